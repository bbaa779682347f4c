-- Step 6: the side from the distances between opposite sides.

local look = require("look")
local sides = require("lessons.sides")

local lesson = {
  title = "Which side? The shortest way out",
  text = [[
The rule that stays: measure how far box a would have to move to get out in each of the four
directions. That is the distance between a side of a and the opposite side of b. The smallest
distance names the side.

The widths and heights do not matter. In case 4 it is the only method that is right.

In the last case it is wrong, too: after one long step the box is more than half-way through.
A single moment cannot tell where it came from. That is why the library's update looks at the
path.]],
  code = [[
local right = a.x + a.width - b.x
local left = b.x + b.width - a.x
local bottom = a.y + a.height - b.y
local top = b.y + b.height - a.y
-- the smallest one is the side
physics.side(a, b)]],
  keys = sides.keys,
  load = sides.load,
  update = sides.update,
  keypressed = sides.keypressed,
  report = sides.report,
}

-- Draws one distance, beside the boxes; `isBest` marks the smallest.
local function drawDistance(name, distance, isBest, x1, y1, x2, y2)
  look.color(isBest and "lime" or "orange")
  love.graphics.setLineWidth(isBest and 4 or 2)
  love.graphics.line(x1, y1, x2, y2)
  love.graphics.circle("fill", x1, y1, 4)
  love.graphics.circle("fill", x2, y2, 4)
  look.color(isBest and "lime" or "white")
  local text = ("%s %.0f"):format(name, distance)
  if y1 == y2 then
    look.text(text, math.max(0, math.min(384, (x1 + x2) / 2 - 50)), y1 + 4, 14, 100, "center")
  else
    look.text(text, x1 + 9, math.min(y1, y2) - 4, 14)
  end
end

local function drawDistances(a, b)
  local right, left = a.x + a.width - b.x, b.x + b.width - a.x
  local bottom, top = a.y + a.height - b.y, b.y + b.height - a.y
  local best = sides.byOpposites()
  local under = math.max(a.y + a.height, b.y + b.height)
  local beside = a.x + a.width
  drawDistance("right", right, best == "right", b.x, under + 20, a.x + a.width, under + 20)
  drawDistance("left", left, best == "left", a.x, under + 54, b.x + b.width, under + 54)
  drawDistance("bottom", bottom, best == "bottom", beside + 14, b.y, beside + 14, a.y + a.height)
  drawDistance("top", top, best == "top", beside + 100, a.y, beside + 100, b.y + b.height)
end

function lesson.draw()
  sides.draw("opposites", drawDistances)
end

return lesson
