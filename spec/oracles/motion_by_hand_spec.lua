--- Proves that free motion and bounces are as worked out by hand, after every step.
--- The scenes are random, at several rates and with irregular steps; the formulas are those of the
--- laws, and share nothing with the library (spec/support/oracle.lua).

local oracle = require("spec.support.oracle")
local some = oracle.some

local class, EXACT, MEETING = oracle.newClass(it), oracle.EXACT, oracle.MEETING
local braked, limited, inAir, bouncing, playLine =
  oracle.braked, oracle.limited, oracle.inAir, oracle.bouncing, oracle.playLine
local huge, min, sqrt = math.huge, math.min, math.sqrt

describe("vx, vy, ax, ay and gravity: known by hand, a body", function()
  -- Free motion

  class("flies on the parabola of its gravity and engine", EXACT, function(s)
    local gx, gy = s:draw(-500, 500, -900, 900)
    s:set({ gravity = gy, gravityX = gx })
    local own = s.random:chance(0.5) and s.random:between(-900, 900) or nil
    local vx, vy, ax, ay = s.random:between(-400, 400), s.random:between(-400, 400), 0, 0
    if s.random:chance(0.7) then
      ax, ay = s.random:between(-300, 300), s.random:between(-300, 300)
    end
    local b = s:box({ x = 0, y = 0, vx = vx, vy = vy, ax = ax, ay = ay, gravity = own })
    ax, ay = ax + gx, ay + (own or gy)
    s:play(2, function(t)
      s:near("x", vx * t + ax * t * t / 2, b.x)
      s:near("y", vy * t + ay * t * t / 2, b.y)
      s:near("vx", vx + ax * t, b.vx)
      s:near("vy", vy + ay * t, b.vy)
    end)
  end)

  class("falls through air towards its terminal speed", EXACT, function(s)
    local g, ax, k, vx, vy = s:draw(100, 1200, -300, 300, 0.1, 4, -400, 400, -400, 400)
    local b = s:box({ x = 0, y = 0, vx = vx, vy = vy, ax = ax, airFriction = k })
    s:play(2, function(t)
      local x, speedX = inAir(vx, ax, k, t)
      local y, speedY = inAir(vy, g, k, t)
      s:near("x", x, b.x)
      s:near("y", y, b.y)
      s:near("vx", speedX, b.vx)
      s:near("vy", speedY, b.vy)
    end)
  end)

  class("falls up to its limit", EXACT, function(s)
    local g, limit, v = s:draw(300, 1200, 100, 600, -90, 90)
    local b = s:box({ x = 0, y = 0, vy = v })
    b[s.random:pick({ "maxSpeedY", "maxFallSpeed", "maxSpeed" })] = limit
    s:play(2, function(t)
      local y, speed = limited(v, g, limit, t)
      s:near("y", y, b.y)
      s:near("vy", speed, b.vy)
    end)
  end)

  class("falls through air up to its limit", EXACT, function(s)
    local g, k = s:draw(600, 1200, 0.2, 2)
    local limit = g / k * s.random:between(0.2, 0.8)
    local b = s:box({ x = 0, y = 0, airFriction = k, maxSpeedY = limit })
    local moment = -math.log(1 - limit * k / g) / k
    s:play(3, function(t)
      local y, v = inAir(0, g, k, min(t, moment))
      s:near("y", y + (t > moment and limit * (t - moment) or 0), b.y)
      s:near("vy", t > moment and limit or v, b.vy)
    end)
  end)

  -- In the step in which `maxSpeedX` is reached `drag` takes its part of the whole step.
  class("drives up to its limit against its drag", 0, function(s)
    local ax, drag, limit = s:draw(200, 600, 20, 150, 60, 300)
    s:set({ gravity = 0 })
    s.tolerance = drag * s:longest() ^ 2 / 2 -- 0.08 px at 30 Hz, 0.001 at 240
    local side = s.random:pick({ -1, 1 })
    local b = s:box({ x = 0, y = 0, ax = side * ax, drag = drag, maxSpeedX = limit })
    s:play(2, function(t)
      local x, v = limited(0, ax - drag, limit, t)
      s:near("x", side * x, b.x)
      s:near("vx", side * v, b.vx)
    end)
  end)

  class("is stopped by its drag, in its direction", EXACT, function(s)
    local vx, vy, drag = s:draw(-300, 300, -300, 300, 80, 400)
    s:set({ gravity = 0 })
    local b = s:box({ x = 0, y = 0, vx = vx, vy = vy, drag = drag })
    local v = sqrt(vx * vx + vy * vy)
    s:play(2, function(t)
      local way, speed = braked(v, drag, t)
      s:near("x", way * vx / v, b.x)
      s:near("y", way * vy / v, b.y)
      s:near("vx", speed * vx / v, b.vx)
      s:near("vy", speed * vy / v, b.vy)
    end)
  end)

  class("gets an impulse by its mass", EXACT, function(s)
    s:set({ gravity = 0 })
    local b = s:box({ x = 0, y = 0, vx = 10 })
    local jx, jy = some(s.random, -300, 300, -300, 300)
    s.world:impulse(b, jx, jy)
    s:play(1, function(t)
      s:near("x", (10 + jx / b.mass) * t, b.x)
      s:near("y", jy / b.mass * t, b.y)
    end)
  end)

  class("feels the wind and the gravity of the zone that it is in", EXACT, function(s)
    s:set({ gravity = 500 })
    local g, ax, ay = some(s.random, -400, 400, -300, 300, -300, 300)
    local zone = { x = -4000, y = -4000, width = 8000, height = 8000, static = true, sensor = true }
    zone.area = { gravity = g, ax = ax, ay = ay }
    s.world:add("zones", zone)
    local vx, vy = some(s.random, -200, 200, -200, 200)
    local b = s:box({ x = 0, y = 0, vx = vx, vy = vy })
    s:play(2, function(t)
      s:near("x", vx * t + ax * t * t / 2, b.x)
      s:near("y", vy * t + (g + ay) * t * t / 2, b.y)
    end)
  end)

  -- Bounces

  class("bounces on a floor: heights, moments and speeds", MEETING, function(s)
    local g, r, h, v, vx = s:draw(300, 1200, 0.3, 1, 40, 300, -100, 100, -200, 200)
    s:floor()
    local b = s:box({ x = 0, y = 0, vy = -v, vx = vx, restitution = r })
    b.y = -h - b.height
    s:play(2, function(t)
      local height, speed, impact = bouncing(h, v, g, r, t)
      if r * impact > 3 * g * s:longest() then
        s:near("height", height, -b.y - b.height)
        -- In the moment of a bounce the speed jumps.
        if height > 1e-3 then
          s:near("vy", -speed, b.vy)
        end
      end
      s:near("x", vx * t, b.x)
    end)
  end)

  class("bounces about in a room on both axes", MEETING, function(s)
    local r = s.random:chance(0.5) and 1 or s.random:between(0.5, 1)
    s:set({ gravity = 0 })
    local b = s:box({ x = 0, y = 0, restitution = r })
    b.vx, b.vy = s.random:between(100, 500), s.random:between(-500, -100)
    local room, tall = some(s.random, 60, 200, 60, 200)
    local function wall(x, y, width, height)
      s.world:add("walls", { x = x, y = y, width = width, height = height, static = true })
    end
    wall(-10, -10, 10, tall + 20)
    wall(room, -10, 10, tall + 20)
    wall(0, -10, room, 10)
    wall(0, tall, room, 10)
    b.x, b.y =
      (room - b.width) * s.random:between(0.1, 0.9), (tall - b.height) * s.random:between(0.1, 0.9)
    local function line(x, v, width, length)
      return {
        { x = -10, v = 0, mass = huge, width = 10 },
        { x = x, v = v, mass = 1, width = width },
        { x = length, v = 0, mass = huge, width = 10 },
      }
    end
    local across, down = line(b.x, b.vx, b.width, room), line(b.y, b.vy, b.height, tall)
    local before = 0
    s:play(2, function(t)
      playLine(across, r, t - before)
      playLine(down, r, t - before)
      before = t
      s:near("x", across[2].x, b.x)
      s:near("y", down[2].x, b.y)
      s:near("vx", across[2].v, b.vx)
      s:near("vy", down[2].v, b.vy)
    end)
  end)

  class("bounces off a lift as off a floor, seen from there", MEETING, function(s)
    local g, r, h, u = s:draw(300, 900, 0.4, 1, 40, 200, -60, 60)
    s.world:add("lifts", { x = -500, y = 0, width = 1000, height = 20, kinematic = true, vy = -u })
    local b = s:box({ x = 0, y = 0, restitution = r })
    b.y = -h - b.height
    s:play(2, function(t)
      local height, _, impact = bouncing(h, -u, g, r, t)
      if r * impact > 3 * g * s:longest() then
        s:near("height", height, -u * t - b.y - b.height)
      end
    end)
  end)

  class("tells the speed of its landing", MEETING, function(s)
    local g, h, v = s:draw(300, 1200, 10, 300, -200, 200)
    s:floor()
    local told
    local b = s:box({ x = 0, y = 0, vy = v })
    b.y = -h - b.height
    b.onBegin = function(_, _, _, speed)
      told = told or speed
    end
    s:play(3)
    s:near("speed", sqrt(v * v + 2 * g * h), told or huge)
  end)
end)
