--- Stands in for LÖVE, as far as the examples need it: no window, but what is asked for is
--- answered, and drawing with anything but numbers is refused.

local files = require("spec.support.files")

local fakeLove = {}

-- Functions of love.graphics with arguments that are numbers, from the given one on.
local DRAWING = { rectangle = 2, circle = 2, ellipse = 2, line = 1, translate = 1 }

local function nothing() end

local function always(a, b, c, d)
  return function()
    return a, b, c, d
  end
end

-- Has every method, and none does anything: an image, a canvas, a batch.
local function newDrawable()
  return setmetatable({}, { __index = always(nothing) })
end

local function newFont(size)
  local font = { getHeight = always(size) }
  function font.getWidth(_, text)
    return #text * size * 0.6
  end
  return font
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
  local graphics = newDrawable()
  for name, first in pairs(DRAWING) do
    graphics[name] = checked(name, first)
  end
  function graphics.transformPoint(x, y)
    return x, y
  end
  graphics.getDimensions, graphics.getLineWidth = always(1200, 640), always(1)
  graphics.getColor, graphics.getFont = always(1, 1, 1, 1), always(newFont(12))
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
  local function within(call)
    return function(name)
      return call(folder .. "/" .. name)
    end
  end
  love.filesystem = {
    getSource = always(folder),
    getInfo = within(function(path)
      local file = io.open(path)
      return file and file:close() and {}
    end),
    read = within(files.read),
    load = within(loadfile),
    lines = within(io.lines),
  }
  love.keyboard = { isDown = always(false), setKeyRepeat = nothing }
  love.mouse = {
    getPosition = function()
      return mouse.x, mouse.y
    end,
    isDown = function()
      return mouse.isHeld
    end,
  }
  love.math = { newRandomGenerator = newRandomGenerator }
  function love.math.noise(x)
    return x % 1
  end
  love.timer, love.event = { getTime = os.clock }, { quit = nothing }
  love.system = { getOS = always("Linux") }
  return love, mouse, texts
end

return fakeLove
