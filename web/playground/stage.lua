--- Runs a program that is written for LÖVE where there is no LÖVE: in the page of the playground,
--- and in plain Lua, where it is compared with the page. The program gets a `love` that has what
--- small games use; what it draws becomes a list of paint commands (paint.js draws them). Nothing
--- of the library is replaced: `physics.draw` paints through the same functions as the program.
--
-- Runs on Lua 5.1 to 5.4 and LuaJIT. Where `string.pack` is missing, nothing is painted.

local stage = {}

local NAME = "main.lua" -- what errors call the program
local WIDTH, HEIGHT = 800, 600 -- px, LÖVE's own window
local STEP = 1 / 60 -- s
local FONT_SIZE = 12 -- px, LÖVE's own

-- Numbers of the paint commands, the same as in paint.js.
local CLEAR, COLOR, FILL, OUTLINE, ROUND, ELLIPSE, POLYGON, LINE, TEXT = 1, 2, 3, 4, 5, 6, 7, 8, 9
local PUSH, POP, ORIGIN, TRANSLATE, SCALE, ROTATE, LINE_WIDTH = 10, 11, 12, 13, 14, 15, 16

local pack = rawget(string, "pack") or function()
  return ""
end
local getInfo = debug.getinfo
local unpackTable = rawget(table, "unpack") or rawget(_G, "unpack")
local compile = rawget(_G, "loadstring") or load

-- Paint commands ----------------------------------------------------------------------------------

local function newPaint()
  return { count = 0 }
end

local function put(paint, command)
  local count = paint.count + 1
  paint.count, paint[count] = count, command
end

local function take(paint)
  local text = table.concat(paint, "", 1, paint.count)
  paint.count = 0
  return text
end

-- Arguments ---------------------------------------------------------------------------------------

-- Raises an error that names the line of the program from which LÖVE was called.
local function blame(message)
  local level = 3
  local info = getInfo(level, "Sl")
  while info and info.source ~= "@" .. NAME do
    level = level + 1
    info = getInfo(level, "Sl")
  end
  local place = info and ("%s:%d: "):format(NAME, info.currentline) or ""
  error(place .. message, 0)
end

local function refuse(name, i, wanted, value)
  local found = value == nil and "no value" or type(value)
  blame(("love: argument %d of %s must be a %s, got %s"):format(i, name, wanted, found))
end

local function checkNumber(value, name, i)
  local number = tonumber(value)
  if not number then
    refuse(name, i, "number", value)
  end
  return number
end

local function checkText(value, name, i)
  if type(value) == "number" then
    return tostring(value)
  elseif type(value) ~= "string" then
    refuse(name, i, "string", value)
  end
  return value
end

local function checkMode(value, name)
  if value ~= "fill" and value ~= "line" then
    blame(('love: the mode of %s must be "fill" or "line", got %s'):format(name, tostring(value)))
  end
  return value == "fill" and 1 or 0
end

-- The numbers of a list, or of the arguments themselves.
local function listOf(first, ...)
  return type(first) == "table" and first or { first, ... }
end

local function packPoints(kind, mode, points, name)
  local parts = { pack("<BBI4", kind, mode, #points) }
  for i = 1, #points do
    parts[i + 1] = pack("<f", checkNumber(points[i], name, i))
  end
  return table.concat(parts)
end

-- love.graphics -----------------------------------------------------------------------------------

local Font = {}
Font.__index = Font

function Font:getWidth(text)
  local widest = 0
  for line in (tostring(text) .. "\n"):gmatch("(.-)\n") do
    widest = math.max(widest, self.measure(line, self.size))
  end
  return math.ceil(widest)
end

function Font:getHeight()
  return math.floor(self.size * 1.2 + 0.5)
end

local function newFont(host, size)
  return setmetatable({ measure = host.measure, size = size }, Font)
end

local function copyState(state)
  local copy = {}
  for name, value in pairs(state) do
    copy[name] = value
  end
  return copy
end

local function addColors(graphics, paint, state)
  local function color(name, red, green, blue, alpha)
    if type(red) == "table" then
      red, green, blue, alpha = red[1], red[2], red[3], red[4]
    end
    red, green, blue =
      checkNumber(red, name, 1), checkNumber(green, name, 2), checkNumber(blue, name, 3)
    return red, green, blue, alpha == nil and 1 or checkNumber(alpha, name, 4)
  end

  function graphics.setColor(...)
    local red, green, blue, alpha = color("setColor", ...)
    state.red, state.green, state.blue, state.alpha = red, green, blue, alpha
    put(paint, pack("<Bffff", COLOR, red, green, blue, alpha))
  end

  function graphics.getColor()
    return state.red, state.green, state.blue, state.alpha
  end

  function graphics.setBackgroundColor(...)
    local red, green, blue = color("setBackgroundColor", ...)
    paint.background = { red, green, blue, 1 }
  end

  function graphics.getBackgroundColor()
    return unpackTable(paint.background)
  end

  function graphics.setLineWidth(width)
    state.lineWidth = checkNumber(width, "setLineWidth", 1)
    put(paint, pack("<Bf", LINE_WIDTH, state.lineWidth))
  end

  function graphics.getLineWidth()
    return state.lineWidth
  end
end

local function addShapes(graphics, paint)
  function graphics.rectangle(mode, x, y, width, height, radius)
    local isFilled = checkMode(mode, "rectangle")
    x, y = checkNumber(x, "rectangle", 2), checkNumber(y, "rectangle", 3)
    width, height = checkNumber(width, "rectangle", 4), checkNumber(height, "rectangle", 5)
    if radius then
      radius = checkNumber(radius, "rectangle", 6)
      put(paint, pack("<BBfffff", ROUND, isFilled, x, y, width, height, radius))
    else
      put(paint, pack("<Bffff", isFilled == 1 and FILL or OUTLINE, x, y, width, height))
    end
  end

  function graphics.ellipse(mode, x, y, radiusX, radiusY)
    local isFilled = checkMode(mode, "ellipse")
    x, y = checkNumber(x, "ellipse", 2), checkNumber(y, "ellipse", 3)
    radiusX = checkNumber(radiusX, "ellipse", 4)
    radiusY = checkNumber(radiusY or radiusX, "ellipse", 5)
    put(paint, pack("<BBffff", ELLIPSE, isFilled, x, y, radiusX, radiusY))
  end

  function graphics.circle(mode, x, y, radius)
    local isFilled = checkMode(mode, "circle")
    x, y = checkNumber(x, "circle", 2), checkNumber(y, "circle", 3)
    radius = checkNumber(radius, "circle", 4)
    put(paint, pack("<BBffff", ELLIPSE, isFilled, x, y, radius, radius))
  end

  function graphics.polygon(mode, ...)
    put(paint, packPoints(POLYGON, checkMode(mode, "polygon"), listOf(...), "polygon"))
  end

  function graphics.line(...)
    put(paint, packPoints(LINE, 0, listOf(...), "line"))
  end

  function graphics.points(...)
    local points = listOf(...)
    for i = 1, #points - 1, 2 do
      local x, y = checkNumber(points[i], "points", i), checkNumber(points[i + 1], "points", i + 1)
      put(paint, pack("<Bffff", FILL, x - 0.5, y - 0.5, 1, 1))
    end
  end
end

local ALIGNMENTS = { left = 0, center = 1, right = 2 }

local function addTexts(graphics, paint, state, host)
  function graphics.newFont(size)
    return newFont(host, size == nil and FONT_SIZE or checkNumber(size, "newFont", 1))
  end

  function graphics.setFont(font)
    if getmetatable(font) ~= Font then
      blame("love: setFont takes what love.graphics.newFont returns, got " .. tostring(font))
    end
    state.font = font
  end

  function graphics.setNewFont(size)
    state.font = newFont(host, size == nil and FONT_SIZE or checkNumber(size, "setNewFont", 1))
    return state.font
  end

  function graphics.getFont()
    return state.font
  end

  -- A limit of 0 px: lines are not broken.
  local function write(text, x, y, limit, align)
    put(paint, pack("<BBffffs4", TEXT, align, x, y, state.font.size, limit, text))
  end

  function graphics.print(text, x, y)
    text = checkText(text, "print", 1)
    x, y = checkNumber(x or 0, "print", 2), checkNumber(y or 0, "print", 3)
    write(text, x, y, 0, ALIGNMENTS.left)
  end

  function graphics.printf(text, x, y, limit, align)
    text = checkText(text, "printf", 1)
    x, y = checkNumber(x, "printf", 2), checkNumber(y, "printf", 3)
    limit = checkNumber(limit, "printf", 4)
    local number = ALIGNMENTS[align or "left"]
    if not number then
      blame('love: align must be "left", "center" or "right", got ' .. tostring(align))
    end
    write(text, x, y, limit, number)
  end
end

local function addTransforms(graphics, paint, state)
  local stack = {}

  local function restoreState(saved)
    for name, value in pairs(saved) do
      state[name] = value
    end
    put(paint, pack("<Bffff", COLOR, state.red, state.green, state.blue, state.alpha))
    put(paint, pack("<Bf", LINE_WIDTH, state.lineWidth))
  end

  function graphics.push(what)
    stack[#stack + 1] = what == "all" and copyState(state) or false
    put(paint, pack("<B", PUSH))
  end

  function graphics.pop()
    local saved = table.remove(stack)
    if saved == nil then
      blame("love: pop without a push before it")
    end
    put(paint, pack("<B", POP))
    if saved then
      restoreState(saved)
    end
  end

  function graphics.origin()
    put(paint, pack("<B", ORIGIN))
  end

  function graphics.translate(dx, dy)
    dx, dy = checkNumber(dx, "translate", 1), checkNumber(dy, "translate", 2)
    put(paint, pack("<Bff", TRANSLATE, dx, dy))
  end

  function graphics.scale(x, y)
    x = checkNumber(x, "scale", 1)
    put(paint, pack("<Bff", SCALE, x, checkNumber(y or x, "scale", 2)))
  end

  function graphics.rotate(angle)
    put(paint, pack("<Bf", ROTATE, checkNumber(angle, "rotate", 1)))
  end

  return stack
end

local function listNames(functions)
  local names = {}
  for name in pairs(functions) do
    names[#names + 1] = name
  end
  table.sort(names)
  return table.concat(names, ", ")
end

local function newGraphics(host, paint, state)
  local graphics = {}
  addColors(graphics, paint, state)
  addShapes(graphics, paint)
  addTexts(graphics, paint, state, host)
  local stack = addTransforms(graphics, paint, state)

  function graphics.getWidth()
    return WIDTH
  end
  function graphics.getHeight()
    return HEIGHT
  end
  function graphics.getDimensions()
    return WIDTH, HEIGHT
  end

  local names = listNames(graphics)
  setmetatable(graphics, {
    __index = function(_, name)
      local text = "the playground has no love.graphics.%s. It has: %s"
      blame(text:format(tostring(name), names))
    end,
  })
  return graphics, stack
end

-- The rest of LÖVE --------------------------------------------------------------------------------

local function newKeyboard(held)
  local keyboard = {}
  function keyboard.isDown(...)
    for i = 1, select("#", ...) do
      local key = select(i, ...)
      if type(key) ~= "string" then
        blame("love: isDown takes names of keys, got " .. tostring(key))
      elseif held[key] then
        return true
      end
    end
    return false
  end
  function keyboard.setKeyRepeat() end -- a held key is told once, here
  return keyboard
end

local function newMouse(pointer)
  local mouse = {}
  function mouse.getX()
    return pointer.x
  end
  function mouse.getY()
    return pointer.y
  end
  function mouse.getPosition()
    return pointer.x, pointer.y
  end
  function mouse.isDown(...)
    for i = 1, select("#", ...) do
      if pointer[select(i, ...)] then
        return true
      end
    end
    return false
  end
  return mouse
end

-- Numbers by chance, the same at every run: Park and Miller, with products that doubles hold.
local function newRandom()
  local seed = 1
  local function random(low, high)
    seed = math.fmod(seed * 16807.0, 2147483647)
    local share = (seed - 1) / 2147483646
    if low == nil then
      return share
    elseif high == nil then
      low, high = 1, low
    end
    return low + math.floor(share * (high - low + 1))
  end
  local function setRandomSeed(value)
    seed = math.floor(math.abs(checkNumber(value, "setRandomSeed", 1)))
    seed = math.fmod(seed, 2147483646) + 1
  end
  return { random = random, setRandomSeed = setRandomSeed }
end

local function newLove(self)
  local love = {}
  self.graphics, self.stack = newGraphics(self.host, self.paint, self.state)
  love.graphics = self.graphics
  love.keyboard = newKeyboard(self.held)
  love.mouse = newMouse(self.pointer)
  love.math = newRandom()
  love.timer = {
    getTime = function()
      return self.steps * STEP
    end,
    getDelta = function()
      return STEP
    end,
    getFPS = function()
      return 60
    end,
  }
  love.window = { setTitle = function() end }
  love.event = {
    quit = function()
      self.isOver = true
    end,
  }
  return love
end

-- A run -------------------------------------------------------------------------------------------

local Run = {}
Run.__index = Run

local function call(self, name, ...)
  local callback = self.love[name]
  if callback == nil then
    return
  elseif type(callback) ~= "function" then
    error(("love.%s must be a function, got %s"):format(name, type(callback)), 0)
  end
  callback(...)
end

-- Worlds of the program's own: `last` is the one that was updated last. The library names the line
-- that calls it, so the call in between is a tail call.
local own = {}

local function watch(physics)
  local World = getmetatable(physics.newWorld())
  if own.class ~= World then
    local update = World.update
    function World.update(self, ...)
      own.last = self
      return update(self, ...)
    end
  end
  own.class, own.last = World, nil
end

--- Compiles a program and runs it up to the end of its love.load. Its globals are the globals.
--- Errors: those of the program.
---@param host table measure(text, size): the width of a text, px
---@param physics table the library, for `hash` and `stats`
function stage.start(host, physics, code)
  watch(physics)
  local self = setmetatable({ host = host, physics = physics, paint = newPaint() }, Run)
  self.state = { red = 1, green = 1, blue = 1, alpha = 1, lineWidth = 1 }
  self.state.font = newFont(host, FONT_SIZE)
  self.paint.background = { 0, 0, 0, 1 }
  self.held, self.pointer, self.steps, self.isOver = {}, { x = 0, y = 0 }, 0, false
  self.script = {}
  self.love = newLove(self)
  rawset(_G, "love", self.love)
  local chunk, problem = compile(code, "@" .. NAME)
  if not chunk then
    error(problem, 0)
  end
  chunk()
  call(self, "load", {}, {})
  return self
end

function Run:key(name, isDown)
  if isDown and not self.held[name] then
    self.held[name] = true
    call(self, "keypressed", name, name, false)
  elseif not isDown and self.held[name] then
    self.held[name] = nil
    call(self, "keyreleased", name, name)
  end
end

function Run:moveMouse(x, y)
  local dx, dy = x - self.pointer.x, y - self.pointer.y
  self.pointer.x, self.pointer.y = x, y
  call(self, "mousemoved", x, y, dx, dy, false)
end

function Run:button(number, isDown)
  self.pointer[number] = isDown or nil
  call(self, isDown and "mousepressed" or "mousereleased", self.pointer.x, self.pointer.y, number)
end

--- Returns the list of { name =, from =, to = } for "right:20-90,space:40", see Run:follow.
function stage.readKeys(text)
  local keys = {}
  for name, from, to in text:gmatch("([^,:]+):(%d+)%-?(%d*)") do
    keys[#keys + 1] = { name = name, from = tonumber(from), to = tonumber(to) or tonumber(from) }
  end
  return keys
end

--- One update of 1/60 s.
function Run:step()
  self.steps = self.steps + 1
  for _, key in ipairs(self.script) do
    if self.steps == key.from or self.steps == key.to + 1 then
      self:key(key.name, self.steps == key.from)
    end
  end
  call(self, "update", STEP)
end

--- Returns the paint commands of love.draw, as a string of bytes.
function Run:draw()
  local paint, state = self.paint, self.state
  local red, green, blue = unpackTable(paint.background)
  paint.count = 0
  put(paint, pack("<Bfff", CLEAR, red, green, blue))
  self.graphics.setColor(1, 1, 1, 1)
  self.graphics.setLineWidth(state.lineWidth)
  for i = #self.stack, 1, -1 do
    self.stack[i] = nil -- a push without its pop ends with the picture, as in LÖVE
  end
  call(self, "draw")
  return take(paint)
end

--- From now on keys are pressed as it is written: "right:20-90,space:40" holds the key right in
--- steps 20 to 90 and hits space in step 40.
function Run:follow(text)
  self.script = stage.readKeys(text)
end

--- The hash of the program's own world, else of the default world, as text.
function Run:hash()
  return ("%.0f"):format(own.last and own.last:hash() or self.physics.hash())
end

--- How many objects that world has.
function Run:objects()
  return (own.last or self.physics).stats.objects
end

return stage
