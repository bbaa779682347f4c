--- A round player that cannot be stopped among round enemies; crowds of boxes and circles, and the
--- same far away.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile, ball = small.put, small.tile, small.ball

local SOLID = 0.3 -- px
local FAR = 20480 -- px
local PULL = 600 -- px/s², of those that are driven by `ax`

-- Drives all enemies to the player, each at its speed or by PULL.
local function chase(enemies, player, field)
  local x, y = player.x + player.radius, player.y + player.radius
  for _, enemy in ipairs(enemies) do
    local dx, dy = x - enemy.x - enemy.width / 2, y - enemy.y - enemy.width / 2
    local wanted = field == "v" and enemy.speed or PULL
    local share = wanted / math.max(1, math.sqrt(dx * dx + dy * dy))
    enemy[field .. "x"], enemy[field .. "y"] = dx * share, dy * share
  end
end

-- Strong players ----------------------------------------------------------------------------------

-- Adds the walls of a place to a list, and returns the place of the player.
local PLACES = {}

function PLACES.lane(scene, radius, walls)
  scene.lane = scene.random:integer(2 * radius + 6, 5 * radius)
  walls[1], walls[2] = tile(-24, -900, 24, 1800), tile(scene.lane, -900, 24, 1800)
  return scene.random:between(radius, scene.lane - radius), 0
end

function PLACES.wall(scene, radius, walls)
  local random = scene.random
  walls[1] = tile(-300, 0, 600, 30)
  walls[2] = random:chance(0.5) and tile(0, -300, 30, 300) or nil
  return walls[2] and -radius - random:pick({ 0, 10 }) or 0, -radius - random:pick({ 0, 0, 20 })
end

function PLACES.open(scene, _, walls)
  local random = scene.random
  for n = 1, 4 do
    local size, x, y = random:integer(12, 40), random:between(-90, 90), random:pick({ -60, 60 })
    walls[n] = tile(x, y, size, size, { radius = random:chance(0.5) and size / 2 or nil })
  end
  return 0, 0
end

-- Returns the place of a new enemy.
local function placeOf(scene, n, radius)
  local random = scene.random
  if scene.lane then
    return random:between(radius, scene.lane - radius), (n % 2 == 0 and 1 or -1) * (40 + n * 18)
  end
  return random:between(-150, 150), random:between(-150, 150)
end

local function addEnemies(scene, player, walls, field)
  local random, enemies, speed = scene.random, {}, scene.random:integer(50, 110)
  for n = 1, scene.lane and 24 or random:integer(15, 45) do
    local radius = math.min(random:between(4, 16), (scene.lane or 1000) / 2 - 0.5)
    local x, y = placeOf(scene, n, radius)
    local enemy = ball(x, y, radius, { speed = speed })
    scene:vary(enemy, "mass", { 1, 1, radius * radius / 100, 3 })
    if field == "a" then
      enemy.maxSpeed, enemy.drag = random:integer(50, 110), 200
    end
    if scene:isFree(enemy, walls) and scene:isFree(enemy, { player }, 2) then
      scene:addFree("enemies", enemy, enemies, 1)
    end
  end
  return enemies
end

local function playStrong(scene)
  local random, kind = scene.random, scene:each({ "open", "lane", "wall" })
  local hz, walls, radius = scene:start(0, { 30, 60, 60, 144 }), {}, random:integer(7, 16)
  local x, y = PLACES[kind](scene, radius, walls)
  for _, wall in ipairs(walls) do
    scene:add("walls", wall)
  end
  local player = scene:vary(ball(x, y, radius, { strength = 1 }), "mass", { 1, 10 })
  local field, wayX, wayY = random:pick({ "v", "v", "a" }), 0, 0
  local enemies = addEnemies(scene, player, walls, field)
  scene:add("players", player)
  scene:play(3, function(n)
    if n % math.floor(hz * 0.5) == 1 then
      wayX, wayY = random:integer(-1, 1), random:integer(-1, 1)
    end
    player.vx, player.vy = 150 * wayX, 150 * wayY
    chase(enemies, player, field)
  end, function()
    scene:measure(kind .. ", in the player, px", scene:depthIn(player, enemies))
    scene:measure("the player in a wall, px", scene:depthIn(player, walls))
  end)
end

-- Mixed crowds ------------------------------------------------------------------------------------

local function playMixed(scene)
  local field = scene:each({ "v", "a" })
  local random, enemies, tries, hz = scene.random, {}, 0, scene:start(0, { 30, 60 })
  local player = scene:add("players", ball(0, 0, 12, { strength = 1, mass = 10 }))
  while #enemies < 80 do
    tries = tries + 1
    local size, angle = random:between(12, 20), random:between(0, 6.283)
    local far = random:between(40, 150 + tries / 4)
    local enemy =
      put(far * math.cos(angle) - size / 2, far * math.sin(angle) - size / 2, size, size)
    enemy.radius, enemy.speed = #enemies % 3 ~= 0 and size / 2 or nil, random:between(60, 90)
    enemy.maxSpeed = field == "a" and enemy.speed or nil
    scene:addFree("enemies", enemy, enemies, 1)
  end
  scene:play(6, function(n)
    local time = n / hz
    player.vx = time > 3 and 100 * math.cos(time) or 0
    player.vy = time > 3 and 100 * math.sin(time) or 0
    chase(enemies, player, field)
  end, function()
    scene:measure("in each other, px", scene:deepest())
  end)
end

-- Here and there ----------------------------------------------------------------------------------

-- Plays two seconds of a crowd around a place, smooth or not, and returns the enemies.
local function crowdAt(scene, x, isRough)
  scene:reseed(scene.left)
  local random, enemies = scene.random, {}
  local player = scene:vary(ball(x, 0, 10), "strength", { false, 1 })
  scene:add("players", player)
  for n = 1, 40 do
    local size = 2 * random:integer(4, 9)
    local enemy = put(x + n % 7 * 40 - 123, math.floor(n / 7) * 40 - 100, size, size)
    enemy.speed, enemy.radius = 80, random:chance(0.5) and size / 2 or nil
    if isRough then
      scene:vary(enemy, "friction", { false, 0.5 }, "restitution", { false, 0.5, 0.9 })
    end
    enemies[n] = scene:add("enemies", enemy)
  end
  if isRough then
    scene:add("slopes", tile(x - 60, 60, 64, 32, { slope = "right" }))
  end
  scene:play(2, function()
    chase(enemies, player, "v")
  end)
  return enemies
end

local function playFar(scene)
  local isRough = scene:each({ false, true })
  scene:start(0)
  local places = scene:places(crowdAt(scene, 0, isRough))
  for _, place in ipairs(places) do
    place.x = place.x + FAR
  end
  scene:again()
  local there = crowdAt(scene, FAR, isRough)
  scene:measure((isRough and "rough" or "smooth") .. ", elsewhere, px", scene:moved(there, places))
end

return {
  scenes.subject("strong", 600, playStrong, {
    { "open, in the player, px", SOLID },
    { "lane, in the player, px", SOLID },
    { "wall, in the player, px", SOLID },
    { "the player in a wall, px", 0.01 },
  }),
  scenes.subject("mixed", 24, playMixed, { { "in each other, px", SOLID } }),
  scenes.subject("far", 20, playFar, {
    { "smooth, elsewhere, px", 0.1 },
    { "rough, elsewhere, px", 0.1 },
  }),
}
