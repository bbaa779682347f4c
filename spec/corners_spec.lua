--- What seldom happens, each in one small scene: lines that no other spec runs.

local box = require("spec.support.box")
local physics = require("physics")

local DT = 1 / 60

local function newWorld(settings)
  return physics.newWorld(settings or { gravity = 600 })
end

local function refuses(text, f, ...)
  local ok, message = pcall(f, ...)
  assert.is_false(ok)
  assert.is_truthy(message:find(text, 1, true), message)
end

describe("queryPoint and raycast", function()
  it("do not find what was replaced by assignment, but the new one", function()
    for _, fields in ipairs({ {}, { static = true } }) do
      local world = newWorld({ gravity = 0 })
      local old, new = box(0, 0, fields), box(100, 0, fields)
      for _, ask in ipairs({
        function()
          return world:queryPoint(8, 8)[1], world:queryPoint(108, 8)[1]
        end,
        function()
          return world:raycast(-9, 8, 40, 8), (world:raycast(90, 8, 140, 8))
        end,
      }) do
        world.objects.boxes = { old }
        world:update(DT)
        local first, second = ask()
        assert.are.equal(old, first)
        assert.is_nil(second)
        world.objects.boxes[1] = new
        if new.static then
          world:refresh(new)
        end
        first, second = ask()
        assert.is_nil(first)
        assert.are.equal(new, second)
      end
    end
  end)

  it("name what has turned bad: an object, a setting or a table", function()
    local world = newWorld()
    local object = world:add("boxes", box(0, 0))
    world:update(DT)
    object.width = 0
    local text = "objects.boxes[1].width must be a number > 0, got 0"
    refuses(text, world.queryPoint, world, 8, 8)
    object.width, world.sideBySide = 16, 1
    refuses("sideBySide must be true or false, got 1", world.queryPoint, world, 0, 0)
    world.sideBySide, world.objects = nil, 7
    refuses("objects must be a table of groups, got 7", world.setBounds, world, 0, 0, 9, 9)
    world.objects = { bounds = box(0, 0) }
    text = "world:setBounds(x, y, w, h): objects.bounds is not a group, got an object"
    refuses(text, world.setBounds, world, 0, 0, 9, 9)
  end)

  it("explain tells gaps on y, corners and canCollide of the world", function()
    local world = newWorld({ gravity = 0 })
    local a, b = world:add("a", box(0, 0)), world:add("b", box(4, 26))
    assert.is_truthy(world:explain(a, b):find("they are 10 px apart on y", 1, true))
    b.x, b.y = 16, 16
    assert.is_truthy(world:explain(a, b):find("they are flush at a corner only", 1, true))
    b.x = 15
    assert.is_truthy(world:explain(a, b):find("they are flush at the bottom of", 1, true))
    assert.is_nil(world:explain(a, b):find("canCollide", 1, true))
    world.canCollide = function() end
    assert.is_truthy(world:explain(a, b):find("canCollide of the world may refuse", 1, true))
  end)
end)

describe("update", function()
  it("of less than 1e-10 s counts as none, so no object becomes infinitely fast", function()
    for _, dt in ipairs({ 5e-324, 1e-310, 1e-100, 9.9e-11, 1e-10 }) do
      local world = newWorld()
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
      assert.are.same({ 10, -10 + 16, -10 }, { lift.x, lift.y, rider.y })
      assert.are.near(0, rider.vx, 1e-3)
      assert.are.equal(0, rider.vy)
    end
  end)

  it(
    "of less than 1e-10 s saves up no step either, and gives what is new its `touching`",
    function()
      local world = newWorld({ gravity = 0, timestep = 0.25 })
      world.objects.boxes = { box(0, 0, { vx = 4 }) }
      world:update(1e-11)
      assert.are.equal("table", type(world.objects.boxes[1].touching))
      for _ = 1, 2 do
        world:update(0.125)
      end
      assert.are.equal(1, world.objects.boxes[1].x)
    end
  )

  it("and save refuse keys that are no finite numbers", function()
    for _, key in ipairs({ 1 / 0, -1 / 0 }) do
      local world = newWorld()
      local object = world:add("b", box(0, 0))
      world:update(DT)
      local place, shown = world.objects.b, key > 0 and "inf" or "-inf"
      for _, path in ipairs({ "objects.b", "objects" }) do
        place[key] = path == "objects" and { object } or object
        place[1] = nil
        local text = path .. " has a key that is not a finite number, got " .. shown
        refuses(text, world.update, world, DT)
        refuses(text, world.save, world)
        refuses(text, world.hash, world)
        place[key], place = nil, world.objects
        place.b = nil
      end
    end
  end)
end)

describe("onBegin", function()
  it("is called in the step that presses, not in the one that ends flush", function()
    for _, push in ipairs({ "both", "first" }) do
      local world = newWorld({ gravity = 0, push = push })
      local begun = 0
      world.onBegin = function()
        begun = begun + 1
      end
      world:add("walls", { x = 17, y = 0, width = 16, height = 16, static = true })
      local object = world:add("boxes", box(0, 0, { vx = 64 }))
      world:add("boxes", box(17, 100))
      local pusher = world:add("boxes", box(0, 100, { vx = 64 }))
      world:update(1 / 64)
      assert.are.same({ 1, 64, 1, 64, 0 }, { object.x, object.vx, pusher.x, pusher.vx, begun })
      world:update(1 / 64)
      assert.are.same({ 1, 0, 32, 2 }, { object.x, object.vx, pusher.vx, begun })
    end
  end)
end)
