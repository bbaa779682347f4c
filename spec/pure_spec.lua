--- The tutorial's pure functions, with checked arguments.

local fields = require("physics.fields.fields")
local newRandom = require("spec.support.random").new
local physics = require("physics")
local pure = require("physics.world.tutorial")

local NAN, INF = 0 / 0, 1 / 0

local function box(x, y, width, height)
  return { x = x, y = y, width = width, height = height }
end

--- A box from a row: { x, y, width, height, and fields by name }.
local function boxOf(row)
  local result = box(row[1], row[2], row[3], row[4])
  for name, value in pairs(row) do
    if type(name) == "string" then
      result[name] = value
    end
  end
  return result
end

--- Runs a call that must be refused. It must blame this file, and say exactly this.
local function refuses(expected, call)
  local ok, message = pcall(call)
  assert.is_false(ok)
  assert.equal(expected, (message:gsub("^.-pure_spec%.lua:%d+: ", "")))
  assert.truthy(message:find("pure_spec.lua:", 1, true))
end

local WRONG_BOXES = {
  { nil, " must be a table, got nil" },
  { "box", ' must be a table, got "box"' },
  { {}, ".x must be a number, got nil" },
  { { x = 0, y = 0, width = 1 }, ".height must be a number > 0, got nil" },
  { { x = "0", y = 0, width = 1, height = 1 }, '.x must be a number, got "0"' },
  { box(NAN, 0, 1, 1), ".x must be a number, got nan" },
  { box(0, INF, 1, 1), ".y must be a finite number, got inf" },
  { box(0, 0, 0, 1), ".width must be a number > 0, got 0" },
  { box(0, 0, 1, -1), ".height must be a number > 0, got -1" },
  { box(0, 0, INF, 1), ".width must be a finite number > 0, got inf" },
}

--- Specs for what two boxes must be, whichever of them is wrong.
local function describeWrongBoxes(name)
  for _, row in ipairs(WRONG_BOXES) do
    local wrong, expected = row[1], row[2]
    it("refuses: a" .. expected, function()
      refuses("physics: " .. name .. "(a, b): a" .. expected, function()
        pure[name](wrong, box(0, 0, 1, 1))
      end)
    end)

    it("refuses: b" .. expected, function()
      refuses("physics: " .. name .. "(a, b): b" .. expected, function()
        pure[name](box(0, 0, 1, 1), wrong)
      end)
    end)
  end
end

describe("inside", function()
  --  0       10
  --  +-------+   the left and the top edge belong to the rectangle,
  --  |#######.   the right and the bottom edge do not
  --  |#######.
  --  +.......+   10
  for _, row in ipairs({
    { "in the middle", { 4, 4, 2, 2 }, true },
    { "in the top left corner", { 0, 0, 2, 2 }, true },
    { "a point on the left edge", { 0, 5, 0, 0 }, true },
    { "a point on the right edge", { 10, 5, 0, 0 }, false },
    { "a point on the bottom edge", { 5, 10, 0, 0 }, false },
    { "in the bottom right corner", { 8, 8, 2, 2 }, false },
    { "half outside", { -1, 4, 2, 2 }, false },
    { "larger", { -1, -1, 12, 12 }, false },
  }) do
    local name, a, expected = row[1], row[2], row[3]
    it("is " .. tostring(expected) .. " for a rectangle " .. name, function()
      assert.equal(expected, pure.inside(a[1], a[2], a[3], a[4], 0, 0, 10, 10))
    end)
  end

  -- which of the eight numbers is wrong
  for _, row in ipairs({
    { 1, nil, "x1 must be a number, got nil" },
    { 2, NAN, "y1 must be a number, got nan" },
    { 3, -1, "w1 must be a number >= 0, got -1" },
    { 4, "1", 'h1 must be a number >= 0, got "1"' },
    { 5, INF, "x2 must be a finite number, got inf" },
    { 6, {}, "y2 must be a number, got table" },
    { 7, 0, "w2 must be a number > 0, got 0" },
    { 8, -2, "h2 must be a number > 0, got -2" },
  }) do
    local place, value, expected = row[1], row[2], row[3]
    it("refuses: " .. expected, function()
      local n = { 1, 2, 3, 4, 5, 6, 7, 8 }
      n[place] = value
      refuses("physics: inside(x1, y1, w1, h1, x2, y2, w2, h2): " .. expected, function()
        pure.inside(n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8])
      end)
    end)
  end
end)

describe("side", function()
  --        +--+
  --        |a |             the middles are 90 px apart on x and 11 on y, and yet it is the
  --   +----|--|--------+    bottom of a that stands on b
  --   +----+--+------b-+
  for _, row in ipairs({
    {
      "a medium box on the end of a wide thin one",
      { 0, -19, 20, 20 },
      { 0, 0, 200, 4 },
      "bottom",
    },
    { "a medium box that came out below", { 0, -15, 20, 20 }, { 0, 0, 200, 4 }, "bottom" },
    { "a wide thin box under a medium one", { 0, 0, 200, 4 }, { 180, -19, 20, 20 }, "top" },
    { "a wide box deep on a post", { 0, 0, 100, 20 }, { 40, 14, 4, 60 }, "bottom" },
    { "a box from the left", { 0, 0, 10, 10 }, { 8, 1, 10, 10 }, "right" },
    { "a box from the right", { 8, 1, 10, 10 }, { 0, 0, 10, 10 }, "left" },
    { "equal boxes", { 0, 0, 10, 10 }, { 0, 0, 10, 10 }, "bottom" },
    { "boxes that are apart", { 0, 0, 10, 10 }, { 50, 0, 10, 10 }, "right" },
  }) do
    local name, a, b, expected = row[1], row[2], row[3], row[4]
    it("is " .. expected .. " for " .. name, function()
      assert.equal(expected, pure.side(boxOf(a), boxOf(b)))
    end)
  end

  describeWrongBoxes("side")
end)

describe("checkCollision", function()
  -- name, a, b, overlapping, side by side counted
  --
  --       +---+         corners inside: none of a's in b (larger), none at all (cross)
  --   +---|---|---+
  --   |   |   |   |
  --   +---|---|---+
  --       +---+
  for _, row in ipairs({
    { "corners in each other", { 0, 0, 10, 10 }, { 8, 5, 10, 10 }, "right", "right" },
    { "the other way round", { 8, 5, 10, 10 }, { 0, 0, 10, 10 }, "left", "left" },
    { "a larger one", { 0, 0, 100, 100 }, { 2, 40, 10, 10 }, "left", "left" },
    { "a smaller one", { 2, 40, 10, 10 }, { 0, 0, 100, 100 }, "right", "right" },
    { "a cross", { 0, 50, 100, 4 }, { 40, 0, 4, 100 }, "left", "left" },
    { "the same place", { 0, 0, 10, 10 }, { 0, 0, 10, 10 }, "bottom", "bottom" },
    { "flush on the right", { 0, 0, 10, 10 }, { 10, 3, 10, 10 }, false, "right" },
    { "flush on the left", { 10, 3, 10, 10 }, { 0, 0, 10, 10 }, false, "left" },
    { "flush on the bottom", { 0, 0, 10, 10 }, { 3, 10, 10, 10 }, false, "bottom" },
    { "flush on the top", { 3, 10, 10, 10 }, { 0, 0, 10, 10 }, false, "top" },
    { "flush corners", { 0, 0, 10, 10 }, { 10, 10, 10, 10 }, false, "bottom" },
    { "an overlap by rounding", { 0, 0, 10, 10 }, { 10 - 1e-9, 3, 10, 10 }, false, "right" },
    { "a gap by rounding", { 0, 0, 10, 10 }, { 10 + 1e-9, 3, 10, 10 }, false, "right" },
    { "an overlap", { 0, 0, 10, 10 }, { 10 - 1e-5, 3, 10, 10 }, "right", "right" },
    { "a gap", { 0, 0, 10, 10 }, { 10 + 1e-5, 3, 10, 10 }, false, false },
    { "far apart", { 0, 0, 10, 10 }, { 99, 99, 10, 10 }, false, false },
  }) do
    local name, a, b, plain, sideBySide = row[1], row[2], row[3], row[4], row[5]
    it("is " .. tostring(plain) .. " for " .. name, function()
      assert.equal(plain, pure.checkCollision(boxOf(a), boxOf(b)))
      assert.equal(plain, pure.checkCollision(boxOf(a), boxOf(b), false))
    end)

    it("is " .. tostring(sideBySide) .. " for " .. name .. ", side by side counted", function()
      assert.equal(sideBySide, pure.checkCollision(boxOf(a), boxOf(b), true))
    end)

    it("takes the eight numbers of " .. name, function()
      local function numbers(...)
        return pure.checkCollision(a[1], a[2], a[3], a[4], b[1], b[2], b[3], b[4], ...)
      end
      assert.equal(plain, numbers())
      assert.equal(sideBySide, numbers(true))
    end)
  end

  it("of the module does as the default world, if the call does not say", function()
    local a, b = box(0, 0, 10, 10), box(10, 3, 10, 10)
    for _, setting in ipairs({ true, false }) do
      physics.load({ sideBySide = setting })
      local expected = setting and "right"
      assert.equal(expected, physics.checkCollision(a, b))
      assert.equal(expected, physics.checkCollision(0, 0, 10, 10, 10, 3, 10, 10))
      assert.equal("right", physics.checkCollision(a, b, true))
      assert.is_false(physics.checkCollision(a, b, false))
      assert.equal("right", physics.checkCollision(0, 0, 10, 10, 10, 3, 10, 10, true))
      assert.is_false(physics.checkCollision(0, 0, 10, 10, 10, 3, 10, 10, false))
    end
    physics.load()
  end)

  it("changes nothing", function()
    local a, b = box(0, 0, 10, 10), box(8, 5, 10, 10)
    pure.checkCollision(a, b)
    assert.same({ box(0, 0, 10, 10), box(8, 5, 10, 10) }, { a, b })
  end)

  describeWrongBoxes("checkCollision")

  it("refuses a sideBySide that is no boolean", function()
    local call = "physics: checkCollision(a, b, sideBySide): "
    refuses(call .. "sideBySide must be true or false, got 1", function()
      pure.checkCollision(box(0, 0, 1, 1), box(0, 0, 1, 1), 1)
    end)
  end)

  -- which of the nine arguments is wrong
  for _, row in ipairs({
    { 2, nil, "y1 must be a number, got nil" },
    { 3, 0, "w1 must be a number > 0, got 0" },
    { 4, -1, "h1 must be a number > 0, got -1" },
    { 5, NAN, "x2 must be a number, got nan" },
    { 6, box(0, 0, 1, 1), "y2 must be a number, got table" },
    { 7, INF, "w2 must be a finite number > 0, got inf" },
    { 8, nil, "h2 must be a number > 0, got nil" },
    { 9, "yes", 'sideBySide must be true or false, got "yes"' },
  }) do
    local place, value, expected = row[1], row[2], row[3]
    it("refuses in its form with numbers: " .. expected, function()
      local n = { 1, 2, 3, 4, 5, 6, 7, 8 }
      n[place] = value
      refuses("physics: checkCollision(x1, y1, w1, h1, x2, y2, w2, h2): " .. expected, function()
        pure.checkCollision(n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9])
      end)
    end)
  end
end)

describe("bump", function()
  --   0       10                 a is hit on its right, 4 px deep
  --   +-------+
  --   | a +---|---+ b      both:   a x = -2, b x = 8
  --   +---|---+   |        first:  a x = -4
  --       +-------+
  --       6       16
  describe("moves", function()
    -- name, fields of a, fields of b, x of a and b in mode "both", x of a and b in mode "first"
    for _, row in ipairs({
      { "plain boxes", {}, {}, { -2, 8 }, { -4, 6 } },
      { "a lighter one further", { mass = 1 }, { mass = 3 }, { -3, 7 }, { -4, 6 } },
      { "a heavier one less", { mass = 4 }, {}, { -0.8, 9.2 }, { -4, 6 } },
      { "all of a, where b is static", {}, { static = true }, { -4, 6 }, { -4, 6 } },
      { "all of b, where a is static", { static = true }, {}, { 0, 10 }, { 0, 10 } },
      { "all of a, where b is kinematic", {}, { kinematic = true }, { -4, 6 }, { -4, 6 } },
      { "all of b, where a is kinematic", { kinematic = true }, {}, { 0, 10 }, { 0, 10 } },
      { "all of a, where b is not pushable", {}, { pushable = false }, { -4, 6 }, { -4, 6 } },
      { "all of b, where a is not pushable", { pushable = false }, {}, { 0, 10 }, { 0, 10 } },
      {
        "what is not pushable out of a wall",
        { pushable = false },
        { static = true },
        { -4, 6 },
        { -4, 6 },
      },
      {
        "two that are not pushable",
        { pushable = false },
        { pushable = false },
        { -2, 8 },
        { -4, 6 },
      },
      {
        "nothing, where both are static",
        { static = true },
        { static = true },
        { 0, 6 },
        { 0, 6 },
      },
      {
        "nothing, where neither can give way",
        { kinematic = true },
        { static = true },
        { 0, 6 },
        { 0, 6 },
      },
    }) do
      local name, fieldsOfA, fieldsOfB = row[1], row[2], row[3]
      for mode, expected in pairs({ both = row[4], first = row[5] }) do
        it(name .. ', mode "' .. mode .. '"', function()
          local a, b = boxOf(fieldsOfA), boxOf(fieldsOfB)
          a.x, a.y, a.width, a.height = 0, 0, 10, 20
          b.x, b.y, b.width, b.height = 6, 5, 10, 20
          assert.equal("right", pure.bump(a, b, mode))
          assert.near(expected[1], a.x, 1e-12)
          assert.near(expected[2], b.x, 1e-12)
          assert.same({ 0, 5 }, { a.y, b.y })
        end)
      end
    end
  end)

  -- side, a, where a is in mode "first", where a and b are in mode "both"; b at 0, 0, 10 by 10
  for _, row in ipairs({
    { "right", { -8, 1, 10, 10 }, { -10, 1 }, { -9, 1 }, { 1, 0 } },
    { "left", { 8, 1, 10, 10 }, { 10, 1 }, { 9, 1 }, { -1, 0 } },
    { "bottom", { 1, -8, 10, 10 }, { 1, -10 }, { 1, -9 }, { 0, 1 } },
    { "top", { 1, 8, 10, 10 }, { 1, 10 }, { 1, 9 }, { 0, -1 } },
  }) do
    local side, start, first, bothA, bothB = row[1], row[2], row[3], row[4], row[5]
    it("opens a hit on the " .. side, function()
      local a, b = boxOf(start), box(0, 0, 10, 10)
      assert.equal(side, pure.bump(a, b, "first"))
      assert.same({ first[1], first[2], 0, 0 }, { a.x, a.y, b.x, b.y })

      a, b = boxOf(start), box(0, 0, 10, 10)
      assert.equal(side, pure.bump(a, b))
      assert.same({ bothA[1], bothA[2], bothB[1], bothB[2] }, { a.x, a.y, b.x, b.y })
    end)
  end

  it('takes "both" for granted', function()
    local a, b = box(0, 0, 10, 20), box(6, 5, 10, 20)
    pure.bump(a, b)
    assert.same({ -2, 8 }, { a.x, b.x })
  end)

  it("leaves alone what is apart, flush or flush up to rounding", function()
    for _, x in ipairs({ 30, 10, 10 - 1e-9 }) do
      local a, b = box(0, 0, 10, 10), box(x, 3, 10, 10)
      assert.is_false(pure.bump(a, b))
      assert.same({ 0, 0, x, 3 }, { a.x, a.y, b.x, b.y })
    end
  end)

  it("puts a box that stands in the floor on it to the bit", function()
    local floor = { x = -100, y = 0.7, width = 300, height = 16, static = true }
    local body = box(0.1, 0.3 - 20, 10.1, 20.9)
    assert.equal("bottom", pure.bump(body, floor))
    assert.equal(floor.y - body.height, body.y)
    assert.equal(0.1, body.x)
  end)

  it("writes nothing to what does not move", function()
    local wall = setmetatable({}, {
      __index = { x = 6, y = 5, width = 10, height = 20, static = true },
      __newindex = function()
        error("written")
      end,
    })
    local a = box(0, 0, 10, 20)
    pure.bump(a, wall)
    pure.bump(wall, a)
    assert.equal(-4, a.x)
  end)

  it("shares by mass without overflow", function()
    local a, b = box(0, 0, 10, 20), box(6, 5, 10, 20)
    a.mass, b.mass = 1e100, 1e100
    pure.bump(a, b)
    assert.same({ -2, 8 }, { a.x, b.x })

    a, b = box(0, 0, 10, 20), box(6, 5, 10, 20)
    a.mass, b.mass = 1e100, 1e-100
    pure.bump(a, b)
    assert.same({ 0, 10 }, { a.x, b.x })
  end)

  describe("in 500 random pairs at each shift", function()
    for _, shift in ipairs({ 0, 0.1, 1 / 3, -1000.1, 100000.3 }) do
      for _, mode in ipairs(fields.settingByName.push.values) do
        it(('leaves them flush, shift %g, mode "%s"'):format(shift, mode), function()
          local random = newRandom(11)
          local function randomBox()
            local x, y = random:between(-20, 20), random:between(-20, 20)
            local result = box(shift + x, shift + y, random:between(1, 30), random:between(1, 30))
            result.mass = random:between(0.1, 5)
            return result
          end
          for _ = 1, 500 do
            local a, b = randomBox(), randomBox()
            local ax, ay, bx, by = a.x, a.y, b.x, b.y
            local side = pure.bump(a, b, mode)
            assert.is_false(pure.checkCollision(a, b))
            if side then
              assert.equal(side, pure.checkCollision(a, b, true))
              if mode == "first" then
                assert.same({ bx, by }, { b.x, b.y })
              else
                assert.near(a.mass * ax + b.mass * bx, a.mass * a.x + b.mass * b.x, 1e-8)
                assert.near(a.mass * ay + b.mass * by, a.mass * a.y + b.mass * b.y, 1e-8)
              end
              local isExact = side == "right" and a.x == b.x - a.width
                or side == "bottom" and a.y == b.y - a.height
                or side == "left" and (b.x == a.x - b.width or a.x == b.x + b.width)
                or side == "top" and (b.y == a.y - b.height or a.y == b.y + b.height)
              assert.is_true(isExact)
            end
          end
        end)
      end
    end
  end)

  describeWrongBoxes("bump")

  it("refuses an object and itself", function()
    local a = box(0, 0, 1, 1)
    local expected = "physics: bump(a, b): a and b must be two objects, got the same one twice"
    refuses(expected, function()
      pure.bump(a, a)
    end)
  end)

  it("refuses an unknown mode", function()
    local expected = 'physics: bump(a, b, mode): mode must be "both" or "first", got "second"'
    refuses(expected, function()
      pure.bump(box(0, 0, 1, 1), box(9, 0, 1, 1), "second")
    end)
  end)

  for _, row in ipairs({
    { "mass", 0, "must be a number > 0, got 0" },
    { "static", 1, "must be true or false, got 1" },
    { "kinematic", "no", 'must be true or false, got "no"' },
    { "pushable", 0, "must be true or false, got 0" },
  }) do
    local name, value, expected = row[1], row[2], row[3]
    it("refuses: " .. name .. " " .. expected .. ", and moves nothing", function()
      local a, b = box(0, 0, 10, 10), box(6, 1, 10, 10)
      b[name] = value
      refuses("physics: bump(a, b): b." .. name .. " " .. expected, function()
        pure.bump(a, b)
      end)
      assert.same({ 0, 6 }, { a.x, b.x })
    end)
  end
end)
