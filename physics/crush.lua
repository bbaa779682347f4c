--- Crushed: held between two that cannot give way, on one axis.
--
-- The object stays where it overlaps its neighbours the least, a single one in the middle, and is
-- free again as soon as there is room. How it came there is remembered with the pair (`wedged`),
-- so that it can only leave along the same axis and is never squeezed out sideways.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local events = require(here .. ".events")
local path = require(here .. ".path")
local weld = require(here .. ".weld")

require(here .. ".interpreted").file()

local crush = {}

local max, min = math.max, math.min

local STATIC, DYNAMIC, EPSILON = columns.STATIC, columns.DYNAMIC, columns.EPSILON

-- The nearest of those welded to i on one side of it, 0: none. (By where they end: where they come
-- from is known of each at another moment.)
local function weldedTo(b, i, axis, isLow)
  local to, k, best, bestAt = b.to, 2 * i + axis, 0, 0.0
  local half = b.head[i]
  while half ~= 0 do
    local j = b.other[half]
    local m = 2 * j + axis
    local at = isLow and to[k] - to[m] or to[m] - to[k]
    -- Only whom it has met: other neighbours may be known or not.
    local isMet = b.met[(half + half % 2) / 2] > 0
    if b.weld[m] == b.weld[k] and at > 0 and b.kind[j] == DYNAMIC and isMet then
      if best == 0 or at < bestAt or (at == bestAt and b.rank[j] < b.rank[best]) then
        best, bestAt = j, at
      end
    end
    half = b.next[half]
  end
  return best
end

-- Who holds slot i on one side, 0: nobody. One of a welded group is held through the next of it.
local function holderOf(b, i, axis, isLow)
  local k = 2 * i + axis
  if b.kind[i] ~= DYNAMIC then
    return 0
  end
  local by = (isLow and b.holderLow or b.holderHigh)[k]
  if by == 0 and b.weld[k] ~= 0 and (isLow and b.heldLow or b.heldHigh)[k] > 0 then
    return weldedTo(b, i, axis, isLow)
  end
  return by
end

-- The end of the chain of those who hold each other, on one side of slot i: the first that cannot
-- be pushed at all. nil: the chain comes to `other`, who should be on the other side, or it has no
-- end. That is so where many are crushed into less than half of their place, and one is in front of
-- the next by one meeting, and behind it by others.
local function endOf(b, i, other, axis, isLow)
  for _ = 0, b.moverCount do
    local by = holderOf(b, i, axis, isLow)
    if by == 0 then
      return i
    elseif by == other then
      return nil
    end
    i = by
  end
  return nil
end

--- Whether slot i counts as held on one side, but by nobody that would keep it from giving way to
--- `other`: it is the last of a welded row, which is held further up; or it was stopped between two
--- who cannot be pushed, which is nothing to a wall.
function crush.hasNoHolder(b, i, other, axis, isLow)
  local k = 2 * i + axis
  return b.kind[i] == DYNAMIC
    and (isLow and b.heldLow or b.heldHigh)[k] > 0
    and (b.weld[k] ~= 0 or b.kind[other] ~= DYNAMIC)
    and not b.buried[i]
    and holderOf(b, i, axis, isLow) == 0
end

--- Whether slot i, held on one side, is held there by `other` in the end, whom it is about to push,
--- or by a ring of others: then nobody is, and pushing would go on and on.
function crush.isRing(b, i, other, axis, isLow)
  return endOf(b, i, other, axis, isLow) == nil
end

-- Lists the members of the chain from `low` (excluded) up to `lo`, then from `hi` to `high`
-- (excluded), in b.stack; returns how many and the sum of their sizes.
local function list(b, lo, hi, low, high, axis)
  local stack, count, sum = b.stack, 0, 0
  local i = lo
  while i ~= low do
    count, sum = count + 1, sum + b.size[2 * i + axis]
    stack[count] = i
    i = holderOf(b, i, axis, true)
  end
  for n = 1, (count - count % 2) / 2 do
    stack[n], stack[count + 1 - n] = stack[count + 1 - n], stack[n]
  end
  i = hi
  while i ~= high do
    count, sum = count + 1, sum + b.size[2 * i + axis]
    stack[count] = i
    i = holderOf(b, i, axis, false)
  end
  return count, sum
end

-- From now on nobody can push the n-th of `count` members, whoever meets it next in this step.
-- Returns the two who hold it.
local function hold(b, n, count, low, high, axis)
  local stack = b.stack
  local k = 2 * stack[n] + axis
  local before, behind = n > 1 and stack[n - 1] or low, n < count and stack[n + 1] or high
  weld.leave(b, k)
  b.heldLow[k], b.heldHigh[k], b.holderLow[k], b.holderHigh[k] = 1, 1, before, behind
  return before, behind
end

local function put(b, i, k, at, v)
  if b.to[k] ~= at or b.speed[k] ~= v then
    b.to[k], b.speed[k], b.accel[k], b.drive[k] = at, v, 0, 0
    path.change(b, i)
  end
end

-- Moves each member as far as it overlaps the one before, away from one end.
local function spreadFrom(b, count, fixed, axis, isUp)
  local stack, to, size, k = b.stack, b.to, b.size, 2 * fixed + axis
  local v, at = b.speed[k], isUp and to[k] + size[k] or to[k]
  for n = isUp and 1 or count, isUp and count or 1, isUp and 1 or -1 do
    k = 2 * stack[n] + axis
    if isUp and to[k] < at - EPSILON then
      put(b, stack[n], k, at, v)
    elseif not isUp and to[k] + size[k] > at + EPSILON then
      put(b, stack[n], k, at - size[k], v)
    end
    at = isUp and to[k] + size[k] or to[k]
  end
end

-- There is room between the two ends, since what held one of the members has gone on, or one was
-- dragged from where it was held: moves them away from the ends that cannot move.
local function spread(b, count, low, high, axis)
  if b.kind[low] ~= DYNAMIC then
    spreadFrom(b, count, low, axis, true)
  end
  if b.kind[high] ~= DYNAMIC then
    spreadFrom(b, count, high, axis, false)
  end
end

-- How deep two are in each other, on the axis of both indexes.
local function depthOn(place, size, kl, kh)
  return place[kl] + size[kl] - place[kh]
end

-- Nobody knows by whom the two are held. But a wall stays a wall: who would be wholly inside, or on
-- the far side, ends where it was when the step began.
local function stop(b, lo, hi, axis)
  local kl, kh = 2 * lo + axis, 2 * hi + axis
  local depth = depthOn(b.to, b.size, kl, kh)
  if b.kind[lo] ~= DYNAMIC and depth > b.size[kh] - EPSILON then
    put(b, hi, kh, b.position[kh], 0)
  elseif b.kind[hi] ~= DYNAMIC and depth > b.size[kl] - EPSILON then
    put(b, lo, kl, b.position[kl], 0)
  end
end

--- Notes two who are left as they are, for `keepOut`.
function crush.giveUp(b, lo, hi, axis)
  local pairs_, n = b.givenUp, b.givenUpCount
  pairs_[n + 1], pairs_[n + 2], pairs_[n + 3] = lo, hi, axis
  b.givenUpCount = n + 3
end

--- Notes that `lo` and `hi`, neither of which can give way, are pressed together on `axis`. All
--- that is held between two ends overlaps its neighbours by the same small amount.
function crush.note(b, lo, hi, axis)
  local low, high = endOf(b, lo, hi, axis, true), endOf(b, hi, lo, axis, false)
  if not (low and high) then
    crush.giveUp(b, lo, hi, axis)
    return stop(b, lo, hi, axis)
  end
  local count, sum = list(b, lo, hi, low, high, axis)
  if count == 0 then
    return stop(b, lo, hi, axis)
  end
  local kl, kh = 2 * low + axis, 2 * high + axis
  local at = b.to[kl] + b.size[kl]
  local total = at + sum - b.to[kh]
  local overlap = total / (count + 1)
  -- Each overlaps the next by more than they are wide: others have pushed an end that is no wall
  -- far beyond the other one, and only that counts.
  local hasOneWall = (b.kind[low] == DYNAMIC) ~= (b.kind[high] == DYNAMIC)
  if total <= EPSILON or (hasOneWall and overlap * count > sum) then
    spread(b, count, low, high, axis)
    -- They fit in exactly: then others must not push them to and fro until patience is used up.
    local fits = total >= -EPSILON and b.kind[low] ~= DYNAMIC and b.kind[high] ~= DYNAMIC
    for n = 1, fits and count or 0 do
      hold(b, n, count, low, high, axis)
    end
    return
  end
  local v = (b.speed[kl] + b.speed[kh]) * 0.5
  for n = 1, count do
    local i = b.stack[n]
    local k = 2 * i + axis
    local before, behind = hold(b, n, count, low, high, axis)
    b.crushed[k], b.crushLow[k], b.crushHigh[k] = true, before, behind
    b.hasCrushed = true
    put(b, i, k, at - overlap, v)
    at = b.to[k] + b.size[k]
  end
end

-- Keeps i out of `wall`, in which it is `depth` px deep on the axis of k: at `out`, where it is no
-- deeper than when the step began, `before` px. Who would be wholly inside, or on the far side,
-- ends where it was then.
local function keepOff(b, i, k, wall, depth, before, out)
  if depth > b.size[k] - EPSILON then
    for m = 2 * i, 2 * i + 1 do
      put(b, i, m, b.position[m], 0)
    end
  elseif depth > before + EPSILON and b.kind[wall] == STATIC and not b.buried[i] then
    put(b, i, k, out, 0)
  end
end

--- Keeps out of walls whom others have pushed there, when all is over: those who were given up, as
--- far as one of two cannot be pushed at all.
function crush.keepOut(b)
  local pairs_, to, size = b.givenUp, b.to, b.size
  for n = 1, b.givenUpCount, 3 do
    local lo, hi, axis = pairs_[n], pairs_[n + 1], pairs_[n + 2]
    local kl, kh, cl, ch = 2 * lo + axis, 2 * hi + axis, 2 * lo + 1 - axis, 2 * hi + 1 - axis
    local depth, before = depthOn(to, size, kl, kh), max(depthOn(b.position, size, kl, kh), 0.0)
    if min(depthOn(to, size, cl, ch), depthOn(to, size, ch, cl)) <= EPSILON then
      depth = 0.0 -- past each other
    end
    if b.kind[lo] ~= DYNAMIC then
      keepOff(b, hi, kh, lo, depth, before, to[kl] + size[kl] - before)
    elseif b.kind[hi] ~= DYNAMIC then
      keepOff(b, lo, kl, hi, depth, before, to[kh] - size[kl] + before)
    end
  end
end

--- Tells whoever began to be crushed in this step.
function crush.tell(b, i)
  for axis = 0, 1 do
    local k = 2 * i + axis
    if b.crushed[k] and not b.wasCrushed[k] then
      events.crush(b, i, b.crushLow[k], b.crushHigh[k], axis == 0 and "x" or "y")
    end
    b.wasCrushed[k] = b.crushed[k]
  end
end

return crush
