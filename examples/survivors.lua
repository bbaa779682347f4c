-- Hundreds of enemies are soft to each other: they overlap and drift apart. You are stronger than
-- they are: they slow you down and cannot move you. Bullets hit only what their list names.

local boxes = require("boxes")
local input = require("input")
local look = require("look")
local physics = require("physics")
local sparks = require("sparks")
local view = require("view")

local survivors = {
  keys = {
    { "left", "right", "up", "down", "mouse", "run" },
    { "space", "blast" },
    { "+", "-", "enemies" },
  },
}

local WIDTH, HEIGHT, TILE, BAR = 1920, 1280, 40, 34 -- px, px, px, px at the bottom of the picture
local SPEED, ENEMY_SLOW, ENEMY_FAST = 190, 55, 95 -- px/s
local FEWEST, MOST, STEP = 100, 1000, 100 -- enemies
local SPAWN = 6 -- enemies a frame, at most
local RELOAD, REACH, BULLET_SPEED = 0.12, 420, 560 -- s, px, px/s
local BLAST, BLAST_RADIUS, BLAST_PUSH, STUN = 3, 150, 420, 0.35 -- s, px, px/s, s
local MAGNET, GEM_SPEED = 150, 380 -- px, px/s
local BOSS_AFTER, BOSS_HEALTH, BOSS_RELOAD, BOSS_SHOT, RING = 8, 40, 1.6, 170, 20 -- s, .., s, px/s
local COLORS = { "red", "orange", "plum" }
local PILLARS = {
  { 8, 6 },
  { 9, 6 },
  { 20, 5 },
  { 34, 8 },
  { 34, 9 },
  { 12, 20 },
  { 26, 22 },
  { 27, 22 },
  { 38, 22 },
  { 6, 27 },
  { 22, 12 },
  { 42, 4 },
}

-- The same lists for all: what each kind of object can hit.
local BULLET_HITS, SHOT_HITS =
  { "enemies", "bosses", "walls", "bounds" }, { "players", "walls", "bounds" }
local GEM_HITS = { "players" }

local world, player, state, random ---@type physics.World, any, table<string, number>, any

local function middle(object)
  return object.x + object.width / 2, object.y + object.height / 2
end

-- Returns the way from one object's middle to another's, and how long it is.
local function wayTo(from, to)
  local x, y = middle(from)
  local toX, toY = middle(to)
  local dx, dy = toX - x, toY - y
  return dx, dy, math.max(1, math.sqrt(dx * dx + dy * dy))
end

local function takeGem(gem)
  if world:remove(gem) then
    state.gems = state.gems + 1
  end
end

local function kill(enemy)
  if not world:remove(enemy) then
    return
  end
  state.killed = state.killed + 1
  local x, y = middle(enemy)
  sparks.burst(enemy, 5)
  local gem = { sensor = true, hits = GEM_HITS, onBegin = takeGem, isCoin = true }
  boxes.add(world, "gems", "yellow", x - 5, y - 5, 10, 10, gem)
end

local function hitEnemy(bullet, other)
  if not world:remove(bullet) or not other.health then
    return
  end
  other.health = other.health - 1
  if other.health <= 0 then
    kill(other)
  end
end

local function hitPlayer(shot, other)
  if world:remove(shot) and other == player then
    state.hurt = state.hurt + 1
    sparks.burst(player, 8, "red")
  end
end

-- Outside of the picture, so that no enemy appears from nowhere.
local function place()
  local x, y
  repeat
    x, y = random:random(TILE, WIDTH - 2 * TILE), random:random(TILE, HEIGHT - 2 * TILE)
  until math.abs(x - player.x) > 500 or math.abs(y - player.y) > 340
  return x, y
end

local function spawn()
  local enemies = world.objects.enemies or {}
  for _ = 1, math.min(SPAWN, state.most - #enemies) do
    local size, x, y = random:random(14, 20), place()
    local speed = ENEMY_SLOW + random:random() * (ENEMY_FAST - ENEMY_SLOW)
    local enemy = { health = 1, speed = speed, stun = 0 }
    boxes.add(world, "enemies", COLORS[random:random(#COLORS)], x, y, size, size, enemy)
  end
  if state.time > state.bossAt then
    local x, y = place()
    state.bossAt = math.huge
    -- Stronger than the crowd, and than you: it walks through it and does not mind your pushes.
    local boss = { health = BOSS_HEALTH, speed = 70, stun = 0, strength = 2, mass = 40, reload = 1 }
    boxes.add(world, "bosses", "blue", x, y, 72, 72, boss)
  end
end

local function steer(enemy, dt)
  local dx, dy, distance = wayTo(enemy, player)
  if enemy.stun > 0 then -- thrown by a blast: it slides until it can walk again
    enemy.stun = enemy.stun - dt
    enemy.vx, enemy.vy = enemy.vx * (1 - 4 * dt), enemy.vy * (1 - 4 * dt)
  else
    enemy.vx, enemy.vy = enemy.speed * dx / distance, enemy.speed * dy / distance
  end
end

local function shootRing(boss)
  local x, y = middle(boss)
  for n = 1, RING do
    local angle = n / RING * 2 * math.pi + state.time
    local vx, vy = BOSS_SHOT * math.cos(angle), BOSS_SHOT * math.sin(angle)
    local shot =
      { vx = vx, vy = vy, sensor = true, hits = SHOT_HITS, onBegin = hitPlayer, alpha = 1 }
    boxes.add(world, "shots", "cyan", x - 5, y - 5, 10, 10, shot)
  end
end

local function steerAll(dt)
  for _, enemy in ipairs(world.objects.enemies or {}) do
    steer(enemy, dt)
  end
  for _, boss in ipairs(world.objects.bosses or {}) do
    steer(boss, dt)
    local dx, dy, distance = wayTo(boss, player)
    boss.lookX, boss.lookY = dx / distance, dy / distance
    boss.reload = boss.reload - dt
    if boss.reload < 0 then
      boss.reload = BOSS_RELOAD
      shootRing(boss)
    end
  end
  for _, gem in ipairs(world.objects.gems or {}) do
    local dx, dy, distance = wayTo(gem, player)
    if distance < MAGNET then
      gem.vx, gem.vy = GEM_SPEED * dx / distance, GEM_SPEED * dy / distance
    end
  end
end

-- Shoots at what is nearest, by itself.
local function shoot(dt)
  state.reload = state.reload - dt
  local x, y = middle(player)
  local target = state.reload < 0 and world:nearest(x, y, REACH, { "enemies", "bosses" })
  if target then
    local dx, dy, distance = wayTo(player, target)
    local bullet = { hits = BULLET_HITS, onBegin = hitEnemy, sensor = true, alpha = 1 }
    bullet.vx, bullet.vy = BULLET_SPEED * dx / distance, BULLET_SPEED * dy / distance
    boxes.add(world, "bullets", "white", x - 4, y - 4, 8, 8, bullet)
    state.reload = RELOAD
  end
end

-- Kills what is near, and throws away what is not so near.
local function blast()
  if state.untilBlast > 0 then
    return
  end
  state.untilBlast, state.blasts = BLAST, state.blasts + 1
  state.ring = 0
  local x, y = middle(player)
  local size = 2 * BLAST_RADIUS
  local near = world:queryRect(x - BLAST_RADIUS, y - BLAST_RADIUS, size, size, "enemies")
  for _, enemy in ipairs(near) do
    local dx, dy, distance = wayTo(player, enemy)
    if distance < BLAST_RADIUS / 2 then
      kill(enemy)
    elseif distance < BLAST_RADIUS then
      enemy.stun = STUN
      world:impulse(enemy, BLAST_PUSH * dx / distance, BLAST_PUSH * dy / distance)
    end
  end
end

function survivors.load()
  random = love.math.newRandomGenerator(5)
  world = physics.newWorld({
    gravity = 0,
    soft = { enemies = { enemies = 350 } }, -- px/s: so fast two at one place part
    masks = { enemies = { gems = false } },
  })
  survivors.world = world
  state = {
    time = 0,
    killed = 0,
    gems = 0,
    hurt = 0,
    blasts = 0,
    most = 300,
    reload = 0,
    untilBlast = 0,
    bossAt = BOSS_AFTER,
    ring = 1,
  }
  world:setBounds(0, 0, WIDTH, HEIGHT)
  for _, at in ipairs(PILLARS) do
    local pillar = { static = true, isTile = true }
    boxes.add(world, "walls", "teal", at[1] * TILE, at[2] * TILE, TILE, TILE, pillar)
  end
  player = { strength = 1, mass = 12, lookX = 1, lookY = 0 }
  boxes.add(world, "players", "lime", WIDTH / 2, HEIGHT / 2, 26, 26, player)
  sparks.clear()
end

function survivors.update(dt)
  state.time, state.untilBlast = state.time + dt, state.untilBlast - dt
  state.ring = state.ring + 4 * dt
  local cameraX, cameraY = survivors.camera()
  local dx, dy = input.direction(player.x + 13 - cameraX, player.y + 13 - cameraY)
  player.vx, player.vy = SPEED * dx, SPEED * dy
  if dx ~= 0 or dy ~= 0 then
    player.lookX, player.lookY = dx, dy
  end
  spawn()
  steerAll(dt)
  shoot(dt)
  world:update(dt)
  sparks.update(dt)
end

function survivors.keypressed(key, isRepeat)
  if key == "space" and not isRepeat then
    blast()
  elseif key == "+" or key == "=" or key == "kp+" then
    state.most = math.min(MOST, state.most + STEP)
  elseif key == "-" or key == "kp-" then
    state.most = math.max(FEWEST, state.most - STEP)
    while #(world.objects.enemies or {}) > state.most do
      world:remove(world.objects.enemies[#world.objects.enemies])
    end
  end
end

-- The top-left corner of what is shown: you are in the middle, but not beside the walls.
function survivors.camera()
  local x = player.x + 13 - view.gameWidth / 2
  local y = player.y + 13 - (view.height - BAR) / 2
  local left = math.max(0, math.min(x, WIDTH - view.gameWidth))
  return math.floor(left), math.floor(math.max(0, math.min(y, HEIGHT - view.height + BAR)))
end

local function drawFloor(cameraX, cameraY)
  look.sky("night", "navy")
  look.color("dusk", 0.5)
  for x = -(cameraX % 80), view.gameWidth, 80 do
    love.graphics.rectangle("fill", x, 0, 1, view.height)
  end
  for y = -(cameraY % 80), view.height, 80 do
    love.graphics.rectangle("fill", 0, y, view.gameWidth, 1)
  end
end

local function drawRing()
  if state.ring < 1 then
    local x, y = middle(player)
    look.color("white", 1 - state.ring)
    love.graphics.circle("line", x, y, BLAST_RADIUS * state.ring)
    look.color("yellow", 0.3 * (1 - state.ring))
    love.graphics.circle("fill", x, y, BLAST_RADIUS * state.ring)
  end
end

local function count(group)
  return #(world.objects[group] or {})
end

function survivors.draw()
  local x, y = survivors.camera()
  drawFloor(x, y)
  love.graphics.push()
  love.graphics.translate(-x, -y)
  boxes.draw(world, "gems walls enemies bosses players shots bullets", state.time)
  drawRing()
  sparks.draw()
  love.graphics.pop()
  local boss = world.objects.bosses and world.objects.bosses[1]
  boxes.status({
    "white",
    ("%d of %d enemies"):format(count("enemies"), state.most),
    "silver",
    ("%d bullets"):format(count("bullets") + count("shots")),
    "yellow",
    ("%d gems"):format(state.gems),
    "lime",
    ("%d killed"):format(state.killed),
    "orange",
    ("hurt %d times"):format(state.hurt),
    "sky",
    boss and ("boss %d"):format(boss.health) or "",
  })
end

function survivors.report()
  local result = "survivors: x=%d y=%d enemies=%d killed=%d gems=%d hurt=%d blasts=%d"
  return result:format(
    player.x,
    player.y,
    count("enemies"),
    state.killed,
    state.gems,
    state.hurt,
    state.blasts
  )
end

return survivors
