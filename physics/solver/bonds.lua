--- Bonds: computes which bodies friction holds together, and how the others slip, if both bodies of
-- a contact give way.
--
-- A bond holds two bodies together as one block (see pool.lua) while friction can give the impulse
-- that this takes. Otherwise it slips: friction pulls both with its limit for the whole step, or
-- until they are equally fast and go on as one. Bonds are listed from the supports up. Which of
-- them hold is found by trial. `check` looks at the blocks that came out, and finds the bonds that
-- break and those that have slipped to their end.
--
-- Reads onset, base, grip and the paths on the rubbed axis; writes tug, lead, onset, and blocks.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local flow = require(root .. ".solver.flow")
local pool = require(root .. ".solver.pool")

local bonds = {}

local max = math.max
-- States of a bond:
--
-- - BOND: both move as one.
-- - SLIP: the two slip, and friction pulls with its limit.
-- - STUCK: they have slipped, and move as one from then on.
local BOND, SLIP, STUCK = 1, 2, 3

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
    onset = {}, -- velocity of the upper body at the start, before it stuck
    next = {}, -- next bond on the same lower body
  }
end

--- Returns whether bond n holds, or held until an impact.
function bonds.holds(list, n)
  return list.state[n] ~= SLIP
end

-- Lets bond n pull the upper body with an impulse of `tug`, and the lower body back.
local function pull(b, list, n, tug)
  local up, low, change = list.up[n], list.low[n], tug - list.tug[n]
  b.tug[up], b.tug[low], list.tug[n] = b.tug[up] + change, b.tug[low] - change, tug
  flow.notePulled(b, up)
  flow.notePulled(b, low)
end

--- Adds a bond: body `up` rubs on `low`, which can be moved, with an impulse of at most `limit`.
function bonds.add(b, list, up, low, limit)
  local n = list.count + 1
  list.count = n
  list.up[n], list.low[n], list.limit[n], list.tug[n] = up, low, limit, 0.0
  list.isGlued[n], list.slipped[n], list.state[n] = false, 0.0, BOND
  if b.onset[up] ~= b.onset[low] then
    list.state[n], list.hasSlips = SLIP, true
  end
  b.bondUnder[up], list.next[n], b.bondOn[low] = n, b.bondOn[low], n
end

-- Lets body k begin the step with velocity `onset` and `way` px further on, and what is bonded to
-- it as well.
local function lead(b, list, k, way, onset)
  b.lead[k], b.onset[k] = way, onset
  flow.notePulled(b, k)
  local n = b.bondOn[k]
  while n ~= 0 do
    if list.state[n] == BOND then
      lead(b, list, list.up[n], way, onset)
    end
    n = list.next[n]
  end
end

-- Ends the slip of bond n: after `way` px both bodies are equally fast and go on as one. If the
-- lower body is not moved by that (`stands`), the upper one takes its speed. Else both share their
-- momentum.
local function stick(b, list, n, way, stands)
  local up, low = list.up[n], list.low[n]
  list.state[n], list.isGlued[n] = STUCK, true
  if stands then
    list.onset[n] = b.onset[up]
    lead(b, list, up, b.lead[low] + way, b.onset[low])
  else
    list.onset[n], list.slipped[n] = b.onset[up], way
  end
end

-- Breaks bond n, which takes more than friction can give. `tug` is the impulse on the upper body.
local function tear(b, list, n, tug)
  if list.state[n] == STUCK then
    lead(b, list, list.up[n], 0.0, list.onset[n])
    list.slipped[n] = 0.0
  end
  list.state[n] = SLIP
  pull(b, list, n, tug)
end

-- Returns whether ground holds body k, directly or through bonds, when something on it pulls it
-- with an impulse of `limit`.
local function standsFast(b, list, k, limit, dt)
  local n = b.bondUnder[k]
  while n ~= 0 do
    local low = list.low[n]
    if b.outset[k] ~= b.outset[low] or list.limit[n] < limit then
      return false
    end
    k = low
    n = b.bondUnder[k]
  end
  return b.grip[k] * dt >= limit and b.outset[k] == b.base[k]
end

-- Decides how bond n begins if its upper body slips on the lower one and carries a total of
-- `burden` kg.
local function slide(b, list, n, burden, dt)
  local up, low, limit = list.up[n], list.low[n], list.limit[n]
  local slip, stands = b.outset[up] - b.outset[low], standsFast(b, list, low, limit, dt)
  local drive, give = flow.drive(b, up, dt), 1 / burden
  if not stands then
    drive, give = drive - flow.drive(b, low, dt), give + b.give[low]
  end
  local size, rate = max(slip, -slip), limit * give / dt + (slip > 0 and -drive or drive)
  if size == 0 then
    list.state[n] = BOND
  elseif size <= rate * dt then
    stick(b, list, n, slip * size / rate * 0.5, stands)
  else
    pull(b, list, n, slip > 0 and -limit or limit)
  end
end

--- Decides for all slipping bonds, from the top down, how they go on if other contacts do not
--- interfere.
function bonds.begin(b, list, dt)
  local burden, give = b.burden, b.give
  for n = 1, list.count do
    local up, low = list.up[n], list.low[n]
    burden[up], burden[low] = 1 / give[up], 1 / give[low]
  end
  for n = list.count, 1, -1 do
    local up, low = list.up[n], list.low[n]
    if list.state[n] == SLIP then
      slide(b, list, n, burden[up], dt)
    end
    if list.state[n] ~= SLIP then
      burden[low] = burden[low] + burden[up]
    end
  end
end

-- Marks the bodies that are bonded, directly or through others, to a body that would not move along
-- by itself. Returns whether there are any.
local function markTowers(b, list)
  local mark, stamp, any = b.bondMark, b.forceStamp, false
  for n = 1, list.count do
    local up, low = list.up[n], list.low[n]
    if list.state[n] ~= SLIP then
      local isEven = b.speed[up] == b.speed[low]
        and b.to[up] - b.from[up] == b.to[low] - b.from[low]
      if list.isGlued[n] or not isEven then
        mark[up], mark[low], any = stamp, stamp, true
      end
    end
  end
  for n = any and list.count or 0, 1, -1 do
    if list.state[n] ~= SLIP and mark[list.up[n]] == stamp then
      mark[list.low[n]] = stamp
    end
  end
  for n = 1, any and list.count or 0 do
    if list.state[n] ~= SLIP and mark[list.low[n]] == stamp then
      mark[list.up[n]] = stamp
    end
  end
  return any
end

-- Makes blocks of the marked bonds.
local function glueMarked(b, list, dt)
  local mark, stamp = b.bondMark, b.forceStamp
  for n = 1, list.count do
    local up, low = list.up[n], list.low[n]
    if list.state[n] ~= SLIP and mark[up] == stamp and mark[low] == stamp then
      list.isGlued[n] = true
      pool.glue(b, up, low, list.slipped[n], dt)
    end
  end
end

--- Makes blocks of the bonds that would not hold otherwise. Returns whether there are any.
function bonds.glue(b, list, dt)
  local isAny = markTowers(b, list)
  if isAny then
    glueMarked(b, list, dt)
  end
  return isAny
end

-- Finds which bodies are pressed by others on the axis: the impulse that their bonds must give is
-- not known.
local function findPressed(b, contacts, awakeCount)
  local awake, isPressed, axis = b.awakeList, b.isPressed, contacts.axis
  for n = 1, awakeCount do
    isPressed[2 * awake[n] + axis] = false
  end
  for c = 1, contacts.count do
    if b.pressed[contacts.pair[c]] == 1 then
      isPressed[contacts.low[c]], isPressed[contacts.high[c]] = true, true
    end
  end
end

-- Updates the states of all bonds (see bonds.check).
local function checkAll(b, list, dt, mayTear)
  local need, isPressed, hasChanged = b.load, b.isPressed, false
  local speed, outset = b.speed, b.outset
  for n = 1, list.count do
    local up, low = list.up[n], list.low[n]
    need[up], need[low] = 0, 0
  end
  for n = list.count, 1, -1 do
    local up, low, limit, state = list.up[n], list.low[n], list.limit[n], list.state[n]
    if state == SLIP then
      local slip, last = outset[up] - outset[low], speed[up] - speed[low]
      if last * list.tug[n] > 0 then -- friction would have reversed the slip
        local way = slip * last < 0 and slip * slip / (slip - last) * 0.5 * dt or 0.0
        pull(b, list, n, 0.0)
        stick(b, list, n, way, speed[low] == outset[low])
        hasChanged = true
      end
    else
      local impulse = need[up] + (speed[up] - b.ownSpeed[up]) / b.give[up]
      local isTorn = mayTear and max(impulse, -impulse) > limit * (1 + 1e-9) + 1e-12
      if isTorn and not isPressed[up] then
        impulse = impulse > 0 and limit or -limit
        tear(b, list, n, impulse)
        hasChanged = true
      elseif not list.isGlued[n] and speed[up] ~= speed[low] then
        list.isGlued[n], hasChanged = true, true
      end
      need[low] = need[low] + impulse
      isPressed[low] = isPressed[low] or isPressed[up]
    end
  end
  return hasChanged
end

--- Updates the states of all bonds, from the top down:
---
--- - bonds break that take more than friction can give, if `mayTear`;
--- - bodies become one block that had not moved as one;
--- - slips end that have come to their end.
---
--- Returns whether something has changed.
function bonds.check(b, contacts, list, dt, mayTear)
  findPressed(b, contacts, b.awakeCount)
  return checkAll(b, list, dt, mayTear)
end

return bonds
