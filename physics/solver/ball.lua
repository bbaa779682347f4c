--- Circles in a step: when a path meets one, how fast, and whether two overlap.
--
-- A circle fills its square, which the broad phase and all axis contacts see. What is asked here is
-- asked of pairs with a circle, where their squares meet.
--
-- Where the normal is along an axis (a ball on a face) the contact is one of boxes. Where it is
-- slanted (a corner, two balls) it is an impact, along the true normal:
--   it bounces, if it is fast enough and the pair is elastic;
--   it sticks, if it is slow and the slant is too small to be seen, and in the last rounds: the two
--     go on with their common velocity, and are a contact of the steeper axis, at the distance they
--     have;
--   else it slides: without friction, along the tangent, which leads into nothing convex.
-- A slanted contact that rests is a contact of its steeper axis and is swept, too. Balls that press
-- each other are left to the heap (see heapPairs).
--
-- Source: the round box (see circle): the centre of a circle meets what it would touch, grown by
-- its radius with rounded corners.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local circle = require(root .. ".memory.circle")
local columns = require(root .. ".memory.columns")
local path = require(root .. ".motion.path")
local pool = require(root .. ".solver.pool")

require(root .. ".memory.jit").file()

local ball = {}

local CIRCLE, EPSILON, DYNAMIC = columns.SHAPE_CIRCLE, columns.EPSILON, columns.DYNAMIC
local max, min, sqrt = math.max, math.min, math.sqrt
-- Share of the smaller size by which two may overlap and part along their normal.
local LOST = 0.25
-- Fraction of the step by which a slanted contact is met later than a face.
local CORNER = 2e-9
-- px by which a path may lead into another: less than EPSILON, at which two overlap.
local SLACK = EPSILON / 2
-- What a normal may have across an axis and still count as along it.
local SLIGHT = 0.05
-- px: what is as little differs by rounding.
local ROUNDING = 1e-9
-- px/s: what is as slow rests.
local STILL = 1e-9

--- Returns whether one of two is a circle. On a slope a circle is its box (see slope).
function ball.isRound(b, i, j)
  return max(b.shape[i], b.shape[j]) == CIRCLE
end

-- The place of i at moment t, and that of j, one after the other.
local function places(b, i, j, t)
  local k, m, startI, startJ = 2 * i, 2 * j, b.time[i], b.time[j]
  return path.at(b, k, startI, t),
    path.at(b, k + 1, startI, t),
    path.at(b, m, startJ, t),
    path.at(b, m + 1, startJ, t)
end

-- How far i is from j, and the normal from j to i, at the places in column `place`. It is asked in
-- the order of the world, since which of a pair is the first depends on the broad phase.
local function gapIn(b, place, i, j)
  local isSwapped = b.rank[j] < b.rank[i]
  if isSwapped then
    local first = j
    j = i
    i = first
  end
  local size, shape, k, m = b.size, b.shape, 2 * i, 2 * j
  local gap, nx, ny = circle.gap(
    place[k],
    place[k + 1],
    size[k],
    size[k + 1],
    shape[i] == CIRCLE,
    place[m],
    place[m + 1],
    size[m],
    size[m + 1],
    shape[j] == CIRCLE
  )
  return gap, isSwapped and -nx or nx, isSwapped and -ny or ny
end

ball.gapIn = gapIn

--- Returns when two bodies meet (0..1 of the step), on which axis, and whether the first is the low
--- one: as `meet` of sweep. The axis is that along which the normal is steeper.
function ball.meet(b, i, j)
  local isSwapped = b.rank[j] < b.rank[i] -- see gapIn
  if isSwapped then
    local first = j
    j = i
    i = first
  end
  local size, to, shape, k, m = b.size, b.to, b.shape, 2 * i, 2 * j
  local start = max(b.time[i], b.time[j])
  local x, y, ox, oy = places(b, i, j, start)
  local isRound, isOtherRound = shape[i] == CIRCLE, shape[j] == CIRCLE
  local w, h, ow, oh = size[k], size[k + 1], size[m], size[m + 1]
  local gap, nx, ny = circle.gap(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound)
  local share, isDeep = 0.0, gap < -EPSILON
  if isDeep and (gapIn(b, to, i, j) >= min(gap, -EPSILON) - ROUNDING) then
    return nil -- it comes out, or gets no deeper
  elseif not isDeep then
    local dx, dy = to[k] - x - (to[m] - ox), to[k + 1] - y - (to[m + 1] - oy)
    share, nx, ny =
      circle.meetPair(x, y, w, h, isRound, dx, dy, ox, oy, ow, oh, isOtherRound, SLACK)
    if not share then
      return nil
    end
  end
  local isLevel, isSlanted = nx * nx > ny * ny, nx ~= 0 and ny ~= 0
  local t = start + (1 - start) * share + (isSlanted and not isDeep and CORNER or 0)
  local isLow = (isLevel and nx or ny) < 0
  return t, isLevel and 0 or 1, isLow ~= isSwapped, isDeep
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

--- Returns whether two are so deep in each other, or so straight, that they leave as boxes do. All
--- others go apart along their contact, at its pace (see contacts).
function ball.isLost(b, i, j)
  local gap, nx, ny = gapIn(b, b.from, i, j)
  if nx == 0 or ny == 0 then
    return gap < -EPSILON
  end
  return gap < -LOST * min(b.size[2 * i], b.size[2 * j])
end

-- Whether gravity presses slot i towards its high side on an axis, or else towards its low one.
local function leans(b, i, axis, isHigh)
  return b.kind[i] == DYNAMIC and b.down[2 * i + axis] == (isHigh and 1 or -1)
end

--- Returns whether a ball rolls off what it touches with the normal (nx, ny): the slant is large
--- enough to be seen.
function ball.isSteep(nx, ny)
  return min(nx * nx, ny * ny) > SLIGHT * SLIGHT
end

-- px/s: what gravity makes of a body in two steps, if it presses that against what it touches.
local function stickOf(b, i, axis, isHigh, dt)
  if not leans(b, i, axis, isHigh) then
    return 0.0
  end
  local pull = b.flowPull[2 * i + axis] + b.push[2 * i + axis]
  return 2 * dt * max(pull, -pull)
end

-- px/s: slower than that, what one bears sticks to it; 0: neither bears the other. (Each of two may
-- have a gravity of its own.)
local function stickSpeed(b, i, j, axis, isLow, dt)
  return max(stickOf(b, i, axis, isLow, dt), stickOf(b, j, axis, not isLow, dt))
end

-- Whether two that touch rest on each other where the step begins: they are as slow as what bears
-- one of them takes off in two steps, or do not move.
local function rests(b, i, j, axis, isLow)
  local square, slow = 0.0, max(stickSpeed(b, i, j, axis, isLow, b.dt), STILL)
  for along = 0, 1 do
    local v = (b.awake[i] and b.start[2 * i + along] or 0.0)
      - (b.awake[j] and b.start[2 * j + along] or 0.0)
    square = square + v * v
  end
  return square <= slow * slow
end

--- Returns how two touch where the step begins: the axis, whether the first is the low one, and
--- whether the contact is slanted; nil, and whether they overlap: they do not touch, or are left to
--- the sweep.
function ball.touch(b, i, j)
  local gap, nx, ny = gapIn(b, b.from, i, j)
  if gap > EPSILON then
    return nil, false
  elseif gap < -EPSILON then
    return nil, true
  end
  local isSlanted, isLevel = nx ~= 0 and ny ~= 0, nx * nx > ny * ny
  local axis, isLow = isLevel and 0 or 1, (isLevel and nx or ny) < 0
  if isSlanted and (ball.isSteep(nx, ny) or not rests(b, i, j, axis, isLow)) then
    return nil, false
  end
  return axis, isLow, isSlanted
end

--- Returns the axis along which two that overlap part, and whether the second is the low one.
function ball.deepAxis(b, i, j)
  local _, nx, ny = gapIn(b, b.from, i, j)
  if nx == 0 and ny == 0 then
    return nil
  end
  local isLevel = nx * nx > ny * ny
  return isLevel and 0 or 1, (isLevel and nx or ny) > 0
end

--- Returns how far the low edges of two must be apart on an axis, so that they do not overlap where
--- they are on the other one.
function ball.separation(b, low, high, axis)
  local from, size, shape = b.from, b.size, b.shape
  local kl, kh, cl, ch = 2 * low + axis, 2 * high + axis, 2 * low + 1 - axis, 2 * high + 1 - axis
  local rl = shape[low] == CIRCLE and size[kl] * 0.5 or 0.0
  local rh = shape[high] == CIRCLE and size[kh] * 0.5 or 0.0
  -- Across, how far apart the cores are; along, both radii reach as far as that leaves.
  local before = from[ch] + rh - from[cl] - size[cl] + rl
  local across = max(before, from[cl] + rl - from[ch] - size[ch] + rh, 0.0)
  local reach = sqrt(max((rl + rh) * (rl + rh) - across * across, 0.0))
  return size[kl] - rl - rh + reach
end

-- Returns the side (left, right, top, bottom: 1 to 4) of i at which a normal from j to i is.
local function sideOf(nx, ny)
  if nx * nx > ny * ny then
    return nx > 0 and 1 or 2
  end
  return ny > 0 and 3 or 4
end

--- Returns the side of the first at which two touch at the end of the step, 0: none, -1: they
--- overlap.
function ball.side(b, i, j)
  local gap, nx, ny = gapIn(b, b.to, i, j)
  if gap > EPSILON then
    return 0
  end
  return gap < -EPSILON and -1 or sideOf(nx, ny)
end

-- The point where two touch, if i is at (x, y) and j at (ox, oy).
local function pointAt(b, i, j, x, y, ox, oy)
  if b.shape[i] ~= CIRCLE then
    local px, py = x, y
    x, y, ox, oy = ox, oy, px, py
    local first = j
    j = i
    i = first
  end
  local size, k, m = b.size, 2 * i, 2 * j
  local w, h, r = size[k], size[k + 1], size[k] * 0.5
  local _, nx, ny = circle.gap(x, y, w, h, true, ox, oy, size[m], size[m + 1], b.shape[j] == CIRCLE)
  return x + r - nx * r, y + r - ny * r
end

--- Returns the point where two touch: at moment t of the step, or without t at its end.
function ball.point(b, i, j, t)
  if b.rank[j] < b.rank[i] then
    local first = j
    j = i
    i = first
  end
  local to, k, m = b.to, 2 * i, 2 * j
  local x, y, ox, oy = to[k], to[k + 1], to[m], to[m + 1]
  if t then
    x, y, ox, oy = places(b, i, j, t)
  end
  return pointAt(b, i, j, x, y, ox, oy)
end

-- Impacts -----------------------------------------------------------------------------------------

-- The velocity of body k at the place where its path begins now, tau s before its end. That place
-- is on a straight line beside the curve of its flight: it has the velocity by which it has lost no
-- energy on its way. (If others have pushed the end of its path, that is not known.)
local function speedAt(b, k, tau)
  local v, a = b.speed[k], b.accel[k]
  local now, way = v - a * tau, b.to[k] - b.from[k]
  local off, most = way - (v + now) * 0.5 * tau, max(a, -a) * b.dt * b.dt * 0.126
  if a == 0 or off > most or off < -most then
    return now
  end
  local size = sqrt(max(v * v - 2 * a * way, 0.0))
  return now < 0 and -size or size
end

-- Lets the path of body k be that from a velocity of v px/s, under an acceleration.
local function fly(b, k, v, a, tau)
  b.to[k] = b.from[k] + (v + a * tau * 0.5) * tau
  b.speed[k], b.accel[k] = v + a * tau, a
end

-- The inverse mass of body k towards the side of `sign`: 0 if something immovable holds it there,
-- which it is not leaving.
local function giveOf(b, k, sign)
  local give, speed = b.give[k], b.speed
  if sign < 0 and b.heldLow[k] > 0 and give > 0 then
    return speed[k] <= speed[b.holderLow[k]] and 0.0 or give
  elseif sign > 0 and b.heldHigh[k] > 0 and give > 0 then
    return speed[k] >= speed[b.holderHigh[k]] and 0.0 or give
  end
  return give
end

-- These of two of which one is stronger (see `pool.share`): both of a body by the same factor.
local function weighPower(b, i, j, nx, ny, ix, iy, jx, jy)
  local x, y, speed, k, m = nx * nx, ny * ny, b.speed, 2 * i, 2 * j
  local wi, wj = x * ix + y * iy, x * jx + y * jy
  if wi == 0 or wj == 0 then
    return ix, iy, jx, jy
  end
  local vi, vj = -nx * speed[k] - ny * speed[k + 1], -nx * speed[m] - ny * speed[m + 1]
  local newI, newJ = pool.share(b.power[i] > b.power[j], wi, wj, vi, vj)
  newI, newJ = newI / wi, newJ / wj
  return ix * newI, iy * newI, jx * newJ, jy * newJ
end

--- Returns the inverse masses of two that push each other along a normal, on both axes: of i, then
--- of j. The last four are those that each has by itself.
function ball.share(b, i, j, nx, ny, ix, iy, jx, jy)
  if b.give[2 * i] > 0 and b.give[2 * j] > 0 and b.pushable[i] ~= b.pushable[j] then
    if b.pushable[i] then
      return ix, iy, 0.0, 0.0
    end
    return 0.0, 0.0, jx, jy
  elseif b.power[i] ~= b.power[j] then
    return weighPower(b, i, j, nx, ny, ix, iy, jx, jy)
  end
  return ix, iy, jx, jy
end

-- The same for two that meet.
local function weigh(b, i, j, nx, ny)
  local ix, iy = giveOf(b, 2 * i, nx), giveOf(b, 2 * i + 1, ny)
  local jx, jy = giveOf(b, 2 * j, -nx), giveOf(b, 2 * j + 1, -ny)
  return ball.share(b, i, j, nx, ny, ix, iy, jx, jy)
end

-- Two go on with their common velocity and acceleration along an axis.
local function stick(b, k, m, wi, wj, tau)
  local total = wi + wj
  if total == 0 then
    return
  end
  local vi, vj, ai, aj = speedAt(b, k, tau), speedAt(b, m, tau), b.accel[k], b.accel[m]
  local v, a = vi + (vj - vi) * wi / total, ai + (aj - ai) * wi / total
  if wi > 0 then
    fly(b, k, wj > 0 and v or vj, wj > 0 and a or aj, tau)
  end
  if wj > 0 then
    fly(b, m, wi > 0 and v or vi, wi > 0 and a or ai, tau)
  end
end

-- Two get an impulse and a force along an axis.
local function push(b, k, m, wi, wj, impulse, force, tau)
  local vi, vj = speedAt(b, k, tau), speedAt(b, m, tau)
  if wi > 0 then
    fly(b, k, vi + impulse * wi, b.accel[k] + force * wi, tau)
  end
  if wj > 0 then
    fly(b, m, vj - impulse * wj, b.accel[m] - force * wj, tau)
  end
end

-- The closing speed and acceleration of two along the normal, and the square of their relative
-- speed.
local function closing(b, i, j, nx, ny, tau)
  local k, m = 2 * i, 2 * j
  local x = speedAt(b, k, tau) - speedAt(b, m, tau)
  local y = speedAt(b, k + 1, tau) - speedAt(b, m + 1, tau)
  local ax, ay = b.accel[k] - b.accel[m], b.accel[k + 1] - b.accel[m + 1]
  return -(x * nx + y * ny), -(ax * nx + ay * ny), x * x + y * y
end

--- Returns the normal of two from the second to the first, where their paths begin now; whether it
--- is slanted.
function ball.normal(b, i, j)
  local _, nx, ny = gapIn(b, b.from, i, j)
  return nx, ny, nx ~= 0 and ny ~= 0
end

--- Two bodies meet slanted, tau s before the end of the step, where their paths begin now. `axis`
--- and `isLow` as `meet` says. Returns their approach speed, and whether they stay together.
function ball.impact(b, i, j, axis, isLow, tau, dt, isLate, restitution)
  local _, nx, ny = gapIn(b, b.from, i, j)
  local u, a, square = closing(b, i, j, nx, ny, tau)
  local ix, iy, jx, jy = weigh(b, i, j, nx, ny)
  local total = nx * nx * (ix + jx) + ny * ny * (iy + jy)
  u = max(u, 0.0)
  b.deflectedAt[i], b.deflectedAt[j] = b.solveStamp, b.solveStamp
  b.news[i], b.news[j] = true, true -- no rest: how far it gets depends on how long a step is
  if total == 0 then
    b.isJammed = true
    return u, true
  end
  local r = (not isLate and u > 2 * dt * max(a, -a)) and restitution or 0
  local slow = stickSpeed(b, i, j, axis, isLow, dt)
  local isSlow = square <= slow * slow and not ball.isSteep(nx, ny)
  if r == 0 and (isLate or isSlow) then
    stick(b, 2 * i, 2 * j, ix, jx, tau)
    stick(b, 2 * i + 1, 2 * j + 1, iy, jy, tau)
    return u, true
  end
  local impulse, force = (1 + r) * u / total, r == 0 and max(a, 0.0) / total or 0.0
  push(b, 2 * i, 2 * j, ix, jx, impulse * nx, force * nx, tau)
  push(b, 2 * i + 1, 2 * j + 1, iy, jy, impulse * ny, force * ny, tau)
  return u, false
end

return ball
