--- Corner correction: a hit that misses by a few pixels slides around the corner.

local physics = require("physics")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME

local function solid(name, x, y, width, height, fields)
  local object = { name = name, x = x, y = y, width = width, height = height, static = true }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return { "tiles", object }
end

local function body(x, y, vx, vy, fields)
  local object = { name = "body", x = x, y = y, width = 16, height = 24, vx = vx, vy = vy }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return { "players", object }
end

describe("nudge", function()
  --   +------+
  --   |      |     100 .. 164, its lower side at 66
  --   +------+
  --        +-+
  --        | | ^   a few pixels of the head below the block
  --        +-+
  describe("under the corner of a block", function()
    for _, row in ipairs({
      -- x, nudge, x behind the corner (nil: it bumps), other fields
      { 161, 4, 164 },
      { 161, 4.5, 164, { pushable = false } },
      { 160.1, 4, 164 },
      { 159.9, 4, nil },
      { 161, 2.9, nil },
      { 161, 3.1, 164 },
      { 161, 0, nil },
      { 163.5, 1, 164 },
      { 87, 4, 84 },
      { 88.1, 4, nil },
      { 130, 4, nil },
      { 130, 1000, 164 }, -- as far as one likes
      { 115, 1000, 84 }, -- and the shorter way
    }) do
      local x, nudge, behind, fields = row[1], row[2], row[3], row[4] or {}
      local does = behind and "comes up beside it" or "bumps its head"
      fields.nudge = nudge
      scene.it(("at x = %g with nudge %g %s"):format(x, nudge, does), EVERYWHERE, function(run)
        local named = run:build({
          solid("block", 100, 50, 64, 16),
          solid("floor", 0, 200, 400, 16),
          body(x, 176, 0, -400, fields),
        })
        local log = run:listen(named.body)
        named.body.vy = -500
        local bumped = (500 - math.sqrt(500 * 500 - 1600 * 110)) / 800
        for time in run:steps(2 / 3) do
          local y = 176 - 500 * time + 400 * time * time
          if time < bumped - 1e-6 then
            run:at(named.body, x, y)
          elseif behind then
            run:at(named.body, behind, y)
            run:near("vy", named.body.vy, 800 * time - 500)
            run:touches(named.body)
          else
            run:near("x", named.body.x, x)
            run:check(named.body.y >= 66 - 1e-6, "its head is at %.9g", named.body.y)
          end
        end
        run:same("bumps", log.sides.top, behind and 0 or 1)
        run:same("vx", named.body.vx, 0)
      end)
    end

    scene.it("moves on sideways as before", SOME, function(run)
      -- at the block, after 0.25 s, 3 px of it are below
      local named = run:build({
        gravity = 0,
        solid("block", 100, 50, 64, 16),
        body(161 - 5, 91, 20, -100, { nudge = 4 }),
      })
      for time in run:steps(1) do
        local shift = time > 0.25 + 1e-6 and 3 or 0
        if math.abs(time - 0.25) > 1e-6 then
          run:at(named.body, 156 + 20 * time + shift, 91 - 100 * time)
        end
        run:same("vx", named.body.vx, 20)
        run:same("vy", named.body.vy, -100)
      end
    end)

    scene.it("with another block beside bumps", EVERYWHERE, function(run)
      for _, x in ipairs({ 164, 175 }) do
        local named = run:build({
          solid("block", 100, 50, 64, 16),
          solid("next", x, 40, 64, 26),
          solid("floor", 0, 200, 400, 16),
          body(161, 176, 0, -500, { nudge = 4 }),
        })
        local log = run:listen(named.body)
        for _ in run:steps(1) do
          run:near("x", named.body.x, 161)
        end
        run:same("bumps", log.sides.top, 1)
      end
    end)

    --   +------+
    --   |      +------   another one half a pixel higher
    --   +------+
    --        +-+
    scene.it(
      "with another block behind it passes the first one, and bumps at the second",
      EVERYWHERE,
      function(run)
        local named = run:build({
          gravity = 0,
          solid("block", 100, 50, 64, 16),
          solid("next", 164, 49.5, 64, 16),
          body(161, 176, 0, -400, { nudge = 4 }),
        })
        run:play(1 / 2)
        run:at(named.body, 164, 65.5)
        run:touches(named.body, "top")
      end
    )

    scene.it("fits exactly between two", EVERYWHERE, function(run)
      local named = run:build({
        solid("block", 100, 50, 64, 16),
        solid("next", 180, 50, 64, 16),
        body(161, 176, 0, -500, { nudge = 4 }),
      })
      run:play(1 / 2)
      run:at(named.body, 164, 26)
      run:near("vy", named.body.vy, -100)
    end)

    scene.it("in a row of tiles bumps at every seam", SOME, function(run)
      for i = 0, 15 do
        local description = { body(100 + i, 176, 0, -500, { nudge = 4 }) }
        scene.tiles(description, 20, 0, 50, 16, 16, 16, 0)
        local named = run:build(description)
        local log = run:listen(named.body)
        for _ in run:steps(1 / 3) do
          run:near("x", named.body.x, 100 + i)
        end
        run:check(log.sides.top >= 1, "should bump its head")
        run:check(named.body.y >= 66 - 1e-6, "its head is at %.9g", named.body.y)
      end
    end)

    -- Both sides close within a billionth of the step.
    scene.it(
      "hit corner to corner is stopped as without it",
      { shift = { 0 }, rate = { 60 }, turn = variants.TURNS },
      function(run)
        for _, off in ipairs({ 0, 4e-9, -4e-9 }) do
          local stops = {}
          for n, nudge in ipairs({ 0, 4 }) do
            local named = run:build({
              gravity = 0,
              solid("block", 100, 100, 64, 16),
              body(79 + off, 71, 600, 600, { nudge = nudge }),
            })
            run:step(1 / 60)
            stops[n] = named.body
          end
          for _, field in ipairs({ "x", "y", "vx", "vy" }) do
            run:same(field, stops[2][field], stops[1][field])
          end
          run:same("speeds stopped", stops[2].vx * stops[2].vy, 0)
        end
      end
    )

    scene.it("at 6000 px/s does the same", SOME, function(run)
      local named = run:build({
        gravity = 0,
        solid("block", 100, 50, 64, 16),
        body(161, 176, 0, -6000, { nudge = 4 }),
      })
      run:play(1 / 6)
      run:at(named.body, 164, -824)
      run:near("vy", named.body.vy, -6000)
    end)

    scene.it("slides around a moving platform, too, and not around a box", SOME, function(run)
      local named = run:build({
        gravity = 0,
        solid("block", 100, 50, 64, 16, { static = false, kinematic = true }),
        body(161, 176, 0, -400, { nudge = 4 }),
      })
      run:play(0.5)
      run:at(named.body, 164, -24)
      named = run:build({
        gravity = 0,
        solid("block", 100, 50, 64, 16, { static = false }),
        body(161, 176, 0, -400, { nudge = 4 }),
      })
      local log = run:listen(named.body)
      run:play(0.5)
      run:near("x", named.body.x, 161)
      run:same("bumps", log.sides.top, 1)
    end)
  end)

  --   +----------+
  --   | o        |    0 .. 112, 0 .. 64: the ball comes by several times
  --   |    ##    |
  --   +----------+
  it("goes as far where two others overlap", function()
    local world = physics.newWorld({ gravity = 0 })
    local box =
      world:add("boxes", { x = 260, y = 220, width = 20, height = 10, nudge = 10, vy = -300 })
    world:add("walls", { x = 260, y = 200, width = 10, height = 20, static = true })
    world:add("walls", { x = 0, y = 0, width = 16, height = 16, static = true })
    world:add("others", { x = 4, y = 6, width = 16, height = 16, oneWay = "bottom" })
    world:update(1 / 60)
    assert.near(270, box.x, 1e-9)
    assert.near(215, box.y, 1e-9)
    assert.equal(-300, box.vy)
  end)

  it("leads around the same block again and again, in one long step as in many", function()
    for _, steps in ipairs({ 1, 2, 15, 64 }) do
      local dt = 0.25 / steps
      local world = physics.newWorld({ gravity = 0, timestep = dt })
      world:setBounds(0, 0, 112, 64)
      world:add("blocks", { x = 48, y = 36, width = 12, height = 8, static = true })
      local ball = world:add("balls", { x = 0, y = 8, width = 12, height = 12 })
      ball.vx, ball.vy, ball.restitution, ball.nudge = 512, 1792, 1, 15
      for _ = 1, steps do
        world:update(dt)
      end
      assert.near(464 / 7, ball.x, 1e-6)
      assert.near(46, ball.y, 1e-6)
      assert.same({ 512, 1792 }, { ball.vx, ball.vy })
    end
  end)

  --            |  |
  --   +--+  -> +--+
  --   |  |            a doorway, y = 100 .. 124
  --   +--+     +--+
  --            |  |
  describe("at a doorway seen from above", function()
    local function doorway(height, y, nudge, vx)
      return {
        gravity = 0,
        solid("upper", 200, 0, 16, 100),
        solid("lower", 200, 100 + height, 16, 100),
        body(100, y, vx or 100, 0, { nudge = nudge }),
      }
    end

    for _, y in ipairs({ 99, 101, 97, 103.5 }) do
      scene.it(("%g px off goes through"):format(y - 100), EVERYWHERE, function(run)
        local named = run:build(doorway(24, y, 4))
        local log = run:listen(named.body)
        for time in run:steps(2, run:keep(named.body, 100)) do
          local x = 100 + 100 * time
          run:near("x", named.body.x, x)
          if x < 184 - 1e-6 then
            run:near("y", named.body.y, y)
          end
          if x > 184 + 1e-6 then
            run:near("y", named.body.y, 100)
          end
          run:same("vx", named.body.vx, 100)
        end
        run:same("begins", log.begins, 0)
      end)
    end

    scene.it("both sides of it in the way at once, goes nowhere", SOME, function(run)
      for _, y in ipairs({ 99, 99.5, 98 }) do
        local named = run:build(doorway(23, y, 4))
        run:play(2)
        run:at(named.body, 184, y)
        run:same("vx", named.body.vx, 0)
      end
    end)

    scene.it("too far off stops", EVERYWHERE, function(run)
      for _, y in ipairs({ 95, 105, 60 }) do
        local named = run:build(doorway(24, y, 4))
        run:play(2, run:keep(named.body, 100))
        run:at(named.body, 184, y)
        run:same("vx", named.body.vx, 0)
        run:touches(named.body, "right")
      end
    end)

    scene.it("without it stops at one pixel", SOME, function(run)
      local named = run:build(doorway(24, 99, 0))
      run:play(2)
      run:at(named.body, 184, 99)
    end)

    scene.it("leaning on the wall beside it goes in when it comes near", SOME, function(run)
      local named = run:build(doorway(24, 60, 4))
      run:play(1, run:keep(named.body, 100))
      run:at(named.body, 184, 60)
      run:play(1.5, function()
        named.body.vx, named.body.vy = 100, 30
      end)
      run:check(named.body.x > 200, "should have gone in, is at %.9g", named.body.x)
    end)

    scene.it("a box before the doorway is pushed, not gone around", SOME, function(run)
      local description = doorway(24, 99, 4)
      description[3][2].y = 100
      description[4] = { "boxes", { name = "box", x = 150, y = 121, width = 16, height = 24 } }
      local named = run:build(description)
      run:play(2, run:keep(named.body, 100))
      run:at(named.box, 184, 121)
      run:at(named.body, 168, 100)
    end)
  end)

  describe("with gravity", function()
    --        +-+
    --        | |  3 px of the feet on the edge
    --        +-+
    --   +------+
    scene.it("never lets slip off an edge", EVERYWHERE, function(run)
      for _, x in ipairs({ 161, 87 }) do
        local named = run:build({
          solid("block", 100, 50, 64, 16),
          body(x, -50, 0, 0, { nudge = 4 }),
        })
        local log = run:listen(named.body)
        run:play(1)
        run:at(named.body, x, 26)
        run:touches(named.body, "bottom")
        run:same("begins", log.begins, 1)
      end
    end)

    it("leads up stairs on a platform that sinks or rises, as on one that stands", function()
      for _, speed in ipairs({ -40, 0, 10, 40 }) do
        local world = physics.newWorld({ gravity = 800 })
        for _, step in ipairs({ { 0, 100 }, { 60, 92 }, { 90, 84 } }) do
          local stair = { x = step[1], y = step[2], width = 200, height = 8, vy = speed }
          stair.kinematic = true
          world:add("stairs", stair)
        end
        local man = { x = 20, y = 80, width = 12, height = 20, nudge = 9 }
        world:add("men", man)
        for _ = 1, 60 do
          man.vx = 80
          world:update(1 / 60)
        end
        assert.near(100, man.x, 80 / 60 + 1e-9)
      end
    end)

    scene.it("lets a box that floats slip off an edge", SOME, function(run)
      local named = run:build({
        solid("block", 100, 50, 64, 16),
        body(161, -50, 0, 100, { nudge = 4, gravity = 0, gravityX = 0 }),
      })
      run:play(1)
      run:at(named.body, 164, 50)
    end)

    --            +----
    --   +-+ ->   |      2 px high
    --   ---------+
    scene.it("walks up a low step, and stops at a higher one", EVERYWHERE, function(run)
      for _, height in ipairs({ 2, 6 }) do
        local named = run:build({
          solid("floor", 0, 200, 600, 16),
          solid("step", 200, 200 - height, 200, 16),
          body(100, 176, 0, 0, { nudge = 4 }),
        })
        for _ in run:steps(2, run:keep(named.body, 100)) do
        end
        if height == 2 then
          run:at(named.body, 300, 174)
          run:touches(named.body, "bottom")
        else
          run:at(named.body, 184, 176)
          run:touches(named.body, "bottom", "right")
        end
      end
    end)

    it("walks up stairs that move", function()
      scene.each({ rate = variants.RATES, order = variants.ORDERS }, function(run)
        for _, way in ipairs({ { 0, 60 }, { 0, 10 }, { 40, 30 }, { 0, -30 }, { 40, 0 } }) do
          local list = { body(-60, 276, 0, 0, { nudge = 4 }) }
          for n = 0, 10 do
            list[n + 2] = solid("stair" .. n, 8 * n - 208, 300 - 4 * n, 600, 20)
            local stair = list[n + 2][2]
            stair.static, stair.kinematic, stair.vx, stair.vy = nil, true, way[1], way[2]
            stair.x = n == 0 and -208 or 8 * n - 8
          end
          local named = run:build(list)
          for _ in run:steps(2) do
            named.body.vx = 100
          end
          run:near("y", named.body.y, named.stair10.y - 24)
          run:touches(named.body, "bottom")
        end
      end)
    end)

    --   +-+ ->  |    a beam that ends 2 px below the top of the head
    --   | |     +
    --   ---------------
    scene.it("does not duck into the floor", EVERYWHERE, function(run)
      local named = run:build({
        solid("floor", 0, 200, 600, 16),
        solid("beam", 200, 100, 16, 78),
        body(100, 176, 0, 0, { nudge = 4 }),
      })
      for time in run:steps(2, run:keep(named.body, 100)) do
        run:at(named.body, math.min(184, 100 + 100 * time), 176)
      end
      run:touches(named.body, "bottom", "right")
    end)

    scene.it("and floor tiles has no seams", SOME, function(run)
      local description = { body(0, 76, 0, 0, { nudge = 4 }) }
      scene.tiles(description, 60, 0, 100, 16, 16, 16, 0)
      local named = run:build(description)
      for time in run:steps(2, run:keep(named.body, 200)) do
        run:at(named.body, 200 * time, 76)
        run:same("vx", named.body.vx, 200)
      end
    end)

    scene.it("on a lift under a corner is moved aside with its rider on it", SOME, function(run)
      local named = run:build({
        solid("block", 100, 50, 64, 16),
        solid("lift", 140, 200, 64, 8, { static = false, kinematic = true, vy = -60 }),
        body(161, 176, 0, 0, { nudge = 4 }),
      })
      run:play(2)
      run:at(named.body, 164, 56)
      run:flush(named.body, named.lift, "bottom")
      run:still(named.body)
    end)
  end)
end)
