--- Permission: asks the game whether a pair may collide (`canCollide` of an object or of the
-- world).
--
-- Writes heard.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local fail = require(root .. ".fields.check").fail

require(root .. ".memory.jit").file()

local ask = {}

local SIDES = columns.SIDES

local function answer(b, callback, one, other, side)
  b.asking = true
  local ok, result = pcall(callback, one, other, side)
  b.asking = false
  if not ok then
    error(result, 0)
  end
  if result == nil and b.world.checked then
    fail("canCollide must return true or false, got nothing (which means true)")
  end
  return result ~= false
end

--- Returns whether the game must be asked about a pair.
function ask.isAsked(b, i, j)
  return b.worldCanCollide or b.canCollide[i] or b.canCollide[j]
end

--- Returns whether a pair may collide on `axis`. It asks `canCollide` of both objects, then that of
--- the world. An error in one of them passes through, and the step is given up with nothing
--- changed.
function ask.permits(b, low, high, axis)
  local world = b.worldCanCollide
  if not ask.isAsked(b, low, high) then
    return true
  end
  -- The answer may be different in the next step, so these two must not sleep.
  b.heard[low], b.heard[high] = true, true
  local one, other = low, high
  if b.rank[high] < b.rank[low] then
    one, other = high, low
  end
  local lowSide, highSide = SIDES[2 * axis + 2], SIDES[2 * axis + 1]
  local sideOne = one == low and lowSide or highSide
  local sideOther = one == low and highSide or lowSide
  local objectOne, objectOther = b.object[one], b.object[other]
  if b.canCollide[one] and not answer(b, b.canCollide[one], objectOne, objectOther, sideOne) then
    return false
  end
  if
    b.canCollide[other] and not answer(b, b.canCollide[other], objectOther, objectOne, sideOther)
  then
    return false
  end
  return not world or answer(b, world, objectOne, objectOther, sideOne)
end

return ask
