# The commands of this project. Each one sets up what it needs first (scripts/setup.sh).

SHELL := bash
.PHONY: help setup test test-all test-plain lint types format docs rock release single test-single examples pictures web test-web test-gopher test-arm64 test-wine test-love demo ci clean publish-check

help: ## shows this list
	@awk -F ':.*## ' '/^[a-z0-9-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' Makefile

setup: ## installs what the other targets need (Debian, Ubuntu)
	@bash scripts/setup.sh

test: setup ## runs the specs in 45 s: on LuaJIT, without the slow ones, and on Lua 5.4 what may differ (spec/slow.lua)
	@bash scripts/test.sh

test-all: setup ## runs the specs on LuaJIT in two ways and Lua 5.1 to 5.5 (spec/slow.lua); shows the coverage
	@bash scripts/test.sh --all

test-plain: ## runs the specs without busted, on any system: LUA="5.1 5.4", or an interpreter
	@bash scripts/plain.sh $(LUA)

lint: setup ## luacheck and StyLua
	@bash scripts/lint.sh

types: setup ## emmylua_check over the library and the examples
	@bash scripts/types.sh

docs: setup ## writes docs/api.md and physics/types.lua from the docstrings and the table of fields
	@luajit scripts/types.lua && luajit scripts/manual.lua

format: setup ## lets StyLua rewrite the sources
	@. scripts/checks.sh && bash scripts/stylua.sh $$(lua_sources)

rock: setup ## installs the rock into lua_modules/ and runs it from another folder; luarocks test
	@bash scripts/rock.sh

release: setup ## packs build/release/physics-VERSION.zip: one file, types, licence (CONTRIBUTING.md)
	@bash scripts/release.sh

publish-check: setup ## says what is left to do before publishing
	@luajit scripts/publish.lua

single: setup ## writes the whole library as one file, build/physics.lua
	@bash scripts/single.sh

test-single: setup ## runs the specs against that file
	@bash scripts/single.sh --test

examples: setup ## plays every example without a display, leaves pictures in build/pictures/
	@bash scripts/examples.sh

pictures: ## makes docs/pictures/ anew, from the examples
	@bash scripts/setup.sh pictures && bash scripts/pictures.sh

web: setup ## packs the examples for the browser, into build/web
	@bash scripts/web.sh

test-web: ## plays them in a browser, leaves pictures in build/web-pictures
	@bash scripts/setup.sh web && bash scripts/web.sh --test

.PHONY: site test-site
site: ## builds the site with the playground, into build/site
	@bash scripts/setup.sh site && bash scripts/site.sh

test-site: ## opens every page, example and snippet of it, pictures in build/site-pictures; TEST="--all": every program
	@bash scripts/setup.sh site web && bash scripts/site.sh --test $(TEST)

test-gopher: ## runs the specs on gopher-lua, a Lua in Go (spec/gopher/README.md)
	@bash scripts/setup.sh gopher || true; bash scripts/gopher.sh

test-arm64: ## runs most specs on LuaJIT for arm64, emulated; TEST="--all" for all
	@bash scripts/setup.sh arm64 && bash scripts/arm64.sh $(TEST)

test-tiled: ## exports maps by the editor Tiled itself, and loads them in LÖVE
	@bash scripts/setup.sh tiled && bash scripts/tiled_maps.sh

test-wine: ## runs most specs on Lua built for Windows, in Wine; LUA="5.1 5.4", else all
	@bash scripts/setup.sh wine && bash scripts/wine.sh $(LUA)

test-love: setup ## plays the determinism scene in LÖVE 11.5; TEST="--all" for the examples, too
	@bash scripts/love.sh $(TEST)

.PHONY: test-online
test-online: setup ## plays the example Online in pairs of processes over 127.0.0.1: SECONDS=6 each
	@bash scripts/online.sh $(or $(SECONDS),6)

demo: setup ## opens the examples in LÖVE
	@bash scripts/demo.sh

.PHONY: fuzz
fuzz: setup ## plays random games and checks them: SECONDS=60, SEED=1
	@luajit scripts/fuzz.lua --seconds $(or $(SECONDS),60) --seed $(or $(SEED),1) --keep-going

.PHONY: same
same: ## plays small scenes and random games beside those of a commit, to the last bit: BASE=COMMIT
	@rm -rf build/same && mkdir -p build/same
	@git archive $(or $(BASE),HEAD) physics.lua physics | tar -x -C build/same
	@diff <(luajit scripts/same.lua build/same) <(luajit scripts/same.lua .) >build/same.txt \
	  && echo "All is the same." \
	  || { sed -n 's/^[<>] \(.*\), frame.*/differs: \1/p' build/same.txt | sort -u; exit 1; }

.PHONY: games
games: setup ## plays random games of eight kinds and looks for what a player would notice: GAMES=100, SEED=1
	@luajit scripts/fuzz.lua --game all --games $(or $(GAMES),100) --seed $(or $(SEED),1)

.PHONY: bench bench-quick bench-docs bench-size bench-ordinary bench-contacts
bench: setup ## measures the engines side by side; BENCH="--help" shows what to choose
	@bash scripts/bench.sh $(BENCH)

bench-quick: setup ## looks whether the benchmark runs, without looking at times
	@bash scripts/bench_quick.sh

bench-worst: setup ## plays the worst cases and shows which bounds hold: WORST="--only spot --both"
	@luajit bench/worst.lua $(WORST)

bench-contacts: setup ## how exact contacts are, over random scenes: CONTACTS="--only rooms,crates --verbose"
	@luajit bench/contacts.lua $(CONTACTS)

bench-ordinary: setup ## times 43 ordinary calls beside those of a commit: BASE=COMMIT
	@luajit bench/ordinary.lua $(or $(BASE),HEAD)

bench-size: setup ## measures size, time of require and memory; BENCH="--path DIR" to find bump.lua
	@luajit bench/size.lua $(BENCH)

bench-docs: setup ## measures, and brings the figures into bench/README.md and docs/performance.md
	@bash scripts/bench_docs.sh $(BENCH)

.PHONY: soak
soak: setup ## plays a busy scene for ten million steps, in parts: STEPS=10000000
	@luajit scripts/soak.lua --steps $(or $(STEPS),10000000)

.PHONY: golden
golden: setup ## writes spec/golden.lua anew, if all kinds of Lua compute the same numbers
	@bash scripts/golden.sh

.PHONY: coverage mutants
coverage: setup ## shows the lines of the core that no spec runs; fails below 99 %
	@bash scripts/test.sh --coverage

mutants: setup ## changes one thing at a time and sees whether a spec fails: SAMPLE=200, SEED=1, FILE=physics/space/shapes.lua, RESUME=1
	@nice luajit scripts/mutants.lua --sample $(or $(SAMPLE),200) --seed $(or $(SEED),1) \
	  $(if $(FILE),--file $(FILE)) $(if $(RESUME),--resume)

ci: ## everything, as the continuous integration does it
	@bash .ci/run

clean: ## removes what the other targets built
	rm -rf build lua_modules
