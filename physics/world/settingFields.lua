--- Every setting of a world, once (see fields.lua).

---@type physics.Field[]
return {
  {
    name = "gravity",
    type = "number",
    default = 9.81 * 64,
    unit = "px/s²",
    meaning = "The downward acceleration of everything that moves. The default is that of the"
      .. " earth at 64 px to the metre.",
  },
  {
    name = "gravityX",
    type = "number",
    default = 0,
    unit = "px/s²",
    meaning = "The sideways acceleration of everything that moves.",
  },
  {
    name = "push",
    type = "string",
    values = { "both", "first" },
    default = "both",
    meaning = "Which of two objects gives way: both, the lighter one more, or only the one that"
      .. " ran into the other.",
  },
  {
    name = "masks",
    type = "masks",
    absent = "every group collides with every group",
    meaning = "Groups that pass through each other: `masks = { bullets = { players = false } }`.",
  },
  {
    name = "soft",
    type = "soft",
    absent = "no group is soft to another",
    unit = "px/s",
    meaning = "Groups that overlap and drift apart instead of colliding:"
      .. " `soft = { enemies = { enemies = 400 } }`. Two at one place part at this speed, two that"
      .. " overlap by half at half of it. Static objects and sensors are not soft.",
  },
  {
    name = "sideBySide",
    type = "boolean",
    default = false,
    meaning = "Whether flush neighbours that never pressed each other count as colliding: in"
      .. " events, `touching`, `queryRect`, `overlapping` and `checkCollision`.",
  },
  {
    name = "broadphase",
    type = "string",
    values = { "auto", "pairs", "grid" },
    default = "auto",
    meaning = "How pairs that may meet are found, all with the same result to the bit. `auto` is"
      .. " the grid.",
  },
  {
    name = "cellSize",
    type = "number",
    absent = "48",
    unit = "px",
    above = 0,
    meaning = "The width and height of the smallest cells of the grid. Most objects should fit"
      .. " into one, with some 10 px to spare; larger objects use larger cells.",
  },
  {
    name = "timestep",
    type = "number",
    absent = "none: a step is as long as dt",
    unit = "s",
    min = 1e-5,
    max = 0.25,
    meaning = "A fixed step: `update` saves up dt and makes as many of these steps as fit.",
  },
  {
    name = "maxStep",
    type = "number",
    default = 1 / 30,
    unit = "s",
    min = 1e-5,
    max = 0.25,
    meaning = "The longest single step. A longer dt is split into equal steps. A `timestep` is"
      .. " never split.",
  },
  {
    name = "order",
    type = "names",
    absent = "numbers ascending, then strings",
    meaning = "Group names from first to last. Groups that are not listed follow in the usual"
      .. " order.",
  },
  {
    name = "ownFields",
    type = "ownFields",
    absent = "none",
    meaning = "Names of fields of your own objects that `save`, `restore` and `hash` count in:"
      .. " numbers, strings, booleans and tables of these.",
  },
  {
    name = "rest",
    type = "boolean",
    default = true,
    meaning = "Whether objects are skipped when a step would not change them. The result is the"
      .. " same to the bit.",
  },
  {
    name = "checked",
    type = "boolean",
    default = false,
    meaning = "Whether every step also looks for common mistakes, such as a misspelt field or a"
      .. " static object that was changed without `refresh`. Use it while you write the game.",
  },
  {
    name = "profile",
    type = "function",
    signature = "()",
    absent = "nothing is timed",
    meaning = "A clock that returns seconds, as `os.clock` or `love.timer.getTime`: with one,"
      .. " `stats` tells how long the stages of the last step have taken.",
  },
  {
    name = "onStep",
    type = "function",
    signature = "(dt)",
    absent = "none",
    meaning = "Called before every step, of dt s: the place for controllers where an update makes"
      .. " several steps (`timestep`, a long dt) or none. What it writes counts in that step.",
  },
  {
    name = "onBegin",
    type = "function",
    signature = "(a, b, side, speed, x1, y1, x2, y2)",
    absent = "none",
    meaning = "Called once when a contact starts, with `a` before `b` in order. `side` is the side"
      .. " of `a`; the edge that the two have in common goes from `x1, y1` to `x2, y2`.",
  },
  {
    name = "onStay",
    type = "function",
    signature = "(a, b, side, dt)",
    absent = "none",
    meaning = "Called at every further step of a contact; dt is the length of that step in s.",
  },
  {
    name = "onEnd",
    type = "function",
    signature = "(a, b, side)",
    absent = "none",
    meaning = "Called once when a contact ends.",
  },
  {
    name = "onCrush",
    type = "function",
    signature = "(object, a, b, axis)",
    absent = "none",
    meaning = "Called once when an object is held between `a` and `b`, neither of which can give"
      .. " way.",
  },
  {
    name = "canCollide",
    type = "function",
    signature = "(a, b, side)",
    absent = "always",
    meaning = "Asked before every contact: `false` lets the pair pass through each other for this"
      .. " step. It must not change the world.",
  },
}
