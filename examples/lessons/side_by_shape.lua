-- Step 4: the side from the shape of the overlap.

local look = require("look")
local sides = require("lessons.sides")

local lesson = {
  title = "Which side? The shape of the overlap",
  text = [[
To push a box out you must know which side was hit. Look at the rectangle that both share. When
a box lands on another one, it is wide and flat. When it runs into a wall, it is narrow and
tall.

Which of the two sides it is depends on which box is further left, or higher.

Go through the cases with space. A thin post that sank deeper than it is wide looks like one
that ran into a wall.]],
  code = [[
if width > height then
  side = a.y < b.y and "bottom" or "top"
else
  side = a.x < b.x and "right" or "left"
end]],
  keys = sides.keys,
  load = sides.load,
  update = sides.update,
  keypressed = sides.keypressed,
  report = sides.report,
}

local function drawShape()
  local width, height, left, top = sides.shared()
  look.color("yellow")
  love.graphics.rectangle("fill", left, top, width, height)
  look.color("white")
  local size = ("%.0f wide, %.0f tall"):format(width, height)
  look.text(size, left + width / 2 - 100, 250, 15, 200, "center")
  look.color("yellow", 0.6)
  love.graphics.setLineWidth(1)
  love.graphics.line(left + width / 2, top + height, left + width / 2, 248)
end

function lesson.draw()
  sides.draw("shape", drawShape)
end

return lesson
