#!/usr/bin/env bash
# Installs what the other scripts call, from the packages of Debian or Ubuntu. Asks nothing, and
# touches neither the network nor the system when everything is there. What only some targets need
# is named: `setup.sh web` adds a browser, `site` Python's environments, `gopher` Go, `arm64` qemu,
# `wine` Wine and a compiler for Windows, `pictures` ffmpeg, `tiled` the editor Tiled.
set -euo pipefail

# Chromium has several names.
browser() {
  command -v chromium || command -v chromium-browser || command -v google-chrome
}
if [ "${1:-}" = --browser ]; then
  browser
  exit
fi

# command it provides : Debian packages
needs="
make:make
love:love
luarocks:luarocks
busted:lua-busted
luacheck:lua-check
luajit:luajit
lua5.1:lua5.1
luac5.1:lua5.1
lua5.2:lua5.2
lua5.3:lua5.3
lua5.4:lua5.4
Xvfb:xvfb
xvfb-run:xvfb
xauth:xauth
npx:nodejs npm
zip:zip
unzip:unzip
"

missing=""
packages=""
for extra in "$@"; do
  case $extra in
    web) browser >/dev/null || needs="${needs}chromium:chromium"$'\n' ;;
    # No command tells whether Python can make an environment.
    site) python3 -c "import ensurepip, venv" >/dev/null 2>&1 || {
      missing=" python3"
      packages=" python3 python3-venv"
    } ;;
    pictures) needs="${needs}ffmpeg:ffmpeg"$'\n' ;;
    tiled) needs="${needs}tiled:tiled"$'\n' ;;
    gopher) needs="${needs}go:golang-go"$'\n' ;;
    wine) needs="${needs}x86_64-w64-mingw32-gcc:gcc-mingw-w64-x86-64-win32 wine64"$'\n' ;;
    arm64) needs="${needs}qemu-aarch64-static:qemu-user-static debian-archive-keyring"$'\n' ;;
    *) echo "setup: what is '$extra'?" >&2 && exit 1 ;;
  esac
done

while IFS=: read -r name package; do
  [ -n "$name" ] || continue
  command -v "$name" >/dev/null 2>&1 && continue
  missing="$missing $name"
  packages="$packages $package"
done <<<"$needs"

if [ -z "$missing" ]; then
  exit 0
fi
echo "setup: not found:$missing"

if ! command -v apt-get >/dev/null 2>&1; then
  cat >&2 <<MESSAGE
setup: this installs by itself on Debian and Ubuntu only. Here, please install these by hand:$missing
(LÖVE from https://love2d.org, LuaRocks from https://luarocks.org, busted and luacheck by LuaRocks.
Node.js brings StyLua, cargo the checker of types and the sources of Lua 5.5.) The game itself needs
only LÖVE: \`love examples\` runs without any other. \`busted\` alone runs the specs on LuaJIT.
MESSAGE
  exit 1
fi

# shellcheck disable=SC2086 # one word per package is meant
packages=$(printf '%s\n' $packages | sort -u | tr '\n' ' ')
as_root=""
if [ "$(id -u)" -ne 0 ]; then
  # -n: sudo must not ask for a password, a build cannot answer.
  if ! command -v sudo >/dev/null 2>&1 || ! sudo -n true 2>/dev/null; then
    cat >&2 <<MESSAGE
setup: installing needs root, and sudo is not there or asks for a password. Please run this once:
  sudo apt-get update && sudo apt-get install -y --no-install-recommends $packages
MESSAGE
    exit 1
  fi
  as_root="sudo -n"
fi

echo "setup: installing $packages"
apt() { $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq "$@" </dev/null; }
apt update
# shellcheck disable=SC2086
apt install -y --no-install-recommends $packages

for name in $missing; do
  if ! command -v "$name" >/dev/null 2>&1; then
    echo "setup: $name is still not found after installing $packages" >&2
    exit 1
  fi
done
