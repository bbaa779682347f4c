-- Step 3: the intersection rectangle.

local hand = require("lessons.hand")
local look = require("look")
local physics = require("physics")

local lesson = {
  title = "The rectangle they share",
  text = [[
Better: compute the rectangle that both boxes cover. It starts at the larger of the two left
edges and ends at the smaller of the two right edges, and the same from top to bottom.

If its width and height are above 0, the boxes overlap, whatever their sizes and places.

A width of exactly 0 means side by side: they touch and share nothing. Whether that counts is
your choice. Space switches it; drag a until it snaps to b.]],
  code = [[
local left = math.max(a.x, b.x)
local right = math.min(a.x + a.width, b.x + b.width)
local width = right - left

physics.checkCollision(a, b, sideBySide)]],
  keys = { { "space", "side by side counts" } },
}

local SNAP = 6 -- px
local sideBySide = false
local a, b ---@type physics.Box, physics.Box

function lesson.load()
  a = { x = 90, y = 80, width = 170, height = 130 }
  b = { x = 200, y = 150, width = 200, height = 140 }
  hand.take({ a, b })
end

function lesson.keypressed(key)
  if key == "space" then
    sideBySide = not sideBySide
  end
end

-- Makes it easy to put a exactly beside b.
function lesson.update()
  if math.abs(a.x + a.width - b.x) < SNAP then
    a.x = b.x - a.width
  elseif math.abs(b.x + b.width - a.x) < SNAP then
    a.x = b.x + b.width
  end
  if math.abs(a.y + a.height - b.y) < SNAP then
    a.y = b.y - a.height
  elseif math.abs(b.y + b.height - a.y) < SNAP then
    a.y = b.y + b.height
  end
end

local function drawShared()
  local left, top = math.max(a.x, b.x), math.max(a.y, b.y)
  local width = math.min(a.x + a.width, b.x + b.width) - left
  local height = math.min(a.y + a.height, b.y + b.height) - top
  if width >= 0 and height >= 0 then
    look.color("yellow")
    love.graphics.rectangle("fill", left - 1, top - 1, width + 2, height + 2)
    look.color("white")
    love.graphics.circle("fill", left, top, 5)
    love.graphics.circle("fill", left + width, top + height, 5)
  end
  look.color("silver")
  look.text(("width %.0f, height %.0f"):format(width, height), 24, 396, 16)
end

function lesson.report()
  return "side=" .. tostring(physics.checkCollision(a, b, sideBySide))
end

function lesson.draw()
  look.box(a.x, a.y, a.width, a.height, "orange", 0.9)
  look.box(b.x, b.y, b.width, b.height, "sky", 0.75)
  hand.label(a, "a")
  hand.label(b, "b")
  hand.draw()
  drawShared()
  local side = physics.checkCollision(a, b, sideBySide)
  look.text("sideBySide = " .. tostring(sideBySide), 24, 424, 16)
  look.color(side and "lime" or "orange")
  look.text("checkCollision: " .. tostring(side and '"' .. side .. '"' or false), 24, 452, 16)
end

return lesson
