--- The scenes of the pictures of docs/guide/: each function builds a world, plays it for some steps
--- and draws it into a window of 720 x 300 px.

local physics = require("physics")

local scenes = {}

local DT = 1 / 60
local WORDS = { 0.78, 0.8, 0.85 }

local function play(world, seconds, each)
  for _ = 1, math.floor(seconds / DT + 0.5) do
    world:update(DT)
    if each then
      each()
    end
  end
end

local function addStatic(world, x, y, width, height, fields)
  local object = { x = x, y = y, width = width, height = height, static = true }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return world:add("tiles", object)
end

local function addBox(world, x, y, width, height, fields)
  local object = { x = x, y = y, width = width, height = height }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return world:add("boxes", object)
end

-- Writes a text with its middle at x.
local function write(text, x, y)
  love.graphics.setColor(WORDS)
  love.graphics.printf(text, x - 100, y, 200, "center")
end

-- All kinds of objects side by side, with their names.
scenes["guide-objects"] = function()
  local world = physics.newWorld({ gravity = 800 })
  addStatic(world, 0, 200, 720, 24)
  local kinds = {
    { "static", addStatic(world, 30, 136, 64, 64) },
    { "kinematic", addBox(world, 128, 150, 64, 16, { kinematic = true, vy = -10 }) },
    { "moving", addBox(world, 238, 40, 48, 48, { vx = 30 }) },
    { "at rest", addBox(world, 338, 152, 48, 48) },
    { "sensor", addStatic(world, 436, 150, 48, 50, { sensor = true }) },
    { "one-way", addStatic(world, 530, 150, 64, 14, { oneWay = "top" }) },
    { "not active", addBox(world, 640, 152, 48, 48, { active = false }) },
  }
  play(world, 0.3)
  world:draw()
  for _, kind in ipairs(kinds) do
    write(kind[1], kind[2].x + kind[2].width / 2, 236)
  end
end

-- A pyramid and a box that leans on it.
scenes["guide-contacts"] = function()
  local world = physics.newWorld({ gravity = 800 })
  addStatic(world, 0, 260, 720, 24)
  for row = 0, 5 do
    for i = 0, 5 - row do
      addBox(world, 220 + 20 * row + 40 * i, 220 - 40 * row, 40, 40, { friction = 0.6 })
    end
  end
  addBox(world, 100, 228, 32, 32)
  addBox(world, 560, 200, 60, 60, { friction = 0.6 })
  addBox(world, 574, 160, 32, 40, { friction = 0.6 })
  play(world, 1)
  world:draw()
end

-- One-way ledges, a sensor, an inactive box and one that passes through a wall.
scenes["guide-filters"] = function()
  local world = physics.newWorld({ gravity = 0 })
  for i, side in ipairs({ "top", "bottom", "left", "right" }) do
    addStatic(world, 20 + 110 * (i - 1), 100, 80, 80, { oneWay = side })
    write(side, 60 + 110 * (i - 1), 196)
  end
  addStatic(world, 470, 90, 70, 100, { sensor = true })
  addBox(world, 490, 140, 30, 30)
  write("sensor", 505, 196)
  addStatic(world, 590, 80, 24, 110)
  addBox(world, 572, 110, 60, 40, { mask = { tiles = false } })
  write("mask", 602, 196)
  addBox(world, 660, 130, 40, 40, { active = false })
  write("not active", 665, 196)
  play(world, 0.1)
  world:draw()
end

-- A lamp: rays in all directions, to what they hit.
scenes["guide-queries"] = function()
  local world = physics.newWorld({ gravity = 0 })
  world:setBounds(10, 10, 700, 280)
  for i = 0, 6 do
    addStatic(world, 70 + 95 * i, 50 + 60 * (i * 3 % 4), 36, 36)
  end
  local x, y = 330, 205
  love.graphics.setColor(1, 0.9, 0.5, 0.5)
  for i = 0, 119 do
    local angle = i * math.pi / 60
    local _, hitX, hitY = world:raycast(x, y, x + 900 * math.cos(angle), y + 900 * math.sin(angle))
    love.graphics.line(x, y, hitX, hitY)
  end
  love.graphics.circle("fill", x, y, 5)
  love.graphics.setColor(1, 1, 1)
  world:draw()
end

return scenes
