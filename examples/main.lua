-- Start with `love examples` from the folder of the library. The menu and each example are screens:
-- tables with the functions load, update, draw, report and, if they like, keypressed, mousepressed.

-- The library lies beside this folder. Inside of a .love the line does no harm.
package.path = love.filesystem.getSource() .. "/../?.lua;" .. package.path

local menu = require("menu")
local script = require("script")

local screen

local function show(name)
  screen = name == "menu" and menu or require(name)
  screen.load()
end

function love.load()
  love.keyboard.setKeyRepeat(true)
  show(script.example or "menu")
end

function love.update(dt)
  if script.isOn then
    script.update(screen.update, screen.report)
  else
    screen.update(dt)
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
