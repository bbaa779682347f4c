-- Colours, fonts and small drawings that all examples share.

local view = require("view")

local look = {}

-- "Sweetie 16", a palette by GrafxKid.
local function hex(code)
  local red, green, blue = code:match("(..)(..)(..)")
  return { tonumber(red, 16) / 255, tonumber(green, 16) / 255, tonumber(blue, 16) / 255 }
end

look.colors = {
  night = hex("1a1c2c"),
  plum = hex("5d275d"),
  red = hex("b13e53"),
  orange = hex("ef7d57"),
  yellow = hex("ffcd75"),
  lime = hex("a7f070"),
  green = hex("38b764"),
  teal = hex("257179"),
  navy = hex("29366f"),
  blue = hex("3b5dc9"),
  sky = hex("41a6f6"),
  cyan = hex("73eff7"),
  white = hex("f4f4f4"),
  silver = hex("94b0c2"),
  slate = hex("566c86"),
  dusk = hex("333c57"),
}

--- Sets the colour: a name from the palette and an opacity.
function look.color(name, alpha)
  local color = look.colors[name]
  love.graphics.setColor(color[1], color[2], color[3], alpha or 1)
end

local fonts, sharpness = {}, nil

--- Sets the font to a size, and returns it. Its letters are as sharp as the screen.
function look.font(size)
  if sharpness ~= view.sharpness() then
    fonts, sharpness = {}, view.sharpness() -- the window has another size
  end
  fonts[size] = fonts[size] or love.graphics.newFont(size, "normal", sharpness)
  love.graphics.setFont(fonts[size])
  return fonts[size]
end

--- Writes text in a size; returns the font. `width` wraps it, `align` needs a width.
function look.text(text, x, y, size, width, align)
  local font = look.font(size)
  if width then
    love.graphics.printf(text, x, y, width, align or "left")
  else
    love.graphics.print(text, x, y)
  end
  return font
end

local gradients = {}

local function newGradient(names)
  local vertices = {}
  for i, name in ipairs(names) do
    local color, y = look.colors[name], (i - 1) / (#names - 1) * view.height
    vertices[#vertices + 1] = { 0, y, 0, 0, color[1], color[2], color[3], 1 }
    vertices[#vertices + 1] = { view.width, y, 0, 0, color[1], color[2], color[3], 1 }
  end
  return love.graphics.newMesh(vertices, "strip", "static")
end

--- Fills the picture with colours that flow into each other from the top to the bottom.
function look.sky(...)
  local key = table.concat({ ... }, " ")
  gradients[key] = gradients[key] or newGradient({ ... })
  love.graphics.setColor(1, 1, 1, 1)
  love.graphics.draw(gradients[key])
end

--- Fills the game's part of the picture with the squares of a draughtboard.
function look.squares(size, color, alpha)
  look.color(color, alpha)
  for row = 0, math.ceil(view.height / size) - 1 do
    for x = row % 2 * size, view.gameWidth - size, 2 * size do
      love.graphics.rectangle("fill", x, row * size, size, size)
    end
  end
end

--- Draws a dark panel for text. `radius`: of its corners, px (10).
function look.panel(x, y, width, height, radius)
  look.color("night", 0.78)
  love.graphics.rectangle("fill", x, y, width, height, radius or 10)
end

--- Draws what a game says when it is won.
function look.won(text, top)
  local x = view.gameWidth / 2 - 190
  look.panel(x, top, 380, 120)
  look.color("lime")
  look.text("You made it!", x, top + 20, 34, 380, "center")
  look.color("white")
  look.text(text, x, top + 74, 17, 380, "center")
end

--- Draws a hint for the player, with its middle at x.
function look.sign(text, x, y)
  local _, breaks = text:gsub("\n", "")
  local width = look.font(15):getWidth(text) + 28
  look.color("night", 0.55)
  love.graphics.rectangle("fill", x - width / 2, y - 5, width, 29 + breaks * 18, 8)
  look.color("white", 0.9)
  look.text(text, x - width / 2, y, 15, width, "center")
end

--- Draws a slider with its knob at a share (0..1) of its width.
function look.slider(x, y, width, share, color)
  look.color("slate")
  love.graphics.rectangle("fill", x, y, width, 8, 4)
  look.color(color)
  love.graphics.rectangle("fill", x, y, width * share, 8, 4)
  love.graphics.circle("fill", x + width * share, y + 4, 11)
end

--- Draws a box with a soft shadow and a lighter upper edge.
function look.box(x, y, width, height, color, alpha)
  look.color("night", 0.25 * (alpha or 1))
  love.graphics.rectangle("fill", x + 3, y + 4, width, height, 4)
  look.color(color, alpha)
  love.graphics.rectangle("fill", x, y, width, height, 4)
  love.graphics.setColor(1, 1, 1, 0.22 * (alpha or 1))
  love.graphics.rectangle("fill", x + 2, y + 2, width - 4, math.min(4, height / 4), 2)
end

--- Draws a ball in its square, with the same shadow and light.
function look.ball(x, y, radius, color, alpha)
  look.color("night", 0.25 * (alpha or 1))
  love.graphics.circle("fill", x + radius + 3, y + radius + 4, radius)
  look.color(color, alpha)
  love.graphics.circle("fill", x + radius, y + radius, radius)
  love.graphics.setColor(1, 1, 1, 0.22 * (alpha or 1))
  love.graphics.circle("fill", x + radius * 0.7, y + radius * 0.6, radius * 0.3)
end

--- Draws two eyes in a box, which look to the given direction (-1..1 on both axes).
function look.eyes(x, y, width, height, lookX, lookY)
  local radius = math.min(width, height) * 0.17
  for _, share in ipairs({ 0.3, 0.7 }) do
    local eyeX, eyeY = x + width * share + lookX * width * 0.08, y + height * 0.36
    look.color("white")
    love.graphics.circle("fill", eyeX, eyeY, radius)
    look.color("night")
    love.graphics.circle(
      "fill",
      eyeX + lookX * radius * 0.45,
      eyeY + lookY * radius * 0.45,
      radius / 2
    )
  end
end

-- The default font has no arrows.
local ARROWS = {
  left = { -5, 0, 4, -6, 4, 6 },
  right = { 5, 0, -4, -6, -4, 6 },
  up = { 0, -5, -6, 4, 6, 4 },
  down = { 0, 5, -6, -4, 6, -4 },
}

--- Draws one key of the keyboard; returns the x where the next thing goes.
function look.key(key, x, y)
  local arrow = ARROWS[key]
  local width = arrow and 26 or look.font(13):getWidth(key) + 16
  look.color("night", 0.9)
  love.graphics.rectangle("fill", x, y + 2, width, 24, 5)
  look.color("slate")
  love.graphics.rectangle("fill", x, y, width, 23, 5)
  look.color("white")
  if arrow then
    local points = {}
    for i = 1, 6, 2 do
      points[i], points[i + 1] = x + width / 2 + arrow[i], y + 11.5 + arrow[i + 1]
    end
    love.graphics.polygon("fill", points)
  else
    look.text(key, x + 8, y + 3, 13)
  end
  return x + width + 4
end

--- Draws a row of key hints, `{ "left", "right", "run" }`: the last word says what the keys do.
--- Returns the x where the row ends.
function look.keys(hints, x, y)
  for _, hint in ipairs(hints) do
    for i = 1, #hint - 1 do
      x = look.key(hint[i], x, y)
    end
    look.color("silver")
    local font = look.text(hint[#hint], x + 3, y + 3, 13)
    x = x + font:getWidth(hint[#hint]) + 22
  end
  return x
end

return look
