--- Bodies with `maxSpeed` that bounce, and `canCollide` of two that overlap.

local overlap = require("spec.support.overlap")
local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local put, tile = small.put, small.tile

local ABOVE, DIAGONAL = "above maxSpeed", "the same at a contact, of both axes"

local function isTouching(thing)
  local sides = thing.touching
  return sides.top or sides.bottom or sides.left or sides.right
end

local function addThings(scene)
  local random, things = scene.random, {}
  for n = 1, random:integer(1, 10) do
    local size = random:integer(8, 16)
    local thing = put(5 + n * 37 % 170, 5 + n * 23 % 60, size, size)
    thing.radius = random:chance(0.5) and size / 2 or nil
    scene:vary(thing, "restitution", { 0, 0.5, 1 }, "maxSpeed", { 50, 150, 300 }, "mass", { 1, 5 })
    thing.vx, thing.vy = random:integer(-400, 400), random:integer(-400, 400)
    things[n] = scene:add("things", thing)
  end
  return things
end

local function playSpeed(scene)
  local random = scene.random
  scene:start({ 0, 900 })
  scene.world:setBounds(0, 0, 200, 160)
  if random:chance(0.6) then
    local slope = scene:vary(tile(60, 100, 80, 60), "slope", { "left", "right" })
    scene:add("slopes", scene:vary(slope, "restitution", { false, 1 }))
  end
  local lift = put(20, 60, 50, 8, { kinematic = true, vx = 40, vy = random:pick({ 0, 30 }) })
  if random:chance(0.4) then
    scene:add("lifts", lift)
  end
  local things = addThings(scene)
  scene:play(4, function()
    scene:turn(lift, 5, 140, 20, 140)
  end, function()
    for _, thing in ipairs(things) do
      local vx, vy = math.abs(thing.vx), math.abs(thing.vy)
      local isOnAxes = math.max(vx, vy) <= thing.maxSpeed * (1 + 1e-9) and isTouching(thing)
      local share = math.sqrt(vx * vx + vy * vy) / thing.maxSpeed - 1
      scene:measure(isOnAxes and DIAGONAL or ABOVE, share)
    end
  end)
end

local function playAsked(scene)
  local random = scene.random
  scene:start({ 0, 900 })
  local first, second = put(0, 0, 20, 20), put(random:between(1, 18), random:between(1, 18), 20, 20)
  scene:vary(first, "radius", { false, 10 }, "static", { false, false, true })
  scene:add("first", first)
  scene:add("second", scene:vary(second, "radius", { false, 10 }))
  if first.static and random:chance(0.5) then
    first.radius, first.slope = nil, random:pick({ "left", "topright" })
  end
  local count, answer = 0, random:chance(0.6)
  local owner = random:pick({ scene.world, first, second })
  function owner.canCollide()
    count = count + 1
    return answer
  end
  scene.world:refresh(first)
  local isDeep = overlap.depth(first, second) > 0.01
  for n = 1, 5 do
    count = 0
    scene:step()
    scene:measure("asked so often in a step", count)
    scene:measure("not asked", n == 1 and isDeep and count == 0)
  end
end

return {
  scenes.subject("maxSpeed", 300, playSpeed, { { ABOVE, 1e-9 }, { DIAGONAL, math.sqrt(2) - 1 } }),
  scenes.subject("canCollide", 200, playAsked, {
    { "asked so often in a step", 1 },
    { "not asked", 0 },
  }),
}
