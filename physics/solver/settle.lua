---@diagnostic disable
--- Settling: computes from the contacts of an axis where their bodies end, so that none overlap at
-- the end of the step if there is room.
--
-- Boxes do not turn, so the contacts of an axis are a partial order, and the result of inelastic
-- contacts can be computed directly:
-- 1. Immovable bodies hold what is pushed against them: it ends flush, with their speed. So does
--    what leans on that, and so on (`hold`). What is held on both sides is squeezed (`squeeze`).
-- 2. Free bodies that press each other become blocks with a common velocity (see pool.lua).
--
-- For example, a box that touches a wall when the step begins, and is pushed against it, ends flush
-- with it (`hold`) at the speed of the wall (`path.press`). What pushes it is held in the same way.
-- A box that comes to the wall inside the step has an impact (`stick` in impact.lua), and is a
-- contact from then on.
--
-- heldLow and heldHigh of a body are 0 if it can give way to that side. Otherwise they are 1 plus
-- the number of contacts between it and the immovable body that holds it there. So a wall has 1 on
-- both sides.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local path = require(root .. ".motion.path")
local pool = require(root .. ".memory.lazy")(root .. ".solver.pool")

local settle = {}

local EPSILON, DYNAMIC = columns.EPSILON, columns.DYNAMIC
local max, min = math.max, math.min
-- Maximum number of times that blocks are made: two that came into one through others may overlap.
local ATTEMPTS = 5
-- heldLow and heldHigh of what is no wall, but stays where it is: what is between that and a wall
-- is not squeezed into the wall.
local FAR = 1000

-- Resets an axis: no movable body is held yet; what cannot be moved holds itself. (What is static
-- is not in the list: its columns are 1 from the beginning, see memory/layout.)
local function release(b, axis)
  local list, give, heldLow, heldHigh = b.awakeList, b.give, b.heldLow, b.heldHigh
  local squeezed, holderLow, holderHigh = b.squeezed, b.holderLow, b.holderHigh
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    squeezed[k] = 0
    if give[k] > 0 then
      heldLow[k], heldHigh[k] = 0, 0
    else
      heldLow[k] = b.kind[list[n]] == DYNAMIC and FAR or 1
      heldHigh[k], holderLow[k], holderHigh[k] = heldLow[k], k, k
    end
  end
end

-- Returns where a squeezed body k goes: not so far that its middle is pushed into the immovable
-- body on that side. The place is its start if they differ by rounding only, which would move it
-- for ever.
local function keepOut(b, k, place, sign)
  local half, from, to, wall = b.size[k] * 0.5, b.from[k], b.to[k], b.holderLow[k]
  place = sign > 0 and min(place, max(to, b.to[b.holderHigh[k]] - half))
    or max(place, min(to, b.to[wall] + b.size[wall] - half))
  local isThere = place - from <= EPSILON and from - place <= EPSILON
  return isThere and from or place
end

-- Squeezes body k between the body that holds it and `other`, which cannot give way either. `other`
-- presses it by `over` px more, to higher coordinates (`sign` 1) or to lower ones (-1).
--
-- - `held` is heldLow or heldHigh, on the side to which k is pressed. A row of such bodies shares
--   the overlap, but the middle of what is beside a wall stays out of that: others overlap more.
-- - The body moves at the mean speed of the two immovable bodies.
-- - If several bodies press it, the one with the largest overlap counts.
local function squeeze(b, k, other, over, sign, held, pressing, holder)
  local isBeside, most = b.give[other] == 0 and held[k] > 2, b.squeezed[k] * sign
  local share = max(1 - 1 / held[k], isBeside and 1 - b.size[k] * 0.5 / over or 0)
  over = over + most * share
  if over > most then
    b.squeezed[k] = sign * over
    local place = b.to[k] + sign * (over - most) * share
    local isAlone = held[k] == 2 and b.give[other] == 0
    place = isAlone and place or keepOut(b, k, place, sign)
    pressing[k] = pressing[other] + 1
    holder[k] = b.give[other] > 0 and holder[other] or other
    path.finish(b, k, place, (b.speed[b.holderLow[k]] + b.speed[b.holderHigh[k]]) * 0.5, 0.0)
  end
end

-- Puts bodies flush against what holds them, from immovable bodies on: against what holds them on
-- their low side, along the list (`sign` 1), or on their high side, back along it (-1). What is
-- held on the other side already is squeezed. Returns whether something was.
local function hold(b, list, slow, sign)
  local near, far, held, wall, opposite = list.low, list.high, b.heldLow, b.holderLow, b.heldHigh
  local first, last = 1, list.count
  if sign < 0 then
    near, far, held, wall, opposite = list.high, list.low, b.heldHigh, b.holderHigh, b.heldLow
    first, last = list.count, 1
  end
  local separation, elastic, to, speed = list.separation, list.elastic, b.to, b.speed
  local give, accel, hasSqueezed = b.give, b.accel, false
  for c = first, last, sign do
    local k, m = near[c], far[c]
    if held[k] > 0 and give[m] > 0 then
      local place = to[k] + sign * separation[c]
      local over, closing = (place - to[m]) * sign, (speed[k] - speed[m]) * sign
      local isMet = over > -EPSILON and (over > 0 or closing >= 0)
      if isMet and (elastic[c] == 0 or not pool.bounces(closing, accel[k] - accel[m], slow)) then
        local isNew = opposite[m] == 0
        if over > EPSILON or (closing > 0 and isNew) then
          b.pressed[list.pair[c]] = 1
        end
        if isNew then
          held[m], wall[m] = held[k] + 1, give[k] > 0 and wall[k] or k
          if over > 0 or to[m] ~= b.from[m] then -- what stands a rounding apart stays so
            to[m] = place
          end
          if closing > 0 then
            path.press(b, m, k, 1 / give[m], 1 / give[k], give[k] > 0 and speed[wall[k]], sign)
          end
        elseif over > EPSILON and held[k] ~= FAR and (held[m] == 0 or b.squeezed[m] * sign > 0) then
          squeeze(b, m, k, over, sign, opposite, held, wall)
          hasSqueezed = true
        end
      end
    end
  end
  return hasSqueezed
end

-- Returns whether an impact has put one of two bodies into the other, which is immovable, and it is
-- not squeezed there yet.
local function isUnsqueezed(b, kl, kh)
  local isWall = (b.give[kl] == 0) ~= (b.give[kh] == 0)
  return isWall and b.squeezed[kl] == 0 and b.squeezed[kh] == 0
end

--- Returns whether a contact of an axis is violated at the end of the step. Contacts that are
--- squeezed, or of which neither body can move, do not count.
function settle.isViolated(b, axis)
  local list, to, heldLow, heldHigh = b.contacts[axis], b.to, b.heldLow, b.heldHigh
  local low, high, separation = list.low, list.high, list.separation
  for c = 1, list.count do
    local kl, kh = low[c], high[c]
    if to[kl] + separation[c] - to[kh] > EPSILON then
      if heldLow[kl] == 0 or heldHigh[kh] == 0 or isUnsqueezed(b, kl, kh) then
        return true
      end
    end
  end
  return false
end

--- Settles what immovable bodies hold, the first half of settling. `b.isViolated` says afterwards
--- whether others overlap. What is held on its low side alone, but was pushed onto what is held on
--- its high side, is squeezed then.
function settle.hold(b, axis, dt)
  local list, slow = b.contacts[axis], 2 * dt
  release(b, axis)
  hold(b, list, slow, -1)
  local hasSqueezed = hold(b, list, slow, 1)
  b.isViolated = settle.isViolated(b, axis)
  if b.isViolated or hasSqueezed then
    hold(b, list, slow, -1)
  end
end

--- Makes blocks of free bodies that overlap, the second half of settling. `isGlued`: friction has
--- made blocks already. `isLate`: the paths begin at different moments of the step.
function settle.finish(b, axis, dt, isGlued, isLate)
  for attempt = 1, (b.isViolated or isGlued) and ATTEMPTS or 0 do
    if not pool.run(b, b.contacts[axis], dt, isLate or attempt > 1) then
      return
    end
    settle.hold(b, axis, dt) -- bodies between two immovable ones share the overlap
  end
end

--- Settles one axis.
function settle.axis(b, axis, dt, isLate)
  settle.hold(b, axis, dt)
  settle.finish(b, axis, dt, false, isLate)
end

return settle
