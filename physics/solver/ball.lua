--- Circles in a step: when a path meets one, how fast, and whether two overlap.
--
-- A circle fills its square, which the broad phase and all axis contacts see. What is asked here is
-- asked of pairs with a circle, where their squares meet.
--
-- Source: the round box (see circle): the centre of a circle meets what it would touch, grown by
-- its radius with rounded corners.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local circle = require(root .. ".memory.circle")
local columns = require(root .. ".memory.columns")

require(root .. ".memory.jit").file()

local ball = {}

local CIRCLE, EPSILON = columns.SHAPE_CIRCLE, columns.EPSILON
local max = math.max

--- Returns whether one of two is a circle.
function ball.isRound(b, i, j)
  return b.shape[i] == CIRCLE or b.shape[j] == CIRCLE
end

--- Returns whether two overlap at the end of the step.
function ball.overlaps(b, i, j)
  local to, size, shape, k, m = b.to, b.size, b.shape, 2 * i, 2 * j
  return circle.overlap(
    to[k],
    to[k + 1],
    size[k],
    size[k + 1],
    shape[i] == CIRCLE,
    to[m],
    to[m + 1],
    size[m],
    size[m + 1],
    shape[j] == CIRCLE,
    EPSILON
  )
end

-- Where body k is at moment t, between its start and its end.
local function at(b, k, start, t)
  local from = b.from[k]
  if t <= start then
    return from
  end
  return from + (b.to[k] - from) * ((t - start) / (1 - start))
end

-- The place of i at moment t, and that of j, one after the other.
local function places(b, i, j, t)
  local k, m, startI, startJ = 2 * i, 2 * j, b.time[i], b.time[j]
  return at(b, k, startI, t), at(b, k + 1, startI, t), at(b, m, startJ, t), at(b, m + 1, startJ, t)
end

--- Returns when two bodies meet (0..1 of the step), on which axis, and whether the first is the low
--- one: as `meet` of sweep. The axis is that along which the normal is steeper.
function ball.meet(b, i, j)
  local size, to, shape, k, m = b.size, b.to, b.shape, 2 * i, 2 * j
  local start = max(b.time[i], b.time[j])
  local x, y, ox, oy = places(b, i, j, start)
  local isRound, isOtherRound = shape[i] == CIRCLE, shape[j] == CIRCLE
  local w, h, ow, oh = size[k], size[k + 1], size[m], size[m + 1]
  local gap, nx, ny = circle.gap(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound)
  local share, isDeep = 0.0, gap < -EPSILON
  if isDeep and not ball.overlaps(b, i, j) then
    return nil
  elseif not isDeep then
    local dx, dy = to[k] - x - (to[m] - ox), to[k + 1] - y - (to[m + 1] - oy)
    share, nx, ny =
      circle.meetPair(x, y, w, h, isRound, dx, dy, ox, oy, ow, oh, isOtherRound, EPSILON)
    if not share then
      return nil
    end
  end
  local isLevel = nx * nx > ny * ny
  return start + (1 - start) * share, isLevel and 0 or 1, (isLevel and nx or ny) < 0, isDeep
end

--- Returns how fast two close at moment t, px/s >= 0.
function ball.approach(b, i, j, t, dt)
  local size, shape, k, m = b.size, b.shape, 2 * i, 2 * j
  local x, y, ox, oy = places(b, i, j, t)
  local _, nx, ny = circle.gap(
    x,
    y,
    size[k],
    size[k + 1],
    shape[i] == CIRCLE,
    ox,
    oy,
    size[m],
    size[m + 1],
    shape[j] == CIRCLE
  )
  local left, speed, accel = (1 - t) * dt, b.speed, b.accel
  local u = speed[k] - speed[m] - (accel[k] - accel[m]) * left
  local v = speed[k + 1] - speed[m + 1] - (accel[k + 1] - accel[m + 1]) * left
  return max(-(u * nx + v * ny), 0.0)
end

return ball
