--- Worlds: which objects are in them, how these come and go, and what may change at run time.

local newBox = require("spec.support.box")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")

local DT = 1 / 60
local ONCE = play.ONCE

local box = scene.thing("boxes", { name = "box", x = 0, y = 84, width = 16, height = 16 })
local solid = scene.maker("tiles", { static = true })
local FLOOR = solid("floor", -200, 100, 800, 16)
local STANDS = { FLOOR, box() }

local function newFloor(y)
  return { x = -200, y = y or 100, width = 800, height = 16, static = true }
end

local function run(world, steps)
  for _ = 1, steps or 60 do
    world:update(DT)
  end
end

local function row(title, entries, given, rows)
  play.row(title, ONCE, entries, given, rows, {
    newBox = newBox,
    DT = DT,
    down = { boxes = { tiles = false } },
    up = { tiles = { boxes = false } },
    both = { tiles = true },
  })
end

local function named(name, number)
  return { name = name, x = 20 * number, y = 0, width = 8, height = 8, gravity = 0 }
end

describe("world.objects", function()
  local world

  before_each(function()
    world = physics.newWorld({ gravity = 800 })
  end)

  it("stand in groups under numbers and names, or directly in the table", function()
    world.objects.tiles = { newFloor() }
    world.objects.boxes = { newBox(0, 50), newBox(30, 50) }
    world.objects.enemies = { spike = newBox(60, 50), [7] = newBox(90, 50), [-2] = newBox(120, 50) }
    world.objects.player, world.objects[3] = newBox(150, 50), newBox(180, 50)
    world.objects[4] = { newBox(210, 50) }
    local list = { world.objects.player, world.objects[3], world.objects[4][1] }
    for _, group in ipairs({ world.objects.boxes, world.objects.enemies }) do
      for _, object in pairs(group) do
        list[#list + 1] = object
      end
    end
    run(world)
    assert.equal(9, world.stats.objects)
    assert.equal(8, #list)
    for _, object in ipairs(list) do
      assert.equal(84, object.y)
      assert.equal(world.objects.tiles[1], object.touching.bottom)
    end
  end)

  -- What a sensor that holds all of them is told of, one after the other.
  local function orderOf(settings)
    local text = ""
    for name, value in pairs(settings) do
      world[name] = value
    end
    local sensor = { x = -99, y = -99, width = 999, height = 999, static = true, sensor = true }
    function sensor.onBegin(_, other)
      text = text .. other.name
    end
    world.objects.zzz = { sensor }
    world:update(DT)
    world.objects.zzz = nil
    world:update(DT)
    return text
  end

  it("are ordered by group and key, numbers before strings, whatever came first", function()
    world.objects.b = { x = named("3", 1), [2.5] = named("2", 2), [-1] = named("1", 3) }
    world.objects.c = named("4", 4)
    world.objects.a = { named("0", 5) }
    world.objects[2] = { named("B", 6) }
    world.objects[-1] = named("A", 7)
    assert.equal("AB01234", orderOf({}))
  end)

  it("follow the setting order, also when nothing else has changed", function()
    for number, name in ipairs({ "a", "b", "c" }) do
      world:add(name, named(name, number))
    end
    assert.equal("cab", orderOf({ order = { "c", "a" } }))
    assert.equal("bac", orderOf({ order = { "b" } }))
    world.order = nil
    assert.equal("abc", orderOf({}))
  end)

  row("may move to another group, and meet its masks from then on", {
    masks = { ghosts = { tiles = false } },
    FLOOR,
    box(),
  }, {
    { "listen box", { steps = 5 }, "box.y == 84" },
    { "world.objects.boxes, world.objects.ghosts = nil, { box.raw }", { steps = 30 } },
    { "box.y > 110", "box heard 1, 1", "box.touching.bottom == false" },
  })

  it("may be class instances, in groups that are class instances, too", function()
    local Box, Group = { width = 16, height = 16, friction = 0.5 }, {}
    Box.__index, Group.__index = Box, Group
    -- Two boxes are equal for the game, if they have the same name.
    function Box.__eq(a, b)
      return a.name == b.name
    end
    function Group.count(self)
      return #self
    end
    local first = setmetatable({ x = 0, y = 84, name = "box" }, Box)
    local second = setmetatable({ x = 100, y = 0, name = "box" }, Box)
    world:add("tiles", newFloor())
    world.objects.boxes = setmetatable({ first }, Group)
    run(world, 10)
    assert.same({ 84, 1 }, { first.y, world.objects.boxes:count() })
    world.objects.boxes[1] = second
    run(world)
    assert.equal(84, second.y)
    assert.is_nil(rawget(second, "width"))
    world:add("boxes", first)
    assert.is_true(world:remove(second))
    assert.is_true(rawequal(first, world.objects.boxes[1]))
  end)

  it("an empty table becomes an object when it is filled", function()
    local player = {}
    world.objects.player = player
    world:update(DT)
    assert.equal(0, world.stats.objects)
    player.x, player.y, player.width, player.height = 0, 0, 16, 16
    world:update(DT)
    assert.equal(1, world.stats.objects)
    assert.is_true(player.vy > 0)
  end)

  -- Of cells that double, the largest would be 1e16 px wide: without an end to that a step, and a
  -- ray, looked through more cells than anybody has time for.
  for _, width in ipairs({ 1e16, 1e100 }) do
    it(("may be %g px wide, among many"):format(width), function()
      local floor = { x = -width / 2, y = 100, width = width, height = 10, static = true }
      world:add("floors", floor)
      for i = 1, 300 do
        world:add("boxes", { x = 15 * i, y = 60 - 20 * (i % 3), width = 10, height = 10 })
      end
      run(world, 40)
      for _, object in ipairs(world.objects.boxes) do
        assert.are.equal(90, object.y)
        assert.are.equal(floor, object.touching.bottom)
      end
      local object, _, y = world:raycast(1e6, 0, 1e6, 300)
      assert.are.equal(floor, object)
      assert.are.equal(100, y)
      assert.are.equal(3, select(2, world:queryRect(12, 85, 30, 20)))
    end)
  end
end)

describe("touching", function()
  local NONE = { top = false, bottom = false, left = false, right = false }

  it("is there at once with add, at the first update with plain Lua, also of dt 0", function()
    local world = physics.newWorld()
    local first, other = world:add("boxes", newBox(0, 0)), newBox(40, 0)
    local touching = first.touching
    assert.same(NONE, touching)
    table.insert(world.objects.boxes, other)
    world:update(0)
    assert.same(NONE, other.touching)
    world:update(DT)
    assert.equal(touching, first.touching)
  end)

  row("belongs to dynamic objects only", { FLOOR, box({ kinematic = true }) }, {
    { steps = 2 },
    "floor.raw.touching == nil; box.raw.touching == nil",
  })

  local FRESH = { rest = false, FLOOR, box() }
  row("comes back when the game replaces it, or the object changes its kind", FRESH, {
    { steps = 3 },
    { "first = box.raw.touching", "box.raw.touching = {}", { steps = 1 } },
    { "box.raw.touching == first", "first.bottom == floor.raw" },
    { "box.kinematic = true", { steps = 1 }, "first.bottom == false" },
    { "box.kinematic = nil", { steps = 2 }, "box.touching.bottom == floor" },
    { "box.active = false", { steps = 1 }, "box.touching.bottom == false" },
    { "box.active = nil", { steps = 2 }, "box.touching.bottom == floor" },
  })

  local PAIR = { FLOOR, box(), box({ name = "rider", y = 68 }) }
  row("is there when it was of another kind for no step", PAIR, {
    { steps = 3 },
    { "rider.kinematic = true", "world:update(0)", "rider.kinematic = nil", { steps = 1 } },
    "rider.touching.bottom == box",
  })

  local TWO = { solid("narrow", 0, 100, 6, 8), solid("wide", 6, 100, 40, 8), box() }
  row("is the neighbour with the widest common edge, the first of equals: {which}", TWO, {
    { steps = 1 },
    { "box.x = x", { steps = 2 }, "box.touching.bottom.name == which" },
  }, { "x, which", { 0, "wide" }, { -2, "wide" }, { -4, "narrow" } }) -- 6 px each
end)

describe("add, remove and refresh", function()
  it("add puts an object at the end of its group and returns it", function()
    local world, one = physics.newWorld(), newBox(0, 0)
    assert.equal(one, world:add("boxes", one))
    world.objects.boxes.named = newBox(20, 0)
    local last = world:add("boxes", newBox(40, 0))
    assert.same({ one, last }, { world.objects.boxes[1], world.objects.boxes[2] })
    world:add(5, newBox(60, 0))
    world:update(DT)
    assert.equal(4, world.stats.objects)
  end)

  it("remove takes it out once, from wherever it stands", function()
    local world, boxes = physics.newWorld(), {}
    for n = 1, 3 do
      boxes[n] = world:add("boxes", newBox(20 * n, 0))
    end
    local objects, inserted = world.objects, newBox(20, 0)
    objects.boxes.named, objects.player = newBox(100, 0), newBox(140, 0)
    world:update(DT)
    assert.is_true(world:remove(boxes[2]))
    assert.is_false(world:remove(boxes[2]))
    assert.equal(boxes[3], objects.boxes[2])
    assert.is_true(world:remove(objects.boxes.named) and world:remove(objects.player))
    assert.same({}, { objects.boxes.named, objects.player })
    world:update(DT)
    assert.equal(2, world.stats.objects)
    assert.is_false(world:remove(newBox(0, 0)))
    table.insert(objects.boxes, inserted) -- not seen yet
    objects.player = newBox(40, 0)
    assert.is_true(world:remove(inserted) and world:remove(objects.player))
    assert.is_nil(objects.player)
    world:update(DT)
    assert.equal(2, world.stats.objects)
  end)

  row("refresh makes a static object dynamic and back", { FLOOR, box({ y = 0, static = true }) }, {
    { steps = 10 },
    { "box.static = nil", { steps = 10 }, "box.y == 0" },
    { "world:refresh(box.raw)", 1, "box.y == 84", "box.touching.bottom == floor" },
    { "box.static, box.vx = true, 100", "world:refresh(box.raw)", "box.touching.bottom == false" },
    { "upper = world:add('boxes', newBox(0, 40))", 1, "upper.y == 68", "box.x == 0" },
  })

  row("add of what was just removed touches what it touched, with rest = {rest}", function(v)
    return { rest = v.rest, FLOOR, box() }
  end, {
    1,
    "world.stats.resting == (rest and 1 or 0)",
    { "world:remove(box.raw)", "world:add('boxes', box.raw)", "box.touching.bottom == floor" },
    "world:touching(box.raw, floor.raw) == 'bottom'",
    1,
    "box.touching.bottom == floor",
    "world:remove(box.raw)", -- where it left in between it is another one
    { steps = 1 },
    { "box.y = 40", "world:add('boxes', box.raw)", "box.touching.bottom == false" },
    "world:touching(box.raw, floor.raw) == nil",
    1,
    "box.touching.bottom == floor",
  }, { "rest", { true }, { false } })

  row("active: a {kind} that is off for {steps} steps is where it was put", function(v)
    local lift = scene.maker("lifts", { kinematic = true, sensor = v.kind == "sensor" or nil })
    return {
      gravity = 0,
      lift("lift", 0, 0, 20, 20),
      box({ x = 200, y = 0, width = 20, height = 20 }),
    }
  end, {
    { "listen lift", { steps = 1 } },
    { "lift.active, lift.x = false, 400", { time = "steps / 60" } },
    { "lift.active = true", { steps = 10 }, "box at 200, 0", "lift at 400, 0" },
    "lift heard 0, 0",
    "lift.x = 300", -- moves again
    { steps = 1 },
    { "lift.x = 190", { steps = 1 }, "heard.lift.begins == 1" },
  }, { "kind, steps", { "lift", 10 }, { "sensor", 10 }, { "lift", 1 } })

  -- A long update has several steps, over which the way of a lift is spread.
  row("refresh puts a lift somewhere else for good, also in the middle of an update", {
    gravity = 0,
    scene.maker("lifts", { kinematic = true })("lift", 0, 0, 9, 9),
    solid("wall", 310.5, 0, 9, 9),
    box({ x = 300, y = 0, width = 10, height = 9, vx = 100 }),
  }, {
    "function box.raw.onBegin() lift.x = 500 world:refresh(lift.raw) end",
    { "world:update(0.001)", "lift.x = 30", "world:update(0.1)", "lift.x == 500" },
    { "world:update(0.1)", "lift.x == 500" },
  })

  row("refresh reads all of a static object anew, and wakes what rests there", STANDS, {
    0.5,
    { "floor.y = 150", 0.5, "box.y == 84" },
    { "world:refresh(floor.raw)", 1, "box.y == 134" },
    { "floor.active = false", "world:refresh(floor.raw)", 0.5, "box.y > 140" },
  })
end)

describe("fields and settings at run time:", function()
  row("vx and vy become numbers", STANDS, {
    { steps = 2 },
    "box.raw.vx == 0; box.raw.vy == 0",
    { "box.raw.vx, box.raw.vy = nil, nil", { steps = 1 }, "box.raw.vx == 0", "box.raw.vy == 0" },
  })

  -- Fields of a box that stands at y = 84 (`nil` takes away), for how many steps, where it is then.
  row("{what}", STANDS, {
    { steps = 5 },
    "{first}",
    { time = "steps / 60" },
    "box.y ~ y, 1e-9",
    "{second}",
    { time = "steps2 / 60" },
    "box.y ~ y2, 1e-9; box.touching.bottom == floor",
  }, {
    "what, first, steps, y, second, steps2, y2",
    { "active, off and on", "box.active, box.y = false, 20", 30, 20, "box.active = nil", 60, 84 },
    { "height and y", "box.height, box.y = 24, 76", 5, 76, "box.height = 8", 30, 92 },
    { "width, x and y", "box.x, box.y, box.width = 300, -50, 32", 1, -50 + 1 / 9, "", 60, 84 },
    { "height, into the floor: it leaves upwards", "", 5, 84, "box.height = 20", 5, 80 },
    { "kinematic", "box.kinematic, box.vy = true, -60", 60, 24, "box.kinematic = nil", 60, 84 },
    { "sensor", "box.sensor = true", 30, 184, "box.sensor, box.y, box.vy = false, 40, 0", 60, 84 },
    { "gravity", "box.raw.gravity = -800", 30, -16, "box.gravity, box.drag = nil, 0", 90, 84 },
    { "gravity = 0", "box.y, box.raw.gravity = 0, 0", 30, 0, "box.raw.gravity = 800", 60, 84 },
    { "masks", "world.masks = down", 30, 184, "box.y, box.vy, world.masks = 0, 0, {}", 60, 84 },
    { "masks, the other way", "world.masks = up", 30, 184, "box.y, world.masks = 0, nil", 60, 84 },
    {
      "mask, changed in place",
      "box.raw.mask = both; world:update(DT); both.tiles = false",
      30,
      184,
      "box.y, box.vy, both.tiles = 20, 0, nil",
      60,
      84,
    },
  })

  -- Far away it has not been tested yet whether the two can meet.
  row("mask of a static object is read once, {x} px away", function(v)
    v.mask = { boxes = true }
    local wall = solid("wall", v.x, 0, 10, 10, { mask = v.mask })
    return { gravity = 0, wall, box({ y = 0, width = 10, height = 10, vx = 600 }) }
  end, {
    { steps = 1 },
    { "mask.boxes = false", "world:explain(box.raw, wall.raw):find('mask', 1, true) == nil" },
    1,
    "box.x == x - 10",
    { "world:refresh(wall.raw)", "box.vx = 600", { steps = 1 }, "box.x == x" },
  }, { "x", { 26 }, { 300 } })

  it("update by 0 reads the tables and moves nothing", function()
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

  it("update by less than 1e-10 s counts as none, so no object becomes infinitely fast", function()
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
      end
      assert.are.near(0, rider.vx, 1e-3)
      world:update(DT)
      assert.are.near(10, rider.x, 1e-3)
      assert.are.same({ 10, 6, -10, 0 }, { lift.x, lift.y, rider.y, rider.vy })
      assert.are.near(0, rider.vx, 1e-3)
    end
  end)

  it("update, save and hash refuse keys that are no finite numbers", function()
    for _, key in ipairs({ 1 / 0, -1 / 0 }) do
      local world = physics.newWorld()
      local object = newBox(0, 0)
      for path, objects in pairs({
        ["objects.b"] = { b = { [key] = object } },
        objects = { [key] = { object } },
      }) do
        world.objects = objects
        for _, call in ipairs({ "update", "save", "hash" }) do
          local ok, message = pcall(world[call], world, call == "update" and DT or nil)
          local text = " has a key that is not a finite number, got "
            .. (key > 0 and "inf" or "-inf")
          assert.is_truthy(not ok and message:find(path .. text, 1, true), message)
        end
      end
    end
  end)

  for _, values in ipairs({
    -- maxStep, dt; where a box is after each step at 1000 px/s
    { 0.1, 0.15, { 75, 150 } },
    { 0.1, 0.25, { 250 / 3, 500 / 3, 250 } },
    { 1 / 30, 0.1, { 100 / 3, 200 / 3, 100 } },
    { 1 / 30, 0.04, { 20, 40 } },
    { 1 / 30, 1 / 30, { 100 / 3 } },
    { 0.1, 60, { 250 / 3, 500 / 3, 250 } }, -- 0.25 s at most
  }) do
    it(("maxStep: %.3g s are equal steps of at most %.3g"):format(values[2], values[1]), function()
      local split, places = physics.newWorld({ gravity = 0, maxStep = values[1] }), {}
      local fast = split:add("boxes", newBox(0, 0, { vx = 1000 }))
      split:add("zones", { x = -50, y = 0, width = 500, height = 8, static = true, sensor = true })
      split.onBegin = function()
        places[#places + 1] = fast.x
      end
      split.onStay = split.onBegin
      split:update(values[2])
      assert.equal(#values[3], #places)
      for n, x in ipairs(values[3]) do
        assert.near(x, places[n], 1e-9)
      end
    end)
  end
end)

describe("stats", function()
  --   +--+
  --   +--+
  --          fall 1.5, 3 and 4.5 px: for 3.7, 5.2 and 6.4 steps
  --   +--+
  --   +--+
  --   +--+       +----+ ->
  --  ------
  it("count a pile that falls, lands and comes to rest", function()
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
end)

describe("newWorld: two worlds", function()
  it("know nothing of each other", function()
    local one, other = physics.newWorld({ gravity = 800 }), physics.newWorld({ gravity = 0 })
    one:add("tiles", newFloor())
    local first, second = one:add("boxes", newBox(0, 0)), other:add("boxes", newBox(0, 0))
    run(one)
    run(other)
    assert.same({ 84, 0, 2, 1 }, { first.y, second.y, one.stats.objects, other.stats.objects })
  end)

  it("may be stepped from each other's callbacks", function()
    local function make()
      local world = physics.newWorld({ gravity = 800, rest = false }) -- it is asked at every step
      world:add("tiles", newFloor())
      return world, world:add("boxes", newBox(0, 0, { restitution = 0.5 }))
    end
    local outer, outerBox = make()
    local inner, innerBox = make()
    local function step()
      inner:update(DT)
    end
    local calls = 0
    function inner.canCollide()
      calls = calls + 1
      return true
    end
    outerBox.onBegin = step
    run(outer, 120)
    assert.is_true(innerBox.y > 0)
    outer.canCollide = step
    run(outer, 200)
    assert.equal(84, innerBox.y)
    assert.is_true(calls > 0)
  end)
end)

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
      if type(method) == "function" then
        assert.is_function(rawget(physics, name), name)
      end
    end
  end)
end)

describe("require: the library in a folder of the game", function()
  -- The interpreter that runs this spec, with its arguments.
  local function interpreter()
    local args, first = rawget(_G, "arg"), 0
    while args[first - 1] do
      first = first - 1
    end
    return args[first]
  end

  local function output(command)
    local pipe = assert(io.popen(command .. " 2>&1"))
    local text = pipe:read("*a")
    pipe:close()
    return text
  end

  local function write(path, text)
    local file = assert(io.open(path, "wb"))
    file:write(text)
    file:close()
  end

  it("works as lib.physics, blames the game, sets no global, needs nothing else #posix", function()
    local folder = os.tmpname()
    os.remove(folder)
    output(("mkdir -p '%s/lib' && cp -r physics.lua physics '%s/lib'"):format(folder, folder))
    write(
      folder .. "/main.lua",
      [[
        local before = {}
        for name in pairs(_G) do before[name] = true end
        local physics = require "lib.physics"
        physics.load { gravity = 800 }
        physics.add("tiles", { x = 0, y = 100, width = 100, height = 10, static = true })
        local box = physics.add("boxes", { x = 0, y = 0, width = 16, height = 16 })
        for _ = 1, 60 do physics.update(1 / 60) end
        assert(box.y == 84 and box.touching.bottom)
        physics.globals()
        objects, physics_load, physics_update, checkCollision, inside, bump = nil
        for name in pairs(_G) do assert(before[name], name) end
        for name in pairs(package.loaded) do
          assert(name ~= "physics" and not name:find("^physics%."), name)
        end
        local ok, message = pcall(function() physics.update(-1) end)
        assert(message:find("^%.?/?main.lua:%d+: physics: world:update"), message)
        print("it works")
      ]]
    )
    local printed = output(("cd '%s' && '%s' main.lua"):format(folder, interpreter()))
    output(("rm -r '%s'"):format(folder))
    assert.equal("it works\n", printed)
  end)
end)
