--- One-way objects: solid on one side, open on the others.

local scene = require("spec.support.scene")
local turn = require("spec.support.turn")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local SETTLE = 1 / 6
local sqrt = math.sqrt

local way = scene.thing(
  "ways",
  { name = "way", x = 0, y = 100, width = 200, height = 8, static = true, oneWay = "top" }
)
local lift = scene.thing(
  "ways",
  { name = "way", x = 0, y = 100, width = 200, height = 8, kinematic = true, oneWay = "top" }
)
local tile =
  scene.thing("tiles", { name = "floor", x = 0, y = 300, width = 200, height = 8, static = true })
local body = scene.thing("players", { name = "body", x = 50, y = 200, width = 16, height = 24 })

local function settled(run, description)
  local named = run:build(description)
  run:play(SETTLE)
  return named, run:listen(named.body)
end

local function had(run, log, begins, ends)
  run:same("begins", log.begins, begins)
  run:same("ends", log.ends, ends)
end

local function drop(run, view, expected)
  run:same("dropThrough", run.world:dropThrough(view.raw), expected)
end

--    .  feet reach 60
--   ===============  100
--    |
--   +-+
--   +-+
--   ---------------  300
describe("oneWay: jumped through from below", function()
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
      local title = "(7) from %s, feet up to %g, ends at feet %g"
      scene.it(title:format(name, peak, ends), EVERYWHERE, function(run)
        local named = run:build({ way(), tile(), body({ y = feet - 24 }) })
        if feet == 300 then
          run:play(SETTLE)
        end
        local log = run:listen(named.body)
        local up = sqrt(1600 * (feet - peak))
        named.body.vy = -up
        local hits = up / 800 + sqrt((ends - peak) / 400)
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
        run:standsOn(named.body, ends == 100 and named.way or named.floor)
        had(run, log, 1, feet == 300 and 1 or 0)
      end)
    end
  end
end)

describe("oneWay: fallen on", function()
  for _, speed in ipairs({ 0, 100, 6000, 90000 }) do
    for _, height in ipairs({ 8, 1 }) do
      local title = ("(7) at %g px/s, %g px thick, catches"):format(speed, height)
      scene.it(title, EVERYWHERE, function(run)
        local named = run:build({ way({ height = height }), body({ y = 0, vx = 10, vy = speed }) })
        local log = run:listen(named.body)
        for time in run:steps(0.5) do
          run:at(named.body, 50 + 10 * time, math.min(76, speed * time + 400 * time * time))
        end
        run:standsOn(named.body, named.way)
        run:same("begins", log.begins, 1)
        run:same("begins at the bottom", log.sides.bottom, 1)
      end)
    end
  end

  scene.it("at an angle catches, too, and at its corner, not beside it", SOME, function(run)
    -- the feet come down to 100 after half a second, when 1 px of them is above it
    local named = run:build({ way(), body({ x = -65, y = -24, vx = 101 }) })
    run:play(2 / 3)
    run:standsOn(named.body, named.way)
    named = run:build({ way(), body({ x = -67, y = -24, vx = 100 }) })
    for time in run:steps(2 / 3) do
      run:at(named.body, -67 + 100 * time, -24 + 400 * time * time)
    end
  end)
end)

--  +-+ ->
--  +=+=============   feet at 104
describe("oneWay: walked through", function()
  local LOW = tile({ x = -300, y = 104, width = 800 })

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
    local named = settled(run, { way(), LOW, body({ x = -40, y = 80 }) })
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

  scene.it("what begins inside it falls out of it", SOME, function(run)
    local named = run:build({ way(), tile(), body({ y = 79 }) })
    for time in run:steps(0.5) do
      run:at(named.body, 50, 79 + 400 * time * time)
    end
  end)
end)

describe("dropThrough", function()
  local TOP = body({ name = "top", y = 52 })

  scene.it("(7) at rest lets fall, once, and only the one that asked", EVERYWHERE, function(run)
    local second = body({ name = "other", x = 80, y = 76 })
    local named, log = settled(run, { way(), tile(), body({ y = 76 }), second })
    local other = run:listen(named.other)
    drop(run, named.body, true)
    for time in run:steps(1) do
      run:at(named.body, 50, math.min(276, 76 + 400 * time * time))
      run:at(named.other, 80, 76)
      run:still(named.other)
    end
    run:standsOn(named.body, named.floor)
    had(run, log, 1, 1)
    had(run, other, 0, 0)
    drop(run, named.body, false)
    named.body.vy = -sqrt(1600 * 240) -- it is solid again after a jump
    run:play(2)
    run:standsOn(named.body, named.way)
  end)

  scene.it("in the air and on a solid does nothing", SOME, function(run)
    local named = run:build({ way(), tile(), body() })
    run:step(1 / 60)
    drop(run, named.body, false)
    run:play(1)
    drop(run, named.body, false)
    run:play(0.5)
    run:standsOn(named.body, named.floor)
  end)

  scene.it("with a box on the head lets that one land; by it does nothing", SOME, function(run)
    local named = settled(run, { way(), tile(), body({ y = 76 }), TOP })
    drop(run, named.top, false)
    run:play(0.5)
    run:at(named.body, 50, 76)
    run:at(named.top, 50, 52)
    drop(run, named.body, true)
    run:play(1)
    run:standsOn(named.body, named.floor)
    run:standsOn(named.top, named.way)
    run:at(named.top, 50, 76)
  end)

  --   +-+|
  --   | || door
  --   +-+|
  --  =======
  scene.it("on a solid, at a door that opens to the other side, does nothing", SOME, function(run)
    local door = way({ name = "door", x = 74, y = 176, width = 8, height = 124, oneWay = "left" })
    local named = run:build({ tile(), door, body({ y = 276, vx = 60 }) })
    run:play(0.2)
    run:same("touching the door", named.body.touching.right, named.door)
    drop(run, named.body, false)
    named.body.vx = 60
    run:play(0.5)
    run:at(named.body, 58, 276)
  end)

  --        +-+
  --   ===========+----+
  --              |    |  solid
  scene.it("while standing also on a solid, stays on that", EVERYWHERE, function(run)
    local solid = tile({ name = "solid", x = 200, y = 100, width = 100, height = 50 })
    local named, log = settled(run, { way(), solid, body({ x = 186, y = 76 }) })
    run:same("touching.bottom", run:support(named.body), named.way)
    drop(run, named.body, true)
    for _ in run:steps(1) do
      run:at(named.body, 186, 76)
      run:standsOn(named.body, named.solid)
    end
    had(run, log, 0, 1)
    named.body.vx = 100 -- away from it, and back: it is solid again
    run:play(0.5)
    named.body.vx = -100
    run:play(1)
    run:standsOn(named.body, named.way)
  end)

  --       +-+->
  --   ====|=|=====  tiles
  scene.it("a row of tiles, passes the next one, too", SOME, function(run)
    for vx = -230, 230, 230 do
      for _, x in ipairs({ 80, 83, 95, 96, 111 }) do
        local list = { tile({ x = -200, width = 600 }), body({ x = x, y = 76 }) }
        for i = 0, 9 do
          list[#list + 1] = way({ name = "plank" .. i, x = 16 * i, width = 16 })
        end
        local named = settled(run, list)
        named.body.vx = vx
        drop(run, named.body, true)
        for time in run:steps(0.5) do
          run:at(named.body, x + vx * time, 76 + 400 * time * time)
        end
      end
    end
  end)

  scene.it("a moving one, keeps its velocity", SOME, function(run)
    local named = settled(run, { lift(), body({ y = 76 }) })
    named.way.vx = 60
    run:play(0.5)
    run.world:dropThrough(named.body.raw)
    for time in run:steps(0.5) do
      run:at(named.body, 80 + 60 * time, 76 + 400 * time * time)
      run:near("vx", named.body.vx, 60)
    end
  end)
end)

describe("oneWay: that moves", function()
  for _, vy in ipairs({ -60, 60, 200, -5000, 5000 }) do
    scene.it(("(7) at %g px/s keeps its rider"):format(vy), EVERYWHERE, function(run)
      local named, log = settled(run, { lift(), body({ y = 76 }) })
      named.way.vy = vy
      for time in run:steps(1) do
        run:at(named.body, 50, 76 + vy * time)
        run:standsOn(named.body, named.way)
      end
      had(run, log, 0, 0)
    end)
  end

  scene.it("up from below a body takes it along", SOME, function(run)
    for _, vy in ipairs({ -60, -600, -6000 }) do
      local named = run:build({ lift({ y = 310.3, vy = vy }), tile(), body({ y = 276 }) })
      for time in run:steps(0.5) do
        run:near("y", named.body.y, math.min(276, 286.3 + vy * time))
      end
      run:standsOn(named.body, named.way)
    end
  end)

  scene.it("down on to a head passes it, and takes it along from below only", SOME, function(run)
    local named, log = settled(run, { lift({ y = 219.7, vy = 60 }), tile(), body({ y = 276 }) })
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
    had(run, log, 0, 0)
    named.way.vy = -60
    run:play(1) -- at 259.7
    run:at(named.body, 50, 235.7)
    run:standsOn(named.body, named.way)
  end)
end)

describe("oneWay: beside a solid", function()
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

  scene.it("of the same height is walked over without a snag, both ways", EVERYWHERE, function(run)
    local named = settled(run, {
      way({ x = 0, width = 100 }),
      tile({ x = 100, y = 100, width = 50, height = 40 }),
      way({ name = "second", x = 150, width = 100 }),
      body({ x = 20, y = 76 }),
    })
    for _, vx in ipairs({ 100, -100 }) do
      local x = named.body.x
      named.body.vx = vx
      for time in run:steps(2) do
        run:at(named.body, x + vx * time, 76)
        run:same("vx", named.body.vx, vx)
        run:touches(named.body, "bottom")
      end
    end
  end)

  --   ====+---+
  --  +-+->|   |
  --   ^   |   |
  scene.it("lets jump through while pressing against it", EVERYWHERE, function(run)
    local solid = tile({ name = "solid", x = 200, y = 0, width = 16, height = 300 })
    local named = settled(run, { way(), solid, tile(), body({ x = 184, y = 276 }) })
    local up = sqrt(1600 * 220)
    named.body.vy = -up
    for time in run:steps(1.5, run:keep(named.body, 100)) do
      local y = 276 - up * time + 400 * time * time
      run:at(named.body, 184, time > up / 800 and math.min(76, y) or y)
    end
    run:standsOn(named.body, named.way)
    run:touches(named.body, "bottom", "right")
  end)

  scene.it("or another one-way in a row has no seams", SOME, function(run)
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

describe("oneWay: with a box on the head", function()
  for _, row in ipairs({ { 1, 0 }, { 100, 0 }, { 1000, 2000 }, { 100, 90000 } }) do
    local mass, vy = row[1], row[2]
    local title = ("(7) of mass %g that comes at %g px/s still holds"):format(mass, vy)
    scene.it(title, EVERYWHERE, function(run)
      local heavy = body({ name = "heavy", x = 55, y = -100, vy = vy, mass = mass })
      local named = run:build({ way(), body({ y = 76 }), heavy })
      local log = run:listen(named.body)
      for _ in run:steps(1) do
        run:at(named.body, 50, 76)
      end
      run:standsOn(named.body, named.way)
      run:at(named.heavy, 55, 52)
      run:standsOn(named.heavy, named.body)
      had(run, log, 2, 0)
    end)
  end
end)

--   v = (100, 0) ->  |  solid on the left
describe("oneWay: each of its four sides", function()
  for _, row in ipairs({
    -- side, velocity that it stops, where the body ends
    { "left", 200, 0, 84, 0 },
    { "right", -200, 0, 108, 0 },
    { "top", 0, 200, 96, -16 },
    { "bottom", 0, -200, 96, 16 },
  }) do
    local side, vx, vy, x, y = row[1], row[2], row[3], row[4], row[5]
    local thing =
      way({ x = vy == 0 and 100 or 96, y = 0, width = vy == 0 and 8 or 16, height = 16 })
    thing[2].oneWay = side

    -- A box that would have its middle at the place after half a second, and its world.
    local function build(run, atX, atY, wayX, wayY, factor)
      local box = body({ x = atX - wayX / 2, y = atY - wayY / 2, width = 16, height = 16 })
      box[2].vx, box[2].vy = wayX * factor, wayY * factor
      local named = run:build({ gravity = 0, thing, box })
      return named.body, run:listen(named.body), box[2]
    end

    for _, factor in ipairs({ 1, 30, 450 }) do
      local title = "%s stops what comes from there at %g px/s, and lets all else through"
      scene.it(title:format(side, 200 * factor), SOME, function(run)
        local view, log = build(run, x, y, vx, vy, factor)
        run:play(1)
        run:at(view, x, y)
        run:still(view)
        had(run, log, 1, 0)
        for _, path in ipairs({ { -vx, -vy }, { vy, vx }, { -vy, -vx } }) do
          local other, its, box = build(run, 96, 0, path[1], path[2], factor)
          for time in run:steps(0.5) do
            run:at(other, box.x + box.vx * time, box.y + box.vy * time)
          end
          run:same("begins", its.begins, 0)
        end
      end)
    end
  end

  scene.it("bottom: a ceiling that is open from above holds the head", SOME, function(run)
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
  end)
end)

describe("canCollide: of a one-way", function()
  scene.it("is asked for what comes from the solid side, with its own side", SOME, function(run)
    local named = settled(run, { way(), tile(), body({ y = 276 }) })
    local asked = {}
    named.body.canCollide = function(_, other, side)
      if other == named.way.raw then
        asked[turn.side(turn.back(run.turn), side)] = true
      end
      return true
    end
    named.body.vy = -sqrt(1600 * 240)
    run:play(2)
    run:standsOn(named.body, named.way)
    run:check(asked.bottom, "should ask for the bottom")
    run:check(not (asked.top or asked.left or asked.right), "should ask for nothing else")
  end)

  for _, which in ipairs({ "body", "way" }) do
    scene.it("that says no, of the " .. which .. ", lets fall through", SOME, function(run)
      local named = run:build({ way(), tile(), body({ y = 20 }) })
      local log = run:listen(named.body)
      local no = which == "way" and named.body.raw or named.way.raw
      named[which].canCollide = function(_, other)
        return other ~= no
      end
      if which == "way" then
        run.world:refresh(named.way.raw)
      end
      for time in run:steps(1) do
        run:at(named.body, 50, math.min(276, 20 + 400 * time * time))
      end
      had(run, log, 1, 0)
    end)
  end
end)

describe("oneWay", function()
  scene.it("true is the top, false is none", SOME, function(run)
    for word, feet in pairs({ [true] = 100, [false] = 300 }) do
      local entry = way()
      entry[2].oneWay = run.turn == 0 and word or word and "top" or nil
      local named = run:build({ entry, tile(), body({ y = word and 276 or 120 }) })
      named.body.vy = word and -sqrt(1600 * 220) or 0
      run:play(2)
      run:near("feet", named.body.y + 24, feet)
    end
  end)

  -- It flies up through the one-way, bounces off the ceiling, and comes down onto the one-way in
  -- the same step.
  scene.it("stops what it has let through earlier in the step", { rate = { 60 } }, function(run)
    local named = run:build({
      gravity = 0,
      body({ x = 40, y = 2, width = 10, height = 10, vy = -2000, restitution = 1 }),
      way({ y = 0, height = 2 }),
      tile({ y = -40, height = 20 }),
    })
    run:step(1 / 60)
    run:near("y", named.body.y, -34 / 3)
    run:near("vy", named.body.vy, -2000)
  end)
end)
