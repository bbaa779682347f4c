--- Friction between two that both give way. What is exact, and what has which tolerance, stands in
--- docs/reliability.md under "Friction in stacks".

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

-- On a floor at y = 0, both ways.
local LEVELS = { shift = { 0 }, order = { "forward" }, push = { "both" }, turn = { 0, 2 } }
LEVELS.rate, LEVELS.broadphase = { 30, 60, 144, 240 }, { "grid" }
local FINE = { shift = { 0 }, order = { "forward" }, push = { "both" }, turn = { 0, 2 } }
FINE.rate, FINE.broadphase = { 30, 60, 240, 1000 }, { "grid" }
local BOTH = { shift = { 0 }, order = { "forward" }, turn = { 0, 2 }, rate = { 30, 60, 144 } }

local SLOW = { shift = { 0 }, push = { "both" }, turn = { 0, 2 }, rate = { 30, 60 } }
local THIRTY = { shift = { 0 }, order = { "forward" }, push = { "both" }, rate = { 30 } }

local floors = scene.maker("floors", { static = true })

-- Rows of numbers in a text, "0 -16 0.5; 0 -32 - 60": no number is nil, the fifth is a size.
local function numbersIn(text)
  local rows = {}
  for part in text:gmatch("[^;]+") do
    local row, n = {}, 0
    for word in part:gmatch("%S+") do
      n = n + 1
      row[n] = tonumber(word)
    end
    row.width, row.height = row[6], row[7]
    rows[#rows + 1] = row
  end
  return rows
end

-- A scene: the floor with its friction, and boxes named a, b, c … on it: x, y, friction, vx, mass,
-- and fields of their own; or as a text, with width and height.
local function on(friction, first, ...)
  local list = { floors("floor", -9000, 0, 18000, 16, { friction = friction }) }
  local rows = type(first) == "string" and numbersIn(first) or { first, ... }
  for n, row in ipairs(rows) do
    local object = small.box(row[1], row[2], row)
    object.friction, object.vx, object.mass = row[3], row[4] or 0, row[5] or 1
    object.name = ("abcdefghijk"):sub(n, n)
    list[n + 1] = { "boxes", object }
  end
  return list
end

-- Rows of which ways and speeds are known by hand. Friction f under gravity g takes f * g off.
describe("friction: as by hand,", function()
  --   60 ->+--+       It is braked by the stack that is under more of it, and bears its weight:
  --      +--+--+      720 px/s². The other one is as high, but one crate, and smoother.
  --      |  +--+
  local LOW, HIGH = { 0, -16, 0.9 }, { 0, -32, 0.9 }
  local LONE, TOP = { -16, -32, 0.1, 0, 1, height = 32 }, { -4, -48, 0.9, 0, 1, name = "top" }
  local STACKS = on(nil, LOW, HIGH, LONE, TOP)
  play.row("a box on two stacks is braked by one", LEVELS, STACKS, {
    { steps = 1 },
    "d.vx = 60",
    { 1, "a.x == 0", "b.x == 0", "c.x == -16" },
    "d.x ~ -4 + 60 ^ 2 / 1440, 1e-9; d.vx == 0",
  })

  --   300 ->+--+      Masses 1, 1 and 5: the highest one slips, the two below stop together, by
  --         +--+      5600 - 4000 * 0.5^0.5 for both.
  --         +--+
  local SLABS = on(1, "0 -10 1 300 1 30 10; 0 -20 1 300 1 30 10; 0 -35 0.5 300 5 30 15")
  play.row("a stack under a heavy box that slides off stops as a whole", FINE, SLABS, {
    { 0.5, "b.x ~ a.x, 1e-9" },
    "a.x ~ 300 ^ 2 / (5600 - 4000 * sqrt(0.5)), 10 / run.rate; a.vx == 0",
  })

  -- From the lowest up: friction, mass, vx; and where each is after a tenth of a second.
  local function wide(v)
    local list = {}
    for n, row in ipairs(v.boxes) do
      list[n] = { 0, -16 * n, row[1], row[3], row[2], width = 200 }
    end
    local all = on(1, small.unpack(list))
    all.gravity = 900
    return all
  end
  play.row("{what}", FINE, wide, { 0.1, "{ends}" }, {
    "what, ends, boxes",
    -- 0.2 * 900 * 5 of the floor against 0.5 * 900 * 4
    {
      "the highest drags the lowest off the floor",
      "a.x ~ 4.5, 1e-9; b.x ~ 27.75, 1e-9",
      { { 0.04, 1, 0 }, { 6.25, 4, 300 } },
    },
    -- 0.6 * 900 * 2: the second could be held with 0.6 * 900 * 3, both only with 0.2 * 900 * 4
    {
      "the highest drags two off the floor that hold together",
      "a.x ~ 0.9, 1e-9; b.x ~ 0.9, 1e-9; c.x ~ 17.3, 1e-9",
      { { 0.04, 1, 0 }, { 9, 1, 0 }, { 0.04, 2, 200 } },
    },
    -- 0.2 * 900 * 4 of the highest, where the second has 0.1 * 900 * 6 against it
    {
      "the highest drags the second off the lowest",
      "a.x ~ 0, 1e-9; b.x ~ 0.45, 1e-9; c.x ~ 9.1, 1e-9",
      { { 0.09, 1, 0 }, { 1 / 9, 2, 0 }, { 0.36, 4, 100 } },
    },
    -- 0.3 * 900 * 5 on the lowest, of which 0.2 * 900 * 6 is borne
    {
      "the second drags the lowest with the weight of what goes along",
      "a.x ~ 1.35, 1e-9; b.x ~ 18.65, 1e-9; c.x ~ 18.65, 1e-9",
      { { 0.04, 1, 0 }, { 2.25, 1, 200 }, { 0.36, 4, 200 } },
    },
  })

  --  120 -> of mass 5, 5, 5 and 1 at rest. The highest helps to brake the others, so that the
  --  lowest can hold those on it: only together they go as far as this.
  local floor, top = 800 * math.sqrt(0.3 * 0.5), 800 * 0.9 -- px/s²
  local brake = (16 * floor + top) / 15
  local t = 120 / (brake + top) -- s, until all go at one speed
  local FAR = (120 + top * t) * t / 2 + (top * t) ^ 2 / (2 * floor)
  local TOWER = on(0.3, "0 -16 0.5 120 5; 0 -32 0.3 120 5; 0 -48 0.9 120 5; 0 -64 0.9")
  play.row("a stack slides from under its highest box", LEVELS, TOWER, {
    1,
    "a.x ~ far, 2 / run.rate; b.x ~ far, 2 / run.rate; c.x ~ far, 2 / run.rate",
    "a.vx == 0; b.vx == 0; c.vx == 0",
  }, { "far", { FAR } })

  play.row("a stack of masses {m1}, {m2}, {m3} slows down as one box does", LEVELS, function(v)
    local boxes = "0 -16 0.5 200 %g; 0 -32 0.5 200 %g; 0 -48 0.5 200 %g"
    return on(nil, boxes:format(v.m1, v.m2, v.m3))
  end, {
    { 1 / 6, "b.x ~ a.x, 1e-9", "c.x ~ a.x, 1e-9" },
    "a.vx ~ 200 - 400 / 6; b.vx ~ 200 - 400 / 6; c.vx ~ 200 - 400 / 6",
    5 / 6,
    "a.x ~ 50, 1; b.x ~ a.x, 1e-9; c.x ~ a.x, 1e-9; a.vx == 0; b.vx == 0; c.vx == 0",
  }, { "m1, m2, m3", { 1, 1, 1 }, { 4, 1, 2 }, { 1, 8, 0.25 } })
end)

describe("friction: what is hit,", function()
  -- Alone both are braked by 400 px/s². What stands on the crate slides, and takes 800 from the
  -- two; all have 50 / 3 px/s after 1/24 s, and stop together.
  local ALONE, SLIP, REST = 50 ^ 2 / 800, (50 ^ 2 - (50 / 3) ^ 2) / 1600, (50 / 3) ^ 2 / 800
  local row = play.with({ alone = ALONE, slip = SLIP + REST, rest = REST, left = 0.1 - 2 / 300 })

  -- The crate of mass 2 is run into from afar, in the middle of a step; 360 px/s² off a box.
  -- Alone the two go on at 100 px/s; the crate brakes both by 2/3 * 360. If it bounces it goes at
  -- 300 * 1.5 / 3 px/s.
  row("a crate of mass 2, restitution {e}, and the box that runs into it", FINE, function(v)
    local list = on(nil, { 0, -16, 0, 300 }, { 40, -16, 0.4, 0, 2, restitution = v.e })
    list.gravity = 900
    return list
  end, { 2, "b.x ~ 40 + way, off; b.vx == 0" }, {
    "e, way, off", -- in the last step it stands for all of it
    { nil, 100 ^ 2 / 480, 0.04 },
    { 0.5, 150 ^ 2 / 720, 1e-9 },
  })

  --   +--+ 300 ->     +--+     450 px/s² off the one on the floor, as long as it lies there: the
  --   +--+ 2 px off   +--+     impact of its landing is over
  local aloft = { 0, -16, 0, 300, 1, gravity = 0, gravityX = 0 }
  local LANDS = on(1, aloft, { 18, -16, 0.25, 0, 1, vy = 500 })
  LANDS.gravity = 900
  row("and comes down hard as the step begins, is braked by its weight alone", FINE, LANDS, {
    0.1,
    "a.x ~ 2 + (150 - 112.5 * left) * left, 1e-9; b.x ~ a.x + 16, 1e-9",
    "a.vx ~ 150 - 225 * left, 1e-9; b.vx ~ a.vx, 1e-9",
  })

  -- (The step in which the slip ends counts the crate alone, not what pushes it.)
  row("a crate by the box next to it, {what}", LEVELS, function(v)
    return on(nil, { 0, -16, 0.5 }, { 16, -16, 0.5 }, v.third)
  end, {
    { steps = 1 },
    "a.vx = 100; (c or a).vx = thirdSpeed or 100",
    1,
    "{ends}; a.vx == 0; b.vx == 0",
  }, {
    "what, ends, third, thirdSpeed",
    { "alone", "a.x ~ alone, 1e-9; b.x ~ 16 + alone, 1e-9" },
    {
      "with a box on it",
      "a.x ~ slip, 0.02; b.x ~ 16 + slip, 0.02; c.x ~ 16 + 200 / 24 ^ 2 + rest, 0.02",
      { 16, -32, 0.5 },
      0,
    },
    {
      "which carries one",
      "a.x ~ alone, 1e-9; b.x ~ 16 + alone, 1e-9; c.x ~ 100 ^ 2 / 800, 1e-9",
      { 0, -32, 0.5 },
    },
  })

  --  #  +--+--+ <- 300     3 px to the wall; the heavy one is braked, which pulls the light one off
  --  #  | 1|30|
  local BEHIND = on(nil, { 0, -16, 0 }, { 16, -16, 0.5, -300, 30 })
  BEHIND[#BEHIND + 1] = scene.maker("walls", { static = true })("wall", -19, -200, 16, 200)
  BEHIND.gravity = 800
  row("a light crate by a heavy one: neither ends in the wall behind it", THIRTY, BEHIND, {
    { steps = 1 },
    "a.x ~ -3, 1e-9; b.x ~ 13, 1e-9",
  })
end)

--   +--+--+       The floor bears 400 px/s² of each kg of a crate, and of what stands on it.
--  -> 1| 1|
-- =========
describe("friction: what is leaned on or pushed,", function()
  local CRATE, NEXT = { 16, -16, 0.5 }, { 32, -16, 0.5 }
  local UP, UP2, UP3 = { 16, -32, 0.5 }, { 16, -48, 0.5 }, { 16, -64, 0.5 }

  -- `a` is an engine of `ax` px/s² (without: it is written 60 px/s), 1 kg, without friction.
  local function engine(v)
    local one = { 0, v.y or -16, nil, 0, 1, ax = v.ax, gravity = v.y and 0, gravityX = v.y and 0 }
    return on(nil, one, v.B, v.C, v.D, v.E)
  end
  local function against(ax)
    return { 32, -16, nil, 0, 1, ax = ax }
  end
  local still = {
    { 1, keep = "a.vx = ax and a.vx or 60", "abs(a.x) <= 1e-12", "b.x ~ 16, 1e-12" },
    "a.vx == 0; b.vx == 0; (c or a).vx == 0; (d or a).vx == 0; (e or a).vx == 0",
  }
  play.row("does not move: {what}", BOTH, engine, still, {
    "what, ax, B, C, D, E, y",
    { "a crate that bears just as much", 400, CRATE },
    { "two crates that bear more together", 790, CRATE, NEXT },
    { "a heavy crate at 60 px/s", nil, { 16, -16, 0.5, 0, 22 } },
    { "the lowest of a stack", 1590, CRATE, UP, UP2, UP3 },
    { "the third of a stack", 390, CRATE, UP, UP2, nil, -48 },
    { "a crate, from both sides", 700, CRATE, against(-500) },
    { "a crate, evenly", 700, CRATE, against(-700) },
    { "a crate, hard", 2000, CRATE, against(-1700) },
  })

  --         +--+        The crate and what stands on it weigh as much as each pusher.
  --  +--+---+--+---+
  -- ->  |          |
  local function pushed(v)
    local fields = { 0, -10, nil, v.vx, 1, height = 10, ax = v.ax, kinematic = v.vx and true }
    local list = { fields }
    for n = 1, v.count do
      list[n + 1] = { 16, -16 * n, 0.5, 0, 1, width = 64 }
    end
    return on(nil, small.unpack(list))
  end
  play.row("{what}", LEVELS, pushed, { { time = "seconds" }, "{ends}" }, {
    "what, seconds, ends, count, vx, ax",
    {
      "goes along with a lift, and all on it",
      3,
      "b.x - a.x ~ 16; c.x - b.x ~ c.x - b.x; a.vx ~ 60; b.vx ~ 60; c.vx ~ 60; d.vx ~ 60",
      3,
      60,
    },
    -- 60 px/s at 400 px/s²: within 60 / 400 s by 60² / 800 px, but for the first step.
    {
      "slips as long as the lift is faster",
      1,
      "b.x ~ 76, 60 / run.rate; c.x ~ 16 + 55.5, 60 / run.rate; b.vx ~ 60; c.vx ~ 60",
      2,
      60,
    },
    -- The floor takes 0.5 * 800 px/s² of the two: (1000 - 800) / 3 is left for all three.
    {
      "goes along with a box that leans on it",
      1,
      "b.x - a.x ~ 16, 1e-9; c.x ~ b.x, 1e-9; a.vx ~ 200 / 3, 1e-9; c.vx ~ 200 / 3, 1e-9",
      2,
      nil,
      1000,
    },
    -- 400 px/s² for the upper one; 0.5 * 800 * 2 of the floor and 400 of that for the lower.
    {
      "slides off if that is too fast for it",
      1 / 6,
      "b.vx ~ 1200 / 6, 400 / run.rate; c.vx ~ 400 / 6, 400 / run.rate",
      2,
      nil,
      3600,
    },
  })

  play.row("under a box of mass {mass}: goes no faster than what pushes", LEVELS, function(v)
    local boxes =
      "-20 -24 - 0 1000 20 24; 0 -20 1 0 1 20 20; 0 -40 1 0 %g 20 20; 20 -20 1 0 1 20 20"
    local list = on(nil, boxes:format(v.mass))
    list.gravity = 1600
    return list
  end, {
    { 2, keep = "a.vx = 200", "abs(b.vx) <= 200", "abs(c.vx) <= 200", "abs(d.vx) <= 200" },
  }, { "mass", { 5 }, { 1000 } })

  local BELT = scene.maker("floors", { static = true, surfaceSpeed = -20 })
  play.row("stands on a belt: goes along with the lift, also touching what is on it", THIRTY, {
    BELT("floor", -9000, 0, 18000, 16),
    scene.maker("boxes", { friction = 1 })("low", 0, -20, 30, 20),
    scene.maker("boxes", { friction = 1 })("high", 0, -40, 30, 20),
    scene.maker("lifts", { kinematic = true, vx = 50 })("lift", -37, -24, 20, 24),
  }, { 1 / 3, { 1, "low.vx ~ 50", "high.x ~ low.x" } })
end)

-- The two push as hard as each other, anew in every update, so nothing moves. One push comes first,
-- and gave the one between more than the other took back: it crept by up to 9 px/s.
--
--     > [ ] <
describe("friction: pressed from both sides goes nowhere:", function()
  local function pressed(v)
    local gap = v.gap or 0
    return on(
      nil,
      { 0, -24, v.friction, 0, v.mass, width = 24, height = 24 },
      { -20 - gap, -20, v.on, 0, 1, width = 20, height = 20 },
      { 24 + gap, -20, v.on, 0, 1, width = 20, height = 20 },
      v.isLoaded and { 4, -40, v.friction } or nil
    )
  end
  -- (One of them comes first, and moves it until the other one is seen in the same step.)
  local KEEP = "a.vx = isWritten and 0 or a.vx; b.vx, c.vx = speed, -speed"
  play.row("{what}", BOTH, pressed, {
    { 1 / 6, keep = KEEP, "a.x ~ 0, off or 1e-9", "a.vx ~ 0, off and 0.3 or 1e-9" },
    {
      5 / 6,
      keep = KEEP,
      "a.x ~ 0, off or 1e-9",
      "a.vx ~ 0",
      "b.x == a.x - 20",
      "c.x == a.x + 24",
      "a.touching.left == b",
      "a.touching.right == c",
    },
  }, {
    "what, friction, speed, isWritten, on, mass, isLoaded, gap, off",
    { "a player", 0.5, 60, true },
    { "a rough player between two", 1, 60, true, 0.5 },
    { "a rough crate", 1, 150 },
    { "a heavy crate", 0.5, 150, nil, nil, 5 },
    { "a crate with another on it", 0.5, 150, nil, nil, nil, true },
    { "a crate that they reach from afar", 0.3, 150, nil, nil, nil, nil, 3, 0.01 },
  })
end)

describe("friction: of two floors", function()
  --      +--+ 100 ->      the second tile may be a one-way: such a contact is looked at in another
  --   ----|====           way than a plain one, and comes at its place in the order all the same
  local tile = scene.maker("tiles", { static = true })
  play.row("the first in order counts: {rough} is rough, {oneWay} one-way", play.ONCE, function(v)
    local list = {}
    for n = 1, 2 do
      local fields =
        { friction = n == v.rough and 1 or 0.1, oneWay = n == v.oneWay and "top" or nil }
      list[n] = tile("tile" .. n, 20 * n, 200, 20, 20, fields)
    end
    list[3] = scene.maker("boxes", { friction = 1, vx = 100 })("box", 30, 180, 20, 20)
    return list
  end, { "run:step(1 / 60); box.vx ~ left, 1e-6; box.y == 180" }, {
    "rough, oneWay, left",
    { 1, 0, 86 + 2 / 3 },
    { 1, 2, 86 + 2 / 3 },
    { 2, 0, 100 - math.sqrt(0.1) * 800 / 60 },
    { 2, 1, 100 - math.sqrt(0.1) * 800 / 60 },
  })

  -- Which carries it, too. It comes to lie past where it is half on either floor, by the way that
  -- it slides from there, and up to a step.
  play.row("the one under more of it counts: it comes off {what}", BOTH, function(v, r)
    local one, far = { friction = v.friction }, { friction = v.friction and 0.5 }
    one.surfaceSpeed = v.belt and (r.turn == 2 and -v.belt or v.belt)
    local floor = scene.maker("floors", { static = true })
    local first, second = floor("near", -500, 0, 600, 16, one), floor("far", 100, 0, 500, 16, far)
    local box = scene.maker("boxes", { friction = 0.5, vx = v.vx })("box", 40, -16, 16, 16)
    return { v.isFirst and first or second, v.isFirst and second or first, box }
  end, {
    5,
    "box.x - 92 >= speed ^ 2 / 800 - 1e-6; box.x - 92 <= speed ^ 2 / 800 + speed / run.rate",
    "box.vx == 0",
  }, {
    "what, speed, isFirst, belt, friction, vx",
    { "a belt", 60, true, 60, nil, 0 },
    { "a belt, the other one first", 60, false, 60, nil, 0 },
    { "the ice", 100, true, nil, 0, 100 },
    { "the ice, the other one first", 100, false, nil, 0, 100 },
  })
end)

describe("friction: of a stack", function()
  -- The lowest box bears all four kg, as on a floor: 0.4 * 4 * 900 px/s² for a sixtieth.
  local LOW = scene.maker("boxes", { friction = 0.4 })("low", 266, 146, 14, 14)
  local HIGH = scene.maker("boxes", { mass = 3, friction = 0 })("high", 266, 132, 14, 14)
  local HILL = scene.maker("ground", { static = true, slope = "right" })("hill", 0, 100, 400, 200)
  local ORDERS = { shift = { 0 }, push = { "both" }, broadphase = { "grid" } }
  play.row("on a slope is that of its whole weight", ORDERS, { gravity = 900, HILL, LOW, HIGH }, {
    { "run:play(1); low.vx, high.vx = 100, 100", 1 / 60, "low.vx ~ 76, 1e-9; high.vx == 100" },
  })

  --   +-+          a crate on a raft that nothing immovable bears: gravity presses it all the same
  --  =====  60 ->
  -- ~~~~~~~
  play.row("acts on what floats, hovers or cannot be pushed: {what}", play.ONCE, function(v)
    local fields =
      { friction = 1, mass = 1000, gravity = v.gravity, pushable = v.pushable, ay = v.ay }
    local raft = scene.maker("rafts", fields)("raft", 0, 100, 200, 16)
    return { raft, scene.maker("crates", { friction = 1 })("crate", 90, 84, 16, 16) }
  end, {
    { 1, keep = "raft.vx = 60" },
    "crate.x ~ 90 + 60 - 60 ^ 2 / 1600, 0.1; crate.vx ~ raft.vx, 1e-9",
  }, {
    "what, gravity, pushable, ay",
    { "floats", 0 },
    { "is held", 0, false },
    { "has a jet, which bears the crate, too", nil, nil, -800.8 },
  })
  -- 400 px/s² of friction against 2 / s of air.
  play.row("drags what is in air, whatever it weighs: {mass} kg", play.ONCE, function(v)
    local raft = scene.maker("rafts", { friction = 0.5, mass = 1e9, gravity = 0, vx = 300 })
    local high = { friction = 0.5, mass = v.mass, airFriction = 2 }
    return { raft("raft", 0, 100, 400, 16), scene.maker("crates", high)("high", 90, 84, 16, 16) }
  end, { { 0.25, "high.vx ~ 200 * (1 - exp(-2 * t)), 1e-6" } }, { "mass", { 1 }, { 3 } })

  --     ->+-+       of two crates before a ram, the upper one is hit: 140 px/s of 1 kg, by 3 kg
  --       +-+==         at -55 are -6.25 for both; friction draws them by 0.4 * 900 * 3 / 4
  --     +---+== <-      = 270 px/s², on a belt, too
  --   ----------- 40 ->
  play.row("holds nothing against a hit: {hit}, on a belt at {belt} px/s", SLOW, function(v)
    local crate = scene.maker("crates", { mass = 3, friction = 0.4 })
    return {
      gravity = 900,
      scene.maker("belts", { static = true, surfaceSpeed = v.belt })("belt", -1000, 315, 3000, 40),
      crate("low", 400, 288, 29, 27),
      crate("top", 404, 272, 21, 16),
      scene.maker("rams", { kinematic = true, vx = -55 })("ram", 429, 293, 70, 10),
      scene.maker("men", { gravity = 0, active = false })("man", 0, 260, 16, 24),
    }
  end, {
    1,
    "man.active, man.x, man.vx = true, top.x - 17, 140",
    { steps = 1 },
    "start = top.x",
    0.1,
    "top.x ~ start - 6.25 * 0.1 - 135 * 0.1 ^ 2 - 270 * dt * 0.05, 270 * dt * 0.05 + 0.01",
  }, { "hit, belt", { "at rest", 0 }, { "pressed to the ram", 40 } })

  --   [ top ][c]         the wall holds low, and that holds top: neither presses c, which falls
  --     [ low ]| wall
  --   ------------- ->
  play.row("holds nothing in the air beside it: on a belt at {belt} px/s", THIRTY, function(v)
    local crate = scene.maker("crates", { friction = 0.7 })
    local belt = { static = true, friction = 0.9, surfaceSpeed = v.belt }
    return {
      gravity = 900,
      scene.maker("belts", belt)("belt", 0, 100, 340, 12),
      scene.maker("walls", { static = true })("wall", 80, 70, 20, 12),
      crate("low", 60, 80, 20, 20),
      crate("top", 57.8, 67, 13, 13),
      crate("c", 70.8, 59, 8, 8),
    }
  end, { 0.5, "c.y == 72" }, { "belt", { 0 }, { 30 }, { 140 } })

  --          |#     what the belt gives it, and the wall takes off again, is no load
  --   [ man ]|#
  --   -------- ->
  play.row("hinders no jump: off a belt at {belt} px/s that presses to a wall", THIRTY, function(v)
    local belt = { static = true, friction = 0.9, surfaceSpeed = v.belt }
    return {
      gravity = 900,
      scene.maker("belts", belt)("belt", 0, 200, 100, 12),
      scene.maker("walls", { static = true })("wall", 100, 0, 20, 200),
      scene.maker("men", { friction = 0.7 })("man", 84, 176, 16, 24),
    }
  end, {
    0.5,
    "man.vy = -300",
    { 1 / 3, "man.x == 84" },
    "man.y ~ 126",
  }, { "belt", { 0 }, { 60 }, { 140 } })
end)
