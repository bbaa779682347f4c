--- The field `oneWay` as a word: `true` is the top, `false` is none.

local physics = require("physics")

local DT = 1 / 60

-- A ledge, a box that jumps through it from below and lands on it, a lift that is a ledge, too.
local function newWorld(oneWay)
  local world = physics.newWorld({ gravity = 800 })
  local ledge = { x = 0, y = 100, width = 100, height = 8, static = true, oneWay = oneWay }
  local lift = { x = 200, y = 100, width = 50, height = 8, kinematic = true, oneWay = oneWay }
  world:add("ledges", ledge)
  world:add("lifts", lift)
  local box = world:add("boxes", { x = 10, y = 120, width = 16, height = 16, vy = -300 })
  local rider = world:add("boxes", { x = 210, y = 60, width = 16, height = 16 })
  return world, box, ledge, lift, rider
end

describe("oneWay", function()
  local loveBefore

  before_each(function()
    loveBefore = rawget(_G, "love")
  end)

  after_each(function()
    rawset(_G, "love", loveBefore)
  end)

  for _, row in ipairs({ { true, "top" }, { false, nil } }) do
    local word, side = row[1], row[2]

    it(tostring(word) .. " is " .. tostring(side) .. ", bit for bit", function()
      local a, boxA = newWorld(word)
      local b = newWorld(side)
      for _ = 1, 120 do
        a:update(DT)
        b:update(DT)
        for i, object in ipairs(a.objects.boxes) do
          local twin = b.objects.boxes[i]
          assert.equal(twin.x, object.x)
          assert.equal(twin.y, object.y)
          assert.equal(twin.vy, object.vy)
        end
      end
      assert.equal(side and 84 or nil, side and boxA.y)
      assert.equal(b.stats.resting, a.stats.resting)
      assert.is_true(a.stats.resting >= 2) -- and nothing is read anew in each step
    end)

    it(tostring(word) .. " is that in questions, too", function()
      local world, box = newWorld(word)
      box.vy = 0
      world:update(0)
      local hit = world:sweep(box, 0, -60)
      assert.equal(side == nil, hit ~= nil)
      local y = select(2, world:move(box, 10, 60))
      assert.equal(side and 60 or 108, y)
      assert.equal(
        side ~= nil,
        world:explain(box, world.objects.ledges[1]):find("only at its top") ~= nil
      )
    end)
  end

  it("may change to and fro", function()
    local world, _, _, lift, rider = newWorld(true)
    for _ = 1, 90 do
      world:update(DT)
    end
    assert.equal(84, rider.y)
    assert.is_true(world:dropThrough(rider))
    for _ = 1, 30 do
      world:update(DT)
    end
    assert.is_true(rider.y > 108)
    lift.oneWay = false
    rider.y, rider.vy = 120, -200
    for _ = 1, 5 do
      world:update(DT)
    end
    assert.is_true(rider.y >= 108)
  end)

  it("is saved and restored as it was written", function()
    local world, _, ledge = newWorld(true)
    world:update(DT)
    local state = world:save()
    ledge.oneWay = "left"
    world:refresh(ledge) -- as after any change of a static object
    world:restore(state)
    assert.is_true(ledge.oneWay)
  end)

  it("true is drawn as the top", function()
    local function picture(oneWay)
      local calls = {}
      local graphics = setmetatable({}, {
        __index = function()
          return function()
            return 1, 1, 1, 1
          end
        end,
      })
      function graphics.rectangle(...)
        calls[#calls + 1] = table.concat({ ... }, " ")
      end
      rawset(_G, "love", { graphics = graphics })
      local world = newWorld(oneWay)
      world:update(0)
      world:draw()
      return table.concat(calls, ", ")
    end
    assert.equal(picture("top"), picture(true))
    assert.not_equal(picture(false), picture(true))
  end)

  -- It flies up through the one-way, bounces off the ceiling, and comes down onto the one-way in
  -- the same step.
  it("stops what it has let through earlier in the step, wherever else things move", function()
    for _, others in ipairs({ 0, 20 }) do
      local world = physics.newWorld({ gravity = 0 })
      local ball = { x = 40, y = 2, width = 10, height = 10, vy = -2000, restitution = 1 }
      world:add("balls", ball)
      world:add("walls", { x = 0, y = 0, width = 100, height = 2, static = true, oneWay = "top" })
      world:add("walls", { x = 0, y = -40, width = 100, height = 20, static = true })
      for n = 1, others do
        world:add("others", { x = 1000 + 20 * n, y = 0, width = 10, height = 10, vx = 1 })
      end
      world:update(1 / 60)
      assert.near(-34 / 3, ball.y, 1e-9)
      assert.equal(-2000, ball.vy)
    end
  end)
end)
