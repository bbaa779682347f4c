---@diagnostic disable
--- Contact state: computes from the places at the end of a step whether a pair is in contact, and
-- on which side.
--
-- `objects/write.lua` calls it only if the contact of a pair does not simply go on.
--
-- Reads to, position, hit, pressedLow, pressedHigh and others; writes contact, overlapping,
-- wedged, dropping, inside, passing, and notes the events.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local rules = require(root .. ".solver.rules")
local columns = require(root .. ".memory.columns")
local crowd = require(root .. ".solver.crowd")
local events = require(root .. ".contacts.events")
local pairFinder = require(root .. ".broadphase.pairFinder")
local shapes = require(root .. ".space.shapes")
local touch = require(root .. ".solver.touch")
local sort = require(root .. ".memory.sort")

local contactState = {}

local DYNAMIC = columns.DYNAMIC
local EPSILON, OPPOSITE, INSIDE = columns.EPSILON, columns.OPPOSITE, columns.INSIDE
local max, min = math.max, math.min

-- Returns the side of slot i on which two are flush at the end of the step, else 0; INSIDE if they
-- overlap.
local function sideOf(b, i, j)
  return b.hasShapes and touch.side(b, i, j) or columns.flushSide(b, i, j)
end

-- Returns whether something leans on that side of slot i, or on the opposite side of slot j, in
-- this step.
local function isPressed(b, i, j, side)
  local axis = side > 2 and 1 or 0
  local ki, kj = 2 * i + axis, 2 * j + axis
  local iDynamic, jDynamic = b.kind[i] == DYNAMIC, b.kind[j] == DYNAMIC
  if side % 2 == 0 then
    return iDynamic and b.pressedHigh[ki] or jDynamic and b.pressedLow[kj]
  end
  return iDynamic and b.pressedLow[ki] or jDynamic and b.pressedHigh[kj]
end

-- Remembers on which axis two that are left overlapping came into each other: they may only
-- separate there.
local function wedge(b, p, i, j)
  if b.deepIn[p] == b.solveStamp then
    b.wedged[p] = b.deepWay[p]
    return
  elseif b.wedged[p] ~= 0 or (b.hasShapes and touch.haveFaces(b, i, j)) then
    return
  end
  local position, size = b.position, b.size
  for axis = 0, 1 do
    local ki, kj = 2 * i + axis, 2 * j + axis
    local r = position[kj] - position[ki]
    if r - size[ki] >= -EPSILON or -r - size[kj] >= -EPSILON then
      b.wedged[p] = 2 * axis + (r < 0 and 1 or 2)
      return
    end
  end
end

-- Notes that the dynamic ones of two overlapping bodies must be separated (see
-- solver/overlap.lua).
local function leaveInside(b, i, j)
  b.inside[i], b.inside[j] = b.kind[i] == DYNAMIC, b.kind[j] == DYNAMIC
  b.hasInside = true
end

-- Returns the side of the first body of pair p on which two that overlap would separate by the
-- shortest way.
local function shortestSide(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  local isSwapped = b.rank[j] < b.rank[i] -- a tie is decided by the order of the world
  if isSwapped then
    i, j = b.pairB[p], b.pairA[p]
  end
  local to, size, k, m = b.to, b.size, 2 * i, 2 * j
  local x, y, width, height = to[k], to[k + 1], size[k], size[k + 1]
  local itsX, itsY, itsWidth, itsHeight = to[m], to[m + 1], size[m], size[m + 1]
  local name = shapes.side(x, y, width, height, itsX, itsY, itsWidth, itsHeight)
  local side = columns.SIDE[name]
  return isSwapped and OPPOSITE[side] or side
end

-- Returns the side on which a solid pair that overlaps is in contact now, else 0.
local function deepContact(b, p, i, j)
  if b.passing[p] or b.oneWay[i] or b.oneWay[j] then
    b.wedged[p] = 0
    leaveInside(b, i, j)
    return 0
  end
  wedge(b, p, i, j)
  local isWedged = b.wedged[p] ~= 0
  if not isWedged or (b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC) then
    leaveInside(b, i, j)
  end
  local side = isWedged and b.wedged[p] or b.contact[p] ~= 0 and b.contact[p] or b.hit[p]
  -- A buried body touches what it is in.
  return side == 0 and (b.buried[i] or b.buried[j]) and shortestSide(b, p) or side
end

-- Returns the side on which a solid pair that does not overlap is in contact now, else 0.
local function flushContact(b, p, i, j, side)
  if side <= 0 or b.passing[p] or b.dropping[p] or rules.lets(b, i, j, side, false) then
    return 0
  end
  local isHeld = b.contact[p] == side or b.hit[p] == side or b.sideBySide
  return (isHeld or isPressed(b, i, j, side)) and side or 0
end

-- Returns the side on which a solid pair is in contact now, else 0.
local function solidContact(b, p, i, j)
  local side = sideOf(b, i, j)
  b.overlapping[p] = side == INSIDE
  if side == INSIDE then
    return deepContact(b, p, i, j)
  end
  b.wedged[p], b.dropping[p] = 0, b.dropping[p] and side ~= 0
  return flushContact(b, p, i, j, side)
end

-- Returns the side on which a sensor was entered, while the two overlap, else 0.
local function sensorContact(b, p, i, j)
  if sideOf(b, i, j) ~= INSIDE or b.passing[p] then
    return 0
  end
  local side = b.contact[p] ~= 0 and b.contact[p] or b.hit[p]
  return side ~= 0 and side or shortestSide(b, p)
end

-- Lists in `work.list` the pairs about which the game must still be asked, in the order of the
-- world. Returns how many there are.
local function listUnasked(b, work)
  local list, first, second, count = work.list, b.firstRank, b.secondRank, 0
  for n = 1, b.liveCount do
    local p = b.live[n]
    local i, j = b.pairA[p], b.pairB[p]
    local isOpen = b.hit[p] == 0 and not b.passing[p] and b.asked[p] ~= b.solveStamp
    if isOpen and not (b.sensor[i] or b.sensor[j]) and rules.isAsked(b, i, j) then
      work.side[p] = flushContact(b, p, i, j, sideOf(b, i, j))
      first[p], second[p] = min(b.rank[i], b.rank[j]), max(b.rank[i], b.rank[j])
      if work.side[p] ~= 0 then
        count = count + 1
        list[count] = p
      end
    end
  end
  sort.by(list, count, first, second, second)
  return count
end

--- Asks the game about pairs that will be in contact without a hit. (An object that stands on two
--- floors is held by one of them.) Writes only `passing`, since the function of the game may fail.
function contactState.ask(b)
  local work = b.unasked
  for n = 1, listUnasked(b, work) do
    local p = work.list[n]
    local i, j, side = b.pairA[p], b.pairB[p], work.side[p]
    local isFirstLow = side % 2 == 0
    local low, high = isFirstLow and i or j, isFirstLow and j or i
    b.passing[p] = not rules.permits(b, low, high, side > 2 and 1 or 0)
    pairFinder.stain(b, p)
  end
end

-- Returns whether slot i has stayed in its place, whatever met it.
local function isStill(b, i)
  return b.kind[i] == columns.STATIC or b.stillAt[i] == b.solveStamp
end

--- Updates whether pair p is in contact now, and notes its events.
function contactState.update(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  local now
  if b.contact[p] == 0 and b.hasCrowds and crowd.isGhost(b, i, j) then
    -- Two in a crowd begin none: whether they still are a pair depends on when it has begun.
    return
  elseif b.sensor[i] or b.sensor[j] then
    now = sensorContact(b, p, i, j)
  else
    now = solidContact(b, p, i, j)
  end
  local before = b.contact[p]
  if now == before then
    if now ~= 0 then
      events.stay(b, p, now)
    elseif isStill(b, i) and isStill(b, j) then
      b.hit[p] = 0 -- what was put back has met nothing: it may sleep
    elseif b.hit[p] ~= 0 then
      events.bounce(b, p, b.hit[p], b.hitSpeed[p])
      b.news[i], b.news[j] = true, true -- each bounce is an event, so they must not sleep
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

return contactState
