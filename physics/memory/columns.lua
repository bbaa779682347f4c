---@diagnostic disable
--- The memory of a world: one array ("column") per property, one index ("slot") per object. What
--- columns there are is in layout.lua.
--
-- The stages of a step read and write these columns, and lists and counts (see initial.lua). The
-- game's tables are read in objects/read.lua and written in objects/write.lua. Columns with a value
-- for each axis are interleaved: `column[2 * slot]` is x and `column[2 * slot + 1]` is y, so that
-- one function serves both axes. Pairs of neighbours have columns of their own. Each pair is in the
-- lists of both of its objects by two half-edges (`2 * pair - 1` and `2 * pair`). So
-- `floor(k * 0.5)` is the slot of an index, and `floor(half * 0.5 + 0.5)` the pair of a half-edge.
--
-- No column is shared between worlds: a callback may step another world.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local allot = require(root .. ".memory.allot")
local layout = require(root .. ".memory.layout")

local columns = {}

--- Kinds, from the one that is least free to move.
columns.STATIC, columns.KINEMATIC, columns.DYNAMIC = 1, 2, 3
--- Value of `packed` of a body that stays where it is, like a wall (see relax).
columns.STUCK = 1000

--- Returns the kind that an object's fields say. `kinematic` is read again in each step, `static`
--- is not.
---@param object physics.Object
---@param isStatic boolean? whether it is static; nil: as its field says
---@return integer
function columns.kindOf(object, isStatic)
  isStatic = isStatic or isStatic == nil and object.static
  return isStatic and columns.STATIC or object.kinematic and columns.KINEMATIC or columns.DYNAMIC
end

--- Returns the highest slot that has a place in a column.
function columns.lastOf(b, name)
  return layout.isOfBodies[name] and b.lastUsed or b.slots
end

--- How far apart two edges may be and still count as touching, px.
columns.EPSILON = 1e-6
--- The same of a ball in a heap, which is pushed to and fro by less.
columns.SLACK = 0.05
--- Widths of common edges are rounded to 1 / WIDTHS px before they are compared: that two are equal
--- does not depend on which of them is looked at first.
columns.WIDTHS = 2 ^ 20

--- Is added to lengths before a division, so that 0 / 0 cannot arise. It changes no other length.
columns.TINY = 1e-300

--- A number larger than the rank of any object.
columns.RANKS = 2 ^ 40

--- Value of `touchTold` at the first side of an object with a `touching` that must be written
--- again.
columns.UNTOLD = -1

local floor, max, min = math.floor, math.max, math.min
local PAIR = layout.PAIR

--- Sides are numbers inside: left, right, top, bottom are 1 to 4, so that the side on `axis` is
--- `2 * axis + 1` (low) or `2 * axis + 2` (high).
---@type table<any, string>
columns.SIDES = { "left", "right", "top", "bottom" }
columns.SIDE = { left = 1, right = 2, top = 3, bottom = 4 }
---@type table<any, integer>
columns.OPPOSITE = { 2, 1, 4, 3 }
--- The axis of each side.
columns.AXIS = { 0, 0, 1, 1 }

--- Returns the side that a value of the field `oneWay` means: `true` is the top; false: none.
function columns.sideOf(value)
  return value == true and "top" or value or false
end

--- Gives an object a path of length 0 at its position, as an obstacle and for the broad phase. An
--- awake object gets its path when a step begins.
function columns.stand(b, i)
  local k = 2 * i
  b.from[k], b.from[k + 1] = b.position[k], b.position[k + 1]
  b.to[k], b.to[k + 1] = b.position[k], b.position[k + 1]
  if i <= b.lastBody then
    b.speed[k], b.speed[k + 1], b.accel[k], b.accel[k + 1] = 0, 0, 0, 0
    b.time[i] = 0
  end
end

-- The lists of half-edges are changed without branches: a write that is not needed goes to place 0.

local function hang(b, half, i, j)
  local first = b.head[i]
  b.other[half], b.next[half], b.previous[half] = j, first, 0
  b.previous[first], b.head[i] = half, half
end

local function unhang(b, half, i)
  local before, after = b.previous[half], b.next[half]
  b.next[before], b.previous[after] = after, before
  b.head[i * (1 - min(before, 1))] = after -- only if it was the first
end

-- Takes `count` free pairs for b.linkOne[1..count] and b.linkOther[1..count] into b.linked.
local function takePairs(b, count)
  local last = b.pairSlots + max(0, count - b.freePairCount)
  allot.reserve(b, PAIR, last)
  allot.reserve(b, layout.LINKS, last)
  local free, have, linked = b.freePairs, b.freePairCount, b.linked
  local ones, others, pairA, pairB, used = b.linkOne, b.linkOther, b.pairA, b.pairB, b.pairSlots
  for n = 1, count do
    local p = n <= have and free[have + 1 - n] or used + n - have
    linked[n], pairA[p], pairB[p] = p, ones[n], others[n]
  end
  b.pairSlots, b.freePairCount = used + max(0, count - have), max(0, have - count)
end

-- Gives new pairs their initial values.
local function resetPairs(b, count)
  local linked = b.linked
  for m = 1, #PAIR.names do
    local column, value = b[PAIR.names[m]], PAIR.values[m]
    for n = 1, count do
      column[linked[n]] = value
    end
  end
end

--- Makes neighbours of b.linkOne[n] and b.linkOther[n], for n from 1 to `count`. Their pairs are in
--- b.linked afterwards. They must not be neighbours yet, nor be listed twice.
function columns.linkAll(b, count)
  allot.embodyLinked(b, count)
  takePairs(b, count)
  resetPairs(b, count)
  local linked, ones, others = b.linked, b.linkOne, b.linkOther
  for n = 1, count do
    hang(b, 2 * linked[n] - 1, ones[n], others[n])
  end
  for n = 1, count do
    hang(b, 2 * linked[n], others[n], ones[n])
  end
  local live, liveCount = b.live, b.liveCount
  for n = 1, count do
    live[liveCount + n] = linked[n]
  end
  b.liveCount, b.links, b.pairCount = liveCount + count, b.links + count, b.pairCount + count
end

--- Makes two objects neighbours and returns the pair. They must not be neighbours yet.
function columns.link(b, i, j)
  b.linkOne[1], b.linkOther[1] = i, j
  columns.linkAll(b, 1)
  return b.linked[1]
end

--- Unlinks the pairs in list[1..count], each of which is listed once. Their contacts must have
--- ended. They are free again when the live pairs are listed anew: lists of this step hold them.
function columns.unlinkAll(b, list, count)
  local pairA, pairB, told = b.pairA, b.pairB, b.touchTold
  local ended, endedCount = b.endedPairs, b.endedPairCount
  for n = 1, count do
    local p = list[n]
    local i, j = pairA[p], pairB[p]
    unhang(b, 2 * p - 1, i)
    unhang(b, 2 * p, j)
    -- Either slot may soon belong to another object.
    told[4 * i + 1], told[4 * j + 1] = columns.UNTOLD, columns.UNTOLD
    pairA[p], pairB[p] = 0, 0
    ended[endedCount + n] = p
  end
  b.endedPairCount, b.pairCount, b.links = endedCount + count, b.pairCount - count, b.links + count
end

--- Makes the pairs free that have ended since this was last called.
function columns.freeEnded(b)
  local free, freeCount, ended, count = b.freePairs, b.freePairCount, b.endedPairs, b.endedPairCount
  for n = 1, count do
    free[freeCount + n] = ended[n]
  end
  b.freePairCount, b.endedPairCount = freeCount + count, 0
end

--- Returns the gap between slots i and j at the places in a column, px; below 0: they overlap.
function columns.gap(b, place, i, j)
  local size, k, m = b.size, 2 * i, 2 * j
  local x, y = place[m] - place[k], place[m + 1] - place[k + 1]
  return max(x - size[k], -x - size[m], y - size[k + 1], -y - size[m + 1])
end

--- Returns whether the middle of slot i comes before that of slot j on an axis, at the places in a
--- column; of two at one place, whether it comes first in the order of the world.
function columns.isLow(b, place, i, j, axis)
  local k, m = 2 * i + axis, 2 * j + axis
  local way = place[m] - place[k] + (b.size[m] - b.size[k]) * 0.5
  return way > 0 or way == 0 and b.rank[i] < b.rank[j]
end

--- Result of `flushSide` for two bodies that overlap.
columns.INSIDE = -1

--- Returns the side of slot i on which two boxes are flush at the end of the step, else 0; INSIDE:
--- they overlap.
function columns.flushSide(b, i, j)
  local to, size, k, m = b.to, b.size, 2 * i, 2 * j
  local x, y = to[m] - to[k], to[m + 1] - to[k + 1]
  local afterX, beforeX = x - size[k], -x - size[m]
  local afterY, beforeY = y - size[k + 1], -y - size[m + 1]
  local gapX, gapY = max(afterX, beforeX), max(afterY, beforeY)
  if max(gapX, gapY) < -columns.EPSILON then
    return columns.INSIDE
  elseif max(gapX, gapY) > columns.EPSILON or min(gapX, gapY) >= -columns.EPSILON then
    return 0 -- apart, or corner to corner
  elseif gapX > gapY then
    return afterX >= beforeX and 2 or 1
  end
  return afterY >= beforeY and 4 or 3
end

--- Returns the two ranks that decide between simultaneous impacts of a pair. The first is the rank
--- of the dynamic object; of two dynamic ones, the lower rank. If one stands on the other, the
--- second rank is made lower than all ranks; if both are dynamic, the first one, too. So of several
--- objects below, the one that counts as the support and carrier bears the weight.
function columns.ranks(b, i, j)
  local one, other = b.rank[i], b.rank[j]
  local iDynamic, jDynamic = b.kind[i] == columns.DYNAMIC, b.kind[j] == columns.DYNAMIC
  local first = one
  if jDynamic and (not iDynamic or other < one) then
    first = other
  end
  local second = one + other - first
  if b.support[i] == j or b.support[j] == i then
    first = iDynamic and jDynamic and first - columns.RANKS or first
    second = second - columns.RANKS
  end
  return first, second
end

-- Returns the half-edge after another one, or the first one of a slot, given as a number below 0;
-- the neighbour, and the pair. Nil behind the last one.
local function follow(b, half)
  half = half < 0 and b.head[-half] or b.next[half]
  if half ~= 0 then
    return half, b.other[half], floor(half * 0.5 + 0.5)
  end
end

--- Goes through the neighbours of slot i: `for _, j, p in columns.neighbours(b, i) do`, where p is
--- the pair of i and j.
function columns.neighbours(b, i)
  return follow, b, -i
end

--- Returns the pair of two neighbours, or nil.
function columns.pairOf(b, i, other)
  for _, j, p in columns.neighbours(b, i) do
    if j == other then
      return p
    end
  end
end

return columns
