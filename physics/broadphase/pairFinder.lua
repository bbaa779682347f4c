---@diagnostic disable
--- Pair finder: computes from the paths of bodies all pairs that may meet, and which of them take
--- part in a step.
--
-- Each object has a fat box: the hull of its path plus a margin. Two objects are neighbours, a
-- pair, if their fat boxes meet. As long as a path stays inside the fat box, the neighbours stay
-- the same, and nothing is looked up. A larger set of neighbours changes no result, since each
-- pair is tested exactly later on. So broad phases and margins may differ, the bits do not.
--
-- Members of a crowd are no pairs with each other. In worlds with round bodies, fat boxes are
-- larger by half of REACH on all sides.
--
-- Reads the paths, size, awakeAt, and `contact`, `hit`, `touches` of pairs; writes fat boxes,
-- `placed` (see layout), the pairs, live and the step columns of the pairs, and `support` where
-- that has ended.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local constants = require(root .. ".memory.constants")
local filter = require(root .. ".broadphase.filter")
local grid = require(root .. ".broadphase.grid")
local islands = require(root .. ".sleep.islands")
local links = require(root .. ".memory.links")

local pairFinder = {}

local STATIC, DYNAMIC = constants.STATIC, constants.DYNAMIC
local contact = grid.contact
local floor, max, min = math.floor, math.max, math.min

-- Margin around a path, px, and around a static object, which does not move.
local MARGIN = 1
-- A fat box reaches AHEAD steps further in the direction of motion, but no more than FARTHEST px.
-- Few objects leave it in that time. An object with `hits` meets few others, and may reach further.
local AHEAD, FARTHEST, FARTHEST_AIMED = 10.0, 8.0, 64.0

-- Value of `placed` of the first stray is one more than this (below 0 for all).
local STRAYS = -2 ^ 30
-- Value of `place` of a pair that is listed to be unlinked.
local LEAVING = 2

--- px: the pairs of round bodies that are as near as that are known when slanted contacts are
--- looked for. (Otherwise which are known depends on the past.)
pairFinder.REACH = 1.5

-- Lists in b.pairList the pairs of the bodies in strays[1..count] with fat boxes that no longer
-- meet. Returns how many there are. A pair stays until its contact has ended, and until its hit in
-- this step has been told.
local function listParted(b, strays, count)
  local fatLow, fatHigh, nextHalf, pairA, pairB = b.fatLow, b.fatHigh, b.next, b.pairA, b.pairB
  local parted, head, place, n = b.pairList, b.head, b.place, 0
  strays[count + 1], head[0] = 0, 0
  local m, half = 1, head[strays[1]]
  while m <= count do
    if half == 0 then
      m = m + 1
      half = head[strays[m]]
    else
      local p = floor(half * 0.5 + 0.5)
      if contact(fatLow, fatHigh, 2 * pairA[p], 2 * pairB[p]) < 0 then
        local isNeeded = b.contact[p] ~= 0 or b.hit[p] ~= 0 or b.touches[p] ~= 0
        if not (isNeeded or place[p] == LEAVING) then
          n = n + 1
          parted[n], place[p] = p, LEAVING
        end
      end
      half = nextHalf[half]
    end
  end
  return n
end

-- Marks the neighbours of an object, so that they are not linked twice.
local function markNeighbours(b, i)
  b.stamp = b.stamp + 1
  local stamp, mark = b.stamp, b.mark
  for _, j in links.neighbours(b, i) do
    mark[j] = stamp
  end
  return stamp
end

-- Lists in b.linkOne and b.linkOther the found pairs that can meet and are no neighbours yet, each
-- once: of two strays, the earlier one counts. Returns how many there are.
local function listNew(b, count)
  local askers, found, mark, placed, crowd = b.broadphase.askers, b.found, b.mark, b.placed, b.crowd
  local ones, others, asker, stamp, at, n = b.linkOne, b.linkOther, 0, 0, 0, 0
  for m = 1, count do
    local i, j = askers[m], found[m]
    if i ~= asker then
      asker, stamp, at = i, markNeighbours(b, i), placed[i]
    end
    local isNew = mark[j] ~= stamp and placed[j] > at
    local isCrowd = min(crowd[2 * i], crowd[2 * j]) > 0
    if isNew and not isCrowd and not filter.reason(b, i, j) then
      n = n + 1
      ones[n], others[n] = i, j
    end
  end
  return n
end

-- Wakes bodies that have a new neighbour. A kinematic body that stands is a wall, and need not wake
-- for a dynamic neighbour.
local function wakeLinked(b, count)
  local ones, others, awakeAt, kind = b.linkOne, b.linkOther, b.awakeAt, b.kind
  for n = 1, count do
    local i, j = ones[n], others[n]
    local matters = kind[j] == DYNAMIC or kind[i] ~= DYNAMIC
    if matters and awakeAt[j] == 0 and (awakeAt[i] > 0 or kind[i] == STATIC) then
      islands.wake(b, j)
    elseif kind[j] == STATIC and awakeAt[i] == 0 then
      islands.wake(b, i)
    end
  end
end

-- Computes the fat box on the axis of k, with a margin. It includes the place where the step began,
-- since the path may end there, too.
local function fatten(b, k, farthest, margin, steps)
  local start, from, to, size = b.position[k], b.from[k], b.to[k], b.size[k]
  local ahead = max(min((to - from) * steps, farthest), -farthest)
  b.fatLow[k] = min(start, from, to) - margin + min(ahead, 0)
  b.fatHigh[k] = max(start, from, to) + size + margin + max(ahead, 0)
end

-- Gives the bodies in strays[1..count] fat boxes around their present paths.
local function enlarge(b, strays, count, margin)
  local broadphase, hitsOnly, turn = b.broadphase, b.hitsOnly, 1 + b.stamp % 96
  for m = 1, count do
    local i = strays[m]
    local farthest = hitsOnly[i] and FARTHEST_AIMED or FARTHEST
    local steps = AHEAD * (0.6 + i * turn % 97 / 120) -- so that not all leave them at once
    fatten(b, 2 * i, farthest, margin, steps)
    fatten(b, 2 * i + 1, farthest, margin, steps)
    broadphase:put(i)
  end
end

-- Static bodies meet no static bodies. If there are more strays than bodies that can move, some
-- strays are static; then all bodies that can move are asked instead. Puts these into `strays`, and
-- returns how many they are.
local function askMovers(b, strays, count)
  local placed, movers, n = b.placed, b.movers, 0
  if count <= b.moverCount then
    return count
  end
  for m = 1, count do
    placed[strays[m]] = 2
  end
  for m = 1, b.moverCount do
    local i = movers[m]
    if placed[i] ~= 0 then
      n = n + 1
      strays[n], placed[i] = i, STRAYS + n
    end
  end
  return n
end

-- Links the bodies in `strays[1..count]` with all bodies near their paths, with a margin, that they
-- can meet at all. They are no strays any more.
local function lookUp(b, strays, count, margin)
  local placed = b.placed
  -- All boxes come first, so that no pair is linked by an outdated box.
  enlarge(b, strays, count, margin)
  links.unlinkAll(b, b.pairList, listParted(b, strays, count))
  count = askMovers(b, strays, count)
  local n = listNew(b, b.broadphase:overlaps(strays, count, b.found))
  for m = 1, count do
    placed[strays[m]] = 2
  end
  if n > 0 then
    links.linkAll(b, n)
    wakeLinked(b, n)
  end
end

--- Looks up the neighbours of the bodies in `list[1..count]` with paths that leave their fat boxes.
--- A body that is listed twice is looked at once, a body that has left the world not at all.
--- `reach`: all pairs of paths that come as near as that are to be known, px, default 0.
function pairFinder.run(b, list, count, reach)
  local strays, active, placed, n = b.stack, b.active, b.placed, 0
  local from, to, size, fatLow, fatHigh = b.from, b.to, b.size, b.fatLow, b.fatHigh
  local free = (reach or 0) * 0.5 -- px of its fat box that a path must leave free
  for at = 1, count do
    local i = list[at]
    local k, m = 2 * i, 2 * i + 1
    local x, y, endX, endY = from[k], from[m], to[k], to[m]
    local left, right, top, bottom = fatLow[k], fatHigh[k], fatLow[m], fatHigh[m]
    local width, height = size[k], size[m]
    -- The same happens on whichever side it leaves. (jit: 2)
    local outX = max(left - x, left - endX, x + width - right, endX + width - right)
    local outY = max(top - y, top - endY, y + height - bottom, endY + height - bottom)
    if (max(outX, outY) > -free or placed[i] ~= 2) and active[i] and placed[i] >= 0 then
      n = n + 1
      strays[n], placed[i] = i, STRAYS + n
    end
  end
  if n > 0 then
    lookUp(b, strays, n, MARGIN + (b.hasRound and pairFinder.REACH * 0.5 or 0))
  end
end

--- Notes that the game has moved or resized an object since its last step.
function pairFinder.markMoved(b, i)
  if b.moved[i] == 0 then
    b.moved[i] = 1
    b.movedCount = b.movedCount + 1
    b.movedList[b.movedCount] = i
  end
end

-- Ends the pairs of an object that are not possible any more. If an object of such a pair stands on
-- the other object, it stands on nothing then: that slot may be used for another object soon.
local function unlink(b, i)
  local n, support = 0, b.support
  for _, j, p in links.neighbours(b, i) do
    if filter.reason(b, i, j) then
      n = n + 1
      b.pairList[n] = p
      support[i] = support[i] == j and 0 or support[i]
      support[j] = support[j] == i and 0 or support[j]
    end
  end
  links.unlinkAll(b, b.pairList, n)
end

--- Takes an object out of the pairs and the broad phase.
function pairFinder.remove(b, i)
  b.active[i] = false -- it may still be listed as moved
  unlink(b, i)
  if b.placed[i] ~= 0 then
    b.broadphase:remove(i)
    b.placed[i] = 0
  end
end

--- Updates the pairs of an object that can meet other objects than before, or has another size. It
--- ends the pairs that are no longer possible and has the neighbours looked up anew. Contacts must
--- have been ended before.
function pairFinder.refilter(b, i)
  if b.active[i] then
    unlink(b, i)
    b.placed[i] = min(b.placed[i], 1)
  else
    pairFinder.remove(b, i)
    islands.drop(b, i)
  end
end

-- Active pairs ------------------------------------------------------------------------------------

--- Lists in b.live the pairs with an awake body, which take part in a new step, and resets their
--- step columns; and lists the free pairs. They are listed anew only when a pair was made or ended,
--- or a body woke or fell asleep. Pairs that are linked in the middle of a step are appended
--- (`links.linkAll`).
function pairFinder.listLive(b)
  local live, free, pairA, pairB, awakeAt = b.live, b.freePairs, b.pairA, b.pairB, b.awakeAt
  local hit, pressed, passing = b.hit, b.pressed, b.passing
  if b.liveAwakenings ~= b.awakenings then
    local count, freeCount = 0, 0
    for p = 1, b.pairSlots do
      if awakeAt[pairA[p]] + awakeAt[pairB[p]] > 0 then -- slot 0, that of a free pair, sleeps
        count = count + 1
        live[count] = p
      elseif pairA[p] == 0 then
        freeCount = freeCount + 1
        free[freeCount] = p
      end
    end
    b.liveCount, b.freePairCount, b.liveAwakenings = count, freeCount, b.awakenings
  end
  for n = 1, b.liveCount do
    local p = live[n]
    hit[p], pressed[p], passing[p] = 0, 0, false
  end
end

return pairFinder
