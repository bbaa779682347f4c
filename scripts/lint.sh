#!/usr/bin/env bash
# luacheck (.luacheckrc) and the formatter (stylua.toml).
set -uo pipefail
. "$(dirname "$0")/checks.sh"

stylua=@johnnymorganz/stylua-bin@2.5.2
mapfile -t sources < <(lua_sources)

check "luacheck" luacheck --no-color --quiet "${sources[@]}" rockspec/*.rockspec

# The rule that matters most is one of configuration: see that it bites.
names_love() { echo "love.graphics.circle('fill', 0, 0, 1)" | luacheck --filename "$1" -; }
check "luacheck refuses love in the core" refuses names_love physics/world.lua
check "luacheck allows love in physics/draw.lua" names_love physics/draw.lua

start_stylua() {
  npx --yes "$stylua" --version && return
  echo "StyLua did not start. It comes through npx (Node.js) as $stylua;"
  echo "the first time npx fetches it, so that time needs the network."
  return 1
}
check "StyLua starts" start_stylua
check "StyLua finds nothing to change" npx --yes "$stylua" --check "${sources[@]}"

finish
