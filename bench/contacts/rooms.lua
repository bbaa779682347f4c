--- Rooms of slopes and boxes, in which a hero walks, dashes, jumps and swims, and rides a lift.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local NEAR = 16 -- px, of the lift
local FREE = small.put(0, 192, 40, 48) -- where the hero starts
local WAYS =
  { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 }, { 1, 1 }, { 1, -1 }, { -1, 1 }, { -1, -1 } }

local function addWall(scene, x, y, width, height)
  local random = scene.random
  local wall = small.tile(x, y, width, height)
  wall.slope = random:chance(0.67) and random:pick(scenes.SLOPES) or nil
  if overlap.depth(wall, FREE) <= 0 then
    table.insert(scene.walls, scene:add("walls", wall))
  end
end

-- In every second room the walls are tiles of a grid.
local function addWalls(scene)
  local random = scene.random
  local share = scene.seed % 2 == 0 and random:between(0.12, 0.4) or 0
  for n = 0, share > 0 and 299 or -1 do
    if random:chance(share) then
      addWall(scene, 16 * (n % 20), 16 * math.floor(n / 20), 16, 16)
    end
  end
  for _ = 1, share > 0 and 0 or random:integer(12, 40) do
    local width, height = random:integer(8, 90), random:integer(8, 70)
    addWall(scene, random:integer(0, 320 - width), random:integer(0, 240 - height), width, height)
  end
end

local function build(scene)
  local random = scene.random
  scene:start(scene.seed % 3 == 0 and 0 or 900)
  scene.world:setBounds(0, 0, 320, 240)
  local bounds = scene.world.objects.bounds
  scene.walls = { bounds.top, bounds.bottom, bounds.left, bounds.right }
  addWalls(scene)
  local lift
  if scene.seed % 4 == 1 then
    lift = small.put(48, 180, 48, 8, { kinematic = true, vx = 0, vy = 0 })
    lift[scene.seed % 8 == 1 and "vx" or "vy"] = 60
    lift.oneWay = scene.seed % 16 == 5 and "top" or nil
    scene:add("lifts", lift)
  end
  if random:chance(0.4) then
    local area = { gravity = 60, airFriction = 2 }
    scene:add("water", small.tile(0, 120, 320, 120, { sensor = true, area = area }))
  end
  local hero =
    small.put(8, 200, random:pick({ 8, 10, 12, 14, 16 }), random:pick({ 12, 16, 20, 24 }))
  scene:vary(hero, "nudge", { false, 4 }, "snap", { false, 8 }, "maxFallSpeed", { 500 })
  hero.constantSpeed = random:chance(0.2) or nil
  hero.maxSlope = random:chance(0.15) and 1.2 or nil
  return scene:add("heroes", hero), lift
end

-- What a player does: a way for some frames, now and then a dash.
local function newPlayer(scene, hero)
  local random, hz = scene.random, scene.hz
  local way, rise, left, dash = 0, 0, 0, 0
  return function()
    if left <= 0 then
      way, rise = random:integer(-1, 1), random:integer(-1, 1)
      left = random:integer(3, 50) * hz / 60
      dash = random:chance(0.35) and 0.14 * hz or 0
    end
    left, dash = left - 1, dash - 1
    local isDashing = dash > 0
    local speed = isDashing and 500 or 130
    hero.gravity = isDashing and 0 or nil
    hero.vx = speed * way
    if isDashing or scene.gravity == 0 then
      hero.vy = speed * rise
    elseif hero.y > 120 and rise ~= 0 and random:chance(0.3) then
      hero.vy = 90 * rise
    elseif hero.touching.bottom and random:chance(0.06) then
      hero.vy = -320
    end
  end
end

-- How far the hero comes in half a second, in the best of eight directions.
local function farthest(scene, hero)
  local places, most, state = scene:places({ hero }), 0, scene.world:save()
  for _, way in ipairs(WAYS) do
    scene:play(0.5, function()
      hero.gravity, hero.vx, hero.vy = 0, 120 * way[1], 120 * way[2]
    end, function()
      most = math.max(most, scene:moved({ hero }, places))
    end)
    scene.world:restore(state)
  end
  return most
end

local function play(scene)
  local hero, lift = build(scene)
  local steer = newPlayer(scene, hero)
  local isHeld, lastNear = false, -1e9 -- a lift may have pressed it into a wall, until it is free
  local function isNearLift()
    return lift and overlap.depth(hero, lift) > -NEAR
  end
  scene.world.onCrush = function()
    scene:measure("crushed without a lift", not isHeld and not isNearLift())
  end
  scene:play(8, function()
    steer()
    if lift then
      scene:turn(lift, 2, 270, 8, 230)
    end
  end, function(n)
    lastNear = isNearLift() and n or lastNear
    local depth = scene:depthIn(hero, scene.walls)
    isHeld = depth > scenes.EXACT and (isHeld or n <= lastNear + 2)
    scene:measure("in a wall, px", not isHeld and depth)
  end)
  scene:measure("stuck", not isHeld and farthest(scene, hero) < 0.5)
end

return {
  scenes.subject("rooms", 640, play, {
    { "in a wall, px", scenes.EXACT },
    { "crushed without a lift", 0 },
    { "stuck", 0 },
  }),
}
