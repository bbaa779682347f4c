--- Sweep: when do bodies meet that were apart?
--
-- Every body moves in a straight line from `from` at `time` (0..1 of the step) to `to` at its end.
-- Source: slab method on the Minkowski difference of two boxes; the side is the axis on which the
-- two were apart, on both: the one that closes last.
--
-- Reads the paths, b.apart; writes the list of impacts, b.impacts.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local interpreted = require(root .. ".memory.jit")

local sweep = {}

local EPSILON = columns.EPSILON
local APART, ELASTIC = contacts.APART, contacts.ELASTIC
local floor, max, min = math.floor, math.max, math.min
-- Of so many pairs, it is cheaper to ask one body for its own.
local FEW = 8
-- Two axes that close within this fraction of the step close together: a hit along gravity.
local TIE = 1e-9
-- Fraction of the step by which a corner is met later than a face.
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
    isDeep = {}, -- they are inside each other
    moment = {}, -- keys of the order: when,
    width = {}, -- the wider common edge first,
    first = {}, -- ranks
    second = {},
  }
end

-- Lists in b.near the pairs of b.apart of which one has a new path, if the paths meet on x;
-- returns how many.
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

-- The same of the pairs of list[1..n], bodies with new paths.
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

-- Of near[1..count], keeps the pairs with paths that meet on y, too, and that are swept at all.
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

-- Gap on an axis at the beginning and, on the same side, at the end, of two with offset r and rEnd;
-- and whether the first is the low one.
local function gaps(r, rEnd, sizeA, sizeB)
  local after, before = r - sizeA, -r - sizeB
  if after >= before then
    return after, rEnd - sizeA, true
  end
  return before, -rEnd - sizeB, false
end

-- The fraction of the path at which two that are apart on one axis, by `gap`, meet on it, or nil.
-- r, rEnd: their offsets on the other axis.
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

-- The same of two that are apart on both axes, and on which axis. Whether they meet is asked of
-- slightly shrunk boxes, so that one that slides past flush does not.
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

-- Where body k is at moment t, between its start and its end.
local function at(b, k, start, t)
  local from = b.from[k]
  if t <= start then
    return from
  end
  return from + (b.to[k] - from) * ((t - start) / (1 - start))
end

-- When two bodies meet (0..1 of the step), on which axis, whether the first is the low one.
local function meet(b, i, j)
  local size, to, k, m = b.size, b.to, 2 * i, 2 * j
  local startI, startJ = b.time[i], b.time[j]
  local start = max(startI, startJ)
  local x, endX = at(b, m, startJ, start) - at(b, k, startI, start), to[m] - to[k]
  local y = at(b, m + 1, startJ, start) - at(b, k + 1, startI, start)
  local endY = to[m + 1] - to[k + 1]
  local gapX, gapEndX, isLowX = gaps(x, endX, size[k], size[m])
  local gapY, gapEndY, isLowY = gaps(y, endY, size[k + 1], size[m + 1])
  local share, axis
  if gapX < -EPSILON and gapY < -EPSILON then
    -- Inside each other: along the shallower axis, if they are so at the end.
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

--- Finds the impacts of whatever has a new path: those in b.changed[1..count], if count is not nil.
--- Returns how many there are.
function sweep.run(b, changedCount)
  local isFew = changedCount and changedCount * FEW < b.apartCount
  local near = keepNear(b, isFew and listOf(b, b.changed, changedCount) or listAll(b))
  local impacts, list, pairA, pairB, rank, count = b.impacts, b.near, b.pairA, b.pairB, b.rank, 0
  for n = 1, near do
    local p = list[n]
    local i, j = pairA[p], pairB[p]
    if rank[j] < rank[i] then -- where both are at one spot, the order of the world decides
      i, j = pairB[p], pairA[p]
    end
    local t, axis, isLow, isDeep
    if b.hasCircles and ball.isRound(b, i, j) then
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

-- Each pair goes another way.
interpreted.functions(gaps, meetFace, meetCorner, at, meet, sweep.run)

return sweep
