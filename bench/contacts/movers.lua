--- A hero on stairs that sink or rise, and crates on each other between a belt and a ram.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put = small.put

local STEPS, TREAD = 10, 20 -- of the stairs; px

-- Adds stairs with steps as high as that, sloped or not, and returns them.
local function addStairs(scene, height, isSloped)
  local stairs = {}
  local function add(x, y, width, tall, slope)
    local stair = put(x, y, width, tall, { kinematic = true, slope = slope })
    stairs[#stairs + 1] = scene:add("stairs", stair)
  end
  add(-200, 300, 300, 400)
  for n = 1, STEPS do
    local x, y = 80 + TREAD * n, 300 - height * n
    if isSloped then
      add(x, y, TREAD, height, "right")
    end
    add(x, isSloped and y + height or y, TREAD, 400)
  end
  add(100 + TREAD * STEPS, 300 - height * STEPS, 600, 400)
  return stairs
end

local function playStairs(scene)
  local random = scene.random
  local hz = scene:start()
  local isSloped, vy = random:chance(0.5), random:pick({ 10, 40, 80, -20 })
  local vx = random:pick({ 0, 0, 30 })
  local stairs = addStairs(scene, random:integer(2, 6), isSloped)
  local hero = put(20, 276, 14, 24)
  scene:vary(hero, "nudge", isSloped and { false, 6 } or { 6 }, "snap", { false, 8 })
  scene:add("heroes", hero)
  scene:play(5 / hz)
  for _, stair in ipairs(stairs) do
    stair.vx, stair.vy = vx, vy
  end
  local speed, ground = random:pick({ 60, 120, 200 }), stairs[1]
  local row = vy < 0 and "rising stairs stop it, of a step" or "sinking stairs stop it, of a step"
  local was
  scene:play(2, function()
    hero.vx, was = speed, hero.x - ground.x
  end, function()
    local along = hero.x - ground.x
    scene:measure(row, along < 580 and 1 - (along - was) / speed * hz)
  end)
end

local function playBelt(scene)
  local random = scene.random
  local hz = scene:start()
  local friction = random:pick({ 0.3, 0.6, 0.9 })
  local belt = { surfaceSpeed = random:pick({ -60, -120 }), friction = friction }
  local function add(group, x, y, size, fields)
    return scene:add(group, put(x, y, size, size, small.set({ friction = friction }, fields)))
  end
  scene:add("belts", small.tile(-500, 300, 1000, 20, belt))
  local list = { add("crates", 100, 280, 20, { mass = random:pick({ 1, 3 }) }) }
  list[2] = add("crates", 100 + random:integer(-8, 8), 260, 20)
  if random:chance(0.5) then
    list[3] = add("crates", 100, 230, 16)
  end
  scene:add("rams", put(0, 285, 60, 10, { kinematic = true, vx = random:pick({ 0, 40 }) }))
  local runner = scene:add("heroes", put(300, 276, 14, 24))
  list[#list + 1] = runner
  local was
  scene:play(3, function(n)
    runner.vx = n > hz and -130 or 0
    if n <= hz then
      runner.x, runner.vy = 300, 0
    end
    was = scene:places(list)
  end, function()
    scene:measure("drawn, faster than, px/s", scene:moved(list, was) * hz - hz)
    scene:measure("in each other, px", scene:deepest())
  end)
end

return {
  scenes.subject("stairs", 240, playStairs, {
    { "sinking stairs stop it, of a step", 0.5 },
    { "rising stairs stop it, of a step", 0.5 },
  }),
  scenes.subject("belt-and-ram", 200, playBelt, {
    { "drawn, faster than, px/s", 400 },
    { "in each other, px", 0.01 },
  }),
}
