-- The worst cases (bench/scenes/worst/), one line each: luajit bench/worst.lua --help

local help = [[
Plays scenes that ask for the most expensive steps, and shows the bounds that hold in them.

  luajit bench/worst.lua [options]

  --only NAMES     scenes with names that begin with one of these, split by commas; NAME:N is one
                   of its sizes, also a size of your own
  --joff           LuaJIT as an interpreter; otherwise a scene is played once before, to warm up
  --both           one line with the compiler, one as an interpreter
  --root DIR       the library in this folder instead of the one beside the benchmark
  --limit SECONDS  for one scene, then it is given up; default 20
  --growth         also how the time grows from 50 to 400 objects
  --json           a line of JSON for each scene
  --here           no process of its own for each scene: for profilers; a step is not cut short
  --list           shows the scenes; other scenes of the benchmark can be named, too: swarm:300

Columns: worst, p99, median, ms a step. apart, rest: frames after the last one that is driven until
no two overlap, until nothing moves; "-": never. idle: ms, median of the last 60 steps. pairs,
deep: that overlap at the end, px. out: most that were beyond a wall in a step. jump: px, most that
a body moved in a step beyond its fastest speed in it. speed: the fastest, px/s. drift: px, how far
a player that must stand was moved. fold: of the end, equal for equal ends.
]]

local here = arg[0]:match("^(.*)bench/worst%.lua$") or error("start it as .../bench/worst.lua", 0)
here = here == "" and "." or here
package.path = here .. "/?.lua;" .. package.path

local json = require("bench.json")

local COMMAND = arg[-1] or "luajit"
local FLAGS = { joff = true, both = true, growth = true, json = true, here = true, list = true }
FLAGS.help, FLAGS.child = true, true
local VALUES = { only = true, root = true, limit = true }

local function fail(...)
  io.stderr:write("worst: ", string.format(...), "\n")
  os.exit(2)
end

local function readOptions(list)
  local chosen, i = { limit = "20" }, 1
  while list[i] do
    local name = list[i]:match("^%-%-(%w+)$")
    if FLAGS[name] then
      chosen[name] = true
    elseif VALUES[name] then
      i = i + 1
      chosen[name] = list[i] or fail("--%s needs a value", name)
    else
      fail("unknown option %s; --help shows all", list[i])
    end
    i = i + 1
  end
  chosen.limit = tonumber(chosen.limit) or fail("--limit must be a number, got %s", chosen.limit)
  return chosen
end

-- Playing one scene -------------------------------------------------------------------------------

local REPORT_EVERY = 1000 -- ms, of steps

-- Tells what is known so far now and then, in case that a step never ends.
local function newReporter()
  local sum = 0
  return function(watch, time)
    sum = sum + time
    if sum > REPORT_EVERY then
      sum = 0
      print(json.encode(watch:result()))
      io.stdout:flush()
    end
  end
end

local function play(chosen, name, n)
  local bounds, scenes = require("bench.bounds"), require("bench.scenes")
  local engine = require("bench.engines.ours")
  local jit = rawget(_G, "jit")
  if chosen.joff and jit then
    jit.off()
    jit.flush()
  end
  local onStep = chosen.child and newReporter()
  local cold
  if jit and not chosen.joff then
    cold = bounds.play(engine, scenes.build(name, n), chosen.limit / 2, onStep)
    if cold.isLimited then
      cold.ending = "given up cold"
      return cold
    end
  end
  local result = bounds.play(engine, scenes.build(name, n), chosen.limit, onStep)
  result.cold = cold and cold.worst
  result.ending = result.isLimited and "given up" or "done"
  return result
end

local function quoted(text)
  return "'" .. text:gsub("'", "'\\''") .. "'"
end

-- Plays it in a process of its own, which is ended when the time is over.
local function start(chosen, name, n, isInterpreted)
  local cut = 2 * chosen.limit -- s; the limit is processor time, and warming up may take half of it
  local words = { "timeout -k 1", ("%g"):format(cut), quoted(COMMAND) }
  words[#words + 1] = quoted(here .. "/bench/worst.lua") .. " --child"
  words[#words + 1] = ("--only %s:%d --limit %g"):format(name, n, chosen.limit)
  words[#words + 1] = isInterpreted and "--joff" or ""
  words[#words + 1] = chosen.root and "--root " .. quoted(chosen.root) or ""
  local started, last = os.time(), nil
  local pipe = io.popen(table.concat(words, " "))
  for line in pipe:lines() do
    last = line:match("^{.*}$") or last
  end
  pipe:close()
  local result = last and json.decode(last) or {}
  if not result.ending then
    result.ending = os.time() - started >= cut - 1 and "cut off" or "FAILED"
  end
  return result
end

-- Choosing ----------------------------------------------------------------------------------------

local function isWorst(definition)
  return definition.growth ~= nil
end

local function addSizes(list, definition, sizes)
  for _, n in ipairs(sizes) do
    list[#list + 1] = { name = definition.name, n = n }
  end
end

local function choose(chosen)
  local list, scenes = {}, require("bench.scenes")
  for _, definition in ipairs(scenes.list) do
    for word in (chosen.only or "all"):gmatch("[^,]+") do
      local name, n = word:match("^([^:]+):(%d+)$")
      name = name or word
      local isMeant = isWorst(definition) and not chosen.only
        or isWorst(definition) and definition.name:sub(1, #name) == name
        or definition.name == name
      if isMeant then
        addSizes(list, definition, n and { tonumber(n) } or definition.sizes)
      end
    end
  end
  if #list == 0 then
    fail("there is no scene %s; --list shows all", chosen.only)
  end
  return list
end

-- Showing -----------------------------------------------------------------------------------------

local ROW = "%-18s %-4s %8s %8s %8s %6s %5s %7s %6s %7s %4s %7s %6s %6s  %s"
local HEAD = ROW:format(
  "scene",
  "mode",
  "worst",
  "p99",
  "median",
  "apart",
  "rest",
  "idle",
  "pairs",
  "deep",
  "out",
  "jump",
  "speed",
  "drift",
  "fold"
)

local function number(format, value)
  return value and format:format(value) or "-"
end

local function milliseconds(value)
  return number(value and value >= 100 and "%.0f" or "%.2f", value)
end

local function modeName(isInterpreted)
  return isInterpreted and "off" or "jit"
end

local function show(chosen, job, result, isInterpreted)
  local isDone = result.ending == "done"
  if chosen.json then
    result.scene, result.n, result.mode = job.name, job.n, modeName(isInterpreted)
    print(json.encode(result))
  else
    print(
      ROW:format(
        job.name .. " " .. job.n,
        modeName(isInterpreted),
        milliseconds(result.worst),
        milliseconds(result.p99),
        milliseconds(result.median),
        number("%d", result.apart),
        number("%d", result.rest),
        number("%.3f", result.restTime),
        number("%d", result.pairs),
        number("%.3f", result.deepest),
        number("%d", result.outside),
        number("%.2f", result.jump),
        number("%.0f", result.fastest),
        number("%.2f", result.drift),
        isDone and ("%.0f"):format(result.fold)
          or ("%s after %d steps, limit %g s"):format(
            result.ending,
            result.steps or 0,
            chosen.limit
          )
      )
    )
  end
  io.stdout:flush()
end

local function run(chosen, job, isInterpreted)
  if chosen.here then
    return play(chosen, job.name, job.n)
  end
  return start(chosen, job.name, job.n, isInterpreted)
end

-- The exponents of one scene from 50 to 400 objects.
local function showGrowth(chosen, definition, isInterpreted)
  local counts, worst, mean = {}, {}, {}
  for _, n in ipairs(definition.growth or definition.sizes) do
    local result = run(chosen, { name = definition.name, n = n }, isInterpreted)
    if result.ending ~= "done" then
      if not chosen.json then
        local text = "%-18s %-4s given up at n = %d"
        print(text:format(definition.name, modeName(isInterpreted), n))
      end
      return
    end
    counts[#counts + 1], worst[#worst + 1], mean[#mean + 1] = n, result.worst, result.mean
  end
  local exponent = require("bench.bounds").exponent
  local figures = {}
  for i, n in ipairs(counts) do
    figures[i] = ("%d: %.2f/%.3f"):format(n, worst[i], mean[i])
  end
  local mode = modeName(isInterpreted)
  local ofWorst, ofMean = exponent(counts, worst), exponent(counts, mean)
  if chosen.json then
    local growth = { worst = ofWorst, mean = ofMean, n = counts }
    print(json.encode({ scene = definition.name, mode = mode, growth = growth }))
  else
    local text = "%-18s %-4s worst n^%.2f, mean n^%.2f   worst/mean ms at %s"
    print(text:format(definition.name, mode, ofWorst, ofMean, table.concat(figures, ", ")))
  end
  io.stdout:flush()
end

local function eachMode(chosen, call)
  if not chosen.joff then
    call(false)
  end
  if chosen.joff or chosen.both then
    call(true)
  end
end

local function growthOfAll(chosen, jobs)
  local scenes, seen = require("bench.scenes"), {}
  if not chosen.json then
    print("\nGrowth with n")
  end
  for _, job in ipairs(jobs) do
    if not seen[job.name] then
      seen[job.name] = true
      eachMode(chosen, function(isInterpreted)
        showGrowth(chosen, scenes.get(job.name), isInterpreted)
      end)
    end
  end
end

local chosen = readOptions(arg)
chosen.joff = chosen.joff or not rawget(_G, "jit")
if chosen.help then
  io.stdout:write(help)
  os.exit(0)
end
if chosen.root then
  require("bench.library")(chosen.root)
end
local jobs = choose(chosen)
if chosen.child then
  print(json.encode(play(chosen, jobs[1].name, jobs[1].n)))
  os.exit(0)
elseif chosen.list then
  for _, job in ipairs(jobs) do
    print(job.name .. ":" .. job.n)
  end
  os.exit(0)
end
if not chosen.json then
  print(HEAD)
end
local isBroken = false
for _, job in ipairs(jobs) do
  eachMode(chosen, function(isInterpreted)
    local result = run(chosen, job, isInterpreted)
    isBroken = isBroken or result.ending == "FAILED"
    show(chosen, job, result, isInterpreted)
  end)
end
if chosen.growth then
  growthOfAll(chosen, jobs)
end
os.exit(isBroken and 1 or 0)
