--- Decides which contacts there are after a step, and writes the results into the game's tables.
--
-- Reads to, speed, carried, hit, pressed...; writes position, velocity, contact, support, carrier,
-- quiet, the fields x, y, vx, vy and touching of the game's objects, and notes the events.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carrier = require(root .. ".objects.carriers")
local knots = require(root .. ".solver.knots")
local read = require(root .. ".objects.read")
local columns = require(root .. ".memory.columns")
local contact = require(root .. ".contacts.contactState")
local crush = require(root .. ".solver.crush")
local interpreted = require(root .. ".memory.jit")
local notice = require(root .. ".queries.notice")
local oneway = require(root .. ".solver.oneWay")
local walk = require(root .. ".memory.lazy")(root .. ".solver.walk")

local write = {}

local DYNAMIC, GIVES = columns.DYNAMIC, columns.GIVES
local AXIS, OPPOSITE = columns.AXIS, columns.OPPOSITE
local EPSILON, VAST, WIDTHS = columns.EPSILON, columns.VAST, columns.WIDTHS
local floor, max, min = math.floor, math.max, math.min

-- Lists the live pairs that are close enough to touch, or did; returns how many.
local function listClose(b)
  local list, close = b.live, b.closePairs
  local count = 0 ---@type number
  local pairA, pairB, contacts, hit = b.pairA, b.pairB, b.contact, b.hit
  local to, size, overlapping, dropping, wedged = b.to, b.size, b.overlapping, b.dropping, b.wedged
  for n = 1, b.liveCount do
    local p = list[n]
    local k, m = 2 * pairA[p], 2 * pairB[p]
    local x, y = to[m] - to[k], to[m + 1] - to[k + 1]
    local gap = max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1])
    local isNear, isMet = (EPSILON - gap) * VAST + 1, contacts[p] + hit[p]
    local isClose = min(max(isNear, isMet, 0), k, 1)
    close[count + 1], wedged[p] = p, wedged[p] * isClose
    count = count + isClose
    if (overlapping[p] or dropping[p]) and isClose == 0 then
      overlapping[p], dropping[p] = false, false
    end
  end
  return count
end

-- Returns whether positions alone decide if two bodies in contact on `side` stay in contact.
local function isEven(b, i, j, side)
  return b.plain[i]
    and b.plain[j]
    and not (b.hears[i] or b.hears[j])
    and not (oneway.isOpen(b, i, side) or oneway.isOpen(b, j, OPPOSITE[side]))
end

-- Splits the close pairs. Lists pairs in contact in b.touchPairs if the world has no onStay, and
-- all others in b.otherPairs. Returns both counts.
local function listKnown(b, closeCount, isQuiet)
  local close, touchPairs, others, contacts = b.closePairs, b.touchPairs, b.otherPairs, b.contact
  local known, otherCount = 0, 0 ---@type number, number
  for n = 1, closeCount do
    local p = close[n]
    local isKnown = min(contacts[p], isQuiet)
    others[otherCount + 1], touchPairs[known + 1] = p, p
    otherCount, known = otherCount + 1 - isKnown, known + isKnown
  end
  return known, otherCount
end

-- Keeps in b.touchPairs the pairs in contact on the same side as before, if the bodies have no
-- onStay. Moves the others to b.otherPairs. The side selects indexes, not branches.
local function listOn(b, known, otherCount)
  local touchPairs, others, contacts, count = b.touchPairs, b.otherPairs, b.contact, 0
  local pairA, pairB, to, size, even = b.pairA, b.pairB, b.to, b.size, b.even
  local passing, dropping, overlapping = b.passing, b.dropping, b.overlapping
  for n = 1, known do
    local p = touchPairs[n]
    local i, j, side = pairA[p], pairB[p], contacts[p]
    local axis = AXIS[side]
    local k, m, kc, mc = 2 * i + axis, 2 * j + axis, 2 * i + 1 - axis, 2 * j + 1 - axis
    local isHigh = side - 2 * axis - 1 -- 0: the other is on the low side, 1: on the high side
    local gap = (2 * isHigh - 1) * (to[m] - to[k]) - size[m + (k - m) * isHigh]
    local rc = to[mc] - to[kc]
    if
      gap <= EPSILON
      and gap >= -EPSILON
      and rc - size[kc] < -EPSILON
      and -rc - size[mc] < -EPSILON
      and not (passing[p] or dropping[p] or overlapping[p])
      and ((even[i] and even[j]) or isEven(b, i, j, side))
    then
      count = count + 1
      touchPairs[count] = p
    else
      otherCount = otherCount + 1
      others[otherCount] = p
    end
  end
  return count, otherCount
end

-- Updates all live pairs and lists those in contact in b.touchPairs; returns how many, and the
-- number of close pairs. Pairs that need more tests come last, one by one.
local function updateContacts(b)
  local closeCount = listClose(b)
  local known, otherCount = listKnown(b, closeCount, b.world.onStay and 0 or 1)
  local count
  count, otherCount = listOn(b, known, otherCount)
  return contact.updateAll(b, b.otherPairs, otherCount, b.touchPairs, count), closeCount
end

-- Returns the length of the common edge of two bodies that meet on an axis, in parts of a px.
local function edgeOf(b, i, j, axis)
  local to, size, k, m = b.to, b.size, 2 * i + 1 - axis, 2 * j + 1 - axis
  return floor((min(to[k] + size[k], to[m] + size[m]) - max(to[k], to[m])) * WIDTHS + 0.5)
end

--- Returns an empty list of hits: sides that were hit by contacts that have ended since.
function write.newHits()
  return {
    count = 0,
    at = {}, -- 4 * slot + side
    owner = {}, -- the object in that slot
    slot = {}, -- of the other object
    other = {}, -- that object
    width = {}, -- px of the common edge
    chosen = {}, -- by `at`: the hit that is shown
  }
end

--- Forgets the hits: another update begins.
function write.forgetHits(b)
  local hits = b.hits
  for n = 1, hits.count do
    hits.owner[n], hits.other[n] = false, false
  end
  hits.count = 0
end

local function noteHit(b, i, side, j)
  if b.kind[i] ~= DYNAMIC then
    return
  end
  local hits = b.hits
  local n = hits.count + 1
  hits.count = n
  hits.at[n], hits.owner[n], hits.slot[n], hits.other[n] = 4 * i + side, b.object[i], j, b.object[j]
  hits.width[n] = edgeOf(b, i, j, AXIS[side])
end

-- Notes the hits of this step if their contact has also ended in it.
local function noteHits(b, closeCount)
  local close, hit, contacts, sensor = b.closePairs, b.hit, b.contact, b.sensor
  for n = 1, closeCount do
    local p = close[n]
    if hit[p] ~= 0 and contacts[p] == 0 then
      local i, j = b.pairA[p], b.pairB[p]
      if not (sensor[i] or sensor[j]) then
        noteHit(b, i, hit[p], j)
        noteHit(b, j, OPPOSITE[hit[p]], i)
      end
    end
  end
end

-- Returns whether hit n is shown rather than hit m on the same side: the wider common edge wins,
-- ties in the order of the world.
local function isWider(b, hits, n, m)
  local more = hits.width[n] - hits.width[m]
  return more > 0 or (more == 0 and b.rank[hits.slot[n]] < b.rank[hits.slot[m]])
end

-- Shows the hits of this update in `touching`, at sides where nothing touches now.
local function showHits(b)
  local hits, best, chosen = b.hits, b.touchBest, b.hits.chosen
  for n = 1, hits.count do
    local at = hits.at[n]
    local i = floor((at - 1) * 0.25)
    -- A callback between two steps may have removed one of the two.
    if b.object[i] == hits.owner[n] and b.object[hits.slot[n]] == hits.other[n] then
      b.news[i] = true -- the next update must remove it
      local shown = chosen[at] -- a hit
      if (best[at] == 0 and not shown) or (shown and isWider(b, hits, n, shown)) then
        best[at], chosen[at] = hits.slot[n], n
      end
    end
  end
  for n = 1, hits.count do
    chosen[hits.at[n]] = nil
  end
end

-- Lists what dynamic objects touch: index in touchBest, slot of the other object, length of the
-- common edge. Returns how many. Sensors touch nothing.
local function listOffers(b, count)
  local touchPairs, pairA, pairB, contacts = b.touchPairs, b.pairA, b.pairB, b.contact
  local at, others, width, sensor, kind = b.offerAt, b.offerOther, b.offerWidth, b.sensor, b.kind
  local to, size = b.to, b.size
  local offers = 1 ---@type number
  for n = 1, count do
    local p = touchPairs[n]
    local i, j, side = pairA[p], pairB[p], contacts[p]
    if not (sensor[i] or sensor[j]) then
      local across = 1 - AXIS[side]
      local k, m = 2 * i + across, 2 * j + across
      local x, y = to[k], to[m]
      local edge = floor((min(x + size[k], y + size[m]) - max(x, y)) * WIDTHS + 0.5)
      at[offers], others[offers], width[offers] = 4 * i + side, j, edge
      offers = offers + GIVES[kind[i]]
      at[offers], others[offers], width[offers] = 4 * j + OPPOSITE[side], i, edge
      offers = offers + GIVES[kind[j]]
    end
  end
  return offers - 1
end

-- Clears what awake objects touch, and whether they are inside others.
local function reset(b)
  local list, best, inside = b.awakeList, b.touchBest, b.inside
  for n = 1, b.awakeCount do
    local i = list[n]
    local at = 4 * i
    best[at + 1], best[at + 2], best[at + 3], best[at + 4] = 0, 0, 0, 0
    inside[i] = false
  end
end

-- Takes the first offer for each side; few sides have more. Lists the others in b.rivals; returns
-- how many.
local function takeFirst(b, count)
  local best, bestWidth, rivals = b.touchBest, b.touchWidth, b.rivals
  local places, others, width = b.offerAt, b.offerOther, b.offerWidth
  local rivalCount = 0 ---@type number
  for n = 1, count do
    local at = places[n]
    local first, widest = best[at], bestWidth[at]
    local isTaken = min(first, 1)
    best[at] = first + others[n] * (1 - isTaken)
    bestWidth[at] = widest * isTaken + width[n] * (1 - isTaken)
    rivals[rivalCount + 1] = n
    rivalCount = rivalCount + isTaken
  end
  return rivalCount
end

-- Of those and the first, the widest common edge wins; ties in the order of the world.
local function chooseRivals(b, rivalCount)
  local best, bestWidth, rivals, rank = b.touchBest, b.touchWidth, b.rivals, b.rank
  local places, others, width = b.offerAt, b.offerOther, b.offerWidth
  for m = 1, rivalCount do
    local n = rivals[m]
    local at, j, w = places[n], others[n], width[n]
    local widest = bestWidth[at]
    if w > widest or (w == widest and rank[j] < rank[best[at]]) then
      best[at], bestWidth[at] = j, w
    end
  end
end

-- Finds what each object touches, from the pairs in contact: the widest common edge wins, ties in
-- the order of the world.
local function findTouching(b, count)
  chooseRivals(b, takeFirst(b, listOffers(b, count)))
end

-- Finds the support of each awake object.
local function findSupports(b)
  local list, down, best, support, news = b.awakeList, b.down, b.touchBest, b.support, b.news
  for n = 1, b.awakeCount do
    local i = list[n]
    local x, y = down[2 * i], down[2 * i + 1]
    -- left, right, top and bottom are 1 to 4
    local below = (x ~= 0 or y ~= 0) and best[4 * i + (x ~= 0 and 1.5 + 0.5 * x or 3.5 + 0.5 * y)]
      or 0
    if below ~= support[i] then
      support[i], news[i] = below, true
    end
  end
end

-- Returns whether something stops k, which is carried at c px/s.
local function isStopped(b, k, c)
  return (c < 0 and b.pressedLow[k]) or (c > 0 and b.pressedHigh[k])
end

-- Makes a rider's velocity relative to its carrier. If carrier and forces point in opposite
-- directions, the way of a step depends on dt. So does a bounce off what the rider is carried
-- against. Such a rider must not sleep, even if it stands still in this step.
local function takeOffCarrier(b, i)
  local c, k = b.carrierNow[i], 2 * i
  local isNew = c ~= b.carrier[i]
  if isNew then
    b.carrier[i], b.news[i] = c, true
  end
  if c ~= 0 then
    local x, y = carrier.velocity(b, c, i)
    b.speed[k] = carrier.ownVelocity(b, k, x, isNew)
    b.speed[k + 1] = carrier.ownVelocity(b, k + 1, y, isNew)
    local pullX, pullY = b.flowPull[k] + b.push[k], b.flowPull[k + 1] + b.push[k + 1]
    b.news[i] = b.news[i]
      or x * pullX < 0
      or y * pullY < 0
      or (b.hasBounces and (isStopped(b, k, x) or isStopped(b, k + 1, y)))
  end
  carrier.keep(b, i, isNew and c == 0)
end

-- Returns whether friction holds the object only at this length of a step. In a longer step, air
-- friction and speed limits take more off a force or a weight.
local function isBorneByChance(b, i)
  return b.rubs > 0 and (b.flowAir[i] ~= 0 or b.reserve[2 * i] ~= 0 or b.reserve[2 * i + 1] ~= 0)
end

-- Returns whether the next step may differ from this one although nothing moves. (Whether a buried
-- body finds a way out depends on walls that are not its neighbours.)
local function hasNews(b, i)
  return b.news[i]
    or b.fresh[i]
    or b.moved[i]
    or b.heard[i]
    or b.buried[i]
    or b.softSpeed[2 * i] ~= 0
    or b.softSpeed[2 * i + 1] ~= 0
    or isBorneByChance(b, i)
end

local function publishKinematic(b, i)
  local object, k = b.object[i], 2 * i
  local x, y = b.to[k], b.to[k + 1]
  b.behind[k] = b.written[k] - b.position[k] + b.behind[k] - b.way[k]
  b.behind[k + 1] = b.written[k + 1] - b.position[k + 1] + b.behind[k + 1] - b.way[k + 1]
  b.quiet[i] = x == b.position[k]
    and y == b.position[k + 1]
    and b.velocity[k] == 0
    and b.velocity[k + 1] == 0
    and b.behind[k] == 0
    and b.behind[k + 1] == 0
    and not hasNews(b, i)
  if x ~= object.x or y ~= object.y then
    object.x, object.y = x, y
  end
  b.position[k], b.position[k + 1] = x, y
  b.written[k], b.written[k + 1] = x, y
end

-- Also gives `touching` to new objects that take no part in the step.
local function forgetMoved(b)
  read.giveTouching(b)
  for n = 1, b.movedCount do
    local i = b.movedList[n]
    b.moved[i], b.fresh[i] = false, false
  end
  b.movedCount = 0
end

local function tellCrushed(b)
  if not b.hasCrushed then
    return
  end
  local list, crushed, wasCrushed = b.awakeList, b.crushed, b.wasCrushed
  for n = 1, b.awakeCount do
    local k = 2 * list[n]
    if crushed[k] or crushed[k + 1] or wasCrushed[k] or wasCrushed[k + 1] then
      crush.tell(b, list[n])
    end
  end
end

-- Lists the objects with a `touching` that is out of date; returns how many. (From one step to the
-- next few are, and the game's tables are far apart in memory.)
local function listOutdated(b)
  local list, best, told, outdated = b.awakeList, b.touchBest, b.touchTold, b.outdated
  local count = 0 ---@type number
  for n = 1, b.awakeCount do
    local i = list[n]
    local at = 4 * i
    if
      best[at + 1] ~= told[at + 1]
      or best[at + 2] ~= told[at + 2]
      or best[at + 3] ~= told[at + 3]
      or best[at + 4] ~= told[at + 4]
    then
      count = count + 1
      outdated[count] = i
    end
  end
  return count
end

local function tellTouching(b, count)
  local outdated, objects, tables, best, told =
    b.outdated, b.object, b.touching, b.touchBest, b.touchTold
  for n = 1, count do
    local i = outdated[n]
    local touching, at = tables[i], 4 * i
    local left, right, top, bottom = best[at + 1], best[at + 2], best[at + 3], best[at + 4]
    if touching then -- it is dynamic
      -- (object[0] is false)
      touching.left, touching.right = objects[left], objects[right]
      touching.top, touching.bottom = objects[top], objects[bottom]
    end
    told[at + 1], told[at + 2], told[at + 3], told[at + 4] = left, right, top, bottom
  end
end

local function tellMotion(b)
  local list, kind, objects, quiet = b.awakeList, b.kind, b.object, b.quiet
  local tables = b.touching
  local to, speed = b.to, b.speed
  local position, velocity, written = b.position, b.velocity, b.written
  for n = 1, b.awakeCount do
    local i = list[n]
    if kind[i] == DYNAMIC then
      local object, k, m = objects[i], 2 * i, 2 * i + 1
      local x, y, vx, vy = to[k], to[m], speed[k], speed[m]
      quiet[i] = vx == 0
        and vy == 0
        and x == position[k]
        and y == position[m]
        and velocity[k] == 0
        and velocity[m] == 0
        and not hasNews(b, i)
      -- Writing is cheaper than testing whether a value is new.
      object.x, object.y, object.vx, object.vy = x, y, vx, vy
      object.touching = tables[i]
      position[k], position[m], velocity[k], velocity[m] = x, y, vx, vy
      written[k], written[m] = x, y
    else
      publishKinematic(b, i)
    end
  end
end

local function findCarriers(b)
  if not b.hasCarriers then
    return
  end
  carrier.find(b)
  local list, now, last, kept = b.awakeList, b.carrierNow, b.carrier, b.kept
  for n = 1, b.awakeCount do
    local i = list[n]
    if now[i] ~= 0 or last[i] ~= 0 or kept[2 * i] ~= 0 or kept[2 * i + 1] ~= 0 then
      takeOffCarrier(b, i)
    end
  end
end

--- Writes the results of a step, for each object that took part in it.
function write.run(b)
  contact.ask(b)
  notice.outdate(b) -- canCollide may have made queries, and what follows may fail
  reset(b)
  knots.note(b)
  local count, closeCount = updateContacts(b)
  findTouching(b, count)
  if b.hasSlopes then
    walk.showBlocked(b)
  end
  tellCrushed(b)
  findSupports(b)
  findCarriers(b)
  if b.resolved > 0 then
    noteHits(b, closeCount)
  end
  showHits(b)
  tellTouching(b, listOutdated(b))
  tellMotion(b)
  forgetMoved(b)
end

-- These lead from loop to loop.
interpreted.functions(write.run, findTouching, updateContacts)

return write
