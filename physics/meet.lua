--- Step 6, meet: contacts in the order of the moment at which they are met.
--
-- Every pair of neighbours that will meet on its present paths has one event in a queue. The first
-- one is resolved, which changes two paths; all pairs of those two are looked at again from that
-- moment on. Simultaneous events: solids before sensors, faces before corners, pairs that have not
-- been resolved in this step before those that have, along gravity before across, supports first
-- (from the floor up), then the order of the world. Nothing of this depends on the order in which
-- pairs were found.

local here = (...):match("^(.*)%.[^.]+$")
local approach = require(here .. ".approach")
local ask = require(here .. ".ask")
local columns = require(here .. ".columns")
local detect = require(here .. ".detect")
local flank = require(here .. ".flank")
local footing = require(here .. ".footing")
local gather = require(here .. ".gather")
local live = require(here .. ".live")
local nudge = require(here .. ".nudge")
local oneway = require(here .. ".oneway")
local path = require(here .. ".path")
local predict = require(here .. ".predict")
local queue = require(here .. ".queue")
local resolve = require(here .. ".resolve")
local turns = require(here .. ".turns")

require(here .. ".interpreted").file()

local meet = {}

local floor, huge, max = math.floor, math.huge, math.max
local DYNAMIC = columns.DYNAMIC
local CORNER = approach.CORNER

-- Moments closer than this part of a step are simultaneous.
local MOMENTS = 1e9
local MOST_MET = 63
-- The last key of what is met at the very beginning (see `keyOf`).
local LAST_INSTANT = 4 * 64 * 2 - 1
-- Corner corrections of one pair in one step.
local MOST_NUDGES = 4
local NONE = columns.NO_EVENT

-- How firmly the one that supports a pair stands: what never gives way first, then by how far down
-- it is (along gravity), so that a stack is resolved from the floor up. Across gravity it is the
-- right-hand one as gravity sees it, so that a scene may be turned.
local function supportOf(b, low, high, axis)
  if b.kind[low] ~= DYNAMIC or b.kind[high] ~= DYNAMIC then
    return huge
  elseif b.orientation[axis] < 0 then
    return -b.from[2 * low + axis]
  end
  return b.from[2 * high + axis] + b.size[2 * high + axis]
end

-- What decides the order of events: moment, kind, how often the pair was resolved, axis, as one
-- whole number.
local function keyOf(b, met, t, kind, axis, isSensed)
  -- What is met at the very beginning goes before all else (see turns).
  local moment = t > 0 and max(floor(t * MOMENTS + 0.5), 1) or 0
  if isSensed then
    moment = moment + 4 -- whoever is stopped by something solid at that moment does not come in
  elseif kind == CORNER then
    moment = moment + 2
  end
  local key = ((moment * 4 + kind) * 64 + (met < MOST_MET and met or MOST_MET)) * 2
  return axis == b.downAxis and key or key + 1
end

local function enqueue(b, p, t, code)
  local one, other, met = b.pairA[p], b.pairB[p], b.met[p]
  local isSensed = b.sensor[one] or b.sensor[other]
  if b.passing[p] or met >= resolve.PATIENCE or (isSensed and met > 0) then
    return
  end
  local kind, axis, otherIsLow = approach.decode(code)
  local low, high = one, other
  if otherIsLow then
    low, high = other, one
  end
  local support = supportOf(b, low, high, axis)
  local first, second = columns.ranks(b, one, other)
  b.watched[one], b.watched[other] = b.step, b.step
  local key = keyOf(b, met, t, kind, axis, isSensed)
  b.waits[p] = t <= 0 and kind ~= CORNER and not isSensed and not b.isEager and 1 or 0
  b.event[p] = queue.push(b.queue, key, support, first, second, p, code, t)
end

local function enqueueAll(b, count)
  local near, nearTime, nearCode = b.near, b.nearTime, b.nearCode
  for n = 1, count do
    if nearCode[n] >= 0 then
      enqueue(b, near[n], nearTime[n], nearCode[n])
    end
  end
end

-- Computes when the pairs that were listed meet, and puts that into the queue.
local function schedule(b, count)
  if count > 0 then
    approach.run(b, count)
    enqueueAll(b, count)
  end
end

-- Looks up the neighbours of those in list[1..count] whose paths leave their fat boxes. This may
-- wake others, who are computed as if they had been awake from the beginning.
local function lookUp(b, list, count, dt)
  detect.run(b, list, 1, count)
  while b.predicted < b.awakeCount do
    local woken = b.predicted + 1
    predict.run(b, dt)
    live.add(b, woken)
    detect.run(b, b.awakeList, woken, b.predicted)
    schedule(b, gather.objects(b, b.awakeList, woken, b.predicted, 0))
  end
end

-- Looks again at everybody whose path has changed. As long as all this is at the very beginning of
-- the step, only those who touch can be met then; the others are looked at when that is over.
local function followChanged(b, dt)
  if b.isInstant then
    b.isStale = true
  else
    lookUp(b, b.changed, b.changedCount, dt)
  end
  schedule(b, gather.objects(b, b.changed, 1, b.changedCount, 0))
end

-- A nudge moves somebody aside at once, also at the very beginning of the step: then he may touch
-- others, and from now on nobody keeps a place without being looked at.
local function followNudge(b, dt)
  if b.isInstant then
    lookUp(b, b.changed, b.changedCount, dt)
  end
  for n = 1, b.changedCount do
    local half = b.head[b.changed[n]]
    while half ~= 0 do
      live.touch(b, (half + half % 2) / 2)
      half = b.next[half]
    end
  end
  if b.isEager then
    return
  end
  b.isEager = true
  for n = 1, b.liveCount do
    local p = b.live[n]
    if b.waits[p] == 2 then
      schedule(b, gather.pair(b, p))
    end
    b.waits[p] = 0
  end
end

local function happen(b, p, code, t, dt)
  local kind, axis, otherIsLow = approach.decode(code)
  local low, high = b.pairA[p], b.pairB[p]
  if otherIsLow then
    low, high = b.pairB[p], b.pairA[p]
  end
  if b.dropping[p] or oneway.lets(b, low, high, 2 * axis + 2, kind) then
    return
  end
  if b.permitted[p] == b.step then
    b.permitted[p] = 0 -- was asked when it was its turn
  elseif not ask.permits(b, low, high, axis) then
    b.passing[p] = true
    return
  end
  if b.sensor[low] or b.sensor[high] then
    resolve.sense(b, p, low, high, axis, t, dt)
    return
  end
  path.startChanges(b)
  if
    b.nudged[p] < MOST_NUDGES
    and (nudge.try(b, low, high, axis, true, t) or nudge.try(b, high, low, axis, false, t))
  then
    b.nudged[p] = b.nudged[p] + 1
    followNudge(b, dt)
  else
    resolve.run(b, p, low, high, axis, t, dt, kind == approach.DEEP)
    b.settled[p] = b.changedCount == 0 and 1 + b.changes[low] + b.changes[high] or 0
  end
  followChanged(b, dt)
end

-- Looks at all pairs that touch, when all have had their turns: only then are their paths what they
-- will be for most.
local function lookAtTouching(b)
  b.isAllSeen, b.isStale = true, true
  schedule(b, gather.together(b))
end

-- Looks at the others, when all that happens at the very beginning of the step is over. Whom
-- everybody may meet is looked up now.
local function lookAtApart(b, dt)
  lookUp(b, b.awakeList, b.awakeCount, dt)
  b.isStale = false
  schedule(b, gather.apart(b))
end

-- Looks at all pairs.
local function lookAtAll(b, dt)
  lookUp(b, b.awakeList, b.awakeCount, dt)
  b.isAllSeen = true
  schedule(b, gather.live(b))
end

-- Puts pairs that are flush and have no turn into the queue, up to place `last` of the list. They
-- may be met before those that have one, now or when a path has changed.
local function scheduleOdd(b, last)
  local watched, step = b.watched, b.step
  for n = b.oddSeen + 1, last do
    local p = b.odd[n]
    watched[b.pairA[p]], watched[b.pairB[p]] = step, step
    schedule(b, gather.pair(b, p))
  end
  b.oddSeen = max(b.oddSeen, last)
end

-- Looks after whom the last turn has changed.
local function followTurn(b, dt)
  local x = b.turnOrder[b.turnsDone]
  path.startChanges(b)
  path.change(b, b.turnUp[x])
  if b.turnsDone > b.footingCount then
    path.change(b, b.turnLow[x])
  end
  followChanged(b, dt)
end

-- Asks the game about the next turn.
local function askAboutTurn(b)
  local at = b.turnsDone + 1
  local x, axis = b.turnOrder[at], at <= b.footingCount and b.downAxis or 1 - b.downAxis
  local low, high, p = b.turnUp[x], b.turnLow[x], b.turnPair[x]
  if b.orientation[axis] < 0 then
    low, high = b.turnLow[x], b.turnUp[x]
  end
  if ask.permits(b, low, high, axis) then
    b.permitted[p] = b.step
  else
    b.passing[p] = true
  end
end

-- Lets those who have turns take them, by `land` of footings or flanks, until the queue goes first;
-- what that disturbs at once goes into it. Returns whether all have had their turns.
local function settle(b, land, dt)
  local isNext, left = false
  repeat
    left = land(b, dt, isNext)
    if left == flank.RUB then
      path.startChanges(b)
      footing.rub(b, b.turnsDone, dt)
    end
    while not footing.slide(b, dt) do
      path.startChanges(b)
      footing.rub(b, b.turnsSlid, dt)
    end
    if left == footing.CHANGED or left == flank.RUB then
      followTurn(b, dt)
    elseif left == footing.PERMIT then
      askAboutTurn(b)
    elseif left > 0 then
      schedule(b, gather.pair(b, left))
    end
    isNext = left == footing.ASK or left == footing.PERMIT
    if left == footing.ASK and footing.isLater(b) then
      return false
    end
  until left == footing.DONE
  return true
end

-- Lets flanks that have met take a second turn. Returns whether all have.
local function settleAgain(b, dt)
  local again = b.turnsAgain
  for n = 1, flank.again(b, again) do
    schedule(b, gather.pair(b, again[n]))
  end
  return settle(b, flank.land, dt)
end

-- Settles what touches when the step begins, until the queue goes first.
local function stand(b, dt)
  scheduleOdd(b, b.oddFootings)
  if settle(b, footing.land, dt) then
    scheduleOdd(b, b.oddCount)
    if settle(b, flank.land, dt) and (b.round > 0 or b.isEager or settleAgain(b, dt)) then
      lookAtTouching(b)
    end
  end
end

-- Sees to it that the first event of the queue is the next one.
local function prepare(b, dt)
  if not b.isAllSeen then
    stand(b, dt)
  end
  while b.isAllSeen and b.isInstant and not footing.isAsked(b.queue, LAST_INSTANT) do
    b.isInstant = b.isStale
    if b.isStale then
      lookAtApart(b, dt)
    end
  end
end

-- Looks at a pair that has waited for its turn, and whose paths have changed since; returns whether
-- it meets as it was noted. If not, it has another event now, or none.
local function isStill(b, p, code, t)
  local count = gather.pair(b, p)
  if count == 0 then
    return false
  end
  approach.run(b, count)
  if b.nearCode[1] == code and b.nearTime[1] == t then
    return true
  end
  enqueueAll(b, count)
  return false
end

-- The first event of the queue, whose turn it is.
local function take(b, id, dt)
  local p, code, t = queue.read(b.queue, id)
  if b.event[p] ~= id or (b.waits[p] == 2 and not isStill(b, p, code, t)) then
    return
  end
  b.event[p], b.waits[p] = NONE, 0
  b.resolved = b.resolved + 1
  happen(b, p, code, t, dt)
end

--- Resolves all contacts of a step of dt s.
function meet.run(b, dt)
  local q = b.queue
  queue.clear(q)
  b.resolved, b.isAllSeen, b.step = 0, false, b.step + 1
  b.isInstant, b.isEager, b.oddSeen = not b.queueOnly, b.queueOnly, 0
  live.list(b)
  turns.list(b)
  if b.queueOnly then
    lookAtAll(b, dt)
  end
  prepare(b, dt)
  local id = queue.pop(q)
  while id do
    take(b, id, dt)
    prepare(b, dt)
    id = queue.pop(q)
  end
end

return meet
