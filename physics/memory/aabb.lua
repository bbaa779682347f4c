--- Scalar rectangle maths: numbers in, numbers out, no tables, no checks.
--- A rectangle is `x, y, width, height`: top-left corner and size in px, y down. Everything else in
--- the library may stand on this file; it stands on nothing.

local max, min = math.max, math.min

local aabb = {}

--- Returns the size of the intersection rectangle.
---
---     +-------+              width, height > 0: the rectangles overlap
---     |   +---|---+          = 0: flush
---     |   |###|   |          < 0: a gap of that many px
---     +---|---+   |
---         +-------+
---@param x1 number px, left edge of the first
---@param y1 number px, its top edge
---@param w1 number px, its width
---@param h1 number px, its height
---@param x2 number px, the second likewise
---@param y2 number px
---@param w2 number px
---@param h2 number px
---@return number width px
---@return number height px
function aabb.overlap(x1, y1, w1, h1, x2, y2, w2, h2)
  return min(x1 + w1, x2 + w2) - max(x1, x2), min(y1 + h1, y2 + h2) - max(y1, y2)
end

--- Tells whether the first rectangle lies inside the second. The left and top edges of the second
--- belong to it, its right and bottom edges do not. A size of 0, 0 asks about a point.
---@param x1 number px, left edge of the first
---@param y1 number px, its top edge
---@param w1 number px, its width, may be 0
---@param h1 number px, its height, may be 0
---@param x2 number px, the second likewise
---@param y2 number px
---@param w2 number px
---@param h2 number px
---@return boolean
function aabb.inside(x1, y1, w1, h1, x2, y2, w2, h2)
  return x1 >= x2 and x1 + w1 < x2 + w2 and y1 >= y2 and y1 + h1 < y2 + h2
end

-- px; 1 / TINY is a number still, for smaller ones it is infinite.
local TINY = 1e-300

--- Returns what share of a way along an axis 1 px is, for `passage`: never infinite.
---@param d number px, how far it goes on the axis; may be 0
---@return number
function aabb.share(d)
  return (d < 0 and -1 or 1) / max(d, -d, TINY)
end

--- Returns at what share of its way a line that begins at 0, 0 enters a box, and at what share it
--- leaves it; if it leaves before it enters, or before 0, or enters after 1, they do not meet. Up
--- to rounding. No branches, so that it is one piece of code for all lines.
---@param left number px, edges of the box
---@param top number px
---@param right number px
---@param bottom number px
---@param shareX number what `share` tells of the line on each axis
---@param shareY number
---@return number enters
---@return number leaves
function aabb.passage(left, top, right, bottom, shareX, shareY)
  local a, b, c, d = left * shareX, right * shareX, top * shareY, bottom * shareY
  return max(min(a, b), min(c, d)), min(max(a, b), max(c, d))
end

local passage = aabb.passage

--- Returns >= 0 if a line that begins at 0, 0 meets a box, up to rounding; see `passage`.
---@param left number px, edges of the box
---@param top number px
---@param right number px
---@param bottom number px
---@param shareX number
---@param shareY number
---@return number
function aabb.crossing(left, top, right, bottom, shareX, shareY)
  local enters, leaves = passage(left, top, right, bottom, shareX, shareY)
  return min(leaves - enters, leaves, 1 - enters)
end

--- Returns how far the first rectangle would have to move to leave the second, one number for each
--- side of the first: `right` is the distance from its right edge to the left edge of the second,
--- so a rectangle that is hit on its right leaves to the left by that much.
---@param x1 number px, left edge of the first
---@param y1 number px, its top edge
---@param w1 number px, its width
---@param h1 number px, its height
---@param x2 number px, the second likewise
---@param y2 number px
---@param w2 number px
---@param h2 number px
---@return number right px
---@return number left px
---@return number bottom px
---@return number top px
function aabb.exits(x1, y1, w1, h1, x2, y2, w2, h2)
  return x1 + w1 - x2, x2 + w2 - x1, y1 + h1 - y2, y2 + h2 - y1
end

--- Returns the side of the first rectangle that is hit, given that the two overlap: the side with
--- the smallest exit. Ties go to the bottom, then the top, then the left, then the right.
--- Source: "Making a Simple 2D Physics Engine", part 1, opposite sides difference.
---@param x1 number px, left edge of the first
---@param y1 number px, its top edge
---@param w1 number px, its width
---@param h1 number px, its height
---@param x2 number px, the second likewise
---@param y2 number px
---@param w2 number px
---@param h2 number px
---@return "right"|"left"|"top"|"bottom" side
function aabb.side(x1, y1, w1, h1, x2, y2, w2, h2)
  local right, left, bottom, top = aabb.exits(x1, y1, w1, h1, x2, y2, w2, h2)
  if right < left and right < top and right < bottom then
    return "right"
  elseif left < top and left < bottom then
    return "left"
  elseif top < bottom then
    return "top"
  end
  return "bottom"
end

return aabb
