-- Many boxes or balls are dropped on each other. What rests is darker: nothing is computed for it.
-- Throw some, watch the time of a step, and let the broad phase look at all pairs instead.

local look = require("look")
local physics = require("physics")

local pile = {
  keys = {
    { "up", "down", "more, fewer" },
    { "click", "throw about" },
    { "space", "kick them all" },
    { "o", "boxes, balls or both" },
    { "b", "grid or all pairs" },
  },
}

local LEFT, RIGHT, FLOOR = 140, 820, 586 -- px, the inside of the container
local WALL = 20 -- px
local ROUNDING = 1e-6 -- px by which what is pressed may overlap
local CELL = 23 -- px, room for one box when they are dropped
local LAYER = 3 -- rows of one colour, which lie upon each other as they fell
local FIRST, STEP, MOST = 600, 100, 1500 -- boxes; of others half as many
local KINDS = { "boxes", "balls", "both" }
local COLORS = { "red", "orange", "yellow", "lime", "green", "cyan", "sky", "blue" }
local KICK, REACH, BLAST = 150, 130, 900 -- px/s, px, px/s

local world, random ---@type physics.World, any
local kind = 1 ---@type integer what is dropped: a place in KINDS

local function addWall(x, y, width, height)
  world:add("walls", { x = x, y = y, width = width, height = height, static = true })
end

-- Whether the i-th one is a ball.
local function isBall(i)
  return KINDS[kind] == "balls" or KINDS[kind] == "both" and i % 2 == 0
end

-- Drops `count` boxes or balls in rows, the lowest row at `bottom`.
local function addBoxes(count, bottom)
  local columns = math.floor((RIGHT - LEFT) / CELL)
  for i = 0, count - 1 do
    local column, row = i % columns, math.floor(i / columns)
    local x, width, height = random:random(0, 3), random:random(10, 20), random:random(10, 20)
    world:add("boxes", {
      x = LEFT + column * CELL + x,
      y = bottom - row * CELL,
      width = width,
      height = isBall(i) and width or height,
      radius = isBall(i) and width / 2 or nil,
      vx = random:random(-40, 40),
      friction = 0.3,
      color = COLORS[math.floor(row / LAYER) % #COLORS + 1],
    })
  end
end

local function fill()
  random = love.math.newRandomGenerator(7)
  world = physics.newWorld({ gravity = 800 })
  pile.world = world
  addWall(LEFT - WALL, FLOOR, RIGHT - LEFT + 2 * WALL, WALL)
  -- The walls reach far above the window, where the boxes begin to fall.
  addWall(LEFT - WALL, FLOOR - 5000, WALL, 5000)
  addWall(RIGHT, FLOOR - 5000, WALL, 5000)
  addBoxes(kind == 1 and FIRST or FIRST / 2, FLOOR - 120)
end

function pile.load()
  kind = 1
  fill()
end

function pile.update(dt)
  world:update(dt)
end

local function kick()
  for _, box in ipairs(world.objects.boxes) do
    box.vx = (box.vx or 0) + random:random(-KICK, KICK)
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
  elseif key == "o" and not isRepeat then
    kind = kind % #KINDS + 1
    fill()
  elseif key == "b" then
    world.broadphase = world.broadphase == "pairs" and "auto" or "pairs"
  end
end

--- Throws the boxes around a point away from it.
function pile.mousepressed(x, y)
  for _, box in ipairs(world:queryRect(x - REACH, y - REACH, 2 * REACH, 2 * REACH, "boxes")) do
    local dx, dy = box.x + box.width / 2 - x, box.y + box.height / 2 - y
    local distance = math.max(20, math.sqrt(dx * dx + dy * dy))
    local speed = math.max(0, 1 - distance / REACH) * BLAST / distance
    box.vx, box.vy = (box.vx or 0) + dx * speed, (box.vy or 0) + dy * speed
  end
end

local function drawBoxes()
  for _, box in ipairs(world.objects.boxes) do
    -- What lies still is darker: nothing is computed for it.
    local isStill = box.vx == 0 and box.vy == 0
    look.color(box.color, isStill and 0.62 or 1)
    local radius, x, y = box.radius, box.x + box.width / 2, box.y + box.height / 2
    if radius then
      love.graphics.circle("fill", x, y, radius)
    else
      love.graphics.rectangle("fill", box.x, box.y, box.width, box.height, 2)
    end
    love.graphics.setColor(1, 1, 1, isStill and 0.08 or 0.3)
    if radius then
      love.graphics.circle("fill", x - radius * 0.3, y - radius * 0.3, radius * 0.25)
    else
      love.graphics.rectangle("fill", box.x + 1, box.y + 1, box.width - 2, 2)
    end
  end
end

function pile.draw()
  look.sky("night", "dusk")
  drawBoxes()
  look.color("slate")
  for _, wall in ipairs(world.objects.walls) do
    love.graphics.rectangle("fill", wall.x, wall.y, wall.width, wall.height)
  end
  look.color("white")
  local text = ("%d %s   broad phase: %s"):format(
    #world.objects.boxes,
    KINDS[kind] == "both" and "boxes and balls" or KINDS[kind],
    world.broadphase
  )
  look.text(text, LEFT + 16, 10, 17)
end

function pile.report()
  local lowest, inside = 0, 0 ---@type number, integer
  for _, box in ipairs(world.objects.boxes) do
    lowest = math.max(lowest, box.y + box.height)
    local low, right = box.y + box.height - ROUNDING, box.x + box.width - ROUNDING
    if box.x + ROUNDING >= LEFT and right <= RIGHT and low <= FLOOR then
      inside = inside + 1
    end
  end
  local result = "pile: boxes=%d inside=%d lowest=%s resting=%d"
  return result:format(#world.objects.boxes, inside, lowest, world.stats.resting)
end

return pile
