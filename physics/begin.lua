--- Beginning of a step for one object: its path is where it stands, nothing has touched it yet.

local begin = {}

--- Resets the step columns of those in awakeList that have not begun this step.
function begin.run(b)
  local list, first, last = b.awakeList, b.begun + 1, b.awakeCount
  local position, from, to, time = b.position, b.from, b.to, b.time
  for n = first, last do
    local i = list[n]
    local k = 2 * i
    from[k], to[k] = position[k], position[k]
    from[k + 1], to[k + 1] = position[k + 1], position[k + 1]
    time[i] = 0
  end
  local heldLow, heldHigh, weld, weldNext = b.heldLow, b.heldHigh, b.weld, b.weldNext
  for n = first, last do
    local k = 2 * list[n]
    heldLow[k], heldHigh[k], weld[k], weldNext[k] = 0, 0, 0, 0
    k = k + 1
    heldLow[k], heldHigh[k], weld[k], weldNext[k] = 0, 0, 0, 0
  end
  local backedLow, backedHigh = b.backedLow, b.backedHigh
  for n = first, last do
    local k = 2 * list[n]
    backedLow[k], backedHigh[k] = false, false
    backedLow[k + 1], backedHigh[k + 1] = false, false
  end
  local holderLow, holderHigh, crushed = b.holderLow, b.holderHigh, b.crushed
  for n = first, last do
    local k = 2 * list[n]
    holderLow[k], holderHigh[k], crushed[k] = 0, 0, false
    k = k + 1
    holderLow[k], holderHigh[k], crushed[k] = 0, 0, false
  end
  local pressedLow, pressedHigh, stuck, grip = b.pressedLow, b.pressedHigh, b.stuck, b.grip
  local buried, heard, news = b.buried, b.heard, b.news
  for n = first, last do
    local i = list[n]
    local k = 2 * i
    stuck[i], grip[i], buried[i], heard[i], news[i] = false, 0, false, false, false
    pressedLow[k], pressedHigh[k] = false, false
    pressedLow[k + 1], pressedHigh[k + 1] = false, false
  end
  b.begun = last
end

--- Notes where everybody is before a fixed step.
function begin.keepPlaces(b)
  local movers, position, last = b.movers, b.position, b.last
  for n = 1, b.moverCount do
    local k = 2 * movers[n]
    last[k], last[k + 1] = position[k], position[k + 1]
  end
end

return begin
