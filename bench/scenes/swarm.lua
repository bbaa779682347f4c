--- Enemies from all sides press to a player, among pillars: what games of survival do for minutes.
--- The game steers each in every frame, by its velocity or by an acceleration up to a speed.
---
---    @  @ @  @  @ @ @
---   @  #   @  @   #  @
---    @   > @P@ <   @
---   @  # @  @  @  #  @
---    @ @  @  @ @  @

local newRandom = require("spec.support.random").new

local CELL = 24 -- px, the grid on which the enemies start
local PILLAR, BETWEEN, SIDES = 40, 240, 6 -- px, px from one to the next, pillars in a row
local START = 180 -- px from the player to the nearest enemy
local PULL = 600 -- px/s², of enemies that accelerate
local WALK = 100 -- px/s, of a player that walks along a square, midway between pillars

local function addPillars(objects)
  local first = -(SIDES - 1) / 2 * BETWEEN - PILLAR / 2
  for row = 0, SIDES - 1 do
    for column = 0, SIDES - 1 do
      objects[#objects + 1] = {
        group = "pillars",
        x = first + BETWEEN * column,
        y = first + BETWEEN * row,
        width = PILLAR,
        height = PILLAR,
        static = true,
      }
    end
  end
end

-- Whether a cell of the grid is free of pillars.
local function isFree(x, y)
  local half = BETWEEN * SIDES / 2
  local function toPillar(at)
    local inside = at + half
    return math.abs(inside - BETWEEN * math.floor(inside / BETWEEN) - BETWEEN / 2)
  end
  local reach = (PILLAR + CELL) / 2
  local isNear = toPillar(x) < reach and toPillar(y) < reach
  return not (isNear and math.abs(x) < half and math.abs(y) < half)
end

local function addEnemy(objects, random, x, y, isRound)
  local size = random:between(14, 20)
  objects[#objects + 1] = {
    group = "enemies",
    x = x - size / 2,
    y = y - size / 2,
    width = size,
    height = size,
    radius = isRound and size / 2 or nil,
    mass = 1,
    speed = random:between(60, 90),
  }
end

-- Squares of cells around the player, from the inside outwards.
local function addEnemies(objects, count, isRound)
  local random, last = newRandom(21), #objects + count
  local ring = math.ceil(START / CELL)
  while #objects < last do
    for k = 0, 8 * ring - 1 do
      local side, along = math.floor(k / (2 * ring)), CELL * (k % (2 * ring) - ring)
      local out = CELL * ring
      local x = side == 0 and along or side == 1 and out or side == 2 and -along or -out
      local y = side == 0 and -out or side == 1 and along or side == 2 and out or -along
      if #objects < last and isFree(x, y) then
        addEnemy(objects, random, x, y, isRound)
      end
    end
    ring = ring + 1
  end
end

-- The way of a player that walks round and round along a square, clear of the pillars.
local function velocityAt(step)
  local side = math.floor(step * WALK / 60 / BETWEEN) % 4
  local vx = side == 0 and WALK or side == 2 and -WALK or 0
  local vy = side == 1 and WALK or side == 3 and -WALK or 0
  return vx, vy
end

-- The first is the player, then come the pillars, then the enemies.
local function newObjects(count, options)
  local objects = {
    {
      group = "players",
      x = -8,
      y = -12,
      width = 16,
      height = 24,
      mass = 10,
      pushable = options.isPushable,
    },
  }
  addPillars(objects)
  local first = #objects + 1
  addEnemies(objects, count, options.isRound)
  if options.isPulled then
    for i = first, #objects do
      objects[i].maxSpeed = objects[i].speed
    end
  end
  return objects, first
end

-- Lets the i-th object go to a place.
local function steer(world, i, goalX, goalY, speed, isPulled)
  local x, y = world:read(i)
  local dx, dy = goalX - x, goalY - y
  local distance = math.sqrt(dx * dx + dy * dy) + 1
  if isPulled then
    world:accelerate(i, dx / distance * PULL, dy / distance * PULL)
  else
    world:setVelocity(i, dx / distance * speed, dy / distance * speed)
  end
end

local function needsOf(options)
  local needs = { "upright", "crowds" }
  needs[#needs + 1] = options.isPulled and "accelerations" or nil
  needs[#needs + 1] = options.isRound and "circles" or nil
  return needs
end

local function build(count, options)
  local objects, first = newObjects(count, options)
  local speeds = {}
  for i = first, #objects do
    speeds[i] = objects[i].speed
    objects[i].speed = nil
  end
  local function frame(world, step)
    if options.isWalking then
      world:setVelocity(1, velocityAt(step))
    end
    local goalX, goalY = world:read(1)
    for i = first, #objects do
      steer(world, i, goalX, goalY, speeds[i], options.isPulled)
    end
    world:step(1 / 60)
  end
  local isStill = not options.isWalking and options.isPushable == false
  return {
    gravity = 0,
    objects = objects,
    hasMasses = true,
    still = isStill and 1 or nil,
    soft = options.soft,
    needs = needsOf(options),
    warmUp = 120,
    steps = 600,
    frame = frame,
  }
end

local SIZES = { 100, 300, 600, 1000 }

local function definition(name, title, options)
  return {
    name = name,
    title = title,
    sizes = SIZES,
    quick = 20,
    build = function(count)
      return build(count, options)
    end,
  }
end

local STANDS = { isPushable = false }
local GIVES_WAY = {}
local SOFT = { enemies = { enemies = 400 } } -- px/s
local SOFT_STANDS = { isPushable = false, soft = SOFT }
local SOFT_WALKS = { isPushable = false, isWalking = true, soft = SOFT }
local WALKS = { isPushable = false, isWalking = true }

local function pulled(options)
  return {
    isPushable = options.isPushable,
    isWalking = options.isWalking,
    isPulled = true,
  }
end

return {
  definition("swarm", "n enemies press to a player that stands, by vx", STANDS),
  definition("swarm-ax", "the same by ax and maxSpeed", pulled(STANDS)),
  definition("swarm-round", "n round enemies, by vx", { isPushable = false, isRound = true }),
  definition("swarm-heavy", "they push it, of mass 10, by vx", GIVES_WAY),
  definition("swarm-heavy-ax", "the same by ax and maxSpeed", pulled(GIVES_WAY)),
  definition("swarm-kite", "they follow one that walks, by vx", WALKS),
  definition("swarm-kite-ax", "the same by ax and maxSpeed", pulled(WALKS)),
  definition("swarm-soft", "n enemies, soft to each other, press to a player", SOFT_STANDS),
  definition("swarm-soft-kite", "they follow one that walks", SOFT_WALKS),
}
