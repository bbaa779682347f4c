--- A press with a slanted underside on boxes and balls, and a hanging slope over a hero that stands
--- up.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local KINDS = { "box", "ball", "stack", "box on ball", "ball on box" }
local FLOOR = 400

local function addFloor(scene)
  return scene:add("floors", tile(-2e5, FLOOR, 4e5, 20))
end

-- Adds what is pressed, from the floor upwards; returns it, and where its middle is.
local function addPressed(scene, kind, pressWidth)
  local random, list = scene.random, {}
  local size, second = random:integer(8, 24), random:integer(8, 24)
  local x = random:between(0.15, 0.85) * pressWidth
  local function box(bottom, width)
    local left = x - width / 2 + random:between(-2, 2)
    local friction = random:pick({ false, 0.5 }) or nil
    list[#list + 1] = put(left, bottom - width, width, width, { friction = friction })
  end
  if kind == "box" or kind == "stack" or kind == "ball on box" then
    box(FLOOR, size)
  else
    list[1] = small.ball(x, FLOOR - size / 2, size / 2)
  end
  if kind == "stack" then
    box(FLOOR - size, second)
    if random:chance(0.5) then
      box(FLOOR - size - second, 8)
    end
  elseif kind == "box on ball" then
    list[2] = put(x - second / 2, FLOOR - size - second, second, second)
  elseif kind == "ball on box" then
    list[2] = small.ball(list[1].x + size / 2, FLOOR - size - second / 2, second / 2)
  end
  for _, object in ipairs(list) do
    scene:add("things", object)
  end
  return list, x
end

local function fastest(object)
  return math.max(math.abs(object.vx), math.abs(object.vy))
end

-- Looks at a step of each object: `was` and `speeds` are from before it.
local function measureStep(scene, list, was, speeds, speed)
  local hz = scene.hz
  for n, object in ipairs(list) do
    local before, now = speeds[n], fastest(object)
    local allowed = math.max(before, now, speed) / hz * 2 + 900 / hz / hz
    local beyond = scene:moved({ object }, { was[n] }) - allowed
    scene:measure("moved more than its speed explains", beyond - object.width / 4)
    if not object.radius and now > before + 100 then
      scene:measure("a box thrown, px/s too fast", now - 3 * speed - 300)
    end
  end
end

local function measureEnd(scene, list, x)
  for _, object in ipairs(list) do
    scene:measure("told so often", scene.told[object])
    scene:measure("ends in the floor", object.y + object.height - FLOOR)
    scene:measure("a box ends far away", not object.radius and math.abs(object.x - x))
  end
end

local function playPress(scene)
  local random, kind = scene.random, KINDS[scene.seed % 5 + 1]
  local hz = random:pick(scenes.RATES)
  scene:start(hz)
  addFloor(scene)
  local width, height = random:integer(60, 300), random:integer(10, 90)
  local fields = { slope = random:pick({ "topleft", "topright" }), kinematic = true }
  local press = scene:add("presses", put(0, FLOOR - height - 90, width, height, fields))
  local list, x = addPressed(scene, kind, width)
  if random:chance(0.4) then
    local gap = random:pick({ 0, 5 })
    scene:add("walls", tile(x - 40 - gap, 300, 20, 100))
    if random:chance(0.5) then
      scene:add("walls", tile(x + 20 + gap, 300, 20, 100))
    end
  end
  scene:run(hz / 2)
  local speed, lowest, turn = random:pick({ 45, 60, 150 }), 0, math.floor(2.2 * hz)
  press.vy = speed
  for n = 1, 3.5 * hz do
    local was, speeds = scene:places(list), {}
    for k, object in ipairs(list) do
      speeds[k] = fastest(object)
    end
    if press.y > FLOOR - height - 4 and press.vy > 0 then
      press.vy = 0
    end
    press.vy = n == turn and -speed or press.vy
    scene:step()
    lowest = math.max(lowest, press.y)
    for _, object in ipairs(n == turn - 1 and list or {}) do
      local isOver = object.x + object.width > press.x and object.x < press.x + width
      scene:measure("ends above the press", isOver and object.y + object.height < press.y + 1)
    end
    measureStep(scene, list, was, speeds, speed)
  end
  measureEnd(scene, list, x)
  if kind == "box" and scene.crushes == 0 then
    scene:measure(
      "pressed, but not told",
      overlap.depth(list[1], small.set(put(0, lowest, width, height), fields))
    )
  end
end

-- Standing up below a slope -----------------------------------------------------------------------

-- Makes a hero as tall as that, on the floor.
local function setHeight(hero, height)
  hero.y, hero.height = hero.y + hero.height - height, height
end

local function playStandUp(scene)
  local random = scene.random
  local hz = random:pick(scenes.RATES)
  scene:start(hz)
  addFloor(scene)
  local width, height, low = random:integer(20, 150), random:integer(3, 16), random:integer(10, 20)
  local name = random:pick({ "topleft", "topright" })
  local slope = scene:add("slopes", tile(0, FLOOR - low - height, width, height, { slope = name }))
  local heroWidth = random:integer(8, 20)
  local tall = random:integer(low + height, 40)
  local x = random:between(0.1, 0.9) * width - heroWidth / 2
  local hero = scene:add("heroes", put(x, FLOOR - low, heroWidth, low))
  scene:run(20)
  if overlap.depth(hero, slope) > 1e-6 then
    return
  end
  x = hero.x
  setHeight(hero, tall)
  local deep, most = overlap.depth(hero, slope), 0
  for _ = 1, hz do
    local was = scene:places({ hero })
    scene:step()
    most = math.max(most, scene:moved({ hero }, was))
  end
  local isThrown = most > 12 or hero.y < FLOOR - tall - 1 or math.abs(hero.x - x) > 1
  scene:measure("thrown, standing up", isThrown and most)
  scene:measure("told so often", scene.told[hero])
  scene:measure(
    "pressed, but not told",
    scene.crushes == 0 and deep > 0.01 and overlap.depth(hero, slope)
  )
  setHeight(hero, low)
  scene:run(hz)
  scene:measure(
    "does not crouch to the floor again",
    hero.y > slope.y and math.abs(hero.y + low - FLOOR)
  )
end

return {
  {
    name = "presses",
    scenes = 1440,
    salt = { 11, 6 },
    rows = {
      { "moved more than its speed explains", 4, "px" },
      { "a box thrown, px/s too fast", 0 },
      { "told so often", 1 },
      { "pressed, but not told", 1, "px" },
      { "ends above the press", 0 },
      { "ends in the floor", 0.02, "px" },
      { "a box ends far away", 400, "px" },
    },
    play = playPress,
  },
  {
    name = "standing-up",
    scenes = 600,
    salt = { 3, 1 },
    rows = {
      { "thrown, standing up", 0, "px" },
      { "told so often", 1 },
      { "pressed, but not told", 0.01, "px" },
      { "does not crouch to the floor again", 1e-6, "px" },
    },
    play = playStandUp,
  },
}
