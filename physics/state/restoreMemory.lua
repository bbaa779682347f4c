--- Gives a world the memory of a state: columns that outlive a step, contacts, events that wait.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local detect = require(root .. ".broadphase.pairFinder")
local events = require(root .. ".contacts.events")
local fieldColumns = require(root .. ".objects.fieldColumns")
local format = require(root .. ".state.format")
local read = require(root .. ".objects.read")
local rest = require(root .. ".sleep.islands")

local memory = {}

local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local max = math.max

--- Forgets all events and all contacts, without events about it.
function memory.forget(b)
  events.forget(b.events)
  for p = 1, b.pairSlots do
    for _, entry in ipairs(format.PAIRS) do
      b[entry[1]][p] = entry[2]
    end
  end
  b.contactCount = 0
end

-- Returns whether the columns hold an object's fields, for those fields that `update` does not
-- compare.
local function isRead(b, i, object)
  if b.kind[i] ~= columns.kindOf(object) then
    return false
  elseif b.kind[i] ~= STATIC then
    return true
  end
  return not fieldColumns.firstChanged(b, i, object)
end

--- Reads the objects again that `update` would not read again.
function memory.readAgain(b, objects, known, visit)
  for m = 1, #visit do
    local n = visit[m]
    local slot = n <= known and b.slotOf[objects[n]]
    if slot and not isRead(b, slot, objects[n]) then
      read.refresh(b, slot)
    end
  end
end

-- Gives objects their written positions, clears their past and wakes them.
local function settle(b, list)
  for n = 1, #list do
    local i = list[n]
    local k = 2 * i
    for axis = k, k + 1 do
      b.position[axis] = b.written[axis]
    end
    for _, name in ipairs(format.FLAGS) do
      b[name][i] = false
    end
    for _, name in ipairs(format.LINKS) do
      b[name][i] = 0
    end
    b.fresh[i] = false
    rest.wake(b, i)
  end
  b.movedCount, b.lostCount = 0, 0
end

local function rememberPoints(b, st, slots, present)
  for _, entry in ipairs(format.POINTS) do
    local list, column, usual = st.memory[entry[1]], b[entry[1]], entry[2]
    local model = b[usual]
    for n = 1, #present do
      local k = 2 * present[n]
      column[k], column[k + 1] = model and model[k] or usual, model and model[k + 1] or usual
    end
    for at = 1, #list, 3 do
      local k = 2 * slots[list[at]]
      column[k], column[k + 1] = list[at + 1], list[at + 2]
    end
  end
end

-- Sets what the world knows of its past, as far as it still matters.
local function rememberHistory(b, saved)
  b.hasCarriers = b.hasCarriers or #saved.carrier > 0 or #saved.carried > 0
  b.hasCrushed = b.hasCrushed or #saved.wasCrushed > 0
  b.hasInside = b.hasInside or #saved.inside > 0
  b.hasCrowds = b.hasCrowds or #saved.crowd > 0
  b.hasKnots = b.hasKnots or #saved.stuck > 0 or #saved.exiting > 0 or #saved.knotted > 0
end

local function rememberSlots(b, st, slots)
  for _, name in ipairs(format.FLAGS) do
    local list = st.memory[name]
    for at = 1, #list do
      b[name][slots[list[at]]] = true
    end
  end
  for _, name in ipairs(format.LINKS) do
    local list = st.memory[name]
    for at = 1, #list, 2 do
      b[name][slots[list[at]]] = slots[list[at + 1]]
    end
  end
  for n = 1, st.known do
    if b.moved[slots[n]] then
      b.movedCount = b.movedCount + 1
      b.movedList[b.movedCount] = slots[n]
    end
  end
  for at, n in ipairs(st.memory.lost) do
    b.lost[at] = slots[n]
  end
  b.lostCount = #st.memory.lost
end

-- Lets objects stand where they are.
local function stand(b, list)
  for n = 1, #list do
    columns.stand(b, list[n])
  end
  detect.run(b, list, 1, #list)
end

local function rememberContacts(b, st, slots)
  local list, PAIRS = st.contacts, format.PAIRS
  local step = 2 + #PAIRS
  for at = 1, #list, step do
    local i, j = slots[list[at]], slots[list[at + 1]]
    local p = columns.pairOf(b, i, j) or columns.link(b, i, j)
    for c = 1, #PAIRS do
      local entry, value = PAIRS[c], list[at + 1 + c]
      if b.pairA[p] ~= i and value ~= entry[2] then
        value = entry[3][value]
      end
      b[entry[1]][p] = value
    end
    if b.contact[p] ~= 0 then
      b.contactCount = b.contactCount + 1
    end
  end
end

-- (`object.touching` may be the table of another world now, or of several objects.)
local function rememberTouching(b, st, objects, named, slots)
  for n = 1, st.known do
    local i, object = slots[n], objects[n]
    if b.kind[i] == DYNAMIC then
      local touching = b.touching[i]
      object.touching = touching
      read.takeTouching(b, i, touching)
      read.clearTouching(touching)
    end
  end
  local list = st.touching
  for at = 1, #list, 5 do
    local t = b.touching[slots[list[at]]]
    if t then
      t.left, t.right = named[list[at + 1]] or false, named[list[at + 2]] or false
      t.top, t.bottom = named[list[at + 3]] or false, named[list[at + 4]] or false
    end
  end
end

local function rememberEvents(b, st, named)
  local e, list, EVENT = b.events, st.events, format.EVENT
  local n = 0
  for at = 1, #list, 3 + #EVENT do
    n = n + 1
    e.order[n], e.kindAndNumber[n] = n, n
    e.a[n], e.b[n] = named[list[at]], named[list[at + 1]]
    e.c[n] = named[list[at + 2]] or false
    for m = 1, #EVENT do
      e[EVENT[m]][n] = list[at + 2 + m]
    end
  end
  e.count, e.told, e.heardBy = n, st.heardBy and 1 or 0, st.heardBy or 3
  e.sorted = max(st.sorted or 0, e.told)
end

--- Fills the memory. `named` are the objects by number, also those that have left the world;
--- `visit` lists the numbers of those to look at.
function memory.remember(b, st, objects, named, visit)
  local slots, present = {}, {}
  for n = 1, st.known do
    slots[n] = b.slotOf[objects[n]]
  end
  for m = 1, #visit do
    present[m] = slots[visit[m]] -- (Those that are not known come last.)
  end
  settle(b, present)
  rememberHistory(b, st.memory)
  rememberPoints(b, st, slots, present)
  rememberSlots(b, st, slots)
  stand(b, present)
  rememberContacts(b, st, slots)
  rememberTouching(b, st, objects, named, slots)
  rememberEvents(b, st, named)
end

return memory
