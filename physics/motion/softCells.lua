--- The cells in which bodies that overlap softly are found (see drift).
--
-- They are sorted by counting. The plane is wound around a ring of cells, so it has no edge. Two
-- bodies are compared once.
-- Source: S. Green, "Particle Simulation using CUDA" (2008).
--
-- Reads the places and sizes in the scratch lists of drift; writes one, other, meanSize.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local softCells = {}

local floor, max = math.floor, math.max

-- The fewest cells; there are about twice as many as bodies.
local FEWEST_CELLS = 16.0
-- A cell is so many times as wide as the mean body. Few bodies may be larger; they are compared
-- with all others.
local CELL, FEW_LARGE = 1.5, 8
-- Rounds sizes, so that their sum does not depend on the order (see drift).
local ROUNDING = 6442450944.0

-- How wide a cell is: few bodies are larger.
local function cellSize(work)
  local halfX, halfY, sum, count = work.halfX, work.halfY, 0.0, work.count
  for n = 1, count do
    sum = sum + (halfX[n] + halfY[n] + ROUNDING - ROUNDING)
  end
  work.meanSize = max(sum / count, columns.TINY)
  local size = work.meanSize * CELL
  for _ = 1, 64 do
    local large = 0 ---@type number
    for n = 1, count do
      large = large + (2 * max(halfX[n], halfY[n]) > size and 1 or 0)
    end
    if large <= FEW_LARGE then
      break
    end
    size = size * 1.5
  end
  return size
end

-- Sorts the bodies by cells; returns the number of those that fit into one, and the large ones'.
-- Cell (x, y) is number (x + y * row) of a ring of `cells`.
local function sortCells(work, size, cells, row)
  local x, y, halfX, halfY, cell, start =
    work.x, work.y, work.halfX, work.halfY, work.cell, work.start
  local large, largeCount, part, share = work.large, 0, 1 / size, 1 / cells
  for c = 0, cells + 4 do
    start[c] = 0
  end
  for n = 1, work.count do
    if 2 * max(halfX[n], halfY[n]) > size then
      largeCount = largeCount + 1
      large[largeCount], cell[n] = n, -1
    else
      local at = floor(x[n] * part) + floor(y[n] * part) * row
      at = at - floor(at * share) * cells
      cell[n], start[at] = at, start[at] + 1
    end
  end
  local sum = 1 ---@type number
  for c = 0, cells - 1 do
    sum = sum + start[c]
    start[c] = sum -- where the next one begins
  end
  return sum - 1, largeCount
end

-- Puts them in that order. The last ones go first, so that each cell keeps the order of the world.
local function place(work, count, cells)
  local cell, start, sorted = work.cell, work.start, work.sorted
  for n = work.count, 1, -1 do
    local at = cell[n]
    if at >= 0 then
      start[at] = start[at] - 1
      sorted[start[at]] = n
    end
  end
  -- Behind the end of the ring it begins anew.
  for c = cells, cells + 4 do
    start[c] = count + 1
  end
  local x, y, halfX, halfY = work.x, work.y, work.halfX, work.halfY
  local sx, sy, shx, shy = work.sx, work.sy, work.shx, work.shy
  for p = 1, count do
    local n = sorted[p]
    sx[p], sy[p], shx[p], shy[p] = x[n], y[n], halfX[n], halfY[n]
  end
end

-- Lists the ranges that are to be compared with each body: what follows in its cell and the next
-- one, and three cells of the next row. Returns how many.
local function listRanges(work, count, cells, row)
  local sorted, cell, start = work.sorted, work.cell, work.start
  local asker, from, last, n = work.asker, work.from, work.last, 0
  for p = 1, count do
    local at = cell[sorted[p]]
    local final = start[at + 2] - 1
    if at + 2 > cells then -- the next cell is the first one of the ring
      final = count
      if start[1] > 1 then
        n = n + 1
        asker[n], from[n], last[n] = p, 1, start[1] - 1
      end
    end
    if final > p then
      n = n + 1
      asker[n], from[n], last[n] = p, p + 1, final
    end
    local below = at + row - 1
    below = below >= cells and below - cells or below
    local first, beyond = start[below], below + 3 - cells
    local till = start[below + 3] - 1
    if beyond > 0 then
      till = count
      if start[beyond] > 1 then
        n = n + 1
        asker[n], from[n], last[n] = p, 1, start[beyond] - 1
      end
    end
    if till >= first then
      n = n + 1
      asker[n], from[n], last[n] = p, first, till
    end
  end
  return n
end

-- Lists those that overlap in the ranges; returns how many.
local function compare(work, ranges)
  if ranges == 0 then
    return 0
  end
  local sx, sy, shx, shy, sorted = work.sx, work.sy, work.shx, work.shy, work.sorted
  local asker, from, last, one, other = work.asker, work.from, work.last, work.one, work.other
  local r, count = 1, 0
  local p, q, final = asker[1], from[1], last[1]
  local x, y, halfX, halfY = sx[p], sy[p], shx[p], shy[p]
  while r <= ranges do
    local dx, dy, w, h = sx[q] - x, sy[q] - y, halfX + shx[q], halfY + shy[q]
    if dx < w and -dx < w and dy < h and -dy < h then
      count = count + 1
      one[count], other[count] = sorted[p], sorted[q]
    end
    q = q + 1
    if q > final then
      r = r + 1
      p, q, final = asker[r] or 1, from[r] or 1, last[r] or 1
      x, y, halfX, halfY = sx[p], sy[p], shx[p], shy[p]
    end
  end
  return count
end

-- The same of the large ones and all others.
local function compareLarge(work, largeCount, count)
  local x, y, halfX, halfY, cell = work.x, work.y, work.halfX, work.halfY, work.cell
  local one, other = work.one, work.other
  for m = 1, largeCount do
    local n = work.large[m]
    for o = 1, work.count do
      local dx, dy = x[o] - x[n], y[o] - y[n]
      local w, h = halfX[n] + halfX[o], halfY[n] + halfY[o]
      if dx < w and -dx < w and dy < h and -dy < h and (cell[o] >= 0 or o > n) then
        count = count + 1
        one[count], other[count] = n, o
      end
    end
  end
  return count
end

--- Lists in `one` and `other` those that overlap; returns how many pairs.
function softCells.findOverlaps(work)
  local cells = FEWEST_CELLS ---@type number
  while cells < 2 * work.count do
    cells = cells * 2
  end
  local row = floor(cells * 0.381966) + 0.0 -- rows that follow each other lie far apart on the ring
  local count, largeCount = sortCells(work, cellSize(work), cells, row)
  place(work, count, cells)
  local found = compare(work, listRanges(work, count, cells, row))
  return compareLarge(work, largeCount, found)
end

return softCells
