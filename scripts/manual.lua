--- Writes the reference from the docstrings and from physics/world/fields.lua:
---
---   luajit scripts/manual.lua       writes docs/api.md

package.path = "./?.lua;" .. package.path

local docstrings = require("scripts.docstrings")
local fields = require("physics.world.fields")
local typedFields = require("scripts.typed_fields")

local manual = {}

-- Written by hand here is only what no single function or field could say.
local HEAD = [[
# Reference

Everything that is public, from the source: `make docs` writes this page from the docstrings and
from [physics/world/fields.lua](../physics/world/fields.lua). The [README](../README.md) explains, this page
lists. Editors that know LuaLS or EmmyLua annotations show the same while you type.

x goes to the right, y **down**; `x, y` is the top-left corner; lengths are in px, times in s. A
`?` behind a type or a name marks what may be left out or be nil. Who calls a function with
something it cannot use gets an error that names the place and blames the calling line; nothing has
changed then.
]]

local MODULE = [[
`local physics = require "physics"`. Besides these functions the module has every method of a world,
for the default world: `physics.update(dt)` is `world:update(dt)`, and `physics.gravity`,
`physics.objects`, `physics.stats`, `physics.onBegin` and so on are that world's fields.
]]

local WORLD = [[
`local world = physics.newWorld(settings)`. The [settings](#settings) are plain fields of a world.
]]

local function add(lines, ...)
  for i = 1, select("#", ...) do
    lines[#lines + 1] = (select(i, ...))
  end
end

-- A bar would end the cell of a table.
local function cell(text)
  return (text:gsub("|", "\\|"))
end

-- A type as code; the marks of a table's cells hold in code, too.
local function code(kind)
  return "`" .. kind .. "`"
end

local function fieldMeaning(field)
  local meaning = field.meaning
  if field.values then
    meaning = meaning .. ' One of `"' .. table.concat(field.values, '"`, `"') .. '"`.'
  end
  if field.signature then
    meaning = ("`%s%s` %s"):format(field.name, field.signature, meaning)
  end
  return meaning
end

local function addFields(lines, list)
  add(lines, "| name | type | default | unit, range | meaning |", "|---|---|---|---|---|")
  for _, field in ipairs(list) do
    local kind = field.type == "function" and "function" or typedFields.type(field)
    local range, unit = typedFields.range(field), field.unit or ""
    if range ~= "" then
      unit = unit == "" and range or unit .. ", " .. range
    end
    local default = typedFields.default(field)
    local row = "| `%s` | %s | %s | %s | %s |"
    kind = cell(code(kind))
    add(lines, row:format(field.name, kind, default, unit, cell(fieldMeaning(field))))
  end
  add(lines, "")
end

local function item(name, kind, text)
  local head = name == "" and "- " .. code(kind) or ("- `%s` (%s)"):format(name, code(kind))
  return head .. (text == "" and "" or ": " .. text)
end

local function addItems(lines, title, list)
  if #list > 0 then
    add(lines, title, "")
    for _, param in ipairs(list) do
      add(lines, item(param.name, param.type, param.text))
    end
    add(lines, "")
  end
end

-- The text of a docstring is Markdown already; "Errors:" and "Source:" begin paragraphs.
local function addText(lines, text)
  for i, line in ipairs(text) do
    local word, rest = line:match("^(%u%l+):%s(.*)$")
    if word == "Errors" or word == "Source" or word == "Options" then
      if i > 1 and text[i - 1] ~= "" then
        add(lines, "")
      end
      line = ("**%s:** %s"):format(word, rest)
    end
    add(lines, line)
  end
  if #text > 0 then
    add(lines, "")
  end
end

local function addFunction(lines, entry, place)
  add(lines, ("### %s%s(%s)"):format(place, entry.name, entry.arguments), "")
  addText(lines, entry.text)
  addItems(lines, "Parameters:", entry.params)
  addItems(lines, "Returns:", entry.returns)
end

local function addFunctions(lines, path, owner, place)
  local _, list = docstrings.functions(path, owner)
  for _, entry in ipairs(list) do
    addFunction(lines, entry, place)
  end
end

local function addType(lines, entry)
  add(lines, "### " .. entry.name, "")
  if entry.kind == "alias" then
    add(lines, code(entry.type), "")
  elseif entry.type ~= "" then
    add(
      lines,
      "All of [" .. entry.type .. "](#" .. entry.type:gsub("%.", ""):lower() .. "), and:",
      ""
    )
  end
  addText(lines, entry.text)
  for _, field in ipairs(entry.fields) do
    if field.name:find("^%a") then
      add(lines, item(field.name, field.type, field.text))
    end
  end
  add(lines, "")
end

-- Types that are fields' tables above, or no business of a game's.
local HIDDEN = {
  ["physics.World"] = true,
  ["physics.NewObject"] = true,
  ["physics.Object"] = true,
  ["physics.Settings"] = true,
  ["physics.WorldSettings"] = true,
  ["physics.DefaultWorld"] = true,
}

local function addTypes(lines, path)
  for _, entry in ipairs(docstrings.read(path)) do
    if entry.kind ~= "function" and not HIDDEN[entry.name] then
      addType(lines, entry)
    end
  end
end

-- The fields of a world that are no settings.
local function addWorldFields(lines)
  for _, entry in ipairs(docstrings.read("physics/world/world.lua")) do
    for _, field in ipairs(entry.name == "physics.World" and entry.fields or {}) do
      if field.name:find("^%a") then
        add(lines, item("world." .. field.name, field.type, field.text))
      end
    end
  end
  add(lines, "")
end

--- Returns the text of docs/api.md.
---@return string
function manual.text()
  local lines = { HEAD, "## Fields of objects", "" }
  addFields(lines, fields.objects)
  add(lines, "## Settings", "")
  addFields(lines, fields.settings)
  add(lines, "## The module", "", MODULE)
  addFunctions(lines, "physics.lua", "physics", "physics.")
  addFunctions(lines, "physics/world/tutorial.lua", "pure", "physics.")
  add(lines, "## Worlds", "", WORLD)
  addWorldFields(lines)
  addFunctions(lines, "physics/world/world.lua", "World", "world:")
  add(lines, "## Types", "")
  local files = { "types", "world/world", "world/draw", "tiled" }
  for _, file in ipairs(files) do
    local path = "physics/" .. file .. ".lua"
    addTypes(lines, path)
  end
  local text = table.concat(lines, "\n"):gsub("\n\n\n+", "\n\n"):gsub("%s+$", "")
  return text .. "\n"
end

if arg and arg[0] and arg[0]:find("scripts/manual.lua", 1, true) then
  local file = assert(io.open("docs/api.md", "wb"))
  file:write(manual.text())
  file:close()
end

return manual
