---@diagnostic disable
--- Contact state: computes from the places at the end of a step whether a pair is in contact, and
-- on which side.
--
-- Two that are flush are in contact on that side if they were, if they were hit there in this step,
-- if something leans on the side (`isPressed`), or with the setting `sideBySide`. What has changed
-- is an event: another side ends a contact and begins one; a hit without a contact is a bounce.
-- Each event keeps both bodies awake. (The hit of two that were put back is forgotten: they may
-- sleep.)
--
-- `objects/write.lua` calls it only if the contact of a pair does not simply go on.
--
-- Reads to, position, hit, pressedAt, passing and others; writes contact, wedged (the side on which
-- two that overlap part), dropping, inside, hit, mustStayAwake, contactCount, and notes the events.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".narrowphase.ball")
local boxes = require(root .. ".space.boxes")
local constants = require(root .. ".memory.constants")
local crowd = require(root .. ".overlaps.crowd")
local events = require(root .. ".contacts.events")
local rules = require(root .. ".narrowphase.rules")
local touch = require(root .. ".narrowphase.touch")

local contactState = {}

local DYNAMIC = constants.DYNAMIC
local EPSILON, OPPOSITE, INSIDE = constants.EPSILON, constants.OPPOSITE, boxes.INSIDE

-- Returns the side of slot i on which it and slot j are flush at the end of the step, else 0;
-- INSIDE if they overlap.
local function sideOf(b, p, i, j)
  return b.hasShapes and touch.side(b, p, i, j) or boxes.flushSide(b, b.to, i, j)
end

-- Returns whether something leans on that side of slot i, or on the opposite side of slot j, in
-- this step.
local function isPressed(b, i, j, side)
  local pressedAt, stamp = b.pressedAt, b.solveStamp
  return b.kind[i] == DYNAMIC and pressedAt[4 * i + side] == stamp
    or b.kind[j] == DYNAMIC and pressedAt[4 * j + OPPOSITE[side]] == stamp
end

-- Remembers on which side two bodies that are left overlapping came into each other (0: they were
-- apart on none): they may only part there.
local function wedge(b, p, i, j)
  local position, side = b.position, 0
  local areDynamic = b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC
  if b.hasShapes and touch.haveFaces(b, i, j) then
    local box, ramp = touch.order(b, i, j)
    side = touch.sideBefore(b, box, ramp, position, b.size, position)
    side = box == i and side or OPPOSITE[side]
  elseif b.hasRound and not areDynamic and ball.isRolling(b, position, i, j) then
    side = ball.side(b, position, i, j)
  else
    for axis = 1, 0, -1 do -- (x counts first)
      local k, m = 2 * i + axis, 2 * j + axis
      local r = position[m] - position[k]
      local isApart = r - b.size[k] >= -EPSILON or -r - b.size[m] >= -EPSILON
      side = isApart and 2 * axis + (r < 0 and 1 or 2) or side
    end
  end
  b.wedged[p] = side
end

-- Notes that two overlapping bodies must be parted, if they are dynamic (see overlaps/overlap.lua).
local function leaveInside(b, i, j)
  b.inside[i], b.inside[j] = b.kind[i] == DYNAMIC, b.kind[j] == DYNAMIC
  b.hasOverlaps = true
end

-- Returns the side on which a solid pair that overlaps is in contact now, else 0.
local function deepContact(b, p, i, j)
  if b.passing[p] or b.oneWay[i] or b.oneWay[j] then
    b.wedged[p] = 0
    leaveInside(b, i, j)
    return 0
  end
  if b.wedged[p] == 0 then
    wedge(b, p, i, j)
  end
  local isWedged = b.wedged[p] ~= 0
  local areLeft = not isWedged or b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC
  if areLeft and not (b.hasRound and ball.isRolling(b, b.to, i, j)) then
    leaveInside(b, i, j)
  end
  local side = isWedged and b.wedged[p] or b.contact[p] ~= 0 and b.contact[p] or b.hit[p]
  -- A buried body touches the object that it is in.
  return side == 0 and (b.buried[i] or b.buried[j]) and ball.side(b, b.to, i, j) or side
end

-- Returns the side on which a solid pair is in contact now, else 0. A pair about which the game
-- must be asked is in contact once it was asked: in the next step, if there was no hit.
local function solidContact(b, p, i, j)
  local side = sideOf(b, p, i, j)
  if side == INSIDE then
    return deepContact(b, p, i, j)
  end
  b.wedged[p], b.dropping[p] = 0, b.dropping[p] and side ~= 0
  local isOpen = b.hasRules and b.asked[p] ~= b.solveStamp and rules.isAsked(b, i, j)
  local passes = side == 0 or b.passing[p] or b.dropping[p]
  if isOpen or passes or rules.lets(b, i, j, side, false) then
    return 0
  end
  local isHeld = b.contact[p] == side or b.hit[p] == side or b.sideBySide
  return (isHeld or isPressed(b, i, j, side)) and side or 0
end

-- Returns the side on which a sensor was entered, while a body is in it, else 0.
local function sensorContact(b, p, i, j)
  if sideOf(b, p, i, j) ~= INSIDE or b.passing[p] then
    return 0
  end
  local side = b.contact[p] ~= 0 and b.contact[p] or b.hit[p]
  return side ~= 0 and side or (ball.side(b, b.to, i, j))
end

-- Returns whether slot i has stayed in its place, whatever met it.
local function isStill(b, i)
  return b.kind[i] == constants.STATIC or b.stillAt[i] == b.solveStamp
end

--- Updates whether pair p is in contact now, and notes its events.
function contactState.update(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  local before, isSensed = b.contact[p], b.sensor[i] or b.sensor[j]
  -- Members of a crowd never begin a contact: whether two are still a pair depends on when the
  -- crowd formed.
  if before == 0 and b.hasOverlaps and crowd.isGhost(b, i, j) then
    return
  end
  local now = isSensed and sensorContact(b, p, i, j) or solidContact(b, p, i, j)
  if now == before then
    if now ~= 0 then
      events.stay(b, p, now)
    elseif isStill(b, i) and isStill(b, j) then
      b.hit[p] = 0 -- a body that was put back has met nothing: it may sleep
    elseif b.hit[p] ~= 0 then
      events.bounce(b, p, b.hit[p], b.hitSpeed[p])
      b.mustStayAwake[i], b.mustStayAwake[j] = true, true -- each bounce is an event
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
  b.mustStayAwake[i], b.mustStayAwake[j] = true, true
end

return contactState
