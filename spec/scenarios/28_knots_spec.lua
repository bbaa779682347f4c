--- Knots (overlaps/patience.lua): bodies that overlap and have no room stand still, and begin anew
--- when there may be some.

local overlap = require("spec.support.overlap").depth
local physics = require("physics")
local small = require("spec.support.small")

local play = small.play
local DT = 1 / 60

-- A closet of 30 x 20 px in which two boxes of 20 px stand: 10 px too little.
local function newCloset()
  local world = physics.newWorld({ gravity = 800 })
  local closet = { world = world }
  closet.floor = world:add("walls", { x = -10, y = 20, width = 50, height = 10, static = true })
  closet.left = world:add("walls", { x = -10, y = 0, width = 10, height = 20, static = true })
  closet.right = world:add("walls", { x = 30, y = 0, width = 10, height = 20, static = true })
  closet.lid = world:add("walls", { x = -10, y = -10, width = 50, height = 10, static = true })
  closet.one = world:add("boxes", { x = 2, y = 0, width = 20, height = 20 })
  closet.two = world:add("boxes", { x = 9, y = 0, width = 20, height = 20 })
  return closet
end

describe("x and y: a knot", function()
  it("without room is at rest within two seconds, and costs nothing then", function()
    local closet = newCloset()
    play(closet.world, 2)
    local x, y = closet.one.x, closet.two.x
    assert.equal(2, closet.world.stats.resting)
    play(closet.world, 1)
    assert.equal(x, closet.one.x)
    assert.equal(y, closet.two.x)
    -- The missing 10 px are shared: by the two, and with a wall on each side.
    assert.is_true(overlap(closet.one, closet.two) > 10 / 3 - 0.01)
    assert.is_true(math.min(x, y) >= -10 / 3 - 0.01 and math.max(x, y) <= 10 + 10 / 3 + 0.01)
  end)

  it("cannot be pushed by others then", function()
    local closet = newCloset()
    play(closet.world, 2)
    closet.world:remove(closet.lid)
    play(closet.world, 2) -- one leaves through the top, and lies on the other
    local heavy = closet.world:add("boxes", { x = 0, y = -200, width = 20, height = 20, mass = 50 })
    play(closet.world, 3)
    for _, box in ipairs({ closet.one, closet.two, heavy }) do
      assert.is_true(box.y <= 0 + 1e-6, "a box is below the floor")
    end
    assert.is_true(overlap(closet.one, closet.two) < 0.01)
    assert.is_true(overlap(heavy, closet.one) < 0.01 and overlap(heavy, closet.two) < 0.01)
  end)

  it("comes apart when the game makes room", function()
    local closet = newCloset()
    play(closet.world, 2)
    closet.two.x, closet.two.y = 100, 0
    closet.world:update(DT)
    closet.one.x = 5
    play(closet.world, 1)
    assert.is_true(overlap(closet.one, closet.two) < 0)
    assert.same({ 5, 0 }, { closet.one.x, closet.one.y })
  end)

  it("begins anew when another body is put into it", function()
    local closet = newCloset()
    play(closet.world, 2)
    local x = closet.two.x
    local third = closet.world:add("boxes", { x = 5, y = 4, width = 8, height = 8 })
    closet.world:update(DT)
    assert.equal(0, closet.world.stats.resting)
    play(closet.world, 0.1)
    assert.is_true(math.abs(closet.two.x - x) > 0.1)
    play(closet.world, 2)
    assert.equal(3, closet.world.stats.resting)
    assert.is_true(third.x > -4 and third.x < 26) -- its middle is in the closet
    assert.is_true(third.y > -4 and third.y < 16)
  end)

  it("goes on from a state to the bit, at rest or on its way out", function()
    for _, seconds in ipairs({ 0.1, 0.25, 0.3, 0.5, 2 }) do
      local closet = newCloset()
      closet.world:remove(closet.lid)
      play(closet.world, seconds)
      local state = closet.world:save()
      local hash = closet.world:hash()
      play(closet.world, 1)
      local after = closet.world:hash()
      closet.world:restore(state)
      assert.equal(hash, closet.world:hash())
      play(closet.world, 1)
      assert.equal(after, closet.world:hash())
    end
  end)

  it("goes through other boxes to the nearest free place, and through no wall", function()
    -- Two in one place in the middle of a full row under a lid with an opening at its end.
    local world = physics.newWorld()
    world.gravity = 0
    world:add("walls", { x = 0, y = 20, width = 100, height = 4, static = true })
    world:add("walls", { x = 0, y = -4, width = 100, height = 4, static = true })
    world:add("walls", { x = -4, y = -4, width = 4, height = 28, static = true })
    local boxes = {}
    for i = 0, 4 do
      boxes[i + 1] = world:add("boxes", { x = 20 * i, y = 0, width = 20, height = 20 })
    end
    boxes[6] = world:add("boxes", { x = 41, y = 0, width = 20, height = 20 })
    for _ = 1, 180 do
      world:update(DT)
      for _, box in ipairs(boxes) do
        assert.is_true(box.y >= -1e-6 and box.y <= 1e-6 or box.x >= 100 - 1e-6)
        assert.is_true(box.x >= -1e-6)
      end
    end
    for i = 1, 6 do
      for j = i + 1, 6 do
        assert.is_true(overlap(boxes[i], boxes[j]) < 0.01)
      end
    end
  end)
end)
