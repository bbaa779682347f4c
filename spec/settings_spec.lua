--- Settings: defaults, what a change does, and that changes come into effect at the next step.

local fields = require("physics.fields.fields")
local newBox = require("spec.support.box")
local physics = require("physics")

local DT = 1 / 60

local function play(world, steps)
  for _ = 1, steps or 60 do
    world:update(DT)
  end
end

describe("settings", function()
  it("are plain fields with the documented defaults", function()
    local world = physics.newWorld()
    for _, field in ipairs(fields.settings) do
      assert.equal(field.default, world[field.name], field.name)
    end
  end)

  it("may be given, also false", function()
    local world = physics.newWorld({ gravity = 5, rest = false, push = "first" })
    assert.equal(5, world.gravity)
    assert.is_false(world.rest)
    assert.equal("first", world.push)
  end)

  it("given table is only read", function()
    local given = { gravity = 5, order = { "a" } }
    physics.newWorld(given)
    assert.same({ gravity = 5, order = { "a" } }, given)
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

  it("push first: the one that runs into the other gives way", function()
    for _, row in ipairs({ { "both", 46 }, { "first", 44 } }) do
      local world = physics.newWorld({ gravity = 0, push = row[1], maxStep = 0.25 })
      local a = world:add("boxes", newBox(40, 0, { vx = 32 })) -- 8 px a step
      local b = world:add("boxes", newBox(60, 0))
      world:update(0.25)
      assert.near(row[2], a.x, 1e-9)
      assert.near(row[2] + 16, b.x, 1e-9)
    end
  end)

  it("broadphase and cellSize may change in mid-air", function()
    local worlds = {}
    for n = 1, 2 do
      local world = physics.newWorld({ gravity = 800, broadphase = "pairs" })
      world:add("tiles", { x = -100, y = 100, width = 400, height = 16, static = true })
      for i = 1, 10 do
        world:add("boxes", newBox(7 * i, -20 * i, { vx = 5 * i }))
      end
      worlds[n] = world
    end
    for step = 1, 120 do
      if step == 20 then
        worlds[2].broadphase = "grid"
      elseif step == 40 then
        worlds[2].cellSize = 11
      elseif step == 60 then
        worlds[2].broadphase = "auto"
      end
      for n = 1, 2 do
        worlds[n]:update(DT)
      end
      for i = 1, 10 do
        local a, b = worlds[1].objects.boxes[i], worlds[2].objects.boxes[i]
        assert.is_true(a.x == b.x and a.y == b.y and a.vx == b.vx and a.vy == b.vy)
      end
    end
  end)

  it("rest may be switched off and on, and changes nothing", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = -100, y = 100, width = 400, height = 16, static = true })
    local box = world:add("boxes", newBox(0, 84))
    play(world)
    world.rest = false
    play(world, 5)
    assert.equal(0, world.stats.resting)
    assert.equal(84, box.y)
    world.rest = true
    play(world, 5)
    assert.equal(1, world.stats.resting)
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
