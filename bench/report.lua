--- The results, for people.

local engines = require("bench.engines")

local report = {}

--- Whether a name is in the list, or there is no list.
function report.isChosen(names, name)
  for _, chosen in ipairs(names or { name }) do
    if chosen == name then
      return true
    end
  end
  return false
end

local UNITS = { { 1e6, "%.1f MB" }, { 1e3, "%.1f KB" } }

--- A number of bytes, short.
---@param count number?
---@return string
function report.bytes(count)
  if not count then
    return "-"
  end
  for _, unit in ipairs(UNITS) do
    if count >= unit[1] then
      return string.format(unit[2], count / unit[1])
    end
  end
  return string.format("%.0f B", count)
end

--- A number of milliseconds, with three digits that matter.
---@param ms number?
---@return string
function report.ms(ms)
  if not ms then
    return "-"
  end
  return string.format(ms < 10 and "%.3f" or ms < 100 and "%.1f" or "%.0f", ms)
end

--- The result of the same scene, size and mode with our engine, or nil.
function report.ours(results, job)
  for _, other in ipairs(results) do
    local isSame = other.scene == job.scene and other.n == job.n and other.mode == job.mode
    if isSame and other.engine == "ours" then
      return other
    end
  end
  return nil
end

--- How many times as long as ours it takes, or nil.
---@return number?
function report.ratio(results, job)
  local ours = report.ours(results, job)
  return ours and ours.median and job.median and ours.median > 0 and job.median / ours.median or nil
end

--- A depth in pixels: one digit when it is small.
---@param depth number?
---@return string
function report.pixels(depth)
  if not depth then
    return "-"
  end
  return string.format(depth == 0 and "0" or depth < 0.1 and "%.1g" or "%.1f", depth)
end

--- What is known of an engine that was given up, in ms: a frame takes more than this on average.
---@param job table
---@param unit string? what to write behind the number, default nothing
---@return string
function report.limit(job, unit)
  return "> " .. (job.atLeast and report.ms(job.atLeast) .. (unit or "") or "limit")
end

local function row(results, job)
  local ratio = report.ratio(results, job)
  local median = report.ms(job.median)
  if job.isLimited then
    median = report.limit(job)
  end
  return string.format(
    "  %-6s %-16s %9s %9s %9s %10s %9s %8s",
    job.mode,
    engines.title(job.engine),
    median,
    job.isLimited and "-" or report.ms(job.p99),
    report.ms(job.worst),
    report.bytes(job.garbage),
    report.pixels(job.overlap),
    ratio and not job.isLimited and string.format("%.1fx", ratio) or "-"
  )
end

local HEAD = string.format(
  "  %-6s %-16s %9s %9s %9s %10s %9s %8s",
  "mode",
  "engine",
  "median ms",
  "p99 ms",
  "worst ms",
  "garbage",
  "overlap",
  "to ours"
)

--- Prints the results of one scene and size as a table.
function report.print(jobs)
  print(string.format("%s %d", jobs[1].scene, jobs[1].n))
  print(HEAD)
  for _, job in ipairs(jobs) do
    if job.median or job.isLimited then
      print(row(jobs, job))
    end
  end
  print("")
  io.stdout:flush()
end

local function processor()
  local file = io.open("/proc/cpuinfo")
  local model = file and file:read("*a"):match("model name%s*:%s*([^\n]+)")
  if file then
    file:close()
  end
  return model
end

--- What the figures depend on.
---@param host table
---@return table
function report.machine(host)
  local jit = rawget(_G, "jit")
  return {
    lua = jit and jit.version or _VERSION,
    processor = processor(),
    date = os.date("%Y-%m-%d"),
    love = host.isLove and table.concat({ love.getVersion() }, ".", 1, 2) or nil,
  }
end

return report
