--- Pressed contacts: notes at the end of a step which sides of bodies are pressed, and the hits of
-- contacts in which two bodies begin to lean on each other.
--
-- Reads contacts, pressed, hit, kind; writes pressedHigh, pressedLow, hit, widest and resolved.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local impact = require(root .. ".solver.impact")

local pressed = {}

local DYNAMIC, EPSILON, WIDTHS = columns.DYNAMIC, columns.EPSILON, columns.WIDTHS
local floor, max, min = math.floor, math.max, math.min

-- Returns the body that leans on the other one in contact c. (What is held from both sides leans on
-- the immovable one of the low side, too.)
local function leaning(b, list, c)
  local isLow = b.kind[(list.low[c] - list.axis) * 0.5] == DYNAMIC
  return isLow and b.heldHigh[list.high[c]] > 0 and list.low[c] or list.high[c]
end

-- Returns whether contact c did not exist in the last step, was not hit in this one, and is flush.
local function isNew(b, list, c)
  local p = list.pair[c]
  local over = b.to[list.low[c]] + list.separation[c] - b.to[list.high[c]]
  return b.hit[p] == 0 and b.contact[p] == 0 and over <= EPSILON and over >= -EPSILON
end

-- Returns the length of the common edge of contact c, in parts of a px, and a rank that decides
-- between equal edges.
local function edgeOf(b, list, c)
  local k, m = list.low[c] + 1 - 2 * list.axis, list.high[c] + 1 - 2 * list.axis
  local edge = min(b.from[k] + b.size[k], b.from[m] + b.size[m]) - max(b.from[k], b.from[m])
  local i, j = (k - 1 + list.axis) * 0.5, (m - 1 + list.axis) * 0.5
  return floor(edge * WIDTHS + 0.5), b.rank[i] + b.rank[j]
end

-- Finds for each body the new contact with the widest common edge among those that it leans on. If
-- several begin at once, only that one counts as hit.
local function findWidest(b, list)
  local widest, awake = b.widest, b.awakeList
  for n = 1, b.awakeCount do
    widest[2 * awake[n] + list.axis] = 0
  end
  for c = 1, list.count do
    if isNew(b, list, c) then
      local k = leaning(b, list, c)
      local best = widest[k]
      local edge, rank = edgeOf(b, list, c)
      local most, first = 0, 0
      if best ~= 0 then
        most, first = edgeOf(b, list, best)
      end
      if best == 0 or edge > most or (edge == most and rank < first) then
        widest[k] = c
      end
    end
  end
end

-- Notes the hit of each contact in which two bodies begin to lean on each other.
local function noteNewHits(b, list)
  findWidest(b, list)
  for c = 1, list.count do
    local p = list.pair[c]
    if b.pressed[p] == 1 and b.hit[p] == 0 and b.contact[p] == 0 then
      local hit = isNew(b, list, c) and b.widest[leaning(b, list, c)] or c
      local kl, kh = list.low[hit], list.high[hit]
      local low, axis = (kl - list.axis) * 0.5, list.axis
      impact.note(b, list.pair[hit], low, axis, max(b.start[kl] - b.start[kh], 0.0), 0)
    end
  end
end

--- Notes the sides on which bodies lean on each other, and the hits of contacts that begin so.
function pressed.note(b, axis)
  local list, isPressed = b.contacts[axis], b.pressed
  local pressedHigh, pressedLow, hasNew = b.pressedHigh, b.pressedLow, false
  for c = 1, list.count do
    local p = list.pair[c]
    if isPressed[p] == 1 then
      pressedHigh[list.low[c]], pressedLow[list.high[c]] = true, true
      if b.hit[p] == 0 then
        b.resolved = b.resolved + 1
        hasNew = hasNew or b.contact[p] == 0
      end
    end
  end
  if hasNew then
    noteNewHits(b, list)
  end
end

--- Forgets which contacts were pressed, before contacts are settled.
function pressed.forget(b)
  for axis = 0, 1 do
    local list = b.contacts[axis]
    for c = 1, list.count do
      b.pressed[list.pair[c]] = 0
    end
  end
end

return pressed
