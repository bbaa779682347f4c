--- A box that loses its hold in the middle of a step, and one that friction with a lift lifts, if
--- it is more than its weight.

local physics = require("physics")

local GRAVITY = 600

-- Kinetic and potential energy of what weighs 1.
local function energyOf(objects)
  local sum = 0
  for _, object in ipairs(objects) do
    sum = sum + (object.vx ^ 2 + object.vy ^ 2) / 2 - GRAVITY * object.y
  end
  return sum
end

describe("restitution: a box that is hit from below, off its shelf,", function()
  --    +------+
  --    |      |
  --    +------+
  --   ===  +--+
  --        +--+ 400 ^
  for _, rate in ipairs({ 30, 60, 144, 240 }) do
    it(("falls from that moment on, at %d Hz"):format(rate), function()
      local world = physics.newWorld({ gravity = GRAVITY })
      world:add("shelves", { x = 0, y = 100, width = 10, height = 4, static = true })
      local crate = world:add("boxes", { x = 0, y = 80, width = 20, height = 20 })
      local ball =
        world:add("boxes", { x = 12, y = 110, width = 8, height = 8, vy = -400, restitution = 1 })
      local bodies = { crate, ball }
      world:update(0)
      local before = energyOf(bodies)
      local steps = math.floor(rate / 15)
      for _ = 1, steps do
        world:update(1 / rate)
      end
      assert.is_true(crate.y < 70)
      assert.near(before, energyOf(bodies), 1e-9 * math.abs(before))
      -- They have swapped their speeds: together they have gone up as one ball and fallen as one.
      local t = steps / rate
      local hit = (400 - math.sqrt(400 ^ 2 - 2 * GRAVITY * 10)) / GRAVITY
      assert.near(-400 + GRAVITY * t, crate.vy, 1e-6)
      assert.near(GRAVITY * (t - hit), ball.vy, 1e-6)
    end)
  end
end)

describe("friction: a box that leans on a lift that rises", function()
  --    +--+----+ ^ 50
  --  > |  |    |      friction lifts with half of what it leans with,
  --    +--+    |      its weight is 600
  --   ====|    |
  local ROWS = {
    { 300, "stays on the floor", 0 },
    { 1100, "stays on the floor", 0 },
    { 1300, "is lifted by the difference, 50 px/s²", 25 },
    { 3000, "is as fast as the lift after 50 / 900 s", 50 - 50 * 50 / 900 / 2 },
  }
  for _, row in ipairs(ROWS) do
    local push, what, way = row[1], row[2], row[3]
    for _, rate in ipairs({ 30, 60, 144, 240 }) do
      it(("with %d px/s² %s, at %d Hz"):format(push, what, rate), function()
        local world = physics.newWorld({ gravity = GRAVITY })
        local floor = { x = -100, y = 100, width = 120, height = 4, static = true, friction = 0 }
        world:add("floors", floor)
        local box = { x = 0, y = 80, width = 20, height = 20, friction = 0.5, ax = push }
        world:add("boxes", box)
        local lift = { x = 20, y = 60, width = 20, height = 400, kinematic = true, vy = -50 }
        world:add("lifts", lift)
        for _ = 1, rate do
          world:update(1 / rate)
          assert.is_true(way > 0 or box.y == 80)
        end
        assert.equal(0, box.x)
        assert.near(80 - way, box.y, 1e-9)
      end)
    end
  end
end)
