--- Steps and time: `timestep`, `maxStep`, `onStep`, and what an update of no time does.

local physics = require("physics")
local everything = require("spec.support.everything")
local newRandom = require("spec.support.random").new
local small = require("spec.support.small")

local newBox, update = small.box, small.run

local DT = 1 / 60

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
      small.run(world, rate, rate)
      assert.is_true(math.abs(box.x - rate) < 1e-6, ("%d Hz: %.17g"):format(rate, box.x))
    end
  end)

  -- what, timestep; for each update dt, where a box of 32 px/s is then, and `alpha`
  for _, row in ipairs({
    { "it is the saved-up share of a step", 0.25, { 0, 0, 0 }, { 0.0625, 0, 0.25 } },
    { "what is left adds up", 0.25, { 0.0625, 0, 0.25 }, { 0.125, 0, 0.75 }, { 0.0625, 8, 0 } },
    { "nothing is left of whole steps", 0.0625, { 0.25, 8, 0 }, { 0.078125, 10, 0.25 } },
    { "more than 0.25 s is cut to that", 0.03125, { 10, 8, 0 }, { 10, 16, 0 }, { 10, 24, 0 } },
    { "of a long step it counts in full", 0.1875, { 0.125, 0, 2 / 3 }, { 0.25, 12, 0 } },
  }) do
    it("alpha: " .. row[1], function()
      local world = physics.newWorld({ gravity = 0, timestep = row[2] })
      local box = world:add("boxes", newBox(0, 0, { vx = 32 }))
      for n = 3, #row do
        world:update(row[n][1])
        assert.same({ row[n][2], row[n][3] }, { box.x, world.alpha })
      end
    end)
  end

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
    assert.same({ 20, 0 }, { box.x, world.alpha })
  end)
end)

small.rows("maxStep: {2} s are equal steps of at most {1}", {
  -- maxStep, dt; where a box is after each step at 1000 px/s
  { 0.1, 0.15, { 75, 150 } },
  { 0.1, 0.25, { 250 / 3, 500 / 3, 250 } },
  { 1 / 30, 0.1, { 100 / 3, 200 / 3, 100 } },
  { 1 / 30, 0.04, { 20, 40 } },
  { 1 / 30, 1 / 30, { 100 / 3 } },
  { 0.1, 60, { 250 / 3, 500 / 3, 250 } }, -- 0.25 s at most
}, function(maxStep, dt, expected)
  local split, places = physics.newWorld({ gravity = 0, maxStep = maxStep }), {}
  local fast = split:add("boxes", newBox(0, 0, { vx = 1000 }))
  split:add("zones", { x = -50, y = 0, width = 500, height = 8, static = true, sensor = true })
  split.onBegin = function()
    places[#places + 1] = fast.x
  end
  split.onStay = split.onBegin
  split:update(dt)
  assert.equal(#expected, #places)
  for n, x in ipairs(expected) do
    assert.near(x, places[n], 1e-9)
  end
end)

describe("world:update", function()
  it("by 0 reads the tables and moves nothing", function()
    local world = physics.newWorld({ gravity = 800 })
    local first, late = world:add("boxes", newBox(0, 84, { vx = 50 })), newBox(40, 0)
    table.insert(world.objects.boxes, late)
    world:update(0)
    assert.same({ 0, 0, 50 }, { first.x, late.y, first.vx })
    late.width = -1
    assert.has_error(function()
      world:update(0)
    end)
  end)

  it("by less than 1e-10 s counts as none, so no object becomes infinitely fast", function()
    for _, dt in ipairs({ 5e-324, 1e-100, 9.9e-11, 1e-10 }) do
      local world = physics.newWorld({ gravity = 600 })
      local lift = world:add("lifts", { x = 0, y = 16, width = 100, height = 8, kinematic = true })
      local rider = world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })
      local flier = world:add("boxes", { x = 0, y = 90, width = 16, height = 16, drag = 9 })
      flier.vx, flier.airFriction = 1e6, 1
      world:update(DT)
      local place, speed = flier.x, flier.vx
      lift.x, lift.y = lift.x + 10, lift.y - 10
      world:update(dt)
      if dt < 1e-10 then
        assert.are.same({ 0, 0, place, speed }, { rider.x, rider.y, flier.x, flier.vx })
      else
        assert.is_true(flier.x > place)
      end
      assert.are.near(0, rider.vx, 1e-3)
      world:update(DT)
      assert.are.near(10, rider.x, 1e-3)
      assert.are.same({ 10, 6, -10, 0 }, { lift.x, lift.y, rider.y, rider.vy })
      assert.are.near(0, rider.vx, 1e-3)
    end
  end)
end)

-- 10 hp a second cost 20 in two seconds at 60 Hz, 59 at 10 Hz and 8 with a timestep at 144 Hz.
describe("onStay: tells how long a step is:", function()
  for _, row in ipairs({ { 60 }, { 10 }, { 144, 60 }, { 60, 144 }, { 20, 90 } }) do
    local rate, fixed = row[1], row[2]
    it(("at %d Hz, timestep %s"):format(rate, fixed and "1 / " .. fixed or "none"), function()
      local timestep = fixed and 1 / fixed
      local world = physics.newWorld({ gravity = 800, timestep = timestep })
      world:add("floors", { x = 0, y = 16, width = 16, height = 16, static = true })
      local box = world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })
      local sums = { box = 0, world = 0 }
      function box.onStay(_, _, _, time)
        sums.box = sums.box + time
      end
      function world.onStay(_, _, _, time)
        sums.world = sums.world + time
      end
      update(world, 2 * rate, rate)
      -- The first step begins the contact; what is saved up is not played yet.
      assert.near(2, sums.box, 2 * (timestep or 1 / 30) + 1e-9)
      assert.equal(sums.box, sums.world)
    end)
  end
end)

-- A controller in front of `update` acted on what an earlier step had shown, or twice in none.
describe("onStep:", function()
  it("is called before every step, with its length", function()
    for _, row in ipairs({
      -- settings, updates a second, steps of three updates and their length
      { {}, 60, 3, 1 / 60 },
      { {}, 15, 6, 1 / 30 },
      { { timestep = 1 / 64 }, 128, 1, 1 / 64 },
      { { timestep = 1 / 64 }, 32, 6, 1 / 64 },
      { {}, 1 / 0, 0 },
    }) do
      local world, count = physics.newWorld(row[1]), 0
      function world.onStep(dt)
        count = count + 1
        assert.near(row[4], dt, 1e-15)
      end
      update(world, 3, row[2])
      assert.equal(row[3], count)
    end
  end)

  it("makes a controller that jumps once, at any phase", function()
    for phase = 0, 19 do
      local world = physics.newWorld({ gravity = 800, timestep = 1 / 60 })
      world:add("floors", { x = 0, y = 100, width = 100, height = 16, static = true })
      local man = world:add("men", { x = 0, y = 76, width = 16, height = 24 })
      local isPressed, jumps = false, 0
      function world.onStep()
        if isPressed and man.touching.bottom then
          man.vy, isPressed, jumps = -400, false, jumps + 1
        end
      end
      world:update((1 + phase / 20) / 60)
      for frame = 1, 288 do
        isPressed = isPressed or frame == 100
        world:update(1 / 144)
        assert.is_true(jumps == (frame < 102 and jumps or 1) and jumps <= 1)
      end
      assert.same({ 1, 76 }, { jumps, man.y })
    end
  end)

  it("may add and remove, and an error in it leaves the step to the next update", function()
    local world, steps = physics.newWorld({ timestep = 1 / 60, gravity = 0 }), 0
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 60 })
    function world.onStep()
      steps = steps + 1
      if steps == 2 then
        error("oops", 0)
      elseif steps == 3 then
        world:add("boxes", { x = 90, y = 0, width = 8, height = 8 })
      elseif steps == 4 then
        world:remove(box)
      end
    end
    world:update(1 / 60)
    local ok, message = pcall(world.update, world, 1 / 60)
    assert.same({ false, "oops" }, { ok, message })
    assert.near(1, box.x, 1e-9)
    for objects = 2, 1, -1 do
      world:update(1 / 60)
      assert.near(2, box.x, 1e-9)
      assert.equal(objects, world.stats.objects)
    end
  end)

  it("cannot update, must be a function, and is the module's, too", function()
    local world = physics.newWorld()
    function world.onStep(dt)
      world:update(dt)
    end
    local text = "world:update(dt) cannot be called from inside onStep"
    small.refuses(text, world.update, world, 1 / 60)
    world.onStep = 3
    small.refuses("onStep must be a function, got 3", world.update, world, 1 / 60)
    world.onStep = nil
    world:update(1 / 60)
    physics.load()
    local length
    function physics.onStep(dt)
      length = dt
    end
    physics.update(1 / 60)
    assert.equal(1 / 60, length)
    physics.load()
  end)
end)
