--- Writes the reference, docs/api.md and docs/api/, from the docstrings,
--- physics/fields/fields.lua and scripts/manual_examples.lua:
---
---   luajit scripts/manual.lua           writes the pages
---   luajit scripts/manual.lua --names   prints the names for the editor of the playground, as JSON

package.path = "./?.lua;" .. package.path

local docstrings = require("scripts.docstrings")
local examples = require("scripts.manual_examples")
local fields = require("scripts.meanings")
local typedFields = require("scripts.typed_fields")

local manual = {}

-- Only sentences that belong to no single function or field are written here.
local INDEX = [[
# Reference

Every public field, setting, function and type. Editors with LuaLS or EmmyLua annotations show the
same texts while you type. The [guide](guide/index.md) explains the ideas.

- x grows to the right, y grows **down**. `x, y` is the top-left corner.
- Lengths are in px, times in s, velocities in px/s, accelerations in px/s².
- A `?` marks an argument that you may leave out, and a result that may be nil.
- Every method of a world is also a function of the module, for the default world:
  `physics.update(dt)`.
- A wrong value raises an error at the line of your game, and nothing has changed.
- Refused everywhere: arguments, fields, settings and options that are unknown or of a wrong type
  or range; NaN and infinity; objects that are not in the world (except in `remove`); a change
  from inside `canCollide`. The entries list other errors only.
]]

local FIELDS = [[
The fields of your tables that the library knows. Other fields are yours. The library writes `x,
y, vx, vy` and `touching` of dynamic objects, and `x, y` of kinematic ones.

- Fields of dynamic and kinematic objects may change at any time.
- A static object is read only once: after a change call `world:refresh`. `onBegin` and `onEnd`
  are read when they are called.
]]

local AREAS = [[
The entries of the field `area` of a [zone](../guide/motion.md#zones).
]]

local SETTINGS = [[
Settings are given to `physics.newWorld` or `physics.load`. After that they are plain fields of
the world: `world.gravity = 0`. To change `order` set another list; `masks` and `soft` may also be
changed in place.
]]

local WORLD = [[
`local world = physics.newWorld(settings)`. The [settings](settings.md) are plain fields of a
world, and so are these:
]]

local PURE = [[
Pure functions of the tutorial. They need no world.
]]

local QUERIES = [[
Queries change nothing, and you may call them anywhere. The [guide](../guide/queries.md) has a
table of questions.

- `filter` says which objects count, default all: the name of a group, a list of names, or a
  function of the object.
- `out` is a list that is filled again in place of a new one.
- Lists are in the order of the world, and come with their length `count`.
- To overlap is to do so by more than 1e-6 px. With the setting `sideBySide` flush objects
  count, too.
]]

local TYPES = [[
Your editor shows these names; at run time they are plain tables. A class of your own is
`---@class Player: physics.Object`. A local that is filled later is `local player ---@type
physics.Object`.
]]

local MAPS = [[
How to make maps that work: [Maps](../maps.md).
]]

local ATLAS = [[
The result of `world:loadTiled` for a world of the editor: see
[Maps](../maps.md#worlds-of-several-maps).
]]

local TILES = [[
The result of `world:addTiles`, and the values of `level.tileLayers` of a map from Tiled or LDtk.
]]

-- The tables of the fields of objects.
local GROUPS = {
  { title = "Place and shape", names = "x y width height radius slope" },
  { title = "Kind", names = "static kinematic active sensor area" },
  {
    title = "Motion",
    names = "vx vy ax ay gravity gravityX airFriction drag "
      .. "maxSpeed maxSpeedX maxSpeedY maxFallSpeed",
  },
  { title = "Walking and riding", names = "nudge snap constantSpeed carry surfaceSpeed" },
  {
    title = "Contacts",
    names = "touching mass pushable strength friction restitution mask hits oneWay",
  },
  { title = "Events", names = "onBegin onStay onEnd onCrush canCollide" },
}

-- What each page of docs/api/ is about, in the order of the index.
local PAGES = {
  { name = "fields", title = "Fields of objects" },
  { name = "settings", title = "Settings" },
  { name = "world", title = "The module and its worlds" },
  { name = "queries", title = "Queries and moves" },
  { name = "maps", title = "Maps and tiles" },
  { name = "types", title = "Types" },
}

-- Functions that stand on another page than their file says.
local ON_WORLD = { ["world:draw"] = true, ["world:interpolate"] = true }
local ON_MAPS = { ["world:loadTiled"] = true, ["world:addTiles"] = true, ["world:loadLDtk"] = true }
local ON_QUERIES = { ["world:move"] = true }

local function add(lines, ...)
  for i = 1, select("#", ...) do
    lines[#lines + 1] = (select(i, ...))
  end
end

-- A bar would end the cell of a table.
local function cell(text)
  return (text:gsub("|", "\\|"))
end

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

-- Kinds of values in a narrow column; the editor's types say more.
local KINDS = {
  number = "",
  mask = "table",
  masks = "table",
  soft = "table",
  names = "list",
  ownFields = "list",
  sides = "table",
  area = "table",
}

-- Returns what a value is: "px, > 0", "boolean", "table, px/s".
local function kindOf(field)
  local parts = {}
  local kind = KINDS[field.type] or field.type
  for _, part in ipairs({ kind, field.unit or "", typedFields.range(field) }) do
    if part ~= "" then
      parts[#parts + 1] = part
    end
  end
  return table.concat(parts, ", ")
end

-- `place` begins the anchor of each row: "field-x", "setting-gravity".
local function addFields(lines, list, place)
  add(lines, "| name | value | default | meaning |", "|---|---|---|---|")
  for _, field in ipairs(list) do
    local row = '| <a id="%s-%s"></a>`%s` | %s | %s | %s |'
    local default, meaning = typedFields.default(field), cell(fieldMeaning(field))
    add(lines, row:format(place, field.name:lower(), field.name, kindOf(field), default, meaning))
  end
  add(lines, "")
end

-- The fields of objects, a table for each group; fields that no group names come last.
local function addGroups(lines)
  local named, rest = {}, {}
  for _, group in ipairs(GROUPS) do
    local rows = {}
    for name in group.names:gmatch("%S+") do
      rows[#rows + 1], named[name] = assert(fields.objectByName[name], name), true
    end
    add(lines, "## " .. group.title, "")
    addFields(lines, rows, "field")
  end
  for _, field in ipairs(fields.objects) do
    rest[#rest + 1] = not named[field.name] and field or nil
  end
  if #rest > 0 then
    add(lines, "## More", "")
    addFields(lines, rest, "field")
  end
end

-- Types that are the tables of fields above, or of no use to a game.
local HIDDEN = {
  ["physics.World"] = true,
  ["physics.NewObject"] = true,
  ["physics.NewBox"] = true,
  ["physics.NewCircle"] = true,
  ["physics.ObjectFields"] = true,
  ["physics.Object"] = true,
  ["physics.Settings"] = true,
  ["physics.WorldSettings"] = true,
  ["physics.DefaultWorld"] = true,
  ["physics.Area"] = true,
}

-- Texts of parameters and results that the head of the index or of a page says once.
local KNOWN = {
  ["px"] = true,
  ["the object"] = true,
  ["an object of the world"] = true,
  ["one of the two"] = true,
  ["the other one"] = true,
  ["a dynamic object"] = true,
  ["which objects are pushed, default all"] = true,
  ["which objects count, default all"] = true,
  ["list to fill, default a new one"] = true,
  ["in the order of the world"] = true,
}

local LIKE = { likewise = true }

-- Joins neighbours in a list that say the same of the same type: "`x`, `y` (`number`): px".
local function joined(list)
  local items = {}
  for _, param in ipairs(list) do
    local last = items[#items]
    local isSame = last and last.type == param.type
    if isSame and (last.text == param.text or LIKE[param.text]) then
      last.name = last.name .. "`, `" .. param.name
    elseif not KNOWN[param.text] then
      items[#items + 1] = { name = param.name, type = param.type, text = param.text }
    end
  end
  return items
end

-- A number needs no word for its type: its unit says it.
local function item(param, mark)
  local kind, text = code(param.type), param.text
  local head = param.name == "" and kind or ("`%s` (%s)"):format(param.name, kind)
  if param.type == "number" and text ~= "" and param.name ~= "" then
    head = "`" .. param.name .. "`"
  end
  return "- " .. mark .. head .. (text == "" and "" or ": " .. text)
end

local function addItems(lines, list, mark, isTerse)
  for _, param in ipairs(joined(list)) do
    if not (isTerse and param.text == "") then
      add(lines, item(param, mark))
    end
  end
end

-- What the index says of every function.
local COMMON = {
  "it is called from inside `canCollide`",
  "a number is not finite",
  "a coordinate is not a finite number",
  "a distance is not a finite number",
  "the object is not a table, or not in the world",
  "the object is not a table",
  "`a` or `b` is not a table, or not in the world",
  "`a` or `b` is not a table",
  "the filter cannot be used",
  "a filter cannot be used",
  "`out` is not a table",
  "a size is <= 0",
  "the radius is <= 0",
  "a setting is unknown or has a value that cannot be used",
  "an unknown option, or a wrong value for one",
  "a field has a value that cannot be used",
  "a field of an object cannot be used",
  "a field or setting that `update` would refuse",
  "a group, key, field or setting has a value that cannot be used (nothing has changed then)",
  "the group is not a string or a number",
  "dt is not a number >= 0",
  "the count is not an integer >= 1",
  "`vx`, `vy` or `mass` of an object cannot be used",
  "its `vx`, `vy` or `mass` cannot be used",
  "a number is missing, NaN or infinite",
  "`a` or `b` has no usable x, y, width, height",
  "`sideBySide` is not a boolean",
  "the cells, the size or an option cannot be used",
}

-- Returns the errors of a function that are its own, or nil.
local function ownErrors(text)
  text = text:gsub("%s*Nothing has [^.]+ then%.", ""):gsub("%.$", "")
  local own = {}
  for clause in (text .. ";"):gmatch("%s*(.-);") do
    local isCommon = false
    for _, common in ipairs(COMMON) do
      isCommon = isCommon or clause == common
    end
    if not isCommon then
      own[#own + 1] = clause
    end
  end
  return own[1] and table.concat(own, "; ") .. "."
end

-- The text of a docstring is Markdown already. Its paragraph "Source:" is for readers of the code.
local function addText(lines, text)
  local i = 1
  while i <= #text do
    local word, rest = text[i]:match("^(%u%l+):%s(.*)$")
    if word == "Errors" or word == "Source" then
      while text[i + 1] and text[i + 1] ~= "" and not text[i + 1]:find("^%u%l+: ") do
        i = i + 1
        rest = rest .. " " .. text[i]
      end
      local own = word == "Errors" and ownErrors(rest)
      if own then
        add(lines, "", "**Errors:** " .. own)
      end
    else
      add(lines, text[i])
    end
    i = i + 1
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
  add(lines, "## " .. name, "", code(signature(entry, place)), "")
  addText(lines, entry.text)
  addItems(lines, entry.params, "", true)
  addItems(lines, entry.returns, "returns ", true)
  add(lines, "")
  if examples[name] then
    add(lines, "```lua", (examples[name]:gsub("\n$", "")), "```", "")
  end
end

-- The file, the table and the beginning of the names of each list of functions.
local SOURCES = {
  { "physics.lua", "physics", "physics." },
  { "physics/world/tutorial.lua", "pure", "physics." },
  { docstrings.WORLD, "World", "world:" },
  { "physics/maps/tiles.lua", "Tiles", "tiles:" },
  { "physics/maps/atlas.lua", "Atlas", "level:" },
}

-- Returns the page of a function of docs/api/.
local function pageOf(name, entry)
  if ON_MAPS[name] or name:find("^tiles:") or name:find("^level:") then
    return "maps"
  elseif ON_WORLD[name] or name:find("^physics%.") then
    return "world"
  elseif ON_QUERIES[name] then
    return "queries"
  end
  return entry.path:find("queryMethods", 1, true) and "queries" or "world"
end

-- All functions in the order of their files: `entry`, `place`, `name`, `page`, `owner`.
local function functions()
  local found = {}
  for _, source in ipairs(SOURCES) do
    local paths = type(source[1]) == "table" and source[1] or { source[1] }
    for _, path in ipairs(paths) do
      local _, list = docstrings.functions(path, source[2])
      for _, entry in ipairs(list) do
        entry.path = path
        local name = source[3] .. entry.name
        found[#found + 1] = {
          entry = entry,
          place = source[3],
          name = name,
          page = pageOf(name, entry),
          owner = source[2],
        }
      end
    end
  end
  return found
end

-- Types with fields that the page Maps lists.
local ON_MAPS_PAGE = {
  ["physics.TiledOptions"] = true,
  ["physics.LDtkOptions"] = true,
  ["physics.TileOptions"] = true,
  ["physics.Level"] = true,
  ["physics.LDtkLevel"] = true,
  ["physics.TilePlace"] = true,
  ["physics.Mark"] = true,
  ["physics.AtlasMap"] = true,
}

local function addType(lines, entry)
  add(lines, ("## %s (type)"):format(entry.name), "")
  if entry.kind == "alias" then
    add(lines, code(entry.type), "")
  elseif entry.type ~= "" then
    add(lines, ("All fields of %s, and:"):format(code(entry.type)), "")
  end
  addText(lines, entry.text)
  local shown, isElsewhere = {}, ON_MAPS_PAGE[entry.name]
  if isElsewhere then
    add(lines, "Fields: [Maps](../maps.md).", "")
  end
  for _, field in ipairs(entry.fields) do
    if field.name:find("^%a") and not isElsewhere then
      shown[#shown + 1] = field
    end
  end
  addItems(lines, shown, "")
  add(lines, "")
end

local function addTypes(lines, paths)
  for _, entry in ipairs(docstrings.read(paths)) do
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
        add(
          lines,
          item({ name = "world." .. field.name, type = field.type, text = field.text }, "")
        )
      end
    end
  end
  add(lines, "")
end

-- The files with the types of each page.
local TYPES_OF = {
  types = {
    "physics/types.lua",
    "physics/world/world.lua",
    "physics/world/queryMethods.lua",
    "physics/world/draw.lua",
  },
  maps = {
    "physics/maps/tiles.lua",
    "physics/maps/array.lua",
    "physics/maps/tiled.lua",
    "physics/maps/atlas.lua",
    "physics/maps/ldtk.lua",
  },
}

-- Links -------------------------------------------------------------------------------------------

local function anchorOf(name)
  return "#" .. name:lower():gsub("[.:]", "")
end

-- The place that each name in code leads to, "queries.md#worldraycast". A function is found under
-- its full name and, unless a field or setting has the same name, under the short one.
local function targets()
  local found = {}
  for _, each in ipairs(functions()) do
    local target = each.page .. ".md" .. anchorOf(each.name)
    found[each.name], found[each.entry.name] = target, target
  end
  for page, paths in pairs(TYPES_OF) do
    for _, entry in ipairs(docstrings.read(paths)) do
      if entry.kind ~= "function" and not HIDDEN[entry.name] then
        found[entry.name] = page .. ".md" .. anchorOf(entry.name) .. "-type"
      end
    end
  end
  for _, field in ipairs(fields.settings) do
    found[field.name] = "settings.md#setting-" .. field.name:lower()
  end
  for _, field in ipairs(fields.objects) do
    found[field.name] = "fields.md#field-" .. field.name:lower()
  end
  for _, name in ipairs({ "side", "x", "y", "load" }) do -- mostly parameters and results
    found[name] = nil
  end
  return found
end

-- Makes links of the names and of the pages of docs/ in one line of a page; `own` is the anchor of
-- the section that the line is in. On the index the pages lie in a folder.
local function linkLine(line, found, own, page)
  line = line:gsub("docs/([%l_/-]+)%.md", "[%1](../%1.md)")
  return (
    line:gsub("(%[?)`([%w_:.]+%??)`", function(bracket, name)
      local target = found[(name:gsub("%?$", ""))]
      if bracket == "" and target and target ~= page .. ".md" .. own then
        local link = target:gsub("^" .. page .. "%.md", "")
        return ("[`%s`](%s%s)"):format(name, page == "index" and "api/" or "", link)
      end
    end)
  )
end

-- Code, headings and the first cells of tables stay as they are.
local function addLinks(lines, page)
  local found, result, own, isCode = targets(), {}, "", false
  for line in (table.concat(lines, "\n") .. "\n"):gmatch("([^\n]*)\n") do
    local title, linked = line:match("^##+ (.*)$"), line
    if title then
      own = anchorOf(title)
    elseif line:find("^```") then
      isCode = not isCode
    elseif not (isCode or line:find("^    ") or line:find("^#") or line:find("^`")) then
      local head, rest = line:match("^(|[^|]*|)(.*)$")
      if not head then
        head, rest = line:match("^(%- [returns ]*`[^(]*` %()(.*)$")
      end
      linked = (head or "") .. linkLine(rest or line, found, own, page)
    end
    result[#result + 1] = linked
  end
  local text = table.concat(result, "\n"):gsub("\n\n\n+", "\n\n"):gsub("%s+$", "")
  return text .. "\n"
end

-- The pages --------------------------------------------------------------------------------------

local function addFunctions(lines, page, owner)
  for _, each in ipairs(functions()) do
    if each.page == page and each.owner == owner then
      addFunction(lines, each.entry, each.place)
    end
  end
end

local write = {}

function write.fields(lines)
  add(lines, FIELDS)
  addGroups(lines)
  add(lines, "## Areas", "", AREAS)
  addFields(lines, fields.area, "area")
end

function write.settings(lines)
  add(lines, SETTINGS)
  addFields(lines, fields.settings, "setting")
end

function write.world(lines)
  add(lines, WORLD)
  addWorldFields(lines)
  addFunctions(lines, "world", "physics")
  addFunctions(lines, "world", "World")
  add(lines, "## The tutorial's functions", "", PURE)
  addFunctions(lines, "world", "pure")
end

function write.queries(lines)
  add(lines, QUERIES)
  addFunctions(lines, "queries", "World")
end

function write.maps(lines)
  add(lines, MAPS)
  addFunctions(lines, "maps", "World")
  add(lines, "## Tiles", "", TILES)
  addFunctions(lines, "maps", "Tiles")
  add(lines, "## Levels of several maps", "", ATLAS)
  addFunctions(lines, "maps", "Atlas")
  addTypes(lines, TYPES_OF.maps)
end

function write.types(lines)
  add(lines, TYPES)
  addTypes(lines, TYPES_OF.types)
end

local function index()
  local lines = { INDEX }
  for _, page in ipairs(PAGES) do
    add(lines, ("**[%s](api/%s.md)**"):format(page.title, page.name))
    local names = {}
    for _, each in ipairs(functions()) do
      if each.page == page.name then
        names[#names + 1] = code(each.name)
      end
    end
    add(lines, #names > 0 and ": " .. table.concat(names, " ") or "", "")
  end
  return addLinks(lines, "index"):gsub("%*%*\n: ", "**: ")
end

--- Returns the pages of the reference: path -> text.
---@return table<string, string>
function manual.pages()
  local pages = { ["docs/api.md"] = (index()) }
  for _, page in ipairs(PAGES) do
    local lines = { "# " .. page.title, "" }
    write[page.name](lines)
    pages["docs/api/" .. page.name .. ".md"] = addLinks(lines, page.name)
  end
  return pages
end

local function quoted(text)
  return '"' .. text:gsub('[%c"\\]', { ['"'] = '\\"', ["\\"] = "\\\\", ["\n"] = " " }) .. '"'
end

-- Adds a name with what it is, what it means, and where the reference has it.
local function addName(list, name, kind, detail, text, place)
  local values = { name, kind, detail, text, "api/" .. place:gsub("%.md#", "/#") }
  for i, value in ipairs(values) do
    values[i] = quoted(value)
  end
  list[#list + 1] = "[" .. table.concat(values, ",") .. "]"
end

--- Returns all names as JSON: a list of [name, "function"|"field"|"setting", detail, text, place].
---@return string
function manual.names()
  local list = {}
  for _, each in ipairs(functions()) do
    local text = (table.concat(each.entry.text, " ") .. " "):match("^(.-%.) ")
    local place = each.page .. ".md" .. anchorOf(each.name)
    addName(list, each.name, "function", signature(each.entry, each.place), text, place)
  end
  for _, field in ipairs(fields.objects) do
    local place = "fields.md#field-" .. field.name:lower()
    addName(list, field.name, "field", kindOf(field), field.meaning, place)
  end
  for _, field in ipairs(fields.settings) do
    local place = "settings.md#setting-" .. field.name:lower()
    addName(list, field.name, "setting", kindOf(field), field.meaning, place)
  end
  return "[" .. table.concat(list, ",\n") .. "]\n"
end

local isProgram = arg and arg[0] and arg[0]:find("scripts/manual.lua", 1, true)
if isProgram and arg[1] == "--names" then
  io.write(manual.names())
elseif isProgram then
  os.execute("mkdir -p docs/api")
  for path, text in pairs(manual.pages()) do
    local file = assert(io.open(path, "wb"))
    file:write(text)
    file:close()
  end
end

return manual
