--- Proves that impacts of two to five share momentum as worked out by hand, at their moment.
--- The scenes are random, at several rates and with irregular steps; the formulas are those of the
--- laws, and share nothing with the library (spec/support/oracle.lua).

local oracle = require("spec.support.oracle")
local some = oracle.some

local class, MEETING = oracle.newClass(it), oracle.MEETING
local timeTo, playLine = oracle.timeTo, oracle.playLine
local abs, huge, max, sqrt = math.abs, math.huge, math.max, math.sqrt

describe("restitution: known by hand,", function()
  -- Impacts

  -- Boxes in a row, `gaps` apart at most, without gravity.
  local function newRow(s, count, r, speed, gap)
    local bodies, line, x = {}, {}, 0
    for n = 1, count do
      local b = s:box({ x = x, y = 0, vx = s.random:between(-speed, speed), restitution = r })
      bodies[n], line[n] = b, { x = x, v = b.vx, mass = b.mass, width = b.width }
      x = x + b.width + s.random:between(0, gap)
    end
    return bodies, line
  end

  local function compareRow(s, bodies, line, r, seconds)
    local before = 0
    s:play(seconds, function(t)
      playLine(line, r, t - before)
      before = t
      for n, b in ipairs(bodies) do
        s:near("x of " .. n, line[n].x, b.x)
        s:near("vx of " .. n, line[n].v, b.vx)
      end
    end)
    return s
  end

  for _, row in ipairs({
    { "two that bounce", 2, true },
    { "two that do not bounce", 2, false },
    { "three that bounce", 3, true },
    { "three that do not bounce", 3, false },
    { "five that do not bounce", 5, false },
  }) do
    class("impacts of " .. row[1], MEETING, function(s)
      s:set({ gravity = 0 })
      local r = row[3] and (s.random:chance(0.3) and 1 or s.random:between(0.3, 1)) or 0
      local bodies, line = newRow(s, row[2], r, 300, 60)
      compareRow(s, bodies, line, r, 1)
    end)
  end

  class("impacts of a box with a wall that moves", MEETING, function(s)
    s:set({ gravity = 0 })
    local r = s.random:between(0.2, 1)
    local u = s.random:between(-100, 200)
    s.world:add("wall", { x = -500, y = -100, width = 500, height = 300, kinematic = true, vx = u })
    local b =
      s:box({ x = s.random:between(5, 60), y = 0, vx = s.random:between(-400, 0), restitution = r })
    local line = { { x = -500, v = u, mass = huge, width = 500 } }
    line[2] = { x = b.x, v = b.vx, mass = b.mass, width = b.width }
    local before = 0
    s:play(1, function(t)
      playLine(line, r, t - before)
      before = t
      s:near("x", line[2].x, b.x)
      s:near("vx", line[2].v, b.vx)
    end)
  end)

  class("impacts of two that fall at different gravity", MEETING, function(s)
    s:set({ gravity = 0 })
    local r = s.random:between(0.3, 1)
    local gA, gB = some(s.random, -300, 300, -300, 300)
    local a = s:box({ x = 0, y = 0, vy = s.random:between(0, 200), gravity = gA, restitution = r })
    local gap = s.random:between(5, 80)
    local b = s:box({ x = 3, y = a.height + gap, vy = s.random:between(-200, 0), gravity = gB })
    local vA, vB = a.vy, b.vy
    local moment = timeTo(gap, vA - vB, gA - gB) or huge
    local closing = sqrt(max((vA - vB) ^ 2 + 2 * (gA - gB) * gap, 0))
    -- Until they would meet again.
    local again = gA > gB and moment + 2 * r * closing / (gA - gB) or huge
    local change = (1 + r) * closing / (a.mass + b.mass)
    local isSlow = r * closing < 3 * abs(gA - gB) * s:longest()
    local y = a.height + gap
    s:play(1, function(t)
      if isSlow or t >= again then
        return
      end
      local late = max(t - moment, 0)
      s:near("y of a", vA * t + gA * t * t / 2 - b.mass * change * late, a.y)
      s:near("y of b", y + vB * t + gB * t * t / 2 + a.mass * change * late, b.y)
    end)
  end)

  -- The normal is that of a moment up to 2e-9 of a step later.
  class("impacts of two balls, along the line of their centres", 1e-5, function(s)
    local r, ra, rb = some(s.random, 0, 1, 6, 20, 6, 20)
    local v, offset = s.random:between(100, 400), (ra + rb) * s.random:between(-0.9, 0.9)
    local function ball(x, y, radius, vx)
      local its = { x = x - radius, y = y - radius, radius = radius, vx = vx, restitution = r }
      its.width, its.height = 2 * radius, 2 * radius
      return s:box(its)
    end
    local a, distance = ball(0, 0, ra, v), ra + rb + s.random:between(5, 60)
    local b = ball(distance, offset, rb)
    local nx, ny = sqrt((ra + rb) ^ 2 - offset * offset) / (ra + rb), offset / (ra + rb)
    local moment = (distance - nx * (ra + rb)) / v
    local j = (1 + r) * v * nx * a.mass * b.mass / (a.mass + b.mass)
    s:play(1, function(t)
      local late = max(t - moment, 0)
      s:near("x of a", v * t - j / a.mass * nx * late, a.x + ra)
      s:near("y of a", -j / a.mass * ny * late, a.y + ra)
      s:near("x of b", distance + j / b.mass * nx * late, b.x + rb)
      s:near("y of b", offset + j / b.mass * ny * late, b.y + rb)
    end)
  end)

  class("bounces of a box or ball off a slope, along the normal", MEETING, function(s)
    s:set({ gravity = 0 })
    local width, height, radius = some(s.random, 150, 300, 60, 300, 5, 15)
    s.world:add(
      "slopes",
      { x = 0, y = 0, width = width, height = height, static = true, slope = "right" }
    )
    -- From (0, height) to (width, 0); the normal points up and to the left.
    local length = sqrt(width * width + height * height)
    local nx, ny = -height / length, -width / length
    local r, v = some(s.random, 0, 1, 100, 300)
    local x, y = width * s.random:between(0.4, 0.6), -60
    local b = s:box({ x = x - radius, y = y - radius, width = 2 * radius, height = 2 * radius })
    b.vy, b.restitution, b.radius = v, r, s.random:chance(0.5) and radius or nil
    -- A box meets it with its corner, a circle with its rim.
    local away = x * nx + (y - height) * ny - radius
    if not b.radius then
      away = (x + radius) * nx + (y + radius - height) * ny
    end
    local moment = away / -(v * ny)
    local change = -(1 + r) * v * ny
    s:play(0.6, function(t)
      local late = max(t - moment, 0)
      s:near("x", x + change * nx * late, b.x + radius)
      s:near("y", y + v * t + change * ny * late, b.y + radius)
    end)
  end)
end)
