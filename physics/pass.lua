--- Step 6, meet: one pass through the turns of a round (see `turns`, `rounds`), along gravity or
--- across it, without the queue.
--
-- What is not simple (`footing`, `press`) goes to `meet`. The queue alone would give the same bits.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local footing = require(here .. ".footing")
local gather = require(here .. ".gather")
local press = require(here .. ".press")
local queue = require(here .. ".queue")
local resolve = require(here .. ".resolve")
local rounds = require(here .. ".rounds")

local pass = {}

local huge, min = math.huge, math.min
local changesOf, isIdle, isSettled = gather.changesOf, gather.isIdle, gather.isSettled
local PATIENCE, UNSEEN = resolve.PATIENCE, columns.UNSEEN
local REFUSED, LOW, HIGH, RUBS = press.REFUSED, press.LOW, press.HIGH, press.RUBS

--- Whether there is an event in the queue that may come before a turn whose key is `key` there (see
--- `keyOf` in meet).
function pass.isAsked(q, key)
  return q.size > 0 and q.data[q.heap[1] + queue.KEY] <= key
end

--- Whether the first event of the queue comes before the next turn.
function pass.isLater(b)
  local x, across = rounds.turnAt(b, b.turnsDone + 1)
  local round = b.turnRound
  local support, first, second = b.turnSupport[x], b.turnFirst[x], b.turnSecond[x]
  return queue.leads(b.queue, 2 * round + across, rounds.turned(round, support, first, second))
end

--- What `run` may return, but for a pair.
pass.DONE, pass.CHANGED, pass.ASK, pass.PERMIT, pass.FINISH = 0, -1, -2, -3, -4
local DONE, CHANGED, ASK, PERMIT, FINISH =
  pass.DONE, pass.CHANGED, pass.ASK, pass.PERMIT, pass.FINISH

-- Whether the game must be asked before a pair may bump (see `ask`).
local function mustAsk(b, p, i, j)
  return (b.worldCanCollide or b.canCollide[i] or b.canCollide[j]) and b.permitted[p] ~= b.step
end

-- Whether two who press do not meet: they pass through each other, or it would change nothing.
local function isOver(b, p)
  return b.passing[p] or b.met[p] >= PATIENCE or isSettled(b, p)
end

-- Returns up to which turn of this round, along gravity (`across` 0) or across it (1), the queue
-- need not be asked; `isNext` if it was asked about the next one already, and does not go first.
local function freeUpTo(b, across, isNext)
  if pass.isAsked(b.queue, 2 * b.turnRound + across) then
    return b.turnsDone + (isNext and 1 or 0)
  end
  return huge
end

-- Returns what is left to do after two have had their turn, the pair p: what `press` says of it.
local function after(b, p, i, j, gives)
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

-- What `turnSeen` is of two who did press when they were looked at, and may again whatever of them
-- changes; < UNSEEN.
local function wholly(changes, i, j)
  return UNSEEN - 1 - changesOf(changes, i, j)
end

-- Whether the two of turn x are as they were when they were looked at.
local function isSame(ups, lows, changes, seen, axis, x)
  local ku, kl = 2 * ups[x], 2 * lows[x]
  local last, look = seen[x], changes[ku + axis] + changes[kl + axis]
  local whole = UNSEEN - 1 - look - changes[ku + 1 - axis] - changes[kl + 1 - axis] -- `wholly`
  return (last - look) * (last - whole) == 0
end

-- What `land` returns if the next turn is none of its own.
local OTHER = -5

-- Lets those who stand on something that stands fast land, one after the other from the next turn
-- on, in the first round along gravity: nearly all do, in heaps and levels. Returns DONE, CHANGED
-- (see `run`) or OTHER. (The loop of `run` does the same; but most of what goes through that does
-- not press at all, and the compiler goes best the way that it came first.)
local function land(b, dt, isNext)
  local order, list, ups, lows, sides = b.turnOrder, b.turnPair, b.turnUp, b.turnLow, b.turnSide
  local changes, axis, last, step = b.changes, b.downAxis, b.footingCount, b.step
  local isUp, free = b.orientation[axis] < 0, freeUpTo(b, 0, isNext)
  local n, left, isStale = b.turnsDone, DONE, b.isTurnStale[0]
  while left == DONE and n < last do
    local x = order[n + 1]
    local p, up, low = list[x], ups[x], lows[x]
    local ku, kl = 2 * up + axis, 2 * low + axis
    if n >= free then
      left = OTHER
    elseif isIdle(b, isUp and kl or ku, isUp and ku or kl) then
      b.turnSeen[x], n = changes[ku] + changes[kl], n + 1
    elseif
      isOver(b, p) or not footing.putOn(b, n + 1, x, p, sides[x], up, low, ku, kl, isUp, dt)
    then
      left = OTHER
    else
      n, isStale, b.permitted[p], b.resolved = n + 1, true, 0, b.resolved + 1
      if b.isEager or b.watched[up] == step or b.watched[low] == step then
        left = CHANGED
      end
    end
  end
  b.turnsDone, b.isTurnStale[0], b.turnGives = n, isStale, isUp and HIGH or LOW
  return left
end

--- Lets one footing (`across` 0) or flank (1) after the other have its turn in a step of dt s,
--- until something else goes before the next; `isNext` if the queue was asked already and does not.
--- Returns what that is: a pair that must be resolved in the general way; CHANGED: somebody must be
--- looked at whom the last one has changed; FINISH: what is to come of the last one (see `press`),
--- then perhaps the same; ASK: `isLater` must be asked; PERMIT: the game must be, about the next;
--- DONE: nothing, none is left. Footings that have landed must `slide` first. Whose paths are the
--- same as in the round before is passed over. Who has given way is told in b.turnGives.
---
--- (The loop is left by its condition only: a way out of its middle leads to what is interpreted,
--- and the compiler gives up the whole way there. It is one loop for both kinds, and who presses
--- does so when the loop comes round again: whatever has led there, `press` is compiled once.)
function pass.run(b, across, dt, isNext)
  if across == 0 and b.turnRound == 0 and not b.hasAskers then
    local before = b.turnsDone
    if land(b, dt, isNext) == CHANGED then
      return CHANGED
    end
    isNext = isNext and b.turnsDone == before
  end
  local order, list, ups, lows, sides = b.turnOrder, b.turnPair, b.turnUp, b.turnLow, b.turnSide
  local changes, seen, hasAskers = b.changes, b.turnSeen, b.hasAskers
  local axis = across == 0 and b.downAxis or 1 - b.downAxis
  local first, last = rounds.span(b, across)
  local isUp, free = b.orientation[axis] < 0, freeUpTo(b, across, isNext)
  local base, way = rounds.direction(b.turnRound, first, last)
  local n, left, isStale = b.turnsDone, DONE, b.isTurnStale[across]
  local most, presses = min(last, free), 0 -- 1: the next turn does
  local seenUpTo = b.turnRound > 0 and most or 0 -- in the first round nobody has been looked at
  while left == DONE and n < last do
    if presses == 1 then
      presses, n = 0, n + 1
      local x = order[base + way * n]
      local p, up, low = list[x], ups[x], lows[x]
      local gives, side = isUp and HIGH or LOW, sides[x]
      seen[x], isStale = wholly(changes, up, low), true
      if
        across == 1
        or not footing.putOn(b, n, x, p, side, up, low, 2 * up + axis, 2 * low + axis, isUp, dt)
      then
        local lo, hi = up, low
        if isUp then
          lo, hi = low, up
        end
        gives = press.run(b, x, p, side, lo, hi, axis, dt)
      end
      left = after(b, p, up, low, gives)
    else
      while n < seenUpTo and isSame(ups, lows, changes, seen, axis, order[base + way * (n + 1)]) do
        n = n + 1
      end
      if n < most then
        local x = order[base + way * (n + 1)]
        local p, up, low = list[x], ups[x], lows[x]
        local ku, kl = 2 * up + axis, 2 * low + axis
        if isIdle(b, isUp and kl or ku, isUp and ku or kl) then
          n, seen[x] = n + 1, changes[ku] + changes[kl] -- nothing happens
        elseif isOver(b, p) then
          n, seen[x], isStale = n + 1, wholly(changes, up, low), true -- nothing, either
        elseif hasAskers and mustAsk(b, p, up, low) then
          left, seen[x], isStale = PERMIT, UNSEEN, true
        else
          presses = 1
        end
      elseif n < last then
        left = ASK
      end
    end
  end
  b.turnsDone, b.isTurnStale[across] = n, isStale
  return left
end

return pass
