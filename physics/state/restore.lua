--- Restores a world from a state (see format.lua).
--
-- First the game's tables get what the library read from them last, and are read. Then the columns
-- that outlive a step are filled. Then the values are written that the game had written since. So
-- the next step finds everything as it was.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local read = require(root .. ".objects.read")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local interpreted = require(root .. ".memory.jit")
local notice = require(root .. ".queries.notice")
local memory = require(root .. ".state.restoreMemory")
local own = require(root .. ".state.own")
local restoreFields = require(root .. ".state.restoreFields")
local settings = require(root .. ".world.settings")
local format = require(root .. ".state.format")
local verify = require(root .. ".state.validate")
local zones = require(root .. ".motion.zones")

local restore = {}

local STATIC = columns.STATIC
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
      restoreFields.overwrite(row, wanted[group])
      wanted[group] = row
    end
    restoreFields.overwrite(known, wanted)
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
  for _, name in ipairs(format.SETTINGS) do
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
  elseif not world.order or not restoreFields.isSameList(saved.order, world.order) then
    world.order = format.copyList(saved.order)
  end
  settings.apply(world)
  -- Whatever the masks were before, and what was soft, the next step applies them anew: the state
  -- may have a contact that they forbid.
  local b = world._bodies
  b.rowsSeen, b.isRemasked = {}, true
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
  local named = restoreFields.recall(b, st, objects, tables.gone)
  local visit = listVisits(b, tables, st.count)
  memory.forget(b)
  restoreSettings(world, st.settings, tables)
  restoreFields.write(st, objects, masks, visit)
  local unread = restoreFields.writeRead(st, objects)
  placeKnown(world, st, objects)
  memory.readAgain(b, objects, st.known, visit)
  collectKnown(world, st)
  memory.remember(b, st, objects, named, visit)
  if unread then
    restoreFields.write(st, objects, masks, visit, unread)
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

interpreted.always(masksOf, areSameMasks, writeMasks)
interpreted.always(emptyGroups, restore.world)

return restore
