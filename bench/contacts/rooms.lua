--- Rooms of slopes and boxes, in which a hero walks, dashes, jumps and swims, and rides a lift.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put = small.put

local NEAR = 16 -- px, of the lift
local FREE = put(0, 192, 40, 48) -- where the hero starts
local WAYS =
  { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 }, { 1, 1 }, { 1, -1 }, { -1, 1 }, { -1, -1 } }

local function addWall(scene, x, y, width, height, share)
  local random = scene.random
  local wall = small.tile(x, y, width, height)
  wall.slope = random:chance(share) and random:pick(scenes.SLOPES) or nil
  if overlap.depth(wall, FREE) <= 0 then
    table.insert(scene.walls, scene:add("walls", wall))
  end
end

local function addGrid(scene)
  local random = scene.random
  local share = random:between(0.12, 0.4)
  for n = 0, 299 do
    if random:chance(share) then
      addWall(scene, 16 * (n % 20), 16 * math.floor(n / 20), 16, 16, 0.65)
    end
  end
end

local function addWalls(scene)
  local random = scene.random
  for _ = 1, random:integer(12, 40) do
    local width, height = random:integer(8, 90), random:integer(8, 70)
    local x, y = random:integer(0, 320 - width), random:integer(0, 240 - height)
    addWall(scene, x, y, width, height, 0.7)
  end
end

local function addLift(scene)
  local isLevel = scene.seed % 8 == 1
  local lift = put(48, 180, 48, 8, { kinematic = true })
  lift.vx, lift.vy = isLevel and 60 or 0, isLevel and 0 or 50
  lift.oneWay = scene.seed % 16 == 5 and "top" or nil
  return scene:add("lifts", lift)
end

local function build(scene)
  local random = scene.random
  local world = scene:start(random:pick(scenes.RATES), scene.seed % 3 == 0 and 0 or 900)
  world:setBounds(0, 0, 320, 240)
  local bounds = world.objects.bounds
  scene.walls = { bounds.top, bounds.bottom, bounds.left, bounds.right }
  local hero = put(8, 200, random:pick({ 8, 10, 12, 14, 16 }), random:pick({ 12, 16, 20, 24 }))
  local add = scene.seed % 2 == 0 and addGrid or addWalls
  add(scene)
  local lift = scene.seed % 4 == 1 and addLift(scene) or nil
  if random:chance(0.4) then
    local area = { gravity = 60, airFriction = 2 }
    scene:add("water", small.tile(0, 120, 320, 120, { sensor = true, area = area }))
  end
  hero.nudge = random:chance(0.4) and 4 or nil
  hero.snap = random:chance(0.4) and 8 or nil
  hero.constantSpeed = random:chance(0.2) or nil
  hero.maxSlope = random:chance(0.15) and 1.2 or nil
  hero.maxFallSpeed = 500
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
    if isDashing or scene.world.gravity == 0 then
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
  local x, y, most, state = hero.x, hero.y, 0, scene.world:save()
  for _, way in ipairs(WAYS) do
    for _ = 1, scene.hz / 2 do
      hero.gravity, hero.vx, hero.vy = 0, 120 * way[1], 120 * way[2]
      scene:step()
      most = math.max(most, math.abs(hero.x - x), math.abs(hero.y - y))
    end
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
    scene:measure("crushed without a lift", not isNearLift())
  end
  for _ = 1, 8 * scene.hz do
    steer()
    if lift then
      scene:turn(lift, 2, 270, 8, 230)
    end
    scene:step()
    lastNear = isNearLift() and scene.frame or lastNear
    local depth = scene:depthIn(hero, scene.walls)
    isHeld = depth > scenes.EXACT and (isHeld or scene.frame <= lastNear + 2)
    if not isHeld then
      scene:measure("in a wall", depth)
      if depth > scenes.EXACT then
        break
      end
    end
  end
  if not isHeld then
    scene:measure("stuck", farthest(scene, hero) < 0.5)
  end
end

return {
  {
    name = "rooms",
    scenes = 640,
    salt = { 31, 5 },
    rows = { { "in a wall", scenes.EXACT, "px" }, { "crushed without a lift", 0 }, { "stuck", 0 } },
    play = play,
  },
}
