--- Scenes for the files of examples/kit: a floor at y 400, gravity 1600, and keys as text.

local physics = require("physics")
local small = require("spec.support.small")

local kit = {}

local DT = 1 / 60

--- Returns a world with a floor, and objects: `{ { group, x, y, width, height, fields }, … }`.
function kit.world(objects, settings)
  local world = physics.newWorld({ gravity = 1600, ownFields = settings })
  world:add("tiles", { x = -1000, y = 400, width = 3000, height = 40, static = true })
  for _, row in ipairs(objects or {}) do
    local fields = row[6] or { static = true }
    world:add(row[1], small.put(row[2], row[3], row[4], row[5], fields))
  end
  return world
end

--- Returns a function of a frame that says which keys are held: "right:1-30 jump:5-20".
function kit.keys(text)
  local spans = {}
  for key, first, last in text:gmatch("(%a+):(%d+)%-(%d+)") do
    spans[#spans + 1] = { key = key, first = tonumber(first), last = tonumber(last) }
  end
  return function(frame)
    local held = {}
    for _, span in ipairs(spans) do
      held[span.key] = held[span.key] or (frame >= span.first and frame <= span.last)
    end
    return held
  end
end

--- Plays frames: `each(frame)` before every step.
function kit.play(world, frames, each)
  for frame = 1, frames do
    each(frame)
    world:update(DT)
  end
end

return kit
