--- Motion: `maxSpeed` and `drag`. (What moves alone is in oracles/.) An object that pulls harder
--- than its speed limit lets it go: an engine (`ax`) with friction, drag or crates in its way.

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")

local LEVELS = { shift = { 0 }, order = { "forward" }, push = { "both" }, turn = { 0, 2 } }
LEVELS.rate, LEVELS.broadphase = { 30, 60, 144, 1000 }, { "grid" }
local row = play.row

-- Friction of 0.5 under a gravity of 800 takes 400 px/s² off.
local FLOOR = scene.maker("floors", { static = true, friction = 0.5 })("floor", -5000, 0, 10000, 20)
local box =
  scene.thing("boxes", { name = "a", x = 0, y = -20, width = 20, height = 20, friction = 0.5 })

describe("ax, maxSpeed and maxSpeedX: an engine at its limit", function()
  --        +--+ ax 600 ->       no faster than 100 px/s
  --        +--+
  --  ===================
  row("goes as by hand {what}", LEVELS, function(v)
    return { FLOOR, box(v.fields) }
  end, { 1, "a at x, -20, 1e-9; a.vx ~ vx, 1e-9" }, {
    "what, x, vx, fields",
    -- Friction leaves 200 px/s², so it takes 1/2 s and 25 px to be that fast.
    { "on a rough floor", 75, 100, { ax = 600, maxSpeedX = 100 } },
    { "with a limit of its whole speed", 75, 100, { ax = 600, maxSpeed = 100 } },
    { "that is as fast as that already", 100, 100, { ax = 600, maxSpeedX = 100, vx = 100 } },
    { "weaker than friction", 250, 200, { ax = 300, maxSpeedX = 300, vx = 300 } },
    { "that may not go at all", 0, 0, { ax = 600, maxSpeedX = 0 } },
    -- It begins at 100 px/s: 0.1 s and 5 px, then 1/2 s and 25 px back, then at the limit.
    { "the other way round", -60, -100, { ax = -600, maxSpeedX = 100, vx = 300 } },
  })

  -- (Only then, since an object that has not stood yet is dragged along its fall, too.)
  row("goes as by hand with some drag, once it has stood", LEVELS, { FLOOR, box() }, {
    { "run:play(0.5); a.ax, a.raw.drag, a.raw.maxSpeed = run.turn == 2 and -700 or 700, 100, 100" },
    1,
    "a at 75, -20, 1e-9; a.vx ~ 100, 1e-9",
  })

  -- It falls 280 px, and meets the floor at √(2 * 800 * 280) = 669 px/s: friction stops it. That
  -- takes 0.837 s; 25 px and 1/2 s later it is as fast as it was.
  local FALLER = box({ y = -300, vx = 100, ax = 600, maxSpeedX = 100 })
  row("has made up for a hard landing when by hand it has", LEVELS, { FLOOR, FALLER }, {
    2,
    "a.x ~ 25 + 100 * 1.5, 1e-9; a.vx ~ 100, 1e-9",
  })

  -- Friction takes half of what it falls: 400 px/s² until it goes at 100 px/s.
  local WALL = scene.maker("walls", { static = true, friction = 0.5 })("wall", 20, -900, 10, 2000)
  local SLIDER = box({ ax = 800, maxSpeedY = 100 })
  row("slides down a wall as fast as its maxSpeedY", LEVELS, { WALL, SLIDER }, {
    1,
    "a at 0, -20 + 87.5, 1e-9; a.vy ~ 100, 1e-9; a.vx == 0",
  })
end)

describe("maxSpeed: a velocity that the game writes towards a wall", function()
  --  vx 100 ->  +--+ |   The wall takes vx. The body falls as fast as maxSpeed allows, flush, at
  --             +--+ |   every rate. Seen from above, it goes on along the wall.
  --              |   |
  local wall = scene.maker("walls", { static = true })("wall", 20, -900, 10, 2000)
  row("gravity {gravity}, ({vx}, {vy}): {way} px in a second", LEVELS, function(v)
    return { gravity = v.gravity, wall, box({ x = -10, friction = 0, maxSpeed = 100 }) }
  end, {
    { 1, keep = "a.vx, a.vy = vx, vy or a.vy" },
    "y = a.y",
    { 1, keep = "a.vx, a.vy = vx, vy or a.vy", "a.x == 0", "a.vx == 0" },
    "a.y - y ~ way, 1e-9",
  }, {
    "gravity, vx, vy, way",
    { 800, 100, nil, 100 },
    { 800, 300, nil, 100 },
    { 0, 100, 100, 100 },
    { 0, 100, 20, 20 },
  })
end)

describe("ax and maxSpeedX: an engine that pushes at its limit", function()
  --   +--+ ax -> +--+--+
  --   +--+       +--+--+
  -- =======================
  local function engine(v)
    local others = { v.B, v.C, v.D }
    local list = { FLOOR, box({ ax = v.ax, maxSpeedX = 100 }) }
    for n, fields in ipairs(others) do
      list[n + 2] = box(fields)
      list[n + 2][2].name = ("bcd"):sub(n, n)
    end
    return list
  end
  -- What it pushes, its ax, where it is after 1 s, and how far that may be off, times dt²: for the
  -- one step in which they come to the limit. By hand they get there with a px/s², which costs them
  -- 100² / 2 a px. (A rider comes to the speed by halves of what is missing, one a step.)
  local ONE, TWO, THREE, HEAVY = { x = 20 }, { x = 40 }, { x = 60 }, { x = 20, mass = 3 }
  row("goes as by hand with {what}", LEVELS, engine, {
    1,
    "a.x ~ x, off / run.rate ^ 2 + 1e-9; a.vx ~ x > 0 and 100 or 0, 1e-5; b.vx ~ a.vx, 1e-5",
    "(c or b).vx ~ a.vx, 1e-5; (d or b).vx ~ a.vx, 1e-5; (b.y < -30 or b.x > a.x) == true",
  }, {
    "what, ax, x, off, B, C, D",
    { "a crate", 1500, 100 - 100 ^ 2 / 700, 12, ONE },
    { "two crates", 2500, 100 - 100 ^ 2 * 3 / 2600, 150, ONE, TWO },
    { "three crates", 2500, 100 - 100 ^ 2 * 4 / 1800, 150, ONE, TWO, THREE },
    { "a heavy one", 2500, 100 - 100 ^ 2 * 4 / 1800, 50, HEAVY },
    { "a rider that stands on it", 1500, 100 - 100 ^ 2 / 700, 80, { y = -40 } },
    { "one that is too heavy for it", 1500, 0, 0, HEAVY },
    { "a weaker engine", 2000, 100 - 100 ^ 2 / 800, 60, { x = 20, ax = -400, maxSpeedX = 100 } },
    { "one that is as strong", 2000, 0, 0, { x = 20, ax = -2000, maxSpeedX = 100 } },
  })

  -- 1600 px/s² for both, then 600, until they are as fast as the slower one may be.
  row("goes as fast as one that may go at {limit} px/s", LEVELS, engine, {
    1,
    "a.x ~ x, off / run.rate ^ 2 + 1e-9; a.vx ~ limit, 1e-9; b.vx ~ limit, 1e-9; b.x - a.x ~ 20",
  }, {
    "limit, ax, x, off, B",
    { 60, 2000, 60 - 60 ^ 2 / 3200, 120, { x = 20, ax = 2000, maxSpeedX = 60 } },
    { 30, 2000, 30 - 30 ^ 2 / 1200, 0, { x = 20, ax = 0, maxSpeedX = 30 } },
  })

  row("goes at its limit from above, behind what air slows", LEVELS, {
    gravity = 0,
    box({ ax = 1500, maxSpeedX = 100 }),
    box({ name = "b", x = 20, airFriction = 5 }),
  }, { 2, "a.vx ~ 100, 1e-9; b.vx ~ 100, 1e-9; b.x - a.x ~ 20" })
end)

-- 1600 px/s² against two crates of 1000 each: they hold. One of them does not.
row("drag of what is pushed holds an engine as friction does, {count} crates", LEVELS, function(v)
  local crate, list = scene.maker("crates", { drag = 1000 }), { gravity = 0, box({ ax = 1600 }) }
  for n = 1, v.count do
    list[n + 1] = crate("crate" .. n, 20 * n, -20, 20, 20)
  end
  return list
end, { 1, "a.x ~ x" }, { "count, x", { 1, 150 }, { 2, 0 } })

-- Right at a floor, above the limit; struck by something heavy; in a vice.
row("maxSpeed: nothing is ever faster than that {what}", LEVELS, function(v)
  local list = { gravity = v.gravity, FLOOR }
  list[2] = box({ maxSpeed = 200, restitution = 1, vy = v.vy })
  list[3] = box({ name = "b", x = 60, vx = v.vx, mass = 100, restitution = 1, gravity = 0 })
  return list
end, {
  { 0.5, "a.vx ^ 2 + a.vy ^ 2 <= 200 ^ 2 + 1e-6" },
  "b.vx = 0",
}, {
  "what, gravity, vx, vy",
  { "at a floor that it touches", 0, 0, 296 },
  { "the same under gravity", 1200, 0, 600 },
  { "what a heavy one strikes", 1200, -900, 100 },
})

-- 45 degrees. (A wall takes what goes into it, a slope does not.)
local RAMP = scene.maker("ramps", { static = true, slope = "left" })("ramp", -20, 0, 800, 800)
local MARBLE = box({ y = 30 - 10 - 200 ^ 0.5, radius = 10, maxSpeed = 200 })
row("maxSpeed: nor is a ball that rolls down a slope", LEVELS, { gravity = 800, RAMP, MARBLE }, {
  { 1, "a.vx ^ 2 + a.vy ^ 2 <= 200 ^ 2 + 1e-6" },
  "a.vx ^ 2 + a.vy ^ 2 > 190 ^ 2; a.touching.bottom == ramp",
})

it("maxSpeed: a box that is driven at the back of a slope falls as at a wall", function()
  for _, slope in ipairs({ "left", "topleft" }) do
    local world = physics.newWorld({ gravity = 800 })
    world:add("ramps", { x = 16, y = 0, width = 200, height = 800, static = true, slope = slope })
    local object = world:add("boxes", { x = 0, y = 100, width = 16, height = 16, maxSpeed = 200 })
    for _ = 1, 30 do
      object.vx = 200
      world:update(1 / 60)
    end
    assert.equal(200, object.vy)
  end
end)
