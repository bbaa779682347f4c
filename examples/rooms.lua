-- Maps as others make them, with little said in the editor: four rooms of one world of Tiled, of
-- which only those near the player are in the world, or a ruin from LDtk with doors that refer to
-- each other. What a map says nothing about is a sensor; its classes and tags say the rest.
--
-- The maps are maps/rooms/*.lua (with rooms.world, rooms.tiled-project) and maps/ruin.ldtk.

local boxes = require("boxes")
local hero = require("hero")
local json = require("json")
local look = require("look")
local physics = require("physics")
local sparks = require("sparks")

local rooms = {
  keys = {
    { "left", "right", "run" },
    { "space", "jump, swim" },
    { "down", "drop through" },
    { "e", "through a door" },
    { "g", "the other editor" },
  },
}

local GRAVITY, JUMP_SPEED, STROKE_SPEED = 1600, 560, 220 -- px/s², px/s
local NEAR = 96 -- px from a room: it is there then

local world, level, player, state ---@type physics.World, any, any, table
local isTiled = true

local function read(name)
  return json.decode(love.filesystem.read("maps/" .. name))
end

local function addPlayer(x, y)
  player = world:add("players", { x = x, y = y, width = 14, height = 22, lookX = 1, lookY = 0 })
  state.startX, state.startY = x, y
end

local function die(_, other)
  if other == player then
    sparks.burst(player, 18, "red")
    player.x, player.y, player.vx, player.vy = state.startX, state.startY, 0, 0
  end
end

-- Tiled -------------------------------------------------------------------------------------------

local function isNear(map, distance)
  local x, y = player.x + player.width / 2, player.y + player.height / 2
  return x > map.x - distance
    and x < map.x + map.width + distance
    and y > map.y - distance
    and y < map.y + map.height + distance
end

-- Adds a room. Coins that were taken stay away: a file knows nothing of that.
local function addRoom(name)
  local room = level:addMap(name)
  for _, object in ipairs(room.sensors) do
    local key = object.type == "Coin" and name .. object.tiled.object.id
    if key and state.taken[key] then
      world:remove(object)
    elseif key then
      object.onBegin = function(coin, other)
        if other == player then
          state.taken[key], state.coins = true, state.coins + 1
          sparks.burst(coin, 8, "yellow")
          world:remove(coin)
        end
      end
    end
  end
  local lift, path = room.named.lift, room.lines[1]
  if lift then
    lift.fromX, lift.toX = path.points[1].x, path.points[2].x
  end
end

local function stream()
  for _, map in ipairs(level.maps) do
    if not map.level and isNear(map, NEAR) then
      addRoom(map.name)
    elseif map.level and not isNear(map, 2 * NEAR) then
      level:removeMap(map.name)
    end
  end
end

local function loadTiled()
  level = world:loadTiled(read("rooms/rooms.world"), {
    folder = "maps/rooms",
    project = read("rooms/rooms.tiled-project"),
    later = true,
  })
  addRoom("hall")
  addPlayer(level.named.start.x, level.named.start.y - 8)
end

local function moveLifts()
  for _, map in ipairs(level.maps) do
    local lift = map.level and map.level.named.lift
    if lift then
      local way = state.time / lift.period % 2
      way = way < 1 and way or 2 - way
      lift.x = lift.fromX + (lift.toX - lift.fromX) * way * way * (3 - 2 * way)
    end
  end
end

-- LDtk --------------------------------------------------------------------------------------------

local function loadLDtk(identifier, doorIid)
  level = world:loadLDtk(state.project, identifier, {
    solid = {
      Hard = true, -- a group of values
      plank = { oneWay = "top", group = "planks" },
      thorns = { sensor = true, group = "thorns" },
      fog = { sensor = true, group = "fog" },
    },
    kinds = { movable = "dynamic" }, -- a tag
  })
  local place = doorIid and level.byIid[doorIid] or level.named.Hero_spawn
  addPlayer(place.x, place.y + place.height - 22)
  for _, thorn in ipairs(world.objects.thorns) do
    thorn.onBegin = die
  end
end

local function goThroughDoor()
  local door = world:overlapping(player, "Door")[1]
  if door then
    world = physics.newWorld({ gravity = GRAVITY })
    rooms.world = world
    loadLDtk(door.to.levelIid, door.to.entityIid)
  end
end

-- The game ----------------------------------------------------------------------------------------

function rooms.load()
  world = physics.newWorld({ gravity = GRAVITY })
  rooms.world = world
  state = { time = 0, coins = 0, taken = {} }
  sparks.clear()
  if isTiled then
    loadTiled()
  else
    state.project = read("ruin.ldtk")
    loadLDtk("Gate")
  end
end

function rooms.update(dt)
  state.time = state.time + dt
  local isInWater = false
  if isTiled then
    stream()
    moveLifts()
    for _, object in ipairs(world:overlapping(player, "Entities")) do
      isInWater = isInWater or object.type == "Water"
    end
  end
  state.isInWater = isInWater
  hero.run(player, dt)
  world:update(dt)
  sparks.update(dt)
end

function rooms.keypressed(key, isRepeat)
  if isRepeat then
    return
  elseif key == "space" or key == "up" or key == "w" then
    if state.isInWater then
      player.vy = -STROKE_SPEED
    else
      hero.jump(player, JUMP_SPEED)
    end
  elseif key == "down" or key == "s" then
    world:dropThrough(player)
  elseif key == "e" and not isTiled then
    goThroughDoor()
  elseif key == "g" then
    isTiled = not isTiled
    rooms.load()
  end
end

-- Drawing -----------------------------------------------------------------------------------------

local SOLID = { Crate = "orange", Lift = "sky", WoodenBox = "orange" }
local SLOPES = {
  left = { 0, 0, 1, 1, 0, 1 },
  right = { 0, 1, 1, 0, 1, 1 },
  topleft = { 0, 0, 1, 0, 0, 1 },
  topright = { 0, 0, 1, 0, 1, 1 },
}

local function drawSolid(object)
  local x, y, width, height = object.x, object.y, object.width, object.height
  if object.slope then
    local points = {}
    for i, share in ipairs(SLOPES[object.slope]) do
      points[i] = i % 2 == 1 and x + share * width or y + share * height
    end
    look.color("plum")
    love.graphics.polygon("fill", points)
  elseif object.oneWay then
    look.box(x, y, width, math.min(height, 6), "lime")
  else
    look.box(x, y, width, height, SOLID[object.type] or "plum")
  end
end

local SENSOR = { Water = "cyan", Door = "yellow", thorns = "red", fog = "silver" }

local function drawSensor(object)
  if object.type == "Coin" then
    look.ball(object.x, object.y, object.width / 2, "yellow")
  elseif object.type ~= "Hero_spawn" then
    local color = SENSOR[object.type] or SENSOR[world:groupOf(object)] or "white"
    look.color(color, 0.5)
    love.graphics.rectangle("fill", object.x, object.y, object.width, object.height)
  end
end

-- The tiles of a picture layer: of Tiled by their cells, of LDtk one by one.
local function drawPictures()
  look.color("blue", 0.5)
  for _, map in ipairs(isTiled and level.maps or {}) do
    for i, gid in ipairs(map.level and map.level.map.layers[1].data or {}) do
      if gid ~= 0 then
        local column = (i - 1) % 30
        local x, y = map.x + column * 16, map.y + (i - 1 - column) / 30 * 16
        love.graphics.rectangle("fill", x + 1, y + 1, 14, 14)
      end
    end
  end
  for _, layer in ipairs(isTiled and {} or level.pictures) do
    for _, tile in ipairs(layer.autoLayerTiles) do
      love.graphics.rectangle("fill", tile.px[1] + 1, tile.px[2] + 1, 14, 14)
    end
  end
end

local function drawWorld()
  drawPictures()
  for _, object in ipairs(level.sensors) do
    if world:groupOf(object) then
      drawSensor(object)
    end
  end
  for _, object in ipairs(level.solids) do
    drawSolid(object)
  end
  local x, y, width, height = player.x, player.y, player.width, player.height
  look.box(x, y, width, height, "orange")
  look.eyes(x, y, width, height, player.lookX, math.max(-1, math.min(1, player.vy / 400)))
  sparks.draw()
end

local function status()
  if not isTiled then
    return ("LDtk: %d solid cells, %d rectangles"):format(level.tiles, level.rectangles)
  end
  local there = 0
  for _, map in ipairs(level.maps) do
    there = there + (map.level and 1 or 0)
  end
  local text = "Tiled: %d of %d rooms are there, %d objects; %d coins"
  return text:format(there, #level.maps, #level.objects, state.coins)
end

function rooms.camera()
  return isTiled and 0 or -240, isTiled and 36 or -150
end

function rooms.draw()
  look.sky("blue", "plum")
  love.graphics.push()
  local x, y = rooms.camera()
  love.graphics.translate(-x, -y)
  drawWorld()
  for _, map in ipairs(isTiled and level.maps or {}) do
    if not map.level then
      look.color("night", 0.7)
      love.graphics.rectangle("fill", map.x, map.y, map.width, map.height)
      look.color("silver")
      local words = map.name .. ": not in the world"
      look.text(words, map.x, map.y + map.height / 2 - 12, 18, map.width, "center")
    end
  end
  love.graphics.pop()
  boxes.status({ "yellow", status() })
end

function rooms.report()
  local result = "rooms: x=%d y=%d coins=%d objects=%d editor=%s"
  local editor = isTiled and "tiled" or "ldtk"
  return result:format(player.x, player.y, state.coins, #level.objects, editor)
end

return rooms
