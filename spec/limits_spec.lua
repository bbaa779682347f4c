--- An object that pulls harder than its speed limit lets it go: an engine (`ax`) with friction,
--- drag or crates in its way.

local physics = require("physics")

-- Friction of 0.5 under a gravity of 800 takes 400 px/s² off.
local FLOOR = { x = -5000, y = 0, width = 10000, height = 20, static = true, friction = 0.5 }
local AWAY = { x = -100, y = 0, width = 10, height = 10, static = true }
local RATES, FAST = { 30, 60, 144 }, 1000

local function box(fields)
  local object = { x = 0, y = -20, width = 20, height = 20, friction = 0.5 }
  for field, value in pairs(fields or {}) do
    object[field] = value
  end
  return object
end

-- Plays so many seconds; mirrored if `way` is -1. Returns the objects, floors left out.
local function play(objects, rate, seconds, settings, way)
  local world, movers = physics.newWorld(settings or { gravity = 800 }), {}
  for n, object in ipairs(objects) do
    object = box(object)
    object.friction = objects[n].friction
    if way == -1 then
      object.x, object.ax = -object.x - object.width, -(object.ax or 0)
    end
    movers[n - 1] = world:add("boxes", object)
  end
  for _ = 1, seconds * rate do
    world:update(1 / rate)
  end
  return movers, world
end

-- A row at 30, 60 and 144 Hz, and at 1000 Hz in a row of its own if that `isSlow`.
local function each(title, isSlow, check)
  it(title, function()
    for _, rate in ipairs(RATES) do
      check(rate)
    end
    if not isSlow then
      check(FAST)
    end
  end)
  if isSlow then
    it(title .. ", at 1000 Hz #slow", function()
      check(FAST)
    end)
  end
end

describe("maxSpeedX: an engine at its limit", function()
  --        +--+ ax 600 ->       no faster than 100 px/s
  --        +--+
  --  ===================
  for _, row in ipairs({
    -- Friction leaves 200 px/s², so it takes 1/2 s and 25 px to be that fast.
    { "on a rough floor", { ax = 600, maxSpeedX = 100 }, 75, 100 },
    { "with a limit of its whole speed", { ax = 600, maxSpeed = 100 }, 75, 100 },
    { "that is as fast as that already", { ax = 600, maxSpeedX = 100, vx = 100 }, 100, 100 },
    { "weaker than friction", { ax = 300, maxSpeedX = 300, vx = 300 }, 250, 200 },
    { "that does not get it going", { ax = 300, maxSpeedX = 100 }, 0, 0 },
    { "that may not go at all", { ax = 600, maxSpeedX = 0 }, 0, 0 },
    -- 1000 px/s² for 0.3 s and 45 px, then 200 the other way.
    { "that turns it round", { ax = -600, maxSpeedX = 300, vx = 300 }, -4, -140 },
    -- It begins at 100 px/s: 0.1 s and 5 px, then 1/2 s and 25 px back, then at the limit.
    { "the other way round", { ax = -600, maxSpeedX = 100, vx = 300 }, -60, -100 },
    -- (Only then, since an object that has not stood yet is dragged along its fall, too.)
    { "with some drag, as well", { ax = 700, drag = 100, maxSpeed = 100 }, 75, 100, true },
  }) do
    local fields, isLater = row[2], row[5]
    each("goes as by hand " .. row[1], false, function(rate)
      local movers, world = play({ FLOOR, box(not isLater and fields) }, rate, isLater and 1 or 0)
      for field, value in pairs(fields) do
        movers[1][field] = value
      end
      for _ = 1, rate do
        world:update(1 / rate)
      end
      assert.near(row[3], movers[1].x, 1e-9)
      assert.near(row[4], movers[1].vx, 1e-9)
      assert.equal(-20, movers[1].y)
    end)
  end

  each("has made up for a hard landing when by hand it has", false, function(rate)
    -- It falls 280 px, and meets the floor at √(2 * 800 * 280) = 669 px/s: friction stops it.
    -- That takes 0.837 s; 25 px and 1/2 s later it is as fast as it was.
    local faller = box({ y = -300, vx = 100, ax = 600, maxSpeedX = 100 })
    local movers, fall = play({ FLOOR, faller }, rate, 2), math.sqrt(2 * 280 / 800)
    assert.near(100 * fall + 25 + 100 * (2 - fall - 0.5), movers[1].x, 1e-9)
    assert.near(100, movers[1].vx, 1e-9)
  end)

  each("slides down a wall as fast as its maxSpeedY", false, function(rate)
    for _, way in ipairs({ 1, -1 }) do
      -- Friction takes half of what it falls: 400 px/s² until it goes at 100 px/s.
      local wall = { x = 20, y = -900, width = 10, height = 2000, static = true, friction = 0.5 }
      local movers = play({ wall, box({ ax = 800, maxSpeedY = 100 }) }, rate, 1, nil, way)
      assert.near(-20 + 87.5, movers[1].y, 1e-9)
      assert.near(100, movers[1].vy, 1e-9)
      assert.equal(0, movers[1].vx)
    end
  end)
end)

describe("maxSpeedX: an engine that pushes at its limit", function()
  --   +--+ ax -> +--+--+
  --   +--+       +--+--+
  -- =======================
  -- What it pushes, its ax, the others, where it is after 1 s, and how far that may be off, times
  -- dt²: for the one step in which they come to the limit. By hand they get there with a px/s²,
  -- which costs them 100² / 2 a px.
  local ONE, TWO, THREE, TOP = { x = 20 }, { x = 40 }, { x = 60 }, { y = -40 }
  local HEAVY = { x = 20, mass = 3 }
  local WEAK, STRONG = { x = 20, ax = -400 }, { x = 20, ax = -2000 }
  for _, row in ipairs({
    { "a crate", 1500, { ONE }, 100 - 100 ^ 2 / 700, 12 },
    { "two crates", 2500, { ONE, TWO }, 100 - 100 ^ 2 * 3 / 2600, 150 },
    { "three crates", 2500, { ONE, TWO, THREE }, 100 - 100 ^ 2 * 4 / 1800, 150 },
    { "a heavy one", 2500, { HEAVY }, 100 - 100 ^ 2 * 4 / 1800, 50 },
    { "a rider that stands on it", 1500, { TOP }, 100 - 100 ^ 2 / 700, 80 },
    { "one that is too heavy for it", 1500, { HEAVY }, 0, 0 },
    { "another engine that is weaker", 2000, { WEAK }, 100 - 100 ^ 2 / 800, 60 },
    { "another that is just as strong", 2000, { STRONG }, 0, 0 },
  }) do
    local others, goal, off = row[3], row[4], row[5]
    each("goes as by hand with " .. row[1], true, function(rate)
      for _, way in ipairs({ 1, -1 }) do
        local objects = { FLOOR, box({ ax = row[2], maxSpeedX = 100 }) }
        for n, other in ipairs(others) do
          objects[n + 2] = box(other)
          objects[n + 2].maxSpeedX = other.ax and 100 or nil
        end
        local movers = play(objects, rate, 1, nil, way)
        local start = way > 0 and 0 or -20
        assert.near(goal * way, movers[1].x - start, off / rate ^ 2 + 1e-9)
        local speed = goal > 0 and 100 or 0
        for n, mover in ipairs(movers) do
          -- (A rider comes to it by halves of what is missing, one a step.)
          assert.near(speed * way, mover.vx, 1e-5)
          local isBeside = n > 1 and others[n - 1].x
          assert.is_true(not isBeside or (mover.x - start) * way > 0)
        end
      end
    end)
  end

  -- 1600 px/s² for both, then 600, until they are as fast as the slower one may be.
  for _, row in ipairs({
    { 60, 2000, 60 - 60 ^ 2 / 3200, 120 },
    { 30, 0, 30 - 30 ^ 2 / 1200, 0 },
  }) do
    local limit, ax, goal, off = row[1], row[2], row[3], row[4]
    each(("goes as fast as one that may go at %d px/s"):format(limit), true, function(rate)
      for _, way in ipairs({ 1, -1 }) do
        local slower = box({ x = 20, ax = ax, maxSpeedX = limit })
        local objects = { FLOOR, box({ ax = 2000, maxSpeedX = 100 }), slower }
        local movers = play(objects, rate, 1, nil, way)
        assert.near(goal * way, movers[1].x - (way > 0 and 0 or -20), off / rate ^ 2 + 1e-9)
        assert.near(limit * way, movers[1].vx, 1e-9)
        assert.near(limit * way, movers[2].vx, 1e-9)
        assert.near(20 * way, movers[2].x - movers[1].x, 1e-9)
      end
    end)
  end

  each("goes at its limit from above, behind what air slows", false, function(rate)
    local engine = { x = 0, y = 0, width = 20, height = 20, ax = 1500, maxSpeedX = 100 }
    local slow = { x = 20, y = 0, width = 20, height = 20, airFriction = 5 }
    local movers = play({ AWAY, engine, slow }, rate, 2, { gravity = 0 })
    assert.near(100, movers[1].vx, 1e-9)
    assert.near(100, movers[2].vx, 1e-9)
    assert.equal(20, movers[2].x - movers[1].x)
  end)
end)

-- 1600 px/s² against two crates of 1000 each: they hold. One of them does not.
it("drag of what is pushed holds an engine as friction does", function()
  for _, rate in ipairs({ 30, 60, 144, 240 }) do
    for count = 1, 2 do
      local world = physics.newWorld({ gravity = 0 })
      local engine = { x = 0, y = 0, width = 16, height = 16, ax = 1600 }
      world:add("engines", engine)
      for n = 1, count do
        world:add("crates", { x = 16 * n, y = 0, width = 16, height = 16, drag = 1000 })
      end
      for _ = 1, rate do
        world:update(1 / rate)
      end
      assert.near(count == 1 and 150 or 0, engine.x, 1e-6)
    end
  end
end)
