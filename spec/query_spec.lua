--- Questions: queryPoint, queryRect, querySegment, raycast, sweep, nearest, overlapping, touching,
--- explain.

local effort = require("spec.support.effort")
local physics = require("physics")
local newRandom = require("spec.support.random").new
local script = require("spec.support.script")

local long = effort.playsLong and it or pending

local function box(x, y, width, height, fields)
  local object = { x = x, y = y, width = width, height = height }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return object
end

local function tile(x, y, width, height)
  return box(x, y, width, height, { static = true })
end

local function still(settings)
  local all = { gravity = 0 }
  for key, value in pairs(settings or {}) do
    all[key] = value
  end
  return physics.newWorld(all)
end

--- Names of the objects in a list, by their field `name`.
local function names(list, count)
  local result = {}
  for i = 1, count do
    result[i] = list[i].name
  end
  assert.are.equal(count, #list)
  return table.concat(result, " ")
end

--- 1 and 2 stand side by side, 3 overlaps both, 4 stands alone.
---
---     +---+---+
---     | 1 | 2 |   +---+
---     |  +-+  |   | 4 |
---     +--|3|--+   +---+
---        +-+
local function four(settings)
  local world = still(settings)
  world:add("a", box(0, 0, 20, 20, { name = "1", static = true }))
  world:add("a", box(20, 0, 20, 20, { name = "2" }))
  world:add("b", box(15, 10, 10, 20, { name = "3", sensor = true }))
  world:add("c", box(60, 10, 20, 20, { name = "4", kinematic = true }))
  return world
end

describe("world:queryPoint", function()
  for _, row in ipairs({
    { "in one", 5, 5, "1" },
    { "on a left and top edge", 0, 0, "1" },
    { "on a seam", 20, 5, "2" },
    { "on a right edge", 40, 5, "" },
    { "on a bottom edge", 65, 30, "" },
    { "where three are, in order", 21, 15, "2 3" },
    { "where nothing is", 50, 5, "" },
  }) do
    it("finds what is there: " .. row[1], function()
      assert.are.equal(row[4], names(four():queryPoint(row[2], row[3])))
    end)
  end
end)

describe("world:queryRect", function()
  for _, row in ipairs({
    { "all", { -100, -100, 300, 300 }, "1 2 3 4", "1 2 3 4" },
    { "inside one", { 2, 2, 3, 3 }, "1", "1" },
    { "flush", { 40, 0, 20, 40 }, "", "2 4" },
    { "flush by rounding", { 40 - 1e-8, 0, 5, 40 }, "", "2" },
    { "corner to corner", { 80, 30, 5, 5 }, "", "4" },
    { "a little in", { 39.999, 0, 5, 40 }, "2", "2" },
  }) do
    it("finds what overlaps: " .. row[1], function()
      local r = row[2]
      assert.are.equal(row[3], names(four():queryRect(r[1], r[2], r[3], r[4])))
      local world = four({ sideBySide = true })
      assert.are.equal(row[4], names(world:queryRect(r[1], r[2], r[3], r[4])))
    end)
  end
end)

describe("world:querySegment", function()
  it("finds what is on the line, nearest first", function()
    local world = four()
    assert.are.equal("1 3 2 4", names(world:querySegment(-10, 15, 100, 15)))
    assert.are.equal("4 2 3 1", names(world:querySegment(100, 15, -10, 15)))
    assert.are.equal("", names(world:querySegment(-10, 50, 100, 50)))
  end)

  -- In a grid of 64 buckets, in which cells that are far apart meet.
  it("reports each object once, among many", function()
    local world, random, boxes = still(), newRandom(77), {}
    for i = 1, 60 do
      local x, y = random:between(-500, 500), random:between(-500, 500)
      local size = random:pick({ 4, 12, 40, 150 })
      boxes[i] = world:add("b", box(x, y, size, size, { name = tostring(i) }))
    end
    local function isOn(object, x, y, dx, dy)
      local a, b = (object.x - x) / dx, (object.x + object.width - x) / dx
      local c, d = (object.y - y) / dy, (object.y + object.height - y) / dy
      local enters = math.max(math.min(a, b), math.min(c, d), 0)
      return enters < math.min(math.max(a, b), math.max(c, d), 1)
    end
    local found = 0
    for _ = 1, 400 do
      local x, y = random:between(-500, 500), random:between(-500, 500)
      local dx, dy = random:between(-600, 600), random:between(-600, 600)
      local list, n = world:querySegment(x, y, x + dx, y + dy)
      local expected = 0
      for _, object in ipairs(boxes) do
        expected = expected + (isOn(object, x, y, dx, dy) and 1 or 0)
      end
      assert.are.equal(expected, n)
      for i = 2, n do
        assert.are_not.equal(list[i - 1], list[i])
      end
      found = found + n
    end
    assert.is_true(found > 300)
  end)

  it("tells equal ones in order", function()
    local world = still()
    for i = 1, 5 do
      world:add("b", box(10, 3 * i, 5, 30, { name = tostring(i) }))
    end
    assert.are.equal("1 2 3 4 5", names(world:querySegment(0, 20, 50, 20)))
  end)
end)

describe("world:raycast", function()
  -- One box from (10, 10) to (30, 20).
  for _, row in ipairs({
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
    { "up to a corner", { 0, 0, 10, 10 }, { 10, 10, 0, -1, 1 } },
    { "from a corner, inwards", { 10, 10, 40, 40 }, { 10, 10, 0, -1, 0 } },
    { "from a corner, outwards", { 10, 10, 0, 0 } },
  }) do
    it("answers: " .. row[1], function()
      for _, static in ipairs({ true, false }) do
        local world = still()
        local object = world:add("b", box(10, 10, 20, 10, { static = static }))
        local l, expected = row[2], row[3]
        local hit, x, y, nx, ny, fraction = world:raycast(l[1], l[2], l[3], l[4])
        assert.are.equal(expected and object, hit)
        if expected then
          assert.are.same(expected, { x, y, nx, ny, fraction })
        else
          assert.are.equal(0, select("#", world:raycast(l[1], l[2], l[3], l[4])))
        end
      end
    end)
  end

  it("hits what is half a thousandth in its way", function()
    local world = still()
    world:add("b", tile(10, 10, 20, 10))
    world:update(1 / 60) -- from here on its box has no margin
    for _, row in ipairs({
      { { 0, 10.0005, 40, 10.0005 }, { 10, 10.0005, -1, 0 } },
      { { 0, 19.9995, 40, 19.9995 }, { 10, 19.9995, -1, 0 } },
      { { 10.0005, 0, 10.0005, 40 }, { 10.0005, 10, 0, -1 } },
      { { 29.9995, 0, 29.9995, 40 }, { 29.9995, 10, 0, -1 } },
    }) do
      local line = row[1]
      local _, x, y, nx, ny = world:raycast(line[1], line[2], line[3], line[4])
      assert.are.same(row[2], { x, y, nx, ny })
      assert.is_table((world:raycast(line[3], line[4], line[1], line[2])))
    end
  end)

  -- Into the corner at (10, 10) of the box.
  it("tells the normal along gravity at a corner", function()
    for _, row in ipairs({
      { 0, 800, 0, -1 },
      { 0, -800, 0, -1 },
      { 800, 0, -1, 0 },
      { -800, 0, -1, 0 },
    }) do
      local world = still({ gravityX = row[1], gravity = row[2] })
      world:add("b", tile(10, 10, 20, 10))
      local hit, x, y, nx, ny = world:raycast(0, 0, 40, 40)
      assert.is_table(hit)
      assert.are.same({ 10, 10, row[3], row[4] }, { x, y, nx, ny })
    end
  end)

  it("takes a billionth of its way before a corner for the corner", function()
    for _, row in ipairs({
      { 0, 800, -1e-9, 0, 0, -1 },
      { 800, 0, 0, -1e-9, -1, 0 },
    }) do
      local world, x, y = still({ gravityX = row[1], gravity = row[2] }), row[3], row[4]
      world:add("b", tile(0, 0, 20, 10))
      local hit, _, _, nx, ny = world:raycast(x, y, x + 1, y + 1)
      assert.is_table(hit)
      assert.are.same({ row[5], row[6] }, { nx, ny })
    end
  end)

  --     +-+            the neighbour covers the side along gravity,
  --     +-+   +-+-+    or the one across it
  --     +-+   +-+-+
  it("tells the normal of the wall at a corner in it", function()
    for _, row in ipairs({ { 10, 0, -1, 0 }, { 0, 10, 0, -1 } }) do
      local world = still({ gravity = 800 })
      world:add("b", tile(10, 10, 10, 10))
      world:add("b", tile(row[1], row[2], 10, 10))
      local hit, x, y, nx, ny = world:raycast(2, 2, 18, 18)
      assert.is_table(hit)
      assert.are.same({ 10, 10, row[3], row[4] }, { x, y, nx, ny })
    end
  end)

  it("does not slip through a seam, whichever way it goes", function()
    for _, shift in ipairs({ 0, 0.1, 1 / 3, -1000.1, 100000.3 }) do
      local world = still()
      for i = 0, 19 do
        world:add("wall", tile(100 + shift, 16 * i + shift, 16, 16))
      end
      for i = 1, 19 do
        local y = 16 * i + shift
        for _, slope in ipairs({ 0, 1, -1, 0.3, -0.3 }) do
          local hit, x, _, nx, ny =
            world:raycast(shift, y - 100 * slope, 200 + shift, y + 100 * slope)
          assert.is_table(hit)
          assert.are.near(100 + shift, x, 1e-6)
          assert.are.same({ -1, 0 }, { nx, ny })
        end
      end
    end
  end)

  it("finds the nearest, however far it is", function()
    local world = still()
    local far = world:add("b", box(1e6, 0, 10, 10))
    for i = 1, 300 do
      world:add("c", tile(20 * i, 50, 16, 16))
    end
    assert.are.equal(far, (world:raycast(0, 5, 2e6, 5)))
    local near = world:add("b", box(1e6 - 20, 0, 10, 10))
    assert.are.equal(near, (world:raycast(0, 5, 2e6, 5)))
    for _, x in ipairs({ 1e5, 1e4, 3000, 300, 12 }) do
      near = world:add("b", box(x, 0, 10, 10))
      assert.are.equal(near, (world:raycast(0, 5, 2e6, 5)))
      assert.are.equal(near, (world:raycast(x + 20, 5, -5000, 5)))
    end
  end)
end)

describe("world:querySegment far from the origin", function()
  -- Whether a line passes through the inside of a box.
  local function passes(o, x1, y1, x2, y2)
    local first, last = 0, 1
    for _, row in ipairs({ { x1, x2, o.x, o.width }, { y1, y2, o.y, o.height } }) do
      local from, way, low, high = row[1], row[2] - row[1], row[3], row[3] + row[4]
      if way == 0 then
        if from <= low or from >= high then
          return false
        end
      else
        local a, b = (low - from) / way, (high - from) / way
        first, last = math.max(first, math.min(a, b)), math.min(last, math.max(a, b))
      end
    end
    return last - first > 1e-9
  end

  for _, place in ipairs({ { 1000, 1000 }, { -1700, 1000 }, { -1700, -1700 } }) do
    it(("finds each tile on the line, at %d, %d"):format(place[1], place[2]), function()
      local world, random, tiles = still(), newRandom(3), {}
      for i = 0, 899 do
        local column = i % 30
        local x, y = place[1] + 20 * column, place[2] + 20 * ((i - column) / 30)
        tiles[i + 1] = world:add("tiles", tile(x, y, 8, 8))
      end
      for _ = 1, 60 do
        local x1, y1 = place[1] + random:between(0, 600), place[2] + random:between(0, 600)
        local x2, y2 = place[1] + random:between(0, 600), place[2] + random:between(0, 600)
        local list, count = world:querySegment(x1, y1, x2, y2)
        local found, expected = {}, 0
        for n = 1, count do
          found[list[n]] = true
        end
        for _, object in ipairs(tiles) do
          if passes(object, x1, y1, x2, y2) then
            expected = expected + 1
            assert.is_true(found[object])
          end
        end
        assert.are.equal(expected, count)
      end
    end)
  end
end)

describe("world:nearest", function()
  for _, row in ipairs({
    { "inside", 5, 5, 10, "1", 0 },
    { "left of one", -3, 5, 10, "1", 3 },
    { "off a corner", 83, 34, 10, "4", 5 },
    { "equal ones, in order", 50, 15, 100, "2", 10 },
    { "at the edge of the radius", -3, 5, 3, "1", 3 },
    { "too far", -3, 5, 2.99, nil, nil },
    { "far away", -3000, 0, 1e7, "1", 3000 },
    { "no radius", 5, 5, 0, "1", 0 },
  }) do
    it("answers: " .. row[1], function()
      local object, distance = four():nearest(row[2], row[3], row[4])
      assert.are.equal(row[5], object and object.name)
      assert.are.equal(row[6], distance)
    end)
  end
end)

describe("world:sweep", function()
  local function scene(fields)
    local world = still()
    local object = world:add("a", box(0, 0, 10, 10, { name = "me" }))
    local wall = world:add("b", box(30, 5, 10, 30, fields))
    return world, object, wall
  end

  for _, row in ipairs({
    { "against a side", { 40, 0 }, { 20, 0, -1, 0, 0.5 } },
    { "past it", { 40, -10 }, nil },
    { "just short of it", { 20, 0 }, nil },
    { "onto the top", { 60, 30 }, { 20, 10, -1, 0, 1 / 3 } },
    { "downwards", { 0, 40 }, nil },
  }) do
    it("answers: " .. row[1], function()
      for _, fields in ipairs({ {}, { static = true }, { kinematic = true } }) do
        local world, object, wall = scene(fields)
        local other, x, y, nx, ny, fraction = world:sweep(object, row[2][1], row[2][2])
        assert.are.equal(row[3] and wall, other)
        if row[3] then
          assert.are.same(row[3], { x, y, nx, ny, fraction })
        end
        assert.are.same({ 0, 0 }, { object.x, object.y })
      end
    end)
  end

  for _, row in ipairs({
    { "right", 3000, 0, 990, 0, -1, 0 },
    { "left", -3000, 0, -985, 0, 1, 0 },
    { "down", 0, 3000, 0, 990, 0, -1 },
    { "up", 0, -3000, 0, -985, 0, 1 },
    { "right and up", 3000, -3000, 990, -990, -1, 0 },
    { "left and down", -3000, 3000, -985, 985, 1, 0 },
  }) do
    it("finds what is far " .. row[1], function()
      local world, dx, dy, x, y = still(), row[2], row[3], row[4], row[5]
      local object = world:add("a", box(0, 0, 10, 10))
      local wall = world:add("b", tile(dx / 3, dy / 3, 15, 15))
      if dx ~= 0 and dy ~= 0 then
        wall.y, wall.height = wall.y - 100, 215
        world:refresh(wall)
      end
      for i = 1, 60 do
        world:add("c", tile(100 * i, 20, 15, 15))
        world:add("c", tile(-100 * i, -20, 15, 15))
      end
      local hit, atX, atY, atNx, atNy, fraction = world:sweep(object, dx, dy)
      assert.are.equal(wall, hit)
      assert.are.near(x, atX, 1e-6)
      assert.are.near(y, atY, 1e-6)
      assert.are.same({ row[6], row[7] }, { atNx, atNy })
      assert.are.near((x ~= 0 and x / dx or y / dy), fraction, 1e-9)
    end)
  end

  it("slides over a floor of tiles and past flush walls", function()
    local world = still()
    for i = 0, 20 do
      world:add("floor", tile(16.3 * i + 0.1, 100.1, 16.3, 16))
    end
    local object = world:add("a", box(20, 76.1, 14, 24))
    assert.is_nil(world:sweep(object, 200, 0))
    assert.are.equal("floor", world:sweep(object, 100, 5) and "floor")
  end)

  -- To a millionth of a pixel, on either side.
  it("slides between two walls that are flush", function()
    for _, off in ipairs({ 0, 5e-7, -5e-7 }) do
      local world = still()
      world:add("walls", tile(0, 0, 10, 100))
      world:add("walls", tile(20 + off, 0, 10, 100))
      local object = world:add("a", box(10 + off, 0, 10, 10))
      assert.is_nil(world:sweep(object, 0, 40))
      object.x = 10 - off
      assert.is_nil(world:sweep(object, 0, 40))
    end
  end)

  it("passes what it cannot meet", function()
    for _, fields in ipairs({
      { sensor = true },
      { active = false },
      { mask = { a = false } },
      { oneWay = "top" },
      { oneWay = "right" },
    }) do
      local world, object, wall = scene(fields)
      assert.is_nil(world:sweep(object, 40, 0))
      wall.sensor, wall.active, wall.mask, wall.oneWay = nil, nil, nil, "left"
      assert.are.equal(wall, (world:sweep(object, 40, 0)))
      object.mask = { b = false }
      assert.is_nil(world:sweep(object, 40, 0))
      object.mask = nil
      world.masks = { a = { b = false } }
      assert.is_nil(world:sweep(object, 40, 0))
    end
  end)

  it("reports at once what it is inside of", function()
    local world, object, wall = scene()
    object.x = 25
    assert.are.same({ wall, 25, 0, 0, 0, 0 }, { world:sweep(object, 40, 0) })
  end)
end)

describe("world:overlapping", function()
  it("finds what overlaps an object", function()
    local world = four()
    local one, three = world.objects.a[1], world.objects.b[1]
    assert.are.equal("3", names(world:overlapping(one)))
    assert.are.equal("1 2", names(world:overlapping(three)))
    world.sideBySide = true
    assert.are.equal("2 3", names(world:overlapping(one)))
    three.active = false
    assert.are.equal("", names(world:overlapping(three)))
  end)
end)

describe("a filter", function()
  it("is a group, a list of groups or a function", function()
    local world = four()
    local function isFour(object)
      return object.name == "4"
    end
    local function isEven(object)
      return object.name % 2 == 0
    end
    assert.are.equal("1 2", names(world:queryRect(-10, -10, 100, 100, "a")))
    assert.are.equal("3 4", names(world:queryRect(-10, -10, 100, 100, { "c", "b" })))
    assert.are.equal("", names(world:queryRect(-10, -10, 100, 100, {})))
    assert.are.equal("2 4", names(world:queryRect(-10, -10, 100, 100, isEven)))
    assert.are.equal("4", world:raycast(-10, 15, 100, 15, "c").name)
    assert.are.equal("4", world:raycast(-10, 15, 100, 15, isFour).name)
    assert.are.equal("3", world:raycast(-10, 15, 100, 15, { "b", "c" }).name)
    assert.are.equal("2 4", names(world:querySegment(-10, 15, 100, 15, isEven)))
    assert.are.equal("4", world:nearest(0, 0, 1000, isFour).name)
    assert.are.equal("2", names(world:queryPoint(21, 15, "a")))
    assert.are.equal("2", names(world:overlapping(world.objects.b[1], isEven)))
    assert.is_nil(world:sweep(world.objects.a[2], 100, 5, "a"))
    assert.are.equal("4", world:sweep(world.objects.a[2], 100, 5, isFour).name)
  end)

  it("may ask from elsewhere, and the answer is that of the first question", function()
    local world = physics.newWorld()
    world:add("a", { x = 30, y = 0, width = 10, height = 10 })
    local near = world:add("a", { x = 10, y = 0, width = 10, height = 10 })
    local function filter()
      world:nearest(500, 5, 1000)
      world:raycast(500, 5, -500, 5)
      return true
    end
    local object, distance = world:nearest(0, 5, 100, filter)
    assert.is_true(object == near)
    assert.are.equal(10, distance)
    local hit, x = world:raycast(0, 5, 100, 5, filter)
    assert.is_true(hit == near)
    assert.are.equal(10, x)
  end)

  it("may ask questions of its own, and fail", function()
    local world = four()
    local function isAlone(object)
      local _, count = world:overlapping(object, function(other)
        return other ~= object
      end)
      return count == 0
    end
    assert.are.equal("4", names(world:queryRect(-10, -10, 100, 100, isAlone)))
    assert.are.equal("4", world:raycast(-10, 15, 100, 15, isAlone).name)
    assert.has_error(function()
      world:queryRect(-10, -10, 100, 100, function()
        error("no", 0)
      end)
    end, "no")
    assert.are.equal("1 2 3 4", names(world:queryRect(-10, -10, 100, 100)))
  end)

  it("is asked about no object twice", function()
    local world, asked = four(), {}
    world:raycast(-1000, 15, 1000, 15, function(object)
      asked[#asked + 1] = object.name
    end)
    table.sort(asked)
    assert.are.equal("1 2 3 4", table.concat(asked, " "))
  end)

  it("is told no negative zero", function()
    local world = still()
    world:add("b", box(-10, -10, 20, 20))
    local froms = { { -20, 0 }, { 20, 0 }, { 0, -20 }, { 0, 20 }, { -10, 0 }, { 0, 10 } }
    for _, from in ipairs(froms) do
      local x1, y1 = from[1], from[2]
      local _, x, y, nx, ny, fraction = world:raycast(x1, y1, -x1 / 2, -y1 / 2)
      for _, number in ipairs({ x, y, nx, ny, fraction }) do
        assert.is_true(number ~= 0 or 1 / number > 0)
      end
    end
  end)

  it("is told where it hits, also if it is as short as a number can be", function()
    for _, length in ipairs({ 1e-290, 1e-305, 4.9406564584124654e-324 }) do
      local left, above = still(), still()
      left:add("a", tile(-16, -8, 16, 16))
      above:add("a", tile(-8, -16, 16, 16))
      assert.are.same({ 0, 0, 1, 0, 0 }, { select(2, left:raycast(0, 0, -length, 0)) })
      assert.are.same({ 0, 0, 0, 1, 0 }, { select(2, above:raycast(0, 0, 0, -length)) })
    end
  end)
end)

-- A world with many objects.
local function build()
  local world = still()
  for i = 1, 300 do
    world:add("tiles", tile(20 * i, 1000, 16, 16))
    world:add("boxes", box(20 * i, 2000, 16, 16))
  end
  return world
end

describe("in a world of 600 a question", function()
  local function count(world, x, y)
    local _, n = world:queryPoint(x, y)
    return n
  end

  it("sees what the game wrote, before and after an update", function()
    local world = build()
    local object = world:add("a", box(0, 0, 10, 10))
    for step = 1, 4 do
      local x = 100 * step
      object.x = x
      assert.are.equal(1, count(world, x + 5, 5))
      object.x = x + 3 -- a question was asked before
      assert.are.equal(0, count(world, x + 2, 5))
      assert.are.equal(1, count(world, x + 12, 5))
      object.width = 3
      assert.are.equal(0, count(world, x + 12, 5))
      object.width = 10
      if step > 2 then
        world:update(1 / 60)
      end
    end
  end)

  it("sees an object that replaced another one of its group", function()
    local world = build()
    local first = world:add("a", box(0, 0, 10, 10))
    world:add("a", box(30, 0, 10, 10))
    world:update(1 / 60)
    assert.are.equal(0, count(world, 105, 5))
    world:remove(first)
    local second = world:add("a", box(100, 0, 10, 10))
    assert.are.equal(1, count(world, 105, 5))
    assert.are.equal(second, (world:raycast(80, 5, 200, 5)))
    world:add("a", box(200, 0, 10, 10))
    world:remove(second)
    assert.are.equal(1, count(world, 205, 5))
    assert.are.equal(0, count(world, 105, 5))
    world:setBounds(300, 0, 50, 50)
    assert.are.equal(1, count(world, 299, 5))
    world:setBounds(400, 0, 50, 50)
    assert.are.equal(0, count(world, 299, 5))
    assert.are.equal(1, count(world, 399, 5))
  end)

  -- From all four sides.
  it("hits what was moved or made larger by 3 px by hand", function()
    local world = build()
    local object = world:add("a", box(0, 0, 10, 10, { vx = 60, vy = 60 }))
    local function hits(x1, y1, x2, y2, x, y)
      local found, hitX, hitY = world:raycast(x1, y1, x2, y2)
      assert.are.equal(object, found)
      assert.are.same({ x, y }, { hitX, hitY })
    end
    for step = 1, 12 do
      world:update(1 / 60)
      local at = object.x
      assert.are.equal(step, at)
      hits(at + 9.5, at + 30, at + 9.5, at - 30, at + 9.5, at + 10)
      object.x, object.y = at + 3, at - 3
      hits(at + 12.5, at + 30, at + 12.5, at - 30, at + 12.5, at + 7)
      hits(at + 30, at - 2.5, at - 30, at - 2.5, at + 13, at - 2.5)
      assert.is_nil(world:raycast(at + 2.5, at - 30, at + 2.5, at + 30))
      assert.is_nil(world:raycast(at - 30, at + 7.5, at + 30, at + 7.5))
      object.x, object.y, object.width, object.height = at, at, 13, 13
      hits(at + 12.5, at - 30, at + 12.5, at + 30, at + 12.5, at)
      hits(at - 30, at + 12.5, at + 30, at + 12.5, at, at + 12.5)
      object.width, object.height = 10, 10
    end
  end)

  -- As from a pool: it is the same table as before, in the same world.
  for _, isStatic in ipairs({ false, true }) do
    local kind = isStatic and "static" or "dynamic"
    it("sees an object that was removed, put elsewhere and added again, " .. kind, function()
      local world = build()
      local object = world:add("a", box(0, 0, 10, 10, { static = isStatic }))
      world:update(1 / 60)
      for x = 100, 300, 100 do
        assert.are.equal(1, count(world, x - 95, 5))
        world:remove(object)
        object.x = x
        world:add(x == 200 and "b" or "a", object)
        for _ = 1, 2 do
          assert.are.equal(0, count(world, x - 95, 5))
          assert.are.equal(1, count(world, x + 5, 5))
          assert.are.equal(object, (world:raycast(x + 5, -50, x + 5, 50)))
          assert.are.equal(object, (world:nearest(x + 5, 15, 10)))
          world:update(1 / 60)
        end
      end
      world:remove(object)
      object.static, object.vx = not isStatic, 60
      world:add("a", object)
      world:update(1 / 60)
      assert.are.equal(isStatic and 301 or 300, object.x)
      assert.are.equal(1, count(world, object.x + 9.5, 5))
    end)
  end

  it("sees what was added and what was removed", function()
    local world = build()
    world:update(1 / 60)
    local first = world:add("a", box(0, 0, 10, 10))
    assert.are.equal(1, count(world, 5, 5))
    table.insert(world.objects.a, box(0, 0, 10, 10))
    assert.are.equal(2, count(world, 5, 5))
    world:remove(first)
    assert.are.equal(1, count(world, 5, 5))
    world.objects.a[1] = nil
    assert.are.equal(0, count(world, 5, 5))
    world:update(1 / 60)
    world.objects.b = { hero = box(0, 0, 10, 10) }
    assert.are.equal(1, count(world, 5, 5))
    world.objects.b = nil
    assert.are.equal(0, count(world, 5, 5))
  end)

  it("sees that another object has taken a place", function()
    local ways = {
      function(world, x)
        return world:queryRect(x - 5, 0, 10, 10)[1]
      end,
      function(world, x)
        return world:querySegment(x, -50, x, 50)[1]
      end,
      function(world, x)
        return (world:raycast(x, -50, x, 50))
      end,
      function(world, x)
        return (world:nearest(x, 5, 1))
      end,
    }
    for _, find in ipairs(ways) do
      local world = build()
      for n = 0, 2 do
        world:add("a", box(100 * n, 0, 10, 10))
      end
      world:update(1 / 60)
      assert.are.equal(world.objects.a[2], find(world, 105))
      local other = box(50, 0, 10, 10)
      world.objects.a[2] = other
      assert.is_nil(find(world, 105))
      assert.are.equal(other, find(world, 55))
    end
  end)

  it("sees which objects are active", function()
    local world = build()
    local object = world:add("a", box(0, 0, 10, 10, { active = false }))
    assert.are.equal(0, count(world, 5, 5))
    object.active = true
    assert.are.equal(1, count(world, 5, 5))
    object.active = false
    assert.are.equal(0, count(world, 5, 5))
  end)

  it("sees a static object where the library has read it", function()
    local world = build()
    local object = world:add("a", tile(0, 0, 10, 10))
    object.x = 50 -- not read yet
    assert.are.equal(1, count(world, 55, 5))
    world:update(1 / 60)
    assert.are.equal(1, count(world, 55, 5))
    object.x = 100
    assert.are.equal(1, count(world, 55, 5))
    world:refresh(object)
    assert.are.same({ 0, 1 }, { count(world, 55, 5), count(world, 105, 5) })
    world:remove(object)
    world:update(1 / 60)
    object.x = 150
    world:add("a", object)
    world:update(1 / 60)
    assert.are.same({ 0, 1 }, { count(world, 105, 5), count(world, 155, 5) })
  end)

  it("sees a kinematic object where the game has put it", function()
    local world = build()
    local object = world:add("a", box(0, 0, 10, 10, { kinematic = true }))
    world:update(1 / 60)
    object.x = 50
    assert.are.same({ 0, 1 }, { count(world, 5, 5), count(world, 55, 5) })
  end)

  it("refuses what an update would refuse", function()
    local world = build()
    local object = world:add("a", box(0, 0, 10, 10))
    world:queryPoint(5, 5)
    for _, row in ipairs({
      { "y", 0 / 0, "must be a number, got nan" },
      { "x", 1e150, "must be a number in -1e+100..1e+100, got 1e+150" },
      { "y", -1e101, "must be a number in -1e+100..1e+100, got -1e+101" },
      { "width", 1 / 0, "must be a finite number > 0, got inf" },
      { "width", 0, "must be a number > 0, got 0" },
      { "height", -1, "must be a number > 0, got -1" },
      { "active", "yes", 'must be true or false, got "yes"' },
    }) do
      local field, text = row[1], ("physics: objects.a[1].%s %s"):format(row[1], row[3])
      local before = object[field]
      object[field] = row[2]
      local ok, message = pcall(function()
        world:queryPoint(5, 5)
      end)
      assert.is_false(ok)
      assert.is_truthy(message:find(text, 1, true), message)
      object[field] = before
      assert.are.equal(1, count(world, 5, 5))
    end
  end)
end)

describe("a question", function()
  it("fills the list that is given, to its end", function()
    local world, out = four(), {}
    local list, n = world:queryRect(-10, -10, 100, 100, nil, out)
    assert.are.equal(out, list)
    assert.are.equal("1 2 3 4", names(list, n))
    assert.are.equal("1", names(world:queryPoint(5, 5, nil, out)))
    assert.are.equal("", names(world:queryPoint(500, 5, nil, out)))
  end)

  it("leaves no garbage", function()
    local world, out = four(), {}
    local object = world.objects.a[2]
    local function ask(times)
      for _ = 1, times do
        world:queryRect(-10, -10, 100, 100, "a", out)
        world:queryPoint(5, 5, nil, out)
        world:querySegment(-10, 15, 100, 15, nil, out)
        world:raycast(-10, 15, 100, 15)
        world:nearest(50, 15, 100)
        world:sweep(object, 100, 5)
        world:overlapping(object, nil, out)
        world:touching(object, world.objects.a[1])
      end
    end
    -- Traces that are compiled count as memory, too: the calmest of some rounds.
    local least = math.huge
    ask(200)
    collectgarbage()
    collectgarbage("stop")
    for _ = 1, 20 do
      local before = collectgarbage("count")
      ask(20)
      least = math.min(least, collectgarbage("count") - before)
    end
    collectgarbage("restart")
    assert.is_true(least < 0.1, ("%.3f KB"):format(least))
  end)

  it("finds what is on a line that is shorter than numbers can divide by", function()
    local world = still()
    for i = 0, 9 do
      world:add("boxes", box(100 * i - 5, -5, 10, 10))
    end
    local tiny = 1e-310
    local lines = { { 0, tiny }, { tiny, 0 }, { tiny, tiny }, { -tiny, 0 }, { 0, 5e-324 } }
    for _, line in ipairs(lines) do
      local object, x, y, nx, ny, fraction = world:raycast(0, 0, line[1], line[2])
      assert.are.equal(world.objects.boxes[1], object)
      assert.are.same({ 0, 0, 0, 0, 0 }, { x, y, nx, ny, fraction })
      assert.are.equal(1, select(2, world:querySegment(0, 0, line[1], line[2])))
      assert.are.equal(object, (world:raycast(0, 0, line[1], line[2], function()
        return true
      end)))
    end
  end)

  -- What moves may stand elsewhere since the last question, what is static may not.
  it("costs what is near and what moves, up to 1000 of these", function()
    local reads = 0

    -- Boxes in rows of 50; their x is read through a counter.
    local function fill(world, group, count, fields)
      for i = 0, count - 1 do
        local object, x = box(nil, 40 * ((i - i % 50) / 50), 16, 16), 40 * (i % 50)
        for name, value in pairs(fields) do
          object[name] = value
        end
        setmetatable(object, {
          __index = function(_, key)
            reads = reads + 1
            return key == "x" and x or nil
          end,
          __newindex = function(t, key, value)
            if key ~= "x" then
              rawset(t, key, value)
            end
          end,
        })
        world:add(group, object)
      end
    end

    local function most(movers, tiles)
      local world, costs = still(), 0
      fill(world, "boxes", movers, {})
      fill(world, "tiles", tiles, { static = true })
      world:update(1 / 60)
      local object = world.objects.boxes[52]
      for n, ask in ipairs({
        function() -- the first one looks at everything
          return world:queryPoint(5, 5)
        end,
        function()
          return world:queryPoint(5, 5)
        end,
        function()
          return world:queryRect(0, 0, 60, 60)
        end,
        function()
          return world:querySegment(-10, 5, 60, 5)
        end,
        function()
          return world:raycast(-10, 5, 100000, 5)
        end,
        function()
          return world:nearest(20, 20, 10)
        end,
        function()
          return world:sweep(object, 30, 0)
        end,
        function()
          return world:overlapping(object)
        end,
      }) do
        reads = 0
        assert.is_truthy(ask())
        costs = n > 1 and math.max(costs, reads) or 0
      end
      return costs
    end

    local few, many, crowd = most(200, 200), most(200, 2000), most(1001, 0)
    assert.is_true(few < 2 * 200, few)
    assert.are.equal(few, many)
    assert.is_true(crowd < 200, crowd)
  end)

  it(
    "finds among 1001 what was moved and refreshed, and says under checked what it misses",
    function()
      local world = still()
      for n = 1, 1001 do
        world:add("boxes", box(40 * n, 0, 16, 16))
      end
      world:update(1 / 60)
      assert.are.equal(0, select(2, world:queryPoint(5, 505)))
      local object = world.objects.boxes[7]
      object.x, object.y = 0, 500
      assert.are.equal(0, select(2, world:queryPoint(5, 505)))
      world.checked = true
      local ok, message = pcall(world.queryPoint, world, 5, 505)
      assert.is_false(ok)
      assert.matches("objects.boxes%[7%] was moved .* world:refresh%(object%)", message)
      world:refresh(object)
      assert.are.equal(object, world:queryPoint(5, 505)[1])
      world:move(object, 90, 500)
      assert.are.equal(object, world:queryPoint(95, 505)[1])
    end
  )

  it("can be asked inside canCollide and inside events, where nothing may be moved", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("floor", tile(0, 100, 200, 20))
    local object = world:add("a", box(0, 50, 10, 10))
    local answers, told = {}, nil
    function object.canCollide(self)
      answers[#answers + 1] = #world:queryPoint(self.x + 5, self.y + 5)
      local ok, message = pcall(world.move, world, self, 0, 0)
      assert(not ok and message:find("cannot be called from inside canCollide", 1, true), message)
      return true
    end
    function object.onBegin(self, other)
      told = world:touching(self, other)
      world:move(self, self.x + 1, self.y)
    end
    for _ = 1, 60 do
      world:update(1 / 60)
    end
    assert.are.equal("bottom", told)
    assert.are.equal(1, answers[1])
    assert.are.equal(1, object.x)
  end)

  long("changes no bit of what comes", function()
    local options = { steps = 60, boxes = 24, writes = 0.5, specials = true }
    for seed = 1, 3 do
      for _, settings in ipairs({ {}, { broadphase = "pairs", rest = false } }) do
        local track = script.track(script.new(seed, options), settings)
        local player = script.play(script.new(seed, options), settings)
        local random, out = newRandom(seed), {}
        repeat
          local world = player.world
          for _ = 1, 3 do
            local x, y = random:between(0, 400), random:between(0, 400)
            world:queryRect(x, y, 50, 50, nil, out)
            world:raycast(x, y, y, x)
            local object = player.list[random:integer(1, player.count)]
            if object then
              -- What is written and taken back has never happened.
              local oldX, active, mask = object.x, object.active, object.mask
              object.x, object.active, object.mask = x, false, { boxes = false }
              world:nearest(x, y, 100)
              object.x, object.active, object.mask = oldX, active, mask
              world:sweep(object, x, y)
              world:overlapping(object, nil, out)
            end
          end
          local more = player:next()
          local text = more and script.difference(track, player)
          if text then
            error(("seed %d, %s"):format(seed, text))
          end
        until not more
      end
    end
  end)

  long("finds what looking at all objects finds", function()
    for seed = 1, 8 do
      local random, world, all = newRandom(seed), still(), {}
      for i = 1, random:integer(5, 300) do
        local size = random:pick({ 4, 16, 16, 64, 300 })
        local x, y = 8 * random:integer(-50, 50), 8 * random:integer(-50, 50)
        all[i] = world:add("b", box(x, y, random:between(1, size), size, { i = i }))
        all[i].static = random:chance(0.5)
      end
      for round = 1, 12 do
        local x1, y1 = 4 * random:integer(-120, 120), 4 * random:integer(-120, 120)
        local x2, y2 = random:pick({ x1, 4 * random:integer(-120, 120) }), random:between(-500, 500)
        local points, rects, near, best = {}, {}, nil, math.huge
        for i = 1, #all do
          local o = all[i]
          local right, bottom = o.x + o.width, o.y + o.height
          if x1 >= o.x and x1 < right and y1 >= o.y and y1 < bottom then
            points[#points + 1] = i
          end
          if x1 < right and x1 + 50 > o.x and y1 < bottom and y1 + 30 > o.y then
            rects[#rects + 1] = i
          end
          local dx, dy = math.max(o.x - x1, 0, x1 - right), math.max(o.y - y1, 0, y1 - bottom)
          local distance = dx * dx + dy * dy
          if distance < best then
            near, best = o, distance
          end
        end
        local function same(expected, list)
          for i = 1, math.max(#expected, #list) do
            local text = "seed %d, round %d: %s"
            assert(list[i] == all[expected[i] or 0], text:format(seed, round, i))
          end
        end
        same(points, (world:queryPoint(x1, y1)))
        same(rects, (world:queryRect(x1, y1, 50, 30)))
        assert.are.equal(near, (world:nearest(x1, y1, 1e5)))
        -- A ray is what the segment finds first, and the pieces of a line find what it finds.
        local line, n = world:querySegment(x1, y1, x2, y2)
        assert.are.equal(line[1], (world:raycast(x1, y1, x2, y2)))
        local isOn = {}
        for i = 1, n do
          isOn[line[i]] = true
        end
        for step = 0, 50 do
          local x, y = x1 + (x2 - x1) * step / 50, y1 + (y2 - y1) * step / 50
          for _, o in ipairs(all) do
            local isIn = math.min(x - o.x, o.x + o.width - x, y - o.y, o.y + o.height - y) > 1e-3
            assert(isOn[o] or not isIn, ("seed %d, round %d: %d"):format(seed, round, o.i))
          end
        end
        local moved = all[random:integer(1, #all)]
        if not moved.static then
          moved.x = moved.x + random:pick({ 3, -5, 200 })
        end
        if round % 5 == 0 then
          world:update(1 / 60)
        end
        world:refresh(moved)
      end
    end
  end)
end)

describe("world:touching", function()
  it("answers with the side of the first", function()
    local world = physics.newWorld({ gravity = 800 })
    local floor = world:add("floor", tile(0, 100, 200, 20))
    local object = world:add("a", box(0, 84, 16, 16))
    local neighbour = world:add("a", box(16, 84, 16, 16))
    local coin = world:add("coins", box(4, 90, 8, 8, { sensor = true, static = true }))
    local far = world:add("a", box(150, 84, 16, 16))
    assert.is_nil(world:touching(object, floor))
    world:update(1 / 60)
    assert.are.equal("bottom", world:touching(object, floor))
    assert.are.equal("top", world:touching(floor, object))
    assert.is_nil(world:touching(object, neighbour))
    assert.is_string(world:touching(object, coin))
    world.sideBySide = true
    assert.are.equal("right", world:touching(object, neighbour))
    object.y = 50
    assert.is_nil(world:touching(object, floor))
    assert.is_nil(world:touching(object, object))
    world.sideBySide, far.x, far.y = false, 16, 50 -- put there, not come
    assert.is_nil(world:touching(object, far))
  end)

  it("knows two apart that are equal by a metamethod", function()
    local isAsked = false
    local crates = {
      __eq = function()
        isAsked = true
        return true
      end,
    }
    local world = still()
    local one = world:add("a", setmetatable(box(0, 0, 10, 10), crates))
    local other = world:add("a", setmetatable(box(10, 0, 10, 10), crates))
    world:add("walls", tile(20, 0, 10, 10))
    one.vx = 10
    world:update(1 / 60)
    assert.is_true(rawequal(other, one.touching.right))
    assert.are.equal("right", world:touching(one, other))
    assert.is_nil(world:touching(one, one))
    local text = world:explain(one, other)
    assert.is_truthy(text:find("flush at the right", 1, true), text)
    assert.is_false(isAsked)
  end)
end)

describe("world:explain", function()
  local NAMES = "objects.a[1] and objects.b[1] "
  for _, row in ipairs({
    { { x = 30 }, {}, "can collide: now they are 20 px apart on x." },
    { { x = 30, y = 15 }, {}, "can collide: now they are 20 px apart on x and 5 px on y." },
    { { x = 10 }, {}, "can collide: now they are flush at the right of objects.a[1]." },
    { { x = 8 }, {}, "can collide: now they overlap by 2 x 10 px." },
    { { active = false }, {}, "never collide: objects.b[1] is not active." },
    {
      {},
      { mask = { b = false } },
      'never collide: the mask of objects.a[1] refuses the group "b".',
    },
    {
      { static = true },
      { kinematic = true },
      "never collide: one is kinematic and the other static",
    },
    { { static = true }, { static = true }, "never collide: both are static" },
    { { sensor = true }, {}, "objects.b[1] is a sensor" },
    { { oneWay = "top" }, {}, "objects.b[1] is solid only at its top" },
    { { canCollide = function() end }, {}, "canCollide of objects.b[1] may refuse" },
  }) do
    it("says: " .. row[3], function()
      local world = still()
      local a = world:add("a", box(0, 0, 10, 10, row[2]))
      local b = world:add("b", box(0, 0, 10, 10, row[1]))
      local sentence = world:explain(a, b)
      assert.is_truthy(sentence:find(NAMES, 1, true), sentence)
      assert.is_truthy(sentence:find(row[3], 1, true), sentence)
    end)
  end

  it("says which object is not there and which masks are the world's", function()
    local world = still({ masks = { a = { b = false } } })
    local a, b = world:add("a", box(0, 0, 1, 1)), world:add("b", box(0, 0, 1, 1))
    local text = 'the world\'s masks let "a" pass through "b"'
    assert.is_truthy(world:explain(b, a):find(text, 1, true))
    assert.is_truthy(world:explain(a, a):find("same object", 1, true))
    assert.is_truthy(world:explain(a, {}):find("b is not in the world", 1, true))
    assert.is_truthy(world:explain({}, {}):find("neither is in the world", 1, true))
  end)
end)

-- (Wrong numbers and tables are in bad_matrix_spec.)
describe("a question refuses", function()
  for _, row in ipairs({
    { "queryPoint", { 1, 2, true }, "queryPoint(x, y): filter must be a group name" },
    {
      "queryPoint",
      { 1, 2, { {} } },
      "filter[1] must be a group name, got table (the name of a group, not its table)",
    },
    { "queryPoint", { 1, 2, { boxes = true } }, "queryPoint(x, y): filter must be a group name" },
    { "queryRect", { 1, 2, 0, 4 }, "queryRect(x, y, w, h): w must be a number > 0, got 0" },
    { "nearest", { 1, 2, -1 }, "nearest(x, y, radius): radius must be a number >= 0, got -1" },
    {
      "sweep",
      { {}, 2, 3 },
      "sweep(object, dx, dy): the object is not in the world (removed, or never added)",
    },
    {
      "overlapping",
      { {} },
      "overlapping(object): the object is not in the world (removed, or never added)",
    },
    { "touching", { {}, {} }, "touching(a, b): a is not in the world (removed, or never added)" },
  }) do
    it(row[3], function()
      local world, given = four(), row[2]
      local ok, message = pcall(function()
        world[row[1]](world, given[1], given[2], given[3], given[4])
      end)
      assert.is_false(ok)
      assert.is_truthy(message:find("physics: world:", 1, true), message)
      assert.is_truthy(message:find(row[3], 1, true), message)
      assert.is_truthy(message:find("query_spec.lua", 1, true), message)
    end)
  end
end)
