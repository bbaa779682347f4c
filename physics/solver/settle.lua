--- Settling: what touches along an axis does not overlap at the end of the step.
--
-- Boxes do not turn, so along one axis the contacts are a partial order, and what inelastic
-- contacts do to it has a closed answer. First, what an immovable body holds is put flush against
-- it, from there on through all that lean on each other (`holdHigh`, `holdLow`). Then free bodies
-- that press each other become blocks with a common velocity (see pool).
--
-- Reads contacts, give, start; writes to, speed, accel, heldLow, heldHigh, pressed, squeezed.
-- heldLow and heldHigh are 0, or say by how many contacts an immovable body is away, and 1: a body
-- that is held cannot give way to that side.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local pool = require(root .. ".solver.pool")

local settle = {}

local EPSILON = columns.EPSILON
local min = math.min

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
            speed[kl], accel[kl], pressed[pair[c]] = speed[kh], accel[kh], 1
          elseif over > EPSILON then
            pressed[pair[c]] = 1
          end
        end
      end
    end
  end
end

-- Body kh is held on its high side and pressed by `over` px from its low side, where kl cannot give
-- way either: it is squeezed. A row of them shares the overlap among its members, so that none goes
-- into what presses the row; one alone shares it with both sides. They go at the mean of the speeds
-- of those two.
local function squeeze(b, kl, kh, over)
  local depth = b.heldHigh[kh] - 1
  local place, wall = b.to[kh] + over * 0.5, b.holderHigh[kh]
  if depth > 1 or b.give[kl] > 0 then
    local share = b.give[kl] == 0 and 1 or (depth - 1) / depth
    place = min(b.to[kh] + over * share, b.to[wall] - b.size[kh])
  end
  b.squeezed[kh] = over
  local from = b.from[kh]
  local isThere = place - from <= EPSILON and from - place <= EPSILON
  b.to[kh] = isThere and from or place -- or rounding would move it for ever
  b.speed[kh] = (b.speed[b.holderLow[kh]] + b.speed[wall]) * 0.5
  b.accel[kh] = 0.0
end

-- Body kl was put into the immovable kh by what holds it on its low side. It goes back to where it
-- is flush, and into those; or half of the way if these cannot be moved either.
local function squeezeBack(b, kl, kh, over)
  b.squeezed[kl], b.heldHigh[kl], b.holderHigh[kl] = over, 2, kh
  b.to[kl] = b.to[kl] - over * (b.heldLow[kl] > 2 and 1 or 0.5)
  b.speed[kl] = (b.speed[b.holderLow[kl]] + b.speed[kh]) * 0.5
  b.accel[kl] = 0.0
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
        if
          give[kh] == 0
          and give[kl] > 0
          and held[kl] > 0
          and b.heldHigh[kl] == 0
          and over > EPSILON
        then
          squeezeBack(b, kl, kh, over)
          pressed[pair[c]] = 1
        else
          isViolated = isViolated or over > EPSILON and (give[kl] > 0 or give[kh] > 0)
        end
      elseif
        (over > 0 or closing >= 0)
        and (elastic[c] == 0 or not pool.bounces(closing, accel[kl] - accel[kh], slow))
      then
        held[kh] = held[kl] + 1
        wall[kh] = give[kl] > 0 and wall[kl] or kl
        if b.heldHigh[kh] > 0 then
          if over > EPSILON then
            squeeze(b, kl, kh, over)
            pressed[pair[c]] = 1
          end
        else
          to[kh] = place
          if closing > 0 then
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
end

--- The second half: free bodies that overlap become blocks, beside those that friction has made.
function settle.finish(b, axis, dt, isGlued)
  if b.isViolated or isGlued then
    pool.run(b, b.contacts[axis], dt, false)
  end
end

--- Settles one axis. `isLate`: the paths have begun at different moments by now.
function settle.axis(b, axis, dt, isLate)
  settle.hold(b, axis, dt)
  if b.isViolated then
    pool.run(b, b.contacts[axis], dt, isLate)
  end
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

interpreted.functions(squeeze, squeezeBack, settle.hold, settle.finish, settle.axis)

return settle
