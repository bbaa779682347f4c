--- The contacts of an object: the field `touching`, what bounces, and what friction lifts. (More of
--- friction is in contacts_friction_spec.lua; overlaps and crushing are scenarios.)

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local variants = require("spec.support.variants")

local newBox, update = small.box, small.run

local DT = 1 / 60

local box = scene.thing("boxes", { name = "box", x = 0, y = 84, width = 16, height = 16 })
local solid = scene.maker("tiles", { static = true })
local FLOOR = solid("floor", -200, 100, 800, 16)

local body = scene.maker("bodies")

local function row(title, entries, given, rows)
  play.row(title, play.ONCE, entries, given, rows)
end

describe("touching", function()
  local NONE = { top = false, bottom = false, left = false, right = false }

  it("is there at once with add, at the first update with plain Lua, also of dt 0", function()
    local world = physics.newWorld()
    local first, other = world:add("boxes", newBox(0, 0)), newBox(40, 0)
    local touching = first.touching
    assert.same(NONE, touching)
    table.insert(world.objects.boxes, other)
    world:update(0)
    assert.same(NONE, other.touching)
    world:update(DT)
    assert.equal(touching, first.touching)
  end)

  row("belongs to dynamic objects only", { FLOOR, box({ kinematic = true }) }, {
    { steps = 2 },
    "floor.raw.touching == nil; box.raw.touching == nil",
  })

  local FRESH = { rest = false, FLOOR, box() }
  row("comes back when the game replaces it, or the object changes its kind", FRESH, {
    { steps = 3 },
    { "first = box.raw.touching", "box.raw.touching = {}", { steps = 1 } },
    { "box.raw.touching == first", "first.bottom == floor.raw" },
    { "box.kinematic = true", { steps = 1 }, "first.bottom == false" },
    { "box.kinematic = nil", { steps = 2 }, "box.touching.bottom == floor" },
    { "box.active = false", { steps = 1 }, "box.touching.bottom == false" },
    { "box.active = nil", { steps = 2 }, "box.touching.bottom == floor" },
  })

  local PAIR = { FLOOR, box(), box({ name = "rider", y = 68 }) }
  row("is there when it was of another kind for no step", PAIR, {
    { steps = 3 },
    { "rider.kinematic = true", "world:update(0)", "rider.kinematic = nil", { steps = 1 } },
    "rider.touching.bottom == box",
  })

  local TWO = { solid("narrow", 0, 100, 6, 8), solid("wide", 6, 100, 40, 8), box() }
  row("is the neighbour with the widest common edge, the first of equals: {which}", TWO, {
    { steps = 1 },
    { "box.x = x", { steps = 2 }, "box.touching.bottom.name == which" },
  }, { "x, which", { 0, "wide" }, { -2, "wide" }, { -4, "narrow" } }) -- 6 px each
end)

--   #####     hit, and left again in the same step
--    +-+ ^
-- `touching.top` was false in each update of each jump.
describe("touching: a side that was hit and left again", function()
  it("shows for one update", function()
    for _, rate in ipairs({ 60, 30, 144, 20 }) do
      for _, rest in ipairs({ true, false }) do
        local world = physics.newWorld({ gravity = 800, rest = rest })
        world:add("tiles", { x = 0, y = 100, width = 100, height = 16, static = true })
        local ceiling = { x = 0, y = 40, width = 100, height = 16, static = true }
        world:add("tiles", ceiling)
        local man = world:add("men", { x = 10, y = 80, width = 10, height = 20 })
        local hits, shown, before = 0, 0, 0
        function man.onBegin(_, _, side)
          hits = hits + (side == "top" and 1 or 0)
        end
        for _ = 1, 3 do
          world:update(1 / rate)
          man.vy = -400
          update(world, rate, rate, function()
            assert.equal(hits > before and ceiling or false, man.touching.top)
            shown, before = shown + (man.touching.top and 1 or 0), hits
          end)
        end
        assert.same({ 3, 3 }, { hits, shown })
      end
    end
  end)

  it("shows on both that bounce, and the wider of two", function()
    local world = physics.newWorld({ gravity = 0 })
    local narrow = world:add("boxes", { x = 0, y = 0, width = 20, height = 20, vx = 100 })
    narrow.restitution = 1
    local first = world:add("walls", { x = 20.5, y = -20, width = 8, height = 25, static = true })
    local second = world:add("walls", { x = 20.5, y = 5, width = 8, height = 25, static = true })
    world:update(1 / 60)
    assert.equal(second, narrow.touching.right)
    assert.is_nil(first.touching)
    world:update(1 / 60)
    assert.is_false(narrow.touching.right)
    local other = world:add("boxes", { x = narrow.x - 21, y = 0, width = 20, height = 20 })
    world:update(1 / 60)
    assert.equal(other, narrow.touching.left)
    assert.equal(narrow, other.touching.right)
    world:update(1 / 60)
    assert.same({ false, false }, { narrow.touching.left, other.touching.right })
  end)

  it("carries nothing and is no ground: a bounce on a lift takes no ride", function()
    local world = physics.newWorld({ gravity = 800 })
    local lift = { x = 0, y = 100, width = 60, height = 8, kinematic = true, vx = 200 }
    world:add("lifts", lift)
    local ball = world:add("balls", { x = 0, y = 60, width = 8, height = 8, restitution = 1 })
    update(world, 40, 60, function()
      assert.equal(0, ball.x)
    end)
  end)

  it("is not remembered of what has left, or of another that took its place", function()
    local world = physics.newWorld({ gravity = 0 })
    local ball = { x = 0, y = 0, width = 8, height = 8, vx = 600, restitution = 1 }
    world:add("balls", ball)
    local wall = world:add("walls", { x = 9, y = 0, width = 8, height = 8, static = true })
    function ball.onBegin(_, other)
      world:remove(other)
      world:add("walls", { x = 900, y = 0, width = 8, height = 8, static = true })
    end
    world:update(1 / 10) -- four steps
    assert.is_false(ball.touching.right)
    assert.is_nil(wall.touching)
  end)
end)

--   [4] ->  .  [4]
-- Less than half of the energy was left after one step.
describe("restitution 1: of different masses in a row", function()
  -- Of the energy, in all, at most: in a row of five, of which light ones are hit from both sides,
  -- the rounds of a step end first (see docs/reliability.md).
  local LOSS, LOSS_OF_FIVE = 0.2, 0.55
  local LEVELS = { rate = variants.RATES, turn = { 0, 2 }, order = { "forward", "backward" } }

  local function energyOf(objects)
    local energy, momentum = 0, 0
    for _, object in ipairs(objects) do
      energy = energy + object.mass * (object.vx ^ 2 + object.vy ^ 2) / 2
      momentum = momentum + object.mass * object.vx
    end
    return energy, momentum
  end

  for _, given in ipairs({
    { { 4, 0.1, 4 }, 2 },
    { { 4, 0.1, 4 }, 0 },
    { { 4, 0.1, 4 }, 5.5 },
    { { 1, 1, 1 }, 2 },
    { { 4, 1, 4 }, 2 },
    { { 1, 4, 0.1 }, 2 },
    { { 4, 0.1, 4, 0.1, 4 }, 2 },
    { { 1, 1, 1, 1, 1, 1 }, 0 },
  }) do
    local masses, gap = given[1], given[2]
    local title = "%s, %g px apart, keep momentum and most of the energy"
    scene.it(title:format(table.concat(masses, ", "), gap), LEVELS, function(run)
      local description = { gravity = 0 }
      for i, mass in ipairs(masses) do
        local fields = { mass = mass, restitution = 1, vx = i == 1 and 400 or 0 }
        description[i] = body("ball" .. i, (16 + gap) * (i - 1), 0, 16, 16, fields)
      end
      run:build(description)
      local energy, momentum = energyOf(run.all)
      local before = energy
      for _ in run:steps(0.5) do
        local now, sum = energyOf(run.all)
        run:near("the momentum", sum, momentum, 1e-9 * math.abs(momentum))
        run:check(now <= before * (1 + 1e-9), "energy grew from %.17g to %.17g", before, now)
        local loss = #masses == 5 and LOSS_OF_FIVE or LOSS
        run:check(now >= energy * (1 - loss), "%.3g of the energy is left", now / energy)
        before = now
      end
    end)
  end
end)

-- A row of boxes with these masses, `gap` px apart, the first of which comes at 400 px/s.
-- `look(energy, momentum, boxes)` is called after each step of a second; both are parts of what
-- they were. None passes through another.
local function bounce(masses, gap, restitution, rate, look)
  local world, boxes = physics.newWorld({ gravity = 0 }), {}
  for n, mass in ipairs(masses) do
    local its = { x = (n - 1) * (20 + gap), y = 0, width = 20, height = 20, mass = mass }
    its.vx, its.restitution = n == 1 and 400 or 0, restitution
    boxes[n] = world:add("boxes", its)
  end
  for _ = 1, rate do
    world:update(1 / rate)
    local energy, momentum = 0, 0
    for n, its in ipairs(boxes) do
      energy = energy + masses[n] * its.vx ^ 2
      momentum = momentum + masses[n] * its.vx
      assert.is_true(n == 1 or its.x >= boxes[n - 1].x + 20 - 1e-6)
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
          local boxes = bounce({ 4, 0.1, 4 }, gap, 1, rate, function(energy, momentum)
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
          bounce(masses, 0.5, restitution, rate, function(energy, momentum)
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
    bounce({ 1, 1, 1, 1, 1 }, 0, 1, 60, function(_, _, boxes)
      for n = 1, 5 do
        assert.near(n == 5 and 400 or 0, boxes[n].vx, 1e-9)
      end
    end)
  end)
end)

describe("friction: a box that leans on a lift that rises", function()
  --    +--+----+ ^ 50
  --  > |  |    |      friction lifts with half of what it leans with,
  --    +--+    |      its weight is 600
  --   ====|    |
  local GROUND = scene.maker("floors", { static = true, friction = 0 })("floor", -100, 100, 120, 4)
  local LIFT = scene.maker("lifts", { kinematic = true, vy = -50 })("lift", 20, 60, 20, 400)
  local LEVELS = { rate = { 30, 144 }, shift = { 0 } }
  play.row("with {ax} px/s² {what}", LEVELS, function(v)
    local crate = scene.maker("boxes", { friction = 0.5, ax = v.ax })("box", 0, 80, 20, 20)
    return { gravity = 600, GROUND, LIFT, crate }
  end, { 1, "box.x == 0; box.y ~ 80 - way, 1e-9" }, {
    "ax, what, way",
    { 300, "stays on the floor", 0 },
    { 1100, "stays on the floor", 0 },
    { 1300, "is lifted by the difference, 50 px/s²", 25 },
    { 3000, "is as fast as the lift after 50 / 900 s", 50 - 50 * 50 / 900 / 2 },
  })
end)
