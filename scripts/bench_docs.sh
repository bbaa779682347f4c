#!/usr/bin/env bash
# Measures everything and brings it into bench/README.md, docs/performance.md and .svg. Options are
# those of scripts/bench.sh; `--path DIR` says where bump.lua and FizzX are.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build

bash scripts/bench.sh "$@" --json >build/bench.json
# The scenes with which plain Lua is compared; of two options of the same name the last one counts.
bash scripts/bench.sh "$@" --mode lua5.1 --scene pile,pile-awake --n 500 --json >build/bench-lua51.json
luajit bench/docs.lua build/bench.json build/bench-lua51.json
