---@diagnostic disable
--- Impacts: computes the paths of two bodies after they meet inside a step. The rounds call
-- `impact.run`, in the order of time. Two that stay together (`stick`) are a contact from then on.
--
-- Both paths are advanced to the impact. The closing speed and the time left there are computed
-- backwards from their ends. That is exact for constant acceleration. The two bounce, or go on
-- flush with a common velocity and are a contact for the rest of the step.
--
-- The impact also has friction along the other axis (`rub`): on ground that of `bear`, between two
-- that both give way that of `rubBoth`. Friction of contacts that exist when the step begins is
-- computed in friction.lua.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local carriers = require(root .. ".motion.carriers")
local flow = require(root .. ".solver.flow")
local friction = require(root .. ".memory.lazy")(root .. ".solver.friction")
local path = require(root .. ".motion.path")
local pool = require(root .. ".solver.pool")
local touch = require(root .. ".solver.touch")

local impact = {}

local HUGE = math.huge
local max, min, sqrt = math.max, math.min, math.sqrt

--- Notes the first impact of a pair in the step: on which side, at u px/s, and where, at moment t.
function impact.note(b, p, low, axis, u, t)
  if b.hit[p] ~= 0 then
    return
  end
  local i, j, side = b.pairA[p], b.pairB[p], 2 * axis + 2
  b.hit[p], b.hitSpeed[p] = i == low and side or side - 1, u
  b.hitAt[p], b.hitLow[p], b.hitHigh[p] = touch.line(b, low, i == low and j or i, side, t)
end

-- Returns the closing speed of two bodies at their impact, px/s, and the time left after it, s.
-- They follow from what would be at the end of the step, which is at most `left` s away:
--
-- - the overlap o, px;
-- - the closing speed v, px/s;
-- - the closing acceleration a, px/s².
local function approach(o, v, a, left)
  local square = v * v - 2 * a * o
  local u = square > 0 and sqrt(square) or 0.0
  if v <= 0 and a >= 0 then
    u = 0.0
  end
  local tau = v + u > 0 and 2 * o / (v + u) or 0.0
  return u, max(min(tau, left), 0.0)
end

-- Returns the inverse masses of the low and the high body for this impact; 0 for a body that does
-- not give way. A body that is held, but is leaving its holder, does give way. One that is not
-- pushable and does not move towards the other one does not, even if that is held.
local function weigh(b, i, j, kl, kh)
  local wl, wh, vl, vh = b.give[kl], b.give[kh], b.speed[kl], b.speed[kh]
  local one, other, canPush = b.power[i], b.power[j], min(wl, wh) > 0
  local stayLow, stayHigh =
    canPush and one == HUGE and vl <= 0, canPush and other == HUGE and vh >= 0
  wl, wh = stayLow and 0 or pool.giveOf(b, kl, -1), stayHigh and 0 or pool.giveOf(b, kh, 1)
  if wl == 0 or wh == 0 then
    return wl, wh
  elseif one ~= other and max(one, other) < HUGE then
    return pool.share(one > other, wl, wh, vl, vh)
  end
  stayLow, stayHigh = pool.weigh(one, other, vl, vh)
  return stayLow and 0 or wl, stayHigh and 0 or wh
end

-- Computes the rest of the path of body k after an impact from its own forces, its friction and its
-- limits along this axis. `tau` is the time left, s.
local function reflow(b, k, tau, dt)
  local isFree = b.grip[k] == 0 and b.least[k] == -HUGE and b.most[k] == HUGE
  local last = b.speed[k]
  local v = last - b.accel[k] * tau
  local leavesHolder = b.heldHigh[k] > 0 and v < b.speed[b.holderHigh[k]]
    or b.heldLow[k] > 0 and v > b.speed[b.holderLow[k]]
  if b.give[k] == 0 or (isFree and not leavesHolder) then
    return
  end
  local new, way = flow.body(b, k, v, tau, dt)
  b.speed[k], b.to[k] = new, b.to[k] + way - (v + last) * 0.5 * tau
  b.accel[k] = tau > 0 and (new - v) / tau or 0.0
end

-- Lets body k rub on its ground: at once with the impulse `jolt` of the impact, then with `press`
-- until the end of the step.
local function bear(b, k, jolt, press, tau, dt)
  local slip = b.speed[k] - b.accel[k] * tau - b.base[k]
  local loss = b.rough[k] * jolt * b.give[k]
  local change = slip > 0 and -min(loss, slip) or min(loss, -slip)
  path.add(b, k, change * tau, change)
  b.grip[k] = tau > 0 and b.grip[k] + b.rough[k] * press / tau or b.grip[k]
  reflow(b, k, tau, dt)
end

-- Lets two bodies that both give way rub on each other: at once with the impulse `jolt`, then with
-- `press` for the last tau s.
local function rubBoth(b, kl, kh, mu, jolt, press, tau)
  local il, ih, accel = b.give[kl], b.give[kh], b.accel[kl] - b.accel[kh]
  local total, last = il + ih, b.speed[kl] - b.speed[kh]
  local v = last - accel * tau
  local loss = mu * jolt * total
  local after = v > loss and v - loss or v < -loss and v + loss or 0.0
  local brake = tau > 0 and mu * press * total / tau or 0.0
  local new, way = flow.run(0.0, brake, 1, accel, after, tau, -HUGE, HUGE)
  local dv, d = (new - last) / total, (way - (v + last) * 0.5 * tau) / total
  path.add(b, kl, d * il, dv * il)
  path.add(b, kh, -d * ih, -dv * ih)
  if tau > 0 then
    local change = (new - after - (last - v)) / tau / total
    b.accel[kl], b.accel[kh] = b.accel[kl] + change * il, b.accel[kh] - change * ih
  end
end

-- Lets the bodies of an impact rub along the other axis. The impulse `jolt` acts at once, then
-- `press` until the end of the step; both are along the normal.
local function rub(b, i, j, axis, jolt, press, tau, dt)
  local mu = friction.coefficient(b, i, j)
  if mu <= 0 then
    return
  end
  local kl, kh = 2 * i + 1 - axis, 2 * j + 1 - axis
  local il, ih = b.give[kl], b.give[kh]
  if il > 0 and ih > 0 then
    rubBoth(b, kl, kh, mu, jolt, press, tau)
  elseif il + ih > 0 then
    local k = il > 0 and kl or kh
    local base = il > 0 and carriers.surface(b, i, j, axis) or carriers.surface(b, j, i, axis)
    b.base[k], b.grip[k], b.rough[k] = base, 0.0, mu
    bear(b, k, jolt, press, tau, dt)
  end
end

-- Sets the places and speeds of two bodies after an impact without a bounce: flush, with a common
-- velocity. Where none of them stays, both give way, or with `push = "first"` the one that ran into
-- the other.
local function stick(b, i, j, kl, kh, wl, wh, separation, o, v)
  local to, speed, accel, total = b.to, b.speed, b.accel, wl + wh
  local isHighFirst, share = wh == 0, wl / total
  if b.pushFirst and wl > 0 and wh > 0 then
    local towards, against = to[kl] - b.from[kl], b.from[kh] - to[kh]
    isHighFirst = towards > against or (towards == against and b.rank[i] < b.rank[j])
    share = 0
  end
  if isHighFirst then
    to[kl] = to[kh] - separation
  else
    to[kl] = to[kl] - o * share
    to[kh] = to[kl] + separation
  end
  if wl == 0 then
    pool.lean(b, kh, kl, 1)
  elseif wh == 0 then
    pool.lean(b, kl, kh, -1)
  end
  if v > 0 and wh == 0 then
    speed[kl], accel[kl] = speed[kh], accel[kh]
  elseif v > 0 then
    speed[kl] = speed[kl] - v * wl / total
    accel[kl] = wl == 0 and accel[kl] or (accel[kl] * wh + accel[kh] * wl) / total
    speed[kh], accel[kh] = speed[kl], accel[kl]
  end
end

-- Sets them after a bounce: at the end of the step the two are `gap` px apart and close at `vEnd`.
local function bounce(b, kl, kh, wl, wh, o, gap, v, vEnd)
  local way, dv = (o + gap) / (wl + wh), (v - vEnd) / (wl + wh)
  path.add(b, kl, -way * wl, -dv * wl)
  path.add(b, kh, way * wh, dv * wh)
end

-- Returns how two bodies meet on an axis: their minimum distance, px; how far they would overlap at
-- the end of the step, px; their closing velocity and acceleration there; and the lean of a touch.
---@return number, number, number, number, number?
local function closing(b, i, j, axis, isDeep)
  local kl, kh, ti, tj = 2 * i + axis, 2 * j + axis, 2 * i + 1 - axis, 2 * j + 1 - axis
  local separation, lean = b.size[kl], 0.0
  if isDeep and (b.deepAt[i] == b.solveStamp or b.deepAt[j] == b.solveStamp) then
    separation = min(separation, b.from[kh] - b.from[kl])
  end
  local v, a = b.speed[kl] - b.speed[kh], b.accel[kl] - b.accel[kh]
  if b.hasShapes then
    local apart
    apart, lean = touch.lean(b, i, j, axis)
    separation = apart or separation
    v = v + lean * (b.speed[tj] - b.speed[ti])
    a = a + lean * (b.accel[tj] - b.accel[ti])
  end
  return separation, b.to[kl] + separation - b.to[kh], v, a, lean
end

--- Notes the hit of a sensor that a body enters or passes through.
function impact.sense(b, p, i, j, axis, t, dt)
  local _, o, v, a = closing(b, i, j, axis, false)
  local u = approach(o, v, a, (1 - t) * dt)
  if b.hasRound and ball.isRound(b, i, j) then
    u = ball.approach(b, i, j, t, dt)
  end
  impact.note(b, p, i, axis, u, t)
end

-- Lets two bodies that close on an axis bounce or go on flush, with the friction of that. `r`:
-- their restitution; o, v, a: as `closing` returns them; u and tau: as `approach` does. Returns
-- whether they stay together.
local function collide(b, i, j, axis, wl, wh, separation, r, o, u, v, a, tau, dt, isLate)
  local kl, kh, total = 2 * i + axis, 2 * j + axis, wl + wh
  local gap, vEnd = 0.0, 0.0
  local isBelow = not isLate and a < 0 and (b.give[kl] == 0 or b.give[kh] == 0)
  if r > 0 or isBelow then -- below a ceiling
    gap, vEnd = r * u * tau - a * tau * tau * 0.5, a * tau - r * u
  end
  local leaves = gap > 0 and vEnd < 0
  local jolt = (1 + r) * u / total
  if leaves then
    bounce(b, kl, kh, wl, wh, o, gap, v, vEnd)
  else
    stick(b, i, j, kl, kh, wl, wh, separation, o, v)
    jolt = min(max(v, 0.0), u) / total
  end
  reflow(b, kl, tau, dt)
  reflow(b, kh, tau, dt)
  if b.hasFriction and v > 0 then
    local press = leaves and 0.0 or max(v / total - jolt, 0.0)
    rub(b, i, j, axis, jolt, press, tau, dt)
  end
  return not leaves
end

--- Resolves the impact of two bodies on an axis at moment t. Two that overlap already (`isDeep`)
--- separate, or if they had no room get no deeper. `isLate`: nothing bounces any more.
---
--- Returns:
--- - whether they stay together;
--- - the minimum distance between their low edges, px;
--- - whether they move apart by themselves and only must not overlap. (Of two that meet slanted:
---   whether they stay together. The first is false then.)
function impact.run(b, p, i, j, axis, t, dt, isLate, isDeep)
  local left = (1 - max(b.time[i], b.time[j])) * dt
  path.advance(b, i, t)
  path.advance(b, j, t)
  b.impactsOf[i], b.impactsOf[j] = b.impactsOf[i] + 1, b.impactsOf[j] + 1
  b.resolved = b.resolved + 1
  if b.hasRound and ball.isRound(b, i, j) then
    local r, tau = max(b.restitution[i], b.restitution[j]), min((1 - t) * dt, left)
    local u, stays = ball.impact(b, i, j, isDeep, tau, dt, isLate, r)
    if u then
      impact.note(b, p, i, axis, u, t)
      return false, b.from[2 * j + axis] - b.from[2 * i + axis], stays
    end
  end
  local kl, kh = 2 * i + axis, 2 * j + axis
  local separation, o, v, a, lean = closing(b, i, j, axis, isDeep)
  local u, tau = approach(o, v, a, left)
  if u > 0 or b.pressed[p] ~= 1 then -- else it is noted with the speed that it began with
    impact.note(b, p, i, axis, u, t)
  end
  -- It bounces if it closes faster than its acceleration alone would make it in two steps.
  local bounces = not isLate and pool.bounces(u, a, 2 * dt)
  local r = bounces and max(b.restitution[i], b.restitution[j]) or 0
  local wl, wh = weigh(b, i, j, kl, kh)
  local total = wl + wh
  if total == 0 then
    b.isJammed = true
    return true, separation
  end
  if lean ~= 0 and touch.deflect(b, i, j, axis, lean, r, isLate, o, v, a, u, tau) then
    return false, separation
  end
  local isElastic = not isLate and (b.restitution[i] > 0 or b.restitution[j] > 0)
  if v < 0 then
    -- They move apart by themselves, and overlap only by what others have pushed.
    path.add(b, kl, -o * wl / total, 0.0)
    path.add(b, kh, o * wh / total, 0.0)
    return not isElastic, separation, isElastic
  end
  return collide(b, i, j, axis, wl, wh, separation, r, o, u, v, a, tau, dt, isLate), separation
end

return impact
