--- The command line of the benchmark.

local engines = require("bench.engines")
local scenes = require("bench.scenes")

local options = {}

options.help = [[
Measures physics.lua and what its users would take instead, side by side.

  --scene NAMES    only these scenes, separated by commas; --list shows all
  --n NUMBERS      only these sizes; also sizes of your own
  --engine NAMES   only these: %s
  --mode NAMES     jit, off (LuaJIT as an interpreter), or the command of another Lua, such as
                   lua5.1, which runs the engines that need no LÖVE; default jit,off
                   (a Lua without a JIT: off)
  --steps N        frames to measure instead of the scene's own number
  --rounds N       how often everything is measured; the medians count; default 3
  --limit SECONDS  processor time for one run, then it is given up; default 10
  --path DIR       also look there for bump.lua and FizzX (folder fizzx)
  --json           the results as JSON
  --quick          small scenes, few steps, one process: does it run?
  --list           shows scenes and engines
]]

local hasJit = rawget(_G, "jit") ~= nil
local DEFAULTS = { rounds = 3, limit = 10, modes = hasJit and { "jit", "off" } or { "off" } }

local function fail(...)
  error("bench: " .. string.format(...), 0)
end

local function split(text)
  local words = {}
  for word in text:gmatch("[^,]+") do
    words[#words + 1] = word
  end
  return words
end

local function number(option, text)
  local value = tonumber(text)
  if not value or value <= 0 then
    fail("--%s must be a number > 0, got %s", option, text)
  end
  return value
end

local function integer(option, text)
  local value = number(option, text)
  if value ~= math.floor(value) then
    fail("--%s must be an integer, got %s", option, text)
  end
  return value
end

local function known(option, text, isKnown)
  local names = split(text)
  for _, name in ipairs(names) do
    if not isKnown(name) then
      fail("--%s: there is no %s; --list shows what there is", option, name)
    end
  end
  return names
end

local function isEngine(name)
  for _, engine in ipairs(engines.names) do
    if engine == name then
      return true
    end
  end
  return false
end

-- Option -> what it does with its value. Those in FLAGS have none.
local FLAGS = { json = true, quick = true, list = true, help = true }
local SET = {
  scene = function(chosen, text)
    chosen.scenes = known("scene", text, scenes.get)
  end,
  engine = function(chosen, text)
    chosen.engines = known("engine", text, isEngine)
  end,
  n = function(chosen, text)
    chosen.sizes = {}
    for i, word in ipairs(split(text)) do
      chosen.sizes[i] = integer("n", word)
    end
  end,
  mode = function(chosen, text)
    chosen.modes = split(text)
    for _, mode in ipairs(chosen.modes) do
      if mode == "jit" and not hasJit then
        fail("--mode jit: %s has no JIT", _VERSION)
      end
    end
  end,
  path = function(chosen, text)
    chosen.path = text
  end,
  -- For the processes that the benchmark starts itself.
  child = function(chosen, text)
    chosen.child = text
  end,
  steps = function(chosen, text)
    chosen.steps = integer("steps", text)
  end,
  rounds = function(chosen, text)
    chosen.rounds = integer("rounds", text)
  end,
  limit = function(chosen, text)
    chosen.limit = number("limit", text)
  end,
}

-- Everything happens in this process then, so it has to be in this Lua.
local function checkQuick(chosen)
  for _, mode in ipairs(chosen.quick and chosen.modes or {}) do
    if mode ~= "jit" and mode ~= "off" then
      fail("--quick cannot be played by %s: start bench/run.lua with it", mode)
    end
  end
end

--- Reads the command line, `--name value` or `--name=value`.
---
--- Errors: an unknown option, scene or engine; a value that is missing or cannot be used.
---@param arguments string[]
---@return table chosen
function options.read(arguments)
  local chosen = {}
  for name, value in pairs(DEFAULTS) do
    chosen[name] = value
  end
  local i = 1
  while arguments[i] do
    local name, value = arguments[i]:match("^%-%-(%w+)=(.*)$")
    name = name or arguments[i]:match("^%-%-(%w+)$")
    if FLAGS[name] and not value then
      chosen[name] = true
    elseif SET[name] then
      if not value then
        i = i + 1
        value = arguments[i] or fail("--%s needs a value", name)
      end
      SET[name](chosen, value)
    else
      fail("unknown option %s; --help shows all", arguments[i])
    end
    i = i + 1
  end
  checkQuick(chosen)
  return chosen
end

options.help = options.help:format(table.concat(engines.names, ", "))

return options
