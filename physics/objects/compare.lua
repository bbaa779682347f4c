--- Finds out what the game has written into objects that are not static.
--
-- Static objects are read once. Of the others those fields that all have are compared first, then
-- the rare ones of those objects that have any.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local columns = require(root .. ".memory.columns")
local interpreted = require(root .. ".memory.jit")
local readFields = require(root .. ".objects.readFields")
local registry = require(root .. ".objects.registry")
local rest = require(root .. ".sleep.islands")
local zones = require(root .. ".motion.zones")

local compare = {}

local HUGE = math.huge
local isFinite, orDefault, sideOf = check.isFinite, readFields.orDefault, columns.sideOf
local KINEMATIC, DYNAMIC = columns.KINEMATIC, columns.DYNAMIC

--- Checks an object again. Errors: a field that cannot be used. Only then the text of its place is
--- made: games write to objects all the time, and the text would be garbage.
function compare.check(b, i)
  local object = b.object[i]
  if check.badField(object) then
    check.object(object, registry.placeOf(b, i))
  end
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
      compare.check(b, i)
    end
    b.kept[k] = vx == velocity[k] and b.kept[k] or 0
    b.kept[k + 1] = vy == velocity[k + 1] and b.kept[k + 1] or 0
    velocity[k], velocity[k + 1] = vx + 0.0, vy + 0.0
    if not b.flying[i] then
      rest.wake(b, i)
    end
  end
end

local function compareMotion(b, reread)
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
  compare.check(b, i)
  b.hears[i], b.bare[i] = object.onStay or false, false
  readFields.noteEven(b, i)
  rest.wake(b, i)
end

-- Lists the objects that need more comparisons than the three fields that many objects have: those
-- with a rare field now or at the last reading. Testing a field for nil costs less than comparing
-- it. (A call costs more than either, without a compiler. So this is one long function.) Returns
-- how many they are.
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

local function compareFilters(b, count, reread)
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

local function compareMaterials(b, count, reread)
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

local function compareLimits(b, count, reread)
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

--- Compares all objects that are not static. Calls `reread(b, i)` for each one that must be read
--- anew; a velocity and an `onStay` are read here.
function compare.run(b, reread)
  compareMotion(b, reread)
  local count = listRich(b)
  compareFilters(b, count, reread)
  compareMaterials(b, count, reread)
  compareLimits(b, count, reread)
end

interpreted.functions(compare.run) -- leads from loop to loop

return compare
