--- The pairs that take part in a step: those of whoever is awake.
--
-- They are listed anew only when a pair or somebody awake came or went. Pairs that are linked in
-- the middle of a step join at the end (`columns.linkAll`).
--
-- Reads the pairs, awake; writes live and the step columns of the pairs.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")

local live = {}

local NO_EVENT = columns.NO_EVENT

-- Lists all pairs of somebody who is awake. Slot 0, that of a free pair, is not.
local function list(b)
  local live_, mark, stamp, count = b.live, b.liveMark, b.liveStamp, 0
  local pairA, pairB, awake = b.pairA, b.pairB, b.awake
  for p = 1, b.pairSlots do
    if awake[pairA[p]] or awake[pairB[p]] then
      count = count + 1
      live_[count] = p
      mark[p] = stamp
    end
  end
  b.liveCount = count
end

-- Nothing has happened to the pairs from place `first` of the list on.
local function reset(b, first)
  local live_, met, hit, turn = b.live, b.met, b.hit, b.turn
  for n = first, b.liveCount do
    local p = live_[n]
    met[p], hit[p], turn[p] = 0, 0, 0
  end
end

--- Notes that more of a pair must be forgotten when the next step begins: whether it passes, was
--- nudged or is settled, which few are.
function live.stain(b, p)
  b.stainCount = b.stainCount + 1
  b.stained[b.stainCount] = p
end

-- Forgets it.
local function clean(b)
  local stained, passing, nudged, settled = b.stained, b.passing, b.nudged, b.settled
  for n = 1, b.stainCount do
    local p = stained[n]
    passing[p], nudged[p], settled[p] = false, 0, 0
  end
  b.stainCount = 0
end

-- Forgets the events of all pairs. A step that has come to its end has left none.
local function forgetEvents(b)
  local event, waits = b.event, b.waits
  for p = 1, b.pairSlots do
    event[p], waits[p] = NO_EVENT, 0
  end
end

--- Lists the pairs of everybody in awakeList, for a new step.
function live.list(b)
  if b.isMeeting then
    forgetEvents(b) -- the last step was given up on its way
  end
  clean(b)
  if b.liveLinks ~= b.links or b.liveAwakenings ~= b.awakenings then
    b.liveLinks, b.liveAwakenings = b.links, b.awakenings
    b.liveStamp, b.liveCount = b.liveStamp + 1, 0
    if b.awakeCount > 0 then
      list(b)
    end
  end
  reset(b, 1)
end

--- Notes that a pair may touch at the very beginning of the step, though it did not when that was
--- looked for.
function live.touch(b, p)
  if b.touches[p] == 0 then
    b.touchCount = b.touchCount + 1
    b.touchList[b.touchCount], b.touches[p] = p, 1
  end
end

--- Adds the pairs of those in awakeList from place `first` on, who have been woken in the step.
function live.add(b, first)
  local live_, mark, stamp, from = b.live, b.liveMark, b.liveStamp, b.liveCount + 1
  local touches = b.touches
  for n = first, b.awakeCount do
    local half = b.head[b.awakeList[n]]
    while half ~= 0 do
      local p = (half + half % 2) / 2
      if mark[p] ~= stamp then
        mark[p], touches[p], b.liveCount = stamp, 0, b.liveCount + 1
        live_[b.liveCount] = p
      end
      half = b.next[half]
    end
  end
  reset(b, from)
  for n = from, b.liveCount do
    live.touch(b, live_[n])
  end
end

return live
