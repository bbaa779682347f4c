--- The scenes of the pictures of docs/guide/: each function builds a world, plays it for some steps
--- and draws it into a window of 720 x 300 px. Those of docs/kit.md are in kit.lua.

local physics = require("physics")

local scenes = require("scripts.pictures.kit")
local stage = require("scripts.pictures.stage")

local write = stage.write

local DT = 1 / 60
local ARROWS = { 1, 0.8, 0.46 }

local function play(world, seconds)
  for _ = 1, math.floor(seconds / DT + 0.5) do
    world:update(DT)
  end
end

local function addBox(world, x, y, width, height, fields)
  return stage.add(world, "boxes", x, y, width, height, fields)
end

local function addStatic(world, x, y, width, height, fields)
  return stage.add(world, "tiles", x, y, width, height, fields, true)
end

-- An arrow along an axis.
local function arrow(x1, y1, x2, y2)
  local dx, dy = x2 > x1 and 1 or x2 < x1 and -1 or 0, y2 > y1 and 1 or y2 < y1 and -1 or 0
  love.graphics.setColor(ARROWS)
  love.graphics.setLineWidth(2)
  love.graphics.line(x1, y1, x2 - 8 * dx, y2 - 8 * dy)
  local x, y, across, up = x2 - 10 * dx, y2 - 10 * dy, 5 * dy, 5 * dx
  love.graphics.polygon("fill", x2, y2, x + across, y + up, x - across, y - up)
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
  write("touching.bottom\nis the floor", 116, 188)
  write("a stack is flush:\ngap 0, velocity 0", 440, 60)
  write("touching.top\nis the box on it", 664, 204)
end

-- What a platform does: riders, a belt, and what is caught below a ceiling.
scenes["guide-platforms"] = function()
  local world = physics.newWorld({ gravity = 800 })
  addStatic(world, 0, 260, 720, 24)
  addBox(world, 60, 190, 130, 18, { kinematic = true })
  addBox(world, 90, 150, 40, 40)
  addBox(world, 98, 122, 28, 28)
  addStatic(world, 290, 200, 180, 18, { surfaceSpeed = 90 })
  addBox(world, 300, 160, 40, 40)
  addStatic(world, 560, 60, 120, 18)
  local lift = addBox(world, 560, 150, 120, 18, { kinematic = true })
  addBox(world, 600, 106, 40, 44)
  play(world, 0.3)
  lift.vy = -100
  play(world, 0.3)
  world:draw()
  write("riders", 46, 140)
  arrow(66, 150, 86, 150)
  write("a lift: kinematic", 125, 214)
  arrow(190, 199, 230, 199)
  write("a belt: surfaceSpeed", 380, 224)
  arrow(345, 180, 385, 180)
  write("caught: onCrush", 620, 34)
  arrow(550, 190, 550, 140)
end

-- All that `world:draw` can show.
scenes["guide-debugging"] = function()
  local world = physics.newWorld({ gravity = 800 })
  addStatic(world, 0, 260, 720, 40)
  addStatic(world, 420, 190, 120, 12, { oneWay = "top" })
  world:add("players", { x = 80, y = 150, width = 40, height = 50, vx = 420, vy = -120 })
  world:add("lifts", { x = 250, y = 210, width = 110, height = 14, kinematic = true, vy = -300 })
  world:add("crates", { x = 280, y = 170, width = 40, height = 40 })
  world:add("coins", { x = 470, y = 150, width = 20, height = 20, static = true, sensor = true })
  world:add("crates", { x = 620, y = 212, width = 48, height = 48 })
  play(world, 0.05)
  world:draw({ velocity = true, names = true, counters = true })
end

-- One-way ledges, a sensor, an inactive box and one that passes through a wall.
scenes["guide-filters"] = function()
  local world = physics.newWorld({ gravity = 0 })
  for i, side in ipairs({ "top", "bottom", "left", "right" }) do
    addStatic(world, 16 + 104 * (i - 1), 100, 80, 80, { oneWay = side })
    write(side, 56 + 104 * (i - 1), 196)
  end
  addStatic(world, 440, 90, 70, 100, { sensor = true })
  addBox(world, 460, 140, 30, 30)
  write("sensor", 475, 196)
  addStatic(world, 560, 80, 24, 110)
  addBox(world, 542, 110, 60, 40, { mask = { tiles = false } })
  write("mask", 572, 196)
  addBox(world, 650, 130, 40, 40, { active = false })
  write("not active", 670, 196)
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
  love.graphics.setColor(0.1, 0.11, 0.17, 0.9)
  love.graphics.rectangle("fill", x - 70, y + 12, 140, 18, 4)
  write("the rays begin here", x, y + 13)
  write("hit at x, y", 660, 214)
  write("hidden: not hit", 88, 92)
end

return scenes
