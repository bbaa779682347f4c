--- Writes the types that editors read (LuaLS, EmmyLua): for what physics/fields/fields.lua lists,
--- and for the functions of the module that are the methods of the default world.
---
---   luajit scripts/types.lua        writes physics/types.lua

package.path = "./?.lua;" .. package.path

local docstrings = require("scripts.docstrings")
local fields = require("scripts.meanings")
local files = require("spec.support.files")

local types = {}

local COLUMNS = 100

local HEAD = [[
---@meta _
--- The types of this library for editors (LuaLS, EmmyLua). Nothing requires this file.
--- scripts/types.lua writes it from physics/fields/fields.lua and the methods of worlds: change
--- those.

---@alias physics.Side "left"|"right"|"top"|"bottom"

--- A rectangle: left edge, top edge and size, in px. It may have fields of your own.
---@class physics.Box
---@field x number px, the left edge
---@field y number px, the top edge; y grows downwards
---@field width number px, > 0
---@field height number px, > 0
---@field [string|number] any

--- The neighbours of a dynamic object: on each side the one with the widest common edge, or false.
---@class physics.Touching
---@field top physics.Object|false
---@field bottom physics.Object|false
---@field left physics.Object|false
---@field right physics.Object|false
]]

-- "px/s, >= 0, default 0. The limit ..."
local function meaning(field)
  local isGiven = not (field.required or field.written)
  local default = isGiven and "default " .. field.standard:gsub("`", "") or ""
  local head = table.concat({ field.unit or "", field.range, default }, ", ")
  head = head:gsub("^[, ]+", ""):gsub(", , ", ", "):gsub("[, ]+$", "")
  return head == "" and field.meaning or head .. ". " .. field.meaning
end

local function add(lines, ...)
  for i = 1, select("#", ...) do
    lines[#lines + 1] = (select(i, ...))
  end
end

-- The text above a field belongs to the field, not to the class. It is broken into lines of at most
-- `COLUMNS`.
local function addField(lines, field, isOptional)
  local line = "---"
  for word in meaning(field):gmatch("%S+") do
    if #line + 1 + #word > COLUMNS then
      add(lines, line)
      line = "---"
    end
    line = line .. " " .. word
  end
  add(lines, line)
  add(lines, ("---@field %s%s %s"):format(field.name, isOptional and "?" or "", field.editorType))
end

-- A table of the game has a width and a height, or a radius.
local NEW_OBJECTS = [[

--- Your own table that you give to `add` or put into a group: a box, or a circle in its square.
---@alias physics.NewObject physics.NewBox|physics.NewCircle

---@class physics.NewBox: physics.ObjectFields
---@field x number px, the left edge
---@field y number px, the top edge
---@field width number px, > 0
---@field height number px, > 0
--- px, > 0. It is a circle: `width` and `height` are 2 * radius.
---@field radius? number

---@class physics.NewCircle: physics.ObjectFields
---@field x number px, the left edge of its square
---@field y number px, the top edge of its square
---@field radius number px, > 0
---@field width? number px, 2 * radius; `add` writes it
---@field height? number px, 2 * radius; `add` writes it

--- An object in a world. A dynamic one always has `vx`, `vy` and `touching`.
---@class physics.Object: physics.NewBox, physics.Box]]

local AREA = "--- The entries of the field `area` of a zone.\n---@class physics.Area"
local SETTINGS = "--- What `newWorld` and `load` take.\n---@class physics.Settings"
local WORLD_SETTINGS = "--- The settings as fields of a world. They may change between two "
  .. "updates.\n---@class physics.WorldSettings"

local function addObjects(lines)
  add(lines, "", "--- What an object may have beside its place and size.")
  add(lines, "---@class physics.ObjectFields")
  for _, field in ipairs(fields.objects) do
    if not field.required and not field.written and field.name ~= "radius" then
      addField(lines, field, true)
    end
  end
  add(lines, "---@field [string|number] any", NEW_OBJECTS)
  for _, field in ipairs(fields.objects) do
    if field.written or field.name == "vx" or field.name == "vy" then
      addField(lines, field, false)
    end
  end
end

local function addFields(lines, list, head, isOptional)
  add(lines, "", head)
  for _, field in ipairs(list) do
    addField(lines, field, isOptional or field.default == nil)
  end
end

local function addFunction(lines, entry)
  add(lines, "")
  for _, line in ipairs(entry.text) do
    add(lines, line == "" and "---" or "--- " .. line)
  end
  for _, tag in ipairs(entry.tags) do
    add(lines, "---" .. tag:gsub("fun%(self: physics.World, ", "fun("))
  end
  add(lines, ("function default.%s(%s) end"):format(entry.name, entry.arguments))
end

--- Returns the text of physics/types.lua.
---@return string
function types.text()
  local lines = {}
  addObjects(lines)
  addFields(lines, fields.area, AREA, true)
  addFields(lines, fields.settings, SETTINGS, true)
  addFields(lines, fields.settings, WORLD_SETTINGS, false)
  add(lines, "", "--- The default world, on which the functions of the module work.")
  add(lines, "---@class physics.DefaultWorld: physics.WorldSettings")
  for _, field in ipairs(docstrings.worldFields()) do
    add(lines, ("---@field %s %s %s"):format(field.name, field.type, field.text))
  end
  add(lines, "local default = {}")
  for _, entry in ipairs(docstrings.functions(docstrings.SOURCES[3])) do
    addFunction(lines, entry)
  end
  return HEAD .. table.concat(lines, "\n") .. "\n"
end

if arg and arg[0] and arg[0]:find("scripts/types.lua", 1, true) then
  files.write("physics/types.lua", types.text())
end

return types
