--- Impacts: two bodies that meet in the middle of a step.
--
-- Both go to the moment of the impact. What happens there is worked out from the end of their paths,
-- which is exact for constant acceleration: the overlap that they would have there, and how fast
-- they would close, tell how fast they meet and how much of the step is left. They bounce, or go on
-- flush with a common velocity, and are a contact for the rest of the step.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carrier = require(root .. ".objects.carriers")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")
local friction = require(root .. ".solver.friction")
local path = require(root .. ".motion.path")

local impact = {}

local DYNAMIC, SIDE = columns.DYNAMIC, columns.SIDE
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- Impacts of one body in a step after which it does not bounce any more, divided by 1 - restitution,
-- and the most there are.
local BOUNCES, MOST_BOUNCES = 4, 12

--- Notes the first impact of a pair in the step: on which side, and at u px/s.
function impact.note(b, p, low, axis, u)
  if b.hit[p] == 0 then
    b.hit[p] = b.pairA[p] == low and 2 * axis + 2 or 2 * axis + 1
    b.hitSpeed[p] = u
  end
end

-- How fast two meet, and how many seconds are left then: from the overlap o, the closing speed v and
-- the closing acceleration a at the end of the step, which is at most `left` s away.
local function approach(o, v, a, left)
  local square = v * v - 2 * a * o
  local u = square > 0 and sqrt(square) or 0.0
  if v <= 0 and a >= 0 then
    u = 0.0
  end
  local tau = v + u > 0 and 2 * o / (v + u) or 0.0
  return u, max(min(tau, left), 0.0)
end

impact.approach = approach

-- Shares of a push for two that can both give way, or one of them, or neither. What has left the body
-- that held it can.
local function weigh(b, i, j, kl, kh)
  local wl, wh = b.give[kl], b.give[kh]
  if b.heldLow[kl] > 0 and b.speed[kl] <= b.speed[b.holderLow[kl]] then
    wl = 0
  end
  if b.heldHigh[kh] > 0 and b.speed[kh] >= b.speed[b.holderHigh[kh]] then
    wh = 0
  end
  if wl > 0 and wh > 0 and not (b.pushable[i] and b.pushable[j]) then
    if b.pushable[i] then
      wh = 0
    elseif b.pushable[j] then
      wl = 0
    else
      local vl, vh = b.speed[kl], b.speed[kh]
      local stayLow, stayHigh = vl <= 0 or vh < 0, vh >= 0 or vl > 0
      if stayLow and stayHigh then
        b.to[kl], b.to[kh] = b.from[kl], b.from[kh]
        b.speed[kl], b.speed[kh], b.accel[kl], b.accel[kh] = 0.0, 0.0, 0.0, 0.0
      end
      wl, wh = stayLow and 0 or wl, stayHigh and 0 or wh
    end
  end
  return wl, wh
end

-- Whether a pair still bounces in this step: it closes faster than its acceleration makes it in two
-- steps, and neither has bounced too often.
local function restitution(b, i, j, u, a, dt)
  local r = max(b.restitution[i], b.restitution[j])
  if r == 0 or u <= 2 * max(a, -a) * dt then
    return 0
  end
  local limit = min(BOUNCES / max(1 - r, 1e-3), MOST_BOUNCES)
  if
    (b.impactsOf[i] > limit and b.kind[i] == DYNAMIC)
    or (b.impactsOf[j] > limit and b.kind[j] == DYNAMIC)
  then
    return 0
  end
  return r
end

-- Friction and engines act on body k along this axis for the rest of the step, from the speed that
-- it has after the impact.
local function reflow(b, k, tau)
  local kinks = b.kinks[k]
  if kinks == 0 or b.give[k] == 0 then
    return
  end
  local last = b.speed[k]
  local v = last - b.accel[k] * tau
  local new, way = flow.run(b, kinks, 1 / b.give[k], b.force[k], v, tau)
  b.speed[k], b.to[k] = new, b.to[k] + way - (v + last) * 0.5 * tau
  b.accel[k] = tau > 0 and (new - v) / tau or 0.0
end

-- The impact rubs along the other axis, at once; what the two press with then, until the end. `jolt`
-- and `press` are impulses along the normal.
local function rub(b, i, j, axis, wl, wh, jolt, press, tau)
  local mu = friction.coefficient(b, i, j)
  if mu <= 0 then
    return
  end
  local kl, kh = 2 * i + 1 - axis, 2 * j + 1 - axis
  local il, ih = b.give[kl], b.give[kh]
  if (il == 0 or wl == 0) and (ih == 0 or wh == 0) then
    il, ih = wl > 0 and il or 0, wh > 0 and ih or 0
  end
  local total = il + ih
  if total == 0 then
    return
  end
  local belt = carrier.beltSpeed(b, i, j, axis) - carrier.beltSpeed(b, j, i, axis)
  local accel = b.accel[kl] - b.accel[kh]
  local last = b.speed[kl] - b.speed[kh] - belt
  local v = last - accel * tau
  local loss = mu * jolt * total
  local after = v > loss and v - loss or v < -loss and v + loss or 0.0
  local brake = tau > 0 and mu * press * total / tau or 0.0
  local new, way = flow.slide(after, accel, 0.0, brake, tau)
  local dv, d = (new - last) / total, (way - (v + last) * 0.5 * tau) / total
  b.speed[kl], b.to[kl] = b.speed[kl] + dv * il, b.to[kl] + d * il
  b.speed[kh], b.to[kh] = b.speed[kh] - dv * ih, b.to[kh] - d * ih
  if tau > 0 then
    b.accel[kl] = b.accel[kl] + (new - after - (last - v)) / tau * il / total
    b.accel[kh] = b.accel[kh] - (new - after - (last - v)) / tau * ih / total
  end
end

-- Places and speeds of two after an impact without a bounce: flush, with a common velocity.
local function stick(b, i, j, kl, kh, wl, wh, o, v)
  local to, speed, accel, size = b.to, b.speed, b.accel, b.size
  local total = wl + wh
  if wl == 0 then
    to[kh] = to[kl] + size[kl]
    if b.heldLow[kl] > 0 then
      b.heldLow[kh] = b.heldLow[kl] + 1
      b.holderLow[kh] = b.give[kl] > 0 and b.holderLow[kl] or kl
    end
  elseif wh == 0 then
    to[kl] = to[kh] - size[kl]
    if b.heldHigh[kh] > 0 then
      b.heldHigh[kl] = b.heldHigh[kh] + 1
      b.holderHigh[kl] = b.give[kh] > 0 and b.holderHigh[kh] or kh
    end
  elseif b.pushFirst then
    local towards, against = to[kl] - b.from[kl], b.from[kh] - to[kh]
    if towards > against or (towards == against and b.rank[i] < b.rank[j]) then
      to[kl] = to[kh] - size[kl]
    else
      to[kh] = to[kl] + size[kl]
    end
  else
    to[kl] = to[kl] - o * wl / total
    to[kh] = to[kl] + size[kl]
  end
  if v > 0 then
    if wl == 0 then
      speed[kh], accel[kh] = speed[kl], accel[kl]
    elseif wh == 0 then
      speed[kl], accel[kl] = speed[kh], accel[kh]
    else
      speed[kl] = speed[kl] - v * wl / total
      speed[kh] = speed[kl]
      accel[kl] = (accel[kl] * wh + accel[kh] * wl) / total
      accel[kh] = accel[kl]
    end
  end
end

-- The same with a bounce, after which they are `gap` px apart and close at `vEnd`.
local function bounce(b, kl, kh, wl, wh, o, gap, v, vEnd)
  local to, speed, total = b.to, b.speed, wl + wh
  local way, dv = (o + gap) / total, (v - vEnd) / total
  to[kl], to[kh] = to[kl] - way * wl, to[kh] + way * wh
  speed[kl], speed[kh] = speed[kl] - dv * wl, speed[kh] + dv * wh
end

--- Two bodies meet on an axis at moment t. Returns whether they stay together; second, whether they go
--- apart and only may not overlap.
function impact.run(b, p, i, j, axis, t, dt, isLast)
  path.advance(b, i, t)
  path.advance(b, j, t)
  local kl, kh = 2 * i + axis, 2 * j + axis
  local o, v = b.to[kl] + b.size[kl] - b.to[kh], b.speed[kl] - b.speed[kh]
  local a = b.accel[kl] - b.accel[kh]
  local u, tau = approach(o, v, a, (1 - min(t, 1)) * dt)
  impact.note(b, p, i, axis, u)
  b.impactsOf[i], b.impactsOf[j] = b.impactsOf[i] + 1, b.impactsOf[j] + 1
  b.resolved = b.resolved + 1
  local r = isLast and 0 or restitution(b, i, j, u, a, dt)
  local wl, wh = weigh(b, i, j, kl, kh)
  local total = wl + wh
  if total == 0 then
    return true
  end
  local isElastic = b.restitution[i] > 0 or b.restitution[j] > 0
  if v < 0 or (isElastic and v == 0 and a == 0) then
    -- They go apart by themselves, and overlap by what others have pushed.
    b.to[kl], b.to[kh] = b.to[kl] - o * wl / total, b.to[kh] + o * wh / total
    return not isElastic, isElastic
  end
  local gap, vEnd = 0.0, 0.0
  if r > 0 then
    gap, vEnd = r * u * tau - a * tau * tau * 0.5, a * tau - r * u
  elseif a < 0 and (b.give[kl] == 0 or b.give[kh] == 0) then
    gap, vEnd = -a * tau * tau * 0.5, a * tau -- below a ceiling
  end
  local leaves = gap > 0 and vEnd < 0
  local jolt = (1 + r) * u / total
  if leaves then
    bounce(b, kl, kh, wl, wh, o, gap, v, vEnd)
  else
    stick(b, i, j, kl, kh, wl, wh, o, v)
    jolt = min(max(v, 0.0), u) / total
  end
  if b.hasFriction or b.hasLimits then
    reflow(b, kl, tau)
    reflow(b, kh, tau)
  end
  if b.hasFriction and v > 0 then
    local press = leaves and 0.0 or max(v / total - jolt, 0.0)
    rub(b, i, j, axis, wl, wh, jolt, press, tau)
  end
  return not leaves
end

return impact
