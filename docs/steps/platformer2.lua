-- Step 2: run with the arrow keys, jump with space

local physics = require "physics"
local world, player
local SPEED, JUMP = 220, 520 -- px/s; the jump is 113 px high with gravity 1200

function love.load()
  world = physics.newWorld { gravity = 1200, checked = true }
  world:add("tiles", { x = 0, y = 400, width = 800, height = 40, static = true })
  player = world:add("players", { x = 100, y = 100, width = 22, height = 30 })
end

local function control()
  local isDown = love.keyboard.isDown
  player.vx = (isDown("right") and SPEED or 0) - (isDown("left") and SPEED or 0)
end

function love.keypressed(key)
  if key == "space" and player.touching.bottom then player.vy = -JUMP end
end

function love.update(dt)
  control()
  world:update(dt)
end

function love.draw()
  world:draw()
end
