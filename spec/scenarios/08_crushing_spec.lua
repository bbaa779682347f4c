--- Crushing: held between two that cannot give way.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local abs = math.abs

local FLOOR =
  { "tiles", { name = "floor", x = -200, y = 116, width = 800, height = 32, static = true } }

local function box(name, x, y, fields)
  local object = { name = name, x = x, y = y, width = 16, height = 16 }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return { "boxes", object }
end

local function tile(name, x, y, width, height)
  local object = { name = name, x = x, y = y, width = width or 16, height = height or 16 }
  object.static = true
  return { "tiles", object }
end

local function wall(name, x, y, width, height, vx, vy)
  local object = { name = name, x = x, y = y, width = width, height = height, kinematic = true }
  object.vx, object.vy = vx or 0, vy or 0
  return { "walls", object }
end

--- Row 8's scene: two walls that meet at x = 100 after 1.2 s, `count` boxes in the middle.
local function between(count, fields)
  local half = 8 * count
  local description = {
    FLOOR,
    wall("L", 60 - (half - 8), 52, 16, 64, 20),
    wall("R", 124 + (half - 8), 52, 16, 64, -20),
  }
  for i = 1, count do
    description[i + 3] = box("box" .. i, 100 - half + 16 * (i - 1), 100, fields)
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

--- Fails unless an object was crushed `count` times, the last time between these two.
local function crushed(run, log, count, one, other, axis)
  run:same("onCrush", log.count, count)
  run:same("axis", log.axis, axis)
  local found = log.a == one and log.b == other or log.a == other and log.b == one
  run:check(found, "should be crushed by others than %s and %s", log.a.name, log.b.name)
end

local function finite(run, view, limit)
  run:check(abs(view.vx) <= limit + 1e-6, "vx is %.9g", view.vx)
  run:check(abs(view.vy) <= limit + 1e-6, "vy is %.9g", view.vy)
end

-- How far a box of a crushed row may be from its even share of the overlap, `deep` px: by half of
-- that, so that none leaves the room. One box alone is in the middle, exactly.
local function reach(count, deep)
  return count > 1 and deep / 2 + 1e-6 or 1e-6
end

--- Watches the boxes of a row of `count` between two others. Returns their views, those of the
--- others under 0 and count + 1; and a function that fails unless each was crushed once by its
--- neighbours.
local function newRow(run, named, count, first, last, axis)
  local views, logs = { [0] = first, [count + 1] = last }, {}
  for i = 1, count do
    views[i] = named["box" .. i]
    logs[i] = watch(run, views[i])
  end
  return views,
    function()
      for i = 1, count do
        crushed(run, logs[i], 1, views[i - 1], views[i + 1], axis)
      end
    end
end

describe("onCrush: inside something, with no way out,", function()
  --   ## ## ## ##
  --      +-+         grows from 16 to 24 px
  --   ## ## ## ##
  scene.it("tells by what it grows into and what is in its way out, once", {
    rate = variants.RATES,
  }, function(run)
    local description = { box("box", 103, 84, { width = 12 }) }
    for i = 0, 12 do
      description[#description + 1] = tile("floor" .. i, 16 * i, 100)
      description[#description + 1] = tile("ceiling" .. i, 16 * i, 68)
    end
    local named = run:build(description)
    local log = watch(run, named.box)
    run:play(0.5)
    run:same("onCrush", log.count, 0)
    for times = 1, 2 do
      named.box.height = 24
      for _ in run:steps(0.5) do
        run:same("onCrush", log.count, times)
        run:at(named.box, 103, 80) -- half of it in each
        run:still(named.box)
      end
      run:same("axis", log.axis, "y")
      run:check(log.a.name:match("^ceiling") or log.b.name:match("^ceiling"), "by no ceiling")
      run:check(log.a.name:match("^floor") or log.b.name:match("^floor"), "by no floor")
      named.box.height = 16
      run:play(0.5)
      run:at(named.box, 103, 84)
      run:touches(named.box, "bottom", "top")
    end
  end)

  scene.it("tells once in a block of tiles, too", nil, function(run)
    local description = { box("box", 70, 70, { width = 12, height = 12 }) }
    for i = 0, 80 do
      description[i + 2] = tile("tile" .. i, 16 * (i % 9), 16 * math.floor(i / 9))
    end
    local named = run:build(description)
    local log = watch(run, named.box)
    for _ in run:steps(0.5) do
      run:same("onCrush", log.count, 1)
      run:at(named.box, 70, 70)
    end
  end)
end)

--   |L|  +-+  |R|
--   |L|->+-+<-|R|
--   -------------
describe("onCrush: between two walls", function()
  scene.it("(8) tells once, at the step after they have met it", {
    turn = variants.TURNS,
  }, function(run)
    local named = run:build(between(1))
    local log = watch(run, named.box1)
    for time in run:steps(1) do
      local step = math.floor(time * 60 + 0.5)
      run:same("onCrush at step " .. step, log.count, step >= 49 and 1 or 0)
    end
  end)

  for count = 1, 3 do
    local title = ("(8) %d share the overlap, each is told once, and they are let go"):format(count)
    scene.it(title, EVERYWHERE, function(run)
      local named = run:build(between(count))
      local views, expectCrushed = newRow(run, named, count, named.L, named.R, "x")
      local seconds = count == 1 and 1.5 or 1
      for time in run:steps(seconds) do
        local deep = math.max(0, 2 * (20 * time - 16))
        for i = 1, count do
          run:near("y", views[i].y, 100)
          finite(run, views[i], 20)
          local left = named.L.x + 16 + 16 * (i - 1) - i * deep / (count + 1)
          if deep > 0 then
            run:near("x of " .. i, views[i].x, left, reach(count, deep))
          end
        end
        if count == 1 then
          run:at(named.box1, 92, 100)
        end
      end
      expectCrushed()
      named.L.vx, named.R.vx = -20, 20
      run:play(seconds)
      expectCrushed()
      for i = 1, count do
        -- In order, within a quarter of its size of where even shares would leave it.
        run:at(views[i], 100 - 8 * count + 16 * (i - 1), 100, count > 1 and 4 or 1e-6)
        local gap = views[i].x - views[i - 1].x - (i == 1 and 0 or 16)
        run:check(gap >= -1e-6, "overlap by %.9g px", -gap)
        run:still(views[i])
      end
      named.box1.vx = count == 1 and 10 or 0
      local x = named.box1.x
      for time in run:steps(count == 1 and 0.5 or 0) do
        run:at(named.box1, x + 10 * time, 100)
        run:touches(named.box1, "bottom")
      end
    end)
  end

  scene.it("tells if one of them stands still, too", SOME, function(run)
    local post = tile("post", 124, 52, 16, 64)
    local named = run:build({ FLOOR, wall("L", 60, 52, 16, 64, 20), post, box("box1", 92, 100) })
    local log = watch(run, named.box1)
    for time in run:steps(2) do
      local pushed = 76 + 20 * time
      run:at(named.box1, pushed > 108 and (pushed + 108) / 2 or math.max(92, pushed), 100)
      finite(run, named.box1, 20)
    end
    crushed(run, log, 1, named.L, named.post, "x")
  end)

  --   |L|  +--+--|R|   8 px inside the second box, and only 6 px of room
  --   |L|  +--+--|R|
  for _, vx in ipairs({ 0, 5, -30 }) do
    scene.it(("tells all of a row that one is put into, at %g px/s"):format(vx), SOME, function(run)
      local named = run:build({
        gravity = 0,
        wall("L", 0, 100, 16, 16),
        box("box1", 22, 100),
        box("box2", 38, 100),
        wall("R", 46, 100, 16, 16, vx),
      })
      local views, expectCrushed = newRow(run, named, 2, named.L, named.R, "x")
      for _ = 1, 6 do -- it comes out of the wall, into the other box, and both are pressed
        run:step(1 / 60)
      end
      local deep = 16 + 32 - (46 + 6 * vx / 60)
      run:at(views[1], 16 - deep / 3, 100, reach(2, deep))
      run:at(views[2], 32 - 2 * deep / 3, 100, reach(2, deep))
      expectCrushed()
    end)
  end

  scene.it("takes it along at the mean of their speeds", SOME, function(run)
    for _, speeds in ipairs({ { 20, -20 }, { 30, -10 }, { 0, -40 }, { 50, 20 } }) do
      local mean = (speeds[1] + speeds[2]) / 2
      local named = run:build({
        gravity = 0,
        wall("L", 0, 100, 16, 16, speeds[1]),
        box("box1", 16, 100),
        wall("R", 32, 100, 16, 16, speeds[2]),
      })
      run:step(1 / 60)
      run:at(named.box1, 16 + mean / 60, 100)
      run:near("vx", named.box1.vx, mean)
    end
  end)

  -- Long after they have passed right through each other, too.
  for _, fields in ipairs({
    { mass = 1 },
    { restitution = 1 },
    { mass = 1000 },
    { friction = 1 },
    { pushable = false },
    { ax = 3000 },
    { gravity = 0, gravityX = 0 },
  }) do
    local name, value = next(fields)
    scene.it(("is no throw with %s = %s"):format(name, tostring(value)), SOME, function(run)
      local named = run:build(between(1, fields))
      local log, seconds = watch(run, named.box1), name == "mass" and 5 or 7 / 6
      for time in run:steps(seconds) do
        if name == "mass" or time > 1 then
          run:at(named.box1, 92, 100)
          finite(run, named.box1, 20)
        end
      end
      run:same("onCrush", log.count, 1)
      if name == "mass" then
        run:still(named.box1)
      end
    end)
  end
end)

describe("onCrush: from above or below", function()
  --   ------------- ceiling, its lower side at y = 16
  --       +-+
  --       +-+
  --     +=====+     lift
  --- `count` boxes on a lift, `gap` px below the ceiling.
  local function stack(count, gap)
    local description = {
      tile("ceiling", 0, 0, 200),
      wall("lift", 80, 16 + gap + 16 * count, 40, 8),
      box("bystander", 400, 0, { gravity = 0, gravityX = 0 }),
    }
    for i = 1, count do
      description[i + 3] = box("box" .. i, 92 + i, gap + 16 * i)
    end
    return description
  end

  for count = 1, 3 do
    for vy, gap in pairs({ [-60] = 30, [-600] = 90 }) do
      local title = ("(8) by a lift at %g px/s and a ceiling: %d on each other"):format(vy, count)
      scene.it(title, EVERYWHERE, function(run)
        local named = run:build(stack(count, gap))
        run:play(1 / 6)
        named.lift.vy = vy
        local views, expectCrushed = newRow(run, named, count, named.ceiling, named.lift, "y")
        local seconds = vy == -60 and 2 / 3 or 1 / 6 -- 10 px too far
        for time in run:steps(seconds) do
          local deep = -gap - vy * time
          for i = 1, count do
            run:near("x", views[i].x, 92 + i)
            finite(run, views[i], -vy)
            if deep > 1e-3 then
              local y = 16 + 16 * (i - 1) - i * deep / (count + 1)
              run:near("y", views[i].y, y, reach(count, deep))
            end
          end
        end
        expectCrushed()
        named.lift.vy = -vy
        for _ in run:steps(seconds) do
          for i = 1, count do
            run:near("x on the way back", views[i].x, 92 + i)
            finite(run, views[i], -vy + 400)
          end
        end
        named.lift.vy = 0
        run:play(0.5)
        for i = 1, count do
          run:at(views[i], 92 + i, gap + 16 * i)
          run:still(views[i])
        end
        run:at(named.bystander, 400, 0)
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
        local description = {
          gravity = gravity,
          FLOOR,
          wall("press", 80, 116 - 16 * count - 30 - 8, 40, 8, 0, 60),
          box("near", 160, 100, { gravity = 0, gravityX = 0 }),
        }
        for i = 1, count do
          description[i + 3] = box("box" .. i, 92 + i, 116 - 16 * i)
        end
        local named = run:build(description)
        local views, expectCrushed = newRow(run, named, count, named.floor, named.press, "y")
        for time in run:steps(2 / 3) do
          local deep = math.max(0, 60 * time - 30)
          for i = 1, count do
            run:near("x", views[i].x, 92 + i)
            local y = 116 - 16 * i + i * deep / (count + 1)
            run:near("y", views[i].y, y, reach(count, deep))
            finite(run, views[i], 60)
          end
          run:at(named.near, 160, 100)
        end
        expectCrushed()
        named.press.vy = -60
        run:play(1)
        for i = 1, count do
          run:near("x", views[i].x, 92 + i)
          finite(run, views[i], 60)
          if gravity == 800 then
            run:near("y", views[i].y, 116 - 16 * i)
            run:still(views[i])
          end
        end
      end)
    end
  end

  scene.it("by a heavy one that falls on it: nothing, that is no wall", SOME, function(run)
    local heavy = box("heavy", 80, 0, { mass = 10000, width = 40 })
    local named = run:build({ FLOOR, box("box1", 92, 100), heavy })
    local log = watch(run, named.box1)
    for _ in run:steps(1) do
      run:at(named.box1, 92, 100)
    end
    run:at(named.heavy, 80, 84)
    run:same("onCrush", log.count, 0)
  end)

  scene.it("by a press: one that walks out in time is not, one that is held is", SOME, function(run)
    local press = wall("press", 80, 62, 40, 8, 0, 60)
    local named = run:build({ FLOOR, press, box("box1", 92, 100), box("box2", 110, 100) })
    local log, log2 = watch(run, named.box1), watch(run, named.box2)
    run:play(1, run:keep(named.box2, 100))
    run:same("onCrush", log.count, 1)
    run:same("onCrush of the one that left", log2.count, 0)
    run:at(named.box2, 210, 100)
  end)
end)
