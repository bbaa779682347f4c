-- Step 10: drawing, and not looking at every pair.

local drawWorld = require("physics.world.draw").draw
local look = require("look")
local physics = require("physics")

local lesson = {
  title = "Drawing, and doing less",
  text = [[
To draw, loop over the objects. For a first look the library draws them itself: each kind in
its colour, with the sides that touch (space).

Comparing every object with every other one is simple and slow: twice the objects are four
times the work. So:
- compare each pair only once
- skip two static objects: they never meet
- use a grid: only neighbours can meet
- skip objects at rest

The bars count the pairs of this scene.]],
  code = [[
function love.draw()
  physics.draw({ velocity = true, touching = true })
end

world.stats.pairs  -- looked at in the last step]],
  keys = { { "space", "draw" }, { "enter", "kick" } },
}

local TILE = 22
local BOXES = 60
local COLORS = { "red", "orange", "yellow", "lime", "sky" }

local world, random ---@type physics.World, any
local isPlain = true -- drawn by the library

function lesson.load()
  random = love.math.newRandomGenerator(5)
  world = physics.newWorld({ gravity = 800 })
  lesson.world = world
  for i = 0, 21 do
    world:add("tiles", { x = i * TILE, y = 308, width = TILE, height = TILE, static = true })
  end
  for i = 0, 13 do
    world:add("tiles", { x = 0, y = i * TILE, width = TILE, height = TILE, static = true })
    world:add("tiles", { x = 462, y = i * TILE, width = TILE, height = TILE, static = true })
  end
  for i = 0, BOXES - 1 do
    world:add("boxes", {
      x = 30 + i % 12 * 35,
      y = 20 + math.floor(i / 12) * 40,
      width = random:random(14, 30),
      height = random:random(14, 30),
      friction = 0.4,
      color = COLORS[i % #COLORS + 1],
    })
  end
end

function lesson.keypressed(key)
  if key == "space" then
    isPlain = not isPlain
  elseif key == "return" then
    for _, box in ipairs(world.objects.boxes) do
      box.vx, box.vy = random:random(-200, 200), -random:random(100, 400)
    end
  end
end

function lesson.update(dt)
  world:update(dt)
end

local function drawFancy()
  for _, tile in ipairs(world.objects.tiles) do
    look.box(tile.x, tile.y, tile.width, tile.height, "slate")
  end
  for _, box in ipairs(world.objects.boxes) do
    look.box(box.x, box.y, box.width, box.height, box.color)
    look.eyes(box.x, box.y, box.width, box.height, 0, 0)
  end
end

-- Bars with a root scale: the differences are too large for a plain one.
local function drawBars(bars)
  local most = bars[1][2]
  for i, bar in ipairs(bars) do
    local y = 336 + (i - 1) * 31
    look.color("silver")
    look.text(bar[1], 12, y, 14)
    look.color(i == #bars and "lime" or i == #bars - 1 and "sky" or "orange")
    love.graphics.rectangle("fill", 210, y + 2, math.max(2, 200 * math.sqrt(bar[2] / most)), 15, 3)
    look.color("white")
    look.text(tostring(bar[2]), 414, y, 14, 60, "right")
  end
end

function lesson.draw()
  if isPlain then
    drawWorld(world, { velocity = true })
  else
    drawFancy()
  end
  local tiles, boxes = #world.objects.tiles, #world.objects.boxes
  local all = tiles + boxes
  drawBars({
    { "each box with each", all * (all - 1) },
    { "each pair once", all * (all - 1) / 2 },
    { "not static with static", boxes * tiles + boxes * (boxes - 1) / 2 },
    { "neighbours in the grid", world.stats.pairs },
    { "boxes not at rest", world.stats.movers - world.stats.resting },
  })
end

function lesson.report()
  return ("pairs=%d"):format(world.stats.pairs)
end

return lesson
