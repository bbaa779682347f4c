--- Step 6, meet: contacts in the order of the moment at which they are met.
--
-- Every pair of neighbours that will meet on its present paths has one event in a queue. The first
-- one is resolved, which changes two paths; all pairs of those two are looked at again from that
-- moment on. Simultaneous events: faces before corners, pairs that have not been resolved in this
-- step before those that have, along gravity before across, supports first (from the floor up), then
-- the order of the world. Nothing of this depends on the order in which pairs were found.

local here = (...):match("^(.*)%.[^.]+$")
local approach = require(here .. ".approach")
local ask = require(here .. ".ask")
local columns = require(here .. ".columns")
local detect = require(here .. ".detect")
local predict = require(here .. ".predict")
local queue = require(here .. ".queue")
local resolve = require(here .. ".resolve")

local meet = {}

local floor, huge = math.floor, math.huge
local DYNAMIC = columns.DYNAMIC
local CORNER = approach.CORNER

-- Moments closer than this part of a step are simultaneous.
local MOMENTS = 1e9
local MOST_MET = 63

-- How firmly the one that supports a pair stands: what cannot give way first, then by how far down
-- it is (along gravity), so that a stack is resolved from the floor up.
local function supportOf(b, low, high, kl, kh, axis)
  if b.kind[low] ~= DYNAMIC or b.kind[high] ~= DYNAMIC or b.heldLow[kl] or b.heldHigh[kh] then
    return huge
  end
  if axis == b.downAxis and b.downSign < 0 then
    return -b.from[kl]
  end
  return b.from[kh] + b.size[kh]
end

-- Computes when pair p meets and puts that into the queue.
local function schedule(b, p)
  b.event[p] = 0
  if b.passing[p] then
    return
  end
  local one, other = b.pairA[p], b.pairB[p]
  local isSensor = b.sensor[one] or b.sensor[other]
  if isSensor and b.met[p] > 0 then
    return
  end
  local t, code = approach.test(b, one, other, p)
  if not t then
    return
  end
  local kind, axis, otherIsLow = approach.decode(code)
  local low, high = one, other
  if otherIsLow then
    low, high = other, one
  end
  local moment = floor(t * MOMENTS + 0.5)
  if kind == CORNER then
    moment = moment + 2
  end
  local met = b.met[p]
  local key = ((moment * 4 + kind) * 64 + (met < MOST_MET and met or MOST_MET)) * 2
  if axis ~= b.downAxis then
    key = key + 1
  end
  local support = supportOf(b, low, high, 2 * low + axis, 2 * high + axis, axis)
  b.event[p] = queue.push(b.queue, key, support, b.rank[low], b.rank[high], p, code, t)
end

local function scheduleAll(b, i)
  local half, nextHalf = b.head[i], b.next
  while half ~= 0 do
    schedule(b, (half + half % 2) / 2)
    half = nextHalf[half]
  end
end

-- First look at the pairs of those in awakeList from `first` on. A pair of two who are awake is
-- looked at from its first half-edge only.
local function scheduleNew(b, first)
  local list, head, nextHalf, other, awake = b.awakeList, b.head, b.next, b.other, b.awake
  for n = first, b.awakeCount do
    local half = head[list[n]]
    while half ~= 0 do
      if half % 2 == 1 or not awake[other[half]] then
        local p = (half + half % 2) / 2
        b.met[p], b.hit[p], b.passing[p] = 0, 0, false
        schedule(b, p)
      end
      half = nextHalf[half]
    end
  end
end

-- Looks again at everybody whose path has changed; a path that leaves its fat box may find new
-- neighbours and wake them.
local function followChanged(b, dt)
  for n = 1, b.changedCount do
    local i = b.changed[n]
    detect.follow(b, i)
  end
  local woken = b.predicted + 1
  if woken <= b.awakeCount then
    predict.run(b, dt)
    scheduleNew(b, woken)
  end
  for n = 1, b.changedCount do
    scheduleAll(b, b.changed[n])
  end
end

local function happen(b, p, code, t, dt)
  local _, axis, otherIsLow = approach.decode(code)
  local low, high = b.pairA[p], b.pairB[p]
  if otherIsLow then
    low, high = high, low
  end
  if not ask.permits(b, p, low, high, axis) then
    b.passing[p] = true
    return
  end
  if b.sensor[low] or b.sensor[high] then
    resolve.sense(b, p, low, high, axis, t, dt)
    return
  end
  b.changedCount = 0
  b.changeStamp = b.changeStamp + 1
  resolve.run(b, p, low, high, axis, t, dt)
  followChanged(b, dt)
end

--- Resolves all contacts of a step of dt s.
function meet.run(b, dt)
  local q, event = b.queue, b.event
  queue.clear(q)
  scheduleNew(b, 1)
  local id = queue.pop(q)
  local resolved = 0
  while id do
    local p = q.pair[id]
    if event[p] == id then
      event[p] = 0
      resolved = resolved + 1
      happen(b, p, q.code[id], q.time[id], dt)
    end
    id = queue.pop(q)
  end
  b.resolved = resolved
end

return meet
