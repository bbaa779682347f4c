--- Reads the docstrings of Lua files: what scripts/manual.lua and scripts/types.lua write down.
--
-- A docstring is a run of lines with `---`, above a function or around `---@class` and `---@alias`.
-- Its text comes first, then its tags; a tag goes on in lines that begin with `---` and two spaces.

local docstrings = {}

---@class docs.Param
---@field name string
---@field type string
---@field text string

---@class docs.Entry
---@field kind "function"|"class"|"alias"
---@field owner string? the table that the function stands in
---@field name string
---@field separator string? ":" or "."
---@field arguments string? as written, without the parentheses
---@field text string[] lines
---@field params docs.Param[]
---@field returns docs.Param[]
---@field fields docs.Param[] of a class
---@field type string? of an alias, and what a class is derived from
---@field tags string[] the lines of tags, as written

local CLOSING = { ["("] = ")", ["<"] = ">", ["{"] = "}", ["["] = "]" }

-- Whether the type goes on after a space: after `fun(a):` and around `|` and `&`.
local function isInside(text, at)
  return text:sub(1, at - 1):find("[:|&,]%s*$") ~= nil or text:find("^%s*[|&]", at) ~= nil
end

-- Splits "type and the rest" at the first space that does not belong to the type.
local function splitType(text)
  local depth = 0
  for at = 1, #text do
    local char = text:sub(at, at)
    if CLOSING[char] then
      depth = depth + 1
    elseif char == ")" or char == ">" or char == "}" or char == "]" then
      depth = depth - 1
    elseif char == " " and depth == 0 and not isInside(text, at) then
      return text:sub(1, at - 1), text:sub(at + 1)
    end
  end
  return text, ""
end

local readTag = {}

function readTag.param(entry, text)
  local name, rest = text:match("^(%S+)%s+(.*)$")
  local kind, meaning = splitType(rest)
  table.insert(entry.params, { name = name, type = kind, text = meaning })
end

readTag["return"] = function(entry, text)
  local kind, rest = splitType(text)
  local name, meaning = rest:match("^(%S+)%s*(.*)$")
  table.insert(entry.returns, { name = name or "", type = kind, text = meaning or "" })
end

-- Words in front of a field's name: whether it is the game's business.
local IS_PUBLIC = { public = true, protected = false, private = false, package = false }

function readTag.field(entry, text)
  local word, seen = text:match("^(%l+)%s+(.*)$")
  if IS_PUBLIC[word] == false then
    return
  elseif IS_PUBLIC[word] then
    text = seen
  end
  local name, rest = text:match("^(%b[])%s+(.*)$")
  if not name then
    name, rest = text:match("^(%S+)%s+(.*)$")
  end
  local kind, meaning = splitType(rest)
  table.insert(entry.fields, { name = name, type = kind, text = meaning })
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

-- Joins the lines of a tag; the others are text.
local function sortLines(lines)
  local text, tags = {}, {}
  for _, line in ipairs(lines) do
    if line:find("^@") then
      tags[#tags + 1] = line
    elseif #tags > 0 then
      tags[#tags] = tags[#tags] .. " " .. line:match("^%s*(.-)$")
    else
      text[#text + 1] = (line:gsub("^ ", ""))
    end
  end
  return text, tags
end

-- A run of lines may declare several classes and aliases; the text belongs to the first.
local function readRun(lines, found)
  local entry = newEntry()
  entry.text, entry.tags = sortLines(lines)
  local last = entry
  for _, tag in ipairs(entry.tags) do
    local name, text = tag:match("^@(%w+)%s*(.*)$")
    if (name == "class" or name == "alias") and last.kind then
      last = newEntry()
    end
    if readTag[name] then
      readTag[name](last, text)
    end
    if name == "class" or name == "alias" then
      found[#found + 1] = last
    end
  end
  return entry
end

-- "function World:update(dt)", or "local function step(self, dt)", which has no owner.
local function readHead(entry, line, found)
  local owner, separator, name, arguments = line:match("^function ([%w_]+)([.:])([%w_]+)%((.*)%)")
  if owner and #entry.text > 0 then
    entry.kind, entry.owner, entry.separator = "function", owner, separator
    entry.name, entry.arguments = name, arguments
    found[#found + 1] = entry
  end
end

local function readFile(path, found)
  local file, run = assert(io.open(path, "rb")), {}
  for line in file:lines() do
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
  file:close()
end

--- The files with the methods of a world, in the order of the reference.
docstrings.WORLD = {
  "physics/world/class.lua",
  "physics/world/world.lua",
  "physics/world/queryMethods.lua",
}

--- Returns the entries of a file, or of several, in their order.
---@param path string|string[]
---@return docs.Entry[]
function docstrings.read(path)
  local paths, found = path, {}
  if type(paths) == "string" then
    paths = { paths }
  end
  for _, name in ipairs(paths) do
    readFile(name, found)
  end
  return found
end

--- Returns the functions of one owner, by name and as a list in the order of the file.
---@param path string|string[]
---@param owner string
---@return table<string, docs.Entry> byName
---@return docs.Entry[] list
function docstrings.functions(path, owner)
  local byName, list = {}, {}
  for _, entry in ipairs(docstrings.read(path)) do
    if entry.kind == "function" and entry.owner == owner then
      byName[entry.name], list[#list + 1] = entry, entry
    end
  end
  return byName, list
end

return docstrings
