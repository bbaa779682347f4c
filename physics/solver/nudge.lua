--- Corner correction: computes from a hit that overlaps a corner by a few pixels the way around
-- that corner.
--
-- A body with the field `nudge` is moved sideways by at most that many px, if the place there is
-- free. A hit on the side towards gravity is not corrected.
--
-- Reads contacts, pressed; writes from, to, time, nudged, nudgedAt, news.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local activePairs = require(root .. ".broadphase.activePairs")
local overlap = require(root .. ".solver.overlap")
local path = require(root .. ".motion.path")

local nudge = {}

local DYNAMIC, EPSILON = columns.DYNAMIC, columns.EPSILON
local max = math.max
-- px by which the tested place is further on, towards what the body hits.
local AHEAD = 1e-3
--- Maximum number of corrections of one pair in a step.
nudge.MOST = 4

-- Returns how far, px, and to which side (its sign) slot i must go along the other axis to pass j
-- at moment t.
local function detour(b, i, j, axis, t)
  local ki, kj = 2 * i + 1 - axis, 2 * j + 1 - axis
  local its, mine = path.at(b, kj, b.time[j], t), path.at(b, ki, b.time[i], t)
  local low, high = its - b.size[ki] - mine, its + b.size[kj] - mine
  return -low < high and low or high
end

-- Returns whether another dynamic body is at moment t where slot i would be, at (x, y).
local function isTaken(b, i, x, y, t)
  local found, size = b.found, b.size
  local width, height = size[2 * i], size[2 * i + 1]
  for n = 1, b.broadphase:query(x, y, x + width, y + height, found) do
    local j = found[n]
    local isSolid = not (b.sensor[i] or b.sensor[j] or b.oneWay[i] or b.oneWay[j])
    if j ~= i and b.kind[j] == DYNAMIC and isSolid and filter.allows(b, i, j) then
      local dx, dy = path.at(b, 2 * j, b.time[j], t) - x, path.at(b, 2 * j + 1, b.time[j], t) - y
      local gap = max(dx - width, -dx - size[2 * j], dy - height, -dy - size[2 * j + 1])
      if gap < -EPSILON then
        return true
      end
    end
  end
  return false
end

--- Moves slot i past the corner of the immovable slot j, which it hits on `axis` at moment t. The
--- two must overlap across the axis by no more than `nudge` px, and the place beside must be free.
--- It is never moved on the side that gravity presses, and never back against its own motion.
--- Returns whether it was moved.
function nudge.try(b, i, j, axis, iIsLow, t)
  if b.nudge[i] == 0 or b.kind[i] ~= DYNAMIC or b.kind[j] == DYNAMIC then
    return false
  end
  if b.down[2 * i + axis] == (iIsLow and 1 or -1) then
    return false
  end
  local way = detour(b, i, j, axis, t)
  if way > b.nudge[i] + EPSILON or way < -b.nudge[i] - EPSILON then
    return false
  elseif way <= EPSILON and way >= -EPSILON then
    return false -- corner to corner: nothing to correct, they would meet again at once
  end
  local k = 2 * i + 1 - axis
  local motion = b.to[k] - b.from[k]
  if (motion > EPSILON and way < 0) or (motion < -EPSILON and way > 0) then
    return false
  end
  -- A body that is flush with what it hits overlaps nothing else that is flush there. So the place
  -- a little further on is tested.
  local ahead = iIsLow and AHEAD or -AHEAD
  local x, y = path.at(b, 2 * i, b.time[i], t), path.at(b, 2 * i + 1, b.time[i], t)
  x, y = x + (axis == 1 and way or ahead), y + (axis == 0 and way or ahead)
  -- It must not sleep. If it is pushed back to where it was, it may pass in a longer step. And what
  -- is in the way beside it may leave without being a neighbour.
  b.news[i] = true
  if overlap.isInside(b, i, x, y) or isTaken(b, i, x, y, t) then
    return false
  end
  path.advance(b, i, t)
  b.from[k], b.to[k] = b.from[k] + way, b.to[k] + way
  b.nudgedAt[i] = b.solveStamp
  return true
end

--- Moves bodies past the corners that they touch at the start of the step and press against now
--- that it is settled. Returns whether a body was moved: then other pairs may touch.
function nudge.run(b)
  local hasMoved = false
  for axis = 0, 1 do
    local list, size, pressed = b.contacts[axis], b.size, b.pressed
    local low, high, separation, pair = list.low, list.high, list.separation, list.pair
    for c = 1, list.count do
      local kl, kh, p = low[c], high[c], pair[c]
      if pressed[p] == 1 and separation[c] == size[kl] and b.nudged[p] < nudge.MOST then
        local i, j = (kl - axis) * 0.5, (kh - axis) * 0.5
        if nudge.try(b, i, j, axis, true, 0) or nudge.try(b, j, i, axis, false, 0) then
          b.nudged[p], hasMoved = b.nudged[p] + 1, true
          activePairs.stain(b, p)
        end
      end
    end
  end
  return hasMoved
end

return nudge
