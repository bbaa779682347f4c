--- Crowds: finds many bodies at one spot. No order of pushes could separate them in a few steps, so
-- they are laid out in columns (see crowdLayout.lua).
--
-- - A body is *crowded* if it shares its place with several others.
-- - Two crowded bodies are no pair: they pass through each other.
-- - A body leaves its crowd if it overlaps no other member and is further away than the crowd
--   needs.
--
-- So the work grows with the number of bodies, not of pairs.
--
-- `crowd` of a body is 0 or the slot of the body that leads its crowd. Reads from, size,
-- awakeList; writes crowd and crowdList.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local begin = require(root .. ".motion.begin")
local filter = require(root .. ".broadphase.filter")
local islands = require(root .. ".sleep.islands")
local pairFinder = require(root .. ".broadphase.pairFinder")
local sort = require(root .. ".memory.sort")

require(root .. ".memory.jit").file()

local crowd = {}

local DYNAMIC = columns.DYNAMIC
local sqrt = math.sqrt
local max, min = math.max, math.min
--- A body is crowded if its middle is inside this many others, or theirs in it.
local MANY = 4
-- Share of the smaller size by which two bodies may overlap without being in one crowd.
local SLACK = 1 / 8
-- Number of the next bodies in the order along x that are tested for being in the same crowd.
local LOOK = 16
-- Number of steps after which a crowd ends. What overlaps then is left to the contacts for a step;
-- where MANY still share a spot, a new crowd forms in the next one.
local LIFE = 60

-- Wakes the rest of each crowd with an awake body: they sleep together or not at all.
local function wake(b)
  local awake, crowd_, mark, stamp = b.awakeList, b.crowd, b.crowdMark, b.crowdStamp
  for n = 1, b.awakeCount do
    mark[crowd_[awake[n]]] = stamp
  end
  mark[0] = -1
  for n = 1, b.moverCount do
    local i = b.movers[n]
    if mark[crowd_[i]] == stamp and not b.awake[i] then
      islands.wake(b, i)
    end
  end
  begin.run(b)
end

-- Lists the bodies that may be crowded: they were in a crowd, were placed by the game, or were left
-- overlapping others. Returns how many there are.
local function listCandidates(b)
  local list, count = b.crowdList, 0
  local awake, crowd_, inside, moved = b.awakeList, b.crowd, b.inside, b.moved
  for n = 1, b.awakeCount do
    local i = awake[n]
    if crowd_[i] ~= 0 or inside[i] or moved[i] then
      if b.kind[i] == DYNAMIC and b.pushable[i] and not (b.sensor[i] or b.stuck[i]) then
        count = count + 1
        list[count] = i
      end
    end
  end
  return count
end

--- Returns twice the middle of a body on the axis of k.
function crowd.middle(b, k)
  return 2 * b.from[k] + b.size[k]
end

-- Sorts list[1..count] by crowd, then by x.
local function sortByX(b, list, count)
  local key, leaderRank, rank, crowd_ = b.crowdKey, b.leaderRank, b.rank, b.crowd
  for n = 1, count do
    local i = list[n]
    key[i] = crowd.middle(b, 2 * i)
    leaderRank[i] = crowd_[i] ~= 0 and rank[crowd_[i]] or -1
  end
  sort.by(list, count, leaderRank, key, rank)
end

-- Returns whether two bodies overlap on an axis by more than SLACK of the smaller size. Returns
-- also whether the middle of one is inside the other there.
local function compare(b, k, m)
  local apart, size, other = crowd.middle(b, k) - crowd.middle(b, m), b.size[k], b.size[m]
  apart = max(apart, -apart)
  return size + other - apart > 2 * SLACK * min(size, other), apart < max(size, other)
end

-- Returns whether two bodies that are near on x overlap and may meet, and whether they are at one
-- spot.
local function meets(b, i, j)
  local overlapsX, isCloseX = compare(b, 2 * i, 2 * j)
  local overlapsY, isCloseY = compare(b, 2 * i + 1, 2 * j + 1)
  if overlapsX and overlapsY and filter.allows(b, i, j) then
    return true, isCloseX and isCloseY
  end
  return false, false
end

-- Counts for each candidate, sorted by x, the others at its spot, up to MANY. A candidate at the
-- spot of a body that has enough of them has enough, too.
local function countShared(b, list, n, widest)
  local shared, key = b.shared, b.crowdKey
  for at = 1, n do
    shared[list[at]] = 0
  end
  for at = 1, n do
    local i, other = list[at], at + 1
    local last, left = key[i] + 2 * widest, LOOK
    while other <= n and key[list[other]] < last and (shared[i] < MANY or left > 0) do
      local j = list[other]
      left = left - 1
      local _, isClose = meets(b, i, j)
      if isClose then
        local more = (shared[i] >= MANY or shared[j] >= MANY) and MANY or 1
        shared[i], shared[j] = shared[i] + more, shared[j] + more
      end
      other = other + 1
    end
  end
end

-- Returns the leader of the crowd of a body.
local function leaderOf(leader, i)
  while leader[i] ~= i do
    i = leader[i]
  end
  return i
end

-- Makes one crowd of two. The first in the order of the world leads it.
local function unite(b, i, j)
  local one, two = leaderOf(b.leader, i), leaderOf(b.leader, j)
  if b.rank[two] < b.rank[one] then
    local first = two
    two = one
    one = first
  end
  b.leader[two] = one
end

-- Adds the candidates that share their spot with many to the crowd of those, or to a new one.
local function admit(b, list, n, widest)
  local crowd_, shared, leader, key = b.crowd, b.shared, b.leader, b.crowdKey
  for at = 1, n do
    local i = list[at]
    leader[i] = i
  end
  for at = 1, n do
    local i = list[at]
    for other = at + 1, shared[i] >= MANY and min(at + LOOK, n) or 0 do
      local j = list[other]
      if key[j] >= key[i] + 2 * widest then
        break
      elseif shared[j] >= MANY and meets(b, i, j) then
        unite(b, i, j)
      end
    end
  end
  for at = 1, n do
    local i = list[at]
    if shared[i] >= MANY then
      crowd_[i] = leaderOf(leader, i)
    end
  end
end

local function widestOf(b, list, first, last)
  local widest = 0.0
  for at = first, last do
    widest = max(widest, b.size[2 * list[at]])
  end
  return widest
end

-- Notes for each member of a crowd, sorted by x, whether it overlaps another one. Returns whether
-- any does.
local function findOverlaps(b, list, first, last)
  local overlapped, key, any = b.isOverlapped, b.crowdKey, false
  local reach = 2 * widestOf(b, list, first, last)
  for at = first, last do
    overlapped[list[at]] = false
  end
  for at = first, last do
    local i, other = list[at], at + 1
    while not overlapped[i] and other <= last and key[list[other]] < key[i] + reach do
      if meets(b, i, list[other]) then
        overlapped[i], overlapped[list[other]], any = true, true, true
      end
      other = other + 1
    end
    other = at - 1
    while not overlapped[i] and other >= first and key[list[other]] > key[i] - reach do
      if meets(b, i, list[other]) then
        overlapped[i] = true
      end
      other = other - 1
    end
  end
  return any
end

-- Takes a body out of its crowd. The members may become its neighbours then.
local function leave(b, i)
  b.crowd[i], b.crowdAge[2 * i], b.placed[i] = 0, 0, min(b.placed[i], 1)
end

-- Gives a crowd a new leader, in case the first one has left the world.
local function findLeader(b, list, first, last)
  local best = list[first]
  for at = first + 1, last do
    if b.rank[list[at]] < b.rank[best] then
      best = list[at]
    end
  end
  for at = first, last do
    b.crowd[list[at]] = best
  end
end

--- Calls `work` for each crowd in list[1..n], which is sorted by crowd, with its part
--- list[first..last].
function crowd.forEach(b, list, n, work)
  local first = 1
  for at = 1, n do
    if at == n or b.leaderRank[list[at + 1]] ~= b.leaderRank[list[first]] then
      work(b, list, first, at)
      first = at + 1
    end
  end
end

--- Returns the middle of a crowd, x and y, and the mean width and height of its members.
function crowd.measure(b, list, first, last)
  local x, y, width, height = 0.0, 0.0, 0.0, 0.0
  for at = first, last do
    local i = list[at]
    local k = 2 * i
    width, height = width + b.size[k], height + b.size[k + 1]
    x, y = x + b.from[k] + b.size[k] * 0.5, y + b.from[k + 1] + b.size[k + 1] * 0.5
  end
  local n = last - first + 1
  return x / n, y / n, width / n, height / n
end

-- Takes bodies out of a crowd that overlap no other member and are further from its middle than the
-- crowd needs.
local function dropFar(b, list, first, last)
  local x, y, width, height = crowd.measure(b, list, first, last)
  local reach = sqrt((last - first + 1) * width * height)
  for at = first, last do
    local i = list[at]
    local farX, farY = crowd.middle(b, 2 * i) * 0.5 - x, crowd.middle(b, 2 * i + 1) * 0.5 - y
    if not b.isOverlapped[i] and max(farX, -farX, farY, -farY) > reach then
      leave(b, i)
    end
  end
end

-- Ends a crowd in which no two bodies overlap, or that has existed for more than LIFE steps.
local function review(b, list, first, last)
  local age = b.crowdAge
  for at = first, last do
    age[2 * list[at]] = age[2 * list[at]] + 1
  end
  if findOverlaps(b, list, first, last) and age[2 * list[first]] <= LIFE then
    findLeader(b, list, first, last)
    dropFar(b, list, first, last)
  else
    for at = first, last do
      leave(b, list[at])
    end
  end
end

-- Keeps the bodies of list[1..n] that are in a crowd. Returns how many there are.
local function keepCrowded(b, list, n)
  local kept = 0
  for at = 1, n do
    if b.crowd[list[at]] ~= 0 then
      kept = kept + 1
      list[kept] = list[at]
    end
  end
  return kept
end

-- Makes new crowds of the candidates that are at one spot.
local function findNew(b, list, n)
  local new, key, count = b.crowdNew, b.crowdKey, 0
  for at = 1, n do
    local i = list[at]
    if b.crowd[i] == 0 then
      count = count + 1
      new[count], key[i] = i, crowd.middle(b, 2 * i)
    end
  end
  if count > MANY then
    sort.by(new, count, key, b.rank, b.rank)
    local widest = widestOf(b, new, 1, count)
    countShared(b, new, count, widest)
    admit(b, new, count, widest)
  end
end

--- Finds the crowded bodies at the start of the step.
function crowd.mark(b)
  b.crowdCount, b.crowdStamp = 0, b.crowdStamp + 1
  if not (b.hasInside or b.hasCrowds or b.movedCount > 0) then
    return
  end
  if b.hasCrowds then
    wake(b)
  end
  local list = b.crowdList
  local n = listCandidates(b)
  if n == 0 then
    return
  end
  findNew(b, list, n)
  n = keepCrowded(b, list, n)
  sortByX(b, list, n)
  crowd.forEach(b, list, n, review)
  b.crowdCount = keepCrowded(b, list, n)
  if b.crowdCount < n then
    pairFinder.run(b, b.awakeList, 1, b.awakeCount) -- what has left a crowd has neighbours now
  end
  b.hasCrowds = b.hasCrowds or b.crowdCount > 0
end

return crowd
