-- Crowd: a hundred and twenty visitors walk to the player and never stand inside each other.
-- Move with the arrow keys or W, A, S and D. There is no gravity: the picture is seen from above.

local physics = require("physics")

local COUNT, SPEED = 120, 60

local player

function love.load()
  physics.load({ gravity = 0 })
  physics.setBounds(0, 0, 800, 600)
  for _, corner in ipairs({ { 240, 180 }, { 500, 180 }, { 240, 360 }, { 500, 360 } }) do
    physics.add("pillars", { x = corner[1], y = corner[2], width = 60, height = 60, static = true })
  end
  player = physics.add("players", { x = 388, y = 288, width = 24, height = 24, mass = 20 })
  -- Ten to a column, at the left and at the right edge.
  for i = 0, COUNT - 1 do
    local column = math.floor(i / 10)
    physics.add("visitors", {
      x = column < 6 and 20 + 22 * column or 632 + 22 * (column - 6),
      y = 50 + 50 * (i - 10 * column) + 5 * column,
      width = 14,
      height = 14,
    })
  end
end

-- Gives an object the velocity that leads it straight to a place.
local function walk(object, x, y, speed)
  local dx, dy = x - object.x, y - object.y
  local distance = math.max(1, math.sqrt(dx * dx + dy * dy))
  object.vx, object.vy = dx / distance * speed, dy / distance * speed
end

function love.update(dt)
  local isDown = love.keyboard.isDown
  local dx = (isDown("right", "d") and 1 or 0) - (isDown("left", "a") and 1 or 0)
  local dy = (isDown("down", "s") and 1 or 0) - (isDown("up", "w") and 1 or 0)
  player.vx, player.vy = dx * 160, dy * 160
  for _, visitor in ipairs(physics.objects.visitors) do
    walk(visitor, player.x + 5, player.y + 5, SPEED)
  end
  physics.update(dt)
end

function love.draw()
  physics.draw()
end
