--- A marble on a ramp, struck by one to three others at once.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
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
  local random, g = scene.random, scene.gravity
  local start = ax * first.vx + ay * first.vy
  local along = start * time + g * ay * time * time / 2
  local cos, sin = math.cos(angle), math.sin(angle)
  local nx, ny = ay * cos + ax * sin, -ax * cos + ay * sin
  local far, speed = first.radius + radius, random:between(100, 600)
  local vx, vy = -nx * speed + ax * start / 2, -ny * speed + ay * start / 2
  local x = first.x + first.radius + ax * along + nx * far - vx * time
  local y = first.y + first.radius + ay * along + ny * far - vy * time - g * time * time / 2
  local striker = small.ball(x, y, radius, { vx = vx, vy = vy })
  scene:vary(striker, "mass", { 0.1, 0.5, 1, 1, 2, 10 }, "restitution", { 0, 0, 0.5 })
  if x * ay - y * ax > radius then
    return scene:add("balls", striker)
  end
end

-- Adds the ramp, the marble and those that strike it, and returns the balls.
local function build(scene, ax, ay)
  local random, count, rise = scene.random, scene.seed % 3 + 1, ay / ax
  scene:add("ramps", small.tile(-4000, -4000 * rise, 8000, 8000 * rise, { slope = "left" }))
  local radius = random:between(5, 14)
  local speed = random:between(100, 500) * random:pick({ 1, 1, 1, 1, -1 })
  local first = small.ball(200 + ay * radius, 200 * rise - ax * radius, radius)
  first.vx, first.vy, first.mass = ax * speed, ay * speed, random:pick({ 1, 1, 5 })
  local balls, time = { scene:add("balls", first) }, random:between(0.05, 0.2)
  for n = 1, count do
    local other = count == 3 and 10 or random:between(5, 14)
    local angle = math.rad(angleOf(random, n, count))
    balls[#balls + 1] = addStriker(scene, first, time, angle, other, ax, ay)
  end
  return balls
end

local function play(scene)
  local hz = scene:start({ 0, 800, 800 }, { 30, 60, 144, 240 })
  local rise = scene.random:pick({ 0.1, 0.25, 0.5, 0.75, 1, 1.5 })
  local ax = 1 / math.sqrt(1 + rise * rise)
  local ay = ax * rise
  local balls = build(scene, ax, ay)
  if #balls == 1 or overlap.checker(balls)() > 0 then
    return
  end
  local start, mass = momentumOf(balls, ax, ay)
  local scale, first, isUp, was = 0, balls[1], false, nil
  for _, ball in ipairs(balls) do
    scale = scale + ball.mass * math.sqrt(ball.vx * ball.vx + ball.vy * ball.vy)
  end
  scene:play(0.5, function()
    was = ax * first.vx + ay * first.vy
    for _, ball in ipairs(balls) do
      isUp = isUp or ax * ball.vx + ay * ball.vy < 0
    end
  end, function()
    scene:measure("stops dead", first.vx == 0 and first.vy == 0 and math.abs(was) > 20)
  end)
  local wanted = start + mass * scene.gravity * ay * scene.frame / hz
  local lost = math.abs(momentumOf(balls, ax, ay) - wanted) / math.max(math.abs(wanted), scale)
  scene:measure(isUp and "the same, one rolls up" or "momentum along the ramp lost", lost)
end

return {
  scenes.subject("marbles", 2000, play, {
    { "momentum along the ramp lost", 0.01 },
    { "the same, one rolls up", 0.01 },
    { "stops dead", 0 },
  }),
}
