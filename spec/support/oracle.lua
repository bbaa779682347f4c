--- Oracles: random scenes of which the motion is known in closed form, from the laws alone. Each
--- class is played with random masses, sizes and speeds at several rates and with irregular steps,
--- and compared after every step. Nothing here is taken from the code of the library.
---
--- Tolerances, in px and px/s: EXACT is the rounding of some hundred steps, MEETING what a moment
--- that is computed adds to it. A wider one has its reason beside it.

local effort = require("spec.support.effort")
local newRandom = require("spec.support.random").new
local small = require("spec.support.small")
local physics = require("physics")

local abs, exp, huge, max, sqrt = math.abs, math.exp, math.huge, math.max, math.sqrt

local oracle = { EXACT = 1e-9, MEETING = 1e-6 }

-- Steps per second; "irregular" ones are between 1/240 and 1/30 s long.
local RATES = { 30, 60, 144, 240, "irregular" }
local SCENES = 12 -- of each class at each rate

-- Numbers on paper -------------------------------------------------------------------------------

--- The time until something at `way` px with v and acceleration a comes to 0; `way` and a > 0 point
--- the same way. nil: it does not.
function oracle.timeTo(way, v, a)
  if a == 0 then
    return v ~= 0 and way / v > 0 and way / v or nil
  end
  local root = v * v + 2 * a * way
  return root >= 0 and (sqrt(root) - v) / a or nil
end

--- A way and speed after t s of braking by b px/s² to a stop.
function oracle.braked(v, b, t)
  local stop = abs(v) / b
  if t >= stop then
    return v * stop / 2, 0
  end
  local sign = v < 0 and -1 or 1
  return v * t - sign * b * t * t / 2, v - sign * b * t
end

--- A way and speed after t s at a px/s² up to a limit.
function oracle.limited(v, a, limit, t)
  local moment = (limit - v) / a
  if t <= moment then
    return v * t + a * t * t / 2, v + a * t
  end
  return v * moment + a * moment * moment / 2 + limit * (t - moment), limit
end

--- A way and speed after t s in air that brakes by k * v, pulled by a.
function oracle.inAir(v, a, k, t)
  local terminal = a / k
  local left = exp(-k * t)
  return terminal * t + (v - terminal) * (1 - left) / k, terminal + (v - terminal) * left
end

--- A height above the floor, and the speed upwards, after t s of bouncing with restitution r; h, v
--- at first. The third result is the speed of the next impact.
function oracle.bouncing(h, v, g, r, t)
  local fall = (v + sqrt(v * v + 2 * g * h)) / g
  local impact = g * fall - v
  while t > fall do
    if r * impact < 1e-3 then
      return 0, 0, 0
    end
    t = t - fall
    h, v = 0, r * impact
    fall, impact = 2 * v / g, v
  end
  return h + v * t - g * t * t / 2, v - g * t, impact
end

-- The moment of the first impact of neighbours within t s, and the left one of the two, or 0.
local function firstImpact(bodies, t)
  local which = 0
  for n = 1, #bodies - 1 do
    local a, b = bodies[n], bodies[n + 1]
    local closing, gap = a.v - b.v, b.x - a.x - a.width
    if closing > 1e-12 and gap / closing < t then
      t = max(gap / closing, 0)
      which = n
    end
  end
  return t, which
end

-- Makes one block of number n, the next one and what goes along with them.
local function join(bodies, n)
  local low = n
  local high = n + 1
  while bodies[n].block and low > 1 and bodies[low - 1].block == bodies[n].block do
    low = low - 1
  end
  local other = bodies[n + 1].block
  while other and high < #bodies and bodies[high + 1].block == other do
    high = high + 1
  end
  local mass, momentum = 0, 0
  local wall
  for m = low, high do
    local body = bodies[m]
    mass, momentum = mass + body.mass, momentum + body.mass * body.v
    if body.mass == huge then
      wall = body.v
    end
  end
  for m = low, high do
    bodies[m].v, bodies[m].block = wall or momentum / mass, bodies[low]
  end
end

local function bounce(a, b, r)
  local shareA = a.mass == huge and 0 or b.mass == huge and 1 or b.mass / (a.mass + b.mass)
  local change = (1 + r) * (a.v - b.v)
  a.v, b.v = a.v - shareA * change, b.v + (1 - shareA) * change
end

--- Plays bodies on a line without forces for t s, impact by impact; those that do not bounce go on
--- as one. Each has x, v, mass (math.huge: a wall) and width; they are in order.
function oracle.playLine(bodies, r, t)
  local which
  repeat
    local time, left = firstImpact(bodies, t)
    which = left
    for _, body in ipairs(bodies) do
      body.x = body.x + body.v * time
    end
    t = t - time
    if which > 0 and r == 0 then
      join(bodies, which)
    elseif which > 0 then
      bounce(bodies[which], bodies[which + 1], r)
    end
  until which == 0
end

-- Scenes -----------------------------------------------------------------------------------------

local Scene = {}
Scene.__index = Scene

-- A scene: a world without gravity, and how far it is from what is computed at most.
local function newScene(random, rate)
  local scene = { random = random, rate = rate, worst = 0, what = "", time = 0, count = 0 }
  scene.world = physics.newWorld({ gravity = 0 })
  return setmetatable(scene, Scene)
end

-- Returns random numbers: low, high, low, high, … The first one is the gravity.
function Scene:draw(low, high, ...)
  self.world.gravity = self.random:between(low, high)
  return self.world.gravity, oracle.some(self.random, ...)
end

function Scene:set(settings)
  small.set(self.world, settings)
end

function Scene:box(fields)
  fields.width = fields.width or self.random:between(8, 32)
  fields.height = fields.height or self.random:between(8, 32)
  fields.mass = fields.mass or self.random:between(0.2, 5)
  return self.world:add("boxes", fields)
end

-- A box on the floor, the surface of which is y = 0.
function Scene:stand(fields)
  fields.height = fields.height or self.random:between(8, 32)
  fields.y = -fields.height
  return self:box(fields)
end

function Scene:floor(fields)
  return self.world:add("floor", small.tile(-30000, 0, 60000, 20, fields))
end

-- Compares a place or a speed with what is computed.
function Scene:near(what, expected, got)
  local off = abs(expected - got)
  self.count = self.count + 1
  if off > self.worst or off ~= off then
    self.worst, self.what =
      off, ("%s: %.12g, not %.12g, after %g s"):format(what, got, expected, self.time)
  end
end

-- Plays for some seconds, and calls check(t) after each step.
function Scene:play(seconds, check)
  self.time = 0
  while self.time < seconds - 1e-9 do
    local dt = self.rate == "irregular" and self.random:between(1 / 240, 1 / 30) or 1 / self.rate
    self.world:update(dt)
    self.time = self.time + dt
    if check then
      check(self.time)
    end
  end
end

-- The longest step, s.
function Scene:longest()
  return self.rate == "irregular" and 1 / 30 or 1 / self.rate
end

-- Plays the scenes of a class. Returns how many numbers were compared.
local function playAll(name, tolerance, play)
  local count, first = 0, 0 -- of the seeds: each class has others
  for n = 1, #name do
    first = first + n * name:byte(n)
  end
  for m, rate in ipairs(RATES) do
    for n = 1, SCENES do
      if effort.plays(m + n + #name, 4) then
        local seed = first + 100 * m + n
        local scene = newScene(newRandom(seed), rate)
        play(scene)
        local isNear = scene.worst <= (scene.tolerance or tolerance)
        local text = "%s Hz, seed %d, off by %.3g: %s"
        assert(isNear, text:format(rate, seed, scene.worst, scene.what))
        count = count + scene.count
      end
    end
  end
  return count
end

--- Returns a function class(name, tolerance, play) that defines a spec by busted's `it`. play(s)
--- plays the scene `s`; where that has a `tolerance`, it is used instead.
function oracle.newClass(it)
  return function(name, tolerance, play)
    it(name, function()
      local count = playAll(name, tolerance, play)
      assert(count >= 15, "compares only " .. count .. " numbers")
    end)
  end
end

--- Returns a random number for each range: low, high, low, high, …
function oracle.some(random, low, high, ...)
  if ... then
    return random:between(low, high), oracle.some(random, ...)
  end
  return random:between(low, high)
end

return oracle
