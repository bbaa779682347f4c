--- Corner to corner: what is met, and on which side.

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local row = play.row
local solid = scene.maker("tiles", { static = true })

local function body(x, y, width, height, vx, vy)
  return scene.maker("boxes", { vx = vx, vy = vy })("body", x, y, width, height)
end

describe("onBegin and touching: corners", function()
  --        +-----+
  --    ^   |block|
  --     \  +-----+
  --      +--+
  --      |  |   leaves along the diagonal
  --      +--+
  local AWAY = { gravity = 0, solid("block", 16, 0, 32, 32), body(0, 32, 16, 16, -60, -60) }
  row("(2a) do not catch a box that moves away from them", EVERYWHERE, AWAY, {
    { "listen body", 1 / 6, "body at -10, 22; body.vx == -60; body.vy == -60; body heard 0, 0" },
  })

  --   +--+
  --   |  |  \                 a tie is vertical (so it is not turned)
  --   +--+   v
  --      +--+
  --      |  |
  --      +--+
  row("(2b) land a box that meets them exactly, block in group {group}", nil, function(v)
    local block = scene.maker(v.group, { static = true })("block", 16, 16, 16, 16)
    return { gravity = 0, block, body(0, 0, 16, 16, 600, 600) }
  end, {
    "listen body; run:step(1 / 60)",
    "body at 10, 0; body.vx ~ 600; body on block; body touches bottom; body heard 1, 0",
    "heard.body.sides.bottom == 1; heard.body.speed ~ 600",
  }, { "group", { "tiles" }, { "boxes" } })

  --   +----+
  --   |    |  both gaps are 4: met at a tenth of the step
  --   +----+
  --          +--+
  --          +--+
  local INSIDE = { gravity = 0, solid("block", 20, 20, 8, 8), body(0, 0, 16, 16, 2400, 2400) }
  row("(2c) are met at their moment inside the step", nil, INSIDE, {
    { "listen body; run:step(1 / 60)", "body at 40, 4; body.vx ~ 2400; body.vy == 0" },
    "heard.body.begins == 1; heard.body.sides.bottom == 1",
  })

  --         |  |
  --   +--+  +--+
  --   |  |  |  |       the face of one tile and the corner of the next, half a step away
  --   +--+  |  |
  --      \  +--+
  --       v |  |
  local WALL = scene.tiles({ gravity = 0 }, 10, 21, -59, 16, 16, 0, 16)
  WALL[11] = body(0, 0, 16, 16, 600, 600)
  row("of a wall are met after its face", { turn = variants.TURNS }, WALL, {
    "run:step(1 / 60); body at 5, 10; body.vx == 0; body.vy ~ 600",
  })

  --   v ->
  --   +--+
  --   |  |
  --   +--+           the top of the block is exactly at the feet
  --         +-----+
  --         |block|
  local LOW = { gravity = 0, solid("block", 40, 100, 32, 32), body(0, 76, 14, 24, 200, 0) }
  row("(2d) level with the feet do not stop a box that flies over them", EVERYWHERE, LOW, {
    "listen body",
    { 1, "body at 200 * t, 76", "body.vx == 200" },
    "body heard 0, 0",
  })

  local LEVEL = { solid("left", 0, 100, 96, 8), solid("right", 128, 100, 200, 8) }
  LEVEL[3], LEVEL[4] =
    scene.maker("blocks", { static = true })("block", 96, 100, 32, 64), body(0, 76, 14, 24, 200, 0)
  row("(2d) level with the floor do not stop a box that walks on to them", EVERYWHERE, LEVEL, {
    { 1.5, "body at 200 * t, 76", "body.vx == 200", "body touches bottom" },
  })

  --        ^
  --      +---++---+
  --      |   ||   |     a jump beside a block of the same height
  --      +---++---+
  --   +---+---+---+---+
  --   64      fractional sizes
  row("(2e) beside a jump let it come down where it began, at {o}", EVERYWHERE, function(v)
    local size, o = 16.3, v.o
    local list = scene.tiles({}, 6, -32.6, 64 + o, size, size, size, 0)
    list[3][2].name = "floor"
    list[7] = scene.maker("blocks", { static = true })("block", size + o, 47.7 + o, size, size)
    list[8] = body(o, 47.7 + o, size, size, 0, -300)
    return list
  end, {
    { 0.5, "body at o, 47.7 + o - 300 * t + 400 * t * t" },
    1.5,
    "body at o, 47.7 + o, 1e-9; body on floor; body still; body touches bottom",
  }, { "o", { 0 }, { 0.1 }, { 0.3 }, { 0.7 } })
end)
