--- Projects of the editor LDtk 1.5, in few words: what a JSON library makes of them.

local small = require("spec.support.small")

local ldtk = {}

--- An IntGrid layer from a picture: "." is 0, a digit a value.
function ldtk.intGrid(identifier, rows, extra)
  local csv = {}
  for _, row in ipairs(rows) do
    for character in row:gmatch(".") do
      csv[#csv + 1] = tonumber(character) or 0
    end
  end
  local layer = { __identifier = identifier, __type = "IntGrid", __gridSize = 16, layerDefUid = 1 }
  layer.__cWid, layer.__cHei, layer.iid = #rows[1], #rows, "layer-" .. identifier
  layer.intGridCsv, layer.autoLayerTiles, layer.gridTiles = csv, {}, {}
  return small.set(layer, extra)
end

--- An entity; `fields` are names and values.
function ldtk.entity(identifier, x, y, width, height, fields, extra)
  local list = {}
  for name, value in pairs(fields or {}) do
    list[#list + 1] = { __identifier = name, __type = "String", __value = value, defUid = 9 }
  end
  local entity = { __identifier = identifier, __pivot = { 0.5, 1 }, __tags = {}, px = { x, y } }
  entity.width, entity.height, entity.iid = width, height, "entity-" .. identifier
  entity.fieldInstances = list
  return small.set(entity, extra)
end

function ldtk.entities(identifier, list, extra)
  local layer = ldtk.intGrid(identifier, { "." }, { __type = "Entities", layerDefUid = 2 })
  layer.intGridCsv, layer.entityInstances = {}, list
  return small.set(layer, extra)
end

function ldtk.level(identifier, layers, extra)
  local level = { identifier = identifier, iid = "level-" .. identifier, layerInstances = layers }
  level.worldX, level.worldY, level.pxWid, level.pxHei = 512, -64, 320, 160
  level.fieldInstances = { { __identifier = "music", __type = "String", __value = "cave" } }
  return small.set(level, extra)
end

--- A project; `values` are the values of its one IntGrid layer: number -> identifier.
function ldtk.project(levels, values)
  local list = {}
  for number = 1, 9 do
    if values and values[number] ~= nil then
      list[#list + 1] = { value = number, identifier = values[number] or nil, color = "#FFFFFF" }
    end
  end
  return {
    jsonVersion = "1.5.3",
    defs = {
      layers = {
        { uid = 1, identifier = "Collisions", type = "IntGrid", intGridValues = list },
        { uid = 2, identifier = "Entities", type = "Entities", intGridValues = {} },
      },
      entities = {},
    },
    levels = levels,
    worlds = {},
  }
end

-- A level with a start, a player, a door to another level, a ladder and a floor.
local function newRoom(name, to, x)
  local rows = { "2.......", "2.......", "11133333" }
  local things = {
    ldtk.entity("Start", x, 32, 8, 32, { static = true, sensor = true }),
    ldtk.entity("Player", 24, 32, 16, 24, { lives = 3 }),
    ldtk.entity("Door", 110, 32, 8, 32, { to = to, static = true, sensor = true }),
  }
  return ldtk.level(name, {
    ldtk.entities("Entities", things),
    ldtk.intGrid("Collisions", rows),
    ldtk.intGrid("Background", rows, { __type = "AutoLayer" }),
  })
end

--- The project of the manual's snippets: two levels with doors that lead to each other.
function ldtk.cave()
  local levels = { newRoom("Cave", "Top", 20), newRoom("Top", "Cave", 24) }
  return ldtk.project(levels, { "dirt", "ladder", "stone" })
end

return ldtk
