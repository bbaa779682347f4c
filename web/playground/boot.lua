-- The first thing that runs in the Lua of the page (machine.js): makes the library and the stage
-- from their sources, and returns the function that the page calls for everything else.

local librarySource, stageSource, measure = ...

local MOST = 200 -- printed lines that are kept until the page fetches them

-- LÖVE runs LuaJIT, which speaks Lua 5.1: these names are there.
unpack, loadstring, math.pow = table.unpack, load, function(x, y)
  return x ^ y
end
-- There are no files to find, and a program that comes with an address must not reach what lies
-- behind Lua here.
local traceback = debug.traceback
local time = { clock = os.clock, date = os.date, difftime = os.difftime, time = os.time }
os, package.loaded.os = time, time
io, package.loaded.io, package.loadlib = nil, nil, nil
package.searchers = { package.searchers[1] } -- preload
package.preload.physics = load(librarySource, "@physics.lua")

local printed = {}

function print(...)
  local texts = {}
  for i = 1, select("#", ...) do
    texts[i] = tostring((select(i, ...)))
  end
  if #printed < MOST then
    printed[#printed + 1] = table.concat(texts, "\t")
  end
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

-- Returns what was printed since the last time.
function actions.printed()
  local text = table.concat(printed, "\n")
  printed = {}
  return text
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
  if type(result) ~= "table" then
    return false, result, 0 -- without memory or stack Lua does not ask `describe`
  end
  return false, result[1], result[2]
end
