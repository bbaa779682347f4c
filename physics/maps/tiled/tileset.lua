--- Finds the tile of a gid: its tileset, how it is flipped, where its collision rectangles are.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local properties = require(root .. ".maps.properties")
local report = require(root .. ".maps.tiled.report")
local shapes = require(root .. ".maps.tiled.shapes")
local source = require(root .. ".maps.tiled.source")

local floor, min = math.floor, math.min

local tileset = {}

-- The upper bits of a gid. Arithmetic replaces bit operations, which differ between the Luas.
local FLIP_X = 2147483648
local FLIP_Y = 1073741824
local TRANSPOSE = 536870912 -- x and y swapped, before the other two
local HEXAGONAL = 268435456 -- means nothing on orthogonal maps

--- A tile as it stands in a layer.
---@class physics.Tile
---@field gid number without the bits that flip it
---@field isFlippedX boolean
---@field isFlippedY boolean
---@field isTransposed boolean
---@field kind physics.TileKind what all that are flipped otherwise have in common

--- A tile of a tileset.
---@class physics.TileKind
---@field set table the tileset of the map
---@field id integer
---@field width number px
---@field height number px
---@field type string? its class in the editor
---@field traits physics.Traits
---@field shapes table[]? its collision rectangles, nil: none were drawn
---@field problems table[] what of it is not supported, `{ id =, reason = }`
---@field isReported boolean were they told
---@field hasProperties boolean
---@field problem string? why its external tileset is not known

local function take(gid, bit)
  if gid >= bit then
    return gid - bit, true
  end
  return gid, false
end

--- Splits a gid into the tile's own gid and its flips.
---@param gid number integer in 0..2^32 - 1
---@return number gid without the bits that flip
---@return boolean isFlippedX
---@return boolean isFlippedY
---@return boolean isTransposed
function tileset.decode(gid)
  local withoutX, isFlippedX = take(gid, FLIP_X)
  local withoutY, isFlippedY = take(withoutX, FLIP_Y)
  local withoutTurns, isTransposed = take(withoutY, TRANSPOSE)
  return (take(withoutTurns, HEXAGONAL)), isFlippedX, isFlippedY, isTransposed
end

-- Tilesets ----------------------------------------------------------------------------------------

local function placeOf(set, id)
  return ("%s: tileset %s, tile %d"):format(report.WHERE, check.show(set.name or ""), id)
end

-- Returns the exported tiles of a tileset by id, and the first gid after it (nil: not known).
local function indexTiles(set, place)
  local byId, last = {}, (set.tilecount or 0) - 1
  if set.tiles ~= nil then
    check.table(set.tiles, "tiles", place)
    for i, tile in ipairs(set.tiles) do
      check.table(tile, ("tiles[%d]"):format(i), place)
      check.integer(tile.id, ("tiles[%d].id"):format(i), place, 0, HEXAGONAL)
      byId[tile.id] = tile
      last = last > tile.id and last or tile.id
    end
  end
  return byId, set.tilecount and set.firstgid + last + 1
end

local function checkSet(set, i)
  local what = ("map.tilesets[%d]"):format(i)
  check.integer(set.firstgid, what .. ".firstgid", report.WHERE, 1, HEXAGONAL)
  local place = ("%s: tileset %s"):format(report.WHERE, check.show(set.name or i))
  -- An export without "Embed tilesets" has only the file name of the tileset.
  if set.tilewidth ~= nil or set.filename == nil then
    check.positive(set.tilewidth, "tilewidth", place)
    check.positive(set.tileheight, "tileheight", place)
  end
  if set.tilecount ~= nil then
    check.integer(set.tilecount, "tilecount", place, 0, HEXAGONAL)
  end
  if set.tileoffset ~= nil then
    check.table(set.tileoffset, "tileoffset", place)
    check.number(set.tileoffset.x, "tileoffset.x", place)
    check.number(set.tileoffset.y, "tileoffset.y", place)
  end
  return place
end

--- Returns the tilesets of a map, `{ set =, byId =, behind =, place = }`, highest gids first.
--- Errors: there is no list; a tileset has no firstgid or size.
---@param map table
---@param folder string? where the map lies
---@return table[]
function tileset.index(map, folder)
  check.table(map.tilesets, "map.tilesets", report.WHERE)
  local index = {}
  for i, given in ipairs(map.tilesets) do
    check.table(given, ("map.tilesets[%d]"):format(i), report.WHERE)
    local set, problem = source.tileset(given, folder)
    local byId, behind = indexTiles(set, checkSet(set, i))
    index[i] = { set = set, byId = byId, behind = behind, place = i, problem = problem }
  end
  table.sort(index, function(a, b)
    -- An empty tileset has the firstgid of the next one.
    return a.set.firstgid > b.set.firstgid or a.set.firstgid == b.set.firstgid and a.place > b.place
  end)
  return index
end

local function find(index, gid)
  for i = 1, #index do
    local entry = index[i]
    if gid >= entry.set.firstgid then
      -- After the last tileset there is none; after the others comes the next one.
      local isBehind = i == 1 and entry.behind and gid >= entry.behind
      return not isBehind and entry or nil
    end
  end
end

--- Returns whether a gid, without the bits that flip it, belongs to one of the tilesets.
---@param index table[] what `tileset.index` returned
---@param gid number
---@return boolean
function tileset.isThere(index, gid)
  return find(index, gid) ~= nil
end

-- Collision shapes --------------------------------------------------------------------------------

local function readShape(kind, object, place, rules)
  check.table(object, "a collision shape", place)
  place = ("%s, shape %s"):format(place, tostring(object.id))
  report.checkObject(object, place)
  local traits = properties.read(object.properties, place, rules)
  local boxes, reason = shapes.boxes(object, place)
  if traits.solid == false then
    return
  elseif not boxes then
    kind.problems[#kind.problems + 1] = { id = object.id, reason = reason }
    return
  end
  for _, box in ipairs(boxes) do
    box.traits = traits
    kind.shapes[#kind.shapes + 1] = box
  end
  for _, text in ipairs(traits.problems) do
    kind.problems[#kind.problems + 1] = { id = object.id, reason = text }
  end
end

local function readShapes(kind, objectGroup, place, rules)
  if objectGroup == nil then
    return
  end
  check.table(objectGroup, "objectGroup", place)
  check.table(objectGroup.objects, "objectGroup.objects", place)
  if #objectGroup.objects > 0 then
    kind.shapes = {}
  end
  for _, object in ipairs(objectGroup.objects) do
    readShape(kind, object, place, rules)
  end
end

-- Tiles -------------------------------------------------------------------------------------------

local function newKind(reading, entry, id)
  local set, tile, map = entry.set, entry.byId[id] or {}, reading.map
  local place = placeOf(set, id)
  local kind = { set = set, id = id, problems = {}, isReported = false, problem = entry.problem }
  kind.width = tile.width or set.tilewidth or map.tilewidth
  kind.height = tile.height or set.tileheight or map.tileheight
  check.positive(kind.width, "width", place)
  check.positive(kind.height, "height", place)
  kind.type = report.typeOf(tile)
  kind.traits = properties.read(tile.properties, place, reading.rules)
  kind.hasProperties = not properties.isEmpty(tile.properties)
  for _, text in ipairs(kind.traits.problems) do
    kind.problems[#kind.problems + 1] = { reason = text }
  end
  readShapes(kind, tile.objectGroup, place, reading.rules)
  return kind
end

local function kindOf(reading, gid)
  local kind = reading.kinds[gid]
  if kind == nil then
    local entry = find(reading.tilesets, gid)
    if not entry then
      return nil
    end
    kind = newKind(reading, entry, gid - entry.set.firstgid)
    reading.kinds[gid] = kind
  end
  return kind
end

--- Returns the tile of a gid; nil for 0, which is no tile. Errors: it is not a gid, or belongs to
--- no tileset.
---@param reading table
---@param value any the gid as it stands in the map
---@param place string how an error names where it stands
---@return physics.Tile?
function tileset.tile(reading, value, place)
  if type(value) ~= "number" or value < 0 or floor(value) ~= value or value >= 2 * FLIP_X then
    check.fail(("%s must be a gid, got %s"):format(place, check.show(value)))
  end
  local gid, isFlippedX, isFlippedY, isTransposed = tileset.decode(value)
  if gid == 0 then
    return nil
  end
  local kind = kindOf(reading, gid)
  if not kind then
    check.fail(("%s must be a gid of one of the tilesets, got %s"):format(place, check.show(gid)))
  end
  return {
    gid = gid,
    kind = kind,
    isFlippedX = isFlippedX,
    isFlippedY = isFlippedY,
    isTransposed = isTransposed,
  }
end

--- Reports, once, that a tileset is not in the export.
---@param reading table
---@param layer table where one of its tiles was found first
---@param kind physics.TileKind
function tileset.reportExternal(reading, layer, kind)
  local set = kind.set
  if set.tilewidth ~= nil or reading.reportedSets[set] then
    return
  end
  reading.reportedSets[set] = true
  local reason = kind.problem or "what its tiles are is not in this export, embed it"
  reason = ("external (%s): "):format(check.show(set.filename or set.exportfilename)) .. reason
  report.add(reading, "tileset", layer, set.firstgid, reason).name = set.name
end

--- Reports, once, what of a tile is not supported.
---@param reading table
---@param layer table where it was found first
---@param kind physics.TileKind
function tileset.report(reading, layer, kind)
  if kind.isReported then
    return
  end
  kind.isReported = true
  for _, problem in ipairs(kind.problems) do
    local entry = report.add(reading, "tile", layer, kind.id, problem.reason)
    entry.tileset, entry.shape, entry.name = kind.set.name, problem.id, kind.type
  end
end

--- Returns where a rectangle of a tile lies on the map. The tile is drawn in a box with these left
--- and lower edges. Turned tiles keep their lower left corner, as the editor draws them.
---@param tile physics.Tile
---@param left number px
---@param bottom number px
---@param width number px, of the box in which it is drawn
---@param height number px
---@param x number px, in the tile's image
---@param y number px
---@param w number px
---@param h number px
---@return number x px
---@return number y px
---@return number width px
---@return number height px
function tileset.place(tile, left, bottom, width, height, x, y, w, h)
  local kind = tile.kind
  local imageWidth, imageHeight = width, height
  if kind.set.fillmode == "preserve-aspect-fit" then
    local scale = min(width / kind.width, height / kind.height)
    imageWidth, imageHeight = kind.width * scale, kind.height * scale
  end
  local offset = kind.set.tileoffset or { x = 0, y = 0 }
  left = left + offset.x * imageWidth / kind.width
  bottom = bottom + offset.y * imageHeight / kind.height
  x, w = x * imageWidth / kind.width, w * imageWidth / kind.width
  y, h = y * imageHeight / kind.height, h * imageHeight / kind.height
  if tile.isTransposed then
    local oldX, oldW, oldWidth, oldImageWidth = x, w, width, imageWidth
    x, w, width, imageWidth = y, h, height, imageHeight
    y, h, height, imageHeight = oldX, oldW, oldWidth, oldImageWidth
  end
  if tile.isFlippedX then
    x = imageWidth - x - w
  end
  if tile.isFlippedY then
    y = imageHeight - y - h
  end
  x = left + (width - imageWidth) / 2 + x
  y = bottom - height + (height - imageHeight) / 2 + y
  return x, y, w, h
end

return tileset
