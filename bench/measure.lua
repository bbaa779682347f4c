--- Plays one scene with one engine: once for the times, and once for everything else, which would
--- disturb the times.

local overlap = require("spec.support.overlap")
local statistics = require("bench.statistics")

local measure = {}

local KB, PAGE = 1024, 4096 -- bytes
local CHECK_EVERY = 10 -- steps, between two looks at the overlaps
local HEAP_LIMIT = 200 * KB -- KB, of garbage, before it is collected

-- Processor time of this process: what other programs do in the meantime does not count.
local clock = os.clock

local function newWorlds(engine, scene)
  local worlds = {}
  for i = 1, scene.worlds do
    worlds[i] = engine.new(scene)
  end
  return worlds
end

local function each(worlds, call, step)
  for i = 1, #worlds do
    call(worlds[i], step)
  end
end

local function free(worlds)
  for i = 1, #worlds do
    worlds[i]:free()
  end
end

-- Plays one frame of all worlds. Returns how long it took, in ms.
local function playFrame(worlds, scene, step)
  if scene.between then
    each(worlds, scene.between, step)
  end
  local before = clock()
  each(worlds, scene.frame, step)
  return (clock() - before) * 1000
end

-- Plays the frames before the measuring starts. Returns whether there was time for all of them, how
-- long the slowest took, since the first ones read all objects and compile, and all of them, in ms.
local function warmUp(worlds, scene, deadline)
  local slowest, sum = 0, 0
  for step = 1, scene.warmUp do
    if clock() > deadline then
      return false, slowest, sum
    end
    local time = playFrame(worlds, scene, step)
    slowest, sum = math.max(slowest, time), sum + time
  end
  return true, slowest, sum
end

local function heap()
  collectgarbage()
  collectgarbage() -- what has a finalizer goes at the second time
  return collectgarbage("count") * KB
end

-- Bytes of memory that this process occupies, with all that C allocated; nil where it is not told.
local function resident()
  local file = io.open("/proc/self/statm")
  local pages = file and file:read("*a"):match("^%d+ (%d+)")
  if file then
    file:close()
  end
  return pages and pages * PAGE
end

-- Times of the frames, in ms, until `scene.steps` or the deadline.
local function timeFrames(worlds, scene, deadline)
  local times = {}
  for i = 1, scene.steps do
    if clock() > deadline then
      break
    end
    times[i] = playFrame(worlds, scene, scene.warmUp + i)
  end
  return times
end

-- `before` is what the frames before have taken, in ms.
local function addTimes(result, scene, times, before)
  result.steps = #times
  result.isLimited = #times < scene.steps
  if #times > 0 then
    result.median = statistics.median(times)
    result.p99 = statistics.quantile(times, 0.99)
    result.worst = statistics.quantile(times, 1)
    result.mean = statistics.mean(times)
  end
  local sum = before + (result.mean or 0) * #times
  if result.isLimited and sum > 0 then
    result.atLeast = sum / (scene.warmUp + scene.steps)
  end
end

-- Plays a scene that is measured from its first frame once before, so that it is compiled by then.
local function rehearse(engine, scene, deadline)
  local worlds = newWorlds(engine, scene)
  for step = 1, scene.steps do
    if clock() > deadline then
      break
    end
    playFrame(worlds, scene, step)
  end
  free(worlds)
end

--- Measures how long the frames of a scene take.
---@param engine table see bench/engines.lua
---@param scene table see bench/scenes.lua
---@param limit number s, of processor time; then it stops, wherever it is
---@return table result `steps` that were measured; when there was time for one, `median`, `p99`,
--- `worst` and `mean` in ms; `isLimited` when the time was over before, and then `atLeast`, ms: a
--- frame takes more on average; `build`, ms for one world, and `slowest`, ms, of the frames before;
--- `memory` of one world in the Lua heap and `resident` of one world in the process, in bytes
function measure.times(engine, scene, limit)
  local deadline = clock() + limit
  if scene.warmUp == 0 then
    rehearse(engine, scene, clock() + limit / 2)
  end
  local heapBefore, residentBefore, started = heap(), resident(), clock()
  local worlds = newWorlds(engine, scene)
  local result = { build = (clock() - started) * 1000 / scene.worlds }
  local isWarm, slowest, before = warmUp(worlds, scene, deadline)
  result.slowest = slowest
  local residentAfter = resident()
  result.memory = (heap() - heapBefore) / scene.worlds
  result.resident = residentAfter and (residentAfter - residentBefore) / scene.worlds
  addTimes(result, scene, isWarm and timeFrames(worlds, scene, deadline) or {}, before)
  free(worlds)
  return result
end

-- Looks at the first world only: the others are its twins. What is static stays where it was, also
-- for those that come back to where they were dug out.
local function newOverlapCheck(world, scene)
  local boxes = {}
  for i, description in ipairs(scene.objects) do
    boxes[i] = {
      width = description.width,
      height = description.height,
      radius = description.radius,
      slope = description.slope,
      static = description.static,
      kinematic = description.kinematic,
      x = description.x,
      y = description.y,
    }
  end
  local find
  return function()
    for i = 1, #boxes do
      if not boxes[i].static then
        boxes[i].x, boxes[i].y = world:read(i)
      end
    end
    find = find or overlap.checker(boxes)
    return (find())
  end
end

-- Bytes that one frame allocates. The collector stands still meanwhile.
local function garbageOf(worlds, scene, step)
  if scene.between then
    each(worlds, scene.between, step)
  end
  collectgarbage("stop")
  local before = collectgarbage("count")
  each(worlds, scene.frame, step)
  local after = collectgarbage("count")
  collectgarbage("restart")
  if after > HEAP_LIMIT then
    collectgarbage()
  end
  return (after - before) * KB
end

--- Measures what a step of a scene allocates, and how deep objects stand in each other.
---@param engine table
---@param scene table
---@param limit number s, of processor time
---@return table result `looks`, how often there was time to look at the overlaps; `overlap`, the
--- largest of all, in px; `overlapAtEnd`; `garbage`, bytes a step on average; `garbageMedian`
function measure.quality(engine, scene, limit)
  local deadline = clock() + limit
  local worlds = newWorlds(engine, scene)
  if not warmUp(worlds, scene, deadline) then
    return { looks = 0 }
  end
  local check = not engine.isTurning and newOverlapCheck(worlds[1], scene)
  local result, garbage = { looks = 0 }, {}
  collectgarbage()
  for i = 1, scene.steps do
    if clock() > deadline then
      break
    end
    garbage[i] = garbageOf(worlds, scene, scene.warmUp + i)
    if check and (i % CHECK_EVERY == 0 or i == scene.steps) then
      result.overlapAtEnd = check()
      result.overlap = math.max(result.overlap or 0, result.overlapAtEnd)
      result.looks = result.looks + 1
    end
  end
  if #garbage > 0 then
    result.garbage, result.garbageMedian = statistics.mean(garbage), statistics.median(garbage)
  end
  free(worlds)
  return result
end

return measure
