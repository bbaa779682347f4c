--- Gravity upwards and sideways: the same scene, turned round, goes the same way.

local newRandom = require("spec.support.random").new
local play = require("spec.support.play")
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
    turn = { 2, 1, 3 }, -- the quick specs of LuaJIT play the second one
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
  return scene.maker("boxes", fields)(name, x, y, fields.width or 16, fields.height or 16)
end

describe("gravity and gravityX: up, left and right is down, turned round:", function()
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

  local LEVELS = { turn = variants.TURNS, rate = variants.RATES }
  play.row("a body falls by ({gravityX}, {gravity}) px/s²", LEVELS, function(v)
    return { gravityX = v.gravityX, gravity = v.gravity, box("body", 0, 0, {}) }
  end, {
    { 1, "body at gravityX / 2 * t * t, gravity / 2 * t * t" },
  }, { "gravityX, gravity", { 300, 800 }, { 0, 0 } })
end)
