--- Writes the reference from the docstrings, physics/fields/fields.lua and
--- scripts/manual_examples.lua:
---
---   luajit scripts/manual.lua       writes docs/api.md

package.path = "./?.lua;" .. package.path

local docstrings = require("scripts.docstrings")
local examples = require("scripts.manual_examples")
local fields = require("scripts.meanings")
local typedFields = require("scripts.typed_fields")

local manual = {}

-- Only sentences that belong to no single function or field are written here.
local HEAD = [[
# Reference

Every public field, setting, function and type. `make docs` writes this page from the docstrings and
from [fields.lua](../physics/world/fields.lua). Editors that know LuaLS or EmmyLua annotations
show the same texts while you type. The [guide](guide/index.md) explains the ideas behind them.

- x grows to the right, y grows **down**. `x, y` is the top-left corner.
- Lengths are in px, times in s, velocities in px/s, accelerations in px/s².
- A `?` marks a parameter that you may leave out, and a result that may be nil.
- A call with a value that it cannot use raises an error. The message names the place, the field,
  what was expected and what was found, at the line of your game. Nothing has changed then.
- Every method of a world is also a function of the module, for the default world. It is called with
  a dot then: `physics.update(dt)`.
]]

local FIELDS = [[
These are the fields of your tables that the library knows. Other fields are yours. The library
writes `x, y, vx, vy` and `touching` of dynamic objects, and `x, y` of kinematic ones.

- Fields of dynamic and kinematic objects may change at any time.
- A static object is read only once: after a change call [`world:refresh`](#worldrefresh). The
  callbacks `onBegin` and `onEnd` are read when they are called.
]]

local AREAS = [[
What the field [`area`](#field-area) of a zone may hold. See [Zones](guide/motion.md#zones).
]]

local SETTINGS = [[
Settings are given to [`physics.newWorld`](#physicsnewworld) or [`physics.load`](#physicsload).
After that they are plain fields of the world: `world.gravity = 0`. The list `order` must be
replaced by another list to change it; `masks` and `soft` may also be changed in place.
]]

local MODULE = [[
`local physics = require "physics"`. Besides these functions the module has every method of a world,
for the default world. `physics.gravity`, `physics.objects`, `physics.stats`, `physics.onBegin` and
so on are fields of that world.
]]

local WORLD = [[
`local world = physics.newWorld(settings)`. The [settings](#settings) are plain fields of a world,
and so are these:
]]

local TYPES = [[
Names of types in the annotations. Your editor shows them; at run time they are plain tables. A
class of your own is `---@class Player: physics.Object`. A local that is filled later is
`local player ---@type physics.Object`.
]]

local TILES = [[
What `world:addTiles` returns, and what is in `level.tileLayers` of a map from Tiled or LDtk: see
[Maps](maps.md).
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

-- Types in a narrow column; the editor's types say more.
local KINDS = {
  mask = "table",
  masks = "table",
  soft = "table",
  names = "list",
  sides = "table",
  area = "table",
}
KINDS.ownFields = "list"

-- `place` begins the anchor of each row: "field-x", "setting-gravity".
local function addFields(lines, list, place)
  add(lines, "| name | type | default | unit, range | meaning |", "|---|---|---|---|---|")
  for _, field in ipairs(list) do
    local kind = KINDS[field.type] or field.type
    local range, unit = typedFields.range(field), field.unit or ""
    if range ~= "" then
      unit = unit == "" and range or unit .. ", " .. range
    end
    local default = typedFields.default(field)
    local row = '| <a id="%s-%s"></a>`%s` | %s | %s | %s | %s |'
    kind = cell(code(kind))
    local meaning = cell(fieldMeaning(field))
    add(lines, row:format(place, field.name:lower(), field.name, kind, default, unit, meaning))
  end
  add(lines, "")
end

-- Types that are the tables of fields above, or of no use to a game.
local HIDDEN = {
  ["physics.World"] = true,
  ["physics.NewObject"] = true,
  ["physics.Object"] = true,
  ["physics.Settings"] = true,
  ["physics.WorldSettings"] = true,
  ["physics.DefaultWorld"] = true,
  ["physics.Area"] = true,
}

-- A type, with a link if it has a section under "Types".
local function typeLink(kind)
  local name = kind:match("^physics%.(%u%w*)%??$")
  if not name or HIDDEN["physics." .. name] then
    return code(kind)
  end
  return ("[%s](#physics%s-type)"):format(code(kind), name:lower())
end

local function item(name, kind, text)
  kind = typeLink(kind)
  local head = name == "" and "- " .. kind or ("- `%s` (%s)"):format(name, kind)
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

-- "object, x, y = world:raycast(x1, y1, x2, y2, filter?)"
local function signature(entry, place)
  local results, parameters = {}, {}
  for i, result in ipairs(entry.returns) do
    results[i] = result.name == "" and result.type:match("([%w_]+)%??$"):lower() or result.name
  end
  for i, param in ipairs(entry.params) do
    local isOptional = param.type:find("%?$") or param.type:find("|nil$")
    parameters[i] = param.name .. (isOptional and "?" or "")
  end
  local head = #results > 0 and table.concat(results, ", ") .. " = " or ""
  return ("%s%s%s(%s)"):format(head, place, entry.name, table.concat(parameters, ", "))
end

local function addFunction(lines, entry, place)
  local name = place .. entry.name
  add(lines, "### " .. name, "", code(signature(entry, place)), "")
  addText(lines, entry.text)
  addItems(lines, "Parameters:", entry.params)
  addItems(lines, "Returns:", entry.returns)
  if examples[name] then
    add(lines, "```lua", (examples[name]:gsub("\n$", "")), "```", "")
  end
end

local function addFunctions(lines, path, owner, place)
  local _, list = docstrings.functions(path, owner)
  for _, entry in ipairs(list) do
    addFunction(lines, entry, place)
  end
end

local function addType(lines, entry)
  add(lines, ("### %s (type)"):format(entry.name), "")
  if entry.kind == "alias" then
    add(lines, code(entry.type), "")
  elseif entry.type ~= "" then
    add(lines, ("All fields of %s, and:"):format(typeLink(entry.type)), "")
  end
  addText(lines, entry.text)
  for _, field in ipairs(entry.fields) do
    if field.name:find("^%a") then
      add(lines, item(field.name, field.type, field.text))
    end
  end
  add(lines, "")
end

local function addTypes(lines, path)
  for _, entry in ipairs(docstrings.read(path)) do
    if entry.kind ~= "function" and not HIDDEN[entry.name] then
      addType(lines, entry)
    end
  end
end

-- The fields of a world that are not settings.
local function addWorldFields(lines)
  for _, entry in ipairs(docstrings.read(docstrings.WORLD)) do
    for _, field in ipairs(entry.name == "physics.World" and entry.fields or {}) do
      if field.name:find("^%a") then
        add(lines, item("world." .. field.name, field.type, field.text))
      end
    end
  end
  add(lines, "")
end

-- Links -------------------------------------------------------------------------------------------

-- The anchor that each name in code leads to. A function is found under its full name and, unless a
-- field or setting has the same name, under the short one.
local function anchors()
  local found = {}
  for _, source in ipairs({
    { "physics.lua", "physics", "physics." },
    { "physics/world/tutorial.lua", "pure", "physics." },
    { docstrings.WORLD, "World", "world:" },
    { "physics/maps/tiles.lua", "Tiles", "tiles:" },
  }) do
    local _, list = docstrings.functions(source[1], source[2])
    for _, entry in ipairs(list) do
      local anchor = "#" .. (source[3] .. entry.name):lower():gsub("[.:]", "")
      found[source[3] .. entry.name], found[entry.name] = anchor, anchor
    end
  end
  for _, field in ipairs(fields.settings) do
    found[field.name] = "#setting-" .. field.name:lower()
  end
  for _, field in ipairs(fields.objects) do
    found[field.name] = "#field-" .. field.name:lower()
  end
  for _, name in ipairs({ "side", "x", "y", "load" }) do -- mostly parameters and results
    found[name] = nil
  end
  return found
end

-- Makes links of the names and of the pages of docs/ in one line; `own` is the anchor of the
-- section that the line is in.
local function linkLine(line, found, own)
  line = line:gsub("docs/([%l_/-]+)%.md", "[%1](%1.md)")
  return (
    line:gsub("(%[?)`([%w_:.]+)`", function(bracket, name)
      local anchor = found[name]
      if bracket == "" and anchor and anchor ~= own then
        return ("[`%s`](%s)"):format(name, anchor)
      end
    end)
  )
end

-- Code, headings and the first cells of tables stay as they are.
local function addLinks(text)
  local found, lines, own, isCode = anchors(), {}, nil, false
  for line in (text .. "\n"):gmatch("([^\n]*)\n") do
    local title, linked = line:match("^### (.*)$"), line
    if title then
      own = "#" .. title:lower():gsub("[.:]", "")
    elseif line:find("^```") then
      isCode = not isCode
    elseif not (isCode or line:find("^    ") or line:find("^#")) then
      local head, rest = line:match("^(|[^|]*|)(.*)$")
      if not head then
        head, rest = line:match("^(%- `[^`]*` %()(.*)$")
      end
      linked = (head or "") .. linkLine(rest or line, found, own)
    end
    lines[#lines + 1] = linked
  end
  return table.concat(lines, "\n")
end

-- The page ---------------------------------------------------------------------------------------

--- Returns the text of docs/api.md.
---@return string
function manual.text()
  local lines = { HEAD, "## Fields of objects", "", FIELDS }
  addFields(lines, fields.objects, "field")
  add(lines, "## Areas", "", AREAS)
  addFields(lines, fields.area, "area")
  add(lines, "## Settings", "", SETTINGS)
  addFields(lines, fields.settings, "setting")
  add(lines, "## The module", "", MODULE)
  addFunctions(lines, "physics.lua", "physics", "physics.")
  addFunctions(lines, "physics/world/tutorial.lua", "pure", "physics.")
  add(lines, "## Worlds", "", WORLD)
  addWorldFields(lines)
  addFunctions(lines, docstrings.WORLD, "World", "world:")
  add(lines, "## Tiles", "", TILES)
  addFunctions(lines, "physics/maps/tiles.lua", "Tiles", "tiles:")
  add(lines, "## Types", "", TYPES)
  addTypes(lines, "physics/types.lua")
  addTypes(lines, docstrings.WORLD)
  local files = { "world/draw", "maps/tiles", "maps/array", "maps/tiled", "maps/ldtk" }
  for _, file in ipairs(files) do
    local path = "physics/" .. file .. ".lua"
    addTypes(lines, path)
  end
  local text = table.concat(lines, "\n"):gsub("\n\n\n+", "\n\n"):gsub("%s+$", "")
  return addLinks(text) .. "\n"
end

if arg and arg[0] and arg[0]:find("scripts/manual.lua", 1, true) then
  local file = assert(io.open("docs/api.md", "wb"))
  file:write(manual.text())
  file:close()
end

return manual
