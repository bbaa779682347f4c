--- Heaps without room: bodies that overlap and do not come apart stand still until there may be
--- room.
--
-- Bodies that overlap, directly or through others, are a *knot*. While the sum of the overlaps of a
-- knot falls, it is left to the solver. A knot that has not fallen for STEPS steps is *stuck*: its
-- bodies do not move and cannot be pushed, as if they were walls. It begins anew when one of them
-- is written by the game or gets into another knot, when a wall beside them goes or moves, or when
-- a knot beside it begins anew. So a heap without room comes to rest.
--
-- Reads contacts, deepIn, to; writes stuck, stuckFor, knotLeast.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")

require(root .. ".memory.jit").file()

local stuck = {}

local DYNAMIC, STATIC, EPSILON = columns.DYNAMIC, columns.STATIC, columns.EPSILON
local max, min = math.max, math.min
local TIME = tonumber(os.getenv("TIME") or 0.65)
-- A knot comes apart if the sum of its overlaps falls to this share of what it was.
local PROGRESS = tonumber(os.getenv("PROGRESS") or 0.95)

-- px between slots i and j, below 0: they overlap.
local function gapOf(b, place, i, j)
  local size, k, m = b.size, 2 * i, 2 * j
  local x, y = place[m] - place[k], place[m + 1] - place[k + 1]
  return max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1])
end

-- Whether slot j, which is not dynamic, moves in this step.
local function isMoving(b, j)
  local k = 2 * j
  return b.kind[j] ~= STATIC
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
      count, moves = count + 1, moves or isMoving(b, j) and b.kind[j] ~= DYNAMIC
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
    b.stuckFor[i], b.jam[2 * i], b.jam[2 * i + 1] = 0, 0, 0
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

--- Frees what may have room now.
function stuck.free(b)
  for n = 1, b.hasStuck and b.awakeCount or 0 do
    local i = b.awakeList[n]
    if b.stuck[i] then
      local walls, moves = countWalls(b, i)
      if
        moves
        or b.moved[i]
        or walls < b.stuckWalls[i]
        or b.velocity[2 * i] ~= 0
        or b.velocity[2 * i + 1] ~= 0
      then
        free(b, i)
      end
      b.stuckWalls[i] = walls
    end
  end
end

local function leaderOf(knot, i)
  while knot[i] ~= i do
    i = knot[i]
  end
  return i
end

-- Ties the bodies that overlap into knots; sums their overlaps.
local function tie(b)
  local knot, sum = b.knot, b.knotSum
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    knot[i], sum[i] = i, 0.0
  end
  for axis = 0, 1 do
    local list = b.contacts[axis]
    for c = 1, list.count do
      local p = list.pair[c]
      if b.deepIn[p] == b.solveStamp then
        local i, j = b.pairA[p], b.pairB[p]
        local one, two = leaderOf(knot, i), leaderOf(knot, j)
        if b.rank[two] < b.rank[one] then
          local first = two
          two = one
          one = first
        end
        if one ~= two then
          knot[two], sum[one] = one, sum[one] + sum[two]
        end
        sum[one] = sum[one] + max(-gapOf(b, b.to, i, j), 0)
      end
    end
  end
end

-- Counts for how many steps slot i has been in a knot that does not come apart, of which the
-- overlaps sum up to `sum`.
local function count(b, i, sum, dt)
  if b.deepAt[i] ~= b.solveStamp then
    b.stuckFor[i] = max(b.stuckFor[i] - dt, 0)
  elseif b.stuckFor[i] == 0 or sum < b.knotLeast[i] * PROGRESS then
    b.stuckFor[i], b.knotLeast[i] = dt, sum
  else
    b.stuckFor[i] = min(b.stuckFor[i] + dt, TIME)
  end
end

--- Finds what is stuck at the end of the step.
function stuck.note(b)
  if b.overlapCount == 0 and not b.hasStuck then
    return
  end
  tie(b)
  local knot, least = b.knot, b.knotWaits
  for n = 1, b.awakeCount do
    least[b.awakeList[n]] = TIME
  end
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.kind[i] == DYNAMIC then
      local leader = leaderOf(knot, i)
      count(b, i, b.knotSum[leader], b.dt)
      if b.moved[i] then
        least[leader] = -1
      elseif b.deepAt[i] == b.solveStamp and not b.stuck[i] then
        least[leader] = min(least[leader], b.stuckFor[i])
      end
    end
  end
  for n = 1, b.awakeCount do
    local i = b.awakeList[n]
    if b.deepAt[i] == b.solveStamp then
      local isStuck = least[leaderOf(knot, i)] >= TIME
      if isStuck and not b.stuck[i] then
        b.stuck[i], b.hasStuck, b.stuckWalls[i] = true, true, 0
        b.speed[2 * i], b.speed[2 * i + 1] = 0.0, 0.0
      elseif b.stuck[i] and least[leaderOf(knot, i)] < 0 then
        free(b, i)
      end
      b.news[i] = b.news[i] or not b.stuck[i]
    end
  end
end

return stuck
