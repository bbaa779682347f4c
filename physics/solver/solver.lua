--- The solver: computes where each body ends a step, and how fast, from its path of free flight and
-- from what it touches or meets.
--
-- The stages are in `solve`:
-- 1. Settle contacts that exist at the start, with their friction (`settleTouching`).
-- 2. Correct corners (`nudgeTouching`).
-- 3. Rounds: sweep, let the first impacts happen (`round`), settle again (`settleLate`).
-- 4. Limit the motion of overlapping bodies, note what is pressed and what is crushed.
--
-- A step is bounded. It has at most ROUNDS rounds, in each of which a body takes part in one
-- impact. Each round makes a fixed number of passes over the contacts. What cannot be finished
-- goes on in the next step.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".solver.ball")
local bonds = require(root .. ".solver.bonds")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local crowd = require(root .. ".solver.crowd")
local crush = require(root .. ".solver.crush")
local drift = require(root .. ".motion.drift")
local friction = require(root .. ".solver.friction")
local impact = require(root .. ".solver.impact")
local interpreted = require(root .. ".memory.jit")
local jam = require(root .. ".solver.jam")
local knots = require(root .. ".solver.knots")
local live = require(root .. ".broadphase.activePairs")
local nudge = require(root .. ".solver.nudge")
local pairFinder = require(root .. ".broadphase.pairFinder")
local path = require(root .. ".motion.path")
local predict = require(root .. ".motion.predict")
local rest = require(root .. ".sleep.islands")
local rules = require(root .. ".solver.rules")
local settle = require(root .. ".solver.settle")
local snap = require(root .. ".memory.lazy")(root .. ".solver.snap")
local sort = require(root .. ".memory.sort")
local sweep = require(root .. ".solver.sweep")
local walk = require(root .. ".solver.walk")

local solver = {}

local DYNAMIC, EPSILON = columns.DYNAMIC, columns.EPSILON
local floor, max, min = math.floor, math.max, math.min

--- Maximum number of rounds (sweep, impacts, settle) in a step.
solver.ROUNDS = 18
local ROUNDS = solver.ROUNDS
--- Share of its size by which separating overlaps may move a body in a step, along each axis.
solver.PARTING = 0.25
local PARTING = solver.PARTING
-- Maximum number of impacts in a step of a body that overlaps others and has no room.
local SPENT = 2
-- Number of last rounds in which nothing bounces, so that the remaining contacts settle.
local LATE = 5
-- Rounds after these in which what meets a circle only stops.
local FREEZES = 16
-- px and px/s by which a circle has not moved.
local CALM, CALM_SPEED = EPSILON, 1e-3
-- px: so little changes by rounding, however long the step is.
local ROUNDING = 1e-9
-- px/s at which a circle that touches something brakes across gravity, by that share of its weight.
local CREEP, BRAKE = 1, 1 / 16
-- Maximum number of restarts of a step because a path came near a sleeping body. After these, all
-- bodies are woken.
local RESTARTS = 8
-- Maximum number of bodies in `b.bounced`, the list that later impacts of a round are compared
-- with.
local BOUNCED = 256
-- px by which a path is widened for that comparison.
local NEAR = 24
-- Impacts are simultaneous if their times, rounded to 1 / MOMENTS of a step, are equal.
local MOMENTS = 1e9
local WIDTHS = columns.WIDTHS

--- Creates the lists that the solver needs in the columns of a world.
function solver.adopt(b)
  b.contacts = { [0] = contacts.newList(0), contacts.newList(1) }
  b.bonds = { [0] = bonds.new(), bonds.new() }
  b.impacts = sweep.newImpacts()
end

-- Returns the velocity of body k at the start of the step, its carrier included.
local function startSpeed(b, k)
  return max(min(b.velocity[k], b.fastest[k]), b.slowest[k]) + b.carried[k]
end

-- Resets the solver's columns of all awake bodies to free flight, before any contact acts.
local function begin(b, dt)
  if b.crowdCount > 0 then
    crowd.hold(b)
  end
  local list, kind, buried, stuck, give = b.awakeList, b.kind, b.buried, b.stuck, b.give
  local freeSpeed, start, speed = b.freeSpeed, b.start, b.speed
  local from, origin, inverseMass, dirty = b.from, b.origin, b.inverseMass, b.dirty
  local accel = b.accel
  for n = 1, b.awakeCount do
    local i = list[n]
    dirty[i], b.impactsOf[i] = 1, 0
    for k = 2 * i, 2 * i + 1 do
      origin[k] = from[k]
      give[k] = kind[i] == DYNAMIC and not (buried[i] or stuck[i]) and inverseMass[i] or 0
      freeSpeed[k] = speed[k]
      if kind[i] == DYNAMIC then
        start[k] = startSpeed(b, k)
        accel[k] = (freeSpeed[k] - start[k]) / dt
      else
        start[k] = speed[k]
      end
    end
  end
  if b.drifts.driftedCount > 0 then
    drift.start(b, dt)
  end
end

-- Returns the body that leans on the other one in contact c.
local function leaning(b, list, c)
  return b.heldHigh[list.high[c]] > 0 and list.low[c] or list.high[c]
end

-- Returns whether contact c did not exist in the last step, was not hit in this one, and is flush.
local function isNew(b, list, c)
  local p = list.pair[c]
  local over = b.to[list.low[c]] + list.separation[c] - b.to[list.high[c]]
  return b.hit[p] == 0 and b.contact[p] == 0 and over <= EPSILON and over >= -EPSILON
end

-- Returns the length of the common edge of contact c, in parts of a px, and a rank that decides
-- between equal edges.
local function edgeOf(b, list, c)
  local k, m = list.low[c] + 1 - 2 * list.axis, list.high[c] + 1 - 2 * list.axis
  local edge = min(b.from[k] + b.size[k], b.from[m] + b.size[m]) - max(b.from[k], b.from[m])
  local i, j = (k - 1 + list.axis) * 0.5, (m - 1 + list.axis) * 0.5
  return floor(edge * WIDTHS + 0.5), b.rank[i] + b.rank[j]
end

-- Finds for each body the new contact with the widest common edge among those that it leans on. If
-- several begin at once, only that one counts as hit.
local function findWidest(b, list)
  local widest, awake = b.widest, b.awakeList
  for n = 1, b.awakeCount do
    widest[2 * awake[n] + list.axis] = 0
  end
  for c = 1, list.count do
    if isNew(b, list, c) then
      local k = leaning(b, list, c)
      local best = widest[k]
      local edge, rank = edgeOf(b, list, c)
      local most, first = 0, 0
      if best ~= 0 then
        most, first = edgeOf(b, list, best)
      end
      if best == 0 or edge > most or (edge == most and rank < first) then
        widest[k] = c
      end
    end
  end
end

-- Notes the hit of each contact in which two bodies begin to lean on each other.
local function noteNewHits(b, list)
  findWidest(b, list)
  for c = 1, list.count do
    local p = list.pair[c]
    if b.pressed[p] == 1 and b.hit[p] == 0 and b.contact[p] == 0 then
      local hit = isNew(b, list, c) and b.widest[leaning(b, list, c)] or c
      local kl, kh = list.low[hit], list.high[hit]
      local low, axis = (kl - list.axis) * 0.5, list.axis
      impact.note(b, list.pair[hit], low, axis, max(b.start[kl] - b.start[kh], 0.0), 0)
    end
  end
end

-- Notes the sides on which bodies lean on each other, and the hits of contacts that begin so.
local function notePressed(b, axis)
  local list, pressed = b.contacts[axis], b.pressed
  local pressedHigh, pressedLow, hasNew = b.pressedHigh, b.pressedLow, false
  for c = 1, list.count do
    local p = list.pair[c]
    if pressed[p] == 1 then
      pressedHigh[list.low[c]], pressedLow[list.high[c]] = true, true
      if b.hit[p] == 0 then
        b.resolved = b.resolved + 1
        hasNew = hasNew or b.contact[p] == 0
      end
    end
  end
  if hasNew then
    noteNewHits(b, list)
  end
end

local function forgetPressed(b)
  for axis = 0, 1 do
    local list = b.contacts[axis]
    for c = 1, list.count do
      b.pressed[list.pair[c]] = 0
    end
  end
end

-- Settles what touches at the start of the step: first along gravity, then across it, each followed
-- by its friction.
local function settleTouching(b, dt)
  contacts.find(b)
  forgetPressed(b)
  local down, across = b.downAxis, 1 - b.downAxis
  settle.axis(b, down, dt, false)
  if not b.hasFriction then
    settle.axis(b, across, dt, false)
  else
    if not friction.run(b, down, dt) then
      settle.axis(b, across, dt, false)
    end
    friction.run(b, across, dt)
  end
end

-- Nudges bodies that are pressed against a corner, and settles again from their new places.
local function nudgeTouching(b, dt)
  for _ = 1, nudge.MOST do
    if not nudge.run(b) then
      return
    end
    pairFinder.run(b, b.awakeList, 1, b.awakeCount)
    for n = 1, b.awakeCount do
      for k = 2 * b.awakeList[n], 2 * b.awakeList[n] + 1 do
        b.start[k] = startSpeed(b, k)
      end
    end
    friction.begin(b)
    friction.reset(b, 0, dt)
    friction.reset(b, 1, dt)
    settleTouching(b, dt)
  end
end

-- Marks bodies with another path than the one that was swept last, and looks up their neighbours.
local function findChanged(b)
  local list, to, swept, dirty = b.awakeList, b.to, b.swept, b.dirty
  for n = 1, b.awakeCount do
    local i = list[n]
    local k = 2 * i
    if to[k] ~= swept[k] or to[k + 1] ~= swept[k + 1] then
      dirty[i] = 1
      swept[k], swept[k + 1] = to[k], to[k + 1]
    end
  end
  pairFinder.run(b, list, 1, b.awakeCount)
end

-- Does the same for the bodies in b.changed, which were in impacts and are marked already.
local function followChanged(b)
  local list, to, swept = b.changed, b.to, b.swept
  for n = 1, b.changedCount do
    local k = 2 * list[n]
    swept[k], swept[k + 1] = to[k], to[k + 1]
  end
  pairFinder.run(b, list, 1, b.changedCount)
end

-- Notes that the path of a dynamic body has changed.
local function change(b, i)
  if b.kind[i] == DYNAMIC and b.dirty[i] == 0 then
    b.dirty[i], b.changedCount = 1, b.changedCount + 1
    b.changed[b.changedCount] = i
  end
end

-- Sorts the impacts by moment, solids before sensors, then the wider common edge first, then by the
-- order of the world.
local function sortImpacts(b)
  local impacts = b.impacts
  for n = 1, impacts.count do
    local i, j, axis = impacts.low[n], impacts.high[n], impacts.axis[n]
    local isSensed = b.sensor[i] or b.sensor[j]
    impacts.order[n] = n
    impacts.moment[n] = floor(impacts.time[n] * MOMENTS + 0.5) + (isSensed and 4 or 0)
    local k, m = 2 * i + 1 - axis, 2 * j + 1 - axis
    local width = min(b.from[k] + b.size[k], b.from[m] + b.size[m]) - max(b.from[k], b.from[m])
    impacts.width[n] = -floor(width * WIDTHS + 0.5)
    impacts.first[n], impacts.second[n] = columns.ranks(b, i, j)
  end
  sort.by(
    impacts.order,
    impacts.count,
    impacts.moment,
    impacts.width,
    impacts.first,
    impacts.second
  )
end

-- Notes the hit of a sensor that a body enters or passes through.
local function sense(b, p, i, j, axis, t, dt)
  if b.hasCircles and ball.isRound(b, i, j) then
    impact.note(b, p, i, axis, ball.approach(b, i, j, t, dt), t)
    return
  end
  local kl, kh = 2 * i + axis, 2 * j + axis
  local o = b.to[kl] + b.size[kl] - b.to[kh]
  local v, a = b.speed[kl] - b.speed[kh], b.accel[kl] - b.accel[kh]
  local u = impact.approach(o, v, a, (1 - t) * dt)
  impact.note(b, p, i, axis, u, t)
end

-- Ends the path of a dynamic body at its place at moment t. If it `isRound`, it has no speed then,
-- and has not moved if that was by rounding only.
local function stop(b, i, t, isRound)
  if b.kind[i] == DYNAMIC then
    path.advance(b, i, t)
    for k = 2 * i, 2 * i + 1 do
      b.to[k] = b.from[k]
      if isRound then
        b.frozenAt[i] = b.solveStamp
        local off = b.from[k] - b.origin[k]
        b.to[k] = off <= EPSILON and off >= -EPSILON and b.origin[k] or b.to[k]
        b.speed[k], b.accel[k] = 0.0, 0.0
      end
    end
  end
end

-- Returns whether a body that overlaps others has used up its impacts for this step. Other dynamic
-- bodies may move into it then; their impact is left to the next step.
local function isSpent(b, i)
  return b.deepAt[i] == b.solveStamp and b.impactsOf[i] >= SPENT
end

-- Returns whether the paths of k and m, as they were swept, cross on their axis.
local function crosses(b, k, m)
  local s, e, u, v = b.from[k], b.swept[k], b.from[m], b.swept[m]
  return max(s, e) + b.size[k] > min(u, v) and max(u, v) + b.size[m] > min(s, e)
end

-- Returns whether the path of slot i comes near that of a body in b.bounced. The paths of those
-- count as they are now and as they were swept.
local function meetsBounced(b, i)
  local list, from, to, swept, size = b.bounced, b.from, b.to, b.swept, b.size
  local k, l = 2 * i, 2 * i + 1
  local left, top = min(from[k], to[k]) - NEAR, min(from[l], to[l]) - NEAR
  local right = max(from[k], to[k]) + size[k] + NEAR
  local bottom = max(from[l], to[l]) + size[l] + NEAR
  for n = 1, b.bouncedCount do
    local m = 2 * list[n]
    local s, e, o = from[m], to[m], swept[m]
    if max(s, e, o) + size[m] > left and min(s, e, o) < right then
      local u, v, w = from[m + 1], to[m + 1], swept[m + 1]
      if max(u, v, w) + size[m + 1] > top and min(u, v, w) < bottom then
        return true
      end
    end
  end
  return false
end

-- Adds the dynamic ones of bodies i and j to b.bounced: an impact has changed their paths in this
-- round.
local function noteBounced(b, i, j)
  for at = 1, b.bouncedCount < BOUNCED and 2 or 0 do
    local k = at == 1 and i or j
    if b.kind[k] == DYNAMIC then
      b.bouncedCount = b.bouncedCount + 1
      b.bounced[b.bouncedCount] = k
    end
  end
end

-- Returns whether the bodies of contact p, one of which has a new path, would end far inside each
-- other.
local function isTorn(b, p)
  local kl, kh = b.contactLow[p], b.contactHigh[p]
  return b.touches[p] == contacts.CONTACT
    and b.to[kl] + b.separation[p] - b.to[kh] > PARTING * min(b.size[kl], b.size[kh])
end

-- Returns whether an earlier impact of this round may have invalidated the impact of slot i:
--
-- - it changed the path of slot i, or of a body that would end far inside it now;
-- - `mayBounce`: it changed a path that crosses that of slot i, or that did before. Slot i may meet
--   that body first.
--
-- Not every changed neighbour counts, because the neighbours depend on the broad phase.
local function isDisturbed(b, i, round, mayBounce)
  if b.inRound[i] == round then
    return true
  elseif b.kind[i] ~= DYNAMIC then
    return false
  elseif mayBounce and meetsBounced(b, i) then
    return true
  end
  local half, inRound = b.head[i], b.inRound
  while half ~= 0 do
    local j = b.other[half]
    if inRound[j] == round then
      if isTorn(b, floor(half * 0.5 + 0.5)) then
        return true
      elseif mayBounce and crosses(b, 2 * i, 2 * j) and crosses(b, 2 * i + 1, 2 * j + 1) then
        return true
      end
    end
    half = b.next[half]
  end
  return false
end

-- Resolves the n-th impact. If an earlier one of this round has disturbed its bodies, they are
-- swept again instead.
local function happen(b, n, dt, isLast, isLate)
  local impacts, round = b.impacts, b.roundStamp
  local p, t, axis = impacts.pair[n], impacts.time[n], impacts.axis[n]
  local i, j = impacts.low[n], impacts.high[n]
  local isSensed = b.sensor[i] or b.sensor[j]
  local isRound = b.hasCircles and ball.isRound(b, i, j)
  local areDynamic = b.kind[i] == DYNAMIC and b.kind[j] == DYNAMIC
  if areDynamic and not isRound and (isSpent(b, i) or isSpent(b, j)) then
    return
  end
  local mayBounce = max(b.restitution[i], b.restitution[j]) > 0
  if isDisturbed(b, i, round, mayBounce) or isDisturbed(b, j, round, mayBounce) then
    change(b, i)
    change(b, j)
    if mayBounce then
      noteBounced(b, i, j)
      b.inRound[i] = b.kind[i] == DYNAMIC and round or 0
      b.inRound[j] = b.kind[j] == DYNAMIC and round or 0
    end
    if isLast and not isSensed then
      stop(b, i, t, isRound)
      stop(b, j, t, isRound)
    end
    return
  end
  if
    (isSensed and b.hit[p] ~= 0)
    or rules.passes(b, p, 2 * i + axis, 2 * j + axis, axis, impacts.isDeep[n])
  then
    return
  elseif isSensed then
    sense(b, p, i, j, axis, t, dt)
    return
  end
  local struck = b.hasCircles and b.mayRestart and jam.struck(b, i, j, axis, t, dt)
  if struck then
    rest.wake(b, struck)
    knots.free(b, struck)
    b.awakenings = b.awakenings + 1 -- the step begins anew
    return
  end
  change(b, i)
  change(b, j)
  b.inRound[i] = b.kind[i] == DYNAMIC and round or 0
  b.inRound[j] = b.kind[j] == DYNAMIC and round or 0
  if b.hasBounces then
    noteBounced(b, i, j)
  end
  if b.hasNudges and not isLast and b.nudged[p] < nudge.MOST then
    if nudge.try(b, i, j, axis, true, t) or nudge.try(b, j, i, axis, false, t) then
      b.nudged[p] = b.nudged[p] + 1
      live.stain(b, p)
      return
    end
  end
  local stays, separation, isElastic =
    impact.run(b, p, i, j, axis, t, dt, isLate, impacts.isDeep[n])
  if stays or isElastic then
    contacts.add(b, axis, p, 2 * i + axis, 2 * j + axis, separation, isElastic)
    b.pressed[p] = stays and 1 or b.pressed[p]
  end
  if isLast then
    stop(b, i, t, isRound)
    stop(b, j, t, isRound)
  end
end

-- Makes one round: sweeps changed paths, then resolves the first impact of each body. Returns
-- whether there was any impact.
local function round(b, dt, isLast, isLate)
  local count = sweep.run(b, b.isChangeListed and b.changedCount)
  local list, dirty = b.isChangeListed and b.changed or b.awakeList, b.dirty
  for n = 1, b.isChangeListed and b.changedCount or b.awakeCount do
    dirty[list[n]] = 0
  end
  b.changedCount = 0
  if count == 0 then
    return false
  end
  sortImpacts(b)
  b.roundStamp, b.bouncedCount = b.roundStamp + 1, 0
  for n = 1, count do
    happen(b, b.impacts.order[n], dt, isLast, isLate)
  end
  contacts.rearrange(b)
  return true
end

-- Settles the axes on which a contact is violated at the end of the step. Returns whether one was.
local function settleViolated(b, dt)
  local isAny = false
  for n = 0, 1 do
    local axis = n == 0 and b.downAxis or 1 - b.downAxis
    if b.isJammed or settle.isViolated(b, axis) then
      settle.axis(b, axis, dt, true)
      isAny = true
    end
  end
  return isAny
end

-- Lets what stands on something follow it, where there are slopes.
local function followGround(b, dt, isFirst)
  walk.run(b, dt, isFirst)
  b.isChangeListed = false
  findChanged(b)
  contacts.noteNew(b)
end

-- Settles what impacts have changed, and looks up the neighbours of the new paths.
local function settleLate(b, dt)
  if b.hasSlopes then
    walk.run(b, dt, false)
  end
  b.isChangeListed, b.isJammed = not settleViolated(b, dt), false
  if b.isChangeListed then
    followChanged(b)
  else
    findChanged(b)
  end
  contacts.noteNew(b)
end

-- Limits the motion of the step, since pushes may add up where bodies overlap. A body ends no
-- further from its start than its fastest speed takes it, and PARTING of its size.
local function limitMotion(b, dt)
  local list, give, origin, to, size = b.awakeList, b.give, b.origin, b.to, b.size
  local start, freeSpeed, speed, position = b.start, b.freeSpeed, b.speed, b.position
  for n = 1, b.awakeCount do
    for k = 2 * list[n], 2 * list[n] + 1 do
      if give[k] > 0 then
        local fastest = max(start[k], -start[k], freeSpeed[k], -freeSpeed[k], speed[k], -speed[k])
        local most = fastest * dt + PARTING * size[k]
        to[k] = max(min(to[k], origin[k] + most), origin[k] - most)
        local all = max(size[k], origin[k] - position[k], position[k] - origin[k]) + fastest * dt
        to[k] = max(min(to[k], position[k] + all), position[k] - all)
      end
    end
  end
end

-- Keeps the end of each body that is not pushable between its start and its own goal, across
-- gravity. A body that is pressed directly by something immovable, or was deflected by a slanted
-- contact, is left out.
local function keepOwnWay(b, dt)
  local list, origin, to = b.awakeList, b.origin, b.to
  for n = 1, b.awakeCount do
    local i = list[n]
    for k = 2 * i, not b.pushable[i] and b.kind[i] == DYNAMIC and 2 * i + 1 or 0 do
      local isFree = b.heldLow[k] ~= 2 and b.heldHigh[k] ~= 2 and b.deflectedAt[i] ~= b.solveStamp
      if b.down[k] == 0 and isFree then
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
  change(b, i)
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
    followChanged(b)
    if not round(b, dt, true, true) and not isHeld then
      return
    end
  end
end

-- Settles what touches when the step begins, and follows the ground.
local function prepare(b, dt)
  b.solveStamp = b.solveStamp + 1
  begin(b, dt)
  friction.begin(b)
  live.list(b)
  if b.hasSlopes then
    walk.begin(b)
  end
  settleTouching(b, dt)
  if b.hasNudges then
    nudgeTouching(b, dt)
  end
  if b.rubs > 0 or b.hasCircles then
    settleViolated(b, dt) -- friction, or crushed circles, may have violated other contacts
  end
  b.isChangeListed = false
  findChanged(b)
  contacts.noteNew(b)
  if b.hasSlopes then
    followGround(b, dt, true)
  end
end

-- Makes the rounds. Returns whether bodies may have left the ground since it was followed; nil:
-- bodies were woken on the way.
local function runRounds(b, dt, awakenings)
  local hasChanged = b.overlapCount > 0 or b.hasFirm
  for n = 1, ROUNDS do
    if b.awakenings ~= awakenings then
      return nil
    end
    if not round(b, dt, n == ROUNDS, n > ROUNDS - LATE) then
      break
    end
    if n < ROUNDS then
      settleLate(b, dt)
      if b.hasSlopes then
        followGround(b, dt, false)
      end
    end
    hasChanged = hasChanged or n == ROUNDS
  end
  if b.awakenings ~= awakenings then
    return nil
  end
  return hasChanged
end

-- Bounds where bodies have come to.
local function boundMotion(b, dt, hasChanged)
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

-- Solves a step for all awake bodies. Returns false if bodies were woken on the way; the result is
-- void then.
local function solve(b, dt)
  local awakenings = b.awakenings
  prepare(b, dt)
  local hasChanged = runRounds(b, dt, awakenings)
  if hasChanged == nil then
    return false
  end
  boundMotion(b, dt, hasChanged)
  if b.hasSnaps then
    snap.run(b, dt)
    if b.awakenings ~= awakenings then
      return false
    end
  end
  for axis = 0, 1 do
    notePressed(b, axis)
    crush.note(b, axis)
  end
  return true
end

-- Puts everything back to the start of the step and computes the free flight again.
local function restart(b, dt)
  local list, from, origin, time = b.awakeList, b.from, b.origin, b.time
  for n = 1, b.predicted do
    local i = list[n]
    from[2 * i], from[2 * i + 1] = origin[2 * i], origin[2 * i + 1]
    time[i] = 0
  end
  b.predicted = 0
  predict.run(b, dt)
end

--- Resolves all contacts and impacts of a step of dt s.
function solver.run(b, dt)
  b.resolved, b.step, b.mayRestart = 0, b.step + 1, true
  for _ = 1, RESTARTS do
    if solve(b, dt) then
      return
    end
    restart(b, dt)
  end
  -- With all bodies awake, no path can come near a sleeping one.
  rest.wakeAll(b)
  b.mayRestart = false
  restart(b, dt)
  solve(b, dt)
end

-- These call one loop after the other, or take another branch for each body. (jit: 4)
interpreted.functions(settleTouching, sortImpacts, sense, stop, happen, round, settleLate, solve)
interpreted.functions(settleViolated, isSpent, crosses, isTorn, isDisturbed, restart, solver.run)
interpreted.functions(prepare, runRounds, boundMotion)

return solver
