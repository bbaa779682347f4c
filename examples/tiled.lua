-- A level from the editor Tiled. Its solid tiles become few large rectangles: press X to see them.
-- Its objects become objects of the world. Their fields are set in the editor. Earth can be dug:
-- only the rectangle that it is a part of is cut.
--
-- The map is maps/hills.lua, an export as Lua; tiled_map.lua draws it.

local boxes = require("boxes")
local hero = require("hero")
local input = require("input")
local lift = require("kit.lift")
local look = require("look")
local physics = require("physics")
local sparks = require("sparks")
local tiledMap = require("tiled_map")
local view = require("view")

local tiled = {
  keys = {
    { "left", "right", "run" },
    { "space", "jump, swim" },
    { "down", "drop through" },
    { "e", "dig ahead, with down below" },
    { "g", "merge tiles or not" },
  },
}

local GRAVITY, IN_WATER = 1600, 320 -- px/s²
local STROKE_SPEED, SWIM_SPEED, DRAG_IN_WATER = 250, 150, 3 -- px/s, px/s, 1/s
local REST = 0.7 -- s, of a lift at its ends

local world, level, player, state ---@type physics.World, physics.Level, any, table
local isMerging = true

local function takeCoin(coin, other)
  if other == player then
    state.coins = state.coins + 1
    sparks.burst(coin, 8, "yellow")
    world:remove(coin)
  end
end

local function die(_, other)
  if other == player then
    state.deaths = state.deaths + 1
    sparks.burst(player, 18, "red")
    player.x, player.y, player.vx, player.vy = state.startX, state.startY, 0, 0
  end
end

local function win(flag, other)
  if other == player and not state.isWon then
    state.isWon = true
    sparks.burst(flag, 40, "lime")
  end
end

-- What objects do is said here, per group; where they are and what they are is said in the editor.
local function bringToLife(group, callback)
  for _, object in ipairs(world.objects[group]) do
    object.onBegin = callback
  end
end

-- The editor says where a lift goes (toX or toY) and how long it takes.
local function startLift(platform)
  local x, y = platform.toX or platform.x, platform.toY or platform.y
  local distance = math.abs(x - platform.x) + math.abs(y - platform.y)
  local settings = { speed = distance / (platform.period - REST), wait = REST }
  platform.lift = lift.new(platform, { { platform.x, platform.y }, { x, y } }, settings)
end

function tiled.load()
  world = physics.newWorld({ gravity = GRAVITY })
  level = world:loadTiled("maps/hills.lua", { merge = isMerging })
  world:setBounds(level.x, level.y - 300, level.width, level.height + 300)
  bringToLife("coins", takeCoin)
  bringToLife("spikes", die)
  bringToLife("flags", win)
  for _, platform in ipairs(world.objects.lifts) do
    startLift(platform)
  end
  player = level.named.hero
  player.lookX, player.lookY = 1, 0
  state = { time = 0, coins = 0, deaths = 0, camera = 0, dug = 0, isWon = false }
  state.startX, state.startY, state.coinsInLevel = player.x, player.y, #world.objects.coins
  tiled.world = world
  tiledMap.load(level.map)
  sparks.clear()
end

local function swim(dt)
  local _, count = world:overlapping(player, "water")
  state.isInWater = count > 0
  player.gravity = state.isInWater and IN_WATER or nil
  player.airFriction = state.isInWater and DRAG_IN_WATER or 0
  hero.run(player, dt, nil, state.isInWater and SWIM_SPEED or nil)
end

-- Digs out the cell of earth at a point, if there is one.
local function digAt(x, y)
  local tiles = level.tileLayers.ground
  local column, row = tiles:cellAt(x, y)
  for _, object in ipairs(world:queryPoint(x, y, "ground")) do
    if column and row and object.type == "earth" and object.tiled.tiles == tiles then
      tiles:setTile(column, row, 0)
      tiledMap.clear("ground", column, row)
      local size = tiles.tileWidth
      local cell = { x = tiles.x + column * size, y = tiles.y + row * size }
      cell.width, cell.height = size, size
      sparks.burst(cell, 12, "plum")
      state.dug = state.dug + 1
      return true
    end
  end
  return false
end

local function dig()
  local feet = player.y + player.height
  if input.isDown("down", "s") then -- all that it stands on
    digAt(player.x + 1, feet + 1)
    digAt(player.x + player.width - 1, feet + 1)
    return
  end
  local x = player.lookX > 0 and player.x + player.width + 1 or player.x - 1
  if not digAt(x, feet - 1) then
    digAt(x, player.y + 1)
  end
end

local function follow(dt)
  local target = player.x + player.width / 2 + player.lookX * 60 - view.gameWidth / 2
  target = math.max(level.x, math.min(level.x + level.width - view.gameWidth, target))
  state.camera = state.camera + (target - state.camera) * math.min(1, 6 * dt)
end

function tiled.update(dt)
  state.time = state.time + dt
  for _, platform in ipairs(world.objects.lifts) do
    lift.update(world, platform, dt)
  end
  swim(dt)
  world:update(dt)
  sparks.update(dt)
  follow(dt)
end

function tiled.keypressed(key, isRepeat)
  if isRepeat then
    return
  elseif key == "space" or key == "up" or key == "w" then
    if state.isInWater then
      player.vy = -STROKE_SPEED
    else
      hero.jump(player)
    end
  elseif key == "down" or key == "s" then
    world:dropThrough(player)
  elseif key == "e" then
    dig()
  elseif key == "g" then
    isMerging = not isMerging
    tiled.load()
  end
end

function tiled.camera()
  return math.floor(state.camera), 0
end

-- How many solid tiles there are now, or rectangles of them.
local function count(what)
  local sum = 0
  for _, layer in ipairs({ "ground", "plants", "far hills" }) do
    sum = sum + level.tileLayers[layer][what]
  end
  return sum
end

local function drawObjects()
  for _, group in ipairs({ "flags", "coins", "crates" }) do
    for _, object in ipairs(world.objects[group]) do
      tiledMap.drawObject(object)
    end
  end
  for _, platform in ipairs(world.objects.lifts) do
    look.box(platform.x, platform.y, platform.width, platform.height, "sky")
  end
  local x, y, width, height = player.x, player.y, player.width, player.height
  look.box(x, y, width, height, "orange")
  look.eyes(x, y, width, height, player.lookX, math.max(-1, math.min(1, player.vy / 400)))
end

function tiled.draw()
  look.sky("blue", "sky", "cyan")
  love.graphics.push()
  local x = tiled.camera()
  love.graphics.translate(-x, 0)
  tiledMap.drawLayer("far hills", x)
  tiledMap.drawLayer("plants", x)
  drawObjects()
  tiledMap.drawLayer("ground", x)
  look.color("plum") -- the earth goes on below the map
  love.graphics.rectangle("fill", x, level.y + level.height, view.gameWidth, view.height)
  tiledMap.drawBelts(world.objects.belts, state.time)
  sparks.draw()
  love.graphics.pop()
  boxes.status({
    "yellow",
    ("%d of %d coins"):format(state.coins, state.coinsInLevel),
    "white",
    ("%d solid tiles, %d rectangles"):format(count("tiles"), count("rectangles")),
    "lime",
    state.isWon and "You made it!" or "",
  })
end

function tiled.report()
  local result = "tiled: x=%d y=%d coins=%d deaths=%d tiles=%d rectangles=%d dug=%d won=%s"
  return result:format(
    player.x,
    player.y,
    state.coins,
    state.deaths,
    level.tiles,
    count("rectangles"),
    state.dug,
    tostring(state.isWon)
  )
end

return tiled
