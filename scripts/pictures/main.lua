-- Draws the pictures of docs/guide/ with `world:draw`, one scene each; films the clips of README:
--
--   love scripts/pictures guide-contacts build/guide-contacts.png
--   love scripts/pictures seams build/film/seams 40      40 frames, 0001.png and so on

package.path = love.filesystem.getSource() .. "/../../?.lua;" .. package.path
local clips = require("scripts.pictures.clips")
local scenes = require("scripts.pictures.scenes")

local name, path, frames
local frame = 0
local play, draw

local function write(image, to)
  local file = assert(io.open(to, "wb"))
  file:write(image:encode("png"):getString())
  file:close()
end

function love.load(arguments)
  name, path, frames = arguments[1], arguments[2], tonumber(arguments[3])
  assert(scenes[name] or clips[name], "no scene " .. tostring(name))
  if clips[name] then
    love.window.setMode(640, 360)
    love.graphics.setBackgroundColor(0.1, 0.11, 0.17)
    play, draw = clips[name]()
  else
    love.graphics.setBackgroundColor(0.11, 0.12, 0.15)
    love.graphics.setFont(love.graphics.newFont(13))
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
    return film()
  end
  scenes[name]()
  love.graphics.captureScreenshot(function(image)
    write(image, path)
    love.event.quit()
  end)
end
