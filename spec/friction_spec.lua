--- Friction between two that both give way. What is exact, and what has which tolerance, stands in
--- docs/reliability.md under "Friction in stacks".

local newRandom = require("spec.support.random").new
local physics = require("physics")
local unpack = rawget(table, "unpack") or rawget(_G, "unpack")

-- Returns a function of a seed that tells where the boxes of a random scene are after steps of
-- 1/rate s. `play(seed, rate)` returns the boxes. Each scene is played once.
local function newReference(play, rate)
  local known = {}
  return function(seed)
    if not known[seed] then
      known[seed] = {}
      for n, box in ipairs(play(seed, rate)) do
        known[seed][n] = box.x
      end
    end
    return known[seed]
  end
end

-- How far the boxes of a random scene are from there, at most, for each of the seeds 1 to `count`,
-- sorted.
local function distances(play, count, rate, reference)
  local apart = {}
  for seed = 1, count do
    local farthest, exact = 0, reference(seed)
    for n, box in ipairs(play(seed, rate)) do
      farthest = math.max(farthest, math.abs(box.x - exact[n]))
    end
    apart[seed] = farthest
  end
  table.sort(apart)
  return apart
end

describe("a box that lands sliding on another", function()
  --    +--+ 60 ->          the floor is ice, the boxes rub with 0.5:
  --    +--+                they pull at each other with 0.5 * 800 = 400 px/s² each,
  --  +------+              so the slip of 60 px/s ends after 60 / 800 s and 60² / 1600 px
  --  +------+
  -- ===========
  for _, rate in ipairs({ 30, 60, 144, 240 }) do
    it(("shares its momentum and slips 2.25 px, at %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 800 })
      world:add("ice", { x = -200, y = 116, width = 800, height = 16, static = true, friction = 0 })
      local low = { x = 0, y = 100, width = 64, height = 16, friction = 0.5 }
      local high = { x = 20, y = 84, width = 16, height = 16, friction = 0.5, vx = 60 }
      world:add("boxes", low)
      world:add("boxes", high)
      for _ = 1, rate do
        world:update(1 / rate)
      end
      assert.near(30, low.vx, 1e-6)
      assert.near(30, high.vx, 1e-6)
      assert.near(22.25, high.x - low.x, 1e-6)
      assert.equal(84, high.y)
    end)
  end
end)

describe("a crate of mass 2 that is run into from afar, in the middle of a step", function()
  --  +--+ 300 ->      +--+     friction takes 0.4 * 900 = 360 px/s² off a box
  --  +--+             +--+
  -- =====================
  local ROWS = {
    -- Both go on at 100 px/s; the crate brakes both by 2/3 * 360: 100² / (2 * 240) px. (In the
    -- last step it stands for all of it.)
    { "both stop where they do by hand", {}, {}, 100 ^ 2 / 480, 0.04 },
    -- At 300 * 1.5 / 3 px/s it goes 150² / (2 * 360) px alone.
    { "goes as far as by hand if it bounces", {}, { restitution = 0.5 }, 150 ^ 2 / 720, 1e-9 },
    -- After 24 px that is braked itself the box has √(300² - 2 * 360 * 24) px/s, the two a third
    -- of it.
    { "so it does if both are rubbed", { friction = 0.4 }, {}, (300 ^ 2 - 17280) / 9 / 720, 0.02 },
  }
  for _, row in ipairs(ROWS) do
    local name, ofBox, ofCrate, way, tolerance = unpack(row)
    for _, rate in ipairs({ 30, 60, 144, 1000 }) do
      it(("%s, at %d Hz"):format(name, rate), function()
        local world = physics.newWorld({ gravity = 900 })
        world:add("floor", { x = -900, y = 16, width = 2000, height = 16, static = true })
        local box = { x = 0, y = 0, width = 16, height = 16, vx = 300 }
        local crate = { x = 40, y = 0, width = 16, height = 16, mass = 2, friction = 0.4 }
        for field, value in pairs(ofBox) do
          box[field] = value
        end
        for field, value in pairs(ofCrate) do
          crate[field] = value
        end
        world:add("boxes", box)
        world:add("boxes", crate)
        for _ = 1, 2 * rate do
          world:update(1 / rate)
        end
        assert.near(40 + way, crate.x, tolerance)
        assert.equal(0, crate.vx)
        assert.equal(0, crate.y)
      end)
    end
  end
end)

describe("a box that comes down hard as a step begins, and is hit in that step", function()
  --   +--+ 300 ->     +--+     friction takes 0.5 * 900 = 450 px/s² off the one on the floor, as
  --   +--+ 2 px off   +--+     long as it lies there: the impact of its landing is over
  --       =================
  local function play(rate, restitution)
    local world = physics.newWorld({ gravity = 900 })
    local floor = { x = -900, y = 16, width = 2000, height = 16, static = true, friction = 1 }
    world:add("floor", floor)
    local box = { x = 0, y = 0, width = 16, height = 16, vx = 300, gravity = 0 }
    local crate = { x = 18, y = 0, width = 16, height = 16, vy = 500, friction = 0.25 }
    box.restitution, crate.restitution = restitution, restitution
    world:add("boxes", box)
    world:add("boxes", crate)
    for _ = 1, rate / 10 do
      world:update(1 / rate)
    end
    return box, crate
  end

  for _, rate in ipairs({ 30, 60, 90, 1000 }) do
    it(("is braked by its weight alone, at %d Hz"):format(rate), function()
      local box, crate = play(rate, 0)
      local left = 0.1 - 2 / 300
      assert.near(150 - 225 * left, crate.vx, 1e-9)
      assert.near(18 + (150 - 225 / 2 * left) * left, crate.x, 1e-9)
      assert.near(crate.x - 16, box.x, 1e-9)
    end)

    it(("is not braked at all once it has bounced off, at %d Hz"):format(rate), function()
      local box, crate = play(rate, 1)
      assert.near(300, crate.vx, 1e-9)
      assert.near(18 + 300 * (0.1 - 2 / 300), crate.x, 1e-9)
      assert.near(0, box.vx, 1e-9)
    end)
  end
end)

describe("boxes that run into each other on a rough floor #slow", function()
  -- Two to four of different mass, some of which bounce, pull or touch from the beginning.
  local function newBox(random, x)
    local box = { x = x, y = 384, width = 16, height = 16 }
    box.friction = random:between(0, 1) < 0.2 and 0 or random:between(0.05, 0.5)
    box.mass = random:between(0, 1) < 0.5 and 1 or random:between(0.3, 4)
    box.vx = random:between(0, 1) < 0.5 and random:between(-300, 300) or 0
    box.restitution = random:between(0, 1) < 0.3 and random:between(0, 1) or nil
    box.ax = random:between(0, 1) < 0.3 and random:between(-400, 400) or nil
    return box
  end

  local function play(seed, rate)
    local random, boxes, x = newRandom(seed), {}, 0
    local world = physics.newWorld({ gravity = 900 })
    local floor = { x = -3000, y = 400, width = 6000, height = 20, static = true, friction = 1 }
    world:add("floor", floor)
    for n = 1, math.floor(random:between(2, 5)) do
      x = x + math.max(random:between(-40, 40), 0)
      boxes[n] = world:add("boxes", newBox(random, x))
      x = x + 16
    end
    for _ = 1, rate / 2 do
      world:update(1 / rate)
    end
    return boxes
  end

  -- Half of them are met once in a step at most, and are exact; the others as far as it goes.
  local reference = newReference(play, 1200)
  for _, row in ipairs({ { 30, 0.9 }, { 60, 0.25 } }) do
    local rate, most = unpack(row)
    it(("are where small steps lead them, at %d Hz #slow"):format(rate), function()
      local apart = distances(play, 40, rate, reference)
      assert.is_true(apart[20] < 1e-9, ("half differ by up to %g px"):format(apart[20]))
      assert.is_true(apart[36] < most, ("nine of ten differ by up to %g px"):format(apart[36]))
    end)
  end
end)

describe("a stack that is run into from afar, in the middle of a step #slow", function()
  --            +--+      the box is as heavy as the stack, and smooth; friction takes 360 px/s² off
  --  +--+ 150 ->  |      a crate, or gives it to one: the lowest and the box go on together, braked
  --  +--+      +--+      by the floor and the others, until all go at 50 px/s, after 5/36 s; then
  -- ===============      the floor brakes all by 180.
  local TOGETHER, LEFT = 5 / 36, 50 ^ 2 / 360
  local UPPER = 50 / 2 * TOGETHER + LEFT
  for _, row in ipairs({ { 2, 100 }, { 3, 112.5 } }) do
    local high, speed = unpack(row)
    local lowest = (speed + 50) / 2 * TOGETHER + LEFT
    for rate, tolerance in pairs({ [30] = 0.1, [60] = 0.03, [144] = 0.01, [1000] = 0.001 }) do
      it(("goes as far as by hand, %d high, at %d Hz"):format(high, rate), function()
        for _, gap in ipairs({ 0.001, 1, 2, 3.3, 40 }) do
          local world, stack = physics.newWorld({ gravity = 900 }), {}
          world:add("floors", { x = -900, y = 0, width = 2000, height = 16, static = true })
          local box = { x = -gap, y = -16, width = 16, height = 16, vx = 150, mass = high }
          world:add("boxes", box)
          for n = 1, high do
            stack[n] = { x = 16, y = -16 * n, width = 16, height = 16, friction = 0.4 }
            world:add("boxes", stack[n])
          end
          for _ = 1, rate do
            world:update(1 / rate)
          end
          assert.near(lowest, stack[1].x - 16, tolerance)
          assert.equal(stack[1].x, box.x + 16)
          for n = 2, high do
            assert.near(UPPER, stack[n].x - 16, tolerance)
          end
        end
      end)
    end
  end

  local function play(seed, rate)
    local random, boxes = newRandom(seed), {}
    local world = physics.newWorld({ gravity = 900 })
    local floor = { x = -900, y = 0, width = 3000, height = 16, static = true }
    floor.friction = random:between(0.1, 0.6)
    world:add("floors", floor)
    local x, vx, high = random:between(-60, -16), random:between(60, 300), random:between(0, 30)
    local stacks = {
      { 0, math.floor(random:between(1, 5)), 0, 0 },
      { x, math.floor(random:between(1, 3)), vx, seed % 4 == 0 and high or 0 },
    }
    for _, stack in ipairs(stacks) do
      for n = 1, stack[2] do
        boxes[#boxes + 1] = world:add("boxes", {
          x = stack[1],
          y = -16 * n - stack[4],
          width = 16,
          height = 16,
          friction = random:between(0.1, 0.7),
          mass = random:between(0.5, 2.5),
          vx = stack[3],
        })
      end
    end
    for _ = 1, rate / 2 do
      world:update(1 / rate)
    end
    return boxes
  end

  local reference = newReference(play, 1500)
  for _, row in ipairs({ { 60, 0.1, 1.5 }, { 300, 0.01, 0.2 } }) do
    local rate, half, most = unpack(row)
    it(("is where small steps lead it, at %d Hz #slow"):format(rate), function()
      local apart = distances(play, 24, rate, reference)
      assert.is_true(apart[12] < half, ("half differ by up to %g px"):format(apart[12]))
      assert.is_true(apart[22] < most, ("nine of ten differ by up to %g px"):format(apart[22]))
    end)
  end
end)

describe("a box that falls on one that slides over a rough floor #slow", function()
  --     +--+           it is dragged along, and brakes the lower one: by what falls on it at once,
  --     +--+  v        by its weight from then on. The floor bears both, and brakes with them: in
  --                    the end with all that gravity has given both, whenever they met.
  --   +------+ 200 ->
  -- ===================
  local WEIGHT, TIME = 900, 0.4 -- of 1 kg; s
  local ROWS = { -- friction of the floor, drop (px), mass of the upper one
    { 0.1, 0.3, 1 },
    { 0.1, 3, 1 },
    { 0.1, 20, 1 },
    { 0.1, 20, 2 },
    { 0.4, 3, 2 },
    { 0.4, 20, 1 },
  }

  local function play(rate, floor, drop, mass)
    local world = physics.newWorld({ gravity = WEIGHT })
    local low = { x = 0, y = 100, width = 64, height = 16, friction = 0.4, vx = 200 }
    local high = { x = 30, y = 84 - drop, width = 16, height = 16, friction = 0.4, mass = mass }
    world:add("floors", {
      x = -900,
      y = 116,
      width = 2000,
      height = 16,
      static = true,
      friction = floor,
    })
    world:add("boxes", low)
    world:add("boxes", high)
    for _ = 1, TIME * rate do
      world:update(1 / rate)
    end
    assert.equal(84, high.y)
    return low, high
  end

  for _, row in ipairs(ROWS) do
    local exactLow, exactHigh
    local function reference()
      if not exactLow then
        exactLow, exactHigh = play(2400, unpack(row))
      end
      return exactLow, exactHigh
    end

    for rate, tolerance in pairs({ [30] = 0.1, [60] = 0.05, [240] = 0.02 }) do
      local text = "goes where small steps lead it: floor %g, drop %g px, mass %d, at %d Hz"
      it(text:format(row[1], row[2], row[3], rate), function()
        local itsLow, itsHigh = reference()
        local low, high = play(rate, unpack(row))
        assert.near(itsLow.x, low.x, tolerance)
        assert.near(itsHigh.x, high.x, tolerance)
        local mass = 1 + row[3]
        local left = 200 - math.sqrt(row[1] * 0.4) * WEIGHT * mass * TIME -- momentum, by hand
        assert.near(math.max(left, 0) / mass, low.vx, 1e-9)
        assert.near(low.vx, high.vx, 1e-9)
      end)
    end
  end
end)

describe("a stack of which the highest slides", function()
  -- Gravity 900, 0.1 s. Coefficients, from the floor up; masses; speeds, and ways by hand.
  local ROWS = {
    -- The lower one is pulled by 0.5 * 900 * 4, of which the floor bears 0.2 * 900 * 5.
    { "drags the lowest off the floor", { 0.2, 0.5 }, { 1, 4 }, { 0, 300 }, { 4.5, 27.75 } },
    -- 0.6 * 900 * 2: the second could be held with 0.6 * 900 * 3, the two only with 0.2 * 900 * 4.
    {
      "drags two off the floor that hold together",
      { 0.2, 0.6, 0.6 },
      { 1, 1, 2 },
      { 0, 0, 200 },
      { 0.9, 0.9, 17.3 },
    },
    -- 0.2 * 900 * 4 of the highest, where the second has 0.1 * 900 * 6 against it.
    {
      "drags the second off the lowest",
      { 0.3, 0.1, 0.2 },
      { 1, 2, 4 },
      { 0, 0, 100 },
      { 0, 0.45, 9.1 },
    },
    -- 0.3 * 900 * 5 on the lowest, of which 0.2 * 900 * 6 is borne. Without the weight of the
    -- highest, 0.3 * 900 would be.
    {
      "drags with what goes along",
      { 0.2, 0.3, 0.9 },
      { 1, 1, 4 },
      { 0, 200, 200 },
      { 1.35, 18.65, 18.65 },
    },
  }

  for _, row in ipairs(ROWS) do
    local name, rubs, masses, speeds, ways = unpack(row)
    for _, rate in ipairs({ 30, 60, 240, 1000 }) do
      it(("%s, at %d Hz"):format(name, rate), function()
        for side = -1, 1, 2 do
          local world, boxes, own = physics.newWorld({ gravity = 900 }), {}, 1
          world:add("floors", {
            x = -900,
            y = 0,
            width = 1800,
            height = 16,
            static = true,
            friction = own,
          })
          for n, rub in ipairs(rubs) do
            own = rub * rub / own -- that of a pair is the root of their product
            boxes[n] = { x = -100, y = -16 * n, width = 200, height = 16, mass = masses[n] }
            boxes[n].friction, boxes[n].vx = own, speeds[n] * side
            world:add("boxes", boxes[n])
          end
          for _ = 1, rate / 10 do
            world:update(1 / rate)
          end
          for n, box in ipairs(boxes) do
            assert.near(ways[n], (box.x + 100) * side, 1e-9)
          end
        end
      end)
    end
  end
end)

describe("a stack of which each slides at another speed #slow", function()
  local function play(seed, rate)
    local random, boxes = newRandom(seed), {}
    local world = physics.newWorld({ gravity = 900 })
    world:add("floors", {
      x = -3000,
      y = 0,
      width = 6000,
      height = 16,
      static = true,
      friction = random:between(0.1, 0.6),
    })
    for n = 1, math.floor(random:between(2, 6)) do
      boxes[n] = world:add("boxes", {
        x = 0,
        y = -16 * n,
        width = 200,
        height = 16,
        friction = random:between(0.1, 0.7),
        mass = random:between(0.5, 2.5),
        vx = random:between(-60, 240),
      })
    end
    -- Half of them get another one on top.
    if seed % 2 == 0 then
      local y = -16 * #boxes - 16 - random:between(1, 30)
      local top = { x = 90, y = y, width = 16, height = 16, friction = random:between(0.1, 0.7) }
      boxes[#boxes + 1] = world:add("boxes", top)
    end
    for _ = 1, 0.4 * rate do
      world:update(1 / rate)
    end
    return boxes
  end

  -- Each time that two reach one speed within a step is worth a part of it.
  local reference = newReference(play, 1500)
  for _, row in ipairs({ { 60, 0.1, 1.5 }, { 300, 0.01, 0.15 } }) do
    local rate, half, most = unpack(row)
    it(("goes where small steps lead it, at %d Hz #slow"):format(rate), function()
      local apart = distances(play, 20, rate, reference)
      assert.is_true(apart[10] < half, ("half differ by up to %g px"):format(apart[10]))
      assert.is_true(apart[20] < most, ("the worst differs by %g px"):format(apart[20]))
    end)
  end
end)

describe("a box that slides against what pulls it", function()
  --    <- 8 +--+ 125 px/s² ->     friction takes 0.05 * 250 = 12.5 px/s² off any motion:
  --         +--+                  8 / 137.5 s and 8² / 275 px back, then 112.5 px/s² forth
  --    ----------------
  for _, rate in ipairs({ 30, 60, 144, 240 }) do
    it(("turns where it stops, not a step later, at %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 250 })
      world:add("floors", { x = -50, y = 16, width = 200, height = 16, static = true })
      local box = { x = 0, y = 0, width = 16, height = 16, friction = 0.05, vx = -8, ax = 125 }
      world:add("boxes", box)
      for _ = 1, rate do
        world:update(1 / rate)
      end
      local left = 1 - 8 / 137.5
      assert.near(112.5 * left, box.vx, 1e-6)
      assert.near(112.5 * left * left / 2 - 8 * 8 / 275, box.x, 1e-6)
    end)
  end
end)

describe("a box that slides over two tiles at once", function()
  --      +--+ 100 ->      the second tile may be a one-way: such a contact is looked at in another
  --      +--+             way than a plain one, and comes at its place in the order all the same
  --   ----|====
  for _, y in ipairs({ 200, -1000 }) do
    for _, oneWay in ipairs({ 0, 1, 2 }) do
      local text = "at y = %d rubs on the first in order, if tile %d is a one-way"
      it(text:format(y, oneWay), function()
        for n, left in ipairs({ 86 + 2 / 3, 100 - math.sqrt(0.1) * 800 / 60 }) do
          local world = physics.newWorld({ gravity = 800 })
          for m = 1, 2 do
            world:add("tiles", {
              x = 20 * m,
              y = y,
              width = 20,
              height = 20,
              static = true,
              friction = m == n and 1 or 0.1,
              oneWay = m == oneWay and "top" or nil,
            })
          end
          local box = { x = 30, y = y - 20, width = 20, height = 20, friction = 1, vx = 100 }
          world:add("boxes", box)
          world:update(1 / 60)
          assert.near(left, box.vx, 1e-6)
          assert.equal(y - 20, box.y)
        end
      end)
    end
  end
end)

describe("a box that stands on two floors that rub differently", function()
  -- Rubs on the one that counts as its support, which carries it, too: the one under more of it.
  for _, row in ipairs({ { 1, 1 }, { 1, 2 }, { -1, 1 }, { -1, 2 } }) do
    local way, first = row[1], row[2]
    local name = ("to the %s, %s floor first"):format(
      way > 0 and "right" or "left",
      first == 1 and "the near" or "the far"
    )
    local function build(near, far, box)
      local world = physics.newWorld({ gravity = 800 })
      near.x, near.width = way > 0 and -500 or -100, 600
      far.x, far.width = way > 0 and 100 or -600, 500
      for n = 1, 2 do
        local floor = (n == first) and near or far
        floor.y, floor.height, floor.static = 116, 16, true
        world:add("floors", floor)
      end
      box.x, box.y, box.width, box.height = way > 0 and 40 or -56, 100, 16, 16
      box.friction = 0.5
      return world, world:add("boxes", box)
    end

    -- Comes to lie `beyond` px past where it is half on either floor, and up to a step at `speed`.
    local function comesToLie(world, box, rate, beyond, speed)
      for _ = 1, 5 * rate do
        world:update(1 / rate)
      end
      local past = (way > 0 and box.x or -box.x - 16) - 92
      assert.is_true(past >= beyond - 1e-6 and past <= beyond + speed / rate, "is at " .. past)
      assert.equal(0, box.vx)
    end

    for _, rate in ipairs({ 30, 60, 144 }) do
      it(("comes off a belt, %s, at %d Hz"):format(name, rate), function()
        local world, box = build({ surfaceSpeed = 60 * way }, {}, {})
        comesToLie(world, box, rate, 60 * 60 / 800, 60)
      end)

      it(("comes off the ice, %s, at %d Hz"):format(name, rate), function()
        local world, box = build({ friction = 0 }, { friction = 0.5 }, { vx = 100 * way })
        comesToLie(world, box, rate, 100 * 100 / 800, 100)
      end)
    end
  end
end)

describe("a box that slides on two stacks", function()
  --   60 ->+--+       gravity 800, friction 0.9 where it is under more of it, and so bears its
  --      +--+--+      weight: braked by 720 px/s². The other one is as high, but one crate, and
  --      |  +--+      smoother.
  --     =========
  for _, rate in ipairs({ 30, 60, 144, 240 }) do
    for _, way in ipairs({ 1, -1 }) do
      for first = 1, 2 do
        local text = "is braked by the one under more of it, the %s one, at %d Hz, to the %s"
        local order, side = first == 1 and "first" or "last", way > 0 and "right" or "left"
        it(text:format(order, rate, side), function()
          local world = physics.newWorld({ gravity = 800 })
          local function add(x, y, height, friction)
            local box = { x = way > 0 and x or -16 - x, y = y, width = 16, height = height }
            box.friction = friction
            return world:add("boxes", box)
          end
          world:add("floors", { x = -900, y = 116, width = 1800, height = 16, static = true })
          local smooth = first == 2 and add(-16, 84, 32, 0.1)
          local low, high = add(0, 100, 16, 0.9), add(0, 84, 16, 0.9)
          smooth = smooth or add(-16, 84, 32, 0.1)
          local box = add(-4, 68, 16, 0.9)
          world:update(1 / rate)
          box.vx = 60 * way
          for _ = 1, rate do
            world:update(1 / rate)
          end
          assert.near(-4 + 60 ^ 2 / 1440, way > 0 and box.x or -16 - box.x, 1e-9)
          assert.equal(0, box.vx)
          for x, other in pairs({ [0] = low, [-16] = smooth }) do
            assert.equal(way > 0 and x or -16 - x, other.x)
          end
          assert.equal(low.x, high.x)
        end)
      end
    end
  end
end)

describe("a tall box that hits a stack in the middle of a step", function()
  -- The same one of the two is pushed first at every rate, from either side. Rounding must not
  -- decide which face is met first, as both are met. (Where they are at 4800 Hz.)
  for _, rate in ipairs({ 30, 60, 144 }) do
    for _, way in ipairs({ 1, -1 }) do
      it(
        ("pushes both as always, at %d Hz, to the %s"):format(rate, way > 0 and "left" or "right"),
        function()
          local world = physics.newWorld({ gravity = 800 })
          local function add(x, y, width, height, vx, ax)
            local box = { x = way > 0 and x or -x - width, y = y, width = width, height = height }
            box.vx, box.ax, box.friction = way * vx, way * ax, 0.5
            return world:add("boxes", box)
          end
          world:add("floors", { x = -1000, y = 0, width = 2000, height = 40, static = true })
          local low, high = add(40, -15, 40, 15, 300, 0), add(40, -30, 40, 15, 300, 0)
          add(260, -40, 20, 40, -300, -600)
          for _ = 1, rate / 2 do
            world:update(1 / rate)
          end
          assert.near(111.1, way > 0 and low.x or -low.x - 40, 2.5)
          assert.near(115.9, way > 0 and high.x or -high.x - 40, 2.5)
        end
      )
    end
  end
end)

describe("a stack under a heavy box that slides off", function()
  --   300 ->+--+      gravity 800; masses 1, 1 and 5, frictions 1, 1 and 0.5, floor 1: the highest
  --         +--+      one slips, the two below stop together, by 5600 - 4000 * 0.5^0.5 for both.
  --         +--+
  --     ============
  it("stops as a whole", function()
    local far = 300 ^ 2 / (5600 - 4000 * math.sqrt(0.5))
    for _, rate in ipairs({ 30, 60, 144, 480 }) do
      for _, way in ipairs({ 1, -1 }) do
        local world = physics.newWorld({ gravity = 800 })
        local floor = { x = -1000, y = 0, width = 2000, height = 40, static = true, friction = 1 }
        world:add("floors", floor)
        local boxes = {}
        for n, row in ipairs({ { -10, 10, 1, 1 }, { -20, 10, 1, 1 }, { -35, 15, 5, 0.5 } }) do
          local box = { x = 0, y = row[1], width = 30, height = row[2], vx = 300 * way }
          box.mass, box.friction = row[3], row[4]
          boxes[n] = world:add("boxes", box)
        end
        for _ = 1, rate / 2 do
          world:update(1 / rate)
        end
        assert.near(far, boxes[1].x * way, 10 / rate)
        assert.near(boxes[1].x, boxes[2].x, 1e-9)
        assert.equal(0, boxes[1].vx)
      end
    end
  end)
end)

describe("a stack that slides from under its highest box", function()
  --          +--+      gravity 800; of mass 5, 5, 5 and 1, on a floor with 0.3. The highest one
  --   120 <- +--+      helps to brake the others, so that the lowest can hold those on it: only
  --          +--+      together they go as far as this.
  --          +--+
  --     ==============
  it("goes as far as by hand", function()
    local floor, top = 800 * math.sqrt(0.3 * 0.5), 800 * 0.9 -- px/s²
    local brake = (16 * floor + top) / 15
    local t = 120 / (brake + top) -- s, until all go at one speed
    local v = top * t
    local far = (120 + v) * t / 2 + v ^ 2 / (2 * floor)
    for _, rate in ipairs({ 30, 60, 144, 240 }) do
      for _, way in ipairs({ 1, -1 }) do
        local world = physics.newWorld({ gravity = 800 })
        world:add(
          "floors",
          { x = -900, y = 116, width = 1800, height = 16, static = true, friction = 0.3 }
        )
        local boxes = {}
        for n, friction in ipairs({ 0.5, 0.3, 0.9, 0.9 }) do
          boxes[n] = { x = 0, y = 116 - 16 * n, width = 16, height = 16, friction = friction }
          boxes[n].mass, boxes[n].vx = n < 4 and 5 or 1, n < 4 and 120 * way or 0
          world:add("boxes", boxes[n])
        end
        for _ = 1, rate do
          world:update(1 / rate)
        end
        for n = 1, 3 do
          assert.near(far, boxes[n].x * way, 2 / rate)
          assert.equal(0, boxes[n].vx)
        end
      end
    end
  end)
end)

describe("a box that runs into a crate next to it", function()
  --  100 ->+--+--+     gravity 800, friction 0.5; they go on together at 50 px/s. Alone they are
  --        +--+--+     braked by 400 px/s². What stands on the crate slides, and takes 800 from the
  --     ===========    two; all have 50 / 3 px/s after 1/24 s, and stop together.
  local ALONE, SLIP, LEFT = 50 ^ 2 / 800, (50 ^ 2 - (50 / 3) ^ 2) / 1600, (50 / 3) ^ 2 / 800
  local ROWS = {
    ["nothing on either"] = { ways = { ALONE, ALONE } },
    -- (The step in which the slip ends counts the crate alone, not what pushes it.)
    ["a box on the crate"] = {
      on = 16,
      ways = { SLIP + LEFT, SLIP + LEFT, 200 / 24 ^ 2 + LEFT },
      off = 0.02,
    },
    ["a box on itself"] = { on = 0, ways = { ALONE, ALONE, 100 ^ 2 / 800 } },
  }
  for name, row in pairs(ROWS) do
    for _, rate in ipairs({ 30, 60, 144, 240 }) do
      for _, way in ipairs({ 1, -1 }) do
        local text = "goes %s as it would by hand, with %s, at %d Hz"
        it(text:format(way > 0 and "right" or "left", name, rate), function()
          local world = physics.newWorld({ gravity = 800 })
          world:add("floors", { x = -900, y = 116, width = 1800, height = 16, static = true })
          local places = { { 0, 100 }, { 16, 100 }, row.on and { row.on, 84 } }
          local boxes = {}
          for n, place in ipairs(places) do
            local x = way > 0 and place[1] or -16 - place[1]
            boxes[n] = { x = x, y = place[2], width = 16, height = 16, friction = 0.5 }
            world:add("boxes", boxes[n])
          end
          world:update(1 / rate)
          boxes[1].vx = 100 * way
          if row.on == 0 then
            boxes[3].vx = 100 * way
          end
          for _ = 1, rate do
            world:update(1 / rate)
          end
          for n, far in ipairs(row.ways) do
            local x = way > 0 and places[n][1] or -16 - places[n][1]
            assert.near(far, way * (boxes[n].x - x), row.off or 1e-9)
            assert.equal(0, boxes[n].vx)
          end
        end)
      end
    end
  end
end)

describe("a box that leans on what friction holds", function()
  --   +--+--+       gravity 800, friction 0.5: the floor bears 400 px/s² of each kg of a crate, and
  --  -> 1| 1|       of what stands on it
  -- =========
  local function box(x, y, own)
    own.x, own.y, own.width, own.height = x, y, 16, 16
    return own
  end

  -- Plays a second of the boxes that `build` returns, on a rough floor; mirrored, if way is -1.
  -- `write` is called before each update.
  local function play(rate, way, push, build, write)
    local world = physics.newWorld({ gravity = 800, push = push })
    world:add("floors", { x = -900, y = 116, width = 1800, height = 16, static = true })
    local list = build()
    local places = {}
    for n, b in ipairs(list) do
      if way < 0 then
        b.x, b.ax, b.vx = -b.x - b.width, -(b.ax or 0), -(b.vx or 0)
      end
      world:add("boxes", b)
      places[n] = b.x
    end
    for _ = 1, rate do
      if write then
        write(list, way)
      end
      world:update(1 / rate)
    end
    local ways, speeds = {}, {}
    for n, b in ipairs(list) do
      ways[n], speeds[n] = way * (b.x - places[n]), way * b.vx
    end
    return ways, speeds, world
  end

  local function walk(list, way)
    list[1].vx = 60 * way
  end

  local HELD = {
    ["a crate that bears more"] = {
      build = function()
        return { box(0, 100, { ax = 399 }), box(16, 100, { friction = 0.5 }) }
      end,
    },
    ["a crate that bears just as much"] = {
      build = function()
        return { box(0, 100, { ax = 400 }), box(16, 100, { friction = 0.5 }) }
      end,
    },
    ["two crates that bear more together"] = {
      build = function()
        local crates = { box(16, 100, { friction = 0.5 }), box(32, 100, { friction = 0.5 }) }
        return { box(0, 100, { ax = 790 }), crates[1], crates[2] }
      end,
    },
    ["a heavy crate, at 60 px/s in each update"] = {
      build = function()
        return { box(0, 100, {}), box(16, 100, { friction = 0.5, mass = 22 }) }
      end,
      write = walk,
    },
    ["the lowest of a stack"] = {
      build = function()
        local list = { box(0, 100, { ax = 1590 }) }
        for n = 0, 3 do
          list[n + 2] = box(16, 100 - 16 * n, { friction = 0.5 })
        end
        return list
      end,
    },
    ["the third of a stack"] = {
      build = function()
        local list = { box(0, 68, { ax = 390, gravity = 0 }) }
        for n = 0, 2 do
          list[n + 2] = box(16, 100 - 16 * n, { friction = 0.5 })
        end
        return list
      end,
    },
  }
  for name, row in pairs(HELD) do
    for _, rate in ipairs({ 30, 60, 144 }) do
      for _, push in ipairs({ "both", "first" }) do
        for _, way in ipairs({ 1, -1 }) do
          local text = "does not move %s, at %d Hz, push = %q, %s"
          it(text:format(name, rate, push, way > 0 and "to the right" or "to the left"), function()
            local ways, speeds = play(rate, way, push, row.build, row.write)
            for n = 1, #ways do
              assert.near(0, ways[n], 1e-12)
              assert.is_true(speeds[n] == 0)
            end
          end)
        end
      end
    end
  end

  -- All of them go on at (ax - what friction bears) / mass.
  local MOVED = {
    ["a crate"] = { 50, { 500 }, 1, 16 },
    ["two crates"] = { 100 / 3, { 900 }, 2, 16 },
    ["a crate, with another behind"] = { 200 / 3, { 300, 300 }, 1, 16 },
  }
  for name, row in pairs(MOVED) do
    for _, rate in ipairs({ 30, 60, 144 }) do
      for _, way in ipairs({ 1, -1 }) do
        local side = way > 0 and "right" or "left"
        it(("pushes %s by the rest, at %d Hz, to the %s"):format(name, rate, side), function()
          local ways, speeds = play(rate, way, "both", function()
            local list = {}
            for _, ax in ipairs(row[2]) do
              list[#list + 1] = box(16 * #list, 100, { ax = ax })
            end
            for _ = 1, row[3] do
              list[#list + 1] = box(16 * #list, 100, { friction = 0.5 })
            end
            return list
          end)
          for n = 1, #ways do
            assert.near(row[1], speeds[n], 1e-9)
            -- (As long as friction would stop them within a step, it is thought to act at once,
            -- and not during the whole step.)
            assert.near(row[1] / 2, ways[n], 300 / rate ^ 2)
          end
        end)
      end
    end
  end

  for _, rate in ipairs({ 30, 60, 144 }) do
    it(("does not move it against one on the other side, at %d Hz"):format(rate), function()
      for _, pulls in ipairs({ { 700, -500 }, { 700, -700 }, { 2000, -1700 } }) do
        local ways, speeds = play(rate, 1, "both", function()
          local list = { box(0, 100, { ax = pulls[1] }), box(16, 100, { friction = 0.5 }) }
          list[3] = box(32, 100, { ax = pulls[2] })
          return list
        end)
        for n = 1, 3 do
          assert.near(0, ways[n], 1e-9)
          assert.equal(0, speeds[n])
        end
      end
    end)
  end

  it("pushes the highest of a stack, of which the lowest is smooth", function()
    -- The others bear 400 px/s² and more, the floor 0.005 * 4 * 800 = 16.
    local ways = play(60, 1, "both", function()
      local list = { box(0, 52, { ax = 240, gravity = 0 }) }
      for n = 0, 3 do
        list[n + 2] = box(16, 100 - 16 * n, { friction = 0.5 })
      end
      list[2].friction = 0.005
      return list
    end)
    assert.is_true(ways[1] > 3, "moves by " .. ways[1])
  end)

  it("pushes what stands on nothing", function()
    local _, speeds = play(60, 1, "both", function()
      return { box(0, 60, { vx = 60, gravity = 0 }), box(16, 60, { gravity = 0, friction = 0.5 }) }
    end)
    assert.near(30, speeds[1], 1e-9)
    assert.near(30, speeds[2], 1e-9)
  end)
end)

-- The two push as hard as each other, anew in every update, so nothing moves. One push comes first,
-- and gave the one between more than the other took back: it crept by up to 9 px/s.
--
--     > [ ] <
describe("a box between two that press it", function()
  local ROWS = {
    { name = "a player", friction = 0.5, isWritten = true, speed = 60 },
    { name = "a rough player", friction = 1, isWritten = true, speed = 60 },
    {
      name = "a rough player between rough ones",
      friction = 1,
      isWritten = true,
      speed = 60,
      on = 0.5,
    },
    { name = "a crate", friction = 0.5, speed = 150 },
    { name = "a rough crate", friction = 1, speed = 150 },
    { name = "a heavy crate", friction = 0.5, speed = 150, mass = 5 },
    { name = "a crate with another on it", friction = 0.5, speed = 150, isLoaded = true },
    -- (One of them comes first, and moves it until the other one is seen in the same step.)
    {
      name = "a crate that they reach from afar",
      friction = 0.3,
      speed = 150,
      gap = 3,
      off = 0.01,
    },
  }
  for _, row in ipairs(ROWS) do
    for _, rate in ipairs({ 30, 60, 144 }) do
      it(("goes nowhere: %s, at %d Hz"):format(row.name, rate), function()
        local world = physics.newWorld({ gravity = 800 })
        world:add("floors", { x = -500, y = 400, width = 1000, height = 16, static = true })
        local box = world:add("boxes", { x = 0, y = 376, width = 24, height = 24, mass = row.mass })
        local gap = row.gap or 0
        local left = world:add("boxes", { x = -20 - gap, y = 380, width = 20, height = 20 })
        local right = world:add("boxes", { x = 24 + gap, y = 380, width = 20, height = 20 })
        box.friction, left.friction, right.friction = row.friction, row.on, row.on
        if row.isLoaded then
          world:add("boxes", { x = 4, y = 360, width = 16, height = 16, friction = row.friction })
        end
        for step = 1, rate do
          box.vx = row.isWritten and 0 or box.vx
          left.vx, right.vx = row.speed, -row.speed
          world:update(1 / rate)
          assert.near(0, box.x, row.off or 1e-9)
          assert.near(0, box.vx, row.off and step <= rate / 6 and 0.3 or 1e-9)
          if step > rate / 6 then
            assert.equal(box.x - 20, left.x)
            assert.equal(box.x + 24, right.x)
            assert.equal(left, box.touching.left)
            assert.equal(right, box.touching.right)
          end
        end
      end)
    end
  end
end)

describe("a stack that slides over a rough floor", function()
  --  +--+ 200 ->      gravity 800, friction 0.5: it slows down by 400 px/s², as one box does, and
  --  +--+             lies after 200 / 400 s and 200² / 800 px
  --  +--+
  -- =========
  for _, rate in ipairs({ 30, 60, 144 }) do
    for _, masses in ipairs({ { 1, 1, 1 }, { 4, 1, 2 }, { 1, 8, 0.25 } }) do
      local text = "slows down as one box does, at %d Hz, with masses of %g, %g and %g"
      it(text:format(rate, masses[1], masses[2], masses[3]), function()
        local world = physics.newWorld({ gravity = 800 })
        world:add("floors", { x = -100, y = 116, width = 900, height = 16, static = true })
        local stack = {}
        for n, mass in ipairs(masses) do
          local box = { x = 0, y = 116 - 16 * n, width = 16, height = 16, vx = 200 }
          box.mass, box.friction = mass, 0.5
          stack[n] = world:add("boxes", box)
        end
        local steps = math.floor(0.25 * rate)
        for _ = 1, steps do
          world:update(1 / rate)
        end
        for n = 1, 3 do
          assert.near(200 - 400 * steps / rate, stack[n].vx, 1e-6)
        end
        for _ = 1, rate do
          world:update(1 / rate)
        end
        for n = 1, 3 do
          assert.near(50, stack[n].x, 1) -- as far as a single box may be off
          assert.near(stack[1].x, stack[n].x, 1e-6)
          assert.equal(0, stack[n].vx)
        end
      end)
    end
  end
end)

describe("a box that stands on a crate that is pushed over a rough floor", function()
  --         +--+        gravity 800, friction 0.5; the crate and what stands on it weigh as much as
  --  +--+---+--+---+    each pusher
  -- ->  |          |
  -- ================
  local function build(rate, way, pusher, heights, own)
    local world = physics.newWorld({ gravity = 800 })
    world:add("floors", { x = -2000, y = 116, width = 4000, height = 16, static = true })
    pusher.x, pusher.y, pusher.width, pusher.height = way > 0 and 0 or -16, 106, 16, 10
    pusher.vx, pusher.ax = way * (pusher.vx or 0), way * (pusher.ax or 0)
    world:add("pushers", pusher)
    local list, width = { pusher }, 64
    for n = 1, heights do
      local box = { x = way > 0 and 16 or -16 - width, y = 116 - 16 * n, height = 16 }
      box.width, box.mass, box.friction = width, 1, 0.5
      for name, value in pairs(own or {}) do
        box[name] = name == "vx" and way * value or value
      end
      list[#list + 1] = box
      world:add("boxes", box)
    end
    local function play(seconds)
      for _ = 1, seconds * rate do
        world:update(1 / rate)
      end
    end
    return list, play
  end

  for _, rate in ipairs({ 30, 60, 144 }) do
    for _, way in ipairs({ 1, -1 }) do
      local text = ", at %d Hz, to the " .. (way > 0 and "right" or "left")

      it(("goes along with it, if a lift pushes" .. text):format(rate), function()
        local list, play = build(rate, way, { kinematic = true, vx = 60 }, 3)
        play(1)
        local places = { list[2].x, list[3].x, list[4].x }
        play(2)
        for n = 1, 3 do
          assert.near(way * 120, list[n + 1].x - places[n], 1e-9)
          assert.near(way * 60, list[n + 1].vx, 1e-9)
        end
      end)

      it(("slips as long as the lift is faster" .. text):format(rate), function()
        -- 60 px/s at 400 px/s²: within 60 / 400 s by 60² / 800 px, but for the first step.
        local list, play = build(rate, way, { kinematic = true, vx = 60 }, 2)
        play(1)
        assert.near(4.5, way * (list[2].x - list[3].x), 60 / rate)
        assert.near(way * 60, list[3].vx, 1e-9)
      end)

      it(("goes along with it, if another box leans on it" .. text):format(rate), function()
        -- The floor takes 0.5 * 800 px/s² of the two: (1000 - 800) / 3 is left for all three.
        local list, play = build(rate, way, { ax = 1000 }, 2)
        play(1)
        for n = 1, 3 do
          assert.near(way * 200 / 3, list[n].vx, 1e-9)
        end
        local edge = way > 0 and list[2].x - 16 or list[2].x + 64
        assert.near(list[1].x, edge, 1e-9)
        assert.near(0, list[3].x - list[2].x, 1e-9)
      end)

      it(("slides off, if that is too fast for it" .. text):format(rate), function()
        -- 400 px/s² for the upper one; 0.5 * 800 * 2 of the floor and 400 of that for the lower.
        local list, play = build(rate, way, { ax = 3600 }, 2)
        play(0.25)
        local time = math.floor(0.25 * rate) / rate
        assert.near(way * 400 * time, list[3].vx, 400 / rate)
        assert.near(way * (3600 - 1200) / 2 * time, list[2].vx, 1200 / rate)
      end)
    end
  end

  it("goes along in a row of such crates, too", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("floors", { x = -100, y = 116, width = 900, height = 16, static = true })
    world:add("lifts", { x = -16, y = 108, width = 16, height = 8, kinematic = true, vx = 60 })
    local list = {}
    for n = 0, 8 do
      local box = { x = 16 * math.floor(n / 3), y = 100 - 16 * (n % 3), width = 16, height = 16 }
      box.friction = 0.5
      list[n + 1] = world:add("boxes", box)
    end
    for _ = 1, 60 do
      world:update(1 / 60)
    end
    local places = {}
    for n = 1, 9 do
      places[n] = list[n].x
    end
    for _ = 1, 120 do
      world:update(1 / 60)
    end
    for n = 1, 9 do
      assert.near(120, list[n].x - places[n], 1e-6)
      assert.equal(84 + 16 - 16 * ((n - 1) % 3), list[n].y)
    end
  end)
end)

describe("a push with friction under it", function()
  -- Found by a review: each once made speed or way out of nothing.
  it("moves nothing further than what pushes, if they hardly close", function()
    local world = physics.newWorld({ gravity = 600 })
    world:add("floors", { x = -3000, y = 100, width = 6000, height = 50, static = true })
    local list = {}
    for n = 0, 3 do
      local box = { x = n < 3 and -5 - 20 * n or -5, y = n < 3 and 80 or 60 }
      box.width, box.height, box.friction = 20, 20, 1
      list[n + 1] = world:add("crates", box)
    end
    world:add("players", { x = -65 - 10 / 3, y = 76, width = 20, height = 24, vx = 100 })
    for _ = 1, 30 do
      world:update(1 / 60)
    end
    for _, box in ipairs(list) do
      assert.equal(0, box.vx)
    end
    assert.is_true(list[1].x >= -5 and list[1].x < -4, "is at " .. list[1].x)
  end)

  for _, mass in ipairs({ 5, 100, 1000 }) do
    it(("makes nothing faster, under a box of mass %d"):format(mass), function()
      local world, list = physics.newWorld({ gravity = 1600 }), {}
      world:add("floors", { x = -2000, y = 100, width = 4000, height = 50, static = true })
      for n, x in ipairs({ 0, 0, 20 }) do
        local box = { x = x, y = n == 2 and 60 or 80, width = 20, height = 20, friction = 1 }
        box.mass = n == 2 and mass or 1
        list[n] = world:add("crates", box)
      end
      local player = { x = -20, y = 76, width = 20, height = 24, mass = 1000 }
      world:add("players", player)
      for _ = 1, 120 do
        player.vx = 200
        world:update(1 / 60)
        for _, box in ipairs(list) do
          assert.is_true(math.abs(box.vx) <= 200, "goes at " .. box.vx)
        end
      end
    end)
  end
end)

describe("a stack on a floor that is rougher than it is itself", function()
  for _, floor in ipairs({ 0.51, 1, 2 }) do
    it(("lets its lowest one stop first, with %g"):format(floor), function()
      local function slide(count)
        local world, list = physics.newWorld({ gravity = 800 }), {}
        local ground = { x = -100, y = 100, width = 900, height = 50, static = true }
        ground.friction = floor
        world:add("floors", ground)
        for n = 1, count do
          local box = { x = 0, y = 100 - 20 * n, width = 20, height = 20, friction = 0.5, vx = 300 }
          list[n] = world:add("boxes", box)
        end
        for _ = 1, 180 do
          world:update(1 / 60)
        end
        return list
      end
      local alone, pair = slide(1)[1], slide(2)
      assert.is_true(pair[1].x <= alone.x, pair[1].x .. " instead of " .. alone.x)
      assert.is_true(pair[2].x > pair[1].x)
      assert.equal(0, pair[1].vx)
      assert.equal(0, pair[2].vx)
    end)
  end
end)

describe("a stack on a belt that a lift pushes the other way", function()
  it("goes along with the lift, also where that touches the upper one", function()
    local world = physics.newWorld({ gravity = 800 })
    local belt = { x = -900, y = 100, width = 1800, height = 50, static = true, surfaceSpeed = -20 }
    world:add("belts", belt)
    local low = { x = 0, y = 80, width = 30, height = 20, friction = 1 }
    local high = { x = 0, y = 60, width = 30, height = 20, friction = 1 }
    world:add("boxes", low)
    world:add("boxes", high)
    world:add("lifts", { x = -37, y = 76, width = 20, height = 24, kinematic = true, vx = 50 })
    for n = 1, 40 do
      world:update(1 / 30)
      if n > 10 then
        assert.near(50, low.vx, 1e-9)
        assert.near(low.x, high.x, 1e-9)
      end
    end
  end)
end)

describe("a tower that slides on a crate", function()
  --     +--+           friction 0.5, gravity 800: it is braked by 400 px/s², and pulls at the crate
  --     +--+ 120 ->    by 400 for each kg, however high it is; that is as firm as its 8 kg
  --     +--+
  --   +------+
  -- ============
  for _, height in ipairs({ 1, 2, 4 }) do
    for _, rate in ipairs({ 30, 60, 144 }) do
      for _, way in ipairs({ 1, -1 }) do
        local side = way > 0 and "right" or "left"
        local text = "comes to stand after 18 px, %d high, at %d Hz, to the %s"
        it(text:format(height, rate, side), function()
          local world = physics.newWorld({ gravity = 800 })
          world:add("floors", { x = -90, y = 116, width = 180, height = 16, static = true })
          local crate = { x = -40, y = 100, width = 80, height = 16, friction = 0.5, mass = 8 }
          world:add("boxes", crate)
          local tower = {}
          for n = 1, height do
            local box = { x = -8, y = 100 - 16 * n, width = 16, height = 16, friction = 0.5 }
            box.vx = 120 * way
            tower[n] = world:add("boxes", box)
          end
          for _ = 1, rate do
            world:update(1 / rate)
          end
          assert.equal(-40, crate.x)
          for _, box in ipairs(tower) do
            assert.near(18, way * (box.x + 8), 1e-2)
            assert.equal(0, box.vx)
          end
        end)
      end
    end
  end

  -- Returns a world, a box in it that is to push, and the stack of four that it does, from below.
  local function pushed(mass, floorFriction)
    local world = physics.newWorld({ gravity = 800 })
    local floor = { x = -90, y = 116, width = 580, height = 16, static = true }
    floor.friction = floorFriction
    world:add("floors", floor)
    local pusher = { x = -16, y = 100, width = 16, height = 16, mass = mass }
    world:add("boxes", pusher)
    local boxes = {}
    for n = 0, 3 do
      local box = { x = 0, y = 100 - 16 * n, width = 16, height = 16, friction = 0.7 }
      boxes[n] = world:add("boxes", box)
    end
    return world, pusher, boxes
  end

  it("slips by 10 / 7 px if the crate is pushed at 40 px/s, in small steps", function()
    local world, pusher, boxes = pushed(1e6)
    for _ = 1, 480 do
      pusher.vx = 40
      world:update(1 / 960)
    end
    for n = 1, 3 do
      assert.near(40 ^ 2 / 2 / (0.7 * 800), boxes[0].x - boxes[n].x, 2e-3)
      assert.equal(boxes[0].vx, boxes[n].vx)
    end
  end)

  for _, vx in ipairs({ 4, 8 }) do
    for _, rate in ipairs({ 30, 60 }) do
      it(("goes along to the bit, pushed at %d px/s, at %d Hz"):format(vx, rate), function()
        -- Smoother than the stack, as rough, and rougher.
        for _, floorFriction in ipairs({ 0.3, 0.7, 0.9 }) do
          local world, pusher, boxes = pushed(99, floorFriction)
          for _ = 1, 2 * rate do
            pusher.vx = vx
            world:update(1 / rate)
            for n = 1, 3 do
              assert.equal(boxes[0].x, boxes[n].x)
            end
          end
          assert.is_true(boxes[0].x > vx)
        end
      end)
    end
  end
end)

describe("a tower that is hit above its lowest box", function()
  --      +--+           a light box under heavy ones is dragged along the floor, which can only
  --      +--+           take momentum from all of them
  --    +------+ <- 139
  --    +------+--+
  --     |  |
  -- ==============
  for _, high in ipairs({ 0, 1, 2 }) do
    for _, way in ipairs({ 1, -1 }) do
      local text = "only loses momentum, with %d on top, hit to the %s"
      it(text:format(high, way > 0 and "right" or "left"), function()
        local world = physics.newWorld({ gravity = 800 })
        world:add("floors", { x = -900, y = 116, width = 1800, height = 16, static = true })
        local boxes = {}
        local function box(x, y, width, height, friction, mass, vx)
          x = way > 0 and -x - width or x
          local own = { x = x, y = y, width = width, height = height, friction = friction }
          own.mass, own.vx = mass, way * vx
          boxes[#boxes + 1] = world:add("boxes", own)
        end
        box(0, 92, 16, 24, 0.5, 0.1, 0)
        box(0, 76, 48, 16, 1, 1, 0)
        for n = 1, high do
          box(n == 1 and 8 or 0, 76 - 16 * n, 16, 16, 0.5, 1, 0)
        end
        box(56, 84, 16, 16, 0.5, 1, 139)
        local before = 139
        for _ = 1, 60 do
          world:update(1 / 30)
          local momentum = 0
          for _, b in ipairs(boxes) do
            momentum = momentum + way * b.mass * b.vx
          end
          assert.is_true(momentum <= before + 1e-9, momentum .. " after " .. before)
          before = momentum
        end
        assert.equal(0, before)
      end)
    end
  end
end)

describe("stacks that push each other #slow", function()
  -- What comes of it cannot be worked out by hand any more: it is what very small steps lead to, as
  -- far as a step is long.
  -- By column, from the lowest up: friction, mass, ax, vx, height if it is not 16.
  local ROWS = {
    ["a stack on a smooth box that runs into another box"] = {
      floor = 0.9,
      { { 0.1, 5, 0, 60 }, { 0.9, 1, 0, 60 }, { 0.9, 1, 0, 60 } },
      { { 0.9, 2, 0, 0 } },
    },
    ["stacks driven by a heavy one that touches two of the first"] = {
      floor = 0.5,
      { { 0.5, 100, 3000, 200, 32 } },
      { { 0.5, 1, 0, 0 }, { 0.3, 1, 0, 0 } },
      { { 0.3, 1, 0, 0 }, { 0.5, 1, 0, 0 } },
      { { 0.5, 1, 0, 0 } },
    },
    ["stacks driven by one that slides, and touches two of the first"] = {
      floor = 0.1,
      { { 0.5, 5, 3000, 200, 32 } },
      { { 0.3, 1, 0, 0 }, { 0.3, 1, 0, 0 } },
      { { 0.9, 1, 0, 0 }, { 0.9, 1, 0, 0 } },
      { { 0.5, 1, 0, 0 }, { 0.5, 1, 0, 0 } },
    },
    ["a stack of which the upper two slide as one"] = {
      floor = 0.9,
      { { 0.5, 5, 0, 120 }, { 0.5, 5, 0, 120 }, { 0.9, 5, 0, 120 } },
      { { 0.5, 2, -400, 0 } },
    },
    ["a smooth crate under two rough ones"] = {
      floor = 0.9,
      { { 0.1, 2, 0, 60 }, { 0.5, 1, 0, 60 }, { 0.5, 1, 0, 60 } },
      { { 0.1, 2, 0, 0 } },
    },
    ["a stack that pushes a higher one"] = {
      floor = 0.1,
      { { 0.3, 2, 0, 60 }, { 0.5, 2, 0, 60 } },
      { { 0.1, 1, 0, 0 }, { 0.9, 1, 0, 0 }, { 0.5, 1, 0, 0 } },
    },
    ["a tall box that drives three stacks of two"] = {
      floor = 0.3,
      { { 0.5, 5, 3000, 200, 32 } },
      { { 0.9, 1, 0, 0 }, { 0.3, 1, 0, 0 } },
      { { 0.3, 1, 0, 0 }, { 0.3, 1, 0, 0 } },
      { { 0.3, 1, 0, 0 }, { 0.9, 1, 0, 0 } },
    },
    ["stacks of which the upper ones are driven apart, and stop"] = {
      floor = 0.3,
      { { 0.5, 5, 400, 60 }, { 0.3, 5, 0, 60 } },
      { { 0.1, 2, 100, 0 }, { 0.9, 2, -400, 0 } },
    },
    ["stacks that hold each other"] = {
      floor = 0.5,
      { { 0.1, 1, -400, 0 }, { 0.1, 1, 1500, 0 }, { 0.5, 2, 0, 0 } },
      { { 0.5, 1, 0, 0 }, { 0.3, 2, -400, 0 } },
    },
  }

  -- Returns where all of them are after half a second; mirrored, if way is -1.
  local function play(row, rate, way)
    local world, boxes = physics.newWorld({ gravity = 800 }), {}
    world:add(
      "floors",
      { x = -900, y = 116, width = 1800, height = 16, static = true, friction = row.floor }
    )
    for column, stack in ipairs(row) do
      for level, own in ipairs(stack) do
        local height = own[5] or 16
        local box = { y = 132 - 16 * level - height, width = 16, height = height }
        box.x = way > 0 and 16 * column or -16 - 16 * column
        box.friction, box.mass, box.ax, box.vx = own[1], own[2], way * own[3], way * own[4]
        boxes[#boxes + 1] = world:add("boxes", box)
      end
    end
    for _ = 1, rate / 2 do
      world:update(1 / rate)
    end
    local places = {}
    for n, box in ipairs(boxes) do
      places[n] = way > 0 and box.x or -16 - box.x
    end
    return places
  end

  for name, row in pairs(ROWS) do
    local small
    for _, rate in ipairs({ 30, 60, 144 }) do
      for _, way in ipairs({ 1, -1 }) do
        local text = "go as in small steps, %s, at %d Hz, to the %s #slow"
        it(text:format(name, rate, way > 0 and "right" or "left"), function()
          small = small or play(row, 2400, 1)
          for n, x in ipairs(play(row, rate, way)) do
            assert.near(small[n], x, 10 / rate)
          end
        end)
      end
    end
  end
end)

describe("one box", function()
  local turn = require("spec.support.turn")

  -- Plays `seconds` of a scene on a floor at y = 0, turned so that gravity points to each side,
  -- with both ways to push. `check(placeOf, box, others)` is called at the end: `placeOf(object)`
  -- returns x, y, vx and vy as if gravity pointed down.
  local function each(rate, seconds, floor, fields, others, check)
    for count = 0, 3 do
      for _, push in ipairs({ "both", "first" }) do
        local gx, gy = turn.vector(count, 0, 1000)
        local world = physics.newWorld({ gravityX = gx, gravity = gy, push = push })
        local function add(group, object)
          local copy = {}
          for name, value in pairs(object) do
            copy[name] = value
          end
          copy.x, copy.y, copy.width, copy.height =
            turn.box(count, object.x, object.y, object.width, object.height)
          copy.vx, copy.vy = turn.vector(count, object.vx or 0, object.vy or 0)
          copy.ax, copy.ay = turn.vector(count, object.ax or 0, object.ay or 0)
          return world:add(group, copy)
        end
        floor.x, floor.y, floor.width, floor.height, floor.static = -2000, 0, 4000, 20, true
        add("floors", floor)
        fields.x, fields.y, fields.width, fields.height = 0, -20, 20, 20
        local box, more = add("boxes", fields), {}
        for n, other in ipairs(others or {}) do
          more[n] = add("boxes", other)
        end
        for _ = 1, seconds * rate do
          world:update(1 / rate)
        end
        local function placeOf(object)
          local x, y = turn.box(turn.back(count), object.x, object.y, object.width, object.height)
          local vx, vy = turn.vector(turn.back(count), object.vx, object.vy)
          return x, y, vx, vy
        end
        check(placeOf, box, more)
      end
    end
  end

  for _, rate in ipairs({ 30, 60, 144 }) do
    it(("slides and stops as by hand under each gravity, at %d Hz"):format(rate), function()
      each(rate, 1, { friction = 0.3 }, { vx = 240, friction = 0.3 }, nil, function(placeOf, box)
        local x, y, vx = placeOf(box)
        assert.near(240 ^ 2 / 600, x, 1e-9)
        assert.near(-20, y, 1e-9)
        assert.near(0, vx, 0)
      end)
    end)

    it(("slows down by air and floor as by hand, at %d Hz"):format(rate), function()
      -- v' = -2 v - 300, until it stands: after log(5) / 2 s.
      local time = math.log(5) / 2
      local way = 375 * (1 - math.exp(-2 * time)) - 150 * time
      local fields = { vx = 600, friction = 0.3, airFriction = 2 }
      each(rate, 1, {}, fields, nil, function(placeOf, box)
        local x, _, vx = placeOf(box)
        assert.near(way, x, 1e-8)
        assert.near(0, vx, 0)
      end)
    end)

    it(("hangs on the wall that it is pressed to, at %d Hz"):format(rate), function()
      -- 0.5 * 2100 px/s² bear more than its weight.
      local wall = { x = 20, y = -500, width = 20, height = 490, static = true, friction = 0.5 }
      local hanging = { x = 0, y = -300, width = 20, height = 20, friction = 0.5, ax = 2100 }
      each(rate, 1, {}, {}, { wall, hanging }, function(placeOf, _, more)
        local x, y, _, vy = placeOf(more[2])
        assert.near(0, x, 1e-12)
        assert.near(-300, y, 1e-12)
        assert.near(0, vy, 0)
      end)
    end)

    it(("pushes a crate with its engine as by hand, at %d Hz"):format(rate), function()
      -- (1200 - 300) / 3 px/s² for both, as the crate has 2/3 of the mass, and rubs with 0.15.
      local crate = { x = 20, y = -20, width = 20, height = 20, mass = 2, friction = 0.15 }
      each(
        rate,
        1,
        { friction = 0.15 },
        { ax = 1200, friction = 0 },
        { crate },
        function(placeOf, box, more)
          local x, _, vx = placeOf(box)
          assert.near(150, x, 1e-9)
          assert.near(300, vx, 1e-9)
          assert.near(170, (placeOf(more[1])), 1e-9)
        end
      )
    end)
  end

  for _, rate in ipairs({ 30, 60, 144, 1000 }) do
    it(("falls as fast as its maxSpeedY through air as by hand, at %d Hz"):format(rate), function()
      -- v' = 1000 - v / 2 until it goes at 300 px/s.
      local world = physics.newWorld({ gravity = 1000 })
      local fields = { x = 0, y = 0, width = 9, height = 9, airFriction = 0.5, maxSpeedY = 300 }
      local box = world:add("boxes", fields)
      for _ = 1, rate do
        world:update(1 / rate)
      end
      local time = -math.log(1 - 0.15) / 0.5
      local way = 2000 * time - 4000 * (1 - math.exp(-0.5 * time)) + 300 * (1 - time)
      assert.near(way, box.y, 1e-8)
      assert.equal(300, box.vy)
    end)
  end
end)

describe("stacks of different sizes, masses and speeds", function()
  local function build(seed, isIce)
    local random, boxes, x = newRandom(seed), {}, 0
    local world = physics.newWorld({ gravity = 900, push = seed % 2 == 0 and "first" or "both" })
    local rub = isIce and 0 or random:between(0.1, 1)
    world:add(
      "floors",
      { x = -9000, y = 0, width = 18000, height = 16, static = true, friction = rub }
    )
    for _ = 1, math.floor(random:between(1, 5)) do
      local top, vx = 0, random:between(-200, 200)
      local isEach = random:between(0, 1) < 0.5
      for _ = 1, math.floor(random:between(1, 5)) do
        local box = { x = x, width = random:between(10, 40), height = random:between(8, 24) }
        top = top - box.height
        box.y, box.friction = top, random:between(0, 1)
        box.mass = random:between(0, 1) < 0.2 and random:between(0.05, 20)
          or random:between(0.5, 2.5)
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

describe("stacks beside other stacks, far away,", function()
  local function add(world, seed, left, boxes)
    local random, x = newRandom(seed), left
    local floor = { x = left - 400, y = 0, width = 900, height = 16, static = true }
    floor.friction = random:between(0, 1)
    world:add("floors", floor)
    for _ = 1, math.floor(random:between(1, 5)) do
      local y = 0
      for _ = 1, math.floor(random:between(1, 6)) do
        local box = { x = x, width = random:integer(10, 40), height = random:integer(8, 24) }
        y = y - box.height
        box.y, box.friction, box.mass = y, random:between(0, 1), random:between(0.5, 3)
        box.vx = random:between(0, 1) < 0.5 and random:between(-200, 200) or 0
        box.ax = random:between(0, 1) < 0.3 and random:between(-900, 900) or 0
        box.restitution = random:between(0, 1) < 0.15 and 1 or nil
        boxes[#boxes + 1] = world:add("boxes", box)
      end
      x = x + 40
    end
  end

  it("are tried as often as those need it, and come out the same to the bit #slow", function()
    for seed = 1, 40 do
      local together, alone =
        physics.newWorld({ gravity = 900 }), physics.newWorld({ gravity = 900 })
      local boxes, same = {}, {}
      add(together, seed, 4096, boxes)
      add(together, seed + 1000, 0, {})
      add(alone, seed, 4096, same)
      for step = 1, 60 do
        together:update(1 / 60)
        alone:update(1 / 60)
        for n, box in ipairs(boxes) do
          local isSame = box.x == same[n].x and box.y == same[n].y and box.vx == same[n].vx
          assert.is_true(isSame, ("seed %d, step %d, box %d"):format(seed, step, n))
        end
      end
    end
  end)
end)

describe("friction of a stack", function()
  -- The lowest box bears all four kg, as on a floor: 0.4 * 4 * 900 px/s² for a sixtieth.
  it("on a slope is that of its whole weight, in every order of adding", function()
    for order = 1, 2 do
      local world = physics.newWorld({ gravity = 900 })
      local hill = { x = 0, y = 100, width = 400, height = 200, static = true, slope = "right" }
      world:add("ground", hill)
      local low = { x = 266, y = 146, width = 14, height = 14, friction = 0.4 }
      local high = { x = 266, y = 132, width = 14, height = 14, friction = 0, mass = 3 }
      world:add("boxes", order == 1 and low or high)
      world:add("boxes", order == 1 and high or low)
      for _ = 1, 60 do
        world:update(1 / 60)
      end
      low.vx, high.vx = 100, 100
      world:update(1 / 60)
      assert.near(76, low.vx, 1e-9)
      assert.equal(100, high.vx)
    end
  end)

  --   +-+          a crate on a raft that nothing immovable bears: gravity presses it all the same
  --  =====  60 ->
  -- ~~~~~~~
  it("acts on what floats, hovers or cannot be pushed", function()
    local RAFTS = {
      { gravity = 0, mass = 1000 },
      { gravity = 0, pushable = false, mass = 1000 },
      { mass = 1000, ay = -800.8 }, -- its jet bears the crate, too
    }
    for _, raft in ipairs(RAFTS) do
      local world = physics.newWorld({ gravity = 800 })
      raft.x, raft.y, raft.width, raft.height, raft.friction = 0, 100, 200, 16, 1
      local crate = { x = 90, y = 84, width = 16, height = 16, friction = 1 }
      world:add("rafts", raft)
      world:add("crates", crate)
      for _ = 1, 60 do
        raft.vx = 60
        world:update(1 / 60)
      end
      assert.near(60 - 60 ^ 2 / 1600, crate.x - 90, 0.1)
      assert.near(raft.vx, crate.vx, 1e-9)
    end
  end)

  --     +--+
  --  70 |  +--+      in every order of adding, none is faster than the one below it
  --  -> |  +--+
  -- ===============
  it("lets none be faster than what bears it, when it is pushed", function()
    for _, high in ipairs({ 3, 4, 6 }) do
      for pushed = 1, high do
        local speeds
        for order = 0, 3 do
          local world, crates = physics.newWorld({ gravity = 800 }), {}
          world:add("floors", { x = -900, y = 0, width = 2000, height = 16, static = true })
          local size = 16 * pushed
          local pusher = { x = 0, y = -size, width = 16, height = size, friction = 0 }
          for n = 1, high do
            local at = order % 2 == 0 and n or high + 1 - n
            crates[at] = { x = 16, y = -16 * at, width = 16, height = 16, friction = 0.4 }
            world:add("crates", crates[at])
          end
          world:add(order < 2 and "a" or "pushers", pusher)
          for _ = 1, 5 do
            pusher.vx = 70
            world:update(1 / 60)
          end
          for n = 2, high do
            assert.is_true(crates[n].vx <= crates[n - 1].vx + 1e-9)
          end
          speeds = speeds or crates[high].vx
          assert.near(speeds, crates[high].vx, 1e-9)
        end
      end
    end
  end)
end)
