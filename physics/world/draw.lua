--- Draws a world as the physics sees it: for development, and as a start for a game's own drawing.
--- It reads `world.objects` and the fields of the objects, as a game could; only the grid is
--- internal.
--
-- Every mark is a filled rectangle or polygon, and texts are written last. LÖVE batches such
-- shapes, so the whole world takes one or two draw calls, however many objects there are. LÖVE's
-- lines cost several times as much as the four rectangles of an outline.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local keyOrder = require(root .. ".memory.keyOrder")

local drawing = {}

-- Fills have a contrast of at least 3 to 1 to black and to white, since a game's background may be
-- either (spec/draw_spec.lua measures it).
local COLORS = {
  static = { 0.47, 0.51, 0.58 },
  kinematic = { 0.22, 0.52, 0.88 },
  moving = { 0.87, 0.42, 0.09 },
  resting = { 0.64, 0.42, 0.24 },
  sensor = { 0.13, 0.59, 0.33 },
  oneWay = { 0.68, 0.36, 0.88 },
  velocity = { 0.86, 0.12, 0.58 },
  grid = { 0.24, 0.55, 0.66 },
}
local TOUCHING = { 1, 0.95, 0.75 } -- inside of a filled box, on its colour
local BORDER = 0.55 -- share of a fill's brightness that its border has
local EDGE = 2 -- px, thickness of a side that touches, and of a velocity
local SOLID = 4 -- px, thickness of the solid side of a one-way object
local OPEN = 0.4 -- share of the opacity that a one-way object has elsewhere
local INACTIVE = 0.3 -- share of the opacity that an inactive object keeps
local VELOCITY_TIME = 0.1 -- s, the velocity line ends where the object will be then
local CELL = 0.4 -- opacity of the mark that each object leaves on its grid cell
local FONT_SIZE = 12
local COUNTERS = { "objects", "movers", "resting", "pairs", "contacts", "events" }

local DEFAULTS = {
  fill = true,
  touching = true,
  oneWay = true,
  velocity = false,
  names = false,
  grid = false,
  counters = false,
  alpha = 1,
}
local WHERE = "draw(options)"

local min, sqrt = math.min, math.sqrt

-- Order -------------------------------------------------------------------------------------------

-- Returns whether the keys are 1, 2, 3, … and nothing else: then nothing must be sorted.
local function isPlainList(group)
  local count = 0
  for _ in pairs(group) do
    count = count + 1
  end
  return count == #group and (count == 0 or group[1] ~= nil)
end

local function isObject(value)
  return type(value.width) == "number"
end

local function visitGroup(group, name, visit, options)
  if isPlainList(group) then
    for key = 1, #group do
      visit(group[key], options, name, key)
    end
  else
    for _, key in ipairs(keyOrder.sorted(group)) do
      visit(group[key], options, name, key)
    end
  end
end

-- Calls visit(object, options, name of the group, key) for every object of a world, in the order of
-- the world: what is drawn on top must not vary.
local function visitAll(world, visit, options)
  for _, name in ipairs(keyOrder.sorted(world.objects)) do
    local value = world.objects[name]
    if isObject(value) then
      visit(value, options, name)
    else
      visitGroup(value, name, visit, options)
    end
  end
end

-- Options -----------------------------------------------------------------------------------------

local NAMES = keyOrder.sorted(DEFAULTS)

local function checkOptions(options)
  if options == nil then
    return DEFAULTS
  end
  check.table(options, "options", WHERE)
  check.names(options, "option", NAMES, WHERE)
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

-- Rectangles --------------------------------------------------------------------------------------

local function setColor(color, alpha, brightness)
  brightness = brightness or 1
  local red, green, blue = color[1] * brightness, color[2] * brightness, color[3] * brightness
  love.graphics.setColor(red, green, blue, alpha)
end

local function fill(x, y, width, height)
  love.graphics.rectangle("fill", x, y, width, height)
end

-- Draws four rectangles inside the box, so that the outline covers no pixels of its neighbours.
local function drawOutline(x, y, width, height, thickness)
  local t = min(thickness, width / 2, height / 2)
  fill(x, y, width, t)
  fill(x, y + height - t, width, t)
  fill(x, y + t, t, height - 2 * t)
  fill(x + width - t, y + t, t, height - 2 * t)
end

-- Draws the strip along one side of a box.
local function drawSide(x, y, width, height, side, thickness)
  if side == "top" or side == "bottom" then
    local t = min(thickness, height)
    fill(x, side == "top" and y or y + height - t, width, t)
  else
    local t = min(thickness, width)
    fill(side == "left" and x or x + width - t, y, t, height)
  end
end

-- Marks -------------------------------------------------------------------------------------------

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

-- A circle: filled with a darker border, or the line around it.
local function drawCircle(object, color, isFilled, alpha)
  local r = object.width / 2
  local x, y = object.x + r, object.y + r
  if isFilled then
    setColor(color, alpha, BORDER)
    love.graphics.circle("fill", x, y, r)
    setColor(color, alpha)
    love.graphics.circle("fill", x, y, r - min(r / 2, 1.0))
  else
    setColor(color, alpha)
    love.graphics.circle("line", x, y, r)
  end
end

-- Draws a box. A sensor is only an outline, since it blocks nothing. The darker border separates
-- boxes that stand side by side.
local function drawBox(object, color, isFilled, alpha)
  local x, y, width, height = object.x, object.y, object.width, object.height
  if isFilled then
    local border = min(width / 4, height / 4, 1.0)
    setColor(color, alpha, BORDER)
    fill(x, y, width, height)
    setColor(color, alpha)
    fill(x + border, y + border, width - 2 * border, height - 2 * border)
  else
    setColor(color, alpha)
    drawOutline(x, y, width, height, 1)
  end
end

local function drawTouching(object, color, alpha)
  local x, y, width, height = object.x, object.y, object.width, object.height
  local touching = object.touching
  setColor(color, alpha)
  if touching.top then
    drawSide(x, y, width, height, "top", EDGE)
  end
  if touching.bottom then
    drawSide(x, y, width, height, "bottom", EDGE)
  end
  if touching.left then
    drawSide(x, y, width, height, "left", EDGE)
  end
  if touching.right then
    drawSide(x, y, width, height, "right", EDGE)
  end
end

local function drawVelocity(object, alpha)
  local dx, dy = (object.vx or 0) * VELOCITY_TIME, (object.vy or 0) * VELOCITY_TIME
  if dx == 0 and dy == 0 then
    return
  end
  local x, y = object.x + object.width / 2, object.y + object.height / 2
  setColor(COLORS.velocity, alpha)
  -- half the thickness, across the way
  local length = sqrt(dx * dx + dy * dy)
  local nx, ny = -dy / length * EDGE / 2, dx / length * EDGE / 2
  local toX, toY = x + dx, y + dy
  local polygon = love.graphics.polygon
  polygon("fill", x + nx, y + ny, toX + nx, toY + ny, toX - nx, toY - ny, x - nx, y - ny)
  fill(toX - EDGE, toY - EDGE, 2 * EDGE, 2 * EDGE)
end

local function drawOneWay(object, alpha)
  local side = object.oneWay == true and "top" or object.oneWay
  setColor(COLORS.oneWay, alpha)
  drawSide(object.x, object.y, object.width, object.height, side, SOLID)
end

local function drawObject(object, options)
  local kind, alpha = kindOf(object), options.alpha
  local color, isFilled = COLORS[kind], options.fill and kind ~= "sensor"
  local isActive = object.active ~= false
  if not isActive then
    alpha = alpha * INACTIVE
  end
  local isOneWay = options.oneWay and object.oneWay
  local draw = object.radius and drawCircle or drawBox
  draw(object, color, isFilled, isOneWay and alpha * OPEN or alpha)
  if isOneWay then
    drawOneWay(object, alpha)
  end
  if options.touching and object.touching and isActive then
    drawTouching(object, isFilled and TOUCHING or color, alpha)
  end
  if options.velocity and isActive and not object.static then
    drawVelocity(object, alpha)
  end
end

-- Draws the grid's cells in which objects are filed; the more objects, the stronger. The plain
-- broad phase has none.
local function drawGrid(world, options)
  local grid = world._bodies and world._bodies.broadphase
  if not grid or not grid.cellOf then
    return
  end
  setColor(COLORS.grid, options.alpha * CELL)
  for n = 1, grid.count do
    local cellX, cellY, cell = grid:cellOf(grid.list[n])
    drawOutline(cellX * cell, cellY * cell, cell, cell, 1)
  end
end

-- Words -------------------------------------------------------------------------------------------

-- White with a dark shadow is readable on every colour.
local function write(text, x, y, alpha)
  love.graphics.setColor(0, 0, 0, alpha)
  love.graphics.print(text, x + 1, y + 1)
  love.graphics.setColor(1, 1, 1, alpha)
  love.graphics.print(text, x, y)
end

local function writeName(object, options, group, key)
  local name = key == nil and tostring(group) or tostring(group) .. " " .. tostring(key)
  local alpha = object.active == false and options.alpha * INACTIVE or options.alpha
  write(name, object.x + EDGE, object.y + EDGE, alpha)
end

-- Writes the counters into the corner of the window, whatever the camera does.
local function writeCounters(stats, font, options)
  local parts = {}
  for i, name in ipairs(COUNTERS) do
    parts[i] = name .. " " .. tostring(stats[name])
  end
  local text = table.concat(parts, "   ")
  love.graphics.push()
  love.graphics.origin()
  love.graphics.setColor(0, 0, 0, 0.7 * options.alpha)
  love.graphics.rectangle("fill", 4, 4, font:getWidth(text) + 12, font:getHeight() + 8)
  write(text, 10, 8, options.alpha)
  love.graphics.pop()
end

-- A font for each `love.graphics` table that has been used.
local fonts = setmetatable({}, { __mode = "k" })

local function writeWords(world, options)
  local before, graphics = love.graphics.getFont(), love.graphics
  local font = fonts[graphics] or graphics.newFont(FONT_SIZE)
  fonts[graphics] = font
  love.graphics.setFont(font)
  if options.names then
    visitAll(world, writeName, options)
  end
  if options.counters and world.stats then
    writeCounters(world.stats, font, options)
  end
  love.graphics.setFont(before)
end

---@class physics.DrawOptions
---@field fill? boolean default true: boxes are filled; false: outlines
---@field touching? boolean default true: sides that touch, as a light edge
---@field oneWay? boolean default true: the solid side of one-way objects, in violet
---@field velocity? boolean default false: a line to where the object will be in 0.1 s
---@field names? boolean default false: group and key of each object
---@field grid? boolean default false: cells of the broad phase that are in use
---@field counters? boolean default false: `world.stats`, in the window's corner
---@field alpha? number 0..1, default 1: opacity of all of it

--- Draws every object of a world: static grey, kinematic blue, dynamic orange (brown at rest),
--- sensors as a green outline, inactive ones faintly. It can be seen on dark and on light ground.
--- Draws with the caller's transform, shader and blend mode; leaves colour, font and transform as
--- they were.
---
--- Errors: an unknown option, one of the wrong type, no LÖVE with a graphics module.
---@param world physics.World only its `objects` and `stats` are read, and the grid if asked for
---@param options physics.DrawOptions? what to show
function drawing.draw(world, options)
  options = checkOptions(options)
  if type(love) ~= "table" or not love.graphics then
    check.fail("draw needs love.graphics: it runs in LÖVE only, with its graphics module on")
  end
  local red, green, blue, alpha = love.graphics.getColor()
  if options.grid then
    drawGrid(world, options)
  end
  visitAll(world, drawObject, options)
  if options.names or options.counters then
    writeWords(world, options)
  end
  love.graphics.setColor(red, green, blue, alpha)
end

interpreted.always(isPlainList)

return drawing
