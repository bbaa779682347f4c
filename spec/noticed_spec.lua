--- Scenes for lines of which a change got past the specs (scripts/mutants.lua).

local physics = require("physics")

local function near(expected, found, tolerance)
  assert.near(expected, found, tolerance or 1e-9)
end

--          topright
--   ________________
--    `-.._          |
--         `-.._     |      the way becomes narrower
--          .-'|  `--|
--      .-'    |
--  .-'________|
describe("a hill below a roof that comes down", function()
  it("stops what walks up, where its corner meets the roof", function()
    for _, y in ipairs({ -400, 300 }) do
      local world = physics.newWorld({ gravity = 800 })
      world:add("floor", { x = -400, y = 0, width = 1000, height = 20, static = true })
      local hill = { x = 0, y = -100, width = 200, height = 100, static = true, slope = "right" }
      world:add("slopes", hill)
      world:add("other", { x = 2000, y = y, width = 10, height = 10, static = true })
      local roof = { x = 0, y = -140, width = 200, height = 40, static = true, slope = "topright" }
      world:add("slopes", roof)
      local walker = world:add("walkers", { x = -40, y = -16, width = 16, height = 16 })
      for _ = 1, 180 do
        walker.vx = 100
        world:update(1 / 60)
      end
      -- The corner is at (x, -x / 2 - 16), the roof there at -140 + x / 5.
      local x = 124 / 0.7
      near(x, walker.x + 16, 1e-6)
      near(-x / 2, walker.y + 16, 1e-6)
    end
  end)
end)

describe("a slope that is met after a bounce in the same step", function()
  --  -----------
  --      O         up, back from the ceiling, and off the slope
  --     .-'|
  --  .-'   |
  it("deflects along its normal", function()
    for _, speed in ipairs({ 500, 3150 }) do
      local world = physics.newWorld({ gravity = 0 })
      world:add("walls", { x = -900, y = -60, width = 2000, height = 20, static = true })
      local slope = { x = 0, y = 0, width = 200, height = 100, static = true, slope = "right" }
      world:add("slopes", slope)
      local box = { x = 90, y = -20, width = 10, height = 10, vy = -speed, restitution = 1 }
      world:add("boxes", box)
      local steps = math.floor(7800 / speed)
      for _ = 1, steps do
        world:update(1 / 60)
      end
      -- 20 px up to the ceiling at -40, then down until its corner, at x = 100, is at 50. The
      -- normal is (-1, -2) / √5: (0, v) becomes (-0.8, -0.6) * v.
      local late = steps / 60 - (20 + 80) / speed
      assert.is_true(late > 0)
      near(90 - 0.8 * speed * late, box.x, 1e-6)
      near(40 - 0.6 * speed * late, box.y, 1e-6)
    end
  end)
end)

describe("two that are soft to each other", function()
  it("part sideways if their middles are equally high, whatever their heights", function()
    local world = physics.newWorld({ gravity = 0, soft = { mites = { mites = 100 } } })
    local low = world:add("mites", { x = 0, y = 0, width = 20, height = 10 })
    local tall = world:add("mites", { x = 10, y = -10, width = 20, height = 30 })
    for _ = 1, 30 do
      world:update(1 / 60)
    end
    near(0, low.y)
    near(-10, tall.y)
    assert.is_true(low.x < -1 and tall.x > 11, "they should part")
  end)
end)
