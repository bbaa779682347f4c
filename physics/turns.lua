--- Step 6, meet: what touches when the step begins, in the order in which it has its turn.
--
-- In piles and levels nearly all contacts are there from the beginning. Those along gravity,
-- footings, come first in each round (see `rounds`), from the floor up or back; then those across,
-- flanks, from the right-hand side as gravity sees it or back. So they need no queue: they are
-- listed once a step, sorted, and settled in one pass a round (`pass`). What is anything but plain
-- is odd, and left to the queue, which alone would give the same bits.
--
-- Of the two of a turn, `low` is the one that supports: further down, or to the right.
--
-- Reads from, size, kind, plain, the live pairs; writes the columns of turns, odd and turn.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local gather = require(here .. ".gather")
local oneway = require(here .. ".oneway")

local turns = {}

local DYNAMIC, GIVES = columns.DYNAMIC, columns.GIVES
local EPSILON, FACES, FIRM = columns.EPSILON, columns.FACES, columns.FIRM
local RANKS, UNSEEN = columns.RANKS, columns.UNSEEN
local ceil, floor, huge, max, min = math.ceil, math.floor, math.huge, math.max, math.min

-- So few are inserted into the others.
local FEW = 6
-- So often each may move, on average, before sorting anew is faster.
local MOVES = 8
-- From how many turns on sorting by digits is worth it, and from how many on with more of them.
local SOME, MANY = 24, 1000
local FEW_DIGITS, MANY_DIGITS = 256, 1024

-- Marks slot i if it touches the immovable j and may slide around a corner of it: anywhere but on
-- the side that gravity presses.
local function markLoose(b, i, j)
  local axis, from, size = b.downAxis, b.from, b.size
  local k, m, kc, mc = 2 * i + axis, 2 * j + axis, 2 * i + 1 - axis, 2 * j + 1 - axis
  local r, rc = from[m] - from[k], from[mc] - from[kc]
  local below = b.down[k] > 0 and r - size[k] or -r - size[m]
  local edge = min(size[kc] - rc, size[mc] + rc)
  if b.down[k] == 0 or below < -EPSILON or edge <= EPSILON then
    b.looseAt[i] = b.step
  end
end

-- Marks those who may slide around a corner at the very beginning of the step: then they no longer
-- touch whom they touched.
local function findLoose(b)
  local list, pairA, pairB, kind, nudge = b.touchList, b.pairA, b.pairB, b.kind, b.nudge
  for n = 1, b.touchCount do
    local p = list[n]
    local i, j = pairA[p], pairB[p]
    if nudge[i] ~= 0 and kind[j] ~= DYNAMIC then
      markLoose(b, i, j)
    elseif nudge[j] ~= 0 and kind[i] ~= DYNAMIC then
      markLoose(b, j, i)
    end
  end
end

-- Whether something else may happen between two that meet than that they bump: one of them is a
-- sensor, or open there, or slides around a corner, or cannot be pushed by the other. (On what
-- stands fast nobody is pushed, and no other footings have a turn in the end.)
local function isChoosy(b, up, low, axis, direction)
  local upSide = 2 * axis + 1.5 + 0.5 * direction
  return not (b.plain[up] and b.plain[low])
    or oneway.isOpen(b, up, upSide)
    or oneway.isOpen(b, low, 4 * axis + 3 - upSide)
    or b.looseAt[up] == b.step
    or b.looseAt[low] == b.step
    or (
      axis ~= b.downAxis
      and not (b.pushable[up] and b.pushable[low])
      and b.kind[up] == DYNAMIC
      and b.kind[low] == DYNAMIC
    )
end

-- Works out who leans on whom along an axis, of the pairs that are flush, behind place `last`;
-- returns the last place then. Pairs that are not plain are listed behind b.odd, and so are
-- footings of which the upper one cannot fall.
local function findLow(b, flush, flushCount, axis, last)
  local list, ups, lows, sides = b.turnPair, b.turnUp, b.turnLow, b.turnSide
  local pairA, pairB, from, kind, odd = b.pairA, b.pairB, b.from, b.kind, b.odd
  local dropping, oddCount = b.dropping, b.oddCount
  local isUp, isFooting = b.orientation[axis] < 0, axis == b.downAxis
  local choosy, direction, nearSide = b.choosy, isUp and -1 or 1, 2 * axis + (isUp and 1 or 2)
  local usual, opposite = isUp and 1 or 0, 4 * axis + 3 - 2 * nearSide ---@type number, number
  for n = 1, flushCount do
    local p = flush[n]
    local i, j = pairA[p], pairB[p]
    -- 1: the second one is the upper one. No branches. (`ceil` makes a whole number of any
    -- difference: very thin ones may be anywhere.)
    local isAhead = max(min(ceil(from[2 * i + axis] - from[2 * j + axis]), 1), 0)
    local isTurned = usual + isAhead * direction ---@type number
    local up, low = i + (j - i) * isTurned, j + (i - j) * isTurned
    local side = nearSide + opposite * isTurned
    if
      (isFooting and kind[up] ~= DYNAMIC)
      or dropping[p]
      or ((choosy[up] or choosy[low]) and isChoosy(b, up, low, axis, direction))
    then
      oddCount = oddCount + 1
      odd[oddCount] = p
    else
      last = last + 1
      list[last], ups[last], lows[last], sides[last] = p, up, low, side
    end
  end
  b.oddCount = oddCount
  return last
end

-- What decides their order (see `meet`): how firmly the lower one stands, and their ranks, as
-- `columns.ranks`. No branches.
local function weigh(b, axis, first, last)
  local ups, lows, support, standsOn = b.turnUp, b.turnLow, b.turnSupport, b.support
  local firsts, seconds, rank, kind = b.turnFirst, b.turnSecond, b.rank, b.kind
  local from, size, isUp, seen = b.from, b.size, b.orientation[axis] < 0, b.turnSeen
  for x = first, last do
    local up, low = ups[x], lows[x]
    local one, other, m = rank[up], rank[low], 2 * up + axis
    local upGives, lowGives = GIVES[kind[up]], GIVES[kind[low]]
    local bothGive = upGives * lowGives
    local ahead = min(one, other) * bothGive + one * (1 - lowGives) + other * (lowGives - bothGive)
    local stands, leans = standsOn[up] - low, standsOn[low] - up -- 0: one stands on the other
    local stand = 1 - min(max(stands, -stands), max(leans, -leans), 1)
    firsts[x], seconds[x] = ahead - RANKS * stand * bothGive, one + other - ahead - RANKS * stand
    seen[x] = UNSEEN
    local face = isUp and -from[m] or from[m] + size[m]
    support[x] = floor(face * FACES + 0.5) / FACES * bothGive + FIRM * (1 - bothGive)
  end
end

-- Writes into `digit` how far down each is (see `meet`), as a whole number below `limit`: 0 for
-- what leans on something immovable, then from the lowest up. Returns false if nearly all do, as in
-- levels: then the others need no digits.
local function quantize(b, first, last, limit)
  local support, digit = b.turnSupport, b.sortDigit
  local lowest, highest, count = -FIRM, FIRM, 0
  for x = first, last do
    local s = support[x]
    if s ~= FIRM then
      lowest, highest, count = max(lowest, s), min(highest, s), count + 1
    end
  end
  if count < FEW then
    return false
  end
  local scale = lowest > highest and (limit - 2) / (lowest - highest) or 0
  for x = first, last do
    local s = support[x]
    digit[x] = s == FIRM and 0 or 1 + floor((lowest - s) * scale)
  end
  return true
end

-- The place of the first in the order of the world.
local function readSeats(b, first, last)
  local digit, seat, ups, lows, kind = b.sortDigit, b.seat, b.turnUp, b.turnLow, b.kind
  for x = first, last do
    local up, low = ups[x], lows[x]
    local one, other = seat[up], seat[low]
    if kind[low] ~= DYNAMIC then
      other = one
    elseif kind[up] ~= DYNAMIC then
      one = other
    end
    digit[x] = min(one, other)
  end
end

-- One pass of a radix sort, stable: from `source` to `target` by the digit that is worth `unit`.
local function sortBy(b, source, target, count, unit, digits)
  local digit, heads, inverse = b.sortDigit, b.sortHeads, 1 / unit
  for d = 1, digits + 1 do
    heads[d] = 0
  end
  for n = 1, count do
    local rest = floor(digit[source[n]] * inverse)
    local d = rest - floor(rest / digits) * digits + 2
    heads[d] = heads[d] + 1
  end
  for d = 2, digits do
    heads[d] = heads[d] + heads[d - 1]
  end
  for n = 1, count do
    local x = source[n]
    local rest = floor(digit[x] * inverse)
    local d = rest - floor(rest / digits) * digits + 1
    local at = heads[d] + 1
    heads[d], target[at] = at, x
  end
end

-- Sorts by the number in `digit`, which is below `limit`; what is equal stays in order.
local function sortAll(b, count, limit, digits)
  local source, target = b.sortFrom, b.sortTo
  local unit = 1 ---@type number
  while unit < limit do
    sortBy(b, source, target, count, unit, digits)
    local sorted = target
    target = source
    source = sorted
    unit = unit * digits
  end
  b.sortFrom, b.sortTo = source, target
end

-- Whether turn x comes before turn y in the first round.
local function isBefore(support, first, second, x, y)
  local s, t = support[x], support[y]
  return s > t
    or (s == t and (first[x] < first[y] or (first[x] == first[y] and second[x] < second[y])))
end

-- Puts x, which stands at place n of `order`, where it belongs among those before; returns how many
-- have moved.
local function insert(order, support, first, second, x, n)
  local at = n - 1
  repeat
    order[at + 1] = order[at]
    at = at - 1
  until at == 0 or not isBefore(support, first, second, x, order[at])
  order[at + 1] = x
  return n - 1 - at
end

-- Sorts what is sorted nearly, by insertion. Returns false if it is not: if more than `most` had to
-- be moved; it is not done then.
local function finish(b, order, count, most)
  local support, first, second = b.turnSupport, b.turnFirst, b.turnSecond
  local n = 2
  while n <= count and most >= 0 do
    local x = order[n]
    if isBefore(support, first, second, x, order[n - 1]) then
      most = most - insert(order, support, first, second, x, n)
    end
    n = n + 1
  end
  return most >= 0
end

-- Lists those from `first` to `last` in the order in which they had their turns in the step before,
-- when there were `before` of them; a new one behind what the same one leant on (`theirs`), as a
-- walker comes to the next tile. Those that had none go last; returns false if these are many.
local function recall(b, first, last, before, theirs)
  local order, places, late, lastTurn = b.sortFrom, b.sortTo, b.sortDigit, b.lastTurn
  local list, ups, lateCount, count = b.turnPair, b.turnUp, 0, 0
  -- At 2 n the one that was the n-th, at 2 n + 1 a new one behind it.
  local most = 2 * before + 1
  for at = 1, most do
    places[at] = 0
  end
  for x = first, last do
    local at = 2 * lastTurn[list[x]]
    at = at > 0 and at or 2 * theirs[ups[x]] + 1
    if at > 1 and at <= most and places[at] == 0 then
      places[at] = x
    else
      lateCount = lateCount + 1
      late[lateCount] = x
    end
  end
  for at = 2, most, 2 do
    local old, new = places[at], places[at + 1]
    if old ~= 0 then
      count = count + 1
      order[count] = old
    end
    if new ~= 0 then
      count = count + 1
      order[count] = new
    end
  end
  for n = 1, lateCount do
    order[count + n] = late[n]
  end
  return lateCount <= FEW + count / 16
end

-- Sorts the places from `first` to `last` of the list from nothing.
-- Source: D. E. Knuth, The Art of Computer Programming, vol. 3: sorting by distribution, by
-- insertion.
local function sort(b, first, last)
  local count = last - first + 1
  for n = 1, count do
    b.sortFrom[n] = first + n - 1
  end
  if count >= SOME then
    local digits = count < MANY and FEW_DIGITS or MANY_DIGITS
    readSeats(b, first, last)
    sortAll(b, count, b.moverCount + 1, digits)
    if quantize(b, first, last, digits * digits) then
      sortAll(b, count, digits * digits, digits)
    end
  end
  finish(b, b.sortFrom, count, huge)
end

-- Notes the turns of the `count` places in `order`, from turn `first` on, for this step and the
-- next.
local function note(b, order, first, count, theirs)
  local turnOrder, turn, list = b.turnOrder, b.turn, b.turnPair
  local lastTurn, ups = b.lastTurn, b.turnUp
  for n = 1, count do
    local x, at = order[n], first + n - 1
    turnOrder[at], turn[list[x]] = x, at
    lastTurn[list[x]], theirs[ups[x]] = n, n
  end
end

-- Gives turns to the places from `first` to `last` of the list: by support, then in the order of
-- the world. From one step to the next that changes little; `before` is how many there were, and
-- `theirs` a column for the turns of those who lean.
local function arrange(b, first, last, before, theirs)
  local count = last - first + 1
  -- The trace compiler goes the way that comes first: it shall not be that of those who land.
  local isKnown = before > FEW and recall(b, first, last, before, theirs)
  if not (isKnown and finish(b, b.sortFrom, count, MOVES * count)) then
    sort(b, first, last)
  end
  note(b, b.sortFrom, first, count, theirs)
end

-- Lists the turns of pairs that are flush along an axis behind place `last`; returns the last place
-- then. In the step before there were `before` of them.
local function listAlong(b, flush, count, axis, last, before, theirs)
  if count == 0 then
    return last -- asked here, where the trace compiler need not keep the columns of `findLow`
  end
  local first = last + 1
  last = findLow(b, flush, count, axis, last)
  if last >= first then
    weigh(b, axis, first, last)
    arrange(b, first, last, before, theirs)
  end
  return last
end

-- Marks odd pairs and those in them.
local function watchOdd(b)
  local odd, turn, pairA, pairB, watched, step = b.odd, b.turn, b.pairA, b.pairB, b.watched, b.step
  for n = 1, b.oddCount do
    local p = odd[n]
    turn[p] = -1
    watched[pairA[p]], watched[pairB[p]] = step, step
  end
end

--- Lists the turns of a step that begins: footings up to b.footingCount, then flanks up to
--- b.turnCount; and the pairs that are odd, up to b.oddFootings those along gravity.
function turns.list(b)
  local footings, flanks = b.footingCount, b.turnCount - b.footingCount
  b.turnRound, b.turnsDone, b.landedCount, b.slidCount = 0, 0, 0, 0
  b.turnPass, b.isTurnStale[0], b.isTurnStale[1] = -1, true, true
  b.footingCount, b.turnCount, b.oddFootings, b.oddCount = 0, 0, 0, 0
  gather.touching(b)
  if b.hasNudges then
    findLoose(b)
  end
  if b.queueOnly then
    return
  end
  local axis, along, across = b.downAxis, b.flushAlong, b.flushAcross
  local alongCount, acrossCount = gather.flush(b, axis, along, across)
  b.footingCount = listAlong(b, along, alongCount, axis, 0, footings, b.lastFooting)
  b.oddFootings = b.oddCount
  b.turnCount = listAlong(b, across, acrossCount, 1 - axis, b.footingCount, flanks, b.lastFlank)
  watchOdd(b)
end

return turns
