-- Coloured boxes in a world: what the short examples have in common.

local look = require("look")

local boxes = {}

--- Adds an object with a colour to a world; `fields` are its other fields.
function boxes.add(world, group, color, x, y, width, height, fields)
  local object = fields or {}
  object.color, object.x, object.y, object.width, object.height = color, x, y, width, height
  return world:add(group, object)
end

--- Draws the groups of a world, each on top of the ones before. Sensors, and what is not active,
--- are translucent; what has no colour is not drawn.
function boxes.draw(world, groups)
  for _, group in ipairs(groups) do
    for _, object in ipairs(world.objects[group] or {}) do
      if object.color then
        local alpha = (object.sensor or object.active == false) and 0.35 or object.alpha
        look.box(object.x, object.y, object.width, object.height, object.color, alpha)
      end
    end
  end
end

--- Draws coins, which bob and are round.
function boxes.drawCoins(coins, time)
  look.color("yellow")
  for _, coin in ipairs(coins) do
    local radius = coin.width / 2
    local bob = math.sin(time * 4 + coin.x + coin.y) * 2
    love.graphics.circle("fill", coin.x + radius, coin.y + radius + bob, radius)
  end
end

--- Draws a row of words in the palette's colours, `{ "yellow", "3 coins", "silver", "2 left" }`.
function boxes.status(words, x, y)
  for i = 1, #words, 2 do
    look.color(words[i])
    x = x + look.text(words[i + 1], x, y, 17):getWidth(words[i + 1]) + 30
  end
end

--- Draws the bar at the bottom that names the keys.
function boxes.keys(hints)
  look.panel(0, 606, 960, 40)
  hints[#hints + 1] = { "r", "again" }
  hints[#hints + 1] = { "esc", "menu" }
  look.keys(hints, 16, 611)
end

return boxes
