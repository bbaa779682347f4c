--- What in a map of Tiled is a wall: by options, properties and the names of layers. The maps have
--- the shapes of those of public games.

local tiled = require("spec.support.tiled")

local load, boxes = tiled.load, tiled.boxes

--- A map of one object layer.
local function newObjects(name, objects, extra, tiles)
  return tiled.map({ tiled.tileset(tiles) }, { tiled.objects(1, name, objects, extra) })
end

local function rectangle(properties, extra)
  local object = tiled.object(1, 0, 0, 40, 8, extra)
  object.properties = properties or {}
  return object
end

-- "static", "kinematic", "sensor", "dynamic" of the first object, "none" without one.
local function kindOf(level)
  local object = level.objects[1]
  if not object then
    return "none"
  elseif object.sensor and object.static then
    return "sensor"
  end
  return object.static and "static" or object.kinematic and "kinematic" or "dynamic"
end

-- The layers that were taken for solid, "name: reason".
local function solidOf(level)
  local list = {}
  for i, layer in ipairs(level.solidLayers) do
    list[i] = layer.name .. ": " .. layer.reason
  end
  return list
end

describe("world:loadTiled, walls", function()
  describe("are rectangles", function()
    --- name of the layer, its properties, the rectangle's, options: kind
    for _, row in ipairs({
      { "things", nil, nil, nil, "sensor" },
      { "things", nil, { solid = true }, nil, "static" },
      { "things", nil, { collidable = true }, nil, "static" },
      { "things", { solid = true }, nil, nil, "static" },
      { "things", nil, nil, { solidLayers = { "things" } }, "static" },
      { "things", { solid = true }, { static = false }, nil, "dynamic" },
      { "things", { solid = false }, { solid = true }, nil, "none" },
      { "things", nil, { solid = false, collidable = true }, nil, "none" },
      { "things", { solid = false }, nil, { solidLayers = { "things" } }, "static" },
      { "things", nil, { hard = true }, { solidProperty = "hard" }, "static" },
      { "things", nil, { solid = true }, { solidProperty = "hard" }, "sensor" },
      { "Walls", nil, nil, nil, "static" },
      { "walls", nil, { static = false }, nil, "dynamic" },
      { "walls", nil, { solid = false }, nil, "none" },
      { "walls", nil, nil, { solidLayers = {} }, "sensor" },
    }) do
      local name, layer, own, options, kind = row[1], row[2], row[3], row[4], row[5]
      local function show(words)
        local list = {}
        for word, value in pairs(words or {}) do
          list[#list + 1] = word .. " = " .. tostring(type(value) == "table" and value[1] or value)
        end
        table.sort(list)
        return "{" .. table.concat(list, ", ") .. "}"
      end
      local title = "%s %s with %s, options %s: %s"
      it(title:format(name, show(layer), show(own), show(options), kind), function()
        local map = newObjects(name, { rectangle(own) }, { properties = layer or {} })
        assert.equal(kind, kindOf(load(map, options)))
      end)
    end

    it("in a group of layers that says so", function()
      local map = newObjects("things", { rectangle() })
      for _, row in ipairs({
        { "all", { solid = true }, "static" },
        { "Collision", {}, "static" },
        { "all", {}, "sensor" },
        { "Collision", { solid = false }, "none" },
      }) do
        local copied = tiled.copy(map)
        copied.layers = { tiled.group(2, row[1], copied.layers, { properties = row[2] }) }
        assert.equal(row[3], kindOf(load(copied)))
        local options = { solidLayers = { "all" } }
        if row[1] == "all" then
          assert.equal("static", kindOf(load(copied, options)))
        end
      end
    end)
  end)

  it("are listed with the word that makes them so", function()
    local solid = tiled.tileset({ { id = 0, properties = { solid = true } } })
    local inner = tiled.objects(6, "inner", { rectangle() })
    local map = tiled.map({ solid }, {
      tiled.objects(1, "a", { rectangle() }, { properties = { collidable = true } }),
      tiled.objects(2, "b", { rectangle() }),
      tiled.tiles(3, "c", { "5." }, { properties = { solid = true } }),
      tiled.tiles(4, "d", { "1." }),
      tiled.group(5, "walls", { inner }),
      { type = "imagelayer", id = 7, name = "ground", properties = {} },
    })
    assert.same({
      'a: property "collidable"',
      'c: property "solid"',
      'inner: its name, "walls"',
    }, solidOf(load(map)))
    assert.same({}, load(map).unsupported)
    assert.same({
      'a: property "collidable"',
      "b: option solidLayers",
      'c: property "solid"',
    }, solidOf(load(map, { solidLayers = { "b" } })))
  end)

  describe("of tiles, in a layer by its name,", function()
    local function count(rows, options, tiles, name)
      local layer = tiled.tiles(1, name or "collision", rows)
      return load(tiled.map({ tiled.tileset(tiles) }, { layer }), options)
    end

    it("are all its tiles", function()
      local level = count({ "5.6", "555" })
      assert.equal(5, level.tiles)
      assert.same({ 'collision: its name, "collision"' }, solidOf(level))
      assert.equal(
        4,
        count({ "5.6", "555" }, nil, { { id = 5, properties = { solid = false } } }).tiles
      )
    end)

    it("but only those that say so if any says so", function()
      local marked = { { id = 0, properties = { solid = true } } }
      local level = count({ "1.6", "155" }, nil, marked)
      assert.equal(2, level.tiles)
      assert.same({}, level.solidLayers)
      local shaped = { tiled.shapes(0, { tiled.object(1, 0, 8, 16, 8) }) }
      assert.equal(2, count({ "1.6", "155" }, nil, shaped).tiles)
      assert.equal(3, count({ "1.6", "155" }, { solidTiles = { 5, 6 } }).tiles)
    end)

    it("and none if there is no free cell: that is a floor seen from above", function()
      local level = count({ "556", "555" }, nil, nil, "Ground")
      assert.equal(0, level.tiles)
      assert.same({}, level.solidLayers)
      assert.equal(6, count({ "556", "555" }, { solidLayers = { "Ground" } }, nil, "Ground").tiles)
    end)
  end)

  it("are tile objects with a tile that says so", function()
    local tiles = { { id = 0, properties = { collidable = true } } }
    local object = tiled.object(1, 0, 16, 16, 16, { gid = 1 })
    assert.equal("static", kindOf(load(newObjects("things", { object }, nil, tiles))))
    object.properties.static = false
    assert.equal("dynamic", kindOf(load(newObjects("things", { object }, nil, tiles))))
  end)

  -- Decoration ------------------------------------------------------------------------------------

  describe("are no tile objects about which the map says nothing", function()
    local function picture(extra)
      return tiled.object(1, 100, 200, 32, 16, extra)
    end

    it("those are decoration", function()
      local map = newObjects("clouds", { picture({ gid = 3 }) }, { offsetx = 5 })
      local level, world = load(map, { y = 7 })
      assert.same({}, level.objects)
      assert.same({}, world.objects.clouds)
      assert.same({}, level.unsupported)
      local cloud = level.pictures[1]
      assert.same({ 105, 191, 32, 16 }, { cloud.x, cloud.y, cloud.width, cloud.height })
      assert.equal(map.layers[1].objects[1], cloud.tiled.object)
      assert.equal(3, cloud.tiled.gid)
    end)

    for _, row in ipairs({
      { "has a name", { name = "cloud" } },
      { "has a tile with a property", nil, { { id = 2, properties = { speed = 3 } } } },
      { "has a tile with a shape", nil, { tiled.shapes(2, { tiled.object(1, 0, 0, 8, 8) }) } },
      { "is in a layer with a word of ours", nil, nil, { properties = { gravity = 0 } } },
      { "is in a layer that is solid", nil, nil, { properties = { solid = true } } },
      { "is in a layer by its name", nil, nil, nil, nil, "walls" },
      { "is in a layer of onlyLayers", nil, nil, nil, { onlyLayers = { "clouds" } } },
    }) do
      it("but what " .. row[1] .. " is there", function()
        local object = picture(row[2])
        object.gid = 3
        local map = newObjects(row[6] or "clouds", { object }, row[4], row[3])
        local level = load(map, row[5])
        assert.equal(1, #level.objects)
        assert.same({}, level.pictures)
      end)
    end
  end)

  it("are only what is in onlyLayers", function()
    local map = newObjects("a", { tiled.object(1, 0, 0, 8, 8) })
    map.layers[2] = tiled.objects(2, "b", { tiled.object(2, 0, 0, 8, 8, { shape = "point" }) })
    map.layers[3] = tiled.group(3, "c", {
      tiled.objects(4, "d", { tiled.object(3, 0, 0, 8, 8), tiled.object(4, 9, 0, 8, 8) }),
    })
    local function count(options)
      local level, world = load(map, options)
      return { #(world.objects.a or {}), #level.points, #(world.objects.d or {}) }
    end
    assert.same({ 1, 1, 2 }, count())
    assert.same({ 1, 0, 0 }, count({ onlyLayers = { "a" } }))
    assert.same({ 0, 1, 2 }, count({ onlyLayers = { "b", 3 } }))
    assert.same({ 0, 0, 2 }, count({ onlyLayers = { "d" } }))
    assert.same({ 0, 0, 0 }, count({ onlyLayers = {} }))
    assert.same({ 0, 0, 0 }, count({ onlyLayers = { "c" }, skipLayers = { "d" } }))
    local _, world = load(map, { onlyLayers = { "a" } })
    assert.is_nil(world.objects.b)
  end)

  -- An export -------------------------------------------------------------------------------------

  --- spec/maps/course.tmx, as Tiled 1.8.2 exports it: what most platformers of beginners look like.
  it("of a course that Tiled has exported are where its author has drawn them", function()
    local level, world = load("spec/maps/course.lua")
    assert.same({
      "0 144 320 16",
      "48 96 64 16",
      "208 96 16 48", -- turned by 90 degrees
      "240 64 64 16", -- a polygon like a gallows, two boxes
      "240 80 16 32",
      "128 96 32 8",
      "16 128 32 16", -- a right triangle
    }, boxes(world, "Platforms"))
    assert.equal("right", world.objects.Platforms[7].slope)
    assert.same({ "0 144 320 16" }, boxes(world, "scenery"))
    assert.same({ "64 84 12 12", "192 128 16 16" }, boxes(world, "Enemies"))
    assert.equal(2, #level.pictures)
    assert.is_true(level.named.lift.kinematic)
    assert.same({ 24, 120 }, { level.named.player.x, level.named.player.y })
    assert.same({ "player", "door" }, { level.points[1].name, level.points[2].name })
    assert.equal(48, level.lines[1].points[3].y)
    local reasons = {}
    for i, part in ipairs(level.unsupported) do
      reasons[i] = ("%s %d: %s"):format(part.layer, part.id, part.reason)
    end
    assert.same({
      'Enemies 11: drag must be a number >= 0, got "true"',
    }, reasons)
    assert.equal(1, level.named.slime.friction)
    for _ = 1, 60 do
      world:update(1 / 60)
    end
    assert.equal(84, level.named.slime.y)
  end)
end)
