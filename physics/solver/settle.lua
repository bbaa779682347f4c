--- Settling: computes from the contacts of an axis where their bodies end, so that none overlap at
-- the end of the step if there is room.
--
-- Boxes do not turn, so the contacts of an axis are a partial order, and the result of inelastic
-- contacts can be computed directly:
-- 1. Immovable bodies hold what is pushed against them: it ends flush, with their speed. So does
--    what leans on that, and so on (`holdHigh`, `holdLow`). What is held on both sides is squeezed
--    (`squeeze`).
-- 2. Free bodies that press each other become blocks with a common velocity (see pool.lua).
--
-- For example, a box that is pushed against a wall ends flush with it at the speed of the wall.
-- What pushes it is held in the same way.
--
-- heldLow and heldHigh of a body are 0 if it can give way to that side. Otherwise they are 1 plus
-- the number of contacts between it and the immovable body that holds it there.
--
-- Reads contacts, give, start; writes to, speed, accel, heldLow, heldHigh, holderLow, holderHigh,
-- pressed, and squeezed (px; below 0: towards low coordinates).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local pool = require(root .. ".solver.pool")

local settle = {}

local EPSILON = columns.EPSILON
local floor, max, min = math.floor, math.max, math.min

-- Resets an axis: no movable body is held yet.
local function release(b, axis)
  local list, give, heldLow, heldHigh = b.awakeList, b.give, b.heldLow, b.heldHigh
  local squeezed = b.squeezed
  for n = 1, b.awakeCount do
    local k = 2 * list[n] + axis
    squeezed[k] = 0
    if give[k] > 0 then
      heldLow[k], heldHigh[k] = 0, 0
    else
      heldLow[k], heldHigh[k] = 1, 1
    end
  end
end

-- Lets `other` press body k back towards the body that held it (`wall`), which k is leaving. The
-- two share their momentum, but k is never faster towards `wall` than that goes.
local function leave(b, k, other, wall, sign)
  local give, speed = b.give, b.speed
  local mass, otherMass = 1 / give[k], 1 / give[other]
  speed[k] = pool.heldSpeed(mass, speed[k], otherMass, speed[other], speed[wall], sign)
end

-- Puts bodies flush against what holds them on their high side, from immovable bodies down the
-- list.
local function holdHigh(b, list, slow)
  local low, high, separation, elastic = list.low, list.high, list.separation, list.elastic
  local pair, pressed = list.pair, b.pressed
  local to, speed, accel, give, held = b.to, b.speed, b.accel, b.give, b.heldHigh
  local wall = b.holderHigh
  for c = list.count, 1, -1 do
    local kl, kh = low[c], high[c]
    if held[kh] > 0 and give[kl] > 0 then
      local place = to[kh] - separation[c]
      local over, closing = to[kl] - place, speed[kl] - speed[kh]
      if over > -EPSILON and (over > 0 or closing >= 0) then
        if elastic[c] == 0 or not pool.bounces(closing, accel[kl] - accel[kh], slow) then
          if over > 0 or to[kl] ~= b.from[kl] then -- what stands a rounding apart stays so
            to[kl] = place
          end
          held[kl] = held[kh] + 1
          wall[kl] = give[kh] > 0 and wall[kh] or kh
          if closing > 0 then
            if give[kh] > 0 and speed[kh] < speed[wall[kh]] then
              leave(b, kh, kl, wall[kh], -1)
            end
            speed[kl], accel[kl], pressed[pair[c]] = speed[kh], accel[kh], 1
          elseif over > EPSILON then
            pressed[pair[c]] = 1
          end
        end
      end
    end
  end
end

local function isBall(b, k)
  return b.hasCircles and b.shape[floor(k * 0.5)] == columns.SHAPE_CIRCLE
end

-- Returns where a squeezed body k goes: not so far that its middle is pushed into the immovable
-- body on that side, and a ball not at all. The place is its start if they differ by rounding only,
-- which would move it for ever.
local function keepOut(b, k, place, sign)
  local most, from, to = isBall(b, k) and 0.0 or b.size[k] * 0.5, b.from[k], b.to[k]
  if sign > 0 then
    place = min(place, max(to, b.to[b.holderHigh[k]] - b.size[k] + most))
  else
    local wall = b.holderLow[k]
    place = max(place, min(to, b.to[wall] + b.size[wall] - most))
  end
  local isThere = place - from <= EPSILON and from - place <= EPSILON
  return isThere and from or place
end

-- Squeezes body k between the body that holds it and `other`, which cannot give way either. `other`
-- presses it by `over` px more, to higher coordinates (`sign` 1) or to lower ones (-1).
--
-- - `held` is heldLow or heldHigh, on the side to which k is pressed. A row of such bodies shares
--   the overlap. A ball beside a wall stays out of that: others have the overlap.
-- - The body moves at the mean speed of the two immovable bodies.
-- - If several bodies press it, the one with the largest overlap counts.
local function squeeze(b, k, other, over, sign, held, pressing, holder)
  local isBeside = b.give[other] == 0 and held[k] > 2 and isBall(b, k)
  local share, most = isBeside and 1 or 1 - 1 / held[k], b.squeezed[k] * sign
  over = over + most * share
  if over > most then
    b.squeezed[k] = sign * over
    local place = b.to[k] + sign * (over - most) * share
    local isAlone = held[k] == 2 and b.give[other] == 0
    b.to[k] = isAlone and place or keepOut(b, k, place, sign)
    pressing[k] = pressing[other] + 1
    holder[k] = b.give[other] > 0 and holder[other] or other
    b.speed[k] = (b.speed[b.holderLow[k]] + b.speed[b.holderHigh[k]]) * 0.5
    b.accel[k] = 0.0
  end
end

-- Squeezes bodies that are held on their low side alone, but have been pushed onto a body that is
-- held on its high side.
local function pushBack(b, list)
  local low, high, separation, pair, pressed =
    list.low, list.high, list.separation, list.pair, b.pressed
  local to, give, heldLow, heldHigh = b.to, b.give, b.heldLow, b.heldHigh
  for c = list.count, 1, -1 do
    local kl, kh = low[c], high[c]
    local isFree = give[kl] > 0 and (heldHigh[kl] == 0 or b.squeezed[kl] < 0)
    if heldHigh[kh] > 0 and heldLow[kl] > 0 and isFree then
      local over = to[kl] + separation[c] - to[kh]
      if over > EPSILON then
        pressed[pair[c]] = 1
        squeeze(b, kl, kh, over, -1, heldLow, heldHigh, b.holderHigh)
      end
    end
  end
end

-- Puts bodies flush against what holds them on their low side. Returns whether free bodies still
-- overlap.
local function holdLow(b, list, slow)
  local low, high, separation, elastic = list.low, list.high, list.separation, list.elastic
  local pair, pressed = list.pair, b.pressed
  local to, speed, accel, give, held = b.to, b.speed, b.accel, b.give, b.heldLow
  local wall = b.holderLow
  local isViolated = false
  for c = 1, list.count do
    local kl, kh = low[c], high[c]
    local place = to[kl] + separation[c]
    local over = place - to[kh]
    if over > -EPSILON then
      local closing = speed[kl] - speed[kh]
      local isHeld = held[kl] > 0 and give[kh] > 0
      if not isHeld then
        isViolated = isViolated or over > EPSILON and (give[kl] > 0 or give[kh] > 0)
      elseif
        (over > 0 or closing >= 0)
        and (elastic[c] == 0 or not pool.bounces(closing, accel[kl] - accel[kh], slow))
      then
        if b.heldHigh[kh] > 0 then
          if over > EPSILON then
            pressed[pair[c]] = 1
            squeeze(b, kh, kl, over, 1, b.heldHigh, held, wall)
          end
        else
          if over > 0 or to[kh] ~= b.from[kh] then
            to[kh] = place
          end
          held[kh] = held[kl] + 1
          wall[kh] = give[kl] > 0 and wall[kl] or kl
          if closing > 0 then
            if give[kl] > 0 and speed[kl] > speed[wall[kl]] then
              leave(b, kl, kh, wall[kl], 1)
            end
            speed[kh], accel[kh], pressed[pair[c]] = speed[kl], accel[kl], 1
          elseif over > EPSILON then
            pressed[pair[c]] = 1
          end
        end
      end
    end
  end
  return isViolated
end

--- Settles what immovable bodies hold, the first half of settling. `b.isViolated` says afterwards
--- whether free bodies overlap.
function settle.hold(b, axis, dt)
  local list = b.contacts[axis]
  release(b, axis)
  local slow = 2 * dt
  holdHigh(b, list, slow)
  b.isViolated = holdLow(b, list, slow)
  if b.isViolated then
    pushBack(b, list)
  end
end

--- Makes blocks of free bodies that overlap, the second half of settling. `isGlued`: friction has
--- made blocks already. `isLate`: the paths begin at different moments of the step.
function settle.finish(b, axis, dt, isGlued, isLate)
  if (b.isViolated or isGlued) and pool.run(b, b.contacts[axis], dt, isLate) then
    settle.hold(b, axis, dt) -- bodies between two immovable ones share the overlap
  end
end

--- Settles one axis.
function settle.axis(b, axis, dt, isLate)
  settle.hold(b, axis, dt)
  settle.finish(b, axis, dt, false, isLate)
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

return settle
