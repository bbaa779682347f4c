--- Maps of the editor Tiled: what of them stands in the world, where, and what does not.

local physics = require("physics")
local tiled = require("spec.support.tiled")

local load, boxes = tiled.load, tiled.boxes
local MEADOW = "spec/maps/meadow.lua"

--- Object layers around one list of objects.
local function newObjects(objects, extra, tilesets)
  local sets = tilesets or { tiled.tileset() }
  return tiled.map(sets, { tiled.objects(1, "things", objects, extra) })
end

describe("world", function()
  describe(":loadTiled", function()
    -- An export -----------------------------------------------------------------------------------

    --- The meadow:
    ---     row 2   ....=====.......      = one-way
    ---         4   ..........~~....      ~ water, a sensor
    ---         5   ......####......      # earth
    ---         6   #.....####.....#
    ---         7   ################
    describe("reads an export of Tiled", function()
      for _, way in ipairs({ "by its path", "as a table" }) do
        it(way, function()
          local level, world = load(way == "as a table" and dofile(MEADOW) or MEADOW)
          assert.same({
            "64 32 80 16", -- the ledge
            "160 64 16 16", -- each sensor is one
            "176 64 16 16",
            "96 80 64 32",
            "0 96 16 16",
            "240 96 16 16",
            "0 112 256 16",
          }, boxes(world, "ground"))
          assert.equal(33, level.tiles)
          assert.equal(7, level.rectangles)
          assert.is_nil(world.objects.flowers)
          assert.same(
            { "32 80 12 20", "80 80 16 16", "176 64 48 8", "240 88 8 40" },
            boxes(world, "things")
          )
          assert.same({ "66 24 8 8", "102 24 8 8" }, boxes(world, "coins"))
          assert.same({}, level.unsupported)
          assert.same({ 0, 0, 256, 128 }, { level.x, level.y, level.width, level.height })
        end)
      end

      it("makes fields of properties", function()
        local level, world = load(MEADOW)
        local ground = world.objects.ground
        local ledge, water, earth = ground[1], ground[2], ground[4]
        assert.equal("top", ledge.oneWay)
        assert.is_true(ledge.static)
        assert.is_true(water.sensor)
        assert.equal("water", water.type)
        assert.equal(0.5, earth.friction)
        local hero = level.named.hero
        assert.equal(400, hero.maxSpeedY)
        assert.equal(3, hero.lives)
        assert.equal("player", hero.type)
        assert.is_nil(hero.static)
        assert.same({ id = 6 }, level.named.lift.goal)
        assert.is_true(world.objects.coins[1].sensor)
      end)

      it("through love.filesystem where there is one", function()
        local loveBefore = rawget(_G, "love")
        finally(function()
          rawset(_G, "love", loveBefore)
        end)
        local asked = {}
        rawset(_G, "love", {
          filesystem = {
            getInfo = function(path)
              return path == "levels/one.lua" and {} or nil
            end,
            load = function(path)
              asked[#asked + 1] = path
              return loadfile(MEADOW)
            end,
          },
        })
        local level = load("levels/one.lua")
        assert.same({ "levels/one.lua" }, asked)
        assert.equal(33, level.tiles)
        assert.has_error(function()
          load("levels/two.lua")
        end)
      end)
    end)

    -- Infinite maps -------------------------------------------------------------------------------

    --- The cave, tiles of 8 px: three parts, one of them to the left of the origin.
    ---
    ---               -10   0    16
    ---     row  4   ......######     one floor across two parts
    ---     row  5         ##         and a wall down into the third
    ---     row 19         ####       rough, so it stays apart
    it(
      "reads the parts of an infinite map in any order, and merges across their borders",
      function()
        local map = tiled.infinite()
        local chunks = map.layers[1].chunks
        for _, order in ipairs({ { 1, 2, 3 }, { 3, 2, 1 } }) do
          map.layers[1].chunks = { chunks[order[1]], chunks[order[2]], chunks[order[3]] }
          local level, world = load(map)
          assert.same({ "-32 8 64 16", "0 24 16 32", "0 56 16 16" }, boxes(world, "rocks"))
          assert.equal(0.9, world.objects.rocks[3].friction)
          assert.same({ -64, 0, 128, 64 }, { level.x, level.y, level.width, level.height })
          local tile = world.objects.rocks[1].tiled
          assert.same(
            { -2, 0, 4, 1, 1 },
            { tile.column, tile.row, tile.columns, tile.rows, tile.gid }
          )
        end
      end
    )

    -- Layers --------------------------------------------------------------------------------------

    describe("adds up offsets", function()
      local function newMap()
        local set = tiled.tileset({ { id = 0, properties = { solid = true } } })
        local outer = { offsetx = 100, offsety = -7.5 }
        local inner = { offsetx = 20, offsety = 0.25, visible = false }
        return tiled.map({ set }, {
          tiled.group(1, "outer", {
            tiled.group(2, "inner", {
              tiled.tiles(3, "ground", { "...", ".11" }, { offsetx = 3, offsety = 1 }),
              tiled.objects(4, "things", { tiled.object(1, 5, 6, 7, 8) }, { offsetx = -1 }),
            }, inner),
          }, outer),
        })
      end

      it("of layers and of the groups around them, hidden ones too", function()
        local _, world = load(newMap())
        assert.same({ "139 9.75 32 16" }, boxes(world, "ground"))
        assert.same({ "124 -1.25 7 8" }, boxes(world, "things"))
      end)

      it("and of STI", function()
        local level, world = load(tiled.sti(newMap(), 500, 50))
        assert.same({ "639 59.75 32 16" }, boxes(world, "outer.inner.ground"))
        assert.same({ "624 48.75 7 8" }, boxes(world, "outer.inner.things"))
        assert.same({ 500, 50 }, { level.x, level.y })
      end)
    end)

    describe("takes the table of STI", function()
      for name, map in pairs({ meadow = dofile(MEADOW), infinite = tiled.infinite() }) do
        it("for the same world, " .. name, function()
          local level = load(map)
          local levelOfSti = load(tiled.sti(map))
          assert.equal(level.tiles, levelOfSti.tiles)
          assert.equal(#level.objects, #levelOfSti.objects)
          for i, object in ipairs(level.objects) do
            for field, value in pairs(object) do
              if field ~= "tiled" then
                assert.same(value, levelOfSti.objects[i][field])
              end
            end
          end
        end)
      end

      it("with flipped tiles and layers of the game's own", function()
        local low = tiled.shapes(0, { tiled.object(1, 0, 12, 16, 4) })
        local legend = { u = 1 + tiled.FLIP_Y }
        local layer = tiled.tiles(1, "ground", { "1u" }, nil, legend)
        local map = tiled.sti(tiled.map({ tiled.tileset({ low }) }, { layer }))
        map.layers[2] = { type = "customlayer", name = "sprites", properties = {} }
        local level, world = load(map)
        assert.same({ "0 12 16 4", "16 0 16 4" }, boxes(world, "ground"))
        assert.same({}, level.unsupported)
      end)
    end)

    it("gives the properties of layers to what is in them, the nearest first", function()
      local map = newObjects({
        tiled.object(1, 0, 0, 8, 8),
        tiled.object(2, 9, 0, 8, 8, { properties = { friction = 0.3, kinematic = true } }),
      }, { properties = { friction = 0.2, mood = "dark" } })
      local around = { properties = { static = true, friction = 0.1, restitution = 1 } }
      map.layers = { tiled.group(2, "all", map.layers, around) }
      local _, world = load(map)
      local a, b = world.objects.things[1], world.objects.things[2]
      assert.same({ true, 0.2, 1 }, { a.static, a.friction, a.restitution })
      assert.is_nil(a.mood) -- that is what the layer is like, not what is in it
      assert.same({ 0.3, 1, true }, { b.friction, b.restitution, b.kinematic })
      assert.is_nil(b.static)
    end)

    it("takes groups from layers, and from the property of the nearest", function()
      local named = { properties = { group = "enemies" } }
      local map = newObjects({
        tiled.object(1, 0, 0, 8, 8),
        tiled.object(2, 9, 0, 8, 8, { properties = { group = "coins" } }),
      }, named)
      map.layers[2] = tiled.objects(2, "empty", {})
      local level, world = load(map)
      assert.same({ "0 0 8 8" }, boxes(world, "enemies"))
      assert.same({ "9 0 8 8" }, boxes(world, "coins"))
      assert.same({}, world.objects.empty)
      assert.is_nil(world.objects.things)
      assert.is_nil(level.objects[1].group)
    end)

    it("adds to groups that are there, behind those in it", function()
      local world = physics.newWorld()
      local box = world:add("things", { x = -99, y = 0, width = 8, height = 8 })
      local first = world:loadTiled(newObjects({ tiled.object(1, 0, 0, 8, 8) }))
      local dynamic = { x = 50, kinds = { things = "dynamic" } }
      local second = world:loadTiled(newObjects({ tiled.object(1, 0, 0, 8, 8) }), dynamic)
      local things = world.objects.things
      assert.same({ box, first.objects[1], second.objects[1] }, things)
      assert.is_false(things[3].touching.bottom)
      world:remove(first.objects[1])
      assert.equal(2, #things)
    end)

    -- Objects -------------------------------------------------------------------------------------

    describe("reads objects", function()
      it("with the name and class of the editor, and the way back to the map", function()
        local map = newObjects({
          tiled.object(7, 0, 0, 8, 8, { name = "door", type = "exit" }),
          tiled.object(8, 9, 0, 8, 8, { name = "door", class = "of 1.9" }),
        })
        map.layers[1].objects[2].type = nil
        local level = load(map)
        local a, b = level.objects[1], level.objects[2]
        assert.same({ "door", "exit" }, { a.name, a.type })
        map.layers[1].objects[1].properties.type = "not this"
        assert.equal("exit", load(map).objects[1].type)
        map.layers[1].objects[2].class, map.layers[1].objects[2].properties.type = "", "but this"
        assert.equal("but this", load(map).objects[2].type)
        assert.equal("of 1.9", b.type)
        assert.equal(a, level.named.door)
        assert.equal(map.layers[1].objects[1], a.tiled.object)
        assert.equal(map.layers[1], a.tiled.layer)
        assert.equal(map, level.map)
      end)

      it("of which no table is shared with the map or each other", function()
        local mask = { players = false }
        local map = newObjects({
          tiled.object(1, 0, 0, 8, 8),
          tiled.object(2, 9, 0, 8, 8),
        }, { properties = { mask = mask } })
        local level = load(map)
        local a, b = level.objects[1], level.objects[2]
        assert.same({ players = false }, a.mask)
        assert.are_not.equal(mask, a.mask)
        assert.are_not.equal(a.mask, b.mask)
      end)

      it("except those that say solid = false", function()
        local no = { properties = { solid = false } }
        local point = { shape = "point", properties = { solid = false } }
        local level = load(newObjects({
          tiled.object(1, 0, 0, 8, 8, no),
          tiled.object(2, 9, 0, 0, 0, point),
          tiled.object(3, 30, 0, 8, 8),
        }))
        assert.equal(1, #level.objects)
        assert.equal(30, level.objects[1].x)
        assert.same({}, level.unsupported)
        local set = tiled.tileset({ { id = 0, properties = { solid = false } } })
        local object = tiled.object(1, 0, 8, 8, 8, { gid = 1, properties = { solid = true } })
        assert.same({}, load(newObjects({ object }, nil, { set })).objects)
        local list = { solidTiles = { 1 } } -- of tiles, not of objects
        assert.same({}, load(newObjects({ object }, nil, { set }), list).objects)
        local map = newObjects({ tiled.object(1, 0, 0, 8, 8) }, no)
        assert.equal(1, #load(map, { solidLayers = { "things" } }).objects)
      end)

      --- A tile object stands on its x and y: `o` is what the map says.
      ---
      ---     bottomleft  +--+     topleft  o--+     center  +--+
      ---                 |  |              |  |             |o |
      ---                 o--+              +--+             +--+
      for _, row in ipairs({
        { "unspecified", "100 180 30 20" },
        { "topleft", "100 200 30 20" },
        { "topright", "70 200 30 20" },
        { "center", "85 190 30 20" },
        { "bottomleft", "100 180 30 20" },
        { "bottomright", "70 180 30 20" },
      }) do
        it("with a tile, aligned " .. tostring(row[1]), function()
          local set = tiled.tileset({}, { objectalignment = row[1] })
          local object = tiled.object(1, 100, 200, 30, 20, { gid = 3, name = "tree" })
          local _, world = load(newObjects({ object }, nil, { set }))
          assert.same({ row[2] }, boxes(world, "things"))
        end)
      end

      it("with the properties and the class of their tile", function()
        local properties = { mass = 3, friction = 0.5, label = "fragile" }
        local crate = { id = 2, type = "crate", properties = properties }
        local own = { gid = 3, properties = { friction = 0.7 } }
        local set = tiled.tileset({ crate })
        local level = load(newObjects({ tiled.object(1, 0, 16, 16, 16, own) }, nil, { set }))
        local made = level.objects[1]
        assert.same({ 3, 0.7, "fragile" }, { made.mass, made.friction, made.label })
        assert.equal("crate", made.type)
        assert.equal(3, made.tiled.gid)
      end)

      --- A tile of 16 x 16 px with one rectangle, 4 px from the left, 6 from the top, 8 x 10.
      for _, row in ipairs({
        { "twice as wide", 32, 16, 0, "108 190 16 10" },
        { "flipped left to right and large", 64, 16, tiled.FLIP_X, "116 190 32 10" },
        { "flipped top to bottom", 16, 32, tiled.FLIP_Y, "104 168 8 20" },
      }) do
        it("with the one collision rectangle of their tile, " .. row[1], function()
          local shape = tiled.object(1, 4, 6, 8, 10, { properties = { friction = 0.25 } })
          local set = tiled.tileset({ tiled.shapes(2, { shape }) })
          local object = tiled.object(1, 100, 200, row[2], row[3], { gid = 3 + row[4] })
          local _, world = load(newObjects({ object }, nil, { set }))
          assert.same({ row[5] }, boxes(world, "things"))
          assert.equal(0.25, world.objects.things[1].friction)
          assert.equal(3, world.objects.things[1].tiled.gid)
        end)
      end
    end)

    -- Not supported -------------------------------------------------------------------------------

    describe("names what is not supported", function()
      --- A map with something of everything that is not supported.
      local function newZoo()
        local solid = tiled.tileset({ { id = 0, properties = { solid = true } } })
        local packed = tiled.tiles(4, "packed", { "1" })
        packed.encoding, packed.compression, packed.data = "base64", "zlib", "eJw="
        return tiled.map({ solid, { firstgid = 17, filename = "far.tsx" } }, {
          tiled.tiles(1, "slopes", { "1a.a" }, nil, { a = 17 }),
          tiled.objects(2, "shapes", {
            tiled.object(3, 0, 0, 16, 8, { shape = "ellipse" }),
            tiled.object(5, 0, 0, 16, 8, { shape = "text" }),
            tiled.object(6, 0, 0, 16, 8, { rotation = 30 }),
            tiled.object(8, 0, 0, 16, 8, { properties = { width = 3 } }),
          }),
          tiled.objects(3, "clouds", { tiled.object(9, 0, 0, 32, 16) }, { parallaxx = 0.5 }),
          packed,
          { type = "imagelayer", id = 5, name = "hills", properties = { solid = true } },
        })
      end

      it("with kind, layer, id and reason, in the order of the layers", function()
        local level, world = load(newZoo())
        local lines = {}
        for i, entry in ipairs(level.unsupported) do
          lines[i] = ("%s %s %s: %s"):format(entry.kind, entry.layer, entry.id, entry.reason)
        end
        local external = 'external ("far.tsx"): what its tiles are is not in this export, embed it'
        assert.same({
          "tileset slopes 17: " .. external,
          "object shapes 3: ellipse: only circles are round; the option ellipses = "
            .. '"box" makes it a box',
          "object shapes 5: text: only rectangles are boxes",
          "object shapes 6: rotated by 30 degrees: boxes do not turn",
          'object shapes 8: property "width": the editor\'s own value counts',
          "layer clouds 3: parallax: its objects do not drift",
          "layer packed 4: encoded data (zlib, base64): LÖVE is not here to unpack it, and there is"
            .. " no option decompress; choose CSV as Tile Layer Format in the map's properties",
          "layer hills 5: image layer: it has no boxes",
        }, lines)
        -- The rest is there.
        assert.same({ "0 0 16 16" }, boxes(world, "slopes"))
        assert.same({ "0 0 32 16" }, boxes(world, "clouds"))
        local entry = load(newZoo(), { x = 1000 }).unsupported[2]
        assert.same({ 3, 1, 1000 }, { entry.id, entry.count, entry.x })
        assert.equal("ellipse", entry.object.shape)
      end)

      it("but not where nothing is solid, and no layer of which nothing is wanted", function()
        local map = newZoo()
        for _, layer in ipairs(map.layers) do
          layer.properties.solid = false
        end
        assert.same({}, load(map).unsupported)
        assert.same({}, load(newZoo(), { skipLayers = { 1, 2, 3, 4, 5 } }).unsupported)
        map = newObjects({}, { parallaxx = 0.5 })
        assert.same({}, load(map).unsupported)
        map.layers[1].objects[1] = tiled.object(1, 0, 0, 8, 8)
        assert.equal(1, #load(map).unsupported)
      end)

      for _, orientation in ipairs({ "isometric", "hexagonal" }) do
        it("of a map that is " .. orientation .. " each layer", function()
          local map = dofile(MEADOW)
          map.orientation = orientation
          local level, world = load(map)
          assert.same({}, level.objects)
          assert.same({}, world.objects)
          local ids = {}
          for i, entry in ipairs(level.unsupported) do
            ids[i] = entry.id
            assert.equal(orientation .. " map: only orthogonal ones have boxes", entry.reason)
          end
          assert.same({ 7, 1, 2, 4, 6 }, ids)
        end)
      end

      it("also a type of layer that is unknown", function()
        local map = newObjects({})
        map.layers[1].type = "hologram"
        local entry = load(map).unsupported[1]
        assert.same({ "layer", 1 }, { entry.kind, entry.id })
        assert.equal('unknown type of layer: "hologram"', entry.reason)
      end)
    end)
  end)
end)
