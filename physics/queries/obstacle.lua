--- Finds what blocks an object that moves without a step, for `sweep` and `move`. Uses only the
--- columns of the queries (see index.lua).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local circle = require(root .. ".memory.circle")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local sweep = require(root .. ".queries.sweptAabb")
local triangle = require(root .. ".memory.triangle")
local view = require(root .. ".queries.index")

require(root .. ".memory.jit").file()

local obstacle = {}

local SIDES, CIRCLE, EPSILON = columns.SIDES, columns.SHAPE_CIRCLE, columns.EPSILON
local floor, max = math.floor, math.max
-- Times of impact closer than 1 / MOMENTS of the way are simultaneous.
local MOMENTS = 1e9

--- Reads what decides which objects an object can meet. Errors: a field that cannot be used.
obstacle.look = view.lookAtFilter

--- Returns whether slot j can be met by slot i: another object, active, no mask between them. All
--- kinds can meet each other: nothing is pushed here.
function obstacle.isMet(v, i, j)
  if i == j or not v.active[j] then
    return false
  end
  view.lookAtFilter(v, j)
  return not (filter.refusal(v, i, j) or filter.refusal(v, j, i) or filter.isSoft(v, i, j))
end

--- Returns whether two objects that meet block each other.
function obstacle.isSolid(v, i, j)
  return not (v.sensor[i] or v.sensor[j])
end

--- Returns the names of the side of the moving object and of the other one.
function obstacle.sides(axis, isLow)
  local low, high = SIDES[2 * axis + 1], SIDES[2 * axis + 2]
  if isLow then
    return high, low
  end
  return low, high
end

-- Returns whether both objects are closed on the side that is hit.
local function isClosed(v, i, j, axis, isLow)
  local mine, its = obstacle.sides(axis, isLow)
  local oneWay, otherOneWay = v.oneWay[i], v.oneWay[j]
  return (not oneWay or oneWay == mine) and (not otherOneWay or otherOneWay == its)
end

-- As `obstacle.meet`, of the slope j.
local function meetSlope(v, i, j, x, y, toX, toY)
  local position, size, k, m = v.position, v.size, 2 * i, 2 * j
  local w, h, ow, oh = size[k], size[k + 1], size[m], size[m + 1]
  local ox, oy, shape, down = position[m], position[m + 1], v.shape[j], v.bodies.downAxis
  local rx, ry = x - ox, y - oy
  local share, face, isDeep = triangle.meet(shape, down, rx, ry, w, h, ow, oh, toX - x, toY - y)
  if not share then
    return nil
  end
  local _, most = triangle.nearest(shape, down, rx, ry, w, h, ow, oh)
  if isDeep or most < -EPSILON then
    if v.oneWay[i] or v.oneWay[j] then
      return nil
    end
    return 0, nil, nil, x, y, sweep.FACE
  end
  local isEdge = face == triangle.EDGE
  local axis, isLow = isEdge and down or face % 2, triangle.isLow(face, shape, down)
  if obstacle.isSolid(v, i, j) and not isClosed(v, i, j, axis, isLow) then
    return nil
  end
  local atX, atY = sweep.place(x, y, w, h, toX, toY, ox, oy, ow, oh, share, axis, isLow)
  if isEdge then
    atX, atY = obstacle.onEdge(v, i, j, x + (toX - x) * share, y + (toY - y) * share)
  end
  return share, axis, isLow, atX, atY, sweep.FACE, isEdge
end

--- Returns where object i, which is at (x, y), is flush with the edge of the slope j along gravity.
function obstacle.onEdge(v, i, j, x, y)
  local position, size, k, m, axis = v.position, v.size, 2 * i, 2 * j, v.bodies.downAxis
  local solid, shape, t = triangle.SOLID, v.shape[j], 1 - axis
  local across = axis == 1 and x or y
  local way = triangle.depth(
    solid[t][shape],
    position[m + t],
    size[m + t],
    size[m + axis],
    across,
    size[k + t]
  )
  local place = position[m + axis] + size[m + axis] - way
  if solid[axis][shape] > 0 then
    place = position[m + axis] + way - size[k + axis]
  end
  return axis == 1 and across or place, axis == 1 and place or across
end

-- Whether one of two is a circle. On a slope a circle is its box.
local function isRoundPair(v, i, j)
  return max(v.shape[i], v.shape[j]) == CIRCLE
end

-- `meet` for two of which one is a circle: the axis is that on which the normal is steeper.
local function meetRound(v, i, j, x, y, toX, toY)
  local position, size, shape, k, m = v.position, v.size, v.shape, 2 * i, 2 * j
  local isRound, isOtherRound = shape[i] == CIRCLE, shape[j] == CIRCLE
  local w, h, ox, oy, ow, oh =
    size[k], size[k + 1], position[m], position[m + 1], size[m], size[m + 1]
  if circle.overlap(x, y, w, h, isRound, ox, oy, ow, oh, isOtherRound, EPSILON) then
    return 0, nil, nil, x, y, sweep.FACE
  end
  local dx, dy = toX - x, toY - y
  local share, nx, ny =
    circle.meetPair(x, y, w, h, isRound, dx, dy, ox, oy, ow, oh, isOtherRound, EPSILON)
  if not share then
    return nil
  end
  local isLevel = nx * nx > ny * ny
  local isLow = (isLevel and nx or ny) < 0
  return share, isLevel and 0 or 1, isLow, x + dx * share, y + dy * share, sweep.FACE
end

--- Returns when object i on its way from (x, y) meets object j: fraction, axis, whether i has the
--- smaller coordinate, the place of i then, the kind of impact; nil: never. The axis is nil if they
--- overlap at the start. Of slopes, a further true: at the sloped edge.
function obstacle.meet(v, i, j, x, y, toX, toY)
  if v.hasCircles and isRoundPair(v, i, j) then
    return meetRound(v, i, j, x, y, toX, toY)
  end
  local position, size, k, m = v.position, v.size, 2 * i, 2 * j
  local w, h, ox, oy, ow, oh =
    size[k], size[k + 1], position[m], position[m + 1], size[m], size[m + 1]
  if v.shape[j] >= triangle.FIRST then
    return meetSlope(v, i, j, x, y, toX, toY)
  elseif sweep.overlap(x, y, w, h, ox, oy, ow, oh) then
    if v.oneWay[i] or v.oneWay[j] then
      return nil -- it is passing through
    end
    return 0, nil, nil, x, y, sweep.FACE
  end
  local share, axis, isLow, kind =
    sweep.meet(x, y, w, h, toX, toY, ox, oy, ow, oh, v.bodies.downAxis)
  if not share or (obstacle.isSolid(v, i, j) and not isClosed(v, i, j, axis, isLow)) then
    return nil
  end
  local atX, atY = sweep.place(x, y, w, h, toX, toY, ox, oy, ow, oh, share, axis, isLow)
  return share, axis, isLow, atX, atY, kind
end

--- Returns the unit normal from object j to object i, which is at (x, y), where one of them is a
--- circle; nil: both are boxes.
function obstacle.normal(v, i, j, x, y)
  local position, size, shape, k, m = v.position, v.size, v.shape, 2 * i, 2 * j
  if not isRoundPair(v, i, j) then
    return nil
  end
  local isRound, isOtherRound = shape[i] == CIRCLE, shape[j] == CIRCLE
  local ox, oy, ow, oh = position[m], position[m + 1], size[m], size[m + 1]
  local _, nx, ny = circle.gap(x, y, size[k], size[k + 1], isRound, ox, oy, ow, oh, isOtherRound)
  return nx, ny
end

--- Returns a number that puts impacts in order: by time, faces before corners, along gravity before
--- across. nil: never.
function obstacle.keyOf(v, i, j, x, y, toX, toY)
  local share, axis, _, _, _, kind = obstacle.meet(v, i, j, x, y, toX, toY)
  if not share then
    return nil
  end
  local moment = floor(share * MOMENTS + 0.5)
  if kind == sweep.CORNER then
    moment = moment + 2
  end
  local across = axis and axis ~= v.bodies.downAxis and 1 or 0
  return (moment * 2 + kind) * 2 + across
end

return obstacle
