---@diagnostic disable
--- Press: keeps the pairs that touch slanted on their sides of their planes (see slant), all
--- together.
--
-- Let x be the places at the end of the step, m the masses. Wanted are the nearest places, those
-- that minimise the sum of m (x' - x)², with  n · (x'one - x'other) >= least  for each plane. They
-- are found row by row: a row that is violated gets a push `l` along its normal, which moves `one`
-- by l n / m and `other` by -l n / m. A push is >= 0 in all, and is taken back where later ones
-- prove it too much.
--
--       ( )          1. PASSES over the rows, from below to above, those of immovable bodies last.
--      ( )( )           Rows are the planes, and the contacts along an axis of the same bodies.
--     ( )( )( )         Without gravity pushes are EAGER times as long, but in the last two passes,
--   ##############      and planes up to LEFT slops deep are not pressed again.
--                    2. Immovable bodies come last: each body ends at the nearest place in front of
--                       all that stop it (`leaveWalls`), which passes reach slowly. Then a body is
--                       taken back to FURTHEST of its size and its own way (`limit`).
--                    3. The same with the speeds, for the rows that touch at the end or have got
--                       an impulse: they must not close. The speed along the tangent is kept.
--                    4. 1 and 2 again for the places alone, since walls have pushed bodies back
--                       into others: SHOCKS passes, with pushes that begin at 0 and are not noted.
--                       Under gravity the lower body of two that can be moved does not give way,
--                       so that a heap does not sink. (With speeds, momentum would be lost.)
--                       FURTHEST does not apply, and which rows touch is not found anew.
--                    5. Pushes are noted, and accelerations are found anew (`noteAll`).
--
-- One pass is enough for one row. In a heap a push goes on to the next row, so passes go on until
-- PASSES; a rest that is left is pushed away in later steps. The step before has found most of the
-- pushes: a plane begins with the last impulse of its pair (`lastImpulse`, see `slant.tell`), of
-- which passes take back a part that is too much. So 16 passes are enough for a heap that is 18
-- bodies deep. Only bodies that are connected with a new or violated plane are solved again. A
-- solve presses several times: planes keep their pushes from call to call, and under gravity the
-- rows of axis contacts, too. (Where those of a floor began at 0, the part that a plane took back
-- lifted the ball off it.) Contacts along an axis are settled before and after.
--
-- Source: projected Gauss-Seidel (J. J. Moreau, 1999) with a warm start (E. Catto, Iterative
-- Dynamics with Temporal Coherence, 2005), on places and then on speeds.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".narrowphase.ball")
local constants = require(root .. ".memory.constants")
local heap = require(root .. ".overlaps.heap")
local links = require(root .. ".memory.links")
local pairFinder = require(root .. ".broadphase.pairFinder")
local path = require(root .. ".motion.path")
local planes = require(root .. ".space.planes")
local slant = require(root .. ".solver.slant")
local sort = require(root .. ".memory.sort")
local yielding = require(root .. ".narrowphase.yielding")

local press = {}

local DYNAMIC, EPSILON = constants.DYNAMIC, constants.EPSILON
local max, min, sqrt = math.max, math.min, math.sqrt
-- Passes over the rows, and those over the places after them.
local PASSES, SHOCKS = 16, 6
-- Factor of each push but the last ones, where there is no gravity: many are pressed from outside
-- to inside, which takes many small pushes. (With 1.4 under gravity heaps explode.)
local EAGER = 1.2
-- Slops, and px at most, by which passes may leave two in each other without gravity. Less is left
-- to later steps: after the first passes a few pairs of very many are always a little too deep.
-- (With 0.12 px large bodies stay 0.35 px in each other for some frames.)
local LEFT, DEEPEST = 5, 0.08
-- Up to this gap, px, two that were pushed under gravity touch: shocks lift them. (With 0.05 heaps
-- do not rest; without a bound two that were 18 px apart touched.)
local LIFTED = 0.2
-- How often late pairs are looked for. (300 crowds with a strong player took at most 3.)
local LOOKS = 4
-- Share of its size by which a body is pushed, more than it moves.
local FURTHEST = 0.35
-- Share of its size by which its new speed may take it further. (Without it, a weak body is left
-- 0.36 px in a strong one, with 0.1 in one of 2000 games; with 0.35, a pit rests 0.1 px deep.)
local FASTER = 0.2
-- Share of a normal along gravity from which on one body of a pair is above the other.
local ABOVE = 0.1
-- How much farther than its own way and those of its walls a body may be put, since it may begin in
-- something immovable, px; and of velocities, for rounding, px/s.
local ROOM = 0.1

-- Rows --------------------------------------------------------------------------------------------

-- Returns by how much the bodies of row c end nearer to each other than they may be, px.
local function depthOf(b, c)
  local s = b.slants
  return s.least[c] - slant.along(b.to, s.one[c], s.other[c], s.nx[c], s.ny[c])
end

-- Returns whether plane c is new, or violated while one of its bodies has another path than at the
-- last sweep, or (`ofAll`) any path. (Passes that others need must not move those of a heap.)
local function needsPress(b, c, ofAll)
  local s, dirty, stamp = b.slants, b.dirty, b.dirtyStamp
  local isChanged = ofAll or dirty[s.one[c]] == stamp or dirty[s.other[c]] == stamp
  local most = b.isWeightless and min(LEFT * s.slop[c], DEEPEST) or 0.0
  local isDeep = isChanged and depthOf(b, c) > max(s.slop[c], most)
  return s.isNew[c] or isDeep and s.total[c] ~= 0
end

-- Marks the dynamic bodies of planes that are new or violated. Returns whether there are any.
local function markNeeded(b, ofAll)
  local s, kind, isAny = b.slants, b.kind, false
  s.stamp = s.stamp + 1
  for c = 1, s.count do
    if needsPress(b, c, ofAll) then
      local i, j = s.one[c], s.other[c]
      s.isNew[c], isAny = false, true
      s.mark[i], s.mark[j] =
        kind[i] == DYNAMIC and s.stamp or 0, kind[j] == DYNAMIC and s.stamp or 0
    end
  end
  return isAny
end

-- Adds a contact along an axis as row c, if one of its bodies is marked, none is squeezed, and they
-- do not bounce. Returns whether it does.
local function addContact(b, list, n, c)
  local s, kl, kh, axis = b.slants, list.low[n], list.high[n], list.axis
  local i, j = (kh - axis) * 0.5, (kl - axis) * 0.5
  local closing, accel = b.speed[kl] - b.speed[kh], b.accel[kl] - b.accel[kh]
  local bounces = list.elastic[n] == 1 and yielding.bounces(closing, accel, 2 * b.dt)
  local isIn = s.mark[i] == s.stamp or s.mark[j] == s.stamp
  if not isIn or bounces or b.squeezed[kl] ~= 0 or b.squeezed[kh] ~= 0 then
    return false
  end
  s.one[c], s.other[c] = i, j
  s.nx[c], s.ny[c], s.least[c] = 1 - axis, axis, list.separation[n]
  local p = list.pair[n]
  local isOld = not b.isWeightless and s.pushedAt[p] == b.solveStamp
  s.pair[c], s.start[c], s.slop[c] = p, 0.0, EPSILON
  s.push[c], s.impulse[c] = isOld and s.pushOf[p] or 0.0, isOld and s.impulseOf[p] or 0.0
  s.height[c], s.first[c], s.second[c] = slant.heightOf(b, i, j), links.ranks(b, i, j)
  s.new[c - s.count] = c
  return true
end

-- Lists the rows to be solved, those of marked bodies and of the bodies that touch these, directly
-- or through others: from below to above, then in the order of the world. (All others are solved
-- already, and do not depend on these.) Planes keep their numbers; contacts along an axis of the
-- same bodies get the numbers behind these.
local function listRows(b)
  local s, last = b.slants, b.slants.count
  s.rows = 0
  for c = s.kept + 1, s.count do
    s.new[c - s.kept] = c
  end
  sort.merge(s.base, s.kept, s.new, s.count - s.kept, s.height, s.first, s.second)
  s.kept = s.count
  heap.spread(b, s.mark, s.stamp)
  for n = 1, s.count do
    local c = s.base[n]
    if s.mark[s.one[c]] == s.stamp or s.mark[s.other[c]] == s.stamp then
      s.rows = s.rows + 1
      s.order[s.rows] = c
    end
  end
  for axis = 0, 1 do
    for n = 1, b.contacts[axis].count do
      last = addContact(b, b.contacts[axis], n, last + 1) and last + 1 or last
    end
  end
  sort.merge(s.order, s.rows, s.new, last - s.count, s.height, s.first, s.second)
  s.rows = s.rows + last - s.count
end

-- Walls -------------------------------------------------------------------------------------------

-- Lists the rows with a wall by the body that it stops: the other body of the row cannot be moved
-- along their normal, since it is immovable, or held, or not pushable; or it is stronger, and one
-- of the two is round. (In 16 passes a light ball between a strong player, a wall and heavy balls
-- hardly moved.)
local function listWalls(b)
  local s = b.slants
  s.walledCount = 0
  for n = 1, s.rows do
    local c = s.order[n]
    local i, j, nx, ny = s.one[c], s.other[c], s.nx[c], s.ny[c]
    local ix, iy, jx, jy = ball.weigh(b, i, j, nx, ny)
    local isOne, isOther = nx * nx * ix + ny * ny * iy > 0, nx * nx * jx + ny * ny * jy > 0
    local isStronger = isOne and isOther and ball.isRound(b, i, j)
    isOne = isOne and not (isStronger and b.power[i] > b.power[j])
    isOther = isOther and not (isStronger and b.power[j] > b.power[i])
    if isOne ~= isOther then
      local mover = isOne and i or j
      if s.wallsAt[mover] ~= s.stamp then
        s.walledCount = s.walledCount + 1
        s.walled[s.walledCount], s.wallsAt[mover], s.firstWall[mover] = mover, s.stamp, 0
      end
      s.nextWall[c], s.firstWall[mover] = s.firstWall[mover], c
    end
  end
end

-- Returns how far body k is from where it began, or how fast it is.
local function lengthOf(b, column, k, isOfSpeeds)
  local x = column[k] - (isOfSpeeds and 0.0 or b.origin[k])
  local y = column[k + 1] - (isOfSpeeds and 0.0 or b.origin[k + 1])
  return sqrt(x * x + y * y)
end

-- Puts each body that walls stop at the nearest place in front of all of them, or gives it the
-- nearest velocity that goes into none. It is looked for as far away as where the body began, or a
-- standstill, and the ways of the walls. (The corner of walls that come from opposite sides may be
-- anywhere.) A body that has no such place is in a vice: from now on it stops those that are not
-- pushable (see `weigh` in narrowphase/ball.lua).
local function leaveWalls(b, column, isOfSpeeds)
  local s = b.slants
  for n = 1, s.walledCount do
    local i = s.walled[n]
    local k, c = 2 * i, s.firstWall[i]
    local most = lengthOf(b, column, k, isOfSpeeds) + ROOM
    planes.count = 0
    while c ~= 0 do
      local sign, j = s.one[c] == i and 1 or -1, s.one[c] + s.other[c] - i
      local nx, ny, m = sign * s.nx[c], sign * s.ny[c], 2 * j
      if not isOfSpeeds or s.isFlush[c] then
        local place = nx * column[m] + ny * column[m + 1] + (isOfSpeeds and 0.0 or s.least[c])
        planes.add(b.rank, nx, ny, place, j, 0)
        most = most + lengthOf(b, column, m, isOfSpeeds)
      end
      c = s.nextWall[c]
    end
    local x, y = planes.nearest(column[k], column[k + 1], most)
    if x then
      column[k], column[k + 1] = x, y
    else
      s.viceAt[i] = b.solveStamp
    end
  end
end

-- Passes ------------------------------------------------------------------------------------------

--- Pushes the bodies of row c apart by `more`: changes their places, or their velocities. (`solve`
--- has it written out: with a call hundreds of circles cost 9 % more without the trace compiler.)
function press.pushApart(column, s, c, more)
  local k, m = 2 * s.one[c], 2 * s.other[c]
  column[k], column[k + 1] = column[k] + more * s.dx[c], column[k + 1] + more * s.dy[c]
  column[m], column[m + 1] = column[m] - more * s.ex[c], column[m + 1] - more * s.ey[c]
end

-- Computes how the two bodies of each row give way, and pushes those apart that begin with an
-- impulse of the last step. `isShock`: the lower body does not give way.
local function weigh(b, isShock)
  local s, down, give = b.slants, b.down, b.give
  for n = 1, s.rows do
    local c = s.order[n]
    local i, j, nx, ny = s.one[c], s.other[c], s.nx[c], s.ny[c]
    local k, m = 2 * i, 2 * j
    local ix, iy, jx, jy = ball.weighFree(b, i, j, nx, ny)
    local share = ((down[k] + down[m]) * nx + (down[k + 1] + down[m + 1]) * ny) * 0.5
    local isInVice = s.viceAt[i] == b.solveStamp or s.viceAt[j] == b.solveStamp
    local mayHold = isShock and give[k] > 0 and give[m] > 0 and not isInVice
    if mayHold and share < -ABOVE then
      jx, jy = 0.0, 0.0
    elseif mayHold and share > ABOVE then
      ix, iy = 0.0, 0.0
    end
    local dx, dy, ex, ey = nx * ix, ny * iy, nx * jx, ny * jy
    s.dx[c], s.dy[c], s.ex[c], s.ey[c] = dx, dy, ex, ey
    s.total[c], s.lift[c] = nx * (dx + ex) + ny * (dy + ey), 0.0
    if s.start[c] ~= 0 then
      s.push[c], s.impulse[c] = s.start[c] * b.dt, s.start[c]
      press.pushApart(b.to, s, c, s.push[c])
      press.pushApart(b.speed, s, c, s.impulse[c])
      s.start[c] = 0.0
    end
  end
end

-- Makes passes over a column, with walls last: the places or the speeds at the end of the step.
-- `sum` holds the push of each row so far. A row whose bodies have left each other again takes its
-- push back.
local function solve(b, column, sum, passCount, isOfSpeeds)
  local s, eagerness = b.slants, b.isWeightless and EAGER or 1.0
  local one, other, nx, ny, least = s.one, s.other, s.nx, s.ny, s.least
  local order, total, isFlush, dx, dy, ex, ey = s.order, s.total, s.isFlush, s.dx, s.dy, s.ex, s.ey
  for pass = 1, passCount do
    local eager = pass < passCount - 1 and eagerness or 1.0
    for n = 1, s.rows do
      local c = order[n]
      if total[c] > 0 and (not isOfSpeeds or isFlush[c] or sum[c] > 0) then
        local k, m = 2 * one[c], 2 * other[c]
        local rel = (column[k] - column[m]) * nx[c] + (column[k + 1] - column[m + 1]) * ny[c]
        local want = ((isOfSpeeds and 0.0 or least[c]) - rel) / total[c] * eager
        local more = max(want, -sum[c])
        sum[c] = sum[c] + more
        if more ~= 0 then
          column[k], column[k + 1] = column[k] + more * dx[c], column[k + 1] + more * dy[c]
          column[m], column[m + 1] = column[m] - more * ex[c], column[m + 1] - more * ey[c]
        end
      end
    end
  end
  leaveWalls(b, column, isOfSpeeds)
end

-- The end of the step -----------------------------------------------------------------------------

-- Limits how far slot i, if it is dynamic, is pushed: a share of its size, and as far as its free
-- flight takes it; the speed that it has got may add a small share (FASTER). (A body between
-- immovable ones would be pushed to and fro; and pushes after the rounds are not swept: one as long
-- as that speed led through walls.)
local function limit(b, i)
  if b.kind[i] ~= DYNAMIC then
    return
  end
  local k, to, origin, dt, size = 2 * i, b.to, b.origin, b.dt, min(b.size[2 * i], b.size[2 * i + 1])
  local way = max(path.largest(b.start, k), path.largest(b.freeSpeed, k)) * dt
  local most = FURTHEST * size + max(way, min(path.largest(b.speed, k) * dt, FASTER * size))
  for m = k, k + 1 do
    to[m] = max(min(to[m], origin[m] + most), origin[m] - most)
  end
end

-- Returns whether row c touches, or was pushed and has been LIFTED.
local function isFlush(b, c)
  local isPushed = not b.isWeightless and b.slants.push[c] > 0
  return -depthOf(b, c) <= max(b.slants.slop[c], isPushed and LIFTED or EPSILON)
end

-- Notes which rows touch at the end of the step, where no body goes farther than `limit` lets it.
local function findFlush(b)
  local s = b.slants
  for n = 1, s.rows do
    limit(b, s.one[s.order[n]])
    limit(b, s.other[s.order[n]])
  end
  for n = 1, s.rows do
    s.isFlush[s.order[n]] = isFlush(b, s.order[n])
  end
end

-- Notes that slot i was pushed, and gives it the acceleration with which it comes to its place with
-- its speed; at most that of its free flight.
local function note(b, i)
  local first, dt, free, start = 2 * i, b.dt, b.freeSpeed, b.start
  b.deflectedAt[i] = b.solveStamp
  if b.give[first] == 0 then
    return
  end
  local x, y = (free[first] - start[first]) / dt, (free[first + 1] - start[first + 1]) / dt
  local tau, most = (1 - b.time[i]) * dt, max(x, -x, y, -y)
  for k = first, first + 1 do
    local a = 2 * (b.speed[k] - (b.to[k] - b.from[k]) / tau) / tau
    path.finish(b, k, b.to[k], b.speed[k], max(min(a, most), -most))
  end
end

-- Notes which bodies have been pushed, and which are in a heap.
local function noteAll(b)
  local s, inHeap = b.slants, b.heapWork.inHeap
  for n = 1, s.rows do
    local c = s.order[n]
    local i, j, p = s.one[c], s.other[c], s.pair[c]
    if c > s.count then
      s.pushedAt[p], s.pushOf[p], s.impulseOf[p] = b.solveStamp, s.push[c], s.impulse[c]
    end
    if s.isFlush[c] then
      note(b, i)
      note(b, j)
      if c <= s.count and b.give[2 * i] > 0 and b.give[2 * j] > 0 then
        inHeap[i], inHeap[j] = b.solveStamp, b.solveStamp
      end
    end
  end
end

--- Pushes new planes apart, violated ones of changed bodies (`ofAll`: of all), and rows of bodies
--- that these connect. Returns whether there are any.
function press.run(b, ofAll)
  local s = b.slants
  if not markNeeded(b, ofAll) then
    return false
  end
  listRows(b)
  listWalls(b)
  weigh(b, false)
  solve(b, b.to, s.push, PASSES, false)
  findFlush(b)
  solve(b, b.speed, s.impulse, PASSES, true)
  weigh(b, true)
  solve(b, b.to, s.lift, SHOCKS, false)
  noteAll(b)
  return true
end

--- Presses the bodies apart that the rounds have left in each other, and finds which planes touch,
--- and the heaps.
function press.finish(b)
  local s = b.slants
  local looks, count = 0, -1
  while looks < LOOKS and s.count ~= count do -- planes of new pairs may push others into each other
    looks, count = looks + 1, s.count
    slant.findLate(b)
    press.run(b, true)
  end
  if s.count == 0 then
    return
  end
  for c = 1, s.count do
    s.isFlush[c] = isFlush(b, c)
  end
  pairFinder.run(b, b.awakeList, b.awakeCount)
  heap.spread(b, b.heapWork.inHeap, b.solveStamp)
end

return press
