--- The layout of crowds: moves the bodies of each crowd (see crowd.lua) to places in columns.
--
-- There are as many columns as the room between the walls around a crowd has space for. Each body
-- moves towards its place by at most a fixed share of its size in a step. All members have one
-- velocity.
--
-- Reads crowdList, crowd, from, size; writes from, to, way, velocity, stoodAt, news.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local begin = require(root .. ".motion.begin")
local crowd = require(root .. ".solver.crowd")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")
local pairFinder = require(root .. ".broadphase.pairFinder")
local separate = require(root .. ".solver.separate")
local sort = require(root .. ".memory.sort")

require(root .. ".memory.jit").file()

local crowdLayout = {}

local ceil, floor, sqrt = math.ceil, math.floor, math.sqrt
local max, min = math.max, math.min
--- Share of its size by which a body moves to its place in a step, along each axis.
crowdLayout.PACE = 0.5
local PACE = crowdLayout.PACE
-- Distance from a wall at which a body still stands on it, px.
local NEAR = 1

-- Returns the edges of the room around (x, y), up to `reach` px away: left, top, right, bottom.
-- Walls count that are less than `halfW` or `halfH` px from the lines through that point.
local function findRoom(b, i, x, y, reach, halfW, halfH)
  local left, top, right, bottom = x - reach, y - reach, x + reach, y + reach
  local from, size, found = b.from, b.size, b.found
  for n = 1, b.broadphase:query(left, top, right, bottom, found) do
    local j = found[n]
    if j ~= i and filter.blocks(b, i, j) then
      local k = 2 * j
      local x1, y1, x2, y2 = from[k], from[k + 1], from[k] + size[k], from[k + 1] + size[k + 1]
      if y1 < y + halfH and y2 > y - halfH then
        if x2 <= x then
          left = max(left, x2)
        elseif x1 >= x then
          right = min(right, x1)
        end
      end
      if x1 < x + halfW and x2 > x - halfW then
        if y2 <= y then
          top = max(top, y2)
        elseif y1 >= y then
          bottom = min(bottom, y1)
        end
      end
    end
  end
  return left, top, right, bottom
end

-- Returns where a stretch of `length` px begins that is centred on `center`, but kept between two
-- edges. The low edge wins.
local function fit(center, length, low, high)
  local at = center - length * 0.5
  return max(min(at, high - length), low)
end

-- Moves a body towards its place, unless a wall is in the way: on both axes, or on one.
local function go(b, i, x, y)
  local k = 2 * i
  local atX, atY = b.from[k], b.from[k + 1]
  local stepX, stepY = b.size[k] * PACE, b.size[k + 1] * PACE
  local toX = atX + max(min(x - atX, stepX), -stepX)
  local toY = atY + max(min(y - atY, stepY), -stepY)
  if toX == atX and toY == atY then
    return
  elseif separate.isInside(b, i, toX, toY) then
    if toX ~= atX and not separate.isInside(b, i, toX, atY) then
      toY = atY
    elseif toY ~= atY and not separate.isInside(b, i, atX, toY) then
      toX = atX
    else
      return
    end
  end
  b.from[k], b.from[k + 1], b.to[k], b.to[k + 1] = toX, toY, toX, toY
  islands.wakeNeighbours(b, i)
end

-- Returns the number of columns of a crowd of n bodies: about as wide as high, if there is room.
local function countColumns(n, width, height, roomW, roomH)
  local across = ceil(sqrt(n * height / width))
  local down = ceil(n / across)
  if across * width > roomW then
    across = max(floor(roomW / width), 1)
    down = ceil(n / across)
  end
  if down * height > roomH then
    down = max(floor(roomH / height), 1)
    across = ceil(n / down)
  end
  return across
end

-- Puts the members of a column below each other, in the order of y.
local function layColumn(b, column, n, x, y, top, bottom)
  local key, height = b.crowdKey, 0.0
  for at = 1, n do
    key[column[at]] = crowd.middle(b, 2 * column[at] + 1)
    height = height + b.size[2 * column[at] + 1]
  end
  sort.by(column, n, key, b.rank, b.rank)
  local place = fit(y, height, top, bottom)
  for at = 1, n do
    local i = column[at]
    go(b, i, x - b.size[2 * i] * 0.5, place)
    place = place + b.size[2 * i + 1]
  end
end

-- Returns whether a body is at the edge of the room of its crowd to which gravity points.
local function isAtBottom(b, i, left, top, right, bottom)
  local axis = b.downAxis
  local k = 2 * i + axis
  if b.orientation[axis] > 0 then
    return b.from[k] + b.size[k] >= (axis == 1 and bottom or right) - NEAR
  end
  return b.from[k] <= (axis == 1 and top or left) + NEAR
end

-- Notes that a crowd does not fall in this step, if one of its members stands on something.
local function stand(b, list, first, last, left, top, right, bottom)
  local isStanding = false
  for at = first, last do
    local i = list[at]
    isStanding = isStanding or b.support[i] ~= 0 or isAtBottom(b, i, left, top, right, bottom)
  end
  for at = first, isStanding and last or 0 do
    b.stoodAt[list[at]] = b.crowdStamp
  end
end

--- Takes the fall off the bodies of standing crowds, once their free flight is known.
function crowdLayout.hold(b)
  for at = 1, b.crowdCount do
    local i = b.crowdList[at]
    for k = 2 * i, b.stoodAt[i] == b.crowdStamp and 2 * i + 1 or 0 do
      if b.speed[k] * b.down[k] > 0 then
        b.speed[k], b.way[k], b.to[k] = b.carried[k], 0.0, b.from[k]
      end
    end
  end
end

-- Gives all bodies of a crowd their common velocity, as impacts without a bounce would. Otherwise
-- they would pass through each other from one side to the other.
local function joinSpeeds(b, list, first, last)
  local velocity, mass, x, y, sum = b.velocity, b.mass, 0.0, 0.0, 0.0
  for at = first, last do
    local i = list[at]
    sum, x, y = sum + mass[i], x + mass[i] * velocity[2 * i], y + mass[i] * velocity[2 * i + 1]
  end
  for at = first, last do
    velocity[2 * list[at]], velocity[2 * list[at] + 1] = x / sum, y / sum
  end
end

-- Lays out the crowd list[first..last], which is sorted by x, in columns.
local function lay(b, list, first, last)
  local n = last - first + 1
  joinSpeeds(b, list, first, last)
  local x, y, width, height = crowd.measure(b, list, first, last)
  local reach = 2 * sqrt(n) * max(width, height) + max(width, height)
  local left, top, right, bottom = findRoom(b, list[first], x, y, reach, width * 0.5, height * 0.5)
  local across = countColumns(n, width, height, right - left, bottom - top)
  local total, at, column = 0.0, first, b.crowdColumn
  for c = 1, across do
    local until_, widest = first + floor(n * c / across + 0.5) - 1, 0.0
    for m = at, until_ do
      widest = max(widest, b.size[2 * list[m]])
    end
    b.columnWidth[c], at = widest, until_ + 1
    total = total + widest
  end
  local place = fit(x, total, left, right)
  at = first
  for c = 1, across do
    local until_, size = first + floor(n * c / across + 0.5) - 1, 0
    for m = at, until_ do
      size = size + 1
      column[size] = list[m]
    end
    local middleX = place + b.columnWidth[c] * 0.5
    layColumn(b, column, size, middleX, y, top, bottom)
    place, at = place + b.columnWidth[c], until_ + 1
  end
  stand(b, list, first, last, left, top, right, bottom)
  for m = first, last do
    b.news[list[m]] = true -- none of them sleeps in this step
  end
end

--- Moves the bodies of each crowd towards their places.
function crowdLayout.run(b)
  if b.crowdCount > 0 then
    crowd.forEach(b, b.crowdList, b.crowdCount, lay)
    pairFinder.run(b, b.crowdList, 1, b.crowdCount)
    begin.run(b)
  end
end

return crowdLayout
