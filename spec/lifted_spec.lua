--- A box that friction with a lift lifts, if that is more than its weight.

local physics = require("physics")

local GRAVITY = 600

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
    for _, rate in ipairs({ 30, 144 }) do
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
