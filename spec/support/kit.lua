--- Scenes for the files of examples/kit: a floor at y 400, gravity 1600, keys as text, and what is
--- expected.

local physics = require("physics")
local small = require("spec.support.small")

local kit = {}

local DT = 1 / 60

kit.NIL = {} -- stands for nil where something is expected

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

--- Compares what is expected: a number within 1e-6, two numbers hold it between them, a boolean
--- says whether something is there.
function kit.check(expected, found, what)
  if type(expected) == "table" and expected[2] then
    local isBetween = type(found) == "number" and found >= expected[1] and found <= expected[2]
    assert(isBetween, ("%s is %s"):format(what, tostring(found)))
  elseif type(expected) == "number" then
    local isNear = type(found) == "number" and math.abs(found - expected) <= 1e-6
    assert(isNear, ("%s is %s, not %g"):format(what, tostring(found), expected))
  else
    local wanted, is = expected, found
    if expected == kit.NIL then
      wanted = nil
    elseif type(expected) == "boolean" then
      is = not not found
    end
    assert(wanted == is, ("%s is %s"):format(what, tostring(found)))
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
