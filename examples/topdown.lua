-- Rooms seen from above. All coins are to be taken; the gate is open while a crate is on the plate.

local boxes = require("boxes")
local input = require("input")
local look = require("look")
local physics = require("physics")

local topdown = {}

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
local NUDGE = 14 -- px: who misses a door by no more than this slips in
local ENGINE, FLOOR_DRAG, MAX_SPEED = 2600, 1200, 230 -- px/s², px/s², px/s
-- A mask names the groups that one passes through; a sensor that one passes through says nothing.
local GHOST = { ghostDoors = false, crates = false, coins = false }

local world, player, gate, state

local function takeCoin(coin)
  state.coins = state.coins + 1
  world:remove(coin)
end

-- A sensor tells who comes and who goes.
local function setGate(change)
  return function()
    state.pressing = state.pressing + change
    gate.active = state.pressing == 0
    world:refresh(gate) -- static objects are read once, and when told to
  end
end

-- What stands on the tile whose top-left corner is x, y.
local function build(character, x, y)
  local function add(group, color, size, object)
    local margin = (TILE - size) / 2
    return boxes.add(world, group, color, x + margin, y + margin, size, size, object)
  end
  if character == "#" then
    add("walls", "blue", TILE, { static = true })
  elseif character == "%" then
    add("ghostDoors", "cyan", TILE, { static = true, alpha = 0.35 })
  elseif character == "|" then
    gate = add("gates", "orange", TILE, { static = true })
  elseif character == "o" then
    local mask = { crates = false }
    add("coins", "yellow", 18, { static = true, sensor = true, mask = mask, onBegin = takeCoin })
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
  state = { time = 0, coins = 0, pressing = 0 }
  local row = 0
  for text in LEVEL:gmatch("[^\n]+") do
    for column = 1, #text do
      build(text:sub(column, column), (column - 1) * TILE, row * TILE)
    end
    row = row + 1
  end
  state.all = #world.objects.coins
end

function topdown.update(dt)
  state.time = state.time + dt
  local dx = input.axis("left", "a", "right", "d")
  local dy = input.axis("up", "w", "down", "s")
  if love.mouse.isDown(1) then
    local x, y = love.mouse.getPosition()
    dx, dy = x - player.x - TILE / 2, y - player.y - TILE / 2
  end
  local share = 1 / math.max(1, math.sqrt(dx * dx + dy * dy))
  -- The player is driven by an engine, and braked by the floor as the crates are.
  player.ax, player.ay = dx * share * ENGINE, dy * share * ENGINE
  if dx ~= 0 or dy ~= 0 then
    player.lookX, player.lookY = dx * share, dy * share
  end
  world:update(dt)
end

function topdown.keypressed(key, isRepeat)
  if key == "space" and not isRepeat then
    player.mask = not player.mask and GHOST or nil
    player.alpha = player.mask and 0.4
  elseif key == "r" then
    topdown.load()
  end
end

function topdown.draw()
  look.sky("dusk", "navy")
  look.color("night", 0.16)
  for i = 0, 24 * 15 - 1, 2 do
    local column, row = i % 24, math.floor(i / 24)
    love.graphics.rectangle("fill", (column + row % 2) * TILE, row * TILE, TILE, TILE)
  end
  boxes.draw(world, { "plates", "ghostDoors", "gates", "crates", "walls", "players" })
  boxes.drawCoins(world.objects.coins, state.time)
  look.eyes(player.x, player.y, TILE, TILE, player.lookX, player.lookY)
  local words = { "white", ("%d / %d coins"):format(state.coins, state.all) }
  if state.coins == state.all then
    words[3], words[4] = "yellow", "All of them!"
  end
  boxes.status(words, 16, 9)
  boxes.keys({
    { "left", "right", "up", "down", "mouse", "walk and push" },
    { "space", "be a ghost, or not" },
  })
end

function topdown.report()
  local shut = gate.active == false and "open" or "shut"
  local result = "topdown: x=%d y=%d coins=%d gate=%s"
  return result:format(player.x, player.y, state.coins, shut)
end

return topdown
