--- Which lines of the core do the specs run?
---
---   COVERAGE=build/a.marks luajit scripts/plain_busted.lua --coverage spec/steps_spec.lua
---   luajit scripts/coverage.lua build/*.marks
---
--- With --coverage each file of the core is loaded with a mark in front of every statement that
--- begins a line; it notes that the line was run. Lines stay where they are: errors name the same.
--- (A hook of the debug library, as LuaCov sets one, makes the specs eleven times as slow.) The
--- second command adds up the lines that several runs have written: it prints the files with lines
--- that were never run, these lines, and the total.

package.path = "./?.lua;" .. package.path

local decoder = require("luacheck.decoder")
local files = require("spec.support.files")
local parser = require("luacheck.parser")

local coverage = {}

-- Whether a part of a node of the syntax tree is a block of statements.
local function isBlock(node, n)
  local tag, isList = node.tag, not node[n].tag
  return node[n].tag == "Do"
    or isList and (tag == "If" or tag == "While" or tag == "Repeat" or tag == "Fornum")
    or tag == "Forin" and n == 3
    or tag == "Function" and n == 2
end

-- Adds the statements below a node to a list.
local function addStatements(node, areStatements, list)
  for n, part in ipairs(node) do
    if type(part) == "table" then
      list[#list + 1] = areStatements and part or nil
      addStatements(part, isBlock(node, n), list)
    end
  end
end

--- The places where a statement begins a line.
---@param text string Lua source
---@return table[] list of `{ line =, offset = }`, in order
function coverage.statements(text)
  local all, list = {}, {}
  text = text:gsub("[\128-\255]", "?") -- offsets in bytes
  local tree, _, _, _, _, offsets = parser.parse(decoder.decode(text))
  addStatements(tree, true, all)
  for _, statement in ipairs(all) do
    if text:sub(offsets[statement.line], statement.offset - 1):find("^%s*$") then
      list[#list + 1] = statement
    end
  end
  return list
end

--- The source with a mark in front of each of these statements.
---@param text string Lua source
---@param name string of the global table; its fields, by the number of the line, become true
---@param known table? lines of which `known[n]` is true get no mark: that they are run is known
---@return string text
---@return table lines `lines[n]` is false for each line that has a mark
function coverage.marked(text, name, known)
  local parts, at, lines = {}, 1, {}
  for _, statement in ipairs(coverage.statements(text)) do
    if not (known and known[statement.line]) then
      parts[#parts + 1] = text:sub(at, statement.offset - 1)
      parts[#parts + 1] = ("%s[%d]=true;"):format(name, statement.line)
      at, lines[statement.line] = statement.offset, false
    end
  end
  return table.concat(parts) .. text:sub(at), lines
end

local NOT_CORE = { ["physics/world/draw.lua"] = true, ["physics/types.lua"] = true }

--- Whether a file is one of the core: what only loads maps, draws or helps editors is not.
---@param path string as in "physics/world/world.lua"
---@return boolean
function coverage.isCore(path)
  return not (NOT_CORE[path] or path:find("^physics/maps/"))
end

--- Adds the lines that a file of marks names to `known`, path -> set of lines.
function coverage.readMarks(known, marks)
  for entry in io.lines(marks) do
    local path, line = entry:match("^(.*) (%d+)$")
    known[path] = known[path] or {}
    known[path][tonumber(line)] = true
  end
end

--- Marks the lines of the core that are run from now on. Returns a function that writes them to the
--- file named by COVERAGE, "PATH LINE" for each. Lines in the file named by COVERAGE_KNOWN get no
--- marks: these cost half of the time where they are many.
---@return fun()
function coverage.start()
  local seen, texts, known = {}, {}, {} -- by path: lines, marked text, lines that need no mark
  local knownFrom = os.getenv("COVERAGE_KNOWN")
  if knownFrom then
    coverage.readMarks(known, knownFrom)
  end

  -- Instead of the loader of files, for the modules of the library.
  table.insert(package.loaders, 2, function(name)
    local path = name:gsub("%.", "/") .. ".lua"
    local isThere = name:find("^physics%f[%.%z]") and coverage.isCore(path) and io.open(path, "rb")
    if not isThere then
      return nil
    end
    isThere:close()
    -- One table for each file: no global of the library's own, and a name that no game would use.
    local global = "COVERAGE_" .. path:gsub("%W", "_")
    if not seen[path] then
      texts[path], seen[path] = coverage.marked(files.read(path), global, known[path])
    end
    rawset(_G, global, seen[path])
    return assert(loadstring(texts[path], "@./" .. path))
  end)

  return function()
    local list, target = {}, assert(os.getenv("COVERAGE"), "COVERAGE is not set")
    for path, lines in pairs(seen) do
      for line, wasRun in pairs(lines) do
        list[#list + 1] = wasRun and ("%s %d\n"):format(path, line) or nil
      end
    end
    -- Others may read it at any time: it is there as a whole, or not yet.
    files.write(target .. ".new", table.concat(list))
    assert(os.rename(target .. ".new", target))
  end
end

--- The report, as text.
---@param known table path -> set of the lines that were run
---@param paths string[] all files
---@return string text
function coverage.report(known, paths)
  local out, total, run = {}, 0, 0
  for _, path in ipairs(paths) do
    local lines, wasRun = select(2, coverage.marked(files.read(path), "_")), known[path] or {}
    local number, before, missed = 0, total, {}
    for line in (files.read(path) .. "\n"):gmatch("(.-)\n") do
      number = number + 1
      if lines[number] == false then
        total, run = total + 1, run + (wasRun[number] and 1 or 0)
        missed[#missed + 1] = not wasRun[number] and ("  %4d  %s"):format(number, line) or nil
      end
    end
    if missed[1] then
      local count = total - before
      local share = 100 * (count - #missed) / count
      out[#out + 1] = ("%s: %.1f %% of %d lines"):format(path, share, count)
      out[#out + 1] = table.concat(missed, "\n")
    end
  end
  local text = "%.2f %% of the lines of the core were run: %d of %d, in %d files"
  out[#out + 1] = text:format(100 * run / total, run, total, #paths)
  return table.concat(out, "\n") .. "\n"
end

if arg and arg[0] and arg[0]:find("scripts/coverage.lua", 1, true) then
  local known = {}
  for _, marks in ipairs(arg) do
    coverage.readMarks(known, marks)
  end
  local core = {}
  for _, path in ipairs(files.list("find physics.lua physics -name '*.lua'")) do
    core[#core + 1] = coverage.isCore(path) and path or nil
  end
  io.write(coverage.report(known, core))
end

return coverage
