--- Beginning of a step: who is awake has a path where it stands, and nothing has touched it yet.

local here = (...):match("^(.*)%.[^.]+$")
local interpreted = require(here .. ".interpreted")

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

local function resetHolds(b, list, first, last)
  local heldLow, heldHigh, weld, weldNext = b.heldLow, b.heldHigh, b.weld, b.weldNext
  for n = first, last do
    local k = 2 * list[n]
    heldLow[k], heldHigh[k], weld[k], weldNext[k] = 0, 0, 0, 0
    k = k + 1
    heldLow[k], heldHigh[k], weld[k], weldNext[k] = 0, 0, 0, 0
  end
end

local function resetBacks(b, list, first, last)
  local backedLow, backedHigh = b.backedLow, b.backedHigh
  for n = first, last do
    local k = 2 * list[n]
    backedLow[k], backedHigh[k] = false, false
    backedLow[k + 1], backedHigh[k + 1] = false, false
  end
end

local function resetHolders(b, list, first, last)
  local holderLow, holderHigh, crushed = b.holderLow, b.holderHigh, b.crushed
  for n = first, last do
    local k = 2 * list[n]
    holderLow[k], holderHigh[k], crushed[k] = 0, 0, false
    k = k + 1
    holderLow[k], holderHigh[k], crushed[k] = 0, 0, false
  end
end

local function resetGrips(b, list, first, last)
  local stuck, grip, used, level = b.stuck, b.grip, b.gripUsed, b.level
  for n = first, last do
    local i = list[n]
    stuck[i], grip[i], used[i], level[i] = 0, 0, 0, 0
  end
end

local function resetBraking(b, list, first, last)
  local hit, accel = b.gripHit, b.gripAccel
  for n = first, last do
    local i = list[n]
    hit[i], accel[i] = 0, 0
  end
end

local function resetCargo(b, list, first, last)
  local cargo, goesWith = b.cargo, b.goesWith
  for n = first, last do
    local i = list[n]
    cargo[i], goesWith[i] = 0, 0
  end
end

local function resetOthers(b, list, first, last)
  local pressedLow, pressedHigh = b.pressedLow, b.pressedHigh
  local buried, heard, news = b.buried, b.heard, b.news
  for n = first, last do
    local i = list[n]
    local k = 2 * i
    buried[i], heard[i], news[i] = false, false, false
    pressedLow[k], pressedHigh[k] = false, false
    pressedLow[k + 1], pressedHigh[k + 1] = false, false
  end
end

--- Resets the step columns of those in awakeList that have not begun this step.
function begin.run(b)
  local list, first, last = b.awakeList, b.begun + 1, b.awakeCount
  b.hasCargo = b.hasCargo and first > 1
  resetPaths(b, list, first, last)
  resetHolds(b, list, first, last)
  if b.hasBacked then
    resetBacks(b, list, first, last)
  end
  resetHolders(b, list, first, last)
  if b.hasFriction then
    resetGrips(b, list, first, last)
    resetBraking(b, list, first, last)
  end
  resetCargo(b, list, first, last)
  resetOthers(b, list, first, last)
  b.begun = last
end

interpreted.functions(begin.run) -- leads from loop to loop

--- Notes where everybody is before a fixed step.
function begin.keepPlaces(b)
  local movers, position, last = b.movers, b.position, b.last
  for n = 1, b.moverCount do
    local k = 2 * movers[n]
    last[k], last[k + 1] = position[k], position[k + 1]
  end
end

return begin
