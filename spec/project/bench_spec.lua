--- The parts of the benchmark that could be wrong without anybody noticing. No spec looks at times.

local bounds = require("bench.bounds")
local docs = require("bench.docs")
local engines = require("bench.engines")
local measure = require("bench.measure")
local options = require("bench.options")
local overlap = require("spec.support.overlap")
local scenes = require("bench.scenes")
local small = require("spec.support.small")
local statistics = require("bench.statistics")

small.rows("statistics know median, p99 and mean: {2}, {3}, {4}", {
  { { 5 }, 5, 5, 5 },
  { { 3, 1 }, 2, 3, 2 },
  { { 9, 1, 2 }, 2, 9, 4 },
  { { 4, 1, 3, 2 }, 2.5, 4, 2.5 },
}, function(values, median, p99, mean)
  local found = { statistics.median(values), statistics.quantile(values, 0.99) }
  assert.same({ median, p99, mean }, { found[1], found[2], statistics.mean(values) })
end)

--   +---+        +--+--+      +------+
--   | +-+-+      +--+--+      | +--+ |
--   +-+ | |                   | +--+ |
--     +---+      flush        +------+
small.rows("the overlap measure counts {1}", {
  { "corners by the smaller way out", 3, small.put(0, 0, 10, 10), small.put(5, 7, 10, 10) },
  { "flush boxes not at all", 0, small.put(0, 0, 10, 10), small.put(10, 0, 10, 10) },
  { "a box inside another by its size", 4, small.put(0, 0, 20, 20), small.put(8, 8, 4, 4) },
  { "a box in a wall", 2, small.put(0, 0, 10, 10), small.tile(-50, 8, 100, 5) },
  { "two walls not at all", 0, small.tile(0, 0, 9, 9), small.tile(5, 5, 9, 9) },
}, function(_, expected, one, other)
  assert.equal(expected, (overlap.checker({ one, other })()))
  assert.equal(expected, (overlap.checker({ other, one })()))
end)

it("the command line reads --name value and --name=value, and refuses what is wrong", function()
  local chosen = options.read({ "--scene", "pile,gas", "--n=500,60", "--steps", "9", "--json" })
  assert.same({ "pile", "gas" }, chosen.scenes)
  assert.same({ { 500, 60 }, 9, true }, { chosen.sizes, chosen.steps, chosen.json })
  for wrong, message in pairs({
    ["--scene=heap"] = "bench: --scene: there is no heap; --list shows what there is",
    ["--steps=1.5"] = "bench: --steps must be an integer, got 1.5",
    ["--limit=-1"] = "bench: --limit must be a number > 0, got -1",
  }) do
    assert.same({ false, message }, { pcall(options.read, { wrong }) })
  end
end)

for _, definition in ipairs(scenes.list) do
  local start = definition.startsInside and "starts or becomes full of" or "starts without"
  it(start .. " overlaps, the same every time: " .. definition.name, function()
    local objects = scenes.build(definition.name, definition.quick).objects
    assert.same(objects, scenes.build(definition.name, definition.quick).objects)
    local deepest = overlap.checker(objects)()
    local hasMovers = not objects[#objects].static
    assert.equal(definition.startsInside and hasMovers or false, deepest > 0)
  end)

  if definition.growth then
    it("a scene of the worst cases has at most 300 movers: " .. definition.name, function()
      for _, n in ipairs(definition.sizes) do
        local scene = scenes.build(definition.name, n)
        local world = engines.get("ours", false).new({ gravity = 0, objects = scene.objects })
        function world.step() end -- only the game's part of the frames
        for step = 1, scene.driven do
          scene.frame(world, step)
        end
        local movers = 0
        for _, object in ipairs(world:list()) do
          movers = movers + ((object.static or object.kinematic) and 0 or 1)
        end
        assert.is_true(movers >= n and movers <= 300, movers .. " movers")
      end
    end)
  end
end

-- An engine of made-up steps: `moves[step]` says how far the first object goes, and its `vx` then.
local function newEngine(moves)
  local World = {}
  World.__index = World
  function World:step()
    self.count = self.count + 1
    local move, its = moves[self.count], self.objects[1]
    if move then
      its.x, its.y, its.vx = its.x + move[1], its.y + move[2], move[3] or its.vx
    end
  end
  function World:list()
    return self.objects
  end
  function World.free() end
  local engine = { World = World }
  function engine.new(scene)
    local world = setmetatable({ count = 0, objects = {}, world = { gravity = 0 } }, World)
    for i, description in ipairs(scene.objects) do
      world.objects[i] = { vx = 0, vy = 0 }
      for field, value in pairs(description) do
        world.objects[i][field] = value
      end
    end
    return world
  end
  return engine
end

local function newScene(more)
  local scene = {
    warmUp = 0,
    steps = 30,
    driven = 5,
    room = { 0, 0, 100, 100 },
    objects = {
      { x = 0, y = 0, width = 10, height = 10 },
      { x = 50, y = 0, width = 10, height = 10, static = true },
    },
    frame = function(world)
      world:step(1 / 60)
    end,
  }
  small.set(scene, more)
  return scene
end

local function play(moves)
  return bounds.play(newEngine(moves), newScene(), 60)
end

describe("the bounds of a scene", function()
  it("count the steps until rest after the last driven one", function()
    assert.equal(7, play({ [12] = { 1, 0 } }).rest)
  end)

  it("tell the motion beyond the fastest speed of the step, and when it was", function()
    -- 2 px of the first are explained, and the second: it was that fast before.
    local result = play({ [2] = { 3, 0, 120 }, [3] = { 2, 0, 0 }, [4] = { 0, 0.5 } })
    assert.near(1, result.jump, 1e-12)
    assert.equal(2, result.jumpAt)
  end)

  it("count overlapping pairs, the deepest, and the steps until all are apart", function()
    local result = play({ [1] = { 43, 0 }, [9] = { -3, 0 } })
    assert.same({ 0, 0, 3 }, { result.pairs, result.deepest, result.apart })
  end)
end)

it("a measurement plays all frames, and finds the overlap of every tenth", function()
  local engine = newEngine({})
  engine.World.read = function(world, index)
    return world.objects[index].x, 0
  end
  local result = measure.times(engine, newScene({ worlds = 2, steps = 20 }), 60)
  assert.same({ 20, false }, { result.steps, result.isLimited })
  assert.truthy(result.median <= result.p99 and result.p99 <= result.worst)
  local moving = newScene({ worlds = 1, warmUp = 2, steps = 20 })
  moving.frame = function(world)
    world.objects[1].x = world.objects[1].x + 1
  end
  moving.objects[2].x = 20
  -- 2 + 10 frames: x = 12, 2 px in the wall; 2 + 20: x = 22, 8 px.
  result = measure.quality(engine, moving, 60)
  assert.same({ 2, 8, 8 }, { result.looks, result.overlap, result.overlapAtEnd })
end)

describe("the report", function()
  local function job(engine, n, mode, median, result)
    result.scene, result.engine, result.n, result.mode = "pile-awake", engine, n, mode
    result.median = median
    return result
  end
  local results = {
    job(
      "ours",
      500,
      "jit",
      0.25,
      { p99 = 0.5, overlap = 0, garbage = 12, memory = 1, resident = 1 }
    ),
    job("love", 500, "jit", 1, { p99 = 2, overlap = 1.2, garbage = 2048 }),
    job("bump", 500, "jit", nil, { isLimited = true, atLeast = 16.7 }),
    job("bump", 1000, "jit", nil, { isLimited = true }),
    job("ours", 500, "off", 2, { p99 = 3 }),
    job("ours", 1000, "jit", 0.5, { p99 = 1 }),
    job("love", 1000, "jit", 4, { p99 = 5 }),
    job("fizzx", 1000, "jit", nil, { skipped = "not found on package.path" }),
  }

  it("becomes tables of the page, with what was given up and what was not measured", function()
    local machine = { lua = "LuaJIT", love = "11.4", date = "2026-01-02" }
    local text = docs.render({ machine = machine, results = results })
    for _, expected in ipairs({
      "LÖVE 11.4, LuaJIT, 2026-01-02.",
      "| scene | n | physics.lua | love.physics | bump.lua |",
      "| pile-awake | 500 | 0.250 ms | 1.000 ms (4.0×) | > 16.7 ms |",
      "| pile-awake | 1000 | 0.500 ms | 4.000 ms (8.0×) | > limit |",
      "| pile-awake | 500 | 0.500 ms (2.0×) | 2.000 ms (2.0×) | – |",
      "| pile-awake | 500 | 0 px | 1.2 px | – |",
      "| pile-awake | 500 | 12 B | 2.0 KB | – |",
    }) do
      assert.truthy(text:find(expected .. "\n", 1, true), expected .. " in\n" .. text)
    end
  end)
end)
