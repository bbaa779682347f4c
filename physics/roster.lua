--- Who is in the world, and in which order.
--
-- The game keeps its objects in plain tables and tells nobody when it adds or removes one. The
-- roster remembers what it saw and compares: as long as nothing changed, that is one comparison an
-- object. Only groups that changed are read again.
--
-- Nothing here follows `pairs` order. Groups: those listed in `order`, then by name, numbers before
-- strings; in a group by key, numbers before strings.

local here = (...):match("^(.*)%.[^.]+$")
local check = require(here .. ".check")

local roster = {}

local sort = table.sort
local GROUP_SPAN = 4294967296 -- ranks per group
local FEW = 64 -- objects of a group that are counted each time

local function comesBefore(a, b)
  local numberA, numberB = type(a) == "number", type(b) == "number"
  if numberA ~= numberB then
    return numberA
  end
  return a < b
end

--- Returns an empty roster. `groups` are the records in order: a record is
--- `{ name, source, direct, index, list, keys, count, plain, stale }`, where `source` is the game's
--- table (the object itself if `direct`), `plain` says that the keys are just 1 to `count`, and
--- `mixed` that they once were others.
function roster.new()
  return {
    source = false,
    entering = false, -- who is being read for the first time
    order = {},
    groups = {},
    groupCount = 0,
    byName = {},
    -- Objects that came through `add` and have not been read yet: their `touching`, their group.
    given = setmetatable({}, { __mode = "k" }),
    groupGiven = setmetatable({}, { __mode = "k" }),
  }
end

-- An object is told from a group by its first field; also one whose width is missing or wrong, so
-- that the message is about the width.
local function isObject(value)
  if type(value.width) == "number" then
    return true
  end
  for _, field in ipairs({ "x", "y", "width", "height" }) do
    local found = value[field]
    if found ~= nil and type(found) ~= "table" then
      return true
    end
  end
  return false
end

local function checkKey(key, path)
  if type(key) ~= "number" and type(key) ~= "string" then
    check.fail(path .. " has a key that is neither a number nor a string, got " .. check.show(key))
  elseif type(key) == "number" and not check.isFinite(key) then
    check.fail(path .. " has a key that is no finite number, got " .. check.show(key))
  end
end

local function countKeys(source)
  local n = 0
  for _ in next, source, nil do
    n = n + 1
  end
  return n
end

-- True if the group still holds what was read last. Numbered objects cost one comparison each; a
-- raw one, since the objects of a game may be "equal" by a metamethod.
local function isUnchanged(record)
  if record.direct then
    return true
  end
  local source, list, count = record.source, record.list, record.count
  if not record.plain then
    local keys = record.keys
    for n = 1, count do
      if not rawequal(source[keys[n]], list[n]) then
        return false
      end
    end
    return countKeys(source) == count
  end
  for n = 1, count do
    if not rawequal(source[n], list[n]) then
      return false
    end
  end
  if count <= FEW or record.mixed then
    return countKeys(source) == count
  end
  -- Keys beyond the last number follow it in the table, unless that has room left from others.
  return next(source, count) == nil or countKeys(source) == count
end

local function haveGroupsChanged(self, objects)
  local n, byName = 0, self.byName
  for name, value in next, objects, nil do
    local record = byName[name]
    if not record or record.source ~= value then
      return true
    end
    n = n + 1
  end
  return n ~= self.groupCount
end

local function sortedNames(self, objects)
  local listed, names = {}, {}
  for _, name in ipairs(self.order) do
    if objects[name] ~= nil and not listed[name] then
      listed[name] = true
      names[#names + 1] = name
    end
  end
  local rest = {}
  for name in next, objects, nil do
    checkKey(name, "objects")
    if not listed[name] then
      rest[#rest + 1] = name
    end
  end
  sort(rest, comesBefore)
  for _, name in ipairs(rest) do
    names[#names + 1] = name
  end
  return names
end

local function newRecord(name, source)
  local direct = isObject(source)
  return {
    name = name,
    source = source,
    direct = direct,
    index = 0,
    list = {},
    keys = {},
    count = 0,
    plain = true,
    movers = false, -- see collect
    mixed = false,
    stale = true,
  }
end

--- Returns how the game would write the place of an object.
function roster.place(record, key)
  if record.direct then
    return check.place(record.name)
  end
  return check.place(record.name, key)
end

local function checkGroup(name, source)
  if type(source) ~= "table" then
    check.fail(
      check.place(name)
        .. " must be a group (a table of objects) or an object, got "
        .. check.show(source)
    )
  end
  return source
end

-- Returns the records of all groups in order, old ones where the table is the same.
local function readGroups(self, objects)
  local groups, byName = {}, {}
  for index, name in ipairs(sortedNames(self, objects)) do
    local source = checkGroup(name, objects[name])
    local record = self.byName[name]
    if not record or record.source ~= source then
      record = newRecord(name, source)
    end
    groups[index], byName[name] = record, record
  end
  return groups, byName
end

-- Returns the keys of a group in order, and whether they are just 1 to their number.
local function readKeys(record)
  local source, keys, n = record.source, {}, 0
  while rawget(source, n + 1) ~= nil do
    n = n + 1
    keys[n] = n
  end
  if countKeys(source) == n then
    return keys, true
  end
  keys = {}
  for key in next, source, nil do
    checkKey(key, check.place(record.name))
    keys[#keys + 1] = key
  end
  sort(keys, comesBefore)
  return keys, false
end

-- Reads the members of a record into `record.newList`, `record.newKeys`; changes nothing else.
local function readMembers(record)
  if record.count == 0 then
    record.direct = isObject(record.source) -- it may have been filled since it was first seen
  end
  if record.direct then
    record.newList, record.newKeys, record.newPlain = { record.source }, { 1 }, true
    return
  end
  local keys, plain = readKeys(record)
  local list = {}
  for n = 1, #keys do
    local object = rawget(record.source, keys[n])
    if type(object) ~= "table" then
      check.fail(
        check.place(record.name, keys[n])
          .. " must be an object (a table), got "
          .. check.show(object)
      )
    end
    list[n] = object
  end
  record.newList, record.newKeys, record.newPlain = list, keys, plain
  record.mixed = record.mixed or not plain
end

local function failTwice(object, first, second)
  check.fail(
    second
      .. " is the same object as "
      .. first
      .. ": an object stands in one place, "
      .. check.show(object)
      .. " was found in two"
  )
end

-- Checks that no object of the stale records stands in two places, and all new ones.
local function checkMembers(b, groups)
  local found = {}
  for _, record in ipairs(groups) do
    if record.stale then
      for n, object in ipairs(record.newList) do
        local here_ = roster.place(record, record.newKeys[n])
        local slot = b.slotOf[object]
        local owner = slot and b.group[slot]
        if found[object] then
          failTwice(object, found[object], here_)
        elseif owner and not owner.stale then
          failTwice(object, roster.place(owner, b.key[slot]), here_)
        end
        found[object] = here_
        if not slot then
          check.object(object, here_)
        end
      end
    end
  end
  return found
end

local function applyMembers(b, self, record, enter, rename)
  local list, keys = record.newList, record.newKeys
  record.list, record.keys, record.count, record.plain = list, keys, #list, record.newPlain
  record.newList, record.newKeys = nil, nil
  record.movers = false
  for n = 1, record.count do
    local object = list[n]
    local slot = b.slotOf[object]
    if not slot then
      self.entering = object
      slot = enter(b, object, record, keys[n])
      self.entering = false
    elseif b.group[slot] ~= record then
      rename(b, slot, record)
    end
    b.key[slot] = keys[n]
    b.rank[slot] = record.index * GROUP_SPAN + n
  end
  record.stale = false -- not before: an object may fail when it is read
end

-- Somebody has failed while it was read: only half of it is there.
local function leaveHalf(b, self, leave)
  local slot = self.entering and b.slotOf[self.entering]
  self.entering = false
  if slot then
    leave(b, slot)
  end
end

local function leaveMissing(b, record, found, leave)
  for n = 1, record.count do
    local slot = b.slotOf[record.list[n]]
    if slot and b.group[slot] == record and not found[record.list[n]] then
      leave(b, slot)
    end
  end
end

-- Puts the records in order and ranks anew those that moved.
local function applyGroups(b, self, objects, groups, byName)
  for index, record in ipairs(groups) do
    if record.index ~= index then
      record.index = index
      for n = 1, record.count do
        local slot = b.slotOf[record.list[n]]
        if slot then
          b.rank[slot] = index * GROUP_SPAN + n
        end
      end
    end
  end
  self.source, self.groups, self.byName, self.groupCount = objects, groups, byName, #groups
end

local function markStale(groups)
  local any = false
  for n = 1, #groups do
    local record = groups[n]
    record.stale = record.stale or not isUnchanged(record)
    any = any or record.stale
  end
  return any
end

--- Compares the game's tables with what was seen last and reports what changed, nothing if the
--- tables cannot be used: `enter(b, object, record, key)` for a new object (returns its slot),
--- `leave(b, slot)` for one that is gone, `rename(b, slot, record)` for one that moved to another
--- group. Returns whether anything changed.
function roster.update(b, self, objects, enter, leave, rename)
  leaveHalf(b, self, leave)
  local groups, byName = self.groups, self.byName
  local regroup = self.source ~= objects or self.reorder or haveGroupsChanged(self, objects)
  if regroup then
    if type(objects) ~= "table" then
      check.fail("objects must be a table of groups, got " .. check.show(objects))
    end
    groups, byName = readGroups(self, objects)
  end
  if not markStale(groups) and not regroup then
    return false
  end
  local gone = {}
  for _, record in ipairs(self.groups) do
    if byName[record.name] ~= record then
      record.stale = true
      gone[#gone + 1] = record
    end
  end
  for _, record in ipairs(groups) do
    if record.stale then
      readMembers(record)
    end
  end
  local found = checkMembers(b, groups)
  for _, record in ipairs(gone) do
    leaveMissing(b, record, found, leave)
  end
  for _, record in ipairs(groups) do
    if record.stale then
      leaveMissing(b, record, found, leave)
    end
  end
  applyGroups(b, self, objects, groups, byName)
  for _, record in ipairs(groups) do
    if record.stale then
      applyMembers(b, self, record, enter, rename)
    end
  end
  self.reorder = false
  for object in pairs(self.groupGiven) do
    self.given[object], self.groupGiven[object] = nil, nil
  end
  return true
end

--- Returns whether the game's tables differ from what was seen last. Changes nothing.
function roster.hasChanged(self, objects)
  if type(objects) ~= "table" or self.source ~= objects or haveGroupsChanged(self, objects) then
    return true
  end
  for n = 1, self.groupCount do
    local record = self.groups[n]
    if record.stale or not isUnchanged(record) then
      return true
    end
  end
  return false
end

--- Returns the game's tables as the next `update` would read them: records in order, the members in
--- `newList` and `newKeys`. Changes nothing.
--- Errors: as `update`.
function roster.look(b, self, objects)
  if type(objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(objects))
  end
  local records, found = {}, {}
  for index, name in ipairs(sortedNames(self, objects)) do
    local record = newRecord(name, checkGroup(name, objects[name]))
    records[index] = record
    readMembers(record)
    for n, object in ipairs(record.newList) do
      local here_ = roster.place(record, record.newKeys[n])
      if found[object] then
        failTwice(object, found[object], here_)
      elseif not b.slotOf[object] then
        check.object(object, here_)
      end
      found[object] = here_
    end
  end
  return records
end

--- Returns the key under which an object stands in its group's table now, or nil.
function roster.find(source, object, hint)
  if hint ~= nil and rawequal(source[hint], object) then
    return hint
  end
  for key, value in next, source, nil do
    if rawequal(value, object) then
      return key
    end
  end
end

return roster
