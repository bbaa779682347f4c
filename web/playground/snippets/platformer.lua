-- Platformer: run with the arrow keys or A and D, jump with space. Take the coins.

local physics = require("physics")

local SPEED, JUMP = 240, 460 -- px/s
local LATE = 0.1 -- s, so long after an edge a jump still counts

local LEVEL = {
  "#                       #",
  "#                       #",
  "#                       #",
  "#              c c      #",
  "#             =====     #",
  "#   c c                 #",
  "#  #####          c     #",
  "#                ###    #",
  "#          c            #",
  "#        ####           #",
  "#                    c  #",
  "#   ==             #### #",
  "#         b             #",
  "#    #    b     ##      #",
  "#########################",
}
local TILE = 32 -- px

local player, coins, sinceGround

local function take(coin, other)
  if other == player then
    physics.remove(coin)
    coins = coins + 1
  end
end

local MAKE = {
  ["#"] = function(x, y)
    physics.add("tiles", { x = x, y = y, width = TILE, height = TILE, static = true })
  end,
  ["="] = function(x, y)
    physics.add("tiles", { x = x, y = y, width = TILE, height = 8, static = true, oneWay = "top" })
  end,
  b = function(x, y)
    physics.add("boxes", { x = x, y = y, width = TILE, height = TILE, mass = 0.5, friction = 0.6 })
  end,
  c = function(x, y)
    local coin = { x = x + 8, y = y + 8, width = 16, height = 16, static = true, sensor = true }
    coin.onBegin = take
    physics.add("coins", coin)
  end,
}

function love.load()
  physics.load({ gravity = 1200 })
  coins, sinceGround = 0, LATE
  for row, line in ipairs(LEVEL) do
    for column = 1, #line do
      local make = MAKE[line:sub(column, column)]
      if make then
        make((column - 1) * TILE, (row - 1) * TILE + 120)
      end
    end
  end
  player = physics.add("players", { x = 64, y = 480, width = 24, height = 32, nudge = 6 })
end

function love.keypressed(key)
  if key == "space" and sinceGround < LATE then
    player.vy, sinceGround = -JUMP, LATE
  end
end

function love.keyreleased(key)
  if key == "space" and player.vy < 0 then
    player.vy = player.vy * 0.4 -- a short press is a low jump
  end
end

function love.update(dt)
  sinceGround = player.touching.bottom and 0 or sinceGround + dt
  local right = love.keyboard.isDown("right", "d") and 1 or 0
  local left = love.keyboard.isDown("left", "a") and 1 or 0
  player.vx = (right - left) * SPEED
  physics.update(dt)
end

function love.draw()
  physics.draw()
  love.graphics.setColor(1, 0.8, 0.45)
  for _, coin in pairs(physics.objects.coins) do
    love.graphics.circle("fill", coin.x + 8, coin.y + 8, 8)
  end
  love.graphics.setColor(1, 1, 1)
  love.graphics.print(("coins: %d of 7"):format(coins), 48, 132)
end
