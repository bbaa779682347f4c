--- What platformers ask for: a limit for falling, velocities over ground, room to stand up, the
--- place of a contact, a world that moves.

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local function near(expected, value, tolerance)
  local difference = math.abs(value - expected)
  if difference > (tolerance or 1e-9) or difference ~= difference then
    error(("%.17g should be %.17g"):format(value, expected), 2)
  end
end

local function update(world, count)
  for _ = 1, count do
    world:update(1 / 60)
  end
end

local man = scene.thing("men", { name = "man", x = 0, y = 0, width = 8, height = 8 })
local solid = scene.maker("tiles", { static = true })
local lift = scene.maker("lifts", { kinematic = true })
local RATES = { rate = { 20, 60, 144, 240 }, turn = variants.TURNS, shift = { 0 } }

describe("maxFallSpeed", function()
  -- Up and down for 0.75 s, until it falls at 200 px/s; then evenly.
  local JUMPER = { man({ vy = -400, maxFallSpeed = 200 }) }
  play.row("limits the fall and not the jump, exactly, at every rate", RATES, JUMPER, {
    { 0.75, "man at 0, -400 * t + 400 * t * t, 1e-8", "man.vy ~ -400 + 800 * t, 1e-8" },
    { 1, "man at 0, -75 + 200 * t, 1e-8", "man.vy ~ 200, 1e-8" },
  })

  play.row("cuts a fall that is faster already, and counts along gravity", RATES, {
    man({ vy = 500, maxFallSpeed = 100 }),
    man({ name = "up", x = 40, vy = -500, maxFallSpeed = 100 }),
    man({ name = "across", x = 80, y = 80, vx = 500, maxFallSpeed = 100 }),
  }, {
    { steps = 1 },
    "man.vy == 100; up.vy ~ -500 + 800 / run.rate; across.vx == 500",
  })

  local RIDES = { lift("lift", 0, 8, 80, 8, { vy = 300 }), man({ maxFallSpeed = 50 }) }
  play.row("changes nothing of what stands, and rides on", RATES, RIDES, {
    { 1, "man.y ~ lift.y - 8", "man.vy == 0" },
  })
end)

describe("world:velocity", function()
  local function onLift(v)
    return { lift("lift", 0, 100, 100, 8, { vx = v.vx, vy = v.vy }), man({ x = 40, y = 92 }) }
  end
  -- Its velocity as a line of a row sees it.
  local row = play.with({
    ofX = function(world, view)
      return (world:velocity(view.raw))
    end,
    ofY = function(world, view)
      return (select(2, world:velocity(view.raw)))
    end,
  })

  row("is that of the rider and of its carrier", play.ONCE, onLift, {
    { "run:play(1 / 6); man.vx = 25" },
    "ofX(world, man) ~ 65; ofY(world, man) ~ -20; ofX(world, lift) ~ 40",
    { steps = 1 },
    "ofX(world, man) ~ 65; man.vx ~ 25",
  }, { "vx, vy", { 40, -20 } })

  row("knows a lift that the game puts elsewhere", play.ONCE, onLift, {
    1 / 6,
    { steps = 5, keep = "lift.x, lift.y = lift.x + 1, lift.y - 0.5" },
    "ofX(world, lift) ~ 60; ofY(world, lift) ~ -30; ofX(world, man) ~ 60; ofY(world, man) ~ -30",
    { "state = world:save()", 1 / 12, "ofX(world, lift) == 0; ofX(world, man) == 0" },
    "world:restore(state); ofX(world, lift) ~ 60; ofX(world, man) ~ 60",
  }, { "vx", { 0 } })

  row("is the speed of the jump that comes, and what it has after it", play.ONCE, onLift, {
    { "run:play(1 / 6); man.vy = -300; ofY(world, man) ~ -360" },
    { steps = 1 },
    "man.vy ~ -360 + 800 / 60; ofY(world, man) ~ man.vy",
  }, { "vx, vy", { 0, -60 } })

  row("counts belts, stacks, and what does not move or was not read yet", play.ONCE, {
    solid("belt", 0, 100, 900, 16, { surfaceSpeed = 30 }),
    man({ x = 40, y = 92 }),
    man({ name = "top", x = 40, y = 84 }),
  }, {
    1 / 6,
    "ofX(world, man) ~ 30; ofX(world, top) ~ 30; ofX(world, belt) == 0; ofY(world, belt) == 0",
    "new = world:add('men', { x = 400, y = 0, width = 4, height = 4, vx = 3, vy = 4 })",
    "(world:velocity(new)) == 3; select(2, world:velocity(new)) == 4",
  })
end)

describe("world:fits", function()
  local function newScene()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = 0, y = 100, width = 200, height = 16, static = true })
    world:add("tiles", { x = 50, y = 60, width = 50, height = 10, static = true })
    world:add("ledges", { x = 150, y = 60, width = 50, height = 8, static = true, oneWay = "top" })
    world:add("water", { x = 0, y = 0, width = 200, height = 100, static = true, sensor = true })
    world:add("crates", { x = 110, y = 84, width = 16, height = 16 })
    local one = world:add("men", { x = 60, y = 82, width = 16, height = 18 })
    world:update(1 / 60)
    return world, one
  end

  it("answers whether an object may stand up", function()
    local world, one = newScene()
    local isFree, other = world:fits(60, 68, 16, 32, one)
    assert.is_false(isFree)
    assert.equal(world.objects.tiles[2], other)
    assert.is_true(world:fits(60, 70, 16, 30, one)) -- flush with the ceiling and the floor
    assert.is_false(world:fits(60, 69.99, 16, 30.01, one))
    assert.is_true(world:fits(20, 60, 16, 40, one))
    assert.is_false(world:fits(100, 60, 16, 40, one)) -- the crate
    assert.is_true(world:fits(160, 50, 16, 50, one)) -- a one-way ledge
    one.mask = { tiles = false }
    assert.is_true(world:fits(60, 68, 16, 32, one))
  end)

  it("answers whether there is room, by groups or by a function", function()
    local world, one = newScene()
    assert.is_false(world:fits(60, 70, 16, 30))
    assert.is_true(world:fits(60, 70, 16, 30, "tiles"))
    assert.is_false(world:fits(60, 70, 16, 30, { "tiles", "men" }))
    assert.is_true(world:fits(60, 70, 16, 30, function(other)
      return other ~= one
    end))
    world.objects.crates[1].active = false
    assert.is_true(world:fits(110, 80, 16, 20))
  end)

  it("sees what was changed since the last step, and changes nothing", function()
    local world, one = newScene()
    local before = world:hash()
    world:fits(0, 0, 500, 500, one)
    assert.equal(before, world:hash())
    local crate = world:add("crates", { x = 0, y = 0, width = 8, height = 8 })
    assert.is_false(world:fits(4, 4, 8, 8))
    world:remove(crate)
    assert.is_true(world:fits(4, 4, 8, 8))
  end)
end)

describe("onBegin: the place of a contact", function()
  local RIM = 28 + 4 * 8 / 13 -- px, x of where two circles touch, 5 and 8 px around 32 and 28
  local LOW = 25 - math.sqrt(25 - (32 - RIM) ^ 2)
  local BALL, ROUND = { 20, -60, 16, 16, radius = 8 }, { 27, 20, 10, 10, radius = 5 }
  local WALL, BOUNCY = { 100, 0, 16, 400 }, { 0, 0, 10, 10, 3000, 1000, restitution = 1 }
  local GATE, FAST = { 100, 0, 4, 60, sensor = true }, { 0, 40, 10, 40, 9000 }
  local DOWN, UP = { 0, 0, 64, 64, slope = "left" }, { 0, 0, 64, 64, slope = "right" }
  local BOX = { 20, -60, 16, 16 }
  for title, row in pairs({
    -- gravity, what is met (static), what moves: x, y, width, height, vx, vy; the place
    ["its edge"] = { 800, { 0, 100, 50, 16 }, { 42, 60, 16, 24 }, "bottom", 42, 100, 50, 100 },
    ["above"] = { 0, { 0, 0, 200, 30 }, { 40, 50, 16, 24, 0, -300 }, "top", 40, 30, 56, 30 },
    ["at the right"] = { 0, { 80, 30, 10, 60 }, { 40, 50, 16, 24, 300 }, "right", 80, 50, 80, 74 },
    ["at the left"] = { 0, { 0, 30, 10, 60 }, { 40, 50, 16, 24, -300 }, "left", 10, 50, 10, 74 },
    ["where they met, not where they are"] = { 0, WALL, BOUNCY, "right", 100, 30, 100, 40 },
    ["where a sensor was entered"] = { 0, GATE, FAST, "right", 100, 40, 100, 60 },
    ["the corner that is on a slope"] = { 800, DOWN, BOX, "bottom", 20, 20, 20, 20 },
    ["the other corner on the other slope"] = { 800, UP, BOX, "bottom", 36, 28, 36, 28 },
    ["where a circle touches a box"] = { 800, { 0, 20, 64, 64 }, BALL, "bottom", 28, 20, 28, 20 },
    ["where a circle touches a circle"] = { 800, ROUND, BALL, "bottom", RIM, LOW, RIM, LOW },
  }) do
    it("is " .. title .. ", for both and for the world", function()
      local world, told, objects = physics.newWorld({ gravity = row[1] }), {}, {}
      for n = 1, 2 do
        local given = row[4 - n]
        objects[n] = { x = given[1], y = given[2], width = given[3], height = given[4] }
        objects[n].vx, objects[n].vy = given[5], given[6]
        for _, name in ipairs({ "radius", "slope", "sensor", "restitution" }) do
          objects[n][name] = given[name]
        end
        objects[n].static = n == 2
      end
      for n, owner in ipairs({ objects[1], objects[2], world }) do
        function owner.onBegin(...)
          told[n] = told[n] or { ... }
        end
      end
      world:add("men", objects[1])
      world:add("tiles", objects[2])
      update(world, 60)
      assert.equal(row[4], told[1][3])
      for n = 1, 3 do
        for k = 5, 8 do
          near(row[k], told[n][k], 1e-6)
        end
        -- For a grid of cells it is in the other object, when it is a wall.
        local x, y, its = (told[n][5] + told[n][7]) / 2, (told[n][6] + told[n][8]) / 2, told[n][2]
        assert.is_true(row[1] > 0 or n == 2 or its.x <= x and x < its.x + its.width)
        assert.is_true(row[1] > 0 or n == 2 or its.y <= y and y < its.y + its.height)
      end
    end)
  end
end)

describe("world:shift", function()
  local function newScene()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = -400, y = 100, width = 1000, height = 16, static = true })
    world:add("tiles", { x = 300, y = 0, width = 16, height = 100, static = true })
    world:add("lifts", { x = 0, y = 60, width = 64, height = 8, kinematic = true, vx = 20 })
    world:add("belts", {
      x = -200,
      y = 84,
      width = 100,
      height = 16,
      static = true,
      surfaceSpeed = 30,
    })
    world:add("coins", { x = 20, y = 40, width = 8, height = 8, static = true, sensor = true })
    world:add("off", { x = 90, y = 40, width = 8, height = 8, active = false })
    for i = 1, 8 do
      local one = { x = 40 * i - 160, y = -20 - i, width = 14, height = 20, friction = 0.3 }
      one.restitution = i % 4 == 0 and 0.5 or nil
      world:add("men", one)
    end
    return world
  end

  it("moves everything, and nothing else happens: the same game goes on elsewhere", function()
    for _, way in ipairs({ { 1024, -512 }, { -4096, 0 }, { 3, 70000 } }) do
      for _, settings in ipairs({ {}, { rest = false }, { broadphase = "pairs" } }) do
        local here, there, log, logThere = newScene(), newScene(), {}, {}
        for name, value in pairs(settings) do
          here[name], there[name] = value, value
        end
        for world, list in pairs({ [here] = log, [there] = logThere }) do
          for _, name in ipairs({ "onBegin", "onEnd", "onCrush" }) do
            world[name] = function(a, b, side)
              list[#list + 1] = name .. " " .. tostring(side) .. " " .. a.width .. " " .. b.width
            end
          end
        end
        for n = 1, 200 do
          if n % 40 == 0 then
            there:shift(way[1], way[2])
            local count = #logThere
            assert.equal(#log, count)
          end
          here:update(1 / 60)
          there:update(1 / 60)
          local shifts = math.floor(n / 40)
          for i, one in ipairs(here.objects.men) do
            local other = there.objects.men[i]
            near(one.x + shifts * way[1], other.x, 1e-6)
            near(one.y + shifts * way[2], other.y, 1e-6)
            near(one.vx, other.vx, 1e-6)
          end
        end
        assert.same(log, logThere)
      end
    end
  end)

  it("takes along interpolation, tiles, and tiles that wait", function()
    local world = physics.newWorld({ gravity = 800, timestep = 1 / 60 })
    local tiles = world:addTiles("earth", { "####", "####" }, nil, 16, { y = 100 })
    local away = world:addTiles("more", { "##" }, nil, 16, { x = 200, y = 100, later = true })
    local one = world:add("men", { x = 4, y = 60, width = 8, height = 8, vx = 30 })
    world:update(1 / 60)
    world:update(1 / 120)
    local x, y = world:interpolate(one)
    world:shift(50, -20)
    local x2, y2 = world:interpolate(one)
    near(x + 50, x2)
    near(y - 20, y2)
    assert.same({ 1, 1 }, { tiles:cellAt(51, 81) })
    assert.is_true(tiles:setTile(1, 1, 0))
    assert.is_true(world:fits(50, 80, 16, 16))
    assert.is_false(world:fits(66, 80, 16, 16))
    away:load()
    assert.is_false(world:fits(250, 80, 16, 16))
    tiles:setTile(1, 1, "#")
    assert.is_false(world:fits(50, 80, 16, 16))
  end)

  it("refuses what it cannot use, and moves nothing then", function()
    local world = newScene()
    world:update(1 / 60)
    world.objects.tiles[2].width = -1
    local x = world.objects.tiles[1].x
    for _, row in ipairs({
      { 1, nil, "dy must be a number, got nil" },
      { 1 / 0, 0, "dx must be a finite number, got inf" },
      { 0, 0, "objects.tiles%[2%].width must be a number > 0, got %-1" },
    }) do
      local ok, text = pcall(function()
        world:shift(row[1], row[2])
      end)
      assert.is_false(ok)
      assert.matches("platformers_spec.lua:%d+: physics: ", text)
      assert.matches(row[3], text)
    end
    world.objects.tiles[2].width = 16
    assert.error_matches(function()
      world:shift(9e99, 0)
      world:shift(9e99, 0)
    end, "world:shift%(dx, dy%): objects%.[a-z]+%[1%] would be too far away")
    world:shift(-9e99, 0)
    assert.equal(x < 0, world.objects.tiles[1].x <= 0)
  end)
end)
