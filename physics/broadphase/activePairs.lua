--- Active pairs: lists from all pairs those with an awake body. They take part in a step.
--
-- They are listed anew only when a pair was made or ended, or a body woke or fell asleep. Pairs
-- that are linked in the middle of a step are appended (`columns.linkAll`).
--
-- Reads the pairs, awake; writes live and the step columns of the pairs.

local live = {}

-- Lists all pairs with an awake body. Slot 0, that of a free pair, is not awake.
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

local function reset(b)
  local live_, hit, pressed = b.live, b.hit, b.pressed
  for n = 1, b.liveCount do
    local p = live_[n]
    hit[p], pressed[p] = 0, 0
  end
end

--- Notes that more columns of a pair must be reset when the next step begins: whether it passes or
--- was nudged. Few pairs need that.
function live.stain(b, p)
  b.stainCount = b.stainCount + 1
  b.stained[b.stainCount] = p
end

-- Resets these columns.
local function clean(b)
  local stained, passing, nudged = b.stained, b.passing, b.nudged
  for n = 1, b.stainCount do
    local p = stained[n]
    passing[p], nudged[p] = false, 0
  end
  b.stainCount = 0
end

--- Lists the pairs with an awake body for a new step, and resets their step columns.
function live.list(b)
  clean(b)
  if b.liveLinks ~= b.links or b.liveAwakenings ~= b.awakenings then
    b.liveLinks, b.liveAwakenings = b.links, b.awakenings
    b.liveStamp, b.liveCount = b.liveStamp + 1, 0
    if b.awakeCount > 0 then
      list(b)
    end
  end
  reset(b)
end

return live
