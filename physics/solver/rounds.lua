---@diagnostic disable
--- Rounds: sweeps changed paths, and lets the first impact of each body happen.
--
-- Impacts are resolved in the order of their times. A body takes part in one impact of a round:
-- what an earlier one has disturbed is swept again in the next round. A path that leaves its fat
-- box in the middle of the step is looked up anew; pairs that it makes are swept in the next round,
-- and if it comes near a sleeping body the step begins anew.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local ball = require(root .. ".memory.lazy")(root .. ".solver.ball")
local columns = require(root .. ".memory.columns")
local contacts = require(root .. ".solver.contacts")
local filter = require(root .. ".broadphase.filter")
local impact = require(root .. ".memory.lazy")(root .. ".solver.impact")
local nudge = require(root .. ".memory.lazy")(root .. ".solver.nudge")
local pairFinder = require(root .. ".broadphase.pairFinder")
local path = require(root .. ".motion.path")
local rules = require(root .. ".solver.rules")
local sort = require(root .. ".memory.sort")
local sweep = require(root .. ".solver.sweep")

local rounds = {}

local DYNAMIC, WIDTHS, neighbours = columns.DYNAMIC, columns.WIDTHS, columns.neighbours
local HUGE, floor, max, min = math.huge, math.floor, math.max, math.min

-- Maximum number of impacts in a step of a body that overlaps others and has no room. (Without it a
-- piston that presses 250 boxes takes three times as long.)
local SPENT = 2
-- Maximum number of new paths in a round with which a later impact is compared.
local BOUNCED = 256
-- Impacts are simultaneous if their times, rounded to 1 / MOMENTS of a step, are equal.
local MOMENTS = 1e9

--- Notes which bodies have another path than the one that was swept last, and looks up the
--- neighbours of all that have changed.
function rounds.findChanged(b)
  local list, to, swept, dirty, stamp = b.awakeList, b.to, b.swept, b.dirty, b.dirtyStamp
  local changed, count = b.changed, b.changedCount
  for n = 1, b.awakeCount do
    local i = list[n]
    local k = 2 * i
    if to[k] ~= swept[k] or to[k + 1] ~= swept[k + 1] then
      swept[k], swept[k + 1] = to[k], to[k + 1]
      if dirty[i] ~= stamp then
        count = count + 1
        dirty[i], changed[count] = stamp, i
      end
    end
  end
  b.changedCount = count
  pairFinder.run(b, changed, count)
  contacts.noteNew(b)
end

-- Sorts the impacts by moment, solids before sensors, then the wider common edge first, then by the
-- order of the world.
local function sortImpacts(b)
  local impacts = b.impacts
  local order, moment, edge = impacts.order, impacts.moment, impacts.width
  for n = 1, impacts.count do
    local i, j, axis = impacts.low[n], impacts.high[n], impacts.axis[n]
    local isSensed = b.sensor[i] or b.sensor[j]
    order[n] = n
    local late = (impacts.isCorner[n] and 2 or 0) + (isSensed and 4 or 0)
    moment[n] = floor(impacts.time[n] * MOMENTS + 0.5) + late
    local k, m = 2 * i + 1 - axis, 2 * j + 1 - axis
    local width = min(b.from[k] + b.size[k], b.from[m] + b.size[m]) - max(b.from[k], b.from[m])
    edge[n] = -floor(width * WIDTHS + 0.5)
    impacts.first[n], impacts.second[n] = columns.ranks(b, i, j)
  end
  sort.by(order, impacts.count, moment, edge, impacts.first, impacts.second)
end

-- Returns whether a body that overlaps others has used up its impacts for this step. Other dynamic
-- bodies may move into it then; their impact is left to the next step.
local function isSpent(b, i)
  return b.deepAt[i] == b.solveStamp and b.impactsOf[i] >= SPENT
end

-- Notes that the dynamic ones of slots i and j have new paths. They take part in this round
-- (`takesPart`), so that what follows in it waits for the next one.
local function change(b, i, j, takesPart)
  for n = 1, 2 do
    local k = n == 1 and i or j
    if b.kind[k] == DYNAMIC then
      path.change(b, k)
      b.inRound[k] = takesPart and b.roundStamp or b.inRound[k]
    end
  end
end

-- Returns whether slot j, which has a new path, may meet slot i on that until moment t, or might
-- have on its old one. The path of slot i counts with its own length around it.
local function comesNear(b, i, j, t)
  local from, to, swept, size = b.from, b.to, b.swept, b.size
  local x, y = to[2 * i] - from[2 * i], to[2 * i + 1] - from[2 * i + 1]
  local reach = max(x, -x, y, -y) * t
  for axis = 0, 1 do
    local k, m = 2 * i + axis, 2 * j + axis
    local way, its, old = (to[k] - from[k]) * t, (to[m] - from[m]) * t, (swept[m] - from[m]) * t
    local low, high = from[k] + min(way, 0) - reach, from[k] + size[k] + max(way, 0) + reach
    if from[m] + size[m] + max(its, old, 0) <= low or from[m] + min(its, old, 0) >= high then
      return false
    end
  end
  return filter.blocks(b, i, j, true)
end

-- Returns whether slots i and j, of pair p, one of which has a new path, meet before moment t.
-- (Their old paths must overlap: whether any other pair is known depends on earlier steps.)
local function meetBefore(b, p, i, j, t)
  local isOpen = not (b.sensor[i] or b.sensor[j] or b.passing[p])
  local its = isOpen and sweep.isNear(b, b.swept, p, i, j) and sweep.find(b, i, j)
  return its and its < t
end

-- Returns whether an earlier impact of this round may have invalidated that of slot i at moment t:
-- it changed the path of slot i, or of a body that it would meet before; or, if it may bounce
-- (`mayBounce`), of one that comes near until twice that moment, since that may bounce, too, and be
-- faster then. (In late rounds it counts as if it did not: beside two that meet without end, it
-- would wait until there are no more rounds.)
local function isDisturbed(b, i, t, mayBounce)
  local inRound, round = b.inRound, b.roundStamp
  if inRound[i] == round then
    return true
  elseif b.kind[i] ~= DYNAMIC then
    return false
  end
  for n = 1, mayBounce and min(b.changedCount, BOUNCED) or 0 do
    local j = b.changed[n]
    if inRound[j] == round and comesNear(b, i, j, min(2 * t, 1)) then
      return true
    end
  end
  for _, j, p in neighbours(b, i) do
    if inRound[j] == round and meetBefore(b, p, i, j, t) then
      return true
    end
  end
  return false
end

-- Lets slots i and j, of pair p, meet at moment t. If they stay together, they are a contact for
-- the rest of the step. Returns whether they met: a nudge may lead past.
local function meet(b, p, i, j, axis, t, dt, isLast, isLate, isDeep)
  change(b, i, j, true)
  if b.hasNudges and not isLast and nudge.correct(b, p, i, j, axis, t) then
    return false
  end
  local stays, separation, isElastic = impact.run(b, p, i, j, axis, t, dt, isLate, isDeep)
  if stays or isElastic then
    contacts.add(b, axis, p, 2 * i + axis, 2 * j + axis, separation, isElastic)
    b.pressed[p] = stays and 1 or b.pressed[p]
  end
  return true
end

-- Returns whether slot i goes on although its rounds run out: it is stronger than the other one,
-- which `relax` puts before it. (A player in a crowd would stand in each second step.)
local function outdoes(b, i, j)
  return b.kind[j] == DYNAMIC and b.power[i] > b.power[j] and b.power[i] < HUGE
end

-- Resolves the n-th impact. If an earlier one of this round has disturbed its bodies, they are
-- swept again instead. What may bounce, and circles, then take part in this round all the same, so
-- that they do not get past each other. (Sensors stop nothing.)
local function happen(b, n, dt, isLast, isLate)
  local impacts = b.impacts
  local p, t, axis = impacts.pair[n], impacts.time[n], impacts.axis[n]
  local i, j, isDeep = impacts.low[n], impacts.high[n], impacts.isDeep[n]
  local isSensed = b.sensor[i] or b.sensor[j]
  local isRound = b.hasRound and ball.isRound(b, i, j)
  local areEqual = b.kind[i] == b.kind[j] and b.power[i] == b.power[j]
  if b.passing[p] or areEqual and not isRound and (isSpent(b, i) or isSpent(b, j)) then
    return
  end
  local mayBounce = max(b.restitution[i], b.restitution[j]) > 0
  local waits = mayBounce and not isLate
  if isDisturbed(b, i, t, waits) or isDisturbed(b, j, t, waits) then
    change(b, i, j, not isSensed and (mayBounce or isRound))
    return
  elseif
    (isSensed and b.hit[p] ~= 0) or rules.passes(b, p, 2 * i + axis, 2 * j + axis, axis, isDeep)
  then
    return
  elseif isSensed then
    impact.sense(b, p, i, j, axis, t, dt)
    return
  end
  if not meet(b, p, i, j, axis, t, dt, isLast, isLate, isDeep) or not isLast then
    return
  end
  if not outdoes(b, i, j) then
    path.stop(b, i, t, isRound)
  end
  if not outdoes(b, j, i) then
    path.stop(b, j, t, isRound)
  end
end

--- Makes one round: sweeps changed paths, then resolves the first impact of each body. Returns
--- whether anything is to be swept again.
function rounds.run(b, dt, isLast, isLate)
  local count = sweep.run(b)
  b.changedCount, b.dirtyStamp = 0, b.dirtyStamp + 1
  if count == 0 then
    return false
  end
  sortImpacts(b)
  b.roundStamp = b.roundStamp + 1
  for n = 1, count do
    happen(b, b.impacts.order[n], dt, isLast, isLate)
  end
  contacts.rearrange(b)
  return b.changedCount > 0
end

return rounds
