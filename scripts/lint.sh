#!/usr/bin/env bash
# luacheck (.luacheckrc), the formatter (stylua.toml), the words (scripts/words.sh), and actionlint for
# the workflow.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

mapfile -t sources < <(lua_sources)

check "luacheck" luacheck --no-color --quiet "${sources[@]}" docs/steps rockspec/*.rockspec

# The rule that matters most is one of configuration: see that it bites.
names_love() { echo "love.graphics.circle('fill', 0, 0, 1)" | luacheck --filename "$1" -; }
check "luacheck refuses love in the core" refuses names_love physics/world/world.lua
check "luacheck allows love in physics/world/draw.lua" names_love physics/world/draw.lua

# The workflow of GitHub, where there is Go to build its checker.
actionlint() { go run github.com/rhysd/actionlint/cmd/actionlint@v1.7.12 -no-color "$@"; }
if command -v go >/dev/null 2>&1; then
  check "actionlint finds nothing in the workflow" actionlint
  printf 'on: push\njobs:\n  a:\n    runs-on: ubuntu\n    steps: [{ run: "${{ matrix.b }}" }]\n' \
    >build/wrong.yml
  check "actionlint notices a variable that is not there" refuses actionlint build/wrong.yml
else
  echo "There is no Go here: the workflow was not checked."
fi

check "StyLua starts" bash scripts/stylua.sh --version
check "StyLua finds nothing to change" bash scripts/stylua.sh --check "${sources[@]}"

check "no folder has more code than its budget" luajit scripts/budget.lua
check "no field is named by more files than before" luajit scripts/field_files.lua

check "each field, setting, method and page has specs" luajit scripts/spec_index.lua

check "an object is it, not a person" bash scripts/words.sh
printf 'The box %s rests.\n' "wh""o" >build/words.md
echo 'The box pushes what is near.' >build/what.md
check "a page in which \"what\" is a noun is found" refuses luajit scripts/sentences.lua build/what.md
check "a word for a person is found" refuses bash scripts/words.sh build/words.md

finish
