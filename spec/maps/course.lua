--- The map of course.tmx, as Tiled 1.8 exports it, without what is the same for all maps.
--- (meadow.lua is an export to the letter. Nothing global is there where a map is read.)

local function object(id, x, y, width, height, fields)
  fields.id, fields.x, fields.y, fields.width, fields.height = id, x, y, width, height
  fields.name, fields.type = fields.name or "", fields.type or ""
  fields.shape, fields.rotation = fields.shape or "rectangle", fields.rotation or 0
  fields.visible, fields.properties = true, fields.properties or {}
  return fields
end

local function layer(id, name, objects)
  local made = { id = id, name = name, type = "objectgroup", draworder = "topdown" }
  made.visible, made.opacity, made.properties, made.objects = true, 1, {}, objects
  made.offsetx, made.offsety, made.parallaxx, made.parallaxy = 0, 0, 1, 1
  return made
end

local earth = { name = "earth", firstgid = 1, tilewidth = 16, tileheight = 16, tilecount = 8 }
earth.columns, earth.image, earth.imagewidth, earth.imageheight = 8, "earth.png", 128, 16
earth.spacing, earth.margin, earth.tileoffset, earth.properties = 0, 0, { x = 0, y = 0 }, {}
earth.objectalignment, earth.wangsets = "unspecified", {}
earth.tiles = {
  { id = 0, properties = { collidable = "true" } },
  { id = 1, type = "crate" },
  { id = 2, properties = { collidable = true, oneWay = true } },
}

local scenery = layer(2, "scenery")
scenery.type, scenery.encoding, scenery.draworder, scenery.data = "tilelayer", "lua", nil, {}
scenery.x, scenery.y, scenery.width, scenery.height = 0, 0, 20, 10
local grass = { 6, 6, 0, 0, 6, 0, 0, 0, 6, 0, 0, 6, 6, 0, 0, 0, 6, 0, 6, 6 }
for n = 1, 200 do
  scenery.data[n] = n > 180 and 1 or n > 160 and grass[n - 160] or 0
end

local CORNER = { { x = 0, y = 0 }, { x = 64, y = 0 }, { x = 64, y = 16 }, { x = 16, y = 16 } }
CORNER[5], CORNER[6] = { x = 16, y = 48 }, { x = 0, y = 48 }
local RAMP = { { x = 0, y = 0 }, { x = 32, y = 0 }, { x = 32, y = -16 } }
local WAY = { { x = 0, y = 0 }, { x = 0, y = -48 }, { x = 48, y = -48 } }
local WORDS = { drag = "true", floating = "true", friction = "1.00" }
local map = { orientation = "orthogonal", width = 20, height = 10, tilewidth = 16, tileheight = 16 }
map.properties, map.tilesets = {}, { earth }
map.layers = {
  layer(1, "Background", { object(1, 32, 48, 32, 32, { gid = 5 }) }),
  scenery,
  layer(3, "Platforms", {
    object(3, 0, 144, 320, 16, {}),
    object(4, 48, 96, 64, 16, {}),
    object(5, 224, 96, 48, 16, { rotation = 90 }),
    object(6, 240, 64, 0, 0, { shape = "polygon", polygon = CORNER }),
    object(7, 128, 96, 32, 8, { name = "lift", properties = { kinematic = true } }),
    object(8, 16, 144, 0, 0, { shape = "polygon", polygon = RAMP }),
  }),
  layer(4, "Start", {
    object(9, 24, 120, 0, 0, { name = "player", type = "spawn", shape = "point" }),
  }),
  layer(5, "Enemies", {
    object(11, 64, 84, 12, 12, { name = "slime", type = "enemy", properties = WORDS }),
    object(12, 192, 144, 16, 16, { name = "crate", gid = 2 }),
  }),
  layer(6, "paths", {
    object(13, 128, 96, 0, 0, { name = "lift", shape = "polyline", polyline = WAY }),
  }),
}
return map
