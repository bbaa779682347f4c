--- Wedges of a slope and a ceiling, or a floor, in which a hero walks, dashes or jumps.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

-- The slope rises to the right from the origin; behind it are a block, nothing, or a wall.
local function addWalls(scene, width, height, gap, isMirrored, isUpsideDown)
  local behind = scene.random:pick({ "block", "block", "block", "nothing", "wall" })
  local function add(x, y, wallWidth, wallHeight, slope)
    x = isMirrored and -x - wallWidth or x
    y = isUpsideDown and -y - wallHeight or y
    if slope then
      slope = (isUpsideDown and "top" or "") .. (isMirrored and "left" or "right")
    end
    scene:add("walls", small.tile(x, y, wallWidth, wallHeight, { slope = slope }))
  end
  add(-300, 0, 700, 20)
  add(0, -height, width, height, "right")
  add(-300, -height - gap - 20, 700, 20)
  if behind == "block" then
    add(width, -height, 80, height)
  elseif behind == "wall" then
    add(width, -height - gap, 20, height + gap)
  end
end

local function addHero(scene, width, height, isMirrored, isUpsideDown)
  local random = scene.random
  local x = -width - random:integer(0, 60)
  local hero = small.put(x, isUpsideDown and 0 or -height, width, height)
  hero.x = isMirrored and -x - width or x
  hero.nudge = random:chance(0.3) and 4 or nil
  hero.snap = random:chance(0.3) and 8 or nil
  hero.constantSpeed = random:chance(0.2) or nil
  return scene:add("heroes", hero)
end

local function play(scene)
  local random = scene.random
  scene:start(random:pick(scenes.RATES), random:pick({ 0, 900, 900 }))
  local isMirrored, isUpsideDown = random:chance(0.5), random:chance(0.35)
  local width, height = random:integer(12, 100), random:integer(8, 60)
  local heroWidth, heroHeight = random:integer(6, 20), random:integer(8, 30)
  local more = { -random:between(0.1, 3), -random:between(0, 12), random:between(0, 6), 0 }
  local gap = math.max(2, heroHeight + random:pick(more))
  addWalls(scene, width, height, gap, isMirrored, isUpsideDown)
  local speed = random:pick({ 60, 130, 300, 500, 900 })
  local mode = random:pick({ "walk", "dash", "jump", "dash and jump" })
  if height + gap < heroHeight then
    return
  end
  local walls = small.set({}, scene.objects)
  local hero = addHero(scene, heroWidth, heroHeight, isMirrored, isUpsideDown)
  local way, up = isMirrored and -1 or 1, isUpsideDown and 1 or -1
  local hz = scene.hz
  local function step(vx, n)
    hero.vx = vx
    if mode == "dash" or mode == "dash and jump" then
      local rise = n % 20 < 10 and up or -up
      hero.gravity, hero.vy = 0, mode == "dash" and 0 or speed * rise / 2
    elseif mode == "jump" and hero.touching.bottom and n % 15 == 0 then
      hero.vy = -300
    end
    scene:step()
    scene:measure("in a wall", scene:depthIn(hero, walls))
  end
  scene:run(2)
  for n = 1, 1.5 * hz do
    step(speed * way, n)
  end
  local x = hero.x
  local along = isMirrored and -x - heroWidth or x
  scene:measure("through a gap too small", x * way > 0 and gap < heroHeight and along > width)
  for n = 1, hz do
    step(-60 * way, n)
  end
  hero.gravity = 0
  for _ = 1, hz do
    hero.vx, hero.vy = -60 * way, 0
    scene:step()
  end
  scene:measure("stuck", math.abs(hero.x - x) < 1)
  scene:measure("crushed", scene.crushes)
end

return {
  {
    name = "wedges",
    scenes = 3000,
    salt = { 47, 3 },
    rows = {
      { "in a wall", scenes.EXACT, "px" },
      { "crushed", 0 },
      { "stuck", 0 },
      { "through a gap too small", 0 },
    },
    play = play,
  },
}
