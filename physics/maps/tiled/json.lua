---@diagnostic disable
--- What Tiled writes otherwise into JSON than into Lua: properties are lists, shapes are flags, and
--- objects of templates only have what differs.
---
--- Source: https://doc.mapeditor.org/en/stable/reference/json-map-format/

local root = (...):match("^(.*)%.maps%.")
local properties = require(root .. ".maps.properties")

local json = {}

local function valueOf(entry)
  local isList, list = entry.type == "list", {}
  for i, inner in ipairs(isList and entry.value or {}) do
    list[i] = inner.type == "list" and valueOf(inner) or inner.value
  end
  return isList and list or entry.type == "object" and { id = entry.value } or entry.value
end

--- Returns the properties of a part of a map as names and values.
function json.properties(part)
  local given = part.properties
  if type(given) ~= "table" or not properties.tableOf(given[1]).name then
    return given
  end
  local made = {}
  for _, entry in ipairs(given) do
    made[entry.name] = valueOf(entry)
  end
  return made
end

local SHAPES = { "ellipse", "point", "capsule", "polygon", "polyline", "text" }

--- Returns the name of the shape of an object.
function json.shapeOf(object)
  for i = 1, object.shape and 0 or #SHAPES do
    if object[SHAPES[i]] then
      return SHAPES[i]
    end
  end
  return object.shape or "rectangle"
end

-- Returns the gid on the map of a tile of a template; nil: the map does not know its tileset.
local function gidOf(reading, base, set, folder)
  for _, entry in ipairs(reading.tilesets) do
    local _, path = reading.beside(folder .. set.source)
    if entry.path == path then
      return base - set.firstgid + entry.set.firstgid
    end
  end
end

--- Returns an object with what its template says besides; nil and a reason: that cannot be read.
function json.whole(reading, object)
  local name = object.template
  if not name then
    return object
  end
  local given, problem = reading.beside(name)
  if not given then
    return nil, "template: " .. problem
  end
  local base, folder = given.object, name:match("^.*/") or ""
  local made = properties.join(base, object)
  made.properties = properties.join(json.properties(base) or {}, json.properties(object) or {})
  if base.gid and not object.gid then
    made.gid = gidOf(reading, base.gid, given.tileset, folder)
    if not made.gid then
      return nil, "template: its tileset is not one of the map"
    end
  end
  return made
end

return json
