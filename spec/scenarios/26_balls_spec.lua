--- Balls: circles that are no sensors.

local effort = require("spec.support.effort")
local overlap = require("spec.support.overlap")
local physics = require("physics")
local small = require("spec.support.small")
local yielding = require("physics.narrowphase.yielding")

local ball, run, tile = small.ball, small.play, small.tile

local long = effort.isFirst and it or pending

local RATES = { 30, 60, 144, 240 }
-- px/s: a corner is met 2e-9 of a step later than a face, so its normal is a little another one.
local LATER = 1e-6

local function near(expected, value, tolerance)
  assert.near(expected, value, tolerance or 1e-9)
end

describe("radius: a ball", function()
  it("moves and collides as its square does where it meets faces only", function()
    local worlds = {}
    for n = 1, 2 do
      local world = physics.newWorld({ gravity = 700 })
      world:setBounds(0, 0, 300, 200)
      local object = ball(60, 60, 10, { vx = 130, restitution = 0.7, friction = 0.2 })
      if n == 2 then
        object.radius, object.width, object.height = nil, 20, 20
      end
      world:add("balls", object)
      worlds[n] = world
    end
    for _ = 1, 300 do
      local one, other = worlds[1].objects.balls[1], worlds[2].objects.balls[1]
      worlds[1]:update(1 / 60)
      worlds[2]:update(1 / 60)
      near(other.x, one.x)
      near(other.y, one.y)
      near(other.vy, one.vy)
    end
  end)

  -- Corner at (100, 100) of a box to the right and below; the ball's radius is 10.
  --
  --      o ->      The normal is (-0.6, -0.8): the ball's centre is at (94, 92).
  --        \ +----
  --          |
  local cases = small.cross(RATES, { 0, 300, -90 })
  small.rows("bounces along the normal off a corner: {2} px/s, {1} Hz", cases, function(rate, speed)
    local world = physics.newWorld({ gravity = 0 })
    world:add("walls", small.put(100, 100, 50, 50, { kinematic = true, vx = speed }))
    local fields = { vx = 200 + speed, restitution = 1 }
    local object = world:add("balls", ball(54, 92, 10, fields))
    run(world, 1, rate)
    -- v - 2 n (n v) = (200, 0) - 2 (-0.6, -0.8) (-120); it is there after 0.2 s.
    near(56 + speed, object.vx, LATER)
    near(-192, object.vy, LATER)
    near(94 + 0.8 * 56 - 10 + speed, object.x, 1e-6)
    near(92 - 0.8 * 192 - 10, object.y, 1e-6)
  end)

  -- It touches as the step begins: that is no contact which holds. Gravity adds 10 px/s.
  local bounces = { { 0, 5, 5, 190 / math.sqrt(2) }, { 1, 90, -80, 180 / math.sqrt(2) } }
  small.rows(
    "meets a stone that it touches slanted, restitution {1}",
    bounces,
    function(e, vx, vy, u)
      local world, side = physics.newWorld({ gravity = 600 }), 10 * math.sqrt(2)
      world:add("stones", ball(0, 0, 10, { static = true }))
      local object = ball(side, -side, 10, { vx = -90, vy = 90, restitution = e })
      world:add("balls", object)
      function object.onBegin(self, _, _, speed)
        self.speed = speed
      end
      world:update(1 / 60)
      near(vx, object.vx)
      near(vy, object.vy)
      near(u, object.speed)
    end
  )

  -- 0.002 of their size do not show, and of what is more one half goes in a step.
  local depths = { { 0.01, 0.01 }, { 0.05, 0.045 } }
  small.rows("in another by {1} px is {2} px in it later", depths, function(deep, after)
    local world, way = physics.newWorld({ gravity = 0 }), (20 - deep) * math.sqrt(0.5)
    local one, other = ball(0, 0, 10), ball(way, -way, 10)
    world.objects.balls = { one, other }
    world:update(1 / 60)
    near(20 - after, math.sqrt((other.x - one.x) ^ 2 + (other.y - one.y) ^ 2))
  end)

  it("is pushed through no wall by a fast heavy box and other balls", function()
    local world = physics.newWorld({ gravity = 0 })
    world:add("walls", tile(300, -1000, 40, 2000))
    local fields = { vx = 20000, mass = 1e5, restitution = 0.8 }
    world:add("boxes", small.put(100, 84, 36, 36, fields))
    world:add("balls", ball(291, 91.55, 9, { restitution = 1 }))
    world:add("balls", ball(280.24, 114.53, 5))
    local last = world:add("balls", ball(275.3, 98.82, 3, { restitution = 1 }))
    run(world, 0.1, 60)
    assert.is_true(last.x < 294.01)
  end)

  it("flies through no corner and no thin wall, at 20 000 px/s", function()
    for n = 0, 40 do
      local world = physics.newWorld({ gravity = 0 })
      world:add("walls", tile(200, 0, 1, 400))
      world:add("walls", tile(200, 400, 300, 1))
      local object = world:add("balls", ball(50, 180 + 6 * n, 8, { vx = 20000, restitution = 1 }))
      run(world, 0.1)
      local x, y = object.x + 8, object.y + 8
      assert.is_true(x < 200 or y > 401 + 8 - 1e-6, n)
    end
  end)

  -- Tiles of 16 px side by side, and one that stands 8 px higher at the end.
  long("rolls over no seam: a row of tiles is as smooth as one", function()
    for _, offset in ipairs({ 0, 1 / 3, -1000.1, 100000.3 }) do
      for _, rate in ipairs(RATES) do
        for _, radius in ipairs({ 3, 8, 20 }) do
          local world = physics.newWorld({ gravity = 800 })
          for i = 0, 39 do
            world:add("tiles", tile(offset + 16 * i, 100, 16, 16))
          end
          local object = world:add("balls", ball(offset + 30, 100 - radius, radius, { vx = 180 }))
          object.restitution = 0.8
          for _ = 1, 2 * rate do
            world:update(1 / rate)
            assert.are.equal(180, object.vx)
            near(100, object.y + object.height, 1e-6)
            assert.is_truthy(object.touching.bottom)
          end
          near(offset + 30 + 360 - radius, object.x, 1e-5)
        end
      end
    end
  end)

  small.rows("falls on a seam as on a face: {1}", { 0, 1e-7, 1e-3, 0.2, 3 }, function(off)
    local world = physics.newWorld({ gravity = 0 })
    world:add("tiles", tile(0, 100, 50, 20))
    world:add("tiles", tile(50, 100, 50, 20))
    local object =
      world:add("balls", ball(50 - off, 50, 10, { vx = 30, vy = 300, restitution = 1 }))
    run(world, 0.25)
    near(30, object.vx, 1e-3)
    near(-300, object.vy, 1e-3)
  end)

  -- A box in a niche of walls; a ball on the floor below is pressed slanted against its corner.
  --
  --      ########
  --      #|   |
  --      #+---+o <-     (`degrees`: of the normal, which leads from the corner to the ball)
  --      ##########
  small.rows("stays at a corner, pressed there at {1} degrees", { 15, 45, 75 }, function(degrees)
    for n = 1, 12 do
      local x, y = 46 + 8 * math.cos(math.rad(degrees)), 46 + 8 * math.sin(math.rad(degrees))
      local world = physics.newWorld({ gravity = 0 })
      world:add("walls", tile(0, 0, 30, 100))
      world:add("walls", tile(30, 0, 100, 30))
      world:add("walls", tile(30, y + 8, 100, 20))
      world:add("boxes", small.box(30, 30))
      local object = world:add("balls", ball(x, y, 8))
      for _ = 1, 4 do
        object.vx = -60 * n
        world:update(1 / 60)
        near(x - 8, object.x, 0.5) -- (what is struck by less is left to its weight)
      end
    end
  end)

  it("rests on the floor, carries, is carried, and sleeps", function()
    local world = physics.newWorld({ gravity = 800 })
    local lift = world:add("lifts", tile(0, 200, 300, 10, { kinematic = true, vx = 40 }))
    lift.static = nil
    local one = world:add("balls", ball(50, 150, 10, { friction = 1 }))
    local plank = world:add("planks", { x = 40, y = 100, width = 20, height = 8 })
    local top = world:add("balls", ball(50, 80, 6))
    run(world, 2)
    near(80, one.x - 0, 45)
    near(180, one.y)
    near(172, plank.y)
    near(160, top.y)
    assert.are.equal(one, plank.touching.bottom)
    local x = top.x
    run(world, 0.5)
    near(x + 20, top.x)
    lift.vx = 0
    run(world, 0.5)
    assert.are.equal(4, world.stats.resting)
  end)

  -- 30 px from centre to centre; 18 px across, 24 px up.
  small.rows("rolls off a ball or a stone: {1}", { true, false }, function(isStatic)
    for _, row in ipairs({ { 18, 24.1 }, { 18, 44 } }) do
      local world = physics.newWorld({ gravity = 800 })
      world:add("floors", tile(0, 120, 200, 10))
      world:add("stones", ball(100, 100, 20, { static = isStatic, mass = 1000, friction = 1 }))
      local object = world:add("balls", ball(100 + row[1], 100 - row[2], 10))
      run(world, 1)
      assert.is_true(object.y > 76)
      assert.is_true(object.vx > 0)
    end
  end)

  -- Its places at the ends of steps are on tangents, up to 0.05 px beside the stone.
  it("touches a stone once, with one onBegin, while the game drives it around that", function()
    local world, begins, ends = physics.newWorld({ gravity = 0 }), 0, 0
    world:add("stones", ball(0, 0, 60, { static = true }))
    local object = world:add("balls", ball(-92, -6, 8))
    function world.onBegin()
      begins = begins + 1
    end
    function world.onEnd()
      ends = ends + 1
    end
    for _ = 1, 240 do
      object.vx = 80
      world:update(1 / 60)
    end
    assert.is_true(object.y < -80)
    assert.same({ 1, 1 }, { begins, ends })
  end)

  it("comes no deeper into a stone that it is 0.03 px in, driven along that", function()
    local world, angle = physics.newWorld({ gravity = 0 }), math.rad(70)
    local stone = world:add("stones", ball(0, 0, 60, { static = true }))
    local x, y = 67.97 * math.cos(angle), 67.97 * math.sin(angle)
    local object = world:add("balls", ball(-x, -y, 8))
    small.run(world, 10, 60, function()
      object.vx, object.vy = 80, 0
      assert.is_true(overlap.depth(object, stone) < 0.03)
    end)
  end)

  it("meets a stone and a lift whether or not another one leans on the stone", function()
    local function meet(hasOther)
      local world = physics.newWorld({ gravity = 800 })
      world:add("stones", ball(150, 180, 20, { static = true }))
      world:add("lifts", small.put(66.3, 129.2, 60, 12, { kinematic = true, vy = 75 }))
      local object = world:add("balls", ball(136.578, 149.851, 13, { vx = -86, vy = 37 }))
      world:add("balls", ball(hasOther and 175.6 or 300, 160.8, 12))
      world:update(1 / 144)
      return object.x
    end
    assert.equal(meet(false), meet(true))
  end)

  it("beside a stone makes way for a box that leaves the floor by a hair", function()
    local world = physics.newWorld({ gravity = 800 })
    world:add("floors", tile(70, 193.999, 80, 80))
    world:add("stones", ball(41, 185, 20, { static = true }))
    world:add("balls", ball(74.5, 167.5, 15.5))
    local object = world:add("boxes", small.put(74, 183, 11, 11))
    world:update(1 / 60)
    assert.equal(74, object.x) -- 90 when the ball counted as being in the stone, as boxes do
  end)

  it("is what world:move and world:sweep see", function()
    local world = physics.newWorld({ gravity = 0 })
    world:add("stones", ball(100, 100, 20, { static = true }))
    local object = world:add("balls", ball(50, 88, 10))
    local other, x, y, nx, ny, fraction = world:sweep(object, 100, 0)
    -- 30 px from centre to centre, 12 px up.
    local across = math.sqrt(900 - 144)
    assert.are.equal(world.objects.stones[1], other)
    near(100 - across - 10, x, 1e-6)
    near(78, y)
    near(-across / 30, nx, 1e-6)
    near(-0.4, ny, 1e-6)
    near((50 - across) / 100, fraction, 1e-6)
    assert.is_nil((world:sweep(object, 0, -100)))
    local toX, toY, hits, count = world:move(object, object.x + 60, object.y)
    assert.are.equal(1, count)
    near(-0.4, hits[1].ny, 1e-6)
    assert.is_true(toX > 62 and toY < 78) -- along the tangent
    assert.are.equal(0, select(2, world:overlapping(object)))
    object.x, object.y = 40, 78
    toX, toY = world:move(object, 100, 78, "touch")
    near(100 - across - 10, toX, 1e-6)
    near(78, toY, 1e-6)
    object.x, object.y = 40, 78
    toX, toY = world:move(object, 100, 78, "bounce")
    local left = 10 + across -- of the way, behind the hit
    local into = left * across / 30
    near(90 - across + left - 2 * into * across / 30, toX, 1e-5)
    near(78 - 2 * into * 0.4, toY, 1e-5)
  end)
end)

it("radius and pushable: two balls without do not push each other, met slanted", function()
  for _, offset in ipairs({ 0, 4, 8, 12, 16 }) do
    local world = physics.newWorld({ gravity = 0 })
    local one = world:add("players", ball(10, 10, 10, { pushable = false }))
    local other = world:add("others", ball(50, 10 + offset, 10, { pushable = false }))
    for _ = 1, 60 do
      one.vx = 100
      world:update(1 / 60)
      near(40, other.x)
      near(offset, other.y)
      local x, y = other.x - one.x, other.y - one.y
      assert.is_true(math.sqrt(x * x + y * y) >= 20 - 1e-6)
    end
  end
end)

describe("radius and pushable: a ball that cannot be pushed", function()
  small.rows("slides around a {1} as others do", {
    { "round pillar", { x = 30, y = 0, width = 64, height = 64, radius = 32, static = true } },
    { "round lift", { x = 30, y = 0, width = 64, height = 64, radius = 32, kinematic = true } },
    { "corner", { x = 50, y = 0, width = 64, height = 64, static = true } },
    { "slope", { x = 0, y = 0, width = 90, height = 45, slope = "topright", static = true } },
  }, function(_, wall)
    local places = {}
    for n, pushable in ipairs({ true, false }) do
      local world = physics.newWorld({ gravity = 0 })
      local one = { x = 0, y = 110, width = 60, height = 60, radius = 30, pushable = pushable }
      local copy = {}
      small.set(copy, wall)
      world:add("walls", copy)
      world:add("bosses", one)
      for _ = 1, 180 do
        one.vx, one.vy = 0, -60
        world:update(1 / 60)
      end
      places[n] = one
    end
    assert.is_true(places[2].y < 4, places[2].y)
    assert.same({ places[1].x, places[1].y }, { places[2].x, places[2].y })
  end)

  -- It falls at 277 px/s. An exact wedge of 1 : 64 would shoot out the lower one at 18 000 px/s.
  small.rows("presses a ball aside without a shot, {1} px off", { 0.25, 1, 4, 6 }, function(offset)
    local world = physics.newWorld({ gravity = 800 })
    world:add("walls", tile(-500, 100, 1000, 20))
    local lower = world:add("balls", ball(0, 92, 8))
    local upper = world:add("stones", ball(offset, 28, 8, { pushable = false }))
    for _ = 1, 60 do
      world:update(1 / 60)
      assert.is_true(math.abs(lower.vx) < 4 * 277, lower.vx)
      local x, y = lower.x - upper.x, lower.y - upper.y
      assert.is_true(math.sqrt(x * x + y * y) > 14)
    end
    near(84, upper.y)
  end)
end)

-- Balls on a lift in an open shaft, which rises at full speed: none is in it, and none passes it.
describe("radius and kinematic: balls in a heap", function()
  local cases = small.cross({ { "lift", 30, 300, 14 }, { "slope", 12, 110, 55 } }, { 30, 60, 144 })
  local title = "stay on a {1} that rises at 900 px/s, at {5} Hz"
  small.rows(title, cases, function(name, count, width, height, rate)
    local slope = name == "slope" and "right" or nil
    local world, deepest = physics.newWorld({ gravity = 900 }), 0
    world:add("walls", tile(-150, -9000, 150, 9500))
    world:add("walls", tile(width, -9000, 150, 9500))
    local fields = { kinematic = true, slope = slope }
    local lift = world:add("lifts", small.put(0, 300, width, height, fields))
    for i = 1, count do
      local x = 10 + (i * 37) % (width - 20)
      world:add("balls", ball(x, 290 - 20 * i, 8, { restitution = 0.6 }))
    end
    for step = 1, effort.share(10, 3) * rate do
      local goal = step % rate < rate / 5 and 255 or 300
      local most = goal < lift.y and 900 / rate or 250 / rate
      lift.y = lift.y + math.max(-most, math.min(goal - lift.y, most))
      world:update(1 / rate)
      for _, one in ipairs(world.objects.balls) do
        deepest = math.max(deepest, one.y + 8 - lift.y - height)
        if not slope then
          deepest = math.max(deepest, one.y + 16 - lift.y)
        end
      end
    end
    near(0, math.max(deepest, 0), 0.01)
  end)
end)

-- A cue ball at 1500 px/s, and a triangle of so many columns of balls that touch each other.
--
--         o        Mirror images leave alike, however the scene is turned.
--   o->  o o
--         o
small.rows(
  "radius and restitution: a flush rack of {1} columns breaks evenly: {2} Hz, turned by {3}",
  small.cross(small.cross({ 2, 3, 4, 5 }, { 30, 60, 144 }), { 0, 30, 50 }),
  function(columns, rate, degrees)
    local world, energy = physics.newWorld({ gravity = 0 }), 0
    local c, s = math.cos(math.rad(degrees)), math.sin(math.rad(degrees))
    local function put(x, y, speed)
      local fields = { restitution = 1, vx = c * speed, vy = s * speed }
      return world:add("balls", ball(c * x - s * y, s * x + c * y, 14, fields))
    end
    local rack = {}
    put(-200, 0, 1500)
    for column = 0, columns - 1 do
      for n = 0, column do
        rack[#rack + 1] = { put(column * 14 * math.sqrt(3), (2 * n - column) * 14, 0) }
        rack[#rack].mirror = #rack - n + column - n
      end
    end
    run(world, 1, rate)
    for _, one in ipairs(world.objects.balls) do
      energy = energy + (one.vx * one.vx + one.vy * one.vy) / (1500 * 1500)
    end
    near(1, energy)
    for _, row in ipairs(rack) do
      local one, other = row[1], rack[row.mirror][1]
      near(c * one.vx + s * one.vy, c * other.vx + s * other.vy, LATER)
      near(c * one.vy - s * one.vx, s * other.vx - c * other.vy, LATER)
    end
    if columns == 2 then -- the normals are at 30 degrees, so each ball gets 0.6 * 1500 along x
      near(900, c * rack[2][1].vx + s * rack[2][1].vy, LATER)
    end
  end
)

small.rows(
  "radius and restitution: a row of {1} balls keeps the energy of a heavier cue: {2} Hz",
  small.cross({ 10, 14 }, { 30, 60, 144 }),
  function(count, rate)
    local world, energy = physics.newWorld({ gravity = 0 }), 0
    world:add("balls", ball(-20, 0, 5, { restitution = 1, vx = 1500, mass = 2 }))
    for n = 1, count do
      world:add("balls", ball(10 * n, 0, 5, { restitution = 1 }))
    end
    run(world, 0.5, rate)
    for n, one in ipairs(world.objects.balls) do
      energy = energy + (n == 1 and 2 or 1) * (one.vx * one.vx + one.vy * one.vy)
    end
    assert.near(1, energy / (2 * 1500 * 1500), 1e-4)
  end
)

describe("radius and slope: a marble", function()
  -- It runs down 1:4 at 412 px/s; another one falls onto it, which must not stop it. Along the ramp
  -- (4, 1) gravity gives both as much.
  local struck = small.cross(small.cross({ 30, 60, 144 }, { 0.5, 1, 10 }), { 0, 800 })
  local title = "struck on a ramp keeps its momentum along it, {1} Hz, by {2} kg, gravity {3}"
  small.rows(title, struck, function(rate, mass, gravity)
    for off = 0, 5 do
      local world = physics.newWorld({ gravity = gravity })
      world:add("ramps", tile(0, 200, 800, 200, { slope = "left" }))
      local far, x = 10 * math.sqrt(1.0625), 235 + 7 * off
      local one = world:add("balls", ball(200, 250 - far, 10, { vx = 400, vy = 100 }))
      local other = world:add("balls", ball(x, 150 + x / 4 - far, 10, { vy = 350, mass = mass }))
      run(world, 0.5, rate)
      local along = 4 * (one.vx + mass * other.vx) + one.vy + mass * other.vy
      local pulled = (1 + mass) * gravity * 0.5
      near(1700 + mass * 350 + pulled, along, 0.01 * along)
      assert.is_true(math.max(math.abs(one.vx), math.abs(other.vx)) > 50)
    end
  end)

  it("turns on a ramp below another one: both keep their momentum along it", function()
    local world, up = physics.newWorld({ gravity = 800 }), { mass = 10, vx = -56, vy = -14 }
    world:add("ramps", tile(0, 200, 800, 200, { slope = "left" }))
    local x, y = 400, 300 - 10 * math.sqrt(1.0625)
    local one = world:add("balls", ball(x, y, 10, up))
    local other = world:add("balls", ball(x - 2.078, y - 19.892, 10, up))
    run(world, 0.4, 30)
    local along = 4 * (one.vx + other.vx) + one.vy + other.vy
    near(-2 * (4 * 56 + 14) + 2 * 0.4 * 800, along, 1)
  end)

  small.rows("rolls down a ramp alike that moves by {1} px/s", { 0, -32, 32 }, function(speed)
    local world, air = physics.newWorld({ gravity = 900 }), 0
    local fields = { slope = "left", kinematic = true, vy = speed }
    world:add("ramps", small.put(-100, 200, 600, 300, fields))
    local one = world:add("balls", ball(48, 158, 8, { vx = 30, vy = speed, restitution = 0.3 }))
    small.run(world, 90, 60, function(n)
      air = air + ((n <= 54 or one.touching.bottom) and 0 or 1)
    end)
    near(438.25, one.x, 0.02)
    assert.equal(0, air)
  end)

  small.rows("is in no hero that runs up to it from {1} px on", { 164, 172, 188 }, function(x)
    local world, balls, deepest = physics.newWorld({ gravity = 900 }), {}, 0
    world:add("ramps", tile(300, 300, 300, 100, { slope = "right" }))
    world:add("ramps", tile(-400, 400, 1600, 40))
    local hero = world:add("heroes", small.put(x, 370, 24, 30, { vx = 220 }))
    for n = 1, 4 do
      local fields = { restitution = 0.6 }
      balls[n] = world:add("balls", ball(329 + 53 * n, 109 + 3 * n, 9 + 3 * n, fields))
    end
    small.run(world, 200, 60, function(step)
      hero.vx = step < 100 and 220 or -220
      for n = 1, 4 do
        deepest = math.max(deepest, overlap.depth(hero, balls[n]))
      end
    end)
    near(0, deepest, 0.1)
  end)
end)

it("radius, strength and mass: a player pulls nothing that leaves it", function()
  for n = 1, 50 do
    local v = 80 + n / 7
    for ulps = -2, 2 do
      local strong, weak = yielding.share(true, 1 / 3, n / 9, v, v + ulps * 2 ^ -46)
      assert.near(0.6 / n, strong / weak, 1e-12)
    end
  end
end)

--    [pillar]
--      <-(_)       Both go to the left, a hair in each other: nothing holds one of them.
--     <-(_)
--    _________
it("radius and restitution: two that go under a pillar are not crushed", function()
  local world, told = physics.newWorld({ gravity = 0 }), 0
  world:add("walls", tile(0, 49, 14, 14))
  world:add("walls", tile(-150, 100, 300, 20))
  world:add("balls", ball(10.444, 73, 10, { vx = -60, restitution = 0.5 }))
  world:add("balls", ball(4.367, 91, 9, { vx = -58, restitution = 0.5, mass = 3 }))
  function world.onCrush()
    told = told + 1
  end
  world:update(1 / 30)
  assert.equal(0, told)
end)

--     [ enemy ][P]       P presses an enemy onto the stone, others come from the left. The enemy
--    (enemy)[ enemy ]    has room only where it comes from.
--                 (stone)
it("radius and strength: what has no room between player and stone does not shoot out", function()
  local world, list = physics.newWorld({ gravity = 0 }), {}
  world:add("pillars", tile(32, 61, 20, 20, { radius = 10 }))
  list[1] = world:add("boxes", small.put(9, 2.6, 20, 20))
  list[2] = world:add("boxes", small.put(19.2, 41.3, 20, 20))
  list[3] = world:add("boxes", ball(14.2, 32.6, 10))
  list[4] = world:add("players", small.put(24.4, 25.3, 16, 16, { strength = 1 }))
  for _ = 1, 3 do
    for n, row in ipairs({ { 50, 74 }, { 28, -84 }, { 88, 12 }, { 0, 80 } }) do
      list[n].vx, list[n].vy = row[1], row[2]
    end
    world:update(1 / 120)
    for _, one in ipairs(list) do -- (600 px/s)
      assert.is_true(one.vx * one.vx + one.vy * one.vy < 150 * 150, one.vx .. ", " .. one.vy)
    end
  end
end)

--    [ram]->  (_)(_)(_)
it("radius: a fast ram pushes three balls, and none of them into another", function()
  for n = 0, 19 do
    local world, list = physics.newWorld({ gravity = 0 }), {}
    world:add("rams", small.put(0, 100, 40, 40, { kinematic = true, vx = 2000 }))
    for m = 1, 3 do
      list[m] = world:add("balls", ball(68 + 17 * m, 97 + 2 * n + 3 * m, 8))
    end
    for _ = 1, 30 do
      world:update(1 / 60)
      assert.is_true(overlap.depth(list[1], list[2]) < 0.01)
      assert.is_true(overlap.depth(list[2], list[3]) < 0.01)
    end
  end
end)

--   _______________
--   '-.     kinematic, down
--   .-'-(_)-----        The two faces meet far away on the left: the nearest place in front of both
--   |     '-.___        is there.
it("radius: a ball is not put where the faces of a vice meet", function()
  local world = physics.newWorld({ gravity = 0 })
  world:add("jaws", tile(0, 300, 300, 30, { slope = "left" }))
  local jaw = { x = 0, y = 200, width = 300, height = 37, slope = "topright", vy = 60 }
  jaw.kinematic = true
  world:add("jaws", jaw)
  local one = world:add("balls", { x = 140, y = 270, radius = 8 })
  local x, y = one.x, one.y
  for _ = 1, 180 do
    world:update(1 / 60)
    near(x, one.x, 15)
    near(y, one.y, 25)
    x, y = one.x, one.y
  end
end)

-- A ball hung on a light one beside it, while its speed grew to 12000 px/s.
it(
  "mass: heavy balls between light ones lie on the floor after a while, without a speed",
  function()
    local world = physics.newWorld({ gravity = 600 })
    world:add("floors", tile(-60, 300, 420, 60))
    local list = {}
    for n, row in ipairs({
      { 28.271, 55.518, 8, 0.1 },
      { 10.0803, 16.4597, 12, 10, 0.4 },
      { 34.0996, 36.4128, 8, 0.1 },
      { 40.1039, 25.9058, 5, 10 },
    }) do
      list[n] = world:add(
        "balls",
        { x = row[1], y = row[2], radius = row[3], mass = row[4], restitution = row[5] }
      )
    end
    for _ = 1, 300 do
      world:update(1 / 30)
    end
    for n = 2, 4, 2 do
      assert.same({ 0, 300 }, { list[n].vy, list[n].y + 2 * list[n].radius })
    end
  end
)
