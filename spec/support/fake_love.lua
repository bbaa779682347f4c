--- Stands in for LÖVE, as far as the examples need it: no window, but what is asked for is
--- answered, and drawing with anything but numbers is refused.

local fakeLove = {}

-- Functions of love.graphics with arguments that are numbers, from the given one on.
local DRAWING = { rectangle = 2, circle = 2, ellipse = 2, line = 1, translate = 1 }

local function nothing() end

local function newFont(size)
  return {
    getWidth = function(_, text)
      return #text * size * 0.6
    end,
    getHeight = function()
      return size
    end,
  }
end

-- An image, a canvas, a batch: has every method, and none does anything.
local function newDrawable()
  return setmetatable({}, {
    __index = function()
      return nothing
    end,
  })
end

local function checked(name, first)
  return function(...)
    for i = first, select("#", ...) do
      local value = select(i, ...)
      if type(value) ~= "number" or value ~= value then
        error(("love.graphics.%s: argument %d is %s"):format(name, i, tostring(value)), 2)
      end
    end
  end
end

-- `texts`: all that is written goes there.
local function newGraphics(texts)
  local graphics = setmetatable({}, {
    __index = function()
      return nothing
    end,
  })
  for name, first in pairs(DRAWING) do
    graphics[name] = checked(name, first)
  end
  function graphics.getDimensions()
    return 1200, 640
  end
  function graphics.transformPoint(x, y)
    return x, y
  end
  function graphics.getColor()
    return 1, 1, 1, 1
  end
  function graphics.getLineWidth()
    return 1
  end
  function graphics.getFont()
    return newFont(12)
  end
  function graphics.print(text)
    assert(type(text) == "string", "love.graphics.print: no text")
    texts[#texts + 1] = text
  end
  graphics.printf, graphics.newFont = graphics.print, newFont
  for _, name in ipairs({ "newCanvas", "newImage", "newMesh", "newQuad", "newSpriteBatch" }) do
    graphics[name] = newDrawable
  end
  return graphics
end

-- Numbers that only have to differ; LÖVE's own are others.
local function newRandomGenerator(seed)
  local state = seed * 16807
  return {
    random = function(_, low, high)
      state = state * 16807 % 2147483647
      if not low then
        return state / 2147483647
      elseif not high then
        low, high = 1, low
      end
      return math.floor(low + state % (high - low + 1))
    end,
  }
end

--- Returns a table to be the global `love`; its files are those of a folder. `mouse.x`, `mouse.y`
--- and `mouse.isHeld` of the second result are the mouse; the third is a list of all texts that are
--- written.
function fakeLove.new(folder)
  local mouse = { x = 0, y = 0, isHeld = false }
  local texts = {}
  local love = { graphics = newGraphics(texts) }
  love.filesystem = {
    getSource = function()
      return folder
    end,
    getInfo = function(name)
      local file = io.open(folder .. "/" .. name)
      return file and file:close() and {}
    end,
    read = function(name)
      local file = assert(io.open(folder .. "/" .. name, "rb"))
      local text = file:read("*a")
      file:close()
      return text
    end,
    load = function(name)
      return loadfile(folder .. "/" .. name)
    end,
    lines = function(name)
      return io.lines(folder .. "/" .. name)
    end,
  }
  love.keyboard = {
    isDown = function()
      return false
    end,
    setKeyRepeat = nothing,
  }
  love.mouse = {
    getPosition = function()
      return mouse.x, mouse.y
    end,
    isDown = function()
      return mouse.isHeld
    end,
  }
  love.math = {
    newRandomGenerator = newRandomGenerator,
    noise = function(x)
      return x % 1
    end,
  }
  love.timer = { getTime = os.clock }
  love.event = { quit = nothing }
  love.system = {
    getOS = function()
      return "Linux"
    end,
  }
  return love, mouse, texts
end

return fakeLove
