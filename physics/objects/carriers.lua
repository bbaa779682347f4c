--- Finds what carries each object, and how fast, from the chain of its supports.
--
-- A kinematic object carries what stands on it, and what stands on that. A belt (`surfaceSpeed`)
-- moves what stands on it along its surface. The carrier's velocity is added to the rider's path in
-- motion/forces.lua and subtracted in objects/write.lua. So a rider's own velocity is relative to
-- its carrier.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local carrier = {}

local KINEMATIC, DYNAMIC = columns.KINEMATIC, columns.DYNAMIC
local EPSILON = columns.EPSILON
local SIDE = columns.SIDE
local max, min = math.max, math.min

--- Returns the velocity, x and y, that slot c gives to its rider i in this step. A belt moves along
--- the surface that gravity presses on.
function carrier.velocity(b, c, i)
  local along = b.surfaceSpeed[c]
  local x, y = along, 0
  if b.down[2 * i] ~= 0 then
    x, y = 0, along
  end
  if b.kind[c] == KINEMATIC and b.carry[c] then
    return b.speed[2 * c] + x, b.speed[2 * c + 1] + y
  end
  return x, y
end

--- Returns the speed, along the other axis, of the belt j that slot i presses on along an axis.
function carrier.beltSpeed(b, i, j, axis)
  local isPressed = (b.down[2 * i] ~= 0) == (axis == 0)
  return isPressed and b.surfaceSpeed[j] or 0
end

local function carries(b, c)
  return b.surfaceSpeed[c] ~= 0 or (b.kind[c] == KINEMATIC and b.carry[c])
end

-- Returns the carrier of slot i, 0: none; nil if that depends on what its support stands on.
local function ends(b, i)
  local below = b.support[i]
  if below == 0 then
    return 0
  elseif b.kind[below] ~= DYNAMIC then
    return carries(b, below) and below or 0
  elseif b.surfaceSpeed[below] ~= 0 then
    return below
  end
end

-- Follows the supports of slot i down to where the carrier is known. Writes that carrier for each
-- slot on the way.
local function follow(b, i, stamp)
  local way, seen, found, support, count = b.stack, b.carrierSeen, b.carrierNow, b.support, 0
  local c = nil
  while c == nil do
    if seen[i] == stamp then
      c = found[i]
    else
      count = count + 1
      -- A ring of supports has no carrier.
      way[count], seen[i], found[i] = i, stamp, 0
      c = ends(b, i)
      i = support[i]
    end
  end
  for n = 1, count do
    found[way[n]] = c
  end
end

--- Finds the carrier of each dynamic body in awakeList, at the end of its chain of supports. Writes
--- carrierNow; 0: none.
function carrier.find(b)
  b.stamp = b.stamp + 1
  local list, kind, stamp = b.awakeList, b.kind, b.stamp
  for n = 1, b.awakeCount do
    if kind[list[n]] == DYNAMIC then
      follow(b, list[n], stamp)
    end
  end
end

-- Returns the part of v that its carrier (at velocity c) gave it: as far as both point the same
-- way.
local function given(v, c)
  if v * c <= 0 then
    return 0
  end
  if c > 0 then
    return v < c and v or c
  end
  return v > c and v or c
end

-- Returns whether k leans on something that cannot move.
local function leans(b, k)
  return (b.pressedHigh[k] and b.heldHigh[k] > 0) or (b.pressedLow[k] and b.heldLow[k] > 0)
end

--- Returns the velocity along k that an object shows: relative to its carrier at c px/s. In its
--- first step on a carrier, and while it leans on something that cannot move, only the part that
--- the carrier gave is subtracted.
function carrier.ownVelocity(b, k, c, isNew)
  local v = b.speed[k]
  if isNew or leans(b, k) then
    return v - given(v, c)
  end
  return v - c
end

-- Returns whether slot i, where it is now, is apart from slot j, where `places` has that.
local function isApart(b, i, j, places)
  local now, size, k, m = b.position, b.size, 2 * i, 2 * j
  local x, y = places[m] - now[k], places[m + 1] - now[k + 1]
  return max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1]) > EPSILON
end

--- Notes that the game has moved slot i and called `refresh`. Call it after the slot was read.
function carrier.noteJump(b, i)
  b.jumped[i] = b.jumped[i] or isApart(b, i, i, b.to) or b.kind[i] ~= DYNAMIC
end

--- Ends the riding of slot i. The velocity that it shows is its own from now on.
function carrier.leave(b, i)
  b.carrier[i], b.carried[2 * i], b.carried[2 * i + 1] = 0, 0, 0
end

-- Returns whether slot i, where it is now, stands on slot c, directly or through others. Then the
-- game has moved it together with c.
local function standsOn(b, i, c)
  local support = b.support
  for _ = 1, b.moverCount do
    local j = support[i]
    if j == 0 then
      return false
    end
    if isApart(b, i, j, b.position) then
      return false
    elseif j == c then
      return true
    end
    i = j
  end
  return false
end

-- Ends the riding of slot i if the game has switched it off, or has moved it by more than its own
-- size and not onto its carrier. If the game has moved it by less, it goes on riding, or jumps with
-- the carrier's velocity.
local function check(b, i)
  local isElsewhere = (b.jumped[i] or isApart(b, i, i, b.to)) and not standsOn(b, i, b.carrier[i])
  if b.kind[i] == DYNAMIC and (isElsewhere or not b.active[i]) then
    carrier.leave(b, i)
  end
end

local function lose(b, i)
  b.carrier[i] = 0
  b.lostCount = b.lostCount + 1
  b.lost[b.lostCount] = i
end

-- Slot c was moved by the game: what was not moved with it no longer stands or rides on it.
local function leaveBehind(b, c)
  for n = 1, b.moverCount do
    local i = b.movers[n]
    if b.carrier[i] == c and not standsOn(b, i, c) then
      lose(b, i)
    end
    if b.support[i] == c and isApart(b, i, c, b.position) then
      b.support[i] = 0
    end
  end
end

--- Ends the riding of objects if the game has moved them or their carrier since the last step. (Not
--- while they are read: reading may be refused, and the result would depend on its order.)
function carrier.checkMoved(b)
  for n = 1, b.hasCarriers and b.movedCount or 0 do
    check(b, b.movedList[n])
  end
  for n = 1, b.movedCount do
    local c = b.movedList[n]
    if b.jumped[c] then
      b.jumped[c] = false
      leaveBehind(b, c)
    end
  end
end

-- Returns the carrier that slot j is for what stands on its `side`; 0: none.
local function carrierAt(b, i, j, side)
  if b.sensor[j] or b.canCollide[i] or b.canCollide[j] or b.worldCanCollide then
    return 0
  elseif b.oneWay[j] and SIDE[b.oneWay[j]] ~= side then
    return 0
  elseif b.kind[j] == DYNAMIC then
    return b.carrier[j]
  end
  return b.kind[j] == KINEMATIC and b.carry[j] and j or 0
end

-- Returns the carrier below slot i, which the game has put flush on it along an axis: the one with
-- the widest common edge, ties in the order of the world; 0: none.
local function carrierBelow(b, i, axis)
  local from, size, k = b.from, b.size, 2 * i + axis
  local across, isHigh = k + 1 - 2 * axis, b.down[k] > 0
  local best, widest, first, half = 0, EPSILON, 0, b.head[i]
  while half ~= 0 do
    local j = b.other[half]
    local m, n = 2 * j + axis, 2 * j + 1 - axis
    local edge = min(from[across] + size[across], from[n] + size[n]) - max(from[across], from[n])
    local gap = isHigh and from[m] - from[k] - size[k] or from[k] - from[m] - size[m]
    if edge > EPSILON and gap <= EPSILON and gap >= -EPSILON then
      local c = carrierAt(b, i, j, 2 * axis + (isHigh and 1 or 2))
      if c ~= 0 and (edge > widest or (edge == widest and b.rank[j] < b.rank[first])) then
        best, widest, first = c, edge, j
      end
    end
    half = b.next[half]
  end
  return best
end

-- Lets slot i ride on what it was put on, if that moves away from below it. Returns whether it
-- does.
local function boardOne(b, i)
  local axis = b.down[2 * i] ~= 0 and 0 or 1
  local k = 2 * i + axis
  local down = b.down[k]
  local isFree = b.kind[i] == DYNAMIC and b.active[i] and not b.sensor[i] and b.carrier[i] == 0
  if not isFree or down == 0 or b.velocity[k] * down < 0 then
    return false
  end
  local c = carrierBelow(b, i, axis)
  if c == 0 or b.speed[2 * c + axis] * down <= 0 then
    return false
  end
  b.carrier[i] = c
  return true
end

--- Lets objects that the game has put onto a carrier that moves away from below them ride at once,
--- also in stacks. Nothing would press them onto it.
function carrier.board(b)
  local hasBoarded = true
  while hasBoarded do
    hasBoarded = false
    for n = 1, b.movedCount do
      hasBoarded = boardOne(b, b.movedList[n]) or hasBoarded
    end
  end
end

--- Ends the riding on a slot that leaves the world, stops carrying or gets in the way of its
--- riders. (The support of what stands on other objects is cleared by pairFinder, when the pair is
--- unlinked.)
function carrier.forget(b, c)
  if b.kind[c] == DYNAMIC and b.surfaceSpeed[c] == 0 then
    return
  end
  for n = 1, b.moverCount do
    local i = b.movers[n]
    if b.carrier[i] == c then
      lose(b, i)
    end
    if b.support[i] == c then
      b.support[i] = 0
    end
  end
end

--- Adds the carrier's velocity to objects that lost their carrier between two steps, unless the
--- game has moved them.
function carrier.dismount(b)
  carrier.checkMoved(b)
  for n = 1, b.lostCount do
    local i = b.lost[n]
    if b.kind[i] == DYNAMIC then
      local object, k = b.object[i], 2 * i
      b.velocity[k] = b.velocity[k] + b.carried[k]
      b.velocity[k + 1] = b.velocity[k + 1] + b.carried[k + 1]
      b.carried[k], b.carried[k + 1] = 0, 0
      object.vx, object.vy = b.velocity[k], b.velocity[k + 1]
    end
  end
  b.lostCount = 0
end

return carrier
