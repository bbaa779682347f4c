--- Questions: queryPoint, queryRect, querySegment, overlapping, nearest, touching, velocity, fits,
--- and their filters. (Rays, circles, moves and worlds of many objects have files of their own.)

local garbage = require("spec.support.garbage")
local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local box, sized, still, tile = small.box, small.put, small.still, small.tile

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
  local OLD = { name = "old" }
  small.rows("{2} finds: {1}", {
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
    { "of the first", "overlapping", { "a" }, "3", "2 3" },
    { "of the sensor", "overlapping", { "b" }, "1 2" },
    { "by a function", "overlapping", { "b", isEven }, "2" },
  }, function(_, method, given, plain, flush)
    for _, sideBySide in ipairs({ false, true }) do
      local world, out = four({ sideBySide = sideBySide }), { OLD, OLD, OLD, OLD, OLD }
      local args = { world, small.unpack(given, 1, 5) }
      if method == "overlapping" then
        args[2] = world.objects[given[1]][1]
      end
      local expected = sideBySide and flush or plain
      local count = method == "queryPoint" and 4 or method == "overlapping" and 3 or 6
      assert.are.equal(expected, names(world[method](small.unpack(args, 1, count))))
      args[count + 1] = out -- the list of an earlier call, filled to its end
      assert.are.equal(out, (world[method](small.unpack(args, 1, count + 1))))
      assert.are.equal(expected, names(out, #out))
    end
  end)

  it("querySegment tells equal ones in order", function()
    local world = still()
    for i = 1, 5 do
      world:add("b", sized(10, 3 * i, 5, 30, { name = tostring(i) }))
    end
    assert.are.equal("1 2 3 4 5", names(world:querySegment(0, 20, 50, 20)))
  end)

  it("leave no garbage, nor do the others", function()
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

  it("overlapping finds nothing for what is not active", function()
    local world = four()
    world.objects.b[1].active = false
    assert.are.equal("", names(world:overlapping(world.objects.b[1])))
  end)
end)

small.rows("nearest answers: {1}", {
  { "inside", 5, 5, 10, "1", 0 },
  { "left of one", -3, 5, 10, "1", 3 },
  { "off a corner", 83, 34, 10, "4", 5 },
  { "equal ones, in order", 50, 15, 100, "2", 10 },
  { "at the edge of the radius", -3, 5, 3, "1", 3 },
  { "too far", -3, 5, 2.99, nil, nil },
  { "far away", -3000, 0, 1e7, "1", 3000 },
  { "no radius", 5, 5, 0, "1", 0 },
}, function(_, x, y, r, name, px)
  local object, distance = four():nearest(x, y, r)
  assert.are.equal(name, object and object.name)
  assert.are.equal(px, distance)
end)

describe("filter: it", function()
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
      local function isOther(other)
        return other ~= object
      end
      return select(2, world:overlapping(object, isOther)) == 0
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

it("world:touching answers with the side of the first", function()
  local world = physics.newWorld({ gravity = 800 })
  local floor = world:add("floor", tile(0, 100, 200, 20))
  local object = world:add("a", box(0, 84))
  local neighbour = world:add("a", box(16, 84))
  local coin = world:add("coins", sized(4, 90, 8, 8, { sensor = true, static = true }))
  local far = world:add("a", box(150, 84))
  assert.is_nil(world:touching(object, floor))
  world:update(1 / 60)
  assert.same({ "bottom", "top" }, { world:touching(object, floor), world:touching(floor, object) })
  assert.is_nil(world:touching(object, neighbour))
  assert.is_string(world:touching(object, coin))
  world.sideBySide = true
  assert.are.equal("right", world:touching(object, neighbour))
  object.y = 50
  assert.is_nil(world:touching(object, floor))
  assert.is_nil(world:touching(object, object))
  world.sideBySide, far.x, far.y = false, 16, 50 -- put there, not come
  assert.is_nil(world:touching(object, far))
  world.sideBySide = "no"
  assert.has_error(function()
    world:queryRect(0, 0, 10, 10)
  end)
end)

-- Velocities and room -------------------------------------------------------------------------

local man = scene.thing("men", { name = "man", x = 0, y = 0, width = 8, height = 8 })
local solid = scene.maker("tiles", { static = true })
local lift = scene.maker("lifts", { kinematic = true })

describe("world:velocity", function()
  local function onLift(v)
    return { lift("lift", 0, 100, 100, 8, { vx = v.vx, vy = v.vy }), man({ x = 40, y = 92 }) }
  end
  -- Its velocity as a line of a row sees it.
  local row = play.with({
    ofX = function(world, view)
      return (world:velocity(view.raw))
    end,
    ofY = function(world, view)
      return (select(2, world:velocity(view.raw)))
    end,
  })

  row("is that of the rider and of its carrier", play.ONCE, onLift, {
    { "run:play(1 / 6); man.vx = 25" },
    "ofX(world, man) ~ 65; ofY(world, man) ~ -20; ofX(world, lift) ~ 40",
    { steps = 1 },
    "ofX(world, man) ~ 65; man.vx ~ 25",
  }, { "vx, vy", { 40, -20 } })

  row("knows a lift that the game puts elsewhere", play.ONCE, onLift, {
    1 / 6,
    { steps = 5, keep = "lift.x, lift.y = lift.x + 1, lift.y - 0.5" },
    "ofX(world, lift) ~ 60; ofY(world, lift) ~ -30; ofX(world, man) ~ 60; ofY(world, man) ~ -30",
    { "state = world:save()", 1 / 12, "ofX(world, lift) == 0; ofX(world, man) == 0" },
    "world:restore(state); ofX(world, lift) ~ 60; ofX(world, man) ~ 60",
  }, { "vx", { 0 } })

  row("is the speed of the jump that comes, and what it has after it", play.ONCE, onLift, {
    { "run:play(1 / 6); man.vy = -300; ofY(world, man) ~ -360" },
    { steps = 1 },
    "man.vy ~ -360 + 800 / 60; ofY(world, man) ~ man.vy",
  }, { "vx, vy", { 0, -60 } })

  row("counts belts, stacks, and what does not move or was not read yet", play.ONCE, {
    solid("belt", 0, 100, 900, 16, { surfaceSpeed = 30 }),
    man({ x = 40, y = 92 }),
    man({ name = "top", x = 40, y = 84 }),
  }, {
    1 / 6,
    "ofX(world, man) ~ 30; ofX(world, top) ~ 30; ofX(world, belt) == 0; ofY(world, belt) == 0",
    "new = world:add('men', { x = 400, y = 0, width = 4, height = 4, vx = 3, vy = 4 })",
    "(world:velocity(new)) == 3; select(2, world:velocity(new)) == 4",
  })
end)

describe("world:fits", function()
  local function newScene()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", tile(0, 100, 200, 16))
    world:add("tiles", tile(50, 60, 50, 10))
    world:add("ledges", tile(150, 60, 50, 8, { oneWay = "top" }))
    world:add("water", tile(0, 0, 200, 100, { sensor = true }))
    world:add("crates", box(110, 84))
    local one = world:add("men", sized(60, 82, 16, 18))
    world:update(1 / 60)
    return world, one
  end

  it("answers whether an object may stand up", function()
    local world, one = newScene()
    local isFree, other = world:fits(60, 68, 16, 32, one)
    assert.is_false(isFree)
    assert.equal(world.objects.tiles[2], other)
    assert.is_true(world:fits(60, 70, 16, 30, one)) -- flush with the ceiling and the floor
    assert.is_false(world:fits(60, 69.99, 16, 30.01, one))
    assert.is_true(world:fits(20, 60, 16, 40, one))
    assert.is_false(world:fits(100, 60, 16, 40, one)) -- the crate
    assert.is_true(world:fits(160, 50, 16, 50, one)) -- a one-way ledge
    one.mask = { tiles = false }
    assert.is_true(world:fits(60, 68, 16, 32, one))
  end)

  it("answers whether there is room, by groups or by a function", function()
    local world, one = newScene()
    assert.is_false(world:fits(60, 70, 16, 30))
    assert.is_true(world:fits(60, 70, 16, 30, "tiles"))
    assert.is_false(world:fits(60, 70, 16, 30, { "tiles", "men" }))
    assert.is_true(world:fits(60, 70, 16, 30, function(other)
      return other ~= one
    end))
    world.objects.crates[1].active = false
    assert.is_true(world:fits(110, 80, 16, 20))
    local words = "filter must be a group name, a list of them or a function, got false"
    small.refuses("fits(x, y, width, height): " .. words, world.fits, world, 1, 8, 6, 2, false)
  end)

  it("sees what was changed since the last step, and changes nothing", function()
    local world, one = newScene()
    local before = world:hash()
    world:fits(0, 0, 500, 500, one)
    assert.equal(before, world:hash())
    local crate = world:add("crates", { x = 0, y = 0, width = 8, height = 8 })
    assert.is_false(world:fits(4, 4, 8, 8))
    world:remove(crate)
    assert.is_true(world:fits(4, 4, 8, 8))
  end)
end)

it("querySegment: fractions are what raycast returns for each object, in the same order", function()
  local world, fractions = four(), { { x = 1 }, 2, 3, 4, 5 }
  for _, wanted in ipairs({ false, "c", isEven }) do
    local list, count = world:querySegment(-10, 12, 90, 17, wanted or nil, nil, fractions)
    assert.equal(count, #fractions)
    for n = 1, count do
      local hit = {
        world:raycast(-10, 12, 90, 17, function(object)
          return object == list[n]
        end),
      }
      assert.near(hit[6], fractions[n], 1e-15)
    end
  end
  local words = "fractions must be a table, got 3"
  small.refuses(words, world.querySegment, world, 0, 0, 9, 9, nil, nil, 3)
end)

it("cast and castCircle meet what an object of that shape would meet that no mask names", function()
  local random = require("spec.support.random").new(3)
  for seed = 1, 60 do
    local world = still()
    for _ = 1, 12 do
      local x, y = random:between(0, 200), random:between(0, 200)
      local other = world:add("walls", tile(x, y, random:between(8, 40), random:between(8, 40)))
      other.slope = seed % 3 == 0 and "left" or nil
      other.oneWay = seed % 3 == 1 and "top" or nil
      other.sensor = random:between(0, 1) < 0.1
      world:refresh(other)
    end
    local size, dx, dy = random:between(4, 20), random:between(-300, 300), random:between(-300, 300)
    local me = world:add("me", sized(100, 100, size, size))
    me.radius = seed % 2 == 0 and size / 2 or nil
    local expected, found = { world:sweep(me, dx, dy) }
    if me.radius then
      local r = me.radius
      found = { world:castCircle(100 + r, 100 + r, r, dx, dy, "walls") }
      found[2], found[3] = found[2] and found[2] - r, found[3] and found[3] - r
    else
      found = { world:cast(100, 100, size, size, dx, dy, { "walls" }) }
    end
    assert.equal(expected[1], found[1])
    for n = 2, #expected do
      assert.near(expected[n], found[n], 1e-9)
    end
  end
end)

describe("freePlace", function()
  --- The nearest free place on a grid of 1 px.
  local function search(world, x, y, w, h, reach)
    local least
    for ox = -reach, reach do
      for oy = -reach, reach do
        local far = math.sqrt(ox * ox + oy * oy)
        if far <= (least or reach) and world:fits(x + ox, y + oy, w, h) then
          least = far
        end
      end
    end
    return least
  end

  it("is free, and the nearest one: random rooms of whole numbers", function()
    local random = require("spec.support.random").new(5)
    local function whole(low, high)
      return math.floor(random:between(low, high))
    end
    local found = 0
    for _ = 1, 40 do
      local world = still()
      for _ = 1, whole(3, 16) do
        world:add("walls", tile(whole(0, 60), whole(0, 60), whole(4, 30), whole(4, 30)))
      end
      local x, y, w, h, reach = whole(10, 50), whole(10, 50), whole(4, 16), whole(4, 16), 24
      local atX, atY = world:freePlace(x, y, w, h, reach)
      local least = search(world, x, y, w, h, reach)
      assert.equal(least ~= nil, atX ~= nil)
      if atX then
        found = found + 1
        assert.near(least, math.sqrt((atX - x) ^ 2 + (atY - y) ^ 2), 1e-9)
        assert.is_true(world:fits(atX, atY, w, h))
      end
    end
    assert.is_true(found > 20)
  end)

  local CLOUD, WATER = tile(0, 90, 99, 50, { oneWay = "top" }), tile(0, 0, 9, 9, { sensor = true })
  small.rows("is {1}", {
    -- what, what is there, where it should be, where it may be
    { "where it is", { tile(0, 100, 99, 20), CLOUD, WATER }, { 0, 90 }, { 0, 90 } },
    { "on the floor", { tile(0, 100, 99, 20) }, { 40, 93 }, { 40, 90 } },
    { "above, of two as near", { tile(40, 40, 10, 10) }, { 40, 40 }, { 40, 30 } },
    { "on the left, of two near", { tile(0, 0, 30, 99), tile(40, 40, 9, 9), tile(50, 0, 9, 99) } },
    { "in a corner", { tile(0, 50, 99, 9), tile(50, 0, 9, 99) }, { 44, 45 }, { 40, 40 } },
    { "on a slope", { tile(0, 0, 100, 100, { slope = "left" }) }, { 50, 45 }, { 52.5, 42.5 } },
    { "beside a ball", { tile(0, 0, 40, 40, { radius = 20 }) }, { 15, -5 }, { 15, -10 } },
    { "too far away", { tile(0, 0, 999, 999) }, { 500, 500 } },
  }, function(_, there, wanted, expected)
    local world = still()
    for _, object in ipairs(there) do
      world:add("walls", small.set({}, object))
    end
    local at = wanted or { 35, 40 }
    local x, y = world:freePlace(at[1], at[2], 10, 10, 100)
    if expected then
      assert.is_true(world:fits(x, y, 10, 10))
      assert.near(expected[1], x, 1e-6)
      assert.near(expected[2], y, 1e-6)
    elseif wanted then
      assert.is_nil(x)
    else
      assert.same({ 30, 40 }, { x, y })
    end
  end)

  it("takes a filter, or the object that would be there, which is not in its own way", function()
    local world = still()
    world:add("crates", box(0, 0))
    world:add("others", box(4, 0, { mask = { men = false } }))
    local asker = world:add("men", box(2, 0))
    assert.same({ 2, -16 }, { world:freePlace(2, 0, 16, 16, 99) })
    assert.same({ 2, 0 }, { world:freePlace(2, 0, 16, 16, 99, "lamps") })
    assert.same({ 16, 1 }, { world:freePlace(2, 1, 16, 16, 99, asker) })
    local function isNothing()
      return false
    end
    assert.same({ 2, 1 }, { world:freePlace(2, 1, 16, 16, 99, isNothing) })
    assert.is_nil((world:freePlace(2, 0, 16, 16, 15)))
  end)

  it("stays out of what its filter accepts, also where that refuses another one", function()
    local world = still()
    local wall = world:add("crates", { x = 0, y = 0, width = 10, height = 10, static = true })
    world:add("others", { x = 2, y = 2, width = 4, height = 4, static = true })
    local function isWall(object)
      return object == wall
    end
    assert.same({ 1, -8 }, { world:freePlace(1, 1, 8, 8, 50, isWall) })
  end)

  it("takes the same one of places as near, whatever the grid is", function()
    for _, size in ipairs({ 32, 64, 128, 512 }) do
      local world = physics.newWorld({ cellSize = size })
      world:add("walls", { x = 15, y = -300, width = 25, height = 700, static = true })
      world:add("walls", { x = 0, y = -500, width = 20, height = 1000, static = true })
      assert.same({ 40, 0 }, { world:freePlace(15, 0, 10, 10, 60) })
    end
  end)
end)
