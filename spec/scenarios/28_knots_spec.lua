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

-- Moments of random games (spec/fuzz/games.lua) without gravity, made small. `o`: a circle, `b`: a
-- box; x, y, width, vx, vy, and perhaps `fixed` (not pushable), `strong`, `wall`, `elastic`,
-- `heavy`. The game writes these velocities in each step (`-`: none). The `pair` must not end
-- deeper in each other.
describe("x, y, vx and vy: a knot of a random game", function()
  local function read(text)
    local objects, pair = {}, {}
    local pattern = "(%l) (%S+) (%S+) (%S+) (%S+) ([^%s,]+)([^,]*)"
    for shape, x, y, size, vx, vy, words in text:gmatch(pattern) do
      local width = tonumber(size)
      local object = small.put(tonumber(x), tonumber(y), width, width)
      object.radius = shape == "o" and width / 2 or nil
      object.pushable, object.strength = not words:find("fixed"), words:find("strong") and 1
      object.static, object.mass = words:find("wall") ~= nil, words:find("heavy") and 3
      object.restitution = words:find("elastic") and 0.5
      table.insert(objects, { object = object, vx = tonumber(vx), vy = tonumber(vy) })
      if words:find("pair") then
        table.insert(pair, object)
      end
    end
    return objects, pair
  end

  small.rows("{1}", {
    {
      "a strong box walks over a box, along a pillar",
      30,
      1,
      "b 189 146 16 80 - pair strong, b 184 162 18 - - pair, b -64 180 368 - - wall,"
        .. "o 200 129 18 - - wall",
    },
    {
      "a hero that cannot be pushed is stopped by a ball at a wall",
      60,
      1,
      "o 198.4 4 24 80 -80 fixed, o 193 26 18 23 -95 pair,"
        .. "o 184 42.3 20 - -92 pair elastic, o 222 0.3 18 -97 - elastic,"
        .. "b -64 -368 368 - - wall, b 240 -90 368 - - wall",
    },
    {
      "a hero that cannot be pushed is stopped by a ball at a corner",
      30,
      1,
      "o 14.7 154 24 - -80 fixed, o 34.34 145.5 16 - - pair elastic,"
        .. "o 14 130 24 - - elastic, o 42 128 20 - 63 pair, b 20 106 24 - - wall",
    },
    {
      "a ball meets a box straight, in which others have pushed it",
      30,
      1,
      "b 112 82 16 - -, o 104 107.99 10 - -, b 108 98 10 18 - pair,"
        .. "b 114 108 10 - -75, o 118.1 98 10 -27 -, b 97.998 98 10 - - pair,"
        .. "b 128 94 10 -61 -",
    },
    {
      "balls meet boxes in a crowd",
      30,
      1,
      "b 101 87.5 11 - -, o 79.4 79 11 - -, o 90.2 77 11 - -,"
        .. "b 101.1998 76.46 11 86 43 pair, o 112.2 71 11 - -, b 101 65 11 - 79 pair",
    },
    {
      "boxes that are a rounding in others have no fewer impacts",
      30,
      1,
      "b 109.939984 62 10 - -, b 119.939772 59 10 - 71 pair, b 109.94 72 10 - -,"
        .. "b 119.9399 69.1 10 - - pair, b 130 67 10 -57 -, o 129 77 10 - -",
    },
    {
      "balls that are in each other part before they bounce",
      60,
      5,
      "o 19 162 18 80 -, o 35.7 154.8 18 -55 - elastic heavy, o 66.4 126 8 -48 36,"
        .. "o 51.7 109 20 - 51 elastic heavy, o 51.7 129 18 -42 43 pair elastic,"
        .. "o 47 145 12 -51 - pair, b -64 180 368 - - wall",
    },
    {
      "balls press a box into another one that had an impact before",
      60,
      1,
      "b 618.16 460.67 20 -97 39 pair, o 604.27 452.2 14 -85 40,"
        .. "o 570.61 438.05 34 -44 55 heavy, o 604.19 466.18 14 -88 30,"
        .. "b 609.78 480.74 20 -96 4 pair, o 638.19 463.11 22 -89 23, o 629.75 480.71 14 -90 18",
    },
    {
      "two that others press into each other in the step leave each other",
      30,
      1,
      "o 218 80 22 - - fixed, o 210.166 66.7 16 61 103 pair elastic,"
        .. "o 206.3768 81.4404 12 119 -15 elastic heavy, o 189.4 91.28 10 112 -44,"
        .. "o 192.532 78.409 14 120 - elastic heavy, o 198.973 52.1 18 68 99 heavy,"
        .. "o 225.97 65 14 -55 106 elastic, o 200.159 69.81 10 104 60 pair elastic,"
        .. "o 199.399 91.21 12 103 -62, o 170 96 24 114 -38,"
        .. "o 193.6 102.95 18 - -82.3 elastic, b 240 0 180 - - wall",
    },
    {
      "two of which one had an impact at the end of the step leave each other",
      30,
      1,
      "o 109.08 104.9 20 -80 80, o 90.4 123.68 12 56 -56 elastic,"
        .. "o 128.25 104.99 10 -79 - heavy, o 83.2 67.4 18 45 65,"
        .. "o 131.2 63.14 22 -37 70 heavy, o 147.4 78 22 -65 - elastic,"
        .. "o 101.04 69.57 18 - 77, o 133.45 84.711 10 -61 50 pair elastic,"
        .. "o 149.35 99.97 20 -78 - heavy, o 95.3 87.22 22 49 62 elastic heavy,"
        .. "o 117.84 88.54 18 -37 70 pair elastic, o 69.5 79 18 66 -,"
        .. "o 93.15 108.51 16 77 -18 elastic heavy, o 128.9 113.87 20 - -33,"
        .. "o 118.77 74.56 14 -24 75 elastic heavy, o 135.31 93.76 16 -73 31 elastic,"
        .. "o 164 116 10 -77 -, b 103 125 26 - - wall",
    },
  }, function(_, rate, steps, text)
    local world, objects, pair = physics.newWorld({ gravity = 0 }), read(text)
    for n, entry in ipairs(objects) do
      world:add(("things %02d"):format(n), entry.object)
    end
    local before = overlap(pair[1], pair[2])
    for _ = 1, steps do
      for _, entry in ipairs(objects) do
        local object = entry.object
        object.vx, object.vy = entry.vx or object.vx, entry.vy or object.vy
      end
      world:update(1 / rate)
    end
    assert.is_true(overlap(pair[1], pair[2]) < math.max(before, 0) + 0.03)
  end)
end)

-- A ball between the wall above and a round pillar: it has room in no direction.
--
--    ####(ball)####
--    (pillar)   ^ (hero)
it("radius and pushable: a hero that cannot be pushed stops at a ball in a vice", function()
  for _, rate in ipairs({ 30, 60, 120 }) do
    for _, offset in ipairs({ 0, 2, -3 }) do
      local world = physics.newWorld({ gravity = 0 })
      world:add("walls", small.tile(0, -20, 240, 20))
      world:add("walls", small.ball(117.5, 22.5, 14.5, { static = true }))
      local hero = world:add("heroes", small.ball(142 + offset, 30, 10, { pushable = false }))
      local ball = world:add("balls", small.ball(146, 6, 6, { ax = -300 }))
      for _ = 1, 2 * rate do
        hero.vx, hero.vy = 0, -80
        world:update(1 / rate)
        assert.is_true(overlap(hero, ball) < 0.01, overlap(hero, ball))
      end
    end
  end
end)

-- A ball between a hero, which walks on a floor while it is pressed down, and a pillar.
--
--    (pillar)
--         (ball)
--            <-(hero)
--    #################
it("radius and pushable: a hero that cannot be pushed is not thrown by such a ball", function()
  for angle = 30, 60 do
    local world = physics.newWorld({ gravity = 0 })
    local x, y = math.cos(math.rad(angle)), math.sin(math.rad(angle))
    world:add("walls", small.tile(0, 180, 240, 20))
    world:add("walls", small.ball(100 - 40 * x, 168 - 40 * y, 12, { static = true }))
    world:add("balls", small.ball(100 - 20 * x, 168 - 20 * y, 8, { ax = 280, ay = 280 }))
    local hero = world:add("heroes", small.ball(100, 168, 12, { pushable = false }))
    for _ = 1, 20 do
      local before = hero.x
      hero.vx, hero.vy = -80, 80
      world:update(1 / 60)
      assert.near(before, hero.x, 3)
      assert.near(156, hero.y, 1e-4)
    end
  end
end)

-- A small ball lies in a corner; the ball above it is between a pillar and the wall.
--
--    (pillar)(ball)#
--    (hero)->  (o) #
--    ###############
it("radius and pushable: under gravity, too, it stands still there", function()
  for _, rate in ipairs({ 30, 60, 120 }) do
    local world = physics.newWorld({ gravity = 800 })
    world:add("walls", small.tile(160, -20, 20, 200))
    world:add("walls", small.tile(0, 160, 160, 20))
    world:add("walls", small.ball(144, 104, 16, { static = true }))
    world:add("balls", small.ball(154.25, 154.25, 5.75))
    local ball = world:add("balls", small.ball(149.5, 129.9, 10.5))
    local hero = world:add("heroes", small.ball(138, 148.4, 11.5625, { pushable = false }))
    local x
    for step = 1, 2 * rate do
      hero.vx = 150
      world:update(1 / rate)
      if step > rate then
        assert.is_true(overlap(hero, ball) < 0.01, overlap(hero, ball))
        assert.near(x, hero.x, 0.01)
      end
      x = hero.x
    end
  end
end)
