--- A map becomes a game: what is solid, what moves and what is only seen, what a level lists, and
--- what it says of a map that no one has made for this library.

local ldtk = require("spec.support.ldtk")
local physics = require("physics")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

local function newMap(layers, tiles)
  return tiled.map({ tiled.tileset(tiles) }, layers)
end

local function newBox(class, properties, extra)
  local object = tiled.object(1, 16, 16, 32, 16, extra)
  object.type, object.properties = class or "", properties or {}
  return object
end

--- A map of one object layer.
local function things(...)
  return newMap({ tiled.objects(1, "things", { ... }) })
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
  if not object then
    return "none"
  end
  local moves = object.static and "static" or object.kinematic and "kinematic" or "dynamic"
  return object.sensor and "sensor" or moves
end

-- "reason", or "reason x3" if it is true of three parts.
local function reasonsOf(level)
  local list = {}
  for i, entry in ipairs(level.unsupported) do
    list[i] = entry.count > 1 and entry.reason .. " x" .. entry.count or entry.reason
  end
  return table.concat(list, "; ")
end

-- The layers that were taken for solid, "name: reason".
local function solidOf(level)
  local list = {}
  for i, layer in ipairs(level.solidLayers) do
    list[i] = layer.name .. ": " .. layer.reason
  end
  return table.concat(list, "; ")
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

describe("loadTiled: an object of a map", function()
  local YES, NO, THINGS = { solid = true }, { solid = false }, { kinds = { things = "static" } }
  local HARD, CRATE = { solidProperty = "hard" }, { kinds = { Crate = "dynamic" } }
  local BOTH = { kinds = { things = "static", Crate = "dynamic" } }
  -- Its layer, its class, its properties, the options, what it is; the properties of its layer, the
  -- name and the properties of a layer around that.
  for i, row in ipairs({
    { "things", "", {}, nil, "sensor" },
    { "Portals", "", { color = "red", friction = 0.5 }, nil, "sensor" },
    { "Portals", "Wall", {}, nil, "static" },
    { "Walls", "Water", {}, { kinds = { Water = "sensor" } }, "sensor" },
    { "things", "Crate", {}, CRATE, "dynamic" },
    { "things", "Lift", {}, { kinds = { Lift = "kinematic" } }, "kinematic" },
    { "things", "", {}, { kinds = { things = "static" } }, "static" },
    { "things", "", {}, { kinds = { [1] = "static" } }, "static" },
    { "things", "Crate", {}, BOTH, "dynamic" },
    { "things", "Crate", { static = true }, CRATE, "static" },
    { "Dynamic things", "", {}, nil, "dynamic" },
    { "things", "KinematicLift", {}, nil, "kinematic" },
    { "things", "", { mass = 2 }, nil, "dynamic" },
    { "things", "", { oneWay = true }, nil, "static" },
    { "things", "", { slope = "left" }, nil, "static" },
    { "things", "", YES, nil, "static" },
    { "things", "", { collidable = true }, nil, "static" },
    { "things", "", { solid = false, collidable = true }, nil, "none" },
    { "things", "", { hard = true }, HARD, "static" },
    { "things", "", YES, HARD, "sensor" },
    { "things", "", {}, THINGS, "static" },
    { "things", "", {}, nil, "static", YES },
    { "things", "", { static = false }, nil, "dynamic", YES },
    { "things", "", YES, nil, "none", NO },
    { "things", "", {}, THINGS, "static", NO },
    { "Walls", "", {}, nil, "static" },
    { "walls", "", { static = false }, nil, "dynamic" },
    { "walls", "", NO, nil, "none" },
    { "things", "", {}, nil, "static", {}, "all", YES },
    { "things", "", {}, nil, "static", {}, "Collision", {} },
    { "things", "", {}, nil, "none", {}, "Collision", NO },
    { "things", "", {}, { kinds = { all = "static" } }, "static", {}, "all", {} },
  }) do
    it(("%d in the layer %s, of the class %q, is %s"):format(i, row[1], row[2], row[5]), function()
      local extra = { properties = row[6] }
      local layers = { tiled.objects(1, row[1], { newBox(row[2], row[3]) }, extra) }
      if row[7] then
        layers = { tiled.group(2, row[7], layers, { properties = row[8] }) }
      end
      assert.equal(row[5], kindOf(load(newMap(layers), row[4]).objects[1]))
    end)
  end

  it("with a tile is what its tile says, and no picture in a wall layer", function()
    local tiles = { { id = 0, properties = { collidable = true } } }
    for name, kind in pairs({ things = "none", walls = "static" }) do
      local object = tiled.object(1, 0, 16, 16, 16, { gid = 3 })
      local map = newMap({ tiled.objects(1, name, { object }) }, tiles)
      assert.equal(kind, kindOf(load(map).objects[1]))
      object.gid = 1
      assert.equal("static", kindOf(load(map).objects[1]))
      object.properties.static = false
      assert.equal("dynamic", kindOf(load(map).objects[1]))
    end
  end)

  it("that moves is no slope and has no one-way side: that is left out and named", function()
    local only = ": only static and kinematic objects have it"
    only = "slope" .. only .. "; oneWay" .. only
    local level, world =
      load(things(newBox("", { slope = "left", oneWay = "top", static = false })))
    assert.equal(only, reasonsOf(level))
    world:update(1 / 60)
    local entity = ldtk.entity("Box", 32, 32, 16, 16, { slope = "left", oneWay = "top", mass = 1 })
    local layers = { ldtk.entities("Things", { entity }) }
    level, world = loadLDtk(layers, { kinds = { Box = "dynamic" } })
    assert.equal(only, reasonsOf(level))
    world:update(1 / 60)
  end)

  it("with fields that do not fit each other loses one of them", function()
    local light = ldtk.entity("Light", 32, 32, 16, 16, { radius = 99 })
    local text = "radius must be half of width and height, which are 16 and 16: it is left out"
    assert.equal(text, reasonsOf((loadLDtk({ ldtk.entities("Things", { light }) }))))
  end)
end)

describe("loadTiled: the name of a layer", function()
  local walls = {
    "Collision LAyer, Platforms lvl, TopWall, collisions_1, WALLS, solid-tiles, boundaries, Static,"
      .. "terrain2, Water Blocks",
    "BackGround, wall_decor, backWalls, Parallax ground, fg platforms, grounded, Décor mur, Water,"
      .. "pit",
  }
  for i, names in ipairs(walls) do
    for name in names:gmatch("%s*([^,]+)") do
      it(name .. (i == 1 and " says wall" or " says no wall"), function()
        local level = load(newMap({ tiled.tiles(1, name, { "1." }) }))
        assert.equal(2 - i, #level.walls)
      end)
    end
  end

  -- The name of a layer, its properties, the options; the one-way side of its three parts: a tile
  -- that says nothing, one with a shape, a rectangle.
  local shape = { tiled.shapes(0, { tiled.object(1, 0, 0, 16, 8) }) }
  small.each("{1} says on which side its walls are solid", {
    OneWayPlatforms = { {}, nil, "top top top" },
    ["Semi Solids"] = { {}, nil, "top top top" },
    one_way = { {}, nil, "top top top" },
    semisolid = { { oneWay = "left" }, nil, "left left left" },
    ["oneway decor"] = { {}, nil, "none top none" },
    ["Stone Way Walls"] = { {}, nil, "false false false" },
    ["Oneway 2"] = { {}, { kinds = { "static" } }, "top top top" },
  }, function(name, row)
    local sides = {}
    for i, part in ipairs({
      tiled.tiles(1, name, { "5." }, { properties = row[1] }),
      tiled.tiles(1, name, { "1." }, { properties = row[1] }),
      tiled.objects(1, name, { newBox() }, { properties = row[1] }),
    }) do
      local other = tiled.tiles(2, "other", { "..." })
      local wall = load(newMap({ part, other }, shape), row[2]).walls[1]
      sides[i] = wall and tostring(wall.oneWay or false) or "none"
    end
    assert.equal(row[3], table.concat(sides, " "))
  end)

  it("is not among those of walls if its parts are sensors", function()
    local properties = { collidable = true, sensor = true }
    local layer = tiled.objects(1, "a", { newBox() }, { properties = properties })
    local level = load(newMap({ layer }))
    assert.same({ 1, "" }, { #level.sensors, solidOf(level) })
  end)

  -- The picture of a layer "collision", its tiles, options: how many are solid, and why.
  local shaped = { tiled.shapes(0, { tiled.object(1, 0, 8, 16, 8) }) }
  local BY_NAME = 'collision: its name, "collision"'
  for i, row in ipairs({
    { { "5.6", "555" }, nil, nil, 5, BY_NAME },
    { { "5.6", "555" }, { { id = 5, properties = { solid = false } } }, nil, 4, BY_NAME },
    -- only those that say so if any says so
    { { "1.6", "155" }, { { id = 0, properties = { solid = true } } }, nil, 2, "" },
    { { "1.6", "155" }, shaped, nil, 2, "" },
    { { "...", "..." }, nil, nil, 0, "" },
    -- a floor seen from above
    { { "556", "555" }, nil, nil, 0, "" },
    { { "556", "555" }, nil, { kinds = { "static" } }, 6, "collision: option kinds" },
    { { "556", "555" }, nil, { kinds = { collision = "static" } }, 6, "collision: option kinds" },
    { { "556", "555" }, nil, { kinds = { collision = "sensor" } }, 6, "" },
  }) do
    it(("makes tiles solid, %d: %d"):format(i, row[4]), function()
      local level = load(newMap({ tiled.tiles(1, "collision", row[1]) }, row[2]), row[3])
      assert.same({ row[4], row[5] }, { level.tiles, solidOf(level) })
    end)
  end

  it("is listed with the word that makes it solid", function()
    local map = newMap({
      tiled.objects(1, "a", { newBox() }, { properties = { collidable = true } }),
      tiled.objects(2, "b", { newBox() }),
      tiled.tiles(3, "c", { "5." }, { properties = { solid = true } }),
      tiled.tiles(4, "d", { "1." }),
      tiled.group(5, "walls", { tiled.objects(6, "inner", { newBox() }) }),
      { type = "imagelayer", id = 7, name = "ground", properties = {} },
    }, { { id = 0, properties = { solid = true } } })
    local head = 'a: property "collidable"; %sc: property "solid"%s'
    assert.equal(head:format("", '; inner: its name, "walls"'), solidOf(load(map)))
    local expected = head:format("b: option kinds; ", '; inner: its name, "walls"')
    assert.equal(expected, solidOf(load(map, { kinds = { b = "static" } })))
  end)
end)

describe("loadTiled: a map without a wall", function()
  local function newTiles()
    return newMap({
      tiled.tiles(1, "backdrop", { "1111", "11.1" }),
      tiled.tiles(2, "stuff", { "1..." }),
      tiled.tiles(3, "main", { "11..", "1..." }),
      tiled.tiles(4, "floor", { "1111", "1111" }),
      tiled.objects(5, "things", { newBox() }),
    })
  end
  local TEXT = "no part of the map is solid: if that is wrong, write %s; its layers are %s"
  local FOUND =
    TEXT:format('kinds = { ["NAME"] = "static" }', '"backdrop", "stuff", "main", "floor", "things"')

  it("is loaded, and says what to write; in a checked world in a line, too", function()
    local lines, level = printed(function()
      return (load(newTiles()))
    end)
    assert.same(
      { "map", "", FOUND, 0 },
      { level.unsupported[1].kind, level.unsupported[1].layer, reasonsOf(level), #lines }
    )
    assert.equal(2, #load(newTiles(), { kinds = { main = "static" } }).walls)
    for expected, options in pairs({
      ["physics: world:loadTiled(map, options): " .. FOUND] = {},
      [""] = { kinds = { main = "static" } },
    }) do
      lines = printed(function()
        load(newTiles(), options, { checked = true })
      end)
      assert.equal(expected, table.concat(lines, "; "))
    end
  end)

  it("and without tiles says so of its objects", function()
    local text = TEXT:format('kinds = { ["NAME"] = "static" }', '"things"')
    assert.same({ text, "" }, { reasonsOf((load(things(newBox())))), reasonsOf((load(things()))) })
    text = TEXT:format('kinds = { ["NAME"] = "static" }', '"main"')
    for picture, expected in pairs({ ["1.."] = text, ["..."] = "" }) do
      local level = load(newMap({ tiled.tiles(1, "main", { picture }) }))
      assert.equal(expected, reasonsOf(level))
    end
  end)

  it("of LDtk says so, too, with its values or tiles", function()
    local rocks = ldtk.intGrid("Rocks", { "..." }, { __type = "Tiles" })
    rocks.gridTiles =
      { { px = { 16, 0 }, t = 7 }, { px = { 32, 0 }, t = 0 }, { px = { 48, 0 }, t = 7 } }
    local level = loadLDtk({ rocks })
    local cure = 'solid = { ["VALUE"] = true }, or kinds = { ["LAYER"] = "static" }'
    assert.equal(TEXT:format(cure, '"Rocks"'), reasonsOf(level))
    local solid, world = loadLDtk({ rocks }, { kinds = { Rocks = "static" } })
    assert.same({ "16 0 32 16" }, tiled.boxes(world, "Rocks"))
    assert.equal("Rocks: option kinds", solidOf(solid))
    local tiles = solid.tileLayers.Rocks
    assert.same({ -1, 7, 0 }, { tiles:getTile(0, 0), tiles:getTile(1, 0), tiles:getTile(2, 0) })
    level = loadLDtk({ ldtk.intGrid("Cells", { "1" }) }, nil, { "water", "wall" })
    assert.equal(TEXT:format(cure, '"Cells"'), reasonsOf(level))
  end)
end)

describe("loadTiled: a level", function()
  it("lists what it has made", function()
    local level = load(
      things(
        newBox("Wall"),
        newBox("Wall", { oneWay = true }),
        newBox("Portal"),
        newBox("Crate", { mass = 1 }),
        newBox("Lift", { kinematic = true }),
        newBox("Wall", { slope = "left" }),
        tiled.object(9, 0, 16, 16, 16, { gid = 1 })
      )
    )
    local counts, names = {}, "objects walls solids sensors dynamic oneWays slopes pictures"
    for name in names:gmatch("%a+") do
      counts[#counts + 1] = #level[name]
    end
    assert.same({ 6, 3, 5, 1, 1, 1, 1, 1 }, counts)
  end)

  it("names each kind of trouble once in a layer, and no size of the editor", function()
    local objects = {}
    for i = 1, 50 do
      objects[i] = newBox("", { width = 9, drag = i % 2 == 0 and 32 or -1 })
    end
    local map = newMap({ tiled.objects(1, "things", objects) })
    local level = load(map, { kinds = { things = "static" } })
    assert.equal("drag must be a number >= 0, got -1 x25", reasonsOf(level))
  end)

  it("of a checked world is not loaded with a slip, unless that is the game's own", function()
    local tiles = { { id = 0, properties = { solid = true, Mass = 5 } } }
    for _, map in ipairs({
      newMap({ tiled.objects(1, "walls", { newBox("", { Mass = 5 }) }) }),
      newMap({ tiled.tiles(1, "walls", { "1." }) }, tiles),
    }) do
      local cure =
        ': property "Mass": did you mean mass? If it is the game\'s own: ignore = { "Mass" }'
      small.refuses(cure, load, map, nil, { checked = true })
      local _, world = load(map, { ignore = { "Mass" } }, { checked = true })
      world:update(1 / 60)
      assert.equal(5, load(map).walls[1].Mass)
    end
    tiles[1].properties = { Static = true }
    local map = newMap({ tiled.tiles(1, "ice", { "1." }) }, tiles)
    assert.equal(1, load(map, { solidProperty = "Static" }, { checked = true }).tiles)
  end)
end)

it("loadLDtk: a level takes groups of values and tags of entities for kinds", function()
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

it("world:loadTiled and world:loadLDtk give the objects of a class its metatable", function()
  local Class = { speed = 7 }
  Class.__index = Class
  local level = physics.newWorld():loadLDtk(ldtk.cave(), nil, { classes = { Player = Class } })
  local named = level.named
  assert.same(
    { Class, 7, 3 },
    { getmetatable(named.Player), named.Player.speed, named.Player.lives }
  )
  assert.is_nil(named.Door.speed)
  local path = "spec/maps/course.lua"
  named = physics.newWorld():loadTiled(path, { classes = { enemy = Class } }).named
  assert.same({ Class, 7, 12 }, { getmetatable(named.slime), named.slime.speed, named.slime.width })
  assert.is_nil(named.lift.speed)
  local words = "classes.enemy must be a table, got 1"
  local world = physics.newWorld()
  small.refuses(words, world.loadTiled, world, path, { classes = { enemy = 1 } })
end)

describe("level:addMap and level:removeMap: a world of several maps", function()
  local function newLevel(options)
    local world = physics.newWorld({ gravity = 800 })
    local maps = {
      { fileName = "course.tmx", x = 0, y = 0, width = 320, height = 192 },
      { fileName = "meadow.tmx", x = 320, y = 32, width = 128, height = 64 },
    }
    options = small.set({ folder = "spec/maps" }, options)
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
    assert.equal(level.named.slime, course.named.slime)
    assert.equal(#level.objects, count(world))
  end)

  it("comes and goes map by map, dug or not", function()
    local level, world = newLevel({ later = true })
    assert.same({ 0, 0 }, { #level.objects, count(world) })
    local course = level:addMap("course")
    assert.equal(course, level:addMap("course"))
    local before = count(world)
    assert.same({ before, course.walls[1] }, { #level.objects, level.walls[1] })
    for _, tiles in pairs(course.tileLayers) do
      for column = 0, 4 do
        tiles:setTile(column, tiles.rows - 1, 0)
      end
    end
    course.objects[1].x = course.objects[1].x + 500
    assert.same({ true, false }, { level:removeMap("course"), level:removeMap("course") })
    assert.same({ 0, 0 }, { #level.objects, count(world) })
    level:addMap("course")
    assert.equal(before, count(world))
  end)

  it("is all levels of a project of LDtk, which come and go, too", function()
    local project, world = ldtk.cave(), physics.newWorld()
    project.levels[2].worldX = 832
    local level = world:loadLDtk(project, nil, { all = true, later = true, x = 100 })
    assert.same({ 612, -64, 640, 160 }, { level.x, level.y, level.width, level.height })
    local top, cave = level:addMap("Top"), level:addMap("Cave")
    assert.same({ 932, 612, "cave" }, { top.x, cave.x, level.maps[1].level.fields.music })
    assert.same({ "Cave", "Top" }, { level.maps[1].name, level.maps[2].name })
    assert.equal(#top.objects + #cave.objects, count(world))
    assert.equal(cave.named.Player, level.byIid["entity-Player"])
    assert.same({ cave.tileLayers.Collisions, project }, { level.tileLayers.Collisions, level.map })
    assert.is_true(level:removeMap("Cave"))
    assert.same({ #top.objects, top.named.Door }, { count(world), level.named.Door })
    assert.equal(2, #physics.newWorld():loadLDtk(project, nil, { all = true }).maps)
  end)

  it("refuses a map that it does not have, and calls without a colon", function()
    local level = newLevel({ later = true })
    local words = 'name must be a map of the world, got "cave"; they are "course", "meadow"'
    small.refuses(words, level.addMap, level, "cave")
    assert.is_false((pcall(level.removeMap, "course")))
  end)
end)
