--- Walls around a level: the group `bounds`.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")

local bounds = {}

local GROUP = "bounds"
local SIDES = { "top", "bottom", "left", "right" }
-- px; nothing tunnels, so this is only for what the game puts beside the level by mistake.
local THICKNESS = 64

local function wall(x, y, width, height)
  return { x = x, y = y, width = width, height = height, static = true }
end

-- The game may keep objects of its own in the group, but not under the names of the walls.
local function checkGroup(objects, walls)
  if type(objects) ~= "table" then
    check.fail("objects must be a table of groups, got " .. check.show(objects))
  end
  local group = objects[GROUP]
  if group == nil then
    return
  elseif type(group) ~= "table" or type(group.width) == "number" then
    check.fail("world:setBounds(x, y, w, h): objects.bounds must be a group, got an object")
  end
  for _, side in ipairs(SIDES) do
    if group[side] ~= nil and group[side] ~= walls[side] then
      check.fail(
        "world:setBounds(x, y, w, h): "
          .. check.place(GROUP, side)
          .. " must be free for a wall, got "
          .. check.show(group[side])
      )
    end
  end
end

local function take(objects, walls)
  local group = objects[GROUP]
  if not group then
    return
  end
  for _, side in ipairs(SIDES) do
    if group[side] == walls[side] then
      group[side] = nil
    end
  end
  if next(group) == nil then
    objects[GROUP] = nil
  end
end

--- Puts four walls around a rectangle in place of `walls`, the last ones; without a rectangle it
--- takes those away. Returns the new walls.
--- Errors: the game uses the names of the walls; nothing has changed then.
function bounds.set(objects, walls, x, y, w, h)
  checkGroup(objects, walls)
  take(objects, walls)
  if not x then
    return {}
  end
  local t = THICKNESS
  local new = {
    top = wall(x - t, y - t, w + 2 * t, t),
    bottom = wall(x - t, y + h, w + 2 * t, t),
    left = wall(x - t, y, t, h),
    right = wall(x + w, y, t, h),
  }
  local group = objects[GROUP] or {}
  objects[GROUP] = group
  for _, side in ipairs(SIDES) do
    group[side] = new[side]
  end
  return new
end

interpreted.always(take)

return bounds
