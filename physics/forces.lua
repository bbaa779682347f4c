--- Step 3, forces: gravity, own acceleration, air friction, drag and speed limits.
--
-- Reads velocity, pull, push, airFriction, drag, limit, maxSpeed; writes speed (velocity at the end
-- of the step) and way (displacement in the step), both of free flight and without a carrier.
-- All are exact solutions for a constant acceleration, so that arcs do not depend on dt.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")

local forces = {}

local DYNAMIC = columns.DYNAMIC
local HUGE = math.huge
local sqrt = math.sqrt

-- Returns e^-x, (1 - e^-x) / x and (e^-x - 1 + x) / x² for x >= 0, from + - * / alone, so that the
-- bits are the same on every machine: x is halved to at most 1/8, the last of the three taken from
-- its Taylor series, and the halving undone.
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

-- One axis of free flight: returns the velocity at the end and the displacement.
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

-- The same for an axis with a speed limit: the limit is reached inside the step.
local function flyLimited(v, a, airFriction, limit, dt)
  v = clamp(v, limit)
  local n, way = fly(v, a, airFriction, dt)
  local capped = clamp(n, limit)
  if capped ~= n then
    local share = (capped - v) / (n - v)
    way = (v + capped) * 0.5 * share * dt + capped * (1 - share) * dt
  end
  return capped, way
end

-- Slows the velocity (x, y) by `drag` px/s² along itself; returns the new velocity and by how much
-- the displacement of the step is shorter.
local function brake(x, y, drag, dt)
  local v = sqrt(x * x + y * y)
  if v == 0 then
    return 0, 0, 0, 0
  end
  local loss = drag * dt
  if loss >= v then
    -- It stops at v / drag and has covered half of v * v / drag.
    local missing = dt - 0.5 * v / drag
    return 0, 0, x * missing, y * missing
  end
  local share = loss / v
  return x - x * share, y - y * share, x * share * 0.5 * dt, y * share * 0.5 * dt
end

local function brakeSlot(b, i, dt)
  local speed, way, k = b.speed, b.way, 2 * i
  local x, y, shorterX, shorterY = brake(speed[k], speed[k + 1], b.drag[i], dt)
  speed[k], speed[k + 1] = x, y
  way[k], way[k + 1] = way[k] - shorterX, way[k + 1] - shorterY
end

-- Limits the length of the velocity; the displacement follows in proportion.
local function limitLength(b, i, dt)
  local speed, way, velocity, k = b.speed, b.way, b.velocity, 2 * i
  local x, y, limit = speed[k], speed[k + 1], b.maxSpeed[i]
  local length = sqrt(x * x + y * y)
  if length > limit then
    x, y = x * (limit / length), y * (limit / length)
    local startX, startY = velocity[k], velocity[k + 1]
    local start = sqrt(startX * startX + startY * startY)
    if start > limit then
      startX, startY = startX * (limit / start), startY * (limit / start)
    end
    speed[k], speed[k + 1] = x, y
    way[k], way[k + 1] = (startX + x) * 0.5 * dt, (startY + y) * 0.5 * dt
  end
end

--- Computes the free flight of the dynamic objects in awakeList from `first` to `last`.
function forces.run(b, dt, first, last)
  local list, kind, airFriction, limit = b.awakeList, b.kind, b.airFriction, b.limit
  local velocity, pull, push, speed, way = b.velocity, b.pull, b.push, b.speed, b.way
  for n = first, last do
    local i = list[n]
    if kind[i] == DYNAMIC then
      local k = 2 * i
      speed[k], way[k] = flyLimited(velocity[k], pull[k] + push[k], airFriction[i], limit[k], dt)
      k = k + 1
      speed[k], way[k] = flyLimited(velocity[k], pull[k] + push[k], airFriction[i], limit[k], dt)
    end
  end
  local drag, maxSpeed = b.drag, b.maxSpeed
  for n = first, last do
    local i = list[n]
    if drag[i] ~= 0 and kind[i] == DYNAMIC then
      brakeSlot(b, i, dt)
    end
    if maxSpeed[i] ~= HUGE and kind[i] == DYNAMIC then
      limitLength(b, i, dt)
    end
  end
end

return forces
