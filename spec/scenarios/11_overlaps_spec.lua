--- What begins inside something else leaves by the smallest way that is free.

local overlap = require("spec.support.overlap")
local physics = require("physics")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local EVERYWHERE = variants.EVERYWHERE

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
    scene.it(
      ("(11) %g wide, %g px deep, comes up on it"):format(width, depth),
      EVERYWHERE,
      function(run)
        local description = scene.tiles({}, 20, 0, 100, 16, 16, 16, 0)
        local body = { name = "body", x = x, y = 76 + depth, width = width, height = 24 }
        description[#description + 1] = { "players", body }
        body = run:build(description).body
        for _ in run:steps(1) do
          run:near("x", body.x, x)
          run:check(body.y >= 76 - 1e-6, "was thrown up, to %.9g", body.y)
        end
        run:at(body, x, 76)
        run:still(body)
        run:touches(body, "bottom")
      end
    )
  end
end)

describe("x and y: a body inside a big block", function()
  --   +-----------+
  --   |        +--|+
  --   |        +--|+   10 px deep
  --   |           |
  --   +-----------+
  scene.it("(11) leaves by the near side and by no other", TURNED, function(run)
    local named = run:build({
      gravity = 0,
      { "tiles", { name = "block", x = 0, y = 0, width = 100, height = 100, static = true } },
      { "boxes", { name = "box", x = 90, y = 40, width = 16, height = 16, vy = 60 } },
    })
    for i = 1, 5 do
      run:step(1 / 60)
      run:at(named.box, 100, 40 + i)
    end
  end)

  --   +-----------+
  --   |   +--+    |   vx = -60
  --   |   +--+    |   ways out: left 36, top and bottom 40, right 44
  --   +-----------+
  scene.it("(11) stays or leaves by the smallest way", EVERYWHERE, function(run)
    local named = run:build({
      gravity = 0,
      { "tiles", { x = 0, y = 0, width = 64, height = 64, static = true } },
      { "boxes", { name = "box", x = 20, y = 24, width = 16, height = 16, vx = -60 } },
    })
    for time in run:steps(0.5) do
      local x = named.box.x
      local stays = math.abs(x - 20) <= 1
      local left = x <= -16 + 1e-6 and x >= -16 - 60 * time - 1e-6
      run:check(stays or left, "should stay or leave to the left, is at %.9g", x)
      run:near("y", named.box.y, 24)
    end
  end)

  --  +------+------+
  --  |      |      |
  --  |   +--+--+   |   12 px deep in both; the ways to the right (10 px, out of the first) and
  --  +---|  |  |---+   to the left (6 px, out of the second) end in the other one
  --      +-----+
  scene.it("does not leave into another block", EVERYWHERE, function(run)
    local named = run:build({
      gravity = 0,
      { "tiles", { x = 0, y = 0, width = 40, height = 100, static = true } },
      { "tiles", { x = 40, y = 0, width = 40, height = 100, static = true } },
      { "boxes", { name = "box", x = 30, y = 88, width = 16, height = 16 } },
    })
    run:step(1 / 60)
    run:at(named.box, 30, 100)
    run:still(named.box)
  end)
end)

describe("x and y: a body that is inside two at once", function()
  --   |      | |#|     1 px deep in the floor and in the wall: neither way leads out alone
  --   |     +--+#|
  --   +-----|--+--+
  scene.it("in a corner leaves one after the other", EVERYWHERE, function(run)
    local named = run:build({
      { "floors", { x = 0, y = 96, width = 320, height = 16, static = true } },
      { "walls", { x = 160, y = 0, width = 16, height = 96, static = true } },
      { "boxes", { name = "box", x = 147, y = 73, width = 14, height = 24 } },
    })
    run:step(1 / 60)
    run:at(named.box, 146, 72)
    run:play(0.5)
    run:at(named.box, 146, 72)
    run:still(named.box)
  end)

  --  #####|   +--+##   The way down, out of the second, ends in a third one below the first:
  --  #####|   |##|##   it must go to the right before it goes down.
  --  #####+---|--+
  --  ########|+--+
  it("in a corner leaves the first one first, where only that way is free", function()
    for _, isTurned in ipairs({ false, true }) do
      local world = physics.newWorld({ gravity = 0 })
      local function add(group, object)
        if isTurned then
          object.x, object.y, object.width, object.height =
            object.y, object.x, object.height, object.width
        end
        return world:add(group, object)
      end
      add("walls", { x = -97, y = -50, width = 100, height = 60.5, static = true })
      add("walls", { x = 9, y = -50, width = 100, height = 52, static = true })
      add("walls", { x = -97, y = 10.5, width = 99, height = 50, static = true })
      local box = add("boxes", { x = 0, y = 0, width = 10, height = 10 })
      world:update(1 / 60)
      assert.are.equal(isTurned and 2 or 3, box.x)
      assert.are.equal(isTurned and 3 or 2, box.y)
    end
  end)
end)

describe("x and y: a body across a bar", function()
  --     +--+         It sticks out above and below; at its left end it is flush with the bar, and
  --   +-|--|------+  goes that way, which is the shortest. Through the bar would be no way.
  --   +-|--|------+
  --     +--+
  for _, row in ipairs({ { "flush with its end", 5, -2, 17 }, { "1 px inside", 6, 6, 30 } }) do
    local name, x, endX, endY = row[1], row[2], row[3], row[4]
    scene.it(
      name .. (" leaves to (%g, %g)"):format(endX, endY),
      { push = { "both", "first" } },
      function(run)
        local named = run:build({
          gravity = 0,
          { "bars", { x = 5, y = 23, width = 28, height = 7, static = true } },
          { "boxes", { name = "box", x = x, y = 17, width = 7, height = 28 } },
        })
        run:step(1 / 60)
        run:at(named.box, endX, endY)
      end
    )
  end
end)

--   +-----+
--   |  +--|--+
--   |  |  |  |   as far to leave upwards as to the left
--   +-----+  |
--      +-----+
describe("x and y: a body with two ways out that are equally short", function()
  -- exact only where it stands, and not the same when turned
  local HERE = { shift = { 0 } }

  -- The block is at 0, 0 and 10 by 10.
  for _, row in ipairs({
    -- the sides that are equally deep; x, y, width, height; x and y afterwards
    { "right and bottom", -8, -8, 10, 10, -8, -10 },
    { "right and top", -8, 8, 10, 10, -8, 10 },
    { "left and bottom", 8, -8, 10, 10, 8, -10 },
    { "left and top", 8, 8, 10, 10, 8, 10 },
    { "top and bottom", 4, -20, 2, 50, 4, -50 },
    { "left and right", -20, 4, 50, 2, 10, 4 },
    { "all", 4, 4, 2, 2, 4, -2 },
    { "all, on the very same spot", 0, 0, 10, 10, 0, -10 },
  }) do
    scene.it("takes bottom before top before left before right: " .. row[1], HERE, function(run)
      local box = { name = "box", x = row[2], y = row[3], width = row[4], height = row[5] }
      local named = run:build({
        gravity = 0,
        { "tiles", { x = 0, y = 0, width = 10, height = 10, static = true } },
        { "boxes", box },
      })
      run:step(1 / 60)
      run:at(named.box, row[6], row[7])
    end)
  end

  scene.it(
    "takes them as the first of two sees them",
    { shift = { 0 }, order = { "forward" }, push = { "both" } },
    function(run)
      local named = run:build({
        gravity = 0,
        { "boxes", { name = "one", x = 8, y = 8, width = 10, height = 10 } },
        { "boxes", { name = "other", x = 0, y = 0, width = 10, height = 10 } },
      })
      run:step(1 / 60)
      run:at(named.one, 8, 9)
      run:at(named.other, 0, -1)
    end
  )
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

  --   +------+--+----+
  --   |  1   |  | 3  |   8 px inside each other
  --   +------+--+----+
  it("(11) part by mass when both give way", function()
    for _, row in ipairs({ { 1, 1, 4 }, { 1, 3, 6 }, { 3, 1, 2 }, { 1, 7, 7 } }) do
      scene.each({ push = { "both" }, turn = variants.TURNS }, function(run)
        local one = { name = "one", x = 0, y = 0, width = 20, height = 20, mass = row[1] }
        local other = { name = "other", x = 12, y = 0, width = 20, height = 20, mass = row[2] }
        local named = run:build({ gravity = 0, { "boxes", one }, { "boxes", other } })
        run:step(1 / 60)
        run:at(named.one, -row[3], 0)
        run:at(named.other, 20 - row[3], 0)
        run:still(named.one)
        run:still(named.other)
      end)
    end
  end)

  --   |   +--+---+--+    the two are 8 px inside each other, the wall is `gap` px away
  --   |   |  |   |  |
  --   |   +--+---+--+
  for _, row in ipairs({
    -- gap, way of the one at the wall: half, if there is room for that
    { 12, 4 },
    { 5, 4 },
    { 3, 0 },
  }) do
    local gap, way = row[1], row[2]
    scene.it(
      ("(11) part where a wall is %g px away"):format(gap),
      { push = { "both" }, turn = variants.TURNS },
      function(run)
        for _, wall in ipairs({ -10 - gap, 32 + gap }) do
          local named = run:build({
            gravity = 0,
            { "boxes", { name = "one", x = 0, y = 0, width = 20, height = 20 } },
            { "boxes", { name = "other", x = 12, y = 0, width = 20, height = 20 } },
            {
              "walls",
              { name = "wall", x = wall, y = -40, width = 10, height = 99, static = true },
            },
          })
          run:step(1 / 60)
          local left = wall < 0 and way or 8 - way
          run:at(named.one, -left, 0)
          run:at(named.other, 20 - left, 0)
        end
      end
    )
  end

  scene.it(
    "(11) part by the way of the first alone, if that is the one that gives way",
    { push = { "first" }, order = { "forward" }, turn = variants.TURNS },
    function(run)
      local named = run:build({
        gravity = 0,
        { "boxes", { name = "one", x = 0, y = 0, width = 20, height = 20 } },
        { "boxes", { name = "other", x = 12, y = 0, width = 20, height = 20 } },
      })
      run:step(1 / 60)
      run:at(named.one, -8, 0)
      run:at(named.other, 12, 0)
    end
  )

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
      { "tiles", { x = 0, y = 0, width = 40, height = 200, static = true } },
      { "tiles", { x = 60, y = 0, width = 40, height = 200, static = true } },
      { "tiles", { x = 0, y = 200, width = 100, height = 16, static = true } },
      { "boxes", { name = "box", x = 38, y = 80, width = 24, height = 24 } },
    })
    for _ in run:steps(3) do
      run:check(named.box.x == named.box.x and named.box.y == named.box.y, "is nowhere")
      run:check(math.abs(named.box.vx) <= 3000 and math.abs(named.box.vy) <= 3000, "is too fast")
      run:check(math.abs(named.box.x - 38) <= 24, "was thrown out to x = %g", named.box.x)
    end
  end)
end)
