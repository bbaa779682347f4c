--- Scalar rectangle maths. Rows are: name, first rectangle, second rectangle, what comes out.

local aabb = require("physics.space.aabb")
local newRandom = require("spec.support.random").new

local OPPOSITE = { top = "bottom", left = "right", bottom = "top", right = "left" }

--- The eight numbers of two rectangles.
local function numbers(a, b)
  return a[1], a[2], a[3], a[4], b[1], b[2], b[3], b[4]
end

describe("aabb", function()
  --  0   5   10  15
  --  +-------+
  --  |   +---|---+   5
  --  |   |###|   |
  --  +---|---+   |   10
  --      +-------+   15
  describe(".overlap", function()
    for _, row in ipairs({
      { "of a corner", { 0, 0, 10, 10 }, { 5, 6, 10, 10 }, 5, 4 },
      { "of the other corner", { 5, 6, 10, 10 }, { 0, 0, 10, 10 }, 5, 4 },
      { "of a small one inside", { 0, 0, 10, 10 }, { 3, 4, 2, 1 }, 2, 1 },
      { "of two that cross", { 0, 4, 10, 2 }, { 4, 0, 2, 10 }, 2, 2 },
      { "of equal ones", { 1, 2, 3, 4 }, { 1, 2, 3, 4 }, 3, 4 },
      { "is 0 for flush sides", { 0, 0, 10, 10 }, { 10, 2, 5, 5 }, 0, 5 },
      { "is 0, 0 for flush corners", { 0, 0, 10, 10 }, { 10, 10, 5, 5 }, 0, 0 },
      { "is the gap, negative", { 0, 0, 10, 10 }, { 13, -7, 5, 5 }, -3, -2 },
    }) do
      local name, a, b, width, height = row[1], row[2], row[3], row[4], row[5]
      it(name, function()
        assert.same({ width, height }, { aabb.overlap(numbers(a, b)) })
      end)
    end
  end)

  --  +-------+
  --  |#######.      # inside
  --  |#######.      . not any more
  --  |########      left and top edges belong to the rectangle,
  --  +.......+      right and bottom edges do not
  describe(".inside", function()
    for _, row in ipairs({
      { "holds for the middle", { 4, 4, 2, 2 }, true },
      { "holds for the top left corner", { 0, 0, 2, 2 }, true },
      { "holds for a point on the left edge", { 0, 5, 0, 0 }, true },
      { "holds for a point on the top edge", { 5, 0, 0, 0 }, true },
      { "fails for a point on the right edge", { 10, 5, 0, 0 }, false },
      { "fails for a point on the bottom edge", { 5, 10, 0, 0 }, false },
      { "fails when the right edges meet", { 8, 4, 2, 2 }, false },
      { "fails when the bottom edges meet", { 4, 8, 2, 2 }, false },
      { "fails to the left", { -1, 4, 2, 2 }, false },
      { "fails above", { 4, -1, 2, 2 }, false },
      { "fails for what is larger", { -1, -1, 12, 12 }, false },
    }) do
      local name, a, expected = row[1], row[2], row[3]
      it(name, function()
        assert.equal(expected, aabb.inside(numbers(a, { 0, 0, 10, 10 })))
      end)
    end
  end)

  --        0   4      10 12      20
  --     0  +-----------+
  --     3  |   +-------|---------+
  --        |   |       |         |      right  = 10 -  4 =  6
  --     9  +-----------+         |      left   = 20 -  0 = 20
  --        |   |                 |      bottom =  9 -  3 =  6
  --    13      +-----------------+      top    = 13 -  0 = 13
  describe(".exits", function()
    it("are the distances between opposite sides", function()
      assert.same({ 6, 20, 6, 13 }, { aabb.exits(0, 0, 10, 9, 4, 3, 16, 10) })
    end)

    it("are negative where the first has left already", function()
      assert.same({ -5, 25, 10, 10 }, { aabb.exits(0, 0, 10, 10, 15, 0, 10, 10) })
    end)

    it("swap when the rectangles do", function()
      local right, left, bottom, top = aabb.exits(0, 0, 10, 9, 4, 3, 16, 10)
      assert.same({ left, right, top, bottom }, { aabb.exits(4, 3, 16, 10, 0, 0, 10, 9) })
    end)
  end)

  describe(".side", function()
    -- the second one lies at 0, 0 and is 10 by 10
    for _, row in ipairs({
      { "right: the first comes from the left", { -8, 1, 10, 10 }, "right" },
      { "left: the first comes from the right", { 8, 1, 10, 10 }, "left" },
      { "bottom: the first comes from above", { 1, -8, 10, 10 }, "bottom" },
      { "top: the first comes from below", { 1, 8, 10, 10 }, "top" },
    }) do
      local name, a, expected = row[1], row[2], row[3]
      it("is the " .. name, function()
        assert.equal(expected, aabb.side(numbers(a, { 0, 0, 10, 10 })))
      end)
    end

    --            +--+                  Where the size of the intersection (the first method of
    --            |a |                  the tutorial) or the distance of the middles (the second)
    --   +--------|--|---------------+  names the wrong axis, opposite sides name the right one.
    --   |        +--+           b   |
    --   +---------------------------+
    for _, row in ipairs({
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
    }) do
      local name, a, b, expected = row[1], row[2], row[3], row[4]
      it("is the " .. expected .. " of " .. name, function()
        assert.equal(expected, aabb.side(numbers(a, b)))
      end)
    end

    -- Equal exits: right must be smaller than all to win, left smaller than top and bottom, ...
    for _, row in ipairs({
      { "right = bottom", { -8, -8, 10, 10 }, "bottom" },
      { "right = top", { -8, 8, 10, 10 }, "top" },
      { "left = bottom", { 8, -8, 10, 10 }, "bottom" },
      { "left = top", { 8, 8, 10, 10 }, "top" },
      { "right = left", { 0, 2, 10, 100 }, "top" },
      { "right = left, smallest of all", { 4, -20, 2, 50 }, "left" },
      { "bottom = top", { -20, 4, 50, 2 }, "bottom" },
      { "all four, the same place", { 0, 0, 10, 10 }, "bottom" },
    }) do
      local name, a, expected = row[1], row[2], row[3]
      it("is the " .. expected .. " in the tie " .. name, function()
        assert.equal(expected, aabb.side(numbers(a, { 0, 0, 10, 10 })))
      end)
    end
  end)

  describe("in 2000 random pairs", function()
    local random = newRandom(7)

    local function box()
      local x, y = random:between(-50, 50), random:between(-50, 50)
      return { x, y, random:between(1, 60), random:between(1, 60) }
    end

    local pairsOfBoxes = {}
    for i = 1, 2000 do
      pairsOfBoxes[i] = { box(), box() }
    end

    it("rectangles overlap exactly where all four exits are open", function()
      for _, pair in ipairs(pairsOfBoxes) do
        local width, height = aabb.overlap(numbers(pair[1], pair[2]))
        local right, left, bottom, top = aabb.exits(numbers(pair[1], pair[2]))
        assert.equal(width > 0 and height > 0, right > 0 and left > 0 and bottom > 0 and top > 0)
      end
    end)

    it("the side of one is the opposite side of the other", function()
      for _, pair in ipairs(pairsOfBoxes) do
        local side = aabb.side(numbers(pair[1], pair[2]))
        assert.equal(OPPOSITE[side], aabb.side(numbers(pair[2], pair[1])))
      end
    end)
  end)
end)
