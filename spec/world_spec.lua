--- The module and its worlds: `load`, `world:shift`, `world:impulse`, `world:setBounds` and
--- `world:explode`. (Objects, steps, states, queries and the tutorial's functions have files.)

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local box, newBox, newFloor, still = small.put, small.box, small.floor, small.still

local function crate(x, y, changes)
  local object = box(x, y, 20, 20, changes)
  object.name = "it"
  return object
end

local DT = 1 / 60

describe("load: the default world", function()
  before_each(function()
    physics.load({ gravity = 800 })
  end)

  after_each(function()
    physics.load()
  end)

  it("is behind the functions and the fields of the module", function()
    physics.objects.tiles = { newFloor() }
    local first, begins = physics.add("boxes", newBox(0, 60)), 0
    function physics.onBegin()
      begins = begins + 1
    end
    for _ = 1, 60 do
      physics.update(DT)
    end
    assert.same({ 84, 1, 2 }, { first.y, begins, physics.stats.objects })
    physics.gravity, first.y = 0, 0
    physics.update(DT)
    assert.same({ 0, 0 }, { first.y, physics.gravity })
    assert.is_true(physics.remove(first))
  end)

  it("is made anew, and empty, by load", function()
    physics.add("boxes", newBox(0, 0))
    physics.gravity = 5
    physics.load()
    assert.is_nil(next(physics.objects))
    assert.near(627.84, physics.gravity, 1e-9)
    assert.equal("both", physics.push)
  end)

  it("has every method of a world as a function", function()
    for name, method in pairs(getmetatable(physics.newWorld()).__index) do
      if type(method) == "function" and not name:find("^_") then
        assert.is_function(rawget(physics, name), name)
      end
    end
  end)
end)

describe("world:shift", function()
  local function newScene()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", { x = -400, y = 100, width = 1000, height = 16, static = true })
    world:add("tiles", { x = 300, y = 0, width = 16, height = 100, static = true })
    world:add("lifts", { x = 0, y = 60, width = 64, height = 8, kinematic = true, vx = 20 })
    world:add("belts", box(-200, 84, 100, 16, { static = true, surfaceSpeed = 30 }))
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
            assert.near(one.x + shifts * way[1], other.x, 1e-6)
            assert.near(one.y + shifts * way[2], other.y, 1e-6)
            assert.near(one.vx, other.vx, 1e-6)
          end
        end
        assert.same(log, logThere)
      end
    end
  end)

  -- Through the wall the way out would be shorter.
  it("takes along what has grown through a wall, on the side where it stood", function()
    local world = still()
    world:add("walls", box(50, -100, 4, 300, { static = true }))
    local one = world:add("men", box(30, 50, 16, 16))
    world:update(DT)
    one.width = 60
    world:shift(300, -200)
    small.run(world, 10)
    assert.near(290, one.x, 1e-6)
  end)

  it("takes along interpolation, tiles, and tiles that wait", function()
    local world = physics.newWorld({ gravity = 800, timestep = 1 / 60 })
    local tiles = world:addTiles("earth", { "####", "####" }, nil, 16, { y = 100 })
    local away = world:addTiles("more", { "##" }, nil, 16, { x = 200, y = 100 })
    away:unload()
    local one = world:add("men", { x = 4, y = 60, width = 8, height = 8, vx = 30 })
    world:update(1 / 60)
    world:update(1 / 120)
    local x, y = world:interpolate(one)
    world:shift(50, -20)
    local x2, y2 = world:interpolate(one)
    assert.near(x + 50, x2, 1e-9)
    assert.near(y - 20, y2, 1e-9)
    assert.same({ 1, 1 }, { tiles:cellAt(51, 81) })
    assert.same({ true, true }, { tiles:setTile(1, 1, 0), world:fits(50, 80, 16, 16) })
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
      { 0, 0, "objects.tiles[2].width must be a number > 0, got -1" },
    }) do
      small.refuses(row[3], world.shift, world, row[1], row[2])
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

it("world:impulse changes the velocity by the impulse over the mass", function()
  local world = still()
  local me = world:add("me", box(0, 0, 10, 10, { mass = 4, vx = 1 }))
  world:impulse(me, 8, -20)
  assert.are.same({ 3, -5 }, { me.vx, me.vy })
  world:update(0.02)
  assert.are.near(0.06, me.x, 1e-12)
end)

describe("world:setBounds", function()
  local FAST = scene.maker("me", { vx = 5000, vy = -9000 })("me", 50, 50, 10, 10)
  play.row("keeps everything inside, until it is taken away", play.ONCE, { FAST }, {
    "world:setBounds(0, 0, 100, 80)",
    { 1, "me.x >= 0", "me.x <= 90", "me.y >= 0", "me.y <= 70" },
    "me at 90, 70; me.touching.bottom == world.objects.bounds.bottom",
    { "world:setBounds(0, 0, 100, 90)", 1, "me.y == 80; world.stats.objects == 5" },
    { "world:setBounds()", 1 / 60, "world.objects.bounds == nil; world.stats.objects == 1" },
  })

  --   +-------------+    x from -64 to 164
  --   +--+-------+--+
  --   |  |       |  |    0 .. 100, 0 .. 80
  --   +--+-------+--+
  --   +-------------+    y from -64 to 144
  it("closes the corners, too", function()
    local world = still()
    world:setBounds(0, 0, 100, 80)
    for _, row in ipairs({
      { "top", -64, -64, 228, 64 },
      { "bottom", -64, 80, 228, 64 },
      { "left", -64, 0, 64, 80 },
      { "right", 100, 0, 64, 80 },
    }) do
      local wall = world.objects.bounds[row[1]]
      assert.same({ row[2], row[3], row[4], row[5] }, { wall.x, wall.y, wall.width, wall.height })
      assert.is_true(wall.static)
    end
  end)

  it("leaves the game's own objects in the group alone", function()
    local world = still()
    local own = world:add("bounds", box(0, 0, 1, 1))
    world:setBounds(0, 0, 100, 80)
    world:setBounds()
    assert.are.same({ own }, world.objects.bounds)
    world.objects.bounds.top = box(0, 0, 1, 1)
    local words = "objects.bounds.top must be free for a wall"
    small.refuses(words, world.setBounds, world, 0, 0, 100, 80)
  end)
end)

describe("world:explode", function()
  -- A crate of 20 px, an explosion at (0, 0) of 100 px and 600.
  play.row("pushes away: {what}", play.ONCE, function(v)
    return { gravity = 0, { "crates", crate(v.x, v.y, v.fields) } }
  end, {
    "list, count = world:explode(0, 0, 100, 600); count == 1; list[1] == it.raw",
    "it.vx ~ vx; it.vy ~ vy",
  }, {
    "what, x, y, fields, vx, vy",
    { "to the right", 30, -10, {}, 420, 0 },
    { "its mass counts", 30, -10, { mass = 2 }, 210, 0 },
    { "what it had is kept", 30, -10, { vx = -20, vy = 7 }, 400, 7 },
    { "around the centre", -5, -10, {}, 600, 0 },
    { "in the centre: up", -10, -10, {}, 0, -600 },
    { "nearly at the rim", 99, -10, {}, 6, 0 },
    -- The nearest corner is 50 px away, the middle at (40, 50) of 64 px.
    { "askew", 30, 40, {}, 300 * 40 / math.sqrt(4100), 300 * 50 / math.sqrt(4100) },
    -- A circle: its middle is 50 px away, its rim 40 px.
    { "a circle", 20, 30, { radius = 10, sensor = true }, 360 * 0.6, 360 * 0.8 },
  })

  play.row("leaves alone: {what}", play.ONCE, function(v)
    return { gravity = 0, { "crates", crate(v.x, v.y, v.fields) } }
  end, {
    "list, count = world:explode(0, 0, 100, 600); count == 0; list[1] == nil",
    "it.vx == 0; it.vy == 0",
  }, {
    "what, x, y, fields",
    { "beyond the rim", 100, -10, {} },
    { "beyond the rim, in its square", 80, 80, {} },
    { "what is inactive", 30, -10, { active = false } },
    { "what is static", 30, -10, { static = true } },
    { "what is kinematic", 30, -10, { kinematic = true } },
  })

  play.row("draws in with a negative impulse, and wakes what rests", play.ONCE, {
    gravity = 0,
    { "crates", crate(30, -10) },
  }, { { "run:play(1 / 30); world:explode(0, 0, 100, -100)", 1 / 60, "it.x < 30" } })

  it("pushes those that the filter names, and are in sight", function()
    local world = still()
    local shown, hidden = world:add("crates", crate(-60, -10)), world:add("crates", crate(60, -10))
    local low, gem = world:add("crates", crate(-10, 60)), world:add("gems", crate(-60, 20))
    -- They hide the centres only.
    local wall = world:add("walls", crate(30, -50, { height = 54, static = true }))
    world:add("walls", crate(-50, 30, { width = 54, static = true }))
    local function pushed(...)
      local list, count = world:explode(0, 0, 100, 10, ...)
      assert.are.equal(count, #list)
      return list
    end
    assert.are.same({ shown, hidden, low, gem }, pushed())
    assert.are.same({ shown, hidden, low }, pushed("crates"))
    assert.are.same({ shown }, pushed("crates", "walls"))
    -- A crate does not hide itself.
    assert.are.same({ shown, gem }, pushed(nil, { "walls", "crates" }))
    assert.are.same(
      { gem },
      pushed("gems", function(object)
        return object == wall
      end)
    )
  end)

  -- (Wrong numbers are in debugging_bad_input_spec.)
  it("is refused where something is wrong, and has changed nothing", function()
    local world = still()
    local one, other = world:add("crates", crate(30, -10)), world:add("crates", crate(30, -40))
    for _, row in ipairs({
      { "walls: filter must be a group name", 1, 1, true },
      { "after it must be a number in", 1e-99, 1e50 },
      { 'mass must be a number > 0, got "heavy"', "heavy", 1 },
    }) do
      other.mass = row[2]
      small.refuses(row[1], world.explode, world, 0, 0, 100, row[3], nil, row[4])
      assert.are.same({ 0, 0 }, { one.vx, one.vy })
    end
    other.mass, other.vx = 1, nil
    world:explode(0, 0, 100, 1)
    assert.is_true(one.vx > 0 and other.vx > 0)
  end)
end)
