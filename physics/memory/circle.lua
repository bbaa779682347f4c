--- Scalar circle maths: numbers in, numbers out, no tables, no checks. Squares and square roots
--- only, which are rounded in the same way on every machine.
---
--- A *round box* is a box and all that is nearer to it than a radius. A circle is the round box of
--- a point; a circle that meets a box is a point that meets a round box.

local max, min, sqrt = math.max, math.min, math.sqrt

local circle = {}

--- Returns the square of the distance of a point from a box, 0: inside.
---@param x number px, the point
---@param y number px
---@param left number px, edges of the box
---@param top number px
---@param right number px
---@param bottom number px
---@return number square px²
function circle.square(x, y, left, top, right, bottom)
  local dx, dy = max(left - x, x - right, 0.0), max(top - y, y - bottom, 0.0)
  return dx * dx + dy * dy
end

local square = circle.square

--- Returns the square of the smallest distance of a moving point from a box. Its motion is
--- (dx, dy).
--
-- Source: the square of the distance from a box is convex, so it is smallest at an end of the way,
-- where the way crosses an edge line, or nearest to a corner.
local function nearest(x, y, dx, dy, left, top, right, bottom)
  local length = dx * dx + dy * dy
  local least =
    min(square(x, y, left, top, right, bottom), square(x + dx, y + dy, left, top, right, bottom))
  if length == 0 then
    return least
  end
  for corner = 0, 3 do
    local cx, cy = corner % 2 == 0 and left or right, corner < 2 and top or bottom
    local s = ((cx - x) * dx + (cy - y) * dy) / length
    s = max(0.0, min(s, 1.0))
    least = min(least, square(x + dx * s, y + dy * s, left, top, right, bottom))
    local sx, sy = dx ~= 0 and (cx - x) / dx or 0.0, dy ~= 0 and (cy - y) / dy or 0.0
    sx, sy = max(0.0, min(sx, 1.0)), max(0.0, min(sy, 1.0))
    least = min(
      least,
      square(x + dx * sx, y + dy * sx, left, top, right, bottom),
      square(x + dx * sy, y + dy * sy, left, top, right, bottom)
    )
  end
  return least
end

-- When a point meets the face of a grown box on one axis, while it is beside the box itself on the
-- other one; 2: never.
local function meetFace(p, d, low, high, q, e, lowQ, highQ)
  if d == 0 then
    return 2
  end
  local share = (d > 0 and low - p or high - p) / d
  local at = q + e * share
  if share < 0 or share > 1 or at < lowQ or at > highQ then
    return 2
  end
  return share
end

-- When a point meets the circle of `radius` around (0, 0), outside of which it is; 2: never.
-- Source: the quadratic equation |p + d s|² = radius², in the form that does not cancel.
local function meetCorner(x, y, dx, dy, radius)
  local along, out = x * dx + y * dy, x * x + y * y - radius * radius
  if along >= 0 then
    return 2
  end
  local root = along * along - (dx * dx + dy * dy) * out
  if root < 0 then
    return 2
  end
  return max(out, 0.0) / (sqrt(root) - along)
end

--- Returns at what share of its way (dx, dy) a point first meets a round box, and the unit normal
--- there, away from the box. Nil: it does not get deeper into it than `slack`, or it is in it from
--- the beginning.
---@param x number px, the point
---@param y number px
---@param dx number px, its way
---@param dy number px
---@param left number px, edges of the box; a point: left = right, top = bottom
---@param top number px
---@param right number px
---@param bottom number px
---@param radius number px, > 0
---@param slack number px, how deep is not deep yet
---@return number? share 0..1
---@return number nx
---@return number ny
function circle.meet(x, y, dx, dy, left, top, right, bottom, radius, slack)
  local inner = max(radius - slack, 0.0)
  if
    square(x, y, left, top, right, bottom) < inner * inner
    or nearest(x, y, dx, dy, left, top, right, bottom) >= inner * inner
  then
    return nil, 0, 0
  end
  local share = min(
    meetFace(x, dx, left - radius, right + radius, y, dy, top, bottom),
    meetFace(y, dy, top - radius, bottom + radius, x, dx, left, right),
    meetCorner(x - left, y - top, dx, dy, radius),
    meetCorner(x - right, y - top, dx, dy, radius),
    meetCorner(x - left, y - bottom, dx, dy, radius),
    meetCorner(x - right, y - bottom, dx, dy, radius)
  )
  share = share > 1 and 0.0 or share -- it begins in the rim, no deeper than `slack`
  return share, circle.normal(x + dx * share, y + dy * share, left, top, right, bottom)
end

--- Returns the unit vector from a box to a point outside of it, and their distance; inside: 0.
---@param x number px
---@param y number px
---@param left number px
---@param top number px
---@param right number px
---@param bottom number px
---@return number nx
---@return number ny
---@return number distance px
function circle.normal(x, y, left, top, right, bottom)
  local nx = x - max(left, min(x, right))
  local ny = y - max(top, min(y, bottom))
  if ny == 0 then
    return nx > 0 and 1 or nx < 0 and -1 or 0, 0, max(nx, -nx)
  elseif nx == 0 then
    return 0, ny > 0 and 1 or -1, max(ny, -ny)
  end
  local length = sqrt(nx * nx + ny * ny)
  return nx / length, ny / length, length
end

--- Returns where a line from (x, y) by (dx, dy) enters and leaves a circle, as shares of the line;
--- enters > leaves: it misses.
---@param x number px, from the centre of the circle
---@param y number px
---@param dx number px
---@param dy number px
---@param radius number px
---@return number enters
---@return number leaves
function circle.passage(x, y, dx, dy, radius)
  local length = dx * dx + dy * dy
  local along, out = x * dx + y * dy, x * x + y * y - radius * radius
  local root = along * along - length * out
  if length == 0 then
    return out < 0 and -1 or 1, out < 0 and 1 or 0
  elseif root <= 0 then
    return 1, 0
  end
  root = sqrt(root)
  if along > 0 then
    return (-along - root) / length, -out / (along + root)
  end
  return out / (root - along), (root - along) / length
end

-- Pairs -------------------------------------------------------------------------------------------

-- Returns the point, the box and the radius of a round box, of which one is in the other as deep as
-- two objects are in each other. A round object is the circle in its square.
-- Source: the Minkowski difference of the two.
local function difference(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound)
  local radius = 0.0
  if isRound then
    radius = w * 0.5
    x, y, w, h = x + radius, y + radius, 0.0, 0.0
  end
  if isOtherRound then
    local r = ow * 0.5
    radius = radius + r
    ox, oy, ow, oh = ox + r, oy + r, 0.0, 0.0
  end
  return x, y, ox - w, oy - h, ox + ow, oy + oh, radius
end

--- Returns whether two objects, at least one of which is round, overlap by more than `slack`.
---@param x number px, the square or box of the first
---@param y number px
---@param w number px
---@param h number px
---@param isRound boolean whether the first is a circle
---@param ox number px, the second likewise
---@param oy number px
---@param ow number px
---@param oh number px
---@param isOtherRound boolean
---@param slack number px
---@return boolean
function circle.overlap(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound, slack)
  local px, py, left, top, right, bottom, radius =
    difference(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound)
  local reach = max(radius - slack, 0.0)
  return square(px, py, left, top, right, bottom) < reach * reach
end

--- Returns how far two objects are apart, < 0: by how much they overlap (not more than the sum of
--- the radii), and the unit normal from the second to the first.
---@return number gap px
---@return number nx
---@return number ny
function circle.gap(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound)
  local px, py, left, top, right, bottom, radius =
    difference(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound)
  local nx, ny, distance = circle.normal(px, py, left, top, right, bottom)
  return distance - radius, nx, ny
end

--- The same as `meet` for an object on its way by (dx, dy) and another one that stands still.
---@return number? share 0..1, nil: they do not meet, or overlap from the beginning
---@return number nx
---@return number ny
function circle.meetPair(x, y, w, h, isRound, dx, dy, ox, oy, ow, oh, isOtherRound, slack)
  local px, py, left, top, right, bottom, radius =
    difference(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound)
  return circle.meet(px, py, dx, dy, left, top, right, bottom, radius, slack)
end

return circle
