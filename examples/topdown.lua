-- Rooms seen from above. The doors are exactly as wide as you: if you miss one by a little, you
-- slip in. The orange gate is open while a crate is on the plate. The pale door lets only ghosts
-- through, and a ghost takes no coins. Take all of them, as fast as you can.

local boxes = require("boxes")
local input = require("input")
local look = require("look")
local physics = require("physics")

local topdown = {
  keys = {
    { "left", "right", "up", "down", "mouse", "walk and push" },
    { "space", "be a ghost, or not" },
  },
}

-- # wall  o coin  C crate  T plate  | gate  % ghost door  P player. A door is one tile wide.
local LEVEL = [[
########################
#      #o     o#       #
# o  o #       #  o o  #
#              #       #
#  P   #   C   # C     #
#      #               #
# o  o #       #       #
#      #o     o# T     #
###%#######.########|###
#      #       #       #
# o  o #  CCC  # o o o #
#      %  CoC  #       #
# o  o #  CCC  # o o o #
#      #       #       #
########################
]]
local TILE = 40 -- px, also the size of the player: it just fits through a door
local NUDGE = 14 -- px: a player that misses a door by at most this slips in
local ENGINE, FLOOR_DRAG, MAX_SPEED = 2600, 1200, 230 -- px/s², px/s², px/s
-- A mask names the groups that one passes through.
local GHOST = { ghostDoors = false, crates = false, coins = false }

-- What is written on the floors, with the middle of the first line in tiles.
local SIGNS = {
  { "Take all the coins!", 4, 1.6 },
  { "push the crate", 11.5, 2.6 },
  { "a crate on the plate\nopens the gate", 19.5, 5.9 },
  { "only a ghost comes in,\nand it takes no coins", 4, 11.05 },
  { "one is inside", 11.5, 9.6 },
}

local world, player, gate, state ---@type physics.World, any, physics.Object, table

-- A sensor tells what comes and what goes.
local function setGate(change)
  return function()
    state.pressing = state.pressing + change
    gate.active = state.pressing == 0
    world:refresh(gate) -- static objects are read once, and when told to
  end
end

-- What stands on the tile with its top-left corner at x, y.
local function build(character, x, y)
  local function add(group, color, size, object)
    local margin = (TILE - size) / 2
    return boxes.add(world, group, color, x + margin, y + margin, size, size, object)
  end
  if character == "#" then
    add("walls", "teal", TILE, { static = true, isTile = true })
  elseif character == "%" then
    add("ghostDoors", "cyan", TILE, { static = true, alpha = 0.35 })
  elseif character == "|" then
    gate = add("gates", "orange", TILE, { static = true })
  elseif character == "o" then
    boxes.addCoin(world, x + TILE / 2, y + TILE / 2, state)
  elseif character == "T" then
    local plate = { static = true, sensor = true, mask = { players = false } }
    plate.onBegin, plate.onEnd = setGate(1), setGate(-1)
    add("plates", "orange", 34, plate)
  elseif character == "C" then
    add("crates", "red", 38, { drag = FLOOR_DRAG, mass = 0.5, nudge = NUDGE })
  elseif character == "P" then
    player = { drag = FLOOR_DRAG, maxSpeed = MAX_SPEED, nudge = NUDGE, lookX = 1, lookY = 0 }
    add("players", "lime", TILE, player)
  end
end

function topdown.load()
  world = physics.newWorld({ gravity = 0 })
  topdown.world, state = world, { time = 0, coins = 0, pressing = 0 }
  boxes.build(LEVEL, TILE, build)
  state.all = #world.objects.coins
end

function topdown.update(dt)
  state.time = state.time + dt
  local dx, dy = input.direction(player.x + TILE / 2, player.y + TILE / 2)
  -- The player is driven by an engine, and braked by the floor as the crates are.
  player.ax, player.ay = dx * ENGINE, dy * ENGINE
  if dx ~= 0 or dy ~= 0 then
    player.lookX, player.lookY = dx, dy
  end
  world:update(dt)
  if state.coins == state.all then
    state.wonAt = state.wonAt or state.time
  end
end

function topdown.keypressed(key, isRepeat)
  if key == "space" and not isRepeat then
    player.mask = not player.mask and GHOST or nil
    player.alpha = player.mask and 0.4
  end
end

-- What a tile does, written into it.
local function label(group, text)
  for _, object in ipairs(world.objects[group]) do
    look.color("white", object.active == false and 0.4 or 0.9)
    local x = object.x + (object.width - TILE) / 2
    look.text(text, x, object.y + object.height / 2 - 7, 11, TILE, "center")
  end
end

local function drawLight()
  for radius = 60, 180, 40 do
    look.color("yellow", 0.05)
    love.graphics.circle("fill", player.x + TILE / 2, player.y + TILE / 2, radius)
  end
end

function topdown.draw()
  look.sky("dusk", "navy")
  look.squares(TILE, "night", 0.16)
  drawLight()
  look.color("silver", 0.8)
  for _, sign in ipairs(SIGNS) do
    look.text(sign[1], sign[2] * TILE - 120, sign[3] * TILE, 15, 240, "center")
  end
  boxes.draw(world, "plates walls ghostDoors gates", state.time)
  label("plates", "plate")
  label("gates", "gate")
  label("ghostDoors", "ghosts")
  boxes.draw(world, "crates coins players", state.time)
  local time = state.wonAt or state.time
  local coins = ("%d / %d coins"):format(state.coins, state.all)
  boxes.status({ "yellow", coins, "silver", ("%.1f s"):format(time) })
  if state.wonAt then
    look.won(("%d coins in %.1f s"):format(state.all, time), 180)
  end
end

function topdown.report()
  local shut = gate.active == false and "open" or "shut"
  local result = "topdown: x=%d y=%d coins=%d gate=%s won=%s"
  return result:format(player.x, player.y, state.coins, shut, tostring(state.wonAt ~= nil))
end

return topdown
