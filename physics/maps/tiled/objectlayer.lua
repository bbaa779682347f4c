--- Reads an object layer: makes boxes of rectangles, tile objects and polygons, and circles; lists
--- points and lines.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local properties = require(root .. ".maps.properties")
local report = require(root .. ".maps.tiled.report")
local shapes = require(root .. ".maps.tiled.shapes")
local tileset = require(root .. ".maps.tiled.tileset")

local objectlayer = {}

-- Where the left and lower edges of a tile object are from its x and y, as fractions of its size.
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

-- Boxes -------------------------------------------------------------------------------------------

-- Returns the box of a tile object: the collision rectangle of its tile if there is just one, else
-- the whole tile.
local function boxOfTile(state, object, tile)
  local kind = tile.kind
  local aligned = ALIGNMENTS[kind.set.objectalignment or "unspecified"] or ALIGNMENTS.unspecified
  local left = object.x - aligned[1] * object.width
  local bottom = object.y + aligned[2] * object.height
  local list = kind.shapes or {}
  local shape = { x = 0, y = 0, width = kind.width, height = kind.height }
  if #list == 1 then
    shape = list[1]
  elseif #list > 1 then
    addReport(state, object, ("its tile has %d rectangles: the whole tile counts"):format(#list))
  end
  local box = { object.width, object.height, shape.x, shape.y, shape.width, shape.height }
  box.x, box.y, box.width, box.height =
    tileset.place(tile, left, bottom, box[1], box[2], box[3], box[4], box[5], box[6])
  return shapes.turnBox(box, object.x, object.y, shapes.quarters(object.rotation))
end

-- Returns the boxes of an object in the layer; nil and the reason if it has none.
local function boxesOf(state, object, tile, place)
  local boxes, reason = shapes.boxes(object, place, state.sti, true)
  if tile and boxes then
    return { boxOfTile(state, object, tile) }
  end
  return boxes, reason
end

-- Which objects are in the world -----------------------------------------------------------------

local function traitsOf(state, own, tile)
  local traits = state.context.traits
  if tile then
    traits = properties.combine(traits, tile.kind.traits)
    local list = tile.kind.shapes
    if list and #list == 1 then
      traits = properties.combine(traits, list[1].traits)
    end
  end
  traits = properties.combine(traits, own)
  local isWall = state.context.solid or own.solid or tile and tile.kind.traits.solid
  return isWall and properties.makeStatic(traits) or traits
end

-- Returns whether the map leaves an object out: one `solid = false` is enough.
local function isOut(state, own, tile)
  return state.context.solid == false
    or own.solid == false
    or tile and tile.kind.traits.solid == false
end

-- Returns whether an object is a mere picture: it has no name, neither it nor its tile has a
-- property, class or shape, and its layer says nothing.
local function isDecoration(state, object, tile)
  local context = state.context
  if not tile or context.solid or context.isWanted or context.isSpoken then
    return false
  end
  local kind = tile.kind
  local hasOwn = not properties.isEmpty(object.properties) or (object.name or "") ~= ""
  local isKnown = kind.hasProperties or kind.shapes ~= nil or kind.type ~= nil
  return not (hasOwn or isKnown or report.typeOf(object))
end

local function newThing(state, object, fields, x, y)
  local made = properties.copy(fields)
  made.x, made.y = state.context.x + x, state.context.y + y
  if object.name ~= "" then
    made.name = object.name
  end
  made.type = report.typeOf(object) or made.type
  made.tiled = { layer = state.layer, object = object }
  return made
end

local function newObject(state, object, traits, box, tile)
  local made = newThing(state, object, traits.fields, box.x, box.y)
  made.width, made.height = box.width, box.height
  if made.radius and made.radius ~= box.radius then
    addReport(state, object, 'property "radius": the editor\'s own shape counts')
  end
  made.radius = box.radius
  made.type = made.type or tile and tile.kind.type
  made.tiled.gid = tile and tile.gid
  return made
end

-- Kinds of objects --------------------------------------------------------------------------------

local function readPoint(state, object, own)
  local list = state.reading.points
  list[#list + 1] = newThing(state, object, own.fields, object.x, object.y)
end

local function readLine(state, object, own, place)
  local points, reason = shapes.points(object, "polyline", place, state.sti)
  if not points then
    addReport(state, object, reason)
    return
  end
  for _, point in ipairs(points) do
    point.x, point.y = state.context.x + point.x, state.context.y + point.y
  end
  local line, list = newThing(state, object, own.fields, object.x, object.y), state.reading.lines
  line.points = points
  list[#list + 1] = line
end

local function readDecoration(state, object, tile)
  local box, list = boxOfTile(state, object, tile), state.reading.decoration
  list[#list + 1] = newObject(state, object, { fields = {} }, box, tile)
end

local function reportTile(state, tile)
  if tile then
    tileset.reportExternal(state.reading, state.layer, tile.kind)
    tileset.report(state.reading, state.layer, tile.kind)
  end
end

local function readBoxes(state, object, own, tile, place)
  local boxes, reason = boxesOf(state, object, tile, place)
  if boxes and isDecoration(state, object, tile) then
    readDecoration(state, object, tile)
    return
  end
  local traits = boxes and traitsOf(state, own, tile)
  if boxes and #boxes > 1 and not traits.fields.static then
    reason = ("polygon of %d boxes: only static ones hold together"):format(#boxes)
    boxes = nil
  end
  if not boxes then
    addReport(state, object, reason)
    return
  end
  reportTile(state, tile)
  for _, box in ipairs(boxes) do
    local reading = state.reading
    reading.add(reading, traits.group, newObject(state, object, traits, box, tile))
  end
end

-- (A click in the editor makes a rectangle without a size.)
local function isPoint(object)
  local shape = object.shape or "rectangle"
  local isEmpty = object.width == 0 and object.height == 0
  return shape == "point" or (shape == "rectangle" and object.gid == nil and isEmpty)
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
  report.checkObject(object, place)
  local own = properties.read(object.properties, place, reading.rules)
  local tile = object.gid ~= nil and tileset.tile(reading, object.gid, place .. ": gid") or nil
  local isMark = isPoint(object) or object.shape == "polyline"
  if not isMark and isOut(state, own, tile) then
    return
  end
  for _, text in ipairs(own.problems) do
    addReport(state, object, text)
  end
  if isPoint(object) then
    readPoint(state, object, own)
  elseif isMark then
    readLine(state, object, own, place)
  else
    readBoxes(state, object, own, tile, place)
  end
end

--- Reads an object layer. Errors: a position, a size, a gid or a property that cannot be used.
---@param reading table
---@param layer table
---@param context table what the layers around it and it itself say
function objectlayer.read(reading, layer, context)
  local state = { reading = reading, layer = layer, context = context }
  if reading.map.tileInstances then -- the map comes from STI
    check.number(layer.x, "x", report.place(layer))
    check.number(layer.y, "y", report.place(layer))
    state.sti = { x = layer.x, y = layer.y }
  end
  check.table(layer.objects, "objects", report.place(layer))
  if context.solid ~= false then
    reading.addGroup(reading, context.traits.group)
  end
  for i, object in ipairs(layer.objects) do
    readObject(state, object, i)
  end
end

return objectlayer
