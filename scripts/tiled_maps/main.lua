-- Loads the maps that scripts/tiled_maps.sh has exported, in LÖVE, since its `love.data` unpacks
-- the layers. `love FOLDER NAME COUNT` says whether maps/NAME.lua has at least COUNT tiles when all
-- its tile layers are solid, and gives the same level as maps/NAME.json. It plays on with it for a
-- second, also as the map is without options.

local json = require("json")
local physics = require("physics")

-- Notes all layers of tiles as solid.
local function tileLayers(layers, names)
  for _, layer in ipairs(layers) do
    if layer.type == "tilelayer" then
      names[layer.name] = "static"
    elseif layer.layers then
      tileLayers(layer.layers, names)
    end
  end
  return names
end

local function load(path, options)
  local world = physics.newWorld()
  local level = world:loadTiled(path, options)
  for _ = 1, 60 do
    world:update(1 / 60)
  end
  return level
end

-- Returns a value as a text. What leads back to the map is left out, and so are functions.
local IS_OTHER = { tiled = true, map = true, touching = true }

local function show(value)
  local list = {}
  if type(value) ~= "table" then
    return type(value) == "number" and ("%.14g"):format(value) or tostring(value)
  end
  for key, inner in pairs(value) do
    if not IS_OTHER[key] then
      list[#list + 1] = tostring(key) .. "=" .. show(inner)
    end
  end
  table.sort(list)
  return "{" .. table.concat(list, " ") .. "}"
end

-- Returns all that a level has, as a text.
local function describe(level)
  local list = {}
  for _, name in ipairs({ "objects", "points", "lines", "pictures" }) do
    list[#list + 1] = name .. show(level[name])
  end
  for _, part in ipairs(level.unsupported) do
    list[#list + 1] = ("%s %s %s x%d"):format(part.kind, part.layer, part.reason, part.count)
  end
  local place = { level.x, level.y, level.width, level.height, level.tiles, level.rectangles }
  return table.concat(list, "; ") .. show(place)
end

local function checkMap(path, expected)
  local map, plain = love.filesystem.load(path)(), load(path)
  local inJson = load(path:gsub("%.lua$", ".json"), { decode = json.decode })
  if describe(inJson) ~= describe(plain) then
    print("  JSON gives another level:", describe(inJson))
    print("  than Lua:", describe(plain))
    return false
  end
  if map.orientation ~= "orthogonal" then
    return #plain.unsupported > 0 and #plain.objects == 0
  end
  local solid = load(path, { kinds = tileLayers(map.layers, {}) })
  local text = "  all layers solid: %d tiles, expected at least %d; %d rectangles"
  print(text:format(solid.tiles, expected, solid.rectangles))
  return solid.tiles >= expected
end

function love.load(arguments)
  local isGood = checkMap("maps/" .. arguments[1] .. ".lua", tonumber(arguments[2]))
  love.event.quit(isGood and 0 or 1)
end
