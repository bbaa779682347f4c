#!/usr/bin/env bash
# Runs the benchmark in LÖVE, without a window. Options: scripts/bench.sh --help
set -euo pipefail
cd "$(dirname "$0")/.."

# LÖVE complains when a machine without a desktop has none.
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp}
exec love bench "$@"
