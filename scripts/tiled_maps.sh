#!/usr/bin/env bash
# Real maps: the editor Tiled exports its own examples and those of spec/maps, as Lua, JSON and CSV.
# LÖVE loads the Lua and the JSON, which must give the same level; the CSV says how many tiles there
# are. What is exported here is not kept.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

root=$PWD
game=$root/build/tiled_maps
rm -rf "$game" && mkdir -p "$game/maps" "$game/csv" "$game/source"
cp -r scripts/tiled_maps/*.lua bench/json.lua physics.lua physics "$game/"
cp spec/maps/*.tmx spec/maps/*.tsx spec/maps/*.png "$game/source/"

# The examples of the Debian package; containers are often made without documentation.
examples=/usr/share/doc/tiled/examples
if [ -d "$examples" ]; then
  cp -r "$examples" "$game/source/examples"
  find "$game/source/examples" -name '*.gz' -exec gunzip {} +
else
  echo "the examples of Tiled are not installed: only the maps of spec/maps"
fi

mkdir -p -m 700 "$game/run"
run_tiled() {
  QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR="$game/run" timeout -k 2 60 tiled "$@"
}

# export_map FILE NAME: all ways, from the folder of the map, so that its tilesets are found.
export_map() {
  (
    cd "$(dirname "$1")" || exit 1
    run_tiled --export-map lua --embed-tilesets "$(basename "$1")" "$game/maps/$2.lua"
    run_tiled --export-map json --embed-tilesets --detach-templates "$(basename "$1")" \
      "$game/maps/$2.json"
    run_tiled --export-map csv "$(basename "$1")" "$game/csv/$2.csv"
  )
  [ -s "$game/maps/$2.lua" ]
}

# count_tiles NAME: the cells of all tile layers in which there is a tile. Tiled writes one file for
# each layer, -1 for no tile.
count_tiles() {
  cat "$game/csv/$1".csv "$game/csv/$1"_*.csv 2>/dev/null |
    tr ',' '\n' | grep -cE '^[0-9]+$'
}

load_map() { (cd "$game" && timeout -k 2 120 love . "$1" "$2"); }

count=0
while IFS= read -r file; do
  name=$(realpath --relative-to="$game/source" "$file" | sed 's/\.tmx$//; s/[^A-Za-z0-9]/-/g')
  check "Tiled exports $name" export_map "$file" "$name"
  tiles=$(count_tiles "$name")
  check "$name loads with at least $tiles tiles, from JSON as from Lua" load_map "$name" "$tiles"
  count=$((count + 1))
done < <(find "$game/source" -name '*.tmx' | LC_ALL=C sort)

# What a wrong count would give, so that the check can fail.
check "a map with too few tiles is found out" refuses load_map packed-zlib 94
sed 's/"height":16/"height":17/' "$game/maps/course.json" >"$game/maps/other.json"
cp "$game/maps/course.lua" "$game/maps/other.lua"
check "a map that differs in JSON is found out" refuses load_map other 1
check "there are maps" test "$count" -ge 4

# The fixture spec/maps/meadow.lua is what Tiled makes of it, but for the two lines at its head.
is_fixture() { diff <(tail -n +3 "spec/maps/$1.lua") <(sed 's|\.\./source/||' "$game/maps/$1.lua"); }
if run_tiled --version 2>/dev/null | grep -q "1\.8\.2"; then
  check "spec/maps/meadow.lua is what Tiled exports" is_fixture meadow
fi

finish
