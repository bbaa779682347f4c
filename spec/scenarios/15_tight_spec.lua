--- Room that fits exactly is room enough.

local overlap = require("spec.support.overlap")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local FEW = { rate = { 60, 144 }, turn = { 0, 3 }, shift = { 0, 0.1 } }
local solid, box = scene.maker("tiles", { static = true }), scene.maker("boxes", {})
local row = play.with({ checker = overlap.checker })

describe("width: a slot exactly as wide as its boxes", function()
  --   |    +--+    |
  --   |    +--+    |      the last one falls between the others
  --   |+--+    +--+|
  --   |+--+    +--+|
  --   +------------+
  local function slot(v)
    local inner = v.size * #v.columns
    local list = { solid("floor", -50, 0, inner + 100, 16), solid("left", -50, -400, 50, 400) }
    list[3] = solid("right", inner, -400, 50, 400)
    for i, column in ipairs(v.columns) do
      local fields = { friction = v.friction }
      list[i + 3] = box("box" .. column, v.size * (column - 1), -60 * i, v.size, 16, fields)
    end
    return list
  end
  -- boxes, width of each, the order in which they come (columns)
  for title, values in pairs({
    ["3 boxes, middle last"] = { 16, { 1, 3, 2 } },
    ["4 boxes, from the left"] = { 16, { 1, 2, 3, 4 } },
    ["5 boxes, gaps last"] = { 16, { 1, 3, 5, 2, 4 } },
    ["4 boxes of a fractional width"] = { 16.3, { 4, 1, 3, 2 } },
    ["7 boxes of 10/3 px"] = { 10 / 3, { 7, 1, 3, 5, 2, 6, 4 } },
  }) do
    row("fills: " .. title .. ", friction {friction}", FEW, slot, {
      "deepest = checker(run.all)",
      { 2.5, "deepest() <= 1e-6" },
      function(run, it)
        for column = 1, #it.columns do
          local view = it["box" .. column]
          run:at(view, it.size * (column - 1), -16)
          run:standsOn(view, it.floor)
          run:still(view)
        end
      end,
    }, {
      "size, columns, friction, levels",
      { values[1], values[2], 0 },
      { values[1], values[2], 0.5, EVERYWHERE },
    })
  end

  --   +-------------------+
  --   +-------------------+
  --  -> +-+ +-+ +-+       |   pushed into a tunnel as high as they are
  --   --------------------+
  local TUNNEL = { solid("low", -200, 100, 400, 16), solid("high", 64, 68, 64, 16) }
  TUNNEL[3], TUNNEL[4] = solid("wall", 128, 68, 16, 32), box("P", -80, 84, 16, 16)
  for i = 1, 4 do
    TUNNEL[i + 4] = box("box" .. i, -60 + 22 * i, 84, 16, 16)
  end
  row("lies down as well: boxes pushed into a tunnel fill it", EVERYWHERE, TUNNEL, {
    { 5, keep = "P.vx = 100" },
    "P at 48, 84; box1 at 64, 84; box2 at 80, 84; box3 at 96, 84; box4 at 112, 84; P still",
  })
end)

describe("width: a platform between two walls", function()
  --   ||      ||
  --   |+------+|
  --   |+------+|   as wide as the shaft that it falls through
  local SHAFT = { solid("left", -16, 0, 16, 500), solid("right", 100, 0, 16, 500) }
  SHAFT[3], SHAFT[4] = solid("floor", -16, 500, 132, 16), box("low", 0, 400, 100, 8)
  SHAFT[5] = box("high", 0, 300, 100, 8)
  row("falls freely on to what lies below", EVERYWHERE, SHAFT, {
    1,
    "low at 0, 492; high at 0, 484; low on floor; high on low; low still; high still",
  })

  --   |+---+ |
  --   ||  +|-|   side by side they are wider than the shaft
  --   |+--+--|
  local CLOSE = { SHAFT[1], solid("right", 28, 0, 16, 500), box("small", 12, 20, 12, 9) }
  CLOSE[4] = box("big", 0, 8, 20, 22)
  row("and one beside it for which there is no room stay out of its walls", EVERYWHERE, CLOSE, {
    { 0.5, "big.x >= -1e-6", "big.x <= 8 + 1e-6", "small.x >= -1e-6", "small.x <= 16 + 1e-6" },
  })
end)
