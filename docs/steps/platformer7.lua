-- Step 7: your own picture

local physics = require "physics"
local world, player, coins
local SPEED, JUMP = 220, 520 -- px/s; the jump is 113 px high with gravity 1200
local LATE, EARLY = 0.08, 0.1 -- s: coyote time, jump buffer
local sinceGround, sincePress = math.huge, math.huge

local LEVEL = {
  "                     o  o               ",
  "                    ----                ",
  "          o                       E     ",
  "         ###                  ########  ",
  "               o                        ",
  "            ######      L          o    ",
  "                                        ",
  "#############^^#####        ############",
}
local TILE = 32 -- px
local SOLID = {
  ["#"] = true,
  ["-"] = { oneWay = "top" },
  ["^"] = { group = "spikes", kills = true },
}

-- Calls make(x, y) for each character of a kind in the level.
local function each(char, make)
  for row, line in ipairs(LEVEL) do
    for column = 1, #line do
      if line:sub(column, column) == char then make((column - 1) * TILE, (row - 1) * TILE) end
    end
  end
end

local function addLift(x, y)
  world:add("lifts", { x = x, y = y, width = 96, height = 16, kinematic = true, vx = 60 })
end

local function addCoin(x, y)
  local coin = { x = x + 8, y = y + 8, width = 16, height = 16, static = true, sensor = true }
  world:add("coins", coin)
end

local function addEnemy(x, y)
  world:add("enemies", { x = x, y = y, width = 28, height = 28, direction = 1 })
end

local function die()
  player.x, player.y, player.vx, player.vy = 32, 100, 0, 0
end

local function onBegin(self, other, side)
  local group = world:groupOf(other)
  if group == "coins" then
    world:remove(other)
    coins = coins + 1
  elseif group == "enemies" and side == "bottom" then -- an enemy is stomped
    world:remove(other)
    player.vy = -300
  elseif group == "enemies" or other.kills then
    die()
  end
end

function love.load()
  world = physics.newWorld { gravity = 1200, checked = true }
  world:addTiles("tiles", LEVEL, nil, TILE, { solid = SOLID })
  world.objects.enemies = {}
  coins = 0
  each("L", addLift)
  each("o", addCoin)
  each("E", addEnemy)
  player = world:add("players", { x = 32, y = 100, width = 22, height = 30, nudge = 6 })
  player.onBegin = onBegin
end

function love.keypressed(key)
  if key == "space" then sincePress = 0 end
end

function love.keyreleased(key)
  if key == "space" and player.vy < 0 then player.vy = 0.4 * player.vy end
end

local function control(dt)
  local isDown = love.keyboard.isDown
  player.vx = (isDown("right") and SPEED or 0) - (isDown("left") and SPEED or 0)
  local isOnGround = player.touching.bottom and player.vy >= 0
  sinceGround = isOnGround and 0 or sinceGround + dt
  if sincePress <= EARLY and sinceGround <= LATE then
    player.vy, sincePress, sinceGround = -JUMP, math.huge, math.huge
  end
  sincePress = sincePress + dt
end

local function moveEnemies()
  for _, enemy in ipairs(world.objects.enemies) do
    local foot = enemy.direction > 0 and enemy.x + enemy.width or enemy.x - 1
    local _, ground = world:queryRect(foot, enemy.y + enemy.height, 1, 1, "tiles")
    if enemy.touching.bottom and ground == 0 then enemy.direction = -enemy.direction end
    enemy.vx = 50 * enemy.direction
  end
end

local function moveLifts()
  for _, lift in ipairs(world.objects.lifts) do
    if lift.x > 26 * TILE then lift.vx = -60 end
    if lift.x < 20 * TILE then lift.vx = 60 end
  end
end

function love.update(dt)
  control(dt)
  moveLifts()
  moveEnemies()
  world:update(dt)
  if player.y > 600 then die() end
end

local COLORS = { tiles = { 0.2, 0.24, 0.34 }, spikes = { 0.7, 0.25, 0.3 }, coins = { 1, 0.8, 0.4 } }
local SKY, OTHER = { 0.45, 0.72, 0.9 }, { 0.35, 0.42, 0.5 }

local function drawBox(object, color)
  love.graphics.setColor(color)
  love.graphics.rectangle("fill", object.x, object.y, object.width, object.height, 3)
end

local function drawPlayer()
  local x, y, w = math.floor(player.x), math.floor(player.y), player.width
  love.graphics.setColor(0.94, 0.49, 0.34)
  love.graphics.rectangle("fill", x, y, w, player.height, 5)
  love.graphics.setColor(1, 1, 1)
  local look = player.vx > 0 and 4 or player.vx < 0 and -4 or 0
  love.graphics.circle("fill", x + w / 2 - 4 + look, y + 9, 3)
  love.graphics.circle("fill", x + w / 2 + 4 + look, y + 9, 3)
end

function love.draw()
  love.graphics.setBackgroundColor(SKY)
  love.graphics.translate(-math.max(0, math.floor(player.x - 400)), 150)
  for _, name in ipairs { "tiles", "spikes", "coins", "lifts", "enemies" } do
    for _, object in ipairs(world.objects[name] or {}) do
      drawBox(object, COLORS[name] or OTHER)
    end
  end
  drawPlayer()
  love.graphics.origin()
  love.graphics.setColor(0, 0, 0)
  love.graphics.print("coins: " .. coins, 10, 10)
end
