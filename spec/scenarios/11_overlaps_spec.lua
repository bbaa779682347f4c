--- What begins inside something else leaves by the smallest way that is free.

local overlap = require("spec.support.overlap")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local GROWN = { shift = { 0, 1 / 3, 100000.3 }, rate = { 60, 30, 144 }, turn = variants.TURNS }
GROWN.order = variants.ORDERS
local EVERYWHERE = variants.EVERYWHERE
local row = play.with({ checker = overlap.checker })
local tile, movable = scene.maker("tiles", { static = true }), scene.maker("boxes", {})

local function solid(x, y, width, height)
  return tile(nil, x, y, width, height)
end

describe("x and y: a body inside a floor of tiles", function()
  --      +--+
  --   +--|  |---+---+
  --   |  +--+   |   |
  --   +---+---+---+---+
  row("(11) {width} wide, {depth} px deep, comes up on it", EVERYWHERE, function(v)
    return scene.tiles(
      { movable("body", v.x, 76 + v.depth, v.width, 24) },
      20,
      0,
      100,
      16,
      16,
      16,
      0
    )
  end, {
    { 1, "body.x ~ x", "body.y >= 76 - 1e-6" },
    "body at x, 76; body still; body touches bottom",
  }, {
    "width, depth, x",
    { 14, 4, 50 }, -- on one tile
    { 14, 12, 50 },
    { 16, 4, 50 }, -- over a seam: 14 px on one tile, 2 px on the next
    { 16, 12, 50 },
    { 24, 12, 44.5 },
  })
end)

describe("x and y: a body inside a block leaves by the smallest way that is free:", function()
  -- exact only where it stands, and not the same when turned
  local HERE = { shift = { 0 } }
  local BLOCK, BAR = { solid(0, 0, 10, 10) }, { solid(5, 23, 28, 7) }

  --  +------+------+
  --  |      |      |
  --  |   +--+--+   |   12 px deep in both; the ways to the right (10 px, out of the first) and
  --  +---|  |  |---+   to the left (6 px, out of the second) end in the other one
  --      +-----+
  local TWO = { solid(0, 0, 40, 100), solid(40, 0, 40, 100) }
  --   |      | |#|     1 px deep in the floor and in the wall: neither way leads out alone
  --   |     +--+#|
  --   +-----|--+--+
  local CORNER = { solid(0, 96, 320, 16), solid(160, 0, 16, 96) }
  --  #####|   +--+##   The way down, out of the second, ends in a third one below the first:
  --  #####|   |##|##   it must go to the right before it goes down.
  --  #####+---|--+
  --  ########|+--+
  local THREE = { solid(-97, -50, 100, 60.5), solid(9, -50, 100, 52), solid(-97, 10.5, 99, 50) }
  local FORWARD = { order = { "forward" } }

  row("{what}", nil, function(v)
    return {
      gravity = 0,
      movable("box", v.x, v.y, v.width, v.height),
      v.there[1],
      v.there[2],
      v.there[3],
    }
  end, {
    "run:step(1 / 60); box at toX, toY; box still",
    { 1 / 6, "box at toX, toY", "box still" },
  }, {
    -- where; x, y, width, height before; x, y after a step
    "what, levels, there, x, y, width, height, toX, toY",
    { "(11) the near side", EVERYWHERE, { solid(0, 0, 100, 100) }, 90, 40, 16, 16, 100, 40 },
    { "not into another block", EVERYWHERE, TWO, 30, 88, 16, 16, 30, 100 },
    { "in a corner one after the other", EVERYWHERE, CORNER, 147, 73, 14, 24, 146, 72 },
    { "the first one first, where only that is free", FORWARD, THREE, 0, 0, 10, 10, 3, 2 },
    -- across a bar: out of its end, not through it
    { "flush with the end of a bar", {}, BAR, 5, 17, 7, 28, -2, 17 },
    { "1 px from the end of a bar", {}, BAR, 6, 17, 7, 28, 6, 30 },
    -- of equally short ways: bottom before top before left before right
    { "right and bottom alike", HERE, BLOCK, -8, -8, 10, 10, -8, -10 },
    { "right and top alike", HERE, BLOCK, -8, 8, 10, 10, -8, 10 },
    { "left and bottom alike", HERE, BLOCK, 8, -8, 10, 10, 8, -10 },
    { "left and top alike", HERE, BLOCK, 8, 8, 10, 10, 8, 10 },
    { "top and bottom alike", HERE, BLOCK, 4, -20, 2, 50, 4, -50 },
    { "left and right alike", HERE, BLOCK, -20, 4, 50, 2, 10, 4 },
    { "all alike", HERE, BLOCK, 4, 4, 2, 2, 4, -2 },
    { "all alike, on the very same spot", HERE, BLOCK, 0, 0, 10, 10, 0, -10 },
  })

  --   +-----------+
  --   |   +--+    |   vx = -60
  --   |   +--+    |   ways out: left 36, top and bottom 40, right 44
  --   +-----------+
  local FAR = { gravity = 0, solid(0, 0, 64, 64), movable("box", 20, 24, 16, 16) }
  row("(11) or stays, where that is far", EVERYWHERE, FAR, {
    "box.vx = -60",
    { 0.5, "min(abs(box.x - 20) - 1, max(box.x + 16, -16 - 60 * t - box.x)) < 1e-6", "box.y ~ 24" },
  })

  local FIRST = { shift = { 0 }, order = { "forward" }, push = { "both" } }
  local BOTH = { gravity = 0, movable("one", 8, 8, 10, 10), movable("other", 0, 0, 10, 10) }
  row("ways alike are taken as the first of two sees them", FIRST, BOTH, {
    "run:step(1 / 60); one at 8, 9; other at 0, -1",
  })
end)

describe("x, y, push and mass: boxes on the very same spot", function()
  local function heap(v)
    local description = { gravity = 0 }
    for i = 1, v.count do
      description[i] = movable("box" .. i, 50, 50, 16, 16)
    end
    return description
  end

  row("(11) part, never further than the overlap", EVERYWHERE, heap, {
    "deepest = checker(run.all)",
    {
      0.5,
      "deepest() <= 1e-6",
      "abs(box1.x - 50) + abs(box1.y - 50) <= 16 + 1e-6",
      "abs(box2.x - 50) + abs(box2.y - 50) <= 16 + 1e-6",
      "box1 still",
      "box2 still",
    },
  }, { "count", { 2 } })

  row("(11) part, {count} of them, and stay finite", TURNED, heap, {
    { "deepest = checker(run.all)", 2, "deepest() <= 1e-6" },
    function(run)
      for _, view in pairs(run.named) do
        run:check(math.abs(view.x - 50) < 160 and math.abs(view.y - 50) < 160, "thrown")
        run:still(view)
      end
    end,
  }, { "count", { 3 }, { 5 }, { 10 } })

  --   |   +------+--+----+
  --   |   |  1   |  | 3  |   8 px inside each other
  --   |   +------+--+----+
  local BOTHWAYS = { push = { "both" }, turn = variants.TURNS }
  local ONE = { push = { "first" }, order = { "forward" }, turn = variants.TURNS }
  row("(11) part {what}", BOTHWAYS, function(v)
    local one, other = movable("one", 0, 0, 20, 20), movable("other", 12, 0, 20, 20)
    one[2].mass, other[2].mass = v.mass, v.otherMass
    return { gravity = 0, one, other, v.wall and solid(v.wall, -40, 10, 99) }
  end, {
    "run:step(1 / 60); one at x, 0; other at otherX, 0; one still; other still",
  }, {
    -- masses, x of a wall of 10 px, x of the left one and of the right one after a step
    "what, mass, otherMass, wall, x, otherX, levels",
    { "by half when both give way", 1, 1, nil, -4, 16 },
    { "by mass", 1, 3, nil, -6, 14 },
    { "by mass, the heavy one left", 3, 1, nil, -2, 18 },
    { "by mass 7", 1, 7, nil, -7, 13 },
    { "by half beside a wall", 1, 1, -15, -4, 16 },
    { "by half beside a wall at the right", 1, 1, 37, -4, 16 },
    { "by one alone, if the wall leaves no room", 1, 1, -13, 0, 20 },
    { "by one alone, if it is at the right", 1, 1, 35, -8, 12 },
    { "by the first alone, if it gives way", 1, 1, nil, -8, 12, ONE },
  })
end)

-- (What nothing pulls, as enemies of a crowd, parts by a sixteenth of its size at most.)
describe("gravity and vx: a row of crates that slides, and overlaps a little,", function()
  local SLIDING = { solid(-500, 16, 1000, 16) }
  for n = 0, 7 do
    SLIDING[n + 2] = movable(n == 7 and "last", 15.1 * n, 0, 16, 16)
    SLIDING[n + 2][2].vx = 60
  end
  row("parts in one step", play.ONCE, SLIDING, {
    { steps = 1, "last.x ~ 15.1 * 7 + 60 / 60 + 0.9 * 7 / 2" },
  })
end)

describe("x and y: a body between two walls that are too narrow", function()
  --   +--+    +--+
  --   |  +----+  |    20 px of room for 24 px
  --   |  |    |  |
  local NARROW = { solid(0, 0, 40, 200), solid(60, 0, 40, 200), solid(0, 200, 100, 16) }
  NARROW[4] = movable("box", 38, 80, 24, 24)
  row("stays finite and comes to rest", EVERYWHERE, NARROW, {
    { 3, "abs(box.x - 38) <= 24", "abs(box.vx) <= 3000", "abs(box.vy) <= 3000" },
  })
end)

--   ########  a ceiling of 8 px
--     +-+
--     | |     24 px high
--   ########
-- What grew came out on top of the ceiling or below the floor, and nothing told so.
describe("width and height: growing where there is no room", function()
  --  +------+ |        both grow beyond the wall, from 50 to 110 px
  --  +------+ |
  scene.it("leaves a wall on the side where it stood, also where others grow", {
    turn = { 0, 1 },
    shift = { 0 },
  }, function(run)
    local size = run.turn == 0 and "width" or "height"
    local description = { gravity = 0, tile("wall", 100, -500, 4, 1000) }
    for n = 1, 3 do
      description[n + 1] = movable("man" .. n, 50, 100 * n, 50, 40)
    end
    local named = run:build(description)
    run:step(1 / 60)
    for n = 1, 3 do
      local man = named["man" .. n]
      local x, y = man.x, man.y
      man.raw[size] = 110
      man.x, man.y = x, y
    end
    run:play(1 / 6)
    for n = 1, 3 do
      run:near("x", named["man" .. n].x, -10)
    end
  end)

  -- Writes a box of the scene to an object, whatever the turn.
  local function write(run, view, x, y, width, height)
    local isTurned = run.turn % 2 == 1
    view.raw.width, view.raw.height = isTurned and height or width, isTurned and width or height
    view.x, view.y = x, y
  end

  for _, given in ipairs({
    -- what, box that it grows into
    { "upwards", 100, 260, 20, 40 },
    { "downwards", 100, 280, 20, 40 },
    { "both ways", 100, 270, 20, 40 },
    { "a little", 100, 278, 20, 26 },
    { "much", 100, 250, 20, 80 },
    { "sideways", 90, 280, 40, 20 },
  }) do
    local name, x, y, width, height = given[1], given[2], given[3], given[4], given[5]
    local isX = name == "sideways"
    for _, thick in ipairs({ 1, 8, 16 }) do
      local title = ("%s, it stays between two solids of %g px"):format(name, thick)
      scene.it(title, GROWN, function(run)
        local named = run:build({
          tile("floor", 0, 300, 600, isX and 16 or thick),
          isX and tile("left", 100 - thick, 100, thick, 200)
            or tile("ceiling", 0, 276 - thick, 300, thick),
          movable("man", isX and 102 or 100, 280, 20, 20),
          isX and tile("right", 124, 100, thick, 200) or nil,
        })
        local log, man = run:listen(named.man), named.man
        run:play(1 / 6)
        write(run, man, x, y, width, height)
        local low, high = isX and 100 or 276, isX and 124 or 300
        for _ in run:steps(1) do
          local middle = isX and man.x + man.width / 2 or man.y + man.height / 2
          local text = "its middle is at %.9g, not between %.9g and %.9g"
          run:check(middle >= low - 1e-6 and middle <= high + 1e-6, text, middle, low, high)
        end
        run:check(log.crushes > 0, "onCrush told nothing")
      end)
    end
  end
end)
