--- Objects and groups: which are in `world.objects`, and how they come and go.

local garbage = require("spec.support.garbage")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local newBox, newFloor, run = small.box, small.floor, small.run

local DT = 1 / 60

local box = scene.thing("boxes", { name = "box", x = 0, y = 84, width = 16, height = 16 })
local solid = scene.maker("tiles", { static = true })
local FLOOR = solid("floor", -200, 100, 800, 16)
local STANDS = { FLOOR, box() }

local row = play.once({ newBox = newBox })

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
    assert.same({ 9, 8 }, { world.stats.objects, #list })
    for _, object in ipairs(list) do
      assert.equal(84, object.y)
      assert.equal(world.objects.tiles[1], object.touching.bottom)
    end
  end)

  -- What a sensor that holds all of them is told of, one after the other.
  local function orderOf(settings)
    local text = ""
    small.set(world, settings)
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
    world.order = { "c" } -- (`orderOf` adds an object)
    world:update(0)
    assert.equal("c", world:queryRect(-1e3, -1e3, 2e3, 2e3)[1].name)
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
    assert.same({ true, true }, { world:remove(second), rawequal(first, world.objects.boxes[1]) })
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

  -- There its width and height are less than a rounding of its place.
  it("may be as far away as 1e18 px on both axes, and comes back", function()
    local object = world:add("boxes", { x = 1e18, y = 1e18, width = 10, height = 10 })
    run(world, 2)
    object.x, object.y = 0, 0
    run(world, 1)
    assert.are.equal(object, world:queryRect(0, 0, 10, 10)[1])
  end)

  -- Of cells that double, the largest would be 1e16 px wide: without an end to that a step, and a
  -- ray, looked through more cells than anybody has time for.
  small.rows("may be {1} px wide, among many", { 1e16, 1e100 }, function(width)
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
    assert.same({ 100, 3 }, { y, select(2, world:queryRect(12, 85, 30, 20)) })
  end)
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
    assert.same({ true, false }, { world:remove(boxes[2]), world:remove(boxes[2]) })
    assert.equal(boxes[3], objects.boxes[2])
    assert.is_true(world:remove(objects.boxes.named) and world:remove(objects.player))
    assert.same({}, { objects.boxes.named, objects.player })
    world:update(DT)
    assert.same({ 2, false }, { world.stats.objects, world:remove(newBox(0, 0)) })
    table.insert(objects.boxes, inserted) -- not seen yet
    objects.player = newBox(40, 0)
    assert.is_true(world:remove(inserted) and world:remove(objects.player))
    assert.is_nil(objects.player)
    world:update(DT)
    assert.equal(2, world.stats.objects)
  end)

  row("refresh and static: made dynamic, and back", { FLOOR, box({ y = 0, static = true }) }, {
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

-- Of each tile 2.5 kB stayed when it was gone.
it("remove: what is gone leaves its columns to what comes later", function()
  local world, tiles = physics.newWorld(), {}
  local function fillAndEmpty()
    for i = 1, 500 do
      tiles[i] = { x = 16 * i, y = 0, width = 16, height = 16, static = true }
      world:add("tiles", tiles[i])
    end
    world:update(1 / 60)
    for i = 1, 500 do
      world:remove(tiles[i])
      tiles[i] = nil
    end
    run(world, 2)
  end
  local kept = garbage.kept(fillAndEmpty, 2, 6) / (6 * 500)
  assert.is_true(kept <= 10, ("%.0f bytes of each are left"):format(kept))
end)
