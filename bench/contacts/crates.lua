--- A hero that pushes crates into a wedge, crates that slide below a hanging slope, and riders of a
--- train that passes below one.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local SLACK = 0.1 -- px
local FLOOR = 60 -- px

-- Adds a hanging slope, with a block behind it or above it, or none.
local function addHanging(scene, width, height)
  local random = scene.random
  local y = random:integer(math.max(0, 30 - height), FLOOR - height)
  scene:add("walls", tile(100, y, width, height, { slope = "topright" }))
  if random:chance(0.5) then
    scene:add("walls", tile(100 + width, y, 40, FLOOR - y))
  end
  if random:chance(0.3) then
    scene:add("walls", tile(100, y - 10, width, 10))
  end
end

-- Adds a slope on the ground and a ceiling above it, and returns the lower side of that.
local function addRising(scene, width, height)
  local random = scene.random
  scene:add("walls", tile(100, FLOOR - height, width, height, { slope = "right" }))
  local ceiling = random:integer(5, 34)
  scene:add("walls", tile(-200, ceiling - 8, 700, 8))
  if random:chance(0.3) then
    scene:add("walls", tile(100 + width, FLOOR - height, 60, height))
  end
  return ceiling
end

-- Adds crates from right to left, then the hero, and returns both.
local function addPushed(scene, ceiling)
  local random, crates, x = scene.random, {}, 90
  for n = 1, random:integer(1, 3) do
    local width, height = random:integer(8, 20), random:integer(8, math.min(24, 59 - ceiling))
    x = x - width - random:pick({ 0, 0, 3, 8 })
    local crate = put(x, FLOOR - height, width, height)
    scene:vary(crate, "mass", { 1, 1, 0.3, 4 }, "friction", { false, false, 0.5 })
    crates[n] = scene:add("crates", crate)
  end
  local width, height = random:integer(8, 16), random:integer(10, math.min(28, 59 - ceiling))
  local hero = put(x - width - random:integer(0, 20), FLOOR - height, width, height)
  local nudges, snaps = { false, false, 4 }, { false, false, 6 }
  scene:vary(hero, "mass", { 1, 1, 3 }, "nudge", nudges, "snap", snaps)
  return scene:add("heroes", hero), crates
end

-- What is looked at in every step.
local function look(scene)
  return function()
    scene:measure("in something, px", scene:deepest())
    scene:measure("crushed", scene.crushes)
  end
end

-- Drives one back for a second, and measures how far it does not come.
local function pullBack(scene, object, vx)
  local x = object.x
  scene:play(1, function()
    object.vx = vx
  end, look(scene))
  scene:measure("in something at the end, px", scene:deepest())
  scene:measure("held on the way out, px of 100", 100 - math.abs(object.x - x))
end

local function push(scene)
  local random = scene.random
  local hz = scene:start({ 900, 900, 900, 900, 900, 0 })
  scene:add("walls", tile(-200, FLOOR, 700, 16))
  local add = random:pick({ addHanging, addHanging, addRising })
  local ceiling = add(scene, random:integer(16, 90), random:integer(10, 56))
  local hero, crates = addPushed(scene, ceiling or 0)
  local speed, isJumping = random:pick({ 60, 120, 200, 500 }), random:chance(0.3)
  scene:play(2)
  scene:play(3, function(n)
    hero.vx = speed
    if isJumping and hero.touching.bottom and n % math.floor(hz * 0.4) == 0 then
      hero.vy = -250
    end
  end, look(scene))
  for _, crate in ipairs(crates) do
    if crate.x < hero.x then
      return -- it is in the way
    end
  end
  pullBack(scene, hero, -100)
end

local function slide(scene)
  local random = scene.random
  scene:start()
  scene:add("walls", tile(-300, FLOOR, 800, 16))
  local width, height = random:integer(12, 90), random:integer(8, 50)
  local way = random:pick({ 1, -1 })
  local slope = { slope = way > 0 and "topright" or "topleft" }
  scene:add("walls", tile(100, FLOOR - height - random:integer(0, 20), width, height, slope))
  local crate = put(140 + width, FLOOR, random:integer(6, 24), random:integer(6, 30))
  crate.x, crate.y = way > 0 and FLOOR - crate.width or crate.x, FLOOR - crate.height
  scene:add("crates", scene:vary(crate, "friction", { 0, 0.3 }))
  if random:chance(0.5) then
    scene:add("crates", put(crate.x + (crate.width - 8) / 2, crate.y - 8, 8, 8))
  end
  local speed = random:pick({ 80, 200, 600, 2000 }) * way
  scene:play(2, function(n)
    crate.vx = n % 3 > 0 and speed or crate.vx
  end, look(scene))
  pullBack(scene, crate, -100 * way)
end

-- Adds a rider with a crate behind it, on it, both or none.
local function addRiders(scene)
  local random = scene.random
  local width, height = random:integer(8, 20), random:integer(8, 30)
  local riders = { scene:add("riders", put(50 - width, FLOOR - height, width, height)) }
  if random:chance(0.5) then
    local crate = scene:vary(put(38 - width, FLOOR - 10, 12, 10), "friction", { 0, 0.5 })
    riders[2] = scene:add("riders", crate)
  end
  if random:chance(0.5) then
    riders[#riders + 1] = scene:add("riders", put(46 - width / 2, FLOOR - 8 - height, 8, 8))
  end
  return riders
end

local function ride(scene)
  local random = scene.random
  local hz = scene:start()
  local width, height = random:integer(12, 90), random:integer(8, 60)
  local y = FLOOR - height - random:integer(0, 30)
  scene:add("walls", tile(100, y, width, height, { slope = "topright" }))
  if random:chance(0.5) then
    scene:add("walls", tile(100 + width, 0, 40, FLOOR))
  end
  local train = scene:vary(put(-500, FLOOR, 590, 16), "kinematic", { true }, "vx", { 30, 60, 200 })
  scene:add("trains", train)
  local riders, vy, was = addRiders(scene), random:pick({ 0, 0, 0, -20, 20 }), nil
  scene:play(3, function(n)
    train.vy = n > hz and vy or 0
    was = scene:places(riders)
  end, function()
    scene:measure("moved in a step, px", scene:moved(riders, was))
    scene:measure("in something, not told, px", scene.crushes == 0 and scene:deepest())
  end)
  scene:measure("crushed on a level train", vy == 0 and scene.crushes)
  for _, rider in ipairs(riders) do
    scene:measure("told so often", scene.told[rider])
  end
end

local ROWS = {
  { "in something, px", SLACK },
  { "in something at the end, px", SLACK },
  { "crushed", 0 },
  { "held on the way out, px of 100", 10 },
}

return {
  scenes.subject("pushed", 2100, push, ROWS),
  scenes.subject("slid", 2100, slide, ROWS),
  scenes.subject("riders", 2100, ride, {
    { "in something, not told, px", SLACK },
    { "crushed on a level train", 0 },
    { "told so often", 1 },
    { "moved in a step, px", 26 },
  }),
}
