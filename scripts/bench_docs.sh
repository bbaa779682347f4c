#!/usr/bin/env bash
# Measures everything and brings it into docs/performance.md and docs/performance.png. Options are
# those of scripts/bench.sh; `--path DIR` says where bump.lua and FizzX are.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build

bash scripts/setup.sh plot
bash scripts/bench.sh "$@" --json >build/bench.json
luajit bench/docs.lua build/bench.json
