#!/usr/bin/env bash
# Packs the examples for the browser into build/web, a folder that any web server can serve. With
# --test it plays them in Chromium, too (web/test.mjs).
set -uo pipefail
. "$(dirname "$0")/checks.sh"

. scripts/node_modules.sh
get_node_modules

# pack FOLDER TARGET: LÖVE for the browser and the game in the folder.
pack() {
  web/node_modules/.bin/love.js -c -t physics.lua -m 67108864 "$1" "$2" </dev/null || exit 1
  rm -r "$2/theme"
  cp web/index.html "$2/index.html"
}

stage=build/web-stage
rm -rf build/web build/web-determinism "$stage"
mkdir -p "$stage/determinism/spec"
cp -r examples "$stage/examples"
cp -r physics.lua physics "$stage/examples/"
pack "$stage/examples" build/web
if [ "${1:-}" != --test ]; then
  echo "The page is build/web/index.html; serve that folder, a file:// address will not do."
  exit 0
fi

cp -r web/determinism/main.lua physics.lua physics "$stage/determinism/"
cp -r spec/support "$stage/determinism/spec/"
pack "$stage/determinism" build/web-determinism

fold=$(luajit spec/support/everything.lua) || exit 1
names=$(sed -n 's/^ *{ name = "\([a-z]*\)".*/\1/p' examples/menu.lua)
# shellcheck disable=SC2086 # one word per example is meant
CHROMIUM=$(bash scripts/setup.sh --browser) exec node web/test.mjs "$fold" $names
