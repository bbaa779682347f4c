--- What platformers ask for: a limit for falling, velocities over ground, room to stand up, the
--- place of a contact, a world that moves.

local physics = require("physics")

local function near(expected, value, tolerance)
  local difference = math.abs(value - expected)
  if difference > (tolerance or 1e-9) or difference ~= difference then
    error(("%.17g should be %.17g"):format(value, expected), 2)
  end
end

local function play(world, count, rate)
  for _ = 1, count do
    world:update(1 / (rate or 60))
  end
end

-- A box of 8 px.
local function small(x, fields)
  local object = { x = x, y = 0, width = 8, height = 8 }
  for name, value in pairs(fields) do
    object[name] = value
  end
  return object
end

describe("maxFallSpeed", function()
  it("limits the fall and not the jump, exactly, at every rate", function()
    for _, rate in ipairs({ 30, 60, 144, 240 }) do
      local world = physics.newWorld({ gravity = 800 })
      local one = world:add("men", small(0, { vy = -400, maxFallSpeed = 200 }))
      local highest = 0
      for n = 1, 2 * rate do
        world:update(1 / rate)
        highest = math.min(highest, one.y)
        local t = n / rate
        -- Up and down for 0.75 s, until it falls at 200 px/s; then evenly.
        local y = t < 0.75 and -400 * t + 400 * t * t or -75 + 200 * (t - 0.75)
        near(y, one.y, 1e-8)
        near(t < 0.75 and -400 + 800 * t or 200, one.vy, 1e-8)
      end
      assert.is_true(highest < -99)
    end
  end)

  it("cuts a fall that is faster already, and counts along any gravity", function()
    for _, row in ipairs({
      { 800, 0, "vy", 500 },
      { -800, 0, "vy", -500 },
      { 0, 800, "vx", 500 },
      { 0, -800, "vx", -500 },
    }) do
      local world = physics.newWorld({ gravity = row[1], gravityX = row[2] })
      local along, other = row[3], row[3] == "vx" and "vy" or "vx"
      local fast = world:add("men", small(0, { maxFallSpeed = 100, [along] = row[4] }))
      local up = world:add("men", small(40, { maxFallSpeed = 100, [along] = -row[4] }))
      local across = world:add("men", small(80, { y = 80, maxFallSpeed = 100, [other] = row[4] }))
      world:update(1 / 60)
      assert.equal(row[4] / 5, fast[along])
      near(-row[4] + row[4] / 500 * 800 / 60, up[along])
      assert.equal(row[4], across[other])
    end
  end)

  it("changes nothing of what stands, and rides on", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("lifts", { x = 0, y = 8, width = 80, height = 8, kinematic = true, vy = 300 })
    local one = world:add("men", { x = 0, y = 0, width = 8, height = 8, maxFallSpeed = 50 })
    for _ = 1, 60 do
      world:update(1 / 60)
      near(world.objects.lifts[1].y - 8, one.y, 1e-6)
      assert.equal(0, one.vy)
    end
  end)
end)

describe("world:velocity", function()
  local function newScene(fields)
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = -500, y = 100, width = 300, height = 16, static = true })
    local lift = { x = 0, y = 100, width = 100, height = 8, kinematic = true }
    for name, value in pairs(fields) do
      lift[name] = value
    end
    world:add("lifts", lift)
    local one = world:add("men", { x = 40, y = 76, width = 16, height = 24 })
    play(world, 10)
    return world, one, lift
  end

  local function expect(world, object, vx, vy, isWritten)
    local itsX, itsY = world:velocity(object)
    near(vx, itsX, isWritten and 1e-6 or nil)
    near(vy or itsY, itsY, isWritten and 1e-6 or nil)
  end

  it("is that of the rider and of its carrier", function()
    local world, one, lift = newScene({ vx = 40, vy = -20 })
    one.vx = 25
    expect(world, one, 65, -20)
    expect(world, lift, 40, -20)
    world:update(1 / 60)
    expect(world, one, 65)
    near(25, one.vx)
  end)

  it("knows a lift that the game moves by writing its place, also after a restore", function()
    local world, one, lift = newScene({})
    for _ = 1, 5 do
      lift.x, lift.y = lift.x + 1, lift.y - 0.5
      world:update(1 / 60)
    end
    expect(world, lift, 60, -30, true)
    expect(world, one, 60, -30, true)
    local state = world:save()
    play(world, 5)
    assert.equal(0, (world:velocity(lift)))
    assert.equal(0, (world:velocity(one)))
    world:restore(state)
    expect(world, lift, 60, nil, true)
    expect(world, one, 60, nil, true)
  end)

  it("is the speed of the jump that comes, and what it has after it", function()
    local world, one = newScene({ vy = -60 })
    one.vy = -300
    local _, vy = world:velocity(one)
    near(-360, vy)
    world:update(1 / 60)
    near(-360 + 800 / 60, one.vy)
    _, vy = world:velocity(one)
    near(one.vy, vy)
  end)

  it("counts belts, stacks, and what does not move or was not read yet", function()
    local world = physics.newWorld({ gravity = 800 })
    local belt = { x = 0, y = 100, width = 900, height = 16, static = true, surfaceSpeed = 30 }
    world:add("belts", belt)
    local low = world:add("men", { x = 40, y = 84, width = 16, height = 16 })
    local top = world:add("men", { x = 40, y = 68, width = 16, height = 16 })
    play(world, 10)
    near(30, (world:velocity(low)))
    near(30, (world:velocity(top)))
    assert.same({ 0, 0 }, { world:velocity(belt) })
    local new = world:add("men", { x = 400, y = 0, width = 4, height = 4, vx = 3, vy = 4 })
    assert.same({ 3, 4 }, { world:velocity(new) })
  end)
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
  local BALL = { 20, -60, 16, 16, radius = 8 }
  for title, row in pairs({
    -- gravity, what is met (static), what moves: x, y, width, height, vx, vy; the place
    ["its edge"] = { 800, { 0, 100, 50, 16 }, { 42, 60, 16, 24 }, "bottom", 42, 100, 50, 100 },
    ["above"] = { 0, { 0, 0, 200, 30 }, { 40, 50, 16, 24, 0, -300 }, "top", 40, 30, 56, 30 },
    ["at the right"] = { 0, { 80, 30, 10, 60 }, { 40, 50, 16, 24, 300 }, "right", 80, 50, 80, 74 },
    ["at the left"] = { 0, { 0, 30, 10, 60 }, { 40, 50, 16, 24, -300 }, "left", 10, 50, 10, 74 },
    ["where they met, though they have parted since"] = {
      0,
      { 100, 0, 16, 400 },
      { 0, 0, 10, 10, 3000, 1000, restitution = 1 },
      "right",
      100,
      30,
      100,
      40,
    },
    ["where a sensor was entered"] = {
      0,
      { 100, 0, 4, 60, sensor = true },
      { 0, 40, 10, 40, 9000 },
      "right",
      100,
      40,
      100,
      60,
    },
    ["the corner that is on a slope"] = {
      800,
      { 0, 0, 64, 64, slope = "left" },
      { 20, -60, 16, 16 },
      "bottom",
      20,
      20,
      20,
      20,
    },
    ["the other corner on the other slope"] = {
      800,
      { 0, 0, 64, 64, slope = "right" },
      { 20, -60, 16, 16 },
      "bottom",
      36,
      28,
      36,
      28,
    },
    ["where a circle touches a box"] = { 800, { 0, 20, 64, 64 }, BALL, "bottom", 28, 20, 28, 20 },
    ["where a circle touches a circle"] = {
      800,
      { 27, 20, 10, 10, radius = 5 },
      BALL,
      "bottom",
      RIM,
      LOW,
      RIM,
      LOW,
    },
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
      play(world, 60)
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
