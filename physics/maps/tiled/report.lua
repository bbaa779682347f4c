--- What the readers of a map share: how a place in it is called, and the list of what is not
--- supported.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")

local report = {}

report.WHERE = "world:loadTiled(map)"

--- Returns how an error names a layer.
---@param layer table
---@return string
function report.place(layer)
  return ("%s: layer %s"):format(report.WHERE, check.show(layer.name))
end

--- Adds something that is not supported to the list, and returns its entry.
---@param reading table
---@param kind "layer"|"object"|"tile"|"tileset"
---@param layer table
---@param id integer? of the layer, the object or the tile; of a tileset its firstgid
---@param reason string
---@return table entry
function report.add(reading, kind, layer, id, reason)
  local entry = { kind = kind, layer = layer.name, id = id, reason = reason }
  reading.unsupported[#reading.unsupported + 1] = entry
  return entry
end

--- Returns the class that the editor gave to a tile or an object, nil: none. Tiled 1.9 calls it
--- `class`, all others `type`.
function report.typeOf(owner)
  local name = owner.type or owner.class
  if type(name) == "string" and name ~= "" then
    return name
  end
end

--- Errors: no finite position, no size >= 0, no finite rotation; a name or a shape that is no text.
---@param object table as Tiled exports it
---@param place string
function report.checkObject(object, place)
  check.optional(object.name, "string", "name", place)
  check.optional(object.shape, "string", "shape", place)
  check.number(object.x, "x", place)
  check.number(object.y, "y", place)
  check.number(object.width, "width", place, 0)
  check.number(object.height, "height", place, 0)
  if object.rotation ~= nil then
    check.number(object.rotation, "rotation", place)
  end
end

return report
