-- Step 1: objects are tables, in groups or not.

local hand = require("lessons.hand")
local look = require("look")
local physics = require("physics")

local lesson = {
  title = "Objects are tables",
  text = [[
A table with a place and a size is an object. It is your own table: add whatever your game
needs, such as a picture, a name, some points. The engine reads x, y, width and height and
writes new places back.

Sort the objects into groups, one table for each kind, or put them side by side into one table.
Keys may be numbers or names. You may mix both forms; the boxes on the right behave the same.]],
  keys = { { "space", "other form" } },
}

local isGrouped = true
-- named: { label, object } in the order of the listing
local world, named ---@type physics.World, table

local GROUPED = [[
objects = {
  floor = { x = 0, y = 440, ..., static = true },
  boxes = { box, box },
  enemies = { spike = enemy, cannon = enemy },
}
table.insert(objects.boxes, box)
world:add("boxes", box)  -- the same]]

local SINGLE = [[
objects = {
  floor = { x = 0, y = 440, ..., static = true },
  player = box,
  spike = enemy,
  box, box,
}
objects.box = box
table.insert(objects, box)]]

function lesson.code()
  return isGrouped and GROUPED or SINGLE
end

local function newBox(x, y, width, height, color)
  return { x = x, y = y, width = width, height = height, color = color, friction = 0.6 }
end

function lesson.load()
  world = physics.newWorld({ gravity = 800 })
  lesson.world = world
  local a = newBox(60, 40, 90, 60, "orange")
  local b = newBox(90, 150, 110, 60, "orange")
  local c = newBox(70, 260, 100, 70, "orange")
  local d = newBox(250, 120, 90, 60, "sky")
  local e = newBox(320, 220, 110, 80, "sky")
  local floor = { x = 0, y = 440, width = 484, height = 56, static = true, color = "slate" }
  if isGrouped then
    world.objects = { floor = floor, boxes = { a, b, c }, enemies = { spike = d, cannon = e } }
    named = {
      { "boxes[1]", a },
      { "boxes[2]", b },
      { "boxes[3]", c },
      { "enemies\n.spike", d },
      { "enemies\n.cannon", e },
    }
  else
    world.objects = { floor = floor, a, b, box = c, spike = d, player = e }
    named = { { "[1]", a }, { "[2]", b }, { "box", c }, { "spike", d }, { "player", e } }
  end
  table.insert(named, { "floor", floor })
  hand.take({ a, b, c, d, e }, true)
end

function lesson.keypressed(key)
  if key == "space" then
    isGrouped = not isGrouped
    lesson.load()
  end
end

function lesson.update(dt)
  world:update(dt)
end

function lesson.draw()
  for _, entry in ipairs(named) do
    local label, object = entry[1], entry[2]
    look.box(object.x, object.y, object.width, object.height, object.color)
    look.color("night")
    local top = object.y + object.height / 2 - (label:find("\n") and 18 or 9)
    look.text(label, object.x, top, 14, object.width, "center")
  end
  hand.draw()
end

return lesson
