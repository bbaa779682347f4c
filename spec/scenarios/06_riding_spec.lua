--- Riding: platforms, lifts and belts take along what stands on them.

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local SETTLE = 1 / 6 -- s, ten steps at 60 Hz
local row = play.row

local LIFT = small.put(100, 400, 64, 8, { name = "platform", kinematic = true })
local platform = scene.thing("platforms", LIFT)
local rider = scene.thing("players", { name = "rider", x = 120, y = 376, width = 16, height = 24 })

local function tile(name, x, y, width, height, oneWay)
  return { "tiles", small.tile(x, y, width, height, { name = name, oneWay = oneWay }) }
end

local ONE = { platform(), rider() }
local PAIR = { platform(), rider(), rider({ name = "top", y = 352 }) }

describe("kinematic: a platform", function()
  --     +-+
  --     | |
  --   +-----+  ->
  row("(6) takes its rider along at ({vx}, {vy}) px/s", EVERYWHERE, ONE, {
    "listen rider",
    SETTLE,
    "platform.vx, platform.vy = vx, vy",
    {
      1,
      "platform at 100 + vx * t, 400 + vy * t",
      "rider at 120 + vx * t, 376 + vy * t",
      "rider rides platform, 20",
    },
    "rider heard 1, 0",
  }, {
    "vx, vy, levels",
    { 60, 0 },
    { 0, -60 },
    { 0, 60 },
    { 0, 200 },
    { 5000, -5000 },
    { 45, -80, SOME },
    { -130, 170, SOME },
    { -5000, 0, SOME },
  })

  -- What the game writes before each step.
  row("(6) keeps its rider when the game writes {fields} = {x}, {y}", EVERYWHERE, ONE, {
    "listen rider",
    SETTLE,
    { 1, keep = "m = t - dt / 2; {fields} = {x}, {y}", "rider rides platform, 20" },
    "rider heard 1, 0",
  }, {
    "fields, x, y",
    { "platform.vx, platform.vy", "50 * pi * cos(pi * m)", "0" },
    { "platform.vx, platform.vy", "50 * pi * cos(pi * m)", "50 * pi * sin(pi * m)" },
    { "platform.vx, platform.vy", "0", "2400 * m" }, -- faster than gravity
    { "platform.vx, platform.vy", "0", "-2400 * m" },
    { "platform.vx, platform.vy", "0", "m * 4 % 2 < 1 and 300 or 0" },
    { "platform.vx, platform.vy", "0", "m * 4 % 2 < 1 and -600 or 0" },
    { "platform.vx, platform.vy", "0", "n % 2 == 0 and -200 or 200" },
    { "platform.vx, platform.vy", "n % 2 == 0 and -5000 or 5000", "0" },
    { "platform.vx, platform.vy", "n % 2 == 0 and -5000 or 5000", "n % 2 == 0 and 5000 or -5000" },
    { "platform.x, platform.y", "100 + 60 * t", "400" },
    { "platform.x, platform.y", "100", "400 + 200 * t" },
    { "platform.x, platform.y", "100 + 5000 * t", "400 + 5000 * t" },
    { "platform.x, platform.y", "100 + 50 * sin(pi * t)", "400" },
    { "platform.x, platform.y", "100", "400 + 50 * sin(pi * t)" },
    { "platform.x, platform.y", "100", "400 + 1200 * t * t" }, -- faster than gravity
    { "platform.x, platform.y", "100", "400 + 10 * floor(t * 8)" },
  })

  row("that has a velocity, and that the game places, does both", SOME, ONE, {
    SETTLE,
    "platform.vx, platform.vy = 30, 25",
    {
      2,
      keep = "platform.x, platform.y = platform.x + 40 * dt, platform.y - 60 * dt",
      "platform at 100 + 70 * t, 400 - 35 * t",
      "rider rides platform, 20",
    },
  })

  row("that the game places, and then leaves alone, stands still", SOME, ONE, {
    SETTLE,
    { 1, keep = "platform.x = 100 + 60 * t", "rider rides platform, 20" },
    { 1, "rider rides platform, 20", "platform.vx == 0", "platform.x ~ 160" },
  })

  --- A step longer than maxStep is split: the platform is not there at once, but on its way.
  row("maxStep: spreads its way over the parts of a long step", SOME, ONE, {
    SETTLE,
    "platform.x, rider.vy = 106, -400", -- 0.1 s, in three parts
    { "run:step(0.1)", "platform.x ~ 106", "rider at 126, 376 - 40 + 4", "rider.vx ~ 60" },
  })

  local BESIDE = { gravity = 0, platform(), rider({ x = 164, y = 392 }) }
  row("maxStep: pushes as fast in a long step", SOME, BESIDE, {
    { steps = 1 },
    { "platform.x = 112", "run:step(0.1)", "platform.x ~ 112", "rider.vx ~ 120", "rider.x ~ 176" },
  })

  --      +-+
  --      +-++
  --     +-+-+
  --     +-++
  --   +-----+  ->
  local THREE = {
    platform(),
    rider(),
    rider({ name = "second", x = 126, y = 352 }),
    rider({ name = "third", x = 122, y = 328, mass = 50, friction = 0.5 }),
  }
  row("(6) takes three on each other along at ({vx}, {vy}) px/s {turns}", EVERYWHERE, THREE, {
    SETTLE,
    "listen third",
    {
      0.5,
      keep = "s = turns and n % 2 == 0 and -1 or 1; platform.vx, platform.vy = s * vx, s * vy",
      "rider rides platform, 20",
      "second rides rider, 6",
      "third rides second, -4",
    },
    "third heard 0, 0",
  }, {
    "vx, vy, turns",
    { 60, 0 },
    { 0, -200 },
    { 0, 200 },
    { 5000, 5000 },
    { -70, -5000 },
    { 300, 500, "and back" },
  })
end)

describe("kinematic: a rider at a wall", function()
  --                 |  |
  --     +-+         |  |  x = 260
  --     | |         |  |
  --   +-----+ ->    +--+
  local AT_WALL = { platform(), rider(), tile("wall", 260, 300, 16, 100) }
  row("(6) is held back, and falls when the platform has passed", EVERYWHERE, AT_WALL, {
    SETTLE,
    { "listen rider", "platform.vx = 60" },
    { 2, "rider at 120 + 60 * t, 376" },
    { 1 / 2, "rider at min(244, 240 + 60 * t), 376", "rider on platform" },
    "rider.touching.right == wall",
    1 / 6,
    -- it begins to fall in this step or in the next one
    {
      1,
      "rider.x ~ 244",
      "rider.vx ~ 0",
      "rider.y - 376 <= 400 * t * t + 1e-6",
      "rider.y - 376 >= 400 * max(0, t - dt - 1e-9) ^ 2 - 1e-6",
    },
    "rider heard 1, 2",
  })

  --  |w|->+-+
  --  |w|  | |
  --     +-----+   the platform stands
  local wall = { name = "wall", x = 40, y = 300, width = 16, height = 100, kinematic = true }
  row("that moves is pushed off the platform", SOME, { platform(), rider(), { "walls", wall } }, {
    SETTLE,
    "wall.vx = 60",
    { 5 / 3, "rider at max(120, 56 + 60 * t), 376", "platform.x ~ 100" },
    0.5,
    { 1 / 3, "rider.y > 376", "rider.vx ~ 60" },
  })
end)

describe("kinematic: on and off a platform:", function()
  row("(6) a jump straight up at ({vx}, {vy}) px/s keeps that, and ends at rest", SOME, ONE, {
    SETTLE,
    { "listen rider", "platform.vx, platform.vy = vx, vy", 0.5 },
    { "rider.vy = -400", "x, y = rider.x, rider.y" },
    -- in free flight, 400 px/s faster than the lift
    { 5 / 6, "rider at x + vx * t, y + (vy - 400) * t + 400 * t * t", "run:support(rider) == nil" },
    1 / 3,
    { 0.5, "rider rides platform, 20" },
    "rider heard 1, 1",
  }, { "vx, vy, levels", { 60, 0, EVERYWHERE }, { 0, -60 }, { 0, 60 }, { -80, 500 }, { 60, -300 } })

  row("a rider that walks off at {vx} px/s keeps the platform's velocity", SOME, ONE, {
    SETTLE,
    "platform.vx, rider.vx = 60, vx",
    { 1.5, "rider.x ~ 120 + (60 + vx) * t", "rider.vx ~ vx + (run:support(rider) and 0 or 60)" },
    "rider.y > 376",
  }, { "vx", { 200 }, { -200 }, { 61 } })

  -- Own vx before and after the landing on a platform at 60 px/s.
  local function above(v)
    return { platform({ x = 0, width = 400, vx = 60 }), rider({ x = 150, y = 350, vx = v.before }) }
  end
  row("a box that lands with vx = {before} has vx = {after} there", SOME, above, {
    0.5,
    "offset = rider.x - platform.x",
    { 0.5, "rider.x - platform.x ~ offset + after * t", "rider.vx ~ after", "rider on platform" },
  }, { "before, after", { 0, 0 }, { 30, 0 }, { 60, 0 }, { 100, 40 }, { -50, -50 } })

  local function falls(v)
    return { platform({ vy = v.vy }), rider({ y = 340 }) }
  end
  row("a box that lands on a lift at {vy} px/s rides it at once", SOME, falls, {
    "listen rider",
    { 0.5, "run:support(rider) and rider.y + 24 - platform.y or 0 ~ 0" },
    { "rider rides platform, 20", "rider heard 1, 0" },
  }, { "vy", { -60 }, { 60 }, { -1000 } })

  local NEXT =
    { platform(), platform({ name = "next", x = 164, width = 300 }), rider({ vx = 100 }) }
  row("a rider that changes to another one has that one's velocity", SOME, NEXT, {
    SETTLE,
    { "next.vx = 40", 1.5, "rider on next" },
    "rider.vx ~ 60", -- 100, of which 40 were the platform's
  })
end)

describe("kinematic: a rider that is put elsewhere", function()
  -- What the game does to a rider at (145, 226) on a platform at (50, -300) px/s.
  local THERE = "rider.x, rider.y, top.x, top.y = 300, -500, 300, -524"
  row("{how}, falls from rest, and so does its rider", SOME, PAIR, {
    SETTLE,
    { "platform.vx, platform.vy = 50, -300", 0.5 },
    THERE,
    "{does}",
    THERE,
    "top.vx, top.vy = 0, 0",
    { 0.5, "rider at 300, -500 + 400 * t * t", "top at 300, -524 + 400 * t * t", "rider.vx ~ 0" },
    "rider.vy ~ 400",
  }, {
    "how, does",
    { "by x and y", "" },
    { "and refreshed", "world:refresh(rider.raw)" },
    { "taken out and put in", "world:remove(rider.raw); world:add('players', rider.raw)" },
    { "while it is off", "rider.active = false; run:play(0.5); rider.active = true" },
    { "when the platform goes", "world:remove(platform.raw)" },
  })

  row("on what carries it rides on", SOME, { platform({ width = 500 }), rider() }, {
    SETTLE,
    { "platform.vx, platform.vy = 50, -300", 0.5 },
    "rider.x = platform.x + 400",
    { 0.5, "rider rides platform, 400" },
  })
end)

describe("kinematic: when the platform is", function()
  row("{gone}, at ({vx}, {vy}) px/s, the riders keep that", SOME, PAIR, {
    SETTLE,
    { "listen rider", "platform.vx, platform.vy = vx, vy", 1 },
    "{does}",
    {
      0.5,
      "rider at 120 + vx + vx * t, 376 + vy + vy * t + 400 * t * t",
      "top at 120 + vx + vx * t, 352 + vy + vy * t + 400 * t * t",
      "rider.vx ~ vx",
      "rider.vy ~ vy + 800 * t",
      "top.vx ~ vx",
      "run:support(top) == rider",
    },
    "rider heard 0, 1",
  }, {
    "gone, vx, vy, does",
    { "removed", 60, 0, "world:remove(platform.raw)" },
    { "removed", 0, 200, "world:remove(platform.raw)" },
    { "taken out of its table", 0, 200, "world.objects.platforms = nil" },
    { "deactivated", 60, 0, "platform.active = false" },
    { "deactivated", 0, 200, "platform.active = false" },
    { "made a sensor", 60, 0, "platform.sensor = true" },
    { "masked", 0, 200, "platform.mask = { players = false }" },
  })

  row("made dynamic, both fall on side by side", SOME, ONE, {
    SETTLE,
    { "platform.vx = 60", 1 },
    "platform.kinematic = nil",
    {
      0.5,
      "rider at 180 + 60 * t, 376 + 400 * t * t",
      "platform at 160 + 60 * t, 400 + 400 * t * t",
    },
    "rider.vx ~ 60",
  })
end)

describe("x and y: what the game puts on a platform", function()
  local ABOVE = { platform({ x = 0, width = 400, vx = 60 }), rider({ y = 100 }) }
  row("rides from the next step on", SOME, ABOVE, {
    { steps = 1 },
    "rider.x, rider.y, rider.vy = 120, 376, 0",
    { steps = 1, "rider at 120, 376" },
    { 1, "rider at 120 + 60 * t, 376", "rider on platform" },
  })

  local SINKING = { platform({ vy = 60, oneWay = "top" }), rider({ y = 100 }) }
  row("rides a one-way platform that moves away from below it", SOME, SINKING, {
    { steps = 1 },
    "rider.y, rider.vy = platform.y - 24, 0",
    { 1, "rider.y ~ platform.y - 24" },
  })

  local OPEN = { platform({ vy = 60 }), rider({ y = 100, oneWay = "top" }) }
  row("falls through it if it is open below", { 60 }, OPEN, {
    { steps = 1 },
    "rider.y, rider.vy = 377, 0",
    { 1 / 6, "rider.y ~ 377 + 400 * t * t" },
  })
end)

describe("carry = false: a platform", function()
  local function wide(friction, air)
    local body = rider({ friction = friction, airFriction = air })
    return { platform({ x = 0, width = 400, carry = false }), body }
  end

  row("slides away under what stands on it", SOME, wide(0), {
    SETTLE,
    { "listen rider", "platform.vx = 60" },
    { 1, "rider at 120, 376", "rider still" },
    "rider heard 0, 0",
  })

  row("drags what stands on it by friction only, in air {air}", SOME, function(v)
    return wide(0.5, v.air)
  end, {
    SETTLE,
    "platform.vx = 100",
    { 1 / 6, "rider.vx ~ {speed}, 1e-6" },
    0.5,
    "rider.vx ~ 100",
  }, { "air, speed", { 0, "400 * t" }, { 0.5, "800 * (1 - exp(-0.5 * t))" } })

  row("that is switched to it in the run lets its rider slide on beside it", SOME, ONE, {
    SETTLE,
    { "platform.vx = 60", 1 },
    "platform.carry = false",
    { 0.5, "rider.x - platform.x ~ 20", "rider.vx ~ 60", "rider on platform" },
  })
end)

describe("kinematic: with others in the way:", function()
  --     +-+
  --   --| |--   one-way
  --   +-----+
  --      ^
  local WAY = { platform(), rider(), tile("way", 90, 343.3, 100, 8, "top") }
  row("a rider is carried up through a one-way, and back on to it", SOME, WAY, {
    "listen rider",
    SETTLE,
    "platform.vy = -60",
    { 1.5, "rider at 120, 376 - 60 * t", "rider rides platform, 20" },
    "rider heard 1, 0",
    "platform.vy = 60",
    { 2, "rider at 120, min(286 + 60 * t, 319.3)", "rider still" },
    { "rider on way", "rider heard 2, 1" },
  })

  local TILES = scene.tiles({ platform({ x = 72 }), rider() }, 30, 136, 0, 16, 13, 0, 13)
  row("a lift takes its rider past a wall of tiles without a snag", SOME, TILES, {
    { "listen rider", "platform.vy = -100", 1 / 6 },
    {
      2,
      keep = "rider.vx = 100",
      "rider.x ~ 120",
      "rider on platform",
      "rider.touching.top == false",
    },
    "heard.rider.begins > 10",
  })

  -- 90 .. 100 of the rider stands on the floor
  local OVER = { platform({ y = 430.5 }), rider({ x = 90 }), tile("floor", 0, 400, 100, 8) }
  row("a lift that comes up under a box on a floor takes it over", SOME, OVER, {
    SETTLE,
    "platform.vy = -60",
    { 1, "rider at 90, min(376, 406.5 - 60 * t)", "rider still" },
    "rider rides platform, -10",
  })
end)
