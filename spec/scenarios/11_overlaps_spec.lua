--- What begins inside something else leaves by the smallest way that is free.

local overlap = require("spec.support.overlap")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local EVERYWHERE = variants.EVERYWHERE

local function solid(x, y, width, height)
  return { "tiles", { x = x, y = y, width = width, height = height, static = true } }
end

local function movable(name, x, y, width, height)
  return { "boxes", { name = name, x = x, y = y, width = width or 16, height = height or 16 } }
end

describe("x and y: a body inside a floor of tiles", function()
  --      +--+
  --   +--|  |---+---+
  --   |  +--+   |   |
  --   +---+---+---+---+
  for _, row in ipairs({
    -- width, depth, x
    { 14, 4, 50 }, -- on one tile
    { 14, 12, 50 },
    { 16, 4, 50 }, -- over a seam: 14 px on one tile, 2 px on the next
    { 16, 12, 50 },
    { 24, 12, 44.5 },
  }) do
    local width, depth, x = row[1], row[2], row[3]
    local title = ("(11) %g wide, %g px deep, comes up on it"):format(width, depth)
    scene.it(title, EVERYWHERE, function(run)
      local description = { movable("body", x, 76 + depth, width, 24) }
      local body = run:build(scene.tiles(description, 20, 0, 100, 16, 16, 16, 0)).body
      for _ in run:steps(1) do
        run:near("x", body.x, x)
        run:check(body.y >= 76 - 1e-6, "was thrown up, to %.9g", body.y)
      end
      run:at(body, x, 76)
      run:still(body)
      run:touches(body, "bottom")
    end)
  end
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

  for _, row in ipairs({
    -- where; x, y, width, height before; x, y after a step
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
  }) do
    scene.it(row[1], row[2], function(run)
      local description = { gravity = 0, movable("box", row[4], row[5], row[6], row[7]) }
      for n, entry in ipairs(row[3]) do
        description[1 + n] = entry
      end
      local box = run:build(description).box
      for _ = 1, 3 do
        run:step(1 / 60)
        run:at(box, row[8], row[9])
        run:still(box)
      end
    end)
  end

  --   +-----------+
  --   |   +--+    |   vx = -60
  --   |   +--+    |   ways out: left 36, top and bottom 40, right 44
  --   +-----------+
  scene.it("(11) or stays, where that is far", EVERYWHERE, function(run)
    local box = run:build({ gravity = 0, solid(0, 0, 64, 64), movable("box", 20, 24) }).box
    box.vx = -60
    for time in run:steps(0.5) do
      local stays = math.abs(box.x - 20) <= 1
      local left = box.x <= -16 + 1e-6 and box.x >= -16 - 60 * time - 1e-6
      run:check(stays or left, "should stay or leave to the left, is at %.9g", box.x)
      run:near("y", box.y, 24)
    end
  end)

  local FIRST = { shift = { 0 }, order = { "forward" }, push = { "both" } }
  scene.it("ways alike are taken as the first of two sees them", FIRST, function(run)
    local one, other = movable("one", 8, 8, 10, 10), movable("other", 0, 0, 10, 10)
    local named = run:build({ gravity = 0, one, other })
    run:step(1 / 60)
    run:at(named.one, 8, 9)
    run:at(named.other, 0, -1)
  end)
end)

describe("x, y, push and mass: boxes on the very same spot", function()
  local function heap(count, fields)
    local description = { gravity = 0 }
    for i = 1, count do
      local box = { name = "box" .. i, x = 50, y = 50, width = 16, height = 16 }
      for key, value in pairs(fields or {}) do
        box[key] = value
      end
      description[i] = { "boxes", box }
    end
    return description
  end

  scene.it("(11) part, never further than the overlap", EVERYWHERE, function(run)
    local named = run:build(heap(2))
    local deepest = overlap.checker(run.all)
    for _ in run:steps(0.5) do
      local depth = deepest()
      run:check(depth <= 1e-6, "still overlap by %.3g", depth)
      for _, view in pairs(named) do
        local dx, dy = math.abs(view.x - 50), math.abs(view.y - 50)
        run:check(dx + dy <= 16 + 1e-6, "%s was thrown %g px", view.name, dx + dy)
        run:still(view)
      end
    end
  end)

  --   |   +------+--+----+
  --   |   |  1   |  | 3  |   8 px inside each other
  --   |   +------+--+----+
  local BOTHWAYS = { push = { "both" }, turn = variants.TURNS }
  local ONE = { push = { "first" }, order = { "forward" }, turn = variants.TURNS }
  for _, row in ipairs({
    -- masses, x of a wall of 10 px, x of the left one and of the right one after a step
    { "by half when both give way", BOTHWAYS, 1, 1, nil, -4, 16 },
    { "by mass", BOTHWAYS, 1, 3, nil, -6, 14 },
    { "by mass, the heavy one left", BOTHWAYS, 3, 1, nil, -2, 18 },
    { "by mass 7", BOTHWAYS, 1, 7, nil, -7, 13 },
    { "by half beside a wall", BOTHWAYS, 1, 1, -15, -4, 16 },
    { "by half beside a wall at the right", BOTHWAYS, 1, 1, 37, -4, 16 },
    { "by one alone, if the wall leaves no room", BOTHWAYS, 1, 1, -13, 0, 20 },
    { "by one alone, if it is at the right", BOTHWAYS, 1, 1, 35, -8, 12 },
    { "by the first alone, if it gives way", ONE, 1, 1, nil, -8, 12 },
  }) do
    scene.it("(11) part " .. row[1], row[2], function(run)
      local one, other = movable("one", 0, 0, 20, 20), movable("other", 12, 0, 20, 20)
      one[2].mass, other[2].mass = row[3], row[4]
      local wall = row[5] and solid(row[5], -40, 10, 99)
      local named = run:build({ gravity = 0, one, other, wall })
      run:step(1 / 60)
      run:at(named.one, row[6], 0)
      run:at(named.other, row[7], 0)
      run:still(named.one)
      run:still(named.other)
    end)
  end

  for _, count in ipairs({ 3, 5, 10 }) do
    scene.it(("(11) part, %d of them, and stay finite"):format(count), TURNED, function(run)
      local named = run:build(heap(count))
      local deepest = overlap.checker(run.all)
      run:play(2)
      local depth = deepest()
      run:check(depth <= 1e-6, "still overlap by %.3g", depth)
      for _, view in pairs(named) do
        run:check(math.abs(view.x - 50) <= 16 * count, "%s: x is %g", view.name, view.x)
        run:check(math.abs(view.y - 50) <= 16 * count, "%s: y is %g", view.name, view.y)
        run:still(view)
      end
    end)
  end
end)

describe("x and y: a body between two walls that are too narrow", function()
  --   +--+    +--+
  --   |  +----+  |    20 px of room for 24 px
  --   |  |    |  |
  scene.it("stays finite and comes to rest", EVERYWHERE, function(run)
    local named = run:build({
      solid(0, 0, 40, 200),
      solid(60, 0, 40, 200),
      solid(0, 200, 100, 16),
      movable("box", 38, 80, 24, 24),
    })
    for _ in run:steps(3) do
      run:check(named.box.x == named.box.x and named.box.y == named.box.y, "is nowhere")
      run:check(math.abs(named.box.vx) <= 3000 and math.abs(named.box.vy) <= 3000, "is too fast")
      run:check(math.abs(named.box.x - 38) <= 24, "was thrown out to x = %g", named.box.x)
    end
  end)
end)
