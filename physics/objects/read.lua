--- Reads the game's tables into columns: finds new and removed objects, checks fields, notes
--- changes.
--
-- Writes the columns of the fields (position, velocity, size, ...), and `moved` of objects if the
-- game has changed their place, size or filter. Wakes every object that was written to. A static
-- object is read once. Reading writes nothing into the game's tables, so a refusal leaves them as
-- they were. Only `giveTouching`, which is called when all has been read, gives objects their
-- `touching`.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local carrier = require(root .. ".objects.carriers")
local compare = require(root .. ".objects.compare")
local columns = require(root .. ".memory.columns")
local detect = require(root .. ".broadphase.pairFinder")
local events = require(root .. ".contacts.events")
local interpreted = require(root .. ".memory.jit")
local notice = require(root .. ".queries.notice")
local readFields = require(root .. ".objects.readFields")
local rest = require(root .. ".sleep.islands")
local registry = require(root .. ".objects.registry")

local read = {}

local STATIC, DYNAMIC = columns.STATIC, columns.DYNAMIC

-- Notes which groups have objects, for the next comparison of masks.
local function noteFilled(groups)
  for n = 1, #groups do
    groups[n].wasFilled = groups[n].count > 0
  end
end

--- Returns the table that will be `touching` of an object. An object that returns to this world
--- gets its old one. `write` puts it into the object.
function read.touchingFor(b, object)
  local r = b.registry
  return r.given[object]
    or r.left[object]
    or r.leftBefore[object]
    or { top = false, bottom = false, left = false, right = false }
end

--- Gives a slot the table that will be `touching` of its object; false: it has none.
function read.takeTouching(b, i, touching)
  b.touching[i], b.touchTold[4 * i + 1] = touching, columns.UNTOLD
end

local takeTouching = read.takeTouching

-- Notes that an object has come, goes, or is read again, if it is static: what was noted of all
-- static ones (see physics/state/save.lua) is out of date.
local function noteStatic(b, i)
  if b.kind[i] == STATIC then
    b.staticVersion = b.staticVersion + 1
  end
end

local function enter(b, object, record, key)
  local i = columns.claim(b)
  b.slotOf[object] = i
  b.object[i], b.group[i], b.groupName[i], b.key[i] = object, record, record.name, key
  b.kind[i] = columns.kindOf(object)
  noteStatic(b, i)
  readFields.all(b, i, object, true)
  columns.stand(b, i)
  b.fresh[i] = true
  b.quiet[i] = false
  if b.kind[i] == DYNAMIC then
    takeTouching(b, i, read.touchingFor(b, object))
  end
  detect.markMoved(b, i)
  rest.wake(b, i)
  notice.refresh(b, object)
  b.newcomers = true
  return i
end

--- Clears all sides: the object leaves, is switched off or is not dynamic any more.
function read.clearTouching(touching)
  if touching then
    touching.top, touching.bottom, touching.left, touching.right = false, false, false, false
  end
end

local clearTouching = read.clearTouching

-- Clears and remembers the table of an object that is not dynamic any more, or not in the world.
local function giveUpTouching(b, i)
  local touching = b.touching[i]
  if touching then
    clearTouching(touching)
    registry.noteLeft(b.registry, b.object[i], touching)
    takeTouching(b, i, false)
  end
end

local function leave(b, i)
  local object = b.object[i]
  noteStatic(b, i)
  carrier.forget(b, i)
  rest.wakeNeighbours(b, i)
  events.endContacts(b, i)
  detect.remove(b, i)
  rest.drop(b, i)
  giveUpTouching(b, i)
  b.slotOf[object] = nil
  columns.release(b, i)
  b.newcomers = true
end

local function rename(b, i, record)
  b.group[i], b.groupName[i] = record, record.name
end

-- Notes a change of the order. Of two equally good supports the first in order is touched. In
-- another group the object may meet other objects.
local function reorder(b, i, isRenamed)
  rest.wakeNeighbours(b, i)
  if isRenamed then
    events.endForbidden(b, i)
    detect.refilter(b, i)
    detect.markMoved(b, i)
  end
  rest.wake(b, i)
end

-- Lists the slots of a group that are not static, in order.
local function listGroup(b, record)
  local movers, places, slots, kind = record.movers, record.moverPlaces, record.slots, b.kind
  local first, n = record.newFrom, #movers
  while n > 0 and places[n] >= record.sameUntil do
    movers[n] = nil
    first, n = record.sameUntil, n - 1
  end
  for m = first, record.count do
    local i = slots[m]
    if kind[i] > STATIC then
      n = n + 1
      movers[n], places[n] = i, m
    end
  end
  record.isListed = true
end

-- Lists the slots that are not static, in the order of the world.
local function listMovers(b)
  local n, movers, groups = 0, b.movers, b.registry.groups
  for g = 1, #groups do
    local record = groups[g]
    if not record.isListed then
      listGroup(b, record)
    end
    local its = record.movers
    for m = 1, #its do
      n = n + 1
      movers[n] = its[m]
    end
  end
  b.moverCount = n
  b.awakenings = b.awakenings + 1
end

-- Clears what steps have left in an object that has changed its kind.
local function forgetMotion(b, i)
  columns.forgetStep(b, i)
  carrier.leave(b, i)
  if b.kind[i] == STATIC then
    rest.drop(b, i)
  end
end

-- Checks and reads an object anew after some of its fields changed.
local function reread(b, i)
  local object = b.object[i]
  compare.check(b, i)
  local kind = columns.kindOf(object, b.kind[i] == STATIC)
  local isNew = kind ~= b.kind[i]
  local isOff = object.active == false
  if isNew or isOff or (b.carry[i] and object.carry == false) then
    carrier.forget(b, i)
  end
  if isNew then
    noteStatic(b, i)
    b.kind[i] = kind
    noteStatic(b, i)
    giveUpTouching(b, i)
    if kind == DYNAMIC then
      takeTouching(b, i, read.touchingFor(b, object))
    end
    forgetMotion(b, i)
  end
  rest.wakeNeighbours(b, i)
  -- One that takes no part goes nowhere: it is where it was put meanwhile.
  readFields.all(b, i, object, isNew or isOff or not b.active[i])
  if not b.active[i] then
    clearTouching(b.touching[i])
  end
  events.endForbidden(b, i)
  detect.refilter(b, i)
  detect.markMoved(b, i)
  rest.wake(b, i)
end

-- Ends the contacts that objects have left because the game has moved them.
local function endLeft(b)
  for n = 1, b.movedCount do
    local i = b.movedList[n]
    if b.kind[i] ~= 0 then -- it may have left the world since
      events.endLeft(b, i)
    end
  end
end

--- Writes `touching` into objects that are new or were moved by the game.
function read.giveTouching(b)
  for n = 1, b.movedCount do
    local i = b.movedList[n]
    local object, touching = b.object[i], b.touching[i]
    if object and touching then
      object.touching = touching -- without comparing it with what stands there, as in write.lua
    end
  end
end

-- Returns whether an object can go on carrying what stands on it, after it is read anew.
local function goesOnCarrying(b, i)
  local object, size, k = b.object[i], b.size, 2 * i
  return columns.kindOf(object) == b.kind[i]
    and object.active ~= false
    and object.carry ~= false
    and object.width == size[k]
    and object.height == size[k + 1]
end

-- Notes that an object is being read anew. If that fails (the game's `__index` may raise an error),
-- the next step reads it again. Otherwise fields that are read once would stay half read.
local function begin(b, object)
  local list = b.halfRead
  if not rawequal(list[#list], object) then
    list[#list + 1] = object
  end
end

local function finish(b)
  b.halfRead[#b.halfRead] = nil
end

--- Reads an object again, including its `static` field. It must be in the world.
function read.refresh(b, i)
  local object = b.object[i]
  compare.check(b, i)
  begin(b, object)
  rest.wakeNeighbours(b, i)
  if not goesOnCarrying(b, i) then
    carrier.forget(b, i)
  end
  local x, y = b.position[2 * i], b.position[2 * i + 1]
  noteStatic(b, i)
  b.kind[i] = columns.kindOf(object)
  noteStatic(b, i)
  if b.kind[i] ~= DYNAMIC then
    forgetMotion(b, i)
    giveUpTouching(b, i)
  elseif not b.touching[i] then
    takeTouching(b, i, read.touchingFor(b, object))
  end
  readFields.all(b, i, object, true)
  if not b.active[i] then
    clearTouching(b.touching[i])
  end
  if x ~= b.position[2 * i] or y ~= b.position[2 * i + 1] then
    carrier.noteJump(b, i)
  end
  columns.stand(b, i)
  events.endForbidden(b, i)
  detect.refilter(b, i)
  detect.markMoved(b, i)
  rest.wake(b, i)
  notice.refresh(b, object)
  registry.reread(b.group[i])
  b.newcomers = true
  finish(b)
end

-- Reads the objects again that could not be read, if they are still in the world.
local function refreshHalfRead(b)
  local list = b.halfRead
  while #list > 0 do
    local slot = b.slotOf[list[#list]]
    if slot then
      read.refresh(b, slot)
    else
      finish(b)
    end
  end
end

--- Reads a world's tables; `objects` is the game's table of groups. Errors: a group, key or field
--- that cannot be used; an object in two places. Then nothing has changed for the game, and the
--- next call starts anew.
function read.run(b, objects)
  local hasChanged = registry.update(b, b.registry, objects, enter, leave, rename, reorder)
  refreshHalfRead(b)
  if hasChanged or b.newcomers then
    listMovers(b)
    b.newcomers = false
  end
  compare.run(b, reread)
  if hasChanged then
    noteFilled(b.registry.groups)
  end
  endLeft(b)
  -- Contacts that have ended by now were between objects that had other ranks.
  if b.events.count > b.events.sorted then
    events.arrange(b.events)
  end
end

--- Reads a changed gravity of the world into all objects, and wakes them.
function read.newGravity(b)
  for i = 1, b.slots do
    if b.kind[i] == DYNAMIC then
      readFields.pull(b, i)
    end
  end
  rest.wakeAll(b)
end

interpreted.functions(endLeft, read.run) -- calls what is interpreted; leads from loop to loop

return read
