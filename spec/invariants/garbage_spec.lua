--- In a steady scene an update allocates nothing: no pause of the garbage collector in a game.

local garbage = require("spec.support.garbage")
local ours = require("bench.engines.ours")
local physics = require("physics")
local scenes = require("bench.scenes")
local small = require("spec.support.small")

local newBox, static, wide = small.box, small.tile, small.put

local WARM_UP, MEASURED = 600, 100

local function nothing() end

-- A part of the scene: adds its objects (the floor is at y 300), and returns what the game does
-- before each step.
local PARTS = {
  ["a walker through sensors, between walls"] = function(world)
    world:add("walls", static(0, 200, 16, 100))
    world:add("walls", static(116, 200, 16, 100))
    local walker = world:add("players", newBox(16, 284))
    for i = 0, 3 do
      local zone = static(33 + 12 * i, 200, 5 + 5 * i, 100, { sensor = true })
      zone.onBegin, zone.onEnd = nothing, nothing
      world:add("zones", zone)
    end
    return function(step)
      walker.vx = step % 40 < 20 and 500 or -500
    end
  end,

  ["boxes that are asked whether they collide"] = function(world)
    local function answer(one, other)
      return one.width ~= 17 and other.width ~= 17
    end
    local walker = world:add("players", newBox(100, 284, { canCollide = answer }))
    world:add("boxes", newBox(100, 268, { canCollide = answer }))
    world:add("boxes", wide(130, 284, 17, 16, { gravity = 0 }))
    world.canCollide = answer
    return function(step)
      walker.vx = step % 40 < 20 and 120 or -120
    end
  end,

  ["jumps past the edge of a ledge, by `nudge`, and through one"] = function(world)
    world:add("tiles", static(16, 280, 16, 20))
    world:add("ledges", static(12, 240, 50, 8))
    world:add("ledges", static(100, 250, 200, 8, { oneWay = "top" }))
    local jumper = world:add("players", newBox(0, 284, { nudge = 6 }))
    local other = world:add("players", newBox(150, 284))
    return function(step)
      jumper.vx = step % 50 > 40 and 300 or 0
      if step % 50 == 0 then
        jumper.vy = -250
      end
      if step % 100 == 0 then
        other.vy = -500
      elseif step % 100 == 70 then
        world:dropThrough(other)
      end
    end
  end,

  ["boxes that are crushed again and again"] = function(world)
    local left = world:add("jaws", wide(0, 236, 16, 64, { kinematic = true }))
    local right = world:add("jaws", wide(64, 236, 16, 64, { kinematic = true }))
    world:add("boxes", newBox(20, 284, { onCrush = nothing }))
    world:add("boxes", newBox(40, 284, { onCrush = nothing }))
    return function(step)
      left.vx = step % 100 < 50 and 20 or -20
      right.vx = -left.vx
    end
  end,

  ["boxes that are put into the floor and each other"] = function(world)
    local deep = world:add("boxes", newBox(0, 284))
    local one = world:add("boxes", newBox(100, 284))
    local other = world:add("boxes", newBox(200, 284, { mass = 3 }))
    return function()
      deep.y = 290
      one.x, other.x = 100, 110
    end
  end,
}

-- Scenes of the benchmark, and how many objects are in them.
local SCENES = {
  { "pile", 60 },
  { "level", 150 },
  { "gas", 60 },
  { "balls", 60 },
  { "lifts", 10 },
  { "bullets", 60 },
  { "asking", 40 },
  { "rest-awake", 60 },
  { "swarm-soft-kite", 30 },
  { "spot-corner", 20 },
  { "bulldozer", 40 },
}

describe("world:update of", function()
  small.rows("the scene {1} allocates nothing", SCENES, function(name, count)
    local scene = scenes.build(name, count)
    local world = ours.new(scene)
    local function play(step)
      scene.frame(world, step)
    end
    assert.equal(0, garbage.bytes(play, 150, 50))
  end)

  small.each("{1} allocates nothing", PARTS, function(_, fill)
    local world = physics.newWorld({ gravity = 800 })
    world.onBegin, world.onStay, world.onEnd = nothing, nothing, nothing
    world:add("tiles", static(-100, 300, 900, 20, { friction = 0 }))
    local act = fill(world)
    local function play(step)
      act(step)
      world:update(1 / 60)
    end
    assert.equal(0, garbage.bytes(play, WARM_UP, MEASURED))
  end)

  -- Each is written to once: the same text made twice would be one.
  it("an object that the game places, sizes and filters again allocates no text either", function()
    local world, lifts, boxes, count = physics.newWorld({ gravity = 800 }), {}, {}, 0
    for i = 1, 90 do
      lifts[i] = world:add("lifts", wide(100 * i, 50, 60, 8, { kinematic = true }))
      boxes[i] = world:add("boxes", newBox(100 * i + 10, 34))
    end
    local function play()
      count = count + 1
      local lift, box = lifts[count], boxes[count]
      lift.x, box.width, box.pushable = lift.x + 1, 15, false
      world:update(1 / 60)
    end
    assert.equal(0, garbage.bytes(play, 40, 20))
  end)
end)
