--- Four walls of 100 px around a square room.

local WALL = 100 -- px

--- Returns the walls of a room of `size` px from 0, 0, as descriptions of a scene.
return function(size)
  local objects = {
    { x = -WALL, y = -WALL, width = size + 2 * WALL, height = WALL },
    { x = -WALL, y = size, width = size + 2 * WALL, height = WALL },
    { x = -WALL, y = 0, width = WALL, height = size },
    { x = size, y = 0, width = WALL, height = size },
  }
  for _, wall in ipairs(objects) do
    wall.group, wall.static = "walls", true
  end
  return objects
end
