--- Walking: what stands on the ground follows it, where there are slopes.
--
-- The solver settles a body on a slope as if that were level. Then `walk.run` follows the ground
-- from where the body was to where it ends across gravity, piece by piece, and puts it there: up
-- and down, over feet, crests and seams, at any speed. What stands on it is moved as much (`lift`).
-- Where that would press it, or what stands on it, into what cannot give way, it stops: a slope is
-- a wall there.
--
-- The way along the ground is a polyline, of which `b.piecePlace` (across gravity) and
-- `b.pieceHeight` hold the corners. The sweep follows it, and `path.advance` stays on it.
--
-- Heights are counted against gravity here: `turn` is 1 where gravity points to high coordinates,
-- -1 else; a height times `turn` is less where it is further up.
--
-- Reads paths, contacts, heldLow, heldHigh; writes to, speed, give, separations, hasWalked.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local ground = require(root .. ".solver.ground")
local interpreted = require(root .. ".memory.jit")
local pairFinder = require(root .. ".broadphase.pairFinder")
local settle = require(root .. ".solver.settle")
local slope = require(root .. ".solver.slope")
local triangle = require(root .. ".memory.triangle")

local walk = {}

local EPSILON, DYNAMIC = columns.EPSILON, columns.DYNAMIC
local isRamp = slope.bears
local FIRST, SOLID = triangle.FIRST, triangle.SOLID
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
local HUGE = math.huge
-- Pieces of the way of one body in a step.
local MOST = 256
-- How often all walk in a step of the solver, as they get into each other's way.
local PASSES = 4
-- px by which what was stopped may be beyond that place, as it is rounded.
local ROUNDING = 1e-8
-- px: what is no support any more holds nothing.
local FREE = -1e30

-- Whether a slope is near slot i.
local function isNearSlope(b, i)
  local half = b.head[i]
  while half ~= 0 do
    if b.shape[b.other[half]] >= FIRST then
      return true
    end
    half = b.next[half]
  end
  return false
end

local function addPiece(b, x, height)
  local n = b.pieceCount + 1
  b.pieceCount = n
  b.piecePlace[n], b.pieceHeight[n] = x, height
end

-- How high slot i can be on a piece of which the middle is at `middle`, where it is at x.
local function limitAt(b, i, axis, turn, x, middle)
  local room, j = b.room[2 * i + axis], b.roof[2 * i + axis]
  if j > 0 and ground.isOver(b, j, axis, middle, b.size[2 * i + 1 - axis]) then
    local m, u = 2 * j + axis, 2 * j + 1 - axis
    return max(room, turn * b.to[m] + slope.separation(b, i, j, axis, x, b.to[u]))
  end
  return room
end

-- Whether two heights differ by rounding only.
local function areLevel(one, other)
  return one - other <= EPSILON and other - one <= EPSILON
end

-- The end of a piece from (x, height) to (xEnd, last), if only `way` px along the ground are left.
local function shorten(x, height, xEnd, last, way)
  local dx, dy = xEnd - x, last - height
  local length = dy == 0 and max(dx, -dx) or sqrt(dx * dx + dy * dy)
  if length <= way then
    return xEnd, last, way - length
  end
  return x + dx * (way / length), height + dy * (way / length), 0
end

-- Follows the ground from (x0, height) to x1, as far as there is room, or with `isFree` anyhow;
-- `isMeasured`: no further along the ground than that is away. Returns where it ends, how high, and
-- what it is on there (0: it is on no ground); and whether it was stopped.
local function follow(b, i, axis, turn, x0, x1, height, isMeasured, isFree)
  local x, on, way = x0, 0, max(x1 - x0, x0 - x1)
  for n = 1, MOST do
    local turnAt = n < MOST and ground.nextTurn(b, x, x1) or x1
    local xEnd, last, its = ground.endOf(b, i, axis, turn, x, turnAt, height)
    if its == 0 then
      x = isMeasured and x + (x1 >= x0 and way or -way) or x1
      addPiece(b, x, height)
      return x, height, on, false
    end
    on = its
    b.ground.isLevel = b.ground.isLevel
      and areLevel(last, height)
      and not isRamp(b, its, axis, turn)
    if isMeasured then
      xEnd, last, way = shorten(x, height, xEnd, last, way)
    end
    local middle = (x + xEnd) * 0.5
    local first = height - limitAt(b, i, axis, turn, x, middle)
    local left = last - limitAt(b, i, axis, turn, xEnd, middle)
    if left < -ROUNDING and left < first and not isFree then
      local share = max(min(first / (first - left), 1.0), 0.0)
      x, height = x + (xEnd - x) * share, height + (last - height) * share
      addPiece(b, x, height)
      return x, height, on, true
    end
    x, height = xEnd, last
    addPiece(b, x, height)
    if x == x1 or (isMeasured and way <= 0) then
      break
    end
  end
  return x, height, on, false
end

-- The ground that holds slot i, or 0.
local function groundUnder(b, k, turn)
  local held, wall = b.heldHigh, b.holderHigh
  if turn < 0 then
    held, wall = b.heldLow, b.holderLow
  end
  return held[k] == 2 and floor(wall[k] * 0.5) or 0
end

-- Slot i cannot go on: a slope would press it against a ceiling.
local function block(b, i, k, on, way)
  b.speed[k], b.accel[k], b.give[k] = b.speed[2 * on + k % 2], 0.0, 0
  if way > 0 then
    b.pressedHigh[k] = true
  else
    b.pressedLow[k] = true
  end
  local n = b.blockedCount + 1
  b.blockedCount = n
  b.blocked[2 * n - 1], b.blocked[2 * n] = 4 * i + 2 * (k % 2) + (way > 0 and 2 or 1), on
end

-- Returns whether something immovable is in the way of body t across gravity, to x.
local function isBarred(b, t, x)
  local list, give, to = b.contacts[t % 2], b.give, b.to
  for c = 1, list.count do
    local kl, kh, separation = list.low[c], list.high[c], list.separation[c]
    local isOnLow = kh == t and give[kl] == 0 and to[kl] + separation > x + EPSILON
    if isOnLow or kl == t and give[kh] == 0 and x + separation > to[kh] + EPSILON then
      return true
    end
  end
  return false
end

-- The same from (x0, height) on, on slot j, to x1. `isStill`: its way is the polyline.
local function walkFrom(b, i, j, axis, turn, x0, x1, height, isStill)
  local k, t = 2 * i + axis, 2 * i + 1 - axis
  ground.list(b, i, axis, turn, x0, x1, height)
  local first = b.pieceCount + 1
  addPiece(b, x0, height)
  b.ground.isLevel = true
  local isMeasured = b.constantSpeed[i] and b.isFirstWalk
  local x, last, on, isStopped = follow(b, i, axis, turn, x0, x1, height, isMeasured, false)
  if isMeasured or isStopped then
    -- As it will be when it is followed once more, to the bit.
    b.pieceCount = first
    x, last, on = follow(b, i, axis, turn, x0, x, height, false, true)
  end
  local isCaught = isStopped and isBarred(b, t, x)
  if on == 0 or isCaught or (b.ground.isLevel and not isStopped) then
    -- (What is on level ground is where it is anyway. Whether slopes are known to be near it
    -- depends on the past.)
    b.pieceCount = first - 1
    return false
  end
  b.pieceFirst[i], b.pieceLast[i] = isStill and first or 0, isStill and b.pieceCount or 0
  if x == x0 and areLevel(last, height) then
    last = height -- what stands a rounding apart stays so
  end
  local place = turn * last
  b.hasWalked = b.hasWalked or isStopped or place ~= b.to[k] or x ~= b.to[t]
  b.liftOf[k] = place - b.to[k]
  b.to[k] = place
  b.to[t] = x
  if isStopped then
    block(b, i, t, b.roof[k] > 0 and b.roof[k] or on, x1 - x0)
  end
  b.walkOn[i], b.walkFrom[i], b.walkTime[i] = on, j, b.time[i]
  return true
end

-- Lets slot i follow the ground. Returns whether it has come elsewhere along gravity.
local function walkOne(b, i)
  local axis = slope.axisOf(b, i)
  local k, t, turn = 2 * i + axis, 2 * i + 1 - axis, b.down[2 * i + axis]
  local j = groundUnder(b, k, turn)
  if j ~= 0 and b.walkTime[i] == b.time[i] then
    j = b.walkFrom[i] -- where its way begins
  end
  b.pieceFirst[i], b.pieceLast[i] = 0, 0
  if j == 0 or not isNearSlope(b, i) then
    return false
  end
  -- The ground where it ends: what moves takes its riders there.
  local m, left = 2 * j, 1 - b.time[i]
  local shift = (b.to[m + 1 - axis] - b.from[m + 1 - axis]) * left
  local rise = (b.to[m + axis] - b.from[m + axis]) * left
  local x0, x1, height = b.from[t] + shift, b.to[t], turn * (b.from[k] + rise)
  if x0 == x1 and b.to[k] == b.from[k] + rise then
    return false
  end
  return walkFrom(b, i, j, axis, turn, x0, x1, height, shift == 0 and rise == 0)
end

-- The indexes of contact c: that of the body further up, and that of the one below it.
local function upAndDown(list, c, turn)
  if turn < 0 then
    return list.high[c], list.low[c]
  end
  return list.low[c], list.high[c]
end

-- The first and the last contact of a list, in the order along `turn`.
local function ends(list, turn)
  if turn > 0 then
    return 1, list.count
  end
  return list.count, 1
end

-- The supports of slot i are those where it is now: others hold it no more.
local function updateSupports(b, list, turn)
  local axis = list.axis
  for c = 1, list.count do
    local p = list.pair[c]
    local k, m = upAndDown(list, c, turn)
    local i, j = (k - axis) * 0.5, (m - axis) * 0.5
    if b.liftMark[k] == b.walkStamp and b.give[m] == 0 and b.kind[j] ~= DYNAMIC then
      local t, u = k + 1 - 2 * axis, m + 1 - 2 * axis
      local isOn = b.to[t] + b.size[t] > b.to[u] + EPSILON
        and b.to[t] < b.to[u] + b.size[u] - EPSILON
      local apart = FREE
      if isOn or b.walkOn[i] == j then
        apart = b.size[turn > 0 and k or m]
        if isRamp(b, j, axis, turn) then
          apart = slope.separation(b, i, j, axis, b.to[t], b.to[u])
        end
      end
      list.separation[c], b.separation[p] = apart, apart
    end
  end
end

-- What leans on something that has been lifted, or lowered, goes with it.
local function liftStacks(b, list, turn)
  local lift, mark, stamp = b.liftOf, b.liftMark, b.walkStamp
  local first, last = ends(list, -turn)
  for c = first, last, -turn do
    local k, m = upAndDown(list, c, turn)
    if b.give[k] > 0 and b.down[k] == turn then
      local its = mark[m] == stamp and lift[m] or 0.0
      local place = b.to[m] - turn * list.separation[c]
      local mine = mark[k] == stamp and lift[k] or nil
      local before = b.to[k] - (mine or 0.0)
      local gap = (place - its - before) * turn
      -- What the ground leads is left out.
      local isOn = gap <= EPSILON and gap >= -EPSILON and b.walkAt[k] ~= stamp
      if isOn and not mine and its == 0 then
        lift[k], mark[k] = 0.0, stamp -- something else holds it
      elseif isOn and (not mine or (place - b.to[k]) * turn < 0) then
        lift[k], mark[k], b.to[k] = place - before, stamp, place
      end
    end
  end
end

-- How far everything can be moved against gravity.
local function findRoom(b, list, turn)
  local room, roof, axis = b.room, b.roof, list.axis
  for n = 1, b.awakeCount do
    local k = 2 * b.awakeList[n] + axis
    room[k], roof[k] = -HUGE, 0
  end
  local first, last = ends(list, turn)
  for c = first, last, turn do
    local m, k = upAndDown(list, c, turn)
    if b.give[k] > 0 then
      local shape = b.shape[(m - axis) * 0.5]
      if shape >= FIRST and SOLID[axis][shape] == -turn then
        roof[k] = (m - axis) * 0.5
      elseif b.give[m] == 0 then
        room[k] = max(room[k], turn * b.to[m] + list.separation[c])
      elseif room[m] > -HUGE then
        room[k] = max(room[k], room[m] + list.separation[c])
      end
    end
  end
end

-- Lists what may walk along an axis, with gravity on one side; returns how many.
local function listWalkers(b, axis, turn)
  local list, walkers, count = b.awakeList, b.walkers, 0
  for n = 1, b.awakeCount do
    local i = list[n]
    if b.down[2 * i + axis] == turn and b.kind[i] == DYNAMIC and isNearSlope(b, i) then
      count = count + 1
      walkers[count] = i
    end
  end
  return count
end

-- What walkers[1..count] have come onto holds them from now on.
local function addSupports(b, axis, turn, count)
  local walkers = b.walkers
  pairFinder.run(b, walkers, 1, count)
  contacts.noteNew(b)
  for n = 1, count do
    local i = walkers[n]
    local j = b.walkOn[i]
    local p = columns.pairOf(b, i, j)
    if p and b.touches[p] == contacts.APART then
      local k, m = 2 * i + axis, 2 * j + axis
      local kl, kh = turn > 0 and k or m, turn > 0 and m or k
      contacts.add(b, axis, p, kl, kh, b.size[kl], false)
      b.pressed[p] = 1
    end
  end
  contacts.rearrange(b)
end

-- Lets all with gravity on one side of an axis follow the ground.
local function walkAlong(b, axis, turn)
  local candidates = listWalkers(b, axis, turn)
  if candidates == 0 then
    return
  end
  local list, walkers, count = b.contacts[axis], b.walkers, 0
  b.walkStamp = b.walkStamp + 1
  findRoom(b, list, turn)
  for n = 1, candidates do
    local i = walkers[n]
    if walkOne(b, i) then
      local k = 2 * i + axis
      count = count + 1
      walkers[count] = i
      b.liftMark[k], b.walkAt[k] = b.walkStamp, b.walkStamp
    end
  end
  if count > 0 then
    addSupports(b, axis, turn, count)
    updateSupports(b, list, turn)
    liftStacks(b, list, turn)
  end
end

-- Where all else that touches a slope ends: it may have come nearer, as it goes across it.
local function updateOthers(b, axis, firstStamp)
  local list = b.contacts[axis]
  for c = 1, list.count do
    local p = list.pair[c]
    local i, j = slope.order(b, b.pairA[p], b.pairB[p])
    local k, shape = 2 * i + axis, b.shape[j]
    local hasWalked = (b.walkAt[k] or 0) >= firstStamp -- its ground is known
    if shape >= FIRST and not (hasWalked and SOLID[axis][shape] == b.down[k]) then
      local kl, kh, t = list.low[c], list.high[c], 1 - axis
      local apart = slope.apartOn(b, i, j, axis, kl == k, b.to[2 * i + t], b.to[2 * j + t])
      b.hasWalked = b.hasWalked or list.separation[c] ~= apart
      list.separation[c], b.separation[p] = apart, apart
      if b.to[kl] + apart - b.to[kh] > EPSILON and b.give[k] > 0 then
        b.speed[k], b.accel[k], b.pressed[p] = b.speed[2 * j + axis], 0.0, 1
      end
    end
  end
end

-- What was stopped, and has come into a wall with its ground since, is held by that.
local function yieldToWalls(b)
  for n = 1, b.blockedCount do
    local i = floor((b.blocked[2 * n - 1] - 1) * 0.25)
    local t = 2 * i + 1 - slope.axisOf(b, i)
    if isBarred(b, t, b.to[t]) then
      b.give[t] = b.inverseMass[i]
    end
  end
end

--- Forgets all ways of an earlier attempt.
function walk.begin(b)
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    b.pieceFirst[i], b.pieceLast[i], b.walkTime[i] = 0, 0, -1
  end
  b.blockedCount = 0
end

--- Lets all bodies that stand on something follow the ground to where they are across gravity at
--- the end of the step. `isMeasured`: for the first time in this step, in which ways are measured.
function walk.run(b, dt, isMeasured)
  b.isFirstWalk = isMeasured
  yieldToWalls(b)
  for _ = 1, PASSES do
    local isSettled, firstStamp = false, b.walkStamp + 1
    b.pieceCount, b.hasWalked = 0, false
    for axis = 0, 1 do
      walkAlong(b, axis, 1)
      walkAlong(b, axis, -1)
      updateOthers(b, axis, firstStamp)
    end
    for axis = 0, 1 do
      -- What pushes those that were stopped is stopped, too. (If slopes have moved nothing, nothing
      -- is settled again: whether there are any must not show.)
      if b.hasWalked and settle.isViolated(b, axis) then
        settle.axis(b, axis, dt, true)
        isSettled = true
      end
    end
    b.isFirstWalk = false
    if not isSettled then
      break
    end
  end
end

--- Lets `touching` show the slopes at which bodies were stopped.
function walk.showBlocked(b)
  for n = 1, b.blockedCount do
    local at, j = b.blocked[2 * n - 1], b.blocked[2 * n]
    if b.touchBest[at] == 0 then
      b.touchBest[at] = j
    end
  end
end

-- These lead from loop to loop.
interpreted.functions(addSupports, walkAlong, walk.run)

return walk
