--- Wedges: rooms that a slope narrows. Objects that stand still crush none, and let all objects
--- out.

local physics = require("physics")
local overlap = require("spec.support.overlap")
local small = require("spec.support.small")

local tile, RATES = small.tile, { 30, 60, 144 }

local function slope(world, x, y, width, height, name)
  return world:add("slopes", tile(x, y, width, height, { slope = name }))
end

local function count(hero)
  hero.crushes = 0
  function hero.onCrush()
    hero.crushes = hero.crushes + 1
  end
  return hero
end

-- Steers for so many seconds, in each step anew.
local function steer(world, object, seconds, rate, fields)
  for _ = 1, math.floor(seconds * rate + 0.5) do
    small.set(object, fields)
    world:update(1 / rate)
  end
end

local function assertAt(x, y, object)
  assert.near(x, object.x, 1e-9)
  assert.near(y, object.y, 1e-9)
end

describe("slope: a wedge", function()
  for _, rate in ipairs(RATES) do
    --  __________________
    --  [hero]->  \      |     seen from above: the slope turns it up, the wall stops it
    it(
      ("stops a hero between a wall and a slanted one, and lets it out: %d Hz"):format(rate),
      function()
        local world = physics.newWorld({ gravity = 0 })
        world:add("walls", tile(0, 0, 300, 16))
        slope(world, 100, 16, 64, 32, "right")
        local hero = count(world:add("heroes", { x = 40, y = 20, width = 16, height = 16 }))
        steer(world, hero, 2, rate, { vx = 120, vy = 0 })
        assertAt(116, 16, hero)
        assert.is_truthy(hero.touching.right and hero.touching.top)
        steer(world, hero, 0.5, rate, { vx = -120, vy = 0 })
        assertAt(56, 16, hero)
        assert.equal(0, hero.crushes)
      end
    )

    it(("stops a dash under a ceiling, and lets it out: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("tiles", tile(0, 208, 400, 16))
      world:add("tiles", tile(116, 192, 100, 16))
      world:add("tiles", tile(60, 160, 200, 16))
      slope(world, 100, 192, 16, 16, "right")
      local hero = count(world:add("heroes", { x = 20, y = 184, width = 12, height = 24 }))
      steer(world, hero, 0.2, rate, { vx = 600, vy = 0, gravity = 0 })
      assertAt(96, 176, hero)
      hero.gravity = nil
      steer(world, hero, 0.5, rate, { vx = -130 })
      assertAt(31, 184, hero)
      assert.equal(0, hero.crushes)
    end)

    it(("stops what walks over a crate below a ceiling: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("tiles", tile(0, 208, 400, 16))
      local crate = world:add("crates", { x = 60, y = 192, width = 32, height = 16 })
      world:add("tiles", tile(92, 192, 64, 16))
      slope(world, 80, 160, 16, 16, "topright")
      local hero = count(world:add("heroes", { x = 62, y = 168, width = 12, height = 24 }))
      steer(world, hero, 2, rate, { vx = 130 })
      assertAt(76, 168, hero)
      assert.same({ 192, 0 }, { crate.y, hero.crushes })
    end)

    it(("stops a jump with the key held below a ceiling: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("tiles", tile(0, 304, 400, 16))
      slope(world, 128, 272, 16, 16, "topright")
      local hero = count(world:add("heroes", { x = 60, y = 280, width = 12, height = 24 }))
      steer(world, hero, 1.5, rate, { vx = 130 })
      hero.vy = -318
      steer(world, hero, 1.5, rate, { vx = 130 })
      assertAt(124, 280, hero)
      assert.equal(0, hero.crushes)
    end)

    it(("holds back a rider on a train that drives below it: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("lifts", { x = -200, y = 192, width = 300, height = 16, kinematic = true, vx = 60 })
      slope(world, 80, 160, 16, 16, "topright")
      local hero = count(world:add("heroes", { x = 10, y = 168, width = 12, height = 24 }))
      small.play(world, 3, rate)
      assertAt(76, 168, hero)
      assert.is_truthy(hero.touching.right and hero.touching.bottom)
      assert.equal(0, hero.crushes)
    end)

    --                \       |
    --  ->[   ][ 1 ]   \      |     crate 1 fits exactly between the places at which the slope stops
    --    [   ][   ][ 2 ]\    |     the hero and crate 2, but for 0.09 px
    --  ___________________________
    it(("stops a hero that pushes two crates into it: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("tiles", tile(0, 60, 300, 16))
      slope(world, 100, 27, 57, 33, "topright")
      local hero = count(world:add("heroes", { x = 20, y = 36, width = 12, height = 24 }))
      local one = count(world:add("crates", { x = 40, y = 44, width = 13, height = 16 }))
      local two = count(world:add("crates", { x = 60, y = 51, width = 13, height = 9 }))
      steer(world, hero, 2, rate, { vx = 120 })
      local right = 100 + 24 * 57 / 33
      assertAt(right - 13, 51, two)
      assertAt(right - 26, 44, one)
      assertAt(right - 38, 36, hero)
      assert.equal(0, hero.crushes + one.crushes + two.crushes)
    end)

    --  ______________________
    --     [crate]
    --    .-'  [hero] <-         the slope and the ceiling hold the crate, which holds the hero
    --  -'   .-'
    it(("stops a hero below a crate that it has pushed there: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("tiles", tile(-100, 60, 500, 16))
      world:add("tiles", tile(-100, 18, 500, 8))
      slope(world, 100, 11, 40, 49, "left")
      local hero = count(world:add("heroes", { x = 165, y = 48, width = 10, height = 12 }))
      local crate = count(world:add("crates", { x = 145, y = 51, width = 14, height = 9 }))
      steer(world, hero, 2, rate, { vx = -60 })
      assertAt(100 + 24 * 40 / 49, 26, crate)
      assertAt(100 + 36 * 40 / 49, 35, hero)
      assert.equal(0, hero.crushes + crate.crushes)
      steer(world, hero, 1, rate, { vx = 60 })
      assertAt(100 + 36 * 40 / 49 + 60, 48, hero)
    end)

    it(("stops what flies into it behind another one: %d Hz"):format(rate), function()
      for height = 10, 16, 2 do
        local world = physics.newWorld({ gravity = 0 })
        world:add("tiles", tile(-100, 15, 500, 8))
        world:add("tiles", tile(-100, 60, 500, 8))
        slope(world, 100, 16, 83, 44, "left")
        local speed, y = -18 * rate, 60 - height
        local one = world:add("boxes", { x = 190, y = 45, width = 9, height = 15, vx = speed })
        local two = { x = 199.2, y = y, width = 18, height = height, vx = speed }
        world:add("boxes", two)
        for _ = 1, rate do
          world:update(1 / rate)
          local isBeside = two.x - one.x - 9 >= -1e-6
          assert.is_true(isBeside or two.y - one.y - 15 >= -1e-6, height)
        end
        assertAt(100 + 22 * 83 / 44, 23, one)
      end
    end)

    --     [hero]\#|      a slope whose thin end is at the hero's feet, and another one above
    --     [    ]->\|
    --     ####.-'  .-'
    it(("stops a dash that would end behind the tip of a slope: %d Hz"):format(rate), function()
      for _, speed in ipairs({ 60, 130, 300, 500, 900, 3000 }) do
        local world = physics.newWorld({ gravity = 900 })
        slope(world, 288, 144, 16, 16, "topright")
        slope(world, 272, 176, 16, 16, "topleft")
        slope(world, 288, 176, 16, 16, "right")
        local hero = count(world:add("heroes", { x = 276, y = 152, width = 12, height = 24 }))
        steer(world, hero, 0.5, rate, { vx = speed, vy = 0 })
        assertAt(284, 152, hero)
        steer(world, hero, 0.5, rate, { vx = -8 })
        assertAt(280, 152, hero)
        assert.equal(0, hero.crushes)
      end
    end)

    --  train -> [one][two]|         two is in a hole, whose edge is the upright side of a slope
    --  =========     [   ]|.-'
    --  ______________
    --             __     a step of 17 px leads over the crest, into the block behind it
    --  [hero]-> /|  |
    it(("stops a fast walk before the block behind it: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("walls", tile(-200, 60, 700, 16))
      world:add("walls", tile(-200, 1, 700, 8))
      world:add("walls", tile(152, 32, 60, 28))
      slope(world, 100, 32, 52, 28, "right")
      local hero = count(world:add("heroes", { x = 100, y = 16, width = 9, height = 24 }))
      steer(world, hero, 1, rate, { vx = 500 })
      assertAt(143 - 52 / 28, 9, hero)
      steer(world, hero, 1, rate, { vx = -100 })
      assert.near(43 - 52 / 28, hero.x, 1e-9)
      assert.equal(0, hero.crushes)
    end)

    --    .------|
    --     ".____|    sinks onto a stack, and stops: the upper box was put 17 px aside
    --      [c][b][a]
    it(("holds a stack under a slanted press: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("floors", tile(-1000, 400, 2000, 20))
      local press = { x = 0, y = 250, width = 160, height = 40, slope = "topleft" }
      press.kinematic = true
      world:add("presses", press)
      world:add("boxes", { x = 93, y = 384, width = 16, height = 16 })
      world:add("boxes", { x = 94, y = 368, width = 16, height = 16 })
      local upper = world:add("boxes", { x = 99, y = 360, width = 8, height = 8 })
      steer(world, press, 0.5, rate, {})
      for _ = 1, 2.5 * rate do
        press.vy = press.y < 356 and 60 or 0
        world:update(1 / rate)
        assert.near(99, upper.x, 1)
      end
    end)

    --  ______________
    --       [hero]        goes up with the crate until the ceiling stops it: it went on into that
    --         [crate] .'
    it(("stops a crate whose rider comes to the ceiling: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      world:add("walls", tile(-200, 60, 700, 16))
      local ceiling = world:add("walls", tile(-200, 26, 700, 8))
      slope(world, 100, 16, 40, 44, "right")
      local crate = count(world:add("crates", small.put(60, 47, 14, 13)))
      local rider = count(world:add("heroes", small.put(56, 37, 10, 10)))
      for _ = 1, 2 * rate do
        crate.vx, rider.vx = 30, 30
        world:update(1 / rate)
        assert.is_true(overlap.depth(rider, ceiling) + overlap.depth(rider, crate) < 1e-9)
      end
      assert.same({ 0, 0 }, { crate.crushes, rider.crushes })
    end)

    it(("tells that a train crushes two crates in it: %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = 900 })
      slope(world, 192, 208, 16, 16, "right")
      slope(world, 224, 208, 16, 16, "topleft")
      local one = count(world:add("crates", { x = 196, y = 194, width = 14, height = 14 }))
      local two = count(world:add("crates", { x = 210, y = 195, width = 14, height = 14 }))
      local train = { x = 132, y = 200, width = 64, height = 8, vx = 60, kinematic = true }
      world:add("trains", train)
      small.play(world, 0.1, rate)
      assert.same({ 1, 1 }, { one.crushes, two.crushes })
    end)
  end
end)

it("slope: boxes that are pushed up a slope, below a ceiling, end in no others", function()
  local world, boxes = physics.newWorld({ gravity = 900 }), {}
  world:add("walls", small.tile(-100, 60, 500, 16))
  world:add("walls", small.tile(-100, 5, 500, 8))
  world:add("walls", small.tile(140, 22, 64, 38, { slope = "right" }))
  for n, size in ipairs({ { 13, 18 }, { 13, 10 }, { 18, 20 }, { 18, 11 } }) do
    boxes[n] = world:add("boxes", small.put(20 * n, 60 - size[2], size[1], size[2]))
  end
  for _ = 1, 40 do
    boxes[1].vx = 120
    world:update(1 / 30)
    local one, other = boxes[2], boxes[3]
    assert.is_true(math.max(other.x - one.x - one.width, one.y - other.y - other.height) > -0.01)
  end
end)

it("slope: a train that rises tells each crush once, also of those in others", function()
  local world, riders = physics.newWorld({ gravity = 900 }), {}
  slope(world, 100, -2, 49, 57, "topright")
  local train = small.put(-448, 60, 590, 16, { vx = 60, vy = -20, kinematic = true })
  world:add("trains", train)
  for n, at in ipairs({ { 89, 41, 19, 19 }, { 77, 50, 12, 10 }, { 94.5, 33, 8, 8 } }) do
    riders[n] = count(world:add("riders", small.put(at[1], at[2], at[3], at[4])))
  end
  small.play(world, 1.5, 30)
  assert.same({ 1, 1, 1 }, { riders[1].crushes, riders[2].crushes, riders[3].crushes })
end)

-- The upright side of a slope is a wall. (Of two boxes, the one at the press went through the other
-- one.)
--
--      [press]-> [a][b]|slope|
it("slope: its upright side squeezes a row as a wall does", function()
  local world = physics.newWorld({ gravity = 0 })
  local ends = tile(100, 0, 40, 40, { slope = "left", kinematic = true })
  ends.static = nil
  world:add("slopes", ends)
  local a = world:add("boxes", small.put(60, 10, 20, 20))
  local b = world:add("boxes", small.put(80, 10, 20, 20))
  world:add("presses", small.put(20, 0, 40, 40, { kinematic = true, vx = 60 }))
  small.run(world, 60)
  assert.near(90, a.x, 1)
  assert.is_true(b.x > a.x)
end)
