--- Coulomb friction: contacts of one axis rub along the other one.
--
-- The load of a contact is what settling took off the body that leans, and what leans on that. All
-- of it goes to the support under most of the body. A support that cannot be moved along the surface
-- is a kink in the motion of the body (see flow), so it slides, stops, turns or sticks exactly. A
-- body on a movable one is bonded to it: while friction can do that, both are one block (see pool).
-- Otherwise it slips, and both feel the limit.
--
-- Reads contacts, free, start; writes kinks, force, and the paths on the rubbed axis.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carrier = require(root .. ".objects.carriers")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")
local pool = require(root .. ".solver.pool")
local settle = require(root .. ".solver.settle")

local friction = {}

local EPSILON = columns.EPSILON
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- How often a bond may break before the step goes on with what it has.
local ATTEMPTS = 4
-- Of a bond: both go as one; it slips, and friction does all it can.
local BOND, SLIP = 1, 2
-- Kinds of support: the low body leans on the high one, or the other way round.
local ON_HIGH, ON_LOW = 1, 2

--- Returns an empty list of bonds.
function friction.newBonds()
  return { count = 0, up = {}, low = {}, limit = {}, state = {}, tug = {}, isGlued = {} }
end

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
local function addLoad(b, list, c, up, low, sign)
  local mass = 1 / b.give[up]
  local impulse = (b.freeSpeed[up] - b.speed[up]) * sign * mass
  local pull = max((b.freeSpeed[up] - b.start[up]) * sign * mass, 0.0)
  local load = b.load[up] + impulse
  local weight = min(load, b.weight[up] + pull)
  list.load[c], list.weight[c] = load, weight
  b.load[low], b.weight[low] = b.load[low] + load, b.weight[low] + weight
end

-- Sums up the loads, from what nothing stands on down to the supports.
local function sumLoads(b, list)
  local low, high, bearing, bearer = list.low, list.high, list.bearing, b.bearer
  for c = 1, list.count do
    if bearing[c] == ON_HIGH and bearer[low[c]] == c then
      addLoad(b, list, c, low[c], high[c], 1)
    end
  end
  for c = list.count, 1, -1 do
    if bearing[c] == ON_LOW and bearer[high[c]] == c then
      addLoad(b, list, c, high[c], low[c], -1)
    end
  end
end

-- Prepares body k to be pulled by friction: its own force, and that of an engine as a kink at the
-- speed limit that keeps it from getting faster.
local function addForce(b, k, dt)
  if b.kinks[k] ~= 0 or b.hasForce[k] == b.forceStamp then
    return
  end
  b.hasForce[k] = b.forceStamp
  b.pulledCount = b.pulledCount + 1
  b.pulled[b.pulledCount] = k
  local mass, reserve = 1 / b.give[k], b.reserve[k]
  local force = mass * (b.freeSpeed[k] - b.start[k] + reserve) / dt
  if reserve > 0 and force > 0 then
    b.kinks[k] = flow.add(b, 0, b.pace[k] + b.carried[k], force)
  elseif reserve < 0 and force < 0 then
    b.kinks[k] = flow.add(b, 0, b.pace[k] + b.carried[k], -force)
    force = 0.0
  end
  b.force[k] = force
end

-- Body k rubs on what cannot be moved and goes at `base`.
local function addGround(b, k, base, load, weight, dt)
  addForce(b, k, dt)
  local slip, jolt = b.start[k] - base, (load - weight) * b.give[k]
  if jolt > 0 then -- the impact rubs at once
    b.start[k] = base + (slip > jolt and slip - jolt or slip < -jolt and slip + jolt or 0.0)
  end
  b.kinks[k] = flow.add(b, b.kinks[k], base, 2 * weight / dt)
  b.force[k] = b.force[k] + weight / dt
end

local function addBond(b, bonds, up, low, limit)
  local n = bonds.count + 1
  bonds.count = n
  bonds.up[n], bonds.low[n], bonds.limit[n], bonds.tug[n] = up, low, limit, 0.0
  bonds.isGlued[n] = false
  local slip = b.start[up] - b.start[low]
  bonds.state[n] = max(slip, -slip) <= limit * b.give[up] and BOND or SLIP
end

-- Contact c rubs along the other axis.
local function addContact(b, list, bonds, c, dt)
  local axis = list.axis
  local ku, ks = list.low[c], list.high[c]
  if list.bearing[c] == ON_LOW then
    ku, ks = ks, ku
  end
  local i, j = floor(ku * 0.5), floor(ks * 0.5)
  local mu = friction.coefficient(b, i, j)
  if mu <= 0 or list.load[c] <= 0 then
    return
  end
  local tu, ts = ku + 1 - 2 * axis, ks + 1 - 2 * axis
  local load, weight = mu * list.load[c], mu * list.weight[c]
  if b.give[ts] == 0 then
    local base = b.speed[ts] + carrier.beltSpeed(b, i, j, axis)
    addGround(b, tu, base, load, weight, dt)
  else
    addBond(b, bonds, tu, ts, load)
  end
end

-- From the supports on.
local function addContacts(b, list, bonds, dt)
  local bearing, bearer, low, high = list.bearing, b.bearer, list.low, list.high
  for c = list.count, 1, -1 do
    if bearing[c] == ON_HIGH and bearer[low[c]] == c then
      addContact(b, list, bonds, c, dt)
    end
  end
  for c = 1, list.count do
    if bearing[c] == ON_LOW and bearer[high[c]] == c then
      addContact(b, list, bonds, c, dt)
    end
  end
end

-- The path of body k under what pulls it.
local function run(b, k, tug, dt)
  local mass = 1 / b.give[k]
  local v, way = flow.run(b, b.kinks[k], mass, b.force[k] + tug / dt, b.start[k], dt)
  return v, way
end

local function runAll(b, dt)
  for n = 1, b.pulledCount do
    local k = b.pulled[n]
    local v, way = run(b, k, 0, dt)
    b.speed[k], b.to[k], b.accel[k] = v, b.from[k] + way, (v - b.start[k]) / dt
  end
end

-- A bond slips with an impulse of `tug` on the upper one: adds that to both.
local function pull(b, bonds, n, tug, dt)
  local up, low, change = bonds.up[n], bonds.low[n], tug - bonds.tug[n]
  addForce(b, up, dt)
  addForce(b, low, dt)
  b.force[up], b.force[low] = b.force[up] + change / dt, b.force[low] - change / dt
  bonds.tug[n] = tug
end

-- A bond that slips from the start on: friction does all it can against that. If that would turn the
-- slip round, the two go on as one.
local function slide(b, bonds, n, dt)
  local slip = b.start[bonds.up[n]] - b.start[bonds.low[n]]
  local limit = slip > 0 and -bonds.limit[n] or bonds.limit[n]
  pull(b, bonds, n, limit, dt)
  local last = (run(b, bonds.up[n], 0, dt)) - (run(b, bonds.low[n], 0, dt))
  if last * slip < 0 then
    pull(b, bonds, n, 0.0, dt)
    bonds.state[n] = BOND
  end
end

local function slideAll(b, bonds, dt)
  for n = 1, bonds.count do
    if bonds.state[n] == SLIP then
      slide(b, bonds, n, dt)
    end
  end
end

-- Marks what is bonded, directly or through others, to a body that would not go along by itself.
-- Returns whether there is any.
local function markTowers(b, bonds)
  local mark, stamp, any = b.bondMark, b.forceStamp, false
  for n = 1, bonds.count do
    local up, low = bonds.up[n], bonds.low[n]
    if bonds.state[n] == BOND then
      local isEven = b.speed[up] == b.speed[low]
        and b.to[up] - b.from[up] == b.to[low] - b.from[low]
      if bonds.isGlued[n] or not isEven then
        mark[up], mark[low], any = stamp, stamp, true
      end
    end
  end
  for n = any and bonds.count or 0, 1, -1 do
    if bonds.state[n] == BOND and mark[bonds.up[n]] == stamp then
      mark[bonds.low[n]] = stamp
    end
  end
  for n = 1, any and bonds.count or 0 do
    if bonds.state[n] == BOND and mark[bonds.low[n]] == stamp then
      mark[bonds.up[n]] = stamp
    end
  end
  return any
end

-- Makes blocks of the bonds that are needed. Returns whether there are any.
local function glue(b, bonds, dt)
  local mark, stamp = b.bondMark, b.forceStamp
  if not markTowers(b, bonds) then
    return false
  end
  for n = 1, bonds.count do
    local up, low = bonds.up[n], bonds.low[n]
    if bonds.state[n] == BOND and mark[up] == stamp and mark[low] == stamp then
      bonds.isGlued[n] = true
      pool.glue(b, up, low, dt)
    end
  end
  return true
end

-- Which bodies of an axis are pressed by others: what a bond has to do there is not known.
local function findPressed(b, list, awakeCount)
  local awake, isPressed, axis = b.awakeList, b.isPressed, list.axis
  for n = 1, awakeCount do
    isPressed[2 * awake[n] + axis] = false
  end
  for c = 1, list.count do
    if b.pressed[list.pair[c]] == 1 then
      isPressed[list.low[c]], isPressed[list.high[c]] = true, true
    end
  end
end

-- Looks from the top down whether friction can do what the bonds ask for, and which bonds are asked
-- that were not. Returns whether something has changed.
local function check(b, list, bonds)
  local need, isPressed, hasChanged = b.load, b.isPressed, false
  findPressed(b, list, b.awakeCount)
  for n = 1, bonds.count do
    local up, low = bonds.up[n], bonds.low[n]
    need[up], need[low] = 0, 0
  end
  for n = bonds.count, 1, -1 do
    local up, low, limit = bonds.up[n], bonds.low[n], bonds.limit[n]
    if bonds.state[n] == BOND then
      local own = b.hasForce[up] == b.forceStamp and b.ownSpeed[up] or b.freeSpeed[up]
      local impulse = need[up] + (b.speed[up] - own) / b.give[up]
      if not isPressed[up] and max(impulse, -impulse) > limit * (1 + 1e-9) + 1e-12 then
        bonds.state[n], hasChanged = SLIP, true
        b.breaking[n] = impulse > 0 and limit or -limit
      elseif not bonds.isGlued[n] and b.speed[up] ~= b.speed[low] then
        bonds.isGlued[n], hasChanged = true, true
      end
      need[low] = need[low] + impulse
      isPressed[low] = isPressed[low] or isPressed[up]
    end
  end
  return hasChanged
end

-- Everything along an axis as it would be without contacts.
local function reset(b, axis, dt)
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

friction.reset = reset

-- Bonds that broke pull with all they can.
local function breakBonds(b, bonds, dt)
  for n = 1, bonds.count do
    local tug = b.breaking[n]
    if tug then
      pull(b, bonds, n, tug, dt)
      b.breaking[n] = false
    end
  end
end

--- Lets the contacts of an axis, which is settled, rub along the other one, and settles that. Returns
--- false, and has done nothing, if none rubs.
function friction.run(b, axis, dt)
  local list, other, bonds = b.contacts[axis], 1 - axis, b.bonds
  findSupports(b, list, axis)
  sumLoads(b, list)
  bonds.count, b.pulledCount, b.forceStamp = 0, 0, b.forceStamp + 1
  addContacts(b, list, bonds, dt)
  if b.pulledCount == 0 and bonds.count == 0 then
    return false
  end
  b.rubs = 1
  slideAll(b, bonds, dt)
  for attempt = 1, ATTEMPTS do
    reset(b, other, dt)
    runAll(b, dt)
    for n = 1, b.pulledCount do
      b.ownSpeed[b.pulled[n]] = b.speed[b.pulled[n]]
    end
    settle.hold(b, other, dt)
    local isGlued = glue(b, bonds, dt)
    settle.finish(b, other, dt, isGlued)
    if attempt == ATTEMPTS or not check(b, b.contacts[other], bonds) then
      return true
    end
    breakBonds(b, bonds, dt)
  end
  return true
end

return friction
