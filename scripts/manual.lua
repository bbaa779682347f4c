--- Writes the reference, docs/api.md and docs/api/, from the docstrings and
--- physics/fields/fields.lua:
---
---   luajit scripts/manual.lua           writes the pages
---   luajit scripts/manual.lua --names   prints the names for the editor of the playground, as JSON
---
--- What is written by hand stays: the text under the heading of a page or section, up to the first
--- table, field or heading, and the example at the end of each function (the specs run it:
--- spec/project/docs_spec.lua).

package.path = "./?.lua;" .. package.path

local docstrings = require("scripts.docstrings")
local fields = require("scripts.meanings")
local files = require("spec.support.files")

local manual = {}

local function set(texts)
  local found = {}
  for text in texts:gmatch("%s*([^;]+)") do
    found[text:gsub("%s+$", "")] = true
  end
  return found
end

-- The tables of the fields of objects.
local GROUPS = {
  { "Place and shape", "x y width height radius slope" },
  { "Kind", "static kinematic active sensor area" },
  {
    "Motion",
    "vx vy ax ay gravity gravityX airFriction drag maxSpeed maxSpeedX maxSpeedY maxFallSpeed",
  },
  { "Walking and riding", "nudge snap constantSpeed carry surfaceSpeed" },
  { "Contacts", "touching mass pushable strength friction restitution mask hits oneWay" },
  { "Events", "onBegin onStay onEnd onCrush canCollide" },
}

-- The files with the types of two pages.
local WORLD, MAPS = { "physics/types.lua" }, {}
for _, name in ipairs({ "world", "queryMethods", "draw" }) do
  WORLD[#WORLD + 1] = ("physics/world/%s.lua"):format(name)
end
for _, name in ipairs({ "tiles", "array", "tiled", "atlas", "ldtk" }) do
  MAPS[#MAPS + 1] = ("physics/maps/%s.lua"):format(name)
end

-- The pages of docs/api/, in the order of the index: the owners of functions and the headings of
-- their parts, and the files with types.
local PAGES = {
  { name = "fields", title = "Fields of objects" },
  { name = "settings", title = "Settings" },
  {
    name = "world",
    title = "The module and its worlds",
    parts = { "physics", "World", "## The tutorial's functions", "pure" },
  },
  { name = "queries", title = "Queries and moves", parts = { "World" } },
  {
    name = "maps",
    title = "Maps and tiles",
    parts = { "World", "## Tiles", "Tiles", "## Levels of several maps", "Atlas" },
    types = MAPS,
  },
  { name = "types", title = "Types", types = WORLD },
}

-- Methods of worlds that stand on other pages than "world".
local PAGE_OF = { loadTiled = "maps", addTiles = "maps", loadLDtk = "maps", move = "queries" }
for _, entry in ipairs(docstrings.read({ "physics/world/queryMethods.lua" })) do
  PAGE_OF[entry.name] = PAGE_OF[entry.name] or "queries"
end
PAGE_OF.draw, PAGE_OF.interpolate = "world", "world"

-- Types that are the tables of fields, or of no use to a game.
local HIDDEN = set([[
  physics.World; physics.NewObject; physics.NewBox; physics.NewCircle; physics.ObjectFields;
  physics.Object; physics.Settings; physics.WorldSettings; physics.DefaultWorld; physics.Area
]])

-- Types with fields that the page Maps lists.
local ON_MAPS_PAGE = set([[
  physics.TiledOptions; physics.LDtkOptions; physics.TileOptions; physics.Level; physics.LDtkLevel;
  physics.TilePlace; physics.Mark; physics.AtlasMap
]])

-- Texts of parameters and results that the head of the index or of a page says once.
local KNOWN = set([[
  px; the object; an object of the world; one of the two; the other one; a dynamic object;
  which objects are pushed, default all; which objects count, default all;
  list to fill, default a new one; in the order of the world
]])

-- Errors that the index says of every function, as patterns.
local COMMON = {
  "^it is called",
  "^an unknown option",
  "^[^w].* cannot be used$",
  "^%w+ %w+ is <= 0$",
  " is not an? [^,]*$",
  " is not a table, or not in the world$",
  " is not finite$",
  " would refuse$",
  " NaN ",
  " no usable ",
  "changed then%)$",
}

local function add(lines, ...)
  for i = 1, select("#", ...) do
    lines[#lines + 1] = (select(i, ...))
  end
end

local function code(text)
  return "`" .. text .. "`"
end

-- All functions in the order of their files, with their `full` name and `page`.
local FUNCTIONS = {}
for _, source in ipairs(docstrings.SOURCES) do
  for _, entry in ipairs(docstrings.functions(source)) do
    local isMap = source.owner == "Tiles" or source.owner == "Atlas"
    local page = source.owner == "World" and PAGE_OF[entry.name]
    entry.full = source.place .. entry.name
    entry.page = page or isMap and "maps" or "world"
    FUNCTIONS[#FUNCTIONS + 1] = entry
  end
end

local function typesOf(page)
  local list = {}
  for _, entry in ipairs(docstrings.read(page.types or {})) do
    list[#list + 1] = entry.kind ~= "function" and not HIDDEN[entry.name] and entry or nil
  end
  return list
end

-- What is written by hand ------------------------------------------------------------------------

-- Returns the text of a page below a heading, up to the next one.
local function sectionOf(page, heading)
  local _, from = ("\n" .. page):find("\n" .. heading .. "\n", 1, true)
  local text = from and page:sub(from) or ""
  return text:sub(1, (text:find("\n##? ") or 0) - 1)
end

-- Adds a heading and the text below it that is written by hand.
local function addHeading(lines, old, heading)
  add(lines, heading, "")
  for line in sectionOf(old, heading):gmatch("([^\n]*)\n") do
    if line:find("^|") or line:find("^%*%*%[") or line:find("^%- `world%.") then
      break
    end
    add(lines, line)
  end
  add(lines, "")
end

-- Fields -----------------------------------------------------------------------------------------

local function fieldMeaning(field)
  local meaning = field.meaning
  if field.values then
    meaning = meaning .. ' One of `"' .. table.concat(field.values, '"`, `"') .. '"`.'
  end
  if field.signature then
    meaning = ("`%s%s` %s"):format(field.name, field.signature, meaning)
  end
  return (meaning:gsub("|", "\\|")) -- a bar would end the cell of the table
end

-- Kinds of values in a narrow column; the editor's types say more.
local KINDS = { number = "", names = "list", ownFields = "list", sides = "table", area = "table" }
KINDS.mask, KINDS.masks, KINDS.soft = "table", "table", "table"

-- Returns what a value is: "px, > 0", "boolean", "table, px/s".
local function kindOf(field)
  local parts = {}
  for _, part in ipairs({ KINDS[field.type] or field.type, field.unit or "", field.range }) do
    parts[#parts + 1] = part ~= "" and part or nil
  end
  return table.concat(parts, ", ")
end

-- `place` begins the anchor of each row: "field-x", "setting-gravity".
local function addFields(lines, list, place)
  add(lines, "| name | value | default | meaning |", "|---|---|---|---|")
  for _, field in ipairs(list) do
    local row = '| <a id="%s-%s"></a>`%s` | %s | %s | %s |'
    local name, kind, meaning = field.name, kindOf(field), fieldMeaning(field)
    add(lines, row:format(place, name:lower(), name, kind, field.standard, meaning))
  end
  add(lines, "")
end

-- The fields of objects, a table for each group; fields that no group names come last.
local function addGroups(lines)
  local named, rest = {}, {}
  for _, group in ipairs(GROUPS) do
    local rows = {}
    for name in group[2]:gmatch("%S+") do
      rows[#rows + 1], named[name] = assert(fields.objectByName[name], name), true
    end
    add(lines, "## " .. group[1], "")
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

-- Functions and types ----------------------------------------------------------------------------

-- Joins neighbours in a list that say the same of the same type: "`x`, `y` (`number`): px".
local function joined(list)
  local items = {}
  for _, param in ipairs(list) do
    local last = items[#items]
    local isSame = last and last.type == param.type
    if isSame and (last.text == param.text or param.text == "likewise") then
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

-- Returns the errors of a function that are its own, or nil.
local function ownErrors(text)
  text = text:gsub("%s*Nothing has [^.]+ then%.", ""):gsub("%.$", "")
  local own = {}
  for clause in (text .. ";"):gmatch("%s*(.-);") do
    local isCommon = false
    for _, common in ipairs(COMMON) do
      isCommon = isCommon or clause:find(common)
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
local function signature(entry)
  local results, parameters = {}, {}
  for i, result in ipairs(entry.returns) do
    results[i] = result.name == "" and result.type:match("([%w_]+)%??$"):lower() or result.name
  end
  for i, param in ipairs(entry.params) do
    local isOptional = param.type:find("%?$") or param.type:find("|nil$")
    parameters[i] = param.name .. (isOptional and "?" or "")
  end
  local head = #results > 0 and table.concat(results, ", ") .. " = " or ""
  return ("%s%s(%s)"):format(head, entry.full, table.concat(parameters, ", "))
end

local function addFunctions(lines, old, page, owner)
  for _, entry in ipairs(FUNCTIONS) do
    if entry.page == page and entry.owner == owner then
      local heading = "## " .. entry.full
      add(lines, heading, "", code(signature(entry)), "")
      addText(lines, entry.text)
      addItems(lines, entry.params, "", true)
      addItems(lines, entry.returns, "returns ", true)
      add(lines, "", sectionOf(old, heading):match("\n(```lua\n.-\n```)\n*$") or "", "")
    end
  end
end

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

local function addTypes(lines, page)
  for _, entry in ipairs(typesOf(page)) do
    addType(lines, entry)
  end
end

local function addWorldFields(lines)
  for _, field in ipairs(docstrings.worldFields()) do
    if field.name:find("^%a") then
      field.name = "world." .. field.name
      add(lines, item(field, ""))
    end
  end
  add(lines, "")
end

-- Links -------------------------------------------------------------------------------------------

local function anchorOf(name)
  return "#" .. name:lower():gsub("[.:]", "")
end

-- The place that each name in code leads to, "queries.md#worldraycast". A function is found under
-- its full name and, unless a field or setting has the same name, under the short one.
local function targets()
  local found = {}
  for _, entry in ipairs(FUNCTIONS) do
    local target = entry.page .. ".md" .. anchorOf(entry.full)
    found[entry.full], found[entry.name] = target, target
  end
  for _, page in ipairs(PAGES) do
    for _, entry in ipairs(typesOf(page)) do
      found[entry.name] = page.name .. ".md" .. anchorOf(entry.name) .. "-type"
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

-- What pages begin with.
local begin = { world = addWorldFields }

function begin.fields(lines, old)
  addGroups(lines)
  addHeading(lines, old, "## Areas")
  addFields(lines, fields.area, "area")
end

function begin.settings(lines)
  addFields(lines, fields.settings, "setting")
end

local function addPage(lines, old, page)
  addHeading(lines, old, "# " .. page.title)
  if begin[page.name] then
    begin[page.name](lines, old)
  end
  for _, part in ipairs(page.parts or {}) do
    if part:find("^#") then
      addHeading(lines, old, part)
    else
      addFunctions(lines, old, page.name, part)
    end
  end
  addTypes(lines, page)
end

local function index(old)
  local lines = {}
  addHeading(lines, old, "# Reference")
  for _, page in ipairs(PAGES) do
    local names = {}
    for _, entry in ipairs(FUNCTIONS) do
      names[#names + 1] = entry.page == page.name and code(entry.full) or nil
    end
    local head = ("**[%s](api/%s.md)**"):format(page.title, page.name)
    add(lines, head .. (names[1] and ": " or "") .. table.concat(names, " "), "")
  end
  return addLinks(lines, "index")
end

local function pathOf(page)
  return "docs/api/" .. page.name .. ".md"
end

--- Returns the pages of the reference: path -> text.
---@return table<string, string>
function manual.pages()
  local pages = { ["docs/api.md"] = index(files.read("docs/api.md")) }
  for _, page in ipairs(PAGES) do
    local lines = {}
    addPage(lines, files.read(pathOf(page)), page)
    pages[pathOf(page)] = addLinks(lines, page.name)
  end
  return pages
end

--- Returns all names as JSON: a list of [name, "function"|"field"|"setting", detail, text, place].
---@return string
function manual.names()
  local list = {}
  local function addName(...)
    list[#list + 1] = ("[%q,%q,%q,%q,%q]"):format(...)
  end
  for _, entry in ipairs(FUNCTIONS) do
    local text = (table.concat(entry.text, " ") .. " "):match("^(.-%.) ")
    local place = "api/" .. entry.page .. "/" .. anchorOf(entry.full)
    addName(entry.full, "function", signature(entry), text, place)
  end
  for _, row in ipairs({ { "field", "objects" }, { "setting", "settings" } }) do
    local kind, page = row[1], row[1] == "field" and "fields" or "settings"
    for _, field in ipairs(fields[row[2]]) do
      local place = ("api/%s/#%s-%s"):format(page, kind, field.name:lower())
      addName(field.name, kind, kindOf(field), field.meaning, place)
    end
  end
  return "[" .. table.concat(list, ",\n") .. "]\n"
end

local isProgram = arg and arg[0] and arg[0]:find("scripts/manual.lua", 1, true)
if isProgram and arg[1] == "--names" then
  io.write(manual.names())
elseif isProgram then
  for path, text in pairs(manual.pages()) do
    files.write(path, text)
  end
end

return manual
