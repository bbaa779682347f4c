--- What random games have found, made small: a game a line in spec/fuzz/found.txt, with a sentence
--- that says what must hold. `make fuzz` prints such lines. A game is dropped when the behaviour
--- that it shows changes and no player could see it. (#slow in a sentence: see spec/slow.lua.)

local effort = require("spec.support.effort")
local physics = require("physics")
local trial = require("spec.fuzz.trial")

effort.interpretQuickly(setup, teardown)

describe("a random game has found that", function()
  for line in io.lines("spec/fuzz/found.txt") do
    local sentence, text = line:match("^(.-)\t(.*)$")
    local case = assert((rawget(_G, "loadstring") or load)("return " .. text))
    it(sentence, function()
      local failure = trial.run(case())
      assert(not failure, failure and failure.check .. ": " .. failure.text)
    end)
  end
end)

-- Three inside each other, each in front of the next. Each push moves one by the width of the
-- others, 23 px in a round, until it is known which one holds which, after eight impacts. Before,
-- it went on up to the limit of impacts: 736 px in a step.
it("a review has found that bodies that hold each other in a ring lie still", function()
  local world = physics.newWorld({ gravityX = 300, gravity = 0 })
  local boxes = {}
  for n, box in ipairs({
    { 60, 160, 10, 10 },
    { 42.15662814777, 160, 8, 10 },
    { 90, 160, 10, 10 },
    { 120, 162.57129250214, 8, 3 },
    { 60, 164.68315135906, 3, 10 },
    { 196.7268311217, 170, 8, 8 },
    { 170, 170, 10, 10 },
    { 180, 170, 10, 3 },
  }) do
    boxes[n] = { x = box[1], y = box[2], width = box[3], height = box[4] }
    world:add(n <= 3 and "a" or "b", boxes[n])
  end
  world:add("walls", { x = 200, y = -100, width = 10, height = 310, static = true })
  local lift = { x = 0, y = 130, width = 30, height = 30, kinematic = true, vx = 600, vy = 100 }
  world:add("lifts", lift)
  world:update(1 / 60)
  for step = 2, 60 do
    local before = {}
    for n, box in ipairs(boxes) do
      before[n] = box.x
    end
    world:update(1 / 60)
    for n, box in ipairs(boxes) do
      local way = math.abs(box.x - before[n])
      assert.is_true(way < 9 * 23, ("step %d: box %d went %g px"):format(step, n, way))
    end
  end
end)
