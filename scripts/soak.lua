-- Plays a busy scene (spec/support/busy.lua) for a very long time and says how it is, part by part:
--
--   luajit scripts/soak.lua --steps 10000000 [--part 500000] [--resume build/soak.lua]
--
-- After each part the state is written to build/soak.lua, from which a later run can go on. It
-- fails if an object is lost, and at the end if the memory or the time of a step has grown.
--
-- Pools and lists keep the size that they once needed, and grow by powers of two. So the memory
-- goes up where the scene needs more than ever before, and that becomes rarer and rarer. A leak
-- goes on: so the last part is compared with the one at half time.

package.path = "./?.lua;" .. package.path

local busy = require("spec.support.busy")
local files = require("spec.support.files")
local states = require("spec.support.states")

local PATH = "build/soak.lua"
-- What the last part may need, compared with the one at half time.
local MORE_MEMORY, MORE_TIME = 1.05, 1.5

local options = { steps = 1000000, part = 100000, resume = "" }

local function store(world, n)
  os.execute("mkdir -p build")
  files.write(PATH, "return " .. states.write({ step = n, state = world:save() }) .. "\n")
end

local function play(world, from, to)
  local started = os.clock()
  for n = from, to do
    busy.step(world, n)
  end
  return (os.clock() - started) / (to - from + 1) * 1e6
end

local function run()
  local world, first = busy.new(), 1
  if options.resume ~= "" then
    local stored = dofile(options.resume)
    world:restore(stored.state)
    first = stored.step + 1
  end
  print("      steps   us/step        kB   objects   pairs   hash")
  local times, sizes = {}, {}
  for from = first, first + options.steps - 1, options.part do
    local to = math.min(from + options.part, first + options.steps) - 1
    local microseconds, size = play(world, from, to), busy.memory()
    local stats = world.stats
    local line = "%11d %9.1f %9.0f %9d %7d   %.0f"
    print(line:format(to, microseconds, size, stats.objects, stats.pairs, world:hash()))
    io.stdout:flush()
    local complaint = busy.complaint(world)
    if complaint then
      print("FAILED  after " .. to .. " steps: " .. complaint)
      return false
    end
    store(world, to)
    times[#times + 1], sizes[#sizes + 1] = microseconds, size
  end
  local half, last = math.ceil(#times / 2), #times
  local isFlat = sizes[last] <= MORE_MEMORY * sizes[half] and times[last] <= MORE_TIME * times[half]
  print(isFlat and "1 passed, 0 failed" or "FAILED  it has grown\n0 passed, 1 failed")
  return isFlat
end

require("scripts.options")(options, arg)
os.exit(run() and 0 or 1)
