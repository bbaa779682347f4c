-- The first thing that runs in the Lua of the page (machine.js): makes the library and the stage
-- from their sources, and returns the function that the page calls for everything else.

local librarySource, stageSource, measure, write = ...

-- LÖVE runs LuaJIT, which speaks Lua 5.1: these names are there.
unpack, loadstring, math.pow = table.unpack, load, function(x, y)
  return x ^ y
end
-- There are no files to find, and a program that comes with an address must not reach what lies
-- behind Lua here.
local traceback = debug.traceback
io, package.loaded.io, package.path, package.cpath, package.loadlib = nil, nil, "", "", nil
package.preload.physics = load(librarySource, "@physics.lua")

function print(...)
  local texts = {}
  for i = 1, select("#", ...) do
    texts[i] = tostring((select(i, ...)))
  end
  write(table.concat(texts, "\t"))
end

local stage = load(stageSource, "@stage.lua")()
debug = { traceback = traceback, getinfo = debug.getinfo } -- the library asks where its caller is
package.loaded.debug = debug
local run

local actions = {}

function actions.start(code)
  run = nil
  run = stage.start({ measure = measure }, require("physics"), code)
end

function actions.isOver()
  return run.isOver and "yes" or ""
end

local NAMES = { "key", "moveMouse", "button", "step", "draw", "follow", "hash", "objects" }
for _, name in ipairs(NAMES) do
  actions[name] = function(...)
    return run[name](run, ...)
  end
end

-- Returns the message of an error and the line of the program that it is about, 0 when none is
-- known.
local function describe(problem)
  local message = tostring(problem)
  local line = message:match("^main%.lua:(%d+):") or traceback():match("main%.lua:(%d+):")
  return { message, tonumber(line) or 0 }
end

-- Returns true and the result, or false, the message and the line.
return function(action, ...)
  local isDone, result = xpcall(actions[action], describe, ...)
  if isDone then
    return true, result
  end
  return false, result[1], result[2]
end
