-- A whole game of several maps. Only rooms near the player are in the world. Classes of the editor
-- are classes of the game. A flag saves, thorns lead back to it, and the file is there tomorrow.
--
-- The maps are maps/rooms/*.lua, four rooms of one world of Tiled (with rooms.world), and
-- maps/ruin.ldtk: its doors refer to each other.

local boxes = require("boxes")
local hero = require("hero")
local input = require("input")
local json = require("json")
local look = require("look")
local physics = require("physics")
local saved = require("saved")
local sparks = require("sparks")

local rooms = {
  keys = {
    { "left", "right", "run" },
    { "space", "jump, swim" },
    { "down", "drop" },
    { "c", "the saved game" },
    { "e", "door" },
    { "g", "the other editor" },
  },
}

local GRAVITY, SPEED, JUMP_SPEED, STROKE_SPEED = 1600, 170, 560, 220 -- px/s², px/s
local NEAR = 96 -- px from a room: it is there then
local FILE = "rooms-save.lua"
local SCALE, WIDTH, HEIGHT = 2, 480, 320 -- of the picture; px, of a room

-- The game's own fields that belong to a saved game: of coins in which room they are, of flags
-- whether they are up, of lifts their time, of the player what it has taken.
local OWN = { "coins", "isUp", "key", "taken", "time" }

local world, level, player ---@type physics.World, any, any
local isTiled = true
local game ---@type table what is in no saved game
local checkpoint ---@type any the state of the world at the last flag

local function read(name)
  return json.decode((love.filesystem.read("maps/" .. name)))
end

-- Classes of the editors --------------------------------------------------------------------------

local function newClass(draw)
  local class = { draw = draw }
  class.__index = class
  return class
end

---@class Coin: physics.Object
local Coin = newClass(function(coin)
  look.ball(coin.x, coin.y, coin.width / 2, "yellow")
end)

function Coin:onBegin(other)
  if other == player then
    player.coins, player.taken[self.key] = player.coins + 1, true
    sparks.burst(self, 8, "yellow")
    world:remove(self)
  end
end

local Thorns = newClass(function(thorns)
  look.color("red")
  for x = thorns.x, thorns.x + thorns.width - 8, 8 do
    local bottom = thorns.y + thorns.height
    love.graphics.polygon("fill", x, bottom, x + 4, thorns.y, x + 8, bottom)
  end
end)

function Thorns.onBegin(_, other)
  game.isDead = game.isDead or other == player
end

local Flag = newClass(function(flag)
  look.box(flag.x, flag.y, 2, flag.height, "silver")
  look.box(flag.x + 2, flag.y + (flag.isUp and 0 or 16), 12, 8, flag.isUp and "lime" or "red")
end)

-- A checkpoint: the world as it is now. (What is still to come of this step is in it, too.)
function Flag:onBegin(other)
  if other == player and not self.isUp then
    self.isUp = true
    sparks.burst(self, 12, "lime")
    checkpoint = world:save()
    saved.write(FILE, { state = checkpoint })
  end
end

local Water = newClass(function(water)
  look.color("cyan", 0.5)
  love.graphics.rectangle("fill", water.x, water.y, water.width, water.height)
end)

local Crate = newClass(function(crate)
  look.box(crate.x, crate.y, crate.width, crate.height, "orange")
end)

local Lift = newClass(function(lift)
  look.box(lift.x, lift.y, lift.width, lift.height, "sky")
end)

-- Moves along a line of the map.
function Lift:move(points, dt)
  self.time = (self.time or 0) + dt
  local way = self.time / self.period % 2
  way = way < 1 and way or 2 - way
  self.x = points[1].x + (points[2].x - points[1].x) * way * way * (3 - 2 * way)
end

local Door = newClass(function(door)
  look.box(door.x, door.y, door.width, door.height, "yellow")
end)

local CLASSES = {
  Coin = Coin,
  Crate = Crate,
  Door = Door,
  Flag = Flag,
  Lift = Lift,
  Thorns = Thorns,
  Water = Water,
  WoodenBox = Crate,
}

-- Tiled -------------------------------------------------------------------------------------------

-- Adds a room. Coins that were taken stay away: its file knows nothing of that.
local function addRoom(name)
  for _, object in ipairs(level:addMap(name).sensors) do
    if object.type == "Coin" then
      object.key = name .. " " .. object.tiled.object.id
      if player.taken[object.key] then
        world:remove(object)
      end
    end
  end
end

local function isNear(map, distance)
  local x, y = player.x + player.width / 2, player.y + player.height / 2
  return x > map.x - distance
    and x < map.x + map.width + distance
    and y > map.y - distance
    and y < map.y + map.height + distance
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

local function addPlayer(x, y)
  player = { x = x, y = y, width = 14, height = 22, vx = 0, vy = 0, lookX = 1 }
  player.coins, player.taken, player.touching = 0, {}, {}
  world.objects.players = { hero = player } -- a key of its own: so a saved game finds it
end

-- Begins anew, or with a saved game: the same world is built, and then put back.
local function loadTiled(state)
  world.ownFields = OWN
  level = world:loadTiled(read("rooms/rooms.world"), {
    folder = "maps/rooms",
    classes = CLASSES,
    later = true,
  })
  addPlayer(80, 590)
  if state then
    world:restore(state)
  else
    addRoom("hall")
  end
  checkpoint = world:save()
end

local function moveLifts(dt)
  for _, map in ipairs(level.maps) do
    local lift = map.level and map.level.named.lift
    if lift then
      lift:move(map.level.lines[1].points, dt)
    end
  end
end

-- LDtk --------------------------------------------------------------------------------------------

local function loadLDtk(identifier, doorIid)
  level = world:loadLDtk(game.project, identifier, {
    solid = {
      Hard = true, -- a group of values
      plank = { oneWay = "top", group = "planks" },
      thorns = { sensor = true, group = "thorns", onBegin = Thorns.onBegin, draw = Thorns.draw },
      fog = { sensor = true, group = "fog" },
    },
    kinds = { movable = "dynamic" }, -- a tag
    classes = CLASSES,
  })
  local place = doorIid and level.byIid[doorIid] or level.named.Hero_spawn
  addPlayer(place.x, place.y + place.height - 22)
  checkpoint = world:save()
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

local function goalOfCamera()
  local x, y = player.x + player.width / 2, player.y + player.height / 2
  if isTiled then
    local column, row = math.floor(x / WIDTH), math.floor(y / HEIGHT)
    return math.max(0, math.min(1, column)) * WIDTH, math.max(0, math.min(1, row)) * HEIGHT
  end
  local right, bottom = math.max(0, level.width - WIDTH), math.max(0, level.height + 18 - HEIGHT)
  return math.max(0, math.min(right, x - WIDTH / 2)), math.max(0, math.min(bottom, y - HEIGHT / 2))
end

local function begin(state)
  world = physics.newWorld({ gravity = GRAVITY })
  rooms.world = world
  game = { deaths = 0, project = not isTiled and read("ruin.ldtk") or nil }
  sparks.clear()
  if isTiled then
    loadTiled(state)
  else
    loadLDtk("Gate")
  end
  game.cameraX, game.cameraY = goalOfCamera()
end

function rooms.load()
  begin()
end

local function die()
  sparks.burst(player, 18, "red")
  world:restore(checkpoint) -- rooms come and go, coins are there again
  game.isDead, game.deaths = false, game.deaths + 1
end

function rooms.update(dt)
  game.isInWater = false
  if isTiled then
    stream()
    moveLifts(dt)
    for _, object in ipairs(world:overlapping(player, "Entities")) do
      game.isInWater = game.isInWater or object.type == "Water"
    end
  end
  hero.run(player, dt, input.axis("left", "a", "right", "d"), SPEED)
  world:update(dt)
  if game.isDead then
    die()
  end
  sparks.update(dt)
  local x, y = goalOfCamera()
  local share = math.min(1, 9 * dt)
  game.cameraX = game.cameraX + (x - game.cameraX) * share
  game.cameraY = game.cameraY + (y - game.cameraY) * share
end

function rooms.keypressed(key, isRepeat)
  if isRepeat then
    return
  elseif key == "space" or key == "up" or key == "w" then
    if game.isInWater then
      player.vy = -STROKE_SPEED
    else
      hero.jump(player, JUMP_SPEED)
    end
  elseif key == "down" or key == "s" then
    world:dropThrough(player)
  elseif key == "e" and not isTiled then
    goThroughDoor()
  elseif key == "c" and isTiled then
    local file = saved.read(FILE)
    begin(file and file.state)
  elseif key == "g" then
    isTiled = not isTiled
    begin()
  end
end

-- Drawing -----------------------------------------------------------------------------------------

local SLOPES = {
  left = { 0, 0, 1, 1, 0, 1 },
  right = { 0, 1, 1, 0, 1, 1 },
  topleft = { 0, 0, 1, 0, 0, 1 },
  topright = { 0, 0, 1, 0, 1, 1 },
}

-- What has no class: walls, slopes, ledges, fog.
local function drawPlain(object)
  local x, y, width, height = object.x, object.y, object.width, object.height
  if object.slope then
    local points = {}
    for i, share in ipairs(SLOPES[object.slope]) do
      points[i] = i % 2 == 1 and x + share * width or y + share * height
    end
    look.color("plum")
    love.graphics.polygon("fill", points)
  elseif object.sensor then
    look.color("silver", 0.3)
    love.graphics.rectangle("fill", x, y, width, height)
  else
    look.box(
      x,
      y,
      width,
      object.oneWay and math.min(height, 6) or height,
      object.oneWay and "lime" or "plum"
    )
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
  for _, list in ipairs({ level.sensors, level.solids }) do
    for _, object in ipairs(list) do
      if world:groupOf(object) and object.type ~= "Hero_spawn" then
        (object.draw or drawPlain)(object)
      end
    end
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
  local text = "coins %d, deaths %d; %d of %d rooms are there, with %d objects"
  return text:format(player.coins, game.deaths, there, #level.maps, #level.objects)
end

function rooms.camera()
  return game.cameraX, game.cameraY, SCALE
end

function rooms.draw()
  look.sky("blue", "plum")
  love.graphics.push()
  love.graphics.scale(SCALE)
  love.graphics.translate(-game.cameraX, -game.cameraY)
  drawWorld()
  love.graphics.pop()
  boxes.status({ "yellow", status() })
end

function rooms.report()
  local result = "rooms: x=%d y=%d coins=%d deaths=%d objects=%d editor=%s"
  local editor = isTiled and "tiled" or "ldtk"
  return result:format(player.x, player.y, player.coins, game.deaths, #level.objects, editor)
end

return rooms
