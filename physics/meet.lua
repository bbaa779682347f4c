--- Step 6, meet: contacts in the order of the moment at which they are met.
--
-- Every pair of neighbours that will meet on its present paths has one event in a queue. The first
-- one is resolved, which changes two paths; all pairs of those two are looked at again from that
-- moment on. Simultaneous events: solids before sensors, faces before corners; what is met at the
-- very beginning in rounds (see `rounds`), what is met later: pairs that have not been resolved in
-- this step before those that have, along gravity before across, supports first (from the floor
-- up), then the order of the world. Nothing of this depends on the order in which pairs were found.

local here = (...):match("^(.*)%.[^.]+$")
local approach = require(here .. ".approach")
local ask = require(here .. ".ask")
local columns = require(here .. ".columns")
local crush = require(here .. ".crush")
local detect = require(here .. ".detect")
local footing = require(here .. ".footing")
local gather = require(here .. ".gather")
local live = require(here .. ".live")
local lone = require(here .. ".lone")
local nudge = require(here .. ".nudge")
local oneway = require(here .. ".oneway")
local pass = require(here .. ".pass")
local path = require(here .. ".path")
local press = require(here .. ".press")
local predict = require(here .. ".predict")
local queue = require(here .. ".queue")
local resolve = require(here .. ".resolve")
local rounds = require(here .. ".rounds")
local turns = require(here .. ".turns")
local weld = require(here .. ".weld")

require(here .. ".interpreted").file()

local meet = {}

local floor, max = math.floor, math.max
local DYNAMIC, FACES = columns.DYNAMIC, columns.FACES
local FACE, CORNER = approach.FACE, approach.CORNER

-- Moments closer than this part of a step are simultaneous.
local MOMENTS = 1e9
-- How many different keys events of one moment and kind may have.
local KEYS = 2 * rounds.MOST
-- The last key of what is met at the very beginning (see `keyOf`), and of the faces among that.
local LAST_INSTANT, LAST_FACE = 4 * KEYS - 1, KEYS - 1
-- While so many turns come to one that has pressed, another round costs less than the queue.
local IDLE_TURNS = 256
-- One who rests to so many who are awake is worth to look who comes near, before anything happens.
local WORTH = 8
-- Corner corrections of one pair in one step.
local MOST_NUDGES = 4
local NONE = columns.NO_EVENT

-- How firmly the one that supports a pair stands: what never gives way first, then by how far down
-- (along gravity) the face of the other one is that leans on it, so that a stack is resolved from
-- the floor up, and all that somebody stands on comes together. Across gravity the right-hand one
-- supports, as gravity sees it, so that a scene may be turned. Faces that are flush are alike, or
-- rounding would decide who of two that one runs into is pushed first.
local function supportOf(b, low, high, axis)
  if b.kind[low] ~= DYNAMIC or b.kind[high] ~= DYNAMIC then
    return columns.FIRM
  end
  local face = b.orientation[axis] < 0 and -b.from[2 * high + axis]
    or b.from[2 * low + axis] + b.size[2 * low + axis]
  return floor(face * FACES + 0.5) / FACES
end

-- What decides the order of events: moment, kind, `round` (or how often the pair was resolved),
-- axis (1: across gravity), as one whole number.
local function keyOf(t, kind, isSensed, round, axis)
  -- What is met at the very beginning goes before all else (see turns).
  local moment = t > 0 and max(floor(t * MOMENTS + 0.5), 1) or 0
  if isSensed then
    moment = moment + 4 -- whoever is stopped by something solid at that moment does not come in
  elseif kind == CORNER then
    moment = moment + 2
  end
  return (moment * 4 + kind) * KEYS + 2 * round + axis
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
  local across, round = axis == b.downAxis and 0 or 1, met
  if t <= 0 and kind == FACE and not isSensed then
    round = rounds.of(b, across, support, first, second)
    support, first, second = rounds.turned(round, support, first, second)
  end
  local key = keyOf(t, kind, isSensed, round, across)
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

-- As long as turns are taken, nobody needs to be looked at but those who touch somebody with whom
-- they have none. Keeps only these of those whose path has changed.
local function keepWatched(b)
  local changed, watched, step, count = b.changed, b.watched, b.step, 0
  for n = 1, b.changedCount do
    local i = changed[n]
    if b.isEager or watched[i] == step then
      count = count + 1
      changed[count] = i
    end
  end
  b.changedCount = count
end

-- Looks again at everybody whose path has changed. As long as all this is at the very beginning of
-- the step, only those who touch can be met then; the others are looked at when that is over.
local function followChanged(b, dt)
  if b.isInstant then
    b.isStale = true
  else
    local first = b.awakeCount + 1
    lookUp(b, b.changed, b.changedCount, dt)
    while b.lone.latest > b.now and lone.undoNear(b, first) do
      lookUp(b, b.changed, b.changedCount, dt)
    end
  end
  if b.isQuiet then
    return
  elseif not b.isAllSeen then
    keepWatched(b)
  end
  if b.changedCount > 0 then
    schedule(b, gather.objects(b, b.changed, 1, b.changedCount, 0))
  end
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
  b.isEager, b.isQuiet = true, false
  for n = 1, b.liveCount do
    local p = b.live[n]
    -- Who has no turn has not always been followed yet (see `keepWatched`).
    if b.waits[p] == 2 or (not b.isAllSeen and b.turn[p] == 0 and b.event[p] ~= NONE) then
      schedule(b, gather.pair(b, p))
    end
    b.waits[p] = 0
  end
end

-- How often the paths of two have changed by now. (Not that of `gather`, which is compiled: see
-- `footing`.)
local function changesOf(changes, i, j)
  return changes[2 * i] + changes[2 * i + 1] + changes[2 * j] + changes[2 * j + 1]
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
  live.stain(b, p)
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
    local before = changesOf(b.changes, low, high)
    b.now = max(b.now, t) -- (events of who is crushed may come late)
    resolve.run(b, p, low, high, axis, t, dt, kind == approach.DEEP)
    b.settled[p] = changesOf(b.changes, low, high) == before and 1 + before or 0
  end
  return followChanged(b, dt)
end

-- Looks at all pairs that touch, when all have had their turns: only then are their paths what they
-- will be for most. `isCalm`: who has had turns presses no more.
local function lookAtTouching(b, isCalm)
  b.isAllSeen, b.isStale, b.isQuiet = true, true, false
  if isCalm then
    rounds.start(b)
  else
    rounds.finish(b, b.turnRound)
  end
  schedule(b, gather.together(b, isCalm))
end

-- Looks after those who have been hit while nobody else had to do with them.
local function followLone(b, dt)
  local first = b.awakeCount + 1
  lookUp(b, b.changed, b.changedCount, dt)
  lone.undoDisturbed(b, first)
  lookUp(b, b.changed, b.changedCount, dt)
  schedule(b, gather.objects(b, b.changed, 1, b.changedCount, 0))
end

-- Looks at the others, when all that happens at the very beginning of the step is over. Whom
-- everybody may meet is looked up now.
local function lookAtApart(b, dt)
  rounds.start(b)
  lookUp(b, b.awakeList, b.awakeCount, dt)
  b.isStale = false
  local count = gather.apart(b)
  if count > 0 then
    approach.run(b, count)
    local isLone = not pass.isAsked(b.queue, LAST_INSTANT) and lone.resolve(b, count, dt)
    enqueueAll(b, count)
    if isLone then
      b.isInstant = false -- all that is left is later
      followLone(b, dt)
    end
  end
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
  for n = b.oddSeen + 1, last do
    schedule(b, gather.pair(b, b.odd[n]))
  end
  b.oddSeen = max(b.oddSeen, last)
end

-- Goes to the n-th turn of this round; returns its place in the columns of turns, and 1 if it is
-- across gravity, 0 if along.
local function passTurn(b, n)
  local x, across = rounds.turnAt(b, n)
  rounds.pass(b, b.turnRound, across, b.turnSupport[x], b.turnFirst[x], b.turnSecond[x])
  return x, across
end

-- Of the two of a turn, first the one with the smaller coordinate; and on which axis it is.
local function lowAndHigh(b, x, across)
  local axis = across == 0 and b.downAxis or 1 - b.downAxis
  if b.orientation[axis] < 0 then
    return b.turnLow[x], b.turnUp[x], axis
  end
  return b.turnUp[x], b.turnLow[x], axis
end

-- Does what is to come of the last turn: lets the rings of the two follow, and rubs them.
local function finishTurn(b)
  local gives = b.turnGives
  path.startChanges(b)
  if gives >= press.RINGS then
    local low, high, axis = lowAndHigh(b, rounds.turnAt(b, b.turnsDone))
    weld.follow(b, 2 * low + axis, 2 * high + axis, b.turnLowTo, b.turnHighTo, b.turnJoins > 0)
  end
  if gives % press.RINGS >= press.RUBS then
    footing.rub(b, b.turnsDone)
  end
end

-- Looks after whom the last turn has changed.
local function followTurn(b, dt)
  local low, high = lowAndHigh(b, passTurn(b, b.turnsDone))
  local gives = b.turnGives % press.RUBS
  if gives % press.HIGH == press.LOW then
    path.change(b, low)
  end
  if gives >= press.HIGH then
    path.change(b, high)
  end
  followChanged(b, dt)
end

-- Asks the game about the next turn.
local function askAboutTurn(b)
  local x, across = passTurn(b, b.turnsDone + 1)
  local low, high, axis = lowAndHigh(b, x, across)
  local p = b.turnPair[x]
  if ask.permits(b, low, high, axis) then
    b.permitted[p] = b.step
  else
    b.passing[p] = true
    live.stain(b, p)
  end
end

-- Resolves the last turn in the general way.
local function takeTurn(b, p, dt)
  local low, _, axis = lowAndHigh(b, passTurn(b, b.turnsDone))
  b.resolved = b.resolved + 1
  happen(b, p, approach.code(FACE, axis, b.pairB[p] == low), 0, dt)
end

-- Looks after whom a footing that has rubbed has changed. In the first round all whom this may
-- concern are yet to be looked at, unless somebody was nudged.
local function followRub(b, dt)
  if b.turnRound > 0 or b.isEager then
    passTurn(b, b.landed[b.slidCount])
    followChanged(b, dt)
  end
end

-- Begins to go through those who have turns along gravity (`across` 0) or across it (1), or goes
-- on. Returns whether all are as they were when they were gone through last, and the queue has
-- nothing that comes in between: they are passed over.
local function isPassedOver(b, across)
  local current, _, last = 2 * b.turnRound + across, rounds.span(b, across)
  if b.turnPass >= current then
    return false
  end
  b.turnPass = current
  if b.isTurnStale[across] or pass.isAsked(b.queue, current) then
    b.isTurnStale[across] = false
    return false
  end
  b.turnsDone = last
  return true
end

-- Lets those rub that have landed, as far as `footing` can. Returns whether these are all.
local function slide(b, dt)
  local first = b.slidCount + 1
  local areAll = footing.slide(b, dt)
  footing.noteImpacts(b, first, areAll and b.slidCount or b.slidCount - 1)
  return areAll
end

-- Lets those who have turns along gravity (`across` 0) or across it (1) take them, until the queue
-- goes first. Returns whether all have had their turns in this round.
local function settle(b, across, dt)
  if isPassedOver(b, across) then
    return true
  end
  local isNext, left = false
  repeat
    left = pass.run(b, across, dt, isNext)
    while b.slidCount < b.landedCount and not slide(b, dt) do
      path.startChanges(b)
      footing.rub(b, b.landed[b.slidCount])
      followRub(b, dt)
    end
    if left == pass.FINISH then
      finishTurn(b)
      if not b.isQuiet then
        followTurn(b, dt)
      end
    elseif left == pass.CHANGED then
      path.startChanges(b)
      followTurn(b, dt)
    elseif left == pass.PERMIT then
      askAboutTurn(b)
    elseif left > 0 then
      takeTurn(b, left, dt)
    end
    isNext = left == pass.ASK or left == pass.PERMIT
    if left == pass.ASK and pass.isLater(b) then
      return false
    end
  until left == pass.DONE
  return true
end

-- Before the first flank of a round: looks at odd pairs across gravity. After the first round, or
-- if somebody was nudged, they have been looked at before; then only at those of whom footings have
-- rubbed since, as `slide` tells nobody.
local function beginFlanks(b, dt)
  b.hasFlanksBegun = true
  if b.turnRound == 0 then
    scheduleOdd(b, b.oddCount)
  end
  if b.isEager or (b.turnRound > 0 and b.oddFootings < b.oddCount) then
    path.startChanges(b)
    for n = 1, footing.listLanded(b, b.rubbed) do
      path.change(b, b.rubbed[n])
    end
    followChanged(b, dt)
  end
end

-- Begins the next round of turns, if many have pressed in this one.
local function nextRound(b)
  local count = b.resolved - b.resolvedBefore
  if count * IDLE_TURNS < b.turnCount or b.turnRound == rounds.MOST - 1 then
    return false
  end
  b.turnRound, b.turnsDone, b.resolvedBefore = b.turnRound + 1, 0, b.resolved
  b.landedCount, b.slidCount, b.hasFlanksBegun = 0, 0, false
  return true
end

-- Settles what touches when the step begins, until the queue goes first.
local function stand(b, dt)
  repeat
    scheduleOdd(b, b.oddFootings)
    if not settle(b, 0, dt) then
      return
    end
    if not b.hasFlanksBegun then
      beginFlanks(b, dt)
    end
    if not settle(b, 1, dt) then
      return
    end
  until b.resolved == b.resolvedBefore or not nextRound(b)
  lookAtTouching(b, b.resolved == b.resolvedBefore)
end

-- Sees to it that the first event of the queue is the next one.
local function prepare(b, dt)
  if not b.isAllSeen then
    stand(b, dt)
  end
  while b.isAllSeen and b.isInstant and not pass.isAsked(b.queue, LAST_INSTANT) do
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

-- Goes to where the rounds are with this event; to their beginning if it has no place in them.
local function passEvent(b, id)
  local key, support, first, second = queue.order(b.queue, id)
  if key > LAST_FACE then
    return rounds.start(b)
  end
  local across = key % 2
  local round = (key - across) / 2
  rounds.pass(b, round, across, rounds.turned(round, support, first, second))
end

-- The first event of the queue, whose turn it is.
local function take(b, id, dt)
  local p, code, t = queue.read(b.queue, id)
  if b.event[p] ~= id or (b.waits[p] == 2 and not isStill(b, p, code, t)) then
    return
  end
  passEvent(b, id)
  b.event[p], b.waits[p] = NONE, 0
  b.resolved = b.resolved + 1
  return happen(b, p, code, t, dt)
end

-- Wakes whom those who are awake may meet, before turns are listed: who is woken later has none.
-- Not for a few, which would cost more than it saves.
local function wakeAhead(b, dt)
  if (b.moverCount - b.awakeCount) * WORTH < b.awakeCount or b.awakeCount == 0 then
    return
  end
  detect.wakeAhead(b)
  predict.run(b, dt)
end

--- Resolves all contacts of a step of dt s.
function meet.run(b, dt)
  local q = b.queue
  queue.clear(q)
  b.resolved, b.isAllSeen, b.step = 0, false, b.step + 1
  b.resolvedBefore, b.hasFlanksBegun, b.givenUpCount = 0, false, 0
  b.isInstant, b.isEager, b.oddSeen = not b.queueOnly, b.queueOnly, 0
  b.lone.latest, b.lone.count, b.now = 0, 0, 0
  rounds.start(b)
  wakeAhead(b, dt)
  live.list(b)
  b.isMeeting = true
  turns.list(b)
  b.isQuiet = not b.queueOnly and b.oddCount == 0
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
  crush.keepOut(b)
  b.isMeeting = false
end

return meet
