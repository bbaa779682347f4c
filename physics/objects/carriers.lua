--- Riders: what carries an object, and how fast.
--
-- A kinematic object carries what stands on it, and what stands on that; a belt (`surfaceSpeed`)
-- moves what stands on it along its surface. The velocity of the carrier is added to the rider's
-- path in `move` and taken off in `publish`, so a rider's own velocity is relative to what carries
-- it.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

local carrier = {}

local STATIC, KINEMATIC, DYNAMIC = columns.STATIC, columns.KINEMATIC, columns.DYNAMIC
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

-- The velocity that the game sees in slot i, and for what it moves by writing x, y that.
local function shown(b, i)
  local object, k = b.object[i], 2 * i
  return (object.vx or 0) + b.drift[k], (object.vy or 0) + b.drift[k + 1]
end

--- Returns the velocity of slot i over ground, x and y: with that of its carrier, or of the way
--- that the game has written.
function carrier.overGround(b, i)
  if b.kind[i] == STATIC then
    return 0, 0
  end
  local x, y = shown(b, i)
  local c = b.carrier[i]
  if b.kind[i] ~= DYNAMIC or c == 0 then
    return x, y
  end
  local belt, isUpright = b.surfaceSpeed[c], b.down[2 * i] ~= 0
  if b.kind[c] == KINEMATIC and b.carry[c] then
    local itsX, itsY = shown(b, c)
    x, y = x + itsX, y + itsY
  end
  return isUpright and x or x + belt, isUpright and y + belt or y
end

--- Returns the speed, along the other axis, of the belt j that slot i presses on along an axis.
function carrier.beltSpeed(b, i, j, axis)
  local isPressed = (b.down[2 * i] ~= 0) == (axis == 0)
  return isPressed and b.surfaceSpeed[j] or 0
end

local function carries(b, c)
  return b.surfaceSpeed[c] ~= 0 or (b.kind[c] == KINEMATIC and b.carry[c])
end

-- What carries slot i, as far as what it stands on tells; nil if that is known only of `support`.
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

-- Follows the supports of slot i down to where the carrier is known, and tells it to all on the
-- way.
local function follow(b, i, stamp)
  local way, seen, found, support, count = b.stack, b.carrierSeen, b.carrierNow, b.support, 0
  local c = nil
  while c == nil do
    if seen[i] == stamp then
      c = found[i]
    else
      count = count + 1
      -- Who meets itself in a ring of supports is carried by nothing.
      way[count], seen[i], found[i] = i, stamp, 0
      c = ends(b, i)
      i = support[i]
    end
  end
  for n = 1, count do
    found[way[n]] = c
  end
end

--- Finds what carries everybody in awakeList, at the end of the chain it stands on: writes
--- carrierNow, 0: nothing.
function carrier.find(b)
  b.stamp = b.stamp + 1
  local list, kind, stamp = b.awakeList, b.kind, b.stamp
  for n = 1, b.awakeCount do
    if kind[list[n]] == DYNAMIC then
      follow(b, list[n], stamp)
    end
  end
end

-- The part of v that its carrier (c) gave it: as far as both point the same way.
local function given(v, c)
  if v * c <= 0 then
    return 0
  end
  if c > 0 then
    return v < c and v or c
  end
  return v > c and v or c
end

-- Whether k leans on something that cannot give way.
local function leans(b, k)
  return (b.pressedHigh[k] and b.heldHigh[k] > 0) or (b.pressedLow[k] and b.heldLow[k] > 0)
end

--- Returns the velocity along k that an object shows: relative to what carries it (c px/s). On the
--- first step on a carrier, and while it leans on something that cannot give way, only what the
--- carrier gave is off. What comes from another carrier, or has left one and comes back, has its
--- own velocity beside what that gave it.
function carrier.ownVelocity(b, k, c, isNew)
  local v = b.speed[k]
  if leans(b, k) then
    return v - given(v, c)
  elseif isNew then
    local before = b.carried[k] ~= 0 and b.carried[k] or b.kept[k]
    return v - given(before ~= 0 and before or v, c)
  end
  return v - c
end

--- Notes how much of the velocity of slot i in the air is what its last carrier gave it, which it
--- has left in this step (`hasLeft`) or before. It keeps that until something else changes it.
function carrier.keep(b, i, hasLeft)
  local isInAir = b.carrierNow[i] == 0 and b.support[i] == 0
  for k = 2 * i, 2 * i + 1 do
    if hasLeft and isInAir and not (b.pressedLow[k] or b.pressedHigh[k]) then
      b.kept[k] = b.carried[k]
    elseif not isInAir or b.speed[k] ~= b.freeSpeed[k] then
      b.kept[k] = 0
    end
  end
end

-- Whether slot i, where it is now, is apart from slot j, where `places` has that.
local function isApart(b, i, j, places)
  local now, size, k, m = b.position, b.size, 2 * i, 2 * j
  local x, y = places[m] - now[k], places[m + 1] - now[k + 1]
  return max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1]) > EPSILON
end

--- Notes that the game has put slot i elsewhere by `refresh`, if it has; it was read by now.
function carrier.noteJump(b, i)
  b.jumped[i] = b.jumped[i] or isApart(b, i, i, b.to) or b.kind[i] ~= DYNAMIC
end

--- Slot i is carried by nothing any more: its velocity is what it shows.
function carrier.leave(b, i)
  b.carrier[i], b.carried[2 * i], b.carried[2 * i + 1] = 0, 0, 0
  b.kept[2 * i], b.kept[2 * i + 1] = 0, 0
end

-- Whether slot i stands where it is now, directly or on others, on slot c: it was put elsewhere
-- together with it.
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

-- Lets slot i leave what carries it if the game has switched it off, or put it further away than
-- its own size, and not on that. What is put aside by less goes on riding, or jumps with the speed
-- of that.
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

-- Slot c was put elsewhere: what was not put there with it stands and rides on it no more.
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

--- Lets those leave their carrier that the game has put elsewhere since the last step, or whose
--- carrier it has. (Not when they are read: that may be refused, and depends on which is read
--- first.)
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

-- The carrier that slot j is for what stands on `side` of it, or rides on; 0: it is none.
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

-- The carrier on which slot i is put, flush, on an axis: the one below most of it, ties in order;
-- 0: none.
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

-- Lets slot i ride on what it was put on, if that goes away from below it; returns whether it does.
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

--- Lets what the game has put onto a carrier that goes away from below it ride at once, also in
--- stacks: nothing would press it there.
function carrier.board(b)
  local hasBoarded = true
  while hasBoarded do
    hasBoarded = false
    for n = 1, b.movedCount do
      hasBoarded = boardOne(b, b.movedList[n]) or hasBoarded
    end
  end
end

--- Marks the riders of a slot that goes away, ceases to carry or to be in their way. (Who stands on
--- one that carries nobody is seen to by `detect` when the two are parted.)
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

--- Gives those who lost their carrier between two steps its velocity to keep, unless they were put
--- elsewhere.
function carrier.dismount(b)
  carrier.checkMoved(b)
  for n = 1, b.lostCount do
    local i = b.lost[n]
    if b.kind[i] == DYNAMIC then
      local object, k = b.object[i], 2 * i
      b.velocity[k] = b.velocity[k] + b.carried[k]
      b.velocity[k + 1] = b.velocity[k + 1] + b.carried[k + 1]
      b.kept[k], b.kept[k + 1] = b.carried[k], b.carried[k + 1]
      b.carried[k], b.carried[k + 1] = 0, 0
      object.vx, object.vy = b.velocity[k], b.velocity[k + 1]
    end
  end
  b.lostCount = 0
end

return carrier
