--- One-way objects: solid on one side, open on the others.

local scene = require("spec.support.scene")
local turn = require("spec.support.turn")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local SETTLE = 1 / 6
local sqrt = math.sqrt

local function with(object, fields)
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return object
end

local function way(fields)
  local object = { name = "way", x = 0, y = 100, width = 200, height = 8, static = true }
  object.oneWay = "top"
  return { "ways", with(object, fields) }
end

local function tile(fields)
  local object = { name = "floor", x = 0, y = 300, width = 200, height = 8, static = true }
  return { "tiles", with(object, fields) }
end

local function body(fields)
  local object = { name = "body", x = 50, y = 200, width = 16, height = 24 }
  return { "players", with(object, fields) }
end

local function support(run, view)
  return run.views[view.raw.touching[turn.side(run.turn, "bottom")]]
end

local function standsOn(run, view, lower)
  run:same("touching.bottom", support(run, view), lower)
  run:flush(view, lower, "bottom")
  run:same("vy", view.vy, 0)
end

describe("a one-way platform", function()
  --    .  feet reach 60
  --   ===============  100
  --    |
  --   +-+
  --   +-+
  --   ---------------  300
  describe("jumped through from below", function()
    for _, row in ipairs({
      -- highest feet, feet at the end
      { 60, 100 },
      { 90, 100 },
      { 99, 100 },
      { 104, 300 },
      { 108.5, 300 },
      { 112, 300 },
    }) do
      local peak, ends = row[1], row[2]
      for name, feet in pairs({ ["the air"] = 224, ["the floor"] = 300 }) do
        scene.it(
          ("(7) from %s, feet up to %g, ends at feet %g"):format(name, peak, ends),
          EVERYWHERE,
          function(run)
            local named = run:build({ way(), tile(), body({ y = feet - 24 }) })
            if feet == 300 then
              run:play(SETTLE)
            end
            local log = run:listen(named.body)
            local up = sqrt(1600 * (feet - peak))
            named.body.vy = -up
            local apex, down = up / 800, feet == 300 and 1 or 0
            local hits = apex + sqrt((math.min(ends, 300) - peak) / 400)
            for time in run:steps(2) do
              run:near("x", named.body.x, 50)
              local y = time < hits and feet - 24 - up * time + 400 * time * time or ends - 24
              run:near("y", named.body.y, y)
              if time < hits - 1e-6 then
                run:same("begins in the air", log.begins, 0)
                run:near("vy", named.body.vy, 800 * time - up)
                run:touches(named.body)
              end
            end
            standsOn(run, named.body, ends == 100 and named.way or named.floor)
            run:same("begins", log.begins, 1)
            run:same("ends", log.ends, down)
          end
        )
      end
    end

    scene.it("at 6000 px/s is no obstacle either", SOME, function(run)
      local named = run:build({ way({ height = 1 }), body({ vy = -6000 }) })
      local log = run:listen(named.body)
      for time in run:steps(0.5) do
        run:near("y", named.body.y, 200 - 6000 * time + 400 * time * time)
      end
      run:same("begins", log.begins, 0)
    end)
  end)

  describe("fallen on", function()
    for _, speed in ipairs({ 0, 100, 6000, 90000 }) do
      for _, height in ipairs({ 8, 1 }) do
        scene.it(
          ("(7) at %g px/s, %g px thick, catches"):format(speed, height),
          EVERYWHERE,
          function(run)
            local named =
              run:build({ way({ height = height }), body({ y = 0, vx = 10, vy = speed }) })
            local log = run:listen(named.body)
            for time in run:steps(0.5) do
              local y = speed * time + 400 * time * time
              run:at(named.body, 50 + 10 * time, math.min(76, y))
            end
            standsOn(run, named.body, named.way)
            run:same("begins", log.begins, 1)
            run:same("begins at the bottom", log.sides.bottom, 1)
          end
        )
      end
    end

    scene.it("at an angle catches, too, and at its corner", SOME, function(run)
      -- the feet come down to 100 after half a second, when 1 px of them is above it
      local named = run:build({ way(), body({ x = -65, y = -24, vx = 101 }) })
      run:play(2 / 3)
      standsOn(run, named.body, named.way)
      -- beside it: nothing
      named = run:build({ way(), body({ x = -67, y = -24, vx = 100 }) })
      for time in run:steps(2 / 3) do
        run:at(named.body, -67 + 100 * time, -24 + 400 * time * time)
      end
    end)
  end)

  --  +-+ ->
  --  +=+=============   feet at 104
  describe("walked through", function()
    scene.it("(7) in the air keeps vx", EVERYWHERE, function(run)
      local floats = body({ x = -40, y = 80, vx = 100, gravity = 0, gravityX = 0 })
      local named = run:build({ way(), floats })
      local log = run:listen(named.body)
      for time in run:steps(3) do
        run:at(named.body, -40 + 100 * time, 80)
        run:same("vx", named.body.vx, 100)
      end
      run:same("begins", log.begins, 0)
    end)

    scene.it("(7) on a floor keeps vx, to and fro", EVERYWHERE, function(run)
      local named = run:build({
        way(),
        tile({ x = -300, y = 104, width = 800 }),
        body({ x = -40, y = 80 }),
      })
      run:play(SETTLE)
      for _, vx in ipairs({ 100, -100 }) do
        local x = named.body.x
        named.body.vx = vx
        for time in run:steps(1.5) do
          run:at(named.body, x + vx * time, 80)
          run:same("vx", named.body.vx, vx)
          run:touches(named.body, "bottom")
        end
      end
    end)

    scene.it("and jumped out of lands on it", SOME, function(run)
      local named = run:build({
        way(),
        tile({ x = -300, y = 104, width = 800 }),
        body({ y = 80, vx = 20 }),
      })
      run:play(SETTLE)
      named.body.vy = -sqrt(1600 * 20)
      run:play(1)
      standsOn(run, named.body, named.way)
    end)

    scene.it("what begins inside it falls out of it", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 79 }) })
      for time in run:steps(0.5) do
        run:at(named.body, 50, 79 + 400 * time * time)
      end
    end)
  end)

  describe("dropped through", function()
    scene.it("(7) at rest lets fall, once, and only the one that asked", EVERYWHERE, function(run)
      local second = body({ name = "other", x = 80, y = 76 })
      local named = run:build({ way(), tile(), body({ y = 76 }), second })
      run:play(1)
      local log, other = run:listen(named.body), run:listen(named.other)
      run:same("dropThrough", run.world:dropThrough(named.body.raw), true)
      for time in run:steps(1) do
        run:at(named.body, 50, math.min(276, 76 + 400 * time * time))
        run:at(named.other, 80, 76)
        run:still(named.other)
      end
      standsOn(run, named.body, named.floor)
      run:same("ends", log.ends, 1)
      run:same("begins", log.begins, 1)
      run:same("events of the other", other.begins + other.ends, 0)
      run:same("again", run.world:dropThrough(named.body.raw), false)
    end)

    scene.it("the step after landing on it works, too", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 60 }) })
      for _ in run:steps(1) do
        if support(run, named.body) == named.way then
          break
        end
      end
      run:same("dropThrough", run.world:dropThrough(named.body.raw), true)
      run:play(1)
      standsOn(run, named.body, named.floor)
    end)

    scene.it("in the air and on a solid does nothing", SOME, function(run)
      local named = run:build({ way(), tile(), body() })
      run:step(1 / 60)
      run:same("in the air", run.world:dropThrough(named.body.raw), false)
      run:play(1)
      run:same("on a solid", run.world:dropThrough(named.body.raw), false)
      run:play(0.5)
      standsOn(run, named.body, named.floor)
    end)

    scene.it("lets land on it again after a jump", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 76 }) })
      run:play(SETTLE)
      run.world:dropThrough(named.body.raw)
      run:play(1)
      named.body.vy = -sqrt(1600 * 240)
      run:play(2)
      standsOn(run, named.body, named.way)
    end)

    scene.it("with a box on the head, that one lands on it", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 76 }), body({ name = "top", y = 52 }) })
      run:play(SETTLE)
      run.world:dropThrough(named.body.raw)
      run:play(1)
      standsOn(run, named.body, named.floor)
      standsOn(run, named.top, named.way)
      run:at(named.top, 50, 76)
    end)

    scene.it("by a box on the head of another does nothing", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 76 }), body({ name = "top", y = 52 }) })
      run:play(SETTLE)
      run:same("dropThrough", run.world:dropThrough(named.top.raw), false)
      run:play(0.5)
      run:at(named.body, 50, 76)
      run:at(named.top, 50, 52)
    end)

    --   +-+|
    --   | || door
    --   +-+|
    --  =======
    scene.it(
      "on a solid, at a door that opens to the other side only, does nothing",
      SOME,
      function(run)
        local door = { name = "door", x = 74, y = 176, width = 8, height = 124, static = true }
        door.oneWay = "left"
        local named = run:build({ tile(), { "ways", door }, body({ y = 276, vx = 60 }) })
        run:play(0.2)
        run:same("touching the door", named.body.touching.right, named.door)
        run:same("dropThrough", run.world:dropThrough(named.body.raw), false)
        named.body.vx = 60
        run:play(0.5)
        run:at(named.body, 58, 276)
      end
    )

    scene.it("with a one-way on the head does nothing", SOME, function(run)
      local top = body({ name = "top", y = 252, oneWay = "bottom" })
      local named = run:build({ tile(), body({ y = 276 }), top })
      run:play(SETTLE)
      run:same("touching.top", named.body.touching.top, named.top)
      run:same("dropThrough", run.world:dropThrough(named.body.raw), false)
      run:play(0.5)
      run:at(named.top, 50, 252)
    end)

    --        +-+
    --   ===========+----+
    --              |    |  solid
    scene.it("while standing also on a solid, stays on that", EVERYWHERE, function(run)
      local solid = tile({ name = "solid", x = 200, y = 100, width = 100, height = 50 })
      local named = run:build({ way(), solid, body({ x = 186, y = 76 }) })
      run:play(SETTLE)
      run:same("touching.bottom", support(run, named.body), named.way)
      local log = run:listen(named.body)
      run:same("dropThrough", run.world:dropThrough(named.body.raw), true)
      for _ in run:steps(1) do
        run:at(named.body, 186, 76)
        standsOn(run, named.body, named.solid)
      end
      run:same("ends", log.ends, 1)
      run:same("begins", log.begins, 0)
      named.body.vx = 100 -- away from it, and back: it is solid again
      run:play(0.5)
      named.body.vx = -100
      run:play(1)
      standsOn(run, named.body, named.way)
    end)

    scene.it("two one-ways at once, passes both", SOME, function(run)
      local named = run:build({
        way({ width = 60 }),
        way({ name = "second", x = 60, width = 100 }),
        way({ name = "third", y = 150 }),
        body({ y = 76 }),
      })
      run:play(SETTLE)
      run.world:dropThrough(named.body.raw)
      run:play(1)
      standsOn(run, named.body, named.third)
    end)

    --       +-+->
    --   ====|=|=====  tiles
    scene.it("a row of tiles, passes the next one, too", SOME, function(run)
      for vx = -230, 230, 230 do
        for _, x in ipairs({ 80, 83, 95, 96, 111 }) do
          local list = { tile({ x = -200, width = 600 }), body({ x = x, y = 76 }) }
          for i = 0, 9 do
            local plank = { name = "plank" .. i, x = 16 * i, width = 16, y = 100, height = 8 }
            list[#list + 1] = way(plank)
          end
          local named = run:build(list)
          run:play(SETTLE)
          named.body.vx = vx
          run:same("dropThrough", run.world:dropThrough(named.body.raw), true)
          for time in run:steps(0.5) do
            run:at(named.body, x + vx * time, 76 + 400 * time * time)
          end
        end
      end
    end)

    scene.it("a moving one, keeps its velocity", SOME, function(run)
      local named = run:build({
        way({ static = false, kinematic = true }),
        body({ y = 76 }),
      })
      run:play(SETTLE)
      named.way.vx = 60
      run:play(0.5)
      run.world:dropThrough(named.body.raw)
      for time in run:steps(0.5) do
        run:at(named.body, 80 + 60 * time, 76 + 400 * time * time)
        run:near("vx", named.body.vx, 60)
      end
    end)
  end)

  describe("that moves", function()
    local function lift(fields)
      return way(with({ static = false, kinematic = true }, fields))
    end

    for _, vy in ipairs({ -60, 60, 200, -5000, 5000 }) do
      scene.it(("(7) at %g px/s keeps its rider"):format(vy), EVERYWHERE, function(run)
        local named = run:build({ lift(), body({ y = 76 }) })
        run:play(SETTLE)
        local log = run:listen(named.body)
        named.way.vy = vy
        for time in run:steps(1) do
          run:at(named.body, 50, 76 + vy * time)
          standsOn(run, named.body, named.way)
        end
        run:same("events", log.begins + log.ends, 0)
      end)
    end

    scene.it("up from below a body takes it along", SOME, function(run)
      for _, vy in ipairs({ -60, -600, -6000 }) do
        local named = run:build({ lift({ y = 310.3, vy = vy }), tile(), body({ y = 276 }) })
        for time in run:steps(0.5) do
          run:near("y", named.body.y, math.min(276, 286.3 + vy * time))
        end
        standsOn(run, named.body, named.way)
      end
    end)

    scene.it(
      "down on to a head passes it, and does not take it along before it is below",
      SOME,
      function(run)
        local named = run:build({ lift({ y = 219.7, vy = 60 }), tile(), body({ y = 276 }) })
        run:play(SETTLE)
        local log = run:listen(named.body)
        for _ in run:steps(1) do
          run:at(named.body, 50, 276)
        end -- at 289.7, inside the body
        named.way.vy = -60
        for _ in run:steps(0.5) do
          run:at(named.body, 50, 276)
        end
        named.way.vy = 60
        run:play(1) -- at 319.7, below it
        run:at(named.body, 50, 276)
        run:same("events", log.begins + log.ends, 0)
        named.way.vy = -60
        run:play(1) -- at 259.7
        run:at(named.body, 50, 235.7)
        standsOn(run, named.body, named.way)
      end
    )

    scene.it("sideways through a body is no obstacle", SOME, function(run)
      local named = run:build({ lift({ x = -300, y = 280, vx = 300 }), tile(), body({ y = 276 }) })
      for _ in run:steps(1) do
        run:at(named.body, 50, 276)
      end
    end)
  end)

  describe("beside a solid", function()
    --   +-+ ->  +---+
    --   +-+     |   |
    --   ========+---+
    scene.it("(7) still lets walk into it", EVERYWHERE, function(run)
      local solid = tile({ name = "solid", x = 200, y = 84, width = 16, height = 24 })
      local named = run:build({ way(), solid, body({ y = 76 }) })
      for time in run:steps(2, run:keep(named.body, 100)) do
        run:at(named.body, math.min(184, 50 + 100 * time), 76)
      end
      run:same("vx", named.body.vx, 0)
      run:touches(named.body, "bottom", "right")
      run:flush(named.body, named.solid, "right")
    end)

    scene.it(
      "of the same height is walked over without a snag, to and fro",
      EVERYWHERE,
      function(run)
        local named = run:build({
          way({ x = 0, width = 100 }),
          tile({ x = 100, y = 100, width = 50, height = 40 }),
          way({ name = "second", x = 150, width = 100 }),
          body({ x = 20, y = 76 }),
        })
        run:play(SETTLE)
        for _, vx in ipairs({ 100, -100 }) do
          local x = named.body.x
          named.body.vx = vx
          for time in run:steps(2) do
            run:at(named.body, x + vx * time, 76)
            run:same("vx", named.body.vx, vx)
            run:touches(named.body, "bottom")
          end
        end
      end
    )

    --   ====+---+
    --  +-+->|   |
    --   ^   |   |
    scene.it("lets jump through while pressing against it", EVERYWHERE, function(run)
      local solid = tile({ name = "solid", x = 200, y = 0, width = 16, height = 300 })
      local named = run:build({ way(), solid, tile(), body({ x = 184, y = 276 }) })
      run:play(SETTLE)
      named.body.vy = -sqrt(1600 * 220)
      local up = -named.body.vy
      for time in run:steps(1.5, run:keep(named.body, 100)) do
        local y = 276 - up * time + 400 * time * time
        if time > up / 800 then
          y = math.min(76, y)
        end
        run:at(named.body, 184, y)
      end
      standsOn(run, named.body, named.way)
      run:touches(named.body, "bottom", "right")
    end)

    scene.it("in a row of one-ways has no seams", SOME, function(run)
      local description = { body({ x = 0, y = 76, vx = 200 }) }
      for i = 0, 39 do
        description[#description + 1] = way({ name = "way" .. i, x = 16 * i, width = 16 })
      end
      local named = run:build(description)
      for time in run:steps(2) do
        run:at(named.body, 200 * time, 76)
        run:same("vx", named.body.vx, 200)
        run:touches(named.body, "bottom")
      end
    end)
  end)

  describe("with a box on the head", function()
    for _, row in ipairs({ { 1, 0 }, { 100, 0 }, { 1000, 2000 }, { 100, 90000 } }) do
      local mass, vy = row[1], row[2]
      scene.it(
        ("(7) of mass %g that comes at %g px/s still holds"):format(mass, vy),
        EVERYWHERE,
        function(run)
          local named = run:build({
            way(),
            body({ y = 76 }),
            body({ name = "heavy", x = 55, y = -100, vy = vy, mass = mass }),
          })
          local log = run:listen(named.body)
          for _ in run:steps(1) do
            run:at(named.body, 50, 76)
          end
          standsOn(run, named.body, named.way)
          run:at(named.heavy, 55, 52)
          standsOn(run, named.heavy, named.body)
          run:same("begins", log.begins, 2)
          run:same("ends", log.ends, 0)
        end
      )
    end

    scene.it("while rising through it, both go their ways", SOME, function(run)
      local named = run:build({
        way(),
        tile(),
        body({ y = 276, vy = -500 }),
        body({ name = "heavy", x = 50, y = 60, vy = 0, mass = 100 }),
      })
      for _ in run:steps(3) do
        local apart = named.body.y - named.heavy.y
        run:check(apart >= 24 - 1e-6, "overlap by %.9g px", 24 - apart)
        run:near("x", named.body.x, 50)
      end
      run:same("vy", named.body.vy, 0)
      run:same("vy", named.heavy.vy, 0)
    end)
  end)

  --   v = (100, 0) ->  |  solid on the left
  describe("solid on one of four sides", function()
    for _, row in ipairs({
      -- side, velocity that it stops, where the body ends
      { "left", 200, 0, 84, 0 },
      { "right", -200, 0, 108, 0 },
      { "top", 0, 200, 96, -16 },
      { "bottom", 0, -200, 96, 16 },
    }) do
      local side, vx, vy, x, y = row[1], row[2], row[3], row[4], row[5]
      local function thing()
        local object = { name = "way", x = 100, y = 0, width = 8, height = 16, static = true }
        if vy ~= 0 then
          object.x, object.width = 96, 16
        end
        object.oneWay = side
        return object
      end

      for _, factor in ipairs({ 1, 30, 450 }) do
        local speed = 200 * factor
        scene.it(
          ("%s stops what comes from there at %g px/s"):format(side, speed),
          SOME,
          function(run)
            local stop = { x = x, y = y }
            if side == "bottom" then
              stop.y = 16
            end
            local box = { name = "body", width = 16, height = 16 }
            box.x, box.y = stop.x - vx / 2, stop.y - vy / 2
            box.vx, box.vy = vx * factor, vy * factor
            local named = run:build({ gravity = 0, { "ways", thing() }, { "boxes", box } })
            local log = run:listen(named.body)
            run:play(1)
            run:at(named.body, stop.x, stop.y)
            run:still(named.body)
            run:same("begins", log.begins, 1)
            run:same("ends", log.ends, 0)
          end
        )

        scene.it(
          ("%s lets through what comes from elsewhere at %g px/s"):format(side, speed),
          SOME,
          function(run)
            for _, path in ipairs({ { -vx, -vy }, { vy, vx }, { -vy, -vx } }) do
              local box = { name = "body", width = 16, height = 16 }
              local wx, wy = path[1], path[2]
              box.x, box.y = 96 - wx / 2, -wy / 2
              box.vx, box.vy = wx * factor, wy * factor
              local named = run:build({ gravity = 0, { "ways", thing() }, { "boxes", box } })
              local log = run:listen(named.body)
              for time in run:steps(0.5) do
                run:at(named.body, box.x + box.vx * time, box.y + box.vy * time)
              end
              run:same("begins", log.begins, 0)
            end
          end
        )
      end
    end

    scene.it(
      "a ceiling that is open from above lets fall through and holds the head",
      SOME,
      function(run)
        local named = run:build({ way({ oneWay = "bottom" }), tile(), body({ y = 20 }) })
        for time in run:steps(1) do
          run:at(named.body, 50, math.min(276, 20 + 400 * time * time))
        end
        local log = run:listen(named.body)
        named.body.vy = -1000
        for _ in run:steps(1) do
          run:check(named.body.y >= 108 - 1e-6, "its head is at %.9g", named.body.y)
        end
        run:same("begins at the top", log.sides.top, 1)
        run:at(named.body, 50, 276)
      end
    )
  end)

  describe("with canCollide", function()
    scene.it("asks what comes from the solid side, with its own side", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 276 }) })
      run:play(SETTLE)
      local asked, others = {}, 0
      named.body.canCollide = function(_, other, side)
        if other == named.way.raw then
          local name = turn.side(turn.back(run.turn), side)
          asked[name] = (asked[name] or 0) + 1
        else
          others = others + 1
        end
        return true
      end
      named.body.vy = -sqrt(1600 * 240)
      run:play(2)
      standsOn(run, named.body, named.way)
      run:check((asked.bottom or 0) > 0, "should ask for the bottom")
      run:check(not (asked.top or asked.left or asked.right), "should ask for nothing else")
    end)

    for _, which in ipairs({ "body", "way" }) do
      scene.it("of the " .. which .. " that says no lets fall through", SOME, function(run)
        local named = run:build({ way(), tile(), body({ y = 20 }) })
        local log = run:listen(named.body)
        local no = named.way.raw
        if which == "way" then
          no = named.body.raw
        end
        named[which].canCollide = function(_, other)
          return other ~= no
        end
        if which == "way" then
          run.world:refresh(named.way.raw)
        end
        for time in run:steps(1) do
          run:at(named.body, 50, math.min(276, 20 + 400 * time * time))
        end
        run:same("begins", log.begins, 1)
        run:same("ends", log.ends, 0)
      end)
    end

    scene.it("that says no while standing there ends the contact and lets fall", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 76 }) })
      run:play(0.5)
      local log = run:listen(named.body)
      named.body.canCollide = function(_, other)
        return other ~= named.way.raw
      end
      for time in run:steps(1) do
        run:at(named.body, 50, math.min(276, 76 + 400 * time * time))
      end
      run:same("ends", log.ends, 1)
    end)
  end)
end)
