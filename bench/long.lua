--- Plays a scene for minutes and tells what a player would feel: how often LuaJIT throws its code
--- away ("flush"), and the worst frame after the first ten seconds.
---
---   love bench --long swarm-kite:300,swarm-soft-kite:300 [minutes]      in LÖVE, with its limits
---   luajit bench/long.lua swarm-kite:300 5

local FRAMES, FIRST = 60, 600 -- frames a second; those in which everything is compiled

local long = {}

local function find(name)
  for _, definition in ipairs(require("bench.scenes").list) do
    if definition.name == name then
      return definition
    end
  end
  error("there is no scene " .. name, 0)
end

-- Plays one scene; prints a line.
local function play(name, count, minutes)
  local scene, flushes = find(name).build(count), 0
  local jit = rawget(_G, "jit")
  local function note(what)
    flushes = flushes + (what == "flush" and 1 or 0)
  end
  local world = require("bench.engines.ours").new(scene)
  local times, frames = {}, minutes * 60 * FRAMES
  if jit then
    jit.attach(note, "trace")
  end
  for frame = 1, frames do
    local before = os.clock()
    scene.frame(world, frame)
    times[frame] = (os.clock() - before) * 1000
  end
  if jit then
    jit.attach(note)
  end
  local late = {}
  for frame = FIRST + 1, frames do
    late[#late + 1] = times[frame]
  end
  table.sort(late)
  local text = "%s %d: %.1f flushes a minute; after 10 s median %.2f, p99.9 %.2f, worst %.2f ms"
  local share = late[math.ceil(0.999 * #late)]
  print(text:format(name, count, flushes / minutes, late[math.ceil(#late / 2)], share, late[#late]))
end

--- Plays the scenes of a list, "name:count,name:count".
function long.main(list, minutes)
  for name, count in list:gmatch("([%w-]+):(%d+)") do
    play(name, tonumber(count), minutes)
  end
end

if arg and arg[0] and arg[0]:find("bench/long%.lua$") then
  local root = arg[0]:match("^(.*)bench/long%.lua$")
  package.path = (root == "" and "." or root) .. "/?.lua;" .. package.path
  long.main(arg[1] or "swarm-kite:300", tonumber(arg[2]) or 5)
end

return long
