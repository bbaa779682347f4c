--- Reads a map of the editor Tiled, exported as Lua, or the table that STI makes of one: which
--- objects stand in it, in which groups. Nothing of the map is changed, nothing of it is drawn.
---
--- The parts: tiled/tileset.lua knows the tiles, tiled/tilelayer.lua and tiled/objectlayer.lua make
--- objects, tiled/merge.lua makes few of many, tiled/properties.lua reads what the map's author
--- wrote, tiled/report.lua tells what cannot be had.
---
--- Source: the exporter's format, https://doc.mapeditor.org/en/stable/manual/export-generic/#lua

local here = (...):match("^(.*)%.[^.]+$")
local check = require(here .. ".check")
local objectlayer = require(here .. ".tiled.objectlayer")
local properties = require(here .. ".tiled.properties")
local report = require(here .. ".tiled.report")
local tilelayer = require(here .. ".tiled.tilelayer")
local tileset = require(here .. ".tiled.tileset")

local tiled = {}

local WHERE = report.WHERE

-- Options -----------------------------------------------------------------------------------------

local OPTIONS = { "merge", "skipLayers", "solidLayers", "solidProperty", "solidTiles", "x", "y" }
local IN_OPTIONS = "world:loadTiled(map, options)"

-- The option of this name, a list of what `kind` says; empty if it is not given.
local function listOf(options, name, kind)
  local list = options[name]
  if list == nil then
    return {}
  elseif not check.isList(list) then
    check.fail(
      ("%s: %s must be a list of %s, got %s"):format(IN_OPTIONS, name, kind, check.show(list))
    )
  end
  return list
end

local function checkNames(options, name)
  local list = listOf(options, name, "layer names")
  for i = 1, #list do
    check.group(list[i], IN_OPTIONS, ("%s[%d]"):format(name, i))
  end
  return list
end

local function checkGids(options)
  local list, isSolid = listOf(options, "solidTiles", "gids"), {}
  for i = 1, #list do
    check.integer(list[i], ("solidTiles[%d]"):format(i), IN_OPTIONS, 1, 268435455)
    isSolid[list[i]] = true
  end
  return isSolid
end

local function checkOffset(options, name)
  local value = options[name]
  if value == nil then
    return 0
  end
  check.number(value, name, IN_OPTIONS)
  return value
end

local function checkSolidProperty(name)
  if name == nil then
    return "solid"
  elseif type(name) ~= "string" then
    check.fail(IN_OPTIONS .. ": solidProperty must be a name, got " .. check.show(name))
  end
  return name
end

local function checkOptions(options)
  if options == nil then
    options = {}
  end
  check.table(options, "options", IN_OPTIONS)
  check.names(options, "option", OPTIONS, IN_OPTIONS)
  if options.merge ~= nil then
    check.boolean(options.merge, "merge", IN_OPTIONS)
  end
  return {
    merge = options.merge ~= false,
    x = checkOffset(options, "x"),
    y = checkOffset(options, "y"),
    solidProperty = checkSolidProperty(options.solidProperty),
    isSolidGid = checkGids(options),
    solidLayers = checkNames(options, "solidLayers"),
    skipLayers = checkNames(options, "skipLayers"),
  }
end

-- The map -----------------------------------------------------------------------------------------

local SLASHES = "; love.filesystem divides folders by / on every system"

local function compile(path)
  if type(love) == "table" and love.filesystem then
    if not love.filesystem.getInfo(path, "file") then
      local hint = path:find("\\", 1, true) and SLASHES or ""
      return nil, "there is no such file" .. hint
    end
    return love.filesystem.load(path)
  end
  return loadfile(path)
end

local function run(chunk, path)
  local isRun, map = pcall(chunk)
  if not isRun then
    check.fail(("%s: cannot run %s: %s"):format(WHERE, check.show(path), tostring(map)))
  elseif type(map) ~= "table" then
    check.fail(
      ("%s: %s must return a map, got %s"):format(WHERE, check.show(path), check.show(map))
    )
  end
  return map
end

local function loadMap(path)
  if path:match("%.tm[xj]$") or path:match("%.json$") then
    check.fail(
      ("%s: %s must be exported as Lua: File > Export As, *.lua"):format(WHERE, check.show(path))
    )
  end
  local isRead, chunk, problem = pcall(compile, path)
  if not isRead or not chunk then
    problem = isRead and problem or chunk -- of the loader, or of pcall
    check.fail(("%s: cannot read %s: %s"):format(WHERE, check.show(path), tostring(problem)))
  end
  return (run(chunk, path))
end

local function checkMap(given)
  local map = given
  if type(given) == "string" then
    map = loadMap(given)
  elseif type(given) ~= "table" then
    check.fail(
      ("%s: map must be a Tiled map or the path of one, got %s"):format(WHERE, check.show(given))
    )
  end
  check.table(map.layers, "map.layers", WHERE)
  check.positive(map.tilewidth, "map.tilewidth", WHERE)
  check.positive(map.tileheight, "map.tileheight", WHERE)
  check.number(map.width, "map.width", WHERE, 0)
  check.number(map.height, "map.height", WHERE, 0)
  return map
end

-- Layers ------------------------------------------------------------------------------------------

local function isListed(list, layer)
  for i = 1, #list do
    if list[i] == layer.name or list[i] == layer.id then
      return true
    end
  end
  return false
end

local function checkLayer(layer, i)
  local what = ("map.layers[%d]"):format(i)
  check.table(layer, what, WHERE)
  if type(layer.name) ~= "string" then
    check.fail(("%s: %s.name must be a string, got %s"):format(WHERE, what, check.show(layer.name)))
  end
  local place = report.place(layer)
  if layer.offsetx ~= nil then
    check.number(layer.offsetx, "offsetx", place)
  end
  if layer.offsety ~= nil then
    check.number(layer.offsety, "offsety", place)
  end
  return place
end

-- What holds in a layer: where it lies, and what its properties and those around it say.
local function contextOf(reading, layer, outer, place)
  local own = properties.readLayer(layer.properties, place, reading.solidProperty)
  local context = {
    x = outer.x + (layer.offsetx or 0),
    y = outer.y + (layer.offsety or 0),
    isParallax = outer.isParallax or (layer.parallaxx or 1) ~= 1 or (layer.parallaxy or 1) ~= 1,
    traits = properties.combine(outer.traits, own),
    solid = own.solid,
  }
  if isListed(reading.solidLayers, layer) then
    context.solid = true
  elseif context.solid == nil then
    context.solid = outer.solid
  end
  return context
end

local function encodingOf(layer)
  local data = layer.data or layer.chunks and layer.chunks[1] and layer.chunks[1].data
  if type(data) == "string" then
    return (layer.compression and layer.compression .. ", " or "") .. (layer.encoding or "text")
  end
end

-- Why nothing of a layer can be read, or nil.
local function whyNot(reading, layer, context)
  local orientation = reading.map.orientation or "orthogonal"
  local encoding = encodingOf(layer)
  if orientation ~= "orthogonal" then
    return orientation .. " map: only orthogonal ones have boxes"
  elseif layer.type == "imagelayer" and context.solid then
    return "image layer: it has no boxes"
  elseif layer.type == "tilelayer" and encoding then
    return ("encoded data (%s): choose CSV as Tile Layer Format in the map's properties"):format(
      encoding
    )
  end
end

local function readNothing(_, _, _) end

local KINDS = {
  tilelayer = tilelayer.read,
  objectgroup = objectlayer.read,
  imagelayer = readNothing,
  customlayer = readNothing, -- STI's, for the game's own drawing
}

local function readLeaf(reading, layer, context)
  local reason = whyNot(reading, layer, context)
  if not reason and not KINDS[layer.type] then
    reason = "unknown type of layer: " .. check.show(layer.type)
  end
  if reason then
    if context.solid ~= false then
      report.add(reading, "layer", layer, layer.id, reason).name = layer.name
    end
    return
  end
  if context.traits.group == nil then
    context.traits.group = layer.name
  end
  local before = #reading.objects
  KINDS[layer.type](reading, layer, context)
  if context.isParallax and #reading.objects > before then
    local entry =
      report.add(reading, "layer", layer, layer.id, "parallax: its objects do not drift")
    entry.name = layer.name
  end
end

local function readLayers(reading, layers, outer)
  for i, layer in ipairs(layers) do
    local place = checkLayer(layer, i)
    if not isListed(reading.skipLayers, layer) then
      local context = contextOf(reading, layer, outer, place)
      if layer.type == "group" then
        check.table(layer.layers, "layers", place)
        readLayers(reading, layer.layers, context)
      else
        readLeaf(reading, layer, context)
      end
    end
  end
end

-- A table may hold itself, what Tiled exports does not: such a map would have no end.
local function checkNesting(layers, around)
  around[layers] = true
  for _, layer in ipairs(layers) do
    local inner = type(layer) == "table" and layer.layers
    if type(inner) == "table" then
      if around[inner] then
        check.fail(
          ("%s: layer %s: layers must not hold that layer itself"):format(
            WHERE,
            check.show(layer.name)
          )
        )
      end
      checkNesting(inner, around)
    end
  end
  around[layers] = nil
end

local function isThere(layers, wanted, names)
  for i, layer in ipairs(layers) do
    checkLayer(layer, i)
    names[#names + 1] = check.show(layer.name)
    if wanted == layer.name or wanted == layer.id then
      return true
    elseif type(layer.layers) == "table" and isThere(layer.layers, wanted, names) then
      return true
    end
  end
  return false
end

-- A misspelt layer would only show in the game, if at all.
local function checkListed(reading, option)
  for i, wanted in ipairs(reading[option]) do
    local names = {}
    if not isThere(reading.map.layers, wanted, names) then
      local what = ("%s: %s[%d] must be a layer of the map, got %s; they are "):format(
        IN_OPTIONS,
        option,
        i,
        check.show(wanted)
      )
      check.fail(what .. table.concat(names, ", "))
    end
  end
end

-- Reading -----------------------------------------------------------------------------------------

local function checkSolidTiles(reading, list)
  for i, gid in ipairs(list or {}) do
    if not tileset.isThere(reading.tilesets, gid) then
      local what = "%s: solidTiles[%d] must be a gid of one of the tilesets, got %s"
      check.fail(what:format(IN_OPTIONS, i, check.show(gid)))
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

local function newReading(map, options)
  local reading = options
  reading.map, reading.tilesets = map, tileset.index(map)
  reading.kinds, reading.reportedSets = {}, {}
  reading.objects, reading.groupOf, reading.groups, reading.hasGroup = {}, {}, {}, {}
  reading.unsupported, reading.tiles, reading.rectangles = {}, 0, 0
  reading.add, reading.addGroup, reading.extend = add, addGroup, extend
  return reading
end

---@class physics.TiledOptions
---@field x? number px, default 0: where the map's left edge goes
---@field y? number px, default 0: where its upper edge goes
---@field solidProperty? string default "solid": name of the property that makes solid
---@field solidLayers? (string|integer)[] names or ids of layers: a yes, not their own `solid`
---@field solidTiles? integer[] gids: a yes instead of the own `solid` of these tiles
---@field skipLayers? (string|integer)[] names or ids of layers that are left out
---@field merge? boolean default true: equal solid tiles become few; false: each one is an object

--- What a map gave to a world.
---@class physics.Level
---@field objects physics.Object[] all its objects, in the order of the layers
---@field named table<string, physics.Object> of all objects of a name the first
---@field tiles integer boxes of solid tiles in the map
---@field rectangles integer what has become of them
---@field unsupported physics.Unsupported[] what could not be had, in the order of the layers
---@field x number px, left edge of the map
---@field y number px, upper edge
---@field width number px; of an infinite map, the parts that were exported
---@field height number px
---@field map table the map

--- A part of a map that is not in the world, or not as the editor shows it.
---@class physics.Unsupported
---@field kind "layer"|"object"|"tile"|"tileset"
---@field layer string name of the layer; where a tile or tileset was found first
---@field id integer? of the layer, the object, or the tile in its tileset; a tileset's firstgid
---@field reason string
---@field name string? of the object, the layer or the tileset, or class of the tile
---@field object table? the object as it stands in the map
---@field x number? px, where the object is, with all offsets
---@field y number? px
---@field tileset string? name of the tile's tileset
---@field shape integer? id of the collision shape of the tile

local function newLevel(reading)
  local map = reading.map
  local box = reading.box or { 0, 0, map.width, map.height }
  local level = {
    objects = reading.objects,
    named = {},
    tiles = reading.tiles,
    rectangles = reading.rectangles,
    unsupported = reading.unsupported,
    x = reading.x + (map.offsetx or 0) + box[1] * map.tilewidth,
    y = reading.y + (map.offsety or 0) + box[2] * map.tileheight,
    width = (box[3] - box[1]) * map.tilewidth,
    height = (box[4] - box[2]) * map.tileheight,
    map = map,
  }
  for _, object in ipairs(level.objects) do
    if object.name and object.tiled.object and not level.named[object.name] then
      level.named[object.name] = object
    end
  end
  return level
end

--- Reads a map and adds nothing: see `world:loadTiled`.
---@param given table|string
---@param options physics.TiledOptions?
---@return physics.Level level
---@return (string|number)[] groupOf the group of each of its objects
---@return (string|number)[] groups all groups that it needs, also empty ones
function tiled.read(given, options)
  local checked = checkOptions(options)
  local reading = newReading(checkMap(given), checked)
  checkNesting(reading.map.layers, {})
  checkListed(reading, "solidLayers")
  checkListed(reading, "skipLayers")
  checkSolidTiles(reading, options and options.solidTiles)
  local map = reading.map
  readLayers(reading, map.layers, {
    -- STI moves a map as a whole by these.
    x = reading.x + (map.offsetx or 0),
    y = reading.y + (map.offsety or 0),
    traits = properties.read(nil, WHERE, reading.solidProperty),
  })
  return newLevel(reading), reading.groupOf, reading.groups
end

return tiled
