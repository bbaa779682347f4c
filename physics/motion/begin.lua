--- Begin: resets the columns of a step of each awake body. It has a path of length 0 where it is,
-- and nothing has touched it yet.

local begin = {}

local function resetPaths(b, list, first, last)
  local position, from, to, time = b.position, b.from, b.to, b.time
  for n = first, last do
    local i = list[n]
    local k = 2 * i
    from[k], to[k] = position[k], position[k]
    from[k + 1], to[k + 1] = position[k + 1], position[k + 1]
    time[i] = 0
  end
end

local function resetNotes(b, list, first, last)
  local buried, heard, news, crushed = b.buried, b.heard, b.news, b.crushed
  for n = first, last do
    local i = list[n]
    buried[i], heard[i], news[i] = false, false, false
    crushed[2 * i], crushed[2 * i + 1] = false, false
  end
end

local function resetPressed(b, list, first, last)
  local pressedLow, pressedHigh = b.pressedLow, b.pressedHigh
  for n = first, last do
    local k = 2 * list[n]
    pressedLow[k], pressedHigh[k] = false, false
    pressedLow[k + 1], pressedHigh[k + 1] = false, false
  end
end

--- Resets the step columns of those in awakeList that have not begun this step.
function begin.run(b)
  local list, first, last = b.awakeList, b.begun + 1, b.awakeCount
  resetPaths(b, list, first, last)
  resetNotes(b, list, first, last)
  resetPressed(b, list, first, last)
  b.begun = last
end

--- Notes where everything is before a fixed step.
function begin.keepPlaces(b)
  local movers, position, last = b.movers, b.position, b.last
  for n = 1, b.moverCount do
    local k = 2 * movers[n]
    last[k], last[k + 1] = position[k], position[k + 1]
  end
end

return begin
