-- Crowd: a hundred and twenty visitors walk to the player and never stand inside each other.
-- Move with the arrow keys or W, A, S and D. There is no gravity: the picture is seen from above.

local physics = require("physics")

local COUNT, SPEED = 120, 60

local player

function love.load()
  physics.load({ gravity = 0 })
  physics.setBounds(0, 0, 800, 600)
  physics.add("walls", { x = 250, y = 140, width = 20, height = 320, static = true })
  physics.add("walls", { x = 530, y = 140, width = 20, height = 320, static = true })
  player = physics.add("players", { x = 390, y = 290, width = 24, height = 24, mass = 20 })
  for i = 0, COUNT - 1 do
    local isLeft = i % 2 == 0
    physics.add("visitors", {
      x = (isLeft and 20 or 620) + 16 * math.floor(i / 20) * 1.5,
      y = 60 + 48 * math.floor(i % 20 / 2),
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
