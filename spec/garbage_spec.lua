--- In a steady scene an update allocates nothing: no pause of the garbage collector in a game.

local garbage = require("spec.support.garbage")
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

-- A walker to and fro over tiles, a lift with a rider, and somebody who is told of everything.
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
  }) do
    it(row[1] .. " allocates nothing", function()
      local world, play = row[2]()
      assert.equal(0, bytesOf(world, play))
    end)
  end
end)
