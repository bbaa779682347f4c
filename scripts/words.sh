#!/usr/bin/env bash
# Finds words for persons where objects are meant: an object is "it" (CONTRIBUTING.md, "Words"). In
# README.md and docs/ it also finds long sentences (scripts/sentences.lua). Without FILE it counts the
# comments of the core that say "what".
#
#   scripts/words.sh             every page, script, example and Lua file that is kept in git
#   scripts/words.sh FILE...     only these files
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

WORDS='who|whom|whoever|somebody|nobody|everybody|everyone'
# Lines of comments in physics/ with "what", mostly in place of a noun (scripts/sentences.lua). The
# number only gets less.
MOST_WHATS=1

failed=0
files=("$@")
if [ $# -eq 0 ]; then
  mapfile -t files < <(git ls-files -- '*.md' '*.lua' '*.sh' '*.mjs' '*.js' '*.html' '*.go' \
    '*.rockspec' '*.yml' Makefile .ci .luacheckrc .busted)
  whats=$(git ls-files 'physics/*.lua' | grep -v types.lua | xargs grep -hwE -- '--.*\bwhat\b' | wc -l)
  if [ "$whats" -gt "$MOST_WHATS" ]; then
    echo "physics/ says \"what\" $whats times, at most $MOST_WHATS: name the thing"
    failed=1
  fi
fi

# The words themselves, and a page that means persons, may have them.
if grep -HniwE -- "$WORDS" "${files[@]}" | grep -vE "^(scripts/words.sh:[0-9]+:WORDS=|CODE_OF_CONDUCT.md)"; then
  failed=1
fi
mapfile -t pages < <(printf '%s\n' "${files[@]}" | grep -E '^(README|docs/.*)\.md$')
luajit scripts/sentences.lua "${pages[@]}" || failed=1
exit "$failed"
