--- Decides what is measured, starts a process for each measurement, and collects the results.
---
--- Every measurement is a process of its own: traces, heap and caches of one engine must not
--- disturb another. The engines take turns, so that noise of the machine hits all of them.

local engines = require("bench.engines")
local json = require("bench.json")
local measure = require("bench.measure")
local options = require("bench.options")
local report = require("bench.report")
local scenes = require("bench.scenes")
local statistics = require("bench.statistics")

local app = {}

local QUICK_STEPS, QUICK_WARM_UP = 3, 2

local function say(...)
  io.stderr:write(string.format(...), "\n")
end

-- Without LÖVE, and in another Lua, love.physics is not there.
local function isLoveMode(host, mode)
  return host.isLove and (mode == "jit" or mode == "off")
end

local function setMode(mode)
  local jit = rawget(_G, "jit")
  if not jit then
    return
  end
  jit.flush()
  if mode == "off" then
    jit.off()
  else
    jit.on()
  end
end

-- One measurement in this process.
local function play(kind, job, limit)
  local scene = scenes.build(job.scene, job.n)
  scene.steps, scene.warmUp = job.steps or scene.steps, job.warmUp or scene.warmUp
  setMode(job.mode)
  return measure[kind](require("bench.engines." .. job.engine), scene, limit)
end

local function quoted(text)
  return "'" .. text:gsub("'", "'\\''") .. "'"
end

-- The words that start this program in a mode. A mode that is a command may have words of its own.
local function commandOf(host, mode)
  if mode ~= "jit" and mode ~= "off" then
    return { mode, quoted(host.root .. "/bench/run.lua") }
  end
  local words = {}
  for i, word in ipairs(host.command) do
    words[i] = quoted(word)
  end
  return words
end

-- One measurement in a process of its own.
local function start(host, chosen, kind, job)
  local parts = commandOf(host, job.mode)
  parts[#parts + 1] = string.format("--child %s --scene %s", kind, job.scene)
  parts[#parts + 1] = string.format("--n %d --engine %s", job.n, job.engine)
  parts[#parts + 1] = string.format("--mode %s --limit %g", quoted(job.mode), chosen.limit)
  if job.steps then
    parts[#parts + 1] = "--steps " .. job.steps
  end
  if chosen.path then
    parts[#parts + 1] = "--path " .. quoted(chosen.path)
  end
  local pipe = io.popen(table.concat(parts, " "))
  local output = pipe:read("*a")
  pipe:close()
  local line = output:match("({[^\n]*})%s*$")
  if not line then
    return { failure = "it failed: " .. table.concat(parts, " ") }
  end
  return json.decode(line)
end

local function sizesOf(chosen, definition)
  if chosen.quick then
    return { definition.quick }
  end
  return chosen.sizes or definition.sizes
end

-- Whether an engine takes part, and why not.
local function admit(host, job)
  local engine, reason = engines.get(job.engine, isLoveMode(host, job.mode))
  return engine and engines.refusal(engine, scenes.build(job.scene, job.n)) or reason
end

-- The jobs of one scene and size: all modes, all engines.
local function jobsOf(host, chosen, definition, n)
  local jobs = {}
  for _, mode in ipairs(chosen.modes) do
    for _, engine in ipairs(chosen.engines or engines.names) do
      local job = { scene = definition.name, n = n, mode = mode, engine = engine }
      job.steps = chosen.steps
      if chosen.quick then
        job.steps, job.warmUp = chosen.steps or QUICK_STEPS, QUICK_WARM_UP
      end
      job.skipped = admit(host, job)
      jobs[#jobs + 1] = job
    end
  end
  return jobs
end

local FIGURES =
  { "median", "p99", "worst", "mean", "memory", "resident", "atLeast", "build", "slowest" }

-- The figures of all rounds become one: their median.
local function join(job)
  local last = job.runs[#job.runs]
  job.steps, job.isLimited = last.steps, last.isLimited
  for _, figure in ipairs(FIGURES) do
    local values = {}
    for _, run in ipairs(job.runs) do
      values[#values + 1] = run[figure]
    end
    job[figure] = #values > 0 and statistics.median(values) or nil
  end
  job.runs = nil
end

-- An engine that did not get through a scene does not get through a larger one either.
local function isHopeless(limited, job)
  return limited[job.scene .. job.engine .. job.mode]
end

local function isOpen(job)
  local last = job.runs and job.runs[#job.runs]
  return not job.skipped and not job.failure and not (last and last.isLimited)
end

local function playRound(jobs, run)
  for _, job in ipairs(jobs) do
    if isOpen(job) then
      local result = run("times", job)
      job.failure = result.failure
      if not result.failure then
        job.runs = job.runs or {}
        job.runs[#job.runs + 1] = result
      end
    end
  end
end

local function playQuality(jobs, run)
  for _, job in ipairs(jobs) do
    if job.runs and not job.failure then
      for figure, value in pairs(run("quality", job)) do
        job[figure] = value
      end
    end
  end
end

local function measureSize(jobs, rounds, run, limited)
  for _, job in ipairs(jobs) do
    if not job.skipped and isHopeless(limited, job) then
      job.skipped, job.isLimited = "gave up at a smaller size", true
    end
  end
  for _ = 1, rounds do
    playRound(jobs, run)
  end
  playQuality(jobs, run)
  for _, job in ipairs(jobs) do
    if job.runs then
      join(job)
      limited[job.scene .. job.engine .. job.mode] = job.isLimited
    end
  end
end

-- Measures everything that was chosen; `onSize(jobs)` is told after each scene and size.
local function measureAll(host, chosen, onSize)
  local function run(kind, job)
    if chosen.quick then
      return play(kind, job, chosen.limit)
    end
    return start(host, chosen, kind, job)
  end
  local limited, results = {}, {}
  for _, definition in ipairs(scenes.list) do
    if report.isChosen(chosen.scenes, definition.name) then
      for _, n in ipairs(sizesOf(chosen, definition)) do
        local jobs = jobsOf(host, chosen, definition, n)
        measureSize(jobs, chosen.quick and 1 or chosen.rounds, run, limited)
        for _, job in ipairs(jobs) do
          results[#results + 1] = job
        end
        onSize(jobs)
      end
    end
  end
  return results
end

local function list()
  for _, definition in ipairs(scenes.list) do
    local sizes = table.concat(definition.sizes, ", ")
    print(string.format("%-12s %s (n: %s)", definition.name, definition.title, sizes))
  end
  print("engines: " .. table.concat(engines.names, ", "))
end

local function playChild(chosen)
  local job = { scene = chosen.scenes[1], n = chosen.sizes[1], engine = chosen.engines[1] }
  job.mode, job.steps = chosen.modes[1], chosen.steps
  print(json.encode(play(chosen.child, job, chosen.limit)))
  return 0
end

local function countFailures(results, isQuick)
  local failures = 0
  for _, job in ipairs(results) do
    if isQuick and not job.skipped and not job.median then
      job.failure = string.format("%s with %s: no figures", job.scene, job.engine)
    end
    if job.failure then
      failures = failures + 1
      say("bench: %s", job.failure)
    end
  end
  return failures
end

local function playAll(host, chosen)
  local results = measureAll(host, chosen, function(jobs)
    if not chosen.json then
      report.print(jobs)
    else
      say("%s %d", jobs[1].scene, jobs[1].n)
    end
  end)
  if chosen.json then
    print(json.encode({ machine = report.machine(host), results = results }))
  end
  return countFailures(results, chosen.quick) == 0 and 0 or 1
end

--- Runs the benchmark.
---@param arguments string[] the command line
---@param host table `root` folder of the library, `command` words that start this program
---again, `isLove`
---@return integer code for the shell
function app.main(arguments, host)
  local isRead, chosen = pcall(options.read, arguments)
  if not isRead then
    say("%s", chosen)
    return 1
  end
  if chosen.path then
    package.path = chosen.path .. "/?.lua;" .. chosen.path .. "/?/init.lua;" .. package.path
  end
  if chosen.help then
    io.stdout:write(options.help)
    return 0
  elseif chosen.list then
    list()
    return 0
  end
  return chosen.child and playChild(chosen) or playAll(host, chosen)
end

return app
