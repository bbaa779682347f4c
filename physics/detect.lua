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

-- px around the path; few objects leave it in a step, and not too many are inside. (Boxes that lead
-- in the direction of motion were measured, too: no gain.)
local MARGIN = 4
-- A static object does not move: just enough to see what touches it.
local STATIC_MARGIN = 1

-- Takes apart the pairs whose fat boxes no longer meet. One in contact stays until that has ended,
-- one that was hit in this step until that has been told.
local function unlinkFar(b, i)
  local fatLow, fatHigh, other, nextHalf = b.fatLow, b.fatHigh, b.other, b.next
  local k = 2 * i
  local half = b.head[i]
  while half ~= 0 do
    local after = nextHalf[half]
    local m = 2 * other[half]
    local apart = max(
      max(fatLow[m] - fatHigh[k], fatLow[k] - fatHigh[m]),
      max(fatLow[m + 1] - fatHigh[k + 1], fatLow[k + 1] - fatHigh[m + 1])
    )
    if apart > 0 then
      local p = (half + half % 2) / 2
      if b.contact[p] == 0 and b.hit[p] == 0 and not b.overlapping[p] then
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

-- Links two whose fat boxes have come to meet, if they can meet at all.
local function link(b, i, j)
  if not filter.allows(b, i, j) then
    return
  end
  columns.link(b, i, j)
  -- A kinematic one that stands is a wall, which need not wake for a dynamic one.
  local matters = b.kind[j] == DYNAMIC or b.kind[i] ~= DYNAMIC
  if matters and not b.awake[j] and (b.awake[i] or b.kind[i] == STATIC) then
    rest.wake(b, j)
  end
end

-- Links those in `list[1..count]` with everybody whose fat boxes meet theirs.
local function linkNear(b, list, count)
  local askers, found, mark = b.askers, b.found, b.mark
  local n = b.broadphase:overlaps(list, count, askers, found)
  local asker, stamp = 0, 0
  for m = 1, n do
    local i, j = askers[m], found[m]
    if i ~= asker then
      asker, stamp = i, markNeighbours(b, i)
    end
    if mark[j] ~= stamp then
      mark[j] = stamp
      link(b, i, j)
    end
  end
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

--- Whether the path of an object leaves its fat box.
function detect.hasLeft(b, i)
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

local hasLeft = detect.hasLeft

local function enlarge(b, i)
  fatten(b, i)
  if b.placed[i] == 0 then
    b.broadphase:insert(i)
  else
    b.broadphase:update(i)
  end
  b.placed[i] = 2
end

-- Looks up the neighbours of those in `strays[1..count]`.
local function lookUp(b, strays, count)
  -- All boxes first, so that no pair is linked by a box that is out of date.
  for m = 1, count do
    enlarge(b, strays[m])
  end
  for m = 1, count do
    unlinkFar(b, strays[m])
  end
  if count > 0 then
    linkNear(b, strays, count)
  end
end

--- Looks up the neighbours of those in `list[first..last]` whose paths leave their fat boxes.
function detect.run(b, list, first, last)
  local strays, active, n = b.strays, b.active, 0
  for m = first, last do
    local i = list[m]
    if hasLeft(b, i) and active[i] then
      n = n + 1
      strays[n] = i
    end
  end
  lookUp(b, strays, n)
end

-- The same for those in `list[1..count]` who are in the world still.
local function runPresent(b, list, count)
  local kind, present, n = b.kind, b.present, 0
  for m = 1, count do
    if kind[list[m]] ~= 0 then
      n = n + 1
      present[n] = list[m]
    end
  end
  detect.run(b, present, 1, n)
end

--- Looks up the neighbours of whoever the game has placed, where it is now.
function detect.runMoved(b)
  runPresent(b, b.movedList, b.movedCount)
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

--- The masks of the world have changed: filters everybody anew, and finds whom they may meet now,
--- before `part` looks at those who are inside each other.
function detect.refilterAll(b)
  for i = 1, b.slots do
    if b.kind[i] ~= 0 then
      detect.refilter(b, i)
    end
  end
  runPresent(b, b.movers, b.moverCount)
end

return detect
