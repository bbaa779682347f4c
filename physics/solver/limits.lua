--- Limits: bounds at the end of a step where bodies have come to.
--
-- - What meets a circle after the last round stops.
-- - A body that overlaps others goes no further than its speed and a share of its size take it.
-- - A body that is not pushable stays on its own way.
--
-- Reads the paths, contacts, limitedAt, deflectedAt, nudgedAt; writes to, speed, accel, frozenAt,
-- limitedAt, news.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local knots = require(root .. ".solver.knots")
local path = require(root .. ".motion.path")
local rounds = require(root .. ".solver.rounds")
local walk = require(root .. ".memory.lazy")(root .. ".solver.walk")

local limits = {}

local DYNAMIC, EPSILON, PARTING = columns.DYNAMIC, columns.EPSILON, rounds.PARTING
local floor, max, min = math.floor, math.max, math.min
-- Rounds after the last round, in which what meets a circle only stops.
local FREEZES = 16
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

-- A circle that touches something, and has moved by no more than rounding, has not moved.
local function calm(b)
  for n = 1, 2 * b.roundCount do
    local p = b.roundPairs[floor((n + 1) * 0.5)]
    local i = n % 2 == 0 and b.pairA[p] or b.pairB[p]
    local k = 2 * i
    local x, y = b.to[k] - b.origin[k], b.to[k + 1] - b.origin[k + 1]
    local way = max(x, -x, y, -y)
    local speed = max(b.speed[k], -b.speed[k], b.speed[k + 1], -b.speed[k + 1])
    if b.give[k] > 0 and way <= CALM and speed <= CALM_SPEED then
      b.news[i] = b.news[i] or way > ROUNDING or speed > 0
      b.to[k], b.to[k + 1], b.speed[k], b.speed[k + 1] = b.origin[k], b.origin[k + 1], 0.0, 0.0
    elseif b.give[k] > 0 and b.down[k] + b.down[k + 1] ~= 0 then
      brake(b, i, k)
      brake(b, i, k + 1)
    end
  end
end

-- Takes back what body k, of slot i, has moved towards a contact, up to `over` px. `sign`: 1 if it
-- is the low one. Returns what is left of that.
local function takeBack(b, i, k, over, sign)
  local way = min(over, max((b.to[k] - b.from[k]) * sign, 0.0))
  if way == 0 or b.kind[i] ~= DYNAMIC then
    return over
  end
  b.to[k], b.speed[k], b.accel[k] = b.to[k] - sign * way, 0.0, 0.0
  b.frozenAt[i] = b.solveStamp
  path.change(b, i)
  return over - way
end

-- What leans on a stopped body does not go into it. Returns whether something has changed.
local function holdBack(b)
  local hasChanged, frozenAt, stamp = false, b.frozenAt, b.solveStamp
  for axis = 0, 1 do
    local list = b.contacts[axis]
    for c = 1, list.count do
      local kl, kh = list.low[c], list.high[c]
      local i, j = (kl - axis) * 0.5, (kh - axis) * 0.5
      local over = b.to[kl] + list.separation[c] - b.to[kh]
      if over > EPSILON and (frozenAt[i] == stamp or frozenAt[j] == stamp) then
        local left = takeBack(b, j, kh, takeBack(b, i, kl, over, 1), -1)
        hasChanged = hasChanged or left < over
      end
    end
  end
  return hasChanged
end

-- What still meets a circle stops there, and what meets that, or leans on it.
local function freeze(b, dt)
  for _ = 1, FREEZES do
    local isHeld = holdBack(b)
    b.isChangeListed = true
    rounds.followChanged(b)
    if not rounds.run(b, dt, true, true) and not isHeld then
      return
    end
  end
end

--- Bounds where bodies have come to.
function limits.run(b, dt, hasChanged)
  if b.hasCircles then
    if b.changedCount > 0 then
      freeze(b, dt)
      hasChanged = true
    end
    calm(b)
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
end

interpreted.functions(limits.run) -- leads from loop to loop

return limits
