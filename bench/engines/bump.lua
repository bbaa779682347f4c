--- bump.lua, when it is found on `package.path`. It finds collisions and slides along them; what a
--- game adds itself stands here: gravity, velocities, bouncing. No box pushes another.

local tables = require("bench.engines.tables")

local engine = {
  module = "bump",
  lacks = {
    sensors = "everything bumps",
    kinematic = "a game has to carry and push by itself",
    accelerations = "a game has to accelerate by itself",
    gravity = "a game has to pull by itself",
    sizes = "a game has to push by itself",
    questions = "a game has to tell it what it has moved",
    state = "no snapshots",
    circles = "boxes only",
    slopes = "boxes only",
    zones = "a game has to accelerate by itself",
  },
}
local World = {}
World.__index = World

local CELL = 32 -- px; twice as fast as the default of 64 with boxes of this size

local function respond(item, other)
  return (item.restitution > 0 or other.restitution > 0) and "bounce" or "slide"
end

function engine.new(scene)
  local bump = require("bump")
  local self = setmetatable({ objects = {}, movers = {}, gravity = scene.gravity }, World)
  self.world = bump.newWorld(CELL)
  for _, description in ipairs(scene.objects) do
    self:add(description)
  end
  return self
end

function World:add(description)
  local object = {
    x = description.x,
    y = description.y,
    vx = description.vx or 0,
    vy = description.vy or 0,
    gravity = description.gravity or self.gravity,
    restitution = description.restitution or 0,
  }
  self.world:add(object, object.x, object.y, description.width, description.height)
  local index = #self.objects + 1
  self.objects[index] = object
  if not description.static then
    self.movers[#self.movers + 1] = object
  end
  return index
end

function World:remove(index)
  local object, movers = self.objects[index], self.movers
  self.world:remove(object)
  for i = 1, #movers do
    if movers[i] == object then
      table.remove(movers, i)
      return
    end
  end
end

-- What the normal of a collision says about the velocity.
local function turn(object, hit)
  local share = -math.max(object.restitution, hit.other.restitution)
  local normal = hit.normal
  if normal.x * object.vx < 0 then
    object.vx = share * object.vx
  end
  if normal.y * object.vy < 0 then
    object.vy = share * object.vy
  end
end

function World:step(dt)
  local world, movers = self.world, self.movers
  for i = 1, #movers do
    local object = movers[i]
    object.vy = object.vy + object.gravity * dt
    local goalX, goalY = object.x + object.vx * dt, object.y + object.vy * dt
    local x, y, hits, count = world:move(object, goalX, goalY, respond)
    object.x, object.y = x, y
    for k = 1, count do
      turn(object, hits[k])
    end
  end
end

World.read, World.setVelocity = tables.read, tables.setVelocity

function World:raycast(x1, y1, x2, y2)
  local hits, count = self.world:querySegmentWithCoords(x1, y1, x2, y2)
  return count > 0 and hits[1].ti1 or nil
end

function World:free()
  self.world, self.objects, self.movers = nil, nil, nil
end

return engine
