#!/usr/bin/env bash
# Builds Lua 5.1, 5.2, 5.3, 5.4 or 5.5 into build/puc/, once, and prints the path of the program:
#
#   scripts/puc_lua.sh 5.5
#   CC=x86_64-w64-mingw32-gcc scripts/puc_lua.sh 5.5 --windows
#
# Where there is a command like lua5.5, it prints that name instead; with --build it builds all the
# same, with --windows a program for Windows. Debian has no package of 5.5 yet, Windows and macOS have none of several. The sources are
# those in the crate lua-src, fetched by cargo; a C compiler (CC) makes the program (puc_lua.c).
set -euo pipefail
cd "$(dirname "$0")/.."

crate=551.1.0
version=$1
place=$PWD/build/puc
program=$place/lua$version
flags=(-O2 -DLUA_USE_POSIX)
case ${2:-}$(uname -s) in
  --windows* | MINGW* | MSYS* | CYGWIN*) program=$program.exe flags=(-O2) ;;
esac

if [ -z "${2:-}" ] && command -v "lua$version" >/dev/null 2>&1; then
  echo "lua$version"
  exit 0
fi
export PATH="$PATH:$HOME/.cargo/bin"
if [ ! -d "$place/vendor/lua-src" ]; then
  mkdir -p "$place/src" && touch "$place/src/lib.rs"
  printf '%s\n' '[package]' 'name = "puc"' 'version = "0.0.0"' 'edition = "2021"' \
    '[dependencies]' "lua-src = \"=$crate\"" '[workspace]' >"$place/Cargo.toml"
  if ! (cd "$place" && cargo vendor --quiet vendor) >/dev/null 2>"$place/log"; then
    echo "cargo did not get the crate lua-src $crate: the first time needs the network" >&2
    cat "$place/log" >&2
    exit 1
  fi
fi
if [ ! -x "$program" ] || [ scripts/puc_lua.c -nt "$program" ]; then
  sources=("$place/vendor/lua-src/lua-$version".*)
  if [ ! -d "${sources[0]}" ]; then
    echo "there is no Lua $version in lua-src $crate" >&2
    exit 1
  fi
  "${CC:-cc}" "${flags[@]}" -I"${sources[0]}" -o "$program" scripts/puc_lua.c "${sources[0]}"/*.c \
    -lm >&2
fi
echo "$program"
