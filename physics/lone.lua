--- Step 6, meet: hits of two who bounce off each other while nobody else has to do with them.
--
-- Where boxes fly about, most hits are of this kind: neither of the two, nor any neighbour of
-- theirs, meets anybody else in this step. One by one, in the order of their moments, each of them
-- goes through the queue and is looked after; here all are resolved at once, in a few short loops.
-- In the end nothing depends on the order of events that have nothing to do with each other.
--
-- It may turn out that somebody does come near such a pair before its moment: whoever is hit in
-- the queue later on may have such a neighbour. Then the hit is taken back (`undoNear`), both go on
-- as if it had not been looked at, and it happens in the queue like all others. To the same bits: a
-- property spec plays random games both ways.
--
-- Only what is simple in every way is resolved here, as `resolve` would do it. What both have in
-- common is written out, because the trace compiler gives up functions that interpreted ones call.
--
-- Reads near, nearTime, nearCode, the queue, met and what the step has left in slots; writes from,
-- to, speed, time, met, hit, hitSpeed, follows, changes, `changed`, meetings, loneOf and b.lone.

local here = (...):match("^(.*)%.[^.]+$")
local approach = require(here .. ".approach")
local columns = require(here .. ".columns")
local interpreted = require(here .. ".interpreted")
local path = require(here .. ".path")
local press = require(here .. ".press")
local queue = require(here .. ".queue")

local lone = {}

local DYNAMIC, GIVES = columns.DYNAMIC, columns.GIVES
local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
local coefficient = press.coefficient

-- Codes of meetings from this one on are those of two inside each other.
local DEEP = approach.code(approach.DEEP, 0, false)
-- Numbers that are kept of each hit, to take it back.
local KEPT = 8

--- Returns the scratch of a world.
function lone.new()
  return {
    latest = 0, -- the last moment of all that were resolved; 0: none
    pairs = {}, -- pairs that meet, as far as is known
    meeting = {}, -- who is in those, two for each
    meetingCount = 0,
    places = {}, -- where they stand in `near`; then only those that may be resolved
    count = 0, -- resolved
    pair = {}, -- by hit: the pair,
    low = {}, -- the index of the one with the smaller coordinate, on the axis of the hit,
    high = {}, -- and of the other,
    moment = {},
    speed = {}, -- at which they met,
    lost = {}, -- closing speed that was taken from them, until the end of the step,
    way = {}, -- by which they are moved apart, px,
    kept = {}, -- and what was before
    disturbed = {},
  }
end

-- Lists the pairs that meet, of the `count` ones in `near`; returns how many there are, and the
-- first moment of all.
local function listHits(b, work, count)
  local near, times, codes, pairs_, places = b.near, b.nearTime, b.nearCode, work.pairs, work.places
  local n, first = 0, 1
  for m = 1, count do
    if codes[m] >= 0 then
      n, first = n + 1, min(first, times[m])
      pairs_[n], places[n] = near[m], m
    end
  end
  return n, first
end

-- Lists those that are in the queue behind them; returns how many there are then. Of pairs that
-- have come apart since (slot 0), events may still be there.
local function listQueued(b, q, work, count)
  local pairs_, pairA = work.pairs, b.pairA
  for n = 1, q.size do
    local p = queue.read(q, q.heap[n])
    if pairA[p] ~= 0 then
      count = count + 1
      pairs_[count] = p
    end
  end
  return count
end

-- Counts how many others each of those meets who are in the first `count` pairs.
local function countHits(b, work, count)
  local pairs_, meeting, meetings = work.pairs, work.meeting, b.meetings
  local pairA, pairB, kind = b.pairA, b.pairB, b.kind
  for n = 1, count do
    local i, j = pairA[pairs_[n]], pairB[pairs_[n]]
    meeting[2 * n - 1], meeting[2 * n] = i, j
    meetings[i] = meetings[i] + GIVES[kind[i]]
    meetings[j] = meetings[j] + GIVES[kind[j]]
  end
  work.meetingCount = 2 * count
end

-- Forgets that. (Not by the pairs: some may be others by then.)
local function forgetHits(b, work)
  local meeting, meetings = work.meeting, b.meetings
  for n = 1, work.meetingCount do
    meetings[meeting[n]] = 0
  end
end

-- Keeps those of places[1..count] where both meet nobody else, are still on the paths that they
-- began the step with, and bump in the simplest way; returns how many.
local function keepSingle(b, work, count)
  local places, near, codes, pairA, pairB = work.places, b.near, b.nearCode, b.pairA, b.pairB
  local meetings, time, met, choosy, canCollide = b.meetings, b.time, b.met, b.choosy, b.canCollide
  local n = 0
  for m = 1, count do
    local at = places[m]
    local p = near[at]
    local i, j = pairA[p], pairB[p]
    if
      max(meetings[i], meetings[j]) <= 1
      and codes[at] < DEEP
      and time[i] + time[j] + met[p] == 0
      and not (choosy[i] or choosy[j] or canCollide[i] or canCollide[j])
      and coefficient(b, i, j) <= 0
    then
      n = n + 1
      places[n] = at
    end
  end
  return n
end

-- What holds slot i, rubs it, or moves with it; 0: nothing.
local function ties(b, i)
  local low, high, weld, k = b.heldLow, b.heldHigh, b.weld, 2 * i
  return low[k]
    + low[k + 1]
    + high[k]
    + high[k + 1]
    + weld[k]
    + weld[k + 1]
    + b.stuck[i]
    + b.grip[i]
end

-- Of these, keeps those whom nobody holds.
local function keepFree(b, work, count)
  local places, near, pairA, pairB, n = work.places, b.near, b.pairA, b.pairB, 0
  for m = 1, count do
    local p = near[places[m]]
    if ties(b, pairA[p]) + ties(b, pairB[p]) == 0 then
      n = n + 1
      places[n] = places[m]
    end
  end
  return n
end

-- Notes the hits at places[1..count]: who is low, who is high, and when.
local function aim(b, work, count)
  local places, near, times, codes, pairA, pairB =
    work.places, b.near, b.nearTime, b.nearCode, b.pairA, b.pairB
  local pair, lows, highs, moments = work.pair, work.low, work.high, work.moment
  for m = 1, count do
    local at = places[m]
    local p, code = near[at], codes[at]
    local second = code % 2 -- 1: the second of the pair is the low one
    local axis = (code - second) * 0.5 % 2
    local i, j = pairA[p], pairB[p]
    local between = (j - i) * second
    pair[m], moments[m] = p, times[at]
    lows[m], highs[m] = 2 * (i + between) + axis, 2 * (j - between) + axis
  end
end

-- Of the hits that were noted, keeps those after which the two part (see `impact.at` and
-- `impact.rebound`): with their speeds and the way apart. Returns how many. No branches: each is
-- written behind the list, which gets longer by 0 or 1.
local function keepBounces(b, work, count, dt)
  local pair, lows, highs, moments = work.pair, work.low, work.high, work.moment
  local speeds, lost, ways, places = work.speed, work.lost, work.way, work.places
  local to, size, speed, accel, drive = b.to, b.size, b.speed, b.accel, b.drive
  local restitution, n = b.restitution, 0
  for m = 1, count do
    local kl, kh = lows[m], highs[m]
    local o, v, a = to[kl] + size[kl] - to[kh], speed[kl] - speed[kh], accel[kl] - accel[kh]
    local square = v * v - 2 * a * o
    local u = sqrt(max(square, 0))
    local tau = max(min(2 * o / (v + u), dt), 0)
    a = drive[kl] - drive[kh]
    local e = max(restitution[floor(kl * 0.5)], restitution[floor(kh * 0.5)])
    local gap, vEnd = e * u * tau - a * tau * tau * 0.5, a * tau - e * u
    pair[n + 1], lows[n + 1], highs[n + 1], moments[n + 1] = pair[m], kl, kh, moments[m]
    speeds[n + 1], lost[n + 1], ways[n + 1], places[n + 1] = u, v - vEnd, o + gap, places[m]
    if v > 0 and square > 0 and u > 2 * a * dt and e > 0 and gap >= 0 and vEnd < 0 then
      n = n + 1
    end
  end
  return n
end

-- Keeps what hits change, for the first `count` of them.
local function keep(b, work, count)
  local kept, lows, highs, at = work.kept, work.low, work.high, 0
  local from, to, speed = b.from, b.to, b.speed
  for m = 1, count do
    local kl, kh = lows[m], highs[m]
    local i, j = 2 * floor(kl * 0.5), 2 * floor(kh * 0.5)
    kept[at + 1], kept[at + 2], kept[at + 3], kept[at + 4] =
      from[i], from[i + 1], from[j], from[j + 1]
    kept[at + 5], kept[at + 6], kept[at + 7], kept[at + 8] = to[kl], to[kh], speed[kl], speed[kh]
    at = at + KEPT
  end
end

-- Begins the paths of those who are low, or high, anew where they are when they are hit (see
-- `path.advance`).
local function advance(b, list, moments, count)
  local from, to, time, kind = b.from, b.to, b.time, b.kind
  for m = 1, count do
    local i, t = floor(list[m] * 0.5), moments[m]
    if kind[i] == DYNAMIC then
      local k = 2 * i
      from[k] = from[k] + (to[k] - from[k]) * t
      from[k + 1] = from[k + 1] + (to[k + 1] - from[k + 1]) * t
      time[i] = t
    end
  end
end

-- Lets them part: where they come to, and how fast they are then.
local function rebound(b, work, count)
  local lows, highs, lost, ways = work.low, work.high, work.lost, work.way
  local to, speed, inverseMass = b.to, b.speed, b.inverseMass
  for m = 1, count do
    local kl, kh, way, dv = lows[m], highs[m], ways[m], lost[m]
    local wl, wh = inverseMass[floor(kl * 0.5)], inverseMass[floor(kh * 0.5)]
    local shareL, shareH = wl / (wl + wh), wh / (wl + wh)
    to[kl], to[kh] = to[kl] - way * shareL, to[kh] + way * shareH
    speed[kl], speed[kh] = speed[kl] - dv * shareL, speed[kh] + dv * (1 - shareL)
  end
end

-- Notes that the pairs have been hit, on which side of their first and how fast, and that they are
-- not met as `near` says.
local function note(b, work, count)
  local pair, lows, speeds, places = work.pair, work.low, work.speed, work.places
  local met, hit, hitSpeed, pairA, codes = b.met, b.hit, b.hitSpeed, b.pairA, b.nearCode
  local latest, moments = 0, work.moment
  for m = 1, count do
    local p, kl = pair[m], lows[m]
    local apart, axis = floor(kl * 0.5) - pairA[p], kl % 2
    met[p], hit[p] = 1, 2 * axis + 2 - min(max(apart, -apart), 1)
    hitSpeed[p], codes[places[m]] = speeds[m], -1
    latest = max(latest, moments[m])
  end
  work.count, work.latest = count, latest
end

-- Notes that the paths of those who are low, or high, have changed (see `path.change`).
local function change(b, list, count)
  local changed, mark, stamp, changedCount = b.changed, b.changedMark, b.changeStamp, b.changedCount
  local kind, follows, changes, loneOf = b.kind, b.follows, b.changes, b.loneOf
  for m = 1, count do
    local i = floor(list[m] * 0.5)
    if kind[i] == DYNAMIC then
      local k = 2 * i
      changes[k], changes[k + 1], follows[i] = changes[k] + 1, changes[k + 1] + 1, 0
      changedCount = changedCount + 1
      mark[i], changed[changedCount], loneOf[i] = stamp, i, m
    end
  end
  b.changedCount = changedCount
end

--- Resolves those hits with which nobody else has to do, as far as is known, of the `count` pairs
--- in b.near (see `approach`), in a step of dt s: nearCode is -1 for them then. Returns whether any
--- pair is met at all; whose path has changed is in b.changed[1..b.changedCount], and
--- `undoDisturbed` must follow.
function lone.resolve(b, count, dt)
  if not b.hasBounces or b.hasBacked or b.pushFirst or b.worldCanCollide then
    return false
  end
  local work = b.lone
  local hits, earliest = listHits(b, work, count)
  if hits == 0 or earliest <= 0 then
    return false
  end
  countHits(b, work, listQueued(b, b.queue, work, hits))
  local n = keepFree(b, work, keepSingle(b, work, hits))
  aim(b, work, n)
  n = keepBounces(b, work, n, dt)
  keep(b, work, n)
  advance(b, work.low, work.moment, n)
  advance(b, work.high, work.moment, n)
  rebound(b, work, n)
  note(b, work, n)
  path.startChanges(b)
  change(b, work.low, n)
  change(b, work.high, n)
  b.resolved = b.resolved + n
  return true
end

-- Takes the m-th hit back: both are on their old paths again, and that is a change.
local function undo(b, m)
  local work, kept, at = b.lone, b.lone.kept, (m - 1) * KEPT
  local from, to, speed = b.from, b.to, b.speed
  local p, kl, kh = work.pair[m], work.low[m], work.high[m]
  work.moment[m] = 0
  local i, j = (kl - kl % 2) / 2, (kh - kh % 2) / 2
  from[2 * i], from[2 * i + 1], from[2 * j], from[2 * j + 1] =
    kept[at + 1], kept[at + 2], kept[at + 3], kept[at + 4]
  to[kl], to[kh], speed[kl], speed[kh] = kept[at + 5], kept[at + 6], kept[at + 7], kept[at + 8]
  b.time[i], b.time[j], b.met[p], b.hit[p] = 0, 0, 0, 0
  b.resolved = b.resolved - 1
  path.change(b, i)
  path.change(b, j)
end

-- Lists those whose path has changed and who have a neighbour, but for the one that they have hit,
-- who meets somebody; returns how many.
local function listDisturbed(b, work)
  local changed, count, head, nextHalf, other = b.changed, b.changedCount, b.head, b.next, b.other
  local meetings, loneOf, pair, disturbed, n = b.meetings, b.loneOf, work.pair, work.disturbed, 0
  changed[count + 1], head[0] = 0, 0
  local m, half = 1, head[changed[1]]
  while m <= count do
    if half == 0 then
      m = m + 1
      half = head[changed[m]]
    else
      local i = changed[m]
      if meetings[other[half]] > 0 and floor(half * 0.5 + 0.5) ~= pair[loneOf[i]] then
        n = n + 1
        disturbed[n] = i
      end
      half = nextHalf[half]
    end
  end
  return n
end

--- Takes those hits back with which others have to do, as is known when all who were changed by
--- `resolve` have their new neighbours. Whoever stands in awakeList from place `first` on was woken
--- by that, and may meet anybody.
function lone.undoDisturbed(b, first)
  local work, meetings = b.lone, b.meetings
  for n = first, b.awakeCount do
    meetings[b.awakeList[n]] = 1
  end
  for n = 1, listDisturbed(b, work) do
    local i = work.disturbed[n]
    if b.time[i] > 0 then
      undo(b, b.loneOf[i])
    end
  end
  for n = first, b.awakeCount do
    meetings[b.awakeList[n]] = 0
  end
  forgetHits(b, work)
end

-- Whether slot i is on the path that its lone hit has led to.
local function isAfterHit(b, i)
  local work, m = b.lone, b.loneOf[i]
  return m > 0
    and m <= work.count
    and work.moment[m] == b.time[i]
    and (floor(work.low[m] * 0.5) == i or floor(work.high[m] * 0.5) == i)
end

-- Takes the hits of the neighbours of slot i back that are later than now.
local function undoAround(b, i)
  local half = b.head[i]
  while half ~= 0 do
    local j = b.other[half]
    if b.time[j] > b.now and isAfterHit(b, j) then
      undo(b, b.loneOf[j])
    end
    half = b.next[half]
  end
end

--- Takes the hits back that are later than now, of all who are neighbours of those whose path has
--- changed, and of those in awakeList from place `first` on. Who was hit is on the list of changes
--- then; returns whether there are any.
function lone.undoNear(b, first)
  local before, n = b.changedCount, 1
  while n <= b.changedCount do
    undoAround(b, b.changed[n])
    n = n + 1
  end
  for m = first, b.awakeCount do
    undoAround(b, b.awakeList[m])
  end
  return b.changedCount > before
end

-- These lead from loop to loop, or are about single ones.
interpreted.functions(
  listQueued,
  lone.resolve,
  undo,
  isAfterHit,
  lone.undoDisturbed,
  undoAround,
  lone.undoNear
)

return lone
