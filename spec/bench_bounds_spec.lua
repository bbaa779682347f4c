--- The part of the benchmark that watches the bounds of a step (bench/bounds.lua).

local bounds = require("bench.bounds")
local engines = require("bench.engines")
local scenes = require("bench.scenes")

-- An engine of made-up steps: `moves[step]` says what happens to its objects.
local function newEngine(moves)
  local World = {}
  World.__index = World
  function World:step()
    self.count = self.count + 1
    local move = moves[self.count]
    if move then
      move(self.objects)
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
  for field, value in pairs(more or {}) do
    scene[field] = value
  end
  return scene
end

local function play(moves, more)
  return bounds.play(newEngine(moves), newScene(more), 60)
end

describe("the bounds of a scene", function()
  it("count the steps until rest after the last driven one", function()
    local result = play({
      [12] = function(list)
        list[1].x = list[1].x + 1
      end,
    })
    assert.equal(7, result.rest)
  end)

  it("tell the motion beyond the fastest speed of the step, and when it was", function()
    local result = play({
      [2] = function(list)
        list[1].x, list[1].vx = list[1].x + 3, 120 -- 2 px are explained
      end,
      [3] = function(list)
        list[1].x, list[1].vx = list[1].x + 2, 0 -- all of it: it was that fast before
      end,
      [4] = function(list)
        list[1].y = list[1].y + 0.5
      end,
    })
    assert.near(1, result.jump, 1e-12)
    assert.equal(2, result.jumpAt)
  end)

  it("count overlapping pairs, the deepest, and the steps until all are apart", function()
    local result = play({
      [1] = function(list)
        list[1].x = 43
      end,
      [9] = function(list)
        list[1].x = 40
      end,
    })
    assert.same({ 0, 0, 3 }, { result.pairs, result.deepest, result.apart })
  end)
end)

describe("a worst case", function()
  local ours = engines.get("ours", false)

  local function isWorst(definition)
    return definition.growth ~= nil
  end

  for _, definition in ipairs(scenes.list) do
    if isWorst(definition) then
      it("has at most 300 movers, of a size and a place: " .. definition.name, function()
        for _, n in ipairs(definition.sizes) do
          local scene = scenes.build(definition.name, n)
          local world = ours.new({ gravity = 0, objects = scene.objects })
          function world.step() end -- only the game's part of the frames
          for step = 1, scene.driven do
            scene.frame(world, step)
          end
          local movers = 0
          for _, object in ipairs(world:list()) do
            assert.is_true(object.width > 0 and object.height > 0)
            movers = movers + ((object.static or object.kinematic) and 0 or 1)
          end
          assert.is_true(movers >= n and movers <= 300, movers .. " movers")
          assert.is_true(scene.steps - scene.driven >= 120)
        end
      end)

      it("plays, small: " .. definition.name, function()
        local scene = scenes.build(definition.name, definition.quick)
        local result = bounds.play(ours, scene, 60)
        assert.equal(scene.steps, result.steps)
        assert.is_number(result.fold)
        assert.is_number(result.worst)
      end)
    end
  end
end)
