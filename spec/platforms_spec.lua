--- Moving platforms and belts: `surfaceSpeed`, and what is put elsewhere together with what carries
--- it. (Riding itself is scenarios/06_riding_spec.lua; trains are 22.)

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local unpack = rawget(table, "unpack") or rawget(_G, "unpack")

local SETTLE = 1 / 6 -- s, a whole number of steps at each rate

local solid = scene.maker("tiles", { static = true })
local body = scene.maker("bodies")
local carrier = scene.maker("carriers", { kinematic = true })
local rider = scene.thing("players", { name = "rider", x = 120, y = 376, width = 16, height = 24 })

local UPRIGHT = { shift = { 0, 1 / 3, -1000.1 }, rate = { 60, 30, 144 }, order = variants.ORDERS }

--      +-+  ->
--      | |
--   (o=====o=====o)   60 px/s
describe("surfaceSpeed: a belt", function()
  --- It is along x, so a scene with one is not turned by a quarter.
  local ALONG = { rate = variants.RATES, turn = { 0, 2 } }
  local KINEMATIC = { static = false, kinematic = true }
  local BELT = { name = "platform", x = 0, y = 400, width = 400, height = 8, static = true }
  BELT.surfaceSpeed = 60
  local belt = scene.thing("platforms", BELT)

  --- A row with belts: their speeds point the other way where the scene is turned round.
  local function belted(title, entries, given, rows)
    play.row(title, ALONG, function(values, run)
      local list = type(entries) == "function" and entries(values) or entries
      local turned = {}
      for i, entry in ipairs(list) do
        local speed = entry[2].surfaceSpeed
        local fields = { surfaceSpeed = speed and speed * (run.turn == 2 and -1 or 1) }
        turned[i] = scene.thing(entry[1], entry[2])(fields)
      end
      return turned
    end, given, rows)
  end

  local MOVING = belt({ static = false, kinematic = true, vx = 25, vy = -40 })
  belted("of a moving platform adds to its velocity", { MOVING, rider() }, {
    SETTLE,
    "x, y = rider.x, rider.y",
    { 1, "rider at x + 85 * t, y - 40 * t", "rider still", "rider on platform" },
  })

  local LONG = { belt({ x = -999, width = 2000 }), rider() }
  belted("adds to the {own} px/s of what walks on it", LONG, {
    SETTLE,
    "x = rider.x",
    { 1, keep = "rider.vx = own", "rider at x + (60 + own) * t, 376", "rider.vx ~ own" },
  }, { "own", { 50 }, { -60 }, { 300 } })

  local AT_WALL = { belt(), rider(), solid("wall", 160, 300, 16, 100) }
  belted("presses against a wall without a rattle", AT_WALL, {
    { "listen rider", 1 },
    { 1, "rider at 144, 376", "rider still", "rider touches bottom right" },
    "rider heard 2, 0",
  })

  --   +-+|
  --   | ||       the upper one is held, and rubs on the lower one
  --   +-+
  --  (o=====o
  local HELD = {
    belt({ friction = 0.5 }),
    rider({ friction = 0.8 }),
    rider({ name = "top", y = 352, friction = 0.4 }),
    solid("wall", 160, 300, 16, 76),
  }
  belted("never moves back what rubs on something held", HELD, {
    1.5,
    "x = rider.x",
    { 1, "rider.x >= x - 0.001", "top at 144, 352", "top on rider" },
  })

  local function two(v)
    local next_ = belt({ name = "next", x = 200, surfaceSpeed = v.speed })
    return { belt({ width = 200 }), next_, rider({ friction = 0.5 }) }
  end
  belted("hands over to one at {speed} px/s, with friction", two, {
    2.5,
    "rider on next",
    "x = rider.x",
    { 0.5, "rider.x ~ x + speed * t", "rider still" },
  }, { "speed", { 120 }, { 20 } })

  local SWITCHED = { belt(KINEMATIC), rider({ x = 200 }) }
  belted("that is switched round and off moves so", SWITCHED, {
    0.5,
    "platform.surfaceSpeed, x = -platform.surfaceSpeed, rider.x",
    { 0.5, "rider.x ~ x - 60 * t", "rider still" },
    "platform.surfaceSpeed, x = 0, rider.x",
    { 0.5, "rider.x ~ x", "rider still" },
  })
end)

--   | man |            | man |
--   =======  v  ...    =======     both are written elsewhere in the same frame
-- The man fell behind, and a contact ended that was never broken.
describe("x and y: what is put elsewhere together with what carries it", function()
  local SPEEDS, WAYS = { { 0, 240 }, { 0, -120 }, { 100, 0 }, { -60, 30 }, { 0, 0 } }, {}
  for _, speed in ipairs(SPEEDS) do
    for _, way in ipairs({ { 0, -480 }, { 700, 0 }, { -2000.5, 333.25 }, { 3, 0 } }) do
      WAYS[#WAYS + 1] = { speed[1], speed[2], way[1], way[2] }
    end
  end
  local JUMP = {
    "car.x, car.y, crate.x, crate.y = car.x + dx, car.y + dy, crate.x + dx, crate.y + dy",
    "man.x, man.y, low, high = man.x + dx, man.y + dy, crate.x - car.x, man.x + dx - crate.x",
    "world:refresh(car.raw)",
    {
      0.5,
      "car.y - crate.y ~ 32",
      "crate.y - man.y ~ 24",
      "crate.x - car.x ~ low",
      "man.x - crate.x ~ high",
      "crate.touching.bottom == car",
      "man.touching.bottom == crate",
    },
  }
  play.row("goes on riding: a carrier of {vx}, {vy} px/s, by {dx}, {dy} px", UPRIGHT, function(v)
    return {
      carrier("car", 0, 400, 100, 16, { vx = v.vx, vy = v.vy }),
      body("crate", 20, 368, 32, 32),
      body("man", 24, 344, 16, 24),
    }
  end, {
    "log = run:listenToWorld()",
    SETTLE,
    JUMP,
    JUMP,
    JUMP,
    "log.ends == 0; log.begins == 2",
  }, { "vx, vy, dx, dy", unpack(WAYS) })

  -- It fell beside the lift for two dozen updates.
  local RIDES = {}
  for n, speed in ipairs({ { 0, 30 }, { 0, 60 }, { 0, 200 }, { 0, 400 }, { 40, 120 } }) do
    RIDES[2 * n - 1] = { "written", speed[1], speed[2] }
    RIDES[2 * n] = { "added", speed[1], speed[2] }
  end
  local title = "is taken along from the second update on if {how}, by a lift at {vx}, {vy} px/s"
  play.row(title, UPRIGHT, function(v)
    local lift = carrier("lift", 100, 0, 64, 8, { vx = v.vx, vy = v.vy })
    return { lift, v.how == "written" and body("man", -400, -500, 16, 24) or nil }
  end, {
    { steps = 1 },
    function(run, it)
      local man = it.man or run:add(unpack(body("man", 0, 0, 16, 24)))
      man.x, man.y, man.vy = it.lift.x + 20, it.lift.y - 24, 0
    end,
    { steps = 2 },
    "x = man.x - lift.x",
    { 1, "lift.y - man.y ~ 24", "man.x - lift.x ~ x", "man.touching.bottom == lift" },
  }, { "how, vx, vy", unpack(RIDES) })
end)
