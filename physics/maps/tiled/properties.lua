--- Custom properties of layers, tiles and objects: what they say to the loader, and which of them
--- become fields.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".check")
local fields = require(root .. ".fields")
local interpreted = require(root .. ".interpreted")

local properties = {}

--- What the properties of something say.
---@class physics.Traits
---@field fields table<string, any> fields that its objects get
---@field solid boolean? may it be in the world
---@field group string|number? name of the group
---@field merge boolean? may its tiles become one
---@field ignored string[] names of properties that stand for what the editor knows better

-- Where an object is and how large, and what it touches, is no matter of properties.
local function isTaken(name)
  local field = fields.objectByName[name]
  return field ~= nil and (field.required or field.written or false)
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

local function readOne(traits, name, value, place, solidName)
  if name == solidName or name == "merge" then
    check.boolean(value, name, place)
    traits[name == solidName and "solid" or "merge"] = value
  elseif name == "group" then
    check.group(value, place)
    traits.group = value
  elseif isTaken(name) then
    traits.ignored[#traits.ignored + 1] = name
  else
    local field = fields.objectByName[name]
    if field then
      check.value(field, value, place .. ": " .. name)
    end
    traits.fields[name] = value
  end
end

--- Reads the properties of a tile, a collision shape or an object.
--- Errors: no table; a property that is a field, and cannot be used.
---@param given table? `properties` of the map
---@param place string how an error names the owner
---@param solidName string name of the property that says whether it is solid
---@return physics.Traits
function properties.read(given, place, solidName)
  local traits = { fields = {}, ignored = {} }
  if given == nil then
    return traits
  end
  check.table(given, "properties", place)
  for _, name in ipairs(sortedNames(given, place)) do
    readOne(traits, name, given[name], place, solidName)
  end
  return traits
end

--- Reads the properties of a layer. Those that are no fields of the library say something about the
--- layer, not about what is in it.
---@param given table?
---@param place string
---@param solidName string
---@return physics.Traits
function properties.readLayer(given, place, solidName)
  local traits = properties.read(given, place, solidName)
  local known = {}
  for name, value in pairs(traits.fields) do
    if fields.objectByName[name] then
      known[name] = value
    end
  end
  traits.fields, traits.ignored = known, {}
  return traits
end

-- `static` and `kinematic` are one choice: who is made the one is not the other any more.
local function choose(combined, inner)
  if inner.kinematic and inner.static == nil then
    combined.static = nil
  elseif inner.static and inner.kinematic == nil then
    combined.kinematic = nil
  end
end

--- Returns what both say together; where they differ, the inner one is right. `solid` is not
--- inherited: who says what about it is for the caller to weigh.
---@param outer physics.Traits
---@param inner physics.Traits
---@return physics.Traits
function properties.combine(outer, inner)
  local combined = { fields = {}, ignored = inner.ignored }
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

--- Returns a new object with these fields. Nothing of it is shared with the map.
---@return table object
function properties.newObject(given, x, y, width, height)
  local object = copy(given)
  object.x, object.y, object.width, object.height = x, y, width, height
  return object
end

local write

local function writeTable(given)
  local names, parts = {}, {}
  for name in pairs(given) do
    names[#names + 1] = name
  end
  table.sort(names, function(a, b)
    return type(a) == type(b) and a < b or type(a) < type(b)
  end)
  for i, name in ipairs(names) do
    parts[i] = write(name) .. "=" .. write(given[name])
  end
  return "{" .. table.concat(parts, ",") .. "}"
end

function write(value)
  local kind = type(value)
  if kind == "table" then
    return writeTable(value)
  elseif kind == "number" then
    return ("%.17g"):format(value)
  end
  return kind == "string" and ("%q"):format(value) or tostring(value)
end

--- Returns a text that is the same for equal fields, and only for those.
---@param given table
---@return string
function properties.signature(given)
  return (writeTable(given))
end

interpreted.always(sortedNames, properties.readLayer, properties.combine, copy, writeTable)

return properties
