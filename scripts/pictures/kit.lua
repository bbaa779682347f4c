--- The scenes of docs/kit.md: a file of examples/kit each. Objects leave a trail.

local bullet = require("examples.kit.bullet")
local checkpoint = require("examples.kit.checkpoint")
local crumble = require("examples.kit.crumble")
local enemy = require("examples.kit.enemy")
local hero = require("examples.kit.hero")
local lift = require("examples.kit.lift")
local physics = require("physics")
local stage = require("scripts.pictures.stage")

local scenes = {}

local add, write = stage.add, stage.write

local DT = 1 / 60
local TRAIL = { 1, 0.8, 0.46, 0.5 }

local function newWorld(boxes)
  local world = physics.newWorld({ gravity = 1600 })
  world:add("walls", { x = 0, y = 260, width = 720, height = 40, static = true })
  for _, box in ipairs(boxes or {}) do
    add(world, box[5] or "walls", box[1], box[2], box[3], box[4], box[6], true)
  end
  return world
end

-- Plays frames; what is in `objects` leaves its outline every `every` frames, and a line of its
-- middle.
local function play(world, frames, each, objects, every)
  local lines = {}
  for frame = 1, frames do
    each(frame)
    world:update(DT)
    for i, object in ipairs(objects) do
      lines[i] = lines[i] or {}
      table.insert(lines[i], object.x + object.width / 2)
      table.insert(lines[i], object.y + object.height / 2)
      if frame % every == 0 then
        love.graphics.setColor(TRAIL)
        love.graphics.rectangle("line", object.x, object.y, object.width, object.height)
      end
    end
  end
  love.graphics.setColor(TRAIL)
  for _, line in ipairs(lines) do
    love.graphics.line(line)
  end
end

-- Keys as text: "right:1-30 jump:5-20".
local function keysOf(text, frame)
  local held = {}
  for key, first, last in text:gmatch("(%a+):(%d+)%-(%d+)") do
    held[key] = held[key] or frame >= tonumber(first) and frame <= tonumber(last)
  end
  return held
end

scenes["kit-hero"] = function()
  local world = newWorld({
    { 175, 160, 60, 8, nil, { oneWay = "top" } },
    { 255, 60, 16, 200 },
    { 345, 60, 16, 200 },
    { 560, 110, 28, 150, "ladders", { sensor = true } },
    { 520, 110, 40, 10 },
    { 588, 110, 60, 10 },
    { 620, 222, 60, 14 },
  })
  local feel =
    { airJumps = 1, wallSlide = 60, wallJump = 260, dash = 620, climb = 130, crouch = 18 }
  feel.jumpSpeed, feel.crouchSpeed = 480, 1
  local players, keys = {}, {}
  for i, row in ipairs({
    { 20, 230, "right:4-70 jump:6-24 jump:28-50" },
    { 275, 100, "right:1-26 jump:26-40 left:27-90 jump:48-52" },
    { 375, 90, "jump:4-16 right:1-26 dash:14-20" },
    { 565, 70, "down:8-140 right:84-140" },
  }) do
    local player = { x = row[1], y = row[2], width = 18, height = 30, hero = hero.new(feel) }
    players[i], keys[i] = world:add("players", player), row[3]
  end
  hero.capLadders(world)
  world:update(DT)
  play(world, 112, function(frame)
    for i, player in ipairs(players) do
      hero.update(world, player, keysOf(keys[i], frame), DT)
    end
  end, players, 6)
  world:draw()
  write("double jump", 110, 272)
  write("wall slide and jump", 308, 272)
  write("dash", 450, 272)
  write("ladder, crouch", 630, 272)
end

scenes["kit-lift"] = function()
  local world = newWorld({ { 470, 30, 230, 20 } })
  local lifts = {}
  for i, row in ipairs({
    { 40, 230, { { 0, 0 }, { 110, -80 }, { 220, -80 } } },
    { 540, 200, { { 0, 0 }, { 0, -130 } } },
  }) do
    local platform = { x = row[1], y = row[2], width = 90, height = 14, kinematic = true }
    lifts[i] = world:add("lifts", platform)
    platform.lift = lift.new(platform, row[3], {})
  end
  world:add("players", { x = 70, y = 200, width = 20, height = 30 })
  world:add("players", { x = 560, y = 150, width = 20, height = 30 })
  world:add("crates", { x = 555, y = 170, width = 30, height = 30 })
  play(world, 190, function()
    for _, platform in ipairs(lifts) do
      lift.update(world, platform, DT)
    end
  end, lifts, 20)
  world:draw()
  write("along a path, with its riders", 190, 272)
  write("stops before it crushes", 585, 272)
end

scenes["kit-enemy"] = function()
  local world = newWorld({
    { 60, 180, 260, 16 },
    { 240, 120, 20, 60 },
    { 420, 220, 60, 40, nil, { slope = "right" } },
    { 480, 220, 120, 40 },
  })
  local guards = {}
  for i, row in ipairs({ { 150, 150, {} }, { 530, 190, { chase = 150, sight = 400 } } }) do
    local guard = { x = row[1], y = row[2], width = 22, height = 30, enemy = enemy.new(row[3]) }
    guards[i] = world:add("enemies", guard)
  end
  local player = world:add("players", { x = 300, y = 230, width = 20, height = 30 })
  play(world, 75, function()
    for _, guard in ipairs(guards) do
      enemy.update(world, guard, DT, player)
    end
  end, guards, 15)
  love.graphics.setColor(1, 0.4, 0.4)
  local guard = guards[2]
  love.graphics.line(guard.x + 11, guard.y + 15, player.x + 10, player.y + 15)
  world:draw()
  write("turns at walls and edges", 170, 272)
  write("chases a player that it sees", 480, 272)
end

scenes["kit-crumble"] = function()
  local world = newWorld()
  local tiles = {}
  for i = 1, 5 do
    local tile = { x = 60 + 120 * (i - 1), y = 180, width = 100, height = 16, static = true }
    tile.crumble, tile.onBegin = crumble.new({ after = 0.7, back = 0.6 }), crumble.onBegin
    tiles[i] = world:add("crumbling", tile)
  end
  local player = { x = 70, y = 120, width = 22, height = 30, nudge = 8, snap = 8 }
  world:add("players", player)
  play(world, 98, function()
    player.vx = 220
    for _, tile in ipairs(tiles) do
      crumble.update(world, tile, DT)
    end
  end, { player }, 8)
  world:draw()
  write("back again", 110, 205)
  write("gone", 230, 205)
  write("goes in a moment", 350, 205)
end

scenes["kit-checkpoint"] = function()
  local world = newWorld({
    { 420, 235, 120, 25, "spikes" },
    { 90, 160, 6, 100, "flags", { sensor = true } },
  })
  world:add("crates", { x = 96, y = 220, width = 40, height = 40 })
  local player = { x = 230, y = 230, width = 22, height = 30, vx = 200 }
  world:add("players", player)
  player.checkpoint = checkpoint.new(player)
  checkpoint.reach(player, 100, 230)
  world.objects.spikes[1].onBegin = function()
    checkpoint.die(player)
  end
  play(world, 60, function(frame)
    player.vx = 200
    if frame == 20 then
      player.vy = -500
    end
  end, { player }, 8)
  for _ = 1, 70 do
    checkpoint.update(world, player, DT)
    player.vx = 0
    world:update(DT)
  end
  world:draw()
  write("checkpoint", 92, 138)
  write("back at a free place", 116, 272)
  write("it dies once", 480, 272)
end

scenes["kit-bullet"] = function()
  local world = newWorld({ { 600, 40, 20, 220 } })
  for i = 0, 2 do
    for _, y in ipairs({ 60, 150 }) do
      local enemyAt = { x = 240 + 110 * i, y = y, width = 24, height = 34, gravity = 0, health = 3 }
      world:add("enemies", enemyAt)
    end
  end
  local shots = {}
  for i, y in ipairs({ 75, 165 }) do
    world:add("players", { x = 40, y = y - 14, width = 22, height = 30, gravity = 0 })
    shots[i] = bullet.shoot(world, "bullets", {
      x = 48,
      y = y,
      width = 10,
      height = 4,
      vx = 800,
      owner = "players",
      pierce = i == 2 and 9 or 0,
    })
  end
  play(world, 60, function()
    bullet.update(world, "bullets", DT)
  end, shots, 4)
  world:draw()
  for _, target in ipairs(world.objects.enemies) do
    write("health " .. target.health, target.x + 12, target.y + 36)
  end
  write("it hits the first", 140, 40)
  write("it pierces, up to the wall", 140, 210)
end

return scenes
