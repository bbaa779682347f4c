--- Blocks: computes from the contacts of an axis which free bodies move as one, and their common
-- velocity.
--
-- Source: pool adjacent violators, which solves isotonic regression (R. E. Barlow et al.,
-- Statistical Inference under Order Restrictions, 1972). Walk along the contacts, and join two
-- blocks that overlap into one with their common momentum. Bodies are in a forest (union-find).
-- Each body has its offset from the root of its block, so that a block stays flush. Friction and
-- engines of its members act on a block as kinks (see flow.lua).
--
-- A block that is stronger (see `strength`) pushes a weaker one as if that had a fifth of its mass,
-- and is not moved by it. A body that is not pushable is *firm*: a block with a firm body moves as
-- that body does. If two firm blocks meet, the one that comes from behind follows; if they meet
-- head-on, both stop.
--
-- Reads contacts, give, onset, and to, speed, accel; writes to, speed, accel, pressed, outset, and
-- what holds the bodies (heldLow, heldHigh, holderLow, holderHigh).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")

local pool = {}

local EPSILON = columns.EPSILON
local floor, max, min = math.floor, math.max, math.min
local HUGE = math.huge
-- Maximum number of walks along the contacts, forwards and backwards.
local PASSES = 8
-- What is pushed by something stronger counts as this share of its mass.
local WEAK = 0.2
-- Maximum number of times that blocks are made anew because two of their bodies overlap.
local TEARS = 4

--- Returns whether an elastic pair bounces: it closes faster than its acceleration alone would make
--- it close in two steps (`slow` s).
function pool.bounces(closing, accel, slow)
  return closing > (accel < 0 and -accel or accel) * slow
end

-- Returns the root of the block of k, and the offset of k from it, px.
local function find(b, k)
  local parent, offset = b.parent, b.offset
  local top, way = k, 0.0
  while parent[top] ~= 0 and parent[top] ~= top do
    way = way + offset[top]
    top = parent[top]
  end
  if top ~= k then
    parent[k], offset[k] = top, way
  end
  return top, way
end

-- Makes a block of one body, unless it is in one or cannot be moved.
local function register(b, k, dt)
  if b.parent[k] ~= 0 or b.give[k] == 0 then
    return
  end
  local n, mass, onset = b.memberCount + 1, 1 / b.give[k], b.onset[k]
  b.memberCount, b.members[n] = n, k
  b.parent[k], b.offset[k] = k, 0.0
  b.blockMass[k], b.blockShift[k] = mass, 0.0
  b.blockMomentum[k], b.blockSpeed[k] = mass * onset, mass * b.speed[k]
  b.blockForce[k] = mass * flow.drive(b, k, dt)
  local base, grip = b.base[k], b.grip[k]
  b.blockKinks[k] = grip > 0 and flow.newKink(b, base, grip) or 0
  b.blockStand[k] = grip > 0 and base == onset and base or HUGE
  b.blockLeast[k], b.blockMost[k] = b.least[k], b.most[k]
  b.isFirm[k] = not b.pushable[floor(k * 0.5)]
  b.blockPower[k] = b.power[floor(k * 0.5)]
end

-- Returns where a block was at the start of the step.
local function origin(b, k)
  return b.from[k] + b.lead[k] + b.blockShift[k] / b.blockMass[k]
end

-- Returns the velocity at the end of the step of a block that starts at v, and its displacement,
-- px.
local function fly(b, k, v, dt)
  local mass, least, most = b.blockMass[k], b.blockLeast[k], b.blockMost[k]
  return flow.run(b, b.blockKinks[k], mass, b.blockForce[k], v, dt, least, most)
end

-- Computes the end of a block from the sums at its root k. A block that friction can hold in place
-- does not move: what pushes it pushes anew in each step.
local function finish(b, k, dt, isLate, place)
  local mass, least, most = b.blockMass[k], b.blockLeast[k], b.blockMost[k]
  if isLate then
    b.to[k], b.speed[k] = place, max(min(b.blockSpeed[k] / mass, most), least)
    return
  elseif b.blockKinks[k] == 0 and least == -HUGE and most == HUGE then
    b.to[k], b.speed[k] = place, b.blockSpeed[k] / mass
    return
  end
  local v, way = fly(b, k, b.blockMomentum[k] / mass, dt)
  way = v == b.blockStand[k] and v * dt or way
  b.to[k], b.speed[k] = origin(b, k) + way, v
end

-- Returns where the block of two ends, as the place of `one`, if `other` is `off` px from it: at
-- their common centre of mass. If only one of them gives way (`push = "first"`), the block ends at
-- the place of the one that was run into.
local function meetingPlace(b, one, other, off, isFirst)
  local massOne, massOther, to = b.blockMass[one], b.blockMass[other], b.to
  if isFirst then
    local towards, against = to[one] - origin(b, one), origin(b, other) - to[other]
    local more = towards - against
    local isEven = more <= EPSILON and more >= -EPSILON
    local yields = isEven and b.rank[floor(one * 0.5)] < b.rank[floor(other * 0.5)]
    return (yields or more > EPSILON) and to[other] - off or to[one]
  end
  return (massOne * to[one] + massOther * (to[other] - off)) / (massOne + massOther)
end

-- Joins two blocks into one. `other` is `off` px from `one`.
local function join(b, one, other, off, dt, isLate, isFirst)
  local massOne, massOther = b.blockMass[one], b.blockMass[other]
  local mass = massOne + massOther
  local place = meetingPlace(b, one, other, off, isFirst)
  b.accel[one] = (massOne * b.accel[one] + massOther * b.accel[other]) / mass
  b.blockMass[one] = mass
  b.blockMomentum[one] = b.blockMomentum[one] + b.blockMomentum[other]
  b.blockSpeed[one] = b.blockSpeed[one] + b.blockSpeed[other]
  b.blockForce[one] = b.blockForce[one] + b.blockForce[other]
  local apart = b.from[other] + b.lead[other] - (b.from[one] + b.lead[one])
  b.blockShift[one] = b.blockShift[one] + b.blockShift[other] + massOther * (apart - off)
  b.blockKinks[one] = flow.merge(b, b.blockKinks[one], b.blockKinks[other])
  b.blockLeast[one] = max(b.blockLeast[one], b.blockLeast[other])
  b.blockMost[one] = min(b.blockMost[one], b.blockMost[other])
  b.blockStand[one] = min(b.blockStand[one], b.blockStand[other])
  b.isFirm[one] = b.isFirm[one] or b.isFirm[other]
  b.blockPower[one] = max(b.blockPower[one], b.blockPower[other])
  b.parent[other], b.offset[other] = one, off
  if b.heldLow[other] > 0 then
    b.heldLow[one], b.holderLow[one] = b.heldLow[one] + b.heldLow[other], b.holderLow[other]
  end
  if b.heldHigh[other] > 0 then
    b.heldHigh[one], b.holderHigh[one] = b.heldHigh[one] + b.heldHigh[other], b.holderHigh[other]
  end
  finish(b, one, dt, isLate, place)
end

--- Decides which of two firm bodies gives way when they press each other; the low one moves at vl,
--- the high one at vh. Returns whether the low one stays, and whether the high one does.
function pool.meetFirm(vl, vh)
  return vl <= 0 or vh < 0, vh >= 0 or vl > 0
end

-- Returns whether the low block keeps its motion in this contact, and whether the high one does.
-- The stronger one does unless it moves towards the other one.
local function weigh(b, low, high)
  local stayLow, stayHigh = b.heldLow[low] > 0, b.heldHigh[high] > 0
  if stayLow or stayHigh then
    return stayLow, stayHigh
  elseif not (b.isFirm[low] or b.isFirm[high]) then
    local powerLow, powerHigh = b.blockPower[low], b.blockPower[high]
    return powerLow > powerHigh and b.speed[low] <= 0, powerHigh > powerLow and b.speed[high] >= 0
  elseif b.isFirm[low] and b.isFirm[high] then
    return pool.meetFirm(b.speed[low], b.speed[high])
  end
  return b.isFirm[low], b.isFirm[high]
end

-- Stops two firm blocks that meet head-on where they were. Returns whether one of them had moved.
local function stopBoth(b, low, high)
  local hasMoved = false
  if b.isFirm[low] and b.isFirm[high] and b.heldLow[low] == 0 and b.heldHigh[high] == 0 then
    for side = 1, 2 do
      local k = side == 1 and low or high
      local place = origin(b, k)
      hasMoved = hasMoved or b.to[k] ~= place
      b.to[k], b.speed[k], b.accel[k] = place, 0.0, 0.0
    end
  end
  return hasMoved
end

--- Returns the speed of a body that is held by one that moves at `base` and pressed against it by
--- another. The speed is `base`, or the common speed of the two bodies if that leads away from the
--- holder. `sign`: 1 if it is held on its low side.
function pool.heldSpeed(mass, speed, otherMass, otherSpeed, base, sign)
  local v = (mass * speed + otherMass * otherSpeed) / (mass + otherMass)
  return (v - base) * sign > 0 and v or base
end

-- Returns the same for two blocks.
local function heldSpeed(b, held, other, base, sign)
  local mass, speed = b.blockMass, b.speed
  return pool.heldSpeed(mass[held], speed[held], mass[other], speed[other], base, sign)
end

--- Notes that body kl, or a block, leans on kh towards high coordinates: what holds kh holds it,
--- too.
function pool.leanHigh(b, kl, kh)
  if b.heldHigh[kh] > 0 then
    b.heldHigh[kl] = b.heldHigh[kh] + 1
    b.holderHigh[kl] = b.give[kh] > 0 and b.holderHigh[kh] or kh
  end
end

--- Notes the same for kh, which leans on kl towards low coordinates.
function pool.leanLow(b, kl, kh)
  if b.heldLow[kl] > 0 then
    b.heldLow[kh] = b.heldLow[kl] + 1
    b.holderLow[kh] = b.give[kl] > 0 and b.holderLow[kl] or kl
  end
end

-- Resolves a contact in which at least one block stays, because it is firm or held. The other block
-- takes the whole push, and becomes firm if a firm block pushes it. Returns whether something has
-- changed.
local function yield(b, low, high, offLow, offHigh, separation, stayLow, stayHigh)
  if stayLow and stayHigh then
    b.isClamped = b.isClamped or b.heldLow[low] > 0 and b.heldHigh[high] > 0
    return stopBoth(b, low, high)
  elseif stayHigh then
    b.to[low] = b.to[high] + offHigh - separation - offLow
    if b.speed[low] > b.speed[high] then
      local base = b.heldHigh[high] > 0 and b.give[high] > 0 and b.speed[b.holderHigh[high]]
      if base and b.speed[high] < base then
        b.speed[high] = heldSpeed(b, high, low, base, -1)
      end
      b.speed[low], b.accel[low] = b.speed[high], b.accel[high]
    end
    pool.leanHigh(b, low, high)
    b.isFirm[low] = b.isFirm[low] or b.isFirm[high] and b.heldHigh[high] == 0
    b.blockPower[low] = max(b.blockPower[low], b.blockPower[high])
  else
    b.to[high] = b.to[low] + offLow + separation - offHigh
    if b.speed[low] > b.speed[high] then
      local base = b.heldLow[low] > 0 and b.give[low] > 0 and b.speed[b.holderLow[low]]
      if base and b.speed[low] > base then
        b.speed[low] = heldSpeed(b, low, high, base, 1)
      end
      b.speed[high], b.accel[high] = b.speed[low], b.accel[low]
    end
    pool.leanLow(b, low, high)
    b.isFirm[high] = b.isFirm[high] or b.isFirm[low] and b.heldLow[low] == 0
    b.blockPower[high] = max(b.blockPower[low], b.blockPower[high])
  end
  return true
end

-- A block that something stronger pushes, to high coordinates (`sign` 1) or low ones (-1): its mass
-- counts as a share of what it is, and what it does against the push not at all.
local function weaken(b, k, sign)
  local start = origin(b, k)
  b.to[k] = start + sign * max((b.to[k] - start) * sign, 0)
  b.blockMass[k], b.blockShift[k] = b.blockMass[k] * WEAK, b.blockShift[k] * WEAK
  b.blockMomentum[k] = sign * max(b.blockMomentum[k] * sign, 0) * WEAK
  b.blockSpeed[k] = sign * max(b.blockSpeed[k] * sign, 0) * WEAK
  b.blockForce[k] = sign * max(b.blockForce[k] * sign, 0) * WEAK
  b.blockLeast[k], b.blockMost[k] = -HUGE, HUGE
end

-- Weakens the weaker one of two blocks. Returns whether there is one.
local function weakenOne(b, low, high)
  local powerLow, powerHigh = b.blockPower[low], b.blockPower[high]
  if powerLow > powerHigh then
    weaken(b, high, 1)
  elseif powerHigh > powerLow then
    weaken(b, low, -1)
  end
  return powerLow ~= powerHigh
end

--- Shares of a push for two of different power that both can give way, of which the low one goes at
--- vl and the high one at vh: what is stronger is not moved by what runs into it, and pushes the
--- other one as in `weaken`. `wl`, `wh`: their inverse masses.
function pool.share(isLow, wl, wh, vl, vh)
  local strong, weak, v, other = wl, wh, vl, vh
  if not isLow then
    strong, weak, v, other = wh, wl, -vh, -vl
  end
  weak = weak / WEAK
  local total = strong + weak
  local lost = v > 0 and v - (v * weak + max(other, 0) * strong) / total or 0.0
  local share = lost > 0 and min(lost / (v - other), 1) or 0.0
  strong, weak = share * total, (1 - share) * total
  return isLow and strong or weak, isLow and weak or strong
end

-- Moves two blocks apart that have bounced and overlap only because others pushed them since.
-- Speeds stay as they are.
local function shift(b, low, high, over)
  local massLow, massHigh = b.blockMass[low], b.blockMass[high]
  local share = over / (massLow + massHigh)
  b.to[low] = b.to[low] - share * massHigh
  b.to[high] = b.to[high] + share * massLow
end

-- Gives two blocks that touch at the start of the step, and close, a common velocity at once, if
-- they separate again from there. The second is `off` px from the first. Returns false, and changes
-- nothing, if they do not touch or would stay together: then they become one block.
local function leave(b, low, high, off, dt)
  local massLow, massHigh = b.blockMass[low], b.blockMass[high]
  local startLow, startHigh = b.blockMomentum[low] / massLow, b.blockMomentum[high] / massHigh
  local gap = origin(b, high) - origin(b, low) - off
  if gap > EPSILON or gap < -EPSILON or startLow <= startHigh then
    return false
  end
  local v = (b.blockMomentum[low] + b.blockMomentum[high]) / (massLow + massHigh)
  local vLow, wayLow = fly(b, low, v, dt)
  local vHigh, wayHigh = fly(b, high, v, dt)
  if wayLow >= wayHigh then
    return false
  end
  b.blockMomentum[low], b.blockMomentum[high] = massLow * v, massHigh * v
  b.blockSpeed[low], b.blockSpeed[high] = massLow * vLow, massHigh * vHigh
  b.to[low], b.speed[low], b.accel[low] = origin(b, low) + wayLow, vLow, (vLow - v) / dt
  b.to[high], b.speed[high], b.accel[high] = origin(b, high) + wayHigh, vHigh, (vHigh - v) / dt
  return true
end

-- Resolves contact c if it is violated. Returns whether something has changed.
local function look(b, list, c, dt, isLate)
  local kl, kh = list.low[c], list.high[c]
  if b.give[kl] == 0 and b.give[kh] == 0 then
    return false
  end
  local low, offLow = find(b, kl)
  local high, offHigh = find(b, kh)
  local separation = list.separation[c]
  if low == high then
    b.isTorn = b.isTorn or offLow + separation - offHigh > EPSILON
    return false
  end
  local over = b.to[low] + offLow + separation - b.to[high] - offHigh
  local closing = b.speed[low] - b.speed[high]
  -- With `push = "first"` a block may have speed but not move: it presses on all the same.
  if over <= EPSILON then
    -- What is held is made exactly flush.
    local isHeld = over > 0 and (b.heldLow[low] > 0 or b.heldHigh[high] > 0)
    if closing <= 0 or not (isHeld or (b.pushFirst and over >= -EPSILON)) then
      return false
    end
  end
  if list.elastic[c] == 1 and pool.bounces(closing, b.accel[low] - b.accel[high], 2 * dt) then
    return false
  end
  register(b, kl, dt)
  register(b, kh, dt)
  b.pressed[list.pair[c]] = 1
  local stayLow, stayHigh = weigh(b, low, high)
  if stayLow or stayHigh then
    return yield(b, low, high, offLow, offHigh, separation, stayLow, stayHigh)
  elseif closing <= 0 and list.elastic[c] == 1 then
    shift(b, low, high, over)
  elseif weakenOne(b, low, high) then
    join(b, low, high, offLow + separation - offHigh, dt, isLate, b.pushFirst)
  elseif isLate or not leave(b, low, high, offLow + separation - offHigh, dt) then
    join(b, low, high, offLow + separation - offHigh, dt, isLate, b.pushFirst)
  end
  return true
end

-- Gives the members of each block its path, and ends all blocks.
local function spread(b)
  local members, parent = b.members, b.parent
  for n = 1, b.memberCount do
    local k = members[n]
    local top, off = find(b, k)
    if top ~= k then
      b.to[k], b.speed[k], b.accel[k] = b.to[top] + off, b.speed[top], b.accel[top]
      b.heldLow[k], b.heldHigh[k] = b.heldLow[top], b.heldHigh[top]
      b.holderLow[k], b.holderHigh[k] = b.holderLow[top], b.holderHigh[top]
    end
    b.outset[k] = b.blockMomentum[top] / b.blockMass[top]
  end
  for n = 1, b.memberCount do
    parent[members[n]] = 0
  end
  b.memberCount = 0
end

--- Makes one block of kUp and kLow, because friction holds the upper one to the lower one after it
--- has slipped `slipped` px.
function pool.glue(b, kUp, kLow, slipped, dt)
  register(b, kUp, dt)
  register(b, kLow, dt)
  local up, offUp = find(b, kUp)
  local low, offLow = find(b, kLow)
  if up ~= low then
    local apart = b.from[kUp] + b.lead[kUp] - (b.from[kLow] + b.lead[kLow]) + slipped
    join(b, low, up, offLow + apart - offUp, dt, false, false)
    b.heldLow[low], b.heldHigh[low] = 0, 0 -- its contacts decide that again
  end
end

-- Returns the next contact from place c on that may be violated at the end of the step. Its bodies
-- overlap by more than `least` px, or one of them is in a block. (The place of a member of a block
-- is not known here.)
local function nextViolated(b, list, c, last, by, least)
  local low, high, separation = list.low, list.high, list.separation
  local to, parent = b.to, b.parent
  while c ~= last do
    local kl, kh = low[c], high[c]
    if parent[kl] + parent[kh] > 0 or to[kl] + separation[c] - to[kh] > least then
      return c
    end
    c = c + by
  end
  return c
end

-- Walks along the contacts once. Returns whether something has changed.
local function walk(b, list, first, last, by, dt, isLate)
  local hasChanged, least = false, b.pushFirst and -EPSILON or EPSILON
  local c = nextViolated(b, list, first, last + by, by, least)
  while c ~= last + by do
    if look(b, list, c, dt, isLate) then
      hasChanged = true
    end
    c = nextViolated(b, list, c + by, last + by, by, least)
  end
  return hasChanged
end

-- Walks along the contacts forwards and backwards, at most PASSES times. (Where gravity points to
-- low coordinates the order is reversed, so that a turned scene gives a turned result.)
local function pass(b, list, dt, isLate)
  local count, isTurned = list.count, b.orientation[list.axis] < 0
  b.isTorn = false
  for n = 1, PASSES do
    local hasChanged
    if (n % 2 == 0) == isTurned then
      hasChanged = walk(b, list, 1, count, 1, dt, isLate)
    else
      hasChanged = walk(b, list, count, 1, -1, dt, isLate)
    end
    if not hasChanged then
      break
    end
  end
  spread(b)
end

--- Makes blocks of free bodies that overlap at the end of the step. Two bodies that came into one
--- block through others may still overlap: the blocks are made anew from there, TEARS times.
--- Returns whether a block was found between two that cannot give way.
function pool.run(b, list, dt, isLate)
  b.isClamped = false
  pass(b, list, dt, isLate)
  for _ = 1, TEARS do
    if not b.isTorn then
      break
    end
    pass(b, list, dt, true)
  end
  return b.isClamped
end

return pool
