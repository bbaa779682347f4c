--- Rest is exact, a bounce loses what it should and no more.

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local TURNED = { turn = variants.TURNS }
local EVERYWHERE = variants.EVERYWHERE
local row = play.row
local solid = scene.maker("tiles", { static = true })
local body = scene.thing("boxes", { name = "box", x = 0, y = 0, width = 16, height = 16 })

--- A box at y over a floor with its top at y = 116.
local function overFloor(v)
  local floor = solid("floor", -200, 116, 800, 32)
  return { floor, body({ y = v.y, restitution = v.restitution, vy = v.vy }) }
end

describe("restitution: a resting box", function()
  --   +--+
  --   |  |
  --   +--+
  --  ------
  row("(9a) stays where it is for 10 s: one begin, no end", TURNED, overFloor, {
    "listen box",
    { 10, "box at 0, 100", "box on floor", "box still", "box touches bottom" },
    { "box heard 1, 0", "heard.box.sides.bottom == 1", "heard.box.stays == 599" },
  }, { "y", { 100 } })

  row("(9a) stays at any frame rate with {restitution}", EVERYWHERE, overFloor, {
    "listen box",
    { 2, "box on floor", "box still" },
    { "box at 0, 100", "box heard 1, 0" },
  }, { "y, restitution", { 100, 0 }, { 100, 0.5 }, { 100, 1 } })
end)

describe("restitution: a falling box", function()
  --  +--+ y = 0
  --  +--+
  --   |      peaks at 75, 93.75, 98.4375
  --   v  .
  --  ------- y = 116: met after 0.5, 1, 1.25 s ..., with half the speed left each time
  row("(9b) with restitution 0.5 comes up to a quarter each time", TURNED, overFloor, {
    "listen box",
    { 0.5, "box.y ~ 400 * t * t" },
    { 0.5, "box.y ~ 100 - 200 * t + 400 * t * t, 0.1" },
    { 0.25, "box.y ~ 100 - 100 * t + 400 * t * t, 0.1" },
    { 0.1, "box.y ~ 100 - 50 * t + 400 * t * t, 0.1" },
    0.65,
    { "begins, ends = heard.box.begins, heard.box.ends", "begins - ends == 1" },
    { 3, "box at 0, 100", "box on floor", "box still" },
    "box heard begins, ends",
  }, { "y, restitution", { 0, 0.5 } })

  row("(9c) with restitution 1 comes up to the same height for 20 s", EVERYWHERE, overFloor, {
    "listen box",
    { 20, "box.y - box.vy ^ 2 / 1600 ~ 0, 0.01", "box.y <= 100 + 1e-6" },
    "box heard 20, 20", -- it meets the floor every second, first after 0.5 s
  }, { "y, restitution", { 0, 1 } })

  row("(9e) with {restitution} rests although dt is 0.5 now and then", TURNED, overFloor, {
    function(run)
      for i = 1, 180 do
        run:step(i % 20 == 7 and 0.5 or 1 / 60)
      end
    end,
    { "box at 0, 100", "box on floor", "box still" },
    { "run:step(0.5)", "box on floor", "box still" },
  }, { "y, restitution", { 0, 0 }, { 0, 0.5 } })
end)

describe("restitution: a bounce", function()
  --   +--+ 20 px/s  |
  --   +--+ ->       |   met after 0.7 s
  local function beforeWall(v)
    local wall = solid("wall", 16 + v.speed * 0.7, 0, 16, 100)
    return { gravity = 0, wall, body({ y = 40, vx = v.speed, restitution = 1 }) }
  end
  row("(9d) without gravity comes back as fast as it went, {speed} px/s", EVERYWHERE, beforeWall, {
    { "listen box", 2, "box.vx ~ -speed", "box.vy == 0", "box at -speed * 0.6, 40" },
    { "box heard 1, 1", "heard.box.speed ~ speed" },
  }, { "speed", { 20 }, { 0.01 }, { 3000 } })

  -- Pulled towards each other by 800 px/s², the two meet in the middle of the step: that adds
  -- 1600 dt px/s in two steps.
  local LEVELS = { rate = { 30, 60, 144 }, turn = variants.TURNS }
  local function onFloor(v, run)
    v.dt = 1 / run.rate
    v.toWall = v.share * 1600 * v.dt - 400 * v.dt
    return overFloor({
      y = 100 - v.toWall * v.dt / 2 - 100 * v.dt ^ 2,
      restitution = 1,
      vy = v.toWall,
    })
  end
  --   +--+ 500   300 +--+
  --   +--+ ->     <- +--+
  local function twoPulled(v, run)
    v.dt = 1 / run.rate
    local vx = v.share * 1600 * v.dt - 400 * v.dt
    local gap = vx * v.dt / 2 + 100 * v.dt ^ 2
    local one = body({ vx = vx, ax = 500, restitution = 1 })
    return { gravity = 0, one, body({ name = "other", x = 16 + gap, ax = -300 }) }
  end
  local BELOW, ABOVE = { "share, back", { 0.999, 0 } }, { "share, back", { 1.001, 1 } }
  for word, rows in pairs({ ["does not happen below"] = BELOW, ["happens above"] = ABOVE }) do
    row(word .. " the speed that gravity adds in two steps", LEVELS, onFloor, {
      { steps = 1 },
      "box.vy ~ back * (400 - share * 1600) / run.rate",
    }, rows)
    row(word .. " the speed that both accelerations add in two steps", LEVELS, twoPulled, {
      { steps = 1 },
      "box.vx - other.vx ~ back * (400 - share * 1600) / run.rate",
    }, rows)
  end

  local FALLING = { body({ vy = 0.01, restitution = 1 }), body({ name = "low", y = 16.0001 }) }
  row("of two that fall together happens however slowly they meet", TURNED, FALLING, {
    { steps = 1 },
    "box.vy ~ 800 / 60; low.vy ~ 800 / 60 + 0.01",
  })

  local function inRoom(v)
    local list = overFloor(v)
    list[3] = solid("ceiling", -200, 8, 800, 16)
    return list
  end
  row("between a floor and a ceiling keeps its energy", EVERYWHERE, inRoom, {
    { 5, "box.vy ^ 2 / 2 - 800 * box.y ~ 85000, 1e-3", "box.y > 24 - 1e-6", "box.y <= 100 + 1e-6" },
  }, { "y, restitution, vy", { 50, 1, -500 } })

  -- Limits: after 24 hits in a step a body bounces no more.
  local function narrow(v)
    local ball = body({ x = 20, y = 10.5, width = 10, height = 10, restitution = 1, vy = v.vy })
    local floors = { solid("low", 0, 0, 800, 10), solid("high", 0, 21, 800, 10) }
    return { gravity = 0, maxStep = 1 / v.rate, floors[1], floors[2], ball }
  end
  row("in 1 px of room, {vy} px/s in steps of 1/{rate} s leaves {left}", TURNED, narrow, {
    function(run)
      for _ = 1, 30 do
        run:step(1 / 30)
      end
    end,
    "abs(box.vy) ~ left, 1e-9",
  }, { "rate, vy, left", { 30, 800, 0 }, { 30, 400, 400 }, { 240, 800, 800 } })
end)
