--- Saves the fields of objects (see format.lua): what the game's tables hold, and what the library
--- has read where that is something else.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local fieldColumns = require(root .. ".objects.fieldColumns")
local fields = require(root .. ".world.fields")
local filter = require(root .. ".broadphase.filter")
local format = require(root .. ".state.format")
local interpreted = require(root .. ".memory.jit")
local registry = require(root .. ".objects.registry")
local standing = require(root .. ".state.standing")
local zones = require(root .. ".motion.zones")

local NONE = {}

local STATIC, KINEMATIC, DYNAMIC = columns.STATIC, columns.KINEMATIC, columns.DYNAMIC
local HUGE = math.huge
local listIn, cut, LISTED = format.listIn, format.cut, format.LISTED

-- Checks an object after a write that the library has not read yet: the values must be usable.
local function checkWritten(b, slot)
  check.object(b.object[slot], registry.placeOf(b, slot))
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
  local entry = fieldColumns.EVERY[m]
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
  local convert = entry[5]
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
      elseif convert then
        value = convert(value)
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
    return LISTED.mask(b.mask[slot])
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
  return LISTED.mask(mask)
end

local function isAreaRead(b, slot, area)
  return zones.isSame(area, b.area[slot])
end

local function listAreaRead(b, slot)
  return b.area[slot] and LISTED.area(b.area[slot])
end

local function listAreaGiven(_, _, area)
  return LISTED.area(area)
end

local function isHitsRead(b, slot, hits)
  return hits == (b.hitsGiven[slot] or nil)
end

local function listHitsRead(b, slot)
  return b.only[slot] and format.copyList(b.only[slot].names)
end

-- Returns a list of `hits`, as it was read: a change in place counts only when it is read.
local function listHitsGiven(b, slot, hits)
  local isRead = slot and isHitsRead(b, slot, hits)
  return isRead and listHitsRead(b, slot) or format.copyList(hits)
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

--- Saves all fields. Objects that are not known yet come last.
local function saveFields(b, out, work)
  listIn(out, "fields")
  for _, list in next, listIn(out, "read"), nil do
    cut(list, 0)
  end
  for n = 1, #fieldColumns.EVERY do
    saveDense(b, out, work, n)
  end
  for n = 1, #fieldColumns.SOME do
    local entry = fieldColumns.SOME[n]
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

interpreted.always(saveFields)

return saveFields
