---@diagnostic disable
--- Grid: finds in a hierarchical grid which fat boxes meet others, or a rectangle (for lines see
-- gridLines.lua). It is a hash table of fixed arrays.
--
-- An object is in exactly one cell: the cell that holds the top-left corner of its fat box, on the
-- first level with cells at least as large as the box. Each level doubles the size of the cells:
--
--      level 0                level 1
--      +---+---+---+---+      +-------+-------+      a is as large as a cell of level 0 or smaller,
--      |   | a-|-. |   |      |       |       |      b of level 1. So a box reaches from its cell
--      +---+-|-+-|-+---+      |   b---|----.  |      into the next one at most, on its level.
--      |   | `-|-' |   |      |   `---|----'  |
--      +---+---+---+---+      +-------+-------+
--
-- A query looks at the cells of its rectangle on every level in use, and at the cells before them,
-- as far as the boxes of the level are wide (`reach`). No object that meets the rectangle can start
-- in another cell. On a single level, small objects among large ones would share few huge cells, or
-- large objects would be in many small ones; with levels, a query looks at a few cells for each
-- level that is in use. If its rectangle would take more cells of level 0 than there are objects
-- (`mostCells`), it looks at all objects. Results have no order.
--
-- Cells are lists in buckets, which the hash of a cell chooses: a power of two of them, four times
-- as many (`grow`) where there are more objects than buckets. So empty cells cost nothing and leave
-- nothing behind. Two cells may share a bucket: the key of an object tells which cell it is in.
--
-- A query lists *ranges* of six numbers: its place in the list of questions, the level, the first
-- and last cell along x, and along y. The `reach` of a level never shrinks.
--
-- Source: M. Teschner et al., "Optimized Spatial Hashing for Collision Detection of Deformable
-- Objects" (2003), for the hash; T. Ulrich, "Loose Octrees", for one cell per object and level.

---@class physics.Grid
---@field [string] any
local grid = {}
grid.__index = grid

local ceil, floor, huge, max, min = math.ceil, math.floor, math.huge, math.max, math.min

local DEFAULT_CELL = 48
local LEVELS = 18
local FIRST_BUCKETS = 64
-- By a number of cells of level 0 side by side: the first level with cells that are as wide as all
-- of these, and the width of such a cell in cells of level 0.
---@type number[], number[]
local LEVEL_OF, WIDTH_OF = { 0 }, { 1 }
for n = 2, 64 do
  LEVEL_OF[n], WIDTH_OF[n] = LEVEL_OF[ceil(n / 2)] + 1, WIDTH_OF[ceil(n / 2)] * 2
end
-- Cells further out than this share the outermost one, so that the arithmetic stays exact.
local FAR = 4194304
-- px, by which reaches and lines are wider: more than the rounding error of a place.
local SLACK = 1e-3
-- Factors of `hash` for the place and the level of a cell.
local FACTOR_X, FACTOR_Y, FACTOR_LEVEL = 73856093, 19349663, 83492791
-- Factors of the key of a cell, which no other cell has: a whole number below 2^53 that holds the
-- place and the level.
local KEY_X, KEY_Y = 1073741824, 64

-- For gridLines.
grid.FAR, grid.SLACK, grid.KEY_X, grid.KEY_Y = FAR, SLACK, KEY_X, KEY_Y
grid.FACTOR_X, grid.FACTOR_Y, grid.FACTOR_LEVEL = FACTOR_X, FACTOR_Y, FACTOR_LEVEL

-- Sets the number of buckets, all empty.
local function makeBuckets(self, count)
  self.buckets = count
  for bucket = 0, count do
    self.heads[bucket] = 0
  end
end

--- Returns an empty grid over the columns `b`; `cellSize` in px, default 48. `comparesAll`: it
--- compares all objects with each other, to see that the cells change no result.
function grid.new(b, cellSize, comparesAll)
  local self = setmetatable({
    bodies = b,
    comparesAll = comparesAll,
    cell = cellSize or DEFAULT_CELL,
    list = {}, -- slots in the grid, from 1 on
    count = 0,
    heads = {}, -- by bucket, from 1 on: the first slot in it
    -- by slot
    placeOf = {}, -- place in the list, nil: it is not in the grid
    key = {}, -- of the cell
    next = {}, -- in the bucket
    previous = {}, -- below 0: it is the first in the bucket of that number
    -- by level
    members = {},
    reach = {}, -- px: no box of a member is wider or higher; mostly below the cell size
    highest = 0, -- level that was ever in use
    -- scratch of overlaps: cells to look at, and the objects that ask for them
    cells = {},
    ranges = {},
    querySlots = { 0 },
    askers = {},
  }, grid)
  makeBuckets(self, FIRST_BUCKETS)
  for level = 0, LEVELS do
    self.members[level], self.reach[level] = 0, 0
  end
  return self
end

---@return integer
local function cellAt(coordinate, share)
  return max(min(floor(coordinate * share), FAR), -FAR)
end

-- `share` is 1 / buckets, exactly: the number of buckets is a power of two.
local function bucketOf(h, buckets, share)
  return h - floor(h * share) * buckets + 1
end

local function hash(cellX, cellY, level)
  return cellX * FACTOR_X + cellY * FACTOR_Y + level * FACTOR_LEVEL
end

local function keyOf(cellX, cellY, level)
  return cellX * KEY_X + cellY * KEY_Y + level
end

-- Returns the level for boxes of a size, and the size of its cells. There is no loop in it: LuaJIT
-- of 2022 has lost the bounds of the loops from which it was called.
local function levelFor(self, size)
  local level, cell = 0, self.cell
  if size > 4096 * cell then
    level, cell = 12, 4096 * cell
  elseif size > 64 * cell then
    level, cell = 6, 64 * cell
  end
  local n = ceil(max(min(size / cell, 64), 1)) -- far out a size may be 0 by rounding
  return level + LEVEL_OF[n], cell * WIDTH_OF[n]
end

-- The lists are changed without branches (jit: 2): writes that belong to no object go to place 0 of
-- each column, and to bucket 0.

local function file(self, i, level, cellX, cellY)
  local bucket = bucketOf(hash(cellX, cellY, level), self.buckets, 1 / self.buckets)
  local heads = self.heads
  local first = heads[bucket]
  self.next[i], self.previous[i], self.key[i] = first, -bucket, keyOf(cellX, cellY, level)
  self.previous[first], heads[bucket] = i, i
  self.members[level], self.highest = self.members[level] + 1, max(self.highest, level)
end

local function unfile(self, i)
  local before, after, level = self.previous[i], self.next[i], self.key[i] % KEY_Y
  self.next[max(before, 0)], self.previous[after] = after, before
  self.heads[max(-before, 0)] = after
  self.members[level] = self.members[level] - 1
end

-- Returns the cell to which slot i belongs: level, x, y. Extends the reach of the level, since an
-- object that stays in its cell may have become wider.
local function place(self, i)
  local b, reach = self.bodies, self.reach
  local fatLow, fatHigh = b.fatLow, b.fatHigh
  local k = 2 * i
  local left, top = fatLow[k], fatLow[k + 1]
  local size = max(fatHigh[k] - left, fatHigh[k + 1] - top)
  local level, cell = levelFor(self, size)
  reach[level] = max(reach[level], size + SLACK)
  local share = 1 / cell
  return level, cellAt(left, share), cellAt(top, share)
end

local function grow(self)
  for n = 1, self.count do
    unfile(self, self.list[n])
  end
  makeBuckets(self, self.buckets * 4)
  for n = 1, self.count do
    local i = self.list[n]
    file(self, i, place(self, i))
  end
end

--- Puts an object into the grid, or notes that its fat box has changed.
function grid:put(i)
  local level, cellX, cellY = place(self, i)
  if not self.placeOf[i] then
    self.count = self.count + 1
    self.list[self.count], self.placeOf[i] = i, self.count
  elseif keyOf(cellX, cellY, level) == self.key[i] then
    return
  else
    unfile(self, i)
  end
  file(self, i, level, cellX, cellY)
  if self.count > self.buckets then
    grow(self)
  end
end

function grid:remove(i)
  unfile(self, i)
  local at, last = self.placeOf[i], self.list[self.count]
  self.list[at] = last
  self.placeOf[last] = at
  self.placeOf[i] = nil
  self.count = self.count - 1
end

-- Overlaps of many objects are found in stages, each of which is one loop (jit: 3):
-- 1. which rectangles of cells to look at;
-- 2. which of those cells hold anything;
-- 3. which objects are in them.
--
-- A rectangle of cells is six numbers side by side, a cell is three.
local RANGE, CELL = 6, 3

-- Returns the number of cells from which on comparing with all objects is cheaper. If an object is
-- wider than the largest cells, it may reach over any number of them: then it always is.
local function mostCells(self)
  local isAll = self.comparesAll or self.reach[LEVELS] > self.cell * 2 ^ LEVELS + SLACK
  return isAll and -huge or 16 + self.count
end

-- Returns whether a rectangle takes more than `most` cells.
local function isWide(self, width, height, most)
  local cell = self.cell
  return (width / cell + 3) * (height / cell + 3) > most
end

-- Lists the rectangles of cells of one level in which objects may meet the fat boxes of the objects
-- in `list`.
local function addRanges(self, list, count, level, cell, most, n)
  local reach, share = self.reach[level], 1 / cell
  local ranges, fatLow, fatHigh = self.ranges, self.bodies.fatLow, self.bodies.fatHigh
  for m = 1, count do
    local k = 2 * list[m]
    local left, top, right, bottom = fatLow[k], fatLow[k + 1], fatHigh[k], fatHigh[k + 1]
    if not isWide(self, right - left, bottom - top, most) then
      ranges[n + 1], ranges[n + 2] = m, level
      ranges[n + 3], ranges[n + 4] = cellAt(left - reach, share), cellAt(right, share)
      ranges[n + 5], ranges[n + 6] = cellAt(top - reach, share), cellAt(bottom, share)
      n = n + RANGE
    end
  end
  return n
end

-- Lists the cells of these rectangles that hold anything. Each is the first slot in it, the place
-- in `list` of the object that asks, and its key.
local function addCells(self, rangeCount)
  local ranges, cells, heads, buckets = self.ranges, self.cells, self.heads, self.buckets
  local n, at, share = 0, 0, 1 / buckets
  local level, cellX, lastX, cellY = ranges[2], ranges[3], ranges[4], ranges[5]
  local h = hash(cellX, cellY, level)
  while at < rangeCount do
    local head = heads[bucketOf(h, buckets, share)]
    if head ~= 0 then
      cells[n + 1], cells[n + 2], cells[n + 3] = head, ranges[at + 1], keyOf(cellX, cellY, level)
      n = n + CELL
    end
    cellX, h = cellX + 1, h + FACTOR_X
    if cellX > lastX then
      cellX, cellY = ranges[at + 3], cellY + 1
      if cellY > ranges[at + 6] then
        at = at + RANGE
        level, cellX = ranges[at + 2], ranges[at + 3]
        lastX, cellY = ranges[at + 4], ranges[at + 5]
      end
      h = hash(cellX, cellY, level)
    end
  end
  return n
end

-- Returns a number >= 0 if two fat boxes meet. (jit: 2)
local function contact(fatLow, fatHigh, k, m)
  return min(
    fatHigh[k] - fatLow[m],
    fatHigh[m] - fatLow[k],
    fatHigh[k + 1] - fatLow[m + 1],
    fatHigh[m + 1] - fatLow[k + 1]
  )
end

-- Walks through the cells, and lists the objects in them that meet the object that asks.
local function addMembers(self, list, cellCount, askers, found)
  local cells, nextInBucket, keys = self.cells, self.next, self.key
  local fatLow, fatHigh = self.bodies.fatLow, self.bodies.fatHigh
  local n, at = 0, 0
  local i, asker = cells[1], list[cells[2]]
  while at < cellCount do
    if contact(fatLow, fatHigh, 2 * asker, 2 * i) >= 0 and keys[i] == cells[at + 3] then
      n = n + 1
      askers[n], found[n] = asker, i
    end
    i = nextInBucket[i]
    if i == 0 then
      at = at + CELL
      i, asker = cells[at + 1], list[cells[at + 2]]
    end
  end
  return n
end

-- Compares one object with all others, if its box is wide.
local function addAll(self, asker, askers, found, n)
  local fatLow, fatHigh, all = self.bodies.fatLow, self.bodies.fatHigh, self.list
  for at = 1, self.count do
    local i = all[at]
    if contact(fatLow, fatHigh, 2 * asker, 2 * i) >= 0 then
      n = n + 1
      askers[n], found[n] = asker, i
    end
  end
  return n
end

--- Finds for each object in `list[1..count]` all objects with a fat box that meets its own, itself
--- included. Writes the one that it meets into `found`, and the object of the list into
--- `self.askers`. Returns how many there are.
function grid:overlaps(list, count, found)
  local askers, ranges, cell, most = self.askers, 0, self.cell, mostCells(self)
  for level = 0, self.highest do
    if self.members[level] > 0 then
      ranges = addRanges(self, list, count, level, cell, most, ranges)
    end
    cell = cell * 2
  end
  for behind = ranges + 2, ranges + 5 do -- read, but not used
    self.ranges[behind] = 0
  end
  local cells = addCells(self, ranges)
  self.cells[cells + 1], self.cells[cells + 2] = 0, 1
  local n = addMembers(self, list, cells, askers, found)
  local fatLow, fatHigh = self.bodies.fatLow, self.bodies.fatHigh
  for m = 1, count do
    local k = 2 * list[m]
    if isWide(self, fatHigh[k] - fatLow[k], fatHigh[k + 1] - fatLow[k + 1], most) then
      n = addAll(self, list[m], askers, found, n)
    end
  end
  return n
end

--- Writes the slots of all objects with a fat box that meets the rectangle into `out`. Returns how
--- many there are. (Slot 0, which is no object, has the rectangle as its fat box.)
function grid:query(left, top, right, bottom, out)
  local fatLow, fatHigh = self.bodies.fatLow, self.bodies.fatHigh
  fatLow[0], fatLow[1], fatHigh[0], fatHigh[1] = left, top, right, bottom
  return (self:overlaps(self.querySlots, 1, out))
end

grid.cellAt, grid.bucketOf, grid.mostCells, grid.contact = cellAt, bucketOf, mostCells, contact

--- Returns the cell of slot i, counted from 0, 0, and its width in px.
function grid:cellOf(i)
  local key = self.key[i]
  local level = key % KEY_Y
  local cellX = floor(key / KEY_X + 0.5)
  return cellX, (key - level - cellX * KEY_X) / KEY_Y, self.cell * 2 ^ level
end

return grid
