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
local max, min, sqrt = math.max, math.min, math.sqrt
local TINY = columns.TINY

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

-- The end of the flight of k, at a speed (x, y), when `drag` takes less than that.
local function slow(b, k, x, y, drag, dt)
  local speed, way, share = b.speed, b.way, drag * dt / sqrt(x * x + y * y)
  speed[k], speed[k + 1] = x - x * share, y - y * share
  way[k], way[k + 1] = way[k] - x * share * 0.5 * dt, way[k + 1] - y * share * 0.5 * dt
end

-- The same of one that stops on its way from a speed (x, y), as it slows down by `rate` px/s², and
-- goes on under the acceleration (ax, ay).
local function turn(b, k, x, y, rate, ax, ay, dt)
  local stop = min(sqrt(x * x + y * y) / max(rate, TINY), dt)
  local left = dt - stop
  b.speed[k], b.speed[k + 1] = ax * left, ay * left
  b.way[k] = x * 0.5 * stop + ax * left * 0.5 * left
  b.way[k + 1] = y * 0.5 * stop + ay * left * 0.5 * left
end

-- The flight of slot i against air friction and drag, exact as long as it moves along a line.
-- Returns false if it would turn on its way; nothing has changed then.
local function flyDragged(b, i, dt)
  local limit, drag, air, k = b.limit, b.drag[i], b.airFriction[i], 2 * i
  local ax, ay = b.pull[k] + b.push[k], b.pull[k + 1] + b.push[k + 1]
  local x, y = clamp(b.velocity[k], limit[k]), clamp(b.velocity[k + 1], limit[k + 1])
  -- Drag acts against the motion; against the pull on who stands, which it may hold.
  local towardsX, towardsY = x, y
  if x == 0 and y == 0 then
    towardsX, towardsY = ax, ay
    drag = min(drag, sqrt(ax * ax + ay * ay))
  end
  local share = drag / max(sqrt(towardsX * towardsX + towardsY * towardsY), TINY)
  local endX, wayX = flyLimited(x, ax - towardsX * share, air, limit[k], dt)
  local endY, wayY = flyLimited(y, ay - towardsY * share, air, limit[k + 1], dt)
  if endX * towardsX + endY * towardsY < 0 then
    return false
  end
  b.speed[k], b.speed[k + 1], b.way[k], b.way[k + 1] = endX, endY, wayX, wayY
  return true
end

-- Slows slot i by its drag along its motion. Exact as long as it moves along a line, but for who
-- turns in the air.
local function brakeSlot(b, i, dt)
  if b.airFriction[i] ~= 0 and flyDragged(b, i, dt) then
    return
  end
  local velocity, limit, drag, k = b.velocity, b.limit, b.drag[i], 2 * i
  local x, y = b.speed[k], b.speed[k + 1]
  local startX, startY = clamp(velocity[k], limit[k]), clamp(velocity[k + 1], limit[k + 1])
  local ax, ay = (x - startX) / dt, (y - startY) / dt
  local a, start = sqrt(ax * ax + ay * ay), sqrt(startX * startX + startY * startY)
  local along = start > 0 and (ax * startX + ay * startY) / start or 0
  local isSlower = x * x + y * y <= drag * dt * (drag * dt)
  if a <= drag and isSlower then
    turn(b, k, startX, startY, drag - along, 0, 0, dt)
  elseif a > drag and along < 0 and start < (drag - along) * dt and ax * startY == ay * startX then
    local share = 1 - drag / a
    turn(b, k, startX, startY, drag - along, ax * share, ay * share, dt)
  elseif isSlower then
    b.speed[k], b.speed[k + 1] = 0, 0
    b.way[k], b.way[k + 1] = startX * 0.5 * dt, startY * 0.5 * dt
  else
    slow(b, k, x, y, drag, dt)
  end
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
