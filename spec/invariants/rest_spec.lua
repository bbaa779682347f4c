--- Proves that skipping what rests changes nothing: the smallest scenes in which it once did,
--- played with and without it. Every hash and every event must be the same.

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local box = small.box

-- Plays with `rest` and without: `plays(world, step)`, where step(dt) updates the world. Fails
-- unless both have the same hash, and have told the same, after each of these.
local function checkSame(settings, plays)
  local tracks = {}
  for n, rest in ipairs({ true, false }) do
    local world, track = physics.newWorld(settings), {}
    world.rest, tracks[n] = rest, track
    for _, name in ipairs({ "onBegin", "onEnd" }) do
      world[name] = function(a, b, side)
        track[#track + 1] = ("%s %g %g %s"):format(name, a.x, b.x, side)
      end
    end
    plays(world, function(dt)
      world:update(dt or 1 / 60)
      track[#track + 1] = world:hash()
    end)
  end
  assert.are.same(tracks[2], tracks[1])
end

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
    checkSame({ gravity = 0 }, function(world, step)
      world:add("walls", box(109, 100, { width = 20, height = 30, static = true }))
      local one = world:add("boxes", box(101, 80, { height = 20, ay = 40, nudge = 10 }))
      local lift = world:add("lifts", box(77, 90, { width = 20, height = 20, kinematic = true }))
      for _ = 1, 3 do
        step()
      end
      lift.vx = -60
      step()
      step(1 / 6)
      assert.are.equal(93, one.x)
      assert.is_true(one.y > 80)
    end)
  end)

  it("a belt starts under a resting box", function()
    checkSame(nil, function(world, step)
      local one = world:add("boxes", box(200, 100, { width = 30, height = 10, vy = 200 }))
      local floor = world:add("floors", box(200, 140, { width = 20, static = true }))
      step(0.21347253244693626)
      floor.surfaceSpeed = 100
      world:refresh(floor)
      step()
      step(0.01)
      assert.is_true(one.x > 200.9)
    end)
  end)

  it("lifts are put back in a long step by as much as they go on", function()
    checkSame({ gravity = 0, maxStep = 1 / 32 }, function(world, step)
      local one = world:add("lifts", box(96, 96, { kinematic = true, vx = 1 }))
      local other = world:add("lifts", box(296, 96, { kinematic = true, vy = 1 }))
      step(1 / 16)
      one.x, other.y = 96, 96
      step(1 / 16)
      step(1 / 16)
      assert.are.same({ 96.125, 96, 296, 96.125 }, { one.x, one.y, other.x, other.y })
    end)
  end)

  -- A ball that a moving wall throws back meets a box that rests. All that is in the step in which
  -- another one far away meets a wall, after that.
  it("a body is woken in the middle of a step", function()
    checkSame({ gravity = 0 }, function(world, step)
      local rests = world:add("a", box(-40, 0, { width = 10 }))
      for _ = 1, 3 do
        step()
      end
      world:add("b", box(60, 0, { width = 10, kinematic = true, vx = -3000 }))
      local ball = world:add("b", box(0, 0, { width = 10, vx = 6000, restitution = 1 }))
      world:add("c", box(100, 500, { height = 50, static = true }))
      local far = world:add("c", box(0, 510, { width = 10, vx = 6000 }))
      step()
      assert.near(-110, rests.x, 1e-6)
      assert.near(-30, ball.x, 1e-6)
      assert.equal(90, far.x)
    end)
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
  local solid = scene.maker("tiles", { static = true })
  play.row("rests while a box presses the wall at {speed} px/s", play.ONCE, {
    solid("floor", 0, 600, 400, 20),
    solid("wall", 200, 0, 4, 600),
    scene.maker("crates", {})("crate", 206, 590, 10, 10),
    scene.maker("players", {})("player", 170, 560, 20, 40),
  }, {
    { steps = 30, keep = "player.vx = speed" },
    { steps = 30, keep = "player.vx = speed", "world.stats.resting == 1" },
    "player.x == 180",
  }, { "speed", { 100 }, { 200 }, { 300 } })
end)

describe("rest: a box on a floor", function()
  local LEVELS = { rate = { 30, 60, 144, 240, 1000, 2000 }, shift = { 0 } }
  play.row("is skipped at each rate", LEVELS, {
    scene.maker("floors", { static = true })("floor", 0, 16, 64, 16),
    scene.maker("boxes", {})("box", 0, 0, 16, 16),
  }, { { steps = 8 }, "world.stats.resting == 1" })
end)

describe("static: one of a row that is pushed", function()
  local make = scene.maker("boxes", {})
  local engine = scene.maker("boxes", { ax = 500 })("engine", 70, 150, 10, 10)
  local ROW = { gravity = 0, engine, make("next", 80, 150, 10, 10), make("last", 90, 150, 10, 10) }
  play.row("stops what pushes it once it is a wall", play.ONCE, ROW, {
    { steps = 1 },
    "next.static = true; world:refresh(next.raw); x = engine.x",
    { steps = 10, "engine.x == x", "engine.vx == 0" },
  })
end)
