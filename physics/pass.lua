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

local huge = math.huge
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

-- Returns how many turns are done: not the n-th yet, if somebody must be asked about it.
local function countDone(left, n)
  return (left == ASK or left == PERMIT) and n - 1 or n
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
--- and the compiler gives up the whole way there. It is one loop for both kinds, so that `press` is
--- compiled once.)
function pass.run(b, across, dt, isNext)
  local order, list, ups, lows, sides = b.turnOrder, b.turnPair, b.turnUp, b.turnLow, b.turnSide
  local changes, seen, hasAskers = b.changes, b.turnSeen, b.hasAskers
  local axis = across == 0 and b.downAxis or 1 - b.downAxis
  local first, last = rounds.span(b, across)
  local isUp, free = b.orientation[axis] < 0, freeUpTo(b, across, isNext)
  local base, way = rounds.direction(b.turnRound, first, last)
  local n, left, isStale = b.turnsDone, DONE, b.isTurnStale[across]
  while left == DONE and n < last do
    n = n + 1
    local x = order[base + way * n]
    local up, low = ups[x], lows[x]
    local look = changes[2 * up + axis] + changes[2 * low + axis]
    if n > free then
      left = ASK
    elseif seen[x] ~= look and seen[x] ~= wholly(changes, up, low) then
      local p, lo, hi = list[x], up, low
      if isUp then
        lo, hi = low, up
      end
      if isIdle(b, 2 * lo + axis, 2 * hi + axis) then
        seen[x] = look -- nothing happens
      else
        seen[x], isStale = wholly(changes, up, low), true
        if isOver(b, p) then
          left = DONE -- nothing, either
        elseif hasAskers and mustAsk(b, p, up, low) then
          left, seen[x] = PERMIT, UNSEEN
        else
          local gives, side = isUp and HIGH or LOW, sides[x]
          if
            across == 1
            or not footing.putOn(b, n, x, p, side, up, low, 2 * up + axis, 2 * low + axis, isUp, dt)
          then
            gives = press.run(b, x, p, side, lo, hi, axis, dt)
          end
          left = after(b, p, up, low, gives)
        end
      end
    end
  end
  b.turnsDone, b.isTurnStale[across] = countDone(left, n), isStale
  return left
end

return pass
