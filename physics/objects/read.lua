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
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local detect = require(root .. ".broadphase.pairFinder")
local events = require(root .. ".contacts.events")
local fieldColumns = require(root .. ".objects.fieldColumns")
local filter = require(root .. ".broadphase.filter")
local interpreted = require(root .. ".memory.jit")
local notice = require(root .. ".queries.notice")
local rest = require(root .. ".sleep.islands")
local registry = require(root .. ".objects.registry")
local zones = require(root .. ".motion.zones")

local read = {}

local HUGE, max, min = math.huge, math.max, math.min
local BOX, SLOPE = columns.SHAPE_BOX, columns.SHAPE_SLOPE_LEFT -- and above
local UNREAD = 0 / 0 -- NaN: no place is equal to it
local isFinite = check.isFinite
local STATIC, KINEMATIC, DYNAMIC = columns.STATIC, columns.KINEMATIC, columns.DYNAMIC

local sideOf, shapeOf = columns.sideOf, columns.shapeOf

local function orDefault(value, default)
  if value == nil then
    return default
  end
  return value
end

-- Notes which groups a mask refuses, by their numbers, to notice changes inside the same table. The
-- mask of a static object is copied.
local function readMask(b, i, mask)
  if b.kind[i] == STATIC then
    b.mask[i] = filter.copyMask(b, mask)
    return
  end
  local groups, seen = b.registry.groups, {}
  for n = 1, #groups do
    seen[groups[n].number] = mask[groups[n].name] == false or nil
  end
  b.maskSeen[i] = seen
end

-- Returns whether a mask says something else of a group than before. A change about a group that
-- was empty, or absent, is only noted: nothing has met an object of it, and a restored world does
-- not know it either.
local function hasMaskChanged(b, mask, seen)
  local groups, changed = b.registry.groups, false
  for n = 1, #groups do
    local group = groups[n]
    local refuses = mask[group.name] == false
    if refuses ~= (seen[group.number] or false) then
      seen[group.number], changed = refuses or nil, changed or group.wasFilled
    end
  end
  return changed
end

-- Notes which groups have objects, for the next comparison of masks.
local function noteFilled(groups)
  for n = 1, #groups do
    groups[n].wasFilled = groups[n].count > 0
  end
end

-- Reads the gravity that acts on an object, and where its "down" is: along the stronger axis, y in
-- a tie.
local function readPull(b, i)
  local k = 2 * i
  local gx, gy = b.ownGravityX[i], b.ownGravity[i]
  if gx == false then
    gx = b.gravityX
  end
  if gy == false then
    gy = b.gravity
  end
  if b.kind[i] ~= DYNAMIC then
    gx, gy = 0, 0
  end
  gx, gy = gx + 0.0, gy + 0.0 -- floats: squares of integers would wrap
  b.pull[k], b.pull[k + 1] = gx, gy
  zones.setDown(b, i, gx, gy)
end

-- Fields that are copied as they are: name, column, default. (`listRich` tests the same fields, and
-- those few that are not copied as they are.)
local RARE = {
  { "canCollide", "canCollide", false },
  { "onStay", "hears", false },
  { "mask", "mask", false },
  { "area", "area", false },
  { "hits", "only", false },
}
for _, entry in ipairs(fieldColumns.SOME) do
  if entry[2] and not entry[4] then
    RARE[#RARE + 1] = entry
  end
end
local NAMES, COLUMNS, DEFAULTS = {}, {}, {}
for n, field in ipairs(RARE) do
  NAMES[n], COLUMNS[n], DEFAULTS[n] = field[1], field[2], field[3]
end

-- Those that are compared for all: many objects have them.
local OFTEN = { sensor = true, hits = true, mass = true, restitution = true }

-- Reads them in a loop: written out, they become much machine code at every place that reads
-- objects. Returns whether the object has none of them.
local function readRare(b, i, object)
  local isBareSoFar = true
  for n = 1, #NAMES do
    local value = object[NAMES[n]]
    if value == nil then
      value = DEFAULTS[n]
    else
      isBareSoFar = isBareSoFar and OFTEN[NAMES[n]] ~= nil
    end
    b[COLUMNS[n]][i] = value
  end
  return isBareSoFar
end

-- Reads the list of groups that an object hits, if it is another one.
local function readHits(b, i, list)
  if list ~= b.hitsGiven[i] then
    b.hitsGiven[i] = list
    b.hitsRead[i] = list and filter.readHits(b, list)
  end
  b.only[i] = b.hitsRead[i]
end

local function readFields(b, i, object)
  local k, isDynamic = 2 * i, b.kind[i] == DYNAMIC
  local hasNoRare = readRare(b, i, object)
  local ax, ay, topX, topY = object.ax, object.ay, object.maxSpeedX, object.maxSpeedY
  if b.mask[i] then
    readMask(b, i, b.mask[i])
  end
  if b.area[i] then
    b.area[i] = zones.copy(b.area[i])
    zones.note(b, i)
  end
  readHits(b, i, b.only[i])
  b.oneWay[i] = sideOf(b.oneWay[i])
  b.shape[i] = b.radius[i] and columns.SHAPE_CIRCLE or isDynamic and BOX or shapeOf(b.slope[i])
  b.inverseMass[i] = isDynamic and 1 / b.mass[i] or 0
  b.friction[i] = orDefault(object.friction, isDynamic and 0 or -1)
  b.push[k], b.push[k + 1] = orDefault(ax, 0), orDefault(ay, 0)
  b.limit[k], b.limit[k + 1] = orDefault(topX, HUGE), orDefault(topY, HUGE)
  b.bare[i] = isDynamic and hasNoRare and not (ax or ay or topX or topY)
  local least = min(b.limit[k], b.limit[k + 1], b.maxFallSpeed[i])
  b.isFree[i] = b.airFriction[i] == 0 and least == HUGE
  readPull(b, i)
end

-- Keeps the place and size of an object before the game made it larger, until the next step.
local function noteGrowth(b, i)
  for k = 2 * i, 2 * i + 1 do
    b.wasAt[k], b.wasSize[k] = b.position[k], b.size[k]
  end
  b.grown[i] = true
end

local function readMotion(b, i, object, isNew)
  local k = 2 * i
  local isLarger = object.width > b.size[k] or object.height > b.size[k + 1]
  if isLarger and not (isNew or b.grown[i]) and b.kind[i] == DYNAMIC then
    noteGrowth(b, i)
  end
  -- Adding 0.0 makes floats of the integers of Lua 5.3 and later, which would wrap.
  local x, y = object.x + 0.0, object.y + 0.0
  b.size[k], b.size[k + 1] = object.width + 0.0, object.height + 0.0
  b.velocity[k], b.velocity[k + 1] = orDefault(object.vx, 0) + 0.0, orDefault(object.vy, 0) + 0.0
  b.written[k], b.written[k + 1] = x, y
  if isNew then
    b.behind[k], b.behind[k + 1] = 0, 0
  end
  if isNew or b.kind[i] ~= KINEMATIC then
    b.position[k], b.position[k + 1] = x, y
    b.last[k], b.last[k + 1] = x, y
  end
  if b.kind[i] == STATIC then
    b.velocity[k], b.velocity[k + 1] = 0, 0
  end
end

-- Notes whether its position alone decides if a contact of the object goes on.
local function noteEven(b, i)
  b.even[i] = not (b.sensor[i] or b.hears[i] or b.oneWay[i]) and b.shape[i] == BOX
end

-- Notes how steep a slope is.
local function noteSlope(b, i)
  local width, height = b.size[2 * i], b.size[2 * i + 1]
  b.hasSlopes = true
  b.steep[0], b.steep[1] = max(b.steep[0], width / height), max(b.steep[1], height / width)
end

-- Reads all fields, which must have been checked. If reading still fails (the game's `__index` may
-- raise an error), the next step reads all of them again.
local function readAll(b, i, object, isNew)
  b.written[2 * i] = UNREAD
  b.reserve[2 * i], b.reserve[2 * i + 1] = 0, 0
  readFields(b, i, object)
  readMotion(b, i, object, isNew)
  b.hasCarriers = b.hasCarriers or b.kind[i] == KINEMATIC or b.surfaceSpeed[i] ~= 0
  b.hasFriction = b.hasFriction or b.friction[i] > 0
  b.hasNudges = b.hasNudges or b.nudge[i] ~= 0
  b.hasSnaps = b.hasSnaps or b.snap[i] ~= 0
  b.hasHinders = b.hasHinders or b.drag[i] ~= 0 or b.maxSpeed[i] ~= HUGE
  b.hasLimits = b.hasLimits or not b.isFree[i] or b.maxSpeed[i] < HUGE
  b.hasBounces = b.hasBounces or b.restitution[i] ~= 0
  b.hasAskers = b.hasAskers or b.canCollide[i] ~= false
  b.hasOneWays = b.hasOneWays or b.oneWay[i] ~= false
  b.hasSensors = b.hasSensors or b.sensor[i]
  b.hasCircles = b.hasCircles or b.shape[i] == columns.SHAPE_CIRCLE
  b.hasFirm = b.hasFirm or not b.pushable[i]
  if b.shape[i] >= SLOPE then
    noteSlope(b, i)
  end
  b.power[i] = b.pushable[i] and b.strength[i] or HUGE
  b.plain[i] = not b.sensor[i] and b.shape[i] == BOX
  noteEven(b, i)
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
  readAll(b, i, object, true)
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

-- Checks an object again. Errors: a field that cannot be used. Only then the text of its place is
-- made: games write to objects all the time, and the text would be garbage.
local function checkAgain(b, i)
  local object = b.object[i]
  if check.badField(object) then
    check.object(object, registry.place(b.group[i], b.key[i]))
  end
end

-- Checks and reads an object anew after some of its fields changed.
local function reread(b, i)
  local object = b.object[i]
  checkAgain(b, i)
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
  readAll(b, i, object, isNew or isOff or not b.active[i])
  if not b.active[i] then
    clearTouching(b.touching[i])
  end
  events.endForbidden(b, i)
  detect.refilter(b, i)
  detect.markMoved(b, i)
  rest.wake(b, i)
end

-- The loops below compare the game's tables with the columns, a few fields each: a long loop body
-- with many live values compiles badly. `false` in a column means nil in the table (a `false` there
-- is refused).

-- Reads a velocity that the game has written, or removed.
local function readVelocity(b, i, object)
  local velocity, k, vx, vy = b.velocity, 2 * i, object.vx, object.vy
  if vx == nil or vy == nil then
    vx, vy = orDefault(vx, 0), orDefault(vy, 0)
    if b.kind[i] == DYNAMIC then
      rest.wake(b, i) -- `write` sets both fields to numbers
    end
  end
  if vx ~= velocity[k] or vy ~= velocity[k + 1] then
    if not (isFinite(vx) and isFinite(vy)) then
      checkAgain(b, i)
    end
    b.kept[k] = vx == velocity[k] and b.kept[k] or 0
    b.kept[k + 1] = vy == velocity[k + 1] and b.kept[k + 1] or 0
    velocity[k], velocity[k + 1] = vx + 0.0, vy + 0.0
    if not b.flying[i] then
      rest.wake(b, i)
    end
  end
end

local function compareMotion(b)
  local movers, objects = b.movers, b.object
  local velocity, size, written = b.velocity, b.size, b.written
  for n = 1, b.moverCount do
    local i = movers[n]
    local object, k = objects[i], 2 * i
    if
      object.x ~= written[k]
      or object.y ~= written[k + 1]
      or object.width ~= size[k]
      or object.height ~= size[k + 1]
    then
      reread(b, i)
    end
    if object.vx ~= velocity[k] or object.vy ~= velocity[k + 1] then
      readVelocity(b, i, object)
    end
  end
end

-- Reads a new onStay. The object wakes; nothing else has happened to it.
local function hear(b, i)
  local object = b.object[i]
  checkAgain(b, i)
  b.hears[i], b.bare[i] = object.onStay or false, false
  noteEven(b, i)
  rest.wake(b, i)
end

-- Lists the objects that need more comparisons than the three fields that many objects have: those
-- with a rare field now or at the last reading. Testing a field for nil costs less than comparing
-- it. (A call costs more than either, without a compiler.) Returns how many they are.
local function listRich(b)
  local movers, objects, bare, rich, count = b.movers, b.object, b.bare, b.rich, 0
  local mass, friction, restitution = b.mass, b.friction, b.restitution
  local sensor, hits = b.sensor, b.hitsGiven
  for n = 1, b.moverCount do
    local i = movers[n]
    local object = objects[i]
    local itsMass, itsFriction, itsRestitution = object.mass, object.friction, object.restitution
    if
      not bare[i] -- not dynamic, or had a rare field
      or object.active ~= nil
      or object.kinematic ~= nil
      or (object.sensor or false) ~= sensor[i]
      or object.hits ~= (hits[i] or nil)
      or object.pushable ~= nil
      or object.strength ~= nil
      or object.oneWay ~= nil
      or object.radius ~= nil
      or object.area ~= nil
      or object.mask ~= nil
      or object.canCollide ~= nil
      or object.onStay ~= nil
      or object.gravity ~= nil
      or object.gravityX ~= nil
      or object.ax ~= nil
      or object.ay ~= nil
      or object.airFriction ~= nil
      or object.drag ~= nil
      or object.maxSpeed ~= nil
      or object.maxSpeedX ~= nil
      or object.maxSpeedY ~= nil
      or object.carry ~= nil
      or object.surfaceSpeed ~= nil
      or object.nudge ~= nil
      or object.snap ~= nil
      or object.maxFallSpeed ~= nil
      or object.slope ~= nil
      or object.constantSpeed ~= nil
      or (itsMass or 1) ~= mass[i]
      or (itsFriction or 0) ~= friction[i]
      or (itsRestitution or 0) ~= restitution[i]
      or itsMass == false -- is refused
      or itsFriction == false
      or itsRestitution == false
    then
      count = count + 1
      rich[count] = i
    end
  end
  return count
end

local function compareFilters(b, count)
  local rich, objects = b.rich, b.object
  local active, sensor, pushable, kind = b.active, b.sensor, b.pushable, b.kind
  local hears, oneWay, canCollide, mask, seen = b.hears, b.oneWay, b.canCollide, b.mask, b.maskSeen
  local slope = b.slope
  local hits = b.hitsGiven
  for n = 1, count do
    local i = rich[n]
    local object = objects[i]
    local its = object.mask
    if
      orDefault(object.active, true) ~= active[i]
      or (object.sensor or false) ~= sensor[i]
      or orDefault(object.pushable, true) ~= pushable[i]
      or sideOf(object.oneWay) ~= oneWay[i]
      or object.slope ~= (slope[i] or nil)
      or object.canCollide ~= (canCollide[i] or nil)
      or (object.kinematic or false) ~= (kind[i] == KINEMATIC)
      or its ~= (mask[i] or nil)
      or object.hits ~= (hits[i] or nil)
      or (its and hasMaskChanged(b, its, seen[i]))
    then
      reread(b, i)
    elseif object.onStay ~= (hears[i] or nil) then
      hear(b, i)
    end
  end
end

local function compareMaterials(b, count)
  local rich, objects = b.rich, b.object
  local mass, friction, restitution = b.mass, b.friction, b.restitution
  local ownGravity, ownGravityX, push, kind = b.ownGravity, b.ownGravityX, b.push, b.kind
  for n = 1, count do
    local i = rich[n]
    local object = objects[i]
    if
      orDefault(object.mass, 1) ~= mass[i]
      or orDefault(object.friction, kind[i] == DYNAMIC and 0 or -1) ~= friction[i]
      or object.friction == -1 -- in the columns that is "not set", from the game it is refused
      or orDefault(object.restitution, 0) ~= restitution[i]
      or object.gravity ~= (ownGravity[i] or nil)
      or object.gravityX ~= (ownGravityX[i] or nil)
      or orDefault(object.ax, 0) ~= push[2 * i]
      or orDefault(object.ay, 0) ~= push[2 * i + 1]
    then
      reread(b, i)
    end
  end
end

local function compareLimits(b, count)
  local rich, objects = b.rich, b.object
  local airFriction, drag, maxSpeed, limit = b.airFriction, b.drag, b.maxSpeed, b.limit
  local carry, surfaceSpeed, nudge, snap = b.carry, b.surfaceSpeed, b.nudge, b.snap
  local constantSpeed, radius, area = b.constantSpeed, b.radius, b.area
  local strength = b.strength
  for n = 1, count do
    local i = rich[n]
    local object = objects[i]
    local top, topX, topY = object.maxSpeed, object.maxSpeedX, object.maxSpeedY
    local fall = object.maxFallSpeed
    if
      orDefault(object.airFriction, 0) ~= airFriction[i]
      or orDefault(object.drag, 0) ~= drag[i]
      or orDefault(top, HUGE) ~= maxSpeed[i]
      or orDefault(topX, HUGE) ~= limit[2 * i]
      or orDefault(topY, HUGE) ~= limit[2 * i + 1]
      or top == HUGE -- in the columns that is "no limit", from the game it is refused
      or topX == HUGE
      or topY == HUGE
      or orDefault(fall, HUGE) ~= b.maxFallSpeed[i]
      or fall == HUGE
      or orDefault(object.carry, true) ~= carry[i]
      or orDefault(object.surfaceSpeed, 0) ~= surfaceSpeed[i]
      or orDefault(object.nudge, 0) ~= nudge[i]
      or orDefault(object.strength, 0) ~= strength[i]
      or orDefault(object.snap, 0) ~= snap[i]
      or (object.constantSpeed or false) ~= constantSpeed[i]
      or object.radius ~= (radius[i] or nil)
      or ((object.area ~= nil or area[i]) and not zones.isSame(object.area, area[i]))
    then
      reread(b, i)
    end
  end
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
  checkAgain(b, i)
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
  readAll(b, i, object, true)
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
  compareMotion(b)
  local count = listRich(b)
  compareFilters(b, count)
  compareMaterials(b, count)
  compareLimits(b, count)
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
      readPull(b, i)
    end
  end
  rest.wakeAll(b)
end

interpreted.functions(endLeft, read.run) -- calls what is interpreted; leads from loop to loop

return read
