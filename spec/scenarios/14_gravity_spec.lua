--- Gravity upwards and sideways: the same scene, turned round, goes the same way.

local newRandom = require("spec.support.random").new
local scene = require("spec.support.scene")
local variants = require("spec.support.variants")

--- Where everything is, step by step, when gravity points down.
local function record(description, seconds, level)
  local run = scene.run(level)
  run:build(description)
  local track = {}
  for _ in run:steps(seconds) do
    local frame = {}
    for name, view in pairs(run.named) do
      frame[name] = { view.x, view.y, view.vx, view.vy }
    end
    track[#track + 1] = frame
  end
  return track
end

--- The same with gravity up, left and right: each object within 1e-6 px at every step, or `near`
--- px.
local function checkTurned(description, seconds, near)
  local levels = {
    shift = { 0, 0.1 },
    order = { "forward" },
    turn = { 1, 2, 3 },
    rate = { 60, 144 },
  }
  local tracks = {}
  scene.each(levels, function(run)
    local key = run.push .. run.rate
    if not tracks[key] then
      local level = { shift = 0, order = "forward", broadphase = "pairs", turn = 0 }
      level.push, level.rate = run.push, run.rate
      tracks[key] = record(description, seconds, level)
    end
    local named, step = run:build(description), 0
    for _ in run:steps(seconds) do
      step = step + 1
      for name, place in pairs(tracks[key][step]) do
        run:near(name .. ".x", named[name].x, place[1], near)
        run:near(name .. ".y", named[name].y, place[2], near)
        local speed = near and near * run.rate
        run:near(name .. ".vx", named[name].vx, place[3], speed)
        run:near(name .. ".vy", named[name].vy, place[4], speed)
      end
    end
  end)
end

local FLOOR = { "tiles", { x = -500, y = 200, width = 1500, height = 32, static = true } }

local function box(name, x, y, fields)
  local object = { name = name, x = x, y = y, width = 16, height = 16 }
  for key, value in pairs(fields or {}) do
    object[key] = value
  end
  return { "boxes", object }
end

describe("gravity up, left and right is gravity down, turned round:", function()
  it("boxes of several masses fall on each other", function()
    local description = { FLOOR }
    for i, mass in ipairs({ 1, 0.25, 8, 2, 100, 0.5 }) do
      description[i + 1] = box("box" .. i, 100 + 3 * i, 190.5 - 25.25 * i, { mass = mass })
    end
    checkTurned(description, 2)
  end)

  it("boxes rub on a floor and on each other", function()
    checkTurned({
      FLOOR,
      box("low", 0, 184, { vx = 200, friction = 0.5 }),
      box("high", 4, 168, { vx = -50, friction = 0.25 }),
      box("alone", -100, 184, { vx = -130, friction = 0.75 }),
    }, 2)
  end)

  it("boxes bounce down stairs", function()
    local description = { FLOOR }
    for i = 1, 6 do
      local step = { x = 32 * i, y = 32 * i - 16, width = 32, height = 32, static = true }
      description[#description + 1] = { "tiles", step }
    end
    description[#description + 1] = box("slow", 33, -60, { vx = 45, restitution = 0.5 })
    description[#description + 1] = box("fast", 35, -90, { vx = 85, restitution = 0.75 })
    checkTurned(description, 3)
  end)

  it("a jump under a ceiling and on to a one-way", function()
    checkTurned({
      FLOOR,
      { "tiles", { x = 0, y = 110, width = 80, height = 16, static = true } },
      { "ways", { x = 140, y = 150, width = 100, height = 8, static = true, oneWay = "top" } },
      box("head", 10, 184, { vx = 20, vy = -400 }),
      box("feet", 120, 184, { vx = 60, vy = -350 }),
    }, 2)
  end)

  it("a push against a wall", function()
    checkTurned({
      FLOOR,
      { "tiles", { x = 300, y = 0, width = 16, height = 200, static = true } },
      box("pusher", 0, 184, { ax = 300, mass = 2 }),
      box("first", 100, 184),
      box("second", 140, 184, { mass = 4 }),
      box("rider", 143, 168, { friction = 0.5 }),
    }, 4)
  end)

  it("a pile with friction", function()
    local random, description = newRandom(23), { FLOOR }
    description[2] = { "tiles", { x = -16, y = -400, width = 16, height = 600, static = true } }
    description[3] = { "tiles", { x = 160, y = -400, width = 16, height = 600, static = true } }
    for i = 0, 29 do
      -- eighths of a pixel turn without rounding
      local size = random:integer(80, 160) / 8
      local x, y = 26 * (i % 6) + random:integer(0, 40) / 8, 170 - 30 * math.floor(i / 6)
      local fields = { vx = random:integer(-160, 160) / 8, friction = 0.25 }
      fields.width, fields.height = size, random:integer(80, 160) / 8
      description[#description + 1] = box("box" .. i, x, y, fields)
    end
    -- Which of two simultaneous impacts is first depends on rounding, which turning changes.
    checkTurned(description, 3, 0.05)
  end)

  scene.it(
    "nothing falls when there is none, or where both axes have some",
    { turn = variants.TURNS, rate = variants.RATES },
    function(run)
      local named = run:build({ gravityX = 300, gravity = 800, box("body", 0, 0) })
      for time in run:steps(1) do
        run:at(named.body, 150 * time * time, 400 * time * time)
      end
      named = run:build({ gravity = 0, box("body", 0, 0) })
      for _ in run:steps(1) do
        run:at(named.body, 0, 0)
      end
    end
  )
end)
