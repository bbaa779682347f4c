-- Loads the maps that scripts/tiled_maps.sh has exported, in LÖVE, since its `love.data` unpacks
-- the layers. `love FOLDER NAME COUNT` says whether maps/NAME.lua has at least COUNT tiles when all
-- its tile layers are solid. It plays on with it for a second, also as the map is without options.

local physics = require("physics")

local function tileLayers(layers, names)
  for _, layer in ipairs(layers) do
    if layer.type == "tilelayer" then
      names[#names + 1] = layer.name
    elseif layer.layers then
      tileLayers(layer.layers, names)
    end
  end
  return names
end

local function countStatic(level)
  local count = 0
  for _, object in ipairs(level.objects) do
    count = count + (object.static and 1 or 0)
  end
  return count
end

local function load(path, options)
  local world = physics.newWorld()
  local level = world:loadTiled(path, options)
  for _ = 1, 60 do
    world:update(1 / 60)
  end
  return level
end

local function report(path, level)
  print(("%s: %d of %d objects are static"):format(path, countStatic(level), #level.objects))
  for _, part in ipairs(level.unsupported) do
    print("  unsupported:", part.kind, part.layer, part.id, part.reason)
  end
  for _, layer in ipairs(level.solidLayers) do
    print("  solid:", layer.name, layer.reason)
  end
end

local function checkMap(path, expected)
  local map, plain = love.filesystem.load(path)(), load(path)
  report(path, plain)
  if map.orientation ~= "orthogonal" then
    return #plain.unsupported > 0 and #plain.objects == 0
  end
  local solid = load(path, { solidLayers = tileLayers(map.layers, {}) })
  local text = "  all layers solid: %d tiles, expected at least %d; %d rectangles"
  print(text:format(solid.tiles, expected, solid.rectangles))
  return solid.tiles >= expected
end

function love.load(arguments)
  local isGood = checkMap("maps/" .. arguments[1] .. ".lua", tonumber(arguments[2]))
  love.event.quit(isGood and 0 or 1)
end
