--- Shows a world as the physics sees it. For development, and as a start for a game's own drawing.
--- Reads only what the game can read too: `world.objects` and the fields of the objects.

local here = (...):match("^(.*)%.[^.]+$")
local check = require(here .. ".check")

local drawing = {}

local COLORS = {
  static = { 0.44, 0.48, 0.55 },
  kinematic = { 0.31, 0.58, 0.90 },
  moving = { 0.98, 0.68, 0.29 },
  resting = { 0.76, 0.46, 0.20 },
  sensor = { 0.47, 0.83, 0.56 },
  touching = { 1.00, 0.93, 0.78 },
  velocity = { 0.98, 0.36, 0.42 },
  name = { 1.00, 1.00, 1.00 },
}
local EDGE = 2 -- px, thickness of a side that touches
local INACTIVE = 0.3 -- share of the opacity that an inactive object keeps
local VELOCITY_TIME = 0.1 -- s, the velocity line ends where the object will be then

local DEFAULTS = { fill = true, touching = true, velocity = false, names = false, alpha = 1 }
local WHERE = "draw(options)"

local function comesBefore(a, b)
  local isNumberA, isNumberB = type(a) == "number", type(b) == "number"
  if isNumberA ~= isNumberB then
    return isNumberA
  end
  return a < b
end

-- Keys of a table in the order of the library: what is drawn on top must not change by chance.
local function sortedKeys(map)
  local keys = {}
  for key in pairs(map) do
    keys[#keys + 1] = key
  end
  table.sort(keys, comesBefore)
  return keys
end

local NAMES = sortedKeys(DEFAULTS)

local function isObject(value)
  return type(value.width) == "number"
end

-- Of several unknown options the first by name, so that the message does not vary from run to run.
local function unknownOption(options)
  local first
  for name in pairs(options) do
    local shown = check.show(name)
    if DEFAULTS[name] == nil and (not first or shown < first) then
      first = shown
    end
  end
  return first
end

local function checkOptions(options)
  if options == nil then
    return DEFAULTS
  end
  check.table(options, "options", WHERE)
  local unknown = unknownOption(options)
  if unknown then
    local known = table.concat(NAMES, ", ")
    check.fail(WHERE .. ": unknown option " .. unknown .. "; the options are " .. known)
  end
  local checked = {}
  for _, name in ipairs(NAMES) do
    local value = options[name]
    if value == nil then
      value = DEFAULTS[name]
    elseif name == "alpha" then
      check.number(value, name, WHERE, 0, 1)
    else
      check.boolean(value, name, WHERE)
    end
    checked[name] = value
  end
  return checked
end

local function kindOf(object)
  if object.sensor then
    return "sensor"
  elseif object.static then
    return "static"
  elseif object.kinematic then
    return "kinematic"
  end
  local rests = (object.vx or 0) == 0 and (object.vy or 0) == 0
  return rests and "resting" or "moving"
end

local function setColor(kind, alpha)
  local color = COLORS[kind]
  love.graphics.setColor(color[1], color[2], color[3], alpha)
end

-- A sensor is only an outline, since it stands in nobody's way; half a pixel inwards, so that the
-- line covers the pixels of the box and not their neighbours.
local function drawBox(object, kind, options, alpha)
  setColor(kind, alpha)
  if options.fill and kind ~= "sensor" then
    love.graphics.rectangle("fill", object.x, object.y, object.width, object.height)
  else
    local width, height = object.width - 1, object.height - 1
    love.graphics.rectangle("line", object.x + 0.5, object.y + 0.5, width, height)
  end
end

local function drawTouching(object, alpha)
  local x, y, width, height = object.x, object.y, object.width, object.height
  local touching = object.touching
  setColor("touching", alpha)
  if touching.top then
    love.graphics.rectangle("fill", x, y, width, EDGE)
  end
  if touching.bottom then
    love.graphics.rectangle("fill", x, y + height - EDGE, width, EDGE)
  end
  if touching.left then
    love.graphics.rectangle("fill", x, y, EDGE, height)
  end
  if touching.right then
    love.graphics.rectangle("fill", x + width - EDGE, y, EDGE, height)
  end
end

local function drawVelocity(object, alpha)
  local x, y = object.x + object.width / 2, object.y + object.height / 2
  local dx, dy = (object.vx or 0) * VELOCITY_TIME, (object.vy or 0) * VELOCITY_TIME
  setColor("velocity", alpha)
  love.graphics.line(x, y, x + dx, y + dy)
end

local function drawObject(object, name, options)
  local kind = kindOf(object)
  local alpha = options.alpha
  if object.active == false then
    alpha = alpha * INACTIVE
  end
  drawBox(object, kind, options, alpha)
  if options.touching and object.touching and object.active ~= false then
    drawTouching(object, alpha)
  end
  if options.velocity and not object.static then
    drawVelocity(object, alpha)
  end
  if options.names then
    setColor("name", alpha)
    love.graphics.print(name, object.x + EDGE, object.y + EDGE)
  end
end

local function drawGroup(group, groupName, options)
  for _, key in ipairs(sortedKeys(group)) do
    drawObject(group[key], tostring(groupName) .. " " .. tostring(key), options)
  end
end

--- Draws every object of a world: static grey, kinematic blue, dynamic orange (darker at rest),
--- sensors as an outline, inactive ones faintly, and the sides that touch as a light edge.
--- Leaves colour and line width as they were.
--- Options: `fill` (true; false draws outlines), `touching` (true), `velocity` (false: a line to
--- where the object will be in 0.1 s), `names` (false: group and key), `alpha` (1: 0..1, opacity).
--- Errors: an unknown option, one of the wrong type, no LÖVE with a graphics module.
---@param world table a world; only its `objects` are read
---@param options table?
function drawing.draw(world, options)
  options = checkOptions(options)
  if type(love) ~= "table" or not love.graphics then
    check.fail("draw needs love.graphics: it runs in LÖVE only, with its graphics module on")
  end
  local red, green, blue, alpha = love.graphics.getColor()
  local lineWidth = love.graphics.getLineWidth()
  love.graphics.setLineWidth(1)
  for _, name in ipairs(sortedKeys(world.objects)) do
    local value = world.objects[name]
    if isObject(value) then
      drawObject(value, tostring(name), options)
    else
      drawGroup(value, name, options)
    end
  end
  love.graphics.setLineWidth(lineWidth)
  love.graphics.setColor(red, green, blue, alpha)
end

return drawing
