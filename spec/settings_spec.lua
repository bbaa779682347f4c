--- Settings: defaults, what a change does, and that changes come into effect at the next step.

local fields = require("physics.fields.fields")
local physics = require("physics")
local small = require("spec.support.small")

local newBox, play = small.box, small.run

local DT = 1 / 60

describe("every setting:", function()
  it("are plain fields with the documented defaults, or what is given", function()
    local given = { gravity = 5, rest = false, push = "first", order = { "a" } }
    local world, own = physics.newWorld(), physics.newWorld(given)
    for _, field in ipairs(fields.settings) do
      assert.equal(field.default, world[field.name], field.name)
    end
    assert.same({ gravity = 5, rest = false, push = "first", order = { "a" } }, given)
    assert.same({ 5, false, "first" }, { own.gravity, own.rest, own.push })
  end)

  it("may change while everything rests: gravity wakes", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = -100, y = 100, width = 400, height = 16, static = true })
    local ceiling = world:add("tiles", { x = -100, y = 0, width = 400, height = 16, static = true })
    local box = world:add("boxes", newBox(0, 84))
    play(world)
    assert.equal(1, world.stats.resting)
    world.gravity = -800
    play(world)
    assert.equal(16, box.y)
    assert.equal(ceiling, box.touching.top)
    world.gravity, world.gravityX = 0, 100
    play(world, 30)
    assert.near(0.5 * 100 * 0.25, box.x, 1e-9)
  end)

  it("push first: what runs into the other is put back alone, velocities are shared", function()
    for _, row in ipairs({ { "both", 46 }, { "first", 44 } }) do
      local world = physics.newWorld({ gravity = 0, push = row[1], maxStep = 0.25 })
      local a = world:add("boxes", newBox(40, 0, { vx = 32 })) -- 8 px a step
      local b = world:add("boxes", newBox(60, 0))
      world:update(0.25)
      assert.near(row[2], a.x, 1e-9)
      assert.near(row[2] + 16, b.x, 1e-9)
      assert.same({ 16, 16 }, { a.vx, b.vx })
    end
  end)

  it("broadphase, cellSize and rest may change in mid-air, and change nothing", function()
    local changes, hashes = { [20] = { broadphase = "grid" }, [40] = { cellSize = 11 } }, {}
    changes[60], changes[200] = { broadphase = "auto" }, { rest = false }
    for n = 1, 2 do
      local world = physics.newWorld({ gravity = 800, broadphase = "pairs" })
      world:add("tiles", small.tile(-100, 100, 400, 16))
      for i = 1, 10 do
        world:add("boxes", newBox(20 * i, -20 * i, { vx = 5 * i, friction = 0.5 }))
      end
      for step = 1, 210 do
        small.set(world, n == 2 and changes[step] or nil)
        world:update(DT)
      end
      assert.equal(n == 1 and 10 or 0, world.stats.resting)
      hashes[n] = world:hash()
    end
    assert.equal(hashes[1], hashes[2])
  end)

  it("masks are seen to change, also of a group that has been away", function()
    local world = physics.newWorld({ gravity = 0, masks = { shots = { gates = true } } })
    local gates = { newBox(30, 0, { static = true }) }
    world.objects = { gates = gates, shots = { newBox(0, 0, { vx = 600 }) } }
    local shot = world.objects.shots[1]
    play(world, 5)
    assert.equal(14, shot.x)
    world.objects.gates = nil
    world:update(DT)
    world.masks.shots.gates = false
    world.objects.gates = gates
    world:update(DT)
    world.masks.shots.gates = nil
    shot.x, shot.vx = 0, 600
    play(world, 5)
    assert.equal(14, shot.x)
    world.masks.shots.gates = false
    shot.x, shot.vx = 0, 600
    play(world, 6)
    assert.near(60, shot.x, 1e-9)
  end)
end)
