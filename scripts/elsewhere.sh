# Sourced by the scripts that play a game outside of the project: `elsewhere` is a folder that goes at
# the end of the script, with a game that fails unless a box falls onto a floor and lies flush on it.

elsewhere=$(mktemp -d)
trap 'rm -rf "$elsewhere"' EXIT
cat >"$elsewhere/game.lua" <<'LUA'
local physics = require("physics")
local world = physics.newWorld({ gravity = 800 })
world:add("tiles", { x = 0, y = 100, width = 200, height = 16, static = true })
local box = world:add("boxes", { x = 20, y = 0, width = 16, height = 16 })
for _ = 1, 120 do
  world:update(1 / 60)
end
assert(box.y == 84 and box.vy == 0, "the box is not on the floor")
assert(box.touching.bottom, "the box does not touch the floor")
LUA
sed 's/"physics"/"lib.physics"/' "$elsewhere/game.lua" >"$elsewhere/lib_game.lua"

# plays PATH GAME LUA: LUA_PATH has no ";;" at its end, so only what is in PATH can be found.
plays() {
  (cd "$elsewhere" && env -u LUA_PATH_5_2 -u LUA_PATH_5_3 -u LUA_PATH_5_4 LUA_PATH="$1" "$3" "$2.lua")
}

# check_plays WHAT PATH GAME: on every Lua.
check_plays() {
  local lua
  for lua in luajit lua5.1 lua5.2 lua5.3 lua5.4; do
    check "$1 on $lua" plays "$2" "$3" "$lua"
  done
}
