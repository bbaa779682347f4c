--- Circles: queries and sensors with a `radius`, exact as a plain loop says.

local newRandom = require("spec.support.random").new
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local BROADPHASES = { "grid", "pairs" }

-- The distance of two shapes, < 0: they overlap. A shape is an object, or { x =, y =, r = } around
-- a centre; worked out in the plain way.
local function centerOf(shape)
  if shape.r then
    return shape.x, shape.y, shape.r
  elseif shape.radius then
    return shape.x + shape.radius, shape.y + shape.radius, shape.radius
  end
end

local function distance(a, b)
  local ax, ay, ar = centerOf(a)
  local bx, by, br = centerOf(b)
  if not ax then
    if not bx then
      local gapX = math.max(a.x - b.x - b.width, b.x - a.x - a.width)
      local gapY = math.max(a.y - b.y - b.height, b.y - a.y - a.height)
      return math.max(gapX, gapY)
    end
    return distance(b, a)
  end
  local dx, dy
  if bx then
    dx, dy = ax - bx, ay - by
  else
    dx = ax - math.max(b.x, math.min(ax, b.x + b.width))
    dy = ay - math.max(b.y, math.min(ay, b.y + b.height))
    br = 0
  end
  return math.sqrt(dx * dx + dy * dy) - ar - br
end

-- Boxes and circles, static, kinematic and dynamic, spread over 600 px.
local function crowd(settings, seed)
  settings.gravity = 0
  local world, random, all = physics.newWorld(settings), newRandom(seed), {}
  for i = 1, 150 do
    local object = { x = random:between(-300, 300), y = random:between(-300, 300), n = i }
    if i % 2 == 0 then
      object.radius, object.sensor = random:pick({ 3, 10, 40 }), true
    else
      object.width, object.height = random:between(4, 50), random:between(4, 50)
      object.sensor = true
    end
    object.static = i % 3 == 0 or nil
    all[i] = world:add(i % 5 == 0 and "fifth" or "others", object)
  end
  return world, all, random
end

-- Their numbers, those of the group "fifth" first, as the world has them in order.
local function numbersOf(list, accept)
  local numbers = {}
  for pass = 1, 2 do
    for _, object in ipairs(list) do
      if (object.n % 5 == 0) == (pass == 1) and accept(object) then
        numbers[#numbers + 1] = object.n
      end
    end
  end
  return table.concat(numbers, " ")
end

local function told(list, count)
  local numbers = {}
  assert.are.equal(#list, count)
  for n, object in ipairs(list) do
    numbers[n] = object.n
  end
  return table.concat(numbers, " ")
end

describe("world:queryCircle", function()
  -- A box from (10, 10) to (30, 20).
  small.rows("finds what the circle overlaps: {1}", {
    { "beside", 0, 15, 10.1, 1 },
    { "flush", 0, 15, 10, 0 },
    { "beyond a corner, in the square of the circle only", 6, 6, 5.6, 0 },
    { "at a corner", 7, 6, 5.1, 1 },
    { "flush at a corner", 7, 6, 5, 0 },
    { "inside", 20, 15, 0.5, 1 },
    { "all of it", 20, 15, 500, 1 },
  }, function(where, x, y, r, expected)
    local world = physics.newWorld({ gravity = 0 })
    world:add("a", { x = 10, y = 10, width = 20, height = 10 })
    assert.are.equal(expected, select(2, world:queryCircle(x, y, r)))
    world.sideBySide = true
    local isFlush = where:find("flush") ~= nil
    local count = select(2, world:queryCircle(x, y, r))
    assert.are.equal(isFlush and 1 or expected, count)
  end)

  small.rows("says what a plain loop says, as do the others: {1}", BROADPHASES, function(broadphase)
    local world, all, random = crowd({ broadphase = broadphase }, 3)
    local found = 0
    for turn = 1, 200 do
      local x, y = random:between(-350, 350), random:between(-350, 350)
      local r, filter = random:between(1, 90), turn % 2 == 0 and "fifth" or nil
      local function isWanted(object)
        return not filter or object.n % 5 == 0
      end
      local expected = numbersOf(all, function(object)
        return isWanted(object) and distance({ x = x, y = y, r = r }, object) < -1e-6
      end)
      assert.are.equal(expected, told(world:queryCircle(x, y, r, filter)))
      found = found + #tostring(expected) -- gopher-lua concatenates one number to a number
      local rect = { x = x, y = y, width = r, height = 40 }
      expected = numbersOf(all, function(object)
        return isWanted(object) and distance(object, rect) < -1e-6
      end)
      assert.are.equal(expected, told(world:queryRect(x, y, r, 40, filter)))
      expected = numbersOf(all, function(object)
        return isWanted(object) and distance(object, { x = x, y = y, width = 0, height = 0 }) < 0
      end)
      assert.are.equal(expected, told(world:queryPoint(x, y, filter)))
      local one = all[random:integer(1, #all)]
      expected = numbersOf(all, function(object)
        return object ~= one and distance(object, one) < -1e-6
      end)
      assert.are.equal(expected, told(world:overlapping(one)))
      local nearest, px = world:nearest(x, y, 1000, filter)
      for _, object in ipairs(all) do
        if isWanted(object) then
          local its = math.max(distance({ x = x, y = y, r = 0 }, object), 0)
          assert.is_true(its >= px - 1e-9)
          assert.is_true(object ~= nearest or math.abs(its - px) < 1e-9)
        end
      end
      if turn % 20 == 0 then
        world:update(1 / 60)
      end
    end
    assert.is_true(found > 500)
  end)
end)

-- A circle of 20 px around (50, 50). (A line along its edge is a millionth of a px in it.)
small.rows("raycast and radius: a ray meets a circle: {1}", {
  { "through the middle", { 0, 50, 100, 50 }, { 30, 50, -1, 0, 0.3 } },
  { "from above", { 50, 0, 50, 50 }, { 50, 30, 0, -1, 0.6 } },
  { "off the middle", { 0, 34, 100, 34 }, { 38, 34, -0.6, -0.8, 0.38 } },
  { "aslant", { 18, 24, 58, 44 }, { 38, 34, -0.6, -0.8, 0.5 } },
  { "past it, through its square", { 0, 31, 32, 31 }, nil },
  { "that ends before it", { 0, 50, 29, 50 }, nil },
  { "from inside", { 50, 50, 100, 50 }, { 50, 50, 0, 0, 0 } },
  { "without length inside", { 40, 50, 40, 50 }, { 40, 50, 0, 0, 0 } },
  { "without length in the corner of its square", { 31, 31, 31, 31 }, nil },
  { "away from it", { 29, 50, 0, 50 }, nil },
  { "along its left edge", { 30, 0, 30, 100 }, { 30, 50, -1, 0, 0.5 }, 0.01 },
  { "along its top edge", { 100, 30, 0, 30 }, { 50, 30, 0, -1, 0.5 }, 0.01 },
  { "along its right edge", { 70, 0, 70, 100 }, nil },
  { "up to its top", { 50, 0, 50, 30 }, { 50, 30, 0, -1, 1 } },
  { "from its top, outwards", { 50, 30, 50, 0 }, nil },
  { "from its rim, outwards", { 50 + 20 * math.cos(4), 50 + 20 * math.sin(4), 28.9, 28.8 }, nil },
}, function(_, line, expected, tolerance)
  local world = physics.newWorld({ gravity = 0 })
  local coin = world:add("coins", { x = 30, y = 30, radius = 20, sensor = true })
  local hit = { world:raycast(small.unpack(line)) }
  local _, count = world:querySegment(small.unpack(line))
  assert.are.equal(expected and 1 or 0, count)
  assert.are.equal(expected and coin or nil, hit[1])
  for n = 1, expected and 5 or 0 do
    assert.near(expected[n], hit[n + 1], tolerance or 1e-9)
  end
end)

describe("radius: a sensor with one", function()
  play.row("meets what is in it already with a speed of 0.0, and not -0", play.ONCE, {
    scene.maker("balls", { radius = 5 })("ball", 0, 0, 10, 10),
    scene.maker("waters", { static = true, sensor = true })("water", 0, 3, 10, 10),
  }, { { "listen ball", 1 / 60, "1 / heard.ball.speed == 1 / 0" } })

  it("gets its width and height from add", function()
    local world = physics.newWorld()
    local coin = world:add("coins", { x = 3, y = 4, radius = 2.5, sensor = true })
    assert.are.same({ 5, 5 }, { coin.width, coin.height })
  end)

  -- A box of 4 px that flies by a circle of 20 px around (50, 50).
  local LEVELS = { rate = { 4000, 240, 60, 30 }, shift = { 0 }, order = { "forward" } }
  local function flies(v)
    local blast = scene.maker("blasts", { radius = 20, sensor = true, [v.kind] = true })
    local box = scene.maker("boxes", { vx = v.vx, vy = v.vy })("box", v.x, v.y, 4, 4)
    return { gravity = 0, blast("blast", 30, 30, 40, 40), box }
  end
  for _, kind in ipairs({ "static", "kinematic", "dynamic" }) do
    play.row("({kind}) does not feel what passes {what}", LEVELS, flies, {
      { "listen blast", 1, "blast heard 0, 0" },
    }, {
      "kind, what, x, y, vx, vy",
      { kind, "above", -50, 25.9, 400, 0 },
      { kind, "below the corner of its square", -35, 67, 200, 200 },
      { kind, "through that corner", -20, 78, 300, -400 },
    })

    play.row("({kind}) feels what enters it at {vx} px/s, however fast", LEVELS, flies, {
      { "listen blast", 1, "blast heard 1, 1; heard.blast.sides.left == 1" },
      "heard.blast.speed ~ speed, 1e-9",
    }, {
      "kind, x, y, vx, vy, speed",
      { kind, -50, 48, 400, 0, 400 },
      { kind, -10, 48, 9000, 0, 9000 },
    })
  end

  -- The box's corner meets the circle where its normal is (-0.6, -0.8).
  play.row("tells the approach along its normal", play.ONCE, flies, {
    { "listen blast", 1, "heard.blast.speed ~ 180, 1e-6; heard.blast.sides.top == 1" },
  }, { "kind, x, y, vx, vy", { "static", 0, 30, 300, 0 } })

  local ROUND = { sensor = true, radius = 10 }
  play.row("feels circles as circles", play.ONCE, {
    gravity = 0,
    scene.maker("blasts", ROUND)("blast", 0, 0, 20, 20),
    scene.maker("coins", ROUND)("coin", 15.2, 13.2, 20, 20),
  }, {
    { "listen blast; coin.vy = -1; run:step(0.1); blast heard 0, 0" }, -- 20.1 px apart
    "run:step(0.25); blast heard 1, 0; world:touching(blast.raw, coin.raw) == 'right'",
    "world:explain(coin.raw, blast.raw):find('they overlap by', 1, true) ~= nil",
  })

  play.row("may grow and shrink at run time", play.ONCE, {
    gravity = 0,
    scene.maker("boxes", {})("box", 40, 40, 10, 10),
    scene.maker("blasts", ROUND)("blast", 0, 0, 20, 20),
  }, {
    { "listen blast", 1 / 60, "blast heard 0, 0" },
    { "blast.radius, blast.width, blast.height = 30, 60, 60", 1 / 60, "blast heard 1, 0" },
    -- the square overlaps, the circle not
    { "blast.radius, blast.width, blast.height = 22, 44, 44", 1 / 60, "blast heard 1, 1" },
    "#world:overlapping(blast.raw) == 0",
    { "blast.radius = nil", 1 / 60, "blast heard 2, 1" },
    "world:overlapping(blast.raw)[1] == box.raw",
  })

  small.rows("refuses what is no circle, and changes nothing: {2}", {
    { { radius = 0 }, "width must be a number > 0, got nil (2 * radius is 0)" },
    { { radius = "8" }, "width must be a number > 0, got nil" },
    { { radius = 8, width = 16 }, "height must be a number > 0, got nil (2 * radius is 16)" },
    { { radius = 8, width = 16, height = 17 }, "radius must be half of width and height" },
  }, function(object, words)
    local world, width = physics.newWorld(), object.width
    object.x, object.y, object.sensor = 0, 0, true
    small.refuses("coins[1]." .. words, world.add, world, "coins", object)
    assert.are.equal(width, object.width)
    assert.is_nil(world.objects.coins)
  end)

  it("is refused when only its radius changes", function()
    local world = physics.newWorld()
    local coin = world:add("coins", { x = 0, y = 0, radius = 8, sensor = true })
    coin.radius = 9
    small.refuses("which are 16 and 16, got 9", world.update, world, 1 / 60)
    assert.is_false((pcall(world.queryPoint, world, 0, 0)))
    coin.radius = 8
    world:update(1 / 60)
  end)
end)
