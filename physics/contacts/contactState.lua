--- Contact state: computes from the places at the end of a step whether a pair is in contact, and
-- on which side.
--
-- `objects/write.lua` calls it only if the contact of a pair does not simply go on. Contacts that
-- begin or end without a listener or a rule are found in a compiled loop. Everything else is
-- interpreted.
--
-- Reads to, position, hit, pressedLow, pressedHigh and others; writes contact, overlapping,
-- wedged, dropping, inside, passing, and notes the events.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".space.aabb")
local rules = require(root .. ".solver.rules")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local events = require(root .. ".contacts.events")
local activePairs = require(root .. ".broadphase.activePairs")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")
local sort = require(root .. ".memory.sort")

local contact = {}

local DYNAMIC = columns.DYNAMIC
local EPSILON, OPPOSITE = columns.EPSILON, columns.OPPOSITE
local floor, max, min = math.floor, math.max, math.min

-- Result of `flushSide` for two bodies that overlap.
local INSIDE = -1

-- Returns 1 for a number >= 0, else 0. (jit: 2)
local function step(v)
  return max(min(floor(v) + 1, 1), 0)
end

-- Returns the side of slot i on which the two are flush at the end of the step, else 0; INSIDE if
-- they overlap. (jit: 2)
local function flushSide(b, i, j)
  local to, size, k, m = b.to, b.size, 2 * i, 2 * j
  local x, y = to[m] - to[k], to[m + 1] - to[k + 1]
  local afterX, beforeX = x - size[k], -x - size[m]
  local afterY, beforeY = y - size[k + 1], -y - size[m + 1]
  local gapX, gapY = max(afterX, beforeX), max(afterY, beforeY)
  local apartX, apartY = step(gapX + EPSILON), step(gapY + EPSILON)
  local flushX, flushY = apartX * step(EPSILON - gapX), apartY * step(EPSILON - gapY)
  return flushX * (1 - apartY) * (1 + step(afterX - beforeX))
    + flushY * (1 - apartX) * (3 + step(afterY - beforeY))
    - (1 - apartX) * (1 - apartY)
end

-- The same of any two.
local function sideOf(b, i, j)
  if b.hasSlopes and slope.isPair(b, i, j) then
    return slope.side(b, i, j)
  elseif b.hasCircles and ball.isRound(b, i, j) then
    return ball.side(b, i, j)
  end
  return flushSide(b, i, j)
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

-- Returns whether two that are flush on a side, and may meet there, are in contact.
local function isHeld(b, p, i, j, side)
  return b.contact[p] == side or b.hit[p] == side or b.sideBySide or isPressed(b, i, j, side)
end

-- Remembers on which axis two that are left overlapping came into each other: they may only
-- separate there.
local function wedge(b, p, i, j)
  if b.deepIn[p] == b.solveStamp then
    b.wedged[p] = b.deepWay[p]
    return
  elseif b.wedged[p] ~= 0 or (b.hasSlopes and slope.isPair(b, i, j)) then
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

-- Returns the side of slot i on which two overlapping bodies would separate by the shortest way.
local function shortestSide(b, i, j)
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

-- Returns the side on which a solid pair is in contact now, else 0.
local function solidContact(b, p, i, j)
  local side = sideOf(b, i, j)
  b.overlapping[p] = side == INSIDE
  if side == INSIDE then
    if b.passing[p] or b.oneWay[i] or b.oneWay[j] then
      b.wedged[p] = 0
      leaveInside(b, i, j)
      return 0
    end
    wedge(b, p, i, j)
    if b.wedged[p] ~= 0 then
      if b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC then
        leaveInside(b, i, j)
      end
      return b.wedged[p]
    end
    leaveInside(b, i, j)
    side = b.contact[p] ~= 0 and b.contact[p] or b.hit[p]
    -- A buried body touches what it is in.
    return side == 0 and (b.buried[i] or b.buried[j]) and shortestSide(b, i, j) or side
  end
  b.wedged[p] = 0
  if side == 0 then
    b.dropping[p] = false
    return 0
  end
  if b.passing[p] or b.dropping[p] or rules.lets(b, i, j, side, false) then
    return 0
  end
  return isHeld(b, p, i, j, side) and side or 0
end

-- Returns the side on which a sensor was entered, while the two overlap, else 0.
local function sensorContact(b, p, i, j)
  if sideOf(b, i, j) ~= INSIDE or b.passing[p] then
    return 0
  end
  if b.contact[p] ~= 0 then
    return b.contact[p]
  elseif b.hit[p] ~= 0 then
    return b.hit[p]
  end
  return shortestSide(b, i, j)
end

-- Returns the side on which solid pair p will be in contact, although it was not hit in this step.
-- (One of the two leans on another body on that side.) Else returns 0.
local function unmetSide(b, p, i, j)
  local side = sideOf(b, i, j)
  if side <= 0 or b.dropping[p] or rules.lets(b, i, j, side, false) then
    return 0
  end
  return isHeld(b, p, i, j, side) and side or 0
end

-- Lists the pairs about which the game must still be asked, in the order of the world. Returns how
-- many there are.
local function listUnasked(b, work)
  local pairs, sides, first, second, order =
    work.pairs, work.sides, work.first, work.second, work.order
  local count = 0
  for n = 1, b.liveCount do
    local p = b.live[n]
    local i, j = b.pairA[p], b.pairB[p]
    local isOpen = b.hit[p] == 0 and not b.passing[p] and b.asked[p] ~= b.solveStamp
    if isOpen and rules.isAsked(b, i, j) then
      local side = (b.sensor[i] or b.sensor[j]) and 0 or unmetSide(b, p, i, j)
      if side ~= 0 then
        local one, other = b.rank[i], b.rank[j]
        count = count + 1
        pairs[count], sides[count], order[count] = p, side, count
        first[count], second[count] = min(one, other), max(one, other)
      end
    end
  end
  sort.by(order, count, first, second, second)
  return count
end

--- Asks the game about pairs that will be in contact without a hit. (An object that stands on two
--- floors is held by one of them.) Writes only `passing`, since the function of the game may fail.
function contact.ask(b)
  if not b.hasAskers then
    return
  end
  local work = b.unasked
  for n = 1, listUnasked(b, work) do
    local at = work.order[n]
    local p, side = work.pairs[at], work.sides[at]
    local i, j, axis = b.pairA[p], b.pairB[p], side > 2 and 1 or 0
    local isFirstLow = side % 2 == 0
    b.passing[p] = not rules.permits(b, isFirstLow and i or j, isFirstLow and j or i, axis)
    activePairs.stain(b, p)
  end
end

-- Returns whether two are in a crowd. They begin no contact: whether they still are a pair depends
-- on when the crowd has begun.
local function areCrowded(b, i, j)
  return min(b.crowd[2 * i], b.crowd[2 * j]) > 0
end

-- Updates whether pair p is in contact now, and notes its events.
local function update(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  local now
  if b.contact[p] == 0 and areCrowded(b, i, j) then
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

-- Returns whether an object or the world has a callback for contacts.
local function hears(listener)
  return listener.onBegin or listener.onEnd or listener.onStay
end

-- Returns whether the places of two bodies decide their contact alone. Both are solid on all sides,
-- did not overlap before, and neither has a callback.
local function isPlain(b, p, i, j)
  return b.plain[i]
    and b.plain[j]
    and b.wedged[p] == 0
    and not (b.oneWay[i] or b.oneWay[j] or b.passing[p] or b.dropping[p] or b.overlapping[p])
    and not areCrowded(b, i, j)
    and not (hears(b.object[i]) or hears(b.object[j]))
end

-- Updates the plain pairs of `list[1..listCount]` (see `isPlain`). Returns how many pairs are left
-- in `list`, and how many are in `touching`.
local function updatePlain(b, list, listCount, touching, count)
  local pairA, pairB, contacts, news, left = b.pairA, b.pairB, b.contact, b.news, 0
  local hit = b.hit
  for n = 1, listCount do
    local p = list[n]
    local i, j, before = pairA[p], pairB[p], contacts[p]
    local side = flushSide(b, i, j)
    if side == INSIDE or not isPlain(b, p, i, j) then
      left = left + 1
      list[left] = p
    else
      local now = side ~= 0 and isHeld(b, p, i, j, side) and side or 0
      if now ~= 0 then
        count = count + 1
        touching[count] = p
      end
      if now ~= before then
        contacts[p], news[i], news[j] = now, true, true
        b.contactCount = b.contactCount + min(now, 1) - min(before, 1)
      elseif now == 0 and hit[p] ~= 0 then
        news[i], news[j] = true, true -- as in `update`: the next bounce may be an event
      end
    end
  end
  return left, count
end

--- Updates the pairs in `list[1..listCount]`, and lists those in contact in `touching`, from place
--- `count` + 1 on. Returns how many are in `touching` then.
function contact.updateAll(b, list, listCount, touching, count)
  if not hears(b.world) then
    listCount, count = updatePlain(b, list, listCount, touching, count)
  end
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
