-- Step 7: gems and a magnet

local physics = require("physics")
local world, player
local SPEED = 160 -- px/s

local function addWalls()
  world:add("walls", { x = 300, y = 0, width = 24, height = 260, static = true })
  world:add("walls", { x = 300, y = 300, width = 24, height = 300, static = true }) -- a 40 px door
end

local function addCrates()
  world:add("crates", { x = 200, y = 100, width = 32, height = 32, drag = 800 })
  world:add("crates", { x = 200, y = 200, width = 32, height = 32, drag = 800, mass = 4 })
end

local function addEnemies()
  for i = 1, 10 do
    world:add("enemies", { x = 500, y = 40 * i, width = 20, height = 20, health = 3 })
  end
end

local function chase(dt)
  for _, enemy in ipairs(world.objects.enemies) do
    enemy.stun = (enemy.stun or 0) - dt
    local toX, toY = player.x - enemy.x, player.y - enemy.y
    local distance = math.max(1, math.sqrt(toX * toX + toY * toY))
    if enemy.stun <= 0 then
      enemy.vx, enemy.vy = 60 * toX / distance, 60 * toY / distance
    end
  end
end

local gems = 0

local function takeGem(gem, other)
  if other == player and world:remove(gem) then
    gems = gems + 1
  end
end

local function dropGem(x, y)
  world:add("gems", {
    x = x,
    y = y,
    width = 8,
    height = 8,
    airFriction = 4,
    sensor = true,
    onBegin = takeGem,
  })
end

local magnet

local function addMagnet()
  magnet = world:add("magnets", {
    x = 0,
    y = 0,
    radius = 120,
    kinematic = true,
    sensor = true,
    hits = { "gems" }, -- it acts on nothing else
    area = { attract = 900 }, -- px/s² towards its centre
  })
end

local HITS = { "enemies", "walls", "crates", "bounds" } -- one list for all bullets
local facingX, facingY = 1, 0

local function hit(bullet, other)
  if world:remove(bullet) and other.health then
    other.health = other.health - 1
    if other.health <= 0 and world:remove(other) then
      dropGem(other.x, other.y)
    end
  end
end

function love.keypressed(key)
  if key == "space" then
    world:add("bullets", {
      x = player.x + 11,
      y = player.y + 11,
      width = 6,
      height = 6,
      vx = 600 * facingX,
      vy = 600 * facingY,
      sensor = true,
      hits = HITS,
      onBegin = hit,
    })
  end
end

local health, safe = 5, 0 -- safe: s, for which a hit does not count

local function hurt(dt)
  safe = safe - dt
  local x, y, w, h = player.x - 2, player.y - 2, player.width + 4, player.height + 4
  local list, count = world:queryRect(x, y, w, h, "enemies")
  if count == 0 or safe > 0 then
    return
  end
  health, safe = health - 1, 1
  for i = 1, count do -- knock-back
    local enemy = list[i]
    enemy.stun = 0.3
    world:impulse(enemy, 5 * (enemy.x - player.x), 5 * (enemy.y - player.y))
  end
end

function love.load()
  world = physics.newWorld({
    gravity = 0,
    checked = true,
    soft = { enemies = { enemies = 300 } }, -- px/s: they drift apart instead of colliding
  })
  world:setBounds(0, 0, 800, 600)
  addWalls()
  addCrates()
  addEnemies()
  addMagnet()
  player = world:add("players", {
    x = 100,
    y = 100,
    width = 28,
    height = 28,
    nudge = 12,
    strength = 1,
    mass = 10, -- a crowd slows it, but does not move it
  })
end

local function control()
  local isDown = love.keyboard.isDown
  local dx = (isDown("right") and 1 or 0) - (isDown("left") and 1 or 0)
  local dy = (isDown("down") and 1 or 0) - (isDown("up") and 1 or 0)
  local length = math.max(1, math.sqrt(dx * dx + dy * dy)) -- not faster on the diagonal
  if dx ~= 0 or dy ~= 0 then
    facingX, facingY = dx / length, dy / length
  end
  player.vx, player.vy = SPEED * dx / length, SPEED * dy / length
end

function love.update(dt)
  control()
  chase(dt)
  magnet.x, magnet.y = player.x + 14 - 120, player.y + 14 - 120
  world:update(dt)
  hurt(dt)
end

function love.draw()
  world:draw()
  love.graphics.print("health: " .. health .. "   gems: " .. gems, 10, 10)
end
