--- The loop of the tutorial this library grew out of, as it stands there: every object that moves
--- is compared with every other one, and what overlaps is bumped apart at once, half each.
--- Kindly read: lists instead of `pairs`, which LuaJIT does not compile.

local tables = require("bench.engines.tables")

local tutorial = {
  lacks = {
    sensors = "everything bumps",
    kinematic = "no moving platforms",
    raycast = "no questions",
    questions = "no questions",
    state = "no snapshots",
    circles = "boxes only",
    slopes = "boxes only",
    zones = "a game has to accelerate by itself",
    crowds = "everything can be pushed",
    accelerations = "a game has to accelerate by itself",
    gravity = "gravity cannot be turned",
    sizes = "a game has to push by itself",
  },
}
local World = {}
World.__index = World

local max, min = math.max, math.min

function tutorial.new(scene)
  local self = setmetatable({ gravity = scene.gravity, objects = {}, all = {}, movers = {} }, World)
  for _, description in ipairs(scene.objects) do
    self:add(description)
  end
  return self
end

function World:add(description)
  local object = {
    x = description.x,
    y = description.y,
    width = description.width,
    height = description.height,
    vx = description.vx or 0,
    vy = description.vy or 0,
    gravity = description.gravity or self.gravity,
    restitution = description.restitution or 0,
    static = description.static or false,
  }
  local index = #self.objects + 1
  self.objects[index] = object
  self.all[#self.all + 1] = object
  if not object.static then
    self.movers[#self.movers + 1] = object
  end
  return index
end

local function drop(list, object)
  for i = 1, #list do
    if list[i] == object then
      table.remove(list, i)
      return
    end
  end
end

function World:remove(index)
  drop(self.all, self.objects[index])
  drop(self.movers, self.objects[index])
end

local function isColliding(a, b)
  return min(a.x + a.width, b.x + b.width) > max(a.x, b.x)
    and min(a.y + a.height, b.y + b.height) > max(a.y, b.y)
end

-- The side of `a` with the shortest way out: the rule of opposite sides.
local function side(a, b)
  local right, left = a.x + a.width - b.x, b.x + b.width - a.x
  local bottom, top = a.y + a.height - b.y, b.y + b.height - a.y
  if right < left and right < top and right < bottom then
    return "x", -right
  elseif left < top and left < bottom then
    return "x", left
  elseif top < bottom then
    return "y", top
  end
  return "y", -bottom
end

-- Takes away, or turns round, the speed that leads into the other.
local function stop(speed, way, restitution)
  return speed * way < 0 and -restitution * speed or speed
end

local function push(object, axis, way, restitution)
  if axis == "x" then
    object.x = object.x + way
    object.vx = stop(object.vx, way, restitution)
  else
    object.y = object.y + way
    object.vy = stop(object.vy, way, restitution)
  end
end

local function bump(a, b)
  local axis, way = side(a, b)
  local restitution = max(a.restitution, b.restitution)
  if b.static then
    push(a, axis, way, restitution)
  else
    push(a, axis, way / 2, restitution)
    push(b, axis, -way / 2, restitution)
  end
end

function World:step(dt)
  local movers, all = self.movers, self.all
  for i = 1, #movers do
    local object = movers[i]
    object.vy = object.vy + object.gravity * dt
    object.x = object.x + object.vx * dt
    object.y = object.y + object.vy * dt
  end
  for i = 1, #movers do
    local a = movers[i]
    for j = 1, #all do
      local b = all[j]
      if a ~= b and isColliding(a, b) then
        bump(a, b)
      end
    end
  end
end

World.read, World.setVelocity = tables.read, tables.setVelocity

function World:free()
  self.objects, self.all, self.movers = nil, nil, nil
end

return tutorial
