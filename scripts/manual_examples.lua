--- A short example for each public function, by name: scripts/manual.lua puts them into
--- docs/api.md, and the specs run them there (spec/project/docs_spec.lua).
---
--- An example finds what spec/support/snippets.lua prepares: `physics`, a `world` with gravity 800,
--- a `floor` at y 400 and a `player` of 24 x 32 px at x 40 that stands on it. What it prints must
--- be what its `-->` comments say.

local examples = {}

examples["physics.newWorld"] = [[
local space = physics.newWorld { gravity = 0 }
space:add("rocks", { x = 0, y = 0, width = 8, height = 8, vx = 60 })
space:update(0.1)
print(space.objects.rocks[1].x) --> 6
]]

examples["physics.load"] = [[
physics.load { gravity = 800, masks = { bullets = { players = false } } }
physics.add("players", { x = 40, y = 40, width = 24, height = 32 })
print(#physics.objects.players, physics.gravity) --> 1 800
]]

examples["physics.globals"] = [[
physics.globals()
physics_load { gravity = 800 }
objects.player = { x = 20, y = 0, width = 16, height = 16 }
physics_update(1 / 60)
]]

examples["physics.inside"] = [[
print(physics.inside(4, 4, 8, 8, 0, 0, 16, 16)) --> true
print(physics.inside(4, 4, 16, 8, 0, 0, 16, 16)) --> false
]]

examples["physics.side"] = [[
local a = { x = 0, y = 0, width = 16, height = 16 }
print(physics.side(a, { x = 12, y = 2, width = 16, height = 16 })) --> right
]]

examples["physics.checkCollision"] = [[
local a = { x = 0, y = 0, width = 16, height = 16 }
local b = { x = 16, y = 0, width = 16, height = 16 }
print(physics.checkCollision(a, b)) --> false
print(physics.checkCollision(a, b, true)) --> right
]]

examples["physics.bump"] = [[
local a = { x = 0, y = 0, width = 16, height = 16 }
local b = { x = 12, y = 2, width = 16, height = 16 }
print(physics.bump(a, b)) --> right
print(a.x, b.x) --> -2 14
]]

examples["world:update"] = [[
player.vx = 120
world:update(0.25) -- 8 steps, since maxStep is 1/30 s
print(player.x, player.y) --> 70 368
]]

examples["world:add"] = [[
local crate = world:add("crates", {
  x = 200, y = 0, width = 16, height = 16,
  mass = 2,
})
print(world.objects.crates[1] == crate, crate.touching.bottom) --> true false
]]

examples["world:remove"] = [[
for i = 1, 3 do
  world:add("coins", { x = i * 20, y = 0, width = 8, height = 8, taken = i > 1 })
end
local coins = world.objects.coins
for i = #coins, 1, -1 do
  if coins[i].taken then world:remove(coins[i]) end
end
print(#coins) --> 1
]]

examples["world:refresh"] = [[
floor.y = floor.y + 100 -- a static object is read only once
world:refresh(floor)
world:update(1 / 60)
print(player.touching.bottom) --> false
]]

examples["world:dropThrough"] = [[
world:add("ledges", {
  x = 300, y = 300, width = 60, height = 8,
  static = true, oneWay = "top",
})
player.x, player.y = 310, 268
world:update(1 / 60)
print(world:dropThrough(player)) --> true
for _ = 1, 60 do world:update(1 / 60) end
print(player.y) --> 368
]]

examples["world:ground"] = [[
world:add("ground", {
  x = 100, y = 368, width = 64, height = 32,
  static = true, slope = "right",
})
player.x, player.y = 110, 320
for _ = 1, 60 do world:update(1 / 60) end
local ground, gradient = world:ground(player)
print(ground.slope, gradient) --> right -0.5
]]

examples["world:save"] = [[
local checkpoint = world:save()
player.x = 700
world:restore(checkpoint)
print(player.x) --> 40
]]

examples["world:restore"] = [[
local state = world:save()
player.vx = 200
for _ = 1, 30 do world:update(1 / 60) end
world:restore(state) -- back in time
print(player.x, player.vx) --> 40 0
]]

examples["world:hash"] = [[
local state = world:save()
world:update(1 / 60)
local first = world:hash()
world:restore(state)
world:update(1 / 60)
print(world:hash() == first) --> true
]]

examples["world:draw"] = [[
function love.draw()
  world:draw { velocity = true, counters = true }
end
]]

examples["world:interpolate"] = [[
world.timestep = 1 / 60

function love.draw()
  local x, y = world:interpolate(player)
  love.graphics.rectangle("fill", x, y, player.width, player.height)
end
]]

examples["world:queryPoint"] = [[
local list, count = world:queryPoint(50, 380)
print(count, list[1] == player) --> 1 true
]]

examples["world:queryCircle"] = [[
world:add("crates", { x = 100, y = 384, width = 16, height = 16 })
local list, count = world:queryCircle(64, 384, 40, { "players", "crates" })
print(count, list[2] == player, list[1].x) --> 2 true 100
]]

examples["world:queryRect"] = [[
local list, count = world:queryRect(0, 300, 100, 150, { "players", "tiles" })
print(count) --> 2
]]

examples["world:querySegment"] = [[
local fractions = {}
local list, count = world:querySegment(50, 0, 50, 500, nil, nil, fractions)
print(count, list[1] == player, list[2] == floor) --> 2 true true
print(fractions[1] * 500, fractions[2] * 500) --> 368 400
]]

examples["world:raycast"] = [[
world:add("tiles", { x = 300, y = 0, width = 16, height = 16, static = true })
local tile, x, y, nx, ny = world:raycast(200, 8, 400, 8, "tiles")
print(x, y, nx, ny) --> 300 8 -1 0
]]

examples["world:sweep"] = [[
world:add("tiles", { x = 0, y = 340, width = 100, height = 16, static = true })
local ceiling, x, y = world:sweep(player, 0, -20)
print(ceiling ~= nil, y) --> true 356
]]

examples["world:cast"] = [[
world:add("tiles", { x = 300, y = 0, width = 16, height = 100, static = true })
local tile, x, y, nx = world:cast(0, 20, 32, 32, 500, 0, "tiles")
print(x, y, nx) --> 268 20 -1
]]

examples["world:castCircle"] = [[
local ground, x, y = world:castCircle(60, 300, 10, 0, 200, "tiles")
print(ground == floor, x, y) --> true 60 390
]]

examples["world:freePlace"] = [[
print(world:freePlace(35, 380, 24, 24, 100)) --> 16 376
]]

examples["world:fits"] = [[
world:add("tiles", { x = 0, y = 340, width = 100, height = 16, static = true })
player.y, player.height = 376, 24 -- it crouches
local isFree = world:fits(player.x, 368, 24, 32, player)
local hasRoom, ceiling = world:fits(player.x, 350, 24, 50, player)
print(isFree, hasRoom, ceiling.y) --> true false 340
]]

examples["world:groupOf"] = [[
function player.onBegin(self, other)
  if world:groupOf(other) == "enemies" then self.isHurt = true end
end
print(world:groupOf(floor), world:groupOf({})) --> tiles nil
]]

examples["world:velocity"] = [[
local lift = world:add("lifts", {
  x = 200, y = 400, width = 80, height = 16,
  kinematic = true, vy = -60,
})
player.x, player.y = 220, 368
for _ = 1, 2 do world:update(1 / 60) end
player.vx = 30
print(world:velocity(player)) --> 30 -60
]]

examples["world:nearest"] = [[
local object, distance = world:nearest(100, 384, 200, "players")
print(object == player, distance) --> true 36
]]

examples["world:overlapping"] = [[
local trap = world:add("traps", {
  x = 30, y = 380, width = 50, height = 10,
  static = true, sensor = true,
})
local list, count = world:overlapping(trap, "players")
if count > 0 then list[1].health = 0 end
print(count, player.health) --> 1 0
]]

examples["world:touching"] = [[
print(world:touching(player, floor), world:touching(floor, player)) --> bottom top
]]

examples["world:explain"] = [[
player.mask = { tiles = false }
print(world:explain(player, floor))
--> objects.players[1] and objects.tiles[1] never collide: the mask of objects.players[1] refuses the group "tiles".
]]

examples["world:move"] = [[
world:add("walls", { x = 200, y = 0, width = 16, height = 100, static = true })
local ghost = world:add("ghosts", { x = 100, y = 0, width = 16, height = 16 })
local x, y, hits, count = world:move(ghost, 300, 20)
print(x, y, count, hits[1].side) --> 184 20 1 right
]]

examples["world:impulse"] = [[
local crate = world:add("crates", {
  x = 200, y = 0, width = 16, height = 16,
  mass = 2,
})
world:impulse(crate, 100, 0)
print(crate.vx) --> 50
]]

examples["world:shift"] = [[
local x = player.x
world:shift(-1000, 0)
print(player.x - x, player.touching.bottom == floor) --> -1000 true
]]

examples["world:explode"] = [[
world:add("walls", { x = 200, y = 300, width = 16, height = 100, static = true })
local near = world:add("crates", { x = 120, y = 384, width = 16, height = 16 })
local hidden = world:add("crates", { x = 240, y = 384, width = 16, height = 16 })
local pushed, count = world:explode(100, 392, 200, 400, "crates", { "walls", "tiles" })
print(count, pushed[1] == near, near.vx, hidden.vx) --> 1 true 360 0
]]

examples["world:setBounds"] = [[
world:setBounds(0, 0, 800, 600)
world.objects.bounds.bottom.friction = 0.5
print(world.objects.bounds.left.x + world.objects.bounds.left.width) --> 0
]]

examples["world:loadTiled"] = [[
local level = world:loadTiled("maps/course.lua")
print(#level.walls, #level.sensors, level.named.player.x) --> 7 2 24
]]

examples["world:addTiles"] = [[
local tiles = world:addTiles("earth", { "##..", "####" }, nil, 16)
print(tiles.tiles, tiles.rectangles) --> 6 2
]]

examples["world:loadLDtk"] = [[
local json = require "dkjson" -- or any other
local project = json.decode((love.filesystem.read("maps/cave.ldtk")))
local level = world:loadLDtk(project, "Cave")
print(level.named.Start.x) --> 16
]]

examples["tiles:setTile"] = [[
local tiles = world:addTiles("earth", { "####", "####" }, nil, 16)
print(tiles:setTile(2, 1, ".")) --> true
print(tiles.tiles) --> 7
]]

examples["tiles:getTile"] = [[
local tiles = world:addTiles("earth", { "##..", "####" }, nil, 16)
print(tiles:getTile(1, 1), tiles:getTile(3, 1)) --> # 0
]]

examples["tiles:cellAt"] = [[
local tiles = world:addTiles("earth", { "##..", "####" }, nil, 16)
local column, row = tiles:cellAt(20, 20)
print(column, row) --> 2 2
]]

examples["tiles:load"] = [[
local tiles = world:addTiles("earth", { "#.#.#" }, nil, 16, { later = true })
print(#world.objects.earth, tiles:load(2), #world.objects.earth) --> 0 1 2
]]

examples["tiles:unload"] = [[
local tiles = world:addTiles("earth", { "#.#.#" }, nil, 16)
print(tiles:unload(), #world.objects.earth) --> 0 0
]]

examples["level:addMap"] = [[
local given = { type = "world", maps = { { fileName = "meadow.tmx", x = 320, y = 0 } } }
local level = world:loadTiled(given, { folder = "maps", later = true })
print(level:addMap("meadow").x, #level.walls > 0) --> 320 true
]]

examples["level:removeMap"] = [[
local given = { type = "world", maps = { { fileName = "meadow.tmx", x = 320, y = 0 } } }
local level = world:loadTiled(given, { folder = "maps" })
print(level:removeMap("meadow"), #level.objects) --> true 0
]]

return examples
