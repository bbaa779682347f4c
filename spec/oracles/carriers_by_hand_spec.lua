--- Proves that belts and slopes carry and let go as worked out by hand, after every step.
--- The scenes are random, at several rates and with irregular steps; the formulas are those of the
--- laws, and share nothing with the library (spec/support/oracle.lua).

local oracle = require("spec.support.oracle")
local some = oracle.some

local class, EXACT = oracle.newClass(it), oracle.EXACT
local braked = oracle.braked
local abs, max, min, sqrt = math.abs, math.max, math.min, math.sqrt

describe("kinematic and surfaceSpeed: known by hand, a box", function()
  class("lies on a belt that stands upright, under sideways gravity", EXACT, function(s)
    local g, mu, v, u = s:draw(300, 1200, 0.05, 1, -300, 300, -200, 200)
    s:set({ gravity = 0, gravityX = g })
    local belt = { x = 0, y = -9000, width = 20, height = 18000, static = true, surfaceSpeed = u }
    s.world:add("belts", belt)
    local b = s:box({ x = 0, y = 0, friction = mu })
    b.x = -b.width
    s:play(0.2)
    local y0 = b.y
    b.vy = v
    s:play(1, function(t)
      s:near("y", y0 + u * t + braked(v, mu * g, t), b.y)
      s:near("x", -b.width, b.x)
    end)
  end)

  class("slides on the belt that it falls on", 0, function(s)
    local g, h, mu, v, u = s:draw(300, 1200, 5, 60, 0.05, 1, -300, 300, -200, 200)
    s:floor({ surfaceSpeed = u })
    s.tolerance = abs(u) * s:longest() -- it is carried from the next step on
    local b = s:box({ x = 0, y = 0, friction = mu, vx = v })
    b.y = -h - b.height
    local moment = sqrt(2 * h / g)
    -- The belt takes off its speed, as far as both point the same way; the impact rubs, too.
    local own = v * u <= 0 and v or v > 0 and max(v - u, 0) or min(v - u, 0)
    own = own > 0 and max(own - mu * g * moment, 0) or min(own + mu * g * moment, 0)
    s:play(1.5, function(t)
      local late = max(t - moment, 0)
      s:near("x", v * min(t, moment) + u * late + braked(own, mu * g, late), b.x)
    end)
  end)

  class("walks up and down a slope along its edge", EXACT, function(s)
    s:set({ gravity = s.random:between(300, 1200) })
    local width, height = some(s.random, 200, 400, 20, 400)
    local v, isFair = s.random:between(30, 300), s.random:chance(0.5)
    s:floor()
    s.world:add(
      "slopes",
      { x = 0, y = -height, width = width, height = height, static = true, slope = "right" }
    )
    s.world:add("blocks", { x = width, y = -height, width = 4000, height = height, static = true })
    local b = s:stand({ x = 0, constantSpeed = isFair, maxSpeed = nil })
    b.x = -b.width - s.random:between(5, 30)
    local start, steep = b.x + b.width, height / width
    local uphill = isFair and v / sqrt(1 + steep * steep) or v
    b.vx = v
    s:play(2, function(t)
      b.vx = v
      local x = start + v * t
      if x > 0 then
        x = min(uphill * (t + start / v), width)
        local late = t + start / v - width / uphill
        x = late > 0 and width + v * late or x
      end
      s:near("x", x, b.x + b.width)
      s:near("y", -min(max(x, 0), width) * steep, b.y + b.height)
    end)
  end)
end)
