--- For specs of saved games: worlds of several rooms at random, and a script that walks through
--- them, digs, builds, takes things, shifts the world. All that it does follows from the number of
--- the step and from what is in the world.

local newRandom = require("spec.support.random").new
local physics = require("physics")

local journey = {}

local COLUMNS, ROWS, SIZE, COUNT = 12, 8, 16, 4 -- of a room; px; rooms
local WIDTH = COLUMNS * SIZE
local TILESET = { name = "set", firstgid = 1, tilecount = 3, tilewidth = SIZE, tileheight = SIZE }
TILESET.tiles = { { id = 1, properties = { friction = 0.1 } } }

local function newCells(random)
  local data = {}
  for i = 1, COLUMNS * ROWS do
    local isFloor = i > COLUMNS * (ROWS - 2)
    data[i] = isFloor and random:pick({ 1, 1, 1, 2 }) or random:chance(0.1) and 1 or 0
  end
  return data
end

-- A room as Tiled exports it: ground, a layer of things that are taken, and crates.
local function newRoom(random)
  local things = {}
  for id = 1, random:integer(2, 6) do
    local x, y = random:integer(0, WIDTH - 12), random:integer(0, 60)
    local thing = { id = id, name = "thing" .. id, shape = "rectangle", rotation = 0 }
    thing.type, thing.x, thing.y = random:pick({ "Coin", "Crate" }), x, y
    thing.width, thing.height = random:integer(6, 12), random:integer(6, 12)
    thing.properties = { mass = thing.type == "Crate" and 2 or nil }
    things[id] = thing
  end
  local ground = { type = "tilelayer", name = "Ground", id = 1, width = COLUMNS, height = ROWS }
  ground.data = newCells(random)
  local layers = { ground, { type = "objectgroup", name = "Things", id = 2, objects = things } }
  local map = { width = COLUMNS, height = ROWS, tilewidth = SIZE, tileheight = SIZE }
  map.layers, map.tilesets = layers, { TILESET }
  return map
end

--- Returns the rooms and the earth of a seed: what is the same in all its worlds.
function journey.new(seed)
  local random, self = newRandom(seed), { seed = seed, rooms = {}, maps = {}, earth = {} }
  for n = 1, COUNT do
    self.rooms["maps/" .. n .. ".lua"] = newRoom(random)
    local x = (n - 1) * WIDTH
    self.maps[n] = { fileName = n .. ".tmx", x = x, y = 0, width = WIDTH, height = ROWS * SIZE }
  end
  for row = 1, 6 do
    self.earth[row] = {}
    for column = 1, COUNT * COLUMNS do
      self.earth[row][column] = random:pick({ "#", "#", "#", "i", "=", "." })
    end
  end
  return self
end

-- Calls f while the rooms are files.
local function withFiles(self, f, ...)
  local before = rawget(_G, "love")
  local filesystem = {}
  function filesystem.getInfo(path)
    return self.rooms[path]
  end
  function filesystem.load(path)
    return function()
      return self.rooms[path]
    end
  end
  rawset(_G, "love", { filesystem = filesystem })
  local isDone, result, second = pcall(f, ...)
  rawset(_G, "love", before)
  assert(isDone, result)
  return result, second
end

--- Returns a new world in which no room is there yet, its level and its earth.
function journey.newWorld(self)
  local world = physics.newWorld({ gravity = 700 })
  local options = { folder = "maps", later = true, kinds = { Crate = "dynamic" } }
  local level = world:loadTiled({ type = "world", maps = self.maps }, options)
  local solid = { ["#"] = true, i = { friction = 0 }, ["="] = { oneWay = "top" } }
  local tiles = world:addTiles("earth", self.earth, nil, SIZE, { y = 8 * SIZE, solid = solid })
  world.objects.hero = { x = 40, y = 20, width = 10, height = 14, nudge = 2 }
  return { world = world, level = level, tiles = tiles }
end

-- Lets those rooms be there that are near the hero.
local function stream(one)
  local hero = one.world.objects.hero
  for _, map in ipairs(one.level.maps) do
    local distance = math.abs(hero.x - map.x - WIDTH / 2)
    if map.level and distance > 1.3 * WIDTH then
      one.level:removeMap(map.name)
    elseif not map.level and distance < 0.9 * WIDTH then
      one.level:addMap(map.name)
    end
  end
end

-- Digs or builds a cell of a layer.
local function change(random, tiles, values)
  local column = random:integer(tiles.firstColumn, tiles.firstColumn + tiles.columns - 1)
  local row = random:integer(tiles.firstRow, tiles.firstRow + tiles.rows - 1)
  tiles:setTile(column, row, random:pick(values))
end

local ACTS = {
  function(random, one)
    change(random, one.tiles, { ".", ".", "#", "i", "=" })
  end,
  function(random, one)
    for _, map in ipairs(one.level.maps) do
      if map.level then
        change(random, map.level.tileLayers.Ground, { 0, 0, 1, 2 })
      end
    end
  end,
  function(random, one)
    local things = one.world.objects.Things or {}
    if #things > 0 then
      one.world:remove(things[random:integer(1, #things)])
    end
  end,
  function(random, one)
    local hero = one.world.objects.hero
    one.world:add("mobs", { x = hero.x + random:integer(-40, 40), y = 0, width = 9, height = 9 })
  end,
  function(random, one)
    one.world:shift(random:integer(-3, 3) * 16, random:integer(-1, 1) * 16)
  end,
  function(random, one) -- (never all of it: what is dug then is in no state)
    if one.tiles:unload(random:integer(1, 5)) == 0 or random:chance(0.6) then
      one.tiles:load(random:integer(1, 9))
    end
  end,
}

--- Makes step n of the script in a world.
function journey.step(self, one, n)
  local random = newRandom(self.seed * 1000 + n)
  withFiles(self, stream, one)
  if random:chance(0.4) then
    random:pick(ACTS)(random, one)
  end
  local hero = one.world.objects.hero
  hero.vx = math.floor(n / 60) % 3 == 2 and -260 or 260
  if hero.touching and hero.touching.bottom and random:chance(0.2) then
    hero.vy = -260
  end
  if hero.y - one.tiles.y > 400 or n % 150 == 149 then
    hero.x, hero.y, hero.vy = one.tiles.x + random:integer(0, COUNT) * WIDTH, one.tiles.y - 100, 0
  end
  one.world:update(1 / 60)
end

--- Makes steps `first` to `last`. Returns the hash after each.
function journey.play(self, one, first, last)
  local list = {}
  for n = first, last do
    journey.step(self, one, n)
    list[#list + 1] = one.world:hash()
  end
  return list
end

--- Puts a world back to a state. Returns what `restore` returns.
function journey.restore(self, one, state)
  return withFiles(self, one.world.restore, one.world, state)
end

return journey
