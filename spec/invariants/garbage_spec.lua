--- In a steady scene an update allocates nothing: no pause of the garbage collector in a game.

local garbage = require("spec.support.garbage")
local physics = require("physics")
local small = require("spec.support.small")

local newBox, static, wide = small.box, small.tile, small.put

local WARM_UP, MEASURED = 600, 100

local function nothing() end

-- A part of the scene: adds its objects (the floor is at y 300), and may return what the game
-- does before each step.
local PARTS = {
  ["a pile"] = function(world)
    for i = 0, 59 do
      local box = newBox(i % 20 * 22, 280 - 20 * math.floor(i / 20), { friction = 0.3 })
      world:add("boxes", box)
    end
  end,

  ["bouncing balls"] = function(world)
    world:add("walls", static(0, 0, 300, 9))
    world:add("walls", static(0, 0, 9, 300))
    world:add("walls", static(300, 0, 9, 300))
    for i = 1, 4 do
      local ball = wide(60 * i, 30 * i, 10, 10, { restitution = 1, gravity = 0, vx = 120 })
      world:add("balls", ball)
    end
  end,

  ["a walker and a lift"] = function(world)
    local walker = world:add("players", wide(100, 276, 14, 24))
    local lift = world:add("lifts", wide(200, 200, 60, 8, { kinematic = true }))
    world:add("players", wide(210, 176, 14, 24))
    return function(step)
      walker.vx = step % 50 < 25 and 100 or -100
      lift.vx = step % 60 < 30 and 60 or -60
    end
  end,

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

  ["boxes that rub each other and a wall"] = function(world)
    world:add("walls", static(300, 0, 16, 300))
    local lower = world:add("boxes", wide(0, 284, 100, 16, { friction = 0.5 }))
    local upper = world:add("boxes", newBox(40, 268, { friction = 0.5 }))
    world:add("tables", static(100, 200, 100, 10))
    local slider = world:add("boxes", newBox(140, 184, { friction = 0.5 }))
    local fields = { ax = 400, gravity = 0, friction = 0.5 }
    local climber = world:add("boxes", newBox(284, 100, fields))
    return function(step)
      local speed = step % 20 < 10 and 100 or -100
      lower.vx, upper.vx, climber.vy = speed, -speed, speed
      if step % 20 == 0 then
        slider.vx, slider.vy = step % 40 < 20 and 50 or -50, -50
      end
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

describe("world:update of", function()
  for name, fill in pairs(PARTS) do
    for _, rest in ipairs(name == "a pile" and { true, false } or { true }) do
      it(("%s allocates nothing, with rest = %s"):format(name, tostring(rest)), function()
        local world = physics.newWorld({ gravity = 800, rest = rest })
        world.onBegin, world.onStay, world.onEnd = nothing, nothing, nothing
        world:add("tiles", static(-100, 300, 900, 20, { friction = name ~= "a pile" and 0 or nil }))
        local act = fill(world) or nothing
        local function play(step)
          act(step)
          world:update(1 / 60)
        end
        assert.equal(0, garbage.bytes(play, WARM_UP, MEASURED))
      end)
    end
  end

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
