--- Limits: bounds at the end of a step where bodies have come to.
--
-- - Balls of a heap are moved apart; what meets a circle after the last round stops.
-- - A body that overlaps others goes no further than its speed and a share of its size take it.
-- - A body that is not pushable stays on its own way.
-- - No bound puts a box into a wall.
--
-- Reads the paths, contacts, limitedAt, deflectedAt, nudgedAt, heapCount; writes to, speed,
-- limitedAt, news.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local filter = require(root .. ".broadphase.filter")
local heap = require(root .. ".memory.lazy")(root .. ".solver.heap")
local interpreted = require(root .. ".memory.jit")
local knots = require(root .. ".solver.knots")
local rounds = require(root .. ".solver.rounds")
local slope = require(root .. ".memory.lazy")(root .. ".solver.slope")
local walk = require(root .. ".memory.lazy")(root .. ".solver.walk")

local limits = {}

local DYNAMIC, EPSILON, PARTING = columns.DYNAMIC, columns.EPSILON, rounds.PARTING
local BOX, CIRCLE, STATIC = columns.SHAPE_BOX, columns.SHAPE_CIRCLE, columns.STATIC
local floor, max, min = math.floor, math.max, math.min
-- Rounds after the last round, in which what meets a circle only stops.
local FREEZES = 4
-- Number of these after which balls that still meet are moved apart again.
local HEAPS = 2
-- px and px/s: a circle that has moved by less has not moved.
local CALM, CALM_SPEED = EPSILON, 1e-3
-- px: so little changes by rounding, however long the step is.
local ROUNDING = 1e-9
-- px/s at which a circle that touches something brakes across gravity, by that share of its weight.
local CREEP, BRAKE = 2, 1 / 16

-- Returns the highest speed that body k had in this step.
local function fastestOf(b, k)
  local start, free, speed = b.start[k], b.freeSpeed[k], b.speed[k]
  return max(start, -start, free, -free, speed, -speed)
end

-- What touches a body that is limited is limited, too, on one side of a list of contacts.
local function spreadLimit(b, list, first, last, step)
  local limitedAt, kind, stamp = b.limitedAt, b.kind, b.solveStamp
  for c = first, last, step do
    local i, j = (list.low[c] - list.axis) * 0.5, (list.high[c] - list.axis) * 0.5
    if kind[i] == DYNAMIC and kind[j] == DYNAMIC then
      local latest = max(limitedAt[i], limitedAt[j])
      if latest == stamp then
        limitedAt[i], limitedAt[j] = stamp, stamp
      end
    end
  end
end

-- Limits the motion of the step, since pushes may add up where bodies overlap. A body ends no
-- further from its start than its fastest speed takes it, PARTING of its size, and its `nudge`.
-- What a slanted contact has deflected may have turned its speed from one axis to the other. (What
-- has nothing to do with an overlap is left out: whether there is one elsewhere depends on what
-- rests.)
local function limitMotion(b, dt)
  local list, give, origin, to, size = b.awakeList, b.give, b.origin, b.to, b.size
  local position = b.position
  for pass = 0, 3 do
    local its = b.contacts[pass % 2]
    spreadLimit(b, its, 1, its.count, 1)
    spreadLimit(b, its, its.count, 1, -1)
  end
  for n = 1, b.awakeCount do
    local i = list[n]
    for k = 2 * i, 2 * i + 1 do
      if give[k] > 0 and b.limitedAt[i] == b.solveStamp then
        local fastest = fastestOf(b, k)
        if b.deflectedAt[i] == b.solveStamp then
          fastest = max(fastest, fastestOf(b, 4 * i + 1 - k))
        end
        local most = fastest * dt + PARTING * size[k] + b.nudge[i]
        to[k] = max(min(to[k], origin[k] + most), origin[k] - most)
        local all = max(size[k], origin[k] - position[k], position[k] - origin[k]) + fastest * dt
        to[k] = max(min(to[k], position[k] + all), position[k] - all)
      end
    end
  end
end

-- Keeps the end of each body that is not pushable between its start and its own goal, across
-- gravity. A body that is pressed by something immovable directly, or by a machine, or was
-- deflected by a slanted contact or a nudge, is left out.
local function keepOwnWay(b, dt)
  local list, origin, to = b.awakeList, b.origin, b.to
  for n = 1, b.awakeCount do
    local i = list[n]
    for k = 2 * i, not b.pushable[i] and b.kind[i] == DYNAMIC and 2 * i + 1 or 0 do
      local isPressed = b.heldLow[k] == 2 or b.heldHigh[k] == 2 or knots.isDriven(b, k)
      local hasTurned = max(b.deflectedAt[i], b.nudgedAt[i]) == b.solveStamp
      if b.down[k] == 0 and not (isPressed or hasTurned) then
        local start, goal = origin[k], origin[k] + b.way[k] + b.carried[k] * dt
        to[k] = max(min(to[k], max(start, goal)), min(start, goal))
      end
    end
  end
end

-- Returns whether box i is inside j, a box or a slope, at these places.
local function isInside(b, places, i, j)
  if b.shape[j] == BOX then
    return columns.gap(b, places, i, j) < -EPSILON
  end
  local _, _, gap = slope.touch(b, i, j, places)
  return gap < -EPSILON
end

-- Returns whether box i ends inside a wall that it was not in before. (Circles are left to the
-- heap.)
local function getsIntoWall(b, i)
  local half = b.head[i]
  while half ~= 0 do
    local j = b.other[half]
    local isWall = b.kind[j] == STATIC and b.shape[j] ~= CIRCLE
    if isWall and isInside(b, b.to, i, j) and not isInside(b, b.position, i, j) then
      if filter.blocks(b, i, j) and not b.passing[floor(half * 0.5 + 0.5)] then
        return true
      end
    end
    half = b.next[half]
  end
  return false
end

-- Puts boxes back to where they began the step if a bound, or the ground after it, has put them
-- into a wall: they were not swept on that way. (What is squeezed may be in one.)
local function keepOut(b)
  local list, origin, to, swept = b.awakeList, b.origin, b.to, b.swept
  local squeezed = b.squeezed
  for n = 1, b.awakeCount do
    local i = list[n]
    local k = 2 * i
    local isSwept = to[k] == swept[k] and to[k + 1] == swept[k + 1]
    local isBox = b.kind[i] == DYNAMIC and b.shape[i] == BOX
    local isFree = squeezed[k] == 0 and squeezed[k + 1] == 0
    if not isSwept and isBox and isFree and getsIntoWall(b, i) then
      to[k], to[k + 1], b.news[i] = origin[k], origin[k + 1], true
    end
  end
end

-- Brakes body k of slot i across gravity if it is too slow to be seen, relative to what carries it:
-- nothing else in a heap of balls would.
local function brake(b, i, k)
  local carried, x, y = b.carried[k], b.pull[2 * i], b.pull[2 * i + 1]
  local speed = b.speed[k] - carried
  local isFree = b.down[k] == 0 and b.push[k] == 0
  if isFree and speed ~= 0 and max(speed, -speed) <= CREEP then
    local loss = BRAKE * max(x, -x, y, -y) * b.dt
    b.speed[k] = carried + max(speed - loss, 0.0) + min(speed + loss, 0.0)
    b.news[i] = true
  end
end

-- Returns how far body k has moved; 0 if it is held: then its place is that of what holds it,
-- however long the step is.
local function freeWay(b, k)
  local way = b.to[k] - b.origin[k]
  return b.heldLow[k] + b.heldHigh[k] > 0 and 0.0 or max(way, -way)
end

-- Slot i is a circle, or touches one. If it has moved by no more than rounding, it has not moved.
local function calm(b, i)
  local k = 2 * i
  local x, y = b.to[k] - b.origin[k], b.to[k + 1] - b.origin[k + 1]
  local way = max(x, -x, y, -y)
  local speed = max(b.speed[k], -b.speed[k], b.speed[k + 1], -b.speed[k + 1])
  if way <= CALM and speed <= CALM_SPEED then
    b.news[i] = b.news[i] or max(freeWay(b, k), freeWay(b, k + 1)) > ROUNDING or speed > 0
    b.to[k], b.to[k + 1], b.speed[k], b.speed[k + 1] = b.origin[k], b.origin[k + 1], 0.0, 0.0
  elseif b.down[k] + b.down[k + 1] ~= 0 then
    brake(b, i, k)
    brake(b, i, k + 1)
  end
end

-- Does this for all of them. A pair that has ended in the step has no bodies any more: slot 0.
local function calmAll(b)
  for n = 1, 2 * b.roundCount do
    local p = b.roundPairs[floor((n + 1) * 0.5)]
    local i = n % 2 == 0 and b.pairA[p] or b.pairB[p]
    if i > 0 and b.give[2 * i] > 0 then
      calm(b, i)
    end
  end
end

-- What still meets a circle stops there, or is moved apart with its heap.
local function freeze(b, dt)
  for n = 1, FREEZES do
    local count = b.heapCount
    b.isChangeListed = true
    rounds.followChanged(b)
    contacts.noteNew(b)
    local hasMet = rounds.run(b, dt, true, true)
    if b.heapCount > count and n <= HEAPS then
      heap.run(b, dt)
    elseif not hasMet then
      return
    end
  end
end

--- Bounds where bodies have come to.
function limits.run(b, dt, hasChanged)
  if b.hasCircles then
    if b.heapCount > 0 then
      heap.run(b, dt)
    end
    if b.changedCount > 0 then
      freeze(b, dt)
      hasChanged = true
    end
    calmAll(b)
  end
  if b.overlapCount > 0 then
    limitMotion(b, dt)
  end
  if b.hasFirm then
    keepOwnWay(b, dt)
  end
  if b.hasSlopes and hasChanged then
    walk.run(b, dt, false)
  end
  if hasChanged or b.heapCount > 0 then
    keepOut(b)
  end
end

interpreted.functions(limits.run) -- leads from loop to loop

return limits
