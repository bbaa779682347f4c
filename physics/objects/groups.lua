--- What the tables of the game's groups hold, compared with the last look.
--
-- A record is what is known of a group; `registry` has the list of its fields. Nothing here follows
-- the order of `pairs`. Groups come in the order of `order`, then by name, numbers before strings.
-- Objects in a group come by key, numbers before strings.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local keyOrder = require(root .. ".memory.keyOrder")

local groups = {}

local sort = table.sort
local FEW = 64 -- groups up to this size are counted each time
-- Up to so many objects may have left a group without the others being read anew.
local MOST_GAPS = 32

-- Returns true where `==` calls a metamethod that only one of the two has (since Lua 5.3).
local isEqualToAny = setmetatable({}, {
  __eq = function()
    return true
  end,
}) == {}

-- Returns whether a value is an object, and not a group, from its first field. One with a
-- missing or wrong width counts as one, so that the error is about the width.
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
    check.fail(path .. " has a key that is not a finite number, got " .. check.show(key))
  end
end

-- Returns how many keys a table has, and whether they are 1, 2, 3, … in the order of `next`.
local function countKeys(source)
  local n, isInOrder = 0, true
  for key in next, source, nil do
    n = n + 1
    isInOrder = isInOrder and key == n
  end
  return n, isInOrder
end

-- Returns whether the keys of a group, which include 1 to `count`, are no others.
local function hasJust(record, count)
  local source = record.source
  if count <= FEW or record.mixed then
    return countKeys(source) == count
  end
  if rawget(source, count + 1) ~= nil then
    return false
  end
  -- Keys beyond the last number follow it in the table, unless that has room left from others.
  return next(source, count) == nil or countKeys(source) == count
end

-- Returns the first place, from n on, at which a numbered group does not hold the object that stood
-- `gap` places further on in the list; the place behind the list if there is none. It takes one
-- comparison an object. The comparison is raw, since a game's objects may be "equal" by a
-- metamethod. Where none of them can be, no call of `rawequal` is needed, which takes an
-- interpreter three times as long. (That is known of static objects only, which are read once. One
-- that gets a metatable later must be refreshed.)
local function firstOther(record, n, gap)
  local source, list, last = record.source, record.list, record.count - gap
  -- (Without a metatable every access is raw, and needs no call.)
  local isRaw = getmetatable(source) == nil
  if gap == 0 and isRaw and record.isSingular then
    for at = n, last do
      if source[at] ~= list[at] then
        return at
      end
    end
    return last + 1
  end
  for at = n, last do
    local object
    if isRaw then
      object = source[at]
    else
      object = rawget(source, at)
    end
    if not rawequal(object, list[at + gap]) then
      return at
    end
  end
  return last + 1
end

--- Returns the place from which on a group differs from what was read last; nil: it does not.
function groups.firstChange(record)
  if record.direct then
    return nil
  end
  local source, list, count = record.source, record.list, record.count
  if not record.plain then
    local keys = record.keys
    for n = 1, count do
      if not rawequal(rawget(source, keys[n]), list[n]) then
        return 1
      end
    end
    return countKeys(source) ~= count and 1 or nil
  end
  local n = firstOther(record, 1, 0)
  return (n <= count or not hasJust(record, count)) and n or nil
end

--- Finds the objects that have left a numbered group, which holds another object at place `first`.
--- The objects behind one that has left follow each other as before.
function groups.findGaps(record)
  local source, list, count, gaps = record.source, record.list, record.count, record.gaps
  local n, gap = record.first, 0
  local object = rawget(source, n)
  while n + gap <= count and object ~= nil do
    local more = gap
    repeat
      more = more + 1
      gaps[more] = n + more - 1
    until more >= MOST_GAPS or rawequal(list[n + more], object)
    if not rawequal(list[n + more], object) then
      break
    end
    n, gap = firstOther(record, n + 1, more), more
    object = gap < MOST_GAPS and rawget(source, n) or nil
  end
  record.first, record.follows, record.gapCount = n, n + gap, gap
end

--- Returns the names of all groups in order.
function groups.sortedNames(self, objects)
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
  sort(rest, keyOrder.comesBefore)
  for _, name in ipairs(rest) do
    names[#names + 1] = name
  end
  return names
end

--- Returns a record of a group of which nothing is known yet.
function groups.newRecord(name, source, number, wasFilled)
  local direct = isObject(source)
  return {
    name = name,
    number = number,
    wasFilled = wasFilled,
    source = source,
    direct = direct,
    index = 0,
    list = {},
    slots = {},
    keys = {},
    count = 0,
    plain = true,
    isSingular = not isEqualToAny,
    movers = {}, -- these two: see read.lua
    moverPlaces = {},
    isListed = false,
    sameUntil = 1,
    newFrom = 1,
    mixed = false,
    stale = true,
    first = 1,
    follows = 1,
    gaps = {},
    gapCount = 0,
    tail = {},
    tailSlots = {},
    tailCount = 0,
  }
end

--- Marks the list of movers of a group as out of date. When it is listed again, the members before
--- place `sameUntil` are the same. Those from there to `newFrom` were in the group, too.
function groups.relist(record)
  record.isListed, record.sameUntil, record.newFrom = false, 1, 1
end

--- Notes that an object of a group was read anew. Its kind may have changed, and it may be equal to
--- others.
function groups.reread(record)
  groups.relist(record)
  record.isSingular = false
end

--- Returns how the game would write the place of an object.
function groups.place(record, key)
  if record.direct then
    return check.place(record.name)
  end
  return check.place(record.name, key)
end

--- Returns how the game would write the place of the object in a slot.
function groups.placeOf(b, i)
  return groups.place(b.group[i], b.key[i])
end

--- Returns the table of a group. Errors: it is no table.
function groups.checkGroup(name, source)
  if type(source) ~= "table" then
    check.fail(
      check.place(name)
        .. " must be a group (a table of objects) or an object, got "
        .. check.show(source)
    )
  end
  return source
end

--- Marks a group to be read anew from place `first` on. The objects before stand as before.
function groups.readFrom(record, first)
  record.first, record.follows, record.gapCount = first, first, 0
end

-- Reads the objects under the numbers from `first` on into the tail.
local function readNumbered(record, first)
  local source, tail, n = record.source, record.tail, 0
  local object = rawget(source, first)
  while object ~= nil do
    n = n + 1
    tail[n] = object
    object = rawget(source, first + n)
  end
  record.first, record.tailCount = first, n
end

-- Reads a whole group by its keys, in order.
local function readKeys(record)
  local source, tail, keys, n = record.source, record.tail, {}, 0
  for key in next, source, nil do
    checkKey(key, check.place(record.name))
    n = n + 1
    keys[n] = key
  end
  sort(keys, keyOrder.comesBefore)
  for at = 1, n do
    tail[at] = rawget(source, keys[at])
  end
  record.newKeys, record.tailCount = keys, n
  groups.readFrom(record, 1)
end

--- Reads the objects of a group from `first` on into the tail; changes nothing else.
function groups.readMembers(record, first)
  if record.count == 0 then
    record.direct = isObject(record.source) -- it may have been filled since it was first seen
  end
  record.newKeys = false
  if record.direct then
    record.tail[1], record.first, record.tailCount = record.source, 1, 1
    return
  end
  readNumbered(record, record.plain and first or 1)
  local count = record.first - 1 + record.tailCount
  -- A group that has grown is counted to be sure: it may hold its new numbers in any order.
  if record.plain and count <= record.count and hasJust(record, count) then
    return
  end
  local found, isInOrder = countKeys(record.source)
  record.mixed = record.mixed or not isInOrder
  if found ~= count then
    readKeys(record)
  end
end

interpreted.always(countKeys, hasJust, groups.sortedNames, readKeys)

return groups
