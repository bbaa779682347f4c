--- love.physics, that is Box2D 2.3, with the settings its users choose for boxes that do not turn.

local lovePhysics = {
  needsLove = true,
  lacks = {
    questions = "asks its own bodies, no tables of the game",
    state = "its state cannot be read out as a whole",
    sizes = "its shapes keep their size",
    zones = "a game has to accelerate by itself",
  },
}
local World = {}
World.__index = World

local METER = 64 -- px; Box2D is tuned for sizes of 0.1 to 10 m
local DT = 1 / 60 -- s, a frame

--- `turns`: the bodies do, as they do by default.
function lovePhysics.new(scene, turns)
  love.physics.setMeter(METER)
  local self = setmetatable({ bodies = {}, halves = {}, isFixed = not turns }, World)
  self.maxSpeeds, self.hasMasses = {}, scene.hasMasses
  self.world = love.physics.newWorld(0, scene.gravity, scene.rest)
  for _, description in ipairs(scene.objects) do
    self:add(description)
  end
  local nearest
  self.onHit = function(_, _, _, _, _, fraction)
    nearest = fraction
    return fraction -- shortens the ray to this hit
  end
  self.takeNearest = function()
    local fraction = nearest
    nearest = nil
    return fraction
  end
  return self
end

-- What cannot be pushed has to be kinematic here.
local function kindOf(description)
  local isKinematic = description.kinematic or description.pushable == false
  return description.static and "static" or isKinematic and "kinematic" or "dynamic"
end

-- The corners of a slope about the middle of its box, without the one that is cut off.
local function cornersOf(slope, halfWidth, halfHeight)
  local isLeft, isHanging = slope:find("left$") ~= nil, slope:find("^top") ~= nil
  local high = isLeft and -halfWidth or halfWidth -- the side with two corners
  local base = isHanging and -halfHeight or halfHeight
  return high, base, -high, base, high, -base
end

local function newShape(description, halfWidth, halfHeight)
  if description.radius then
    return love.physics.newCircleShape(description.radius)
  elseif description.slope then
    return love.physics.newPolygonShape(cornersOf(description.slope, halfWidth, halfHeight))
  end
  return love.physics.newRectangleShape(description.width, description.height)
end

function World:add(description)
  local halfWidth, halfHeight = description.width / 2, description.height / 2
  local x, y = description.x + halfWidth, description.y + halfHeight
  local body = love.physics.newBody(self.world, x, y, kindOf(description))
  local fixture = love.physics.newFixture(body, newShape(description, halfWidth, halfHeight))
  fixture:setFriction(description.friction or 0)
  fixture:setRestitution(description.restitution or 0)
  if description.hits then -- what has no list of hits is in category 1
    fixture:setFilterData(2, 1, 0)
  end
  fixture:setSensor(description.sensor or false)
  if self.hasMasses then
    body:setMass(description.mass or 1)
  end
  body:setFixedRotation(self.isFixed)
  body:setGravityScale(description.gravity == 0 and 0 or 1)
  body:setLinearVelocity(description.vx or 0, description.vy or 0)
  local index = #self.bodies + 1
  self.bodies[index] = body
  self.halves[2 * index - 1], self.halves[2 * index] = halfWidth, halfHeight
  self.maxSpeeds[index] = description.maxSpeed
  return index
end

function World:remove(index)
  self.bodies[index]:destroy()
end

function World:step(dt)
  self.world:update(dt)
end

function World:read(index)
  local x, y = self.bodies[index]:getPosition()
  return x - self.halves[2 * index - 1], y - self.halves[2 * index]
end

function World:setVelocity(index, vx, vy)
  local body = self.bodies[index]
  local oldX, oldY = body:getLinearVelocity()
  body:setLinearVelocity(vx or oldX, vy or oldY)
end

-- There is no largest speed: a game that wants one writes this.
function World:accelerate(index, ax, ay)
  local body, maxSpeed = self.bodies[index], self.maxSpeeds[index]
  local vx, vy = body:getLinearVelocity()
  vx, vy = vx + ax * DT, vy + ay * DT
  local speed = math.sqrt(vx * vx + vy * vy)
  if speed > maxSpeed then
    vx, vy = vx / speed * maxSpeed, vy / speed * maxSpeed
  end
  body:setLinearVelocity(vx, vy)
end

function World:setGravity(x, y)
  self.world:setGravity(x, y)
end

function World:raycast(x1, y1, x2, y2)
  self.world:rayCast(x1, y1, x2, y2, self.onHit)
  return self.takeNearest()
end

function World:free()
  self.world:destroy()
end

return lovePhysics
