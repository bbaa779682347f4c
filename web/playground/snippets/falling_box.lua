-- Falling box: a box falls, hits the floor and bounces.
-- Change a number: the program starts again.

local physics = require("physics")

function love.load()
  physics.load({ gravity = 800 })
  physics.add("floors", {
    x = 100,
    y = 480,
    width = 600,
    height = 40,
    static = true,
  })
  physics.add("boxes", {
    x = 376,
    y = 60,
    width = 48,
    height = 48,
    restitution = 0.6,
  })
end

function love.update(dt)
  physics.update(dt)
end

function love.draw()
  physics.draw()
end
