#!/usr/bin/env bash
# The formatter, in the one version that is used everywhere.
set -uo pipefail

# npm's own patience without a network is minutes.
export npm_config_fetch_retries=1 npm_config_fetch_retry_mintimeout=1000
export npm_config_fetch_retry_maxtimeout=5000 npm_config_fetch_timeout=60000
export npm_config_update_notifier=false npm_config_loglevel=error
npx --yes @johnnymorganz/stylua-bin@2.5.2 "$@" && exit
code=$?
if ! npx --yes @johnnymorganz/stylua-bin@2.5.2 --version >/dev/null 2>&1; then
  echo "StyLua did not start. It comes through npx (Node.js), which fetches it the first time:" >&2
  echo "that time needs the network." >&2
fi
exit "$code"
