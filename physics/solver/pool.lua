---@diagnostic disable
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
-- and is not moved by it. A body that is not pushable is infinitely strong: a block with one moves
-- as that body does. If two such blocks meet, the one that comes from behind follows; if they meet
-- head-on, both stop.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local flow = require(root .. ".solver.flow")
local path = require(root .. ".motion.path")

local pool = {}

-- px: of a touch, and what a flush place may be rounded by.
local EPSILON, ROUNDING = columns.EPSILON, 1e-9
local floor, max, min = math.floor, math.max, math.min
local HUGE = math.huge
-- Maximum number of walks along the contacts, forwards and backwards.
local PASSES = 8
-- What is pushed by something stronger counts as this share of its mass.
local WEAK = 0.2

-- Returns what the blocks of a world need while they are made, all by body: `member` lists the
-- bodies in blocks. At the root of a block, the others are sums over its members.
local function newBlocks()
  return {
    count = 0,
    member = {},
    offset = {}, -- px from the next body on the way to the root, `parent`
    mass = {},
    momentum = {}, -- at the start of the step
    speed = {}, -- momentum at its end
    force = {},
    base = {}, -- velocity of the ground that its members rub on,
    grip = {}, -- and the limit of their friction there
    shift = {}, -- kg px between its centre of mass and where its members alone would have it
    least = {}, -- speed limits
    most = {},
    stand = {}, -- velocity of ground on which a member stands
    power = {}, -- of its strongest member
  }
end

--- Returns whether an elastic pair bounces: it closes faster than its acceleration alone would make
--- it close in two steps (`slow` s).
function pool.bounces(closing, accel, slow)
  return closing > (accel < 0 and -accel or accel) * slow
end

-- Returns the root of the block of k, and the offset of k from it, px.
local function find(b, k)
  local parent, offset = b.parent, b.blocks.offset
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
  local blocks = b.blocks
  local n, mass, onset, base, grip =
    blocks.count + 1, 1 / b.give[k], b.onset[k], b.base[k], b.grip[k]
  blocks.count, blocks.member[n] = n, k
  b.parent[k], blocks.offset[k] = k, 0.0
  blocks.mass[k], blocks.shift[k] = mass, 0.0
  blocks.momentum[k], blocks.speed[k] = mass * onset, mass * b.speed[k]
  blocks.force[k] = mass * flow.drive(b, k, dt)
  blocks.base[k], blocks.grip[k] = base, grip
  blocks.stand[k] = grip > 0 and base == onset and base or HUGE
  blocks.least[k], blocks.most[k] = b.least[k], b.most[k]
  blocks.power[k] = b.power[floor(k * 0.5)]
end

-- Returns where a block was at the start of the step.
local function origin(b, k)
  return b.from[k] + b.blocks.shift[k] / b.blocks.mass[k]
end

-- Computes the end of a block from the sums at its root k. A block that friction can hold in place
-- does not move: what pushes it pushes anew in each step.
local function finish(b, k, dt, isLate, place)
  local blocks = b.blocks
  local mass, least, most = blocks.mass[k], blocks.least[k], blocks.most[k]
  if isLate or (blocks.grip[k] == 0 and least == -HUGE and most == HUGE) then
    b.to[k], b.speed[k] = place, max(min(blocks.speed[k] / mass, most), least)
    return
  end
  local onset = blocks.momentum[k] / mass
  local base, grip, force = blocks.base[k], blocks.grip[k], blocks.force[k]
  local v, way = flow.run(base, grip, mass, force, onset, dt, least, most)
  way = v == blocks.stand[k] and v * dt or way
  b.to[k], b.speed[k] = origin(b, k) + way, v
end

-- Returns where the block of two ends, as the place of `one`, if `other` is `off` px from it: at
-- their common centre of mass. If only one of them gives way (`push = "first"`), the block ends at
-- the place of the one that was run into.
local function meetingPlace(b, one, other, off, isFirst)
  local massOne, massOther, to = b.blocks.mass[one], b.blocks.mass[other], b.to
  if isFirst then
    local towards, against = to[one] - origin(b, one), origin(b, other) - to[other]
    local more = towards - against
    local isEven = more <= EPSILON and more >= -EPSILON
    local yields = isEven and b.rank[floor(one * 0.5)] < b.rank[floor(other * 0.5)]
    return (yields or more > EPSILON) and to[other] - off or to[one]
  end
  return (massOne * to[one] + massOther * (to[other] - off)) / (massOne + massOther)
end

local function add(column, one, other)
  column[one] = column[one] + column[other]
end

-- Adds the friction of block `other` to that of `one`, if the ground of both goes at one velocity.
-- Else the stronger grip counts, and the other one as a force.
local function rubTogether(blocks, one, other)
  local base, grip, force = blocks.base, blocks.grip, blocks.force
  local strong, weak = one, other
  if grip[other] > grip[one] then
    strong, weak = other, one
  end
  if base[one] == base[other] then
    grip[one] = grip[one] + grip[other]
  else
    force[one] = force[one] + (base[weak] > base[strong] and grip[weak] or -grip[weak])
    base[one], grip[one] = base[strong], grip[strong]
  end
end

-- Joins two blocks into one. `other` is `off` px from `one`.
local function join(b, one, other, off, dt, isLate, isFirst)
  local blocks, accel = b.blocks, b.accel
  local mass, massOther = blocks.mass, blocks.mass[other]
  local place = meetingPlace(b, one, other, off, isFirst)
  local apart = b.from[other] - b.from[one]
  accel[one] = (mass[one] * accel[one] + massOther * accel[other]) / (mass[one] + massOther)
  add(mass, one, other)
  add(blocks.momentum, one, other)
  add(blocks.speed, one, other)
  add(blocks.force, one, other)
  add(blocks.shift, one, other)
  blocks.shift[one] = blocks.shift[one] + massOther * (apart - off)
  rubTogether(blocks, one, other)
  blocks.least[one] = max(blocks.least[one], blocks.least[other])
  blocks.most[one] = min(blocks.most[one], blocks.most[other])
  blocks.stand[one] = min(blocks.stand[one], blocks.stand[other])
  blocks.power[one] = max(blocks.power[one], blocks.power[other])
  b.parent[other], blocks.offset[other] = one, off
  b.heldLow[one], b.holderLow[one] = b.heldLow[other], b.holderLow[other]
  finish(b, one, dt, isLate, place)
end

--- Decides which of two that meet keeps its motion, by their power; the low one moves at vl, the
--- high one at vh. The stronger one does unless it moves towards the other one, and always if it is
--- not pushable. Returns whether the low one does, and whether the high one does.
function pool.weigh(powerLow, powerHigh, vl, vh)
  if powerLow == powerHigh then
    local isFirm = powerLow == HUGE
    return isFirm and (vl <= 0 or vh < 0), isFirm and (vh >= 0 or vl > 0)
  end
  return powerLow > powerHigh and (powerLow == HUGE or vl <= 0),
    powerHigh > powerLow and (powerHigh == HUGE or vh >= 0)
end

--- Returns the inverse mass of body k towards the side of `sign`: 0 if something immovable holds it
--- there, which it is not leaving.
function pool.giveOf(b, k, sign)
  local give, speed = b.give[k], b.speed
  if sign < 0 and b.heldLow[k] > 0 and give > 0 then
    return speed[k] <= speed[b.holderLow[k]] and 0.0 or give
  elseif sign > 0 and b.heldHigh[k] > 0 and give > 0 then
    return speed[k] >= speed[b.holderHigh[k]] and 0.0 or give
  end
  return give
end

-- Stops two blocks that meet head-on and cannot be pushed where they were. Returns whether one of
-- them had moved.
local function stopBoth(b, low, high)
  if b.heldLow[low] > 0 or b.heldHigh[high] > 0 then
    return false
  end
  local one, other = origin(b, low), origin(b, high)
  local hasMoved = b.to[low] ~= one or b.to[high] ~= other
  path.finish(b, low, one, 0.0, 0.0)
  path.finish(b, high, other, 0.0, 0.0)
  return hasMoved
end

--- Notes that body m leans on k, towards low coordinates (`sign` 1) or high ones (-1): what holds k
--- holds it, too.
function pool.lean(b, m, k, sign)
  local held, holder = b.heldLow, b.holderLow
  if sign < 0 then
    held, holder = b.heldHigh, b.holderHigh
  end
  if held[k] > 0 then
    held[m], holder[m] = held[k] + 1, b.give[k] > 0 and holder[k] or k
  end
end

-- Returns where block m, or its speed, ends that is pushed from `now` to `new`, towards `sign`.
-- What is not pushable is stopped, but not taken further than `rest`.
local function limit(b, m, now, new, rest, sign)
  local isMoved = b.blocks.power[m] == HUGE and (new - rest) * sign > ROUNDING
  return isMoved and sign * min(new * sign, max(now * sign, rest * sign)) or new
end

-- Puts block m at `place`, flush against block k, which keeps its motion because it is held or
-- strong. Block m takes the whole push, and k's power if that is not held. A block that is not
-- pushable itself is stopped, but not moved from where it was. `sign` as in `lean`.
local function follow(b, m, k, place, sign)
  local held, holder, speed, mass, power =
    b.heldLow, b.holderLow, b.speed, b.blocks.mass, b.blocks.power
  if sign < 0 then
    held, holder = b.heldHigh, b.holderHigh
  end
  local v = speed[m]
  b.to[m] = limit(b, m, b.to[m], place, origin(b, m), sign)
  if (speed[k] - speed[m]) * sign > 0 then
    local base = held[k] > 0 and b.give[k] > 0 and speed[holder[k]]
    path.press(b, m, k, mass[m], mass[k], base, sign)
    speed[m] = limit(b, m, v, speed[m], 0, sign)
  end
  pool.lean(b, m, k, sign)
  if b.give[k] > 0 and (held[k] == 0 or power[k] < HUGE) then
    power[m] = max(power[m], power[k])
  end
end

-- A block that something stronger pushes, to high coordinates (`sign` 1) or low ones (-1): its mass
-- counts as a share of what it is, and what it does against the push not at all.
local function weaken(b, k, sign)
  local blocks, start = b.blocks, origin(b, k)
  b.to[k] = start + sign * max((b.to[k] - start) * sign, 0)
  blocks.mass[k], blocks.shift[k] = blocks.mass[k] * WEAK, blocks.shift[k] * WEAK
  for n = 1, 3 do
    local column = n == 1 and blocks.momentum or n == 2 and blocks.speed or blocks.force
    column[k] = sign * max(column[k] * sign, 0) * WEAK
  end
  blocks.least[k], blocks.most[k] = -HUGE, HUGE
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

-- Resolves contact c, of which the bodies overlap by `over` px, for two blocks. Returns whether
-- something has changed. (Two that have bounced, and overlap only because others pushed them since,
-- keep their speeds.)
local function resolve(b, list, c, low, high, off, over, closing, dt, isLate)
  local powerLow, powerHigh = b.blocks.power[low] or HUGE, b.blocks.power[high] or HUGE
  local stayLow, stayHigh = b.heldLow[low] > 0, b.heldHigh[high] > 0
  if not (stayLow or stayHigh) then
    stayLow, stayHigh = pool.weigh(powerLow, powerHigh, b.speed[low], b.speed[high])
  end
  if stayLow and stayHigh then
    b.isUnsettled, b.isTight = b.isUnsettled or b.heldLow[low] > 0 and b.heldHigh[high] > 0, true
    return stopBoth(b, low, high)
  elseif stayHigh then
    follow(b, low, high, b.to[high] - off, -1)
  elseif stayLow then
    follow(b, high, low, b.to[low] + off, 1)
  elseif closing <= 0 and list.elastic[c] == 1 then
    local mass = b.blocks.mass
    local share = over / (mass[low] + mass[high])
    path.add(b, low, -share * mass[high], 0.0)
    path.add(b, high, share * mass[low], 0.0)
  else
    if powerLow ~= powerHigh then
      weaken(b, powerLow > powerHigh and high or low, powerLow > powerHigh and 1 or -1)
    end
    join(b, low, high, off, dt, isLate, b.pushFirst)
  end
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
  local off = offLow + list.separation[c] - offHigh
  if low == high then
    if off >= -EPSILON then -- how they press each other is not known
      b.isPushed[kl], b.isPushed[kh] = true, true
      b.isUnsettled = b.isUnsettled or off > EPSILON
    end
    return false
  end
  local over, closing = b.to[low] + off - b.to[high], b.speed[low] - b.speed[high]
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
  return resolve(b, list, c, low, high, off, over, closing, dt, isLate)
end

-- Gives the members of each block its path, and ends all blocks.
local function spread(b)
  local blocks, parent = b.blocks, b.parent
  local member = blocks.member
  for n = 1, blocks.count do
    local k = member[n]
    local top, off = find(b, k)
    if top ~= k then
      b.to[k], b.speed[k], b.accel[k] = b.to[top] + off, b.speed[top], b.accel[top]
      b.heldLow[k], b.heldHigh[k] = b.heldLow[top], b.heldHigh[top]
      b.holderLow[k], b.holderHigh[k] = b.holderLow[top], b.holderHigh[top]
    end
    b.outset[k] = blocks.momentum[top] / blocks.mass[top]
  end
  for n = 1, blocks.count do
    parent[member[n]] = 0
  end
  blocks.count = 0
end

--- Makes one block of kUp and kLow, because friction holds the upper one to the lower one after it
--- has slipped `slipped` px.
function pool.glue(b, kUp, kLow, slipped, dt)
  b.blocks = b.blocks or newBlocks()
  register(b, kUp, dt)
  register(b, kLow, dt)
  local up, offUp = find(b, kUp)
  local low, offLow = find(b, kLow)
  if up ~= low then
    local apart = b.from[kUp] - b.from[kLow] + slipped
    join(b, low, up, offLow + apart - offUp, dt, false, false)
    b.heldLow[low], b.heldHigh[low] = 0, 0 -- its contacts decide that again
  end
end

-- Walks along the contacts once, and looks at those that may be violated at the end of the step:
-- the bodies overlap, or one of them is in a block. (The place of a member of a block is not known
-- here.) Returns whether something has changed.
local function walk(b, list, first, last, by, dt, isLate)
  local hasChanged, least = false, b.pushFirst and -EPSILON or EPSILON
  local low, high, separation = list.low, list.high, list.separation
  local to, parent = b.to, b.parent
  for c = first, last, by do
    local kl, kh = low[c], high[c]
    local mayBe = parent[kl] + parent[kh] > 0 or to[kl] + separation[c] - to[kh] > least
    if mayBe and look(b, list, c, dt, isLate) then
      hasChanged = true
    end
  end
  return hasChanged
end

--- Makes blocks of free bodies that overlap at the end of the step: walks along the contacts
--- forwards and backwards, at most PASSES times. (Where gravity points to low coordinates the order
--- is reversed, so that a turned scene gives a turned result.) Returns whether the axis is to be
--- settled again: a block is between two that cannot give way, or two of one block overlap.
function pool.run(b, list, dt, isLate)
  local count, isTurned = list.count, b.orientation[list.axis] < 0
  b.isUnsettled, b.blocks = false, b.blocks or newBlocks()
  for n = 1, PASSES do
    local isForward = (n % 2 == 0) == isTurned
    local first, last = isForward and 1 or count, isForward and count or 1
    if not walk(b, list, first, last, isForward and 1 or -1, dt, isLate) then
      break
    end
  end
  spread(b)
  return b.isUnsettled
end

return pool
