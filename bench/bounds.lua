--- Plays a scene and watches the bounds that a step has to keep: how long the slowest step takes,
--- how far a body moves in one, what is left of overlaps, and when everything is at rest.
---
--- Only for engines that show their objects, by `World:list()`.

local fold = require("spec.support.fold")
local overlap = require("spec.support.overlap")
local statistics = require("bench.statistics")

local bounds = {}

local DT = 1 / 60
local DEEP = 0.01 -- px; less is no overlap
local QUIET = 10 -- frames in which nothing moves, before it counts as rest

local clock = os.clock

local Watch = {}
Watch.__index = Watch

-- Notes where everything is before a step, and how fast it is going to be at most: the speed of an
-- object is relative to what carries it.
local function note(watch)
  local list, before = watch.list, watch.before
  local pullX = DT * math.abs(watch.world.world.gravityX or 0)
  local pullY = DT * math.abs(watch.world.world.gravity or 0)
  local carrierX, carrierY = 0, 0
  for i = 1, #list do
    if list[i].kinematic then
      carrierX = math.max(carrierX, math.abs(list[i].vx))
      carrierY = math.max(carrierY, math.abs(list[i].vy))
    end
  end
  watch.carrierX, watch.carrierY = carrierX, carrierY
  for i = 1, #list do
    local object, k = list[i], 4 * i
    before[k], before[k + 1] = object.x, object.y
    before[k + 2], before[k + 3] =
      math.abs(object.vx or 0) + pullX, math.abs(object.vy or 0) + pullY
  end
end

local function isMover(object)
  return not object.static and not object.kinematic
end

-- How much farther the i-th object is from its start than its fastest speed explains, px; and its
-- speed after the step.
local function excess(watch, i)
  local object, before, k = watch.list[i], watch.before, 4 * i
  local dx, dy = object.x - before[k], object.y - before[k + 1]
  local vx = math.max(before[k + 2], math.abs(object.vx)) + watch.carrierX
  local vy = math.max(before[k + 3], math.abs(object.vy)) + watch.carrierY
  local far = math.sqrt(dx * dx + dy * dy) - DT * math.sqrt(vx * vx + vy * vy)
  return far, math.sqrt(object.vx * object.vx + object.vy * object.vy)
end

local function isOutside(object, x1, y1, x2, y2)
  local x, y = object.x + object.width / 2, object.y + object.height / 2
  return not (x >= x1 and x <= x2 and y >= y1 and y <= y2) -- so NaN is outside, too
end

local function countOutside(watch)
  local room = watch.scene.room
  if not room then
    return 0
  end
  local x1, y1, x2, y2
  if type(room) == "function" then
    x1, y1, x2, y2 = room(watch.world)
  else
    x1, y1, x2, y2 = room[1], room[2], room[3], room[4]
  end
  local count = 0
  for _, object in ipairs(watch.list) do
    if isMover(object) and isOutside(object, x1, y1, x2, y2) then
      count = count + 1
    end
  end
  return count
end

-- Looks at the motion of the step. Returns whether anything moves.
local function watchMotion(watch)
  local isMoving = false
  for i, object in ipairs(watch.list) do
    if isMover(object) then
      local far, speed = excess(watch, i)
      local k = 4 * i
      if far > watch.jump then
        watch.jump, watch.jumpAt = far, watch.step
      end
      watch.fastest = math.max(watch.fastest, speed)
      if speed > 0 or object.x ~= watch.before[k] or object.y ~= watch.before[k + 1] then
        isMoving = true
      end
    end
  end
  return isMoving
end

-- How far the object that must not move is from its start, px.
local function watchStill(watch)
  local still = watch.list[watch.scene.still]
  if still then
    local start = watch.scene.objects[watch.scene.still]
    local dx, dy = still.x - start.x, still.y - start.y
    watch.drift = math.max(watch.drift or 0, math.sqrt(dx * dx + dy * dy))
  end
end

local function watchStep(watch)
  local isMoving = watchMotion(watch)
  watchStill(watch)
  local deepest, _, _, pairsLeft = watch.findOverlaps()
  watch.deepest, watch.pairs = deepest, pairsLeft
  watch.outside = math.max(watch.outside, countOutside(watch))
  if pairsLeft > 0 then
    watch.lastOverlap = watch.step
  end
  if isMoving then
    watch.lastMotion = watch.step
  end
end

-- Frames after the driven ones until something holds, nil: it does not hold at the end.
local function since(watch, last)
  if watch.step - last < QUIET then
    return nil
  end
  return math.max(last - (watch.scene.driven or watch.count), 0)
end

--- What has been seen up to now; see `bounds.play`.
function Watch:result()
  local times = self.times
  local result = { steps = #times, isLimited = #times < self.count }
  result.worst, result.worstAt = self.worst, self.worstAt
  result.jump, result.jumpAt, result.fastest = self.jump, self.jumpAt, self.fastest
  result.outside, result.pairs, result.deepest = self.outside, self.pairs, self.deepest
  result.drift = self.drift
  if #times > 0 then
    result.median, result.mean = statistics.median(times), statistics.mean(times)
    result.p99 = statistics.quantile(times, 0.99)
  end
  if not result.isLimited then
    result.rest, result.apart = since(self, self.lastMotion), since(self, self.lastOverlap)
    local last = {}
    for i = math.max(#times - 59, 1), #times do
      last[#last + 1] = times[i]
    end
    result.restTime = statistics.median(last)
    result.fold = fold.objects(fold.START, self.list)
  end
  return result
end

local function newWatch(engine, scene)
  local world = engine.new(scene)
  local watch = setmetatable({ world = world, scene = scene, list = world:list() }, Watch)
  watch.before, watch.times, watch.step = {}, {}, 0
  watch.count = scene.warmUp + scene.steps
  watch.worst, watch.worstAt, watch.jump, watch.jumpAt, watch.fastest = 0, 0, 0, 0, 0
  watch.outside, watch.pairs, watch.deepest = 0, 0, 0
  watch.lastOverlap, watch.lastMotion = 0, 0
  watch.findOverlaps = overlap.checker(watch.list, DEEP)
  -- What the game does before it steps is neither timed nor a motion of the step.
  function world.step(_, dt)
    note(watch)
    local before = clock()
    engine.World.step(world, dt)
    local time = (clock() - before) * 1000
    watch.times[watch.step] = time
    if time > watch.worst then
      watch.worst, watch.worstAt = time, watch.step
    end
  end
  return watch
end

--- Plays a scene once.
---@param engine table see bench/engines.lua; it shows its methods as `engine.World`
---@param scene table see bench/scenes/worst/shared.lua
---@param limit number s of processor time; then it stops after the step in which it is
---@param onStep? fun(watch: table, time: number) told after each step, with its time in ms
---@return table result `worst`, `p99`, `median`, `mean`, ms a step; `worstAt`; `steps` that were
---played, `isLimited` if these are not all; `apart` and `rest`, frames after the last one that is
---driven until no two overlap (by more than 0.01 px) and until nothing moves, nil: never;
---`restTime`, the median of the last 60 steps, ms; `pairs` that overlap at the end and `deepest`
---overlap, px; `outside`, most movers beyond the walls in any step; `jump`, px, the largest motion
---in a step beyond the fastest speed of the body in it, and `jumpAt`; `drift`, px, how far what
---must not move was from its start, nil: there is nothing of that; `fastest` speed, px/s;
---`fold` of all positions and velocities at the end
function bounds.play(engine, scene, limit, onStep)
  local deadline = clock() + limit
  local watch = newWatch(engine, scene)
  for step = 1, watch.count do
    if clock() > deadline then
      break
    end
    watch.step = step
    scene.frame(watch.world, step)
    watchStep(watch)
    if onStep then
      onStep(watch, watch.times[step])
    end
  end
  local result = watch:result()
  watch.world:free()
  return result
end

--- The exponent with which a value grows with n: the slope of the line through the logarithms.
--- Source: least squares.
---@param counts number[] values of n
---@param values number[] the value of each, > 0
---@return number
function bounds.exponent(counts, values)
  local n, sumX, sumY, sumXX, sumXY = #counts, 0, 0, 0, 0
  for i = 1, n do
    local x, y = math.log(counts[i]), math.log(values[i])
    sumX, sumY, sumXX, sumXY = sumX + x, sumY + y, sumXX + x * x, sumXY + x * y
  end
  return (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX)
end

return bounds
