-- The first screen: choose an example. Behind the list a small world rains boxes.

local look = require("look")
local physics = require("physics")

local menu = {}

local EXAMPLES = {
  { name = "platformer", title = "Platformer", text = "A level to play: run, jump, push, stomp." },
  { name = "tutorial", title = "Tutorial", text = "How such an engine works, in ten steps." },
  { name = "lifts", title = "Lifts", text = "Riders, belts, one-way shelves, a press." },
  { name = "topdown", title = "Top-down", text = "Rooms, narrow doors, crates, a ghost." },
  { name = "breakout", title = "Breakout", text = "Balls that bounce, bullets that hit." },
  { name = "rollback", title = "Rollback", text = "Football, and time that turns back." },
  { name = "pile", title = "Pile", text = "What it costs to stack many boxes." },
}
local X, Y, WIDTH, HEIGHT, GAP = 80, 170, 430, 50, 7
local COLORS = { "red", "orange", "yellow", "green", "sky", "blue", "plum" }
local MOST = 90 -- boxes

local chosen = 1
local mouseX, mouseY = 0, 0
local world, random, untilNext

function menu.load()
  random = love.math.newRandomGenerator(2)
  untilNext = 0
  world = physics.newWorld({ gravity = 700 })
  world:add("walls", { x = 540, y = 600, width = 420, height = 40, static = true })
  world:add("walls", { x = 540, y = -400, width = 20, height = 1000, static = true })
  world:add("walls", { x = 940, y = -400, width = 20, height = 1000, static = true })
end

local function addBox()
  local size = random:random(18, 46)
  world:add("boxes", {
    x = random:random(565, 890),
    y = -80,
    width = size,
    height = random:random(18, 46),
    mass = size,
    friction = 0.5,
    restitution = 0.15,
    vx = random:random(-60, 60),
    color = COLORS[random:random(#COLORS)],
  })
  local boxes = world.objects.boxes
  if #boxes > MOST then
    table.remove(boxes, 1)
  end
end

function menu.update(dt)
  untilNext = untilNext - dt
  if untilNext <= 0 then
    untilNext = 0.16
    addBox()
  end
  world:update(dt)

  -- The mouse chooses when it moves, so that it does not fight with the keys.
  local x, y = love.mouse.getPosition()
  if x ~= mouseX or y ~= mouseY then
    mouseX, mouseY = x, y
    chosen = menu.at(x, y) or chosen
  end
end

--- Returns the number of the example whose entry is at a point, or nil.
function menu.at(x, y)
  for i = 1, #EXAMPLES do
    local top = Y + (i - 1) * (HEIGHT + GAP)
    if physics.inside(x, y, 0, 0, X, top, WIDTH, HEIGHT) then
      return i
    end
  end
end

function menu.draw()
  look.sky("night", "navy")
  for _, wall in ipairs(world.objects.walls) do
    look.color("dusk")
    love.graphics.rectangle("fill", wall.x, wall.y, wall.width, wall.height)
  end
  for _, box in ipairs(world.objects.boxes or {}) do
    look.box(box.x, box.y, box.width, box.height, box.color)
    look.eyes(box.x, box.y, box.width, box.height, 0, box.touching.bottom and 0 or 1)
  end

  look.color("white")
  look.text("physics.lua", X, 44, 54)
  look.color("silver")
  look.text("2D physics for games made of boxes", X + 3, 116, 18)
  for i, example in ipairs(EXAMPLES) do
    local y = Y + (i - 1) * (HEIGHT + GAP)
    look.panel(X, y, WIDTH, HEIGHT)
    if i == chosen then
      look.color("sky")
      love.graphics.rectangle("fill", X, y + 9, 5, HEIGHT - 18, 2)
      look.color("white")
    else
      look.color("silver")
    end
    look.text(example.title, X + 22, y + 12, 20)
    look.color(i == chosen and "silver" or "slate")
    look.text(example.text, X + 142, y + 17, 14)
  end
  look.keys({ { "up", "down", "choose" }, { "enter", "start" }, { "esc", "quit" } }, X, 588)
end

--- Returns the name of the example to show when one was started.
function menu.keypressed(key)
  if key == "up" then
    chosen = (chosen - 2) % #EXAMPLES + 1
  elseif key == "down" then
    chosen = chosen % #EXAMPLES + 1
  elseif key == "return" or key == "kpenter" or key == "space" then
    return EXAMPLES[chosen].name
  end
end

function menu.mousepressed(x, y)
  local i = menu.at(x, y)
  return i and EXAMPLES[i].name
end

function menu.report()
  local boxes = world.objects.boxes
  return ("menu: chosen=%d boxes=%d"):format(chosen, boxes and #boxes or 0)
end

return menu
