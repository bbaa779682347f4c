--- A press with a slanted underside on boxes and balls, and a hanging slope over a hero that stands
--- up.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local FLOOR = 400 -- px
local WAY = 90 -- px, of the press to the floor

-- Kinds of what is pressed, from the floor upwards.
local KINDS = { { "box" }, { "ball" }, { "box", "box" }, { "ball", "box" }, { "box", "ball" } }

local function addFloor(scene)
  scene:add("floors", tile(-2e5, FLOOR, 4e5, 20))
end

-- Adds what is pressed, with its middle at x.
local function addPressed(scene, kind, x)
  local random, list, bottom = scene.random, {}, FLOOR
  for n, shape in ipairs(kind) do
    local size = random:integer(8, 24)
    local object = put(x - size / 2, bottom - size, size, size)
    if shape == "ball" then
      object.radius = size / 2
    else
      object.x = object.x + random:between(-2, 2)
      scene:vary(object, "friction", { false, 0.5 })
    end
    list[n], bottom = scene:add("things", object), bottom - size
  end
  if #kind == 2 and kind[1] == kind[2] and random:chance(0.5) then
    list[3] = scene:add("things", put(x - 4, bottom - 8, 8, 8))
  end
  return list
end

local function fastest(object)
  return math.max(math.abs(object.vx), math.abs(object.vy))
end

-- Looks at a step of each object: `was` and `speeds` are from before it.
local function look(scene, list, was, speeds, speed)
  local hz = scene.hz
  for n, object in ipairs(list) do
    local before, now = speeds[n], fastest(object)
    local allowed = math.max(before, now, speed) / hz * 2 + 900 / hz / hz + object.width / 4
    scene:measure("moved by surprise, px", scene:moved({ object }, { was[n] }) - allowed)
    local isThrown = not object.radius and now > before + 100
    scene:measure("a box thrown, px/s too fast", isThrown and now - 3 * speed - 300)
  end
end

local function lookAtEnd(scene, list, x)
  for _, object in ipairs(list) do
    scene:measure("told so often", scene.told[object])
    scene:measure("ends in the floor, px", object.y + object.height - FLOOR)
    scene:measure("a box ends far away, px", not object.radius and math.abs(object.x - x))
  end
end

local function playPress(scene)
  local random, kind = scene.random, scene:each(KINDS)
  local hz = scene:start()
  addFloor(scene)
  local width, height = random:integer(60, 300), random:integer(10, 90)
  local press = put(0, FLOOR - height - WAY, width, height, { kinematic = true })
  scene:add("presses", scene:vary(press, "slope", { "topleft", "topright" }))
  local x = random:between(0.15, 0.85) * width
  local list, gap = addPressed(scene, kind, x), random:pick({ 0, 5 })
  for n = 1, random:pick({ 0, 0, 0, 1, 2 }) do
    scene:add("walls", tile(n == 1 and x - 40 - gap or x + 20 + gap, 300, 20, 100))
  end
  scene:play(0.5)
  local speed, lowest, turn = random:pick({ 45, 60, 150 }), 0, math.floor(2.2 * hz)
  local was, speeds = nil, {}
  press.vy = speed
  scene:play(3.5, function(n)
    was = scene:places(list)
    for k, object in ipairs(list) do
      speeds[k] = fastest(object)
    end
    press.vy = press.y > FLOOR - height - 4 and math.min(press.vy, 0) or press.vy
    press.vy = n == turn and -speed or press.vy
  end, function(n)
    lowest = math.max(lowest, press.y)
    look(scene, list, was, speeds, speed)
    for _, object in ipairs(n == turn - 1 and list or {}) do
      local isOver = object.x + object.width > press.x and object.x < press.x + width
      scene:measure("ends above the press", isOver and object.y + object.height < press.y + 1)
    end
  end)
  lookAtEnd(scene, list, x)
  press.y = lowest
  local isUntold = #list == 1 and not list[1].radius and scene.crushes == 0
  scene:measure("pressed, not told, px", isUntold and overlap.depth(list[1], press))
end

-- Standing up below a slope -----------------------------------------------------------------------

-- Makes a hero as tall as that, on the floor.
local function setHeight(hero, height)
  hero.y, hero.height = hero.y + hero.height - height, height
end

local function playStandUp(scene)
  local random = scene.random
  scene:start()
  addFloor(scene)
  local width, height, low = random:integer(20, 150), random:integer(3, 16), random:integer(10, 20)
  local slope = tile(0, FLOOR - low - height, width, height)
  scene:add("slopes", scene:vary(slope, "slope", { "topleft", "topright" }))
  local hero = put(random:between(0.1, 0.9) * width - 7, FLOOR - low, random:integer(8, 20), low)
  scene:add("heroes", hero)
  scene:play(0.5)
  local x, tall = hero.x, random:integer(low + height, 40)
  setHeight(hero, tall)
  local deep, most, was = overlap.depth(hero, slope), 0, nil
  scene:play(1, function()
    was = scene:places({ hero })
  end, function()
    most = math.max(most, scene:moved({ hero }, was))
  end)
  local isThrown = most > 12 or hero.y < FLOOR - tall - 1 or math.abs(hero.x - x) > 1
  scene:measure("thrown, px", isThrown and most)
  scene:measure("told so often", scene.told[hero])
  local isUntold = scene.crushes == 0 and deep > 0.01
  scene:measure("pressed, not told, px", isUntold and overlap.depth(hero, slope))
  setHeight(hero, low)
  scene:play(1)
  local isBelow = hero.y > slope.y
  scene:measure("does not crouch again, px", isBelow and math.abs(hero.y + low - FLOOR))
end

return {
  scenes.subject("presses", 1440, playPress, {
    { "moved by surprise, px", 4 },
    { "a box thrown, px/s too fast", 0 },
    { "told so often", 1 },
    { "pressed, not told, px", 1 },
    { "ends above the press", 0 },
    { "ends in the floor, px", 0.02 },
    { "a box ends far away, px", 400 },
  }),
  scenes.subject("standing-up", 600, playStandUp, {
    { "thrown, px", 0 },
    { "told so often", 1 },
    { "pressed, not told, px", 0.01 },
    { "does not crouch again, px", 1e-6 },
  }),
}
