-- Step 9: masks, static and active.

local hand = require("lessons.hand")
local look = require("look")
local physics = require("physics")

local lesson = {
  title = "What meets what",
  text = [[
Three switches decide how an object meets the others.

A mask names the groups that it passes through: the ghost falls through clouds and stands on
the floor.

A static object never moves and is never pushed. It is read only once, so tell the world after
you change it.

An object that is not active is out of the game until you switch it on again: the trapdoor
opens.]],
  keys = { { "1", "2", "3", "switch" } },
}

local WIDTH = 160 -- px, of one column
local FLOOR = 440

local world ---@type physics.World
local ghost ---@type physics.Object
local block ---@type physics.NewBox
local door ---@type physics.NewBox
local isMasked, isStatic, isActive ---@type boolean, boolean, boolean

function lesson.code()
  local text = [[
ghost.mask = { clouds = %s }
block.static = %s
world:refresh(block)
door.active = %s
world:refresh(door)]]
  return text:format(tostring(not isMasked), tostring(isStatic), tostring(isActive))
end

local function newBox(x, y, color)
  return { x = x, y = y, width = 44, height = 44, color = color, friction = 0.5 }
end

function lesson.load()
  world = physics.newWorld({ gravity = 800 })
  lesson.world = world
  isMasked, isStatic, isActive = true, true, true
  world:add("floor", { x = 0, y = FLOOR, width = 484, height = 56, static = true, color = "slate" })
  local cloud = { x = 10, y = 250, width = 140, height = 20, static = true, color = "silver" }
  world:add("clouds", cloud)
  ghost = world:add("ghosts", newBox(30, 90, "white"))
  ghost.mask = { clouds = false }
  local knight = world:add("boxes", newBox(92, 90, "orange"))

  block = { x = 180, y = 250, width = 124, height = 40, static = true, color = "green", mass = 4 }
  block.friction = 0.5
  world:add("blocks", block)
  local rider = world:add("boxes", newBox(220, 90, "orange"))

  door = { x = 334, y = 250, width = 140, height = 16, static = true, color = "red" }
  world:add("doors", door)
  local left = world:add("boxes", newBox(350, 90, "orange"))
  local right = world:add("boxes", newBox(414, 40, "orange"))
  hand.take({ ghost, knight, rider, left, right }, true)
end

function lesson.keypressed(key)
  if key == "1" then
    isMasked = not isMasked
    ghost.mask = { clouds = not isMasked }
    ghost.x, ghost.y, ghost.vy = 30, 90, 0
  elseif key == "2" then
    isStatic = not isStatic
    block.static = isStatic
    world:refresh(block)
  elseif key == "3" then
    isActive = not isActive
    door.active = isActive
    world:refresh(door)
  end
end

function lesson.update(dt)
  world:update(dt)
end

local function drawObject(object, alpha)
  look.box(object.x, object.y, object.width, object.height, object.color, alpha)
end

local NAMES = { "1  mask", "2  static", "3  active" }

function lesson.draw()
  for i, name in ipairs(NAMES) do
    look.color("silver")
    look.text(name, (i - 1) * WIDTH, 10, 16, WIDTH, "center")
  end
  for _, group in ipairs({ "floor", "clouds", "blocks", "doors", "ghosts", "boxes" }) do
    for _, object in ipairs(world.objects[group]) do
      drawObject(object, object.active == false and 0.2 or object == ghost and 0.7 or 1)
    end
  end
  look.eyes(ghost.x, ghost.y, ghost.width, ghost.height, 0, 0)
  hand.draw()
end

function lesson.report()
  local lowest = 0 ---@type number
  for _, box in ipairs(world.objects.boxes) do
    lowest = math.max(lowest, box.y + box.height)
  end
  return ("ghost=%s block=%s lowest=%s"):format(ghost.y + 44, block.y + 40, lowest)
end

return lesson
