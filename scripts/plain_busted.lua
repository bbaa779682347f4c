--- Runs specs where busted cannot run: it needs modules in C, and its own modules are not yet
--- written for Lua 5.5. In plain Lua, as much of `describe`, `it` and `assert` as the specs use.
--- (luassert would be plain Lua, but on gopher-lua some of its assertions hold whatever they are
--- given.)
--
--   LUA scripts/plain_busted.lua [--left-out=MODULE] [--exclude-tags=slow] [--no-keep-going]
--   [--coverage] SPEC...
--
-- Prints what failed, and a line of counts. `--coverage` marks the lines of the core that are
-- run (scripts/coverage.lua). As with busted every file loads the library anew, unless it was
-- loaded before the specs; specs are named by all the `describe` around them, and a tag stands in
-- such a name, as in #slow. The module lists what is not run, files and specs by name, with
-- reasons: spec/gopher/left_out.lua.

package.path = "./?.lua;" .. package.path

local options, files = {}, {}
for i = 1, #arg do
  local name, value = arg[i]:match("^%-%-([%w%-]+)=(.+)$")
  if name == "left-out" or name == "exclude-tags" then
    options[name] = value
  elseif arg[i] == "--no-keep-going" or arg[i] == "--coverage" then
    options[arg[i]] = true
  elseif arg[i]:find("^%-") then
    error("unknown option: " .. arg[i], 0)
  else
    files[#files + 1] = arg[i]
  end
end

local LEFT_OUT = { files = {}, specs = {}, starts = {} }
if options["left-out"] then
  LEFT_OUT = require(options["left-out"])
end

-- The words of --exclude-tags, "slow,files".
local excluded = {}
for tag in (options["exclude-tags"] or ""):gmatch("[^,]+") do
  excluded[#excluded + 1] = "#" .. tag
end

-- In a table: on gopher-lua an error takes local variables away from the closures that count.
local count = { passed = 0, failed = 0, leftOut = 0 }

-- Assertions -------------------------------------------------------------------------------------

-- Equality of tables by what they hold; they may hold themselves.
local function isSame(a, b, seen)
  if type(a) ~= "table" or type(b) ~= "table" then
    return a == b
  end
  seen = seen or {}
  if a == b or seen[a] == b then
    return true
  end
  seen[a] = b
  for key, value in pairs(a) do
    if not isSame(value, b[key], seen) then
      return false
    end
  end
  for key in pairs(b) do
    if a[key] == nil then
      return false
    end
  end
  return true
end

local function show(value)
  if type(value) == "number" then
    return ("%.17g"):format(value)
  end
  return type(value) == "string" and '"' .. value .. '"' or tostring(value)
end

local function fail(expected, found, message)
  local text = message and tostring(message) .. ": " or ""
  error(text .. "expected " .. expected .. ", got " .. show(found), 3)
end

-- An assertion of two values. A message is argument number `n` of those behind them, default 1.
local function comparing(text, holds, n)
  return function(expected, found, ...)
    if not holds(expected, found, ...) then
      fail(text .. show(expected), found, (select(n or 1, ...)))
    end
    return found
  end
end

-- An assertion of one value.
local function checking(text, holds)
  return function(found, message)
    if not holds(found) then
      fail(text, found, message)
    end
    return found
  end
end

local function find(pattern, found, init, plain)
  return type(found) == "string" and found:find(pattern, init or 1, plain)
end

local assertions = {
  equal = comparing("", function(expected, found)
    return expected == found
  end),
  not_equal = comparing("another than ", function(unwanted, found)
    return unwanted ~= found
  end),
  same = comparing("the same as ", function(expected, found)
    return isSame(expected, found)
  end),
  near = comparing("about ", function(expected, found, tolerance)
    return found >= expected - tolerance and found <= expected + tolerance
  end, 2),
  -- The pattern, and as in string.find where to begin and whether it is plain text.
  matches = comparing("a match of ", find, 3),
  truthy = checking("anything but nil and false", function(found)
    return found
  end),
  is_not_nil = checking("anything but nil", function(found)
    return found ~= nil
  end),
  is_true = checking("true", function(found)
    return found == true
  end),
  is_false = checking("false", function(found)
    return found == false
  end),
}
for _, kind in ipairs({ "nil", "table", "function", "string", "number" }) do
  assertions["is_" .. kind] = checking("a " .. kind, function(found)
    return type(found) == kind
  end)
end
assertions.is_near, assertions.is_truthy = assertions.near, assertions.truthy
assertions.are, assertions.are_not = assertions, { equal = assertions.not_equal }

-- As luassert does, without the place in front of a message.
function assertions.has_error(call, expected)
  local isFine, message = pcall(call)
  if type(message) == "string" then
    message = message:gsub("^.-:%d+: ", "", 1)
  end
  if isFine or (expected ~= nil and not isSame(expected, message)) then
    fail("an error", message)
  end
end

function assertions.error_matches(call, pattern, init, plain)
  local isFine, message = pcall(call)
  if isFine or not find(pattern, message, init, plain) then
    fail("an error that matches " .. show(pattern), message)
  end
end

setmetatable(assertions, {
  __call = function(_, value, message, ...)
    if not value then
      error(message or "assertion failed!", 2)
    end
    return value, message, ...
  end,
})

-- Specs ------------------------------------------------------------------------------------------

-- A block is a `describe`, or the file around all of them, which has the specs.
local block, root

-- What the running spec has asked for, to be called after it.
local final

local function newBlock(parent, name)
  return { parent = parent, name = name, once = {}, before = {}, after = {} }
end

local function describe(name, define)
  block = newBlock(block, (block.name .. " " .. name):gsub("^ ", ""))
  define()
  block = block.parent
end

local function it(name, spec)
  local full = (block.name .. " " .. name):gsub("^ ", "")
  table.insert(root.specs, { name = full, run = spec, block = block })
end

-- What is not reached yet: busted counts it as pending.
local function pending()
  count.leftOut = count.leftOut + 1
end

-- Calls the hooks of a block and of all around it, from the outside in; those of `setup` once.
local function callHooks(which, inner)
  if inner then
    callHooks(which, inner.parent)
    while which == "before" and inner.once[1] do
      table.remove(inner.once, 1)()
    end
    for _, hook in ipairs(inner[which]) do
      hook()
    end
  end
end

local function runSpec(spec)
  callHooks("before", spec.block)
  final = nil
  local isFine, problem = pcall(spec.run)
  if final then
    final()
  end
  callHooks("after", spec.block)
  if isFine then
    count.passed = count.passed + 1
  else
    count.failed = count.failed + 1
    print("FAILED  " .. spec.name .. "\n        " .. tostring(problem))
    if options["--no-keep-going"] then
      os.exit(1)
    end
  end
end

-- What is loaded before the specs stays for all of them.
local kept = {}
for name in pairs(package.loaded) do
  kept[name] = true
end

local function forgetModules()
  for name in pairs(package.loaded) do
    local isOurs = name == "physics" or name:find("^physics%.") or name:find("^spec%.")
    if isOurs and not kept[name] then
      package.loaded[name] = nil
    end
  end
end

local function leaveOut(name, reason)
  count.leftOut = count.leftOut + 1
  print("left out  " .. name .. ": " .. reason)
end

-- Why a spec is left out; nil: it is not.
local function reasonFor(name)
  for _, row in ipairs(LEFT_OUT.starts) do
    if name:sub(1, #row[1]) == row[1] then
      return row[2]
    end
  end
  return LEFT_OUT.specs[name]
end

local function isExcluded(name)
  for _, tag in ipairs(excluded) do
    if name:find(tag, 1, true) then
      return true
    end
  end
  return false
end

local function runFile(path)
  forgetModules()
  block = newBlock(nil, "")
  root = block
  root.specs, root.last = {}, {}
  assert(loadfile(path))()
  for _, spec in ipairs(root.specs) do
    if isExcluded(spec.name) then
      count.leftOut = count.leftOut + 1
    elseif reasonFor(spec.name) then
      leaveOut(spec.name, reasonFor(spec.name))
    else
      runSpec(spec)
    end
  end
  for _, hook in ipairs(root.last) do
    hook()
  end
end

-- What the specs take from busted itself.
local function busted()
  return {
    fail = function(message, level)
      error(message, (level or 1) + 1)
    end,
  }
end

local function install()
  local globals = _G
  globals.assert, globals.describe, globals.it = assertions, describe, it
  globals.pending = pending
  package.preload.busted = busted
  globals.finally = function(call)
    final = call
  end
  globals.setup = function(hook)
    block.once[#block.once + 1] = hook
  end
  -- Later than in busted: when the whole file has been run.
  globals.teardown = function(hook)
    table.insert(root.last, 1, hook)
  end
  globals.before_each = function(hook)
    block.before[#block.before + 1] = hook
  end
  globals.after_each = function(hook)
    block.after[#block.after + 1] = hook
  end
end

-- As a spec expects it: the interpreter is there, without its options, and no file that is run by
-- itself.
local first = -1
while arg[first - 1] do
  first = first - 1
end
arg = { [-1] = arg[first], [0] = "busted" }
install()
require("spec.support.pairs")
if os.getenv("PHYSICS_LUA") then
  dofile("scripts/interpreter.lua")
end
local writeMarks = options["--coverage"] and require("scripts.coverage").start()
for _, path in ipairs(files) do
  if LEFT_OUT.files[path] then
    leaveOut(path, LEFT_OUT.files[path])
  else
    runFile(path)
  end
end
if writeMarks then
  writeMarks()
end
print(("%d passed, %d failed, %d left out"):format(count.passed, count.failed, count.leftOut))
os.exit(count.failed == 0 and 0 or 1)
