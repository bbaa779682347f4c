--- Finds which objects are in the world, and in which order, by comparing tables with the last
--- look.
--
-- The game keeps its objects in plain tables and does not say when it adds or removes one. The
-- registry remembers what it saw and compares. As long as nothing has changed, that is one
-- comparison an object. Only groups that have changed are read again.
--
-- What has changed in a group is found in groups.lua, and members.lua checks what is new.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local groups = require(root .. ".objects.groups")
local members = require(root .. ".objects.members")

local registry = {}

local max = math.max
local GROUP_SPAN = 4294967296 -- ranks per group
-- Up to so many objects may have left a group since it was read, and those behind them are found by
-- going back from their old number.
local MOST_GONE = 64
-- After so many objects have been added, the table for them is made anew.
local FEW = 64

registry.placeOf, registry.reread = groups.placeOf, groups.reread

-- Returns a table that keeps none of its keys alive.
local function newWeak()
  return setmetatable({}, { __mode = "k" })
end

-- Returns a table that keeps neither keys nor values alive. A game may have put anything into a
-- `touching`, also something that refers to its object.
local function newFrail()
  return setmetatable({}, { __mode = "kv" })
end

-- At least so many are remembered. (On some Luas weak tables are not weak.)
local MOST_LEFT = 4096

--- Remembers the `touching` of an object, in case it returns.
function registry.noteLeft(self, object, touching)
  if self.leftCount == MOST_LEFT then
    self.leftBefore, self.left, self.leftCount = self.left, newFrail(), 0
  end
  self.left[object], self.leftCount = touching, self.leftCount + 1
end

--- Returns an empty registry. `groups` are the records in order. A record has these fields:
--- - `number`: stays as long as the world has a group of this name, and is never used again;
--- - `wasFilled`: for the comparison of masks in read.lua;
--- - `source`: the game's table (the object itself if `direct`);
--- - `list`, `slots`: the objects that were in it, and their slots;
--- - `plain`: the keys are just 1 to `count`;
--- - `mixed`: the keys once were others, or out of order;
--- - `isSingular`: all objects are static and equal to no other one (see `firstOther`).
---
--- Of a stale record, the objects before place `follows` of the list stand before place `first` of
--- the table now. Their order is the same, without those at the places in `gaps`. The objects
--- behind them wait in `tail`.
function registry.new()
  return {
    source = false,
    entering = false, -- the object that is being read for the first time
    order = {},
    groups = {},
    groupCount = 0,
    byName = {},
    numbers = 0, -- the last number of a group
    moved = {}, -- slots that have changed their group or their order in an update
    isRenamed = {},
    movedCount = 0,
    seen = {}, -- by slot: the stamp of the last update that has found it in a stale group
    stamp = 0,
    -- Objects that came through `add` and have not been read yet: their `touching`, their group.
    given = newWeak(),
    groupGiven = newWeak(),
    -- The `touching` of objects that have none now, or have left the world: the latest, and those
    -- before (see `noteLeft`).
    left = newFrail(),
    leftBefore = newFrail(),
    leftCount = 0,
  }
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

-- Returns what a group takes over from the last group of the same name (nil: there was none): its
-- number, and whether it had objects.
local function inherit(self, last)
  if last then
    return last.number, last.wasFilled
  end
  self.numbers = self.numbers + 1
  return self.numbers, false
end

-- Returns the records of all groups in order; old ones where the table is the same.
local function readGroups(self, objects)
  local records, byName = {}, {}
  for index, name in ipairs(groups.sortedNames(self, objects)) do
    local source = groups.checkGroup(name, objects[name])
    local record = self.byName[name]
    if not record or not rawequal(record.source, source) then
      local number, wasFilled = inherit(self, record)
      record = groups.newRecord(name, source, number, wasFilled)
    end
    records[index], byName[name] = record, record
  end
  return records, byName
end

-- Moves the objects at places `first + gap` to `last + gap` of the list up by `gap` places.
local function moveUp(b, record, first, last, gap)
  local list, slots, rank, key = record.list, record.slots, b.rank, b.key
  local base = record.index * GROUP_SPAN
  for n = first, last do
    local slot = slots[n + gap]
    list[n], slots[n] = list[n + gap], slot
    key[slot], rank[slot] = n, base + n
  end
end

-- Closes the gaps in the list that objects have left.
local function closeGaps(b, record)
  local gaps, count = record.gaps, record.gapCount
  for gap = 1, count do
    local last = gap < count and gaps[gap + 1] or record.follows
    moveUp(b, record, gaps[gap] - gap + 1, last - 1 - gap, gap)
  end
end

-- Notes which part of a group's movers read.lua must list again.
local function noteChange(record)
  local isListed, gaps = record.isListed, record.gapCount
  groups.relist(record)
  if isListed then
    record.sameUntil = gaps > 0 and record.gaps[1] or record.follows
    record.newFrom = record.first
  end
end

-- Appends the tail to the list.
local function takeTail(record)
  local list, slots, tail, tailSlots = record.list, record.slots, record.tail, record.tailSlots
  local before = record.first - 1
  local count = before + record.tailCount
  for n = 1, record.tailCount do
    local object = tail[n]
    list[before + n], slots[before + n] = object, tailSlots[n]
    record.isSingular = record.isSingular and getmetatable(object) == nil and object.static == true
    tail[n] = nil -- keeps no object alive
  end
  for n = count + 1, record.count do
    list[n], slots[n] = nil, nil
  end
  record.keys, record.plain = record.newKeys or {}, not record.newKeys
  record.count = count
  noteChange(record)
end

-- Gives the known members of a record their keys, ranks and group. Lists those that have changed
-- their group, or stand behind one that they stood before.
local function applyKnown(b, self, record, rename)
  local slots, keys, plain = record.slots, record.keys, record.plain
  local moved, isRenamed = self.moved, self.isRenamed
  local rank, key, group, base = b.rank, b.key, b.group, record.index * GROUP_SPAN
  local last = base + record.follows - 1 -- the rank of the last one before them, or a higher one
  for n = record.first, record.count do
    local slot = slots[n]
    if slot ~= 0 then
      local isOther = group[slot] ~= record
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

-- Reports the objects that have moved, after all have their ranks and groups. Contacts that end
-- because of that are reported in the order of the world.
local function reportMoved(b, self, reorder)
  for n = 1, reorder and self.movedCount or 0 do
    reorder(b, self.moved[n], self.isRenamed[n])
  end
  self.movedCount = 0
end

-- Enters the new objects.
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

-- Removes an object that could not be read, so that only half of it is there.
local function leaveHalf(b, self, leave)
  local slot = self.entering and b.slotOf[self.entering]
  self.entering = false
  if slot then
    leave(b, slot)
  end
end

-- Removes the object at place n of a stale record if it is in no record now.
local function leaveIfMissing(b, self, record, n, leave)
  local slot = record.slots[n]
  if self.seen[slot] ~= self.stamp and rawequal(b.object[slot], record.list[n]) then
    leave(b, slot)
  end
end

-- Removes the objects of a stale record that are in no record now.
local function leaveMissing(b, self, record, leave)
  for n = 1, record.gapCount do
    leaveIfMissing(b, self, record, record.gaps[n], leave)
  end
  for n = record.follows, record.count do
    leaveIfMissing(b, self, record, n, leave)
  end
end

-- Gives the objects of a record new ranks. `isBehind`: the record is now behind one that it stood
-- before.
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

-- Puts the records in order and gives new ranks to those that have moved.
local function applyGroups(b, self, objects, records, byName, reorder)
  local last = 0
  for index, record in ipairs(records) do
    local before = record.index
    if before ~= index or before < last then
      applyIndex(b, record, index, before < last, reorder)
    end
    last = before > last and before or last
  end
  self.source, self.groups, self.byName, self.groupCount = objects, records, byName, #records
end

-- Notes which records differ from the game's tables, and from which place on.
local function markStale(records)
  local any = false
  for n = 1, #records do
    local record = records[n]
    -- A record that is stale already is new, or an error has left it half done.
    local isNew, change = record.stale, 1 ---@type boolean, integer?
    if not isNew then
      change = groups.firstChange(record)
    end
    record.stale, any = change ~= nil, any or change ~= nil
    groups.readFrom(record, change or 1)
    if change and record.plain and not isNew then
      groups.findGaps(record)
    end
  end
  return any
end

-- Forgets what `add` has noted: these objects have been read, or have been removed again.
local function forgetGiven(b, self)
  local given, groupGiven, n = self.given, self.groupGiven, 0
  for object in next, groupGiven, nil do
    if given[object] and not b.slotOf[object] then
      registry.noteLeft(self, object, given[object])
    end
    given[object], groupGiven[object], n = nil, nil, n + 1
  end
  -- After many objects the table stays large, and finding it empty takes long.
  if n > FEW then
    self.groupGiven = newWeak()
  end
end

-- Marks the records of groups that are not in the game's tables any more as stale; returns them.
local function markGone(self, byName)
  local gone = {}
  for _, record in ipairs(self.groups) do
    if byName[record.name] ~= record then
      record.stale = true
      groups.readFrom(record, 1)
      gone[#gone + 1] = record
    end
  end
  return gone
end

-- Reads and checks the stale groups. Errors: a group or object that cannot be used.
local function readStale(b, self, records)
  for _, record in ipairs(records) do
    if record.stale then
      groups.readMembers(record, record.first)
    end
  end
  members.check(b, self, records)
end

-- Removes the objects that are in no group now.
local function leaveStale(b, self, records, gone, leave)
  for _, record in ipairs(gone) do
    leaveMissing(b, self, record, leave)
  end
  for _, record in ipairs(records) do
    if record.stale then
      leaveMissing(b, self, record, leave)
    end
  end
end

-- Takes over what the stale groups hold now.
local function applyStale(b, self, records, enter, rename, reorder)
  for _, record in ipairs(records) do
    if record.stale then
      closeGaps(b, record)
      takeTail(record)
    end
  end
  for _, record in ipairs(records) do
    if record.stale then
      applyKnown(b, self, record, rename)
    end
  end
  reportMoved(b, self, reorder)
  -- New objects come last: if one fails, all others are in their places.
  for _, record in ipairs(records) do
    if record.stale then
      applyNew(b, self, record, enter)
    end
  end
end

--- Compares the game's tables with what was seen last and reports the changes:
--- - `enter(b, object, record, key)` for a new object; it returns the slot;
--- - `leave(b, slot)` for one that has left;
--- - `rename(b, slot, record)` for one that has changed its group, while others still have their
---   old one;
--- - then `reorder(b, slot, isRenamed)`, if given, for these and for each one that is now behind
---   another that it stood before.
---
--- If the tables cannot be used, nothing is reported. Returns whether anything has changed.
function registry.update(b, self, objects, enter, leave, rename, reorder)
  leaveHalf(b, self, leave)
  local records, byName = self.groups, self.byName
  local regroup = not rawequal(self.source, objects)
    or self.reorder
    or haveGroupsChanged(self, objects)
  if regroup then
    if type(objects) ~= "table" then
      check.fail("objects must be a table of groups, got " .. check.show(objects))
    end
    records, byName = readGroups(self, objects)
  end
  if not markStale(records) and not regroup then
    return false
  end
  local gone = markGone(self, byName)
  readStale(b, self, records)
  leaveStale(b, self, records, gone, leave)
  applyGroups(b, self, objects, records, byName, reorder)
  applyStale(b, self, records, enter, rename, reorder)
  self.reorder = false
  forgetGiven(b, self)
  return true
end

--- Returns whether the game's tables differ from what was seen last. Changes nothing.
function registry.hasChanged(self, objects)
  local isOther = not rawequal(self.source, objects)
  if type(objects) ~= "table" or isOther or haveGroupsChanged(self, objects) then
    return true
  end
  for n = 1, self.groupCount do
    local record = self.groups[n]
    if record.stale or groups.firstChange(record) then
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
--- `tail[1..tailCount]`, their keys in `newKeys`. Changes nothing. Errors: those of `update`.
function registry.look(b, self, objects)
  if type(objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(objects))
  end
  local records, found = {}, {}
  for index, name in ipairs(groups.sortedNames(self, objects)) do
    local record = groups.newRecord(name, groups.checkGroup(name, objects[name]), 0, false)
    records[index] = record
    groups.readMembers(record, 1)
    for n = 1, record.tailCount do
      local object = record.tail[n]
      if type(object) == "table" and b.slotOf[object] and not found[object] then
        found[object] = true
      else
        members.checkNew(records, record, n, found)
      end
    end
    record.newKeys = record.newKeys or numbersTo(record.tailCount)
  end
  return records
end

-- Returns the number under which an object stands now: its old one, or a little less if others have
-- left. (Not much less: a number may be anything, such as an id.)
local function findBefore(source, object, hint)
  for key = hint, max(hint - MOST_GONE, 1), -1 do
    if rawequal(rawget(source, key), object) then
      return key
    end
  end
end

--- Returns the key under which an object stands in its group's table now, or nil. `hint` is a key
--- to try first; if it is a number, the numbers just before it, too.
function registry.find(source, object, hint)
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

--- Returns the table that holds the object of a slot now, and its key there; nothing if the object
--- no longer stands in the table in which it was seen. `objects` is the game's table of groups.
function registry.whereSeen(b, objects, slot)
  local record, object = b.group[slot], b.object[slot]
  local source = objects[record.name]
  if record.direct then
    if rawequal(source, object) then
      return objects, record.name
    end
  elseif rawequal(source, record.source) then
    local key = registry.find(source, object, b.key[slot])
    if key ~= nil then
      return source, key
    end
  end
end

interpreted.always(
  haveGroupsChanged,
  forgetGiven,
  markGone,
  readStale,
  leaveStale,
  applyStale,
  registry.update,
  registry.find
)

return registry
