-- Start with `love examples` from the folder of the library. The menu and each example are screens:
-- tables with the functions load, update, draw, report and, if they like, keypressed, mousepressed.
--
-- For tests: `love examples --say` prints a line when a screen has started, and then one a second:
--
--   example menu started
--   example platformer started
--   example platformer second 1: x=160 y=486 coins=0 deaths=0 won=false
--
-- The first word is always "example", the second the screen's name, as in `--example=NAME`. x, y is
-- the place of who the arrow keys move, in px: the player (platformer, lifts, topdown), the paddle
-- (breakout), the blue player (rollback). Where there is none other values tell of the keys: menu
-- (down) chosen=, tutorial (right) page=, pile (up) boxes=. The seconds are those of the clock: the
-- lines go on while the game is paused. Where no arguments can be given, as in a browser, two files beside main.lua
-- do the same: say.txt (it only has to be there) for --say, and start.txt, which holds a name, for
-- --example=NAME. An argument goes first.

-- The library lies beside this folder. Inside of a .love the line does no harm.
package.path = love.filesystem.getSource() .. "/../?.lua;" .. package.path

local menu = require("menu")
local say = require("say")
local script = require("script")

local screen

local function show(name)
  screen = name == "menu" and menu or require(name)
  screen.load()
  say.start(name)
end

-- Returns the first word of a file beside this one, "" when it is empty, nil when there is none.
local function readWord(file)
  local text = love.filesystem.getInfo(file) and love.filesystem.read(file)
  return text and (text:match("%S+") or "")
end

function love.load()
  love.keyboard.setKeyRepeat(true)
  say.isOn = say.isOn or readWord("say.txt") ~= nil
  show(script.example or readWord("start.txt") or "menu")
end

local function update(dt)
  screen.update(dt)
  say.update(dt, screen.report) -- with the time of the clock, whatever the screen makes of it
end

function love.update(dt)
  if script.isOn then
    script.update(update, screen.report)
  else
    update(dt)
  end
end

function love.draw()
  screen.draw()
end

function love.keypressed(key, _, isRepeat)
  if key == "escape" and not isRepeat then
    if screen == menu then
      love.event.quit()
    else
      show("menu")
    end
  elseif screen.keypressed then
    local chosen = screen.keypressed(key, isRepeat)
    if chosen then
      show(chosen)
    end
  end
end

function love.mousepressed(x, y, button)
  if button == 1 and screen.mousepressed then
    local chosen = screen.mousepressed(x, y)
    if chosen then
      show(chosen)
    end
  end
end
