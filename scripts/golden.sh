#!/usr/bin/env bash
# Writes spec/golden.lua anew: each number as LuaJIT, LuaJIT without compiler, Lua 5.1 and Lua 5.4
# compute it, if all four agree.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/golden
file=spec/invariants/determinism_spec.lua

# note NAME LUA: what an interpreter computes, sorted, each number once.
note() {
  local list=build/golden/$1
  : >"$list"
  PHYSICS_GOLDEN=$list $2 scripts/plain_busted.lua "$file" >/dev/null 2>&1 || true
  LC_ALL=C sort -u -o "$list" "$list"
}
note luajit luajit &
note joff "luajit -joff"
note lua5.1 lua5.1 &
note lua5.4 lua5.4
wait
for other in joff lua5.1 lua5.4; do
  diff build/golden/luajit "build/golden/$other" || { echo "$other computes other numbers" >&2; exit 1; }
done
{
  sed -n '1,/^return {/p' spec/golden.lua
  sed 's/^\([^ ]*\) \(.*\)$/  \1 = "\2",/' build/golden/luajit
  echo "}"
} >build/golden/golden.lua
cp build/golden/golden.lua spec/golden.lua
git --no-pager diff --stat spec/golden.lua
