#!/usr/bin/env bash
# Which lines of the core do the specs run? Prints the lines that they do not, and the total; fails
# below LEAST %. The specs run interpreted, where the slow ones are a selection.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

LEAST=98
report=build/coverage.txt
rm -f "$report"
started=$SECONDS
# These look at what the scripts, files and LÖVE do.
others="bench|draw|examples|love12|manual|mutations|portable|rockspec|tiled"
mapfile -t specs < <(find spec -name '*_spec.lua' | grep -Ev "/($others)[a-z_]*_spec" | LC_ALL=C sort)
COVERAGE=$report busted --lua=scripts/luajit-joff --helper=scripts/coverage.lua \
  --output=plainTerminal "${specs[@]}" </dev/null >build/coverage.log 2>&1
count_specs "luajit -joff, with marks" $? build/coverage.log $((SECONDS - started))

enough() {
  awk -v least=$LEAST '/^[0-9.]+ % of the lines of the core/ { found = $1 }
    END { exit !(found >= least) }' "$report"
}
cat "$report"
check "at least $LEAST % of the lines of the core are run" enough

finish
