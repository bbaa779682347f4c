---@diagnostic disable
--- Flow: computes the motion of a body or a block along an axis from a constant force, friction and
-- speed limits.
--
-- Coulomb friction against ground that moves at v is a *kink* at v: the force jumps there, from
-- +grip below to -grip above. A motion that comes to the kink stays there while the rest of the
-- force is less than the grip. A speed limit holds what comes to it as long as the force drives it
-- on. So friction stops, turns or holds a body at the exact moment, and so do limits.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local forces = require(root .. ".memory.lazy")(root .. ".motion.forces")
local path = require(root .. ".motion.path")

local flow = {}

local DYNAMIC = columns.DYNAMIC
local HUGE = math.huge
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- Stretches of time in a step: before the kink, after it, and at a limit.
local STRETCHES = 3

--- Returns the velocity after `tau` s and the displacement until then, px. The body has this mass,
--- the velocity v, this force without its kink, of `grip` at velocity `base`. It moves no slower
--- than `least` and no faster than `most`.
function flow.run(base, grip, mass, force, v, tau, least, most)
  local way = 0.0
  base, v = grip > 0 and base or HUGE, max(min(v, most), least)
  for _ = 1, STRETCHES do
    local above = v < base and force + grip or force - grip
    local below = v > base and force - grip or force + grip
    local a, target = 0.0, v
    if above > 0 and v < most then
      a, target = above / mass, min(v < base and base or HUGE, most)
    elseif below < 0 and v > least then
      a, target = below / mass, max(v > base and base or -HUGE, least)
    end
    local last = v + a * tau
    if a == 0 or (target - last) * a >= 0 then
      return last, way + (v + last) * 0.5 * tau
    end
    local time = (target - v) / a
    way, tau = way + (v + target) * 0.5 * time, tau - time
    v = target
  end
  return v, way + v * tau
end

--- Returns the acceleration of body k by itself, px/s², with what a speed limit keeps from it, but
--- without the friction of its ground, and without its drag, which is such friction here.
function flow.drive(b, k, dt)
  local tug = b.tug[k] * b.give[k] / dt
  if b.flowDrag[floor(k * 0.5)] ~= 0 then
    return path.pullOf(b, k) + tug
  end
  return (b.freeSpeed[k] - b.start[k] + b.reserve[k]) / dt + tug
end

--- Returns the velocity of body k tau s after it was v, in a step of dt s, and its displacement.
--- The friction of its ground and its limits act on it.
function flow.body(b, k, v, tau, dt)
  local give, grip, base = b.give[k], b.grip[k], b.base[k]
  if b.flowAir[floor(k * 0.5)] ~= 0 and b.least[k] == -HUGE and b.most[k] == HUGE then
    local a = path.pullOf(b, k) + b.tug[k] * give / dt
    return forces.slide(b, k, v, a, base, grip * give, tau)
  end
  return flow.run(base, grip * give, 1, flow.drive(b, k, dt), v, tau, b.least[k], b.most[k])
end

--- Notes that friction or a bond acts on body k, so that its path must be computed anew.
function flow.notePulled(b, k)
  b.pulledCount = b.pulledCount + 1
  b.pulled[b.pulledCount] = k
end

-- Computes the speed limits of all awake bodies, with the velocity of their carriers.
local function findLimits(b)
  local list, carried, reserve, softSpeed = b.awakeList, b.carried, b.reserve, b.softSpeed
  for n = 1, b.awakeCount do
    for k = 2 * list[n], 2 * list[n] + 1 do
      local base = carried[k] + softSpeed[k]
      b.least[k] = reserve[k] < 0 and b.freeSpeed[k] or b.slowest[k] + base
      b.most[k] = reserve[k] > 0 and b.freeSpeed[k] or b.fastest[k] + base
    end
  end
end

-- Lets drag rub on bodies as ground does that moves with their carrier: against their motion, or,
-- if they do not move, against what pulls or pushes them.
local function addDrag(b)
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    local k, brake = 2 * i, b.flowDrag[i]
    if brake ~= 0 and b.kind[i] == DYNAMIC then
      local x, y = b.velocity[k], b.velocity[k + 1]
      if x == 0 and y == 0 then
        x = b.down[k] ~= 0 and b.support[i] ~= 0 and 0 or path.pullOf(b, k)
        y = b.down[k + 1] ~= 0 and b.support[i] ~= 0 and 0 or path.pullOf(b, k + 1)
      end
      local size, most = sqrt(x * x + y * y), brake * b.mass[i]
      b.grip[k] = size > 0 and max(x, -x) / size * most or most
      b.grip[k + 1] = size > 0 and max(y, -y) / size * most or most
      b.base[k], b.base[k + 1] = b.carried[k], b.carried[k + 1]
    end
  end
end

--- Prepares all awake bodies for the step: nothing rubs yet but drag.
function flow.begin(b)
  local list, onset, start, tug = b.awakeList, b.onset, b.start, b.tug
  local grip, base, bondUnder, bondOn = b.grip, b.base, b.bondUnder, b.bondOn
  for n = 1, b.awakeCount do
    for k = 2 * list[n], 2 * list[n] + 1 do
      onset[k], tug[k], grip[k], base[k], bondUnder[k], bondOn[k] = start[k], 0, 0, 0, 0, 0
    end
  end
  if b.hasHinders then
    addDrag(b)
  end
  if b.hasLimits then
    findLimits(b)
  end
end

--- Puts all movable bodies on an axis to where they would be without contacts.
function flow.reset(b, axis, dt)
  local list, from, to, speed, free = b.awakeList, b.from, b.to, b.speed, b.freeSpeed
  local way, carried, accel, start = b.way, b.carried, b.accel, b.start
  local onset, outset, ownSpeed, isPushed = b.onset, b.outset, b.ownSpeed, b.isPushed
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    if b.give[k] > 0 then
      to[k], speed[k] = from[k] + way[k] + carried[k] * dt, free[k]
      accel[k] = (free[k] - start[k]) / dt
    end
    outset[k], ownSpeed[k], isPushed[k] = onset[k], free[k], false
  end
end

--- Computes the paths of the bodies that were noted so, as if they had no contacts on this axis.
function flow.runAll(b, dt)
  for n = 1, b.pulledCount do
    local k = b.pulled[n]
    local onset = b.onset[k]
    local v, way = flow.body(b, k, onset, dt, dt)
    b.speed[k], b.to[k], b.accel[k] = v, b.from[k] + way, (v - onset) / dt
    b.ownSpeed[k] = v
  end
end

return flow
