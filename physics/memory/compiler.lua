---@diagnostic disable
--- Gives LuaJIT's trace compiler room for the library, and says which functions it leaves alone.
-- Where there is no compiler, or no debug library, nothing happens.
--
-- A trace is one path through the code, branch by branch. The library has up to 2500 in a scene.
-- LuaJIT has room for 1000 in the whole program, in 512 kB, LÖVE 11.4 for 2000, in 16 MB. When the
-- room is full, all traces are thrown away and compiled again. So the room is made larger.

local compiler = {}

local jit = rawget(_G, "jit")
local debug = rawget(_G, "debug")

-- Traces, kB of machine code. A game that wants other limits sets them after it has loaded the
-- library. (LuaJIT's `hotexit` stays: with 150 for 10, a crowd has a third fewer traces after four
-- minutes, but ordinary calls take up to twice the time until their ways are compiled.)
local ROOM = { "maxtrace=8000", "maxmcode=16384" }

--- By file: the functions that are not compiled.
compiler.INTERPRETED = {
  -- Functions that go through a table by `next` or `pairs`. LuaJIT of 2022 makes code of them that
  -- may crash on x64: it reads the result of `next` through the lower half of a pointer to the
  -- stack.
  ["fields.check"] = "firstBad isEmpty",
  ["maps.cells"] = "clear waiting",
  ["maps.recall"] = "place snapshotOf save begin find finish",
  ["maps.properties"] = "put read decide isEmpty",
  ["maps.tiled.tileset"] = "index",
  ["memory.compiler"] = "eachExport listNew load",
  ["memory.keyOrder"] = "sorted",
  ["memory.lazy"] = "fill",
  ["fields.forms"] = "isSame copy",
  ["objects.groups"] = "sortedKeys hasOthers compare",
  ["objects.registry"] = "find search",
  ["queries.move"] = "finish",
  ["state.format"] = "isPlain",
  ["state.older"] = "read objectsOf",
  ["state.restore"] = "clear emptyGroups",
  ["state.validate"] = "needMaps",
  ["world.bounds"] = "set",
  ["world.checked"] = "misspelt wrongGroup refusesNothing checkRows",
}

local exported = {} -- functions that modules give to others, while it works
local handled = {} -- names of modules

-- Calls `visit(name, f)` for each function that a module gives to others.
local function eachExport(module, visit)
  for name, value in next, type(module) == "table" and module or { module }, nil do
    if type(value) == "function" then
      visit(name, value)
    elseif name == "methods" then
      eachExport(value, visit)
    end
  end
end

local function export(_, f)
  exported[f] = true
end

-- Leaves functions of a module alone: of the functions that it gives to others, and of the local
-- functions that these use. Functions of other files are left out: their turn comes with that file.
local function leave(module, names)
  local wanted, seen = {}, {}
  for name in names:gmatch("%S+") do
    wanted[name] = true
  end
  local function visit(name, f)
    seen[f] = true
    if wanted[name] then
      jit.off(f, true)
    end
    local n, inner, value = 1, debug.getupvalue(f, 1)
    while inner do
      if type(value) == "function" and not (exported[value] or seen[value]) then
        visit(inner, value)
      end
      n = n + 1
      inner, value = debug.getupvalue(f, n)
    end
  end
  eachExport(module, visit)
end

-- Returns the modules that were loaded since the last call, by their names without the root.
local function listNew(root)
  local list, prefix = {}, root .. "."
  exported = {}
  for name, module in next, package.loaded, nil do
    local isOurs = type(name) == "string" and name:sub(1, #prefix) == prefix
    if isOurs and (type(module) == "table" or type(module) == "function") then
      list[name:sub(#prefix + 1)] = not handled[name] and module or nil
      handled[name] = true
      eachExport(module, export)
    end
  end
  return list
end

--- Loads a module, and applies all this to it and to the modules that it loads below the root.
--- Returns the module. Meanwhile nothing is compiled: this runs once. (Else `require` of the
--- library takes 1 ms more, and 30 kB.)
function compiler.load(name, root)
  local isOn = jit.status()
  jit.off()
  local module, list = require(name), listNew(root)
  for file, names in next, compiler.INTERPRETED, nil do
    if list[file] then
      leave(list[file], names)
    end
  end
  jit[isOn and "on" or "off"]()
  return module
end

if type(jit) == "table" and jit.opt and type(debug) == "table" and debug.getupvalue then
  jit.opt.start(ROOM[1], ROOM[2])
else
  compiler.load = require
end

return compiler
