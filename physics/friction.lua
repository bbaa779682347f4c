--- Step 6, meet: friction. Coulomb's law with the impulse of the contact.
--
-- An impact rubs at its moment, a weight during the time that is left. On the side where gravity
-- presses, what sticks to something that does not slide holds what stands on it, as far as its own
-- hold bears: the weight above presses it on, too. So a stack of boxes stops as a whole.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local path = require(here .. ".path")
local ring = require(here .. ".ring")
local weld = require(here .. ".weld")

require(here .. ".interpreted").file()

local friction = {}

local DYNAMIC = columns.DYNAMIC
local huge, max, min, sqrt = math.huge, math.max, math.min, math.sqrt
-- Share by which impulses may be rounded: what is borne at one dt is borne at every other.
local ROUNDING = 1e-9
--- Share of what friction can give from which on that is all of it.
friction.ALL = 1 - ROUNDING
local ALL = friction.ALL
local STILL, TINY, VAST = columns.STILL, columns.TINY, columns.VAST

--- Returns the coefficient of a pair: √(a·b); without one of its own (negative) a static or
--- kinematic object takes the other's.
function friction.coefficient(b, i, j)
  local one, other = b.friction[i], b.friction[j]
  if one < 0 then
    one = other
  end
  if other < 0 then
    other = one
  end
  if one <= 0 or other <= 0 then
    return 0
  end
  return one == other and one or sqrt(one * other)
end

-- What is left of u when its amount is less by `loss` >= 0, which does not turn it round. No
-- branches.
local function lessen(u, loss)
  return max(u - loss, 0.0) + min(u + loss, 0.0)
end

-- A speed, or 0 if it is hardly one. No branches.
local function calm(v)
  return v * min(max((max(v, -v) - STILL) * VAST + 1, 0), 1) + 0.0
end

-- Slides at a relative speed that would be `u` at the end of the time left, under a relative
-- acceleration `a`, against an impact that takes up to `impact` px/s at once and a weight that
-- takes up to `weight` px/s over the time. Returns the relative speed at the end and the relative
-- way: first it is braked, for as long as that takes; then, if it is pulled back faster than
-- friction can hold, it goes back. No branches: compiled, each would be a way of its own through
-- all that the caller still has to do.
local function slide(u, a, tau, impact, weight)
  local v = lessen(calm(u - a * tau), impact)
  if tau <= 0 then
    return v, 0
  end
  local hold, amount, sign = weight / tau, max(v, -v), max(min(v * VAST, 1), -1)
  local brake = hold - a * sign -- < 0: it is pulled on, faster than friction can hold
  local braked = min(tau, amount / max(brake, TINY))
  local stop, back = sign * max(amount - brake * tau, 0), lessen(a, hold) * (tau - braked)
  return stop + back, (v + stop) * 0.5 * braked + back * 0.5 * (tau - braked)
end

-- Inverse mass of slot i on the axis of k: that of all that is welded to it there.
local function inverseMass(b, i, k)
  if b.weld[k] ~= 0 then
    return weld.inverseMass(b, k)
  end
  return b.inverseMass[i]
end

-- Whether k stays where it is held, though friction would change its speed: friction pushes it
-- there, so the wall takes that, and two walls that rub the same object do not push it to and fro
-- between them; or it pulls away less than k itself pulls there in the `tau` s that are left.
local function isBarred(b, k, dSpeed, tau)
  if (dSpeed > 0 and b.backedHigh[k]) or (dSpeed < 0 and b.backedLow[k]) then
    return true -- pressed against one that cannot be pushed
  end
  local low, high = b.heldLow[k], b.heldHigh[k]
  if low + high == 0 then
    return false
  end
  local pull = (b.pull[k] + b.push[k]) * tau
  return max(dSpeed * high, -dSpeed * low) > 0
    or (low > 0 and dSpeed > 0 and dSpeed <= -pull)
    or (high > 0 and dSpeed < 0 and -dSpeed <= pull)
end

-- Whom friction has dragged away from what holds it, faster than its own pull brings it back in
-- `tau` s, is held no longer. Returns whether that is so: it falls then, unless it sticks to what
-- rubs it. (Two that go alike are not rubbed at all, see `press`: nobody may be let go of who does
-- not move against who holds it.)
local function endHold(b, k, tau)
  if b.heldLow[k] + b.heldHigh[k] == 0 then
    return false
  end
  local axis, pull = k % 2, b.pull[k] + b.push[k]
  local least = max(pull, -pull) * tau + STILL
  local leavesLow = weld.release(b, k, axis, b.heldLow, b.holderLow, -1, least)
  local leavesHigh = weld.release(b, k, axis, b.heldHigh, b.holderHigh, 1, least)
  return leavesLow or leavesHigh
end

-- Changes speed and way of k, and of all that is welded to it, by what friction took off.
local function shift(b, k, dSpeed, dWay, tau, t)
  if isBarred(b, k, dSpeed, tau) then
    return
  end
  b.speed[k] = b.speed[k] + dSpeed
  b.to[k] = b.to[k] + dWay
  -- (A row that is welded goes on as one, and falls in the next step.)
  if endHold(b, k, tau) and b.weld[k] == 0 then
    path.fall(b, k, tau)
  end
  path.change(b, (k - k % 2) / 2)
  return ring.follow(b, k, dWay, t)
end

-- Speed of the surface of `low` along kw: its own and, along x, that of its belt.
local function surface(b, low, kw)
  local v = b.speed[kw]
  if b.surfaceSpeed[low] ~= 0 and kw == 2 * low then
    v = v + b.surfaceSpeed[low]
  end
  return v
end

-- Returns how large an impulse friction can still give slot i across gravity, in the direction of
-- `sign`: from what it stands on, if that stands fast, and what that stands on. 0: none worth it.
local function graspOf(b, i, sign)
  local least = huge
  repeat
    local grasp = b.grip[i] - sign * b.gripUsed[i]
    if grasp <= b.grip[i] * ROUNDING then
      return 0
    end
    i, least = b.ground[i], min(least, grasp)
  until b.kind[i] ~= DYNAMIC or not b.stuck[i]
  return b.kind[i] ~= DYNAMIC and least or 0
end

-- A weight on slot i presses on all that it stands on.
local function weighOn(b, i, jn)
  repeat
    b.grip[i] = b.grip[i] + b.stickiness[i] * jn
    i = b.ground[i]
  until b.kind[i] ~= DYNAMIC or not b.stuck[i]
end

-- Gives slot i an impulse, from the ground through all that it stands on.
local function give(b, i, impulse)
  repeat
    b.gripUsed[i] = b.gripUsed[i] + impulse
    i = b.ground[i]
  until b.kind[i] ~= DYNAMIC
end

-- `up` rubs on `low`, which does not slide; returns false if the hold of `low` does not bear it.
local function rubOnSteady(b, up, low, ku, kw, mu, jn, share, tau, t)
  local grounded = b.inverseMass[low] == 0
  local w, floorSpeed = inverseMass(b, up, ku), surface(b, low, kw)
  local u, a = b.speed[ku] - floorSpeed, b.accel[ku] - b.accel[kw]
  local limit = mu * jn
  local stop, way = slide(u, a, tau, limit * w * share, limit * w * (1 - share))
  if isBarred(b, ku, stop - u, tau) then
    return true
  end
  local impulse = (stop - u) / w
  if not grounded then
    weighOn(b, low, jn)
    if impulse ~= 0 then
      if max(impulse, -impulse) > graspOf(b, low, impulse > 0 and 1 or -1) * (1 + ROUNDING) then
        return false
      end
      give(b, low, impulse)
    end
  end
  b.grip[up], b.gripUsed[up] = b.grip[up] + limit, b.gripUsed[up] + impulse
  b.ground[up], b.groundSpeed[up], b.stickiness[up] = low, floorSpeed, mu
  if stop == 0 then
    b.stuck[up] = true
    b.speed[ku], b.accel[ku] = floorSpeed, b.accel[kw]
  else
    b.speed[ku] = b.speed[ku] + (stop - u)
  end
  local before = b.to[ku]
  if stop == 0 and way == 0 then
    -- A kinematic object's path began with the step, that of a dynamic one at this moment.
    local left = b.kind[low] == DYNAMIC and 1 or 1 - b.time[up]
    local belt = (floorSpeed - b.speed[kw]) * tau
    b.to[ku] = b.from[ku] + (b.to[kw] - b.from[kw]) * left + belt
  else
    b.to[ku] = before + (way - (u - a * tau + u) * 0.5 * tau)
  end
  endHold(b, ku, tau)
  path.change(b, up)
  ring.follow(b, ku, b.to[ku] - before, t)
  return true
end

-- k sticks to a wall, kw, from now on: it goes where that goes, to the bit.
local function stick(b, k, kw, dSpeed, tau, t)
  if isBarred(b, k, dSpeed, tau) then
    return
  end
  local i, before = (k - k % 2) / 2, b.to[k]
  b.speed[k] = b.speed[kw]
  b.to[k] = b.from[k] + (b.to[kw] - b.from[kw]) * (1 - b.time[i])
  endHold(b, k, tau)
  path.change(b, i)
  return ring.follow(b, k, b.to[k] - before, t)
end

local function rubBoth(b, lo, hi, kl, kh, mu, jn, share, tau, t)
  if b.weld[kl] ~= 0 and b.weld[kl] == b.weld[kh] then
    return
  end
  local wl, wh = inverseMass(b, lo, kl), inverseMass(b, hi, kh)
  local w = wl + wh
  if w == 0 then
    return
  end
  local u, a = b.speed[kl] - b.speed[kh], b.accel[kl] - b.accel[kh]
  local limit = mu * jn * w
  local stop, way = slide(u, a, tau, limit * share, limit * (1 - share))
  local dSpeed, dWay = stop - u, way - (u - a * tau + u) * 0.5 * tau
  if stop == 0 and way == 0 and wh == 0 then
    return stick(b, kl, kh, dSpeed, tau, t)
  elseif stop == 0 and way == 0 and wl == 0 then
    return stick(b, kh, kl, -dSpeed, tau, t)
  end
  -- The shares first: that of one who rubs on a wall is 1 then, and it stops to the bit.
  local shareL, shareH = wl / w, wh / w
  shift(b, kl, dSpeed * shareL, dWay * shareL, tau, t)
  return shift(b, kh, -dSpeed * shareH, -dWay * shareH, tau, t)
end

-- Friction of slot i against going on with others, `mass` in all, at v px/s: gives it what stops
-- them all, or what it can. Returns the impulse, and whether that stops them.
local function resist(b, i, v, mass)
  local u = v - b.groundSpeed[i]
  local amount = max(u, -u)
  if b.grip[i] * amount * ALL + b.gripUsed[i] * u <= 0 then
    return 0, false -- as `press` asks
  end
  local sign, needed = u > 0 and -1 or 1, amount * mass
  local grasp = graspOf(b, i, sign)
  local stops = needed <= grasp * (1 + ROUNDING)
  local impulse = (stops and needed or grasp) * sign
  if grasp > 0 then
    give(b, i, impulse)
  end
  return impulse, stops
end

--- Lets friction bear a push across gravity at the very beginning of a step, as far as it can:
--- `lo` and `hi` close at v px/s, overlap by `o` px at its end, and both give way (inverse masses
--- `wl`, `wh`). It acts on both, who go on together, as long as the push does. Returns the inverse
--- masses for the push (0 for one who stands, and whom friction does not let go), the impulse of
--- the contact, and who stands where it is rubbed (0: neither): so will both.
function friction.bear(b, lo, hi, kl, kh, wl, wh, v, o)
  local mass, common = 1 / wl + 1 / wh, b.speed[kl] - v * (wl / (wl + wh))
  -- Who bears less does not stop who bears more.
  local weak, strong, isLowWeak = hi, lo, b.grip[lo] <= b.grip[hi]
  if isLowWeak then
    weak, strong = lo, hi
  end
  local less, isWeakStill = resist(b, weak, common, mass)
  local more, isStrongStill = resist(b, strong, common + less / mass, mass)
  local still = isStrongStill and strong or (isWeakStill and more == 0 and weak) or 0
  if isStrongStill and less == 0 and strong == lo and b.speed[kl] == b.groundSpeed[lo] then
    return 0, wh, v / wh, lo
  elseif isStrongStill and less == 0 and strong == hi and b.speed[kh] == b.groundSpeed[hi] then
    return wl, 0, v / wl, hi
  end
  local dSpeed = (less + more) / mass
  local dWay = b.pushFirst and 0 or dSpeed * max(o, 0) / v
  b.speed[kl], b.speed[kh] = b.speed[kl] + dSpeed, b.speed[kh] + dSpeed
  b.to[kl], b.to[kh] = b.to[kl] + dWay, b.to[kh] + dWay
  local forLow, forHigh = more, less
  if isLowWeak then
    forLow, forHigh = less, more
  end
  return wl, wh, (v + forLow * wl - forHigh * wh) / (wl + wh), still
end

--- Rubs two that have just met on `axis`, `lo` with the smaller coordinate: `jn` is the impulse of
--- the contact, `share` the part of it that was an impact, `tau` the time left in s, t the moment
--- (0..1). Both paths must begin at this moment.
function friction.rub(b, lo, hi, axis, jn, share, tau, t)
  local mu = friction.coefficient(b, lo, hi)
  if mu == 0 or jn <= 0 then
    return
  end
  local kl, kh = 2 * lo + axis, 2 * hi + axis
  local tl, th = 2 * lo + 1 - axis, 2 * hi + 1 - axis
  local up, low = 0, 0
  local ku, kw ---@type number, number
  if b.down[kl] > 0 then
    up, low, ku, kw = lo, hi, tl, th
  elseif b.down[kh] < 0 then
    up, low, ku, kw = hi, lo, th, tl
  end
  local steady = up ~= 0 and (b.inverseMass[low] == 0 or b.stuck[low])
  if steady and rubOnSteady(b, up, low, ku, kw, mu, jn, share, tau, t) then
    return
  end
  return rubBoth(b, lo, hi, tl, th, mu, jn, share, tau, t)
end

return friction
