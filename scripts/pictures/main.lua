-- Draws the pictures of docs/guide/ with `world:draw`, one scene each; films the clips of README:
--
--   love scripts/pictures guide-contacts build/guide-contacts.png
--   love scripts/pictures seams build/film/seams 40      40 frames, 0001.png and so on
--   love scripts/pictures platformer3 build/platformer3.png      a step of docs/platformers.md

package.path = love.filesystem.getSource() .. "/../../?.lua;" .. package.path
local clips = require("scripts.pictures.clips")
local scenes = require("scripts.pictures.scenes")
local steps = require("scripts.pictures.steps")

local path, frames -- nil: one picture, which is `path` itself
local frame = 0
local draw
local function play() end

-- Plays a frame, draws it, and writes the picture.
local function film()
  play()
  draw()
  frame = frame + 1
  local to = frames and ("%s/%04d.png"):format(path, frame) or path
  local isLast = frame == (frames or 1)
  love.graphics.captureScreenshot(function(image)
    local file = assert(io.open(to, "wb"))
    file:write(image:encode("png"):getString())
    file:close()
    if isLast then
      love.event.quit()
    end
  end)
end

function love.load(arguments)
  local name = arguments[1]
  path, frames = arguments[2], tonumber(arguments[3])
  local size = clips[name] and { 640, 360 } or scenes[name] and { 720, 300 } or { 800, 600 }
  love.window.setMode(size[1], size[2])
  love.graphics.setBackgroundColor(0.1, 0.11, 0.17)
  if clips[name] then
    play, draw = clips[name]()
  elseif scenes[name] then
    love.graphics.setFont(love.graphics.newFont(13))
    draw = scenes[name]
  else
    draw = steps.play(name)
  end
  love.draw, love.update = film, nil
end
