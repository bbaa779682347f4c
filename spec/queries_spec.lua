--- Questions: queryPoint, queryRect, querySegment, raycast, sweep, nearest, overlapping, touching,
--- explain. (Circles are in queries_circles_spec, wrong arguments in debugging_bad_input_spec.)

local box = require("spec.support.box")
local effort = require("spec.support.effort")
local garbage = require("spec.support.garbage")
local newRandom = require("spec.support.random").new
local physics = require("physics")
local script = require("spec.support.script")

local unpack = rawget(table, "unpack") or rawget(_G, "unpack")

local long = effort.isFirst and it or pending

-- A box; its fields are kept by `box`.
local function sized(x, y, width, height, fields)
  local object = box(x, y, fields)
  object.width, object.height = width, height
  return object
end

local function tile(x, y, width, height)
  return sized(x, y, width, height, { static = true })
end

local function still(settings)
  local world = physics.newWorld(settings)
  world.gravity = settings and settings.gravity or 0
  return world
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

local function isFour(object)
  return object.name == "4"
end

local function isEven(object)
  return object.name % 2 == 0
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
  world:add("a", sized(0, 0, 20, 20, { name = "1", static = true }))
  world:add("a", sized(20, 0, 20, 20, { name = "2" }))
  world:add("b", sized(15, 10, 10, 20, { name = "3", sensor = true }))
  world:add("c", sized(60, 10, 20, 20, { name = "4", kinematic = true }))
  return world
end

describe("queryPoint, queryRect, querySegment and overlapping", function()
  for _, row in ipairs({
    -- what, the method, its arguments, which are found, and which with `sideBySide`
    { "in one", "queryPoint", { 5, 5 }, "1" },
    { "on a left and top edge", "queryPoint", { 0, 0 }, "1" },
    { "on a seam", "queryPoint", { 20, 5 }, "2" },
    { "on a right edge", "queryPoint", { 40, 5 }, "" },
    { "on a bottom edge", "queryPoint", { 65, 30 }, "" },
    { "where three are, in order", "queryPoint", { 21, 15 }, "2 3" },
    { "of a group", "queryPoint", { 21, 15, "a" }, "2" },
    { "all", "queryRect", { -100, -100, 300, 300 }, "1 2 3 4" },
    { "inside one", "queryRect", { 2, 2, 3, 3 }, "1" },
    { "flush", "queryRect", { 40, 0, 20, 40 }, "", "2 4" },
    { "flush by rounding", "queryRect", { 40 - 1e-8, 0, 5, 40 }, "", "2" },
    { "corner to corner", "queryRect", { 80, 30, 5, 5 }, "", "4" },
    { "a little in", "queryRect", { 39.999, 0, 5, 40 }, "2" },
    { "of a group", "queryRect", { -10, -10, 100, 100, "a" }, "1 2" },
    { "of two groups", "queryRect", { -10, -10, 100, 100, { "c", "b" } }, "3 4" },
    { "of no group", "queryRect", { -10, -10, 100, 100, {} }, "" },
    { "by a function", "queryRect", { -10, -10, 100, 100, isEven }, "2 4" },
    { "nearest first", "querySegment", { -10, 15, 100, 15 }, "1 3 2 4" },
    { "the other way", "querySegment", { 100, 15, -10, 15 }, "4 2 3 1" },
    { "past all", "querySegment", { -10, 50, 100, 50 }, "" },
    { "by a function", "querySegment", { -10, 15, 100, 15, isEven }, "2 4" },
    { "of the first", "overlapping", { 1 }, "3", "2 3" },
    { "of the sensor", "overlapping", { 3 }, "1 2" },
    { "by a function", "overlapping", { 3, isEven }, "2" },
  }) do
    it(row[2] .. " finds: " .. row[1], function()
      for _, sideBySide in ipairs({ false, true }) do
        local world, out, given =
          four({ sideBySide = sideBySide }), { "a", "b", "c", "d", "e" }, row[3]
        if row[2] == "overlapping" then
          given = { ({ world.objects.a[1], nil, world.objects.b[1] })[given[1]], given[2] }
        end
        local expected = sideBySide and row[5] or row[4]
        local args = { world, given[1], given[2], given[3], given[4], given[5] }
        local count = row[2] == "queryPoint" and 4 or row[2] == "overlapping" and 3 or 6
        assert.are.equal(expected, names(world[row[2]](unpack(args, 1, count))))
        args[count + 1] = out -- the list of an earlier call, filled to its end
        assert.are.equal(out, (world[row[2]](unpack(args, 1, count + 1))))
        assert.are.equal(expected, names(out, #out))
      end
    end)
  end

  it("querySegment tells equal ones in order", function()
    local world = still()
    for i = 1, 5 do
      world:add("b", sized(10, 3 * i, 5, 30, { name = tostring(i) }))
    end
    assert.are.equal("1 2 3 4 5", names(world:querySegment(0, 20, 50, 20)))
  end)

  it("overlapping finds nothing for what is not active", function()
    local world = four()
    world.objects.b[1].active = false
    assert.are.equal("", names(world:overlapping(world.objects.b[1])))
  end)
end)

describe("raycast", function()
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
    { "shorter than can be divided by", { 15, 15, 15, 15 + 1e-310 }, { 15, 15, 0, 0, 0 } },
    { "up to a corner", { 0, 0, 10, 10 }, { 10, 10, 0, -1, 1 } },
    { "from a corner, inwards", { 10, 10, 40, 40 }, { 10, 10, 0, -1, 0 } },
    { "from a corner, outwards", { 10, 10, 0, 0 } },
    { "a little under its top", { 0, 10.0005, 40, 10.0005 }, { 10, 10.0005, -1, 0, 0.25 } },
    { "a little over its bottom", { 0, 19.9995, 40, 19.9995 }, { 10, 19.9995, -1, 0, 0.25 } },
    { "a little in its left", { 10.0005, 0, 10.0005, 40 }, { 10.0005, 10, 0, -1, 0.25 } },
    { "a little in its right", { 29.9995, 0, 29.9995, 40 }, { 29.9995, 10, 0, -1, 0.25 } },
  }) do
    it("answers: " .. row[1], function()
      for _, static in ipairs({ true, false }) do
        local world = still()
        local object = world:add("b", sized(10, 10, 20, 10, { static = static }))
        local l, expected = row[2], row[3]
        for _ = 1, 2 do
          local hit, x, y, nx, ny, fraction = world:raycast(l[1], l[2], l[3], l[4])
          assert.are.equal(expected and object, hit)
          if expected then
            assert.are.same(expected, { x, y, nx, ny, fraction })
            for _, number in ipairs({ x, y, nx, ny, fraction }) do
              assert.is_true(number ~= 0 or 1 / number > 0) -- no negative zero
            end
          else
            assert.are.equal(0, select("#", world:raycast(l[1], l[2], l[3], l[4])))
          end
          world:update(1 / 60) -- from here on its box has no margin
        end
      end
    end)
  end

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

  it("finds the nearest, however far it is", function()
    local world = still()
    for i = 1, 300 do
      world:add("c", tile(20 * i, 50, 16, 16))
    end
    for _, x in ipairs({ 1e6, 1e6 - 20, 1e5, 1e4, 3000, 300, 12 }) do
      local near = world:add("b", sized(x, 0, 10, 10))
      assert.are.equal(near, (world:raycast(0, 5, 2e6, 5)))
      assert.are.equal(near, (world:raycast(x + 10, 5, -5000, 5)))
    end
  end)
end)

describe("nearest", function()
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

describe("sweep", function()
  local function scene(fields)
    local world = still()
    local object = world:add("a", sized(0, 0, 10, 10, { name = "me" }))
    local wall = world:add("b", sized(30, 5, 10, 30, fields))
    return world, object, wall
  end

  -- The wall, the way, and what is told; far away others stand beside the way.
  for _, row in ipairs({
    { "against a side", { 30, 5, 10, 30 }, { 40, 0 }, { 20, 0, -1, 0, 0.5 } },
    { "past it", { 30, 5, 10, 30 }, { 40, -10 }, nil },
    { "just short of it", { 30, 5, 10, 30 }, { 20, 0 }, nil },
    { "onto the top", { 30, 5, 10, 30 }, { 60, 30 }, { 20, 10, -1, 0, 1 / 3 } },
    { "downwards", { 30, 5, 10, 30 }, { 0, 40 }, nil },
    { "far to the right", { 1000, 0, 15, 15 }, { 3000, 0 }, { 990, 0, -1, 0, 0.33 } },
    { "far to the left", { -1000, 0, 15, 15 }, { -3000, 0 }, { -985, 0, 1, 0, 985 / 3000 } },
    { "far down", { 0, 1000, 15, 15 }, { 0, 3000 }, { 0, 990, 0, -1, 0.33 } },
    { "far up", { 0, -1000, 15, 15 }, { 0, -3000 }, { 0, -985, 0, 1, 985 / 3000 } },
  }) do
    it("answers: " .. row[1], function()
      for _, fields in ipairs({ {}, { static = true }, { kinematic = true } }) do
        local world, object, wall = scene(fields)
        wall.x, wall.y, wall.width, wall.height = unpack(row[2])
        world:refresh(wall)
        for i = 2, 60 do
          world:add("c", tile(100 * i, 20, 15, 15))
          world:add("c", tile(-100 * i, -20, 15, 15))
        end
        local other, x, y, nx, ny, fraction = world:sweep(object, row[3][1], row[3][2])
        assert.are.equal(row[4] and wall, other)
        if row[4] then
          assert.are.near(row[4][5], fraction, 1e-12)
          assert.are.same(row[4], { x, y, nx, ny, row[4][5] })
        end
        assert.are.same({ 0, 0 }, { object.x, object.y })
      end
    end)
  end

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
      for owner, fields in pairs({ [wall] = row[1], [object] = row[2], [world] = row[3] }) do
        for name, value in pairs(fields) do
          owner[name] = value
        end
      end
      assert.is_nil(world:sweep(object, 40, 0))
    end
  end)

  it("reports at once what it is inside of", function()
    local world, object, wall = scene()
    object.x = 25
    assert.are.same({ wall, 25, 0, 0, 0, 0 }, { world:sweep(object, 40, 0) })
  end)
end)

describe("filter", function()
  it("is a group, a list of groups or a function in raycast, nearest and sweep, too", function()
    local world = four()
    assert.are.equal("4", world:raycast(-10, 15, 100, 15, "c").name)
    assert.are.equal("4", world:raycast(-10, 15, 100, 15, isFour).name)
    assert.are.equal("3", world:raycast(-10, 15, 100, 15, { "b", "c" }).name)
    assert.are.equal("4", world:nearest(0, 0, 1000, isFour).name)
    assert.is_nil(world:sweep(world.objects.a[2], 100, 5, "a"))
    assert.are.equal("4", world:sweep(world.objects.a[2], 100, 5, isFour).name)
  end)

  it("may ask questions of its own, and fail", function()
    local world = four()
    local function isAlone(object)
      world:nearest(500, 5, 1000)
      world:raycast(500, 5, -500, 5)
      return 0
        == select(
          2,
          world:overlapping(object, function(other)
            return other ~= object
          end)
        )
    end
    assert.are.equal("4", names(world:queryRect(-10, -10, 100, 100, isAlone)))
    local hit, x = world:raycast(-10, 15, 100, 15, isAlone)
    assert.are.same({ "4", 60 }, { hit.name, x })
    assert.are.equal(10, select(2, world:nearest(50, 15, 100, isAlone)))
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
    assert.are.equal("1234", table.concat(asked))
  end)
end)

describe("queryPoint, raycast and nearest in a world of 600", function()
  -- A world with many objects.
  local function build()
    local world = still()
    for i = 1, 300 do
      world:add("tiles", tile(20 * i, 1000, 16, 16))
      world:add("boxes", sized(20 * i, 2000, 16, 16))
    end
    return world
  end

  -- Fails unless this object is what all find at x .. x + 10, y = 0 .. 10 (nil: nothing is).
  local function expect(world, object, x)
    local count = object and 1 or 0
    assert.are.same({ object }, (world:queryPoint(x + 9.5, 5)))
    assert.are.equal(count, select(2, world:queryRect(x + 1, 1, 8, 8)))
    assert.are.equal(count, select(2, world:querySegment(x + 0.5, -50, x + 0.5, 50)))
    assert.are.equal(object, (world:raycast(x + 9.5, -50, x + 9.5, 50)))
    assert.are.equal(object, (world:raycast(x - 5, 9.5, x + 15, 9.5)))
    assert.are.equal(object, (world:nearest(x + 5, 15, 6)))
  end

  for kind, fields in pairs({ dynamic = {}, kinematic = { kinematic = true } }) do
    it("see what the game wrote, before and after an update: " .. kind, function()
      local world = build()
      local object = world:add("a", sized(0, 0, 10, 10, fields))
      for step = 1, 4 do
        local x = 100 * step
        object.x = x
        expect(world, object, x)
        object.x = x + 3 -- a question was asked before
        expect(world, object, x + 3)
        assert.is_nil(world:queryPoint(x + 2, 5)[1])
        object.width = 3
        assert.is_nil(world:queryPoint(x + 12, 5)[1])
        object.width, object.active = 10, false
        expect(world, nil, x + 3)
        object.active = true
        if step > 2 then
          world:update(1 / 60)
        end
      end
    end)
  end

  it("see a static object where the library has read it", function()
    local world = build()
    local object = world:add("a", tile(0, 0, 10, 10))
    object.x = 50 -- not read yet
    expect(world, object, 50)
    world:update(1 / 60)
    object.x = 100
    expect(world, object, 50)
    world:refresh(object)
    expect(world, nil, 50)
    expect(world, object, 100)
  end)

  for _, isStatic in ipairs({ false, true }) do
    local kind = isStatic and "static" or "dynamic"
    -- As from a pool: it is the same table as before, in the same world.
    it("see what was removed, put elsewhere and added again: " .. kind, function()
      local world = build()
      local object = world:add("a", sized(0, 0, 10, 10, { static = isStatic }))
      world:update(1 / 60)
      for x = 100, 300, 100 do
        expect(world, object, x - 100)
        world:remove(object)
        object.x = x
        world:add(x == 200 and "b" or "a", object)
        for _ = 1, 2 do
          expect(world, nil, x - 100)
          expect(world, object, x)
          world:update(1 / 60)
        end
      end
      world:remove(object)
      object.static, object.vx = not isStatic, 60
      world:add("a", object)
      world:update(1 / 60)
      expect(world, object, isStatic and 301 or 300)
    end)

    it("see what came, went and was replaced: " .. kind, function()
      local world = build()
      local function new(x)
        return sized(x, 0, 10, 10, { static = isStatic })
      end
      world:update(1 / 60)
      local first, objects = world:add("a", new(0)), world.objects
      expect(world, first, 0)
      objects.a[2] = new(50)
      expect(world, objects.a[2], 50)
      world:remove(first)
      expect(world, nil, 0)
      objects.a[1] = new(100) -- takes the place
      expect(world, nil, 50)
      expect(world, objects.a[1], 100)
      objects.a[1], objects.c = nil, { hero = new(150) }
      expect(world, nil, 100)
      expect(world, objects.c.hero, 150)
      objects.c = nil
      expect(world, nil, 150)
      world:setBounds(300, 0, 50, 50)
      assert.are.same({ objects.bounds.left }, (world:queryPoint(299, 5)))
      world:setBounds(400, 0, 50, 50)
      expect(world, nil, 290)
    end)
  end

  it("refuse what an update would refuse", function()
    local world = build()
    local object = world:add("a", sized(0, 0, 10, 10))
    world:queryPoint(5, 5)
    for _, row in ipairs({
      { "y", 0 / 0, "must be a number, got nan" },
      { "x", 1e150, "must be a number in -1e+100..1e+100, got 1e+150" },
      { "width", 1 / 0, "must be a finite number > 0, got inf" },
      { "height", -1, "must be a number > 0, got -1" },
      { "active", "yes", 'must be true or false, got "yes"' },
    }) do
      local field, before = row[1], object[row[1]]
      object[field] = row[2]
      local ok, message = pcall(world.queryPoint, world, 5, 5)
      assert.is_false(ok)
      local text = ("physics: objects.a[1].%s %s"):format(field, row[3])
      assert.is_truthy(message:find(text, 1, true), message)
      object[field] = before
      expect(world, object, 0)
    end
  end)

  it("find among 1001 what was refreshed, and say under checked what they miss", function()
    local world = still()
    for n = 1, 1001 do
      world:add("boxes", sized(40 * n, 500, 10, 10))
    end
    world:update(1 / 60)
    expect(world, nil, 0)
    local object = world.objects.boxes[7]
    object.x, object.y = 0, 0
    expect(world, nil, 0)
    world.checked = true
    local ok, message = pcall(world.queryPoint, world, 5, 5)
    assert.is_false(ok)
    assert.matches("objects.boxes%[7%] was moved .* world:refresh%(object%)", message)
    world:refresh(object)
    expect(world, object, 0)
    world:move(object, 90, 0)
    expect(world, object, 90)
  end)
end)

describe("queryRect and the others", function()
  it("leaves no garbage", function()
    local world, out = four(), {}
    local object = world.objects.a[2]
    local function ask()
      world:queryRect(-10, -10, 100, 100, "a", out)
      world:queryPoint(5, 5, nil, out)
      world:querySegment(-10, 15, 100, 15, nil, out)
      world:raycast(-10, 15, 100, 15)
      world:nearest(50, 15, 100)
      world:sweep(object, 100, 5)
      world:overlapping(object, nil, out)
      world:touching(object, world.objects.a[1])
    end
    assert.is_true(garbage.bytes(ask, 200, 100) <= 100)
  end)

  it("may be asked inside canCollide and inside events; only in these it may be moved", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("floor", tile(0, 100, 200, 20))
    local object = world:add("a", sized(0, 50, 10, 10))
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
    assert.are.same({ "bottom", 1, 1 }, { told, answers[1], object.x })
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

  -- Whether a line from (x1, y1) by (dx, dy) passes through the inside of a box; nil: nearly.
  local function passes(o, x1, y1, dx, dy)
    local first, last = 0, 1
    for _, row in ipairs({ { x1, dx, o.x, o.width }, { y1, dy, o.y, o.height } }) do
      local from, way, low, high = row[1], row[2], row[3], row[3] + row[4]
      if way == 0 then
        way = 1e-300
      end
      local a, b = (low - from) / way, (high - from) / way
      first, last = math.max(first, math.min(a, b)), math.min(last, math.max(a, b))
    end
    return last - first > 1e-9 or last - first < -1e-9 and false or nil
  end

  -- (The others are compared in queries_circles_spec.lua.)
  long("finds what a line through all objects finds", function()
    for seed = 1, 10 do
      local random, world, all = newRandom(seed), still(), {}
      local ox, oy = random:pick({ 0, 0, -1700 }), random:pick({ 0, 0, 1000 })
      for i = 1, random:integer(5, 300) do
        local size = random:pick({ 4, 16, 16, 64, 300 })
        local x, y = ox + 8 * random:integer(-50, 50), oy + 8 * random:integer(-50, 50)
        local fields = { i = i, static = random:chance(0.5) }
        all[i] = world:add("b", sized(x, y, random:between(1, size), size, fields))
      end
      for round = 1, 12 do
        local x1, y1 = ox + 4 * random:integer(-120, 120), oy + 4 * random:integer(-120, 120)
        local x2, y2 = random:pick({ x1, ox + 4 * random:integer(-120, 120) }), oy
        y2 = y2 + random:between(-500, 500)
        -- A ray is what the segment finds first.
        local line, n = world:querySegment(x1, y1, x2, y2)
        assert.are.equal(line[1], (world:raycast(x1, y1, x2, y2)))
        local isOn = {}
        for i = 1, n do
          assert.is_nil(isOn[line[i]])
          isOn[line[i]] = true
        end
        for _, o in ipairs(all) do
          local is = passes(o, x1, y1, x2 - x1, y2 - y1)
          assert(is == nil or is == (isOn[o] or false), ("seed %d: %d"):format(seed, o.i))
        end
        local moved = all[random:integer(1, #all)]
        moved.x = moved.x + (moved.static and 0 or random:pick({ 3, -5, 200 }))
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
    local object = world:add("a", box(0, 84))
    local neighbour = world:add("a", box(16, 84))
    local coin = world:add("coins", sized(4, 90, 8, 8, { sensor = true, static = true }))
    local far = world:add("a", box(150, 84))
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
end)

describe("explain", function()
  local NAMES = "objects.a[1] and objects.b[1] "
  for _, row in ipairs({
    { { x = 30 }, {}, "can collide: now they are 20 px apart on x." },
    { { x = 4, y = 20 }, {}, "can collide: now they are 10 px apart on y." },
    { { x = 30, y = 15 }, {}, "can collide: now they are 20 px apart on x and 5 px on y." },
    { { x = 10 }, {}, "can collide: now they are flush at the right of objects.a[1]." },
    { { x = 10, y = 10 }, {}, "can collide: now they are flush at a corner only" },
    { { x = 9, y = 10 }, {}, "can collide: now they are flush at the bottom of objects.a[1]." },
    { { x = 8 }, {}, "can collide: now they overlap by 2 x 10 px." },
    { { active = false }, {}, "never collide: objects.b[1] is not active." },
    {
      {},
      { mask = { b = false } },
      'never collide: the mask of objects.a[1] refuses the group "b".',
    },
    { { static = true }, { kinematic = true }, "one is kinematic and the other static" },
    { { static = true }, { static = true }, "never collide: both are static" },
    { { sensor = true }, {}, "objects.b[1] is a sensor" },
    { { oneWay = "top" }, {}, "objects.b[1] is solid only at its top" },
    { { oneWay = true }, {}, "objects.b[1] is solid only at its top" },
    { { canCollide = function() end }, {}, "canCollide of objects.b[1] may refuse" },
  }) do
    it("says: " .. row[3], function()
      local world = still()
      local a = world:add("a", sized(0, 0, 10, 10, row[2]))
      local b = world:add("b", sized(row[1].x or 0, row[1].y or 0, 10, 10, row[1]))
      local sentence = world:explain(a, b)
      assert.is_truthy(sentence:find(NAMES, 1, true), sentence)
      assert.is_truthy(sentence:find(row[3], 1, true), sentence)
    end)
  end

  it("says which object is not there, what the world's masks and its canCollide do", function()
    local world = still({ masks = { a = { b = false } } })
    local a, b = world:add("a", box(0, 0)), world:add("b", box(0, 0))
    local text = 'the world\'s masks let "a" pass through "b"'
    assert.is_truthy(world:explain(b, a):find(text, 1, true))
    assert.is_truthy(world:explain(a, a):find("same object", 1, true))
    assert.is_truthy(world:explain(a, {}):find("b is not in the world", 1, true))
    assert.is_truthy(world:explain({}, {}):find("neither is in the world", 1, true))
    world.masks, world.canCollide = nil, function() end
    assert.is_truthy(world:explain(a, b):find("canCollide of the world may refuse", 1, true))
  end)
end)
