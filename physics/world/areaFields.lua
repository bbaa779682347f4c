--- What the field `area` of a zone may hold (see fields.lua).

---@type physics.Field[]
return {
  {
    name = "gravity",
    type = "number",
    absent = "that of the object",
    unit = "px/s²",
    meaning = "Replaces the downward gravity of what is inside. A negative one lifts, as in water.",
  },
  {
    name = "gravityX",
    type = "number",
    absent = "that of the object",
    unit = "px/s²",
    meaning = "Replaces the sideways gravity of what is inside.",
  },
  {
    name = "ax",
    type = "number",
    default = 0,
    unit = "px/s²",
    meaning = "An acceleration along x on top: wind.",
  },
  {
    name = "ay",
    type = "number",
    default = 0,
    unit = "px/s²",
    meaning = "An acceleration along y on top.",
  },
  {
    name = "airFriction",
    type = "number",
    default = 0,
    unit = "1/s",
    min = 0,
    meaning = "Damping on top of that of the object: water, mud.",
  },
  {
    name = "drag",
    type = "number",
    default = 0,
    unit = "px/s²",
    min = 0,
    meaning = "A constant deceleration on top of that of the object.",
  },
  {
    name = "attract",
    type = "number",
    default = 0,
    unit = "px/s²",
    meaning = "An acceleration towards the centre of the zone; a negative one repels.",
  },
  {
    name = "law",
    type = "string",
    values = { "constant", "linear", "inverse", "square" },
    default = "constant",
    meaning = "How `attract`, which it is at the rim, depends on the distance from the centre:"
      .. " not at all, growing with it, as 1 / distance, or as 1 / distance². The rim is at half of"
      .. " the smaller size. Within an eighth of that the pull falls to 0 at the centre.",
  },
}
