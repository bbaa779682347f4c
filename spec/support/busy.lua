--- A busy scene that goes on for ever, for scripts/soak.lua and soak_spec.lua: boxes and circles
--- that are kicked about in a room, slopes, lifts and belts, tiles and bullets that come and go, a
--- crowd that is put on one spot and another one of which the members are soft to each other, and
--- some that fall without end. What the game does depends on the number of the step alone.

local physics = require("physics")
local newRandom = require("spec.support.random").new

local busy = {}

busy.DT = 1 / 60
local ROOM = 600 -- px
local BOXES = 30
local FALLING = 5
local CROWD = 12 -- of each kind
local BRIDGE = 6 -- tiles

local function makeRoom(world)
  for i = 0, ROOM / 20 - 1 do
    world:add("tiles", { x = 20 * i, y = ROOM, width = 20, height = 20, static = true })
  end
  world:add("walls", { x = -50, y = -ROOM, width = 50, height = 2 * ROOM + 20, static = true })
  world:add("walls", { x = ROOM, y = -ROOM, width = 50, height = 2 * ROOM + 20, static = true })
  world:add("walls", { x = -50, y = -ROOM - 50, width = ROOM + 100, height = 50, static = true })
  world:add("belts", {
    x = 350,
    y = 520,
    width = 150,
    height = 8,
    static = true,
    surfaceSpeed = -80,
    oneWay = "top",
  })
  world:add("lifts", { x = 60, y = 400, width = 80, height = 8, kinematic = true, vy = 40 })
  world:add("lifts", { x = 200, y = 300, width = 80, height = 8, kinematic = true, vx = 60 })
  local hill = { x = 0, y = 350, width = 60, height = 30, static = true, slope = "left" }
  local ramp = { x = ROOM - 60, y = 400, width = 60, height = 60, static = true }
  ramp.slope, ramp.friction = "right", 0.4
  world:add("slopes", hill)
  world:add("slopes", ramp)
  world:add("gates", { x = 0, y = 200, width = ROOM, height = 4, static = true, sensor = true })
end

local function makeBoxes(world)
  local random = newRandom(5)
  for i = 0, BOXES - 1 do
    local width, height = random:between(8, 30), random:between(8, 30)
    local isRound = i % 4 == 0
    world:add("boxes", {
      x = 10 + 50 * (i % 11),
      y = 20 + 40 * math.floor(i / 11),
      width = width,
      height = isRound and width or height,
      radius = isRound and width / 2 or nil,
      friction = random:chance(0.6) and random:between(0, 1) or nil,
      restitution = random:chance(0.3) and random:between(0, 1) or nil,
      mass = random:between(0.2, 5),
    })
  end
  for i = 1, CROWD do
    world:add("mob", { x = 20 * i, y = 150, width = 8, height = 8 })
    local size = random:between(6, 12)
    local swarm = { x = 300 + 12 * i, y = 150, width = size, height = size, gravity = 0 }
    swarm.maxSpeed, swarm.mask = 120, { slopes = false }
    world:add("swarm", swarm)
  end
  for i = 1, FALLING do
    world:add("falling", { x = 1000 + 30 * i, y = 0, width = 10, height = 10, maxSpeed = 400 * i })
  end
end

--- Makes the scene.
---@param settings table?
function busy.new(settings)
  local world = physics.newWorld(settings or { gravity = 900 })
  world.soft = { swarm = { swarm = 200 } }
  makeRoom(world)
  makeBoxes(world)
  return world
end

local function steerLifts(world)
  local up, across = world.objects.lifts[1], world.objects.lifts[2]
  if up.y > 500 or up.y < 250 then
    up.vy = up.y > 500 and -40 or 40
  end
  if across.x > 400 or across.x < 150 then
    across.vx = across.x > 400 and -60 or 60
  end
end

local function shoot(world, n)
  local bullets = world.objects.bullets
  if bullets and #bullets >= 8 then
    world:remove(bullets[1])
  end
  local y = 100 + n * 37 % 450
  world:add("bullets", { x = 2, y = y, width = 4, height = 2, vx = 1500, gravity = 0, mass = 0.1 })
end

-- A bridge in the middle of the room comes and goes, and so does what stands on it.
local function build(world, n)
  if n % 200 == 0 then
    for i = 0, BRIDGE - 1 do
      world:add("bridge", { x = 220 + 20 * i, y = 460, width = 20, height = 12, static = true })
    end
  elseif n % 200 == 120 and world.objects.bridge then
    for i = #world.objects.bridge, 1, -1 do
      world:remove(world.objects.bridge[i])
    end
  end
end

-- The mob is put on one spot now and then; the swarm flies to and fro.
local function drive(world, n)
  local mob, swarm = world.objects.mob, world.objects.swarm
  if n % 300 == 0 then
    local x = 150 + n * 7 % 300
    for i = 1, CROWD do
      mob[i].x, mob[i].y, mob[i].vx, mob[i].vy = x, 150, 0, 0
    end
  end
  local goal = n % 800 < 400 and 100 or 500
  for i = 1, CROWD do
    swarm[i].ax, swarm[i].ay = 2 * (goal - swarm[i].x), 2 * (250 - swarm[i].y)
  end
end

--- Makes step number n.
function busy.step(world, n)
  steerLifts(world)
  build(world, n)
  drive(world, n)
  if n % 20 == 0 then
    shoot(world, n)
  end
  if n % 15 == 0 then
    local box = world.objects.boxes[n * 31 % BOXES + 1]
    box.vx, box.vy = (n * 17 % 41 - 20) * 20, -(n * 13 % 40) * 15
  end
  world:update(busy.DT)
end

--- Returns the memory in use, kB; compiled code, which comes and goes, is thrown away before.
function busy.memory()
  local jit = rawget(_G, "jit")
  if jit then
    jit.flush()
  end
  collectgarbage()
  collectgarbage()
  return collectgarbage("count")
end

--- Returns what is wrong with the scene, or nil: an object has left the room or has a coordinate
--- that is not a number.
function busy.complaint(world)
  for _, name in ipairs({ "boxes", "mob", "swarm", "bullets", "falling" }) do
    for i, object in ipairs(world.objects[name] or {}) do
      local x, y = object.x, object.y
      local isFinite = x - x == 0 and y - y == 0 and object.vx - object.vx == 0
      local isIn = x > -1 and x + object.width < ROOM + 1 and y > -ROOM - 1 and y < ROOM + 1
      if not isFinite or (name ~= "falling" and not isIn) then
        return ("%s[%d] is at %.17g, %.17g"):format(name, i, x, y)
      end
    end
  end
  local count = { boxes = BOXES, falling = FALLING, mob = CROWD, swarm = CROWD }
  for name, number in pairs(count) do
    if #world.objects[name] ~= number then
      return "an object of " .. name .. " is lost"
    end
  end
end

return busy
