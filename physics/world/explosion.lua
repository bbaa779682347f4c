--- Explosions: a velocity away from a point for the dynamic objects in a circle.
--
-- All new velocities are worked out and checked before the first one is written.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local query = require(root .. ".queries.query")
local rays = require(root .. ".queries.rays")

interpreted.file()

local explosion = {}

local max, min, sqrt = math.max, math.min, math.sqrt
local PUSHED = { "vx", "vy", "mass" }

-- Whether nothing that `walls` names is between a point and the centre of an object.
local function isSeen(world, object, x, y, walls)
  local centerX, centerY = object.x + object.width * 0.5, object.y + object.height * 0.5
  local hit = rays.raycast(world, x, y, centerX, centerY, walls)
  return hit == nil or rawequal(hit, object)
end

-- The distance of a point from an object.
local function distanceOf(object, x, y)
  local dx = x - max(object.x, min(x, object.x + object.width))
  local dy = y - max(object.y, min(y, object.y + object.height))
  if object.radius then
    local r = object.radius
    dx, dy = x - object.x - r, y - object.y - r
    return max(sqrt(dx * dx + dy * dy) - r, 0.0)
  end
  return sqrt(dx * dx + dy * dy)
end

-- The unit vector from a point to the centre of an object: up, if that is the point.
local function directionTo(object, x, y)
  local dx, dy = object.x + object.width * 0.5 - x, object.y + object.height * 0.5 - y
  local length = sqrt(dx * dx + dy * dy)
  if length == 0 then
    return 0.0, -1.0
  end
  return dx / length, dy / length
end

-- Keeps the dynamic ones of list[1..count] that are seen; returns how many.
local function keepHit(world, list, count, x, y, walls)
  local kept = 0
  for n = 1, count do
    local object = list[n]
    if not object.static and not object.kinematic then
      if walls == nil or isSeen(world, object, x, y, walls) then
        kept = kept + 1
        list[kept] = object
      end
    end
  end
  for n = count, kept + 1, -1 do
    list[n] = nil
  end
  return kept
end

--- Gives the dynamic objects in a circle an impulse; returns the list of these, and how many.
--- Errors: a velocity or mass that cannot be used, before the call or after it.
function explosion.run(world, x, y, radius, impulse, filter, walls, where)
  local list, count = query.circle(world, x, y, radius, filter)
  count = keepHit(world, list, count, x, y, walls)
  local speeds = {}
  for n = 1, count do
    local object = list[n]
    check.fields(object, where .. ": object", PUSHED)
    local share = max(1 - distanceOf(object, x, y) / radius, 0.0)
    local change, nx, ny = impulse * share / (object.mass or 1), directionTo(object, x, y)
    local vx, vy = (object.vx or 0) + change * nx, (object.vy or 0) + change * ny
    check.number(vx, "vx after it", where)
    check.number(vy, "vy after it", where)
    speeds[2 * n - 1], speeds[2 * n] = vx, vy
  end
  for n = 1, count do
    list[n].vx, list[n].vy = speeds[2 * n - 1], speeds[2 * n]
  end
  return list, count
end

return explosion
