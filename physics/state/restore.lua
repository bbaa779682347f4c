--- Restores a world from a state (see format.lua).
--
-- The game's tables get their saved fields and places, and are read. Then the columns that outlive
-- a step are filled. So the next step finds everything as it was.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".fields.check")
local columns = require(root .. ".memory.columns")
local compare = require(root .. ".objects.compare")
local pairFinder = require(root .. ".broadphase.pairFinder")
local events = require(root .. ".contacts.events")
local fields = require(root .. ".fields.fields")
local format = require(root .. ".state.format")
local notice = require(root .. ".objects.notice")
local own = require(root .. ".state.own")
local read = require(root .. ".objects.read")
local islands = require(root .. ".sleep.islands")
local settings = require(root .. ".objects.settings")
local validate = require(root .. ".state.validate")
local zones = require(root .. ".motion.zones")

local restore = {}

local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local COLUMNS, LINKS, PAIRS, EVENT = format.COLUMNS, format.LINKS, format.PAIRS, format.EVENT
local max, min = math.max, math.min

-- Which table is which object ---------------------------------------------------------------------

-- Calls visit(n, group, key) for each object of a state; the key of a direct one is nil.
local function forEach(st, visit)
  local n = 0
  for _, group in ipairs(st.groups) do
    for m = 1, group.count do
      n = n + 1
      visit(n, group.name, not group.direct and (group.keys and group.keys[m] or m) or nil)
    end
  end
end

local function isDirect(members)
  return type(members) == "table" and type(members.width) == "number"
end

-- Finds objects for a state from elsewhere: those at the same places, and new ones.
local function matchByPlace(world, st)
  local objects, taken = {}, {}
  forEach(st, function(n, name, key)
    local object = world.objects[name]
    if isDirect(object) ~= (key == nil) then
      object = nil
    elseif key ~= nil and type(object) == "table" then
      object = object[key]
    end
    if type(object) ~= "table" or taken[object] then
      object = {}
    end
    objects[n], taken[object] = object, true
  end)
  return objects
end

-- A sentence that names the first group under numbers that has another count of objects here than
-- in a state from elsewhere: what the game has put into them may be on other objects. nil: none.
local function misfit(world, st)
  for _, group in ipairs(st.groups) do
    local members, count = world.objects[group.name], group.count
    local isNumbered = not group.direct and (not group.keys or type(group.keys[count]) == "number")
    local here = type(members) == "table" and not isDirect(members) and #members or 0
    if isNumbered and count ~= here and here > 0 then
      return (
        "%s has %d objects in the state and %d here: numbers shift when an object is removed,"
        .. " so your own fields may be on other objects. String keys stay."
      ):format(check.place(group.name), count, here)
    end
  end
end

-- Returns all objects that a state names, by number: if this world has saved it, the same tables.
-- Second: what does not fit (see misfit).
local function match(world, st)
  local known = world._bodies.tablesOf and world._bodies.tablesOf[st]
  local goneCount = st.gone and #st.gone or 0
  if known and #known == st.count + goneCount then
    return format.copyList(known)
  end
  local objects = matchByPlace(world, st)
  for n = st.count + 1, st.count + goneCount do
    objects[n] = {}
  end
  return objects, misfit(world, st)
end

-- The game's tables -------------------------------------------------------------------------------

-- Returns whether two values, or the entries of two tables, are the same.
local function isSame(one, other)
  if type(one) ~= "table" or type(other) ~= "table" then
    return one == other
  end
  for key, value in next, one, nil do
    if other[key] ~= value then
      return false
    end
  end
  for key in next, other, nil do
    if one[key] == nil then
      return false
    end
  end
  return true
end

-- Writes what a state holds of a field, nil: nothing. A table that says the same stays.
local function write(object, field, value)
  local make, now = format.MADE[field.type], object[field.name]
  if make and value ~= nil then
    value = make(value)
    value = isSame(now, value) and now or value
  end
  if now ~= value then
    object[field.name] = value
  end
end

local function writeField(st, objects, field)
  local name, list, at = field.name, st.fields[field.name], 1
  local isDense = format.isDense(field)
  for n = 1, st.count do
    local object, value = objects[n], nil
    if isDense then
      value = list[n] or nil
    elseif list[at] == n then
      value, at = list[at + 1], at + 2
    end
    if object[name] ~= value then
      write(object, field, value)
    end
  end
end

-- Gives objects that had left the world the fields that they had.
local function writeGone(b, st, objects)
  for n, saved in ipairs(st.gone or {}) do
    local object = objects[st.count + n]
    for _, field in ipairs(fields.saved) do
      write(object, field, saved[field.name])
    end
    if not (saved.static or saved.kinematic or type(object.touching) == "table") then
      object.touching = read.touchingFor(b, object)
    end
  end
end

local function clear(list)
  for key in next, list, nil do
    list[key] = nil
  end
end

-- Puts the objects into the game's groups. Groups that are not in the state are emptied.
local function place(world, st, objects)
  for name, members in next, world.objects, nil do
    if type(members) ~= "table" or isDirect(members) then
      world.objects[name] = nil
    else
      clear(members)
    end
  end
  for _, group in ipairs(st.groups) do
    world.objects[group.name] = not group.direct and (world.objects[group.name] or {}) or nil
  end
  forEach(st, function(n, name, key)
    if key == nil then
      world.objects[name] = objects[n]
    else
      world.objects[name][key] = objects[n]
    end
  end)
end

-- Settings ----------------------------------------------------------------------------------------

-- Returns rows that a state holds as { group, other, value, ... }, in the game's own tables where
-- these are there: the game may hold them.
local function rowsOf(list, now)
  local rows = type(now) == "table" and now or {}
  for group, row in next, rows, nil do
    if type(row) == "table" then
      clear(row)
    else
      rows[group] = nil
    end
  end
  for at = 1, #list, 3 do
    format.listIn(rows, list[at])[list[at + 1]] = list[at + 2]
  end
  return rows
end

local function restoreSettings(world, saved)
  for _, name in ipairs(format.SETTINGS) do
    world[name] = saved[name]
  end
  world.masks = saved.masks and rowsOf(saved.masks, world.masks)
  world.soft = saved.soft and rowsOf(saved.soft, world.soft)
  if not (saved.order and world.order and isSame(saved.order, world.order)) then
    world.order = saved.order and format.copyList(saved.order)
  end
  settings.apply(world)
  -- The state may have a contact that they forbid: the next step applies them anew.
  local b = world._bodies
  b.rowsSeen, b.isRemasked = {}, true
end

-- Reading -----------------------------------------------------------------------------------------

-- Reads the objects that `update` would not read again.
local function readStatic(b, st, objects)
  for n = 1, st.count do
    local object, i = objects[n], b.slotOf[objects[n]]
    local isStatic = i and b.kind[i] == STATIC
    if i and (isStatic or object.static) then
      if isStatic ~= (object.static or false) or compare.firstChanged(b, i, object) then
        read.refresh(b, i)
      end
    end
  end
end

-- Reads all objects in their old order. If the game has set another `order` since the last step, it
-- holds from the next step on.
local function readAll(world, st)
  local r, names = world._bodies.registry, {}
  for n, group in ipairs(st.groups) do
    names[n] = group.name
  end
  local order = r.order
  r.order, r.reorder = names, true
  read.run(world._bodies, world.objects)
  r.order, r.reorder = order, true
end

-- Memory ------------------------------------------------------------------------------------------

-- Forgets all events and all contacts, without events about it.
local function forget(b)
  events.forget(b.events)
  for c = 1, #PAIRS do
    local column = b[PAIRS[c][1]]
    for p = 1, b.pairSlots do
      column[p] = PAIRS[c][2]
    end
  end
  b.contactCount = 0
end

local function restoreColumn(b, list, slots, entry)
  local column, width, usual = b[entry[1]], entry[2], entry[3]
  local model, y = b[usual], width - 1
  for n = 1, #slots do
    local k = width * slots[n]
    if model then
      column[k], column[k + y] = model[k], model[k + y]
    else
      column[k], column[k + y] = usual, usual
    end
  end
  for at = 1, #list, 1 + width do
    local k = width * slots[list[at]]
    column[k], column[k + y] = list[at + 1], list[at + 1 + y]
  end
end

local function restoreLink(column, list, slots)
  for n = 1, #slots do
    column[slots[n]] = 0
  end
  for at = 1, #list, 2 do
    column[slots[list[at]]] = slots[list[at + 1]]
  end
end

-- Notes the history of a world, as far as it still matters (see the skip hints in initial.lua).
local function restoreHistory(b, memory)
  b.hasCarriers = b.hasCarriers or #memory.carrier > 0 or #memory.carried > 0
  b.hasCrushed = b.hasCrushed or #memory.wasCrushed > 0
  b.hasInside = b.hasInside or #memory.inside > 0
  b.hasCrowds = b.hasCrowds or #memory.crowd > 0
  b.hasPacked = b.hasPacked or #memory.packed > 0
end

local function restoreMemory(b, st, slots)
  restoreHistory(b, st.memory)
  for n = 1, #COLUMNS do
    restoreColumn(b, st.memory[COLUMNS[n][1]], slots, COLUMNS[n])
  end
  for n = 1, #LINKS do
    restoreLink(b[LINKS[n]], st.memory[LINKS[n]], slots)
  end
  b.movedCount, b.lostCount = 0, #st.lost
  for n = 1, #slots do
    local i = slots[n]
    b.fresh[i] = false
    islands.wake(b, i)
    columns.stand(b, i)
    if b.moved[i] then
      b.movedCount = b.movedCount + 1
      b.movedList[b.movedCount] = i
    end
  end
  for at = 1, b.lostCount do
    b.lost[at] = slots[st.lost[at]]
  end
end

local function restoreContacts(b, st, slots)
  local list = st.contacts
  pairFinder.run(b, slots, 1, #slots)
  for at = 1, #list, 2 + #PAIRS do
    local i, j = slots[list[at]], slots[list[at + 1]]
    local p = columns.pairOf(b, i, j) or columns.link(b, i, j)
    for c = 1, #PAIRS do
      local value = list[at + 1 + c]
      if b.pairA[p] ~= i and value ~= PAIRS[c][2] then
        value = PAIRS[c][3][value]
      end
      b[PAIRS[c][1]][p] = value
    end
    b.contactCount = b.contactCount + min(b.contact[p], 1)
  end
end

-- (`object.touching` may be the table of another world now, or of several objects.)
local function restoreTouching(b, st, objects, slots)
  for n = 1, st.count do
    local i = slots[n]
    if b.kind[i] == DYNAMIC then
      objects[n].touching = b.touching[i]
      read.takeTouching(b, i, b.touching[i])
      read.clearTouching(b.touching[i])
    end
  end
  for at = 1, #st.touching, 5 do
    local touching = b.touching[slots[st.touching[at]]]
    for side = 1, touching and 4 or 0 do
      touching[columns.SIDES[side]] = objects[st.touching[at + side]] or false
    end
  end
end

local function restoreEvents(b, st, objects)
  local e, list, n = b.events, st.events, 0
  for at = 1, #list, 3 + #EVENT do
    n = n + 1
    e.order[n], e.kindAndNumber[n] = n, n
    e.a[n], e.b[n] = objects[list[at]], objects[list[at + 1]]
    e.c[n] = objects[list[at + 2]] or false
    for m = 1, #EVENT do
      e[EVENT[m]][n] = list[at + 2 + m]
    end
  end
  e.count, e.told, e.heardBy = n, st.heardBy and 1 or 0, st.heardBy or 3
  e.sorted = max(st.sorted or 0, e.told)
end

--- Makes a world what it was when `st` was saved. Returns what does not fit (see misfit), or nil.
--- Errors: a state that cannot be used; then nothing has changed.
function restore.world(world, st)
  validate.state(st)
  local b, slots = world._bodies, {}
  if type(world.objects) ~= "table" then
    world.objects = {}
  end
  local objects, sentence = match(world, st)
  writeGone(b, st, objects)
  forget(b)
  restoreSettings(world, st.settings)
  for _, field in ipairs(fields.saved) do
    writeField(st, objects, field)
  end
  place(world, st, objects)
  readStatic(b, st, objects)
  readAll(world, st)
  events.forget(b.events)
  for n = 1, st.count do
    slots[n] = b.slotOf[objects[n]]
  end
  restoreMemory(b, st, slots)
  restoreContacts(b, st, slots)
  restoreTouching(b, st, objects, slots)
  restoreEvents(b, st, objects)
  own.restore(st, objects)
  world._walls = {}
  for side, n in next, st.walls, nil do
    world._walls[side] = objects[n]
  end
  world._saved = st.saved
  world.alpha = world.timestep and max(0, min(st.saved / world.timestep, 1)) or 0
  zones.restore(b)
  notice.outdate(b)
  return sentence
end

return restore
