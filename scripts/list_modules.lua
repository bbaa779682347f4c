-- Writes the list of modules in each rockspec anew, from the files of the library:
--
--   luajit scripts/list_modules.lua

package.path = "./?.lua;" .. package.path

local files = require("spec.support.files")

local lines = {}
for _, file in ipairs(files.list("find physics.lua physics -name '*.lua'")) do
  local name = file:gsub("%.lua$", ""):gsub("/", ".")
  lines[#lines + 1] = ('    ["%s"] = "%s",\n'):format(name, file)
end

for _, path in ipairs(files.list("ls rockspec/*.rockspec")) do
  local before, after = files.read(path):match("^(.-  modules = {\n).-(  },\n.*)$")
  files.write(path, assert(before, path .. ": no list of modules") .. table.concat(lines) .. after)
end
