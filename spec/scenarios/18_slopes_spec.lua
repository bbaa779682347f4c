--- Slopes behave like stairs with infinitely small steps: P1 to P12 of the contract.
--
-- The hill of most rows, 1:2 up, 1:1 down:
--
--                 336 ____________
--                  /              \
--        _________/                \_________ 400
--       -400     80  208         308 372

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE, RATES = variants.EVERYWHERE, { rate = variants.RATES }
local PUSH = { rate = variants.RATES, turn = variants.TURNS, push = { "both" } }
local BOTH_WAYS = { "way", { 1 }, { -1 } }
local solid = scene.maker("ground", { static = true })
local crate = scene.maker("crates", {})
local body = scene.thing("players", { name = "body", width = 16, height = 24 })

local function slope(x, y, width, height, name, fields)
  local entry = solid("slope", x, y, width, height, fields)
  entry[2].slope = name
  return entry
end

--- The hill, and what else there is.
local function hill(...)
  return {
    solid("flat", -400, 400, 480, 40),
    slope(80, 336, 128, 64, "right"),
    solid("top", 208, 336, 100, 64),
    slope(308, 336, 64, 64, "left"),
    solid("base", 80, 400, 292, 40),
    solid("far", 372, 400, 600, 40),
    ...,
  }
end

-- Where the bottom of a box of 16 px stands on the hill, with its left edge at x.
local function floorAt(x)
  local right = x + 16
  if right <= 80 or x >= 372 then
    return 400
  elseif right < 208 then
    return 400 - (right - 80) * 0.5
  elseif x <= 308 then
    return 336
  end
  return 336 + (x - 308)
end

--- The body on the hill, with its left edge at x, and what else there is.
local function onHill(x, fields, ...)
  local entry = body(fields)
  entry[2].x, entry[2].y = x, floorAt(x) - 24
  return hill(entry, ...)
end

local row = play.with({ floorAt = floorAt })

describe("slope: hills", function()
  local function walker(v)
    return onHill(v.way > 0 and 20 or 420)
  end
  local walks = { "speed, way" }
  for _, speed in ipairs({ 40, 120, 600, 2400 }) do
    walks[#walks + 1], walks[#walks + 2] = { speed, 1 }, { speed, -1 }
  end
  row("(P1 to P5) keep a walker of {speed} px/s on the ground, way {way}", EVERYWHERE, walker, {
    { "listen body", "x = body.x" },
    {
      time = "max(floor(380 / speed * 6) / 6, 1 / 6)",
      keep = "body.vx = way * speed",
      "body at x + way * speed * t, floorAt(body.x) - 24",
      "body.vx == way * speed",
      "body.vy == 0",
      "body touches bottom",
    },
    "heard.body.begins == heard.body.sides.bottom",
  }, walks)

  local CREST = onHill(100, nil, crate("heavy", 207, 320, 16, 16, { mass = 9 }))
  row("(P1) keep down what bumps into a crate on the crest", { rate = { 30, 60 } }, CREST, {
    { 1, keep = "body.vx = 200", "body.y ~ floorAt(body.x) - 24" },
  })

  -- `m`: of the right edge: 44 px flat, 143.1 up, 116 flat, 90.5 down, flat
  local FAIR = onHill(20, { constantSpeed = true })
  row("constantSpeed (P5): they take as long as they are", EVERYWHERE, FAIR, {
    "up, down = sqrt(128 ^ 2 + 64 ^ 2), sqrt(64 ^ 2 * 2)",
    {
      4,
      keep = "body.vx = 120; m = 120 * t",
      "body.x ~ 20 + min(m, 44) + min(max(m - 44, 0), up) * 128 / up"
        .. "+ min(max(m - 44 - up, 0), 116) + min(max(m - 160 - up, 0), down) * 64 / down"
        .. "+ max(m - 160 - up - down, 0)",
      "body.y ~ floorAt(body.x) - 24",
      "body.vx == 120",
      "body touches bottom",
    },
  })

  row("(P3) let a jump at the crest be as high as on the flat", EVERYWHERE, onHill(100), {
    { 2 / 3, keep = "body.vx = 120" }, -- to x = 180
    "body.vy = -300",
    {
      0.5,
      keep = "body.vx = 120",
      "body at 180 + 120 * t, floorAt(180) - 24 - 300 * t + 400 * t * t",
    },
  })

  local ABOVE = hill(body({ x = 120, y = 304 }))
  row("(P4) catch what lands on them", EVERYWHERE, ABOVE, {
    { "listen body", 1, "body at 120, floorAt(120) - 24", "body still", "body touches bottom" },
    { "body heard 1, 0", "heard.body.speed ~ sqrt(1600 * (floorAt(120) - 328))" },
  })

  row("(P4) let a jumper go uphill and downhill, way {way}", EVERYWHERE, onHill(120), {
    0.5,
    "body.vy = -300",
    {
      0.5,
      keep = "body.vx = 60 * way",
      "body at 120 + 60 * way * t, floorAt(120) - 24 - 300 * t + 400 * t * t",
      "body touches",
    },
  }, BOTH_WAYS)

  local function rubbing(v)
    return onHill(130, { friction = 0.5, vx = v.way * 100 })
  end
  row("(P6) let friction brake as on a floor, and hold, way {way}", EVERYWHERE, rubbing, {
    1,
    "body at 130 + way * 12.5, floorAt(130 + way * 12.5) - 24; body still",
  }, BOTH_WAYS)

  local PLAIN = { rate = { 30, 60, 144 }, shift = { 0 } }
  row("(P6) let slide what gets the pull along them, unless friction {mu} holds", PLAIN, function(v)
    local box = body({ x = 600, y = 76, width = 16, height = 16, friction = v.mu })
    return { slope(0, 0, 800, 400, "right"), box }
  end, {
    "function pull(g) body.raw.ax = g * 800 / (1 + g * g) end",
    "function world.onStep() pull(select(2, world:ground(body.raw)) or 0) end",
    { steps = 1 }, -- in which it is not known yet what it stands on
    1,
    "body.vx ~ vx, 1e-9; body.y ~ 76 + (600 - body.x) / 2, 1e-9",
  }, { "mu, vx", { 0, -320 }, { 0.2, -160 }, { 0.41, 0 } })

  local Y = floorAt(120)
  local STACK = hill(
    crate("first", 120, Y - 16, 16, 16),
    crate("second", 118, Y - 32, 20, 16),
    crate("third", 125, Y - 48, 8, 16)
  )
  row("(P6) bear stacks that stand for ever, without an event", EVERYWHERE, STACK, {
    { steps = 1 },
    { "log = run:listenToWorld()", 2, "first at 120, floorAt(120) - 16" },
    { "second at 118, floorAt(120) - 32", "third at 125, floorAt(120) - 48" },
    { "log.begins + log.ends == 0", "first still", "second still", "third still" },
  })

  local function escalator(_, run)
    local speed = run.turn >= 2 and -60 or 60
    local stairs = slope(80, 336, 128, 64, "right", { surfaceSpeed = speed, friction = 1 })
    return { stairs, body({ x = 100, y = floorAt(100) - 24, friction = 1 }) }
  end
  row("(P6) are escalators with surfaceSpeed", EVERYWHERE, escalator, {
    0.5,
    { "x = body.x", 1, "body at x + 60, floorAt(x + 60) - 24" },
  })

  --  a pusher before three crates, on the hill and on a flat floor
  local function pushed(v)
    local list, start = hill(solid("low", -800, 2000, 2000, 40)), v.way > 0 and 60 or 330
    for n = 0, 3 do
      local x = start + v.way * n * 17
      for _, its in ipairs({ { "up", floorAt(x) }, { "flat", 2000 } }) do
        local one = crate(its[1] .. n, x, its[2] - 24, 16, 24)
        one[2].mass = n == 0 and 3 or 1
        list[#list + 1] = one
      end
    end
    return list
  end
  row("(P7) take no work from a row of crates that is pushed, way {way}", PUSH, pushed, {
    { 1, keep = "up0.vx, flat0.vx = 90 * way, 90 * way" },
    "up0 at flat0.x, floorAt(up0.x) - 24; up1 at flat1.x, floorAt(up1.x) - 24",
    "up2 at flat2.x, floorAt(up2.x) - 24; up3 at flat3.x, floorAt(up3.x) - 24",
  }, BOTH_WAYS)

  local function ridden(v)
    local x = v.way > 0 and 40 or 400
    return onHill(x, nil, crate("rider", x + 2, 364, 12, 12))
  end
  row("(P7) let a walker carry its rider, way {way}", EVERYWHERE, ridden, {
    {
      2,
      keep = "body.vx, rider.vx = way * 150, way * 150",
      "body.y ~ floorAt(body.x) - 24",
      "rider.y ~ body.y - 12",
      "rider touches bottom",
    },
  }, BOTH_WAYS)

  --             +------+ 312
  --             +------+ 320
  --      [ ]->      /
  --   ___________/
  local function underCeiling(v)
    local list = hill(solid("ceiling", 100, 300, 100, 20), body({ x = 0, y = 376 }))
    for n = 1, v.crates do
      list[#list + 1] = crate("crate" .. n, 16 * n, 376, 16, 24)
    end
    return list
  end
  -- 320 is the ceiling, 344 where the bottom is, 192 where the right edge is then
  row("(P8) are walls below a ceiling, {crates} crates pushed", PUSH, underCeiling, {
    { "first = run.named['crate' .. crates] or body", "log = run:listen(first)" },
    { 3, keep = "body.vx = 120" },
    "first at 176, 320, 3e-6", -- flush is flush to 1e-6 px in height, 2e-6 along x
    { "first.vx == 0", "first.touching.right ~= false" },
    { "body at 176 - 16 * crates, floorAt(176 - 16 * crates) - 24, 3e-6", "log.crushes == 0" },
  }, { "crates", { 0 }, { 1 }, { 2 } })

  local BOTH = hill(solid("roof", 100, 300, 270, 20), body({ x = 0, y = 376 }))
  BOTH[#BOTH + 1] = body({ name = "other", x = 440, y = 376 })
  row("(P8) are walls below a ceiling for two that come from both sides", PUSH, BOTH, {
    { 3, keep = "body.vx, other.vx = 120, -120" },
    "body.touching.right ~= false; other.touching.left ~= false",
  })

  --   ______________
  --   [ ]->
  --   _____   ______   as high as what walks through
  --        \_/
  local DIP = { solid("flat", -400, 400, 480, 40), solid("far", 112, 400, 1600, 40) }
  DIP[3], DIP[4] = slope(80, 400, 16, 8, "left"), slope(96, 400, 16, 8, "right")
  DIP[5], DIP[6] = solid("ceiling", -400, 356, 2000, 20), body({ x = 0, y = 376 })
  row("(P8) have a dip below a ceiling that stops nothing", { rate = { 30, 60, 144 } }, DIP, {
    { 0.5, keep = "body.vx = 2400", "body.x ~ 2400 * t" },
  })

  local function hanging(name, x, ...)
    return {
      solid("flat", -400, 400, 1200, 40),
      slope(0, 340, 100, 50, name),
      body({ x = x, y = 376 }),
      ...,
    }
  end
  --   _________
  --   \        |   topright
  --  ->  \     |
  --  -------\--+---
  row("(P8) that hang from above stop what walks below", EVERYWHERE, hanging("topright", -60), {
    { "listen body", { 2, keep = "body.vx = 100" } },
    "body at 56, 376", -- the edge is at 376 where x is 72
    { "body.vx == 0", "heard.body.crushes == 0" },
    { 0.5, keep = "body.vx = -100" },
    "body at 6, 376",
  })

  local LOW = { solid("flat", -200, 400, 600, 20), slope(0, 326, 200, 100, "topleft") }
  LOW[3] = body({ x = 100, y = 384, width = 20, height = 16 })
  row("(P8) that hang from above crush what grows below them, half of it in each", RATES, LOW, {
    { "listen body", 0.5 },
    { "body.y, body.height = 368, 32", 1, "body at 100, 372", "heard.body.crushes == 1" },
  })

  -- The same below a thin one, which is left over by the shortest way.
  local THIN = { solid("flat", -200, 400, 600, 20), slope(0, 376, 100, 8, "topleft") }
  THIN[3] = body({ x = 60, y = 384, height = 16 })
  row("(P8) that hang from above and are thin hold a hero that stands up below them", RATES, THIN, {
    { "listen body", 0.5 },
    { "body.y, body.height = 368, 32", 1, "body.x == 60", "body.y > 368", "body.y < 376" },
    { "heard.body.crushes == 1", "body.y, body.height = body.y + 16, 16", 1, "body at 60, 384" },
  })

  --    ______
  --    |  .-'  down and up again
  --    |-' [ ]
  --   _______________
  local PRESS = { solid("flat", -200, 400, 600, 20), slope(0, 210, 300, 100, "topleft") }
  PRESS[2][2].static, PRESS[2][2].kinematic = nil, true
  PRESS[3] = body({ x = 100, y = 380, width = 20, height = 20 })
  row("that press down from above hold the object that they crush, at any depth", PUSH, PRESS, {
    { "listen body", "slope.vy = 60", 2.5, "body at 100, 380, 1e-3" },
    { "heard.body.crushes == 1", "slope.vy = -60", 2, "body at 100, 380, 1e-3", "slope.vy = 0" },
    { 1, keep = "body.vx = 60", "body at 100 + 60 * t, 380" },
  })

  local HIGH = { solid("flat", -400, 400, 1200, 40), slope(0, 300, 100, 50, "topleft") }
  HIGH[3] = body({ x = 50, y = 376 })
  row("that hang from above send a jumper down again", EVERYWHERE, HIGH, {
    0.5,
    "body.vy = -400",
    { 1, "body.x ~ 50", "body.y >= 325 - 1e-6" },
    "body at 50, 376",
  })

  local SECOND = onHill(20)
  table.insert(SECOND, 1, crate("other", 500, 384, 16, 16))
  row(
    "world:ground tells what it is, and the gradient",
    { rate = { 60 }, turn = { 0, 2 } },
    SECOND,
    {
      0.5,
      { "ground, gradient = world:ground(body.raw)", "ground == flat.raw", "gradient == 0" },
      { 1, keep = "body.vx = 100" }, -- to x = 120
      { "ground, gradient = world:ground(body.raw)", "ground.slope ~= nil", "gradient ~ -0.5" },
      { "body.vy = -300", 0.5, "(world:ground(body.raw)) == nil" },
    }
  )

  -- as from the end of a floor without one, 2000 px further
  local REFUSED = { solid("flat", -400, 400, 480, 40), solid("same", 1600, 400, 480, 40) }
  REFUSED[3], REFUSED[4] = slope(80, 400, 64, 16, "left"), body({ x = 20, y = 376 })
  REFUSED[5] = body({ name = "other", x = 2020, y = 376 })
  row("canCollide: let fall what it refuses", { rate = { 20, 30, 60 } }, REFUSED, {
    "function slope.raw.canCollide() return false end",
    "world:refresh(slope.raw)",
    { 0.5, keep = "body.vx, other.vx = 330, 330", "body at other.x - 2000, other.y" },
  })

  local LEG = { solid("flat", -400, 400, 1200, 40), slope(80, 336, 128, 64, "right") }
  LEG[3] = body({ x = 250, y = 376 })
  row("have a wall at their legs", EVERYWHERE, LEG, {
    { 1, keep = "body.vx = -100" },
    "body at 208, 376",
    "body touches left bottom",
  })

  local BELOW = { solid("flat", -400, 400, 1200, 40), slope(80, 300, 128, 64, "right") }
  BELOW[3] = body({ x = 120, y = 376 })
  row("have a ceiling below", EVERYWHERE, BELOW, {
    0.5,
    "body.vy = -300",
    { 0.5, "body.y >= 364 - 1e-6" },
  })

  local FOOT = { solid("flat", -400, 404, 480, 40), slope(80, 336, 128, 64, "right") }
  FOOT[3] = body({ x = 20, y = 380 })
  row("(P4) are walls for what is too low for the foot", RATES, FOOT, {
    { 1, keep = "body.vx = 100" },
    "body at 64, 380",
    "body touches right bottom",
  })
end)

describe("slope and oneWay: hills", function()
  local function oneWay(v)
    local up = slope(80, 336, 128, 64, "right", { oneWay = "top" })
    return { solid("flat", -400, 400, 1200, 40), up, body({ x = v.x, y = v.y }) }
  end
  row("(P9) bear what comes from the foot", EVERYWHERE, oneWay, {
    { 1.5, keep = "body.vx = 100", "body.y ~ floorAt(body.x) - 24" },
  }, { "x, y", { 20, 376 } })

  row("(P9) bear what comes from above", EVERYWHERE, oneWay, {
    1,
    "body at 120, floorAt(120) - 24",
  }, { "x, y", { 120, 250 } })

  row("(P9) let pass what comes from behind", EVERYWHERE, oneWay, {
    { 2, keep = "body.vx = -100", "body at 250 - 100 * t, 376" },
  }, { "x, y", { 250, 376 } })

  row("(P9) let pass what comes from below", EVERYWHERE, oneWay, {
    0.5,
    "body.vy = -400",
    { 0.5, "body.y ~ 376 - 400 * t + 400 * t * t" },
    1,
    "body at 140, floorAt(140) - 24",
  }, { "x, y", { 140, 376 } })

  row("(P9) let fall with dropThrough", EVERYWHERE, oneWay, {
    0.5,
    "body touches bottom",
    "world:dropThrough(body.raw) == true",
    1,
    "body at 140, 376",
  }, { "x, y", { 140, floorAt(140) - 24 } })

  --     +-+
  --  \._+-+_./   a bridge
  local function bridge(v)
    local list = { solid("flat", -400, 500, 1200, 40), body({ x = v.x, y = 176, snap = 8 }) }
    for i = 0, 19 do
      local name = i < 10 and "left" or "right"
      list[i + 3] = slope(20 * i, 200 + 4 * math.min(i, 19 - i), 20, 4, name, { oneWay = "top" })
    end
    return list
  end
  row("(P9) are a bridge for dropThrough: {x}, {vx} px/s", EVERYWHERE, bridge, {
    0.5,
    "body touches bottom",
    { "body.vx = vx", "world:dropThrough(body.raw) == true" },
    { 0.5, keep = "body.vx = vx" },
    "body.y > 276",
  }, { "x, vx", { 104, -200 }, { 107, 200 }, { 121, 0 }, { 135, 200 }, { 121, -200 } })
end)

describe("slope and kinematic: hills that move", function()
  local function moving(fields, ...)
    local entry = slope(80, 336, 128, 64, "right", { static = false, kinematic = true })
    return { scene.thing("ground", entry[2])(fields), ... }
  end

  row("(P10) carry what stands and what walks at {walk} px/s", EVERYWHERE, function()
    return moving({}, body({ x = 130, y = floorAt(130) - 24 }))
  end, {
    0.5,
    "slope.vx, slope.vy = 50, -30",
    {
      0.5,
      keep = "body.vx = walk; m = 130 + walk * t",
      "body at m + 50 * t, floorAt(m) - 24 - 30 * t",
      "body.vy == 0",
      "body touches bottom",
    },
  }, { "walk", { 0 }, { 40 }, { -40 } })

  --      ______    ______
  --    _/      \__/      \   a train, all of it runs
  local function train(v)
    local list = { body({ x = -100, y = 308 }) }
    for n, part in ipairs({
      { 0, 300, 64, 32, "right" },
      { 64, 300, 80, 32 },
      { 144, 300, 64, 32, "left" },
      { 208, 316, 32, 16, "right" },
      { 240, 300, 32, 32, "right" },
      { 272, 300, 300, 32 },
      { -200, 332, 200, 20 },
    }) do
      local fields = { static = false, kinematic = true, vx = v.vx, vy = v.vy }
      list[n + 1] = slope(part[1], part[2], part[3], part[4], part[5], fields)
    end
    return list
  end
  local LEVELS = { rate = variants.RATES, order = variants.ORDERS }
  row("(P1, P10) at ({vx}, {vy}) px/s have no wall at their seams for what walks", LEVELS, train, {
    "run:step(1 / 60)", -- it lands
    { 2, keep = "body.vx = 200", "body.vx == 200", "body touches bottom" },
  }, { "vx, vy", { 60, 0 }, { -60, 0 }, { 0, 60 }, { 0, -60 }, { 30, -40 } })

  local function soft(v)
    local fields = { x = 0, y = 300, width = 400, height = 100, vy = v.vy, slope = "left" }
    local list =
      moving(fields, body({ x = 40, y = 286 }), body({ name = "other", x = 64, y = 292 }))
    list.soft = { players = { players = 300 } }
    return list
  end
  row("(P10) at {vy} px/s keep two of a soft group down that part on them", RATES, soft, {
    {
      1.5,
      keep = "body.vx, other.vx = 120, 60",
      "body.y ~ slope.y + body.x / 4 - 24",
      "other.y ~ slope.y + other.x / 4 - 24",
      "body.vy == 0",
      "other.vy == 0",
    },
  }, { "vy", { 0 }, { -20 }, { -40 }, { -80 } })

  local FLAT = solid("flat", -400, 400, 1200, 40)
  row("(P10) lift what is in their way, if they do not carry", EVERYWHERE, function()
    return moving({ vx = -60, carry = false }, body({ x = 40, y = 376 }), FLAT)
  end, { { 2, "body at 40, min(400, 400 - (56 - (80 - 60 * t)) * 0.5) - 24" } })

  row("(P10) crush what has no room", EVERYWHERE, function()
    local ceiling = solid("ceiling", 100, floorAt(130) - 64, 100, 20)
    return moving({ vy = -30 }, body({ x = 130, y = floorAt(130) - 24 }), ceiling)
  end, { "listen body", 1, "heard.body.crushes == 1" })

  --  ______________________ 372
  --  wall |[ ]      ..../|
  --       |    ..../  <- |
  --  ______________________ 400
  row("(P10) push nothing into a wall: gap {gap}, restitution {e}", EVERYWHERE, function(v)
    local list = moving({ y = 376, height = 24, vx = -100 }, FLAT)
    list[3], list[4] = solid("ceiling", -400, 332, 900, 40), solid("wall", 0, 372, 20, 28)
    list[5] = body({ x = 20 + v.gap, y = 376, restitution = v.e })
    return list
  end, { "listen body", { 2, "body.x > 20 - 1e-6" }, "heard.body.crushes > 0" }, {
    "gap, e",
    { 0, 0 },
    { 0, 1 },
    { 5, 1 },
    { 5.3, 0 },
  })
end)

describe("slope and restitution: hills", function()
  --  a ball that falls on 45 degrees; its corner is at (50, 50) when it has fallen by 74 px
  local BOUNCY = slope(0, 0, 100, 100, "right", { restitution = 1 })
  local FALLS = { BOUNCY, body({ x = 34, y = -40, width = 16, height = 16 }) }
  row("(P11) bounce along their normal", { rate = variants.RATES, turn = variants.TURNS }, FALLS, {
    { "listen body", 0.5 },
    { "u = sqrt(1600 * 74)", "heard.body.begins == 1", "heard.body.speed ~ u" },
    { "body.vx ~ -u, 1e-6", "body.vy ~ 800 * (0.5 - u / 800), 1e-6" },
  })

  local BALL = body({ x = 236, y = -175.5, restitution = 1, vx = -600, vy = 600 })
  row("(P11) bounce on their crest what has run off it by the end of the step", RATES, {
    gravity = 0,
    slope(0, 0, 100, 100, "right"),
    BALL,
  }, { 0.5, "body at 236 - 300, -24 - 148.5", "body.vy ~ -600" }) -- at 100.5 after 0.2525 s

  -- 100 px/s along x, less what goes into 1:2; it has met the edge after 0.82 s, at 82 px, and has
  -- left it at the crest
  row("(P12) are diagonal walls without gravity: {name}", RATES, function(v)
    local box = body({ x = 42 - 100 * v.way, y = 20, width = 16, height = 10, vx = 100 * v.way })
    return { gravity = 0, slope(0, 0, 100, 50, v.name), box }
  end, { 2, "body at x, y", "body.vx ~ 80 * way", "body.vy ~ 40 * up" }, {
    "name, way, up, x, y",
    { "left", -1, -1, 84 - 118.4, -27.2 },
    { "right", 1, -1, 118.4, -27.2 },
    { "topleft", -1, 1, 84 - 118.4, 40 + 27.2 },
    { "topright", 1, 1, 118.4, 40 + 27.2 },
  })
end)

--   #####
--   #####[   ]          A wall stands where the slope begins. What dashes against it was on its way
--        [   ]          down the slope in that step.
--      .-'########
row("slope: a wall at its crest stops a dash of {speed} px/s on the ground", RATES, {
  solid("wall", 96, 240, 16, 16),
  slope(96, 272, 16, 16, "right"),
  solid("floor", 112, 272, 160, 16),
  body({ x = 118, y = 248 }),
}, {
  { steps = 1 },
  { 0.5, keep = "body.vx = -speed", "body.y ~ 248" },
  "body.x ~ 112",
}, { "speed", { 130 }, { 300 }, { 500 }, { 800 } })
