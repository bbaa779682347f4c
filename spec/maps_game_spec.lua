--- A map becomes a game: what is solid, what moves and what is only seen, what a level lists, and
--- what it says of a map that no one has made for this library.

local ldtk = require("spec.support.ldtk")
local physics = require("physics")
local tiled = require("spec.support.tiled")

local function newMap(layers, tiles, extra)
  return tiled.map({ tiled.tileset(tiles) }, layers, extra)
end

local function newBox(class, properties, extra)
  local object = tiled.object(1, 16, 16, 32, 16, extra)
  object.type, object.properties = class or "", properties or {}
  return object
end

local function load(map, options, settings)
  local world = physics.newWorld(settings or { gravity = 0 })
  return world:loadTiled(map, options), world
end

local function loadLDtk(layers, options, values)
  local world = physics.newWorld({ gravity = 0 })
  return world:loadLDtk(ldtk.project({ ldtk.level("Cave", layers) }, values), nil, options), world
end

local function kindOf(object)
  local moves = object.static and "static" or object.kinematic and "kinematic" or "dynamic"
  return object.sensor and "sensor" or moves
end

-- "reason", or "reason x3" if it is true of three parts.
local function reasonsOf(level)
  local list = {}
  for i, entry in ipairs(level.unsupported) do
    list[i] = entry.count > 1 and entry.reason .. " x" .. entry.count or entry.reason
  end
  return list
end

-- Calls f, and returns what it prints and what it returns.
local function printed(f)
  local before, lines = print, {}
  rawset(_G, "print", function(text)
    lines[#lines + 1] = text
  end)
  local isDone, result = pcall(f)
  rawset(_G, "print", before)
  assert(isDone, result)
  return lines, result
end

describe("an object of a map", function()
  -- Its layer, its class, its properties, the option `kinds`: what it is.
  for _, row in ipairs({
    { "Portals", "", {}, nil, "sensor" },
    { "Portals", "", { color = "red", friction = 0.5 }, nil, "sensor" },
    { "Portals", "Wall", {}, nil, "static" },
    { "Walls", "Water", {}, { Water = "sensor" }, "sensor" },
    { "Things", "Crate", {}, { Crate = "dynamic" }, "dynamic" },
    { "Things", "Lift", {}, { Lift = "kinematic" }, "kinematic" },
    { "Things", "", {}, { Things = "static" }, "static" },
    { "Things", "Crate", {}, { Things = "static", Crate = "dynamic" }, "dynamic" },
    { "Things", "Crate", { static = true }, { Crate = "dynamic" }, "static" },
    { "Dynamic things", "", {}, nil, "dynamic" },
    { "Things", "KinematicLift", {}, nil, "kinematic" },
    { "Things", "", { mass = 2 }, nil, "dynamic" },
    { "Things", "", { oneWay = true }, nil, "static" },
    { "Things", "", { slope = "left" }, nil, "static" },
  }) do
    local name = ("in the layer %q of the class %q is %s"):format(row[1], row[2], row[5])
    it(name .. ": " .. tostring(next(row[3])) .. ", " .. tostring(next(row[4] or {})), function()
      local map = newMap({ tiled.objects(1, row[1], { newBox(row[2], row[3]) }) })
      assert.equal(row[5], kindOf(load(map, { kinds = row[4] }).objects[1]))
    end)
  end

  it("that moves is no slope and has no one-way side: that is left out and named", function()
    local properties = { slope = "left", oneWay = "top", static = false }
    local level, world = load(newMap({ tiled.objects(1, "things", { newBox("", properties) }) }))
    local only = ": only static and kinematic objects have it"
    assert.same({ "slope" .. only, "oneWay" .. only }, reasonsOf(level))
    world:update(1 / 60)
    local entity = ldtk.entity("Box", 32, 32, 16, 16, { slope = "left", oneWay = "top", mass = 1 })
    level, world = loadLDtk(
      { ldtk.entities("Things", { entity }) },
      { kinds = { Box = "dynamic" } }
    )
    assert.same({ "slope" .. only, "oneWay" .. only }, reasonsOf(level))
    world:update(1 / 60)
  end)

  it("or tile with fields that do not fit each other loses one of them", function()
    local light = ldtk.entity("Light", 32, 32, 16, 16, { radius = 99 })
    local level = loadLDtk({ ldtk.entities("Things", { light }) })
    local text = "radius must be half of width and height, which are 16 and 16: it is left out"
    assert.same({ text }, reasonsOf(level))
    local tiles = { { id = 0, properties = { solid = true, area = { gravity = 5 }, radius = 3 } } }
    level = load(newMap({ tiled.tiles(1, "ground", { "1.1" }) }, tiles))
    assert.equal(2, #level.walls)
    assert.equal(2, #level.unsupported)
  end)

  it("falls out of the map: that is named, with the cure", function()
    local floor = newBox("Wall", {}, { x = 16, y = 64 })
    local objects =
      { newBox("Crate", { mass = 1 }), newBox("Crate", { mass = 1 }, { x = 300 }), floor }
    local map = newMap({ tiled.objects(1, "things", objects) })
    local text =
      'it falls: no wall is below it; write static = true, or kinds = { ["Crate"] = "static" }'
    assert.same(
      { (text:gsub('%["Crate"%]', '["Crate"]')) },
      reasonsOf((load(map, nil, { gravity = 9 })))
    )
    assert.same({}, reasonsOf((load(map))))
  end)

  it("that is an ellipse is a box or a circle by an option", function()
    local map = newMap({ tiled.objects(1, "walls", { newBox("", {}, { shape = "ellipse" }) }) })
    local only = 'ellipse: only circles are round; the option ellipses = "box" makes it a box'
    assert.equal(only, load(map).unsupported[1].reason)
    local box = load(map, { ellipses = "box" }).walls[1]
    assert.same({ 16, 32, 16 }, { box.x, box.width, box.height })
    local ball = load(map, { ellipses = "circle" }).walls[1]
    assert.same({ 24, 16, 8 }, { ball.x, ball.width, ball.radius })
  end)

  it("has what the project says of its class, members that are classes, too", function()
    local project = {
      propertyTypes = {
        { name = "Mode", type = "enum", values = { "a" } },
        {
          name = "Pull",
          type = "class",
          members = {
            { name = "gravity", type = "float", value = 5 },
            { name = "drag", type = "float", value = 1 },
            { name = "again", type = "class", propertyType = "Pull", value = {} },
          },
        },
        {
          name = "Water",
          type = "class",
          members = {
            { name = "sensor", type = "bool", value = true },
            { name = "static", type = "bool", value = true },
            { name = "depth", type = "int", value = 3 },
            { name = "pull", type = "class", propertyType = "Pull", value = { drag = 2 } },
          },
        },
      },
    }
    local water = newBox("Water", { depth = 4, pull = { gravity = 7 } })
    local map = newMap({ tiled.objects(1, "things", { water, newBox("Water") }) })
    local level = load(map, { project = project })
    assert.same({ 7, 2 }, { level.sensors[1].pull.gravity, level.sensors[1].pull.drag })
    assert.same(
      { 4, 3, 5 },
      { level.sensors[1].depth, level.sensors[2].depth, level.sensors[2].pull.gravity }
    )
    assert.is_nil(load(map).sensors[2].depth)
  end)

  it("is found by what a property refers to", function()
    local door = newBox("", { target = { id = 7 } })
    local point = tiled.object(7, 5, 6, 0, 0, { shape = "point" })
    local level = load(newMap({ tiled.objects(1, "things", { door, point }) }))
    assert.equal(level.points[1], level.byId[level.objects[1].target.id])
    assert.equal(level.objects[1], level.byId[1])
  end)
end)

describe("the name of a layer", function()
  for name, isWall in pairs({
    ["Collision LAyer"] = true,
    ["Platforms lvl"] = true,
    TopWall = true,
    collisions_1 = true,
    ["Wall Layer"] = true,
    WALLS = true,
    ["solid-tiles"] = true,
    boundaries = true,
    frontWalls = true,
    BackGround = false,
    wall_decor = false,
    backWalls = false,
    ["Parallax ground"] = false,
    ["fg platforms"] = false,
    Foreground = false,
    grounded = false,
    wallpaper = false,
    ["Décor mur"] = false,
  }) do
    it(("%s is that of %s"):format(name, isWall and "walls" or "no walls"), function()
      local level = load(newMap({ tiled.tiles(1, name, { "1." }) }))
      assert.equal(isWall and 1 or 0, #level.walls)
    end)
  end

  it("means what the game's own words say", function()
    local map = newMap({ tiled.tiles(1, "Mur", { "1." }), tiled.tiles(2, "Mur du fond", { ".1" }) })
    assert.equal(2, #load(map, { wallWords = { "mur" } }).walls)
    assert.equal(1, #load(map, { wallWords = { "mur" }, pictureWords = { "fond" } }).walls)
    assert.equal(
      0,
      #load(newMap({ tiled.tiles(1, "Walls", { "1." }) }), { wallWords = { "mur" } }).walls
    )
  end)
end)

describe("lines in a wall layer", function()
  it("are thin walls where they are level or upright, and named where they slope", function()
    local points = { { x = 0, y = 0 }, { x = 32, y = 0 }, { x = 32, y = 48 }, { x = 64, y = 60 } }
    local line = tiled.object(1, 8, 16, 0, 0, { shape = "polyline", polyline = points })
    local level, world = load(newMap({ tiled.objects(1, "walls", { line, tiled.copy(line) }) }))
    assert.same(
      { "8 16 32 1", "40 16 1 48", "8 16 32 1", "40 16 1 48" },
      tiled.boxes(world, "walls")
    )
    assert.same({ "polyline: a sloped part has no width x2" }, reasonsOf(level))
    assert.same({ 2, 4 }, { #level.lines, #level.walls })
    assert.equal(0, #load(newMap({ tiled.objects(1, "paths", { line }) })).objects)
  end)
end)

describe("a map without a wall", function()
  local function newTiles()
    return newMap({
      tiled.tiles(1, "backdrop", { "1111", "11.1" }),
      tiled.tiles(2, "stuff", { "1..." }),
      tiled.tiles(3, "main", { "11..", "1..." }),
      tiled.objects(4, "things", { newBox() }),
    })
  end

  it("is loaded, and says what to write", function()
    local level = load(newTiles())
    assert.same({ "map", "" }, { level.unsupported[1].kind, level.unsupported[1].layer })
    local cure = 'if that is wrong, write solidLayers = { "main" }; its layers are "backdrop", '
      .. '"stuff", "main", "things"'
    assert.same({ "no part of the map is solid: " .. cure }, reasonsOf(level))
    assert.equal(2, #load(newTiles(), { solidLayers = { "main" } }).walls)
  end)

  it("is told by one line in a checked world", function()
    local lines = printed(function()
      return load(newTiles(), nil, { checked = true })
    end)
    assert.equal(1, #lines)
    assert.truthy(
      lines[1]:find("^physics: world:loadTiled%(map, options%): no part of the map is solid")
    )
    assert.same({}, (printed(function()
      return load(newTiles(), { solidLayers = { "main" } }, { checked = true })
    end)))
  end)

  it("of LDtk says so, too, with its values or tiles", function()
    local tiles = ldtk.intGrid("Rocks", { "..." }, { __type = "Tiles" })
    tiles.gridTiles = { { px = { 16, 0 }, t = 7 }, { px = { 32, 0 }, t = 0 } }
    local level = loadLDtk({ tiles })
    assert.truthy(reasonsOf(level)[1]:find('write kinds = { Rocks = "static" }', 1, true))
    local solid, world = loadLDtk({ tiles }, { kinds = { Rocks = "static" } })
    assert.same({ "16 0 32 16" }, tiled.boxes(world, "Rocks"))
    assert.same({ 7, 0, -1 }, {
      solid.tileLayers.Rocks:getTile(1, 0),
      solid.tileLayers.Rocks:getTile(2, 0),
      solid.tileLayers.Rocks:getTile(0, 0),
    })
    level = loadLDtk({ ldtk.intGrid("Cells", { "1" }) }, nil, { "water", "wall" })
    assert.truthy(reasonsOf(level)[1]:find('write solid = { ["water"] = true }', 1, true))
  end)
end)

describe("a level", function()
  it("lists what it has made", function()
    local objects = {
      newBox("Wall"),
      newBox("Wall", { oneWay = true }),
      newBox("Portal"),
      newBox("Crate", { mass = 1 }),
      newBox("Lift", { kinematic = true }),
      newBox("Wall", { slope = "left" }),
      tiled.object(9, 0, 16, 16, 16, { gid = 1 }),
    }
    local level = load(newMap({ tiled.objects(1, "things", objects) }))
    local counts = {}
    local names = "objects walls solids sensors dynamic oneWays slopes pictures"
    for name in names:gmatch("%a+") do
      counts[#counts + 1] = name .. " " .. #level[name]
    end
    assert.equal(
      "objects 6, walls 3, solids 5, sensors 1, dynamic 1, oneWays 1, slopes 1, pictures 1",
      table.concat(counts, ", ")
    )
    assert.equal(objects[7], level.pictures[1].tiled.object)
  end)

  it(
    "names each kind of trouble once in a layer, and nothing that is as the editor says",
    function()
      local objects = {}
      for i = 1, 50 do
        objects[i] = newBox("", { width = i % 2 == 0 and 32 or 9, height = 16 })
      end
      local level = load(newMap({ tiled.objects(1, "things", objects) }), { solidLayers = {} })
      assert.equal('property "width": the editor\'s own value counts x25', reasonsOf(level)[1])
    end
  )

  it("says that its map is there already", function()
    local map, world = newMap({ tiled.tiles(1, "walls", { "1." }) }), physics.newWorld()
    local first = world:loadTiled(map)
    assert.same({}, first.unsupported)
    assert.same(
      { "the map is here already: all of it is there twice" },
      reasonsOf(world:loadTiled(map))
    )
    assert.same({}, world:loadTiled(map, { x = 99 }).unsupported)
    assert.same({}, physics.newWorld():loadTiled(map).unsupported)
  end)

  it("of a checked world is not loaded with a slip, unless that is the game's own", function()
    local map = newMap({ tiled.objects(1, "walls", { newBox("", { Mass = 5 }) }) })
    local isDone, message = pcall(load, map, nil, { checked = true })
    assert.is_false(isDone)
    local cure = 'layer "walls", object 1: property "Mass": did you mean mass? If it is the '
      .. 'game\'s own: ignore = { "Mass" }'
    assert.truthy(message:find(cure, 1, true), message)
    local _, world = load(map, { ignore = { "Mass" } }, { checked = true })
    world:update(1 / 60)
    assert.equal(5, load(map).walls[1].Mass)
  end)
end)

describe("a level of LDtk", function()
  it("takes groups of values and tags of entities for kinds", function()
    local cells = ldtk.intGrid("Cells", { "123" })
    local box = ldtk.entity("Box", 32, 32, 16, 16, nil, { __tags = { "movable" } })
    local project = ldtk.project(
      { ldtk.level("Cave", { ldtk.entities("Things", { box }), cells }) },
      { "dirt", "stone", "fog" }
    )
    local definition = project.defs.layers[1]
    definition.intGridValuesGroups = { { uid = 4, identifier = "Hard" } }
    definition.intGridValues[1].groupUid, definition.intGridValues[2].groupUid = 4, 4
    local options =
      { solid = { Hard = true, stone = { sensor = true } }, kinds = { movable = "dynamic" } }
    local level = physics.newWorld():loadLDtk(project, nil, options)
    assert.same({ 1, 1, 1 }, { #level.walls, #level.sensors, #level.dynamic })
    definition.intGridValuesGroups[1].identifier = "Walls"
    assert.equal(32, physics.newWorld():loadLDtk(project).walls[1].width)
  end)
end)

describe("a world of several maps", function()
  local function newLevel(options)
    local world = physics.newWorld({ gravity = 800 })
    local maps = {
      { fileName = "course.tmx", x = 0, y = 0, width = 320, height = 192 },
      { fileName = "meadow.tmx", x = 320, y = 32, width = 128, height = 64 },
    }
    options = tiled.copyInto({ folder = "spec/maps" }, options)
    return world:loadTiled({ type = "world", maps = maps }, options), world
  end

  local function count(world)
    world:update(1 / 60)
    return world.stats.objects
  end

  it("is one level, each map in its place", function()
    local level, world = newLevel({ x = 100 })
    local course, meadow = level.maps[1].level, level.maps[2].level
    assert.same({ 100, 0, 420, 32 }, { course.x, course.y, meadow.x, meadow.y })
    for _, name in ipairs({ "objects", "walls", "sensors", "points", "unsupported" }) do
      assert.equal(#course[name] + #meadow[name], #level[name], name)
    end
    assert.equal(course.tiles + meadow.tiles, level.tiles)
    assert.equal(level.named.hero, meadow.named.hero)
    assert.equal(#level.objects, count(world))
  end)

  it("comes and goes map by map, dug or not", function()
    local level, world = newLevel({ later = true })
    assert.same({ 0, 0 }, { #level.objects, count(world) })
    local meadow = level:addMap("meadow")
    assert.equal(meadow, level:addMap("meadow"))
    local before = count(world)
    assert.same({ before, meadow.walls[1] }, { #level.objects, level.walls[1] })
    for _, tiles in pairs(meadow.tileLayers) do
      for column = 0, 4 do
        tiles:setTile(column, tiles.rows - 1, 0)
      end
    end
    meadow.objects[1].x = meadow.objects[1].x + 500
    assert.is_true(level:removeMap("meadow"))
    assert.is_false(level:removeMap("meadow"))
    assert.same({ 0, 0 }, { #level.objects, count(world) })
    level:addMap("meadow")
    assert.equal(before, count(world))
  end)

  it("refuses a map that it does not have, and calls without a colon", function()
    local level = newLevel({ later = true })
    local isDone, message = pcall(level.addMap, level, "cave")
    assert.is_false(isDone)
    assert.truthy(
      message:find(
        'name must be a map of the world, got "cave"; they are "course", "meadow"',
        1,
        true
      )
    )
    assert.is_false((pcall(level.removeMap, "course")))
  end)
end)
