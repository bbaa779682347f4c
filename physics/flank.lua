--- Step 6, meet: what leans on something across gravity when the step begins.
--
-- The flanks of a round have their turns behind the footings (see `turns`), in one loop, too. What
-- is not simple goes to `meet`, and the queue alone would give the same bits.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local footing = require(here .. ".footing")
local gather = require(here .. ".gather")
local press = require(here .. ".press")
local rounds = require(here .. ".rounds")

local flank = {}

local UNSEEN = columns.UNSEEN
local isIdle, isOver = gather.isIdle, footing.isOver
local REFUSED, RUBS = press.REFUSED, press.RUBS

--- Lets one flank after the other press in a step of dt s; see `footing.land`.
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
        local gives = press.run(b, x, p, sides[x], lo, hi, axis, dt)
        if gives == REFUSED then
          return p
        end
        b.permitted[p], b.resolved, b.turnGives = 0, b.resolved + 1, gives
        if gives >= RUBS then
          return footing.RUB
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
