--- Properties that a map's author wrote: of layers, tiles and objects of Tiled, of entities of
--- LDtk, of values in a plain array. Finds which of them are words for the loader, and which are
--- fields.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local fields = require(root .. ".world.fields")
local interpreted = require(root .. ".memory.jit")

local properties = {}

--- How properties are read.
---@class physics.PropertyRules
---@field solidNames string[] names of the property that makes solid, the most important one first
---@field isIgnored table<string, boolean> names of properties that are left to the game
---@field isStrict boolean a value that cannot be used is an error
---@field isCode boolean? the game's code says it: its tables may hold anything

--- What the properties of something say.
---@class physics.Traits
---@field fields table<string, any> fields that its objects get
---@field solid boolean? may it be in the world
---@field solidName string? the property that said so
---@field group string|number? name of the group
---@field merge boolean? may its tiles become one
---@field problems string[] why which of the properties are not used

-- Words ------------------------------------------------------------------------------------------

-- Lua's own `tonumber` also takes "0x10", and on some systems "nan" and "inf".
local function toNumber(text)
  local digits = text:match("^%s*(.-)%s*$")
  if digits:match("^[-+]?%d[%d.]*[eE]?[-+]?%d*$") or digits:match("^[-+]?%.%d+$") then
    return tonumber(digits)
  end
end

local BOOLEANS = { ["true"] = true, ["false"] = false }

local function toBoolean(value)
  if type(value) == "string" then
    return BOOLEANS[value:lower()]
  end
  return value
end

-- Old maps have strings only, so a string may stand for a number, `true` or `false`.
local function convert(field, value)
  if type(value) == "string" then
    if field.type == "number" then
      local number = toNumber(value)
      return number == nil and value or number
    elseif field.type == "boolean" or field.yes then
      local boolean = toBoolean(value)
      value = boolean == nil and value or boolean
    end
  end
  if value == true and field.yes then
    return field.yes
  end
  return value
end

-- Reading -----------------------------------------------------------------------------------------

-- Where an object is and how large, and what it touches, is no matter of properties.
local function isTaken(field)
  return field.required or field.written or false
end

local function sortedNames(given, place)
  local names = {}
  for name in pairs(given) do
    if type(name) ~= "string" then
      check.fail(place .. ": properties must have strings as keys, got " .. check.show(name))
    end
    names[#names + 1] = name
  end
  table.sort(names) -- so that of several wrong values always the same one is told
  return names
end

local function isSolidName(rules, name)
  for i = 1, #rules.solidNames do
    if rules.solidNames[i] == name then
      return i
    end
  end
end

-- A value of ours that cannot be used.
local function refuse(traits, rules, place, text)
  if rules.isStrict then
    check.fail(place .. ": " .. text)
  end
  traits.problems[#traits.problems + 1] = text
end

local function readWord(traits, name, value, place, rules)
  local boolean = toBoolean(value)
  if type(boolean) ~= "boolean" then
    refuse(
      traits,
      rules,
      place,
      ("%s must be true or false, got %s"):format(name, check.show(value))
    )
    return
  elseif name == "merge" then
    traits.merge = boolean
    return
  end
  local before = traits.solidName and isSolidName(rules, traits.solidName)
  if not before or isSolidName(rules, name) < before then
    traits.solid, traits.solidName = boolean, name
  end
end

local function readGroup(traits, value, place, rules)
  if check.isName(value) then
    traits.group = value
  else
    local text = "group must be a string or a number, got " .. check.show(value)
    refuse(traits, rules, place, text)
  end
end

local function readField(traits, field, value, place, rules)
  value = convert(field, value)
  if field.yes and value == false then
    return -- none
  elseif check.accepts(field, value) then
    traits.fields[field.name] = value
  else
    refuse(traits, rules, place, check.describe(field.name, field, value))
  end
end

local function copy(value)
  if type(value) ~= "table" then
    return value
  end
  local copied = {}
  for key, inner in pairs(value) do
    copied[key] = copy(inner)
  end
  return copied
end

-- One entry of an area, for maps without tables: a property "area.gravity".
local function readEntry(traits, name, value, place, rules)
  local entry = fields.areaByName[name:sub(#"area." + 1)]
  if not entry then
    refuse(traits, rules, place, ("%s: an area has no such entry"):format(name))
    return
  end
  value = convert(entry, value)
  if not check.accepts(entry, value) then
    refuse(traits, rules, place, check.describe(name, entry, value))
    return
  end
  traits.fields.area = copy(traits.fields.area or {})
  traits.fields.area[entry.name] = value
end

local function checkCycles(value, place, name, around)
  if type(value) ~= "table" then
    return
  elseif around[value] then
    check.fail(("%s: property %s must not hold itself"):format(place, check.show(name)))
  end
  around[value] = true
  for _, inner in pairs(value) do
    checkCycles(inner, place, name, around)
  end
  around[value] = nil
end

local function readOne(traits, name, value, place, rules)
  local field = fields.objectByName[name]
  if not rules.isCode then
    checkCycles(value, place, name, {})
  end
  if rules.isIgnored[name] then
    return
  elseif name == "merge" or isSolidName(rules, name) then
    readWord(traits, name, value, place, rules)
  elseif name == "group" then
    readGroup(traits, value, place, rules)
  elseif field and isTaken(field) and rules.isCode then
    refuse(traits, rules, place, name .. " must be nil: place and size are those of the cells")
  elseif field and isTaken(field) then
    local text = ("property %s: the editor's own value counts"):format(check.show(name))
    traits.problems[#traits.problems + 1] = text
  elseif field then
    readField(traits, field, value, place, rules)
  elseif name:find("^area%.") and not rules.isCode then
    readEntry(traits, name, value, place, rules)
  else
    traits.fields[name] = value
  end
end

--- Reads the properties of a tile, a collision shape, an object or an entity.
--- Errors: no table; a key that is no string; a table that holds itself; with `isStrict` a field
--- of the library that cannot be used.
---@param given table? names and values
---@param place string how an error names the owner
---@param rules physics.PropertyRules
---@return physics.Traits
function properties.read(given, place, rules)
  local traits = { fields = {}, problems = {} }
  if given == nil then
    return traits
  end
  check.table(given, "properties", place)
  for _, name in ipairs(sortedNames(given, place)) do
    readOne(traits, name, given[name], place, rules)
  end
  return traits
end

--- Reads the properties of a layer. Those that are no fields of the library say something about the
--- layer, not about what is in it.
---@param given table?
---@param place string
---@param rules physics.PropertyRules
---@return physics.Traits
function properties.readLayer(given, place, rules)
  local traits = properties.read(given, place, rules)
  local known, problems = {}, {}
  for name, value in pairs(traits.fields) do
    if fields.objectByName[name] then
      known[name] = value
    end
  end
  for _, text in ipairs(traits.problems) do
    if not text:find("^property ") then
      problems[#problems + 1] = text
    end
  end
  traits.fields, traits.problems = known, problems
  return traits
end

-- Combining ---------------------------------------------------------------------------------------

-- `static` and `kinematic` are one choice: what is made the one is not the other any more.
local function choose(combined, inner)
  if inner.kinematic and inner.static == nil then
    combined.static = nil
  elseif inner.static and inner.kinematic == nil then
    combined.kinematic = nil
  end
end

--- Returns what both say together; where they differ, the inner one is right. `solid` is not
--- inherited: the caller weighs which word counts.
---@param outer physics.Traits
---@param inner physics.Traits
---@return physics.Traits
function properties.combine(outer, inner)
  local combined = { fields = {}, problems = inner.problems }
  for name, value in pairs(outer.fields) do
    combined.fields[name] = value
  end
  for name, value in pairs(inner.fields) do
    combined.fields[name] = value
  end
  choose(combined.fields, inner.fields)
  combined.group = inner.group == nil and outer.group or inner.group
  combined.merge = inner.merge
  if combined.merge == nil then
    combined.merge = outer.merge
  end
  return combined
end

--- Makes static what says neither that it is nor that it moves.
---@param traits physics.Traits
---@return physics.Traits traits the same
function properties.makeStatic(traits)
  if traits.fields.static == nil and not traits.fields.kinematic then
    traits.fields.static = true
  end
  return traits
end

local function hasKnown(list)
  for name in pairs(list) do
    if fields.objectByName[name] then
      return true
    end
  end
  return false
end

--- Returns whether the map says nothing: there are no properties, or none in the table.
---@param given table?
---@return boolean
function properties.isEmpty(given)
  return given == nil or next(given) == nil
end

--- Returns whether any word of it is for the library.
---@param traits physics.Traits
---@return boolean
function properties.saysAnything(traits)
  return traits.solid ~= nil or traits.group ~= nil or hasKnown(traits.fields)
end

-- Objects -----------------------------------------------------------------------------------------

--- Returns a copy of a table without cycles, of which no table is shared.
properties.copy = copy

--- Returns a new object with these fields. Nothing of it is shared with the map.
---@return table object
function properties.newObject(given, x, y, width, height)
  local object = copy(given)
  object.x, object.y, object.width, object.height = x, y, width, height
  return object
end

local write

local function writeTable(given, depth)
  local parts = {}
  for name, value in pairs(given) do
    parts[#parts + 1] = write(name, depth) .. "=" .. write(value, depth)
  end
  table.sort(parts)
  return "{" .. table.concat(parts, ",") .. "}"
end

function write(value, depth)
  local kind = type(value)
  if kind == "table" and depth > 0 then
    return writeTable(value, depth - 1)
  elseif kind == "number" then
    return ("%.17g"):format(value)
  end
  return kind == "string" and ("%q"):format(value) or tostring(value)
end

--- Returns a text that is the same for equal fields, and only for those.
---@param given table
---@param depth integer? default all: tables further inside are equal only if they are the same
---@return string
function properties.signature(given, depth)
  return (writeTable(given, depth or 1 / 0))
end

interpreted.always(sortedNames, checkCycles, properties.readLayer, properties.combine)
interpreted.always(properties.isEmpty, hasKnown, copy, writeTable)

return properties
