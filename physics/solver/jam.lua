--- Jams: what lies in a heap of balls and does not get on comes to rest.
--
-- What presses each other slanted is never solved to the last bit (see heap): it would creep for
-- ever. So a body that has met something slanted for PATIENCE s, and is still in its place, is
-- *stuck*, as in a knot: it stands like a wall, and the heap can sleep.
--
-- A jam begins anew, like a stuck knot (see knots), and when something strikes or presses it that
-- is faster than what lies still in a heap.
--
-- Reads deflectedAt, from, velocity, pull; writes stuck, jam, jamWay, to, speed and news.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")

require(root .. ".memory.jit").file()

local jam = {}

local DYNAMIC, STATIC, EPSILON = columns.DYNAMIC, columns.STATIC, columns.EPSILON
local CIRCLE = columns.SHAPE_CIRCLE
local gapOf = columns.gap
local max, sqrt = math.max, math.sqrt
-- s for which a body meets something slanted and does not move, before it is stuck.
local PATIENCE = 0.25
-- px: what has met something in the step lies on it if the gap is no larger. (A heap is not moved
-- apart to the last bit.)
local CLOSE = 0.01
-- Share of the way that its weight takes it in that time: what is as near its place has not moved.
local STILL = 1 / 32
-- Number of steps of gravity that make something as fast as what frees a jam when it presses it,
-- and when it strikes it.
local PRESSING, STRIKING = 2, 8

-- Returns how fast its weight makes slot i in a step, px/s.
local function fallOf(b, i)
  local x, y = b.pull[2 * i], b.pull[2 * i + 1]
  return max(x, -x, y, -y) * b.dt
end

-- Returns whether slot i has met something in this step, and is near the place where it waits.
local function isCaught(b, i)
  local k, m, pull, way = 2 * i, 2 * i + 1, b.pull, b.jamWay
  local fall = max(pull[k], -pull[k], pull[m], -pull[m]) * PATIENCE * PATIENCE * 0.5
  local x, y = way[k] + b.to[k] - b.origin[k], way[m] + b.to[m] - b.origin[m]
  return b.deflectedAt[i] == b.solveStamp and max(x, -x, y, -y) < STILL * fall
end

--- Lets slot i have waited for no time.
function jam.forget(b, i)
  local k, m = 2 * i, 2 * i + 1
  b.jam[k], b.jamWay[k], b.jamWay[m] = 0, 0, 0
end

-- Adds this step to the time that slot i has waited, if it is caught. Returns that time, s.
local function wait(b, i)
  local k, m = 2 * i, 2 * i + 1
  if not isCaught(b, i) then
    jam.forget(b, i)
    return 0
  end
  b.jam[k] = b.jam[k] + b.dt
  b.jamWay[k] = b.jamWay[k] + b.to[k] - b.origin[k]
  b.jamWay[m] = b.jamWay[m] + b.to[m] - b.origin[m]
  return b.jam[k]
end

-- Returns whether j, which is immovable and touches slot i, lies below the middle of that.
local function bears(b, i, j)
  local axis = b.down[2 * i] ~= 0 and 0 or 1
  local k, m = 2 * i + axis, 2 * j + axis
  local middle = b.to[k] + b.size[k] * 0.5
  if b.down[k] > 0 then
    return b.to[m] > middle or b.shape[j] > CIRCLE
  end
  return b.to[m] + b.size[m] < middle or b.shape[j] > CIRCLE
end

-- Returns whether something immovable bears slot i, directly or through others.
local function isGrounded(b, i)
  local stack, count = b.stack, 1
  b.stamp = b.stamp + 1
  stack[1], b.visited[i] = i, b.stamp
  while count > 0 do
    i, count = stack[count], count - 1
    local half = b.head[i]
    while half ~= 0 do
      local j = b.other[half]
      if not b.sensor[j] and b.visited[j] ~= b.stamp and gapOf(b, b.to, i, j) <= CLOSE then
        if b.kind[j] == DYNAMIC then
          count = count + 1
          stack[count], b.visited[j] = j, b.stamp
        elseif bears(b, i, j) then
          return true
        end
      end
      half = b.next[half]
    end
  end
  return false
end

--- Counts at the end of a step for how long bodies have been caught, and lets them be stuck.
function jam.note(b)
  local list, count = b.knotList, 0
  for n = 1, b.hasCircles and b.awakeCount or 0 do
    local i = b.awakeList[n]
    if b.kind[i] == DYNAMIC and not b.stuck[i] then
      local waited = wait(b, i)
      b.news[i] = b.news[i] or waited > 0
      if waited >= PATIENCE and isGrounded(b, i) then
        count = count + 1
        list[count] = i
      elseif waited >= PATIENCE then
        jam.forget(b, i)
      end
    end
  end
  -- They are put back when all have been asked what they touch: the list has no order.
  for n = 1, count do
    local k, m = 2 * list[n], 2 * list[n] + 1
    b.stuck[list[n]], b.hasKnots, b.knotWas[m] = true, true, 0
    b.to[k], b.to[m], b.speed[k], b.speed[m] = b.origin[k], b.origin[m], 0.0, 0.0
  end
end

-- Returns whether slot i touches j where the step begins.
local function touches(b, i, j)
  local gap = ball.isRound(b, i, j) and ball.gapIn(b, b.from, i, j) or gapOf(b, b.from, i, j)
  return gap <= EPSILON and not b.sensor[j]
end

-- Returns whether body j goes, or is pulled by itself, towards slot i that it touches.
local function presses(b, i, j)
  local position, size, k, m = b.position, b.size, 2 * i, 2 * j
  local x = position[k] - position[m] + (size[k] - size[m]) * 0.5
  local y = position[k + 1] - position[m + 1] + (size[k + 1] - size[m + 1]) * 0.5
  local speed = b.velocity[m] * x + b.velocity[m + 1] * y
  local length = max(sqrt(x * x + y * y), EPSILON)
  return speed > PRESSING * fallOf(b, i) * length or b.push[m] * x + b.push[m + 1] * y > 0
end

--- Returns whether something that is not stuck presses slot i, which is, where the step begins.
function jam.isPressed(b, i)
  local half = b.jam[2 * i] > 0 and b.head[i] or 0
  while half ~= 0 do
    local j = b.other[half]
    local isFree = b.awake[j] and b.kind[j] == DYNAMIC and not b.stuck[j]
    if isFree and touches(b, i, j) and presses(b, i, j) then
      return true
    end
    half = b.next[half]
  end
  return false
end

--- Returns the one of two that is in a jam, if the other one strikes it at moment t of the step, or
--- nil.
function jam.struck(b, i, j, axis, t, dt)
  local one, other = i, j
  if b.jam[2 * i] == 0 or not b.stuck[i] then
    one, other = j, i
  end
  if b.jam[2 * one] == 0 or not b.stuck[one] or b.stuck[other] or b.kind[other] == STATIC then
    return nil
  end
  local speed
  if ball.isRound(b, i, j) then
    speed = ball.approach(b, i, j, t, dt)
  else
    local kl, kh, left = 2 * i + axis, 2 * j + axis, (1 - t) * dt
    speed = b.speed[kl] - b.speed[kh] - (b.accel[kl] - b.accel[kh]) * left
  end
  return speed > STRIKING * fallOf(b, one) and one or nil
end

return jam
