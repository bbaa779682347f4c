--- Room that fits exactly is room enough.

local overlap = require("spec.support.overlap")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local FEW = { rate = { 60, 144 }, turn = { 0, 3 }, shift = { 0, 0.1 } }

describe("width: a slot exactly as wide as its boxes", function()
  --   |    +--+    |
  --   |    +--+    |      the last one falls between the others
  --   |+--+    +--+|
  --   |+--+    +--+|
  --   +------------+
  for _, row in ipairs({
    -- boxes, width of each, the order in which they come (columns)
    { "3 boxes, middle last", 16, { 1, 3, 2 } },
    { "4 boxes, from the left", 16, { 1, 2, 3, 4 } },
    { "5 boxes, gaps last", 16, { 1, 3, 5, 2, 4 } },
    { "4 boxes of a fractional width", 16.3, { 4, 1, 3, 2 } },
    { "7 boxes of 10/3 px", 10 / 3, { 7, 1, 3, 5, 2, 6, 4 } },
  }) do
    local size, columns = row[2], row[3]

    local function slot(friction)
      local inner = size * #columns
      local description = {
        { "tiles", { name = "floor", x = -50, y = 0, width = inner + 100, height = 16 } },
        { "tiles", { x = -50, y = -400, width = 50, height = 400 } },
        { "tiles", { x = inner, y = -400, width = 50, height = 400 } },
      }
      for i = 1, 3 do
        description[i][2].static = true
      end
      for i, column in ipairs(columns) do
        local box = { name = "box" .. column, x = size * (column - 1), y = -60 * i }
        box.width, box.height, box.friction = size, 16, friction
        description[#description + 1] = { "boxes", box }
      end
      return description
    end

    it("fills: " .. row[1], function()
      for friction, levels in pairs({ [0] = FEW, [0.5] = EVERYWHERE }) do
        scene.each(levels, function(run)
          local named = run:build(slot(friction))
          local deepest = overlap.checker(run.all)
          for _ in run:steps(2.5) do
            local depth = deepest()
            run:check(depth <= 1e-6, "overlap of %.3g", depth)
          end
          for column = 1, #columns do
            local box = named["box" .. column]
            run:at(box, size * (column - 1), -16)
            run:flush(box, named.floor, "bottom")
            run:still(box)
          end
        end)
      end
    end)
  end

  --   +-------------------+
  --   +-------------------+
  --  -> +-+ +-+ +-+       |   pushed into a tunnel as high as they are
  --   --------------------+
  scene.it("lies down as well: boxes pushed into a tunnel fill it", EVERYWHERE, function(run)
    local description = {
      { "tiles", { x = -200, y = 100, width = 400, height = 16, static = true } },
      { "tiles", { x = 64, y = 68, width = 64, height = 16, static = true } },
      { "tiles", { name = "wall", x = 128, y = 68, width = 16, height = 32, static = true } },
      { "players", { name = "P", x = -80, y = 84, width = 16, height = 16 } },
    }
    for i = 1, 4 do
      local box = { name = "box" .. i, x = -60 + 22 * i, y = 84, width = 16, height = 16 }
      description[#description + 1] = { "boxes", box }
    end
    local named = run:build(description)
    run:play(5, run:keep(named.P, 100))
    for i = 1, 4 do
      run:at(named["box" .. i], 48 + 16 * i, 84)
    end
    run:at(named.P, 48, 84)
    run:flush(named.box4, named.wall, "right")
    run:still(named.P)
  end)
end)

describe("width: a platform between two walls", function()
  --   ||      ||
  --   |+------+|
  --   |+------+|   as wide as the shaft that it falls through
  scene.it("falls freely on to what lies below", EVERYWHERE, function(run)
    local named = run:build({
      { "tiles", { x = -16, y = 0, width = 16, height = 500, static = true } },
      { "tiles", { x = 100, y = 0, width = 16, height = 500, static = true } },
      { "tiles", { name = "floor", x = -16, y = 500, width = 132, height = 16, static = true } },
      { "boxes", { name = "low", x = 0, y = 400, width = 100, height = 8 } },
      { "boxes", { name = "high", x = 0, y = 300, width = 100, height = 8 } },
    })
    run:play(1)
    run:at(named.low, 0, 492)
    run:at(named.high, 0, 484)
    run:flush(named.low, named.floor, "bottom")
    run:flush(named.high, named.low, "bottom")
    run:still(named.low)
    run:still(named.high)
  end)
end)
