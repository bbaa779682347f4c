-- The panel beside an example: what it shows, what it costs, and the buttons.

local look = require("look")
local meter = require("meter")
local physics = require("physics")
local view = require("view")

local panel = {}

local X, WIDTH, MARGIN = view.gameWidth, view.width - view.gameWidth, 18 -- px
local LEFT, INNER = X + MARGIN, WIDTH - 2 * MARGIN
local TIMES_Y, GRAPH_Y, GRAPH_HEIGHT, COUNTERS_Y = 262, 308, 48, 368
local BUTTONS_Y, BUTTON = 438, 33 -- px; the height of a button
local SCALES = { 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100 } -- ms, upper ends of the graph
local SHOWN = 0.95 -- of the steps fit into the graph
local COUNTERS = { "objects", "movers", "resting", "pairs", "contacts", "events" }

--- Returns the button at a point, or nil.
function panel.at(buttons, x, y)
  for i, button in ipairs(buttons) do
    local top = BUTTONS_Y + (i - 1) * BUTTON
    if physics.inside(x, y, 0, 0, X + 8, top, WIDTH - 16, BUTTON) then
      return button
    end
  end
end

local function milliseconds(time)
  return time and ("%.2f ms"):format(time) or "-"
end

local function drawTime(name, time, y)
  look.color("silver")
  look.text(name, LEFT, y, 14)
  look.color("white")
  look.text(milliseconds(time), LEFT, y, 14, INNER, "right")
end

-- The lowest scale that shows all bars but a few outliers, or the highest one.
local function findScale(times)
  local sorted = {}
  for i, time in ipairs(times) do
    sorted[i] = time
  end
  table.sort(sorted)
  local high = sorted[math.ceil(#sorted * SHOWN)] or 0
  for _, scale in ipairs(SCALES) do
    if high <= scale then
      return scale
    end
  end
  return SCALES[#SCALES]
end

local function drawGraph()
  local scale = findScale(meter.steps)
  look.color("dusk", 0.6)
  love.graphics.rectangle("fill", LEFT, GRAPH_Y, INNER, GRAPH_HEIGHT, 4)
  for i, time in ipairs(meter.steps) do
    look.color(time > scale and "orange" or "sky")
    local height = math.min(1.0, time / scale) * GRAPH_HEIGHT
    love.graphics.rectangle("fill", LEFT + i * 2, GRAPH_Y + GRAPH_HEIGHT - height, 2, height)
  end
  look.color("silver")
  look.text(("%g ms"):format(scale), LEFT + 5, GRAPH_Y + 3, 11)
end

local function drawCounters(stats)
  for i, name in ipairs(COUNTERS) do
    local x = LEFT + (i - 1) % 2 * (INNER / 2 + 6)
    local y = COUNTERS_Y + math.floor((i - 1) / 2) * 19
    look.color("slate")
    look.text(name, x, y, 13)
    look.color("silver")
    look.text(tostring(stats[name]), x, y, 13, INNER / 2 - 6, "right")
  end
end

local function drawButton(button, y, isHovered)
  local isOn = button.isOn and button.isOn()
  if isOn or isHovered then
    look.color(isOn and "blue" or "dusk")
    love.graphics.rectangle("fill", X + 8, y, WIDTH - 16, BUTTON - 3, 6)
  end
  local x = look.key(button.label or button.key, LEFT, y + 3)
  look.color((isOn or isHovered) and "white" or "silver")
  look.text(button.text, x + 6, y + 6, 14)
end

--- Draws the panel. `about`: `{ title =, comment = }`; `world`: its counters are shown, or nil;
--- `hovered`: the button under the mouse, or nil.
function panel.draw(about, world, buttons, hovered)
  look.color("night")
  love.graphics.rectangle("fill", X, 0, WIDTH, view.height)
  look.color("sky")
  love.graphics.rectangle("fill", X, 0, 3, view.height)
  look.color("white")
  look.text(about.title, LEFT, 18, 26)
  look.color("silver")
  look.text(about.comment, LEFT, 58, 14, INNER)
  drawTime("a frame", meter.frame, TIMES_Y)
  if world then
    drawTime("a physics step", meter.step, TIMES_Y + 20)
    drawGraph()
    drawCounters(world.stats)
  end
  for i, button in ipairs(buttons) do
    drawButton(button, BUTTONS_Y + (i - 1) * BUTTON, button == hovered)
  end
end

return panel
