--- Contacts: computes from the places at the start of the step which pairs touch, as one sorted
-- list for each axis, and adds those that arise in it.
--
-- A contact has one axis. `low` is the body with the smaller coordinate on it, `high` the other
-- one. The axis is the one on which the two are apart. The list is sorted by the coordinate of
-- `high`, so that one walk goes from each body to those behind it. The order does not depend on
-- the order in which pairs were found.
--
-- Reads from, size, restitution; writes the lists `b.contacts[axis]`, `b.apart`, `b.roundPairs`,
-- touches, contactLow, contactHigh, contactKey, separation, deepIn, deepWay, deepAt, limitedAt.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local contactOrder = require(root .. ".solver.contactOrder")
local heapPairs = require(root .. ".solver.heapPairs")
local interpreted = require(root .. ".memory.jit")
local knots = require(root .. ".solver.knots")
local rules = require(root .. ".solver.rules")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")

local contacts = {}

local EPSILON, DYNAMIC, CIRCLE = columns.EPSILON, columns.DYNAMIC, columns.SHAPE_CIRCLE
--- Share of the smaller size by which two overlapping dynamic bodies separate in a step.
contacts.PACE = 0.25
local PACE = contacts.PACE
local PATIENCE = knots.PATIENCE
local floor, max, min = math.floor, math.max, math.min

--- Values of `touches`:
---
--- - APART: the pair is swept.
--- - CONTACT: it is a contact.
--- - ELASTIC: it is a contact that is swept, too: it may bounce, or one of the two is a circle.
--- - HEAP: the two are left to the heap (see heapPairs).
--- - GHOST: both bodies are in a crowd, or one leaves a knot; the pair does nothing.
contacts.APART, contacts.CONTACT, contacts.ELASTIC, contacts.GHOST = 0, 1, 2, 3
local APART, CONTACT = contacts.APART, contacts.CONTACT
local ELASTIC, GHOST = contacts.ELASTIC, contacts.GHOST

--- Returns an empty list of contacts.
function contacts.newList(axis)
  return {
    axis = axis,
    isNew = false, -- contacts were added since it was sorted, or have changed
    count = 0,
    order = {}, -- pairs, sorted
    recalled = 0, -- number of those that stood in `order` when it was last sorted
    pair = {}, -- by contact: its pair
    low = {}, -- index of the low body on the axis
    high = {}, -- index of the high body
    separation = {}, -- minimum px from the low edge of `low` to that of `high`
    elastic = {}, -- 1: the contact may bounce
    bearing = {}, -- which body leans on the other (see friction.lua)
    width = {}, -- px of the common edge
    load = {}, -- normal impulse in this step, impacts included
    weight = {}, -- the part of the load that is no impact
  }
end

-- Splits the live pairs: those within reach at the start go to `b.closePairs`, the others to
-- `b.apart`. Returns the number of close pairs.
local function listClose(b)
  local live, close, apart, touches = b.live, b.closePairs, b.apart, b.touches
  local pairA, pairB, from, size = b.pairA, b.pairB, b.from, b.size
  local closeCount, apartCount = 0, 0
  for n = 1, b.liveCount do
    local p = live[n]
    local k, m = 2 * pairA[p], 2 * pairB[p]
    local x, y = from[m] - from[k], from[m + 1] - from[k + 1]
    local gap = max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1])
    touches[p] = APART
    if gap <= EPSILON then
      closeCount = closeCount + 1
      close[closeCount] = p
    else
      apartCount = apartCount + 1
      apart[apartCount] = p
    end
  end
  b.apartCount, b.seenCount = apartCount, b.liveCount
  return closeCount
end

-- Adds the pair to those that are swept.
local function leaveApart(b, p)
  b.apartCount = b.apartCount + 1
  b.apart[b.apartCount] = p
end

-- Moves pairs with a sensor from the close pairs to those that are only swept. Returns the number
-- of pairs that are left.
local function dropSensors(b, count)
  local close, pairA, pairB, sensor, kept = b.closePairs, b.pairA, b.pairB, b.sensor, 0
  for n = 1, count do
    local p = close[n]
    if sensor[pairA[p]] or sensor[pairB[p]] then
      leaveApart(b, p)
    else
      kept = kept + 1
      close[kept] = p
    end
  end
  return kept
end

-- Moves pairs with a circle from the close ones to b.roundPairs. Returns how many are left.
local function takeRound(b, count)
  local close, round, pairA, pairB, shape = b.closePairs, b.roundPairs, b.pairA, b.pairB, b.shape
  local kept, roundCount = 0, 0
  for n = 1, count do
    local p = close[n]
    if shape[pairA[p]] == CIRCLE or shape[pairB[p]] == CIRCLE then
      roundCount = roundCount + 1
      round[roundCount] = p
    else
      kept = kept + 1
      close[kept] = p
    end
  end
  b.roundCount = roundCount
  return kept
end

-- Whether slots i and j pass through each other: both are in a crowd, or one leaves a knot.
local function isGhost(b, i, j)
  return min(b.crowd[i], b.crowd[j]) > 0
    or (b.exiting[i] and b.kind[j] == DYNAMIC)
    or (b.exiting[j] and b.kind[i] == DYNAMIC)
end

-- Removes from a list the pairs that pass through each other. Returns the number that is left.
local function dropGhosts(b, list, count)
  local pairA, pairB, kept = b.pairA, b.pairB, 0
  for n = 1, count do
    local p = list[n]
    if isGhost(b, pairA[p], pairB[p]) then
      b.touches[p] = GHOST
    else
      kept = kept + 1
      list[kept] = p
    end
  end
  return kept
end

-- Makes a contact of a pair. The list of its axis is sorted later.
local function put(b, p, axis, kl, kh, separation)
  local list = b.contacts[axis]
  local n = list.count + 1
  list.count = n
  list.pair[n] = p
  b.touches[p] = CONTACT
  b.contactLow[p], b.contactHigh[p], b.separation[p] = kl, kh, separation
  b.contactKey[p] = b.from[kh]
end

-- Returns the axis on which two overlapping bodies separate, and whether the second of the pair is
-- the low one. The axis is that along which they came into each other (`wedged`), else the one with
-- the smaller overlap.
local function deepAxis(b, p, ki, kj)
  if b.wedged[p] ~= 0 then
    return columns.AXIS[b.wedged[p]], b.wedged[p] % 2 == 1
  end
  local from, size = b.from, b.size
  local x, y = from[kj] - from[ki], from[kj + 1] - from[ki + 1]
  local gapX, gapY = max(x - size[ki], -x - size[kj]), max(y - size[ki + 1], -y - size[kj + 1])
  local axis = gapY >= gapX and 1 or 0
  local middle = (axis == 0 and x or y) + (size[kj + axis] - size[ki + axis]) * 0.5
  return axis, middle < 0 or (middle == 0 and b.rank[kj * 0.5] < b.rank[ki * 0.5])
end

-- Returns how much further apart two overlapping dynamic bodies must be at the end of the step than
-- at its start, px. It shrinks while there is no room.
local function growthOf(b, kl, kh)
  local i, j = floor(kl * 0.5), floor(kh * 0.5)
  local waited = max(b.knotted[2 * i], b.knotted[2 * j], 0)
  return PACE * min(b.size[kl], b.size[kh]) * (1 - waited / PATIENCE)
end

-- Returns the low and the high body of two that overlap, the axis on which they part, and how far
-- apart their low edges must be at the end of the step: two dynamic bodies part by `growthOf`, a
-- circle and a wall by PACE, a wedged body and a wall as far as there is room. Others stay as deep
-- as they are.
local function deepSeparation(b, p, i, j, isRound)
  local from, axis, isSecondLow = b.from, nil, false
  if isRound and b.wedged[p] == 0 then
    axis, isSecondLow = ball.deepAxis(b, i, j)
  end
  if not axis then
    axis, isSecondLow = deepAxis(b, p, 2 * i, 2 * j)
  end
  local low, high = isSecondLow and j or i, isSecondLow and i or j
  local kl, kh = 2 * low + axis, 2 * high + axis
  local separation = isRound and ball.separation(b, low, high, axis) or b.size[kl]
  if b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC then
    -- These are valid for this solve only, since the step may be started again.
    b.deepIn[p], b.deepWay[p] = b.solveStamp, isSecondLow and 2 * axis + 1 or 2 * axis + 2
    b.deepAt[i], b.deepAt[j] = b.solveStamp, b.solveStamp
    separation = min(separation, from[kh] - from[kl] + growthOf(b, kl, kh))
  elseif isRound then
    separation = min(separation, from[kh] - from[kl] + PACE * min(b.size[kl], b.size[kh]))
  elseif b.wedged[p] == 0 then
    separation = from[kh] - from[kl]
  end
  return kl, kh, axis, separation
end

-- Makes a contact of two overlapping bodies. Two that were squeezed into each other (`wedged`)
-- separate as soon as there is room.
local function putDeep(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  if b.oneWay[i] or b.oneWay[j] then
    leaveApart(b, p)
    return
  end
  local isRound = b.hasCircles and ball.isRound(b, i, j)
  local kl, kh, axis, separation = deepSeparation(b, p, i, j, isRound)
  if rules.passes(b, p, kl, kh, axis, true) then
    leaveApart(b, p)
    return
  end
  put(b, p, axis, kl, kh, separation)
  b.limitedAt[i], b.limitedAt[j] = b.solveStamp, b.solveStamp
  if isRound then
    b.touches[p] = ELASTIC
    leaveApart(b, p)
  end
end

-- Takes the pairs with a slope out of the close ones, and makes contacts of those that touch.
-- Returns how many are left.
local function putSlopes(b, count)
  local close, kept = b.closePairs, 0
  for n = 1, count do
    local p = close[n]
    if slope.isPair(b, b.pairA[p], b.pairB[p]) then
      local axis, kl, kh, separation = slope.contact(b, p)
      if axis then
        put(b, p, axis, kl, kh, separation)
      else
        leaveApart(b, p)
      end
    else
      kept = kept + 1
      close[kept] = p
    end
  end
  return kept
end

-- Decides for each close pair on which axis it touches.
local function classify(b, count)
  local close, pairA, pairB, from, size = b.closePairs, b.pairA, b.pairB, b.from, b.size
  local overlaps, overlapCount = b.overlaps, 0
  for n = 1, count do
    local p = close[n]
    local i, j = pairA[p], pairB[p]
    local k, m = 2 * i, 2 * j
    local x, y = from[m] - from[k], from[m + 1] - from[k + 1]
    local afterX, afterY = x - size[k], y - size[k + 1]
    local beforeX, beforeY = -x - size[m], -y - size[m + 1]
    local gapX, gapY = max(afterX, beforeX), max(afterY, beforeY)
    if gapX < -EPSILON then
      if gapY >= -EPSILON then
        if afterY >= beforeY then
          put(b, p, 1, k + 1, m + 1, size[k + 1])
        else
          put(b, p, 1, m + 1, k + 1, size[m + 1])
        end
      else
        overlapCount = overlapCount + 1
        overlaps[overlapCount] = p
      end
    elseif gapY < -EPSILON then
      if afterX >= beforeX then
        put(b, p, 0, k, m, size[k])
      else
        put(b, p, 0, m, k, size[m])
      end
    else
      leaveApart(b, p) -- corner to corner
    end
  end
  b.overlapCount = overlapCount
end

-- Decides whether pair p, with a circle, touches, and on which axis.
local function putRound(b, p, i, j)
  local axis, isLow, isSlanted = ball.touch(b, i, j)
  if axis then
    local kl, kh = 2 * (isLow and i or j) + axis, 2 * (isLow and j or i) + axis
    put(b, p, axis, kl, kh, isSlanted and b.from[kh] - b.from[kl] or b.size[kl])
    if isSlanted then
      b.touches[p] = ELASTIC
      leaveApart(b, p)
    end
  elseif isLow then -- they overlap
    b.overlapCount = b.overlapCount + 1
    b.overlaps[b.overlapCount] = p
  else
    leaveApart(b, p)
  end
end

-- Does so for the pairs with a circle that are not left to the heap.
local function classifyRound(b)
  for n = 1, b.roundCount do
    local p = b.roundPairs[n]
    local i, j = b.pairA[p], b.pairB[p]
    if heapPairs.rest(b, p, i, j) then
      heapPairs.leave(b, p)
    else
      putRound(b, p, i, j)
    end
  end
end

-- Writes the numbers of each contact that the passes over the list need.
local function fill(b, list)
  local order, pair, low, high = list.order, list.pair, list.low, list.high
  local separation, elastic = list.separation, list.elastic
  local contactLow, contactHigh, its = b.contactLow, b.contactHigh, b.separation
  local touches = b.touches
  for n = 1, list.count do
    local p = order[n]
    pair[n], low[n], high[n], separation[n] = p, contactLow[p], contactHigh[p], its[p]
    elastic[n] = touches[p] == ELASTIC and 1 or 0
  end
end

-- Drops the contacts of a list that must not act: open sides of one-ways, `dropThrough`,
-- `canCollide`.
local function dropRefused(b, list)
  local order, kept = list.order, 0
  for n = 1, list.count do
    local p = order[n]
    if rules.passes(b, p, b.contactLow[p], b.contactHigh[p], list.axis, false) then
      if b.touches[p] ~= ELASTIC then
        leaveApart(b, p)
      end
      b.touches[p] = APART
    else
      kept = kept + 1
      order[kept] = p
    end
  end
  list.count, list.recalled = kept, kept
end

-- Marks the contacts that may bounce. They are swept, too.
local function markElastic(b, list)
  local order, restitution, pairA, pairB = list.order, b.restitution, b.pairA, b.pairB
  local wedged, deepIn, stamp = b.wedged, b.deepIn, b.solveStamp
  for n = 1, list.count do
    local p = order[n]
    local isDeep = wedged[p] ~= 0 or deepIn[p] == stamp
    local isElastic = max(restitution[pairA[p]], restitution[pairB[p]]) > 0
    if isElastic and not isDeep and b.touches[p] ~= ELASTIC then
      b.touches[p] = ELASTIC
      leaveApart(b, p)
    end
  end
end

--- Finds the contacts at the start of the step.
function contacts.find(b)
  local down, across = b.contacts[b.downAxis], b.contacts[1 - b.downAxis]
  down.count, across.count, b.heapCount = 0, 0, 0
  local count = listClose(b)
  if b.hasSensors then
    count = dropSensors(b, count)
  end
  if b.crowdCount > 0 or b.hasKnots then
    count = dropGhosts(b, b.closePairs, count)
    b.apartCount = dropGhosts(b, b.apart, b.apartCount)
  end
  if b.hasSlopes then
    count = putSlopes(b, count)
  end
  if b.hasCircles then
    count = takeRound(b, count)
  end
  classify(b, count)
  if b.hasCircles then
    classifyRound(b)
  end
  for n = 1, b.overlapCount do
    putDeep(b, b.overlaps[n])
  end
  contactOrder.arrange(b, down)
  contactOrder.arrange(b, across)
  if b.hasAskers or b.hasOneWays then
    dropRefused(b, down)
    dropRefused(b, across)
  end
  if b.hasBounces then
    markElastic(b, down)
    markElastic(b, across)
  end
  fill(b, down)
  fill(b, across)
end

--- Makes a contact of a pair that has met. It did not bounce, or it may bounce again (`isElastic`).
--- `separation` is the minimum px between the low edges of the two.
function contacts.add(b, axis, p, kl, kh, separation, isElastic)
  if b.touches[p] == CONTACT or (isElastic and b.touches[p] == ELASTIC) then
    return
  elseif b.touches[p] == ELASTIC then -- it no longer bounces
    b.touches[p] = CONTACT
    b.contacts[axis].isNew = true
    return
  end
  put(b, p, axis, kl, kh, separation)
  b.touches[p] = isElastic and ELASTIC or CONTACT
  b.contacts[axis].isNew = true
end

--- Sorts contacts that were added during the step into their lists.
function contacts.rearrange(b)
  for axis = 0, 1 do
    local list = b.contacts[axis]
    if list.isNew then
      list.isNew = false
      contactOrder.arrange(b, list)
      fill(b, list)
    end
  end
end

--- Adds pairs that were found in the middle of the step to those that are swept.
function contacts.noteNew(b)
  for n = b.seenCount + 1, b.liveCount do
    local p = b.live[n]
    if isGhost(b, b.pairA[p], b.pairB[p]) then
      b.touches[p] = GHOST
    else
      b.touches[p] = APART
      leaveApart(b, p)
    end
  end
  b.seenCount = b.liveCount
end

interpreted.functions(putRound, classifyRound, putSlopes)
interpreted.functions(
  deepSeparation,
  putDeep,
  dropRefused,
  contacts.find,
  contacts.add,
  contacts.rearrange
)

return contacts
