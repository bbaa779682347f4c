--- Which lines of the core do the specs run?
---
---   COVERAGE=build/a.marks luajit scripts/plain_busted.lua --coverage spec/steps_spec.lua
---   luajit scripts/coverage.lua build/*.marks
---
--- Each file of the core is loaded with a mark in front of every statement that begins a line; it
--- notes that the line was run. Lines stay where they are: errors name the same. (A hook of the
--- debug library, as LuaCov sets one, makes the specs eleven times as slow.) What another run has
--- marked before needs no mark any more: COVERAGE_KNOWN names a file with such lines. When the
--- specs are over, the lines that were run are written. The second command adds up what several
--- runs have written: it prints the files with lines that were never run, these lines, and the
--- total.

package.path = "./?.lua;" .. package.path

local tokens = require("scripts.tokens")

local coverage = {}

local BEGINNERS = {
  ["local"] = true,
  ["if"] = true,
  ["for"] = true,
  ["while"] = true,
  ["repeat"] = true,
  ["return"] = true,
  ["break"] = true,
}
local NO_BEGINNERS = { ["end"] = true, ["else"] = true, ["elseif"] = true, ["until"] = true }
for _, word in ipairs({ "then", "do", "and", "or", "not", "in" }) do
  NO_BEGINNERS[word] = true
end
local OPENING = { ["("] = "sign", ["{"] = "sign", ["["] = "sign", ["function"] = "word" }
OPENING["if"], OPENING["do"], OPENING["repeat"] = "word", "word", "word"
local CLOSING = { [")"] = true, ["}"] = true, ["]"] = true, ["end"] = true, ["until"] = true }

-- Whether a token that is the first of its line begins a statement, outside of brackets.
local function begins(token, before)
  if token.kind ~= "word" or NO_BEGINNERS[token.text] then
    return false
  end
  return BEGINNERS[token.text] or not tokens.isOpen(before)
end

--- The places where a statement begins a line.
---@param text string Lua source
---@return table[] list of tokens
function coverage.statements(text)
  local list, open, before = {}, {}, nil
  for _, token in ipairs(tokens.list(text)) do
    local isFirst = not before or before.line < token.line
    if isFirst and open[#open] ~= "sign" and begins(token, before) then
      list[#list + 1] = token
    end
    if token.kind ~= "string" then
      if CLOSING[token.text] then
        open[#open] = nil
      elseif OPENING[token.text] then
        open[#open + 1] = OPENING[token.text]
      end
    end
    before = token
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
  for _, token in ipairs(coverage.statements(text)) do
    if not (known and known[token.line]) then
      parts[#parts + 1] = text:sub(at, token.at - 1)
      parts[#parts + 1] = ("%s[%d]=true;"):format(name, token.line)
      at, lines[token.line] = token.at, false
    end
  end
  return table.concat(parts) .. text:sub(at), lines
end

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("*a")
  file:close()
  return text
end

local NOT_CORE = { ["physics/world/draw.lua"] = true, ["physics/types.lua"] = true }

--- Whether a file is one of the core: what only loads maps, draws or helps editors is not.
---@param path string as in "physics/world/world.lua"
---@return boolean
function coverage.isCore(path)
  return not (NOT_CORE[path] or path:find("^physics/maps/"))
end

local function coreFiles()
  local list, pipe = { "physics.lua" }, io.popen("find physics -name '*.lua' | LC_ALL=C sort")
  for path in pipe:lines() do
    if coverage.isCore(path) then
      list[#list + 1] = path
    end
  end
  pipe:close()
  return list
end

-- The numbers of the lines that have a mark and were not run, in order; and how many have one.
local function missedLines(lines)
  local missed, count = {}, 0
  for line, wasRun in pairs(lines) do
    count = count + 1
    if not wasRun then
      missed[#missed + 1] = line
    end
  end
  table.sort(missed)
  return missed, count
end

local function sourceLines(path)
  local list = {}
  for line in (read(path) .. "\n"):gmatch("(.-)\n") do
    list[#list + 1] = line
  end
  return list
end

--- The report, as text.
---@param known table path -> `{ [line] = whether it was run }`; a file not in it was not run
---@param paths string[] all files
---@return string text
function coverage.report(known, paths)
  local out, total, run = {}, 0, 0
  for _, path in ipairs(paths) do
    local lines = known[path] or select(2, coverage.marked(read(path), "_"))
    local missed, count = missedLines(lines)
    total, run = total + count, run + count - #missed
    if #missed > 0 then
      local share = 100 * (count - #missed) / count
      out[#out + 1] = ("%s: %.1f %% of %d lines"):format(path, share, count)
      local text = sourceLines(path)
      for _, line in ipairs(missed) do
        out[#out + 1] = ("  %4d  %s"):format(line, text[line])
      end
    end
  end
  local text = "%.2f %% of the lines of the core were run: %d of %d, in %d files"
  out[#out + 1] = text:format(100 * run / total, run, total, #paths)
  return table.concat(out, "\n") .. "\n"
end

-- Adds what a run has written (scripts/coverage_marks.lua) to `known`.
local function readMarks(known, source)
  for entry in io.lines(source) do
    local path, line = entry:match("^(.*) (%d+)$")
    known[path] = known[path] or select(2, coverage.marked(read(path), "_"))
    known[path][tonumber(line)] = true
  end
end

if arg and arg[0] and arg[0]:find("scripts/coverage.lua", 1, true) then
  local known = {}
  for n = 1, #arg do
    readMarks(known, arg[n])
  end
  io.write(coverage.report(known, coreFiles()))
end

return coverage
