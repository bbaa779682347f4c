--- Which pairs may meet on their present paths: those that are not clear of each other on an axis.
--
-- This is asked of every pair, so it is one short loop without branches; `approach` then computes
-- how those meet that may. In between their numbers wait in b.relative, four a pair: the position
-- of the other relative to the object, x and y, where the later of the two paths begins, and x and
-- y at the end of the step.
--
-- An event at the very beginning of the step, of a pair that is flush, keeps its place among the
-- events whatever happens to the two before it is its turn: they do not move until then, and what
-- decides the order is where they are. So such a pair is not looked at again with each change of
-- the two, as in a crowd there are dozens, but once, when it is its turn (column `waits`).
--
-- Reads from, to, speed, size, time, the pairs; writes near, relative, event, waits.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")

local gather = {}

local EPSILON, STILL = columns.EPSILON, columns.STILL
local TINY, VAST = columns.TINY, columns.VAST
local NO_EVENT = columns.NO_EVENT
local floor, max, min = math.floor, math.max, math.min
-- px by which differences of coordinates may be rounded: by less two are not clear of each other
-- until `endOverlap` says so.
local ROUNDING = 1e-9

--- By how much the paths overlap on an axis at the end of the step. Both ways to round are asked,
-- so that a box that was put flush against the other, from either side, does not overlap it.
function gather.endOverlap(b, low, high)
  local atLow, size, atHigh = b.to[low], b.size[low], b.to[high]
  local forward, backward = atLow + size - atHigh, atLow - (atHigh - size)
  return min(forward, backward)
end

--- Whether the paths of two that are flush do not press against each other (as approach.meetFace
--- decides); `low` is the index with the smaller coordinate.
function gather.isIdle(b, low, high)
  local to, size, speed = b.to, b.size, b.speed
  local atLow, sizeLow, atHigh = to[low], size[low], to[high]
  local forward, backward = atLow + sizeLow - atHigh, atLow - (atHigh - sizeLow) -- see `endOverlap`
  return (forward <= EPSILON or backward <= EPSILON)
    and (speed[low] - speed[high] <= STILL or min(forward, backward) <= -b.clear)
end

local isIdle = gather.isIdle

-- >= 0 if two stay clear of each other on one axis: apart now, and at the end on the same side, or
-- flush there and not moving against each other (`v`, at the end). With a `clear` of EPSILON only
-- if they are apart by that much at the end. No branches, so that it is one piece of code for all.
local function clearance(r, rEnd, v, size, sizeOther, clear)
  local before, after = rEnd - size - clear, -rEnd - sizeOther - clear
  local flush = EPSILON - clear
  return max(
    min(r - size + EPSILON, max(before - ROUNDING, min(before + flush, STILL - v))),
    min(-r - sizeOther + EPSILON, max(after - ROUNDING, min(after + flush, STILL + v)))
  )
end

-- Lists a half-edge behind b.near and b.relative if its pair may meet on the present paths; returns
-- the new count. The object is at index k, the other at m; x, y is where that is, relative to the
-- object, when the later of the two paths begins.
local function list(b, half, k, m, x, y, clear, count)
  local to, size, speed, relative = b.to, b.size, b.speed, b.relative
  local endX, endY = to[m] - to[k], to[m + 1] - to[k + 1]
  local gap = max(
    min(x, endX) - size[k],
    -max(x, endX) - size[m],
    min(y, endY) - size[k + 1],
    -max(y, endY) - size[m + 1]
  )
  if gap >= clear + ROUNDING then
    return count -- most are so far from each other all the time that no more needs to be asked
  end
  local apart = max(
    clearance(x, endX, speed[k] - speed[m], size[k], size[m], clear),
    clearance(y, endY, speed[k + 1] - speed[m + 1], size[k + 1], size[m + 1], clear)
  )
  if apart < 0 then
    local at = 4 * count
    relative[at + 1], relative[at + 2] = x, y
    relative[at + 3], relative[at + 4] = endX, endY
    count = count + 1
    b.near[count] = half
  end
  return count
end

-- What is listed is written behind the list, and the list made longer by 0 or 1. Without branches
-- the way through the loop is the same, whatever comes first.

--- Lists the live pairs in b.touchList that may be met at the very beginning of the step: nowhere
--- apart when it begins.
function gather.touching(b)
  local pairs_, pairA, pairB, from, size = b.live, b.pairA, b.pairB, b.from, b.size
  local out, touches, gapsX, gapsY = b.touchList, b.touches, b.touchGapX, b.touchGapY
  local count = 0 ---@type number
  for n = 1, b.liveCount do
    local p = pairs_[n]
    local k, m = 2 * pairA[p], 2 * pairB[p]
    local x, y = from[m] - from[k], from[m + 1] - from[k + 1]
    local gapX, gapY = max(x - size[k], -x - size[m]), max(y - size[k + 1], -y - size[m + 1])
    local does = max(min((EPSILON - gapX) * VAST + 1, (EPSILON - gapY) * VAST + 1, 1), 0)
    gapsX[count + 1], gapsY[count + 1] = gapX, gapY
    out[count + 1], touches[p] = p, does
    count = count + does
  end
  b.touchCount = count
end

--- Of these, lists those in `along` that are flush along `axis` when the step begins, and those in
--- `across` that are flush along the other one. Returns how many those are.
function gather.flush(b, axis, along, across)
  local pairs_, gaps, gapsAcross = b.touchList, b.touchGapX, b.touchGapY
  if axis == 1 then
    gaps, gapsAcross = b.touchGapY, b.touchGapX
  end
  local n, m = 0, 0 ---@type number, number
  for at = 1, b.touchCount do
    local p, gap, gapAcross = pairs_[at], gaps[at], gapsAcross[at]
    -- >= 1 if they are no deeper than flush there; if they are in each other there; else < 0.
    local meets, meetsAcross = (gap + EPSILON) * VAST + 1, (gapAcross + EPSILON) * VAST + 1
    local isIn, isInAcross = (-EPSILON - gap) * VAST + 1, (-EPSILON - gapAcross) * VAST + 1
    local isAlong = max(min(meets, isInAcross, 1), 0) ---@type number
    local isAcross = max(min(meetsAcross, isIn, 1 - isAlong), 0) ---@type number
    along[n + 1], across[m + 1] = p, p
    n, m = n + isAlong, m + isAcross
  end
  return n, m
end

-- Where the other of a pair is on an axis, relative to the object, at the time `start`.
local function relativeAt(from, to, k, m, mine, its)
  return from[m] + (to[m] - from[m]) * its - (from[k] + (to[k] - from[k]) * mine)
end

local function listAt(b, half, i, j, clear, count)
  local from, to, time, k, m = b.from, b.to, b.time, 2 * i, 2 * j
  local start = max(time[i], time[j])
  local mine = (start - time[i]) / max(1 - time[i], TINY)
  local its = (start - time[j]) / max(1 - time[j], TINY)
  local x = relativeAt(from, to, k, m, mine, its)
  local y = relativeAt(from, to, k + 1, m + 1, mine, its)
  return list(b, half, k, m, x, y, clear, count)
end

-- Lists pair p if it may meet while both paths begin with the step, and forgets its event.
local function listWhole(b, p, clear, count)
  local from, k, m = b.from, 2 * b.pairA[p], 2 * b.pairB[p]
  b.event[p], b.waits[p] = NO_EVENT, 0
  return list(b, 2 * p - 1, k, m, from[m] - from[k], from[m + 1] - from[k + 1], clear, count)
end

--- Lists all live pairs that may meet on the present paths, which must all begin with the step, and
--- forgets the events of all. Returns how many there are.
function gather.live(b)
  local pairs_, clear, count = b.live, b.clear, 0
  for n = 1, b.liveCount do
    count = listWhole(b, pairs_[n], clear, count)
  end
  return count
end

--- Returns how often the paths of two have changed by now, from the column of that.
function gather.changesOf(changes, i, j)
  return changes[2 * i] + changes[2 * i + 1] + changes[2 * j] + changes[2 * j + 1]
end

local changesOf = gather.changesOf

--- Whether the last meeting of a pair has changed nothing, and the paths are still the same: it
--- would meet for ever.
function gather.isSettled(b, p)
  local settled = b.settled[p]
  return settled ~= 0 and settled == 1 + changesOf(b.changes, b.pairA[p], b.pairB[p])
end

local isSettled = gather.isSettled

-- Lists the pairs of the turns from `first` to `last`, along `axis`, that may meet again: not those
-- that are idle where they are flush, as nearly all are when they have had their turns.
local function listRestless(b, axis, first, last, clear, count)
  local pairs_, ups, lows, turn = b.turnPair, b.turnUp, b.turnLow, b.turn
  local isUp = b.orientation[axis] < 0
  for x = first, last do
    local p, k, m = pairs_[x], 2 * ups[x] + axis, 2 * lows[x] + axis
    if
      not isIdle(b, isUp and m or k, isUp and k or m)
      and turn[p] > 0 -- it has not been taken apart meanwhile
      and not isSettled(b, p)
    then
      count = listWhole(b, p, clear, count)
    end
  end
  return count
end

--- As `live`, but only those that touch when the step begins, are not settled and have not been
--- looked at all the time, as odd ones are; if `isCalm`, not those that have had turns either.
function gather.together(b, isCalm)
  local pairs_, turn, event, clear, count = b.touchList, b.turn, b.event, b.clear, 0
  local isEager, footings = b.isEager, b.footingCount
  if not isCalm then
    count = listRestless(b, b.downAxis, 1, footings, clear, count)
    count = listRestless(b, 1 - b.downAxis, footings + 1, b.turnCount, clear, count)
  end
  for n = 1, b.touchCount do
    local p = pairs_[n]
    if turn[p] == 0 and not (isEager and event[p] ~= NO_EVENT) and not isSettled(b, p) then
      count = listWhole(b, p, clear, count)
    end
  end
  return count
end

--- As `live`, but only those that do not touch.
function gather.apart(b)
  local pairs_, touches, clear, count = b.live, b.touches, b.clear, 0
  for n = 1, b.liveCount do
    local p = pairs_[n]
    if touches[p] == 0 then
      count = listWhole(b, p, clear, count)
    end
  end
  return count
end

-- Whether both have only followed the same ring since the changes began: they meet as they did.
local function followAlike(b, i, j)
  local follows, mark, stamp = b.follows, b.changedMark, b.changeStamp
  return follows[i] ~= 0 and follows[i] == follows[j] and mark[i] == stamp and mark[j] == stamp
end

--- Lists the pairs of the objects in slots[first..last] that may meet on the present paths, and
--- forgets the events of all their pairs, but for those that wait and, until `isAllSeen`, those
--- that have turns. As long as `isInstant`, only pairs that touch are in question, and the events
--- of the others are left as they are. Returns how many there are, `count` of them listed before.
function gather.objects(b, slots, first, last, count)
  local other, nextHalf, head, event, waits = b.other, b.next, b.head, b.event, b.waits
  local turn, touches, isLate, isAllSeen = b.turn, b.touches, not b.isInstant, b.isAllSeen
  local clear, gathered, stamp = b.clear, b.gathered, b.gatherStamp + 1
  b.gatherStamp = stamp
  local n, half = first, head[slots[first]]
  while n <= last do
    if half == 0 then
      n = n + 1
      half = n <= last and head[slots[n]] or 0
    elseif followAlike(b, slots[n], other[half]) then
      half = nextHalf[half]
    else
      local p = floor(half * 0.5 + 0.5)
      if waits[p] > 0 then
        waits[p] = 2
      elseif
        (touches[p] > 0 or isLate)
        and (isAllSeen or turn[p] <= 0)
        and gathered[p] ~= stamp
      then
        event[p], gathered[p] = NO_EVENT, stamp
        count = listAt(b, half, slots[n], other[half], clear, count)
      end
      half = nextHalf[half]
    end
  end
  return count
end

--- Lists one pair.
function gather.pair(b, p)
  b.event[p], b.waits[p] = NO_EVENT, 0
  return listAt(b, 2 * p - 1, b.pairA[p], b.pairB[p], b.clear, 0)
end

return gather
