--- What the scenes of the pictures share: boxes by numbers, and texts.

local stage = {}

--- Adds a box with fields to a group of a world. Returns it.
function stage.add(world, group, x, y, width, height, fields, isStatic)
  local object = { x = x, y = y, width = width, height = height, static = isStatic }
  for name, value in pairs(fields or {}) do
    object[name] = value
  end
  return world:add(group, object)
end

--- Writes a text with its middle at x.
function stage.write(text, x, y)
  love.graphics.setColor(0.78, 0.8, 0.85)
  love.graphics.printf(text, x - 100, y, 200, "center")
end

return stage
