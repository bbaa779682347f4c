--- Maps that cannot be used: what is said, that the game's own line is blamed, and that nothing of
--- a refused map is in the world.

local physics = require("physics")
local tiled = require("spec.support.tiled")

local NAN = 0 / 0

--- A map with something of everything.
local function newMap()
  local set = tiled.tileset({
    { id = 0, type = "earth", properties = { solid = true, friction = 0.5 } },
    tiled.shapes(1, { tiled.object(3, 0, 0, 16, 8, { properties = { oneWay = "top" } }) }),
  })
  return tiled.map({ set }, {
    tiled.objects(1, "things", {
      tiled.object(5, 0, 0, 8, 8),
      tiled.object(6, 9, 0, 8, 8, { name = "crate", gid = 3, properties = { mass = 2 } }),
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

--- The call must be refused with this message, at the line of the call, and change nothing.
local function refuses(expected, map, options)
  local world = newWorld()
  local before = tiled.copy(world.objects)
  local isDone, message = pcall(function()
    world:loadTiled(map, options)
  end)
  assert.is_false(isDone, "it was not refused: " .. expected)
  local text = message:match("tiled_refusals_spec%.lua:%d+: physics: (.*)$")
  assert.truthy(text, "blames another line: " .. message)
  assert.equal(expected, text)
  assert.same(before, world.objects)
  world:loadTiled(newMap()) -- and it can still be used
end

describe("world:loadTiled refuses", function()
  local M, O = "world:loadTiled(map): ", "world:loadTiled(map, options): "

  it("what is no map", function()
    refuses(M .. "map must be a Tiled map or the path of one, got nil", nil)
    refuses(M .. "map must be a Tiled map or the path of one, got 5", 5)
    refuses(M .. "map.layers must be a table, got nil", {})
  end)

  describe("a file", function()
    local path

    before_each(function()
      path = os.tmpname()
    end)

    after_each(function()
      os.remove(path)
    end)

    -- As a message shows it: on Windows it has backslashes.
    local function shown()
      return '"' .. path:gsub("\\", "\\\\") .. '"'
    end

    local function write(text)
      local file = assert(io.open(path, "wb"))
      file:write(text)
      file:close()
    end

    it("that is not there", function()
      os.remove(path)
      local isDone, message = pcall(newWorld().loadTiled, newWorld(), path)
      assert.is_false(isDone)
      assert.truthy(message:find("cannot read " .. shown() .. ": ", 1, true), message)
    end)

    it("that is not Lua", function()
      write("<map>")
      local isDone, message = pcall(newWorld().loadTiled, newWorld(), path)
      assert.is_false(isDone)
      assert.truthy(message:find("cannot read " .. shown() .. ": ", 1, true), message)
    end)

    it("that fails", function()
      write("error('no luck')")
      local isDone, message = pcall(newWorld().loadTiled, newWorld(), path)
      assert.is_false(isDone)
      assert.truthy(message:find("cannot run " .. shown() .. ": ", 1, true), message)
    end)

    it("that returns no map", function()
      write("return 5")
      refuses(M .. shown() .. " must return a map, got 5", path)
    end)

    it("of the editor that is not exported", function()
      local expected = " must be exported as Lua: File > Export As, *.lua"
      refuses(M .. '"level.tmx"' .. expected, "level.tmx")
      refuses(M .. '"level.json"' .. expected, "level.json")
    end)
  end)

  --- Each row: how the map is damaged, and what is said.
  for _, row in ipairs({
    {
      function(map)
        map.tilewidth = 0
      end,
      "map.tilewidth must be a number > 0, got 0",
    },
    {
      function(map)
        map.height = nil
      end,
      "map.height must be a number >= 0, got nil",
    },
    {
      function(map)
        map.tilesets = nil
      end,
      "map.tilesets must be a table, got nil",
    },
    {
      function(map)
        map.tilesets[1].firstgid = 0
      end,
      "map.tilesets[1].firstgid must be an integer in 1..268435456, got 0",
    },
    {
      function(map)
        map.tilesets[1].tileheight = "16"
      end,
      'tileset "terrain": tileheight must be a number > 0, got "16"',
    },
    {
      function(map)
        map.tilesets[1].tiles[1].id = "a"
      end,
      'tileset "terrain": tiles[1].id must be an integer in 0..268435456, got "a"',
    },
    {
      function(map)
        map.layers[1] = 5
      end,
      "map.layers[1] must be a table, got 5",
    },
    {
      function(map)
        map.layers[1].name = nil
      end,
      "map.layers[1].name must be a string, got nil",
    },
    {
      function(map)
        map.layers[1].offsetx = NAN
      end,
      'layer "things": offsetx must be a number, got nan',
    },
    {
      function(map)
        map.layers[2].layers = nil
      end,
      'layer "all": layers must be a table, got nil',
    },
    {
      function(map)
        map.layers[2].layers[2] = map.layers[2]
      end,
      'layer "all": layers must not hold that layer itself',
    },
    {
      function(map)
        map.layers[2].layers[1].data[4] = nil
      end,
      'layer "ground": data must hold 4 gids (2 x 2), got 3',
    },
    {
      function(map)
        map.layers[2].layers[1].data = nil
      end,
      'layer "ground": data must be a table, got nil',
    },
    {
      function(map)
        map.layers[2].layers[1].width = 1.5
      end,
      'layer "ground": width must be an integer in 1..1000000, got 1.5',
    },
    {
      function(map)
        map.layers[2].layers[1].data[3] = 17
      end,
      'layer "ground": the tile at column 0, row 1 must be a gid of one of the tilesets, got 17',
    },
    {
      function(map)
        map.layers[2].layers[1].data[2] = -1
      end,
      'layer "ground": the tile at column 1, row 0 must be a gid, got -1',
    },
    {
      function(map)
        map.layers[2].layers[1].data[2] = 1.5
      end,
      'layer "ground": the tile at column 1, row 0 must be a gid, got 1.5',
    },
    {
      function(map)
        map.layers[2].layers[1].data[2] = NAN
      end,
      'layer "ground": the tile at column 1, row 0 must be a gid, got nan',
    },
    {
      function(map)
        map.layers[2].layers[1].chunks = { { x = 0, y = 0.5, width = 1, height = 1, data = { 1 } } }
      end,
      'layer "ground", chunk 1: y must be an integer in -1000000..1000000, got 0.5',
    },
    {
      function(map)
        map.layers[2].layers[1].chunks = { { x = 0, y = 0, width = 2, height = 1, data = { 1 } } }
      end,
      'layer "ground", chunk 1: data must hold 2 gids (2 x 1), got 1',
    },
    {
      function(map)
        map.layers[2].properties.friction = "ice"
      end,
      'layer "all": friction must be a number >= 0, got "ice"',
    },
    {
      function(map)
        map.layers[2].properties = 5
      end,
      'layer "all": properties must be a table, got 5',
    },
    {
      function(map)
        map.layers[2].properties = { "solid" }
      end,
      'layer "all": properties must have strings as keys, got 1',
    },
    {
      function(map)
        map.tilesets[1].tiles[1].properties.restitution = 2
      end,
      'tileset "terrain", tile 0: restitution must be a number in 0..1, got 2',
    },
    {
      function(map)
        map.tilesets[1].tiles[1].properties.solid = "yes"
      end,
      'tileset "terrain", tile 0: solid must be true or false, got "yes"',
    },
    {
      function(map)
        map.tilesets[1].tiles[2].objectGroup.objects[1].properties.oneWay = "up"
      end,
      'tileset "terrain", tile 1, shape 3: oneWay must be true, false, "top", "bottom", "left" or '
        .. '"right", got "up"',
    },
    {
      function(map)
        map.tilesets[1].tiles[2].objectGroup.objects[1].width = nil
      end,
      'tileset "terrain", tile 1, shape 3: width must be a number >= 0, got nil',
    },
    {
      function(map)
        map.layers[1].objects = nil
      end,
      'layer "things": objects must be a table, got nil',
    },
    {
      function(map)
        map.layers[1].objects[2] = "crate"
      end,
      'layer "things": objects[2] must be a table, got "crate"',
    },
    {
      function(map)
        map.layers[1].objects[1].x = NAN
      end,
      'layer "things", object 5: x must be a number, got nan',
    },
    {
      function(map)
        map.layers[1].objects[2].width = -1
      end,
      'layer "things", object 6 "crate": width must be a number >= 0, got -1',
    },
    {
      function(map)
        map.layers[1].objects[2].gid = 99
      end,
      'layer "things", object 6 "crate": gid must be a gid of one of the tilesets, got 99',
    },
    {
      function(map)
        map.layers[1].objects[2].properties.mass = 0
      end,
      'layer "things", object 6 "crate": mass must be a number > 0, got 0',
    },
    {
      function(map)
        map.layers[1].objects[2].properties.onBegin = "open"
      end,
      'layer "things", object 6 "crate": onBegin must be a function, got "open"',
    },
    {
      function(map)
        map.layers[1].objects[2].properties.merge = 1
      end,
      'layer "things", object 6 "crate": merge must be true or false, got 1',
    },
    {
      function(map)
        map.layers[1].objects[2].properties.group = true
      end,
      'layer "things", object 6 "crate": group must be a string or a number, got true',
    },
    {
      function(map)
        -- Of several the first by name, always the same one.
        local wrong = { vx = "a", ax = "b", mass = "c", drag = "d", friction = "e" }
        map.layers[1].objects[2].properties = wrong
      end,
      'layer "things", object 6 "crate": ax must be a number, got "b"',
    },
    {
      function(map)
        map.layers[1].name = "player"
      end,
      "objects.player is not a group, got an object",
    },
  }) do
    it(row[2], function()
      local map = newMap()
      row[1](map)
      refuses(M .. row[2], map, { strict = true })
    end)
  end

  it("a damaged table of STI", function()
    local map = tiled.sti(newMap())
    map.layers[2].data[2] = 5
    refuses(M .. 'layer "all.ground": data[2] must be a table, got 5', map)
    map.layers[2].data[2] = { 5 }
    refuses(M .. 'layer "all.ground": data[2][1] must be a table, got 5', map)
    map.layers[2].data[2] = { {} }
    local expected = 'layer "all.ground": the tile at column 0, row 1 must be a gid, got nil'
    refuses(M .. expected, map)
  end)

  for _, row in ipairs({
    { 5, "options must be a table, got 5" },
    {
      { solidLayer = { "ground" } },
      'unknown option "solidLayer" (did you mean "solidLayers"?); the options are decompress,'
        .. " dynamic, folder, ignore, merge, onlyLayers, skipLayers, solidLayers, solidProperty,"
        .. " solidTiles, strict, x, y",
    },
    { { merge = 1 }, "merge must be true or false, got 1" },
    { { x = NAN }, "x must be a number, got nan" },
    { { x = false }, "x must be a number, got false" },
    { { y = false }, "y must be a number, got false" },
    { { y = "1" }, 'y must be a number, got "1"' },
    { { solidProperty = true }, "solidProperty must be a name, got true" },
    { { solidProperty = false }, "solidProperty must be a name, got false" },
    { { solidTiles = 5 }, "solidTiles must be a list of gids, got 5" },
    { { solidTiles = { [5] = true } }, "solidTiles must be a list of gids, got table" },
    { { solidTiles = { 0 } }, "solidTiles[1] must be an integer in 1..268435455, got 0" },
    { { solidTiles = { 1, 17 } }, "solidTiles[2] must be a gid of one of the tilesets, got 17" },
    { { strict = 1 }, "strict must be true or false, got 1" },
    { { folder = 5 }, "folder must be a path, got 5" },
    { { decompress = "zlib" }, 'decompress must be a function, got "zlib"' },
    { { ignore = "drag" }, 'ignore must be a list of property names, got "drag"' },
    { { ignore = { 5 } }, "ignore[1] must be a name, got 5" },
    { { onlyLayers = "things" }, 'onlyLayers must be a list of layer names, got "things"' },
    {
      { onlyLayers = { "thngs" } },
      'onlyLayers[1] must be a layer of the map, got "thngs"; they are "things", "all", "ground"',
    },
    { { solidLayers = "ground" }, 'solidLayers must be a list of layer names, got "ground"' },
    { { skipLayers = { ground = true } }, "skipLayers must be a list of layer names, got table" },
    { { skipLayers = { true } }, "skipLayers[1] must be a string or a number, got true" },
    {
      { skipLayers = { "ground", "grund" } },
      'skipLayers[2] must be a layer of the map, got "grund"; they are "things", "all", "ground"',
    },
    {
      { solidLayers = { 9 } },
      'solidLayers[1] must be a layer of the map, got 9; they are "things", "all", "ground"',
    },
  }) do
    it("options: " .. row[2], function()
      refuses(O .. row[2], newMap(), row[1])
    end)
  end

  it("to be called without a world", function()
    assert.has_error(function()
      physics.newWorld().loadTiled(newMap())
    end)
  end)

  it("to be called from inside canCollide", function()
    local world = physics.newWorld()
    world:add("floors", { x = 0, y = 8, width = 99, height = 8, static = true })
    local box = world:add("boxes", { x = 0, y = 0, width = 8, height = 8 })
    local message
    function box.canCollide()
      local _, found = pcall(world.loadTiled, world, newMap())
      message = found
    end
    for _ = 1, 5 do
      world:update(1 / 60)
    end
    local expected = "world:loadTiled(map, options) cannot be called from inside canCollide"
    assert.truthy(tostring(message):find(expected, 1, true), tostring(message))
    assert.is_nil(world.objects.ground)
  end)
end)
