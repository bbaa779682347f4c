#!/usr/bin/env bash
# Runs the specs on LuaJIT for arm64, emulated by qemu: its trace compiler is another one than that
# for x86-64. LuaJIT is that of Debian 13, unpacked into build/arm64; nothing of it goes into the
# system. A quarter of an hour; with --all, which runs the slowest specs, too, more than one.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/specs.sh
. scripts/debian.sh

# Each of these takes more than two minutes there.
slow='debugging_bad_input|fuzz|recovery|state|0[135-9]_\w+|1[02357]_\w+|16_nudge'
place=$PWD/build/arm64

unpack() {
  [ ! -x "$place/luajit" ] || return 0
  fetch_debian "$place" arm64 download luajit libluajit-5.1-2 libc6 libgcc-s1 || return
  ln -s usr/lib "$place/root/lib"
  cat >"$place/luajit" <<SCRIPT
#!/bin/sh
exec qemu-aarch64-static -L '$place/root' '$place/root/usr/bin/luajit' "\$@"
SCRIPT
  chmod +x "$place/luajit"
}
check "LuaJIT for arm64 is there" unpack
check "it compiles" "$place/luajit" -e 'assert(jit.arch == "arm64" and jit.status())'
finish_if_failed

what="the determinism scene gives the same number as here"
check "$what" same_number "$place/luajit"
check "$what without the trace compiler" same_number "$place/luajit" -joff
# A product and a sum in one instruction are rounded once: see "Where it works" in the README.
check "with fma it gives another one" refuses same_number "$place/luajit" -O+fma
check "$what with fma, but without fuse" same_number "$place/luajit" -O+fma -O-fuse

# A process of its own (#posix) would not be emulated.
[ "${1:-}" != --all ] || slow=none
play_specs < <(spec_files | grep -vE "/($slow)_spec" |
  sed "s#^#LuaJIT|$place/luajit scripts/plain_busted.lua --exclude-tags=posix|#")

finish
