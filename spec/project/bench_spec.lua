--- The parts of the benchmark that could be wrong without anybody noticing. No spec looks at times.

local engines = require("bench.engines")
local options = require("bench.options")
local overlap = require("spec.support.overlap")
local scenes = require("bench.scenes")

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
