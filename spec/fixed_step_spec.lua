--- The setting `timestep`: the same trajectory whatever dt is, and a smooth picture all the same.

local physics = require("physics")
local everything = require("spec.support.everything")
local newRandom = require("spec.support.random").new

local STEP = 1 / 64 -- a power of two: sums of dt are exact, so both runs make the same steps
local SECONDS = 2

-- Plays the big scene, the game writing only at the first of all, and notes each fixed step.
local function trackOf(lengths)
  local world, track = everything.new({ timestep = STEP }), {}
  for _, dt in ipairs(lengths) do
    world:update(dt)
    local objects, sum = world.objects, {}
    for _, group in ipairs({ "boxes", "crates", "lifts" }) do
      for _, object in ipairs(objects[group]) do
        sum[#sum + 1] = ("%.17g %.17g"):format(object.x, object.y)
      end
    end
    track[#track + 1] = table.concat(sum, " ")
  end
  return track, world
end

-- Multiples of 1/1024 s that add up to `total`, from a seed.
local function irregular(seed, total)
  local random, lengths, left = newRandom(seed), {}, total * 1024
  while left > 0 do
    local length = math.min(left, random:pick({ 1, 2, 3, 11, 16, 17, 33, 64, 200 }))
    lengths[#lengths + 1] = length / 1024
    left = left - length
  end
  return lengths
end

local function regular(dt, total)
  local lengths = {}
  for i = 1, total / dt do
    lengths[i] = dt
  end
  return lengths
end

describe("timestep", function()
  it("irregular dt give the trajectory of regular ones, to the bit", function()
    local lengths = regular(STEP, SECONDS)
    local track, straight = trackOf(lengths)
    for seed = 1, 4 do
      local mine, time = irregular(seed, SECONDS), 0
      local other, world = trackOf(mine)
      for i, dt in ipairs(mine) do
        time = time + dt
        local steps = math.floor(time / STEP)
        if steps > 0 then
          local text = ("seed %d, after %g s"):format(seed, time)
          assert(other[i] == track[steps], text)
        end
      end
      assert.are.equal(straight:hash(), world:hash())
    end
  end)

  it("no step is lost to rounding: 60 frames of 1/60 s are 60 steps", function()
    for _, rate in ipairs({ 30, 60, 75, 90, 100, 120, 144, 240 }) do
      local world = physics.newWorld({ gravity = 0, timestep = 1 / rate })
      local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = rate })
      for _ = 1, rate do
        world:update(1 / rate)
      end
      assert.is_true(math.abs(box.x - rate) < 1e-6, ("%d Hz: %.17g"):format(rate, box.x))
    end
  end)

  it("alpha is the saved-up share of a step, in 0..1", function()
    local world = physics.newWorld({ timestep = 0.0625 })
    for _, row in ipairs({
      { 0, 0 },
      { 0.015625, 0.25 },
      { 0.03125, 0.75 },
      { 0.015625, 0 },
      { 0.25, 0 },
      { 0.078125, 0.25 },
    }) do
      world:update(row[1])
      assert.are.equal(row[2], world.alpha)
    end
  end)

  it("more than 0.25 s is cut to that", function()
    local world = physics.newWorld({ gravity = 0, timestep = 0.03125 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 32 })
    for _ = 1, 3 do
      world:update(10)
    end
    assert.are.equal(24, box.x)
    assert.are.equal(0, world.alpha)
  end)

  it("what is left of a long step counts in full beside a long dt", function()
    local world = physics.newWorld({ gravity = 0, timestep = 0.1875 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 16 })
    world:update(0.125)
    world:update(0.25)
    assert.are.equal(6, box.x)
  end)

  it("an update shorter than a step moves nothing and tells nothing", function()
    local world = physics.newWorld({ timestep = 0.25 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 40 })
    world.onBegin = function()
      error("told")
    end
    world:update(0.125)
    assert.are.equal(0, box.x)
  end)

  it("saved-up time goes with the state", function()
    local world = physics.newWorld({ gravity = 0, timestep = 0.25 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 40 })
    world:update(0.25)
    world:update(0.125)
    local state, x = world:save(), world:interpolate(box)
    world:update(0.1875)
    world:restore(state)
    assert.are.equal(0.5, world.alpha)
    assert.are.equal(x, (world:interpolate(box)))
    world:update(0.125)
    assert.are.equal(20, box.x)
    assert.are.equal(0, world.alpha)
  end)
end)

-- A step of 0.25 s: what moves at 40 px/s is 10 px further after it.
describe("world:interpolate", function()
  local world
  before_each(function()
    world = physics.newWorld({ gravity = 0, timestep = 0.25 })
  end)

  local function box(fields)
    local object = { x = 0, y = 0, width = 8, height = 8, vx = 40, vy = -20 }
    for key, value in pairs(fields or {}) do
      object[key] = value
    end
    return world:add("boxes", object)
  end

  local function checkAt(x, y, object)
    local foundX, foundY = world:interpolate(object)
    assert.are.same({ x, y }, { foundX, foundY })
  end

  for _, fields in ipairs({ { name = "dynamic" }, { name = "kinematic", kinematic = true } }) do
    it("goes from the last place to the present one, " .. fields.name, function()
      local object = box(fields)
      world:update(0.25)
      checkAt(0, 0, object)
      world:update(0.125)
      checkAt(5, -2.5, object)
      world:update(0.0625)
      checkAt(7.5, -3.75, object)
      world:update(0.0625)
      checkAt(10, -5, object)
      assert.are.equal(20, object.x)
    end)
  end

  it("is x, y for an object that is new, static, not active or not in the world", function()
    local static = box({ static = true, x = 50 })
    world:update(0.25)
    world:update(0.125)
    checkAt(50, 0, static)
    checkAt(100, 0, box({ x = 100 }))
    checkAt(3, 4, { x = 3, y = 4, width = 1, height = 1 })
    local idle = box({ x = 200 })
    world:update(0.25)
    idle.active = false
    world:update(0.25)
    checkAt(210, -5, idle)
  end)

  it("is where the game has put a dynamic object", function()
    local object = box()
    world:update(0.25)
    world:update(0.125)
    object.x, object.y = 300, 100
    checkAt(300, 100, object)
    world:update(0.25) -- from there it goes on
    checkAt(305, 97.5, object)
  end)

  it("is on the way to where the game has put a kinematic object", function()
    local object = box({ kinematic = true, vx = 0, vy = 0 })
    world:update(0.25)
    world:update(0.125)
    object.x = 16
    checkAt(0, 0, object)
    world:update(0.25)
    checkAt(8, 0, object)
    world:update(0.25)
    checkAt(16, 0, object)
  end)

  it("keeps a rider on its lift", function()
    world = physics.newWorld({ gravity = 640, timestep = 0.03125 })
    local lift = world:add("lifts", {
      x = 0,
      y = 100,
      width = 40,
      height = 8,
      kinematic = true,
      vx = 70,
      vy = -50,
    })
    local rider = world:add("boxes", { x = 10, y = 84, width = 16, height = 16 })
    for i = 1, 60 do
      world:update(0.01 + i % 3 * 0.004)
      local _, liftY = world:interpolate(lift)
      local _, riderY = world:interpolate(rider)
      assert.is_true(math.abs(riderY + 16 - liftY) < 1e-9, ("frame %d"):format(i))
    end
  end)
end)
