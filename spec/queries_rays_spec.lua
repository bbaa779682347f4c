--- world:raycast and world:sweep.

local small = require("spec.support.small")

local sized, still, tile = small.put, small.still, small.tile

describe("raycast", function()
  -- One box from (10, 10) to (30, 20).
  small.rows("answers: {1}", {
    { "from the left", { 0, 15, 40, 15 }, { 10, 15, -1, 0, 0.25 } },
    { "from the right", { 40, 15, 0, 15 }, { 30, 15, 1, 0, 0.25 } },
    { "from above", { 15, 0, 15, 40 }, { 15, 10, 0, -1, 0.25 } },
    { "from below", { 15, 40, 15, 0 }, { 15, 20, 0, 1, 0.5 } },
    { "across", { 0, 5, 20, 25 }, { 10, 15, -1, 0, 0.5 } },
    { "too short", { 0, 15, 9, 15 } },
    { "past it", { 0, 25, 40, 25 } },
    { "away from it", { 40, 15, 80, 15 } },
    { "from inside", { 15, 15, 80, 15 }, { 15, 15, 0, 0, 0 } },
    { "from an edge, inwards", { 10, 15, 50, 15 }, { 10, 15, -1, 0, 0 } },
    { "from an edge, outwards", { 10, 15, -50, 15 } },
    { "from the far edge, outwards", { 30, 15, 50, 15 } },
    { "up to the edge", { 0, 15, 10, 15 }, { 10, 15, -1, 0, 1 } },
    { "up to the far edge", { 40, 15, 30, 15 }, { 30, 15, 1, 0, 1 } },
    { "along the top edge", { 0, 10, 40, 10 }, { 10, 10, -1, 0, 0.25 } },
    { "along the bottom edge", { 0, 20, 40, 20 } },
    { "along the left edge", { 10, 0, 10, 40 }, { 10, 10, 0, -1, 0.25 } },
    { "along the right edge", { 30, 0, 30, 40 } },
    { "along the top edge, from on it", { 15, 10, 40, 10 }, { 15, 10, 0, 0, 0 } },
    { "into a corner", { 0, 0, 40, 40 }, { 10, 10, 0, -1, 0.25 } },
    { "grazing a corner", { 0, 20, 20, 0 } },
    { "without length, inside", { 15, 15, 15, 15 }, { 15, 15, 0, 0, 0 } },
    { "without length, outside", { 0, 0, 0, 0 } },
    { "without length, on the left edge", { 10, 15, 10, 15 }, { 10, 15, 0, 0, 0 } },
    { "without length, on the right edge", { 30, 15, 30, 15 } },
    { "without length, on the upper left corner", { 10, 10, 10, 10 }, { 10, 10, 0, 0, 0 } },
    { "without length, on the lower right corner", { 30, 20, 30, 20 } },
    { "shorter than can be divided by", { 15, 15, 15, 15 + 1e-310 }, { 15, 15, 0, 0, 0 } },
    { "up to a corner", { 0, 0, 10, 10 }, { 10, 10, 0, -1, 1 } },
    { "from a corner, inwards", { 10, 10, 40, 40 }, { 10, 10, 0, -1, 0 } },
    { "from a corner, outwards", { 10, 10, 0, 0 } },
    { "a little under its top", { 0, 10.0005, 40, 10.0005 }, { 10, 10.0005, -1, 0, 0.25 } },
    { "a little over its bottom", { 0, 19.9995, 40, 19.9995 }, { 10, 19.9995, -1, 0, 0.25 } },
    { "a little in its left", { 10.0005, 0, 10.0005, 40 }, { 10.0005, 10, 0, -1, 0.25 } },
    { "a little in its right", { 29.9995, 0, 29.9995, 40 }, { 29.9995, 10, 0, -1, 0.25 } },
  }, function(_, line, expected)
    for _, static in ipairs({ true, false }) do
      local world = still()
      local object = world:add("b", sized(10, 10, 20, 10, { static = static }))
      for _ = 1, 2 do
        local hit, x, y, nx, ny, fraction = world:raycast(small.unpack(line))
        assert.are.equal(expected and object, hit)
        if expected then
          assert.are.same(expected, { x, y, nx, ny, fraction })
          for _, number in ipairs({ x, y, nx, ny, fraction }) do
            assert.is_true(number ~= 0 or 1 / number > 0) -- no negative zero
          end
        else
          assert.are.equal(0, select("#", world:raycast(small.unpack(line))))
        end
        world:update(1 / 60) -- from here on its box has no margin
      end
    end
  end)

  --     +-+            the neighbour covers the side along gravity,
  --     +-+   +-+-+    or the one across it
  --     +-+   +-+-+
  for _, row in ipairs({
    -- gravityX, gravity, the neighbour, the normal
    { 0, 800, nil, 0, -1 },
    { 0, -800, nil, 0, -1 },
    { 800, 0, nil, -1, 0 },
    { -800, 0, nil, -1, 0 },
    { 0, 800, { 10, 0 }, -1, 0 },
    { 0, 800, { 0, 10 }, 0, -1 },
    { 800, 0, nil, -1, 0, 1e-9 },
    { 0, 800, nil, 0, -1, -1e-9 },
  }) do
    local beside = row[3] and "a neighbour, " or ""
    local title = "tells the normal (%d, %d) at a corner, %sgravity (%d, %d)"
    it(title:format(row[4], row[5], beside, row[1], row[2]), function()
      local world = still({ gravityX = row[1], gravity = row[2] })
      world:add("b", tile(10, 10, 10, 10))
      if row[3] then
        world:add("b", tile(row[3][1], row[3][2], 10, 10))
      end
      local off = row[6] or 0 -- px: a billionth of its way before the corner
      local hit, x, y, nx, ny = world:raycast(9 + math.min(off, 0), 9 - math.max(off, 0), 18, 18)
      assert.is_table(hit)
      assert.is_near(10, x, 1e-8)
      assert.is_near(10, y, 1e-8)
      assert.are.same({ row[4], row[5] }, { nx, ny })
    end)
  end

  it("does not slip through a seam, whichever way it goes", function()
    for _, shift in ipairs({ 0, 0.1, 1 / 3, -1000.1, 100000.3 }) do
      local world = still()
      for i = 0, 19 do
        world:add("wall", tile(100 + shift, 16 * i + shift, 16, 16))
      end
      for _, way in ipairs({ 0, 100, -100, 30, -30 }) do
        local y = 16 * 9 + shift
        local hit, x, _, nx, ny = world:raycast(shift, y - way, 200 + shift, y + way)
        assert.is_table(hit)
        assert.are.near(100 + shift, x, 1e-6)
        assert.are.same({ -1, 0 }, { nx, ny })
      end
    end
  end)
end)

-- A ledge of 100 x 10 px at (0, 0), round ones, a slope; lines that meet them.
local ROUND, SLOPE = { radius = 50, height = 100 }, { slope = "left", height = 100 }
small.rows("raycast: oneWay stops a line only where it stops a body: {1}", {
  { "top", { 50, -50, 50, 50 }, 0 },
  { "top", { 50, 50, 50, -50 } },
  { "top", { -50, 5, 50, 5 } },
  { "top", { 50, 5, 50, -50 } }, -- from inside
  { "top", { 20, -50, 50, 50 }, 0 },
  { true, { 50, -50, 50, 50 }, 0 },
  { "bottom", { 50, 50, 50, -50 }, 10 },
  { "bottom", { 50, -50, 50, 50 } },
  { "left", { -50, 5, 50, 5 }, 5 },
  { "left", { 150, 5, 50, 5 } },
  { "right", { 150, 5, 50, 5 }, 5 },
  { "top", { 50, -50, 50, 50 }, 0, ROUND },
  { "top", { 50, 150, 50, -50 }, nil, ROUND },
  { "top", { -50, 40, 50, 40 }, nil, ROUND },
  { "top", { 50, 0, 50, 99 }, 50, SLOPE },
  { "top", { 50, 150, 50, 50 }, nil, SLOPE },
  { "top", { 50, 50, 50, -50 }, nil, { sensor = false } },
  { "top", { 50, 50, 50, -50 }, 10, { sensor = true } }, -- that has no solid side
}, function(side, line, at, fields)
  for _, isNew in ipairs({ true, false }) do
    local l, world = line, still()
    local ledge = tile(0, 0, 100, 10, fields)
    ledge.oneWay = side
    world:add("ledges", ledge)
    world:update(isNew and 0 or 1 / 60)
    local hit, _, y = world:raycast(l[1], l[2], l[3], l[4])
    assert.same({ at and ledge or nil, at }, { hit, hit and y or nil })
    assert.equal(hit and 1 or 0, (select(2, world:querySegment(l[1], l[2], l[3], l[4]))))
  end
end)

--   +---+ .
--   |   |.
--   +---+---+
--      .|   |
describe("raycast: the corner at which two tiles touch", function()
  it("lets no line through, whichever way", function()
    local world, passed = still(), 0
    local one, other = tile(300, 0, 16, 16), tile(316, 16, 16, 16)
    world:add("tiles", one)
    world:add("tiles", other)
    for n = 1, 40 do
      for _, k in ipairs({ 1, -1, 1 / 3, 0.7 }) do
        local dx, dy = n * k, (41 - n) * k
        local hit, x, y, nx, ny = world:raycast(316 + dx, 16 - dy, 316 - dx, 16 + dy)
        local isThere = math.abs(x or 0) - 316 <= 1e-9 and math.abs(y or 0) - 16 <= 1e-9
        passed = passed + (hit and isThere and nx * nx + ny * ny == 1 and 0 or 1)
        local count = select(2, world:querySegment(316 + dx, 16 - dy, 316 - dx, 16 + dy))
        passed = passed + (count > 0 and 0 or 1)
      end
    end
    assert.equal(0, passed)
    assert.equal(one, (world:raycast(326, 6, 306, 26)))
  end)

  local CORNERS = { { "left", 15 }, { "right", -5 } }
  small.rows("passes the empty corner of a slope: {1}", CORNERS, function(slope, x)
    local world = still()
    world:add("slopes", sized(0, 0, 10, 10, { slope = slope, static = true }))
    assert.is_nil((world:raycast(x, 20, 5, -5)))
  end)

  it("lets through what passes one tile alone, or the filter says so", function()
    local world = still()
    local one, other = tile(300, 0, 16, 16), tile(316, 16, 16, 16)
    world:add("tiles", one)
    assert.is_nil((world:raycast(326, 6, 306, 26)))
    world:add("others", other)
    assert.equal(other, (world:raycast(326, 6, 306, 26)))
    assert.is_nil((world:raycast(326, 6, 306, 26, "tiles")))
    assert.is_nil((world:raycast(326, 6, 306, 26, function(object)
      return object == one
    end)))
    assert.is_nil((world:raycast(326, 6, 316.5, 15.5))) -- ends before it
    other.x = 317
    world:refresh(other)
    assert.is_nil((world:raycast(326, 6, 306, 26)))
  end)
end)

describe("sweep", function()
  local function scene(fields)
    local world = still()
    local object = world:add("a", sized(0, 0, 10, 10, { name = "me" }))
    local wall = world:add("b", sized(30, 5, 10, 30, fields))
    return world, object, wall
  end

  -- The wall, the way, and what is told; far away others stand beside the way.
  small.rows("answers: {1}", {
    { "against a side", { 30, 5, 10, 30 }, { 40, 0 }, { 20, 0, -1, 0, 0.5 } },
    { "past it", { 30, 5, 10, 30 }, { 40, -10 }, nil },
    { "just short of it", { 30, 5, 10, 30 }, { 20, 0 }, nil },
    { "onto the top", { 30, 5, 10, 30 }, { 60, 30 }, { 20, 10, -1, 0, 1 / 3 } },
    { "downwards", { 30, 5, 10, 30 }, { 0, 40 }, nil },
    { "far to the right", { 1000, 0, 15, 15 }, { 3000, 0 }, { 990, 0, -1, 0, 0.33 } },
    { "far to the left", { -1000, 0, 15, 15 }, { -3000, 0 }, { -985, 0, 1, 0, 985 / 3000 } },
    { "far down", { 0, 1000, 15, 15 }, { 0, 3000 }, { 0, 990, 0, -1, 0.33 } },
    { "far up", { 0, -1000, 15, 15 }, { 0, -3000 }, { 0, -985, 0, 1, 985 / 3000 } },
  }, function(_, box, way, expected)
    for _, fields in ipairs({ {}, { static = true }, { kinematic = true } }) do
      local world, object, wall = scene(fields)
      wall.x, wall.y, wall.width, wall.height = small.unpack(box)
      world:refresh(wall)
      for i = 2, 60 do
        world:add("c", tile(100 * i, 20, 15, 15))
        world:add("c", tile(-100 * i, -20, 15, 15))
      end
      local other, x, y, nx, ny, fraction = world:sweep(object, way[1], way[2])
      assert.are.equal(expected and wall, other)
      if expected then
        assert.are.near(expected[5], fraction, 1e-12)
        assert.are.same(expected, { x, y, nx, ny, expected[5] })
      end
      assert.are.same({ 0, 0 }, { object.x, object.y })
    end
  end)

  -- To a millionth of a pixel, on either side.
  it("slides over a floor of tiles, and between two walls that are flush", function()
    local world = still()
    for i = 0, 20 do
      world:add("floor", tile(16.3 * i + 0.1, 100.1, 16.3, 16))
    end
    local runner = world:add("a", sized(20, 76.1, 14, 24))
    assert.is_nil(world:sweep(runner, 200, 0))
    assert.is_table((world:sweep(runner, 100, 5)))
    for _, off in ipairs({ 0, 5e-7, -5e-7 }) do
      world = still()
      world:add("walls", tile(0, 0, 10, 100))
      world:add("walls", tile(20 + off, 0, 10, 100))
      local object = world:add("a", sized(10 + off, 0, 10, 10))
      assert.is_nil(world:sweep(object, 0, 40))
      object.x = 10 - off
      assert.is_nil(world:sweep(object, 0, 40))
    end
  end)

  it("tells what it overlaps before a floor on which it stands, in any order", function()
    for _, names in ipairs({ { "floor", "crate" }, { "crate", "floor" } }) do
      local world = still()
      local place = { floor = { 0, 10, 40, 10 }, crate = { 5, 0, 10, 10 } }
      for _, name in ipairs(names) do
        world:add("walls", tile(small.unpack(place[name]))).name = name
      end
      local other, x, y, nx, ny = world:sweep(world:add("a", sized(0, 0, 10, 10)), 0, 20)
      assert.are.same({ "crate", 0, 0, 0, 0 }, { other.name, x, y, nx, ny })
    end
  end)

  it("passes what it cannot meet", function()
    for _, row in ipairs({
      -- fields of the wall, of what goes there, of the world
      { { sensor = true }, {}, {} },
      { { active = false }, {}, {} },
      { { mask = { a = false } }, {}, {} },
      { { oneWay = "top" }, {}, {} },
      { { oneWay = true }, {}, {} },
      { { oneWay = "right" }, {}, {} },
      { {}, { mask = { b = false } }, {} },
      { {}, {}, { masks = { a = { b = false } } } },
    }) do
      local world, object, wall = scene({ oneWay = "left" })
      assert.are.equal(wall, (world:sweep(object, 40, 0)))
      small.set(wall, row[1])
      small.set(object, row[2])
      small.set(world, row[3])
      assert.is_nil(world:sweep(object, 40, 0))
    end
  end)

  it("reports at once what it is inside of", function()
    local world, object, wall = scene()
    object.x = 25
    assert.are.same({ wall, 25, 0, 0, 0, 0 }, { world:sweep(object, 40, 0) })
  end)
end)
