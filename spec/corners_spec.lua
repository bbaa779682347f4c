--- What seldom happens, each in one small scene: lines that no other spec runs.

local box = require("spec.support.box")
local physics = require("physics")

local DT = 1 / 60

local function newWorld(settings)
  return physics.newWorld(settings or { gravity = 600 })
end

local function floor(y)
  return { x = 0, y = y, width = 400, height = 20, static = true }
end

local function refuses(text, f, ...)
  local ok, message = pcall(f, ...)
  assert.is_false(ok)
  assert.is_truthy(message:find(text, 1, true), message)
end

describe("a question", function()
  it("does not find what was replaced by assignment, but the new one", function()
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

  it("finds every object where it is after an update that has failed half way", function()
    local world = newWorld({ gravity = 0 })
    local fast = world:add("a", box(0, 0, { vx = 6000 }))
    for n = 1, 200 do
      world:add("far", box(40 * n, 900))
    end
    local fields = { x = 0, y = 300, width = 16, height = 16, vx = 1, vy = 0 }
    local isFull = false
    world:add(
      "z",
      setmetatable({}, {
        __index = fields,
        __newindex = function(_, key, value)
          if isFull and key == "x" then
            error("full")
          end
          fields[key] = value
        end,
      })
    )
    world:add("walls", box(0, 100, { static = true }))
    world:add("b", box(0, 80, { vy = 600 }))
    world:update(DT)
    world.objects.b[1].y, world.objects.b[1].vy = 80, 600
    isFull = true
    world.canCollide = function()
      return world:queryPoint(-50, -50) ~= nil
    end
    refuses("full", world.update, world, DT)
    assert.are.equal(200, fast.x)
    assert.are.equal(fast, world:queryPoint(208, 8)[1])
    assert.are.equal(fast, (world:raycast(208, -50, 208, 50)))
  end)

  it("names the object with a place or size that has turned bad", function()
    for _, row in ipairs({
      { "width", 0, "objects.boxes[1].width must be a number > 0, got 0" },
      { "height", -1, "objects.boxes[1].height must be a number > 0, got -1" },
      { "x", 0 / 0, "objects.boxes[1].x must be a number, got nan" },
    }) do
      local world = newWorld()
      local object = world:add("boxes", box(0, 0))
      world:update(DT)
      object[row[1]] = row[2]
      refuses(row[3], world.queryPoint, world, 8, 8)
    end
  end)

  it("names a setting or a table that has turned bad", function()
    local world = newWorld()
    world:add("boxes", box(0, 0))
    world.sideBySide = 1
    refuses("sideBySide must be true or false, got 1", world.queryPoint, world, 0, 0)
    world.sideBySide, world.objects = nil, 7
    refuses("objects must be a table of groups, got 7", world.setBounds, world, 0, 0, 9, 9)
    world.objects = { bounds = box(0, 0) }
    local text = "world:setBounds(x, y, w, h): objects.bounds is not a group, got an object"
    refuses(text, world.setBounds, world, 0, 0, 9, 9)
  end)

  it("is answered by explain for gaps on y, corners and canCollide of the world", function()
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

describe("an update", function()
  it("of a tiny dt is one step, too", function()
    local world = newWorld({ gravity = 0, maxStep = 0.25 })
    local object = world:add("boxes", box(0, 0, { vx = 1000 }))
    world:update(1e-5)
    assert.are.near(0.01, object.x, 1e-12)
    world:update(1e-10)
    assert.are.near(0.01 + 1e-7, object.x, 1e-12)
  end)

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

  it("and a state refuse keys that are no finite numbers", function()
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

describe("a contact", function()
  for _, row in ipairs({
    { "gravity", 600, "bottom", "top", 0, 20 },
    { "gravity", -600, "top", "bottom", 0, -20 },
    { "gravityX", 600, "right", "left", 20, 0 },
    { "gravityX", -600, "left", "right", -20, 0 },
  }) do
    it(("has its side where %s is %d"):format(row[1], row[2]), function()
      local world = newWorld({ gravity = 0 })
      world[row[1]] = row[2]
      local object = world:add("boxes", box(0, 0))
      local ground = world:add("walls", box(row[5], row[6], { static = true }))
      local told = {}
      function object.onBegin(_, other, side)
        told[#told + 1] = other == ground and side
      end
      function ground.onBegin(_, other, side)
        told[#told + 1] = other == object and side
      end
      for _ = 1, 30 do
        world:update(DT)
      end
      assert.are.same({ row[3], row[4] }, told)
      assert.are.equal(ground, object.touching[row[3]])
      assert.are.equal(row[3], world:touching(object, ground))
    end)
  end

  it("begins in the step that presses, not in the one that ends flush", function()
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

describe("a state", function()
  -- Saves in the middle, goes on, goes back and goes on again; and the same in a world of its own.
  local function checkReplay(world, change)
    local state, hash = world:save(), world:hash()
    local function goOn(it)
      for _ = 1, 20 do
        it:update(DT)
      end
      return it:hash()
    end
    local expected = goOn(world)
    world:restore(state)
    assert.are.equal(hash, world:hash())
    assert.are.equal(expected, goOn(world))
    local twin = newWorld()
    twin:restore(state)
    assert.are.equal(hash, twin:hash())
    assert.are.equal(expected, goOn(twin))
    if change then
      world:restore(state)
      change(world)
      world:update(DT)
      world:restore(state)
      assert.are.equal(hash, world:hash())
      assert.are.equal(expected, goOn(world))
    end
    return state
  end

  it("knows a mask that has changed since it was read", function()
    local world = newWorld()
    world:add("floor", floor(100))
    local mask = { floor = false }
    local object = world:add("boxes", box(0, 60, { mask = mask }))
    world:update(DT)
    mask.floor = nil -- the next update will read this
    mask.boxes = false
    checkReplay(world, function()
      object.mask, mask.boxes, mask.other = nil, true, true
    end)
    object.mask.floor = 1
    refuses("objects.boxes[1].mask", world.save, world)
  end)

  it("knows a mask that was read and is gone", function()
    local world = newWorld()
    world:add("floor", floor(100))
    local object = world:add("boxes", box(0, 60, { mask = { floor = false } }))
    world:update(DT)
    object.mask = nil
    checkReplay(world, function()
      object.mask = { boxes = false }
    end)
  end)

  it("knows riders that lost their lift, and objects that the game has moved", function()
    local world = newWorld()
    local lift = { x = 0, y = 100, width = 100, height = 16, kinematic = true, vx = 30, vy = -20 }
    world:add("lifts", lift)
    local rider = world:add("boxes", box(10, 84))
    world:add("boxes", box(60, 60))
    for _ = 1, 40 do
      world:update(DT)
    end
    assert.are.equal(lift, rider.touching.bottom)
    world:remove(lift)
    checkReplay(world, function()
      rider.x = rider.x + 3
    end)
  end)

  it("tells static objects that changed unseen from those that did not", function()
    for _, row in ipairs({ { "y", 90 }, { "oneWay", "top" }, { "kinematic", true } }) do
      local world = newWorld()
      local ground = world:add("floor", floor(100))
      world:add("boxes", box(0, 60))
      world:update(DT)
      checkReplay(world, function()
        if row[1] == "kinematic" then
          ground.static = nil
        end
        ground[row[1]] = row[2]
        world:refresh(ground)
      end)
    end
  end)

  it("brings back the list `order` as the same table, or as one that says the same", function()
    local world = newWorld()
    world:add("b", box(0, 0))
    local order = { "b", "a" }
    world.order = order
    world:update(DT)
    local state = world:save()
    world:restore(state)
    assert.are.equal(order, world.order)
    order[1], order[2] = "a", "b"
    world:restore(state)
    assert.are.same({ "b", "a" }, world.order)
    assert.are.same({ "a", "b" }, order)
    world.order, world.objects = nil, nil
    world:restore(state)
    assert.are.same({ "b", "a" }, world.order)
    assert.are.equal(0, world.objects.b[1].x)
  end)

  it("keeps the table `touching` of an object that comes back", function()
    local world = newWorld()
    world:add("floor", floor(100))
    local object = world:add("boxes", box(0, 84))
    world:update(DT)
    local state, touching = world:save(), object.touching
    world:remove(object)
    world:update(DT)
    world:restore(state)
    assert.are.equal(touching, object.touching)
    assert.are.equal(world.objects.floor[1], touching.bottom)
  end)

  it("keeps it of one that was something else meanwhile", function()
    for _, kind in ipairs({ "static", "kinematic" }) do
      local world = newWorld()
      local ground = world:add("floor", floor(100))
      local object = world:add("boxes", box(0, 84))
      world:update(DT)
      local state, touching = world:save(), object.touching
      object[kind] = true
      world:refresh(object)
      world:update(DT)
      assert.is_false(touching.bottom)
      world:restore(state)
      assert.are.equal(touching, object.touching)
      assert.are.equal(ground, touching.bottom)
      object[kind] = true
      world:refresh(object)
      world:update(DT)
      object[kind] = nil
      world:refresh(object)
      for _ = 1, 3 do
        world:update(DT)
      end
      assert.are.equal(touching, object.touching)
      assert.are.equal(ground, touching.bottom)
    end
  end)

  it("keeps no object alive that has left, whatever the game has put into `touching`", function()
    local world = newWorld()
    local alive = setmetatable({}, { __mode = "k" })
    for n = 1, 20 do
      local object = world:add("boxes", box(40 * n, 0))
      object.touching.owner, alive[object] = object, true
      world:update(DT)
      world:remove(object)
    end
    world:update(DT)
    world:update(DT)
    collectgarbage()
    collectgarbage()
    local count = 0
    for _ in pairs(alive) do
      count = count + 1
    end
    assert.are.equal(0, count)
  end)

  it("keeps the tables `touching` of the last few thousand that have left, no more", function()
    local world, objects = newWorld(), {}
    for n = 1, 10000 do
      objects[n] = world:add("boxes", box(20 * n, 0, { active = false }))
    end
    world:update(0)
    local first, last = objects[1].touching, objects[10000].touching
    world.objects.boxes = nil
    world:update(0)
    world.objects.boxes = { objects[1], objects[10000] }
    world:update(0)
    assert.are.equal(last, objects[10000].touching)
    assert.are_not.equal(first, objects[1].touching)
  end)

  it("does not take the table `touching` of another world", function()
    local one, other = newWorld(), newWorld()
    local ground = one:add("floor", floor(100))
    local object = one:add("boxes", box(0, 84))
    one:update(DT)
    local state, touching = one:save(), object.touching
    one:remove(object)
    one:update(DT)
    other:add("boxes", object)
    other:update(DT)
    assert.are_not.equal(touching, object.touching)
    other:remove(object)
    one:restore(state)
    other:update(DT) -- here it has left
    for _ = 1, 3 do
      object.vx = 10
      one:update(DT)
      assert.are.equal(touching, object.touching)
      assert.are.equal(ground, object.touching.bottom)
    end
  end)

  it("gives two a table `touching` each, whatever the game has put there", function()
    local world = newWorld()
    local ground = world:add("floor", floor(100))
    local object, other = world:add("boxes", box(0, 84)), world:add("boxes", box(100, 0))
    world:update(DT)
    local shared = {}
    object.touching, other.touching = shared, shared
    world:restore(world:save())
    world:update(DT)
    assert.are_not.equal(object.touching, other.touching)
    assert.are.equal(ground, object.touching.bottom)
    assert.is_false(other.touching.bottom)
  end)

  it("knows a lift that was moved and switched off at once where it is", function()
    local function lets()
      return true
    end
    local world, copy = newWorld(), newWorld()
    local lift = world:add("lifts", box(100, 84, { kinematic = true, canCollide = lets }))
    world:update(DT)
    lift.x, lift.active = 90, false
    world:update(DT)
    copy:restore(world:save())
    assert.are.equal(world:hash(), copy:hash())
    copy.objects.lifts[1].canCollide = lets
    for _ = 1, 3 do
      world:update(DT)
      copy:update(DT)
      assert.are.equal(world:hash(), copy:hash())
    end
    lift.active, copy.objects.lifts[1].active = nil, nil
    for _ = 1, 3 do
      world:update(DT)
      copy:update(DT)
      assert.are.equal(90, lift.x)
      assert.are.equal(world:hash(), copy:hash())
    end
  end)

  it("refuses an object that stands twice, as update does", function()
    local world = newWorld()
    local object = world:add("b", box(0, 0))
    world:update(DT)
    world.objects.c = { object }
    for _, call in ipairs({ "save", "hash", "update" }) do
      refuses("objects.c[1]", world[call], world, call == "update" and DT or nil)
    end
  end)
end)
