--- `pushable = false`: others cannot push it, walls still stop it.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME

local FLOOR = {
  "tiles",
  { name = "floor", x = -500, y = 116, width = 1500, height = 32, static = true },
}
local WALL = { "tiles", { name = "wall", x = 200, y = 0, width = 16, height = 116, static = true } }

local function box(name, x, y, fields)
  local object = { name = name, x = x, y = y, width = 16, height = 16 }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return { "boxes", object }
end

local function firm(name, x, y, fields)
  local entry = box(name, x, y, fields)
  entry[2].pushable = false
  return entry
end

describe("pushable = false", function()
  --   +-+ ->  +-+
  --   +-+     |U|
  --   ------------
  describe("against one that can be pushed,", function()
    for _, row in ipairs({ { 100, 1 }, { 1000, 1000 }, { 6000, 50 } }) do
      local vx, mass = row[1], row[2]
      scene.it(
        ("it stays where it is, hit at %g px/s by mass %g"):format(vx, mass),
        EVERYWHERE,
        function(run)
          local named = run:build({ FLOOR, box("P", 20, 100, { mass = mass }), firm("U", 80, 100) })
          for _ in run:steps(1, run:keep(named.P, vx)) do
            run:at(named.U, 80, 100)
            run:still(named.U)
          end
          run:at(named.P, 64, 100)
          run:flush(named.P, named.U, "right")
          run:still(named.P)
        end
      )
    end

    scene.it("it pushes a box, and keeps its speed", EVERYWHERE, function(run)
      for _, mass in ipairs({ 1, 100 }) do
        local named = run:build({
          FLOOR,
          firm("U", 20, 100, { vx = 100 }),
          box("P", 80, 100, { mass = mass }),
        })
        for time in run:steps(2) do
          run:at(named.U, 20 + 100 * time, 100)
          run:same("vx", named.U.vx, 100)
          run:at(named.P, math.max(80, 36 + 100 * time), 100)
        end
        run:near("gap", named.P.x - named.U.x - 16, 0)
      end
    end)

    scene.it("a box bounces off it", SOME, function(run)
      local named = run:build({
        FLOOR,
        box("P", 14, 100, { vx = 100, restitution = 1 }),
        firm("U", 80, 100),
      })
      for time in run:steps(1) do
        run:at(named.P, 14 + math.min(100 * time, 100 - 100 * time), 100)
        run:at(named.U, 80, 100)
      end
    end)
  end)

  describe("against a wall:", function()
    scene.it("it is stopped", EVERYWHERE, function(run)
      local named = run:build({ FLOOR, WALL, firm("U", 20, 100, { vx = 300 }) })
      for time in run:steps(1) do
        run:at(named.U, math.min(184, 20 + 300 * time), 100)
      end
      run:flush(named.U, named.wall, "right")
      run:still(named.U)
    end)

    scene.it("it is stopped by what it pushes there", EVERYWHERE, function(run)
      for count = 1, 3 do
        local description = { FLOOR, WALL, firm("U", 20, 100) }
        for i = 1, count do
          description[3 + i] = box("box" .. i, 50 + 20 * i, 100)
        end
        local named = run:build(description)
        for _ in run:steps(2, run:keep(named.U, 100)) do
          for i = 1, count do
            run:near("y", named["box" .. i].y, 100)
          end
        end
        run:at(named.U, 184 - 16 * count, 100)
        for i = 1, count do
          run:at(named["box" .. i], 184 - 16 * (count - i), 100)
        end
        run:still(named.U)
        run:flush(named.U, named.box1, "right")
      end
    end)

    scene.it("it is moved by a kinematic one", SOME, function(run)
      local pusher = { name = "K", x = 0, y = 50, width = 16, height = 64, kinematic = true }
      pusher.vx = 60
      local named = run:build({ FLOOR, { "walls", pusher }, firm("U", 46, 100) })
      for time in run:steps(1) do
        run:at(named.U, math.max(46, 16 + 60 * time), 100)
      end
      run:near("vx", named.U.vx, 60)
    end)

    scene.it("it is crushed between two of them, once", SOME, function(run)
      local named = run:build({
        FLOOR,
        { "walls", { name = "L", x = 60, y = 52, width = 16, height = 64, kinematic = true } },
        { "walls", { name = "R", x = 124, y = 52, width = 16, height = 64, kinematic = true } },
        firm("U", 92, 100),
      })
      local log = run:listen(named.U)
      named.L.vx, named.R.vx = 20, -20
      for _ in run:steps(1) do
        run:at(named.U, 92, 100)
      end
      run:same("onCrush", log.crushes, 1)
    end)
  end)

  --   +-+ ->   <- +-+
  --   |U|         |V|
  --   ----------------
  describe("two of them:", function()
    for _, row in ipairs({
      -- vx of U at 0 and of V at 100, where U ends
      { 100, -100, 42 },
      { 100, -50, 56 },
      { 10, -200, 4 },
      { 100, 0, 84 },
      { 0, -100, 0 },
      { 6000, -6000, 42 },
    }) do
      local vxU, vxV, x = row[1], row[2], row[3]
      scene.it(("meet at %g and %g px/s and stop"):format(vxU, vxV), EVERYWHERE, function(run)
        local named = run:build({
          FLOOR,
          firm("U", 0, 100, { vx = vxU }),
          firm("V", 100, 100, { vx = vxV, mass = 10 }),
        })
        local log = run:listen(named.U)
        run:play(2)
        for _ in run:steps(0.5) do
          run:at(named.U, x, 100)
          run:at(named.V, x + 16, 100)
          run:still(named.U)
          run:still(named.V)
        end
        run:check(log.begins == 2 and log.ends == 0, "%d begins, %d ends", log.begins, log.ends)
      end)
    end

    scene.it("the faster one behind the slower one follows it", SOME, function(run)
      for sign = -1, 1, 2 do
        local named = run:build({
          FLOOR,
          firm("U", 0, 100, { vx = 100 * sign }),
          firm("V", 100 * sign, 100, { vx = 40 * sign }),
        })
        for time in run:steps(2) do
          run:at(named.V, (100 + 40 * time) * sign, 100)
          run:at(named.U, math.min(100 * time, 84 + 40 * time) * sign, 100)
        end
        run:near("vx", named.U.vx, 40 * sign)
      end
    end)
  end)

  --   +-+-+-+-+   +-+
  --   |U|P|Q|..   |V|
  --   +-+-+-+-+   +-+
  describe("with a row between two of them: #slow", function()
    -- U, `count` boxes and V, with gaps of `gap` px.
    local function newRow(count, gap, fieldsU, fieldsV)
      local list, size = { gravity = 0, firm("U", 0, 0, fieldsU) }, 16 + gap
      for i = 1, count do
        list[i + 1] = box("P" .. i, size * i, 0)
      end
      list[count + 2] = firm("V", size * (count + 1), 0, fieldsV)
      return list, size * (count + 1)
    end

    for _, row in ipairs({
      -- boxes, gap between all, vx of U, vx of V
      { 2, 0, 150, 0 },
      { 2, 0, 0, -150 },
      { 2, 1, 150, 0 },
      { 3, 0.5, 60, 0 },
      { 4, 5, 600, 0 },
      { 2, 5, 100, -100 },
      { 3, 0, 60, -60 },
    }) do
      local count, gap, left, right = row[1], row[2], row[3], row[4]
      local title = "%d boxes, %g px apart, at %g and %g px/s, stop them"
      scene.it(title:format(count, gap, left, right), SOME, function(run)
        local list, start = newRow(count, gap)
        local named = run:build(list)
        for _ in run:steps(1, run:keep(named.U, left, named.V, right)) do
          local last = named.U
          for i = 1, count + 1 do
            local next_ = named["P" .. i] or named.V
            local room = next_.x - last.x - 16
            run:check(room >= -1e-6, "%s is %.9g px inside %s", last.name, -room, next_.name)
            last = next_
          end
        end
        run:near("length of the row", named.V.x - named.U.x, 16 * (count + 1))
        if left == 0 then
          run:near("U", named.U.x, 0)
        elseif right == 0 then
          run:near("V", named.V.x, start)
        end
      end)
    end
  end)

  --     +-+
  --     |U|
  --    +-+-
  --    | |
  --   ------
  describe("on each other:", function()
    for _, row in ipairs({
      -- from the floor up: f cannot be pushed, b can
      "f",
      "fb",
      "bf",
      "ff",
      "fff",
      "bfb",
      "fbf",
      "bbf",
      "fbfbf",
    }) do
      scene.it(("a stack %q is dropped, and rests"):format(row), EVERYWHERE, function(run)
        local description = { FLOOR }
        for i = 1, #row do
          local make = row:sub(i, i) == "f" and firm or box
          description[i + 1] = make("box" .. i, 90 + 2 * i, 112 - 20 * i)
        end
        local named = run:build(description)
        run:play(1)
        for _ in run:steps(0.5) do
          for i = 1, #row do
            local view = named["box" .. i]
            run:at(view, 90 + 2 * i, 116 - 16 * i)
            run:still(view)
            run:flush(view, i == 1 and named.floor or named["box" .. i - 1], "bottom")
          end
        end
      end)
    end

    scene.it("a box is pushed out from under one", SOME, function(run)
      local named = run:build({ FLOOR, box("P", 20, 100), box("low", 80, 100), firm("U", 84, 84) })
      run:play(1, run:keep(named.P, 100)) -- P passes below it, too
      for _ in run:steps(1, run:keep(named.P, 100)) do
        run:near("x", named.U.x, 84)
      end
      run:at(named.U, 84, 100)
      run:near("x", named.low.x, named.P.x + 16)
    end)

    scene.it("one is carried by a lift and jumps like any other", SOME, function(run)
      local lift = { name = "lift", x = 80, y = 100, width = 64, height = 8, kinematic = true }
      local named = run:build({ { "lifts", lift }, firm("U", 92, 84), firm("V", 94, 68) })
      run:play(1 / 6)
      named.lift.vx, named.lift.vy = 60, -90
      for time in run:steps(1) do
        run:at(named.U, 92 + 60 * time, 84 - 90 * time)
        run:at(named.V, 94 + 60 * time, 68 - 90 * time)
        run:still(named.U)
        run:still(named.V)
      end
      named.V.vy = -200
      run:play(1)
      run:at(named.U, 212, -96)
      run:at(named.V, 214, -112)
      run:still(named.V)
    end)

    --      |A| v
    --      |B| ^
    --   =========== ^  lift
    scene.it(
      "one that bounces off a lift against a falling one is not held in the lift",
      SOME,
      function(run)
        local named = run:build({
          {
            "lifts",
            { name = "lift", x = 60, y = 141, width = 60, height = 8, kinematic = true, vy = -60 },
          },
          firm("A", 80, 113, { height = 10, vy = 266 }),
          firm("B", 81, 125, { height = 15, vy = 157, restitution = 0.4 }),
        })
        for _ in run:steps(1) do
          run:check(named.B.y + 15 <= named.lift.y + 1e-6, "B is in the lift")
          run:check(named.A.y + 10 <= named.B.y + 1e-6, "A is in B")
        end
        run:flush(named.A, named.B, "bottom")
        run:flush(named.B, named.lift, "bottom")
        run:still(named.A)
      end
    )
  end)

  scene.it("can be switched while it runs", SOME, function(run)
    local named = run:build({ FLOOR, box("P", 20, 100), firm("U", 80, 100) })
    run:play(1, run:keep(named.P, 100))
    run:at(named.U, 80, 100)
    named.U.pushable = nil
    run:play(1, run:keep(named.P, 100))
    run:check(named.U.x > 100, "should be pushed, is at %.9g", named.U.x)
    named.U.pushable, named.U.vx = false, 0
    run:play(1 / 6)
    local x = named.U.x
    run:play(1, run:keep(named.P, 100))
    run:near("x", named.U.x, x)
  end)
end)
