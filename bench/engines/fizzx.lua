--- FizzX, when it is found on `package.path`. It has one world a program, rectangles are given by
--- their middle and half their size.

local engine = {
  module = "fizzx",
  lacks = {
    sensors = "everything bumps",
    worlds = "one world a program",
    raycast = "no questions",
    questions = "no questions",
    state = "no snapshots",
    circles = "boxes only",
    slopes = "boxes only",
    zones = "a game has to accelerate by itself",
    crowds = "everything can be pushed",
    accelerations = "a game has to accelerate by itself",
    gravity = "gravity acts on what comes later",
    sizes = "its shapes keep their size",
  },
}
local World = {}
World.__index = World

local CELL = 32 -- px; the fastest for boxes of this size that still finds all neighbours

local function add(fizz, description)
  local halfWidth, halfHeight = description.width / 2, description.height / 2
  local x, y = description.x + halfWidth, description.y + halfHeight
  if description.static then
    return fizz.addStatic("rect", x, y, halfWidth, halfHeight)
  elseif description.kinematic then
    return fizz.addKinematic("rect", x, y, halfWidth, halfHeight)
  end
  local shape = fizz.addDynamic("rect", x, y, halfWidth, halfHeight)
  shape.gravity = description.gravity == 0 and 0 or 1
  return shape
end

function engine.new(scene)
  local fizz = require("fizzx")
  local self = setmetatable({ fizz = fizz, shapes = {} }, World)
  fizz.setCellsize(CELL)
  fizz.setGravity(0, scene.gravity)
  for _, description in ipairs(scene.objects) do
    self:add(description)
  end
  return self
end

function World:add(description)
  local shape = add(self.fizz, description)
  shape.friction = description.friction or 0
  shape.bounce = description.restitution or 0
  if not description.static then
    self.fizz.setVelocity(shape, description.vx or 0, description.vy or 0)
  end
  local index = #self.shapes + 1
  self.shapes[index] = shape
  return index
end

function World:remove(index)
  self.fizz.removeShape(self.shapes[index])
end

function World:step(dt)
  self.fizz.update(dt)
end

function World:read(index)
  local shape = self.shapes[index]
  return shape.x - shape.hw, shape.y - shape.hh
end

function World:setVelocity(index, vx, vy)
  local shape = self.shapes[index]
  self.fizz.setVelocity(shape, vx or shape.xv, vy or shape.yv)
end

-- The shapes would stay in the only world there is.
function World:free()
  for _, shape in ipairs(self.shapes) do
    if shape.list then
      self.fizz.removeShape(shape)
    end
  end
  self.shapes = nil
end

return engine
