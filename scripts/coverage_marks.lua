--- Marks the lines of the core that are run from now on. Writes them to the file named by COVERAGE,
--- "PATH LINE" for each (scripts/coverage.lua). Lines that stand in the file named by
--- COVERAGE_KNOWN already are left alone: marks cost half of the time where they are many.

local coverage = require("scripts.coverage")

-- path -> lines, path -> marked text
local seen, texts = {}, {}

-- path -> set of the lines that need no mark
local known, knownFrom = {}, os.getenv("COVERAGE_KNOWN")
if knownFrom then
  coverage.readMarks(known, knownFrom)
end

-- Instead of the loader of files, for the modules of the library.
local function search(name)
  local path = name:gsub("%.", "/") .. ".lua"
  if not name:find("^physics%f[%.%z]") or not coverage.isCore(path) then
    return nil
  end
  -- One table for each file: no global of the library's own, and a name that no game would use.
  local global = "COVERAGE_" .. path:gsub("%W", "_")
  if not seen[path] then
    local file = io.open(path, "rb")
    if not file then
      return nil
    end
    texts[path], seen[path] = coverage.marked(file:read("*a"), global, known[path])
    file:close()
  end
  rawset(_G, global, seen[path])
  return assert(loadstring(texts[path], "@./" .. path))
end

--- Writes the lines that were run.
local function write()
  local target = assert(os.getenv("COVERAGE"), "COVERAGE is not set")
  -- Others may read it at any time: it is there as a whole, or not yet.
  local file = assert(io.open(target .. ".new", "wb"))
  for path, lines in pairs(seen) do
    for line, wasRun in pairs(lines) do
      if wasRun then
        file:write(path, " ", line, "\n")
      end
    end
  end
  file:close()
  assert(os.rename(target .. ".new", target))
end

table.insert(package.loaders, 2, search)

return { write = write }
