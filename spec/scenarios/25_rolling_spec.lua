--- Circles on slopes: they touch the edge with their rim, along its true normal, and roll off.
---
--- `along` is the unit vector down the slope, `normal` that out of it:
---
---     |\  normal
---     | \/
---     |  \  along
---     +---+

local effort = require("spec.support.effort")
local newRandom = require("spec.support.random").new
local physics = require("physics")
local shapes = require("physics.space.shapes")
local small = require("spec.support.small")

local long = effort.isFirst and it or pending
local RATES, GRAVITY, R = effort.isWhole and { 30, 60, 144 } or { 30, 144 }, 800, 8
-- Share of a length or a speed that may be rounding: what is put flush is so to 1e-6 px.
local SHARE = 1e-6

local function static(x, y, width, height, slope, changes)
  local object = small.tile(x, y, width, height, changes)
  object.slope = slope
  return object
end

-- A ball that touches the edge of a slope that is high at its left, at x.
local function ballOn(slope, x, changes)
  local length = math.sqrt(slope.width * slope.width + slope.height * slope.height)
  local alongX, alongY = slope.width / length, slope.height / length
  local y = slope.y + (x - slope.x) * slope.height / slope.width
  local ball = { x = x + alongY * R - R, y = y - alongX * R - R, radius = R }
  return small.set(ball, changes), alongX, alongY
end

local function gapOf(ball, other)
  local shape, its = shapes.CIRCLE, shapes.of(other)
  local x, y, w, h = ball.x, ball.y, 2 * ball.radius, 2 * ball.radius
  return (shapes.gap(shape, x, y, w, h, its, other.x, other.y, other.width, other.height))
end

-- The distance to the nearest of a group; below 0: how deep the ball is in it.
local function gapTo(ball, group)
  local least = math.huge
  for _, other in ipairs(group) do
    least = math.min(least, gapOf(ball, other))
  end
  return least
end

local function each(seconds, rate, world, check)
  for n = 1, seconds * rate + 0.5 do
    world:update(1 / rate)
    check(n / rate)
  end
end

local function newWorld(...)
  local world = physics.newWorld({ gravity = GRAVITY })
  for _, object in ipairs({ ... }) do
    world:add("ground", object)
  end
  return world, world.objects.ground
end

local function near(expected, value, tolerance)
  assert.near(expected, value, tolerance or SHARE * math.max(1, math.abs(expected)))
end

describe("slope and radius: a ball on a slope", function()
  small.rows("rolls down {1} degrees by g sin", { 10, 30, 45, 70 }, function(degrees)
    for n = 1, 6 do
      local rate, rises = RATES[(n - 1) % #RATES + 1], math.tan(math.rad(degrees))
      local slope = static(0, 0, 2000, 2000 * rises, "left")
      local world = newWorld(slope)
      local ball, alongX, alongY = ballOn(slope, 300, { friction = n > 3 and 1 or 0 })
      world:add("balls", ball)
      local x, y = ball.x, ball.y
      each(1, rate, world, function(time)
        local way, speed = GRAVITY * alongY * time * time / 2, GRAVITY * alongY * time
        near(x + alongX * way, ball.x)
        near(y + alongY * way, ball.y)
        near(alongX * speed, ball.vx)
        near(alongY * speed, ball.vy)
        near(0, gapOf(ball, slope))
      end)
    end
  end)

  --  |\_
  --  |  \_  tiles
  --  |____\______
  small.rows("passes the seams of tiles and the foot without a hop, {1} Hz", RATES, function(rate)
    local world, ground = newWorld(), {}
    world.objects.ground = ground
    for n = 0, 9 do
      ground[#ground + 1] = static(40 * n, 20 * n, 40, 20, "left")
      ground[#ground + 1] = static(40 * n, 20 * n + 20, 40, 400 - 20 * n)
      ground[#ground + 1] = static(400 + 40 * n, 200, 40, 220)
    end
    local ball = world:add("balls", (ballOn(ground[1], 20)))
    local y = ball.y
    each(2, rate, world, function()
      near(0, gapTo(ball, ground))
    end)
    near(200 - 2 * R, ball.y)
    -- The floor takes what goes into it: the part along x is left.
    near(math.sqrt(2 * GRAVITY * (ball.y - y)) * 2 / math.sqrt(5), ball.vx)
    assert.equal(0, ball.vy)
  end)

  small.rows("rolls over the crest as far as it flies, {1} Hz", RATES, function(rate)
    local world, ground = newWorld(static(0, 0, 100, 40), static(100, 0, 800, 400, "left"))
    local ball = world:add("balls", { x = 20, y = -2 * R, radius = R, vx = 40 })
    local hop = 0
    each(2.5, rate, world, function()
      hop = math.max(hop, gapTo(ball, ground))
      assert.is_true(gapTo(ball, ground) >= -1e-6)
    end)
    assert.is_true(hop < 0.5, hop) -- (40 px/s)² / g is 2 px along x
    near(0, gapTo(ball, ground))
  end)

  small.rows("rests in a valley: {1}", RATES, function(rate)
    local world, ground =
      newWorld(static(0, 0, 200, 100, "left"), static(200, 0, 200, 100, "right"))
    local ball = world:add("balls", { x = 60, y = 0, radius = R })
    each(12, rate, world, function()
      assert.is_true(gapTo(ball, ground) >= -1e-6)
    end)
    assert.same({ 0, 0 }, { ball.vx, ball.vy })
    near(192, ball.x)
    near(0, gapOf(ball, ground[1]))
    near(0, gapOf(ball, ground[2]))
  end)

  small.rows("passes a one-way, rolls on it, drops through, {1} Hz", RATES, function(rate)
    local slope = static(0, 0, 800, 400, "left", { oneWay = "top" })
    local world = newWorld(slope)
    local ball = world:add("balls", { x = 150, y = 160, radius = R, vy = -500 })
    each(1 / 3, rate, world, function(time)
      near(160 - 500 * time + GRAVITY * time * time / 2, ball.y)
    end)
    each(1, rate, world, function() end)
    near(0, gapOf(ball, slope))
    assert.equal(slope, ball.touching.bottom)
    assert.is_true(ball.vx > 0)
    assert.is_true(world:dropThrough(ball))
    each(0.5, rate, world, function() end)
    assert.is_true(ball.y > slope.y + ball.x / 2 + R)
  end)

  small.rows("that moves carries it, or pushes it, {1} Hz", RATES, function(rate)
    for _, way in ipairs({ { 0, -50 }, { 0, 50 }, { 50, 0 }, { -50, 0 }, { -30, 30 } }) do
      for _, carry in ipairs({ true, false }) do
        local slope = static(0, 0, 800, 400, "left", { carry = carry, kinematic = true })
        slope.static = nil
        local world = newWorld(slope)
        local ball = ballOn(slope, 200)
        if not carry then
          slope.vx, slope.vy, ball.vx, ball.vy = way[1], way[2], way[1], way[2]
        end
        world:add("balls", ball)
        local x, y = ball.x, ball.y
        local function at(time)
          local rolled = GRAVITY * time * time / 2
          near(x + slope.x + rolled * 2 / 5, ball.x, 1e-5)
          near(y + slope.y + rolled / 5, ball.y, 1e-5)
          near(0, gapOf(ball, slope))
        end
        each(0.5, rate, world, at)
        slope.vx, slope.vy = way[1], way[2]
        each(0.5, rate, world, function(time)
          at(0.5 + time)
        end)
      end
    end
  end)
end)

describe("slope and radius: a marble run", function()
  -- Three ramps, pins, a funnel. One ball after another is put to the top again.
  local function newRun(seed)
    local world, ground = newWorld(
      static(0, 100, 400, 80, "left"),
      static(80, 240, 400, 100, "right"),
      static(0, 400, 380, 60, "left"),
      static(360, 580, 120, 60, "right"),
      static(0, 580, 120, 60, "left")
    )
    for n = 1, 5 do
      local pin = { x = 60 + n * 60, y = 520, radius = 8, static = true, restitution = 0.6 }
      world:add("ground", pin)
    end
    world:setBounds(0, 0, 480, 640)
    local random = newRandom(seed)
    for n = 0, 59 do
      local x, y = 130 + n % 10 * 20 + random:between(-3, 3), 624 - math.floor(n / 10) * 14
      world:add("balls", { x = x, y = y, radius = 6, restitution = 0.2 })
    end
    return world, ground, world.objects.balls
  end

  local function deepest(ground, balls)
    local depth = 0
    for n, ball in ipairs(balls) do
      depth = math.max(depth, -gapTo(ball, ground))
      for m = n + 1, #balls do
        depth = math.max(depth, -gapOf(ball, balls[m]))
      end
    end
    return depth
  end

  -- The ball that is the furthest down.
  local function lowest(balls)
    local low = balls[1]
    for _, ball in ipairs(balls) do
      low = ball.y > low.y and ball or low
    end
    return low
  end

  for _, rate in ipairs(effort.isWhole and { 60, 144 } or { 60 }) do
    long(("of 60 balls runs at %d Hz, with none lifted"):format(rate), function()
      local world, ground, balls = newRun(rate)
      for _ = 1, effort.share(rate == 60 and 60 or 50) do
        local ball = lowest(balls)
        ball.x, ball.y, ball.vx, ball.vy = 10, 60, 0, 0
        each(0.4, rate, world, function() end)
        local depth = deepest(ground, balls)
        assert.is_true(depth <= 1, depth .. " px")
        local _, waiting = world:queryRect(0, 0, 480, 400, "balls")
        assert.is_true(waiting <= 16, waiting .. " balls do not roll, or are lifted")
      end
    end)
  end
end)

-- It ends each step on the tangent, a little beside the stone.
small.rows("onBegin: a ball that rolls over a round stone touches it all the way: {1}", {
  { "fast", 0 },
  { "slowly", 5 },
}, function(_, airFriction)
  local world, count = physics.newWorld({ gravity = GRAVITY }), 0
  world:add("stones", { x = 100, y = 200, radius = 100, static = true })
  local ball = { radius = 10, airFriction = airFriction }
  ball.x, ball.y = 190 + 110 * 0.342, 290 - 110 * math.sqrt(1 - 0.342 * 0.342)
  function ball.onBegin()
    count = count + 1
  end
  ball.onEnd = ball.onBegin
  world:add("balls", ball)
  small.play(world, 0.5)
  assert.is_true(ball.x > 235)
  assert.equal(1, count)
end)
