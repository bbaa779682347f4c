-- Step 5: bullets, with space

local physics = require "physics"
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

local function chase()
  for _, enemy in ipairs(world.objects.enemies) do
    local toX, toY = player.x - enemy.x, player.y - enemy.y
    local distance = math.max(1, math.sqrt(toX * toX + toY * toY))
    enemy.vx, enemy.vy = 60 * toX / distance, 60 * toY / distance
  end
end

local HITS = { "enemies", "walls", "crates", "bounds" } -- one list for all bullets
local facingX, facingY = 1, 0

local function hit(bullet, other)
  if world:remove(bullet) and other.health then
    other.health = other.health - 1
    if other.health <= 0 then world:remove(other) end
  end
end

function love.keypressed(key)
  if key == "space" then
    world:add("bullets", {
      x = player.x + 11, y = player.y + 11, width = 6, height = 6,
      vx = 600 * facingX, vy = 600 * facingY, sensor = true, hits = HITS, onBegin = hit,
    })
  end
end

function love.load()
  world = physics.newWorld {
    gravity = 0, checked = true,
    soft = { enemies = { enemies = 300 } }, -- px/s: they drift apart instead of colliding
  }
  world:setBounds(0, 0, 800, 600)
  addWalls()
  addCrates()
  addEnemies()
  player = world:add("players", {
    x = 100, y = 100, width = 28, height = 28,
    nudge = 12, strength = 1, mass = 10, -- a crowd slows it, but does not move it
  })
end

local function control()
  local isDown = love.keyboard.isDown
  local dx = (isDown("right") and 1 or 0) - (isDown("left") and 1 or 0)
  local dy = (isDown("down") and 1 or 0) - (isDown("up") and 1 or 0)
  local length = math.max(1, math.sqrt(dx * dx + dy * dy)) -- not faster on the diagonal
  if dx ~= 0 or dy ~= 0 then facingX, facingY = dx / length, dy / length end
  player.vx, player.vy = SPEED * dx / length, SPEED * dy / length
end

function love.update(dt)
  control()
  chase()
  world:update(dt)
end

function love.draw()
  world:draw()
end
