-- What the library knows of the object under the mouse, as a small table beside it.

local look = require("look")
local view = require("view")

local inspector = {}

local WIDTH, LINE = 200, 17 -- px
local SIDES = { "top", "bottom", "left", "right" }

-- "boxes 3", or "player" for one that stands directly in `objects`.
local function nameOf(world, object)
  for name, group in pairs(world.objects) do
    if group == object then
      return tostring(name)
    end
    for key, member in pairs(group) do
      if member == object then
        return ("%s %s"):format(name, key)
      end
    end
  end
  return "?" -- it was removed in this moment
end

local function kindOf(object)
  local kind = object.static and "static" or object.kinematic and "kinematic" or "dynamic"
  return object.sensor and kind .. " sensor" or kind
end

local function describe(world, object)
  local lines = { nameOf(world, object) .. ", " .. kindOf(object) }
  lines[2] = ("x %.2f   y %.2f"):format(object.x, object.y)
  lines[3] = ("width %g   height %g"):format(object.width, object.height)
  if not object.static then
    lines[4] = ("vx %.1f   vy %.1f"):format(object.vx or 0, object.vy or 0)
  end
  for _, side in ipairs(SIDES) do
    local other = object.touching and object.touching[side]
    if other then
      lines[#lines + 1] = ("%s: %s"):format(side, nameOf(world, other))
    end
  end
  return lines
end

-- Of several one that is solid.
local function find(world, x, y)
  local found = world:queryPoint(x, y)
  for _, object in ipairs(found) do
    if not object.sensor then
      return object
    end
  end
  return found[1]
end

--- Draws what there is to say about the object at a point of the picture. `cameraX, cameraY`: the
--- place of the world at the picture's top-left corner. `scale`: of the world in the picture (1).
function inspector.draw(world, x, y, cameraX, cameraY, scale)
  local object = find(world, x / (scale or 1) + cameraX, y / (scale or 1) + cameraY)
  if not object then
    return
  end
  local lines = describe(world, object)
  local height = #lines * LINE + 14
  local left = math.min(x + 16, view.gameWidth - WIDTH - 8)
  local top = math.max(8, math.min(y + 16, view.height - height - 42))
  look.panel(left, top, WIDTH, height, 6)
  look.panel(left, top, WIDTH, height, 6) -- twice: hardly anything shines through
  for i, line in ipairs(lines) do
    look.color(i == 1 and "yellow" or "white")
    look.text(line, left + 10, top + 6 + (i - 1) * LINE, 13)
  end
end

return inspector
