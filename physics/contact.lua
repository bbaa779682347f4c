--- Step 7, publish: whether a pair is in contact at the end of a step, and on which side.
--
-- Reads to, position, hit, pressed...; writes contact, overlapping, wedged, dropping, inside, and
-- notes the events. `publish` asks it only for pairs of which the answer is not plain to see.

local here = (...):match("^(.*)%.[^.]+$")
local aabb = require(here .. ".aabb")
local approach = require(here .. ".approach")
local columns = require(here .. ".columns")
local events = require(here .. ".events")
local oneway = require(here .. ".oneway")

require(here .. ".interpreted").file()

local contact = {}

local DYNAMIC = columns.DYNAMIC
local EPSILON, OPPOSITE = columns.EPSILON, columns.OPPOSITE

-- Gap on an axis at the end of the step (negative: overlap) and whether the first is the low one.
local function gapAtEnd(b, ka, kc)
  local r = b.to[kc] - b.to[ka]
  local after, before = r - b.size[ka], -r - b.size[kc]
  if after >= before then
    return after, true
  end
  return before, false
end

-- The side of the pair's first at which the two are flush, else 0; and whether they overlap.
local function flushSide(b, i, j)
  local gapX, lowX = gapAtEnd(b, 2 * i, 2 * j)
  if gapX > EPSILON then
    return 0, false
  end
  local gapY, lowY = gapAtEnd(b, 2 * i + 1, 2 * j + 1)
  if gapY > EPSILON then
    return 0, false
  end
  if gapX >= -EPSILON then
    if gapY >= -EPSILON then
      return 0, false -- corner to corner
    end
    return lowX and 2 or 1, false
  elseif gapY >= -EPSILON then
    return lowY and 4 or 3, false
  end
  return 0, true
end

-- Whether a side was leant on in this step, by either of the two.
local function isPressed(b, i, j, side)
  local axis = side > 2 and 1 or 0
  local ki, kj = 2 * i + axis, 2 * j + axis
  local iDynamic, jDynamic = b.kind[i] == DYNAMIC, b.kind[j] == DYNAMIC
  if side % 2 == 0 then
    return iDynamic and b.pressedHigh[ki] or jDynamic and b.pressedLow[kj]
  end
  return iDynamic and b.pressedLow[ki] or jDynamic and b.pressedHigh[kj]
end

-- Remembers how two that are left inside each other came there: they may only part that way.
local function wedge(b, p, i, j)
  if b.wedged[p] ~= 0 then
    return
  end
  local position, size = b.position, b.size
  for axis = 0, 1 do
    local ki, kj = 2 * i + axis, 2 * j + axis
    local r = position[kj] - position[ki]
    if r - size[ki] >= -EPSILON or -r - size[kj] >= -EPSILON then
      b.wedged[p] = 1 + approach.code(approach.DEEP, axis, r < 0)
      return
    end
  end
end

local function wedgedSide(b, p)
  local _, axis, otherIsLow = approach.decode(b.wedged[p] - 1)
  return 2 * axis + (otherIsLow and 1 or 2)
end

-- Who is dynamic will try to get out (see `part`).
local function leaveInside(b, i, j)
  b.inside[i], b.inside[j] = b.kind[i] == DYNAMIC, b.kind[j] == DYNAMIC
end

-- The side on which a solid pair is in contact now, else 0.
local function solidContact(b, p, i, j)
  local side, overlap = flushSide(b, i, j)
  b.overlapping[p] = overlap
  if overlap then
    if b.passing[p] or b.oneWay[i] or b.oneWay[j] then
      b.wedged[p] = 0
      leaveInside(b, i, j)
      return 0
    end
    wedge(b, p, i, j)
    if b.wedged[p] == 0 then
      leaveInside(b, i, j)
    end
    return b.wedged[p] ~= 0 and wedgedSide(b, p) or 0
  end
  b.wedged[p] = 0
  if side == 0 then
    b.dropping[p] = false
    return 0
  end
  if b.passing[p] or b.dropping[p] or oneway.lets(b, i, j, side, approach.FACE) then
    return 0
  end
  if b.contact[p] == side or b.hit[p] == side or b.sideBySide or isPressed(b, i, j, side) then
    return side
  end
  return 0
end

-- The side on which a sensor was entered, while the two overlap, else 0.
local function sensorContact(b, p, i, j)
  local _, overlap = flushSide(b, i, j)
  if not overlap or b.passing[p] then
    return 0
  end
  if b.contact[p] ~= 0 then
    return b.contact[p]
  elseif b.hit[p] ~= 0 then
    return b.hit[p]
  end
  -- A tie is decided by the order of the world.
  local isSwapped = b.rank[j] < b.rank[i]
  if isSwapped then
    local first = j
    j = i
    i = first
  end
  local to, size, ki, kj = b.to, b.size, 2 * i, 2 * j
  local side = columns.SIDE[aabb.side(
    to[ki],
    to[ki + 1],
    size[ki],
    size[ki + 1],
    to[kj],
    to[kj + 1],
    size[kj],
    size[kj + 1]
  )]
  return isSwapped and OPPOSITE[side] or side
end

-- Finds out whether pair p is in contact now, and notes what there is to tell of that.
local function update(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  local now
  if b.sensor[i] or b.sensor[j] then
    now = sensorContact(b, p, i, j)
  else
    now = solidContact(b, p, i, j)
  end
  local before = b.contact[p]
  if now == before then
    if now ~= 0 then
      events.stay(b, p, now)
    elseif b.hit[p] ~= 0 then
      events.bounce(b, p, b.hit[p], b.hitSpeed[p])
    end
    return
  end
  if before ~= 0 then
    events.finish(b, p, before)
    b.contactCount = b.contactCount - 1
  end
  if now ~= 0 then
    events.begin(b, p, now, b.hit[p] ~= 0 and b.hitSpeed[p] or 0)
    b.contactCount = b.contactCount + 1
  end
  b.contact[p] = now
  b.news[i], b.news[j] = true, true
end

--- Updates the pairs in `list[1..listCount]`, and lists those in contact behind place `count` of
--- `touching`; returns how many these are then.
function contact.updateAll(b, list, listCount, touching, count)
  for n = 1, listCount do
    local p = list[n]
    update(b, p)
    if b.contact[p] ~= 0 then
      count = count + 1
      touching[count] = p
    end
  end
  return count
end

return contact
