--- physics.lua. The objects of a scene are copied once: afterwards they are the game's own tables.

local physics = require("physics")
local tables = require("bench.engines.tables")

local ours = {}
local World = {}
World.__index = World

local function copy(description)
  local object = {}
  for field, value in pairs(description) do
    object[field] = value
  end
  object.group = nil
  return object
end

function ours.new(scene)
  local self = setmetatable({ objects = {} }, World)
  self.world = physics.newWorld({
    gravity = scene.gravity,
    rest = scene.rest,
    soft = scene.soft,
  })
  for _, description in ipairs(scene.objects) do
    self:add(description)
  end
  return self
end

function World:add(description)
  local index = #self.objects + 1
  self.objects[index] = self.world:add(description.group, copy(description))
  return index
end

function World:remove(index)
  self.world:remove(self.objects[index])
end

function World:step(dt)
  self.world:update(dt)
end

World.read, World.setVelocity = tables.read, tables.setVelocity

--- Accelerates an object until it is told otherwise, up to its `maxSpeed`.
function World:accelerate(index, ax, ay)
  local object = self.objects[index]
  object.ax, object.ay = ax, ay
end

--- Makes a box grow, or shrink, about its middle.
function World:setSize(index, width, height)
  local object = self.objects[index]
  object.x = object.x - (width - object.width) / 2
  object.y = object.y - (height - object.height) / 2
  object.width, object.height = width, height
end

function World:setGravity(x, y)
  self.world.gravityX, self.world.gravity = x, y
end

--- The game's own tables, in the order of their numbers.
function World:list()
  return self.objects
end

function World:raycast(x1, y1, x2, y2)
  local object, _, _, _, _, fraction = self.world:raycast(x1, y1, x2, y2)
  return object and fraction
end

--- Asks the n-th question of a frame at a place.
function World:ask(n, x, y)
  local world, kind = self.world, n % 4
  if kind == 0 then
    world:queryRect(x - 32, y - 32, 64, 64, nil, self.objects.found)
  elseif kind == 1 then
    world:raycast(x, y, x + 200, y + 40)
  elseif kind == 2 then
    world:queryPoint(x, y, nil, self.objects.found)
  else
    world:nearest(x, y, 200)
  end
end

--- Moves an object by hand along x.
function World:moveBy(index, way)
  self.objects[index].x = self.objects[index].x + way
end

function World:save(out)
  return self.world:save(out)
end

function World:restore(state)
  self.world:restore(state)
end

function World:hash()
  return self.world:hash()
end

function World:free()
  self.world, self.objects = nil, nil
end

ours.World = World

return ours
