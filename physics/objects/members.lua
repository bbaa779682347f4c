--- Checks that each object stands in one place only, and that new ones can be used.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local groups = require(root .. ".objects.groups")

local members = {}

-- Returns how the game would write the place of the n-th object of the tail.
local function tailPlace(record, n)
  return groups.place(record, record.newKeys and record.newKeys[n] or record.first - 1 + n)
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

-- Finds the slots of the objects in the tail, 0 for a new one. Most of them stood in the list in
-- the same order, with one missing now and then.
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

-- Returns the place in which an object was found first.
local function firstPlace(records, object)
  for _, record in ipairs(records) do
    for n = 1, record.stale and record.tailCount or 0 do
      if rawequal(record.tail[n], object) then
        return tailPlace(record, n)
      end
    end
  end
end

-- Returns where an object that stood under a key stands in its group now. nil: it has left, or is
-- read anew.
local function placeNow(record, key)
  if not record.stale then
    return key
  elseif record.follows == 1 or key >= record.follows then
    return nil -- (keys that are no numbers: all objects are read anew)
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

-- Checks that a known object in the tail stands in no other place.
local function checkKnown(b, self, records, record, n, slot)
  local object, owner, seen = record.tail[n], b.group[slot], self.seen
  if seen[slot] == self.stamp then
    failTwice(object, firstPlace(records, object), tailPlace(record, n))
  end
  local place = placeNow(owner, b.key[slot])
  if place then
    failTwice(object, groups.place(owner, place), tailPlace(record, n))
  end
  seen[slot] = self.stamp
end

--- Checks that a new object can be used, and stands in no other place.
function members.checkNew(records, record, n, found)
  local object = record.tail[n]
  if type(object) ~= "table" then
    check.fail(tailPlace(record, n) .. " must be an object (a table), got " .. check.show(object))
  elseif found[object] then
    failTwice(object, firstPlace(records, object), tailPlace(record, n))
  end
  found[object] = true
  if check.badField(object) then
    check.object(object, tailPlace(record, n))
  end
end

--- Checks that no object in the stale records stands in two places, and checks all new ones.
function members.check(b, self, records)
  local found = {}
  self.stamp = self.stamp + 1
  for _, record in ipairs(records) do
    if record.stale then
      matchTail(b, record)
      local slots = record.tailSlots
      for n = 1, record.tailCount do
        if slots[n] ~= 0 then
          checkKnown(b, self, records, record, n, slots[n])
        else
          members.checkNew(records, record, n, found)
        end
      end
    end
  end
end

return members
