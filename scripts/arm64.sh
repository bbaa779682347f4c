#!/usr/bin/env bash
# Runs the specs on LuaJIT for arm64, emulated by qemu: its trace compiler is another one than that
# for x86-64. LuaJIT is that of Debian 13, unpacked into build/arm64; nothing of it goes into the
# system. A quarter of an hour; with --all, which runs the slowest specs, too, more than one.
set -uo pipefail
. "$(dirname "$0")/checks.sh"

# Each of these takes more than two minutes there.
slow="debugging_bad_input fuzz properties recovery state
01_seams 03_stacks 05_pushing 06_riding 07_oneway 08_crushing 09_rest_and_bounce 10_free_motion
12_momentum 13_piles 15_tight 16_nudge 17_pushable"
# Not asked: how long something takes in an emulation; a process of its own, which would not be
# emulated; and how much room for code is left (there is less, see docs/performance.md).
left_out=(--filter-out="in less than 50 ms" --filter-out="works as lib.physics"
  --filter-out="leaves room in a small world")
place=$PWD/build/arm64
root=$place/root

# apt for another Debian and another machine, in a folder of its own.
fetch_packages() {
  local apt=$place/apt
  mkdir -p "$apt/state/lists/partial" "$apt/cache/archives/partial" "$place/packages"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
    "http://deb.debian.org/debian trixie main" >"$apt/sources.list"
  local options=(-qq -o "Dir::State=$apt/state" -o "Dir::Cache=$apt/cache"
    -o "Dir::State::status=/dev/null" -o "Dir::Etc::sourcelist=$apt/sources.list"
    -o "Dir::Etc::sourceparts=-" -o "APT::Architecture=arm64" -o "APT::Architectures=arm64"
    -o "APT::Sandbox::User=$(id -un)")
  apt-get "${options[@]}" update || return
  (cd "$place/packages" && apt-get "${options[@]}" download \
    luajit libluajit-5.1-2 libc6 libgcc-s1 lua-filesystem lua-system lua-term)
}

unpack() {
  [ ! -x "$place/luajit" ] || return 0
  rm -rf "$place" && mkdir -p "$root"
  fetch_packages || return
  for package in "$place"/packages/*.deb; do
    dpkg -x "$package" "$root" || return
  done
  ln -s usr/lib "$root/lib"
  # What is pure Lua is that of this machine: busted and what it needs.
  cat >"$place/luajit" <<SCRIPT
#!/bin/sh
export LUA_PATH='$(luajit -e 'print(package.path)')'
export LUA_CPATH='$root/usr/lib/aarch64-linux-gnu/lua/5.1/?.so'
exec qemu-aarch64-static -L '$root' '$root/usr/bin/luajit' "\$@"
SCRIPT
  chmod +x "$place/luajit"
}
check "LuaJIT for arm64 is there" unpack
check "it compiles" "$place/luajit" -e 'assert(jit.arch == "arm64" and jit.status())'
if [ "$failed" -gt 0 ]; then
  finish
  exit 1
fi

here=$(luajit spec/support/everything.lua)
# same_number OPTION...: the options are those of luajit.
same_number() {
  local there
  there=$("$place/luajit" "$@" spec/support/everything.lua) || return 1
  echo "$there on arm64, $here here"
  [ -n "$here" ] && [ "$here" = "$there" ]
}
what="the determinism scene gives the same number as here"
check "$what" same_number
check "$what without the trace compiler" same_number -joff
# A product and a sum in one instruction are rounded once: see "Where it works" in the README.
check "with fma it gives another one" refuses same_number -O+fma
check "$what with fma, but without fuse" same_number -O+fma -O-fuse

logs=build/arm64-logs
rm -rf "$logs" && mkdir -p "$logs"
list_specs "$slow" "${1:-}"
run_one() {
  local log=$logs/$(basename "$1") started=$SECONDS
  PHYSICS_LUA=LuaJIT "$place/luajit" "$busted" --ignore-lua --output=plainTerminal \
    --helper=scripts/interpreter.lua "${@:2}" "$1" >"$log.log" 2>&1 </dev/null
  echo "$? $((SECONDS - started))" >"$log.status"
}
busted=$(command -v busted)
export -f run_one
export logs place busted
printf '%s\0' "${files[@]}" |
  xargs -0 -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -I{} bash -c 'run_one "$@"' _ {} "${left_out[@]}"
for file in "${files[@]}"; do
  log=$logs/$(basename "$file")
  read -r code seconds <"$log.status"
  count_specs "arm64, $file" "$code" "$log.log" "$seconds"
done

echo "left out: ${left_out[*]#*=}"
finish
