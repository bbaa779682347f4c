#!/usr/bin/env bash
# Runs the specs on every Lua. Counts each spec on each of them as one check.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

# what the interpreter calls itself (scripts/interpreter.lua compares) : command
interpreters="
LuaJIT:luajit
LuaJIT -joff:scripts/luajit-joff
LuaJIT compiled:scripts/luajit-compiled
Lua 5.1:lua5.1
Lua 5.2:lua5.2
Lua 5.3:lua5.3
Lua 5.4:lua5.4
"
logs=build/test
rm -rf "$logs" && mkdir -p "$logs"

# The library must stay loadable by plain Lua 5.1, love.js has nothing newer.
while read -r file; do
  check "Lua 5.1 syntax: $file" luac5.1 -p "$file"
done < <(find physics.lua physics spec -name '*.lua' | sort)

# Each run below says which interpreter it wants; a run on another one has to be noticed.
wrong_lua() { PHYSICS_LUA="LuaJIT -joff" busted --lua=luajit --helper=scripts/interpreter.lua; }
check "specs on the wrong interpreter are refused" refuses wrong_lua

run_specs() {
  local name=$1 command=$2
  local started=$SECONDS
  PHYSICS_LUA=$name busted --lua="$command" --output=plainTerminal \
    --helper=scripts/interpreter.lua </dev/null >"$logs/$name.log" 2>&1
  echo "$? $((SECONDS - started))" >"$logs/$name.status"
}
export -f run_specs
export logs

# Two at a time on a machine with two cores: they share nothing but the files they read.
jobs=${JOBS:-$(getconf _NPROCESSORS_ONLN)}
printf '%s' "$interpreters" | sed '/^$/d' | tr '\n' '\0' |
  xargs -0 -P "$jobs" -I{} bash -c 'run_specs "${1%%:*}" "${1#*:}"' _ {}

while IFS=: read -r name _; do
  [ -n "$name" ] || continue
  read -r code seconds <"$logs/$name.status"
  count_specs "$name" "$code" "$logs/$name.log" "$seconds"
done <<<"$interpreters"

finish
