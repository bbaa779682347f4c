#!/usr/bin/env bash
# The types of the library and of the examples (emmylua_check, .emmyrc.json), and whether they find
# the mistakes that they are there for. First as an author has them: the folder, copied into `lib` of a
# game, with the settings of a new installation, where the library's own files must be silent. LuaLS
# looks at the same where `lua-language-server` is found.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

check "emmylua_check starts" bash scripts/emmylua.sh --version

game=$PWD/build/types-game
rm -rf "$game" && mkdir -p "$game/lib"
cp -r physics.lua physics "$game/lib"
cat >"$game/main.lua" <<'LUA'
local physics = require("lib.physics")
local world = physics.newWorld({ gravity = 800 })
local player = world:add("players", { x = 0, y = 0, width = 8, height = 8, coins = 0 })
local ball = { x = 0, y = 0, radius = 8 }
world:add("balls", ball)
physics.add("balls", { x = 0, y = 0, radius = 8 })
world:refresh(ball)
world:update(1 / 60)
print(player.coins, player.touching.bottom)
LUA
as_an_author() { bash scripts/emmylua.sh --warnings-as-errors "$game"; }
in_luals() { lua-language-server --check="$game" --checklevel=Information --logpath=build/luals; }
# finds_in CHECKER: adds a mistake to the game, which must be all that is found.
finds_in() {
  local found
  cp "$game/main.lua" build/types-main.lua
  echo 'world:updaet(1)' >>"$game/main.lua"
  found=$("$1" 2>&1)
  mv build/types-main.lua "$game/main.lua"
  echo "$found"
  [[ $found == *updaet* && $found != *lib/physics* ]]
}
check "a copied folder has no warnings of its own" as_an_author
check "and a method that does not exist is found" finds_in as_an_author
if command -v lua-language-server >/dev/null 2>&1; then
  check "the same in LuaLS" in_luals
  check "and it finds it, too" finds_in in_luals
else
  echo "There is no lua-language-server here: the folder was not looked at by LuaLS."
fi

# What follows checks the code itself, in a copy without the line that silences it. The checker does
# not know that `...` of a file is a string, which files `root` leads to, nor that the speed `u` of an
# impact and the number of cells `looked` at, which begin at 0, are no integers.
copy=$PWD/build/types
rm -rf "$copy" && mkdir -p "$copy"
cp -r .emmyrc.json physics.lua physics examples "$copy"
mkdir "$copy/bench" && cp bench/engines.lua "$copy/bench/" # for examples/compare
find "$copy/physics" "$copy/physics.lua" -name '*.lua' -exec sed -i -E \
  -e '1{/^---@diagnostic disable$/d}' \
  -e 's/= \(\.\.\.\):match/= (... --[[@as string]]):match/' \
  -e 's/(lazy|require|require\(root \.\. "\.memory\.lazy"\))\(root \.\. "/require("physics/' \
  -e 's/^( +local (u|n, cell, looked) = 0(, self\.cell, 0)?)$/\1.0/' {} +

emmylua() { bash scripts/emmylua.sh --warnings-as-errors "$copy"; }

check "no warning in the library and the examples" emmylua

# What a game writes, and the name of the warning that it must get, or "nothing". Each is a file of
# the game; all are looked at in one go, by `check_games`.
games=()
says() {
  games+=("$2|$1")
  cat >"$copy/game${#games[@]}.lua" <<LUA
local physics = require("physics")
local world = physics.newWorld({ gravity = 800, push = "first" })
local player = world:add("players", { x = 0, y = 0, width = 8, height = 8, coins = 0 })
$3
return { physics, world, player }
LUA
}
finds() { says "types: $1 is found" "$2" "$3"; }
allows() { says "types: $1 is allowed" nothing "$2"; }

is_said() {
  local code=$1 file=$2 found
  # The report has a part for each file, which begins with its name.
  found=$(awk -v file="$file" '/^--- / { isOurs = $2 == file } isOurs' <<<"$report")
  echo "expected $code, found: ${found:-nothing}"
  if [ "$code" = nothing ]; then
    [ -z "$found" ]
  else
    [[ $found == *"$code"* ]]
  fi
}
check_games() {
  local n report
  report=$(bash scripts/emmylua.sh "$copy")
  for ((n = 1; n <= ${#games[@]}; n++)); do
    check "${games[n - 1]#*|}" is_said "${games[n - 1]%%|*}" "game$n.lua"
  done
}

allows "a field of the game's own" 'player.coins = player.coins + 1'
allows "reading a velocity" 'player.vx = player.vx * 0.5'
allows "asking what is touched" 'if player.touching.bottom then player.vy = -400 end'
allows "a callback" 'function player.onBegin(_, other, _, speed) other.vx = speed end'
allows "a setting of the default world" 'physics.gravity = physics.gravity * 2'
allows "a method of the default world" 'physics.add("boxes", player).vx = 3; physics.update(1 / 60)'
allows "a group by hand" 'world.objects.boxes = { { x = 0, y = 0, width = 8, height = 8 } }'
allows "a local that is filled later" 'local hero ---@type physics.Object
hero = world:add("heroes", { x = 0, y = 0, width = 8, height = 8 }); print(hero.vx + 1)'
allows "a hit" 'local _, _, hits = world:move(player, 3, 4); print(hits[1].other, hits[1].nx + 1)'
allows "eight numbers" 'print(physics.checkCollision(0, 0, 8, 8, 4, 4, 8, 8))'
allows "a class of the game's own" '---@class Player: physics.Object
---@field coins integer
local Player = {}
function Player:jump() if self.touching.bottom then self.vy = -400 end end
---@return Player
local function newPlayer() return setmetatable({ x = 0, y = 0, width = 8, height = 8 }, Player) end
local hero = newPlayer()
world:add("heroes", hero)
hero:jump()
hero.coins = hero.coins + 1'

finds "a string as velocity" assign-type-mismatch 'player.vx = "fast"'
finds "a side that does not exist" assign-type-mismatch 'player.oneWay = "up"'
finds "an object without a height" param-type-mismatch \
  'world:add("boxes", { x = 0, y = 0, width = 8 })'
allows "a circle without a width" 'world:add("balls", { x = 0, y = 0, radius = 4 })'
finds "a mass of the wrong type" assign-type-mismatch \
  'world:add("boxes", { x = 0, y = 0, width = 8, height = 8, mass = "1" })'
finds "a setting of the wrong type" param-type-mismatch 'physics.load({ gravity = "9" })'
finds "a mode that does not exist" param-type-mismatch 'physics.newWorld({ push = "second" })'
finds "a wrong setting at run time" assign-type-mismatch 'world.maxStep = false'
finds "a method that does not exist" undefined-field 'world:updaet(1)'
finds "a function that does not exist" undefined-field 'physics.updaet(1)'
finds "a counter that does not exist" undefined-field 'print(world.stats.boxes)'
finds "a missing argument" missing-parameter 'world:update()'
finds "a wrong argument of the module" param-type-mismatch 'physics.update("1")'
finds "a response that does not exist" param-type-mismatch 'world:move(player, 0, 0, "slip")'
finds "an option of the wrong type" param-type-mismatch 'physics.draw({ fill = 1 })'

check_games
finish
