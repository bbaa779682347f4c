---@diagnostic disable
--- Rules: decides whether two bodies pass through each other in a step, from the solid sides of
-- one-way objects, `dropThrough`, and the answer of the game (`canCollide`).
--
-- Answers are remembered with the pair: `passing` for this step (pairFinder clears it), `dropping`
-- until the two are apart, `asked`: the solve in which the game has said yes, or minus that, no.
--
-- The side in the field `oneWay` is solid, the others are open. That is decided in `filter.isOpen`
-- and, of lines, in `lets` of queries/rays.lua. The side of a slanted meeting, and so the solid
-- quarter of a round one-way object, is that of `shapes.sideOf`, which names sides everywhere:
-- `filter.isOpen` gets no normal. Its callers choose the side, and tell the game that side:
-- `sweep.meet` for impacts, `passes` in solver/slant.lua for planes, `sideOf` in
-- contacts/contactState.lua for contacts that go on, `wallOf` in solver/bounds.lua for walls in
-- which a body would end; for queries `query.meet`, `lets` in rays.lua, and move.lua. (Ground and
-- snap know slopes and boxes.) Another limit than 45° is a function of the pair and the normal in
-- place of `shapes.sideOf` there.
-- For `filter.areSolid` and `filter.blocks` a one-way object is no obstacle: their callers leave it
-- out.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".fields.check")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local links = require(root .. ".memory.links")
local path = require(root .. ".motion.path")
local touch = require(root .. ".narrowphase.touch")

local rules = {}

local DYNAMIC, neighbours = constants.DYNAMIC, links.neighbours
local OPPOSITE, SIDES = constants.OPPOSITE, constants.SIDES
local floor = math.floor

-- Returns whether slot i falls through a one-way object with the side `solid`.
-- Until it is clear of that object, no other one-way object with the same side holds it, as the
-- next plank of a bridge would.
local function isFalling(b, i, solid)
  for _, j, p in neighbours(b, i) do
    if b.dropping[p] and b.oneWay[j] == solid then
      return true
    end
  end
  return false
end

-- Returns whether slot i falls through the one-way slot j, or slot j through slot i.
local function isDropping(b, i, j)
  local ownSide, otherSide = b.oneWay[i], b.oneWay[j]
  return otherSide and isFalling(b, i, otherSide) or ownSide and isFalling(b, j, ownSide)
end

--- Returns whether i and j, which meet on `side` of i, pass through each other because one is a
--- one-way object. A body that overlaps a one-way object already (`isDeep`) always passes.
function rules.lets(b, i, j, side, isDeep)
  if not (b.oneWay[i] or b.oneWay[j]) then
    return false
  end
  return isDeep or filter.isOpen(b, i, j, side) or isDropping(b, i, j)
end

-- Asks the game. An error in its function passes through, and the step is given up with nothing
-- changed.
local function answer(b, callback, one, other, side)
  if not callback then
    return true
  end
  b.asking = "canCollide"
  local ok, result = pcall(callback, one, other, side)
  b.asking = nil
  if not ok then
    b.solveStamp = b.solveStamp + 1 -- the next step asks all anew
    error(result, 0)
  elseif result == nil and b.world.checked then
    check.fail("canCollide must return true or false, got nothing (which means true)")
  end
  return result ~= false
end

--- Returns whether the game must be asked about a pair.
function rules.isAsked(b, i, j)
  return b.worldCanCollide or b.canCollide[i] or b.canCollide[j]
end

--- Returns whether a pair may collide on `axis`. It asks `canCollide` of both objects, in the order
--- of the world, then that of the world.
function rules.permits(b, low, high, axis)
  if not rules.isAsked(b, low, high) then
    return true
  end
  -- The answer may be different in the next step, so these two must not sleep.
  b.isPolled[low], b.isPolled[high] = true, true
  local i, j, side = low, high, 2 * axis + 2
  if b.rank[high] < b.rank[low] then
    i, j, side = high, low, 2 * axis + 1
  end
  local one, other, sideName = b.object[i], b.object[j], SIDES[side]
  return answer(b, b.canCollide[i], one, other, sideName)
    and answer(b, b.canCollide[j], other, one, SIDES[OPPOSITE[side]])
    and answer(b, b.worldCanCollide, one, other, sideName)
end

--- Returns whether pair p may collide, before the first solve of a step (the stamp of which is one
--- more), which does not ask again.
function rules.foresees(b, p, low, high, axis)
  local stamp = b.solveStamp + 1
  if b.asked[p] ~= stamp and b.asked[p] ~= -stamp then
    b.asked[p] = rules.permits(b, low, high, axis) and stamp or -stamp
  end
  return b.asked[p] == stamp
end

--- Returns whether the bodies of pair p pass through each other on an axis, and notes it. `kl` and
--- `kh` are the indices of the low body and the high one. `isDeep`: they overlap already. The game
--- is asked once a solve about each pair: a step that begins anew asks again.
function rules.passes(b, p, kl, kh, axis, isDeep)
  if b.passing[p] or b.dropping[p] then
    return true
  end
  local low, high = floor(kl * 0.5), floor(kh * 0.5)
  if rules.lets(b, low, high, 2 * axis + 2, isDeep) then
    b.dropping[p] = isDropping(b, low, high)
    return true
  elseif not b.hasRules or b.asked[p] == b.solveStamp then
    return false
  end
  local isRefused = b.asked[p] == -b.solveStamp -- see `foresees`
  b.asked[p] = b.solveStamp
  b.passing[p] = isRefused or not rules.permits(b, low, high, axis)
  return b.passing[p]
end

-- Gives slot i, which falls through slope j, the speed at which the edge sinks under it, in the
-- game's table. Else it would be left above the edge where it runs down.
local function keepUp(b, i, j)
  local axis, object = path.axisOf(b, i), b.object[i]
  local along, across = axis == 0 and "vx" or "vy", axis == 0 and "vy" or "vx"
  local speed = touch.gradient(b, i, j) * (object[across] or 0)
  if (speed - (object[along] or 0)) * b.down[2 * i + axis] > 0 then
    object[along] = speed
  end
end

--- Makes slot i fall through the one-way objects that it stands on, by the contacts of the last
--- step. Returns whether there were any.
--- An object that is not dynamic stands on nothing, nor does an object without gravity.
function rules.drop(b, i)
  if b.kind[i] ~= DYNAMIC or (b.down[2 * i] == 0 and b.down[2 * i + 1] == 0) then
    return false
  end
  local x, y, any = b.down[2 * i], b.down[2 * i + 1], false
  local foot = x ~= 0 and 1.5 + 0.5 * x or 3.5 + 0.5 * y -- left, right, top, bottom are 1 to 4
  for _, j, p in neighbours(b, i) do
    local side = b.contact[p] -- side of the first body of the pair, 0: none
    if b.pairA[p] ~= i then
      side = OPPOSITE[side]
    end
    if side == foot and b.oneWay[j] then
      b.dropping[p], any = true, true
      keepUp(b, i, j)
    end
  end
  return any
end

return rules
