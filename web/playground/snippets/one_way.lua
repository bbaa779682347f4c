-- One-way: shelves that are solid from above only, and a door that opens to the right.
-- Arrow keys run, space jumps up through the shelves, down drops through the one below.

local physics = require("physics")

local player

function love.load()
  physics.load({ gravity = 1000 })
  physics.setBounds(0, 0, 800, 600)
  for i = 0, 3 do
    physics.add("shelves", {
      x = 120 + 60 * i,
      y = 500 - 90 * i,
      width = 220,
      height = 10,
      static = true,
      oneWay = "top",
    })
  end
  -- Its solid side is the right one: you pass it to the right, and not back.
  physics.add(
    "doors",
    { x = 600, y = 440, width = 10, height = 160, static = true, oneWay = "right" }
  )
  for i = 0, 4 do
    physics.add(
      "balls",
      { x = 150 + 70 * i, y = 20 + 30 * i, width = 20, height = 20, restitution = 0.5 }
    )
  end
  player = physics.add("players", { x = 60, y = 560, width = 24, height = 32 })
end

function love.keypressed(key)
  if key == "space" and player.touching.bottom then
    player.vy = -480
  elseif key == "down" then
    physics.dropThrough(player)
  end
end

function love.update(dt)
  player.vx = 0
  if love.keyboard.isDown("right") then
    player.vx = 220
  elseif love.keyboard.isDown("left") then
    player.vx = -220
  end
  physics.update(dt)
end

function love.draw()
  physics.draw()
  love.graphics.print("violet: the solid side", 16, 16)
end
