--- Writes the library's addon for the Lua language server: config.json, and library/physics.lua
--- with all types and functions but no code. A game that has the library as the one file, or
--- elsewhere than in its workspace, gets names, types and texts from it.
---
---   luajit scripts/addon.lua build/addon

package.path = "./?.lua;" .. package.path

local docstrings = require("scripts.docstrings")
local types = require("scripts.types")

local addon = {}

local CONFIG = [[
{
  "name": "physics.lua",
  "words": ["require[%s%(\"']+[%w_.]*physics[\"']", "physics%.newWorld"],
  "settings": {}
}
]]

local HEAD = [[
---@meta physics
--- physics.lua %s for editors: all types and functions, no code. Not for running.

]]

local function sources()
  local list, pipe =
    { "physics.lua" }, assert(io.popen("find physics -name '*.lua' | LC_ALL=C sort"))
  for path in pipe:lines() do
    if path ~= "physics/types.lua" then
      list[#list + 1] = path
    end
  end
  pipe:close()
  return list
end

local function add(lines, ...)
  for i = 1, select("#", ...) do
    lines[#lines + 1] = (select(i, ...))
  end
end

local function addText(lines, entry)
  for _, line in ipairs(entry.text) do
    add(lines, line == "" and "---" or "--- " .. line)
  end
end

-- Lines of a run that declares a class, without the fields that are the library's own.
local function addDeclaration(lines, entry)
  add(lines, "")
  addText(lines, entry)
  if entry.kind == "alias" then
    add(lines, ("---@alias %s %s"):format(entry.name, entry.type))
    return
  end
  add(lines, "---@class " .. entry.name .. (entry.type == "" and "" or ": " .. entry.type))
  for _, field in ipairs(entry.fields) do
    add(lines, (("---@field %s %s %s"):format(field.name, field.type, field.text):gsub("%s+$", "")))
  end
end

local function addFunction(lines, entry, owner)
  add(lines, "")
  addText(lines, entry)
  for _, tag in ipairs(entry.tags) do
    add(lines, "---" .. tag)
  end
  add(lines, ("function %s(%s) end"):format(owner .. entry.name, entry.arguments))
end

-- Names of our types in a text that are not declared yet, in the order of the text.
local function findMissing(text, declared)
  local missing = {}
  for name in text:gmatch("%f[%w_]physics%.%u%w*") do
    if not declared[name] then
      declared[name] = true
      missing[#missing + 1] = name
    end
  end
  return missing
end

--- Returns the text of library/physics.lua.
---@return string
function addon.text()
  local declarations, functions = {}, {}
  for _, path in ipairs(sources()) do
    for _, entry in ipairs(docstrings.read(path)) do
      if entry.kind == "function" then
        functions[entry.owner] = functions[entry.owner] or {}
        table.insert(functions[entry.owner], entry)
      else
        declarations[entry.name] = entry
      end
    end
  end

  local lines = {}
  addDeclaration(lines, assert(declarations["physics.World"]))
  add(lines, "local World = {}")
  for _, entry in ipairs(assert(functions.World)) do
    addFunction(lines, entry, "World:")
  end
  addDeclaration(lines, assert(declarations["physics.Module"]))
  add(lines, "---@field _VERSION string")
  add(lines, "local physics = {}")
  for _, owner in ipairs({ "physics", "pure" }) do
    for _, entry in ipairs(assert(functions[owner])) do
      addFunction(lines, entry, "physics.")
    end
  end
  local code = table.concat(lines, "\n") .. "\n\nreturn physics\n"

  -- What these name, and what that names again.
  local head = HEAD:format(require("physics")._VERSION)
  local text = head .. types.text():gsub("^%-%-%-@meta[^\n]*\n.-\n\n", "", 1)
  local declared = {}
  for kind, name in (text .. code):gmatch("%-%-%-@(%l+) (physics%.%u%w*)") do
    declared[name] = kind == "class" or kind == "alias" or declared[name]
  end
  local more, seen = {}, text .. code
  repeat
    local missing = findMissing(seen, declared)
    local new = {}
    for _, name in ipairs(missing) do
      addDeclaration(new, assert(declarations[name], name .. " is declared nowhere"))
    end
    seen = table.concat(new, "\n")
    add(more, seen)
  until #missing == 0
  return text .. table.concat(more, "\n") .. code
end

-- For `require "lib.physics"`: a file of types is found under one name only.
local IN_LIB = [[
---@meta lib.physics
return require("physics")
]]

--- Writes the addon into a folder that is there, with the folders `library` and `library/lib`.
---@param folder string
function addon.write(folder)
  for name, text in pairs({
    ["config.json"] = CONFIG,
    ["library/physics.lua"] = addon.text(),
    ["library/lib/physics.lua"] = IN_LIB,
  }) do
    local file = assert(io.open(folder .. "/" .. name, "wb"))
    file:write(text)
    file:close()
  end
end

if arg and arg[0] and arg[0]:find("scripts/addon.lua", 1, true) then
  addon.write(assert(arg[1], "which folder?"))
end

return addon
