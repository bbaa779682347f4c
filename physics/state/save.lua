--- Makes the state of a world: all that a future step depends on, as tables of plain values.
--
-- In a state, objects are numbers: first those that the library knows, in the order of the world,
-- then those that the game has added since. Lists are dense. A "sparse" list has entries one after
-- the other, for the objects only that have one; each entry begins with the number of its object.
--
--   version       of this layout
--   settings      name -> value; masks = { group, other, collides, ... }; soft = { group, other,
--                 px/s, ... }
--   saved         s, saved up for the next fixed step
--   groups        { name, count, direct, keys } in order: the known objects. Without keys: 1 to
--                 count
--   tables        { name, direct, keys, objects } in order: what the game's tables hold now; only
--                 if that differs
--   count, known  number of objects, number of known objects
--   x, y, width, height, vx, vy   one entry for each object, false: not set
--   fields        name -> sparse: value. The other fields, where they are set
--   read          name -> sparse: value, false if not set. What the library has read, where the
--                 game has written something else since
--   memory        column -> sparse: value (see LINKS, POINTS); or just objects (see FLAGS; `lost`)
--   walls         side -> object: the walls of setBounds
--   touching      sparse: object (0: none) at the left, right, top, bottom
--   contacts      first, second, and a value for each of PAIRS, for each pair that has one
--   events        three objects (0: none) and the values of EVENT each: the events that wait
--   sorted        how many of the events are in order already, nil: none; the others follow them
--   heardBy       if a callback has interrupted the first event: how many objects have heard of it,
--                 1 or 2
--   gone          fields by name of objects that have left the world, but are named in `touching`
--                 or `events`; nil: none. Their numbers follow all others
--
--   own           the game's own fields that the setting `ownFields` names (see own.lua)
--
-- The broad phase and sleep are not saved, since they change no result. Functions and the game's
-- other fields stay on the objects.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carrier = require(root .. ".objects.carriers")
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local events = require(root .. ".contacts.events")
local fields = require(root .. ".world.fields")
local filter = require(root .. ".broadphase.filter")
local interpreted = require(root .. ".memory.jit")
local keyOrder = require(root .. ".memory.keyOrder")
local own = require(root .. ".state.own")
local registry = require(root .. ".objects.registry")
local standing = require(root .. ".state.standing")
local zones = require(root .. ".motion.zones")

local state = {}

local NONE = {}

local STATIC, KINEMATIC, DYNAMIC = columns.STATIC, columns.KINEMATIC, columns.DYNAMIC
local HUGE = math.huge

--- Version of the layout of a state; states of other versions are refused.
state.VERSION = 2

-- Columns that outlive a step. A new column of this kind in columns.lua must be added here, too.

--- By slot: flags, saved where they are true.
state.FLAGS = { "moved", "inside", "jumped", "grown", "stuck", "exiting" }
--- By slot: a slot, 0 for none.
state.LINKS = { "support", "carrier", "crowd" }
--- By slot and axis: name, and the usual value or the column that has it. `last` is only for
--- drawing, in worlds with a `timestep`.
state.POINTS = {
  { "position", "written" },
  { "last", "position" },
  { "carried", 0 },
  { "kept", 0 },
  { "drift", 0 },
  { "behind", 0 },
  { "wasCrushed", false },
  { "crowdAge", 0 },
  { "knotted", 0 },
  { "knotWas", 0 },
  { "jam", 0 },
  { "wasAt", 0 },
  { "wasSize", 0 },
}
--- By pair: name, the value of a pair with nothing to remember, and what another value becomes if
--- the two of the pair are swapped.
state.PAIRS = {
  { "contact", 0, columns.OPPOSITE },
  { "wedged", 0, columns.OPPOSITE },
  { "overlapping", false, { [true] = true } },
  { "dropping", false, { [true] = true } },
}

--- Fields with an entry for every object: name, column, axis, and the column's value if the field
--- is not set.
state.DENSE = {
  { "x", "written", 0 },
  { "y", "written", 1 },
  { "width", "size", 0 },
  { "height", "size", 1 },
  { "vx", "velocity", 0, 0 },
  { "vy", "velocity", 1, 0 },
}
--- The other fields: name, column, the column's value if the field is not set, axis. (`static`,
--- `kinematic`, `friction`, `mask` and `hits` are read by functions of their own.)
state.SPARSE = {
  { "static" },
  { "kinematic" },
  { "active", "active", true },
  { "sensor", "sensor", false },
  { "pushable", "pushable", true },
  { "strength", "strength", 0 },
  { "mass", "mass", 1 },
  { "gravity", "ownGravity", false },
  { "gravityX", "ownGravityX", false },
  { "friction" },
  { "restitution", "restitution", 0 },
  { "airFriction", "airFriction", 0 },
  { "drag", "drag", 0 },
  { "maxSpeed", "maxSpeed", HUGE },
  { "maxSpeedX", "limit", HUGE, 0 },
  { "maxSpeedY", "limit", HUGE, 1 },
  { "maxFallSpeed", "maxFallSpeed", HUGE },
  { "ax", "push", 0, 0 },
  { "ay", "push", 0, 1 },
  { "oneWay", "oneWay", false },
  { "radius", "radius", false },
  { "carry", "carry", true },
  { "surfaceSpeed", "surfaceSpeed", 0 },
  { "nudge", "nudge", 0 },
  { "snap", "snap", 0 },
  { "slope", "slope", false },
  { "constantSpeed", "constantSpeed", false },
  { "mask" },
  { "area" },
  { "hits" },
}

--- The names of all these fields.
state.FIELDS = {}
for _, entry in ipairs(state.DENSE) do
  state.FIELDS[#state.FIELDS + 1] = entry[1]
end
for _, entry in ipairs(state.SPARSE) do
  state.FIELDS[#state.FIELDS + 1] = entry[1]
end

-- Settings that are not in SETTINGS. All but `masks`, `soft` and `order` change no result; these
-- have a format of their own.
local UNSAVED = {
  broadphase = true,
  cellSize = true,
  rest = true,
  checked = true,
  masks = true,
  soft = true,
  order = true,
  ownFields = true,
}

--- Settings in a state, in order, apart from masks, soft and order.
state.SETTINGS = {}
for _, field in ipairs(fields.settings) do
  if not UNSAVED[field.name] and field.type ~= "function" then
    state.SETTINGS[#state.SETTINGS + 1] = field.name
  end
end

-- Lists ------------------------------------------------------------------------------------------

-- Returns the list of that name; makes it if there is none.
local function listIn(owner, name)
  local list = owner[name]
  if type(list) ~= "table" then
    list = {}
    owner[name] = list
  end
  return list
end

-- Cuts off what an earlier state left behind the first n entries.
local function cut(list, n)
  for at = #list, n + 1, -1 do
    list[at] = nil
  end
end

--- Returns a copy of a list.
function state.copyList(list)
  local copy = {}
  for n = 1, #list do
    copy[n] = list[n]
  end
  return copy
end

-- Returns a mask as { group, collides, ... }.
local function listMask(mask)
  local list = {}
  for _, group in ipairs(keyOrder.sorted(mask)) do
    list[#list + 1] = group
    list[#list + 1] = mask[group]
  end
  return list
end

-- An area as { name, value, ... }.
local function listArea(area)
  local list = {}
  for _, name in ipairs(fields.areaNames) do
    if area[name] ~= nil then
      list[#list + 1] = name
      list[#list + 1] = area[name]
    end
  end
  return list
end

-- The masks of a world, or what is soft, as { group, other, value, ... }.
local function listMasks(masks)
  local list = {}
  for _, group in ipairs(keyOrder.sorted(masks)) do
    for _, other in ipairs(keyOrder.sorted(masks[group])) do
      local n = #list
      list[n + 1], list[n + 2], list[n + 3] = group, other, masks[group][other]
    end
  end
  return list
end

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

-- Fields -----------------------------------------------------------------------------------------

-- Checks an object after a write that the library has not read yet: the values must be usable.
local function checkWritten(b, slot)
  local record = b.group[slot]
  check.object(b.object[slot], registry.place(record, b.key[slot]))
end

-- Notes what the library has read in field `name` of object n.
local function noteRead(b, out, work, name, n, slot, value)
  checkWritten(b, slot)
  work.isClean = work.isClean and b.kind[slot] ~= STATIC
  local list = listIn(out.read, name)
  list[#list + 1] = n
  list[#list + 1] = value
end

-- Saves a field with an entry for every object. The velocity of a static object is not read.
local function saveDense(b, out, work, m)
  local entry = state.DENSE[m]
  local name, column, axis, absent = entry[1], b[entry[2]], entry[3], entry[4]
  local list, objects, slots, kind = listIn(out, name), work.objects, work.slots, b.kind
  local fixed, visit, numbers = work.fixed and work.fixed.slots or NONE, work.visit, work.numbers
  local values = work.fixed and work.fixed.dense[m]
  for at = #list + 1, out.count do
    list[at] = false -- so that it is filled from its beginning
  end
  for at = 1, #fixed do
    list[numbers[fixed[at]]] = values[at]
  end
  for at = 1, work.visitKnown do
    local n = visit[at]
    local slot, value = slots[n], objects[n][name]
    local read = column[2 * slot + axis]
    list[n] = value or false
    if value == nil then
      value = absent
    end
    if value ~= read then
      if absent and kind[slot] == STATIC then
        checkWritten(b, slot)
      else
        noteRead(b, out, work, name, n, slot, read)
      end
    end
  end
  for n = out.known + 1, out.count do
    list[n] = objects[n][name] or false
  end
  cut(list, out.count)
end

-- Saves a field that has one column.
local function saveColumn(b, out, work, entry)
  local name, column, absent, axis = entry[1], b[entry[2]], entry[3], entry[4]
  local list, objects, slots, at = listIn(out.fields, name), work.objects, work.slots, 0
  local stride, offset = axis and 2 or 1, axis or 0
  local has, i, visit = work.fixed and work.fixed.has[name] or NONE, 1, work.visit
  for m = 1, work.visitKnown do
    local n = visit[m]
    local slot, value = slots[n], objects[n][name]
    local read = column[stride * slot + offset]
    at, i = standing.put(list, at, has, i, n, work.numbers)
    if value ~= nil then
      list[at + 1], list[at + 2] = n, value
      at = at + 2
      if value == HUGE then
        checkWritten(b, slot) -- in a column that means no limit, from the game it is refused
      end
    else
      value = absent
    end
    if value ~= read then
      noteRead(b, out, work, name, n, slot, read ~= HUGE and read)
    end
  end
  at = standing.put(list, at, has, i, HUGE, work.numbers)
  for n = out.known + 1, out.count do
    local value = objects[n][name]
    if value ~= nil then
      list[at + 1], list[at + 2] = n, value
      at = at + 2
    end
  end
  cut(list, at)
end

-- The next functions return what the library has read in fields without a column of their own.

local function readStatic(b, slot)
  return b.kind[slot] == STATIC
end

local function readKinematic(b, slot, object)
  -- (It is not read of a static object.)
  return b.kind[slot] == STATIC and (object.kinematic or false) or b.kind[slot] == KINEMATIC
end

local function readFriction(b, slot)
  return b.friction[slot] >= 0 and b.friction[slot]
end

---@type table<integer, number|false>
local ABSENT_FRICTION = { [STATIC] = false, [KINEMATIC] = false, [DYNAMIC] = 0 }

local function absentFriction(b, slot)
  return ABSENT_FRICTION[b.kind[slot]]
end

local function never()
  return false
end

-- Saves a field by means of functions.
local function saveSpecial(b, out, work, name, read, absent)
  local list, objects, slots, at = listIn(out.fields, name), work.objects, work.slots, 0
  local has, i, visit = work.fixed and work.fixed.has[name] or NONE, 1, work.visit
  for m = 1, #visit do
    local n = visit[m]
    local object, slot = objects[n], slots[n]
    local value = object[name]
    at, i = standing.put(list, at, has, i, n, work.numbers)
    if value ~= nil then
      list[at + 1], list[at + 2] = n, value
      at = at + 2
    elseif n <= out.known then
      value = absent(b, slot)
    end
    if n <= out.known then
      local was = read(b, slot, object)
      if value ~= was then
        noteRead(b, out, work, name, n, slot, was)
      end
    end
  end
  at = standing.put(list, at, has, i, HUGE, work.numbers)
  cut(list, at)
end

-- Returns the mask as the library has read it, false: none. Of a mover these are only the groups
-- that it refuses.
local function listMaskRead(b, slot)
  if not b.mask[slot] then
    return false
  elseif b.kind[slot] == STATIC then
    return listMask(b.mask[slot])
  end
  local list, groups, seen = {}, b.registry.groups, b.maskSeen[slot]
  for n = 1, #groups do
    if seen[groups[n].number] then
      list[#list + 1] = groups[n].name
      list[#list + 1] = false
    end
  end
  return list
end

-- Returns whether the mask of a mover still says what was read.
local function isSeen(b, slot, mask)
  local groups, seen = b.registry.groups, b.maskSeen[slot]
  for n = 1, #groups do
    local group = groups[n]
    -- Groups that were empty are looked up in the mask itself.
    if group.wasFilled and (mask[group.name] == false) ~= (seen[group.number] or false) then
      return false
    end
  end
  return true
end

local function isMaskRead(b, slot, given)
  local read, mask = b.mask[slot], given or false
  if b.kind[slot] == STATIC then
    return filter.isSameMask(mask, read)
  elseif not mask or mask ~= read then
    return mask == read
  elseif not check.accepts(fields.objectByName.mask, mask) then
    checkWritten(b, slot)
  end
  return isSeen(b, slot, mask)
end

local function listMaskGiven(_, _, mask)
  return listMask(mask)
end

local function isAreaRead(b, slot, area)
  return zones.isSame(area, b.area[slot])
end

local function listAreaRead(b, slot)
  return b.area[slot] and listArea(b.area[slot])
end

local function listAreaGiven(_, _, area)
  return listArea(area)
end

local function isHitsRead(b, slot, hits)
  return hits == (b.hitsGiven[slot] or nil)
end

local function listHitsRead(b, slot)
  return b.hitsRead[slot] and state.copyList(b.hitsRead[slot].names)
end

-- Returns a list of `hits`, as it was read: a change in place counts only when it is read.
local function listHitsGiven(b, slot, hits)
  local isRead = slot and isHitsRead(b, slot, hits)
  return isRead and listHitsRead(b, slot) or state.copyList(hits)
end

-- Saves a field that is a table. `isRead(b, slot, value)`: whether that is what the library has
-- read; `listRead(b, slot)` lists what it has, false: nothing; `listGiven(b, slot, value)` lists a
-- value, without a slot that of an object not known yet.
local function saveTable(b, out, work, name, isRead, listRead, listGiven)
  local list, objects, slots, at = listIn(out.fields, name), work.objects, work.slots, 0
  local has, i, visit = work.fixed and work.fixed.has[name] or NONE, 1, work.visit
  for m = 1, #visit do
    local n = visit[m]
    local value, slot = objects[n][name], n <= out.known and slots[n]
    at, i = standing.put(list, at, has, i, n, work.numbers)
    if slot and not isRead(b, slot, value) then
      noteRead(b, out, work, name, n, slot, listRead(b, slot))
    end
    if value then
      list[at + 1], list[at + 2] = n, listGiven(b, slot, value)
      at = at + 2
    end
  end
  at = standing.put(list, at, has, i, HUGE, work.numbers)
  cut(list, at)
end

local function saveFields(b, out, work)
  listIn(out, "fields")
  for _, list in next, listIn(out, "read"), nil do
    cut(list, 0)
  end
  for n = 1, #state.DENSE do
    saveDense(b, out, work, n)
  end
  for n = 1, #state.SPARSE do
    local entry = state.SPARSE[n]
    if entry[2] then
      saveColumn(b, out, work, entry)
    end
  end
  saveSpecial(b, out, work, "static", readStatic, never)
  saveSpecial(b, out, work, "kinematic", readKinematic, never)
  saveSpecial(b, out, work, "friction", readFriction, absentFriction)
  saveTable(b, out, work, "mask", isMaskRead, listMaskRead, listMaskGiven)
  saveTable(b, out, work, "area", isAreaRead, listAreaRead, listAreaGiven)
  saveTable(b, out, work, "hits", isHitsRead, listHitsRead, listHitsGiven)
end

-- Memory -----------------------------------------------------------------------------------------

-- Returns whether the game has given an object another `canCollide` than the one that was read. The
-- state does not hold functions, but an update would treat the object as moved.
local function asksAnew(b, i)
  return b.kind[i] ~= STATIC and (b.object[i].canCollide or false) ~= b.canCollide[i]
end

local function saveFlags(b, out, work)
  local slots = work.slots
  for m = 1, #state.FLAGS do
    local name = state.FLAGS[m]
    local list, column, at = listIn(out.memory, name), b[name], 0
    for v = 1, work.visitKnown do
      local n = work.visit[v]
      if column[slots[n]] or (name == "moved" and asksAnew(b, slots[n])) then
        at = at + 1
        list[at] = n
      end
    end
    cut(list, at)
  end
end

local function saveLinks(b, out, work)
  local slots, numbers = work.slots, work.numbers
  for m = 1, #state.LINKS do
    local name = state.LINKS[m]
    local list, column, at = listIn(out.memory, name), b[name], 0
    for v = 1, work.visitKnown do
      local n = work.visit[v]
      local other = column[slots[n]]
      if other ~= 0 and b.kind[other] ~= 0 then
        list[at + 1], list[at + 2] = n, numbers[other]
        at = at + 2
      end
    end
    cut(list, at)
  end
end

local function savePoints(b, out, work)
  local slots = work.slots
  for m = 1, #state.POINTS do
    local name, usual = state.POINTS[m][1], state.POINTS[m][2]
    local list, column, model, at = listIn(out.memory, name), b[name], b[usual], 0
    local isWanted = name ~= "last" or b.world.timestep
    for v = 1, isWanted and work.visitKnown or 0 do
      local n = work.visit[v]
      local k = 2 * slots[n]
      local x, y = usual, usual
      if model then
        x, y = model[k], model[k + 1]
      end
      if column[k] ~= x or column[k + 1] ~= y then
        list[at + 1], list[at + 2], list[at + 3] = n, column[k], column[k + 1]
        at = at + 3
      end
    end
    cut(list, at)
  end
end

-- Saves the riders that have lost their carrier since the last step.
local function saveLost(b, out, work)
  local list = listIn(out.memory, "lost")
  local count = 0
  for n = 1, b.lostCount do
    local i = b.lost[n]
    if b.kind[i] == DYNAMIC then
      count = count + 1
      list[count] = work.numbers[i]
    end
  end
  cut(list, count)
  table.sort(list)
end

-- Saves the walls of `setBounds`.
local function saveWalls(world, out, work)
  local walls = listIn(out, "walls")
  for side in next, walls, nil do
    walls[side] = nil
  end
  if next(world._walls) ~= nil then
    for n = 1, out.count do
      for side, wall in next, world._walls, nil do
        if work.objects[n] == wall then
          walls[side] = n
        end
      end
    end
  end
end

-- Returns the number of an object that the library remembers, 0 for none. An object that has left
-- the world gets a number behind all others.
local function numberOf(b, out, work, object)
  if not object then
    return 0
  end
  local slot, objects = b.slotOf[object], work.objects
  local number = slot and work.numbers[slot]
  if number and rawequal(objects[number], object) then
    return number
  end
  local last = out.count + work.goneCount
  for n = out.known + 1, last do
    if rawequal(objects[n], object) then
      return n
    end
  end
  work.goneCount = work.goneCount + 1
  objects[last + 1] = object
  return last + 1
end

local function saveTouching(b, out, work)
  local list, slots, at = listIn(out, "touching"), work.slots, 0
  for n = 1, out.known do
    local t = b.touching[slots[n]]
    if t and (t.left or t.right or t.top or t.bottom) then
      list[at + 1] = n
      list[at + 2] = numberOf(b, out, work, t.left)
      list[at + 3] = numberOf(b, out, work, t.right)
      list[at + 4] = numberOf(b, out, work, t.top)
      list[at + 5] = numberOf(b, out, work, t.bottom)
      at = at + 5
    end
  end
  cut(list, at)
end

-- Contacts ---------------------------------------------------------------------------------------

local function remembers(b, p)
  for c = 1, #state.PAIRS do
    local entry = state.PAIRS[c]
    if b[entry[1]][p] ~= entry[2] then
      return true
    end
  end
  return false
end

-- Lists in work.pairs the pairs of object n (in `slot`) with later objects, if there is something
-- to remember, by the number of the other. Returns how many.
local function gatherPairs(b, work, n, slot)
  local other, nextHalf, numbers, found = b.other, b.next, work.numbers, work.pairs
  local count, half = 0, b.head[slot]
  while half ~= 0 do
    if remembers(b, (half + half % 2) / 2) then
      local number = numbers[other[half]]
      if number > n then
        count = count + 1
        local at = count
        while at > 1 and numbers[other[found[at - 1]]] > number do
          found[at] = found[at - 1]
          at = at - 1
        end
        found[at] = half
      end
    end
    half = nextHalf[half]
  end
  return count
end

local function saveContacts(b, out, work)
  work.pairs = work.pairs or {}
  local list, slots, numbers, at = listIn(out, "contacts"), work.slots, work.numbers, 0
  local PAIRS, found = state.PAIRS, work.pairs
  for n = 1, out.known do
    for m = 1, gatherPairs(b, work, n, slots[n]) do
      local half = found[m]
      local p = (half + half % 2) / 2
      list[at + 1], list[at + 2] = n, numbers[b.other[half]]
      at = at + 2
      for c = 1, #PAIRS do
        local entry = PAIRS[c]
        local value = b[entry[1]][p]
        if half % 2 == 0 and value ~= entry[2] then
          value = entry[3][value]
        end
        at = at + 1
        list[at] = value
      end
    end
  end
  cut(list, at)
end

-- The world --------------------------------------------------------------------------------------

-- What an event holds besides its objects (`a`, `b`, `c`).
state.EVENT = { "kind", "side", "speed", "leant", "rankA", "rankB", "x1", "y1", "x2", "y2" }

-- Saves the waiting events. Events wait only after a callback has failed, or inside one. Some
-- objects may have heard of the first event already: `heardBy`.
local function saveEvents(b, out, work)
  local list, e, at = listIn(out, "events"), b.events, 0
  local isHalfTold = e.told > 0 and e.heardBy < 3
  local first = isHalfTold and e.told or e.told + 1
  out.heardBy = isHalfTold and e.heardBy or nil
  out.sorted = first <= e.sorted and e.sorted - first + 1 or nil
  -- Events that a callback noted before it failed are told in order, too.
  events.sortLate(e)
  for told = first, e.count do
    local n = told <= e.sorted and e.order[told] or e.late[told - e.sorted]
    list[at + 1] = numberOf(b, out, work, e.a[n])
    list[at + 2] = numberOf(b, out, work, e.b[n])
    list[at + 3] = numberOf(b, out, work, e.c[n])
    at = at + 3
    for m = 1, #state.EVENT do
      list[at + m] = e[state.EVENT[m]][n]
    end
    at = at + #state.EVENT
  end
  cut(list, at)
end

-- Returns the library's fields of an object that has left the world, as far as they are valid.
local function fieldsOf(object)
  local saved = {}
  for _, name in ipairs(state.FIELDS) do
    local value = object[name]
    if value ~= nil and check.accepts(fields.objectByName[name], value) then
      saved[name] = name == "mask" and listMask(value)
        or name == "area" and listArea(value)
        or name == "hits" and state.copyList(value)
        or value
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
  for _, name in ipairs(state.SETTINGS) do
    check.setting(name, world[name])
    settings[name] = world[name]
  end
  check.setting("masks", world.masks)
  check.setting("order", world.order)
  check.setting("soft", world.soft)
  settings.masks = world.masks and listMasks(world.masks) or nil
  settings.soft = world.soft and listMasks(world.soft) or nil
  settings.order = world.order and state.copyList(world.order)
end

-- How the game would write object n.
local function placeOf(b, out, work, n)
  local slot = n <= out.known and work.slots[n]
  return slot and registry.place(b.group[slot], b.key[slot]) or "an object that was added"
end

--- Fills `out` with the state of a world. Returns `work` with the objects by number, and behind
--- them the `goneCount` objects that have left. Errors: something that `update` would refuse.
function state.fill(world, out)
  local b = world._bodies
  local work = workOf(b)
  -- A restored world could not tell what the game has moved since the last step; so this is done
  -- now.
  carrier.checkMoved(b)
  out.version = state.VERSION
  saveSettings(world, out)
  out.saved = world._saved
  work.goneCount = 0
  saveGroups(b, out, work)
  saveTables(b, world.objects, out, work)
  standing.listVisits(b, out, work)
  saveFields(b, out, work)
  listIn(out, "memory")
  saveFlags(b, out, work)
  saveLinks(b, out, work)
  savePoints(b, out, work)
  saveLost(b, out, work)
  saveWalls(world, out, work)
  saveTouching(b, out, work)
  saveContacts(b, out, work)
  saveEvents(b, out, work)
  saveGone(out, work)
  own.save(world, out, work, placeOf)
  cut(work.objects, out.count + work.goneCount)
  if not work.fixed then
    b.fixed = false
    if work.isClean and not standing.hasMoved(b) then
      standing.note(b, out, work, state.DENSE, state.SPARSE)
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

interpreted.always(saveFields, saveWalls, noteMasks)

return state
