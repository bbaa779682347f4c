---@diagnostic disable
--- Corner correction: computes from a hit that overlaps a corner by a few pixels the way around
-- that corner.
--
--      ########                   ########                 the body would hit the ceiling with
--             [   ]    ->                 [   ]            1 px of its width; with nudge >= 1 it
--               ^                           ^              goes 1 px to the right, and on
--
-- A body has two ways past an obstacle: to the place beside its low side, and beside its high side.
-- `detour` is the shorter one. It is taken if it is no longer than the field `nudge`, if the body
-- does not move the other way by itself, and if the place is free (`mayGo`, `try`). A hit on the
-- side towards gravity is not corrected, or bodies would slip off the edges on which they stand.
--
-- Another body may push it back, so that it hits the same corner again: in the last round of a step
-- a hit is not corrected.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local constants = require(root .. ".memory.constants")
local overlap = require(root .. ".overlaps.overlap")
local path = require(root .. ".motion.path")

local nudge = {}

local DYNAMIC, EPSILON = constants.DYNAMIC, constants.EPSILON
local floor, max = math.floor, math.max
-- px by which the tested place is further on, towards the body that is hit.
local AHEAD = 1e-3

-- Returns how far, px, and to which side (its sign) slot i must go along the other axis to pass j
-- at moment t.
local function detour(b, i, j, axis, t)
  local ki, kj = 2 * i + 1 - axis, 2 * j + 1 - axis
  local otherPlace, ownPlace = path.at(b, kj, b.time[j], t), path.at(b, ki, b.time[i], t)
  local low, high = otherPlace - b.size[ki] - ownPlace, otherPlace + b.size[kj] - ownPlace
  return -low < high and low or high
end

-- Returns whether slot i may go `distance` px along k, around a corner: no further than its
-- `nudge`, not back against its own motion, and not towards a body that holds it in this step.
local function mayGo(b, i, k, distance)
  local motion = b.to[k] - b.from[k] - (b.carried[k] - b.softSpeed[k]) * (1 - b.time[i]) * b.dt
  local isBack = (motion > EPSILON and distance < 0) or (motion < -EPSILON and distance > 0)
  local size, isHeld = max(distance, -distance), b.held[2 * k + (distance > 0 and 2 or 1)] > 0
  return size > EPSILON and size <= b.nudge[i] + EPSILON and not (isBack or isHeld)
end

-- Moves slot i past the corner of the immovable slot j, which it hits on `axis` at moment t, if the
-- place beside j is free. A hit on the side to which gravity presses i is left alone. Returns
-- whether slot i was moved.
local function try(b, i, j, axis, iIsLow, t)
  local k = 2 * i + 1 - axis
  if b.kind[i] ~= DYNAMIC or b.kind[j] == DYNAMIC or b.nudge[i] == 0 then
    return false
  end
  local distance = detour(b, i, j, axis, t)
  if b.down[2 * i + axis] == (iIsLow and 1 or -1) or not mayGo(b, i, k, distance) then
    return false
  end
  -- A body that is flush with slot j overlaps no other body that is flush there. So the place a
  -- little further on is tested.
  local ahead = iIsLow and AHEAD or -AHEAD
  local x, y = path.at(b, 2 * i, b.time[i], t), path.at(b, 2 * i + 1, b.time[i], t)
  -- The test sees all other bodies where the step began: stairs that sink under it, a little
  -- higher.
  local sunk = b.carried[k] * distance < 0 and b.carried[k] * t * b.dt or 0
  x = x + (axis == 1 and distance - sunk or ahead)
  y = y + (axis == 0 and distance - sunk or ahead)
  -- It must not sleep. If it is pushed back to where it was, it may pass in a longer step. And a
  -- body that is in the way beside it may leave without being a neighbour.
  b.mustStayAwake[i] = true
  if overlap.isInside(b, i, x, y, true) then
    return false
  end
  path.advance(b, i, t)
  path.shift(b, k, distance)
  return true
end

--- Moves slot `low` past a corner of slot `high`, or slot `high` past a corner of slot `low`. They
--- meet on `axis` at moment t. Returns whether a body was moved.
function nudge.correct(b, low, high, axis, t)
  return try(b, low, high, axis, true, t) or try(b, high, low, axis, false, t)
end

--- Moves bodies past the corners that they touch at the start of the step and press against now
--- that it is settled. Returns whether a body was moved: then other pairs may touch.
function nudge.run(b)
  local hasMoved = false
  for axis = 0, 1 do
    local list = b.contacts[axis]
    for c = 1, list.count do
      local kl, kh = list.low[c], list.high[c]
      if b.pressed[list.pair[c]] == 1 and list.separation[c] == b.size[kl] then
        local i, j = floor(kl * 0.5), floor(kh * 0.5)
        hasMoved = nudge.correct(b, i, j, axis, 0) or hasMoved
      end
    end
  end
  return hasMoved
end

return nudge
