-- How long the updates of a world take, and the frames.

local meter = {}

local KEPT = 100 -- updates in the graph
local SHARE = 0.08 -- of a new time in the average

-- updates: their times since the last frame
local watched, updates ---@type table?, table

--- Forgets all times.
function meter.reset()
  watched, updates = nil, {}
  meter.steps = {} -- ms, the last ones
  meter.step, meter.frame = nil, nil -- ms, averages; nil: none yet
end

-- Puts a clock around the `update` of this one world.
local function watch(world)
  local update = world.update
  function world.update(self, dt)
    local before = love.timer.getTime()
    update(self, dt)
    updates[#updates + 1] = (love.timer.getTime() - before) * 1000
  end
  watched = world
end

local function average(old, new)
  return old and old + (new - old) * SHARE or new
end

--- Books a frame of `dt` s. `world` is measured from the next update on; nil: there is none.
function meter.update(world, dt)
  meter.frame = average(meter.frame, dt * 1000)
  for i, time in ipairs(updates) do
    meter.step = average(meter.step, time)
    table.insert(meter.steps, time)
    updates[i] = nil
  end
  while #meter.steps > KEPT do
    table.remove(meter.steps, 1)
  end
  if world ~= watched then
    meter.reset()
    if world then
      watch(world)
    end
  end
end

return meter
