-- Do the specs notice? Changes one thing of the core at a time (scripts/mutations.lua), in a copy
-- of the project, and runs the specs one file after the other until one fails:
--
--   luajit scripts/mutants.lua [--sample 200] [--seed 1] [--file physics/space/shapes.lua]
-- [--resume] [--slow] [--seconds 15]
--
-- Without --sample all changes are tried, which takes days; --list shows them. Each result is
-- written to build/mutants.txt at once; --resume leaves out what that file says was noticed by a
-- spec. With --seconds a change that is not noticed within that time of the
-- processor is put off: a later run with --resume tries it, and what has survived, with all specs.
-- A result is one of these:
--
-- - noticed: by a spec that says what is right.
-- - by numbers: by the scene with everything in it and determinism_spec.lua alone. They only say
--   that something has changed.
-- - survived: not noticed.
-- - put off: not noticed in the time.
--
-- It fails if more than a fifth is of the last three kinds: about a tenth of all changes can make
-- no difference (a value that is written before it is read, a comparison with a length that no sum
-- has).
--
-- The specs run as in `make test`; with --slow also those with that tag (spec/slow.lua). At first
-- each spec file is run without a change, to see which lines of the core it runs: only those that
-- run the changed line can notice the change. A spec may use four times the time of the processor
-- that it takes without a change, not of the clock: what else the machine does cannot make it fail.
-- Specs of text alone are left out: that a page of the docs is old does not show that a wrong
-- default value would be missed.

package.path = "./?.lua;" .. package.path

local coverage = require("scripts.coverage")
local mutations = require("scripts.mutations")
local tokens = require("scripts.tokens")
local newRandom = require("spec.support.random").new

local options = { sample = 0, seed = 1, file = "", list = false, resume = false }
options.slow, options.seconds = false, 0
local COPY = "build/mutants"
local MARKS = "marks.txt" -- in the copy
local KNOWN = "build/mutants.marks" -- the same of each spec file, and how long it takes
local RESULTS = "build/mutants.txt"
local SURVIVORS_ALLOWED = 0.2
local MEMORY = 4000000 -- kB: a change may make a loop that fills the memory

-- Not the core: drawing, maps, types for editors.
local NOT_CORE = { "/draw", "/maps/", "/types" }

-- What looks at files, at LÖVE or at times, not at what the core does.
local OTHER_SPECS = { "bench", "draw", "manual", "mutations", "portable", "rockspec", "tiled" }
OTHER_SPECS[#OTHER_SPECS + 1], OTHER_SPECS[#OTHER_SPECS + 2] = "plain_busted", "slow_spec"

-- What only compares with numbers of an earlier version.
local NUMBERS = { everything = true, determinism = true }

-- file -> the specs to begin with, besides those that have noticed changes there
local FIRST = {
  restore = { "state_restore", "state", "recovery" },
  validate = { "state_damaged", "state", "recovery" },
  hash = { "state", "state_restore" },
  explain = { "debugging" },
  bounds = { "world" },
  pairFinder = { "settings" },
  fields = { "settings" },
  settings = { "fields", "fields_at_run_time" },
  checked = { "debugging" },
  read = { "fields_at_run_time", "objects", "recovery" },
  registry = { "objects", "objects_order", "recovery" },
  islands = { "rest" },
  compiler = { "interpreted" },
  tutorial = { "world_tutorial", "shapes" },
  ball = { "26_balls", "queries_circles" },
  shapes = { "shapes", "18_slopes", "queries_circles" },
  lines = { "shapes", "queries_rays" },
  slope = { "18_slopes", "slopes" },
  walk = { "18_slopes", "slopes" },
  drift = { "filters_soft" },
  crowd = { "20_crowds" },
  pressed = { "08_crushing" },
  snap = { "24_snap" },
  nudge = { "16_nudge" },
  flow = { "contacts_friction", "friction_in_stacks" },
  bonds = { "contacts_friction" },
  impact = { "contacts", "12_momentum", "09_rest_and_bounce" },
  carriers = { "06_riding" },
  forces = { "10_free_motion", "motion_by_hand" },
  contactState = { "events", "filters" },
  write = { "events" },
  array = { "maps_tiles" },
}

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("*a")
  file:close()
  return text
end

local function save(path, text, mode)
  local file = assert(io.open(path, mode or "wb"))
  file:write(text)
  file:close()
end

local function linesOf(command)
  local pipe, list = assert(io.popen(command)), {}
  for line in pipe:lines() do
    list[#list + 1] = line
  end
  pipe:close()
  return list
end

local function isAny(path, words)
  for _, word in ipairs(words) do
    if path:find(word, 1, true) then
      return true
    end
  end
  return false
end

-- What can be changed -----------------------------------------------------------------------------

-- "physics/space/shapes.lua:31:17 + -> -", which names a change, and the line.
local function describe(change)
  local text = change.text
  local start = text:sub(1, change.at - 1):match("^.*\n()") or 1
  local column = change.at - start + 1
  local line = text:sub(start):match("^%s*([^\n]*)")
  local name = ("%s:%d:%d %s -> %s"):format(
    change.path,
    change.line,
    column,
    change.old,
    change.new == "" and "nothing" or change.new
  )
  return name, line
end

local function findChanges()
  local changes = {}
  local paths = linesOf("ls physics.lua; find physics -name '*.lua' | LC_ALL=C sort")
  for _, path in ipairs(paths) do
    if not isAny(path, NOT_CORE) then
      local text = read(path)
      for _, change in ipairs(mutations.list(text)) do
        change.path, change.text = path, text
        changes[#changes + 1] = change
      end
    end
  end
  return changes
end

-- Running specs -----------------------------------------------------------------------------------

-- Runs a command in the copy. Returns whether it succeeded, its output, and the seconds of the
-- processor that it took.
local function run(command, limit)
  local shell = 'cd %s && bash -c \'ulimit -t %d -v %d; TIMEFORMAT=":%%U %%S"; '
    .. "{ time %s </dev/null; } 2>&1; echo :$?'"
  local lines = linesOf(shell:format(COPY, limit, MEMORY, command))
  local code = table.remove(lines)
  local user, system = (table.remove(lines) or ""):match("^:(%S+) (%S+)$")
  return code == ":0", table.concat(lines, "\n"), (tonumber(user) or 0) + (tonumber(system) or 0)
end

-- path -> set of the lines that were run, from what scripts/coverage_marks.lua has written
local function linesIn(text)
  local lines = {}
  for path, line in text:gmatch("([^\n]*) (%d+)\n") do
    lines[path] = lines[path] or {}
    lines[path][tonumber(line)] = true
  end
  return lines
end

-- The scene with everything in it prints one number.
local function newScene()
  local command = "luajit -joff spec/support/everything.lua"
  local isFine, number, seconds = run(command, 600)
  assert(isFine, number)
  local scene = { name = "everything", seconds = seconds, kills = 0, killsAt = {} }
  function scene.passes()
    local isWell, text = run(command, math.ceil(4 * seconds) + 2)
    return isWell and text == number
  end
  return scene
end

-- What starts another process runs lines that its own marks do not show.
local function startsProcesses(path)
  local text = read(path)
  return text:find("popen", 1, true) or text:find("os.execute", 1, true)
end

-- Runs a spec without a change. Returns the seconds that it takes, and what it has marked, "": all.
local function measure(command, path)
  local isFine, text, seconds = run(command .. "--coverage " .. path, 3600)
  local marks = isFine and not startsProcesses(path) and read(COPY .. "/" .. MARKS) or ""
  if not isFine then
    isFine, text, seconds = run(command .. path, 3600)
  end
  assert(isFine, "without any change:\n" .. text)
  return seconds, marks
end

-- The same from an earlier run with --resume, or for it.
local function measured(command, path, name)
  local file = options.resume and io.open(KNOWN .. "/" .. name)
  if file then
    local seconds, marks = file:read("*n", "*a")
    file:close()
    return seconds, marks:sub(2)
  end
  local seconds, marks = measure(command, path)
  os.execute("mkdir -p " .. KNOWN)
  save(KNOWN .. "/" .. name, seconds .. "\n" .. marks)
  return seconds, marks
end

local function newSpec(path)
  local command = "luajit scripts/plain_busted.lua --no-keep-going "
    .. (options.slow and "" or "--exclude-tags=slow ")
  local effort = options.slow and "full" or "quick"
  command = ("env PHYSICS_SPEC=%s COVERAGE=%s %s"):format(effort, MARKS, command)
  local name = path:match("([^/]+)_spec%.lua$")
  local seconds, marks = measured(command, path, name)
  local spec = { name = name, seconds = seconds, kills = 0, killsAt = {} }
  spec.lines = marks ~= "" and linesIn(marks) or nil
  function spec.passes()
    return (run(command .. path, math.ceil(4 * seconds) + 2))
  end
  return spec
end

local function findSpecs()
  local specs = { newScene() }
  for _, path in ipairs(linesOf("find spec -name '*_spec.lua' | LC_ALL=C sort")) do
    if not isAny(path, OTHER_SPECS) then
      specs[#specs + 1] = newSpec(path)
    end
  end
  return specs
end

-- The line with the mark of the statement that a change is in. nil: it is not known, as what
-- begins its line is no statement, but the end of one or another condition.
local function markedLine(change)
  local marked, firsts, before = {}, {}, 0
  for _, token in ipairs(coverage.statements(change.text)) do
    marked[token.line] = true
  end
  for _, token in ipairs(tokens.list(change.text)) do
    if token.line > before then
      firsts[token.line], before = token.text, token.line
    end
  end
  for line = change.line, 1, -1 do
    if marked[line] then
      return line
    elseif firsts[line] == "elseif" or firsts[line] == "until" or firsts[line] == "end" then
      return nil
    end
  end
end

local function mayNotice(spec, change, line)
  local lines = spec.lines and line and spec.lines[change.path]
  return not spec.lines or not line or lines and lines[line]
end

-- Quick specs, those of this file, and those that have noticed much, above all there, come first;
-- those that only compare numbers come last.
local function worth(spec, base, isFirst)
  if NUMBERS[spec.name] then
    return spec.name == "everything" and -1 or -2
  end
  local isOwn = spec.name == base or isFirst[spec.name]
  local kills = 1 + spec.kills + 4 * (spec.killsAt[base] or 0) + (isOwn and 10 or 0)
  return kills / (spec.seconds + 0.1)
end

local function inOrder(specs, change)
  local base = change.path:match("([^/]+)%.lua$")
  local isFirst, worthOf, list, line = {}, {}, {}, markedLine(change)
  for _, name in ipairs(FIRST[base] or {}) do
    isFirst[name] = true
  end
  for _, spec in ipairs(specs) do
    if mayNotice(spec, change, line) then
      list[#list + 1], worthOf[spec.name] = spec, worth(spec, base, isFirst)
    end
  end
  table.sort(list, function(a, b)
    if worthOf[a.name] ~= worthOf[b.name] then
      return worthOf[a.name] > worthOf[b.name]
    end
    return a.name < b.name
  end)
  return list, base
end

-- The name of the spec that fails, nil: none. The second result: there was no time for all.
local function noticed(specs, change)
  local list, base = inOrder(specs, change)
  local spent = 0
  for _, spec in ipairs(list) do
    if options.seconds > 0 and spent > options.seconds then
      return nil, true
    end
    spent = spent + spec.seconds
    if not spec.passes() then
      spec.kills, spec.killsAt[base] = spec.kills + 1, (spec.killsAt[base] or 0) + 1
      return spec.name
    end
  end
end

-- All of it ---------------------------------------------------------------------------------------

-- A random choice of them, without those that are no Lua.
local function choose(changes)
  local chosen = {}
  for _, change in ipairs(newRandom(options.seed):shuffled(changes)) do
    if #chosen == options.sample and options.sample > 0 then
      break
    end
    local isWanted = options.file == "" or change.path == options.file
    if isWanted and mutations.apply(change.text, change) then
      chosen[#chosen + 1] = change
    end
  end
  return chosen
end

-- name -> result, from an earlier run
local function knownResults()
  local known, file = {}, options.resume and io.open(RESULTS)
  if file then
    for line in file:lines() do
      local result, name = line:match("^([^\t]+)\t([^\t]+)")
      known[name] = result
    end
    file:close()
  else
    save(RESULTS, "")
  end
  return known
end

local function try(specs, change)
  save(COPY .. "/" .. change.path, mutations.apply(change.text, change))
  local by, isLate = noticed(specs, change)
  save(COPY .. "/" .. change.path, change.text)
  local none = isLate and "put off" or "survived"
  return NUMBERS[by] and "by numbers" or by and "noticed by " .. by or none
end

local function verdict(result)
  return (result == "survived" or result == "put off" or result == "by numbers") and result
    or "noticed"
end

-- Returns how many have each verdict.
local function tryAll(chosen)
  local known, specs = knownResults(), nil
  local counts = { noticed = 0, survived = 0 }
  counts["by numbers"], counts["put off"] = 0, 0
  local isQuick = options.seconds > 0
  for n, change in ipairs(chosen) do
    local name, line = describe(change)
    local result = known[name]
    local was = result and verdict(result)
    local isOpen = was == "survived" or was == "by numbers" or was == "put off"
    if not result or (isOpen and not isQuick) then
      specs = specs or findSpecs()
      result = try(specs, change)
      save(RESULTS, ("%s\t%s\t%s\n"):format(result, name, line), "ab")
      print(("%d of %d  %s  %s  %s"):format(n, #chosen, result, name, line))
      io.stdout:flush()
    end
    local is = verdict(result)
    counts[is] = counts[is] + 1
  end
  return counts
end

local function copyProject()
  os.execute("rm -rf " .. COPY .. " && mkdir -p " .. COPY)
  os.execute("git ls-files -z -co --exclude-standard | xargs -0 cp --parents -t " .. COPY)
end

local function main()
  local changes = findChanges()
  local chosen = choose(changes)
  if options.list then
    for _, change in ipairs(chosen) do
      print((describe(change)))
    end
    return true
  end
  copyProject()
  local counts = tryAll(chosen)
  print(("%d changes were tried of %d:"):format(#chosen, #changes))
  for _, row in ipairs({
    { "noticed", "noticed by a spec" },
    { "by numbers", "noticed by nothing but numbers of an earlier version" },
    { "survived", "not noticed" },
    { "put off", "not noticed in the time" },
  }) do
    local count = counts[row[1]]
    print(("%6d  %5.1f %%  %s"):format(count, 100 * count / #chosen, row[2]))
  end
  local missed = counts.survived + counts["by numbers"] + counts["put off"]
  return missed <= SURVIVORS_ALLOWED * #chosen
end

local n = 1
while arg[n] do
  local name = arg[n]:match("^%-%-(.+)$")
  assert(options[name] ~= nil, "unknown option " .. arg[n])
  if type(options[name]) == "boolean" then
    options[name] = true
  else
    n = n + 1
    options[name] = type(options[name]) == "number" and assert(tonumber(arg[n])) or arg[n]
  end
  n = n + 1
end
os.exit(main() and 0 or 1)
