--- Step 6, meet: what stands on something when the step begins.
--
-- The footings of a step (see `turns`) are settled in one pass, without the queue. What is not
-- simple, or makes others move, goes to `meet`. The queue alone would give the same bits.
--
-- These loops are compiled; what they have in common with the interpreted files (`path.change`,
-- `impact.at`, ...) is written out here, because the trace compiler gives up functions that
-- interpreted ones call, and with them the loop.
--
-- Writes what `resolve` would write.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local friction = require(here .. ".friction")
local gather = require(here .. ".gather")
local impact = require(here .. ".impact")
local queue = require(here .. ".queue")

local footing = {}

local isIdle = gather.isIdle
local DYNAMIC = columns.DYNAMIC
local STILL, TINY = columns.STILL, columns.TINY
local EVEN, ROUNDING = impact.EVEN, impact.ROUNDING
local max, min, sqrt = math.max, math.min, math.sqrt

-- The side towards the floor and the one away from it, as columns: held, holder, pressed.
local function sidesOf(b, isUp)
  if isUp then
    return b.heldLow, b.heldHigh, b.holderLow, b.pressedLow, b.pressedHigh
  end
  return b.heldHigh, b.heldLow, b.holderHigh, b.pressedHigh, b.pressedLow
end

-- What leans on `low` from now on.
local function lean(b, low, ku, kl, isUp)
  local held, _, holder, pressed, pressedUp = sidesOf(b, isUp)
  b.accel[ku], b.drive[ku] = b.accel[kl], b.drive[kl]
  pressed[ku], held[ku], holder[ku] = true, true, low
  pressedUp[kl] = true -- means nothing for one that is not dynamic
end

-- Whether one that cannot give way has something on it that can, and nothing is welded.
local function isSimple(b, up, low, ku, kl, isUp)
  local held, upHeld = sidesOf(b, isUp)
  return (held[kl] or b.kind[low] ~= DYNAMIC)
    and b.weld[ku] == 0
    and b.weld[kl] == 0
    and not (held[ku] or upHeld[ku] or upHeld[kl])
    and b.time[up] == 0
    and b.time[low] == 0
end

-- Friction between two that do not move against each other, nor would: `up` sticks to `low` where
-- that stands fast. Returns false for all others, whom `friction` must look at.
local function stick(b, up, low, ku, kl, mu, impulse, sign)
  local across = 1 - 2 * b.downAxis -- from an index along gravity to the one across
  local ka, kb = ku + across, kl + across
  local isFast = b.inverseMass[low] == 0
  if
    max(b.speed[ka] - b.speed[kb], b.speed[kb] - b.speed[ka]) > 0
    or b.accel[ka] ~= b.accel[kb]
    or b.surfaceSpeed[low] ~= 0
    or b.down[ku] ~= sign
  then
    return false
  elseif not (isFast or b.stuck[low]) then
    b.changes[low] = b.changes[low] + 1
    return true -- both slide, together
  end
  local bearing = mu * impulse
  if not isFast then
    b.grip[low] = b.grip[low] + b.stickiness[low] * impulse
    bearing = min(bearing, b.grip[low])
  end
  b.stuck[up], b.stickiness[up], b.grip[up] = true, mu, bearing
  b.to[ka] = b.from[ka] + (b.to[kb] - b.from[kb])
  return true
end

--- Coefficient of friction of a pair, as in `friction`. Who is not dynamic may have none (< 0).
function footing.coefficient(b, i, j)
  local one, other = b.friction[i], b.friction[j]
  if other < 0 or other == one then
    return one
  elseif one < 0 then
    return other
  end
  return sqrt(one * other)
end

-- Changes speed and way of k by what friction took off, unless it is held there. (Few are held at
-- all: asked first, so that the sign of what is taken makes no two ways through the code.)
local function shift(b, i, k, dSpeed, dWay)
  local heldLow, heldHigh = b.heldLow[k], b.heldHigh[k]
  if (heldLow or heldHigh) and ((dSpeed > 0 and heldHigh) or (dSpeed < 0 and heldLow)) then
    return
  end
  b.speed[k], b.to[k] = b.speed[k] + dSpeed, b.to[k] + dWay
  b.changes[i] = b.changes[i] + 1
end

--- Whether two that meet at u px/s bounce, as in `resolve`; a px/s² pull them at each other.
function footing.bounces(b, i, j, u, a, dt)
  return u > 2 * a * dt and max(b.restitution[i], b.restitution[j]) > 0
end

-- What is left of u when its amount is less by `loss`, which does not turn it round. No branches.
local function lessen(u, loss)
  return max(u - loss, 0.0) + min(u + loss, 0.0)
end

-- Friction between two that both slide, and are pulled alike: the simple half of `friction`.
-- Returns false for all others.
local function slideTogether(b, up, low, ku, kl, limit, share, sign, dt)
  local across = 1 - 2 * b.downAxis
  local ka, kb = ku + across, kl + across
  if
    b.inverseMass[low] == 0
    or b.stuck[low]
    or b.surfaceSpeed[low] ~= 0
    or b.down[ku] ~= sign
    or b.accel[ka] ~= b.accel[kb]
    or b.weld[ka] ~= 0
    or b.weld[kb] ~= 0
  then
    return false
  end
  local wu, wl = b.inverseMass[up], b.inverseMass[low]
  local w, u = wu + wl, b.speed[ka] - b.speed[kb]
  local stop, way = 0.0, 0.0
  if max(u, -u) >= STILL then
    local v, brake = lessen(u, limit * w * share), limit * w * (1 - share) / dt
    stop = lessen(v, brake * dt)
    way = (v + stop) * 0.5 * min(dt, max(v, -v) / max(brake, TINY))
  end
  local dSpeed, dWay = stop - u, way - (u + u) * 0.5 * dt
  local shareU, shareL = wu / w, wl / w
  shift(b, up, ka, dSpeed * shareU, dWay * shareU)
  shift(b, low, kb, -dSpeed * shareL, -dWay * shareL)
  return true
end

-- Puts `up` on `low`, who meet on `side` of the pair's first, as `resolve` would: flush, without a
-- bounce, held from below. Notes by how much that presses, for friction, at place x. Returns false
-- if the case is another one; nothing has changed then.
local function land(b, x, p, side, up, low, ku, kl, isUp, dt)
  local to, size, speed, accel, drive = b.to, b.size, b.speed, b.accel, b.drive
  local sign = isUp and -1 or 1
  local v = (speed[ku] - speed[kl]) * sign
  local goal = isUp and to[kl] + size[kl] or to[kl] - size[ku]
  local o = isUp and goal - to[ku] or to[ku] + size[ku] - to[kl]
  if not isSimple(b, up, low, ku, kl, isUp) or (drive[ku] - drive[kl]) * sign < -EVEN then
    return false
  end
  -- They touch already: the simple half of `impact.at`.
  local start = v - (accel[ku] - accel[kl]) * sign * dt
  if start <= -STILL or o < (v + start) * 0.5 * dt * (1 - ROUNDING) then
    return false
  end
  local u = start > STILL and start or 0
  if footing.bounces(b, up, low, u, (drive[ku] - drive[kl]) * sign, dt) then
    return false
  end
  b.hit[p], b.hitSpeed[p], b.met[p] = side, u, 1
  to[ku], b.changes[up] = goal, b.changes[up] + 1
  if v > 0 then
    speed[ku] = speed[kl]
    b.turnImpulse[x], b.turnShare[x] = v / b.inverseMass[up], min(u / v, 1.0)
  end
  if v > -STILL then
    lean(b, low, ku, kl, isUp)
  end
  return true
end

--- Whether there is an event in the queue that may come before a turn whose key is `key` there: 0
--- for footings, 1 for flanks, 3 for flanks that have met once (see `keyOf` in meet).
function footing.isAsked(q, key)
  return q.size > 0 and q.data[q.heap[1] + queue.KEY] <= key
end

--- Whether the first event of the queue comes before the next turn.
function footing.isLater(b)
  local at = b.turnsDone + 1
  local x, key = b.turnOrder[at], at <= b.footingCount and 0 or 1 + 2 * b.round
  return queue.leads(b.queue, key, b.turnSupport[x], b.turnFirst[x], b.turnSecond[x])
end

--- What `land` may return, but for a pair.
footing.DONE, footing.CHANGED, footing.ASK, footing.PERMIT = 0, -1, -2, -3

--- Whether the game must be asked before a pair may bump (see `ask`).
function footing.mustAsk(b, p, i, j)
  return (b.worldCanCollide or b.canCollide[i] or b.canCollide[j]) and b.permitted[p] ~= b.step
end

--- Lands one footing after the other in a step of dt s, until something else goes before the next;
--- `isNext` if the queue was asked already and does not. Returns what that is: a pair that must be
--- looked at in the general way; CHANGED: the last one's neighbours; ASK: `isLater` must be asked;
--- PERMIT: the game must be, about the next one; DONE: nothing, no footing is left. Those that have
--- landed must `slide` first.
function footing.land(b, dt, isNext)
  local q, order, list, ups, lows = b.queue, b.turnOrder, b.turnPair, b.turnUp, b.turnLow
  local axis, turn, impulses = b.downAxis, b.turn, b.turnImpulse
  local isUp, sides, watched = b.orientation[axis] < 0, b.turnSide, b.watched
  local step, passing, permitted, hasAskers = b.step, b.passing, b.permitted, b.hasAskers
  for at = b.turnsDone + 1, b.footingCount do
    local x = order[at]
    local p, up, low = list[x], ups[x], lows[x]
    if footing.isAsked(q, 0) and not isNext then
      return footing.ASK
    end
    isNext = false
    b.turnsDone, impulses[x] = at, 0
    local lo, hi = 2 * up + axis, 2 * low + axis
    if isUp then
      lo, hi = 2 * low + axis, 2 * up + axis
    end
    if turn[p] == at and isIdle(b, lo, hi) then
      -- If it comes to press, that goes before later footings.
      watched[up], watched[low] = step, step
    elseif turn[p] == at and not passing[p] then
      if hasAskers and footing.mustAsk(b, p, up, low) then
        b.turnsDone = at - 1
        return footing.PERMIT
      end
      if not land(b, x, p, sides[x], up, low, 2 * up + axis, 2 * low + axis, isUp, dt) then
        return p
      end
      permitted[p], b.resolved = 0, b.resolved + 1
      if watched[up] == step then
        return footing.CHANGED
      end
    end
  end
  return footing.DONE
end

--- Lets those rub that have landed, in the same order. That changes paths across gravity only, on
--- which no footing depends, nor anything else that goes before the flanks; so it may follow the
--- landings (one loop for both would be too long for the trace compiler). Returns false at one that
--- needs more than this loop does, and must `rub`.
function footing.slide(b, dt)
  local order, ups, lows, impulses = b.turnOrder, b.turnUp, b.turnLow, b.turnImpulse
  local axis, shares = b.downAxis, b.turnShare
  local sign = b.orientation[axis] < 0 and -1 or 1
  for at = b.turnsSlid + 1, b.turnsDone do
    local x = order[at]
    local up, low, impulse = ups[x], lows[x], impulses[x]
    local mu = impulse > 0 and footing.coefficient(b, up, low) or 0
    if mu > 0 and not stick(b, up, low, 2 * up + axis, 2 * low + axis, mu, impulse, sign) then
      b.turnsSlid = at
      local ku, kl, limit = 2 * up + axis, 2 * low + axis, mu * impulse
      if not slideTogether(b, up, low, ku, kl, limit, shares[x], sign, dt) then
        return false
      end
    end
  end
  b.turnsSlid = b.turnsDone
  return true
end

--- Lets the two of a turn rub, along or across gravity, in the general way.
function footing.rub(b, at, dt)
  local x, isFooting = b.turnOrder[at], at <= b.footingCount
  local axis, tau = b.downAxis, dt
  if not isFooting then
    axis, tau = 1 - axis, b.turnLeft[x]
  end
  local up, low = b.turnUp[x], b.turnLow[x]
  local isDown = b.orientation[axis] > 0
  local lo, hi = isDown and up or low, isDown and low or up
  friction.rub(b, lo, hi, axis, b.turnImpulse[x], b.turnShare[x], tau, 0)
  b.turnImpulse[x] = 0 -- nothing is left for `slide`
end

return footing
