--- Questions in worlds of many objects that come, go and are written: the answers are those of a
--- plain loop over all of them, and nothing changes by asking.

local effort = require("spec.support.effort")
local newRandom = require("spec.support.random").new
local physics = require("physics")
local small = require("spec.support.small")

local sized, still, tile = small.put, small.still, small.tile

local long = effort.isFirst and it or pending

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

  local kinds = { dynamic = {}, kinematic = { kinematic = true } }
  small.each("see what the game wrote, before and after an update: {1}", kinds, function(_, fields)
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

  it("see what the game has put flush to a rectangle, with sideBySide", function()
    local world = physics.newWorld({ sideBySide = true })
    local object = world:add("a", sized(50, 50, 10, 10))
    world:update(1 / 60)
    for _, place in ipairs({ { 0, 10 }, { 10, 0 }, { 0, -10 }, { -10, 0 } }) do
      object.x, object.y = place[1], place[2]
      assert.equal(1, select(2, world:queryRect(0, 0, 10, 10)))
    end
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
      { "height", 0, "must be a number > 0, got 0" },
      { "height", 1e150, "must be a number > 0 and <= 1e+100, got 1e+150" },
      { "active", "yes", 'must be true or false, got "yes"' },
    }) do
      local field, before = row[1], object[row[1]]
      object[field] = row[2]
      local text = ("objects.a[1].%s %s"):format(field, row[3])
      small.refuses(text, world.queryPoint, world, 5, 5)
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
    small.refuses("objects.boxes[7] was moved", world.queryPoint, world, 5, 5)
    world:refresh(object)
    expect(world, object, 0)
    world:move(object, 90, 0)
    expect(world, object, 90)
  end)
end)

describe("queryRect and the others", function()
  it("wake no object that is not active, if the masks change before it is read", function()
    local world = physics.newWorld({ gravity = 600 })
    local object = world:add("a", sized(10, 80, 20, 20, { active = false }))
    world:queryRect(0, 0, 200, 200)
    world.masks = { a = { b = false } }
    small.run(world, 5)
    assert.are.equal(80, object.y)
  end)

  -- Plays a game in which objects come, go and change their places in the tables, and returns what
  -- was told. With `isAsked` it asks a question after each change.
  local function play(seed, isAsked)
    local random, told, world = newRandom(seed), {}, physics.newWorld({ gravity = 600 })
    world.masks = { a = { b = false } }
    local groups, objects, count = { "a", "b", 3 }, world.objects, 0
    local asked = 0
    local function note(name)
      return function(one, other, side)
        told[#told + 1] = ("%s %s %s %s"):format(name, one.name, other.name, tostring(side))
      end
    end
    world.onBegin, world.onEnd = note("begin"), note("end")
    world:add("floors", small.set(tile(0, 100, 200, 16), { name = "floor" }))
    local acts = {
      function(members, n) -- comes, also in the middle, by the game's own hand
        count = count + 1
        local isStatic = random:chance(0.2)
        local y = random:integer(0, 80)
        local object = sized(random:integer(0, 180), y, 12, 12, { static = isStatic, name = count })
        table.insert(members, n, object)
      end,
      function(members, n) -- goes
        world:remove(members[n] or {})
      end,
      function(members, n) -- goes to another group
        local object = table.remove(members, n)
        if object then
          world:add(random:pick(groups), object)
        end
      end,
      function(members, n) -- is gone for the length of a question
        local object = members[n]
        table.remove(members, n)
        local _ = isAsked and world:queryPoint(0, 0)
        table.insert(members, n, object)
      end,
      function(members, n) -- is elsewhere for the length of a question
        local object = members[n] or {}
        local x = object.x
        object.x = 500
        local _ = isAsked and world:queryPoint(505, 0)
        object.x = x
      end,
    }
    for _, group in ipairs(groups) do
      objects[group] = {}
    end
    for _ = 1, 40 do
      for _ = 1, 4 do
        local members = objects[random:pick(groups)]
        random:pick(acts)(members, random:integer(1, #members + 1))
        asked = asked + 1
        local _ = isAsked and asked % 3 > 0 and world:queryRect(0, 0, 50, 50)
      end
      world:update(1 / 60)
      told[#told + 1] = ("%.0f"):format(world:hash())
    end
    return told
  end

  it("change nothing by asking, whatever comes and goes meanwhile", function()
    for seed = 1, 12 do
      assert.are.same(play(seed, false), play(seed, true))
    end
  end)

  it("change no order of contacts that end, nor a hash, if the lists change around them", function()
    local hashes = {}
    for n, isAsked in ipairs({ false, true }) do
      local world, told = physics.newWorld({ gravity = 600 }), {}
      local function ask()
        return isAsked and world:queryPoint(0, 0)
      end
      world:add("floors", small.set(tile(0, 100, 200, 16), { name = "floor" }))
      local lower = world:add("crates", sized(50, 80, 20, 20, { name = "lower" }))
      local upper = world:add("crates", sized(50, 60, 20, 20, { name = "upper" }))
      small.run(world, 3)
      function world.onEnd(one, other)
        told[#told + 1] = one.name .. " " .. other.name
      end
      world.objects.crates = { upper, lower }
      ask()
      world.objects.crates = {}
      ask()
      hashes[n] = world:hash()
      world:update(1 / 60)
      assert.are.same({ "lower upper", "lower floor" }, told)
    end
    assert.are.equal(hashes[1], hashes[2])
  end)

  it("may be asked inside canCollide and inside events; only in these it may be moved", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("floor", tile(0, 100, 200, 20))
    local object = world:add("a", sized(0, 50, 10, 10))
    local answers, told = {}, nil
    function object.canCollide(self)
      answers[#answers + 1] = #world:queryPoint(self.x + 5, self.y + 5)
      small.refuses("cannot be called from inside canCollide", world.move, world, self, 0, 0)
      return true
    end
    function object.onBegin(self, other)
      told = world:touching(self, other)
      world:move(self, self.x + 1, self.y)
    end
    small.run(world, 60)
    assert.are.same({ "bottom", 1, 1 }, { told, answers[1], object.x })
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
