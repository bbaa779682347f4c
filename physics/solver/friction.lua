--- Coulomb friction: contacts of one axis rub along the other one.
--
-- The load of a contact is what settling took off the body that leans, and what leans on that. All
-- of it goes to the support under most of the body. A support that cannot be moved along the
-- surface is ground (see flow): the body slides, stops, turns or sticks exactly. One that can be
-- moved has a bond with the body (see bonds).
--
-- Reads contacts, freeSpeed, start; writes base, grip, onset, bonds, and the paths on the rubbed
-- axis.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local bonds = require(root .. ".solver.bonds")
local carrier = require(root .. ".objects.carriers")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")
local interpreted = require(root .. ".memory.jit")
local settle = require(root .. ".solver.settle")

local friction = {}

local EPSILON = columns.EPSILON
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- How often bonds may break, and how often all is tried: in the end bonds only stick.
local TEARS, ATTEMPTS = 4, 8
-- Kinds of support: the low body leans on the high one, or the other way round.
local ON_HIGH, ON_LOW = 1, 2

--- Returns the coefficient of a pair: the geometric mean; an immovable body without one takes the
--- other's.
function friction.coefficient(b, i, j)
  local one, other = b.friction[i], b.friction[j]
  if other < 0 or one == other then
    return max(one, 0)
  elseif one < 0 then
    return other
  end
  return sqrt(one * other)
end

-- Gives body k, of which the contact c is one more support, the one under more of it; of equal ones
-- the first in order.
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

-- Finds which contacts bear a load, and which one bears that of each body.
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
    if over <= EPSILON and over >= -EPSILON then
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

-- Adds the load of contact c: what was taken off `up` in this step, of which at most what its own
-- acceleration made is weight, the rest an impact; and what stands on it.
local function addLoad(b, list, c, up, low, sign, dt)
  local mass, start, speed = 1 / b.give[up], b.start[up], b.speed[up]
  local free, air = b.freeSpeed[up] + b.reserve[up], b.airFriction[floor(up * 0.5)]
  if air ~= 0 then -- what it would be slowed down by, if it fell, does not carry it
    free = start + (b.pull[up] + b.push[up] - air * (speed - b.carried[up])) * dt
  end
  local impulse, pull = (free - speed) * sign * mass, max((free - start) * sign * mass, 0.0)
  local load = b.load[up] + impulse
  local weight = min(load, b.weight[up] + pull)
  list.load[c], list.weight[c] = load, weight
  b.load[low], b.weight[low] = b.load[low] + load, b.weight[low] + weight
end

-- Sums up the loads, from what nothing stands on down to the supports.
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

-- Body k rubs on what cannot be moved and goes at `base`. An impact rubs at once.
local function addGround(b, k, base, mu, load, weight, dt)
  load, weight = mu * load, mu * weight
  local slip, jolt = b.onset[k] - base, (load - weight) * b.give[k]
  if jolt > 0 then
    b.onset[k] = base + (slip > jolt and slip - jolt or slip < -jolt and slip + jolt or 0.0)
  end
  b.base[k], b.grip[k], b.rough[k] = base, weight / dt, mu
  flow.notePulled(b, k)
end

-- Contact c rubs along the other axis.
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
    local base = b.speed[ts] + carrier.beltSpeed(b, i, j, axis)
    addGround(b, tu, base, mu, list.load[c], list.weight[c], dt)
  else
    bonds.add(b, held, tu, ts, mu * list.load[c])
  end
end

-- From the supports on.
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

--- Puts everything along an axis to where it would be without contacts.
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

-- And how it begins, and would end, without the others.
local function resetOwn(b, axis)
  local list, onset, outset = b.awakeList, b.onset, b.outset
  local ownSpeed, free = b.ownSpeed, b.freeSpeed
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    outset[k], ownSpeed[k] = onset[k], free[k]
  end
end

-- Limits of what is awake, with what carries it.
local function findLimits(b)
  local list, limit, carried, reserve, pace = b.awakeList, b.limit, b.carried, b.reserve, b.pace
  local drift = b.drift
  for n = 1, b.awakeCount do
    for k = 2 * list[n], 2 * list[n] + 1 do
      local most, least = limit[k], -limit[k]
      if reserve[k] > 0 then
        most = pace[k]
      elseif reserve[k] < 0 then
        least = pace[k]
      end
      local base = carried[k] + drift[k]
      b.least[k], b.most[k] = least + base, most + base
    end
  end
end

--- Prepares what is awake for the step: nothing rubs yet.
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

-- Everything along an axis as it is with friction, and what immovable bodies hold of that; nothing
-- of an earlier attempt is left, which may have been made for others.
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

-- What an immovable body pushes goes as that does from the start on.
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

--- Lets the contacts of an axis, which is settled, rub along the other one, and settles that.
--- Returns false, and has done nothing, if none rubs.
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
  b.rubs = 1
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

-- These lead from loop to loop.
interpreted.functions(place, friction.run)

return friction
