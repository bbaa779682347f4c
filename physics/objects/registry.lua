--- Who is in the world, and in which order.
--
-- The game keeps its objects in plain tables and tells nobody when it adds or removes one. The
-- roster remembers what it saw and compares: as long as nothing changed, that is one comparison an
-- object. Only groups that changed are read again.
--
-- Nothing here follows `pairs` order. Groups: those listed in `order`, then by name, numbers before
-- strings; in a group by key, numbers before strings.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local keyOrder = require(root .. ".memory.keyOrder")

local roster = {}

local max, sort = math.max, table.sort
local GROUP_SPAN = 4294967296 -- ranks per group
local FEW = 64 -- objects of a group that are counted each time
-- So many may have left a group, and who stays is found where it is now without being read anew.
local MOST_GAPS = 32
-- So many of a group may have been taken out since it was read, and who stood behind them is found
-- without looking at all.
local MOST_GONE = 64

-- Whether two tables may be equal by a metamethod that only one of them has, as since Lua 5.3.
local isEqualToAny = setmetatable({}, {
  __eq = function()
    return true
  end,
}) == {}

-- Keeps none of its keys alive.
local function newWeak()
  return setmetatable({}, { __mode = "k" })
end

-- Nor its values: a game may have put anything into a `touching`, also what leads back to its
-- object.
local function newFrail()
  return setmetatable({}, { __mode = "kv" })
end

-- So many are remembered at least. (There are Luas whose weak tables are not weak.)
local MOST_LEFT = 4096

--- Remembers the `touching` of an object, in case it comes back.
function roster.noteLeft(self, object, touching)
  if self.leftCount == MOST_LEFT then
    self.leftBefore, self.left, self.leftCount = self.left, newFrail(), 0
  end
  self.left[object], self.leftCount = touching, self.leftCount + 1
end

--- Returns an empty roster. `groups` are the records in order: a record is
--- `{ name, number, source, direct, index, list, slots, keys, count, plain, stale, first, follows,
--- gaps, gapCount, wasFilled, isSingular }`, where `number` stays as long as the world has a group
--- of this name, and is nobody else's ever, `wasFilled` is for `collect`, `source` is the game's
--- table (the object itself if `direct`), `list` who was in it and `slots` theirs, `plain` says
--- that the keys are just 1 to `count`, `mixed` that they once were others, or out of order, and
--- `isSingular` that everybody in it is static and equal to nobody else (see `firstOther`). Of a
--- stale one those before place `follows` of the list stand before place `first` of the table now,
--- in the same order, without those at the places in `gaps`; what is behind waits in `tail`.
function roster.new()
  return {
    source = false,
    entering = false, -- who is being read for the first time
    order = {},
    groups = {},
    groupCount = 0,
    byName = {},
    numbers = 0, -- the last number of a group
    moved = {}, -- slots of those who have changed their group or their order in an update
    isRenamed = {},
    movedCount = 0,
    seen = {}, -- by slot: the stamp of the last update that has found it in a stale group
    stamp = 0,
    -- Objects that came through `add` and have not been read yet: their `touching`, their group.
    given = newWeak(),
    groupGiven = newWeak(),
    -- The `touching` that those have had who have none now, or are in the world no more: the last
    -- ones, and those before (see `noteLeft`).
    left = newFrail(),
    leftBefore = newFrail(),
    leftCount = 0,
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
    check.fail(path .. " has a key that is not a finite number, got " .. check.show(key))
  end
end

-- How many keys a table has, and whether they are 1, 2, 3, … in the order in which it holds them.
local function countKeys(source)
  local n, isInOrder = 0, true
  for key in next, source, nil do
    n = n + 1
    isInOrder = isInOrder and key == n
  end
  return n, isInOrder
end

-- Whether the keys of a group are just 1 to `count`, which it has.
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

-- The first place, from n on, at which a numbered group does not hold who stood `gap` places
-- further on in the list; behind the list if there is none. One comparison an object; a raw one,
-- since the objects of a game may be "equal" by a metamethod. Where none of them can be, that needs
-- no call, which takes an interpreter three times as long. (Only of static ones, which are read
-- once: one that gets a metatable later is to be refreshed.)
local function firstOther(record, n, gap)
  local source, list, last = record.source, record.list, record.count - gap
  -- (Without a metatable every access is a raw one, and needs no call.)
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

-- The place from which on a group does not hold what was read last; nil: it does.
local function firstChange(record)
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

-- Looks who has left a numbered group that holds another one at place `first`: those behind who has
-- left follow each other as before.
local function findGaps(record)
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

local function haveGroupsChanged(self, objects)
  local n, byName = 0, self.byName
  for name, value in next, objects, nil do
    local record = byName[name]
    if not record or not rawequal(record.source, value) then
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
  sort(rest, keyOrder.comesBefore)
  for _, name in ipairs(rest) do
    names[#names + 1] = name
  end
  return names
end

local function newRecord(name, source, number, wasFilled)
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
    movers = {}, -- these two: see collect
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

--- Says that it is not known any more who of a group are movers. When they are listed, those before
--- place `sameUntil` are who they were, and those from there to `newFrom` were in the group, too.
function roster.relist(record)
  record.isListed, record.sameUntil, record.newFrom = false, 1, 1
end

--- Says that somebody in a group was read anew: it may be of another kind, and equal to others.
function roster.reread(record)
  roster.relist(record)
  record.isSingular = false
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

-- Returns what stays of the last group of the same name (nil: there was none): its number, and
-- whether anybody was in it.
local function inherit(self, last)
  if last then
    return last.number, last.wasFilled
  end
  self.numbers = self.numbers + 1
  return self.numbers, false
end

-- Returns the records of all groups in order, old ones where the table is the same.
local function readGroups(self, objects)
  local groups, byName = {}, {}
  for index, name in ipairs(sortedNames(self, objects)) do
    local source = checkGroup(name, objects[name])
    local record = self.byName[name]
    if not record or not rawequal(record.source, source) then
      local number, wasFilled = inherit(self, record)
      record = newRecord(name, source, number, wasFilled)
    end
    groups[index], byName[name] = record, record
  end
  return groups, byName
end

-- Says that a group must be read anew from place `first` on, and that those before stand as before.
local function readFrom(record, first)
  record.first, record.follows, record.gapCount = first, first, 0
end

-- Reads into the tail who stands under the numbers from `first` on.
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
  readFrom(record, 1)
end

-- Reads who is in a group from `first` on; changes nothing else.
local function readMembers(record, first)
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
  -- One that has grown is counted to be sure: it may hold its new numbers in any order.
  if record.plain and count <= record.count and hasJust(record, count) then
    return
  end
  local found, isInOrder = countKeys(record.source)
  record.mixed = record.mixed or not isInOrder
  if found ~= count then
    readKeys(record)
  end
end

-- How the game would write the place of the n-th in the tail.
local function tailPlace(record, n)
  return roster.place(record, record.newKeys and record.newKeys[n] or record.first - 1 + n)
end

local function failTwice(object, first, second)
  check.fail(
    second
      .. " is the same object as "
      .. first
      .. ": an object must be in one place only, got "
      .. check.show(object)
      .. " in two"
  )
end

-- Finds the slots of those in the tail, 0 for who is new. Most of them stood in the list in the
-- same order, with one missing now and then.
local function matchTail(b, record)
  local tail, slots, list, known = record.tail, record.tailSlots, record.list, record.slots
  local objects, slotOf, m = b.object, b.slotOf, record.follows
  for n = 1, record.tailCount do
    local object, slot = tail[n], 0
    if rawequal(list[m], object) then
      slot, m = known[m], m + 1
    elseif rawequal(list[m + 1], object) then
      slot, m = known[m + 1], m + 2
    end
    -- After an update that failed the list may be out of date.
    if not rawequal(objects[slot], object) then
      slot = slotOf[object] or 0
    end
    slots[n] = slot
  end
end

-- The place in which an object was found first.
local function firstPlace(groups, object)
  for _, record in ipairs(groups) do
    for n = 1, record.stale and record.tailCount or 0 do
      if rawequal(record.tail[n], object) then
        return tailPlace(record, n)
      end
    end
  end
end

-- Where somebody who stood under a key stands in its group now; nil: it left, or is read anew.
local function placeNow(record, key)
  if not record.stale then
    return key
  elseif record.follows == 1 or key >= record.follows then
    return nil -- (keys that are no numbers: all are read anew)
  end
  local place = key
  for n = 1, record.gapCount do
    if record.gaps[n] == key then
      return nil
    elseif record.gaps[n] < key then
      place = place - 1
    end
  end
  return place
end

-- Somebody in the tail who is known must stand nowhere else.
local function checkKnown(b, self, groups, record, n, slot)
  local object, owner, seen = record.tail[n], b.group[slot], self.seen
  if seen[slot] == self.stamp then
    failTwice(object, firstPlace(groups, object), tailPlace(record, n))
  end
  local place = placeNow(owner, b.key[slot])
  if place then
    failTwice(object, roster.place(owner, place), tailPlace(record, n))
  end
  seen[slot] = self.stamp
end

-- Somebody who is new must be of use, and stand nowhere else.
local function checkNew(groups, record, n, found)
  local object = record.tail[n]
  if type(object) ~= "table" then
    check.fail(tailPlace(record, n) .. " must be an object (a table), got " .. check.show(object))
  elseif found[object] then
    failTwice(object, firstPlace(groups, object), tailPlace(record, n))
  end
  found[object] = true
  check.object(object, tailPlace(record, n))
end

-- Checks that nobody in the stale records stands in two places, and all who are new.
local function checkMembers(b, self, groups)
  local found = {}
  self.stamp = self.stamp + 1
  for _, record in ipairs(groups) do
    if record.stale then
      matchTail(b, record)
      local slots = record.tailSlots
      for n = 1, record.tailCount do
        if slots[n] ~= 0 then
          checkKnown(b, self, groups, record, n, slots[n])
        else
          checkNew(groups, record, n, found)
        end
      end
    end
  end
end

-- Moves those that stand at places `first` to `last` now up by `gap` places in the list.
local function moveUp(b, record, first, last, gap)
  local list, slots, rank, key = record.list, record.slots, b.rank, b.key
  local base = record.index * GROUP_SPAN
  for n = first, last do
    local slot = slots[n + gap]
    list[n], slots[n] = list[n + gap], slot
    key[slot], rank[slot] = n, base + n
  end
end

-- Closes the gaps that those who have left leave in the list.
local function closeGaps(b, record)
  local gaps, count = record.gaps, record.gapCount
  for gap = 1, count do
    local last = gap < count and gaps[gap + 1] or record.follows
    moveUp(b, record, gaps[gap] - gap + 1, last - 1 - gap, gap)
  end
end

-- For whom `collect` must look when it lists the movers of a group.
local function noteChange(record)
  local isListed, gaps = record.isListed, record.gapCount
  roster.relist(record)
  if isListed then
    record.sameUntil = gaps > 0 and record.gaps[1] or record.follows
    record.newFrom = record.first
  end
end

-- Puts the tail into the list.
local function takeTail(record)
  local list, slots, tail, tailSlots = record.list, record.slots, record.tail, record.tailSlots
  local before = record.first - 1
  local count = before + record.tailCount
  for n = 1, record.tailCount do
    local object = tail[n]
    list[before + n], slots[before + n] = object, tailSlots[n]
    record.isSingular = record.isSingular and getmetatable(object) == nil and object.static == true
    tail[n] = nil -- keeps nobody alive
  end
  for n = count + 1, record.count do
    list[n], slots[n] = nil, nil
  end
  record.keys, record.plain = record.newKeys or {}, not record.newKeys
  record.count = count
  noteChange(record)
end

-- Gives the known members of a record their keys, ranks and group; lists those who are in another
-- group than before, or behind one that they stood before.
local function applyKnown(b, self, record, rename)
  local slots, keys, plain = record.slots, record.keys, record.plain
  local moved, isRenamed = self.moved, self.isRenamed
  local rank, key, groups, base = b.rank, b.key, b.group, record.index * GROUP_SPAN
  local last = base + record.follows - 1 -- the rank of the last one before them, or a larger one
  for n = record.first, record.count do
    local slot = slots[n]
    if slot ~= 0 then
      local isOther = groups[slot] ~= record
      if isOther or rank[slot] < last then
        self.movedCount = self.movedCount + 1
        moved[self.movedCount], isRenamed[self.movedCount] = slot, isOther
      else
        last = rank[slot]
      end
      if isOther then
        rename(b, slot, record)
      end
      key[slot], rank[slot] = plain and n or keys[n], base + n
    end
  end
end

-- Reports who has moved. Not before all have their ranks and groups: what ends because of that is
-- told in the order of the world.
local function reportMoved(b, self, reorder)
  for n = 1, reorder and self.movedCount or 0 do
    reorder(b, self.moved[n], self.isRenamed[n])
  end
  self.movedCount = 0
end

-- Lets in who is new.
local function applyNew(b, self, record, enter)
  local list, slots, keys, plain = record.list, record.slots, record.keys, record.plain
  for n = record.first, record.count do
    if slots[n] == 0 then
      local key = plain and n or keys[n]
      self.entering = list[n]
      local slot = enter(b, list[n], record, key)
      self.entering = false
      slots[n] = slot
      b.key[slot], b.rank[slot] = key, record.index * GROUP_SPAN + n
    end
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

-- Whoever stood at place n of a stale record and is in none now leaves.
local function leaveIfMissing(b, self, record, n, leave)
  local slot = record.slots[n]
  if self.seen[slot] ~= self.stamp and rawequal(b.object[slot], record.list[n]) then
    leave(b, slot)
  end
end

-- Whoever was in a stale record and is in none now leaves.
local function leaveMissing(b, self, record, leave)
  for n = 1, record.gapCount do
    leaveIfMissing(b, self, record, record.gaps[n], leave)
  end
  for n = record.follows, record.count do
    leaveIfMissing(b, self, record, n, leave)
  end
end

-- Ranks a record anew; `isBehind`: behind one that it stood before.
local function applyIndex(b, record, index, isBehind, reorder)
  record.index = index
  for n = 1, record.count do
    local slot = record.slots[n]
    if rawequal(b.object[slot], record.list[n]) then
      b.rank[slot] = index * GROUP_SPAN + n
      if isBehind and reorder then
        reorder(b, slot)
      end
    end
  end
end

-- Puts the records in order and ranks anew those that moved.
local function applyGroups(b, self, objects, groups, byName, reorder)
  local last = 0
  for index, record in ipairs(groups) do
    local before = record.index
    if before ~= index or before < last then
      applyIndex(b, record, index, before < last, reorder)
    end
    last = before > last and before or last
  end
  self.source, self.groups, self.byName, self.groupCount = objects, groups, byName, #groups
end

-- Notes which records differ from the game's tables, and from where on.
local function markStale(groups)
  local any = false
  for n = 1, #groups do
    local record = groups[n]
    -- One that is stale already is new, or was left half done by an error.
    local isNew, change = record.stale, 1 ---@type boolean, integer?
    if not isNew then
      change = firstChange(record)
    end
    record.stale, any = change ~= nil, any or change ~= nil
    readFrom(record, change or 1)
    if change and record.plain and not isNew then
      findGaps(record)
    end
  end
  return any
end

-- Those who came through `add` have been read, or are not there any more.
local function forgetGiven(b, self)
  local given, groupGiven, n = self.given, self.groupGiven, 0
  for object in next, groupGiven, nil do
    if given[object] and not b.slotOf[object] then
      roster.noteLeft(self, object, given[object])
    end
    given[object], groupGiven[object], n = nil, nil, n + 1
  end
  -- Many leave a large table behind, and it takes long to see that it is empty.
  if n > FEW then
    self.groupGiven = newWeak()
  end
end

--- Compares the game's tables with what was seen last and reports what changed, nothing if the
--- tables cannot be used: `enter(b, object, record, key)` for a new object (returns its slot),
--- `leave(b, slot)` for one that is gone, `rename(b, slot, record)` for one whose group is another
--- now, while others still have their old one; then `reorder(b, slot, isRenamed)`, if it is given,
--- for all these and for whoever now stands behind another before which it stood. Returns whether
--- anything changed.
function roster.update(b, self, objects, enter, leave, rename, reorder)
  leaveHalf(b, self, leave)
  local groups, byName = self.groups, self.byName
  local regroup = not rawequal(self.source, objects)
    or self.reorder
    or haveGroupsChanged(self, objects)
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
      readFrom(record, 1)
      gone[#gone + 1] = record
    end
  end
  for _, record in ipairs(groups) do
    if record.stale then
      readMembers(record, record.first)
    end
  end
  checkMembers(b, self, groups)
  for _, record in ipairs(gone) do
    leaveMissing(b, self, record, leave)
  end
  for _, record in ipairs(groups) do
    if record.stale then
      leaveMissing(b, self, record, leave)
    end
  end
  applyGroups(b, self, objects, groups, byName, reorder)
  for _, record in ipairs(groups) do
    if record.stale then
      closeGaps(b, record)
      takeTail(record)
    end
  end
  for _, record in ipairs(groups) do
    if record.stale then
      applyKnown(b, self, record, rename)
    end
  end
  reportMoved(b, self, reorder)
  -- Last of all: should somebody fail now, everybody else is where it stands.
  for _, record in ipairs(groups) do
    if record.stale then
      applyNew(b, self, record, enter)
    end
  end
  self.reorder = false
  forgetGiven(b, self)
  return true
end

--- Returns whether the game's tables differ from what was seen last. Changes nothing.
function roster.hasChanged(self, objects)
  local isOther = not rawequal(self.source, objects)
  if type(objects) ~= "table" or isOther or haveGroupsChanged(self, objects) then
    return true
  end
  for n = 1, self.groupCount do
    local record = self.groups[n]
    if record.stale or firstChange(record) then
      return true
    end
  end
  return false
end

local function numbersTo(count)
  local list = {}
  for n = 1, count do
    list[n] = n
  end
  return list
end

--- Returns the game's tables as the next `update` would read them: records in order, the members in
--- `tail[1..tailCount]`, their keys in `newKeys`. Changes nothing.
--- Errors: as `update`.
function roster.look(b, self, objects)
  if type(objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(objects))
  end
  local records, found = {}, {}
  for index, name in ipairs(sortedNames(self, objects)) do
    local record = newRecord(name, checkGroup(name, objects[name]), 0, false)
    records[index] = record
    readMembers(record, 1)
    for n = 1, record.tailCount do
      local object = record.tail[n]
      if type(object) == "table" and b.slotOf[object] and not found[object] then
        found[object] = true
      else
        checkNew(records, record, n, found)
      end
    end
    record.newKeys = record.newKeys or numbersTo(record.tailCount)
  end
  return records
end

-- Where an object stands that stood under a number: there, or a little before that if others have
-- left. (No further: a number may be any, such as an id.)
local function findBefore(source, object, hint)
  for key = hint, max(hint - MOST_GONE, 1), -1 do
    if rawequal(rawget(source, key), object) then
      return key
    end
  end
end

--- Returns the key under which an object stands in its group's table now, or nil. `hint`: it may be
--- that one, or one a little before it.
function roster.find(source, object, hint)
  local key = hint
  if type(hint) == "number" then
    key = findBefore(source, object, hint)
  end
  if key ~= nil and rawequal(source[key], object) then
    return key
  end
  for other, value in next, source, nil do
    if rawequal(value, object) then
      return other
    end
  end
end

--- Returns the table that holds the object of a slot now, and its key in there, if it still stands
--- in the table in which it was seen; `objects` is the game's table of groups.
function roster.whereSeen(b, objects, slot)
  local record, object = b.group[slot], b.object[slot]
  local source = objects[record.name]
  if record.direct then
    if rawequal(source, object) then
      return objects, record.name
    end
  elseif rawequal(source, record.source) then
    local key = roster.find(source, object, b.key[slot])
    if key ~= nil then
      return source, key
    end
  end
end

interpreted.always(
  countKeys,
  hasJust,
  haveGroupsChanged,
  sortedNames,
  readKeys,
  forgetGiven,
  roster.update,
  roster.find
)

return roster
