#!/usr/bin/env bash
# Runs the library on gopher-lua, a Lua in Go (spec/gopher/README.md): the scene of the determinism
# spec, and the specs of what may differ (spec/slow.lua). With --all all of them.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

if ! command -v go >/dev/null 2>&1; then
  echo "There is no Go here: nothing was run on gopher-lua. On Debian: apt-get install golang-go"
  exit 0
fi

# Without --all: of what may differ (spec/slow.lua) all but what takes eight seconds there, or minutes.
slow="determinism debugging_bad_input recipes fields_at_run_time"
gopher=$PWD/build/gopher

build() { (cd spec/gopher && go build -mod=readonly -buildvcs=false -o "$gopher" .); }
check "gopher-lua builds" build
if [ "$failed" -gt 0 ]; then
  finish
  exit 1
fi

same_number() {
  local here there
  here=$(luajit spec/support/everything.lua) || return 1
  there=$("$gopher" spec/support/everything.lua) || return 1
  echo "$there on gopher-lua, $here on LuaJIT"
  [ -n "$here" ] && [ "$here" = "$there" ]
}
check "the determinism scene gives the same number as on LuaJIT" same_number

# That a spec fails has to be seen.
echo 'it("fails", function() assert.equal(1, 2) end)' >build/fails_spec.lua
check "a spec that fails is noticed" refuses "$gopher" scripts/plain_busted.lua build/fails_spec.lua

logs=build/gopher-logs
rm -rf "$logs" && mkdir -p "$logs"
differing() { luajit -e 'print(table.concat(require("spec.slow").differs, "\n"))'; }
if [ "${1:-}" = --all ]; then
  list_specs "" --all
else
  mapfile -t files < <(differing | grep -vE "/(${slow// /|})_spec")
fi
tags=--exclude-tags=slow
[ "${1:-}" != --all ] || tags=""
export gopher logs tags
run_one() {
  "$gopher" scripts/plain_busted.lua --left-out=spec.gopher.left_out ${tags:+"$tags"} "$1" \
    >"$logs/$(basename "$1").log" 2>&1 </dev/null
}
export -f run_one
printf '%s\0' "${files[@]}" |
  xargs -0 -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -I{} bash -c 'run_one "$1" || true' _ {}

left_out=0
for file in "${files[@]}"; do
  log=$logs/$(basename "$file").log
  counts=$(tail -n 1 "$log" | grep -E '^[0-9]+ passed, [0-9]+ failed, [0-9]+ left out$')
  # What died before it could count has failed.
  read -r good _ bad _ out _ <<<"${counts:-0 passed, 1 failed, 0 left out}"
  passed=$((passed + good))
  failed=$((failed + bad))
  left_out=$((left_out + out))
  if [ "$bad" -gt 0 ]; then
    echo "FAILED  $file: $bad failed"
    head -n 60 "$log" | sed 's/^/        /'
  else
    echo "ok      $file: $good passed, $out left out"
  fi
done
# With --all every file is read, so that a name which fits nothing is old.
if [ "${1:-}" = --all ]; then
  names() { luajit -e 'for n in pairs(require("spec.gopher.left_out").specs) do print(n) end'; }
  each_is_there() { names | while read -r name; do grep -rqF "left out  $name:" "$logs" || exit 1; done; }
  check "every spec that is left out is there" each_is_there
fi
echo "$left_out specs and files were left out (spec/gopher/left_out.lua)"

finish
