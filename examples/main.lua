-- Start with `love examples` from the folder of the library, or one of them: `love examples hills`.
--
-- The menu and each example are screens: tables with the functions load(), update(dt), draw(),
-- report(), which returns "name: value=1 other=2", and, if they like, keypressed(key, isRepeat),
-- mousepressed(x, y), and leave(), for when another screen comes. An example draws 960x640 px and
-- also has: keys, the hints for the bar at the bottom; world, the world that the frame around it
-- (frame.lua) measures and makes visible; and, if its picture scrolls, camera(), which returns the
-- x, y of the world at the top-left corner, and the scale if that is not 1. Its load() gets the
-- words behind its name in the command line. A new one is entered in the list of menu.lua.
--
-- For tests: `love examples --say` prints a line when a screen has started, and then one a second:
--
--   example menu started
--   example platformer started
--   example platformer second 1: x=160 y=486 coins=0 deaths=0 won=false
--
-- The first word is always "example", the second the screen's name, as in `--example=NAME`. x, y is
-- the place of what the arrow keys move, in px: the player (platformer, hills, lifts, topdown,
-- tiled), the paddle (breakout), the blue player (rollback, online). Where there is none other
-- values tell of the keys: menu (down) chosen=, tutorial (right) page=, pile (up) boxes=, marbles
-- (up) marbles=. The seconds are those of the clock: the lines go on while the game is paused.
-- Where no arguments can be given, as in a browser, two files beside main.lua do the same: say.txt
-- (it only has to be there) for --say, and start.txt, which holds a name, for --example=NAME. An
-- argument goes first.

-- The library lies beside this folder. Inside of a .love the line does no harm.
package.path = love.filesystem.getSource() .. "/../?.lua;" .. package.path

local frame = require("frame")
local menu = require("menu")
local say = require("say")
local script = require("script")
local view = require("view")

local screen ---@type table

local function leave()
  if screen and screen.leave then
    screen.leave()
  end
end

-- Shows another screen, or nothing new when there is no name. The words are for its `load`.
local function show(name, ...)
  if name then
    leave()
    screen = name == "menu" and menu or frame.around(menu.entry(name))
    screen.load(...)
    say.start(name)
  end
end

-- Returns the first word of a file beside this one, "" when it is empty, nil when there is none.
local function readWord(file)
  local text = love.filesystem.getInfo(file) and love.filesystem.read(file)
  return text and (text:match("%S+") or "")
end

function love.load(arguments)
  love.keyboard.setKeyRepeat(true)
  say.isOn = say.isOn or readWord("say.txt") ~= nil
  local name, word1, word2 = script.readWords(arguments)
  show(name or readWord("start.txt") or "menu", word1, word2)
end

function love.quit()
  leave()
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
  view.draw(screen.draw)
end

function love.keypressed(key, _, isRepeat)
  if key == "f11" then
    love.window.setFullscreen(not love.window.getFullscreen())
  else
    show(screen.keypressed(key, isRepeat))
  end
end

function love.mousepressed(x, y, button)
  if button == 1 then
    show(screen.mousepressed(view.toPicture(x, y)))
  end
end
