--- Rules: decides whether a contact may act, from open sides of one-ways, `dropThrough` and
-- `canCollide`.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local permission = require(root .. ".solver.permission")
local activePairs = require(root .. ".broadphase.activePairs")
local oneWay = require(root .. ".solver.oneWay")

require(root .. ".memory.jit").file()

local rules = {}

local floor = math.floor

--- Returns whether the bodies of pair p pass through each other on an axis. `kl` and `kh` are the
--- indices of the low body and the high one. `isDeep`: they overlap already. The game is asked once
--- a solve about each pair: a step that begins anew asks again.
function rules.passes(b, p, kl, kh, axis, isDeep)
  if b.passing[p] or b.dropping[p] then
    return true
  end
  local low, high = floor(kl * 0.5), floor(kh * 0.5)
  if oneWay.lets(b, low, high, 2 * axis + 2, isDeep) then
    b.dropping[p] = oneWay.isDropping(b, low, high)
    return true
  end
  if not b.hasAskers or b.asked[p] == b.solveStamp then
    return false
  end
  b.asked[p] = b.solveStamp
  if permission.permits(b, low, high, axis) then
    return false
  end
  b.passing[p] = true
  activePairs.stain(b, p)
  return true
end

return rules
