-- Draws the pictures of docs/guide/ with `world:draw`, one scene each:
--
--   love scripts/pictures guide-contacts build/guide-contacts.png

package.path = love.filesystem.getSource() .. "/../../?.lua;" .. package.path
local scenes = require("scripts.pictures.scenes")

local name, path

function love.load(arguments)
  name, path = arguments[1], arguments[2]
  assert(scenes[name], "no scene " .. tostring(name))
  love.graphics.setBackgroundColor(0.11, 0.12, 0.15)
  love.graphics.setFont(love.graphics.newFont(13))
end

function love.draw()
  scenes[name]()
  love.graphics.captureScreenshot(function(image)
    local file = assert(io.open(path, "wb"))
    file:write(image:encode("png"):getString())
    file:close()
    love.event.quit()
  end)
end
