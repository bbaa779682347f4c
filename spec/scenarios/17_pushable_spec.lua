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
  --   +-+ ->  +-+         U and V cannot be pushed, P and the boxes can
  --   +-+     |U|
  --   ------------
  local function at(x, vx, mass)
    return { x = x, vx = vx, mass = mass }
  end

  -- Objects by name: x, vx, mass; speeds that the game writes before each step; for how long; where
  -- all are then, and which is not still, but how fast.
  local ROWS = {
    { "stops a box", { P = at(20), U = at(80) }, { P = 100 }, 1, { P = 64, U = 80 } },
    { "stops one of 1000 px/s", { P = at(20), U = at(80) }, { P = 1000 }, 1, { P = 64, U = 80 } },
    {
      "stops what is heavy",
      { P = at(20, 0, 50), U = at(80) },
      { P = 6000 },
      1,
      { P = 64, U = 80 },
    },
    { "pushes a box", { U = at(20, 100), P = at(80) }, {}, 2, { U = 220, P = 236 }, 100 },
    {
      "pushes a heavy one",
      { U = at(20, 100), P = at(80, 0, 99) },
      {},
      2,
      { U = 220, P = 236 },
      100,
    },
    { "is stopped by a wall", { U = at(20, 300), wall = at(200) }, {}, 1, { U = 184 } },
    {
      "is stopped by what it pushes to a wall",
      { U = at(20), P = at(70), Q = at(90), R = at(110), wall = at(200) },
      { U = 100 },
      2,
      { U = 136, P = 152, Q = 168, R = 184 },
    },
    { "is moved by a kinematic one", { U = at(46), K = at(0, 60) }, {}, 1, { U = 76 }, 60 },
    -- two that cannot be pushed
    { "meets another", { U = at(0, 100), V = at(100, -100, 10) }, {}, 2, { U = 42, V = 58 } },
    { "meets a slow one", { U = at(0, 100), V = at(100, -50, 10) }, {}, 2, { U = 56, V = 72 } },
    { "meets a fast one", { U = at(0, 10), V = at(100, -200, 10) }, {}, 2, { U = 4, V = 20 } },
    { "meets one that stands", { U = at(0, 100), V = at(100) }, {}, 2, { U = 84, V = 100 } },
    { "stands, and is met", { U = at(0), V = at(100, -100, 10) }, {}, 2, { U = 0, V = 16 } },
    { "meets at 6000 px/s", { U = at(0, 6000), V = at(100, -6000, 9) }, {}, 2, { U = 42, V = 58 } },
    { "follows a slow one", { U = at(0, 100), V = at(100, 40) }, {}, 2, { U = 164, V = 180 }, 40 },
    { "is followed", { V = at(0, -40), U = at(100, -100) }, {}, 2, { V = -80, U = -64 }, -40 },
  }
  for _, row in ipairs(ROWS) do
    scene.it(row[1], EVERYWHERE, function(run)
      local description = { FLOOR }
      for name, fields in pairs(row[2]) do
        local make = (name == "U" or name == "V") and firm or box
        local entry = name == "wall" and WALL or make(name, fields.x, 100, fields)
        entry[2].kinematic = name == "K" or nil
        description[#description + 1] = entry
      end
      table.sort(description, function(a, b)
        return a[2].name < b[2].name
      end)
      local named, keep = run:build(description), {}
      for name, vx in pairs(row[3]) do
        keep[1], keep[2] = named[name], vx
      end
      for _ in run:steps(row[4], run:keep(keep[1], keep[2])) do
        for name in pairs(row[5]) do
          run:near("y", named[name].y, 100)
        end
      end
      for name, x in pairs(row[5]) do
        run:at(named[name], x, 100)
        run:near("vx of " .. name, named[name].vx, row[6] or 0)
      end
    end)
  end

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

  scene.it("is crushed between two walls that move, once", SOME, function(run)
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
