--- Knots: bodies that overlap and do not come apart look for room elsewhere, or stand still.
--
-- Dynamic bodies that overlap, directly or through others, are a *knot*. While the sum of its
-- overlaps falls, a knot is left to the solver. If the sum has not fallen for PATIENCE s, some of
-- its bodies *exit*: each goes to the nearest free place along an axis that no wall is in front of,
-- and passes through other bodies on its way. If no body of the knot finds such a place, the knot
-- is *stuck*: its bodies do not move and cannot be pushed, like walls. So a heap without room comes
-- to rest.
--
-- A stuck knot begins anew
--
-- - when the game writes one of its bodies, or puts a body into it,
-- - when a wall that touches it goes away, or a machine (a kinematic object) there moves,
-- - when a stuck knot that touches it begins anew.
--
-- What a machine has squeezed does not exit: it stays between the two that squeeze it.
--
-- Reads contacts, deepIn, deepAt, squeezed, to; writes stuck, exiting, knotted, knotWas, from, to,
-- speed and news.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local begin = require(root .. ".motion.begin")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")
local jam = require(root .. ".solver.jam")
local pairFinder = require(root .. ".broadphase.pairFinder")
local sort = require(root .. ".memory.sort")

require(root .. ".memory.jit").file()

local knots = {}

local DYNAMIC, KINEMATIC, EPSILON = columns.DYNAMIC, columns.KINEMATIC, columns.EPSILON
local CIRCLE, gapOf = columns.SHAPE_CIRCLE, columns.gap
local floor, huge, max, min = math.floor, math.huge, math.max, math.min
--- s for which the overlaps of a knot may stay as they are.
knots.PATIENCE = 0.2
local PATIENCE = knots.PATIENCE
-- The overlaps fall if their sum comes to this share of what it was.
local PROGRESS = 0.95
-- A sum of less px is not seen, and is left as it is.
local UNSEEN = 0.01
-- A sum that has grown so many times replaces what it was.
local GROWTH = 2
-- Share of a second by which a body that overlaps no other has waited less after a second.
local RECOVERY = 0.25
-- How often a body waits for PATIENCE in vain before it no longer exits. (If nothing in its knot
-- exits, and no machine is near, it is stuck after the first time.)
local TRIES = 3
-- What is known of a knot in a step: nothing; the game has put a body into it; a body of it exits,
-- or may have room soon.
local CALM, DISTURBED, HOPEFUL = 0, 1, 2
-- The number of tries of a body that a machine squeezes.
local CAUGHT = TRIES + 1
-- Bodies that begin to exit in a step, at most.
local MOST = 24
-- How far away a body looks for room, and how far it goes in a step: in sizes along the axis.
local REACH, PACE = 16, 0.25

-- Whether slot j is a machine that moves in this step.
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

-- Returns how many walls and stuck bodies slot i touches, in a jam how many bodies, and whether a
-- machine there moves.
local function countWalls(b, i)
  local half, count, moves, isJammed = b.head[i], 0, false, b.jam[2 * i] > 0
  while half ~= 0 do
    local j = b.other[half]
    local isWall = isJammed or b.kind[j] ~= DYNAMIC or b.stuck[j]
    if isWall and not b.sensor[j] and gapOf(b, b.from, i, j) <= EPSILON then
      count, moves = count + 1, moves or isMachine(b, j)
    end
    half = b.next[half]
  end
  return count, moves
end

--- Lets the stuck slot i begin anew, and the stuck bodies that it touches, directly or through
--- others; in a jam also through those that are not stuck.
function knots.free(b, i)
  local stack, count, isJam = b.stack, 1, b.jam[2 * i] > 0
  b.stamp = b.stamp + 1
  stack[1], b.visited[i] = i, b.stamp
  while count > 0 do
    i, count = stack[count], count - 1
    b.stuck[i] = false
    b.knotted[2 * i], b.knotted[2 * i + 1], b.jam[2 * i] = 0, 0, 0
    local half = b.head[i]
    while half ~= 0 do
      local j = b.other[half]
      local isNext = (b.stuck[j] or isJam and b.kind[j] == DYNAMIC) and not b.exiting[j]
      if isNext and b.visited[j] ~= b.stamp and gapOf(b, b.from, i, j) <= EPSILON then
        b.visited[j] = b.stamp
        count = count + 1
        stack[count] = j
      end
      half = b.next[half]
    end
  end
end

-- Frees the stuck bodies that may have room now. A jam of which a neighbour has gone is loosened
-- body by body, as each of them moves.
local function freeSome(b)
  local list, count, loose, looseCount = b.knotList, 0, b.looseList, 0
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.stuck[i] and not b.exiting[i] then
      local walls, moves = countWalls(b, i)
      local isWritten = b.moved[i] or b.velocity[2 * i] ~= 0 or b.velocity[2 * i + 1] ~= 0
      local isLeft, isJam = walls < b.knotWas[2 * i + 1], b.jam[2 * i] > 0
      if moves or isWritten or (isLeft and not isJam) or jam.isPressed(b, i) then
        count = count + 1
        list[count] = i
      elseif isLeft then
        looseCount = looseCount + 1
        loose[looseCount] = i
      end
      b.news[i] = b.news[i] or walls ~= b.knotWas[2 * i + 1]
      b.knotWas[2 * i + 1] = walls
    end
  end
  for n = 1, count do
    knots.free(b, list[n])
  end
  for n = 1, looseCount do
    b.stuck[loose[n]] = false
    jam.forget(b, loose[n])
  end
end

-- Whether slot i, when it goes along an axis, slides along the wall j and not into it.
local function slidesAlong(b, i, j, axis)
  local from, size, k, m = b.from, b.size, 2 * i, 2 * j
  local x = min(from[k] + size[k], from[m] + size[m]) - max(from[k], from[m])
  local y = min(from[k + 1] + size[k + 1], from[m + 1] + size[m + 1])
    - max(from[k + 1], from[m + 1])
  return x > 0 and y > 0 and ((axis == 0 and y < x) or (axis == 1 and x < y))
end

-- Lists in b.found the bodies on the line through slot i along an axis. Returns how many there are,
-- the least and the greatest coordinate between the walls on that line, and whether one of these
-- walls moves.
local function listOnLine(b, i, axis)
  local from, size, found, k, c = b.from, b.size, b.found, 2 * i + axis, 2 * i + 1 - axis
  local low, high = from[k] - REACH * size[k], from[k] + (REACH + 1) * size[k]
  local near, far = from[c] + EPSILON, from[c] + size[c] - EPSILON
  local first, last, count, isNearMachine = low, high, 0, false
  local total = axis == 0 and b.broadphase:query(low, near, high, far, found)
    or b.broadphase:query(near, low, far, high, found)
  for n = 1, total do
    local j = found[n]
    local m, d = 2 * j + axis, 2 * j + 1 - axis
    local isPassed = j == i or b.sensor[j] or b.oneWay[j] or not filter.allows(b, i, j)
    local isBeside = from[d] >= far or from[d] + size[d] <= near
    local isBeyond = from[m] >= last or from[m] + size[m] <= first -- but in one cell of the grid
    if not (isPassed or isBeside or isBeyond) then
      if b.kind[j] == DYNAMIC then
        count = count + 1
        found[count] = j
      elseif not slidesAlong(b, i, j, axis) then
        isNearMachine = isNearMachine or isMachine(b, j)
        if 2 * from[m] + size[m] < 2 * from[k] + size[k] then
          low = max(low, from[m] + size[m])
        else
          high = min(high, from[m])
        end
      end
    end
  end
  return count, low, high - size[k], isNearMachine
end

-- Returns the nearest place for slot i towards `sign` along an axis at which it overlaps none of
-- found[1..count].
local function nearestFree(b, i, axis, sign, count)
  local from, size, found, k = b.from, b.size, b.found, 2 * i + axis
  local place = from[k]
  repeat
    local before = place
    for n = 1, count do
      local m = 2 * found[n] + axis
      if before + size[k] > from[m] + EPSILON and before < from[m] + size[m] - EPSILON then
        place = sign > 0 and max(place, from[m] + size[m]) or min(place, from[m] - size[k])
      end
    end
  until place == before
  return place
end

-- Returns the axis on which slot i has the nearest free place, that place, and how far away it is;
-- nil: there is none. Returns last whether a machine near it moves.
local function findRoom(b, i)
  local bestAxis ---@type integer?
  local bestPlace, bestWay, isNearMachine = 0, huge, false
  for n = 0, 1 do
    local axis = n == 0 and b.downAxis or 1 - b.downAxis
    local count, low, high, isNear = listOnLine(b, i, axis)
    isNearMachine = isNearMachine or isNear
    for sign = -1, 1, 2 do
      local place = nearestFree(b, i, axis, sign, count)
      local way = max(place - b.from[2 * i + axis], b.from[2 * i + axis] - place)
      if place >= low and place <= high and way < bestWay - EPSILON then
        bestAxis, bestPlace, bestWay = axis, place, way
      end
    end
  end
  return bestAxis, bestPlace, bestWay, isNearMachine
end

-- Moves the exiting slot i towards the nearest free place. It is there when it overlaps no body.
local function exit(b, i)
  local axis, place, way = findRoom(b, i)
  local _, isPushed = countWalls(b, i)
  if not axis or way <= EPSILON or isPushed then
    b.stuck[i], b.exiting[i], b.knotted[2 * i] = false, false, 0
    return
  end
  local k = 2 * i + axis
  local step = PACE * b.size[k]
  b.from[k] = max(min(place, b.from[k] + step), b.from[k] - step)
  b.to[k] = b.from[k]
  islands.wakeNeighbours(b, i)
end

--- Frees the stuck bodies that may have room now, and moves those that exit.
function knots.run(b)
  if not b.hasKnots then
    return
  end
  freeSome(b)
  local list, count, rank = b.knotList, 0, b.rank
  for n = 1, b.awakeCount do
    if b.exiting[b.awakeList[n]] then
      count = count + 1
      list[count] = b.awakeList[n]
    end
  end
  if count > 0 then
    sort.by(list, count, rank, rank, rank)
    for n = 1, count do
      exit(b, list[n])
      pairFinder.run(b, list, n, n) -- the next one looks where this one is now
    end
    begin.run(b)
  end
end

-- Returns the slot that leads the knot of slot i.
local function leaderOf(knot, i)
  while knot[i] ~= i do
    i = knot[i]
  end
  return i
end

-- Makes one knot of the knots of slots i and j; returns the slot that leads it.
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

-- Ties the bodies that overlap into knots, and sums the overlaps of each.
local function tie(b)
  local knot, sum, states = b.knot, b.knotSum, b.knotStates
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    knot[i], sum[i], states[i] = i, 0.0, CALM
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

--- Returns whether a machine presses body k, directly or through others, by moving towards it.
function knots.isDriven(b, k)
  local low, high = b.holderLow[k], b.holderHigh[k]
  return (b.heldLow[k] > 0 and b.kind[floor(low * 0.5)] == KINEMATIC and b.speed[low] > 0)
    or (b.heldHigh[k] > 0 and b.kind[floor(high * 0.5)] == KINEMATIC and b.speed[high] < 0)
end

-- Returns what a body has waited and tried after a step of dt s without an overlap. Below
-- 0 it is the time since then; after PATIENCE all is forgotten.
local function recover(waited, tries, dt)
  if waited == 0 and tries == 0 then
    return 0, 0
  elseif waited > 0 then
    return max(waited - dt * RECOVERY, 0), tries
  elseif waited - dt > -PATIENCE then
    return waited - dt, tries
  end
  return 0, 0
end

-- Counts for how long slot i has been in a knot of which the overlaps, `sum` px, do not fall.
local function wait(b, i, sum)
  local knotted, was, k = b.knotted, b.knotWas, 2 * i
  local waited, tries = knotted[k], knotted[k + 1]
  local isDeep = b.deepAt[i] == b.solveStamp
  local isSqueezed, isPressed = b.squeezed[k] ~= 0 or b.squeezed[k + 1] ~= 0, false
  -- What begins to be squeezed in this step is not looked at yet, as if there were no other knot.
  local isKnown = isDeep or waited ~= 0 or tries ~= 0
  for m = k, isSqueezed and isKnown and k + 1 or 0 do
    isPressed = isPressed or (b.squeezed[m] ~= 0 and knots.isDriven(b, m))
  end
  if not isDeep or sum < UNSEEN then
    waited, tries = recover(waited, tries, b.dt)
  elseif waited <= 0 or sum < was[k] * PROGRESS then
    waited, was[k] = b.dt, sum
  else
    waited = min(waited + b.dt, PATIENCE)
    was[k] = (isPressed or sum > GROWTH * was[k]) and max(sum, was[k]) or was[k]
  end
  if isPressed then
    tries = CAUGHT
  elseif tries == CAUGHT and not isSqueezed and waited < PATIENCE then
    tries = 0
  end
  b.news[i] = b.news[i] or waited ~= knotted[k] -- how far two part depends on it
  knotted[k], knotted[k + 1] = waited, tries
end

-- Whether a body that overlaps slot i exits.
local function isBesideExit(b, i)
  local half = b.head[i]
  while half ~= 0 do
    if b.exiting[b.other[half]] and gapOf(b, b.to, i, b.other[half]) < -EPSILON then
      return true
    end
    half = b.next[half]
  end
  return false
end

-- Returns whether slot i may exit: it has not done so often, no machine squeezes it, no body exits
-- that overlaps it, and there is room. Returns also whether a machine near it moves.
local function canExit(b, i)
  local axis, _, _, isNearMachine = findRoom(b, i)
  local isOpen = axis ~= nil and b.knotted[2 * i + 1] < TRIES
  return isOpen and not isBesideExit(b, i), isNearMachine
end

-- Lets bodies of list[1..count], which have waited for long, exit. The others are stuck, unless a
-- body of their knot exits and they have not tried often, or a machine near them moves: then there
-- may be room soon.
local function decide(b, list, count)
  local knot, states, knotted, rank, exits = b.knot, b.knotStates, b.knotted, b.rank, 0
  sort.by(list, count, rank, rank, rank)
  for n = 1, count do
    local i = list[n]
    local isExit, isNearMachine = false, false
    if exits < MOST then
      isExit, isNearMachine = canExit(b, i)
    end
    if isExit then
      b.stuck[i], b.exiting[i], exits = true, true, exits + 1
      states[leaderOf(knot, i)] = HOPEFUL
    elseif isNearMachine then
      states[leaderOf(knot, i)] = HOPEFUL
      knotted[2 * i] = 0
    end
  end
  for n = 1, count do
    local i = list[n]
    local tries = knotted[2 * i + 1]
    local isHopeful = states[leaderOf(knot, i)] == HOPEFUL and tries < TRIES
    if not (b.exiting[i] or isHopeful) and knotted[2 * i] > 0 then
      b.stuck[i], b.knotWas[2 * i + 1] = true, 0
      b.speed[2 * i], b.speed[2 * i + 1], b.news[i] = 0.0, 0.0, true
    end
    knotted[2 * i], knotted[2 * i + 1] = 0, tries < TRIES and tries + 1 or tries
  end
end

-- Whether an awake body is in a knot, or was in one shortly before.
local function hasKnots(b)
  if b.overlapCount > 0 then
    return true
  end
  for n = 1, b.hasKnots and b.awakeCount or 0 do
    local i = b.awakeList[n]
    if b.knotted[2 * i] ~= 0 or b.knotted[2 * i + 1] ~= 0 or b.stuck[i] then
      return true
    end
  end
  return false
end

-- Counts how long all bodies have waited, and marks the knots that the game has put a body into.
local function waitAll(b)
  local knot, states = b.knot, b.knotStates
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.kind[i] == DYNAMIC and not b.stuck[i] then
      local leader = leaderOf(knot, i)
      wait(b, i, b.knotSum[leader])
      states[leader] = b.moved[i] and DISTURBED or states[leader]
    end
  end
end

-- Whether slot i has waited for long, and is a box.
local function isLate(b, i)
  return b.knotted[2 * i] >= PATIENCE and b.shape[i] ~= CIRCLE
end

-- Whether slot i is a ball that has waited for long. Balls neither exit nor get stuck: two without
-- room stay a little inside each other, and can be pushed.
local function isSettledBall(b, i)
  return b.knotted[2 * i] >= PATIENCE and b.shape[i] == CIRCLE
end

--- Decides at the end of a step which bodies exit, and which are stuck.
function knots.note(b)
  jam.note(b)
  if not hasKnots(b) then
    return
  end
  b.hasKnots = true
  tie(b)
  waitAll(b)
  local knot, states, list, count = b.knot, b.knotStates, b.knotList, 0
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.deepAt[i] == b.solveStamp then
      local isDisturbed = states[leaderOf(knot, i)] == DISTURBED
      if b.stuck[i] and isDisturbed then
        knots.free(b, i)
      elseif isLate(b, i) and not (b.stuck[i] or isDisturbed) then
        count = count + 1
        list[count] = i
      end
    end
  end
  if count > 0 then
    decide(b, list, count)
  end
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    local isDeep = b.deepAt[i] == b.solveStamp and b.knotSum[leaderOf(knot, i)] >= UNSEEN
    local isKnotted = b.knotted[2 * i] ~= 0 or b.knotted[2 * i + 1] ~= 0
    local isStill = b.stuck[i] or isSettledBall(b, i)
    local isBusy = b.exiting[i] or (isDeep or isKnotted) and not isStill
    b.news[i] = b.news[i] or isBusy
  end
end

return knots
