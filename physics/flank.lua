--- Step 6, meet: what leans on something across gravity when the step begins.
--
-- The flanks of a step have their turns behind the footings (see `turns`), in one loop, too. What
-- is not simple goes to `meet`, and the queue alone would give the same bits. As in `footing`, what
-- this has in common with the interpreted files is written out.
--
-- Writes what `resolve` would write.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local footing = require(here .. ".footing")
local gather = require(here .. ".gather")
local impact = require(here .. ".impact")
local resolve = require(here .. ".resolve")
local rounds = require(here .. ".rounds")

local flank = {}

local STILL = columns.STILL
local EVEN, ROUNDING = impact.EVEN, impact.ROUNDING
local max, min, sqrt = math.max, math.min, math.sqrt
local isIdle = gather.isIdle
local isOver, coefficient = footing.isOver, footing.coefficient
local WELDS, UNSEEN = resolve.WELDS, columns.UNSEEN

-- Whether nobody is held away from the other, welded or backed, and they have not met again and
-- again.
local function isSimple(b, p, lo, hi, kl, kh)
  return b.met[p] + 1 < WELDS
    and not (b.heldHigh[kl] or b.heldLow[kh])
    and not (b.backedLow[kl] or b.backedHigh[kl] or b.backedLow[kh] or b.backedHigh[kh])
    and b.weld[kl] == 0
    and b.weld[kh] == 0
    and b.time[lo] == 0
    and b.time[hi] == 0
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

local function lean(b, lo, hi, kl, kh, wl, wh)
  share(b.accel, kl, kh, wl, wh)
  share(b.drive, kl, kh, wl, wh)
  -- Both mean nothing for one that is not dynamic.
  b.pressedHigh[kl], b.pressedLow[kh] = true, true
  if wh == 0 then
    b.heldHigh[kl], b.holderHigh[kl] = true, hi
  elseif wl == 0 then
    b.heldLow[kh], b.holderLow[kh] = true, lo
  end
end

-- Puts both flush, with a common speed.
local function place(b, lo, kl, kh, wl, wh, o, v)
  local to, size, speed = b.to, b.size, b.speed
  local shareL, shareH = wl / (wl + wh), wh / (wl + wh)
  local dl, dh = o * shareL, o * shareH
  if dh == 0 then
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

-- Whether two rub as they are: they go alike along their common edge, and neither is a wall.
local function isAlike(b, lo, hi, tl, th)
  return b.speed[tl] == b.speed[th]
    and b.accel[tl] == b.accel[th]
    and b.inverseMass[lo] > 0
    and b.inverseMass[hi] > 0
end

-- Approach speed, and the time left after the contact (see `impact.at`). Friction of footings may
-- have shortened a way more than the speed and the acceleration tell.
local function impactAt(o, v, a, dt)
  local start = v - a * dt
  if start > -STILL and o >= (v + start) * 0.5 * dt * (1 - ROUNDING) then
    return start > STILL and start or 0, dt
  end
  local square = v * v - 2 * a * o
  local u = (v > 0 or a < 0) and sqrt(max(square, 0)) or 0
  return u, v + u > 0 and min(2 * o / (v + u), dt) or dt
end

local REFUSED, LEANS, RUBS = 0, 1, 2

-- Lets two lean on each other, who meet on `side` of the pair's first, as `resolve` would. Returns
-- REFUSED if the case is another one (nothing has changed then), or whether friction is to come.
local function press(b, x, p, side, lo, hi, axis, dt)
  local kl, kh = 2 * lo + axis, 2 * hi + axis
  local wl, wh = b.inverseMass[lo], b.inverseMass[hi]
  if b.heldLow[kl] then
    wl = 0
  end
  if b.heldHigh[kh] then
    wh = 0
  end
  if wl + wh == 0 or not isSimple(b, p, lo, hi, kl, kh) or b.drive[kl] - b.drive[kh] < -EVEN then
    return REFUSED
  elseif b.pushFirst and wl > 0 and wh > 0 then
    return REFUSED -- one of them takes it all
  end
  local v, o = b.speed[kl] - b.speed[kh], b.to[kl] + b.size[kl] - b.to[kh]
  local u, tau = impactAt(o, v, b.accel[kl] - b.accel[kh], dt)
  if footing.bounces(b, lo, hi, u, b.drive[kl] - b.drive[kh], dt) then
    return REFUSED
  end
  footing.noteHit(b, p, side, u)
  place(b, lo, kl, kh, wl, wh, o, v)
  b.changes[lo] = b.changes[lo] + (wl > 0 and 1 or 0)
  b.changes[hi] = b.changes[hi] + (wh > 0 and 1 or 0)
  if v > -STILL then
    lean(b, lo, hi, kl, kh, wl, wh)
  end
  if v <= 0 then
    return LEANS
  end
  b.stuck[lo] = b.stuck[lo] and b.down[kl] ~= 0
  b.stuck[hi] = b.stuck[hi] and b.down[kh] ~= 0
  local sideways = 1 - 2 * axis
  if coefficient(b, lo, hi) <= 0 then
    return LEANS
  elseif
    b.down[kl] == 0
    and b.down[kh] == 0
    and isAlike(b, lo, hi, kl + sideways, kh + sideways)
  then
    b.changes[lo], b.changes[hi] = b.changes[lo] + 1, b.changes[hi] + 1
    return LEANS
  end
  b.turnImpulse[x], b.turnShare[x], b.turnLeft[x] = v / (wl + wh), min(u / v, 1.0), tau
  return RUBS
end

--- What `land` may return besides what that of footings does.
flank.RUB = -4

--- Lets one flank after the other lean in a step of dt s; see `footing.land`. RUB: the last one
--- must `footing.rub`, which changes paths along gravity.
function flank.land(b, dt, isNext)
  local order, list, ups, lows, sides = b.turnOrder, b.turnPair, b.turnUp, b.turnLow, b.turnSide
  local axis, key, isWary = 1 - b.downAxis, 2 * b.turnRound + 1, b.isEager
  local isUp, step, watched = b.orientation[axis] < 0, b.step, b.watched
  local changes, seen, isAsked = b.changes, b.turnSeen, footing.isAsked(b.queue, key)
  local base, way = rounds.direction(b.turnRound, b.footingCount + 1, b.turnCount)
  for n = b.turnsDone + 1, b.turnCount do
    if isAsked and not isNext then
      b.turnsDone = n - 1
      return footing.ASK
    end
    isNext = false
    local x = order[base + way * n]
    local lo, hi = ups[x], lows[x]
    local look = changes[lo] + changes[hi]
    if seen[x] ~= look then
      if isUp then
        lo, hi = lows[x], ups[x]
      end
      local p = list[x]
      seen[x] = look
      if not (isIdle(b, 2 * lo + axis, 2 * hi + axis) or isOver(b, p)) then
        if b.hasAskers and footing.mustAsk(b, p, lo, hi) then
          b.turnsDone, seen[x] = n - 1, UNSEEN
          return footing.PERMIT
        end
        b.turnsDone = n
        local done = press(b, x, p, sides[x], lo, hi, axis, dt)
        if done == REFUSED then
          return p
        end
        b.permitted[p], b.resolved = 0, b.resolved + 1
        if done == RUBS then
          return flank.RUB
        elseif isWary or watched[lo] == step or watched[hi] == step then
          return footing.CHANGED
        end
      end
    end
  end
  b.turnsDone = b.turnCount
  return footing.DONE
end

return flank
