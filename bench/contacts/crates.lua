--- A hero that pushes crates into a wedge, crates that slide below a hanging slope, and riders of a
--- train that passes below one. The three are played with one stream of random numbers.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local SLACK = 0.1 -- px

-- Returns the lower side of the ceiling, or 0.
local function addWedge(scene)
  local random = scene.random
  scene:add("walls", tile(-200, 60, 700, 16))
  local kind = random:pick({ "topright", "topright", "right" })
  local width, height = random:integer(16, 90), random:integer(10, 56)
  if kind == "topright" then
    local y = random:integer(math.max(0, 30 - height), 60 - height)
    scene:add("walls", tile(100, y, width, height, { slope = kind }))
    if random:chance(0.5) then
      scene:add("walls", tile(100 + width, y, 40, 60 - y))
    end
    if random:chance(0.3) then
      scene:add("walls", tile(100, y - 10, width, 10))
    end
    return 0
  end
  scene:add("walls", tile(100, 60 - height, width, height, { slope = kind }))
  local ceiling = random:integer(5, 34)
  scene:add("walls", tile(-200, ceiling - 8, 700, 8))
  if random:chance(0.3) then
    scene:add("walls", tile(100 + width, 60 - height, 60, height))
  end
  return ceiling
end

-- Adds crates from right to left, then the hero, and returns both.
local function addPushed(scene, ceiling)
  local random, crates, x = scene.random, {}, 90
  for n = 1, random:integer(1, 3) do
    local width, height = random:integer(8, 20), random:integer(8, math.min(24, 59 - ceiling))
    x = x - width - random:pick({ 0, 0, 3, 8 })
    local crate = put(x, 60 - height, width, height, { mass = random:pick({ 1, 1, 0.3, 4 }) })
    crate.friction = random:chance(0.4) and 0.5 or nil
    crates[n] = scene:add("crates", crate)
  end
  local width, height = random:integer(8, 16), random:integer(10, math.min(28, 59 - ceiling))
  local hero = put(x - width - random:integer(0, 20), 60 - height, width, height)
  hero.mass = random:pick({ 1, 1, 3 })
  hero.nudge = random:chance(0.3) and 4 or nil
  hero.snap = random:chance(0.3) and 6 or nil
  return scene:add("heroes", hero), crates
end

local function push(scene, hz)
  local random = scene.random
  scene:start(hz, random:chance(0.15) and 0 or 900)
  local hero, crates = addPushed(scene, addWedge(scene))
  local speed, isJumping = random:pick({ 60, 120, 200, 500 }), random:chance(0.3)
  scene:run(2 * hz)
  for n = 1, 3 * hz do
    hero.vx = speed
    if isJumping and hero.touching.bottom and n % math.floor(hz * 0.4) == 0 then
      hero.vy = -250
    end
    scene:step()
    scene:measure("pushed crates in something", scene:deepest())
  end
  local x = hero.x
  for _ = 1, hz do
    hero.vx = -100
    scene:step()
    scene:measure("pushed crates in something", scene:deepest())
  end
  scene:measure("the same at the end", scene:deepest())
  scene:measure("pushing, crushed", scene.crushes)
  for _, crate in ipairs(crates) do
    if crate.x < hero.x then
      return -- it is in the way
    end
  end
  scene:measure("pushing, held on the way out, of 100", 100 - (x - hero.x))
end

local function slide(scene, hz)
  local random = scene.random
  scene:start(hz)
  scene:add("walls", tile(-300, 60, 800, 16))
  local width, height = random:integer(12, 90), random:integer(8, 50)
  local way = random:pick({ 1, -1 })
  local slope = { slope = way > 0 and "topright" or "topleft" }
  scene:add("walls", tile(100, 60 - height - random:integer(0, 20), width, height, slope))
  local crateWidth, crateHeight = random:integer(6, 24), random:integer(6, 30)
  local crate = put(way > 0 and 60 - crateWidth or 140 + width, 60 - crateHeight)
  crate.width, crate.height = crateWidth, crateHeight
  crate.friction = random:pick({ 0, 0.3 })
  scene:add("crates", crate)
  if random:chance(0.5) then
    scene:add("crates", put(crate.x + (crateWidth - 8) / 2, 52 - crateHeight, 8, 8))
  end
  local speed = random:pick({ 80, 200, 600, 2000 }) * way
  for n = 1, 2 * hz do
    crate.vx = n % 3 > 0 and speed or crate.vx
    scene:step()
    scene:measure("sliding crates in something", scene:deepest())
  end
  local x = crate.x
  for _ = 1, hz do
    crate.vx = -100 * way
    scene:step()
    scene:measure("sliding crates in something", scene:deepest())
  end
  scene:measure("sliding, crushed", scene.crushes)
  scene:measure("sliding, held on the way out, of 100", 100 - (x - crate.x) * way)
end

-- Adds a rider with a crate behind it, on it, both or none.
local function addRiders(scene)
  local random = scene.random
  local width, height = random:integer(8, 20), random:integer(8, 30)
  local riders = { scene:add("riders", put(50 - width, 60 - height, width, height)) }
  if random:chance(0.5) then
    local friction = random:pick({ 0, 0.5 })
    riders[2] = scene:add("riders", put(38 - width, 50, 12, 10, { friction = friction }))
  end
  if random:chance(0.5) then
    riders[#riders + 1] = scene:add("riders", put(46 - width / 2, 52 - height, 8, 8))
  end
  return riders
end

local function ride(scene, hz)
  local random = scene.random
  scene:start(hz)
  local width, height = random:integer(12, 90), random:integer(8, 60)
  local y = 60 - height - random:integer(0, 30)
  random:unit()
  scene:add("walls", tile(100, y, width, height, { slope = "topright" }))
  if random:chance(0.5) then
    scene:add("walls", tile(100 + width, 0, 40, 60))
  end
  local speed, vy = random:pick({ 30, 60, 200 }), random:pick({ 0, 0, 0, -20, 20 })
  local train = scene:add("trains", put(-500, 60, 590, 16, { kinematic = true, vx = speed }))
  local riders = addRiders(scene)
  for n = 1, 3 * hz do
    train.vy = n > hz and vy or 0
    local was = scene:places(riders)
    scene:step()
    scene:measure("riding, moved in a step", scene:moved(riders, was))
    if scene.crushes == 0 then
      scene:measure("riders in something, not told", scene:deepest())
    end
  end
  scene:measure("riding, crushed on a level train", vy == 0 and scene.crushes)
  for _, rider in ipairs(riders) do
    scene:measure("riding, told so often", scene.told[rider])
  end
end

local function play(scene)
  local hz = scenes.RATES[scene.seed % 3 + 1]
  push(scene, hz)
  slide(scene, hz)
  ride(scene, hz)
end

return {
  {
    name = "crates",
    scenes = 2100,
    salt = { 17, 3 },
    rows = {
      { "pushed crates in something", SLACK, "px" },
      { "the same at the end", SLACK, "px" },
      { "pushing, crushed", 0 },
      { "pushing, held on the way out, of 100", 10, "px" },
      { "sliding crates in something", SLACK, "px" },
      { "sliding, crushed", 0 },
      { "sliding, held on the way out, of 100", 10, "px" },
      { "riders in something, not told", SLACK, "px" },
      { "riding, crushed on a level train", 0 },
      { "riding, told so often", 1 },
      { "riding, moved in a step", 26, "px" },
    },
    play = play,
  },
}
