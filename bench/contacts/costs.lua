--- The instructions of circles that press to one point, by those of boxes, without the compiler.

local instructions = require("spec.support.instructions")
local newCrowd = require("spec.support.crowd").new
local scenes = require("bench.contacts.scene")

local WINDOWS = { { 60, 100 }, { 141, 150 }, { 391, 400 }, { 991, 1000 } } -- frames
local HZ = 60

local function nameOf(window)
  return ("frames %d to %d"):format(window[1], window[2])
end

-- The instructions of some frames, for each window.
local function countOf(options)
  local crowd, frame, counts = newCrowd(options), 0, {}
  local function runTo(last)
    for _ = frame + 1, last do
      crowd:step(1 / HZ)
    end
    frame = last
  end
  for n, window in ipairs(WINDOWS) do
    runTo(window[1] - 1)
    counts[n] = instructions(function()
      runTo(window[2])
    end)
  end
  return counts
end

local function play(scene)
  local options = { count = scene:each({ 50, 100, 150 }), goal = "point", drive = "vx" }
  scene:start(0, HZ)
  options.seed = scene.left
  local ofBoxes = countOf(options)
  options.balls = 1 -- all of them
  for n, count in ipairs(countOf(options)) do
    scene.frame = WINDOWS[n][2]
    scene:measure(nameOf(WINDOWS[n]), count / ofBoxes[n])
  end
end

local rows = {}
for n, window in ipairs(WINDOWS) do
  rows[n] = { nameOf(window), 2 }
end

return { scenes.subject("costs", 6, play, rows) }
