--- Step 7, publish: which contacts there are now, and what the game's tables are told.
--
-- Reads to, speed, carried, hit, pressed...; writes position, velocity, contact, support, carrier,
-- quiet, the fields x, y, vx, vy and touching of the game's objects, and notes the events.

local here = (...):match("^(.*)%.[^.]+$")
local aabb = require(here .. ".aabb")
local approach = require(here .. ".approach")
local carrier = require(here .. ".carrier")
local columns = require(here .. ".columns")
local crush = require(here .. ".crush")
local events = require(here .. ".events")
local oneway = require(here .. ".oneway")

local publish = {}

local DYNAMIC = columns.DYNAMIC
local EPSILON, OPPOSITE = columns.EPSILON, columns.OPPOSITE
local max, min = math.max, math.min
local SIDE_NUMBER = { left = 1, right = 2, top = 3, bottom = 4 }

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

-- The side on which a solid pair is in contact now, else 0.
local function solidContact(b, p, i, j)
  local side, overlap = flushSide(b, i, j)
  b.overlapping[p] = overlap
  if overlap then
    if b.passing[p] or b.oneWay[i] or b.oneWay[j] then
      b.wedged[p] = 0
      b.inside[i], b.inside[j] = true, true
      return 0
    end
    wedge(b, p, i, j)
    if b.wedged[p] == 0 then
      b.inside[i], b.inside[j] = true, true
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
    i, j = j, i
  end
  local to, size, ki, kj = b.to, b.size, 2 * i, 2 * j
  local side = SIDE_NUMBER[aabb.side(
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

local function gapAt(b, k, m)
  local r = b.to[m] - b.to[k]
  return max(r - b.size[k], -r - b.size[m])
end

local function updateContact(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  if
    b.contact[p] == 0
    and b.hit[p] == 0
    and max(gapAt(b, 2 * i, 2 * j), gapAt(b, 2 * i + 1, 2 * j + 1)) > EPSILON
  then
    b.overlapping[p], b.wedged[p], b.dropping[p] = false, 0, false
    return -- most neighbours do not touch
  end
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
end

-- Updates all pairs of whoever took part, and lists those in contact behind b.touchPairs.
local function updateContacts(b)
  local list, head, nextHalf, other, awake = b.awakeList, b.head, b.next, b.other, b.awake
  local contact, touchPairs, count = b.contact, b.touchPairs, 0
  for n = 1, b.awakeCount do
    local half = head[list[n]]
    while half ~= 0 do
      if half % 2 == 1 or not awake[other[half]] then
        local p = (half + half % 2) / 2
        updateContact(b, p)
        if contact[p] ~= 0 then
          count = count + 1
          touchPairs[count] = p
        end
      end
      half = nextHalf[half]
    end
  end
  return count
end

local function commonEdge(b, i, j, axis)
  local ki, kj = 2 * i + axis, 2 * j + axis
  local to, size = b.to, b.size
  return min(to[ki] + size[ki], to[kj] + size[kj]) - max(to[ki], to[kj])
end

-- Offers j as what i touches on a side: the widest common edge wins, ties in order.
local function offer(b, i, side, j, width)
  local at = 4 * i + side
  local best, bestWidth = b.touchBest[at], b.touchWidth[at]
  if
    best == 0
    or width > bestWidth + EPSILON
    or (width >= bestWidth - EPSILON and b.rank[j] < b.rank[best])
  then
    b.touchBest[at], b.touchWidth[at] = j, width
  end
end

-- Finds what everybody touches, from the pairs in contact.
local function findTouching(b, count)
  local list, best, touchPairs = b.awakeList, b.touchBest, b.touchPairs
  for n = 1, b.awakeCount do
    local at = 4 * list[n]
    best[at + 1], best[at + 2], best[at + 3], best[at + 4] = 0, 0, 0, 0
  end
  for n = 1, count do
    local p = touchPairs[n]
    local i, j, side = b.pairA[p], b.pairB[p], b.contact[p]
    if not (b.sensor[i] or b.sensor[j]) then
      local width = commonEdge(b, i, j, side > 2 and 0 or 1)
      if b.awake[i] then
        offer(b, i, side, j, width)
      end
      if b.awake[j] then
        offer(b, j, OPPOSITE[side], i, width)
      end
    end
  end
end

local function publishTouching(b, i)
  local object, touching, best, at = b.object[i], b.touching[i], b.touchBest, 4 * i
  local left, right, top, bottom = best[at + 1], best[at + 2], best[at + 3], best[at + 4]
  touching.left = left ~= 0 and b.object[left]
  touching.right = right ~= 0 and b.object[right]
  touching.top = top ~= 0 and b.object[top]
  touching.bottom = bottom ~= 0 and b.object[bottom]
  if object.touching ~= touching then
    object.touching = touching
  end
  local downX, downY = b.down[2 * i], b.down[2 * i + 1]
  b.support[i] = downY > 0 and bottom
    or downY < 0 and top
    or downX > 0 and right
    or downX < 0 and left
    or 0
end

-- Whether the next step may differ from this one although nothing moves.
local function hasNews(b, i)
  return b.fresh[i] or b.moved[i] or b.heard[i] or b.inside[i]
end

local function publishDynamic(b, i)
  local object, k = b.object[i], 2 * i
  local x, y = b.to[k], b.to[k + 1]
  local vx, vy = b.speed[k], b.speed[k + 1]
  local c = carrier.find(b, i)
  if c ~= 0 then
    local cx, cy = carrier.velocity(b, c)
    vx = carrier.ownVelocity(b, k, cx, c ~= b.carrier[i])
    vy = carrier.ownVelocity(b, k + 1, cy, c ~= b.carrier[i])
  end
  b.carrier[i] = c
  local still = x == b.position[k] and y == b.position[k + 1]
  local steady = vx == b.velocity[k] and vy == b.velocity[k + 1]
  b.quiet[i] = still and steady and vx == 0 and vy == 0 and not hasNews(b, i)
  if not still then
    object.x, object.y = x, y
    b.position[k], b.position[k + 1] = x, y
    b.written[k], b.written[k + 1] = x, y
  end
  if vx ~= object.vx or vy ~= object.vy then
    object.vx, object.vy = vx, vy
    b.velocity[k], b.velocity[k + 1] = vx, vy
  end
end

local function publishKinematic(b, i)
  local object, k = b.object[i], 2 * i
  local x, y = b.to[k], b.to[k + 1]
  b.behind[k] = b.written[k] - b.position[k] + b.behind[k] - b.way[k]
  b.behind[k + 1] = b.written[k + 1] - b.position[k + 1] + b.behind[k + 1] - b.way[k + 1]
  b.quiet[i] = x == b.position[k]
    and y == b.position[k + 1]
    and b.velocity[k] == 0
    and b.velocity[k + 1] == 0
    and b.behind[k] == 0
    and b.behind[k + 1] == 0
    and not hasNews(b, i)
  if x ~= object.x or y ~= object.y then
    object.x, object.y = x, y
  end
  b.position[k], b.position[k + 1] = x, y
  b.written[k], b.written[k + 1] = x, y
end

-- Where everybody is from now on, also as an obstacle for the next step.
local function stand(b, i)
  local k = 2 * i
  b.from[k], b.from[k + 1] = b.position[k], b.position[k + 1]
  b.to[k], b.to[k + 1] = b.position[k], b.position[k + 1]
  b.speed[k], b.speed[k + 1], b.accel[k], b.accel[k + 1] = 0, 0, 0, 0
  b.time[i] = 0
  b.fresh[i] = false
end

local function forgetMoved(b)
  for n = 1, b.movedCount do
    local i = b.movedList[n]
    b.moved[i], b.fresh[i] = false, false
  end
  b.movedCount = 0
end

--- Publishes what the step has brought, for everybody who took part in it.
function publish.run(b)
  local list, kind, inside = b.awakeList, b.kind, b.inside
  for n = 1, b.awakeCount do
    inside[list[n]] = false
  end
  findTouching(b, updateContacts(b))
  for n = 1, b.awakeCount do
    if kind[list[n]] == DYNAMIC then
      publishTouching(b, list[n])
      crush.tell(b, list[n])
    end
  end
  for n = 1, b.awakeCount do
    local i = list[n]
    if kind[i] == DYNAMIC then
      publishDynamic(b, i)
    else
      publishKinematic(b, i)
    end
  end
  for n = 1, b.awakeCount do
    stand(b, list[n])
  end
  forgetMoved(b)
end

return publish
