--- Step 6, meet: friction. Coulomb's law with the impulse of the contact.
--
-- An impact rubs at its moment, a weight during the time that is left. On the side where gravity
-- presses, what sticks to something that does not slide holds what stands on it, as far as its own
-- hold bears: the weight above presses it on, too. So a stack of boxes stops as a whole.

local here = (...):match("^(.*)%.[^.]+$")
local cargo = require(here .. ".cargo")
local columns = require(here .. ".columns")
local grip = require(here .. ".grip")
local path = require(here .. ".path")
local reserve = require(here .. ".reserve")
local ring = require(here .. ".ring")
local tower = require(here .. ".tower")
local weld = require(here .. ".weld")

require(here .. ".interpreted").file()

local friction = {}

local max, min, sqrt = math.max, math.min, math.sqrt
local advance = path.advance
local ROUNDING = grip.ROUNDING
local EPSILON = columns.EPSILON
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
-- takes up to `weight` px/s over the time. Returns the relative speed at the end, the relative way,
-- and the relative speed behind the impact: first it is braked, for as long as that takes; then, if
-- it is pulled back faster than friction can hold, it goes back. No branches: compiled, each would
-- be a way of its own through all that the caller still has to do.
local function slide(u, a, tau, impact, weight)
  local v = lessen(calm(u - a * tau), impact)
  if tau <= 0 then
    return v, 0, v
  end
  local hold, amount, sign = weight / tau, max(v, -v), max(min(v * VAST, 1), -1)
  local brake = hold - a * sign -- < 0: it is pulled on, faster than friction can hold
  local braked = min(tau, amount / max(brake, TINY))
  local stop, back = sign * max(amount - brake * tau, 0), lessen(a, hold) * (tau - braked)
  return stop + back, (v + stop) * 0.5 * braked + back * 0.5 * (tau - braked), v
end

-- The same of k, against something that goes at `base` px/s and does not give way: it makes up for
-- what friction takes with what its limit keeps from it (see `reserve`). Fourth, how far its path
-- goes as it is, relative to that; then what is left of the reserve, and what is not.
local function slideAgainst(b, k, base, u, a, tau, impact, weight)
  local kept, before = reserve.left(b, k, tau), (u - a * tau + u) * 0.5 * tau
  if kept == 0 or tau <= 0 then
    local stop, way, start = slide(u, a, tau, impact, weight)
    return stop, way, start, before, 0, 0
  end
  local stop, way, start = slide(u + kept, a + kept / tau, tau, impact, weight)
  local top = reserve.top(b, k) - base
  if max(top - u, u - top) <= STILL then
    before = reserve.wayTo(before + kept * 0.5 * tau, u - a * tau, top, kept, tau)
  end
  local over = kept > 0 and max(stop - top, 0.0) or min(stop - top, 0.0)
  if over == 0 then
    return stop, way, start, before, 0, kept
  end
  return top, reserve.wayTo(way, start, top, over, tau), start, before, over, kept - over
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

-- `up` rubs on `low`, which does not slide. Returns whether the hold of `low` bears it, and if it
-- does not, who slides then: `low`, or one of those that it stands on.
local function rubOnSteady(b, up, low, ku, kw, mu, jn, share, tau, t)
  local grounded = b.inverseMass[low] == 0
  local w, floorSpeed = inverseMass(b, up, ku), surface(b, low, kw)
  local u, a = b.speed[ku] - floorSpeed, b.accel[ku] - b.accel[kw]
  local limit, lasting = mu * jn, t < 1 and jn * (1 - share) / (1 - t) or 0
  local impact, weight = limit * w * share, limit * w * (1 - share)
  local stop, way, start, old, kept, used =
    slideAgainst(b, ku, floorSpeed, u, a, tau, impact, weight)
  if isBarred(b, ku, stop - u, tau) then
    return true
  end
  local impulse = (stop - u - used) / w
  if not grounded then
    grip.weighOn(b, low, jn, lasting)
    if impulse ~= 0 then
      if
        max(impulse, -impulse) > grip.left(b, low, impulse > 0 and 1 or -1, 0) * (1 + ROUNDING)
      then
        local weakest = grip.weakest(b, low, impulse > 0 and 1 or -1, 0)
        grip.weighOn(b, low, -jn, -lasting) -- that is another case
        return false, weakest
      end
      grip.give(b, low, impulse)
    end
  end
  grip.note(b, up, low, floorSpeed, mu, limit, impulse, mu * lasting)
  if used ~= 0 then
    b.reserve[ku] = kept
  end
  if stop == 0 then
    b.stuck[up] = 1
    b.speed[ku], b.accel[ku] = floorSpeed, b.accel[kw]
    if not grounded then
      cargo.put(b, up, low)
    end
  else
    b.speed[ku] = b.speed[ku] + (stop - u)
    if tau > 0 then
      -- It is braked all the time: what rubs on it must know that it was not so slow before.
      b.accel[ku] = b.accel[kw] + (stop - start) / tau
      b.gripAccel[up] = b.gripAccel[up] + (stop - start) / tau - a
    end
  end
  local before = b.to[ku]
  if stop == 0 and way == 0 then
    b.to[ku] = grip.goal(b, up, low, ku, kw, floorSpeed, tau)
  else
    b.to[ku] = before + (way - old)
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

-- As `slide` of two, k and m, at a relative speed that is `sign` times that of k; `isAgainst` if m
-- does not give way. Third, how far the path of k goes as it is, relative to m.
local function slideBoth(b, k, m, sign, isAgainst, u, a, tau, impact, weight)
  if b.reserves == 0 or not isAgainst then
    local stop, way = slide(u, a, tau, impact, weight)
    return stop, way, (u - a * tau + u) * 0.5 * tau
  end
  local stop, way, _, before, kept, used =
    slideAgainst(b, k, b.speed[m], u * sign, a * sign, tau, impact, weight)
  if used ~= 0 then
    b.reserve[k] = kept
  end
  return stop * sign, way * sign, before * sign
end

-- Makes two slower against each other by what friction took off, each by its share (inverse masses
-- `wl`, `wh`). `left` is 0 if they do not move against each other then.
local function slow(b, kl, kh, wl, wh, dSpeed, dWay, left, tau, t)
  if max(left, wh) == 0 then
    return stick(b, kl, kh, dSpeed, tau, t)
  elseif max(left, wl) == 0 then
    return stick(b, kh, kl, -dSpeed, tau, t)
  end
  -- The shares first: that of one who rubs on a wall is 1 then, and it stops to the bit.
  local shareL, shareH = wl / (wl + wh), wh / (wl + wh)
  shift(b, kl, dSpeed * shareL, dWay * shareL, tau, t)
  return shift(b, kh, -dSpeed * shareH, -dWay * shareH, tau, t)
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
  local k, m, sign = kl, kh, 1
  if wl == 0 then
    k, m, sign = kh, kl, -1
  end
  local isWall = wl == 0 or wh == 0
  local impact, weight = limit * share, limit * (1 - share)
  local stop, way, before = slideBoth(b, k, m, sign, isWall, u, a, tau, impact, weight)
  local left = max(stop, -stop, way, -way)
  return slow(b, kl, kh, wl, wh, stop - u, way - before, left, tau, t)
end

-- Adds to the accelerations of two what has made them faster by `gainU` and `gainL` px/s over the
-- `tau` s that are left; if they go together now, they have one.
local function addAccel(b, ku, kw, wu, wl, gainU, gainL, tau, isTogether)
  local accel = b.accel
  if isTogether and wu + wl > 0 then
    local common = (accel[ku] * wl + accel[kw] * wu) / (wu + wl)
    accel[ku], accel[kw] = common, common
  elseif tau > 0 then
    accel[ku], accel[kw] = accel[ku] + gainU / tau, accel[kw] + gainL / tau
  end
end

-- Lets a tower go on at `new` px/s instead of v, `way` px further, with an acceleration, as a part
-- of it gets an impulse (see `tower.move`).
local function moveTower(b, first, last, axis, v, new, way, accel, impulse)
  tower.move(b, first, last, axis, new, new - v, way, accel, impulse)
  tower.tell(b, first, last, new)
end

local weighOnTower -- defined below

-- Lists the tower that slides with slot i (see `cargo.listTower`), the paths of all on which begin
-- anew at moment t.
local function listTowerAt(b, i, axis, t)
  local last, base, mass = cargo.listTower(b, i, axis, 0)
  if base == 0 or t == 0 then
    return last, base, mass
  end
  advance(b, base, t)
  for n = 1, (tower.list(b, base, axis, 0, 0, 0)) do
    advance(b, b.tower[n], t)
  end
  return cargo.listTower(b, i, axis, 0)
end

-- The tower on slot `base` slides over one that slides, too: the impulse jn of a weight on it lets
-- the two rub more, unless one of them would not hold together, and so on down to what stands fast.
local function rubTowers(b, base, axis, jn, share, tau, t)
  local k, ground = 2 * base + axis, b.ground[base]
  local m = 2 * ground + axis
  local lowLast, low, lowMass = listTowerAt(b, ground, axis, t)
  if low == 0 or b.level[low] >= b.level[base] then
    return
  end
  local v, lowSpeed, first = b.speed[k], b.speed[m], lowLast + 1
  local last, mass = tower.listParts(b, base, axis, v, lowLast)
  tower.markThrough(b, ground, low)
  local slip = v - lowSpeed
  local needed, limit = max(slip, -slip) / (1 / mass + 1 / lowMass), b.stickiness[base] * jn
  local impulse = (slip > 0 and -1 or 1) * min(needed, limit)
  local gain, lowGain, stops = impulse / mass, -impulse / lowMass, needed <= limit
  if not tower.holds(b, 1, lowLast, lowGain, -impulse, 0) then
    return weighOnTower(b, low, axis, jn, share, tau, t)
  elseif tower.holds(b, first, last, gain, 0, 0) then
    local common = (b.accel[k] * mass + b.accel[m] * lowMass) / (mass + lowMass)
    local accel = stops and common or b.accel[k] + gain * (1 - share) / tau
    local lowAccel = stops and common or b.accel[m] + lowGain * (1 - share) / tau
    local new, lowNew = v + gain, stops and v + gain or lowSpeed + lowGain
    local part = tau * (0.5 + 0.5 * share)
    moveTower(b, 1, lowLast, axis, lowSpeed, lowNew, lowGain * part, lowAccel, -impulse)
    moveTower(b, first, last, axis, v, new, gain * part, accel, 0)
  elseif limit > 0 then
    impulse = cargo.brake(b, base, axis, limit, lowSpeed + lowGain, b.accel[m], share, tau)
    lowLast, low = cargo.listTower(b, ground, axis, 0)
    lowGain = -impulse / lowMass
    tower.markThrough(b, ground, low)
    local lowAccel = b.accel[m] + lowGain * (1 - share) / tau
    local way = lowGain * tau * (0.5 + 0.5 * share)
    moveTower(b, 1, lowLast, axis, lowSpeed, lowSpeed + lowGain, way, lowAccel, -impulse)
  end
  b.gripUsed[base] = b.gripUsed[base] + impulse
  return weighOnTower(b, low, axis, jn, share, tau, t)
end

-- Whether slot i goes as slot j does since the step began, where moment t has got to, but for what
-- was between them.
local function goesAs(b, i, j, axis, t)
  local k, m, velocity, carried = 2 * i + axis, 2 * j + axis, b.velocity, b.carried
  return b.speed[k] == b.speed[m]
    and b.time[i] == t
    and b.time[j] == t
    and velocity[k] + carried[k] == velocity[m] + carried[m]
end

-- Slot i, which stood, is dragged off what it stands on, or takes that along, down to `weakest`.
-- (Who was to stop there, and on the way was braked in another way than that, goes on with it.)
local function dragOff(b, i, weakest, axis, t)
  local from, to, m = b.from, b.to, 2 * weakest + axis
  while i ~= weakest do
    local k = 2 * i + axis
    if goesAs(b, i, weakest, axis, t) then
      to[k] = from[k] + (to[m] - from[m])
      path.change(b, i)
    end
    b.stuck[i], i = 0, b.ground[i]
  end
  b.stuck[weakest] = 0
end

-- Slot `base` has been dragged off what it stands on: what would have held it still brakes it.
local function brakeOff(b, base, axis, tau, t)
  local k = 2 * base + axis
  local slip = b.speed[k] - b.groundSpeed[base]
  if tau <= 0 or slip == 0 then
    return
  end
  local _, slider = listTowerAt(b, base, axis, t)
  if slider ~= base then
    return
  end
  local left = grip.left(b, base, slip > 0 and -1 or 1, t)
  if left > 0 then
    return weighOnTower(b, base, axis, left / b.stickiness[base], 0, tau, t)
  end
end

-- The tower on slot `base` slides over what stands fast, and is braked there by what the impulse jn
-- of a weight on it adds to its friction; if it would not hold together, its lowest one is, and the
-- others go along as far as friction can take them.
local function brakeTower(b, base, axis, jn, share, tau, t)
  local k, ground = 2 * base + axis, b.ground[base]
  local v, m = b.speed[k], 2 * ground + axis
  local last, mass = tower.listParts(b, base, axis, v, 0)
  local limit = b.stickiness[base] * jn
  local slip = v - b.groundSpeed[base]
  local amount, sign = max(slip, -slip), slip > 0 and -1 or 1
  local isBorne = b.inverseMass[ground] > 0 -- by friction under that
  local borne = reserve.bear(b, base, k, sign * limit, tau)
  if borne ~= 0 then
    limit = limit - sign * borne
    b.gripUsed[base] = b.gripUsed[base] + borne
    if isBorne then
      grip.give(b, ground, borne)
    end
  end
  if isBorne then
    local left = grip.left(b, ground, sign, t)
    if min(limit, amount * mass) > left * (1 + ROUNDING) and cargo.isFree(b, m) then
      local weakest = grip.weakest(b, ground, sign, t)
      dragOff(b, ground, weakest, axis, t)
      rubTowers(b, base, axis, jn, share, tau, t)
      return brakeOff(b, weakest, axis, tau, t)
    end
    limit = min(limit, left)
  end
  local gain, floorSpeed = sign * min(amount, limit / mass), b.groundSpeed[base]
  local impulse, stops = gain * mass, amount * mass <= limit
  if tower.holds(b, 1, last, gain, 0, 0) then
    local new = stops and floorSpeed or v + gain
    local accel = stops and b.accel[m] or b.accel[k] + gain * (1 - share) / tau
    moveTower(b, 1, last, axis, v, new, gain * tau * (0.5 + 0.5 * share), accel, 0)
  elseif limit > 0 then
    impulse, stops = cargo.brake(b, base, axis, limit, floorSpeed, b.accel[m], share, tau)
  end
  b.gripUsed[base] = b.gripUsed[base] + impulse
  if isBorne then
    grip.give(b, ground, impulse)
  end
  if stops then
    -- (Who went as fast as the ground does before has stopped with it.)
    last = tower.listParts(b, base, axis, floorSpeed, 0)
    local goal = grip.goal(b, base, ground, k, m, floorSpeed, tau)
    tower.stop(b, 1, last, axis, goal - b.from[k])
  end
end

-- The impulse jn of a weight on the tower on slot `base`, which slides, lets it rub more.
function weighOnTower(b, base, axis, jn, share, tau, t)
  if b.level[base] > 1 and b.stuck[b.ground[base]] == 0 then
    return rubTowers(b, base, axis, jn, share, tau, t)
  end
  return brakeTower(b, base, axis, jn, share, tau, t)
end

-- Whether slot i touches somebody across gravity: k on that axis, m along.
local function hasFlank(b, i, k, m)
  local from, size, half = b.from, b.size, b.head[i]
  while half ~= 0 do
    local j = b.other[half]
    local kj, mj = 2 * j + k - 2 * i, 2 * j + m - 2 * i
    local across = max(from[k] - from[kj] - size[kj], from[kj] - from[k] - size[k])
    local along = max(from[m] - from[mj] - size[mj], from[mj] - from[m] - size[m])
    if max(across, -across) <= EPSILON and along < -EPSILON then
      return true
    end
    half = b.next[half]
  end
  return false
end

-- Whether anybody in the list touches somebody across gravity.
local function haveFlanks(b, first, last, axis)
  for n = first, last do
    local i = b.tower[n]
    if hasFlank(b, i, 2 * i + axis, 2 * i + 1 - axis) then
      return true
    end
  end
  return false
end

-- The weight of `up` has braked the tower that `low` is a part of so much that they pass each
-- other within `tau` s, and close at `u` px/s then: from that moment on friction holds them
-- together, or acts the other way. It can give an impulse of `limit`, a `share` of it at once, and
-- has. (When the step begins, whoever pushes the tower has not done so yet, and that may be why.)
local function turnRub(b, up, low, ku, kw, axis, u, limit, share, tau, t)
  local last, base, mass = cargo.listTower(b, low, axis, 0)
  if base == 0 or (t == 0 and haveFlanks(b, 1, last, axis)) then
    return
  end
  local speed, accel, to, wu = b.speed, b.accel, b.to, b.inverseMass[up]
  local start, after, most = u - (accel[ku] - accel[kw]) * tau, tau, 2 * limit
  if start * u < 0 then
    after = tau * u / (u - start)
    most = most * (1 - share) * after / tau
  end
  local needed = max(u, -u) / (wu + 1 / mass)
  local isTogether = needed <= most * (1 + ROUNDING)
  local impulse = (u > 0 and 1 or -1) * min(needed, most)
  local gain, loss = impulse / mass, impulse * wu
  tower.markThrough(b, low, base)
  if not tower.holds(b, 1, last, gain, impulse, 0) then
    return
  end
  moveTower(b, 1, last, axis, speed[kw], speed[kw] + gain, gain * after * 0.5, accel[kw], impulse)
  speed[ku], to[ku] = isTogether and speed[kw] or speed[ku] - loss, to[ku] - loss * after * 0.5
  accel[ku] = isTogether and accel[kw] or accel[ku]
  b.gripUsed[up] = b.gripUsed[up] - impulse
end

-- `up` rubs on `low`, a part of a tower of this mass that slides on slot `base` (see
-- `cargo.listTower`): they share what is between them, then its weight brakes the tower. Returns
-- false, and changes nothing, if the case is another one.
local function rubOnTower(b, up, low, last, base, mass, ku, kw, mu, jn, share, tau, t)
  if not cargo.isFree(b, ku) or b.surfaceSpeed[low] ~= 0 or tau <= 0 then
    return false
  end
  local axis, v, wu = ku - 2 * up, b.speed[kw], b.inverseMass[up]
  local u, a, w = b.speed[ku] - v, b.accel[ku] - b.accel[kw], wu + 1 / mass
  local stop, way, start = slide(u, a, tau, mu * jn * w * share, mu * jn * w * (1 - share))
  local impulse = (stop - u) / w
  local gain = -impulse / mass
  tower.markThrough(b, low, base)
  if not tower.holds(b, 1, last, gain, -impulse, jn) then
    return false
  end
  local lasting = jn * (1 - share) / (1 - t)
  grip.weighOn(b, low, jn, lasting)
  local dWay = way - (u - a * tau + u) * 0.5 * tau
  -- The relative acceleration from now on: none, if they go together.
  local da = (stop == 0 and 0 or (stop - start) / tau) - a
  local accel = b.accel[kw] - da / mass / w
  moveTower(b, 1, last, axis, v, v + gain, -dWay / mass / w, accel, -impulse)
  b.speed[ku] = stop == 0 and b.speed[kw] or b.speed[ku] + impulse * wu
  b.to[ku] = b.to[ku] + dWay * wu / w
  b.accel[ku] = stop == 0 and accel or b.accel[ku] + da * wu / w
  grip.note(b, up, low, b.speed[kw], mu, mu * jn, impulse, mu * lasting)
  cargo.put(b, up, low)
  path.change(b, up)
  weighOnTower(b, base, axis, jn, share, tau, t)
  local closing = b.speed[ku] - b.speed[kw]
  if closing * stop < 0 then
    turnRub(b, up, low, ku, kw, axis, closing, mu * jn, share, tau, t)
  end
  return true
end

-- `up` rubs on `low`, which slides on something rough itself.
local function rubOnSliding(b, lo, hi, tl, th, up, low, ku, kw, mu, jn, share, tau, t)
  local last, base, mass = listTowerAt(b, low, kw - 2 * low, t)
  if base ~= 0 and rubOnTower(b, up, low, last, base, mass, ku, kw, mu, jn, share, tau, t) then
    return
  end
  local wu, wl = inverseMass(b, up, ku), inverseMass(b, low, kw)
  local speedU, speedL = b.speed[ku], b.speed[kw]
  rubBoth(b, lo, hi, tl, th, mu, jn, share, tau, t)
  local gainU, gainL = b.speed[ku] - speedU, b.speed[kw] - speedL
  local floorSpeed = surface(b, low, kw)
  local slip = b.speed[ku] - floorSpeed
  local isTogether = max(slip, -slip) < STILL and floorSpeed == b.speed[kw]
  addAccel(b, ku, kw, wu, wl, gainU * (1 - share), gainL * (1 - share), tau, isTogether)
  local impulse, limit = wu > 0 and gainU / wu or 0, mu * jn
  grip.note(b, up, low, floorSpeed, mu, limit, impulse, limit * (1 - share))
  if isTogether then
    b.speed[ku] = b.speed[kw]
  end
  cargo.put(b, up, low)
end

-- Whether nobody on slot i moves on it, or is held by anything else than that.
local function isCargoStill(b, i, axis)
  local up = b.cargo[i]
  while up ~= 0 do
    if b.gripUsed[up] ~= 0 or b.ground[up] ~= i or not cargo.isFree(b, 2 * up + axis) then
      return false
    end
    up = b.nextCargo[up]
  end
  return true
end

-- The impulse of the weight on slot i in a step, or what is left of it from moment t on.
local function weightOn(b, i, t)
  return (b.grip[i] - b.gripHit[i]) / b.stickiness[i] * (1 - t)
end

--- Lets friction act on slot i, which was hit at moment t of the step, and on what stands on it, in
--- the `tau` s that are left: all of it was still.
function friction.hit(b, i, axis, tau, t)
  local k = 2 * i + axis
  if tau <= 0 or b.level[i] == 0 or b.grip[i] == 0 or b.gripUsed[i] ~= 0 then
    return
  elseif b.cargo[i] == 0 and b.level[i] == 1 then
    return
  elseif b.speed[k] == b.groundSpeed[i] or not isCargoStill(b, i, axis) then
    return
  end
  local _, base = listTowerAt(b, i, axis, t)
  if base ~= i then
    return
  end
  local weight, up = weightOn(b, i, t), b.cargo[i]
  while up ~= 0 do
    local its = weightOn(b, up, t)
    b.stuck[up], weight = 0, weight - its
    rubTowers(b, up, axis, its, 0, tau, t)
    up = b.nextCargo[up]
  end
  return weighOnTower(b, i, axis, max(weight, 0), 0, tau, t)
end

--- Lets friction brake slot i, which bounces off somebody, on what it stands on, for `tau` s from
--- moment t on: it was still, or slower, when it was rubbed.
function friction.brake(b, i, axis, tau, t)
  local k, low = 2 * i + axis, b.ground[i]
  if tau <= 0 or b.level[i] ~= 1 or b.cargo[i] ~= 0 or not cargo.isFree(b, k) then
    return
  end
  local u, a, w =
    b.speed[k] - b.groundSpeed[i], b.accel[k] - b.accel[2 * low + axis], b.inverseMass[i]
  local stop, way = slide(u, a, tau, 0, grip.left(b, i, u > 0 and -1 or 1, t) * w)
  if stop == u then
    return
  end
  local accel = (stop - u) / tau
  b.speed[k], b.accel[k] = b.speed[k] + (stop - u), b.accel[k] + accel
  b.gripAccel[i] = b.gripAccel[i] + accel
  b.to[k] = b.to[k] + (way - (u - a * tau + u) * 0.5 * tau)
  grip.give(b, i, (stop - u) / w)
  return path.change(b, i)
end

--- Rubs two that have just met on `axis`, `lo` with the smaller coordinate: `jn` is the impulse of
--- the contact, `share` the part of it that was an impact, `tau` the time left in s, t the moment
--- (0..1). Both paths must begin at this moment.
function friction.rub(b, lo, hi, axis, jn, share, tau, t)
  local mu = friction.coefficient(b, lo, hi)
  if mu == 0 or jn <= 0 then
    return
  end
  b.rubs = 1
  local kl, kh = 2 * lo + axis, 2 * hi + axis
  local tl, th = 2 * lo + 1 - axis, 2 * hi + 1 - axis
  local up, low = 0, 0
  local ku, kw ---@type number, number
  if b.down[kl] > 0 then
    up, low, ku, kw = lo, hi, tl, th
  elseif b.down[kh] < 0 then
    up, low, ku, kw = hi, lo, th, tl
  end
  -- (Who is pulled another way rubs on another axis.)
  local isAlike = up ~= 0 and b.down[kl] == b.down[kh]
  local weakest = 0
  if up ~= 0 and (b.inverseMass[low] == 0 or (b.stuck[low] > 0 and isAlike)) then
    local isBorne, slider = rubOnSteady(b, up, low, ku, kw, mu, jn, share, tau, t)
    if isBorne then
      return
    end
    weakest = slider
    dragOff(b, low, weakest, 1 - axis, t)
  end
  if isAlike and b.grip[low] > 0 then
    rubOnSliding(b, lo, hi, tl, th, up, low, ku, kw, mu, jn, share, tau, t)
    return weakest ~= 0 and brakeOff(b, weakest, 1 - axis, tau, t)
  end
  return rubBoth(b, lo, hi, tl, th, mu, jn, share, tau, t)
end

return friction
