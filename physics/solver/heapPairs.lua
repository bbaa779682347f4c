--- Heap pairs: decides which pairs with a ball are left to the heap (see heap) and lists them.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local rules = require(root .. ".solver.rules")

require(root .. ".memory.jit").file()

local heapPairs = {}

local CIRCLE, DYNAMIC, EPSILON = columns.SHAPE_CIRCLE, columns.DYNAMIC, columns.EPSILON
local max = math.max
--- Value of `touches` of these pairs (see contacts).
heapPairs.HEAP = 4
-- Maximum number of impacts of a body in a step before others are left to the heap: of two that do
-- not bounce, and of two of which one does.
local MOST, MOST_BOUNCES = 4, 13
--- Number of steps of gravity that make something as fast as what rests.
heapPairs.SLOW = 2
local SLOW = heapPairs.SLOW

--- Returns whether two can move, and one of them is a ball.
function heapPairs.areLoose(b, i, j)
  local kind = b.kind
  return max(b.shape[i], b.shape[j]) == CIRCLE
    and kind[i] == DYNAMIC
    and kind[j] == DYNAMIC
    and not (b.sensor[i] or b.sensor[j])
end

-- Returns the speed of body k where the step begins, px/s; 0.0 if it sleeps.
local function startOf(b, i, k)
  return b.awake[i] and b.start[k] or 0.0
end

-- Returns how fast its weight makes the faster one of two in a step, px/s.
local function fallOf(b, i, j)
  local pull, k, m = b.pull, 2 * i, 2 * j
  local x = max(pull[k], -pull[k], pull[m], -pull[m])
  return max(x, pull[k + 1], -pull[k + 1], pull[m + 1], -pull[m + 1]) * b.dt
end

--- Returns whether two that are near each other where the step begins are left to the heap.
--- They rest on each other slanted, or overlap a little. (Elastic ones rest if one of them has not
--- moved in the last step, see jam.)
function heapPairs.rest(b, p, i, j)
  if not heapPairs.areLoose(b, i, j) then
    return false
  end
  local gap, nx, ny = ball.gapIn(b, b.from, i, j)
  if gap > EPSILON or ball.isLost(b, i, j) then
    return false
  elseif gap >= -EPSILON and not ball.isSteep(nx, ny) then
    return false
  elseif gap >= -EPSILON and not (b.stuck[i] and b.stuck[j]) then
    local x = startOf(b, i, 2 * i) - startOf(b, j, 2 * j)
    local y = startOf(b, i, 2 * i + 1) - startOf(b, j, 2 * j + 1)
    local speed, isElastic = x * nx + y * ny, max(b.restitution[i], b.restitution[j]) > 0
    local isMoving = b.jam[2 * i] == 0 and b.jam[2 * j] == 0
    if max(speed, -speed) > SLOW * fallOf(b, i, j) or (isElastic and isMoving) then
      return false
    end
  end
  local axis = nx * nx > ny * ny and 0 or 1
  local isLow = (axis == 0 and nx or ny) < 0
  local low, high = isLow and i or j, isLow and j or i
  return not rules.passes(b, p, 2 * low + axis, 2 * high + axis, axis, false)
end

--- Returns whether the impact of two is left to the heap: they have met others often in this step,
--- or nothing may bounce any more (`isLate`).
function heapPairs.isLeft(b, i, j, isLate)
  if not heapPairs.areLoose(b, i, j) then
    return false
  end
  local most = max(b.restitution[i], b.restitution[j]) > 0 and MOST_BOUNCES or MOST
  return isLate or max(b.impactsOf[i], b.impactsOf[j]) >= most
end

--- Leaves pair p to the heap.
function heapPairs.leave(b, p)
  b.touches[p], b.heapCount = heapPairs.HEAP, b.heapCount + 1
  b.heapPairs[b.heapCount] = p
end

return heapPairs
