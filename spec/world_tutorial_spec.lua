--- The tutorial's functions: physics.inside, side, checkCollision and bump, and the tutorial,
--- followed line by line: global names, grouped tables, a loop.
-- luacheck: globals objects physics_load physics_update

local fresh = require("spec.support.fresh")
local newRandom = require("spec.support.random").new
local physics = require("physics")
local small = require("spec.support.small")

local GLOBALS = { "objects", "physics_load", "physics_update", "checkCollision", "inside", "bump" }
local DT = 1 / 60

-- A global that a spec assigns would be busted's own, one that it reads is real.
local globals = _G

local function forgetGlobals()
  for _, name in ipairs(GLOBALS) do
    rawset(_G, name, nil)
  end
end

local NAN, INF = 0 / 0, 1 / 0
local box, refuses = small.put, small.refuses

local function boxOf(row)
  return box(row[1], row[2], row[3], row[4])
end

-- (Other wrong values are in debugging_bad_input_spec.)
small.rows("{1} refuses a or b if no box", { "side", "checkCollision", "bump" }, function(name)
  local fine = box(0, 0, 1, 1)
  for _, row in ipairs({
    { "box", ' must be a table, got "box"' },
    { { x = "0", y = 0, width = 1, height = 1 }, '.x must be a number, got "0"' },
    { box(0, INF, 1, 1), ".y must be a finite number, got inf" },
    { box(0, 0, 0, 1), ".width must be a number > 0, got 0" },
    { box(0, 0, 1, NAN), ".height must be a number > 0, got nan" },
  }) do
    refuses(name .. "(a, b): a" .. row[2], physics[name], row[1], fine)
    refuses(name .. "(a, b): b" .. row[2], physics[name], fine, row[1])
  end
end)

--  0       10
--  +-------+   the left and the top edge belong to the rectangle,
--  |#######.   the right and the bottom edge do not
--  |#######.
--  +.......+   10
small.rows("inside is {3} for a rectangle {1}", {
  { "in the middle", { 4, 4, 2, 2 }, true },
  { "in the top left corner", { 0, 0, 2, 2 }, true },
  { "a point on the left edge", { 0, 5, 0, 0 }, true },
  { "a point on the top edge", { 5, 0, 0, 0 }, true },
  { "a point on the right edge", { 10, 5, 0, 0 }, false },
  { "a point on the bottom edge", { 5, 10, 0, 0 }, false },
  { "at the right edge", { 8, 4, 2, 2 }, false },
  { "at the bottom edge", { 4, 8, 2, 2 }, false },
  { "half to the left", { -1, 4, 2, 2 }, false },
  { "half above", { 4, -1, 2, 2 }, false },
  { "larger", { -1, -1, 12, 12 }, false },
}, function(_, a, expected)
  assert.equal(expected, physics.inside(a[1], a[2], a[3], a[4], 0, 0, 10, 10))
end)

--            +--+                  Where the size of the intersection (the first method of
--            |a |                  the tutorial) or the distance of the middles (the second)
--   +--------|--|---------------+  names the wrong axis, opposite sides name the right one.
--   |        +--+           b   |
--   +---------------------------+
small.rows("side is {4} for {1}", {
  -- middles: 90 px apart on x, 11 on y
  { "a medium box on the end of a thin one", { 0, -19, 20, 20 }, { 0, 0, 200, 4 }, "bottom" },
  { "the same one on the other end", { 180, -19, 20, 20 }, { 0, 0, 200, 4 }, "bottom" },
  { "the same one under it", { 180, 3, 20, 20 }, { 0, 0, 200, 4 }, "top" },
  { "one that has come out below", { 0, -15, 20, 20 }, { 0, 0, 200, 4 }, "bottom" },
  { "the wide one under it", { 0, 0, 200, 4 }, { 0, -19, 20, 20 }, "top" },
  { "a medium box at the end of a thin wall", { -19, 0, 20, 20 }, { 0, 0, 4, 200 }, "right" },
  -- intersection: 4 wide, 6 high
  { "a wide box deep on a post", { 0, 0, 100, 20 }, { 40, 14, 4, 60 }, "bottom" },
  { "a high box deep in a ledge", { 0, 0, 20, 100 }, { 14, 40, 60, 4 }, "right" },
  -- intersection: 100 wide, 4 high; middles: 0 px apart on both
  { "a cross", { 0, 48, 100, 4 }, { 48, 0, 4, 100 }, "bottom" },
  { "boxes that are apart", { 0, 0, 10, 10 }, { 50, 0, 10, 10 }, "right" },
  { "a box from the left", { -8, 1, 10, 10 }, { 0, 0, 10, 10 }, "right" },
  { "a box from the right", { 8, 1, 10, 10 }, { 0, 0, 10, 10 }, "left" },
  { "a box from above", { 1, -8, 10, 10 }, { 0, 0, 10, 10 }, "bottom" },
  { "a box from below", { 1, 8, 10, 10 }, { 0, 0, 10, 10 }, "top" },
  -- Equal ways out: right must be smaller than all to win, left smaller than top and bottom, …
  { "a tie of right and bottom", { -8, -8, 10, 10 }, { 0, 0, 10, 10 }, "bottom" },
  { "a tie of right and top", { -8, 8, 10, 10 }, { 0, 0, 10, 10 }, "top" },
  { "a tie of left and bottom", { 8, -8, 10, 10 }, { 0, 0, 10, 10 }, "bottom" },
  { "a tie of left and top", { 8, 8, 10, 10 }, { 0, 0, 10, 10 }, "top" },
  { "a tie of right and left", { 0, 2, 10, 100 }, { 0, 0, 10, 10 }, "top" },
  { "right and left, smallest of all", { 4, -20, 2, 50 }, { 0, 0, 10, 10 }, "left" },
  { "a tie of bottom and top", { -20, 4, 50, 2 }, { 0, 0, 10, 10 }, "bottom" },
  { "the same place", { 0, 0, 10, 10 }, { 0, 0, 10, 10 }, "bottom" },
}, function(_, a, b, expected)
  assert.equal(expected, physics.side(boxOf(a), boxOf(b)))
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
    local title = ("is %s for %s, %s beside"):format(tostring(plain), name, tostring(sideBySide))
    it(title, function()
      local function numbers(...)
        return physics.checkCollision(a[1], a[2], a[3], a[4], b[1], b[2], b[3], b[4], ...)
      end
      assert.equal(plain, physics.checkCollision(boxOf(a), boxOf(b)))
      assert.equal(plain, physics.checkCollision(boxOf(a), boxOf(b), false))
      assert.equal(sideBySide, physics.checkCollision(boxOf(a), boxOf(b), true))
      assert.equal(plain, numbers())
      assert.equal(sideBySide, numbers(true))
    end)
  end

  it("does as the default world, if the call does not say", function()
    local a, b = box(0, 0, 10, 10), box(10, 3, 10, 10)
    for _, setting in ipairs({ true, false }) do
      physics.load({ sideBySide = setting })
      local expected = setting and "right"
      assert.equal(expected, physics.checkCollision(a, b))
      assert.equal(expected, physics.checkCollision(0, 0, 10, 10, 10, 3, 10, 10))
      assert.equal("right", physics.checkCollision(a, b, true))
      assert.is_false(physics.checkCollision(a, b, false))
      assert.is_false(physics.checkCollision(0, 0, 10, 10, 10, 3, 10, 10, false))
    end
    physics.load()
    assert.same({ box(0, 0, 10, 10), box(10, 3, 10, 10) }, { a, b })
  end)
end)

describe("bump", function()
  local STATIC, KINEMATIC, HELD = { static = true }, { kinematic = true }, { pushable = false }

  --   0       10                 a is hit on its right, 4 px deep
  --   +-------+
  --   | a +---|---+ b      both:   a x = -2, b x = 8
  --   +---|---+   |        first:  a x = -4
  --       +-------+
  --       6       16
  -- name, fields of a, fields of b, x of a and b in mode "both", x of a and b in mode "first"
  small.rows("moves {1}", {
    { "plain boxes", {}, {}, { -2, 8 }, { -4, 6 } },
    { "a lighter one further", { mass = 1 }, { mass = 3 }, { -3, 7 }, { -4, 6 } },
    { "a heavier one less", { mass = 4 }, {}, { -0.8, 9.2 }, { -4, 6 } },
    { "huge masses without overflow", { mass = 1e100 }, { mass = 1e100 }, { -2, 8 }, { -4, 6 } },
    { "all of a feather", { mass = 1e100 }, { mass = 1e-100 }, { 0, 10 }, { -4, 6 } },
    { "all of a, where b is static", {}, STATIC, { -4, 6 }, { -4, 6 } },
    { "all of b, where a is static", STATIC, {}, { 0, 10 }, { 0, 10 } },
    { "all of a, where b is kinematic", {}, KINEMATIC, { -4, 6 }, { -4, 6 } },
    { "all of b, where a is kinematic", KINEMATIC, {}, { 0, 10 }, { 0, 10 } },
    { "all of a, where b is not pushable", {}, HELD, { -4, 6 }, { -4, 6 } },
    { "all of b, where a is not pushable", HELD, {}, { 0, 10 }, { 0, 10 } },
    { "what is not pushable out of a wall", HELD, STATIC, { -4, 6 }, { -4, 6 } },
    { "two that are not pushable", HELD, HELD, { -2, 8 }, { -4, 6 } },
    { "nothing, where both are static", STATIC, STATIC, { 0, 6 }, { 0, 6 } },
    { "nothing, where neither can give way", KINEMATIC, STATIC, { 0, 6 }, { 0, 6 } },
  }, function(_, its, other, both, first)
    for mode, expected in pairs({ both = both, first = first }) do
      local a, b = box(0, 0, 10, 20, its), box(6, 5, 10, 20, other)
      assert.equal("right", physics.bump(a, b, mode))
      assert.near(expected[1], a.x, 1e-12)
      assert.near(expected[2], b.x, 1e-12)
      assert.same({ 0, 5 }, { a.y, b.y })
    end
  end)

  -- side, a, where a is in mode "first", where a and b are in mode "both"; b at 0, 0, 10 by 10
  small.rows('opens a hit on the {1}; "both" is taken for granted', {
    { "right", { -8, 1, 10, 10 }, { -10, 1 }, { -9, 1 }, { 1, 0 } },
    { "left", { 8, 1, 10, 10 }, { 10, 1 }, { 9, 1 }, { -1, 0 } },
    { "bottom", { 1, -8, 10, 10 }, { 1, -10 }, { 1, -9 }, { 0, 1 } },
    { "top", { 1, 8, 10, 10 }, { 1, 10 }, { 1, 9 }, { 0, -1 } },
  }, function(side, at, first, a2, b2)
    local a, b = boxOf(at), box(0, 0, 10, 10)
    assert.equal(side, physics.bump(a, b, "first"))
    assert.same({ first[1], first[2], 0, 0 }, { a.x, a.y, b.x, b.y })
    a, b = boxOf(at), box(0, 0, 10, 10)
    assert.equal(side, physics.bump(a, b))
    assert.same({ a2[1], a2[2], b2[1], b2[2] }, { a.x, a.y, b.x, b.y })
  end)

  small.rows("leaves alone what is apart or flush, {1}", { 30, 10, 10 - 1e-9 }, function(x)
    local a, b = box(0, 0, 10, 10), box(x, 3, 10, 10)
    assert.is_false(physics.bump(a, b))
    assert.same({ 0, 0, x, 3 }, { a.x, a.y, b.x, b.y })
  end)

  small.rows("leaves 500 pairs flush: {1}", { 0, 0.1, 1 / 3, -1000.1, 100000.3 }, function(shift)
    local random = newRandom(11)
    local function randomBox()
      local x, y = random:between(-20, 20), random:between(-20, 20)
      local result = box(shift + x, shift + y, random:between(1, 30), random:between(1, 30))
      result.mass = random:between(0.1, 5)
      return result
    end
    for n = 1, 1000 do
      local mode = n % 2 == 0 and "both" or "first"
      local a, b = randomBox(), randomBox()
      local ax, ay, bx, by = a.x, a.y, b.x, b.y
      local side = physics.bump(a, b, mode)
      assert.is_false(physics.checkCollision(a, b))
      if side then
        assert.equal(side, physics.checkCollision(a, b, true))
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

  it("refuses an object and itself, and an unknown mode", function()
    local a = box(0, 0, 1, 1)
    refuses("bump(a, b): a and b must be two objects, got the same one twice", physics.bump, a, a)
    local expected = 'bump(a, b, mode): mode must be "both" or "first", got "second"'
    refuses(expected, physics.bump, a, box(9, 0, 1, 1), "second")
  end)

  small.rows("refuses: {1} {3}, and moves nothing", {
    { "mass", 0, "must be a number > 0, got 0" },
    { "static", 1, "must be true or false, got 1" },
    { "kinematic", "no", 'must be true or false, got "no"' },
    { "pushable", 0, "must be true or false, got 0" },
  }, function(name, value, words)
    local a, b = box(0, 0, 10, 10), box(6, 1, 10, 10)
    b[name] = value
    refuses("bump(a, b): b." .. name .. " " .. words, physics.bump, a, b)
    assert.same({ 0, 6 }, { a.x, b.x })
  end)
end)

it("globals sets no global, until it is asked to", function()
  local before = {}
  for name in pairs(_G) do
    before[name] = true
  end
  fresh.during(function(again)
    again.load({ gravity = 0 })
    again.add("boxes", { x = 0, y = 0, width = 1, height = 1 })
    again.update(DT)
  end)
  for name in pairs(_G) do
    assert.is_true(before[name], tostring(name))
  end
  for _, name in ipairs(GLOBALS) do
    assert.is_nil(rawget(_G, name))
  end
end)

describe("globals: the tutorial", function()
  before_each(function()
    physics.load()
    physics.globals()
  end)

  after_each(function()
    forgetGlobals()
    physics.load()
  end)

  it("loads, and updates a table of groups that the game assigns", function()
    globals.objects = {
      players = { { x = 40, y = 40, width = 24, height = 32 } },
      tiles = { { x = 0, y = 560, width = 800, height = 40, static = true } },
    }
    physics_load({ gravity = 800 })
    for _ = 1, 120 do
      physics_update(DT)
    end
    assert.equal(528, objects.players[1].y)
    assert.equal(objects.tiles[1], objects.players[1].touching.bottom)
    assert.equal(objects, physics.objects)
  end)

  it("reads the global anew at every update", function()
    physics_load({ gravity = 0 })
    globals.objects = { boxes = { { x = 0, y = 0, width = 8, height = 8, vx = 60 } } }
    physics_update(DT)
    local first = objects.boxes[1]
    assert.near(1, first.x, 1e-12)
    globals.objects = { boxes = { { x = 100, y = 0, width = 8, height = 8, vx = 60 } } }
    physics_update(DT)
    assert.near(1, first.x, 1e-12)
    assert.near(101, objects.boxes[1].x, 1e-12)
  end)

  it("may put all objects into one table, without groups", function()
    physics_load({ gravity = 800 })
    globals.objects = {
      { x = 0, y = 0, width = 16, height = 16 },
      { x = -50, y = 100, width = 200, height = 16, static = true },
      player = { x = 40, y = 0, width = 16, height = 16 },
    }
    for _ = 1, 60 do
      physics_update(DT)
    end
    assert.same({ 84, 84 }, { objects[1].y, objects.player.y })
  end)

  it("may start with no table at all", function()
    rawset(_G, "objects", nil)
    physics_load()
    objects.boxes = { { x = 0, y = 0, width = 16, height = 16 } }
    physics_update(DT)
    assert.is_true(objects.boxes[1].y > 0)
  end)
end)
