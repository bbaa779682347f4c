--- The scenes of examples/compare say what docs/compare.md says of this library and the plain loop.

local snippets = require("spec.support.snippets")

describe("docs/compare.md: examples/compare", function()
  local pathBefore = package.path
  local plays, scenes, engines

  setup(function()
    package.path = "examples/compare/?.lua;" .. package.path
    plays, scenes = require("plays"), require("scenes")
    engines = {}
    for _, each in ipairs(plays.engines()) do
      engines[each.name] = each
    end
  end)

  teardown(function()
    package.path = pathBefore
  end)

  local PAGE = snippets.read("docs/compare.md")

  -- the name of a scene, a word of its row, what the tutorial's loop comes to
  for _, row in ipairs({
    { "seams", "runs over", 0 },
    { "stack", "eight boxes", 9.3 },
    { "lift", "lift starts", 72.5 },
    { "bullet", "a bullet", "through" },
    { "doorway", "thirty enemies", 10.5 },
    { "bounce", "a box bounces", 0.7 },
    { "jump", "the same jump", 7.9 },
    { "pyramid", "a pyramid", 2.7 },
  }) do
    it("is right about " .. row[1], function()
      local scene
      for _, each in ipairs(scenes.list) do
        scene = each.name == row[1] and each or scene
      end
      local ours = plays.number(scene, engines.ours)
      local loop = plays.show(plays.number(scene, engines.tutorial))
      assert.equal(row[1] == "bullet" and "stopped" or 0, ours)
      assert.equal(tostring(row[3]), loop)
      local line = PAGE:match("\n(| [^\n]*" .. row[2] .. "[^\n]*)\n")
      assert.truthy(line:find("| " .. plays.show(ours) .. " |", 1, true), line)
      assert.truthy(line:find("| " .. loop .. " |$"), line)
    end)
  end
end)
