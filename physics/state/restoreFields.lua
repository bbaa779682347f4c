--- Writes the fields of a state into objects.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local fieldColumns = require(root .. ".objects.fieldColumns")
local fields = require(root .. ".world.fields")
local filter = require(root .. ".broadphase.filter")
local format = require(root .. ".state.format")
local interpreted = require(root .. ".memory.jit")
local read = require(root .. ".objects.read")
local zones = require(root .. ".motion.zones")

local restoreFields = {}

local max = math.max

local function write(object, name, value)
  if object[name] ~= value then
    object[name] = value
  end
end

--- Returns whether two lists hold the same.
function restoreFields.isSameList(list, other)
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

--- Gives a table the contents of another one.
function restoreFields.overwrite(list, contents)
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
    restoreFields.overwrite(known, wanted)
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
  if not (type(now) == "table" and restoreFields.isSameList(list, now)) then
    write(object, "hits", format.copyList(list))
  end
end

-- By name: how the fields that are tables are written.
local WRITE = { mask = writeMask, area = writeArea, hits = writeHits }

-- Writes what a state holds of a field, nil: nothing. `known` is the table that was its mask,
-- if that is known.
local function writeField(object, name, value, known)
  if value ~= nil and WRITE[name] then
    WRITE[name](object, value, known)
  else
    write(object, name, value)
  end
end

-- Writes a sparse list of values. Objects that are not in it have no value.
local function writeSparse(objects, masks, name, list, visit)
  local at = 1
  for m = 1, #visit do
    local n = visit[m]
    while list[at] and list[at] < n do
      at = at + 2
    end
    local value = nil
    if list[at] == n then
      value, at = list[at + 1], at + 2
    end
    writeField(objects[n], name, value, masks[n])
  end
end

local function writeDense(objects, name, list, visit)
  for m = 1, #visit do
    local n = visit[m]
    write(objects[n], name, list[n] or nil)
  end
end

--- Writes the fields of the objects to visit as they were when the state was saved; with `only`,
--- just those.
function restoreFields.write(st, objects, masks, visit, only)
  for _, entry in ipairs(fieldColumns.EVERY) do
    local name = entry[1]
    if not only or only[name] then
      writeDense(objects, name, st[name], visit)
    end
  end
  for _, entry in ipairs(fieldColumns.SOME) do
    local name = entry[1]
    if not only or only[name] then
      writeSparse(objects, masks, name, st.fields[name], visit)
    end
  end
end

--- Writes what the library had read, where that was something else. Returns the names of these
--- fields.
function restoreFields.writeRead(st, objects)
  local names, any = {}, false
  for name, list in next, st.read, nil do
    local isBoolean = fields.objectByName[name] and fields.objectByName[name].type == "boolean"
    for at = 1, #list, 2 do
      local value = list[at + 1]
      if (name == "mask" or name == "area") and value then
        value = tableOf(value)
      elseif name == "hits" and value then
        value = format.copyList(value)
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
  for _, name in ipairs(fieldColumns.NAMES) do
    writeField(object, name, saved[name])
  end
  if not (saved.static or saved.kinematic or type(object.touching) == "table") then
    object.touching = read.touchingFor(b, object)
  end
end

--- Returns all objects that a state names by number: those of the world, then those that had left
--- it, as new tables if `gone` does not have them.
function restoreFields.recall(b, st, objects, gone)
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

interpreted.always(restoreFields.overwrite, restoreFields.writeRead)

return restoreFields
