---@diagnostic disable
--- Bonds: computes which bodies friction holds together, and how the others slip, if both bodies of
-- a contact give way.
--
-- A bond holds two bodies together as one block (see pool.lua) while friction can give the impulse
-- that this takes. Otherwise it slips: friction pulls both with its limit for the whole step, or
-- until they are equally fast and go on as one. Bonds are listed from the supports up. Which of
-- them hold is found by trial. `check` looks at the blocks that came out, and finds the bonds that
-- break and those that have slipped to their end.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local flow = require(root .. ".solver.flow")
local pool = require(root .. ".solver.pool")

local bonds = {}

local max = math.max
-- px by which the ways of two that move as one may differ.
local ROUNDING = 1e-9
-- States of a bond:
--
-- - BOND: both move as one, if they slip at first, then from when they are equally fast.
-- - SLIP: the two slip, and friction pulls with its limit.
-- - STAND: the lower one stands; for the other it is ground.
local BOND, SLIP, STAND = 1, 2, 3

--- Returns an empty list of bonds.
function bonds.new()
  return {
    count = 0,
    hasSlips = false, -- some bonds slip when the step begins
    up = {}, -- index of the body that leans
    low = {}, -- index of the body that it leans on
    limit = {}, -- maximum impulse of friction in the step
    state = {},
    tug = {}, -- impulse on the upper body while it slips
    isGlued = {}, -- the two are in one block
    slipped = {}, -- px that the upper body slips before it sticks
    next = {}, -- next bond on the same lower body
  }
end

-- Lets bond n pull the upper body with an impulse of `tug`, and the lower body back.
local function pull(b, list, n, tug)
  local up, low, change = list.up[n], list.low[n], tug - list.tug[n]
  b.tug[up], b.tug[low], list.tug[n] = b.tug[up] + change, b.tug[low] - change, tug
  flow.notePulled(b, up)
  flow.notePulled(b, low)
end

-- Returns whether ground holds body k, directly or through bonds, when something on it pulls it
-- with an impulse of `limit`.
local function standsFast(b, list, k, limit)
  local n = b.bondUnder[k]
  while n ~= 0 and list.state[n] == BOND do
    if b.onset[k] ~= b.onset[list.low[n]] or list.limit[n] < limit then
      return false
    end
    k = list.low[n]
    n = b.bondUnder[k]
  end
  return b.grip[k] * b.dt >= limit and b.onset[k] == b.base[k]
end

-- Lets the lower body of bond n be ground for the upper one.
local function stand(b, list, n)
  local up = list.up[n]
  list.state[n], b.base[up], b.grip[up] = STAND, b.onset[list.low[n]], list.limit[n] / b.dt
  flow.notePulled(b, up)
end

-- Decides how bond n begins if its upper body slips on the lower one, as far as the two are alone.
local function slide(b, list, n, slip)
  local up, low, limit, dt = list.up[n], list.low[n], list.limit[n], b.dt
  local drive, give, stands = flow.drive(b, up, dt), b.give[up], standsFast(b, list, low, limit)
  if not stands then
    drive, give = drive - flow.drive(b, low, dt), give + b.give[low]
  end
  local size, rate = max(slip, -slip), limit * give / dt + (slip > 0 and -drive or drive)
  list.hasSlips = true
  if size > rate * dt then
    list.state[n] = SLIP
    pull(b, list, n, slip > 0 and -limit or limit)
  elseif stands then
    stand(b, list, n)
  else
    list.isGlued[n], list.slipped[n] = true, slip * size / rate * 0.5
  end
end

--- Adds a bond: body `up` rubs on `low`, which can be moved, with an impulse of at most `limit`.
function bonds.add(b, list, up, low, limit)
  local n, slip = list.count + 1, b.onset[up] - b.onset[low]
  list.count = n
  list.up[n], list.low[n], list.limit[n], list.tug[n] = up, low, limit, 0.0
  list.isGlued[n], list.slipped[n], list.state[n] = false, 0.0, BOND
  b.bondUnder[up], list.next[n], b.bondOn[low] = n, b.bondOn[low], n
  if slip ~= 0 then
    slide(b, list, n, slip)
  end
end

-- Marks the bodies that are bonded, directly or through others, to a body that would not move along
-- by itself. Returns whether there are any.
local function markTowers(b, list)
  local mark, stamp, any = b.bondMark, b.forceStamp, false
  for n = 1, list.count do
    local up, low = list.up[n], list.low[n]
    if list.state[n] == BOND then
      local apart = b.to[up] - b.from[up] - b.to[low] + b.from[low]
      local isEven = b.speed[up] == b.speed[low] and max(apart, -apart) <= ROUNDING
      if list.isGlued[n] or not isEven then
        mark[up], mark[low], any = stamp, stamp, true
      end
    end
  end
  for n = any and list.count or 0, 1, -1 do
    if list.state[n] == BOND and mark[list.up[n]] == stamp then
      mark[list.low[n]] = stamp
    end
  end
  for n = 1, any and list.count or 0 do
    if list.state[n] == BOND and mark[list.low[n]] == stamp then
      mark[list.up[n]] = stamp
    end
  end
  return any
end

--- Makes blocks of the bonds that would not hold otherwise. Returns whether there are any.
function bonds.glue(b, list, dt)
  local mark, stamp, isAny = b.bondMark, b.forceStamp, markTowers(b, list)
  for n = 1, isAny and list.count or 0 do
    local up, low = list.up[n], list.low[n]
    if list.state[n] == BOND and mark[up] == stamp and mark[low] == stamp then
      list.isGlued[n] = true
      -- (Else both are as fast as the holder.)
      local isFree = b.heldLow[low] + b.heldHigh[low] + b.heldLow[up] + b.heldHigh[up] == 0
      pool.glue(b, up, low, isFree and list.slipped[n] or 0.0, dt)
    end
  end
  return isAny
end

-- Ends the slip of bond n if friction would have reversed it. If the lower body is not moved by
-- that, it is ground for the upper one from now on, else both share their momentum. Returns whether
-- the slip has ended.
local function endSlip(b, list, n)
  local up, low, speed, outset = list.up[n], list.low[n], b.speed, b.outset
  local slip, last = outset[up] - outset[low], speed[up] - speed[low]
  if last * list.tug[n] <= 0 then
    return false
  end
  pull(b, list, n, 0.0)
  if speed[low] == outset[low] then
    stand(b, list, n)
  else
    list.state[n], list.isGlued[n] = BOND, true
    list.slipped[n] = slip * last < 0 and slip * slip / (slip - last) * 0.5 * b.dt or 0.0
  end
  return true
end

-- Decides whether bond n, which holds, breaks because it takes more than friction can give. `need`
-- is what its upper body gives to those on it. Returns the impulse on that, and whether the bond
-- has changed.
local function test(b, list, n, need, mayTear)
  local up, limit = list.up[n], list.limit[n]
  local impulse = need + (b.speed[up] - b.ownSpeed[up]) / b.give[up]
  if mayTear and max(impulse, -impulse) > limit * (1 + 1e-9) + 1e-12 and not b.isPushed[up] then
    impulse = impulse > 0 and limit or -limit
    list.state[n], list.slipped[n] = SLIP, 0.0
    pull(b, list, n, impulse)
    return impulse, true
  end
  local isLost = not list.isGlued[n] and b.speed[up] ~= b.speed[list.low[n]]
  list.isGlued[n] = list.isGlued[n] or isLost
  return impulse, isLost
end

--- Updates the states of all bonds, from the top down:
---
--- - bonds break that take more than friction can give, if `mayTear`. (What is pressed by others on
---   the axis takes an impulse that is not known.)
--- - bodies become one block that had not moved as one;
--- - slips end that have come to their end.
---
--- Returns whether something has changed.
function bonds.check(b, contacts, list, mayTear)
  local need, isPushed, hasChanged = b.load, b.isPushed, false
  for c = 1, contacts.count do
    if b.pressed[contacts.pair[c]] == 1 then
      isPushed[contacts.low[c]], isPushed[contacts.high[c]] = true, true
    end
  end
  for n = 1, list.count do
    need[list.up[n]], need[list.low[n]] = 0, 0
  end
  for n = list.count, 1, -1 do
    local up, low, state = list.up[n], list.low[n], list.state[n]
    if state == SLIP then
      hasChanged = endSlip(b, list, n) or hasChanged
    elseif state == BOND then
      local impulse, isNew = test(b, list, n, need[up], mayTear)
      hasChanged = hasChanged or isNew
      need[low] = need[low] + impulse
      isPushed[low] = isPushed[low] or isPushed[up]
    end
  end
  return hasChanged
end

return bonds
