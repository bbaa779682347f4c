--- Pits: balls, and boxes among them, in a room of a few of their widths. They stay in it, come to
--- rest, and go on from a state.

local newOverlaps = require("spec.support.overlap").checker
local newRandom = require("spec.support.random").new
local physics = require("physics")
local small = require("spec.support.small")

local function wall(world, x, y, width, height)
  world:add("walls", { x = x, y = y, width = width, height = height, static = true })
end

-- A pit, 60 px wide or as given, with `count` balls at random places above each other. `change` may
-- change each before it is added.
local function newPit(count, seed, change, width)
  local world, random = physics.newWorld({ gravity = 800 }), newRandom(seed)
  width = width or 60
  wall(world, -40, 400, width + 80, 40)
  wall(world, -40, -800, 40, 1200)
  wall(world, width, -800, 40, 1200)
  for i = 1, count do
    local ball = { radius = random:between(6, 10) }
    ball.x, ball.y = random:between(0, width - 2 * ball.radius), 400 - 24 * i
    change(ball, random, i)
    world:add("balls", ball)
  end
  return world
end

-- The deepest overlap of a ball and the pit. (Among masses of very different size a light ball may
-- be shot out at the top.)
local function depthIn(world)
  local deepest = 0
  for _, one in ipairs(world.objects.balls) do
    local side = one.y + one.height > 0 and math.max(-one.x, one.x + one.width - 60) or 0
    deepest = math.max(deepest, side, one.y + one.height - 400)
  end
  return deepest
end

-- Balls, and the number of the scene. (In the last one a box had a speed of 5e-16 px/s for ever.)
local ROWS = { { 8, 12 }, { 8, 54 }, { 12, 3 }, { 12, 40 }, { 20, 21 }, { 20, 35 }, { 12, 8 } }

describe("radius: balls in a pit", function()
  -- Balls, the number of the scene, and the number of steps.
  it("stay between its walls, with any masses, in others, and some unpushable", function()
    local function weigh(ball, random)
      ball.mass = 10 ^ random:between(-6, 6)
    end
    local function fix(ball, random)
      ball.pushable = random:between(0, 1) > 0.3
    end
    -- (Where they begin in each other, masses 10^8 times as large shoot one of 300 out of the pit.)
    local function crowd(ball, random)
      ball.mass = 10 ^ random:between(-3, 3)
      ball.y = 400 - 2 * ball.radius - random:between(0, 60)
    end
    local rows =
      { { 3, 25, weigh, 24 }, { 6, 26, weigh, 40 }, { 2, 13, fix, 20 }, { 10, 19, fix, 40 } }
    for seed = 1, 20 do
      rows[#rows + 1] = { 12, seed, crowd, 40 }
    end
    for _, row in ipairs(rows) do
      local world = newPit(row[1], row[2], row[3])
      for _ = 1, row[4] do
        world:update(1 / 60)
        assert.is_true(depthIn(world) < 1e-6, depthIn(world))
      end
    end
  end)

  it("come to rest with boxes between the balls", function()
    for _, row in ipairs(ROWS) do
      local world = newPit(row[1], row[2], function(object, _, i)
        if i % 3 == 0 then
          object.width, object.height, object.radius = 2 * object.radius, 2 * object.radius, nil
        end
      end)
      small.run(world, 720)
      assert.are.equal(row[1], world.stats.resting)
    end
  end)

  -- Width, balls, the number of the scene, Hz. (In the first three a loose ball went to and fro for
  -- ever, in the others balls rested 0.2 and 0.3 px in each other.)
  small.rows("come to rest, hardly in each other: {1} px wide, {2}, scene {3}", {
    { 200, 12, 17, 60 },
    { 200, 12, 22, 60 },
    { 200, 12, 36, 60 },
    { 100, 24, 25, 30 },
    { 100, 40, 12, 30 },
  }, function(width, count, seed, hz)
    local world = newPit(count, seed, function() end, width)
    small.run(world, 5 * hz, hz)
    assert.are.equal(count, world.stats.resting)
    assert.is_true(newOverlaps(world.objects.balls)() < 0.1)
  end)

  -- In the first one a ball is stuck in the step, in the second one two press each other.
  it("go on as they were when they are restored, with a gravity of each ball", function()
    for _, row in ipairs({ { 4, 33, 59 }, { 10, 29, 34 } }) do
      local world = newPit(row[1], row[2], function(ball, random, i)
        if i % 2 == 0 then
          ball.gravityX, ball.gravity = random:between(-500, 500), random:between(-500, 500)
        end
      end)
      small.run(world, row[3])
      local other = physics.newWorld()
      other:restore(world:save())
      world:update(1 / 60)
      other:update(1 / 60)
      assert.are.equal(world:hash(), other:hash())
    end
  end)
end)
