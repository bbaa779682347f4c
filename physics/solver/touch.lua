---@diagnostic disable
--- Touch: computes from the shapes of two bodies on which axis they touch, how far apart they must
--- be there, and at which side and place. Here boxes and slopes are told apart from what is round,
--- which ball answers for; what a shape is says space/shapes.
--
-- Slopes are right triangles, on which bodies stand as on stairs with infinitely small steps. A
-- contact with the sloped edge is one along gravity (along y without gravity), and no other than
-- that of two boxes, but for its separation: how far the two must be apart depends on where the
-- corner of the box is across gravity. So friction, stacks, belts and one-ways need no rule of
-- their own. `walk` moves what stands on slopes along them, an impact is turned along them by
-- `deflect`.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local path = require(root .. ".motion.path")
local shapes = require(root .. ".space.shapes")

local touch = {}

local AXIS, OPPOSITE = columns.AXIS, columns.OPPOSITE
local EPSILON, SLACK = columns.EPSILON, columns.SLACK
local isBox, isSlope, SOLID = shapes.isBox, shapes.isSlope, shapes.SOLID
local axisOf, depth = path.axisOf, shapes.depth
local max, min = math.max, math.min

--- Returns whether two leave each other over their own faces: a box and a slope. (Two slopes, of
--- which one is a sensor, are boxes.)
function touch.haveFaces(b, i, j)
  local one, other = b.shape[i], b.shape[j]
  return isBox[one] and isSlope[other] or isBox[other] and isSlope[one]
end

local haveFaces = touch.haveFaces

--- Returns the box and the slope of a pair.
function touch.order(b, i, j)
  if isSlope[b.shape[j]] then
    return i, j
  end
  return j, i
end

local order = touch.order

--- Returns whether slot j is a slope that bears what gravity on that side of an axis (`sign`)
--- presses on it.
function touch.isRamp(b, j, axis, sign)
  return SOLID[axis][b.shape[j]] == sign
end

--- Returns how far apart the low one and the high one of slots i and j must be on an axis, if i is
--- at `place` across it and j at `its`: as their boxes, or if i is a box, flush with the edge of
--- slope j.
function touch.apart(b, i, j, axis, isLow, place, its)
  local size, shape, t = b.size, b.shape[j], 1 - axis
  local low, way = isLow and i or j, 0.0
  local isEdge = SOLID[axis][shape] == (isLow and 1 or -1) and isBox[b.shape[i]]
  if isEdge and axis == axisOf(b, i) then
    local m = 2 * j
    way = depth(SOLID[t][shape], its, size[m + t], size[m + axis], place, size[2 * i + t])
  end
  return size[2 * low + axis] - way
end

local apart = touch.apart

-- How far box i at (x, y) is beyond the nearest face of slope j, the unit normal of that, and
-- whether it is the edge.
local function nearest(b, i, j, x, y, ox, oy)
  local size, k, m, its = b.size, 2 * i, 2 * j, b.shape[j]
  local w, h, ow, oh, axis = size[k], size[k + 1], size[m], size[m + 1], axisOf(b, i)
  return shapes.face(shapes.BOX, x, y, w, h, its, ox, oy, ow, oh, axis)
end

-- The face of slope j on which box i is flush, or inside by less than all others, as an axis and
-- whether the box is low; px to it, and whether it is the edge. Nil as the first: it is apart, or
-- flush with a corner only.
local function nearestSide(b, i, j, places)
  local size, axis, k, m = b.size, axisOf(b, i), 2 * i, 2 * j
  local gap, nx, ny, isEdge = nearest(b, i, j, places[k], places[k + 1], places[m], places[m + 1])
  local q, isLow = shapes.sideOf(nx, ny, isEdge, axis)
  k, m = k + 1 - q, m + 1 - q
  local common = min(places[k] + size[k], places[m] + size[m]) - max(places[k], places[m])
  if gap > EPSILON or gap >= -EPSILON and common <= EPSILON then
    return nil, nil, gap
  end
  return q, isLow, gap, isEdge
end

-- Whether no gravity presses slot i to anything: the edge of a slope is a wall for it.
local function isFloating(b, i)
  return b.down[2 * i] == 0 and b.down[2 * i + 1] == 0
end

-- How far box i, at x across its axis, is beyond the crest of slope j, at `its`; < 0: before it.
local function beyondCrest(b, i, j, x, its)
  local t = 1 - axisOf(b, i)
  local before = SOLID[t][b.shape[j]] > 0 and b.size[2 * i + t] - b.size[2 * j + t]
  return before and x + before - its or its - x
end

-- How much further along the axis of box i the edge of slope j is for each px across it.
local function slantOf(b, i, j)
  return shapes.slant(b.shape[j], axisOf(b, i), b.size[2 * j], b.size[2 * j + 1])
end

--- Returns the gradient of the ground, slot j, under slot i: px along gravity for each px across
--- it, 0 beyond the crest.
function touch.gradient(b, i, j)
  local axis, place = axisOf(b, i), b.position
  local t = 1 - axis
  local isOn = touch.isRamp(b, j, axis, b.down[2 * i + axis])
    and beyondCrest(b, i, j, place[2 * i + t], place[2 * j + t]) < -EPSILON
  return isOn and slantOf(b, i, j) or 0
end

--- Returns how two that are not both boxes touch where the step begins: the axis, the low and the
--- high index, and px that these must be apart. Nil, and whether they overlap: they do not touch,
--- or are left to the sweep, as a slope that a box is inside of, or floats at.
function touch.contact(b, i, j)
  local from, axis, isLow, gap, isEdge = b.from
  if haveFaces(b, i, j) then
    i, j = order(b, i, j)
    axis, isLow, gap, isEdge = nearestSide(b, i, j, from)
  else
    axis, isLow = ball.touch(b, i, j)
  end
  if not axis or gap and (gap < -EPSILON or isEdge and isFloating(b, i)) then
    return nil, not gap and isLow
  end
  local t, kl, kh = 1 - axis, 2 * (isLow and i or j) + axis, 2 * (isLow and j or i) + axis
  return axis, kl, kh, apart(b, i, j, axis, isLow, from[2 * i + t], from[2 * j + t])
end

--- Returns the side of slot i at which it and j, of pair p, are flush at the end of the step, else
--- 0; -1: they are inside each other. Nil: they are boxes. (What is driven around something round
--- is beside it at the end of a step, on the tangent. In heaps it would rest there.)
function touch.side(b, p, i, j)
  local slack, q, isLow, gap, nx, ny = EPSILON
  if b.hasRound and ball.isRound(b, i, j) then
    gap, nx, ny = ball.gapIn(b, b.to, i, j)
    local isKnown = not (path.isPulled(b, i) or path.isPulled(b, j))
    isKnown = isKnown and (b.hit[p] ~= 0 or b.contact[p] ~= 0)
    slack = (isKnown or ball.isInHeap(b, i) or ball.isInHeap(b, j)) and SLACK or slack
    q, isLow = shapes.sideOf(nx, ny, false)
  elseif haveFaces(b, i, j) then
    local box, its = order(b, i, j)
    q, isLow, gap = nearestSide(b, box, its, b.to)
    isLow = isLow == (box == i)
  else
    return nil
  end
  return gap < -EPSILON and -1 or (gap > slack or not q) and 0 or 2 * q + (isLow and 2 or 1)
end

-- The part of a common edge, from `low` to `high`, on which box i touches slope j with its side
-- `side`: all, or the corner that is on the sloped edge.
local function narrow(b, i, j, side, low, high)
  local axis, shape = AXIS[side], b.shape[j]
  if axis ~= axisOf(b, i) or (side % 2 == 0) ~= (SOLID[axis][shape] > 0) then
    return low, high
  end
  local at = SOLID[1 - axis][shape] > 0 and high or low
  return at, at
end

--- Returns where two touch at moment t, at `side` of slot i: the place on the axis of that side,
--- and from where to where across it. Of a box and a slope the side of the box counts.
function touch.line(b, i, j, side, t)
  local axis, isOnSlope = AXIS[side], b.hasShapes and haveFaces(b, i, j)
  if b.hasRound and ball.isRound(b, i, j) then
    local x, y = ball.point(b, i, j, t)
    local across = axis == 0 and y or x
    return axis == 0 and x or y, across, across
  elseif isOnSlope and isSlope[b.shape[i]] then
    return touch.line(b, j, i, OPPOSITE[side], t)
  end
  local size, own, k, m = b.size, 2 * i + axis, 2 * i + 1 - axis, 2 * j + 1 - axis
  local x, y = path.at(b, k, b.time[i], t), path.at(b, m, b.time[j], t)
  local low, high = max(x, y), max(x, y, min(x + size[k], y + size[m]))
  if isOnSlope then
    low, high = narrow(b, i, j, side, low, high)
  end
  return path.at(b, own, b.time[i], t) + (side % 2 == 0 and size[own] or 0), low, high
end

--- Returns the width and the height by which two overlap where the step begins, if slot i is at
--- (x, y). Of a slope both are px along its nearest face.
function touch.depth(b, i, j, x, y)
  local from, size, k, m = b.from, b.size, 2 * i, 2 * j
  local ox, oy = from[m], from[m + 1]
  if not (b.hasShapes and haveFaces(b, i, j)) then
    return shapes.overlap(x, y, size[k], size[k + 1], ox, oy, size[m], size[m + 1])
  end
  local inside = isBox[b.shape[i]] and nearest(b, i, j, x, y, ox, oy)
    or nearest(b, j, i, ox, oy, x, y)
  return -inside, -inside
end

--- Returns where slot i is flush with j on an axis where the step begins, on the low side of it
--- (`sign` -1) or the high one.
function touch.flushPlace(b, i, j, axis, sign)
  local box, its = order(b, i, j)
  local from, isLow, t = b.from, (sign < 0) == (box == i), 1 - axis
  local way = apart(b, box, its, axis, isLow, from[2 * box + t], from[2 * its + t])
  return from[2 * j + axis] + sign * way
end

-- Meeting -----------------------------------------------------------------------------------------

--- Returns the axis that counts where two meet at a corner, or at the edge of a slope.
function touch.axisOfPair(b, i, j)
  return haveFaces(b, i, j) and axisOf(b, (order(b, i, j))) or b.downAxis
end

--- Returns how far apart two that meet on an axis must be at the end of the step, and how much
--- faster they close for each px/s that the second goes across it, relative to the first. Nil and
--- 0: as boxes.
function touch.lean(b, i, j, axis)
  if not haveFaces(b, i, j) then
    return nil, 0.0
  end
  local box, its = order(b, i, j)
  local t, isLow = 1 - axis, i == box -- i is the low one of the impact
  local x, place = b.to[2 * box + t], b.to[2 * its + t]
  local isEdge = axis == axisOf(b, box) and SOLID[axis][b.shape[its]] == (isLow and 1 or -1)
  local before, at = b.from[2 * box + t], path.at(b, 2 * its + t, b.time[its], b.time[box])
  -- The crest is level, also for what has left it by the end of the step.
  if isEdge and beyondCrest(b, box, its, before, at) > EPSILON then
    isEdge, x, place = false, before, at
  end
  local lean = isEdge and slantOf(b, box, its) or 0.0
  return apart(b, box, its, axis, isLow, x, place), lean
end

--- Deflects one of two that meet at a sloped edge, along the normal of that, if they bounce: with
--- restitution r, or without gravity, unless others press them there. At the end of the step they
--- overlap by o px along the axis, close at v px/s and accelerate towards each other by a; they
--- have met at u px/s, tau s before. Returns whether they bounce.
function touch.deflect(b, i, j, axis, lean, r, isLate, o, v, a, u, tau)
  local box, its = order(b, i, j)
  local way, change = o, max(v, 0.0)
  if r > 0 then
    way, change = o + r * u * tau - a * tau * tau * 0.5, v - a * tau + r * u
  elseif isLate or not isFloating(b, box) then
    return false
  end
  local k, t, shape = 2 * box + axis, 2 * box + 1 - axis, b.shape[its]
  local share = -SOLID[axis][shape] / (1 + lean * lean)
  b.deflectedAt[box] = b.solveStamp
  path.add(b, k, way * share, change * share)
  path.add(b, t, -way * share * lean, -change * share * lean)
  return true
end

return touch
