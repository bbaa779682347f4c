-- Step 3: a level from text, and a camera

local physics = require "physics"
local world, player
local SPEED, JUMP = 220, 520 -- px/s; the jump is 113 px high with gravity 1200

local LEVEL = {
  "                                        ",
  "                                        ",
  "                                        ",
  "         ###                  ########  ",
  "                                        ",
  "            ######                      ",
  "                                        ",
  "##########################  ############",
}
local TILE = 32 -- px

function love.load()
  world = physics.newWorld { gravity = 1200, checked = true }
  world:addTiles("tiles", LEVEL, nil, TILE, { solid = { ["#"] = true } })
  player = world:add("players", { x = 100, y = 100, width = 22, height = 30, nudge = 6 })
end

local function control()
  local isDown = love.keyboard.isDown
  player.vx = (isDown("right") and SPEED or 0) - (isDown("left") and SPEED or 0)
end

function love.keypressed(key)
  if key == "space" and player.touching.bottom then player.vy = -JUMP end
end

function love.update(dt)
  control()
  world:update(dt)
end

function love.draw()
  love.graphics.translate(-math.max(0, math.floor(player.x - 400)), 150)
  world:draw()
end
