--- Friction between two that both give way. What is exact, and what has which tolerance, stands in
--- docs/reliability.md under "Friction in stacks".

local newRandom = require("spec.support.random").new
local physics = require("physics")

-- A box of 16 px with its upper left corner at x, y; the floor is at y = 0.
local function put(x, y, friction, vx, mass, fields)
  local object = { x = x, y = y, width = 16, height = 16, friction = friction }
  object.vx, object.mass = vx or 0, mass or 1
  for name, value in pairs(fields or {}) do
    object[name] = value
  end
  return object
end

local function addFloor(world, friction)
  local floor = { x = -9000, y = 0, width = 18000, height = 16, static = true, friction = friction }
  return world:add("floors", floor)
end

local function play(world, steps, dt, keep, boxes)
  for _ = 1, steps do
    for n, vx in pairs(keep or {}) do
      boxes[n].vx = vx
    end
    world:update(dt)
  end
end

-- Plays a row: boxes on a floor with friction `floor` under `gravity` (800), for `seconds` (1).
-- Mirrored, if `way` is -1. `keep`: vx of boxes, written before each update. `settle`: seconds
-- before the ways are measured; `later`: vx of boxes, written after one update.
-- Returns their ways and speeds, along `way`, and the boxes.
local function run(row, rate, way, push)
  local world = physics.newWorld({ gravity = row.gravity or 800, push = push })
  addFloor(world, row.floor)
  local boxes, keep, from, ways, speeds = {}, {}, {}, {}, {}
  for n, fields in ipairs(row) do
    local box = put(fields.x, fields.y, fields.friction, fields.vx, fields.mass, fields)
    if way < 0 then
      box.x, box.vx, box.ax = -box.x - box.width, -box.vx, -(box.ax or 0)
    end
    boxes[n] = world:add("boxes", box)
  end
  for n, vx in pairs(row.keep or {}) do
    keep[n] = way * vx
  end
  play(world, row.later and 1 or (row.settle or 0) * rate, 1 / rate, keep, boxes)
  for n, box in ipairs(boxes) do
    from[n] = box.x
    box.vx = row.later and row.later[n] and way * row.later[n] or box.vx
  end
  play(world, math.floor((row.seconds or 1) * rate + 0.5), 1 / rate, keep, boxes)
  for n, box in ipairs(boxes) do
    ways[n], speeds[n] = way * (box.x - from[n]), way * box.vx
  end
  return ways, speeds, boxes
end

local function near(what, expected, actual, off)
  local difference = math.abs(expected - actual)
  if difference > off or difference ~= difference then
    error(("%s should be %.12g, is %.12g"):format(what, expected, actual))
  end
end

-- Fails unless the boxes of a row came as far and are as fast as it says: ways within `off` (1e-9)
-- plus `offDt` px/s times dt and `offDt2` px/s² times its square; speeds within `offSpeed` (1e-9)
-- plus `offSpeedDt` times dt, and to the bit where they are 0. The boxes of `same` go equally far.
-- With `isExact` ways of 0 are meant to the bit. None leaves its height, without `falls`.
local function expect(row, rate, way, push)
  local ways, speeds, boxes = run(row, rate, way, push)
  local where = ("%d Hz, push %s, way %d: box "):format(rate, push, way)
  local off = (row.off or 1e-9) + (row.offDt or 0) / rate + (row.offDt2 or 0) / rate ^ 2
  local offSpeed = (row.offSpeed or 1e-9) + (row.offSpeedDt or 0) / rate
  for n, box in ipairs(boxes) do
    local its, speed = row.ways and row.ways[n], row.speeds and row.speeds[n]
    if its then
      near(where .. n .. ": way", its, ways[n], row.isExact and its == 0 and 0 or off)
    end
    if speed then
      near(
        where .. n .. ": vx",
        speed,
        speeds[n],
        speed == 0 and not row.offSpeed and 0 or offSpeed
      )
    end
    if not row.falls then
      near(where .. n .. ": y", row[n].y, box.y, 0)
    end
  end
  for _, n in ipairs(row.same or {}) do
    near(where .. n .. ": way, as the first", ways[row.same[1]], ways[n], 1e-9)
  end
end

local function spec(row, tag)
  it(row[0] .. (tag or ""), function()
    for _, rate in ipairs(row.rates or { 30, 60, 144, 240 }) do
      for _, push in ipairs(row.pushes or { "both" }) do
        for _, way in ipairs({ 1, -1 }) do
          expect(row, rate, way, push)
        end
      end
    end
  end)
end

local WIDE = { width = 200 }
local LEFT = 0.1 - 2 / 300 -- s, after what moves 2 px at 300 px/s

-- Rows of which ways and speeds are known by hand. Friction f under gravity g takes f * g off.
describe("friction: as by hand,", function()
  local SLIDING = {
    --    +--+ 60 ->          The floor is ice, the boxes rub with 0.5: they pull at each other with
    --    +--+                400 px/s² each, so the slip ends after 60 / 800 s and 60² / 1600 px.
    --  +------+
    -- ===========
    {
      [0] = "a box slides on another on ice: they share the momentum, and slip 2.25 px",
      floor = 0,
      put(0, -16, 0.5, 0, 1, { width = 64 }),
      put(20, -32, 0.5, 60),
      ways = { 28.875, 31.125 },
      speeds = { 30, 30 },
      off = 1e-6,
      offSpeed = 1e-6,
    },
    --   60 ->+--+       It is braked by the stack that is under more of it, and bears its weight:
    --      +--+--+      720 px/s². The other one is as high, but one crate, and smoother.
    --      |  +--+
    {
      [0] = "a box on two stacks is braked by the one under more of it",
      put(0, -16, 0.9),
      put(0, -32, 0.9),
      put(-16, -32, 0.1, 0, 1, { height = 32 }),
      put(-4, -48, 0.9),
      later = { [4] = 60 },
      ways = { 0, 0, 0, 60 ^ 2 / 1440 },
      speeds = { 0, 0, 0, 0 },
      isExact = true,
    },
    --   300 ->+--+      Masses 1, 1 and 5: the highest one slips, the two below stop together, by
    --         +--+      5600 - 4000 * 0.5^0.5 for both.
    --         +--+
    {
      [0] = "a stack under a heavy box that slides off stops as a whole",
      rates = { 30, 60, 144, 480 },
      seconds = 0.5,
      floor = 1,
      put(0, -10, 1, 300, 1, { width = 30, height = 10 }),
      put(0, -20, 1, 300, 1, { width = 30, height = 10 }),
      put(0, -35, 0.5, 300, 5, { width = 30, height = 15 }),
      ways = { 300 ^ 2 / (5600 - 4000 * math.sqrt(0.5)) },
      speeds = { 0 },
      offDt = 10,
      same = { 1, 2 },
      falls = true,
    },
  }

  -- From the lowest up: friction, mass, vx; and how far each comes within a tenth of a second.
  for name, row in pairs({
    -- 0.2 * 900 * 5 of the floor against 0.5 * 900 * 4
    ["the highest drags the lowest off the floor"] = {
      { 0.04, 1, 0, 4.5 },
      { 6.25, 4, 300, 27.75 },
    },
    -- 0.6 * 900 * 2: the second could be held with 0.6 * 900 * 3, both only with 0.2 * 900 * 4
    ["the highest drags two off the floor that hold together"] = {
      { 0.04, 1, 0, 0.9 },
      { 9, 1, 0, 0.9 },
      { 0.04, 2, 200, 17.3 },
    },
    -- 0.2 * 900 * 4 of the highest, where the second has 0.1 * 900 * 6 against it
    ["the highest drags the second off the lowest"] = {
      { 0.09, 1, 0, 0 },
      { 1 / 9, 2, 0, 0.45 },
      { 0.36, 4, 100, 9.1 },
    },
    -- 0.3 * 900 * 5 on the lowest, of which 0.2 * 900 * 6 is borne
    ["the second drags the lowest with the weight of what goes along"] = {
      { 0.04, 1, 0, 1.35 },
      { 2.25, 1, 200, 18.65 },
      { 0.36, 4, 200, 18.65 },
    },
  }) do
    local all =
      { [0] = name, rates = { 30, 60, 240, 1000 }, gravity = 900, seconds = 0.1, floor = 1 }
    all.ways = {}
    for n, box in ipairs(row) do
      all[n], all.ways[n] = put(0, -16 * n, box[1], box[3], box[2], WIDE), box[4]
    end
    SLIDING[#SLIDING + 1] = all
  end

  --  120 -> of mass 5, 5, 5 and 1 at rest. The highest helps to brake the others, so that the
  --  lowest can hold those on it: only together they go as far as this.
  local floor, top = 800 * math.sqrt(0.3 * 0.5), 800 * 0.9 -- px/s²
  local brake = (16 * floor + top) / 15
  local t = 120 / (brake + top) -- s, until all go at one speed
  local far = (120 + top * t) * t / 2 + (top * t) ^ 2 / (2 * floor)
  SLIDING[#SLIDING + 1] = {
    [0] = "a stack slides from under its highest box",
    floor = 0.3,
    put(0, -16, 0.5, 120, 5),
    put(0, -32, 0.3, 120, 5),
    put(0, -48, 0.9, 120, 5),
    put(0, -64, 0.9),
    ways = { far, far, far },
    speeds = { 0, 0, 0 },
    offDt = 2,
  }

  for _, masses in ipairs({ { 1, 1, 1 }, { 4, 1, 2 }, { 1, 8, 0.25 } }) do
    for seconds, speed in pairs({ [1 / 6] = 200 - 400 / 6, [1] = 0 }) do
      local row = { seconds = seconds, same = { 1, 2, 3 }, off = 1, offSpeed = speed > 0 and 1e-6 }
      local text = "a stack of masses %s slows down as one box does, %.2g s"
      row[0] = text:format(table.concat(masses, ", "), seconds)
      for n, mass in ipairs(masses) do
        row[n] = put(0, -16 * n, 0.5, 200, mass)
      end
      row.ways, row.speeds = speed == 0 and { 50, 50, 50 }, { speed, speed, speed }
      SLIDING[#SLIDING + 1] = row
    end
  end

  --     +--+           It is braked by 400 px/s², and pulls at the crate by 400 for each kg; that
  --     +--+ 120 ->    is as firm as its 8 kg.
  --   +------+
  for _, height in ipairs({ 1, 2, 4 }) do
    local row = { put(-40, -16, 0.5, 0, 8, { width = 80 }) }
    row[0] = ("a tower of %d slides on a crate, 18 px"):format(height)
    row.isExact, row.off, row.ways, row.speeds = true, 1e-2, { 0 }, { 0 }
    for n = 1, height do
      row[n + 1] = put(-8, -16 - 16 * n, 0.5, 120)
      row.ways[n + 1], row.speeds[n + 1] = 18, 0
    end
    SLIDING[#SLIDING + 1] = row
  end

  for _, row in ipairs(SLIDING) do
    spec(row)
  end
end)

describe("friction: what is hit,", function()
  -- Alone both are braked by 400 px/s². What stands on the crate slides, and takes 800 from the
  -- two; all have 50 / 3 px/s after 1/24 s, and stop together.
  local ALONE, SLIP, REST = 50 ^ 2 / 800, (50 ^ 2 - (50 / 3) ^ 2) / 1600, (50 / 3) ^ 2 / 800
  -- The crate of mass 2 is run into from afar, in the middle of a step; 360 px/s² off a box.
  -- Alone the two go on at 100 px/s; the crate brakes both by 2/3 * 360. If it bounces it goes at
  -- 300 * 1.5 / 3 px/s. After 24 px, braked itself, the box has √(300² - 2 * 360 * 24) px/s.
  local ROWS = {
    {
      [0] = "a crate of mass 2 and the box that runs into it stop",
      rates = { 30, 60, 144, 1000 },
      gravity = 900,
      seconds = 2,
      put(0, -16, 0, 300),
      put(40, -16, 0.4, 0, 2),
      ways = { false, 100 ^ 2 / 480 },
      speeds = { false, 0 },
      off = 0.04, -- in the last step it stands for all of it
    },
    {
      [0] = "a crate of mass 2 that bounces goes alone",
      rates = { 30, 60, 144, 1000 },
      gravity = 900,
      seconds = 2,
      put(0, -16, 0, 300),
      put(40, -16, 0.4, 0, 2, { restitution = 0.5 }),
      ways = { false, 150 ^ 2 / 720 },
      speeds = { false, 0 },
    },
    --   +--+ 300 ->     +--+     450 px/s² off the one on the floor, as long as it lies there: the
    --   +--+ 2 px off   +--+     impact of its landing is over
    {
      [0] = "and comes down hard as the step begins, is braked by its weight alone",
      rates = { 30, 60, 90, 1000 },
      gravity = 900,
      seconds = 0.1,
      floor = 1,
      put(0, -16, 0, 300, 1, { gravity = 0 }),
      put(18, -16, 0.25, 0, 1, { vy = 500 }),
      ways = { 2 + (150 - 225 / 2 * LEFT) * LEFT, (150 - 225 / 2 * LEFT) * LEFT },
      speeds = { 150 - 225 * LEFT, 150 - 225 * LEFT },
    },
    {
      [0] = "a crate by the box next to it",
      put(0, -16, 0.5),
      put(16, -16, 0.5),
      later = { 100 },
      ways = { ALONE, ALONE },
      speeds = { 0, 0 },
    },
    -- (The step in which the slip ends counts the crate alone, not what pushes it.)
    {
      [0] = "a crate with a box on it by the box next to it",
      put(0, -16, 0.5),
      put(16, -16, 0.5),
      put(16, -32, 0.5),
      later = { 100 },
      ways = { SLIP + REST, SLIP + REST, 200 / 24 ^ 2 + REST },
      speeds = { 0, 0, 0 },
      off = 0.02,
    },
    {
      [0] = "a crate by the box next to it, which carries one",
      put(0, -16, 0.5),
      put(16, -16, 0.5),
      put(0, -32, 0.5),
      later = { 100, 0, 100 },
      ways = { ALONE, ALONE, 100 ^ 2 / 800 },
      speeds = { 0, 0, 0 },
    },
  }
  for _, row in ipairs(ROWS) do
    spec(row)
  end
end)

--   +--+--+       The floor bears 400 px/s² of each kg of a crate, and of what stands on it.
--  -> 1| 1|
-- =========
describe("friction: what is leaned on or pushed,", function()
  local function engine(ax, fields)
    local object = put(0, -16, nil, 0, 1, fields)
    object.ax = ax
    return object
  end

  local CRATE, NEXT = put(16, -16, 0.5), put(32, -16, 0.5)
  local BOTH, RATES = { "both", "first" }, { 30, 60, 144 }
  local UP, UP2, UP3 = put(16, -32, 0.5), put(16, -48, 0.5), put(16, -64, 0.5)
  for name, row in pairs({
    ["a crate that bears more"] = { engine(399), CRATE },
    ["a crate that bears just as much"] = { engine(400), CRATE },
    ["two crates that bear more together"] = { engine(790), CRATE, NEXT },
    ["a heavy crate at 60 px/s"] = { engine(), put(16, -16, 0.5, 0, 22), keep = { 60 } },
    ["the lowest of a stack"] = { engine(1590), CRATE, UP, UP2, UP3 },
    ["the third of a stack"] = { engine(390, { y = -48, gravity = 0 }), CRATE, UP, UP2 },
    ["a crate, from both sides"] = { engine(700), CRATE, put(32, -16, nil, 0, 1, { ax = -500 }) },
    ["a crate, evenly"] = { engine(700), CRATE, put(32, -16, nil, 0, 1, { ax = -700 }) },
    ["a crate, hard"] = { engine(2000), CRATE, put(32, -16, nil, 0, 1, { ax = -1700 }) },
  }) do
    row[0], row.rates, row.pushes, row.off = "does not move: " .. name, RATES, BOTH, 1e-12
    row.ways, row.speeds = { 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0 }
    spec(row)
  end

  -- All of them go on at (ax - what friction bears) / mass. (As long as friction would stop them
  -- within a step, it is thought to act at once, and not during the whole step.)
  for name, row in pairs({
    ["a crate"] = { engine(500), CRATE, speeds = { 50, 50 } },
    ["two crates"] = { engine(900), CRATE, NEXT, speeds = { 100 / 3, 100 / 3, 100 / 3 } },
    ["a crate, with another behind"] = {
      engine(300),
      engine(300, { x = 16 }),
      NEXT,
      speeds = { 200 / 3, 200 / 3, 200 / 3 },
    },
  }) do
    row[0], row.rates, row.offDt2, row.ways = "goes on by the rest: " .. name, RATES, 300, {}
    for n, speed in ipairs(row.speeds) do
      row.ways[n] = speed / 2
    end
    spec(row)
  end

  --         +--+        The crate and what stands on it weigh as much as each pusher.
  --  +--+---+--+---+
  -- ->  |          |
  local function pushed(fields, count)
    local row = { put(0, -10, nil, fields.vx, 1, fields), rates = RATES }
    row[1].height = 10
    for n = 1, count do
      row[n + 1] = put(16, -16 * n, 0.5, 0, 1, { width = 64 })
    end
    return row
  end
  local LIFT = { kinematic = true, vx = 60 }
  local along, slips, both = pushed(LIFT, 3), pushed(LIFT, 2), pushed({ ax = 1000 }, 2)
  along[0], along.settle, along.seconds = "goes along with a lift, and all on it", 1, 2
  along.ways, along.speeds = { 120, 120, 120, 120 }, { 60, 60, 60, 60 }
  -- 60 px/s at 400 px/s²: within 60 / 400 s by 60² / 800 px, but for the first step.
  slips[0], slips.offDt = "slips as long as the lift is faster", 60
  slips.ways, slips.speeds = { 60, 60, 55.5 }, { 60, 60, 60 }
  -- The floor takes 0.5 * 800 px/s² of the two: (1000 - 800) / 3 is left for all three.
  both[0], both.same = "goes along with a box that leans on it", { 1, 2, 3 }
  both.speeds = { 200 / 3, 200 / 3, 200 / 3 }
  -- 400 px/s² for the upper one; 0.5 * 800 * 2 of the floor and 400 of that for the lower.
  local off = pushed({ ax = 3600 }, 2)
  off[0], off.seconds, off.offSpeedDt = "slides off if that is too fast for it", 1 / 6, 400
  off.speeds = { false, 1200 / 6, 400 / 6 }
  local nine = { put(-16, -8, nil, 60, 1, { height = 8, kinematic = true }), off = 1e-6 }
  nine[0], nine.settle, nine.seconds, nine.ways = "goes along in a row of stacks", 1, 2, { 120 }
  for n = 0, 8 do
    nine[n + 2] = put(16 * math.floor(n / 3), -16 - 16 * (n % 3), 0.5)
    nine.ways[n + 2] = 120
  end
  for _, row in ipairs({ along, slips, both, off, nine }) do
    spec(row)
  end

  spec({
    [0] = "stands on nothing",
    put(0, -56, nil, 60, 1, { gravity = 0 }),
    put(16, -56, 0.5, 0, 1, { gravity = 0 }),
    speeds = { 30, 30 },
  })

  for _, mass in ipairs({ 5, 100, 1000 }) do
    it(("under a box of mass %d: goes no faster than what pushes"):format(mass), function()
      local world, crates = physics.newWorld({ gravity = 1600 }), {}
      addFloor(world)
      for n, x in ipairs({ 0, 0, 20 }) do
        local size = { width = 20, height = 20 }
        local crate = put(x, n == 2 and -40 or -20, 1, 0, n == 2 and mass or 1, size)
        crates[n] = world:add("crates", crate)
      end
      local player = world:add("players", put(-20, -24, nil, 0, 1000, { width = 20, height = 24 }))
      for _ = 1, 120 do
        player.vx = 200
        world:update(1 / 60)
        for _, crate in ipairs(crates) do
          assert.is_true(math.abs(crate.vx) <= 200, "goes at " .. crate.vx)
        end
      end
    end)
  end

  it("stands on a belt: goes along with the lift, also if that touches the one on it", function()
    local world = physics.newWorld({ gravity = 800 })
    addFloor(world).surfaceSpeed = -20
    local size = { width = 30, height = 20 }
    local low = world:add("boxes", put(0, -20, 1, 0, 1, size))
    local high = world:add("boxes", put(0, -40, 1, 0, 1, size))
    local lift = { width = 20, height = 24, kinematic = true }
    world:add("lifts", put(-37, -24, nil, 50, 1, lift))
    for n = 1, 40 do
      world:update(1 / 30)
      if n > 10 then
        near("vx", 50, low.vx, 1e-9)
        near("x", low.x, high.x, 1e-9)
      end
    end
  end)

  -- Four on each other and their pusher.
  local function tower(mass, floor, vx)
    local row = { put(-16, -16, nil, 0, mass), keep = { vx }, floor = floor }
    for n = 1, 4 do
      row[n + 1] = put(0, -16 * n, 0.7)
    end
    return row
  end

  it("is a tower, at 40 px/s: slips by 10 / 7 px in small steps", function()
    local row = tower(1e6, nil, 40)
    row.seconds = 0.5
    local ways, speeds = run(row, 960, 1)
    for n = 3, 5 do
      near("slip", 40 ^ 2 / 2 / (0.7 * 800), ways[2] - ways[n], 2e-3)
      assert.equal(speeds[2], speeds[n])
    end
  end)

  -- The floor smoother than the tower, as rough, and rougher.
  it("is a tower, at 4 or 8 px/s: goes along to the bit", function()
    for _, vx in ipairs({ 4, 8 }) do
      for _, floor in ipairs({ 0.3, 0.7, 0.9 }) do
        for _, rate in ipairs({ 30, 60 }) do
          for _, seconds in ipairs({ 0.1, 0.5, 1, 2 }) do
            local row = tower(99, floor, vx)
            row.seconds = seconds
            local ways = run(row, rate, 1)
            assert.same({ ways[2], ways[2], ways[2] }, { ways[3], ways[4], ways[5] })
            assert.is_true(seconds < 2 or ways[2] > vx)
          end
        end
      end
    end
  end)
end)

-- The two push as hard as each other, anew in every update, so nothing moves. One push comes first,
-- and gave the one between more than the other took back: it crept by up to 9 px/s.
--
--     > [ ] <
describe("friction: pressed from both sides goes nowhere:", function()
  for name, row in pairs({
    ["a player"] = { friction = 0.5, isWritten = true, speed = 60 },
    ["a rough player between two"] = { friction = 1, isWritten = true, speed = 60, on = 0.5 },
    ["a rough crate"] = { friction = 1, speed = 150 },
    ["a heavy crate"] = { friction = 0.5, speed = 150, mass = 5 },
    ["a crate with another on it"] = { friction = 0.5, speed = 150, isLoaded = true },
    -- (One of them comes first, and moves it until the other one is seen in the same step.)
    ["a crate that they reach from afar"] = { friction = 0.3, speed = 150, gap = 3, off = 0.01 },
  }) do
    it(name, function()
      for _, rate in ipairs({ 30, 60, 144 }) do
        local world, gap = physics.newWorld({ gravity = 800 }), row.gap or 0
        addFloor(world)
        local size, small = { width = 24, height = 24 }, { width = 20, height = 20 }
        local box = world:add("boxes", put(0, -24, row.friction, 0, row.mass, size))
        local left = world:add("boxes", put(-20 - gap, -20, row.on, 0, 1, small))
        local right = world:add("boxes", put(24 + gap, -20, row.on, 0, 1, small))
        if row.isLoaded then
          world:add("boxes", put(4, -40, row.friction))
        end
        for step = 1, rate do
          box.vx = row.isWritten and 0 or box.vx
          left.vx, right.vx = row.speed, -row.speed
          world:update(1 / rate)
          near("x", 0, box.x, row.off or 1e-9)
          near("vx", 0, box.vx, row.off and step <= rate / 6 and 0.3 or 1e-9)
          if step > rate / 6 then
            assert.same({ box.x - 20, box.x + 24 }, { left.x, right.x })
            assert.equal(left, box.touching.left)
            assert.equal(right, box.touching.right)
          end
        end
      end
    end)
  end
end)

describe("friction: of two floors", function()
  --      +--+ 100 ->      the second tile may be a one-way: such a contact is looked at in another
  --   ----|====           way than a plain one, and comes at its place in the order all the same
  it("the first in order counts for what stands evenly on both, also by one-ways", function()
    for _, y in ipairs({ 200, -1000 }) do
      for oneWay = 0, 2 do
        for n, left in ipairs({ 86 + 2 / 3, 100 - math.sqrt(0.1) * 800 / 60 }) do
          local world, size = physics.newWorld({ gravity = 800 }), { width = 20, height = 20 }
          for m = 1, 2 do
            local tile = put(20 * m, y, m == n and 1 or 0.1, 0, 1, size)
            tile.static, tile.oneWay = true, m == oneWay and "top" or nil
            world:add("tiles", tile)
          end
          local box = world:add("boxes", put(30, y - 20, 1, 100, 1, size))
          world:update(1 / 60)
          near("vx", left, box.vx, 1e-6)
          assert.equal(y - 20, box.y)
        end
      end
    end
  end)

  -- Which carries it, too. It comes to lie past where it is half on either floor, by the way that
  -- it slides from there, and up to a step.
  for name, row in pairs({
    ["a belt"] = { { surfaceSpeed = 60 }, {}, 0, 60 * 60 / 800, 60 },
    ["the ice"] = { { friction = 0 }, { friction = 0.5 }, 100, 100 * 100 / 800, 100 },
  }) do
    it("the one under more of it counts: it comes off " .. name, function()
      for order = 1, 2 do
        for _, way in ipairs({ 1, -1 }) do
          for _, rate in ipairs({ 30, 60, 144 }) do
            local world = physics.newWorld({ gravity = 800 })
            for n = 1, 2 do
              local isNear = n == order
              local floor = put(0, 0, nil, 0, 1, isNear and row[1] or row[2])
              floor.static, floor.width = true, isNear and 600 or 500
              floor.x = way > 0 and (isNear and -500 or 100) or (isNear and -100 or -600)
              floor.surfaceSpeed = (floor.surfaceSpeed or 0) * way
              world:add("floors", floor)
            end
            local box = world:add("boxes", put(way > 0 and 40 or -56, -16, 0.5, row[3] * way))
            play(world, 5 * rate, 1 / rate)
            local past = (way > 0 and box.x or -box.x - 16) - 92
            assert.is_true(past >= row[4] - 1e-6 and past <= row[4] + row[5] / rate, past)
            assert.equal(0, box.vx)
          end
        end
      end
    end)
  end
end)

-- What comes of these cannot be worked out by hand any more: it is what very small steps lead to,
-- as far as a step is long.
describe("friction: goes where small steps lead it #slow", function()
  -- How far the boxes of `build(random, seed)` are from there, at most, for each of the seeds.
  local function distances(build, gravity, seconds, count, rate)
    local apart = {}
    for seed = 1, count do
      local row = build(newRandom(seed), seed)
      row.gravity, row.seconds = gravity, seconds
      local exact, ways = run(row, 1500, 1), run(row, rate, 1)
      apart[seed] = 0
      for n = 1, #row do
        apart[seed] = math.max(apart[seed], math.abs(ways[n] - exact[n]))
      end
    end
    table.sort(apart)
    return apart
  end

  -- Two to four of different mass, some of which bounce, pull or touch from the beginning.
  local function runningInto(random)
    local row, x = { floor = 1 }, 0
    for n = 1, math.floor(random:between(2, 5)) do
      x = x + math.max(random:between(-40, 40), 0)
      local box = put(x, -16, random:between(0, 1) < 0.2 and 0 or random:between(0.05, 0.5))
      box.mass = random:between(0, 1) < 0.5 and 1 or random:between(0.3, 4)
      box.vx = random:between(0, 1) < 0.5 and random:between(-300, 300) or 0
      box.restitution = random:between(0, 1) < 0.3 and random:between(0, 1) or nil
      box.ax = random:between(0, 1) < 0.3 and random:between(-400, 400) or nil
      row[n], x = box, x + 16
    end
    return row
  end

  -- One stack that runs into another, or comes down on it.
  local function stacks(random, seed)
    local row = { floor = random:between(0.1, 0.6) }
    local x, vx, high = random:between(-60, -16), random:between(60, 300), random:between(0, 30)
    for _, stack in ipairs({
      { 0, math.floor(random:between(1, 5)), 0, 0 },
      { x, math.floor(random:between(1, 3)), vx, seed % 4 == 0 and high or 0 },
    }) do
      for n = 1, stack[2] do
        local friction, mass = random:between(0.1, 0.7), random:between(0.5, 2.5)
        row[#row + 1] = put(stack[1], -16 * n - stack[4], friction, stack[3], mass)
      end
    end
    return row
  end

  -- A stack of which each has another speed; half of them get another one on top.
  local function sliding(random, seed)
    local row = { floor = random:between(0.1, 0.6) }
    for n = 1, math.floor(random:between(2, 6)) do
      local friction, mass = random:between(0.1, 0.7), random:between(0.5, 2.5)
      row[n] = put(0, -16 * n, friction, random:between(-60, 240), mass, WIDE)
    end
    if seed % 2 == 0 then
      local y = -16 * #row - 16 - random:between(1, 30)
      row[#row + 1] = put(90, y, random:between(0.1, 0.7))
    end
    return row
  end

  for _, row in ipairs({
    -- what, build, seconds, seeds, rate, px for the half of them and for so many
    { "boxes that run into each other", runningInto, 0.5, 40, 30, 1e-9, 36, 0.9 },
    { "boxes that run into each other", runningInto, 0.5, 40, 60, 1e-9, 36, 0.25 },
    { "a stack that is run into", stacks, 0.5, 24, 60, 0.1, 22, 1.5 },
    { "a stack of different speeds", sliding, 0.4, 20, 60, 0.1, 20, 1.5 },
  }) do
    it(("%s, at %d Hz #slow"):format(row[1], row[5]), function()
      local apart = distances(row[2], 900, row[3], row[4], row[5])
      local half, most = apart[row[4] / 2], apart[row[7]]
      assert.is_true(half < row[6], ("half differ by up to %g px"):format(half))
      assert.is_true(most < row[8], ("%d differ by up to %g px"):format(row[7], most))
    end)
  end
end)

describe("friction: stacks of different sizes, masses and speeds", function()
  local function build(seed, isIce)
    local random, boxes, x = newRandom(seed), {}, 0
    local world = physics.newWorld({ gravity = 900, push = seed % 2 == 0 and "first" or "both" })
    addFloor(world, isIce and 0 or random:between(0.1, 1))
    for _ = 1, math.floor(random:between(1, 5)) do
      local top, vx = 0, random:between(-200, 200)
      local isEach = random:between(0, 1) < 0.5
      for _ = 1, math.floor(random:between(1, 5)) do
        local box = { x = x, width = random:between(10, 40), height = random:between(8, 24) }
        top = top - box.height
        box.y, box.friction = top, random:between(0, 1)
        local isOdd = random:between(0, 1) < 0.2
        box.mass = isOdd and random:between(0.05, 20) or random:between(0.5, 2.5)
        box.vx = isEach and random:between(-200, 200) or vx
        box.restitution = random:between(0, 1) < 0.15 and random:between(0, 1) or nil
        boxes[#boxes + 1] = world:add("boxes", box)
      end
      x = x + 50 + math.max(random:between(-30, 30), 0)
    end
    return world, boxes
  end

  local function sumsOf(boxes)
    local energy, momentum, moving = 0, 0, 0
    for _, box in ipairs(boxes) do
      local kinetic = box.mass * (box.vx ^ 2 + box.vy ^ 2) / 2
      energy = energy + kinetic - box.mass * 900 * box.y
      momentum, moving = momentum + box.mass * box.vx, moving + kinetic
    end
    return energy, momentum, moving
  end

  for _, rate in ipairs({ 30, 60, 144 }) do
    it(("never get energy, and on ice keep their momentum, at %d Hz #slow"):format(rate), function()
      for seed = 1, 12 do
        for _, isIce in ipairs({ true, false }) do
          local world, boxes = build(seed, isIce)
          world:update(0)
          local energy, momentum, moving = sumsOf(boxes)
          for step = 1, rate do
            world:update(1 / rate)
            local now, its = sumsOf(boxes)
            assert.is_true(now <= energy + 1e-6 * moving, ("seed %d, step %d"):format(seed, step))
            assert.is_true(not isIce or math.abs(its - momentum) < 1e-9)
            energy = now
          end
        end
      end
    end)
  end
end)

describe("friction: of a stack", function()
  -- The lowest box bears all four kg, as on a floor: 0.4 * 4 * 900 px/s² for a sixtieth.
  it("on a slope is that of its whole weight, in every order of adding", function()
    for order = 1, 2 do
      local world = physics.newWorld({ gravity = 900 })
      local hill = { x = 0, y = 100, width = 400, height = 200, static = true, slope = "right" }
      world:add("ground", hill)
      local size = { width = 14, height = 14 }
      local low, high = put(266, 146, 0.4, 0, 1, size), put(266, 132, 0, 0, 3, size)
      world:add("boxes", order == 1 and low or high)
      world:add("boxes", order == 1 and high or low)
      play(world, 60, 1 / 60)
      low.vx, high.vx = 100, 100
      world:update(1 / 60)
      near("vx", 76, low.vx, 1e-9)
      assert.equal(100, high.vx)
    end
  end)

  --   +-+          a crate on a raft that nothing immovable bears: gravity presses it all the same
  --  =====  60 ->
  -- ~~~~~~~
  it("acts on what floats, hovers or cannot be pushed", function()
    for _, raft in ipairs({
      { gravity = 0 },
      { gravity = 0, pushable = false },
      { ay = -800.8 }, -- its jet bears the crate, too
    }) do
      local world = physics.newWorld({ gravity = 800 })
      raft.width = 200
      raft = world:add("rafts", put(0, 100, 1, 0, 1000, raft))
      local crate = world:add("crates", put(90, 84, 1))
      play(world, 60, 1 / 60, { 60 }, { raft })
      near("way", 60 - 60 ^ 2 / 1600, crate.x - 90, 0.1)
      near("vx", raft.vx, crate.vx, 1e-9)
    end
  end)
end)
