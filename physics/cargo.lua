--- Step 6, meet: who goes along with what it stands on, by friction, when that is pushed.
--
-- Friction is asked before pushes across gravity (see `turns`). What slides on a rough floor is
-- braked, and brakes what stands on it; if something pushes it on at once, that must go on, too, or
-- it would slide off, a little in each step. So it counts as a part of who is pushed, as long as
-- friction can take it along.
--
-- Noted where they rub: `cargo` leads from a slot to one that stands on it, `nextCargo` to the next
-- one, `goesWith` back.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local grip = require(here .. ".grip")
local path = require(here .. ".path")

require(here .. ".interpreted").file()

local cargo = {}

local huge, max = math.huge, math.max

local ALL, ROUNDING = grip.ALL, grip.ROUNDING
local STILL = columns.STILL
-- So often at most it is asked again who is dragged, and how fast all become then.
local ROUNDS = 40

--- Notes that `up` goes along with `low`, on which it stands.
function cargo.put(b, up, low)
  if b.goesWith[up] == 0 then
    b.goesWith[up], b.nextCargo[up], b.cargo[low] = low, b.cargo[low], up
    b.hasCargo = true
  end
end

--- Whether k may go as friction lets it: nothing holds or backs it, or is welded to it.
function cargo.isFree(b, k)
  return b.weld[k] == 0
    and b.heldLow[k] + b.heldHigh[k] == 0
    and not (b.backedLow[k] or b.backedHigh[k])
end

-- Whether nothing but friction holds `up` on slot i. (Levels go up, see `grip`.)
local function isLoose(b, up, i, axis)
  return b.level[up] > b.level[i] and cargo.isFree(b, 2 * up + axis)
end

local need

-- Adds the impulse that brings all that stands on slot i to v px/s, as far as friction can, and the
-- mass of those that it brings there; returns both.
local function needOn(b, i, axis, v, impulse, mass)
  local up = b.cargo[i]
  while up ~= 0 do
    if isLoose(b, up, i, axis) then
      local more, its = need(b, up, axis, v)
      impulse, mass = impulse + more, mass + its
    end
    up = b.nextCargo[up]
  end
  return impulse, mass
end

-- Returns the same for `up` with all that stands on it; notes the impulse, and whether `up` is one
-- of those that it does not bring there.
function need(b, up, axis, v)
  local own = b.mass[up]
  local impulse, mass = needOn(b, up, axis, v, own * (v - b.speed[2 * up + axis]), own)
  local sign = impulse < 0 and -1 or 1
  local most = max(b.grip[up] - sign * b.gripUsed[up], 0.0)
  local goes = impulse * sign <= most * (1 + ROUNDING)
  if not goes then
    impulse, mass = most * sign, 0
  end
  b.dragged[up], b.dragImpulse[up] = not goes, impulse
  return impulse, mass
end

-- Returns the same for all that stands on k, and on those that are welded to it.
local function needOnRing(b, k, axis, v)
  local impulse, mass, member = 0, 0, k ---@type number, number, number
  repeat
    impulse, mass = needOn(b, (member - axis) / 2, axis, v, impulse, mass)
    member = b.weldNext[member]
  until member == k or member == 0
  return impulse, mass
end

-- Returns the speed to try after v px/s, which takes too large an impulse by `excess`, and the new
-- bounds: `new`, if that is between them. More speed takes more, by pieces of straight lines.
-- Source: Newton's method, kept between bounds by bisection.
local function tryNext(v, new, excess, least, most)
  if excess > 0 then
    most = v
  else
    least = v
  end
  return (new <= least or new >= most) and (least + most) * 0.5 or new, least, most
end

-- Returns the speed at which `up` goes on, given an impulse, with all that stands on it: where that
-- takes what is left.
local function draggedSpeed(b, up, axis, impulse)
  local own, before = b.mass[up], b.speed[2 * up + axis]
  local v, least, most = before, -huge, huge
  for _ = 1, ROUNDS do
    local taken, mass = needOn(b, up, axis, v, own * (v - before), own)
    local excess = taken - impulse
    local new = v - excess / mass
    if max(new - v, v - new) <= STILL then
      return new
    end
    v, least, most = tryNext(v, new, excess, least, most)
  end
  return v
end

-- Returns the speed at which two go on that run into each other, with inverse masses `wl`, `wh`,
-- and all that stands on them: where the impulses of all add up to nothing.
local function commonSpeed(b, kl, kh, axis, wl, wh)
  local speedL, speedH = b.speed[kl], b.speed[kh]
  if wl == 0 or wh == 0 then
    return wl == 0 and speedL or speedH
  end
  local v, least, most = (speedL * wh + speedH * wl) / (wl + wh), -huge, huge
  for _ = 1, ROUNDS do
    local impulseL, massL = needOnRing(b, kl, axis, v)
    local impulseH, massH = needOnRing(b, kh, axis, v)
    local excess = (v - speedL) / wl + (v - speedH) / wh + impulseL + impulseH
    local new = v - excess / (1 / wl + 1 / wh + massL + massH)
    if max(new - v, v - new) <= STILL then
      return new
    end
    v, least, most = tryNext(v, new, excess, least, most)
  end
  return v
end

-- Returns the inverse mass of k (`w`; 0: it does not give way) with all that goes along with it
-- at v px/s, and by how much the others make it slower, px/s.
local function weigh(b, k, axis, w, v)
  local impulse, mass = needOnRing(b, k, axis, v)
  local all = w > 0 and 1 / (1 / w + mass) or 0
  return all, (impulse - mass * (v - b.speed[k])) * all
end

--- Loads two that close at v px/s across gravity, and overlap by `o` px at the end of a step of
--- dt s, with what goes along with them; some may only be dragged, by a force that acts during the
--- whole step. Returns their inverse masses, v and o as they are then, and whether anything goes
--- along.
function cargo.load(b, kl, kh, axis, wl, wh, v, o, dt)
  local common = commonSpeed(b, kl, kh, axis, wl, wh)
  local allL, lossL = weigh(b, kl, axis, wl, common)
  local allH, lossH = weigh(b, kh, axis, wh, common)
  local closing = v - lossL + lossH
  if closing <= 0 then
    return wl, wh, v, o, false -- they are apart then, but for what they overlap already
  end
  local share = b.pushFirst and 0 or dt * 0.5
  b.speed[kl], b.speed[kh] = b.speed[kl] - lossL, b.speed[kh] - lossH
  b.to[kl], b.to[kh] = b.to[kl] - lossL * share, b.to[kh] - lossH * share
  return allL, allH, closing, o + (lossH - lossL) * share, true
end

-- Whether two went at the same speed when the step began.
local function beganAlike(b, k, m)
  local velocity, carried = b.velocity, b.carried
  return velocity[k] + carried[k] == velocity[m] + carried[m]
end

-- Takes along, as far as friction can, all that stands on slot i, which moved at v px/s before, and
-- has come to go `way` px further in a step of dt s. What they need has been noted (see `need`).
local function take(b, i, axis, v, way, dt)
  local m, up = 2 * i + axis, b.cargo[i]
  local new = b.speed[m]
  while up ~= 0 do
    local k = 2 * up + axis
    if isLoose(b, up, i, axis) then
      local before, impulse, isDragged = b.speed[k], b.dragImpulse[up], b.dragged[up]
      if isDragged then
        b.speed[k] = draggedSpeed(b, up, axis, impulse)
        needOn(b, up, axis, b.speed[k], 0, 0) -- for what stands on it
      else
        b.speed[k], b.accel[k] = new, b.accel[m]
      end
      local was = b.to[k]
      if not isDragged and beganAlike(b, k, m) then
        b.to[k] = b.from[k] + (b.to[m] - b.from[m]) -- to the bit
      else
        local goesAlike = not isDragged and before == v
        b.to[k] = was + (goesAlike and way or (b.speed[k] - before) * dt * 0.5)
      end
      b.gripUsed[up] = b.gripUsed[up] + impulse
      b.groundSpeed[up], b.taken[up] = new, b.step
      path.change(b, up)
      take(b, up, axis, before, b.to[k] - was, dt)
    end
    up = b.nextCargo[up]
  end
end

--- Takes along all that stands on k, and on those that are welded to it: they moved at v px/s
--- before, and go `way` px further in a step of dt s now.
function cargo.follow(b, k, axis, v, way, dt)
  local member = k
  needOnRing(b, k, axis, b.speed[k])
  repeat
    take(b, (member - axis) / 2, axis, v, way, dt)
    member = b.weldNext[member]
  until member == k or member == 0
end

-- Whether slot i slides on what it stands on, and something may go along with it.
local function slides(b, i, k)
  local used = b.gripUsed[i]
  return max(used, -used) > b.grip[i] * ALL and b.cargo[i] + b.weld[k] > 0
end

--- Whether a push of two must take along what goes with them, as one of them slides on what it
--- stands on. (As long as it does not, it goes with that; what stands on it has rubbed already.)
function cargo.isDue(b, lo, hi, kl, kh)
  return slides(b, lo, kl) or slides(b, hi, kh)
end

-- Whether `up`, which stands on slot i, goes as the tower does, at v px/s.
local function isPart(b, up, i, axis, v)
  return b.speed[2 * up + axis] == v and isLoose(b, up, i, axis)
end

--- Mass of slot i and of all on it that go as it does, at v px/s.
function cargo.massOf(b, i, axis, v)
  local mass, up = b.mass[i], b.cargo[i]
  while up ~= 0 do
    if isPart(b, up, i, axis, v) then
      mass = mass + cargo.massOf(b, up, axis, v)
    end
    up = b.nextCargo[up]
  end
  return mass
end

--- Returns the lowest one of the tower that slides as a whole, slot i with it, and the mass of that
--- tower; 0: there is none.
function cargo.tower(b, i, axis)
  local v = b.speed[2 * i + axis]
  local low = b.goesWith[i]
  while low ~= 0 and b.ground[i] == low and b.speed[2 * low + axis] == v do
    if not isLoose(b, i, low, axis) then
      return 0, 0
    end
    i, low = low, b.goesWith[low]
  end
  local rubs = b.level[i] > 0 and (low == 0 or b.ground[i] == low)
  if b.stuck[i] > 0 or not rubs or not cargo.isFree(b, 2 * i + axis) then
    return 0, 0
  end
  return i, cargo.massOf(b, i, axis, v)
end

--- Whether friction can hold the tower on slot i, which goes at v px/s, together if it becomes
--- faster by `gain`, as `low`, a part of it, gets an impulse, under a weight. Returns that, the
--- mass of this part of it, and whether `low` is in that.
function cargo.holds(b, i, axis, v, gain, low, impulse, weight)
  local mass, hasLow, up = b.mass[i], i == low, b.cargo[i]
  while up ~= 0 do
    if isPart(b, up, i, axis, v) then
      local isHeld, its, isIt = cargo.holds(b, up, axis, v, gain, low, impulse, weight)
      local used = b.gripUsed[up] + its * gain - (isIt and impulse or 0)
      local most = b.grip[up] + (isIt and b.stickiness[up] * weight or 0)
      if not isHeld or max(used, -used) > most * (1 + ROUNDING) then
        return false, mass, hasLow
      end
      mass = mass + its
      if isIt then
        hasLow = true
      end
    end
    up = b.nextCargo[up]
  end
  return true, mass, hasLow
end

--- Lets slot i alone go on at `new` px/s, `way` px further, with an acceleration: what stands on it
--- slides, unless that goes on, too.
function cargo.go(b, i, axis, new, way, accel)
  local k, up = 2 * i + axis, b.cargo[i]
  while up ~= 0 do
    b.groundSpeed[up] = new
    up = b.nextCargo[up]
  end
  b.speed[k], b.to[k], b.accel[k] = new, b.to[k] + way, accel
  path.change(b, i)
end

--- Lets the tower on slot i do that: it goes on at `new` px/s instead of v, `way` px further, with
--- an acceleration. Returns the mass of this part of it, and whether `low` is in that.
function cargo.move(b, i, axis, v, new, way, accel, low, impulse)
  local mass, hasLow, up = b.mass[i], i == low, b.cargo[i]
  while up ~= 0 do
    if isPart(b, up, i, axis, v) then
      local its, isIt = cargo.move(b, up, axis, v, new, way, accel, low, impulse)
      b.gripUsed[up] = b.gripUsed[up] + its * (new - v) - (isIt and impulse or 0)
      mass = mass + its
      if isIt then
        hasLow = true
      end
    end
    up = b.nextCargo[up]
  end
  cargo.go(b, i, axis, new, way, accel)
  return mass, hasLow
end

--- Notes that the tower on slot i has stopped: all of it goes at v px/s now, as its ground does,
--- and `way` px in this step. Who has not moved otherwise goes that way to the bit.
function cargo.stop(b, i, axis, v, way)
  local k, up = 2 * i + axis, b.cargo[i]
  while up ~= 0 do
    if isPart(b, up, i, axis, v) then
      cargo.stop(b, up, axis, v, way)
    end
    up = b.nextCargo[up]
  end
  grip.settle(b, k, b.from[k] + way)
  b.stuck[i] = 1
end

return cargo
