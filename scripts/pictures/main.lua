-- Draws the pictures of docs/guide/ with `world:draw`, one scene each; films the clips of README:
--
--   love scripts/pictures guide-contacts build/guide-contacts.png
--   love scripts/pictures seams build/film/seams 40      40 frames, 0001.png and so on
--   love scripts/pictures platformer3 build/platformer3.png      a step of docs/platformers.md

package.path = love.filesystem.getSource() .. "/../../?.lua;" .. package.path
local clips = require("scripts.pictures.clips")
local scenes = require("scripts.pictures.scenes")
local steps = require("scripts.pictures.steps")

local name, path, frames
local frame = 0
local play, draw

local function write(image, to)
  local file = assert(io.open(to, "wb"))
  file:write(image:encode("png"):getString())
  file:close()
end

-- Draws once, and writes the picture.
local function drawStill()
  draw()
  love.graphics.captureScreenshot(function(image)
    write(image, path)
    love.event.quit()
  end)
end

function love.load(arguments)
  name, path, frames = arguments[1], arguments[2], tonumber(arguments[3])
  love.graphics.setBackgroundColor(0.1, 0.11, 0.17)
  if clips[name] then
    love.window.setMode(640, 360)
    play, draw = clips[name]()
  elseif scenes[name] then
    love.graphics.setFont(love.graphics.newFont(13))
    draw = scenes[name]
  else
    love.window.setMode(800, 600)
    love.graphics.setBackgroundColor(0.1, 0.11, 0.17)
    draw = steps.play(name)
    love.draw, love.update = drawStill, nil
  end
end

local function film()
  play()
  frame = frame + 1
  draw()
  local number, isLast = frame, frame == frames
  love.graphics.captureScreenshot(function(image)
    write(image, ("%s/%04d.png"):format(path, number))
    if isLast then
      love.event.quit()
    end
  end)
end

function love.draw()
  if play then
    film()
  else
    drawStill()
  end
end
