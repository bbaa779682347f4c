--- Finds objects at a point, in a rectangle, near a point, or in the way of an object. (For lines
--- see rays.lua.) Queries see the game's tables as they are now (see index.lua) and change nothing.
--- They make no garbage unless they have to make the list that they return.
--
-- All queries have the same steps. The index offers candidates, each is tested exactly, and the
-- rest is put in order. A filter that is a function is called last, in that order, for as few
-- objects as possible.
--
-- Inactive objects are not found. Sensors are, except by `sweep`, which only solids stop.
--
-- A game may make a thousand queries a frame, and lists, `nearest` and `sweep` take another path
-- through the code each time. So the code that leads from one loop to the next is interpreted. The
-- loops over candidates are compiled, in functions of their own (see memory/jit.lua).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local circle = require(root .. ".memory.circle")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local obstacle = require(root .. ".queries.obstacle")
local results = require(root .. ".queries.results")
local sort = require(root .. ".memory.sort")
local triangle = require(root .. ".memory.triangle")
local view = require(root .. ".queries.index")

local query = {}

local EPSILON, CIRCLE = columns.EPSILON, columns.SHAPE_CIRCLE
local max, min, sqrt = math.max, math.min, math.sqrt
local keepNamed = results.keepNamed
local SLOPE = triangle.FIRST -- and above
-- px around a point that are searched first for the nearest object.
local FIRST_RADIUS = 32

-- Points and rectangles ---------------------------------------------------------------------------

-- px from a rectangle to the edge of the slope i; below 0: it is inside.
local function toEdge(v, i, x, y, w, h)
  local p, s, k = v.position, v.size, 2 * i
  local rx, ry = x - p[k], y - p[k + 1]
  return triangle.gap(triangle.EDGE, v.shape[i], 1, rx, ry, w, h, s[k], s[k + 1])
end

-- The square of the distance of a point from an object.
local function distanceTo(v, i, x, y)
  local position, size, k = v.position, v.size, 2 * i
  local left, top = position[k], position[k + 1]
  if v.shape[i] == CIRCLE then
    local r = size[k] * 0.5
    local far = max(sqrt(circle.square(x, y, left + r, top + r, left + r, top + r)) - r, 0.0)
    return far * far
  elseif v.shape[i] >= SLOPE then
    local its = triangle.distance(v.shape[i], x - left, y - top, size[k], size[k + 1])
    if its then
      return its
    end
  end
  return circle.square(x, y, left, top, left + size[k], top + size[k + 1])
end

-- Keeps of `found` what overlaps a circle by more than `depth`, but for slot `but`; returns how
-- many.
local function keepInCircle(v, found, count, x, y, radius, depth, but)
  local position, size, shape, active, n = v.position, v.size, v.shape, v.active, 0
  for m = 1, count do
    local i = found[m]
    local k = 2 * i
    local left, top, right, bottom = position[k], position[k + 1], size[k], size[k + 1]
    local reach = radius - depth
    if shape[i] == CIRCLE then
      reach = reach + right * 0.5
      left, top, right, bottom = left + right * 0.5, top + bottom * 0.5, 0.0, 0.0
    end
    local square = shape[i] >= SLOPE and distanceTo(v, i, x, y)
      or circle.square(x, y, left, top, left + right, top + bottom)
    if square < reach * max(reach, 0.0) and i ~= but and active[i] then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

-- Everything but slot `but` in a circle, in order.
local function inCircle(v, world, x, y, radius, but, filter, out)
  local found = results.take(v)
  local depth, reach = world.sideBySide and -EPSILON or EPSILON, radius + EPSILON
  local n = view.near(v, world, x - reach, y - reach, x + reach, y + reach, found)
  n = keepNamed(v, found, keepInCircle(v, found, n, x, y, radius, depth, but), filter)
  sort.by(found, n, v.rank, v.rank, v.rank)
  return results.publish(v, found, n, filter, out)
end

-- Keeps in `found` the objects around a point; returns how many.
local function keepAround(v, found, count, x, y)
  local position, size, active, n = v.position, v.size, v.active, 0
  for m = 1, count do
    local i = found[m]
    local k = 2 * i
    local left, top = position[k], position[k + 1]
    if
      aabb.inside(x, y, 0, 0, left, top, size[k], size[k + 1])
      and active[i]
      and (v.shape[i] < SLOPE or toEdge(v, i, x, y, 0, 0) <= 0)
    then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

-- Keeps of `found` all but circles that a point is not in; returns how many.
local function keepRoundAround(v, found, count, x, y)
  local n = 0
  for m = 1, count do
    local i = found[m]
    if v.shape[i] ~= CIRCLE or distanceTo(v, i, x, y) == 0 then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

--- Returns the objects around a point. Left and top edges belong to an object, right and bottom
--- ones do not.
function query.point(world, x, y, filter, out)
  local v = view.of(world)
  local found = results.take(v)
  local n = keepAround(v, found, view.near(v, world, x, y, x, y, found), x, y)
  if v.hasCircles then
    n = keepRoundAround(v, found, n, x, y)
  end
  n = keepNamed(v, found, n, filter)
  sort.by(found, n, v.rank, v.rank, v.rank)
  return results.publish(v, found, n, filter, out)
end

-- Keeps in `found` the objects that overlap a rectangle by more than `depth`, except slot `but`;
-- returns how many.
local function keepOverlapping(v, found, count, x, y, w, h, depth, but)
  local position, size, active, n = v.position, v.size, v.active, 0
  for m = 1, count do
    local i = found[m]
    local k = 2 * i
    local width, height =
      aabb.overlap(x, y, w, h, position[k], position[k + 1], size[k], size[k + 1])
    if
      min(width, height) > depth
      and i ~= but
      and active[i]
      and (v.shape[i] < SLOPE or toEdge(v, i, x, y, w, h) < -depth)
    then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

-- Keeps of `found` all but circles that a rectangle does not meet by more than `depth`.
local function keepRoundOverlapping(v, found, count, x, y, w, h, depth)
  local position, size, n = v.position, v.size, 0
  for m = 1, count do
    local i = found[m]
    local r = size[2 * i] * 0.5
    local centerX, centerY, reach = position[2 * i] + r, position[2 * i + 1] + r, r - depth
    if
      v.shape[i] ~= CIRCLE
      or circle.square(centerX, centerY, x, y, x + w, y + h) < reach * reach
    then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

-- Returns the objects in a rectangle except slot `but`, in the order of the world.
local function inRectangle(v, world, x, y, w, h, but, filter, out)
  local found = results.take(v)
  -- Flush means within a millionth of a pixel, on either side.
  local depth = world.sideBySide and -EPSILON or EPSILON
  local left, top, right, bottom = x - EPSILON, y - EPSILON, x + w + EPSILON, y + h + EPSILON
  local n = view.near(v, world, left, top, right, bottom, found)
  n = keepOverlapping(v, found, n, x, y, w, h, depth, but)
  if v.hasCircles then
    n = keepRoundOverlapping(v, found, n, x, y, w, h, depth)
  end
  n = keepNamed(v, found, n, filter)
  sort.by(found, n, v.rank, v.rank, v.rank)
  return results.publish(v, found, n, filter, out)
end

--- Returns the objects that overlap a rectangle.
function query.rectangle(world, x, y, w, h, filter, out)
  return inRectangle(view.of(world), world, x, y, w, h, 0, filter, out)
end

-- Keeps of `found` what is solid on all sides; with i ~= 0: for slot i, as far as masks allow.
local function keepSolid(v, found, count, i)
  local n = 0
  for m = 1, count do
    local j = found[m]
    view.lookAtFilter(v, j)
    if
      not (v.sensor[j] or v.oneWay[j])
      and (i == 0 or (obstacle.isMet(v, i, j) and obstacle.isSolid(v, i, j)))
    then
      n = n + 1
      found[n] = j
    end
  end
  return n
end

--- The first solid object in a rectangle, nil: it is free. `filter` may be the object that would be
--- there; if it is not in the world, the second value is false.
function query.blocker(world, x, y, w, h, filter)
  local v, i = view.of(world), 0
  if type(filter) == "table" and type(filter.width) == "number" then
    i = view.find(v, world, filter)
    if not i then
      return nil, false
    end
    obstacle.look(v, i)
    filter = nil
  end
  local found = results.take(v)
  local n = view.near(v, world, x, y, x + w, y + h, found)
  n = keepOverlapping(v, found, n, x, y, w, h, EPSILON, i)
  if v.hasCircles then
    n = keepRoundOverlapping(v, found, n, x, y, w, h, EPSILON)
  end
  n = keepSolid(v, found, keepNamed(v, found, n, filter), i)
  local entry = v.entry
  for m = 1, n do
    entry[found[m]] = 0
  end
  local hit = results.pick(v, found, n, filter)
  results.give(v, found)
  return hit and v.object[hit], true
end

--- Everything that overlaps a circle.
function query.circle(world, x, y, radius, filter, out)
  return inCircle(view.of(world), world, x, y, radius, 0, filter, out)
end

--- Returns the objects that overlap an object; nil: it is not in the world.
function query.overlapping(world, object, filter, out)
  local v = view.of(world)
  local i = view.find(v, world, object)
  if not i then
    return nil
  elseif not v.active[i] then
    return results.publish(v, results.take(v), 0, filter, out)
  end
  local p, s, k = v.position, v.size, 2 * i
  if v.shape[i] == CIRCLE then
    local r = s[k] * 0.5
    return inCircle(v, world, p[k] + r, p[k + 1] + r, r, i, filter, out)
  end
  return inRectangle(v, world, p[k], p[k + 1], s[k], s[k + 1], i, filter, out)
end

-- Near --------------------------------------------------------------------------------------------

-- Keeps in `found` the objects further from a point than `last`, but not further than `most`
-- (squares), with their distance as `entry`; returns how many.
local function keepWithin(v, found, count, x, y, last, most)
  local entry, active, n = v.entry, v.active, 0
  for m = 1, count do
    local i = found[m]
    local distance = distanceTo(v, i, x, y)
    if distance <= most and distance > last and active[i] then
      n = n + 1
      found[n], entry[i] = i, distance
    end
  end
  return n
end

--- Returns the nearest object and its distance. A growing square is searched, so that an object
--- nearby costs little, however large the radius is.
function query.nearest(world, x, y, radius, filter)
  local v = view.of(world)
  local found = results.take(v)
  local reach, last, hit = min(FIRST_RADIUS, radius), -1
  repeat
    local n = view.near(v, world, x - reach, y - reach, x + reach, y + reach, found)
    n = keepNamed(v, found, keepWithin(v, found, n, x, y, last, reach * reach), filter)
    hit = results.pick(v, found, n, filter)
    local isLast = reach >= radius
    last, reach = reach * reach, min(reach * 4, radius)
  until hit or isLast
  results.give(v, found)
  if hit then
    return v.object[hit], sqrt(distanceTo(v, hit, x, y))
  end
end

-- In the way --------------------------------------------------------------------------------------

-- Keeps in `found` the objects that stop an object on its way; writes their order into `entry`.
local function keepStopping(v, found, count, i, toX, toY)
  local entry, n = v.entry, 0
  for m = 1, count do
    local j = found[m]
    if obstacle.isMet(v, i, j) and obstacle.isSolid(v, i, j) then
      local key = obstacle.keyOf(v, i, j, v.position[2 * i], v.position[2 * i + 1], toX, toY)
      if key then
        n = n + 1
        found[n], entry[j] = j, key
      end
    end
  end
  return n
end

local function describeStop(v, i, j, toX, toY)
  local p, k = v.position, 2 * i
  local share, axis, isLow, x, y, _, isEdge = obstacle.meet(v, i, j, p[k], p[k + 1], toX, toY)
  if not axis then
    return v.object[j], x, y, 0, 0, 0
  elseif isEdge then
    local nx, ny = triangle.normal(v.shape[j], v.size[2 * j], v.size[2 * j + 1])
    return v.object[j], x, y, nx, ny, share
  end
  local nx, ny = obstacle.normal(v, i, j, x, y)
  if nx then
    return v.object[j], x, y, nx + 0, ny + 0, share
  end
  local normal = isLow and -1 or 1
  return v.object[j], x, y, axis == 0 and normal or 0, axis == 1 and normal or 0, share
end

--- Returns what would stop an object on its way by (dx, dy): object, x, y, nx, ny, fraction. If the
--- object is not in the world, it returns nil, false.
function query.sweep(world, object, dx, dy, filter)
  local v = view.of(world)
  local i = view.find(v, world, object)
  if not i then
    return nil, false
  end
  obstacle.look(v, i)
  if not v.active[i] then
    return nil
  end
  local found = results.take(v)
  local x, y = v.position[2 * i], v.position[2 * i + 1]
  local n = view.onWay(v, world, i, x, y, x + dx, y + dy, found)
  n = keepStopping(v, found, keepNamed(v, found, n, filter), i, x + dx, y + dy)
  local hit = results.pick(v, found, n, filter)
  results.give(v, found)
  if hit then
    return describeStop(v, i, hit, x + dx, y + dy)
  end
end

interpreted.functions(
  keepSolid,
  query.blocker,
  query.nearest,
  keepStopping,
  describeStop,
  query.sweep
)

return query
