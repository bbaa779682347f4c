-- What steps 4 to 6 share: the cases, and the three ways to find the side that was hit.

local hand = require("lessons.hand")
local look = require("look")
local physics = require("physics")

local sides = {}

-- Box a always fell from above onto b: "bottom" is the right answer. Numbers: x, y, width, height.
local CASES = {
  { "a box lands on a wide one", { 200, 96, 80, 80 }, { 80, 158, 320, 60 } },
  { "a box lands beside the middle", { 60, 100, 84, 84 }, { 50, 174, 390, 20 } },
  { "a post sinks into the ground", { 250, 80, 30, 110 }, { 60, 148, 370, 70 } },
  { "a wide thin box under a medium one", { 84, 104, 38, 86 }, { 46, 150, 390, 42 } },
  { "fallen too far in one frame", { 200, 130, 70, 70 }, { 50, 142, 390, 16 } },
}
local TRUTH = "bottom"

local case = 1
local a, b ---@type physics.Box, physics.Box
-- while you have not moved the boxes, the right answer is known
local isUntouched ---@type boolean

local function boxFrom(numbers)
  return { x = numbers[1], y = numbers[2], width = numbers[3], height = numbers[4] }
end

local function isAsGiven()
  return a.x == CASES[case][2][1]
    and a.y == CASES[case][2][2]
    and b.x == CASES[case][3][1]
    and b.y == CASES[case][3][2]
end

--- Sets the boxes of the case that is shown.
function sides.load()
  a, b = boxFrom(CASES[case][2]), boxFrom(CASES[case][3])
  hand.take({ a, b })
  isUntouched = true
end

function sides.update()
  isUntouched = isUntouched and isAsGiven()
end

function sides.keypressed(key)
  if key == "space" then
    case = case % #CASES + 1
    sides.load()
  elseif tonumber(key) and CASES[tonumber(key)] then
    case = tonumber(key) --[[@as integer]]
    sides.load()
  end
end

-- ------------------------------------------------------------------------------- the three ways --

--- Returns the width and height of what the boxes share, and where it begins.
function sides.shared()
  local left, top = math.max(a.x, b.x), math.max(a.y, b.y)
  local width = math.min(a.x + a.width, b.x + b.width) - left
  local height = math.min(a.y + a.height, b.y + b.height) - top
  return width, height, left, top
end

--- First way: a flat overlap was a vertical hit, a tall one a horizontal hit.
function sides.byShape()
  local width, height = sides.shared()
  if width > height then
    return a.y < b.y and "bottom" or "top"
  end
  return a.x < b.x and "right" or "left"
end

--- Returns the way from the middle of b to the middle of a.
function sides.middles()
  return a.x + a.width / 2 - b.x - b.width / 2, a.y + a.height / 2 - b.y - b.height / 2
end

--- Second way: the longer distance between the middles names the axis.
function sides.byMiddles()
  local dx, dy = sides.middles()
  if math.abs(dx) > math.abs(dy) then
    return dx < 0 and "right" or "left"
  end
  return dy < 0 and "bottom" or "top"
end

--- Third way, the library's: the smallest of the four distances between opposite sides.
function sides.byOpposites()
  return physics.side(a, b)
end

-- ----------------------------------------------------------------------------------------- draw --

local function drawVerdict(name, side, x, isShown)
  local isRight = side == TRUTH
  look.color(isShown and "navy" or "night")
  love.graphics.rectangle("fill", x, 384, 142, 96, 8)
  if isShown then
    look.color("sky")
    love.graphics.setLineWidth(2)
    love.graphics.rectangle("line", x, 384, 142, 96, 8)
  end
  look.color("silver")
  look.text(name, x, 394, 13, 142, "center")
  if isUntouched then
    look.color(isRight and "lime" or "orange")
  else
    look.color("white")
  end
  look.text(side, x, 416, 24, 142, "center")
  if isUntouched then
    look.text(isRight and "is right" or "is wrong", x, 452, 13, 142, "center")
  end
end

-- The way that box a came: from above.
local function drawFall()
  local x = a.x + a.width / 2
  look.color("silver", 0.5)
  love.graphics.setLineWidth(2)
  love.graphics.rectangle("line", a.x, 30, a.width, math.min(a.height, a.y - 60), 4)
  love.graphics.line(x, 40, x, a.y - 12)
  love.graphics.polygon("fill", x - 6, a.y - 14, x + 6, a.y - 14, x, a.y - 4)
end

--- Draws the boxes and the three verdicts; `drawWay(a, b)` shows how one of them, `shown`, works.
function sides.draw(shown, drawWay)
  look.color("silver")
  local title = isUntouched and ("%d. %s"):format(case, CASES[case][1]) or "moved by hand"
  look.text(title, 0, 6, 15, 484, "center")
  if isUntouched then
    drawFall()
  end
  look.box(b.x, b.y, b.width, b.height, "sky", 0.8)
  look.box(a.x, a.y, a.width, a.height, "orange", 0.8)
  hand.draw()
  if not physics.checkCollision(a, b) then
    look.color("silver")
    look.text("they do not overlap", 0, 420, 16, 484, "center")
    return
  end
  drawWay(a, b)
  drawVerdict("shape of the overlap", sides.byShape(), 16, shown == "shape")
  drawVerdict("middle to middle", sides.byMiddles(), 171, shown == "middles")
  drawVerdict("opposite sides", sides.byOpposites(), 326, shown == "opposites")
end

--- Returns the three verdicts in one line.
function sides.report()
  local text = "shape=%s middles=%s opposites=%s"
  return text:format(sides.byShape(), sides.byMiddles(), sides.byOpposites())
end

sides.keys = { { "space", "next case" } }

return sides
