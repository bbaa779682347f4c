--- Blocks: free bodies that press each other along an axis go on as one.
--
-- Source: pool adjacent violators, which solves isotonic regression (R. E. Barlow et al.,
-- Statistical Inference under Order Restrictions, 1972): walk along the contacts, and make one block
-- of two that overlap, with their common momentum. Bodies are in a forest (union-find); the offset
-- of each from the root of its block is kept, so that a block stays flush. Friction and engines of
-- its members act on a block as kinks (see flow).
--
-- A body that is not pushable is *firm*: a block with one moves as that does. Of two firm blocks
-- the one that comes from behind follows; two that meet head-on both stop.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")

local pool = {}

local EPSILON = columns.EPSILON
local floor = math.floor
-- Walks along the contacts, there and back.
local PASSES = 8

--- Returns whether an elastic pair bounces: it closes faster than its acceleration makes it in two
--- steps (`slow` s).
function pool.bounces(closing, accel, slow)
  return closing > (accel < 0 and -accel or accel) * slow
end

-- The root of the block of k, and how far k is from it.
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

-- Makes a block of one body, unless it is in one.
local function register(b, k)
  if b.parent[k] ~= 0 or b.give[k] == 0 then
    return
  end
  local n, mass, start = b.memberCount + 1, 1 / b.give[k], b.start[k]
  b.memberCount, b.members[n] = n, k
  b.parent[k], b.offset[k] = k, 0.0
  b.blockMass[k] = mass
  b.blockMomentum[k], b.blockSpeed[k] = mass * start, mass * b.speed[k]
  b.blockForce[k] = b.kinks[k] ~= 0 and b.force[k] or mass * b.accel[k]
  b.blockKinks[k] = b.kinks[k]
  b.blockStart[k] = mass * b.from[k]
  b.isFirm[k] = not b.pushable[floor(k * 0.5)]
end

-- The end of a block of which the parts are summed up, at its root.
local function finish(b, k, dt, isLate, place)
  local mass = b.blockMass[k]
  if b.blockKinks[k] == 0 or isLate then
    b.to[k], b.speed[k] = place, b.blockSpeed[k] / mass
    return
  end
  local v, way = flow.run(b, b.blockKinks[k], mass, b.blockForce[k], b.blockMomentum[k] / mass, dt)
  b.to[k], b.speed[k] = b.blockStart[k] / mass + way, v
end

-- Where a block of two goes, at the first's place, if the second is `off` px from it: to their
-- common centre of mass, or with `push = "first"` to the place of the one that was run into.
local function meetingPlace(b, one, other, off)
  local massOne, massOther, to, start = b.blockMass[one], b.blockMass[other], b.to, b.blockStart
  if b.pushFirst then
    local towards, against = to[one] - start[one] / massOne, start[other] / massOther - to[other]
    local isFirst = towards > against
      or (towards == against and b.rank[floor(one * 0.5)] < b.rank[floor(other * 0.5)])
    return isFirst and to[other] - off or to[one]
  end
  return (massOne * to[one] + massOther * (to[other] - off)) / (massOne + massOther)
end

-- Makes one block of two, of which the second is `off` px from the first.
local function join(b, one, other, off, dt, isLate)
  local massOne, massOther = b.blockMass[one], b.blockMass[other]
  local mass = massOne + massOther
  local place = meetingPlace(b, one, other, off)
  b.accel[one] = (massOne * b.accel[one] + massOther * b.accel[other]) / mass
  b.blockMass[one] = mass
  b.blockMomentum[one] = b.blockMomentum[one] + b.blockMomentum[other]
  b.blockSpeed[one] = b.blockSpeed[one] + b.blockSpeed[other]
  b.blockForce[one] = b.blockForce[one] + b.blockForce[other]
  b.blockStart[one] = b.blockStart[one] + b.blockStart[other] - massOther * off
  b.blockKinks[one] = flow.merge(b, b.blockKinks[one], b.blockKinks[other])
  b.parent[other], b.offset[other] = one, off
  b.heldLow[one] = b.heldLow[one] + b.heldLow[other]
  b.heldHigh[one] = b.heldHigh[one] + b.heldHigh[other]
  finish(b, one, dt, isLate, place)
end

-- Two firm blocks: who gives way. Returns whether the low one stays, whether the high one does.
local function meetFirm(b, low, high)
  local vl, vh = b.speed[low], b.speed[high]
  return vl <= 0 or vh < 0, vh >= 0 or vl > 0
end

-- Whether the low block stays, and the high one.
local function weigh(b, low, high)
  local stayLow, stayHigh = b.heldLow[low] > 0, b.heldHigh[high] > 0
  if stayLow or stayHigh or not (b.isFirm[low] or b.isFirm[high]) then
    return stayLow, stayHigh
  elseif b.isFirm[low] and b.isFirm[high] then
    return meetFirm(b, low, high)
  end
  return b.isFirm[low], b.isFirm[high]
end

-- Two firm blocks meet head-on: both stop where they were. Returns whether one has gone anywhere.
local function stopBoth(b, low, high)
  local hasMoved = false
  if b.isFirm[low] and b.isFirm[high] and b.heldLow[low] == 0 and b.heldHigh[high] == 0 then
    for side = 1, 2 do
      local k = side == 1 and low or high
      local place = b.blockStart[k] / b.blockMass[k]
      hasMoved = hasMoved or b.to[k] ~= place
      b.to[k], b.speed[k], b.accel[k] = place, 0.0, 0.0
    end
  end
  return hasMoved
end

--- Returns the speed of two that press each other, of which the first is held by what goes at `base`:
--- that, or if they leave it together, their common one. `sign`: 1 if it is held on its low side.
function pool.heldSpeed(mass, speed, otherMass, otherSpeed, base, sign)
  local v = (mass * speed + otherMass * otherSpeed) / (mass + otherMass)
  return (v - base) * sign > 0 and v or base
end

-- The same of two blocks.
local function heldSpeed(b, held, other, base, sign)
  local mass, speed = b.blockMass, b.speed
  return pool.heldSpeed(mass[held], speed[held], mass[other], speed[other], base, sign)
end

-- A firm block and a free one, or one that is held: the other takes the whole push, and what is
-- firm stays in command of what it pushes. Returns whether something has changed.
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
    if b.heldHigh[high] > 0 then
      b.heldHigh[low] = b.heldHigh[high] + 1
      b.holderHigh[low] = b.give[high] > 0 and b.holderHigh[high] or high
    end
    b.isFirm[low] = b.isFirm[low] or b.isFirm[high] and b.heldHigh[high] == 0
  else
    b.to[high] = b.to[low] + offLow + separation - offHigh
    if b.speed[low] > b.speed[high] then
      local base = b.heldLow[low] > 0 and b.give[low] > 0 and b.speed[b.holderLow[low]]
      if base and b.speed[low] > base then
        b.speed[low] = heldSpeed(b, low, high, base, 1)
      end
      b.speed[high], b.accel[high] = b.speed[low], b.accel[low]
    end
    if b.heldLow[low] > 0 then
      b.heldLow[high] = b.heldLow[low] + 1
      b.holderLow[high] = b.give[low] > 0 and b.holderLow[low] or low
    end
    b.isFirm[high] = b.isFirm[high] or b.isFirm[low] and b.heldLow[low] == 0
  end
  return true
end

-- They have bounced, and overlap only by what they were pushed since: places alone.
local function shift(b, low, high, over)
  local massLow, massHigh = b.blockMass[low], b.blockMass[high]
  local share = over / (massLow + massHigh)
  b.to[low] = b.to[low] - share * massHigh
  b.to[high] = b.to[high] + share * massLow
end

-- Looks at contact c. Returns whether something has changed.
local function look(b, list, c, dt, isLate)
  local kl, kh = list.low[c], list.high[c]
  if b.give[kl] == 0 and b.give[kh] == 0 then
    return false
  end
  local low, offLow = find(b, kl)
  local high, offHigh = find(b, kh)
  if low == high then
    return false
  end
  local separation = list.separation[c]
  local over = b.to[low] + offLow + separation - b.to[high] - offHigh
  local closing = b.speed[low] - b.speed[high]
  -- With `push = "first"` a block has speed, but goes nowhere: it presses on all the same.
  if over <= EPSILON then
    local isHeld = over > 0 and (b.heldLow[low] > 0 or b.heldHigh[high] > 0) -- flush to the bit
    if closing <= 0 or not (isHeld or (b.pushFirst and over >= -EPSILON)) then
      return false
    end
  end
  if list.elastic[c] == 1 and pool.bounces(closing, b.accel[low] - b.accel[high], 2 * dt) then
    return false
  end
  register(b, kl)
  register(b, kh)
  b.pressed[list.pair[c]] = 1
  local stayLow, stayHigh = weigh(b, low, high)
  if stayLow or stayHigh then
    return yield(b, low, high, offLow, offHigh, separation, stayLow, stayHigh)
  elseif closing <= 0 and list.elastic[c] == 1 then
    shift(b, low, high, over)
  else
    join(b, low, high, offLow + separation - offHigh, dt, isLate)
  end
  return true
end

-- Gives the members of blocks what has become of those.
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
  end
  for n = 1, b.memberCount do
    parent[members[n]] = 0
  end
  b.memberCount = 0
end

--- Makes one block of kUp and kLow, of which friction holds the first to the second.
function pool.glue(b, kUp, kLow, dt)
  register(b, kUp)
  register(b, kLow)
  local up, offUp = find(b, kUp)
  local low, offLow = find(b, kLow)
  if up ~= low then
    join(b, low, up, offLow + b.from[kUp] - b.from[kLow] - offUp, dt, false)
    b.heldLow[low], b.heldHigh[low] = 0, 0 -- its contacts find out anew
  end
end

--- Makes blocks of what overlaps at the end of the step. Walks there and back, at most PASSES times.
--- Returns whether a block was found between two that cannot give way.
function pool.run(b, list, dt, isLate)
  local count, isTurned = list.count, b.orientation[list.axis] < 0
  b.isClamped = false
  for n = 1, PASSES do
    local hasChanged = false
    local first, last, by = 1, count, 1
    if (n % 2 == 0) ~= isTurned then
      first, last, by = count, 1, -1
    end
    for c = first, last, by do
      if look(b, list, c, dt, isLate) then
        hasChanged = true
      end
    end
    if not hasChanged then
      break
    end
  end
  spread(b)
  return b.isClamped
end

return pool
