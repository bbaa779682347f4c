--- Quarter turns of vectors, boxes and side names: a scene turned once falls to the left, turned
--- twice upwards, turned three times to the right.
---
---     0: y          1: <- y       2: ^ y        3: y ->
---        v

local turn = {}

turn.names = { [0] = "down", "left", "up", "right" }

local NEXT = { bottom = "left", left = "top", top = "right", right = "bottom" }

--- Turns a vector clockwise.
---@param count integer quarter turns, 0..3
function turn.vector(count, x, y)
  if count == 1 then
    return 0 - y, x
  end
  if count == 2 then
    return 0 - x, 0 - y
  end
  if count == 3 then
    return y, 0 - x
  end
  return x, y
end

--- Turns a box clockwise around the origin.
---@return number x, number y, number width, number height
function turn.box(count, x, y, width, height)
  if count == 1 then
    return 0 - (y + height), x, height, width
  end
  if count == 2 then
    return 0 - (x + width), 0 - (y + height), width, height
  end
  if count == 3 then
    return y, 0 - (x + width), height, width
  end
  return x, y, width, height
end

--- Turns the name of a side.
function turn.side(count, side)
  for _ = 1, count do
    side = NEXT[side]
  end
  return side
end

-- The sides on which slopes are solid.
local SOLID = {
  left = { "left", "bottom" },
  right = { "right", "bottom" },
  topleft = { "left", "top" },
  topright = { "right", "top" },
}

--- Turns the value of the field `slope`.
function turn.slope(count, name)
  local one, other = turn.side(count, SOLID[name][1]), turn.side(count, SOLID[name][2])
  for its, sides in pairs(SOLID) do
    if (sides[1] == one and sides[2] == other) or (sides[1] == other and sides[2] == one) then
      return its
    end
  end
end

--- The number of turns that undoes `count` turns.
function turn.back(count)
  if count == 0 then
    return 0
  end
  return 4 - count
end

return turn
