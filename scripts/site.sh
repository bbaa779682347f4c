#!/usr/bin/env bash
# Builds the site into build/site, a folder that any web server can serve: the pages (mkdocs.yml),
# the examples as they run in the browser (scripts/web.sh), and the playground (web/playground). With
# --test it opens all of it in Chromium, too (web/site/test.mjs).
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/node_modules.sh
get_node_modules

environment=build/site-environment
if ! diff -q web/requirements.txt $environment/installed >/dev/null 2>&1; then
  rm -rf $environment
  if ! { python3 -m venv $environment &&
    $environment/bin/pip install --quiet --disable-pip-version-check -r web/requirements.txt </dev/null; }; then
    echo "pip did not get what web/requirements.txt names: the first time needs the network." >&2
    echo "0 passed, 1 failed"
    exit 1
  fi
  cp web/requirements.txt $environment/installed
fi

source=build/site-source

# bundle TARGET FORMAT SOURCE: one file of a program and all that it imports. What wasmoon asks of
# Node is not asked in a browser.
bundle() {
  web/node_modules/.bin/esbuild "$3" --bundle --minify --loader:.lua=text --format="$2" \
    --external:module --external:url --external:path --external:fs --external:child_process \
    --external:crypto --target=es2022 --log-level=warning --outfile="$source/docs/$1" || exit 1
}

bash scripts/web.sh >/dev/null || exit 1
luajit scripts/manual.lua --names >build/names.json || exit 1
rm -rf $source build/site
python3 web/site/stage.py $source || exit 1
cp -r web/site/overrides $source/
cp -r build/web $source/docs/play
mkdir -p $source/docs/assets $source/docs/playground
cp web/site/icon.svg web/site/site.css $source/docs/assets/
bundle assets/site.js esm web/site/site.js
bundle playground/playground.js esm web/playground/playground.js
bundle playground/worker.js iife web/playground/worker.js
cp web/playground/playground.css web/node_modules/wasmoon/dist/glue.wasm $source/docs/playground/
luajit scripts/single.lua $source/docs/playground/physics.lua || exit 1
# The variable keeps the theme from telling of another generator. With --quiet warnings would not end
# the build.
if ! NO_MKDOCS_2_WARNING=1 $environment/bin/mkdocs build --config-file $source/mkdocs.yml \
  --site-dir "$PWD/build/site" >build/site.log 2>&1; then
  grep -v ^INFO build/site.log >&2
  exit 1
fi

python3 web/site/add_words.py $source/words.json build/site/search/search_index.json || exit 1

if [ "${1:-}" != --test ]; then
  echo "The site is build/site; serve that folder, a file:// address will not do."
  exit 0
fi
CHROMIUM=$(bash scripts/setup.sh --browser) exec node web/site/test.mjs "${@:2}"
