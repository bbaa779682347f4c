#!/usr/bin/env bash
# Installs the rock into lua_modules/, then uses it from a folder that knows nothing else of the
# project. The same for the library copied into a game's own folder.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

tree=$PWD/lua_modules
version=$(luarocks config lua_version)
elsewhere=$(mktemp -d)
trap 'rm -rf "$elsewhere"' EXIT

rm -rf "$tree"
# The rockspec of a release (scripts/publish.lua), here with an address that stands in for the real one.
rockspec=build/physics-1.2.3-1.rockspec
make_rockspec() {
  sed 's#url = "[^"]*"#url = "git+https://example.com/owner/name"#' rockspec/*.rockspec >build/addressed.rockspec
  luajit scripts/publish.lua rockspec 1.2.3 build/addressed.rockspec >$rockspec
}
check "a release gets a rockspec" make_rockspec
for one in rockspec/*.rockspec $rockspec; do
  check "$one is valid" luarocks lint "$one"
done
check "luarocks make installs the release" luarocks --tree "$tree" make "$rockspec"
check "luarocks make installs the state of the folder" luarocks --tree "$tree" make

# `luarocks test` wants busted as a rock; here it is the one that is installed, made into a rock.
shelf=$PWD/build/rocks
rm -rf "$shelf" && mkdir -p "$shelf/busted"
cp "$(command -v busted)" "$shelf/busted/busted"
cat >"$shelf/busted/busted-2.1.1-1.rockspec" <<'ROCKSPEC'
rockspec_format = "3.0"
package = "busted"
version = "2.1.1-1"
source = { url = "git+https://github.com/lunarmodules/busted" }
build = { type = "builtin", modules = {}, install = { bin = { "busted" } } }
ROCKSPEC
echo "rocks_trees = { { name = 'shelf', root = '$shelf' } }" >"$shelf/config.lua"
make_busted() { (cd "$shelf/busted" && luarocks --tree "$shelf" make busted-2.1.1-1.rockspec); }
check "busted is there as a rock" make_busted
luarocks_test() { LUAROCKS_CONFIG="$shelf/config.lua" luarocks test "$@"; }
check "luarocks test plays the specs" luarocks_test -- spec/world_spec.lua
echo 'it("fails", function() assert.equal(1, 2) end)' >build/fails_spec.lua
check "and fails when one fails" refuses luarocks_test -- build/fails_spec.lua

# Prints what the script must find: the box has fallen onto the floor and lies flush on it.
cat >"$elsewhere/game.lua" <<'LUA'
local name = ...
local physics = require(name)
local world = physics.newWorld({ gravity = 800 })
world:add("tiles", { x = 0, y = 100, width = 200, height = 16, static = true })
local box = world:add("boxes", { x = 20, y = 0, width = 16, height = 16 })
for _ = 1, 120 do
  world:update(1 / 60)
end
assert(box.y == 84 and box.vy == 0, "the box is at y = " .. box.y .. ", not on the floor")
assert(box.touching.bottom, "the box does not touch the floor")
LUA

# LUA_PATH has no ";;" at its end: nothing of this machine but the given folder can be found.
plays() {
  local lua=$1 path=$2 name=$3
  (cd "$elsewhere" && env -u LUA_PATH_5_2 -u LUA_PATH_5_3 -u LUA_PATH_5_4 LUA_PATH="$path" \
    "$lua" game.lua "$name")
}
installed="$tree/share/lua/$version/?.lua"
copied="$elsewhere/?.lua"
for lua in luajit lua5.1 lua5.2 lua5.3 lua5.4; do
  check "the installed rock runs from another folder on $lua" plays "$lua" "$installed" physics
done

mkdir -p "$elsewhere/lib" && cp -r physics.lua physics "$elsewhere/lib/"
for lua in luajit lua5.1 lua5.2 lua5.3 lua5.4; do
  check "require \"lib.physics\" works from a copied folder on $lua" \
    plays "$lua" "$copied" lib.physics
done
check "nothing is found without them" refuses plays luajit "$elsewhere/none/?.lua" physics

finish
