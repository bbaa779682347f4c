--- Flush racks of balls that bounce without loss, struck by a ball from any direction.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local ROOT = math.sqrt(3)
local HEXAGON = { 1, 2, 1, 2, 1 } -- balls in each column

-- Adds a column of balls to a list of places, in radii; each knows its mirror image in the list.
local function addColumn(places, x, count, gap)
  local first = #places + 1
  for n = 0, count - 1 do
    places[first + n] = { x, (2 * n - count + 1) / 2 * gap, first + count - 1 - n }
  end
end

-- Kind of rack -> adds the places of its balls.
local RACKS = {}

function RACKS.triangle(places, random)
  for n = 1, random:integer(2, 5) do
    addColumn(places, (n - 1) * ROOT, n, 2)
  end
end

function RACKS.row(places, random)
  for n = 1, random:integer(3, 15) do
    addColumn(places, 2 * n - 2, 1, 2)
  end
end

function RACKS.column(places, random)
  addColumn(places, 0, random:integer(3, 15), 2)
end

function RACKS.hexagon(places)
  for n, count in ipairs(HEXAGON) do
    addColumn(places, n - 1, count, 2 * ROOT)
  end
end

function RACKS.two(places, random)
  for n = 1, random:integer(2, 7) do
    addColumn(places, 2 * n - 2, 2, 2)
  end
end

local function energyOf(balls)
  local sum = 0
  for _, ball in ipairs(balls) do
    sum = sum + ball.mass * (ball.vx * ball.vx + ball.vy * ball.vy)
  end
  return sum
end

-- The largest difference of a ball and its mirror image on the other side of the cue's line.
local function mirrorDifference(balls, places, cos, sin)
  local most = 0
  for n, ball in ipairs(balls) do
    local other = balls[places[n][3]]
    if other ~= ball then
      local along = cos * (ball.vx - other.vx) + sin * (ball.vy - other.vy)
      local across = cos * (ball.vy + other.vy) - sin * (ball.vx + other.vx)
      most = math.max(most, math.abs(along), math.abs(across))
    end
  end
  return most
end

local function play(scene)
  local random = scene.random
  scene:start(0, { 30, 60, 120, 144 })
  local angle = random:between(0, 2 * math.pi)
  local radius, speed = random:between(4, 20), random:pick({ 200, 700, 1500, 3000 })
  if random:chance(0.2) then
    angle = math.rad(random:pick({ 0, 30, 45, 60, 90, 180, 270 }))
  end
  local rack = RACKS[random:pick({ "triangle", "row", "column", "hexagon", "two" })]
  local mass = random:chance(0.3) and random:between(0.3, 3) or 1
  local places = { { -random:between(3, 12), 0, 1 } } -- the cue's
  rack(places, random)
  local cos, sin, balls = math.cos(angle), math.sin(angle), {}
  for n, place in ipairs(places) do
    local x, y = place[1] * radius, place[2] * radius
    balls[n] = small.ball(cos * x - sin * y, sin * x + cos * y, radius, { restitution = 1 })
    balls[n].mass = n == 1 and mass or 1
  end
  balls[1].vx, balls[1].vy = cos * speed, sin * speed
  for _, ball in ipairs(random:shuffled(balls)) do
    scene:add("balls", ball)
  end
  local energy = energyOf({ balls[1] })
  scene:play(0.6)
  scene:measure("energy lost or won", math.abs(energyOf(balls) / energy - 1))
  scene:measure("mirror balls leave apart", mirrorDifference(balls, places, cos, sin) / speed)
end

return {
  scenes.subject("racks", 1000, play, {
    { "energy lost or won", 0.01 },
    { "mirror balls leave apart", 0.01 },
  }),
}
