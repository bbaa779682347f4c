--- Wedges: rooms that a slope narrows. Objects that stand still crush none, and let all objects
--- out.

local physics = require("physics")
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
      ("stops a hero between a wall and a slanted wall, and lets it out: %d Hz"):format(rate),
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
  end
end)
