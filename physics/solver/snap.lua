--- Snap: an object that stood on something stays on the ground when that drops by a little.
--
-- It is the other half of nudge: that goes up stairs, this goes down. When all paths of the step
-- are known, an object with `snap` that has run off what it stood on is lowered onto the ground
-- below, and what stands on it, too. It is lowered straight down, where it ends, onto the first
-- thing there is; so it passes through nothing. If it has run over several edges in the step, each
-- of them may be as high as `snap`. On slopes the ground is as deep as its edge is where the object
-- stands (see slope).
--
-- Reads support, velocity, to, speed, heldLow, heldHigh; writes to, speed, accel, lowered,
-- pressedLow or pressedHigh, and heldLow or heldHigh of what was lowered.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local pairFinder = require(root .. ".broadphase.pairFinder")
local rules = require(root .. ".solver.rules")
local shapes = require(root .. ".space.shapes")
local slope = require(root .. ".solver.slope")
local sort = require(root .. ".memory.sort")

local snap = {}

local DYNAMIC, EPSILON, SIDE = columns.DYNAMIC, columns.EPSILON, columns.SIDE
local CIRCLE = shapes.CIRCLE
local floor, huge, max, min = math.floor, math.huge, math.max, math.min
-- Edges that an object may run over in a step.
local EDGES = 16

-- Returns the lists that a world needs.
local function newLists()
  return { list = {}, depth = {}, count = 0, ground = {} }
end

-- How deep the foot of a body is, along its gravity: the higher, the deeper.
local function footOf(b, k, sign)
  return sign > 0 and b.to[k] + b.size[k] or -b.to[k]
end

-- How deep the upper side of slot j is along an axis, for body k that is at x across it.
local function topOf(b, j, k, sign, x)
  local m = 2 * j + k % 2
  local top = sign > 0 and b.to[m] or -b.to[m] - b.size[m]
  if b.hasSlopes and slope.bears(b, j, k % 2, sign) then
    return top + slope.fall(b, k, j, x)
  end
  return top
end

-- The index of the axis along which slot i falls; 0: it does not.
local function downOf(b, i)
  local k = 2 * i
  return b.down[k] ~= 0 and k or b.down[k + 1] ~= 0 and k + 1 or 0
end

-- Whether slot i has begun the step standing, and does not go up from there. (What is round rolls
-- over edges.)
local function stands(b, i)
  local k = downOf(b, i)
  return b.support[i] ~= 0
    and k ~= 0
    and b.kind[i] == DYNAMIC
    and not (b.sensor[i] or b.buried[i] or b.shape[i] == CIRCLE)
    and b.crowd[2 * i] <= 0
    and b.velocity[k] * b.down[k] >= 0
end

-- Whether slot i still stands on what it stood on.
local function isOnSupport(b, i, k, sign)
  local j, axis = b.support[i], k % 2
  local across, other = k + 1 - 2 * axis, 2 * j + 1 - axis
  local gap = topOf(b, j, k, sign, b.to[across]) - footOf(b, k, sign)
  local r = b.to[other] - b.to[across]
  local isBeside = max(r - b.size[across], -r - b.size[other]) >= -EPSILON
  return gap <= EPSILON and gap >= -EPSILON and not isBeside
end

-- Whether slot j is solid for slot i, which comes from above.
local function isSolid(b, i, j, side)
  return j ~= i
    and not b.sensor[j]
    and not (b.oneWay[j] and SIDE[b.oneWay[j]] ~= side)
    and not (b.oneWay[i] and SIDE[b.oneWay[i]] ~= columns.OPPOSITE[side])
    and filter.allows(b, i, j)
end

-- Whether slot i falls through slot j.
local function isDropping(b, i, j)
  local p = columns.pairOf(b, i, j)
  return p and b.dropping[p] or rules.isFalling(b, i, b.oneWay[j])
end

-- Lists what slot i could stand on, where its way across leads (from x to its end) and down to
-- `depth`; returns how many.
local function listGround(b, i, k, sign, x, depth)
  local axis = k % 2
  local across, found = k + 1 - 2 * axis, b.snaps.ground
  local foot, side = footOf(b, k, sign), 2 * axis + (sign > 0 and 1 or 2)
  local low, high = min(x, b.to[across]), max(x, b.to[across]) + b.size[across]
  local near, far = min(sign * foot, sign * depth), max(sign * foot, sign * depth)
  local left, top, right, bottom = low, near, high, far
  if axis == 0 then
    left, top, right, bottom = near, low, far, high
  end
  local count = 0
  for n = 1, b.broadphase:query(left, top, right, bottom, found) do
    local j = found[n]
    -- (The crest of a slope may be further up than the place where the object comes onto it.)
    local isBelow = topOf(b, j, k, sign, x) >= foot - EPSILON
      or (b.hasSlopes and slope.bears(b, j, axis, sign))
    if isBelow and isSolid(b, i, j, side) and not isDropping(b, i, j) then
      count = count + 1
      found[count] = j
    end
  end
  return count
end

-- Of ground[1..count], the highest one below body k, if that is at x, and no higher than `least`;
-- and how deep that is.
local function highest(b, k, sign, count, x, least)
  local found, axis = b.snaps.ground, k % 2
  local best, depth, width = 0, huge, b.size[k + 1 - 2 * axis]
  for n = 1, count do
    local j = found[n]
    local other, its = 2 * j + 1 - axis, topOf(b, j, k, sign, x)
    local r = b.to[other] - x
    local isBelow = r - width < -EPSILON and -r - b.size[other] < -EPSILON
    if isBelow and its >= least - EPSILON then
      if its < depth or (its == depth and b.rank[j] < b.rank[best]) then
        best, depth = j, its
      end
    end
  end
  return best, depth
end

-- Where ground as deep as `height` ends for body k, which stands on it at x and goes on by `way`
-- px; and how deep it is there.
local function endOf(b, k, sign, count, x, way, height)
  local found, axis, hasGone = b.snaps.ground, k % 2, true
  local width, goal = b.size[k + 1 - 2 * axis], b.to[k + 1 - 2 * axis]
  while hasGone and (goal - x) * way > 0 do
    hasGone = false
    for n = 1, count do
      local j = found[n]
      local other, gap = 2 * j + 1 - axis, topOf(b, j, k, sign, x) - height
      local r = b.to[other] - x
      local isBelow = r - width < -EPSILON and -r - b.size[other] < -EPSILON
      if isBelow and gap <= EPSILON and gap >= -EPSILON then
        x, hasGone = way > 0 and b.to[other] + b.size[other] or b.to[other] - width, true
        if b.hasSlopes and slope.bears(b, j, axis, sign) then
          x = way > 0 and min(x, goal) or max(x, goal)
          height = topOf(b, j, k, sign, x)
        end
      end
    end
  end
  return x, height
end

-- How deep the ground may be at the end of the way of body k, which was `way` px long and began on
-- ground as deep as `height`: from edge to edge it drops by at most `most` px.
local function reach(b, k, sign, count, way, height, most)
  local goal = b.to[k + 1 - 2 * (k % 2)]
  local x = goal - way
  for _ = 1, EDGES do
    x, height = endOf(b, k, sign, count, x, way, height)
    if (goal - x) * way <= 0 then
      break
    end
    local _, depth = highest(b, k, sign, count, x, height)
    if depth > height + most + EPSILON then
      break
    end
    height = depth
  end
  return height + most
end

-- Whether slot j, which body k would be put onto, is held, and the two do not go apart.
local function bears(b, j, k, sign)
  local m = 2 * j + k % 2
  local isHeld = b.kind[j] ~= DYNAMIC or (sign > 0 and b.heldHigh[m] or b.heldLow[m]) > 0
  local closing = (b.speed[k] - b.speed[m]) * sign
  return isHeld and max(closing, b.speed[k] * sign) >= -EPSILON
end

-- Puts slot i onto slot j, unless the game lets it pass; returns whether it stands there.
local function put(b, i, j, k, sign)
  local m, before, foot = 2 * j + k % 2, b.to[k], footOf(b, k, sign)
  local list, x = b.snaps.list, b.to[k + 1 - 2 * (k % 2)]
  if b.hasSlopes and slope.bears(b, j, k % 2, sign) then
    b.to[k] = b.to[m] - sign * slope.separation(b, i, j, k % 2, x, b.to[m + 1 - 2 * (k % 2)])
  else
    b.to[k] = sign > 0 and b.to[m] - b.size[k] or b.to[m] + b.size[m]
  end
  list[0] = i
  pairFinder.run(b, list, 0, 0)
  local p = columns.pairOf(b, i, j)
  if not p or rules.passes(b, p, sign > 0 and k or m, sign > 0 and m or k, k % 2, false) then
    b.to[k] = before
    return false
  end
  b.speed[k], b.accel[k] = b.speed[m], b.accel[m]
  if sign > 0 then
    b.pressedHigh[k], b.heldHigh[k], b.holderHigh[k] = true, b.heldHigh[m] + 1, m
  else
    b.pressedLow[k], b.heldLow[k], b.holderLow[k] = true, b.heldLow[m] + 1, m
  end
  b.lowered[i] = footOf(b, k, sign) - foot
  return true
end

-- Lowers slot i by at most `most` px at each edge; returns whether it was.
local function lower(b, i, most, dt)
  local k = downOf(b, i)
  local sign, across = b.down[k], k + 1 - 2 * (k % 2)
  if isOnSupport(b, i, k, sign) then
    return false
  end
  local way = b.to[across] - b.origin[across] - b.carried[across] * dt
  local foot, edges, start = footOf(b, k, sign), min(EDGES, 1 + floor(max(way, -way)))
  local deepest = foot + most * edges
  if b.hasSlopes then
    deepest = deepest + max(way, -way) * b.steep[k % 2]
    start = foot - (b.to[k] - b.origin[k] - b.carried[k] * dt) * sign
  end
  local count = listGround(b, i, k, sign, b.to[across] - way, deepest)
  local j, depth = highest(b, k, sign, count, b.to[across], foot)
  if j == 0 or depth <= foot + EPSILON or b.shape[j] == CIRCLE or not bears(b, j, k, sign) then
    return false
  elseif depth > foot + most + EPSILON then
    local isOneEdge = edges == 1 and not b.hasSlopes
    if isOneEdge or depth > reach(b, k, sign, count, way, start or foot, most) + EPSILON then
      return false
    end
  end
  return put(b, i, j, k, sign)
end

-- Adds slot i to those to be lowered, the lowest first.
local function add(b, i)
  local k, snaps = downOf(b, i), b.snaps
  snaps.count = snaps.count + 1
  snaps.list[snaps.count], snaps.depth[i] = i, -footOf(b, k, b.down[k])
end

local function lowerListed(b, dt)
  local snaps, any = b.snaps, false
  local list, count = snaps.list, snaps.count
  sort.by(list, count, snaps.depth, b.rank, b.rank)
  for n = 1, count do
    local i = list[n]
    any = lower(b, i, max(b.snap[i], b.lowered[b.support[i]]), dt) or any
  end
  snaps.count = 0
  return any
end

--- Lowers what has run off the ground that it stood on, and what stands on that.
function snap.run(b, dt)
  b.snaps = b.snaps or newLists()
  local awake, support, lowered = b.awakeList, b.support, b.lowered
  for n = 1, b.awakeCount do
    local i = awake[n]
    lowered[i] = 0
    if b.snap[i] > 0 and stands(b, i) then
      add(b, i)
    end
  end
  local any = b.snaps.count > 0 and lowerListed(b, dt)
  while any do
    for n = 1, b.awakeCount do
      local i = awake[n]
      if lowered[i] == 0 and lowered[support[i]] > 0 and stands(b, i) then
        add(b, i)
      end
    end
    any = lowerListed(b, dt)
  end
end

return snap
