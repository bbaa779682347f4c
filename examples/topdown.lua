-- Rooms seen from above. All coins are to be taken; the gate is open while a crate is on the plate.

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
local ENGINE, FLOOR_DRAG, MAX_SPEED = 2600, 1200, 230 -- px/s², px/s², px/s
local LAYERS = { "plates", "ghostDoors", "gates", "crates", "walls" }
-- A mask names the groups that one passes through; a sensor that one passes through says nothing.
local GHOST = { ghostDoors = false, crates = false, coins = false }

local world, player, gate, state

local function takeCoin(coin)
  state.coins = state.coins + 1
  world:remove(coin)
end

-- A sensor is told who comes and who goes.
local function setGate(change)
  return function()
    state.pressing = state.pressing + change
    gate.active = state.pressing == 0
    world:refresh(gate) -- static objects are read once, and when told to
  end
end

local function add(group, color, x, y, size, object)
  local margin = (TILE - size) / 2
  object.x, object.y, object.width, object.height = x + margin, y + margin, size, size
  object.color = color
  return world:add(group, object)
end

local build = {
  ["#"] = function(x, y)
    add("walls", "blue", x, y, TILE, { static = true })
  end,
  ["%"] = function(x, y)
    add("ghostDoors", "cyan", x, y, TILE, { static = true })
  end,
  ["|"] = function(x, y)
    gate = add("gates", "orange", x, y, TILE, { static = true })
  end,
  o = function(x, y)
    local mask = { crates = false }
    local coin = { static = true, sensor = true, mask = mask, onBegin = takeCoin }
    add("coins", "yellow", x, y, 18, coin)
  end,
  C = function(x, y) -- the floor brakes it
    add("crates", "red", x, y, 38, { drag = FLOOR_DRAG, mass = 0.5, nudge = 14 })
  end,
  T = function(x, y)
    local plate = { static = true, sensor = true, mask = { players = false } }
    plate.onBegin, plate.onEnd = setGate(1), setGate(-1)
    add("plates", "orange", x, y, 32, plate)
  end,
  P = function(x, y)
    -- `nudge`: who misses a door by up to 14 px slips in and does not get stuck at its corner.
    player = { drag = FLOOR_DRAG, maxSpeed = MAX_SPEED, nudge = 14, lookX = 1, lookY = 0 }
    add("players", "lime", x, y, TILE, player)
  end,
}

function topdown.load()
  world = physics.newWorld({ gravity = 0 })
  state = { time = 0, coins = 0, pressing = 0 }
  local row = 0
  for text in LEVEL:gmatch("[^\n]+") do
    for column = 1, #text do
      local make = build[text:sub(column, column)]
      if make then
        make((column - 1) * TILE, row * TILE)
      end
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
  local length = math.sqrt(dx * dx + dy * dy)
  local share = length == 0 and 0 or 1 / math.max(length, 1)
  -- The player is driven by an engine, and braked by the floor as the crates are.
  player.ax, player.ay = dx * share * ENGINE, dy * share * ENGINE
  if length > 0 then
    player.lookX, player.lookY = dx * share, dy * share
  end
  world:update(dt)
end

function topdown.keypressed(key, isRepeat)
  if key == "space" and not isRepeat then
    player.mask = not player.mask and GHOST or nil
  elseif key == "r" then
    topdown.load()
  end
end

function topdown.draw()
  look.sky("dusk", "navy")
  for i = 0, 24 * 15 - 1, 2 do
    local column, row = i % 24, math.floor(i / 24)
    look.color("night", 0.16)
    love.graphics.rectangle("fill", (column + row % 2) * TILE, row * TILE, TILE, TILE)
  end
  for _, layer in ipairs(LAYERS) do
    for _, object in ipairs(world.objects[layer]) do
      local alpha = (layer == "ghostDoors" or layer == "plates" or object.active == false) and 0.4
      look.box(object.x, object.y, object.width, object.height, object.color, alpha or 1)
    end
  end
  look.color("yellow")
  for _, coin in ipairs(world.objects.coins) do
    local size = 8 + math.sin(state.time * 4 + coin.x + coin.y)
    love.graphics.circle("fill", coin.x + 9, coin.y + 9, size)
  end
  look.box(player.x, player.y, TILE, TILE, "lime", player.mask and 0.4 or 1)
  look.eyes(player.x, player.y, TILE, TILE, player.lookX, player.lookY)
  look.color("yellow")
  look.text(("%d / %d coins"):format(state.coins, state.all), 16, 9, 17)
  if state.coins == state.all then
    look.text("All of them!", 0, 9, 17, 940, "right")
  end
  look.panel(0, 606, 960, 40)
  local x = look.keys({ { "left", "right", "up", "down", "mouse", "walk and push" } }, 16, 611)
  x = look.keys({ { "space", "be a ghost, or not" }, { "r", "again" } }, x, 611)
  look.keys({ { "esc", "menu" } }, x, 611)
end

function topdown.report()
  local result = "topdown: coins=%d x=%d y=%d gate=%s"
  return result:format(state.coins, player.x, player.y, gate.active == false and "open" or "shut")
end

return topdown
