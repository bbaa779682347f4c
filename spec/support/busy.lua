--- A busy scene that goes on for ever, for scripts/soak.lua and soak_spec.lua: boxes and circles
--- that are kicked about in a room, slopes, lifts and belts, tiles and bullets that come and go, a
--- crowd that is put on one spot and another one of which the members are soft to each other, and
--- some that fall without end. What the game does depends on the number of the step alone.

local physics = require("physics")
local newRandom = require("spec.support.random").new
local small = require("spec.support.small")

local busy = {}

busy.DT = 1 / 60
local ROOM = 600 -- px
local BOXES = 30
local FALLING = 5
local CROWD = 12 -- of each kind
local BRIDGE = 6 -- tiles

-- Adds an object; static unless `fields` say that it is kinematic.
local function put(world, group, x, y, width, height, fields)
  local object = small.put(x, y, width, height, fields)
  object.static = not object.kinematic
  world:add(group, object)
end

local function makeRoom(world)
  for i = 0, ROOM / 20 - 1 do
    put(world, "tiles", 20 * i, ROOM, 20, 20)
  end
  put(world, "walls", -50, -ROOM, 50, 2 * ROOM + 20)
  put(world, "walls", ROOM, -ROOM, 50, 2 * ROOM + 20)
  put(world, "walls", -50, -ROOM - 50, ROOM + 100, 50)
  put(world, "belts", 350, 520, 150, 8, { surfaceSpeed = -80, oneWay = "top" })
  put(world, "lifts", 60, 400, 80, 8, { kinematic = true, vy = 40 })
  put(world, "lifts", 200, 300, 80, 8, { kinematic = true, vx = 60 })
  put(world, "slopes", 0, 350, 60, 30, { slope = "left" })
  put(world, "slopes", ROOM - 60, 400, 60, 60, { slope = "right", friction = 0.4 })
  put(world, "gates", 0, 200, ROOM, 4, { sensor = true })
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
      put(world, "bridge", 220 + 20 * i, 460, 20, 12)
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
