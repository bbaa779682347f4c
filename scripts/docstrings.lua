--- Reads the docstrings of Lua files: what scripts/manual.lua and scripts/types.lua write down.
--
-- A docstring is a run of lines with `---`, above a function or around `---@class` and `---@alias`.
-- Its text comes first, then its tags; a tag goes on in lines that begin with `---` and two spaces.

local files = require("spec.support.files")

local docstrings = {}

---@class docs.Param
---@field name string
---@field type string
---@field text string

---@class docs.Entry
---@field kind "function"|"class"|"alias"
---@field owner string? the table that the function stands in
---@field name string
---@field arguments string? as written, without the parentheses
---@field text string[] lines
---@field params docs.Param[]
---@field returns docs.Param[]
---@field fields docs.Param[] of a class
---@field type string? of an alias, and what a class is derived from
---@field tags string[] the lines of tags, as written

-- Splits "type and the rest" at the first space that does not belong to the type: a type goes on in
-- brackets, after `fun(a):` and around `|` and `&`.
local function splitType(text)
  local depth = 0
  for at = 1, #text do
    local char = text:sub(at, at)
    if char:find("[(<{%[]") then
      depth = depth + 1
    elseif char:find("[)>}%]]") then
      depth = depth - 1
    elseif char == " " and depth == 0 then
      local goesOn = text:sub(1, at - 1):find("[:|&,]%s*$") or text:find("^%s*[|&]", at)
      if not goesOn then
        return text:sub(1, at - 1), text:sub(at + 1)
      end
    end
  end
  return text, ""
end

-- Adds a parameter or field, "name type text".
local function addParam(list, name, rest)
  local kind, text = splitType(rest)
  table.insert(list, { name = name, type = kind, text = text })
end

local readTag = {}

function readTag.param(entry, text)
  addParam(entry.params, text:match("^(%S+)%s+(.*)$"))
end

readTag["return"] = function(entry, text)
  local kind, rest = splitType(text)
  local name, meaning = rest:match("^(%S+)%s*(.*)$")
  table.insert(entry.returns, { name = name or "", type = kind, text = meaning or "" })
end

-- Fields that are not the game's business are left out.
function readTag.field(entry, text)
  if not (text:find("^protected ") or text:find("^private ") or text:find("^package ")) then
    text = text:gsub("^public ", "")
    local name = text:match("^%b[]") or text:match("^%S+")
    addParam(entry.fields, name, text:sub(#name + 1):match("^%s+(.*)$"))
  end
end

function readTag.class(entry, text)
  entry.kind = "class"
  entry.name, entry.type = text:gsub("^%(partial%) ", ""):match("^([%w_.]+):?%s*(.*)$")
end

function readTag.alias(entry, text)
  entry.kind = "alias"
  entry.name, entry.type = text:match("^(%S+)%s+(.*)$")
end

local function newEntry()
  return { text = {}, params = {}, returns = {}, fields = {}, tags = {} }
end

-- A run of lines may declare several classes and aliases; the text belongs to the first.
local function readRun(lines, found)
  local entry = newEntry()
  for _, line in ipairs(lines) do
    local tags = entry.tags
    if line:find("^@") then
      tags[#tags + 1] = line
    elseif #tags > 0 then
      tags[#tags] = tags[#tags] .. " " .. line:match("^%s*(.-)$")
    else
      table.insert(entry.text, (line:gsub("^ ", "")))
    end
  end
  local last = entry
  for _, tag in ipairs(entry.tags) do
    local name, text = tag:match("^@(%w+)%s*(.*)$")
    local isDeclared = name == "class" or name == "alias"
    if isDeclared and last.kind then
      last = newEntry()
    end
    if readTag[name] then
      readTag[name](last, text)
    end
    found[#found + 1] = isDeclared and last or nil
  end
  return entry
end

-- "function World:update(dt)", or "local function step(self, dt)", which has no owner.
local function readHead(entry, line, found)
  local owner, name, arguments = line:match("^function ([%w_]+)[.:]([%w_]+)%((.*)%)")
  if owner and #entry.text > 0 then
    entry.kind, entry.owner, entry.name, entry.arguments = "function", owner, name, arguments
    found[#found + 1] = entry
  end
end

--- Returns the entries of files, in their order.
---@param paths string[]
---@return docs.Entry[]
function docstrings.read(paths)
  local found = {}
  for _, path in ipairs(paths) do
    local run = {}
    for line in files.read(path):gmatch("([^\n]*)\n") do
      local comment = line:match("^%-%-%-(.*)$")
      if comment then
        run[#run + 1] = comment
      elseif #run > 0 then
        local entry = readRun(run, found)
        if not entry.kind then
          readHead(entry, line, found)
        end
        run = {}
      end
    end
  end
  return found
end

--- The functions of the reference, in its order: their files, their owner there, and the beginning
--- of their names.
docstrings.SOURCES = {
  { paths = { "physics.lua" }, owner = "physics", place = "physics." },
  { paths = { "physics/world/tutorial.lua" }, owner = "pure", place = "physics." },
  {
    paths = {
      "physics/world/class.lua",
      "physics/world/world.lua",
      "physics/world/queryMethods.lua",
    },
    owner = "World",
    place = "world:",
  },
  { paths = { "physics/maps/tiles.lua" }, owner = "Tiles", place = "tiles:" },
  { paths = { "physics/maps/atlas.lua" }, owner = "Atlas", place = "level:" },
}

--- Returns the functions of a source.
---@param source table a row of `SOURCES`
---@return docs.Entry[]
function docstrings.functions(source)
  local list = {}
  for _, entry in ipairs(docstrings.read(source.paths)) do
    list[#list + 1] = entry.owner == source.owner and entry or nil
  end
  return list
end

--- Returns the fields of a world that are no settings.
---@return docs.Param[]
function docstrings.worldFields()
  local list = {}
  for _, entry in ipairs(docstrings.read(docstrings.SOURCES[3].paths)) do
    for _, field in ipairs(entry.name == "physics.World" and entry.fields or {}) do
      list[#list + 1] = field
    end
  end
  return list
end

return docstrings
