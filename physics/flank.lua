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

--- Lets one flank after the other press in a step of dt s; see `footing.land`.
function flank.land(b, dt, isNext)
  local order, list, ups, lows, sides = b.turnOrder, b.turnPair, b.turnUp, b.turnLow, b.turnSide
  local axis = 1 - b.downAxis
  local isUp, free = b.orientation[axis] < 0, footing.freeUpTo(b, 1, isNext)
  local changes, seen = b.changes, b.turnSeen
  local base, way = rounds.direction(b.turnRound, b.footingCount + 1, b.turnCount)
  local n, last, left = b.turnsDone, b.turnCount, footing.DONE
  while left == footing.DONE and n < last do
    n = n + 1
    local x = order[base + way * n]
    local lo, hi = ups[x], lows[x]
    local look = changes[lo] + changes[hi]
    if n > free then
      left = footing.ASK
    elseif seen[x] ~= look then
      if isUp then
        lo, hi = lows[x], ups[x]
      end
      local p = list[x]
      seen[x] = look
      if isIdle(b, 2 * lo + axis, 2 * hi + axis) or isOver(b, p) then
        left = footing.DONE
      elseif b.hasAskers and footing.mustAsk(b, p, lo, hi) then
        left, seen[x] = footing.PERMIT, UNSEEN
      else
        left = footing.after(b, p, lo, hi, press.run(b, x, p, sides[x], lo, hi, axis, dt))
      end
    end
  end
  b.turnsDone = footing.over(left, n)
  return left
end

return flank
