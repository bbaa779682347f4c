--- After an error that came out of the library, whatever raised it, the world is whole: the next
--- update goes on. Objects fail here at every single point at which the library touches them, one
--- after the other, as they would if memory ran out there.

local effort = require("spec.support.effort")
local physics = require("physics")
local small = require("spec.support.small")

local DT = 1 / 60
local FAILURE = "an object fails"

-- Objects that fail -------------------------------------------------------------------------------

-- Counts down with every access; at 0 the access fails.
local fuse = { left = math.huge }

local function burn()
  fuse.left = fuse.left - 1
  if fuse.left == 0 then
    error(FAILURE, 0)
  end
end

-- An object that keeps its fields elsewhere, so that every access is a call.
local function newFailing(values)
  return setmetatable({}, {
    __index = function(_, name)
      burn()
      return values[name]
    end,
    __newindex = function(_, name, value)
      burn()
      values[name] = value
    end,
  })
end

-- Scenes ------------------------------------------------------------------------------------------

---      a      b ->   |
---      |      |      lift
---     floor ==========
local function newScene()
  local scene = { world = physics.newWorld({ gravity = 800 }), told = {} }
  local function put(name, group, values)
    scene[name] = newFailing(values)
    scene.world.objects[group] = scene.world.objects[group] or {}
    table.insert(scene.world.objects[group], scene[name])
  end
  put("floor", "floors", { x = 0, y = 100, width = 200, height = 16, static = true, friction = 1 })
  put("a", "boxes", { x = 20, y = 83, width = 16, height = 16, friction = 1, mask = { x = false } })
  put("b", "boxes", { x = 60, y = 81, width = 16, height = 16, vx = 40, restitution = 0.5 })
  put("lift", "lifts", { x = 150, y = 90, width = 20, height = 5, kinematic = true, vx = -15 })
  local open = {}
  scene.open = open
  function scene.world.onBegin(first, second)
    assert(not open[first] or not open[first][second], "it began twice")
    open[first] = open[first] or {}
    open[first][second] = true
  end
  function scene.world.onEnd(first, second)
    assert(open[first] and open[first][second], "it ended before it began")
    open[first][second] = nil
  end
  return scene
end

local function isFinite(value)
  return type(value) == "number" and value - value == 0
end

-- The world goes on, and comes to where it should.
local function checkGoesOn(scene, what)
  for _ = 1, 40 do
    local ok, message = pcall(scene.world.update, scene.world, DT)
    assert(ok, what .. ": a later update fails: " .. tostring(message))
  end
  for _, name in ipairs({ "a", "b", "lift" }) do
    local object = scene[name]
    assert(isFinite(object.x) and isFinite(object.vx), what .. ": " .. name .. " is lost")
  end
  assert.same({ 84, 84, 0, 0 }, { scene.a.y, scene.b.y, scene.a.vy, scene.b.vy }, what)
  assert.equal(scene.floor, scene.a.touching.bottom, what)
  assert.equal(100, scene.floor.y, what)
  assert.is_true(scene.open[scene.a][scene.floor], what)
  assert.equal("bottom", scene.world:touching(scene.a, scene.floor), what)
end

local FEWEST = 10 -- with fewer accesses a spec would not look at what it is there for

-- Makes a call fail at each access in turn, until it needs no more; returns how many there were.
local function failEverywhere(prepare, call, check)
  local at, step = 0, effort.isWhole and 1 or 7
  repeat
    at = at + step
    local scene = newScene()
    prepare(scene)
    fuse.left = at
    local ok, message = pcall(call, scene)
    fuse.left = math.huge
    assert(ok or message == FAILURE, tostring(message))
    check(scene, ("access %d"):format(at), ok)
  until ok
  local count = at - step
  assert(count > FEWEST, "accesses: " .. count)
  return count
end

local function run(count)
  return function(scene)
    small.run(scene.world, count)
  end
end

local function update(scene)
  scene.world:update(DT)
end

-- What the rest of the game sees of the scene.
local function snapshot(scene)
  local list = {}
  for _, name in ipairs({ "floor", "a", "b", "lift" }) do
    for _, field in ipairs({ "x", "y", "vx", "vy", "width" }) do
      list[#list + 1] = scene[name][field] or false
    end
  end
  return list
end

describe("update, save, add, raycast: after an object has failed", function()
  for _, steps in ipairs({ 0, 2, 10 }) do
    it("at any point of update number " .. steps + 1 .. ", the next one goes on", function()
      failEverywhere(run(steps), update, checkGoesOn)
    end)
  end

  local function isAlike(one, other)
    for n = 1, #one do
      if one[n] ~= other[n] then
        return false
      end
    end
    return true
  end

  it("at any point before an object has moved, the next one takes over what was written", function()
    local function prepare(scene)
      run(3)(scene)
      scene.a.kinematic, scene.a.vx, scene.a.oneWay = true, 30, "bottom"
      scene.b.drag, scene.b.maxSpeed, scene.b.mask = 100, 35, newFailing({ lifts = false })
      scene.lift.kinematic, scene.lift.gravity = nil, 0
      scene.before = snapshot(scene)
    end
    local twin, seen = newScene(), {}
    prepare(twin)
    run(5)(twin)
    failEverywhere(prepare, update, function(scene, what, ok)
      if not ok and isAlike(scene.before, snapshot(scene)) then
        seen[#seen + 1] = what
        run(5)(scene)
        assert.same(snapshot(twin), snapshot(scene), what)
      end
    end)
    assert.is_true(#seen > 20, "accesses: " .. #seen)
  end)

  small.each("inside {1}, nothing has changed", {
    save = function(scene)
      scene.world:save()
    end,
    raycast = function(scene)
      scene.world:raycast(0, 90, 200, 95)
    end,
    add = function(scene)
      scene.world:add("birds", newFailing({ x = 40, y = 0, width = 5, height = 5, gravity = 0 }))
    end,
  }, function(_, call)
    failEverywhere(run(5), call, function(scene, what, ok)
      local twin = newScene()
      run(5)(twin)
      if not ok then
        assert.same(snapshot(twin), snapshot(scene), what)
        assert.equal(twin.world:hash(), scene.world:hash(), what)
      end
      checkGoesOn(scene, what)
    end)
  end)

  it("inside restore, restoring again puts everything right #slow", function()
    local saved
    failEverywhere(function(scene)
      run(20)(scene)
      saved = scene.world:save()
      run(10)(scene)
    end, function(scene)
      scene.world:restore(saved)
    end, function(scene, what)
      scene.world:restore(saved)
      local twin = newScene()
      run(20)(twin)
      assert.equal(twin.world:hash(), scene.world:hash(), what)
      run(5)(twin)
      run(5)(scene)
      assert.same(snapshot(twin), snapshot(scene), what)
    end)
  end)
end)

-- Callbacks ---------------------------------------------------------------------------------------

describe("onBegin and the others: after one has failed", function()
  it("objects that have not heard of the event are told at the next update", function()
    local scene, told = newScene(), {}
    local function listen(which)
      return function()
        told[#told + 1] = which
      end
    end
    scene.a.onBegin, scene.floor.onBegin = error, listen("floor")
    scene.world.onBegin = listen("world")
    repeat
      local ok = pcall(scene.world.update, scene.world, DT)
    until not ok
    assert.same({}, told)
    scene.a.onBegin = listen("a")
    scene.world:update(DT)
    assert.equal("floor world", table.concat(told, " ", 1, 2))
    assert.is_nil(table.concat(told, " "):find("a ", 1, true))
  end)

  -- Each of them fails once, at its first, second, ... call.
  local CALLBACKS = { "onBegin", "onStay", "onEnd", "canCollide" }
  local cases = small.cross(CALLBACKS, { "world", "a", "b" })
  small.rows("{1} of {2}, the world goes on as if it had not", cases, function(name, which)
    local failures = 0
    for at = 1, 12 do
      local calls, armed = 0, true
      local function callback()
        calls = calls + 1
        if armed and calls == at then
          failures = failures + 1
          error(FAILURE, 0)
        end
        return true
      end
      local scene, twin = newScene(), newScene()
      scene.world.onBegin, scene.world.onEnd = nil, nil
      twin.world.onBegin, twin.world.onEnd = nil, nil
      scene[which][name] = callback
      twin[which][name] = function()
        return true
      end
      for _ = 1, 60 do
        local ok, message = pcall(scene.world.update, scene.world, DT)
        assert(ok or message == FAILURE, message)
        if not ok and name == "canCollide" then
          scene.world:update(DT) -- that step was not made
        end
        twin.world:update(DT)
        assert.same(snapshot(twin), snapshot(scene))
      end
      armed = false
    end
    -- Some of them are never called here.
    assert.is_true(failures > 0 or (name == "onEnd" and which ~= "b"), "failures: " .. failures)
  end)

  it("canCollide, soft bodies that drift apart elsewhere do not keep their drift", function()
    local world = physics.newWorld({ soft = { crowd = { crowd = 400 } } })
    local a = world:add("crowd", small.box(0, 0))
    local b = world:add("crowd", small.box(4, 0))
    local fails = false
    world:add("others", small.box(100, 0)).canCollide = function()
      return not fails or error(FAILURE, 0)
    end
    local other = world:add("others", small.box(120, 0, { vx = -300 }))
    world:update(DT)
    fails = true
    assert.is_false((pcall(world.update, world, DT)))
    fails, a.x, b.x, other.x = false, -300, 300, 600
    a.vx, b.vx = 0, 0
    for _ = 1, 60 do
      world:update(DT)
    end
    assert.same({ -300, 300 }, { a.x, b.x })
  end)
end)
