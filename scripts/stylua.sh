#!/usr/bin/env bash
# The formatter, in the one version that everybody uses.
set -uo pipefail
npx --yes @johnnymorganz/stylua-bin@2.5.2 "$@" && exit
code=$?
if ! npx --yes @johnnymorganz/stylua-bin@2.5.2 --version >/dev/null 2>&1; then
  echo "StyLua did not start. It comes through npx (Node.js), which fetches it the first time:" >&2
  echo "that time needs the network." >&2
fi
exit "$code"
