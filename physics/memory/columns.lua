--- The memory of a world: one array ("column") per property, one index ("slot") per object. What
--- columns there are is in layout.lua.
--
-- Every stage of a step reads and writes these columns and nothing else. The game's tables are read
-- in objects/read.lua and written in objects/write.lua. Columns with a value for each axis are
-- interleaved: `column[2 * slot]` is x and `column[2 * slot + 1]` is y, so that one function serves
-- both axes. Pairs of neighbours have columns of their own. Each pair is in the lists of both of
-- its objects by two half-edges (`2 * pair - 1` and `2 * pair`).
--
-- No column is shared between worlds: a callback may step another world.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local initial = require(root .. ".memory.initial")
local layout = require(root .. ".memory.layout")

local columns = {}

columns.STATIC, columns.KINEMATIC, columns.DYNAMIC = 1, 2, 3

--- By kind: 1 for a dynamic object, else 0, as a factor instead of a branch. (0 is an empty slot.)
columns.GIVES = { [0] = 0, [columns.STATIC] = 0, [columns.KINEMATIC] = 0, [columns.DYNAMIC] = 1 }

--- Returns the kind that an object's fields say. `kinematic` is read again in each step, `static`
--- is not.
---@param object physics.Object
---@param isStatic boolean? whether it is static; nil: as its field says
---@return integer
function columns.kindOf(object, isStatic)
  if isStatic == nil then
    isStatic = object.static or false
  end
  return isStatic and columns.STATIC or object.kinematic and columns.KINEMATIC or columns.DYNAMIC
end

--- How far apart two edges may be and still count as touching, px.
columns.EPSILON = 1e-6
--- Widths of common edges are rounded to 1 / WIDTHS px before they are compared: that two are equal
--- does not depend on which of them is looked at first.
columns.WIDTHS = 2 ^ 20

--- Makes any difference of two numbers around EPSILON more than 1. So `min(max(d * VAST, 0), 1)` is
--- 1 for d > 0 and 0 for d <= 0, and `min(max(d * VAST + 1, 0), 1)` is 1 for d >= 0 and 0 for d <
--- 0. These stand for branches in measured loops: each branch direction but the one compiled first
--- costs 40 ns more.
columns.VAST = 1e300

--- Is added to lengths before a division, so that 0 / 0 cannot arise. It changes no other length.
columns.TINY = 1e-300

--- A number larger than the rank of any object.
columns.RANKS = 2 ^ 40

--- Value of `touchTold` at the first side of an object with a `touching` that must be written
--- again.
columns.UNTOLD = -1

local floor, max, min = math.floor, math.max, math.min
local EVERY, MOVING, PAIR_NAMES = layout.EVERY, layout.MOVING, layout.PAIR_NAMES
-- Slots are prepared ahead: one for each so many that are in use.
local AHEAD = 8
-- Before the static bodies there are slots for so many that can move, or for one in SHARE of all.
local ROOM, SHARE = 16, 8
-- Up to so many bodies columns grow by themselves.
local FEW = 256

-- The global `require`: that of the single file knows only its modules.
local hasNew, newTable = pcall(rawget(_G, "require"), "table.new")
---@cast newTable fun(arrays: integer, hashes: integer): table

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

local function fill(column, first, last, value)
  for at = first, last do
    column[at] = value
  end
end

-- Gives slots the initial values of some columns, column by column. (Slot by slot, 20 000 tiles
-- take twice as long.)
local function blank(b, rows, first, last)
  for n = 1, #rows do
    local row = rows[n]
    local shift = row.width == 4 and 1 or 0 -- sides are 1 to 4
    fill(b[row.name], row.width * first + shift, row.width * (last + 1) + shift - 1, row.value)
  end
end

-- Names the columns that say what acts on a body, where there are no zones (see zones).
local function nameFlow(b)
  b.flowPull, b.flowAir, b.flowDrag = b.pull, b.airFriction, b.drag
end

--- Returns the empty columns of a world.
function columns.new()
  local b = {}
  initial(b)
  for n = 1, #layout.OTHERS do
    b[layout.OTHERS[n]] = {}
  end
  for _, rows in ipairs({ EVERY, MOVING }) do
    for n = 1, #rows do
      b[rows[n].name] = {}
    end
    blank(b, rows, 0, 0)
  end
  -- Slot 0 is the empty slot, that of unlinked pairs. Its size is negative, so it meets nothing.
  b.next[0], b.previous[0], b.size[0], b.size[1] = 0, 0, -1, -1
  nameFlow(b)
  return b
end

-- Returns the last slot to prepare together with slot i.
local function ahead(i)
  local room = 1 -- Lua makes room up to the next power of two
  while room <= i do
    room = room * 2
  end
  return min(i + floor(i / AHEAD), max(i, room - 1))
end

-- Makes the columns that each slot has anew, with room up to the slot `last`. (A table that grows
-- takes the next power of two.) Keeps the first `count` slots.
local function resize(b, count, last)
  for n = 1, #EVERY do
    local width, old = EVERY[n].width, b[EVERY[n].name]
    local new = newTable(width * (last + 1), 0)
    for k = 0, width * (count + 1) - 1 do
      new[k] = old[k]
    end
    b[EVERY[n].name] = new
  end
  if not b.hasZones then
    nameFlow(b)
  end
end

-- Takes a slot for a static body that was never used.
local function takeStatic(b)
  if b.lastMover == math.huge then
    b.lastMover = b.moverSlots + max(ROOM, floor(b.expected / SHARE))
    if hasNew and b.expected > FEW then
      resize(b, b.moverSlots, b.lastMover + b.expected + 1)
    end
    blank(b, EVERY, b.moverSlots + 1, b.lastMover)
    b.slots, b.blankTo = b.lastMover, b.lastMover
  end
  local i = b.slots + 1
  b.slots = i
  if i > b.blankTo then
    b.blankTo = b.expected > FEW and i + b.expected or ahead(i)
    blank(b, EVERY, i, b.blankTo)
  end
  return i
end

--- Gives a slot the columns of bodies that can move, if it has not got them.
function columns.complete(b, i)
  if not b.full[i] then
    b.full[i] = true
    blank(b, MOVING, i, i)
  end
end

-- Takes a slot for a body that can move that was never used.
local function takeMover(b)
  local i = b.moverSlots + 1
  b.moverSlots, b.slots = i, max(b.slots, i)
  if i > b.moverBlankTo then
    b.moverBlankTo = min(ahead(i), b.lastMover)
    blank(b, EVERY, i, b.moverBlankTo)
    blank(b, MOVING, i, b.moverBlankTo)
  end
  b.full[i] = true
  return i
end

-- Takes a slot from a list of free ones.
local function takeFree(b, list)
  local i = list[#list]
  if i then
    list[#list] = nil
    blank(b, EVERY, i, i)
  end
  return i
end

--- Takes a slot for a new object and returns it. All its columns have their initial values. A
--- static body has only those that each slot has.
function columns.claim(b, isStatic)
  b.count, b.expected = b.count + 1, max(0, b.expected - 1)
  if isStatic then
    return takeFree(b, b.freeStatic) or takeStatic(b)
  end
  local i = takeFree(b, b.free)
  if not i and b.moverSlots < b.lastMover then
    return takeMover(b)
  end
  i = i or takeFree(b, b.freeStatic) or takeStatic(b)
  columns.complete(b, i)
  return i
end

--- Resets what the last step has left in a slot.
function columns.forgetStep(b, i)
  blank(b, layout.STEP_EVERY, i, i)
  blank(b, layout.STEP_MOVING, i, b.full[i] and i or i - 1)
end

--- Gives an object a path of length 0 at its position, as an obstacle and for the broad phase. An
--- awake object gets its path when a step begins.
function columns.stand(b, i)
  local k = 2 * i
  b.from[k], b.from[k + 1] = b.position[k], b.position[k + 1]
  b.to[k], b.to[k + 1] = b.position[k], b.position[k + 1]
  b.speed[k], b.speed[k + 1], b.accel[k], b.accel[k + 1] = 0, 0, 0, 0
  b.time[i] = 0
end

--- Gives a slot back. Its pairs must have been unlinked.
function columns.release(b, i)
  b.object[i], b.group[i], b.touching[i], b.mask[i], b.canCollide[i] =
    false, false, false, false, false
  b.area[i], b.only[i], b.hitsGiven[i] = false, false, false
  b.kind[i], b.awake[i] = 0, false
  local list = i > b.lastMover and b.freeStatic or b.free
  list[#list + 1] = i
  b.count = b.count - 1
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
  local free, have, linked = b.freePairs, b.freePairCount, b.linked
  local ones, others, pairA, pairB, slots = b.linkOne, b.linkOther, b.pairA, b.pairB, b.pairSlots
  for n = 1, count do
    local p = n <= have and free[have + 1 - n] or slots + n - have
    linked[n], pairA[p], pairB[p] = p, ones[n], others[n]
  end
  b.pairSlots, b.freePairCount = slots + max(0, count - have), max(0, have - count)
end

-- Gives new pairs their initial values.
local function resetPairs(b, count)
  local linked = b.linked
  for m = 1, #PAIR_NAMES do
    local column, value = b[PAIR_NAMES[m]], layout.PAIR[PAIR_NAMES[m]]
    for n = 1, count do
      column[linked[n]] = value
    end
  end
end

--- Makes neighbours of b.linkOne[n] and b.linkOther[n], for n from 1 to `count`. Their pairs are in
--- b.linked afterwards. They must not be neighbours yet, nor be listed twice.
function columns.linkAll(b, count)
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
  local pairA, pairB = b.pairA, b.pairB
  for n = 1, count do
    unhang(b, 2 * list[n] - 1, pairA[list[n]])
  end
  for n = 1, count do
    unhang(b, 2 * list[n], pairB[list[n]])
  end
  local ended, endedCount = b.endedPairs, b.endedPairCount
  local told = b.touchTold
  for n = 1, count do
    local p = list[n]
    -- Either slot may soon belong to another object.
    told[4 * pairA[p] + 1], told[4 * pairB[p] + 1] = columns.UNTOLD, columns.UNTOLD
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

--- Returns the pair of two neighbours, or nil.
function columns.pairOf(b, i, j)
  local other, nextHalf = b.other, b.next
  local half = b.head[i]
  while half ~= 0 do
    if other[half] == j then
      return (half + half % 2) / 2
    end
    half = nextHalf[half]
  end
end

return columns
