--- Swept AABB: computes the time of impact and the side at which a moving box meets one that stands
--- still. Scalars only.
--
-- The rules are those of a step (see solver/sweep.lua). The side is on the axis on which the two
-- were apart last. A box that slides past flush meets nothing. The place at the hit is flush to the
-- bit.
--
-- Source: slab method on the Minkowski difference of the two boxes.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

require(root .. ".memory.jit").file()

local sweep = {}

local EPSILON = columns.EPSILON
local min = math.min
-- Two axes that close within this fraction of the way close together.
local TIE = 1e-9

--- Kinds of impact, in the order in which simultaneous ones count.
sweep.FACE, sweep.CORNER = 0, 1

-- Returns the gap between two intervals, negative: overlap; and whether the first one is the low
-- one.
local function gapOf(at, size, other, otherSize)
  local r = other - at
  local after, before = r - size, -r - otherSize
  if after >= before then
    return after, true
  end
  return before, false
end

-- Returns the gap on the same side as the first gap, at another place.
local function gapAgain(at, size, other, otherSize, isLow)
  if isLow then
    return other - at - size
  end
  return at - other - otherSize
end

-- Returns by how much the two overlap at the end of the way. It rounds in both ways and takes the
-- smaller result, so that a box that was put flush against the other, from either side, does not
-- overlap it.
local function endOverlap(to, size, other, otherSize, isLow)
  if isLow then
    return min(to + size - other, to - (other - size))
  end
  return min(other + otherSize - to, other - (to - otherSize))
end

-- Returns the fraction of the way at which the two meet on this axis, overlapping on the other (b);
-- nil: never.
local function meetFace(at, size, to, other, otherSize, atB, sizeB, toB, otherB, otherSizeB)
  local gap, isLow = gapOf(at, size, other, otherSize)
  local closes = isLow and to > at or not isLow and to < at
  local overlap = endOverlap(to, size, other, otherSize, isLow)
  if not closes or overlap <= 0 then
    return nil
  end
  local share = gap > EPSILON and gap / (gap + overlap) or 0
  local gapB = gapOf(atB + (toB - atB) * share, sizeB, otherB, otherSizeB)
  if gapB >= -EPSILON then
    return nil -- past each other by then
  end
  return share, isLow
end

-- Returns the part of the way on which two slightly shrunk boxes overlap on an axis on which they
-- are still apart.
local function span(at, size, to, other, otherSize)
  local gap, isLow = gapOf(at, size, other, otherSize)
  local gapEnd = gapAgain(to, size, other, otherSize, isLow) + 2 * EPSILON
  gap = gap + 2 * EPSILON -- > 0: the two are apart
  if gapEnd >= 0 then
    return 2, 2
  end
  local depth = size + otherSize - 4 * EPSILON
  return gap / (gap - gapEnd), (gap + depth) / (gap - gapEnd)
end

local function shareOn(at, size, to, other, otherSize)
  local gap, isLow = gapOf(at, size, other, otherSize)
  local overlap = endOverlap(to, size, other, otherSize, isLow)
  if overlap <= EPSILON then
    return nil
  end
  return gap > 0 and gap / (gap + overlap) or 0, isLow
end

--- Returns when a box on its way from (x, y) to (toX, toY) meets another one that it does not
--- overlap yet. The values are the fraction of the way, the axis (0: x, 1: y), whether the moving
--- box has the smaller coordinate, and the kind of impact. nil: never.
---@param downAxis integer 0 or 1: the axis that counts if both close together
function sweep.meet(x, y, w, h, toX, toY, ox, oy, ow, oh, downAxis)
  local share, isLow
  local gapX, gapY = gapOf(x, w, ox, ow), gapOf(y, h, oy, oh)
  if gapX < -EPSILON then
    share, isLow = meetFace(y, h, toY, oy, oh, x, w, toX, ox, ow)
    return share, 1, isLow, sweep.FACE
  elseif gapY < -EPSILON then
    share, isLow = meetFace(x, w, toX, ox, ow, y, h, toY, oy, oh)
    return share, 0, isLow, sweep.FACE
  end
  local inX, outX = span(x, w, toX, ox, ow)
  local inY, outY = span(y, h, toY, oy, oh)
  if inX > 1 or inY > 1 or inX >= outY or inY >= outX then
    return nil
  end
  local axis = inY > inX and 1 or 0
  if inY - inX <= TIE and inX - inY <= TIE then
    axis = downAxis
  end
  if axis == 0 then
    share, isLow = shareOn(x, w, toX, ox, ow)
  else
    share, isLow = shareOn(y, h, toY, oy, oh)
  end
  return share, axis, isLow, sweep.CORNER
end

--- Returns where the moving box is at an impact: flush on its axis.
function sweep.place(x, y, w, h, toX, toY, ox, oy, ow, oh, share, axis, isLow)
  if axis == 0 then
    return isLow and ox - w or ox + ow, y + (toY - y) * share
  end
  return x + (toX - x) * share, isLow and oy - h or oy + oh
end

--- Returns whether two boxes overlap by more than rounding.
function sweep.overlap(x, y, w, h, ox, oy, ow, oh)
  return gapOf(x, w, ox, ow) < -EPSILON and gapOf(y, h, oy, oh) < -EPSILON
end

return sweep
