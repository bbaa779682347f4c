--- What rests: when it does, and what wakes it. (That skipping it changes nothing is played by each
--- random game; the smallest scenes in which it once did are in spec/fuzz/found.txt.)

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")

it("rest: a resting heap is woken as a whole by a shot", function()
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

it("rest: a sleeping heap is as it was when a box far away leaves their common floor", function()
  local hashes = {}
  for n, rest in ipairs({ true, false }) do
    local world = physics.newWorld({ gravity = 900, rest = rest })
    world:add("floors", { x = 0, y = 100, width = 400, height = 10, static = true })
    world:add("walls", { x = -10, y = 50, width = 10, height = 60, static = true })
    world:add("walls", { x = 46, y = 50, width = 10, height = 60, static = true })
    world:add("balls", { x = 2, y = 80, radius = 10 })
    world:add("balls", { x = 26, y = 80, radius = 10 })
    world:add("balls", { x = 10, y = 40, radius = 10 })
    local far = world:add("boxes", { x = 300, y = 90, width = 10, height = 10 })
    for frame = 1, 310 do
      if frame == 300 then
        world:remove(far)
      end
      world:update(1 / 60)
    end
    hashes[n] = world:hash()
  end
  assert.equal(hashes[1], hashes[2])
end)
