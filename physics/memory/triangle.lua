--- Scalar maths of slopes: right triangles that fill a box. Numbers in, numbers out.
---
--- A slope is solid on one side of each axis: SOLID[axis][shape] is 1 where that is the high side
--- (right, bottom), -1 where it is the low one. What touches the sloped edge is a corner of a box:
--- the one on the solid sides.
---
---        B          "right": SOLID[0] = 1, SOLID[1] = 1
---       /|          `depth` at A is its height, at B it is 0
---     A--+

local max, min = math.max, math.min

local triangle = {}

--- Shapes from this one on are slopes.
triangle.FIRST = 2
--- By axis and shape (left, right, topleft, topright): see above.
triangle.SOLID = { [0] = { 0, -1, 1, -1, 1 }, { 0, 1, 1, -1, -1 } }

--- Returns how far the sloped edge is from the side of the triangle's box that it begins on, along
--- an axis, at the corner of a box; beyond the ends it goes on in a straight line.
---@param sign number on which side across the axis it is solid
---@param at number px, its place across the axis
---@param across number px, its size there
---@param along number px, its size on the axis
---@param x number px, place of the box across the axis
---@param width number px, size of the box there
---@return number px
function triangle.line(sign, at, across, along, x, width)
  local off = x - at
  if sign > 0 then
    off = at + across - (x + width)
  end
  return off * along / across
end

--- Returns the same of what the box can rest on: 0 beyond the crest, the whole size before the foot.
function triangle.depth(sign, at, across, along, x, width)
  local off
  if sign > 0 then
    off = at + across - min(x + width, at + across)
  else
    off = max(x, at) - at
  end
  return min(off, across) * along / across
end

return triangle
