--- Scalar maths of slopes: right triangles that fill a box. Numbers in, numbers out.
---
--- A slope is solid on one side of each axis: SOLID[axis][shape] is 1 where that is the high side
--- (right, bottom), -1 where it is the low one. What touches the sloped edge is a corner of a box:
--- the one on the solid sides.
---
---        B          "right": SOLID[0] = 1, SOLID[1] = 1
---       /|          `depth` at A is its height, at B it is 0
---     A--+
---
--- For a box that moves, the triangle is a pentagon: the four sides of boxes, and the edge. Where a
--- box is, is told as rx, ry: px from the low corner of the triangle's box to its own.
--- Source of `enter`: line clipping by M. Cyrus and J. Beck, Generalized Two- and Three-Dimensional
--- Clipping, Computers and Graphics 3, 1978, on the Minkowski difference.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local max, min, sqrt = math.max, math.min, math.sqrt
local EPSILON = columns.EPSILON
-- Fraction of a way within which two faces are met together.
local TIE = 1e-9

local triangle = {}

--- Shapes from this one on are slopes.
triangle.FIRST = columns.SHAPE_SLOPE_LEFT
--- By axis and shape (left, right, topleft, topright): see above.
triangle.SOLID = { [0] = { 0, -1, 1, -1, 1 }, { 0, 1, 1, -1, -1 } }
--- Faces: the legs, where it is solid, and the open sides of its box, by axis; and the edge.
triangle.LEG, triangle.OPEN, triangle.EDGE = 0, 2, 4
local SOLID, LEG, OPEN, EDGE = triangle.SOLID, triangle.LEG, triangle.OPEN, triangle.EDGE

--- Returns how far the edge is from the side of the triangle's box that it begins on, along an
--- axis, at the corner of a box: 0 beyond the crest, the whole size before the foot.
---@param sign number on which side across the axis it is solid
---@param at number px, its place across the axis
---@param across number px, its size there
---@param along number px, its size on the axis
---@param x number px, place of the box across the axis
---@param width number px, size of the box there
---@return number px
function triangle.depth(sign, at, across, along, x, width)
  local off
  if sign > 0 then
    off = at + across - min(x + width, at + across)
  else
    off = max(x, at) - at
  end
  return min(off, across) * along / across
end

-- px from the corner of a box to the edge along an axis, as if that went on in a straight line.
local function toEdge(shape, axis, rx, ry, w, h, ow, oh)
  local t, r, size, its = rx, ry, h, oh
  local tw, tow = w, ow
  if axis == 0 then
    t, r, size, its, tw, tow = ry, rx, w, ow, h, oh
  end
  local off = t
  if SOLID[1 - axis][shape] > 0 then
    off = tow - (t + tw)
  end
  local way = off * its / tow
  if SOLID[axis][shape] > 0 then
    return way - r - size
  end
  return r - its + way
end

--- Returns px from a box to a face of a triangle, along the axis of that (of the edge: along
--- `axis`); below 0: it is beyond it.
function triangle.gap(face, shape, axis, rx, ry, w, h, ow, oh)
  if face == EDGE then
    return toEdge(shape, axis, rx, ry, w, h, ow, oh)
  end
  local q = face % 2
  local r, size, its = rx, w, ow
  if q == 1 then
    r, size, its = ry, h, oh
  end
  if (SOLID[q][shape] > 0) == (face < OPEN) then
    return r - its
  end
  return -r - size
end

local gap = triangle.gap

-- The n-th face to be looked at: of two that are as far, the edge counts, then the axis of gravity.
local function faceOf(n, axis)
  if n == 0 then
    return EDGE
  end
  return (n <= 2 and OPEN or LEG) + (n % 2 == 1 and axis or 1 - axis)
end

--- Returns which face a box is furthest beyond, and px to that: the greatest gap.
function triangle.nearest(shape, axis, rx, ry, w, h, ow, oh)
  local best, most = EDGE, toEdge(shape, axis, rx, ry, w, h, ow, oh)
  for n = 1, 4 do
    local face = faceOf(n, axis)
    local its = gap(face, shape, axis, rx, ry, w, h, ow, oh)
    if its > most + EPSILON then
      best, most = face, its
    end
  end
  return best, most
end

--- Returns whether a box is the low one at a face.
function triangle.isLow(face, shape, axis)
  return (SOLID[face == EDGE and axis or face % 2][shape] > 0) == (face >= OPEN)
end

-- The face that a box on its way by (dx, dy) enters last, and when (0..1); nil, 0: it begins
-- inside.
local function enter(shape, axis, rx, ry, w, h, ow, oh, dx, dy)
  local face, share, out = nil, -1, 2
  for n = 0, 4 do
    local its = faceOf(n, axis)
    local first = gap(its, shape, axis, rx, ry, w, h, ow, oh)
    local last = gap(its, shape, axis, rx + dx, ry + dy, w, h, ow, oh)
    if first >= -EPSILON then
      if last >= -EPSILON or last >= first then
        return nil
      end
      local s = max(first, 0.0) / (first - last)
      if s > share + TIE then
        face, share = its, s
      end
    elseif last > -EPSILON then
      out = min(out, (first + EPSILON) / (first - last))
    end
  end
  if face and share >= out then
    return nil
  end
  return face, face and share or 0.0
end

--- Returns when a box on its way by (dx, dy), relative to a triangle, meets it (0..1), at which
--- face, and whether it was inside from the beginning; nil: never.
function triangle.meet(shape, axis, rx, ry, w, h, ow, oh, dx, dy)
  local face, share = enter(shape, axis, rx, ry, w, h, ow, oh, dx, dy)
  if not share then
    return nil
  elseif not face then
    local most
    face, most = triangle.nearest(shape, axis, rx + dx, ry + dy, w, h, ow, oh)
    if most >= -EPSILON then
      return nil
    end
    return 0.0, face, true
  elseif face == OPEN + 1 - axis then
    -- Level with the foot, or above it: the edge is met.
    local x, y = rx + dx * share, ry + dy * share
    if toEdge(shape, axis, x, y, w, h, ow, oh) >= -EPSILON then
      face = EDGE
    end
  end
  return share, face, false
end

--- Returns the normal of the edge, of length 1.
function triangle.normal(shape, ow, oh)
  local length = sqrt(ow * ow + oh * oh)
  return -SOLID[0][shape] * oh / length, -SOLID[1][shape] * ow / length
end

--- Returns how much further along an axis the edge is for each px across it, where the coordinates
--- grow.
function triangle.slant(shape, axis, ow, oh)
  local rise = axis == 1 and oh / ow or ow / oh
  return -rise * SOLID[0][shape] * SOLID[1][shape]
end

--- Returns the square of the distance of a point from the edge, if that is the nearest; else nil.
--- (rx, ry): px from the low corner of the triangle's box to the point.
function triangle.distance(shape, rx, ry, ow, oh)
  if toEdge(shape, 1, rx, ry, 0, 0, ow, oh) <= 0 then
    return nil
  end
  local slant = triangle.slant(shape, 1, ow, oh)
  local y0 = slant < 0 and oh or 0.0 -- where the edge is at x = 0
  local share = max(min((rx * ow + (ry - y0) * slant * ow) / (ow * ow + oh * oh), 1), 0)
  local dx, dy = rx - ow * share, ry - y0 - slant * ow * share
  return dx * dx + dy * dy
end

return triangle
