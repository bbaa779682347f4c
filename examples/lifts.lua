-- A factory with lifts, belts, a press and shelves. Take the five coins.

local input = require("input")
local look = require("look")
local physics = require("physics")

local lifts = {}

local RUN_SPEED, RUN_UP, JUMP_SPEED = 230, 1800, 620 -- px/s, px/s², px/s
local CRATE, SHEET = 32, 4 -- px, height of a crate before and after the press
local CRATE_EVERY, MOST = 2.4, 30 -- s, crates

local world, player, press, state

local function addWall(group, x, y, width, height, fields)
  local wall = { x = x, y = y, width = width, height = height, static = true }
  for name, value in pairs(fields or {}) do
    wall[name] = value
  end
  return world:add(group, wall)
end

-- A kinematic object goes where it is told to, whatever is in its way. Those who stand on it come
-- along, and those who stand on them: nothing more has to be done for that.
local function addLift(x, y, width, height, toX, toY, period)
  local lift = { x = x, y = y, width = width, height = height, kinematic = true, period = period }
  lift.fromX, lift.fromY, lift.toX, lift.toY = x, y, toX, toY
  return world:add("lifts", lift)
end

local function moveLift(lift)
  local way = state.time / lift.period % 2
  way = way < 1 and way or 2 - way -- there and back again
  way = lift == press and way ^ 5 or way * way * (3 - 2 * way)
  lift.x = lift.fromX + (lift.toX - lift.fromX) * way
  lift.y = lift.fromY + (lift.toY - lift.fromY) * way
end

-- Called when an object is held between two that cannot give way: here the press and the belt.
local function flatten(object)
  if object == player then
    player.x, player.y, player.vx, player.vy = 300, 500, 0, 0
  elseif object.height == CRATE then
    object.y, object.height, object.color = object.y + CRATE - SHEET, SHEET, "silver"
    state.flattened = state.flattened + 1
  end
end

local function takeCoin(coin, other)
  if other == player then
    state.coins = state.coins + 1
    world:remove(coin)
  end
end

local function addCrate(x, y, color)
  local crate = { x = x, y = y, width = CRATE, height = CRATE, mass = 0.5, friction = 0.4 }
  crate.color, crate.onCrush = color, flatten
  world:add("crates", crate)
  if #world.objects.crates > MOST then
    table.remove(world.objects.crates, 5) -- the first four stay
  end
end

function lifts.load()
  world = physics.newWorld({ gravity = 1600 })
  state = { time = 0, coins = 0, flattened = 0, untilCrate = 0 }
  world:setBounds(0, -300, 960, 856) -- four walls; the lower one is the floor
  addWall("walls", 436, 354, 16, 98)
  -- What stands on a surface that runs is carried, as if by a lift.
  addWall("belts", 250, 330, 330, 24, { surfaceSpeed = 90 })
  addWall("belts", 400, 460, 310, 24, { surfaceSpeed = -110 })
  for i = 0, 3 do
    addWall("shelves", 790, 466 - i * 90, 130, 12, { oneWay = "top" })
  end
  addLift(40, 540, 110, 16, 40, 210, 3).oneWay = "top" -- or it would crush who stands below
  addLift(180, 210, 150, 16, 610, 210, 3.5)
  press = addLift(454, 356, 76, 34, 454, 460 - SHEET - 34, 1.5)
  for i = 0, 2 do
    addCrate(220 + i % 2 * 20, 178 - i * CRATE, "yellow")
  end
  addCrate(104, 508, "yellow")
  for i, at in ipairs({ { 30, 120 }, { 400, 90 }, { 848, 140 }, { 500, 430 }, { 848, 410 } }) do
    addWall("coins", at[1], at[2], 20, 20, { sensor = true, onBegin = takeCoin, number = i })
  end
  player = { x = 300, y = 522, width = 26, height = 34, vx = 0, vy = 0, onCrush = flatten }
  player.facing = 1
  world:add("players", player)
end

function lifts.update(dt)
  state.time, state.untilCrate = state.time + dt, state.untilCrate - dt
  if state.untilCrate <= 0 then
    state.untilCrate = CRATE_EVERY
    addCrate(262, 298, "red")
  end
  for _, lift in ipairs(world.objects.lifts) do
    moveLift(lift)
  end
  -- On a lift or a belt, vx is relative to it: 0 is to stand still.
  local direction, step = input.axis("left", "a", "right", "d"), RUN_UP * dt
  local missing = direction * RUN_SPEED - player.vx
  player.vx = player.vx + math.max(-step, math.min(step, missing))
  player.facing = direction ~= 0 and direction or player.facing
  world:update(dt)
end

function lifts.keypressed(key, isRepeat)
  if (key == "space" or key == "up" or key == "w") and player.touching.bottom then
    player.vy = -JUMP_SPEED
  elseif (key == "down" or key == "s") and not isRepeat then
    world:dropThrough(player) -- falls through the shelf or lift below
  elseif key == "r" then
    lifts.load()
  end
end

local function drawBelt(belt)
  look.box(belt.x, belt.y, belt.width, belt.height, "night")
  local gap, run = 22, state.time * belt.surfaceSpeed
  look.color("slate")
  for x = belt.x + run % gap, belt.x + belt.width - 8, gap do
    love.graphics.rectangle("fill", x, belt.y + 2, 8, 4)
    love.graphics.circle("line", math.floor((x - run % gap) + 8), belt.y + 15, 5)
  end
end

function lifts.draw()
  look.sky("night", "navy", "plum")
  look.color("night", 0.5)
  love.graphics.rectangle("fill", 93, 210, 4, 346) -- rails
  love.graphics.rectangle("fill", 180, 216, 580, 4)
  love.graphics.rectangle("fill", 484, 354, 16, press.y - 354)
  look.color("dusk")
  love.graphics.rectangle("fill", 0, 556, 960, 84)
  look.box(436, 354, 16, 98, "slate")
  look.box(250, 286, 56, 6, "slate")
  for _, belt in ipairs(world.objects.belts) do
    drawBelt(belt)
  end
  for _, shelf in ipairs(world.objects.shelves) do
    look.box(shelf.x, shelf.y, shelf.width, shelf.height, "teal")
  end
  for _, lift in ipairs(world.objects.lifts) do
    look.box(lift.x, lift.y, lift.width, lift.height, lift == press and "slate" or "sky")
  end
  for _, crate in ipairs(world.objects.crates) do
    look.box(crate.x, crate.y, crate.width, crate.height, crate.color)
  end
  for _, coin in ipairs(world.objects.coins) do
    look.color("yellow")
    local x, bob = coin.x + 10, math.sin(state.time * 3 + coin.number) * 3
    love.graphics.ellipse("fill", x, coin.y + 10 + bob, 9, 10)
  end
  look.box(player.x, player.y, player.width, player.height, "orange")
  look.eyes(player.x, player.y, player.width, player.height, player.facing, 0)
  look.panel(16, 14, 260, 40)
  look.color("yellow")
  look.text(("coins %d / 5"):format(state.coins), 32, 24, 16)
  look.color("silver")
  look.text(("pressed flat %d"):format(state.flattened), 140, 24, 16)
  look.panel(0, 606, 960, 40)
  look.keys({
    { "left", "right", "run" },
    { "space", "jump" },
    { "down", "drop through" },
    { "r", "again" },
    { "esc", "menu" },
  }, 16, 611)
end

function lifts.report()
  local result = "lifts: coins=%d flattened=%d x=%d"
  return result:format(state.coins, state.flattened, player.x)
end

return lifts
