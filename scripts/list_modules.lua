-- Writes the list of modules in each rockspec anew, from the files of the library:
--
--   luajit scripts/list_modules.lua

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

local function write(path)
  local input = assert(io.open(path))
  local text = input:read("*a")
  input:close()
  local before, after = text:match("^(.-  modules = {\n).-(  },\n.*)$")
  assert(before, path .. ": no list of modules found")
  local output = assert(io.open(path, "w"))
  output:write(before, table.concat(lines), after)
  output:close()
end

for path in read("ls rockspec/*.rockspec"):gmatch("[^\n]+") do
  write(path)
end
