-- A factory. What stands on a lift or a belt rides along, and so does what stands on a rider. You
-- can jump through shelves from below. The press crushes what is under it, and guards a coin. Take
-- all five, as fast as you can.

local boxes = require("boxes")
local hero = require("hero")
local look = require("look")
local physics = require("physics")

local lifts = {
  keys = { { "left", "right", "run" }, { "space", "jump" }, { "down", "drop through a shelf" } },
}

local CRATE, SHEET = 32, 4 -- px, the height of a crate before and after the press
local CRATE_EVERY, MOST = 2.4, 30 -- s, crates
local SIGNS = {
  { "Take the five coins!", 313, 482 },
  { "ride up", 95, 170 },
  { "the press guards a coin", 575, 496 },
  { "jump up, drop down", 855, 508 },
}
local COINS = { { 39, 119 }, { 409, 89 }, { 857, 149 }, { 499, 439 }, { 857, 419 } } -- px

local world, player, press, state ---@type physics.World, any, physics.Object, table

-- A kinematic object goes where it is told to, whatever is in its way.
local function addLift(color, x, y, width, height, toX, toY, period, oneWay)
  local lift = { kinematic = true, period = period, oneWay = oneWay }
  lift.fromX, lift.fromY, lift.toX, lift.toY = x, y, toX, toY
  return boxes.add(world, "lifts", color, x, y, width, height, lift)
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
    state.tries = state.tries + 1
  elseif object.height == CRATE then
    object.y, object.height, object.color = object.y + CRATE - SHEET, SHEET, "silver"
    state.flattened = state.flattened + 1
  end
end

local function addCrate(x, y, color)
  local crate = { mass = 0.5, friction = 0.4, onCrush = flatten }
  boxes.add(world, "crates", color, x, y, CRATE, CRATE, crate)
  if #world.objects.crates > MOST then
    table.remove(world.objects.crates, 5) -- the first four stay
  end
end

function lifts.load()
  world = physics.newWorld({ gravity = 1600 })
  lifts.world, state = world, { time = 0, coins = 0, tries = 1, flattened = 0, untilCrate = 0 }
  world:setBounds(0, -300, 960, 856) -- four walls; the lower one is the floor
  boxes.add(world, "walls", "slate", 436, 354, 16, 98, { static = true })
  boxes.add(world, "belts", "slate", 250, 330, 330, 24, { static = true, surfaceSpeed = 90 })
  boxes.add(world, "belts", "slate", 400, 460, 310, 24, { static = true, surfaceSpeed = -110 })
  for i = 0, 3 do
    local y = 466 - i * 90
    boxes.add(world, "shelves", "teal", 790, y, 130, 12, { static = true, oneWay = "top" })
  end
  addLift("sky", 40, 540, 110, 16, 40, 210, 3, "top") -- one-way: it crushes nothing below
  addLift("sky", 180, 210, 150, 16, 610, 210, 3.5)
  press = addLift("slate", 454, 356, 76, 34, 454, 460 - SHEET - 34, 1.5)
  for i = 0, 2 do
    addCrate(210 + i % 2 * 20, 178 - i * CRATE, "green") -- each rides on the one below
  end
  addCrate(80, 500, "green")
  for _, at in ipairs(COINS) do
    boxes.addCoin(world, at[1], at[2], state)
  end
  player = { vx = 0, vy = 0, onCrush = flatten, lookX = 1, lookY = 0 }
  boxes.add(world, "players", "orange", 300, 500, 26, 34, player)
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
  if state.coins == #COINS then
    state.wonAt = state.wonAt or state.time
  end
  hero.run(player, dt) -- on a lift or a belt vx is relative to it: 0 is to stand still
  world:update(dt)
end

function lifts.keypressed(key, isRepeat)
  if key == "space" or key == "up" or key == "w" then
    hero.jump(player)
  elseif (key == "down" or key == "s") and not isRepeat then
    world:dropThrough(player) -- through the shelf or lift that it stands on
  end
end

function lifts.draw()
  look.sky("night", "navy", "plum")
  look.color("night", 0.5) -- rails, and the piston of the press
  love.graphics.rectangle("fill", 93, 210, 4, 346)
  love.graphics.rectangle("fill", 180, 216, 580, 4)
  love.graphics.rectangle("fill", 484, 354, 16, press.y - 354)
  boxes.ground(556)
  for _, sign in ipairs(SIGNS) do
    look.sign(sign[1], sign[2], sign[3])
  end
  boxes.draw(world, "walls belts shelves lifts crates coins players", state.time)
  local time = state.wonAt or state.time
  boxes.status({
    "yellow",
    ("%d / %d coins"):format(state.coins, #COINS),
    "silver",
    ("tries %d"):format(state.tries),
    "silver",
    ("%.1f s"):format(time),
    "slate",
    ("%d crates crushed"):format(state.flattened),
  })
  if state.wonAt then
    look.won(("5 coins in %.1f s"):format(time), 220)
  end
end

function lifts.report()
  local result = "lifts: x=%d y=%d coins=%d flattened=%d won=%s"
  local hasWon = tostring(state.wonAt ~= nil)
  return result:format(player.x, player.y, state.coins, state.flattened, hasWon)
end

return lifts
