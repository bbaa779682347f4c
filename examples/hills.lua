-- A walk over hills, which are rows of slopes. No seam can be felt, crates stay where they are, and
-- the hero keeps to the ground downhill. On the way: a bridge to jump through, a turtle, stairs, a
-- cable car, and a mine cart that the slopes drive.
--
-- This file is the game: what is in the level and how things move. kit/hero.lua moves the hero,
-- terrain.lua makes slopes of the hills, hills_art.lua draws them. The physics is that of the
-- library.

local art = require("hills_art")
local hero = require("kit.hero")
local input = require("input")
local physics = require("physics")
local terrain = require("terrain")

local hills = {
  keys = { { "left", "right", "run" }, { "space", "jump" }, { "down", "drop through the bridge" } },
}

-- The ground from left to right. Each piece has a shape, a width, and how much higher its end is,
-- in px; then comes what is on it.
local GROUND = {
  { "flat", 300, hero = true, sign = "run over the hills:\nno step can be felt" },
  { "hill", 320, 120, coins = 5 },
  { "hill", 360, -170, coins = 5 },
  { "hill", 240, 110 },
  { "slope", 260, -120, crates = 3 },
  { "slope", 160, 40, tower = 2 },
  { "flat", 150, sign = "over the bridge or\nthrough the valley" },
  { "slope", 90, -130, bridge = true },
  { "hill", 160, -30, coins = 3 },
  { "hill", 160, 30, coins = 3 },
  { "slope", 90, 130 },
  { "hill", 140, 40 },
  { "flat", 110, sign = "its shell is\ntwo slopes" },
  { "cliff", 0, -150 },
  { "flat", 560, 0, water = 124, turtle = true },
  { "cliff", 0, 150 },
  { "flat", 160 },
  { "stairs", 210, 98, coins = 4 },
  { "flat", 120, crates = 2 },
  { "stairs", 210, -98, coins = 4 },
  { "hill", 160, -40 },
  { "flat", 120, sign = "wait for the car" },
  { "flat", 190 },
  { "slope", 260, 200, car = 130 },
  { "cliff", 0, 130 },
  { "flat", 150, mine = true },
  { "flat", 120, sign = "jump into the cart" },
  { "flat", 160, cart = true },
  { "hill", 340, -200, coins = 6 },
  { "hill", 200, 90, coins = 4 },
  { "hill", 240, -130, coins = 5 },
  { "flat", 80 },
  { "cliff", 0, -200 },
  { "flat", 150, water = 60 },
  { "cliff", 0, 160 },
  { "flat", 60 },
  { "hill", 260, 80, coins = 5 },
  { "hill", 280, -130, coins = 5 },
  { "flat", 160, buffer = true },
  { "hill", 240, 70 },
  { "flat", 360, flag = true },
}
local BRIDGE = { { "dip", 250, -50, coins = 4 }, { "climb", 250, 50, coins = 4 } }
local CEILING = {
  { "flat", 210 },
  { "slope", 60, -40 },
  { "slope", 80, 40 },
  { "hill", 420, -150 },
  { "slope", 60, -36 },
  { "slope", 60, 36 },
  { "hill", 340, -50 },
  { "flat", 310 },
  { "hill", 300, 40 },
  { "hill", 300, -90 },
}
-- What a piece may have on it, in the order in which it is put there.
local THINGS = {}
local NAMES = "hero bridge water turtle car mine cart buffer crates tower coins sign flag"
for name in NAMES:gmatch("%S+") do
  THINGS[#THINGS + 1] = name
end

local DEEP, HIGH = 1600, -1200 -- px, y: the lower end of the ground, the upper end of the rock
local FEEL = { runSpeed = 230, runUpInAir = 1800, jumpSpeed = 620, dropThrough = true }
local TURTLE_PERIOD, CAR_PERIOD = 3.8, 3.2 -- s, there or back
local CART_PULL, CART_SPEED = 900, 130 -- px/s², on a gradient of 1; px/s, at least

local world, player, cart, state ---@type physics.World, any, any, table

-- Callbacks.

local function takeCoin(coin, other)
  if other == player then
    state.coins = state.coins + 1
    art.burst(coin, 8, "yellow")
    world:remove(coin)
  end
end

local function fallIntoWater(_, other)
  if other == player then
    state.deaths = state.deaths + 1
    art.burst(player, 24, "white")
    player.x, player.y = state.startX, state.startY
    hero.reset(player)
    cart.x, cart.y, cart.vx, cart.vy, cart.isRolling = cart.startX, cart.startY, 0, 0, false
  end
end

local function reachFlag(flag, other)
  if other == player and not flag.reached then
    flag.reached, state.won, state.wonAt = true, true, state.time
    art.burst(flag, 40, "lime")
  end
end

-- What is on the pieces. Each function gets the value in the list, and the ends of the piece.
local put = {}

function put.hero(_, x1, y1, x2)
  player = { x = (x1 + x2) / 2 - 60, y = y1 - 34, width = 26, height = 34, hero = hero.new(FEEL) }
  player.constantSpeed = true -- uphill it is as fast along the ground as on level ground
  player.nudge, player.snap = 16, 16 -- px: up and down stairs without a jump
  world:add("players", player)
end

-- Above the ground: it falls onto it, and then stays there, however steep that is.
local function addCrate(x, y)
  local crate = { x = x - 18, y = y - 50, width = 36, height = 36, mass = 0.5, friction = 0.3 }
  world:add("crates", crate)
end

function put.crates(count, x1, y1, x2, y2)
  for i = 1, count do
    local way = i / (count + 1)
    addCrate(x1 + (x2 - x1) * way, y1 + (y2 - y1) * way)
  end
end

function put.tower(count, x1, y1, x2, y2)
  for i = 1, count do
    addCrate((x1 + x2) / 2, (y1 + y2) / 2 - 36 * (i - 1))
  end
end

function put.coins(count, x1, y1, x2, y2)
  for i = 1, count do
    local way = (i - 0.5) / count
    local x, y = x1 + (x2 - x1) * way, y1 + (y2 - y1) * way * way * (3 - 2 * way) - 40
    local coin = { x = x - 9, y = y - 9, width = 18, height = 18, static = true, sensor = true }
    coin.onBegin = takeCoin
    world:add("coins", coin)
  end
end

function put.water(depth, x1, y1, x2)
  local water = { x = x1, y = y1 - depth, width = x2 - x1, height = depth, static = true }
  water.sensor, water.onBegin = true, fallIntoWater
  world:add("water", water)
end

function put.bridge(_, x, y)
  -- Solid only from above: a player may jump through from below, and drop through.
  local function add(x1, y1, x2, y2)
    local plank = { x = x1, y = math.min(y1, y2), width = x2 - x1, height = math.abs(y2 - y1) }
    plank.slope, plank.static, plank.oneWay = y1 > y2 and "right" or "left", true, "top"
    world:add("planks", plank)
  end
  terrain.follow(BRIDGE, x, y, add, THINGS, put)
end

-- A kinematic object goes where it is told to, and carries what is on it.
local function addMover(group, x, y, width, height, toX, toY, period)
  local mover = { x = x, y = y, width = width, height = height, kinematic = true, period = period }
  mover.fromX, mover.fromY, mover.toX, mover.toY = x, y, toX, toY
  state.movers[#state.movers + 1] = mover
  return world:add(group, mover)
end

-- Three parts that swim beside each other: a slope, a box and a slope.
function put.turtle(_, x1, y1, x2)
  local y, slopes = y1 - 160, { [0] = "right", nil, "left" }
  for i = 0, 2 do
    local from, to = x2 - 164 + 50 * i, x1 + 14 + 50 * i
    local part = addMover("turtles", from, y, 50, 34, to, y, TURTLE_PERIOD)
    part.slope, part.isShell = slopes[i], i == 1
  end
end

function put.car(above, x1, y1, x2, y2)
  local car = addMover("cars", x1 - 100, y1 - 16, 96, 14, x2 - 96, y2 - above, CAR_PERIOD)
  car.oneWay = "top" -- it crushes nothing below
end

function put.mine(_, x1, y1)
  local function add(fromX, fromY, toX, toY)
    terrain.addCeiling(world, fromX, fromY, toX, toY, HIGH)
  end
  state.ceiling = terrain.follow(CEILING, x1 + 60, y1 - 150, add)
end

function put.cart(_, x1, y1)
  state.rails = { x1, x1 }
  cart = { x = x1 + 60, y = y1 - 16, width = 64, height = 16, mass = 5, pushable = false }
  cart.startX, cart.startY = cart.x, cart.y
  world:add("carts", cart)
end

function put.buffer(_, _, y1, x2)
  state.rails[2] = x2
  world:add("buffers", { x = x2 - 30, y = y1 - 30, width = 30, height = 30, static = true })
end

-- Signs are where the player comes back to.
function put.sign(text, x1, y1, x2)
  state.signs[#state.signs + 1] = { x = (x1 + x2) / 2, y = y1, text = text }
end

function put.flag(_, x1, y1)
  local flag = { x = x1 + 160, y = y1 - 120, width = 24, height = 120, static = true }
  flag.sensor, flag.onBegin = true, reachFlag
  world:add("flags", flag)
end

function hills.load()
  world = physics.newWorld({ gravity = 1600 })
  hills.world = world
  state = { time = 0, coins = 0, deaths = 0, signs = {}, movers = {} }
  local function add(x1, y1, x2, y2)
    terrain.addGround(world, x1, y1, x2, y2, DEEP)
  end
  state.ground = terrain.follow(GROUND, 0, 500, add, THINGS, put)
  state.width = state.ground[#state.ground][1]
  world:setBounds(0, HIGH, state.width, DEEP - HIGH)
  state.startX, state.startY, state.coinsInLevel = player.x, player.y, #world.objects.coins
  art.load(world, player, state)
end

local function move(mover)
  local way = state.time / mover.period % 2
  mover.direction = (way < 1) == (mover.toX > mover.fromX) and 1 or -1
  way = 1.4 * (way < 1 and way or 2 - way) - 0.2 -- there and back again, with a rest at the ends
  way = math.max(0, math.min(1, way))
  way = way * way * (3 - 2 * way)
  mover.x = mover.fromX + (mover.toX - mover.fromX) * way
  mover.y = mover.fromY + (mover.toY - mover.fromY) * way
end

-- The cart is driven by what it stands on: faster downhill, slower uphill.
local function roll(dt)
  local _, gradient = world:ground(cart)
  if cart.touching.top == player then
    cart.isRolling = true
  end
  if cart.touching.right then
    cart.isRolling, cart.vx = false, 0
  elseif cart.isRolling then
    cart.vx = math.max(CART_SPEED, cart.vx + CART_PULL * gradient * dt)
  end
end

local function readKeys()
  return {
    left = input.isDown("left", "a"),
    right = input.isDown("right", "d"),
    down = input.isDown("down", "s"),
    jump = input.isDown("space", "up", "w"),
  }
end

-- On a lift or a turtle vx is relative to it. The cart is no lift, so this does the same for it.
local function run(dt)
  local isInCart = player.touching.bottom == cart
  player.vx = player.vx - (isInCart and cart.vx or 0)
  hero.update(world, player, readKeys(), dt)
  roll(dt)
  player.vx = player.vx + (isInCart and cart.vx or 0)
end

function hills.update(dt)
  state.time = state.time + dt
  for _, mover in ipairs(state.movers) do
    move(mover)
  end
  run(dt)
  world:update(dt)
  for _, sign in ipairs(state.signs) do
    if player.x > sign.x and sign.x > state.startX then
      state.startX, state.startY = sign.x, sign.y - player.height
    end
  end
  art.update(dt)
end

function hills.camera()
  return art.camera()
end

function hills.draw()
  art.draw()
end

function hills.report()
  local result = "hills: x=%d y=%d coins=%d deaths=%d won=%s"
  return result:format(player.x, player.y, state.coins, state.deaths, tostring(state.won or false))
end

return hills
