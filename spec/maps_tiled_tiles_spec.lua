--- Tiles of Tiled maps: which are solid, where, how many rectangles become of them; packed layers,
--- tilesets in files of their own, and digging.

local physics = require("physics")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

local load, boxes, show = tiled.load, tiled.boxes, tiled.show
local X, Y, T = tiled.FLIP_X, tiled.FLIP_Y, tiled.TRANSPOSE

--- A map of one layer of tiles. 1 is solid, 2 a sensor, 3 a ledge, 4 rough, 5 says nothing, 6 is
--- not solid, 7 moves, 8 is as solid as 1 and has a name.
local TILES = {
  { id = 0, properties = { solid = true } },
  { id = 1, properties = { solid = true, sensor = true } },
  { id = 2, properties = { solid = true, oneWay = "top" } },
  { id = 3, properties = { solid = true, friction = 0.75 } },
  { id = 5, properties = { solid = false } },
  { id = 6, properties = { solid = true, kinematic = true } },
  { id = 7, properties = { solid = true, label = "marble" } },
}

local function newMap(rows, extra, legend, tiles, set)
  local layer = tiled.tiles(1, "ground", rows, extra, legend)
  return tiled.map({ tiled.tileset(tiles or TILES, set) }, { layer })
end

-- What a spec may put there for a while.
local function pretend(love)
  local before = rawget(_G, "love")
  finally(function()
    rawset(_G, "love", before)
  end)
  rawset(_G, "love", love)
end

describe("world:loadTiled, tiles", function()
  describe("are solid", function()
    local LAYER, NO, YES = { kinds = { ground = "static" } }, { solid = false }, { solid = true }
    local LEGEND = { a = 5 + X, b = 6 + Y + T, c = 5 + 268435456.0 } -- flipped

    -- why, the tiles, properties of their layer and of one around it, options, how many are solid
    small.rows("{1}", {
      { "by their property, and nothing else is", "1556.555...1", nil, nil, nil, 2 },
      { "by their layer's property, but for those that say no", "1556", YES, nil, nil, 3 },
      { "by the name of their layer", "1556", nil, nil, LAYER, 3 },
      { "by a layer around theirs", "555", nil, YES, nil, 3 },
      { "but not against their own layer", "555", NO, {}, { kinds = { all = "static" } }, 0 },
      { "by the nearest layer that says anything", "5", YES, NO, nil, 1 },
      { "however they are flipped", "1a5bc...", YES, nil, nil, 4 },
      { "in one that says no, by its name", "1234", NO, nil, LAYER, 4 },
      { "by no name of a layer if they say no", "666", NO, nil, LAYER, 0 },
    }, function(_, cells, its, around, options, count)
      local map = newMap({ cells }, { properties = its }, LEGEND)
      if around then
        map.layers = { tiled.group(2, "all", map.layers, { properties = around }) }
      end
      assert.equal(count, (load(map, options)).tiles)
    end)
  end)

  local function shape(id, x, y, width, height, extra, properties)
    local object = tiled.object(1, x, y, width, height, extra)
    object.properties = properties or {}
    return tiled.shapes(id, { object })
  end
  local groups = {
    { id = 0, properties = { solid = true } },
    { id = 1, properties = { solid = true, group = "ice" } },
    { id = 2, properties = { solid = true, merge = false } },
  }
  local mushroom = shape(0, 0, 0, 16, 4, nil, { oneWay = "top" })
  mushroom.objectGroup.objects[2] =
    tiled.object(2, 6, 4, 4, 12, { properties = { friction = 0.9 } })
  mushroom.properties = { friction = 0.1, label = "mushroom" }
  local silent = shape(5, 0, 8, 16, 8)
  silent.properties = { solid = false }
  local known = {
    word = { { id = 4, properties = { hard = true } } },
    low = { shape(4, 0, 8, 16, 8), silent, tiled.shapes(6, {}) },
    groups = groups,
    mushroom = { mushroom },
    halves = { shape(0, 0, 8, 16, 8), shape(1, 0, 0, 8, 16) },
    round = {
      shape(0, 2, 4, 8, 8, { shape = "ellipse" }),
      shape(1, 0, 0, 8, 16, { shape = "ellipse" }),
    },
    turned = { shape(0, 16, 0, 4, 16, { rotation = 90 }) },
    images = {
      { id = 2, image = "tree.png", width = 20, height = 48 },
      { id = 5, image = "bush.png", width = 12, height = 10 },
    },
    few = { tilecount = 2 },
    corner = { shape(0, 0, 4, 8, 4) },
    grid = { tilewidth = 8, tileheight = 8, tilerendersize = "grid" },
    misfit = { { id = 0, properties = { solid = true, area = { gravity = 5 }, radius = 3 } } },
    all = TILES,
    spoken = {
      { id = 0, properties = { oneWay = "top" } },
      { id = 1, properties = { slope = "right" } },
      { id = 2, properties = { sensor = true, group = "ladders" } },
      { id = 3, properties = { static = true } },
      { id = 4, properties = { kinematic = true } },
      { id = 5, properties = { mass = 2 } },
      { id = 6, properties = { friction = 0.5 } },
      { id = 7, properties = { solid = true } },
      { id = 8, properties = { oneWay = "top", solid = false } },
    },
    zone = { { id = 0, properties = { area = { gravity = 5 } } } },
  }
  tiled.text(
    [[by a property of any name | ground | #515 | tiles = "word", solidProperty = "hard"
  ground 0 0 16 16 static; ground 32 0 16 16 static
by their shapes, unless they say no | ground | #5567 | tiles = "low"
  ground 0 8 32 8 static
solid, unless they say otherwise | ground | #17 | tiles = "all"
  ground 0 0 16 16 static; ground 16 0 16 16 kinematic
not static, by their layer | ground static:false | #1 | tiles = "all"
  ground 0 0 16 16 static=false
by a field that decides, without solid | all | #123456 | tiles = "spoken"
  all 0 0 16 16 oneWay=top static; all 16 0 16 16 slope=right static
  ladders 32 0 16 16 sensor static; all 48 0 16 16 static; all 64 0 16 16 kinematic
  all 80 0 16 16 mass=2
also where one says solid | ground | #1238.. | tiles = "spoken"
  ground 0 0 16 16 oneWay=top static; ground 16 0 16 16 slope=right static
  ladders 32 0 16 16 sensor static; ground 48 0 16 16 static
not by a field that says nothing of it, nor against solid | all | #1.79. | tiles = "spoken"
  all 0 0 16 16 oneWay=top static
by an area | all | #1 | tiles = "zone"
  all 0 0 16 16 area={gravity=5} sensor static
by a field of their layer | all oneWay:top | #77.7 | tiles = "spoken"
  all 0 0 32 16 friction=0.5 oneWay=top static; all 48 0 16 16 friction=0.5 oneWay=top static
as slopes, by their layer, but with their shapes | all slope:left | #15 | tiles = "low"
  all 0 0 16 16 slope=left static; all 16 8 16 8 static
by groups, and apart if they say so | ground | #112233 | tiles = "groups"
  ground 0 0 32 16 static; ice 32 0 32 16 static; ground 64 0 16 16 static
  ground 80 0 16 16 static
with all their shapes: equal caps merge, stems do not | ground | #111 1.. | tiles = "mushroom"
  ground 0 0 48 4 friction=0.1 label=mushroom oneWay=top static
  ground 0 16 16 4 friction=0.1 label=mushroom oneWay=top static
  ground 6 4 4 12 friction=0.9 label=mushroom static
  ground 22 4 4 12 friction=0.9 label=mushroom static
  ground 38 4 4 12 friction=0.9 label=mushroom static
  ground 6 20 4 12 friction=0.9 label=mushroom static
as halves that merge along the side where they meet | ground | #11.22 11.22 | tiles = "halves"
  ground 0 8 32 8 static; ground 0 24 32 8 static; ground 48 0 8 32 static
  ground 64 0 8 32 static
as circles | ground | #11 2. | tiles = "round"
  ground 2 4 8 8 radius=4 static; ground 18 4 8 8 radius=4 static
  ! ground: ellipse: only circles are round; the option ellipses = "box" makes it a box
with a turned shape | ground | #.11 | tiles = "turned"
  ground 16 0 32 4 static
with images of their own | ground | #36 | tiles = "images", set = "few", kinds = { "static" }
  ground 0 -32 20 48 static; ground 16 6 12 10 static
at the size of the grid, with their shapes | ground | #11 | tiles = "corner", set = "grid"
  ground 0 8 32 8 static
without fields that do not fit each other, which are named once | ground | #1.1 | tiles = "misfit"
  ground 0 0 16 16 static; ground 32 0 16 16 static
  ! ground: area must be nil unless the object is a sensor: it is left out
  ! ground: radius must be half of width and height, which are 16 and 16: it is left out
]],
    known
  )

  local triangle = { { x = 0, y = 0 }, { x = 0, y = -16 }, { x = 16, y = 0 } }
  local ramp = shape(0, 0, 16, 0, 0, { shape = "polygon", polygon = triangle })
  small.each("with slopes that flip and turn with them: {1}", {
    left = { 0, T + X + Y },
    right = { X, T + Y },
    topleft = { Y, T + X },
    topright = { X + Y, T },
  }, function(slope, flags)
    local legend = { a = 1 + flags[1], b = 1 + flags[2] }
    local level = load(newMap({ "ab" }, nil, legend, { ramp }))
    assert.same({ slope, slope }, { level.objects[1].slope, level.objects[2].slope })
  end)

  --- Each row: a picture, and the rectangles in tiles: column row columns rows.
  for _, row in ipairs({
    { "a column", { ".1.", ".1.", ".1." }, "1 0 1 3" },
    { "a floor with pillars", { "1.1", "1.1", "111" }, "0 0 1 2, 2 0 1 2, 0 2 3 1" },
    { "a hole", { "111", "1.1", "111" }, "0 0 3 1, 0 1 1 1, 2 1 1 1, 0 2 3 1" },
    { "equal tiles only", { "1144" }, "0 0 2 1, 2 0 2 1" },
    { "equal in what the game says of them, too", { "1188" }, "0 0 2 1, 2 0 2 1" },
    { "ledges in a row, not in a column", { "33", "33" }, "0 0 2 1, 0 1 2 1" },
    { "no sensors", { "22" }, "0 0 1 1, 1 0 1 1" },
    { "sensors that say merge", { "22", "22" }, "0 0 2 2", { merge = true } },
  }) do
    it("merge: " .. row[1], function()
      local level = load(newMap(row[2], { properties = row[4] }))
      local found = {}
      for i, object in ipairs(level.objects) do
        local tile = object.tiled
        found[i] = ("%d %d %d %d"):format(tile.column, tile.row, tile.columns, tile.rows)
        assert.same(
          { tile.column * 16, tile.row * 16, tile.columns * 16, tile.rows * 16 },
          { object.x, object.y, object.width, object.height }
        )
      end
      assert.equal(row[3], table.concat(found, ", "))
      assert.same(
        { #found, select(2, table.concat(row[2]):gsub("%d", "")) },
        { level.rectangles, level.tiles }
      )
    end)
  end

  it("merge over equal tiles of several tilesets", function()
    local first = tiled.tileset({ { id = 0, properties = { solid = true } } }, { tilecount = 4 })
    local second = tiled.tileset({ { id = 2, properties = { solid = true } } }, { firstgid = 5 })
    local level = load(tiled.map({ first, second }, { tiled.tiles(1, "ground", { "1771" }) }))
    assert.same({ 4, 1, nil }, { level.tiles, level.rectangles, level.objects[1].tiled.gid })
  end)

  it("are there, too, if the image of their tileset was missing at the export", function()
    local set = tiled.tileset({}, { tilecount = 0 })
    local level = load(tiled.map({ set }, { tiled.tiles(1, "walls", { "15.9" }) }))
    assert.same({ 3, 2, 0 }, { level.tiles, #level.objects, #level.unsupported })
  end)

  it("are refused behind the last tileset, in whichever order the map lists them", function()
    local first = tiled.tileset({}, { tilecount = 4 })
    local second = tiled.tileset({}, { firstgid = 5, tilecount = 4 })
    for _, sets in ipairs({ { first, second }, { second, first } }) do
      local map = tiled.map(sets, { tiled.tiles(1, "ground", { "1589" }) })
      local isRead, message = pcall(load, map)
      assert.is_false(isRead)
      assert.truthy(message:find("must be a gid of one of the tilesets, got 9", 1, true))
    end
  end)

  --- One rectangle in a tile, 2 px from the left, 3 px from the top, 4 px wide, 8 px high, in all
  --- the ways in which the editor turns tiles (keys X, Y and Z); and tiles of 24 x 40 px, which
  --- stand on the lower left corner of their cell.
  ---
  ---      +--------+                +----+
  ---      | +-+    |                |    |
  ---      | | |    |            +--+|    |
  ---      | +-+    |            |  ||    |
  ---      +--------+            +--++----+
  local little = { tiled.shapes(0, { tiled.object(1, 2, 3, 4, 8) }) }
  local moved, grid = { tileoffset = { x = 3, y = -5 } }, { tilerendersize = "grid" }
  small.rows("stand {1}", {
    { "as drawn", 0, "2 3 4 8" },
    { "flipped left to right", X, "10 3 4 8" },
    { "flipped top to bottom", Y, "2 5 4 8" },
    { "turned by 180 degrees", X + Y, "10 5 4 8" },
    { "flipped along the diagonal", T, "3 2 8 4" },
    { "turned by 90 degrees", T + X, "5 2 8 4" },
    { "turned by 270 degrees", T + Y, "3 10 8 4" },
    { "flipped along the other diagonal", T + X + Y, "5 10 8 4" },
    { "larger than a cell", 0, "0 -24 24 40", {} },
    { "moved by the tileset", 0, "3 -29 24 40", moved },
    { "large, turned by 90 degrees", T + X, "0 -8 40 24", {} },
    { "drawn at the size of the grid", 0, "0 0 16 16", grid },
  }, function(_, flags, expected, fields)
    local set = fields and small.set({ tilewidth = 24, tileheight = 40 }, fields)
    local map = newMap({ "a" }, nil, { a = 1 + flags }, not set and little, set)
    local _, world = load(map)
    assert.same({ expected }, boxes(world, "ground"))
  end)
end)

describe("world:loadTiled, packed layers", function()
  local PLAIN = dofile("spec/maps/meadow.lua")
  local REASON =
    "nothing here can unpack it; choose CSV as Tile Layer Format in the map's properties"

  -- Returns a map of three tiles, of which data is packed in that way.
  local function packed(compression, data, encoding)
    local map = newMap({ "..." }, nil, nil, nil, { firstgid = 1 })
    local layer = map.layers[1]
    layer.encoding, layer.compression = encoding or "base64", compression
    layer.data = data or "AQAAAAAAAAAFAACA"
    return map
  end

  -- LÖVE, which can unpack "zlib".
  local function know(packing, bytes)
    local function unpack(container, how, data)
      return assert(container .. how .. data == "stringzlib" .. packing and bytes)
    end
    pretend({ data = { decompress = unpack } })
  end

  local BYTES = "\1\0\0\0\0\0\0\0\5\0\0\128"

  it("are read in base64, and unpacked by LÖVE", function()
    know("a", BYTES)
    for _, map in ipairs({ packed(), packed("", "AQAAAAAA\n AAAFAACA"), packed("zlib", "YQ==") }) do
      local ground = load(map, { kinds = { ground = "static" } }).tileLayers.ground
      assert.same({ 1, 0, 2147483653 }, {
        ground:getTile(0, 0),
        ground:getTile(1, 0),
        ground:getTile(2, 0),
      })
      assert.is_string(map.layers[1].data) -- the map is as it was
    end
  end)

  it("of an infinite map are parts", function()
    local map = small.copy(PLAIN)
    local layer = map.layers[1]
    local part = { x = -24, y = 0, width = 24, height = 12, data = layer.data }
    layer.chunks = { part, { x = 0, y = 0, width = 24, height = 12, data = layer.data } }
    layer.data = nil
    assert.equal(186, (load(map)).tiles)
  end)

  small.each("are named if nothing can unpack them: {1}", {
    ["encoded data (zlib, base64): "] = packed("zlib", "AAAA"),
    ["encoded data (zstd, base64): "] = packed("zstd"),
    ["encoded data (csv): "] = packed(nil, "1,0,5", "csv"),
  }, function(expected, map)
    assert.equal("! ground: " .. expected .. REASON, show(load(map)))
    know("", BYTES)
    assert.equal("! ground: " .. expected .. REASON, show(load(map)))
  end)

  small.rows("are refused, if they are no base64: {1}", { "AA$=", "AAA" }, function(data)
    local words = 'world:loadTiled(map): layer "ground": data must be base64, got "%s"'
    small.refuses(words:format(data), load, packed(nil, data))
    small.refuses(words:format(data), load, packed("zlib", data))
  end)

  small.each("are refused: {1}", {
    ["#data must be an integer in 3..3, got 0"] = "",
    ["#data must be an integer in 3..3, got 1"] = "\1\0\0\0",
    ["the cell at column 0, row 0 must be a gid of one of the tilesets, got 9999"] = (
      BYTES:gsub("^..", "\15\39")
    ),
  }, function(expected, bytes)
    know("a", bytes)
    small.refuses(
      'world:loadTiled(map): layer "ground": ' .. expected,
      load,
      packed("zlib", "YQ==")
    )
  end)
end)

describe("world:loadTiled, tilesets in files of their own", function()
  local SET =
    [[return { name = "earth", tilewidth = 16, tileheight = 16, tilecount = 4, columns = 4,
    tiles = { { id = 1, type = "rock", properties = { solid = true } } } }]]
  local HEAD = '! land: external ("earth.tsx"): '

  --- Writes a Lua file and returns its folder and its name.
  local function write(text)
    local path = os.tmpname()
    local file = assert(io.open(path, "wb"))
    file:write(text)
    file:close()
    finally(function()
      os.remove(path)
    end)
    return path:match("^(.*)/([^/]+)$")
  end

  -- A map with such a tileset; `name` is that of its file, the end of a path.
  local function newLand(exportName)
    local set =
      { name = "earth", firstgid = 1, filename = "earth.tsx", exportfilename = exportName }
    return tiled.map({ set }, { tiled.tiles(1, "land", { "12." }) })
  end

  it("are read from exportfilename, beside the map", function()
    local folder, name = write(SET)
    local map = newLand(name)
    assert.equal("land 16 0 16 16 static type=rock", show(load(map, { folder = folder })))
    assert.is_nil(map.tilesets[1].tilewidth) -- the map is as it was
  end)

  small.rows("are read from where a map lies: {1}", { "", "./", "nowhere/../" }, function(way)
    local _, name = write(SET)
    local folder, map = write(([[return { orientation = "orthogonal", width = 2, height = 1,
      tilewidth = 16, tileheight = 16, tilesets = { { firstgid = 1, filename = "e.tsx",
      exportfilename = "%s" } }, layers = { { type = "tilelayer", id = 1, name = "land",
      width = 2, height = 1, data = { 1, 2 } } } }]]):format(way .. name))
    assert.equal(1, (load(folder .. "/" .. map)).tiles)
  end)

  it("are looked for by love.filesystem without any .., as maps are", function()
    local asked, filesystem = {}, {}
    function filesystem.getInfo(path)
      asked[#asked + 1] = path
      return path:find("^sets/") and {} or nil
    end
    function filesystem.load(path)
      local compile = rawget(_G, "loadstring") or rawget(_G, "load")
      return path == "sets/map.lua" and loadfile("spec/maps/course.lua") or compile(SET)
    end
    pretend({ filesystem = filesystem })
    assert.equal(1, (load(newLand("../sets/earth.lua"), { folder = "maps" })).tiles)
    assert.equal(1, (load(newLand("earth.lua"), { folder = "sets" })).tiles)
    load(newLand("../earth.lua"), { folder = "" })
    assert.same({ "sets/earth.lua", "sets/earth.lua", "../earth.lua" }, asked)
    assert.same({ 1, false }, { #load("sets/map.lua").points, (pcall(load, "maps/map.lua")) })
  end)

  it("are named if they cannot be had, and then a layer can still be solid", function()
    assert.equal(
      HEAD .. "what its tiles are is not in this export, embed it",
      show(load(newLand()))
    )
    local unknown = "where the map lies is not known: give the option folder"
    assert.equal(HEAD .. unknown, show(load(newLand("earth.lua"))))
    for text, expected in pairs({
      ["return 5"] = "is no tileset",
      ["return {}"] = "is no tileset",
      ["error('no luck')"] = "cannot read ",
      ["<set>"] = "cannot read ",
    }) do
      local folder, name = write(text)
      local entry = load(newLand(name), { folder = folder }).unsupported[1]
      assert.truthy(entry.reason:find(expected, 1, true), entry.reason)
      assert.same({ "tileset", 1, "earth", 1 }, { entry.kind, entry.id, entry.name, entry.count })
    end
    assert.equal(2, (load(newLand(), { kinds = { land = "static" } })).tiles)
    local map = newLand()
    map.layers[1].properties.solid = false
    assert.equal("", show(load(map)))
  end)
end)

describe("world:loadTiled, level.tileLayers", function()
  local tiles = {
    { id = 0, type = "earth", properties = { solid = true } },
    { id = 1, properties = { solid = true, group = "ice", friction = 0 } },
    tiled.shapes(2, { tiled.object(1, 0, 8, 16, 8), tiled.object(2, 0, 0, 8, 8) }),
  }

  it("dig and build, counted from 0 as in the editor", function()
    local map = newMap({ "....", "1111", "1111" }, { offsetx = 5 }, nil, tiles)
    local level, world = load(map, { y = 100 })
    local layer = level.tileLayers.ground
    assert.same({ 0, 0, 5, 100 }, { layer.firstColumn, layer.firstRow, layer.x, layer.y })
    assert.same({ 4, 3 }, { layer.columns, layer.rows })
    layer:setTile(1, 1, 0)
    assert.same({ "5 132 64 16", "5 116 16 16", "37 116 32 16" }, boxes(world, "ground"))
    local first = world.objects.ground[2]
    local place = first.tiled
    assert.same({ "earth", layer, 1 }, { first.type, place.tiles, place.gid })
    assert.same({ 0, 1, 1, 1 }, { place.column, place.row, place.columns, place.rows })
    layer:setTile(1, 1, 2)
    assert.same({ "21 116 16 16" }, boxes(world, "ice"))
    layer:setTile(1, 1, 3 + X) -- two rectangles, turned
    assert.same({}, boxes(world, "ice"))
    local both = { "5 132 64 16", "5 116 16 16", "37 116 32 16", "21 124 16 8", "29 116 8 8" }
    assert.same(both, boxes(world, "ground"))
    local words = "value must be a gid of one of the tilesets, got 99"
    small.refuses(words, layer.setTile, layer, 1, 1, 99)
    assert.same(both, boxes(world, "ground"))
    layer:setTile(1, 1, 1)
    assert.same({ "5 116 64 32" }, boxes(world, "ground"))
    assert.same({ 1, 1, 1 }, { layer:getTile(1, 1), layer:cellAt(21, 131.9) })
  end)

  it("are there for infinite maps, with columns below 0", function()
    local level, world = load(tiled.infinite())
    local rocks = level.tileLayers.rocks
    assert.same({ -4, 0, 1 }, { rocks.firstColumn, rocks.firstRow, rocks:getTile(-2, 0) })
    rocks:setTile(-1, 0, 0)
    assert.equal("-32 8 16 16", boxes(world, "rocks")[3])
    physics.newWorld():loadTiled(tiled.infinite())
  end)
end)
