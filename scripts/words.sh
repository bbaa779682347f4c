#!/usr/bin/env bash
# Finds words for persons where objects are meant: an object is "it" (CONTRIBUTING.md, "Words"). In
# README.md and docs/ it also finds long sentences (scripts/sentences.lua). Without FILE it finds
# comments of the core that say "what", and a `module.name` in them and in the pages for developers
# that the core does not have.
#
#   scripts/words.sh             every page, script, example and Lua file that is kept in git
#   scripts/words.sh FILE...     only these files
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

WORDS='who|whom|whoever|somebody|nobody|everybody|everyone'

failed=0
files=("$@")
if [ $# -eq 0 ]; then
  mapfile -t files < <(git ls-files -- '*.md' '*.lua' '*.sh' '*.mjs' '*.js' '*.html' '*.go' \
    '*.rockspec' '*.yml' Makefile .ci .luacheckrc .busted)
  mapfile -t core < <(git ls-files 'physics/*.lua' | grep -v types.lua)
  # (Mostly in place of a noun, see scripts/sentences.lua.)
  grep -HnE -- '--.*[^`]\bwhat\b' "${core[@]}" && failed=1
  modules=$(basename -as .lua "${core[@]}" | grep -vxE 'world|level' | paste -sd '|')
  there=$(sed 's/--.*//' "${core[@]}" | grep -oE "\\b($modules)\.\w+" && basename -a "${core[@]}")
  grep -hoE -- '--.*' "${core[@]}" | cat - ARCHITECTURE.md CONTRIBUTING.md spec/TESTING.md |
    grep -oE "\`($modules)\.\w+" | tr -d '\`' | sort -u | grep -vxF "$there" |
    sed 's/^/the core has no /' | grep . && failed=1
fi

# The words themselves, and a page that means persons, may have them.
grep -HniwE -- "$WORDS" "${files[@]}" |
  grep -vE "^(scripts/words.sh:[0-9]+:WORDS=|CODE_OF_CONDUCT.md)" && failed=1
mapfile -t pages < <(printf '%s\n' "${files[@]}" | grep -E '^(README|docs/.*)\.md$')
luajit scripts/sentences.lua "${pages[@]}" || failed=1
exit "$failed"
