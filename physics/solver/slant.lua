---@diagnostic disable
--- Slants: lists the pairs of a step with a circle that touch slanted: two circles, a circle and a
-- corner, a circle and a slope. `press` solves them.
--
-- Each of these pairs gets a *plane*: the tangent where the two touch, or will meet.
--
--           n                Along the normal n, which leads from `other` to `one`, the two must
--           ^     o ->       end at least `least` px apart: the difference of their places along
--      -----|----(-)-----    it, now if they touch, else where they meet.
--           o
--          (-)
--
-- Both shapes are convex. So bodies on their own sides of the plane cannot overlap, at any speed
-- and wherever else they go. So a pair with a plane is swept no more (`SLANTED` in contacts). Pairs
-- that bounce get no plane: they have impacts. Each solve begins with an empty list.
--
-- Planes are found in four ways: of pairs that touch when the step begins (`takes`), that will meet
-- on their paths (`find`), that meet in a round and do not bounce (`meet`), and that end in each
-- other all the same (`findLate`).

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".narrowphase.ball")
local boxes = require(root .. ".space.boxes")
local constants = require(root .. ".memory.constants")
local contacts = require(root .. ".solver.contacts")
local filter = require(root .. ".broadphase.filter")
local impact = require(root .. ".solver.impact")
local links = require(root .. ".memory.links")
local pairFinder = require(root .. ".broadphase.pairFinder")
local path = require(root .. ".motion.path")
local rules = require(root .. ".narrowphase.rules")
local shapes = require(root .. ".space.shapes")
local yielding = require(root .. ".narrowphase.yielding")

local slant = {}

local APART, SLANTED = contacts.APART, contacts.SLANTED
local DYNAMIC, EPSILON = constants.DYNAMIC, constants.EPSILON
local gapIn, slotsOf = ball.gapIn, links.slotsOf
local huge, max, min = math.huge, math.max, math.min
-- Two that can both be moved get a plane although they may not meet if they are nearer than this
-- share of the smaller size, and slower than that share in a step: others may push them together.
local NEAR, SLOW = 0.1, 0.25
-- Share of an overlap beyond the slop that is taken away in a step.
local PACE = 0.5
-- A pair that lies still takes a new impulse if that is below this share of its own. (With 0.6 some
-- heaps rest later than they should.)
local KEPT = 0.25

--- Prepares the list of a world for a new solve.
function slant.begin(b)
  local s = b.slants
  if not s.pair then
    s.stamp, s.base = 0, {}
    -- By plane: its pair, and the slots of it, the first in the order of the world first; the unit
    -- normal from `other` to `one`, and the distance along it.
    s.pair, s.one, s.other, s.nx, s.ny, s.least = {}, {}, {}, {}, {}, {}
    s.slop = {} -- px by which they may be nearer
    s.time, s.speed = {}, {} -- when they meet, and how fast
    s.isNew, s.isFlush = {}, {} -- it was not solved yet; the two touch at the end of the step
    -- By how much they are pushed apart: places, kg px; speeds, kg px/s; places by shocks, kg px.
    s.push, s.impulse, s.lift = {}, {}, {}
    s.start = {} -- impulse with which the passes begin, see `weigh` in press
    s.height, s.first, s.second, s.new = {}, {}, {}, {} -- the order, see `listRows` in press
    s.dx, s.dy, s.ex, s.ey, s.total = {}, {}, {}, {}, {} -- effects of a push of 1, see press
    -- Rows of press, in order; by slot, stamps: it is connected with something violated; it is
    -- beside walls; the slots of these, by slot the first row of each, and by row the next one; by
    -- slot: the last solve that it found no place in front of all its walls.
    s.rows, s.walledCount, s.order, s.mark = 0, 0, {}, {}
    s.wallsAt, s.walled, s.firstWall, s.nextWall, s.viceAt = {}, {}, {}, {}, {}
    s.pushedAt, s.pushOf, s.impulseOf = {}, {}, {} -- by pair: the solve of these pushes, see press
    s.leansAt = {} -- by slot: when something immovable touched it slanted as a step began
  end
  s.count, s.kept = 0, 0
end

--- Returns how high slots i and j are against the gravity of the world; if one of them is
--- immovable, higher than all pairs that can move.
function slant.heightOf(b, i, j)
  local axis = b.downAxis
  local one, other = b.from[2 * i + axis], b.from[2 * j + axis]
  local height = b.orientation[axis] > 0 and -max(one, other) or min(one, other)
  local areDynamic = b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC
  return areDynamic and (path.isPulled(b, i) or path.isPulled(b, j)) and height or huge
end

--- Returns the difference of the places (or velocities) of two bodies along a normal.
function slant.along(column, i, j, nx, ny)
  local k, m = 2 * i, 2 * j
  return (column[k] - column[m]) * nx + (column[k + 1] - column[m + 1]) * ny
end

local along = slant.along

-- Returns whether the normal of pair p is an axis, or the two pass through each other along it: the
-- game is asked.
local function passes(b, p, i, j, nx, ny, isDeep)
  if nx == 0 or ny == 0 then
    return true
  end
  local axis, isLow = shapes.sideOf(nx, ny, false)
  local low = isLow and i or j
  return rules.passes(b, p, 2 * low + axis, 2 * (i + j - low) + axis, axis, isDeep)
end

-- Returns whether two bodies that close at u px/s are left to an impact: they are elastic, and
-- faster than gravity makes them in two steps (without gravity at any speed).
local function isElastic(b, i, j, u)
  if yielding.elasticity(b, i, j) == 0 then
    return false
  end
  local pull = max(path.largest(b.pull, 2 * i), path.largest(b.pull, 2 * j))
  return pull == 0 or u > 2 * b.dt * pull
end

-- Returns whether slots i and j can press each other.
local function mayPress(b, i, j)
  return b.give[2 * i] + b.give[2 * j] > 0 and min(b.power[i], b.power[j]) < huge
end

-- Makes a plane of pair p, which closes at u px/s.
local function put(b, p, nx, ny, least, time, u)
  local s, i, j = b.slants, slotsOf(b, p)
  local c = s.count + 1
  s.count, s.pair[c], s.one[c], s.other[c], s.nx[c], s.ny[c], s.least[c] = c, p, i, j, nx, ny, least
  s.time[c], s.speed[c], s.slop[c] = time, u, ball.slop(b, i, j)
  s.height[c], s.first[c], s.second[c] = slant.heightOf(b, i, j), b.rank[i], b.rank[j]
  s.push[c], s.impulse[c], s.total[c], s.isNew[c], s.isFlush[c] = 0.0, 0.0, 1.0, true, false
  s.start[c] = b.lastImpulse[p]
  b.touches[p] = SLANTED
end

local function noteHit(b, p, nx, ny, time, speed)
  local i, j = slotsOf(b, p)
  local axis, isLow = shapes.sideOf(nx, ny, false)
  impact.note(b, p, isLow and i or j, axis, speed, time)
end

--- Makes a plane of pair p, which touches or overlaps where the step begins, if it is slanted.
--- Returns whether it is.
function slant.takes(b, p)
  local i, j = slotsOf(b, p)
  if ball.isCaught(b, p) or not (ball.isRound(b, i, j) and mayPress(b, i, j)) then
    return false
  end
  local gap, nx, ny = gapIn(b, b.from, i, j)
  local u, slop = -along(b.speed, i, j, nx, ny), ball.slop(b, i, j)
  local bounces = gap >= -slop and (gap >= -EPSILON or u > 0) and isElastic(b, i, j, u)
  local isFar = gap > EPSILON or gap < -ball.LOST * ball.smallest(b, i, j)
  if bounces or isFar or passes(b, p, i, j, nx, ny, gap < -EPSILON) then
    return false
  end
  local target = gap < -slop and -slop + (gap + slop) * (1 - PACE) or min(gap, 0.0)
  put(b, p, nx, ny, along(b.from, i, j, nx, ny) - gap + target, 0.0, u)
  if b.give[2 * i] == 0 or b.give[2 * j] == 0 then
    b.slants.leansAt[b.give[2 * i] == 0 and j or i] = b.solveStamp
  end
  return true
end

-- Returns when two bodies meet on their paths (1: they are only near), the normal there, and px to
-- there; nil: they do not, or they are in each other. (They are convex: to meet they must close
-- their gap along its normal.)
local function meeting(b, i, j)
  local size, from, to, shape, k, m = b.size, b.from, b.to, b.shape, 2 * i, 2 * j
  local dx = to[k] - from[k] - to[m] + from[m]
  local dy = to[k + 1] - from[k + 1] - to[m + 1] + from[m + 1]
  local smallest, distance = ball.smallest(b, i, j), max(dx, -dx, dy, -dy)
  local near = min(NEAR * smallest, pairFinder.REACH)
  if boxes.gap(b, from, i, j) > max(distance, near) then
    return nil
  end
  local gap, nx, ny = gapIn(b, from, i, j)
  if gap >= -EPSILON and -nx * dx - ny * dy > gap then
    local x, y, ox, oy = from[k], from[k + 1], from[m], from[m + 1]
    shapes.setPair(shape[i], x, y, size[k], size[k + 1], shape[j], ox, oy, size[m], size[m + 1])
    local share, itsX, itsY = shapes.meet(dx, dy, b.downAxis, 0.0, 0.0)
    if share then
      return share, itsX, itsY, -share * (dx * itsX + dy * itsY)
    end
  end
  local isIn = gap < -EPSILON or gap > near or distance > SLOW * smallest
  local areLoose = b.give[k] > 0 and b.give[m] > 0
  return areLoose and not isIn and 1.0 or nil, nx, ny, max(gap, 0.0)
end

-- Makes a plane of pair p if it is apart and will meet slanted, or is near and slow (one-way
-- objects: never).
local function findPair(b, p)
  local i, j = slotsOf(b, p)
  local time, nx, ny, gap = meeting(b, i, j)
  if not (time and mayPress(b, i, j) and filter.areSolid(b, i, j)) then
    return
  end
  local u = -along(b.speed, i, j, nx, ny)
  if isElastic(b, i, j, u) or passes(b, p, i, j, nx, ny, false) then
    return
  end
  if b.contact[p] == 0 and time < 1 then
    noteHit(b, p, nx, ny, time, max(u, 0.0)) -- while the paths still lead there
  end
  put(b, p, nx, ny, along(b.from, i, j, nx, ny) - gap, time, u)
end

--- Makes planes of the pairs that are apart where the step begins and will meet slanted. `isFirst`:
--- bodies that lean on something slanted are left for the next time, since that turns them first.
function slant.find(b, isFirst)
  pairFinder.run(b, b.awakeList, b.awakeCount, pairFinder.REACH)
  local live, touches, pairA, pairB = b.live, b.touches, b.pairA, b.pairB
  local stamp, leansAt = b.solveStamp, b.slants.leansAt
  for n = 1, b.liveCount do
    local p = live[n]
    local i, j = pairA[p], pairB[p]
    local waits = isFirst and (leansAt[i] == stamp or leansAt[j] == stamp)
    local isOpen = touches[p] == APART and not waits and ball.isRound(b, i, j)
    if isOpen and not isElastic(b, i, j, -huge) then
      findPair(b, p)
    end
  end
end

--- Makes a plane of pair p, which meets at moment t in a round and does not bounce. (The two may be
--- deep in each other, if others have pushed them there in this step.)
function slant.meet(b, p, t)
  local i, j = slotsOf(b, p)
  local gap, nx, ny, x, y = ball.gapNow(b, i, j, t)
  put(b, p, nx, ny, x * nx + y * ny - min(gap, 0.0), t, 0.0)
end

--- Makes planes of the pairs, also of boxes, that were apart when the step began and end in each
--- other: one of the two had an impact after others had changed the path of the second one.
function slant.findLate(b)
  for n = 1, b.liveCount do
    local p = b.live[n]
    local i, j = slotsOf(b, p)
    local isOpen = b.touches[p] == APART and not b.passing[p] and filter.areSolid(b, i, j)
    local isIn = isOpen and mayPress(b, i, j) and gapIn(b, b.to, i, j) < -EPSILON
    if isIn and gapIn(b, b.origin, i, j) >= -EPSILON then
      slant.meet(b, p, 1)
    end
  end
end

-- Returns whether slot i ends where it began.
local function isStill(b, i)
  local to, position, k = b.to, b.position, 2 * i
  return to[k] == position[k] and to[k + 1] == position[k + 1]
end

--- Notes the hits of pairs that begin to touch in this step, and forgets those that did not come to
--- that; and with which impulses pairs press each other: the next step begins with these. (A pair
--- that lies still keeps its own, so that an island at rest does not change. But it does not keep
--- that of a landing: balls that stood on a belt shook the last one off again and again.)
function slant.tell(b)
  local s, last, live, touches = b.slants, b.lastImpulse, b.live, b.touches
  for n = 1, b.liveCount do
    if touches[live[n]] ~= SLANTED then
      last[live[n]] = 0.0
    end
  end
  for c = 1, s.count do
    local p, i, j = s.pair[c], s.one[c], s.other[c]
    local impulse = s.isFlush[c] and s.impulse[c] or 0.0
    if not (isStill(b, i) and isStill(b, j)) then
      last[p] = impulse
    elseif impulse < KEPT * last[p] then
      last[p], b.mustStayAwake[i], b.mustStayAwake[j] = impulse, true, true
      b.stillAt[i], b.stillAt[j] = 0, 0
    end
    if s.isFlush[c] then
      b.resolved = b.resolved + 1
      if b.contact[p] == 0 then
        noteHit(b, p, s.nx[c], s.ny[c], s.time[c], max(s.speed[c], 0.0))
      end
    elseif b.contact[p] == 0 then
      b.hit[p] = 0
    end
  end
end

return slant
