--- The smallest scenes in which skipping what rests once made a difference. Each is played with and
--- without it, and every hash and every event must be the same.

local physics = require("physics")

local unpack = rawget(table, "unpack") or rawget(_G, "unpack")

-- What is in the scene, by number, and what it is told.
local function newPlayer(settings, rest)
  local all = { rest = rest }
  for key, value in pairs(settings or {}) do
    all[key] = value
  end
  local player = { world = physics.newWorld(all), objects = {}, numbers = {}, log = {} }
  local function note(kind)
    return function(a, b, side)
      local first, second = player.numbers[a] or "?", player.numbers[b] or "?"
      player.log[#player.log + 1] = ("%s %s %s %s"):format(kind, first, second, tostring(side))
    end
  end
  player.world.onBegin, player.world.onEnd = note("begin"), note("end")
  return player
end

local acts = {}

function acts.add(player, number, group, fields)
  local object = {}
  for key, value in pairs(fields) do
    object[key] = value
  end
  player.objects[number], player.numbers[object] = object, number
  player.world:add(group, object)
end

function acts.write(player, number, fields)
  local object = player.objects[number]
  for key, value in pairs(fields) do
    object[key] = value
  end
  if object.static then
    player.world:refresh(object)
  end
end

function acts.bounds(player, ...)
  player.world:setBounds(...)
end

function acts.set(player, name, value)
  player.world[name] = value
end

function acts.update(player, dt)
  player.world:update(dt)
end

local function checkSame(settings, list)
  local with, without = newPlayer(settings, true), newPlayer(settings, false)
  for n, act in ipairs(list) do
    for _, player in ipairs({ with, without }) do
      acts[act[1]](player, unpack(act, 2))
    end
    local place = ("after act %d (%s)"):format(n, act[1])
    assert.are.equal(without.world:hash(), with.world:hash(), place)
    assert.are.same(without.log, with.log, place)
  end
  return with
end

local DT = 1 / 64

describe("rest changes nothing:", function()
  -- The box would slide around the corner of the wall, where the lift is in the way: too far off to
  -- be a neighbour of the box.
  --
  --          +--+
  --   +----+ |  |
  --   |    | +--+
  --   +----+  +-----+
  --           |     |
  it("a lift goes away from where a box would be nudged to", function()
    local player = checkSame({ gravity = 0 }, {
      { "add", 1, "walls", { x = 109, y = 100, width = 20, height = 30, static = true } },
      { "add", 2, "boxes", { x = 101, y = 80, width = 16, height = 20, ay = 40, nudge = 10 } },
      { "add", 3, "lifts", { x = 77, y = 90, width = 20, height = 20, kinematic = true } },
      { "update", 1 / 60 },
      { "update", 1 / 60 },
      { "update", 1 / 60 },
      { "write", 3, { vx = -60 } },
      { "update", 1 / 60 },
      { "update", 1 / 6 },
    })
    assert.are.equal(93, player.objects[2].x)
    assert.is_true(player.objects[2].y > 80)
  end)

  it("a belt starts under a resting box", function()
    local player = checkSame(nil, {
      { "add", 1, "boxes", { x = 200, y = 100, width = 30, height = 10, vy = 200 } },
      { "add", 2, "floors", { x = 200, y = 140, width = 20, height = 10, static = true } },
      { "update", 0.21347253244693626 },
      { "write", 2, { surfaceSpeed = 100 } },
      { "update", 1 / 60 },
      { "update", 0.01 },
    })
    assert.is_true(player.objects[1].x > 200.9)
  end)

  it("lifts are put back in a long step by as much as they go on", function()
    local function at(x, y, vx, vy)
      return { x = x, y = y, width = 16, height = 16, kinematic = true, vx = vx, vy = vy }
    end
    local player = checkSame({ gravity = 0, maxStep = 1 / 32 }, {
      { "add", 1, "lifts", at(96, 96, 1, 0) },
      { "add", 2, "lifts", at(296, 96, 0, 1) },
      { "update", 1 / 16 },
      { "write", 1, { x = 96 } },
      { "write", 2, { y = 96 } },
      { "update", 1 / 16 },
      { "update", 1 / 16 },
    })
    local one, other = player.objects[1], player.objects[2]
    assert.are.same({ 96.125, 96, 296, 96.125 }, { one.x, one.y, other.x, other.y })
  end)

  -- A ball that a moving wall throws back meets a box that rests. All that is in the step in which
  -- another one far away meets a wall, after that.
  it("a body is woken in the middle of a step", function()
    local player = checkSame({ gravity = 0 }, {
      { "add", 1, "a", { x = -40, y = 0, width = 10, height = 10 } },
      { "update", 1 / 60 },
      { "update", 1 / 60 },
      { "update", 1 / 60 },
      { "add", 2, "b", { x = 60, y = 0, width = 10, height = 10, kinematic = true, vx = -3000 } },
      { "add", 3, "b", { x = 0, y = 0, width = 10, height = 10, vx = 6000, restitution = 1 } },
      { "add", 4, "c", { x = 100, y = 500, width = 5, height = 50, static = true } },
      { "add", 5, "c", { x = 0, y = 510, width = 10, height = 10, vx = 6000 } },
      { "update", 1 / 60 },
    })
    local objects = player.objects
    assert.near(-110, objects[1].x, 1e-6)
    assert.near(-30, objects[3].x, 1e-6)
    assert.equal(90, objects[5].x)
  end)
end)

describe("rest: a resting heap", function()
  it("is woken as a whole by a shot", function()
    local world = physics.newWorld({ gravity = 600 })
    world:add("floor", { x = 0, y = 600, width = 400, height = 20, static = true })
    for n = 0, 39 do
      local x, y = 100 + 20 * (n % 4), 580 - 5 * (n - n % 4)
      world:add("boxes", { x = x, y = y, width = 20, height = 20 })
    end
    world:update(1 / 60)
    world:update(1 / 60)
    assert.equal(40, world.stats.resting)
    world:add("shots", { x = 0, y = 500, width = 8, height = 8, vx = 900, gravity = 0 })
    repeat
      assert.is_true(world.objects.shots[1].x < 100)
      world:update(1 / 60)
    until world.stats.resting < 40
    assert.equal(0, world.stats.resting)
  end)
end)

describe("rest: a crate behind a thin wall", function()
  for _, speed in ipairs({ 100, 200, 300 }) do
    it("rests while a box presses the wall at " .. speed .. " px/s", function()
      local world = physics.newWorld({ gravity = 600 })
      world:add("tiles", { x = 0, y = 600, width = 400, height = 20, static = true })
      world:add("tiles", { x = 200, y = 0, width = 4, height = 600, static = true })
      world:add("crates", { x = 206, y = 590, width = 10, height = 10 })
      local player = world:add("players", { x = 170, y = 560, width = 20, height = 40 })
      for step = 1, 60 do
        player.vx = speed
        world:update(1 / 60)
        assert.is_true(step < 30 or world.stats.resting == 1, "step " .. step)
      end
      assert.equal(180, player.x)
    end)
  end
end)

describe("rest: a box on a floor", function()
  for _, rate in ipairs({ 30, 60, 144, 240, 1000, 2000 }) do
    it("is skipped at " .. rate .. " Hz", function()
      local world = physics.newWorld()
      world:add("floors", { x = 0, y = 16, width = 64, height = 16, static = true })
      world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })
      for _ = 1, 8 do
        world:update(1 / rate)
      end
      assert.equal(1, world.stats.resting)
    end)
  end
end)

describe("static: one of a row that is pushed", function()
  it("stops what pushes it once it is a wall", function()
    local world = physics.newWorld()
    local boxes = {}
    for n = 1, 3 do
      boxes[n] = world:add("boxes", { x = 60 + 10 * n, y = 150, width = 10, height = 10 })
    end
    boxes[1].ax = 500
    world:update(DT)
    boxes[2].static = true
    world:refresh(boxes[2])
    local x = boxes[1].x
    for _ = 1, 10 do
      world:update(DT)
      assert.are.equal(x, boxes[1].x)
      assert.are.equal(0, boxes[1].vx)
    end
  end)
end)
