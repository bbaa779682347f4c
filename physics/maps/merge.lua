--- Covers cells of a grid with few rectangles.

local merge = {}

-- How many free cells follow each other from `first` on, at most one row of them: the grid has a
-- column that is never free at its right end.
local function countRight(free, first)
  local columns = 1
  while free[first + columns] do
    columns = columns + 1
  end
  return columns
end

-- Is there the very same run of cells: free ones, and none beside them that would belong to it.
local function isSameRun(free, first, columns, isWide)
  if isWide and (free[first - 1] or free[first + columns]) then
    return false
  end
  for index = first, first + columns - 1 do
    if not free[index] then
      return false
    end
  end
  return true
end

local function countDown(free, first, columns, stride, isWide)
  local rows = 1
  while isSameRun(free, first + rows * stride, columns, isWide) do
    rows = rows + 1
  end
  return rows
end

local function take(free, first, columns, rows, stride)
  for row = 0, rows - 1 do
    for index = first + row * stride, first + row * stride + columns - 1 do
      free[index] = nil
    end
  end
end

--- Returns rectangles that cover the cells, each cell once, as one flat list: index of the top-left
--- cell, columns, rows, and so on. Greedy: the first cell that is left, row by row, grows to the
--- right as far as it goes, and then down over rows that are equally long. So a floor stays one,
--- whatever stands on it; on most levels this gives fewer than to grow over longer rows as well.
---@param cells integer[] ascending; a cell is row * stride + column
---@param count integer
---@param stride integer more than the columns, so that no row runs into the next one
---@param isWide boolean may cells of a row become one
---@param isTall boolean may cells of a column become one (alone, or whole rows of them)
---@return integer[] rectangles
---@return integer count numbers in the list
function merge.cover(cells, count, stride, isWide, isTall)
  local free, found, n = {}, {}, 0
  for i = 1, count do
    free[cells[i]] = true
  end
  for i = 1, count do
    local first = cells[i]
    if free[first] then
      local columns = isWide and countRight(free, first) or 1
      local rows = isTall and countDown(free, first, columns, stride, isWide) or 1
      take(free, first, columns, rows, stride)
      found[n + 1], found[n + 2], found[n + 3] = first, columns, rows
      n = n + 3
    end
  end
  return found, n
end

return merge
