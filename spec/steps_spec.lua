--- The setting `timestep`: the same trajectory whatever dt is, and a smooth picture all the same.

local physics = require("physics")
local everything = require("spec.support.everything")
local newRandom = require("spec.support.random").new

local STEP = 1 / 64 -- a power of two: sums of dt are exact, so both runs make the same steps
local SECONDS = 2

-- Plays the big scene, the game writing only at the first of all. Returns its hash, and by time in
-- multiples of 1/1024 s that of what had moved.
local function trackOf(lengths)
  local world, track, time = everything.new({ timestep = STEP }), {}, 0
  for _, length in ipairs(lengths) do
    world:update(length / 1024)
    time = time + length
    local objects, places = world.objects, {}
    for _, group in ipairs({ "boxes", "crates", "lifts" }) do
      for _, object in ipairs(objects[group]) do
        places[#places + 1] = ("%.17g %.17g"):format(object.x, object.y)
      end
    end
    track[math.floor(time / 16)] = table.concat(places, " ")
  end
  return world:hash(), track
end

describe("timestep", function()
  it("irregular dt give the trajectory of regular ones, to the bit", function()
    local regular, total = {}, SECONDS * 1024
    for i = 1, total / 16 do
      regular[i] = 16
    end
    local hash, track = trackOf(regular)
    for seed = 1, 4 do
      local random, lengths, left = newRandom(seed), {}, total
      while left > 0 do
        lengths[#lengths + 1] = math.min(left, random:pick({ 1, 2, 3, 11, 16, 17, 33, 64, 200 }))
        left = left - lengths[#lengths]
      end
      local found, its = trackOf(lengths)
      assert.equal(hash, found)
      for step, places in pairs(its) do
        assert(step == 0 or places == track[step], ("seed %d, step %d"):format(seed, step))
      end
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
      assert.equal(row[2], world.alpha)
    end
  end)

  it("what the game moves goes an equal part of the way in each step of an update", function()
    local world, places = physics.newWorld({ gravity = 0, timestep = 0.0625 }), {}
    local lift = { x = 0, y = 0, width = 8, height = 8, kinematic = true }
    world:add("lifts", lift)
    local box = world:add("boxes", { x = 8, y = 0, width = 8, height = 8 })
    world:update(0.0625)
    world.onStep = function()
      places[#places + 1] = box.x
    end
    lift.x = 30
    world:update(0.1875)
    assert.same({ 8, 18, 28, 38 }, { places[1], places[2], places[3], box.x })
  end)

  it("more than 0.25 s is cut to that", function()
    local world = physics.newWorld({ gravity = 0, timestep = 0.03125 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 32 })
    for _ = 1, 3 do
      world:update(10)
    end
    assert.equal(24, box.x)
    assert.equal(0, world.alpha)
  end)

  it("what is left of a long step counts in full beside a long dt", function()
    local world = physics.newWorld({ gravity = 0, timestep = 0.1875 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 16 })
    world:update(0.125)
    assert.equal(0, box.x)
    world:update(0.25)
    assert.equal(6, box.x)
  end)

  it("no time is lost over a value that is refused", function()
    local world = physics.newWorld({ gravity = 0, timestep = 0.25 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 40 })
    world:update(0.125)
    box.width = -1
    for _ = 1, 4 do
      assert.is_false((pcall(world.update, world, 0.2)))
    end
    box.width = 8
    world:update(0.125)
    assert.same({ 10, 0 }, { box.x, world.alpha })
  end)

  it("saved-up time goes with the state", function()
    local world = physics.newWorld({ gravity = 0, timestep = 0.25 })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 40 })
    world:update(0.25)
    world:update(0.125)
    local state, x = world:save(), world:interpolate(box)
    world:update(0.1875)
    world:restore(state)
    assert.equal(0.5, world.alpha)
    assert.equal(x, (world:interpolate(box)))
    world:update(0.125)
    assert.equal(20, box.x)
    assert.equal(0, world.alpha)
  end)
end)

-- A step of 0.25 s: what moves at 40 px/s is 10 px further after it, and 20 px higher at -80.
describe("world:interpolate", function()
  local NOW = { 0.25 }
  local HALF, LATER = { 0.25, 0.125 }, { 0.25, 0.125, 0.25 }
  local STILL = { kinematic = true, vx = 0, vy = 0 }
  -- what: fields; updates; fields that are written then; more updates; where it is drawn
  for _, row in ipairs({
    { "the last place after a step", {}, NOW, {}, {}, 0, 0 },
    { "between the last and the present place", {}, HALF, {}, {}, 5, -10 },
    { "at the next step again between", {}, LATER, {}, {}, 15, -30 },
    { "that of what is kinematic, too", { kinematic = true }, HALF, {}, {}, 5, -10 },
    { "x, y of what is static", { static = true }, HALF, {}, {}, 0, 0 },
    { "x, y of what is new", {}, {}, {}, {}, 0, 0 },
    { "x, y of what is not active", {}, NOW, { active = false }, { 0.25 }, 10, -20 },
    { "where the game has put it", {}, HALF, { x = 300, y = 100 }, {}, 300, 100 },
    { "from there on", {}, HALF, { x = 300, y = 100 }, { 0.25 }, 305, 90 },
    { "on the way to where it was put, kinematic", STILL, HALF, { x = 16 }, { 0.25 }, 8, 0 },
    { "at last there", STILL, HALF, { x = 16 }, { 0.25, 0.25 }, 16, 0 },
  }) do
    it("is " .. row[1], function()
      local world = physics.newWorld({ gravity = 0, timestep = 0.25 })
      local object = { x = 0, y = 0, width = 8, height = 8, vx = 40, vy = -80 }
      for name, value in pairs(row[2]) do
        object[name] = value
      end
      world:add("boxes", object)
      for _, dt in ipairs(row[3]) do
        world:update(dt)
      end
      for name, value in pairs(row[4]) do
        object[name] = value
      end
      for _, dt in ipairs(row[5]) do
        world:update(dt)
      end
      assert.same({ row[6], row[7] }, { world:interpolate(object) })
    end)
  end

  it("is x, y of what is in no world", function()
    local world = physics.newWorld({ timestep = 0.25 })
    assert.same({ 3, 4 }, { world:interpolate({ x = 3, y = 4, width = 1, height = 1 }) })
  end)

  it("keeps a rider on its lift", function()
    local world = physics.newWorld({ gravity = 640, timestep = 0.03125 })
    local lift = { x = 0, y = 100, width = 40, height = 8, kinematic = true, vx = 70, vy = -50 }
    world:add("lifts", lift)
    local rider = world:add("boxes", { x = 10, y = 84, width = 16, height = 16 })
    for i = 1, 60 do
      world:update(0.01 + i % 3 * 0.004)
      local _, liftY = world:interpolate(lift)
      local _, riderY = world:interpolate(rider)
      assert.is_true(math.abs(riderY + 16 - liftY) < 1e-9, ("frame %d"):format(i))
    end
  end)
end)
