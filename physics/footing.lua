--- Step 6, meet: what stands on something when the step begins.
--
-- The footings of a step (see `turns`) are settled in one pass a round, without the queue. What is
-- not simple goes to `meet`. The queue alone would give the same bits.
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
local press = require(here .. ".press")
local queue = require(here .. ".queue")
local resolve = require(here .. ".resolve")
local rounds = require(here .. ".rounds")

local footing = {}

local direction, isIdle, isSettled = rounds.direction, gather.isIdle, gather.isSettled
local PATIENCE, WELDS, UNSEEN = resolve.PATIENCE, resolve.WELDS, columns.UNSEEN
local REFUSED, LOW, HIGH, RUBS = press.REFUSED, press.LOW, press.HIGH, press.RUBS
local DYNAMIC = columns.DYNAMIC
local STILL, TINY = columns.STILL, columns.TINY
local EVEN, ROUNDING = impact.EVEN, impact.ROUNDING
local huge, max, min = math.huge, math.max, math.min

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

-- Whether one that cannot give way has something on it that can, nothing is welded, and they have
-- not met again and again.
local function isSimple(b, p, up, low, ku, kl, isUp)
  local held, upHeld = sidesOf(b, isUp)
  return (held[kl] or b.kind[low] ~= DYNAMIC)
    and b.met[p] < WELDS
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
    or b.weld[ka] ~= 0
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
-- bounce, held from below. If that presses, notes for friction by how much, at place x, and that
-- it was the n-th turn. Returns false if the case is another one; nothing has changed then.
local function putOn(b, n, x, p, side, up, low, ku, kl, isUp, dt)
  local to, size, speed, accel, drive = b.to, b.size, b.speed, b.accel, b.drive
  local sign = isUp and -1 or 1
  local v = (speed[ku] - speed[kl]) * sign
  local goal = isUp and to[kl] + size[kl] or to[kl] - size[ku]
  local o = isUp and goal - to[ku] or to[ku] + size[ku] - to[kl]
  if not isSimple(b, p, up, low, ku, kl, isUp) or (drive[ku] - drive[kl]) * sign < -EVEN then
    return false
  end
  -- They touch already: the simple half of `impact.at`.
  local start = v - (accel[ku] - accel[kl]) * sign * dt
  if start <= -STILL or o < (v + start) * 0.5 * dt * (1 - ROUNDING) then
    return false
  end
  local u = start > STILL and start or 0
  if press.bounces(b, up, low, u, (drive[ku] - drive[kl]) * sign, dt) then
    return false
  end
  press.noteHit(b, p, side, u)
  to[ku], b.changes[up] = goal, b.changes[up] + 1
  if v > 0 then
    speed[ku] = speed[kl]
    b.turnImpulse[x], b.turnShare[x], b.turnLeft[x] = v / b.inverseMass[up], min(u / v, 1.0), dt
    b.landedCount = b.landedCount + 1
    b.landed[b.landedCount] = n
  end
  if v > -STILL then
    lean(b, low, ku, kl, isUp)
  end
  return true
end

--- Returns the place in the columns of turns of the n-th turn of this round, and 1 if it is across
--- gravity, 0 if along.
function footing.turnAt(b, n)
  local first, last, across = 1, b.footingCount, 0
  if n > last then
    first, last, across = last + 1, b.turnCount, 1
  end
  local base, way = direction(b.turnRound, first, last)
  return b.turnOrder[base + way * n], across
end

--- Whether there is an event in the queue that may come before a turn whose key is `key` there (see
--- `keyOf` in meet).
function footing.isAsked(q, key)
  return q.size > 0 and q.data[q.heap[1] + queue.KEY] <= key
end

--- Whether the first event of the queue comes before the next turn.
function footing.isLater(b)
  local x, across = footing.turnAt(b, b.turnsDone + 1)
  local round = b.turnRound
  local support, first, second = b.turnSupport[x], b.turnFirst[x], b.turnSecond[x]
  return queue.leads(b.queue, 2 * round + across, rounds.turned(round, support, first, second))
end

--- What `land` may return, but for a pair.
footing.DONE, footing.CHANGED, footing.ASK, footing.PERMIT, footing.FINISH = 0, -1, -2, -3, -4
local DONE, CHANGED, ASK, PERMIT, FINISH =
  footing.DONE, footing.CHANGED, footing.ASK, footing.PERMIT, footing.FINISH

--- Whether the game must be asked before a pair may bump (see `ask`).
function footing.mustAsk(b, p, i, j)
  return (b.worldCanCollide or b.canCollide[i] or b.canCollide[j]) and b.permitted[p] ~= b.step
end

--- Whether two who press do not meet: they pass through each other, or it would change nothing.
function footing.isOver(b, p)
  return b.passing[p] or b.met[p] >= PATIENCE or isSettled(b, p)
end

local isOver = footing.isOver

--- Returns up to which turn of this round, along gravity (`across` 0) or across it (1), the queue
--- need not be asked; `isNext` if it was asked about the next one already, and does not go first.
function footing.freeUpTo(b, across, isNext)
  if footing.isAsked(b.queue, 2 * b.turnRound + across) then
    return b.turnsDone + (isNext and 1 or 0)
  end
  return huge
end

--- Returns what is left to do after two have had their turn, the pair p: what `press` says of it.
function footing.after(b, p, i, j, gives)
  if gives == REFUSED then
    return p
  end
  b.permitted[p], b.resolved, b.turnGives = 0, b.resolved + 1, gives
  if gives >= RUBS then
    return FINISH
  end
  local isWatched = b.isEager or b.watched[i] == b.step or b.watched[j] == b.step
  return isWatched and CHANGED or DONE
end

--- Returns how many turns are over: not the n-th yet, if somebody must be asked about it.
function footing.over(left, n)
  return (left == ASK or left == PERMIT) and n - 1 or n
end

--- Lands one footing after the other in a step of dt s, until something else goes before the next;
--- `isNext` if the queue was asked already and does not. Returns what that is: a pair that must be
--- resolved in the general way; CHANGED: somebody must be looked at whom the last one has changed;
--- FINISH: the same, and what is to come of it must be done first (see `press`); ASK: `isLater`
--- must be asked; PERMIT: the game must be, about the next one; DONE: nothing, no footing is left.
--- Those that have landed must `slide` first. Whose paths are the same as in the round before is
--- passed over. Who has given way is told in b.turnGives, see `press`.
---
--- (The loop is left by its condition only: a way out of its middle leads to what is interpreted,
--- and the compiler gives up the whole way there.)
function footing.land(b, dt, isNext)
  local order, list, ups, lows, sides = b.turnOrder, b.turnPair, b.turnUp, b.turnLow, b.turnSide
  local axis, isUp = b.downAxis, b.orientation[b.downAxis] < 0
  local changes, seen = b.changes, b.turnSeen
  local hasAskers, free = b.hasAskers, footing.freeUpTo(b, 0, isNext)
  local base, way = direction(b.turnRound, 1, b.footingCount)
  local n, last, left = b.turnsDone, b.footingCount, DONE
  while left == DONE and n < last do
    n = n + 1
    local x = order[base + way * n]
    local up, low = ups[x], lows[x]
    local look = changes[up] + changes[low]
    if n > free then
      left = ASK
    elseif seen[x] ~= look then
      local p, lo, hi = list[x], up, low
      if isUp then
        lo, hi = low, up
      end
      seen[x] = look
      if isIdle(b, 2 * lo + axis, 2 * hi + axis) or isOver(b, p) then
        left = DONE
      elseif hasAskers and footing.mustAsk(b, p, up, low) then
        left, seen[x] = PERMIT, UNSEEN
      else
        local gives, side = isUp and HIGH or LOW, sides[x]
        if not putOn(b, n, x, p, side, up, low, 2 * up + axis, 2 * low + axis, isUp, dt) then
          gives = press.run(b, x, p, side, lo, hi, axis, dt)
        end
        left = footing.after(b, p, up, low, gives)
      end
    end
  end
  b.turnsDone = footing.over(left, n)
  return left
end

--- Lets those rub that have landed, in the same order. That changes paths across gravity only, on
--- which no footing depends, nor anything else that goes before the flanks; so it may follow the
--- landings (one loop for both would be too long for the trace compiler). Returns false at one that
--- needs more than this loop does, and must `rub`: the last of b.landed[1..b.slidCount].
function footing.slide(b, dt)
  local order, ups, lows, landed = b.turnOrder, b.turnUp, b.turnLow, b.landed
  local axis, shares, impulses = b.downAxis, b.turnShare, b.turnImpulse
  local sign = b.orientation[axis] < 0 and -1 or 1
  local base, way = direction(b.turnRound, 1, b.footingCount)
  local at, isDone = b.slidCount, true
  while isDone and at < b.landedCount do
    at = at + 1
    local x = order[base + way * landed[at]]
    local up, low, impulse = ups[x], lows[x], impulses[x]
    local mu = press.coefficient(b, up, low)
    local ku, kl, limit = 2 * up + axis, 2 * low + axis, mu * impulse
    isDone = mu <= 0
      or stick(b, up, low, ku, kl, mu, impulse, sign)
      or slideTogether(b, up, low, ku, kl, limit, shares[x], sign, dt)
  end
  b.slidCount = at
  return isDone
end

--- Lists in `out` who has landed in this round, or been landed on, and touches somebody with whom
--- it has no turn, or may, since somebody was nudged; returns how many.
function footing.listLanded(b, out)
  local ups, lows, landed = b.turnUp, b.turnLow, b.landed
  local watched, step, isWary, count = b.watched, b.step, b.isEager, 0
  for at = 1, b.landedCount do
    local x = footing.turnAt(b, landed[at])
    if isWary or watched[ups[x]] == step or watched[lows[x]] == step then
      out[count + 1], out[count + 2] = ups[x], lows[x]
      count = count + 2
    end
  end
  return count
end

--- Lets the two of the n-th turn of this round rub, along or across gravity, in the general way.
function footing.rub(b, n)
  local x, across = footing.turnAt(b, n)
  local axis = across == 1 and 1 - b.downAxis or b.downAxis
  local up, low = b.turnUp[x], b.turnLow[x]
  local isDown = b.orientation[axis] > 0
  local lo, hi = isDown and up or low, isDown and low or up
  friction.rub(b, lo, hi, axis, b.turnImpulse[x], b.turnShare[x], b.turnLeft[x], 0)
end

return footing
