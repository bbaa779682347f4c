-- Step 5: the side from the middles.

local look = require("look")
local sides = require("lessons.sides")

local lesson = {
  title = "Which side? From middle to middle",
  text = [[
Another idea: draw a line from the middle of one box to the middle of the other. If it runs more
sideways than up or down, a left or right side was hit, otherwise a top or bottom.

One step gives the axis and the direction. With boxes of about the same size it is right.

With a wide box it is wrong: a box that lands near its end is far from its middle, and is pushed
off the floor sideways. Case 4 fools both methods at once.]],
  code = [[
local dx = a.x + a.width / 2 - (b.x + b.width / 2)
local dy = a.y + a.height / 2 - (b.y + b.height / 2)
if math.abs(dx) > math.abs(dy) then
  side = dx < 0 and "right" or "left"
else
  side = dy < 0 and "bottom" or "top"
end]],
  keys = sides.keys,
  load = sides.load,
  update = sides.update,
  keypressed = sides.keypressed,
  report = sides.report,
}

local function drawMiddles(a, b)
  local dx, dy = sides.middles()
  local x, y = b.x + b.width / 2, b.y + b.height / 2
  love.graphics.setLineWidth(3)
  look.color(math.abs(dx) > math.abs(dy) and "lime" or "orange")
  love.graphics.line(x, y, x + dx, y)
  look.color(math.abs(dx) > math.abs(dy) and "orange" or "lime")
  love.graphics.line(x + dx, y, x + dx, y + dy)
  look.color("white")
  love.graphics.line(x, y, x + dx, y + dy)
  love.graphics.circle("fill", x, y, 5)
  love.graphics.circle("fill", a.x + a.width / 2, a.y + a.height / 2, 5)
  local text = ("%.0f sideways, %.0f up or down"):format(math.abs(dx), math.abs(dy))
  look.text(text, 0, 250, 15, 484, "center")
end

function lesson.draw()
  sides.draw("middles", drawMiddles)
end

return lesson
