--- An object that pulls harder than its speed limit lets it go: an engine (`ax`) with friction,
--- drag or crates in its way.

local physics = require("physics")
local unpack = rawget(table, "unpack") or rawget(_G, "unpack")

-- Friction of 0.5 under a gravity of 800 takes 400 px/s² off.
local FLOOR = { x = -5000, y = 0, width = 10000, height = 20, static = true, friction = 0.5 }
local RATES = { 30, 60, 144, 1000 }

local function slowAt(rate)
  return rate > 200 and " #slow" or ""
end

local function copyOf(object, changes)
  local copy = {}
  for field, value in pairs(object) do
    copy[field] = value
  end
  for field, value in pairs(changes or {}) do
    copy[field] = value
  end
  return copy
end

local function box(changes)
  return copyOf({ x = 0, y = -20, width = 20, height = 20, friction = 0.5 }, changes)
end

-- Plays so many seconds; returns the objects, floors left out.
local function play(objects, rate, seconds, settings)
  local world = physics.newWorld(settings or { gravity = 800 })
  local movers = {}
  for n, object in ipairs(objects) do
    object = world:add("boxes", copyOf(object))
    assert.equal(n == 1, object.static or false)
    movers[n - 1] = object
  end
  for _ = 1, seconds * rate do
    world:update(1 / rate)
  end
  return movers, world
end

describe("an engine at its speed limit", function()
  --        +--+ ax 600 ->       no faster than 100 px/s
  --        +--+
  --  ===================
  local ROWS = {
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
  }
  for _, row in ipairs(ROWS) do
    local name, fields, way, speed, isLater = unpack(row)
    for _, rate in ipairs(RATES) do
      it(("goes as by hand %s, at %d Hz"):format(name, rate), function()
        local movers, world =
          play({ FLOOR, box(isLater and {} or fields) }, rate, isLater and 1 or 0)
        for field, value in pairs(fields) do
          movers[1][field] = value
        end
        for _ = 1, rate do
          world:update(1 / rate)
        end
        assert.near(way, movers[1].x, 1e-9)
        assert.near(speed, movers[1].vx, 1e-9)
        assert.equal(-20, movers[1].y)
      end)
    end
  end

  for _, rate in ipairs(RATES) do
    it(("has made up for a hard landing when by hand it has, at %d Hz"):format(rate), function()
      -- It falls 280 px, and meets the floor at √(2 * 800 * 280) = 669 px/s: friction stops it.
      -- That takes 0.837 s; 25 px and 1/2 s later it is as fast as it was.
      local movers =
        play({ FLOOR, box({ y = -300, vx = 100, ax = 600, maxSpeedX = 100 }) }, rate, 2)
      local fall = math.sqrt(2 * 280 / 800)
      assert.near(100 * fall + 25 + 100 * (2 - fall - 0.5), movers[1].x, 1e-9)
      assert.near(100, movers[1].vx, 1e-9)
    end)

    for _, side in ipairs({ 1, -1 }) do
      local text = "slides down the wall to the %s as fast as its maxSpeedY, at %d Hz"
      it(text:format(side > 0 and "right" or "left", rate), function()
        -- Friction takes half of what it falls: 400 px/s² until it goes at 100 px/s.
        local wall = { x = 20, y = -900, width = 10, height = 2000, static = true, friction = 0.5 }
        local faller = box({ ax = 800 * side, maxSpeedY = 100 })
        wall.x = side > 0 and 20 or -10
        local movers = play({ wall, faller }, rate, 1)
        assert.near(-20 + 87.5, movers[1].y, 1e-9)
        assert.near(100, movers[1].vy, 1e-9)
        assert.equal(0, movers[1].vx)
      end)
    end
  end
end)

describe("an engine that pushes at its speed limit", function()
  --   +--+ ax -> +--+--+
  --   +--+       +--+--+
  -- =======================
  -- Name, the one that pushes, the others, where it is after 1 s, and how far that may be off,
  -- times dt²: for the one step in which they come to the limit. By hand they get there with
  -- a px/s², which costs them 100² / 2 a px.
  local ROWS = {
    { "a crate", { ax = 1500 }, { { x = 20 } }, 100 - 100 ^ 2 / 700, 12 },
    { "two crates", { ax = 2500 }, { { x = 20 }, { x = 40 } }, 100 - 100 ^ 2 * 3 / 2600, 150 },
    {
      "three crates",
      { ax = 2500 },
      { { x = 20 }, { x = 40 }, { x = 60 } },
      100 - 100 ^ 2 * 4 / 1800,
      150,
    },
    { "a heavy one", { ax = 2500 }, { { x = 20, mass = 3 } }, 100 - 100 ^ 2 * 4 / 1800, 50 },
    { "a rider that stands on it", { ax = 1500 }, { { y = -40 } }, 100 - 100 ^ 2 / 700, 80 },
    { "one that is too heavy for it", { ax = 1500 }, { { x = 20, mass = 3 } }, 0, 0 },
    {
      "another engine that is weaker",
      { ax = 2000 },
      { { x = 20, ax = -400 } },
      100 - 100 ^ 2 / 800,
      60,
    },
    { "another that is just as strong", { ax = 2000 }, { { x = 20, ax = -2000 } }, 0, 0 },
  }
  for _, row in ipairs(ROWS) do
    local name, fields, others, way, off = unpack(row)
    for _, rate in ipairs(RATES) do
      for _, side in ipairs({ 1, -1 }) do
        local text = "goes as by hand with %s, at %d Hz, to the %s" .. slowAt(rate)
        it(text:format(name, rate, side > 0 and "right" or "left"), function()
          local objects = { FLOOR, box(copyOf(fields, { ax = fields.ax * side, maxSpeedX = 100 })) }
          for _, other in ipairs(others) do
            local its = { x = (other.x or 0) * side, ax = (other.ax or 0) * side }
            its.maxSpeedX = other.ax and 100 or nil
            objects[#objects + 1] = box(copyOf(other, its))
          end
          local movers = play(objects, rate, 1)
          assert.near(way * side, movers[1].x, off / rate ^ 2 + 1e-9)
          local speed = way > 0 and 100 or 0
          for n, mover in ipairs(movers) do
            -- (A rider comes to it by halves of what is missing, one a step.)
            assert.near(speed * side, mover.vx, 1e-5)
            assert.is_true(n == 1 or others[n - 1].x == nil or mover.x * side > 0)
          end
        end)
      end
    end
  end

  -- 1600 px/s² for both, then 600, until they are as fast as the slower one may be.
  local SLOWER = { { 60, 2000, 60 - 60 ^ 2 / 3200, 120 }, { 30, 0, 30 - 30 ^ 2 / 1200, 0 } }
  for _, row in ipairs(SLOWER) do
    local limit, ax, way, off = unpack(row)
    for _, rate in ipairs(RATES) do
      for _, side in ipairs({ 1, -1 }) do
        local text = "goes as fast as one that may go at %d px/s, at %d Hz, to the %s"
          .. slowAt(rate)
        it(text:format(limit, rate, side > 0 and "right" or "left"), function()
          local movers = play({
            FLOOR,
            box({ ax = 2000 * side, maxSpeedX = 100 }),
            box({ x = 20 * side, ax = ax * side, maxSpeedX = limit }),
          }, rate, 1)
          assert.near(way * side, movers[1].x, off / rate ^ 2 + 1e-9)
          assert.near(limit * side, movers[1].vx, 1e-9)
          assert.near(limit * side, movers[2].vx, 1e-9)
          assert.near(20 * side, movers[2].x - movers[1].x, 1e-9)
        end)
      end
    end
  end

  for _, rate in ipairs(RATES) do
    it(("goes at its limit from above, behind what air slows, at %d Hz"):format(rate), function()
      local movers = play({
        { x = -100, y = 0, width = 10, height = 10, static = true },
        { x = 0, y = 0, width = 20, height = 20, ax = 1500, maxSpeedX = 100 },
        { x = 20, y = 0, width = 20, height = 20, airFriction = 5 },
      }, rate, 2, { gravity = 0 })
      assert.near(100, movers[1].vx, 1e-9)
      assert.near(100, movers[2].vx, 1e-9)
      assert.equal(20, movers[2].x - movers[1].x)
    end)
  end

  for _, rate in ipairs(RATES) do
    it(("is not driven on by what runs into it from behind, at %d Hz"):format(rate), function()
      local movers = play({
        { x = -100, y = 0, width = 10, height = 10, static = true },
        { x = 0, y = 0, width = 20, height = 20, mass = 3, vx = 100 },
        { x = 30, y = 0, width = 20, height = 20, ax = 2500, vx = 60, maxSpeedX = 60 },
      }, rate, 1, { gravity = 0 })
      -- (In the step of the impact both go as fast as their momentum is, for a part of it.)
      assert.near(90, movers[2].x, rate == 30 and 0.5 or 1e-9)
      assert.near(20, movers[2].x - movers[1].x, 1e-9)
      assert.near(60, movers[1].vx, 1e-9)
      assert.near(60, movers[2].vx, 1e-9)
    end)
  end

  it("leaves a crate behind it alone, and one that is faster", function()
    local movers = play({
      FLOOR,
      box({ x = 40, ax = 600, maxSpeedX = 100, vx = 100 }),
      box({ x = 20 }),
      box({ x = 60, vx = 300 }),
    }, 60, 0.5)
    assert.near(90, movers[1].x, 1e-9)
    assert.equal(20, movers[2].x)
    assert.near(60 + 300 * 0.5 - 200 * 0.25, movers[3].x, 1e-9)
  end)

  it("pushes by what is left of its pull, where only one of two may give way", function()
    for _, push in ipairs({ "first", "both" }) do
      local movers = play({
        FLOOR,
        box({ ax = 1500, maxSpeedX = 100 }),
        box({ x = 20 }),
      }, 60, 1, { gravity = 800, push = push })
      assert.near(100, movers[1].vx, 1e-9)
      assert.near(100, movers[2].vx, 1e-9)
      assert.near(20, movers[2].x - movers[1].x, 1e-9)
    end
  end)
end)

describe("drag", function()
  -- 1600 px/s² against two crates of 1000 each: they hold. One of them does not.
  for _, rate in ipairs({ 30, 60, 144, 240 }) do
    it(("of what is pushed holds an engine as friction does, at %d Hz"):format(rate), function()
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
    end)
  end
end)
