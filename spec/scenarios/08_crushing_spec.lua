--- Crushing: held between two that cannot give way.

local physics = require("physics")
local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local solid = scene.maker("tiles", { static = true })
local wall = scene.maker("walls", { kinematic = true })
local FLOOR = solid("floor", -200, 116, 800, 32)

local function box(name, x, y, fields)
  return scene.maker("boxes", fields or {})(name, x, y, 16, 16)
end

--- Two walls that meet at x = 100 after 1.2 s, `count` boxes in the middle.
local function between(v)
  local half = 8 * v.count
  local left, right = wall("L", 68 - half, 52, 16, 64), wall("R", 116 + half, 52, 16, 64)
  left[2].vx, right[2].vx = 20, -20
  local description = { FLOOR, left, right }
  for i = 1, v.count do
    description[i + 3] = box("box" .. i, 100 - half + 16 * (i - 1), 100, v.fields)
  end
  return description
end

--- Counts how often an object is crushed, and between which, from now on.
local function watch(run, view)
  local log = { count = 0 }
  view.raw.onCrush = function(_, a, b, axis)
    log.count = log.count + 1
    if run.turn % 2 == 1 then
      axis = axis == "x" and "y" or "x"
    end
    log.a, log.b, log.axis = run.views[a], run.views[b], axis
  end
  return log
end

--- Fails unless it was crushed `count` times, the last time between these two.
local function crushed(run, log, count, one, other, axis)
  run:same("onCrush", log.count, count)
  run:same("axis", log.axis, axis)
  local found = log.a == one and log.b == other or log.a == other and log.b == one
  run:check(found, "should be crushed by others than %s and %s", log.a.name, log.b.name)
end

local row = play.with({ watch = watch, crushed = crushed })

--- A row of `count` boxes between two others along an axis. Returns functions that fail: `share`
--- unless all stand still across it and have even shares of the overlap of `deep` px (several to
--- half of that, so that none leaves the room), the first with its near side at `start`; and
--- `once` unless each was crushed once by its neighbours.
local function newRow(run, named, count, first, last, axis)
  local views, logs, across = { [0] = first, [count + 1] = last }, {}, axis == "x" and "y" or "x"
  local places = {}
  for i = 1, count do
    views[i] = named["box" .. i]
    logs[i], places[i] = watch(run, views[i]), views[i][across]
  end
  local function share(start, deep, limit)
    for i = 1, count do
      local view = views[i]
      run:near(across .. " of " .. i, view[across], places[i])
      run:check(math.abs(view.vx) <= limit and math.abs(view.vy) <= limit, "it is too fast")
      if deep > 1e-3 then
        local reach = count > 1 and deep / 2 + 1e-6 or 1e-6
        run:near("share", view[axis], start + 16 * (i - 1) - i * deep / (count + 1), reach)
      end
    end
  end
  local function once()
    for i = 1, count do
      crushed(run, logs[i], 1, views[i - 1], views[i + 1], axis)
    end
  end
  return share, once, views
end

describe("onCrush: inside something, with no way out,", function()
  --   ## ## ## ##
  --      +-+         grows from 16 to 24 px
  --   ## ## ## ##
  local TILES =
    scene.tiles({ scene.maker("boxes", {})("box", 103, 84, 12, 16) }, 13, 0, 100, 16, 16, 16, 0)
  scene.tiles(TILES, 13, 0, 68, 16, 16, 16, 0)
  row("tells by what it grows into, once", { rate = variants.RATES }, TILES, {
    { "log = watch(run, box)", 0.5, "log.count == 0; box.height = 24" },
    { 0.5, "log.count == 1", "box at 103, 80", "box still" }, -- half of it in each
    "log.axis == 'y'; min(log.a.y, log.b.y) ~ 68; max(log.a.y, log.b.y) ~ 100",
    { "box.height = 16", 0.5, "box at 103, 84; box touches bottom top; box.height = 24" },
    { 0.5, "log.count == 2", "box at 103, 80" },
  })

  row("tells a box of {size} px once in a block of tiles, by two at its sides", nil, function(v)
    local list = { scene.maker("boxes", {})("box", 70, 70, v.size, v.size) }
    for i = 0, 8 do
      scene.tiles(list, 9, 16 * i, 0, 16, 16, 0, 16)
    end
    return list
  end, {
    "log, middle = watch(run, box), 70 + size / 2 - 8",
    { 0.5, "log.count == 1", "box at 70, 70" },
    "(log.a[log.axis] - middle) * (log.b[log.axis] - middle) < 0",
  }, { "size", { 12 }, { 36 } })
end)

--   |L|  +-+  |R|
--   |L|->+-+<-|R|
--   -------------
describe("onCrush: between two walls", function()
  row("(8) tells once, at the step after they have met it", { turn = variants.TURNS }, between, {
    "log = watch(run, box1)",
    { 1, "log.count == (t * 60 > 48.5 and 1 or 0)" },
  }, { "count", { 1 } })

  for count = 1, 3 do
    local title = ("(8) %d share the overlap, each is told once, and they are let go"):format(count)
    scene.it(title, EVERYWHERE, function(run)
      local named = run:build(between({ count = count }))
      local share, once, views = newRow(run, named, count, named.L, named.R, "x")
      local seconds = count == 1 and 1.5 or 1
      for time in run:steps(seconds) do
        share(named.L.x + 16, math.max(0, 2 * (20 * time - 16)), 20 + 1e-6)
      end
      once()
      named.L.vx, named.R.vx = -20, 20
      run:play(seconds)
      once()
      for i = 1, count do
        -- In order, within a quarter of its size of where even shares would leave it.
        run:at(views[i], 100 - 8 * count + 16 * (i - 1), 100, count > 1 and 4 or 1e-6)
        local gap = views[i].x - views[i - 1].x - (i == 1 and 0 or 16)
        run:check(gap >= -1e-6, "overlap by %.9g px", -gap)
        run:still(views[i])
      end
    end)
  end

  local POST = { FLOOR, wall("L", 60, 52, 16, 64, { vx = 20 }), solid("post", 124, 52, 16, 64) }
  POST[2][2].vx, POST[4] = 20, box("box1", 92, 100)
  row("tells if one of them stands still, too", SOME, POST, {
    "log = watch(run, box1)",
    { 1.5, "box1 at max(92, 76 + 20 * t), 100" },
    0.1,
    { 0.4, "box1.x ~ (L.x + 16 + 108) / 2", "abs(box1.vx) <= 20 + 1e-6" },
    "crushed(run, log, 1, L, post, 'x')",
  })

  --   |L|  +--+--|R|   8 px inside the second box, and only 6 px of room
  --   |L|  +--+--|R|
  for _, vx in ipairs({ 0, 5, -30 }) do
    scene.it(("tells all of a row that one is put into, at %g px/s"):format(vx), SOME, function(run)
      local right = wall("R", 46, 100, 16, 16, { vx = vx })
      local boxes = { box("box1", 22, 100), box("box2", 38, 100) }
      local named = run:build({ gravity = 0, wall("L", 0, 100, 16, 16), boxes[1], boxes[2], right })
      local share, once = newRow(run, named, 2, named.L, named.R, "x")
      named.R.vx = vx
      for _ = 1, 6 do -- it comes out of the wall, into the other box, and both are pressed
        run:step(1 / 60)
      end
      share(16, 48 - 46 - 6 * vx / 60, 1e9)
      once()
    end)
  end

  row("takes it along at the mean of their speeds: {left} and {right}", SOME, function(v)
    local left, right = wall("L", 0, 100, 16, 16), wall("R", 32, 100, 16, 16)
    left[2].vx, right[2].vx = v.left, v.right
    return { gravity = 0, left, box("box1", 16, 100), right }
  end, {
    "run:step(1 / 60); box1 at 16 + (left + right) / 120, 100; box1.vx ~ (left + right) / 2",
  }, { "left, right", { 20, -20 }, { 30, -10 }, { 0, -40 }, { 50, 20 } })

  -- Long after they have passed right through each other, too.
  row("is no throw with mass {mass}", SOME, between, {
    "log = watch(run, box1)",
    { 5, "box1 at 92, 100", "abs(box1.vx) <= 20 + 1e-6", "abs(box1.vy) <= 20 + 1e-6" },
    "log.count == 1; box1 still",
  }, { "mass, count, fields", { 1, 1, { mass = 1 } }, { 1000, 1, { mass = 1000 } } })

  row("is no throw with {what}", SOME, between, {
    { "log = watch(run, box1)", 1 },
    { 1 / 6, "log.count == 1" },
  }, {
    "what, count, fields",
    { "restitution 1", 1, { restitution = 1 } },
    { "friction 1", 1, { friction = 1 } },
    { "pushable = false", 1, { pushable = false } },
    { "ax 3000", 1, { ax = 3000 } },
    { "no gravity", 1, { gravity = 0, gravityX = 0 } },
  })
end)

--   +-----+  +--+|\
--   |press|  |  || \    to x = 121, beyond what is at 100; the other slope is far away
--   +-----+  +--++--+
row("slope: between a press and {what} a box ends {where}", play.ONCE, function(v)
  local block = solid("block", 100, 84, 64, 32)
  block[2].slope = v.slope
  local far = solid("far", 500, 84, 64, 32)
  far[2].slope = "left"
  return { FLOOR, block, far, wall("press", 60, 101, 16, 14), box("box", 83, 100) }
end, {
  { "press.vx = 60", 0.75, "box.x ~ x" },
}, {
  "what, where, slope, x",
  { "its upright face", "before it", "left", 84 },
  { "a wall", "half in each", nil, 102.5 },
})

describe("onCrush: from above or below", function()
  --   ------------- ceiling, its lower side at y = 16
  --       +-+
  --       +-+
  --     +=====+     lift, `gap` px too low
  for count = 1, 3 do
    for vy, gap in pairs({ [-60] = 30, [-600] = 90 }) do
      local title = ("(8) by a lift at %g px/s and a ceiling: %d on each other"):format(vy, count)
      scene.it(title, EVERYWHERE, function(run)
        local description =
          { solid("ceiling", 0, 0, 200, 16), wall("lift", 80, 16 + gap + 16 * count, 40, 8) }
        for i = 1, count do
          description[i + 2] = box("box" .. i, 92 + i, gap + 16 * i)
        end
        local named = run:build(description)
        run:play(1 / 6)
        named.lift.vy = vy
        local share, once, views = newRow(run, named, count, named.ceiling, named.lift, "y")
        local seconds = vy == -60 and 2 / 3 or 1 / 6 -- 10 px too far
        for time in run:steps(seconds) do
          share(16, -gap - vy * time, 1e-6 - vy)
        end
        once()
        named.lift.vy = -vy
        for _ in run:steps(seconds) do
          share(0, 0, 400 - vy)
        end
        named.lift.vy = 0
        run:play(0.5)
        for i = 1, count do
          run:at(views[i], 92 + i, gap + 16 * i)
          run:still(views[i])
        end
      end)
    end
  end

  --     +=====+  press
  --       +-+ v
  --       +-+
  --   -------------
  for count = 1, 3 do
    for _, gravity in ipairs({ 800, 0 }) do
      local title = ("by a press on a floor, gravity %d: %d on each other"):format(gravity, count)
      scene.it(title, gravity == 800 and EVERYWHERE or SOME, function(run)
        local press = wall("press", 80, 116 - 16 * count - 30 - 8, 40, 8)
        local description = { gravity = gravity, FLOOR, press }
        for i = 1, count do -- from above, in the order of the shares
          description[i + 2] = box("box" .. i, 92 + i, 100 - 16 * (count - i))
        end
        local named = run:build(description)
        named.press.vy = 60
        local share, once, views = newRow(run, named, count, named.press, named.floor, "y")
        for time in run:steps(2 / 3) do
          local deep = math.max(0, 60 * time - 30)
          share(116 - 16 * count + deep, deep, 60 + 1e-6)
        end
        once()
        named.press.vy = -60
        run:play(1)
        share(0, 0, 60 + 1e-6)
        for i = 1, gravity == 800 and count or 0 do
          run:near("y", views[i].y, 100 - 16 * (count - i))
          run:still(views[i])
        end
      end)
    end
  end

  local HEAVY = scene.maker("boxes", { mass = 10000 })("heavy", 80, 0, 40, 16)
  local UNDER = { FLOOR, box("box1", 92, 100), HEAVY }
  row("by a heavy one: nothing, that is no wall", SOME, UNDER, {
    "log = watch(run, box1)",
    { 1, "box1 at 92, 100" },
    "heavy at 80, 84; log.count == 0",
  })

  local PRESS = { FLOOR, wall("press", 80, 62, 40, 8), box("box1", 92, 100), box("box2", 110, 100) }
  row("by a press: one that walks out in time is not, one that is held is", SOME, PRESS, {
    "press.vy, log, log2 = 60, watch(run, box1), watch(run, box2)",
    { 1, keep = "box2.vx = 100" },
    "log.count == 1; log2.count == 0; box2 at 210, 100",
  })
end)

-- While the press moved the ball counted as one that may bounce, which nothing squeezes.
it("onCrush: a ball is told once, also if the press stops or turns while it holds it", function()
  for _, rate in ipairs({ 30, 60, 144 }) do
    for _, after in ipairs({ 0, 60, -30 }) do
      local world, told = physics.newWorld({ gravity = 800 }), 0
      world:add("floors", { x = -50, y = 100, width = 200, height = 20, static = true })
      local press = { x = -50, y = 20, width = 150, height = 20, kinematic = true, vy = 60 }
      world:add("presses", press)
      local ball = world:add("balls", { x = 0, y = 84, radius = 8 })
      function ball.onCrush()
        told = told + 1
      end
      for step = 1, 2 * rate do
        press.vy = press.y < 68 and step < 1.5 * rate and 60 or step < 1.5 * rate and 0 or after
        world:update(1 / rate)
        press.vy = press.y > 80 and 0 or press.vy
      end
      assert.same({ rate, after, 1 }, { rate, after, told })
    end
  end
end)

it("onCrush: what is put elsewhere leaves the same lift by the shortest way, at once", function()
  local world, isCrushed = physics.newWorld({ gravity = 900 }), false
  world:add("tiles", small.tile(736, 100, 48, 200))
  local lift = small.put(640, 208, 48, 12, { kinematic = true, vx = 60 })
  world:add("lifts", lift)
  local man = world:add("men", small.put(720, 200, 12, 24, { gravity = 0 }))
  function man.onCrush()
    isCrushed = true
  end
  while not isCrushed do
    world:update(1 / 60)
  end
  man.x, man.y, man.vx, man.vy, man.gravity = lift.x + 10, 208, 0, 0, 900
  local x = man.x
  small.run(world, 3)
  assert.equal(x, man.x)
  assert.is_true(man.y >= 220 and man.y < 222)
end)

it("onCrush: put elsewhere under the same press, an object is told again", function()
  local world, told = physics.newWorld({ gravity = 800 }), 0
  world:add("floors", small.put(0, 100, 200, 20, { static = true }))
  local press = world:add("presses", small.put(0, 50, 200, 20, { kinematic = true, vy = 60 }))
  local man = world:add("men", small.put(50, 76, 12, 24))
  function man.onCrush()
    told = told + 1
  end
  small.run(world, 12)
  assert.equal(1, told)
  man.x, press.vy = 100, 0
  small.run(world, 2)
  assert.same({ 2, 100 }, { told, man.x })
end)

--    ______      ______
--    |  .-'      |    |  down to the floor, and up again after a while
--    |-'( )#     | [] |
--   ---------   --[]---
it("onCrush: a press that waits holds a ball in a corner, and a stack, and tells once", function()
  for _, rate in ipairs({ 30, 60, 144 }) do
    for _, slope in ipairs({ "topleft", false }) do
      local world, told = physics.newWorld({ gravity = 800 }), 0
      local press =
        small.put(0, slope and 10 or -20, 100, 50, { kinematic = true, slope = slope or nil })
      world:add("floors", small.put(-50, 100, 200, 20, { static = true }))
      world:add("presses", press)
      world:add("walls", small.put(60, 0, 16, 100, { static = true }))
      local low = slope and { x = 40, y = 80, radius = 10 } or small.put(40, 80, 20, 20)
      world:add("things", low)
      if not slope then
        world:add("things", small.put(40, 60, 20, 20))
      end
      function low.onCrush()
        told = told + 1
      end
      for step = 1, 4 * rate do
        press.vy = step <= rate and 60 or step <= 2 * rate and 0 or -20
        local y = low.y
        world:update(1 / rate)
        assert.is_true(math.abs(low.y - y) <= 2)
        assert.equal(40, low.x)
      end
      assert.same({ rate, slope, 1 }, { rate, slope, told })
      assert.is_true(math.abs(low.y - 80) < 1e-6)
    end
  end
end)

--   | #### |
--   |( )   |   two balls that lean on each other in a shaft: free when the press is up
--   |   ( )|
it("onCrush: balls that lean on each other are told at each stroke of a press", function()
  for _, rate in ipairs({ 30, 60, 144 }) do
    local world, told = physics.newWorld({ gravity = 800 }), 0
    world:add("walls", small.put(-50, 200, 200, 20, { static = true }))
    world:add("walls", small.put(-20, -200, 20, 400, { static = true }))
    world:add("walls", small.put(16.5, -200, 20, 400, { static = true }))
    world:add("balls", { x = 0.5, y = 174, radius = 8 })
    local ball = world:add("balls", { x = 0, y = 158, radius = 8 })
    function ball.onCrush()
      told = told + 1
    end
    small.run(world, 4 * rate, rate)
    local press = small.put(0, ball.y - 60, 16.5, 20, { kinematic = true })
    world:add("presses", press)
    for stroke = 1, 3 do
      for _, vy in ipairs({ 60, -60, 0, 0 }) do
        press.vy = vy
        small.run(world, 0.8 * rate, rate)
      end
      assert.same({ rate, stroke }, { rate, told })
    end
  end
end)

it("onCrush: names two objects of the world where only one side of an object is pressed", function()
  local world, told = physics.newWorld({ gravity = 800 }), 0
  local function put(group, x, y, width, height, fields)
    return world:add(group, small.put(x, y, width, height, fields))
  end
  put("floors", -200, 100, 800, 40, { static = true })
  put("lifts", 26, 52, 21, 29, { kinematic = true, vx = 80, vy = 20 })
  put("lifts", 53, 43, 23, 38, { kinematic = true, vx = -40, vy = 80 })
  put("lifts", 4, 43, 22, 26, { kinematic = true, vy = 140 })
  world:add("boxes", { x = 26, y = 62, radius = 10 })
  put("boxes", 27, 65, 14, 12)
  put("boxes", 31, 60, 8, 19)
  function world.onCrush(object, a, b)
    told = told + 1
    for _, other in ipairs({ a, b }) do
      assert.is_string(world:groupOf(other))
      assert.not_equal(object, other)
    end
  end
  small.run(world, 40)
  assert.is_true(told > 2)
end)

it("slope: one near a box that is pressed to the ground has no say in where that ends", function()
  for gap = 1, 8 do
    local world = physics.newWorld({ gravity = 800 })
    world:add("floors", small.tile(0, 100, 400, 20))
    world:add("presses", small.put(90, 60, 40, 10, { kinematic = true, vy = 30 }))
    world:add("slopes", small.tile(124 + gap, 90, 20, 10, { slope = "right" }))
    local pressed = world:add("boxes", small.put(104, 80, 20, 20))
    small.run(world, 30)
    assert.same({ gap, 104, 82.5 }, { gap, pressed.x, pressed.y })
  end
end)
