-- What stands around every example, so that none has to bring it: the panel at its side with the
-- source's comment and the times, pause, slow motion, single steps, and the physics made visible.

local drawWorld = require("physics.world.draw").draw
local input = require("input")
local inspector = require("inspector")
local look = require("look")
local meter = require("meter")
local panel = require("panel")
local source = require("source")
local view = require("view")

local frame = {}

local STEP, SLOW = 1 / 60, 0.2 -- s; share of the time that passes in slow motion
local BAR = 34 -- px, the height of the bar with the example's keys

-- What the x-ray shows, from one press of its key to the next; 0: nothing.
local VIEWS = {
  { alpha = 0.85, velocity = true },
  { alpha = 0.85, velocity = true, names = true, grid = true },
}

local example, about ---@type table, table
local clock = { isPaused = false, isSlow = false }
local viewed = 0

local function step()
  if clock.isPaused then
    example.update(STEP)
  end
  clock.isPaused = true
end

local BUTTONS = {
  {
    key = "p",
    text = "pause",
    press = function()
      clock.isPaused = not clock.isPaused
    end,
    isOn = function()
      return clock.isPaused
    end,
  },
  { key = "n", text = "next step", press = step },
  {
    key = "m",
    text = "slow motion",
    press = function()
      clock.isSlow = not clock.isSlow
    end,
    isOn = function()
      return clock.isSlow
    end,
  },
  {
    key = "x",
    text = "what the physics sees",
    press = function()
      viewed = (viewed + 1) % (#VIEWS + 1)
    end,
    isOn = function()
      return viewed > 0
    end,
  },
  {
    key = "r",
    text = "start again",
    press = function()
      clock.isPaused = false
      local restart = example.restart or example.load
      restart()
    end,
  },
  {
    key = "escape",
    label = "esc",
    text = "menu",
    press = function()
      return "menu"
    end,
  },
}

--- Puts the frame around an example, `{ name =, title = }`; returns it: a screen like any other.
function frame.around(entry)
  example = require(entry.name)
  about = { title = entry.title, comment = source.comment(entry.name) }
  return frame
end

function frame.load(...)
  clock.isPaused = false
  meter.reset()
  example.load(...)
end

function frame.leave()
  if example.leave then
    example.leave()
  end
end

function frame.update(dt)
  if not clock.isPaused then
    example.update(clock.isSlow and dt * SLOW or dt)
  end
  meter.update(example.world, dt)
end

function frame.keypressed(key, isRepeat)
  for _, button in ipairs(BUTTONS) do
    if button.key == key and (not isRepeat or button.press == step) then
      return button.press()
    end
  end
  if example.keypressed then
    example.keypressed(key, isRepeat)
  end
end

function frame.mousepressed(x, y)
  local button = panel.at(BUTTONS, x, y)
  if button then
    return button.press()
  elseif x < view.gameWidth and example.mousepressed then
    example.mousepressed(x, y)
  end
end

local function drawPhysics()
  local x, y, scale = 0, 0, 1
  if example.camera then
    x, y, scale = example.camera()
  end
  love.graphics.push()
  love.graphics.scale(scale or 1)
  love.graphics.translate(-x, -y)
  look.font(11) -- for the names
  drawWorld(example.world, VIEWS[viewed])
  love.graphics.pop()
  local mouseX, mouseY = input.mouse()
  if mouseX < view.gameWidth then
    inspector.draw(example.world, mouseX, mouseY, x, y, scale)
  end
end

local function drawGame()
  example.draw()
  if viewed > 0 and example.world then
    drawPhysics()
  end
  if view.hasKeys then
    look.panel(0, view.height - BAR, view.gameWidth, BAR, 0)
    look.keys(example.keys, 16, view.height - BAR + 5)
  end
end

function frame.draw()
  view.clip(0, 0, view.gameWidth, view.height, drawGame)
  if view.width > view.gameWidth then
    panel.draw(about, example.world, BUTTONS, panel.at(BUTTONS, input.mouse()))
  end
end

function frame.report()
  return example.report()
end

return frame
