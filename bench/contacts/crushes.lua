--- Which objects `onCrush` names among slopes and movers, also after `restore`; and what is put
--- elsewhere when it has been crushed.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local shapes = require("physics.space.shapes")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local function gapOf(a, b)
  local shape, other = shapes.of(a), shapes.of(b)
  local gap = shapes.gap(shape, a.x, a.y, a.width, a.height, other, b.x, b.y, b.width, b.height)
  return gap
end

-- A name of each object that is the same in another run.
local function namesOf(world)
  local names = {}
  for group, objects in pairs(world.objects) do
    for n, object in pairs(objects) do
      names[object] = group .. tostring(n)
    end
  end
  return names
end

local function addThing(scene, fixed, things)
  local random, size = scene.random, scene.random:integer(8, 22)
  local thing = put(random:integer(0, 218), random:integer(0, 158), size, size)
  thing.radius = random:chance(0.35) and size / 2 or nil
  local isThere = scene:isFree(thing, things)
  for _, other in ipairs(fixed) do
    if overlap.depth(thing, other) > 0 and random:chance(0.9) then
      isThere = false
    end
  end
  if isThere then
    things[#things + 1] = scene:add("things", thing)
  end
end

-- Builds a room of slopes and movers, and returns the movers.
local function build(scene)
  local random = scene.random
  local hz, gravity = random:pick(scenes.RATES), random:pick({ 900, 900, 0 })
  local world = scene:start(hz, gravity)
  world:setBounds(0, 0, 240, 180)
  local bounds = world.objects.bounds
  local fixed = { bounds.top, bounds.bottom, bounds.left, bounds.right }
  for _ = 1, random:integer(4, 12) do
    local width, height = random:integer(16, 80), random:integer(12, 60)
    local x, y = random:integer(0, 240 - width), random:integer(0, 180 - height)
    local slope = random:chance(0.85) and random:pick(scenes.SLOPES) or nil
    fixed[#fixed + 1] = scene:add("slopes", tile(x, y, width, height, { slope = slope }))
  end
  local movers, things = {}, {}
  for n = 1, random:integer(1, 3) do
    local width, height = random:integer(20, 70), random:integer(10, 40)
    local x, y = random:integer(0, 240 - width), random:integer(0, 180 - height)
    local mover = put(x, y, width, height, { kinematic = true })
    mover.slope = random:chance(0.6) and random:pick(scenes.SLOPES) or nil
    mover.vx, mover.vy = random:pick({ 0, 40, -40 }), random:pick({ 0, 50, -50 })
    movers[n] = scene:add("movers", mover)
    fixed[#fixed + 1] = mover
  end
  for _ = 1, random:integer(2, 7) do
    addThing(scene, fixed, things)
  end
  return movers
end

-- Makes steps, in which the movers turn at the walls.
local function drive(scene, movers, count)
  for _ = 1, count do
    for _, mover in ipairs(movers) do
      scene:turn(mover, -10, 250 - mover.width, -10, 190 - mover.height)
    end
    scene:step()
  end
end

local function playNames(scene)
  local movers = build(scene)
  local world, log = scene.world, {}
  local names = namesOf(world)
  world.onCrush = function(object, a, b, axis)
    log[#log + 1] =
      table.concat({ names[object], tostring(names[a]), tostring(names[b]), axis }, " ")
    scene:show("      crushed: %s", log[#log])
    for _, other in ipairs({ a or false, b or false }) do
      local isWrong = not (other and world:groupOf(other)) or other == object
      scene:measure("names nothing, or itself", isWrong)
      scene:measure("names one that is away", not isWrong and gapOf(object, other))
    end
  end
  local count = math.floor(5 * scene.hz)
  local half = math.floor(count * (0.3 + scene.seed % 5 / 10))
  drive(scene, movers, half)
  local state = world:save()
  local logs, hashes = {}, {}
  for n = 1, 2 do
    log = {}
    drive(scene, movers, count - half)
    logs[n], hashes[n] = table.concat(log, ";"), world:hash()
    world:restore(state)
  end
  scene:measure("differs after restore", logs[1] ~= logs[2] or hashes[1] ~= hashes[2])
end

-- Put elsewhere -----------------------------------------------------------------------------------

local function playElsewhere(scene)
  local random = scene.random
  local hz = random:pick(scenes.RATES)
  scene:start(hz)
  scene:add("floors", tile(-1000, 300, 2000, 20))
  local slope = random:pick({ false, "topleft", "topright" }) or nil
  local press = put(0, 100, 120, random:pick({ 20, 60 }), { kinematic = true, slope = slope })
  press.vy = 60
  scene:add("presses", press)
  local isRound = random:chance(0.3)
  local thing = isRound and small.ball(60, 290, 10) or put(random:between(20, 80), 276, 14, 24)
  if random:chance(0.3) then
    scene:add("walls", tile(thing.x + thing.width, 200, 10, 100))
    scene:add("walls", tile(thing.x - 10, 200, 10, 100))
  end
  scene:add("things", thing)
  while scene.crushes == 0 and scene.frame < 5 * hz do
    scene:step()
  end
  if scene.crushes == 0 then
    return
  end
  scene:run(random:integer(0, 6))
  press.vy = random:pick({ 0, 60, -60 })
  local where = random:pick({ "far", "far", "press", "beside" })
  local isFree = where ~= "press"
  thing.x, thing.y, thing.vx, thing.vy = press.x + 100 - thing.width, press.y + 4, 0, 0
  if isFree then
    thing.x, thing.y = where == "far" and 400 or 140, where == "far" and 276 or 260
  end
  scene.crushes = 0
  local x = thing.x
  scene:run(hz / 2, function()
    thing.vx = isFree and 60 or thing.vx
  end)
  scene:measure("not free", isFree and math.abs(thing.x - x - 30) - 60 / hz)
  scene:measure("crushed where it is free", isFree and scene.crushes)
  scene:measure(
    "put into the press: not told",
    not isFree and scene.crushes == 0 and overlap.depth(thing, press)
  )
end

return {
  {
    name = "crushes",
    scenes = 400,
    salt = { 37, 11 },
    rows = {
      { "names nothing, or itself", 0 },
      { "names one that is away", 1, "px" },
      { "differs after restore", 0 },
    },
    play = playNames,
  },
  {
    name = "elsewhere",
    scenes = 300,
    salt = { 13, 2 },
    rows = {
      { "not free", 1e-6, "px" },
      { "crushed where it is free", 0 },
      { "put into the press: not told", 0.01, "px" },
    },
    play = playElsewhere,
  },
}
