-- Slopes: hills, a kinematic slope, crates that stand where they are left, and a few stairs.
-- Run with the arrow keys, jump with space. The bar on the head turns with the ground.

local physics = require("physics")

local STEP = 8 -- px, the height of a step

local player, wagon

local function slope(x, y, width, height, side)
  physics.add(
    "hills",
    { x = x, y = y, width = width, height = height, static = true, slope = side }
  )
end

local function block(x, y, width, height)
  physics.add("hills", { x = x, y = y, width = width, height = height, static = true })
end

function love.load()
  physics.load({ gravity = 1000 })
  physics.setBounds(0, 0, 800, 600)
  block(0, 540, 800, 60)
  slope(120, 476, 128, 64, "right")
  block(248, 476, 60, 64)
  slope(308, 476, 64, 64, "left")
  slope(470, 412, 64, 64, "topright")
  for i = 1, 6 do
    block(560 + 16 * i, 540 - STEP * i, 240 - 16 * i, STEP)
  end
  wagon = physics.add("wagons", {
    x = 380,
    y = 508,
    width = 64,
    height = 32,
    kinematic = true,
    slope = "right",
    vx = 40,
  })
  physics.add("crates", { x = 150, y = 440, width = 24, height = 24, friction = 0.5 })
  physics.add("crates", { x = 152, y = 410, width = 20, height = 20, friction = 0.5 })
  player = physics.add("players", { x = 40, y = 500, width = 20, height = 28, nudge = STEP })
end

function love.keypressed(key)
  if key == "space" and player.touching.bottom then
    player.vy = -420
  end
end

function love.update(dt)
  player.vx = 0
  if love.keyboard.isDown("right") then
    player.vx = 200
  elseif love.keyboard.isDown("left") then
    player.vx = -200
  end
  if wagon.x < 376 or wagon.x > 490 then
    wagon.vx = wagon.x < 376 and 40 or -40
  end
  physics.update(dt)
end

function love.draw()
  physics.draw()
  local _, gradient = physics.ground(player)
  local x, y = player.x + player.width / 2, player.y - 10
  love.graphics.line(x - 12, y - 12 * gradient, x + 12, y + 12 * gradient)
  love.graphics.print(("gradient: %g"):format(gradient), 16, 16)
end
