-- What the player holds. The examples ask here and not love.keyboard, so that a script can play.

local input = { held = {} } -- held: keys that the script holds

--- True while one of the keys is held.
function input.isDown(...)
  for i = 1, select("#", ...) do
    local key = select(i, ...)
    if input.held[key] or love.keyboard.isDown(key) then
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

return input
