--- Compares the game's groups with what was seen of them last: which objects have come to a place,
--- and which have gone from one.
--
-- As long as nothing has changed, that is one comparison an object. A group that has changed is
-- compared on from the first difference. Nothing follows the order of `pairs`: groups come in the
-- order of `order`, then by name; objects by key; numbers before strings.
--
-- Reads the game's groups. Writes the records of groups; their lists are taken over by
-- registry.lua.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".fields.check")
local keyOrder = require(root .. ".memory.keyOrder")

local groups = {}

local max = math.max
local FEW = 64 -- groups up to this size are counted each time

-- Returns a record of a group of which nothing is known yet.
local function newRecord(name, source)
  return {
    name = name,
    source = source, -- the game's table
    direct = false, -- that is an object itself
    index = 0, -- place among the groups
    list = {}, -- the objects that were in it,
    slots = {}, -- their slots, 0: not entered yet,
    keys = false, -- and their keys; false: 1 to `count`
    count = 0,
    stale = true, -- it has changed from place `first` on
    first = 1,
    newKeys = false, -- what a stale one holds now
    newCount = 0,
    come = {}, -- its places, in order, that hold another object than before,
    comeCount = 0,
    gone = {}, -- and its old places from which an object has gone
    goneCount = 0,
    movers = {}, -- slots of those that are not static (see read.lua),
    isListed = true, -- if none has come, gone or moved since they were listed
    mixed = false, -- its keys were not 1, 2, 3 … in the order of `next`
  }
end

-- The game's tables -------------------------------------------------------------------------------

-- Returns whether a value is an object, and not a group, from its first field. One with a missing
-- or wrong width counts as one, so that the error is about the width.
local function isObject(value)
  for _, field in ipairs({ "width", "x", "y", "height" }) do
    local found = value[field]
    if found ~= nil and type(found) ~= "table" then
      return true
    end
  end
  return false
end

-- Returns the keys of a table in order, without those in `listed`.
local function sortedKeys(source, path, listed)
  local keys = {}
  for key in next, source, nil do
    if type(key) ~= "number" and type(key) ~= "string" then
      check.fail(
        path .. " has a key that is neither a number nor a string, got " .. check.show(key)
      )
    elseif not check.isName(key) then
      check.fail(path .. " has a key that is not a finite number, got " .. check.show(key))
    elseif not (listed and listed[key]) then
      keys[#keys + 1] = key
    end
  end
  table.sort(keys, keyOrder.comesBefore)
  return keys
end

-- Returns the names of all groups in order.
local function sortedNames(self, objects)
  local listed, names = {}, {}
  for _, name in ipairs(self.order) do
    if objects[name] ~= nil and not listed[name] then
      listed[name] = true
      names[#names + 1] = name
    end
  end
  for _, name in ipairs(sortedKeys(objects, "objects", listed)) do
    names[#names + 1] = name
  end
  return names
end

-- Returns whether a group has other keys than 1 to `count`, which it has. `isGrown`: it may hold
-- new numbers in any order.
local function hasOthers(record, count, isGrown)
  local source, n = record.source, 0
  if count > FEW and not (record.mixed or isGrown) and rawget(source, count + 1) == nil then
    if next(source, count) == nil then -- keys beyond the last number would follow it
      return false
    end
  end
  for key in next, source, nil do
    n = n + 1
    record.mixed = record.mixed or key ~= n
  end
  return n ~= count
end

--- Returns the place from which on a group differs from what was read last; nil: it does not. (The
--- comparison is raw, since a game's objects may be "equal" by a metamethod.)
function groups.firstChange(record)
  if record.direct then
    return nil
  end
  local source, list, keys, count = record.source, record.list, record.keys, record.count
  for n = 1, count do
    if not rawequal(rawget(source, keys and keys[n] or n), list[n]) then
      return n
    end
  end
  return hasOthers(record, count, false) and count + 1 or nil
end

--- Returns the n-th member of a stale group, and its key.
function groups.memberAt(record, n)
  local key = record.newKeys and record.newKeys[n] or n
  return record.direct and record.source or rawget(record.source, key), key
end

-- What has changed --------------------------------------------------------------------------------

local function come(record, n)
  record.comeCount = record.comeCount + 1
  record.come[record.comeCount] = n
end

--- Notes that what stood at these places has gone.
function groups.go(record, first, last)
  for n = first, last do
    record.goneCount = record.goneCount + 1
    record.gone[record.goneCount] = n
  end
end

-- Returns the place at which an object stood in a group under numbers; 0: at none.
local function oldPlace(b, record, object)
  local slot = b.slotOf[object]
  return slot and b.group[slot] == record and not record.keys and b.key[slot] or 0
end

-- Compares the numbers of a group from n on with the old ones from `old` on. Where the two differ,
-- it goes on with the place that the object had: what stood before that has gone. Returns the last
-- one.
local function compareOn(b, record, n, old)
  local source, list, count = record.source, record.list, record.count
  local object
  repeat
    while old <= count and rawequal(rawget(source, n), list[old]) do
      n, old = n + 1, old + 1
    end
    object = rawget(source, n)
    if object ~= nil then
      local isReplaced = old < count and rawequal(rawget(source, n + 1), list[old + 1])
      local at = isReplaced and old + 1 or max(old, oldPlace(b, record, object))
      groups.go(record, old, at - 1)
      old = at
      if old > count or not rawequal(object, list[old]) then
        come(record, n)
        n = n + 1
      end
    end
  until object == nil
  groups.go(record, old, count)
  return n - 1
end

-- Finds what a changed group holds now, and what has come and gone from place `first` on.
local function compareGroup(b, record, first)
  local count, old = record.count, first
  record.comeCount, record.goneCount, record.newKeys = 0, 0, false
  if count == 0 then
    record.direct = isObject(record.source) -- it may have been filled since it was first seen
  end
  if record.keys or record.direct then
    first, old = 1, count + 1
    groups.go(record, 1, count)
  end
  record.newCount = record.direct and 1 or compareOn(b, record, first, old)
  if record.direct then
    come(record, 1)
  elseif hasOthers(record, record.newCount, record.newCount > count) then
    record.newKeys = sortedKeys(record.source, check.place(record.name))
    record.newCount, record.comeCount, record.goneCount, first = #record.newKeys, 0, 0, 1
    groups.go(record, 1, count)
    for n = 1, record.newCount do
      come(record, n)
    end
  end
  record.first = first
end

--- Returns whether there are other groups than those that were seen last.
function groups.haveChanged(self, objects)
  local n = 0
  for name, value in next, objects, nil do
    local record = self.byName[name]
    if not record or not rawequal(record.source, value) then
      return true
    end
    n = n + 1
  end
  return n ~= self.groupCount
end

--- Refuses a table of groups that is none.
function groups.checkAll(objects)
  if type(objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(objects))
  end
end

local function checkGroup(name, source)
  if type(source) ~= "table" then
    local text = " must be a group (a table of objects) or an object, got "
    check.fail(check.place(name) .. text .. check.show(source))
  end
end

--- Returns the records of all groups in order, and by name; old ones where the table is the same.
function groups.read(self, objects)
  local records, byName = {}, {}
  for index, name in ipairs(sortedNames(self, objects)) do
    local source, record = objects[name], self.byName[name]
    checkGroup(name, source)
    if not record or not rawequal(record.source, source) then
      record = newRecord(name, source)
    end
    records[index], byName[name] = record, record
  end
  return records, byName
end

--- Compares the groups with what was read last. Returns whether anything has changed. (A group with
--- another place gets other ranks, so all of it is read.)
function groups.compareAll(b, records)
  local isAny = false
  for index, record in ipairs(records) do
    local change = record.index ~= index and 1 or groups.firstChange(record)
    record.stale = change ~= nil
    if change then
      compareGroup(b, record, change)
      isAny = true
    end
  end
  return isAny
end

return groups
