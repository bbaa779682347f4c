--- Reads a level of the editor LDtk: the cells of its IntGrid layers and its entities. Nothing of
--- the project is changed, nothing of it is drawn.
---
--- Source: the format of LDtk 1.x, https://ldtk.io/json

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local project = require(root .. ".maps.ldtk.project")
local properties = require(root .. ".maps.properties")
local tiles = require(root .. ".maps.tiles")
local values = require(root .. ".maps.values")

local ldtk = {}

local WHERE = project.WHERE

--- What a level of LDtk gave to a world.
---@class physics.LDtkLevel
---@field objects physics.Object[] all its objects, in the order of the layers
---@field named table<string, physics.Object> the first entity of an identifier or a field `name`
---@field byIid table<string, physics.Object> entities by what fields that refer to them hold
---@field tileLayers table<string, physics.Tiles> the tiles of each IntGrid layer, to dig in
---@field solidLayers physics.SolidLayer[] which layers have solid values, and which these are
---@field tiles integer solid cells
---@field rectangles integer what has become of them
---@field unsupported physics.Unsupported[] what could not be had
---@field fields table<string, any> fields of the level itself
---@field x number px, left edge
---@field y number px, upper edge
---@field width number px
---@field height number px
---@field worldX number px, where the level lies in the world of the editor
---@field worldY number px
---@field level table the level of the project

-- Cells -------------------------------------------------------------------------------------------

-- number -> identifier of the values of an IntGrid layer, "" if it has none.
local function identifiersOf(reading, layer)
  local identifiers = {}
  for _, definition in ipairs(project.valuesOf(reading.project, layer.layerDefUid)) do
    identifiers[definition.value] = project.text(definition.identifier) or ""
  end
  return identifiers
end

local WALL_NAMES = { wall = true, collision = true, collider = true, solid = true, ground = true }

local function saysSolid(identifier)
  return WALL_NAMES[(identifier:lower():gsub("s$", ""))] or false
end

-- Which values are solid by themselves: those whose identifier says so; if none does, all.
local function solidByName(identifiers)
  local isSolid, hasNames = {}, false
  for number, identifier in pairs(identifiers) do
    isSolid[number] = saysSolid(identifier)
    hasNames = hasNames or isSolid[number]
  end
  return isSolid, hasNames
end

local function newTraitsOf(reading, identifiers)
  local isSolid, hasNames = solidByName(identifiers)
  return function(value)
    if value == 0 then
      return false
    elseif not reading.solid then
      return (not hasNames or isSolid[value]) and { fields = {}, problems = {} }
    end
    local traits = reading.solid[value]
    if traits == nil then
      traits = reading.solid[identifiers[value]]
    end
    return traits
  end
end

local function newTiles(state, layer, x, y)
  return tiles.new({
    x = x,
    y = y,
    zero = 0,
    tileWidth = layer.__gridSize,
    tileHeight = layer.__gridSize,
    firstColumn = 0,
    firstRow = 0,
    columns = layer.__cWid,
    rows = layer.__cHei,
    record = "ldtk",
    base = { layer = layer },
    copy = values.copy,
    empty = 0,
    piecesOf = function(value, where)
      if type(value) ~= "number" or (value ~= 0 and state.identifiers[value] == nil) then
        local what = where or WHERE
        local text = "%s: value must be 0 or a value of layer %s, got %s"
        check.fail(text:format(what, check.show(layer.__identifier), check.show(value)))
      end
      return values.piecesOf(state, value)
    end,
  })
end

local function fill(state, layer, place)
  local list, columns = layer.intGridCsv, layer.__cWid
  for i = 1, #list do
    local value = list[i]
    if value ~= 0 then
      if type(value) ~= "number" or value < 0 or value % 1 ~= 0 then
        local text = "%s: intGridCsv[%d] must be an integer >= 0, got %s"
        check.fail(text:format(place, i, check.show(value)))
      end
      if state.identifiers[value] == nil then
        state.identifiers[value] = ""
      end
      local column = (i - 1) % columns
      local pieces = values.piecesOf(state, value)
      cells.fill(state.tiles, column, (i - 1 - column) / columns, value, pieces)
    end
  end
end

local function reportSolid(reading, state, layer)
  local shown = {}
  for _, number in ipairs(state.order) do
    if #(state.pieces[number] or {}) > 0 then
      local identifier = state.identifiers[number]
      shown[#shown + 1] = identifier ~= "" and check.show(identifier) or tostring(number)
    end
  end
  if #shown > 0 then
    local reason = (reading.solid and "option solid: " or "its values ")
      .. table.concat(shown, ", ")
    local entry = { name = layer.__identifier, id = layer.iid, reason = reason, layer = layer }
    reading.solidLayers[#reading.solidLayers + 1] = entry
  end
end

local function add(reading, group, object)
  local n = #reading.objects + 1
  reading.objects[n], reading.groupOf[n] = object, group
end

local function readIntGrid(reading, layer, x, y, place)
  project.checkGrid(layer, place)
  local identifiers = identifiersOf(reading, layer)
  local state = { group = layer.__identifier, merge = reading.merge, identifiers = identifiers }
  state.pieces, state.boxesByKey, state.traitsOf = {}, {}, newTraitsOf(reading, identifiers)
  state.order = {}
  for _, definition in ipairs(project.valuesOf(reading.project, layer.layerDefUid)) do
    state.order[#state.order + 1] = definition.value
  end
  state.tiles = newTiles(state, layer, x, y)
  fill(state, layer, place)
  cells.build(state.tiles, function(group, object)
    add(reading, group, object)
  end)
  reportSolid(reading, state, layer)
  reading.tiles = reading.tiles + state.tiles.tiles
  reading.rectangles = reading.rectangles + state.tiles.rectangles
  reading.tileLayers[layer.__identifier] = state.tiles
  reading.allTiles[#reading.allTiles + 1] = state.tiles
end

-- Entities ----------------------------------------------------------------------------------------

local function traitsOf(reading, layer, entity, place)
  local traits = properties.read(project.fieldsOf(entity, place), place, reading.rules)
  for _, text in ipairs(traits.problems) do
    local entry = { kind = "object", layer = layer.__identifier, id = entity.iid, reason = text }
    entry.name, entry.object = entity.__identifier, entity
    reading.unsupported[#reading.unsupported + 1] = entry
  end
  return traits.solid and properties.makeStatic(traits) or traits
end

local function nameEntity(reading, object, entity)
  local named, own = reading.named, object.name
  if type(own) == "string" then
    named[own] = named[own] or object
  end
  named[entity.__identifier] = named[entity.__identifier] or object
  if type(entity.iid) == "string" then
    reading.byIid[entity.iid] = object
  end
end

local function readEntity(reading, layer, entity, x, y, place)
  project.checkEntity(entity, place)
  local traits = traitsOf(reading, layer, entity, place)
  if traits.solid == false then
    return
  end
  local pivot, px = entity.__pivot, entity.px
  local left, top = px[1] - pivot[1] * entity.width, px[2] - pivot[2] * entity.height
  local object = properties.newObject(traits.fields, x + left, y + top, entity.width, entity.height)
  if object.type == nil then
    object.type = entity.__identifier
  end
  object.ldtk = { layer = layer, entity = entity }
  nameEntity(reading, object, entity)
  local group = traits.group
  if group == nil then
    group = reading.groups[entity.__identifier]
  end
  add(reading, group == nil and entity.__identifier or group, object)
end

local function readEntities(reading, layer, x, y, place)
  check.table(layer.entityInstances, "entityInstances", place)
  for i, entity in ipairs(layer.entityInstances) do
    readEntity(reading, layer, entity, x, y, ("%s, entityInstances[%d]"):format(place, i))
  end
end

-- Layers ------------------------------------------------------------------------------------------

local KINDS = { IntGrid = readIntGrid, Entities = readEntities }

local function isListed(list, layer)
  for i = 1, #(list or {}) do
    if list[i] == layer.__identifier then
      return true
    end
  end
  return false
end

local function readLayer(reading, layer, i)
  local place = project.checkLayer(layer, i)
  local isWanted = isListed(reading.onlyLayers, layer)
  if isListed(reading.skipLayers, layer) or (reading.onlyLayers and not isWanted) then
    return
  end
  local x = reading.x + (layer.__pxTotalOffsetX or 0)
  local y = reading.y + (layer.__pxTotalOffsetY or 0)
  local read = KINDS[layer.__type]
  if read then
    read(reading, layer, x, y, place)
  elseif isWanted then
    local entry = { kind = "layer", layer = layer.__identifier, name = layer.__identifier }
    entry.id, entry.reason = layer.iid, "only IntGrid and entity layers have boxes"
    reading.unsupported[#reading.unsupported + 1] = entry
  end
end

--- Reads a level and adds nothing: see `world:loadLDtk`.
---@param given table the decoded project
---@param wanted string|integer|table|nil which level
---@param options physics.LDtkOptions?
---@return physics.LDtkLevel level
---@return (string|number)[] groupOf the group of each of its objects
---@return physics.Tiles[] tiles of all IntGrid layers
function ldtk.read(given, wanted, options)
  local reading = project.checkOptions(options)
  local level = project.findLevel(given, wanted)
  project.checkNames(given, level, reading)
  reading.project, reading.objects, reading.groupOf, reading.allTiles = given, {}, {}, {}
  reading.named, reading.byIid, reading.tileLayers, reading.solidLayers = {}, {}, {}, {}
  reading.unsupported, reading.tiles, reading.rectangles = {}, 0, 0
  -- LDtk lists layers from the front to the back, and draws them the other way round.
  for i = #level.layerInstances, 1, -1 do
    readLayer(reading, level.layerInstances[i], i)
  end
  return {
    objects = reading.objects,
    named = reading.named,
    byIid = reading.byIid,
    tileLayers = reading.tileLayers,
    solidLayers = reading.solidLayers,
    tiles = reading.tiles,
    rectangles = reading.rectangles,
    unsupported = reading.unsupported,
    fields = project.fieldsOf(level, WHERE .. ": level"),
    x = reading.x,
    y = reading.y,
    width = level.pxWid,
    height = level.pxHei,
    worldX = level.worldX or 0,
    worldY = level.worldY or 0,
    level = level,
  },
    reading.groupOf,
    reading.allTiles
end

interpreted.always(solidByName)

return ldtk
