--- Every object field and every setting, once. (Settings are in settingFields.lua, entries of areas
--- in areaFields.lua.) Checks, documentation and editor types are made from these lists; a field
--- that is not here does not exist.
---
--- An entry has `name`, `type` and `meaning` (one sentence), and where they apply:
---   default   the value that `nil` stands for; `absent` says it in words where it is no constant
---   unit      "px", "px/s", "px/s²", "1/s", "s"
---   min, above, max   range of a number: >= min, > above, <= max
---   values    the strings that are allowed
---   yes       the one of them that `true` stands for; `false` stands for none
---   required  true: has no default
---   written   true: the library writes it; what the game put there is not read
---   signature parameters of a function
---   infinite  what the message for an infinite number advises
---   misnamed  another library's name for the field: the message for nil says if the object has it
---
--- Types: "number" (finite), "boolean", "string" (one of `values`), "function",
---   "mask" (group name -> boolean), "masks" (group name -> mask), "soft" (group name -> group name
---   -> number in 0..10^6), "names" (list of group names), "ownFields" (list of names of fields of
---   the game), "sides" (side -> object or false),
---   "area" (name -> value, see `fields.area`).

---@class physics.Field
---@field name string
---@field type string
---@field meaning string
---@field default any
---@field absent string?
---@field unit string?
---@field min number?
---@field above number?
---@field max number?
---@field values string[]?
---@field yes string?
---@field required boolean?
---@field written boolean?
---@field signature string?
---@field infinite string?
---@field misnamed string?

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")

local SIDES = { "top", "bottom", "left", "right" }

local fields = {}

---@type physics.Field[]
fields.objects = {
  {
    name = "x",
    type = "number",
    required = true,
    unit = "px",
    meaning = "The left edge.",
  },
  {
    name = "y",
    type = "number",
    required = true,
    unit = "px",
    meaning = "The top edge; y grows downwards.",
  },
  {
    name = "width",
    type = "number",
    required = true,
    unit = "px",
    above = 0,
    misnamed = "w",
    meaning = "The size along x. It may change at run time.",
  },
  {
    name = "height",
    type = "number",
    required = true,
    unit = "px",
    above = 0,
    misnamed = "h",
    meaning = "The size along y. It may change at run time.",
  },
  {
    name = "radius",
    type = "number",
    absent = "none: a box",
    unit = "px",
    above = 0,
    meaning = "A circle in its square: `x, y` is the corner of the square, `width` and `height` are"
      .. " 2 * radius. `add` writes both if they are nil.",
  },
  {
    name = "vx",
    type = "number",
    default = 0,
    unit = "px/s",
    meaning = "The velocity along x. For a rider it is relative to what carries it.",
  },
  {
    name = "vy",
    type = "number",
    default = 0,
    unit = "px/s",
    meaning = "The velocity along y, downwards. For a rider it is relative to what carries it.",
  },
  {
    name = "ax",
    type = "number",
    default = 0,
    unit = "px/s²",
    meaning = "A constant acceleration along x: an engine, wind, a magnet.",
  },
  {
    name = "ay",
    type = "number",
    default = 0,
    unit = "px/s²",
    meaning = "A constant acceleration along y, on top of gravity.",
  },
  {
    name = "static",
    type = "boolean",
    default = false,
    meaning = "It never moves. A static object is read once, when it is first seen; `refresh`"
      .. " reads it again.",
  },
  {
    name = "kinematic",
    type = "boolean",
    default = false,
    meaning = "It moves by its own velocity, or by the game writing `x, y`. It pushes, is never"
      .. " pushed and feels no gravity.",
  },
  {
    name = "active",
    type = "boolean",
    default = true,
    meaning = "`false` takes it out: no motion, no contacts, no queries.",
  },
  {
    name = "sensor",
    type = "boolean",
    default = false,
    meaning = "It reports contacts, but nothing bumps into it.",
  },
  {
    name = "area",
    type = "area",
    absent = "none",
    meaning = "Only of a sensor, which is a zone then: what acts on the dynamic objects inside it."
      .. " Water, wind, low gravity, a magnet.",
  },
  {
    name = "pushable",
    type = "boolean",
    default = true,
    meaning = "`false`: other objects cannot push it, but it pushes them. Walls still stop it.",
  },
  {
    name = "strength",
    type = "number",
    default = 0,
    meaning = "Of two objects the one with the larger strength is not moved by the other, and"
      .. " pushes it as if that had a fifth of its mass.",
  },
  {
    name = "mass",
    type = "number",
    default = 1,
    above = 0,
    infinite = "pushable = false: never pushed",
    meaning = "The weight in pushes and in the exchange of momentum. Only ratios matter.",
  },
  {
    name = "gravity",
    type = "number",
    absent = "the world's",
    unit = "px/s²",
    meaning = "Replaces the world's downward gravity for this object. An object with 0 floats.",
  },
  {
    name = "gravityX",
    type = "number",
    absent = "the world's",
    unit = "px/s²",
    meaning = "Replaces the world's sideways gravity for this object.",
  },
  {
    name = "friction",
    type = "number",
    default = 0,
    absent = "0; static and kinematic: the other object's",
    min = 0,
    meaning = "The Coulomb coefficient. A pair uses the square root of the product.",
  },
  {
    name = "restitution",
    type = "number",
    default = 0,
    min = 0,
    max = 1,
    meaning = "The bounciness: 0 none, 1 all of it. A pair uses the larger one.",
  },
  {
    name = "airFriction",
    type = "number",
    default = 0,
    unit = "1/s",
    min = 0,
    meaning = "Damping: the speed falls as e^(-k t), the same at any frame rate.",
  },
  {
    name = "drag",
    type = "number",
    default = 0,
    unit = "px/s²",
    min = 0,
    meaning = "A constant deceleration towards 0, as on a floor seen from above.",
  },
  {
    name = "maxSpeed",
    type = "number",
    absent = "none",
    unit = "px/s",
    min = 0,
    meaning = "The limit of the speed, that is of the length of the velocity.",
  },
  {
    name = "maxSpeedX",
    type = "number",
    absent = "none",
    unit = "px/s",
    min = 0,
    meaning = "The limit of the speed along x, in both directions.",
  },
  {
    name = "maxSpeedY",
    type = "number",
    absent = "none",
    unit = "px/s",
    min = 0,
    meaning = "The limit of the speed along y, in both directions: it also cuts a jump that is"
      .. " faster.",
  },
  {
    name = "maxFallSpeed",
    type = "number",
    absent = "none",
    unit = "px/s",
    min = 0,
    meaning = "The limit of the speed at which it falls, along gravity only: a jump may be faster.",
  },
  {
    name = "mask",
    type = "mask",
    absent = "collides with every group",
    meaning = "`mask[group] = false`: passes through the objects of that group. `true` and nil"
      .. " collide. Either object of a pair may refuse.",
  },
  {
    name = "hits",
    type = "names",
    absent = "every group that no mask refuses",
    meaning = 'Collides with the objects of these groups and of no others: `hits = { "players" }`.'
      .. " The list is read when it is set; to change it, set another list.",
  },
  {
    name = "oneWay",
    type = "string",
    values = SIDES,
    yes = "top",
    absent = "none: solid all around",
    meaning = "The one side that is solid; `true` is the top. The others let everything through."
      .. " For static and kinematic objects: a dynamic one would fall through the floor.",
  },
  {
    name = "slope",
    type = "string",
    values = { "left", "right", "topleft", "topright" },
    absent = "none: a box",
    meaning = "A right triangle that fills its box, for static and kinematic objects. `left` and"
      .. " `right` name the side that is high, solid below; `topleft` and `topright` hang from"
      .. " above.",
  },
  {
    name = "carry",
    type = "boolean",
    default = true,
    meaning = "Whether a kinematic object takes its riders along. `false`: it slides away under"
      .. " them.",
  },
  {
    name = "surfaceSpeed",
    type = "number",
    default = 0,
    unit = "px/s",
    meaning = "A conveyor: what stands on it moves along x at this speed; along y where gravity"
      .. " acts sideways.",
  },
  {
    name = "nudge",
    type = "number",
    default = 0,
    unit = "px",
    min = 0,
    meaning = "Corner correction: an object that hits a static or kinematic corner by at most this"
      .. " much slides past it. One that lands on an edge is not moved.",
  },
  {
    name = "snap",
    type = "number",
    default = 0,
    unit = "px",
    min = 0,
    meaning = "An object that stood on something, and does not jump, stays on the ground where that"
      .. " drops by at most this much: down stairs at any speed.",
  },
  {
    name = "constantSpeed",
    type = "boolean",
    default = false,
    meaning = "On slopes `vx` is the speed along the ground: uphill and downhill it comes less far"
      .. " along x. `false`: `vx` is the speed along x everywhere.",
  },
  {
    name = "touching",
    type = "sides",
    written = true,
    meaning = "What a dynamic object touches: `top`, `bottom`, `left` and `right`, each the other"
      .. " object or `false`. An object that was hit in the last update, and left again, counts.",
  },
  {
    name = "onBegin",
    type = "function",
    signature = "(self, other, side, speed, x1, y1, x2, y2)",
    absent = "none",
    meaning = "Called once when a contact starts, also with a sensor. `side` is the side of `self`"
      .. " that was hit, `speed` the approach speed in px/s. The edge that the two have in"
      .. " common goes from `x1, y1` to `x2, y2`.",
  },
  {
    name = "onStay",
    type = "function",
    signature = "(self, other, side, dt)",
    absent = "none",
    meaning = "Called at every further step of a contact; dt is the length of that step in s.",
  },
  {
    name = "onEnd",
    type = "function",
    signature = "(self, other, side)",
    absent = "none",
    meaning = "Called once when a contact ends, also when one of the two is removed or"
      .. " deactivated.",
  },
  {
    name = "onCrush",
    type = "function",
    signature = "(self, a, b, axis)",
    absent = "none",
    meaning = "Called once when `self` is held between `a` and `b`, neither of which can give way."
      .. ' `axis` is "x" or "y".',
  },
  {
    name = "canCollide",
    type = "function",
    signature = "(self, other, side)",
    absent = "always",
    meaning = "Asked before a contact: `false` lets the pair pass through each other for this"
      .. " step. It must not change the world.",
  },
}

--- What the field `area` of a zone may hold.
---@type physics.Field[]
fields.area = require(root .. ".world.areaFields")

--- The settings of a world.
---@type physics.Field[]
fields.settings = require(root .. ".world.settingFields")

---@param list physics.Field[]
---@return table<string, physics.Field>
local function byName(list)
  local names = {}
  for i = 1, #list do
    names[list[i].name] = list[i]
  end
  return names
end

---@param list physics.Field[]
---@return string[]
local function namesOf(list)
  local names = {}
  for i = 1, #list do
    names[i] = list[i].name
  end
  return names
end

fields.objectNames, fields.settingNames = namesOf(fields.objects), namesOf(fields.settings)
fields.areaNames, fields.areaByName = namesOf(fields.area), byName(fields.area)
fields.objectByName = byName(fields.objects)
fields.settingByName = byName(fields.settings)

return fields
