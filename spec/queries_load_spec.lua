--- `world:load`: the forces that press the sides of an object.

local effort = require("spec.support.effort")
local physics = require("physics")
local small = require("spec.support.small")

local ball, newBox, run = small.ball, small.box, small.run

local RATES = { 30, 60, 144, 1000 }

-- Adds a stack of three crates of mass 2, the lowest first, on a ground of which the top is at 100.
local function addStack(world, ground)
  local stack = {}
  world:add("grounds", ground)
  for n = 1, 3 do
    stack[n] = world:add("crates", newBox(40, 100 - 16 * n, { mass = 2 }))
  end
  return stack
end

local function groundOf(fields)
  fields.x, fields.y, fields.width, fields.height = 0, 100, 400, 16
  return fields
end

local function assertLoad(world, object, top, bottom, left, right)
  assert.same({ top = top, bottom = bottom, left = left, right = right }, world:load(object))
end

describe("world:load", function()
  local GROUNDS = {
    { "the floor", { static = true } },
    { "a lift that goes up", { kinematic = true, vy = -60 } },
    { "a lift that goes down", { kinematic = true, vy = 60 } },
    { "a train", { kinematic = true, vx = 60 } },
    { "a belt", { static = true, surfaceSpeed = 40 } },
    { "a one-way platform", { static = true, oneWay = "top" } },
    { "a rough floor", { static = true, friction = 1 } },
  }
  small.rows("of a stack of three of mass 2 is 4 800 on {1}", GROUNDS, function(_, fields)
    for _, rate in ipairs(RATES) do
      local world, ground = physics.newWorld({ gravity = 800 }), groundOf({})
      small.set(ground, fields)
      local stack = addStack(world, ground)
      run(world, 1.5 * rate, rate)
      for _ = 1, 2 do
        assertLoad(world, ground, 4800, 0, 0, 0)
        assertLoad(world, stack[1], 3200, 4800, 0, 0)
        assertLoad(world, stack[2], 1600, 3200, 0, 0)
        assertLoad(world, stack[3], 0, 1600, 0, 0)
        world:restore(world:save())
      end
    end
  end)

  it("is the same while all sleep, and in a world that was restored from a file", function()
    local world = physics.newWorld({ gravity = 800 })
    local ground = groundOf({ static = true })
    addStack(world, ground)
    run(world, 200)
    assert.are.equal(3, world.stats.resting)
    assertLoad(world, ground, 4800, 0, 0, 0)
    local other = physics.newWorld()
    other:restore(world:save())
    assertLoad(other, other.objects.grounds[1], 4800, 0, 0, 0)
  end)

  it("of objects that fall together, or were not seen by an update yet, is 0", function()
    local world = physics.newWorld({ gravity = 800 })
    local stack = addStack(world, groundOf({ static = true, active = false }))
    assertLoad(world, stack[1], 0, 0, 0, 0)
    run(world, 20)
    for n = 1, 3 do
      assertLoad(world, stack[n], 0, 0, 0, 0)
    end
  end)

  it("is shared by the widths of the common edges", function()
    local world = physics.newWorld({ gravity = 800 })
    local left, right = newBox(0, 100, { static = true }), newBox(80, 100, { static = true })
    left.width, right.width = 30, 10
    local plank = world:add("planks", { x = 0, y = 90, width = 90, height = 10, mass = 4 })
    world:add("scales", left)
    world:add("scales", right)
    run(world, 60)
    assertLoad(world, left, 2400, 0, 0, 0)
    assertLoad(world, right, 800, 0, 0, 0)
    assertLoad(world, plank, 0, 3200, 0, 0)
  end)

  it("does not go on through objects that are immovable", function()
    local world = physics.newWorld({ gravity = 800 })
    local low = world:add("crates", newBox(0, 84))
    world:add("grounds", groundOf({ static = true }))
    local shelf = world:add("shelves", newBox(0, 68, { kinematic = true }))
    world:add("crates", newBox(0, 52))
    run(world, 60)
    assertLoad(world, shelf, 800, 0, 0, 0)
    assertLoad(world, low, 0, 800, 0, 0)
  end)

  it("of a row that is pushed against a wall is the sum of its forces", function()
    local world = physics.newWorld({ gravity = 0 })
    local wall = world:add("walls", newBox(64, 0, { static = true }))
    for n = 0, 3 do
      world:add("crates", newBox(16 * n, 0, { mass = n + 1, ax = 10 }))
    end
    run(world, 60)
    assertLoad(world, wall, 0, 0, 100, 0)
    assertLoad(world, world.objects.crates[4], 0, 0, 60, 100)
  end)

  it("of what is pushed freely is its mass times its acceleration", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("grounds", groundOf({ static = true }))
    local hero = world:add("heroes", newBox(0, 84, { ax = 500 }))
    local crate = world:add("crates", newBox(16, 84, { mass = 4 }))
    run(world, 20)
    local load = world:load(crate)
    assert.near(400, load.left, 1e-9)
    assert.are.equal(3200, load.bottom)
    assert.near(400, world:load(hero).right, 1e-9)
  end)

  local TURNED = {
    { "upwards", 0, -800, "bottom" },
    { "to the right", 800, 0, "left" },
    { "to the left", -800, 0, "right" },
  }
  small.rows("follows gravity {1}", TURNED, function(_, gx, gy, side)
    local world = physics.newWorld({ gravityX = gx, gravity = gy })
    local scale = world:add("scales", newBox(0, 0, { static = true }))
    local x, y = -gx / 50, -gy / 50
    for n = 1, 3 do
      world:add("crates", newBox(n * x, n * y, { mass = 2 }))
    end
    run(world, 60)
    assert.are.equal(4800, world:load(scale)[side])
  end)

  it("counts the pull of zones, also after a restore", function()
    local world = physics.newWorld({ gravity = 800 })
    local scale = world:add("grounds", groundOf({ static = true }))
    local wall = world:add("walls", newBox(16, 84, { static = true }))
    local area = { gravity = 200, ax = 30 }
    world:add("zones", small.tile(-50, 0, 200, 100, { sensor = true, area = area }))
    world:add("crates", newBox(0, 84, { mass = 3 }))
    run(world, 60)
    for _ = 1, 2 do
      assert.same({ 600, 90 }, { world:load(scale).top, world:load(wall).left })
      local other = physics.newWorld()
      other:restore(world:save())
      world, scale, wall = other, other.objects.grounds[1], other.objects.walls[1]
    end
  end)

  it("of a ball on a slope is that along the normal", function()
    local world = physics.newWorld({ gravity = 800 })
    local slope = { x = 0, y = 0, width = 400, height = 300, static = true, slope = "right" }
    world:add("slopes", slope)
    local rolls = world:add("balls", ball(200 - 0.6 * 10, 150 - 0.8 * 10, 10, { mass = 2 }))
    run(world, 20)
    local load = world:load(slope)
    assert.near(1600 * 0.8 * 0.8, load.top, 1e-6)
    assert.near(1600 * 0.8 * 0.6, load.left, 1e-6)
    assert.near(1600 * 0.8 * 0.6, world:load(rolls).right, 1e-6)
  end)

  it("of a ball between a slope and a wall holds it", function()
    local world = physics.newWorld({ gravity = 800 })
    local slope = { x = 0, y = 0, width = 400, height = 300, static = true, slope = "right" }
    local wall = { x = 90, y = 0, width = 80, height = 220, static = true }
    world:add("slopes", slope)
    world:add("walls", wall)
    world:add("balls", ball(220 - 0.6 * 10, 135 - 0.8 * 10, 10, { mass = 2 }))
    run(world, 300)
    assert.near(1600, world:load(slope).top, 1e-6)
    assert.near(1600 * 0.75, world:load(slope).left, 1e-6)
    assert.near(1600 * 0.75, world:load(wall).right, 1e-6)
  end)

  for _, roundShare in ipairs({ 0, 0.5, 1 }) do
    for _, count in ipairs(effort.isWhole and { 20, 80 } or { 20 }) do
      it(("of a heap is its weight: %d, %g round"):format(count, roundShare), function()
        local world, weight = physics.newWorld({ gravity = 800 }), 0
        local scale = { x = 0, y = 400, width = 160, height = 16, static = true }
        world:add("grounds", scale)
        world:add("walls", { x = -16, y = -2000, width = 16, height = 2416, static = true })
        world:add("walls", { x = 160, y = -2000, width = 16, height = 2416, static = true })
        for n = 1, count do
          local radius, x = 6 + n * 7 % 5, n * 37 % 130
          local thing = ball(x + radius, 390 - 11 * n, radius, { mass = 1 + n % 3 })
          thing.radius = n * 13 % 10 < roundShare * 10 and radius or nil
          world:add("things", thing)
          weight = weight + 800 * thing.mass
        end
        run(world, 600)
        assert.near(1, world:load(scale).top / weight, 0.05)
      end)
    end
  end

  it("does not depend on the order in which objects came", function()
    local function measure(first, last, by)
      local world = physics.newWorld({ gravity = 800, gravityX = 40 })
      world.objects.balls = {}
      local scale = { x = 0, y = 400, width = 160, height = 16, static = true }
      world.objects.grounds = { scale }
      world.objects.walls = { { x = 160, y = 0, width = 16, height = 400, static = true } }
      for n = first, last, by do
        world.objects.balls[n] = ball(20 + n * 31 % 120, 380 - 14 * n, 7, { mass = 1 + n % 3 })
        if n % 2 == 0 then
          world:update(0)
        end
      end
      run(world, 200)
      return world:load(scale)
    end
    assert.same(measure(1, 12, 1), measure(12, 1, -1))
  end)

  it("changes nothing, fills `out`, and makes no garbage with it", function()
    local world = physics.newWorld({ gravity = 800 })
    local ground = groundOf({ static = true })
    addStack(world, ground)
    run(world, 10)
    local before, out = world:hash(), {}
    assert.are.equal(out, world:load(ground, out))
    assert.are.equal(4800, out.top)
    assert.are.equal(before, world:hash())
  end)
end)
