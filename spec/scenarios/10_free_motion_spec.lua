--- Arcs, damping and limits, the same at every frame rate.

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local row = play.row
local solid = scene.maker("tiles", { static = true })
local FLOOR = solid("floor", -200, 116, 800, 32)

--- A box of 16 px with more fields, where it flies or on the floor.
local function box(x, y, fields)
  return scene.maker("boxes", fields)("body", x, y, 16, 16)
end

local function flying(v)
  return { gravity = v.gravity, box(0, 0, v.fields) }
end

local function onFloor(v)
  return { FLOOR, box(0, 100, v.fields) }
end

describe("vy and gravity: a jump", function()
  --      . .
  --    .     .    100 px
  --  +--+
  -- ----------
  row("(10) with 400 px/s is exactly 100 px high", EVERYWHERE, { FLOOR, box(0, 100, {}) }, {
    0.5,
    "body.vy = -400",
    { 0.5, "body at 0, 100 - 400 * t + 400 * t * t" },
    "body.y ~ 0",
    { 1.5, "body at 0, min(100, 400 * t * t)" },
    { "body still", "body touches bottom" },
  })
end)

describe("airFriction, drag, maxSpeed, friction: slowing down", function()
  -- the way is the integral of v0 e^(-kt): v0 (1 - e^-k) / k
  row("(10) by airFriction 0.5 leaves e^-0.5 of the speed after 1 s", EVERYWHERE, flying, {
    { 1, "body.vx ~ 300 * exp(-0.5 * t), 1e-9" },
    "body.x ~ 600 * (1 - exp(-0.5)), 0.1",
  }, { "gravity, fields", { 0, { vx = 300, airFriction = 0.5 } } })

  row("(10) by drag 100 from 200 px/s stops after 2 s and 200 px", EVERYWHERE, flying, {
    { 2, "body.vx ~ 200 - 100 * t, 1" },
    { 1, "body.vy == 0" },
    { "body.vx == 0", "body.x ~ 200, 2" },
  }, { "gravity, fields", { 0, { vx = 200, drag = 100 } } })

  -- The floor takes away what the body would fall in a step: that is no motion to slow down.
  row("(10) by {what} on a floor", EVERYWHERE, onFloor, {
    2.5,
    "body.x ~ x, off; body.vx ~ vx, 1e-9; body.y ~ 100",
  }, {
    "what, x, off, vx, fields",
    { "drag 100 stops 200 px/s after 200 px", 200, 0.1, 0, { vx = 200, drag = 100 } },
    { "friction 0.5 stops 200 px/s after 50 px", 50, 1, 0, { vx = 200, friction = 0.5 } },
    { "maxSpeed goes on", 237.5, 0.25, 100, { ax = 400, maxSpeed = 100, drag = 0 } },
  })

  -- Where they come in steps of 1/2400 s. There is no such place in closed form.
  row("by {what} on a curve is nearly the same at every rate", EVERYWHERE, flying, {
    { time = "seconds" },
    "body at x, y, 0.12",
  }, {
    "what, seconds, x, y, fields",
    { "drag", 2, 133.4515, 724.3259, { vx = 200, vy = -300, drag = 300 } },
    { "maxSpeed", 1, 66.7031, 240.7754, { vx = 100, maxSpeed = 300 } },
  })

  row("by {what} reverses no velocity", EVERYWHERE, flying, { { 0.5, "{line}" } }, {
    "what, line, fields",
    { "drag 400", "body.vx >= 0", { vx = 5, vy = -14, drag = 400 } },
    { "maxSpeed 5", "body.vx >= 0", { vx = 5, maxSpeed = 5 } },
    { "drag 683", "body.vy <= 0", { vx = 21, vy = -5, ax = -1415, gravity = 0, drag = 683 } },
  })

  -- v' = 250 - 240 - 3 v: to 10 / 3 px/s
  row("by drag and airFriction, pulled, from {start} px/s", EVERYWHERE, flying, {
    "last, off = 10 / 3, start - 10 / 3",
    {
      2,
      "body.vy ~ last + off * exp(-3 * t), 1e-9",
      "body.y ~ last * t + off * (1 - exp(-3 * t)) / 3, 1e-9",
    },
    "body.vx == 0",
  }, {
    "start, gravity, fields",
    { 0, 250, { vy = 0, airFriction = 3, drag = 240 } },
    { 300, 250, { vy = 300, airFriction = 3, drag = 240 } },
  })
end)

row("maxSpeedY: a speed limit (10) maxSpeedY 960 holds", EVERYWHERE, flying, {
  { 3, "body.vy ~ min(960, 800 * t)", "body.vy <= 960", "body.vx == 50" },
  "body.vy == 960",
}, { "fields", { { vx = 50, maxSpeedY = 960 } } })

describe("vx and touching: a slide", function()
  local DIAGONAL = box(0, 0, { vx = 100, vy = 100 })

  --   +--+       |
  --   +--+       +
  --      \       |
  --       v      +  tiles
  local WALL = scene.tiles({ gravity = 0, DIAGONAL }, 40, 100, -64, 16, 16, 0, 16)
  row("(10) along a wall of tiles keeps its speed, pushed every step", EVERYWHERE, WALL, {
    {
      2,
      keep = "body.vx, body.vy = 100, 100",
      "body at min(84, 100 * t), 100 * t",
      "body.vy == 100",
    },
    "body touches right",
  })

  --   +--+           |
  --   +--+           |
  --       \          |
  --        v         |
  --   ---------------+
  local WALLS = { solid("wall", 100, -100, 16, 216), solid("floor", -100, 100, 200, 16) }
  local CORNER = { gravity = 0, DIAGONAL, WALLS[1], WALLS[2] }
  row("(10) into an inner corner touches both sides in the same step", EVERYWHERE, CORNER, {
    "listen body",
    {
      1,
      keep = "body.vx, body.vy = 100, 100",
      "(body.touching.bottom ~= false) == (body.touching.right ~= false)",
    },
    { "body at 84, 84", "body still", "body touches right bottom", "body heard 2, 0" },
  })
end)
