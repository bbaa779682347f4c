#!/usr/bin/env bash
# Finds words for persons where objects are meant: an object is "it" (CONTRIBUTING.md, "Words"). In
# README.md and docs/ it also finds long sentences (scripts/sentences.lua). Without FILE it counts the
# comments of the core that say "what".
#
#   scripts/words.sh             every page, script, example and Lua file that is kept in git
#   scripts/words.sh FILE...     only these files
#   scripts/words.sh --tidy      takes what is clean or gone out of scripts/words_not_yet.txt
#
# Files in scripts/words_not_yet.txt are still to be rewritten. The list only gets shorter: a file in it
# that is clean, or gone, must be taken out.
set -euo pipefail
cd "$(dirname "$0")/.."

WORDS='who|whom|whoever|somebody|nobody|everybody|everyone'
NOT_YET=scripts/words_not_yet.txt
# Lines of comments in physics/ with "what", mostly in place of a noun (scripts/sentences.lua). The
# number only gets less.
MOST_WHATS=98

# Lines that mean a person, or that are these words: FILE:PART OF THE LINE.
EXCEPTIONS='
scripts/words.sh:WORDS=
CODE_OF_CONDUCT.md:
'

list_files() {
  git ls-files -- '*.md' '*.lua' '*.sh' '*.mjs' '*.js' '*.html' '*.go' '*.rockspec' '*.yml' \
    Makefile .ci .luacheckrc .busted
}

# is_exception FILE NUMBER:LINE
is_exception() {
  local file part
  while IFS=: read -r file part; do
    [ -n "$file" ] && [ "$1" = "$file" ] && [[ "$2" == *"$part"* ]] && return 0
  done <<<"$EXCEPTIONS"
  return 1
}

# Prints the lines of a file that have one of the words, as FILE:NUMBER:LINE.
find_words() {
  local line
  { grep -niwE -- "$WORDS" "$1" || true; } | while IFS= read -r line; do
    is_exception "$1" "$line" || printf '%s:%s\n' "$1" "$line"
  done
}

is_page() { [[ "$1" == README.md || "$1" == docs/*.md ]]; }

find_sentences() { [ $# -eq 0 ] || luajit scripts/sentences.lua "$@" || true; }

is_clean() { [ -z "$(find_words "$1")" ] && { ! is_page "$1" || [ -z "$(find_sentences "$1")" ]; }; }

if [ "${1:-}" = --tidy ]; then
  while IFS= read -r file; do
    [ ! -f "$file" ] || is_clean "$file" || echo "$file"
  done <"$NOT_YET" >"$NOT_YET.new"
  mv "$NOT_YET.new" "$NOT_YET"
  exit
fi

failed=0
report() {
  printf '%s\n' "$1"
  failed=1
}

if [ $# -gt 0 ]; then
  files=("$@")
else
  mapfile -t files < <(list_files)
  [ "${#files[@]}" -gt 0 ] || report "git lists no files here"
  whats=$(git ls-files 'physics/*.lua' | grep -v types.lua | xargs grep -hwE -- '--.*\bwhat\b' | wc -l)
  [ "$whats" -le "$MOST_WHATS" ] || report "physics/ says \"what\" $whats times, at most $MOST_WHATS: name the thing"
fi

pages=()
for file in "${files[@]}"; do
  if [ -f "$file" ] && ! grep -qxF -- "$file" "$NOT_YET"; then
    found=$(find_words "$file")
    [ -z "$found" ] || report "$found"
    ! is_page "$file" || pages+=("$file")
  fi
done
found=$(find_sentences "${pages[@]}")
[ -z "$found" ] || report "$found"

while IFS= read -r file; do
  if [ ! -f "$file" ]; then
    report "$NOT_YET: $file does not exist (scripts/words.sh --tidy)"
  elif is_clean "$file"; then
    report "$NOT_YET: $file is clean (scripts/words.sh --tidy)"
  fi
done <"$NOT_YET"

exit "$failed"
