--- Heap: moves balls, and what lies between them, apart all together at the end of a step.
--
-- Impacts happen one after the other, and in a heap one makes the next: that does not end within a
-- step. So pairs with a ball that rest on each other slanted, or meet too often, are left to the
-- heap (see heapPairs). What is near these bodies takes part, too.
--
-- A pass goes through the pairs from the lowest body to the highest. Two that overlap at the end of
-- the step are pushed apart along their normal, and lose the speed with which they close. In the
-- last passes the lower one of two counts as immovable: what is left over goes up, and not into the
-- ground. Then come those that cannot move, static ones last, so that walls hold.
--
-- Sources: position based dynamics (M. Müller, B. Heidelberger, M. Hennix, J. Ratcliff, 2007) for
-- the passes; shock propagation (E. Guendelman, R. Bridson, R. Fedkiw, 2003) for the last ones.
--
-- Reads heapPairs, the ends of the paths, give; writes to, speed, touches, news and deflectedAt.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local heapPairs = require(root .. ".solver.heapPairs")
local interpreted = require(root .. ".memory.jit")
local pairFinder = require(root .. ".broadphase.pairFinder")
local path = require(root .. ".motion.path")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")
local triangle = require(root .. ".memory.triangle")
local sort = require(root .. ".memory.sort")

local heap = {}

local CIRCLE, DYNAMIC, HUGE = columns.SHAPE_CIRCLE, columns.DYNAMIC, math.huge
local SOLID = triangle.SOLID
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
-- Number of passes in which both of two give way, and of those in which the lower one does not.
local PASSES, SHOCKS = 8, 4
-- px by which a body may be apart from one in the heap, and take part.
local REACH = 1
-- Share of its size by which a body is moved along each axis, for pairs that are listed once. Its
-- centre does not get into a wall, so that the normal of that is known.
local FURTHEST = 0.35
-- Maximum number of times that the pairs are listed.
local LISTS = 2
-- px: when no two overlap by more, the next passes are the last ones.
local ENOUGH = 1e-3
-- Share of a normal along gravity from which on one of two is above the other.
local ABOVE = 0.1
local SLOW = heapPairs.SLOW
-- Keys of pairs with a body that does not move: after all others.
local HELD, STATIC = 1e300, HUGE

-- Returns whether the bodies of pair p may push each other.
local function isOpen(b, p, i, j)
  if b.sensor[i] or b.sensor[j] or b.passing[p] or b.dropping[p] then
    return false
  elseif b.touches[p] == contacts.GHOST then
    return false
  end
  -- Of a pair that has not met, the open sides of a one-way or the game have not been asked.
  return b.touches[p] ~= contacts.APART or not (b.hasAskers or b.oneWay[i] or b.oneWay[j])
end

-- Returns the gap between slot i and slope j at the end of the step, px, and the normal of that,
-- from the slope.
local function slopeGap(b, i, j)
  local axis, isLow, gap = slope.touch(b, i, j, b.to)
  if not axis then
    return max(gap, 0.0), 0.0, 0.0
  elseif axis == slope.axisOf(b, i) and isLow == (SOLID[axis][b.shape[j]] > 0) then
    local nx, ny = triangle.normal(b.shape[j], b.size[2 * j], b.size[2 * j + 1])
    local along = axis == 0 and nx or ny -- the gap is along gravity
    return gap * max(along, -along), nx, ny
  end
  local sign = isLow and -1 or 1
  return gap, axis == 0 and sign or 0.0, axis == 1 and sign or 0.0
end

-- Returns the same of two boxes; the normal is from j to i.
local function boxGap(b, i, j)
  local to, size, k, m = b.to, b.size, 2 * i, 2 * j
  local x, y = to[k] - to[m], to[k + 1] - to[m + 1]
  local right, bottom = x - size[m], y - size[m + 1]
  local gapX, gapY = max(right, -x - size[k]), max(bottom, -y - size[k + 1])
  if gapX > gapY then
    return gapX, gapX == right and 1 or -1, 0.0
  end
  return gapY, 0.0, gapY == bottom and 1 or -1
end

-- Returns the same of two balls.
local function ballGap(b, i, j)
  local to, size, k, m = b.to, b.size, 2 * i, 2 * j
  local more = (size[k] - size[m]) * 0.5
  local x, y = to[k] - to[m] + more, to[k + 1] - to[m + 1] + more
  local distance, reach = sqrt(x * x + y * y), (size[k] + size[m]) * 0.5
  if distance == 0 then
    return -reach, 0.0, 0.0
  end
  return distance - reach, x / distance, y / distance
end

-- Returns the same of any two.
local function gapBetween(b, i, j)
  if b.shape[i] == CIRCLE and b.shape[j] == CIRCLE then
    return ballGap(b, i, j)
  elseif b.hasSlopes and slope.isPair(b, i, j) then
    if slope.isOne(b, j) then
      return slopeGap(b, i, j)
    end
    local gap, nx, ny = slopeGap(b, j, i)
    return gap, -nx, -ny
  elseif ball.isRound(b, i, j) then
    local gap, nx, ny = ball.gapIn(b, b.to, i, j)
    if nx ~= 0 or ny ~= 0 then
      return gap, nx, ny
    end
    -- The centre of the ball is in the box.
  end
  return boxGap(b, i, j)
end

-- Lets slot i take part if it can move.
local function join(b, i)
  local work = b.heapWork
  local canMove = b.kind[i] == DYNAMIC and b.awake[i] and not b.stuck[i]
  if canMove and work.joined[i] ~= work.stamp then
    work.joined[i], work.count = work.stamp, work.count + 1
    work.members[work.count] = i
  end
end

-- Returns whether slot i may come to slot j in this step: it is near, or stood at it. (What it
-- stood at is not swept again; all else is.)
local function mayReach(b, p, i, j)
  local isHeld = b.touches[p] == contacts.CONTACT and b.kind[j] ~= DYNAMIC
  return isHeld or gapBetween(b, i, j) <= REACH
end

-- Lists the pairs of slot i with what is near, which takes part, too.
local function spread(b, i)
  local work, half = b.heapWork, b.head[i]
  while half ~= 0 do
    local j, p = b.other[half], floor(half * 0.5 + 0.5)
    local isNew = work.listed[p] ~= work.stamp and isOpen(b, p, i, j)
    if isNew and mayReach(b, p, i, j) then
      join(b, j)
      work.listed[p], work.pairCount = work.stamp, work.pairCount + 1
      work.pairs[work.pairCount] = p
      if b.touches[p] ~= contacts.CONTACT and heapPairs.areLoose(b, i, j) then
        b.touches[p] = heapPairs.HEAP
      end
    end
    half = b.next[half]
  end
end

-- Returns how high slot i is, against its gravity; without gravity its place in the order of the
-- world.
local function heightOf(b, i)
  local k, down, to, size = 2 * i, b.down, b.to, b.size
  local x, y = down[k], down[k + 1]
  if x == 0 and y == 0 then
    return b.rank[i]
  end
  return -x * (to[k] + size[k] * 0.5) - y * (to[k + 1] + size[k + 1] * 0.5)
end

-- Returns the key of slot i among the lower bodies of pairs.
local function lowerKey(b, i)
  local work = b.heapWork
  if work.joined[i] == work.stamp then
    return work.height[i]
  end
  return b.kind[i] == DYNAMIC and HELD or STATIC
end

-- Sorts the pairs: by the higher body, then the lower one, then the order of the world.
local function sortPairs(b)
  local work = b.heapWork
  for n = 1, work.pairCount do
    local p = work.pairs[n]
    local i, j = b.pairA[p], b.pairB[p]
    local one, other = lowerKey(b, i), lowerKey(b, j)
    local low, high = min(one, other), max(one, other)
    local isHeld = high >= HELD
    work.lower[p], work.upper[p] = isHeld and high or low, isHeld and low or high
    work.first[p], work.second[p] = columns.ranks(b, i, j)
    -- Which of a pair is the first depends on the broad phase.
    local isFirst = b.rank[i] < b.rank[j]
    work.one[p], work.other[p] = isFirst and i or j, isFirst and j or i
  end
  sort.by(work.pairs, work.pairCount, work.upper, work.lower, work.first, work.second)
end

-- Lists the bodies of the heap and its pairs.
local function collect(b)
  local work, n = b.heapWork, 1
  work.stamp, work.count, work.pairCount = work.stamp + 1, 0, 0
  for at = 1, b.heapCount do
    join(b, b.pairA[b.heapPairs[at]])
    join(b, b.pairB[b.heapPairs[at]])
  end
  while n <= work.count do
    local last = work.count
    pairFinder.runWithin(b, work.members, n, last, REACH)
    contacts.noteNew(b)
    for at = n, last do
      spread(b, work.members[at])
    end
    n = last + 1
  end
  for at = 1, work.count do
    local i = work.members[at]
    work.height[i], work.x[i], work.y[i] = heightOf(b, i), b.to[2 * i], b.to[2 * i + 1]
    b.deflectedAt[i], b.news[i] = b.solveStamp, true
    path.change(b, i)
  end
  sortPairs(b)
end

-- Returns the inverse masses of two along the normal: of i, then of j. `isShock`: the lower one is
-- immovable.
local function weigh(b, i, j, nx, ny, isShock)
  local give, k, m = b.give, 2 * i, 2 * j
  local ix, iy, jx, jy = give[k], give[k + 1], give[m], give[m + 1]
  if b.power[i] ~= b.power[j] then
    ix, iy, jx, jy = ball.share(b, i, j, nx, ny, ix, iy, jx, jy)
  end
  if isShock and max(ix, iy) > 0 and max(jx, jy) > 0 then
    local down = b.down[k] ~= 0 and b.down[k] * nx or b.down[k + 1] * ny
    if down < -ABOVE then
      return ix, iy, 0.0, 0.0
    elseif down > ABOVE then
      return 0.0, 0.0, jx, jy
    end
  end
  return ix, iy, jx, jy
end

-- Moves slot i by a way, but no further than FURTHEST from where the heap has found it.
local function shift(b, i, x, y)
  local work, to, k = b.heapWork, b.to, 2 * i
  local wide, high = FURTHEST * b.size[k], FURTHEST * b.size[k + 1]
  to[k] = max(min(to[k] + x, work.x[i] + wide), work.x[i] - wide)
  to[k + 1] = max(min(to[k + 1] + y, work.y[i] + high), work.y[i] - high)
end

-- Pushes two apart that overlap at the end of the step.
local function part(b, i, j, gap, nx, ny, isShock)
  local k, m, speed = 2 * i, 2 * j, b.speed
  local ix, iy, jx, jy = weigh(b, i, j, nx, ny, isShock)
  local total = nx * nx * (ix + jx) + ny * ny * (iy + jy)
  if total == 0 then
    return
  end
  local way = -gap / total
  b.heapWork.pushed[i], b.heapWork.pushed[j] = b.heapWork.stamp, b.heapWork.stamp
  if max(ix, iy) > 0 then
    shift(b, i, way * nx * ix, way * ny * iy)
  end
  if max(jx, jy) > 0 then
    shift(b, j, -way * nx * jx, -way * ny * jy)
  end
  local closing = (speed[m] - speed[k]) * nx + (speed[m + 1] - speed[k + 1]) * ny
  local impulse = max(closing, 0.0) / total
  speed[k], speed[k + 1] = speed[k] + impulse * nx * ix, speed[k + 1] + impulse * ny * iy
  speed[m], speed[m + 1] = speed[m] - impulse * nx * jx, speed[m + 1] - impulse * ny * jy
end

-- Makes one pass over the pairs of which the lower body has at least that key. Returns the largest
-- overlap, px.
local function pass(b, key, isShock)
  local work, shape, most = b.heapWork, b.shape, 0.0
  local pairs, lower, ones, others = work.pairs, work.lower, work.one, work.other
  for n = 1, work.pairCount do
    local p = pairs[n]
    if lower[p] >= key then
      local i, j = ones[p], others[p]
      local gap, nx, ny ---@type number, number, number
      if shape[i] == CIRCLE and shape[j] == CIRCLE then
        gap, nx, ny = ballGap(b, i, j)
      else
        gap, nx, ny = gapBetween(b, i, j)
      end
      if gap < 0 then
        most = max(most, -gap)
        part(b, i, j, gap, nx, ny, isShock)
      end
    end
  end
  return most
end

-- Takes from the bodies that were pushed, and are as slow as in a heap that rests, the part of
-- their speed with which they get nowhere.
local function slow(b, dt)
  local work, speed, pull = b.heapWork, b.speed, b.pull
  for n = 1, work.count do
    local i = work.members[n]
    local x, y, left = 2 * i, 2 * i + 1, (1 - b.time[i]) * dt
    local fall = max(pull[x], -pull[x], pull[y], -pull[y]) * dt
    local isSlow = max(speed[x], -speed[x], speed[y], -speed[y]) <= SLOW * fall
    for k = x, isSlow and work.pushed[i] == work.stamp and y or 0 do
      local got = left > 0 and (b.to[k] - b.from[k]) / left or 0.0
      speed[k] = max(min(speed[k], max(got, 0.0)), min(got, 0.0))
    end
  end
end

-- Makes the passes over the pairs that are listed.
local function solve(b)
  local n = 1
  while n <= PASSES and pass(b, -HUGE, false) > ENOUGH do
    n = n + 1
  end
  for _ = 1, SHOCKS do
    pass(b, -HUGE, true)
  end
  for _ = 1, SHOCKS do
    pass(b, STATIC, false)
  end
end

-- Returns whether a body was pushed so far that it may have come to others than those that are
-- listed.
local function isFar(b)
  local work, to = b.heapWork, b.to
  for n = 1, work.count do
    local i = work.members[n]
    local x, y = to[2 * i] - work.x[i], to[2 * i + 1] - work.y[i]
    if max(x, -x, y, -y) > REACH * 0.5 then
      return true
    end
  end
  return false
end

--- Moves the balls of heaps apart.
function heap.run(b, dt)
  for _ = 1, LISTS do
    collect(b)
    solve(b)
    if not isFar(b) then
      break
    end
  end
  slow(b, dt)
end

-- These take another branch for each pair, or lead from loop to loop. (jit: 4)
interpreted.functions(
  isOpen,
  slopeGap,
  boxGap,
  gapBetween,
  mayReach,
  join,
  spread,
  heightOf,
  lowerKey
)
interpreted.functions(sortPairs, collect, solve, heap.run)

return heap
