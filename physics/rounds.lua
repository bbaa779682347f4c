--- Step 6, meet: the order of what touches when a step begins.
--
-- Faces that are met at the very beginning have their turns in rounds: first all along gravity,
-- then all across it; in the first round supports come first (from the floor up, from walls
-- outwards), then the order of the world decides; the next round goes back, the third one as the
-- first, until nobody presses any more. Whose turn has gone by when it comes to press waits for
-- the next round. So a push reaches the other end of a row in one round, whichever way it goes.
-- Source: symmetric Gauss-Seidel iteration, as in D. M. Young, Iterative Solution of Large Linear
-- Systems (1971).
--
-- Where the rounds are: b.round, b.roundAxis (-1: at the beginning of all, 0: along gravity, 1:
-- across it, 2: behind the last turn of this round) and what decides the place among those of the
-- same axis, in the order of the first round.

local rounds = {}

--- So many rounds differ; all beyond are one.
rounds.MOST = 1024
local LAST = rounds.MOST - 1

--- Goes to the beginning of the first round.
function rounds.start(b)
  b.round, b.roundAxis = 0, -1
end

--- Goes behind the last turn of a round.
function rounds.finish(b, round)
  b.round, b.roundAxis = round, 2
end

-- Whether a round goes back.
local function isBack(round)
  return round % 2 == 1
end

--- Returns `base` and `way` (1 or -1): the n-th turn of a round, n from `first` to `last`, is at
--- place `base + way * n` of their order in the first round.
---@return number
---@return number
function rounds.direction(round, first, last)
  if isBack(round) then
    return first + last, -1
  end
  return 0, 1
end

--- Returns the first and the last turn of a round along gravity (`across` 0) or across it (1).
---@return number
---@return number
function rounds.span(b, across)
  if across == 0 then
    return 1, b.footingCount
  end
  return b.footingCount + 1, b.turnCount
end

--- Returns the place in the columns of turns of the n-th turn of this round, and 1 if it is across
--- gravity, 0 if along.
function rounds.turnAt(b, n)
  local across = n > b.footingCount and 1 or 0
  local base, way = rounds.direction(b.turnRound, rounds.span(b, across))
  return b.turnOrder[base + way * n], across
end

--- Returns what decides the place of a turn in a round (the larger support first, then the smaller
--- ranks) from what does in the first round; and the other way, too.
function rounds.turned(round, support, first, second)
  if isBack(round) then
    return -support, -first, -second
  end
  return support, first, second
end

--- Goes to a turn; `axis` is 0 along gravity and 1 across it.
function rounds.pass(b, round, axis, support, first, second)
  b.round, b.roundAxis = round, axis
  b.roundSupport, b.roundFirst, b.roundSecond = support, first, second
end

-- Whether a turn comes later than where the rounds are, if they go from first to last on its axis.
local function isBehind(b, support, first, second)
  if support ~= b.roundSupport then
    return support < b.roundSupport
  elseif first ~= b.roundFirst then
    return first > b.roundFirst
  end
  return second > b.roundSecond
end

--- Returns the round in which two who come to press now have their turn: this one, or if that has
--- gone by, the next.
function rounds.of(b, axis, support, first, second)
  local round, isLater = b.round, axis > b.roundAxis
  if axis == b.roundAxis then
    local isHere = support == b.roundSupport and first == b.roundFirst and second == b.roundSecond
    isLater = not isHere and isBehind(b, support, first, second) ~= isBack(round)
  end
  if isLater or round == LAST then
    return round
  end
  return round + 1
end

return rounds
