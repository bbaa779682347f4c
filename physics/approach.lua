--- When and on which side two objects meet, if both keep to their present paths.
--
-- Source: slab method on the Minkowski difference of two boxes that move in a straight line; the
-- side is the axis on which they were apart last.

local here = (...):match("^(.*)%.[^.]+$")
local aabb = require(here .. ".aabb")
local columns = require(here .. ".columns")

local approach = {}

local EPSILON = columns.EPSILON
-- Two axes that close within this fraction of the step close together: a vertical hit.
local TIE = 1e-9
-- px/s below which two do not move against each other.
local STILL = 1e-9

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

-- By how much the paths overlap on an axis at the end of the step. Both ways to round are asked, so
-- that a box that was put flush against the other, from either side, does not overlap it.
local function endOverlap(low, size, high)
  local forward, backward = low + size - high, low - (high - size)
  return forward < backward and forward or backward
end

-- Gap between two intervals at relative position r of the second; negative: overlap.
local function gapAt(r, sizeA, sizeB)
  local after, before = r - sizeA, -r - sizeB
  return after > before and after or before
end

-- Where in the rest of the step two shrunk boxes begin and cease to overlap on an axis, for a gap at
-- its start and its end (measured on the side where they are apart).
local function slab(gap, gapEnd, depth)
  gap, gapEnd = gap + 2 * EPSILON, gapEnd + 2 * EPSILON
  local closing = gap - gapEnd
  if closing <= 0 or gapEnd >= 0 then
    return 2, 2
  end
  return gap / closing, (gap + depth - 4 * EPSILON) / closing
end

-- Where the boxes themselves, not shrunk, close on an axis.
local function closes(gap, gapEnd)
  return gap > 0 and gap / (gap - gapEnd) or 0
end

-- Apart on both axes. Whether they meet at all is asked of slightly shrunk boxes, so that one that
-- slides past flush does not.
local function meetCorner(b, ka, kc, gapX, endX, aLowX, gapY, endY, aLowY)
  local size = b.size
  local inX, outX = slab(gapX, endX, size[ka] + size[kc])
  local inY, outY = slab(gapY, endY, size[ka + 1] + size[kc + 1])
  if inX > 1 or inY > 1 or inX >= outY or inY >= outX then
    return nil
  end
  if inY >= inX - TIE then
    if -endY > EPSILON then
      return closes(gapY, endY), approach.code(approach.CORNER, 1, not aLowY)
    end
  elseif -endX > EPSILON then
    return closes(gapX, endX), approach.code(approach.CORNER, 0, not aLowX)
  end
end

local SIDE_CODES = { right = { 0, false }, left = { 0, true }, bottom = { 1, false }, top = { 1, true } }

-- Two that are inside each other: they part along the axis on which they were apart before the
-- step, else by the opposite-sides rule. Rare.
local function meetDeep(b, ka, kc)
  local position, size, to = b.position, b.size, b.to
  local axis, secondIsLow
  for try = 0, 1 do
    local r = position[kc + try] - position[ka + try]
    if gapAt(r, size[ka + try], size[kc + try]) >= -EPSILON then
      axis, secondIsLow = try, r < 0
      break
    end
  end
  if not axis then
    local from = b.from
    local side = SIDE_CODES[aabb.side(
      from[ka],
      from[ka + 1],
      size[ka],
      size[ka + 1],
      from[kc],
      from[kc + 1],
      size[kc],
      size[kc + 1]
    )]
    axis, secondIsLow = side[1], side[2]
  end
  local low, high = ka + axis, kc + axis
  if secondIsLow then
    low, high = high, low
  end
  if endOverlap(to[low], size[low], to[high]) > 0 then
    return 0, approach.code(approach.DEEP, axis, secondIsLow)
  end
end

-- Apart on one axis only (`axis`), on which they close from `gap` to an overlap.
local function meetFace(b, ka, kc, axis, gap, aLow, rOther, endOther)
  local size, to = b.size, b.to
  local low, high = ka + axis, kc + axis
  if not aLow then
    low, high = high, low
  end
  local overlap = endOverlap(to[low], size[low], to[high])
  if overlap <= 0 then
    -- Flush now and at the end, but with speed left against each other: a push that was taken by
    -- one of them alone (push = "first").
    local closes = gap <= EPSILON and overlap > -EPSILON and b.speed[low] - b.speed[high] > STILL
    if not closes then
      return nil
    end
    overlap = 0
  end
  local share = 0
  if gap > EPSILON then
    share = gap / (gap + overlap)
  end
  local other = 1 - axis
  local r = rOther + (endOther - rOther) * share
  if gapAt(r, size[ka + other], size[kc + other]) >= -EPSILON then
    return nil
  end
  return share, approach.code(approach.FACE, axis, not aLow)
end

--- Returns where in the step (0..1) the objects `a` and `c` meet and the code of the meeting, or
--- nil.
function approach.test(b, a, c)
  local from, to, size, time = b.from, b.to, b.size, b.time
  local ka, kc = 2 * a, 2 * c
  local ax, ay, cx, cy = from[ka], from[ka + 1], from[kc], from[kc + 1]
  local timeA, timeC = time[a], time[c]
  local start = timeA
  if timeA < timeC then
    start = timeC
    local share = (timeC - timeA) / (1 - timeA)
    ax, ay = ax + (to[ka] - ax) * share, ay + (to[ka + 1] - ay) * share
  elseif timeC < timeA then
    local share = (timeA - timeC) / (1 - timeC)
    cx, cy = cx + (to[kc] - cx) * share, cy + (to[kc + 1] - cy) * share
  end

  local rx, endX = cx - ax, to[kc] - to[ka]
  local aLowX = rx - size[ka] >= -rx - size[kc]
  local gapX = aLowX and rx - size[ka] or -rx - size[kc]
  local gapEndX = aLowX and endX - size[ka] or -endX - size[kc]
  if gapX >= -EPSILON and gapEndX >= 0 then
    return nil
  end
  local ry, endY = cy - ay, to[kc + 1] - to[ka + 1]
  local aLowY = ry - size[ka + 1] >= -ry - size[kc + 1]
  local gapY = aLowY and ry - size[ka + 1] or -ry - size[kc + 1]
  local gapEndY = aLowY and endY - size[ka + 1] or -endY - size[kc + 1]
  if gapY >= -EPSILON and gapEndY >= 0 then
    return nil
  end

  local share, code
  if gapX >= -EPSILON then
    if gapY >= -EPSILON then
      share, code = meetCorner(b, ka, kc, gapX, gapEndX, aLowX, gapY, gapEndY, aLowY)
    else
      share, code = meetFace(b, ka, kc, 0, gapX, aLowX, ry, endY)
    end
  elseif gapY >= -EPSILON then
    share, code = meetFace(b, ka, kc, 1, gapY, aLowY, rx, endX)
  else
    share, code = meetDeep(b, ka, kc)
  end
  if share then
    return start + (1 - start) * share, code
  end
end

return approach
