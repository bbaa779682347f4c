--- Crowds as games have them: enemies from all sides press to a player or a point.
---
---     local crowd = crowds.new({ count = 300, seed = 1, goal = "firm", drive = "vx" })
---     crowd:step(1 / 60)
---
--- The player stands and cannot be pushed ("firm"), is pushed and has a mass of 10 ("heavy"), walks
--- round and round ("walker"), or there is none ("point").

local newRandom = require("spec.support.random").new
local small = require("spec.support.small")
local physics = require("physics")

local crowds = {}

local Crowd = {}
Crowd.__index = Crowd

local PULL = 600 -- px/s², of enemies that are driven by `ax`
local CELL = 24 -- px, the grid on which they start
local WALK, SIDE = 100, 240 -- px/s, px: the player's way is a square, midway between the pillars
local PILLAR = 40 -- px

crowds.FASTEST = 90 -- px/s, of an enemy

local function addPillars(self)
  for row = -3, 2 do
    for column = -3, 2 do
      local x, y = SIDE * (column + 0.5) - PILLAR / 2, SIDE * (row + 0.5) - PILLAR / 2
      local pillar = self.world:add("pillars", small.tile(x, y, PILLAR, PILLAR))
      self.objects[#self.objects + 1] = pillar
    end
  end
end

local function isFree(self, x, y, size)
  for _, object in ipairs(self.objects) do
    local isInside = x < object.x + object.width and x + size > object.x
    if isInside and y < object.y + object.height and y + size > object.y then
      return false
    end
  end
  return true
end

local function addEnemy(self, random, x, y, options)
  local size, speed = random:between(14, 20), random:between(60, crowds.FASTEST)
  x, y = x - size / 2, y - size / 2
  if not (options.startsInside or isFree(self, x, y, size)) then
    return
  end
  local enemy = { x = x, y = y, width = size, height = size }
  enemy.radius = options.balls and random:chance(options.balls) and size / 2 or nil
  enemy.maxSpeed = options.drive == "ax" and speed or nil
  self.world:add("enemies", enemy)
  self.speeds[enemy] = speed
  self.enemies[#self.enemies + 1], self.objects[#self.objects + 1] = enemy, enemy
end

-- A place on a square around the middle, `ring` cells away.
local function placeOn(random, ring)
  local side, along = random:integer(0, 3), CELL * random:between(-ring, ring)
  local out = CELL * ring
  if side < 2 then
    return along, side == 0 and -out or out
  end
  return side == 2 and -out or out, along
end

-- From the inside outwards, as many on a square as it has room for, nearly.
local function addEnemies(self, options)
  local random, ring, tries = newRandom(options.seed), options.ring or 5, 0
  while #self.enemies < options.count do
    local x, y = placeOn(random, ring)
    addEnemy(self, random, x, y, options)
    tries = tries + 1
    if tries > 8 * ring then
      ring, tries = ring + 1, 0
    end
  end
end

local function addPlayer(self, goal)
  if goal == "point" then
    return
  end
  local fields = { mass = 10, pushable = goal == "heavy" }
  self.player = self.world:add("players", small.put(-8, -12, 16, 24, fields))
  self.objects[#self.objects + 1] = self.player
end

local function walk(self)
  local side = math.floor(self.time * WALK / SIDE) % 4
  self.player.vx = side == 0 and WALK or side == 2 and -WALK or 0
  self.player.vy = side == 1 and WALK or side == 3 and -WALK or 0
end

-- What a game does before each step.
function Crowd:steer()
  local goalX, goalY = 0, 0
  if self.player then
    goalX, goalY = self.player.x + 8, self.player.y + 12
  end
  if self.goal == "walker" then
    walk(self)
  end
  local nameX, nameY = "vx", "vy"
  if self.drive == "ax" then
    nameX, nameY = "ax", "ay"
  end
  for _, enemy in ipairs(self.enemies) do
    local half = enemy.width / 2
    local dx, dy = goalX - enemy.x - half, goalY - enemy.y - half
    local wanted = self.drive == "ax" and PULL or self.speeds[enemy]
    local share = wanted / (math.sqrt(dx * dx + dy * dy) + 1)
    enemy[nameX], enemy[nameY] = dx * share, dy * share
  end
end

--- Steers everything and updates the world.
function Crowd:step(dt)
  self:steer()
  self.world:update(dt)
  self.time = self.time + dt
end

--- Makes a crowd.
---@param options table count, seed, goal, drive ("vx" or "ax"), settings of the world;
---`balls`: the share of them that are circles;
---`ring`: cells from the middle to the first of them, default 5;
---`startsInside`: many of them start inside others, or in pillars
---@return table crowd `world`, `player`, `enemies`, `objects` (all of them)
function crowds.new(options)
  local self = setmetatable({ world = physics.newWorld({ gravity = 0 }), time = 0 }, Crowd)
  self.goal, self.drive = options.goal, options.drive
  self.objects, self.enemies, self.speeds = {}, {}, {}
  addPlayer(self, options.goal)
  addPillars(self)
  addEnemies(self, options)
  return self
end

return crowds
