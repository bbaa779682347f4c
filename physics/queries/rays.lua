--- Finds what is on a line: `raycast` and `querySegment`.
--
-- Rays are compiled as a whole, since most of them take one of a few paths; those with a filter
-- function are not.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local circle = require(root .. ".memory.circle")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local results = require(root .. ".queries.results")
local sort = require(root .. ".memory.sort")
local triangle = require(root .. ".memory.triangle")
local view = require(root .. ".queries.index")

local rays = {}

local EPSILON, TINY, VAST = columns.EPSILON, columns.TINY, columns.VAST
local BOX, CIRCLE = columns.SHAPE_BOX, columns.SHAPE_CIRCLE
local max, min = math.max, math.min
local isNamed, keepNamed = results.isNamed, results.keepNamed
local TIE = 1e-9
local SLOPE = triangle.FIRST -- and above
-- Larger than the whole of a line, which is 1: the fraction at which a line hits an object that it
-- misses.
local NEVER = 2
-- px of a ray that are searched first; each further piece is twice as long.
local FIRST_PIECE = 48

-- px from a point to the edge of the slope i; below 0: it is inside.
local function toEdge(v, i, x, y)
  local p, s, k = v.position, v.size, 2 * i
  local rx, ry = x - p[k], y - p[k + 1]
  return triangle.gap(triangle.EDGE, v.shape[i], 1, rx, ry, 0, 0, s[k], s[k + 1])
end

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

-- The share of a line at which it crosses the edge of the slope i, and whether it goes in there;
-- nil: it does not come to it.
local function crossEdge(v, i, x, y, dx, dy)
  local start, last = toEdge(v, i, x, y), toEdge(v, i, x + dx, y + dy)
  if start > 0 and last > 0 then
    return NEVER, true
  elseif start > 0 ~= (last > 0) then
    return start / (start - last), start > 0
  end
  return nil
end

-- As `passage`, of a slope.
local function passSlope(v, i, line)
  local enters, leaves = passage(v, i, line.x, line.y, line.dx, line.dy)
  local at, goesIn = crossEdge(v, i, line.x, line.y, line.dx, line.dy)
  if at and goesIn then
    enters = max(enters, at)
  elseif at then
    leaves = min(leaves, at)
  end
  return enters, leaves
end

-- The same of a circle.
local function passageRound(v, i, x, y, dx, dy)
  local position, k, r = v.position, 2 * i, v.size[2 * i] * 0.5
  return circle.passage(x - position[k] - r, y - position[k + 1] - r, dx, dy, r)
end

-- Returns a line: a working list for the objects that it hits, with its data. `filter` is the
-- query's filter, or false if that is a function, which is called later.
local function takeLine(v, x1, y1, x2, y2, filter)
  local line = results.take(v)
  line.view, line.from, line.to = v, -1, 1
  line.x, line.dx = begins(x1, x2 - x1)
  line.y, line.dy = begins(y1, y2 - y1)
  line.filter = type(filter) ~= "function" and filter
  return line
end

-- Returns the fraction of the line at which it hits slot i, after `from` and up to `to`; NEVER: it
-- does not. An object at the very beginning is hit at 0, which is after any `from` < 0.
local function hitAt(line, v, i)
  local enters, leaves ---@type number, number
  if v.shape[i] == BOX then
    enters, leaves = passage(v, i, line.x, line.y, line.dx, line.dy)
  elseif v.shape[i] == CIRCLE then
    enters, leaves = passageRound(v, i, line.x, line.y, line.dx, line.dy)
  else
    enters, leaves = passSlope(v, i, line)
  end
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
function rays.segment(world, x1, y1, x2, y2, filter, out)
  local v = view.of(world)
  local line = takeLine(v, x1, y1, x2, y2, filter)
  view.walk(v, world, x1, y1, x2, y2, line, visitAll)
  sort.by(line, line.count, v.entry, v.rank, v.rank)
  return results.publish(v, line, line.count, filter, out)
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
  local found = results.take(v)
  local reach = 2 * EPSILON
  local n = view.near(v, world, x - reach, y - reach, x + reach, y + reach, found)
  n = keepNamed(v, found, n, filter)
  local sx, sy = dx > 0 and 1 or -1, dy > 0 and 1 or -1
  local coversY = isFilled(v, found, n, x, y, sx, -sy)
  local coversX = isFilled(v, found, n, x, y, -sx, sy)
  results.give(v, found)
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

-- The same of a circle: the normal points from its centre.
local function describeRound(v, i, x1, y1, dx, dy)
  local position, k, r = v.position, 2 * i, v.size[2 * i] * 0.5
  local at = passageRound(v, i, x1, y1, dx, dy)
  if at < 0 then
    return v.object[i], x1, y1, 0, 0, 0
  end
  at = min(at, 1) + 0
  local x, y = x1 + dx * at, y1 + dy * at
  local centerX, centerY = position[k] + r, position[k + 1] + r
  local nx, ny = circle.normal(x, y, centerX, centerY, centerX, centerY)
  return v.object[i], x, y, nx + 0, ny + 0, at
end

-- Returns what a ray reports about the object that it hits. There are no branches for the sides:
-- each would lead to a trace of its own for all that the game does with the answer.
local function describeHit(v, world, i, x1, y1, dx, dy, filter)
  if v.shape[i] == CIRCLE then
    return describeRound(v, i, x1, y1, dx, dy)
  end
  local inX, inY = enterOn(v, 2 * i, x1, dx), enterOn(v, 2 * i + 1, y1, dy)
  local at = max(inX, inY)
  if v.shape[i] >= SLOPE then
    local share, goesIn = crossEdge(v, i, x1, y1, dx, dy)
    if share and goesIn and share >= at - TIE then
      local nx, ny = triangle.normal(v.shape[i], v.size[2 * i], v.size[2 * i + 1])
      return v.object[i], x1 + dx * share, y1 + dy * share, nx, ny, share
    elseif at < 0 then
      return v.object[i], x1, y1, 0, 0, 0
    end
  end
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
    hit = results.pick(v, line, line.count, filter)
    line.from, done, piece = to, done + piece, piece * 2
  until hit or to == 1
  return hit
end

--- Returns the first hit on a line: object, x, y, nx, ny, fraction.
function rays.raycast(world, x1, y1, x2, y2, filter)
  local v = view.of(world)
  local line = takeLine(v, x1, y1, x2, y2, filter)
  local hit
  if type(filter) == "function" then
    hit = firstAccepted(v, world, x1, y1, x2, y2, line, filter)
  else
    view.walk(v, world, x1, y1, x2, y2, line, visitFirst)
    hit = line.best ~= 0 and line.best
  end
  results.give(v, line)
  if hit then
    return describeHit(v, world, hit, x1, y1, x2 - x1, y2 - y1, filter)
  end
end

interpreted.functions(rays.segment, isFilled, cornerAxis, firstAccepted)

return rays
