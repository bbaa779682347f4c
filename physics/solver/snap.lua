---@diagnostic disable
--- Snap: an object that stood on something stays on the ground when that drops by a little.
--
-- It is the other half of nudge: nudge goes up stairs, snap goes down.
--
--      [ ]- - ->[ ]           without snap: it flies off the edge
--      #######   |
--      #######   v lowered by at most `snap` px
--      #######  [ ]
--      ###############
--
-- When all paths of the step are known, an object with `snap` that has run off its support is
-- lowered onto the ground below, together with the objects that stand on it. It is lowered straight
-- down, from the place where it ends, onto the first ground there is, unless something round is in
-- the way; so it passes through nothing.
-- If it has run over several edges in the step, each edge may be as high as `snap`: the walk along
-- the ground is made again, with leave to drop that far at each edge.
--
-- One pass is enough, because the lowest bodies come first: when a rider's turn comes, its support
-- is in place. (A `height` here is that of the place along gravity: the lowest has the least. What
-- `lower` compares is as in ground.lua: the further up, the less.)
--
-- Only boxes with a support are lowered (so no sensors), not onto round ground, and only if they
-- do not move up in the step. A body is put there first, so that its new neighbours are known, and
-- put back if one forbids it. A lowered body takes the speed of its ground; those that stand on it
-- may go down by as much as it did (`lowered`).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".narrowphase.ball")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local ground = require(root .. ".solver.ground")
local links = require(root .. ".memory.links")
local pairFinder = require(root .. ".broadphase.pairFinder")
local path = require(root .. ".motion.path")
local rules = require(root .. ".narrowphase.rules")
local shapes = require(root .. ".space.shapes")
local sort = require(root .. ".memory.sort")
local walk = require(root .. ".solver.walk")
local yielding = require(root .. ".narrowphase.yielding")

local snap = {}

local DYNAMIC, EPSILON = constants.DYNAMIC, constants.EPSILON
local max, min = math.max, math.min

-- Returns whether slot i may be lowered, by its own `snap` or with its support: it has begun the
-- step standing, and does not go up from there. (Circles roll over edges.)
local function stands(b, i)
  local k = 2 * i + path.axisOf(b, i)
  return b.support[i] ~= 0
    and (b.snap[i] > 0 or b.kind[b.support[i]] == DYNAMIC)
    and b.down[k] ~= 0 -- it is dynamic
    and shapes.isBox[b.shape[i]]
    and b.displacement[k] * b.down[k] >= 0
end

-- Returns whether slot i ends in something round, beside which it would be lowered.
local function endsInCircle(b, i)
  for _, j, p in links.neighbours(b, i) do
    local mayTouch = ball.isRound(b, i, j) and filter.areSolid(b, i, j) and not b.passing[p]
    if mayTouch and ball.gapIn(b, b.to, i, j) < -EPSILON then
      return true
    end
  end
  return false
end

-- Puts slot i onto slot j, at a height, unless a rule or the game says that the two pass.
local function put(b, i, j, k, turn, height)
  local m, place, v, a = 2 * j + k % 2, b.to[k], b.speed[k], b.accel[k]
  path.finish(b, k, turn * height, b.speed[m], b.accel[m])
  b.stack[1] = i
  pairFinder.run(b, b.stack, 1)
  local p = links.pairOf(b, i, j)
  local passes = not p or b.hasRound and endsInCircle(b, i)
  if passes or rules.passes(b, p, turn > 0 and k or m, turn > 0 and m or k, k % 2, false) then
    path.finish(b, k, place, v, a)
    return
  end
  b.pressedAt[2 * k + (turn > 0 and 2 or 1)] = b.solveStamp
  yielding.leanOn(b, k, m, -turn)
  b.snaps.lowered[i] = (b.to[k] - place) * turn
end

-- Lowers slot i by at most `most` px at each edge.
local function lower(b, i, most)
  local axis = path.axisOf(b, i)
  local k, t = 2 * i + axis, 2 * i + 1 - axis
  local turn, x = b.down[k], b.to[t]
  local x0, here = path.home(b, t), turn * b.to[k]
  local start, low = turn * path.home(b, k), here + most
  local drop = max(here - start, start - here) + most * (1 + max(x - x0, x0 - x))
  ground.list(b, i, x0, x, min(start, here), drop) -- (nudge may have lifted it)
  local j, height = ground.envelope(b, x, x, here)
  if j ~= 0 and height > low + EPSILON then
    b.walkWork.count = 0 -- no path follows the pieces any more
    local _, last = walk.follow(b, x0, x, start, false, most)
    low = last + most
  end
  local isLower = height > here + EPSILON and height <= low + EPSILON
  if j ~= 0 and isLower and not shapes.isRound[b.shape[j]] then
    put(b, i, j, k, turn, height)
  end
end

--- Lowers the objects that have run off their supports, and the objects that stand on them, the
--- lowest first.
function snap.run(b)
  b.snaps = b.snaps or { list = {}, height = {}, lowered = {} } -- px in this step
  local lowered, list, height, count = b.snaps.lowered, b.snaps.list, b.snaps.height, 0
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    lowered[i] = 0
    if stands(b, i) then
      local k = 2 * i + path.axisOf(b, i)
      count = count + 1
      list[count], height[i] = i, -b.down[k] * b.to[k]
    end
  end
  sort.by(list, count, height, b.rank, b.rank)
  for n = 1, count do
    local i = list[n]
    local most = max(b.snap[i], lowered[b.support[i]] or 0)
    if most > 0 then
      lower(b, i, most)
    end
  end
end

return snap
