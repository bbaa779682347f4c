---@diagnostic disable
--- Slants: keeps round bodies apart that touch slanted: two circles, a circle and a corner or a
-- slope. All such pairs of a step are solved together.
--
-- A pair that touches when the step begins, or would meet in it, gets a plane: the tangent where
-- the two touch. At the end of the step each must be on its side of it. Both shapes are convex, so
-- they cannot overlap then, wherever else they go.
--
--           n                    Along the normal n the two end at least `least` px apart
--           ^     o ->           (the difference of their places). If they touch now, that is how
--      -----|----(-)-----        far apart they are; if they meet later, how far they are there.
--           o
--          (-)
--
-- 1. The places at the end are pushed apart (`push`, >= 0, is taken back if it proves too much),
--    pair after pair, in PASSES passes. Under gravity a few passes follow in which the lower one of
--    two does not give way, so that a heap does not sink.
-- 2. The speeds at the end are changed in the same way, for the pairs that were pushed: they must
--    not close along the normal. The speed along the tangent is kept.
--
-- Pairs that bounce are left to impacts. Contacts along an axis are settled before and after.
--
-- Source: projected Gauss-Seidel (J. J. Moreau, 1999; E. Catto, Iterative Dynamics with Temporal
-- Coherence, 2005), on places and then on speeds.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".narrowphase.ball")
local boxes = require(root .. ".space.boxes")
local constants = require(root .. ".memory.constants")
local contacts = require(root .. ".solver.contacts")
local crowd = require(root .. ".overlaps.crowd")
local links = require(root .. ".memory.links")
local heap = require(root .. ".overlaps.heap")
local filter = require(root .. ".broadphase.filter")
local pairFinder = require(root .. ".broadphase.pairFinder")
local impact = require(root .. ".solver.impact")
local planes = require(root .. ".space.planes")
local path = require(root .. ".motion.path")
local yielding = require(root .. ".narrowphase.yielding")
local rules = require(root .. ".narrowphase.rules")
local shapes = require(root .. ".space.shapes")
local sort = require(root .. ".memory.sort")

local slant = {}

local APART, CONTACT = contacts.APART, contacts.CONTACT
local DYNAMIC, EPSILON = constants.DYNAMIC, constants.EPSILON
local huge, max, min, sqrt = math.huge, math.max, math.min, math.sqrt
local isRound = shapes.isRound
-- Passes over the pairs, and those after them in which the lower one does not give way.
local PASSES, SHOCKS = 16, 6
-- Factor of each push but the last ones, where there is no gravity: a crowd is pressed from outside
-- to inside, which takes many small pushes.
local EAGER = 1.2
-- Shares of the smaller size: an overlap that is left as it is, a gap at which two that are slower
-- than SLOW in a step are listed although they may not meet, and the depth from which two leave as
-- boxes do.
local SLOP, NEAR, SLOW, LOST = 0.002, 0.1, 0.25, 0.25
-- px: as near as that, pairs are known. (Otherwise which are depends on the past.)
local REACH = 1.5
-- px by which a body may be in something immovable where the step begins.
local ROOM = 0.1
-- Share of an overlap that is taken away in a step.
local PACE = 0.5
-- Share of its size by which a body is pushed, more than it moves.
local FURTHEST = 0.35
-- The same of two: what they are in each other after all passes, or would be in the next step, if
-- there is no room.
local JAMMED = 0.05
-- Share of a normal along gravity from which on one of two is above the other.
local ABOVE = 0.1

-- Returns an empty list of slanted contacts.
local function newList()
  return {
    count = 0,
    kept = 0, -- of these, those that were sorted already, and
    base = {}, -- their order
    rows = 0, -- these, and contacts along an axis behind them
    stamp = 0,
    jamAt = {}, -- by slot: when it had no room
    leansAt = {}, -- by slot: when something immovable touched it slanted as a step began
    walled = 0, -- bodies beside something immovable
    walledList = {},
    wallsAt = {}, -- by slot: when it was listed
    firstWall = {}, -- its first row, and
    nextWall = {}, -- by row: the next one of the same body
    firstAt = {}, -- by slot: when it was first met by something immovable,
    firstOf = {}, -- and its contact
    mark = {}, -- by slot: what these press, directly or through others
    isNew = true,
    order = {}, -- from below to above, then in the order of the world
    height = {},
    first = {},
    second = {},
    pair = {},
    one = {}, -- slot; the first in the order of the world
    other = {},
    nx = {}, -- unit normal from `other` to `one`
    ny = {},
    least = {}, -- px between them along the normal at the end of the step
    push = {}, -- by how much they are pushed apart, kg px
    impulse = {}, -- the same of their speeds, kg px/s
    oneX = {}, -- inverse masses
    oneY = {},
    otherX = {},
    otherY = {},
    total = {}, -- that of the pair along the normal
    isNewOne = {}, -- it was not solved yet
    last = 0, -- the last row
    slop = {}, -- px by which they may be nearer
    isFlush = {}, -- they touch at the end of the step
    time = {}, -- when they meet, and how fast
    speed = {},
    dx = {}, -- scratch: what a push of 1 moves each by
    dy = {},
    ex = {},
    ey = {},
  }
end

-- Returns the slots of pair p, the first in the order of the world first.
local function slotsOf(b, p)
  local i, j = b.pairA[p], b.pairB[p]
  if b.rank[j] < b.rank[i] then
    return j, i
  end
  return i, j
end

-- Returns how high a pair is against the gravity of the world.
local function heightOf(b, i, j)
  local axis = b.downAxis
  local one, other = b.from[2 * i + axis], b.from[2 * j + axis]
  local height = b.orientation[axis] > 0 and -max(one, other) or min(one, other)
  local areDynamic = b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC
  return areDynamic and (path.isPulled(b, i) or path.isPulled(b, j)) and height or huge
end

-- Returns whether pair p passes through each other along a normal: the game is asked.
local function passes(b, p, i, j, nx, ny, isDeep)
  local axis, isLow = shapes.sideOf(nx, ny, false)
  local low = isLow and i or j
  return rules.passes(b, p, 2 * low + axis, 2 * (i + j - low) + axis, axis, isDeep)
end

-- Returns by how many px two may be in each other: nothing visible, and nothing in what is
-- immovable or stronger.
local function slopOf(b, i, j)
  local areEqual = b.give[2 * i] > 0 and b.give[2 * j] > 0 and b.power[i] == b.power[j]
  return areEqual and SLOP * ball.smallest(b, i, j) or EPSILON / 2
end

local function add(b, p, i, j, nx, ny, least, time, speed)
  if not b.slants.isNew then
    b.slants = newList()
  end
  local s = b.slants
  local c = s.count + 1
  s.count, s.pair[c], s.one[c], s.other[c] = c, p, i, j
  s.nx[c], s.ny[c], s.least[c], s.time[c], s.speed[c] = nx, ny, least, time, speed
  s.height[c], s.first[c], s.second[c] = heightOf(b, i, j), b.rank[i], b.rank[j]
  s.push[c], s.impulse[c], s.total[c] = 0.0, 0.0, 1.0
  s.isNewOne[c], s.isFlush[c] = true, false
  s.slop[c] = slopOf(b, i, j)
  b.touches[p], b.contactLow[p] = CONTACT, 0 -- (it is in no list of an axis)
end

-- Notes the hit of a pair that is about to meet, while the paths still lead there.
local function noteHit(b, p, i, j, nx, ny, time, speed)
  if b.contact[p] == 0 and time < 1 then
    local axis, isLow = shapes.sideOf(nx, ny, false)
    impact.note(b, p, isLow and i or j, axis, speed, time)
  end
end

-- Adds a pair that is apart. Of the immovable ones that a body meets only the first one counts now:
-- that turns it, so that it may not come to the others (as to the seam of two tiles). Returns
-- whether it was added.
local function addFirst(b, p, i, j, nx, ny, least, time, speed)
  noteHit(b, p, i, j, nx, ny, time, speed)
  local s, mover = b.slants, b.give[2 * i] == 0 and j or b.give[2 * j] == 0 and i or 0
  local c = mover > 0 and s.firstAt[mover] == s.stamp and s.firstOf[mover]
  if c then
    local k, m = s.one[c] == mover and s.other[c] or s.one[c], i + j - mover
    if time > s.time[c] or time == s.time[c] and b.rank[m] > b.rank[k] then
      return false
    end
    b.touches[s.pair[c]] = APART
    local count = s.count
    s.count = c - 1
    add(b, p, i, j, nx, ny, least, time, speed)
    s.count = count
    return true
  end
  add(b, p, i, j, nx, ny, least, time, speed)
  s = b.slants
  s.firstAt[mover], s.firstOf[mover] = s.stamp, s.count
  return true
end

-- Returns whether one of two is round and one can move.
local function mayPress(b, i, j)
  local areRound = isRound[b.shape[i]] or isRound[b.shape[j]]
  return areRound and b.give[2 * i] + b.give[2 * j] > 0 and min(b.power[i], b.power[j]) < huge
end

-- The relative speed at the start of the step along a normal, px/s; > 0: they close.
local function closingAt(i, j, nx, ny, column)
  local k, m = 2 * i, 2 * j
  return (column[m] - column[k]) * nx + (column[m + 1] - column[k + 1]) * ny
end

-- Returns whether two that close at u px/s are left to an impact.
local function isElastic(b, i, j, u)
  if max(b.restitution[i], b.restitution[j]) == 0 then
    return false
  elseif not (path.isPulled(b, i) or path.isPulled(b, j)) then
    return true
  end
  local pull = max(
    b.pull[2 * i],
    -b.pull[2 * i],
    b.pull[2 * i + 1],
    -b.pull[2 * i + 1],
    b.pull[2 * j],
    -b.pull[2 * j],
    b.pull[2 * j + 1],
    -b.pull[2 * j + 1]
  )
  return u > 2 * b.dt * pull
end

-- The distance of two places along a normal.
local function along(column, i, j, nx, ny)
  local k, m = 2 * i, 2 * j
  return (column[k] - column[m]) * nx + (column[k + 1] - column[m + 1]) * ny
end

--- Takes pair p, which touches or overlaps where the step begins. Returns whether it is slanted.
function slant.takes(b, p)
  local i, j = slotsOf(b, p)
  if not mayPress(b, i, j) then
    return false
  end
  local gap, nx, ny = ball.gapIn(b, b.from, i, j)
  local size = ball.smallest(b, i, j)
  if gap > EPSILON or nx == 0 or ny == 0 or gap < -LOST * size then
    return false
  end
  local u = closingAt(i, j, nx, ny, b.speed)
  if isElastic(b, i, j, u) or passes(b, p, i, j, nx, ny, gap < -EPSILON) then
    return false
  end
  local slop = slopOf(b, i, j)
  local target = gap < -slop and -slop + (gap + slop) * (1 - PACE) or min(gap, 0.0)
  add(b, p, i, j, nx, ny, along(b.from, i, j, nx, ny) - gap + target, 0.0, u)
  return true
end

-- Lists pair p if it is apart and will meet slanted, or is near and slow. Returns whether it was.
local function listPair(b, p)
  local i, j = slotsOf(b, p)
  local size, from, to, shape, k, m = b.size, b.from, b.to, b.shape, 2 * i, 2 * j
  local x, y = from[k] - from[m], from[k + 1] - from[m + 1]
  local dx, dy =
    to[k] - from[k] - to[m] + from[m], to[k + 1] - from[k + 1] - to[m + 1] + from[m + 1]
  local way, least = max(dx, -dx, dy, -dy), ball.smallest(b, i, j)
  local reach = max(way, min(NEAR * least, REACH))
  local far = max(x - size[m], -x - size[k], y - size[m + 1], -y - size[k + 1])
  if far > reach or not filter.areSolid(b, i, j) or b.passing[p] or crowd.isGhost(b, i, j) then
    return false
  elseif b.time[i] > 0 or b.time[j] > 0 or b.pieceLast[i] > 0 or b.pieceLast[j] > 0 then
    return false
  end
  shapes.setPair(
    shape[i],
    from[k],
    from[k + 1],
    size[k],
    size[k + 1],
    shape[j],
    from[m],
    from[m + 1],
    size[m],
    size[m + 1]
  )
  local share, nx, ny, _, isDeep = shapes.meet(dx, dy, b.downAxis, 0.0, 0.0)
  local gap
  if share then
    gap = -share * (dx * nx + dy * ny)
  else -- they are listed if others may push them together
    share = 1.0
    gap, nx, ny = ball.gapIn(b, from, i, j)
    local areLoose = b.give[k] > 0 and b.give[m] > 0
    isDeep = not areLoose or gap < -EPSILON or gap > min(NEAR * least, REACH) or way > SLOW * least
    gap = max(gap, 0.0)
  end
  if isDeep or nx == 0 or ny == 0 then
    return false
  end
  local u = closingAt(i, j, nx, ny, b.speed)
  if isElastic(b, i, j, u) or passes(b, p, i, j, nx, ny, false) then
    return false
  end
  return addFirst(b, p, i, j, nx, ny, along(from, i, j, nx, ny) - gap, share, max(u, 0.0))
end

--- Makes a plane of pair p, which meets slanted at moment t in a round and does not bounce. Returns
--- whether it did.
function slant.meet(b, p, t)
  local i, j = slotsOf(b, p)
  if not mayPress(b, i, j) or b.pieceLast[i] > 0 or b.pieceLast[j] > 0 then
    return false
  end
  local gap, nx, ny, x, y = ball.gapNow(b, i, j, t)
  if gap < -LOST * ball.smallest(b, i, j) or nx == 0 or ny == 0 then
    return false
  end
  add(b, p, i, j, nx, ny, x * nx + y * ny - min(gap, 0.0), t, 0.0)
  return true
end

-- Marks the bodies that something immovable touches slanted where the step begins: that turns them
-- first, before others are looked for on their ways.
local function markLeaning(b)
  local s, give = b.slants, b.give
  for c = 1, s.count do
    local i, j = s.one[c], s.other[c]
    if give[2 * i] == 0 or give[2 * j] == 0 then
      s.leansAt[i], s.leansAt[j] = b.solveStamp, b.solveStamp
    end
  end
end

--- Lists the pairs that are apart where the step begins and will meet slanted. Returns whether
--- there are new ones. `isFirst`: those of bodies that lean on something are left for the next
--- time.
function slant.find(b, isFirst)
  pairFinder.run(b, b.awakeList, b.awakeCount, REACH)
  contacts.noteNew(b)
  if not b.slants.isNew then
    b.slants = newList()
  end
  local apart, touches, pairA, pairB, hasNew = b.apart, b.touches, b.pairA, b.pairB, false
  local stamp, leansAt = b.solveStamp, b.slants.leansAt
  if isFirst then
    markLeaning(b)
  end
  b.slants.stamp = b.slants.stamp + 1
  for n = 1, b.apartCount do
    local p = apart[n]
    local i, j = pairA[p], pairB[p]
    local waits = isFirst and (leansAt[i] == stamp or leansAt[j] == stamp)
    if touches[p] == APART and not waits and mayPress(b, i, j) and listPair(b, p) then
      hasNew = true
    end
  end
  return hasNew
end

-- Puts the slanted contacts in order.
local function arrange(b)
  local s, base = b.slants, b.slants.base
  for c = s.kept + 1, s.count do
    base[c] = c
  end
  s.kept = s.count
  sort.by(base, s.count, s.height, s.first, s.second)
end

-- Returns whether the two of contact c end nearer to each other than they may be.
local function isTight(b, c)
  local s = b.slants
  return s.least[c] - along(b.to, s.one[c], s.other[c], s.nx[c], s.ny[c]) > s.slop[c]
    and s.total[c] ~= 0
end

--- Returns whether there is something new, or two end nearer to each other than they may be.
function slant.isViolated(b)
  for c = 1, b.slants.count do
    if b.slants.isNewOne[c] or isTight(b, c) then
      return true
    end
  end
  return false
end

-- Marks both of two if one of them is marked, and both can move.
local function reach(b, i, j)
  local mark, stamp = b.slants.mark, b.slants.stamp
  local areDynamic = b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC
  if areDynamic and (mark[i] == stamp or mark[j] == stamp) then
    mark[i], mark[j] = stamp, stamp
  end
end

-- Marks the dynamic ones of contacts that are new or too tight, and what touches these, directly or
-- through others: all else is solved already, and does not depend on what happens here.
local function spread(b)
  local s, kind, mark, base = b.slants, b.kind, b.slants.mark, b.slants.base
  s.stamp = s.stamp + 1
  for c = 1, s.count do
    if s.isNewOne[c] or isTight(b, c) then
      s.isNewOne[c] = false
      for n = 1, 2 do
        local i = n == 1 and s.one[c] or s.other[c]
        mark[i] = kind[i] == DYNAMIC and s.stamp or 0
      end
    end
  end
  for pass = 0, 7 do
    local list, isBack = b.contacts[pass % 2], pass % 4 > 1
    for n = 1, s.count do
      local c = base[isBack and s.count + 1 - n or n]
      reach(b, s.one[c], s.other[c])
    end
    for n = 1, list.count do
      local c = isBack and list.count + 1 - n or n
      reach(b, (list.low[c] - list.axis) * 0.5, (list.high[c] - list.axis) * 0.5)
    end
  end
end

-- Adds a contact along an axis as a row.
local function addRow(b, list, n)
  local s, kl, kh, mark, stamp = b.slants, list.low[n], list.high[n], b.slants.mark, b.slants.stamp
  local i, j = (kh - list.axis) * 0.5, (kl - list.axis) * 0.5
  local closing, accel = b.speed[kl] - b.speed[kh], b.accel[kl] - b.accel[kh]
  local bounces = list.elastic[n] == 1 and yielding.bounces(closing, accel, 2 * b.dt)
  local isIn = mark[i] == stamp or mark[j] == stamp
  if isIn and not bounces and b.squeezed[kl] == 0 and b.squeezed[kh] == 0 then
    local c = s.last + 1
    s.last, s.rows = c, s.rows + 1
    s.order[s.rows], s.pair[c], s.one[c], s.other[c] = c, list.pair[n], i, j
    s.nx[c], s.ny[c], s.least[c] = 1 - list.axis, list.axis, list.separation[n]
    s.push[c], s.impulse[c], s.slop[c] = 0.0, 0.0, EPSILON
    s.height[c], s.first[c], s.second[c] = heightOf(b, i, j), links.ranks(b, i, j)
  end
end

-- Lists the rows to be solved: slanted contacts, and those along an axis of the same bodies.
local function listRows(b)
  local s, mark = b.slants, b.slants.mark
  arrange(b)
  spread(b)
  s.rows, s.last = 0, s.count
  for n = 1, s.count do
    local c = s.base[n]
    if mark[s.one[c]] == s.stamp or mark[s.other[c]] == s.stamp then
      s.rows = s.rows + 1
      s.order[s.rows] = c
    end
  end
  for axis = 0, 1 do
    for n = 1, b.contacts[axis].count do
      addRow(b, b.contacts[axis], n)
    end
  end
  sort.by(s.order, s.rows, s.height, s.first, s.second)
end

-- Returns whether slot i is a body that is not pushable, and that the game drives.
local function isSteered(b, i)
  return b.kind[i] == DYNAMIC and not b.pushable[i] and path.isDriven(b, i)
end

-- Returns by how much a push of 1 along a normal moves body k, which is steered: back along its own
-- way only. It is stopped, but not turned aside.
local function holdBack(b, k, nx, ny, ix, iy)
  local x, y = b.freeSpeed[k], b.freeSpeed[k + 1]
  local square = x * x + y * y
  local share = square > 0 and (nx * x + ny * y) / square or 0.0
  return share * x * ix, share * y * iy
end

-- Looks up which of each pair gives way. `isShock`: the lower one of two does not.
local function weigh(b, isShock)
  local s = b.slants
  for n = 1, s.rows do
    local c = s.order[n]
    local i, j, nx, ny = s.one[c], s.other[c], s.nx[c], s.ny[c]
    local k, m = 2 * i, 2 * j
    local ix, iy, jx, jy = ball.weighFree(b, i, j, nx, ny)
    local down = ((b.down[k] + b.down[m]) * nx + (b.down[k + 1] + b.down[m + 1]) * ny) * 0.5
    if isShock and b.give[k] > 0 and b.give[m] > 0 then
      if down < -ABOVE then
        jx, jy = 0.0, 0.0
      elseif down > ABOVE then
        ix, iy = 0.0, 0.0
      end
    end
    local dx, dy, ex, ey = nx * ix, ny * iy, nx * jx, ny * jy
    if isSteered(b, i) then
      dx, dy = holdBack(b, k, nx, ny, ix, iy)
    end
    if isSteered(b, j) then
      ex, ey = holdBack(b, m, nx, ny, jx, jy)
    end
    s.total[c] = nx * (dx + ex) + ny * (dy + ey)
    s.dx[c], s.dy[c], s.ex[c], s.ey[c] = dx, dy, ex, ey
  end
end

-- Makes passes over a column, the places or the speeds at the end of the step. `sum` is what each
-- pair has been pushed by so far.
local function sweep(b, column, sum, passCount, isOfSpeeds, isShock, hasWeight)
  local s = b.slants
  local order, one, other, nx, ny, least = s.order, s.one, s.other, s.nx, s.ny, s.least
  local total, dx, dy, ex, ey, isFlush = s.total, s.dx, s.dy, s.ex, s.ey, s.isFlush
  for pass = 1, passCount do
    local eager = pass < passCount - 1 and (hasWeight and 1.0 or EAGER) or 1.0
    for n = 1, s.rows do
      local c = order[n]
      if total[c] > 0 and (not isOfSpeeds or isFlush[c] or sum[c] > 0) then
        local k, m = 2 * one[c], 2 * other[c]
        local rel = (column[k] - column[m]) * nx[c] + (column[k + 1] - column[m + 1]) * ny[c]
        local want = ((isOfSpeeds and 0.0 or least[c]) - rel) / total[c] * eager
        local way = max(want, isShock and 0.0 or -sum[c])
        if isOfSpeeds and not isFlush[c] then
          way = -sum[c] -- it has left again
        end
        sum[c] = sum[c] + way
        if way ~= 0 then
          column[k], column[k + 1] = column[k] + way * dx[c], column[k + 1] + way * dy[c]
          column[m], column[m + 1] = column[m] - way * ex[c], column[m + 1] - way * ey[c]
        end
      end
    end
  end
end

-- Returns which of the two of row c is stopped by the other one, which cannot be moved along their
-- normal: that is immovable, or held; nil: none.
local function moverOf(b, c)
  local s = b.slants
  local i, j = s.one[c], s.other[c]
  local ix, iy, jx, jy = ball.weigh(b, i, j, s.nx[c], s.ny[c])
  local isOne, isOther = max(ix, iy) > 0, max(jx, jy) > 0
  return isOne ~= isOther and (isOne and i or j) or nil
end

-- Lists by body the rows in which that is stopped.
local function listWalls(b)
  local s = b.slants
  s.walled = 0
  for n = 1, s.rows do
    local c = s.order[n]
    local mover = moverOf(b, c)
    if mover then
      if s.wallsAt[mover] ~= s.stamp then
        s.walled = s.walled + 1
        s.walledList[s.walled], s.wallsAt[mover], s.firstWall[mover] = mover, s.stamp, 0
      end
      s.nextWall[c], s.firstWall[mover] = s.firstWall[mover], c
    end
  end
end

-- Returns how far body k is from where it began, or how fast it is.
local function lengthOf(column, start, k, isOfSpeeds)
  local x, y = column[k], column[k + 1]
  if not isOfSpeeds then
    x, y = x - start[k], y - start[k + 1]
  end
  return sqrt(x * x + y * y)
end

-- Puts what is pressed into immovable bodies at the nearest place in front of all of them, or gives
-- it the nearest velocity that goes into none. (Passes alone would come there slowly in a wedge.)
-- That is no further away than where the body began, or a standstill; it takes the ways of the
-- others to that. (Of two that come from opposite sides, the corner may be anywhere.)
local function leaveWalls(b, column, isOfSpeeds)
  local s, start = b.slants, b.origin
  for n = 1, s.walled do
    local i = s.walledList[n]
    local k, c, ways = 2 * i, s.firstWall[i], isOfSpeeds and 0.0 or ROOM
    planes.count = 0
    while c ~= 0 do
      local sign, j = s.one[c] == i and 1 or -1, s.one[c] == i and s.other[c] or s.one[c]
      local nx, ny, m = sign * s.nx[c], sign * s.ny[c], 2 * j
      if not isOfSpeeds or s.isFlush[c] then
        local place = nx * column[m] + ny * column[m + 1]
        planes.add(b.rank, nx, ny, place + (isOfSpeeds and 0.0 or s.least[c]), j, 0)
        ways = ways + lengthOf(column, start, m, isOfSpeeds)
      end
      c = s.nextWall[c]
    end
    ways = ways + lengthOf(column, start, k, isOfSpeeds)
    local x, y = planes.nearest(column[k], column[k + 1], ways)
    if x then
      column[k], column[k + 1] = x, y
    end
  end
end

-- Returns whether the two of contact c touch at the end of the step.
local function isFlush(b, c)
  local s = b.slants
  return along(b.to, s.one[c], s.other[c], s.nx[c], s.ny[c]) - s.least[c] <= max(s.slop[c], EPSILON)
end

-- Lists the pairs that impacts have left in each other at the end of the step.
local function findLate(b)
  pairFinder.run(b, b.awakeList, b.awakeCount)
  contacts.noteNew(b)
  for n = 1, b.liveCount do
    local p = b.live[n]
    local i, j = slotsOf(b, p)
    local isIn = b.touches[p] ~= CONTACT
      and mayPress(b, i, j)
      and boxes.gap(b, b.to, i, j) < -EPSILON
    if isIn and filter.areSolid(b, i, j) and not (b.passing[p] or crowd.isGhost(b, i, j)) then
      local gap, nx, ny = ball.gapIn(b, b.to, i, j)
      local isNew = gap < -EPSILON and ball.gapIn(b, b.origin, i, j) >= -EPSILON
      if isNew and nx ~= 0 and ny ~= 0 and not passes(b, p, i, j, nx, ny, false) then
        add(b, p, i, j, nx, ny, along(b.to, i, j, nx, ny) - gap, 1.0, 0.0)
      end
    end
  end
end

-- Limits how far slot i is pushed: a share of its size, and what its own motion is. (What is
-- between two that cannot move would be pushed to and fro.)
local function limit(b, i)
  local k, to, swept, origin = 2 * i, b.to, b.swept, b.origin
  local x, y = swept[k] - origin[k], swept[k + 1] - origin[k + 1]
  local most = FURTHEST * min(b.size[k], b.size[k + 1]) + max(x, -x, y, -y)
  for m = k, k + 1 do
    to[m] = max(min(to[m], origin[m] + most), origin[m] - most)
  end
end

-- Notes which pairs touch at the end of the step.
local function findFlush(b)
  local s = b.slants
  for n = 1, s.rows do
    local c = s.order[n]
    if b.kind[s.one[c]] == DYNAMIC then
      limit(b, s.one[c])
    end
    if b.kind[s.other[c]] == DYNAMIC then
      limit(b, s.other[c])
    end
  end
  for n = 1, s.rows do
    local c = s.order[n]
    s.isFlush[c] = isFlush(b, c)
  end
end

-- Lets what is pushed by more than it can give way forget that: between two that cannot move, each
-- pass has pushed it to and fro.
local function forgetJams(b)
  local s, stamp = b.slants, b.slants.stamp
  for n = 1, s.rows do
    local c = s.order[n]
    local i, j, nx, ny = s.one[c], s.other[c], s.nx[c], s.ny[c]
    local isDeep = s.least[c] - along(b.to, i, j, nx, ny) > JAMMED * ball.smallest(b, i, j)
    local isFast = s.isFlush[c]
      and -along(b.speed, i, j, nx, ny) * b.dt > JAMMED * ball.smallest(b, i, j)
    if isDeep or isFast then
      s.jamAt[i], s.jamAt[j] = stamp, stamp
    end
  end
  for c = 1, s.count do
    if s.jamAt[s.one[c]] == stamp or s.jamAt[s.other[c]] == stamp then
      s.push[c], s.impulse[c] = 0.0, 0.0
    end
  end
end

-- Returns the acceleration that body k has had on its way, if it began that at the place and with
-- the speed from which it comes there; at most `most`.
local function accelOf(b, k, tau, most)
  local a = tau > 0 and 2 * (b.speed[k] - (b.to[k] - b.from[k]) / tau) / tau or 0.0
  return max(min(a, most), -most)
end

-- Notes which bodies have been pushed.
local function note(b)
  local s, stamp, inHeap = b.slants, b.solveStamp, b.heapWork.inHeap
  for n = 1, s.rows do
    local c = s.order[n]
    local i, j = s.one[c], s.other[c]
    if s.isFlush[c] then
      b.deflectedAt[i], b.deflectedAt[j] = stamp, stamp
      for m = 1, 2 do
        local k = m == 1 and 2 * i or 2 * j
        if b.give[k] > 0 then
          local x, y =
            (b.freeSpeed[k] - b.start[k]) / b.dt, (b.freeSpeed[k + 1] - b.start[k + 1]) / b.dt
          local most, tau = max(x, -x, y, -y), (1 - b.time[m == 1 and i or j]) * b.dt
          path.finish(b, k, b.to[k], b.speed[k], accelOf(b, k, tau, most))
          path.finish(b, k + 1, b.to[k + 1], b.speed[k + 1], accelOf(b, k + 1, tau, most))
        end
      end
      if c <= s.count and b.give[2 * i] > 0 and b.give[2 * j] > 0 then
        inHeap[i], inHeap[j] = stamp, stamp
      end
    end
  end
end

--- Pushes all pairs apart that are too near at the end of the step.
function slant.press(b)
  local s = b.slants
  listRows(b)
  if s.rows == 0 then
    return
  end
  local hasWeight = not b.isWeightless
  listWalls(b)
  weigh(b, false)
  sweep(b, b.to, s.push, PASSES, false, false, hasWeight)
  leaveWalls(b, b.to, false)
  findFlush(b)
  sweep(b, b.speed, s.impulse, PASSES, true, false, hasWeight)
  leaveWalls(b, b.speed, true)
  if hasWeight then
    weigh(b, true)
    sweep(b, b.to, s.push, SHOCKS, false, true, hasWeight)
    leaveWalls(b, b.to, false)
    sweep(b, b.speed, s.impulse, SHOCKS, true, true, hasWeight)
    leaveWalls(b, b.speed, true)
  end
  forgetJams(b)
  note(b)
end

-- Leaves bodies that rest against slants exactly where they were: rounding would let them creep.
local function rest(b)
  local s, to, speed, carried = b.slants, b.to, b.speed, b.carried
  arrange(b)
  for c = 1, s.count do
    s.isFlush[c] = isFlush(b, c)
    for n = 1, s.isFlush[c] and 2 or 0 do
      local i = n == 1 and s.one[c] or s.other[c]
      local k = 2 * i
      local x, y = to[k] - path.home(b, k), to[k + 1] - path.home(b, k + 1)
      local u, v = (speed[k] - carried[k]) * b.dt, (speed[k + 1] - carried[k + 1]) * b.dt
      if b.kind[i] == DYNAMIC and max(x, -x, y, -y, u, -u, v, -v) <= EPSILON then
        path.putBack(b, i)
      end
    end
  end
end

-- Prepares the awake bodies for the end of the step. Those that `ball` has held can be pushed
-- again.
local function release(b)
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.stillAt[i] == b.solveStamp then
      b.give[2 * i], b.give[2 * i + 1] = b.inverseMass[i], b.inverseMass[i]
    end
  end
end

--- Presses what the rounds have left in each other, and finds the heaps. Returns whether there is
--- something slanted.
function slant.finish(b)
  release(b)
  findLate(b)
  if b.slants.count == 0 then
    return false
  elseif slant.isViolated(b) then
    slant.press(b)
  end
  rest(b)
  pairFinder.run(b, b.awakeList, b.awakeCount)
  heap.spreadStamp(b, b.heapWork.inHeap)
  return true
end

--- Notes the hits of pairs that begin to touch in this step, and forgets those that did not come to
--- that.
function slant.tell(b)
  local s = b.slants
  for c = 1, s.count do
    local p, i, j = s.pair[c], s.one[c], s.other[c]
    if s.isFlush[c] then
      b.resolved = b.resolved + 1
      if b.contact[p] == 0 then
        local axis, isLow = shapes.sideOf(s.nx[c], s.ny[c], false)
        impact.note(b, p, isLow and i or j, axis, max(s.speed[c], 0.0), s.time[c])
      end
    elseif b.contact[p] == 0 then
      b.hit[p] = 0
    end
  end
end

return slant
