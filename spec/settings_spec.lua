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
