--- Questions: who is at a point, in a rectangle, on a line, near, in the way. They see the game's
--- tables as they are now (see view), change nothing, and make no garbage unless they have to make
--- the list that they return.
--
-- Every question goes the same way: the view offers whoever may be meant, each is tested exactly,
-- and what is left is put in order. A filter that is a function is asked last, in that order, about
-- as few as possible.
--
-- Inactive objects are not found. Sensors are, except by `sweep`, which nothing stops but solids.

local here = (...):match("^(.*)%.[^.]+$")
local aabb = require(here .. ".aabb")
local columns = require(here .. ".columns")
local obstacle = require(here .. ".obstacle")
local sort = require(here .. ".sort")
local view = require(here .. ".view")

local query = {}

local EPSILON, TINY = columns.EPSILON, columns.TINY
local max, min, sqrt = math.max, math.min, math.sqrt
local TIE = 1e-9
-- px of a ray that are looked at first; each further piece is twice as long.
local FIRST_PIECE = 48
-- px around a point in which the nearest is looked for first.
local FIRST_RADIUS = 64

-- Filters and results -----------------------------------------------------------------------------

-- Whether a filter that is no function lets an object pass; one that is a function is asked later.
local function isNamed(v, i, filter)
  if filter == nil or type(filter) == "function" then
    return true
  elseif type(filter) ~= "table" then
    return v.groupName[i] == filter
  end
  local name = v.groupName[i]
  for n = 1, #filter do
    if filter[n] == name then
      return true
    end
  end
  return false
end

local function keepNamed(v, found, count, filter)
  if filter == nil or type(filter) == "function" then
    return count
  end
  local n = 0
  for m = 1, count do
    if isNamed(v, found[m], filter) then
      n = n + 1
      found[n] = found[m]
    end
  end
  return n
end

local function accepts(v, i, filter)
  local object = v.object[i]
  -- A filter that asks may have noticed that somebody has left.
  return object and (type(filter) ~= "function" or filter(object))
end

-- Writes the objects in `found` that the filter accepts into `out`, in the order of `found`.
local function publish(v, found, count, filter, out)
  out = out or {}
  local n = 0
  for m = 1, count do
    if accepts(v, found[m], filter) then
      n = n + 1
      out[n] = v.object[found[m]]
    end
  end
  for m = #out, n + 1, -1 do
    out[m] = nil
  end
  view.give(v, found)
  return out, n
end

-- The first of `found`, by `entry` and then in order, that the filter accepts; nil: none.
local function pick(v, found, count, filter)
  local entry, rank = v.entry, v.rank
  if type(filter) == "function" then
    sort.by(found, count, entry, rank, rank)
    for n = 1, count do
      if accepts(v, found[n], filter) then
        return found[n]
      end
    end
    return nil
  end
  local best = found[1]
  for n = 2, count do
    local i = found[n]
    if entry[i] < entry[best] or (entry[i] == entry[best] and rank[i] < rank[best]) then
      best = i
    end
  end
  return count > 0 and best or nil
end

-- Points and rectangles ---------------------------------------------------------------------------

--- Everybody around a point. Left and top edges belong to an object, right and bottom ones do not.
function query.point(world, x, y, filter, out)
  local v = view.of(world)
  local found = view.take(v)
  local count, n = view.near(v, world, x, y, x, y, found), 0
  local position, size = v.position, v.size
  for m = 1, count do
    local i = found[m]
    local k = 2 * i
    local isIn = aabb.inside(x, y, 0, 0, position[k], position[k + 1], size[k], size[k + 1])
    if isIn and v.active[i] and isNamed(v, i, filter) then
      n = n + 1
      found[n] = i
    end
  end
  sort.by(found, n, v.rank, v.rank, v.rank)
  return publish(v, found, n, filter, out)
end

-- Everybody but slot `but` in a rectangle, in order.
local function inRectangle(v, world, x, y, w, h, but, filter, out)
  local found = view.take(v)
  -- Flush is flush to a millionth of a pixel, on either side.
  local depth = world.sideBySide and -EPSILON or EPSILON
  local left, top, right, bottom = x - EPSILON, y - EPSILON, x + w + EPSILON, y + h + EPSILON
  local count, n = view.near(v, world, left, top, right, bottom, found), 0
  local position, size = v.position, v.size
  for m = 1, count do
    local i = found[m]
    local k = 2 * i
    local width, height =
      aabb.overlap(x, y, w, h, position[k], position[k + 1], size[k], size[k + 1])
    local isIn = width > depth and height > depth
    if isIn and i ~= but and v.active[i] and isNamed(v, i, filter) then
      n = n + 1
      found[n] = i
    end
  end
  sort.by(found, n, v.rank, v.rank, v.rank)
  return publish(v, found, n, filter, out)
end

--- Everybody who overlaps a rectangle.
function query.rectangle(world, x, y, w, h, filter, out)
  return inRectangle(view.of(world), world, x, y, w, h, 0, filter, out)
end

--- Everybody who overlaps an object; nil: it is not in the world.
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

-- Where a line is told to begin on an axis, and how far it goes. A line along an edge belongs to
-- the box below it or to its right, so that it slips through no seam; to a millionth of a pixel.
local function begins(p, d)
  return d == 0 and p + EPSILON or p, d == 0 and TINY or d
end

-- Where a line from (x, y) by (dx, dy), as `begins` tells it, enters a box on each axis, and
-- where it leaves it. No branches, so that it is one piece of code for all.
local function enters(v, i, x, y, dx, dy)
  local position, size, k = v.position, v.size, 2 * i
  local left, top = position[k] - x, position[k + 1] - y
  local right, bottom = position[k] + size[k] - x, position[k + 1] + size[k + 1] - y
  local a, b, c, d = left / dx, right / dx, top / dy, bottom / dy
  return min(a, b), min(c, d), min(max(a, b), max(c, d))
end

-- Writes into `entry` where the line enters each of `found`: 2, behind its end, if it does not.
local function findEntries(v, found, count, x1, y1, x2, y2)
  local entry = v.entry
  local x, dx = begins(x1, x2 - x1)
  local y, dy = begins(y1, y2 - y1)
  for m = 1, count do
    local i = found[m]
    local inX, inY, exit = enters(v, i, x, y, dx, dy)
    local at = max(inX, inY)
    if min(exit - at, exit) <= 0 then
      at = 2
    end
    entry[i] = max(at, 0)
  end
end

-- Keeps of `found` who is hit by the line after `from` and up to `to`, with its `entry`; returns
-- how many. Who is hit at the very beginning is hit after any `from` < 0.
local function keepHit(v, found, count, x1, y1, x2, y2, from, to)
  local n, entry, active = 0, v.entry, v.active
  findEntries(v, found, count, x1, y1, x2, y2)
  for m = 1, count do
    local i = found[m]
    local at = entry[i]
    if at > from and at <= to and active[i] then
      n = n + 1
      found[n] = i
    end
  end
  return n
end

--- Everybody on a line, nearest first.
function query.segment(world, x1, y1, x2, y2, filter, out)
  local v = view.of(world)
  local found = view.take(v)
  local n = keepNamed(v, found, view.along(v, world, x1, y1, x2, y2, found), filter)
  n = keepHit(v, found, n, x1, y1, x2, y2, -1, 1)
  sort.by(found, n, v.entry, v.rank, v.rank)
  return publish(v, found, n, filter, out)
end

-- Whether somebody fills the quarter beside a point towards (sx, sy).
local function isFilled(v, found, count, x, y, sx, sy, filter)
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
    if isBeside and isBelow and v.active[i] and isNamed(v, i, filter) then
      return true
    end
  end
  return false
end

-- The axis whose face is hit by a line that meets a corner: the one that no neighbour covers, else
-- along gravity.
--
--        .     +---+    The line meets two tiles of a wall where they join: the top edge of the
--          .   |   |    lower one is covered by the upper one, so it hits the wall.
--            . +---+
--              |   |
local function cornerAxis(v, world, x, y, dx, dy, filter)
  local found = view.take(v)
  local reach = 2 * EPSILON
  local n = view.near(v, world, x - reach, y - reach, x + reach, y + reach, found)
  local sx, sy = dx > 0 and 1 or -1, dy > 0 and 1 or -1
  local coversY = isFilled(v, found, n, x, y, sx, -sy, filter)
  local coversX = isFilled(v, found, n, x, y, -sx, sy, filter)
  view.give(v, found)
  if coversX == coversY then
    return v.bodies.downAxis
  end
  return coversX and 1 or 0
end

-- What a ray is told about the object it hits.
local function describeHit(v, world, i, x1, y1, dx, dy, filter)
  local x0, slopeX = begins(x1, dx)
  local y0, slopeY = begins(y1, dy)
  local inX, inY = enters(v, i, x0, y0, slopeX, slopeY)
  inX, inY = dx == 0 and -1 or inX, dy == 0 and -1 or inY
  local at = max(inX, inY)
  if at < 0 then
    return v.object[i], x1, y1, 0, 0, 0
  end
  at = at > 0 and at or 0 -- no negative zero
  local k, x, y = 2 * i, x1 + dx * at, y1 + dy * at
  local axis = inY > inX and 1 or 0
  if inX - inY <= TIE and inY - inX <= TIE then
    axis = cornerAxis(v, world, x, y, dx, dy, filter)
  end
  if axis == 0 then
    x = dx > 0 and v.position[k] or v.position[k] + v.size[k]
    return v.object[i], x, y, dx > 0 and -1 or 1, 0, at
  end
  y = dy > 0 and v.position[k + 1] or v.position[k + 1] + v.size[k + 1]
  return v.object[i], x, y, 0, dy > 0 and -1 or 1, at
end

--- The first on a line: object, x, y, nx, ny, fraction. The line is looked at in pieces, so that a
--- hit nearby costs little, however long the line is.
function query.raycast(world, x1, y1, x2, y2, filter)
  local v = view.of(world)
  local found = view.take(v)
  local dx, dy = x2 - x1, y2 - y1
  local length = max(dx, -dx, dy, -dy)
  local from, piece = -1.0, FIRST_PIECE
  local done, hit = 0
  repeat
    local to = done + piece < length and (done + piece) / length or 1
    local start = from > 0 and from or 0
    local endX, endY = x1 + dx * to, y1 + dy * to
    local n = view.along(v, world, x1 + dx * start, y1 + dy * start, endX, endY, found)
    n = keepHit(v, found, keepNamed(v, found, n, filter), x1, y1, x2, y2, from, to)
    hit = pick(v, found, n, filter)
    from, done, piece = to, done + piece, piece * 2
  until hit or to == 1
  view.give(v, found)
  if hit then
    return describeHit(v, world, hit, x1, y1, dx, dy, filter)
  end
end

-- Near --------------------------------------------------------------------------------------------

-- The square of the distance of a point from an object.
local function distanceTo(v, i, x, y)
  local position, size, k = v.position, v.size, 2 * i
  local left, top = position[k], position[k + 1]
  local dx = max(left - x, x - (left + size[k]), 0)
  local dy = max(top - y, y - (top + size[k + 1]), 0)
  return dx * dx + dy * dy
end

--- The nearest object and its distance. A growing square is looked at, so that one nearby costs
--- little, however large the radius is.
function query.nearest(world, x, y, radius, filter)
  local v = view.of(world)
  local found = view.take(v)
  local reach, last, hit = min(FIRST_RADIUS, radius), -1
  repeat
    local count, n = view.near(v, world, x - reach, y - reach, x + reach, y + reach, found), 0
    for m = 1, count do
      local i = found[m]
      if v.active[i] and isNamed(v, i, filter) then
        local distance = distanceTo(v, i, x, y)
        if distance <= reach * reach and distance > last then
          n = n + 1
          found[n], v.entry[i] = i, distance
        end
      end
    end
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

-- Keeps of `found` who stops an object on its way; writes when into `entry`.
local function keepStopping(v, found, count, i, toX, toY, filter)
  local entry, n = v.entry, 0
  for m = 1, count do
    local j = found[m]
    if obstacle.isMet(v, i, j) and obstacle.isSolid(v, i, j) and isNamed(v, j, filter) then
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

--- What would stop an object on its way by (dx, dy): object, x, y, nx, ny, fraction. The second
--- value is whether the object is in the world at all.
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
  local x, y, w, h = v.position[2 * i], v.position[2 * i + 1], v.size[2 * i], v.size[2 * i + 1]
  local left, top = min(x, x + dx), min(y, y + dy)
  local right, bottom = max(x, x + dx) + w, max(y, y + dy) + h
  local n = view.near(v, world, left, top, right, bottom, found)
  n = keepStopping(v, found, n, i, x + dx, y + dy, filter)
  local hit = pick(v, found, n, filter)
  view.give(v, found)
  if hit then
    return describeStop(v, i, hit, x + dx, y + dy)
  end
end

return query
