--- `maxSlope`: a steeper slope is a wall for the object: it stops there, and falls along the edge.
--
--                   __________ 200
--                  /
--                 /    200 px in 50: 4 px up for each px across
--        ________/ 400
--              100

local play = require("spec.support.play")
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

local EVERYWHERE = variants.EVERYWHERE
local solid = scene.maker("ground", { static = true })
local body = scene.thing("players", { name = "body", width = 16, height = 24, maxSlope = 1 })

local function slope(x, y, width, height, name, fields)
  local entry = solid(fields and "moving" or "slope", x, y, width, height, fields)
  entry[2].slope = name or "right"
  return entry
end

--- The body at a place, and what else there is.
local function at(x, y, fields, ...)
  local entry = body(fields)
  entry[2].x, entry[2].y = x, y
  return { gravity = 800, solid("flat", -400, 400, 500, 40), entry, ... }
end

local row = play.row

describe("maxSlope: walls", function()
  -- A ramp with a plateau behind it.
  local function newRamp(v)
    local top = solid("top", 100 + v.run, 400 - v.rise, 300, v.rise)
    return at(20, 376, nil, slope(100, 400 - v.rise, v.run, v.rise), top)
  end

  row("stop a walker of {speed} px/s at {rise} px in {run}", EVERYWHERE, newRamp, {
    { 1, keep = "body.vx = speed", "body.y ~ 376" },
    "body at 84, 376",
    "body.vx == 0; body.vy == 0",
    "body touches bottom, right; body.touching.right == slope",
  }, {
    "speed, rise, run",
    { 100, 102, 100 },
    { 200, 200, 50 },
    { 2000, 200, 10 },
    { 400, 30, 20 },
  })

  row("let a walker up that are no steeper: {rise} px in {run}", EVERYWHERE, newRamp, {
    { 2, keep = "body.vx = 120", "body touches bottom" },
    "body at 260, 376 - rise",
  }, { "rise, run", { 50, 100 }, { 100, 100 } })

  row("are no walls for others with a higher limit", EVERYWHERE, function()
    local top = solid("top", 150, 200, 300, 200)
    return at(20, 376, { maxSlope = 4 }, slope(100, 200, 50, 200), top)
  end, {
    { 1, keep = "body.vx = 240" },
    "body.x > 200",
  })

  row("push when they come, and when they rise under it", EVERYWHERE, function()
    local moves = { kinematic = true, static = false, vx = -60 }
    return at(0, 376, nil, slope(76, 200, 50, 200, "right", moves))
  end, {
    2,
    "body at -60, 376",
    "body touches bottom, right",
  })
end)

describe("maxSlope: falls", function()
  -- From 150 px above the floor: its right bottom corner comes to the edge at (126, 296).
  row("go along the edge as freely as beside a wall", EVERYWHERE, function()
    return at(110, 226, nil, slope(100, 200, 50, 200))
  end, {
    { 0.5, "body.y ~ 226 + 400 * t * t, 1e-8", "body.vy ~ 800 * t, 1e-8", "body.vx == 0" },
    "body.x ~ 84 + (376 - body.y) / 4, 1e-6",
    "body touches right; body.touching.bottom == false",
    1,
    "body at 84, 376",
    "body touches bottom, right",
  })

  -- Six slopes over each other, in one line of 600 px.
  row("snag on no seam, and pass the foot straight", EVERYWHERE, function()
    local list = at(305, 200, nil)
    for n = 0, 5 do
      list[#list + 1] = slope(300 - 30 * n, 300 + 100 * n, 30, 100)
      list[#list + 1] = solid("rock", 330 - 30 * n, 300 + 100 * n, 200, 100)
    end
    list[#list + 1] = solid("floor", 0, 900, 600, 40)
    return list
  end, {
    { 1, "body.y ~ 200 + 400 * t * t, 1e-8", "body.vy ~ 800 * t, 1e-8" },
    1,
    "body at 134, 876",
  })

  row("are not held up by `vx`, and a jump beside them is straight", EVERYWHERE, function()
    return at(84, 376, nil, slope(100, 200, 50, 200))
  end, {
    { steps = 1 },
    "body.vy = -400",
    { 0.5, "body.x ~ 84, 1e-9" },
    { 1.5, keep = "body.vx = 200" },
    "body at 84, 376",
  })

  row("end where two edges meet, without a crush", EVERYWHERE, function()
    local left, right = slope(0, 0, 100, 200, "left"), slope(100, 0, 100, 200)
    left[2].name, right[2].name = "one", "two"
    return { gravity = 800, body({ x = 52, y = -80, snap = 6 }), left, right }
  end, {
    { "listen body", 2 },
    "body at 92, 160",
    "body.vx == 0; body.vy == 0; body touches bottom, left, right",
  })

  row("begin where it walks off a top, with snap or without: {snap}", EVERYWHERE, function(v)
    local list = at(40, 176, { snap = v.snap }, slope(100, 200, 50, 200, "left"))
    list[#list + 1] = solid("top", -400, 200, 500, 200)
    list[#list + 1] = solid("low", 0, 400, 600, 40)
    return list
  end, {
    { 1.5, keep = "body.vx = 60" },
    "body.y > 180; body.y < 376",
    1,
    "body.y ~ 376; body.x > 149.999; body.touching.bottom == low",
  }, { "snap", { 0 }, { 8 } })
end)
