-- Step 2: walls and a door

local physics = require "physics"
local world, player
local SPEED = 160 -- px/s

local function addWalls()
  world:add("walls", { x = 300, y = 0, width = 24, height = 260, static = true })
  world:add("walls", { x = 300, y = 300, width = 24, height = 300, static = true }) -- a 40 px door
end

function love.load()
  world = physics.newWorld { gravity = 0, checked = true }
  world:setBounds(0, 0, 800, 600)
  addWalls()
  player = world:add("players", { x = 100, y = 100, width = 28, height = 28, nudge = 12 })
end

local function control()
  local isDown = love.keyboard.isDown
  local dx = (isDown("right") and 1 or 0) - (isDown("left") and 1 or 0)
  local dy = (isDown("down") and 1 or 0) - (isDown("up") and 1 or 0)
  local length = math.max(1, math.sqrt(dx * dx + dy * dy)) -- not faster on the diagonal
  player.vx, player.vy = SPEED * dx / length, SPEED * dy / length
end

function love.update(dt)
  control()
  world:update(dt)
end

function love.draw()
  world:draw()
end
