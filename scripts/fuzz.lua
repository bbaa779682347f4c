-- Random games (spec/fuzz/), checked after every step, until the time is over:
--
--   luajit scripts/fuzz.lua --seconds 60 [--seed 1] [--steps 80] [--keep-going]
--     [--slopes]
--
-- `--slopes`: games with slopes (spec/fuzz/sloped.lua).
--
-- `--game NAME` (or all): games of the kinds that are made, a platformer, survivors, breakout,
-- marbles, Sokoban, a factory, caves, an arena (spec/fuzz/games.lua), `--games N` of each kind.
--
-- A case that fails is made small and printed, for spec/fuzz/found.txt. Its seed
-- plays it again: `--seed N --seconds 0` plays that one only, `--case FILE` one that was written
-- down.

package.path = "./?.lua;" .. package.path

-- Every world is another one: with the usual limits the compiler would spend its time on throwing
-- traces away, and on compiling each variant of a loop.
local jit = rawget(_G, "jit")
if jit and jit.opt then
  jit.opt.start("maxtrace=20000", "maxmcode=60000", "sizemcode=256", "maxirconst=2000")
  jit.opt.start("hotloop=300", "hotexit=200")
end

require("spec.support.pairs")

local case = require("spec.fuzz.case")
local games = require("spec.fuzz.games")
local shrink = require("spec.fuzz.shrink")
local sloped = require("spec.fuzz.sloped")
local states = require("spec.support.states")
local trial = require("spec.fuzz.trial")

local options = {
  seconds = 60,
  seed = 1,
  steps = 80,
  ["keep-going"] = false,
  shrink = 30,
  case = "",
  slopes = false,
  game = "",
  games = 100,
}

local function newCase(seed)
  return (options.slopes and sloped or case).new(seed, options.steps)
end

local function report(seed, failed, failure)
  print(("FAILED  seed %d: %s: %s"):format(seed, failure.check, failure.text))
  local small, its = shrink.run(failed, failure, options.shrink, trial.run)
  print(("        made small: %s: %s"):format(its.check, its.text))
  print(states.write(small))
  io.stdout:flush()
end

local function run()
  local seed, played, failed, steps = options.seed, 0, 0, 0
  local stop = os.time() + options.seconds
  repeat
    local one = newCase(seed)
    local failure, count = trial.run(one)
    played, steps = played + 1, steps + count
    if failure then
      failed = failed + 1
      report(seed, one, failure)
      if not options["keep-going"] then
        break
      end
    end
    seed = seed + 1
  until os.time() >= stop
  local text = "%d games, %d updates, seeds %d to %d: %d passed, %d failed"
  print(text:format(played, steps, options.seed, seed - 1, played - failed, failed))
  print(("%d passed, %d failed"):format(played - failed, failed))
  return failed == 0
end

-- Plays the case in a file, which holds what was printed.
local function replay(path)
  local file = assert(io.open(path))
  local chunk = assert((loadstring or load)("return " .. file:read("*a")))
  file:close()
  local failure = trial.run(chunk())
  if failure then
    print(("%s: %s (act %d)"):format(failure.check, failure.text, failure.at))
  end
  print(failure and "0 passed, 1 failed" or "1 passed, 0 failed")
  return not failure
end

-- Plays games of some kinds.
local function playKinds(names)
  local passed, failed = 0, 0
  for _, kind in ipairs(names) do
    for seed = options.seed, options.seed + options.games - 1 do
      local failure = games.play(kind, seed)
      if failure then
        failed = failed + 1
        local text = "FAILED  %s, seed %d, frame %d: %s: %s"
        print(text:format(kind, seed, failure.at, failure.check, failure.text))
      else
        passed = passed + 1
      end
    end
    print(("%s: %d games"):format(kind, options.games))
  end
  print(("%d passed, %d failed"):format(passed, failed))
  return failed == 0
end

require("scripts.options")(options, arg)
if options.game ~= "" then
  os.exit(playKinds(options.game == "all" and games.kinds or { options.game }) and 0 or 1)
end
if options.case ~= "" then
  os.exit(replay(options.case) and 0 or 1)
end
os.exit(run() and 0 or 1)
