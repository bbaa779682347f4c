--- Step 2, part: what overlaps already leaves each other. Positions only.
--
-- Who was placed by the game or was left inside another is moved out by the smallest way that is
-- free: intersection rectangle, then the opposite-sides rule. A way that would end inside another
-- immovable object is none, or a box that stands deep in a floor of tiles would be thrown sideways.
-- Who finds no way out of something immovable is `buried`: it stays where it is.
-- Two that were squeezed into each other (`wedged`) are left to `meet`: they part as they came.
--
-- Reads and writes from, to, position.

local here = (...):match("^(.*)%.[^.]+$")
local aabb = require(here .. ".aabb")
local ask = require(here .. ".ask")
local begin = require(here .. ".begin")
local columns = require(here .. ".columns")
local detect = require(here .. ".detect")
local filter = require(here .. ".filter")
local rest = require(here .. ".rest")
local sort = require(here .. ".sort")

local part = {}

local huge = math.huge
local EPSILON, DYNAMIC = columns.EPSILON, columns.DYNAMIC
local ROUNDS = 8

-- The four ways out for the first of two, and the order among equals: the tutorial's.
local AXIS = { 1, 1, 0, 0 } -- bottom, top, left, right
local SIGN = { -1, 1, 1, -1 } -- where the first goes when that side of it was hit

local function isOpen(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  return not (b.sensor[i] or b.sensor[j] or b.oneWay[i] or b.oneWay[j] or b.wedged[p] ~= 0)
end

local function overlapOf(b, i, j)
  local from, size = b.from, b.size
  local ki, kj = 2 * i, 2 * j
  return aabb.overlap(
    from[ki],
    from[ki + 1],
    size[ki],
    size[ki + 1],
    from[kj],
    from[kj + 1],
    size[kj],
    size[kj + 1]
  )
end

-- Adds pair p to the work of this round if the two overlap.
local function consider(b, p)
  local work = b.partWork
  if work.stamp[p] == work.round or not isOpen(b, p) then
    return
  end
  local i, j = b.pairA[p], b.pairB[p]
  if b.kind[i] ~= DYNAMIC and b.kind[j] ~= DYNAMIC then
    return
  end
  local width, height = overlapOf(b, i, j)
  if width > EPSILON and height > EPSILON then
    work.stamp[p] = work.round
    local n = work.count + 1
    work.count = n
    work.pairs[n] = p
    local immovable = b.kind[i] ~= DYNAMIC or b.kind[j] ~= DYNAMIC
    local depth = width < height and width or height
    -- Static partners first, then the deepest; a key of one number, since depth is finite.
    work.depth[p] = immovable and -depth - work.far or -depth
    local first, second = b.rank[i], b.rank[j]
    work.first[p] = first < second and first or second
    work.second[p] = first < second and second or first
  end
end

local function considerAll(b, i)
  local half = b.head[i]
  while half ~= 0 do
    consider(b, (half + half % 2) / 2)
    half = b.next[half]
  end
end

--- Returns whether slot i at (x, y) would be inside something immovable.
function part.isInside(b, i, x, y)
  local found, w, h = b.found, b.size[2 * i], b.size[2 * i + 1]
  local n = b.broadphase:query(x, y, x + w, y + h, found)
  local from, size = b.from, b.size
  for m = 1, n do
    local j = found[m]
    local k = 2 * j
    if j ~= i and filter.blocks(b, i, j) then
      local width, height = aabb.overlap(x, y, w, h, from[k], from[k + 1], size[k], size[k + 1])
      if width > EPSILON and height > EPSILON then
        return true
      end
    end
  end
  return false
end

-- Moves slot i by `way` px along an axis; flush against `edge` if that is given.
local function shift(b, i, axis, way, edge)
  if b.kind[i] ~= DYNAMIC or way == 0 then
    return
  end
  rest.wake(b, i)
  begin.run(b)
  local k = 2 * i + axis
  b.from[k] = edge or b.from[k] + way
  b.to[k] = b.from[k]
  local work = b.partWork
  work.movedCount = work.movedCount + 1
  work.moved[work.movedCount] = i
  if not b.moved[i] then
    b.moved[i] = true
    b.movedCount = b.movedCount + 1
    b.movedList[b.movedCount] = i
  end
end

local function canGo(b, i, axis, way)
  if b.kind[i] ~= DYNAMIC then
    return false
  end
  local x, y = b.from[2 * i], b.from[2 * i + 1]
  return not part.isInside(b, i, x + (axis == 0 and way or 0), y + (axis == 1 and way or 0))
end

-- Shares of the way for i and j, the first of the two in the order of the world: by mass, whoever
-- is in the way of nobody immovable.
local function weigh(b, i, j, axis, sign, way)
  local wi, wj = b.inverseMass[i], b.inverseMass[j]
  if wi > 0 and wj > 0 then
    if b.pushable[i] ~= b.pushable[j] then
      wi, wj = b.pushable[i] and 1 or 0, b.pushable[j] and 1 or 0
    elseif b.pushFirst then
      wi, wj = 1, 0
    end
    local share = wi / (wi + wj)
    local goesI = canGo(b, i, axis, sign * way * share)
    if goesI and canGo(b, j, axis, -sign * way * (1 - share)) then
      return share
    end
    wi = goesI and 1 or 0
  end
  if wi > 0 then
    return canGo(b, i, axis, sign * way) and 1 or nil
  end
  return canGo(b, j, axis, -sign * way) and 0 or nil
end

-- Tries the way out on one side of i; returns whether it was free.
local function leave(b, i, j, exit, way)
  local axis, sign = AXIS[exit], SIGN[exit]
  local share = weigh(b, i, j, axis, sign, way)
  if not share then
    return false
  end
  local ki, kj = 2 * i + axis, 2 * j + axis
  if share < 1 then
    shift(
      b,
      j,
      axis,
      -sign * way * (1 - share),
      share == 0 and (sign < 0 and b.from[ki] + b.size[ki] or b.from[ki] - b.size[kj]) or nil
    )
  end
  if share > 0 then
    shift(
      b,
      i,
      axis,
      sign * way * share,
      sign < 0 and b.from[kj] - b.size[ki] or b.from[kj] + b.size[kj]
    )
  end
  return true
end

-- Closes the ways out on which the first would pass right through the second: if it sticks out on
-- some sides, only those are ways out; if it is wholly inside, all are.
local function closePassages(b, i, j, ways)
  local from, size = b.from, b.size
  local ki, kj = 2 * i, 2 * j
  local left = from[kj] - from[ki] > EPSILON
  local right = from[ki] + size[ki] - from[kj] - size[kj] > EPSILON
  local top = from[kj + 1] - from[ki + 1] > EPSILON
  local bottom = from[ki + 1] + size[ki + 1] - from[kj + 1] - size[kj + 1] > EPSILON
  if left or right or top or bottom then
    ways[1] = top and ways[1] or huge
    ways[2] = bottom and ways[2] or huge
    ways[3] = right and ways[3] or huge
    ways[4] = left and ways[4] or huge
  end
end

local function separate(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  if b.kind[i] ~= DYNAMIC or (b.kind[j] == DYNAMIC and b.rank[j] < b.rank[i]) then
    i, j = b.pairB[p], b.pairA[p]
  end
  local width, height = overlapOf(b, i, j)
  if width <= EPSILON or height <= EPSILON then
    return
  end
  -- Who sleeps begins the step before it is judged, or what is noted here would be forgotten then.
  rest.wake(b, i)
  begin.run(b)
  local from, size, ways = b.from, b.size, b.partWork.ways
  local ki, kj = 2 * i, 2 * j
  ways[4], ways[3], ways[1], ways[2] = aabb.exits(
    from[ki],
    from[ki + 1],
    size[ki],
    size[ki + 1],
    from[kj],
    from[kj + 1],
    size[kj],
    size[kj + 1]
  )
  local axis = height < width and 1 or 0
  if
    not ask.permits(
      b,
      from[ki + axis] <= from[kj + axis] and i or j,
      from[ki + axis] <= from[kj + axis] and j or i,
      axis
    )
  then
    return
  end
  closePassages(b, i, j, ways)
  for _ = 1, 4 do
    local exit = 1
    for other = 2, 4 do
      if ways[other] < ways[exit] then
        exit = other
      end
    end
    if ways[exit] == huge then
      break
    end
    if leave(b, i, j, exit, ways[exit]) then
      return
    end
    ways[exit] = huge
  end
  b.buried[i] = b.buried[i] or b.kind[j] ~= DYNAMIC
end

local function startRound(b)
  local work = b.partWork
  work.round = work.round + 1
  work.count, work.movedCount = 0, 0
end

--- Parts whoever was moved by the game, or left inside another by the last step.
function part.run(b)
  local work = b.partWork
  startRound(b)
  for n = 1, b.movedCount do
    considerAll(b, b.movedList[n])
  end
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.inside[i] then
      considerAll(b, i)
    end
  end
  for _ = 1, ROUNDS do
    if work.count == 0 then
      return
    end
    sort.by(work.pairs, work.count, work.depth, work.first, work.second)
    for n = 1, work.count do
      separate(b, work.pairs[n])
    end
    local movedCount = work.movedCount
    detect.run(b, work.moved, 1, movedCount)
    startRound(b)
    for n = 1, movedCount do
      considerAll(b, work.moved[n])
    end
  end
end

return part
