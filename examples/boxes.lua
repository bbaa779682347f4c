-- Coloured boxes in a world: what the short examples have in common. The looks of an object are
-- fields of its own, of which the library takes no notice:
--
--   color        a name from the palette; without one it is not drawn
--   alpha        its opacity; without one sensors, and what is not active, are translucent
--   isTile       it is one of many that look like one; a whole group is or is not
--   isCoin       it is round and bobs
--   lookX lookY  it has eyes, which look there (-1..1)

local look = require("look")
local view = require("view")

local boxes = {}

--- Adds an object with a colour to a world; `fields` are its other fields.
function boxes.add(world, group, color, x, y, width, height, fields)
  local object = fields or {}
  object.color, object.x, object.y, object.width, object.height = color, x, y, width, height
  return world:add(group, object)
end

-- Lifts and crates pass through a coin: a sensor that one passes through says nothing.
local COIN_MASK = { lifts = false, crates = false }

--- Adds a coin with its middle at x, y. Touching it adds one to `purse.coins`.
function boxes.addCoin(world, x, y, purse)
  local coin = { static = true, sensor = true, isCoin = true, mask = COIN_MASK }
  function coin.onBegin()
    purse.coins = purse.coins + 1
    world:remove(coin) -- callbacks may do that: the step is over when they are called
  end
  return boxes.add(world, "coins", "yellow", x - 9, y - 9, 18, 18, coin)
end

--- Reads a level, a text with a row of characters per line: calls `build(character, x, y)` with the
--- top-left corner of each one's tile, row by row.
function boxes.build(level, tile, build)
  local row = 0
  for text in level:gmatch("[^\n]+") do
    for column = 1, #text do
      build(text:sub(column, column), (column - 1) * tile, row * tile)
    end
    row = row + 1
  end
end

local function drawCoin(coin, time)
  local radius = coin.width / 2
  local x, y = coin.x + radius, coin.y + radius + math.sin(time * 4 + coin.x + coin.y) * 2
  look.color("orange")
  love.graphics.circle("fill", x, y + 1, radius)
  look.color("yellow")
  love.graphics.circle("fill", x, y, radius - 1)
  look.color("white", 0.7)
  love.graphics.circle("fill", x - radius / 3, y - radius / 3, radius / 4)
end

-- Stripes that run as a belt does.
local function drawBelt(belt, time)
  look.color("silver")
  for x = belt.x + time * belt.surfaceSpeed % 24, belt.x + belt.width - 9, 24 do
    love.graphics.rectangle("fill", x, belt.y + 2, 9, 4)
  end
end

-- Tiles stand beside each other without a seam. Seen from above, they show a front where no other
-- tile hides it.
local function drawTiles(tiles)
  for pass = 1, 2 do
    for _, tile in ipairs(tiles) do
      look.color(pass == 1 and "night" or tile.color)
      local shift = pass == 1 and 9 or 0
      love.graphics.rectangle("fill", tile.x, tile.y + shift, tile.width, tile.height)
    end
  end
end

local function drawObject(object, time)
  local x, y, width, height = object.x, object.y, object.width, object.height
  if object.isCoin then
    return drawCoin(object, time)
  end
  local isPale = object.sensor or object.active == false
  local alpha = object.alpha or isPale and 0.35 or nil
  if object.radius then
    look.ball(x, y, object.radius, object.color, alpha)
  else
    look.box(x, y, width, height, object.color, alpha)
  end
  if object.surfaceSpeed then
    drawBelt(object, time)
  elseif object.lookX then
    look.eyes(x, y, width, height, object.lookX, object.lookY)
  end
end

--- Draws groups of a world, "walls coins players", each on top of the ones before. `time`: for
--- what moves by itself.
function boxes.draw(world, groups, time)
  for name in groups:gmatch("%S+") do
    local group = world.objects[name] or {}
    if group[1] and group[1].isTile then
      drawTiles(group)
    end
    for _, object in ipairs(group) do
      if object.color and not object.isTile then
        drawObject(object, time)
      end
    end
  end
end

--- Draws a row of words in the palette's colours, `{ "yellow", "3 coins", "silver", "2 left" }`.
function boxes.status(words)
  local x, font, width = 24, look.font(17), -6
  for i = 2, #words, 2 do
    width = width + font:getWidth(words[i]) + (words[i] ~= "" and 30 or 0)
  end
  look.panel(12, 4, width, 32)
  look.panel(12, 4, width, 32) -- twice: hardly anything shines through
  for i = 1, #words, 2 do
    look.color(words[i])
    x = x + look.text(words[i + 1], x, 10, 17):getWidth(words[i + 1]) + 30
  end
end

--- Draws the ground, from a height down to the lower edge of the picture.
function boxes.ground(y)
  look.color("dusk")
  love.graphics.rectangle("fill", 0, y, view.gameWidth, view.height - y)
  look.color("slate")
  love.graphics.rectangle("fill", 0, y, view.gameWidth, 4)
end

return boxes
