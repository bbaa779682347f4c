--- Rooms of boxes and balls at random, which walk into each other, beside a door that moves. What a
--- world knows of its past beyond the state (fat boxes, which bodies sleep, what held them once)
--- changes no bit of what comes. Nor does a crowd far away.

local newRandom = require("spec.support.random").new
local physics = require("physics")
local small = require("spec.support.small")

local DT = 1 / 60

-- A box, or a ball of its width.
local function thing(random, x, y, width, fields)
  fields.x, fields.y, fields.width, fields.height = x, y, width, random:between(6, 18)
  if random:chance(0.45) then
    fields.width, fields.height, fields.radius = nil, nil, width / 2
  end
  return fields
end

-- Returns a world, and whether what is in it is driven to a place, in each step.
local function newRoom(seed, settings)
  local random, world = newRandom(seed), physics.newWorld(settings)
  local size = random:between(80, 200)
  local function put(group, width, fields)
    local x, y = random:between(0, size - width), random:between(0, size - width)
    world:add(group, thing(random, x, y, width, fields))
  end
  world:setBounds(0, 0, size, size)
  for _ = 1, random:integer(0, 3) do
    put("stones", random:between(8, 30), { static = random:chance(0.7), pushable = false })
  end
  for _ = 1, random:chance(0.4) and 1 or 0 do
    local x, y = random:between(0, size - 30), random:between(0, size - 30)
    local slope = random:pick({ "left", "right" })
    world:add("slopes", { x = x, y = y, width = 30, height = 20, static = true, slope = slope })
  end
  for _ = 1, random:integer(3, 15) do
    local fields = { vx = random:between(-80, 80), vy = random:between(-80, 80) }
    fields.mass = random:chance(0.3) and random:between(0.2, 8) or nil
    fields.strength = random:chance(0.3) and random:between(1, 6) or nil
    fields.restitution = random:chance(0.2) and 1 or nil
    fields.friction = random:chance(0.3) and random:between(0, 1) or nil
    fields.maxSpeed = random:chance(0.2) and random:between(40, 120) or nil
    put("mobs", random:between(6, 18), fields)
  end
  if random:chance(0.3) then
    put("doors", 20, { kinematic = true, vx = random:between(-40, 40), vy = 30 })
  end
  return world, random:chance(0.5)
end

-- What the game does before step n: from places alone, so that a copy does the same.
local function drive(world, n, isDriven)
  local x, y = 50 + 40 * (n * 37 % 11) / 11, 50 + 40 * (n * 53 % 13) / 13
  for _, mob in ipairs(isDriven and world.objects.mobs or {}) do
    local way, height = x - mob.x, y - mob.y
    local length = math.sqrt(way * way + height * height) + 1
    mob.vx, mob.vy = way / length * 60, height / length * 60
  end
  for _, door in ipairs(world.objects.doors or {}) do
    if door.x < 0 or door.x > 80 then
      door.vx = door.x < 0 and 30 or -30
    end
    if door.y < 0 or door.y > 80 then
      door.vy = door.y < 0 and 30 or -30
    end
  end
end

-- Plays steps first to last, of which the first may have been driven already.
local function play(world, first, last, isDriven, hasBegun)
  for n = first, last do
    if not (hasBegun and n == first) then
      drive(world, n, isDriven)
    end
    world:update(DT)
  end
  return world:hash()
end

-- Expects the same hash of a room that is saved before a step, and of a copy that is restored; of
-- others, too, that are played from the beginning.
local function check(seed, gravity, others)
  local world, isDriven = newRoom(seed, { gravity = gravity })
  local at, hasBegun = 20 + seed % 97, seed % 2 == 0
  play(world, 1, at - 1, isDriven)
  if hasBegun then
    drive(world, at, isDriven)
  end
  local copy = physics.newWorld()
  copy:restore(world:save())
  local hash, last = play(world, at, at + 60, isDriven, hasBegun), at + 60
  assert.are.equal(hash, play(copy, at, last, isDriven, hasBegun), seed)
  for _, settings in ipairs(others) do
    settings.gravity = gravity
    assert.are.equal(hash, play(newRoom(seed, settings), 1, last, isDriven), seed)
  end
end

describe("world:restore of boxes and balls in a room", function()
  -- In the first two something is held that was held by something else before; in the last one a
  -- ball is pushed to what only one of two worlds had looked up.
  small.rows("gives the same bits: room {1}", { 145, 353, 824 }, function(seed)
    check(seed, 0, {})
  end)

  small.rows("gives the same bits, as do pairs: gravity {1} #slow", { 0, 600 }, function(gravity)
    for seed = 1, 40 do
      check(seed, gravity, { { broadphase = "pairs" }, { rest = false } })
    end
  end)
end)

-- A yard with a ram, crates and balls on a belt, and `far`, 40 boxes and balls that bounce in a
-- room 20 000 px away. Returns the places in the yard after each step.
local function playYard(seed, far)
  local random, world = newRandom(seed), physics.newWorld({ gravity = 900 })
  local function wall(x, y, width, height, fields)
    fields = fields or { static = true }
    fields.x, fields.y, fields.width, fields.height = x, y, width, height
    return world:add("walls", fields)
  end
  wall(0, 300, 400, 40, { static = true, surfaceSpeed = random:chance(0.5) and 40 or nil })
  wall(-20, 0, 20, 340)
  wall(400, 0, 20, 340)
  local ram, things, places = wall(20, 270, 40, 20, { kinematic = true, vx = 50 }), {}, {}
  for n = 1, 16 do
    local x, y, width = 70 + n % 8 * 40, 40 + n * 12, random:between(10, 24)
    local fields = { friction = random:pick({ 0, 0.4, 0.8 }), mass = random:integer(1, 3) }
    things[n] = world:add("things", thing(random, x, y, width, fields))
  end
  if far then
    wall(19980, -20, 340, 20)
    wall(19980, 300, 340, 20)
    wall(19980, 0, 20, 300)
    wall(20300, 0, 20, 300)
  end
  for n = 1, far and 40 or 0 do
    local fields = { vx = random:between(-300, 300), vy = random:between(-300, 300) }
    fields.restitution = 0.9
    world:add("zealots", thing(random, 20010 + n % 8 * 30, 10 + n * 6, 12, fields))
  end
  for _ = 1, 200 do
    ram.vx = ram.x < 10 and 50 or ram.x > 200 and -50 or ram.vx
    world:update(DT)
    for _, one in ipairs(things) do
      places[#places + 1], places[#places + 2] = one.x, one.y
    end
  end
  return places
end

small.rows("update: a crowd 20 000 px away changes no bit: {1}", { 3, 5, 9, 14 }, function(seed)
  assert.same(playYard(seed, false), playYard(seed, true))
end)
