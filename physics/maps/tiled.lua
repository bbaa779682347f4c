--- Reads a map of the editor Tiled, exported as Lua, or the table that STI makes of one: which
--- objects stand in it, in which groups. Nothing of the map is changed, nothing of it is drawn.
---
--- The parts: tiled/options.lua checks what is asked for, tiled/source.lua finds files,
--- tiled/layers.lua goes through the layers, tiled/tilelayer.lua and tiled/objectlayer.lua make
--- objects, tiled/tileset.lua knows the tiles, tiled/shapes.lua makes boxes of shapes,
--- tiled/decode.lua unpacks, tiled/report.lua tells what cannot be had.
---
--- Source: the exporter's format, https://doc.mapeditor.org/en/stable/manual/export-generic/#lua

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local layers = require(root .. ".maps.tiled.layers")
local optionList = require(root .. ".maps.tiled.options")
local properties = require(root .. ".maps.properties")
local report = require(root .. ".maps.tiled.report")
local source = require(root .. ".maps.tiled.source")
local tileset = require(root .. ".maps.tiled.tileset")

local tiled = {}

local function checkSolidTiles(reading)
  for i, gid in ipairs(reading.solidTiles or {}) do
    if not tileset.isThere(reading.tilesets, gid) then
      local what = "%s: solidTiles[%d] must be a gid of one of the tilesets, got %s"
      check.fail(what:format(optionList.WHERE, i, check.show(gid)))
    end
  end
end

local function addGroup(reading, group)
  if not reading.hasGroup[group] then
    reading.hasGroup[group] = true
    reading.groups[#reading.groups + 1] = group
  end
end

local function add(reading, group, object)
  addGroup(reading, group)
  local n = #reading.objects + 1
  reading.objects[n], reading.groupOf[n] = object, group
end

local function addTiles(reading, layer, tiles)
  reading.tiles = reading.tiles + tiles.tiles
  reading.rectangles = reading.rectangles + tiles.rectangles
  reading.tileLayers[layer.name] = reading.tileLayers[layer.name] or tiles
  reading.allTiles[#reading.allTiles + 1] = tiles
end

-- The box of the map in tiles grows by a part of an infinite layer.
local function extend(reading, left, top, right, bottom)
  local box = reading.box
  if not box then
    reading.box = { left, top, right, bottom }
    return
  end
  box[1], box[2] = math.min(box[1], left), math.min(box[2], top)
  box[3], box[4] = math.max(box[3], right), math.max(box[4], bottom)
end

local function newReading(given, options)
  local reading = optionList.check(options)
  local map, folder = source.load(given)
  reading.map, reading.folder = map, reading.folder or folder
  reading.tilesets = tileset.index(map, reading.folder)
  reading.kinds, reading.reportedSets = {}, {}
  reading.objects, reading.groupOf, reading.groups, reading.hasGroup = {}, {}, {}, {}
  reading.points, reading.lines, reading.decoration, reading.solid = {}, {}, {}, {}
  reading.tileLayers, reading.allTiles = {}, {}
  reading.unsupported, reading.tiles, reading.rectangles = {}, 0, 0
  reading.add, reading.addGroup, reading.addTiles, reading.extend = add, addGroup, addTiles, extend
  return reading
end

--- What a map gave to a world.
---@class physics.Level
---@field objects physics.Object[] all its objects, in the order of the layers
---@field named table<string, any> the first object of a name; without one the first point or line
---@field points physics.Mark[] points, and rectangles without a size
---@field lines physics.Mark[] polylines
---@field decoration table[] tile objects about which the map says nothing: not in the world
---@field solidLayers physics.SolidLayer[] which layers were taken for solid, and why
---@field tileLayers table<string, physics.Tiles> the tiles of each layer by its name, to dig in
---@field tiles integer boxes of solid tiles in the map
---@field rectangles integer what has become of them
---@field unsupported physics.Unsupported[] what could not be had, in the order of the layers
---@field x number px, left edge of the map
---@field y number px, upper edge
---@field width number px; of an infinite map, the parts that were exported
---@field height number px
---@field map table the map

--- A mark of the map that is no object of the world: a point, or a line. The properties that it has
--- in the editor are its fields.
---@class physics.Mark
---@field x number px, with all offsets
---@field y number px
---@field name string? as in the editor
---@field type string? its class
---@field points table[]? of a line: { x =, y = }, px, with all offsets
---@field tiled table its `layer` and `object` in the map

---@class physics.SolidLayer
---@field name string
---@field id integer|string?
---@field reason string the option, the property or the name that says so
---@field layer table the layer of the map

--- A part of a map that is not in the world, or not as the editor shows it.
---@class physics.Unsupported
---@field kind "layer"|"object"|"tile"|"tileset"
---@field layer string name of the layer; where a tile or tileset was found first
---@field id integer|string? of the layer, the object, or the tile in its tileset; a tileset's
---  firstgid; in LDtk an iid
---@field reason string
---@field name string? of the object, the layer or the tileset, or class of the tile
---@field object table? the object as it stands in the map
---@field x number? px, where the object is, with all offsets
---@field y number? px
---@field tileset string? name of the tile's tileset
---@field shape integer? id of the collision shape of the tile

local function nameAll(named, list)
  for _, thing in ipairs(list) do
    if thing.name and thing.tiled.object and not named[thing.name] then
      named[thing.name] = thing
    end
  end
end

local function newLevel(reading)
  local map = reading.map
  local box = reading.box or { 0, 0, map.width, map.height }
  local level = {
    objects = reading.objects,
    named = {},
    points = reading.points,
    lines = reading.lines,
    decoration = reading.decoration,
    solidLayers = reading.solid,
    tileLayers = reading.tileLayers,
    tiles = reading.tiles,
    rectangles = reading.rectangles,
    unsupported = reading.unsupported,
    x = reading.x + (map.offsetx or 0) + box[1] * map.tilewidth,
    y = reading.y + (map.offsety or 0) + box[2] * map.tileheight,
    width = (box[3] - box[1]) * map.tilewidth,
    height = (box[4] - box[2]) * map.tileheight,
    map = map,
  }
  nameAll(level.named, level.objects)
  nameAll(level.named, level.points)
  nameAll(level.named, level.lines)
  return level
end

--- Reads a map and adds nothing: see `world:loadTiled`.
---@param given table|string
---@param options physics.TiledOptions?
---@return physics.Level level
---@return (string|number)[] groupOf the group of each of its objects
---@return (string|number)[] groups all groups that it needs, also empty ones
---@return physics.Tiles[] tiles of all tile layers
function tiled.read(given, options)
  local reading = newReading(given, options)
  local map = reading.map
  layers.checkNesting(map.layers)
  layers.checkListed(reading, "solidLayers")
  layers.checkListed(reading, "skipLayers")
  layers.checkListed(reading, "onlyLayers")
  checkSolidTiles(reading)
  layers.read(reading, {
    -- STI moves a map as a whole by these.
    x = reading.x + (map.offsetx or 0),
    y = reading.y + (map.offsety or 0),
    traits = properties.read(nil, report.WHERE, reading.rules),
  })
  return newLevel(reading), reading.groupOf, reading.groups, reading.allTiles
end

return tiled
