#!/usr/bin/env bash
# Runs the specs. Counts each spec on each interpreter as one check.
#
#   scripts/test.sh             LuaJIT, without what is tagged #slow, and of Lua 5.4 what may differ
#   scripts/test.sh --all       every interpreter, and the coverage
#   scripts/test.sh --coverage  the part of that which shows the coverage
#
# spec/slow.lua says what is not played everywhere, and why.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/specs.sh

mode=${1:---quick}
least=99 # % of the lines of the core

# Each run says which interpreter it wants; a run on another one has to be noticed.
wrong_lua() { PHYSICS_LUA="LuaJIT -joff" busted --lua=luajit --helper=scripts/interpreter.lua; }
check "specs on the wrong interpreter are refused" refuses wrong_lua
wrong_plain_lua() { PHYSICS_LUA="Lua 5.3" lua5.4 scripts/plain_busted.lua spec/world_tutorial_spec.lua; }
check "specs on the wrong interpreter are refused without busted, too" refuses wrong_plain_lua

# in_busted LUA NAME FILES...: specs are played by scripts/plain_busted.lua, as busted takes a third
# longer and needs modules in C; this sees that busted plays them, too.
in_busted() {
  PHYSICS_LUA=$2 busted --lua="$1" --helper=scripts/interpreter.lua --exclude-tags=slow "${@:3}"
}
check "busted itself plays specs" in_busted luajit LuaJIT spec/scenarios/17_pushable_spec.lua
check "busted itself plays specs on Lua 5.4" in_busted lua5.4 "Lua 5.4" spec/world_tutorial_spec.lua

# The library must stay loadable by plain Lua 5.1, love.js has nothing newer.
has_old_syntax() { find physics.lua physics spec -name '*.lua' -print0 | xargs -0 luac5.1 -p; }
check "physics/ and spec/ have the syntax of Lua 5.1" has_old_syntax

# Slow files come first.
slow_files=$(luajit -e 'for _, row in ipairs(require("spec.slow").files) do print(row[1]) end')
all_files=$(echo "$slow_files" && spec_files | grep -vxF "$slow_files")
differing=$(differing_files)
# jobs NAME LUA FILES [OPTION]
jobs() { sed "s#^#$1|$2 scripts/plain_busted.lua ${4:-}|#" <<<"$3"; }
covering() { jobs "LuaJIT -joff" "luajit -joff" "$all_files" "--exclude-tags=slow --coverage"; }

case $mode in
  --quick)
    # Of what is played in many variants LuaJIT plays a selection, too (spec/support/effort.lua).
    export PHYSICS_SPEC=quick
    play_specs < <(
      jobs LuaJIT luajit "$all_files" --exclude-tags=slow
      jobs "Lua 5.4" lua5.4 "$differing" --exclude-tags=slow
    )
    # Files that have become slow: to be made faster, or to be tagged and listed in spec/slow.lua.
    grep -H . "$logs/LuaJIT "*.time | awk -F : '$2 > 2 { print "slow, but not tagged: " $0 }'
    ;;
  --coverage) play_specs < <(covering) ;;
  --all)
    lua55=$(bash scripts/puc_lua.sh 5.5) || check "there is Lua 5.5" false
    # shellcheck disable=SC2086 # one word per file is meant
    check "busted itself plays what may differ" in_busted luajit LuaJIT $differing
    play_specs < <(
      jobs LuaJIT luajit "$slow_files"
      covering
      jobs LuaJIT luajit "$(grep -vxF "$slow_files" <<<"$all_files")"
      jobs "Lua 5.4" lua5.4 "$all_files" --exclude-tags=slow
      for version in 5.1 5.2 5.3; do
        jobs "Lua $version" "lua$version" "$differing" --exclude-tags=slow
      done
      jobs "Lua 5.5" "$lua55" "$differing" --exclude-tags=slow
    )
    ;;
  *) echo "test: what is '$mode'?" >&2 && exit 1 ;;
esac

if [ "$mode" != --quick ]; then
  luajit scripts/coverage.lua "$logs/"*.marks | tee build/coverage.txt
  enough() {
    awk -v least=$least '/^[0-9.]+ % of the lines of the core/ { found = $1 }
      END { exit !(found >= least) }' build/coverage.txt
  }
  check "at least $least % of the lines of the core are run" enough
fi

finish
