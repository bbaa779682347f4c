--- Records which cells of a layer of tiles are solid, and which object covers which of them.
---
--- A value of a cell is a list of *boxes*. Cells that have the same box in the same place share it.
--- The cells of one box are covered by rectangles, one object each (merge.lua). `owner` of the
--- boxes has the object at the left end of each row of each rectangle; a cell finds its object by
--- looking to the left. So a change costs as much as the rectangle around the cell is wide and
--- high, whatever the size of the layer.

local root = (...):match("^(.*)%.maps%.")
local interpreted = require(root .. ".memory.jit")
local merge = require(root .. ".maps.merge")

local floor, max, min = math.floor, math.max, math.min

local cells = {}

--- Equal boxes in equal places of their cells, which may become one object.
---@class physics.TileBoxes
---@field x number px, from the left edge of the cell
---@field y number px, from its upper edge
---@field width number px
---@field height number px
---@field fields table<string, any> fields of the objects
---@field group string|number name of their group
---@field value any the value of the cells, nil: several
---@field first any the first of these values
---@field isWide boolean may boxes of a row become one
---@field isTall boolean may boxes of a column become one
---@field cells integer[]? while the layer is read: where they are
---@field count integer while the layer is read: how many cells there are
---@field owner table<integer, physics.Object> cell -> object whose rectangle begins in this row
---@field widest integer columns of the widest rectangle

--- Makes the records of a layer without any solid cell; it is in no world yet.
---@param self table the tiles
---@param given table x, y: px, where the cell is whose column and row are `zero`; tileWidth,
---  tileHeight, firstColumn, firstRow, columns, rows; `record`: name of the field that gets the
---  place of an object; `base`: what stands in each place; `copy`: makes new fields of those of the
---  boxes; `piecesOf(value, where)`: returns the list of boxes of a value, or raises an error;
---  `empty`: the value of a cell in which nothing is; `isEmpty[value]`: true for others that mean
---  the same, unless they have boxes
function cells.open(self, given)
  self._x, self._y, self._zero = given.x, given.y, given.zero
  self.tileWidth, self.tileHeight = given.tileWidth, given.tileHeight
  self.firstColumn, self.firstRow = given.firstColumn, given.firstRow
  self.columns, self.rows = given.columns, given.rows
  self.x = given.x + (given.firstColumn - given.zero) * given.tileWidth
  self.y = given.y + (given.firstRow - given.zero) * given.tileHeight
  self.tiles, self.rectangles = 0, 0
  self._record, self._base, self._copy = given.record, given.base or {}, given.copy
  self._piecesOf, self._empty, self._isEmpty = given.piecesOf, given.empty, given.isEmpty or {}
  self._values, self._list = {}, {}
  self._waiting, self._isWaiting, self._next = {}, {}, 1
  self._restores = 0
end

--- Returns new boxes. They belong to one layer of tiles.
---@param self table the tiles
---@param boxes table x, y, width, height, fields, group, value, isWide, isTall
---@return physics.TileBoxes
function cells.addBoxes(self, boxes)
  boxes.cells, boxes.count, boxes.owner, boxes.widest = {}, 0, {}, 0
  self._list[#self._list + 1] = boxes
  return boxes
end

-- Returns the index of a cell. The stride is larger than the number of columns, so that no row runs
-- into the next one.
local function indexOf(self, column, row)
  return (row - self.firstRow) * (self.columns + 1) + column - self.firstColumn + 1
end

--- Sets a cell while the layer is read.
---@param self table the tiles
---@param column integer
---@param row integer
---@param value any
---@param pieces physics.TileBoxes[] what `piecesOf` returned for it
function cells.fill(self, column, row, value, pieces)
  local index = indexOf(self, column, row)
  self._values[index] = value
  for i = 1, #pieces do
    local boxes = pieces[i]
    boxes.count = boxes.count + 1
    boxes.cells[boxes.count] = index
  end
end

-- Returns a new object for a rectangle of cells; it is not recorded yet.
local function newObject(self, boxes, column, row, columns, rows)
  local object = self._copy(boxes.fields)
  object.x = self._x + ((column - self._zero) * self.tileWidth + boxes.x)
  object.y = self._y + ((row - self._zero) * self.tileHeight + boxes.y)
  object.width = boxes.width + (columns - 1) * self.tileWidth
  object.height = boxes.height + (rows - 1) * self.tileHeight
  local place = { tiles = self, column = column, row = row, columns = columns, rows = rows }
  for name, value in pairs(self._base) do
    place[name] = value
  end
  place._boxes = boxes
  place[self._record == "tiled" and "gid" or "value"] = boxes.value
  object[self._record] = place
  return object
end

local function register(self, boxes, object)
  local place = object[self._record]
  boxes.widest = max(boxes.widest, place.columns)
  for row = place.row, place.row + place.rows - 1 do
    boxes.owner[indexOf(self, place.column, row)] = object
  end
  self.rectangles = self.rectangles + 1
end

local function unregister(self, boxes, object)
  local place = object[self._record]
  for row = place.row, place.row + place.rows - 1 do
    boxes.owner[indexOf(self, place.column, row)] = nil
  end
  self.rectangles = self.rectangles - 1
end

local function build(self, boxes, add)
  table.sort(boxes.cells) -- the parts of an infinite layer come one by one
  local stride = self.columns + 1
  local found, count = merge.cover(boxes.cells, boxes.count, stride, boxes.isWide, boxes.isTall)
  for i = 1, count, 3 do
    local row = floor((found[i] - 1) / stride)
    local column = found[i] - 1 - row * stride + self.firstColumn
    local object = newObject(self, boxes, column, row + self.firstRow, found[i + 1], found[i + 2])
    register(self, boxes, object)
    add(boxes.group, object)
  end
  self.tiles, boxes.cells = self.tiles + boxes.count, nil
end

--- Makes the objects of all cells that were filled.
---@param self table the tiles
---@param add fun(group: string|number, object: physics.Object)
function cells.build(self, add)
  for _, boxes in ipairs(self._list) do
    build(self, boxes, add)
  end
end

--- Notes that an object of these tiles stays out of the world until `load` puts it there.
---@param self table the tiles
---@param object physics.Object
function cells.wait(self, object)
  self._waiting[#self._waiting + 1], self._isWaiting[object] = object, true
end

-- Returns the object of these boxes that covers a cell.
local function find(self, boxes, column, row)
  local owner, index = boxes.owner, indexOf(self, column, row)
  for back = 0, min(boxes.widest - 1, column - self.firstColumn) do
    local object = owner[index - back]
    if object then
      return back < object[self._record].columns and object or nil
    end
  end
end

local function isInside(self, column, row)
  return column >= self.firstColumn
    and column < self.firstColumn + self.columns
    and row >= self.firstRow
    and row < self.firstRow + self.rows
end

-- Loading and unloading ---------------------------------------------------------------------------

--- Puts the next waiting objects into the world.
---@param self table the tiles
---@param most number how many at most
---@return integer left how many wait still
function cells.bring(self, most)
  local done = 0
  while self._next <= #self._waiting and done < most do
    local object = self._waiting[self._next]
    self._next = self._next + 1
    if self._isWaiting[object] then
      self._isWaiting[object], done = nil, done + 1
      self._access.put(self.world, object[self._record]._boxes.group, object)
    end
  end
  local left = 0 ---@type integer
  for n = self._next, #self._waiting do
    left = left + (self._isWaiting[self._waiting[n]] and 1 or 0)
  end
  if left == 0 then
    self._waiting, self._next = {}, 1
  end
  return left
end

-- Returns whether an object is still recorded: `setTile` may have cut it.
local function isKnown(self, object)
  local place = object[self._record]
  return place._boxes.owner[indexOf(self, place.column, place.row)] == object
end

--- Takes the next objects that leave out of the world; after that they wait.
---@param self table the tiles
---@param most number how many at most
---@return integer left how many are still to leave
function cells.takeOut(self, most)
  local done, leaving = 0, self._leaving
  while self._left < #leaving and done < most do
    self._left = self._left + 1
    local object = leaving[self._left]
    if isKnown(self, object) and self._access.remove(self.world, object) then
      cells.wait(self, object)
      done = done + 1
    end
  end
  local left = #leaving - self._left
  ---@cast left integer
  if left == 0 then
    self._leaving = nil
  end
  return left
end

cells.find, cells.isInside, cells.newObject = find, isInside, newObject
cells.register, cells.unregister, cells.indexOf = register, unregister, indexOf

interpreted.always(newObject)

return cells
