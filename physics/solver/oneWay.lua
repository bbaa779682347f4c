--- One-way objects: solid on one side, open on the others.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")

local oneway = {}

local SIDE = columns.SIDE

--- Returns whether slot i is open where it was hit: on `side` of it.
function oneway.isOpen(b, i, side)
  local solid = b.oneWay[i]
  return solid and SIDE[solid] ~= side
end

local isOpen = oneway.isOpen

--- Returns whether two that meet on `side` of i pass through each other there. What is inside a
--- one-way already (`isDeep`) always passes.
function oneway.lets(b, i, j, side, isDeep)
  if not (b.oneWay[i] or b.oneWay[j]) then
    return false
  end
  return isDeep or isOpen(b, i, side) or isOpen(b, j, columns.OPPOSITE[side])
end

-- The side of slot i with which it stands on what is below, as gravity sees it; 0: it floats.
local function footOf(b, i)
  local x, y = b.down[2 * i], b.down[2 * i + 1]
  if x ~= 0 then
    return x > 0 and SIDE.right or SIDE.left
  elseif y ~= 0 then
    return y > 0 and SIDE.bottom or SIDE.top
  end
  return 0
end

--- Lets slot i fall through the one-way objects it stands on; returns whether there were any. What
--- is not dynamic stands on nothing.
function oneway.drop(b, i)
  if b.kind[i] ~= columns.DYNAMIC then
    return false
  end
  local half, foot, any = b.head[i], footOf(b, i), false
  while half ~= 0 do
    local p, j = (half + half % 2) / 2, b.other[half]
    local side = b.contact[p] -- of the pair's first
    if side ~= 0 and b.pairA[p] ~= i then
      side = columns.OPPOSITE[side]
    end
    if side ~= 0 and side == foot and b.oneWay[j] then
      b.dropping[p] = true
      any = true
    end
    half = b.next[half]
  end
  return any
end

interpreted.functions(oneway.lets, oneway.drop)

return oneway
