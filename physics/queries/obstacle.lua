--- Finds what blocks an object that moves without a step, for `sweep` and `move`. Uses only the
--- columns of the queries (see index.lua).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local sweep = require(root .. ".queries.sweptAabb")
local view = require(root .. ".queries.index")

require(root .. ".memory.jit").file()

local obstacle = {}

local SIDES = columns.SIDES
local floor = math.floor
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

--- Returns when object i on its way from (x, y) meets object j: fraction, axis, whether i has the
--- smaller coordinate, the place of i then, the kind of impact; nil: never. The axis is nil if they
--- overlap at the start.
function obstacle.meet(v, i, j, x, y, toX, toY)
  local position, size, k, m = v.position, v.size, 2 * i, 2 * j
  local w, h, ox, oy, ow, oh =
    size[k], size[k + 1], position[m], position[m + 1], size[m], size[m + 1]
  if sweep.overlap(x, y, w, h, ox, oy, ow, oh) then
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
