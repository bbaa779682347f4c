#!/usr/bin/env bash
# Plays the scene of the determinism spec in LÖVE: the LÖVE of this machine (LOVE names another), and
# LÖVE 11.5, that of Debian 13, unpacked into build/love-11.5; nothing of it goes into the system.
# With --all the examples too, in a window of LÖVE 11.5. With --only only the first.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/debian.sh

place=$PWD/build/love-11.5
stage=$PWD/build/love-scene

unpack() {
  [ ! -x "$place/love" ] || return 0
  fetch_debian "$place" amd64 --download-only --yes install love libgl1-mesa-dri libglx-mesa0 || return
  local libraries=$place/root/usr/lib/x86_64-linux-gnu
  # With its own C library, and its own driver for a window without a graphics card.
  cat >"$place/love" <<SCRIPT
#!/bin/sh
export LIBGL_DRIVERS_PATH='$libraries/dri'
exec '$libraries/ld-linux-x86-64.so.2' --library-path '$libraries:$libraries/pulseaudio' \\
  '$place/root/usr/bin/love-11.5' "\$@"
SCRIPT
  chmod +x "$place/love"
}

rm -rf "$stage" && mkdir -p "$stage/spec"
cp -r physics.lua physics "$stage/" && cp -r spec/support "$stage/spec/"
cp bench/conf.lua "$stage/conf.lua"
cat >"$stage/main.lua" <<'LUA'
print(love.getVersion())
print("fold " .. require("spec.support.everything").fold())
os.exit(0)
LUA
number=$(luajit -e 'print(require("spec.golden").everything)')
limited() { if command -v timeout >/dev/null; then timeout -k 2 120 "$@"; else "$@"; fi; }
known_number() {
  local there
  there=$(XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp} limited "$1" "$stage") || return 1
  echo "$there; the spec says $number"
  [ -n "$number" ] && grep -qx "fold $number" <(tr -d '\r' <<<"$there")
}
check "the determinism scene gives the known number in LÖVE" known_number "${LOVE:-love}"
is_new() { "$1" --version | grep -F "LOVE 11.5"; }
if [ "${1:-}" = --only ] || is_new "${LOVE:-love}"; then
  finish
  exit
fi

check "LÖVE 11.5 is there" unpack
check "and it is that" is_new "$place/love"
check "the determinism scene gives the known number in LÖVE 11.5" known_number "$place/love"
if [ "${1:-}" = --all ]; then
  counts=$(LOVE=$place/love bash scripts/examples.sh | tee /dev/stderr | tail -n 1)
  read -r good _ bad _ <<<"$counts"
  passed=$((passed + good))
  failed=$((failed + bad))
fi

finish
