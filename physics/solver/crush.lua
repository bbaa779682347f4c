--- Crushing: notes from the settled contacts which bodies are pressed between two that cannot give
-- way, on one axis.
--
-- A crushed body stays where it overlaps its neighbours the least (see settle.lua), and is free
-- again as soon as there is room. How it came there is remembered with the pair (`wedged`). So it
-- leaves along the same axis and is never squeezed out sideways.
--
-- Reads contacts, squeezed, pressed; writes crushed, crushLow, crushHigh, wedged.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local events = require(root .. ".contacts.events")

local crush = {}

local DYNAMIC, EPSILON = columns.DYNAMIC, columns.EPSILON
local SLOPE = columns.SHAPE_SLOPE_LEFT -- and above
local max = math.max

-- Returns the gap between slot i, as it was before it grew, and slot j on an axis, px. Returns also
-- whether j is the low one.
local function gapBefore(b, i, j, axis)
  local k, m = 2 * i + axis, 2 * j + axis
  local r = b.from[m] - b.wasAt[k]
  local after, before = r - b.wasSize[k], -r - b.size[m]
  return max(after, before), before > after
end

local function isInside(b, i, j)
  local from, size, k, m = b.from, b.size, 2 * i, 2 * j
  local x, y = from[m] - from[k], from[m + 1] - from[k + 1]
  return max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1]) < -EPSILON
end

-- Marks slot i as wedged into the immovable slot j, if it has grown into that along one axis.
local function wedge(b, p, i, j)
  local isSolid = not (b.sensor[i] or b.sensor[j] or b.oneWay[i] or b.oneWay[j])
  isSolid = isSolid and b.shape[j] < SLOPE -- that is left over its edge
  if b.kind[j] == DYNAMIC or not isSolid or b.wedged[p] ~= 0 or not isInside(b, i, j) then
    return
  end
  local gapX, isLowX = gapBefore(b, i, j, 0)
  local gapY, isLowY = gapBefore(b, i, j, 1)
  if (gapX >= -EPSILON) == (gapY >= -EPSILON) then
    return -- it overlapped before, or was beyond the corner
  end
  local axis, isLow = 0, isLowX
  if gapY >= -EPSILON then
    axis, isLow = 1, isLowY
  end
  local isOfFirst = b.pairA[p] == i
  b.wedged[p] = 2 * axis + (isLow == isOfFirst and 1 or 2)
end

-- Returns whether slot i still overlaps the place where it was, so that it was not also put
-- elsewhere.
local function isThere(b, i)
  for k = 2 * i, 2 * i + 1 do
    local r = b.wasAt[k] - b.from[k]
    if max(r - b.size[k], -r - b.wasSize[k]) >= -EPSILON then
      return false
    end
  end
  return true
end

--- Marks what the game has made larger than its room. It leaves walls the way it came in, and not
--- by the shortest way, which would lead through thin walls.
function crush.wedgeGrown(b)
  for n = 1, b.movedCount do
    local i = b.movedList[n]
    if b.grown[i] then
      local half = isThere(b, i) and b.head[i] or 0
      while half ~= 0 do
        wedge(b, (half + half % 2) / 2, i, b.other[half])
        half = b.next[half]
      end
      b.grown[i] = false
      for k = 2 * i, 2 * i + 1 do
        b.wasAt[k], b.wasSize[k] = 0, 0
      end
    end
  end
end

--- Notes which bodies are squeezed along an axis, and between which two.
function crush.note(b, axis)
  local list, squeezed, crushed = b.contacts[axis], b.squeezed, b.crushed
  local crushLow, crushHigh = b.crushLow, b.crushHigh
  for c = 1, list.count do
    local kl, kh = list.low[c], list.high[c]
    if squeezed[kl] ~= 0 and b.pressed[list.pair[c]] == 1 then
      crushHigh[kl] = (kh - axis) * 0.5
    end
    if squeezed[kh] ~= 0 and b.pressed[list.pair[c]] == 1 then
      crushLow[kh] = (kl - axis) * 0.5
    end
  end
  for n = 1, b.awakeCount do
    local k = 2 * b.awakeList[n] + axis
    if squeezed[k] ~= 0 then
      crushed[k], b.hasCrushed = true, true
    end
  end
end

--- Notes the event of an object that begins to be crushed in this step.
function crush.tell(b, i)
  for axis = 0, 1 do
    local k = 2 * i + axis
    if b.crushed[k] and not b.wasCrushed[k] then
      events.crush(b, i, b.crushLow[k], b.crushHigh[k], axis == 0 and "x" or "y")
    end
    b.wasCrushed[k] = b.crushed[k]
  end
end

return crush
