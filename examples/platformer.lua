-- A level to play: run, jump, push the crate, land on heads, reach the flag. A jump key that is
-- pressed a little early or late counts. The longer you hold it, the higher you jump.
--
-- This file is the game: what is in the level, and how it feels. How it looks is in
-- platformer_art.lua; the player, the enemies and coming back are from the kit, files to copy. The
-- physics is that of the library.

local art = require("platformer_art")
local checkpoint = require("kit.checkpoint")
local crumble = require("kit.crumble")
local enemy = require("kit.enemy")
local hero = require("kit.hero")
local input = require("input")
local physics = require("physics")
local view = require("view")

local platformer = { keys = { { "left", "right", "run" }, { "space", "jump" } } }

-- # ground  = bricks  ~ bricks that crumble  C crate  o coin  E enemy  ^ spikes  S spring  F flag
-- P player
local LEVEL = [[
#                                                                                          #
#                                                             ooooo                        #
#                                                             ~~~~~                        #
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
local FEEL = {
  runSpeed = 290, -- px/s
  runUp = 2200, -- px/s²
  runUpInAir = 1500,
  jumpSpeed = 780, -- px/s
  shortJump = 260,
  coyoteTime = 0.09, -- s, in which one may still jump after walking off an edge
  jumpBuffer = 0.12, -- s, for which a jump key pressed too early is remembered
  fallSpeed = 1100, -- px/s, the highest; a spring may throw faster
}
local NUDGE = 6 -- px: a head or a foot that hits a corner by at most this slips past it
local STOMP_SPEED, SPRING_SPEED, ENEMY_SPEED = 520, 1180, 70 -- px/s

local world, player, state ---@type physics.World, any, table

-- Callbacks tell what touches what. They may remove and move objects, because the library calls
-- them after the step.

local function die()
  if checkpoint.die(player) then
    state.deaths = state.deaths + 1
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

local function meetEnemy(guard, other, side)
  if other == player and side == "top" then
    art.burst(guard, 14, "plum")
    world:remove(guard)
    player.vy, player.hero.isJumping = -STOMP_SPEED, false
  elseif other == player then
    die()
  end
end

local function jumpOnSpring(spring, other, side)
  if side == "top" and not other.static then
    other.vy = -SPRING_SPEED
    if other == player then
      player.hero.isJumping = false -- letting the key go does not cut this flight short
    end
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
  ["~"] = function(x, y)
    local brick = { x = x, y = y, width = TILE, height = TILE, static = true }
    brick.crumble, brick.onBegin = crumble.new(), crumble.onBegin
    world:add("crumbling", brick)
  end,
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
    local guard = { x = x + 3, y = y + 12, width = 34, height = 28, mass = 4 }
    guard.enemy, guard.onBegin = enemy.new({ speed = ENEMY_SPEED }), meetEnemy
    world:add("enemies", guard)
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
    player = { x = x + 7, y = y + 6, width = 26, height = 34, hero = hero.new(FEEL) }
    player.nudge, player.checkpoint = NUDGE, checkpoint.new(player)
    world:add("players", player)
  end,
}

function platformer.load()
  world = physics.newWorld({ gravity = 2000 })
  platformer.world = world
  state = { time = 0, coins = 0, deaths = 0 }
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

local function readKeys()
  return {
    left = input.isDown("left", "a"),
    right = input.isDown("right", "d"),
    jump = input.isDown("space", "up", "w"),
  }
end

function platformer.update(dt)
  state.time = state.time + dt
  if checkpoint.update(world, player, dt) then
    hero.reset(player)
  end
  hero.update(world, player, state.won and {} or readKeys(), dt)
  for _, guard in ipairs(world.objects.enemies) do
    enemy.update(world, guard, dt)
  end
  for _, brick in ipairs(world.objects.crumbling) do
    crumble.update(world, brick, dt)
  end
  world:update(dt)
  art.update(dt)
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
