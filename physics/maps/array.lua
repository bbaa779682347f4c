--- Reads the tiles of a plain array: which values are solid, and the fields of their objects.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local check = require(root .. ".world.check")
local tiles = require(root .. ".maps.tiles")
local values = require(root .. ".maps.values")

local array = {}

local WHERE = "world:addTiles(group, cells, columns, size, options)"
local OPTIONS = { "fields", "later", "merge", "solid", "x", "y" }

---@class physics.TileOptions
---@field x? number px, default 0: left edge of the first column
---@field y? number px, default 0: upper edge of the first row
---@field solid? table<any, boolean|table> which values are solid: true, or the fields of their
---  objects; default: all but 0, false, "", " " and "."
---@field fields? table<string, any> fields of all objects
---@field merge? boolean default true: equal solid cells become few objects; false: each is one
---@field later? boolean default false; true: nothing is in the world until `load` is called

-- Values that are empty by custom, unless the option `solid` says otherwise.
local IS_EMPTY = { [0] = true, [false] = true, [""] = true, [" "] = true, ["."] = true }

-- Options -----------------------------------------------------------------------------------------

local function checkOptions(options)
  options = values.readOptions(options, OPTIONS, { "later", "merge" }, WHERE)
  local common = values.readFields(options.fields == nil and {} or options.fields, "fields", WHERE)
  return {
    x = options.x or 0,
    y = options.y or 0,
    merge = options.merge ~= false,
    later = options.later or false,
    common = common,
    solid = values.readSolid(options.solid, common, WHERE),
  }
end

-- Sizes -------------------------------------------------------------------------------------------

local function checkSize(size)
  if type(size) == "table" then
    check.positive(size[1], "size[1]", WHERE)
    check.positive(size[2], "size[2]", WHERE)
    return size[1], size[2]
  end
  check.positive(size, "size", WHERE)
  return size, size
end

-- Returns the number of rows and columns of a list of rows; a row is a list or a string.
local function measureRows(list, columns)
  local widest = 1
  for row = 1, #list do
    local kind = type(list[row])
    if kind ~= "table" and kind ~= "string" then
      local text = "%s: cells[%d] must be a row, got %s"
      check.fail(text:format(WHERE, row, check.show(list[row])))
    elseif columns and #list[row] > columns then
      local text = "%s: cells[%d] must hold at most %d cells, got %d"
      check.fail(text:format(WHERE, row, columns, #list[row]))
    end
    widest = math.max(widest, #list[row])
  end
  return #list, columns or widest
end

local function measure(list, columns)
  check.table(list, "cells", WHERE)
  local isNested = type(list[1]) == "table" or (type(list[1]) == "string" and columns == nil)
  if columns ~= nil or not isNested then
    check.integer(columns, "columns", WHERE, 1, 1e6)
  end
  if isNested then
    return true, measureRows(list, columns)
  elseif #list % columns ~= 0 then
    local text = "%s: cells must hold whole rows of %d, got %d cells"
    check.fail(text:format(WHERE, columns, #list))
  end
  return false, #list / columns, columns
end

-- Reading -----------------------------------------------------------------------------------------

local function checkValue(value, what)
  if not values.isValue(value) then
    local text = "%s must be a number, a string or a boolean, got %s"
    check.fail(text:format(what, check.show(value)))
  end
end

local function setCell(state, value, column, row, index)
  if value == nil then
    return
  end
  local pieces = state.pieces[value]
  if not pieces then
    local what = index and ("cells[%d]"):format(index) or ("cells[%d][%d]"):format(row, column)
    checkValue(value, WHERE .. ": " .. what)
    pieces = values.piecesOf(state, value)
  end
  if not IS_EMPTY[value] or #pieces > 0 then
    cells.fill(state.tiles, column, row, value, pieces)
  end
end

local function readRows(state, list)
  for row = 1, #list do
    local line = list[row]
    local isText = type(line) == "string"
    for column = 1, isText and #line or state.tiles.columns do
      setCell(state, isText and line:sub(column, column) or line[column], column, row)
    end
  end
end

local function readFlat(state, list)
  local columns, index = state.tiles.columns, 0
  for row = 1, state.tiles.rows do
    for column = 1, columns do
      index = index + 1
      setCell(state, list[index], column, row, index)
    end
  end
end

-- Returns the value of an empty cell: the first of these values that is not solid.
local function emptyOf(state)
  for _, value in ipairs({ 0, false, "", " ", "." }) do
    if not state.traitsOf(value) then
      return value
    end
  end
  return "empty"
end

local function newTiles(state, columns, rows, width, height)
  return tiles.new({
    x = state.x,
    y = state.y,
    zero = 1,
    tileWidth = width,
    tileHeight = height,
    firstColumn = 1,
    firstRow = 1,
    columns = columns,
    rows = rows,
    record = "tile",
    copy = values.copy,
    empty = emptyOf(state),
    isEmpty = IS_EMPTY,
    piecesOf = function(value, where)
      checkValue(value, where and where .. ": value" or WHERE)
      return values.piecesOf(state, value)
    end,
  })
end

--- Reads tiles and adds nothing: see `world:addTiles`.
---@param group string|number
---@param list table the cells
---@param columns integer?
---@param size number|number[]
---@param options physics.TileOptions?
---@return physics.Tiles tiles
---@return physics.Object[] objects
---@return (string|number)[] groupOf the group of each of them
---@return boolean later are they to wait
function array.read(group, list, columns, size, options)
  check.group(group, WHERE)
  local state = checkOptions(options)
  local width, height = checkSize(size)
  local isNested, rows, itsColumns = measure(list, columns)
  state.group, state.pieces, state.boxesByKey = group, {}, {}
  function state.traitsOf(value)
    if state.solid then
      return state.solid[value]
    end
    return not IS_EMPTY[value] and state.common
  end
  state.tiles = newTiles(state, itsColumns, math.max(rows, 1), width, height)
  local read = isNested and readRows or readFlat
  read(state, list)
  local objects, groupOf = {}, {}
  cells.build(state.tiles, function(itsGroup, object)
    objects[#objects + 1], groupOf[#groupOf + 1] = object, itsGroup
  end)
  return state.tiles, objects, groupOf, state.later
end

return array
