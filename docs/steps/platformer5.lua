-- Step 5: coyote time, jump buffer, short jumps

local physics = require "physics"
local world, player
local SPEED, JUMP = 220, 520 -- px/s; the jump is 113 px high with gravity 1200
local LATE, EARLY = 0.08, 0.1 -- s: coyote time, jump buffer
local sinceGround, sincePress = math.huge, math.huge

local LEVEL = {
  "                                        ",
  "                    ----                ",
  "                                        ",
  "         ###                  ########  ",
  "                                        ",
  "            ######      L               ",
  "                                        ",
  "####################        ############",
}
local TILE = 32 -- px
local SOLID = { ["#"] = true, ["-"] = { oneWay = "top" } }

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

function love.load()
  world = physics.newWorld { gravity = 1200, checked = true }
  world:addTiles("tiles", LEVEL, nil, TILE, { solid = SOLID })
  each("L", addLift)
  player = world:add("players", { x = 100, y = 100, width = 22, height = 30, nudge = 6 })
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

local function moveLifts()
  for _, lift in ipairs(world.objects.lifts) do
    if lift.x > 26 * TILE then lift.vx = -60 end
    if lift.x < 20 * TILE then lift.vx = 60 end
  end
end

function love.update(dt)
  control(dt)
  moveLifts()
  world:update(dt)
end

function love.draw()
  love.graphics.translate(-math.max(0, math.floor(player.x - 400)), 150)
  world:draw()
end
