#!/usr/bin/env bash
# Opens the examples. Without a display it plays them all in a virtual one and says where the
# pictures are.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ] || [ "$(uname)" = Darwin ]; then
  exec love examples
fi
echo "There is no display here: playing the examples in a virtual one (Xvfb)."
bash scripts/examples.sh
