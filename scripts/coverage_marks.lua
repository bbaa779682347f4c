--- Marks the lines of the core that are run from now on. Writes them to the file named by COVERAGE,
--- "PATH LINE" for each (scripts/coverage.lua).

local coverage = require("scripts.coverage")

-- path -> lines, path -> marked text
local seen, texts = {}, {}

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
    texts[path], seen[path] = coverage.marked(file:read("*a"), global)
    file:close()
  end
  rawset(_G, global, seen[path])
  return assert(loadstring(texts[path], "@./" .. path))
end

--- Writes the lines that were run.
local function write()
  local file = assert(io.open(assert(os.getenv("COVERAGE"), "COVERAGE is not set"), "wb"))
  for path, lines in pairs(seen) do
    for line, wasRun in pairs(lines) do
      if wasRun then
        file:write(path, " ", line, "\n")
      end
    end
  end
  file:close()
end

table.insert(package.loaders, 2, search)

return { write = write }
