--- One-way objects: solid on one side, open on the others.

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local small = require("spec.support.small")
local turn = require("spec.support.turn")
local variants = require("spec.support.variants")

local EVERYWHERE, SOME = variants.EVERYWHERE, variants.SOME
local SETTLE = 1 / 6
local row = play.row

local WAY = { name = "way", x = 0, y = 100, width = 200, height = 8, oneWay = "top" }
local way = scene.thing("ways", small.set({ static = true }, WAY))
local lift = scene.thing("ways", small.set({ kinematic = true }, WAY))
local tile =
  scene.thing("tiles", { name = "floor", x = 0, y = 300, width = 200, height = 8, static = true })
local solid = scene.maker("tiles", { static = true })
local body = scene.thing("players", { name = "body", x = 50, y = 200, width = 16, height = 24 })

--    .  feet reach 60
--   ===============  100
--    |
--   +-+
--   +-+
--   ---------------  300
local function below(v)
  return { way(), tile(), body({ y = v.feet - 24 }) }
end
row("oneWay: (7) jumped through from {feet}, up to {peak}, feet end at {ends}", EVERYWHERE, below, {
  { steps = 1 },
  { "body.y, body.vy = feet - 24, -sqrt(1600 * (feet - peak))", "listen body" },
  "up, hits = -body.vy, -body.vy / 800 + sqrt((ends - peak) / 400)",
  {
    2,
    "body at 50, t < hits and feet - 24 - up * t + 400 * t * t or ends - 24",
    "0 == t < hits - 1e-6 and heard.body.begins or 0",
    "0 ~ t < hits - 1e-6 and body.vy - 800 * t + up or 0",
  },
  { "body on ends == 100 and way or floor", "heard.body.begins == 1" },
}, {
  "feet, peak, ends", -- highest feet, feet at the end
  { 224, 60, 100 },
  { 300, 60, 100 },
  { 224, 99, 100 },
  { 300, 90, 100 },
  { 224, 104, 300 },
  { 300, 108.5, 300 },
  { 224, 112, 300 },
})

describe("oneWay: fallen on", function()
  local function above(v)
    return { way({ height = v.height }), body({ y = 0, vx = 10, vy = v.vy }) }
  end
  row("(7) at {vy} px/s, {height} px thick, catches", EVERYWHERE, above, {
    "listen body",
    { 0.5, "body at 50 + 10 * t, min(76, vy * t + 400 * t * t)" },
    { "body on way", "heard.body.sides.bottom == 1", "body heard 1, 0" },
  }, { "vy, height", { 0, 8 }, { 100, 1 }, { 6000, 8 }, { 90000, 1 } })

  -- the feet come down to 100 after half a second, when 1 px of them is above it
  row("at an angle catches at its corner", SOME, { way(), body({ x = -65, y = -24, vx = 101 }) }, {
    2 / 3,
    "body on way",
  })

  row("beside its corner lets pass", SOME, { way(), body({ x = -67, y = -24, vx = 100 }) }, {
    { 2 / 3, "body at -67 + 100 * t, -24 + 400 * t * t" },
  })
end)

--  +-+ ->
--  +=+=============   feet at 104
describe("oneWay: walked through", function()
  local FLOATS = body({ x = -40, y = 80, vx = 100, gravity = 0, gravityX = 0 })
  row("(7) in the air keeps vx", EVERYWHERE, { way(), FLOATS }, {
    "listen body",
    { 3, "body at -40 + 100 * t, 80", "body.vx == 100" },
    "body heard 0, 0",
  })

  local LOW = tile({ x = -300, y = 104, width = 800 })
  local ON_FLOOR = { way(), LOW, body({ x = -40, y = 80 }) }
  row("(7) on a floor keeps vx, to and fro", EVERYWHERE, ON_FLOOR, {
    "body.vx = 100",
    { 1.5, "body at -40 + 100 * t, 80", "body.vx == 100", "body touches bottom" },
    "body.vx = -100",
    { 1.5, "body at 110 - 100 * t, 80", "body.vx == -100", "body touches bottom" },
  })

  row("what begins inside it falls out of it", SOME, { way(), tile(), body({ y = 79 }) }, {
    { 0.5, "body at 50, 79 + 400 * t * t" },
  })
end)

describe("dropThrough", function()
  local TWO = { way(), tile(), body({ y = 76 }), body({ name = "other", x = 80, y = 76 }) }
  row("(7) at rest lets fall, once, and only the one that asked", EVERYWHERE, TWO, {
    SETTLE,
    { "listen body", "listen other", "world:dropThrough(body.raw) == true" },
    { 1, "body at 50, min(276, 76 + 400 * t * t)", "other at 80, 76", "other still" },
    { "body on floor", "body heard 1, 1", "other heard 0, 0" },
    "world:dropThrough(body.raw) == false",
    "body.vy = -sqrt(1600 * 240)", -- it is solid again after a jump
    2,
    "body on way",
  })

  row("in the air and on a solid does nothing", SOME, { way(), tile(), body() }, {
    { steps = 1 },
    "world:dropThrough(body.raw) == false",
    1,
    "world:dropThrough(body.raw) == false",
    0.5,
    "body on floor",
  })

  local TOP = { way(), tile(), body({ y = 76 }), body({ name = "top", y = 52 }) }
  row("with a box on the head lets that one land; by it does nothing", SOME, TOP, {
    SETTLE,
    "world:dropThrough(top.raw) == false",
    { 0.5, "body at 50, 76", "top at 50, 52" },
    "world:dropThrough(body.raw) == true",
    1,
    "body on floor",
    "top on way",
    "top at 50, 76",
  })

  --   +-+|
  --   | || door
  --   +-+|
  --  =======
  local DOOR = way({ name = "door", x = 74, y = 176, width = 8, height = 124, oneWay = "left" })
  local AT_DOOR = { tile(), DOOR, body({ y = 276, vx = 60 }) }
  row("on a solid, at a door that opens to the other side, does nothing", SOME, AT_DOOR, {
    0.2,
    "body.touching.right == door; world:dropThrough(body.raw) == false",
    { "body.vx = 60", 0.5, "body at 58, 276" },
  })

  --        +-+
  --   ===========+----+
  --              |    |  solid
  local SOLID = { way(), solid("solid", 200, 100, 100, 50), body({ x = 186, y = 76 }) }
  row("while standing also on a solid, stays on that", EVERYWHERE, SOLID, {
    SETTLE,
    { "listen body", "run:support(body) == way", "world:dropThrough(body.raw) == true" },
    { 1, "body at 186, 76", "body on solid" },
    "body heard 0, 1",
    "body.vx = 100", -- away from it, and back: it is solid again
    0.5,
    { "body.vx = -100", 1, "body on way" },
  })

  --       +-+->
  --   ====|=|=====  tiles
  local function planks(v)
    local list = { tile({ x = -200, width = 600 }), body({ x = v.x, y = 76 }) }
    for i = 0, 9 do
      list[i + 3] = way({ name = "plank" .. i, x = 16 * i, width = 16 })
    end
    return list
  end
  row("a row of tiles, passes the next one, too: from {x} at {vx} px/s", SOME, planks, {
    SETTLE,
    { "body.vx = vx", "world:dropThrough(body.raw) == true" },
    { 0.5, "body at x + vx * t, 76 + 400 * t * t" },
  }, { "x, vx", { 80, -230 }, { 83, 230 }, { 95, 0 }, { 96, 230 }, { 111, -230 } })

  row("a moving one, keeps its velocity", SOME, { lift(), body({ y = 76 }) }, {
    SETTLE,
    { "way.vx = 60", 0.5, "world:dropThrough(body.raw) == true" },
    { 0.5, "body at 80 + 60 * t, 76 + 400 * t * t", "body.vx ~ 60" },
  })
end)

describe("oneWay: that moves", function()
  row("(7) at {vy} px/s keeps its rider", EVERYWHERE, { lift(), body({ y = 76 }) }, {
    SETTLE,
    { "listen body", "way.vy = vy" },
    { 1, "body at 50, 76 + vy * t", "body on way" },
    "body heard 0, 0",
  }, { "vy", { -60 }, { 200 }, { -5000 }, { 5000 } })

  local function under(v)
    return { lift({ y = 310.3, vy = v.vy }), tile(), body({ y = 276 }) }
  end
  row("up from below a body at {vy} px/s takes it along", SOME, under, {
    { 0.5, "body at 50, min(276, 286.3 + vy * t)" },
    "body on way",
  }, { "vy", { -60 }, { -600 }, { -6000 } })

  local HEAD = { lift({ y = 219.7, vy = 60 }), tile(), body({ y = 276 }) }
  row("down on to a head passes it, and takes it along from below only", SOME, HEAD, {
    SETTLE,
    "listen body",
    { 1, "body at 50, 276" }, -- at 289.7, inside the body
    "way.vy = -60",
    { 0.5, "body at 50, 276" },
    "way.vy = 60",
    { 1, "body at 50, 276" }, -- at 319.7, below it
    "body heard 0, 0",
    "way.vy = -60",
    1, -- at 259.7
    { "body at 50, 235.7", "body on way" },
  })
end)

describe("oneWay: beside a solid", function()
  --   +-+ ->  +---+
  --   +-+     |   |
  --   ========+---+
  local UPRIGHT = { way(), solid("solid", 200, 84, 16, 24), body({ y = 76 }) }
  row("(7) still lets walk into it", EVERYWHERE, UPRIGHT, {
    { 2, keep = "body.vx = 100", "body at min(184, 50 + 100 * t), 76" },
    { "body.vx == 0", "body touches bottom right" },
  })

  local LEVEL = {
    way({ width = 100 }),
    solid("solid", 100, 100, 50, 40),
    way({ name = "second", x = 150, width = 100 }),
    body({ x = 20, y = 76 }),
  }
  row("of the same height is walked over without a snag, both ways", EVERYWHERE, LEVEL, {
    "body.vx = 100",
    { 2, "body at 20 + 100 * t, 76", "body.vx == 100", "body touches bottom" },
    "body.vx = -100",
    { 2, "body at 220 - 100 * t, 76", "body.vx == -100", "body touches bottom" },
  })

  --   ====+---+
  --  +-+->|   |
  --   ^   |   |
  local WALL = { way(), solid("solid", 200, 0, 16, 300), tile(), body({ x = 184, y = 276 }) }
  row("lets jump through while pressing against it", EVERYWHERE, WALL, {
    SETTLE,
    { "up = sqrt(1600 * 220)", "body.vy = -up" },
    { 2 / 3, keep = "body.vx = 100", "body at 184, 276 - up * t + 400 * t * t" },
    { 5 / 6, keep = "body.vx = 100", "body.y <= 76 + 1e-6" },
    { "body on way", "body touches bottom right" },
  })

  local ROW = { body({ x = 0, y = 76, vx = 200 }) }
  for i = 0, 39 do
    ROW[i + 2] = way({ name = "way" .. i, x = 16 * i, width = 16 })
  end
  row("or another one-way in a row has no seams", SOME, ROW, {
    { 2, "body at 200 * t, 76", "body.vx == 200", "body touches bottom" },
  })
end)

local function loaded(v)
  return {
    way(),
    body({ y = 76 }),
    body({ name = "heavy", x = 55, y = -100, vy = v.vy, mass = v.mass }),
  }
end
row("oneWay: (7) holds under a box of mass {mass} that comes at {vy} px/s", EVERYWHERE, loaded, {
  "listen body",
  { 1, "body at 50, 76" },
  { "body on way", "heavy at 55, 52", "heavy on body", "body heard 2, 0" },
}, { "mass, vy", { 1, 0 }, { 100, 0 }, { 1000, 2000 }, { 100, 90000 } })

--   v = (100, 0) ->  |  solid on the left
describe("oneWay: each of its four sides", function()
  -- The box would have its middle at x, y after half a second.
  local function meet(v)
    local isUpright = v.side == "left" or v.side == "right"
    local thing = { oneWay = v.side, x = isUpright and 100 or 96, y = 0, height = 16 }
    thing.width = isUpright and 8 or 16
    local box = { x = v.x - v.vx / 2, y = v.y - v.vy / 2, width = 16, height = 16 }
    box.vx, box.vy = v.vx * v.factor, v.vy * v.factor
    return { gravity = 0, way(thing), body(box) }
  end
  local STOPS = { "listen body", 1, "body at x, y", "body still", "body heard 1, 0" }
  local PASSES = {
    { "listen body", "x0, y0, vx0, vy0 = body.x, body.y, body.vx, body.vy" },
    { 0.5, "body at x0 + vx0 * t, y0 + vy0 * t" },
    "body heard 0, 0",
  }
  for _, factor in ipairs({ 1, 30, 450 }) do
    row("{side} stops what comes from there at ({vx}, {vy}) * {factor} px/s", SOME, meet, STOPS, {
      "side, vx, vy, x, y, factor", -- where it ends
      { "left", 200, 0, 84, 0, factor },
      { "right", -200, 0, 108, 0, factor },
      { "top", 0, 200, 96, -16, factor },
      { "bottom", 0, -200, 96, 16, factor },
    })
    local open = { "side, vx, vy, x, y, factor" }
    for _, v in ipairs({
      { "left", 200, 0 },
      { "right", -200, 0 },
      { "top", 0, 200 },
      { "bottom", 0, -200 },
    }) do
      for _, path in ipairs({ { -v[2], -v[3] }, { v[3], v[2] }, { -v[3], -v[2] } }) do
        open[#open + 1] = { v[1], path[1], path[2], 96, 0, factor }
      end
    end
    row("{side} lets through what moves by ({vx}, {vy}) * {factor} px/s", SOME, meet, PASSES, open)
  end

  local CEILING = { way({ oneWay = "bottom" }), tile(), body({ y = 20 }) }
  row("bottom: a ceiling that is open from above holds the head", SOME, CEILING, {
    { 1, "body at 50, min(276, 20 + 400 * t * t)" },
    { "listen body", "body.vy = -1000" },
    { 1, "body.y >= 108 - 1e-6" },
    { "heard.body.sides.top == 1", "body at 50, 276" },
  })
end)

--       +-+
--      .-"""-.     its upper quarters hold, the others let through
--     (       )
describe("oneWay: round", function()
  local disc = scene.maker("discs", { oneWay = "top", radius = 50 })
  local PAGES = { rate = variants.RATES, shift = { 0, 1 / 3 } }
  row("{what}, with radius {radius}, at a {kind} one", PAGES, function(v)
    local size = v.radius and 2 * v.radius or 20
    local fields = { vx = v.vx, vy = v.vy, gravity = v.gravity, radius = v.radius }
    local list = { disc("disc", 0, 0, 100, 100) }
    list[1][2].static, list[1][2].kinematic = v.kind == "static", v.kind == "kinematic"
    list[2] = scene.maker("bodies", fields)("body", v.x, v.y, size, size)
    return list
  end, { 1.5, "body.x ~ toX; body.y ~ toY, 0.7" }, {
    "kind, radius, what, x, y, vx, vy, gravity, toX, toY",
    { "static", nil, "a box lands on it", 40, -100, 0, 0, 800, 40, -20 },
    { "static", 10, "a ball lands on it", 40, -100, 0, 0, 800, 40, -20 },
    { "kinematic", 10, "a ball lands on it", 40, -100, 0, 0, 800, 40, -20 },
    { "static", nil, "a box jumps through it", 40, 120, 0, -600, 800, 40, -20 },
    { "static", 10, "a ball jumps through it", 40, 120, 0, -600, 800, 40, -20 },
    { "kinematic", nil, "a box jumps through it", 40, 120, 0, -600, 800, 40, -20 },
    { "static", 10, "a ball flies through it", -100, 60, 600, 0, 0, 800, 60 },
    { "static", nil, "a box flies through it", -100, 60, 600, 0, 0, 800, 60 },
  })

  row("a ball rolls off it", PAGES, function()
    local ball = scene.maker("balls", { radius = 10 })
    return { disc("disc", 0, 0, 100, 100, { static = true }), ball("ball", 50, -30, 20, 20) }
  end, { 2, "ball.x > 100; ball.y > 50" })
end)

describe("canCollide: of a one-way", function()
  row("is asked for what comes from the solid side", SOME, { way(), tile(), body({ y = 276 }) }, {
    SETTLE,
    "asked = ''",
    function(run, it)
      function it.body.raw.canCollide(_, other, side)
        if other == it.way.raw then
          it.asked = turn.side(turn.back(run.turn), side)
          run:same("its own side", it.asked, "bottom")
        end
        return true
      end
    end,
    { "body.vy = -sqrt(1600 * 240)", 2, "body on way", "asked == 'bottom'" },
  })

  local FALLS = { way(), tile(), body({ y = 20 }) }
  row("that says no, of the {which}, lets pass", SOME, FALLS, {
    "listen body",
    "function {which}.raw.canCollide(_, other) return other == floor.raw end",
    "world:refresh(way.raw)",
    { 1, "body at 50, min(276, 20 + 400 * t * t)" },
    "body heard 1, 0",
  }, { "which", { "body" }, { "way" } })
end)

describe("oneWay", function()
  local function word(v, run)
    local entry = way()
    entry[2].oneWay = run.turn == 0 and v.value or v.value and "top" or nil
    return { entry, tile(), body({ y = 150, vy = v.vy }) }
  end
  row("{value} ends at feet {feet}", SOME, word, { 2, "body at 50, feet - 24" }, {
    "value, vy, feet",
    { true, -400, 100 },
    { false, 0, 300 },
  })

  -- It flies up through the one-way, bounces off the ceiling, and comes down onto the one-way in
  -- the same step.
  local BALL = body({ x = 40, y = 2, width = 10, height = 10, vy = -2000, restitution = 1 })
  local CEILING = { gravity = 0, BALL, way({ y = 0, height = 2 }), tile({ y = -40, height = 20 }) }
  row("stops what it has let through earlier in the step", { rate = { 60 } }, CEILING, {
    { steps = 1 },
    "body.y ~ -34 / 3; body.vy ~ -2000",
  })
end)
