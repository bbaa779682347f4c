-- A lift along a path: it waits at the ends, turns at walls, and stops before it crushes.
--
--   local platform = { x = 40, y = 300, width = 80, height = 16, kinematic = true }
--   world:add("lifts", platform)
--   platform.lift = lift.new(platform, { { 0, 0 }, { 200, 0 }, { 200, -120 } }, { wait = 1 })
--
--   for _, platform in ipairs(world.objects.lifts) do lift.update(world, platform, dt) end
--
-- Only the shape of the path counts: it begins where the platform is. So a polyline of a map will
-- do: `level.lines[1].points`. The library carries the riders. All that it remembers is in
-- platform.lift, as plain values: with `world.ownFields = { "lift" }` it is part of each saved
-- state.

local lift = {}

local SETTINGS = {
  speed = 80, -- px/s
  wait = 0.5, -- s, at the ends; in a loop at its first point
  loop = false, -- true: from the last point to the first one; else there and back
  crushes = false, -- true: it does not stop for anybody
}

--- Returns what goes into platform.lift. `points`: two or more, { x, y } or { x =, y = }. Errors: a
--- setting that does not exist; too few points.
function lift.new(platform, points, settings)
  local me = { path = {}, goal = 2, way = 1, waits = 0 } ---@type table
  for name, value in pairs(SETTINGS) do
    me[name] = value
  end
  for name, value in pairs(settings or {}) do
    if SETTINGS[name] == nil then
      error(("lift: there is no setting %s"):format(tostring(name)), 2)
    end
    me[name] = value
  end
  if #points < 2 then
    error("lift: a path has two points or more", 2)
  end
  local x, y = points[1].x or points[1][1], points[1].y or points[1][2]
  for i, point in ipairs(points) do
    local dx, dy = (point.x or point[1]) - x, (point.y or point[2]) - y
    me.path[i] = { platform.x + dx, platform.y + dy }
  end
  return me
end

local function isFixed(other)
  return (other.static or other.kinematic) and not other.sensor
end

-- Is there room for an object that the lift pushes, and for those that this pushes?
local function hasRoom(world, object, dx, dy, depth)
  local other, _, _, nx, ny = world:sweep(object, dx, dy)
  if not other or nx == 0 and ny == 0 then
    return true
  end
  return depth < 10 and not isFixed(other) and hasRoom(world, other, dx, dy, depth + 1)
end

local function wouldCrush(world, platform, dx, dy)
  local x, y = platform.x + dx, platform.y + dy
  local list, count = world:queryRect(x, y, platform.width, platform.height)
  for i = 1, count do
    local other = list[i]
    local isPassed = platform.oneWay and other.y + other.height > platform.y + 0.01 -- from below
    if other ~= platform and not isPassed and not other.sensor and not isFixed(other) then
      if not hasRoom(world, other, dx, dy, 1) then
        return true
      end
    end
  end
  return false
end

-- A platform that is in a wall already passes through it.
local function hitsWall(world, platform, dx, dy)
  local other, _, _, nx, ny = world:sweep(platform, dx, dy, isFixed)
  return other and (nx ~= 0 or ny ~= 0)
end

-- The point is reached: on to the next one.
local function advance(me)
  local last = #me.path
  local isAtEnd = me.goal == 1 or me.goal == last and not me.loop
  me.waits = isAtEnd and me.wait or 0
  if me.loop then
    me.goal = me.goal % last + 1
  else
    if isAtEnd then
      me.way = me.goal == 1 and 1 or -1
    end
    me.goal = me.goal + me.way
  end
end

local function turn(me)
  local last = #me.path
  me.way = -me.way
  me.goal = me.goal + me.way
  if me.loop then
    me.goal = (me.goal - 1) % last + 1
  end
  me.goal = math.max(1, math.min(last, me.goal))
end

--- Moves a platform in the next step of dt s. To be called before `world:update`, or in `onStep`.
function lift.update(world, platform, dt)
  local me = platform.lift
  platform.vx, platform.vy = 0, 0
  if me.waits > 0 then
    me.waits = me.waits - dt
    return
  end
  local goal = me.path[me.goal]
  local dx, dy = goal[1] - platform.x, goal[2] - platform.y
  local distance = math.sqrt(dx * dx + dy * dy)
  local share = me.speed * dt / math.max(distance, 1e-9)
  if share > 0.999999 then
    share = 1 -- also after many steps that are not quite exact
  end
  dx, dy = dx * share, dy * share
  if hitsWall(world, platform, dx, dy) then
    turn(me)
  elseif not me.crushes and wouldCrush(world, platform, dx, dy) then
    return -- until there is room
  elseif share < 1 then
    platform.vx, platform.vy = dx / dt, dy / dt
  else
    platform.x, platform.y = goal[1], goal[2] -- exactly there, with its riders
    advance(me)
  end
end

return lift
