---@diagnostic disable
--- Load: computes with which forces an object is pressed, from the contacts that the last step has
-- left. A step notes nothing for it. So it costs nothing there, and bodies that sleep, or were just
-- restored, answer the same.
--
-- Each contact of the bodies that are connected with the object has a force f >= 0 along its
-- normal n. The forces wanted are those with which no contact closes:
--
--      a = pull + sum of (f n) / m        n · (a of `one` - a of `other`) >= 0,  and 0 if f > 0
--
-- 1. A body that something immovable holds, directly or through others, passes the force that
--    presses it on to the contacts that hold it, in proportion to their widths (`pass`). One walk
--    for each direction, from the bodies furthest back, is exact for stacks and rows of boxes.
-- 2. Passes over all contacts find the other forces: of bodies that push each other freely, and of
--    slanted contacts (`relax`, projected Gauss-Seidel).
-- 3. A heap that has come to rest is not in balance everywhere, and its bodies may be a little
--    apart. Those at rest pass the force that is left straight down.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".narrowphase.ball")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local links = require(root .. ".memory.links")
local path = require(root .. ".motion.path")
local sort = require(root .. ".memory.sort")

local load = {}

local AXIS, DYNAMIC = constants.AXIS, constants.DYNAMIC
local max, min = math.max, math.min
-- Most passes over all contacts, and the share of the largest force that the last one may change.
local PASSES, ENOUGH = 200, 1e-12
-- The least width of a contact, px.
local POINT = 1.0
-- Of a heap at rest: the share of a normal along gravity from which on a contact bears a body, and
-- px by which the two may be apart.
local BEARS, NEAR = 0.1, 1

-- By contact: its slots, the first in the order of the world first, and their ranks; the unit
-- normal from `other` to `one`, px of the common edge, the force along the normal, and that on
-- `one`; of a direction the body that presses the other one, how far back it is, and whether the
-- contact holds it.
local one, other, first, second, normalX, normalY, width = {}, {}, {}, {}, {}, {}, {}
local size, forceX, forceY, order, pusher, key, holds = {}, {}, {}, {}, {}, {}, {}
-- By index: the force that no contact bears yet; by slot: px of the contacts that have to bear it.
local rest, free = {}, {}
-- Slots; by slot, by pair, the value of `stamp`: it is listed.
local bodies, listedAt, pairAt = {}, {}, {}
local stamp, count = 0, 0

local function isAtRest(b, i)
  return b.velocity[2 * i] == 0 and b.velocity[2 * i + 1] == 0
end

-- Returns whether slot i, of a heap, rests although it touches nothing below.
local function floats(b, i)
  return b.kind[i] == DYNAMIC and b.support[i] == 0 and isAtRest(b, i) and path.isPulled(b, i)
end

-- Returns whether slots i and j, of pair p, may press each other.
local function mayPress(b, p, i, j)
  if b.contact[p] ~= 0 or b.passing[p] or not (floats(b, i) or floats(b, j)) then
    return b.contact[p] ~= 0 and not filter.isSensed(b, i, j)
  end
  return filter.blocks(b, i, j, true) and ball.gapIn(b, b.position, i, j) <= NEAR
end

-- Adds the contact of pair p.
local function add(b, p)
  local c, side, across, place, give = count + 1, b.contact[p], POINT, b.position, b.inverseMass
  local i, j = links.slotsOf(b, p)
  local _, nx, ny = ball.gapIn(b, place, i, j)
  if side ~= 0 and not ball.isRound(b, i, j) then
    local sign = (side % 2 == 0) == (i == b.pairA[p]) and -1 or 1
    nx, ny = (1 - AXIS[side]) * sign, AXIS[side] * sign
  end
  for n = 0, 1 do
    local k, m = 2 * i + n, 2 * j + n
    rest[k] = give[i] > 0 and path.pullOf(b, k) / give[i] or 0.0
    rest[m] = give[j] > 0 and path.pullOf(b, m) / give[j] or 0.0
    local last = min(place[k] + b.size[k], place[m] + b.size[m])
    across = max(across, last - max(place[k], place[m]))
  end
  one[c], other[c], first[c], second[c] = i, j, b.rank[i], b.rank[j]
  normalX[c], normalY[c], width[c] = nx, ny, across
  count, size[c], forceX[c], forceY[c] = c, 0.0, 0.0, 0.0
end

-- Lists the contacts of slot i, and of the bodies that are connected with it, not through immovable
-- ones.
local function gather(b, i)
  local n, last = 0, 1
  stamp = stamp + 1
  bodies[1], listedAt[i] = i, stamp
  while n < last do
    n = n + 1
    for _, j, p in links.neighbours(b, bodies[n]) do
      if pairAt[p] ~= stamp and mayPress(b, p, bodies[n], j) then
        pairAt[p] = stamp
        add(b, p)
        if listedAt[j] ~= stamp and b.kind[j] == DYNAMIC then
          last = last + 1
          bodies[last], listedAt[j] = j, stamp
        end
      end
    end
  end
end

-- Adds a force on `one` of contact c, and the opposite one on `other`.
local function push(c, x, y)
  local k, m = 2 * one[c], 2 * other[c]
  forceX[c], forceY[c] = forceX[c] + x, forceY[c] + y
  rest[k], rest[k + 1] = rest[k] + x, rest[k + 1] + y
  rest[m], rest[m + 1] = rest[m] - x, rest[m + 1] - y
end

-- Passes on the forces in a direction (`sign` on an axis), from the bodies furthest back on, to the
-- contacts that hold them there: their normals have at least the share `least` along the axis.
-- `isLast`: only that of bodies at rest, and straight, whatever the normal is.
local function pass(b, axis, sign, least, isLast)
  local normal = axis == 0 and normalX or normalY ---@type number[]
  for c = 1, count do
    local part = normal[c] --[[@as number]]
    local i = part * sign > 0 and other[c] or one[c]
    local k = 2 * i + axis
    pusher[c], order[c], key[c] = i, c, sign * (b.position[k] + b.size[k] * 0.5)
    holds[c] = max(part, -part) >= least
    free[one[c]], free[other[c]] = 0.0, 0.0
  end
  sort.by(order, count, key, first, second)
  for n = count, 1, -1 do
    local c = order[n]
    local i = pusher[c]
    local j = one[c] + other[c] - i
    local isHeld = b.kind[j] ~= DYNAMIC or free[j] > 0
    local isBody = b.kind[i] == DYNAMIC and (not isLast or isAtRest(b, i))
    holds[c] = holds[c] and isBody and isHeld
    free[i] = free[i] + (holds[c] and width[c] or 0.0)
  end
  for n = 1, count do
    local c = order[n]
    local i = pusher[c]
    if holds[c] then
      local more = max(rest[2 * i + axis] * sign, 0.0) * (width[c] / free[i])
      local along = (i == one[c] and -sign or sign) * more
      free[i], size[c] = free[i] - width[c], size[c] + more
      push(c, (1 - axis) * along, axis * along)
    end
  end
end

-- Makes passes over all contacts until hardly anything changes.
local function relax(b)
  local n, change, most, give = 1, 1.0, 1.0, b.inverseMass
  while n <= PASSES and change > ENOUGH * most do
    change, n = 0.0, n + 1
    for at = 1, count do
      local c = order[n % 2 == 0 and at or count + 1 - at]
      local nx, ny, wi, wj = normalX[c], normalY[c], give[one[c]], give[other[c]]
      local k, m = 2 * one[c], 2 * other[c]
      local x, y = wj * rest[m] - wi * rest[k], wj * rest[m + 1] - wi * rest[k + 1]
      local more = max((x * nx + y * ny) / (wi + wj), -size[c])
      size[c] = size[c] + more
      change, most = max(change, more, -more), max(most, size[c])
      push(c, more * nx, more * ny)
    end
  end
end

--- Writes the forces on the sides of slot i (nil: it was not read yet) into `out`; returns that.
function load.run(b, i, out)
  local down, turn = b.downAxis, b.orientation[b.downAxis]
  out.top, out.bottom, out.left, out.right, count = 0.0, 0.0, 0.0, 0.0, 0
  if i then
    gather(b, i)
  end
  pass(b, 1 - down, 1, 1)
  pass(b, 1 - down, -1, 1)
  pass(b, down, -turn, 1)
  pass(b, down, turn, 1)
  relax(b)
  pass(b, down, turn, BEARS, true)
  for c = 1, count do
    local sign = one[c] == i and 1 or other[c] == i and -1 or 0
    local x, y = sign * forceX[c], sign * forceY[c]
    out.left, out.right = out.left + max(x, 0.0), out.right + max(-x, 0.0)
    out.top, out.bottom = out.top + max(y, 0.0), out.bottom + max(-y, 0.0)
  end
  return out
end

return load
