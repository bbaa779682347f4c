---@diagnostic disable
--- Restores a world from a state (see format.lua).
--
-- The game's tables get their saved fields and places, and are read. Then the columns that outlive
-- a step are filled. So the next step finds everything as it was.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local boxes = require(root .. ".space.boxes")
local check = require(root .. ".fields.check")
local constants = require(root .. ".memory.constants")
local events = require(root .. ".contacts.events")
local fields = require(root .. ".fields.fields")
local format = require(root .. ".state.format")
local forms = require(root .. ".fields.forms")
local islands = require(root .. ".sleep.islands")
local layout = require(root .. ".memory.layout")
local links = require(root .. ".memory.links")
local pairFinder = require(root .. ".broadphase.pairFinder")
local read = require(root .. ".objects.read")
local readFields = require(root .. ".objects.readFields")
local recall = require(root .. ".memory.lazy")(root .. ".maps.recall")
local settings = require(root .. ".objects.settings")
local validate = require(root .. ".state.validate")
local zones = require(root .. ".memory.lazy")(root .. ".motion.zones")

local restore = {}

local STATIC = constants.STATIC
local COLUMNS, PAIRS, VALUES = layout.KEPT, format.PAIRS, events.VALUES
local NONE = {}
local MISFIT = "%s has %d objects in the state and %d here: numbers shift, string keys stay"
local max, min = math.max, math.min

-- Which table is which object ---------------------------------------------------------------------

-- Returns the table of the game that holds the objects of a group in a state; nil: there is none.
local function ownerOf(world, group)
  return group.direct and world.objects or world.objects[group.name]
end

-- Returns the key of the m-th of these objects there.
local function keyOf(group, m)
  return group.direct and group.name or group.keys and group.keys[m] or m
end

-- Returns all objects that a state from elsewhere names, by number: those `named`, if the state has
-- names; those at the same places, unless they have a name; and new ones. Second: a sentence that
-- names the first group under numbers that has another count of objects here: then fields may land
-- on the wrong objects. (Of a group of loaded objects that says nothing.) Third: the new ones.
local function match(world, st, named)
  local objects, taken, new, n, sentence = {}, {}, {}, 0, nil
  for _, group in ipairs(st.groups) do
    local owner, count, keys = ownerOf(world, group), group.count, group.keys
    owner = type(owner) == "table" and not check.isObject(owner) and owner or NONE
    local here = not group.direct and not (keys and type(keys[count]) ~= "number") and #owner or 0
    if here > 0 and here ~= count and not sentence and not (named and recall.nameOf(owner[1])) then
      sentence = MISFIT:format(check.place(group.name), count, here)
    end
    for m = 1, count do
      n = n + 1
      local object = owner[keyOf(group, m)]
      local isFit = type(object) == "table" and (owner ~= world.objects or check.isObject(object))
      if named and (named[n] or isFit and recall.nameOf(object)) then
        object, isFit = named[n], named[n]
      end
      if not isFit or taken[object] then
        object = {}
        new[#new + 1] = object
      end
      objects[n], taken[object] = object, true
    end
  end
  return objects, sentence, new
end

-- The game's tables -------------------------------------------------------------------------------

local function clear(list)
  for key in next, list, nil do
    list[key] = nil
  end
end

-- Writes the settings. A table that says the same stays; another one is changed in place, since the
-- game may hold it.
local function writeSettings(world, given)
  for _, row in ipairs(fields.savedSettings) do
    local now, value = world[row.name], given[row.name]
    if not forms.isSame(now, value) then
      local into = type(value) == "table" and type(now) == "table" and now or nil
      clear(into or NONE)
      world[row.name] = forms.copy(value, into)
    end
  end
end

-- Takes over the place and velocity of an object that is known and can move, so that it need not be
-- read anew if it is only elsewhere. (Memory has the rest of it.)
local function readKnown(b, i, object)
  if i and b.kind[i] ~= STATIC and not object.static then
    local written, velocity, k = b.written, b.velocity, 2 * i
    written[k], written[k + 1] = object.x + 0.0, object.y + 0.0
    velocity[k], velocity[k + 1] = (object.vx or 0) + 0.0, (object.vy or 0) + 0.0
  end
end

-- Writes the fields. An object that had left the world gets those that it had then. Returns the
-- numbers of the objects that must be read: all but tiles that are in place.
local function writeFields(b, st, objects)
  local odd, list, others, own, at, m = {}, st.boxes, st.others, st.own, 1, 1
  for n = 1, st.count do
    local object, i, saved = objects[n], b.slotOf[objects[n]], st.fields[m]
    if others[m] == n then
      m = m + 1
    else
      local x, y, width, height = list[at], list[at + 1], list[at + 2], list[at + 3]
      object.x, object.y, object.width, object.height = x, y, width, height
      local isStill = i and format.isTile(b, i, object, own) and format.isInPlace(b, i, object)
      saved, at = nil, at + 4
      if not isStill then
        saved = { x = x, y = y, width = width, height = height, static = true }
      end
    end
    if saved then
      odd[#odd + 1] = n
      format.write(saved, object, own)
      readKnown(b, i, object)
    end
  end
  for n, saved in ipairs(st.gone) do
    objects[st.count + n] = objects[st.count + n] or {}
    format.write(saved, objects[st.count + n])
  end
  return odd
end

local function emptyGroups(world)
  for name, members in next, world.objects, nil do
    if type(members) ~= "table" or check.isObject(members) then
      world.objects[name] = nil
    else
      clear(members)
    end
  end
end

-- Puts the objects into the game's groups. Groups that are not in the state are emptied.
local function place(world, st, objects)
  local n = 0
  emptyGroups(world)
  for _, group in ipairs(st.groups) do
    world.objects[group.name] = not group.direct and (world.objects[group.name] or {}) or nil
    local owner = ownerOf(world, group)
    for m = 1, group.count do
      owner[keyOf(group, m)] = objects[n + m]
    end
    n = n + group.count
  end
end

-- Reading -----------------------------------------------------------------------------------------

-- Reads static objects again that have other fields now. (An object that a query has seen leave is
-- in no group until all are read.) Returns the slots of all.
local function readStatic(b, objects, odd)
  local slots = {}
  for m = 1, #odd do
    local object = objects[odd[m]]
    local i, isStatic = b.slotOf[object], object.static or false
    local wasStatic = i and b.kind[i] == STATIC
    local isOther = isStatic and wasStatic and readFields.firstOfStatic(b, i, object)
    if i and b.group[i] and (isOther or isStatic ~= wasStatic) then
      read.refresh(b, i)
    end
    slots[#slots + 1] = b.slotOf[object]
  end
  for n = 1, b.movedCount do -- those that only stand in another group now, too
    local i = b.movedList[n]
    slots[#slots + 1] = b.kind[i] ~= 0 and i or nil -- (it may have left the world since)
  end
  return slots
end

-- Memory ------------------------------------------------------------------------------------------

-- Forgets all events and all contacts, without events about it.
local function forget(b)
  for c = 1, #PAIRS do
    local column = b[PAIRS[c][1]]
    for p = 1, b.pairSlots do
      column[p] = PAIRS[c][2]
    end
  end
  b.contactCount = 0
end

local function restoreColumn(b, slots, list, objects, entry)
  local name, width, usual = entry[1], entry[2], entry[3]
  local column, kind, slotOf = b[name], b.kind, b.slotOf
  local model, y, hint, isOfMovers = b[usual], width - 1, entry.hint, layout.isOfMovers[name]
  local mayDiffer = not hint or b[hint]
  if hint then
    b[hint] = b[hint] or #list > 0
  end
  for m = 1, mayDiffer and #slots or 0 do
    local k = width * slots[m]
    if not isOfMovers or kind[slots[m]] ~= STATIC then
      column[k], column[k + y] = model and model[k] or usual, model and model[k + y] or usual
    end
  end
  for at = 1, #list, 1 + width do
    local slot, value, other = slotOf[objects[list[at]]], list[at + 1], list[at + 1 + y]
    if entry.isLink then
      value = slotOf[objects[value]]
      other = value
    end
    if not isOfMovers or kind[slot] ~= STATIC then
      column[width * slot], column[width * slot + y] = value, other
    end
  end
end

local function restoreMemory(b, slots, st, objects)
  for n = 1, #COLUMNS do
    restoreColumn(b, slots, st.memory[COLUMNS[n][1]], objects, COLUMNS[n])
  end
  for n = 1, #slots do
    local i = slots[n]
    islands.wake(b, i)
    boxes.stand(b, i)
    read.resetTouching(b, i) -- (its table may be that of another world now, or of several)
  end
  b.movedCount = #st.memory.moved * 0.5
  for n = 1, b.movedCount do
    b.movedList[n] = b.slotOf[objects[st.memory.moved[2 * n - 1]]]
  end
end

local function restoreContacts(b, slots, st, objects)
  local list, slotOf = st.contacts, b.slotOf
  pairFinder.run(b, slots, #slots)
  for at = 1, #list, 2 + #PAIRS do
    local one, other = objects[list[at]], objects[list[at + 1]]
    local p = links.pairOf(b, slotOf[one], slotOf[other])
      or links.link(b, slotOf[one], slotOf[other])
    local isSwapped = b.pairA[p] ~= slotOf[one]
    for c = 1, #PAIRS do
      b[PAIRS[c][1]][p] = format.turned(c, list[at + 1 + c], isSwapped)
    end
    b.contactCount = b.contactCount + min(b.contact[p], 1)
  end
end

local function restoreTouching(b, st, objects)
  for at = 1, #st.touching, 5 do
    local i = b.slotOf[objects[st.touching[at]]]
    local touching = b.kind[i] ~= STATIC and b.touching[i]
    for side = 1, touching and 4 or 0 do
      touching[constants.SIDES[side]] = objects[st.touching[at + side]] or false
    end
  end
end

local function restoreEvents(b, st, objects)
  local e, list, n = b.events, st.events, 0
  for at = 1, #list, #VALUES do
    n = n + 1
    e.order[n] = n
    for m = 1, #VALUES do
      local value = list[at + m - 1]
      if m <= events.OBJECTS then
        value = objects[value] or false
      end
      e[VALUES[m]][n] = value
    end
  end
  e.count, e.sorted, e.told, e.heardBy = n, n, st.heardBy and 1 or 0, st.heardBy or 3
end

--- Brings a world back to the moment at which `st` was saved. Returns the sentence of `match`, or
--- nil, and the objects that it had to make. Errors: a state that cannot be used; then
--- nothing has changed.
function restore.world(world, st)
  local b, layers, sentence, new = world._bodies, nil, nil, {}
  local objects = b.tablesOf and b.tablesOf[st]
  validate.state(st, objects)
  local isKnown = objects and #objects == st.count + #st.gone
  if type(world.objects) ~= "table" then
    world.objects = {}
  end
  if b.maps and (isKnown or st.loaded) then
    layers = recall.begin(world, st, isKnown and objects)
  end
  if not isKnown then
    objects, sentence, new = match(world, st, layers and recall.find(world, st, layers))
  end
  forget(b)
  writeSettings(world, st.settings)
  settings.apply(world)
  local odd = writeFields(b, st, objects)
  place(world, st, objects)
  readStatic(b, objects, odd)
  read.run(b, world.objects)
  local slots = readStatic(b, objects, odd)
  events.forget(b.events)
  restoreMemory(b, slots, st, objects)
  restoreContacts(b, slots, st, objects)
  restoreTouching(b, st, objects)
  restoreEvents(b, st, objects)
  world._saved = st.saved
  world.alpha = world.timestep and max(0, min(st.saved / world.timestep, 1)) or 0
  if b.zoneList[1] then
    zones.begin(b, b.movers, b.moverCount) -- where "down" is
    zones.run(b, b.movers, b.moverCount, 0) -- for `load`
  end
  world._shiftedX, world._shiftedY = st.shiftedX or 0, st.shiftedY or 0
  if layers then
    recall.finish(world, st, layers, objects)
  end
  b.isSeen = false
  return sentence, new
end

require(root .. ".memory.compiler").leave(clear, emptyGroups)

return restore
