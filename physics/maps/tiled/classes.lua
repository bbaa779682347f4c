--- Finds the properties of a part of a map: its own, and what a project of the editor says of its
--- class. Changes nothing.
---
--- Source: https://doc.mapeditor.org/en/stable/manual/custom-properties/#custom-types

local root = (...):match("^(.*)%.maps%.")
local properties = require(root .. ".maps.properties")

local classes = {}

local tableOf = properties.tableOf

-- Returns properties, and what the members of a class say besides. `around` has the classes around
-- it: one that holds itself ends there.
local function fill(byName, name, own, around)
  local made, class = properties.put({}, own), byName[name]
  if not class or around[name] then
    return made
  end
  around[name] = true
  for _, member in ipairs(class.members or {}) do
    local value = made[member.name]
    if member.type == "class" then
      local inner = properties.put(properties.put({}, tableOf(member.value)), tableOf(value))
      made[member.name] = fill(byName, member.propertyType, inner, around)
    elseif value == nil then
      made[member.name] = member.value
    end
  end
  around[name] = nil
  return made
end

--- Returns a function that finds the properties of a part of a map.
---@param project table? the decoded .tiled-project file
---@param typeOf fun(part: table): string?
---@return fun(part: table): table?
function classes.reader(project, typeOf)
  local byName = {}
  for _, class in ipairs(project and project.propertyTypes or {}) do
    byName[class.name] = class
  end
  return function(part)
    local class, own = typeOf(part), part.properties
    if not byName[class] or own ~= nil and type(own) ~= "table" then
      return own
    end
    return fill(byName, class, own or {}, {})
  end
end

return classes
