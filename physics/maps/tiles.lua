--- Tiles of one layer in a world: reads and changes cells, loads and unloads objects.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local check = require(root .. ".world.check")
local digging = require(root .. ".maps.digging")
local rewind = require(root .. ".maps.rewind")

local floor = math.floor

local tiles = {}

--- The place of an object that was made of tiles, as its field `tile` (of a plain array), `tiled`
--- (of Tiled) or `ldtk`.
---@class physics.TilePlace
---@field tiles physics.Tiles the layer of tiles that it belongs to
---@field column integer its left column, counted as the source counts
---@field row integer its upper row
---@field columns integer
---@field rows integer
---@field value any what stands in its cells, nil: different values (from Tiled it is called `gid`)
---@field package _boxes physics.TileBoxes

--- Tiles of one layer in a world. Columns and rows are counted as their source counts them: from 1
--- in the lists of `addTiles`, from 0 in Tiled and LDtk.
---@class physics.Tiles
---@field world physics.World where they are
---@field x number px, left edge of the first column
---@field y number px, upper edge of the first row
---@field tileWidth number px
---@field tileHeight number px
---@field firstColumn integer
---@field firstRow integer
---@field columns integer
---@field rows integer
---@field tiles integer how many solid boxes of tiles there are
---@field rectangles integer how many objects they are
---@field package _access table what it may do with its world: check, put, remove
---@field package _restores integer how often the world had been put back when it was looked at last
---@field package _isAway boolean are its objects to stay out of the world
---@field package _leaving physics.Object[]? those that go, some at a time
---@field package _left integer how many of these have gone
---@field package _values table<integer, any> cell -> value, of those that are not empty
---@field package _empty any value of an empty cell
---@field package _isEmpty table<any, boolean> other values that mean the same
---@field package _list physics.TileBoxes[] all boxes
---@field package _piecesOf fun(value: any, where: string?): physics.TileBoxes[]
local Tiles = {}
Tiles.__index = Tiles

--- Returns tiles without any solid cell, in no world yet; `given` is what `cells.open` takes.
---@param given table
---@return physics.Tiles
function tiles.new(given)
  local self = {} ---@type table
  cells.open(self, given)
  return setmetatable(self, Tiles)
end

--- Sets the world that the objects of the tiles belong to.
---@param self physics.Tiles
---@param world table
---@param access table what they may do with it: check, put, remove
---@param waiting physics.Object[]|false? those that are not a part of it yet
function tiles.attach(self, world, access, waiting)
  self.world, self._access, self._restores = world, access, world._restores
  self._isAway = waiting and true or false
  for _, object in ipairs(waiting or {}) do
    cells.wait(self, object)
  end
end

local function checkSelf(self, call)
  if getmetatable(self) ~= Tiles then
    check.fail(
      "tiles:" .. call .. " must be called with a colon on tiles, got " .. check.show(self)
    )
  end
end

local function checkCell(self, column, row, where)
  check.integer(column, "column", where, self.firstColumn, self.firstColumn + self.columns - 1)
  check.integer(row, "row", where, self.firstRow, self.firstRow + self.rows - 1)
end

local function groupsOf(list)
  local groups = {}
  for i = 1, #list do
    groups[i] = list[i].group
  end
  return groups
end

--- Digs and builds: changes the value of one cell. Only the rectangle that covers it is cut. New
--- tiles merge with equal neighbours; all others stay as they are. What rested on it wakes up, or
--- stays at rest, at the next update.
---
--- Errors: the cell is outside of the layer; its source does not know the value; it is called from
--- inside `canCollide`. Nothing has changed then.
---@param column integer as the source counts: from 1 in the lists of `addTiles`, else from 0
---@param row integer likewise
---@param value any as in the source: 0 digs, nil does, too
---@return boolean changed false: the cell had this value already
function Tiles:setTile(column, row, value)
  local where = "tiles:setTile(column, row, value)"
  checkSelf(self, "setTile(column, row, value)")
  checkCell(self, column, row, where)
  if value == nil then
    value = self._empty
  end
  local after = self._piecesOf(value, where)
  if #after == 0 and self._isEmpty[value] then
    value = self._empty
  end
  self._access.check(self.world, where, groupsOf(after))
  rewind.follow(self)
  local index = cells.indexOf(self, column, row)
  local old = self._values[index]
  if old == nil then
    old = self._empty
  end
  if old == value then
    return false
  end
  self._values[index] = nil
  if value ~= self._empty then
    self._values[index] = value
  end
  digging.change(self, self._piecesOf(old, where), after, column, row)
  return true
end

--- Returns the value of a cell.
---
--- Errors: the cell is outside of the layer.
---@param column integer counted as the source counts
---@param row integer likewise
---@return any value as in the source; an empty cell is 0 (`false` if 0 is solid)
function Tiles:getTile(column, row)
  checkSelf(self, "getTile(column, row)")
  checkCell(self, column, row, "tiles:getTile(column, row)")
  rewind.follow(self)
  local value = self._values[cells.indexOf(self, column, row)]
  if value == nil then
    return self._empty
  end
  return value
end

--- Returns the cell at a point. Its left and upper edges belong to it.
---
--- Errors: a coordinate is not a finite number.
---@param x number px
---@param y number px
---@return integer? column nil: the point is outside of the layer
---@return integer? row
function Tiles:cellAt(x, y)
  checkSelf(self, "cellAt(x, y)")
  check.number(x, "x", "tiles:cellAt(x, y)")
  check.number(y, "y", "tiles:cellAt(x, y)")
  local column = self.firstColumn + floor((x - self.x) / self.tileWidth)
  local row = self.firstRow + floor((y - self.y) / self.tileHeight)
  if cells.isInside(self, column, row) then
    return column, row
  end
end

local function checkCount(count, where)
  if count ~= nil then
    check.integer(count, "count", where, 1, 1e9)
  end
  return count or 1 / 0
end

--- Puts waiting objects into the world: all, or `count` of them, so that a large layer can come
--- over several frames. Objects wait after `unload`, and from the beginning with the option
--- `later`.
---
--- Errors: the count is not an integer >= 1; it is called from inside `canCollide`.
---@param count integer? >= 1, default all
---@return integer left how many still wait
function Tiles:load(count)
  local where = "tiles:load(count)"
  checkSelf(self, "load(count)")
  local most = checkCount(count, where)
  self._access.check(self.world, where, groupsOf(self._list))
  rewind.follow(self)
  self._isAway, self._leaving = false, nil
  return cells.bring(self, most)
end

--- Takes objects out of the world: all, or `count` of them. They wait until `load` brings them
--- back. Meanwhile `setTile` can change them.
---
--- Errors: the count is not an integer >= 1; it is called from inside `canCollide`.
---@param count integer? >= 1, default all
---@return integer left how many are still in the world
function Tiles:unload(count)
  local where = "tiles:unload(count)"
  checkSelf(self, "unload(count)")
  local most = checkCount(count, where)
  self._access.check(self.world, where, {})
  rewind.follow(self)
  if not self._leaving then
    self._leaving, self._left = {}, 0
    rewind.eachInWorld(self, function(_, object)
      self._leaving[#self._leaving + 1] = object
    end)
  end
  self._isAway = true
  return cells.takeOut(self, most)
end

return tiles
