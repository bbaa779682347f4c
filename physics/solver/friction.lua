---@diagnostic disable
--- Coulomb friction: computes from the loads of the contacts of one axis how they brake their
-- bodies along the other axis.
--
-- Coulomb's law: friction brakes the slip of two bodies with an impulse of at most mu times the
-- load, the impulse with which they press each other. The axis of the load is settled before, so
-- the loads are known, and friction does not change them in this step.
--
--            [  a  ]              load of a on b: the impulse that settling took off a,
--         [     b     ]             m (free speed - speed)
--      ///////////////////        load of b on the ground: that of a, and the impulse taken off b
--
-- The load of a body is summed up from the top of a stack down, and goes to one support: the one
-- with the widest common edge (`findSupports`). Slanted contacts add no load, as they are solved
-- after friction: a ball under a heap rubs with its own weight. A load has two parts:
--
-- - Weight, the part that the body's own acceleration causes. It acts through the whole step, as a
--   constant grip of mu weight / dt.
-- - An impact, the rest. On ground it rubs at once: it changes the velocity with which the step
--   begins (`onset`) by at most mu (load - weight) / m. A bond has one limit for both parts.
--
-- Then the contacts rub, from the supports up, because the speed of a support must be known
-- before a body rubs on it. There are two cases:
--
-- - Ground is a support that cannot be moved along the surface (`addGround`). The body slides,
--   stops, turns or sticks on it exactly (see flow.lua).
-- - A support that can be moved: a bond up to mu times the load (`bonds.add`).
--
-- One pass would be enough if all supports were ground. Bonds may break or form when the other axis
-- is settled, so that is repeated up to ATTEMPTS times (see bonds.lua).
--
-- The coefficient mu of a pair is `friction.coefficient`. It is multiplied into the limit of
-- friction in four places: these two, and `bear` and `rubBoth` in impact.lua, for two bodies that
-- meet inside the step. The limit of a contact is one number for the whole step.
--
-- A field that changes the coefficient (as rolling friction of round bodies, for which
-- `shapes.isRound[b.shape[i]]` of space/shapes.lua is true) is a row of fields/fields.lua with
-- `hint = "hasFriction"`, and a term in all three results of `friction.coefficient`, which all
-- four places ask: symmetric in i and j. (Contacts are not only with floors: a ball at a wall, a
-- box on a ball. A field for floors only is a factor in `addContact` here and in `rub` of
-- impact.lua, which know the axis.) Slanted contacts (a ball on a slope, on a corner, or beside
-- the middle of another ball) have none: see ARCHITECTURE, friction.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local bonds = require(root .. ".solver.bonds")
local carriers = require(root .. ".motion.carriers")
local constants = require(root .. ".memory.constants")
local contacts = require(root .. ".solver.contacts")
local flow = require(root .. ".solver.flow")
local path = require(root .. ".motion.path")
local settle = require(root .. ".solver.settle")

local friction = {}

local EPSILON = constants.EPSILON
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- Number of attempts in which bonds may break, and of all attempts (see bonds.lua).
local TEARS, ATTEMPTS = 2, 4

--- Returns the coefficient of friction of a pair: the geometric mean of both. If a body has no
--- coefficient of its own (an immovable body may have none), the other body's counts.
function friction.coefficient(b, i, j)
  local one, other = b.friction[i], b.friction[j]
  if other < 0 or one == other then
    return max(one, 0)
  elseif one < 0 then
    return other
  end
  return sqrt(one * other)
end

-- Chooses the support of body k, of which contact c is one more candidate. The one with the widest
-- common edge wins, and of equal ones the first in the order of the world.
local function chooseSupport(b, list, k, c, other)
  local best, isBetter = b.bearer[k], true
  if best ~= 0 then
    local wider = list.width[c] - list.width[best]
    local bestOther = list.bearing[best] > 0 and list.high[best] or list.low[best]
    local isFirst = b.rank[floor(other * 0.5)] < b.rank[floor(bestOther * 0.5)]
    isBetter = wider > EPSILON or (wider > -EPSILON and isFirst)
  end
  b.bearer[k] = isBetter and c or best
end

-- Returns whether body k leans on body m, towards high coordinates (`sign` 1) or low ones (-1): it
-- has lost speed to m. Where m is held, m must be immovable, or gravity act that way, or m lean
-- there, too (else a bond below k may have stopped both as one block). Where m is not held, gravity
-- must act that way, and m have lost no speed.
local function leans(b, list, k, m, sign)
  local lost = b.give[k] > 0 and (b.freeSpeed[k] - b.speed[k]) * sign or -1
  if lost < 0 then
    return false
  elseif b.held[2 * m + (sign > 0 and 2 or 1)] > 0 then
    return b.give[m] == 0 or b.down[k] == sign or list.bearing[b.bearer[m]] == sign
  end
  return lost > 0 and b.down[k] == sign and (b.speed[m] - b.freeSpeed[m]) * sign >= 0
end

-- Finds the contacts that bear a load, from the supports up, and for each body the contact that
-- bears its load.
local function findSupports(b, list, axis)
  local awake, bearer, load, weight = b.awakeList, b.bearer, b.load, b.weight
  for n = 1, b.awakeCount do
    local k = 2 * awake[n] + axis
    bearer[k], load[k], weight[k] = 0, 0, 0
  end
  local to, from, size, bearing, across = b.to, b.from, b.size, list.bearing, 1 - 2 * axis
  for sign = 1, -1, -2 do
    local up, low = contacts.along(list, sign)
    local _, _, first, last = contacts.along(list, -sign)
    for c = first, last, -sign do
      local k, m = up[c], low[c]
      local over = (to[k] - to[m]) * sign + list.separation[c]
      bearing[c] = sign < 0 and bearing[c] or 0
      local isFlush = over <= EPSILON and over >= -EPSILON
      if bearing[c] == 0 and isFlush and leans(b, list, k, m, sign) then
        local tk, tm = k + across, m + across
        bearing[c] = sign
        list.width[c] = min(from[tk] + size[tk], from[tm] + size[tm]) - max(from[tk], from[tm])
        chooseSupport(b, list, k, c, m)
      end
    end
  end
end

-- Adds to the load of body `up`, so far that of the bodies on it, the impulse that was taken off it
-- in this step, and passes all on to its support. The part that its own acceleration has caused
-- counts as weight; the rest is an impact. (The velocity that its carrier gives it in each step,
-- and a wall takes off again, is no load.)
local function addLoad(b, up, low, sign, dt)
  local mass, start, speed = 1 / b.give[up], b.start[up], b.speed[up]
  local free, air = b.freeSpeed[up] + b.reserve[up], b.flowAir[floor(up * 0.5)]
  if air ~= 0 then -- air friction that would slow its fall bears no load
    free = start + (path.pullOf(b, up) - air * (speed - b.carried[up])) * dt
  end
  local gift = b.carried[up] - carriers.given(speed, b.carried[up])
  local impulse, pull = (free - gift - speed) * sign * mass, max((free - start) * sign * mass, 0.0)
  local load = b.load[up] + impulse
  local weight = min(load, b.weight[up] + pull)
  b.load[up], b.weight[up] = load, weight
  b.load[low], b.weight[low] = b.load[low] + load, b.weight[low] + weight
end

-- Notes that body k rubs on ground that moves at `base`. The part of the load that is an impact
-- rubs at once.
local function addGround(b, k, base, mu, load, weight, dt)
  load, weight = mu * load, mu * weight
  local slip, jolt = b.onset[k] - base, (load - weight) * b.give[k]
  if jolt > 0 then
    b.onset[k] = base + (slip > jolt and slip - jolt or slip < -jolt and slip + jolt or 0.0)
  end
  local drag = b.base[k] == base and b.grip[k] or 0 -- that acts like friction of this ground
  b.base[k], b.grip[k] = base, weight / dt + drag
  flow.notePulled(b, k)
end

-- Notes that body ku, which leans on body ks, rubs along the other axis: on ground, or through a
-- bond.
local function addContact(b, axis, held, ku, ks, dt)
  local i, j, load = floor(ku * 0.5), floor(ks * 0.5), b.load[ku]
  local mu = friction.coefficient(b, i, j)
  if mu <= 0 or load <= 0 then
    return
  end
  local tu, ts = ku + 1 - 2 * axis, ks + 1 - 2 * axis
  if b.give[ts] == 0 then
    addGround(b, tu, carriers.surface(b, i, j, axis), mu, load, b.weight[ku], dt)
  else
    bonds.add(b, held, tu, ts, mu * load)
  end
end

-- Sums up the loads from the uppermost bodies down to the supports; or, with `rubs`, makes all
-- contacts rub, from the supports up.
local function walk(b, list, held, dt, rubs)
  for sign = 1, -1, -2 do
    local up, low = contacts.along(list, sign)
    local way = rubs and -sign or sign
    local _, _, first, last = contacts.along(list, way)
    for c = first, last, way do
      local isBorne = list.bearing[c] == sign and b.bearer[up[c]] == c -- with all its load
      if isBorne and rubs then
        addContact(b, list.axis, held, up[c], low[c], dt)
      elseif isBorne then
        addLoad(b, up[c], low[c], sign, dt)
      end
    end
  end
end

--- Applies the friction of the contacts of a settled axis along the other one, and settles that
--- (see `settleTouching` in solver). Returns false, and does nothing, if no contact rubs.
function friction.run(b, axis, dt)
  b.bonds = b.bonds or { [0] = bonds.new(), bonds.new() }
  local list, other, held = b.contacts[axis], 1 - axis, b.bonds[1 - axis]
  local rubbed = b.contacts[other]
  findSupports(b, list, axis)
  walk(b, list, held, dt, false)
  held.count, held.hasSlips = 0, false
  b.pulledCount, b.forceStamp = 0, b.forceStamp + 1
  walk(b, list, held, dt, true)
  if b.pulledCount == 0 and held.count == 0 then
    return false
  end
  local isGlued = false
  for attempt = 1, ATTEMPTS do
    flow.reset(b, other, dt)
    flow.runAll(b, dt)
    local areLeft = settle.hold(b, rubbed, dt)
    isGlued = bonds.glue(b, held, dt)
    if areLeft or isGlued then
      settle.finish(b, rubbed, dt, false)
    end
    local mayChange = attempt < ATTEMPTS and (areLeft or isGlued or held.hasSlips)
    if not (mayChange and bonds.check(b, rubbed, held, attempt <= TEARS)) then
      break
    end
  end
  if isGlued then
    bonds.release(b, rubbed, held)
  end
  return true
end

return friction
