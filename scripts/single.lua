-- Writes the whole library as one file, for games that want to copy one:
--
--   luajit scripts/single.lua build/physics.lua
--
-- Each module becomes a function in that file, and `require` a local function that knows only
-- these, and LuaJIT's FFI: neither `package.preload` nor `package.loaded` is touched, so two copies
-- of the file, or the file and the folder, live side by side. The door gets the same name wherever
-- the file lies, `require "physics"` and `require "lib.physics"` find it by its own name.

package.path = "./?.lua;" .. package.path

local files = require("spec.support.files")

local path = assert(arg[1], "which file to write?")
local read = files.read

-- A text as a comment.
local function commented(text)
  return (("\n" .. text:gsub("%s+$", "")):gsub("\n", "\n-- "):gsub(" +%f[\n]", ""):sub(2))
end

local HEAD = [[
---@diagnostic disable
-- physics.lua %s, the whole library in one file.
-- Written by `make single` from the files of the repository: change those, not this one.
--
%s

local modules, loaded = {}, {}

-- The modules' own: it finds what is in this file, and LuaJIT's FFI.
local outer = require
local function require(name)
  if name == "ffi" then
    return outer(name)
  elseif loaded[name] == nil then
    loaded[name] = modules[name](name)
  end
  return loaded[name]
end
]]

local MODULE = [[

modules["%s"] = function(...)
%s
end
]]

-- The types for editors: comments, and functions that are never called.
local TYPES = [[

do
%s
end
]]

local version = assert(read("physics.lua"):match('_VERSION = "([^"]+)"'), "physics.lua: no version")
local parts = {
  HEAD:format(version, commented(read("LICENSE"))),
  TYPES:format((read("physics/types.lua"):gsub("^%-%-%-@meta[^\n]*\n", ""))),
}
for _, file in ipairs(files.list("find physics.lua physics -name '*.lua'")) do
  local name = file:gsub("%.lua$", ""):gsub("/", ".")
  -- The names of modules are known here: no file has to find out where it lies.
  local text = read(file):gsub("%s+$", ""):gsub('root %.%. "', '"physics')
  text = text:gsub("^%-%-%-@diagnostic disable\n", "") -- HEAD has that line
  local rootless = text:gsub("local root = [^\n]*\n", "", 1)
  text = rootless:find("%f[%w]root%f[%W]") and text or rootless
  if not text:find("^%-%-%-@meta") then -- types for editors are not for running
    parts[#parts + 1] = MODULE:format(name, text)
  end
end
parts[#parts + 1] = '\nlocal door = require("physics") ---@type physics.Module\nreturn door\n'

files.write(path, table.concat(parts))
