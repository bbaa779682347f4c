--- Not an engine: what a step has to read before it can begin. Games write to their own tables
--- whenever they like, so each step of physics.lua looks at every field of all objects that may
--- move, and whether every other object is still there. This does that in the fewest loops and
--- compares with what it saw last, and nothing else: no engine that keeps the contract can be
--- faster.

local reading = { plays = { rest = true, level = true } }
local World = {}
World.__index = World

-- Fields that hold a number, always or mostly.
local function findMoved(movers, seen, count)
  local changed = 0
  for n = 1, count do
    local object, k = movers[n], 6 * n
    if
      object.x ~= seen[k]
      or object.y ~= seen[k + 1]
      or object.width ~= seen[k + 2]
      or object.height ~= seen[k + 3]
      or object.vx ~= seen[k + 4]
      or object.vy ~= seen[k + 5]
    then
      seen[k], seen[k + 1], seen[k + 2], seen[k + 3] =
        object.x, object.y, object.width, object.height
      seen[k + 4], seen[k + 5] = object.vx, object.vy
      changed = changed + 1
    end
  end
  return changed
end

-- Fields that few objects have. The boxes of the benchmark have only three of them.
local function findRich(movers, frictions, count)
  local rich = 0
  for n = 1, count do
    local object = movers[n]
    if
      object.friction ~= frictions[n]
      or object.mass ~= nil
      or object.restitution ~= nil
      or object.active ~= nil
      or object.kinematic ~= nil
      or object.sensor ~= nil
      or object.pushable ~= nil
      or object.strength ~= nil
      or object.oneWay ~= nil
      or object.mask ~= nil
      or object.hits ~= nil
      or object.canCollide ~= nil
      or object.onStay ~= nil
      or object.gravity ~= nil
      or object.gravityX ~= nil
      or object.ax ~= nil
      or object.ay ~= nil
      or object.airFriction ~= nil
      or object.drag ~= nil
      or object.maxSpeed ~= nil
      or object.maxSpeedX ~= nil
      or object.maxSpeedY ~= nil
      or object.maxFallSpeed ~= nil
      or object.carry ~= nil
      or object.surfaceSpeed ~= nil
      or object.nudge ~= nil
      or object.snap ~= nil
      or object.slope ~= nil
      or object.constantSpeed ~= nil
      or object.radius ~= nil
      or object.area ~= nil
    then
      rich = rich + 1
    end
  end
  return rich
end

local function findReplaced(group, seen, count)
  for n = 1, count do
    if group[n] ~= seen[n] then
      return n
    end
  end
  return next(group, count)
end

function reading.new(scene)
  local self = setmetatable({ all = {}, groups = {}, names = {}, movers = {} }, World)
  self.numbers, self.frictions, self.found = {}, {}, 0
  for _, description in ipairs(scene.objects) do
    self:add(description)
  end
  return self
end

local function newObject(description)
  local object = {
    x = description.x,
    y = description.y,
    width = description.width,
    height = description.height,
    static = description.static,
    friction = description.friction,
  }
  if not object.static then
    object.vx, object.vy, object.touching = description.vx or 0, description.vy or 0, {}
  end
  return object
end

function World:add(description)
  local object, name = newObject(description), description.group
  local group = self.groups[name]
  if not group then
    group = { objects = {}, seen = {} }
    self.groups[name], self.names[#self.names + 1] = group, name
  end
  group.objects[#group.objects + 1], group.seen[#group.seen + 1] = object, object
  if not object.static then
    local n = #self.movers + 1
    self.movers[n], self.frictions[n] = object, object.friction
    for k = 6 * n, 6 * n + 5 do
      self.numbers[k] = 0
    end
  end
  self.all[#self.all + 1] = object
  return #self.all
end

--- Notes in `found` how many fields or objects are others than in the step before.
function World:step()
  local count, replaced = #self.movers, 0
  for n = 1, #self.names do
    local group = self.groups[self.names[n]]
    replaced = replaced + (findReplaced(group.objects, group.seen, #group.seen) and 1 or 0)
  end
  local moved = findMoved(self.movers, self.numbers, count)
  self.found = replaced + moved + findRich(self.movers, self.frictions, count)
end

function World:read(index)
  local object = self.all[index]
  return object.x, object.y
end

function World:setVelocity(index, vx, vy)
  local object = self.all[index]
  object.vx = vx or object.vx
  object.vy = vy or object.vy
end

function World:free()
  self.all, self.groups, self.movers = nil, nil, nil
end

return reading
