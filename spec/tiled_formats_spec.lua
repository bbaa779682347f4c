--- The forms in which Tiled writes things: packed layers, tilesets in files of their own, points,
--- turned shapes, polygons and lines, tiles in which to dig.

local physics = require("physics")
local tiled = require("spec.support.tiled")

local load, boxes = tiled.load, tiled.boxes

local function reasonsOf(level)
  local list = {}
  for i, part in ipairs(level.unsupported) do
    list[i] = part.reason
  end
  return list
end

local function fails(expected, map, options)
  local isDone, message = pcall(function()
    physics.newWorld():loadTiled(map, options)
  end)
  assert.is_false(isDone, "it was not refused: " .. expected)
  local text = message:match("tiled_formats_spec%.lua:%d+: physics: (.*)$")
  assert.equal("world:loadTiled(map): " .. expected, text, message)
end

-- What a spec may put there for a while.
local loveBefore

local function pretend(love)
  rawset(_G, "love", love)
end

local function keepGlobals()
  loveBefore = rawget(_G, "love")
end

local function restoreGlobals()
  rawset(_G, "love", loveBefore)
end

-- Packed layers -----------------------------------------------------------------------------------

local CSV = "choose CSV as Tile Layer Format in the map's properties"

describe("world:loadTiled, packed layers", function()
  local PLAIN = dofile("spec/maps/packed_plain.lua")
  local RAW -- the bytes of the layer

  local function packed(compression)
    local map = tiled.copy(PLAIN)
    map.layers[1].compression = compression
    return map
  end

  --- An unpacker: knows the bytes of the fixture, which are packed in name only.
  local function unpacker(log)
    return function(data, compression)
      log[#log + 1] = compression
      return data == RAW and RAW or nil
    end
  end

  before_each(function()
    keepGlobals()
    -- The bytes come from the library itself: a map that says it is compressed, but is not.
    local map = tiled.copy(PLAIN)
    map.layers[1].compression = "none of these"
    physics.newWorld():loadTiled(map, {
      decompress = function(data)
        RAW = data
        return data
      end,
    })
  end)

  after_each(restoreGlobals)

  it("in base64 are read by themselves", function()
    assert.equal(4 * 24 * 12, #RAW)
    local level, world = load(PLAIN)
    assert.same({ 93, 9 }, { level.tiles, level.rectangles })
    assert.equal("top", world.objects.collision[#world.objects.collision].oneWay)
    local flipped = level.tileLayers.collision:getTile(5, 10)
    assert.equal(2147483649, flipped)
    assert.is_string(PLAIN.layers[1].data) -- the map is as it was
    -- 65537 is 01 00 01 00
    local set = tiled.tileset({ { id = 0, properties = { solid = true } } }, { firstgid = 65537 })
    local layer = tiled.tiles(1, "land", { "." }, { encoding = "base64" })
    layer.data = "AQABAA=="
    assert.equal(1, (load(tiled.map({ set }, { layer }))).tiles)
  end)

  for _, compression in ipairs({ "zlib", "gzip" }) do
    it("with " .. compression .. " are unpacked by the option decompress, or by LÖVE", function()
      local log = {}
      local level, world = load(packed(compression), { decompress = unpacker(log) })
      local _, plain = load(PLAIN)
      assert.same({ compression }, log)
      assert.same(boxes(plain, "collision"), boxes(world, "collision"))
      assert.same({}, level.unsupported)
      log = {}
      local unpack = unpacker(log)
      pretend({
        data = {
          decompress = function(container, format, data)
            assert.equal("string", container)
            return unpack(data, format)
          end,
        },
      })
      assert.equal(93, (load(packed(compression))).tiles)
      assert.same({ compression }, log)
    end)
  end

  it("are named with what to do if nothing here can unpack them", function()
    local neither = "LÖVE is not here to unpack it, and there is no option decompress"
    for _, compression in ipairs({ "zlib", "gzip" }) do
      local level, world = load(packed(compression))
      local expected = ("encoded data (%s, base64): %s; %s"):format(compression, neither, CSV)
      assert.same({ expected }, reasonsOf(level))
      local part = level.unsupported[1]
      assert.same({ "layer", "collision", 1 }, { part.kind, part.layer, part.id })
      assert.is_nil(world.objects.collision)
    end
  end)

  it("of an infinite map are parts", function()
    local map = tiled.copy(PLAIN)
    local layer = map.layers[1]
    local part = { x = -24, y = 0, width = 24, height = 12, data = layer.data }
    layer.chunks = { part, { x = 0, y = 0, width = 24, height = 12, data = layer.data } }
    layer.data = nil
    assert.equal(186, (load(map)).tiles)
  end)

  describe("are refused:", function()
    local function with(data, compression)
      local map = tiled.copy(PLAIN)
      map.layers[1].data, map.layers[1].compression = data, compression
      return map
    end

    it("what is no base64", function()
      local where = 'layer "collision": data must be base64, got '
      fails(where .. '"AAA"', with("AAA"))
      fails(where .. '"AA$="', with("AA$="))
    end)

    it("data of another length", function()
      fails('layer "collision": data must hold 288 gids (24 x 12), got 0', with(""))
    end)

    it("damaged data", function()
      local map = with(packed("zlib").layers[1].data, "zlib")
      local damaged = 'layer "collision": data cannot be unpacked (zlib): it is damaged'
      pretend({
        data = {
          decompress = function()
            error("Could not decompress zlib-compressed data.")
          end,
        },
      })
      fails(damaged, map)
      local options = {
        decompress = function()
          return 5
        end,
      }
      fails(damaged, map, options)
    end)

    it("gids that no tileset has", function()
      fails(
        'layer "collision": the cell at column 0, row 0 must be a gid of one of the tilesets,'
          .. " got 9999",
        with((PLAIN.layers[1].data:gsub("^AQAAAAAA", "DycAAAAA")))
      )
    end)

    it("another encoding is only named", function()
      local map = with("1,2,3")
      map.layers[1].encoding = "csv"
      assert.same({ "encoded data (csv): " .. CSV }, reasonsOf(load(map)))
    end)
  end)
end)

-- Tilesets ----------------------------------------------------------------------------------------

describe("world:loadTiled, tilesets in files of their own", function()
  local folder, files

  before_each(function()
    keepGlobals()
    folder, files = os.tmpname(), {}
    os.remove(folder)
    folder = folder .. "_"
  end)

  after_each(function()
    restoreGlobals()
    for _, path in ipairs(files) do
      os.remove(path)
    end
  end)

  --- Writes a Lua file into the folder (which is the beginning of its name) and returns its path.
  local function write(name, text)
    local path = folder .. name
    local file = assert(io.open(path, "wb"))
    file:write(text)
    file:close()
    files[#files + 1] = path
    return path
  end

  local SET =
    [[return { name = "earth", tilewidth = 16, tileheight = 16, tilecount = 4, columns = 4,
    tiles = { { id = 1, type = "rock", properties = { solid = true } } } }]]

  -- A map with such a tileset; `name` is that of its file, the end of a path.
  local function newMap(exportName)
    return tiled.map(
      { { name = "earth", firstgid = 1, filename = "earth.tsx", exportfilename = exportName } },
      { tiled.tiles(1, "land", { "12." }) }
    )
  end

  it("are read from exportfilename, beside the map", function()
    local path = write("earth.lua", SET)
    local map = newMap(path:match("[^/]+$"))
    local level = load(map, { folder = path:match("^(.*)/") })
    assert.equal(1, level.tiles)
    assert.equal("rock", level.objects[1].type)
    assert.same({}, level.unsupported)
    assert.is_nil(map.tilesets[1].tilewidth) -- the map is as it was
  end)

  it("are read from where a map by path lies", function()
    local path = write("earth.lua", SET)
    local name = path:match("[^/]+$")
    local text = [[return { orientation = "orthogonal", width = 2, height = 1, tilewidth = 16,
      tileheight = 16, tilesets = { { firstgid = 1, filename = "e.tsx", exportfilename = "%s" } },
      layers = { { type = "tilelayer", id = 1, name = "land", width = 2, height = 1,
      data = { 1, 2 } } } }]]
    for _, way in ipairs({ name, "./" .. name, "nowhere/../" .. name }) do
      local map = write("map.lua", text:format(way))
      assert.equal(1, (load(map)).tiles)
    end
  end)

  it("are looked for by love.filesystem without any ..", function()
    local asked = {}
    pretend({
      filesystem = {
        getInfo = function(path)
          asked[#asked + 1] = path
          return path == "sets/earth.lua" and {} or nil
        end,
        load = function()
          return (rawget(_G, "loadstring") or rawget(_G, "load"))(SET)
        end,
      },
    })
    assert.equal(1, (load(newMap("../sets/earth.lua"), { folder = "maps" })).tiles)
    assert.equal(1, (load(newMap("earth.lua"), { folder = "sets" })).tiles)
    load(newMap("../earth.lua"), { folder = "" })
    assert.same({ "sets/earth.lua", "sets/earth.lua", "../earth.lua" }, asked)
  end)

  it("are named if they cannot be had, and then a layer can still be solid", function()
    local head = 'external ("earth.tsx"): '
    local function reason(map, options)
      local level = load(map, options)
      local part = level.unsupported[1]
      assert.same({ "tileset", 1, "earth" }, { part.kind, part.id, part.name })
      assert.equal(1, #level.unsupported)
      return part.reason
    end
    assert.equal(head .. "what its tiles are is not in this export, embed it", reason(newMap()))
    assert.equal(
      head .. "where the map lies is not known: give the option folder",
      reason(newMap("earth.lua"))
    )
    local place = { folder = folder:match("^(.*)/") }
    assert.truthy(reason(newMap("nothing%s.lua"), place):find(head .. "cannot read ", 1, true))
    local name = write("bad.lua", "return 5"):match("[^/]+$")
    assert.truthy(reason(newMap(name), place):find('bad.lua" is no tileset', 1, true))
    local broken = write("broken.lua", "error('no luck')"):match("[^/]+$")
    assert.truthy(reason(newMap(broken), place):find("broken.lua", 1, true))
    assert.equal(2, (load(newMap(), { solidLayers = { "land" } })).tiles)
  end)
end)

-- Points and lines --------------------------------------------------------------------------------

describe("world:loadTiled, points and lines", function()
  local function newMap(objects, extra)
    return tiled.map({ tiled.tileset() }, { tiled.objects(4, "marks", objects, extra) })
  end

  it("are in level.points and level.named", function()
    local map = newMap({
      tiled.object(1, 30, 40, 0, 0, { shape = "point", name = "player", type = "spawn" }),
      tiled.object(
        2,
        50,
        60,
        0,
        0,
        { name = "player", properties = { facing = "left", vx = "5" } }
      ),
      tiled.object(3, 1, 2, 0, 0, { shape = "point" }),
    }, { offsetx = 100 })
    local level, world = load(map, { y = 1000 })
    assert.same({ 3, 0, 0 }, { #level.points, #level.objects, #level.unsupported })
    local first, second, third = level.points[1], level.points[2], level.points[3]
    assert.same({ 130, 1040, "player", "spawn" }, { first.x, first.y, first.name, first.type })
    assert.same({ 150, 1060, "left", 5 }, { second.x, second.y, second.facing, second.vx })
    assert.is_nil(third.name)
    assert.equal(first, level.named.player)
    assert.equal(map.layers[1].objects[1], first.tiled.object)
    assert.equal(map.layers[1], first.tiled.layer)
    assert.same({}, world.objects.marks)
    world:add("players", { x = first.x, y = first.y, width = 8, height = 8 })
  end)

  it("of which a size is missing on one side only are named", function()
    local level =
      load(newMap({ tiled.object(1, 0, 0, 8, 0), tiled.object(2, 0, 0, 0, 8, { gid = 1 }) }))
    assert.same({ "it has no size" }, reasonsOf(level))
    assert.equal(2, level.unsupported[1].count)
  end)

  --- A path of a lift:    o--+
  ---                         |
  ---                         +
  for _, row in ipairs({
    { 0, { 10, 20, 40, 20, 40, 60 } },
    { 90, { 10, 20, 10, 50, -30, 50 } },
  }) do
    it("are lines with all their corners, turned by " .. row[1], function()
      local object = tiled.object(9, 10, 20, 0, 0, {
        shape = "polyline",
        name = "path",
        rotation = row[1],
        polyline = { { x = 0, y = 0 }, { x = 30, y = 0 }, { x = 30, y = 40 } },
        properties = { period = 4 },
      })
      for _, isSti in ipairs({ false, true }) do
        local map = newMap({ object }, { offsetx = 100 })
        local level = load(isSti and tiled.sti(map) or map)
        local line = level.lines[1]
        for i, point in ipairs(line.points) do
          assert.near(row[2][2 * i - 1] + 100, point.x, 1e-9)
          assert.near(row[2][2 * i], point.y, 1e-9)
        end
        assert.same(
          { 3, 4, "path", 110, 20 },
          { #line.points, line.period, line.name, line.x, line.y }
        )
        assert.equal(line, level.named.path)
        assert.same({}, level.unsupported)
      end
    end)
  end
end)

-- Turned shapes -----------------------------------------------------------------------------------

describe("world:loadTiled, turned", function()
  local function newMap(object, set)
    return tiled.map({ set or tiled.tileset() }, { tiled.objects(1, "things", { object }) })
  end

  --- A rectangle of 30 x 10 px turns about its upper left corner, which stays at 100, 200.
  for _, row in ipairs({
    { 90, "90 200 10 30" },
    { 180, "70 190 30 10" },
    { 270, "100 170 10 30" },
    { -90, "100 170 10 30" },
    { 89.99999, "90 200 10 30" },
  }) do
    it(("rectangles are boxes, by %g degrees"):format(row[1]), function()
      local level, world = load(newMap(tiled.object(1, 100, 200, 30, 10, { rotation = row[1] })))
      assert.same({ row[2] }, boxes(world, "things"))
      assert.same({}, level.unsupported)
    end)

    it(("tile objects are boxes, by %g degrees"):format(row[1]), function()
      -- It stands on its point: unturned at 100 190 30 10.
      local expected = {
        ["100 200 30 10"] = "100 190 30 10",
        ["90 200 10 30"] = "100 200 10 30",
        ["70 190 30 10"] = "70 200 30 10",
        ["100 170 10 30"] = "90 170 10 30",
      }
      local object = tiled.object(1, 100, 200, 30, 10, { rotation = row[1], gid = 1, name = "a" })
      local _, world = load(newMap(object))
      assert.same({ expected[row[2]] }, boxes(world, "things"))
    end)
  end

  it("tile objects turn with the rectangle of their tile", function()
    -- The lower half of a tile of 16 px; turned clockwise it is the left half.
    local set = tiled.tileset({ tiled.shapes(0, { tiled.object(1, 0, 8, 16, 8) }) })
    local object = tiled.object(1, 100, 200, 16, 16, { rotation = 90, gid = 1 })
    local _, world = load(newMap(object, set))
    assert.same({ "100 200 8 16" }, boxes(world, "things"))
  end)

  it("shapes of tiles are boxes, too", function()
    local set =
      tiled.tileset({ tiled.shapes(0, { tiled.object(1, 16, 0, 4, 16, { rotation = 90 }) }) })
    local _, world = load(tiled.map({ set }, { tiled.tiles(1, "land", { ".11" }) }))
    assert.same({ "16 0 32 4" }, boxes(world, "land"))
  end)
end)

describe("world:loadTiled, polygons", function()
  -- "0,0 40,0 40,10"
  local function points(text)
    local polygon = {}
    for x, y in text:gmatch("(%S+),(%S+)") do
      polygon[#polygon + 1] = { x = tonumber(x), y = tonumber(y) }
    end
    return polygon
  end

  local function newMap(text, extra)
    local object = tiled.object(1, 100, 200, 0, 0, extra)
    object.shape, object.polygon = "polygon", points(text)
    return tiled.map({ tiled.tileset() }, { tiled.objects(1, "walls", { object }) })
  end

  -- "x y width height slope" of each part, from the place of the polygon; or what is said of it.
  local function partsOf(level)
    local parts = reasonsOf(level)
    for _, part in ipairs(level.objects) do
      local text = ("%g %g %g %g %s"):format(
        part.x - 100,
        part.y - 200,
        part.width,
        part.height,
        part.slope or "-"
      )
      parts[#parts + 1] = text:gsub(" %-$", "")
    end
    return table.concat(parts, ", ")
  end

  for _, row in ipairs({
    { "a rectangle", "0,0 40,0 40,10 0,10", "0 0 40 10" },
    { "the other way round", "0,0 0,10 40,10 40,0", "0 0 40 10" },
    { "closed by its first corner", "0,0 40,0 40,10 0,10 0,0", "0 0 40 10" },
    { "by a hand that trembles", "0,0 40,0.004 39.998,10 0,10.001", "0 0 40 10" },
    { "an L", "0,0 10,0 10,20 30,20 30,30 0,30", "0 0 10 20, 0 20 30 10" },
    { "a U", "0,0 10,0 10,20 20,20 20,0 30,0 30,30 0,30", "0 0 10 20, 20 0 10 20, 0 20 30 10" },
    { "a stair", "0,0 10,0 10,10 20,10 20,20 0,20", "0 0 10 10, 0 10 20 10" },
    { "a triangle, high on the right", "0,16 32,0 32,16", "0 0 32 16 right" },
    { "a triangle, high on the left", "32,16 0,0 0,16", "0 0 32 16 left" },
    { "a triangle that hangs on the left", "0,0 0,16 32,0", "0 0 32 16 topleft" },
    { "a ramp on a box", "0,0 16,4 16,16 0,16", "0 0 16 4 left, 0 4 16 12" },
    { "a ramp below a box", "0,0 16,0 16,16 0,12", "0 0 16 12, 0 12 16 4 topright" },
    { "an overhang", "0,0 20,0 12,16 0,16", "12 0 8 16 topleft, 0 0 12 16" },
    { "a roof", "0,16 8,0 24,16", "0 0 8 16 right, 8 0 16 16 left" },
    { "a leaf", "0,0 16,4 16,16 0,12", "0 0 16 4 left, 0 4 16 8, 0 12 16 4 topright" },
    {
      "one that crosses itself",
      "0,0 16,16 0,16 16,0",
      "polygon: it has thin parts that are no boxes, nor slopes",
    },
    { "one without area", "0,0 16,0 0,0", "polygon: it has no area" },
  }) do
    it("are boxes and slopes: " .. row[1], function()
      for _, map in ipairs({ newMap(row[2]), tiled.sti(newMap(row[2])) }) do
        assert.equal(row[3], partsOf(load(map)))
      end
    end)
  end

  it("are boxes when they are turned by quarters, through STI, too", function()
    local map = newMap("0,0 40,0 40,10 0,10", { rotation = 90 })
    map.layers[1].offsetx = 7
    for _, given in ipairs({ map, tiled.sti(map) }) do
      local box = load(given).objects[1]
      for i, value in ipairs({ 97, 200, 10, 40 }) do
        assert.near(value, ({ box.x, box.y, box.width, box.height })[i], 1e-9)
      end
    end
  end)

  it("are slopes that flip and turn with their tiles", function()
    local shape = tiled.object(5, 0, 16, 0, 0)
    shape.shape, shape.polygon = "polygon", points("0,0 0,-16 16,0")
    local set = tiled.tileset({ tiled.shapes(0, { shape }) })
    local X, Y, T = 2 ^ 31, 2 ^ 30, 2 ^ 29
    local layer = tiled.tiles(1, "walls", { "11111111" })
    layer.data = { 1, 1 + X, 1 + Y, 1 + X + Y, 1 + T, 1 + T + X, 1 + T + Y, 1 + T + X + Y }
    local _, world = load(tiled.map({ set }, { layer }))
    table.sort(world.objects.walls, function(a, b)
      return a.x < b.x
    end)
    local found = {}
    for i, object in ipairs(world.objects.walls) do
      found[i] = object.slope
    end
    assert.same(
      { "left", "right", "topleft", "topright", "topright", "topleft", "right", "left" },
      found
    )
  end)

  it("of several boxes move only together, that is not at all", function()
    local map = newMap("0,0 10,0 10,20 30,20 30,30 0,30")
    map.layers[1].objects[1].properties = { static = false }
    assert.same({ "polygon of 2 boxes: only static ones hold together" }, reasonsOf(load(map)))
    map = newMap("0,0 40,0 40,10 0,10")
    map.layers[1].objects[1].properties = { static = false }
    assert.is_false(load(map).objects[1].static)
  end)

  it("capsules, ellipses, texts and what is turned are named", function()
    for shape, reason in pairs({
      ["polyline, turned"] = "rotated by 45 degrees: boxes do not turn",
      ["rectangle, turned"] = "rotated by 45 degrees: boxes do not turn",
      ["polygon, turned"] = "rotated by 45 degrees: boxes do not turn",
      capsule = "capsule: only rectangles are boxes",
      ellipse = 'ellipse: only circles are round; the option ellipses = "box" makes it a box',
      text = "text: only rectangles are boxes",
    }) do
      local object = tiled.object(1, 0, 0, 16, 32, { shape = shape:match("%a+") })
      object.polyline, object.polygon = {}, points("0,0 40,0 40,10 0,10")
      object.rotation = shape:find("turned") and 45 or 0
      local map = tiled.map({ tiled.tileset() }, { tiled.objects(1, "things", { object }) })
      assert.same({ reason }, reasonsOf(load(map)))
    end
  end)

  it("ellipses that are circles are round as shapes of tiles, too", function()
    local shape = tiled.object(5, 2, 4, 8, 8, { shape = "ellipse" })
    local long = tiled.object(6, 0, 0, 8, 16, { shape = "ellipse" })
    local set = tiled.tileset({ tiled.shapes(0, { shape }), tiled.shapes(1, { long }) })
    local level, world = load(tiled.map({ set }, { tiled.tiles(1, "land", { "11", "2." }) }))
    assert.same({ "2 4 8 8", "18 4 8 8" }, boxes(world, "land"))
    assert.same({ 4, true }, { world.objects.land[1].radius, world.objects.land[1].static })
    assert.equal(1, #level.unsupported)
    world:add("balls", { x = 4, y = -20, radius = 2 })
    for _ = 1, 60 do
      world:update(1 / 60)
    end
    assert.near(0, world.objects.balls[1].y, 1e-6) -- on top of the circle
  end)
end)

-- Digging -----------------------------------------------------------------------------------------

describe("world:loadTiled, level.tileLayers", function()
  local function newMap()
    local set = tiled.tileset({
      { id = 0, type = "earth", properties = { solid = true } },
      { id = 1, properties = { solid = true, group = "ice", friction = 0 } },
      tiled.shapes(2, { tiled.object(1, 0, 8, 16, 8), tiled.object(2, 0, 0, 8, 8) }),
    })
    return tiled.map(
      { set },
      { tiled.tiles(1, "land", { "....", "1111", "1111" }, { offsetx = 5 }) }
    )
  end

  it("dig and build, counted from 0 as in the editor", function()
    local level, world = load(newMap(), { y = 100 })
    local tiles = level.tileLayers.land
    assert.same({ 0, 0, 5, 100 }, { tiles.firstColumn, tiles.firstRow, tiles.x, tiles.y })
    assert.same({ 4, 3 }, { tiles.columns, tiles.rows })
    assert.equal(tiles, world.objects.land[1].tiled.tiles)
    tiles:setTile(1, 1, 0)
    assert.same({ "5 116 16 16", "37 116 32 16", "5 132 64 16" }, boxes(world, "land"))
    assert.equal("earth", world.objects.land[1].type)
    assert.equal(1, world.objects.land[1].tiled.gid)
    local place = world.objects.land[1].tiled
    assert.same({ 0, 1, 1, 1 }, { place.column, place.row, place.columns, place.rows })
    tiles:setTile(1, 1, 2)
    assert.same({ "21 116 16 16" }, boxes(world, "ice"))
    tiles:setTile(1, 1, 3 + tiled.FLIP_X) -- two rectangles, turned
    assert.same({}, boxes(world, "ice"))
    assert.same({
      "5 116 16 16",
      "37 116 32 16",
      "5 132 64 16",
      "21 124 16 8",
      "29 116 8 8",
    }, boxes(world, "land"))
    tiles:setTile(1, 1, 1)
    assert.same({ "5 116 64 32" }, boxes(world, "land"))
    assert.equal(1, tiles:getTile(1, 1))
    assert.same({ 1, 1 }, { tiles:cellAt(21, 131.9) })
  end)

  it("refuse what no tileset has", function()
    local level, world = load(newMap())
    local isDone, message = pcall(function()
      level.tileLayers.land:setTile(1, 1, 99)
    end)
    assert.is_false(isDone)
    local expected = "value must be a gid of one of the tilesets, got 99"
    assert.truthy(message:find(expected, 1, true), message)
    assert.same({ "5 16 64 32" }, boxes(world, "land"))
  end)

  it("are there for infinite maps, with columns below 0", function()
    local level, world = load(tiled.infinite())
    local tiles = level.tileLayers.rocks
    assert.same({ -4, 0 }, { tiles.firstColumn, tiles.firstRow })
    assert.equal(1, tiles:getTile(-2, 0))
    tiles:setTile(-1, 0, 0)
    assert.equal("-32 8 16 16", boxes(world, "rocks")[3])
  end)
end)
