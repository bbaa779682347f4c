--- Faults that games saw, each as a kind: the smallest scene that shows it, and its relatives. What
--- they saw stands above each.

local garbage = require("spec.support.garbage")
local motion = require("spec.support.motion")
local newOverlaps = require("spec.support.overlap").checker
local newRandom = require("spec.support.random").new
local physics = require("physics")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local ORDERS = { "forward", "shuffled", "backward" }
local TURNED = { shift = { 0, 1 / 3, 100000.3 }, rate = { 60, 30, 144 }, order = ORDERS }
TURNED.turn = variants.TURNS
local UPRIGHT = { shift = { 0, 1 / 3, -1000.1 }, rate = { 60, 30, 144 }, order = ORDERS }
local SETTLE = 1 / 6 -- s, a whole number of steps at each rate

-- Returns a function that makes entries of a group, which are static, kinematic or neither.
local function kind(group, fixed)
  return function(name, x, y, width, height, fields)
    local object = { name = name, x = x, y = y, width = width, height = height }
    for key, value in pairs(fields or {}) do
      object[key] = value
    end
    if fixed then
      object[fixed] = true
    end
    return { group, object }
  end
end

local solid, carrier, body = kind("tiles", "static"), kind("carriers", "kinematic"), kind("bodies")
local player = kind("players")

-- Plays some seconds; none of the steps may move anything farther than it may.
local function watched(run, watch, seconds)
  for _, dt in ipairs(scene.times(seconds, run.rate)) do
    watch:before()
    run:step(dt)
    local problem = watch:after(dt)
    run:check(not problem, "%s", problem)
  end
end

-- Fails unless two objects are apart, flush or with a gap.
local function expectApart(run)
  local deepest, a, b = newOverlaps(run.all)()
  if deepest > 0.01 then
    local text = "two overlap by %.9g px, at %.9g, %.9g and %.9g, %.9g"
    run:check(false, text, deepest, a.x, a.y, b.x, b.y)
  end
end

-- Fails unless nothing moves by a bit for half a second.
-- Nothing goes further than half a pixel in half a second: crates that are squeezed sideways part
-- by 0.03 px in a step, less than a player sees, until the sum of their overlaps has stayed.
local function expectRest(run)
  local before = {}
  for i, object in ipairs(run.all) do
    before[i] = { object.x, object.y }
  end
  for _ in run:steps(0.5) do
    for i, object in ipairs(run.all) do
      local x, y = before[i][1], before[i][2]
      local text = "an object at rest went from %.17g, %.17g to %.17g, %.17g"
      local far = math.max(math.abs(object.x - x), math.abs(object.y - y))
      run:check(far <= 0.5, text, x, y, object.x, object.y)
    end
  end
end

-- Plays `count` steps of 1 / rate s.
local function play(world, count, rate, each)
  for n = 1, count do
    world:update(1 / (rate or 60))
    if each then
      each(n)
    end
  end
end

--   | man |            | man |
--   =======  v  ...    =======     both are written elsewhere in the same frame
-- The man fell behind, and a contact ended that was never broken.
describe("x and y: what is put elsewhere together with what carries it", function()
  local STACK = { "car", "crate", "man" }

  for _, speed in ipairs({ { 0, 240 }, { 0, -120 }, { 100, 0 }, { -60, 30 }, { 0, 0 } }) do
    for _, way in ipairs({ { 0, -480 }, { 700, 0 }, { -2000.5, 333.25 }, { 3, 0 } }) do
      local title = "goes on riding: a carrier of %g, %g px/s, by %g, %g px"
      scene.it(title:format(speed[1], speed[2], way[1], way[2]), UPRIGHT, function(run)
        local named = run:build({
          carrier("car", 0, 400, 100, 16, { vx = speed[1], vy = speed[2] }),
          body("crate", 20, 368, 32, 32),
          body("man", 24, 344, 16, 24),
        })
        local log = run:listenToWorld()
        run:play(SETTLE)
        for _ = 1, 3 do
          local offsets = { named.crate.x - named.car.x, named.man.x - named.crate.x }
          for _, name in ipairs(STACK) do
            named[name].x, named[name].y = named[name].x + way[1], named[name].y + way[2]
          end
          run.world:refresh(named.car.raw)
          for _ in run:steps(0.5) do
            for i, offset in ipairs(offsets) do
              local low, high = named[STACK[i]], named[STACK[i + 1]]
              run:near("the gap", low.y - high.y - high.height, 0)
              run:near("the place on it", high.x - low.x, offset)
              run:same("touching.bottom", run:support(high), low)
            end
          end
        end
        run:same("ends", log.ends, 0)
        run:same("begins", log.begins, 2)
      end)
    end
  end

  scene.it("goes on when everything is moved, static objects too", UPRIGHT, function(run)
    local named = run:build({
      solid("floor", -500, 300, 1000, 16),
      carrier("lift", 0, 250, 60, 16, { vy = -30 }),
      body("crate", 100, 284, 16, 16),
      body("top", 100, 268, 16, 16),
      body("man", 20, 226, 16, 24),
    })
    local log = run:listenToWorld()
    run:play(SETTLE)
    local begins = log.begins
    for _, object in ipairs(run.all) do
      object.x, object.y = object.x - 5000, object.y + 2500
      if object.static or object.kinematic then
        run.world:refresh(object)
      end
    end
    for _ in run:steps(0.5) do
      run:near("the crate", named.crate.y, 2784)
      run:near("the one on it", named.top.y, 2768)
      run:near("the gap below the man", named.lift.y - named.man.y, 24)
    end
    run:same("begins", log.begins, begins)
    run:same("ends", log.ends, 0)
  end)

  -- It fell beside the lift for two dozen updates.
  for _, speed in ipairs({ { 0, 30 }, { 0, 60 }, { 0, 200 }, { 0, 400 }, { 40, 120 } }) do
    for _, how in ipairs({ "written", "added" }) do
      local title = "is taken along from the second update on by a lift at %d, %d px/s, if it is %s"
      scene.it(title:format(speed[1], speed[2], how), UPRIGHT, function(run)
        local named = run:build({
          carrier("lift", 100, 0, 64, 8, { vx = speed[1], vy = speed[2] }),
          how == "written" and body("man", -400, -500, 16, 24) or nil,
        })
        run:step(1 / run.rate)
        local man, y = named.man, named.lift.y - 24
        if man then
          man.x, man.y, man.vy = named.lift.x + 20, y, 0
        else
          local fields = { x = named.lift.x + 20, y = y, width = 16, height = 24 }
          man = run:add("bodies", fields)
        end
        run:step(1 / run.rate)
        run:step(1 / run.rate)
        local offset = man.x - named.lift.x
        for _ in run:steps(1) do
          run:near("the gap", named.lift.y - man.y - 24, 0)
          run:near("the place on it", man.x - named.lift.x, offset)
          run:same("touching.bottom", man.raw.touching.bottom, named.lift.raw)
        end
      end)
    end
  end
end)

--   ########  a ceiling of 8 px
--     +-+
--     | |     24 px high
--   ########
-- What grew came out on top of the ceiling or below the floor, and nothing told so.
describe("width and height: growing where there is no room", function()
  --  +------+ |        both grow beyond the wall, from 50 to 110 px
  --  +------+ |
  scene.it("leaves a wall on the side where it stood, also where others grow", {
    turn = { 0, 1 },
    shift = { 0 },
  }, function(run)
    local size = run.turn == 0 and "width" or "height"
    local description = { gravity = 0, solid("wall", 100, -500, 4, 1000) }
    for n = 1, 3 do
      description[n + 1] = body("man" .. n, 50, 100 * n, 50, 40)
    end
    local named = run:build(description)
    run:step(1 / 60)
    for n = 1, 3 do
      local man = named["man" .. n]
      local x, y = man.x, man.y
      man.raw[size] = 110
      man.x, man.y = x, y
    end
    run:play(SETTLE)
    for n = 1, 3 do
      run:near("x", named["man" .. n].x, -10)
    end
  end)

  -- Writes a box of the scene to an object, whatever the turn.
  local function write(run, view, x, y, width, height)
    local isTurned = run.turn % 2 == 1
    view.raw.width, view.raw.height = isTurned and height or width, isTurned and width or height
    view.x, view.y = x, y
  end

  for _, row in ipairs({
    -- what, box that it grows into
    { "upwards", 100, 260, 20, 40 },
    { "downwards", 100, 280, 20, 40 },
    { "both ways", 100, 270, 20, 40 },
    { "a little", 100, 278, 20, 26 },
    { "much", 100, 250, 20, 80 },
    { "sideways", 90, 280, 40, 20 },
  }) do
    local name, x, y, width, height = row[1], row[2], row[3], row[4], row[5]
    local isX = name == "sideways"
    for _, thick in ipairs({ 1, 8, 16 }) do
      local title = ("%s, it stays between two solids of %g px"):format(name, thick)
      scene.it(title, TURNED, function(run)
        local named = run:build({
          solid("floor", 0, 300, 600, isX and 16 or thick),
          isX and solid("left", 100 - thick, 100, thick, 200)
            or solid("ceiling", 0, 276 - thick, 300, thick),
          body("man", isX and 102 or 100, 280, 20, 20),
          isX and solid("right", 124, 100, thick, 200) or nil,
        })
        local log, man = run:listen(named.man), named.man
        run:play(SETTLE)
        write(run, man, x, y, width, height)
        local low, high = isX and 100 or 276, isX and 124 or 300
        for _ in run:steps(1) do
          local middle = isX and man.x + man.width / 2 or man.y + man.height / 2
          local text = "its middle is at %.9g, not between %.9g and %.9g"
          run:check(middle >= low - 1e-6 and middle <= high + 1e-6, text, middle, low, high)
        end
        run:check(log.crushes > 0, "onCrush told nothing")
      end)
    end
  end

  scene.it("and shrinking again leaves it standing on the floor", TURNED, function(run)
    local named = run:build({
      solid("floor", 0, 300, 600, 16),
      solid("ceiling", 0, 268, 600, 8),
      body("man", 100, 280, 20, 20),
    })
    run:play(SETTLE)
    write(run, named.man, 100, 260, 20, 40)
    run:play(0.5)
    write(run, named.man, 100, named.man.y + 10, 20, 20)
    run:play(1)
    run:at(named.man, 100, 280)
    run:still(named.man)
  end)
end)

--   +--------+
--   |  boss  |
--   |     +-+|
--   |     |P||     P: a player in its foot
--   ----------
-- The boss was lifted onto the player's head, or not: the first of the two groups decided.
describe("pushable = false: a boss and what is inside it", function()
  local FEW = { shift = { 0, 1 / 3 }, order = { "forward", "backward" }, rate = { 60, 30 } }
  local FLOOR = solid("floor", -500, 300, 1500, 16)
  local BOSS = body("boss", 200, 236, 80, 64, { pushable = false, mass = 100 })

  local function expectParted(run, players)
    local description = { FLOOR, BOSS }
    for n, entry in ipairs(players) do
      description[n + 2] = entry
    end
    local named = run:build(description)
    for _ in run:steps(1) do
      run:at(named.boss, 200, 236)
    end
    expectApart(run)
    return named.player
  end

  scene.it("part, and the player alone moves, wherever in its foot it is", FEW, function(run)
    for at = -13, 79 do
      local it_ = expectParted(run, { player("player", 200 + at, 276, 14, 24) })
      run:near("the player's y", it_.y, 276)
      run:check(it_.x <= 186.01 or it_.x >= 279.99, "from %d it came to x = %.9g", at, it_.x)
    end
  end)

  for _, row in ipairs({
    -- x, y, width, height of the player; mass
    { 230, 280, 20, 20, 1 },
    { 230, 280, 20, 20, 1000 },
    { 190, 292, 8, 8, 1 },
    { 260, 200, 60, 100, 5 },
    { 210, 226, 14, 24, 1 }, -- at its head: upwards
    { 100, 260, 200, 40, 1 }, -- wider than the boss
  }) do
    local title = ("part, and a player of %g x %g px, mass %g, moves"):format(
      row[3],
      row[4],
      row[5]
    )
    scene.it(title, FEW, function(run)
      expectParted(run, { player("player", row[1], row[2], row[3], row[4], { mass = row[5] }) })
    end)
  end

  scene.it("part, of ten that are all inside it, and each other", FEW, function(run)
    local random, ten = newRandom(3), {}
    for i = 1, 10 do
      ten[i] = player(nil, random:between(200, 266), 276, 14, 24)
    end
    expectParted(run, ten)
  end)

  scene.it("part, if it is another boss", FEW, function(run)
    local other = body("other", 260, 236, 80, 64, { pushable = false, mass = 100 })
    local named = run:build({ FLOOR, BOSS, other })
    run:play(1)
    expectApart(run)
    run:check(named.boss.x < named.other.x, "they have changed sides")
  end)
end)

--   ################
--          ##
--          ##           16 at one spot
--   ################
-- They stayed one column, pressed into the ceiling for ever.
describe("overlaps: a pile at one spot under a ceiling", function()
  for _, row in ipairs({
    -- boxes, their size, height of the corridor, y of the spot above its floor
    { 16, 16, 64, 40 },
    { 12, 20, 20, 20 },
    { 24, 8, 30, 20 },
    { 16, 16, 64, 16 },
    { 16, 16, 64, 64 },
    { 8, 16, 100, 50 },
  }) do
    local count, size, height, above = row[1], row[2], row[3], row[4]
    local title = "is apart within a second: %d of %d px in a corridor of %d px, at %d px"
    scene.it(title:format(count, size, height, above), TURNED, function(run)
      local description = {
        solid("floor", -600, 100, 1200, 16),
        solid("ceiling", -600, 100 - height - 16, 1200, 16),
      }
      for i = 1, count do
        description[2 + i] = body("box" .. i, 0, 100 - above, size, size)
      end
      local named = run:build(description)
      watched(run, motion.new(run.world, run.all), 1)
      expectApart(run)
      local least, most = 0, 0
      for i = 1, count do
        local box = named["box" .. i]
        least, most = math.min(least, box.x), math.max(most, box.x)
        local isInside = box.y >= 100 - height - 0.01 and box.y <= 100 - size + 0.01
        run:check(isInside, "box %d is at y = %.9g", i, box.y)
      end
      run:check(most - least >= size, "they are still one column")
      run:play(1)
      expectRest(run)
    end)
  end
end)

--   |->|####|
--   |->|####|
--   +-------+
-- Hundreds of impacts in each step, for ever.
describe("kinematic: a heap that it squeezes", function()
  for _, row in ipairs({
    -- crates, their sizes, what is left of 200 px, restitution, friction
    { 20, "equal", 40, 0, 0.3 },
    { 20, "different", 40, 0, 0.3 },
    { 20, "different", 30, 0, 0 },
    { 20, "different", 40, 0.5, 0.3 },
    { 40, "different", 80, 0, 0.3 },
    { 5, "different", 12, 0, 0.3 },
  }) do
    local count, sizes, left, restitution, friction = row[1], row[2], row[3], row[4], row[5]
    local title = "of %d crates of %s sizes in %d px, restitution %g, friction %g, rests"
    scene.it(title:format(count, sizes, left, restitution, friction), UPRIGHT, function(run)
      local random, rows = newRandom(12), 5
      local description = {
        solid("floor", -300, 300, 600, 16),
        solid("ceiling", -300, 204, 600, 16),
        solid("wall", 200, 220, 16, 80),
        carrier("piston", -100, 220, 100, 80),
      }
      for i = 0, count - 1 do
        local size = sizes == "equal" and 16 or random:between(10, 16)
        local column = math.floor(i / rows)
        local x, y = 4 + 17 * column, 300 - 16 * (i - rows * column) - size
        local fields = { restitution = restitution, friction = friction }
        description[5 + i] = body("crate" .. i, x, y, size, size, fields)
      end
      local named = run:build(description)
      local watch = motion.new(run.world, run.all)
      named.piston.vx = 200 - left
      watched(run, watch, 1)
      named.piston.vx = 0
      watched(run, watch, count < 40 and restitution == 0 and 2 or 3)
      expectRest(run)
    end)
  end
end)

--   [4] ->  .  [4]
-- Less than half of the energy was left after one step.
describe("restitution 1: of different masses in a row", function()
  -- Of the energy, in all, at most: in a row of five, of which light ones are hit from both sides,
  -- the rounds of a step end first (see docs/reliability.md).
  local LOSS, LOSS_OF_FIVE = 0.2, 0.55
  local LEVELS = { rate = variants.RATES, turn = { 0, 2 }, order = { "forward", "backward" } }

  local function energyOf(objects)
    local energy, momentum = 0, 0
    for _, object in ipairs(objects) do
      energy = energy + object.mass * (object.vx ^ 2 + object.vy ^ 2) / 2
      momentum = momentum + object.mass * object.vx
    end
    return energy, momentum
  end

  for _, row in ipairs({
    { { 4, 0.1, 4 }, 2 },
    { { 4, 0.1, 4 }, 0 },
    { { 4, 0.1, 4 }, 5.5 },
    { { 1, 1, 1 }, 2 },
    { { 4, 1, 4 }, 2 },
    { { 1, 4, 0.1 }, 2 },
    { { 4, 0.1, 4, 0.1, 4 }, 2 },
    { { 1, 1, 1, 1, 1, 1 }, 0 },
  }) do
    local masses, gap = row[1], row[2]
    local title = "%s, %g px apart, keep momentum and most of the energy"
    scene.it(title:format(table.concat(masses, ", "), gap), LEVELS, function(run)
      local description = { gravity = 0 }
      for i, mass in ipairs(masses) do
        local fields = { mass = mass, restitution = 1, vx = i == 1 and 400 or 0 }
        description[i] = body("ball" .. i, (16 + gap) * (i - 1), 0, 16, 16, fields)
      end
      run:build(description)
      local energy, momentum = energyOf(run.all)
      local before = energy
      for _ in run:steps(0.5) do
        local now, sum = energyOf(run.all)
        run:near("the momentum", sum, momentum, 1e-9 * math.abs(momentum))
        run:check(now <= before * (1 + 1e-9), "energy grew from %.17g to %.17g", before, now)
        local loss = #masses == 5 and LOSS_OF_FIVE or LOSS
        run:check(now >= energy * (1 - loss), "%.3g of the energy is left", now / energy)
        before = now
      end
    end)
  end
end)

-- At 30 Hz it went 0.04 px farther than by hand.
describe("airFriction: what moves alone is the same at every rate:", function()
  local exp, log = math.exp, math.log
  local LEVELS = { rate = variants.RATES, turn = { 0, 2 }, order = { "forward" } }

  -- A speed with v' = -k v - a: its way after t, until it stands. k > 0.
  local function braked(v, k, a, t)
    t = math.min(t, log(1 + k * v / a) / k)
    return (v + a / k) / k * (1 - exp(-k * t)) - a / k * t
  end

  -- A speed from 0 with v' = a - k v up to a limit, which may be too high: its way after t.
  local function limited(a, k, limit, t)
    local reached = limit * k < a and -log(1 - k * limit / a) / k or t
    local s = math.min(t, reached)
    return a / k * s - a / (k * k) * (1 - exp(-k * s)) + limit * math.max(t - reached, 0)
  end

  -- Plays one box; `axis` is where `way(t)` says after t s.
  local function row(title, gravity, fields, axis, way, more)
    scene.it(title, LEVELS, function(run)
      local named = run:build({
        gravity = gravity,
        solid("floor", -2000, 5000, 6000, 16),
        solid("ground", -2000, 100, fields.friction and 6000 or 1, 16),
        body("box", 0, 84, 16, 16, fields),
      })
      for time in run:steps(2) do
        local expected = way(time) + (axis == "y" and 84 or 0)
        run:near(axis, named.box[axis], expected, (more or 1e-6) + 1e-9 * math.abs(run.shift))
      end
      run:check(not fields.friction or named.box.vx == 0, "should stand")
    end)
  end

  for _, r in ipairs({
    -- speed, friction, airFriction, gravity
    { 600, 0.3, 2, 1000 },
    { 600, 0.3, 0.5, 1000 },
    { 200, 0.5, 4, 800 },
    { -350, 0.1, 1, 800 },
    { 900, 1, 10, 640 },
  }) do
    local v, friction, air, gravity = r[1], r[2], r[3], r[4]
    local title = ("%g px/s, friction %g, airFriction %g"):format(v, friction, air)
    local fields = { vx = v, friction = friction, airFriction = air }
    row(title, gravity, fields, "x", function(t)
      return v / math.abs(v) * braked(math.abs(v), air, friction * gravity, t)
    end)
  end

  for _, r in ipairs({
    -- pull, airFriction, largest speed
    { 800, 0.5, 200 },
    { 800, 2, 300 },
    { 1000, 4, 200 },
    { 800, 0.1, 700 },
    { 800, 2, 500 }, -- never reached
  }) do
    local pull, air, limit = r[1], r[2], r[3]
    local title = ("pulled by %g px/s², airFriction %g, up to %g px/s, "):format(pull, air, limit)
    local function way(t)
      return limited(pull, air, limit, t)
    end
    row(title .. "falling", pull, { airFriction = air, maxSpeedY = limit }, "y", way)
    row(title .. "by ax", 0, { ax = pull, airFriction = air, maxSpeedX = limit }, "x", way)
  end

  -- In the step in which it stops it slows down evenly.
  local fields = { vx = 400, airFriction = 1.5, drag = 120 }
  row("with drag", 0, fields, "x", function(t)
    return braked(400, 1.5, 120, t)
  end, 1e-3)
end)

--           ##
--         ####
--   +-+ ######
--   | |#######
-- Now and then a step ended in the air, and a jump asked for then was lost.
describe("nudge: up stairs", function()
  local LEVELS = { rate = { 60, 30, 144, 240 }, shift = { 0, 0.1, 1 / 3 } }
  LEVELS.order = { "forward", "backward" }
  for _, row in ipairs({
    -- width and height of a stair, px, speed, px/s
    { 1, 1, 120 },
    { 1, 1, 60 },
    { 2, 1, 120 },
    { 4, 2, 120 },
    { 8, 4, 200 },
    { 16, 8, 400 },
    { 3, 4, 90 },
  }) do
    local width, height, speed = row[1], row[2], row[3]
    local title = "of %g x %g px at %g px/s it stands in every step"
    scene.it(title:format(width, height, speed), LEVELS, function(run)
      for _, way in ipairs({ 1, -1 }) do
        local description = { solid("floor", -500, 100, 1000, 16) }
        for i = 1, 40 do
          local x = way * (40 + width * (i - 1)) - (way < 0 and width or 0)
          description[i + 1] = solid("stair" .. i, x, 100 - height * i, width, height * i)
        end
        description[42] = body("man", way > 0 and 0 or -16, 76, 16, 24, { nudge = height })
        local named = run:build(description)
        run:step(1 / run.rate)
        for _ = 1, math.floor((24 + 40 * width) / speed * run.rate) do
          named.man.vx = way * speed
          run:step(1 / run.rate)
          local foot = named.man.raw.touching.bottom
          run:check(foot, "in the air at %.9g, %.9g", named.man.x, named.man.y)
        end
        run:check(named.man.y < 76 - 10 * height, "it came up to y = %.9g only", named.man.y)
      end
    end)
  end
end)

--   ##+-+
--   ##| |  800 <-     a belt that stands upright
--   ##+-+
-- Nothing moved.
it("surfaceSpeed takes along what gravity presses onto it, from each side", function()
  for _, row in ipairs({
    -- gravityX, gravity, x, y of the body at a belt from 0 to 20, axis of the belt, across it
    { 800, 0, -16, 0, "y", "x", "width" },
    { -800, 0, 20, 0, "y", "x", "width" },
    { 0, -800, 0, 20, "x", "y", "height" },
    { 0, 800, 0, -16, "x", "y", "height" },
  }) do
    for _, speed in ipairs({ 60, -90 }) do
      for _, rate in ipairs({ 30, 60, 144 }) do
        local world = physics.newWorld({ gravityX = row[1], gravity = row[2] })
        local belt = { x = -1000, y = -1000, width = 2000, height = 2000, static = true }
        belt[row[6]], belt[row[7]], belt.surfaceSpeed = 0, 20, speed
        local box = { x = row[3], y = row[4], width = 16, height = 16 }
        world:add("belts", belt)
        world:add("boxes", box)
        play(world, 2, rate)
        local along, across = box[row[5]], box[row[6]]
        play(world, rate, rate)
        assert.near(across, box[row[6]], 1e-9)
        assert.near(math.abs(speed), math.abs(box[row[5]] - along), 1e-6)
      end
    end
  end
end)

--   ####****
--      ++
--      ||  ^     1 px under one brick, 7 px under the other
-- The one that came first in the game's list was told, and broke.
describe("onBegin: of two bricks hit at the same moment", function()
  for _, row in ipairs({ { 1, 7 }, { 7, 1 }, { 2, 14 }, { 9, 7 }, { 15.5, 0.5 } }) do
    local left, right = row[1], row[2]
    local title = "the one with the wider common edge is first: %g and %g px"
    scene.it(title:format(left, right), TURNED, function(run)
      local wide = left > right and "left" or "right"
      local named = run:build({
        gravity = 0,
        solid("left", 0, 0, 100, 16),
        solid("right", 100, 0, 100, 16),
        body("man", 100 - left, 40, left + right, 24, { vy = -300 }),
      })
      local told = {}
      run.world.onBegin = function(a, b)
        told[#told + 1] = a == named.man.raw and b or a
      end
      run:play(0.5)
      run:check(told[1] == named[wide].raw, "the first that is told is not the %s one", wide)
      local top = named.man.touching.top
      run:check(top and top.raw == named[wide].raw, "touching.top is not the %s one", wide)
    end)
  end
end)

-- Of each tile 2.5 kB stayed when it was gone.
describe("remove: what is gone", function()
  it("leaves its columns to what comes later", function()
    local world, tiles = physics.newWorld(), {}
    local function fillAndEmpty()
      for i = 1, 500 do
        tiles[i] = { x = 16 * i, y = 0, width = 16, height = 16, static = true }
        world:add("tiles", tiles[i])
      end
      world:update(1 / 60)
      for i = 1, 500 do
        world:remove(tiles[i])
        tiles[i] = nil
      end
      play(world, 2)
    end
    local kept = garbage.kept(fillAndEmpty, 2, 6) / (6 * 500)
    assert.is_true(kept <= 10, ("%.0f bytes of each are left"):format(kept))
  end)

  it("lets what stood on it fall, all at once", function()
    local world, crates = physics.newWorld({ gravity = 800 }), {}
    for i = 0, 199 do
      world:add("tiles", { x = 16 * i, y = 100, width = 16, height = 16, static = true })
    end
    for i = 1, 100 do
      crates[i] = world:add("crates", { x = 30 * i, y = 84, width = 16, height = 16 })
    end
    play(world, 10)
    world.objects.tiles = nil
    play(world, 30, 60, function(step)
      for _, crate in ipairs(crates) do
        assert.near(84 + 400 * (step / 60) ^ 2, crate.y, 1e-9)
      end
    end)
  end)
end)

--   #####     hit, and left again in the same step
--    +-+ ^
-- `touching.top` was false in each update of each jump.
describe("touching: a side that was hit and left again", function()
  it("shows for one update", function()
    for _, rate in ipairs({ 60, 30, 144, 20 }) do
      for _, rest in ipairs({ true, false }) do
        local world = physics.newWorld({ gravity = 800, rest = rest })
        world:add("tiles", { x = 0, y = 100, width = 100, height = 16, static = true })
        local ceiling = { x = 0, y = 40, width = 100, height = 16, static = true }
        world:add("tiles", ceiling)
        local man = world:add("men", { x = 10, y = 80, width = 10, height = 20 })
        local hits, shown, before = 0, 0, 0
        function man.onBegin(_, _, side)
          hits = hits + (side == "top" and 1 or 0)
        end
        for _ = 1, 3 do
          world:update(1 / rate)
          man.vy = -400
          play(world, rate, rate, function()
            assert.equal(hits > before and ceiling or false, man.touching.top)
            shown, before = shown + (man.touching.top and 1 or 0), hits
          end)
        end
        assert.same({ 3, 3 }, { hits, shown })
      end
    end
  end)

  it("shows on both that bounce, and the wider of two", function()
    local world = physics.newWorld({ gravity = 0 })
    local narrow = world:add("boxes", { x = 0, y = 0, width = 20, height = 20, vx = 100 })
    narrow.restitution = 1
    local first = world:add("walls", { x = 20.5, y = -20, width = 8, height = 25, static = true })
    local second = world:add("walls", { x = 20.5, y = 5, width = 8, height = 25, static = true })
    world:update(1 / 60)
    assert.equal(second, narrow.touching.right)
    assert.is_nil(first.touching)
    world:update(1 / 60)
    assert.is_false(narrow.touching.right)
    local other = world:add("boxes", { x = narrow.x - 21, y = 0, width = 20, height = 20 })
    world:update(1 / 60)
    assert.equal(other, narrow.touching.left)
    assert.equal(narrow, other.touching.right)
    world:update(1 / 60)
    assert.same({ false, false }, { narrow.touching.left, other.touching.right })
  end)

  it("carries nothing and is no ground: a bounce on a lift takes no ride", function()
    local world = physics.newWorld({ gravity = 800 })
    local lift = { x = 0, y = 100, width = 60, height = 8, kinematic = true, vx = 200 }
    world:add("lifts", lift)
    local ball = world:add("balls", { x = 0, y = 60, width = 8, height = 8, restitution = 1 })
    play(world, 40, 60, function()
      assert.equal(0, ball.x)
    end)
  end)

  it("is not remembered of what has left, or of another that took its place", function()
    local world = physics.newWorld({ gravity = 0 })
    local ball = { x = 0, y = 0, width = 8, height = 8, vx = 600, restitution = 1 }
    world:add("balls", ball)
    local wall = world:add("walls", { x = 9, y = 0, width = 8, height = 8, static = true })
    function ball.onBegin(_, other)
      world:remove(other)
      world:add("walls", { x = 900, y = 0, width = 8, height = 8, static = true })
    end
    world:update(1 / 10) -- four steps
    assert.is_false(ball.touching.right)
    assert.is_nil(wall.touching)
  end)
end)

-- 10 hp a second cost 20 in two seconds at 60 Hz, 59 at 10 Hz and 8 with a timestep at 144 Hz.
describe("onStay: tells how long a step is:", function()
  for _, row in ipairs({ { 60 }, { 10 }, { 144, 60 }, { 60, 144 }, { 20, 90 } }) do
    local rate, fixed = row[1], row[2]
    it(("at %d Hz, timestep %s"):format(rate, fixed and "1 / " .. fixed or "none"), function()
      local timestep = fixed and 1 / fixed
      local world = physics.newWorld({ gravity = 800, timestep = timestep })
      world:add("floors", { x = 0, y = 16, width = 16, height = 16, static = true })
      local box = world:add("boxes", { x = 0, y = 0, width = 16, height = 16 })
      local sums = { box = 0, world = 0 }
      function box.onStay(_, _, _, time)
        sums.box = sums.box + time
      end
      function world.onStay(_, _, _, time)
        sums.world = sums.world + time
      end
      play(world, 2 * rate, rate)
      -- The first step begins the contact; what is saved up is not played yet.
      assert.near(2, sums.box, 2 * (timestep or 1 / 30) + 1e-9)
      assert.equal(sums.box, sums.world)
    end)
  end
end)

-- A controller in front of `update` acted on what an earlier step had shown, or twice in none.
describe("onStep:", function()
  it("is called before every step, with its length", function()
    for _, row in ipairs({
      -- settings, updates a second, steps of three updates and their length
      { {}, 60, 3, 1 / 60 },
      { {}, 15, 6, 1 / 30 },
      { { timestep = 1 / 64 }, 128, 1, 1 / 64 },
      { { timestep = 1 / 64 }, 32, 6, 1 / 64 },
      { {}, 1 / 0, 0 },
    }) do
      local world, count = physics.newWorld(row[1]), 0
      function world.onStep(dt)
        count = count + 1
        assert.near(row[4], dt, 1e-15)
      end
      play(world, 3, row[2])
      assert.equal(row[3], count)
    end
  end)

  it("makes a controller that jumps once, at any phase", function()
    for phase = 0, 19 do
      local world = physics.newWorld({ gravity = 800, timestep = 1 / 60 })
      world:add("floors", { x = 0, y = 100, width = 100, height = 16, static = true })
      local man = world:add("men", { x = 0, y = 76, width = 16, height = 24 })
      local isPressed, jumps = false, 0
      function world.onStep()
        if isPressed and man.touching.bottom then
          man.vy, isPressed, jumps = -400, false, jumps + 1
        end
      end
      world:update((1 + phase / 20) / 60)
      for frame = 1, 288 do
        isPressed = isPressed or frame == 100
        world:update(1 / 144)
        assert.is_true(jumps == (frame < 102 and jumps or 1) and jumps <= 1)
      end
      assert.equal(1, jumps)
      assert.equal(76, man.y)
    end
  end)

  it("drives a lift to its goal by (goal - y) / dt: what it writes counts in the step", function()
    for _, rate in ipairs({ 144, 60, 25 }) do
      local world = physics.newWorld({ timestep = 1 / 60 })
      local lift = world:add("lifts", { x = 0, y = 0, width = 8, height = 8, kinematic = true })
      function world.onStep(step)
        lift.vy = (100 - lift.y) / step
      end
      play(world, 20, rate)
      assert.near(100, lift.y, 1e-9)
    end
  end)

  it("may add and remove, and an error in it leaves the step to the next update", function()
    local world, steps = physics.newWorld({ timestep = 1 / 60, gravity = 0 }), 0
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8, vx = 60 })
    function world.onStep()
      steps = steps + 1
      if steps == 2 then
        error("oops", 0)
      elseif steps == 3 then
        world:add("boxes", { x = 90, y = 0, width = 8, height = 8 })
      elseif steps == 4 then
        world:remove(box)
      end
    end
    world:update(1 / 60)
    local ok, message = pcall(world.update, world, 1 / 60)
    assert.same({ false, "oops" }, { ok, message })
    assert.near(1, box.x, 1e-9)
    for objects = 2, 1, -1 do
      world:update(1 / 60)
      assert.near(2, box.x, 1e-9)
      assert.equal(objects, world.stats.objects)
    end
  end)

  it("cannot update, must be a function, and is the module's, too", function()
    local world = physics.newWorld()
    function world.onStep(dt)
      world:update(dt)
    end
    local ok, message = pcall(world.update, world, 1 / 60)
    assert.is_false(ok)
    local _, text = message:match("^(.*faults_spec%.lua:%d+): (.*)$")
    assert.equal("physics: world:update(dt) cannot be called from inside onStep", text)
    world.onStep = 3
    ok, message = pcall(world.update, world, 1 / 60)
    assert.is_false(ok)
    assert.truthy(message:find("onStep must be a function, got 3", 1, true), message)
    world.onStep = nil
    world:update(1 / 60)
    physics.load()
    local length
    function physics.onStep(dt)
      length = dt
    end
    physics.update(1 / 60)
    assert.equal(1 / 60, length)
    physics.load()
  end)
end)

it("profile: a clock in it tells how long the stages of a step took", function()
  local now, world = 0, physics.newWorld()
  world:add("boxes", { x = 0, y = 0, width = 8, height = 8 })
  world:update(1 / 60)
  assert.is_nil(world.stats.times)
  function world.profile()
    now = now + 2
    return now
  end
  world:update(1 / 60)
  assert.same({ read = 2, separate = 2, move = 2, solve = 2, write = 2 }, world.stats.times)
  world.profile = os.clock
  world:update(1 / 60)
  for name, time in pairs(world.stats.times) do
    assert.is_true(time >= 0 and time < 1, name)
  end
  world.profile = nil
  world:update(1 / 60)
  assert.is_nil(world.stats.times)
end)

-- While the press moved the ball counted as one that may bounce, which nothing squeezes.
it("crushed: a ball is told once, also if the press stops or turns while it holds it", function()
  for _, rate in ipairs({ 30, 60, 144 }) do
    for _, after in ipairs({ 0, 60, -30 }) do
      local world, told = physics.newWorld({ gravity = 800 }), 0
      world:add("floors", { x = -50, y = 100, width = 200, height = 20, static = true })
      local press = { x = -50, y = 20, width = 150, height = 20, kinematic = true, vy = 60 }
      world:add("presses", press)
      world:add("balls", {
        x = 0,
        y = 84,
        radius = 8,
        onCrush = function()
          told = told + 1
        end,
      })
      for step = 1, 2 * rate do
        press.vy = press.y < 68 and step < 1.5 * rate and 60 or step < 1.5 * rate and 0 or after
        world:update(1 / rate)
        press.vy = press.y > 80 and 0 or press.vy
      end
      assert.same({ rate, after, 1 }, { rate, after, told })
    end
  end
end)
