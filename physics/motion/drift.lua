---@diagnostic disable
--- Soft crowds: bodies of two groups that are soft to each other overlap, and drift apart.
--
-- softDrift.lua computes the velocity of that, the *drift* of a body. It is added to the path of
-- this step and taken off again after it, so that what is solid stops it as any other motion.
--
-- Reads from, size, mass, group; writes drift, and wakes what has one.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local columns = require(root .. ".memory.columns")
local softDrift = require(root .. ".motion.softDrift")

local drift = {}

local DYNAMIC = columns.DYNAMIC
local max, min = math.max, math.min

-- Nothing drifts any more.
local function reset(b, work)
  local drifted, drifts = work.drifted, b.softSpeed
  for n = 1, work.driftedCount do
    local k = 2 * drifted[n]
    drifts[k], drifts[k + 1] = 0, 0
  end
  work.driftedCount = 0
end

-- What stands on something drifts across gravity only: it is not lifted off the ground.
local function keepDown(b, work)
  local down, support, drifts = b.down, b.support, b.softSpeed
  for n = 1, work.driftedCount do
    local i = work.drifted[n]
    for k = 2 * i, support[i] ~= 0 and 2 * i + 1 or 0 do
      drifts[k] = down[k] == 0 and drifts[k] or 0
    end
  end
end

--- Finds the drift of all that are soft to what they overlap, in a step of dt s.
function drift.run(b, dt)
  reset(b, b.drifts)
  if b.soft then
    if not b.drifts.slot then
      b.drifts = softDrift.new()
    end
    softDrift.run(b, b.drifts, dt)
    keepDown(b, b.drifts)
  end
end

--- Adds the drift to the free flight of those in awakeList from `first` to `last`.
function drift.add(b, dt, first, last)
  local awakeList, kind, drifts, way, speed = b.awakeList, b.kind, b.softSpeed, b.way, b.speed
  local undrifted, carried = b.undrifted, b.carried
  for n = first, last do
    local k = 2 * awakeList[n]
    if kind[awakeList[n]] == DYNAMIC then
      undrifted[k], undrifted[k + 1] = speed[k] + carried[k], speed[k + 1] + carried[k + 1]
      way[k], way[k + 1] = way[k] + drifts[k] * dt, way[k + 1] + drifts[k + 1] * dt
      speed[k], speed[k + 1] = speed[k] + drifts[k], speed[k + 1] + drifts[k + 1]
    end
  end
end

--- Gives those with a drift the velocity at which they start, drift included, and the acceleration
--- without it.
function drift.start(b, dt)
  local work = b.drifts
  for n = 1, work.driftedCount do
    local i = work.drifted[n]
    for k = 2 * i, b.awake[i] and 2 * i + 1 or 0 do
      b.start[k] = b.freeSpeed[k] - (b.undrifted[k] - b.start[k])
      b.accel[k] = (b.freeSpeed[k] - b.start[k]) / dt -- to the bit as friction computes it
    end
  end
end

-- The velocity of its own that k has left, of `own`, after it has met something: what has changed
-- its speed has not turned it about.
local function ownAfter(own, speed, change)
  if change < 0 then
    return min(own, max(own + change, speed))
  end
  return max(own, min(own + change, speed))
end

--- Takes the drift off the velocities again, after a step.
function drift.takeOff(b)
  local work = b.drifts
  for n = 1, work.driftedCount do
    local i = work.drifted[n]
    for k = 2 * i, b.awake[i] and 2 * i + 1 or 0 do
      local own, change = b.undrifted[k], b.speed[k] - b.freeSpeed[k]
      b.speed[k] = change == 0 and own or ownAfter(own, b.speed[k], change)
    end
  end
end

return drift
