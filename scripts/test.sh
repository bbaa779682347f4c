#!/usr/bin/env bash
# Runs the specs. Counts each spec on each interpreter as one check.
#
#   scripts/test.sh             LuaJIT, without what is tagged #slow, and of Lua 5.4 what may differ
#   scripts/test.sh --all       every interpreter, and the coverage
#   scripts/test.sh --coverage  the part of that which shows the coverage
#
# spec/slow.lua says what is not played everywhere, and why.
#
# Files run side by side on all cores (JOBS=1: one at a time), the slow ones first.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

mode=${1:---quick}
least=99 # % of the lines of the core
logs=build/test
rm -rf "$logs" && mkdir -p "$logs"

# what the interpreter calls itself (scripts/interpreter.lua compares) : command
# Specs are played by scripts/plain_busted.lua: busted takes a third longer, and its modules are not
# yet written for 5.5. Checks see that busted plays specs, too; `make test-single` plays with it all
# files of what may differ.
# `partial`: the interpreters that play only what may differ from one Lua to the next.
partial="Lua 5.4"
interpreters="
LuaJIT:luajit
Lua 5.4:lua5.4
"
case $mode in
  # Of what is played in many variants LuaJIT plays a selection, too (spec/support/effort.lua).
  --quick) export PHYSICS_SPEC=quick ;;
  --all)
    # Built only where there is none.
    if ! lua55=$(bash scripts/puc_lua.sh 5.5); then
      echo "0 passed, 1 failed"
      exit 1
    fi
    partial=$'Lua 5.1\nLua 5.2\nLua 5.3\nLua 5.5'
    interpreters="
LuaJIT:luajit
LuaJIT -joff:scripts/luajit-joff
Lua 5.1:lua5.1
Lua 5.2:lua5.2
Lua 5.3:lua5.3
Lua 5.4:lua5.4
Lua 5.5:$lua55
"
    ;;
  --coverage) interpreters="LuaJIT -joff:scripts/luajit-joff" ;;
  *) echo "test: what is '$mode'?" >&2 && exit 1 ;;
esac

plays_slow() {
  [ "$mode" != --quick ] && grep -qxF "$1" <<<"$slow_interpreters"
}
slow_files=$(luajit -e 'for _, row in ipairs(require("spec.slow").files) do print(row[1]) end') &&
  differing=$(luajit -e 'print(table.concat(require("spec.slow").differs, "\n"))') &&
  slow_interpreters=$(luajit -e 'print(table.concat(require("spec.slow").interpreters, "\n"))') ||
  exit 1
# of_interpreter NAME FILES...: those that it plays
of_interpreter() {
  if grep -qxF "$1" <<<"$partial"; then
    printf '%s\n' "${@:2}" | grep -xF "$differing" | tr '\n' ' '
  else
    echo "${@:2}"
  fi
}

# Each run below says which interpreter it wants; a run on another one has to be noticed.
wrong_lua() { PHYSICS_LUA="LuaJIT -joff" busted --lua=luajit --helper=scripts/interpreter.lua; }
check "specs on the wrong interpreter are refused" refuses wrong_lua
wrong_plain_lua() { PHYSICS_LUA="Lua 5.3" lua5.4 scripts/plain_busted.lua spec/world_tutorial_spec.lua; }
check "specs on the wrong interpreter are refused without busted, too" refuses wrong_plain_lua

busted_on_54() {
  PHYSICS_LUA="Lua 5.4" busted --lua=lua5.4 --helper=scripts/interpreter.lua spec/world_tutorial_spec.lua
}
busted_on_luajit() {
  PHYSICS_LUA=LuaJIT busted --lua=luajit --helper=scripts/interpreter.lua \
    --exclude-tags=slow spec/scenarios/17_pushable_spec.lua
}
check "busted itself plays specs" busted_on_luajit
if [ "$mode" = --all ]; then
  check "busted itself plays specs on Lua 5.4" busted_on_54
fi

# The library must stay loadable by plain Lua 5.1, love.js has nothing newer.
has_old_syntax() { find physics.lua physics spec -name '*.lua' -print0 | xargs -0 luac5.1 -p; }
check "physics/ and spec/ have the syntax of Lua 5.1" has_old_syntax

# What is slow is a job by itself; the rest are jobs of some files each.
BUNDLES=6
mapfile -t files < <(find spec -name '*_spec.lua' | LC_ALL=C sort)
bundles=()
for ((n = 0; n < ${#files[@]}; n++)); do
  if ! grep -qxF "${files[n]}" <<<"$slow_files"; then
    bundles[n % BUNDLES]+=" ${files[n]}"
  fi
done

# list_jobs FILES...: a line for each interpreter that plays them: name, command, tags, files
list_jobs() {
  local name command tags files
  while IFS=: read -r name command; do
    files=$(of_interpreter "$name" "$@")
    [ -n "$name" ] && [ -n "$files" ] || continue
    tags=slow
    ! plays_slow "$name" || tags=""
    printf '%s|%s|%s|%s\n' "$name" "$command" "$tags" "$files"
  done <<<"$interpreters"
}
# shellcheck disable=SC2086 # one word per file is meant
# First what runs most lines of the core for the coverage: what comes later needs no marks there.
is_marked() { grep "$@" '^LuaJIT -joff|'; }
{
  list_jobs ${bundles[0]} | is_marked
  for file in $slow_files; do list_jobs "$file"; done
  list_jobs ${bundles[0]} | is_marked -v
  for bundle in "${bundles[@]:1}"; do list_jobs $bundle; done
} | nl -w 3 -n rz -s '|' >"$logs/jobs"

# play_plainly LUA [OPTIONS] FILES...: a process for each, since they share what is global. With
# --coverage each leaves the lines that none before it has left.
play_plainly() {
  local lua=$1 options=() file code=0
  shift
  while [[ "$1" == --* ]]; do
    options+=("$1")
    shift
  done
  for file in "$@"; do
    export COVERAGE=${SPEC_TIMES%.times}-${file//\//-}.marks COVERAGE_KNOWN=$SPEC_TIMES.known
    cat "$logs/"*.marks >"$COVERAGE_KNOWN" 2>/dev/null || true
    { time SPEC_TIMES="" "$lua" scripts/plain_busted.lua "${options[@]}" "$file" 2>&3 || code=1; } \
      3>&2 2>"$SPEC_TIMES.one"
    echo "$(<"$SPEC_TIMES.one") $file" >>"$SPEC_TIMES"
  done
  rm -f "$SPEC_TIMES.one" "$SPEC_TIMES.known"
  return $code
}

# run_job NUMBER|NAME|COMMAND|TAGS|FILES: leaves its output and "CODE SECONDS" of the processor.
run_job() {
  local number name command tags list seconds options=()
  IFS='|' read -r number name command tags list <<<"$1"
  read -ra list <<<"$list"
  local log="$logs/$number $name"
  TIMEFORMAT=%U
  [ -z "$tags" ] || options+=("--exclude-tags=$tags")
  [ "$name" != "LuaJIT -joff" ] || options+=(--coverage)
  export PHYSICS_LUA=$name SPEC_TIMES=$log.times
  seconds=$({ time play_plainly "$command" "${options[@]}" "${list[@]}" </dev/null >"$log.log" 2>&1; } 2>&1)
  echo "$? $seconds" >"$log.status"
}
export -f run_job play_plainly
export logs
started=$SECONDS
play_jobs() {
  tr '\n' '\0' <"$logs/jobs" |
    xargs -0 -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -I{} bash -c 'run_job "$1"' _ {}
}
check "all jobs come to their end" play_jobs

# count_jobs NAME: adds up what the jobs of an interpreter have counted. A job that dies, and an
# interpreter that has played nothing, leave no number that would count: they fail as a whole.
count_jobs() {
  local name=$1 log code seconds counts good bad pending all=0 lost=0 waiting=0 cpu=0
  for log in "$logs/"[0-9]*" $name.log"; do
    # A job that was ended from outside has left no code.
    code=1 seconds=0
    [ ! -s "${log%.log}.status" ] || read -r code seconds <"${log%.log}.status"
    # A line of counts for each file.
    counts=$(sed -nE 's/^([0-9]+) passed, ([0-9]+) failed, ([0-9]+) left out$/\1 \2 \3/p' "$log" |
      awk '{ a += $1; b += $2; c += $3 } END { print a + 0, NR ? b + 0 : 1, c + 0 }')
    read -r good bad pending <<<"$counts"
    if [ "$code" -ne 0 ] && [ "$bad" -eq 0 ]; then
      bad=1
    fi
    if [ "$bad" -gt 0 ]; then
      tail -n 200 "$log" | sed 's/^/        /'
    fi
    all=$((all + good)) lost=$((lost + bad)) waiting=$((waiting + pending))
    cpu=$(awk "BEGIN { print $cpu + $seconds }")
  done
  [ "$all" -gt 0 ] || lost=$((lost + 1))
  passed=$((passed + all))
  failed=$((failed + lost))
  if [ "$lost" -gt 0 ]; then
    echo "FAILED  specs on $name: $all passed, $lost failed ($cpu s of one core)"
  else
    echo "ok      specs on $name: $all passed, $waiting left out ($cpu s of one core)"
  fi
}
while IFS=: read -r name _; do
  [ -z "$name" ] || count_jobs "$name"
done <<<"$interpreters"
echo "$((SECONDS - started)) s in all"

# Files that have become slow: to be made faster, or to be tagged and listed in spec/slow.lua.
if [ "$mode" = --quick ]; then
  cat "$logs/"*" LuaJIT.times" | awk '$1 > 2 { print "slow, but not tagged: " $2 ": " $1 " s" }'
fi

if [ "$mode" != --quick ]; then
  report=build/coverage.txt
  luajit scripts/coverage.lua "$logs/"*.marks >"$report"
  enough() {
    awk -v least=$least '/^[0-9.]+ % of the lines of the core/ { found = $1 }
      END { exit !(found >= least) }' "$report"
  }
  cat "$report"
  check "at least $least % of the lines of the core are run" enough
fi

finish
