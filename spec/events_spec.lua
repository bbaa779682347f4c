--- Events: what the game is told about which objects, in which order, and what callbacks may do.

local newBox = require("spec.support.box")
local physics = require("physics")

local DT = 1 / 60

local function newWall(x, y, width, height, changes)
  local wall = newBox(x, y, changes)
  wall.width, wall.height, wall.static = width, height, true
  return wall
end

local function play(world, steps)
  for _ = 1, steps or 60 do
    world:update(DT)
  end
end

--- Counts the events of an object.
local function listen(object)
  local log = { begins = 0, stays = 0, ends = 0 }
  function object.onBegin(_, other, side, speed)
    log.begins, log.other, log.side, log.speed = log.begins + 1, other, side, speed
  end
  function object.onStay(_, other, side)
    log.stays, log.other, log.side = log.stays + 1, other, side
  end
  function object.onEnd(_, other, side)
    log.ends, log.other, log.side = log.ends + 1, other, side
  end
  return log
end

local function checkLog(log, begins, ends)
  assert.equal(begins, log.begins, "begins")
  assert.equal(ends, log.ends, "ends")
end

describe("onBegin and onEnd of an object that is inside something solid", function()
  it("begins once, wholly inside, and ends when it is put elsewhere", function()
    local world = physics.newWorld({ gravity = 800 })
    world:setBounds(0, 0, 16, 16)
    local tile = world:add("tiles", newWall(0, 0, 16, 16))
    local crate = world:add("crates", newBox(0, 0))
    local log = listen(tile)
    play(world, 30)
    checkLog(log, 1, 0)
    assert.equal(crate, log.other)
    world:setBounds()
    crate.x = 100
    play(world, 30)
    checkLog(log, 1, 1)
  end)
end)

describe("onBegin, onStay, onEnd", function()
  local world

  before_each(function()
    world = physics.newWorld({ gravity = 0 })
  end)

  --    side of the box, where it comes from, its speed
  for _, row in ipairs({
    { "right", "left", 0, 100, 120, 0 },
    { "left", "right", 200, 100, -120, 0 },
    { "bottom", "top", 100, 0, 0, 120 },
    { "top", "bottom", 100, 200, 0, -120 },
  }) do
    it("have the side of self that was hit, and the speed: " .. row[1], function()
      local wall = world:add("walls", newWall(100, 100, 16, 16))
      local box = world:add("boxes", newBox(row[3], row[4], { vx = row[5], vy = row[6] }))
      local ofBox, ofWall = listen(box), listen(wall)
      play(world)
      for _, log in ipairs({ ofBox, ofWall }) do
        assert.equal(1, log.begins)
        assert.near(120, log.speed, 1e-9)
      end
      assert.equal(wall, ofBox.other)
      assert.equal(box, ofWall.other)
      assert.equal(row[1], ofBox.side)
      assert.equal(row[2], ofWall.side)
    end)
  end

  it("are told to both, then to the world: begin, then stay at every step, then end", function()
    local wall = world:add("walls", newWall(16.5, 0, 16, 16))
    local box = world:add("boxes", newBox(0, 0, { vx = 60 }))
    local lines = {}
    local function note(which, what)
      return function(a, b, side, speed)
        local other = type(b) == "table" and (b == box and "box" or "wall") or "?"
        local first = a == box and "box" or "wall"
        lines[#lines + 1] = ("%s %s: %s %s %s %s"):format(
          which,
          what,
          first,
          other,
          side,
          speed and ("%.3g"):format(speed) or "-"
        )
      end
    end
    for _, what in ipairs({ "onBegin", "onStay", "onEnd" }) do
      box[what], wall[what], world[what] =
        note("box", what), note("wall", what), note("world", what)
    end
    play(world, 3)
    box.vx = -60
    play(world, 3)
    assert.same({
      "box onBegin: box wall right 60",
      "wall onBegin: wall box left 60",
      "world onBegin: box wall right 60",
      "box onStay: box wall right 0.0167",
      "wall onStay: wall box left 0.0167",
      "world onStay: box wall right 0.0167",
      "box onStay: box wall right 0.0167",
      "wall onStay: wall box left 0.0167",
      "world onStay: box wall right 0.0167",
      "box onEnd: box wall right -",
      "wall onEnd: wall box left -",
      "world onEnd: box wall right -",
    }, lines)
  end)

  it("are told in the order of the world, whatever was met first", function()
    world.order = { "late", "early" }
    local lines = {}
    function world.onBegin(a, b)
      lines[#lines + 1] = a.name .. b.name
    end
    for n = 1, 3 do
      local y = 40 * n
      world:add("late", newBox(0, y, { name = "b" .. n, vx = 3000 - 700 * n }))
      world:add("early", newBox(20, y, { name = "w" .. n, static = true }))
    end
    world:update(DT)
    assert.same({ "b1w1", "b2w2", "b3w3" }, lines)
  end)

  -- The box stands before the crate in the order of the world, and so do the walls.
  it("of an object that left are told before those of the step", function()
    local told = {}
    world = physics.newWorld({ gravity = 800 })
    local function note(kind)
      return function(a, b)
        told[#told + 1] = kind .. " " .. a.name .. " " .. b.name
      end
    end
    world:add("tiles", newWall(0, 100, 100, 16, { name = "floor" }))
    local stands = world:add("crates", newBox(60, 84, { name = "crate" }))
    local falls = world:add("boxes", newBox(0, 50, { name = "box", gravity = 0 }))
    play(world, 1)
    world.onBegin, world.onEnd = note("begin"), note("end")
    world:remove(stands)
    falls.y, falls.vy = 83.9, 100
    world:setBounds(-500, -500, 2000, 2000)
    local state = world:save()
    play(world, 1)
    assert.are.same({ "end crate floor", "begin box floor" }, told)
    world:restore(state)
    play(world, 1)
    assert.are.same({ "end crate floor", "begin box floor" }, { told[3], told[4] })
  end)
end)

describe("onBegin and onEnd", function()
  local world, floor

  before_each(function()
    world = physics.newWorld({ gravity = 800 })
    floor = world:add("tiles", newWall(-200, 100, 800, 16))
  end)

  it("onStay is told at every step, also of one that rests", function()
    for _, which in ipairs({ "box", "floor", "world" }) do
      local box = world:add("boxes", newBox(0, 84))
      local owner = which == "box" and box or which == "floor" and floor or world
      play(world, 60)
      local stays = 0
      owner.onStay = function()
        stays = stays + 1
      end
      assert.equal(1, world.stats.resting)
      if which == "floor" then
        world:refresh(floor) -- of a static object it is read once
      end
      play(world, 100)
      assert.equal(100, stays, which)
      owner.onStay = nil
      world:remove(box)
      world:update(DT)
    end
  end)

  it("are not told while it leans on a wall after the push has ended", function()
    local wall = world:add("walls", newWall(100, 0, 16, 100))
    local box = world:add("boxes", newBox(60, 84))
    box.vx = 100
    play(world, 1)
    local log = listen(box)
    box.onStay = nil
    for _ = 1, 60 do
      box.vx = 100
      world:update(DT)
    end
    checkLog(log, 1, 0)
    play(world, 300)
    checkLog(log, 1, 0)
    assert.equal(wall, box.touching.right)
    box.vx = -10
    play(world, 3)
    checkLog(log, 1, 1)
    assert.equal("right", log.side)
    assert.is_false(box.touching.right)
  end)

  -- It stands on the edge, and is past it at the end of the step.
  it("are told in one step for a box that runs off an edge, wherever down is", function()
    for _, row in ipairs({
      { 0, 800, "bottom", "top" },
      { 0, -800, "top", "bottom" },
      { 800, 0, "right", "left" },
      { -800, 0, "left", "right" },
    }) do
      local gx, gy = row[1] / 800, row[2] / 800
      for first, side in ipairs({ row[3], row[4] }) do
        world = physics.newWorld({ gravityX = row[1], gravity = row[2] })
        local log = {}
        world.onBegin = function(_, _, its)
          log[#log + 1] = "begin " .. its
        end
        world.onEnd = function(_, _, its)
          log[#log + 1] = "end " .. its
        end
        local block = { x = 100, y = 100, width = 20, height = 20, static = true }
        local runner = { x = 100 - 20 * gx, y = 100 - 20 * gy, width = 20, height = 20 }
        runner.vx, runner.vy = 1500 * math.abs(gy), 1500 * math.abs(gx)
        world:add("a", first == 1 and runner or block)
        world:add("b", first == 1 and block or runner)
        world:update(1 / 60)
        assert.are.same({ "begin " .. side, "end " .. side }, log)
      end
    end
  end)

  it("onBegin is called in the step that presses, not in the one that ends flush", function()
    for _, push in ipairs({ "both", "first" }) do
      world = physics.newWorld({ gravity = 0, push = push })
      local begun = 0
      world.onBegin = function()
        begun = begun + 1
      end
      world:add("walls", { x = 17, y = 0, width = 16, height = 16, static = true })
      local object = world:add("boxes", newBox(0, 0, { vx = 64 }))
      world:add("boxes", newBox(17, 100))
      local pusher = world:add("boxes", newBox(0, 100, { vx = 64 }))
      world:update(1 / 64)
      assert.are.same({ 1, 64, 1, 64, 0 }, { object.x, object.vx, pusher.x, pusher.vx, begun })
      world:update(1 / 64)
      assert.are.same({ 1, 0, 32, 2 }, { object.x, object.vx, pusher.vx, begun })
    end
  end)

  it("are not told of neighbours that never pressed each other, but for sideBySide", function()
    local wall = world:add("walls", newWall(16, 0, 16, 100))
    local box = world:add("boxes", newBox(0, 84))
    local log = listen(wall)
    play(world, 10)
    checkLog(log, 0, 0)
    assert.is_false(box.touching.right)
    world.sideBySide = true
    play(world, 10)
    checkLog(log, 1, 0)
    assert.equal("left", log.side)
    assert.equal(wall, box.touching.right)
  end)
end)

describe("onBegin and onEnd of an object that is put elsewhere", function()
  -- A bullet from a pool: it is fired again before the next update, and hits the same one in that.
  for _, row in ipairs({
    { "also when it is switched off in between", { active = false } },
    { "also with `rest = false`", {}, { rest = false } },
    { "also pair by pair", {}, { broadphase = "pairs" } },
    { "also a sensor", { sensor = true } },
    { "also with `sideBySide`", {}, { sideBySide = true } },
  }) do
    it("are told anew when it hits again in one step, " .. row[1], function()
      local world = physics.newWorld(row[3] or {})
      world.gravity = 0
      local boss = world:add("bosses", newWall(100, 0, 100, 400))
      local bullet = world:add("bullets", newBox(85, 50, { vx = 1200, sensor = row[2].sensor }))
      local log = listen(bullet)
      play(world, 1)
      checkLog(log, 1, 0)
      assert.equal("right", world:touching(bullet, boss))
      for n = 1, 3 do
        if row[2].active == false then
          bullet.active = false
          bullet.active = true
        end
        bullet.x, bullet.y, bullet.vx = 80, 100 * n, 1200
        assert.is_nil(world:touching(bullet, boss))
        play(world, 1)
        checkLog(log, 1 + n, n)
        assert.equal(1200, log.speed)
        assert.equal("right", world:touching(bullet, boss))
      end
    end)
  end

  it("are not told when it is put elsewhere along what it touches", function()
    local world = physics.newWorld()
    world:add("tiles", newWall(0, 100, 400, 20))
    local box = world:add("boxes", newBox(0, 84))
    local log = listen(box)
    play(world, 10)
    for n = 1, 10 do
      box.x = 30 * n
      play(world, 1)
    end
    checkLog(log, 1, 0)
    box.y = 83
    play(world, 10)
    checkLog(log, 2, 1)
  end)
end)

describe("onEnd is told exactly once", function()
  local world, floor, box, ofBox, ofFloor, told

  before_each(function()
    world = physics.newWorld({ gravity = 800 })
    floor = world:add("tiles", newWall(-200, 100, 800, 16))
    box = world:add("boxes", newBox(0, 84))
    ofBox, ofFloor, told = listen(box), listen(floor), 0
    box.onStay, floor.onStay = nil, nil
    world:refresh(floor)
    play(world, 60)
    function world.onEnd()
      told = told + 1
    end
  end)

  local function no()
    return false
  end

  -- What is written, or done, to the box, the floor or the world.
  for _, row in ipairs({
    { "a box that is removed", box = "removed" },
    { "a box that is removed with plain Lua", world = { objects = {} } },
    { "a box that is switched off", box = { active = false } },
    { "a box with a mask", box = { mask = { tiles = false } } },
    { "a box that is put elsewhere", box = { x = 2000, y = -500 } },
    { "a box that canCollide lets through", box = { canCollide = no } },
    { "a floor that is removed", floor = "removed" },
    { "a floor that is switched off", floor = { active = false } },
    { "a floor with a mask", floor = { mask = { boxes = false } } },
    { "masks of the world", world = { masks = { tiles = { boxes = false } } } },
    { "canCollide of the world", world = { canCollide = no } },
  }) do
    it("for " .. row[1], function()
      for name, object in pairs({ box = box, floor = floor, world = world }) do
        if row[name] == "removed" then
          world:remove(object)
        end
        for field, value in pairs(type(row[name]) == "table" and row[name] or {}) do
          object[field] = value
        end
      end
      if type(row.floor) == "table" then
        world:refresh(floor)
      end
      play(world, 1)
      for _ = 1, 2 do
        checkLog(ofBox, 1, 1)
        checkLog(ofFloor, 1, 1)
        assert.equal("bottom", ofBox.side)
        assert.equal(1, told)
        assert.is_false(box.touching.bottom)
        play(world, 5)
      end
    end)
  end

  it("also when it is switched off and removed, or made part of another world", function()
    box.active = false
    play(world, 2)
    world:remove(box)
    box.active = true
    physics.newWorld():add("boxes", box)
    play(world, 2)
    checkLog(ofBox, 1, 1)
  end)

  it("and begins anew when it comes back, or has been small", function()
    box.active = false
    play(world, 2)
    box.active = true
    play(world, 2)
    checkLog(ofBox, 2, 1)
    world:remove(box)
    play(world, 1)
    world:add("boxes", box)
    play(world, 1)
    checkLog(ofBox, 3, 2)
    box.height = 4
    play(world, 11)
    checkLog(ofBox, 4, 3) -- it has fallen, and stands again
  end)
end)

describe("sensor", function()
  local world

  before_each(function()
    world = physics.newWorld({ gravity = 0 })
  end)

  local function newSensor(x, y, width, height, changes)
    local sensor = { x = x, y = y, width = width, height = height, sensor = true, static = true }
    for name, value in pairs(changes or {}) do
      sensor[name] = value
    end
    return world:add("sensors", sensor)
  end

  it("reports what comes, stays and goes, and stops nothing", function()
    local sensor = newSensor(100, -50, 50, 200)
    local box = world:add("boxes", newBox(0, 0, { vx = 600 }))
    local ofSensor, ofBox = listen(sensor), listen(box)
    for n = 1, 60 do
      world:update(DT)
      assert.near(10 * n, box.x, 1e-9)
      assert.is_false(box.touching.right)
    end
    checkLog(ofSensor, 1, 1)
    checkLog(ofBox, 1, 1)
    assert.equal("left", ofSensor.side)
    assert.equal("right", ofBox.side)
    assert.equal(5, ofSensor.stays)
  end)

  it("is told what is in it when it appears", function()
    local box = world:add("boxes", newBox(0, 0))
    play(world, 10)
    local sensor = newSensor(8, -10, 50, 50)
    local log = listen(sensor)
    play(world, 10)
    checkLog(log, 1, 0)
    assert.equal(box, log.other)
    assert.equal(9, log.stays)
    sensor.active = false
    world:refresh(sensor)
    play(world, 1)
    checkLog(log, 1, 1)
  end)

  -- A sensor of 16 px at x = 100 (with fields), what is at x (with fields), begins and ends in 1 s.
  for _, row in ipairs({
    { "nothing that is flush", {}, 84, {}, 0, 0 },
    { "what is a little in it", {}, 84.01, {}, 1, 0 },
    { "what passes", {}, 0, { vx = 600 }, 1, 1 },
    { "no static sensor", {}, 100, { sensor = true, static = true }, 0, 0 },
    { "a sensor that moves", {}, 0, { sensor = true, vx = 600 }, 1, 1 },
    { "what is kinematic", {}, 0, { kinematic = true, vx = 600 }, 1, 1 },
    { "when it is kinematic", { static = false, kinematic = true, vx = 600 }, 200, {}, 1, 1 },
    { "when it is dynamic", { static = false, vx = 600 }, 200, {}, 1, 1 },
    { "nothing that its mask refuses", { mask = { boxes = false } }, 0, { vx = 600 }, 0, 0 },
    { "nothing with a mask against it", {}, 0, { vx = 600, mask = { sensors = false } }, 0, 0 },
  }) do
    it("sees " .. row[1], function()
      local log = listen(newSensor(100, 0, 16, 16, row[2]))
      local box = world:add("boxes", newBox(row[3], 0, row[4]))
      play(world, 60)
      checkLog(log, row[5], row[6])
      assert.near(row[3] + (row[4].vx or 0), box.x, 1e-9)
    end)
  end
end)

describe("onBegin", function()
  local world, floor

  before_each(function()
    world = physics.newWorld({ gravity = 800 })
    floor = world:add("tiles", newWall(-200, 100, 800, 16))
  end)

  it("may be set and taken away at any time", function()
    local box = world:add("boxes", newBox(0, 0, { restitution = 1 }))
    local begins = 0
    play(world, 30)
    box.onBegin = function()
      begins = begins + 1
    end
    play(world, 100)
    assert.is_true(begins > 0)
    box.onBegin, begins = nil, 0
    play(world, 100)
    assert.equal(0, begins)
    floor.onBegin = function() -- of a static object, too
      begins = begins + 1
    end
    play(world, 100)
    assert.is_true(begins > 0)
  end)

  it("may remove self, the other, or an object that has not been told yet", function()
    local told = 0
    local boxes = {}
    for n = 1, 6 do
      boxes[n] = world:add("boxes", newBox(30 * n, 80))
      boxes[n].onBegin = function(self, other)
        told = told + 1
        assert.equal(floor, other)
        assert.equal(boxes[n], self)
        world:remove(boxes[1])
        world:remove(boxes[n])
        world:remove(boxes[6])
      end
    end
    play(world, 10)
    assert.equal(6, told)
    assert.equal(1, world.stats.objects)
    boxes[1] = world:add("boxes", newBox(0, 80))
    boxes[1].onBegin = function(_, other)
      world:remove(other)
    end
    play(world, 60)
    assert.is_true(boxes[1].y > 200)
  end)

  it("may put the velocity that it wants, and it counts from the next step on", function()
    local box = world:add("boxes", newBox(0, 80))
    box.onBegin = function(self)
      self.vy = -400
    end
    local highest = 100
    for _ = 1, 120 do
      world:update(DT)
      highest = math.min(highest, box.y)
    end
    assert.near(84 - 100, highest, 0.2)
  end)

  it("may call update itself", function()
    local box = world:add("boxes", newBox(0, 60))
    local deep = 0
    box.onBegin = function()
      deep = deep + 1
      world:update(DT)
    end
    play(world, 60)
    assert.equal(1, deep)
    assert.equal(84, box.y)
  end)
end)

describe("canCollide", function()
  local world, floor, box

  before_each(function()
    world = physics.newWorld({ gravity = 800 })
    floor = world:add("tiles", newWall(-200, 100, 800, 16))
    box = world:add("boxes", newBox(0, 60))
  end)

  it("is asked with self, the other and the side of self; of the world with both", function()
    local lines = {}
    local function note(which)
      return function(self, other, side)
        local first, second = self == box and "box" or "floor", other == box and "box" or "floor"
        lines[which] = ("%s %s %s"):format(first, second, side)
        return true
      end
    end
    box.canCollide, floor.canCollide, world.canCollide = note("box"), note("floor"), note("world")
    play(world, 60)
    assert.same({
      box = "box floor bottom",
      floor = "floor box top",
      world = "box floor bottom",
    }, lines)
    assert.equal(84, box.y)
  end)

  it("says no with false and nothing else", function()
    box.canCollide = function() end
    play(world, 60)
    assert.equal(84, box.y)
    box.canCollide = function()
      return false
    end
    play(world, 30)
    assert.is_true(box.y > 100)
  end)

  it("lets pass for this step only", function()
    local log, passes = listen(box), 1
    box.onStay = nil
    box.vy, box.y = 600, 75 -- 10 px a step: it is inside the floor then
    box.canCollide = function()
      passes = passes - 1
      return passes < 0
    end
    world:update(DT)
    assert.is_true(box.y > 84.5)
    assert.is_false(box.touching.bottom)
    checkLog(log, 0, 0)
    world:update(DT)
    assert.equal(84, box.y)
    play(world, 5)
    checkLog(log, 1, 0)
  end)

  it("is asked by objects that rest, too: it may say something else today", function()
    for _, owner in ipairs({ box, world }) do
      local open = false
      owner.canCollide = function()
        return not open
      end
      box.y, box.vy = 60, 0
      play(world, 200)
      assert.equal(84, box.y)
      open = true
      play(world, 30)
      assert.is_true(box.y > 100)
      owner.canCollide = nil
    end
  end)

  it("is asked about sensors, too", function()
    local sensor = world:add("sensors", newWall(-50, 70, 200, 4))
    sensor.sensor = true
    local log = listen(sensor)
    sensor.canCollide = function()
      return false
    end
    play(world, 60)
    checkLog(log, 0, 0)
    sensor.canCollide = nil
    world:refresh(sensor)
    box.y, box.vy = 40, 0
    play(world, 60)
    assert.equal(1, log.begins)
  end)

  -- The box is held by one of the two, so that it does not run into the other.
  for _, broadphase in ipairs({ "pairs", "grid" }) do
    for refusedOne = 1, 2 do
      local title = "touches none of two floors that is refused: number %d, %s"
      it(title:format(refusedOne, broadphase), function()
        local asked = 0
        world.broadphase, box.x, box.y, box.vy = broadphase, 92, 84, 0
        floor.width = 300
        world:refresh(floor)
        local floors = { floor, world:add("tiles", newWall(100, 100, 100, 16)) }
        local logs = { listen(floors[1]), listen(floors[2]) }
        box.canCollide = function(_, tile)
          asked = asked + 1
          return tile ~= floors[refusedOne]
        end
        for _ = 1, 30 do
          world:update(DT)
          assert.equal(floors[3 - refusedOne], box.touching.bottom)
          assert.equal(84, box.y)
        end
        assert.equal(60, asked)
        checkLog(logs[refusedOne], 0, 0)
        checkLog(logs[3 - refusedOne], 1, 0)
      end)
    end
  end

  it("is asked in every step about a wall beside an object that does not press it", function()
    local wall = world:add("tiles", newWall(16, 0, 16, 100))
    box.y, box.vx = 84, 60
    local isWall, log = true, listen(wall)
    wall.canCollide = function()
      return isWall
    end
    play(world, 5)
    assert.equal(wall, box.touching.right)
    isWall = false
    play(world, 1)
    assert.is_false(box.touching.right)
    checkLog(log, 1, 1)
  end)
end)

describe("onCrush", function()
  it("is told to the object and to the world, once", function()
    local world = physics.newWorld({ gravity = 0 })
    local left = world:add("presses", newWall(0, 0, 16, 64))
    local right = world:add("presses", {
      x = 48,
      y = 0,
      width = 16,
      height = 64,
      kinematic = true,
      vx = -60,
    })
    local box = world:add("boxes", newBox(20, 20))
    local lines = {}
    local function note(object, a, b, axis)
      assert.equal(box, object)
      assert.is_true(a == left and b == right or a == right and b == left)
      lines[#lines + 1] = axis
    end
    box.onCrush, world.onCrush = note, note
    play(world, 40)
    assert.same({ "x", "x" }, lines)
    assert.is_true(box.vx - box.vx == 0)
  end)
end)
