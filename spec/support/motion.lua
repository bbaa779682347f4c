--- Watches how far a step moves objects: no farther than the fastest speed of the step explains,
--- plus what parting may add, and that none gets past an immovable one.
---
---     local watch = motion.new(world, objects)
---     watch:before()  world:update(dt)  local what = watch:after(dt)

local motion = {}

local abs, max, min = math.abs, math.max, math.min

local DEEP = 1e-6 -- px; less is not inside
local EDGES = 16 -- so many edges, each as high as `snap`, an object may come down in a step

local Watch = {}
Watch.__index = Watch

local function isMover(object)
  return not object.static and not object.kinematic
end

local function overlapOf(low, high, otherLow, otherHigh)
  return min(high, otherHigh) - max(low, otherLow)
end

-- (A machine that the game puts elsewhere is no wall in that step: it gets there on the way.)
local function isWall(object)
  return not isMover(object) and not (object.sensor or object.oneWay or object.active == false)
end

local function isSolid(object)
  return isMover(object) and not object.sensor and object.active ~= false
end

-- Adds the speed of an object to the fastest of the step. Two that bounce may pass on more than the
-- speed of the one that hits. What is carried or on a belt has a speed relative to that.
local function addSpeed(watch, object, vx, vy)
  local belt = abs(object.surfaceSpeed or 0)
  watch.carryX, watch.carryY = max(watch.carryX, belt), max(watch.carryY, belt)
  if isMover(object) then
    local factor = 1 + max(object.restitution or 0, 0)
    watch.vx, watch.vy = max(watch.vx, factor * abs(vx)), max(watch.vy, factor * abs(vy))
    watch.nudge = max(watch.nudge, object.nudge or 0, EDGES * (object.snap or 0))
  else
    watch.carryX, watch.carryY = max(watch.carryX, abs(vx)), max(watch.carryY, abs(vy))
  end
end

-- What forces may add to a speed in `dt` seconds.
local function addForces(watch, object, dt)
  local world = watch.world
  local gx = abs(object.gravityX or world.gravityX or 0) + abs(object.ax or 0)
  local gy = abs(object.gravity or world.gravity or 0) + abs(object.ay or 0)
  watch.pullX, watch.pullY = max(watch.pullX, gx * dt), max(watch.pullY, gy * dt)
end

-- The way out of a wall along an axis, px, if it is one that a body may take: the shorter of both
-- axes, or one no longer than itself, where the shorter one ends in another wall.
local function wayOut(way, other, size)
  return (way <= other or way <= size) and way or 0
end

-- Out of what is immovable a body goes at once: how far that may be for the i-th, along each axis.
local function noteWays(watch, i)
  local body, sumX, sumY = watch.objects[i], 0, 0
  local canBePushed = body.pushable ~= false
  for n = 1, watch.firmCount do
    local wall = watch.firm[n]
    if canBePushed or isWall(wall) then
      local left, right = body.x + body.width - wall.x, wall.x + wall.width - body.x
      local top, bottom = body.y + body.height - wall.y, wall.y + wall.height - body.y
      local x, y = min(left, right), min(top, bottom)
      if x > 0 and y > 0 then
        sumX, sumY = sumX + wayOut(x, y, body.width), sumY + wayOut(y, x, body.height)
      end
    end
  end
  watch.wayX[i], watch.wayY[i] = sumX, sumY
end

-- Lists what is immovable: walls, and what cannot be pushed, to what can be pushed.
local function listFirm(watch)
  local count = 0
  for m = 1, watch.count do
    local object = watch.objects[m]
    if object.pushable == false or isWall(object) then
      count = count + 1
      watch.firm[count] = object
    end
  end
  watch.firmCount = count
end

--- To be called before an update, after everything that the game writes.
function Watch:before()
  local boxes = self.boxes
  self.vx, self.vy, self.pullX, self.pullY, self.nudge = 0, 0, 0, 0, 0
  self.carryX, self.carryY = 0, 0
  self.count = #self.objects
  for i = 1, self.count do
    local object, k = self.objects[i], 4 * i
    boxes[k], boxes[k + 1] = object.x, object.y
    local x, y = self.lastX[object], self.lastY[object]
    self.isWritten[i] = object.kinematic and x and (x ~= object.x or y ~= object.y)
    boxes[k + 2], boxes[k + 3] = object.width, object.height
    addSpeed(self, object, object.vx or 0, object.vy or 0)
  end
  listFirm(self)
  for i = 1, self.count do
    noteWays(self, i)
  end
end

-- Machines that the game drives by writing their place carry and push, too.
local function addMachines(watch, dt)
  for i = 1, watch.count do
    local object = watch.objects[i]
    local x, y = watch.lastX[object], watch.lastY[object]
    if x and not isMover(object) then
      addSpeed(watch, object, (object.x - x) / dt, (object.y - y) / dt)
    end
    watch.lastX[object], watch.lastY[object] = object.x, object.y
  end
end

-- How much farther than it may the i-th object moved, px, along the axis where that is more; and
-- how far it moved along it. A contact parts along one axis, so each axis has its own limit. A step
-- moves an object by its larger side at most to part it from others that it overlaps. (Out of what
-- is immovable it goes at once, as scenario 11 has it: see `noteWays`.)
local function excessOf(watch, i, dt)
  local object, boxes, k = watch.objects[i], watch.boxes, 4 * i
  local dx, dy = abs(object.x - boxes[k]), abs(object.y - boxes[k + 1])
  local parted = max(boxes[k + 2], boxes[k + 3]) + watch.nudge
  local x = dx - (watch.vx + watch.pullX + watch.carryX) * dt - parted - watch.wayX[i]
  local y = dy - (watch.vy + watch.pullY + watch.carryY) * dt - parted - watch.wayY[i]
  if x > y or x ~= x then
    return x, dx
  end
  return y, dy
end

-- Whether a middle that was on one side of a wall is on the other side now.
local function hasCrossed(at, newAt, near, far, newNear, newFar)
  return at <= near and newAt >= newFar or at >= far and newAt <= newNear
end

local function isBetween(value, low, high)
  return value > low + DEEP and value < high - DEEP
end

-- What the i-th object did to the m-th, which is immovable: its middle went into it, or past it.
-- Into a machine it may be pressed.
local function trespassOf(watch, i, m)
  local boxes, k, w = watch.boxes, 4 * i, 4 * m
  local a, wall = watch.objects[i], watch.objects[m]
  local x, y, width, height = boxes[k], boxes[k + 1], boxes[k + 2], boxes[k + 3]
  local left, top = boxes[w], boxes[w + 1]
  local right, bottom = left + boxes[w + 2], top + boxes[w + 3]
  local newLeft, newTop = wall.x, wall.y
  local newRight, newBottom = newLeft + wall.width, newTop + wall.height
  local isBeside = overlapOf(y, y + height, top, bottom) > 0
    and overlapOf(a.y, a.y + a.height, newTop, newBottom) > 0
  local isAbove = overlapOf(x, x + width, left, right) > 0
    and overlapOf(a.x, a.x + a.width, newLeft, newRight) > 0
  local midX, midY = x + width / 2, y + height / 2
  local newX, newY = a.x + a.width / 2, a.y + a.height / 2
  if
    isBeside and hasCrossed(midX, newX, left, right, newLeft, newRight)
    or isAbove and hasCrossed(midY, newY, top, bottom, newTop, newBottom)
  then
    return "past"
  elseif
    wall.static
    and isBetween(newX, newLeft, newRight)
    and isBetween(newY, newTop, newBottom)
    and not (isBetween(midX, left, right) and isBetween(midY, top, bottom))
  then
    return "into"
  end
end

--- The farthest motion of an update, measured by what is allowed. To be called once after each.
---@param dt number s
---@return number excess px beyond the limit, negative: within
---@return table? object
---@return number? moved px
function Watch:farthest(dt)
  addMachines(self, dt)
  for i = 1, self.count do
    local object = self.objects[i]
    addSpeed(self, object, object.vx or 0, object.vy or 0)
    addForces(self, object, dt)
  end
  local worst, farthest, path = -math.huge, nil, nil
  for i = 1, self.count do
    if isMover(self.objects[i]) then
      local excess, moved = excessOf(self, i, dt)
      if excess > worst or excess ~= excess then
        worst, farthest, path = excess, self.objects[i], moved
      end
    end
  end
  return worst, farthest, path
end

--- The first object that went with its middle into an immovable one, or past it.
---@return string? how "into" or "past"
---@return table? object
---@return table? wall
function Watch:trespass()
  for m = 1, self.count do
    if isWall(self.objects[m]) and not self.isWritten[m] then
      for i = 1, self.count do
        local how = isSolid(self.objects[i]) and trespassOf(self, i, m)
        if how then
          return how, self.objects[i], self.objects[m]
        end
      end
    end
  end
end

--- To be called after the update: what does not hold, or nil.
---@param dt number s
---@return string? text
function Watch:after(dt)
  local excess, object, moved = self:farthest(dt)
  if object and (excess > 1e-6 or excess ~= excess) then
    local text = "an object of %.9g x %.9g px moved %.9g px in a step, %.9g px more than it may"
    return text:format(object.width, object.height, moved, excess)
  end
  local how, a, wall = self:trespass()
  if how then
    local text = "the middle of an object at %.9g, %.9g went %s an immovable one at %.9g, %.9g"
    return text:format(a.x, a.y, how, wall.x, wall.y)
  end
end

--- Watches the objects of a list, which may grow.
---@param world table its gravity counts
---@param objects table[]
function motion.new(world, objects)
  local self = { world = world, objects = objects, boxes = {}, lastX = {}, lastY = {} }
  self.wayX, self.wayY = {}, {}
  self.firm, self.firmCount = {}, 0
  self.isWritten = {} -- by number: the game has put it elsewhere since the last update
  return setmetatable(self, Watch)
end

return motion
