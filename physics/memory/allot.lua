---@diagnostic disable
--- Gives each object a slot, that is an index in the columns of a world, and makes the columns.
--
-- Writes the initial values of all columns of new objects, and makes those of pairs.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local arrays = require(root .. ".memory.arrays")
local constants = require(root .. ".memory.constants")
local initial = require(root .. ".memory.initial")
local layout = require(root .. ".memory.layout")

local allot = {}

local floor, remove = math.floor, table.remove
local STATIC = constants.STATIC
local OBJECT, BODY, MOVER = layout.OBJECT, layout.BODY, layout.MOVER
-- In front of many static objects that come at once, there is a free slot for a mover in so many.
local SHARE = 64

--- Makes room in some columns for the index `last`. If `fills`, new places have the first values.
--- (They are filled column by column. Slot by slot, 20 000 tiles take twice as long.)
function allot.reserve(b, rows, last, fills)
  local old = b.reserved[rows] ---@type number
  if last < old then
    return
  end
  local count = arrays.places(old, last + 1)
  for n = 1, #rows.names do
    local name, width, kind, value = rows.names[n], rows.widths[n], rows.kinds[n], rows.values[n]
    local column = arrays.grow(kind, b[name], width, old, count)
    local shift = width == 4 and 1 or 0 -- sides are 1 to 4
    local mustFill = fills and not arrays.begins(kind, value)
    for at = width * old + shift, mustFill and width * count + shift - 1 or -1 do
      column[at] = value
    end
    b[name] = column
  end
  b.reserved[rows] = count
end

--- Gives the slots in places `first` to `last` of a list the initial values of some columns.
function allot.blank(b, rows, slots, first, last)
  for n = 1, first <= last and #rows.names or 0 do
    local column, value, width = b[rows.names[n]], rows.values[n], rows.widths[n]
    local shift = width == 4 and 1 or 0 -- sides are 1 to 4
    for place = shift, shift + width - 1 do
      for m = first, last do
        column[width * slots[m] + place] = value
      end
    end
  end
end

local blank, reserve = allot.blank, allot.reserve

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
  for _, rows in ipairs({ OBJECT, BODY, MOVER, layout.PAIR, layout.LINKS }) do
    add(b, rows.names)
    b.reserved[rows] = 0
    reserve(b, rows, 0, true)
  end
  -- Slot 0 is the empty slot, that of unlinked pairs. Its size is negative, so it meets nothing.
  b.size[0], b.size[1] = -1, -1
end

-- Coming and going -------------------------------------------------------------------------------

--- Takes a slot for a new object and returns it. All its columns have their initial values, but
--- those of movers may not reach it yet: for a mover `allot.addMover` must follow.
--- `coming`: it is the first of so many. (Movers get slots that are close together, before the
--- static ones that come with them: the columns of movers end with the last mover.)
function allot.claim(b, isStatic, coming)
  if not b.object then
    make(b)
  end
  local i = remove(isStatic and b.freeStatic or b.freeMovers)
  if not i then
    if isStatic and #b.freeMovers == 0 then -- leave some slots to movers that come later
      local last = b.slots + floor(coming / SHARE)
      for slot = last, b.slots + 1, -1 do
        b.freeMovers[#b.freeMovers + 1] = slot
      end
      b.slots = last
    end
    i = b.slots + 1
    b.slots = i
    if i >= b.reserved[OBJECT] then
      reserve(b, OBJECT, i + coming - 1, true)
      reserve(b, BODY, i + coming - 1, true)
      reserve(b, MOVER, isStatic and 0 or i + coming - 1, true)
    end
  end
  b.count = b.count + 1
  return i
end

--- Gives the columns that steps write their first values: an object gets another kind, and still
--- has the old one.
function allot.clear(b, i)
  b.stack[1] = i
  blank(b, BODY, b.stack, 1, 1)
  blank(b, MOVER, b.stack, 1, b.kind[i] == STATIC and 0 or 1)
end

--- Makes room for slot i in the columns of movers.
function allot.addMover(b, i)
  reserve(b, MOVER, i, true)
end

--- Gives slots back. Their pairs must have been unlinked.
function allot.release(b, slots)
  local movers, before = b.freeMovers, #b.freeMovers
  for n = 1, #slots do
    local free = b.kind[slots[n]] > STATIC and movers or b.freeStatic
    free[#free + 1] = slots[n]
  end
  blank(b, OBJECT, slots, 1, #slots)
  blank(b, BODY, slots, 1, #slots)
  blank(b, MOVER, movers, before + 1, #movers)
  b.count = b.count - #slots
end

return allot
