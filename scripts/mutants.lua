-- Do the specs notice? Changes one thing of the core at a time (scripts/mutations.lua), in a copy
-- of the project, and runs the specs one file after the other until one fails:
--
--   luajit scripts/mutants.lua [--sample 200] [--seed 1] [--file physics/memory/aabb.lua]
-- [--resume]
--
-- Without --sample all changes are tried, which takes days; --list shows them. What no spec notices
-- survives, and is printed. Each result is written to build/mutants.txt at once; --resume leaves
-- out what that file says was noticed, or is harmless.
--
-- Harmless are those that make no difference, which scripts/harmless.lua lists with the reason. It
-- fails if more than a tenth of all survives and is not listed there, if a spec notices what is,
-- and if a listed line is no longer to be found.
--
-- The specs run interpreted, where the slow ones are a selection (spec/support/effort.lua). A spec
-- may use four times the time of the processor that it takes without a change, not of the clock:
-- what else the machine does cannot make it fail. Specs of text alone are left out: that a page of
-- the docs is old does not show that anybody would miss a default value.

package.path = "./?.lua;" .. package.path

local harmless = require("scripts.harmless")
local mutations = require("scripts.mutations")
local newRandom = require("spec.support.random").new

local options = { sample = 0, seed = 1, file = "", list = false, resume = false }
local COPY = "build/mutants"
local RESULTS = "build/mutants.txt"
local SURVIVORS_ALLOWED = 0.1
local MEMORY = 4000000 -- kB: a change may make a loop that fills the memory

-- Not the core: drawing, maps, types for editors.
local NOT_CORE = { "/draw", "/maps/", "/types" }

-- What looks at files, at LÖVE or at times, not at what the core does.
local OTHER_SPECS =
  { "bench", "draw", "examples", "love12", "manual", "mutations", "portable", "rockspec", "tiled" }
OTHER_SPECS[#OTHER_SPECS + 1], OTHER_SPECS[#OTHER_SPECS + 2] = "plain_busted", "slow_spec"

-- file -> the specs to begin with, besides the one of the same name
local FIRST = {
  restore = { "state", "recovery" },
  validate = { "verify", "state", "recovery" },
  hash = { "state" },
  sweptAabb = { "query" },
  obstacle = { "query" },
  index = { "query" },
  explain = { "query" },
  bounds = { "world" },
  activePairs = { "settings", "fields" },
  fields = { "settings" },
  settings = { "fields", "world" },
  strictMode = { "guard" },
  read = { "fields", "world", "recovery" },
  registry = { "world", "fields", "recovery" },
  columnStore = { "column_store" },
  islands = { "rest" },
  jit = { "interpreted" },
  tutorial = { "pure", "aabb" },
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

-- "physics/memory/aabb.lua:31:17 + -> -", which names a change, and the line.
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

local function keyOf(path, line, changed)
  return ("%s:%d: %s"):format(path, line, changed)
end

-- Gives the changes that are listed as harmless their reason.
local function explain(changes)
  local byKey = {}
  for _, change in ipairs(changes) do
    byKey[keyOf(change.path, change.line, mutations.changedLine(change.text, change))] = change
  end
  for _, row in ipairs(harmless) do
    local path, line, changed, reason = row[1], row[2], row[3], row[4]
    local number = mutations.findLine(read(path), line)
    local change = number and byKey[keyOf(path, number, changed)]
    local text = "scripts/harmless.lua: in %s there is %s:\n%s"
    assert(number, text:format(path, "not one line", line))
    assert(change, text:format(path, "no change to", changed)).reason = reason
  end
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
  explain(changes)
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

-- The scene with everything in it prints one number that a spec compares: the quickest way to see
-- most changes.
local function newScene()
  local command = "luajit spec/support/everything.lua"
  local isFine, number, seconds = run(command, 600)
  assert(isFine, number)
  local scene = { name = "everything", seconds = seconds, kills = 0 }
  function scene.passes()
    local isWell, text = run(command, math.ceil(4 * seconds) + 2)
    return isWell and text == number
  end
  return scene
end

local function newSpec(path)
  local busted = "busted --lua=scripts/luajit-joff --no-keep-going --output=plainTerminal " .. path
  local isFine, text, seconds = run(busted, 3600)
  assert(isFine, "without any change:\n" .. text)
  local spec = { name = path:match("([^/]+)_spec%.lua$"), seconds = seconds, kills = 0 }
  function spec.passes()
    return (run(busted, math.ceil(4 * seconds) + 2))
  end
  return spec
end

-- Quick ones and those that have noticed much come first.
local function worth(spec)
  return (spec.kills + 1) / (spec.seconds + 0.2)
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

-- Those that are likely to notice a change of a file come first, then the scene, then the others.
local function inOrder(specs, path)
  local base = path:match("([^/]+)%.lua$")
  local turn, list = { everything = 2, [base] = 1 }, {}
  for _, name in ipairs(FIRST[base] or {}) do
    turn[name] = 1
  end
  for n, spec in ipairs(specs) do
    list[n] = spec
  end
  table.sort(list, function(a, b)
    local turnA, turnB, worthA, worthB = turn[a.name] or 3, turn[b.name] or 3, worth(a), worth(b)
    if turnA ~= turnB then
      return turnA < turnB
    elseif worthA ~= worthB then
      return worthA > worthB
    end
    return a.name < b.name
  end)
  return list
end

-- The name of the spec that fails, nil: none.
local function noticed(specs, path)
  for _, spec in ipairs(inOrder(specs, path)) do
    if not spec.passes() then
      spec.kills = spec.kills + 1
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
  local by = noticed(specs, change.path)
  save(COPY .. "/" .. change.path, change.text)
  return by and "noticed by " .. by or "survived"
end

-- "noticed", "survived", "harmless", or "wrong": listed as harmless, and noticed.
local function verdict(result, change)
  if result == "survived" then
    return change.reason and "harmless" or "survived"
  end
  return change.reason and "wrong" or "noticed"
end

-- Returns how many have each verdict.
local function tryAll(chosen)
  local known, specs = knownResults(), nil
  local counts = { noticed = 0, survived = 0, harmless = 0, wrong = 0 }
  for n, change in ipairs(chosen) do
    local name, line = describe(change)
    local result = known[name]
    if not result or verdict(result, change) == "survived" then
      specs = specs or findSpecs()
      result = try(specs, change)
      save(RESULTS, ("%s\t%s\t%s\n"):format(result, name, line), "ab")
      local is = verdict(result, change)
      local text = (is == "noticed" or is == "survived") and result or result .. ", " .. is
      print(("%d of %d  %s  %s  %s"):format(n, #chosen, text, name, line))
      io.stdout:flush()
    end
    local is = verdict(result, change)
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
    { "harmless", "not noticed, and known to change nothing" },
    { "survived", "not noticed" },
    { "wrong", "noticed, although listed as harmless" },
  }) do
    local count = counts[row[1]]
    print(("%6d  %5.1f %%  %s"):format(count, 100 * count / #chosen, row[2]))
  end
  return counts.wrong == 0 and counts.survived <= SURVIVORS_ALLOWED * #chosen
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
