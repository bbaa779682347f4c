--- Step 5, detect: all pairs whose paths may meet.
--
-- Each object has a fat box: the hull of its path plus a margin. Two objects whose fat boxes meet
-- are neighbours, a pair. As long as a path stays inside the fat box, the neighbours stay the same
-- and nothing is looked up. A larger set of neighbours changes no result, since each pair is tested
-- exactly later on; so broad phases and margins may differ, the bits do not.
--
-- Reads from, to, size; writes fatLow, fatHigh and the pairs.

local here = (...):match("^(.*)%.[^.]+$")
local columns = require(here .. ".columns")
local filter = require(here .. ".filter")
local rest = require(here .. ".rest")

local detect = {}

local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local max, min = math.max, math.min

-- px around the path; few objects leave it in a step, and not too many are inside.
local MARGIN = 4
-- A static object does not move: just enough to see what touches it.
local STATIC_MARGIN = 1

-- Takes apart the pairs whose fat boxes no longer meet. One in contact stays until that has ended.
local function unlinkFar(b, i)
  local fatLow, fatHigh, other, nextHalf = b.fatLow, b.fatHigh, b.other, b.next
  local k = 2 * i
  local half = b.head[i]
  while half ~= 0 do
    local after = nextHalf[half]
    local m = 2 * other[half]
    if
      fatLow[m] > fatHigh[k]
      or fatHigh[m] < fatLow[k]
      or fatLow[m + 1] > fatHigh[k + 1]
      or fatHigh[m + 1] < fatLow[k + 1]
    then
      local p = (half + half % 2) / 2
      if b.contact[p] == 0 and not b.overlapping[p] then
        columns.unlink(b, p)
      end
    end
    half = after
  end
end

-- Marks the neighbours of an object, so that they are not linked twice.
local function markNeighbours(b, i)
  b.stamp = b.stamp + 1
  local stamp, mark, other, nextHalf = b.stamp, b.mark, b.other, b.next
  mark[i] = stamp
  local half = b.head[i]
  while half ~= 0 do
    mark[other[half]] = stamp
    half = nextHalf[half]
  end
  return stamp
end

-- Links an object with everybody whose fat box meets its own; returns how many were new.
local function linkNear(b, i)
  local k = 2 * i
  local found, mark = b.found, b.mark
  local fatLow, fatHigh = b.fatLow, b.fatHigh
  local n = b.broadphase:query(fatLow[k], fatLow[k + 1], fatHigh[k], fatHigh[k + 1], found)
  local stamp = markNeighbours(b, i)
  local new = 0
  for m = 1, n do
    local j = found[m]
    if mark[j] ~= stamp and filter.allows(b, i, j) then
      columns.link(b, i, j)
      new = new + 1
      if b.kind[j] == DYNAMIC and not b.awake[j] and (b.awake[i] or b.kind[i] == STATIC) then
        rest.wake(b, j)
      end
    end
  end
  return new
end

local function fatten(b, i)
  local from, to, size, fatLow, fatHigh = b.from, b.to, b.size, b.fatLow, b.fatHigh
  local margin = b.kind[i] == STATIC and STATIC_MARGIN or MARGIN
  local k = 2 * i
  fatLow[k] = min(from[k], to[k]) - margin
  fatHigh[k] = max(from[k], to[k]) + size[k] + margin
  k = k + 1
  fatLow[k] = min(from[k], to[k]) - margin
  fatHigh[k] = max(from[k], to[k]) + size[k] + margin
end

local function hasLeft(b, i)
  local from, to, size, fatLow, fatHigh = b.from, b.to, b.size, b.fatLow, b.fatHigh
  local k = 2 * i
  return b.placed[i] ~= 2
    or from[k] < fatLow[k]
    or to[k] < fatLow[k]
    or from[k] + size[k] > fatHigh[k]
    or to[k] + size[k] > fatHigh[k]
    or from[k + 1] < fatLow[k + 1]
    or to[k + 1] < fatLow[k + 1]
    or from[k + 1] + size[k + 1] > fatHigh[k + 1]
    or to[k + 1] + size[k + 1] > fatHigh[k + 1]
end

local function enlarge(b, i)
  fatten(b, i)
  if b.placed[i] == 0 then
    b.broadphase:insert(i)
  else
    b.broadphase:update(i)
  end
  b.placed[i] = 2
end

--- Looks up the neighbours of an object anew if its path leaves its fat box; returns how many new
--- ones there are.
function detect.follow(b, i)
  if not b.active[i] or not hasLeft(b, i) then
    return 0
  end
  enlarge(b, i)
  unlinkFar(b, i)
  return linkNear(b, i)
end

--- Looks up the neighbours of those in awakeList from `first` to `last`.
function detect.run(b, first, last)
  local list, strays, n = b.awakeList, b.strays, 0
  for m = first, last do
    if hasLeft(b, list[m]) then
      n = n + 1
      strays[n] = list[m]
    end
  end
  -- All boxes first, so that no pair is linked by a box that is out of date.
  for m = 1, n do
    enlarge(b, strays[m])
  end
  for m = 1, n do
    unlinkFar(b, strays[m])
    linkNear(b, strays[m])
  end
end

--- Looks up the neighbours of whoever the game has placed, where it is now.
function detect.runMoved(b)
  local list = b.movedList
  for n = 1, b.movedCount do
    local i = list[n]
    if b.kind[i] ~= 0 and b.active[i] then
      detect.follow(b, i)
    end
  end
end

--- Takes an object out: no neighbours, not in the broad phase.
function detect.remove(b, i)
  local half = b.head[i]
  while half ~= 0 do
    local after = b.next[half]
    columns.unlink(b, (half + half % 2) / 2)
    half = after
  end
  if b.placed[i] ~= 0 then
    b.broadphase:remove(i)
    b.placed[i] = 0
  end
end

--- What an object can meet has changed, or its size: forgets the neighbours it can no longer have,
--- and has the others looked up anew. Contacts must have been ended before.
function detect.refilter(b, i)
  if not b.active[i] then
    detect.remove(b, i)
    rest.drop(b, i)
    return
  end
  local half = b.head[i]
  while half ~= 0 do
    local after = b.next[half]
    if not filter.allows(b, i, b.other[half]) then
      columns.unlink(b, (half + half % 2) / 2)
    end
    half = after
  end
  b.placed[i] = min(b.placed[i], 1)
end

--- The masks of the world have changed: filters everybody anew.
function detect.refilterAll(b)
  for i = 1, b.slots do
    if b.kind[i] ~= 0 then
      detect.refilter(b, i)
    end
  end
end

return detect
