--- world:move, and what it, world:impulse and world:setBounds refuse.

local effort = require("spec.support.effort")
local physics = require("physics")
local garbage = require("spec.support.garbage")
local newRandom = require("spec.support.random").new
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")

local box, still = small.put, small.still

local long = effort.isFirst and it or pending

local SHIFTS = { 0, 0.1, 1 / 3, -1000.1, 100000.3 }

--- Hits as text: name of the other, side, response.
local function told(hits, count)
  local lines = {}
  for i = 1, count do
    lines[i] = hits[i].other.name .. " " .. hits[i].side .. " " .. hits[i].response
  end
  assert.are.equal(count, #hits)
  return table.concat(lines, ", ")
end

describe("world:move", function()
  -- A wall, me to the left of it, a floor below both.
  --
  --              +------+
  --     +----+   | wall |
  --     | me |   |      |
  --     +----+   +------+
  --
  --     +---------------+
  --     |     floor     |
  local function newScene(wall, shift)
    local world, o = still(), shift or 0
    local me = world:add("me", box(o, o, 10, 10, { vx = 3, vy = 4 }))
    wall = small.set({ name = "wall" }, wall)
    wall = world:add("walls", box(30 + o, -20 + o, 10, 40, wall))
    local floor = world:add("floors", box(-50 + o, 20 + o, 200, 10, { name = "floor" }))
    return world, me, wall, floor
  end

  small.rows("goes: {1}", {
    { "nothing in the way", "slide", { 15, 5 }, { 15, 5 }, "" },
    { "slide along a wall", "slide", { 40, 5 }, { 20, 5 }, "wall right slide" },
    { "into a corner", "slide", { 40, 40 }, { 20, 10 }, "floor bottom slide, wall right slide" },
    { "slide over the floor", "slide", { 15, 40 }, { 15, 10 }, "floor bottom slide" },
    { "touch", "touch", { 40, 8 }, { 20, 4 }, "wall right touch" },
    { "cross", "cross", { 60, 0 }, { 60, 0 }, "wall right cross" },
    { "cross both", "cross", { 60, 25 }, { 60, 25 }, "wall right cross, floor bottom cross" },
    { "bounce", "bounce", { 30, 5 }, { 10, 5 }, "wall right bounce" },
    { "bounce twice", "bounce", { 30, 15 }, { 10, 5 }, "floor bottom bounce, wall right bounce" },
    { "up to the wall", "slide", { 20, 0 }, { 20, 0 }, "" },
    { "a thousand times as fast", "slide", { 40000, 0 }, { 20, 0 }, "wall right slide" },
    { "no way at all", "slide", { 0, 0 }, { 0, 0 }, "" },
  }, function(_, response, to, at, expected)
    for _, o in ipairs(SHIFTS) do
      for _, kind in ipairs({ "dynamic", "static", "kinematic" }) do
        local world, me = newScene({ [kind] = kind ~= "dynamic" or nil }, o)
        local x, y, hits, count = world:move(me, to[1] + o, to[2] + o, response)
        assert.are.near(at[1] + o, x, 1e-6)
        assert.are.near(at[2] + o, y, 1e-6)
        assert.are.same({ x, y, 3, 4 }, { me.x, me.y, me.vx, me.vy })
        assert.are.equal(expected, told(hits, count))
      end
    end
  end)

  it("tells all about a hit", function()
    local world, me, wall = newScene()
    local _, _, hits = world:move(me, 80, 8)
    local hit = hits[1]
    assert.are.same({ 20, 2, -1, 0, 0.25 }, { hit.x, hit.y, hit.nx, hit.ny, hit.fraction })
    assert.are.equal(wall, hit.other)
  end)

  -- 10 px to the first wall, 20 px from one to the other: hit 64 after 1270 px, 65 after 1290
  it("tells where on the whole way each hit was, and ends after 64", function()
    local world = still()
    local me = world:add("a", box(0, 0, 10, 10))
    for _, x in ipairs({ 20, -20 }) do
      world:add("b", box(x, -50, 10, 100, { static = true }))
    end
    for _, row in ipairs({
      -- to, at, hits
      { 80, 0, 4 },
      { 1269, -9, 63 },
      { 1289, 9, 64 },
      { 1291, -10, 64 },
      { 9000, -10, 64 },
    }) do
      me.x = 0
      local x, y, hits, count = world:move(me, row[1], 0, "bounce")
      assert.are.same({ row[2], 0, row[3] }, { x, y, count })
      for n = 1, count do
        assert.are.near((20 * n - 10) / row[1], hits[n].fraction, 1e-9)
        assert.are.equal(n % 2 == 1 and 10 or -10, hits[n].x)
      end
    end
  end)

  small.rows("never snags on tiles: {1}", SHIFTS, function(o)
    local world = still()
    local list = newRandom(3):shuffled({ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 })
    for _, i in ipairs(list) do
      world:add("tiles", box(16.3 * i + o, 100 + o, 16.3, 16, { static = true, name = "t" .. i }))
    end
    local me = world:add("me", box(20 + o, 76 + o, 14, 24))
    for step = 1, 100 do
      local x, y, hits, count = world:move(me, 20 + step + o, me.y + 5)
      assert.are.near(20 + step + o, x, 1e-9)
      assert.are.equal(100 + o - 24, y)
      for i = 1, count do
        assert.are.equal("bottom", hits[i].side)
      end
    end
  end)

  --         ____
  --       /|         up a slope, a steeper one that stands on it, and on at the height of its top
  --     _/ |
  --  _/____|__
  local PLACES = { { 30, 84 }, { 60, 70 }, { 90, 40 }, { 150, 40 } }
  small.rows("walks along two slopes to x = {1}", PLACES, function(toX, toY)
    local world = physics.newWorld({ gravity = 800 })
    local me = world:add("me", box(0, 90, 10, 10))
    world:add("hills", box(10, 80, 100, 20, { static = true, slope = "right" }))
    world:add("hills", box(40, 50, 60, 60, { static = true, slope = "right" }))
    local x, y = world:move(me, toX, 90)
    assert.are.near(toX, x, 1e-9)
    assert.are.near(toY, y, 1e-9)
  end)

  it("slides down a slope, and on along a floor that stands out of it", function()
    local world = physics.newWorld({ gravity = 800 })
    local me = world:add("me", box(10, 70, 10, 10))
    world:add("hills", box(10, 80, 100, 20, { static = true, slope = "left" }))
    world:add("floors", box(60, 90, 300, 20, { static = true }))
    local x, y = world:move(me, 150, 120)
    assert.are.same({ 150, 80 }, { x, y })
  end)

  it("crosses sensors and reports them in order", function()
    local world, me = newScene()
    world:add("coins", box(15, 0, 5, 5, { name = "near", sensor = true }))
    world:add("coins", box(5, 2, 5, 5, { name = "here", sensor = true, static = true }))
    world:add("coins", box(50, 0, 5, 5, { name = "behind", sensor = true }))
    local x, _, hits, count = world:move(me, 80, 0)
    assert.same({ 20, "here", "near" }, { x, hits[1].other.name, hits[2].other.name })
    assert.same({ "cross", "wall", 3 }, { hits[2].response, hits[3].other.name, count })
    me.x, me.sensor = 0, true
    assert.are.equal(80, (world:move(me, 80, 0)))
  end)

  it("passes what it cannot meet", function()
    for _, row in ipairs({
      -- fields of the wall, of me, of the world
      { { active = false }, {}, {} },
      { { mask = { me = false } }, {}, {} },
      { { oneWay = "top" }, {}, {} },
      { {}, { mask = { walls = false } }, {} },
      { {}, {}, { masks = { walls = { me = false } } } },
      { {}, { active = false }, {} },
    }) do
      local world, me = newScene(row[1])
      small.set(me, row[2])
      small.set(world, row[3])
      assert.are.equal(80, (world:move(me, 80, 0)))
    end
  end)

  it("lands on a one-way and comes up through it", function()
    local world = still()
    world:add("clouds", box(0, 100, 100, 8, { static = true, oneWay = "top", name = "cloud" }))
    local me = world:add("me", box(20, 150, 10, 10))
    assert.are.equal(50, select(2, world:move(me, 20, 50)))
    assert.are.equal(90, select(2, world:move(me, 20, 500)))
    assert.are.equal(90, select(2, world:move(me, 60, 95)))
    me.y = 95
    assert.are.equal(120, select(2, world:move(me, 20, 120)))
  end)

  -- Where two are met at once: by the wider common edge, then in the order of the world.
  for _, row in ipairs({
    -- y and height of the first and of the second; which is told first
    { 0, 10, 10, 10, "first", "second" },
    { 10, 10, 0, 10, "first", "second" },
    { 0, 4, 4, 20, "second", "first" },
    { 12, 20, 0, 12, "second", "first" },
  }) do
    local title = "move meets both of two, the %s first, from %g, %g px high, and from %g, %g px"
    it(title:format(row[5], row[1], row[2], row[3], row[4]), function()
      local world = still()
      local me = world:add("a", box(0, 0, 10, 20))
      world:add("walls", box(30, row[1], 10, row[2], { name = "first", static = true }))
      world:add("walls", box(30, row[3], 10, row[4], { name = "second", static = true }))
      local _, _, hits, count = world:move(me, 80, 0, "touch")
      assert.are.equal(row[5] .. " right touch, " .. row[6] .. " right touch", told(hits, count))
      me.x = 0
      _, _, hits, count = world:move(me, 80, 2, function(_, other)
        return other.name == "first" and "slide" -- the other one is ignored
      end)
      assert.are.equal("first right slide", told(hits, count))
      assert.are.same({ 20, 2 }, { me.x, me.y })
    end)
  end

  it("asks a function for the response", function()
    local world, me = newScene()
    world:add("doors", box(15, 0, 5, 10, { name = "door" }))
    world:add("ghosts", box(20, 0, 5, 10, { name = "ghost" }))
    local function response(object, other)
      assert.are.equal(me, object)
      if other.name == "door" then
        return "cross"
      end
      if other.name == "ghost" then
        return false
      end
      return other.name == "wall" and "touch" or nil
    end
    local x, _, hits, count = world:move(me, 80, 0, response)
    assert.same({ 20, "door right cross, wall right touch" }, { x, told(hits, count) })
    world:move(me, 0, 0, "cross")
    assert.are.equal(10, select(2, world:move(me, 0, 80, response)))
  end)

  it("lets out what is inside a solid, and holds it nowhere", function()
    local world, me, wall = newScene()
    me.x = 25
    local x, _, hits, count = world:move(me, 5, 0)
    assert.same({ 5, "wall right cross", 0 }, { x, told(hits, count), hits[1].fraction })
    assert.are.equal(wall.x - 10, (world:move(me, 50, 0)))
  end)

  it("writes to no object that stands in the list", function()
    local world = physics.newWorld()
    local me = world:add("boxes", { x = 0, y = 0, width = 10, height = 10 })
    local wall = world:add("walls", { x = 20, y = 0, width = 10, height = 10, static = true })
    local list = world:queryRect(0, 0, 100, 100)
    assert.are.equal(2, #list)
    local x, _, hits, count = world:move(me, 30, 0, "slide", list)
    assert.are.equal(10, x)
    assert.are.equal(list, hits)
    assert.are.same({ 1, 1 }, { count, #hits })
    assert.is_true(hits[1].other == wall)
    assert.are.same({ x = 20, y = 0, width = 10, height = 10, static = true }, wall)
    world:move(me, 0, 0, "slide", world:queryRect(0, 0, 100, 100, nil, list))
    assert.are.equal(0, #list)
  end)

  it("leaves no garbage with a list of its own", function()
    local world, me = newScene()
    local hits = {}
    local function go()
      world:move(me, 40, 40, "slide", hits)
      world:move(me, 0, 0, "slide", hits)
    end
    assert.is_true(garbage.bytes(go, 200, 100) <= 100)
  end)

  long("never ends inside a solid", function()
    local names = { "slide", "touch", "bounce" }
    for seed = 1, 40 do
      local random, world, all = newRandom(seed), still(), {}
      for i = 1, 60 do
        local x, y = 20 * random:integer(0, 15), 20 * random:integer(0, 15)
        if i > 30 then
          x, y = random:between(0, 300), random:between(0, 300)
        end
        local _, count = world:queryRect(x, y, 20, 20)
        if count == 0 then
          all[#all + 1] = world:add("b", box(x, y, 20, 20, { static = random:chance(0.5) }))
        end
      end
      for _ = 1, 200 do
        local me = all[random:integer(1, #all)]
        if not me.static then
          local x, y = me.x + random:between(-200, 200), me.y + random:between(-200, 200)
          if random:chance(0.5) then
            x = me.x
          end
          world:move(me, x, y, random:pick(names))
          local inside = world:overlapping(me)
          assert(#inside == 0, ("seed %d"):format(seed))
        end
      end
    end
  end)

  play.row("is taken by the next update as a place the game wrote", play.ONCE, {
    scene.maker("floors", { static = true })("floor", 0, 100, 200, 16),
    scene.maker("me", {})("me", 0, 84, 16, 16),
  }, {
    { steps = 5, keep = "world:move(me.raw, me.x + 10, me.y)" },
    "me at 50, 84; me.vy == 0; me touches bottom",
  })
end)

-- (Wrong numbers and tables are in debugging_bad_input_spec.)
local function no()
  return "no"
end

small.rows("move, impulse and setBounds refuse {3}", {
  { "move", { "me", 0, 0, "glide" }, 'response must be "slide", "touch", "cross" or "bounce"' },
  { "move", { "me", 50, 0, no }, "what response(object, other) returns must be" },
  { "move", { "wall", 0, 0 }, "world:move(object, x, y): object must not be static" },
  { "move", { {}, 0, 0 }, "world:move(object, x, y): the object is not in the world" },
  { "impulse", { "wall", 0, 0 }, "object must be dynamic" },
  { "setBounds", { 0, 0, 0, 5 }, "world:setBounds(x, y, w, h): w must be a number > 0, got 0" },
}, function(method, args, words)
  local world = still()
  local objects = { me = world:add("me", box(0, 0, 10, 10)) }
  objects.wall = world:add("walls", box(30, 0, 10, 10, { static = true }))
  local given = args
  local first = objects[given[1]] or given[1]
  small.refuses(words, world[method], world, first, given[2], given[3], given[4])
  assert.are.same({ 0, 0 }, { objects.me.x, objects.me.y })
  assert.is_nil(world.objects.bounds)
end)
