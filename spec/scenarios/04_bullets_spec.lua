--- Nothing is too fast.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local BOTH = { push = { "both" }, turn = variants.TURNS }

--- A bullet of 100 px a step (at 60 Hz) that starts at x = `o`, and a wall 2 px thick at x = 500.
local function shot(o, restitution)
  local bullet = { name = "bullet", x = o, y = 48, width = 4, height = 4, vx = 6000 }
  bullet.restitution = restitution
  local wall = { name = "wall", x = 500, y = 0, width = 2, height = 100, static = true }
  return { gravity = 0, { "walls", wall }, { "bullets", bullet } }
end

describe("vx and onBegin: bullets", function()
  --   +-+ vx = 6000     ||
  --   +-+ ->            ||  2 px
  --   o                500
  scene.it("(4) stop at a thin wall, from 100 distances", { turn = variants.TURNS }, function(run)
    for o = 0, 99 do
      local named = run:build(shot(o))
      local log = run:listen(named.bullet)
      run:play(10 / 60)
      run:at(named.bullet, 496, 48)
      run:flush(named.bullet, named.wall, "right")
      run:still(named.bullet)
      run:same(("begins, from %d,"):format(o), log.begins, 1)
      run:same(("begins on the right, from %d,"):format(o), log.sides.right, 1)
      run:same(("ends, from %d,"):format(o), log.ends, 0)
      run:near("speed", log.speed, 6000)
    end
  end)

  scene.it("(4) bounce off a thin wall at the right moment", EVERYWHERE, function(run)
    for o = 0, 99, 9 do
      local named = run:build(shot(o, 1))
      local log = run:listen(named.bullet)
      run:play(10 / 60)
      -- 1000 px of way: (496 - o) there, the rest back. After 6 steps from 0: 392
      run:at(named.bullet, 496 - (1000 - (496 - o)), 48)
      run:near("vx", named.bullet.vx, -6000)
      run:same("begins", log.begins, 1)
      run:same("ends", log.ends, 1)
    end
  end)

  --   +-+ 90 000 px/s                       |
  --   +-+ ->                                | 1 px
  --   0                                    5000
  scene.it("of 90 000 px/s stop flush at a wall of 1 px", EVERYWHERE, function(run)
    local named = run:build({
      gravity = 0,
      { "walls", { name = "wall", x = 5000, y = 0, width = 1, height = 100, static = true } },
      { "boxes", { name = "box", x = 0, y = 48, width = 4, height = 4, vx = 90000 } },
    })
    run:play(1 / 6)
    run:at(named.box, 4996, 48)
    run:flush(named.box, named.wall, "right")
    run:still(named.box)
    run:touches(named.box, "right")
  end)

  --   +-+ ->                    <- +-+
  --   +-+  6000           -6000    +-+
  --   0                            100
  describe("head-on", function()
    for _, row in ipairs({
      -- restitution, A, B, vx of A, vx of B
      { 0, 48, 52, 0, 0 },
      { 1, -4, 104, -6000, 6000 },
    }) do
      local restitution, atA, atB, vA, vB = row[1], row[2], row[3], row[4], row[5]
      scene.it(
        ("(4) meet in the middle of the step, restitution %g"):format(restitution),
        BOTH,
        function(run)
          local a = { name = "a", x = 0, y = 0, width = 4, height = 4, vx = 6000 }
          local b = { name = "b", x = 100, y = 0, width = 4, height = 4, vx = -6000 }
          a.restitution, b.restitution = restitution, restitution
          local named = run:build({ gravity = 0, { "boxes", a }, { "boxes", b } })
          local log = run:listen(named.a)
          run:step(1 / 60)
          run:at(named.a, atA, 0)
          run:at(named.b, atB, 0)
          run:near("vx of a", named.a.vx, vA)
          run:near("vx of b", named.b.vx, vB)
          run:same("begins", log.begins, 1)
          run:near("speed", log.speed, 12000)
        end
      )
    end

    scene.it(
      "do not pass each other with push first either",
      { push = { "first" }, turn = variants.TURNS, rate = variants.RATES },
      function(run)
        local named = run:build({
          gravity = 0,
          { "boxes", { name = "a", x = 0, y = 0, width = 4, height = 4, vx = 6000 } },
          { "boxes", { name = "b", x = 100, y = 0, width = 4, height = 4, vx = -6000 } },
        })
        run:play(1 / 6)
        run:near("distance", named.b.x - named.a.x, 4)
        run:near("vx of a", named.a.vx, 0)
        run:near("vx of b", named.b.vx, 0)
      end
    )
  end)

  --         +-+ B, 6000 px/s down
  --         +-+
  --          v
  --   +-+
  --   +-+ -> A, 6000 px/s          paths cross: B comes down on A at 0.45 of the step
  scene.it("that cross at a right angle meet", BOTH, function(run)
    local named = run:build({
      gravity = 0,
      { "boxes", { name = "a", x = 0, y = 100, width = 10, height = 10, vx = 6000 } },
      { "boxes", { name = "b", x = 50, y = 45, width = 10, height = 10, vy = 6000 } },
    })
    local a, b = run:listen(named.a), run:listen(named.b)
    run:step(1 / 60)
    -- both go on at 3000 px/s down for 0.55 steps of 50 px; nothing rubs, so A keeps its 6000
    run:at(named.a, 100, 127.5)
    run:at(named.b, 50, 117.5)
    run:near("vx of a", named.a.vx, 6000)
    run:near("vy of a", named.a.vy, 3000)
    run:near("vx of b", named.b.vx, 0)
    run:near("vy of b", named.b.vy, 3000)
    run:same("begins at the top of a", a.sides.top, 1)
    run:same("begins at the bottom of b", b.sides.bottom, 1)
    run:step(1 / 60)
    run:same("begins of a", a.begins, 1)
    run:same("ends of a", a.ends, 1)
    run:same("ends of b", b.ends, 1)
  end)

  --   +-+ ->   ||  a sensor 2 px wide
  --   +-+      ||
  scene.it("(4) are seen by a thin sensor that they cross in one step", EVERYWHERE, function(run)
    local sensor = { name = "sensor", x = 50, y = 0, width = 2, height = 100 }
    sensor.sensor, sensor.static = true, true
    local named = run:build({
      gravity = 0,
      { "sensors", sensor },
      { "bullets", { name = "bullet", x = 0, y = 48, width = 4, height = 4, vx = 6000 } },
    })
    local bullet, world = run:listen(named.bullet), run:listenToWorld()
    sensor = run:listen(named.sensor)
    for time in run:steps(1 / 6) do
      run:at(named.bullet, 6000 * time, 48)
      run:same("vx", named.bullet.vx, 6000)
      run:touches(named.bullet)
    end
    run:same("begins of the sensor", sensor.begins, 1)
    run:same("ends of the sensor", sensor.ends, 1)
    run:same("begins of the bullet", bullet.begins, 1)
    run:same("ends of the bullet", bullet.ends, 1)
    run:same("begins of the world", world.begins, 1)
    run:same("ends of the world", world.ends, 1)
  end)
end)
