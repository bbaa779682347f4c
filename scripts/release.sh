#!/usr/bin/env bash
# Packs a release into build/release/: physics-VERSION.zip with the library as one file, the addon for
# editors, the changelog and the licence; physics.lua for a direct download; examples-VERSION.love; the
# rockspec, if the project has an address (scripts/publish.lua).
# Then unpacks the zip elsewhere, plays a game with the file, and
# checks a game's types with the addon. The same sources give the same zip, to the bit.
# What else a release needs: CONTRIBUTING.md.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/elsewhere.sh

version=$(luajit -e 'io.write(require("physics")._VERSION)') || exit 1
name=physics-$version
address=$(luajit scripts/publish.lua address) || exit 1
place=build/release
zip=$PWD/$place/$name.zip

# write_addon FOLDER: the addon for the Lua language server, for a game that has the library as one
# file, which is too long for that server, or elsewhere than in its workspace.
write_addon() {
  mkdir -p "$1/library/lib" && cp -r physics.lua physics "$1/library/" || return
  # For `require "lib.physics"`.
  printf '%s\n' '---@meta lib.physics' 'return require("physics")' >"$1/library/lib/physics.lua"
  cat >"$1/config.json" <<'JSON'
{
  "name": "physics.lua",
  "words": ["require[%s%(\"']+[%w_.]*physics[\"']", "physics%.newWorld"],
  "settings": {}
}
JSON
}

pack() {
  rm -rf "$place" && mkdir -p "$place/$name" || return
  luajit scripts/single.lua "$place/$name/physics.lua" || return
  write_addon "$place/$name/addon" || return
  cp LICENSE CHANGELOG.md "$place/$name/" || return
  # Dates are those of the last commit; a copy without git has one that a zip can hold.
  local date
  date=$(git log -1 --format=%ct 2>/dev/null) || date=315619200
  find "$place/$name" -exec touch -d "@$date" {} +
  (cd "$place" && find "$name" -type f | LC_ALL=C sort | TZ=UTC zip -qX "$zip" -@) || return
  cp "$place/$name/physics.lua" "$place/physics.lua"
  [ -z "$address" ] || luajit scripts/publish.lua rockspec "$version" >"$place/$name-1.rockspec" || return
  (zip -qrX "$place/examples-$version.love" physics.lua physics &&
    cd examples && zip -qrX "../$place/examples-$version.love" . -x 'compare/*')
}
check "packs $name.zip" pack
first=$(sha256sum <"$zip")
check "packs it again" pack
same() { [ "$first" = "$(sha256sum <"$zip")" ]; }
check "and it is the same, to the bit" same

check "it can be unpacked" unzip -q "$zip" -d "$elsewhere"
holds() {
  local found expected
  found=$(cd "$elsewhere/$name" && find . -type f | LC_ALL=C sort)
  expected=$(printf './%s\n' CHANGELOG.md LICENSE addon/config.json addon/library/lib/physics.lua \
    physics.lua $(find physics.lua physics -type f -printf 'addon/library/%p\n') | LC_ALL=C sort)
  echo "$found"
  [ "$found" = "$expected" ]
}
check "it holds what it should" holds

check_plays "a game plays with the file" "./$name/?.lua" game

# The addon is a folder of types beside the game, which has no code of the library.
types=$place/types
mkdir -p "$types"
echo "{ \"workspace\": { \"library\": [\"$elsewhere/$name/addon/library\"] } }" >"$types/.emmyrc.json"
# emmylua GAME LINE: what is said of the game with a line more.
emmylua() {
  cp "$elsewhere/$1.lua" "$types/game.lua"
  echo "$2" >>"$types/game.lua"
  bash scripts/emmylua.sh --warnings-as-errors "$types"
}
finds() {
  local found code
  found=$(emmylua "$2" "$3" 2>&1)
  code=$?
  echo "$found"
  [ $code -eq 1 ] && [[ "$found" == *"[$1]"* ]]
}
knows="for _, hit in ipairs((select(3, world:move(box, 3, 4)))) do print(hit.other, hit.nx + 1) end"
check "the addon knows what the game calls, and what a query returns" emmylua game "$knows"
check "it finds a method that does not exist" finds undefined-field game 'world:updaet(1)'
check "and a function that does not exist" finds undefined-field game 'physics.updaet(1)'
check "and an argument that is missing" finds missing-parameter game 'world:update()'
check "and a setting of the wrong type" finds param-type-mismatch game 'physics.load({ gravity = "9" })'
check "it also finds it for a game that requires lib.physics" \
  finds undefined-field lib_game 'world:updaet(1)'
single_finds() {
  rm "$types/.emmyrc.json" && mkdir -p "$types/lib" && cp "$elsewhere/$name/physics.lua" "$types/lib/"
  emmylua lib_game "" && finds undefined-field lib_game 'world:updaet(1)'
}
check "the single file alone does the same, and has no warnings of its own" single_finds

echo "The release is ${zip#"$PWD"/}"
finish
