--- Slopes behave like stairs with infinitely small steps: P1 to P12 of the contract.
--
-- The hill of most rows, 1:2 up, 1:1 down:
--
--                 336 ____________
--                  /              \
--        _________/                \_________ 400
--       -400     80  208         308 372

local physics = require("physics")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = { rate = variants.RATES, turn = variants.TURNS }
local RATES = { rate = variants.RATES }

local function static(x, y, width, height, slope)
  local object = { x = x, y = y, width = width, height = height, static = true, slope = slope }
  return { "ground", object }
end

--- The hill, and what else there is.
local function hill(...)
  return {
    static(-400, 400, 480, 40),
    static(80, 336, 128, 64, "right"),
    static(208, 336, 100, 64),
    static(308, 336, 64, 64, "left"),
    static(80, 400, 292, 40),
    static(372, 400, 600, 40),
    ...,
  }
end

local function body(fields)
  local object = { name = "body", width = 16, height = 24 }
  for key, value in pairs(fields) do
    object[key] = value
  end
  return { "players", object }
end

--- Where the bottom of a box of 16 px stands on the hill, with its left edge at x.
local function floorAt(x)
  local right = x + 16
  if right <= 80 or x >= 372 then
    return 400
  elseif right < 208 then
    return 400 - (right - 80) * 0.5
  elseif x <= 308 then
    return 336
  end
  return 336 + (x - 308)
end

local function push(it, vx)
  return function()
    it.vx = vx
  end
end

describe("slopes", function()
  for _, speed in ipairs({ 40, 120, 600, 2400 }) do
    it(("(P1, P2, P3, P4, P5) keep a walker of %d px/s on the ground"):format(speed), function()
      scene.each(EVERYWHERE, function(run)
        for way = 1, -1, -2 do
          local start = way > 0 and 20 or 420
          local it = run:build(hill(body({ x = start, y = 376 }))).body
          local log = run:listen(it)
          local seconds = math.floor(380 / speed * 60) / 60
          seconds = math.max(seconds - seconds % (1 / 6), 1 / 6)
          for time in run:steps(seconds, push(it, way * speed)) do
            local x = start + way * speed * time
            run:near("x", it.x, x)
            run:near("y", it.y, floorAt(it.x) - 24, 1e-9 * (1 + math.abs(it.raw.y)))
            run:same("vx", it.vx, way * speed)
            run:same("vy", it.vy, 0)
            run:touches(it, "bottom")
          end
          run:same("begins elsewhere than below", log.begins, log.sides.bottom)
        end
      end)
    end)
  end

  it("(P5) take as long as they are with constantSpeed", function()
    scene.each(EVERYWHERE, function(run)
      local it = run:build(hill(body({ x = 20, y = 376, constantSpeed = true }))).body
      local up, down = math.sqrt(128 * 128 + 64 * 64), math.sqrt(64 * 64 * 2)
      for time in run:steps(4, push(it, 120)) do
        local way, x = 120 * time -- of the right edge: 44 flat, up, 116 flat, down, flat
        if way <= 44 then
          x = 20 + way
        elseif way <= 44 + up then
          x = 64 + (way - 44) * 128 / up
        elseif way <= 44 + up + 116 then
          x = 192 + way - 44 - up
        elseif way <= 44 + up + 116 + down then
          x = 308 + (way - 160 - up) * 64 / down
        else
          x = 372 + way - 160 - up - down
        end
        run:at(it, x, floorAt(x) - 24)
        run:same("vx", it.vx, 120)
        run:touches(it, "bottom")
      end
    end)
  end)

  it("(P3) let a jump at the crest be as high as on the flat", function()
    scene.each(EVERYWHERE, function(run)
      local it = run:build(hill(body({ x = 100, y = floorAt(100) - 24 }))).body
      run:play(2 / 3, push(it, 120)) -- to x = 180
      it.vy = -300
      for time in run:steps(0.5, push(it, 120)) do
        run:at(it, 180 + 120 * time, floorAt(180) - 24 - 300 * time + 400 * time * time)
      end
    end)
  end)

  it("(P4) catch what lands on them, at the speed of the way towards them", function()
    scene.each(EVERYWHERE, function(run)
      local it = run:build(hill(body({ x = 120, y = 328 - 24, vx = 0 }))).body
      local log = run:listen(it)
      run:play(1)
      run:at(it, 120, floorAt(120) - 24)
      run:still(it)
      run:touches(it, "bottom")
      run:same("begins", log.begins, 1)
      run:near("speed", log.speed, math.sqrt(2 * 800 * (floorAt(120) - 328)))
    end)
  end)

  it("(P4) let a jumper go uphill and downhill", function()
    scene.each(EVERYWHERE, function(run)
      for way = 1, -1, -2 do
        local it = run:build(hill(body({ x = 120, y = floorAt(120) - 24 }))).body
        run:play(0.5)
        it.vy = -300
        for time in run:steps(0.5, push(it, 60 * way)) do
          run:at(it, 120 + 60 * way * time, floorAt(120) - 24 - 300 * time + 400 * time * time)
          run:touches(it)
        end
      end
    end)
  end)

  it("(P6) let friction brake as on a floor, and hold", function()
    scene.each(EVERYWHERE, function(run)
      for way = 1, -1, -2 do
        local fields = { x = 130, y = floorAt(130) - 24, friction = 0.5, vx = way * 100 }
        local it = run:build(hill(body(fields))).body
        run:play(1)
        local x = 130 + way * 100 * 100 / (2 * 400)
        run:at(it, x, floorAt(x) - 24)
        run:still(it)
      end
    end)
  end)

  it("(P6) let slide what gets the pull along them, unless friction holds it", function()
    for _, row in ipairs({ { 0, -320 }, { 0.2, -160 }, { 0.41, 0 } }) do
      for _, rate in ipairs({ 30, 60, 144 }) do
        local world = physics.newWorld({ gravity = 800 })
        local ground = { x = 0, y = 0, width = 800, height = 400, static = true, slope = "right" }
        world:add("ground", ground)
        local box = { x = 600, y = 76, width = 16, height = 16, friction = row[1] }
        world:add("boxes", box)
        function world.onStep()
          local _, gradient = world:ground(box)
          gradient = gradient or 0
          box.ax = gradient * world.gravity / (1 + gradient * gradient)
        end
        for _ = 0, rate do -- in the first step it is not known yet what it stands on
          world:update(1 / rate)
        end
        assert.near(row[2], box.vx, 1e-9)
        assert.near(76 + (600 - box.x) / 2, box.y, 1e-9)
      end
    end
  end)

  it("(P6) bear stacks that stand for ever, without an event", function()
    scene.each(EVERYWHERE, function(run)
      local y = floorAt(120)
      local named = run:build(
        hill(
          body({ x = 120, y = y - 16, height = 16 }),
          { "crates", { name = "second", x = 118, y = y - 32, width = 20, height = 16 } },
          { "crates", { name = "third", x = 125, y = y - 48, width = 8, height = 16 } }
        )
      )
      run:step(1 / 60)
      local log = run:listenToWorld()
      run:play(2)
      run:at(named.body, 120, y - 16)
      run:at(named.second, 118, y - 32)
      run:at(named.third, 125, y - 48)
      run:same("begins and ends", log.begins + log.ends, 0)
      for _, name in ipairs({ "body", "second", "third" }) do
        run:still(named[name])
      end
    end)
  end)

  it("(P6) are escalators with surfaceSpeed", function()
    scene.each(EVERYWHERE, function(run)
      local escalator = static(80, 336, 128, 64, "right")
      escalator[2].surfaceSpeed, escalator[2].friction = 60, 1
      if run.turn >= 2 then
        escalator[2].surfaceSpeed = -60
      end
      local fields = { x = 100, y = floorAt(100) - 24, friction = 1 }
      local it = run:build({ escalator, body(fields) }).body
      run:play(0.5)
      local before = it.x
      run:play(1)
      run:near("x", it.x, before + 60)
      run:near("y", it.y, floorAt(it.x) - 24)
    end)
  end)

  --  a pusher before three crates, on the hill and on a flat floor
  it("(P7) take no work from a row of crates that is pushed", function()
    local PUSH = { rate = variants.RATES, turn = variants.TURNS, push = { "both" } }
    scene.each(PUSH, function(run)
      for way = 1, -1, -2 do
        local start = way > 0 and 60 or 330
        local function row(list, isFlat)
          for n = 0, 3 do
            local x = start + way * n * 17
            local height = isFlat and 400 or floorAt(x)
            local crate = { x = x, y = height - 24, width = 16, height = 24, name = "crate" .. n }
            crate.mass = n == 0 and 3 or 1
            list[#list + 1] = { "crates", crate }
          end
          local named = run:build(list)
          local places = {}
          run:play(1, push(named.crate0, way * 90))
          for n = 0, 3 do
            places[n] = named["crate" .. n].x
            local y = isFlat and 400 or floorAt(places[n])
            run:near("y", named["crate" .. n].y, y - 24)
          end
          return places
        end
        local flat, up = row({ static(-800, 400, 2000, 40) }, true), row(hill(), false)
        for n = 0, 3 do
          run:near("x", up[n], flat[n])
        end
      end
    end)
  end)

  it("(P7) let a walker carry its rider", function()
    scene.each(EVERYWHERE, function(run)
      for way = 1, -1, -2 do
        local start = way > 0 and 40 or 400
        local named = run:build(
          hill(
            body({ x = start, y = 376 }),
            { "crates", { name = "rider", x = start + 2, y = 364, width = 12, height = 12 } }
          )
        )
        local function both()
          named.body.vx, named.rider.vx = way * 150, way * 150
        end
        for _ in run:steps(2, both) do
          run:near("y", named.body.y, floorAt(named.body.x) - 24)
          run:near("y of the rider", named.rider.y, named.body.y - 12)
          run:touches(named.rider, "bottom")
        end
      end
    end)
  end)

  --             +------+ 312
  --             +------+ 320
  --      [ ]->      /
  --   ___________/
  it("(P8) are walls where they press against a ceiling", function()
    scene.each({ rate = variants.RATES, turn = variants.TURNS, push = { "both" } }, function(run)
      for _, crates in ipairs({ 0, 1, 2 }) do
        local list = hill(static(100, 300, 100, 20), body({ x = 0, y = 376 }))
        for n = 1, crates do
          local crate = { x = 16 * n, y = 376, width = 16, height = 24, name = "crate" .. n }
          list[#list + 1] = { "crates", crate }
        end
        local named = run:build(list)
        local first = crates == 0 and named.body or named["crate" .. crates]
        local log = run:listen(first)
        run:play(3, push(named.body, 120))
        -- 320 is the ceiling, 344 where the bottom is, 192 where the right edge is then
        run:at(first, 176, 320, 3e-6) -- flush is flush to 1e-6 px in height, 2e-6 along x
        run:same("vx", first.vx, 0)
        run:check(first.touching.right ~= false, "it should touch the slope on its right")
        run:at(named.body, 176 - 16 * crates, floorAt(176 - 16 * crates) - 24, 3e-6)
        run:same("crushes", log.crushes, 0)
      end
    end)
  end)

  describe("that are one-way", function()
    local function oneWay(...)
      local slope = static(80, 336, 128, 64, "right")
      slope[2].oneWay = "top"
      return { static(-400, 400, 1200, 40), slope, ... }
    end

    it("(P9) bear what comes from above or from the foot", function()
      scene.each(EVERYWHERE, function(run)
        local it = run:build(oneWay(body({ x = 20, y = 376 }))).body
        for _ in run:steps(1.5, push(it, 100)) do
          run:near("y", it.y, floorAt(it.x) - 24)
        end
        it = run:build(oneWay(body({ x = 120, y = 250 }))).body
        run:play(1)
        run:at(it, 120, floorAt(120) - 24)
      end)
    end)

    it("(P9) let pass what comes from below or behind", function()
      scene.each(EVERYWHERE, function(run)
        local it = run:build(oneWay(body({ x = 250, y = 376 }))).body
        for time in run:steps(2, push(it, -100)) do
          run:at(it, 250 - 100 * time, 376)
        end
        it = run:build(oneWay(body({ x = 140, y = 376 }))).body
        run:play(0.5)
        it.vy = -400
        for time in run:steps(0.5) do
          run:near("y", it.y, 376 - 400 * time + 400 * time * time)
        end
        run:play(1)
        run:at(it, 140, floorAt(140) - 24)
      end)
    end)

    it("(P9) let fall with dropThrough", function()
      scene.each(EVERYWHERE, function(run)
        local it = run:build(oneWay(body({ x = 140, y = floorAt(140) - 24 }))).body
        run:play(0.5)
        run:touches(it, "bottom")
        run:check(run.world:dropThrough(it.raw), "it should stand on a one-way")
        run:play(1)
        run:at(it, 140, 376)
      end)
    end)

    --     +-+
    --  \._+-+_./   a bridge
    it("(P9) are a bridge through which dropThrough leads, also one that runs", function()
      scene.each(EVERYWHERE, function(run)
        for vx = -200, 200, 200 do
          for _, x in ipairs({ 104, 107, 121, 135 }) do
            local list = { static(-400, 500, 1200, 40), body({ x = x, y = 176, snap = 8 }) }
            for i = 0, 19 do
              local plank = static(20 * i, 200 + 4 * math.min(i, 19 - i), 20, 4)
              plank[2].slope, plank[2].oneWay = i < 10 and "left" or "right", "top"
              list[#list + 1] = plank
            end
            local it = run:build(list).body
            run:play(0.5)
            run:touches(it, "bottom")
            it.vx = vx
            run:check(run.world:dropThrough(it.raw), "it should stand on the bridge")
            run:play(0.5, push(it, vx))
            run:check(it.y > 276, "it is caught at %.9g", it.y)
          end
        end
      end)
    end)
  end)

  describe("that move", function()
    local function moving(fields, ...)
      local object = { name = "slope", x = 80, y = 336, width = 128, height = 64 }
      object.slope, object.kinematic = "right", true
      for key, value in pairs(fields) do
        object[key] = value
      end
      return { { "ground", object }, ... }
    end

    it("(P10) carry what stands and what walks", function()
      scene.each(EVERYWHERE, function(run)
        for _, walk in ipairs({ 0, 40, -40 }) do
          local fields = { x = 130, y = floorAt(130) - 24 }
          local named = run:build(moving({}, body(fields)))
          local it = named.body
          run:play(0.5)
          named.slope.vx, named.slope.vy = 50, -30
          for time in run:steps(0.5, push(it, walk)) do
            local x = 130 + walk * time
            run:at(it, x + 50 * time, floorAt(x) - 24 - 30 * time)
            run:same("vy", it.vy, 0)
            run:touches(it, "bottom")
          end
        end
      end)
    end)

    --      ______    ______
    --    _/      \__/      \   a train, all of it runs
    it("(P1, P10) have no wall at their seams for what walks there", function()
      local PARTS = {
        { x = 0, y = 300, width = 64, height = 32, slope = "right" },
        { x = 64, y = 300, width = 80, height = 32 },
        { x = 144, y = 300, width = 64, height = 32, slope = "left" },
        { x = 208, y = 316, width = 32, height = 16, slope = "right" },
        { x = 240, y = 300, width = 32, height = 32, slope = "right" },
        { x = 272, y = 300, width = 300, height = 32 },
        { x = -200, y = 332, width = 200, height = 20 },
      }
      scene.each({ rate = variants.RATES, order = variants.ORDERS }, function(run)
        for _, way in ipairs({ { 60, 0 }, { -60, 0 }, { 0, 60 }, { 0, -60 }, { 30, -40 } }) do
          local list = { body({ x = -100, y = 308 }) }
          for n, part in ipairs(PARTS) do
            list[n + 1] = { "train", { kinematic = true, vx = way[1], vy = way[2] } }
            for key, value in pairs(part) do
              list[n + 1][2][key] = value
            end
          end
          local it = run:build(list).body
          run:step(1 / 60) -- it lands
          for _ in run:steps(2, push(it, 200)) do
            run:same("vx", it.vx, 200)
            run:touches(it, "bottom")
          end
        end
      end)
    end)

    it("(P10) keep two of a soft group down that part on them", function()
      scene.each(RATES, function(run)
        local soft = { players = { players = 300 } }
        for vy = 0, -80, -20 do
          local list =
            moving({ x = 0, y = 300, width = 400, height = 100, vy = vy, slope = "left" })
          list.soft = soft
          list[2], list[3] = body({ x = 40, y = 286 }), body({ x = 64, y = 292 })
          list[3][2].name = "other"
          local named = run:build(list)
          local function both()
            named.body.vx, named.other.vx = 120, 60
          end
          for _ in run:steps(1.5, both) do
            for _, it in ipairs({ named.body, named.other }) do
              run:near("y", it.y, named.slope.y + it.x / 4 - 24)
              run:same("vy", it.vy, 0)
            end
          end
        end
      end)
    end)

    it("(P10) lift what is in their way, if they do not carry", function()
      scene.each(EVERYWHERE, function(run)
        local list = moving({ vx = -60, carry = false }, body({ x = 40, y = 376 }))
        list[#list + 1] = static(-400, 400, 1200, 40)
        local it = run:build(list).body
        for time in run:steps(2) do
          local foot = 80 - 60 * time
          run:at(it, 40, math.min(400, 400 - (56 - foot) * 0.5) - 24)
        end
      end)
    end)

    it("(P10) crush what has no room", function()
      scene.each(EVERYWHERE, function(run)
        local fields = { x = 130, y = floorAt(130) - 24 }
        local list = moving({ vy = -30 }, body(fields))
        list[#list + 1] = static(100, floorAt(130) - 64, 100, 20)
        local it = run:build(list).body
        local log = run:listen(it)
        run:play(1)
        run:same("crushes", log.crushes, 1)
      end)
    end)

    --  ______________________ 372
    --  wall |[ ]      ..../|
    --       |    ..../  <- |
    --  ______________________ 400
    it("(P10) push nothing into a wall below a ceiling", function()
      scene.each(EVERYWHERE, function(run)
        for _, gap in ipairs({ 0, 5, 5.3 }) do
          for restitution = 0, 1 do
            local list = moving({ y = 376, height = 24, vx = -100 }, static(-400, 400, 900, 40))
            list[#list + 1] = static(-400, 332, 900, 40)
            list[#list + 1] = static(0, 372, 20, 28)
            local fields = { x = 20 + gap, y = 376, restitution = restitution }
            list[#list + 1] = body(fields)
            local it = run:build(list).body
            local log = run:listen(it)
            for _ in run:steps(2) do
              run:check(it.x > 20 - 1e-6, "it is %g px in the wall", 20 - it.x)
            end
            run:check(log.crushes > 0, "it should be crushed")
          end
        end
      end)
    end)
  end)

  --  a ball that falls on 45 degrees
  it("(P11) bounce along their normal", function()
    scene.each({ rate = variants.RATES, turn = variants.TURNS }, function(run)
      local slope = static(0, 0, 100, 100, "right")
      slope[2].restitution = 1
      local it = run:build({ slope, body({ x = 34, y = -40, width = 16, height = 16 }) }).body
      local log = run:listen(it)
      run:play(0.5) -- the corner is at (50, 50) when it has fallen by 74 px
      local u = math.sqrt(2 * 800 * 74)
      run:same("begins and bounces", log.begins, 1)
      run:near("speed", log.speed, u)
      run:near("vx", it.vx, -u, 1e-6)
      run:near("vy", it.vy, 800 * (0.5 - u / 800), 1e-6)
    end)
  end)

  it("(P11) bounce on their crest what has run off it by the end of the step", function()
    scene.each(RATES, function(run)
      local ball = body({ x = 236, y = -24 - 151.5, restitution = 1 })
      local it = run:build({ static(0, 0, 100, 100, "right"), ball, gravity = 0 }).body
      it.vx, it.vy = -600, 600
      run:play(0.5) -- at the hit, after 0.2525 s, its corner is at 100.5
      run:near("x", it.x, 236 - 300)
      run:near("y", it.y, -24 - 148.5)
      run:near("vy", it.vy, -600)
    end)
  end)

  it("(P12) are diagonal walls without gravity", function()
    scene.each(RATES, function(run)
      for _, name in ipairs({ "left", "right", "topleft", "topright" }) do
        local way = (name == "right" or name == "topright") and 1 or -1
        local up = name:sub(1, 3) == "top" and 1 or -1
        local list = { static(0, 0, 100, 50, name), gravity = 0 }
        list[2] = body({ x = 42 - 100 * way, y = 20, width = 16, height = 10 })
        local it = run:build(list).body
        it.vx = 100 * way
        run:play(2)
        -- 100 px/s along x, less what goes into 1:2
        run:near("vx", it.vx, 80 * way)
        run:near("vy", it.vy, 40 * up)
        -- it has met the edge after 0.82 s, at 82 px, and has left it at the crest
        run:near("x", it.x, way > 0 and 118.4 or 84 - 118.4)
        run:near("y", it.y, up < 0 and -27.2 or 40 + 27.2)
      end
    end)
  end)

  --   _________
  --   \        |   topright
  --  ->  \     |
  --  -------\--+---
  it("(P8) that hang from above stop what walks below", function()
    scene.each(EVERYWHERE, function(run)
      local list = { static(-400, 400, 1200, 40), static(0, 340, 100, 50, "topright") }
      list[3] = body({ x = -60, y = 376 })
      local it = run:build(list).body
      local log = run:listen(it)
      run:play(2, push(it, 100))
      run:at(it, 56, 376) -- the edge is at 376 where x is 72
      run:same("vx", it.vx, 0)
      run:same("crushes", log.crushes, 0)
      run:play(0.5, push(it, -100))
      run:at(it, 6, 376)
    end)
  end)

  it("(P8) that hang from above leave what stands up below them where it is, crushed", function()
    scene.each(RATES, function(run)
      local list = { static(-200, 400, 600, 20), static(0, 326, 200, 100, "topleft") }
      list[3] = body({ x = 100, y = 384, width = 20, height = 16 })
      local it = run:build(list).body
      local log = run:listen(it)
      run:play(0.5)
      it.y, it.height = 368, 32
      run:play(1)
      run:at(it, 100, 368)
      run:same("crushes", log.crushes, 1)
    end)
  end)

  it("that hang from above send a jumper down again", function()
    scene.each(EVERYWHERE, function(run)
      local list = { static(-400, 400, 1200, 40), static(0, 300, 100, 50, "topleft") }
      list[3] = body({ x = 50, y = 376 })
      local it = run:build(list).body
      run:play(0.5)
      it.vy = -400
      for _ in run:steps(1) do
        run:near("x", it.x, 50)
        run:check(it.y >= 325 - 1e-6, "it should stay below the edge, is at %.9g", it.y)
      end
      run:at(it, 50, 376)
    end)
  end)

  it("tell the ground and its gradient", function()
    scene.each({ rate = { 60 }, turn = { 0, 2 } }, function(run)
      local named = run:build(hill(body({ x = 20, y = 376 })))
      local it = named.body
      run:play(0.5)
      local ground, gradient = run.world:ground(it.raw)
      run:check(ground and not ground.slope, "it should stand on the flat")
      run:same("gradient", gradient, 0)
      run:play(1, push(it, 100)) -- to x = 120
      ground, gradient = run.world:ground(it.raw)
      run:check(ground and ground.slope, "it should stand on the slope")
      run:near("gradient", gradient, -0.5)
      it.vy = -300
      run:play(0.5)
      run:same("ground", run.world:ground(it.raw), nil)
    end)
  end)

  it("have a wall and a ceiling at their legs", function()
    scene.each(EVERYWHERE, function(run)
      run:build({ static(-400, 400, 1200, 40), static(80, 336, 128, 64, "right") })
      local it = run:add("players", body({ x = 250, y = 376 })[2])
      run:play(1, push(it, -100))
      run:at(it, 208, 376)
      run:touches(it, "left", "bottom")
      run:build({ static(80, 300, 128, 64, "right"), static(-400, 400, 1200, 40) })
      it = run:add("players", body({ x = 120, y = 376 })[2])
      run:play(0.5)
      it.vy = -300
      for _ in run:steps(0.5) do
        run:check(it.y >= 364 - 1e-6, "it should stay below the slope, is at %.9g", it.y)
      end
    end)
  end)

  it("(P4) are walls for what is too low for the foot", function()
    scene.each(RATES, function(run)
      run:build({ static(-400, 404, 480, 40), static(80, 336, 128, 64, "right") })
      local it = run:add("players", body({ x = 20, y = 380 })[2])
      run:play(1, push(it, 100))
      run:at(it, 64, 380)
      run:touches(it, "right", "bottom")
    end)
  end)
end)
