--- Finds which objects of a grid a line may meet. Only queries need it.
--
-- Source: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm" (1987), by strips.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local grid = require(root .. ".broadphase.grid")

local max, min = math.max, math.min
local passage = aabb.passage
local cellAt, bucketOf, mostCells = grid.cellAt, grid.bucketOf, grid.mostCells
local FAR, SLACK, VAST = grid.FAR, grid.SLACK, 1e300
local FACTOR_X, FACTOR_Y, FACTOR_LEVEL = grid.FACTOR_X, grid.FACTOR_Y, grid.FACTOR_LEVEL
local KEY_X, KEY_Y = grid.KEY_X, grid.KEY_Y

-- A line that is shorter than this on an axis, px, stays within SLACK of where it begins.
local SHORTEST = 1e-9

-- Returns the direction of a line that goes by d on an axis: 1 or -1.
local function wayOf(d)
  return max(min(d * VAST * VAST + 1, 1), -1)
end

-- Returns what share of such a line 1 px is, like `aabb.share`, but limited, so that nothing that
-- is computed with it is infinite.
local function lineShare(d)
  return wayOf(d) / max(d, -d, SHORTEST)
end

-- Returns `one`, or `other` if `isOther` is 1.
local function choose(one, other, isOther)
  return one * (1 - isOther) + other * isOther
end

-- Returns where the line enters the fat box of slot i, up to rounding; more than 1 if it does not.
-- It has no branches, since most boxes are not entered, and no processor can predict which.
-- (jit: 2)
local function entryOf(fatLow, fatHigh, i, x, y, shareX, shareY)
  local k = 2 * i
  local left, top = fatLow[k] - SLACK - x, fatLow[k + 1] - SLACK - y
  local right, bottom = fatHigh[k] + SLACK - x, fatHigh[k + 1] + SLACK - y
  local enters, leaves = passage(left, top, right, bottom, shareX, shareY)
  return max(enters, max(enters - leaves, -leaves) * VAST)
end

-- Walks along a line through the cells of one level, strip by strip across `axis`, its longer one
-- (0: x, 1: y); see `walk`. The line begins at (x, y) and goes by (dx, dy).
--
--     +---+---+---+     An object that starts in a strip reaches into the next one at most. So
--     |   | . |.  |     a strip looks at the piece of the line up to there, and no cell is
--     |  .|   |   |     looked at twice.
--     +---+---+---+
--
-- Members, cells and strips go through one loop, since a line passes few of each: so this is one
-- function. The direction of the line is arithmetic, since branches would make a piece of code of
-- each of eight directions. (jit: 2)
local function walkLevel(self, level, cell, axis, x, y, dx, dy, line, visit, bound)
  local heads, buckets, nextInBucket, keys = self.heads, self.buckets, self.next, self.key
  local fatLow, fatHigh = self.bodies.fatLow, self.bodies.fatHigh
  local shareX, shareY = lineShare(dx), lineShare(dy)
  -- Along the line is a, across it b.
  local a1, b1, da, db =
    choose(x, y, axis), choose(y, x, axis), choose(dx, dy, axis), choose(dy, dx, axis)
  local keyA, keyB = choose(KEY_X, KEY_Y, axis), choose(KEY_Y, KEY_X, axis)
  local factorA, factorB = choose(FACTOR_X, FACTOR_Y, axis), choose(FACTOR_Y, FACTOR_X, axis)
  local base, inverse = level * FACTOR_LEVEL, 1 / buckets
  local share, way = choose(shareX, shareY, axis), wayOf(da)
  local lowest, highest, slope = min(a1, a1 + da), max(a1, a1 + da), db * share
  local reach, part, isBack = self.reach[level], 1 / cell, 0.5 - 0.5 * way
  local first, last = cellAt(lowest - reach, part), cellAt(highest, part)
  local strip, edge =
    choose(first - 1, last + 1, isBack), choose(-SLACK, cell + reach + SLACK, isBack)
  -- Strips left after this one (below 0: the end), the present cell of this strip, its last cell,
  -- and the slot that is looked at.
  local left, at, lastB, i = last - first + 1, 0, -1, 0 ---@type number, number, number, integer
  while left >= 0 do
    if i ~= 0 then
      if
        entryOf(fatLow, fatHigh, i, x, y, shareX, shareY) <= bound
        and keys[i] == strip * keyA + at * keyB + level
      then
        bound = visit(line, i, bound)
        left = bound < 0 and -1 or left
      end
      i = nextInBucket[i]
    elseif at < lastB then
      at = at + 1
      i = heads[bucketOf(strip * factorA + at * factorB + base, buckets, inverse)]
    else
      strip, left = strip + way, left - 1
      local low, high = max(lowest, strip * cell), min(highest, (strip + 1) * cell + reach)
      local from, till = b1 + (low - a1) * slope, b1 + (high - a1) * slope
      at, lastB =
        cellAt(min(from, till) - SLACK - reach, part) - 1, cellAt(max(from, till) + SLACK, part)
      if (strip * cell + edge - a1) * share > bound then
        left = -1 -- what starts in this strip, or further on, is met too late
      end
    end
  end
  return bound
end

-- Does the same for all levels, looking at all objects: cheaper than at more cells than there are
-- objects. The nearest object is visited first: mostly it is the only one.
local function walkAll(self, x, y, dx, dy, line, visit)
  local list, fatLow, fatHigh = self.list, self.bodies.fatLow, self.bodies.fatHigh
  local shareX, shareY = lineShare(dx), lineShare(dy)
  local nearest, bound = 0, 1 ---@type number, number
  for at = 1, self.count do
    local enters = entryOf(fatLow, fatHigh, list[at], x, y, shareX, shareY)
    if enters <= bound then
      nearest, bound = list[at], enters
    end
  end
  if nearest == 0 then
    return
  end
  bound = visit(line, nearest, 1)
  local at = 0
  while at < self.count and bound >= 0 do
    at = at + 1
    local i = list[at]
    if i ~= nearest and entryOf(fatLow, fatHigh, i, x, y, shareX, shareY) <= bound then
      bound = visit(line, i, bound)
    end
  end
end

--- Calls `visit(line, i, bound)` for every object i that the line from (x1, y1) to (x2, y2) may
--- meet, by its fat box. The order is more or less from near to far.
---
--- - `line` is any value for `visit`.
--- - `bound` is 1 at first, then what `visit` has returned. Objects that cannot be met before this
---   share of the line are left out. Below 0 no more objects are visited.
return function(self, x1, y1, x2, y2, line, visit)
  local dx, dy, cell, bound = x2 - x1, y2 - y1, self.cell, 1
  local wideX, wideY = max(dx, -dx), max(dy, -dy)
  if
    3 * (max(wideX, wideY) / cell + 2) > mostCells(self)
    -- So far out cells are shared (see `cellAt`).
    or max(x1, -x1, x2, -x2, y1, -y1, y2, -y2) >= (FAR - 2) * cell
  then
    return walkAll(self, x1, y1, dx, dy, line, visit)
  end
  local axis = max(min((wideY - wideX) * VAST * VAST, 1), 0)
  for level = 0, self.highest do
    if self.members[level] > 0 and bound >= 0 then
      bound = walkLevel(self, level, cell, axis, x1, y1, dx, dy, line, visit, bound)
    end
    cell = cell * 2
  end
end
