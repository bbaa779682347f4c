--- Settling: what touches along an axis does not overlap at the end of the step.
--
-- Boxes do not turn, so along one axis the contacts are a partial order, and what inelastic
-- contacts do to it has a closed answer. First, what an immovable body holds is put flush against
-- it, from there on through all that lean on each other (`holdHigh`, `holdLow`). Then free bodies
-- that press each other become blocks with a common velocity (see pool).
--
-- Reads contacts, give, start; writes to, speed, accel, heldLow, heldHigh, pressed, squeezed (px;
-- below 0: towards low coordinates).
-- heldLow and heldHigh are 0, or say by how many contacts an immovable body is away, and 1: a body
-- that is held cannot give way to that side.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local pool = require(root .. ".solver.pool")

local settle = {}

local EPSILON = columns.EPSILON
local max, min = math.max, math.min

-- Nothing dynamic is held yet.
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

-- Body k is leaving what has held it, `wall`, when `other` presses it back towards there.
local function leave(b, k, other, wall, sign)
  local give, speed = b.give, b.speed
  local mass, otherMass = 1 / give[k], 1 / give[other]
  speed[k] = pool.heldSpeed(mass, speed[k], otherMass, speed[other], speed[wall], sign)
end

-- Towards high coordinates: from what cannot give way, down the list, what leans on it.
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
          to[kl], held[kl] = place, held[kh] + 1
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

-- Where a squeezed body k goes: its middle is not pushed into what cannot be moved on that side.
-- (Where it was, if it is there again but for rounding, which would move it for ever.)
local function keepOut(b, k, place, sign)
  local half, from, to = b.size[k] * 0.5, b.from[k], b.to[k]
  if sign > 0 then
    place = min(place, max(to, b.to[b.holderHigh[k]] - half))
  else
    local wall = b.holderLow[k]
    place = max(place, min(to, b.to[wall] + b.size[wall] - half))
  end
  local isThere = place - from <= EPSILON and from - place <= EPSILON
  return isThere and from or place
end

-- Body k is held on one side, where `held` says how far what cannot give way is from it. `other`,
-- which cannot give way either, presses it by `over` px more towards there: to higher coordinates
-- (`sign` 1) or lower ones (-1). So it is squeezed. A row of such bodies shares the overlap, and
-- goes at the mean of the speeds of the two that press it. Of several that press a body the one
-- counts that does so most.
local function squeeze(b, k, other, over, sign, held, pressing, holder)
  local share, most = 1 - 1 / held[k], b.squeezed[k] * sign
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

-- Towards high coordinates again: what is held on its low side alone has been pushed onto something
-- on its high side that cannot give way.
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

-- Towards low coordinates. Returns whether free bodies still overlap.
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
          to[kh], held[kh] = place, held[kl] + 1
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

--- The first half of settling: what immovable bodies hold. Returns whether free ones overlap.
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

--- The second half: free bodies that overlap become blocks, beside those that friction has made.
--- `isLate`: the paths have begun at different moments by now.
function settle.finish(b, axis, dt, isGlued, isLate)
  if (b.isViolated or isGlued) and pool.run(b, b.contacts[axis], dt, isLate) then
    settle.hold(b, axis, dt) -- what is clamped shares the overlap
  end
end

--- Settles one axis.
function settle.axis(b, axis, dt, isLate)
  settle.hold(b, axis, dt)
  settle.finish(b, axis, dt, false, isLate)
end

--- Returns whether a contact of an axis is violated at the end of the step, apart from those that
--- cannot be helped: neither body can give way.
function settle.isViolated(b, axis)
  local list, to, heldLow, heldHigh = b.contacts[axis], b.to, b.heldLow, b.heldHigh
  local low, high, separation = list.low, list.high, list.separation
  for c = 1, list.count do
    local kl, kh = low[c], high[c]
    if to[kl] + separation[c] - to[kh] > EPSILON and (heldLow[kl] == 0 or heldHigh[kh] == 0) then
      return true
    end
  end
  return false
end

interpreted.functions(squeeze, pushBack, settle.hold, settle.finish, settle.axis)

return settle
