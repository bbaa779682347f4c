-- What the hilly and the flat level look like alike: the hero, crates, coins, a flag, the status.

local look = require("look")

local sprites = {}

function sprites.crate(x, y, size)
  look.box(x, y, size, size, "orange")
  look.color("red", 0.8)
  love.graphics.setLineWidth(4)
  love.graphics.line(x + 7, y + 7, x + size - 7, y + size - 7)
  love.graphics.line(x + 7, y + size - 7, x + size - 7, y + 7)
  love.graphics.rectangle("line", x + 3, y + 3, size - 6, size - 6, 3)
end

--- Draws a coin that turns and bobs, in the box of an object. `clock`: s.
function sprites.coin(coin, clock)
  local x, y = coin.x + coin.width / 2, coin.y + coin.height / 2
  local turn = math.abs(math.cos(clock * 3 + coin.x * 0.01))
  y = y + math.sin(clock * 4 + coin.x * 0.02) * 2
  look.color("orange")
  love.graphics.ellipse("fill", x, y + 1, 2 + 8 * turn, 11)
  look.color("yellow")
  love.graphics.ellipse("fill", x, y, 1 + 8 * turn, 10)
  look.color("white", 0.8)
  love.graphics.ellipse("fill", x - 2 * turn, y - 3, 2 * turn, 3)
end

--- Draws a flag at the left edge of an object, which has `reached` when it is won. `clock`: s.
function sprites.flag(flag, clock)
  local x, y = flag.x + 4, flag.y
  look.color("silver")
  love.graphics.rectangle("fill", x, y, 5, flag.height, 2)
  local color = flag.reached and "lime" or "yellow"
  for i = 0, 5 do
    local wave = math.sin(clock * 5 - i * 0.8) * i * 0.7
    look.color(color, 1 - i % 2 * 0.12)
    love.graphics.rectangle("fill", x - 8 - i * 8, y + 5 + wave + i * 1.5, 8.5, 30 - i * 3)
  end
end

--- Draws the hero in a box. `stretch`: how much higher and thinner it is, 0..1; `step`: px, how far
--- the feet are beside their places; `lookX`, `lookY`: where it looks, -1..1; `hasShadow`: it
--- stands.
function sprites.hero(x, y, width, height, stretch, step, lookX, lookY, hasShadow)
  local drawnWidth, drawnHeight = width * (1 - stretch * 0.7), height * (1 + stretch)
  local left, top = x + (width - drawnWidth) / 2, y + height - drawnHeight
  if hasShadow then
    look.color("night", 0.3)
    love.graphics.ellipse("fill", x + width / 2, y + height, width * 0.65, 4)
  end
  look.color("plum")
  love.graphics.rectangle("fill", left + 3 + step, y + height - 7, 8, 7, 2)
  love.graphics.rectangle("fill", left + drawnWidth - 11 - step, y + height - 7, 8, 7, 2)
  look.color("orange")
  love.graphics.rectangle("fill", left, top, drawnWidth, drawnHeight - 4, 8)
  look.color("yellow")
  love.graphics.rectangle("fill", left, top + drawnHeight * 0.56, drawnWidth, 6)
  look.eyes(left, top, drawnWidth, drawnHeight, lookX, lookY)
end

--- Draws the coins, tries and time of a level, and at `top` px what it says when it is won.
function sprites.status(state, top)
  look.panel(16, 14, 244, 40)
  look.color("yellow")
  love.graphics.circle("fill", 38, 34, 9)
  look.color("white")
  look.text(("%d / %d"):format(state.coins, state.coinsInLevel), 54, 24, 16)
  look.color("silver")
  look.text(("tries %d"):format(state.deaths + 1), 128, 24, 16)
  look.text(("%.1f s"):format(state.wonAt or state.time), 200, 24, 16)
  if state.won then
    local text = "%d of %d coins in %.1f s"
    look.won(text:format(state.coins, state.coinsInLevel, state.wonAt), top)
  end
end

return sprites
