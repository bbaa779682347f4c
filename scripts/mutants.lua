-- Do the specs notice? Changes one thing of the core at a time (scripts/mutations.lua), in a copy
-- of the project, and runs the specs one file after the other until one fails:
--
--   luajit scripts/mutants.lua [--sample 200] [--seed 1] [--resume]
--     [--file physics/space/shapes.lua]
--
-- Without --sample all changes are tried, which takes days. Each result is written to
-- build/mutants.txt at once; --resume leaves out the changes that stand there.
--
-- It fails if more than a fifth is not noticed: about a tenth of all changes can make no difference
-- (a value that is written before it is read, a comparison with a length that no sum has).
--
-- The specs run as in `make test`. At first each spec file is run without a change, to see which
-- lines of the core it runs: only specs that run the changed line can notice the change. A spec may
-- use four times the time of the processor that it takes without a change, not of the clock: other
-- programs cannot make it fail. Left out are specs of text, of drawing and of maps, and those that
-- only compare numbers with those of an earlier version.

package.path = "./?.lua;" .. package.path

local coverage = require("scripts.coverage")
local files = require("spec.support.files")
local mutations = require("scripts.mutations")
local newRandom = require("spec.support.random").new

local options = { sample = 0, seed = 1, file = "", resume = false }
local COPY, RESULTS = "build/mutants", "build/mutants.txt"
local KNOWN = "build/mutants.marks" -- of each spec file: its seconds, then the lines that it runs
local SURVIVORS_ALLOWED = 0.2
local MEMORY = 4000000 -- kB: a change may make a loop that fills the memory
local OTHER_SPECS = { "/project/", "_draw_", "/maps_", "/slow_", "determinism" }
local COMMAND = "env PHYSICS_SPEC=quick COVERAGE=marks.txt "
  .. "luajit scripts/plain_busted.lua --no-keep-going --exclude-tags=slow "

-- Runs a command in the copy. Returns whether it succeeded, its output, and the seconds of the
-- processor that it took.
local function run(command, limit)
  local shell = 'cd %s && bash -c \'ulimit -t %d -v %d; TIMEFORMAT=":%%U %%S"; '
    .. "{ time %s </dev/null; } 2>&1; echo :$?'"
  local output = files.output(shell:format(COPY, limit, MEMORY, command))
  local text, user, system, code = output:match("^(.*):(%S+) (%S+)\n:(%d+)\n$")
  return code == "0", text, (tonumber(user) or 0) + (tonumber(system) or 0)
end

-- Runs a spec without a change, or reads what an earlier run has noted. Returns the seconds that it
-- takes, and the set of lines that it runs, nil: all, as it starts other processes.
local function measure(path, name)
  local known = KNOWN .. "/" .. name
  local file = options.resume and io.open(known)
  if file then
    file:close()
  else
    local isFine, text, seconds = run(COMMAND .. "--coverage " .. path, 3600)
    assert(isFine, "without any change:\n" .. text)
    files.write(known, seconds .. "\n" .. files.read(COPY .. "/marks.txt"))
  end
  local text, lines, source = files.read(known), {}, files.read(path)
  for line in text:gmatch("[^\n]+") do
    lines[line] = true
  end
  local startsOthers = source:find("popen", 1, true) or source:find("files.output", 1, true)
  return tonumber(text:match("^[^\n]*")), not startsOthers and lines or nil
end

local function findSpecs()
  local specs = {}
  for _, path in ipairs(files.list("find spec -name '*_spec.lua'")) do
    local isOther = false
    for _, part in ipairs(OTHER_SPECS) do
      isOther = isOther or path:find(part, 1, true)
    end
    if not isOther then
      local name = path:match("([^/]+)_spec%.lua$")
      local seconds, lines = measure(path, name)
      local spec = { path = path, name = name, seconds = seconds, lines = lines }
      spec.kills, spec.killsAt = 0, {} -- changes that it has noticed, in all and by file
      specs[#specs + 1] = spec
    end
  end
  return specs
end

-- The mark of the statement that a change is in, "physics/world/step.lua 12". nil: it is not known,
-- as the change is in another condition than the first, or behind the end of a block.
local function markOf(change)
  local last
  for _, statement in ipairs(coverage.statements(change.text)) do
    local isBefore = statement.offset <= change.at
    last = isBefore and (not last or statement.offset > last.offset) and statement or last
  end
  local between = last and change.text:sub(last.offset, change.at) or ""
  for _, word in ipairs({ "elseif", "until", "end" }) do
    last = not between:find("\n%s*" .. word .. "%f[%W]") and last or nil
  end
  return last and change.path .. " " .. last.line
end

-- The specs that may notice a change. First come quick ones, and those that have noticed much.
local function inOrder(specs, change)
  local worth, list, mark = {}, {}, markOf(change)
  for _, spec in ipairs(specs) do
    if not spec.lines or not mark or spec.lines[mark] then
      list[#list + 1] = spec
      local kills = 1 + spec.kills + 4 * (spec.killsAt[change.path] or 0)
      worth[spec] = kills / (spec.seconds + 0.1)
    end
  end
  table.sort(list, function(a, b)
    return worth[a] > worth[b] or worth[a] == worth[b] and a.name < b.name
  end)
  return list
end

-- The name of the spec that notices a change, nil: none.
local function try(specs, change)
  local by
  files.write(COPY .. "/" .. change.path, mutations.apply(change.text, change))
  for _, spec in ipairs(inOrder(specs, change)) do
    if not run(COMMAND .. spec.path, math.ceil(4 * spec.seconds) + 2) then
      spec.kills, spec.killsAt[change.path] = spec.kills + 1, (spec.killsAt[change.path] or 0) + 1
      by = spec.name
      break
    end
  end
  files.write(COPY .. "/" .. change.path, change.text)
  return by
end

-- A random choice of changes, without those that are no Lua. Each has a name:
-- "physics/space/shapes.lua:31:17 + -> -".
local function choose()
  local changes, chosen = {}, {}
  for _, path in ipairs(files.list("find physics.lua physics -name '*.lua'")) do
    if coverage.isCore(path) and (options.file == "" or path == options.file) then
      local text = files.read(path)
      for _, change in ipairs(mutations.list(text)) do
        change.path, change.text = path, text
        changes[#changes + 1] = change
      end
    end
  end
  for _, change in ipairs(newRandom(options.seed):shuffled(changes)) do
    local isWanted = options.sample == 0 or #chosen < options.sample
    if isWanted and mutations.apply(change.text, change) then
      local column = #change.text:sub(1, change.at):match("[^\n]*$")
      local name = "%s:%d:%d %s -> %s"
      change.name = name:format(change.path, change.line, column, change.old, change.new)
      chosen[#chosen + 1] = change
    end
  end
  return chosen, #changes
end

-- name -> whether it was noticed, from an earlier run
local function knownResults()
  local known, file = {}, options.resume and io.open(RESULTS)
  for line in file and file:lines() or ("").gmatch("", "x") do
    local result, name = line:match("^(%S+)[^\t]*\t(.*)$")
    known[name] = result == "noticed"
  end
  return known
end

local function main()
  os.execute("mkdir -p " .. KNOWN .. " && rm -rf " .. COPY .. " && mkdir -p " .. COPY)
  os.execute("git ls-files -z -co --exclude-standard | xargs -0 cp --parents -t " .. COPY)
  local chosen, count = choose()
  local known, specs, noticed = knownResults(), nil, 0
  local results = assert(io.open(RESULTS, options.resume and "a" or "w"))
  for n, change in ipairs(chosen) do
    local isNoticed = known[change.name]
    if isNoticed == nil then
      specs = specs or findSpecs()
      local by = try(specs, change)
      local result = by and "noticed by " .. by or "survived"
      isNoticed = by ~= nil
      results:write(result, "\t", change.name, "\n")
      results:flush()
      print(("%d of %d  %s  %s"):format(n, #chosen, result, change.name))
      io.stdout:flush()
    end
    noticed = noticed + (isNoticed and 1 or 0)
  end
  local text = "%d changes were tried of %d: %d were noticed, %d were not"
  print(text:format(#chosen, count, noticed, #chosen - noticed))
  return #chosen - noticed <= SURVIVORS_ALLOWED * #chosen
end

require("scripts.options")(options, arg)
os.exit(main() and 0 or 1)
