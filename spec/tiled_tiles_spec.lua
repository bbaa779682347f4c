--- Solid tiles of Tiled maps: which are, where, how many rectangles become of them, and that
--- merging changes no motion.

local tiled = require("spec.support.tiled")

local load, boxes = tiled.load, tiled.boxes
local X, Y, T = tiled.FLIP_X, tiled.FLIP_Y, tiled.TRANSPOSE

--- A map of one layer of tiles. 1 is solid, 2 a sensor, 3 a ledge, 4 rough, 5 says nothing, 6 is
--- not solid, 7 moves, 8 is as solid as 1 and has a name.
local function newMap(rows, extra, legend)
  local set = tiled.tileset({
    { id = 0, properties = { solid = true } },
    { id = 1, properties = { solid = true, sensor = true } },
    { id = 2, properties = { solid = true, oneWay = "top" } },
    { id = 3, properties = { solid = true, friction = 0.75 } },
    { id = 5, properties = { solid = false } },
    { id = 6, properties = { solid = true, kinematic = true } },
    { id = 7, properties = { solid = true, label = "marble" } },
  })
  return tiled.map({ set }, { tiled.tiles(1, "ground", rows, extra, legend) })
end

describe("world:loadTiled, tiles", function()
  -- Which are solid -------------------------------------------------------------------------------

  describe("are solid", function()
    local function count(map, options)
      local level, world = load(map, options)
      return level.tiles, world
    end

    local LAYER, NO, YES = { solidLayers = { "ground" } }, { solid = false }, { solid = true }
    local LEGEND = { a = 5 + X, b = 6 + Y + T, c = 5 + 268435456.0 } -- flipped

    -- why, the tiles, properties of their layer and of one around it, options, how many are solid
    for _, row in ipairs({
      { "by their property, and nothing else is", "1556.555...1", nil, nil, nil, 2 },
      { "by their layer's property, but for those that say no", "1556", YES, nil, nil, 3 },
      { "by the name of their layer", "1556", nil, nil, LAYER, 3 },
      { "by a layer around theirs", "555", nil, YES, nil, 3 },
      { "but not against their own layer", "555", NO, {}, { solidLayers = { "all" } }, 0 },
      { "by the nearest layer that says anything", "5", YES, NO, nil, 1 },
      { "by the nearest, before solidTiles", "5", nil, NO, { solidTiles = { 5 } }, 0 },
      { "by a longer list of gids", "1a5bc...", nil, nil, { solidTiles = { 5, 6 } }, 5 },
      { "but not in a layer that says no", "1234", NO, nil, { solidTiles = { 1 } }, 0 },
      { "in one that says no, by its name", "1234", NO, nil, LAYER, 4 },
      { "by an option, whatever they say", "666", nil, nil, { solidTiles = { 6 } }, 3 },
      { "by no name of a layer if they say no", "666", NO, nil, LAYER, 0 },
      {
        "by both options",
        "666",
        NO,
        nil,
        { solidLayers = { "ground" }, solidTiles = { 6 } },
        3,
      },
    }) do
      it(row[1], function()
        local map = newMap({ row[2] }, { properties = row[3] }, LEGEND)
        if row[4] then
          map.layers = { tiled.group(2, "all", map.layers, { properties = row[4] }) }
        end
        assert.equal(row[6], (count(map, row[5])))
      end)
    end

    it("by a property of another name", function()
      local set = tiled.tileset({ { id = 4, properties = { collidable = true } } })
      local map = tiled.map({ set }, { tiled.tiles(1, "ground", { "515" }) })
      local tiles, world = count(map, { solidProperty = "collidable" })
      assert.equal(2, tiles)
      assert.is_nil(world.objects.ground[1].collidable)
    end)

    it("by their collision rectangles", function()
      local low = tiled.shapes(4, { tiled.object(1, 0, 8, 16, 8) })
      local silent = tiled.shapes(5, { tiled.object(1, 0, 8, 16, 8) }, {
        properties = { solid = false },
      })
      local empty = tiled.shapes(6, {})
      local map = newMap({ "5567" })
      map.tilesets[1].tiles = { low, silent, empty }
      local tiles, world = count(map)
      assert.equal(2, tiles)
      assert.same({ "0 8 32 8" }, boxes(world, "ground"))
    end)

    it("static, unless they say otherwise", function()
      local _, world = count(newMap({ "17" }))
      local a, b = world.objects.ground[1], world.objects.ground[2]
      assert.is_true(a.static)
      assert.is_nil(b.static)
      assert.is_true(b.kinematic)
      _, world = count(newMap({ "1" }, { properties = { static = false } }))
      assert.is_false(world.objects.ground[1].static)
      assert.truthy(world.objects.ground[1].touching)
    end)
  end)

  -- Merging ---------------------------------------------------------------------------------------

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
      local level, world = load(newMap(row[2], { properties = row[4] }))
      local found = {}
      for i, object in ipairs(world.objects.ground) do
        local tile = object.tiled
        found[i] = ("%d %d %d %d"):format(tile.column, tile.row, tile.columns, tile.rows)
        assert.equal(tile.column * 16, object.x)
        assert.equal(tile.row * 16, object.y)
        assert.equal(tile.columns * 16, object.width)
        assert.equal(tile.rows * 16, object.height)
      end
      assert.equal(row[3], table.concat(found, ", "))
      assert.equal(#found, level.rectangles)
      assert.equal(select(2, table.concat(row[2]):gsub("%d", "")), level.tiles)
    end)
  end

  it("do not merge over groups, nor with those that say no", function()
    local set = tiled.tileset({
      { id = 0, properties = { solid = true } },
      { id = 1, properties = { solid = true, group = "ice" } },
      { id = 2, properties = { solid = true, merge = false } },
    })
    local level, world = load(tiled.map({ set }, { tiled.tiles(1, "ground", { "112233" }) }))
    assert.same({ "0 0 32 16", "64 0 16 16", "80 0 16 16" }, boxes(world, "ground"))
    assert.same({ "32 0 32 16" }, boxes(world, "ice"))
    assert.same({ 6, 4 }, { level.tiles, level.rectangles })
  end)

  it("merge over equal tiles of several tilesets", function()
    local first = tiled.tileset({ { id = 0, properties = { solid = true } } }, { tilecount = 4 })
    local second = tiled.tileset({ { id = 2, properties = { solid = true } } }, { firstgid = 5 })
    local level = load(tiled.map({ first, second }, { tiled.tiles(1, "ground", { "1771" }) }))
    assert.same({ 4, 1 }, { level.tiles, level.rectangles })
    assert.is_nil(level.objects[1].tiled.gid)
  end)

  -- Shapes ----------------------------------------------------------------------------------------

  --- One rectangle in a tile, 2 px from the left, 3 px from the top, 4 px wide, 8 px high, in all
  --- the ways in which the editor turns tiles (keys X, Y and Z).
  ---
  ---      +--------+
  ---      | +-+    |
  ---      | | |    |
  ---      | +-+    |
  ---      +--------+
  for _, row in ipairs({
    { "as drawn", 0, "2 3 4 8" },
    { "flipped left to right", X, "10 3 4 8" },
    { "flipped top to bottom", Y, "2 5 4 8" },
    { "turned by 180 degrees", X + Y, "10 5 4 8" },
    { "flipped along the diagonal", T, "3 2 8 4" },
    { "turned by 90 degrees", T + X, "5 2 8 4" },
    { "turned by 270 degrees", T + Y, "3 10 8 4" },
    { "flipped along the other diagonal", T + X + Y, "5 10 8 4" },
  }) do
    it("have collision rectangles, " .. row[1], function()
      local set = tiled.tileset({ tiled.shapes(0, { tiled.object(1, 2, 3, 4, 8) }) })
      local layer = tiled.tiles(1, "ground", { "a" }, nil, { a = 1 + row[2] })
      local _, world = load(tiled.map({ set }, { layer }))
      assert.same({ row[3] }, boxes(world, "ground"))
    end)
  end

  it("have several of them, each with properties of its own", function()
    local set = tiled.tileset({
      tiled.shapes(0, {
        tiled.object(1, 0, 0, 16, 4, { properties = { oneWay = "top" } }),
        tiled.object(2, 6, 4, 4, 12, { properties = { friction = 0.9 } }),
      }, { properties = { friction = 0.1, label = "mushroom" } }),
    })
    local level, world = load(tiled.map({ set }, { tiled.tiles(1, "ground", { "111", "1.." }) }))
    assert.same({
      "0 0 48 4", -- the caps of a row become one
      "0 16 16 4",
      "6 4 4 12", -- the stems stand apart
      "22 4 4 12",
      "38 4 4 12",
      "6 20 4 12",
    }, boxes(world, "ground"))
    local cap, stem = level.objects[1], level.objects[3]
    assert.same({ "top", 0.1, "mushroom" }, { cap.oneWay, cap.friction, cap.label })
    assert.same({ 0.9, "mushroom" }, { stem.friction, stem.label })
    assert.same({ 8, 6 }, { level.tiles, level.rectangles })
  end)

  it("merge half tiles along the side where they meet", function()
    local set = tiled.tileset({
      tiled.shapes(0, { tiled.object(1, 0, 8, 16, 8) }), -- the lower half
      tiled.shapes(1, { tiled.object(1, 0, 0, 8, 16) }), -- the left half
    })
    local _, world = load(tiled.map({ set }, { tiled.tiles(1, "ground", { "11.22", "11.22" }) }))
    assert.same({
      "0 8 32 8",
      "0 24 32 8",
      "48 0 8 32",
      "64 0 8 32",
    }, boxes(world, "ground"))
  end)

  -- Sizes -----------------------------------------------------------------------------------------

  --- Tiles stand on the lower left corner of their cell, whatever their size.
  ---
  ---          +----+
  ---          |    |
  ---      +--+|    |    the cell is 16 x 16, the second tile 24 x 40
  ---      |  ||    |
  ---      +--++----+
  for _, row in ipairs({
    { "larger than a cell", {}, 0, "16 -8 24 40" },
    { "moved by the tileset", { tileoffset = { x = 3, y = -5 } }, 0, "19 -13 24 40" },
    { "turned by 90 degrees", {}, T + X, "16 8 40 24" },
    { "drawn at the size of the grid", { tilerendersize = "grid" }, 0, "16 16 16 16" },
  }) do
    it("may be " .. row[1], function()
      local set = tiled.tileset({ { id = 0, properties = { solid = true } } }, {
        tilewidth = 24,
        tileheight = 40,
      })
      for name, value in pairs(row[2]) do
        set[name] = value
      end
      local layer = tiled.tiles(1, "ground", { "..", ".a" }, nil, { a = 1 + row[3] })
      local _, world = load(tiled.map({ set }, { layer }))
      assert.same({ row[4] }, boxes(world, "ground"))
    end)
  end

  it("may have an image and a size of their own", function()
    local set = tiled.tileset({
      { id = 2, image = "tree.png", width = 20, height = 48 },
      { id = 5, image = "bush.png", width = 12, height = 10 },
    }, { tilewidth = 20, tileheight = 48, columns = 0, tilecount = 2 })
    local map = tiled.map({ set }, { tiled.tiles(1, "ground", { "36" }) })
    local _, world = load(map, { solidLayers = { "ground" } })
    assert.same({ "0 -32 20 48", "16 6 12 10" }, boxes(world, "ground"))
  end)

  it("are scaled with their rectangles", function()
    local set = tiled.tileset({ tiled.shapes(0, { tiled.object(1, 0, 4, 8, 4) }) }, {
      tilewidth = 8,
      tileheight = 8,
      tilerendersize = "grid",
    })
    local _, world = load(tiled.map({ set }, { tiled.tiles(1, "ground", { "11" }) }))
    assert.same({ "0 8 32 8" }, boxes(world, "ground"))
  end)
end)
