-- Balls bounce without losing speed. Bullets fly 200 px in a single step and miss no brick. A brick
-- with a window holds another ball. Where the ball hits the paddle decides where it goes.

local boxes = require("boxes")
local bullet = require("kit.bullet")
local input = require("input")
local look = require("look")
local physics = require("physics")
local sparks = require("sparks")

local breakout = {
  keys = { { "left", "right", "mouse", "move" }, { "space", "click", "shoot" } },
}

local BALL, BALL_SPEED = 14, 430 -- px, px/s
local BULLET_SPEED = 12000 -- px/s: 200 px a step, ten times the height of a brick
local PADDLE_SPEED, LEFT, RIGHT, TOP = 640, 20, 940, 60 -- px/s, and px: the inside of the walls
local COLORS = { "red", "orange", "yellow", "lime", "green", "sky", "blue" }
local COLUMNS, WIDTH, HEIGHT, GAP = 12, 70, 20, 6 -- bricks

local world, paddle, state, mouseX ---@type physics.World, any, table, number?

-- Gives a ball a direction; its speed is always the same.
local function send(ball, dx, dy)
  local share = BALL_SPEED / math.sqrt(dx * dx + dy * dy)
  ball.vx, ball.vy = dx * share, dy * share
end

local function addBall(x, y, dx, dy)
  local ball = { radius = BALL / 2, restitution = 1 } -- round: it flies off corners askew
  send(boxes.add(world, "balls", "white", x, y, BALL, BALL, ball), dx, dy)
end

-- Callbacks may remove and add what they like: the library calls them when its step is done.
local function breakBrick(brick, other)
  world:remove(brick)
  sparks.burst(brick, 8)
  if brick.hasBall then
    addBall(brick.x + (WIDTH - BALL) / 2, brick.y, other.x < brick.x and 1 or -1, 2)
  end
end

local function hitPaddle(_, ball)
  send(ball, (ball.x + BALL / 2 - paddle.x - paddle.width / 2) / paddle.width * 2.4, -1)
end

local function loseBall(_, ball)
  world:remove(ball)
end

local function hitAnything(_, shot)
  state.hits = state.hits + 1
  sparks.flash(shot.x, shot.y, 4, paddle.y - shot.y)
end

local function shoot()
  local shot = { x = paddle.x + paddle.width / 2 - 2, y = paddle.y, width = 4, height = 12 }
  shot.vy, shot.owner, shot.color = -BULLET_SPEED, "paddles", "cyan"
  bullet.shoot(world, "bullets", shot)
  state.shots = state.shots + 1
end

function breakout.load()
  world = physics.newWorld({ gravity = 0, masks = { balls = { balls = false, bullets = false } } })
  breakout.world, state, bullet.onHit = world, { shots = 0, hits = 0 }, hitAnything
  mouseX = input.mouse()
  sparks.clear()
  -- One pixel of wall holds everything, however fast it is.
  boxes.add(world, "walls", nil, LEFT - 1, TOP, 1, 600, { static = true })
  boxes.add(world, "walls", nil, RIGHT, TOP, 1, 600, { static = true })
  boxes.add(world, "walls", nil, LEFT, TOP - 1, RIGHT - LEFT, 1, { static = true })
  local pit = { static = true, sensor = true, onBegin = loseBall }
  boxes.add(world, "pits", nil, 0, 660, 960, 9, pit)
  for i = 0, COLUMNS * #COLORS - 1 do
    local column, row = i % COLUMNS, math.floor(i / COLUMNS)
    local x, y = LEFT + 7 + column * (WIDTH + GAP), TOP + 40 + row * (HEIGHT + GAP)
    local brick = { static = true, onBegin = breakBrick, hasBall = i % 17 == 8 }
    boxes.add(world, "bricks", COLORS[row + 1], x, y, WIDTH, HEIGHT, brick)
  end
  -- Solid only at its top: it never presses a ball against a wall.
  paddle = { kinematic = true, oneWay = "top", carry = false, onBegin = hitPaddle }
  boxes.add(world, "paddles", "cyan", 420, 556, 120, 16, paddle)
end

function breakout.update(dt)
  local x = paddle.x + input.axis("left", "a", "right", "d") * PADDLE_SPEED * dt ---@type number
  local mouse = input.mouse()
  if mouse ~= mouseX then -- the mouse moves the paddle when it moves itself
    x, mouseX = mouse - paddle.width / 2, mouse
  end
  paddle.x = math.max(LEFT, math.min(RIGHT - paddle.width, x)) -- a kinematic object: just write x
  if not (world.objects.balls and world.objects.balls[1]) then
    addBall(paddle.x + (paddle.width - BALL) / 2, paddle.y - 40, 0.6, -1)
  end
  bullet.update(world, "bullets", dt)
  world:update(dt)
  sparks.update(dt)
end

function breakout.keypressed(key)
  if key == "space" or key == "up" or key == "w" then
    shoot()
  end
end

breakout.mousepressed = shoot

-- A brick with a ball in it has a window.
local function drawHeldBalls()
  for _, brick in ipairs(world.objects.bricks) do
    if brick.hasBall then
      local x, y = brick.x + WIDTH / 2, brick.y + HEIGHT / 2
      look.color("night", 0.6)
      love.graphics.rectangle("fill", x - 14, brick.y + 3, 28, HEIGHT - 6, (HEIGHT - 6) / 2)
      look.color("white")
      love.graphics.circle("fill", x, y, BALL / 2 - 1)
    end
  end
end

function breakout.draw()
  look.sky("night", "navy", "plum")
  look.color("cyan") -- the walls, as thin as they are
  love.graphics.rectangle("line", LEFT - 0.5, TOP - 0.5, RIGHT - LEFT + 1, 700)
  boxes.draw(world, "bricks balls bullets paddles", 0)
  drawHeldBalls()
  sparks.draw()
  look.eyes(paddle.x + 28, paddle.y - 5, 64, 36, 0, -0.6)
  local bricks = #world.objects.bricks
  local words = bricks > 0 and bricks .. " bricks" or "Well done!"
  boxes.status({ "white", words, "silver", ("%d shots, %d hits"):format(state.shots, state.hits) })
end

function breakout.report()
  local broken = COLUMNS * #COLORS - #world.objects.bricks
  local lost = state.shots - state.hits - #(world.objects.bullets or {}) -- those in the air are not
  local result = "breakout: x=%d y=%d broken=%d shots=%d lost=%d"
  return result:format(paddle.x, paddle.y, broken, state.shots, lost)
end

return breakout
