--- Knots: bodies that overlap and do not come apart look for room elsewhere, or stand still.
--
-- Bodies that overlap, directly or through others, are a *knot*. While the sum of the overlaps of a
-- knot falls, it is left to the solver. If it has not fallen for PATIENCE s, some of its bodies
-- *leave*: each goes to the nearest free place along an axis, as far as no wall is in the way, and
-- passes through other bodies on that way. If none of them finds such a place, the knot is *stuck*:
-- its bodies do not move and cannot be pushed, as if they were walls. It begins anew when the game
-- writes one of them or puts something into it, when a wall beside it goes or moves, or when a knot
-- beside it begins anew.
--
-- So a heap without room comes to rest, and comes apart when there is room again.
--
-- Reads contacts, deepIn, to; writes stuck, leaving, waited, tries, knotLeast, stuckWalls, from.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local pairFinder = require(root .. ".broadphase.pairFinder")
local sort = require(root .. ".memory.sort")

require(root .. ".memory.jit").file()

local stuck = {}

local DYNAMIC, KINEMATIC, EPSILON = columns.DYNAMIC, columns.KINEMATIC, columns.EPSILON
local floor, huge, max, min = math.floor, math.huge, math.max, math.min
--- s for which the overlaps of a knot may stay as they are.
stuck.PATIENCE = tonumber(os.getenv("TIME") or 0.3)
local PATIENCE = stuck.PATIENCE
-- A knot comes apart if the sum of its overlaps falls to this share of what it was.
local PROGRESS = tonumber(os.getenv("PROGRESS") or 0.95)
-- How often a body leaves a knot before it is stuck.
local TRIES = tonumber(os.getenv("TRIES") or 3)
-- A knot that is so many times as deep as it was is another one.
local GROWTH = 2
-- What `tries` is of a body that a machine squeezes.
local CAUGHT = TRIES + 1
-- Bodies that leave at a time.
local MOST = 24
-- In sizes of a body: how far away it looks for room, and how far it goes in a step.
local REACH, PACE = 16, 0.25

-- px between slots i and j, below 0: they overlap.
local function gapOf(b, place, i, j)
  local size, k, m = b.size, 2 * i, 2 * j
  local x, y = place[m] - place[k], place[m + 1] - place[k + 1]
  return max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1])
end

-- Whether slot j is kinematic and moves in this step.
local function isMachine(b, j)
  local k = 2 * j
  return b.kind[j] == KINEMATIC
    and (
      b.velocity[k] ~= 0
      or b.velocity[k + 1] ~= 0
      or b.written[k] ~= b.position[k]
      or b.written[k + 1] ~= b.position[k + 1]
    )
end

-- Returns how many walls and stuck bodies slot i touches, and whether one of them is on its way.
local function countWalls(b, i)
  local half, count, moves = b.head[i], 0, false
  while half ~= 0 do
    local j = b.other[half]
    local isWall = b.kind[j] ~= DYNAMIC or b.stuck[j]
    if isWall and not b.sensor[j] and gapOf(b, b.from, i, j) <= EPSILON then
      count, moves = count + 1, moves or isMachine(b, j)
    end
    half = b.next[half]
  end
  return count, moves
end

-- Frees slot i, and the stuck bodies that it touches, directly or through others.
local function free(b, i)
  local stack, count = b.stack, 1
  stack[1], b.stuck[i] = i, false
  while count > 0 do
    i, count = stack[count], count - 1
    b.waited[i], b.tries[i] = 0, 0
    local half = b.head[i]
    while half ~= 0 do
      local j = b.other[half]
      if b.stuck[j] and gapOf(b, b.from, i, j) <= EPSILON then
        b.stuck[j] = false
        count = count + 1
        stack[count] = j
      end
      half = b.next[half]
    end
  end
end

-- Frees what may have room now.
local function freeSome(b)
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.stuck[i] then
      local walls, moves = countWalls(b, i)
      local isWritten = b.moved[i] or b.velocity[2 * i] ~= 0 or b.velocity[2 * i + 1] ~= 0
      if moves or isWritten or walls < b.stuckWalls[i] then
        free(b, i)
      end
      b.stuckWalls[i] = walls
    end
  end
end

-- Whether slot i, which goes along an axis, slides along the wall j beside it rather than into it.
local function slidesAlong(b, i, j, axis)
  local from, size, k, m = b.from, b.size, 2 * i, 2 * j
  local x = min(from[k] + size[k], from[m] + size[m]) - max(from[k], from[m])
  local y = min(from[k + 1] + size[k + 1], from[m + 1] + size[m + 1]) - max(from[k + 1], from[m + 1])
  return x > 0 and y > 0 and ((axis == 0 and y < x) or (axis == 1 and x < y))
end

-- Lists in b.found what is in the way of slot i on the line through it along an axis. Returns how
-- many there are, and the range between the walls.
local function listInWay(b, i, axis)
  local from, size, found, k, c = b.from, b.size, b.found, 2 * i + axis, 2 * i + 1 - axis
  local reach = REACH * size[k]
  local low, high, count = from[k] - reach, from[k] + size[k] + reach, 0
  local near, far = from[c] + EPSILON, from[c] + size[c] - EPSILON
  local total = axis == 0 and b.broadphase:query(low, near, high, far, found)
    or b.broadphase:query(near, low, far, high, found)
  for n = 1, total do
    local j = found[n]
    local m, d = 2 * j + axis, 2 * j + 1 - axis
    local isPassed = j == i or b.sensor[j] or b.oneWay[j] or not filter.allows(b, i, j)
    if isPassed or from[d] >= far or from[d] + size[d] <= near then
      -- not in the way
    elseif b.kind[j] == DYNAMIC then
      count = count + 1
      found[count] = j
    elseif not slidesAlong(b, i, j, axis) then
      b.isNearMachine = b.isNearMachine or isMachine(b, j)
      if 2 * from[m] + size[m] < 2 * from[k] + size[k] then
        low = max(low, from[m] + size[m])
      else
        high = min(high, from[m])
      end
    end
  end
  return count, low, high - size[k]
end

-- The nearest place for slot i towards `sign` along an axis at which none of found[1..count] is.
local function nearestFree(b, i, axis, sign, count)
  local from, size, found, k = b.from, b.size, b.found, 2 * i + axis
  local place, before = from[k], nil
  while place ~= before do
    before = place
    for n = 1, count do
      local m = 2 * found[n] + axis
      if place + size[k] > from[m] + EPSILON and place < from[m] + size[m] - EPSILON then
        place = sign > 0 and max(place, from[m] + size[m]) or min(place, from[m] - size[k])
      end
    end
  end
  return place
end

-- Returns the axis along which slot i has the nearest free place, and that; nil if there is none.
local function findRoom(b, i)
  local bestAxis, bestPlace, bestWay = nil, 0, huge
  for n = 0, 1 do
    local axis = n == 0 and b.downAxis or 1 - b.downAxis
    local count, low, high = listInWay(b, i, axis)
    for sign = -1, 1, 2 do
      local place = nearestFree(b, i, axis, sign, count)
      local way = max(place - b.from[2 * i + axis], b.from[2 * i + axis] - place)
      if place >= low and place <= high and way < bestWay - EPSILON then
        bestAxis, bestPlace, bestWay = axis, place, way
      end
    end
  end
  return bestAxis, bestPlace, bestWay
end

-- Lets slot i go on towards the nearest free place. It is there when it overlaps no other body.
local function leave(b, i)
  local axis, place, way = findRoom(b, i)
  local _, isPushed = countWalls(b, i)
  if not axis or way <= EPSILON or isPushed then
    b.exiting[i], b.waited[i] = false, 0
    return
  end
  local k = 2 * i + axis
  local step = PACE * b.size[k]
  b.from[k] = max(min(place, b.from[k] + step), b.from[k] - step)
  b.to[k] = b.from[k]
end

--- Frees what may have room now, and moves what leaves a knot.
function stuck.run(b)
  if not b.hasStuck then
    return
  end
  freeSome(b)
  local list, count, rank = b.leavers, 0, b.rank
  for n = 1, b.awakeCount do
    if b.exiting[b.awakeList[n]] then
      count = count + 1
      list[count] = b.awakeList[n]
    end
  end
  if count > 0 then
    sort.by(list, count, rank, rank, rank)
    for n = 1, count do
      leave(b, list[n])
    end
    pairFinder.run(b, list, 1, count)
  end
end

local function leaderOf(knot, i)
  while knot[i] ~= i do
    i = knot[i]
  end
  return i
end

-- Makes one knot of those of slots i and j; returns the slot that leads it.
local function unite(b, i, j)
  local knot, sum = b.knot, b.knotSum
  local one, two = leaderOf(knot, i), leaderOf(knot, j)
  if b.rank[two] < b.rank[one] then
    local first = two
    two = one
    one = first
  end
  if one ~= two then
    knot[two], sum[one] = one, sum[one] + sum[two]
  end
  return one
end

-- Ties the bodies that overlap into knots, and sums their overlaps.
local function tie(b)
  local knot, sum = b.knot, b.knotSum
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    knot[i], sum[i], b.knotWaits[i] = i, 0.0, PATIENCE
  end
  for axis = 0, 1 do
    local list = b.contacts[axis]
    for c = 1, list.count do
      local p = list.pair[c]
      if b.deepIn[p] == b.solveStamp then
        local i, j = b.pairA[p], b.pairB[p]
        local leader = unite(b, i, j)
        sum[leader] = sum[leader] + max(-gapOf(b, b.to, i, j), 0)
      end
    end
  end
end

-- Whether one of the two bodies that press body k in the end is a machine on its way.
local function isPressedByMachine(b, k)
  local low, high = b.holderLow[k], b.holderHigh[k]
  return (b.kind[floor(low * 0.5)] == KINEMATIC and b.speed[low] > 0)
    or (b.kind[floor(high * 0.5)] == KINEMATIC and b.speed[high] < 0)
end

-- Notes whether a machine has squeezed slot i: then it stays where it is until it is free again.
local function noteMachine(b, i)
  local isSqueezed = false
  for k = 2 * i, 2 * i + 1 do
    isSqueezed = isSqueezed or b.squeezed[k] ~= 0
    if b.squeezed[k] ~= 0 and isPressedByMachine(b, k) then
      b.tries[i] = CAUGHT
    end
  end
  if b.tries[i] == CAUGHT and not isSqueezed and b.waited[i] < PATIENCE then
    b.tries[i] = 0
  end
end

-- Counts for how long slot i has been in a knot with overlaps of `sum` px that does not come apart.
local function wait(b, i, sum)
  if b.deepAt[i] ~= b.solveStamp then
    b.waited[i] = max(b.waited[i] - b.dt, 0)
    b.tries[i] = b.waited[i] > 0 and b.tries[i] or 0
  elseif b.waited[i] == 0 or sum < b.knotLeast[i] * PROGRESS then
    b.waited[i], b.knotLeast[i] = b.dt, sum
  else
    b.waited[i] = min(b.waited[i] + b.dt, PATIENCE)
    if sum > GROWTH * b.knotLeast[i] or (b.tries[i] == CAUGHT and sum > b.knotLeast[i]) then
      b.knotLeast[i] = sum
    end
  end
end

-- Whether slot i may leave: it has not left often, no machine squeezes it, no body that overlaps it
-- leaves, and there is room. Notes if a machine beside it moves: then there may be room soon.
local function canLeave(b, i)
  b.isNearMachine = false
  if not findRoom(b, i) or b.tries[i] >= TRIES then
    return false
  end
  local half = b.head[i]
  while half ~= 0 do
    if b.exiting[b.other[half]] and gapOf(b, b.to, i, b.other[half]) < -EPSILON then
      return false
    end
    half = b.next[half]
  end
  return true
end

-- Lets bodies leave the knots that have waited: list[1..count]. Returns how many have not waited in
-- vain.
local function release(b, list, count)
  local knot, waits, rank, leavers = b.knot, b.knotWaits, b.rank, 0
  sort.by(list, count, rank, rank, rank)
  for n = 1, count do
    local i = list[n]
    if leavers < MOST and canLeave(b, i) then
      b.exiting[i], b.hasStuck, b.tries[i] = true, true, b.tries[i] + 1
      waits[leaderOf(knot, i)] = 0
      leavers = leavers + 1
    elseif b.isNearMachine then
      waits[leaderOf(knot, i)] = 0
    end
  end
  for n = 1, count do
    local i = list[n]
    b.waited[i] = 0
    if waits[leaderOf(knot, i)] >= PATIENCE then
      b.stuck[i], b.hasStuck, b.stuckWalls[i] = true, true, 0
      b.speed[2 * i], b.speed[2 * i + 1] = 0.0, 0.0
    end
  end
end

--- Finds at the end of the step what leaves a knot, and what is stuck.
function stuck.note(b)
  if b.overlapCount == 0 and not b.hasStuck then
    return
  end
  tie(b)
  local knot, waits = b.knot, b.knotWaits
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.kind[i] == DYNAMIC then
      local leader = leaderOf(knot, i)
      wait(b, i, b.knotSum[leader])
      if not b.stuck[i] then
        noteMachine(b, i)
      end
      if b.moved[i] then
        waits[leader] = -1
      elseif b.deepAt[i] == b.solveStamp and not b.stuck[i] then
        waits[leader] = min(waits[leader], b.waited[i])
      end
    end
  end
  local list, count = b.leavers, 0
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.deepAt[i] == b.solveStamp then
      local wait_ = waits[leaderOf(knot, i)]
      if b.stuck[i] and wait_ < 0 then
        free(b, i)
      elseif not b.stuck[i] and wait_ >= PATIENCE then
        count = count + 1
        list[count] = i
      end
    end
  end
  if count > 0 then
    release(b, list, count)
  end
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    b.news[i] = b.news[i] or b.exiting[i] or (b.deepAt[i] == b.solveStamp and not b.stuck[i])
  end
end

return stuck
