-- Breakout: move the paddle with the arrow keys or the mouse. A ball with restitution = 1 loses
-- no speed. A brick goes when it is hit.

local physics = require("physics")

local SPEED = 420 -- px/s
local COLORS = { { 0.9, 0.3, 0.35 }, { 0.95, 0.55, 0.3 }, { 1, 0.8, 0.45 }, { 0.4, 0.8, 0.45 } }

local paddle, ball, hits

local function breakBrick(brick)
  physics.remove(brick)
  hits = hits + 1
end

local function serve()
  ball.x, ball.y, ball.vx, ball.vy = 392, 440, 180, -300
end

function love.load()
  physics.load({ gravity = 0 })
  physics.setBounds(0, 0, 800, 700) -- open below: the ball leaves the picture there
  hits = 0
  for row = 0, 3 do
    for column = 0, 9 do
      physics.add("bricks", {
        x = 44 + 72 * column,
        y = 60 + 32 * row,
        width = 64,
        height = 24,
        static = true,
        color = COLORS[row + 1],
        onBegin = breakBrick,
      })
    end
  end
  paddle = physics.add("paddles", { x = 350, y = 550, width = 100, height = 14, kinematic = true })
  ball = physics.add("balls", { x = 392, y = 440, width = 14, height = 14, restitution = 1 })
  serve()

  -- Where the ball hits the paddle decides where it goes.
  function paddle.onBegin(self, other)
    if other == ball then
      ball.vx = (ball.x + 7 - self.x - self.width / 2) * 6
    end
  end
end

function love.mousemoved(x)
  paddle.x = math.max(0, math.min(700, x - 50))
end

function love.update(dt)
  paddle.vx = 0
  if love.keyboard.isDown("right") and paddle.x < 700 then
    paddle.vx = SPEED
  elseif love.keyboard.isDown("left") and paddle.x > 0 then
    paddle.vx = -SPEED
  end
  physics.update(dt)
  if ball.y > 620 then
    serve()
  end
end

function love.draw()
  for _, brick in ipairs(physics.objects.bricks) do
    love.graphics.setColor(brick.color)
    love.graphics.rectangle("fill", brick.x, brick.y, brick.width, brick.height, 4)
  end
  love.graphics.setColor(1, 1, 1)
  love.graphics.rectangle("fill", paddle.x, paddle.y, paddle.width, paddle.height, 6)
  love.graphics.circle("fill", ball.x + 7, ball.y + 7, 7)
  love.graphics.print(("bricks: %d of 40"):format(hits), 16, 16)
end
