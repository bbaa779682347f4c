--- Rest is exact, a bounce loses what it should and no more.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local EVERYWHERE = variants.EVERYWHERE

--- A box at a height over a floor with its top at y = 116.
local function overFloor(y, restitution)
  local floor = { name = "floor", x = -200, y = 116, width = 800, height = 32, static = true }
  local box = { name = "box", x = 0, y = y, width = 16, height = 16, restitution = restitution }
  return { gravity = 800, { "tiles", floor }, { "boxes", box } }
end

--- Where a flying box has its peak, from its height and speed.
local function peakOf(view)
  return view.y - view.vy * view.vy / (2 * 800)
end

describe("restitution: a resting box", function()
  --   +--+
  --   |  |
  --   +--+
  --  ------
  scene.it("(9a) stays where it is for 10 s: one begin, no end", TURNED, function(run)
    local named = run:build(overFloor(100))
    local log, world = run:listen(named.box), run:listenToWorld()
    for _ in run:steps(10) do
      run:at(named.box, 0, 100)
      run:flush(named.box, named.floor, "bottom")
      run:still(named.box)
      run:touches(named.box, "bottom")
    end
    run:same("begins", log.begins, 1)
    run:same("begins at the bottom", log.sides.bottom, 1)
    run:same("stays", log.stays, 599)
    run:same("ends", log.ends, 0)
    run:same("begins of the world", world.begins, 1)
  end)

  it("(9a) stays where it is at any frame rate, bouncy or not", function()
    for _, restitution in ipairs({ 0, 0.5, 1 }) do
      scene.each(EVERYWHERE, function(run)
        local named = run:build(overFloor(100, restitution))
        local log = run:listen(named.box)
        for _ in run:steps(2) do
          run:flush(named.box, named.floor, "bottom")
          run:still(named.box)
        end
        run:at(named.box, 0, 100)
        run:same("begins", log.begins, 1)
        run:same("ends", log.ends, 0)
      end)
    end
  end)
end)

describe("restitution: a falling box", function()
  --  +--+ y = 0
  --  +--+
  --   |      peaks at 75, 93.75, 98.4375
  --   v  .
  --  ------- y = 116
  scene.it("(9b) with restitution 0.5 comes up to a quarter each time", TURNED, function(run)
    local named = run:build(overFloor(0, 0.5))
    local log = run:listen(named.box)
    local peaks, before, rising = {}, 0, false
    for _ in run:steps(2) do
      if rising and named.box.y >= before then
        peaks[#peaks + 1] = before
      end
      rising = named.box.y < before
      before = named.box.y
    end
    for i, peak in ipairs({ 75, 93.75, 98.4375 }) do
      run:check(peaks[i], "there should be a peak number %d", i)
      run:near("peak " .. i, peaks[i], peak, 0.1)
    end
    local begins, ends = log.begins, log.ends
    run:same("contacts left", begins - ends, 1)
    for _ in run:steps(3) do
      run:at(named.box, 0, 100)
      run:flush(named.box, named.floor, "bottom")
      run:still(named.box)
    end
    run:same("begins after 2 s", log.begins, begins)
    run:same("ends after 2 s", log.ends, ends)
  end)

  scene.it("(9c) with restitution 1 comes up to the same height for 20 s", EVERYWHERE, function(run)
    local named = run:build(overFloor(0, 1))
    local log = run:listen(named.box)
    for _ in run:steps(20) do
      run:near("peak", peakOf(named.box), 0, 0.01)
      run:check(named.box.y <= 100 + 1e-6, "is in the floor, at %.9g", named.box.y)
    end
    -- it meets the floor every second, first after 0.5 s
    run:same("begins", log.begins, 20)
    run:same("ends", log.ends, 20)
  end)

  it("(9e) comes to rest where it should although dt is 0.5 now and then", function()
    for _, restitution in ipairs({ 0, 0.5 }) do
      scene.each(TURNED, function(run)
        local named = run:build(overFloor(0, restitution))
        for i = 1, 180 do
          run:step(i % 20 == 7 and 0.5 or 1 / 60)
        end
        run:at(named.box, 0, 100)
        run:flush(named.box, named.floor, "bottom")
        run:still(named.box)
        run:step(0.5)
        run:flush(named.box, named.floor, "bottom")
        run:still(named.box)
      end)
    end
  end)
end)

describe("restitution: a bounce", function()
  --   +--+ 20 px/s  |
  --   +--+ ->       |
  for _, speed in ipairs({ 20, 1, 0.01, 3000 }) do
    local title = ("(9d) without gravity comes back as fast as it went, %g px/s"):format(speed)
    scene.it(title, EVERYWHERE, function(run)
      local gap = speed * 0.7 -- the wall is met after 0.7 s
      local box = { name = "box", x = 0, y = 40, width = 16, height = 16, vx = speed }
      box.restitution = 1
      local wall = { name = "wall", x = 16 + gap, y = 0, width = 16, height = 100, static = true }
      run:build({ gravity = 0, { "boxes", box }, { "walls", wall } })
      local log = run:listen(run.named.box)
      run:play(2)
      run:near("vx", run.named.box.vx, -speed)
      run:same("vy", run.named.box.vy, 0)
      run:at(run.named.box, gap - speed * 1.3, 40)
      run:same("begins", log.begins, 1)
      run:same("ends", log.ends, 1)
      run:near("speed", log.speed, speed)
    end)
  end

  -- Pulled towards each other by 800 px/s², the two meet in the middle of the step: that adds
  -- 1600 dt px/s in two steps.
  for _, row in ipairs({ { 0.999, "does not happen below" }, { 1.001, "happens above" } }) do
    local share, what = row[1], row[2]
    local levels = { rate = { 30, 60, 144 }, turn = variants.TURNS }

    --- A speed and a gap that make the two meet at `share` of the limit.
    local function approach(dt)
      local speed = share * 1600 * dt - 400 * dt
      return speed, speed * dt / 2 + 100 * dt * dt
    end

    local function check(run, closing, dt)
      if share < 1 then
        run:same("speed of the one towards the other", closing, 0)
      else
        run:near("speed of the one towards the other", closing, 400 * dt - share * 1600 * dt)
      end
    end

    scene.it(what .. " the speed that gravity adds in two steps", levels, function(run)
      local dt = 1 / run.rate
      local speed, gap = approach(dt)
      local description = overFloor(100 - gap, 1)
      description[2][2].vy = speed
      local box = run:build(description).box
      run:step(dt)
      check(run, box.vy, dt)
    end)

    --   +--+ 500   300 +--+
    --   +--+ ->     <- +--+
    scene.it(what .. " the speed that both accelerations add in two steps", levels, function(run)
      local dt = 1 / run.rate
      local speed, gap = approach(dt)
      local one = { name = "one", x = 0, y = 0, width = 16, height = 16, vx = speed, ax = 500 }
      local other = { name = "other", x = 16 + gap, y = 0, width = 16, height = 16, ax = -300 }
      one.restitution = 1
      local named = run:build({ gravity = 0, { "boxes", one }, { "boxes", other } })
      run:step(dt)
      check(run, named.one.vx - named.other.vx, dt)
    end)
  end

  scene.it("of two that fall together happens however slowly they meet", TURNED, function(run)
    local one = { name = "one", x = 0, y = 0, width = 16, height = 16, vy = 0.01 }
    local other = { name = "other", x = 0, y = 16.0001, width = 16, height = 16 }
    one.restitution = 1
    local named = run:build({ gravity = 800, { "boxes", one }, { "boxes", other } })
    run:step(1 / 60)
    run:near("vy of the upper", named.one.vy - 800 / 60, 0)
    run:near("vy of the lower", named.other.vy - 800 / 60, 0.01)
  end)

  scene.it("between a floor and a ceiling keeps its energy", EVERYWHERE, function(run)
    local description = overFloor(50, 1)
    local ceiling = { x = -200, y = 8, width = 800, height = 16, static = true }
    description[3] = { "tiles", ceiling }
    description[2][2].vy = -500
    local box = run:build(description).box
    local energy = 500 * 500 / 2 - 800 * 50
    for _ in run:steps(5) do
      run:near("energy", box.vy * box.vy / 2 - 800 * box.y, energy, 1e-3)
      run:check(box.y >= 24 - 1e-6 and box.y <= 100 + 1e-6, "is outside, at %.9g", box.y)
    end
  end)

  -- README, Limits: after 13 hits in a step a body bounces no more.
  for _, row in ipairs({ { 1 / 30, 400, 0 }, { 1 / 30, 200, 200 }, { 1 / 240, 400, 400 } }) do
    local name = "where there is 1 px of room, %d px/s in steps of 1/%d s"
    scene.it(name:format(row[2], 1 / row[1]), TURNED, function(run)
      local ball = { name = "ball", x = 20, y = 10.5, width = 10, height = 10, restitution = 1 }
      ball.vy = row[2]
      local named = run:build({
        gravity = 0,
        maxStep = row[1],
        { "tiles", { x = 0, y = 0, width = 800, height = 10, static = true } },
        { "tiles", { x = 0, y = 21, width = 800, height = 10, static = true } },
        { "balls", ball },
      })
      for _ = 1, 30 do
        run:step(1 / 30)
      end
      run:near("speed", math.abs(named.ball.vy), row[3], 1e-9)
    end)
  end
end)
