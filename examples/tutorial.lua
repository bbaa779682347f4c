-- "Making a Simple 2D Physics Engine": the tutorial from which this library grew, in ten steps to
-- play with. Move the boxes with the mouse or the keys, and watch what the code says.
--
-- This file turns the pages; each step is one file in lessons/.

local hand = require("lessons.hand")
local look = require("look")
local view = require("view")

local tutorial = {}

local LESSONS = {
  "objects",
  "inside",
  "overlap",
  "side_by_shape",
  "side_by_middles",
  "side_by_opposites",
  "bump",
  "forces",
  "masks",
  "optimize",
}
local SCENE_X, SCENE_Y, SCENE_WIDTH, SCENE_HEIGHT = 460, 76, 484, 508
local TEXT_X, TEXT_WIDTH = 18, 428
local TEXT_SIZE, CODE_SIZE, CODE_LINE = 19, 15, 21

local page = 1
local lesson ---@type table

local function open(number)
  page = number
  lesson = require("lessons." .. LESSONS[page]) --[[@as table]]
  hand.release()
  lesson.load()
  tutorial.keys = { { "left", "right", "page" } }
  for _, hint in ipairs(lesson.keys or {}) do
    table.insert(tutorial.keys, hint)
  end
  if hand.isBusy() then
    table.insert(tutorial.keys, { "mouse", "w", "a", "s", "d", "move" })
    table.insert(tutorial.keys, { "tab", "next box" })
  end
end

function tutorial.load()
  open(1)
end

--- Starts the page again, not the whole tutorial.
function tutorial.restart()
  open(page)
end

function tutorial.update(dt)
  hand.update(dt, SCENE_X, SCENE_Y)
  lesson.update(dt)
  tutorial.world = lesson.world
end

function tutorial.keypressed(key, isRepeat)
  if (key == "right" or key == "pagedown") and page < #LESSONS then
    open(page + 1)
  elseif (key == "left" or key == "pageup") and page > 1 then
    open(page - 1)
  elseif key == "tab" then
    hand.choose()
  elseif lesson.keypressed and not isRepeat then
    lesson.keypressed(key)
  end
end

-- The texts are broken into lines to suit the editor; only an empty line or a dash means a new one.
local function reflow(text)
  return (text:gsub("\n\n", "\0"):gsub("\n([^-])", " %1"):gsub("%z", "\n\n"))
end

local function drawCode()
  local code = type(lesson.code) == "function" and lesson.code() or lesson.code
  local _, lines = (code .. "\n"):gsub("\n", "")
  local height = lines * CODE_LINE + 22
  local y = SCENE_Y + SCENE_HEIGHT - height
  look.panel(TEXT_X, y, TEXT_WIDTH, height)
  y = y + 11
  for line in (code .. "\n"):gmatch("([^\n]*)\n") do
    local words, comment = line:match("^(.-)(%-%-.*)$")
    look.color("yellow")
    local font = look.text(words or line, TEXT_X + 14, y, CODE_SIZE)
    if comment then
      look.color("silver")
      look.text(comment, TEXT_X + 14 + font:getWidth(words), y, CODE_SIZE)
    end
    y = y + CODE_LINE
  end
end

local function drawPages()
  for i = 1, #LESSONS do
    look.color(i == page and "sky" or "slate")
    love.graphics.circle("fill", 700 + i * 22, 44, i == page and 7 or 4)
  end
end

function tutorial.draw()
  look.sky("night", "navy")
  look.color("sky")
  look.text(tostring(page), TEXT_X, 26, 30)
  look.color("white")
  look.text(lesson.title, TEXT_X + (page < 10 and 36 or 54), 28, 26)
  look.color("white", 0.9)
  look.text(reflow(lesson.text), TEXT_X, SCENE_Y + 2, TEXT_SIZE, TEXT_WIDTH)
  drawCode()
  drawPages()

  look.panel(SCENE_X, SCENE_Y, SCENE_WIDTH, SCENE_HEIGHT)
  love.graphics.push()
  love.graphics.translate(SCENE_X, SCENE_Y)
  view.clip(0, 0, SCENE_WIDTH, SCENE_HEIGHT, lesson.draw)
  love.graphics.pop()
end

--- Returns the point of the scene at the top-left corner of the picture.
function tutorial.camera()
  return -SCENE_X, -SCENE_Y
end

function tutorial.report()
  return ("tutorial: page=%d %s"):format(page, lesson.report and lesson.report() or "")
end

return tutorial
