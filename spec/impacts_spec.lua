--- Rows of bodies that bounce off each other many times in a step: bounded work, and what it costs.

local physics = require("physics")

-- A row of boxes with these masses, `gap` px apart, the first of which comes at 400 px/s.
-- `look(energy, momentum, boxes)` is called after each step of a second; both are parts of what
-- they were. None passes through another.
local function play(masses, gap, restitution, rate, look)
  local world, boxes = physics.newWorld({ gravity = 0 }), {}
  for n, mass in ipairs(masses) do
    local box = { x = (n - 1) * (20 + gap), y = 0, width = 20, height = 20, mass = mass }
    box.vx, box.restitution = n == 1 and 400 or 0, restitution
    boxes[n] = world:add("boxes", box)
  end
  for _ = 1, rate do
    world:update(1 / rate)
    local energy, momentum = 0, 0
    for n, box in ipairs(boxes) do
      energy = energy + masses[n] * box.vx ^ 2
      momentum = momentum + masses[n] * box.vx
      assert.is_true(n == 1 or box.x >= boxes[n - 1].x + 20 - 1e-6)
    end
    look(energy / masses[1] / 400 ^ 2, momentum / masses[1] / 400, boxes)
  end
  return boxes
end

describe("restitution: a light box between two heavy ones", function()
  -- 4, 0.1 and 4 kg: some ten bounces, within a step or in a few.
  for _, rate in ipairs({ 30, 60, 144 }) do
    for _, gap in ipairs({ 0, 1, 5 }) do
      it(
        ("costs a thousandth of the energy at most, %g px apart, at %d Hz"):format(gap, rate),
        function()
          local before = 1
          local boxes = play({ 4, 0.1, 4 }, gap, 1, rate, function(energy, momentum)
            assert.is_true(energy <= before + 1e-12 and energy >= 0.999, "has " .. energy)
            assert.near(1, momentum, 1e-12)
            before = energy
          end)
          assert.near(-4.7, boxes[1].vx, 0.1)
        end
      )
    end
  end

  for _, rate in ipairs({ 30, 60, 144 }) do
    it(("never gets energy, nor does a longer row, at %d Hz"):format(rate), function()
      local least = 1
      local ROWS = { { 10, 1, 0.1, 1, 10 }, { 100, 1, 100 }, { 1, 0.01, 1, 0.01, 1 } }
      for _, masses in ipairs(ROWS) do
        for _, restitution in ipairs({ 0.9, 1 }) do
          local before = 1
          play(masses, 0.5, restitution, rate, function(energy, momentum)
            assert.is_true(energy <= before + 1e-12, energy .. " after " .. before)
            assert.near(1, momentum, 1e-12)
            before = energy
          end)
          least = math.min(least, restitution == 1 and before or 1)
        end
      end
      -- Where a step is not enough for all of it, up to what is left with all at one speed is lost.
      assert.is_true(least > 0.33, "loses down to " .. least)
    end)
  end
end)

describe("restitution: a row of five that touch", function()
  it("hands the speed on to the last, in one step", function()
    play({ 1, 1, 1, 1, 1 }, 0, 1, 60, function(_, _, boxes)
      for n = 1, 5 do
        assert.near(n == 5 and 400 or 0, boxes[n].vx, 1e-9)
      end
    end)
  end)
end)
