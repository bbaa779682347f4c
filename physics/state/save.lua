--- Saves a world as a state (see format.lua). In a state, objects are numbers.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carrier = require(root .. ".objects.carriers")
local check = require(root .. ".world.check")
local fieldColumns = require(root .. ".objects.fieldColumns")
local fields = require(root .. ".world.fields")
local format = require(root .. ".state.format")
local interpreted = require(root .. ".memory.jit")
local own = require(root .. ".state.own")
local registry = require(root .. ".objects.registry")
local saveFields = require(root .. ".state.saveFields")
local saveMemory = require(root .. ".state.saveMemory")
local standing = require(root .. ".state.standing")

local state = {}

local listIn, cut = format.listIn, format.cut

-- Objects ----------------------------------------------------------------------------------------

-- Returns the working lists of a world: `objects` and `slots` by number, `numbers` by slot.
local function workOf(b)
  b.saving = b.saving or { objects = {}, slots = {}, numbers = {} }
  return b.saving
end

local function writeGroup(out, record)
  out.name, out.count, out.direct = record.name, record.count, record.direct
  out.keys = nil
  if not record.plain then
    local keys = {}
    for n = 1, record.count do
      keys[n] = record.keys[n]
    end
    out.keys = keys
  end
end

-- Gives each known object its number.
local function saveGroups(b, out, work)
  local list, groups, n = listIn(out, "groups"), b.registry.groups, 0
  local objects, slots, numbers = work.objects, work.slots, work.numbers
  for g = 1, #groups do
    local record = groups[g]
    writeGroup(listIn(list, g), record)
    for m = 1, record.count do
      local object = record.list[m]
      local slot = b.slotOf[object]
      n = n + 1
      objects[n], slots[n], numbers[slot] = object, slot, n
    end
  end
  cut(list, #groups)
  out.known = n
end

-- Saves what the tables hold now, if the library has not seen it yet.
local function saveTables(b, objects, out, work)
  out.tables, out.count = nil, out.known
  if not registry.hasChanged(b.registry, objects) then
    return
  end
  local list, numberOf = {}, {}
  for g, record in ipairs(registry.look(b, b.registry, objects)) do
    local numbers = {}
    for m = 1, record.tailCount do
      local object = record.tail[m]
      local slot = b.slotOf[object]
      if not slot then
        out.count = out.count + 1
        work.objects[out.count] = object
        numberOf[object] = out.count
      end
      numbers[m] = slot and work.numbers[slot] or numberOf[object]
    end
    list[g] =
      { name = record.name, direct = record.direct, keys = record.newKeys, objects = numbers }
  end
  out.tables = list
end

-- The world --------------------------------------------------------------------------------------

-- Returns the library's fields of an object that has left the world, as far as they are valid.
local function fieldsOf(object)
  local saved = {}
  for _, name in ipairs(fieldColumns.NAMES) do
    local value = object[name]
    if value ~= nil and check.accepts(fields.objectByName[name], value) then
      saved[name] = format.LISTED[name] and format.LISTED[name](value) or value
    end
  end
  return saved
end

local function saveGone(out, work)
  out.gone = work.goneCount > 0 and {} or nil
  for n = 1, work.goneCount do
    out.gone[n] = fieldsOf(work.objects[out.count + n])
  end
end

local function saveSettings(world, out)
  local settings = listIn(out, "settings")
  for _, name in ipairs(format.SETTINGS) do
    check.setting(name, world[name])
    settings[name] = world[name]
  end
  check.setting("masks", world.masks)
  check.setting("order", world.order)
  check.setting("soft", world.soft)
  settings.masks = world.masks and format.listMasks(world.masks) or nil
  settings.soft = world.soft and format.listMasks(world.soft) or nil
  settings.order = world.order and format.copyList(world.order)
end

-- How the game would write object n.
local function placeOf(b, out, work, n)
  local slot = n <= out.known and work.slots[n]
  if slot then
    return registry.placeOf(b, slot)
  end
  local object = work.objects[n]
  local group = b.registry.groupGiven[object]
  local members = group ~= nil and b.world.objects[group]
  local key = members and registry.find(members, object)
  return key ~= nil and check.place(group, key) or "an object that was added"
end

--- Fills `out` with the state of a world. Returns `work` with the objects by number, and behind
--- them the `goneCount` objects that have left. Errors: something that `update` would refuse.
function state.fill(world, out)
  local b = world._bodies
  local work = workOf(b)
  -- A restored world could not tell what the game has moved since the last step; so this is done
  -- now.
  carrier.checkMoved(b)
  out.version = format.VERSION
  saveSettings(world, out)
  out.saved = world._saved
  work.goneCount = 0
  saveGroups(b, out, work)
  saveTables(b, world.objects, out, work)
  standing.listVisits(b, out, work)
  saveFields(b, out, work)
  saveMemory(world, out, work)
  saveGone(out, work)
  own.save(world, out, work, placeOf)
  cut(work.objects, out.count + work.goneCount)
  if not work.fixed then
    b.fixed = false
    if work.isClean and not standing.hasMoved(b) then
      standing.note(b, out, work, fieldColumns.EVERY, fieldColumns.SOME)
    end
  end
  return work
end

-- Remembers which tables the masks of a world and their rows are.
local function noteMasks(tables, masks)
  local rows = tables.rows
  for group in next, rows, nil do
    rows[group] = nil
  end
  if masks then
    for group, row in next, masks, nil do
      rows[group] = row
    end
  end
  tables.worldMasks = masks or false
end

--- Returns the state of a world, in `out` if that is given. As long as that table lives, the world
--- remembers which tables its objects are.
function state.save(world, out)
  local b = world._bodies
  out = out or {}
  local work = state.fill(world, out)
  b.tablesOf = b.tablesOf or setmetatable({}, { __mode = "k" })
  local tables = b.tablesOf[out]
  if not tables then
    tables = { objects = {}, masks = {}, gone = {}, rows = {} }
    b.tablesOf[out] = tables
  end
  tables.staticVersion = b.fixed and b.staticVersion or false
  for n = 1, out.count do
    tables.objects[n] = work.objects[n]
    tables.masks[n] = work.objects[n].mask or false
  end
  for n = 1, work.goneCount do
    tables.gone[n] = work.objects[out.count + n]
  end
  noteMasks(tables, world.masks)
  cut(tables.objects, out.count)
  cut(tables.masks, out.count)
  cut(tables.gone, work.goneCount)
  return out
end

interpreted.always(noteMasks)

return state
