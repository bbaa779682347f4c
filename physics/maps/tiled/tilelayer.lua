--- Reads a tile layer: finds the boxes of its solid tiles, for merging into few large ones.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local check = require(root .. ".world.check")
local decode = require(root .. ".maps.tiled.decode")
local properties = require(root .. ".maps.properties")
local report = require(root .. ".maps.tiled.report")
local tiles = require(root .. ".maps.tiles")
local tileset = require(root .. ".maps.tiled.tileset")

local tilelayer = {}

-- Boxes of a tile ---------------------------------------------------------------------------------

-- Returns whether a tile is solid. A property that says no decides; else one must say yes.
-- Collision shapes say yes.
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

-- Sets which boxes may merge. By default only static boxes do, since the game cannot notice it
-- then. Sensors can be counted: each coin is one. A one-way box must stay one row deep if the side
-- behind it is not solid.
local function setMerging(boxes, merge, reading)
  local given, map = boxes.fields, reading.map
  local isMerging = merge
  if isMerging == nil then
    isMerging = given.static == true and not given.sensor
  end
  if given.slope or not reading.merge then
    isMerging = false
  end
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

-- Traits with another slope.
local function withSlope(traits, slope)
  if slope == traits.fields.slope then
    return traits
  end
  local fields = properties.copy(traits.fields)
  fields.slope = slope
  return { fields = fields, group = traits.group, merge = traits.merge }
end

-- Returns the boxes to which one rectangle of a tile belongs.
local function boxesFor(state, tile, traits, x, y, width, height, slope)
  traits = withSlope(traits, tileset.flipSlope(tile, slope or traits.fields.slope))
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
    boxes = { x = x, y = y, width = width, height = height, fields = traits.fields }
    boxes.group, boxes.value, boxes.first = traits.group, tile.gid, tile.value
    setMerging(boxes, traits.merge, state.reading)
    state.boxesByKey[key] = cells.addBoxes(state.tiles, boxes)
  elseif boxes.value ~= tile.gid then
    boxes.value = nil
  end
  return boxes
end

local function traitsOf(state, kind)
  local traits = properties.combine(state.context.traits, kind.traits)
  traits.fields.type = traits.fields.type or kind.type
  return traits
end

-- Returns the boxes of all rectangles of a tile as a list, empty if it is not solid.
local function piecesOf(state, tile)
  local kind, pieces = tile.kind, {}
  if state.context.solid ~= false then
    tileset.reportExternal(state.reading, state.layer, kind)
  end
  if not isSolid(state.reading, state.solid, kind, tile.gid) then
    return pieces
  end
  tileset.report(state.reading, state.layer, kind)
  local traits, makeStatic = traitsOf(state, kind), properties.makeStatic
  if not kind.shapes then
    pieces[1] = boxesFor(state, tile, makeStatic(traits), 0, 0, kind.width, kind.height)
  end
  for i, shape in ipairs(kind.shapes or {}) do
    local combined = makeStatic(properties.combine(traits, shape.traits))
    local x, y, width, height = shape.x, shape.y, shape.width, shape.height
    pieces[i] = boxesFor(state, tile, combined, x, y, width, height, shape.slope)
  end
  return pieces
end

-- Returns the same for a gid as it stands in the map, and remembers it.
local function piecesOfGid(state, gid, where)
  local pieces = state.piecesByGid[gid]
  if not pieces then
    local tile = tileset.tile(state.reading, gid, where)
    if tile then
      tile.value = gid
    end
    pieces = tile and piecesOf(state, tile) or {}
    state.piecesByGid[gid] = pieces
  end
  return pieces
end

-- Cells -------------------------------------------------------------------------------------------

-- Returns whether STI has replaced the list of gids by rows of tiles.
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
  if type(grid.data) == "string" then
    return
  end
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

-- Calls f(state, gid, column, row, place) for each tile of a grid.
local function eachTile(state, grid, f)
  local data, width, left, top = grid.data, grid.width, grid.column, grid.row
  local hasRows, place = isRows(data), grid.place
  for row = 0, grid.height - 1 do
    for column = 0, width - 1 do
      local gid
      if hasRows then
        gid = cellOfRows(data, column, row, place)
      else
        gid = data[row * width + column + 1]
      end
      if gid ~= 0 then
        f(state, gid, left + column, top + row, place)
      end
    end
  end
end

local function whereIs(column, row, place)
  return ("%s: the tile at column %d, row %d"):format(place, column, row)
end

local function addCell(state, gid, column, row, place)
  local pieces = state.piecesByGid[gid]
  if not pieces then
    pieces = piecesOfGid(state, gid, whereIs(column, row, place))
  end
  cells.fill(state.tiles, column, row, gid, pieces)
end

-- Grids -------------------------------------------------------------------------------------------

local function newGrid(reading, layer, grid, column, row, place)
  checkGrid(grid, place)
  local data, reason = grid.data, nil
  if type(data) == "string" then
    data, reason = decode.gids(reading, layer, grid, place)
  end
  local made = { data = data, width = grid.width, height = grid.height }
  made.column, made.row, made.place = column, row, place
  return made, reason
end

-- Returns the parts of an infinite layer, or the one of a finite layer; nil and the reason if they
-- cannot be unpacked.
local function gridsOf(reading, layer, place)
  if layer.chunks == nil then
    local grid, reason = newGrid(reading, layer, layer, 0, 0, place)
    return not reason and { grid } or nil, reason
  end
  check.table(layer.chunks, "chunks", place)
  local grids = {}
  for i, chunk in ipairs(layer.chunks) do
    check.table(chunk, ("chunks[%d]"):format(i), place)
    local chunkPlace = ("%s, chunk %d"):format(place, i)
    check.integer(chunk.x, "x", chunkPlace, -1e6, 1e6)
    check.integer(chunk.y, "y", chunkPlace, -1e6, 1e6)
    local grid, reason = newGrid(reading, layer, chunk, chunk.x, chunk.y, chunkPlace)
    if reason then
      return nil, reason
    end
    grids[i] = grid
  end
  return grids
end

local function newTiles(state, grids)
  local left, top, right, bottom = math.huge, math.huge, -math.huge, -math.huge
  for _, grid in ipairs(grids) do
    left, top = math.min(left, grid.column), math.min(top, grid.row)
    right = math.max(right, grid.column + grid.width)
    bottom = math.max(bottom, grid.row + grid.height)
  end
  local context, map = state.context, state.reading.map
  return tiles.new({
    x = context.x,
    y = context.y,
    zero = 0,
    tileWidth = map.tilewidth,
    tileHeight = map.tileheight,
    firstColumn = left,
    firstRow = top,
    columns = right - left,
    rows = bottom - top,
    record = "tiled",
    base = { layer = state.layer },
    copy = properties.copy,
    empty = 0,
    piecesOf = function(gid, where)
      return piecesOfGid(state, gid, where and where .. ": value")
    end,
  })
end

-- Solid by name -----------------------------------------------------------------------------------

local function countKind(state, gid, column, row, place)
  state.filled = state.filled + 1
  if state.isMarked[gid] == nil then
    local tile = tileset.tile(state.reading, gid, whereIs(column, row, place))
    local kind = tile and tile.kind
    local isMarked = kind
      and (kind.traits.solid or kind.shapes or state.reading.isSolidGid[tile.gid])
    state.isMarked[gid] = isMarked and true or false
    state.hasMarks = state.hasMarks or state.isMarked[gid]
  end
end

-- Returns whether a layer that is solid only by its name is so. It is not if its tiles say
-- themselves which of them are solid, nor if it has no free cell: that is a floor seen from above.
local function isNameTrue(state, grids)
  local size = 0.0
  state.filled, state.isMarked, state.hasMarks = 0, {}, false
  for _, grid in ipairs(grids) do
    size = size + grid.width * grid.height
    eachTile(state, grid, countKind)
  end
  return state.filled > 0 and state.filled < size and not state.hasMarks
end

-- Reading -----------------------------------------------------------------------------------------

--- Reads a tile layer. Errors: a size, a chunk, data or a gid that cannot be used.
---@param reading table
---@param layer table
---@param context table what the layers around it and it itself say
---@return string? reason why nothing of it can be read
function tilelayer.read(reading, layer, context)
  local place = report.place(layer)
  local grids, reason = gridsOf(reading, layer, place)
  if not grids then
    return reason
  elseif #grids == 0 then
    return
  end
  local state = { reading = reading, layer = layer, context = context, solid = context.solid }
  state.boxesByKey, state.piecesByGid = {}, {}
  if context.isByName and not isNameTrue(state, grids) then
    state.solid, context.solid = nil, nil
  end
  local made = newTiles(state, grids)
  state.tiles = made
  if layer.chunks then
    local right, bottom = made.firstColumn + made.columns, made.firstRow + made.rows
    reading.extend(reading, made.firstColumn, made.firstRow, right, bottom)
  end
  for _, grid in ipairs(grids) do
    eachTile(state, grid, addCell)
  end
  cells.build(made, function(group, object)
    reading.add(reading, group, object)
  end)
  reading.addTiles(reading, layer, made)
end

return tilelayer
