--- When and on which side two objects meet (their time of impact), if both keep to their present
--- paths.
--
-- Source: slab method on the Minkowski difference of two boxes that move in a straight line; the
-- side is the axis on which they were apart last.

local here = (...):match("^(.*)%.[^.]+$")
local aabb = require(here .. ".aabb")
local columns = require(here .. ".columns")
local gather = require(here .. ".gather")
local interpreted = require(here .. ".interpreted")

local approach = {}

local EPSILON = columns.EPSILON
local max = math.max
local endOverlap = gather.endOverlap
-- Two axes that close within this fraction of the step close together: a vertical hit.
local TIE = 1e-9
local STILL = columns.STILL

--- Kinds of meeting, in the order in which simultaneous ones are resolved.
approach.FACE, approach.CORNER, approach.DEEP = 0, 1, 2

--- A meeting is told as one number: kind * 4 + axis * 2 + (1 if the second of the pair is the one
--- with the smaller coordinate).
function approach.code(kind, axis, secondIsLow)
  return kind * 4 + axis * 2 + (secondIsLow and 1 or 0)
end

--- Returns kind, axis and whether the second of the pair has the smaller coordinate.
function approach.decode(code)
  local low = code % 2
  local rest = (code - low) / 2
  local axis = rest % 2
  return (rest - axis) / 2, axis, low == 1
end

--- The same meeting, told with the two of the pair exchanged.
function approach.mirrored(code)
  return code % 2 == 0 and code + 1 or code - 1
end

-- Gap between two intervals at relative position r of the second; negative: overlap.
local function gapAt(r, sizeA, sizeB)
  local after, before = r - sizeA, -r - sizeB
  return after > before and after or before
end

-- The gap on an axis at the beginning and, on the same side, at the end; whether the object itself
-- is the low one. `at` is where the pair's numbers begin in b.relative.
local function gaps(b, at, ka, kc, axis)
  local r, rEnd = b.relative[at + axis + 1], b.relative[at + axis + 3]
  local after, before = r - b.size[ka + axis], -r - b.size[kc + axis]
  if after >= before then
    return after, rEnd - b.size[ka + axis], true
  end
  return before, -rEnd - b.size[kc + axis], false
end

-- Where in the rest of the step two slightly shrunk boxes begin to overlap on an axis, and where
-- they cease to.
local function enters(b, at, ka, kc, axis)
  local gap, gapEnd = gaps(b, at, ka, kc, axis)
  gap, gapEnd = gap + EPSILON, gapEnd + EPSILON -- gap > 0: the two are apart
  if gapEnd >= 0 then
    return 2
  end
  return gap / (gap - gapEnd)
end

local function leaves(b, at, ka, kc, axis)
  local gap, gapEnd = gaps(b, at, ka, kc, axis)
  local depth = b.size[ka + axis] + b.size[kc + axis] - 2 * EPSILON
  return (gap + EPSILON + depth) / (gap - gapEnd)
end

-- Apart on both axes. Whether they meet at all is asked of slightly shrunk boxes, so that one that
-- slides past flush does not; where, of the boxes themselves.
local function meetCorner(b, at, ka, kc)
  local inX, inY = enters(b, at, ka, kc, 0), enters(b, at, ka, kc, 1)
  if inX > 1 or inY > 1 or inX >= leaves(b, at, ka, kc, 1) or inY >= leaves(b, at, ka, kc, 0) then
    return nil
  end
  local axis = inY > inX and 1 or 0
  if inY - inX <= TIE and inX - inY <= TIE then
    axis = b.downAxis -- a tie: along gravity
  end
  local gap, gapEnd, aLow = gaps(b, at, ka, kc, axis)
  if -gapEnd <= EPSILON then
    return nil
  end
  return gap > 0 and gap / (gap - gapEnd) or 0, approach.code(approach.CORNER, axis, not aLow)
end

-- Apart on one axis only, by `gap`, on which they close. `aLow`: the object itself is the low one.
local function meetFace(b, at, ka, kc, axis, gap, aLow)
  local low, high = ka + axis, kc + axis
  if not aLow then
    low, high = kc + axis, ka + axis
  end
  local overlap = endOverlap(b, low, high)
  if overlap <= EPSILON and b.speed[low] - b.speed[high] <= STILL then
    return nil -- side by side, apart from rounding
  end
  if overlap <= 0 then
    -- Flush now and at the end, but with speed left against each other: a push that was taken by
    -- one of them alone (push = "first").
    if not (b.pushFirst and gap <= EPSILON and overlap > -EPSILON) then
      return nil
    end
    overlap = 0
  end
  if gap <= EPSILON then
    return 0, approach.code(approach.FACE, axis, not aLow)
  end
  local share = gap / (gap + overlap)
  local r = b.relative[at + 2 - axis]
  r = r + (b.relative[at + 4 - axis] - r) * share
  if gapAt(r, b.size[ka + 1 - axis], b.size[kc + 1 - axis]) >= -EPSILON then
    return nil -- past each other by then
  end
  return share, approach.code(approach.FACE, axis, not aLow)
end

local SIDE_CODES =
  { right = { 0, false }, left = { 0, true }, bottom = { 1, false }, top = { 1, true } }

-- Inside each other: they part along the axis on which they were apart before they came there, else
-- by the opposite-sides rule. Rare.
local function meetDeep(b, p, ka, kc)
  local from, size = b.from, b.size
  local axis, secondIsLow
  if b.wedged[p] ~= 0 then
    local _
    _, axis, secondIsLow = approach.decode(b.wedged[p] - 1)
    secondIsLow = secondIsLow == (b.pairA[p] * 2 == ka)
  else
    -- A tie is decided by the order of the world, not by who of the two is looked at.
    local isSwapped = b.rank[kc / 2] < b.rank[ka / 2]
    local one, other = ka, kc
    if isSwapped then
      one, other = kc, ka
    end
    local side = SIDE_CODES[aabb.side(
      from[one],
      from[one + 1],
      size[one],
      size[one + 1],
      from[other],
      from[other + 1],
      size[other],
      size[other + 1]
    )]
    axis, secondIsLow = side[1], side[2] ~= isSwapped
  end
  local low, high = ka + axis, kc + axis
  if secondIsLow then
    low, high = kc + axis, ka + axis
  end
  if endOverlap(b, low, high) <= 0 then
    return nil
  end
  return 0, approach.code(approach.DEEP, axis, secondIsLow)
end

-- Faces are what crowds and heaps are made of; the others go too many ways.
interpreted.functions(meetCorner, meetDeep)

-- What `gaps` tells of both axes at the beginning decides which of the four it is.
local function meet(b, at, p, ka, kc)
  local size, x, y = b.size, b.relative[at + 1], b.relative[at + 2]
  local afterX, beforeX = x - size[ka], -x - size[kc]
  local afterY, beforeY = y - size[ka + 1], -y - size[kc + 1]
  local gapX, gapY = max(afterX, beforeX), max(afterY, beforeY)
  if gapX >= -EPSILON then
    if gapY >= -EPSILON then
      return meetCorner(b, at, ka, kc)
    end
    return meetFace(b, at, ka, kc, 0, gapX, afterX >= beforeX)
  elseif gapY >= -EPSILON then
    return meetFace(b, at, ka, kc, 1, gapY, afterY >= beforeY)
  end
  return meetDeep(b, p, ka, kc)
end

--- Computes when and how the `count` pairs listed meet: writes the pair into b.near, the moment
--- (0..1 of the step) into b.nearTime and the code of the meeting into b.nearCode; the code is -1
--- for those that do not.
function approach.run(b, count)
  local near, nearTime, nearCode, time, other = b.near, b.nearTime, b.nearCode, b.time, b.other
  for n = 1, count do
    local half = near[n]
    local isFirst = half % 2 == 1
    local p = isFirst and (half + 1) / 2 or half / 2
    local i, j = other[isFirst and half + 1 or half - 1], other[half]
    local share, code = meet(b, 4 * n - 4, p, 2 * i, 2 * j)
    near[n], nearCode[n] = p, -1
    if share then
      local start = max(time[i], time[j])
      nearTime[n] = start + (1 - start) * share
      -- The code is about the pair's own first and second.
      nearCode[n] = isFirst and code or approach.mirrored(code)
    end
  end
end

return approach
