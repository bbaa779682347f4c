--- Impacts: two bodies that meet in the middle of a step.
--
-- Both go to the moment of the impact. What happens there is worked out from the end of their
-- paths, which is exact for constant acceleration: the overlap that they would have there, and how
-- fast they would close, tell how fast they meet and how much of the step is left. They bounce, or
-- go on flush with a common velocity, and are a contact for the rest of the step.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local bonds = require(root .. ".solver.bonds")
local carrier = require(root .. ".objects.carriers")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")
local friction = require(root .. ".solver.friction")
local path = require(root .. ".motion.path")
local pool = require(root .. ".solver.pool")

require(root .. ".memory.jit").file()

local impact = {}

local DYNAMIC = columns.DYNAMIC
local HUGE = math.huge
local max, min, sqrt = math.max, math.min, math.sqrt
-- Impacts of one body in a step after which it does not bounce any more, divided by 1 -
-- restitution, and the most there are.
local BOUNCES, MOST_BOUNCES = 4, 13
-- The same, after which it stays where it was hit, even below a ceiling: others push it there.
local PUSHED = 3
-- Bonds in a row along which an impact drags others with it in its own step.
local DEPTH = 8

--- Notes the first impact of a pair in the step: on which side, and at u px/s.
function impact.note(b, p, low, axis, u)
  if b.hit[p] == 0 then
    b.hit[p] = b.pairA[p] == low and 2 * axis + 2 or 2 * axis + 1
    b.hitSpeed[p] = u
  end
end

-- How fast two meet, and how many seconds are left then: from the overlap o, the closing speed v
-- and the closing acceleration a at the end of the step, which is at most `left` s away.
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

-- Shares of a push for two that can both give way, or one of them, or neither. What has left the
-- body that held it can.
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
      local stayLow, stayHigh = pool.meetFirm(b.speed[kl], b.speed[kh])
      if stayLow and stayHigh then
        b.to[kl], b.to[kh] = b.from[kl], b.from[kh]
        b.speed[kl], b.speed[kh], b.accel[kl], b.accel[kh] = 0.0, 0.0, 0.0, 0.0
      end
      wl, wh = stayLow and 0 or wl, stayHigh and 0 or wh
    end
  elseif wl > 0 and wh > 0 and b.power[i] ~= b.power[j] then
    return pool.share(b.power[i] > b.power[j], wl, wh, b.speed[kl], b.speed[kh])
  end
  return wl, wh
end

-- The restitution of a pair that closes at u px/s: 0, unless that is faster than its acceleration
-- makes it in two steps.
local function restitution(b, i, j, u, a, dt)
  return pool.bounces(u, a, 2 * dt) and max(b.restitution[i], b.restitution[j]) or 0
end

-- Whether slot i has met others too often in this step to bounce once more.
local function isSpent(b, i, r)
  local limit = min(BOUNCES / max(1 - r, 1e-3), MOST_BOUNCES)
  return b.impactsOf[i] > limit and b.kind[i] == DYNAMIC
end

-- Whether one of two that have met has met others so often that these seem to push it on.
local function isPushed(b, i, j)
  return b.impactsOf[i] > PUSHED and b.kind[i] == DYNAMIC
    or b.impactsOf[j] > PUSHED and b.kind[j] == DYNAMIC
end

-- Whether body k, which goes at v now, is on its way off what has held it in this step.
local function leavesHolder(b, k, v)
  return b.heldHigh[k] > 0 and v < b.speed[b.holderHigh[k]]
    or b.heldLow[k] > 0 and v > b.speed[b.holderLow[k]]
end

-- What acts on body k by itself, friction and limits do so along this axis for the rest of the
-- step, from the speed that it has after the impact.
local function reflow(b, k, tau, dt)
  local isFree = b.grip[k] == 0 and b.least[k] == -HUGE and b.most[k] == HUGE
  local last = b.speed[k]
  local v = last - b.accel[k] * tau
  if b.give[k] == 0 or (isFree and not leavesHolder(b, k, v)) then
    return
  end
  local new, way = flow.body(b, k, v, tau, dt)
  b.speed[k], b.to[k] = new, b.to[k] + way - (v + last) * 0.5 * tau
  b.accel[k] = tau > 0 and (new - v) / tau or 0.0
end

-- The ground under body k bears an impact, and rubs at once; then what presses until the end.
local function bear(b, k, jolt, press, tau, dt)
  local slip = b.speed[k] - b.accel[k] * tau - b.base[k]
  local loss = b.rough[k] * jolt * b.give[k]
  local change = slip > 0 and -min(loss, slip) or min(loss, -slip)
  b.speed[k], b.to[k] = b.speed[k] + change, b.to[k] + change * tau
  b.grip[k] = tau > 0 and b.grip[k] + b.rough[k] * press / tau or b.grip[k]
  reflow(b, k, tau, dt)
end

-- Two that both give way rub on each other.
local function rubBoth(b, kl, kh, mu, jolt, press, tau)
  local il, ih, accel = b.give[kl], b.give[kh], b.accel[kl] - b.accel[kh]
  local total, last = il + ih, b.speed[kl] - b.speed[kh]
  local v = last - accel * tau
  local loss = mu * jolt * total
  local after = v > loss and v - loss or v < -loss and v + loss or 0.0
  local brake = tau > 0 and mu * press * total / tau or 0.0
  local new, way = flow.slide(after, accel, 0.0, brake, tau)
  local dv, d = (new - last) / total, (way - (v + last) * 0.5 * tau) / total
  b.speed[kl], b.to[kl] = b.speed[kl] + dv * il, b.to[kl] + d * il
  b.speed[kh], b.to[kh] = b.speed[kh] - dv * ih, b.to[kh] - d * ih
  if tau > 0 then
    local change = (new - after - (last - v)) / tau / total
    b.accel[kl], b.accel[kh] = b.accel[kl] + change * il, b.accel[kh] - change * ih
  end
end

local drag

-- Friction has held the bodies of bond n together. An impact has given one of them another speed:
-- they rub for the last tau s.
local function dragBond(b, list, n, other, tau, dt, depth)
  local up, low, press = list.up[n], list.low[n], list.limit[n] * tau / dt
  if depth == 0 or not bonds.holds(list, n) or b.speed[up] == b.speed[low] then
    return
  elseif other == low and b.speed[low] == b.base[low] and b.grip[low] * tau >= press then
    b.base[up], b.grip[up] = b.speed[low], press / tau -- the ground holds the lower one
    reflow(b, up, tau, dt)
  else
    rubBoth(b, up, low, 1, 0.0, press, tau)
    drag(b, other, n, tau, dt, depth - 1)
  end
end

-- The same for all bonds of body k but for `from`; and so on, `depth` times.
function drag(b, k, from, tau, dt, depth)
  local list, n = b.bonds[k % 2], b.bondUnder[k]
  if n ~= 0 and n ~= from then
    dragBond(b, list, n, list.low[n], tau, dt, depth)
  end
  n = b.bondOn[k]
  while n ~= 0 do
    if n ~= from then
      dragBond(b, list, n, list.up[n], tau, dt, depth)
    end
    n = list.next[n]
  end
end

-- The impact rubs along the other axis, at once; what the two press with then, until the end.
-- `jolt` and `press` are impulses along the normal.
local function rub(b, i, j, axis, wl, wh, jolt, press, tau, dt)
  local mu = friction.coefficient(b, i, j)
  if mu <= 0 then
    return
  end
  local kl, kh = 2 * i + 1 - axis, 2 * j + 1 - axis
  local il, ih = b.give[kl], b.give[kh]
  if il > 0 and ih > 0 then
    local k = wl == 0 and kl or wh == 0 and kh
    if k and b.grip[k] > 0 then
      bear(b, k, jolt, press, tau, dt)
    end
    rubBoth(b, kl, kh, mu, jolt, press, tau)
  elseif il + ih > 0 then
    local k, ground, belt = kl, kh, carrier.beltSpeed(b, i, j, axis)
    if il == 0 then
      k, ground, belt = kh, kl, carrier.beltSpeed(b, j, i, axis)
    end
    b.base[k], b.grip[k], b.rough[k] = b.speed[ground] + belt, 0.0, mu
    bear(b, k, jolt, press, tau, dt)
  end
end

-- Places and speeds of two after an impact without a bounce: flush, with a common velocity.
local function stick(b, i, j, kl, kh, wl, wh, separation, o, v)
  local to, speed, accel = b.to, b.speed, b.accel
  local total = wl + wh
  if wl == 0 then
    to[kh] = to[kl] + separation
    pool.leanLow(b, kl, kh)
  elseif wh == 0 then
    to[kl] = to[kh] - separation
    pool.leanHigh(b, kl, kh)
  elseif b.pushFirst then
    local towards, against = to[kl] - b.from[kl], b.from[kh] - to[kh]
    if towards > against or (towards == against and b.rank[i] < b.rank[j]) then
      to[kl] = to[kh] - separation
    else
      to[kh] = to[kl] + separation
    end
  else
    to[kl] = to[kl] - o * wl / total
    to[kh] = to[kl] + separation
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

--- Two bodies meet on an axis at moment t. Two that are inside each other (`isDeep`) come apart, or
--- in a heap that has no room get no deeper.
--- Returns whether they stay together; how far apart, px from the low edge of one to that of the
--- other; and whether they go apart and only may not overlap.
function impact.run(b, p, i, j, axis, t, dt, isLate, isDeep)
  local left = (1 - max(b.time[i], b.time[j])) * dt
  path.advance(b, i, t)
  path.advance(b, j, t)
  local kl, kh = 2 * i + axis, 2 * j + axis
  local separation = b.size[kl]
  if isDeep and (b.deepAt[i] == b.solveStamp or b.deepAt[j] == b.solveStamp) then
    separation = min(separation, b.from[kh] - b.from[kl])
  end
  local o, v = b.to[kl] + separation - b.to[kh], b.speed[kl] - b.speed[kh]
  local a = b.accel[kl] - b.accel[kh]
  local u, tau = approach(o, v, a, left)
  impact.note(b, p, i, axis, u)
  b.impactsOf[i], b.impactsOf[j] = b.impactsOf[i] + 1, b.impactsOf[j] + 1
  b.resolved = b.resolved + 1
  local r = restitution(b, i, j, u, a, dt)
  if r > 0 and (isLate or isSpent(b, i, r) or isSpent(b, j, r)) then
    r = 0
  end
  local wl, wh = weigh(b, i, j, kl, kh)
  local total = wl + wh
  if total == 0 then
    b.isJammed = true
    return true, separation
  end
  local isElastic = b.restitution[i] > 0 or b.restitution[j] > 0
  if v < 0 or (isElastic and v == 0 and a == 0) then
    -- They go apart by themselves, and overlap by what others have pushed.
    b.to[kl], b.to[kh] = b.to[kl] - o * wl / total, b.to[kh] + o * wh / total
    return not isElastic, separation, isElastic
  end
  local gap, vEnd = 0.0, 0.0
  if r > 0 then
    gap, vEnd = r * u * tau - a * tau * tau * 0.5, a * tau - r * u
  elseif a < 0 and (b.give[kl] == 0 or b.give[kh] == 0) and not isPushed(b, i, j) then
    gap, vEnd = -a * tau * tau * 0.5, a * tau -- below a ceiling
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
    if tau > 0 then
      drag(b, kl, 0, tau, dt, DEPTH)
      drag(b, kh, 0, tau, dt, DEPTH)
    end
    local press = leaves and 0.0 or max(v / total - jolt, 0.0)
    rub(b, i, j, axis, wl, wh, jolt, press, tau, dt)
  end
  return not leaves, separation
end

return impact
