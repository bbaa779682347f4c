--- Arcs, damping and limits, the same at every frame rate.

local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local FLOOR = { name = "floor", x = -200, y = 116, width = 800, height = 32, static = true }

--- A box of 16 px with more fields.
local function box(x, y, fields)
  local object = { name = "box", x = x, y = y, width = 16, height = 16 }
  for key, value in pairs(fields) do
    object[key] = value
  end
  return { "boxes", object }
end

describe("vy and gravity: a jump", function()
  --      . .
  --    .     .    100 px
  --  +--+
  -- ----------
  scene.it("(10) with 400 px/s is exactly 100 px high", EVERYWHERE, function(run)
    local body = run:build({ { "tiles", FLOOR }, box(0, 100, {}) }).box
    run:play(0.5)
    body.vy = -400
    local highest = body.y
    for time in run:steps(2) do
      run:at(body, 0, math.min(100, 100 - 400 * time + 400 * time * time))
      highest = math.min(highest, body.y)
    end
    -- 0.5 s are a whole number of steps at every even rate
    if run.rate ~= "irregular" then
      run:near("height", 100 - highest, 100)
    end
    run:still(body)
    run:touches(body, "bottom")
  end)
end)

describe("airFriction, drag, maxSpeed, friction: slowing down", function()
  scene.it("(10) by airFriction 0.5 leaves e^-0.5 of the speed after 1 s", EVERYWHERE, function(run)
    local body = run:build({ gravity = 0, box(0, 0, { vx = 300, airFriction = 0.5 }) }).box
    run:play(1)
    run:near("vx", body.vx, 300 * math.exp(-0.5), 300 * math.exp(-0.5) * 0.001)
    run:near("vx", body.vx, 300 * math.exp(-0.5), 1e-9) -- damping is exact at any rate
    -- the way is the integral of v0 e^(-kt): v0 (1 - e^-k) / k
    run:near("x", body.x, 300 * (1 - math.exp(-0.5)) / 0.5, 0.1)
  end)

  scene.it("(10) by drag 100 from 200 px/s stops after 2 s and 200 px", EVERYWHERE, function(run)
    local body = run:build({ gravity = 0, box(0, 0, { vx = 200, drag = 100 }) }).box
    for time, dt in run:steps(3) do
      if time < 1.98 then
        run:near("vx", body.vx, 200 - 100 * time, 1)
      end
      if time - dt > 2.02 then
        run:same("vx", body.vx, 0)
      end
    end
    run:near("x", body.x, 200, 2)
    run:same("vy", body.vy, 0)
  end)

  -- The floor takes away what the body would fall in a step: that is no motion to slow down.
  scene.it("(10) by drag 100 on a floor, too", EVERYWHERE, function(run)
    local body = run:build({ { "tiles", FLOOR }, box(0, 100, { vx = 200, drag = 100 }) }).box
    run:play(2.5)
    run:near("x", body.x, 200, 0.1)
    run:still(body)
  end)

  scene.it("by maxSpeed is the same on a floor at every rate", EVERYWHERE, function(run)
    local fields = { ax = 400, maxSpeed = 100, drag = 0 }
    local body = run:build({ { "tiles", FLOOR }, box(0, 100, fields) }).box
    run:play(2)
    run:near("vx", body.vx, 100, 1e-9)
    run:near("x", body.x, 12.5 + 175, 0.25)
  end)

  -- Where they come in steps of 1/2400 s. There is no such place in closed form.
  for _, row in ipairs({
    { "drag", { vx = 200, vy = -300, drag = 300 }, 2, 133.4515, 724.3259 },
    { "maxSpeed", { vx = 100, maxSpeed = 300 }, 1, 66.7031, 240.7754 },
  }) do
    local name, fields, seconds, x, y = row[1], row[2], row[3], row[4], row[5]
    scene.it(
      "by " .. name .. " on a curve is nearly the same at every rate",
      EVERYWHERE,
      function(run)
        local body = run:build({ box(0, 0, fields) }).box
        run:play(seconds)
        run:near("x", body.x, x, 0.12)
        run:near("y", body.y, y, 0.12)
      end
    )
  end

  for _, fields in ipairs({
    { vx = 5, vy = -14, drag = 400 },
    { vx = 5, maxSpeed = 5 },
    { vx = 21, vy = -5, ax = -1415, gravity = 0, drag = 683 },
  }) do
    local name = fields.drag and "drag " .. fields.drag or "maxSpeed " .. fields.maxSpeed
    scene.it("by " .. name .. " reverses no velocity", EVERYWHERE, function(run)
      local body = run:build({ box(0, 0, fields) }).box
      for _ in run:steps(0.5) do
        local isPulled = fields.ax ~= nil
        run:check(isPulled or body.vx >= 0, "vx is %g", body.vx)
        run:check(not isPulled or body.vy <= 0, "vy is %g", body.vy)
      end
    end)
  end

  -- v' = 250 - 240 - 3 v: to 10 / 3 px/s
  for _, start in ipairs({ 0, 300 }) do
    scene.it("by drag and airFriction, pulled, from " .. start .. " px/s", EVERYWHERE, function(run)
      local fields = { vy = start, airFriction = 3, drag = 240 }
      local body = run:build({ gravity = 250, box(0, 0, fields) }).box
      for time in run:steps(2) do
        local decay, last = math.exp(-3 * time), 10 / 3
        run:near("vy", body.vy, last + (start - last) * decay, 1e-9)
        run:near("y", body.y, last * time + (start - last) * (1 - decay) / 3, 1e-9)
      end
      run:same("vx", body.vx, 0)
    end)
  end

  --  +--+ 200 px/s
  --  +--+ ->
  -- ==============
  scene.it("(10) by friction 0.5 on a floor stops 200 px/s after 50 px", EVERYWHERE, function(run)
    local body = run:build({ { "tiles", FLOOR }, box(0, 100, { vx = 200, friction = 0.5 }) }).box
    for time in run:steps(2) do
      run:near("y", body.y, 100)
      if time < 0.45 then
        run:near("vx", body.vx, 200 - 400 * time, 1e-6)
      end
    end
    run:near("x", body.x, 50, 1)
    run:still(body)
  end)
end)

describe("maxSpeedY: a speed limit", function()
  scene.it("(10) maxSpeedY 960 holds", EVERYWHERE, function(run)
    local body = run:build({ box(0, 0, { vx = 50, maxSpeedY = 960 }) }).box
    for time in run:steps(3) do
      run:check(math.abs(body.vy) <= 960, "vy is %.17g", body.vy)
      run:near("vy", body.vy, math.min(960, 800 * time))
      run:same("vx", body.vx, 50)
    end
    run:same("vy", body.vy, 960)
  end)
end)

describe("vx and touching: a slide", function()
  --   +--+       |
  --   +--+       +
  --      \       |
  --       v      +  tiles
  local function slide()
    local description = { gravity = 0, box(0, 0, { vx = 100, vy = 100 }) }
    return scene.tiles(description, 40, 100, -64, 16, 16, 0, 16)
  end

  scene.it(
    "(10) along a wall of tiles keeps its speed, pushed every step",
    EVERYWHERE,
    function(run)
      local body = run:build(slide()).box
      for time in
        run:steps(2, function()
          body.vx, body.vy = 100, 100
        end)
      do
        run:at(body, math.min(84, 100 * time), 100 * time)
        run:same("vy", body.vy, 100)
      end
      run:at(body, 84, 200)
      run:touches(body, "right")
    end
  )

  --   +--+           |
  --   +--+           |
  --       \          |
  --        v         |
  --   ---------------+
  scene.it(
    "(10) into an inner corner touches both sides in the same step",
    EVERYWHERE,
    function(run)
      local named = run:build({
        gravity = 0,
        box(0, 0, { vx = 100, vy = 100 }),
        { "walls", { name = "wall", x = 100, y = -100, width = 16, height = 216, static = true } },
        { "walls", { name = "floor", x = -100, y = 100, width = 200, height = 16, static = true } },
      })
      local body, log = named.box, run:listen(named.box)
      for _ in
        run:steps(1, function()
          body.vx, body.vy = 100, 100
        end)
      do
        local touching = body.touching
        run:same("bottom flagged", touching.bottom ~= false, touching.right ~= false)
      end
      run:at(body, 84, 84)
      run:flush(body, named.wall, "right")
      run:flush(body, named.floor, "bottom")
      run:still(body)
      run:touches(body, "right", "bottom")
      run:same("begins", log.begins, 2)
      run:same("ends", log.ends, 0)
    end
  )
end)
