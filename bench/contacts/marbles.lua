--- A marble on a ramp, struck by one to three others at once.

local overlap = require("spec.support.overlap")
local small = require("spec.support.small")

-- Degrees from the ramp's normal at which striker `n` of `count` comes.
local function angleOf(random, n, count)
  if count == 1 then
    return random:between(-70, 70)
  elseif count == 2 then
    return n == 1 and random:between(-80, -45) or random:between(45, 80)
  end
  return 65 * n - 130
end

-- Momentum along the ramp, and mass.
local function momentumOf(balls, ax, ay)
  local sum, mass = 0, 0
  for _, ball in ipairs(balls) do
    sum = sum + ball.mass * (ax * ball.vx + ay * ball.vy)
    mass = mass + ball.mass
  end
  return sum, mass
end

-- Adds a ball that meets the first one after `time` s, if it starts above the ramp.
local function addStriker(scene, first, time, angle, radius, ax, ay)
  local random, g = scene.random, scene.world.gravity
  local start = ax * first.vx + ay * first.vy
  local along = start * time + g * ay * time * time / 2
  local cos, sin = math.cos(angle), math.sin(angle)
  local nx, ny = ay * cos + ax * sin, -ax * cos + ay * sin
  local far = first.radius + radius
  local x = first.x + first.radius + ax * along + nx * far
  local y = first.y + first.radius + ay * along + ny * far
  local speed = random:between(100, 600)
  local vx, vy = -nx * speed + ax * start / 2, -ny * speed + ay * start / 2
  x, y = x - vx * time, y - vy * time - g * time * time / 2
  local striker = small.ball(x, y, radius, { vx = vx, vy = vy })
  striker.mass = random:pick({ 0.1, 0.5, 1, 1, 2, 10 })
  striker.restitution = random:pick({ 0, 0, 0.5 })
  if x * ay - y * ax > radius then
    return scene:add("balls", striker)
  end
end

-- Adds the ramp, the marble and those that strike it, and returns the balls.
local function build(scene, ax, ay)
  local random, count = scene.random, scene.seed % 3 + 1
  local rise = ay / ax
  scene:add("ramps", small.tile(-4000, -4000 * rise, 8000, 8000 * rise, { slope = "left" }))
  local radius = random:between(5, 14)
  local speed = random:between(100, 500) * (random:chance(0.2) and -1 or 1)
  local first = small.ball(200 + ay * radius, 200 * rise - ax * radius, radius)
  first.vx, first.vy, first.mass = ax * speed, ay * speed, random:pick({ 1, 1, 5 })
  local balls = { scene:add("balls", first) }
  local time = random:between(0.05, 0.2)
  random:unit()
  for n = 1, count do
    local other = random:between(5, 14)
    other = count == 3 and 10 or other
    local angle = math.rad(angleOf(random, n, count))
    balls[#balls + 1] = addStriker(scene, first, time, angle, other, ax, ay)
  end
  return balls
end

local function play(scene)
  local random = scene.random
  scene:start(random:pick({ 30, 60, 144, 240 }), random:pick({ 0, 800, 800 }))
  local rise = random:pick({ 0.1, 0.25, 0.5, 0.75, 1, 1.5 })
  local ax = 1 / math.sqrt(1 + rise * rise)
  local ay = ax * rise
  local balls = build(scene, ax, ay)
  if #balls == 1 or overlap.checker(balls)() > 0 then
    return
  end
  local start, mass = momentumOf(balls, ax, ay)
  local scale, first, isUp = 0, balls[1], false
  for _, ball in ipairs(balls) do
    scale = scale + ball.mass * math.sqrt(ball.vx * ball.vx + ball.vy * ball.vy)
  end
  local count = math.floor(0.5 * scene.hz + 0.5)
  for _ = 1, count do
    for _, ball in ipairs(balls) do
      isUp = isUp or ax * ball.vx + ay * ball.vy < 0
    end
    local was = ax * first.vx + ay * first.vy
    scene:step()
    scene:measure("stops dead", first.vx == 0 and first.vy == 0 and math.abs(was) > 20)
  end
  local wanted = start + mass * scene.world.gravity * ay * count / scene.hz
  local lost = math.abs(momentumOf(balls, ax, ay) - wanted) / math.max(math.abs(wanted), scale)
  scene:measure(isUp and "the same, one rolls up" or "momentum along the ramp lost", lost)
end

return {
  {
    name = "marbles",
    scenes = 2000,
    salt = { 19, 7 },
    rows = {
      { "momentum along the ramp lost", 0.01 },
      { "the same, one rolls up", 0.01 },
      { "stops dead", 0 },
    },
    play = play,
  },
}
