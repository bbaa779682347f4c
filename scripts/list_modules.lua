-- Writes the list of modules in the rockspec anew, from the files of the library:
--
--   luajit scripts/list_modules.lua rockspec/physics-0.1.0-1.rockspec

local path = assert(arg[1], "which rockspec?")

local function read(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read("*a")
  pipe:close()
  return text
end

local lines = {}
for file in read("find physics.lua physics -name '*.lua' | LC_ALL=C sort"):gmatch("[^\n]+") do
  local name = file:gsub("%.lua$", ""):gsub("/", ".")
  lines[#lines + 1] = ('    ["%s"] = "%s",\n'):format(name, file)
end

local input = assert(io.open(path))
local text = input:read("*a")
input:close()

local before, after = text:match("^(.-  modules = {\n).-(  },\n.*)$")
local output = assert(io.open(path, "w"))
output:write(assert(before, "no list of modules found"), table.concat(lines), after)
output:close()
