--- Step 6, meet: what stands on something when the step begins.
--
-- In piles and levels nearly all contacts are there from the beginning: flush along gravity. They
-- are listed once a step, in the order in which `meet` would resolve them (from the floor up), and
-- settled in one pass over that list, without the queue. What is anything but plain, or makes
-- others move, goes to `meet`. The queue alone would give the same bits.
--
-- This loop is compiled; what it has in common with the interpreted files (`path.change`,
-- `impact.at`, ...) is written out here, because the trace compiler gives up functions that
-- interpreted ones call, and with them the loop.
--
-- Reads from, size, kind, plain, the live pairs; writes footings and turn, and what `resolve` would
-- write.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local detect = require(here .. ".detect")
local friction = require(here .. ".friction")
local gather = require(here .. ".gather")
local impact = require(here .. ".impact")
local queue = require(here .. ".queue")

local footing = {}

local DYNAMIC, EPSILON = columns.DYNAMIC, columns.EPSILON
local STILL, TINY = columns.STILL, columns.TINY
local EVEN, ROUNDING = impact.EVEN, impact.ROUNDING
local huge, sqrt = math.huge, math.sqrt
local floor, max, min = math.floor, math.max, math.min

-- Digits of the sort, and from how many footings on it is worth it.
local DIGITS, MANY = 1024, 24
-- In the place of its impulse: a footing by which the path of the lower one has changed, too.
local RUBBED = -1

-- Of the pairs that are flush along gravity, keeps those that are plain and lists the others behind
-- b.odd; returns how many are plain.
local function keepPlain(b, flushCount)
  local flush, odd, pairA, pairB, count = b.footingOrder, b.odd, b.pairA, b.pairB, 0
  local plain, dropping, oddCount = b.plain, b.dropping, 0
  for n = 1, flushCount do
    local p = flush[n]
    if plain[pairA[p]] and plain[pairB[p]] and not dropping[p] then
      count = count + 1
      flush[count] = p
    else
      oddCount = oddCount + 1
      odd[oddCount] = p
    end
  end
  b.oddCount = oddCount
  return count
end

-- Works out who stands on whom; returns how many stand on something. Where the upper one cannot
-- fall, the pair is odd, too.
local function findUpper(b, plainCount)
  local flush, list, ups, lows, count = b.footingOrder, b.footings, b.footingUp, b.footingLow, 0
  local pairA, pairB, from, kind, axis = b.pairA, b.pairB, b.from, b.kind, b.downAxis
  local isUp, sides, odd, oddCount = b.orientation[axis] < 0, b.footingSide, b.odd, b.oddCount
  for n = 1, plainCount do
    local p = flush[n]
    local up, low = pairA[p], pairB[p]
    local side = 2 * axis + (isUp and 1 or 2)
    if (from[2 * low + axis] < from[2 * up + axis]) ~= isUp then
      up, low = pairB[p], pairA[p]
      side = 4 * axis + 3 - side
    end
    if kind[up] == DYNAMIC then
      count = count + 1
      list[count], ups[count], lows[count], sides[count] = p, up, low, side
    else
      oddCount = oddCount + 1
      odd[oddCount] = p
    end
  end
  b.oddCount = oddCount
  return count
end

-- What decides their order: how far down the lower one is, and their ranks.
local function weigh(b, count)
  local ups, lows, support = b.footingUp, b.footingLow, b.footingSupport
  local firsts, seconds, rank, kind = b.footingFirst, b.footingSecond, b.rank, b.kind
  local from, size, axis = b.from, b.size, b.downAxis
  local isUp = b.orientation[axis] < 0
  for n = 1, count do
    local up, low = ups[n], lows[n]
    local first, second = rank[up], rank[low]
    if kind[low] == DYNAMIC then
      local m = 2 * low + axis
      support[n] = isUp and -from[m] or from[m] + size[m]
      firsts[n], seconds[n] = min(first, second), max(first, second)
    else
      support[n], firsts[n], seconds[n] = huge, first, second
    end
  end
end

-- Writes into `digit` how far down each is, as a whole number below DIGITS²: 0 for what stands on
-- something immovable, then from the lowest up.
local function quantize(b, count)
  local support, digit = b.footingSupport, b.footingDigit
  local lowest, highest = -huge, huge
  for n = 1, count do
    local s = support[n]
    if s ~= huge then
      lowest, highest = max(lowest, s), min(highest, s)
    end
  end
  local scale = lowest > highest and (DIGITS * DIGITS - 2) / (lowest - highest) or 0
  for n = 1, count do
    local s = support[n]
    digit[n] = s == huge and 0 or 1 + floor((lowest - s) * scale)
  end
end

-- The place of the first in the order of the world.
local function readSeats(b, count)
  local digit, seat, ups, lows, kind = b.footingDigit, b.seat, b.footingUp, b.footingLow, b.kind
  for n = 1, count do
    local first, second = seat[ups[n]], seat[lows[n]]
    digit[n] = kind[lows[n]] == DYNAMIC and min(first, second) or first
  end
end

-- One pass of a radix sort, stable: from `source` to `target` by the digit that is worth `unit`.
local function sortBy(b, source, target, count, unit)
  local digit, heads, inverse = b.footingDigit, b.footingHeads, 1 / unit
  for d = 1, DIGITS + 1 do
    heads[d] = 0
  end
  for n = 1, count do
    local d = floor(digit[source[n]] * inverse)
    d = d - floor(d / DIGITS) * DIGITS + 2
    heads[d] = heads[d] + 1
  end
  for d = 2, DIGITS do
    heads[d] = heads[d] + heads[d - 1]
  end
  for n = 1, count do
    local x = source[n]
    local d = floor(digit[x] * inverse)
    d = d - floor(d / DIGITS) * DIGITS + 1
    local at = heads[d] + 1
    heads[d], target[at] = at, x
  end
end

-- Sorts by the number in `digit`, which is below `limit`; what is equal stays in order.
local function sortAll(b, count, limit)
  local source, target, unit = b.footingOrder, b.footingBetween, 1
  while unit < limit do
    sortBy(b, source, target, count, unit)
    local sorted = target
    target = source
    source = sorted
    unit = unit * DIGITS
  end
  b.footingOrder, b.footingBetween = source, target
end

-- Sorts what is sorted nearly, by insertion.
local function finish(b, order, count)
  local support, first, second = b.footingSupport, b.footingFirst, b.footingSecond
  for n = 2, count do
    local x, at = order[n], n - 1
    local s, a, c = support[x], first[x], second[x]
    while at > 0 do
      local y = order[at]
      local t = support[y]
      if t > s or (t == s and (first[y] < a or (first[y] == a and second[y] < c))) then
        break
      end
      order[at + 1] = y
      at = at - 1
    end
    order[at + 1] = x
  end
end

-- Puts the footings in order: from the floor up, then in that of the world. Source: D. E. Knuth,
-- The Art of Computer Programming, vol. 3: sorting by distribution, by insertion.
local function arrange(b, count)
  for n = 1, count do
    b.footingOrder[n] = n
  end
  if count >= MANY then
    readSeats(b, count)
    sortAll(b, count, b.moverCount + 1)
    quantize(b, count)
    sortAll(b, count, DIGITS * DIGITS)
  end
  local order, turn, list = b.footingOrder, b.turn, b.footings
  finish(b, order, count)
  for at = 1, count do
    turn[list[order[at]]] = at
  end
end

--- Lists the footings of a step that begins.
function footing.list(b)
  b.footingAt, b.footingSlid, b.footingSeen = 0, 0, 0
  b.footingCount, b.oddCount = 0, 0
  -- With push = "first" what is flush is not at rest; and whom the world asks about cannot be
  -- plain.
  if b.pushFirst or b.worldCanCollide or b.queueOnly then
    return
  end
  local count = findUpper(b, keepPlain(b, gather.flush(b, b.footingOrder)))
  b.footingCount = count
  if count > 0 then
    weigh(b, count)
    arrange(b, count)
  end
end

-- Whether the paths of a footing do not press against each other (see gather.endOverlap).
local function isIdle(b, ku, kl, isUp)
  local low, high = ku, kl
  if isUp then
    low, high = kl, ku
  end
  local atLow, atHigh, size = b.to[low], b.to[high], b.size[low]
  local overlap = min(atLow + size - atHigh, atLow - (atHigh - size))
  return max(-overlap, min(EPSILON - overlap, STILL - (b.speed[low] - b.speed[high]))) >= 0
end

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

-- Coefficient of friction of a pair, as in `friction`. Who is not dynamic may have none (< 0).
local function coefficientOf(b, up, low)
  local one, other = b.friction[up], b.friction[low]
  if other < 0 or other == one then
    return one
  end
  return sqrt(one * other)
end

-- Changes speed and way of k by what friction took off, unless it is held there. (Few are held at
-- all: asked first, so that the sign of what is taken makes no two ways through the code.)
local function shift(b, k, dSpeed, dWay)
  local heldLow, heldHigh = b.heldLow[k], b.heldHigh[k]
  if (heldLow or heldHigh) and ((dSpeed > 0 and heldHigh) or (dSpeed < 0 and heldLow)) then
    return
  end
  b.speed[k], b.to[k] = b.speed[k] + dSpeed, b.to[k] + dWay
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
  shift(b, ka, dSpeed * shareU, dWay * shareU)
  shift(b, kb, -dSpeed * shareL, -dWay * shareL)
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
  b.hit[p], b.hitSpeed[p], b.met[p] = side, u, 1
  to[ku] = goal
  if v > 0 then
    speed[ku] = speed[kl]
    b.footingImpulse[x], b.footingShare[x] = v / b.inverseMass[up], min(u / v, 1.0)
  end
  if v > -STILL then
    lean(b, low, ku, kl, isUp)
  end
  return true
end

--- Whether the first event of the queue, which is one at the very beginning (see `land`), comes
--- before the next footing.
function footing.isLater(b)
  local x = b.footingOrder[b.footingAt + 1]
  return queue.leads(b.queue, b.footingSupport[x], b.footingFirst[x], b.footingSecond[x])
end

--- What `land` may return, but for a pair.
footing.DONE, footing.CHANGED, footing.ASK = 0, -1, -2

--- Lands one footing after the other in a step of dt s, until something else goes before the next;
--- `isNext` if the queue was asked already and does not. Returns what that is: a pair that must be
--- looked at in the general way; CHANGED: the last one's neighbours; ASK: `isLater` must be asked;
--- DONE: nothing, no footing is left. Those that have landed must `slide` first.
function footing.land(b, dt, isNext)
  local q, order, list, ups, lows = b.queue, b.footingOrder, b.footings, b.footingUp, b.footingLow
  local axis, turn, impulses = b.downAxis, b.turn, b.footingImpulse
  local isUp, sides, watched = b.orientation[axis] < 0, b.footingSide, b.watched
  local step = b.step
  for at = b.footingAt + 1, b.footingCount do
    local x = order[at]
    local p, up, low = list[x], ups[x], lows[x]
    if q.size > 0 and q.data[q.heap[1] + queue.KEY] == 0 and not isNext then
      return footing.ASK
    end
    isNext = false
    b.footingAt, impulses[x] = at, 0
    if turn[p] == at and isIdle(b, 2 * up + axis, 2 * low + axis, isUp) then
      -- If it comes to press, that goes before later footings.
      watched[up], watched[low] = step, step
    elseif turn[p] == at then
      if not land(b, x, p, sides[x], up, low, 2 * up + axis, 2 * low + axis, isUp, dt) then
        return p
      end
      b.resolved = b.resolved + 1
      if watched[up] == step then
        return footing.CHANGED
      end
    end
  end
  return footing.DONE
end

--- Lets those rub that have landed, in the same order. That changes paths across gravity only,
--- which no footing and nothing else at the very beginning depends on, so it may follow the
--- landings (one loop for both would be too long for the trace compiler). Returns false at one that
--- needs more than this loop does, and must `rub`.
function footing.slide(b, dt)
  local order, ups, lows, impulses = b.footingOrder, b.footingUp, b.footingLow, b.footingImpulse
  local axis, shares = b.downAxis, b.footingShare
  local sign = b.orientation[axis] < 0 and -1 or 1
  for at = b.footingSlid + 1, b.footingAt do
    local x = order[at]
    local up, low, impulse = ups[x], lows[x], impulses[x]
    local mu = impulse > 0 and coefficientOf(b, up, low) or 0
    if mu > 0 and not stick(b, up, low, 2 * up + axis, 2 * low + axis, mu, impulse, sign) then
      b.footingSlid = at
      local ku, kl, limit = 2 * up + axis, 2 * low + axis, mu * impulse
      if not slideTogether(b, up, low, ku, kl, limit, shares[x], sign, dt) then
        return false
      end
      impulses[x] = RUBBED
    end
  end
  b.footingSlid = b.footingAt
  return true
end

--- Lets the footing rub at which `slide` has stopped.
function footing.rub(b, dt)
  local x, axis = b.footingOrder[b.footingSlid], b.downAxis
  local up, low = b.footingUp[x], b.footingLow[x]
  local isDown = b.orientation[axis] > 0
  local lo, hi = isDown and up or low, isDown and low or up
  friction.rub(b, lo, hi, axis, b.footingImpulse[x], b.footingShare[x], dt, 0)
  b.footingImpulse[x] = RUBBED
end

local function addStray(b, i)
  if detect.hasLeft(b, i) and b.changedMark[i] ~= b.changeStamp then
    b.changedCount = b.changedCount + 1
    b.changed[b.changedCount], b.changedMark[i] = i, b.changeStamp
  end
end

--- Lists those in `changed` whose paths have left their fat boxes since the last call, by landing
--- and sliding.
function footing.listStrays(b)
  local order, ups, lows, impulses = b.footingOrder, b.footingUp, b.footingLow, b.footingImpulse
  for at = b.footingSeen + 1, b.footingAt do
    local x = order[at]
    addStray(b, ups[x])
    if impulses[x] == RUBBED then
      addStray(b, lows[x])
    end
  end
  b.footingSeen = b.footingAt
end

return footing
