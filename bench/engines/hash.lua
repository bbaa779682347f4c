--- What a game writes that wants no library: a table of cells, and loops over it. It plays two
--- scenes: a soft crowd by the same rule as physics.lua (`soft`), which goes round pillars, and
--- bullets that can hit one object.

local tables = require("bench.engines.tables")

local hash = {
  plays = { ["swarm-soft"] = true, ["swarm-soft-kite"] = true, bullets = true },
}
local World = {}
World.__index = World

local floor, max, min, sqrt = math.floor, math.max, math.min, math.sqrt
local CELL = 20 -- px, the largest enemy
local ROW = 65536 -- keys of cells from one row to the next
local STATIC_CELL = 64 -- px

function hash.new(scene)
  local self = setmetatable({ objects = {}, enemies = {}, bullets = {}, cells = {} }, World)
  self.soft, self.walls = scene.soft and scene.soft.enemies.enemies, {}
  for _, description in ipairs(scene.objects) do
    self:add(description)
  end
  return self
end

local function keyOf(x, y, cell)
  return floor(x / cell) + ROW * floor(y / cell)
end

-- A wall stands in every cell that it or an enemy beside it may reach.
local function addWall(walls, wall)
  for x = wall.x - CELL, wall.x + wall.width + STATIC_CELL, STATIC_CELL do
    for y = wall.y - CELL, wall.y + wall.height + STATIC_CELL, STATIC_CELL do
      local key = keyOf(x, y, STATIC_CELL)
      walls[key] = walls[key] or {}
      table.insert(walls[key], wall)
    end
  end
end

function World:add(description)
  local object = {
    x = description.x,
    y = description.y,
    width = description.width,
    height = description.height,
    vx = description.vx or 0,
    vy = description.vy or 0,
    driftX = 0,
    driftY = 0,
  }
  local index = #self.objects + 1
  self.objects[index] = object
  if description.static or description.group == "players" then
    addWall(self.walls, object)
  elseif description.group == "bullets" then
    table.insert(self.bullets, object)
  elseif description.group == "enemies" then
    table.insert(self.enemies, object)
  end
  return index
end

-- Two that overlap part in proportion to how deep.
local function part(a, b, soft)
  local dx = b.x + b.width / 2 - a.x - a.width / 2
  local dy = b.y + b.height / 2 - a.y - a.height / 2
  local w, h = (a.width + b.width) / 2, (a.height + b.height) / 2
  if dx < w and -dx < w and dy < h and -dy < h then
    dx, dy = dx / w, dy / h
    local far = max(max(dx, -dx), max(dy, -dy))
    if far > 0 then
      local v = soft * (1 / far - 1) / 2
      a.driftX, a.driftY = a.driftX - v * dx, a.driftY - v * dy
      b.driftX, b.driftY = b.driftX + v * dx, b.driftY + v * dy
    end
  end
end

local function separate(self)
  local cells, soft, enemies = {}, self.soft, self.enemies
  for n = 1, #enemies do
    local e = enemies[n]
    local key = keyOf(e.x, e.y, CELL)
    e.driftX, e.driftY = 0, 0
    -- Those that have been filed before are the others.
    for y = key - ROW, key + ROW, ROW do
      for at = y - 1, y + 1 do
        local cell = cells[at]
        if cell then
          for m = 1, #cell do
            part(e, cell[m], soft)
          end
        end
      end
    end
    local cell = cells[key]
    if cell then
      cell[#cell + 1] = e
    else
      cells[key] = { e }
    end
  end
end

-- Out of what it has run into, the shortest way.
local function leave(e, wall)
  local left, right = e.x + e.width - wall.x, wall.x + wall.width - e.x
  local up, down = e.y + e.height - wall.y, wall.y + wall.height - e.y
  if min(left, right, up, down) > 0 then
    if min(left, right) < min(up, down) then
      e.x = left < right and wall.x - e.width or wall.x + wall.width
    else
      e.y = up < down and wall.y - e.height or wall.y + wall.height
    end
  end
end

local function moveEnemies(self, dt)
  local enemies, soft, walls = self.enemies, self.soft, self.walls
  for n = 1, #enemies do
    local e = enemies[n]
    local dx, dy = e.driftX, e.driftY
    local length = sqrt(dx * dx + dy * dy)
    local share = length > soft and soft / length or 1
    e.x, e.y = e.x + (e.vx + dx * share) * dt, e.y + (e.vy + dy * share) * dt
    local near = walls[keyOf(e.x, e.y, STATIC_CELL)]
    if near then
      for m = 1, #near do
        leave(e, near[m])
      end
    end
  end
end

local function moveBullets(self, dt)
  local bullets, player, hits = self.bullets, self.objects[1], 0
  local left, top = player.x, player.y
  local right, bottom = left + player.width, top + player.height
  for n = 1, #bullets do
    local bullet = bullets[n]
    local x, y = bullet.x + bullet.vx * dt, bullet.y + bullet.vy * dt
    bullet.x, bullet.y = x, y
    if x < right and y < bottom and x + bullet.width > left and y + bullet.height > top then
      hits = hits + 1
    end
  end
  self.hits = hits
end

function World:step(dt)
  if self.soft then
    separate(self)
    moveEnemies(self, dt)
  end
  moveBullets(self, dt)
end

World.read, World.setVelocity = tables.read, tables.setVelocity

function World:free()
  self.objects, self.enemies, self.bullets = nil, nil, nil
end

return hash
