---@diagnostic disable
--- Compares the game's groups with their last records: in which places they differ, and which keys
--- they have.
--
-- As long as nothing has changed, that is one comparison an object. Nothing follows the order of
-- `pairs`: groups come in the order of `order`, then by name; objects by key; numbers before
-- strings.
--
-- Reads the game's groups. Writes the records of groups; their lists are taken over by
-- registry.lua.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".fields.check")
local keyOrder = require(root .. ".memory.keyOrder")

local groups = {}

local max, min, sort = math.max, math.min, table.sort
-- For `haveChanged`: the question, and its answer.
---@type number[], any, any, any
local TWO, asked, given, answer = { 1, 2 }, false, false, false

-- Groups up to this size are counted each time. Up to so many neighbours that go leave a gap.
local FEW = 64

-- Returns a record of a group of which nothing is known yet. Each update adds `newKeys` and
-- `newCount`, its present keys and objects, `gapCount`, `changedCount` and `foundCount` (see
-- `compareAll`), and `rankBehind`, the lowest rank in the groups that follow (see registry).
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
    gaps = {}, -- the places whose object has gone, so that those behind it have moved up, in order,
    changed = {}, -- the other places that hold another object now, when these gaps are closed,
    found = {}, -- and the slots of those objects
    moves = false, -- some object of it has been one that is not static
    isPlain = true, -- none of its objects has a metatable
    mixed = false, -- its keys were not 1, 2, 3 … in the order of `next`
  }
end

-- The game's tables -------------------------------------------------------------------------------

-- Returns the keys of a table in order.
local function sortedKeys(source, path)
  local keys = keyOrder.sorted(source)
  for _, key in ipairs(keys) do
    if not check.isName(key) then
      check.fail("%s has a key that is no finite number or string, got %s", path, check.show(key))
    end
  end
  return keys
end

-- Returns the names of all groups in order.
local function sortedNames(self, objects)
  local listed, names = {}, {}
  for _, list in ipairs({ self.order, sortedKeys(objects, "objects") }) do
    for _, name in ipairs(list) do
      if objects[name] ~= nil and not listed[name] then
        names[#names + 1], listed[name] = name, true
      end
    end
  end
  return names
end

-- Returns whether a group has other keys than 1 to `count`, which it has. A large group is not
-- counted as long as `next` gave its numbers in their order: the keys behind the last known
-- number are enough then, since keys of the hash part come behind those of the array.
local function hasOthers(record, count)
  local source, n, known = record.source, 0, min(count, record.count)
  if known > FEW and not record.mixed and rawget(source, count + 1) == nil then
    local last, key -- keys beyond the last known number follow it
    repeat
      last, key = key or known, next(source, key or known)
    until key ~= last + 1
    if key == nil and last == count then
      return false
    end
  end
  for key in next, source, nil do
    n = n + 1
    record.mixed = record.mixed or key ~= n
  end
  return n ~= count
end

--- Returns the first place in which a group differs from its record, nil: in none. The comparison
--- is raw, since a game's objects may be "equal" by a metamethod. (A plain group is indexed, which
--- costs half of `rawget`.) `isShort`: in a group that has numbers only, other keys are not looked
--- for, since that counts all its objects.
function groups.firstChange(record, isShort)
  if record.direct then
    return nil
  end
  local source, list, keys, count = record.source, record.list, record.keys, record.count
  local isPlain = record.isPlain and not keys
  -- (Without a compiler `rawequal` costs a level of 20 000 tiles a quarter more. An object that got
  -- an `__eq` only later, and is replaced by an equal one, is not seen to be another one.)
  for n = 1, isPlain and count or 0 do
    if source[n] ~= list[n] then
      return n
    end
  end
  for n = 1, isPlain and 0 or count do
    if not rawequal(source[keys and keys[n] or n], list[n]) then
      return n
    end
  end
  if isShort and not keys then
    return rawget(source, count + 1) ~= nil and count + 1 or nil
  end
  return hasOthers(record, count) and count + 1 or nil
end

--- Returns the n-th member that a group has now, and its key.
function groups.memberAt(record, n)
  local key = record.newKeys and record.newKeys[n] or n
  return record.direct and record.source or rawget(record.source, key), key
end

-- Changes -----------------------------------------------------------------------------------------

-- Returns the place in the list of the object at place n of a group, which was expected at `at`,
-- and lists the gaps before it. If that is not near, or another object follows there, returns `at`.
local function passGaps(b, record, n, at, object)
  local slot, gaps = b.slotOf[object], record.gaps
  local behind = slot and b.group[slot] == record and b.seat[slot] or 0
  local isNear = behind > at and behind <= at + FEW
  if not (isNear and rawequal(record.list[behind + 1], rawget(record.source, n + 1))) then
    return at
  end
  for gap = at, behind - 1 do
    gaps[gap - n + 1] = gap
  end
  return behind
end

-- Lists the gaps, and the places that hold another object than before. Finds how many objects a
-- group holds under the numbers from 1 on.
local function listChanges(b, record, first)
  local source, list, changed = record.source, record.list, record.changed
  local n, at, count, object = first, first, 0, rawget(source, first)
  while object ~= nil do
    if not rawequal(object, list[at]) then
      at = passGaps(b, record, n, at, object)
      if not rawequal(object, list[at]) then
        count = count + 1
        changed[count] = n
      end
    end
    n, at = n + 1, at + 1
    object = rawget(source, n)
  end
  record.gapCount, record.foundCount, record.newCount = at - n, count, n - 1
  for place = n, record.count - record.gapCount do
    count = count + 1
    changed[count] = place
  end
  record.changedCount = count
end

-- Finds the changes in a group from place `first` on. All places have changed if there are other
-- keys, or the group itself has another place.
local function readChanges(b, record, first, isAll)
  local source = record.source
  if record.count == 0 then
    record.direct = check.isObject(source) -- it may have been filled since it was first seen
  end
  record.newKeys, record.newCount = false, 1
  if not record.direct then
    listChanges(b, record, first)
    if hasOthers(record, record.newCount) then
      record.newKeys = sortedKeys(source, check.place(record.name))
      record.newCount = #record.newKeys
    end
  end
  if isAll or record.keys or record.newKeys or record.direct then
    record.gapCount, record.foundCount = 0, record.newCount
    record.changedCount = max(record.count, record.newCount)
    for n = 1, record.changedCount do
      record.changed[n] = n
    end
  end
end

-- Finds whether the registry `asked` knows other groups than `given`, the game's, or has them in
-- another order. (It is called as an order of two numbers.)
local function compare()
  local isSame = given ~= nil and rawequal(asked.source, given)
  local n, isOther = 0, asked.reorder or not isSame
  for name, value in next, isOther and {} or given, nil do
    local record = asked.byName[name]
    n, isOther = n + 1, isOther or not (record and rawequal(record.source, value))
  end
  answer = isOther or n ~= #asked.groups
  return false
end

--- Returns whether there are other groups than those that were seen last, or in another order.
--- (`compare` is not compiled, and compiled code ends where such a function follows; but it goes on
--- behind one of C. So `sort` calls it: questions take 0.8 of the time.)
function groups.haveChanged(self, objects)
  asked, given = self, objects
  sort(TWO, compare)
  asked, given = false, false
  return answer
end

--- Returns the records of all groups in order, and by name; old ones where the table is the same.
--- Errors: a table of groups that is none, or a group; a key that is no finite number or string.
function groups.read(self, objects)
  local records, byName = {}, {}
  if type(objects) ~= "table" then
    check.refuse("objects", "a table of groups", objects)
  end
  for index, name in ipairs(sortedNames(self, objects)) do
    local source, record = objects[name], self.byName[name]
    if type(source) ~= "table" then
      check.refuse(check.place(name), "a group (a table of objects) or an object", source)
    end
    if not record or not rawequal(record.source, source) then
      record = newRecord(name, source)
    end
    records[index], byName[name] = record, record
  end
  return records, byName
end

--- Compares the groups with their records. Returns whether anything has changed. (A group with
--- another place gets other ranks, so all of it is read.)
function groups.compareAll(b, records)
  local isAny = false
  for index, record in ipairs(records) do
    local isOther = record.index ~= index
    local change = isOther and 1 or groups.firstChange(record)
    record.changedCount, record.foundCount, record.gapCount = 0, 0, 0
    record.newKeys, record.newCount = record.keys, record.count
    if change then
      readChanges(b, record, record.keys and 1 or change, isOther)
      isAny = true
    end
  end
  return isAny
end

require(root .. ".memory.compiler").leave(hasOthers, compare)

return groups
