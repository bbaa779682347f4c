--- Separate: computes from bodies that overlap when the step begins the places where they do not.
-- Positions only.
--
-- A body that was placed by the game, or was left overlapping another, is moved out by the
-- shortest way that is free. The ways come from the rule of the intersection rectangle, then that
-- of the opposite sides.
--
-- - A way that would end inside another immovable object does not count. Otherwise a box deep in a
--   floor of tiles would be thrown sideways.
-- - A body that overlaps two immovable ones in a corner leaves by one way after the other.
-- - A body that finds no way out of something immovable is `buried`. It stays where it is, and is
--   crushed by the two that hold it.
-- - Two bodies that were squeezed into each other (`wedged`) are left to contacts.lua. They
--   separate the way they came in.
--
-- Reads and writes from, to; writes buried, and crushed, crushLow and crushHigh of buried bodies.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local ask = require(root .. ".solver.permission")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local begin = require(root .. ".motion.begin")
local columns = require(root .. ".memory.columns")
local detect = require(root .. ".broadphase.pairFinder")
local filter = require(root .. ".broadphase.filter")
local rest = require(root .. ".sleep.islands")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")
local sort = require(root .. ".memory.sort")

local separate = {}

local huge, max, min = math.huge, math.max, math.min
local EPSILON, DYNAMIC = columns.EPSILON, columns.DYNAMIC
local SLOPE = columns.SHAPE_SLOPE_LEFT -- and above
local ROUNDS = 8
-- Number of overlapped dynamic bodies that a body leaves at once; it leaves more of them over
-- several steps (see contacts.lua).
local MOST = 2

-- The four ways out for the first of two bodies. Their order decides between equal ones, as in the
-- tutorial.
local AXIS = { 1, 1, 0, 0 } -- bottom, top, left, right
local SIGN = { -1, 1, 1, -1 } -- where the first body goes when that side of it was hit

local function isOpen(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  return not (b.sensor[i] or b.sensor[j] or b.oneWay[i] or b.oneWay[j] or b.wedged[p] ~= 0)
end

local function overlapOf(b, i, j)
  local from, size = b.from, b.size
  local ki, kj = 2 * i, 2 * j
  if b.hasSlopes and slope.isPair(b, i, j) then
    local box, its = slope.order(b, i, j)
    local depth = slope.inside(b, box, its, from[2 * box], from[2 * box + 1])
    return depth, depth
  end
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

-- Returns whether a body overlaps more than MOST other dynamic ones. These are left to
-- contacts.lua.
local function isCrowded(b, i)
  local work = b.partWork
  if work.seen[i] == work.round then
    return work.isCrowded[i]
  end
  local half, count = b.head[i], 0
  while half ~= 0 and count <= MOST do
    local j = b.other[half]
    if b.kind[j] == DYNAMIC and not b.sensor[j] then
      local width, height = overlapOf(b, i, j)
      if width > EPSILON and height > EPSILON then
        count = count + 1
      end
    end
    half = b.next[half]
  end
  work.seen[i], work.isCrowded[i] = work.round, count > MOST
  return count > MOST
end

-- Adds pair p to the work of this round if its bodies overlap.
local function consider(b, p)
  local work = b.partWork
  if work.stamp[p] == work.round or not isOpen(b, p) then
    return
  end
  local i, j = b.pairA[p], b.pairB[p]
  if (b.kind[i] ~= DYNAMIC and b.kind[j] ~= DYNAMIC) or b.stuck[i] or b.stuck[j] then
    return
  elseif b.hasCircles and ball.isRound(b, i, j) and not ball.isLost(b, i, j) then
    return
  end
  local width, height = overlapOf(b, i, j)
  -- For a body that can be pushed, one that cannot is like an immovable one.
  local isImmovable = b.kind[i] ~= DYNAMIC or b.kind[j] ~= DYNAMIC or b.power[i] ~= b.power[j]
  if
    width > EPSILON
    and height > EPSILON
    and (isImmovable or not (isCrowded(b, i) or isCrowded(b, j)))
  then
    work.stamp[p] = work.round
    local n = work.count + 1
    work.count = n
    work.pairs[n] = p
    local depth = width < height and width or height
    -- Pairs with an immovable body come first, then the deepest. One number is enough as the key,
    -- since depths are finite.
    work.depth[p] = isImmovable and -depth - work.far or -depth
    local first, second = b.rank[i], b.rank[j]
    work.first[p] = first < second and first or second
    work.second[p] = first < second and second or first
  end
end

-- Considers the pairs of slot i. `isBeside`: not those with a crowd, which has been laid out over
-- what is beside it.
local function considerAll(b, i, isBeside)
  local half = b.head[i]
  while half ~= 0 do
    if not (isBeside and max(b.crowd[i], b.crowd[b.other[half]]) > 0) then
      consider(b, (half + half % 2) / 2)
    end
    half = b.next[half]
  end
end

-- Lists in b.found the immovable objects that slot i would overlap at (x, y). Returns how many
-- there are.
local function listBlockers(b, i, x, y)
  local found, w, h, count = b.found, b.size[2 * i], b.size[2 * i + 1], 0
  local from, size = b.from, b.size
  for m = 1, b.broadphase:query(x, y, x + w, y + h, found) do
    local j = found[m]
    local k = 2 * j
    if j ~= i and filter.blocks(b, i, j) then
      local width, height = aabb.overlap(x, y, w, h, from[k], from[k + 1], size[k], size[k + 1])
      if b.shape[j] >= SLOPE then
        width = slope.inside(b, i, j, x, y)
      end
      if width > EPSILON and height > EPSILON then
        count = count + 1
        found[count] = j
      end
    end
  end
  return count
end

--- Returns whether slot i at (x, y) would overlap an immovable object.
function separate.isInside(b, i, x, y)
  return listBlockers(b, i, x, y) > 0
end

-- Moves slot i by `way` px along an axis, or flush against `edge` if that is given.
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
  detect.markMoved(b, i)
end

-- Returns where slot i is after it has moved `way` px along an axis.
local function placeOn(b, i, axis, way)
  local x, y = b.from[2 * i], b.from[2 * i + 1]
  return x + (axis == 0 and way or 0), y + (axis == 1 and way or 0)
end

local function canGo(b, i, axis, way)
  if b.kind[i] ~= DYNAMIC then
    return false
  end
  return not separate.isInside(b, i, placeOn(b, i, axis, way))
end

-- Returns the share of the way that i moves, by mass; j moves the rest. A body that would move into
-- something immovable stays. Returns nil if both would, or the only one that can be pushed.
local function weigh(b, i, j, axis, sign, way)
  local wi, wj = b.inverseMass[i], b.inverseMass[j]
  if wi > 0 and wj > 0 and b.power[i] ~= b.power[j] then
    wi, wj = b.power[i] < b.power[j] and wi or 0, b.power[j] < b.power[i] and wj or 0
  end
  if wi > 0 and wj > 0 then
    if b.pushFirst then
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

-- Returns where slot i is flush with j on an axis, on its low side (`sign` -1) or its high side
-- (1).
local function flushPlace(b, i, j, axis, sign)
  local k, m = 2 * i + axis, 2 * j + axis
  if b.hasSlopes and slope.isPair(b, i, j) then
    return slope.flushPlace(b, i, j, axis, sign)
  end
  return sign < 0 and b.from[m] - b.size[k] or b.from[m] + b.size[m]
end

-- Tries the way out on one side of i. Returns whether it was free.
local function leave(b, i, j, exit, way)
  local axis, sign = AXIS[exit], SIGN[exit]
  local share = weigh(b, i, j, axis, sign, way)
  if not share then
    return false
  end
  if share < 1 then
    local edge = share == 0 and flushPlace(b, j, i, axis, -sign) or nil
    shift(b, j, axis, -sign * way * (1 - share), edge)
  end
  if share > 0 then
    shift(b, i, axis, sign * way * share, flushPlace(b, i, j, axis, sign))
  end
  return true
end

-- Returns the object in b.found that slot i leaves last if it moves along an axis towards `sign`,
-- and how far that is, px. Returns 0, 0 if that way is no good:
--
-- - it is longer than the overlap with one of the objects;
-- - the game may let slot i pass through one of them (`canCollide`).
local function furthest(b, i, axis, sign, count)
  local from, size, last = b.from, b.size, 0
  local most = 0 ---@type number
  for m = 1, count do
    local j = b.found[m]
    local ki, kj = 2 * i + axis, 2 * j + axis
    local way = sign < 0 and from[ki] + size[ki] - from[kj] or from[kj] + size[kj] - from[ki]
    local width, height = overlapOf(b, i, j)
    local isDeeper = way > (axis == 0 and width or height) + EPSILON
    if isDeeper or min(width, height) <= EPSILON or ask.isAsked(b, i, j) then
      return 0, 0
    elseif way > most then
      last, most = j, way
    end
  end
  return last, most
end

-- Tries a way out of a corner. It leads out on one side of i, and then along the other axis out of
-- what i still overlaps. Returns whether that was free.
local function leaveCorner(b, i, j, exit, way)
  local axis, sign = AXIS[exit], SIGN[exit]
  local x, y = placeOn(b, i, axis, sign * way)
  local count = listBlockers(b, i, x, y)
  local low, lowWay = furthest(b, i, 1 - axis, -1, count)
  local high, highWay = furthest(b, i, 1 - axis, 1, count)
  local isLow = low ~= 0 and (high == 0 or lowWay <= highWay)
  local other, side = isLow and low or high, isLow and -lowWay or highWay
  if
    other == 0 or separate.isInside(b, i, axis == 0 and x or x + side, axis == 0 and y + side or y)
  then
    return false
  end
  shift(b, i, axis, way, flushPlace(b, i, j, axis, sign))
  shift(b, i, 1 - axis, side, flushPlace(b, i, other, 1 - axis, isLow and -1 or 1))
  return true
end

-- Returns whether an object that sticks out by `gap` px on a side may leave there. If it is only
-- flush, this must be the shortest way of all.
local function isOpenOn(gap, way, shortest)
  return gap > EPSILON or (gap >= -EPSILON and way == shortest)
end

-- Closes the ways out on which the first body would pass right through the second. If it sticks out
-- on some sides, only those are ways out. If it is wholly inside, all are.
local function closePassages(b, i, j, ways)
  local from, size = b.from, b.size
  local ki, kj = 2 * i, 2 * j
  local left, top = from[kj] - from[ki], from[kj + 1] - from[ki + 1]
  local right = from[ki] + size[ki] - from[kj] - size[kj]
  local bottom = from[ki + 1] + size[ki + 1] - from[kj + 1] - size[kj + 1]
  if max(left, right, top, bottom) > EPSILON then
    local shortest = min(ways[1], ways[2], ways[3], ways[4])
    ways[1] = isOpenOn(top, ways[1], shortest) and ways[1] or huge
    ways[2] = isOpenOn(bottom, ways[2], shortest) and ways[2] or huge
    ways[3] = isOpenOn(right, ways[3], shortest) and ways[3] or huge
    ways[4] = isOpenOn(left, ways[4], shortest) and ways[4] or huge
  end
end

-- The way out along gravity, over the sloped edge, is always open.
local function openEdge(b, i, j, ways)
  local axis, sign = slope.wayOut(b, i, j)
  local k = 2 * i + axis
  local way = (slope.flushPlace(b, i, j, axis, sign) - b.from[k]) * sign
  ways[axis == 1 and 1.5 + 0.5 * sign or 3.5 - 0.5 * sign] = way
end

-- Tries the ways of i out of j, the shortest first. Returns whether one was free.
local function tryWays(b, i, j, leaveBy)
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
  closePassages(b, i, j, ways)
  if b.shape[j] >= SLOPE then
    openEdge(b, i, j, ways)
  end
  for _ = 1, 4 do
    local exit = 1
    for other = 2, 4 do
      if ways[other] < ways[exit] then
        exit = other
      end
    end
    if ways[exit] == huge then
      return false
    elseif leaveBy(b, i, j, exit, ways[exit]) then
      return true
    end
    ways[exit] = huge
  end
  return false
end

-- Returns the first object in the order of the world that is in the way of slot i, `way` px along
-- an axis. The middle of the object must be beyond that of slot i. Returns 0 if there is none.
-- `isApart`: objects that slot i overlaps already do not count.
local function blockerOn(b, i, axis, way, isApart)
  local from, size, first = b.from, b.size, 0
  local k, sign = 2 * i + axis, way < 0 and -1 or 1
  for n = 1, listBlockers(b, i, placeOn(b, i, axis, way)) do
    local j = b.found[n]
    local m = 2 * j + axis
    local beyond = from[m] + size[m] * 0.5 - from[k] - size[k] * 0.5
    local width, height = overlapOf(b, i, j)
    local counts = beyond * sign > 0 and not (isApart and min(width, height) > EPSILON)
    if counts and (first == 0 or b.rank[j] < b.rank[first]) then
      first = j
    end
  end
  return first
end

-- Notes that slot i, which finds no way out of j, is held between j and another object. That one is
-- on the shorter way out along an axis. Returns whether there is such an object.
local function noteHeldOn(b, i, j, axis, isApart)
  local from, size, k, m = b.from, b.size, 2 * i + axis, 2 * j + axis
  local down, up = from[k] + size[k] - from[m], from[m] + size[m] - from[k]
  local isDown = down <= up
  local other = blockerOn(b, i, axis, isDown and -down or up, isApart)
  if other ~= 0 then
    b.crushed[k], b.hasCrushed = true, true
    b.crushLow[k], b.crushHigh[k] = isDown and other or j, isDown and j or other
  end
  return other ~= 0
end

-- Notes that slot i finds no way out of j.
local function bury(b, i, j)
  local width, height = overlapOf(b, i, j)
  local axis = height <= width and 1 or 0
  b.buried[i], b.hasBuried = true, true
  if not (b.crushed[2 * i] or b.crushed[2 * i + 1]) then
    -- A ceiling is preferred to the next tile of the floor that it overlaps, too.
    return noteHeldOn(b, i, j, axis, true)
      or noteHeldOn(b, i, j, 1 - axis, true)
      or noteHeldOn(b, i, j, axis, false)
      or noteHeldOn(b, i, j, 1 - axis, false)
  end
end

-- Returns whether slot j is to leave slot i, and not the other way round. The body that can be
-- pushed leaves, else the first in the order of the world.
local function leavesLater(b, i, j)
  if b.kind[i] ~= DYNAMIC or b.kind[j] ~= DYNAMIC then
    return b.kind[i] ~= DYNAMIC
  elseif b.power[i] ~= b.power[j] then
    return b.power[j] < b.power[i]
  end
  return b.rank[j] < b.rank[i]
end

local function separatePair(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  if leavesLater(b, i, j) then
    i, j = b.pairB[p], b.pairA[p]
  end
  local width, height = overlapOf(b, i, j)
  if width <= EPSILON or height <= EPSILON then
    return
  end
  -- A sleeping body begins the step first: otherwise what is noted here would be forgotten then.
  rest.wake(b, i)
  begin.run(b)
  local axis = height < width and 1 or 0
  local isLow = b.from[2 * i + axis] <= b.from[2 * j + axis]
  if not ask.permits(b, isLow and i or j, isLow and j or i, axis) or tryWays(b, i, j, leave) then
    return
  elseif b.kind[j] ~= DYNAMIC and not tryWays(b, i, j, leaveCorner) then
    bury(b, i, j)
  end
end

local function startRound(b)
  local work = b.partWork
  work.round = work.round + 1
  work.count, work.movedCount = 0, 0
end

--- Separates overlapping bodies: those that the game has moved, and those that the last step left
--- overlapping. After a change of the world's masks all awake bodies are examined.
function separate.run(b)
  local work = b.partWork
  startRound(b)
  for n = 1, b.movedCount do
    considerAll(b, b.movedList[n], false)
  end
  if b.hasInside or b.isRemasked then
    for n = 1, b.awakeCount do
      local i = b.awakeList[n]
      if b.inside[i] or b.isRemasked then
        considerAll(b, i, not b.inside[i])
      end
    end
  end
  b.isRemasked = false
  for _ = 1, ROUNDS do
    if work.count == 0 then
      return
    end
    sort.by(work.pairs, work.count, work.depth, work.first, work.second)
    for n = 1, work.count do
      separatePair(b, work.pairs[n])
    end
    local movedCount = work.movedCount
    detect.run(b, work.moved, 1, movedCount)
    startRound(b)
    for n = 1, movedCount do
      considerAll(b, work.moved[n], false)
    end
  end
end

return separate
