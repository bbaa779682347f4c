-- An example that plays itself in the menu, with the keys of its file in demos/.

local input = require("input")
local recording = require("recording")
local view = require("view")

local preview = {}

local STEP, MOST = 1 / 60, 2 -- s; steps a frame: a slow machine shows it slower
local LINGER = 120 -- steps after the last key, until it starts again

local example, spans, length, step, untilStep ---@type table, table, number, integer, number

local function restart()
  step, untilStep = 0, 0
  example.load()
end

-- The keys and the mouse that choose in the menu are not meant for the example.
local function inPrivate(call, ...)
  input.isReal = false
  call(...)
  input.isReal, input.held = true, {}
end

--- Shows another example from now on.
function preview.load(name)
  local file = "demos/" .. name .. ".keys"
  local text = love.filesystem.getInfo(file) and love.filesystem.read(file) or ""
  spans, length = recording.read(text)
  example = require(name)
  inPrivate(restart)
end

local function press(key)
  if example.keypressed then
    example.keypressed(key)
  end
end

local function advance()
  step = step + 1
  if length > 0 and step > length + LINGER then
    restart()
  end
  recording.play(spans, step, press, example.mousepressed)
  example.update(STEP)
end

local function run(dt)
  untilStep = math.max(untilStep - dt, -MOST * STEP)
  while untilStep < -STEP / 2 do
    untilStep = untilStep + STEP
    advance()
  end
end

function preview.update(dt)
  inPrivate(run, dt)
end

--- Draws the picture of the game with its top-left corner at x, y.
function preview.draw(x, y, scale)
  love.graphics.push()
  love.graphics.translate(x, y)
  love.graphics.scale(scale)
  view.clip(0, 0, view.gameWidth, view.height, example.draw)
  love.graphics.pop()
end

return preview
