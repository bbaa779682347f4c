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
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")
local pool = require(root .. ".solver.pool")
local settle = require(root .. ".solver.settle")

local friction = {}

local EPSILON = columns.EPSILON
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- How often bonds may break, and how often all is tried: in the end bonds only stick.
local TEARS, ATTEMPTS = 4, 8
-- Of a bond: both go as one; it slips, and friction does all it can; it has, and they go as one now.
local BOND, SLIP, STUCK = 1, 2, 3
-- Kinds of support: the low body leans on the high one, or the other way round.
local ON_HIGH, ON_LOW = 1, 2

--- Returns an empty list of bonds.
function friction.newBonds()
  return { count = 0, up = {}, low = {}, limit = {}, state = {}, tug = {}, isGlued = {}, slipped = {}, onset = {}, next = {} }
end

--- Returns whether bond n holds its bodies together, or has done so before an impact.
function friction.holds(bonds, n)
  return bonds.state[n] ~= SLIP
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

-- Notes that body k does not go as it would by itself.
local function addPulled(b, k)
  b.pulledCount = b.pulledCount + 1
  b.pulled[b.pulledCount] = k
end

-- Body k rubs on what cannot be moved and goes at `base`. An impact rubs at once.
local function addGround(b, k, base, mu, load, weight, dt)
  load, weight = mu * load, mu * weight
  local slip, jolt = b.onset[k] - base, (load - weight) * b.give[k]
  if jolt > 0 then
    b.onset[k] = base + (slip > jolt and slip - jolt or slip < -jolt and slip + jolt or 0.0)
  end
  b.base[k], b.grip[k], b.rough[k] = base, weight / dt, mu
  addPulled(b, k)
end

-- A bond slips, with an impulse of `tug` on the upper one.
local function pull(b, bonds, n, tug)
  local up, low, change = bonds.up[n], bonds.low[n], tug - bonds.tug[n]
  b.tug[up], b.tug[low], bonds.tug[n] = b.tug[up] + change, b.tug[low] - change, tug
  addPulled(b, up)
  addPulled(b, low)
end

-- Body `up` rubs on `low`, which can be moved.
local function addBond(b, bonds, up, low, limit)
  local n = bonds.count + 1
  bonds.count = n
  bonds.up[n], bonds.low[n], bonds.limit[n], bonds.tug[n] = up, low, limit, 0.0
  bonds.isGlued[n], bonds.slipped[n], bonds.state[n] = false, 0.0, BOND
  if b.onset[up] ~= b.onset[low] then
    bonds.state[n], bonds.hasSlips = SLIP, true
  end
  b.bondUnder[up], bonds.next[n], b.bondOn[low] = n, b.bondOn[low], n
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
  if b.give[ts] == 0 then
    local base = b.speed[ts] + (axis == 1 and b.surfaceSpeed[j] or 0)
    addGround(b, tu, base, mu, list.load[c], list.weight[c], dt)
  else
    addBond(b, bonds, tu, ts, mu * list.load[c])
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

-- Bond n has slipped `way` px until both are as fast, and they go on as one. If the lower one is not
-- moved by that (`stands`), the upper one takes its speed; else both share their momentum.
local function stick(b, bonds, n, way, stands)
  local up, low = bonds.up[n], bonds.low[n]
  bonds.state[n], bonds.isGlued[n] = STUCK, true
  if stands then
    bonds.onset[n] = b.onset[up]
    b.lead[up], b.onset[up] = b.lead[low] + way, b.onset[low]
    addPulled(b, up)
  else
    bonds.onset[n], bonds.slipped[n] = b.onset[up], way
  end
end

-- Friction cannot do what bond n asks for.
local function tear(b, bonds, n, tug)
  if bonds.state[n] == STUCK then
    local up = bonds.up[n]
    b.onset[up], b.lead[up], bonds.slipped[n] = bonds.onset[n], 0.0, 0.0
  end
  bonds.state[n] = SLIP
  pull(b, bonds, n, tug)
end

-- Whether body k stands on the ground, or on what does, when something on it pulls it with `limit`.
local function standsFast(b, bonds, k, limit, dt)
  local n = b.bondUnder[k]
  while n ~= 0 do
    local low = bonds.low[n]
    if b.outset[k] ~= b.outset[low] or bonds.limit[n] < limit then
      return false
    end
    k = low
    n = b.bondUnder[k]
  end
  return b.grip[k] * dt >= limit and b.outset[k] == b.base[k]
end

-- Decides how bond n begins, of which the upper body slips on the lower one, and drives `burden` kg.
local function slide(b, bonds, n, burden, dt)
  local up, low, limit = bonds.up[n], bonds.low[n], bonds.limit[n]
  local slip, stands = b.outset[up] - b.outset[low], standsFast(b, bonds, low, limit, dt)
  local drive, give = flow.drive(b, up, dt), 1 / burden
  if not stands then
    drive, give = drive - flow.drive(b, low, dt), give + b.give[low]
  end
  local size, rate = max(slip, -slip), limit * give / dt + (slip > 0 and -drive or drive)
  if size == 0 then
    bonds.state[n] = BOND
  elseif size <= rate * dt then
    stick(b, bonds, n, slip * size / rate * 0.5, stands)
  else
    pull(b, bonds, n, slip > 0 and -limit or limit)
  end
end

-- From the top down, with what each bond drives: what does not slip on it.
local function slideAll(b, bonds, dt)
  local burden, give = b.burden, b.give
  for n = 1, bonds.count do
    local up, low = bonds.up[n], bonds.low[n]
    burden[up], burden[low] = 1 / give[up], 1 / give[low]
  end
  for n = bonds.count, 1, -1 do
    local up, low = bonds.up[n], bonds.low[n]
    if bonds.state[n] == SLIP then
      slide(b, bonds, n, burden[up], dt)
    end
    if bonds.state[n] ~= SLIP then
      burden[low] = burden[low] + burden[up]
    end
  end
end

-- The paths of all that friction and limits act on, as far as contacts leave them alone.
local function runAll(b, dt)
  for n = 1, b.pulledCount do
    local k = b.pulled[n]
    local onset = b.onset[k]
    local v, way = flow.body(b, k, onset, dt, dt)
    b.speed[k], b.to[k], b.accel[k] = v, b.from[k] + b.lead[k] + way, (v - onset) / dt
    b.ownSpeed[k] = v
  end
end

-- Marks what is bonded, directly or through others, to a body that would not go along by itself.
-- Returns whether there is any.
local function markTowers(b, bonds)
  local mark, stamp, any = b.bondMark, b.forceStamp, false
  for n = 1, bonds.count do
    local up, low = bonds.up[n], bonds.low[n]
    if bonds.state[n] ~= SLIP then
      local isEven = b.speed[up] == b.speed[low]
        and b.to[up] - b.from[up] == b.to[low] - b.from[low]
      if bonds.isGlued[n] or not isEven then
        mark[up], mark[low], any = stamp, stamp, true
      end
    end
  end
  for n = any and bonds.count or 0, 1, -1 do
    if bonds.state[n] ~= SLIP and mark[bonds.up[n]] == stamp then
      mark[bonds.low[n]] = stamp
    end
  end
  for n = 1, any and bonds.count or 0 do
    if bonds.state[n] ~= SLIP and mark[bonds.low[n]] == stamp then
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
    if bonds.state[n] ~= SLIP and mark[up] == stamp and mark[low] == stamp then
      bonds.isGlued[n] = true
      if bonds.state[n] == BOND and b.lead[up] ~= b.lead[low] then -- it goes along with one that has stuck to what stands
        b.lead[up], b.onset[up] = b.lead[low], b.onset[low]
      end
      pool.glue(b, up, low, bonds.slipped[n], dt)
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

-- Looks from the top down whether friction can do what the bonds ask for, which bonds are asked that
-- were not, and which have slipped to their end. Returns whether something has changed.
local function check(b, list, bonds, dt, mayTear)
  local need, isPressed, hasChanged = b.load, b.isPressed, false
  local speed, outset = b.speed, b.outset
  findPressed(b, list, b.awakeCount)
  for n = 1, bonds.count do
    local up, low = bonds.up[n], bonds.low[n]
    need[up], need[low] = 0, 0
  end
  for n = bonds.count, 1, -1 do
    local up, low, limit, state = bonds.up[n], bonds.low[n], bonds.limit[n], bonds.state[n]
    if state == SLIP then
      local slip, last = outset[up] - outset[low], speed[up] - speed[low]
      if last * bonds.tug[n] > 0 then -- friction would have turned the slip round
        local way = slip * last < 0 and slip * slip / (slip - last) * 0.5 * dt or 0.0
        pull(b, bonds, n, 0.0)
        stick(b, bonds, n, way, speed[low] == outset[low])
        hasChanged = true
      end
    else
      local impulse = need[up] + (speed[up] - b.ownSpeed[up]) / b.give[up]
      local isTorn = mayTear and max(impulse, -impulse) > limit * (1 + 1e-9) + 1e-12
      if isTorn and not isPressed[up] then
        impulse = impulse > 0 and limit or -limit
        tear(b, bonds, n, impulse)
        hasChanged = true
      elseif not bonds.isGlued[n] and speed[up] ~= speed[low] then
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
  for n = 1, b.awakeCount do
    for k = 2 * list[n], 2 * list[n] + 1 do
      local most, least = limit[k], -limit[k]
      if reserve[k] > 0 then
        most = pace[k]
      elseif reserve[k] < 0 then
        least = pace[k]
      end
      b.least[k], b.most[k] = least + carried[k], most + carried[k]
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

-- Everything along an axis as it is with friction, but without contacts.
local function place(b, axis, dt)
  reset(b, axis, dt)
  resetOwn(b, axis)
  runAll(b, dt)
  settle.hold(b, axis, dt)
end

-- What an immovable body pushes goes as that does from the start on.
local function noteHeld(b, axis)
  local list, outset, speed, heldLow, heldHigh = b.awakeList, b.outset, b.speed, b.heldLow, b.heldHigh
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    if b.give[k] > 0 and heldLow[k] + heldHigh[k] > 0 then
      outset[k] = speed[k]
    end
  end
end

--- Lets the contacts of an axis, which is settled, rub along the other one, and settles that. Returns
--- false, and has done nothing, if none rubs.
function friction.run(b, axis, dt)
  local list, other, bonds = b.contacts[axis], 1 - axis, b.bonds[1 - axis]
  findSupports(b, list, axis)
  sumLoads(b, list, dt)
  bonds.count, bonds.hasSlips = 0, false
  b.pulledCount, b.forceStamp = 0, b.forceStamp + 1
  addContacts(b, list, bonds, dt)
  if b.pulledCount == 0 and bonds.count == 0 then
    return false
  end
  b.rubs = 1
  if bonds.hasSlips then
    place(b, other, dt)
    settle.finish(b, other, dt, false)
    noteHeld(b, other)
    slideAll(b, bonds, dt)
  end
  for attempt = 1, ATTEMPTS do
    place(b, other, dt)
    local isGlued = glue(b, bonds, dt)
    settle.finish(b, other, dt, isGlued)
    local mayChange = isGlued or b.isViolated or bonds.hasSlips
    if attempt == ATTEMPTS or not (mayChange and check(b, b.contacts[other], bonds, dt, attempt <= TEARS)) then
      return true
    end
  end
  return true
end

return friction
