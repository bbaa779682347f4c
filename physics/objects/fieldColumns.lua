--- Which column holds which field of an object. Reading, `save`, `restore` and the checks of static
--- objects go by these lists.
--
-- `EVERY` has the fields that each object has a value of, `SOME` all others that a state holds, in
-- the order in which it holds them.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local filter = require(root .. ".broadphase.filter")
local zones = require(root .. ".motion.zones")

local fieldColumns = {}

local HUGE = math.huge

--- Name, column, axis, and the column's value if the field is not set.
fieldColumns.EVERY = {
  { "x", "written", 0 },
  { "y", "written", 1 },
  { "width", "size", 0 },
  { "height", "size", 1 },
  { "vx", "velocity", 0, 0 },
  { "vy", "velocity", 1, 0 },
}

--- Name, column, the column's value if the field is not set, axis, and a function that returns what
--- the column holds of a value (nil: the value). Those without a column are read by functions of
--- their own.
fieldColumns.SOME = {
  { "static" },
  { "kinematic" },
  { "active", "active", true },
  { "sensor", "sensor", false },
  { "pushable", "pushable", true },
  { "strength", "strength", 0 },
  { "mass", "mass", 1 },
  { "gravity", "ownGravity", false },
  { "gravityX", "ownGravityX", false },
  { "friction" },
  { "restitution", "restitution", 0 },
  { "airFriction", "airFriction", 0 },
  { "drag", "drag", 0 },
  { "maxSpeed", "maxSpeed", HUGE },
  { "maxSpeedX", "limit", HUGE, 0 },
  { "maxSpeedY", "limit", HUGE, 1 },
  { "maxFallSpeed", "maxFallSpeed", HUGE },
  { "ax", "push", 0, 0 },
  { "ay", "push", 0, 1 },
  { "oneWay", "oneWay", false, nil, columns.sideOf },
  { "radius", "radius", false },
  { "carry", "carry", true },
  { "surfaceSpeed", "surfaceSpeed", 0 },
  { "nudge", "nudge", 0 },
  { "snap", "snap", 0 },
  { "slope", "slope", false },
  { "constantSpeed", "constantSpeed", false },
  { "mask" },
  { "area" },
  { "hits" },
}

--- The names of all these fields.
fieldColumns.NAMES = {}
for _, list in ipairs({ fieldColumns.EVERY, fieldColumns.SOME }) do
  for _, entry in ipairs(list) do
    fieldColumns.NAMES[#fieldColumns.NAMES + 1] = entry[1]
  end
end

-- Returns the first field of a list of which a static object has another value than was read. The
-- velocity of a static object is not read.
local function firstOther(b, i, object, list, isEvery)
  for n = 1, #list do
    local entry = list[n]
    local name, column = entry[1], entry[2]
    local absent, axis = entry[3], entry[4]
    if isEvery then
      absent, axis = nil, entry[3]
    end
    local value = object[name]
    if value == nil then
      value = absent
    elseif entry[5] then
      value = entry[5](value)
    end
    if column and column ~= "velocity" and value ~= b[column][axis and 2 * i + axis or i] then
      return name
    end
  end
end

--- Returns the first field of a static object that has another value than was read; nil: none. Of
--- functions nothing is said.
function fieldColumns.firstChanged(b, i, object)
  local name = firstOther(b, i, object, fieldColumns.EVERY, true)
    or firstOther(b, i, object, fieldColumns.SOME, false)
  if name then
    return name
  elseif (object.friction or -1) ~= b.friction[i] then
    return "friction"
  elseif not filter.isSameMask(object.mask, b.mask[i]) then
    return "mask"
  elseif not zones.isSame(object.area, b.area[i]) then
    return "area"
  elseif object.hits ~= (b.hitsGiven[i] or nil) then
    return "hits"
  end
end

return fieldColumns
