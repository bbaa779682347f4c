#!/usr/bin/env bash
# The type checker, in the one version that is used everywhere. Built by cargo the first time, which
# takes some minutes.
set -uo pipefail

version=0.25.1
export PATH="$PATH:$HOME/.cargo/bin"
if [ "$(emmylua_check --version 2>/dev/null)" != "emmylua_check $version" ]; then
  echo "building emmylua_check $version, once: this takes some minutes" >&2
  if ! cargo install --quiet --locked "emmylua_check@$version"; then
    cat >&2 <<MESSAGE
emmylua_check $version could not be built. It needs the network and a cargo of 2025 or later (found:
$(cargo --version 2>/dev/null || echo none)). https://rustup.rs brings one; that of Debian 12 is too old.
MESSAGE
    exit 1
  fi
fi
exec emmylua_check "$@"
