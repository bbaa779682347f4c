--- Changes one cell of a layer of tiles: digs it out of the rectangle that covers it, or lets a new
--- rectangle grow together with those around it.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")

local find, isInside, newObject = cells.find, cells.isInside, cells.newObject
local register, unregister = cells.register, cells.unregister
local min = math.min

local digging = {}

-- Takes an object away: out of the books, and out of the world, or of what waits to get there.
-- Returns false if the game has taken it out itself.
local function takeAway(self, boxes, object)
  unregister(self, boxes, object)
  if self._fresh[object] then
    self._fresh[object] = nil
    return true
  elseif self._isWaiting[object] then
    self._isWaiting[object] = nil
    return true
  end
  return self._access.remove(self.world, object)
end

-- Makes an object, which comes into the world when the change is complete.
local function make(self, boxes, column, row, columns, rows)
  local object = newObject(self, boxes, column, row, columns, rows)
  register(self, boxes, object)
  local n = #self._freshList + 1
  self._freshList[n], self._fresh[object] = object, true
  return object
end

-- The object beside a rectangle that makes a larger rectangle with it.
local function neighbourOf(self, boxes, place)
  local column, row, columns, rows = place.column, place.row, place.columns, place.rows
  for side = boxes.isWide and 1 or 3, boxes.isTall and 4 or 2 do
    local x = side == 1 and column - 1 or side == 2 and column + columns or column
    local y = side == 3 and row - 1 or side == 4 and row + rows or row
    local other = isInside(self, x, y) and find(self, boxes, x, y)
    local its = other and other[self._record]
    if its and side <= 2 and its.row == row and its.rows == rows then
      return other
    elseif its and side > 2 and its.column == column and its.columns == columns then
      return other
    end
  end
end

-- Lets a rectangle grow over its neighbours as long as one fits.
local function grow(self, boxes, object)
  local place = object[self._record]
  local other = neighbourOf(self, boxes, place)
  while other do
    local its = other[self._record]
    if takeAway(self, boxes, other) then
      takeAway(self, boxes, object)
      local column, row = min(place.column, its.column), min(place.row, its.row)
      local isBeside = place.row == its.row
      local columns = isBeside and place.columns + its.columns or place.columns
      local rows = isBeside and place.rows or place.rows + its.rows
      object = make(self, boxes, column, row, columns, rows)
      place = object[self._record]
    end
    other = neighbourOf(self, boxes, place)
  end
end

-- Takes one cell out of its rectangle:
--
--      +-----------+      the parts above and below are as wide as the rectangle was,
--      |   above   |      those on the left and right one row high
--      +---+-+-----+
--      |   |x|     |
--      +---+-+-----+
--      |   below   |
--      +-----------+
local function cut(self, boxes, column, row)
  local object = find(self, boxes, column, row)
  self.tiles = self.tiles - 1
  if not object then
    return
  end
  local place = object[self._record]
  if not takeAway(self, boxes, object) then
    return -- the game has taken it out: nothing of it comes back
  end
  local right, bottom = place.column + place.columns, place.row + place.rows
  for _, part in ipairs({
    { place.column, place.row, place.columns, row - place.row },
    { place.column, row, column - place.column, 1 },
    { column + 1, row, right - column - 1, 1 },
    { place.column, row + 1, place.columns, bottom - row - 1 },
  }) do
    if part[3] > 0 and part[4] > 0 then
      grow(self, boxes, make(self, boxes, part[1], part[2], part[3], part[4]))
    end
  end
end

local function fillIn(self, boxes, column, row)
  self.tiles = self.tiles + 1
  grow(self, boxes, make(self, boxes, column, row, 1, 1))
end

-- Puts what a change has made into the world.
local function settle(self)
  for _, object in ipairs(self._freshList) do
    if self._fresh[object] then
      if self._isAway then
        cells.wait(self, object)
      else
        self._access.put(self.world, object[self._record]._boxes.group, object)
      end
    end
  end
  self._fresh, self._freshList = nil, nil
end

--- Returns whether a value is in a list.
function digging.has(list, wanted)
  for i = 1, #list do
    if list[i] == wanted then
      return true
    end
  end
  return false
end

--- Changes what a cell consists of.
---@param self table the tiles
---@param before physics.TileBoxes[] what was there
---@param after physics.TileBoxes[] what shall be there
---@param column integer
---@param row integer
function digging.change(self, before, after, column, row)
  self._fresh, self._freshList = {}, {}
  for _, boxes in ipairs(before) do
    if not digging.has(after, boxes) then
      cut(self, boxes, column, row)
    end
  end
  for _, boxes in ipairs(after) do
    if not digging.has(before, boxes) then
      fillIn(self, boxes, column, row)
    end
  end
  settle(self)
end

return digging
