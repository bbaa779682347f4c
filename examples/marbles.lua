-- A marble run. Marbles are circles: they roll down slopes, jump off their ends, and bounce off
-- round bumpers and pegs. Small platforms bring them up again. Drop some, or tilt the board.

local art = require("marbles_art")
local physics = require("physics")
local sparks = require("sparks")

local marbles = {
  keys = { { "click", "drop one" }, { "up", "down", "more, fewer" }, { "space", "tilt" } },
}

local FIRST, MOST, RADIUS = 24, 120, 8 -- marbles; px
local EVERY = 0.7 -- s between two that are dropped from the top
local KICK, TILT = 260, 220 -- px/s, of a bumper, of the board
local COLORS = { "red", "orange", "yellow", "lime", "green", "cyan", "sky", "blue", "white" }

-- The shaft of the lift: its left and right inside, where its opening at the top and at the floor
-- are, and where its platforms begin and end, px; px/s.
local LIFT = { left = 914, right = 932, exit = 62, door = 548, low = 660, high = 20, speed = 130 }
local PLATFORM, APART = 8, 66 -- px, thickness, and from one to the next

-- Slopes: x, y, width, height, high side. What is below them is solid, down to `base` px more.
local RAMPS = {
  { 660, 84, 254, 58, "right" },
  { 560, 142, 100, 10, "right" },
  { 40, 268, 190, 60, "left" },
  { 230, 328, 170, 22, "left" },
  { 740, 372, 150, 56, "right" },
  { 620, 428, 120, 18, "right" },
  { 40, 482, 300, 40, "left" },
  { 340, 522, 454, 36, "left" },
  { 794, 558, 120, 30, "left" },
}
local BASE = 12 -- px, the thickness of a ramp below its slope
local BUMPERS = { { 130, 176, 22 }, { 246, 128, 18 }, { 322, 222, 20 }, { 452, 216, 16 } }
local PEGS = { x = 436, y = 350, columns = 5, rows = 4, apart = 40, radius = 5 }

local world, state, random ---@type physics.World, table, any

local function addStatic(group, x, y, width, height, fields)
  local object = fields or {}
  object.x, object.y, object.width, object.height, object.static = x, y, width, height, true
  return world:add(group, object)
end

local function addRamps()
  for _, ramp in ipairs(RAMPS) do
    local x, y, width, height, high = ramp[1], ramp[2], ramp[3], ramp[4], ramp[5]
    addStatic("ramps", x, y, width, height, { slope = high })
    addStatic("ramps", x, y + height, width, BASE)
  end
end

-- A bumper throws back what touches it, and lights up. The normal leads from the marble to it.
local function bump(bumper, marble, _, _, _, _, _, _, nx, ny)
  marble.vx, marble.vy = marble.vx - nx * KICK, marble.vy - ny * KICK
  bumper.light, state.bumps = 1, state.bumps + 1
  sparks.burst(marble, 6)
end

local function addRound(group, x, y, radius, fields)
  fields.x, fields.y, fields.radius, fields.static = x - radius, y - radius, radius, true
  world:add(group, fields)
end

local function addBumpers()
  for _, bumper in ipairs(BUMPERS) do
    addRound("bumpers", bumper[1], bumper[2], bumper[3], { onBegin = bump, light = 0 })
  end
  for row = 0, PEGS.rows - 1 do
    for column = 0, PEGS.columns - 1 - row % 2 do
      local x = PEGS.x + (column + row % 2 / 2) * PEGS.apart
      addRound("pegs", x, PEGS.y + row * 32, PEGS.radius, { restitution = 0.5 })
    end
  end
end

-- The platforms of the lift are not stopped by the slope above them, which leads the marbles out.
local function addLift()
  local width, height = LIFT.right - LIFT.left, LIFT.low - LIFT.high
  addStatic("walls", LIFT.left - 6, LIFT.exit + 34, 6, LIFT.door - LIFT.exit - 34)
  addStatic("walls", LIFT.right, 0, 28, 640)
  addStatic("ramps", LIFT.left - 22, LIFT.exit - 46, 40, 40, { slope = "topright" })
  for n = 0, math.floor(height / APART) - 1 do
    local platform = { x = LIFT.left, y = LIFT.low - n * APART, width = width, height = PLATFORM }
    platform.kinematic, platform.vy = true, -LIFT.speed
    world:add("lifts", platform)
  end
end

local function addMarble(x, y)
  return world:add("marbles", {
    x = x - RADIUS,
    y = y - RADIUS,
    radius = RADIUS,
    restitution = 0.25,
    color = COLORS[random:random(#COLORS)],
    angle = random:random() * 6,
  })
end

local function remove()
  table.remove(world.objects.marbles)
end

function marbles.load()
  random = love.math.newRandomGenerator(3)
  world = physics.newWorld({ gravity = 700 })
  marbles.world = world
  state = { waiting = FIRST, untilNext = 0, bumps = 0, laps = 0 }
  sparks.clear()
  addStatic("walls", 0, 0, 40, 640)
  addStatic("walls", 40, 600, 874, 40)
  addRamps()
  addBumpers()
  addLift()
  world.objects.marbles = {}
  art.load()
end

-- A platform that has come to the top begins again at the bottom: for that it is taken out.
local function moveLift()
  for _, platform in ipairs(world.objects.lifts) do
    platform.active = true
    if platform.y < LIFT.high then
      platform.active, platform.y = false, platform.y + #world.objects.lifts * APART
    end
  end
end

local function drop(dt)
  state.untilNext = state.untilNext - dt
  if state.waiting > 0 and state.untilNext <= 0 then
    state.waiting, state.untilNext = state.waiting - 1, EVERY
    addMarble(860 + random:random(0, 30), 60)
  end
end

-- A marble rolls by its way along the ground.
local function roll(marble, dt)
  local isUp = marble.y < LIFT.exit + 20 and marble.x > LIFT.left - 30
  if isUp and not marble.isUp then
    state.laps = state.laps + 1
  end
  marble.isUp = isUp
  marble.angle = marble.angle + marble.vx / RADIUS * dt
end

function marbles.update(dt)
  moveLift()
  drop(dt)
  world:update(dt)
  for _, marble in ipairs(world.objects.marbles) do
    roll(marble, dt)
  end
  art.update(world, dt)
end

function marbles.keypressed(key, isRepeat)
  if key == "up" and #world.objects.marbles + state.waiting < MOST then
    addMarble(700 + random:random(0, 180), 40)
  elseif key == "down" and #world.objects.marbles > 0 then
    remove()
  elseif key == "space" and not isRepeat then
    for _, marble in ipairs(world.objects.marbles) do
      marble.vx = marble.vx + random:random(-TILT, TILT)
      marble.vy = marble.vy - random:random(TILT / 2, TILT)
    end
  end
end

function marbles.mousepressed(x, y)
  local left, top = x - RADIUS, y - RADIUS
  local _, count = world:queryRect(left, top, 2 * RADIUS, 2 * RADIUS)
  if count == 0 and #world.objects.marbles < MOST then
    addMarble(x, y)
  end
end

function marbles.draw()
  art.draw(world)
end

function marbles.report()
  local inside = 0
  for _, marble in ipairs(world.objects.marbles) do
    if marble.x > 30 and marble.x < LIFT.right and marble.y > -400 and marble.y < 640 then
      inside = inside + 1
    end
  end
  local result = "marbles: marbles=%d inside=%d laps=%d bumps=%d"
  return result:format(#world.objects.marbles, inside, state.laps, state.bumps)
end

return marbles
