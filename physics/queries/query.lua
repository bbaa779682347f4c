--- Finds objects at a point, in a rectangle, on a line, near a point, or in the way of an object.
--- Queries see the game's tables as they are now (see index.lua) and change nothing. They make no
--- garbage unless they have to make the list that they return.
--
-- All queries have the same steps. The index offers candidates, each is tested exactly, and the
-- rest is put in order. A filter that is a function is called last, in that order, for as few
-- objects as possible.
--
-- Inactive objects are not found. Sensors are, except by `sweep`, which only solids stop.
--
-- A game may make a thousand queries a frame, and lists, `nearest` and `sweep` take another path
-- through the code each time. So the code that leads from one loop to the next is interpreted. The
-- loops over candidates are compiled, in functions of their own (see memory/jit.lua). Rays are
-- compiled as a whole, since most of them take one of a few paths; those with a filter function are
-- not.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local aabb = require(root .. ".memory.aabb")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local obstacle = require(root .. ".queries.obstacle")
local sort = require(root .. ".memory.sort")
local view = require(root .. ".queries.index")

local query = {}

local EPSILON, TINY, VAST = columns.EPSILON, columns.TINY, columns.VAST
local max, min, sqrt = math.max, math.min, math.sqrt
local TIE = 1e-9
-- Larger than the whole of a line, which is 1: the fraction at which a line hits an object that it
-- misses.
local NEVER = 2
-- px of a ray that are searched first; each further piece is twice as long.
local FIRST_PIECE = 48
-- px around a point that are searched first for the nearest object.
local FIRST_RADIUS = 32

-- Filters and results -----------------------------------------------------------------------------

-- Returns whether a filter that is no function accepts a group of that name.
local function isNamed(filter, name)
  if type(filter) ~= "table" then
    return filter == name
  end
  local at = 1
  while filter[at] ~= nil and filter[at] ~= name do
    at = at + 1
  end
  return filter[at] ~= nil
end

-- Keeps the objects that a filter accepts if it is no function; a function is called later.
local function keepNamed(v, found, count, filter)
  if filter == nil or type(filter) == "function" then
    return count
  end
  local groupName, n = v.groupName, 0
  for m = 1, count do
    local i = found[m]
    if isNamed(filter, groupName[i]) then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

local function accepts(v, i, filter)
  local object = v.object[i]
  -- A filter function may have found that the object has left.
  return object and filter(object)
end

local function writeAll(v, found, count, out)
  local objects = v.object
  for n = 1, count do
    out[n] = objects[found[n]]
  end
  return count
end

-- Writes the objects that a filter function accepts; returns how many.
local function writeAccepted(v, found, count, filter, out)
  local n = 0
  for m = 1, count do
    if accepts(v, found[m], filter) then
      n = n + 1
      out[n] = v.object[found[m]]
    end
  end
  return n
end

-- Removes the entries of a list behind place n.
local function shorten(out, n)
  for m = #out, n + 1, -1 do
    out[m] = nil
  end
end

-- Writes the objects in `found` that the filter accepts into `out`, in the order of `found`.
local function publish(v, found, count, filter, out)
  out = out or {}
  local n
  if type(filter) == "function" then
    n = writeAccepted(v, found, count, filter, out)
  else
    n = writeAll(v, found, count, out)
  end
  if #out > n then
    shorten(out, n)
  end
  view.give(v, found)
  return out, n
end

-- Returns the first of `found`, by `entry`, then in the order of the world.
local function first(v, found, count)
  local entry, rank, best = v.entry, v.rank, found[1]
  for n = 2, count do
    local i = found[n]
    if entry[i] < entry[best] or (entry[i] == entry[best] and rank[i] < rank[best]) then
      best = i
    end
  end
  return best
end

-- Returns the first slot that the filter accepts; nil: none.
local function pick(v, found, count, filter)
  if type(filter) ~= "function" then
    return count > 0 and first(v, found, count) or nil
  end
  sort.by(found, count, v.entry, v.rank, v.rank)
  for n = 1, count do
    if accepts(v, found[n], filter) then
      return found[n]
    end
  end
end

-- Points and rectangles ---------------------------------------------------------------------------

-- Keeps in `found` the objects around a point; returns how many.
local function keepAround(v, found, count, x, y)
  local position, size, active, n = v.position, v.size, v.active, 0
  for m = 1, count do
    local i = found[m]
    local k = 2 * i
    local left, top = position[k], position[k + 1]
    if aabb.inside(x, y, 0, 0, left, top, size[k], size[k + 1]) and active[i] then
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
  local found = view.take(v)
  local n = keepAround(v, found, view.near(v, world, x, y, x, y, found), x, y)
  n = keepNamed(v, found, n, filter)
  sort.by(found, n, v.rank, v.rank, v.rank)
  return publish(v, found, n, filter, out)
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
    if min(width, height) > depth and i ~= but and active[i] then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

-- Returns the objects in a rectangle except slot `but`, in the order of the world.
local function inRectangle(v, world, x, y, w, h, but, filter, out)
  local found = view.take(v)
  -- Flush means within a millionth of a pixel, on either side.
  local depth = world.sideBySide and -EPSILON or EPSILON
  local left, top, right, bottom = x - EPSILON, y - EPSILON, x + w + EPSILON, y + h + EPSILON
  local n = view.near(v, world, left, top, right, bottom, found)
  n = keepNamed(v, found, keepOverlapping(v, found, n, x, y, w, h, depth, but), filter)
  sort.by(found, n, v.rank, v.rank, v.rank)
  return publish(v, found, n, filter, out)
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
  local found = view.take(v)
  local n = view.near(v, world, x, y, x + w, y + h, found)
  n = keepNamed(v, found, keepOverlapping(v, found, n, x, y, w, h, EPSILON, i), filter)
  n = keepSolid(v, found, n, i)
  local entry = v.entry
  for m = 1, n do
    entry[found[m]] = 0
  end
  local hit = pick(v, found, n, filter)
  view.give(v, found)
  return hit and v.object[hit], true
end

--- Returns the objects that overlap an object; nil: it is not in the world.
function query.overlapping(world, object, filter, out)
  local v = view.of(world)
  local i = view.find(v, world, object)
  if not i then
    return nil
  elseif not v.active[i] then
    return publish(v, view.take(v), 0, filter, out)
  end
  local p, s, k = v.position, v.size, 2 * i
  return inRectangle(v, world, p[k], p[k + 1], s[k], s[k + 1], i, filter, out)
end

-- Lines -------------------------------------------------------------------------------------------

-- Returns where a line begins on an axis, and its length there. A line along an edge belongs to the
-- box below it or to its right, so that it slips through no seam. The shift is a millionth of a
-- pixel.
local function begins(p, d)
  return d == 0 and p + EPSILON or p, d == 0 and TINY or d
end

-- Returns where a line from (x, y) by (dx, dy), shifted by `begins`, enters and leaves a box. It
-- divides, since the result goes to the game; `aabb.passage` is rounded twice. The code has no
-- branches, so that one trace serves all lines.
local function passage(v, i, x, y, dx, dy)
  local position, size, k = v.position, v.size, 2 * i
  local left, top = position[k] - x, position[k + 1] - y
  local right, bottom = position[k] + size[k] - x, position[k + 1] + size[k + 1] - y
  local a, b, c, d = left / dx, right / dx, top / dy, bottom / dy
  return max(min(a, b), min(c, d)), min(max(a, b), max(c, d))
end

-- Returns a line: a working list for the objects that it hits, with its data. `filter` is the
-- query's filter, or false if that is a function, which is called later.
local function takeLine(v, x1, y1, x2, y2, filter)
  local line = view.take(v)
  line.view, line.from, line.to = v, -1, 1
  line.x, line.dx = begins(x1, x2 - x1)
  line.y, line.dy = begins(y1, y2 - y1)
  line.filter = type(filter) ~= "function" and filter
  return line
end

-- Returns the fraction of the line at which it hits slot i, after `from` and up to `to`; NEVER: it
-- does not. An object at the very beginning is hit at 0, which is after any `from` < 0.
local function hitAt(line, v, i)
  local enters, leaves = passage(v, i, line.x, line.y, line.dx, line.dy)
  local start = max(enters, 0)
  if
    min(leaves - enters, leaves) > 0
    and start > line.from
    and start <= line.to
    and v.active[i]
    and (not line.filter or isNamed(line.filter, v.groupName[i]))
  then
    return start
  end
  return NEVER
end

-- Notes the first object that is hit; of several at the same place, the first in the order of the
-- world.
local function visitFirst(line, i, bound)
  local v, best = line.view, line.best
  if not view.see(v, i) then
    line.isStale = true
    return -1
  end
  local at = hitAt(line, v, i)
  if at < bound or (at == bound and (best == 0 or v.rank[i] < v.rank[best])) then
    line.best = i
    return at
  end
  return bound
end

-- Lists every object that is hit, with its `entry`.
local function visitAll(line, i, bound)
  local v = line.view
  if not view.see(v, i) then
    line.isStale = true
    return -1
  end
  local at = hitAt(line, v, i)
  if at < NEVER then
    local n = line.count + 1
    line.count, line[n], v.entry[i] = n, i, at
  end
  return bound
end

--- Returns the objects on a line, nearest first.
function query.segment(world, x1, y1, x2, y2, filter, out)
  local v = view.of(world)
  local line = takeLine(v, x1, y1, x2, y2, filter)
  view.walk(v, world, x1, y1, x2, y2, line, visitAll)
  sort.by(line, line.count, v.entry, v.rank, v.rank)
  return publish(v, line, line.count, filter, out)
end

-- Returns whether an object fills the quarter beside a point towards (sx, sy).
local function isFilled(v, found, count, x, y, sx, sy)
  local position, size = v.position, v.size
  for n = 1, count do
    local i = found[n]
    local k = 2 * i
    local left, top = position[k] - x, position[k + 1] - y
    local right, bottom = left + size[k], top + size[k + 1]
    local isBeside = sx > 0 and left <= EPSILON and right > EPSILON
      or sx < 0 and left < -EPSILON and right >= -EPSILON
    local isBelow = sy > 0 and top <= EPSILON and bottom > EPSILON
      or sy < 0 and top < -EPSILON and bottom >= -EPSILON
    if isBeside and isBelow and v.active[i] then
      return true
    end
  end
  return false
end

-- Returns the axis of the face that is hit by a line through a corner: the one that no neighbour
-- covers, else the axis of gravity.
--
--        .     +---+    The line meets two tiles of a wall where they join: the top edge of the
--          .   |   |    lower one is covered by the upper one, so it hits the wall.
--            . +---+
--              |   |
local function cornerAxis(v, world, x, y, dx, dy, filter)
  local found = view.take(v)
  local reach = 2 * EPSILON
  local n = view.near(v, world, x - reach, y - reach, x + reach, y + reach, found)
  n = keepNamed(v, found, n, filter)
  local sx, sy = dx > 0 and 1 or -1, dy > 0 and 1 or -1
  local coversY = isFilled(v, found, n, x, y, sx, -sy)
  local coversX = isFilled(v, found, n, x, y, -sx, sy)
  view.give(v, found)
  if coversX == coversY then
    return v.bodies.downAxis
  end
  return coversX and 1 or 0
end

-- Returns where a line enters a box on the axis of k, as in `passage`; -1 if it does not move on
-- it.
local function enterOn(v, k, p, d)
  if d == 0 then
    return -1
  end
  local low, high = v.position[k] - p, v.position[k] + v.size[k] - p
  return min(low / d, high / d)
end

-- Returns what a ray reports about the object that it hits. There are no branches for the sides:
-- each would lead to a trace of its own for all that the game does with the answer.
local function describeHit(v, world, i, x1, y1, dx, dy, filter)
  local inX, inY = enterOn(v, 2 * i, x1, dx), enterOn(v, 2 * i + 1, y1, dy)
  local at = max(inX, inY)
  if at < 0 then
    return v.object[i], x1, y1, 0, 0, 0
  end
  at = at + 0 -- no negative zero
  local x, y = x1 + dx * at, y1 + dy * at
  local axis = max(min((inY - inX) * VAST, 1), 0) ---@type number
  if max(inX - inY, inY - inX) <= TIE then
    axis = cornerAxis(v, world, x, y, dx, dy, filter)
  end
  -- (Multiplied twice, since a line may be as short as a number can be.)
  local back = (dx * (axis - 1) - dy * axis) * VAST * VAST
  local other, isBack = 1 - axis, max(min(back, 1), 0) ---@type number, number
  local k = 2 * i + axis
  local edge, normal = v.position[k] + v.size[k] * isBack, 2 * isBack - 1
  x, y = edge * other + x * axis, edge * axis + y * other
  return v.object[i], x, y, normal * other + 0, normal * axis + 0, at
end

-- Returns the first object on a line that a filter function accepts. The line is searched in
-- pieces, so that a hit nearby costs little, however long the line is.
local function firstAccepted(v, world, x1, y1, x2, y2, line, filter)
  local dx, dy = x2 - x1, y2 - y1
  local length = max(dx, -dx, dy, -dy)
  local done, piece = 0, FIRST_PIECE
  local hit ---@type integer?
  repeat
    local from = done > 0 and done / length or 0
    local to = done + piece < length and (done + piece) / length or 1
    line.to = to
    local endX, endY = x1 + dx * to, y1 + dy * to
    view.walk(v, world, x1 + dx * from, y1 + dy * from, endX, endY, line, visitAll)
    hit = pick(v, line, line.count, filter)
    line.from, done, piece = to, done + piece, piece * 2
  until hit or to == 1
  return hit
end

--- Returns the first hit on a line: object, x, y, nx, ny, fraction.
function query.raycast(world, x1, y1, x2, y2, filter)
  local v = view.of(world)
  local line = takeLine(v, x1, y1, x2, y2, filter)
  local hit
  if type(filter) == "function" then
    hit = firstAccepted(v, world, x1, y1, x2, y2, line, filter)
  else
    view.walk(v, world, x1, y1, x2, y2, line, visitFirst)
    hit = line.best ~= 0 and line.best
  end
  view.give(v, line)
  if hit then
    return describeHit(v, world, hit, x1, y1, x2 - x1, y2 - y1, filter)
  end
end

-- Near --------------------------------------------------------------------------------------------

-- Returns the square of the distance of a point from an object.
local function distanceTo(v, i, x, y)
  local position, size, k = v.position, v.size, 2 * i
  local left, top = position[k], position[k + 1]
  local dx = max(left - x, x - (left + size[k]), 0)
  local dy = max(top - y, y - (top + size[k + 1]), 0)
  return dx * dx + dy * dy
end

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
  local found = view.take(v)
  local reach, last, hit = min(FIRST_RADIUS, radius), -1
  repeat
    local n = view.near(v, world, x - reach, y - reach, x + reach, y + reach, found)
    n = keepNamed(v, found, keepWithin(v, found, n, x, y, last, reach * reach), filter)
    hit = pick(v, found, n, filter)
    local isLast = reach >= radius
    last, reach = reach * reach, min(reach * 4, radius)
  until hit or isLast
  view.give(v, found)
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
  local share, axis, isLow, x, y = obstacle.meet(v, i, j, p[k], p[k + 1], toX, toY)
  if not axis then
    return v.object[j], x, y, 0, 0, 0
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
  local found = view.take(v)
  local x, y = v.position[2 * i], v.position[2 * i + 1]
  local n = view.onWay(v, world, i, x, y, x + dx, y + dy, found)
  n = keepStopping(v, found, keepNamed(v, found, n, filter), i, x + dx, y + dy)
  local hit = pick(v, found, n, filter)
  view.give(v, found)
  if hit then
    return describeStop(v, i, hit, x + dx, y + dy)
  end
end

interpreted.functions(
  accepts,
  shorten, -- mostly by one or two entries: unrolled, all that follows is compiled each time
  writeAccepted,
  pick,
  keepSolid,
  query.blocker,
  query.segment,
  isFilled,
  cornerAxis,
  firstAccepted,
  query.nearest,
  keepStopping,
  describeStop,
  query.sweep
)

return query
