--- Wedges of a slope and a ceiling, or a floor, in which a hero walks, dashes or jumps.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

-- The slope rises to the right from the origin; behind it are a block, nothing, or a wall.
local function addWalls(scene, width, height, gap, way, up)
  local behind = scene.random:pick({ "block", "block", "block", "nothing", "wall" })
  local function add(x, y, wallWidth, wallHeight, isSlope)
    x, y = way > 0 and x or -x - wallWidth, up < 0 and y or -y - wallHeight
    local slope = (up < 0 and "" or "top") .. (way > 0 and "right" or "left")
    local fields = { slope = isSlope and slope or nil }
    scene:add("walls", small.tile(x, y, wallWidth, wallHeight, fields))
  end
  add(-300, 0, 700, 20)
  add(0, -height, width, height, true)
  add(-300, -height - gap - 20, 700, 20)
  if behind == "block" then
    add(width, -height, 80, height)
  elseif behind == "wall" then
    add(width, -height - gap, 20, height + gap)
  end
end

local function play(scene)
  local random = scene.random
  local hz = scene:start({ 0, 900, 900 })
  local way, up = random:pick({ 1, -1 }), random:pick({ -1, -1, 1 })
  local width, height = random:integer(12, 100), random:integer(8, 60)
  local heroWidth, heroHeight = random:integer(6, 20), random:integer(8, 30)
  local more = { -random:between(0.1, 3), -random:between(0, 12), random:between(0, 6), 0 }
  local gap = math.max(2, heroHeight + random:pick(more))
  if height + gap < heroHeight then
    return
  end
  addWalls(scene, width, height, gap, way, up)
  local walls = small.set({}, scene.objects)
  local speed = random:pick({ 60, 130, 300, 500, 900 })
  local mode = random:pick({ "walk", "dash", "jump", "dash and jump" })
  local x = -heroWidth - random:integer(0, 60)
  local hero = small.put(way > 0 and x or -x - heroWidth, up < 0 and -heroHeight or 0)
  hero.width, hero.height = heroWidth, heroHeight
  scene:vary(hero, "nudge", { false, false, 4 }, "snap", { false, false, 8 })
  hero.constantSpeed = random:chance(0.2) or nil
  scene:add("heroes", hero)
  local function walk(seconds, vx)
    scene:play(seconds, function(n)
      hero.vx = vx
      if mode == "dash" or mode == "dash and jump" then
        local rise = n % 20 < 10 and up or -up
        hero.gravity, hero.vy = 0, mode == "dash" and 0 or speed * rise / 2
      elseif mode == "jump" and hero.touching.bottom and n % 15 == 0 then
        hero.vy = -300
      end
    end, function()
      scene:measure("in a wall, px", scene:depthIn(hero, walls))
    end)
  end
  scene:play(2 / hz)
  walk(1.5, speed * way)
  x = hero.x
  local along = way > 0 and x or -x - heroWidth
  scene:measure("through a gap too small", gap < heroHeight and along > width)
  walk(1, -60 * way)
  hero.gravity = 0
  scene:play(1, function()
    hero.vx, hero.vy = -60 * way, 0
  end)
  scene:measure("stuck", math.abs(hero.x - x) < 1)
  scene:measure("crushed", scene.crushes)
end

return {
  scenes.subject("wedges", 3000, play, {
    { "in a wall, px", scenes.EXACT },
    { "crushed", 0 },
    { "stuck", 0 },
    { "through a gap too small", 0 },
  }),
}
