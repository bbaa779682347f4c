--- Reads a tile layer: finds the boxes of its solid tiles and makes few large ones of them.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".check")
local merge = require(root .. ".maps.tiled.merge")
local properties = require(root .. ".maps.tiled.properties")
local report = require(root .. ".maps.tiled.report")
local tileset = require(root .. ".maps.tiled.tileset")

local floor = math.floor

local tilelayer = {}

--- Equal boxes in equal places of their cells: what can become one.
---@class physics.TileBoxes
---@field x number px, from the left edge of the cell
---@field y number px, from its upper edge
---@field width number px
---@field height number px
---@field traits physics.Traits
---@field gid number? nil: several
---@field isWide boolean may boxes of a row become one
---@field isTall boolean may boxes of a column become one
---@field cells integer[]
---@field count integer

-- What a tile consists of -------------------------------------------------------------------------

-- Whoever says no is right; else somebody has to say yes. Collision shapes say yes.
local function isSolid(reading, layerSolid, kind, gid)
  local tileSolid = kind.traits.solid
  if reading.isSolidGid[gid] then
    tileSolid = true
  end
  if layerSolid == false or tileSolid == false then
    return false
  end
  return layerSolid or tileSolid or kind.shapes ~= nil
end

-- Only what never moves becomes one, since nobody can tell. Sensors can be told apart: each coin is
-- one. A side that is solid while the one behind it is not must stay one row deep.
local function setMerging(boxes, reading)
  local given, map = boxes.traits.fields, reading.map
  local isMerging = boxes.traits.merge
  if isMerging == nil then
    isMerging = given.static == true and not given.sensor
  end
  isMerging = isMerging and reading.merge
  local oneWay = given.oneWay
  boxes.isWide = isMerging
    and boxes.width == map.tilewidth
    and oneWay ~= "left"
    and oneWay ~= "right"
  boxes.isTall = isMerging
    and boxes.height == map.tileheight
    and oneWay ~= "top"
    and oneWay ~= "bottom"
end

local function signature(traits, x, y, width, height)
  return properties.signature({
    properties.signature(traits.fields),
    traits.group,
    tostring(traits.merge),
    x,
    y,
    width,
    height,
  })
end

-- The boxes in which one rectangle of a tile belongs.
local function boxesFor(state, tile, traits, x, y, width, height)
  local map = state.reading.map
  local drawnWidth, drawnHeight = tile.kind.width, tile.kind.height
  if tile.kind.set.tilerendersize == "grid" then
    drawnWidth, drawnHeight = map.tilewidth, map.tileheight
  end
  x, y, width, height =
    tileset.place(tile, 0, map.tileheight, drawnWidth, drawnHeight, x, y, width, height)
  local key = signature(traits, x, y, width, height)
  local boxes = state.boxesByKey[key]
  if not boxes then
    boxes = { x = x, y = y, width = width, height = height, traits = traits, gid = tile.gid }
    boxes.cells, boxes.count = {}, 0
    setMerging(boxes, state.reading)
    state.boxesByKey[key] = boxes
    state.list[#state.list + 1] = boxes
  elseif boxes.gid ~= tile.gid then
    boxes.gid = nil
  end
  return boxes
end

local function traitsOf(state, kind)
  local traits = properties.combine(state.traits, kind.traits)
  traits.fields.type = traits.fields.type or kind.type
  return traits
end

local function makeStatic(traits)
  if traits.fields.static == nil and not traits.fields.kinematic then
    traits.fields.static = true
  end
  return traits
end

-- The boxes of all rectangles of a tile, as a list; an empty one for who is not solid.
local function piecesOf(state, tile)
  local kind, pieces = tile.kind, {}
  if state.solid ~= false then
    tileset.reportExternal(state.reading, state.layer, kind.set)
  end
  if not isSolid(state.reading, state.solid, kind, tile.gid) then
    return pieces
  end
  tileset.report(state.reading, state.layer, kind)
  local traits = traitsOf(state, kind)
  if not kind.shapes then
    pieces[1] = boxesFor(state, tile, makeStatic(traits), 0, 0, kind.width, kind.height)
  end
  for i, shape in ipairs(kind.shapes or {}) do
    local combined = makeStatic(properties.combine(traits, shape.traits))
    local x, y, width, height = shape.x, shape.y, shape.width, shape.height
    pieces[i] = boxesFor(state, tile, combined, x, y, width, height)
  end
  return pieces
end

-- Cells -------------------------------------------------------------------------------------------

-- STI makes rows of tiles of the list of gids.
local function isRows(data)
  return type(data[1]) == "table"
end

local function cellOfRows(data, column, row, place)
  check.table(data[row + 1], ("data[%d]"):format(row + 1), place)
  local tile = data[row + 1][column + 1]
  if tile == nil then
    return 0
  end
  check.table(tile, ("data[%d][%d]"):format(row + 1, column + 1), place)
  return tile.gid
end

local function checkGrid(grid, place)
  check.integer(grid.width, "width", place, 1, 1e6)
  check.integer(grid.height, "height", place, 1, 1e6)
  check.table(grid.data, "data", place)
  local count, expected = #grid.data, grid.width * grid.height
  if not isRows(grid.data) and count ~= expected then
    check.fail(
      ("%s: data must hold %d gids (%d x %d), got %d"):format(
        place,
        expected,
        grid.width,
        grid.height,
        count
      )
    )
  end
end

local function addCell(state, gid, column, row, place)
  local pieces = state.piecesByGid[gid]
  if not pieces then
    local where = ("%s: the tile at column %d, row %d"):format(place, column, row)
    local tile = tileset.tile(state.reading, gid, where)
    pieces = tile and piecesOf(state, tile) or {}
    state.piecesByGid[gid] = pieces
  end
  local index = (row - state.firstRow) * state.stride + column - state.firstColumn
  for i = 1, #pieces do
    local boxes = pieces[i]
    boxes.count = boxes.count + 1
    boxes.cells[boxes.count] = index
  end
end

local function readGrid(state, grid, left, top, place)
  local data, width, hasRows = grid.data, grid.width, isRows(grid.data)
  for row = 0, grid.height - 1 do
    for column = 0, width - 1 do
      local gid
      if hasRows then
        gid = cellOfRows(data, column, row, place)
      else
        gid = data[row * width + column + 1]
      end
      if gid ~= 0 then
        addCell(state, gid, left + column, top + row, place)
      end
    end
  end
end

-- The parts of an infinite layer, or the one of a finite layer.
local function gridsOf(layer, place)
  if layer.chunks == nil then
    checkGrid(layer, place)
    return { { grid = layer, column = 0, row = 0, place = place } }
  end
  check.table(layer.chunks, "chunks", place)
  local grids = {}
  for i, chunk in ipairs(layer.chunks) do
    check.table(chunk, ("chunks[%d]"):format(i), place)
    local chunkPlace = ("%s, chunk %d"):format(place, i)
    check.integer(chunk.x, "x", chunkPlace, -1e6, 1e6)
    check.integer(chunk.y, "y", chunkPlace, -1e6, 1e6)
    checkGrid(chunk, chunkPlace)
    grids[i] = { grid = chunk, column = chunk.x, row = chunk.y, place = chunkPlace }
  end
  return grids
end

-- Makes room in the numbering of cells for all parts, and in the map's own box.
local function measure(state, grids)
  local left, top, right, bottom = math.huge, math.huge, -math.huge, -math.huge
  for _, part in ipairs(grids) do
    left, top = math.min(left, part.column), math.min(top, part.row)
    right = math.max(right, part.column + part.grid.width)
    bottom = math.max(bottom, part.row + part.grid.height)
  end
  state.firstColumn, state.firstRow, state.stride = left, top, right - left + 1
  return left, top, right, bottom
end

-- Objects -----------------------------------------------------------------------------------------

local function addObject(state, boxes, index, columns, rows)
  local reading, context = state.reading, state.context
  local map = reading.map
  local row = floor(index / state.stride)
  local column = index - row * state.stride + state.firstColumn
  row = row + state.firstRow
  local object = properties.newObject(
    boxes.traits.fields,
    context.x + (column * map.tilewidth + boxes.x),
    context.y + (row * map.tileheight + boxes.y),
    boxes.width + (columns - 1) * map.tilewidth,
    boxes.height + (rows - 1) * map.tileheight
  )
  object.tiled = { layer = state.layer, column = column, row = row, columns = columns, rows = rows }
  object.tiled.gid = boxes.gid
  reading.add(reading, boxes.traits.group, object)
end

local function addObjects(state, boxes)
  local reading = state.reading
  table.sort(boxes.cells) -- the parts of an infinite layer come one by one
  local found, count =
    merge.cover(boxes.cells, boxes.count, state.stride, boxes.isWide, boxes.isTall)
  for i = 1, count, 3 do
    addObject(state, boxes, found[i], found[i + 1], found[i + 2])
    reading.rectangles = reading.rectangles + 1
  end
  reading.tiles = reading.tiles + boxes.count
end

--- Reads a tile layer.
--- Errors: a size, a chunk or a gid that cannot be used.
---@param reading table
---@param layer table
---@param context table what the layers around it and it itself say
function tilelayer.read(reading, layer, context)
  local place = report.place(layer)
  local grids = gridsOf(layer, place)
  if #grids == 0 then
    return
  end
  local state = { reading = reading, layer = layer, context = context, list = {} }
  state.traits, state.solid = context.traits, context.solid
  state.boxesByKey, state.piecesByGid = {}, {}
  local left, top, right, bottom = measure(state, grids)
  if layer.chunks then
    reading.extend(reading, left, top, right, bottom)
  end
  for _, part in ipairs(grids) do
    readGrid(state, part.grid, part.column, part.row, part.place)
  end
  for _, boxes in ipairs(state.list) do
    addObjects(state, boxes)
  end
end

return tilelayer
