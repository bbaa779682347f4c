--- Welding: objects that ran into each other again and again within one step go on as one.
--
-- Two boxes that push a third settle their speeds in infinitely many hits within a finite time.
-- After the third hit of a pair without a bounce it is taken as one body along that axis until the
-- step ends, which is where the series leads to. Groups are rings: `weldNext` leads from member to
-- member, `weld` names the leader (an interleaved index, as everything here), which knows the mass.

local here = (...):match("^(.*)%.[^.]+$")
local path = require(here .. ".path")
local ring = require(here .. ".ring")

require(here .. ".interpreted").file()

local weld = {}

local max = math.max

local function found(b, k)
  if b.weld[k] == 0 then
    b.weld[k], b.weldNext[k] = k, k
    b.weldMass[k] = b.mass[(k - k % 2) / 2]
  end
  return b.weld[k]
end

--- Marks all welded to k (and k) as pushed from the low or high side by one that cannot be pushed.
function weld.back(b, k, backedLow, backedHigh)
  if not (backedLow or backedHigh) then
    return -- mostly: nothing to mark in a group that may be large
  end
  b.hasBacked = true
  local first = k
  repeat
    b.backedLow[k] = b.backedLow[k] or backedLow
    b.backedHigh[k] = b.backedHigh[k] or backedHigh
    k = b.weldNext[k]
  until k == first or k == 0
end

-- Ends the hold of slot i on one side, and of whoever is held through it.
local function letGo(b, i, axis, held, holder)
  local k = 2 * i + axis
  held[k], holder[k] = 0, 0
  local half = b.head[i]
  while half ~= 0 do
    local j = b.other[half]
    if holder[2 * j + axis] == i then
      letGo(b, j, axis, held, holder)
    end
    half = b.next[half]
  end
end

--- Ends the hold of k, and of all that is welded to it, on the side of the columns given, if it
--- moves away from who holds it at more than `least` px/s; `sign` is 1 for the high side, -1 for
--- the low side. Returns whether it does.
function weld.release(b, k, axis, held, holder, sign, least)
  if held[k] == 0 then
    return false
  end
  local member, by = k, holder[k]
  while by == 0 and b.weldNext[member] ~= 0 and b.weldNext[member] ~= k do
    member = b.weldNext[member]
    by = holder[member]
  end
  if by == 0 or (b.speed[2 * by + axis] - b.speed[k]) * sign <= least then
    return false
  end
  member = k
  repeat
    letGo(b, (member - axis) / 2, axis, held, holder)
    member = b.weldNext[member]
  until member == k or member == 0
  return true
end

--- Returns the inverse mass of the group of k, which must have one.
function weld.inverseMass(b, k)
  return 1 / b.weldMass[b.weld[k]]
end

-- Whoever is in the ring of k weighs and is held together.
local function settle(b, k)
  local member, mass, heldLow, heldHigh = k, 0, 0, 0
  repeat
    mass = mass + b.mass[(member - member % 2) / 2]
    heldLow = b.holderLow[member] ~= 0 and 1 or heldLow
    heldHigh = b.holderHigh[member] ~= 0 and 1 or heldHigh
    member = b.weldNext[member]
  until member == k
  ring.name(b, k, k)
  b.weldMass[k] = mass
  repeat
    b.heldLow[member], b.heldHigh[member] = heldLow, heldHigh
    path.change(b, (member - member % 2) / 2)
    member = b.weldNext[member]
  until member == k
end

--- Takes k out of its group, since it is crushed: the others may go where it cannot. What held them
--- through it holds them no longer.
function weld.leave(b, k)
  if b.weld[k] == 0 then
    return
  end
  local before = k
  while b.weldNext[before] ~= k do
    before = b.weldNext[before]
  end
  b.weldNext[before] = b.weldNext[k]
  b.weld[k], b.weldNext[k] = 0, 0
  if before ~= k then
    settle(b, before)
  end
end

--- Joins the groups of two.
function weld.join(b, kl, kh)
  local one, other = found(b, kl), found(b, kh)
  if one == other then
    return
  end
  local mass = b.weldMass[one] + b.weldMass[other]
  if ring.isLonger(b, kl, kh) then
    ring.name(b, kh, one)
    b.weldMass[one] = mass
  else
    ring.name(b, kl, other)
    b.weldMass[other] = mass
  end
  -- Two rings become one when two members swap whom they lead to.
  b.weldNext[kl], b.weldNext[kh] = b.weldNext[kh], b.weldNext[kl]
  local heldLow, heldHigh = b.heldLow, b.heldHigh
  ring.hold(b, kl, max(heldLow[kl], heldLow[kh]), max(heldHigh[kl], heldHigh[kh]))
  weld.back(b, kl, b.backedLow[kl] or b.backedLow[kh], b.backedHigh[kl] or b.backedHigh[kh])
end

--- Lets the rings of two follow them who have pressed each other at the very beginning of the step,
--- and would have come to `lowTo` and `highTo` before; joins them, if it `joins`.
function weld.follow(b, kl, kh, lowTo, highTo, joins)
  ring.follow(b, kl, b.to[kl] - lowTo, 0)
  ring.follow(b, kh, b.to[kh] - highTo, 0)
  if joins then
    weld.join(b, kl, kh)
  end
end

return weld
