#!/usr/bin/env bash
# Installs the rock into lua_modules/, then uses it from a folder that knows nothing else of the
# project. The same for the library copied into a game's own folder.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/elsewhere.sh

tree=$PWD/lua_modules
version=$(luarocks config lua_version)

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

check_plays "the installed rock runs from another folder" "$tree/share/lua/$version/?.lua" game
mkdir -p "$elsewhere/lib" && cp -r physics.lua physics "$elsewhere/lib/"
check_plays 'require "lib.physics" works from a copied folder' "$elsewhere/?.lua" lib_game
check "nothing is found without them" refuses plays "$elsewhere/none/?.lua" game luajit

finish
