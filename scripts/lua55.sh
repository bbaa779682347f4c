#!/usr/bin/env bash
# Builds Lua 5.5 into build/lua55/lua5.5, once, and prints that path; where there is a command lua5.5
# it prints that name instead. Debian has no package of it yet. The sources are those in the crate
# lua-src, fetched by cargo; a C compiler makes the program (scripts/lua55.c).
set -euo pipefail
cd "$(dirname "$0")/.."

crate=551.1.0
place=build/lua55
program=$place/lua5.5

if command -v lua5.5 >/dev/null 2>&1; then
  echo lua5.5
  exit 0
fi
if [ ! -x "$program" ] || [ scripts/lua55.c -nt "$program" ]; then
  rm -rf "$place" && mkdir -p "$place/src"
  printf '%s\n' '[package]' 'name = "lua55"' 'version = "0.0.0"' 'edition = "2021"' \
    '[dependencies]' "lua-src = \"=$crate\"" '[workspace]' >"$place/Cargo.toml"
  touch "$place/src/lib.rs"
  export PATH="$PATH:$HOME/.cargo/bin"
  if ! (cd "$place" && cargo vendor --quiet vendor) >/dev/null 2>"$place/log"; then
    echo "cargo did not get the crate lua-src $crate: the first time needs the network" >&2
    cat "$place/log" >&2
    exit 1
  fi
  sources=("$place"/vendor/lua-src/lua-5.5.*)
  "${CC:-cc}" -O2 -DLUA_USE_POSIX -DLUA_USE_DLOPEN -I"${sources[0]}" -o "$program" \
    scripts/lua55.c "${sources[0]}"/*.c -lm -ldl -Wl,-E >&2
fi
echo "$program"
