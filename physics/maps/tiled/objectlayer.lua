--- Reads an object layer: one object for each rectangle and each tile object.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".check")
local properties = require(root .. ".maps.tiled.properties")
local report = require(root .. ".maps.tiled.report")
local tileset = require(root .. ".maps.tiled.tileset")

local objectlayer = {}

-- Where the left and lower edges of a tile object are, as shares of its size from its x and y.
local ALIGNMENTS = {
  topleft = { 0, 1 },
  top = { 0.5, 1 },
  topright = { 1, 1 },
  left = { 0, 0.5 },
  center = { 0.5, 0.5 },
  right = { 1, 0.5 },
  bottomleft = { 0, 0 },
  bottom = { 0.5, 0 },
  bottomright = { 1, 0 },
}
ALIGNMENTS.unspecified = ALIGNMENTS.bottomleft

local function addReport(state, object, reason)
  local entry = report.add(state.reading, "object", state.layer, object.id, reason)
  entry.name, entry.object = object.name, object
  entry.x, entry.y = state.context.x + object.x, state.context.y + object.y
end

-- The box of a tile object: the collision rectangle of its tile if there is just one, else the
-- whole tile.
local function boxOfTile(state, object, tile)
  local kind = tile.kind
  local aligned = ALIGNMENTS[kind.set.objectalignment or "unspecified"] or ALIGNMENTS.unspecified
  local left = object.x - aligned[1] * object.width
  local bottom = object.y + aligned[2] * object.height
  local shapes = kind.shapes or {}
  local x, y, width, height = 0, 0, kind.width, kind.height
  if #shapes == 1 then
    x, y, width, height = shapes[1].x, shapes[1].y, shapes[1].width, shapes[1].height
  elseif #shapes > 1 then
    addReport(state, object, ("its tile has %d rectangles: the whole tile counts"):format(#shapes))
  end
  return tileset.place(tile, left, bottom, object.width, object.height, x, y, width, height)
end

local function traitsOf(state, own, tile)
  local traits = state.context.traits
  if tile then
    traits = properties.combine(traits, tile.kind.traits)
    local shapes = tile.kind.shapes
    if shapes and #shapes == 1 then
      traits = properties.combine(traits, shapes[1].traits)
    end
  end
  return properties.combine(traits, own)
end

local function newObject(state, object, traits, tile)
  local x, y, width, height = object.x, object.y, object.width, object.height
  if tile then
    x, y, width, height = boxOfTile(state, object, tile)
  end
  local context = state.context
  local made = properties.newObject(traits.fields, context.x + x, context.y + y, width, height)
  if object.name ~= "" then
    made.name = object.name
  end
  made.type = report.typeOf(object) or made.type or tile and tile.kind.type
  made.tiled = { layer = state.layer, object = object, gid = tile and tile.gid }
  return made
end

-- Whoever says no is right; without a word an object is in.
local function isOut(state, own, tile)
  return state.context.solid == false
    or own.solid == false
    or tile and tile.kind.traits.solid == false
end

local function placeOf(state, object, i)
  if type(object) ~= "table" then
    check.fail(
      ("%s: objects[%d] must be a table, got %s"):format(
        report.place(state.layer),
        i,
        check.show(object)
      )
    )
  end
  local name = object.name and object.name ~= "" and " " .. check.show(object.name) or ""
  return ("%s, object %s%s"):format(report.place(state.layer), tostring(object.id), name)
end

local function readObject(state, object, i)
  local reading, place = state.reading, placeOf(state, object, i)
  report.checkGeometry(object, place)
  local own = properties.read(object.properties, place, reading.solidProperty)
  local tile = object.gid ~= nil and tileset.tile(reading, object.gid, place .. ": gid") or nil
  if isOut(state, own, tile) then
    return
  end
  local reason = tileset.whyNoBox(object)
  if reason then
    addReport(state, object, reason)
    return
  end
  for _, name in ipairs(own.ignored) do
    addReport(state, object, report.ignored(name))
  end
  if tile then
    tileset.reportExternal(reading, state.layer, tile.kind.set)
    tileset.report(reading, state.layer, tile.kind)
  end
  local traits = traitsOf(state, own, tile)
  reading.add(reading, traits.group, newObject(state, object, traits, tile))
end

--- Reads an object layer.
--- Errors: a position, a size, a gid or a property that cannot be used.
---@param reading table
---@param layer table
---@param context table what the layers around it and it itself say
function objectlayer.read(reading, layer, context)
  local state = { reading = reading, layer = layer, context = context }
  check.table(layer.objects, "objects", report.place(layer))
  if context.solid ~= false then
    reading.addGroup(reading, context.traits.group)
  end
  for i, object in ipairs(layer.objects) do
    readObject(state, object, i)
  end
end

return objectlayer
