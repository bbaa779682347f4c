#!/usr/bin/env bash
# Writes the library as one file, build/physics.lua. With --test it runs the specs against it, too:
# in a folder where the file stands alone, without the folder physics/.
set -uo pipefail
. "$(dirname "$0")/checks.sh"
. scripts/specs.sh

luajit scripts/single.lua build/physics.lua || exit 1
if [ "${1:-}" != --test ]; then
  echo "build/physics.lua is the whole library in one file"
  exit 0
fi

lua55=$(bash scripts/puc_lua.sh 5.5) || exit 1
stage=build/single
rm -rf "$stage" && mkdir -p "$stage"
git ls-files -z -co --exclude-standard | grep -zvE '^(physics|web)/' | xargs -0 cp --parents -t "$stage"
cp build/physics.lua "$stage/"
find physics -name '*.lua' | sed 's/\.lua$//; s#/#.#g' >"$stage/modules.txt"
check "Lua 5.1 reads the single file" luac5.1 -p "$stage/physics.lua"

# The same file twice, and nothing else: each is a library of its own and shows only its own name.
mkdir "$stage/lib" && cp build/physics.lua "$stage/lib/"
cat >"$stage/twice.lua" <<'LUA'
package.path = "./?.lua"
pcall(require, "ffi") -- of LuaJIT, and not of the library
local seen = {}
for _, list in ipairs({ package.loaded, package.preload, _G }) do
  seen[list] = {}
  for name in pairs(list) do
    seen[list][name] = true
  end
end
local copies = { require("physics"), require("lib.physics"), dofile("physics.lua") }
for i, physics in ipairs(copies) do
  physics.load({ gravity = 800 })
  for _ = 1, i do
    physics.add("tiles", { x = 0, y = 100, width = 200, height = 16, static = true })
    physics.add("boxes", { x = 20 * #physics.objects.tiles, y = 0, width = 16, height = 16 })
    physics.objects.tiles[2] = nil
  end
end
for i, physics in ipairs(copies) do
  for _ = 1, 120 do
    physics.update(1 / 60)
  end
  assert(#physics.objects.boxes == i, "copies share a world")
  assert(physics.objects.boxes[1].y == 84, "the box is not on the floor")
  local hasTyped = false
  for _, column in pairs(physics._bodies) do
    hasTyped = hasTyped or type(column) == "cdata"
  end
  assert(hasTyped == (type(jit) == "table"), "typed arrays only with LuaJIT")
  local isRefused, message = pcall(physics.update, -1)
  assert(not isRefused and message:find("^%.?/?twice.lua:%d+: physics: world:update"), message)
end
seen[package.loaded]["physics"], seen[package.loaded]["lib.physics"] = true, true
for list, names in pairs(seen) do
  for name in pairs(list) do
    assert(names[name], "new: " .. tostring(name))
  end
end
LUA
for lua in luajit lua5.1 lua5.2 lua5.3 lua5.4 "$lua55"; do
  check "two copies live side by side on $lua" env -C "$stage" "$lua" twice.lua
done

# Left out are specs that open the library's files by name, which has nothing to open here, and those
# about motion: the code is that of `make test-all`, what may differ is how its parts find each other.
# Interpreted, without the slow specs.
command="env -C $stage luajit -joff -l scripts.single_helper scripts/plain_busted.lua"
play_specs < <(differing_files | grep -vE '/(fields|manual)_spec' |
  sed "s#^#LuaJIT -joff|$command --exclude-tags=files,slow|#")

finish
