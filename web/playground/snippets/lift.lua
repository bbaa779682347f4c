-- Lift: what stands on a lift or a belt rides along. Move with the arrow keys, jump with space.

local physics = require("physics")

local lift, ferry, player

function love.load()
  physics.load({ gravity = 900 })
  physics.setBounds(0, 0, 800, 600)
  physics.add("floors", { x = 0, y = 560, width = 800, height = 40, static = true })
  physics.add("floors", { x = 600, y = 240, width = 200, height = 16, static = true })
  physics.add(
    "belts",
    { x = 300, y = 500, width = 200, height = 16, static = true, surfaceSpeed = 80 }
  )

  lift =
    physics.add("lifts", { x = 60, y = 540, width = 120, height = 16, kinematic = true, vy = -90 })
  ferry =
    physics.add("lifts", { x = 200, y = 220, width = 120, height = 16, kinematic = true, vx = 110 })

  for i = 0, 2 do
    physics.add(
      "crates",
      { x = 70 + 8 * i, y = 500 - 32 * i, width = 28, height = 28, friction = 0.6 }
    )
    physics.add("crates", { x = 310 + 36 * i, y = 460, width = 28, height = 28, friction = 0.6 })
  end
  player = physics.add("players", { x = 140, y = 500, width = 24, height = 32 })
end

-- The velocity of a rider is relative to the lift: without a key it is 0, and the player rides.
function love.update(dt)
  if lift.y < 220 then
    lift.vy = 90
  elseif lift.y > 540 then
    lift.vy = -90
  end
  if ferry.x > 470 then
    ferry.vx = -110
  elseif ferry.x < 200 then
    ferry.vx = 110
  end

  player.vx = 0
  if love.keyboard.isDown("right") then
    player.vx = 200
  elseif love.keyboard.isDown("left") then
    player.vx = -200
  end
  physics.update(dt)
end

function love.keypressed(key)
  if key == "space" and player.touching.bottom then
    player.vy = -420
  end
end

function love.draw()
  physics.draw({ velocity = true })
end
