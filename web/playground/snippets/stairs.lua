-- Stairs: with nudge, a player that runs against a step of at most that height goes up.
-- Run with the arrow keys, jump with space. Set nudge to 0 and try again.

local physics = require("physics")

local STEP = 8 -- px, the height of a step

local player

function love.load()
  physics.load({ gravity = 1000 })
  physics.setBounds(0, 0, 800, 600)
  physics.add("floors", { x = 0, y = 540, width = 800, height = 60, static = true })
  for i = 1, 12 do
    physics.add("steps", {
      x = 160 + 16 * i,
      y = 540 - STEP * i,
      width = 460 - 32 * i,
      height = STEP,
      static = true,
    })
  end
  physics.add("crates", { x = 640, y = 480, width = 40, height = 40, friction = 0.5 })
  player = physics.add("players", { x = 40, y = 500, width = 24, height = 32, nudge = STEP })
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
  physics.update(dt)
end

function love.draw()
  physics.draw()
  love.graphics.print(("nudge: %d px, a step: %d px"):format(player.nudge, STEP), 16, 16)
end
