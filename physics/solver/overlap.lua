---@diagnostic disable
--- Overlap: computes from two or three bodies that overlap when the step begins the places where
-- they do not. Positions only.
--
-- A body leaves by the shortest way that is free: first the way out of the intersection rectangle,
-- then those to the opposite sides. The ways out of a slope are those over its own faces.
--
-- - No way ends inside something immovable, or leads right through it: of what sticks out on some
--   sides, only these are ways out.
-- - Out of a corner of two immovable objects a body goes along one axis after the other.
-- - What finds no way out of something immovable is `buried`, and crushed between that and what is
--   in its way. It stays where it is.
-- - What has come into another along one axis (`wedged`), or has grown into it, is left to the
--   contacts: it leaves along that axis. So is a body that overlaps many (see crowd, relax).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")
local pairFinder = require(root .. ".broadphase.pairFinder")
local path = require(root .. ".motion.path")
local rules = require(root .. ".solver.rules")
local shapes = require(root .. ".space.shapes")
local touch = require(root .. ".solver.touch")
local sort = require(root .. ".memory.sort")

local overlap = {}

local DYNAMIC, EPSILON = columns.DYNAMIC, columns.EPSILON
local neighbours = columns.neighbours
local huge, max, min = math.huge, math.max, math.min
-- Pairs that bodies moved in a round overlap now are parted in the next one.
local ROUNDS = 8
-- Number of overlapped dynamic bodies that a body leaves at once.
local MOST = 2
-- Share of its size, along an axis, after which a body leaves no more dynamic ones in a step.
local FURTHEST = 0.5
-- px: more than any depth.
local FAR = 1e18

-- The four ways out of a body. Of equal ones the first is taken, as in the tutorial.
local AXIS = { 1, 1, 0, 0 } -- up, down, right, left
local SIGN = { -1, 1, 1, -1 }

-- Geometry ----------------------------------------------------------------------------------------

local function depthOf(b, i, j)
  return touch.depth(b, i, j, b.from[2 * i], b.from[2 * i + 1])
end

local function isDeep(width, height)
  return width > EPSILON and height > EPSILON
end

-- Returns how far slot i has to go to be flush with j on one side of that, px.
local function wayOut(b, i, j, axis, sign)
  return (touch.flushPlace(b, i, j, axis, sign) - b.from[2 * i + axis]) * sign
end

-- Lists in b.found the immovable objects, or all (`isAny`), that slot i would overlap at (x, y).
-- Returns how many.
local function listBlockers(b, i, x, y, isAny)
  local found, count = b.found, 0
  for n = 1, b.broadphase:query(x, y, x + b.size[2 * i], y + b.size[2 * i + 1], found) do
    local j = found[n]
    if j ~= i and filter.blocks(b, i, j, isAny) and isDeep(touch.depth(b, i, j, x, y)) then
      count = count + 1
      found[count] = j
    end
  end
  return count
end

--- Returns whether slot i at (x, y) would overlap an immovable object, or any one (`isAny`).
function overlap.isInside(b, i, x, y, isAny)
  return listBlockers(b, i, x, y, isAny) > 0
end

-- Returns where slot i is after it has gone `way` px along an axis.
local function placeOn(b, i, axis, way)
  local x, y = b.from[2 * i], b.from[2 * i + 1]
  return x + (axis == 0 and way or 0), y + (axis == 1 and way or 0)
end

--- Returns how far slot i goes along an axis, towards `sign`, until it overlaps nothing; huge: a
--- wall is before that, or it is more than `most` px.
function overlap.wayToRoom(b, i, axis, sign, most)
  local way, before = 0.0, -1.0
  while way > before and way <= most do
    local x, y = placeOn(b, i, axis, sign * way)
    before = way
    for n = 1, listBlockers(b, i, x, y, true) do
      if b.kind[b.found[n]] ~= DYNAMIC then
        return huge
      end
      way = max(way, wayOut(b, i, b.found[n], axis, sign))
    end
  end
  return way <= most and way or huge
end

-- Moving ------------------------------------------------------------------------------------------

-- Puts slot i at a place on an axis.
local function put(b, i, axis, place)
  local work, k = b.partWork, 2 * i + axis
  islands.wake(b, i)
  path.begin(b)
  b.from[k], b.to[k] = place, place
  work.movedCount = work.movedCount + 1
  work.moved[work.movedCount] = i
  pairFinder.markMoved(b, i)
end

local function canGo(b, i, axis, way)
  return way == 0 or b.kind[i] == DYNAMIC and not overlap.isInside(b, i, placeOn(b, i, axis, way))
end

-- Returns the share of the way that slot i goes of two, by mass; j goes the rest. If one of them
-- would end inside something immovable, the other one goes all of it; so does i if it is the weaker
-- one (see `leavesLater`). nil: neither can.
local function shareOf(b, i, j, axis, way)
  local wi, wj = b.inverseMass[i], b.power[i] < b.power[j] and 0 or b.inverseMass[j]
  local share = (wj == 0 or (wi > 0 and b.pushFirst)) and 1 or wi / (wi + wj)
  if canGo(b, i, axis, way * share) and canGo(b, j, axis, way * (share - 1)) then
    return share
  elseif wi > 0 and canGo(b, i, axis, way) then
    return 1
  end
  return wj > 0 and canGo(b, j, axis, -way) and 0 or nil
end

-- Lets two leave each other on one side of slot i. Returns whether that way is free.
local function leave(b, i, j, axis, sign, way)
  local share = shareOf(b, i, j, axis, sign * way)
  if not share then
    return false
  elseif share == 0 then
    put(b, j, axis, touch.flushPlace(b, j, i, axis, -sign))
    return true
  elseif share < 1 then
    put(b, j, axis, b.from[2 * j + axis] - sign * way * (1 - share))
  end
  put(b, i, axis, touch.flushPlace(b, i, j, axis, sign))
  return true
end

-- Returns how far slot i goes along an axis until it is out of b.found[1..count], and the last of
-- these; nil: it would go right through one of them, or the game may let it pass there.
local function wayOutOfAll(b, i, axis, sign, count)
  local most, last = 0, nil
  for n = 1, count do
    local j = b.found[n]
    local way, width, height = wayOut(b, i, j, axis, sign), depthOf(b, i, j)
    local isThrough = way > (axis == 0 and width or height) + EPSILON
    if isThrough or not isDeep(width, height) or rules.isAsked(b, i, j) then
      return nil
    elseif way > most then
      most, last = way, j
    end
  end
  return most, last
end

-- Lets slot i leave j on one side, and then what it still overlaps along the other axis.
local function leaveCorner(b, i, j, axis, sign, way)
  local x, y = placeOn(b, i, axis, sign * way)
  local count, across = listBlockers(b, i, x, y), 1 - axis
  local low, lowest = wayOutOfAll(b, i, across, -1, count)
  local high, highest = wayOutOfAll(b, i, across, 1, count)
  local isLow = lowest and (not highest or low <= high)
  local other, side = isLow and lowest or highest, isLow and -1 or 1
  if not other then
    return false
  end
  local place = touch.flushPlace(b, i, other, across, side)
  if overlap.isInside(b, i, axis == 0 and x or place, axis == 0 and place or y) then
    return false
  end
  put(b, i, axis, touch.flushPlace(b, i, j, axis, sign))
  put(b, i, across, place)
  return true
end

-- Writes the four ways of slot i out of j; huge: it is closed. What sticks out of j leaves where it
-- does so. (If it is only flush on a side, that must be the shortest way.)
local function listWays(b, i, j)
  local ways, shortest, furthestOut = b.partWork.ways, huge, -huge
  for exit = 1, 4 do
    local way = wayOut(b, i, j, AXIS[exit], SIGN[exit])
    ways[exit], shortest = way, min(shortest, way)
    furthestOut = max(furthestOut, b.size[2 * i + AXIS[exit]] - way)
  end
  for exit = 1, furthestOut > EPSILON and 4 or 0 do
    local out = b.size[2 * i + AXIS[exit]] - ways[exit]
    if out < -EPSILON or (out <= EPSILON and ways[exit] ~= shortest) then
      ways[exit] = huge
    end
  end
end

-- Tries the ways of slot i out of j, the shortest first. Returns whether one was free.
local function tryWays(b, i, j, leaveBy)
  local ways = b.partWork.ways
  listWays(b, i, j)
  for _ = 1, 4 do
    local exit = 1
    for other = 2, 4 do
      exit = ways[other] < ways[exit] and other or exit
    end
    if ways[exit] == huge then
      return false
    elseif leaveBy(b, i, j, AXIS[exit], SIGN[exit], ways[exit]) then
      return true
    end
    ways[exit] = huge
  end
  return false
end

-- No way out --------------------------------------------------------------------------------------

-- Returns the first object in the order of the world that is in the way of slot i, `way` px along
-- an axis, with its middle beyond that of slot i; nil: there is none.
local function blockerOn(b, i, axis, way)
  local k, first = 2 * i + axis, nil
  for n = 1, listBlockers(b, i, placeOn(b, i, axis, way)) do
    local j = b.found[n]
    local m = 2 * j + axis
    local beyond = b.from[m] + b.size[m] * 0.5 - b.from[k] - b.size[k] * 0.5
    if beyond * way > 0 and (not first or b.rank[j] < b.rank[first]) then
      first = j
    end
  end
  return first
end

-- Notes slot i, which finds no way out of j, as crushed between j and what is in its shorter way
-- along one axis. Returns whether there is anything.
local function crush(b, i, j, axis)
  local k, low, high = 2 * i + axis, wayOut(b, i, j, axis, -1), wayOut(b, i, j, axis, 1)
  local isLow = low <= high
  local other = blockerOn(b, i, axis, isLow and -low or high)
  if other then
    b.crushed[k], b.hasCrushed = true, true
    b.crushLow[k], b.crushHigh[k] = isLow and other or j, isLow and j or other
  end
  return other ~= nil
end

local function bury(b, i, j)
  local width, height = depthOf(b, i, j)
  local axis = height <= width and 1 or 0
  axis = b.wasCrushed[2 * i + 1 - axis] and 1 - axis or axis -- so that it is told once
  b.buried[i] = true
  b.news[i] = true -- whether it finds a way out depends on walls that are not its neighbours
  if not (b.crushed[2 * i] or b.crushed[2 * i + 1]) then
    local _ = crush(b, i, j, axis) or crush(b, i, j, 1 - axis)
  end
end

-- Pairs -------------------------------------------------------------------------------------------

-- Returns whether slot i is left to the contacts: it overlaps more than MOST others that can be
-- pushed, or was moved far in this step.
local function isCrowded(b, i)
  local count, k = 0, 2 * i
  local x, y = b.from[k] - b.position[k], b.from[k + 1] - b.position[k + 1]
  if max(x, -x) > FURTHEST * b.size[k] or max(y, -y) > FURTHEST * b.size[k + 1] then
    return true
  end
  for _, j in neighbours(b, i) do
    if b.kind[j] == DYNAMIC and not b.sensor[j] and isDeep(depthOf(b, i, j)) then
      count = count + 1
    end
    if count > MOST then
      return true
    end
  end
  return false
end

-- Returns whether the bodies of pair p are parted here at all.
local function isOpen(b, p, i, j)
  local canMove = b.kind[i] == DYNAMIC or b.kind[j] == DYNAMIC
  local isRolling = b.hasRound and ball.isRound(b, i, j) and not ball.isLost(b, i, j)
  return filter.areSolid(b, i, j) and canMove and not isRolling and b.wedged[p] == 0
end

-- Adds pair p to the work of this round if its bodies overlap: those with something immovable
-- first, then the deepest. (What is driven would hop: what the last step left of it parts as
-- contacts.)
local function consider(b, p, isOld)
  local work, i, j = b.partWork, b.pairA[p], b.pairB[p]
  if work.stamp[p] == work.round or not isOpen(b, p, i, j) then
    return
  end
  local width, height = depthOf(b, i, j)
  -- For a body that can be pushed, one that cannot is like an immovable one.
  local isFirm = b.kind[i] ~= DYNAMIC or b.kind[j] ~= DYNAMIC or b.power[i] ~= b.power[j]
  local isLeft = isOld and (path.isDriven(b, i) or path.isDriven(b, j))
  local isHere = isFirm or not (isLeft or isCrowded(b, i) or isCrowded(b, j))
  if isHere and isDeep(width, height) then
    work.stamp[p], work.count = work.round, work.count + 1
    b.pairList[work.count] = p
    b.sortKey[p] = -min(width, height) - (isFirm and FAR or 0)
    b.firstRank[p], b.secondRank[p] = columns.ranks(b, i, j)
  end
end

-- Considers the pairs of slot i. (A crowd lays out its members: they leave only what is none.)
local function considerAll(b, i, isOld)
  for _, j, p in neighbours(b, i) do
    if max(b.crowd[2 * i], b.crowd[2 * j]) <= 0 or b.kind[i] ~= b.kind[j] then
      consider(b, p, isOld)
    end
  end
end

-- Returns whether slot j is to leave i, and not the other way round: what can be pushed, then what
-- is weaker, then the first in the order of the world.
local function leavesLater(b, i, j)
  if b.kind[i] ~= DYNAMIC or b.kind[j] ~= DYNAMIC then
    return b.kind[i] ~= DYNAMIC
  elseif b.power[i] ~= b.power[j] then
    return b.power[j] < b.power[i]
  end
  return b.rank[j] < b.rank[i]
end

local function part(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  if leavesLater(b, i, j) then
    i, j = b.pairB[p], b.pairA[p]
  end
  local width, height = depthOf(b, i, j)
  if not isDeep(width, height) then
    return
  end
  islands.wake(b, i) -- what is noted of it here would be forgotten when it wakes later
  path.begin(b)
  local axis = height < width and 1 or 0
  local isLow = b.from[2 * i + axis] <= b.from[2 * j + axis]
  local isMet = rules.permits(b, isLow and i or j, isLow and j or i, axis)
  local isFree = not isMet or tryWays(b, i, j, leave)
  if not isFree and b.kind[j] ~= DYNAMIC and not tryWays(b, i, j, leaveCorner) then
    bury(b, i, j)
  end
end

--- Parts the bodies that the game has put into each other, and those that the last step left so.
function overlap.run(b)
  local work = b.partWork
  work.round, work.count, work.movedCount = work.round + 1, 0, 0
  for n = 1, b.movedCount do
    considerAll(b, b.movedList[n])
  end
  for n = 1, b.hasInside and b.awakeCount or 0 do
    if b.inside[b.awakeList[n]] then
      considerAll(b, b.awakeList[n], true)
    end
  end
  for _ = 1, ROUNDS do
    if work.count == 0 then
      return
    end
    sort.by(b.pairList, work.count, b.sortKey, b.firstRank, b.secondRank)
    for n = 1, work.count do
      part(b, b.pairList[n])
    end
    local movedCount = work.movedCount
    pairFinder.run(b, work.moved, movedCount)
    work.round, work.count, work.movedCount = work.round + 1, 0, 0
    for n = 1, movedCount do
      considerAll(b, work.moved[n])
    end
  end
end

-- Growth ------------------------------------------------------------------------------------------

-- Returns px between slot i, as it was before it grew, and slot j on an axis, and whether i was the
-- low one.
local function gapBefore(b, i, j, axis)
  local k, m = 2 * i + axis, 2 * j + axis
  local r = b.from[m] - b.wasAt[k]
  local after, before = r - b.wasSize[k], -r - b.size[m]
  return max(after, before), after > before
end

-- Lets slot i, which has grown into the immovable slot j along one axis, leave it along that.
local function wedge(b, p, i, j)
  local canWedge = filter.areSolid(b, i, j)
    and b.kind[j] ~= DYNAMIC
    and shapes.isBox[b.shape[j]]
    and b.wedged[p] == 0
  if not canWedge or columns.gap(b, b.from, i, j) >= -EPSILON then
    return
  end
  local gapX, isLowX = gapBefore(b, i, j, 0)
  local gapY, isLowY = gapBefore(b, i, j, 1)
  if (gapX >= -EPSILON) ~= (gapY >= -EPSILON) then
    local isLow = gapY >= -EPSILON and isLowY or gapX >= -EPSILON and isLowX
    b.wedged[p] = (gapY >= -EPSILON and 2 or 0) + (isLow == (b.pairA[p] == i) and 2 or 1)
  end
end

-- Returns whether slot i still touches the place where it was, so that it was not put elsewhere.
local function isThere(b, i)
  local gapX, gapY = gapBefore(b, i, i, 0), gapBefore(b, i, i, 1)
  return max(gapX, gapY) < -EPSILON
end

--- Marks what the game has made larger than its room: the shortest way would lead through thin
--- walls.
function overlap.noteGrown(b)
  for n = 1, b.movedCount do
    local i = b.movedList[n]
    local hasGrown = b.kind[i] == DYNAMIC and b.wasSize[2 * i] > 0
    if hasGrown and isThere(b, i) then
      for _, j, p in neighbours(b, i) do
        wedge(b, p, i, j)
      end
    end
    for k = 2 * i, hasGrown and 2 * i + 1 or 0 do
      b.wasAt[k], b.wasSize[k] = 0, 0
    end
  end
end

return overlap
