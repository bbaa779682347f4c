--- Events: what the game is told about which objects, in which order, and what callbacks may do.

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local variants = require("spec.support.variants")

local newBox = small.box

local DT = 1 / 60
local ONCE = play.ONCE

local box = scene.thing("boxes", { name = "box", x = 0, y = 0, width = 16, height = 16 })
local solid = scene.maker("walls", { static = true })
local FLOOR = solid("floor", -200, 100, 800, 16)

--- Lines that the callbacks of a row have written, one after the other.
local lines

local function note(text)
  lines[#lines + 1] = text
end

--- A part of a row: `f(it)`, with the views and names of the row.
local function act(f)
  return function(_, it)
    f(it)
  end
end

local row = play.once({ newWorld = physics.newWorld, DT = DT })

describe("onBegin, onStay, onEnd", function()
  --    side of the box, of the wall, where it comes from, its speed
  row("have the side of self that was hit, and the speed: {side}", function(v)
    local wall = solid("wall", 100, 100, 16, 16)
    return { gravity = 0, wall, box({ x = v.x, y = v.y, vx = v.vx, vy = v.vy }) }
  end, {
    { "listen box", "listen wall", 1, "heard.box.sides[side] == 1", "heard.wall.sides[back] == 1" },
    { "box heard 1, 0", "wall heard 1, 0", "heard.box.speed ~ 120, 1e-9" },
    "heard.wall.speed ~ 120, 1e-9",
  }, {
    "side, back, x, y, vx, vy",
    { "right", "left", 0, 100, 120, 0 },
    { "left", "right", 200, 100, -120, 0 },
    { "bottom", "top", 100, 0, 0, 120 },
    { "top", "bottom", 100, 200, 0, -120 },
  })

  row("are told to both, then to the world: begin, then stay at every step, then end", {
    gravity = 0,
    solid("wall", 16.5, 0, 16, 16),
    box({ vx = 60 }),
  }, {
    act(function(it)
      lines = {}
      for _, name in ipairs({ "onBegin", "onStay", "onEnd" }) do
        for owner, object in pairs({ box = it.box.raw, wall = it.wall.raw, world = it.world }) do
          object[name] = function(a, b, side, speed)
            local text = speed and ("%.3g"):format(speed) or "-"
            note(("%s %s: %s %s %s %s"):format(owner, name, a.name, b.name, side, text))
          end
        end
      end
      it.world:refresh(it.wall.raw)
    end),
    { steps = 3 },
    { "box.vx = -60", { steps = 3 } },
    act(function()
      assert.same({
        "box onBegin: box wall right 60",
        "wall onBegin: wall box left 60",
        "world onBegin: box wall right 60",
        "box onStay: box wall right 0.0167",
        "wall onStay: wall box left 0.0167",
        "world onStay: box wall right 0.0167",
        "box onStay: box wall right 0.0167",
        "wall onStay: wall box left 0.0167",
        "world onStay: box wall right 0.0167",
        "box onEnd: box wall right -",
        "wall onEnd: wall box left -",
        "world onEnd: box wall right -",
      }, lines)
    end),
  })

  it("are told in the order of the world, whatever was met first", function()
    local world = physics.newWorld({ gravity = 0, order = { "late", "early" } })
    lines = {}
    function world.onBegin(a, b)
      note(a.name .. b.name)
    end
    for n = 1, 3 do
      local y = 40 * n
      world:add("late", newBox(0, y, { name = "b" .. n, vx = 3000 - 700 * n }))
      world:add("early", newBox(20, y, { name = "w" .. n, static = true }))
    end
    world:update(DT)
    assert.same({ "b1w1", "b2w2", "b3w3" }, lines)
  end)

  -- The box stands before the crate in the order of the world, and so do the walls.
  it("of an object that left are told before those of the step", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("tiles", FLOOR[2])
    local stands = world:add("crates", newBox(60, 84, { name = "crate" }))
    local falls = world:add("boxes", newBox(0, 50, { name = "box", gravity = 0 }))
    world:update(DT)
    for _, name in ipairs({ "onBegin", "onEnd" }) do
      world[name] = function(a, b)
        note(("%s %s %s"):format(name, a.name, b.name))
      end
    end
    world:remove(stands)
    falls.y, falls.vy = 83.9, 100
    world:setBounds(-500, -500, 2000, 2000)
    local state = world:save()
    for _ = 1, 2 do
      lines = {}
      world:update(DT)
      assert.are.same({ "onEnd crate floor", "onBegin box floor" }, lines)
      world:restore(state)
    end
  end)

  row("begins once for what is wholly inside a solid, ends when it is put elsewhere", {
    solid("tile", 0, 0, 16, 16),
    box(),
  }, {
    { "listen tile", "world:setBounds(0, 0, 16, 16)", { steps = 30 }, "tile heard 1, 0" },
    { "world:setBounds()", "box.x = 100", { steps = 30 }, "tile heard 1, 1" },
  })
end)

row("onStay: tells the {owner} at every step, also of one that rests", { FLOOR, box({ y = 84 }) }, {
  1,
  "world.stats.resting == 1; stays = 0",
  "function {owner}.onStay() stays = stays + 1 end",
  "world:refresh(floor.raw)", -- of a static object it is read once
  { steps = 100 },
  "stays == 100",
}, { "owner", { "box.raw" }, { "floor.raw" }, { "world" } })

describe("onBegin and onEnd", function()
  row("are not told while it leans on a wall after the push has ended", {
    FLOOR,
    solid("wall", 100, 0, 16, 100),
    box({ x = 60, y = 84, vx = 100 }),
  }, {
    { steps = 1 },
    { "listen box", { 1, keep = "box.vx = 100" } },
    "box.raw.onStay = nil", -- so that it may rest
    5,
    "box heard 1, 0",
    "box.touching.right == wall",
    { "box.vx = -10", { steps = 3 }, "box heard 1, 1", "box.touching.right == false" },
  })

  -- It stands on the edge, and is past it at the end of the step.
  play.row("are told in one step for a box that runs off an edge, wherever down is", {
    turn = variants.TURNS,
    order = { "forward", "backward" },
  }, { solid("block", 100, 100, 20, 20), box({ x = 100, y = 84, vx = 1800 }) }, {
    { "listen box", { steps = 1 }, "box heard 1, 1; heard.box.sides.bottom == 1" },
  })

  row("are told in the step that presses, not in the one that ends flush: push {push}", function(v)
    local first, pusher = box({ vx = 64 }), box({ name = "pusher", y = 100, vx = 64 })
    local other = box({ name = "other", x = 17, y = 100 })
    return { gravity = 0, push = v.push, solid("wall", 17, 0, 16, 16), first, other, pusher }
  end, {
    { "log = run:listenToWorld()", "run:step(1 / 64)", "box at 1, 0", "box.vx == 64" },
    { "pusher.x == 1", "log.begins == 0" },
    { "run:step(1 / 64)", "box at 1, 0", "box.vx == 0", "pusher.vx == 32", "log.begins == 2" },
  }, { "push", { "both" }, { "first" } })

  row("sideBySide: only with it they are told of neighbours that never pressed each other", {
    FLOOR,
    solid("wall", 16, 0, 16, 100),
    box({ y = 84 }),
  }, {
    { "listen wall", { steps = 10 }, "wall heard 0, 0", "box.touching.right == false" },
    { "world.sideBySide = true", { steps = 10 }, "wall heard 1, 0", "heard.wall.sides.left == 1" },
    "box.touching.right == wall",
  })

  -- A bullet from a pool: it is fired again before the next update, and hits the same one in that.
  row("are told anew when it is put elsewhere and hits again in one step{also}", function(v)
    local list =
      { solid("boss", 100, 0, 100, 400), box({ x = 85, y = 50, vx = 1200, sensor = v.sensor }) }
    list[v.setting or "rest"], list.gravity = v.value or false, 0
    return list
  end, {
    { "listen box", { steps = 1 }, "box heard 1, 0" },
    "world:touching(box.raw, boss.raw) == 'right'",
    { "box.active = off or nil", "box.active = nil", "box.x, box.y, box.vx = 80, 100, 1200" },
    "world:touching(box.raw, boss.raw) == nil",
    { steps = 1 },
    "box heard 2, 1",
    "heard.box.speed == 1200; world:touching(box.raw, boss.raw) == 'right'",
  }, {
    "also, setting, value, sensor, off",
    { "", "rest", true },
    { ", switched off in between", "rest", true, nil, false },
    { ", with rest = false" },
    { ", pair by pair", "broadphase", "pairs" },
    { ", a sensor", "rest", true, true },
    { ", with sideBySide", "sideBySide", true },
  })

  row("are not told when it is put elsewhere along what it touches", { FLOOR, box({ y = 84 }) }, {
    { "listen box", { steps = 10 } },
    { steps = 10, keep = "box.x = 30 * n" },
    "box heard 1, 0",
    { "box.y = 83", { steps = 10 }, "box heard 2, 1" },
  })
end)

describe("onEnd is told exactly once", function()
  local function no()
    return false
  end

  -- What is written, or done, to the box, the floor or the world.
  local STANDS = { FLOOR, box({ y = 84 }) }
  play.row("for {what}", ONCE, STANDS, {
    { "listen box", "listen floor", "box.raw.onStay, floor.raw.onStay = nil, nil", 1 },
    "log = run:listenToWorld()",
    "{does}",
    "world:refresh(floor.raw)",
    { steps = 1, "box heard 1, 1", "floor heard 1, 1" },
    { steps = 5, "box heard 1, 1", "floor heard 1, 1", "log.ends == 1" },
    "box.touching.bottom == false",
  }, {
    "what, does",
    { "a box that is removed", "world:remove(box.raw)" },
    { "a box that is removed with plain Lua", "world.objects.boxes = nil" },
    { "a box that is switched off", "box.raw.active = false" },
    { "a box with a mask", "box.raw.mask = { walls = false }" },
    { "a box that is put elsewhere", "box.raw.x, box.raw.y = 2000, -500" },
    { "a box that canCollide lets through", "box.raw.canCollide = no" },
    {
      "a floor that is removed",
      "world:remove(floor.raw); world:add('others', floor.raw); floor.raw.x = 9e3",
    },
    { "a floor that is switched off", "floor.raw.active = false" },
    { "a floor with a mask", "floor.raw.mask = { boxes = false }" },
    { "masks of the world", "world.masks = { walls = { boxes = false } }" },
    { "canCollide of the world", "world.canCollide = no" },
  }, { no = no })

  row("also when it is switched off and removed, and made part of another world", STANDS, {
    { "listen box", { steps = 2 } },
    { "box.active = false", { steps = 2 } },
    { "world:remove(box.raw)", "box.active = true" },
    "newWorld():add('boxes', box.raw)",
    { steps = 2 },
    "box heard 1, 1",
  })

  row("and begins anew when it comes back, or has been small", STANDS, {
    { "listen box", { steps = 2 } },
    { "box.active = false", { steps = 2 } },
    { "box.active = true", { steps = 2 }, "box heard 2, 1" },
    { "world:remove(box.raw)", { steps = 1 } },
    { "world:add('boxes', box.raw)", { steps = 1 }, "box heard 3, 2" },
    { "box.height = 4", { steps = 11 } },
    "box heard 4, 3", -- it has fallen, and stands again
  })
end)

describe("onBegin", function()
  row("may come and go at any time, of a static object, too", { FLOOR, box({ restitution = 1 }) }, {
    { "begins = 0", 0.5 },
    "function count() begins = begins + 1 end",
    { "box.raw.onBegin = count", 2, "begins > 0" },
    { "box.raw.onBegin, begins = nil, 0", 2, "begins == 0" },
    { "floor.raw.onBegin = count", 2, "begins > 0" },
  })

  it("may remove self, the other, or an object that has not been told yet", function()
    local world = physics.newWorld({ gravity = 800 })
    local floor, told, boxes = world:add("tiles", FLOOR[2]), 0, {}
    for n = 1, 6 do
      boxes[n] = world:add("boxes", newBox(30 * n, 80))
      boxes[n].onBegin = function(self, other)
        told = told + 1
        assert.equal(floor, other)
        assert.equal(boxes[n], self)
        world:remove(boxes[1])
        world:remove(boxes[n])
        world:remove(boxes[6])
      end
    end
    small.run(world, 10)
    assert.same({ 6, 1 }, { told, world.stats.objects })
    local last = world:add("boxes", newBox(0, 80))
    function last.onBegin(_, other)
      world:remove(other)
    end
    small.run(world, 60)
    assert.is_true(last.y > 200)
  end)

  row("may put a velocity, which counts from the next step on", { FLOOR, box({ y = 80 }) }, {
    "function box.raw.onBegin(self) self.vy = -400 end",
    { "highest = 100", { 2, keep = "highest = min(highest, box.y)" }, "highest ~ 84 - 100, 0.2" },
  })

  row("may call update itself", { FLOOR, box({ y = 60 }) }, {
    "deep = 0",
    "function box.raw.onBegin() deep = deep + 1 world:update(DT) end",
    1,
    "deep == 1; box.y == 84",
  })
end)

-- How a spike and a man on a floor come into each other, with the sides that touch at last.
local WAYS = {
  ["is added"] = function(world, spike)
    local fields = { static = spike.static, kinematic = spike.kinematic }
    world:add("spikes", small.put(45, 380, 24, 20, fields))
  end,
  ["is put there"] = function(world, spike)
    spike.x = 45
    world:refresh(spike)
  end,
  grows = function(world, spike)
    spike.x, spike.width = 45, 60
    world:refresh(spike)
  end,
  ["has a man put into it"] = function(_, _, man)
    man.x = 110
  end,
  ["has a man grow into it"] = function(_, _, man)
    local size = man.radius and 100 or man.height
    man.x, man.y, man.width, man.height = 30, 400 - size, 100, size
    man.radius = man.radius and 50
  end,
}

describe("onBegin: a spike that", function()
  small.each("{1} tells that it touches, once, at no speed of its own", WAYS, function(_, come)
    for n = 0, 11 do
      local world, told = physics.newWorld({ gravity = n % 2 * 800 }), {}
      world:add("floors", small.tile(-500, 400, 1000, 20))
      local man = { x = 40, y = 376, width = 24, height = 24, radius = n > 5 and 12 or nil }
      world:add("men", man)
      local spike = world:add("spikes", small.put(120, 380, 24, 20))
      spike.static, spike.kinematic = n % 3 == 0 or nil, n % 3 == 1 or nil
      world:refresh(spike)
      small.run(world, 20)
      function man.onBegin(_, other, side, speed)
        local isRight = world:groupOf(other) == "spikes" and man.touching[side] == other
        told[#told + 1] = isRight and speed <= (man.radius and 800 / 60 or 0)
      end
      come(world, spike, man)
      small.run(world, 10)
      assert.same({ n, { true } }, { n, told })
    end
  end)
end)

describe("onBegin: the place of a contact", function()
  local RIM = 28 + 4 * 8 / 13 -- px, x of where two circles touch, 5 and 8 px around 32 and 28
  local LOW = 25 - math.sqrt(25 - (32 - RIM) ^ 2)
  local BALL, ROUND = { 20, -60, 16, 16, radius = 8 }, { 27, 20, 10, 10, radius = 5 }
  local WALL, BOUNCY = { 100, 0, 16, 400 }, { 0, 0, 10, 10, 3000, 1000, restitution = 1 }
  local GATE, FAST = { 100, 0, 4, 60, sensor = true }, { 0, 40, 10, 40, 9000 }
  local DOWN, UP = { 0, 0, 64, 64, slope = "left" }, { 0, 0, 64, 64, slope = "right" }
  local BOX = { 20, -60, 16, 16 }
  small.each("is {1}, for both and for the world", {
    -- gravity, what is met (static), what moves: x, y, width, height, vx, vy; the place
    ["its edge"] = { 800, { 0, 100, 50, 16 }, { 42, 60, 16, 24 }, "bottom", 42, 100, 50, 100 },
    ["above"] = { 0, { 0, 0, 200, 30 }, { 40, 50, 16, 24, 0, -300 }, "top", 40, 30, 56, 30 },
    ["at the right"] = { 0, { 80, 30, 10, 60 }, { 40, 50, 16, 24, 300 }, "right", 80, 50, 80, 74 },
    ["at the left"] = { 0, { 0, 30, 10, 60 }, { 40, 50, 16, 24, -300 }, "left", 10, 50, 10, 74 },
    ["where they met, not where they are"] = { 0, WALL, BOUNCY, "right", 100, 30, 100, 40 },
    ["where a sensor was entered"] = { 0, GATE, FAST, "right", 100, 40, 100, 60 },
    ["the corner that is on a slope"] = { 800, DOWN, BOX, "bottom", 20, 20, 20, 20 },
    ["the other corner on the other slope"] = { 800, UP, BOX, "bottom", 36, 28, 36, 28 },
    ["where a circle touches a box"] = { 800, { 0, 20, 64, 64 }, BALL, "bottom", 28, 20, 28, 20 },
    ["where a circle touches a circle"] = { 800, ROUND, BALL, "bottom", RIM, LOW, RIM, LOW },
  }, function(_, given)
    local world, told, objects = physics.newWorld({ gravity = given[1] }), {}, {}
    for n = 1, 2 do
      local its = given[4 - n]
      objects[n] = { x = its[1], y = its[2], width = its[3], height = its[4] }
      objects[n].vx, objects[n].vy = its[5], its[6]
      for _, name in ipairs({ "radius", "slope", "sensor", "restitution" }) do
        objects[n][name] = its[name]
      end
      objects[n].static = n == 2
    end
    for n, owner in ipairs({ objects[1], objects[2], world }) do
      function owner.onBegin(...)
        told[n] = told[n] or { ... }
      end
    end
    world:add("men", objects[1])
    world:add("tiles", objects[2])
    small.run(world, 60)
    assert.equal(given[4], told[1][3])
    for n = 1, 3 do
      for k = 5, 8 do
        assert.near(given[k], told[n][k], 1e-6)
      end
      -- For a grid of cells it is in the other object, when it is a wall.
      local x, y, other = (told[n][5] + told[n][7]) / 2, (told[n][6] + told[n][8]) / 2, told[n][2]
      assert.is_true(given[1] > 0 or n == 2 or other.x <= x and x < other.x + other.width)
      assert.is_true(given[1] > 0 or n == 2 or other.y <= y and y < other.y + other.height)
    end
  end)
end)

--   ####****
--      ++
--      ||  ^     1 px under one brick, 7 px under the other
-- The one that came first in the game's list was told, and broke.
describe("onBegin: of two bricks hit at the same moment", function()
  local TURNED = { shift = { 0, 1 / 3, 100000.3 }, rate = { 60, 30, 144 }, turn = variants.TURNS }
  TURNED.order = variants.ORDERS
  play.row("the one with the wider common edge is first: {a} and {b} px", TURNED, function(v)
    return {
      gravity = 0,
      solid("left", 0, 0, 100, 16),
      solid("right", 100, 0, 100, 16),
      scene.maker("bodies")("man", 100 - v.a, 40, v.a + v.b, 24, { vy = -300 }),
    }
  end, {
    "first = nil",
    "function world.onBegin(one, other) first = first or one == man.raw and other or one end",
    0.5,
    "wide = a > b and left or right; first == wide.raw; man.touching.top == wide",
  }, { "a, b", { 1, 7 }, { 7, 1 }, { 2, 14 }, { 9, 7 }, { 15.5, 0.5 } })
end)

describe("onCrush", function()
  row("is told to the object and to the world, once", {
    gravity = 0,
    solid("left", 0, 0, 16, 64),
    scene.maker("presses", { kinematic = true, vx = -60 })("right", 48, 0, 16, 64),
    box({ x = 20, y = 20 }),
  }, {
    "told = ''",
    "function tell(it, a, b, axis) told = told .. it.name .. min(a.x, b.x) .. axis end",
    "box.raw.onCrush, world.onCrush = tell, tell",
    { steps = 40 },
    "told == 'box0xbox0x'",
    "box.vx - box.vx == 0",
  })
end)

describe("onBegin, onStay: the normal", function()
  local root = math.sqrt(0.5)

  -- Runs a world until the mover has begun a contact, and stayed in it for a step if `stays`.
  -- Returns the normals that mover and other have heard: x, y, other's x, y.
  local function hear(name, gravity, mover, other, state)
    local world, heard = physics.newWorld({ gravity = gravity }), {}
    mover[name] = function(_, _, _, _, ...)
      heard.x, heard.y = select(name == "onBegin" and 5 or 1, ...)
    end
    other[name] = function(_, _, _, _, ...)
      heard.ox, heard.oy = select(name == "onBegin" and 5 or 1, ...)
    end
    world:add("movers", mover)
    world:add("others", other)
    for n = 1, 60 do
      if n == state then
        world:restore(world:save())
      end
      world:update(DT)
      if heard.x then
        return heard
      end
    end
  end

  -- The mover flies or falls; the other one is static.
  local WALL, CEILING = newBox(30, 0), newBox(0, 10)
  local BUMPER, CORNER = small.ball(100, 100, 8), newBox(100, 100)
  local SLOPE = small.put(0, 100, 100, 100, { slope = "right" })
  local function hit(fields)
    return small.ball(100 - 0.8 * 46, 100 - 0.6 * 46, 8, small.set({ vx = 240, vy = 180 }, fields))
  end
  for _, given in ipairs({
    { "a box at a wall", -1, 0, 0, newBox(0, 0, { vx = 120 }), WALL },
    { "a box below a ceiling", 0, 1, 0, newBox(0, 40, { vy = -120 }), CEILING },
    { "a ball at a round bumper", -0.8, -0.6, 0, hit(), BUMPER },
    { "a ball that bounces off it", -0.8, -0.6, 0, hit({ restitution = 1 }), BUMPER },
    {
      "a ball at a corner",
      -root,
      -root,
      0,
      small.ball(60, 60, 8, { vx = 200, vy = 200 }),
      CORNER,
    },
    { "a box on a slope", -root, -root, 800, newBox(20, 130), SLOPE },
    { "a box beyond the crest of a slope", 0, -1, 800, newBox(95, 70), SLOPE },
  }) do
    local name, nx, ny, gravity, mover, other = small.unpack(given)
    for _, event in ipairs({ "onBegin", "onStay" }) do
      for state = 1, (event == "onStay" and mover.restitution) and 0 or 16, 15 do
        it(("leads away from the other object: %s, %s, %d"):format(name, event, state), function()
          local one, its = small.set({}, mover), small.set({ static = true }, other)
          local heard = hear(event, gravity, one, its, state)
          assert.near(nx, heard.x, 1e-9)
          assert.near(ny, heard.y, 1e-9)
          assert.same({ -heard.x, -heard.y }, { heard.ox, heard.oy })
          for _, value in pairs(heard) do
            assert.are_not.equal(-math.huge, 1 / value) -- no -0
          end
        end)
      end
    end
  end

  it("is told after a restore of events that wait", function()
    local world = physics.newWorld({ gravity = 0 })
    local ball = world:add("balls", small.ball(60, 60, 8, { vx = 200, vy = 200 }))
    world:add("walls", newBox(100, 100, { static = true }))
    ball.onBegin = function()
      error("on purpose")
    end
    local isWell = true
    while isWell do
      isWell = pcall(world.update, world, DT)
    end
    local x, y
    function world.onBegin(_, _, _, _, _, _, _, _, nx, ny)
      x, y = nx, ny
    end
    world:restore(world:save())
    world:update(DT)
    assert.near(-root, x, 1e-9)
    assert.near(-root, y, 1e-9)
  end)
end)
