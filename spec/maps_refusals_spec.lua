--- Calls and maps that cannot be used: what is said, that the game's own line is blamed, and that
--- nothing of a refused map is in the world.

local ldtk = require("spec.support.ldtk")
local physics = require("physics")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

local NAN, NONE = 0 / 0, {}
local SHAPES = "tilesets.1.tiles.2.objectGroup.objects.1."

--- A map with something of everything.
local function newMap()
  local set = tiled.tileset({
    { id = 0, type = "earth", properties = { solid = true, friction = 0.5 } },
    tiled.shapes(1, { tiled.object(3, 0, 0, 16, 8, { properties = { oneWay = "top" } }) }),
  })
  local line = { shape = "polyline", polyline = { { x = 0, y = 0 }, { x = 9, y = 0 } } }
  return tiled.map({ set }, {
    tiled.objects(1, "things", {
      tiled.object(5, 0, 0, 8, 8),
      tiled.object(6, 9, 0, 8, 8, { name = "crate", gid = 3, properties = { mass = 2 } }),
      tiled.object(7, 9, 0, 0, 0, line),
    }),
    tiled.group(2, "all", { tiled.tiles(3, "ground", { "12", "11" }) }),
  })
end

local function newWorld()
  local world = physics.newWorld()
  world.objects.player = { x = 0, y = 0, width = 8, height = 8 }
  world:add("ground", { x = 99, y = 0, width = 8, height = 8, static = true })
  return world
end

--- The call must be refused with this message at the line of the call, and change nothing. A text
--- that ends in "…" is only its beginning: the rest is of the Lua that runs.
local function refuses(expected, name, ...)
  local world, given = newWorld(), { ... }
  local before = small.copy(world.objects)
  local isDone, message = pcall(function()
    world[name](world, given[1], given[2], given[3], given[4], given[5])
  end)
  assert.is_false(isDone, "it was not refused: " .. expected)
  local text = message:match("maps_refusals_spec%.lua:%d+: physics: world:[^:]*: (.*)$")
  assert.truthy(text, "blames another line: " .. message)
  local start = expected:match("^(.*) …$")
  assert.equal(start or expected, start and text:sub(1, #start) or text)
  assert.same(before, world.objects)
  world:update(1 / 60)
end

--- Puts a value where a path leads: "layers.1.objects.2".
local function put(target, path, value)
  local way, last = path:match("^(.-)%.?([^.]+)$")
  for key in way:gmatch("[^.]+") do
    target = target[tonumber(key) or key]
  end
  target[tonumber(last) or last] = value ~= NONE and value or nil
end

describe("world:loadTiled refuses", function()
  small.rows("{2}", {
    { nil, "map must be a Tiled map or the path of one, got nil" },
    { 5, "map must be a Tiled map or the path of one, got 5" },
    { { tilecount = 5 }, "this is a tileset, not a map: load the map that uses it" },
    { "a.tmx", 'cannot read "a.tmx": it is XML: export the map as Lua (File > Export As), …' },
    { "a.world", 'cannot read "a.world": it is JSON: give the option decode, …' },
    {
      ("assets/"):rep(6) .. "level-7.json",
      'cannot read "...ets/assets/assets/assets/level-7.json": it is JSON: give the option …',
    },
    { ldtk.cave(), "map.layers must be a table, got nil" },
    { "none.lua", 'cannot read "none.lua": …' },
    { { type = "world" }, "a world needs the option folder: where its maps are" },
  }, function(given, words)
    refuses(words, "loadTiled", given)
  end)

  -- Where a map is damaged, by what, and what is said.
  local C, G = 'layer "things", object 6 "crate": ', 'layer "ground": '
  local tile, data =
    G .. "the cell at column 1, row 0 must be a gid, got ", "layers.2.layers.1.data"
  small.rows("{3}", {
    { "tilewidth", -1, "map.tilewidth must be a number >= 0, got -1" },
    { "tilesets.1.firstgid", "a", "the map is damaged: …" },
    { "layers.1", 5, "layers[1] must be a table, got 5" },
    { "layers.1.name", NONE, "the name of a layer must be a string, got nil" },
    { data .. ".4", NONE, G .. "#data must be an integer in 4..4, got 3" },
    { data, NONE, G .. "data must be a table, got nil" },
    { "layers.2.layers.1.width", 3, G .. "#data must be an integer in 6..6, got 4" },
    { data .. ".2", 17, tile:gsub("gid,", "gid of one of the tilesets,") .. "17" },
    { data .. ".2", -1, tile .. "-1" },
    {
      "layers.2.layers.1.chunks",
      { { x = 0, y = 0.5, width = 1, height = 1, data = { 1 } } },
      'layer "ground", chunk 1: y must be an integer in -1000000..1000000, got 0.5',
    },
    {
      "layers.2.layers.1.chunks",
      { { x = 0, y = 0, width = 2, height = 1, data = { 1 } } },
      'layer "ground", chunk 1: #data must be an integer in 2..2, got 1',
    },
    { "layers.2.properties", 5, 'layer "all": properties must be a table, got 5' },
    { "layers.2.properties", { "solid" }, 'layer "all": properties must have strings as …' },
    { SHAPES .. "width", NONE, G .. "the map is damaged: …" },
    { "layers.1.objects.2", "crate", 'layer "things", object nil: the map is damaged: …' },
    { "layers.1.objects.1.x", NAN, 'layer "things", object 5: x must be a number, got nan' },
    { "layers.1.objects.2.width", -1, C .. "width must be a number > 0, got -1" },
    { "layers.1.objects.2.gid", 99, C .. "gid must be a gid of one of the tilesets, got 99" },
    {
      "layers.1.objects.2.properties",
      { vx = "a", ax = "b", mass = "c" }, -- the first by name
      C .. 'ax must be a number, got "b"',
    },
    { "layers.1.objects.3.polyline.1", { x = 1 }, 'layer "things", object 7: the map is …' },
    { "layers.1.name", "player", "objects.player is not a group, got an object" },
  }, function(path, value, words)
    local map = newMap()
    put(map, path, value)
    refuses(words, "loadTiled", map, { strict = true })
  end)

  it("sizes that would take for ever, and reads no polygon with a thousand corners", function()
    local map = tiled.sti(newMap())
    map.layers[2].width = 1e9
    local expected = 'layer "all.ground": width * height must be an integer in 0..10000000, …'
    refuses(expected, "loadTiled", map)
    local corners = {}
    for i = 1, 1000 do
      corners[i] = { x = i % 2 * 16, y = i }
    end
    map = newMap()
    map.layers[1].objects[1].shape, map.layers[1].objects[1].polygon = "polygon", corners
    local level = newWorld():loadTiled(map)
    assert.equal("polygon: it has more than 500 corners", level.unsupported[1].reason)
  end)

  it("layers and properties that hold themselves, and goes on", function()
    local map = newMap()
    map.layers[2].layers[2] = map.layers[2]
    refuses("the map is damaged: stack overflow …", "loadTiled", map)
    map = newMap()
    map.layers[1].objects[1].properties.own = map
    map.properties.map = map
    local damaged = 'layer "things", object 5: the map is damaged: stack overflow …'
    refuses(damaged, "loadTiled", map)
  end)

  local names = 'they are "things", "all", "ground"'
  small.rows("the option: {2}", {
    { 5, "options must be a table, got 5" },
    { { skipLayer = {} }, 'unknown option "skipLayer" (did you mean "skipLayers"?); the …' },
    { { solidLayers = {} }, 'unknown option "solidLayers"; the options are …' },
    { { merge = 1 }, "merge must be true or false, got 1" },
    { { x = NAN }, "x must be a number, got nan" },
    { { solidProperty = true }, "solidProperty must be a name, got true" },
    { { kinds = { Crate = "box" } }, 'kinds.Crate must be "static", "dynamic", "kinematic" …' },
    { { ellipses = "oval" }, 'ellipses must be "box" or "circle", got "oval"' },
    { { ignore = "wall" }, 'ignore must be a list of names, got "wall"' },
    { { decode = "json" }, 'decode must be a function, got "json"' },
    { { ignore = { 5 } }, "ignore[1] must be a name, got 5" },
    { { onlyLayers = "things" }, 'onlyLayers must be a list of layer names, got "things"' },
    { { onlyLayers = { "a" } }, 'onlyLayers[1] must be a layer of the map, got "a"; ' .. names },
    { { skipLayers = { true } }, "skipLayers[1] must be a layer's name, got true" },
    { { skipLayers = { 9 } }, "skipLayers[1] must be a layer of the map, got 9; " .. names },
  }, function(options, words)
    refuses(words, "loadTiled", newMap(), options)
  end)

  it("a file that fails, that returns no map, or that asks for globals", function()
    local path = os.tmpname()
    for text, expected in pairs({
      ["<map>"] = "cannot read …",
      ["error('no luck')"] = "cannot read …",
      ["return os.exit(1)"] = "cannot read …",
      ["return 5"] = ("what %q returns must be a table, got 5"):format(path),
    }) do
      local file = assert(io.open(path, "w"))
      file:write(text)
      file:close()
      refuses(expected, "loadTiled", path)
    end
    os.remove(path)
  end)

  it("a world of which one map cannot be read: none of them is there", function()
    local maps =
      { { fileName = "course.tmx", x = 0, y = 0 }, { fileName = "none.tmx", x = 9, y = 0 } }
    local given = { type = "world", maps = maps }
    refuses('cannot read "spec/maps/none.lua": …', "loadTiled", given, { folder = "spec/maps" })
    maps[2].x = "here"
    refuses("the map is damaged: …", "loadTiled", given, { folder = "spec/maps" })
  end)
end)

describe("world:loadLDtk refuses", function()
  local levels = "level must be the identifier, iid or number of a level, got %s; they are"
  small.rows("{3}", {
    { nil, nil, "project must be a table, got nil" },
    { "a.ldtk", nil, 'project must be a table, got "a.ldtk"' },
    { {}, nil, "project.levels must be a table, got nil" },
    { ldtk.cave(), "Attic", levels:format('"Attic"') .. ' "Cave", "Top"' },
    { ldtk.cave(), 3, levels:format("3") .. ' "Cave", "Top"' },
    { ldtk.cave(), {}, "level.layerInstances must be a table, got nil" },
  }, function(project, level, words)
    refuses(words, "loadLDtk", project, level)
  end)

  local C, E = 'layer "Collisions": ', 'layer "Entities", entity "Start": '
  local entity = "layerInstances.1.entityInstances.1"
  small.rows("{1}: {3}", {
    { "pxWid", 0, "level.pxWid must be a number > 0, got 0" },
    { "layerInstances.2.__pxTotalOffsetX", NAN, C .. "the right edge must be a number, got nan" },
    { "layerInstances.2.__gridSize", 0, C .. "width must be a number > 0, got 0" },
    { "layerInstances.2.intGridCsv", {}, C .. "#intGridCsv must be an integer in …" },
    { "layerInstances.2.intGridCsv.4", -1, C .. "the cell at column 3, row 0 must be 0 or …" },
    { "layerInstances.1.entityInstances", NONE, 'layer "Entities": the map is damaged: …' },
    { entity .. ".width", 0, E .. "width must be a number > 0, got 0" },
    { entity .. ".px", NONE, E .. "the map is damaged: …" },
  }, function(path, value, words)
    local project = ldtk.cave()
    put(project.levels[1], path, value)
    refuses(words, "loadLDtk", project, nil, { strict = true })
  end)

  small.rows("the option: {2}", {
    { { sold = {} }, 'unknown option "sold" (did you mean "solid"?); the options are …' },
    { { solid = { dirt = 5 } }, 'solid["dirt"] must be true, false or a table of fields, got 5' },
    { { solid = { dirt = { mass = -1 } } }, 'solid["dirt"]: mass must be a number > 0, got -1' },
    {
      { solid = { dirtt = true } },
      'a key of solid must be a value of an IntGrid layer, got "dirtt"; …',
    },
    { { groups = { Player = true } }, 'layer "Entities", entity "Player": group must be a …' },
    { { onlyLayers = { "Wall" } }, 'onlyLayers[1] must be a layer of the level, got "Wall"; …' },
    { { kinds = { Player = 5 } }, 'kinds.Player must be "static", "dynamic", "kinematic" or …' },
  }, function(options, words)
    refuses(words, "loadLDtk", ldtk.cave(), nil, options)
  end)

  it("a level in another file, unless readLevel brings it", function()
    local project = ldtk.cave()
    local layers = project.levels[1].layerInstances
    project.levels[1].layerInstances = nil
    project.levels[1].externalRelPath = "world/Cave.ldtkl"
    local expected = 'level "Cave" is in world/Cave.ldtkl: decode it and give that, or the option '
      .. "readLevel"
    refuses(expected, "loadLDtk", project)
    refuses(expected, "loadLDtk", project, nil, { readLevel = function() end })
    local options = {
      readLevel = function(path)
        assert.equal("world/Cave.ldtkl", path)
        project.levels[1].layerInstances = layers
        return project.levels[1]
      end,
    }
    assert.truthy(newWorld():loadLDtk(project, nil, options).named.Player)
  end)
end)

describe("world:addTiles refuses", function()
  local columns = "columns must be an integer in 1..1000000, got "
  small.rows("{2}", {
    { { true, {}, 1, 10 }, "group must be a string or a number, got true" },
    { { "tiles", 5, 1, 10 }, "cells must be a table, got 5" },
    { { "tiles", { 1 }, nil, 10 }, columns .. "nil" },
    { { "tiles", { { 1 } }, "1", 10 }, columns .. '"1"' },
    {
      { "tiles", { 1, 2, 3 }, 2, 10 },
      "#cells / columns must be an integer in 0..1000000, got 1.5",
    },
    { { "tiles", { { 1, 2 } }, 1, 10 }, "#cells[1] must be an integer in 0..1, got 2" },
    { { "tiles", { { 1 }, 5 }, 1, 10 }, "cells[2] must be a row, got 5" },
    { { "tiles", { 1, {} }, 2, 10 }, "the cell at column 2, row 1 must …" },
    { { "tiles", { 1 }, 1 }, "size must be a number > 0, got nil" },
    { { "tiles", { 1 }, 1, { 5 } }, "size[2] must be a number > 0, got nil" },
    {
      { "tiles", { 1, 1 }, 1, { 1e60, 1e99 }, { y = 1e100, merge = false } },
      "the lower edge must be a number in -1e+100..1e+100, got 1.2e+100",
    },
    { { "player", { 1 }, 1, 5 }, "objects.player is not a group, got an object" },
  }, function(given, words)
    refuses(words, "addTiles", given[1], given[2], given[3], given[4], given[5])
  end)

  local wrong = { a = { mass = -1 }, [3] = true }
  small.rows("the option: {2}", {
    { 5, "options must be a table, got 5" },
    { { sold = {} }, 'unknown option "sold" (did you mean "solid"?); …' },
    { { solid = { [1] = 5 } }, "solid[1] must be true, false or a …" },
    { { solid = { [{}] = true } }, "solid must have values of cells …" },
    { { solid = wrong }, 'solid["a"]: mass must be a number > 0, got -1' },
    { { solid = { [1] = { group = "player" } } }, "objects.player is …" },
    { { fields = { width = 5 } }, "fields: width must be nil: place …" },
    { { fields = { solid = "x" } }, "fields: solid must be true or …" },
  }, function(options, words)
    refuses(words, "addTiles", "tiles", { 1 }, 1, 5, options)
  end)

  it("what cannot be done with tiles", function()
    local world = newWorld()
    local tiles = world:addTiles("tiles", { "##" }, nil, 16)
    local set = "setTile(column, row, value): "
    for expected, call in pairs({
      [set .. "column must be an integer in 1..2, got 3"] = { "setTile", tiles, 3, 1, 0 },
      [set .. "row must be an integer in 1..1, got nil"] = { "setTile", tiles, 1 },
      ["cellAt(x, y): y must be a number, got nil"] = { "cellAt", tiles, 1 },
      ["load() must be called with a colon on tiles, got nil"] = { "load" },
      ["getTile(column, row) must be called with a colon on tiles, got 1"] = { "getTile", 1, 1 },
    }) do
      small.refuses("tiles:" .. expected, tiles[call[1]], call[2], call[3], call[4], call[5])
    end
    assert.equal(1, #world.objects.tiles)
  end)

  it("to be called from inside canCollide, as the others do", function()
    local world, messages = newWorld(), {}
    world:add("boxes", { x = 99, y = -8, width = 8, height = 8, vy = 90 }).canCollide = function()
      for _, call in ipairs({
        { "addTiles", "more", { "#" }, nil, 16 },
        { "loadTiled", newMap() },
        { "loadLDtk", ldtk.cave() },
      }) do
        local _, message = pcall(world[call[1]], world, call[2], call[3], call[4], call[5])
        messages[#messages + 1] = message
      end
      return true
    end
    small.run(world, 9)
    assert.is_true(#messages >= 3)
    assert.is_nil(world.objects.more or world.objects.Player or world.objects.all)
  end)
end)
