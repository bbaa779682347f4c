--- Proves that friction brakes one, and rows, as worked out by hand, after every step.
--- The scenes are random, at several rates and with irregular steps; the formulas are those of the
--- laws, and share nothing with the library (spec/support/oracle.lua).

local oracle = require("spec.support.oracle")

local class, EXACT, MEETING = oracle.newClass(it), oracle.EXACT, oracle.MEETING
local braked, limited, inAir = oracle.braked, oracle.limited, oracle.inAir
local abs, max, min, sqrt = math.abs, math.max, math.min, math.sqrt

describe("friction: known by hand, a box", function()
  -- Friction

  class("slides to a stop", EXACT, function(s)
    local g, mu, v = s:draw(300, 1200, 0.05, 1.2, -400, 400)
    local own = s.random:between(0.05, 1.5)
    s:floor({ friction = mu * mu / own })
    local b = s:stand({ x = 0, vx = v, friction = own })
    s:play(2, function(t)
      local x, speed = braked(v, mu * g, t)
      s:near("x", x, b.x)
      s:near("vx", speed, b.vx)
      s:near("y", -b.height, b.y)
    end)
  end)

  class("slides to a stop in air", EXACT, function(s)
    local g, mu, v, k = s:draw(300, 1200, 0.05, 0.8, 50, 600, 0.2, 3)
    s:floor()
    local b = s:stand({ x = 0, vx = v, friction = mu, airFriction = k })
    local stop = math.log(1 + v * k / (mu * g)) / k
    s:play(2, function(t)
      local x, speed = inAir(v, -mu * g, k, min(t, stop))
      s:near("x", x, b.x)
      s:near("vx", t < stop and speed or 0, b.vx)
    end)
  end)

  class("starts in air, driven by less than 1 px/s²", EXACT, function(s)
    local mu, k, sign =
      s.random:between(0.05, 0.3), s.random:between(0.2, 1), s.random:pick({ 1, -1 })
    local a = s.random:between(mu + 0.1, 0.95)
    s:set({ gravity = 1 })
    s:floor()
    local b = s:stand({ x = 0, friction = mu, airFriction = k, ax = sign * a })
    s:play(4, function(t)
      local x, speed = inAir(0, a - mu, k, t)
      s:near("x", sign * x, b.x)
      s:near("vx", sign * speed, b.vx)
    end)
  end)

  class("drives against friction up to its limit", EXACT, function(s)
    local g, mu, a, limit = s:draw(300, 1200, 0, 0.8, 50, 800, 60, 300)
    s:floor()
    local b = s:stand({ x = 0, friction = mu, ax = a, maxSpeedX = limit })
    s:play(2, function(t)
      local x, v = 0, 0
      if a > mu * g then
        x, v = limited(0, a - mu * g, limit, t)
      end
      s:near("x", x, b.x)
      s:near("vx", v, b.vx)
    end)
  end)

  class("turns where its engine overcomes its slide", EXACT, function(s)
    local g, mu, v = s:draw(300, 1200, 0.05, 0.5, 50, 300)
    local a = mu * g * s.random:between(0.5, 3)
    s:floor()
    local b = s:stand({ x = 0, friction = mu, vx = v, ax = -a })
    local stop = v / (a + mu * g)
    s:play(2, function(t)
      local x = braked(v, a + mu * g, t)
      local late = max(t - stop, 0)
      s:near("x", x - max(a - mu * g, 0) * late * late / 2, b.x)
    end)
  end)

  class("slides down the wall that it is pressed to", EXACT, function(s)
    local g, mu, a, v = s:draw(300, 1200, 0, 0.9, 100, 800, 0, 200)
    s.world:add("walls", { x = 0, y = -1000, width = 20, height = 20000, static = true })
    local b = s:box({ x = 0, y = 0, friction = mu, ax = a, vy = v })
    b.x = -b.width
    s:play(1.5, function(t)
      local y, speed
      if g > mu * a then
        y, speed = v * t + (g - mu * a) * t * t / 2, v + (g - mu * a) * t
      else
        y, speed = braked(v, mu * a - g, t)
      end
      s:near("y", y, b.y)
      s:near("vy", speed, b.vy)
    end)
  end)

  class("slides on a belt, seen from the belt", EXACT, function(s)
    local g, mu, v, u = s:draw(300, 1200, 0.05, 1, -300, 300, -200, 200)
    s:floor({ surfaceSpeed = u })
    local b = s:stand({ x = 0, friction = mu })
    s:play(0.2)
    local x0 = b.x
    b.vx = v
    s:play(2, function(t)
      local x, speed = braked(v, mu * g, t)
      s:near("x", x0 + u * t + x, b.x)
      s:near("vx", speed, b.vx)
    end)
  end)

  class("slides on a train, seen from the train", EXACT, function(s)
    local g, mu, v, u = s:draw(300, 1200, 0.05, 1, -300, 300, -300, 300)
    local w = s.random:between(-100, 100)
    local train = { x = -4000, y = 0, width = 8000, height = 20, kinematic = true, vx = u, vy = w }
    s.world:add("trains", train)
    local b = s:stand({ x = 0, friction = mu })
    s:play(0.5)
    local x0 = b.x - train.x
    b.vx = v
    s:play(1.5, function(t)
      s:near("x", x0 + braked(v, mu * g, t), b.x - train.x)
      s:near("y", 0, train.y - b.y - b.height)
    end)
  end)

  class("slides to a stop on another, which the floor holds", EXACT, function(s)
    local g, mu, v = s:draw(300, 1200, 0.05, 0.5, -80, 80)
    s:floor({ friction = 40 })
    local low = s:stand({ x = 0, width = 400, friction = 0.5 })
    local high = s:box({ x = 200, y = 0, friction = mu * mu / 0.5, vx = v })
    high.y = low.y - high.height
    s:play(2, function(t)
      s:near("x of the high one", 200 + braked(v, mu * g, t), high.x)
      s:near("x of the low one", 0, low.x)
    end)
  end)

  class("slides on ice with another on it until both are equally fast", EXACT, function(s)
    local g, mu, v = s:draw(300, 1200, 0.1, 0.5, -120, 120)
    s:floor({ friction = 0 })
    local low = s:stand({ x = 0, width = 600, friction = mu })
    local high = s:box({ x = 300, y = 0, friction = mu, vx = v })
    high.y = low.y - high.height
    local slows, drives = mu * g, mu * g * high.mass / low.mass
    local together = abs(v) / (slows + drives)
    local sign = v < 0 and -1 or 1
    s:play(1.5, function(t)
      local slip, late = min(t, together), max(t - together, 0)
      local common = sign * drives * together
      s:near("x of the low one", sign * drives * slip * slip / 2 + common * late, low.x)
      s:near(
        "x of the high one",
        300 + v * slip - sign * slows * slip * slip / 2 + common * late,
        high.x
      )
    end)
  end)

  -- Rows

  -- Boxes side by side on the floor, the first of which has the fields.
  local function newTrain(s, count, friction, fields)
    local row, x, mass, rub = {}, 0, 0, 0
    for n = 1, count do
      local own = n == 1 and fields or {}
      own.x, own.friction = x, friction()
      row[n] = s:stand(own)
      x = x + row[n].width
      mass, rub = mass + row[n].mass, rub + row[n].mass * own.friction
    end
    return row, mass, rub
  end

  class("pushes a row with its engine, by the mass of all and their friction", EXACT, function(s)
    local g, a, limit = s:draw(300, 1200, 300, 2000, 60, 200)
    s:floor()
    local row, mass, rub = newTrain(s, s.random:integer(2, 6), function()
      return s.random:chance(0.3) and 0 or s.random:between(0, 0.3)
    end, { ax = a, maxSpeedX = limit })
    local all = (row[1].mass * a - rub * g) / mass
    local start = {}
    for n, b in ipairs(row) do
      start[n] = b.x
    end
    s:play(1.5, function(t)
      local x = all > 0 and limited(0, all, limit, t) or 0
      for n, b in ipairs(row) do
        if all > 0 then
          s:near("x of " .. n, start[n] + x, b.x)
        else
          s:near("x of " .. n, start[n], b.x)
        end
      end
      return x
    end)
  end)

  -- Where both stop in the same step.
  class("pushes the one before it that friction brakes more", MEETING, function(s)
    local g, v = s:draw(300, 1200, 50, 300)
    s:floor()
    local low = s.random:between(0, 0.3)
    local a = s:stand({ x = 0, vx = v, friction = low })
    local b = s:stand({ x = a.width, vx = v, friction = low + s.random:between(0.01, 0.5) })
    local all = (a.mass * a.friction + b.mass * b.friction) * g / (a.mass + b.mass)
    s:play(2, function(t)
      local x = braked(v, all, t)
      s:near("x of a", x, a.x)
      s:near("x of b", a.width + x, b.x)
    end)
  end)

  class("comes apart from the one behind it that friction brakes more", EXACT, function(s)
    local g, v = s:draw(300, 1200, 50, 300)
    s:floor()
    local low = s.random:between(0.05, 0.3)
    local a = s:stand({ x = 0, vx = v, friction = low + s.random:between(0.01, 0.5) })
    local b = s:stand({ x = a.width, vx = v, friction = low })
    s:play(2, function(t)
      s:near("x of a", braked(v, a.friction * g, t), a.x)
      s:near("x of b", a.width + braked(v, b.friction * g, t), b.x)
    end)
  end)

  class("meets one that lies there, and both slide to a stop", MEETING, function(s)
    local g, r, muA, muB = s:draw(300, 1200, 0.3, 1, 0.05, 0.4, 0.05, 0.4)
    s:floor()
    local gap = s.random:between(5, 60)
    local v = sqrt(2 * muA * g * gap) + s.random:between(40, 300)
    local a =
      s:stand({ x = 0, vx = v, friction = muA, restitution = r, mass = s.random:between(0.2, 1) })
    local b = s:stand({ x = a.width + gap, friction = muB, mass = s.random:between(2, 5) })
    local moment = (v - sqrt(v * v - 2 * muA * g * gap)) / (muA * g)
    local speed = v - muA * g * moment
    local j = (1 + r) * speed * a.mass * b.mass / (a.mass + b.mass)
    local afterA, afterB = speed - j / a.mass, j / b.mass
    s:play(2, function(t)
      if t > moment and (afterA <= 0 or afterA ^ 2 / muA < afterB ^ 2 / muB) then
        s:near("x of a", gap + braked(afterA, muA * g, t - moment), a.x)
        s:near("x of b", a.width + gap + braked(afterB, muB * g, t - moment), b.x)
      end
    end)
  end)
end)
