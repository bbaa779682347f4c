--- Goes through the layers of a map: what holds in each, which of them are solid, which are read.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local objectlayer = require(root .. ".maps.tiled.objectlayer")
local options = require(root .. ".maps.tiled.options")
local properties = require(root .. ".maps.properties")
local report = require(root .. ".maps.tiled.report")
local tilelayer = require(root .. ".maps.tiled.tilelayer")

local layers = {}

local WHERE = report.WHERE

-- Names that say that a layer is solid, in the singular and in small letters.
local SOLID_NAMES = {
  wall = true,
  collision = true,
  collider = true,
  solid = true,
  ground = true,
  platform = true,
}

local function saysSolid(name)
  return SOLID_NAMES[(name:lower():gsub("s$", ""))] or false
end

-- STI knows no groups of layers: it calls a layer in one "outer.inner".
local function isNamedSolid(reading, name)
  if reading.map.tileInstances then
    for part in name:gmatch("[^.]+") do
      if saysSolid(part) then
        return true
      end
    end
  end
  return saysSolid(name)
end

local function isListed(list, layer)
  for i = 1, #(list or {}) do
    if list[i] == layer.name or list[i] == layer.id then
      return true
    end
  end
  return false
end

local function checkLayer(layer, i)
  local what = ("map.layers[%d]"):format(i)
  check.table(layer, what, WHERE)
  if type(layer.name) ~= "string" then
    check.fail(("%s: %s.name must be a string, got %s"):format(WHERE, what, check.show(layer.name)))
  end
  local place = report.place(layer)
  if layer.offsetx ~= nil then
    check.number(layer.offsetx, "offsetx", place)
  end
  if layer.offsety ~= nil then
    check.number(layer.offsety, "offsety", place)
  end
  return place
end

-- Context -----------------------------------------------------------------------------------------

-- Whether a layer is solid, why, and whether only a name says so. An option goes before its own
-- property, that before one around it, and that before a name. nil: nothing says anything.
local function solidOf(reading, layer, own, outer)
  if isListed(reading.solidLayers, layer) then
    return true, "option solidLayers"
  elseif own.solid ~= nil then
    return own.solid, ("property %s"):format(check.show(own.solidName))
  elseif outer.solid ~= nil and not outer.isByName then
    return outer.solid, outer.reason
  elseif outer.isByName then
    return true, outer.reason, true
  end
  local hasBoxes = layer.type ~= "imagelayer" and layer.type ~= "customlayer"
  if not reading.solidLayers and hasBoxes and isNamedSolid(reading, layer.name) then
    return true, ("its name, %s"):format(check.show(layer.name)), true
  end
end

-- What holds in a layer: where it lies, and what its properties and those around it say.
local function contextOf(reading, layer, outer, place)
  local own = properties.readLayer(layer.properties, place, reading.rules)
  for _, text in ipairs(own.problems) do
    report.add(reading, "layer", layer, layer.id, text).name = layer.name
  end
  local context = {
    x = outer.x + (layer.offsetx or 0),
    y = outer.y + (layer.offsety or 0),
    isParallax = outer.isParallax or (layer.parallaxx or 1) ~= 1 or (layer.parallaxy or 1) ~= 1,
    isWanted = outer.isWanted or isListed(reading.onlyLayers, layer),
    isForced = outer.isForced or isListed(reading.solidLayers, layer),
    traits = properties.combine(outer.traits, own),
  }
  context.isSpoken = properties.saysAnything(context.traits)
  context.solid, context.reason, context.isByName = solidOf(reading, layer, own, outer)
  return context
end

-- Reading -----------------------------------------------------------------------------------------

-- Why nothing of a layer can be read, or nil.
local function whyNot(reading, layer, context)
  local orientation = reading.map.orientation or "orthogonal"
  if orientation ~= "orthogonal" then
    return orientation .. " map: only orthogonal ones have boxes"
  elseif layer.type == "imagelayer" and context.solid and not context.isByName then
    return "image layer: it has no boxes"
  end
end

local function readNothing(_, _, _) end

local KINDS = {
  tilelayer = tilelayer.read,
  objectgroup = objectlayer.read,
  imagelayer = readNothing,
  customlayer = readNothing, -- STI's, for the game's own drawing
}

local function reportLayer(reading, layer, reason)
  report.add(reading, "layer", layer, layer.id, reason).name = layer.name
end

local function readKind(reading, layer, context)
  local reason = whyNot(reading, layer, context)
  if not reason and not KINDS[layer.type] then
    reason = "unknown type of layer: " .. check.show(layer.type)
  end
  return reason or KINDS[layer.type](reading, layer, context)
end

local function readLeaf(reading, layer, context)
  if context.traits.group == nil then
    context.traits.group = layer.name
  end
  local before = #reading.objects
  local reason = readKind(reading, layer, context)
  if reason then
    if context.isForced and layer.type == "tilelayer" then
      check.fail(("%s: it is in solidLayers, but %s"):format(report.place(layer), reason))
    elseif context.solid ~= false then
      reportLayer(reading, layer, reason)
    end
    return
  end
  if context.isParallax and #reading.objects > before then
    reportLayer(reading, layer, "parallax: its objects do not drift")
  end
  local hasBoxes = layer.type == "tilelayer" or layer.type == "objectgroup"
  if context.solid and hasBoxes then
    local list = reading.solid
    list[#list + 1] = { name = layer.name, id = layer.id, reason = context.reason, layer = layer }
  end
end

local function readLayers(reading, list, outer)
  for i, layer in ipairs(list) do
    local place = checkLayer(layer, i)
    if not isListed(reading.skipLayers, layer) then
      local context = contextOf(reading, layer, outer, place)
      if layer.type == "group" then
        check.table(layer.layers, "layers", place)
        readLayers(reading, layer.layers, context)
      elseif context.isWanted or not reading.onlyLayers then
        readLeaf(reading, layer, context)
      end
    end
  end
end

--- Reads all layers of a map.
--- Errors: a malformed layer, a value that cannot be used.
---@param reading table
---@param outer table what holds for the map: x, y, traits
function layers.read(reading, outer)
  readLayers(reading, reading.map.layers, outer)
end

-- Checks ------------------------------------------------------------------------------------------

--- Checks that no layer holds itself: such a map would have no end.
--- Errors: one that does.
---@param list table layers
---@param around table? the lists that hold it
function layers.checkNesting(list, around)
  around = around or {}
  around[list] = true
  for _, layer in ipairs(list) do
    local inner = type(layer) == "table" and layer.layers
    if type(inner) == "table" then
      if around[inner] then
        local text = "%s: layer %s: layers must not hold that layer itself"
        check.fail(text:format(WHERE, check.show(layer.name)))
      end
      layers.checkNesting(inner, around)
    end
  end
  around[list] = nil
end

local function isThere(list, wanted, names)
  for i, layer in ipairs(list) do
    checkLayer(layer, i)
    names[#names + 1] = check.show(layer.name)
    if wanted == layer.name or wanted == layer.id then
      return true
    elseif type(layer.layers) == "table" and isThere(layer.layers, wanted, names) then
      return true
    end
  end
  return false
end

--- Checks that all layers of an option are in the map: a misspelt one would only show in the game.
--- Errors: one that is not.
---@param reading table
---@param option string
function layers.checkListed(reading, option)
  for i, wanted in ipairs(reading[option] or {}) do
    local names = {}
    if not isThere(reading.map.layers, wanted, names) then
      local what = ("%s: %s[%d] must be a layer of the map, got %s; they are "):format(
        options.WHERE,
        option,
        i,
        check.show(wanted)
      )
      check.fail(what .. table.concat(names, ", "))
    end
  end
end

return layers
