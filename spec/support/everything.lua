--- One scene with everything in it, for the specs of states and of determinism. What the game
--- writes depends on the number of the step and on what stands in the world's tables alone, so any
--- step can be played again. Run as a file it prints the fold of the whole run, see
--- determinism_spec.lua.

local physics = require("physics")
local newRandom = require("spec.support.random").new
local small = require("spec.support.small")

local everything = {}

everything.STEPS = 120
local RATES = { 1 / 60, 1 / 60, 1 / 144, 1 / 30, 1 / 60, 0.05 }
local ROOM = 480

-- Group, place and size; other fields. What is not kinematic or pressed is static.
local LEVEL = {
  { "walls", -16, -100, 16, ROOM + 116 },
  { "walls", ROOM, -100, 16, ROOM + 116 },
  { "walls", 300, 330, 60, 10 },
  { "shelves", 40, 380, 80, 6, { oneWay = "top" } },
  { "shelves", 150, 340, 60, 6, { oneWay = "top" } },
  { "shelves", 230, 380, 6, 60, { oneWay = "left" } },
  { "belts", 360, 440, 90, 8, { surfaceSpeed = -60 } },
  { "coins", 200, 420, 10, 10, { sensor = true } },
  { "coins", 0, 300, ROOM, 1, { sensor = true } },
  { "lifts", 130, 440, 60, 8, { kinematic = true, vx = 50 } },
  { "lifts", 300, 440, 50, 8, { kinematic = true, vy = -40 } },
  { "lifts", 20, 430, 50, 8, { kinematic = true, carry = false, vx = 30 } },
  { "lifts", 240, 300, 40, 8, { kinematic = true } },
  -- A press: it lifts a box against a ceiling.
  { "lifts", 400, 330, 40, 8, { kinematic = true, vy = -60 } },
  { "walls", 395, 260, 50, 10 },
  { "pressed", 405, 310, 14, 14 },
}

local function makeLevel(world)
  for i = 0, 29 do
    local tile = { x = 16 * i, y = ROOM, width = 16, height = 16, static = true }
    tile.friction = i % 3 == 0 and 0.5 or nil
    world:add("tiles", tile)
  end
  for _, row in ipairs(LEVEL) do
    local object = small.put(row[2], row[3], row[4], row[5], row[6])
    object.static = not object.kinematic and row[1] ~= "pressed" or nil
    world:add(row[1], object)
  end
end

-- Fields of every nth box from one on: between two numbers, one of a list, or a value.
local FIELDS = {
  { "friction", 2, 0, 0.1, 1 },
  { "restitution", 3, 0, { 0.3, 0.6, 1 } },
  { "mass", 4, 0, 0.5, 6 },
  { "airFriction", 5, 0, 0, 2 },
  { "drag", 6, 0, 0, 60 },
  { "maxSpeed", 7, 0, 250 },
  { "maxSpeedX", 8, 1, 90 },
  { "maxSpeedY", 8, 1, 300 },
  { "snap", 8, 5, 6 },
  { "maxFallSpeed", 8, 5, 200 },
  { "gravity", 9, 1, { -50, 0, 1200 } },
  { "gravityX", 10, 2, 100 },
  { "ax", 11, 3, 40 },
  { "ay", 11, 3, -20 },
  { "pushable", 11, 5, false },
  { "mask", 30, 7, { coins = false, lifts = false } },
  { "sensor", 30, 9, true },
}

local function makeBoxes(world)
  local random = newRandom(7)
  for i = 0, 29 do
    local x, y = 20 + 44 * (i % 10) + random:between(0, 8), 60 + 40 * (i - i % 10) / 10
    local box = small.put(x, y + random:between(0, 8), random:between(8, 24), random:between(8, 24))
    box.vx = random:between(-80, 80)
    for _, row in ipairs(FIELDS) do
      local value = row[4]
      if i % row[2] == row[3] and (row[1] ~= "pushable" or i < 20) then
        if row[5] then
          value = random:between(value, row[5])
        elseif type(value) == "table" and value[1] then
          value = random:pick(value)
        end
        box[row[1]] = value
      end
    end
    world:add(i % 2 == 0 and "boxes" or "crates", box)
  end
end

-- A bullet that hits something solid is gone, and leaves a spark; a coin counts.
local function onBegin(world)
  return function(a, b)
    local objects = world.objects
    for _, pair in ipairs({ { a, b }, { b, a } }) do
      local bullet, other = pair[1], pair[2]
      if bullet.width == 4 and bullet.height == 2 then
        if not other.sensor and world:remove(bullet) then
          world:add("sparks", { x = bullet.x, y = bullet.y, width = 3, height = 3, vy = -90 })
        end
      end
    end
    if a == objects.player or b == objects.player then
      objects.player.mass = 3 - objects.player.mass
    end
  end
end

-- A crushed object gets thinner.
local function onCrush(object, _, _, axis)
  local side = axis == "x" and "width" or "height"
  object[side] = math.max(4, object[side] - 2)
end

local function canCollide(a, b)
  return not (a.width == 3 and b.width == 10)
end

-- The world with all that answers, and nothing in it.
function everything.newWorld(settings)
  local all = {
    gravity = 700,
    masks = { sparks = { sparks = false, bullets = false } },
    order = { "walls", "player" },
  }
  local world = physics.newWorld(small.set(all, settings))
  world.onBegin, world.onCrush = onBegin(world), onCrush
  return world
end

--- A world with the scene.
function everything.new(settings)
  local world = everything.newWorld(settings)
  makeLevel(world)
  makeBoxes(world)
  world.objects.player =
    { x = 60, y = 300, width = 14, height = 22, friction = 0.3, mass = 1, nudge = 4 }
  return world
end

-- Between which places which lift goes to and fro, and how fast.
local WAYS = {
  { 1, "x", 100, 220, 50 },
  { 2, "y", 345, 450, 40 },
  { 3, "x", 5, 90, 30 },
  { 5, "y", 276, 330, 60 },
}

local function steerLifts(objects, n)
  for _, row in ipairs(WAYS) do
    local lift, axis, speed = objects.lifts[row[1]], row[2], row[5]
    if lift[axis] > row[4] then
      lift["v" .. axis] = -speed
    elseif lift[axis] < row[3] then
      lift["v" .. axis] = speed
    end
  end
  objects.lifts[4].x = 240 + (n % 40 < 20 and n % 20 or 20 - n % 20) * 3
end

local function steerPlayer(world, player, n, input)
  local held = (n * 7 + input) % 60
  player.vx = held < 25 and 140 or held < 45 and -120 or player.vx
  local touching = player.touching
  if touching and touching.bottom and n % 23 == input % 23 then
    player.vy = -320
  end
  if touching and touching.bottom and n % 31 == 5 then
    world:dropThrough(player)
  end
  if n % 50 == 40 then
    player.x, player.y = 60 + 5 * (n % 7), 250
  end
end

local function disturb(world, n)
  local objects = world.objects
  local boxes, crates = objects.boxes, objects.crates
  if n % 9 == 3 then
    world:add("bullets", { x = 10, y = 200 + n, width = 4, height = 2, vx = 2500, gravity = 0 })
  end
  if n % 17 == 4 and #boxes > 4 then
    table.remove(boxes, n % #boxes + 1)
  end
  if n % 13 == 2 then
    table.insert(boxes, { x = 30 + n, y = 10, width = 12, height = 12 + n % 5 })
  end
  if n % 19 == 6 then
    crates[n % #crates + 1].width = 8 + n % 14
  end
  if n % 21 == 7 then
    crates[n % 3 + 1].active = crates[n % 3 + 1].active == false
  end
  if n % 27 == 8 then
    world:impulse(crates[n % #crates + 1], 60, -200)
  end
  if n % 37 == 9 then
    world.gravity = 1300 - world.gravity
  end
  if n % 41 == 10 then
    world:move(crates[4], crates[4].x + 20, crates[4].y - 10)
  end
  if n % 43 == 11 then
    crates[5].mask = n % 2 == 0 and { boxes = false } or nil
  end
  if n % 57 == 12 then
    world.masks.sparks.boxes = n % 2 == 0 and true or false
  end
end

--- Writes what the game writes before step number n; `input` (integer, default 0) is what the
--- player does.
function everything.write(world, n, input)
  -- Not always, because the step has a shorter way without `canCollide`.
  world.canCollide = n % 5 < 2 and canCollide or nil
  if n % 40 == 15 then
    world:setBounds(0, -100 - n, ROOM + n, ROOM + 100 + n)
  end
  steerLifts(world.objects, n)
  steerPlayer(world, world.objects.player, n, input or 0)
  disturb(world, n)
end

--- Makes step number n.
function everything.step(world, n, input)
  everything.write(world, n, input)
  world:update(RATES[n % #RATES + 1])
end

--- The length of step number n, s.
function everything.dt(n)
  return RATES[n % #RATES + 1]
end

--- Plays the scene to its end and folds the hashes of all steps into one number.
---@param world table? a filled world
---@param between function? called before every step
function everything.fold(world, between)
  world = world or everything.new()
  local sum = 0.0
  for n = 1, everything.STEPS do
    if between then
      between(world, n)
    end
    everything.step(world, n)
    sum = sum * 31 + world:hash()
    sum = sum - math.floor(sum / 99999999999973) * 99999999999973
  end
  return ("%.0f"):format(sum)
end

if arg and arg[0] and arg[0]:find("everything%.lua$") then
  io.write(everything.fold(), "\n")
end

return everything
