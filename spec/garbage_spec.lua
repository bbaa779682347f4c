--- In a steady scene an update allocates nothing: no pause of the garbage collector in a game.

local garbage = require("spec.support.garbage")
local newBox = require("spec.support.box")
local physics = require("physics")

local WARM_UP, MEASURED = 600, 100

-- Bytes that MEASURED updates allocate.
local function bytesOf(world, play)
  local function step(n)
    play(n)
    world:update(1 / 60)
  end
  return garbage.bytes(step, WARM_UP, MEASURED)
end

local function nothing() end

local function pile(settings)
  local world = physics.newWorld(settings)
  world:add("tiles", { x = 0, y = 300, width = 500, height = 20, static = true })
  for i = 0, 59 do
    local x, y = (i % 20) * 22, 280 - 20 * math.floor(i / 20)
    world:add("boxes", { x = x, y = y, width = 16, height = 16, friction = 0.3 })
  end
  return world, nothing
end

local function gas()
  local world = physics.newWorld({ gravity = 0 })
  for _, wall in ipairs({
    { -50, -50, 700, 50 },
    { -50, 400, 700, 50 },
    { -50, 0, 50, 400 },
    { 600, 0, 50, 400 },
  }) do
    world:add(
      "walls",
      { x = wall[1], y = wall[2], width = wall[3], height = wall[4], static = true }
    )
  end
  for i = 0, 3 do
    local ball = { x = 140 * i, y = 90 * i, width = 10, height = 10, restitution = 1 }
    ball.vx, ball.vy = 120, 0
    world:add("balls", ball)
  end
  return world, nothing
end

-- A walker to and fro over tiles, a lift with a rider, and an object with every callback.
local function level()
  local world = physics.newWorld({ gravity = 800, timestep = 1 / 60 })
  for i = 0, 59 do
    world:add("tiles", { x = 16 * i, y = 300, width = 16, height = 16, static = true })
  end
  local walker = world:add("players", { x = 100, y = 276, width = 14, height = 24 })
  local lift = world:add("lifts", { x = 200, y = 200, width = 60, height = 8, kinematic = true })
  world:add("players", { x = 210, y = 176, width = 14, height = 24 })
  world.onBegin, world.onStay, world.onEnd = nothing, nothing, nothing
  return world,
    function(step)
      walker.vx = step % 50 < 25 and 100 or -100
      lift.vx = step % 60 < 30 and 60 or -60
    end
end

local function withFloor()
  local world = physics.newWorld({ gravity = 800 })
  world:add("tiles", { x = 0, y = 300, width = 500, height = 20, static = true, friction = 0 })
  return world
end

-- A walker to and fro between two walls.
local function sensors()
  local world = withFloor()
  world:add("walls", { x = 84, y = 200, width = 16, height = 100, static = true })
  world:add("walls", { x = 200, y = 200, width = 16, height = 100, static = true })
  local walker = world:add("players", newBox(100, 284))
  for i = 0, 3 do
    local zone = { x = 117 + 12 * i, y = 200, width = 5 + 5 * i, height = 100 }
    zone.static, zone.sensor, zone.onBegin, zone.onEnd = true, true, nothing, nothing
    world:add("zones", zone)
  end
  return world, function(step)
    walker.vx = step % 40 < 20 and 500 or -500
  end
end

-- Two objects and a world with `canCollide`; nothing collides with the third object.
local function questions()
  local world = withFloor()
  local function answer(one, other)
    return one.width ~= 17 and other.width ~= 17
  end
  local walker = world:add("players", newBox(100, 284, { canCollide = answer }))
  world:add("boxes", newBox(100, 268, { canCollide = answer }))
  world:add("boxes", newBox(130, 284, { width = 17, gravity = 0 }))
  world.canCollide = answer
  return world, function(step)
    walker.vx = step % 40 < 20 and 120 or -120
  end
end

-- Jumps again and again past the edge of a ledge, and walks back to the step below it.
local function corners()
  local world = withFloor()
  world:add("tiles", { x = 116, y = 280, width = 16, height = 20, static = true })
  world:add("ledges", { x = 112, y = 240, width = 50, height = 8, static = true })
  local jumper = world:add("players", newBox(100, 284, { nudge = 6 }))
  return world,
    function(step)
      jumper.vx = step % 50 > 40 and 300 or 0
      if step % 50 == 0 then
        jumper.vy = -250
      end
    end
end

-- Two boxes between jaws that close and open.
local function jaws()
  local world = withFloor()
  local left = { x = 60, y = 236, width = 16, height = 64, kinematic = true }
  local right = { x = 124, y = 236, width = 16, height = 64, kinematic = true }
  world:add("jaws", left)
  world:add("jaws", right)
  world:add("boxes", newBox(80, 284, { onCrush = nothing }))
  world:add("boxes", newBox(100, 284, { onCrush = nothing }))
  return world,
    function(step)
      left.vx = step % 100 < 50 and 20 or -20
      right.vx = -left.vx
    end
end

-- Jumps through a ledge from below, stands on it, and falls through it.
local function ledge()
  local world = withFloor()
  world:add("ledges", { x = 0, y = 250, width = 200, height = 8, static = true, oneWay = "top" })
  local jumper = world:add("players", newBox(100, 284))
  return world,
    function(step)
      if step % 100 == 0 then
        jumper.vy = -500
      elseif step % 100 == 70 then
        world:dropThrough(jumper)
      end
    end
end

-- One slides on another that slides, a third hops over a table, a fourth slides along a wall.
local function slides()
  local world = withFloor()
  world:add("walls", { x = 400, y = 0, width = 16, height = 300, static = true })
  local lower = world:add("boxes", newBox(100, 284, { width = 100, friction = 0.5 }))
  local upper = world:add("boxes", newBox(140, 268, { friction = 0.5 }))
  world:add("tables", { x = 200, y = 200, width = 100, height = 10, static = true })
  local slider = world:add("boxes", newBox(240, 184, { friction = 0.5 }))
  local climber = world:add("boxes", newBox(384, 100, { ax = 400, gravity = 0, friction = 0.5 }))
  return world,
    function(step)
      local speed = step % 20 < 10 and 100 or -100
      lower.vx, upper.vx, climber.vy = speed, -speed, speed
      if step % 20 == 0 then
        slider.vx, slider.vy = step % 40 < 20 and 50 or -50, -50
      end
    end
end

-- The game puts one into the floor, and one into another box.
local function overlaps()
  local world = withFloor()
  local deep = world:add("boxes", newBox(100, 284))
  local one = world:add("boxes", newBox(200, 284))
  local other = world:add("boxes", newBox(300, 284, { mass = 3 }))
  return world, function()
    deep.y = 290
    one.x, other.x = 200, 210
  end
end

describe("an update of", function()
  for _, row in ipairs({
    {
      "a pile that is awake",
      function()
        return pile({ gravity = 800, rest = false })
      end,
    },
    {
      "a pile at rest",
      function()
        return pile({ gravity = 800 })
      end,
    },
    { "bouncing balls", gas },
    { "a level with a walker, a lift and callbacks", level },
    { "a walker through sensors", sensors },
    { "boxes that ask whether they collide", questions },
    { "a jumper with `nudge`", corners },
    { "boxes that are crushed again and again", jaws },
    { "a jumper through a one-way ledge", ledge },
    { "boxes that rub each other and a wall", slides },
    { "boxes that are put inside others", overlaps },
  }) do
    it(row[1] .. " allocates nothing", function()
      local world, play = row[2]()
      assert.equal(0, bytesOf(world, play))
    end)
  end

  -- Each is written to once: the same text made twice would be one.
  it("an object that the game places, sizes and filters again allocates no text either", function()
    local world, lifts, boxes, count = physics.newWorld({ gravity = 800 }), {}, {}, 0
    for i = 1, 90 do
      local lift = { x = 100 * i, y = 50, width = 60, height = 8, kinematic = true }
      local box = { x = 100 * i + 10, y = 34, width = 16, height = 16 }
      lifts[i], boxes[i] = world:add("lifts", lift), world:add("boxes", box)
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
