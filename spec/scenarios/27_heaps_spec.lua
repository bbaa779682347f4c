--- Heaps of balls: they come to rest, and are no rocks then.

local effort = require("spec.support.effort")
local newOverlaps = require("spec.support.overlap").checker
local newRandom = require("spec.support.random").new
local physics = require("physics")
local small = require("spec.support.small")

local run = small.play

local long = effort.isFirst and it or pending
local COUNT = effort.isWhole and 60 or 24 -- balls of a heap

local function wall(world, x, y, width, height)
  return world:add("walls", small.tile(x, y, width, height))
end

-- A shaft 160 px wide, or so wide, with a floor at y 400. Returns the world and its floor.
local function newShaft(settings, width)
  width = width or 160
  local world = physics.newWorld(settings)
  world.gravity = 800
  local floor = wall(world, -20, 400, width + 40, 20)
  wall(world, -20, -3000, 20, 3400)
  wall(world, width, -3000, 20, 3400)
  return world, floor
end

-- Balls of 7 to 10 px: in six columns, at random places above each other, or every third a box.
local function fill(world, kind, seed)
  local random = newRandom(seed)
  for i = 0, COUNT - 1 do
    local radius = random:between(7, 10)
    local object = { restitution = seed % 2 == 0 and 0.3 or 0 }
    object.friction = (seed % 3 == 0 or kind == "mixed") and 0.4 or nil
    if kind == "poured" then
      object.x, object.y = random:between(1, 138), 370 - 12 * i
    else
      object.x, object.y = 4 + i % 6 * 25 + random:between(0, 4), 380 - 20 - (i - i % 6) / 6 * 26
    end
    if kind == "mixed" and i % 3 == 0 then
      object.width, object.height = 2 * radius, 2 * radius
    else
      object.radius = radius
    end
    world:add("balls", object)
  end
end

local function newHeap(kind, seed, settings)
  local world, floor = newShaft(settings)
  fill(world, kind, seed)
  return world, floor
end

local settled -- a heap that has come to rest, as saved

-- Returns the world of that heap, and its floor.
local function newSettled()
  if not settled then
    local world = newHeap("poured", 4)
    run(world, 8)
    settled = world:save()
  end
  local world = physics.newWorld()
  world:restore(settled)
  return world, world.objects.walls[1]
end

-- A heap of ten from x on, at rest.
local function newTen(x)
  local world = newShaft()
  for i = 0, 9 do
    world:add("balls", { x = x + 12 * (i % 5), y = 300 - 14 * (i - i % 5), radius = 8 })
  end
  run(world, 6)
  assert.are.equal(10, world.stats.resting)
  return world
end

-- The y of the highest of a group.
local function topOf(group)
  local top = math.huge
  for _, object in ipairs(group) do
    top = math.min(top, object.y)
  end
  return top
end

-- 100 balls of 6 to 10 px, poured one after the other into a room 360 px wide.
local function pour(world, seed, rate, each)
  local random, balls = newRandom(seed), {}
  for step = 1, 10 * rate do
    if step % (rate / 10) == 0 then
      local n = #balls
      local x, radius = 170 + (n % 3 - 1) * 30 + random:between(0, 6), random:between(6, 10)
      local ball = { x = x, y = 20, radius = radius, restitution = seed % 2 == 0 and 0.4 or nil }
      balls[n + 1] = world:add("balls", ball)
    end
    world:update(1 / rate)
    each(step, balls)
  end
  return balls
end

-- The gap between two balls, px, and the normal from the second to the first.
local function gapOf(one, other)
  local x, y =
    one.x + one.radius - other.x - other.radius, one.y + one.radius - other.y - other.radius
  local distance = math.sqrt(x * x + y * y)
  return distance - one.radius - other.radius, x / distance, y / distance
end

-- The deepest overlap of two balls, and the deepest one of a ball and a room so wide.
local function depths(balls, width)
  local ofBalls, ofRoom = 0, 0
  for n, one in ipairs(balls) do
    ofRoom = math.max(ofRoom, -one.x, one.x + one.width - width, one.y + one.height - 400)
    for m = 1, n - 1 do
      ofBalls = math.max(ofBalls, -gapOf(one, balls[m]))
    end
  end
  return ofBalls, ofRoom
end

-- Whether others, or the room, bear a ball from both sides or straight from below.
local function isBorne(balls, one)
  local isLeft, isRight = one.x < 0.4, one.x + one.width > 360 - 0.4
  for _, other in ipairs(balls) do
    local gap, x, y = 1, 0, 0
    if other ~= one then
      gap, x, y = gapOf(one, other)
    end
    if gap < 0.4 and y < 0.1 then
      isLeft, isRight = isLeft or x > -0.05, isRight or x < 0.05
    end
  end
  return isLeft and isRight or one.y + one.height > 400 - 0.4
end

-- They were pushed off the floor by hundredths of a px, and came onto it anew, in each step.
small.rows("touching and onBegin: {1} balls side by side touch once", { 10, 20 }, function(count)
  local world, begins = physics.newWorld({ gravity = 600 }), 0
  world:setBounds(0, 0, 400, 300)
  for n = 1, count do
    world:add("balls", { x = 3 + 17 * n, y = 20, radius = 5 + n % 4 * 2 })
  end
  run(world, 5)
  world.onBegin = function()
    begins = begins + 1
  end
  run(world, 1)
  assert.is_true(begins <= 2)
  for _, ball in ipairs(world.objects.balls) do
    assert.equal(300 - ball.y - ball.height < 0.05, ball.touching.bottom ~= false)
  end
end)

describe("radius: a heap of balls", function()
  small.rows("comes to rest: {1}", { "columns", "poured", "mixed" }, function(kind)
    for seed = 1, effort.share(4) do
      local world = newHeap(kind, seed)
      small.run(world, 600, 60, function(n)
        if n % 20 == 0 and kind ~= "mixed" then
          local ofBalls, ofRoom = depths(world.objects.balls, 160)
          assert.is_true(ofRoom < 1, ofRoom) -- px in a wall, in the fall
          assert.is_true(n < 600 or ofBalls < 0.15 and ofRoom < 1e-6, ofBalls)
        end
      end)
      assert.are.equal(COUNT, world.stats.resting)
      local hash = world:hash()
      run(world, 1)
      assert.are.equal(hash, world:hash())
    end
  end)

  -- By rate: px by which two balls may overlap while they are poured, and when they rest. Of 100
  -- balls 11 hang in the mean of 18 heaps, and 19 in one.
  small.rows(
    "lies closely, and nothing hangs over a gap: {1} Hz #slow",
    { { 30, 1, 0.3 }, { 60, 0.55, 0.15 }, { 120, 0.5, 0.15 } },
    function(rate, whilePoured, atRest)
      for seed = 1, effort.share(2) do
        local world, deepest, inRoom = newShaft({}, 360), 0, 0
        local balls = pour(world, seed, rate, function(step, balls)
          if step % 3 == 0 then
            local ofBalls, ofRoom = depths(balls, 360)
            deepest, inRoom = math.max(deepest, ofBalls), math.max(inRoom, ofRoom)
          end
        end)
        run(world, 5, rate)
        assert.are.equal(100, world.stats.resting)
        local ofBalls, hanging = depths(balls, 360), 0
        for _, one in ipairs(balls) do
          hanging = hanging + (isBorne(balls, one) and 0 or 1)
        end
        assert.is_true(deepest < whilePoured, deepest)
        assert.is_true(ofBalls < atRest, ofBalls)
        assert.is_true(inRoom < 1e-6, inRoom)
        assert.is_true(hanging <= 19, hanging)
      end
    end
  )

  -- Balls, or each third one a box, in ten columns. The last one lands within 0.6 s. (Of 30 such
  -- heaps four rest later, at 3.1 s at the latest.)
  local heaps = { { "100", 60 }, { "100, at 30 Hz", 30 }, { "67, and 33 boxes, #slow", 60, true } }
  for _, row in ipairs(heaps) do
    local what, rate, hasBoxes = row[1], row[2], row[3]
    long("of " .. what .. " rests two seconds after it has fallen, without overlaps", function()
      local world, random = newShaft({}, 240), newRandom(4)
      for i = 0, 99 do
        local radius = random:between(6, 10)
        local object = { x = 4 + i % 10 * 23, y = 370 - (i - i % 10) / 10 * 26 }
        if hasBoxes and i % 3 == 0 then
          object.width, object.height, object.friction = 2 * radius, 2 * radius, 0.3
        else
          object.radius = radius
        end
        world:add("balls", object)
      end
      run(world, 2.6, rate)
      assert.are.equal(100, world.stats.resting)
      -- (Of 12 such heaps at 60 and 120 Hz the deepest overlap is 0.06 to 0.1 px.)
      local deepest = newOverlaps(world.objects.balls)()
      assert.is_true(deepest < 0.12, deepest)
    end)
  end

  -- The belt leads to a wall: they stand, though it runs on under them. (The last one was shaken
  -- off by 0.1 px again and again.)
  local rows = { { 6, 2 }, { 5, 21 } }
  small.rows("that waits on a belt rests: from {1} px on", rows, function(smallest, seed)
    local world, random = physics.newWorld({ gravity = 800 }), newRandom(seed)
    local belt = wall(world, 0, 100, 340, 20)
    belt.surfaceSpeed, belt.friction = 80, 0.5
    wall(world, 340, 0, 20, 120)
    for i = 1, 10 do
      local radius = random:between(smallest, 9)
      local x, y = 24 * i, 100 - 2 * radius
      world:add("balls", { x = x, y = y, radius = radius, friction = 0.5 })
    end
    run(world, 5)
    assert.are.equal(10, world.stats.resting)
    assert.is_true(depths(world.objects.balls, 340) < 0.1)
  end)

  -- (Columns of boxes at a wall went to and fro for ever, since that wall counted as coming from
  -- where the world has its zero point.)
  for _, at in ipairs({ -3000, 0, 3000 }) do
    it(("and boxes comes to rest wherever it is: %d"):format(at), function()
      local world = physics.newWorld({ gravity = 800 })
      wall(world, at - 16, 400, 192, 16)
      wall(world, at - 16, -2000, 16, 2400)
      wall(world, at + 160, -2000, 16, 2400)
      for n = 57, 136 do
        local radius, x = 6 + n * 7 % 5, at + n * 37 % 130
        local object = { x = x, y = 390 - 11 * (n - 56) - radius, mass = 1 + n % 3 }
        object.width, object.height = 2 * radius, 2 * radius
        object.radius = n * 13 % 10 < 5 and radius or nil
        world:add("balls", object)
      end
      run(world, 5)
      assert.are.equal(80, world.stats.resting)
    end)
  end

  long("is the same with rest, and with pairs and without rest", function()
    -- Half a second after the last one has come down, if it is a selection.
    local hashes, seconds = {}, effort.isWhole and 6 or 2
    for n, settings in ipairs({ {}, { rest = false, broadphase = "pairs" } }) do
      local world = newHeap("poured", 5, settings)
      run(world, seconds)
      hashes[n] = world:hash()
    end
    assert.are.equal(hashes[1], hashes[2])
  end)

  it("goes on in the same way if it is restored among boxes", function()
    local world = newHeap("mixed", 5)
    for _ = 1, effort.isWhole and 24 or 12 do
      run(world, 5 / 60)
      local other = physics.newWorld()
      other:restore(world:save())
      run(other, 1 / 60)
      run(world, 1 / 60)
      assert.are.equal(world:hash(), other:hash())
    end
  end)

  -- A coin hangs where the balls fall, and a ghost falls among them.
  long("moves nothing that it may not push, and is not moved by it", function()
    local hashes = {}
    for n, hasGuests in ipairs({ false, true }) do
      local world, coin, ghost = newShaft(), nil, nil
      fill(world, "poured", 3)
      world.canCollide = function(one, other)
        return one.static or other.static or not (one.isGhost or other.isGhost)
      end
      if hasGuests then
        coin = { x = 70, y = 350, radius = 12, sensor = true, gravity = 0, gravityX = 0 }
        ghost = { x = 30, y = 250, radius = 8, mass = 1000, isGhost = true }
        world:add("guests", coin)
        world:add("guests", ghost)
      end
      run(world, 2)
      local sum = 0
      for _, one in ipairs(world.objects.balls) do
        sum = sum + one.x + 3 * one.y
      end
      hashes[n] = sum
      if hasGuests then
        assert.are.same({ 70, 350, 30, 384 }, { coin.x, coin.y, ghost.x, ghost.y })
      end
    end
    assert.are.equal(hashes[1], hashes[2])
  end)

  it("falls when its floor goes away", function()
    local world, floor = newSettled()
    local top = topOf(world.objects.balls)
    world:remove(floor)
    run(world, 2.5)
    assert.is_true(topOf(world.objects.balls) > top + 200)
  end)

  it("comes down where balls are taken out of it", function()
    local world = newSettled()
    local list = world.objects.balls
    local top = topOf(list)
    for n = #list, 1, -1 do
      if list[n].y > 350 then
        table.remove(list, n)
      end
    end
    run(world, 4)
    assert.is_true(topOf(list) > top + 20)
    local low = 0
    for _, object in ipairs(list) do
      low = math.max(low, object.y + object.height)
    end
    assert.near(400, low, 1e-3)
  end)

  it("is pushed by a player that walks against it", function()
    local world = newTen(50)
    local player = world:add("players", { x = 2, y = 360, width = 12, height = 40, mass = 50 })
    for _ = 1, 90 do
      player.vx = 60
      world:update(1 / 60)
    end
    assert.is_true(player.x > 40, player.x)
  end)

  small.rows("stands as a pyramid, with walls: {1}", { true, false }, function(hasWalls)
    local world = physics.newWorld({ gravity = 800 })
    wall(world, -400, 200, 1000, 20)
    for row = 0, 3 do
      for i = 0, 3 - row do
        world:add("balls", { x = 20 * i + 10 * row, y = 180 - 17.4 * row, radius = 10 })
      end
    end
    if hasWalls then
      wall(world, -10, 100, 10, 100)
      wall(world, 80, 100, 10, 100)
    end
    run(world, 4)
    if hasWalls then
      assert.are.equal(10, world.stats.resting)
      assert.is_true(topOf(world.objects.balls) < 140)
    else
      assert.is_true(topOf(world.objects.balls) > 140) -- three may stay on each other
    end
  end)

  long("lies between two slopes, and in none of them", function()
    local world, random = newShaft({}, 400), newRandom(1)
    world:add("slopes", small.tile(0, 300, 150, 100, { slope = "left" }))
    world:add("slopes", small.tile(250, 300, 150, 100, { slope = "right" }))
    local count = effort.isWhole and 40 or 16
    for i = 0, count - 1 do
      local x, y = 20 + i % 10 * 36, 260 - (i - i % 10) / 10 * 30
      world:add("balls", { x = x, y = y, radius = random:between(7, 10) })
    end
    run(world, effort.isWhole and 12 or 6)
    assert.are.equal(count, world.stats.resting)
    for _, one in ipairs(world.objects.balls) do
      -- The lines go down by 100 px on 150, to the middle.
      local x, y, slant = one.x + one.radius, one.y + one.radius, math.sqrt(100 * 100 + 150 * 150)
      local ofLeft, ofRight = (300 - y) * 150 + x * 100, (300 - y) * 150 + (400 - x) * 100
      assert.is_true(math.min(ofLeft, ofRight) / slant >= one.radius - 1e-6, one.y)
      assert.is_true(one.y + one.height <= 400 + 1e-6, one.y)
    end
  end)

  -- (One that is much heavier sinks between the balls, which slide off each other.)
  long("bears a crate, and lies on boxes", function()
    local world = newSettled()
    local crate = world:add("boxes", { x = 60, y = 0, width = 40, height = 20, mass = 5 })
    run(world, 6)
    assert.are.equal(COUNT + 1, world.stats.resting)
    assert.is_true(crate.y + 20 <= 400 - 14, crate.y) -- there are balls below it
  end)

  -- The ball hangs over the corner by so many px.
  it("rolls off a corner", function()
    for _, row in ipairs({ { 0.4, true }, { 4, true }, { 4, false } }) do
      for _, rate in ipairs({ 30, 60, 240 }) do
        local world, off = physics.newWorld({ gravity = 800 }), row[1]
        wall(world, -200, 200, 500, 20)
        world:add("boxes", { x = 0, y = 160, width = 40, height = 40, static = row[2] })
        local up = math.sqrt(100 - off * off)
        local object = world:add("balls", { x = 30 + off, y = 150 - up, radius = 10 })
        run(world, 2, rate)
        assert.is_true(object.y > 160, object.y)
      end
    end
  end)
end)
