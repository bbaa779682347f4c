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
local tower = require(here .. ".tower")

require(here .. ".interpreted").file()

local cargo = {}

local huge, max, min = math.huge, math.max, math.min

local ALL = grip.ALL
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

-- Lists all that goes along with k, and with those that are welded to it, behind place `last`, but
-- for slot `except`, which is pushed itself. Returns the last place then, and the mass of all.
local function listRing(b, k, axis, except, last)
  local member, all = k, 0 ---@type number, number
  repeat
    local top, mass = tower.list(b, (member - axis) / 2, axis, 0, except, last)
    last, all, member = top, all + mass, b.weldNext[member]
  until member == k or member == 0
  return last, all
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

-- Returns the speed at which the one at place n of the list goes on, given an impulse, with all
-- that stands on it: where that takes what is left.
local function draggedSpeed(b, n, axis, impulse)
  local up = b.tower[n]
  local first, own, before = b.towerBegin[up], b.mass[up], b.speed[2 * up + axis]
  local v, least, most = before, -huge, huge
  for _ = 1, ROUNDS do
    local taken, mass = tower.need(b, first, n - 1, axis, v, up, own * (v - before), own)
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
-- and all that stands on them, of masses `onL`, `onH`: where the impulses of all add up to nothing.
-- Then what `tower.need` has told at this speed (but for rounding) of what is on either.
local function commonSpeed(b, kl, kh, axis, wl, wh, onL, onH)
  local speedL, speedH = b.speed[kl], b.speed[kh]
  local v, isFixed, least, most = wl == 0 and speedL or speedH, wl == 0 or wh == 0, -huge, huge
  if not isFixed then
    local allL, allH = 1 / wl + onL, 1 / wh + onH -- mostly all of it goes along
    v = (speedL * allL + speedH * allH) / (allL + allH)
  end
  local impulseL, massL, impulseH, massH ---@type number, number, number, number
  for _ = 1, isFixed and 1 or ROUNDS do
    impulseL, massL = tower.need(b, 1, b.loadSplit, axis, v, 0, 0, 0)
    impulseH, massH = tower.need(b, b.loadSplit + 1, b.loadCount, axis, v, 0, 0, 0)
    local excess = (v - speedL) / wl + (v - speedH) / wh + impulseL + impulseH
    local new = v - excess / (1 / wl + 1 / wh + massL + massH)
    if isFixed or max(new - v, v - new) <= STILL then
      break
    end
    v, least, most = tryNext(v, new, excess, least, most)
  end
  return v, impulseL, massL, impulseH, massH
end

--- Loads two that close at v px/s across gravity, and overlap by `o` px at the end of a step of
--- dt s, with what goes along with them; some may only be dragged, by a force that acts during the
--- whole step. Returns their inverse masses, v and o as they are then, and whether anything goes
--- along.
function cargo.load(b, kl, kh, axis, wl, wh, v, o, dt)
  local split, onL = listRing(b, kl, axis, (kh - axis) / 2, 0)
  local count, onH = listRing(b, kh, axis, (kl - axis) / 2, split)
  if count == 0 then
    return wl, wh, v, o, false
  end
  b.loadSplit, b.loadCount = split, count
  local common, impulseL, massL, impulseH, massH = commonSpeed(b, kl, kh, axis, wl, wh, onL, onH)
  -- Who does not give way (0) is heavy enough as it is.
  local allL = wl > 0 and 1 / (1 / wl + massL) or 0
  local allH = wh > 0 and 1 / (1 / wh + massH) or 0
  -- By how much the others make the two slower, px/s.
  local lossL = (impulseL - massL * (common - b.speed[kl])) * allL
  local lossH = (impulseH - massH * (common - b.speed[kh])) * allH
  local closing = v - lossL + lossH
  if closing <= 0 then
    return wl, wh, v, o, false -- they are apart then, but for what they overlap already
  end
  local share = b.pushFirst and 0 or dt * 0.5
  b.speed[kl], b.speed[kh] = b.speed[kl] - lossL, b.speed[kh] - lossH
  b.to[kl], b.to[kh] = b.to[kl] - lossL * share, b.to[kh] - lossH * share
  b.loadSpeed = common
  return allL, allH, closing, o + (lossH - lossL) * share, true
end

-- Drags along the one at place n of the list, which friction cannot bring to the speed of what it
-- stands on, in a step of dt s. What it can give has been noted (see `tower.need`).
local function drag(b, n, axis, dt)
  local up = b.tower[n]
  local k, impulse = 2 * up + axis, b.dragImpulse[up]
  local before, v = b.speed[k], draggedSpeed(b, n, axis, impulse)
  local way = (v - before) * dt * 0.5
  tower.need(b, b.towerBegin[up], n - 1, axis, v, up, 0, 0) -- for what stands on it
  b.speed[k], b.to[k] = v, b.to[k] + way
  b.gripUsed[up] = b.gripUsed[up] + impulse
  b.groundSpeed[up], b.taken[up] = b.speed[2 * b.goesWith[up] + axis], b.step
  b.dragFrom[up], b.dragWay[up] = before, way
  return path.change(b, up)
end

-- Takes along those in the list, who stand on what moved at v px/s before, and goes `way` px
-- further in a step of dt s now; `root` stands for that.
local function takeAll(b, root, first, last, axis, v, way, dt)
  b.dragFrom[root], b.dragWay[root] = v, way
  local n = tower.take(b, first, last, axis, dt)
  while n >= first do
    drag(b, n, axis, dt)
    n = tower.take(b, first, n - 1, axis, dt)
  end
end

--- Takes along all that stands on one of the two that were loaded last, or on those that are welded
--- to it, as far as friction can: on k, the one with the larger coordinate (`isHigh`) or the other,
--- which moved at v px/s before, and goes `way` px further in a step of dt s now.
function cargo.follow(b, k, isHigh, axis, v, way, dt)
  local first, last = 1, b.loadSplit
  if isHigh then
    first, last = last + 1, b.loadCount
  end
  local u = b.speed[k] - b.loadSpeed
  if max(u, -u) > STILL then -- friction has borne a part of the push since
    tower.need(b, first, last, axis, b.speed[k], 0, 0, 0)
  end
  return takeAll(b, 0, first, last, axis, v, way, dt)
end

-- Lets slot i alone go on at `new` px/s, `way` px further, with an acceleration: what stands on it
-- slides, unless it is taken along.
local function go(b, i, axis, new, way, accel)
  local k, up = 2 * i + axis, b.cargo[i]
  while up ~= 0 do
    b.groundSpeed[up] = new
    up = b.nextCargo[up]
  end
  b.speed[k], b.to[k], b.accel[k] = new, b.to[k] + way, accel
  path.change(b, i)
end

--- Brakes slot i over `tau` s to v px/s, the speed of what it stands on, as far as an impulse of up
--- to `limit` can, of which a `share` acts at once; what stands on it goes along as far as friction
--- can. Returns the impulse that it takes, and whether it has that speed now; its acceleration is
--- `accel` px/s² then.
function cargo.brake(b, i, axis, limit, v, accel, share, tau)
  local k, own, last = 2 * i + axis, b.mass[i], (tower.list(b, i, axis, i, 0, 0))
  local before = b.speed[k]
  b.tower[last + 1], b.towerOn[last + 1], b.towerBegin[i] = i, 0, 1
  local needed, new = tower.need(b, 1, last, axis, v, i, own * (v - before), own), v
  local impulse = max(min(needed, limit), -limit)
  local stops = impulse == needed
  if not stops then
    new = draggedSpeed(b, last + 1, axis, impulse)
  end
  local gain = new - before
  local way = gain * tau * (0.5 + 0.5 * share)
  go(b, i, axis, new, way, stops and accel or b.accel[k] + gain * (1 - share) / tau)
  takeAll(b, i, 1, last, axis, before, way, tau * (1 + share))
  return impulse, stops
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

--- Lists the tower that slides as a whole, slot i with it, behind place `last`. Returns the last
--- place then, the lowest one, and the mass of all; `last`, 0, 0: there is none.
function cargo.listTower(b, i, axis, last)
  local v = b.speed[2 * i + axis]
  local low = b.goesWith[i]
  while
    low ~= 0
    and b.ground[i] == low
    and b.speed[2 * low + axis] == v
    and (b.stuck[i] > 0 or b.stuck[low] == 0) -- else it has just been dragged off
  do
    if b.level[i] <= b.level[low] or not cargo.isFree(b, 2 * i + axis) then
      return last, 0, 0
    end
    i, low = low, b.goesWith[low]
  end
  local rubs = b.level[i] > 0 and (low == 0 or b.ground[i] == low)
  if b.stuck[i] > 0 or not rubs or not cargo.isFree(b, 2 * i + axis) then
    return last, 0, 0
  end
  local top, mass = tower.listParts(b, i, axis, v, last)
  return top, i, mass
end

return cargo
