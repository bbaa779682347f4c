--- A yard of boxes and balls at random: a crowd far away changes no bit of what comes.

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
