--- Maps as Tiled 1.10 exports them, in few words.

local physics = require("physics")
local small = require("spec.support.small")

local tiled = {}

--- The bits of a gid that flip the tile.
tiled.FLIP_X, tiled.FLIP_Y, tiled.TRANSPOSE = 2147483648.0, 1073741824.0, 536870912.0

--- Loads a map into a new world.
function tiled.load(map, options)
  local world = physics.newWorld({ gravity = 800 })
  local level = world:loadTiled(map, options)
  -- That a map has no wall is told by rows of its own.
  for i = #level.unsupported, 1, -1 do
    local entry = level.unsupported[i]
    if entry.kind == "map" then
      level.missed = table.remove(level.unsupported, i)
    end
  end
  return level, world
end

-- What is read ------------------------------------------------------------------------------------

local SKIPPED = { x = true, y = true, width = true, height = true, tiled = true, ldtk = true }
SKIPPED.touching, SKIPPED.points = true, true

local function show(value, depth)
  if type(value) ~= "table" then
    return type(value) == "number" and ("%.8g"):format(value) or tostring(value)
  end
  local list = {}
  for key, inner in pairs(value) do
    if depth > 0 or not (SKIPPED[key] or inner == 0 and (key == "vx" or key == "vy")) then
      list[#list + 1] = inner == true and key or ("%s=%s"):format(key, show(inner, depth + 1))
    end
  end
  table.sort(list)
  local text = table.concat(list, " ")
  return depth > 0 and "{" .. text .. "}" or text
end

local function describe(words, thing)
  local place = ("%.8g %.8g"):format(thing.x, thing.y)
  if thing.width then
    place = ("%s %.8g %.8g"):format(place, thing.width, thing.height)
  end
  for _, point in ipairs(thing.points or {}) do
    place = ("%s, %.8g %.8g"):format(place, point.x, point.y)
  end
  return (("%s %s %s"):format(words, place, show(thing, 0)):gsub(" $", ""))
end

--- A level as a text: "group x y width height fields" of each object, points, lines and pictures
--- likewise, and "! layer: reason" of what is not supported, with " x2" if it is twice.
function tiled.show(level, world)
  local groupOf, list = {}, {}
  for group, objects in pairs(world.objects) do
    for _, object in ipairs(objects) do
      groupOf[object] = group
    end
  end
  for _, kind in ipairs({ "objects", "points", "lines", "pictures" }) do
    for _, thing in ipairs(level[kind] or {}) do
      if not thing.gridTiles then
        list[#list + 1] = describe(groupOf[thing] or kind:sub(1, -2), thing)
      end
    end
  end
  for _, entry in ipairs(level.unsupported) do
    local count = entry.count > 1 and " x" .. entry.count or ""
    list[#list + 1] = ("! %s: %s%s"):format(entry.layer, entry.reason, count)
  end
  return table.concat(list, "; ")
end

--- The boxes of a group, one text each: "x y width height".
function tiled.boxes(world, group)
  local list = {}
  for i, object in ipairs(world.objects[group] or {}) do
    list[i] = ("%.14g %.14g %.14g %.14g"):format(object.x, object.y, object.width, object.height)
  end
  return list
end

--- A map of 16 px tiles around some tilesets and layers. What the library never reads is left out;
--- spec/maps has whole exports.
function tiled.map(tilesets, layers, extra)
  local map = { orientation = "orthogonal", width = 8, height = 4, tilewidth = 16, tileheight = 16 }
  map.properties, map.tilesets, map.layers = {}, tilesets, layers
  return small.set(map, extra)
end

--- A tileset of 16 px tiles; `tiles` are those that say something.
function tiled.tileset(tiles, extra)
  local set = { name = "terrain", firstgid = 1, tilewidth = 16, tileheight = 16, tilecount = 16 }
  set.objectalignment, set.tilerendersize = "unspecified", "tile"
  set.tileoffset, set.tiles = { x = 0, y = 0 }, tiles or {}
  return small.set(set, extra)
end

local function layer(type, id, name, extra)
  return small.set({ type = type, id = id, name = name, class = "", properties = {} }, extra)
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
  local made = layer("tilelayer", id, name, { encoding = "lua" })
  made.width, made.height, made.data = #rows[1], #rows, tiled.gids(rows, legend)
  return small.set(made, extra)
end

--- An object layer.
function tiled.objects(id, name, objects, extra)
  local made = layer("objectgroup", id, name, { objects = objects })
  return small.set(made, extra)
end

--- A group of layers.
function tiled.group(id, name, layers, extra)
  return small.set(layer("group", id, name, { layers = layers }), extra)
end

--- A rectangle of an object layer, or of a tile's collision shapes.
function tiled.object(id, x, y, width, height, extra)
  local object = { id = id, x = x, y = y, width = width, height = height, rotation = 0 }
  object.name, object.type, object.shape, object.properties = "", "", "rectangle", {}
  return small.set(object, extra)
end

--- What a tileset says of a tile with collision shapes.
function tiled.shapes(id, objects, extra)
  local group = tiled.objects(2, "", objects)
  return small.set({ id = id, objectGroup = group }, extra)
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
  local left = tiled.chunk(-4, 0, { "..11", "...." })
  local upper, lower = tiled.chunk(0, 0, { "11..", "1..." }), tiled.chunk(0, 2, { "1...", "4..." })
  rocks.data, rocks.chunks = nil, { left, upper, lower }
  local box = tiled.object(2, -20, 0, 8, 8, { properties = { mass = 2 } })
  return tiled.map({ set }, { rocks, tiled.objects(2, "boxes", { box }) }, { infinite = true })
end

-- STI ---------------------------------------------------------------------------------------------

local function flatten(layers, list)
  for _, inner in ipairs(layers) do
    if inner.type == "group" then
      for _, child in ipairs(inner.layers) do
        child.name = inner.name .. "." .. child.name
        child.offsetx = (inner.offsetx or 0) + (child.offsetx or 0)
        child.offsety = (inner.offsety or 0) + (child.offsety or 0)
        child.properties = small.set(small.set({}, inner.properties), child.properties)
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
  map = small.copy(map)
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

-- JSON --------------------------------------------------------------------------------------------

local SHAPES = { ellipse = true, point = true, capsule = true, text = true }

-- Properties as a list, in an order of its own.
local function listProperties(owner)
  local list = {}
  for name, value in pairs(owner.properties or {}) do
    local kind = type(value) == "table" and (value.id and "object" or "class") or type(value)
    local isList = kind == "class" and value[1] ~= nil
    local given = kind == "object" and value.id or value
    if isList then
      given = {}
      for i, inner in ipairs(value) do
        given[i] = { type = "string", value = inner }
      end
    end
    list[#list + 1] = { name = name, type = isList and "list" or kind, value = given }
  end
  owner.properties = list[1] and list or nil
end

local function writeObjects(owner)
  for _, object in ipairs(owner.objects or {}) do
    listProperties(object)
    if SHAPES[object.shape] then
      object[object.shape] = true
    end
    object.shape = nil
  end
end

local function writeLayers(layers)
  for _, inner in ipairs(layers) do
    listProperties(inner)
    writeObjects(inner)
    writeLayers(inner.layers or {})
    inner.encoding = inner.encoding ~= "lua" and inner.encoding or nil
  end
end

--- The table that a JSON library makes of the JSON that Tiled exports of a map.
function tiled.json(map)
  map = small.copy(map)
  map.type, map.infinite = "map", map.infinite or false
  writeLayers(map.layers)
  for _, set in ipairs(map.tilesets) do
    for _, tile in ipairs(set.tiles or {}) do
      tile.objectgroup, tile.objectGroup = tile.objectGroup, nil
      listProperties(tile)
      writeObjects(tile.objectgroup or {})
      if tile.image then
        tile.imagewidth, tile.imageheight = tile.width, tile.height
        tile.width, tile.height = nil, nil
      end
    end
  end
  return map
end

-- Rows --------------------------------------------------------------------------------------------

--- A map with this title must be read like that, also from JSON, and through STI unless `sti` is
--- false.
function tiled.row(title, map, expected, options, sti)
  small.rows(title, { {} }, function()
    for _, each in ipairs({ map, tiled.json(map), sti ~= false and tiled.sti(map) or nil }) do
      local found = tiled.show(tiled.load(each, options))
      assert(found == expected, found)
    end
  end)
end

-- Reads words: `name=value` is a field of the editor, `name:value` a property, `4,5` a corner, and
-- a word without these the shape. Returns the plain numbers.
local function readWords(target, text)
  local numbers = {}
  for word in text:gmatch("%S+") do
    local name, sign, value = word:match("^(%a%w*)([=:])(.*)$")
    local x, y = word:match("^(%-?[%d.]+),(%-?[%d.]+)$")
    if name then
      local owner = sign == "=" and target or target.properties
      owner[name] = value == "true" or value ~= "false" and (tonumber(value) or value)
    elseif x then
      table.insert(target[target.shape], { x = tonumber(x), y = tonumber(y) })
    elseif tonumber(word) then
      numbers[#numbers + 1] = tonumber(word)
    else
      target.shape, target[word] = word, {}
    end
  end
  return numbers
end

local function readBody(name, body)
  local rows, objects = {}, {}
  if body:find("^#") then
    for row in body:gmatch("[^# ]+") do
      rows[#rows + 1] = row
    end
    return tiled.tiles(1, name, rows)
  end
  for part in body:gmatch("[^;]+") do
    local object = tiled.object(#objects + 1)
    local numbers = readWords(object, part)
    object.x, object.y, object.width, object.height = numbers[1], numbers[2], numbers[3], numbers[4]
    objects[#objects + 1] = object
  end
  return tiled.objects(1, name, objects)
end

--- Rows of text: "title | layer | body | options", and below it, indented, what `show` gives. The
--- layer is a name and words (see above), the body a picture of tiles, "#11. 1..", or objects,
--- "ellipse 0 0 8 8 name=a solid:true; 9 0 8 8". The options are Lua; `tiles` and `set` among them
--- are the tileset's, and they know the names in `known`.
function tiled.text(text, known)
  local rows = {}
  for line in text:gmatch("[^\n]+") do
    local title, head, body, options = line:match("^(%S.-) +| (.-) +| ([^|]*)|? ?(.*)$")
    if title then
      local compile = rawget(_G, "loadstring") or rawget(_G, "load")
      local chunk = assert(compile("return { " .. options .. " }"))
      rows[#rows + 1] = { title = title, options = chunk(), expected = {} }
      rows[#rows].layer = readBody(head:match("%S+"), body)
      readWords(rows[#rows].layer, head:match("%S+(.*)"))
    else
      table.insert(rows[#rows].expected, line:match("^ +(.*)$"))
    end
  end
  for _, row in ipairs(rows) do
    local options = row.options
    local set = tiled.tileset(known and known[options.tiles], known and known[options.set])
    options.tiles, options.set = nil, nil
    local map = tiled.map({ set }, { row.layer })
    tiled.row(row.title, map, table.concat(row.expected, "; "), options)
  end
end

return tiled
