--- Slopes: right triangles, on which bodies stand as on stairs with infinitely small steps.
--
-- A contact with the sloped edge is one along gravity (along y without gravity), and no other than
-- that of two boxes, but for its separation: how far the two must be apart depends on where the
-- corner of the box is across gravity. So friction, stacks, belts and one-ways need no rule of
-- their own. `walk` moves what stands on slopes along them. The sweep meets slopes by `meetAny`,
-- and an impact is turned along them by `deflect`.
--
-- Reads the paths, slope; writes to, speed, deflectedAt.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local path = require(root .. ".motion.path")
local triangle = require(root .. ".memory.triangle")

local slope = {}

local EPSILON, DYNAMIC = columns.EPSILON, columns.DYNAMIC
local FIRST, SOLID, EDGE = triangle.FIRST, triangle.SOLID, triangle.EDGE
local depth = triangle.depth
local max, min = math.max, math.min
-- Impacts of a body in a step until which it is deflected without gravity.
local DEFLECTED = 3
-- Fraction of a step that ends of pieces may be off.
local TIE = 1e-9

--- Returns whether slot i is a slope.
function slope.isOne(b, i)
  return b.shape[i] >= FIRST
end

--- Returns whether one of two slots is a slope. (Two slopes, of which one is a sensor, are boxes.)
function slope.isPair(b, i, j)
  return (b.shape[i] >= FIRST) ~= (b.shape[j] >= FIRST)
end

--- Returns the box and the slope of a pair.
function slope.order(b, i, j)
  if b.shape[j] >= FIRST then
    return i, j
  end
  return j, i
end

local order = slope.order

--- Returns the axis along which slot i stands on slopes.
function slope.axisOf(b, i)
  return b.down[2 * i] ~= 0 and 0 or 1
end

local axisOf = slope.axisOf

--- Returns whether slot j is a slope that bears what gravity on that side of an axis (`sign`)
--- presses on it.
function slope.bears(b, j, axis, sign)
  return b.shape[j] >= FIRST and SOLID[axis][b.shape[j]] == sign
end

--- Returns px by which slope j is lower than its crest under body k, which is at x across.
function slope.fall(b, k, j, x)
  local axis = k % 2
  local t, tj, size = k + 1 - 2 * axis, 2 * j + 1 - axis, b.size
  return depth(SOLID[1 - axis][b.shape[j]], b.to[tj], size[tj], size[2 * j + axis], x, size[t])
end

--- Returns how far apart the low one and the high one of box i and slope j must be on an axis, when
--- the box is at `place` across it and the slope at `its`.
function slope.separation(b, i, j, axis, place, its)
  local size, ki, kj = b.size, 2 * i + axis, 2 * j + axis
  local ti, tj = 2 * i + 1 - axis, 2 * j + 1 - axis
  local shape = b.shape[j]
  local way = depth(SOLID[1 - axis][shape], its, size[tj], size[kj], place, size[ti])
  if SOLID[axis][shape] > 0 then
    return size[ki] - way
  end
  return size[kj] - way
end

local separation = slope.separation

-- Which face of slope j box i at (x, y) is furthest beyond, and px to that.
local function nearest(b, i, j, x, y, ox, oy)
  local size, k, m = b.size, 2 * i, 2 * j
  return triangle.nearest(
    b.shape[j],
    axisOf(b, i),
    x - ox,
    y - oy,
    size[k],
    size[k + 1],
    size[m],
    size[m + 1]
  )
end

--- Returns the face of slope j on which box i is flush, or inside by less than all others, as an
--- axis and whether the box is low; px to it; nil as the first: it is apart, or flush with a corner
--- only.
function slope.touch(b, i, j, places)
  local axis, k, m = axisOf(b, i), 2 * i, 2 * j
  local x, y, ox, oy = places[k], places[k + 1], places[m], places[m + 1]
  local face, gap = nearest(b, i, j, x, y, ox, oy)
  if gap > EPSILON then
    return nil, nil, gap
  end
  local q = face == EDGE and axis or face % 2
  if gap >= -EPSILON then
    local t = 1 - q
    local edge = min(places[k + t] + b.size[k + t], places[m + t] + b.size[m + t])
      - max(places[k + t], places[m + t])
    if edge <= EPSILON then
      return nil, nil, gap
    end
  end
  return q, triangle.isLow(face, b.shape[j], axis), gap
end

-- The px that box i and slope j must be apart where they meet on an axis: flush with the edge or
-- the top of the triangle, or with the side of its box.
local function apartOn(b, i, j, q, isLow, place, its)
  local isEdge = q == axisOf(b, i) and isLow == (SOLID[q][b.shape[j]] > 0)
  if isEdge then
    return separation(b, i, j, q, place, its)
  end
  return b.size[2 * (isLow and i or j) + q]
end

slope.apartOn = apartOn

-- Whether no gravity presses slot i to anything: the edge of a slope is a wall for it.
local function isFloating(b, i)
  return b.down[2 * i] == 0 and b.down[2 * i + 1] == 0
end

-- How much further along its axis the edge of slope j is below box i for each px across it; 0: the
-- box is beyond the crest.
local function gradient(b, i, j, places)
  local axis, size, shape = axisOf(b, i), b.size, b.shape[j]
  local k, m, t = 2 * i, 2 * j, 1 - axis
  local beyond = places[k + t] + size[k + t] - places[m + t] - size[m + t]
  if SOLID[t][shape] < 0 then
    beyond = places[m + t] - places[k + t]
  end
  return beyond < -EPSILON and triangle.slant(shape, axis, size[m], size[m + 1]) or 0
end

--- Returns the gradient of the ground, slot j, under slot i: px along gravity for each px across
--- it.
function slope.gradient(b, i, j)
  local axis = axisOf(b, i)
  if b.shape[j] < FIRST or SOLID[axis][b.shape[j]] ~= b.down[2 * i + axis] then
    return 0
  end
  return gradient(b, i, j, b.position)
end

--- Returns for two that touch where the step begins: axis, low and high index, px that they must be
--- apart; nil: they do not.
function slope.contact(b, p)
  local i, j = order(b, b.pairA[p], b.pairB[p])
  local from = b.from
  local q, isLow, gap = slope.touch(b, i, j, from)
  local isAside = q == axisOf(b, i) and isFloating(b, i)
  if not q or gap < -EPSILON or isAside and gradient(b, i, j, from) ~= 0 then
    return nil -- what is inside, or floats, is left to the sweep
  end
  local kl, kh = 2 * (isLow and i or j) + q, 2 * (isLow and j or i) + q
  return q, kl, kh, apartOn(b, i, j, q, isLow, from[2 * i + 1 - q], from[2 * j + 1 - q])
end

--- Returns the side of slot i at which the two are flush at the end of the step, else 0; -1: they
--- are inside each other.
function slope.side(b, i, j)
  local box, its = order(b, i, j)
  local q, isLow, gap = slope.touch(b, box, its, b.to)
  if gap < -EPSILON then
    return -1
  elseif not q then
    return 0
  end
  if box ~= i then
    isLow = not isLow
  end
  return 2 * q + (isLow and 2 or 1)
end

--- Returns px by which box i is inside slope j, along the nearest face; below 0: it is apart.
function slope.inside(b, i, j, x, y)
  local from, m = b.from, 2 * j
  local _, gap = nearest(b, i, j, x, y, from[m], from[m + 1])
  return -gap
end

--- Returns the axis along which box i leaves slope j over the sloped edge, and the direction.
function slope.wayOut(b, i, j)
  local axis = axisOf(b, i)
  return axis, -SOLID[axis][b.shape[j]]
end

--- Returns where one of two, of which one is a slope, is flush with the other on an axis, on the
--- low side of it (`sign` -1) or the high one.
function slope.flushPlace(b, i, j, axis, sign)
  local from, m = b.from, 2 * j + axis
  local box, its = order(b, i, j)
  local isLow = (sign < 0) == (box == i)
  local t = 1 - axis
  local apart = apartOn(b, box, its, axis, isLow, from[2 * box + t], from[2 * its + t])
  return from[m] + sign * apart
end

--- When two of which one is a slope meet, as `sweep.meet`: moment, axis, whether the first is the
--- low one, whether they are inside each other.
function slope.meet(b, one, other)
  local i, j = order(b, one, other)
  local axis, k, m = axisOf(b, i), 2 * i, 2 * j
  local startI, startJ, to = b.time[i], b.time[j], b.to
  local start = max(startI, startJ)
  local x, y = path.at(b, k, startI, start), path.at(b, k + 1, startI, start)
  local ox, oy = path.at(b, m, startJ, start), path.at(b, m + 1, startJ, start)
  local share, face, isDeep = triangle.meet(
    b.shape[j],
    axis,
    x - ox,
    y - oy,
    b.size[k],
    b.size[k + 1],
    b.size[m],
    b.size[m + 1],
    to[k] - to[m] - (x - ox),
    to[k + 1] - to[m + 1] - (y - oy)
  )
  if not share then
    return nil
  end
  local isLow = triangle.isLow(face, b.shape[j], axis)
  if i ~= one then
    isLow = not isLow
  end
  return start + (1 - start) * share, face == EDGE and axis or face % 2, isLow, isDeep
end

--- Returns how far apart two that meet on an axis must be at the end of the step, and how much
--- faster they close for each px/s that the second goes across it, relative to the first.
function slope.lean(b, i, j, axis)
  local box, its = order(b, i, j)
  local shape, to, size, t = b.shape[its], b.to, b.size, 1 - axis
  local isLow = i == box -- i is the low one of the impact
  local apart = apartOn(b, box, its, axis, isLow, to[2 * box + t], to[2 * its + t])
  if axis ~= axisOf(b, box) or isLow ~= (SOLID[axis][shape] > 0) then
    return apart, 0.0
  end
  -- The crest is level.
  local place = path.at(b, 2 * its + t, b.time[its], b.time[box])
  local beyond = b.from[2 * box + t] + size[2 * box + t] - place - size[2 * its + t]
  if SOLID[t][shape] < 0 then
    beyond = place - b.from[2 * box + t]
  end
  if beyond > EPSILON then
    return apart, 0.0
  end
  return apart, triangle.slant(shape, axis, size[2 * its], size[2 * its + 1])
end

--- Whether two that meet at a sloped edge bounce, or slide, along its normal: with restitution r,
--- or without gravity, unless others press them there. `lean` is what `slope.lean` says.
function slope.isDeflected(b, i, j, lean, r, isLate)
  local box = order(b, i, j)
  return lean ~= 0
    and (r > 0 or (isFloating(b, box) and b.impactsOf[box] <= DEFLECTED and not isLate))
end

--- Returns the part of a common edge, from `low` to `high`, on which box i touches slope j with its
--- side `side`: all, or the corner that is on the sloped edge.
function slope.narrow(b, i, j, side, low, high)
  local axis, shape = columns.AXIS[side], b.shape[j]
  if axis ~= axisOf(b, i) or (side % 2 == 0) ~= (SOLID[axis][shape] > 0) then
    return low, high
  elseif SOLID[1 - axis][shape] > 0 then
    return high, high
  end
  return low, low
end

--- Returns px by which two overlap along the edge, as if that had no ends, at the end of the step.
function slope.overlap(b, i, j, axis)
  local box, its = order(b, i, j)
  local to, size, k, m = b.to, b.size, 2 * box, 2 * its
  local x, y = to[k] - to[m], to[k + 1] - to[m + 1]
  local w, h, ow, oh = size[k], size[k + 1], size[m], size[m + 1]
  return -triangle.gap(EDGE, b.shape[its], axis, x, y, w, h, ow, oh)
end

--- Deflects one of two that meet at a sloped edge, along the normal of that: at the end of the step
--- they overlap by o px along the axis, close at v px/s and accelerate towards each other by a;
--- they have met at u px/s, tau s before.
function slope.deflect(b, i, j, axis, lean, r, o, v, a, u, tau)
  local box, its = order(b, i, j)
  local way, change = o, max(v, 0.0)
  if r > 0 then
    way, change = o + r * u * tau - a * tau * tau * 0.5, v - a * tau + r * u
  end
  local k, t, shape = 2 * box + axis, 2 * box + 1 - axis, b.shape[its]
  local share = -SOLID[axis][shape] / (1 + lean * lean)
  b.deflectedAt[box] = b.solveStamp
  if b.give[k] > 0 then
    b.to[k], b.to[t] = b.to[k] + way * share, b.to[t] - way * share * lean
    b.speed[k], b.speed[t] = b.speed[k] + change * share, b.speed[t] - change * share * lean
  end
end

-- A walker and something immovable: piece by piece of its way, each taken as a path that goes on
-- until the end of the step.
local function meetPieces(b, i, j, meet)
  local axis, from, to, time = axisOf(b, i), b.from, b.to, b.time
  local k, t, turn = 2 * i + axis, 2 * i + 1 - axis, b.down[2 * i + axis]
  local height, place, endHeight, endPlace, start = from[k], from[t], to[k], to[t], time[i]
  local way, last = endPlace - place, b.pieceLast[i]
  local moment, isLow, isDeep, q
  for n = b.pieceFirst[i], last do
    local x, y = b.piecePlace[n], turn * b.pieceHeight[n]
    local share = (x - place) / way
    local past = start + (1 - start) * share
    if past > time[i] and way ~= 0 then
      local more = (1 - time[i]) / (past - time[i])
      to[t], to[k] = from[t] + (x - from[t]) * more, from[k] + (y - from[k]) * more
      moment, q, isLow, isDeep = meet(b, i, j)
      if moment and n < last and moment >= past - TIE - EPSILON / max(way, -way) then
        moment = nil -- beyond this piece
      end
      if moment then
        break
      end
      from[t], from[k], time[i] = x, y, past
    end
  end
  from[k], from[t], to[k], to[t], time[i] = height, place, endHeight, endPlace, start
  return moment, q, isLow, isDeep
end

--- As `meet`, which is that of two boxes or of circles, in a world with slopes.
function slope.meetAny(b, one, other, meet)
  local its = slope.isPair(b, one, other) and slope.meet or meet
  if b.pieceLast[one] > 0 and b.kind[other] ~= DYNAMIC then
    local t, axis, isLow, isDeep = meetPieces(b, one, other, its)
    return t, axis, isLow, isDeep
  elseif b.pieceLast[other] > 0 and b.kind[one] ~= DYNAMIC then
    local t, axis, isLow, isDeep = meetPieces(b, other, one, its)
    return t, axis, t and not isLow, isDeep
  end
  return its(b, one, other)
end

return slope
