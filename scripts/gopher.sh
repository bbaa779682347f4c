#!/usr/bin/env bash
# Runs the library on gopher-lua, a Lua in Go (spec/gopher/README.md): the scene of the determinism
# spec, and the specs of what may differ (spec/slow.lua). With --all all of them.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/specs.sh

if ! command -v go >/dev/null 2>&1; then
  echo "There is no Go here: nothing was run on gopher-lua. On Debian: apt-get install golang-go"
  exit 0
fi

gopher=$PWD/build/gopher
build() { (cd spec/gopher && go build -mod=readonly -buildvcs=false -o "$gopher" .); }
check "gopher-lua builds" build
finish_if_failed
check "the determinism scene gives the same number as on LuaJIT" same_number "$gopher"

# That a spec fails has to be seen.
echo 'it("fails", function() assert.equal(1, 2) end)' >build/fails_spec.lua
check "a spec that fails is noticed" refuses "$gopher" scripts/plain_busted.lua build/fails_spec.lua

command="$gopher scripts/plain_busted.lua --left-out=spec.gopher.left_out"
if [ "${1:-}" = --all ]; then
  play_specs < <(spec_files | sed "s#^#Lua 5.1|$command|#")
  # Every file is read, so a name that fits nothing is old.
  names() { luajit -e 'for n in pairs(require("spec.gopher.left_out").specs) do print(n) end'; }
  each_is_there() { names | while read -r name; do grep -rqF "left out  $name:" "$logs" || exit 1; done; }
  check "every spec that is left out is there" each_is_there
else
  # All but what takes eight seconds there, or minutes.
  slow='/(determinism|debugging_bad_input|recipes|fields_at_run_time)_spec'
  play_specs < <(differing_files | grep -vE "$slow" | sed "s#^#Lua 5.1|$command --exclude-tags=slow|#")
fi

finish
