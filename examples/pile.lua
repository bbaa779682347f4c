-- Many boxes dropped on each other, with the numbers that say what it costs.

local look = require("look")
local physics = require("physics")

local pile = {}

local LEFT, RIGHT, FLOOR = 260, 940, 610 -- px, the inside of the container
local WALL = 20 -- px
local CELL = 23 -- px, room for one box when they are dropped
local FIRST, STEP, MOST = 600, 100, 1500 -- boxes
local COLORS = { "red", "orange", "yellow", "lime", "green", "cyan", "sky", "blue" }
local HISTORY = 200 -- updates in the graph
local GRAPH_TOP = 4 -- ms, the upper end of the graph

local world, random
local times, average -- ms per update: the last ones, and smoothed

local function addWall(x, y, width, height)
  world:add("walls", { x = x, y = y, width = width, height = height, static = true })
end

-- Drops `count` boxes in rows, the lowest row at `bottom`.
local function addBoxes(count, bottom)
  local columns = math.floor((RIGHT - LEFT) / CELL)
  for i = 0, count - 1 do
    local column, row = i % columns, math.floor(i / columns)
    world:add("boxes", {
      x = LEFT + column * CELL + random:random(0, 3),
      y = bottom - row * CELL,
      width = random:random(10, 20),
      height = random:random(10, 20),
      vx = random:random(-40, 40),
      friction = 0.3,
      color = COLORS[random:random(#COLORS)],
    })
  end
end

function pile.load()
  random = love.math.newRandomGenerator(7)
  times, average = {}, 0
  world = physics.newWorld({ gravity = 800 })
  addWall(LEFT - WALL, FLOOR, RIGHT - LEFT + 2 * WALL, WALL)
  -- The walls reach far above the window, where the boxes begin to fall.
  addWall(LEFT - WALL, FLOOR - 5000, WALL, 5000)
  addWall(RIGHT, FLOOR - 5000, WALL, 5000)
  addBoxes(FIRST, FLOOR - 120)
end

function pile.update(dt)
  local before = love.timer.getTime()
  world:update(dt)
  local ms = (love.timer.getTime() - before) * 1000
  table.insert(times, ms)
  if #times > HISTORY then
    table.remove(times, 1)
  end
  average = average + (ms - average) * (#times < 20 and 0.3 or 0.05)
end

local function kick()
  for _, box in ipairs(world.objects.boxes) do
    box.vx = (box.vx or 0) + random:random(-150, 150)
    box.vy = -random:random(200, 600)
  end
end

local function more()
  local boxes = world.objects.boxes
  local top = FLOOR
  for _, box in ipairs(boxes) do
    top = math.min(top, box.y)
  end
  addBoxes(math.min(STEP, MOST - #boxes), math.min(top, 0) - 2 * CELL)
end

local function fewer()
  local boxes = world.objects.boxes
  for _ = 1, math.min(STEP, #boxes) do
    table.remove(boxes)
  end
end

function pile.keypressed(key, isRepeat)
  if key == "+" or key == "kp+" or key == "=" or key == "up" then
    more()
  elseif key == "-" or key == "kp-" or key == "down" then
    fewer()
  elseif key == "space" and not isRepeat then
    kick()
  elseif key == "r" then
    pile.load()
  elseif key == "b" then
    world.broadphase = world.broadphase == "pairs" and "auto" or "pairs"
  end
end

-- ----------------------------------------------------------------------------------------- draw --

local function drawBoxes()
  for _, box in ipairs(world.objects.boxes) do
    -- What lies still is darker: nothing is computed for it.
    local isStill = box.vx == 0 and box.vy == 0
    look.color(box.color, isStill and 0.62 or 1)
    love.graphics.rectangle("fill", box.x, box.y, box.width, box.height, 2)
    love.graphics.setColor(1, 1, 1, isStill and 0.08 or 0.3)
    love.graphics.rectangle("fill", box.x + 1, box.y + 1, box.width - 2, 2)
  end
end

local function drawNumber(name, value, y)
  look.color("silver")
  look.text(name, 32, y + 2, 14)
  look.color("white")
  look.text(tostring(value), 120, y, 17, 84, "right")
end

local function drawGraph(x, y, width, height)
  look.color("dusk")
  love.graphics.rectangle("fill", x, y, width, height, 4)
  for i, ms in ipairs(times) do
    local size = math.min(height, ms / GRAPH_TOP * height)
    look.color(ms > GRAPH_TOP and "red" or "sky")
    local barX = x + (i - 1) / HISTORY * width
    love.graphics.rectangle("fill", barX, y + height - size, width / HISTORY, size)
  end
  look.color("silver")
  look.text(("%d ms"):format(GRAPH_TOP), x + 5, y + 3, 11)
end

local function drawPanel()
  local stats = world.stats
  look.panel(16, 16, 208, 606)
  look.color("white")
  look.text("Pile", 32, 26, 30)
  drawNumber("boxes", #world.objects.boxes, 78)
  drawNumber("ms an update", ("%.2f"):format(average), 104)
  drawNumber("frames a second", love.timer.getFPS(), 130)
  drawGraph(32, 164, 176, 80)
  drawNumber("objects", stats.objects, 260)
  drawNumber("movers", stats.movers, 284)
  drawNumber("resting", stats.resting, 308)
  drawNumber("pairs looked at", stats.pairs, 332)
  drawNumber("contacts", stats.contacts, 356)
  drawNumber("events in a step", stats.events, 380)
  drawNumber("broad phase", world.broadphase, 404)
  look.keys({ { "+", "more" }, { "-", "fewer" } }, 32, 446)
  look.keys({ { "space", "kick them all" } }, 32, 478)
  look.keys({ { "b", "grid or all pairs" } }, 32, 510)
  look.keys({ { "r", "again" } }, 32, 542)
  look.keys({ { "esc", "menu" } }, 32, 574)
end

function pile.draw()
  look.sky("night", "dusk")
  drawBoxes()
  look.color("slate")
  for _, wall in ipairs(world.objects.walls) do
    love.graphics.rectangle("fill", wall.x, wall.y, wall.width, wall.height)
  end
  drawPanel()
end

function pile.report()
  local lowest, inside = 0, 0
  for _, box in ipairs(world.objects.boxes) do
    lowest = math.max(lowest, box.y + box.height)
    if box.x >= LEFT and box.x + box.width <= RIGHT and box.y + box.height <= FLOOR then
      inside = inside + 1
    end
  end
  local result = "pile: boxes=%d inside=%d lowest=%s resting=%d"
  return result:format(#world.objects.boxes, inside, lowest, world.stats.resting)
end

return pile
