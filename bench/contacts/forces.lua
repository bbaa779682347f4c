--- Boxes and balls that land in water, or leave it along a wall; and a hero with `snap` that wind,
--- a magnet, an engine or gravity lifts.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local WALL, FLOOR, LAND = 200, 300, -100 -- px: left side of the wall, the ground, top of the wall

local function addSwimmer(scene)
  local random = scene.random
  local area = scene:vary({}, "gravity", { 60, 300 }, "airFriction", { 1, 2, 5, 20 })
  scene:vary(area, "drag", { false, false, false, 50 })
  local zone = { sensor = true, area = area }
  scene:add("water", tile(-400, random:integer(120, 290), 600, 200, zone))
  local swimmer = put(random:between(0, 170), 60, 14, 24)
  if random:chance(0.3) then
    swimmer.width, swimmer.height, swimmer.radius = 20, 20, 10
  end
  scene:vary(swimmer, "snap", { false, 6 }, "nudge", { false, 4 }, "friction", { 0, 0.5 })
  return scene:add("swimmers", swimmer)
end

local function playWater(scene)
  local random = scene.random
  local hz = scene:start()
  scene:add("walls", tile(-400, FLOOR, 1000, 20))
  scene:add("walls", tile(WALL, LAND, 20, 400))
  local swimmer, swim = addSwimmer(scene), random:pick({ false, 130, 400 })
  -- Swims for some seconds, and stands still when it has landed.
  local function land(row, first)
    scene:play(8, function(n)
      if n < first * hz then
        swimmer.vx = swim or swimmer.vx
      elseif swimmer.touching.bottom then
        swimmer.vx = 0
      end
    end, function(n)
      local isOnGround = n > (first + 1) * hz and swimmer.touching.bottom
      scene:measure(row, isOnGround and math.abs(swimmer.vy))
    end)
    if swimmer.touching.bottom then
      local low = swimmer.y + swimmer.height
      scene:measure(row, math.abs(swimmer.vx))
      scene:measure("above or in the ground, px", low > LAND + 1 and math.abs(low - FLOOR))
    end
  end
  land("landed, px/s", 3)
  local up = random:pick({ -90, -200, -400 })
  swimmer.x = WALL - swimmer.width - random:pick({ 0, 10 })
  scene:play(0.8, function()
    swimmer.vx, swimmer.vy = 130, up
  end, function()
    scene:measure("in the wall, px", scene:deepest())
  end)
  land("come back along a wall, px/s", 0)
end

-- Snap --------------------------------------------------------------------------------------------

-- Kind of lift -> the fields of a zone with that pull.
local ZONES = {
  wind = function(pull)
    return { area = { ay = -pull } }
  end,
  gravity = function(pull)
    return { area = { gravity = -pull } }
  end,
  magnet = function(pull)
    return { area = { attract = pull, law = "inverse" }, radius = 500 }
  end,
}

-- Plays a second, and returns the places of the hero.
local function lift(scene, choice, snap)
  scene:again()
  local x, slope, y = choice.x, choice.slope, FLOOR - 24
  if slope then
    scene:add("walls", tile(-2000, 200, 4000, 1000, { slope = slope }))
    y = slope == "left" and 176 + (x + 2000) / 4 or 1176 - (x + 2014) / 4
  else
    scene:add("walls", tile(-2000, FLOOR, 4000, 20))
  end
  local hero, places = scene:add("heroes", put(x, y, 14, 24, { snap = snap })), {}
  local newZone = ZONES[choice.kind]
  scene:play(1, function(n)
    if n == choice.begin and newZone then
      local zone = tile(x - 500, y - 600, 1000, 1000, newZone(choice.pull))
      scene:add("zones", small.set(zone, { sensor = true }))
    elseif n == choice.begin then
      hero.ay = -choice.pull
    end
    hero.vx = hero.touching.bottom and choice.vx or hero.vx
  end, function(n)
    places[n] = { x = hero.x, y = hero.y }
  end)
  return places
end

local function playSnap(scene)
  local choice = { x = scene.random:between(80, 120), begin = scene.random:pick({ 1, 16 }) }
  scene:start()
  scene:vary(choice, "kind", { "wind", "magnet", "engine", "gravity" })
  scene:vary(choice, "pull", { 950, 1200, 2000, 5000 }, "vx", { false, 60, -60 })
  scene:vary(choice, "slope", { false, "left", "right" })
  local free = lift(scene, choice, nil)
  local snapped = lift(scene, choice, scene.random:pick({ 4, 8, 16 }))
  scene:measure("rises otherwise than without it, px", scene:moved(free, snapped))
  local isUp = free[#free].y <= free[1].y - 1
  scene:measure("rises in neither", choice.kind ~= "magnet" and choice.begin == 1 and not isUp)
end

return {
  scenes.subject("water", 240, playWater, {
    { "landed, px/s", 0 },
    { "come back along a wall, px/s", 0 },
    { "above or in the ground, px", 1e-6 },
    { "in the wall, px", 1e-6 },
  }),
  scenes.subject("snap", 240, playSnap, {
    { "rises otherwise than without it, px", 1e-6 },
    { "rises in neither", 0 },
  }),
}
