--- A round player that cannot be stopped among round enemies, and crowds of boxes and circles.

local small = require("spec.support.small")

local put, ball = small.put, small.ball

local SOLID = 0.3 -- px
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

local function addWall(scene, wall)
  wall.static = true
  table.insert(scene.walls, scene:add("walls", wall))
end

local function addEnemy(scene, x, y, radius)
  local random = scene.random
  local enemy = ball(x, y, radius, { mass = random:pick({ 1, 1, radius * radius / 100, 3 }) })
  if scene.field == "a" then
    enemy.maxSpeed, enemy.drag = random:integer(50, 110), 200
  end
  local isInside = not scene:isFree(enemy, scene.walls)
  if
    scene:isFree(enemy, scene.enemies, 1)
    and not isInside
    and scene:isFree(enemy, { scene.player }, 2)
  then
    table.insert(scene.enemies, scene:add("enemies", enemy))
  end
end

local function newPlayer(scene, x, y, radius)
  scene.player = ball(x, y, radius, { strength = 1, mass = scene.random:pick({ 1, 10 }) })
end

-- Kind of scene -> adds walls and enemies, and makes the player.
local ADD = {}

function ADD.lane(scene, radius)
  local random = scene.random
  local width = random:integer(2 * radius + 6, 5 * radius)
  addWall(scene, put(-24, -900, 24, 1800))
  addWall(scene, put(width, -900, 24, 1800))
  newPlayer(scene, random:between(radius, width - radius), 0, radius)
  for n = 1, 24 do
    local its = math.min(random:pick({ 7, 11, 17, random:between(6, 14) }), width / 2 - 0.5)
    addEnemy(scene, random:between(its, width - its), (n % 2 == 0 and 1 or -1) * (40 + n * 18), its)
  end
end

local function addAround(scene, x, y, radius)
  local random = scene.random
  newPlayer(scene, x, y, radius)
  for _ = 1, random:integer(15, 45) do
    local its = random:integer(4, 14)
    addEnemy(scene, random:between(-150, 150), random:between(-150, 150), its)
  end
end

function ADD.wall(scene, radius)
  local random, x = scene.random, 0
  addWall(scene, put(-300, 0, 600, 30))
  local y = -radius - random:pick({ 0, 0, 20 })
  if random:chance(0.5) then
    addWall(scene, put(0, -300, 30, 300))
    x = -radius - random:pick({ 0, 10 })
  end
  addAround(scene, x, y, radius)
end

function ADD.open(scene, radius)
  local random = scene.random
  for _ = 1, 4 do
    local size, isRound = random:integer(12, 40), random:chance(0.5)
    local x, y = random:between(-90, 90), random:pick({ -60, 60 })
    addWall(scene, isRound and ball(x, y, size / 2) or put(x, y, size, size))
  end
  addAround(scene, 0, 0, radius)
end

local function playStrong(scene)
  local random, kind = scene.random, ({ "open", "lane", "wall" })[scene.seed % 3 + 1]
  local hz = random:pick({ 30, 60, 60, 144 })
  scene:start(hz, 0)
  scene.walls, scene.enemies = {}, {}
  local radius = random:integer(7, 16)
  scene.field = random:pick({ "v", "v", "a" })
  ADD[kind](scene, radius)
  local player, speed, wayX, wayY =
    scene:add("players", scene.player), random:integer(50, 110), 0, 0
  for _, enemy in ipairs(scene.enemies) do
    enemy.speed = speed
  end
  for n = 1, 3 * hz do
    if n % math.floor(hz * 0.5) == 1 then
      wayX, wayY = random:integer(-1, 1), random:integer(-1, 1)
    end
    player.vx, player.vy = 150 * wayX, 150 * wayY
    chase(scene.enemies, player, scene.field)
    scene:step()
    scene:measure(kind .. ", in the player", scene:depthIn(player, scene.enemies))
    scene:measure("the player in a wall", scene:depthIn(player, scene.walls))
  end
end

-- Mixed crowds ------------------------------------------------------------------------------------

local function playMixed(scene)
  local hz, field = scene:each({ 30, 60 }), scene:each({ "v", "a" })
  local random, enemies, tries = scene.random, {}, 0
  scene:start(hz, 0)
  local player = scene:add("players", ball(0, 0, 12, { strength = 1, mass = 10 }))
  while #enemies < 80 do
    tries = tries + 1
    local size, angle = random:between(12, 20), random:between(0, 6.283)
    local far = random:between(40, 150 + tries / 4)
    local x, y = far * math.cos(angle) - size / 2, far * math.sin(angle) - size / 2
    local enemy = put(x, y, size, size)
    enemy.radius = #enemies % 3 ~= 0 and size / 2 or nil
    enemy.maxSpeed = field == "a" and random:between(60, 90) or nil
    if scene:isFree(enemy, enemies, 1) then
      enemy.speed = random:between(60, 90)
      enemies[#enemies + 1] = scene:add("enemies", enemy)
    end
  end
  for n = 1, 6 * hz do
    local time = n / hz
    player.vx = time > 3 and 100 * math.cos(time) or 0
    player.vy = time > 3 and 100 * math.sin(time) or 0
    chase(enemies, player, field)
    scene:step()
    scene:measure("in each other", scene:deepest())
  end
end

return {
  {
    name = "strong",
    scenes = 600,
    salt = { 23, 9 },
    rows = {
      { "open, in the player", SOLID, "px" },
      { "lane, in the player", SOLID, "px" },
      { "wall, in the player", SOLID, "px" },
      { "the player in a wall", 0.01, "px" },
    },
    play = playStrong,
  },
  {
    name = "mixed",
    scenes = 12,
    salt = { 41, 2 },
    rows = { { "in each other", SOLID, "px" } },
    play = playMixed,
  },
}
