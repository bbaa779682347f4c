--- Maps as Tiled 1.10 exports them, in few words.

local physics = require("physics")

local tiled = {}

--- The bits of a gid that flip the tile.
tiled.FLIP_X, tiled.FLIP_Y, tiled.TRANSPOSE = 2147483648.0, 1073741824.0, 536870912.0

--- Loads a map into a new world.
function tiled.load(map, options)
  local world = physics.newWorld({ gravity = 800 })
  local level = world:loadTiled(map, options)
  -- That a map has no wall, and what falls then, is told by rows of its own.
  for i = #level.unsupported, 1, -1 do
    local entry = level.unsupported[i]
    if entry.kind == "map" or entry.reason:find("^it falls") then
      level.missed = table.remove(level.unsupported, i)
    end
  end
  return level, world
end

--- The boxes of a group, one text each: "x y width height".
function tiled.boxes(world, group)
  local list = {}
  for i, object in ipairs(world.objects[group] or {}) do
    list[i] = ("%.14g %.14g %.14g %.14g"):format(object.x, object.y, object.width, object.height)
  end
  return list
end

local function copyInto(target, extra)
  for name, value in pairs(extra or {}) do
    target[name] = value
  end
  return target
end

tiled.copyInto = copyInto

--- A map of 16 px tiles around some tilesets and layers.
function tiled.map(tilesets, layers, extra)
  return copyInto({
    version = "1.10",
    luaversion = "5.1",
    tiledversion = "1.10.2",
    class = "",
    orientation = "orthogonal",
    renderorder = "right-down",
    width = 8,
    height = 4,
    tilewidth = 16,
    tileheight = 16,
    nextlayerid = 99,
    nextobjectid = 99,
    properties = {},
    tilesets = tilesets,
    layers = layers,
  }, extra)
end

--- A tileset of 16 px tiles; `tiles` are those that say something.
function tiled.tileset(tiles, extra)
  return copyInto({
    name = "terrain",
    firstgid = 1,
    class = "",
    tilewidth = 16,
    tileheight = 16,
    spacing = 0,
    margin = 0,
    columns = 4,
    image = "terrain.png",
    imagewidth = 64,
    imageheight = 64,
    objectalignment = "unspecified",
    tilerendersize = "tile",
    fillmode = "stretch",
    tileoffset = { x = 0, y = 0 },
    grid = { orientation = "orthogonal", width = 16, height = 16 },
    properties = {},
    wangsets = {},
    tilecount = 16,
    tiles = tiles or {},
  }, extra)
end

local function layer(type, id, name, extra)
  return copyInto({
    type = type,
    id = id,
    name = name,
    class = "",
    visible = true,
    opacity = 1,
    offsetx = 0,
    offsety = 0,
    parallaxx = 1,
    parallaxy = 1,
    properties = {},
  }, extra)
end

--- The gids of a picture: "." is nothing, a digit is a gid, other characters stand in `legend`.
function tiled.gids(rows, legend)
  local gids = {}
  for _, row in ipairs(rows) do
    for character in row:gmatch(".") do
      gids[#gids + 1] = character == "." and 0
        or legend and legend[character]
        or assert(tonumber(character), "not in the legend: " .. character)
    end
  end
  return gids
end

--- A tile layer from a picture.
function tiled.tiles(id, name, rows, extra, legend)
  local made = layer("tilelayer", id, name, { x = 0, y = 0, encoding = "lua" })
  made.width, made.height, made.data = #rows[1], #rows, tiled.gids(rows, legend)
  return copyInto(made, extra)
end

--- An object layer.
function tiled.objects(id, name, objects, extra)
  local made = layer("objectgroup", id, name, { draworder = "topdown", objects = objects })
  return copyInto(made, extra)
end

--- A group of layers.
function tiled.group(id, name, layers, extra)
  return copyInto(layer("group", id, name, { layers = layers }), extra)
end

--- A rectangle of an object layer, or of a tile's collision shapes.
function tiled.object(id, x, y, width, height, extra)
  return copyInto({
    id = id,
    name = "",
    type = "",
    shape = "rectangle",
    x = x,
    y = y,
    width = width,
    height = height,
    rotation = 0,
    visible = true,
    properties = {},
  }, extra)
end

--- What a tileset says of a tile with collision shapes.
function tiled.shapes(id, objects, extra)
  local group = tiled.objects(nil, "", objects, { draworder = "index", id = 2 })
  return copyInto({ id = id, objectGroup = group }, extra)
end

--- A part of an infinite layer.
function tiled.chunk(x, y, rows)
  return { x = x, y = y, width = #rows[1], height = #rows, data = tiled.gids(rows) }
end

--- An infinite map: a ledge, and a pillar that ends in another stone.
function tiled.infinite()
  local solid, rough = { solid = true }, { solid = true, friction = 0.9 }
  local set = tiled.tileset({ { id = 0, properties = solid }, { id = 3, properties = rough } })
  local rocks = tiled.tiles(1, "rocks", { "." }, { offsety = 8 })
  rocks.data, rocks.chunks =
    nil, {
      tiled.chunk(-4, 0, { "..11", "...." }),
      tiled.chunk(0, 0, { "11..", "1..." }),
      tiled.chunk(0, 2, { "1...", "4..." }),
    }
  local box = tiled.object(2, -20, 0, 8, 8, { properties = { mass = 2 } })
  return tiled.map({ set }, { rocks, tiled.objects(2, "boxes", { box }) }, { infinite = true })
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

tiled.copy = copy

-- STI ---------------------------------------------------------------------------------------------

local function flatten(layers, list)
  for _, inner in ipairs(layers) do
    if inner.type == "group" then
      for _, child in ipairs(inner.layers) do
        child.name = inner.name .. "." .. child.name
        child.offsetx = (inner.offsetx or 0) + (child.offsetx or 0)
        child.offsety = (inner.offsety or 0) + (child.offsety or 0)
        child.properties = copyInto(copyInto({}, inner.properties), child.properties)
      end
      flatten(inner.layers, list)
    else
      list[#list + 1] = inner
    end
  end
  return list
end

local function toRows(grid, tiles)
  local rows = {}
  for y = 1, grid.height do
    rows[y] = {}
    for x = 1, grid.width do
      local gid = grid.data[(y - 1) * grid.width + x]
      if gid ~= 0 then
        tiles[gid] = tiles[gid] or { gid = gid, properties = {}, sx = 1, sy = 1, r = 0 }
        rows[y][x] = tiles[gid]
      end
    end
  end
  grid.data = rows
end

-- STI turns corners by sine and cosine, and moves them to where the object is.
local function moveCorners(object, inner)
  local angle = math.rad(object.rotation or 0)
  local cos, sin = math.cos(angle), math.sin(angle)
  for _, corner in ipairs(object.polygon or object.polyline or {}) do
    local x, y = corner.x, corner.y
    corner.x = inner.x + object.x + cos * x - sin * y
    corner.y = inner.y + object.y + sin * x + cos * y
  end
end

--- The table that STI 1.2 makes of a map: layers without groups, also under their names; rows of
--- tiles instead of gids; objects by id. What it adds only for drawing is left out.
function tiled.sti(map, offsetX, offsetY)
  map = copy(map)
  map.offsetx, map.offsety = offsetX or 0, offsetY or 0
  map.objects, map.tiles, map.tileInstances = {}, {}, {}
  map.layers = flatten(map.layers, {})
  for _, inner in ipairs(map.layers) do
    inner.x = map.offsetx + (inner.offsetx or 0)
    inner.y = map.offsety + (inner.offsety or 0)
    for _, grid in ipairs(inner.chunks or { inner.data and inner }) do
      toRows(grid, map.tiles)
    end
    for _, object in ipairs(inner.objects or {}) do
      object.layer = inner
      moveCorners(object, inner)
      map.objects[object.id] = object
    end
  end
  for _, inner in ipairs(map.layers) do
    map.layers[inner.name] = inner
  end
  return map
end

return tiled
