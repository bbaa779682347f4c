-- Step 7: bumping.

local hand = require("lessons.hand")
local look = require("look")
local physics = require("physics")

local lesson = {
  title = "Bumping",
  text = [[
The side is known. Now the boxes are moved apart until they are flush. Which one has to move?

Push the first: box a moves back all the way, b stands like a wall.

Push both: each moves half of the way. A crate gives way, and the box that pushes it gets slower.

Drag a into b and switch with space. A static box never gives way: then the other one moves the
whole way in both modes.]],
  keys = { { "space", "push first or both" } },
}

local mode = "both"
local a, b, wall ---@type physics.NewBox, physics.NewObject, physics.NewObject

function lesson.code()
  return ([[
local side = physics.checkCollision(a, b)
-- "right": a ran into the left side of b
-- a.x = b.x - a.width, or half of it for each

physics.bump(a, b, "%s")]]):format(mode)
end

function lesson.load()
  a = { x = 60, y = 150, width = 100, height = 90, color = "orange" }
  b = { x = 230, y = 130, width = 110, height = 130, color = "sky" }
  wall = { x = 444, y = 20, width = 40, height = 350, static = true, color = "slate" }
  hand.take({ a, b })
end

function lesson.keypressed(key)
  if key == "space" then
    mode = mode == "both" and "first" or "both"
  end
end

function lesson.update()
  physics.bump(a, b, mode)
  physics.bump(b, wall, mode)
  physics.bump(a, wall, mode)
end

function lesson.draw()
  for _, box in ipairs({ wall, b, a }) do
    look.box(box.x, box.y, box.width, box.height, box.color)
  end
  hand.label(a, "a")
  hand.label(b, "b")
  hand.draw()
  look.color("silver")
  look.text("push = ", 24, 424, 18)
  look.color("yellow")
  look.text('"' .. mode .. '"', 96, 424, 18)
  look.color("silver")
  look.text(("a.x = %.1f    b.x = %.1f"):format(a.x, b.x), 24, 454, 16)
end

function lesson.report()
  return ("a=%d gap=%s"):format(a.x, b.x - a.x - a.width)
end

return lesson
