--- Step 6, meet: two that press against each other when the step begins, in the way that most do.
--- Both give way or one of them, with all that is welded to them (see `weld`).
--
-- What is not simple is refused and goes to `resolve`, which would give the same bits. This is
-- called by loops that are compiled; what it has in common with the interpreted files
-- (`path.change`, `impact.at`, ...) is written out here, because the trace compiler gives up
-- functions that interpreted ones call, and with them the loop.
--
-- Writes what `resolve` would write.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local impact = require(here .. ".impact")
local resolve = require(here .. ".resolve")

local press = {}

local ALL = require(here .. ".grip").ALL
local DYNAMIC, STILL = columns.DYNAMIC, columns.STILL
local TINY, VAST = columns.TINY, columns.VAST
local EVEN, ROUNDING, SLOWEST = impact.EVEN, impact.ROUNDING, impact.SLOWEST
local LEAVES, WELDS = resolve.LEAVES, resolve.WELDS
local max, min, sqrt = math.max, math.min, math.sqrt

--- Coefficient of friction of a pair, as in `friction`. Who is not dynamic may have none (< 0).
function press.coefficient(b, i, j)
  local one, other = b.friction[i], b.friction[j]
  if other < 0 or other == one then
    return one
  elseif one < 0 then
    return other
  end
  return sqrt(one * other)
end

-- 1 for a number > 0, else 0.
local function isPositive(v)
  return min(max(v * VAST, 0), 1)
end

--- Whether two that meet at u px/s bounce, as in `resolve`; a px/s² pull them at each other. One
--- question.
function press.bounces(b, i, j, u, a, dt)
  return max(b.restitution[i], b.restitution[j]) * isPositive(u - 2 * a * dt) > 0
end

--- Notes a hit of a pair at u px/s, the first one on `side` of its first. No branches.
function press.noteHit(b, p, side, u)
  local hit, hitSpeed, met = b.hit, b.hitSpeed, b.met[p]
  local isFirst = 1 - min(met, 1)
  hit[p] = hit[p] + (side - hit[p]) * isFirst
  hitSpeed[p] = hitSpeed[p] * (1 - isFirst) + u * isFirst
  b.met[p] = met + 1
end

-- Of a number, without its sign.
local function amount(v)
  return max(v, -v)
end

-- Whether two are not welded to each other. One question: to ask first whether they are welded
-- at all would make three ways.
local function isApart(one, other)
  return min(max(one - other, other - one), 1) + (1 - min(one, 1)) > 0
end

-- 0: none of two has anything with which it pushes the other, but for its limit (see
-- `reserve.pushes`).
local function reserves(b, kl, kh)
  return max(b.reserve[kl], -b.reserve[kh], (b.weld[kl] + b.weld[kh]) * b.reserves)
end

-- Whether nobody is held away from the other or backed, they are not welded to each other, both can
-- be pushed, and they have not met again and again.
local function isSimple(b, p, lo, hi, kl, kh)
  return b.met[p] < LEAVES
    and ((b.pushable[lo] and b.pushable[hi]) or b.kind[lo] ~= DYNAMIC or b.kind[hi] ~= DYNAMIC)
    and b.heldHigh[kl] + b.heldLow[kh] + reserves(b, kl, kh) == 0
    and not (b.backedLow[kl] or b.backedHigh[kl] or b.backedLow[kh] or b.backedHigh[kh])
    and isApart(b.weld[kl], b.weld[kh])
    and b.time[lo] == 0
    and b.time[hi] == 0
end

-- Inverse mass of slot i and of all that is welded to it; 0 if it is `held` (1) against the push.
-- No branches: the two of a pair would make four ways, each with all that follows.
local function weight(b, i, k, held)
  local leader = b.weld[k]
  local isWelded = min(leader, 1)
  local own, common = b.inverseMass[i], isWelded / max(b.weldMass[leader], TINY)
  return (own * (1 - isWelded) + common) * (1 - held)
end

-- What both do together from now on; who cannot give way (`wl`, `wh` 0) decides.
local function share(column, kl, kh, wl, wh)
  if wl == 0 then
    column[kh] = column[kl]
  elseif wh == 0 then
    column[kl] = column[kh]
  else
    local common = (column[kl] * wh + column[kh] * wl) / (wl + wh)
    column[kl], column[kh] = common, common
  end
end

-- Whether the ring of k goes on with another member; 0: k is in none. One question instead of two.
local function isAnother(member, k)
  return (member - k) * member ~= 0
end

-- Marks the ring of k, which may be nobody else, as held on one side.
local function hold(held, weldNext, k)
  held[k] = 1
  local member = weldNext[k]
  while isAnother(member, k) do
    held[member] = 1
    member = weldNext[member]
  end
end

local function lean(b, lo, hi, kl, kh, wl, wh)
  share(b.accel, kl, kh, wl, wh)
  share(b.drive, kl, kh, wl, wh)
  -- Both mean nothing for one that is not dynamic.
  b.pressedHigh[kl], b.pressedLow[kh] = true, true
  if wh == 0 then
    b.holderHigh[kl] = hi
    hold(b.heldHigh, b.weldNext, kl)
  elseif wl == 0 then
    b.holderLow[kh] = lo
    hold(b.heldLow, b.weldNext, kh)
  end
end

-- Puts both flush, with a common speed.
local function place(b, lo, kl, kh, wl, wh, o, v)
  local to, size, speed = b.to, b.size, b.speed
  local shareL, shareH = wl / (wl + wh), wh / (wl + wh)
  local dl, dh = o * shareL, o * shareH
  if dh == 0 and wl > 0 then
    to[kl] = to[kh] - size[kl]
  elseif dl == 0 then
    to[kh] = to[kl] + size[kl]
  else
    to[kl] = to[kl] - dl
    to[kh] = to[kl] + size[kl]
    b.news[lo] = true -- see `place` in resolve
  end
  if v > 0 and wl == 0 then
    speed[kh] = speed[kl]
  elseif v > 0 and wh == 0 then
    speed[kl] = speed[kh]
  elseif v > 0 then
    local common = speed[kl] - v * shareL
    speed[kl], speed[kh] = common, common
  end
end

-- Lets the others of the ring of k follow it, as `ring.follow` does.
local function follow(b, k, way)
  local to, speed, accel, drive, weldNext = b.to, b.speed, b.accel, b.drive, b.weldNext
  local changes, v, a, d, member = b.changes, speed[k], accel[k], drive[k], weldNext[k]
  while isAnother(member, k) do
    to[member], speed[member] = to[member] + way, v
    accel[member], drive[member], changes[member] = a, d, changes[member] + 1
    member = weldNext[member]
  end
end

-- Makes a ring of k, the only one in it, unless it is in one. No branches.
local function found(b, i, k)
  local weld, weldNext, weldMass = b.weld, b.weldNext, b.weldMass
  local isAlone = 1 - min(weld[k], 1)
  weld[k], weldNext[k] = weld[k] + k * isAlone, weldNext[k] + k * isAlone
  weldMass[k] = weldMass[k] * (1 - isAlone) + b.mass[i] * isAlone
end

-- Joins the rings of two whom nothing holds or backs, as `weld.join` does.
local function join(b, lo, hi, kl, kh)
  found(b, lo, kl)
  found(b, hi, kh)
  local weld, weldNext, weldMass = b.weld, b.weldNext, b.weldMass
  -- The shorter ring is named anew, see `ring.isLonger`.
  local member, its = weldNext[kl], weldNext[kh]
  while member ~= kl and its ~= kh do
    member, its = weldNext[member], weldNext[its]
  end
  local isShorter = 1 - min(max(member - kl, kl - member), 1)
  local one, other = kl + (kh - kl) * isShorter, kh + (kl - kh) * isShorter
  local leader = weld[one]
  weldMass[leader] = weldMass[weld[kl]] + weldMass[weld[kh]]
  member = other
  repeat
    weld[member] = leader
    member = weldNext[member]
  until member == other
  local next = weldNext[kl]
  weldNext[kl] = weldNext[kh]
  weldNext[kh] = next
end

-- Whether two rub as they are: they go alike along their common edge, and neither is a wall.
local function isAlike(b, lo, hi, tl, th)
  return b.speed[tl] == b.speed[th]
    and b.accel[tl] == b.accel[th]
    and b.inverseMass[lo] > 0
    and b.inverseMass[hi] > 0
end

-- Approach speed, and the time left after the contact (see `impact.at`). Friction of footings may
-- have shortened a way more than the speed and the acceleration tell. No branches: both cases are
-- worked out.
local function impactAt(o, v, a, dt)
  local start = v - a * dt
  local way = (v + start) * 0.5 * dt * (1 - ROUNDING)
  local reaches = min(max((o - way) * VAST + 1, 0), 1) ---@type number
  local touches = isPositive(start + STILL) * reaches
  -- A speed that is hardly one is none.
  local speed = max(start, 0.0) * isPositive(start - STILL)
  local u = sqrt(max(v * v - 2 * a * o, 0.0)) * isPositive(max(v, -a))
  local closes = isPositive(v + u)
  local tau = max(min(2 * o / max(v + u, SLOWEST), dt), 0.0) * closes + dt * (1 - closes)
  return speed * touches + u * (1 - touches), dt * touches + tau * (1 - touches)
end

--- Who gives way to a press, and what is to come (friction; those welded to the two follow, or the
--- two are joined), as a sum; 0: it is refused.
press.REFUSED, press.LOW, press.HIGH, press.RUBS, press.RINGS = 0, 1, 2, 4, 8
local REFUSED, LOW, HIGH, RUBS, RINGS =
  press.REFUSED, press.LOW, press.HIGH, press.RUBS, press.RINGS

-- Lets those who are welded to the two follow them, and the two be joined; or leaves that to come.
-- Returns `gives`, and RINGS in this case.
local function finish(b, lo, hi, kl, kh, gives)
  if max(b.turnJoins, b.weld[kl], b.weld[kh]) == 0 then
    return gives
  elseif not b.isQuiet then
    return gives + RINGS
  end
  follow(b, kl, b.to[kl] - b.turnLowTo)
  follow(b, kh, b.to[kh] - b.turnHighTo)
  if b.turnJoins > 0 then
    join(b, lo, hi, kl, kh)
  end
  return gives
end

-- Whether two who were pressed rub: not if nothing can come of it.
local function rubs(b, lo, hi, kl, kh)
  if press.coefficient(b, lo, hi) <= 0 then
    return false
  end
  -- From an index along the push to the one across it.
  local sideways = 1 - 2 * (kl - 2 * lo)
  if b.down[kl] == 0 and b.down[kh] == 0 and isAlike(b, lo, hi, kl + sideways, kh + sideways) then
    b.changes[kl], b.changes[kh] = b.changes[kl] + 1, b.changes[kh] + 1
    return false
  end
  return true
end

-- What is to come of two who have run into each other.
local function stop(b, lo, hi, kl, kh, gives)
  b.stuck[lo] = b.stuck[lo] * amount(b.down[kl])
  b.stuck[hi] = b.stuck[hi] * amount(b.down[kh])
  return finish(b, lo, hi, kl, kh, gives + (rubs(b, lo, hi, kl, kh) and RUBS or 0))
end

-- 1 if friction may give slot i anything against going at v px/s, as in `grip`; else 0.
local function mayResist(b, i, v)
  local u, isOnFloor = v - b.groundSpeed[i], max(1 - amount(b.level[i] - 1), 0)
  local isOnFirm = max(isOnFloor, b.stuck[b.ground[i]])
  return isPositive(b.grip[i] * amount(u) * ALL + b.gripUsed[i] * u) * isOnFirm
end

-- 1 if slot i slides on what it stands on, and something may go along with it (see `cargo.isDue`);
-- else 0.
local function slides(b, i, k)
  return isPositive(amount(b.gripUsed[i]) - b.grip[i] * ALL) * min(b.cargo[i] + b.weld[k], 1)
end

-- Whether friction may have to do with a push across gravity: bear some of it (see `grip.mayBear`),
-- or bring somebody along. One question: each more would double the ways through all that follows.
local function isRubbed(b, lo, hi, kl, kh, wl, wh, v)
  local common = b.speed[kl] - v * (wl / (wl + wh))
  local borne = min(wl, wh) * (mayResist(b, lo, common) + mayResist(b, hi, common))
  local taken = slides(b, lo, kl) + slides(b, hi, kh)
  local closes = isPositive(v) * (1 - amount(b.down[kl])) -- across gravity
  return closes * (borne + taken) > 0
end

-- Whether a push across gravity would bring one of two beyond its limit (see `reserve.settle`).
local function isLimited(b, lo, hi, kl, kh, wl, wh, v)
  local common = b.speed[kl] - v * (wl / (wl + wh))
  local overL = b.carried[kl] - common - min(b.limit[kl], b.maxSpeed[lo])
  local overH = common - b.carried[kh] - min(b.limit[kh], b.maxSpeed[hi])
  local isAcross = 1 - max(amount(b.down[kl]), amount(b.down[kh]))
  return min(wl, wh) * isAcross > 0 and max(overL, overH) > 0
end

--- Lets two lean on each other, the pair p of turn x, which meets on `side` of its first, as
--- `resolve` would. Returns REFUSED if the case is another one (nothing has changed then), or who
--- has given way and what is to come of it.
---
--- (What is called last is returned, here and in other files: so nothing is left of the caller,
--- whose numbers the trace compiler would have to keep.)
function press.run(b, x, p, side, lo, hi, axis, dt)
  local kl, kh = 2 * lo + axis, 2 * hi + axis
  local wl, wh = weight(b, lo, kl, b.heldLow[kl]), weight(b, hi, kh, b.heldHigh[kh])
  if wl + wh == 0 or not isSimple(b, p, lo, hi, kl, kh) or b.drive[kl] - b.drive[kh] < -EVEN then
    return REFUSED
  elseif b.pushFirst and wl > 0 and wh > 0 then
    return REFUSED -- one of them takes it all
  end
  local v, o = b.speed[kl] - b.speed[kh], b.to[kl] + b.size[kl] - b.to[kh]
  if b.grip[lo] + b.grip[hi] > 0 and isRubbed(b, lo, hi, kl, kh, wl, wh, v) then
    return REFUSED
  end
  if b.hasLimits and isLimited(b, lo, hi, kl, kh, wl, wh, v) then
    return REFUSED
  end
  local u, tau = impactAt(o, v, b.accel[kl] - b.accel[kh], dt)
  if press.bounces(b, lo, hi, u, b.drive[kl] - b.drive[kh], dt) then
    return REFUSED
  end
  press.noteHit(b, p, side, u)
  -- (Worked out without branches, this would take more numbers than there are registers.)
  local gives = (wl > 0 and LOW or 0) + (wh > 0 and HIGH or 0)
  b.turnLowTo, b.turnHighTo, b.turnJoins = b.to[kl], b.to[kh], 0
  if b.met[p] >= WELDS then
    b.turnJoins = gives == LOW + HIGH and v > 0 and 1 or 0
  end
  place(b, lo, kl, kh, wl, wh, o, v)
  b.changes[kl] = b.changes[kl] + (wl > 0 and 1 or 0)
  b.changes[kh] = b.changes[kh] + (wh > 0 and 1 or 0)
  b.turnSeen[x] = b.changes[kl] + b.changes[kh]
  if v > -STILL then
    lean(b, lo, hi, kl, kh, wl, wh)
  end
  if v <= 0 then
    return finish(b, lo, hi, kl, kh, gives)
  end
  b.turnImpulse[x], b.turnShare[x], b.turnLeft[x] = v / (wl + wh), min(u / v, 1.0), tau
  return stop(b, lo, hi, kl, kh, gives)
end

return press
