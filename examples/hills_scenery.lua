-- The ground of the hills, what grows on it, and what is behind it. Nothing here is in the world.

local look = require("look")
local terrain = require("terrain")
local view = require("view")

local scenery = {}

local HIGH, DEEP = -1200, 1600 -- px, y far beyond every picture

local state ---@type any
local camera, clock ---@type table, number
local runs, bands, plants, stones, ties, posts ---@type table, table, table, table, table, table
local glow ---@type any

local function mix(from, to, share)
  local a, b, mixed = look.colors[from], look.colors[to], {}
  for i = 1, 3 do
    mixed[i] = a[i] + (b[i] - a[i]) * share
  end
  return mixed
end

-- From the surface down.
local SOIL, SOIL_BELOW, SOIL_DEEP =
  mix("plum", "orange", 0.3), mix("plum", "night", 0.2), mix("plum", "night", 0.7)
local ROCK, ROCK_BELOW, ROCK_DEEP =
  mix("slate", "dusk", 0.3), mix("dusk", "night", 0.1), mix("dusk", "night", 0.6)
local GRASS, GRASS_BELOW = look.colors.green, mix("green", "teal", 0.7)
local CAVE, CAVE_BELOW = mix("night", "dusk", 0.35), mix("night", "dusk", 0.7)

local KINDS = { "fir", "bush", "tree", "fir" } ---@type table<number, string>

-- ---------------------------------------------------------------------------------- the ground --

local function isStone(point)
  local piece, ceiling = point[3], state.ceiling
  local isInMine = point[1] > ceiling[1][1] and point[1] < ceiling[#ceiling][1] + 1
  return isInMine or piece[1] == "stairs" or piece[1] == "cliff" or piece.water ~= nil
end

-- Cuts the line of the ground where grass and stone meet: lists of points, each `isStone` or not.
local function findRuns()
  runs = {}
  for i, point in ipairs(state.ground) do
    local run = runs[#runs]
    if not run or run.isStone ~= isStone(point) then
      run = { state.ground[i - 1], isStone = isStone(point) }
      runs[#runs + 1] = run
    end
    run[#run + 1] = point
  end
end

-- A band along a line of points, from `top` px below it to `bottom` px below it, in two colours
-- that flow into each other.
local function addBand(line, top, bottom, upper, lower)
  local vertices = {}
  for _, point in ipairs(line) do
    local x, y = point[1], point[2]
    vertices[#vertices + 1] = { x, y + top, 0, 0, upper[1], upper[2], upper[3], 1 }
    vertices[#vertices + 1] = { x, y + bottom, 0, 0, lower[1], lower[2], lower[3], 1 }
  end
  bands[#bands + 1] = love.graphics.newMesh(vertices, "strip", "static")
end

local function addBands()
  bands = {}
  addBand(state.ceiling, 0, 600, CAVE, CAVE_BELOW) -- the first one is behind all
  for _, run in ipairs(runs) do
    if run.isStone then
      addBand(run, 0, 60, ROCK, ROCK_BELOW)
      addBand(run, 60, DEEP, ROCK_BELOW, ROCK_DEEP)
      addBand(run, 0, 4, look.colors.silver, look.colors.slate)
    else
      addBand(run, 0, 90, SOIL, SOIL_BELOW)
      addBand(run, 90, DEEP, SOIL_BELOW, SOIL_DEEP)
      addBand(run, -1, 9, GRASS, GRASS_BELOW)
      addBand(run, -1, 3, look.colors.lime, GRASS)
    end
  end
  addBand(state.ceiling, HIGH, -60, ROCK_DEEP, ROCK_BELOW)
  addBand(state.ceiling, -60, 0, ROCK_BELOW, ROCK)
end

-- Goes along runs in steps of `step` px, and calls `call(x, y, noise, i)`.
local function along(step, isOnStone, call)
  for _, run in ipairs(runs) do
    local last = run.isStone == isOnStone and run[#run][1] or -1
    for x = run[1][1] + step / 2, last - step / 4, step do
      local i = math.floor(x / step)
      call(x, terrain.heightAt(run, x), love.math.noise(i * 1.37, 7), i)
    end
  end
end

local function addPlants()
  plants = { tufts = {}, trees = {} }
  along(11, false, function(x, y, noise)
    plants.tufts[#plants.tufts + 1] = { x, y, 3 + noise * 6 }
  end)
  along(84, false, function(x, y, noise, i)
    local kind = noise > 0.35 and KINDS[i * 7 % 4 + 1]
    for _, sign in ipairs(state.signs) do
      kind = math.abs(sign.x - x) > 110 and kind
    end
    if kind then
      plants.trees[#plants.trees + 1] = { x, y, kind, 0.65 + noise * 0.6 }
    end
  end)
end

local function addStones()
  stones = {}
  local function add(x, y, noise, i)
    stones[#stones + 1] = { x, y + 26 + (noise * 7919 + i * 37) % 90, 5 + noise * 7 }
  end
  along(37, false, add)
  along(53, true, add)
end

-- Rails lead from the cart to the buffer; posts and lamps hang from the ceiling.
local function addMine(fromX, toX)
  ties, posts = {}, {}
  along(18, true, function(x, y)
    local gradient = (terrain.heightAt(state.ground, x + 9) - y) / 9
    local _, piece = terrain.heightAt(state.ground, x)
    if x > fromX and x < toX and math.abs(gradient) < 2 and not piece.water then
      ties[#ties + 1] = { x, y, gradient }
    end
  end)
  local ceiling = state.ceiling
  for x = ceiling[1][1] + 90, ceiling[#ceiling][1] - 110, 200 do
    posts[#posts + 1] = { x, terrain.heightAt(ceiling, x), terrain.heightAt(state.ground, x) }
  end
end

-- A disc with a radius of 1 that fades towards its edge.
local function newGlow()
  local vertices = { { 0, 0, 0, 0, 1, 1, 1, 1 } } ---@type any
  for i = 0, 40 do
    local angle = i * math.pi / 20
    vertices[#vertices + 1] = { math.cos(angle), math.sin(angle), 0, 0, 1, 1, 1, 0 }
  end
  return love.graphics.newMesh(vertices, "fan", "static")
end

--- Makes everything that a level shows. `gameState` has `ground` and `ceiling`, lines of points,
--- `signs`, and `rails`, the x where they begin and end.
function scenery.load(gameState)
  state = gameState
  findRuns()
  addBands()
  addPlants()
  addStones()
  addMine(state.rails[1], state.rails[2])
  glow = newGlow()
end

--- To be called before a picture is drawn. `gameCamera`: `{ x =, y = }`; `time`: s.
function scenery.prepare(gameCamera, time)
  camera, clock = gameCamera, time
end

--- Is something at x in the picture? `margin`: px, half its width.
function scenery.isSeen(x, margin)
  return x > camera.x - margin and x < camera.x + view.gameWidth + margin
end

local isSeen = scenery.isSeen

-- ---------------------------------------------------------------------------------- background --

-- A row of hills; `depth` 0 is infinitely far away, 1 moves like the level.
local function drawRange(depth, base, height, length, color, alpha)
  look.color(color, alpha)
  base = base - camera.y * depth * 0.5
  local lastX, lastY ---@type number?, number?
  for x = 0, view.gameWidth + 12, 12 do
    local place = (x + camera.x * depth) / length
    local y = base - love.math.noise(place, depth * 50) * height
    y = y - love.math.noise(place * 5, depth * 20) * height * 0.08
    if lastX then
      love.graphics.polygon("fill", lastX, lastY, x, y, x, 640, lastX, 640)
    end
    lastX, lastY = x, y
  end
end

local function drawCloud(x, y, size)
  love.graphics.setColor(0.9, 0.95, 1)
  love.graphics.ellipse("fill", x, y, size, size * 0.26)
  love.graphics.ellipse("fill", x - size * 0.4, y - size * 0.14, size * 0.4, size * 0.28)
  love.graphics.ellipse("fill", x + size * 0.25, y - size * 0.22, size * 0.5, size * 0.36)
  love.graphics.setColor(1, 1, 1)
  love.graphics.ellipse("fill", x + size * 0.23, y - size * 0.25, size * 0.44, size * 0.3)
  love.graphics.ellipse("fill", x - size * 0.42, y - size * 0.17, size * 0.34, size * 0.22)
end

function scenery.drawBackground()
  look.sky("blue", "sky", "cyan", "yellow")
  look.color("yellow", 0.6)
  love.graphics.draw(glow, view.gameWidth - 220, 120, 0, 200)
  look.color("white")
  love.graphics.circle("fill", view.gameWidth - 220, 120, 40)
  for i = 0, 5 do
    local x = i * 290 + clock * (5 + i % 3 * 3) - camera.x * 0.08
    x = x % (view.gameWidth + 340) - 170
    drawCloud(x, 70 + i * 53 % 170 - camera.y * 0.05, 60 + i * 37 % 50)
  end
  drawRange(0.15, 560, 330, 260, "sky", 0.65)
  drawRange(0.3, 600, 280, 210, "teal", 0.5)
  drawRange(0.5, 640, 250, 170, "teal", 0.9)
end

local drawPlant = {}

function drawPlant.fir(x, y, size)
  look.color("night")
  love.graphics.rectangle("fill", x - 4, y - 20, 8, 26)
  for i = 0, 2 do
    local width, top = (36 - i * 8) * size, y - (62 + i * 30) * size
    local bottom = top + 50 * size
    look.color("teal")
    love.graphics.polygon("fill", x - width, bottom, x, top, x + width, bottom)
    look.color("green", 0.45)
    love.graphics.polygon("fill", x, top, x + width, bottom, x + 4, bottom - 4 * size)
  end
end

function drawPlant.tree(x, y, size)
  look.color("plum")
  love.graphics.rectangle("fill", x - 5, y - 56 * size, 10, 56 * size + 8)
  look.color("teal")
  love.graphics.circle("fill", x - 22 * size, y - 66 * size, 26 * size)
  love.graphics.circle("fill", x + 22 * size, y - 62 * size, 28 * size)
  look.color("green")
  love.graphics.circle("fill", x, y - 86 * size, 32 * size)
  look.color("lime", 0.6)
  love.graphics.circle("fill", x + 8 * size, y - 94 * size, 16 * size)
end

function drawPlant.bush(x, y)
  look.color("teal")
  love.graphics.circle("fill", x - 14, y - 4, 15)
  love.graphics.circle("fill", x + 13, y - 5, 17)
  look.color("green")
  love.graphics.circle("fill", x, y - 10, 18)
end

local function drawLamp(x, y)
  look.color("yellow", 0.35)
  love.graphics.draw(glow, x, y + 40, 0, 140)
  look.color("night")
  love.graphics.rectangle("fill", x - 1, y - 20, 2, 56)
  look.color("yellow")
  love.graphics.circle("fill", x, y + 40, 7)
end

--- Draws what is behind the objects: trees and the inside of the mine.
function scenery.drawBehind()
  for _, tree in ipairs(plants.trees) do
    if isSeen(tree[1], 60) then
      drawPlant[tree[3]](tree[1], tree[2], tree[4])
    end
  end
  love.graphics.setColor(1, 1, 1)
  love.graphics.draw(bands[1])
  for _, post in ipairs(posts) do
    local x, top, bottom = post[1], post[2], post[3]
    if isSeen(x, 150) then
      look.color("plum")
      love.graphics.rectangle("fill", x - 7, top - 4, 14, bottom - top + 8)
      look.color("red", 0.4)
      love.graphics.rectangle("fill", x - 7, top - 4, 5, bottom - top + 8)
      drawLamp(x + 100, terrain.heightAt(state.ceiling, x + 100))
    end
  end
end

-- ------------------------------------------------------------------------------ the foreground --

local function drawTufts()
  for i, tuft in ipairs(plants.tufts) do
    local x, y, height = tuft[1], tuft[2], tuft[3]
    if isSeen(x, 10) then
      love.graphics.setColor(GRASS_BELOW)
      love.graphics.circle("fill", x, y + 9, 5)
      look.color(i % 2 == 0 and "lime" or "green")
      local sway = math.sin(clock * 2 + x * 0.05) * 1.5
      love.graphics.polygon("fill", x - 4, y + 2, x - 3 + sway, y - height, x, y + 2)
      love.graphics.polygon("fill", x, y + 2, x + 4 + sway, y - height * 0.7, x + 4, y + 2)
    end
  end
end

local function drawTie(x, y, gradient)
  look.color("plum")
  love.graphics.polygon("fill", x - 5, y + 1, x + 5, y + 1, x + 4, y + 9, x - 4, y + 9)
  local dy = gradient * 9
  look.color("silver")
  love.graphics.polygon(
    "fill",
    x - 9,
    y - dy - 1,
    x + 9,
    y + dy - 1,
    x + 9,
    y + dy + 3,
    x - 9,
    y - dy + 3
  )
end

--- Draws the ground and the rock above the mine.
function scenery.drawGround()
  love.graphics.setColor(1, 1, 1)
  for i = 2, #bands do
    love.graphics.draw(bands[i])
  end
  look.color("night", 0.25)
  for _, stone in ipairs(stones) do
    if isSeen(stone[1], 20) then
      love.graphics.ellipse("fill", stone[1], stone[2], stone[3], stone[3] * 0.6)
    end
  end
  for _, tie in ipairs(ties) do
    if isSeen(tie[1], 10) then
      drawTie(tie[1], tie[2], tie[3])
    end
  end
  drawTufts()
end

return scenery
