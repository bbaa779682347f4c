-- The first screen: choose an example. The chosen one plays itself beside the list; boxes rain on
-- its picture, just because they can.

local input = require("input")
local look = require("look")
local physics = require("physics")
local preview = require("preview")
local source = require("source")
local view = require("view")

local menu = {}

local EXAMPLES = {
  { name = "platformer", title = "Platformer", text = "A level to play: run, jump, push, stomp." },
  { name = "hills", title = "Hills", text = "Slopes, stairs, a turtle, a mine cart." },
  { name = "tutorial", title = "Tutorial", text = "How such an engine works, in ten steps." },
  { name = "lifts", title = "Lifts", text = "Riders, belts, one-way shelves, a press." },
  { name = "topdown", title = "Top-down", text = "Rooms, narrow doors, crates, a ghost." },
  { name = "survivors", title = "Survivors", text = "Hundreds of enemies around you." },
  { name = "breakout", title = "Breakout", text = "Balls that bounce, bullets that hit." },
  { name = "rollback", title = "Rollback", text = "Football, and time that turns back." },
  { name = "online", title = "Online", text = "Football over a bad line, with rollback." },
  { name = "tiled", title = "Tiled", text = "A level from the editor, few rectangles." },
  { name = "rooms", title = "Rooms", text = "Several maps, checkpoints, a saved game." },
  { name = "marbles", title = "Marbles", text = "Slopes, bumpers, pegs, and a lift." },
  { name = "pile", title = "Pile", text = "What it costs to stack many boxes." },
}
local X, Y, WIDTH, HEIGHT, GAP = 40, 136, 440, 30, 4
local SHOW_X, SHOW_Y, SHOW_SCALE = 520, 122, 2 / 3
local SHOW_WIDTH, SHOW_HEIGHT = view.gameWidth * SHOW_SCALE, view.height * SHOW_SCALE
local COLORS = { "red", "orange", "yellow", "green", "sky", "blue", "plum" }
local MOST, KICK = 40, 420 -- boxes; px/s, at most

local chosen, comment = 1, nil
local mouseX, mouseY = 0, 0
local world, random, untilNext ---@type physics.World, any, number

--- Returns the entry of an example, `{ name =, title =, text = }`, which is the chosen one from now
--- on. Errors: there is no such one.
function menu.entry(name)
  for i, entry in ipairs(EXAMPLES) do
    if entry.name == name then
      chosen = i
      return entry
    end
  end
  error(('there is no example "%s"'):format(name))
end

local function choose(i)
  chosen, comment = i, source.comment(EXAMPLES[i].name)
  preview.load(EXAMPLES[i].name)
end

function menu.load()
  random = love.math.newRandomGenerator(2)
  untilNext = 0
  world = physics.newWorld({ gravity = 700 })
  local show = { x = SHOW_X, y = SHOW_Y, width = SHOW_WIDTH, height = SHOW_HEIGHT, static = true }
  world:add("shows", show)
  mouseX, mouseY = input.mouse()
  choose(chosen)
end

local function addBox()
  local size = random:random(18, 42)
  world:add("boxes", {
    x = random:random(SHOW_X + 10, SHOW_X + SHOW_WIDTH - 60),
    y = -80,
    width = size,
    height = random:random(18, 42),
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

local function kick(box)
  box.vx, box.vy = random:random(-KICK, KICK) / 3, -random:random(KICK / 2, KICK)
end

-- Returns the number of the example that has its entry at a point, or nil.
local function entryAt(x, y)
  for i = 1, #EXAMPLES do
    local top = Y + (i - 1) * (HEIGHT + GAP)
    if physics.inside(x, y, 0, 0, X, top, WIDTH, HEIGHT) then
      return i
    end
  end
end

function menu.update(dt)
  untilNext = untilNext - dt
  if untilNext <= 0 then
    untilNext = 0.2
    addBox()
  end
  world:update(dt)

  -- The mouse chooses when it moves, so that it does not fight with the keys.
  local x, y = input.mouse()
  if x ~= mouseX or y ~= mouseY then
    mouseX, mouseY = x, y
    local i = entryAt(x, y)
    if i and i ~= chosen then
      choose(i)
    end
  end
  preview.update(dt)
end

local function drawBoxes()
  for _, box in ipairs(world.objects.boxes or {}) do
    look.box(box.x, box.y, box.width, box.height, box.color)
    local dx, dy = mouseX - box.x, mouseY - box.y
    local share = 1 / math.max(1, math.sqrt(dx * dx + dy * dy))
    look.eyes(box.x, box.y, box.width, box.height, dx * share, dy * share)
  end
end

local function drawEntry(entry, y, isChosen)
  look.panel(X, y, WIDTH, HEIGHT)
  if isChosen then
    look.color("blue")
    love.graphics.rectangle("fill", X, y, WIDTH, HEIGHT, 10)
  end
  look.color("white", isChosen and 1 or 0.8)
  look.text(entry.title, X + 18, y + 3, 20)
  look.color(isChosen and "white" or "silver", isChosen and 1 or 0.8)
  look.text(entry.text, X + 142, y + 7, 14)
end

local function drawShow()
  look.color("sky")
  love.graphics.rectangle("fill", SHOW_X - 3, SHOW_Y, SHOW_WIDTH + 6, SHOW_HEIGHT + 3, 4)
  preview.draw(SHOW_X, SHOW_Y + 3, SHOW_SCALE)
  look.color("silver")
  look.text(comment, SHOW_X, SHOW_Y + SHOW_HEIGHT + 14, 15, SHOW_WIDTH)
end

function menu.draw()
  look.sky("night", "navy")
  look.color("white")
  look.text("physics.lua", X, 28, 54)
  look.color("silver")
  look.text("2D physics for games made of boxes, slopes and balls", X + 3, 100, 18)
  for i, entry in ipairs(EXAMPLES) do
    drawEntry(entry, Y + (i - 1) * (HEIGHT + GAP), i == chosen)
  end
  drawBoxes()
  drawShow()
  look.keys({ { "up", "down", "mouse", "choose" }, { "enter", "click", "play" } }, X, 588)
end

--- Returns the name of the example to show when one was started.
function menu.keypressed(key)
  if key == "up" then
    choose((chosen - 2) % #EXAMPLES + 1)
  elseif key == "down" then
    choose(chosen % #EXAMPLES + 1)
  elseif key == "return" or key == "kpenter" or key == "space" then
    return EXAMPLES[chosen].name
  elseif key == "escape" and love.system.getOS() ~= "Web" then
    love.event.quit() -- in a browser nothing would be left to come back to
  end
end

--- Likewise. A click on a box kicks it.
function menu.mousepressed(x, y)
  local box = world:queryPoint(x, y, "boxes")[1]
  local i = entryAt(x, y)
  if box then
    kick(box)
  elseif i then
    return EXAMPLES[i].name
  elseif physics.inside(x, y, 0, 0, SHOW_X, SHOW_Y, SHOW_WIDTH, SHOW_HEIGHT) then
    return EXAMPLES[chosen].name
  end
end

function menu.report()
  local boxes = world.objects.boxes
  return ("menu: chosen=%d boxes=%d"):format(chosen, boxes and #boxes or 0)
end

return menu
