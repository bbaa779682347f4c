--- Step 6, meet: push and restitution of one pair at its moment.
--
-- A contact changes where both will be at the end of the step, their speeds there, and lets their
-- paths begin anew. Who cannot give way on that side (static, kinematic, not pushable, or held by
-- one that cannot) stays, and the other takes the whole push; so what rests is flush to the bit,
-- because its coordinate is assigned, not corrected.
--
-- Reads inverseMass, pushable, restitution, and what the modules below have written; writes from,
-- to, speed, accel, drive, time, stuck, news, heldLow, heldHigh, holderLow, holderHigh, pressedLow,
-- pressedHigh, met, hit, hitSpeed and `changed`.

local here = (...):match("^(.*)%.[^.]+$")
local cargo = require(here .. ".cargo")
local columns = require(here .. ".columns")
local crush = require(here .. ".crush")
local friction = require(here .. ".friction")
local grip = require(here .. ".grip")
local impact = require(here .. ".impact")
local path = require(here .. ".path")
local reserve = require(here .. ".reserve")
local ring = require(here .. ".ring")
local weld = require(here .. ".weld")

require(here .. ".interpreted").file()

local resolve = {}

local max, min = math.max, math.min
local advance, change = path.advance, path.change
local DYNAMIC = columns.DYNAMIC

-- Hits of one pair in one step after which it bounces no more.
local BOUNCES = 4
--- The same: after which it does not even leave by its own acceleration.
resolve.LEAVES = 8
local LEAVES = resolve.LEAVES
--- The same: hits without a bounce after which it is welded.
resolve.WELDS = 3
local WELDS = resolve.WELDS
--- The same: after which it is left alone.
resolve.PATIENCE = 32
local PATIENCE = resolve.PATIENCE
local STILL, VAST = columns.STILL, columns.VAST

-- Whether k goes towards high (`sign` 1) or low coordinates (-1), and ends there, too: with `push =
-- "first"` who shares a speed may be put back.
local function goes(b, k, sign)
  return b.speed[k] * sign > 0 and (b.to[k] - b.from[k]) * sign >= 0
end

-- Inverse masses for a push between `lo` and `hi`; 0: cannot give way. Third, whether they meet
-- head-on and neither can be pushed.
local function weights(b, lo, hi, kl, kh)
  local wl, wh = b.inverseMass[lo], b.inverseMass[hi]
  if b.weld[kl] ~= 0 then
    wl = weld.inverseMass(b, kl)
  end
  if b.weld[kh] ~= 0 then
    wh = weld.inverseMass(b, kh)
  end
  if b.heldLow[kl] > 0 then
    wl = 0
  end
  if b.heldHigh[kh] > 0 then
    wh = 0
  end
  if b.pushable[lo] ~= b.pushable[hi] and b.kind[lo] == DYNAMIC and b.kind[hi] == DYNAMIC then
    -- One that is held counts as a wall even for whoever cannot be pushed. Who pushes a row with
    -- one behind it that cannot be pushed either does as if it had run into that: it follows, or
    -- both stop.
    local ownL, ownH = wl, wh
    if b.pushable[lo] then
      wh = wl > 0 and 0 or wh
      if wh == 0 and b.heldHigh[kh] == 0 and b.backedLow[kl] and b.speed[kh] < 0 then
        local follows = goes(b, kl, -1)
        return 0, follows and ownH or 0, not follows
      end
    else
      wl = wh > 0 and 0 or wl
      if wl == 0 and b.heldLow[kl] == 0 and b.backedHigh[kh] and b.speed[kl] > 0 then
        local follows = goes(b, kh, 1)
        return follows and ownL or 0, 0, not follows
      end
    end
  end
  if wl > 0 and wh > 0 and not b.pushable[lo] and not b.pushable[hi] then
    -- Neither pushes the other: who comes up from behind stops, two that meet head-on both stop.
    if b.speed[kh] >= 0 then
      wh = 0
    elseif b.speed[kl] <= 0 then
      wl = 0
    else
      return 0, 0, true
    end
  end
  return wl, wh
end

-- Moves the end of the paths of `lo` and the other by their shares of `way`; if they end flush, the
-- coordinate of one is assigned from that of the other: never that of one who does not give way, or
-- a wall would be moved by rounding when there is no way at all.
local function place(b, lo, kl, kh, way, shareL, shareH, flush)
  local to, size, dl, dh = b.to, b.size, way * shareL, way * shareH
  if not flush then
    to[kl], to[kh] = to[kl] - dl, to[kh] + dh
  elseif dh == 0 and shareL > 0 then
    to[kl] = to[kh] - size[kl]
  elseif dl == 0 then
    to[kh] = to[kl] + size[kl]
  else
    to[kl] = to[kl] - dl
    to[kh] = to[kl] + size[kl]
    -- Where two that both give way come to lie is rounded, and not the same at every dt: no rest
    -- for their island.
    b.news[lo] = true
  end
end

-- Shares of a push: by weight, or all to the one that ran into the other.
-- The latter leads nowhere for two that are inside each other, or meet again and again.
local function shares(b, lo, hi, kl, kh, wl, wh, isStubborn)
  if b.pushFirst and wl > 0 and wh > 0 and not isStubborn then
    local towards, against = b.to[kl] - b.from[kl], b.from[kh] - b.to[kh]
    if towards > against or (towards == against and b.rank[lo] < b.rank[hi]) then
      return 1, 0
    end
    return 0, 1
  end
  return wl / (wl + wh), wh / (wl + wh)
end

local function setSpeeds(b, kl, kh, wl, wh, dv, common)
  local speed = b.speed
  local share = wl / (wl + wh)
  if not common then
    speed[kl], speed[kh] = speed[kl] - dv * share, speed[kh] + dv * (1 - share)
  elseif wl == 0 then
    speed[kh] = speed[kl]
  elseif wh == 0 then
    speed[kl] = speed[kh]
  else
    local v = speed[kl] - dv * share
    speed[kl], speed[kh] = v, v
  end
end

local function shareAccel(accel, kl, kh, wl, wh)
  if wl == 0 then
    accel[kh] = accel[kl]
  elseif wh == 0 then
    accel[kl] = accel[kh]
  else
    local common = (accel[kl] * wh + accel[kh] * wl) / (wl + wh)
    accel[kl], accel[kh] = common, common
  end
end

-- Whether slot i, which does not give way towards low (high) coordinates, is a wall to what leans
-- on it. One that merely cannot be pushed is not: it stops where that has no place to go, unless
-- another such one is behind it.
local function isWall(b, i, held, backed)
  return b.kind[i] ~= DYNAMIC or held or backed
end

-- What two that rest against each other now do together. Who pushes one of a row and cannot be
-- pushed is behind the whole row.
local function lean(b, lo, hi, kl, kh, wl, wh)
  if b.kind[lo] == DYNAMIC then
    b.pressedHigh[kl] = true
    if wh == 0 and isWall(b, hi, b.heldHigh[kh] > 0, b.backedLow[kl]) then
      ring.hold(b, kl, 0, 1)
      b.holderHigh[kl] = hi
    else
      weld.back(b, kl, false, wh == 0 or b.backedHigh[kh])
    end
  end
  if b.kind[hi] == DYNAMIC then
    b.pressedLow[kh] = true
    if wl == 0 and isWall(b, lo, b.heldLow[kl] > 0, b.backedHigh[kh]) then
      ring.hold(b, kh, 1, 0)
      b.holderLow[kh] = lo
    else
      weld.back(b, kh, wl == 0 or b.backedLow[kl], false)
    end
  end
end

-- Two of one welded group differ by rounding only: one follows the other.
local function rejoin(b, lo, hi, kl, kh)
  if b.heldHigh[kh] > 0 then
    b.to[kl], b.speed[kl] = b.to[kh] - b.size[kl], b.speed[kh]
    change(b, lo)
  else
    b.to[kh], b.speed[kh] = b.to[kl] + b.size[kl], b.speed[kl]
    change(b, hi)
  end
  b.pressedHigh[kl], b.pressedLow[kh] = true, true
end

-- Two that neither can be pushed nor push run into each other head-on, or into the two ends of a
-- row, which stops with them.
local function stopBoth(b, lo, hi, kl, kh, t)
  local to, speed, accel = b.to, b.speed, b.accel
  local oldL, oldH = to[kl], to[kh]
  to[kh] = b.from[kh]
  to[kl] = to[kh] - b.size[kl]
  speed[kl], speed[kh], accel[kl], accel[kh] = 0, 0, 0, 0
  b.pressedHigh[kl], b.pressedLow[kh] = true, true
  -- What is between two of them cannot give way; they themselves still do to walls.
  local holdsLow, holdsHigh = b.pushable[lo] and 1 or 0, b.pushable[hi] and 1 or 0
  ring.hold(b, kl, holdsLow, holdsLow)
  ring.hold(b, kh, holdsHigh, holdsHigh)
  change(b, lo)
  change(b, hi)
  ring.follow(b, kl, to[kl] - oldL, t)
  ring.follow(b, kh, to[kh] - oldH, t)
end

local function countHit(b, p, lo, hi, axis)
  b.met[p] = b.met[p] + 1
  if b.met[p] == PATIENCE then
    crush.giveUp(b, lo, hi, axis)
  end
end

-- Notes the first hit of the step: its side and its speed. No branches: compiled, this is in the
-- middle of a way through the code on which most numbers of `run` are needed later on.
local function noteHit(b, p, lo, hi, axis, u)
  local hit, hitSpeed, first = b.hit, b.hitSpeed, b.pairA[p]
  local isFirst = 1 - min(b.met[p], 1)
  local side = 2 * axis + 2 - min(max(first - lo, lo - first), 1)
  hit[p] = hit[p] + (side - hit[p]) * isFirst
  hitSpeed[p] = hitSpeed[p] * (1 - isFirst) + u * isFirst
  countHit(b, p, lo, hi, axis)
end

-- Whether the one of two that cannot give way is held by the other.
local function holdEachOther(b, lo, hi, axis, wl, wh)
  return (wh == 0 and b.kind[hi] == DYNAMIC and crush.isRing(b, hi, lo, axis, false))
    or (wl == 0 and b.kind[lo] == DYNAMIC and crush.isRing(b, lo, hi, axis, true))
end

-- Of two who both count as held, frees who is held by nobody (see `crush.hasNoHolder`): it may go
-- where its row cannot. Returns their inverse masses anew.
local function free(b, lo, hi, kl, kh, axis)
  if crush.hasNoHolder(b, lo, hi, axis, true) then
    weld.leave(b, kl)
    b.heldLow[kl] = 0
  end
  if crush.hasNoHolder(b, hi, lo, axis, false) then
    weld.leave(b, kh)
    b.heldHigh[kh] = 0
  end
  return weights(b, lo, hi, kl, kh)
end

-- Who is thrown back from what held it is held no longer, and falls.
local function release(b, kl, kh, axis, flush, tau)
  if weld.release(b, kl, axis, b.heldHigh, b.holderHigh, 1, STILL) and not flush then
    path.fall(b, kl, tau)
  end
  if weld.release(b, kh, axis, b.heldLow, b.holderLow, -1, STILL) and not flush then
    path.fall(b, kh, tau)
  end
end

-- Who has gone away from what held it, from an earlier moment of the step on, is held by that no
-- longer. (Of those who were pushed there again and again.)
local function leave(b, i, k, axis, held, holder, sign, t)
  if b.time[i] < t then
    weld.release(b, k, axis, held, holder, sign, STILL)
  end
end

-- Whether friction under the two may have to do with a push: it goes across gravity. One question.
local function isRubbed(b, p, kl, kh, dv)
  local downL, downH = b.down[kl], b.down[kh]
  return min(dv, LEAVES + 1 - b.met[p], 1 - downL * downL, 1 - downH * downH) > 0
end

-- Whether a push may be one of those in which what a limit keeps from somebody has its part.
local function lends(b, p, kl, kh, wl, wh, dv)
  return dv > 0 and min(wl, wh) > 0 and b.met[p] <= LEAVES and reserve.pushes(b, kl, kh)
end

-- Lets friction have its part in a push of two that close at v px/s: what stands on them goes
-- along, and what they stand on bears it. Returns the inverse masses, v and o as they are for the
-- push then; its impulse, who stands still now (0: neither), and whether anything goes along.
local function withFriction(b, lo, hi, kl, kh, axis, wl, wh, v, o, dt)
  local isBorne, still, isLoaded = grip.mayBear(b, lo, hi, kl, wl, wh, v), 0, false
  if b.hasCargo and (isBorne or cargo.isDue(b, lo, hi, kl, kh)) then
    wl, wh, v, o, isLoaded = cargo.load(b, kl, kh, axis, wl, wh, v, o, dt)
  end
  local impulse = v / (wl + wh)
  if isBorne then
    wl, wh, impulse, still = grip.bear(b, lo, hi, kl, kh, wl, wh, v, 0, dt)
  end
  return wl, wh, v, o, impulse, still, isLoaded
end

-- Whether slot i is rubbed, if at all, by one that nobody pushes, and nothing goes along with it.
local function stands(b, i)
  return max(b.level[i] - 1, b.cargo[i]) <= 0
end

-- Whether friction would turn slot i round that has another speed now, within `tau` s.
local function turns(b, i, speed, tau)
  local u, brake = speed - b.groundSpeed[i], b.gripAccel[i]
  return u * brake < 0 and max(u, -u) < max(brake, -brake) * tau
end

-- Whether friction goes on braking slot i as it did, `tau` s more.
local function goesOn(b, i, speed, tau)
  return (speed - b.groundSpeed[i]) * b.gripAccel[i] <= 0 and not turns(b, i, speed, tau)
end

-- The acceleration that friction gives two that meet at moment t, closing at u px/s, `tau` s before
-- the step ends, towards each other: it is in their paths, and goes on (see `friction.brake`).
local function braking(b, lo, hi, kl, kh, wl, wh, restitution, u, t, tau)
  local brake, speed, accel = b.gripAccel[lo] - b.gripAccel[hi], b.speed, b.accel
  if brake == 0 or b.down[kl] ~= 0 or b.down[kh] ~= 0 or not (stands(b, lo) and stands(b, hi)) then
    return 0
  elseif restitution == 0 and t == 0 then
    return 0 -- whether those part who lean on each other shows in the next step
  end
  local speedL, speedH = speed[kl] - accel[kl] * tau, speed[kh] - accel[kh] * tau
  local impulse = (1 + restitution) * u / (wl + wh)
  speedL, speedH = speedL - impulse * wl, speedH + impulse * wh
  if restitution == 0 then
    return goesOn(b, lo, speedL, tau) and goesOn(b, hi, speedH, tau) and brake or 0
  end
  return (turns(b, lo, speedL, tau) or turns(b, hi, speedH, tau)) and 0 or brake
end

-- What a push needs until it is over waits in fields, and what it needs for a while only is in a
-- block: otherwise it would be more numbers than there are registers, and LuaJIT could not continue
-- what it has compiled.

-- What a push leads to: it makes two slower against each other by dv px/s, with an impulse, and
-- friction lets `still` stand (0: neither).
local function goOn(b, p, lo, hi, kl, kh, axis, wl, wh, dv, impulse, still, tau, t, dt)
  do
    local speed, to, flush = b.speed, b.to, b.pushIsFlush
    -- Two that push each other to and fro for positions alone go on together.
    local moves = dv > 0 or (b.met[p] > LEAVES and wl > 0 and wh > 0)
    if moves then
      setSpeeds(b, kl, kh, wl, wh, dv, b.pushIsCommon)
      -- A hit from the side breaks the hold of friction.
      b.stuck[lo] = b.down[kl] ~= 0 and b.stuck[lo] or 0
      b.stuck[hi] = b.down[kh] ~= 0 and b.stuck[hi] or 0
      if still == lo then
        grip.hold(b, lo, axis, t == 0 and dt or tau)
        speed[kh], to[kh] = speed[kl], to[kl] + b.size[kl]
      elseif still == hi then
        grip.hold(b, hi, axis, t == 0 and dt or tau)
        speed[kl], to[kl] = speed[kh], to[kh] - b.size[kl]
      elseif b.hasLimits and flush and b.down[kl] == 0 and b.down[kh] == 0 then
        impulse = impulse - reserve.settle(b, kl, kh, wl, wh, tau)
      end
    end
    release(b, kl, kh, axis, flush, tau)
    if b.pushLeans then
      shareAccel(b.accel, kl, kh, wl, wh)
      shareAccel(b.drive, kl, kh, wl, wh)
      lean(b, lo, hi, kl, kh, b.pushLowWeight, b.pushHighWeight)
    end
    -- (Who stands may have been put back to where what it stands on takes it.)
    local wayL, wayH = to[kl] - b.pushLowTo, to[kh] - b.pushHighTo
    if wl ~= 0 or wayL ~= 0 then
      change(b, lo)
    end
    if wh ~= 0 or wayH ~= 0 then
      change(b, hi)
    end
    ring.follow(b, kl, wayL, t)
    ring.follow(b, kh, wayH, t)
    if b.pushIsLoaded then
      if wl ~= 0 then
        cargo.follow(b, kl, false, axis, b.pushLowSpeed, wayL, dt)
      end
      if wh ~= 0 then
        cargo.follow(b, kh, true, axis, b.pushHighSpeed, wayH, dt)
      end
    end
    if flush and moves and b.met[p] >= WELDS and wl > 0 and wh > 0 then
      weld.join(b, kl, kh)
    end
  end
  if not b.pushIsFlush and b.pushIsRubbed then
    -- (As long as it could: `tau` may be next to nothing, by rounding.)
    friction.brake(b, lo, axis, (1 - t) * dt, t)
    friction.brake(b, hi, axis, (1 - t) * dt, t)
  end
  if t > 0 and not b.pushIsDeep and b.pushIsRubbed then
    friction.hit(b, lo, axis, (1 - t) * dt, t)
    friction.hit(b, hi, axis, (1 - t) * dt, t)
  end
  if dv > 0 then
    local share = b.pushSpeed / dv
    return friction.rub(b, lo, hi, axis, impulse, share < 1 and share or 1, tau, t)
  end
end

-- Lets two push each other who hit at u px/s, close at v px/s at the end of the step, `tau` s
-- later, and would overlap by o px then.
local function push(b, p, lo, hi, kl, kh, axis, wl, wh, o, v, u, tau, t, dt, isDeep)
  local gap, vEnd = 0, 0
  do
    -- From here on only what goes on pulling counts: drag ends with the speed it slows.
    local a, met = b.drive[kl] - b.drive[kh], b.met[p]
    local mayBounce = min(max(BOUNCES + 1 - met, 0), 1) ---@type number
    local bounces = min(max((u - (a + a) * dt) * VAST, 0), mayBounce)
    local restitution = max(b.restitution[lo], b.restitution[hi]) * bounces
    if restitution == 0 and b.reserves > 0 then
      a = a + reserve.idle(b, kl, kh)
    end
    -- Who is pushed from behind by one that cannot be pushed has nowhere to leave to by itself.
    local isPinned = restitution == 0 and (b.backedLow[kl] or b.backedHigh[kh])
    if met <= LEAVES and not isPinned then
      local brake = braking(b, lo, hi, kl, kh, wl, wh, restitution, u, t, tau)
      gap, vEnd = impact.rebound(restitution, u, a + brake, tau)
    end
    b.pushSpeed = u * (1 + restitution)
    b.pushLowTo, b.pushHighTo = b.to[kl], b.to[kh]
    b.pushLowSpeed, b.pushHighSpeed = b.speed[kl], b.speed[kh]
    b.pushLowWeight, b.pushHighWeight, b.pushLends = wl, wh, false
  end
  local flush, dv = gap == 0 and vEnd == 0, v - vEnd
  if flush and not isDeep and lends(b, p, kl, kh, wl, wh, dv) then
    local gain, further = reserve.lend(b, kl, kh, wl, wh, tau)
    dv, o = dv + gain, o + further
    b.pushLends = gain > 0
  end
  local impulse, still, isLoaded = dv / (wl + wh), 0, false
  local rubbed = isRubbed(b, p, kl, kh, dv)
  if rubbed and flush and not isDeep then
    if t == 0 then
      wl, wh, dv, o, impulse, still, isLoaded =
        withFriction(b, lo, hi, kl, kh, axis, wl, wh, dv, o, dt)
    elseif stands(b, lo) and stands(b, hi) and grip.mayBear(b, lo, hi, kl, wl, wh, dv) then
      wl, wh, impulse, still = grip.bear(b, lo, hi, kl, kh, wl, wh, dv, t, (1 - t) * dt)
    end
  end
  local shareL, shareH = shares(b, lo, hi, kl, kh, wl, wh, isDeep or b.met[p] > BOUNCES)
  place(b, lo, kl, kh, o + gap, shareL, shareH, flush)
  -- Who is on the way apart already, and only flush through a push, leans on nobody; but who is
  -- pushed back again and again is held between two.
  b.pushLeans = flush and (v > -STILL or isDeep or b.met[p] > LEAVES)
  b.pushIsFlush, b.pushIsCommon, b.pushIsRubbed = flush, vEnd == 0, rubbed
  b.pushIsDeep, b.pushIsLoaded = isDeep, isLoaded
  return goOn(b, p, lo, hi, kl, kh, axis, wl, wh, dv, impulse, still, tau, t, dt)
end

--- Resolves pair p, which meets on `axis` at time t (0..1 of a step of dt s), `lo` being the one
--- with the smaller coordinate; `isDeep` if they are inside each other. Lists whose path changed in
--- b.changed[1..b.changedCount].
function resolve.run(b, p, lo, hi, axis, t, dt, isDeep)
  local kl, kh = 2 * lo + axis, 2 * hi + axis
  -- Where both paths began. They are straight lines, and t is a moment on those: who is braked has
  -- met earlier.
  local start = min(max(b.time[lo], b.time[hi]), t)
  if b.heldLow[kl] + b.heldHigh[kh] > 0 then
    leave(b, lo, kl, axis, b.heldLow, b.holderLow, -1, t)
    leave(b, hi, kh, axis, b.heldHigh, b.holderHigh, 1, t)
  end
  advance(b, lo, t)
  advance(b, hi, t)
  if b.weld[kl] ~= 0 and b.weld[kl] == b.weld[kh] then
    countHit(b, p, lo, hi, axis)
    if not (b.crushed[kl] and b.crushed[kh]) then -- those share the overlap of their row
      rejoin(b, lo, hi, kl, kh)
    end
    return
  end
  local wl, wh, headOn = weights(b, lo, hi, kl, kh)
  local o, v = b.to[kl] + b.size[kl] - b.to[kh], b.speed[kl] - b.speed[kh]
  local a = b.accel[kl] - b.accel[kh]
  local touches = 1 - min((t - start) * VAST, 1)
  local u, tau = impact.at(o, v, a, (1 - start) * dt, touches)
  noteHit(b, p, lo, hi, axis, u)
  if headOn then
    return stopBoth(b, lo, hi, kl, kh, t)
  elseif wl == 0 and wh == 0 then
    wl, wh = free(b, lo, hi, kl, kh, axis)
    if wl == 0 and wh == 0 then
      return crush.note(b, lo, hi, axis)
    end
  end
  if b.met[p] > LEAVES and holdEachOther(b, lo, hi, axis, wl, wh) then
    return
  end
  return push(b, p, lo, hi, kl, kh, axis, wl, wh, o, v, u, tau, t, dt, isDeep)
end

--- Notes that a sensor was met, and at which speed; that changes nobody's path.
function resolve.sense(b, p, lo, hi, axis, t, dt)
  local kl, kh = 2 * lo + axis, 2 * hi + axis
  local o = b.to[kl] + b.size[kl] - b.to[kh]
  local v, a = b.speed[kl] - b.speed[kh], b.accel[kl] - b.accel[kh]
  noteHit(b, p, lo, hi, axis, (impact.at(o, v, a, (1 - t) * dt, 0)))
end

return resolve
