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
  for x = 0, view.gameWidth + 12, 12 do
    local place = (x + camera * depth) / length
    points[#points + 1] = x
    points[#points + 1] = base - love.math.noise(place, depth * 50) * height
  end
  points[#points + 1], points[#points + 2] = view.gameWidth + 12, 640
  for i = 3, #points - 4, 2 do
    local x1, y1, x2, y2 = points[i], points[i + 1], points[i + 2], points[i + 3]
    love.graphics.polygon("fill", x1, y1, x2, y2, x2, 640, x1, 640)
  end
end

local function drawBackground()
  look.sky("navy", "plum", "orange")
  look.color("white", 0.5)
  for i = 1, 40 do
    local x = (love.math.noise(i * 3.1) * 1400 - camera * 0.03) % view.gameWidth
    love.graphics.circle("fill", x, love.math.noise(i * 7.7) * 260, 0.6 + i % 3 * 0.4)
  end
  -- The sun: many thin discs make a soft glow around a bright one.
  local sunX = view.gameWidth - 260 - camera * 0.05
  for i = 1, 16 do
    look.color("orange", 0.05)
    love.graphics.circle("fill", sunX, 330, 190 - i * 8)
  end
  look.color("yellow", 0.9)
  love.graphics.circle("fill", sunX, 330, 58)
  drawHills(0.15, 520, 230, 190, "plum")
  drawHills(0.3, 580, 200, 150, "navy")
  drawHills(0.5, 640, 190, 120, "night")
end

-- -------------------------------------------------------------------------------------- objects --

local draw = {}

-- One function for each character of the level that is a tile.
local tiles = {} ---@type table<string, function>

tiles["#"] = function(x, y, size, hasGrass)
  look.color("dusk")
  love.graphics.rectangle("fill", x, y, size, size)
  look.color("slate", 0.35)
  local shift = (x * 7 + y * 3) % 22
  love.graphics.rectangle("fill", x + shift, y + 18, 10, 4, 2)
  love.graphics.rectangle("fill", x + 24 - shift / 2, y + 30, 6, 4, 2)
  if hasGrass then
    look.color("green")
    love.graphics.rectangle("fill", x, y, size, 10)
    for offset = 0, size - 8, 8 do
      love.graphics.circle("fill", x + offset + 4, y + 10, 4)
    end
    look.color("lime")
    love.graphics.rectangle("fill", x, y, size, 3)
  end
end

tiles["="] = function(x, y, size)
  look.box(x, y, size, size, "red")
  look.color("plum", 0.7)
  love.graphics.rectangle("fill", x, y + 19, size, 3)
  love.graphics.rectangle("fill", x + 18, y + 4, 3, 15)
  love.graphics.rectangle("fill", x + 8, y + 22, 3, 16)
  love.graphics.rectangle("fill", x + 29, y + 22, 3, 16)
end

-- The objects of the tiles are large rectangles. The map knows each tile.
local function drawTiles()
  local size, map = state.tile, state.tiles ---@type number, any
  local first = math.max(1, math.floor(camera / size))
  for column = first, math.min(state.columns, first + math.ceil(view.gameWidth / size) + 1) do
    for row = 1, state.rows do
      local kind = map:getTile(column, row)
      if tiles[kind] then
        local hasGrass = row == 1 or map:getTile(column, row - 1) ~= kind
        tiles[kind](size * (column - 1), state.top + size * (row - 1), size, hasGrass)
      end
    end
  end
end

function draw.crumbling(brick)
  if brick.active ~= false then
    local shake = brick.crumble.left and math.sin(clock * 70) * 2 or 0
    tiles["="](brick.x + shake, brick.y, brick.width)
  end
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

local BEHIND = { "flags", "spikes", "springs", "crumbling" }
local BEFORE = { "coins", "crates", "enemies", "players" }

local function drawObjects(groups)
  local left, right = camera - 100, camera + view.gameWidth + 100
  for _, group in ipairs(groups) do
    for _, object in ipairs(world.objects[group]) do
      if object.x < right and object.x + object.width > left then
        draw[group](object)
      end
    end
  end
end

local function drawSigns()
  for _, sign in ipairs(SIGNS) do
    look.sign(sign[3], sign[1] * SIGN_TILE, sign[2] * SIGN_TILE)
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
  drawObjects(BEHIND)
  drawTiles()
  drawObjects(BEFORE)
  sparks.draw()
  drawSigns()
  love.graphics.pop()
  sprites.status(state, 210)
end

return art
