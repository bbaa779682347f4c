--- Boxes and balls that are added, put, or grow into another object, or meet it by another field:
--- one `onBegin` with the speed 0, and `touching`.

local scenes = require("bench.contacts.scene")
local small = require("spec.support.small")

local OTHERS = {
  { static = true },
  { kinematic = true },
  {},
  { pushable = false },
  { static = true, radius = 20 },
  { radius = 20 },
  { static = true, slope = "left" },
  { static = true, slope = "topright" },
  { static = true, sensor = true },
}
local SIZE = 20 -- px

-- Way to meet -> f(scene, object, other): brings them into each other.
local WAYS = {}

local function wait(scene, object)
  scene:add("things", object)
  scene:play(0.1)
end

function WAYS.add(scene, object)
  scene:play(0.1)
  scene:add("things", object)
end

function WAYS.put(scene, object)
  local x = object.x
  object.x = -300
  wait(scene, object)
  object.x = x
end

-- To the right, and a circle cannot do that.
function WAYS.grow(scene, object)
  if object.radius then
    return WAYS.add(scene, object)
  end
  object.x, object.width, object.height = object.x - 40, 4, 4
  wait(scene, object)
  object.width, object.height = 60, SIZE
end

function WAYS.activate(scene, object)
  object.active = false
  wait(scene, object)
  object.active = true
end

function WAYS.mask(scene, object)
  object.mask = { others = false }
  wait(scene, object)
  object.mask = nil
end

WAYS["put the other"] = function(scene, object, other)
  local x = other.x
  other.x = 600
  scene.world:refresh(other)
  wait(scene, object)
  other.x = x
  scene.world:refresh(other)
end

-- Where the object is `deep` px in the other one.
local function placeOf(other, deep)
  if other.slope == "left" then
    return 102, 108
  elseif other.slope == "topright" then
    return 115, 80 + deep
  end
  return 80 + deep, 110
end

local function play(scene)
  local isRound, fields = scene:each({ false, true }), scene:each(OTHERS)
  local way = scene:each({ "add", "put", "grow", "activate", "put the other", "mask" })
  local hz, gravity, deep =
    scene:each({ 30, 144 }), scene:each({ 0, 900 }), scene:each({ 0.5, 3, 12 })
  scene:start(0, hz)
  local other = scene:add("others", small.put(100, 100, 40, 40, fields))
  local x, y = placeOf(other, deep)
  local object = small.put(x, y, SIZE, SIZE, { radius = isRound and SIZE / 2 or nil, gravity = 0 })
  local count, fastest = 0, 0
  function object.onBegin(_, met, _, speed)
    if met == other then
      count, fastest = count + 1, math.max(fastest, speed)
    end
  end
  WAYS[way](scene, object, other)
  scene.world.gravity = gravity
  scene:step()
  local isTouching = fields.sensor
  for _, touched in pairs(object.touching) do
    isTouching = isTouching or touched == other
  end
  scene:measure("silent, or begins twice", count ~= 1)
  scene:measure("begins with a speed, px/s", fastest)
  scene:measure("not in touching", not isTouching)
end

return {
  scenes.subject("added", 1296, play, {
    { "silent, or begins twice", 0 },
    { "begins with a speed, px/s", 0 },
    { "not in touching", 0 },
  }),
}
