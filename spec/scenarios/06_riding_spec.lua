--- Riding: platforms, lifts and belts take along what stands on them.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local SETTLE = 1 / 6 -- s, ten steps at 60 Hz
local abs, pi, sin, cos = math.abs, math.pi, math.sin, math.cos

local platform = scene.thing(
  "platforms",
  { name = "platform", x = 100, y = 400, width = 64, height = 8, kinematic = true }
)
local rider = scene.thing("players", { name = "rider", x = 120, y = 376, width = 16, height = 24 })

local function tile(name, x, y, width, height)
  return { "tiles", { name = name, x = x, y = y, width = width, height = height, static = true } }
end

local WALL = tile("wall", 260, 300, 16, 100)

--- Row 6's scene, at rest: views by name, and the events of the rider from the beginning.
local function settled(run, description)
  local named = run:build(description or { platform(), rider() })
  local log = named.rider and run:listen(named.rider)
  run:play(SETTLE)
  return named, log
end

--- Two on each other on a platform.
local function pair()
  return { platform(), rider(), rider({ name = "top", y = 352 }) }
end

--- Fails unless `upper` stands on `lower` without a gap, `offset` px right of its left edge, and is
--- at rest as it sees it.
local function rides(run, upper, lower, offset)
  run:near("offset", upper.x - lower.x, offset)
  run:flush(upper, lower, "bottom")
  run:same("touching.bottom", run:support(upper), lower)
  run:still(upper)
end

--- Fails unless there were `begins` contacts (1), of which `ends` (0) are over.
local function had(run, log, begins, ends)
  run:same("begins", log.begins, begins or 1)
  run:same("ends", log.ends, ends or 0)
end

local function fallsFrom(run, body, x, y, vx, vy, time)
  run:at(body, x + vx * time, y + vy * time + 400 * time * time)
  run:near("vx", body.vx, vx)
  run:near("vy", body.vy, vy + 800 * time)
end

describe("kinematic: a platform", function()
  --     +-+
  --     | |
  --   +-----+  ->
  for i, row in ipairs({
    -- its velocity
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
    local title = ("(6) takes its rider along at (%g, %g) px/s"):format(vx, vy)
    scene.it(title, i <= 5 and EVERYWHERE or SOME, function(run)
      local named, log = settled(run)
      named.platform.vx, named.platform.vy = vx, vy
      for time in run:steps(i <= 4 and 2 or 1) do
        run:at(named.platform, 100 + vx * time, 400 + vy * time)
        run:at(named.rider, 120 + vx * time, 376 + vy * time)
        rides(run, named.rider, named.platform, 20)
      end
      had(run, log)
    end)
  end

  -- Of the time t in s, and of the number of the step; times an amplitude.
  local SHAPES = {
    even = function(t)
      return t
    end,
    square = function(t)
      return t * t
    end,
    sine = function(t)
      return sin(pi * t)
    end,
    cosine = function(t)
      return cos(pi * t)
    end,
    ["half the time"] = function(t)
      return t * 4 % 2 < 1 and 1 or 0
    end,
    jumps = function(t)
      return math.floor(t * 8)
    end,
    ["to and fro"] = function(_, step)
      return step % 2 == 0 and -1 or 1
    end,
  }

  -- Which fields the game writes before each step, in which shape, amplitudes (px/s or px), s.
  -- (A velocity is that of the middle of the step.)
  for _, row in ipairs({
    { "vx, vy", "cosine", 50 * pi, "cosine", 0, 2 },
    { "vx, vy", "cosine", 0, "cosine", 50 * pi, 2 },
    { "vx, vy", "cosine", 50 * pi, "sine", 50 * pi, 1 },
    { "vx, vy", "even", 0, "even", 2400, 1 }, -- faster than gravity
    { "vx, vy", "even", 0, "even", -2400, 1 },
    { "vx, vy", "even", 0, "half the time", 300, 1 },
    { "vx, vy", "even", 0, "half the time", -600, 1 },
    { "vx, vy", "to and fro", 0, "to and fro", 200, 0.5 },
    { "vx, vy", "to and fro", 0, "to and fro", 5000, 0.5 },
    { "vx, vy", "to and fro", 5000, "to and fro", 0, 0.5 },
    { "vx, vy", "to and fro", 5000, "to and fro", -5000, 0.5 },
    { "x, y", "even", 60, "even", 0, 2 },
    { "x, y", "even", 0, "even", -60, 2 },
    { "x, y", "even", 0, "even", 60, 2 },
    { "x, y", "even", 0, "even", 200, 2 },
    { "x, y", "even", 5000, "even", 5000, 1 },
    { "x, y", "sine", 50, "even", 0, 2 },
    { "x, y", "even", 0, "sine", 50, 2 },
    { "x, y", "even", 0, "square", 1200, 1 }, -- faster than gravity
    { "x, y", "even", 0, "jumps", 10, 1 },
  }) do
    local shapeX, shapeY, isPlaced = SHAPES[row[2]], SHAPES[row[4]], row[1] == "x, y"
    local title = "(6) keeps its rider when the game writes %s: %s * %g, %s * %g"
    scene.it(title:format(row[1], row[2], row[3], row[4], row[5]), EVERYWHERE, function(run)
      local named, log = settled(run)
      local lift, step, x, y = named.platform, 0, nil, nil
      local function write(time, dt)
        step = step + 1
        local t = isPlaced and time or time - dt / 2
        x, y = row[3] * shapeX(t, step), row[5] * shapeY(t, step)
        if isPlaced then
          lift.x, lift.y = 100 + x, 400 + y
        else
          lift.vx, lift.vy = x, y
        end
      end
      for _ in run:steps(row[6], write) do
        if isPlaced then
          run:at(lift, 100 + x, 400 + y)
        end
        rides(run, named.rider, lift, 20)
      end
      had(run, log)
    end)
  end

  scene.it("that has a velocity, and that the game places, does both", SOME, function(run)
    local named, log = settled(run)
    local lift = named.platform
    lift.vx, lift.vy = 30, 25
    local function write(_, dt)
      lift.x, lift.y = lift.x + 40 * dt, lift.y - 60 * dt
    end
    for time in run:steps(2, write) do
      run:at(lift, 100 + 70 * time, 400 - 35 * time)
      rides(run, named.rider, lift, 20)
    end
    had(run, log)
  end)

  scene.it("that the game places, and then leaves alone, stands still", SOME, function(run)
    local named = settled(run)
    local lift = named.platform
    local function write(time)
      if time < 1 then
        lift.x = 100 + 60 * time
      end
    end
    for time in run:steps(2, write) do
      rides(run, named.rider, lift, 20)
      if time > 1 then
        run:same("speed of the platform", lift.vx, 0)
      end
    end
    run:check(abs(lift.x - 160) < 6.1, "should be near 160, is at %.9g", lift.x)
  end)

  --- A step longer than maxStep is split: the platform is not there at once, but on its way.
  scene.it("maxStep: spreads its way over the parts of a long step", SOME, function(run)
    local named = settled(run)
    named.platform.x = 106 -- 0.1 s, in three parts
    named.rider.vy = -400
    run:step(0.1)
    run:near("platform.x", named.platform.x, 106)
    run:near("vx", named.rider.vx, 60)
    run:at(named.rider, 126, 376 - 400 * 0.1 + 400 * 0.01)

    named = run:build({ gravity = 0, platform(), rider({ x = 164, y = 392 }) }) -- at its right
    run:step(1 / 60)
    named.platform.x = 112
    run:step(0.1)
    run:near("platform.x", named.platform.x, 112)
    run:near("vx of the pushed rider", named.rider.vx, 120)
    run:near("x of the pushed rider", named.rider.x, 176)
  end)

  --      +-+
  --      +-++
  --     +-+-+
  --     +-++
  --   +-----+  ->
  for _, row in ipairs({
    -- velocity, and whether it turns round at every step
    { 60, 0 },
    { 0, -200 },
    { 0, 200 },
    { 5000, 5000 },
    { -70, -5000 },
    { 300, 500, true },
  }) do
    local vx, vy, turns = row[1], row[2], row[3]
    local title = "(6) takes three on each other along at (%g, %g) px/s" .. (turns and ", ±" or "")
    scene.it(title:format(vx, vy), EVERYWHERE, function(run)
      local named, log = settled(run, {
        platform(),
        rider(),
        rider({ name = "second", x = 126, y = 352 }),
        rider({ name = "third", x = 122, y = 328, mass = 50, friction = 0.5 }),
      })
      local third, sign = run:listen(named.third), 1
      local function write()
        named.platform.vx, named.platform.vy = sign * vx, sign * vy
        sign = turns and -sign or sign
      end
      for time in run:steps(turns and 0.5 or 1, write) do
        if not turns then
          run:at(named.platform, 100 + vx * time, 400 + vy * time)
        end
        rides(run, named.rider, named.platform, 20)
        rides(run, named.second, named.rider, 6)
        rides(run, named.third, named.second, -4)
      end
      had(run, log, 2) -- platform and second
      had(run, third, 0) -- after it had settled
    end)
  end
end)

--                 |  |
--     +-+         |  |  x = 260
--     | |         |  |
--   +-----+ ->    +--+
describe("kinematic: a rider at a wall", function()
  scene.it("(6) is held back, and falls when the platform has passed", EVERYWHERE, function(run)
    local named, log = settled(run, { platform(), rider(), WALL })
    named.platform.vx = 60
    for time, dt in run:steps(4) do
      local passed = time - 160 / 60
      run:near("platform.x", named.platform.x, 100 + 60 * time)
      run:near("x", named.rider.x, math.min(120 + 60 * time, 244))
      run:near("vx", named.rider.vx, 0)
      if passed < -1e-6 then
        run:flush(named.rider, named.platform, "bottom")
        run:check(run:support(named.rider) == named.platform, "should stand on it")
        if time > 2.1 then
          run:same("touching.right", named.rider.touching.right, named.wall)
        end
      elseif passed > 1e-6 then -- it begins to fall in this step or in the next one
        local late = math.max(0, passed - (run.rate == "irregular" and 0.1 or dt + 1e-9))
        local y = named.rider.y - 376
        run:check(y >= 400 * late * late - 1e-6, "falls too late: %.9g", y)
        run:check(y <= 400 * passed * passed + 1e-6, "falls too early: %.9g", y)
      end
    end
    had(run, log, 2, 2) -- below the wall it is rid of that, too
  end)

  --  |w|->+-+
  --  |w|  | |
  --     +-----+   the platform stands
  scene.it("that moves is pushed off the platform", SOME, function(run)
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

describe("kinematic: on and off a platform:", function()
  local ROWS = { { 60, 0 }, { 0, -60 }, { 0, 60 }, { 60, -60 }, { -80, 500 }, { 60, -300 } }
  for i, row in ipairs(ROWS) do
    local vx, vy = row[1], row[2]
    local title = "(6) a jump straight up at (%g, %g) px/s keeps that, and ends at rest"
    scene.it(title:format(vx, vy), i == 1 and EVERYWHERE or SOME, function(run)
      local named, log = settled(run)
      named.platform.vx, named.platform.vy = vx, vy
      run:play(0.5)
      local x, y = named.rider.x, named.rider.y
      named.rider.vy = -400
      for time in run:steps(5 / 6) do -- in free flight, 400 px/s faster than the lift
        fallsFrom(run, named.rider, x, y, vx, vy - 400, time)
        run:check(not run:support(named.rider), "should be in the air")
      end
      run:play(1 / 3)
      for _ in run:steps(0.5) do
        rides(run, named.rider, named.platform, 20)
      end
      had(run, log, 2, 1)
    end)
  end

  for _, vx in ipairs({ 200, -200, 61 }) do
    local title = ("a rider that walks off at %g px/s keeps the platform's velocity"):format(vx)
    scene.it(title, SOME, function(run)
      local named = settled(run)
      named.platform.vx, named.rider.vx = 60, vx
      local left = false
      for time in run:steps(1.5) do
        run:near("x", named.rider.x, 120 + (60 + vx) * time)
        if run:support(named.rider) then
          run:near("own vx", named.rider.vx, vx)
          run:near("y", named.rider.y, 376)
        else
          run:near("vx", named.rider.vx, 60 + vx)
          run:check(not left or named.rider.y > 376, "should fall")
          left = true -- on the way off in this step, it falls in the next one
        end
      end
      run:check(not run:support(named.rider), "should have walked off")
    end)
  end

  -- Own vx before and after the landing on a platform at 60 px/s.
  for _, row in ipairs({ { 0, 0 }, { 30, 0 }, { 60, 0 }, { 100, 40 }, { -50, -50 } }) do
    local before, after = row[1], row[2]
    local title = ("a box that lands with vx = %g has vx = %g there"):format(before, after)
    scene.it(title, SOME, function(run)
      local named = run:build({
        platform({ x = 0, width = 400, vx = 60 }),
        rider({ x = 150, y = 350, vx = before }),
      })
      local landed
      for time in run:steps(1) do
        local start = named.rider.x - 60 * time - after * time
        if landed or run:support(named.rider) then
          landed = landed or start
          run:near("vx", named.rider.vx, after)
          run:near("way on the platform", start, landed)
          run:flush(named.rider, named.platform, "bottom")
        end
      end
      run:check(landed, "should have landed")
    end)
  end

  for _, vy in ipairs({ -60, 60, 300, -1000 }) do
    local title = ("a box that lands on a lift at %g px/s rides it at once"):format(vy)
    scene.it(title, SOME, function(run)
      local named = run:build({ platform({ vy = vy }), rider({ y = 340 }) })
      local log, landed = run:listen(named.rider), false
      for _ in run:steps(0.5) do
        landed = landed or run:support(named.rider) ~= nil
        if landed then
          rides(run, named.rider, named.platform, 20)
        end
      end
      run:check(landed or vy == 300, "should have landed")
      had(run, log, landed and 1 or 0)
    end)
  end

  scene.it("a rider that changes to another one has that one's velocity", SOME, function(run)
    local next_ = platform({ name = "next", x = 164, width = 300 })
    local named = settled(run, { platform(), next_, rider({ vx = 100 }) })
    named.next.vx = 40
    run:play(1.5)
    run:same("touching.bottom", run:support(named.rider), named.next)
    run:near("vx", named.rider.vx, 60) -- 100, of which 40 were the platform's
  end)
end)

describe("kinematic: a rider that is put elsewhere", function()
  -- What the game does to a rider at (145, 226) on a platform at (50, -300) px/s.
  local WAYS = {
    ["by x and y"] = function() end,
    ["and refreshed"] = function(run, named)
      run.world:refresh(named.rider.raw)
    end,
    ["and taken out and put in again"] = function(run, named)
      run.world:remove(named.rider.raw)
      run.world:add("players", named.rider.raw)
    end,
    ["while it is switched off"] = function(run, named)
      named.rider.raw.active = false
      run:play(0.5)
      named.rider.raw.active = true
    end,
    ["when the platform goes"] = function(run, named)
      run.world:remove(named.platform.raw)
    end,
  }
  for name, change in pairs(WAYS) do
    scene.it(name .. ", falls from rest, and so does its rider", SOME, function(run)
      local named = settled(run, pair())
      named.platform.vx, named.platform.vy = 50, -300
      run:play(0.5)
      named.rider.x, named.rider.y, named.top.x, named.top.y = 300, -500, 300, -524
      change(run, named)
      named.rider.x, named.rider.y, named.top.x, named.top.y = 300, -500, 300, -524
      named.top.vx, named.top.vy = 0, 0
      for time in run:steps(0.5) do
        fallsFrom(run, named.rider, 300, -500, 0, 0, time)
        run:at(named.top, 300, -524 + 400 * time * time)
      end
    end)
  end

  scene.it("on what carries it rides on", SOME, function(run)
    local named = settled(run, { platform({ width = 500 }), rider() })
    named.platform.vx, named.platform.vy = 50, -300
    run:play(0.5)
    named.rider.x = named.platform.x + 400
    for _ in run:steps(0.5) do
      rides(run, named.rider, named.platform, 400)
    end
  end)
end)

describe("kinematic: when the platform is", function()
  for name, vanish in pairs({
    removed = function(run, view)
      run.world:remove(view.raw)
    end,
    ["taken out of its table"] = function(run)
      run.world.objects.platforms = nil
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
    for vx, vy in pairs({ [60] = 0, [0] = 200 }) do
      local title = name .. ", at (%g, %g) px/s, the riders keep that"
      scene.it(title:format(vx, vy), SOME, function(run)
        local named, log = settled(run, pair())
        named.platform.vx, named.platform.vy = vx, vy
        run:play(1)
        vanish(run, named.platform)
        for time in run:steps(0.5) do
          fallsFrom(run, named.rider, 120 + vx, 376 + vy, vx, vy, time)
          run:near("x", named.top.x, 120 + vx + vx * time)
          run:near("vx", named.top.vx, vx)
          run:flush(named.top, named.rider, "bottom")
        end
        run:same("ends", log.ends, 1)
      end)
    end
  end

  scene.it("made dynamic, both fall on side by side", SOME, function(run)
    local named = settled(run)
    named.platform.vx = 60
    run:play(1)
    named.platform.kinematic = nil
    for time in run:steps(0.5) do
      fallsFrom(run, named.rider, 180, 376, 60, 0, time)
      run:at(named.platform, 160 + 60 * time, 400 + 400 * time * time)
    end
  end)
end)

describe("carry = false: a platform", function()
  scene.it("slides away under what stands on it", SOME, function(run)
    local named, log = settled(run, { platform({ x = 0, width = 200, carry = false }), rider() })
    named.platform.vx = 60
    for _ in run:steps(1) do
      run:at(named.rider, 120, 376)
      run:still(named.rider)
    end
    had(run, log)
  end)

  scene.it("drags what stands on it by friction only", SOME, function(run)
    local wide = platform({ x = 0, width = 400, carry = false })
    local named = settled(run, { wide, rider({ friction = 0.5 }) })
    named.platform.vx = 100
    for time in run:steps(1 / 6) do
      run:near("vx", named.rider.vx, 400 * time, 1e-6)
    end
    run:play(0.5)
    run:near("vx", named.rider.vx, 100)
  end)

  scene.it(
    "that is switched to it in the run lets its rider slide on beside it",
    SOME,
    function(run)
      local named, log = settled(run)
      named.platform.vx = 60
      run:play(1)
      named.platform.carry = false
      for _ in run:steps(0.5) do
        run:near("offset", named.rider.x - named.platform.x, 20)
        run:near("vx", named.rider.vx, 60)
        run:flush(named.rider, named.platform, "bottom")
      end
      had(run, log)
    end
  )
end)

--      +-+  ->
--      | |
--   (o=====o=====o)   60 px/s
describe("surfaceSpeed: a belt", function()
  --- It is along x, so a scene with one is not turned by a quarter.
  local ALONG = { rate = variants.RATES, turn = { 0, 2 } }
  local KINEMATIC = { static = false, kinematic = true }
  local plain = scene.thing(
    "platforms",
    { name = "platform", x = 0, y = 400, width = 400, height = 8, static = true, surfaceSpeed = 60 }
  )

  local function belt(run, fields)
    local entry = plain(fields)
    entry[2].surfaceSpeed = entry[2].surfaceSpeed * (run.turn == 2 and -1 or 1)
    return entry
  end

  for _, friction in ipairs({ 0, 0.1, 1 }) do
    for name, fields in pairs({ static = {}, kinematic = KINEMATIC }) do
      local title = ("that is %s moves a pile with friction %g at its speed"):format(name, friction)
      scene.it(title, ALONG, function(run)
        local named, log = settled(run, {
          belt(run, fields),
          rider({ friction = friction }),
          rider({ name = "top", y = 352, friction = 0.5 }),
        })
        local x, top = named.rider.x, named.top.x
        for time in run:steps(2) do
          run:at(named.rider, x + 60 * time, 376)
          run:at(named.top, top + 60 * time, 352)
          run:still(named.rider)
          run:still(named.top)
          run:touches(named.rider, "bottom", "top")
        end
        run:near("platform.x", named.platform.x, 0)
        had(run, log, 2)
      end)
    end

    local title = ("grips a box with friction %g that is dropped on it"):format(friction)
    scene.it(title, ALONG, function(run)
      local named = run:build({ belt(run), rider({ y = 340, friction = friction }) })
      run:play(0.5) -- lands after 0.3 s
      run:still(named.rider)
      local x = named.rider.x
      for time in run:steps(1) do
        run:at(named.rider, x + 60 * time, 376)
        run:still(named.rider)
      end
    end)
  end

  scene.it("of a moving platform adds to its velocity", ALONG, function(run)
    local fields = { static = false, kinematic = true, vx = 25, vy = -40 }
    local named = settled(run, { belt(run, fields), rider() })
    local x, y = named.rider.x, named.rider.y
    for time in run:steps(1) do
      run:at(named.rider, x + 85 * time, y - 40 * time)
      run:still(named.rider)
      run:flush(named.rider, named.platform, "bottom")
    end
  end)

  for _, own in ipairs({ 50, -60, -100, 300 }) do
    scene.it(("adds to the %g px/s of what walks on it"):format(own), ALONG, function(run)
      local named = settled(run, { belt(run, { x = -1000, width = 2000 }), rider() })
      local x = named.rider.x
      for time in run:steps(1, run:keep(named.rider, own)) do
        run:at(named.rider, x + (60 + own) * time, 376)
        run:near("vx", named.rider.vx, own)
      end
    end)
  end

  scene.it("gives what leaves it its speed", ALONG, function(run)
    local named = settled(run, { belt(run, { width = 200 }), rider() })
    local x = named.rider.x
    for time in run:steps(2) do
      run:near("x", named.rider.x, x + 60 * time)
    end
    run:check(named.rider.y > 376, "should have left it")
    run:near("vx", named.rider.vx, 60)
  end)

  scene.it("presses against a wall without a rattle", ALONG, function(run)
    local named, log = settled(run, { belt(run), rider(), tile("wall", 160, 300, 16, 100) })
    run:play(1)
    for _ in run:steps(1) do
      run:at(named.rider, 144, 376)
      run:still(named.rider)
      run:flush(named.rider, named.wall, "right")
      run:touches(named.rider, "bottom", "right")
    end
    had(run, log, 2)
  end)

  for _, speed in ipairs({ 120, 20 }) do
    scene.it(("hands over to one at %d px/s, with friction"):format(speed), ALONG, function(run)
      local named = settled(run, {
        belt(run, { width = 200 }),
        belt(run, { name = "next", x = 200, surfaceSpeed = speed }),
        rider({ friction = 0.5 }),
      })
      run:play(2.5)
      run:same("touching.bottom", run:support(named.rider), named.next)
      local x = named.rider.x
      for time in run:steps(0.5) do
        run:near("x", named.rider.x, x + speed * time)
        run:still(named.rider)
      end
    end)
  end

  scene.it("that is switched round or off moves what stands on it so", ALONG, function(run)
    local named = settled(run, { belt(run, KINEMATIC), rider({ x = 200 }) })
    run:play(0.5)
    for _, factor in ipairs({ -1, 0 }) do
      named.platform.surfaceSpeed = named.platform.surfaceSpeed * factor
      local x = named.rider.x
      for time in run:steps(0.5) do
        run:near("x", named.rider.x, x + 60 * factor * time)
        run:still(named.rider)
      end
    end
  end)
end)

describe("kinematic: with others in the way:", function()
  --     +-+
  --   --| |--   one-way
  --   +-----+
  --      ^
  scene.it("a rider is carried up through a one-way, and back on to it", SOME, function(run)
    local way = tile("way", 90, 343.3, 100, 8)
    way[2].oneWay = "top"
    local named, log = settled(run, { platform(), rider(), way })
    named.platform.vy = -60
    for time in run:steps(1.5) do
      run:at(named.rider, 120, 376 - 60 * time)
      rides(run, named.rider, named.platform, 20)
    end
    had(run, log)
    named.platform.vy = 60
    for time in run:steps(2) do
      run:at(named.rider, 120, math.min(286 + 60 * time, 319.3))
      run:still(named.rider)
    end
    run:same("touching.bottom", run:support(named.rider), named.way)
    had(run, log, 2, 1)
  end)

  scene.it("a lift takes its rider past a wall of tiles without a snag", SOME, function(run)
    local description = scene.tiles({ platform(), rider() }, 30, 136, 0, 16, 13, 0, 13)
    local named, log = settled(run, description)
    named.platform.x = 72 -- ends at the wall, too; its rider stays where it is
    named.platform.vx, named.platform.vy = 0, -100
    run:play(1 / 6)
    local x = named.rider.x
    for _ in run:steps(2, run:keep(named.rider, 100)) do
      run:check(named.rider.x >= x, "should not go back")
      run:flush(named.rider, named.platform, "bottom")
      run:same("vy", named.rider.vy, 0)
      run:check(not named.rider.touching.top, "should not bump its head")
    end
    run:near("x", named.rider.x, 120)
    run:check(log.begins > 10, "should pass tiles")
  end)

  scene.it("a lift that comes up under a box on a floor takes it over", SOME, function(run)
    local floor = tile("floor", 0, 400, 100, 8) -- 90 .. 100 of the rider stands on it
    local named = settled(run, { platform({ y = 430.5 }), rider({ x = 90 }), floor })
    named.platform.vy = -60
    for time in run:steps(1) do
      run:at(named.rider, 90, math.min(376, 406.5 - 60 * time))
      run:still(named.rider)
    end
    rides(run, named.rider, named.platform, -10)
  end)
end)
