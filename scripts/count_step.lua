--- Counts the functions and files of the core that one step goes through, by debug hooks:
---
---   lua5.1 scripts/count_step.lua

package.path = "./?.lua;" .. package.path

local physics = require("physics")

-- Plays a step of a world; prints how many functions in how many files it has called.
local function count(name, world)
  local seen, files, functions, inFiles = {}, {}, 0, 0
  debug.sethook(function()
    local info = debug.getinfo(2, "S")
    local file = info.what == "Lua" and info.source:match("physics/(.*)$")
    local key = file and file .. ":" .. info.linedefined
    if key and not seen[key] then
      inFiles = files[file] and inFiles or inFiles + 1
      seen[key], files[file], functions = true, true, functions + 1
    end
  end, "c")
  world:update(1 / 60)
  debug.sethook()
  print(("%s: %d functions in %d files"):format(name, functions, inFiles))
end

local empty = physics.newWorld({ gravity = 800 })
for _ = 1, 5 do
  empty:update(1 / 60)
end
count("an empty world", empty)

local world = physics.newWorld({ gravity = 800 })
world:add("floors", { x = 0, y = 100, width = 400, height = 10, static = true, friction = 0.3 })
for n = 1, 3 do
  world:add("crates", { x = 50, y = 100 - 20 * n, width = 20, height = 20, friction = 0.3 })
end
for _ = 1, 30 do
  world:update(1 / 60)
end
world.objects.crates[3].vx = 60
count("a pushed stack of three", world)
