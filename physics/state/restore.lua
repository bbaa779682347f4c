--- Restores a world from a state (see save.lua).
--
-- First the game's tables get what the library read from them last, and are read. Then the columns
-- that outlive a step are filled. Then the values are written that the game had written since. So
-- the next step finds everything as it was.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local read = require(root .. ".objects.read")
local columns = require(root .. ".memory.columns")
local detect = require(root .. ".broadphase.pairFinder")
local events = require(root .. ".contacts.events")
local fields = require(root .. ".world.fields")
local filter = require(root .. ".broadphase.filter")
local interpreted = require(root .. ".memory.jit")
local notice = require(root .. ".queries.notice")
local own = require(root .. ".state.own")
local rest = require(root .. ".sleep.islands")
local settings = require(root .. ".world.settings")
local state = require(root .. ".state.save")
local verify = require(root .. ".state.validate")
local zones = require(root .. ".motion.zones")

local restore = {}

local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC
local max, min = math.max, math.min

-- Which table is which object --------------------------------------------------------------------

-- Returns the object that stands at a place now, or nil.
local function standing(world, group, direct, key)
  local members = world.objects[group]
  if type(members) ~= "table" then
    return nil
  end
  local isDirect = type(members.width) == "number"
  local object = nil
  if direct then
    object = isDirect and members
  elseif not isDirect then
    object = members[key]
  end
  return type(object) == "table" and object or nil
end

local function take(objects, taken, n, object)
  if object and not objects[n] and not taken[object] then
    objects[n], taken[object] = object, true
  end
end

-- Finds objects for a state that another world saved: those that stand at the same places.
local function matchByPlace(world, st)
  local objects, taken = {}, {}
  for _, group in ipairs(st.tables or {}) do
    for m, n in ipairs(group.objects) do
      take(objects, taken, n, standing(world, group.name, group.direct, group.keys[m]))
    end
  end
  local n = 0
  for _, group in ipairs(st.groups) do
    for m = 1, group.count do
      n = n + 1
      local key = group.keys and group.keys[m] or m
      if not st.tables then
        take(objects, taken, n, standing(world, group.name, group.direct, key))
      end
    end
  end
  for m = 1, st.count do
    objects[m] = objects[m] or {}
  end
  return objects
end

-- A sentence that names the first group under numbers that has another count of objects here than
-- in a state from elsewhere: what the game has put into them may be on other objects. nil: none.
local function misfit(world, st)
  for _, group in ipairs(st.tables or st.groups) do
    local members = world.objects[group.name]
    local count = group.count or #group.objects
    local isNumbered = not group.direct and (not group.keys or type(group.keys[count]) == "number")
    local here = type(members) == "table" and type(members.width) ~= "number" and #members or 0
    if isNumbered and count ~= here and here > 0 then
      return (
        "%s has %d objects in the state and %d here: numbers shift when an object is removed,"
        .. " so your own fields may be on other objects. String keys stay."
      ):format(check.place(group.name), count, here)
    end
  end
end

-- Returns which tables the objects were when the state was saved, as far as known: `objects` by
-- number. If this world has saved the state, also their `masks`, the objects that had `gone`, the
-- masks of the world (`worldMasks`) and their `rows`. Second: what does not fit (see misfit).
local function match(world, st)
  local tables = world._bodies.tablesOf and world._bodies.tablesOf[st]
  if tables and #tables.objects == st.count then
    return tables
  end
  local sentence = misfit(world, st)
  return { objects = matchByPlace(world, st), masks = {}, gone = {}, rows = {} }, sentence
end

-- Lists the objects to look at, by number: all, or if no static object has come, gone or been read
-- again since the state was saved, all others.
local function listVisits(b, tables, count)
  local visit, at = {}, 0
  local isFixed = tables.staticVersion == b.staticVersion and not b.newcomers
  local objects, slotOf, kind = tables.objects, b.slotOf, b.kind
  for n = 1, count do
    local slot = isFixed and slotOf[objects[n]]
    if not slot or kind[slot] ~= STATIC then
      at = at + 1
      visit[at] = n
    end
  end
  return visit
end

-- Fields -----------------------------------------------------------------------------------------

local function write(object, name, value)
  if object[name] ~= value then
    object[name] = value
  end
end

local function isSameList(list, other)
  for n = 1, max(#list, #other) do
    if list[n] ~= other[n] then
      return false
    end
  end
  return true
end

local function tableOf(list)
  local mask = {}
  for at = 1, #list, 2 do
    mask[list[at]] = list[at + 1]
  end
  return mask
end

-- Gives a table the contents of another one.
local function overwrite(list, contents)
  for key in next, list, nil do
    list[key] = nil
  end
  for key, value in next, contents, nil do
    list[key] = value
  end
end

-- Writes a mask, into its old table if that is known.
local function writeMask(object, list, known)
  local wanted, mask = tableOf(list), known or object.mask
  if type(mask) == "table" and filter.isSameMask(wanted, mask) then
    wanted = mask
  elseif known then
    overwrite(known, wanted)
    wanted = known
  end
  write(object, "mask", wanted)
end

-- Writes an area; the table that is there stays if it says the same.
local function writeArea(object, list)
  local wanted = tableOf(list)
  if not zones.isSame(object.area, wanted) then
    object.area = wanted
  end
end

-- Writes a list of what an object hits; one that says the same stays the same list.
local function writeHits(object, list)
  local now = object.hits
  if not (type(now) == "table" and isSameList(list, now)) then
    write(object, "hits", state.copyList(list))
  end
end

-- Writes a sparse list of values. Objects that are not in it have no value.
local function writeSparse(objects, masks, name, list, visit)
  local at, isMask = 1, name == "mask"
  for m = 1, #visit do
    local n = visit[m]
    local object = objects[n]
    while list[at] and list[at] < n do
      at = at + 2
    end
    if list[at] ~= n then
      write(object, name, nil)
    elseif isMask then
      writeMask(object, list[at + 1], masks[n])
      at = at + 2
    elseif name == "area" then
      writeArea(object, list[at + 1])
      at = at + 2
    elseif name == "hits" then
      writeHits(object, list[at + 1])
      at = at + 2
    else
      write(object, name, list[at + 1])
      at = at + 2
    end
  end
end

local function writeDense(objects, name, list, visit)
  for m = 1, #visit do
    local n = visit[m]
    write(objects[n], name, list[n] or nil)
  end
end

-- Writes the fields of the objects to visit as they were when the state was saved; with `only`,
-- just those.
local function writeFields(st, objects, masks, visit, only)
  for _, entry in ipairs(state.DENSE) do
    local name = entry[1]
    if not only or only[name] then
      writeDense(objects, name, st[name], visit)
    end
  end
  for _, entry in ipairs(state.SPARSE) do
    local name = entry[1]
    if not only or only[name] then
      writeSparse(objects, masks, name, st.fields[name], visit)
    end
  end
end

-- Writes what the library had read, where that was something else. Returns the names of these
-- fields.
local function writeRead(st, objects)
  local names, any = {}, false
  for name, list in next, st.read, nil do
    local isBoolean = fields.objectByName[name] and fields.objectByName[name].type == "boolean"
    for at = 1, #list, 2 do
      local value = list[at + 1]
      if (name == "mask" or name == "area") and value then
        value = tableOf(value)
      elseif name == "hits" and value then
        value = state.copyList(value)
      elseif value == false and not isBoolean then
        value = nil
      end
      objects[list[at]][name] = value
      names[name], any = true, true
    end
  end
  return any and names
end

-- Writes the fields of an object that had left the world.
local function writeGone(b, object, saved)
  for _, name in ipairs(state.FIELDS) do
    if name == "mask" and saved.mask then
      writeMask(object, saved.mask)
    elseif name == "area" and saved.area then
      writeArea(object, saved.area)
    elseif name == "hits" and saved.hits then
      writeHits(object, saved.hits)
    else
      write(object, name, saved[name])
    end
  end
  if not (saved.static or saved.kinematic or type(object.touching) == "table") then
    object.touching = read.touchingFor(b, object)
  end
end

-- Returns all objects that a state names by number: those of the world, then those that had left
-- it, as new tables if `gone` does not have them.
local function recall(b, st, objects, gone)
  if not st.gone then
    return objects
  end
  local named = {}
  for n = 1, st.count do
    named[n] = objects[n]
  end
  for n, saved in ipairs(st.gone) do
    local object = gone[n] or {}
    writeGone(b, object, saved)
    named[st.count + n] = object
  end
  return named
end

-- Tables -----------------------------------------------------------------------------------------

local function emptyGroups(objects)
  for name, members in next, objects, nil do
    if type(members) ~= "table" or type(members.width) == "number" then
      objects[name] = nil
    else
      for key in next, members, nil do
        members[key] = nil
      end
    end
  end
end

-- Returns the table of a group to be filled. An object's own table is never a group.
local function groupIn(objects, name)
  local members = objects[name]
  if members == nil then
    members = {}
    objects[name] = members
  end
  return members
end

-- Puts the objects where they were when the library looked last.
local function placeKnown(world, st, objects)
  emptyGroups(world.objects)
  local n = 0
  for _, group in ipairs(st.groups) do
    if group.direct then
      n = n + 1
      world.objects[group.name] = objects[n]
    else
      local members = groupIn(world.objects, group.name)
      for m = 1, group.count do
        n = n + 1
        members[group.keys and group.keys[m] or m] = objects[n]
      end
    end
  end
end

-- Gives an object that was added since then the `touching` that `add` had given it.
local function giveTouching(b, object, group)
  if not object.static and not object.kinematic then
    local touching = read.touchingFor(b, object)
    read.clearTouching(touching)
    object.touching = touching
    b.registry.given[object], b.registry.groupGiven[object] = touching, group
  end
end

-- Puts the objects where the game had put them since then.
local function placeNow(world, st, objects)
  if not st.tables then
    return
  end
  emptyGroups(world.objects)
  for _, group in ipairs(st.tables) do
    local members = not group.direct and groupIn(world.objects, group.name)
    for m, n in ipairs(group.objects) do
      if members then
        members[group.keys[m]] = objects[n]
      else
        world.objects[group.name] = objects[n]
      end
      if n > st.known then
        giveTouching(world._bodies, objects[n], group.name)
      end
    end
  end
end

-- The library's memory ---------------------------------------------------------------------------

-- Forgets all events and all contacts, without events about it.
local function forget(b)
  events.forget(b.events)
  for p = 1, b.pairSlots do
    for _, entry in ipairs(state.PAIRS) do
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
  for _, entry in ipairs(state.DENSE) do
    local value = object[entry[1]]
    if entry[2] ~= "velocity" and value ~= b[entry[2]][2 * i + entry[3]] then
      return false
    end
  end
  for _, entry in ipairs(state.SPARSE) do
    if entry[2] then
      local value, at = object[entry[1]], entry[4] and 2 * i + entry[4] or i
      if value == nil then
        value = entry[3]
      end
      if value ~= b[entry[2]][at] then
        return false
      end
    end
  end
  local isSameMask = filter.isSameMask(object.mask, b.mask[i])
  local isSame = isSameMask and zones.isSame(object.area, b.area[i])
  local isSameHits = object.hits == (b.hitsGiven[i] or nil)
  return isSame and isSameHits and (object.friction or -1) == b.friction[i]
end

-- Reads the objects again that `update` would not read again.
local function readAgain(b, objects, known, visit)
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
    for _, name in ipairs(state.FLAGS) do
      b[name][i] = false
    end
    for _, name in ipairs(state.LINKS) do
      b[name][i] = 0
    end
    b.fresh[i] = false
    rest.wake(b, i)
  end
  b.movedCount, b.lostCount = 0, 0
end

local function rememberPoints(b, st, slots, present)
  for _, entry in ipairs(state.POINTS) do
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
local function rememberHistory(b, memory)
  b.hasCarriers = b.hasCarriers or #memory.carrier > 0 or #memory.carried > 0
  b.hasCrushed = b.hasCrushed or #memory.wasCrushed > 0
  b.hasInside = b.hasInside or #memory.inside > 0
  b.hasCrowds = b.hasCrowds or #memory.crowd > 0
  b.hasKnots = b.hasKnots or #memory.stuck > 0 or #memory.exiting > 0 or #memory.knotted > 0
end

local function rememberSlots(b, st, slots)
  for _, name in ipairs(state.FLAGS) do
    local list = st.memory[name]
    for at = 1, #list do
      b[name][slots[list[at]]] = true
    end
  end
  for _, name in ipairs(state.LINKS) do
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
  local list, PAIRS = st.contacts, state.PAIRS
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
  local e, list, EVENT = b.events, st.events, state.EVENT
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

local function remember(b, st, objects, named, visit)
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

-- The world --------------------------------------------------------------------------------------

-- Returns the masks of a world as a table. A list cannot hold empty rows: they come from `rows`.
local function masksOf(list, rows)
  local masks = {}
  for group, row in next, rows, nil do
    if type(row) == "table" and (type(group) == "string" or check.isFinite(group)) then
      masks[group] = {}
    end
  end
  for at = 1, #list, 3 do
    local group = masks[list[at]] or {}
    masks[list[at]] = group
    group[list[at + 1]] = list[at + 2]
  end
  return masks
end

local function areSameMasks(masks, other)
  for group, row in next, masks, nil do
    if not filter.isSameMask(row, other[group]) then
      return false
    end
  end
  for group in next, other, nil do
    if masks[group] == nil then
      return false
    end
  end
  return true
end

-- Writes the masks of a world, into their old tables if those are known.
local function writeMasks(world, list, tables)
  local known = tables.worldMasks
  local masks = known or (type(world.masks) == "table" and world.masks) or {}
  local wanted = masksOf(list, known and tables.rows or masks)
  if areSameMasks(wanted, masks) then
    wanted = masks
  elseif known then
    for group, row in next, tables.rows, nil do
      overwrite(row, wanted[group])
      wanted[group] = row
    end
    overwrite(known, wanted)
    wanted = known
  end
  world.masks = wanted
end

-- Writes what is soft; a table that says the same stays the same table.
local function writeSoft(world, list)
  local wanted = list and masksOf(list, {}) or nil
  if not (wanted and type(world.soft) == "table" and areSameMasks(wanted, world.soft)) then
    world.soft = wanted
  end
end

-- Writes the settings. A list or table of the world that already says the same is kept.
local function restoreSettings(world, saved, tables)
  for _, name in ipairs(state.SETTINGS) do
    world[name] = saved[name]
  end
  if saved.masks then
    writeMasks(world, saved.masks, tables)
  else
    world.masks = nil
  end
  writeSoft(world, saved.soft)
  if not saved.order then
    world.order = nil
  elseif not world.order or not isSameList(saved.order, world.order) then
    world.order = state.copyList(saved.order)
  end
  settings.apply(world)
  -- Whatever the masks were before, the next step applies them anew.
  world._bodies.masksSeen, world._bodies.isRemasked = false, true
end

-- Reads the known objects in their old order. If the game has set another `order` since the last
-- step, it holds from the next step on.
local function collectKnown(world, st)
  local r, names = world._bodies.registry, {}
  for n, group in ipairs(st.groups) do
    names[n] = group.name
  end
  local order = r.order
  r.order, r.reorder = names, true
  read.run(world._bodies, world.objects)
  r.order, r.reorder = order, true
end

--- Makes a world what it was when `st` was saved. Errors: a state that cannot be used; then nothing
--- has changed.
function restore.world(world, st)
  verify.state(st)
  local b = world._bodies
  if type(world.objects) ~= "table" then
    world.objects = {}
  end
  local tables, sentence = match(world, st)
  local objects, masks = tables.objects, tables.masks
  local named = recall(b, st, objects, tables.gone)
  local visit = listVisits(b, tables, st.count)
  forget(b)
  restoreSettings(world, st.settings, tables)
  writeFields(st, objects, masks, visit)
  local unread = writeRead(st, objects)
  placeKnown(world, st, objects)
  readAgain(b, objects, st.known, visit)
  collectKnown(world, st)
  remember(b, st, objects, named, visit)
  if unread then
    writeFields(st, objects, masks, visit, unread)
  end
  placeNow(world, st, objects)
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

interpreted.always(overwrite, masksOf, areSameMasks, writeMasks)
interpreted.always(writeRead, emptyGroups, restore.world)

return restore
