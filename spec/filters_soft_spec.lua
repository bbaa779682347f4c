-- Soft crowds: objects of groups that are soft to each other overlap, and drift apart.

local newRandom = require("spec.support.random").new
local physics = require("physics")
local small = require("spec.support.small")

local run = small.run

local DT = 1 / 60

local function newWorld(soft, settings)
  settings = settings or {}
  settings.gravity, settings.soft = settings.gravity or 0, soft
  return physics.newWorld(settings)
end

local function box(x, y, fields)
  return small.put(x, y, 20, 20, fields)
end

local SOFT = { enemies = { enemies = 100 } }

-- Two enemies side by side, the second `gap` px behind where it would overlap nothing.
local function pair(one, other, soft, settings)
  local world = newWorld(soft or SOFT, settings)
  local a = world:add("enemies", box(100, 0, one))
  local b = world:add("enemies", box(110, 0, other))
  return world, a, b
end

describe("soft: objects", function()
  it("drift apart, the slower the less they overlap, and stop", function()
    local world, a, b = pair()
    run(world, 1, 1000)
    assert.near(105, (a.x + b.x) / 2, 1e-9)
    assert.near(0.05, b.x - a.x - 10, 1e-4) -- half of 100 px/s for 1 ms
    run(world, 60)
    assert.near(20 - 10 * math.exp(-100 / 20), b.x - a.x, 0.05) -- the overlap decays
    assert.near(105, (a.x + b.x) / 2, 1e-6)
  end)

  -- All at once it would be to 40 px, and 70 px.
  small.rows("drift in parts of a step if they are fast: at {1} px/s to {2} px", {
    { 3600, 25 },
    { 7200, 30 },
  }, function(speed, apart)
    local world, a, b = pair(nil, nil, { enemies = { enemies = speed } })
    run(world, 1)
    assert.near(apart, b.x - a.x, 1e-9)
  end)

  -- The last one of a row is pushed by three others at once.
  it("drift no faster than the setting says, along both axes", function()
    for axis = 0, 1 do
      local world, row = newWorld(SOFT), {}
      for n = 0, 3 do
        row[n] = world:add("enemies", axis == 0 and box(2 * n, 0) or box(0, 2 * n))
      end
      run(world, 2, 1000)
      local along = axis == 0 and "x" or "y"
      assert.near(-0.2, row[0][along], 1e-9) -- 100 px/s for 2 ms
      assert.near(6 + 0.2, row[3][along], 1e-9)
      assert.near(0, axis == 0 and row[3].y or row[3].x, 1e-9)
    end
  end)

  it("keep their velocities, which do not count the drift", function()
    local world, a, b = pair({ vx = 30, vy = -7 }, { vx = 30, vy = -7 })
    run(world, 20)
    for _, object in ipairs({ a, b }) do
      assert.same({ 30, -7 }, { object.vx, object.vy })
    end
    assert.is_true(b.x - a.x > 14)
  end)

  small.rows("drift apart on a rough floor, too, but for a pixel: {1}", { 30, 144 }, function(rate)
    local world, a, b = pair({ friction = 0.5 }, { friction = 0.5 }, SOFT, { gravity = 800 })
    world:add("floors", small.tile(-500, 20, 1000, 20))
    run(world, 2 * rate, rate)
    assert.near(20, b.x - a.x, 1)
  end)

  it("that drift towards what strikes them get its speed", function()
    for _, row in ipairs({ { "a", 79, 500 }, { "b", 131, -500 } }) do
      local world, a, b = pair()
      world:add("shots", box(row[2], 0, { vx = row[3], mass = 1e6 }))
      run(world, 1)
      assert.near(row[3], (row[1] == "a" and a or b).vx, 1)
    end
  end)

  it("touch nothing and hear of nothing", function()
    local heard = 0
    local function hear()
      heard = heard + 1
    end
    local world, a, b = pair({ onBegin = hear, onStay = hear, onEnd = hear })
    run(world, 30)
    assert.same({ 0, false, 0 }, { heard, a.touching.right, world.stats.contacts })
    assert.is_nil(world:touching(a, b))
    assert.equal(
      "objects.enemies[1] and objects.enemies[2] never collide:"
        .. " their groups are soft to each other.",
      world:explain(a, b)
    )
    assert.is_nil((world:sweep(a, 300, 0)))
  end)

  small.rows("share the drift {1}", {
    { "by their masses", { mass = 3 }, {}, 0.25, 0.75 },
    { "with one that is not pushable", { pushable = false }, {}, 0, 1 },
    { "with one that is kinematic", { kinematic = true }, {}, 0, 1 },
    { "not at all if both are not pushable", { pushable = false }, { pushable = false }, 0, 0 },
  }, function(_, one, other, first, second)
    local world, a, b = pair(one, other)
    run(world, 30)
    local left, right = 100 - a.x, b.x - 110
    local whole = first + second
    assert.near(first * (left + right), left * whole, 1e-6)
    assert.equal(whole > 0, left + right > 5)
  end)

  it("part also if they are at one place, the same in every world", function()
    local places = {}
    for n = 1, 2 do
      local world = newWorld(SOFT, { broadphase = n == 1 and "pairs" or "grid" })
      for _ = 1, 30 do
        world:add("enemies", box(50, 50))
      end
      run(world, 300)
      local overlaps = 0
      for i, enemy in ipairs(world.objects.enemies) do
        places[i] = places[i] or enemy.x
        assert.equal(places[i], enemy.x)
        local _, others = world:queryRect(enemy.x + 4, enemy.y + 4, 12, 12)
        overlaps = overlaps + others - 1
      end
      assert.equal(0, overlaps)
    end
  end)

  it("may be of different groups, named in either order", function()
    for _, soft in ipairs({ { crates = { enemies = 60 } }, { enemies = { crates = 60 } } }) do
      local world, a, b = pair(nil, nil, soft)
      local crate = world:add("crates", box(100, 0))
      run(world, 60)
      assert.is_true(math.abs(a.x - crate.x) + math.abs(a.y - crate.y) > 5)
      assert.is_true(b.x - a.x >= 20 - 1e-6) -- enemies are solid to each other
    end
  end)

  it("are solid to all others, and to what is static", function()
    local world, a = pair({ vx = 100 })
    local wall = world:add("enemies", box(200, 0, { static = true }))
    world:remove(world.objects.enemies[2])
    run(world, 60)
    assert.equal(wall, a.touching.right)
    assert.near(180, a.x, 1e-9)
  end)

  it("do not act through a mask, and not on sensors", function()
    for _, fields in ipairs({
      { mask = { enemies = false } },
      { hits = { "players" } },
      { sensor = true },
      { active = false },
    }) do
      local world, a, b = pair(nil, fields)
      run(world, 10)
      assert.same({ 100, 110 }, { a.x, b.x })
    end
  end)

  it("sleep when they are apart, and are woken by others", function()
    local world, a, b = pair()
    run(world, 600)
    b.x = a.x + 25
    run(world, 2)
    assert.equal(2, world.stats.resting)
    world:add("enemies", box(a.x - 40, 0, { vx = 50 }))
    run(world, 60)
    assert.is_true(b.x - a.x < 20 and a.x > 100)
  end)

  it("change when the setting does, also inside the same table", function()
    local soft = { enemies = { enemies = 0 } }
    local world, a, b = pair(nil, nil, soft)
    run(world, 10)
    assert.equal(10, b.x - a.x)
    soft.enemies.enemies = 100
    run(world, 10)
    assert.is_true(b.x - a.x > 11)
    world.soft = nil
    run(world, 10)
    assert.near(20, b.x - a.x, 1e-6)
    assert.matches("can collide", world:explain(a, b))
  end)
end)

-- Lets each go at a speed to the middle of a player.
local function steer(enemies, player, speed)
  for _, enemy in ipairs(enemies) do
    local half = enemy.width / 2
    local dx, dy = player.x + 10 - enemy.x - half, player.y + 10 - enemy.y - half
    local far = math.max(1, math.sqrt(dx * dx + dy * dy))
    enemy.vx, enemy.vy = speed * dx / far, speed * dy / far
  end
end

describe("soft: a crowd", function()
  -- Frames a second, size, soft; 20 times the size is what the manual recommends.
  for _, row in ipairs({ { 30, 17, 120 }, { 60, 17, 300 }, { 60, 10, 180 }, { 144, 17, 600 } }) do
    local rate, size, soft = row[1], row[2], row[3]
    local name = ("of %d px comes to stand at %d Hz and %d px/s: "):format(size, rate, soft)
    it(name .. "fewer than 2 % turn round in a frame", function()
      local random, world = newRandom(7), newWorld({ enemies = { enemies = soft } })
      local player = world:add("players", box(-10, -10, { pushable = false }))
      for _ = 1, 120 do
        local angle, far = random:between(0, 6.28), random:between(40, 60 + 9 * size)
        local x, y = far * math.cos(angle), far * math.sin(angle)
        world:add("enemies", { x = x, y = y, width = size, height = size })
      end
      local turns, lastX, lastY = 0, {}, {}
      for frame = 1, 7 * rate do
        steer(world.objects.enemies, player, 80)
        for n, enemy in ipairs(world.objects.enemies) do
          enemy.lastX, enemy.lastY, lastX[n], lastY[n] =
            enemy.x, enemy.y, enemy.x - (enemy.lastX or 0), enemy.y - (enemy.lastY or 0)
        end
        world:update(1 / rate)
        for n, enemy in ipairs(world.objects.enemies) do
          local x, y = enemy.x - enemy.lastX, enemy.y - enemy.lastY
          local isSeen = math.max(math.abs(x), math.abs(y)) > 0.05
          if frame > 7 * rate - 20 and isSeen and x * lastX[n] + y * lastY[n] < 0 then
            turns = turns + 1
          end
        end
      end
      assert.is_true(turns / (20 * 120) < 0.02)
    end)
  end
end)

it("soft: the setting must name groups of the world, if that is checked", function()
  local world = newWorld({ enemies = { enemeis = 5 } }, { checked = true })
  world:add("enemies", box(0, 0))
  local words = "world.soft.enemies: there is no group enemeis, did you mean enemies?"
  small.refuses(words, world.update, world, DT)
end)

it("soft: two of different heights part sideways if their middles are equally high", function()
  local world = physics.newWorld({ gravity = 0, soft = { mites = { mites = 100 } } })
  local low = world:add("mites", { x = 0, y = 0, width = 20, height = 10 })
  local tall = world:add("mites", { x = 10, y = -10, width = 20, height = 30 })
  small.run(world, 30)
  assert.near(0, low.y, 1e-9)
  assert.near(-10, tall.y, 1e-9)
  assert.is_true(low.x < -1 and tall.x > 11, "they should part")
end)
