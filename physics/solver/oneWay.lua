--- One-way objects: decides from the side of a contact whether a one-way object is solid there or
-- open.
--
-- The side in the field `oneWay` is solid, the others are open. Writes dropping.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")

local oneway = {}

local SIDE = columns.SIDE

--- Returns whether slot i is a one-way object that is open on `side`.
function oneway.isOpen(b, i, side)
  local solid = b.oneWay[i]
  return solid and SIDE[solid] ~= side
end

local isOpen = oneway.isOpen

--- Returns whether slot i falls through a one-way object with the side `solid` (nil: with none).
--- Until it is clear of that, no other one holds it, as the next plank of a bridge would.
function oneway.isFalling(b, i, solid)
  local half = solid and b.head[i] or 0
  while half ~= 0 do
    if b.dropping[(half + half % 2) / 2] and b.oneWay[b.other[half]] == solid then
      return true
    end
    half = b.next[half]
  end
  return false
end

local isFalling = oneway.isFalling

--- Returns whether one of i and j falls through the other because of that.
function oneway.isDropping(b, i, j)
  return isFalling(b, i, b.oneWay[j]) or isFalling(b, j, b.oneWay[i])
end

local isDropping = oneway.isDropping

--- Returns whether i and j, which meet on `side` of i, pass through each other because one is a
--- one-way object. What overlaps a one-way object already (`isDeep`) always passes.
function oneway.lets(b, i, j, side, isDeep)
  if not (b.oneWay[i] or b.oneWay[j]) then
    return false
  end
  return isDeep or isOpen(b, i, side) or isOpen(b, j, columns.OPPOSITE[side]) or isDropping(b, i, j)
end

-- Returns the side of slot i that points along its gravity, with which it stands; 0 without
-- gravity.
local function footOf(b, i)
  local x, y = b.down[2 * i], b.down[2 * i + 1]
  if x ~= 0 then
    return x > 0 and SIDE.right or SIDE.left
  elseif y ~= 0 then
    return y > 0 and SIDE.bottom or SIDE.top
  end
  return 0
end

-- Lets slot i, which falls through slope j, begin as fast as the edge sinks under it. Else it would
-- be left above the edge where it runs down.
local function keepUp(b, i, j)
  local axis, object = slope.axisOf(b, i), b.object[i]
  local along, across = axis == 0 and "vx" or "vy", axis == 0 and "vy" or "vx"
  local speed = slope.gradient(b, i, j) * (object[across] or 0)
  if (speed - (object[along] or 0)) * b.down[2 * i + axis] > 0 then
    object[along] = speed
  end
end

--- Lets slot i fall through the one-way objects that it stands on. Returns whether there were any.
--- An object that is not dynamic stands on nothing.
function oneway.drop(b, i)
  if b.kind[i] ~= columns.DYNAMIC then
    return false
  end
  local half, foot, any = b.head[i], footOf(b, i), false
  while half ~= 0 do
    local p, j = (half + half % 2) / 2, b.other[half]
    local side = b.contact[p] -- side of the first body of the pair
    if side ~= 0 and b.pairA[p] ~= i then
      side = columns.OPPOSITE[side]
    end
    if side ~= 0 and side == foot and b.oneWay[j] then
      b.dropping[p] = true
      any = true
      keepUp(b, i, j)
    end
    half = b.next[half]
  end
  return any
end

interpreted.functions(oneway.isFalling, oneway.lets, keepUp, oneway.drop)

return oneway
