--- Pits of a hundred balls, or balls and boxes, and queues of them on a belt: when do they rest?

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local COUNT = 100

-- Adds a pit of some width with a grid of balls above it; some are boxes.
local function addPit(scene, width, hasBoxes)
  local random, columns = scene.random, math.floor((width - 4) / 25)
  scene:add("walls", tile(-40, 400, width + 80, 40))
  scene:add("walls", tile(-40, -1600, 40, 2000))
  scene:add("walls", tile(width, -1600, 40, 2000))
  for n = 0, COUNT - 1 do
    local radius, column = random:between(6, 11), n % columns
    local x = 2 + column * 25 + random:between(0, 24 - 2 * radius)
    local y = 370 - (n - column) / columns * 26 - random:between(0, 3)
    local object = put(x, y, 2 * radius, 2 * radius)
    if hasBoxes and n % 3 == 0 then
      object.friction = 0.3
    else
      object.radius = radius
    end
    scene:add("balls", object)
  end
end

local function playPit(scene)
  local hz, hasBoxes = scene:each(scenes.RATES), scene:each({ false, true })
  local width = scene.random:pick({ 220, 260, 320 })
  local world = scene:start(hz, 800)
  addPit(scene, width, hasBoxes)
  local hasMet, left, landed = {}, COUNT, nil
  world.onBegin = function(a, b)
    for _, object in ipairs({ a, b }) do
      if not object.static and not hasMet[object] then
        hasMet[object], left = true, left - 1
      end
    end
  end
  for frame = 1, 14 * hz do
    scene:step()
    landed = landed or left == 0 and frame
    if landed and world.stats.resting == COUNT then
      scene:measure("rests after all have landed", (frame - landed) / hz)
      scene:measure("in each other at rest", scene:deepest())
      return
    end
  end
  scene:measure("moves after 14 s", true)
end

local function touchAll(things)
  for _, thing in ipairs(things) do
    if not thing.touching.right then
      return false
    end
  end
  return true
end

local function playQueue(scene)
  local random = scene.random
  local kind = ({ "boxes", "equal balls", "balls", "mixed" })[scene.seed % 4 + 1]
  local hz, count = random:pick(scenes.RATES), random:integer(2, 16)
  local world = scene:start(hz, 800)
  local speed, friction = random:pick({ 40, 80, 150 }), random:pick({ 0.3, 0.5, 0.9 })
  local belt = { surfaceSpeed = speed, friction = friction }
  scene:add("belts", tile(-600, 100, 1000, 20, belt))
  scene:add("walls", tile(400, -100, 20, 220))
  local x, equal, things = 400 - random:between(0, 40), random:between(5, 9), {}
  for n = 1, count do
    local radius = kind == "equal balls" and equal or random:between(5, 9)
    local isBox = kind == "boxes" or kind == "mixed" and random:chance(0.5)
    x = x - 2 * radius - random:pick({ 0, random:between(0, 12) })
    local thing = put(x, 100 - 2 * radius, 2 * radius, 2 * radius, { friction = friction })
    thing.radius = not isBox and radius or nil
    things[n] = scene:add("things", thing)
  end
  local arrived
  for frame = 1, 20 * hz do
    scene:step()
    arrived = arrived or touchAll(things) and frame
    if world.stats.resting == count then
      scene:measure("rests after all touch", (frame - (arrived or frame)) / hz)
      break
    end
  end
  scene:measure("moves after 20 s", world.stats.resting < count)
  scene:measure("in each other at rest", scene:deepest())
end

return {
  {
    name = "pits",
    scenes = 144,
    salt = { 101, 13 },
    rows = {
      { "rests after all have landed", 2, "s" },
      { "moves after 14 s", 0 },
      { "in each other at rest", 0.1, "px" },
    },
    play = playPit,
  },
  {
    name = "queues",
    scenes = 960,
    salt = { 59, 4 },
    rows = {
      { "rests after all touch", 2, "s" },
      { "moves after 20 s", 0 },
      { "in each other at rest", 0.1, "px" },
    },
    play = playQueue,
  },
}
