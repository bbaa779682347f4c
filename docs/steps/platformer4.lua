-- Step 4: ledges and a lift

local physics = require "physics"
local world, player
local SPEED, JUMP = 220, 520 -- px/s; the jump is 113 px high with gravity 1200

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

local function control()
  local isDown = love.keyboard.isDown
  player.vx = (isDown("right") and SPEED or 0) - (isDown("left") and SPEED or 0)
end

function love.keypressed(key)
  if key == "space" and player.touching.bottom then player.vy = -JUMP end
end

local function moveLifts()
  for _, lift in ipairs(world.objects.lifts) do
    if lift.x > 26 * TILE then lift.vx = -60 end
    if lift.x < 20 * TILE then lift.vx = 60 end
  end
end

function love.update(dt)
  control()
  moveLifts()
  world:update(dt)
end

function love.draw()
  love.graphics.translate(-math.max(0, math.floor(player.x - 400)), 150)
  world:draw()
end
