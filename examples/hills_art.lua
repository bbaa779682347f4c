-- How the hills look. Reads the objects of their world and changes none of them.

local look = require("look")
local scenery = require("hills_scenery")
local sparks = require("sparks")
local sprites = require("sprites")
local view = require("view")

local art = {}

local FOOT = 34 -- px, how far below itself an object looks for the ground that it is drawn on

local CARRIERS = { "ground", "planks", "turtles" } -- what may slope

local world, player, state ---@type physics.World, any, table
local camera, clock, squash, wasOnGround ---@type table, number, number, any

function art.load(gameWorld, gamePlayer, gameState)
  world, player, state = gameWorld, gamePlayer, gameState
  clock, squash, wasOnGround = 0, 0, true
  camera = { x = player.x - view.gameWidth / 2, y = player.y - 330 }
  sparks.clear()
  scenery.load(state)
end

-- ------------------------------------------------------------------------------ how things lean --

-- Notes where the middle of an object's lower edge is drawn, and the gradient there. The library
-- keeps the corner on the uphill side on the ground. A picture is turned, so its middle is there.
local function lean(object, dt)
  local ground, gradient = world:ground(object)
  local share = object.gradient and math.min(1, 16 * dt) or 1
  object.gradient = (object.gradient or 0) * (1 - share) + gradient * share
  object.on = ground and not (ground.static or ground.kinematic) and ground or nil
  object.footX, object.footY = object.x + object.width / 2, object.y + object.height
  if ground and not object.on then
    local x, y = object.footX, object.footY
    local _, _, foot = world:raycast(x, y - 2, x, y + FOOT, CARRIERS)
    object.footY = foot or y
  end
end

-- Moves and turns what is drawn next, so that the middle of the object's lower edge is at 0, 0.
-- What stands on an object leans as that does.
local function place(object)
  local below = object.on
  if below and below.footX then
    place(below)
    local x, y = object.footX - below.x - below.width / 2, object.footY - below.y - below.height
    love.graphics.translate(x, y)
  else
    love.graphics.translate(object.footX, object.footY)
    love.graphics.rotate(math.atan(object.gradient))
  end
end

local function follow(dt)
  local width, height = view.gameWidth, view.height
  local x = player.x + player.width / 2 + player.hero.facing * 70 - width / 2
  x = math.max(0, math.min(state.width - width, x))
  camera.x = camera.x + (x - camera.x) * math.min(1, 6 * dt)
  camera.y = camera.y + (player.y - height * 0.55 - camera.y) * math.min(1, 5 * dt)
end

function art.update(dt)
  clock = clock + dt
  sparks.update(dt)
  follow(dt)
  for _, group in ipairs({ "crates", "carts", "players" }) do
    for _, object in ipairs(world.objects[group]) do
      lean(object, dt)
    end
  end
  local onGround = player.touching.bottom
  if onGround and not wasOnGround then
    squash = 0.32
  end
  wasOnGround = onGround
  squash = squash - squash * math.min(1, 12 * dt)
end

--- Throws sparks from the middle of an object.
art.burst = sparks.burst

-- --------------------------------------------------------------------------------------- things --

local draw = {}

function draw.planks(plank)
  local x, width, low = plank.x, plank.width, plank.y + plank.height
  local left = plank.slope == "left" and plank.y or low
  local right = plank.slope == "left" and low or plank.y
  look.color("night", 0.8)
  love.graphics.setLineWidth(2)
  love.graphics.line(x, left - 34, x + width, right - 34)
  love.graphics.line(x + 1, left - 34, x + 1, left)
  look.color("red")
  love.graphics.polygon("fill", x + 1, left, x + 18, right, x + 18, right + 8, x + 1, left + 8)
  look.color("orange")
  love.graphics.polygon("fill", x + 1, left, x + 18, right, x + 18, right + 3, x + 1, left + 3)
end

function draw.coins(coin)
  sprites.coin(coin, clock)
end

function draw.flags(flag)
  sprites.flag(flag, clock)
end

function draw.crates(crate)
  place(crate)
  sprites.crate(-crate.width / 2, -crate.height, crate.width)
end

function draw.turtles(part)
  if not part.isShell then
    return
  end
  local x, y, low = part.x, part.y, part.y + part.height
  local direction = part.direction
  local headX = x + 25 + direction * 92
  look.color("teal")
  love.graphics.ellipse("fill", headX, low - 8 + math.sin(clock * 3) * 2, 20, 15)
  love.graphics.ellipse("fill", x + 25 + direction * 70, low + 6, 26, 11)
  love.graphics.ellipse("fill", x + 25 - direction * 60, low + 14, 30, 9)
  look.eyes(headX - 20 + direction * 5, low - 20, 40, 30, direction, 0)
  look.color("night", 0.4)
  love.graphics.polygon("fill", x - 54, low + 6, x - 2, y + 4, x + 52, y + 4, x + 104, low + 6)
  look.color("green")
  love.graphics.polygon("fill", x - 50, low + 2, x, y, x + 50, y, x + 100, low + 2)
  look.color("teal")
  for i = -1, 1 do
    local middle = x + 25 + i * 36
    local top = i == 0 and y + 6 or y + 16
    love.graphics.polygon(
      "fill",
      middle - 12,
      top + 14,
      middle - 7,
      top,
      middle + 7,
      top,
      middle + 12,
      top + 14
    )
  end
  look.color("lime")
  love.graphics.setLineWidth(3)
  love.graphics.line(x - 49, low, x, y + 1, x + 50, y + 1, x + 99, low)
end

function draw.cars(car)
  local x, y = car.x + car.width / 2, car.y
  look.color("night")
  love.graphics.setLineWidth(3)
  love.graphics.line(car.x + 4, y, x, y - 84, car.x + car.width - 4, y)
  look.color("silver")
  love.graphics.circle("fill", x, y - 86, 8)
  look.box(car.x, y, car.width, car.height, "red")
  look.color("yellow")
  love.graphics.rectangle("fill", car.x + 6, y + 6, car.width - 12, 3)
end

function draw.carts(cart)
  place(cart)
  look.color("night")
  love.graphics.polygon("fill", -38, -30, 38, -30, 30, -4, -30, -4)
  look.color("slate")
  love.graphics.polygon("fill", -36, -28, 36, -28, 29, -5, -29, -5)
  look.color("silver")
  love.graphics.rectangle("fill", -39, -32, 78, 5, 2)
  for side = -1, 1, 2 do
    look.color("night")
    love.graphics.circle("fill", side * 20, -8, 9)
    look.color("silver")
    love.graphics.circle("fill", side * 20, -8, 4)
    local angle = cart.x / 9
    love.graphics.setLineWidth(2)
    love.graphics.line(side * 20, -8, side * 20 + math.cos(angle) * 8, -8 + math.sin(angle) * 8)
  end
end

function draw.buffers(buffer)
  look.box(buffer.x, buffer.y, buffer.width, buffer.height, "red")
  look.color("white")
  love.graphics.rectangle("fill", buffer.x, buffer.y + 6, buffer.width, 6)
  love.graphics.rectangle("fill", buffer.x, buffer.y + 18, buffer.width, 6)
end

function draw.players()
  local onGround = player.touching.bottom
  local stretch = math.min(0.2, math.abs(player.vy) / 6000) - squash
  local step = onGround and math.sin(player.x * 0.12) * 4 or 3
  local lookY = math.max(-1, math.min(1, player.vy / 500))
  local width, height, facing = player.width, player.height, player.hero.facing
  place(player)
  sprites.hero(-width / 2, -height, width, height, stretch, step, facing, lookY, onGround)
end

function draw.water(water)
  local x, y, width, height = water.x, water.y, water.width, water.height
  for i = 0, 5 do
    look.color("blue", 0.72 + i * 0.05)
    love.graphics.rectangle("fill", x, y + i * height / 6, width, height / 6)
  end
  look.color("cyan", 0.8)
  for wave = x, x + width - 10, 10 do
    local rise = 3 + math.sin(clock * 2.5 + wave * 0.07) * 2
    love.graphics.rectangle("fill", wave, y - rise + 2, 10, rise)
  end
end

local function drawGroups(names)
  for name in names:gmatch("%S+") do
    for _, object in ipairs(world.objects[name]) do
      if scenery.isSeen(object.x + object.width / 2, object.width / 2 + 110) then
        love.graphics.push()
        draw[name](object)
        love.graphics.pop()
      end
    end
  end
end

local function drawCable()
  local car = world.objects.cars[1]
  local x1, y1 = car.fromX + car.width / 2, car.fromY - 86
  local x2, y2 = car.toX + car.width / 2, car.toY - 86
  look.color("plum")
  love.graphics.rectangle("fill", x1 - 66, y1 - 12, 10, 200)
  love.graphics.rectangle("fill", x2 + 60, y2 - 12, 10, 110)
  look.color("night")
  love.graphics.setLineWidth(3)
  love.graphics.line(x1 - 61, y1, x1, y1, x2, y2, x2 + 65, y2)
end

local function drawSigns()
  for _, sign in ipairs(state.signs) do
    if scenery.isSeen(sign.x, 120) then
      look.color("plum")
      love.graphics.rectangle("fill", sign.x - 4, sign.y - 70, 8, 74)
      local _, breaks = sign.text:gsub("\n", "")
      local height = 28 + breaks * 18
      look.box(sign.x - 84, sign.y - 70 - height, 168, height, "red")
      look.color("white")
      look.text(sign.text, sign.x - 84, sign.y - 65 - height, 15, 168, "center")
    end
  end
end

--- Returns the x, y of the world at the top-left corner of the picture.
function art.camera()
  return math.floor(camera.x), math.floor(camera.y)
end

function art.draw()
  scenery.prepare(camera, clock)
  scenery.drawBackground()
  love.graphics.push()
  local x, y = art.camera()
  love.graphics.translate(-x, -y)
  scenery.drawBehind()
  drawSigns()
  drawCable()
  drawGroups("flags turtles water")
  scenery.drawGround()
  drawGroups("buffers planks coins cars crates players carts")
  sparks.draw()
  love.graphics.pop()
  sprites.status(state, 170)
end

return art
