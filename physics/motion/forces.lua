--- Forces: computes the free flight of a body in a step from gravity, its own acceleration, air
-- friction, drag and speed limits.
--
-- Reads velocity, push, flowPull, flowAir, flowDrag (see zones), limit, maxSpeed, support. Writes
-- speed (velocity at the end of the step) and way (displacement in the step), both without contacts
-- and without a carrier. Writes reserve and pace of bodies with a limit. All are exact solutions
-- for a constant acceleration, so that arcs do not depend on dt.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local forces = {}

local DYNAMIC = columns.DYNAMIC
local HUGE = math.huge
local max, min, sqrt = math.max, math.min, math.sqrt
local TINY = columns.TINY

-- Returns e^-x, (1 - e^-x) / x and (e^-x - 1 + x) / x² for x >= 0. It uses + - * / alone, so that
-- the bits are the same on every machine. x is halved until it is at most 1/8, the last of the
-- three is taken from its Taylor series, and the halving is undone.
local function damping(x)
  local halvings = 0
  while x > 0.125 do
    x = x * 0.5
    halvings = halvings + 1
  end
  local second = 0.5
    - x * (1 / 6 - x * (1 / 24 - x * (1 / 120 - x * (1 / 720 - x * (1 / 5040 - x / 40320)))))
  local first = 1 - x * second
  local decay = 1 - x * first
  for _ = 1, halvings do
    x = x * 2
    first = first * (1 + decay) * 0.5
    decay = decay * decay
    second = (1 - first) / x
  end
  return decay, first, second
end

-- Returns the velocity at the end of a free flight on one axis, and the displacement.
local function fly(v, a, airFriction, dt)
  if airFriction == 0 then
    local n = v + a * dt
    return n, (v + n) * 0.5 * dt
  end
  local decay, first, second = damping(airFriction * dt)
  return v * decay + a * dt * first, v * dt * first + a * dt * dt * second
end

local function clamp(v, limit)
  return v > limit and limit or v < -limit and -limit or v
end

-- Returns how many seconds a flight with air friction takes until it is as fast as `target`, which
-- it is before dt is over. Source: Newton's method. The velocity is convex or concave, so it
-- converges.
local function timeUntil(v, a, airFriction, target, dt)
  local time = 0.0
  for _ = 1, 6 do
    local now = fly(v, a, airFriction, time)
    time = max(0.0, min(time + (target - now) / (a - airFriction * now), dt))
  end
  return time
end

--- Computes the flight with air friction of body k for tau s, from a velocity of v px/s, under an
--- acceleration of a px/s². Meanwhile it rubs on ground that moves at `base` and brakes it by
--- `brake` px/s². Returns the velocity at the end and the displacement.
function forces.slide(b, k, v, a, base, brake, tau)
  local carried, air, way = b.carried[k], b.flowAir[(k - k % 2) * 0.5], 0.0
  local slip, own = v - base, base - carried
  if slip ~= 0 then
    local pull = slip > 0 and a - brake or a + brake
    local last, its = fly(v - carried, pull, air, tau)
    if (last - own) * slip >= 0 then
      return last + carried, its + carried * tau
    end
    local time = timeUntil(v - carried, pull, air, own, tau)
    local _, before = fly(v - carried, pull, air, time)
    way, tau = before + carried * time, tau - time
  end
  local pull = a - air * own
  if pull <= brake and -pull <= brake then
    return base, way + base * tau
  end
  local last, its = fly(own, pull > 0 and a - brake or a + brake, air, tau)
  return last + carried, way + its + carried * tau
end

-- Computes the free flight on an axis with a speed limit, which may be reached inside the step.
-- Returns the velocity at the end, the displacement, and by how much faster it would be without the
-- limit.
local function flyLimited(v, a, airFriction, limit, dt)
  v = clamp(v, limit)
  local n, way = fly(v, a, airFriction, dt)
  local capped = clamp(n, limit)
  if capped ~= n and airFriction == 0 then
    local share = (capped - v) / (n - v)
    way = (v + capped) * 0.5 * share * dt + capped * (1 - share) * dt
  elseif capped ~= n then
    local time = timeUntil(v, a, airFriction, capped, dt)
    local _, before = fly(v, a, airFriction, time)
    way = before + capped * (dt - time)
  end
  return capped, way, n - capped
end

-- Notes what a limit has kept from k, at a speed of v px/s.
local function keep(b, k, v, left)
  b.reserve[k], b.pace[k] = left, v
end

-- Returns what is left of a loss of speed of k, after it is made up with what the limit of k keeps
-- back.
local function lose(b, k, loss)
  local kept = b.reserve[k]
  local borne = max(min(loss, max(kept, 0)), min(kept, 0))
  b.reserve[k] = kept - borne
  return loss - borne
end

-- Ends a flight from the speed (startX, startY) to (x, y), of which `drag` takes only a part. Drag
-- acts against the direction that the flight has halfway, or against that at the end if it turns
-- about. Source: the midpoint method, as in E. Hairer et al., Solving Ordinary Differential
-- Equations I.
local function slow(b, k, startX, startY, x, y, drag, dt)
  local alongX, alongY = x, y
  local dot, square = startX * x + startY * y, x * x + y * y
  -- If it turns by less than 60 degrees; the cosine of 60 degrees is 1/2.
  if dot > 0 and 4 * dot * dot > (startX * startX + startY * startY) * square then
    alongX, alongY = startX + x, startY + y
  end
  local share = drag * dt / max(sqrt(alongX * alongX + alongY * alongY), TINY)
  local speed, way = b.speed, b.way
  local lossX, lossY = lose(b, k, alongX * share), lose(b, k + 1, alongY * share)
  speed[k], speed[k + 1] = x - lossX, y - lossY
  way[k], way[k + 1] = way[k] - lossX * 0.5 * dt, way[k + 1] - lossY * 0.5 * dt
end

-- Ends the flight of a body that slows down from (x, y) by `rate` px/s², stops, and goes on under
-- the acceleration (ax, ay).
local function turn(b, k, x, y, rate, ax, ay, dt)
  local stop = min(sqrt(x * x + y * y) / max(rate, TINY), dt)
  local left = dt - stop
  b.speed[k], b.speed[k + 1], b.reserve[k], b.reserve[k + 1] = ax * left, ay * left, 0, 0
  b.way[k] = x * 0.5 * stop + ax * left * 0.5 * left
  b.way[k + 1] = y * 0.5 * stop + ay * left * 0.5 * left
end

-- Returns the index of the axis along which slot i stands on something, 0 if there is none. What it
-- stands on will take away its fall in this step.
local function standsAlong(b, i)
  local down, k = b.down, 2 * i
  k = k + (down[k] ~= 0 and 0 or 1)
  local isPulled = (b.flowPull[k] + b.push[k]) * down[k] > 0
  return b.support[i] ~= 0 and isPulled and b.velocity[k] == 0 and k or 0
end

-- Computes the flight of slot i under the acceleration (ax, ay), against air friction and drag. It
-- is exact as long as the motion is along a line. Returns false, and changes nothing, if it would
-- turn round on its way.
local function flyDragged(b, i, ax, ay, dt)
  local limit, drag, air, k = b.limit, b.flowDrag[i], b.flowAir[i], 2 * i
  local x, y = clamp(b.velocity[k], limit[k]), clamp(b.velocity[k + 1], limit[k + 1])
  -- Drag acts against the motion. If the body does not move, it acts against the pull, which it may
  -- hold.
  local towardsX, towardsY = x, y
  if x == 0 and y == 0 then
    towardsX, towardsY = ax, ay
    drag = min(drag, sqrt(ax * ax + ay * ay))
  end
  local share = drag / max(sqrt(towardsX * towardsX + towardsY * towardsY), TINY)
  local endX, wayX, keptX = flyLimited(x, ax - towardsX * share, air, limit[k], dt)
  local endY, wayY, keptY = flyLimited(y, ay - towardsY * share, air, limit[k + 1], dt)
  if endX * towardsX + endY * towardsY < 0 then
    return false
  end
  b.speed[k], b.speed[k + 1], b.way[k], b.way[k + 1] = endX, endY, wayX, wayY
  keep(b, k, endX, keptX)
  keep(b, k + 1, endY, keptY)
  return true
end

-- Slows slot i by its drag along its motion. That is exact as long as it moves along a line, unless
-- it turns round against air friction. On the axis of `stands` it does not move.
local function brakeSlot(b, i, stands, dt)
  local velocity, limit, drag, k = b.velocity, b.limit, b.flowDrag[i], 2 * i
  if b.flowAir[i] ~= 0 then
    local pullX = stands == k and 0 or b.flowPull[k] + b.push[k]
    local pullY = stands == k + 1 and 0 or b.flowPull[k + 1] + b.push[k + 1]
    if flyDragged(b, i, pullX, pullY, dt) then
      return
    end
  end
  local x, y = b.speed[k], b.speed[k + 1]
  local startX, startY = clamp(velocity[k], limit[k]), clamp(velocity[k + 1], limit[k + 1])
  local freeX, freeY = x + b.reserve[k], y + b.reserve[k + 1] -- without its limits
  local ax, ay = (freeX - startX) / dt, (freeY - startY) / dt
  local a, start = sqrt(ax * ax + ay * ay), sqrt(startX * startX + startY * startY)
  local along = start > 0 and (ax * startX + ay * startY) / start or 0
  local isSlower = freeX * freeX + freeY * freeY <= drag * dt * (drag * dt)
  if a <= drag and isSlower then
    turn(b, k, startX, startY, drag - along, 0, 0, dt)
  elseif a > drag and along < 0 and start < (drag - along) * dt and ax * startY == ay * startX then
    local share = 1 - drag / a
    turn(b, k, startX, startY, drag - along, ax * share, ay * share, dt)
  elseif isSlower then
    b.speed[k], b.speed[k + 1], b.reserve[k], b.reserve[k + 1] = 0, 0, 0, 0
    b.way[k], b.way[k + 1] = startX * 0.5 * dt, startY * 0.5 * dt
  else
    slow(b, k, startX, startY, x, y, drag, dt)
  end
end

-- Returns a vector in the direction of (x, y).
local function scaled(x, y, length)
  local share = length / max(sqrt(x * x + y * y), TINY)
  return x * share, y * share
end

-- Returns the part of a step after which a velocity is as long as `limit`. It changes evenly by
-- (gainX, gainY), and is not longer than `limit` when the step begins.
local function shareUntil(limit, startX, startY, gainX, gainY)
  local square, dot = gainX * gainX + gainY * gainY, startX * gainX + startY * gainY
  local missing = max(limit * limit - startX * startX - startY * startY, 0)
  return max(0, min((sqrt(dot * dot + square * missing) - dot) / max(square, TINY), 1))
end

-- Limits the length of the velocity, which may reach its limit inside the step. From there on, only
-- the gain across the motion, halfway, changes it, if the rest of the step adds less than half of
-- the limit. So the direction turns at the same rate in steps of any length.
local function limitLength(b, i, dt)
  local speed, way, velocity, k = b.speed, b.way, b.velocity, 2 * i
  local x, y, limit = speed[k], speed[k + 1], b.maxSpeed[i]
  if x * x + y * y <= limit * limit then
    return
  end
  local startX, startY = velocity[k], velocity[k + 1]
  if startX * startX + startY * startY > limit * limit then
    startX, startY = scaled(startX, startY, limit)
    x, y = startX + (x - velocity[k]), startY + (y - velocity[k + 1])
  end
  if x * x + y * y <= limit * limit then -- it was faster than the limit, and has slowed down
    speed[k], speed[k + 1] = x, y
    way[k], way[k + 1] = (startX + x) * 0.5 * dt, (startY + y) * 0.5 * dt
    return
  end
  local share, freeX, freeY = shareUntil(limit, startX, startY, x - startX, y - startY), x, y
  local fullX, fullY = startX + (x - startX) * share, startY + (y - startY) * share
  local gainX, gainY = x - fullX, y - fullY
  local halfX, halfY = (fullX + x) * 0.5, (fullY + y) * 0.5
  if (gainX * gainX + gainY * gainY) * 4 < limit * limit then
    local gain = (gainX * halfX + gainY * halfY) / (halfX * halfX + halfY * halfY)
    x, y = x - halfX * gain, y - halfY * gain
  end
  x, y = scaled(x, y, limit)
  local before, after = share * 0.5 * dt, (1 - share) * 0.5 * dt
  keep(b, k, x, b.reserve[k] + freeX - x)
  keep(b, k + 1, y, b.reserve[k + 1] + freeY - y)
  speed[k], speed[k + 1] = x, y
  way[k] = (startX + fullX) * before + (fullX + x) * after
  way[k + 1] = (startY + fullY) * before + (fullY + y) * after
end

-- Applies drag and maxSpeed to the flight of slot i. Both act on motion: of a body that stands, the
-- fall that the floor will take away does not count.
local function hinder(b, i, dt)
  local speed, way, stands, k = b.speed, b.way, standsAlong(b, i), 2 * i
  if b.flowAir[i] == 0 and b.limit[k] == HUGE and b.limit[k + 1] == HUGE then
    b.reserve[k], b.reserve[k + 1] = 0, 0
  end
  if stands ~= 0 then
    speed[stands], way[stands], b.reserve[stands] = 0, 0, 0
  end
  if b.flowDrag[i] ~= 0 then
    brakeSlot(b, i, stands, dt)
  end
  if b.maxSpeed[i] ~= HUGE then
    limitLength(b, i, dt)
  end
  if stands ~= 0 then
    -- What it stands on may let it through in this step.
    local limit, pull = min(b.limit[stands], b.maxSpeed[i]), b.flowPull[stands] + b.push[stands]
    local v, its, kept = flyLimited(0, pull, b.flowAir[i], limit, dt)
    speed[stands], way[stands] = v, its
    keep(b, stands, v, kept)
  end
end

-- Applies drag and maxSpeed to the bodies that have one.
local function hinderAll(b, dt, first, last)
  local list, kind, drag, maxSpeed = b.awakeList, b.kind, b.flowDrag, b.maxSpeed
  for n = first, last do
    local i = list[n]
    if (drag[i] ~= 0 or maxSpeed[i] ~= HUGE) and kind[i] == DYNAMIC then
      hinder(b, i, dt)
    end
  end
end

--- Computes the free flight of the dynamic objects in awakeList from `first` to `last`.
function forces.run(b, dt, first, last)
  local list, kind, airFriction, limit = b.awakeList, b.kind, b.flowAir, b.limit
  local velocity, pull, push, speed, way = b.velocity, b.flowPull, b.push, b.speed, b.way
  for n = first, last do
    local i = list[n]
    local k, m = 2 * i, 2 * i + 1
    if kind[i] == DYNAMIC and airFriction[i] == 0 and limit[k] == HUGE and limit[m] == HUGE then
      -- The same as `fly`, written out for the usual case: without a compiler the calls would cost
      -- more than the work.
      local x, y = velocity[k], velocity[m]
      local endX, endY = x + (pull[k] + push[k]) * dt, y + (pull[m] + push[m]) * dt
      speed[k], speed[m] = endX, endY
      way[k], way[m] = (x + endX) * 0.5 * dt, (y + endY) * 0.5 * dt
    elseif kind[i] == DYNAMIC then
      local air = airFriction[i]
      local x, wayX, keptX = flyLimited(velocity[k], pull[k] + push[k], air, limit[k], dt)
      local y, wayY, keptY = flyLimited(velocity[m], pull[m] + push[m], air, limit[m], dt)
      speed[k], way[k], speed[m], way[m] = x, wayX, y, wayY
      keep(b, k, x, keptX)
      keep(b, m, y, keptY)
    end
  end
  if b.hasHinders then
    hinderAll(b, dt, first, last)
  end
end

return forces
