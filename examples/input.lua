-- What the player holds. The examples ask here and not love.keyboard, so that a script can play.

local view = require("view")

-- held: keys that a script holds. isReal: do the keyboard and the mouse count, too?
local input = { held = {}, isReal = true }

--- True while one of the keys is held.
function input.isDown(...)
  for i = 1, select("#", ...) do
    local key = select(i, ...)
    if input.held[key] or (input.isReal and love.keyboard.isDown(key)) then
      return true
    end
  end
  return false
end

--- Returns -1, 0 or 1: the direction that two keys (or their letters) ask for.
function input.axis(negative, negativeLetter, positive, positiveLetter)
  local direction = 0
  if input.isDown(negative, negativeLetter) then
    direction = direction - 1
  end
  if input.isDown(positive, positiveLetter) then
    direction = direction + 1
  end
  return direction
end

--- Returns dx, dy, at most 1 long: where the arrow keys (or w a s d) ask to go, or from x, y to the
--- mouse while its button is held.
function input.direction(x, y)
  local dx, dy ---@type number, number
  dx, dy = input.axis("left", "a", "right", "d"), input.axis("up", "w", "down", "s")
  local mouseX, mouseY, isHeld = input.mouse()
  if isHeld and mouseX < view.gameWidth then
    dx, dy = mouseX - x, mouseY - y
  end
  local length = math.max(1, math.sqrt(dx * dx + dy * dy))
  return dx / length, dy / length
end

--- Returns where the mouse is in the picture, and whether its left button is held.
function input.mouse()
  if not input.isReal then
    return -1, -1, false
  end
  local x, y = view.toPicture(love.mouse.getPosition())
  return x, y, love.mouse.isDown(1)
end

return input
