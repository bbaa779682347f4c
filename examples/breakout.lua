-- Breakout: balls that lose no speed, bullets that miss nothing, white bricks that hold a ball.

local boxes = require("boxes")
local input = require("input")
local look = require("look")
local physics = require("physics")

local breakout = {}

local BALL, BALL_SPEED = 14, 430 -- px, px/s
local BULLET_SPEED = 12000 -- px/s: 200 px a step, ten times the height of a brick
local PADDLE_SPEED, LEFT, RIGHT, TOP = 640, 20, 940, 60 -- px/s, and px: the inside of the walls
local COLORS = { "red", "orange", "yellow", "lime", "green", "sky", "blue" }
local COLUMNS, WIDTH, HEIGHT, GAP = 12, 70, 20, 6 -- bricks

local world, paddle, state, mouseX

-- Gives a ball a direction; its speed is always the same.
local function send(ball, dx, dy)
  local share = BALL_SPEED / math.sqrt(dx * dx + dy * dy)
  ball.vx, ball.vy = dx * share, dy * share
end

local function addBall(x, y, dx, dy)
  local ball = { restitution = 1 }
  send(ball, dx, dy)
  boxes.add(world, "balls", "white", x, y, BALL, BALL, ball)
end

-- Callbacks may remove and add what they like: the library calls them when its step is done.
local function breakBrick(brick, other)
  world:remove(brick)
  table.insert(state.flashes, { brick.x, brick.y, WIDTH, HEIGHT, left = 1 })
  if brick.color == "white" then
    addBall(brick.x + (WIDTH - BALL) / 2, brick.y, other.x < brick.x and 1 or -1, 2)
  end
end

local function hitPaddle(_, ball, side)
  if side == "top" then -- where the ball hits says where it goes
    send(ball, (ball.x + BALL / 2 - paddle.x - paddle.width / 2) / paddle.width * 2.4, -1)
  end
end

local function loseBall(_, ball)
  world:remove(ball)
end

local function hitAnything(bullet)
  world:remove(bullet)
  state.hits = state.hits + 1
  table.insert(state.flashes, { bullet.x, bullet.y, 4, paddle.y - bullet.y, left = 1 })
end

local function shoot()
  local bullet = { vy = -BULLET_SPEED, onBegin = hitAnything }
  boxes.add(world, "bullets", "cyan", paddle.x + paddle.width / 2 - 2, paddle.y, 4, 12, bullet)
  state.shots = state.shots + 1
end

function breakout.load()
  local masks = { balls = { balls = false, bullets = false }, bullets = { paddles = false } }
  world = physics.newWorld({ gravity = 0, masks = masks })
  state = { shots = 0, hits = 0, flashes = {} }
  -- One pixel of wall holds everything, however fast it is.
  world:add("walls", { x = LEFT - 1, y = TOP, width = 1, height = 600, static = true })
  world:add("walls", { x = RIGHT, y = TOP, width = 1, height = 600, static = true })
  world:add("walls", { x = LEFT, y = TOP - 1, width = RIGHT - LEFT, height = 1, static = true })
  local pit = { x = 0, y = 660, width = 960, height = 9, static = true, sensor = true }
  pit.onBegin = loseBall
  world:add("pits", pit)
  for i = 0, COLUMNS * #COLORS - 1 do
    local column, row = i % COLUMNS, math.floor(i / COLUMNS)
    local x, y = LEFT + 7 + column * (WIDTH + GAP), TOP + 40 + row * (HEIGHT + GAP)
    local color = i % 17 == 8 and "white" or COLORS[row + 1]
    local brick = { static = true, onBegin = breakBrick }
    boxes.add(world, "bricks", color, x, y, WIDTH, HEIGHT, brick)
  end
  -- Solid only at its top: it never presses a ball against a wall.
  paddle = { kinematic = true, oneWay = "top", carry = false, onBegin = hitPaddle }
  boxes.add(world, "paddles", "cyan", 420, 556, 120, 16, paddle)
end

function breakout.update(dt)
  local x = paddle.x + input.axis("left", "a", "right", "d") * PADDLE_SPEED * dt
  local mouse = love.mouse.getX()
  if mouse ~= mouseX then -- the mouse moves the paddle when it moves itself
    x, mouseX = mouseX and mouse - paddle.width / 2 or x, mouse
  end
  paddle.x = math.max(LEFT, math.min(RIGHT - paddle.width, x)) -- a kinematic object: just write x
  if not (world.objects.balls and world.objects.balls[1]) then
    addBall(paddle.x + (paddle.width - BALL) / 2, paddle.y - 40, 0.6, -1)
  end
  world:update(dt)
  for i = #state.flashes, 1, -1 do
    state.flashes[i].left = state.flashes[i].left - 4 * dt
    if state.flashes[i].left <= 0 then
      table.remove(state.flashes, i)
    end
  end
end

function breakout.keypressed(key)
  if key == "space" or key == "up" or key == "w" then
    shoot()
  elseif key == "r" then
    breakout.load()
  end
end

breakout.mousepressed = shoot

function breakout.draw()
  look.sky("night", "navy", "plum")
  look.color("slate")
  love.graphics.rectangle("line", LEFT - 0.5, TOP - 0.5, RIGHT - LEFT + 1, 600)
  boxes.draw(world, { "bricks", "balls", "bullets", "paddles" })
  for _, flash in ipairs(state.flashes) do
    look.color("white", flash.left)
    love.graphics.rectangle("fill", flash[1], flash[2], flash[3], flash[4], 3)
  end
  local ball = world.objects.balls and world.objects.balls[1] or paddle
  local lookX = math.max(-1, math.min(1, (ball.x - paddle.x - 53) / 200))
  look.eyes(paddle.x + 38, paddle.y, 44, 24, lookX, -0.6)
  local lost = state.shots - state.hits - #(world.objects.bullets or {})
  local bullets = ("%d bullets, %d went through a wall"):format(state.shots, lost)
  local bricks = #world.objects.bricks .. " bricks"
  local won = bricks == "0 bricks" and "Well done!" or ""
  boxes.status({ "white", bricks, "silver", bullets, "yellow", won }, 24, 20)
  boxes.keys({ { "left", "right", "mouse", "move" }, { "space", "click", "shoot" } })
end

function breakout.report()
  local broken = COLUMNS * #COLORS - #world.objects.bricks
  local lost = state.shots - state.hits - #(world.objects.bullets or {})
  local result = "breakout: x=%d y=%d broken=%d shots=%d lost=%d"
  return result:format(paddle.x, paddle.y, broken, state.shots, lost)
end

return breakout
