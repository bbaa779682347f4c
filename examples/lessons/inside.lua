-- Step 2: inside, and the four corners.

local hand = require("lessons.hand")
local look = require("look")
local physics = require("physics")

local lesson = {
  title = "Is a corner inside?",
  text = [[
The first idea: two boxes touch when a corner of one is inside the other. A corner is a box
without size, so one small function is enough.

Test the corners of both boxes. Otherwise you miss a small box inside a big one.

It is still not enough. Space shows three arrangements. In the last one the boxes cross, and no
corner is inside a box.]],
  code = [[
function inside(x1, y1, w1, h1, x2, y2, w2, h2)
  return x1 >= x2 and x1 + w1 < x2 + w2
    and y1 >= y2 and y1 + h1 < y2 + h2
end

inside(a.x, a.y, 0, 0, b.x, b.y, b.width, b.height)]],
  keys = { { "space", "next arrangement" } },
}

-- x, y, width, height of a and of b
local CASES = {
  { 90, 90, 150, 110, 190, 160, 190, 150 },
  { 80, 60, 320, 240, 190, 140, 90, 80 },
  { 60, 160, 360, 70, 200, 50, 80, 280 },
}

local case = 1
local a, b ---@type physics.Box, physics.Box

function lesson.load()
  local n = CASES[case]
  a = { x = n[1], y = n[2], width = n[3], height = n[4] }
  b = { x = n[5], y = n[6], width = n[7], height = n[8] }
  hand.take({ a, b })
end

function lesson.keypressed(key)
  if key == "space" then
    case = case % #CASES + 1
    lesson.load()
  end
end

function lesson.update() end

-- Draws the corners of a box and returns how many of them lie in the other.
local function drawCorners(box, other)
  local count = 0
  for i = 0, 3 do
    local x, y = box.x + i % 2 * box.width, box.y + math.floor(i / 2) * box.height
    local isIn = physics.inside(x, y, 0, 0, other.x, other.y, other.width, other.height)
    count = count + (isIn and 1 or 0)
    look.color(isIn and "lime" or "red")
    love.graphics.circle("fill", x, y, 8)
    look.color("night")
    love.graphics.circle("line", x, y, 8)
  end
  return count
end

local function drawAnswer(text, yes, y)
  look.color("silver")
  look.text(text, 24, y, 16)
  look.color(yes and "lime" or "orange")
  look.text(yes and "yes" or "no", 400, y, 16)
end

function lesson.report()
  return "overlap=" .. tostring(physics.checkCollision(a, b) and true)
end

function lesson.draw()
  look.box(a.x, a.y, a.width, a.height, "orange", 0.9)
  look.box(b.x, b.y, b.width, b.height, "sky", 0.75)
  hand.label(a, "a")
  hand.label(b, "b")
  hand.draw()
  love.graphics.setLineWidth(2)
  local ofA, ofB = drawCorners(a, b), drawCorners(b, a)
  drawAnswer("a corner of a is inside of b", ofA > 0, 396)
  drawAnswer("a corner of b is inside of a", ofB > 0, 424)
  drawAnswer("they really overlap", physics.checkCollision(a, b) and true, 452)
end

return lesson
