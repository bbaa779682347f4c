-- How the platformer looks. Reads the objects of its world and changes none of them.

local look = require("look")
local sparks = require("sparks")
local sprites = require("sprites")
local view = require("view")

local art = {}

local SIGNS = {
  { 4.5, 7, "run and jump" },
  { 10.5, 6.4, "hold the key: jump higher" },
  { 26, 7.6, "push the crate\nto get up there" },
  { 43, 7.6, "land on their heads" },
  { 57, 10, "a spring!" },
  { 80.5, 9, "crates are for fun" },
}
local SIGN_TILE = 40

local world, player, state ---@type physics.World, physics.Object, table
local camera, squash, wasOnGround, clock ---@type number, number, any, number

function art.load(gameWorld, gamePlayer, gameState)
  world, player, state = gameWorld, gamePlayer, gameState
  camera, squash, wasOnGround, clock = 0, 0, true, 0
  sparks.clear()
  -- Grass grows on tiles that have no tile above.
  local filled = {}
  for _, tile in ipairs(world.objects.tiles) do
    filled[tile.x .. " " .. tile.y] = true
  end
  for _, tile in ipairs(world.objects.tiles) do
    tile.hasGrass = not filled[tile.x .. " " .. tile.y - tile.height]
  end
end

--- Throws sparks from the middle of an object.
art.burst = sparks.burst

function art.update(dt)
  clock = clock + dt
  sparks.update(dt)
  local width = view.gameWidth
  local target = player.x + player.width / 2 + player.hero.facing * 70 - width / 2
  target = math.max(0, math.min(state.width - width, target))
  camera = camera + (target - camera) * math.min(1, 6 * dt)

  local onGround = player.touching.bottom
  if onGround and not wasOnGround then
    squash = 0.32
  end
  wasOnGround = onGround
  squash = squash - squash * math.min(1, 12 * dt)
end

-- ----------------------------------------------------------------------------------- background --

-- A row of hills; `depth` 0 is infinitely far away, 1 moves like the level.
local function drawHills(depth, base, height, length, color)
  look.color(color)
  local points = { 0, 640 } ---@type number[]
  for x = 0, 960, 12 do
    local place = (x + camera * depth) / length
    points[#points + 1] = x
    points[#points + 1] = base - love.math.noise(place, depth * 50) * height
  end
  points[#points + 1], points[#points + 2] = 960, 640
  for i = 3, #points - 4, 2 do
    local x1, y1, x2, y2 = points[i], points[i + 1], points[i + 2], points[i + 3]
    love.graphics.polygon("fill", x1, y1, x2, y2, x2, 640, x1, 640)
  end
end

local function drawBackground()
  look.sky("navy", "plum", "orange")
  look.color("white", 0.5)
  for i = 1, 40 do
    local x = (love.math.noise(i * 3.1) * 1400 - camera * 0.03) % 960
    love.graphics.circle("fill", x, love.math.noise(i * 7.7) * 260, 0.6 + i % 3 * 0.4)
  end
  -- The sun: many thin discs make a soft glow around a bright one.
  for i = 1, 16 do
    look.color("orange", 0.05)
    love.graphics.circle("fill", 700 - camera * 0.05, 330, 190 - i * 8)
  end
  look.color("yellow", 0.9)
  love.graphics.circle("fill", 700 - camera * 0.05, 330, 58)
  drawHills(0.15, 520, 230, 190, "plum")
  drawHills(0.3, 580, 200, 150, "navy")
  drawHills(0.5, 640, 190, 120, "night")
end

-- -------------------------------------------------------------------------------------- objects --

local draw = {}

function draw.tiles(tile)
  look.color("dusk")
  love.graphics.rectangle("fill", tile.x, tile.y, tile.width, tile.height)
  look.color("slate", 0.35)
  local shift = (tile.x * 7 + tile.y * 3) % 22
  love.graphics.rectangle("fill", tile.x + shift, tile.y + 18, 10, 4, 2)
  love.graphics.rectangle("fill", tile.x + 24 - shift / 2, tile.y + 30, 6, 4, 2)
  if tile.hasGrass then
    look.color("green")
    love.graphics.rectangle("fill", tile.x, tile.y, tile.width, 10)
    for x = 0, tile.width - 8, 8 do
      love.graphics.circle("fill", tile.x + x + 4, tile.y + 10, 4)
    end
    look.color("lime")
    love.graphics.rectangle("fill", tile.x, tile.y, tile.width, 3)
  end
end

function draw.bricks(brick)
  look.box(brick.x, brick.y, brick.width, brick.height, "red")
  look.color("plum", 0.7)
  love.graphics.rectangle("fill", brick.x, brick.y + 19, brick.width, 3)
  love.graphics.rectangle("fill", brick.x + 18, brick.y + 4, 3, 15)
  love.graphics.rectangle("fill", brick.x + 8, brick.y + 22, 3, 16)
  love.graphics.rectangle("fill", brick.x + 29, brick.y + 22, 3, 16)
end

function draw.crates(crate)
  sprites.crate(crate.x, crate.y, crate.width)
end

function draw.coins(coin)
  sprites.coin(coin, clock)
end

function draw.enemies(enemy)
  local x, y, width, height = enemy.x, enemy.y, enemy.width, enemy.height
  local bob = math.sin(clock * 9 + x * 0.05) * 1.5
  look.color("night", 0.3)
  love.graphics.ellipse("fill", x + width / 2, y + height, width * 0.55, 4)
  look.color("night")
  love.graphics.rectangle("fill", x + 5, y + height - 6, 9, 6, 2)
  love.graphics.rectangle("fill", x + width - 14, y + height - 6, 9, 6, 2)
  look.color("blue")
  love.graphics.rectangle("fill", x, y + bob, width, height - 4 - bob, 11)
  look.color("sky")
  love.graphics.rectangle("fill", x + 5, y + 3 + bob, width - 10, 5, 3)
  look.eyes(x, y + bob + 2, width, height, enemy.enemy.direction, 0.3)
end

function draw.spikes(spikes)
  local bottom = spikes.y + spikes.height
  for i = 0, 2 do
    local x = spikes.x - 6 + i * 13.3
    look.color("silver")
    love.graphics.polygon("fill", x, bottom, x + 6.7, bottom - 26, x + 13.3, bottom)
    look.color("slate")
    love.graphics.polygon("fill", x + 6.7, bottom, x + 6.7, bottom - 26, x + 13.3, bottom)
  end
end

function draw.springs(spring)
  local since = clock - (spring.pressedAt or -1)
  local press = since < 0.25 and math.sin(since / 0.25 * math.pi) * 9 or 0
  look.color("slate")
  love.graphics.rectangle("fill", spring.x + 5, spring.y + 12, 26, 6, 2)
  look.color("silver")
  love.graphics.rectangle("fill", spring.x + 9, spring.y + 4 - press, 18, 9 + press)
  look.box(spring.x, spring.y - press, spring.width, 7, "yellow")
end

function draw.flags(flag)
  sprites.flag(flag, clock)
end

function draw.players()
  if player.active == false then
    return
  end
  local stretch = math.min(0.2, math.abs(player.vy) / 6000) - squash
  local onGround = player.touching.bottom
  local step = onGround and math.sin(player.x * 0.12) * 4 or 3
  local x, y, width, height = player.x, player.y, player.width, player.height
  local lookY = math.max(-1, math.min(1, player.vy / 500))
  sprites.hero(x, y, width, height, stretch, step, player.hero.facing, lookY, onGround)
end

local LAYERS = {
  "flags",
  "spikes",
  "springs",
  "tiles",
  "bricks",
  "coins",
  "crates",
  "enemies",
  "players",
}

local function drawLevel()
  local left, right = camera - 100, camera + 1060
  for _, layer in ipairs(LAYERS) do
    for _, object in ipairs(world.objects[layer]) do
      if object.x < right and object.x + object.width > left then
        draw[layer](object)
      end
    end
  end
  sparks.draw()
end

local function drawSigns()
  for _, sign in ipairs(SIGNS) do
    local x, y = sign[1] * SIGN_TILE, sign[2] * SIGN_TILE
    local _, breaks = sign[3]:gsub("\n", "")
    look.color("night", 0.55)
    love.graphics.rectangle("fill", x - 105, y - 5, 210, 29 + breaks * 18, 8)
    look.color("white", 0.9)
    look.text(sign[3], x - 105, y, 15, 210, "center")
  end
end

--- Returns the x of the world at the left edge of the picture.
function art.camera()
  return math.floor(camera)
end

function art.draw()
  drawBackground()
  love.graphics.push()
  love.graphics.translate(-math.floor(camera), 0)
  drawLevel()
  drawSigns()
  love.graphics.pop()
  sprites.status(state, 210)
end

return art
