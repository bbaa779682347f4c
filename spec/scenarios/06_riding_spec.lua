--- Riding: platforms, lifts and belts take along what stands on them.

local scene = require("spec.support.scene")
local turn = require("spec.support.turn")
local variants = require("spec.support.variants")

local EVERYWHERE = { rate = variants.RATES, turn = variants.TURNS }
-- For the many rows that are relatives of another one: 12 variants.
local SOME = { shift = { 0, 1 / 3, 100000.3 }, rate = { 60, 30, "irregular" } }
SOME.order, SOME.turn = { "forward", "shuffled" }, variants.TURNS
local SETTLE = 1 / 6 -- s, ten steps at 60 Hz
local abs, pi, sin, cos = math.abs, math.pi, math.sin, math.cos

local function with(object, fields)
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return object
end

local function platform(fields)
  local object = { name = "platform", x = 100, y = 400, width = 64, height = 8, kinematic = true }
  return { "platforms", with(object, fields) }
end

local function rider(fields)
  local object = { name = "rider", x = 120, y = 376, width = 16, height = 24 }
  return { "players", with(object, fields) }
end

local function tile(name, x, y, width, height)
  return { "tiles", { name = name, x = x, y = y, width = width, height = height, static = true } }
end

--- Row 6's scene, at rest.
local function settled(run, description)
  local named = run:build(description or { platform(), rider() })
  local log = named.rider and run:listen(named.rider)
  run:play(SETTLE)
  return named, log
end

--- Updates the world for some seconds; before each step `write(time)` gets the time at its end.
local function driven(run, seconds, write)
  local list, i, time = scene.times(seconds, run.rate), 0, 0
  return function()
    i = i + 1
    if not list[i] then
      return nil
    end
    time = time + list[i]
    write(time, list[i])
    run:step(list[i])
    return time
  end
end

--- What an object stands on, or nil.
local function support(run, view)
  return run.views[view.raw.touching[turn.side(run.turn, "bottom")]]
end

--- Fails unless `upper` stands on `lower` without a gap, `offset` px right of its left edge, and is
--- at rest as it sees it.
local function rides(run, upper, lower, offset)
  run:near("offset", upper.x - lower.x, offset)
  run:flush(upper, lower, "bottom")
  run:same("touching.bottom", support(run, upper), lower)
  run:still(upper)
end

--- Fails unless there was one contact, which lives.
local function neverFlickered(run, log)
  run:same("begins", log.begins, 1)
  run:same("ends", log.ends, 0)
end

describe("riding", function()
  --     +-+
  --     | |
  --   +-----+  ->
  describe("a platform that moves evenly", function()
    for i, row in ipairs({
      -- velocity of the platform
      { 60, 0 },
      { 0, -60 },
      { 0, 60 },
      { 0, 200 },
      { 5000, -5000 },
      { -60, 0 },
      { 45, -80 },
      { -130, 170 },
      { 5000, 0 },
      { -5000, 0 },
      { 0, 5000 },
      { 0, -5000 },
    }) do
      local vx, vy = row[1], row[2]
      it(("(6) takes its rider along at (%g, %g) px/s"):format(vx, vy), function()
        scene.each(i <= 5 and EVERYWHERE or SOME, function(run)
          local named, log = settled(run)
          named.platform.vx, named.platform.vy = vx, vy
          for time in run:steps(i <= 4 and 2 or 1) do
            run:at(named.platform, 100 + vx * time, 400 + vy * time)
            run:at(named.rider, 120 + vx * time, 376 + vy * time)
            rides(run, named.rider, named.platform, 20)
          end
          neverFlickered(run, log)
        end)
      end)
    end

    it("(6) 120 steps end at the numbers of the page", function()
      for _, row in ipairs({
        -- vx, vy, coordinate, platform, rider
        { 60, 0, "x", 220, 240 },
        { 0, -60, "y", 280, 256 },
        { 0, 60, "y", 520, 496 },
        { 0, 200, "y", 800, 776 },
      }) do
        scene.each(nil, function(run)
          local named = settled(run)
          named.platform.vx, named.platform.vy = row[1], row[2]
          run:play(2)
          run:near("platform", named.platform[row[3]], row[4])
          run:near("rider", named.rider[row[3]], row[5])
        end)
      end
    end)
  end)

  describe("a platform that changes its velocity", function()
    -- how; the platform's velocity at t s, taken in the middle of each step; for how many seconds
    local ways = {
      {
        "sways",
        function(t)
          return 50 * pi * cos(pi * t), 0
        end,
        seconds = 2,
      },
      {
        "goes up and down",
        function(t)
          return 0, 50 * pi * cos(pi * t)
        end,
        seconds = 2,
      },
      {
        "goes in a circle",
        function(t)
          return 50 * pi * cos(pi * t), 50 * pi * sin(pi * t)
        end,
      },
      {
        "falls faster than gravity",
        function(t)
          return 0, 2400 * t
        end,
      },
      {
        "rises ever faster",
        function(t)
          return 0, -2400 * t
        end,
      },
      {
        "stops dead and starts again",
        function(t)
          return 0, t * 4 % 2 < 1 and 300 or 0
        end,
      },
      {
        "stops dead on its way up",
        function(t)
          return 0, t * 4 % 2 < 1 and -600 or 0
        end,
      },
    }
    for _, row in ipairs(ways) do
      it("(6) keeps its rider when it " .. row[1], function()
        scene.each(EVERYWHERE, function(run)
          local named, log = settled(run)
          local lift = named.platform
          local function write(time, dt)
            lift.vx, lift.vy = row[2](time - dt / 2)
          end
          for _ in driven(run, row.seconds or 1, write) do
            rides(run, named.rider, lift, 20)
          end
          neverFlickered(run, log)
        end)
      end)
    end

    it("(6) keeps its rider when it turns round at every step", function()
      scene.each(EVERYWHERE, function(run)
        for _, row in ipairs({ { 0, 200 }, { 0, 5000 }, { 5000, 0 }, { 5000, -5000 } }) do
          local named, log = settled(run)
          local lift, sign = named.platform, 1
          for _ in
            driven(run, 0.5, function()
              lift.vx, lift.vy = sign * row[1], sign * row[2]
              sign = -sign
            end)
          do
            rides(run, named.rider, lift, 20)
          end
          neverFlickered(run, log)
        end
      end)
    end)
  end)

  --- The same when the game writes x and y.
  describe("a platform that the game places", function()
    -- how; where it is after t s; for 2 s: where it and its rider are then
    local ways = {
      {
        "evenly sideways",
        function(t)
          return 60 * t, 0
        end,
        { 220, 400, 240, 376 },
      },
      {
        "evenly upwards",
        function(t)
          return 0, -60 * t
        end,
        { 100, 280, 120, 256 },
      },
      {
        "evenly downwards",
        function(t)
          return 0, 60 * t
        end,
        { 100, 520, 120, 496 },
      },
      {
        "down at 200 px/s",
        function(t)
          return 0, 200 * t
        end,
        { 100, 800, 120, 776 },
      },
      {
        "at 5000 px/s",
        function(t)
          return 5000 * t, 5000 * t
        end,
      },
      {
        "on a sine sideways",
        function(t)
          return 50 * sin(pi * t), 0
        end,
        { 100, 400, 120, 376 },
      },
      {
        "on a sine up and down",
        function(t)
          return 0, 50 * sin(pi * t)
        end,
        { 100, 400, 120, 376 },
      },
      {
        "down faster than gravity",
        function(t)
          return 0, 1200 * t * t
        end,
      },
      {
        "in jumps of 10 px",
        function(t)
          return 0, 10 * math.floor(t * 8)
        end,
      },
    }
    for _, row in ipairs(ways) do
      it(("(6) %s takes its rider along"):format(row[1]), function()
        scene.each(EVERYWHERE, function(run)
          local named, log = settled(run)
          local lift = named.platform
          local function write(time)
            local x, y = row[2](time)
            lift.x, lift.y = 100 + x, 400 + y
          end
          for time in driven(run, row[3] and 2 or 1, write) do
            local x, y = row[2](time)
            run:at(lift, 100 + x, 400 + y)
            rides(run, named.rider, lift, 20)
          end
          neverFlickered(run, log)
          if row[3] then
            run:at(lift, row[3][1], row[3][2])
            run:at(named.rider, row[3][3], row[3][4])
          end
        end)
      end)
    end

    it("and moves by a velocity as well does both", function()
      scene.each(SOME, function(run)
        local named, log = settled(run)
        local lift = named.platform
        lift.vx, lift.vy = 30, 25
        for time in
          driven(run, 2, function(_, dt)
            lift.x, lift.y = lift.x + 40 * dt, lift.y - 60 * dt
          end)
        do
          run:at(lift, 100 + 70 * time, 400 - 35 * time)
          rides(run, named.rider, lift, 20)
        end
        neverFlickered(run, log)
      end)
    end)

    it("and then leaves alone stands still with its rider", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        local lift = named.platform
        for time in
          driven(run, 2, function(time)
            if time < 1 then
              lift.x = 100 + 60 * time
            end
          end)
        do
          rides(run, named.rider, lift, 20)
          if time > 1 then
            run:same("speed of the platform", lift.vx, 0)
          end
        end
        run:check(abs(lift.x - 160) < 6.1, "should be near 160, is at %.9g", lift.x)
      end)
    end)

    it("gives a rider that jumps its velocity", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        local lift = named.platform
        for _ in
          driven(run, 1, function(time)
            lift.x = 100 + 60 * time
          end)
        do
        end
        lift.x = 161 -- one step on
        named.rider.vy = -400
        run:step(1 / 60)
        run:near("vx", named.rider.vx, 60)
        run:near("x", named.rider.x, 181)
      end)
    end)

    --- A step longer than maxStep is split: the platform is not there at once, but on its way.
    it("spreads the way over the parts of a long step", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        local lift = named.platform
        lift.x = 106 -- 0.1 s, in three parts
        named.rider.vy = -400
        run:step(0.1)
        run:near("platform.x", lift.x, 106)
        run:near("vx", named.rider.vx, 60)
        run:at(named.rider, 126, 376 - 400 * 0.1 + 400 * 0.01)

        named = run:build({
          gravity = 0,
          platform(),
          rider({ x = 164, y = 392 }), -- at its right
        })
        run:step(1 / 60)
        named.platform.x = 112
        run:step(0.1)
        run:near("platform.x", named.platform.x, 112)
        run:near("vx of the pushed rider", named.rider.vx, 120)
        run:near("x of the pushed rider", named.rider.x, 176)
      end)
    end)
  end)

  --      +-+
  --      +-++
  --     +-+-+
  --     +-++
  --   +-----+  ->
  describe("on a rider", function()
    local function chain()
      return {
        platform(),
        rider(),
        rider({ name = "second", x = 126, y = 352 }),
        rider({ name = "third", x = 122, y = 328, mass = 50, friction = 0.5 }),
      }
    end

    for _, row in ipairs({ { 60, 0 }, { 0, -200 }, { 0, 200 }, { 5000, 5000 }, { -70, -5000 } }) do
      local vx, vy = row[1], row[2]
      it(("(6) three high go along at (%g, %g) px/s"):format(vx, vy), function()
        scene.each(EVERYWHERE, function(run)
          local named, log = settled(run, chain())
          local third = run:listen(named.third)
          named.platform.vx, named.platform.vy = vx, vy
          for time in run:steps(1) do
            run:at(named.platform, 100 + vx * time, 400 + vy * time)
            rides(run, named.rider, named.platform, 20)
            rides(run, named.second, named.rider, 6)
            rides(run, named.third, named.second, -4)
          end
          run:same("begins", log.begins, 2) -- platform and second
          run:same("ends", log.ends, 0)
          run:same("begins of the third", third.begins, 0) -- after it had settled
          run:same("ends of the third", third.ends, 0)
        end)
      end)
    end

    it("three high go along when the platform turns round at every step", function()
      scene.each(SOME, function(run)
        local named, log = settled(run, chain())
        local sign, lift = 1, named.platform
        for _ in
          driven(run, 0.5, function()
            lift.vx, lift.vy = 300 * sign, 500 * sign
            sign = -sign
          end)
        do
          rides(run, named.rider, lift, 20)
          rides(run, named.second, named.rider, 6)
          rides(run, named.third, named.second, -4)
        end
        run:same("ends", log.ends, 0)
      end)
    end)

    it("walks on it as on a floor", function()
      scene.each(SOME, function(run)
        local named = settled(run, { platform(), rider(), rider({ name = "top", y = 352 }) })
        named.platform.vx, named.platform.vy = 60, 90
        for time in
          run:steps(1, function()
            named.top.vx = 10
          end)
        do
          rides(run, named.rider, named.platform, 20)
          run:near("x", named.top.x, 120 + 70 * time)
          run:same("vx", named.top.vx, 10)
          run:flush(named.top, named.rider, "bottom")
        end
      end)
    end)

    --- the lower one goes away: the upper one falls to the platform and has its velocity all along
    it("falls to the platform when the lower one is removed", function()
      scene.each(SOME, function(run)
        local named = settled(run, { platform(), rider(), rider({ name = "top", y = 352 }) })
        named.platform.vx = 60
        run:play(0.5)
        run.world:remove(named.rider.raw)
        for time in run:steps(0.5) do
          run:near("offset", named.top.x - named.platform.x, 20)
          run:near("y", named.top.y, math.min(376, 352 + 400 * time * time))
        end
        rides(run, named.top, named.platform, 20)
      end)
    end)
  end)

  --                 |  |
  --     +-+         |  |  x = 260
  --     | |         |  |
  --   +-----+ ->    +--+
  describe("along a wall", function()
    it("(6) the rider is held back, and falls when the platform has passed", function()
      scene.each(EVERYWHERE, function(run)
        local description = { platform(), rider(), tile("wall", 260, 300, 16, 100) }
        local named, log = settled(run, description)
        named.platform.vx = 60
        for time, dt in run:steps(4) do
          local passed = time - 160 / 60
          run:near("platform.x", named.platform.x, 100 + 60 * time)
          run:near("x", named.rider.x, math.min(120 + 60 * time, 244))
          run:near("vx", named.rider.vx, 0)
          if passed < -1e-6 then
            run:flush(named.rider, named.platform, "bottom")
            run:check(support(run, named.rider) == named.platform, "should stand on it")
            local right = named.rider.touching.right
            if time > 2.1 then
              run:same("touching.right", right, named.wall)
            end
          elseif passed > 1e-6 then -- it begins to fall in this step or in the next one
            local late = math.max(0, passed - dt - 1e-9)
            if run.rate == "irregular" then
              late = math.max(0, passed - 0.1)
            end
            local y = named.rider.y - 376
            run:check(y >= 400 * late * late - 1e-6, "falls too late: %.9g", y)
            run:check(y <= 400 * passed * passed + 1e-6, "falls too early: %.9g", y)
          end
        end
        run:same("begins", log.begins, 2)
        run:same("ends", log.ends, 2) -- below the wall it is rid of that, too
      end)
    end)

    it("the rider goes along again when the platform comes back", function()
      scene.each(SOME, function(run)
        local named = settled(run, { platform(), rider(), tile("wall", 260, 300, 16, 100) })
        named.platform.vx = 60
        run:play(2.5)
        run:near("x", named.rider.x, 244)
        named.platform.vx = -60
        for time in run:steps(1) do
          run:near("x", named.rider.x, 244 - 60 * time)
          run:same("vx", named.rider.vx, 0)
          run:flush(named.rider, named.platform, "bottom")
        end
      end)
    end)

    it("the rider's rider is held back with it", function()
      scene.each(SOME, function(run)
        local named = settled(run, {
          platform(),
          rider(),
          rider({ name = "top", y = 352 }),
          tile("wall", 260, 300, 16, 100),
        })
        named.platform.vx = 60
        for _ in run:steps(2.5) do
          run:flush(named.rider, named.platform, "bottom")
          run:flush(named.top, named.rider, "bottom")
        end
        run:near("x", named.rider.x, 244)
        run:near("x of the upper one", named.top.x, 244)
      end)
    end)

    it("on the way down a lift does not pull what leans on it off the wall", function()
      scene.each(SOME, function(run)
        local named, log = settled(run, { platform(), rider(), tile("wall", 136, 300, 16, 100) })
        named.platform.vy = 60
        for time in
          run:steps(2 / 3, function()
            named.rider.vx = 100
          end)
        do
          run:near("y", named.rider.y, 376 + 60 * time)
          run:flush(named.rider, named.platform, "bottom")
          run:same("vy", named.rider.vy, 0)
          if time < 0.39 then
            run:near("x", named.rider.x, 120)
            run:same("vx", named.rider.vx, 0)
          end
        end
        run:check(log.ends <= 1, "ends %d contacts", log.ends)
      end)
    end)

    --  |w|->+-+
    --  |w|  | |
    --     +-----+   the platform stands
    it("that moves pushes the rider off", function()
      scene.each(SOME, function(run)
        local wall = { name = "wall", x = 40, y = 300, width = 16, height = 100, kinematic = true }
        local named = settled(run, { platform(), rider(), { "walls", wall } })
        named.wall.vx = 60
        for time in run:steps(2.5) do
          local pushed = math.max(120, 56 + 60 * time)
          run:near("x", named.rider.x, pushed)
          run:near("platform.x", named.platform.x, 100)
          if pushed < 164 - 1e-6 then
            run:near("y", named.rider.y, 376)
          elseif pushed > 164 + 7 then -- 0.1 s later
            run:check(named.rider.y > 376, "should fall")
            run:near("vx", named.rider.vx, 60)
          end
        end
      end)
    end)
  end)

  describe("on and off:", function()
    it("(6) a jump keeps the platform's velocity", function()
      scene.each(EVERYWHERE, function(run)
        local named = settled(run)
        named.platform.vx = 60
        run:play(2)
        named.rider.vy = -400
        for time in run:steps(5 / 6) do
          run:at(named.rider, 240 + 60 * time, 376 - 400 * time + 400 * time * time)
          run:same("vx", named.rider.vx, 60)
          run:check(not support(run, named.rider), "should be in the air")
        end
        run:play(1 / 6)
        run:near("x", named.rider.x, 300)
        run:play(0.5)
        rides(run, named.rider, named.platform, 20)
      end)
    end)

    for _, row in ipairs({ { 0, -60 }, { 0, 60 }, { 60, -60 }, { -80, 500 }, { 60, -300 } }) do
      local vx, vy = row[1], row[2]
      it(("a jump straight up on a lift at (%g, %g) ends at rest"):format(vx, vy), function()
        scene.each(SOME, function(run)
          local named, log = settled(run)
          named.platform.vx, named.platform.vy = vx, vy
          run:play(0.5)
          local x, y = named.rider.x, named.rider.y
          named.rider.vy = -400
          for time in run:steps(5 / 6) do -- in free flight, 400 px/s faster than the lift
            local up = vy - 400
            run:at(named.rider, x + vx * time, y + up * time + 400 * time * time)
            run:near("vy", named.rider.vy, up + 800 * time)
          end
          run:play(1 / 3)
          for _ in run:steps(0.5) do
            rides(run, named.rider, named.platform, 20)
          end
          run:same("begins", log.begins, 2)
          run:same("ends", log.ends, 1)
        end)
      end)
    end

    for _, vx in ipairs({ 200, -200, 61 }) do
      it(("a rider that walks off at %g px/s keeps the platform's velocity"):format(vx), function()
        scene.each(SOME, function(run)
          local named = settled(run)
          named.platform.vx = 60
          named.rider.vx = vx
          local left = false
          for time in run:steps(1.5) do
            run:near("x", named.rider.x, 120 + (60 + vx) * time)
            if support(run, named.rider) then
              run:near("own vx", named.rider.vx, vx)
              run:near("y", named.rider.y, 376)
            else
              run:near("vx", named.rider.vx, 60 + vx)
              run:check(not left or named.rider.y > 376, "should fall")
              left = true -- on the way off in this step, it falls in the next one
            end
          end
          run:check(not support(run, named.rider), "should have walked off")
        end)
      end)
    end

    it("a rider that walks off a sinking lift keeps its fall", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        named.platform.vy = 300
        named.rider.vx = 200
        local left
        for time in run:steps(1) do
          run:near("x", named.rider.x, 120 + 200 * time)
          if support(run, named.rider) then
            run:near("y", named.rider.y, 376 + 300 * time)
          else
            left = left or { named.rider.vy - 800 * time }
            run:near("vy", named.rider.vy, 800 * time + left[1])
            run:check(named.rider.vy > 299, "should fall like the lift")
          end
        end
        run:check(left, "should have walked off")
      end)
    end)

    --- own vx before and after the landing on a platform at 60 px/s
    for _, row in ipairs({ { 0, 0 }, { 30, 0 }, { 60, 0 }, { 100, 40 }, { -50, -50 } }) do
      local before, after = row[1], row[2]
      it(("a box that lands with vx = %g has vx = %g there"):format(before, after), function()
        scene.each(SOME, function(run)
          local named = run:build({
            platform({ x = 0, width = 400, vx = 60 }),
            rider({ x = 150, y = 350, vx = before }),
          })
          local landed
          for time in run:steps(1) do
            if landed then
              run:near("vx", named.rider.vx, after)
              run:near("way on the platform", named.rider.x - 60 * time - after * time, landed)
              run:flush(named.rider, named.platform, "bottom")
            elseif support(run, named.rider) then
              run:near("vx", named.rider.vx, after)
              landed = named.rider.x - 60 * time - after * time
            end
          end
          run:check(landed, "should have landed")
        end)
      end)
    end

    for _, vy in ipairs({ -60, 60, 300, -1000 }) do
      it(("a box that lands on a lift at %g px/s rides it at once"):format(vy), function()
        scene.each(SOME, function(run)
          local named = run:build({ platform({ vy = vy }), rider({ y = 340 }) })
          local log, landed = run:listen(named.rider), false
          for _ in run:steps(0.5) do
            landed = landed or support(run, named.rider) ~= nil
            if landed then
              rides(run, named.rider, named.platform, 20)
            end
          end
          run:check(landed or vy == 300, "should have landed")
          if landed then
            neverFlickered(run, log)
          end
        end)
      end)
    end

    it("a rider that changes from one platform to another has the other's velocity", function()
      scene.each(SOME, function(run)
        local named = settled(run, {
          platform(),
          platform({ name = "next", x = 164, width = 300 }),
          rider({ vx = 100 }),
        })
        named.next.vx = 40
        run:play(1.5)
        run:same("touching.bottom", support(run, named.rider), named.next)
        run:near("vx", named.rider.vx, 60) -- 100, of which 40 were the platform's
      end)
    end)

    it("a seam between two that move alike is none", function()
      scene.each(SOME, function(run)
        local named, log = settled(run, {
          platform({ vx = 60, vy = 30 }),
          platform({ name = "next", x = 164, vx = 60, vy = 30 }),
          rider({ x = 110 }),
        })
        named.rider.vx = 50
        for _ in run:steps(1.5) do
          run:same("vx", named.rider.vx, 50)
          run:same("vy", named.rider.vy, 0)
          run:flush(named.rider, named.platform, "bottom")
          run:touches(named.rider, "bottom")
        end
        run:same("touching.bottom", support(run, named.rider), named.next)
        run:same("begins", log.begins, 2)
      end)
    end)
  end)

  describe("an object that is put elsewhere", function()
    local function put(view)
      view.x, view.y = 300, -500
    end

    for name, reset in pairs({
      ["by x and y"] = function(_, named)
        put(named.rider)
      end,
      ["and refreshed"] = function(run, named)
        put(named.rider)
        run.world:refresh(named.rider.raw)
      end,
      ["and is taken out and put in again"] = function(run, named)
        run.world:remove(named.rider.raw)
        put(named.rider)
        run.world:add("players", named.rider.raw)
      end,
      ["while it is switched off"] = function(run, named)
        named.rider.raw.active = false
        run:play(0.5)
        put(named.rider)
        named.rider.raw.active = true
      end,
      ["when the platform goes"] = function(run, named)
        run.world:remove(named.platform.raw)
        put(named.rider)
      end,
    }) do
      it(name .. " is carried by nothing any more, and falls from rest", function()
        scene.each(SOME, function(run)
          local named = settled(run)
          named.platform.vx, named.platform.vy = 50, -300
          run:play(0.5)
          reset(run, named)
          for time in run:steps(0.5) do
            run:at(named.rider, 300, -500 + 400 * time * time)
            run:near("vx", named.rider.vx, 0)
            run:near("vy", named.rider.vy, 800 * time)
          end
        end)
      end)
    end

    it("where it stood, but switched off, is carried by nothing", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        named.platform.vx, named.platform.vy = 50, 300
        named.rider.raw.active = false
        run:play(0.5)
        run:at(named.rider, 120, 376)
        named.rider.raw.active = true
        for time in run:steps(0.5) do
          run:at(named.rider, 120, 376 + 400 * time * time)
        end
      end)
    end)

    it("together with what stands on it, both fall from rest", function()
      scene.each(SOME, function(run)
        local named = settled(run, { platform(), rider(), rider({ name = "upper", y = 352 }) })
        named.platform.vx, named.platform.vy = 50, -300
        run:play(0.5)
        named.rider.x, named.rider.y = 300, -500
        named.upper.x, named.upper.y = 300, -524
        for time in run:steps(0.5) do
          run:at(named.rider, 300, -500 + 400 * time * time)
          run:at(named.upper, 300, -524 + 400 * time * time)
        end
      end)
    end)

    -- What stands in the tables when a step is made counts, not what was read and refused before.
    for name, leave in pairs({
      ["put elsewhere"] = function(view)
        view.x, view.y = 300, -500
      end,
      ["switched off"] = function(view)
        view.raw.active = false
      end,
    }) do
      it("rides on if it is " .. name .. " and back while an update is refused", function()
        scene.each(SOME, function(run)
          local named = settled(run, { platform(), rider(), tile("tile", 0, 0, 16, 16) })
          local box = { x = 1000, y = 0, width = 16, height = 16, gravity = 0 }
          run.world:add("zoo", box)
          named.platform.vx = 200
          run:play(0.5)
          local x, y = named.rider.x, named.rider.y
          leave(named.rider)
          box.mass = -1
          assert.has_error(function()
            run.world:update(1 / 60)
          end)
          box.mass, named.rider.raw.active = nil, nil
          named.rider.x, named.rider.y = x, y
          for _ in run:steps(0.5) do
            rides(run, named.rider, named.platform, 20)
          end
        end)
      end)
    end

    it("on what carries it rides on", function()
      scene.each(SOME, function(run)
        local named = settled(run, { platform({ width = 500 }), rider() })
        named.platform.vx, named.platform.vy = 50, -300
        run:play(0.5)
        named.rider.x = named.platform.x + 400
        for _ in run:steps(0.5) do
          rides(run, named.rider, named.platform, 400)
        end
      end)
    end)

    it("by less than its size jumps with the platform's velocity", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        named.platform.vx, named.platform.vy = 50, -100
        run:play(0.5)
        local x, y = named.rider.x, named.rider.y
        named.rider.y = y - 2
        named.rider.vy = -400
        for time in run:steps(0.5) do
          run:at(named.rider, x + 50 * time, y - 2 - 500 * time + 400 * time * time)
        end
      end)
    end)
  end)

  describe("when the platform goes away", function()
    local function falls(run, body, time, x)
      run:near("x", body.x, x + 60 * time)
      run:near("vx", body.vx, 60)
      run:near("y", body.y, 376 + 400 * time * time)
    end

    for name, vanish in pairs({
      removed = function(run, view)
        run.world:remove(view.raw)
      end,
      ["taken out of its table"] = function(run, view)
        local list = run.world.objects.platforms
        for key, object in pairs(list) do
          if object == view.raw then
            list[key] = nil
          end
        end
      end,
      deactivated = function(_, view)
        view.active = false
      end,
      ["made a sensor"] = function(_, view)
        view.sensor = true
      end,
      masked = function(_, view)
        view.mask = { players = false }
      end,
    }) do
      it(name .. ", the rider keeps its velocity", function()
        scene.each(SOME, function(run)
          local named, log = settled(run)
          named.platform.vx = 60
          run:play(1)
          vanish(run, named.platform)
          for time in run:steps(0.5) do
            falls(run, named.rider, time, 180)
          end
          run:same("ends", log.ends, 1)
        end)
      end)
    end

    it("the rider's rider keeps its velocity, too", function()
      scene.each(SOME, function(run)
        local named = settled(run, { platform(), rider(), rider({ name = "top", y = 352 }) })
        named.platform.vx = 60
        run:play(1)
        run.world:remove(named.platform.raw)
        for time in run:steps(0.5) do
          falls(run, named.rider, time, 180)
          run:near("x", named.top.x, 180 + 60 * time)
          run:near("vx", named.top.vx, 60)
          run:flush(named.top, named.rider, "bottom")
        end
      end)
    end)

    it("and was falling, the rider keeps its fall", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        named.platform.vy = 200
        run:play(1)
        run.world:remove(named.platform.raw)
        for time in run:steps(0.5) do
          run:near("y", named.rider.y, 576 + 200 * time + 400 * time * time)
          run:near("vy", named.rider.vy, 200 + 800 * time)
        end
      end)
    end)

    it("turned into a dynamic object, both fall on side by side", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        named.platform.vx = 60
        run:play(1)
        named.platform.kinematic = nil
        for time in run:steps(0.5) do
          falls(run, named.rider, time, 180)
          run:near("x of the platform", named.platform.x, 160 + 60 * time)
          run:near("y of the platform", named.platform.y, 400 + 400 * time * time)
        end
      end)
    end)

    it("no more than its `carry`, the rider slides on beside it", function()
      scene.each(SOME, function(run)
        local named, log = settled(run)
        named.platform.vx = 60
        run:play(1)
        named.platform.carry = false
        for _ in run:steps(0.5) do
          run:near("offset", named.rider.x - named.platform.x, 20)
          run:near("vx", named.rider.vx, 60)
          run:flush(named.rider, named.platform, "bottom")
        end
        neverFlickered(run, log)
      end)
    end)

    it("turned static, the rider slides on over it", function()
      scene.each(SOME, function(run)
        local named = settled(run)
        named.platform.vx = 20
        run:play(1)
        named.platform.static = true
        run.world:refresh(named.platform.raw)
        for time in run:steps(0.5) do
          run:at(named.rider, 140 + 20 * time, 376)
          run:near("vx", named.rider.vx, 20)
        end
      end)
    end)

    it("under a rider that is removed, it and its other rider go on", function()
      scene.each(SOME, function(run)
        local named, log = settled(run, { platform(), rider(), rider({ name = "other", x = 140 }) })
        local other = run:listen(named.other)
        named.platform.vx, named.platform.vy = 60, -60
        run:play(0.5)
        run.world:remove(named.rider.raw)
        for _ in run:steps(0.5) do
          rides(run, named.other, named.platform, 40)
        end
        run:same("ends", log.ends, 1)
        run:same("ends of the other", other.ends, 0)
      end)
    end)
  end)

  describe("with carry = false", function()
    it("the platform slides away under what stands on it", function()
      scene.each(SOME, function(run)
        local named, log =
          settled(run, { platform({ x = 0, width = 200, carry = false }), rider() })
        named.platform.vx = 60
        for _ in run:steps(1) do
          run:at(named.rider, 120, 376)
          run:still(named.rider)
        end
        neverFlickered(run, log)
      end)
    end)

    it("the platform lifts what stands on it", function()
      scene.each(SOME, function(run)
        local named, log = settled(run, { platform({ carry = false }), rider() })
        named.platform.vy = -60
        for time in run:steps(1) do
          run:at(named.rider, 120, 376 - 60 * time)
          run:flush(named.rider, named.platform, "bottom")
        end
        neverFlickered(run, log)
      end)
    end)

    it("the platform drags what stands on it by friction only", function()
      scene.each(SOME, function(run)
        local named = settled(run, {
          platform({ x = 0, width = 400, carry = false }),
          rider({ friction = 0.5 }),
        })
        named.platform.vx = 100
        for time in run:steps(1 / 6) do
          run:near("vx", named.rider.vx, 400 * time, 1e-6)
        end
        run:play(0.5)
        run:near("vx", named.rider.vx, 100)
      end)
    end)
  end)

  --      +-+  ->
  --      | |
  --   (o=====o=====o)   60 px/s
  describe("a belt", function()
    --- `surfaceSpeed` is along x, so a scene with one is not turned by a quarter.
    local ALONG = { rate = variants.RATES, turn = { 0, 2 } }

    local function belt(run, fields)
      local speed = (fields and fields.surfaceSpeed or 60) * (run.turn == 2 and -1 or 1)
      local object = { name = "platform", x = 0, y = 400, width = 400, height = 8, static = true }
      with(object, fields)
      object.surfaceSpeed = speed
      return { "platforms", object }
    end

    for _, friction in ipairs({ 0, 0.1, 1 }) do
      local kinds = { static = {}, kinematic = { static = false, kinematic = true } }
      for name, fields in pairs(kinds) do
        local title = "that is %s moves a box with friction %g at exactly its speed"
        it(title:format(name, friction), function()
          scene.each(ALONG, function(run)
            local named, log = settled(run, { belt(run, fields), rider({ friction = friction }) })
            local x = named.rider.x
            for time in run:steps(2) do
              run:at(named.rider, x + 60 * time, 376)
              run:still(named.rider)
              run:touches(named.rider, "bottom")
            end
            run:near("platform.x", named.platform.x, 0)
            neverFlickered(run, log)
          end)
        end)
      end

      it(("grips a box with friction %g that is dropped on it"):format(friction), function()
        scene.each(ALONG, function(run)
          local named = run:build({ belt(run), rider({ y = 340, friction = friction }) })
          run:play(0.5) -- lands after 0.3 s
          run:still(named.rider)
          local x = named.rider.x
          for time in run:steps(1) do
            run:at(named.rider, x + 60 * time, 376)
            run:still(named.rider)
          end
        end)
      end)
    end

    it("of a moving platform adds to its velocity", function()
      scene.each(ALONG, function(run)
        local fields = { static = false, kinematic = true, vx = 25, vy = -40 }
        local named = settled(run, { belt(run, fields), rider() })
        local x, y = named.rider.x, named.rider.y
        for time in run:steps(1) do
          run:at(named.rider, x + 85 * time, y - 40 * time)
          run:still(named.rider)
          run:flush(named.rider, named.platform, "bottom")
        end
      end)
    end)

    for _, own in ipairs({ 50, -60, -100, 300 }) do
      it(("adds to the %g px/s of what walks on it"):format(own), function()
        scene.each(ALONG, function(run)
          local named = settled(run, { belt(run, { x = -1000, width = 2000 }), rider() })
          local x = named.rider.x
          for time in
            run:steps(1, function()
              named.rider.vx = own
            end)
          do
            run:at(named.rider, x + (60 + own) * time, 376)
            run:near("vx", named.rider.vx, own)
          end
        end)
      end)
    end

    it("gives what leaves it its speed", function()
      scene.each(ALONG, function(run)
        local named = settled(run, { belt(run, { width = 200 }), rider() })
        local x = named.rider.x
        for time in run:steps(2) do
          run:near("x", named.rider.x, x + 60 * time)
        end
        run:check(named.rider.y > 376, "should have left it")
        run:near("vx", named.rider.vx, 60)
      end)
    end)

    it("moves a pile", function()
      scene.each(ALONG, function(run)
        local named = settled(run, {
          belt(run),
          rider(),
          rider({ name = "top", y = 352, friction = 0.5 }),
        })
        local x = named.rider.x
        for time in run:steps(1) do
          run:at(named.rider, x + 60 * time, 376)
          run:at(named.top, x + 60 * time, 352)
          run:still(named.top)
        end
      end)
    end)

    it("presses against a wall without a rattle", function()
      scene.each(ALONG, function(run)
        local named, log = settled(run, { belt(run), rider(), tile("wall", 160, 300, 16, 100) })
        run:play(1)
        for _ in run:steps(1) do
          run:at(named.rider, 144, 376)
          run:still(named.rider)
          run:flush(named.rider, named.wall, "right")
          run:touches(named.rider, "bottom", "right")
        end
        run:same("begins", log.begins, 2)
        run:same("ends", log.ends, 0)
      end)
    end)

    it("hands over to a faster one, and to a slower one with friction", function()
      scene.each(ALONG, function(run)
        for _, speed in ipairs({ 120, 20 }) do
          local named = settled(run, {
            belt(run, { width = 200 }),
            belt(run, { name = "next", x = 200, surfaceSpeed = speed }),
            rider({ friction = 0.5 }),
          })
          run:play(2.5)
          run:same("touching.bottom", support(run, named.rider), named.next)
          local x = named.rider.x
          for time in run:steps(0.5) do
            run:near("x", named.rider.x, x + speed * time)
            run:still(named.rider)
          end
        end
      end)
    end)

    it("that is switched round or off moves what stands on it accordingly", function()
      scene.each(ALONG, function(run)
        local fields = { static = false, kinematic = true }
        local named = settled(run, { belt(run, fields), rider({ x = 200 }) })
        run:play(0.5)
        named.platform.surfaceSpeed = -named.platform.surfaceSpeed
        local x = named.rider.x
        for time in run:steps(0.5) do
          run:near("x", named.rider.x, x - 60 * time)
          run:still(named.rider)
        end
        named.platform.surfaceSpeed = 0
        x = named.rider.x
        for _ in run:steps(0.5) do
          run:near("x", named.rider.x, x)
          run:still(named.rider)
        end
      end)
    end)
  end)

  describe("with others in the way:", function()
    --     +-+
    --   --| |--   one-way
    --   +-----+
    --      ^
    it("a rider is carried up through a one-way, and stands on it on the way back", function()
      scene.each(SOME, function(run)
        local way = tile("way", 90, 343.3, 100, 8)
        way[2].oneWay = "top"
        local named, log = settled(run, { platform(), rider(), way })
        named.platform.vy = -60
        for time in run:steps(1.5) do
          run:at(named.rider, 120, 376 - 60 * time)
          rides(run, named.rider, named.platform, 20)
        end
        neverFlickered(run, log)
        named.platform.vy = 60
        for time in run:steps(2) do
          run:at(named.rider, 120, math.min(286 + 60 * time, 319.3))
          run:still(named.rider)
        end
        run:same("touching.bottom", support(run, named.rider), named.way)
        run:same("begins", log.begins, 2)
        run:same("ends", log.ends, 1)
      end)
    end)

    --   +--+ ->  +-+
    --   +--+     +-+
    --          --------+
    --                  |  ledge
    it("a platform pushes a box off a ledge", function()
      scene.each(SOME, function(run)
        local named = settled(run, {
          platform({ y = 392 }), -- a bar above the ledge, 100 .. 164
          rider({ x = 200 }),
          tile("ledge", 180, 400, 100, 8),
        })
        named.platform.vx = 60
        for time in run:steps(2.5) do
          local x = math.max(200, 164 + 60 * time)
          run:near("x", named.rider.x, x)
          if x > 207 and x < 280 then
            run:near("vx", named.rider.vx, 60)
          end
          if x < 280 - 1e-6 then
            run:near("y", named.rider.y, 376)
          end
        end
        run:check(named.rider.y > 400, "should have fallen, is at %.9g", named.rider.y)
        run:near("vx", named.rider.vx, 60)
      end)
    end)

    it("a lift takes its rider past a wall of tiles without a snag", function()
      scene.each(SOME, function(run)
        local description = scene.tiles({ platform(), rider() }, 30, 136, 0, 16, 13, 0, 13)
        local named, log = settled(run, description)
        named.platform.x = 72 -- ends at the wall, too; its rider stays where it is
        named.platform.vx, named.platform.vy = 0, -100
        run:play(1 / 6)
        local x = named.rider.x
        for _ in
          run:steps(2, function()
            named.rider.vx = 100
          end)
        do
          run:check(named.rider.x >= x, "should not go back")
          run:flush(named.rider, named.platform, "bottom")
          run:same("vy", named.rider.vy, 0)
          run:check(not named.rider.touching.top, "should not bump its head")
        end
        run:near("x", named.rider.x, 120)
        run:check(log.begins > 10, "should pass tiles")
      end)
    end)

    it("a lift under a loose box in a shaft carries it up to the bit", function()
      scene.each(SOME, function(run)
        local named = settled(run, {
          platform({ x = 104 }),
          rider(),
          tile("left", 104, 0, 16, 399),
          tile("right", 136, 0, 16, 399),
        })
        named.platform.vy = -100
        for time in run:steps(2) do
          run:near("y", named.rider.y, 376 - 100 * time)
          run:near("x", named.rider.x, 120)
          run:flush(named.rider, named.platform, "bottom")
          run:still(named.rider)
        end
      end)
    end)

    it("a lift that comes up under a box that stands on a floor takes it over", function()
      scene.each(SOME, function(run)
        local named = settled(run, {
          platform({ y = 430.5 }),
          rider({ x = 90 }),
          tile("floor", 0, 400, 100, 8), -- 90 .. 100 of the rider stands on it
        })
        named.platform.vy = -60
        for time in run:steps(1) do
          run:at(named.rider, 90, math.min(376, 406.5 - 60 * time))
          run:still(named.rider)
        end
        rides(run, named.rider, named.platform, -10)
      end)
    end)
  end)
end)
