---@diagnostic disable
--- Gives each body a slot, that is an index in the columns of a world, and makes the columns.
--
-- A static body that has never had a neighbour, as most of a level, has few columns: those of its
-- place and its fields. Slots up to `lastBody` have all columns, those behind it have only these.
-- When a static body gets its first neighbour, it moves to a slot with all of them (`embody`). So
-- until then its slot may change whenever pairs are linked, or a body comes that can move.
--
-- Writes all columns of new and of moved bodies.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local arrays = require(root .. ".memory.arrays")
local initial = require(root .. ".memory.initial")
local layout = require(root .. ".memory.layout")

local allot = {}

local floor, max, remove = math.floor, math.max, table.remove
---@type any, any
local EVERY, BODY = layout.EVERY, layout.BODY
-- Before the static bodies there are so many free slots with all columns. When they are used up,
-- there is room for one in MORE of all of them on top. (The static bodies in the way must move:
-- with half of them on top, one frame of a level of 20 000 tiles takes 9 ms.)
local ROOM, MORE = 8, 16
-- The lists that may keep the slot of a static body without neighbours while pairs are linked, and
-- their counts. (`moveNoted` mends `slotOf`, `group.slots` and the grid.) Nothing else may: all
-- else asks `embody` for a slot that stays.
local KEEPERS =
  { "linkOne", "linkOther", "movedList", "entered", "zoneList", "restored", "gone", "reranked" }
local COUNTS = { "linkCount", "linkCount", "movedCount", "enteredCount" }

--- Makes room in some columns for the index `last`.
function allot.reserve(b, rows, last)
  local old = b.reserved[rows] ---@type number
  if last < old then
    return
  end
  local count = arrays.places(old, last + 1)
  for n = 1, #rows.names do
    local name, width = rows.names[n], rows.widths[n]
    b[name] = arrays.grow(rows.kinds[n], b[name], width, old, count)
  end
  b.reserved[rows] = count
end

-- Gives slots the initial values of some columns, column by column. (Slot by slot, 20 000 tiles
-- take twice as long.)
local function blank(b, rows, first, last)
  for n = 1, #rows.names do
    local column, value, width = b[rows.names[n]], rows.values[n], rows.widths[n]
    local shift = width == 4 and 1 or 0 -- sides are 1 to 4
    for at = width * first + shift, width * (last + 1) + shift - 1 do
      column[at] = value
    end
  end
end

-- Makes room in some columns for the slot `last`. Slots that are not in use have the first values.
local function prepare(b, rows, last)
  local old = b.reserved[rows]
  if last >= old then
    allot.reserve(b, rows, last)
    blank(b, rows, old, b.reserved[rows] - 1)
  end
end

-- Makes columns or lists. Errors: something else has such a name.
local function add(b, names)
  for n = 1, #names do
    assert(b[names[n]] == nil, "physics: two columns have one name: " .. names[n])
    b[names[n]] = {}
  end
end

--- Returns the memory of a world in which there is nothing.
function allot.new()
  local b = {}
  initial.begin(b)
  add(b, layout.FIRST)
  return b
end

-- Makes the columns, when the first object comes.
local function make(b)
  b.fatLow, b.fatHigh = nil, nil -- they become columns
  add(b, layout.OTHERS)
  initial.addWork(b)
  for _, rows in ipairs({ EVERY, BODY, layout.PAIR, layout.LINKS }) do
    add(b, rows.names)
    b.reserved[rows] = 0
    prepare(b, rows, 0)
  end
  -- Slot 0 is the empty slot, that of unlinked pairs. Its size is negative, so it meets nothing.
  b.size[0], b.size[1] = -1, -1
end

-- Takes a slot behind `lastBody`. (Of the free ones some may be in front of it by now.)
local function takePlace(b, coming)
  local i
  repeat
    i = remove(b.slotWork.freePlaces)
  until not i or i > b.lastBody
  if not i then
    i = b.slots + 1
    b.slots = i
    prepare(b, EVERY, i + coming - 1)
  end
  return i
end

-- Takes a slot with all columns. There must be one.
local function takeBody(b, coming)
  local i = remove(b.slotWork.free)
  if not i then
    i = b.lastUsed + 1
    b.lastUsed, b.slots = i, max(b.slots, i)
    prepare(b, EVERY, i + coming - 1)
    prepare(b, BODY, i + coming - 1)
  end
  return i
end

-- Moving -----------------------------------------------------------------------------------------

-- Notes that the static body in slot i, which has no neighbours, is about to move to slot j.
local function note(b, i, j)
  local work = b.slotWork
  work.leftCount = work.leftCount + 1
  work.left[work.leftCount], work.movedTo[i] = i, j
end

local function renameIn(movedTo, list, count)
  for n = 1, count do
    list[n] = movedTo[list[n]] or list[n]
  end
end

local function copy(column, width, left, movedTo, count)
  for n = 1, count do
    local k, m = width * left[n], width * movedTo[left[n]]
    column[m], column[m + width - 1] = column[k], column[k + width - 1]
  end
end

-- Moves the bodies that were noted, and writes their slots into the lists that keep them.
local function moveNoted(b)
  local work = b.slotWork
  local left, movedTo, places, count = work.left, work.movedTo, work.freePlaces, work.leftCount
  for n = 1, #EVERY.names do
    copy(b[EVERY.names[n]], EVERY.widths[n], left, movedTo, count)
  end
  for n = 1, #KEEPERS do
    renameIn(movedTo, b[KEEPERS[n]], b[COUNTS[n]] or #b[KEEPERS[n]])
  end
  for n = 1, count do
    local i, j = left[n], movedTo[left[n]]
    local slots = b.group[j] and b.group[j].slots or {} -- (an object that has gone is in none)
    b.slotOf[b.object[j]], slots[b.seat[j]] = j, j
    if j <= b.lastBody then
      b.origin[2 * j], b.origin[2 * j + 1] = b.from[2 * j], b.from[2 * j + 1]
    end
    if b.placed[j] ~= 0 then
      b.broadphase:remove(i)
      b.broadphase:insert(j)
    end
    blank(b, EVERY, i, i)
    movedTo[i], places[#places + 1] = nil, i
  end
  work.leftCount = 0
end

-- Makes room for `count` more bodies with all columns.
local function makeRoom(b, count)
  local first = b.lastBody + 1
  if #b.slotWork.free + b.lastBody - b.lastUsed >= count then
    return
  end
  b.lastBody = b.lastBody + max(count, ROOM, floor(b.lastBody / MORE))
  b.slots = max(b.slots, b.lastBody)
  prepare(b, EVERY, b.slots)
  for i = first, b.lastBody do
    if b.object[i] and not b.slotWork.movedTo[i] then
      note(b, i, takePlace(b, 1))
    end
  end
  moveNoted(b) -- and the bodies that were noted before
end

-- Notes the bodies of a list that have no slot with all columns, and takes one for each.
local function noteAll(b, list, count)
  for n = 1, count do
    if list[n] > b.lastBody and not b.slotWork.movedTo[list[n]] then
      makeRoom(b, 1) -- (it may move the body)
      note(b, list[n], takeBody(b, 1))
    end
  end
end

--- Gives the bodies of the pairs in b.linkOne and b.linkOther slots with all columns.
function allot.embodyLinked(b, count)
  b.linkCount = count
  noteAll(b, b.linkOne, count)
  noteAll(b, b.linkOther, count)
  if b.slotWork.leftCount > 0 then
    moveNoted(b)
  end
end

--- Gives a body a slot with all columns. Returns its slot.
function allot.embody(b, i)
  b.linkOne[1], b.linkOther[1] = i, i
  allot.embodyLinked(b, 1)
  return b.linkOne[1]
end

-- Coming and going -------------------------------------------------------------------------------

--- Takes a slot for a new object and returns it. All its columns have their initial values.
--- `coming`: it is the first of so many.
function allot.claim(b, isStatic, coming)
  if not b.object then
    make(b)
  end
  b.count = b.count + 1
  if not isStatic then
    makeRoom(b, coming)
    return takeBody(b, coming)
  elseif b.lastBody == math.huge then
    b.lastBody, b.slots = b.lastUsed + ROOM, b.lastUsed + ROOM
    prepare(b, EVERY, b.lastBody)
  end
  return takePlace(b, coming)
end

--- Gives the columns of bodies their first values: a body has got another kind.
function allot.clear(b, i)
  if i <= b.lastBody then
    blank(b, BODY, i, i)
  end
end

--- Gives a slot back. Its pairs must have been unlinked.
function allot.release(b, i)
  local list = i > b.lastBody and b.slotWork.freePlaces or b.slotWork.free
  allot.clear(b, i)
  blank(b, EVERY, i, i)
  b.count, list[#list + 1] = b.count - 1, i
end

return allot
