--- Reads the fields of an object into its columns. They must have been checked.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local fieldColumns = require(root .. ".objects.fieldColumns")
local filter = require(root .. ".broadphase.filter")
local zones = require(root .. ".motion.zones")

local readFields = {}

local HUGE, max, min = math.huge, math.max, math.min
local BOX, SLOPE = columns.SHAPE_BOX, columns.SHAPE_SLOPE_LEFT -- and above
local UNREAD = 0 / 0 -- NaN: no place is equal to it
local STATIC, KINEMATIC, DYNAMIC = columns.STATIC, columns.KINEMATIC, columns.DYNAMIC

local sideOf, shapeOf = columns.sideOf, columns.shapeOf

--- Returns a value, or the default if it is nil.
function readFields.orDefault(value, default)
  if value == nil then
    return default
  end
  return value
end

local orDefault = readFields.orDefault

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

--- Reads the gravity that acts on an object, and where its "down" is: along the stronger axis, y in
--- a tie.
function readFields.pull(b, i)
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
local OFTEN = { sensor = true, mass = true, restitution = true }

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
    b.only[i] = list and filter.readHits(b, list)
  end
end

local function readOthers(b, i, object)
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
  readHits(b, i, object.hits or false)
  b.oneWay[i] = sideOf(b.oneWay[i])
  b.shape[i] = b.radius[i] and columns.SHAPE_CIRCLE or isDynamic and BOX or shapeOf(b.slope[i])
  b.inverseMass[i] = isDynamic and 1 / b.mass[i] or 0
  b.friction[i] = orDefault(object.friction, isDynamic and 0 or -1)
  b.push[k], b.push[k + 1] = orDefault(ax, 0), orDefault(ay, 0)
  b.limit[k], b.limit[k + 1] = orDefault(topX, HUGE), orDefault(topY, HUGE)
  b.bare[i] = isDynamic and hasNoRare and not (ax or ay or topX or topY)
  local least = min(b.limit[k], b.limit[k + 1], b.maxFallSpeed[i])
  b.isFree[i] = b.airFriction[i] == 0 and least == HUGE
  readFields.pull(b, i)
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

--- Notes whether its position alone decides if a contact of the object goes on.
function readFields.noteEven(b, i)
  b.even[i] = not (b.sensor[i] or b.hears[i] or b.oneWay[i]) and b.shape[i] == BOX
end

-- Notes how steep a slope is.
local function noteSlope(b, i)
  local width, height = b.size[2 * i], b.size[2 * i + 1]
  b.hasSlopes = true
  b.steep[0], b.steep[1] = max(b.steep[0], width / height), max(b.steep[1], height / width)
end

--- Reads all fields. If reading fails (the game's `__index` may raise an error), the next step
--- reads all of them again.
function readFields.all(b, i, object, isNew)
  b.written[2 * i] = UNREAD
  b.reserve[2 * i], b.reserve[2 * i + 1] = 0, 0
  readOthers(b, i, object)
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
  readFields.noteEven(b, i)
end

return readFields
