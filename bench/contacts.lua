-- How exact contacts are, over random scenes (bench/contacts/), a line for each row:
-- luajit bench/contacts.lua --help

local help = [[
Plays random scenes of slopes, circles and boxes, and compares the worst figure of them with an aim.

  luajit bench/contacts.lua [options]

  --only NAMES  subjects with names that begin with one of these, split by commas
  --scenes N    number of scenes of each subject, instead of its own
  --seed N      plays one scene of each, and prints every step
  --verbose     also the seeds that miss an aim
  --quick       few scenes: does it run?
  --root DIR    the library in this folder instead of the one beside the benchmark
  --help        shows this

Columns: subject, scenes, the figure, the worst of all scenes, its aim (at most), and how many
scenes miss it.
]]

local here = arg[0]:match("^(.*)bench/contacts%.lua$")
  or error("start it as .../bench/contacts.lua", 0)
package.path = (here == "" and "." or here) .. "/?.lua;" .. package.path

local FILES = {
  "rooms",
  "wedges",
  "crates",
  "racks",
  "marbles",
  "crowds",
  "pits",
  "slopes",
  "presses",
  "walls",
  "crushes",
  "forces",
  "added",
  "movers",
  "limits",
  "orders",
  "costs",
}
local QUICK = 1 / 40 -- of the scenes

local options = {
  only = "",
  scenes = 0,
  seed = 0,
  verbose = false,
  quick = false,
  root = "",
  help = false,
}
require("scripts.options")(options, arg)
if options.help then
  io.write(help)
  os.exit(0)
end
if options.root ~= "" then
  require("bench.library")(options.root)
end

local newScene = require("bench.contacts.scene").new

local function isMeant(name)
  for word in options.only:gmatch("[^,]+") do
    if name:sub(1, #word) == word then
      return true
    end
  end
  return options.only == ""
end

-- Prints the lines of a subject; `missed` has a line for each scene that misses a row, `measured`
-- how often a row was measured.
local function report(subject, count, worst, missed, measured)
  for _, row in ipairs(subject.rows) do
    local text, aim = row[1], row[2]
    local lines = missed[text]
    local verdict = #lines == 0 and "met" or "missed by " .. #lines
    verdict = measured[text] > 0 and verdict or "not measured"
    local line = "%-12s %5d  %-38s %9.3g  aim %-8.3g  %s"
    print(line:format(subject.name, count, text, worst[text], aim, verdict))
    for _, one in ipairs(options.verbose and lines or {}) do
      print(one)
    end
  end
  io.stdout:flush()
end

local function play(subject)
  local count = options.scenes > 0 and options.scenes or subject.count
  local first = options.seed > 0 and options.seed or 1
  count = options.quick and math.ceil(QUICK * count) or count
  count = options.seed > 0 and 1 or count
  local worst, missed, measured = {}, {}, {}
  for _, row in ipairs(subject.rows) do
    worst[row[1]], missed[row[1]], measured[row[1]] = 0, {}, 0
  end
  for seed = first, first + count - 1 do
    local scene = newScene(subject, seed, options.seed > 0)
    subject.play(scene)
    for _, row in ipairs(subject.rows) do
      local text, value = row[1], scene.values[row[1]]
      worst[text] = math.max(worst[text], value)
      measured[text] = measured[text] + (scene.counts[text] or 0)
      if value > row[2] then
        local line = "             seed %d: %.4g, frame %d at %d Hz"
        table.insert(missed[text], line:format(seed, value, scene.frames[text], scene.hz))
      end
    end
  end
  report(subject, count, worst, missed, measured)
end

local played = 0
for _, file in ipairs(FILES) do
  for _, subject in ipairs(require("bench.contacts." .. file)) do
    if isMeant(subject.name) then
      play(subject)
      played = played + 1
    end
  end
end
if played == 0 then
  error("--only " .. options.only .. ": there is no such subject", 0)
end
print(("%.0f s"):format(os.clock()))
