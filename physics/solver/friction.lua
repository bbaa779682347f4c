--- Coulomb friction: computes from the loads of the contacts of one axis how they brake their
-- bodies along the other axis.
--
-- The load of a contact is the impulse that settling took off the body that leans, plus that of
-- what leans on it. All of it goes to the support with the widest common edge. There are two
-- cases:
--
-- - Ground is a support that cannot be moved along the surface. The body slides, stops, turns or
--   sticks on it exactly (see flow.lua).
-- - A support that can be moved has a bond with the body (see bonds.lua).
--
-- The coefficient of a pair is `friction.coefficient`. Friction of two that meet inside the step
-- is `rub` in impact.lua.
--
-- Reads contacts, freeSpeed, start; writes base, grip, onset, bonds, and the paths on the rubbed
-- axis.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local bonds = require(root .. ".solver.bonds")
local carriers = require(root .. ".motion.carriers")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")
local settle = require(root .. ".solver.settle")

local friction = {}

local EPSILON = columns.EPSILON
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- Number of attempts in which bonds may break, and of all attempts. In the later ones bonds only
-- stick.
local TEARS, ATTEMPTS = 2, 4
-- px by which what is squeezed may overlap what bears it, and still rub on it.
local SQUEEZED = 0.01
-- Values of `bearing`: the low body leans on the high one, or the high one on the low one.
local ON_HIGH, ON_LOW = 1, 2

--- Returns the coefficient of friction of a pair: the geometric mean of both. If one body has none
--- of its own (an immovable one), it is that of the other.
function friction.coefficient(b, i, j)
  local one, other = b.friction[i], b.friction[j]
  if other < 0 or one == other then
    return max(one, 0)
  elseif one < 0 then
    return other
  end
  return sqrt(one * other)
end

-- Chooses the support of body k, of which contact c is one more candidate. The one with the widest
-- common edge wins, and of equal ones the first in the order of the world.
local function chooseSupport(b, list, k, c, other)
  local best = b.bearer[k]
  if best == 0 then
    b.bearer[k] = c
    return
  end
  local wider = list.width[c] - list.width[best]
  local bestOther = list.bearing[best] == ON_HIGH and list.high[best] or list.low[best]
  local isFirst = b.rank[floor(other * 0.5)] < b.rank[floor(bestOther * 0.5)]
  if wider > EPSILON or (wider > -EPSILON and isFirst) then
    b.bearer[k] = c
  end
end

-- Finds which contacts bear a load, and which one bears the load of each body.
local function findSupports(b, list, axis)
  local awake, bearer, load, weight = b.awakeList, b.bearer, b.load, b.weight
  for n = 1, b.awakeCount do
    local k = 2 * awake[n] + axis
    bearer[k], load[k], weight[k] = 0, 0, 0
  end
  local low, high, separation, bearing = list.low, list.high, list.separation, list.bearing
  local to, speed, free, give, from, size = b.to, b.speed, b.freeSpeed, b.give, b.from, b.size
  local other = 1 - 2 * axis
  for c = 1, list.count do
    local kl, kh = low[c], high[c]
    local over = to[kl] + separation[c] - to[kh]
    local kind = 0
    if over <= SQUEEZED and over >= -EPSILON then
      if b.heldHigh[kh] > 0 and give[kl] > 0 and free[kl] >= speed[kl] then
        kind = ON_HIGH
      elseif b.heldLow[kl] > 0 and give[kh] > 0 and free[kh] <= speed[kh] then
        kind = ON_LOW
      end
    end
    bearing[c] = kind
    if kind ~= 0 then
      local tl, th = kl + other, kh + other
      list.width[c] = min(from[tl] + size[tl], from[th] + size[th]) - max(from[tl], from[th])
      if kind == ON_HIGH then
        chooseSupport(b, list, kl, c, kh)
      else
        chooseSupport(b, list, kh, c, kl)
      end
    end
  end
end

-- Adds the load of contact c: the impulse that was taken off `up` in this step, plus the load that
-- stands on it. At most what its own acceleration made counts as weight; the rest is an impact.
local function addLoad(b, list, c, up, low, sign, dt)
  local mass, start, speed = 1 / b.give[up], b.start[up], b.speed[up]
  local free, air = b.freeSpeed[up] + b.reserve[up], b.flowAir[floor(up * 0.5)]
  if air ~= 0 then -- air friction that would slow its fall bears no load
    free = start + (b.flowPull[up] + b.push[up] - air * (speed - b.carried[up])) * dt
  end
  local impulse, pull = (free - speed) * sign * mass, max((free - start) * sign * mass, 0.0)
  local load = b.load[up] + impulse
  local weight = min(load, b.weight[up] + pull)
  list.load[c], list.weight[c] = load, weight
  b.load[low], b.weight[low] = b.load[low] + load, b.weight[low] + weight
end

-- Sums up the loads from the uppermost bodies down to the supports.
local function sumLoads(b, list, dt)
  local low, high, bearing, bearer = list.low, list.high, list.bearing, b.bearer
  for c = 1, list.count do
    if bearing[c] == ON_HIGH and bearer[low[c]] == c then
      addLoad(b, list, c, low[c], high[c], 1, dt)
    end
  end
  for c = list.count, 1, -1 do
    if bearing[c] == ON_LOW and bearer[high[c]] == c then
      addLoad(b, list, c, high[c], low[c], -1, dt)
    end
  end
end

-- Lets body k rub on ground that moves at `base`. The part of the load that is an impact rubs at
-- once.
local function addGround(b, k, base, mu, load, weight, dt)
  load, weight = mu * load, mu * weight
  local slip, jolt = b.onset[k] - base, (load - weight) * b.give[k]
  if jolt > 0 then
    b.onset[k] = base + (slip > jolt and slip - jolt or slip < -jolt and slip + jolt or 0.0)
  end
  b.base[k], b.grip[k], b.rough[k] = base, weight / dt, mu
  flow.notePulled(b, k)
end

-- Lets contact c rub along the other axis: on ground, or through a bond.
local function addContact(b, list, held, c, dt)
  local axis = list.axis
  local ku, ks = list.low[c], list.high[c]
  if list.bearing[c] == ON_LOW then
    ku, ks = list.high[c], list.low[c]
  end
  local i, j = floor(ku * 0.5), floor(ks * 0.5)
  local mu = friction.coefficient(b, i, j)
  if mu <= 0 or list.load[c] <= 0 then
    return
  end
  local tu, ts = ku + 1 - 2 * axis, ks + 1 - 2 * axis
  if b.give[ts] == 0 then
    local base = b.speed[ts] + carriers.beltSpeed(b, i, j, axis)
    addGround(b, tu, base, mu, list.load[c], list.weight[c], dt)
  else
    bonds.add(b, held, tu, ts, mu * list.load[c])
  end
end

-- Lets all contacts rub, from the supports up.
local function addContacts(b, list, held, dt)
  local bearing, bearer, low, high = list.bearing, b.bearer, list.low, list.high
  for c = list.count, 1, -1 do
    if bearing[c] == ON_HIGH and bearer[low[c]] == c then
      addContact(b, list, held, c, dt)
    end
  end
  for c = 1, list.count do
    if bearing[c] == ON_LOW and bearer[high[c]] == c then
      addContact(b, list, held, c, dt)
    end
  end
end

--- Puts all movable bodies on an axis to where they would be without contacts.
function friction.reset(b, axis, dt)
  local list, from, to, speed, free = b.awakeList, b.from, b.to, b.speed, b.freeSpeed
  local way, carried, accel, start = b.way, b.carried, b.accel, b.start
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    if b.give[k] > 0 then
      to[k], speed[k] = from[k] + way[k] + carried[k] * dt, free[k]
      accel[k] = (free[k] - start[k]) / dt
    end
  end
end

-- Resets the velocities at which bodies begin and end the step if they are alone.
local function resetOwn(b, axis)
  local list, onset, outset = b.awakeList, b.onset, b.outset
  local ownSpeed, free = b.ownSpeed, b.freeSpeed
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    outset[k], ownSpeed[k] = onset[k], free[k]
  end
end

-- Computes the speed limits of all awake bodies, with the velocity of their carriers.
local function findLimits(b)
  local list, carried, reserve, pace = b.awakeList, b.carried, b.reserve, b.pace
  local softSpeed = b.softSpeed
  for n = 1, b.awakeCount do
    for k = 2 * list[n], 2 * list[n] + 1 do
      local most, least = b.fastest[k], b.slowest[k]
      if reserve[k] > 0 then
        most = pace[k]
      elseif reserve[k] < 0 then
        least = pace[k]
      end
      local base = carried[k] + softSpeed[k]
      b.least[k], b.most[k] = least + base, most + base
    end
  end
end

--- Prepares all awake bodies for the step: nothing rubs yet.
function friction.begin(b)
  local list, onset, start, tug = b.awakeList, b.onset, b.start, b.tug
  local grip, base, lead, bondUnder, bondOn = b.grip, b.base, b.lead, b.bondUnder, b.bondOn
  flow.reset(b)
  for n = 1, b.awakeCount do
    for k = 2 * list[n], 2 * list[n] + 1 do
      onset[k], tug[k], grip[k], base[k], lead[k] = start[k], 0, 0, 0, 0
      bondUnder[k], bondOn[k] = 0, 0
    end
  end
  if b.hasLimits then
    findLimits(b)
  end
end

-- Puts all bodies on an axis to where they are with friction, and then against what immovable
-- bodies hold. Notes of an earlier attempt are forgotten, since they may be wrong now.
local function place(b, axis, dt)
  local list, pressed = b.contacts[axis], b.pressed
  for c = 1, list.count do
    pressed[list.pair[c]] = 0
  end
  friction.reset(b, axis, dt)
  resetOwn(b, axis)
  flow.runAll(b, dt)
  settle.hold(b, axis, dt)
end

-- Notes that what an immovable body pushes moves with it from the start of the step.
local function noteHeld(b, axis)
  local list, outset, speed, heldLow, heldHigh =
    b.awakeList, b.outset, b.speed, b.heldLow, b.heldHigh
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    if b.give[k] > 0 and heldLow[k] + heldHigh[k] > 0 then
      outset[k] = speed[k]
    end
  end
end

--- Lets the contacts of an axis, which is settled, rub along the other one, and settles that axis.
--- Returns false, and does nothing, if no contact rubs.
function friction.run(b, axis, dt)
  local list, other, held = b.contacts[axis], 1 - axis, b.bonds[1 - axis]
  findSupports(b, list, axis)
  sumLoads(b, list, dt)
  held.count, held.hasSlips = 0, false
  b.pulledCount, b.forceStamp = 0, b.forceStamp + 1
  addContacts(b, list, held, dt)
  if b.pulledCount == 0 and held.count == 0 then
    return false
  end
  if held.hasSlips then
    place(b, other, dt)
    settle.finish(b, other, dt, false, false)
    noteHeld(b, other)
    bonds.begin(b, held, dt)
  end
  for attempt = 1, ATTEMPTS do
    place(b, other, dt)
    local isGlued = bonds.glue(b, held, dt)
    settle.finish(b, other, dt, isGlued, false)
    local mayChange = isGlued or b.isViolated or held.hasSlips
    if
      attempt == ATTEMPTS
      or not (mayChange and bonds.check(b, b.contacts[other], held, dt, attempt <= TEARS))
    then
      return true
    end
  end
  return true
end

return friction
