-- A level to play: run, jump, push the crate, land on heads, reach the flag. A jump key that is
-- pressed a little early or late counts. The longer you hold it, the higher you jump.
--
-- This file is the game: what is in the level and how the player moves. How it looks is in
-- platformer_art.lua. The physics is that of the library.

local art = require("platformer_art")
local input = require("input")
local physics = require("physics")
local view = require("view")

local platformer = { keys = { { "left", "right", "run" }, { "space", "jump" } } }

-- # ground  = bricks  C crate  o coin  E enemy  ^ spikes  S spring  F flag  P player
local LEVEL = [[
#                                                                                          #
#                                                             ooooo                        #
#                                                             =====                        #
#                                                                                          #
#                                                                                          #
#                                                             o o o                        #
#                      ooo     o o       o oo                #######   ooo                 #
#                  oo  ===     ###      ======     oo        #######   ===                 #
#              oo              ###                           #######                 oo    #
#              ##              ###                           #######            C    ##    #
#  P   o o o  ###          C   ###   #    E    # #    #   S  #######   E    #  CCC  ###  F #
##################^^^^############################^^^^######################################
############################################################################################
]]
local TILE = 40 -- px, one character of the map
local SOLID = { ["#"] = true, ["="] = { group = "bricks" } } -- ["#"]: in the group "tiles"

-- What makes a jump feel right: it is forgiving at both ends, and as high as the key is held long.
local RUN_SPEED, RUN_UP, RUN_UP_IN_AIR = 290, 2200, 1500 -- px/s, px/s², px/s²
local JUMP_SPEED, SHORT_JUMP_SPEED = 780, 260 -- px/s
local COYOTE_TIME = 0.09 -- s, in which one may still jump after walking off an edge
local BUFFER_TIME = 0.12 -- s, for which a jump key pressed too early is remembered
local FALL_SPEED = 1100 -- px/s, the highest; a spring may throw faster
local NUDGE = 6 -- px: a head or a foot that hits a corner by at most this slips past it
local STOMP_SPEED, SPRING_SPEED, ENEMY_SPEED = 520, 1180, 70 -- px/s

local world, player, state ---@type physics.World, any, table

-- Callbacks tell what touches what. They may remove and move objects, because the library calls
-- them after the step.

local function die()
  if not state.deadFor then
    state.deadFor = 0
    state.deaths = state.deaths + 1
    player.active = false
    art.burst(player, 18, "red")
  end
end

local function takeCoin(coin, other)
  if other == player then
    state.coins = state.coins + 1
    art.burst(coin, 8, "yellow")
    world:remove(coin)
  end
end

local function hitSpikes(_, other)
  if other == player then
    die()
  end
end

local function meetEnemy(enemy, other, side)
  if other == player and side == "top" then
    art.burst(enemy, 14, "plum")
    world:remove(enemy)
    player.vy = -STOMP_SPEED
  elseif other == player then
    die()
  end
end

local function jumpOnSpring(spring, other, side)
  if side == "top" and not other.static then
    other.vy = -SPRING_SPEED
    state.isJumping = false
    spring.pressedAt = state.time
  end
end

local function reachFlag(flag, other)
  if other == player and not flag.reached then
    flag.reached = true
    state.won, state.wonAt = true, state.time
    art.burst(flag, 40, "lime")
  end
end

-- One function for each character of the map that is no tile; x, y is the top-left corner there.
local build = {
  C = function(x, y)
    local crate = { x = x + 2, y = y + 4, width = 36, height = 36, mass = 0.5, friction = 0.3 }
    world:add("crates", crate)
  end,
  o = function(x, y)
    local coin = { x = x + 11, y = y + 11, width = 18, height = 18, static = true, sensor = true }
    coin.onBegin = takeCoin
    world:add("coins", coin)
  end,
  E = function(x, y)
    local enemy = { x = x + 3, y = y + 12, width = 34, height = 28, mass = 4, direction = -1 }
    enemy.onBegin = meetEnemy
    world:add("enemies", enemy)
  end,
  ["^"] = function(x, y)
    -- Smaller than its picture: no player likes to die beside a spike.
    local spikes = { x = x + 6, y = y + 22, width = 28, height = 18, static = true, sensor = true }
    spikes.onBegin = hitSpikes
    world:add("spikes", spikes)
  end,
  S = function(x, y)
    local spring = { x = x + 2, y = y + 22, width = 36, height = 18, static = true }
    spring.onBegin = jumpOnSpring
    world:add("springs", spring)
  end,
  F = function(x, y)
    local flag = { x = x + 12, y = y - 80, width = 24, height = 120, static = true, sensor = true }
    flag.onBegin = reachFlag
    world:add("flags", flag)
  end,
  P = function(x, y)
    state.startX, state.startY = x + 7, y + 6
    player = { x = state.startX, y = state.startY, width = 26, height = 34, vx = 0, vy = 0 }
    player.nudge, player.maxFallSpeed, player.facing = NUDGE, FALL_SPEED, 1
    world:add("players", player)
  end,
}

function platformer.load()
  world = physics.newWorld({ gravity = 2000 })
  platformer.world = world
  state = { time = 0, coins = 0, deaths = 0, sinceGround = 1, sinceKey = 1, fallSpeed = 0 }
  local rows = {}
  for row in LEVEL:gmatch("[^\n]+") do
    rows[#rows + 1] = row
  end
  local top = view.height - #rows * TILE
  -- Equal tiles are merged into few large rectangles. No seam can be felt.
  state.tiles = world:addTiles("tiles", rows, nil, TILE, { y = top, solid = SOLID })
  for row, text in ipairs(rows) do
    for column = 1, #text do
      local make = build[text:sub(column, column)]
      if make then
        make((column - 1) * TILE, top + (row - 1) * TILE)
      end
    end
  end
  state.top, state.rows, state.columns = top, #rows, #rows[1]
  state.tile, state.width, state.coinsInLevel = TILE, #rows[1] * TILE, #world.objects.coins
  art.load(world, player, state)
end

local function approach(value, target, step)
  return value < target and math.min(target, value + step) or math.max(target, value - step)
end

local function steer(dt)
  local direction = input.axis("left", "a", "right", "d")
  local onGround = player.touching.bottom
  local speedUp = onGround and RUN_UP or RUN_UP_IN_AIR
  player.vx = approach(player.vx, direction * RUN_SPEED, speedUp * dt)
  if direction ~= 0 then
    player.facing = direction
  end

  state.sinceGround = onGround and 0 or state.sinceGround + dt
  state.sinceKey = state.sinceKey + dt
  if state.sinceKey < BUFFER_TIME and state.sinceGround < COYOTE_TIME then
    player.vy = -JUMP_SPEED
    state.sinceKey, state.sinceGround = BUFFER_TIME, COYOTE_TIME
    state.isJumping = true
  end
  -- Letting the key go cuts a jump short, but not the flight off a spring or an enemy.
  if state.isJumping and not input.isDown("space", "up", "w") then
    player.vy = math.max(player.vy, -SHORT_JUMP_SPEED)
    state.isJumping = false
  end
end

local function patrol(enemy)
  if enemy.touching.left then
    enemy.direction = 1
  elseif enemy.touching.right then
    enemy.direction = -1
  end
  enemy.vx = enemy.direction * ENEMY_SPEED
end

local function comeBack()
  state.deadFor = nil
  player.active = true
  player.x, player.y, player.vx, player.vy = state.startX, state.startY, 0, 0
end

function platformer.update(dt)
  state.time = state.time + dt
  if state.deadFor then
    state.deadFor = state.deadFor + dt
    if state.deadFor > 0.8 then
      comeBack()
    end
  elseif not state.won then
    steer(dt)
  else
    player.vx = approach(player.vx, 0, RUN_UP * dt)
  end
  for _, enemy in ipairs(world.objects.enemies) do
    patrol(enemy)
  end
  world:update(dt)
  art.update(dt)
end

function platformer.keypressed(key, isRepeat)
  if isRepeat then
    return
  elseif key == "space" or key == "up" or key == "w" then
    state.sinceKey = 0
  end
end

function platformer.camera()
  return art.camera(), 0
end

function platformer.draw()
  art.draw()
end

function platformer.report()
  local result = "platformer: x=%d y=%d coins=%d deaths=%d won=%s"
  return result:format(player.x, player.y, state.coins, state.deaths, tostring(state.won or false))
end

return platformer
