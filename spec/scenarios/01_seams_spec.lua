--- A row of tiles behaves like one long box: floor, wall or shaft.

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local row = play.row
local thing = scene.thing("players", { name = "body", x = 0, y = 76, width = 14, height = 24 })

--- A floor of 60 tiles from x = 0 to 960, top at y = 100; with a body.
local function floorAnd(fields)
  return scene.tiles({ thing(fields) }, 60, 0, 100, 16, 16, 16, 0)
end

--- A wall of 40 tiles from y = 0 to 640, left face at x = 100; with a body.
local function wallAnd(fields)
  return scene.tiles({ thing(fields) }, 40, 100, 0, 16, 16, 0, 16)
end

describe("vx and vy: seams of a floor", function()
  --   v = 200 ->
  --   +--+
  --   |  |
  --   +--+---+---+---+---+
  --   |  |   |   |   |   |   60 tiles
  --
  -- 0 .. 414 lies on the tiles 0 to 25; the tiles 0 to 23 are left behind, the 24th (384 .. 400)
  -- ends exactly where the body begins.
  row("(1a) do not slow, lift or stop what walks over them", EVERYWHERE, floorAnd({ vx = 200 }), {
    "listen body",
    { 2, "body at 200 * t, 76", "body.vx == 200", "body.vy == 0", "body touches bottom" },
    "heard.body.begins == 26; heard.body.sides.bottom == 26",
    "heard.body.ends >= 24; heard.body.ends <= 25",
  })

  --    o        k = 1 … 100, each with its own speed
  --     \    ->
  --   +---+---+---+---+
  local LEVELS = { rate = { 60, "irregular" }, turn = { 0, 3 } }
  local MANY = floorAnd({ x = -500 })
  MANY.masks = { players = { players = false } }
  for k = 1, 100 do
    local fields = { name = "lander" .. k, x = 0.13 * k, y = 70, vx = 100 + 4 * k, k = k }
    MANY[#MANY + 1] = thing(fields)
  end
  row("(1d) take no speed from 100 that land", LEVELS, MANY, {
    1,
    function(run)
      for k = 1, 100 do
        local body = run.named["lander" .. k]
        run:same(("k = %d: vx"):format(k), body.vx, 100 + 4 * k)
        run:same(("k = %d: vy"):format(k), body.vy, 0)
        run:at(body, 0.13 * k + (100 + 4 * k), 76)
      end
    end,
  })
end)

--            +---+
--   vx = 100 |   |
--     +--+-> +---+
--     |  |   |   |   40 tiles
--     +--+   +---+
--      g     |   |
describe("vx and vy: seams of a wall", function()
  row("(1b) do not hold what slides down along them", EVERYWHERE, wallAnd({ x = 86, y = 0 }), {
    {
      1,
      keep = "body.vx = 100",
      "body at 86, 400 * t * t",
      "body.vx == 0",
      "body.vy ~ 800 * t",
      "body touches right",
    },
  })

  row("(1c) do not stop what jumps up along them, from x = {x}", EVERYWHERE, function(v)
    return wallAnd({ x = v.x, y = 500, vy = -600 })
  end, {
    "listen body",
    {
      2 / 3,
      keep = "body.vx = 200",
      "body.touching.top == false",
      "body.touching.bottom == false",
    },
    "body at 86, 500 - 600 * 2 / 3 + 400 * 4 / 9; heard.body.sides.right == heard.body.begins",
  }, { "x", { 80 }, { 79.3 }, { 70 } })
end)

--   +---+  +---+
--   |   |  |   |
--   +---++-++---+
--   |   || ||   |     the shaft is exactly as wide as the body
--   +---++-++---+
describe("vx and vy: seams of a shaft", function()
  local function shaftAnd(fields, top)
    fields.x = 100
    local list = scene.tiles({ thing(fields) }, 50, 84, top, 16, 16, 0, 16)
    return scene.tiles(list, 50, 100 + list[1][2].width, top, 16, 16, 0, 16)
  end

  -- pressed against a side of it, or not
  row("(1e) do not brake what falls through it, at vx = {vx}", EVERYWHERE, shaftAnd({ y = 0 }, 0), {
    { 1, keep = "body.vx = vx", "body at 100, 400 * t * t", "body.vx == 0", "body.vy ~ 800 * t" },
  }, { "vx", { 0 }, { -100 } })

  local BOX = shaftAnd({ y = 20, width = 16, height = 16 }, 100)
  row("let a 16 px box into a 16 px shaft", EVERYWHERE, BOX, {
    "listen body",
    { 1, "body at 100, 20 + 400 * t * t" },
    "body heard 0, 0",
  })

  --   +---+---+---+---+---+
  --      v ->  the ceiling of a tunnel that begins here
  --   +-+    +---+---+---+
  --   +-+      exactly as high as the body
  --   +---+---+---+---+---+
  local TUNNEL = floorAnd({ y = 84, width = 16, height = 16, vx = 150 })
  scene.tiles(TUNNEL, 20, 64, 68, 16, 16, 16, 0)
  row("let a 16 px box into a 16 px tunnel", EVERYWHERE, TUNNEL, {
    { 2, "body at 150 * t, 84", "body.vx == 150", "body touches bottom" },
  })
end)
