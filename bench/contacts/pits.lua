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
    local isBox = hasBoxes and n % 3 == 0
    local fields = { friction = isBox and 0.3 or nil, radius = not isBox and radius or nil }
    scene:add("balls", put(x, y, 2 * radius, 2 * radius, fields))
  end
end

local function playPit(scene)
  local hz = scene:start(800, scene:each(scenes.RATES))
  local hasBoxes = scene:each({ false, true })
  addPit(scene, scene.random:pick({ 220, 260, 320 }), hasBoxes)
  local hasMet, left, landed = {}, COUNT, nil
  function scene.world.onBegin(a, b)
    for _, object in ipairs({ a, b }) do
      if not object.static and not hasMet[object] then
        hasMet[object], left = true, left - 1
      end
    end
  end
  repeat
    scene:step()
    landed = landed or left == 0 and scene.frame
    local isAtRest = landed and scene.world.stats.resting == COUNT
  until isAtRest or scene.frame >= 14 * hz
  local isStill = scene.world.stats.resting == COUNT
  scene:measure("moves after 14 s", not isStill)
  scene:measure(
    "rests after all have landed, s",
    isStill and landed and (scene.frame - landed) / hz
  )
  scene:measure("in each other at rest, px", isStill and scene:deepest())
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
  local kind = scene:each({ "boxes", "equal balls", "balls", "mixed" })
  local random, hz, things = scene.random, scene:start(800), {}
  local friction = random:pick({ 0.3, 0.5, 0.9 })
  local belt = { surfaceSpeed = random:pick({ 40, 80, 150 }), friction = friction }
  scene:add("belts", tile(-600, 100, 1000, 20, belt))
  scene:add("walls", tile(400, -100, 20, 220))
  local x, equal, count = 400 - random:between(0, 40), random:between(5, 9), random:integer(2, 16)
  for n = 1, count do
    local radius = kind == "equal balls" and equal or random:between(5, 9)
    local isBox = kind == "boxes" or kind == "mixed" and random:chance(0.5)
    x = x - 2 * radius - random:pick({ 0, random:between(0, 12) })
    local thing = put(x, 100 - 2 * radius, 2 * radius, 2 * radius, { friction = friction })
    thing.radius = not isBox and radius or nil
    things[n] = scene:add("things", thing)
  end
  local arrived
  repeat
    scene:step()
    arrived = arrived or touchAll(things) and scene.frame
    local isAtRest = scene.world.stats.resting == count
  until isAtRest or scene.frame >= 20 * hz
  local isStill = scene.world.stats.resting == count
  scene:measure("moves after 20 s", not isStill)
  scene:measure("rests after all touch, s", isStill and arrived and (scene.frame - arrived) / hz)
  scene:measure("in each other at the end, px", scene:deepest())
end

return {
  scenes.subject("pits", 144, playPit, {
    { "rests after all have landed, s", 2 },
    { "moves after 14 s", 0 },
    { "in each other at rest, px", 0.1 },
  }),
  scenes.subject("queues", 960, playQueue, {
    { "rests after all touch, s", 2 },
    { "moves after 20 s", 0 },
    { "in each other at the end, px", 0.1 },
  }),
}
