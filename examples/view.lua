-- The picture has one size, whatever the window's: it is scaled as far as it fits.

local view = { width = 1200, height = 640, gameWidth = 960 } -- px; left the game, right the panel
view.hasKeys = true -- the player has a keyboard

-- Returns the place of the picture in the window, and its scale.
local function place()
  local width, height = love.graphics.getDimensions()
  local scale = math.min(width / view.width, height / view.height)
  return (width - view.width * scale) / 2, (height - view.height * scale) / 2, scale
end

--- Returns how many pixels of the screen are one px of the picture.
function view.sharpness()
  local _, _, scale = place()
  return scale * love.graphics.getDPIScale()
end

--- Draws with coordinates of the picture.
function view.draw(draw)
  local x, y, scale = place()
  love.graphics.push()
  love.graphics.translate(x, y)
  love.graphics.scale(scale)
  draw()
  love.graphics.pop()
end

--- Draws only inside a rectangle, which obeys the current transform. What follows is for `draw`.
function view.clip(x, y, width, height, draw, ...)
  local left, top = love.graphics.transformPoint(x, y)
  local right, bottom = love.graphics.transformPoint(x + width, y + height)
  local oldX, oldY, oldWidth, oldHeight = love.graphics.getScissor()
  love.graphics.intersectScissor(left, top, math.max(0, right - left), math.max(0, bottom - top))
  draw(...)
  love.graphics.setScissor(oldX, oldY, oldWidth, oldHeight)
end

--- Returns the point of the picture at a point of the window.
function view.toPicture(windowX, windowY)
  local x, y, scale = place()
  return (windowX - x) / scale, (windowY - y) / scale
end

return view
