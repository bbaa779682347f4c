#!/usr/bin/env bash
# Runs the specs on Lua built for Windows, in Wine (scripts/plain.sh says which). Paths have
# backslashes there, and commands go to cmd.exe.
#
#   scripts/wine.sh [5.1 ... 5.5]
set -uo pipefail
. "$(dirname "$0")/checks.sh"

place=$PWD/build/wine
mkdir -p "$place"
# Debian's wine64 has no command in the path.
wine=$(command -v wine64 || command -v wine || echo /usr/lib/wine/wine64)
[ $# -gt 0 ] || set -- 5.1 5.2 5.3 5.4 5.5

commands=()
for version in "$@"; do
  program=$(CC=x86_64-w64-mingw32-gcc bash scripts/puc_lua.sh "$version" --windows) || exit 1
  cat >"$place/lua$version" <<SCRIPT
#!/bin/sh
export WINEPREFIX='$place/prefix' WINEDEBUG=-all
exec '$wine' '$program' "\$@"
SCRIPT
  chmod +x "$place/lua$version"
  commands+=("$place/lua$version")
done
exec bash scripts/plain.sh "${commands[@]}"
