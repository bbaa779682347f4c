--- Types of the reference: what is in `stats`.

local physics = require("physics")
local small = require("spec.support.small")

local newBox, newFloor = small.box, small.floor

local DT = 1 / 60

--   +--+
--   +--+
--          fall 1.5, 3 and 4.5 px: for 3.7, 5.2 and 6.4 steps
--   +--+
--   +--+
--   +--+       +----+ ->
--  ------
it("stats count a pile that falls, lands and comes to rest", function()
  for _, broadphase in ipairs({ "grid", "pairs" }) do
    local world, seen = physics.newWorld({ gravity = 800, broadphase = broadphase }), {}
    world:add("tiles", newFloor())
    for i = 1, 3 do
      world:add("boxes", newBox(0, 100 - 17.5 * i))
    end
    local lift = { x = 300, y = 0, width = 32, height = 8, kinematic = true, vx = 10 }
    world:add("lifts", lift)
    for step = 0, 20 do
      local stats = world.stats
      seen[step] = { stats.objects, stats.movers, stats.resting, stats.contacts, stats.events }
      assert.is_true(stats.pairs >= stats.contacts)
      world:update(DT)
    end
    for _, values in ipairs({
      -- step; objects, movers, resting, contacts, events
      { 0, { 0, 0, 0, 0, 0 } },
      { 3, { 5, 4, 0, 0, 0 } },
      { 4, { 5, 4, 0, 1, 1 } },
      { 6, { 5, 4, 0, 2, 2 } },
      { 7, { 5, 4, 0, 3, 3 } },
      { 20, { 5, 4, 3, 3, 0 } },
    }) do
      assert.same(values[2], seen[values[1]], broadphase .. ", step " .. values[1])
    end
  end
end)

it("profile: a clock in it tells how long the stages of a step took", function()
  local now, world = 0, physics.newWorld()
  world:add("boxes", { x = 0, y = 0, width = 8, height = 8 })
  world:update(1 / 60)
  assert.is_nil(world.stats.times)
  function world.profile()
    now = now + 2
    return now
  end
  world:update(0) -- no step
  assert.same({ read = 0, separate = 0, move = 0, solve = 0, write = 0 }, world.stats.times)
  now = 0
  world:update(1 / 60)
  assert.same({ read = 2, separate = 2, move = 2, solve = 2, write = 2 }, world.stats.times)
  world.profile = os.clock
  world:update(1 / 60)
  for name, time in pairs(world.stats.times) do
    assert.is_true(time >= 0 and time < 1, name)
  end
  world.profile = nil
  world:update(1 / 60)
  assert.is_nil(world.stats.times)
end)

it("profile: stages that are left out, since everything sleeps, take no time", function()
  local now, world = 0, physics.newWorld({ gravity = 0 })
  local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8 })
  function world.profile()
    now = now + 2
    return now
  end
  for _ = 1, 5 do
    world:update(1 / 60)
  end
  assert.same({ read = 2, separate = 0, move = 0, solve = 0, write = 0 }, world.stats.times)
  box.vx = 1
  world:update(1 / 60)
  assert.same({ read = 2, separate = 2, move = 2, solve = 2, write = 2 }, world.stats.times)
end)
