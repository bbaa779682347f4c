-- Step 1: a box that falls on a floor

local physics = require "physics"
local world, player

function love.load()
  world = physics.newWorld { gravity = 1200, checked = true }
  world:add("tiles", { x = 0, y = 400, width = 800, height = 40, static = true })
  player = world:add("players", { x = 100, y = 100, width = 22, height = 30 })
end

function love.update(dt)
  world:update(dt)
end

function love.draw()
  world:draw()
end
