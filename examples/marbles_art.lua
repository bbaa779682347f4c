-- How the marble run looks: a board of wood, glass marbles that turn as they roll, bumpers that
-- light up. The world is only read.

local look = require("look")
local sparks = require("sparks")
local view = require("view")

local art = {}

local FADE = 3 -- 1/s, how fast a bumper goes out
local TRAIL = 7 -- places of a marble that are drawn behind it

local board ---@type table

-- The lines of the board's wood: knots and grain, always the same.
local function newGrain()
  local lines = {}
  for n = 1, 26 do
    local points, y = {}, n * 24 - 8
    for x = 0, view.gameWidth, 40 do
      points[#points + 1] = x
      points[#points + 1] = y + love.math.noise(x / 260, n * 3.7) * 34
    end
    lines[n] = points
  end
  return lines
end

function art.load()
  board = newGrain()
end

local function remember(marble)
  local trail = marble.trail or {}
  marble.trail = trail
  table.insert(trail, 1, marble.y + marble.radius)
  table.insert(trail, 1, marble.x + marble.radius)
  for n = #trail, 2 * TRAIL + 1, -1 do
    trail[n] = nil
  end
end

function art.update(world, dt)
  for _, bumper in ipairs(world.objects.bumpers) do
    bumper.light = math.max(0, bumper.light - dt * FADE)
  end
  for _, marble in ipairs(world.objects.marbles) do
    remember(marble)
  end
  sparks.update(dt)
end

local function drawBoard()
  look.sky("plum", "night")
  love.graphics.setLineWidth(2)
  look.color("red", 0.13)
  for _, points in ipairs(board) do
    for n = 1, #points - 3, 2 do
      love.graphics.line(points[n], points[n + 1], points[n + 2], points[n + 3])
    end
  end
  love.graphics.setLineWidth(1)
end

-- The corners of what is solid of a ramp, a box or a slope.
local function cornersOf(ramp)
  local left, top, right, bottom = ramp.x, ramp.y, ramp.x + ramp.width, ramp.y + ramp.height
  if ramp.slope == "right" then
    return { left, bottom, right, top, right, bottom }
  elseif ramp.slope == "left" then
    return { left, top, right, bottom, left, bottom }
  elseif ramp.slope == "topright" then
    return { left, top, right, top, right, bottom }
  end
  return { left, top, right, top, right, bottom, left, bottom }
end

local function drawRamps(ramps)
  love.graphics.push()
  love.graphics.translate(4, 6)
  look.color("night", 0.45)
  for _, ramp in ipairs(ramps) do
    love.graphics.polygon("fill", cornersOf(ramp))
  end
  love.graphics.pop()
  for _, ramp in ipairs(ramps) do
    look.color("orange")
    love.graphics.polygon("fill", cornersOf(ramp))
  end
  love.graphics.setLineWidth(3)
  for _, ramp in ipairs(ramps) do
    local corners = cornersOf(ramp)
    if ramp.slope then
      look.color("yellow")
      local last = ramp.slope == "topright" and 5 or 3 -- the other end of the edge
      love.graphics.line(corners[1], corners[2], corners[last], corners[last + 1])
    end
  end
  love.graphics.setLineWidth(1)
end

local function drawWalls(walls)
  for _, wall in ipairs(walls) do
    look.color("night", 0.45)
    love.graphics.rectangle("fill", wall.x + 3, wall.y + 4, wall.width, wall.height)
    look.color("plum")
    love.graphics.rectangle("fill", wall.x, wall.y, wall.width, wall.height)
    look.color("red", 0.6)
    love.graphics.rectangle("fill", wall.x, wall.y, 3, wall.height)
  end
end

local function drawLift(lifts)
  for _, platform in ipairs(lifts) do
    look.color("silver", platform.active == false and 0 or 1)
    love.graphics.rectangle("fill", platform.x, platform.y, platform.width, platform.height, 3)
    look.color("white", platform.active == false and 0 or 0.7)
    love.graphics.rectangle("fill", platform.x + 1, platform.y, platform.width - 2, 2, 1)
  end
end

local function drawBumpers(bumpers)
  for _, bumper in ipairs(bumpers) do
    local r, x, y = bumper.radius, bumper.x + bumper.radius, bumper.y + bumper.radius
    look.color("night", 0.45)
    love.graphics.circle("fill", x + 4, y + 6, r)
    look.color("yellow", 0.35 * bumper.light)
    love.graphics.circle("fill", x, y, r + 10 * bumper.light)
    look.color("red")
    love.graphics.circle("fill", x, y, r)
    look.color("white")
    love.graphics.circle("fill", x, y, r * 0.72)
    look.color(bumper.light > 0.2 and "yellow" or "orange")
    love.graphics.circle("fill", x, y, r * 0.5)
  end
end

local function drawPegs(pegs)
  for _, peg in ipairs(pegs) do
    local x, y = peg.x + peg.radius, peg.y + peg.radius
    look.color("night", 0.45)
    love.graphics.circle("fill", x + 2, y + 4, peg.radius)
    look.color("yellow")
    love.graphics.circle("fill", x, y, peg.radius)
    look.color("white", 0.8)
    love.graphics.circle("fill", x - 1.5, y - 1.5, peg.radius * 0.35)
  end
end

local function drawTrail(marble)
  local trail = marble.trail or {}
  for n = 3, #trail, 2 do
    look.color(marble.color, 0.16 * (1 - n / #trail))
    love.graphics.circle("fill", trail[n], trail[n + 1], marble.radius * (1 - n / #trail / 2))
  end
end

-- Glass: a band across it shows how it turns, a light stays where the lamp is.
local function drawMarble(marble)
  local r, x, y = marble.radius, marble.x + marble.radius, marble.y + marble.radius
  look.color("night", 0.35)
  love.graphics.circle("fill", x + 2, y + 4, r)
  look.color(marble.color)
  love.graphics.circle("fill", x, y, r)
  look.color("night", 0.28)
  love.graphics.arc("fill", x, y, r, marble.angle, marble.angle + math.pi)
  look.color("white", 0.75)
  love.graphics.setLineWidth(2)
  local dx, dy = math.cos(marble.angle) * r * 0.75, math.sin(marble.angle) * r * 0.75
  love.graphics.line(x - dx, y - dy, x + dx, y + dy)
  love.graphics.setLineWidth(1)
  look.color("white", 0.9)
  love.graphics.circle("fill", x - r * 0.35, y - r * 0.4, r * 0.25)
end

function art.draw(world)
  local objects = world.objects
  drawBoard()
  drawWalls(objects.walls)
  drawLift(objects.lifts)
  drawRamps(objects.ramps)
  drawPegs(objects.pegs)
  drawBumpers(objects.bumpers)
  for _, marble in ipairs(objects.marbles) do
    drawTrail(marble)
  end
  for _, marble in ipairs(objects.marbles) do
    drawMarble(marble)
  end
  sparks.draw()
end

return art
