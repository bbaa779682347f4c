--- Sweep: computes from the paths of two bodies that were apart when they meet in the step (the
-- time of impact), and on which side.
--
-- Every body moves in a straight line from `from` at `time` (0..1 of the step) to `to` at its end.
-- (One that follows slopes has several, see slope.meetPieces.)
-- Source: slab method on the Minkowski difference of two boxes. The side is on the axis on which
-- the two were apart. If they were apart on both, it is the axis that closes last.
--
-- Reads the paths, touches, b.apart, and the pairs of changed bodies; writes the list of impacts,
-- b.impacts.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local interpreted = require(root .. ".memory.jit")
local path = require(root .. ".motion.path")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")

local sweep = {}

local EPSILON = columns.EPSILON
local APART, ELASTIC = contacts.APART, contacts.ELASTIC
local floor, max, min = math.floor, math.max, math.min
-- If there are more than FEW pairs per changed body, the pair lists of these bodies are searched
-- instead of all pairs.
local FEW = 8
-- Two axes that close within this fraction of the step close together: the hit is along gravity.
local TIE = 1e-9
-- Fraction of the step by which a corner is met later than a face at the same place.
local CORNER = 2e-9

--- Returns an empty list of impacts.
function sweep.newImpacts()
  return {
    count = 0,
    order = {},
    pair = {},
    time = {}, -- fraction of the step
    axis = {},
    low = {}, -- slot of the low body on the axis
    high = {},
    isDeep = {}, -- the two overlap already
    moment = {}, -- sort keys: the time, rounded
    width = {}, -- width of the common edge, negative: the widest comes first
    first = {}, -- ranks of the two
    second = {},
  }
end

-- Lists in b.near the pairs of b.apart with at least one new path, if their paths overlap on x.
-- Returns how many there are.
local function listAll(b)
  local apart, near, dirty, count = b.apart, b.near, b.dirty, 0
  local pairA, pairB, from, to, size = b.pairA, b.pairB, b.from, b.to, b.size
  for n = 1, b.apartCount do
    local p = apart[n]
    local i, j = pairA[p], pairB[p]
    if dirty[i] + dirty[j] > 0 then
      local k, m = 2 * i, 2 * j
      local s, e, u, v = from[k], to[k], from[m], to[m]
      if max(s, e) + size[k] > min(u, v) and max(u, v) + size[m] > min(s, e) then
        count = count + 1
        near[count] = p
      end
    end
  end
  return count
end

-- Does the same for the pairs of the bodies in list[1..n], which have new paths.
local function listOf(b, list, n)
  local near, swept, stamp, count = b.near, b.sweptAt, b.sweptStamp + 1, 0
  local head, other, nextHalf, from, to, size = b.head, b.other, b.next, b.from, b.to, b.size
  b.sweptStamp = stamp
  for at = 1, n do
    local i = list[at]
    local half, k = head[i], 2 * i
    while half ~= 0 do
      local p, m = floor(half * 0.5 + 0.5), 2 * other[half]
      local s, e, u, v = from[k], to[k], from[m], to[m]
      if max(s, e) + size[k] > min(u, v) and max(u, v) + size[m] > min(s, e) then
        if swept[p] ~= stamp then
          swept[p], count = stamp, count + 1
          near[count] = p
        end
      end
      half = nextHalf[half]
    end
  end
  return count
end

-- Keeps the pairs of near[1..count] that are to be swept and have paths that overlap on y, too.
-- Returns how many there are.
local function keepNear(b, count)
  local near, touches, pairA, pairB = b.near, b.touches, b.pairA, b.pairB
  local from, to, size, kept = b.from, b.to, b.size, 0
  for n = 1, count do
    local p = near[n]
    local k, m = 2 * pairA[p] + 1, 2 * pairB[p] + 1
    local s, e, u, v = from[k], to[k], from[m], to[m]
    if max(s, e) + size[k] > min(u, v) and max(u, v) + size[m] > min(s, e) then
      if touches[p] == APART or touches[p] == ELASTIC then
        kept = kept + 1
        near[kept] = p
      end
    end
  end
  return kept
end

-- Returns the gap on an axis at the start, that on the same side at the end, and whether the first
-- is the low body. `r` and `rEnd` are the offsets of the second body from the first.
local function gaps(r, rEnd, sizeA, sizeB)
  local after, before = r - sizeA, -r - sizeB
  if after >= before then
    return after, rEnd - sizeA, true
  end
  return before, -rEnd - sizeB, false
end

-- Returns the fraction of the path at which two bodies meet that are apart by `gap` on one axis
-- only, or nil. r, rEnd: their offsets on the other axis.
local function meetFace(gap, gapEnd, r, rEnd, sizeA, sizeB)
  if gapEnd >= -EPSILON or gapEnd >= gap then
    return nil
  end
  local share = gap > EPSILON and gap / (gap - gapEnd) or 0.0
  local at = r + (rEnd - r) * share
  if max(at - sizeA, -at - sizeB) >= -EPSILON then
    return nil -- past each other by then
  end
  return share
end

-- Returns the same for two bodies that are apart on both axes, and the axis of the hit. The boxes
-- are shrunk a little for this test, so that a body that slides past flush does not hit.
local function meetCorner(gapX, endX, gapY, endY, depthX, depthY, down)
  if endX >= -EPSILON or endY >= -EPSILON then
    return nil
  end
  local inX, inY = (gapX + EPSILON) / (gapX - endX), (gapY + EPSILON) / (gapY - endY)
  local outX = (gapX + depthX - EPSILON) / (gapX - endX)
  local outY = (gapY + depthY - EPSILON) / (gapY - endY)
  if inX >= outY or inY >= outX then
    return nil
  end
  local axis = inY > inX and 1 or 0
  if inY - inX <= TIE and inX - inY <= TIE then
    axis = down
  end
  local gap, gapEnd = gapX, endX
  if axis == 1 then
    gap, gapEnd = gapY, endY
  end
  return max(gap, 0.0) / (gap - gapEnd) + CORNER, axis
end

-- Returns when two bodies meet (0..1 of the step), on which axis, whether the first one is the low
-- one, and whether they overlap already. Returns nil if they do not meet.
local function meet(b, i, j)
  local size, to, k, m = b.size, b.to, 2 * i, 2 * j
  local startI, startJ = b.time[i], b.time[j]
  local start = max(startI, startJ)
  local x, endX = path.at(b, m, startJ, start) - path.at(b, k, startI, start), to[m] - to[k]
  local y = path.at(b, m + 1, startJ, start) - path.at(b, k + 1, startI, start)
  local endY = to[m + 1] - to[k + 1]
  local gapX, gapEndX, isLowX = gaps(x, endX, size[k], size[m])
  local gapY, gapEndY, isLowY = gaps(y, endY, size[k + 1], size[m + 1])
  local share, axis
  if gapX < -EPSILON and gapY < -EPSILON then
    -- They overlap already: on the axis with the smaller overlap, if they still overlap at the end.
    if gapEndX >= -EPSILON or gapEndY >= -EPSILON then
      return nil
    end
    share, axis = 0.0, gapEndY >= gapEndX and 1 or 0
  elseif gapX < -EPSILON then
    share, axis = meetFace(gapY, gapEndY, x, endX, size[k], size[m]), 1
  elseif gapY < -EPSILON then
    share, axis = meetFace(gapX, gapEndX, y, endY, size[k + 1], size[m + 1]), 0
  else
    share, axis = meetCorner(
      gapX,
      gapEndX,
      gapY,
      gapEndY,
      size[k] + size[m],
      size[k + 1] + size[m + 1],
      b.downAxis
    )
  end
  if not share then
    return nil
  end
  local isDeep = gapX < -EPSILON and gapY < -EPSILON
  return start + (1 - start) * share, axis, axis == 1 and isLowY or axis == 0 and isLowX, isDeep
end

sweep.meet = meet

--- Finds the impacts of all bodies with new paths. If `changedCount` is not nil, these are
--- b.changed[1..changedCount]. Returns the number of impacts.
function sweep.run(b, changedCount)
  local isFew = changedCount and changedCount * FEW < b.apartCount
  local near = keepNear(b, isFew and listOf(b, b.changed, changedCount) or listAll(b))
  local impacts, list, pairA, pairB, rank, count = b.impacts, b.near, b.pairA, b.pairB, b.rank, 0
  local hasSlopes, hasCircles = b.hasSlopes, b.hasCircles
  for n = 1, near do
    local p = list[n]
    local i, j = pairA[p], pairB[p]
    if rank[j] < rank[i] then -- if both are at one place, the order of the world decides
      i, j = pairB[p], pairA[p]
    end
    local isRound = hasCircles and ball.isRound(b, i, j)
    local t, axis, isLow, isDeep
    if hasSlopes then
      t, axis, isLow, isDeep = slope.meetAny(b, i, j, isRound and ball.meet or meet)
    elseif isRound then
      t, axis, isLow, isDeep = ball.meet(b, i, j)
    else
      t, axis, isLow, isDeep = meet(b, i, j)
    end
    if t then
      count = count + 1
      impacts.pair[count], impacts.time[count], impacts.axis[count] = p, t, axis
      impacts.low[count], impacts.high[count] = isLow and i or j, isLow and j or i
      impacts.isDeep[count] = isDeep
    end
  end
  impacts.count = count
  return count
end

-- These take another branch for each pair. (jit: 4)
interpreted.functions(gaps, meetFace, meetCorner, meet, sweep.run)

return sweep
