--- Maps of the editor Tiled: what of layers, objects and words stands in the world, and where; what
--- is said of the rest. Most rows are read through STI as well.

local physics = require("physics")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

local load, show, boxes = tiled.load, tiled.show, tiled.boxes

local function map(layers, tiles, extra)
  return tiled.map({ tiled.tileset(tiles) }, layers, extra)
end

--- A map of one object layer.
local function things(objects, extra)
  return map({ tiled.objects(1, "things", objects, extra) })
end

--- A rectangle of 8 x 8 px.
local function box(x, properties, extra)
  local object = tiled.object(x, x, 0, 8, 8, extra)
  object.properties = properties or {}
  return object
end

describe("world:loadTiled, layers", function()
  local inner = tiled.group(2, "inner", {
    tiled.tiles(3, "ground", { "...", ".11" }, { offsetx = 3, offsety = 1 }),
    tiled.objects(4, "things", { tiled.object(1, 5, 6, 7, 8) }, { offsetx = -1 }),
  }, { offsetx = 20, offsety = 0.25, visible = false })
  local deep = tiled.group(1, "outer", { inner }, { offsetx = 100, offsety = -7.5 })
  local solid = { { id = 0, properties = { solid = true } } }
  local expected = "ground 139 9.75 32 16 static; things 124 -1.25 7 8 sensor static"
  tiled.row("have the sum of their offsets", map({ deep }, solid), expected, nil, false)

  it("have the sum of their offsets through STI, too", function()
    local level, world = load(tiled.sti(map({ deep }, solid), 500, 50))
    assert.same({ "639 59.75 32 16" }, boxes(world, "outer.inner.ground"))
    assert.same({ "624 48.75 7 8" }, boxes(world, "outer.inner.things"))
    assert.same({ 500, 50 }, { level.x, level.y })
  end)

  local list = { box(0), box(9, { friction = 0.3, kinematic = true }) }
  local inside =
    tiled.objects(1, "things", list, { properties = { friction = 0.2, mood = "dark" } })
  local around = { properties = { static = true, friction = 0.1, restitution = 1 } }
  expected = "things 0 0 8 8 friction=0.2 restitution=1 static; "
    .. "things 9 0 8 8 friction=0.3 kinematic restitution=1"
  local nested = map({ tiled.group(2, "all", { inside }, around) })
  tiled.row("give their properties to what is in them", nested, expected, nil, false)

  local image = { type = "imagelayer", name = "walls", properties = {} }
  tiled.row("of images have no boxes", map({ image }), "")
  image = { type = "imagelayer", name = "a", properties = { solid = true } }
  tiled.row("of images should be solid", map({ image }), "! a: image layer: it has no boxes")
  tiled.row("of STI", map({ { type = "customlayer", name = "a" } }), "")
  expected = '! a: unknown type of layer: "fog"'
  tiled.row("of another type", map({ { type = "fog", name = "a" } }), expected)

  local a, b = tiled.objects(1, "a", { box(0) }), tiled.objects(2, "b", { box(9) })
  local two, group = map({ a, b }), map({ tiled.group(9, "c", { a, b }) })
  expected = "b 9 0 8 8 sensor static"
  tiled.row("only one", two, expected, { onlyLayers = { "b" } })
  tiled.row("none", two, "", { onlyLayers = {} })
  tiled.row("all but one", two, expected, { skipLayers = { 1 } })
  local some = { onlyLayers = { 9 }, skipLayers = { "a" } }
  tiled.row("all of a group but one", group, expected, some, false)
  expected = "! %s: hexagonal map: only orthogonal ones have boxes"
  expected = expected:format("a") .. "; " .. expected:format("b")
  tiled.row("of a map of hexagons", map({ a, b }, nil, { orientation = "hexagonal" }), expected)

  it("may be empty, are added behind what is there, and share nothing with the map", function()
    local world, mask = physics.newWorld(), { players = false }
    local first = world:add("things", { x = -99, y = 0, width = 8, height = 8 })
    local given = things({ box(0), box(9) }, { properties = { mask = mask } })
    given.layers[2] = tiled.objects(2, "empty", {})
    local before = small.copy(given)
    local level = world:loadTiled(given, { kinds = { things = "dynamic" } })
    local one, other = level.objects[1], level.objects[2]
    assert.same({ first, one, other }, world.objects.things)
    assert.same({ {}, false }, { world.objects.empty, one.touching.bottom })
    one.mask.players = true
    assert.same({ false, before }, { other.mask.players, given })
  end)

  it("of an infinite map are parts in any order, which merge", function()
    local given = tiled.infinite()
    local parts = given.layers[1].chunks
    for _, order in ipairs({ { 1, 2, 3 }, { 3, 2, 1 } }) do
      given.layers[1].chunks = { parts[order[1]], parts[order[2]], parts[order[3]] }
      local level, world = load(given)
      assert.same({ "-32 8 64 16", "0 24 16 32", "0 56 16 16" }, boxes(world, "rocks"))
      assert.same({ -64, 0, 128, 64 }, { level.x, level.y, level.width, level.height })
      local place = level.objects[1].tiled
      assert.same(
        { -2, 0, 4, 1, 1 },
        { place.column, place.row, place.columns, place.rows, place.gid }
      )
      assert.same(show(level, world), show(load(tiled.sti(given))))
    end
  end)

  it("of a course that Tiled has exported are where its author has drawn them", function()
    local level, world = load("spec/maps/course.lua")
    assert.equal(
      table.concat({
        "scenery 0 144 320 16 static",
        "Platforms 0 144 320 16 static",
        "Platforms 48 96 64 16 static",
        "Platforms 208 96 16 48 static",
        "Platforms 240 64 64 16 static",
        "Platforms 240 80 16 32 static",
        "Platforms 128 96 32 8 kinematic name=lift",
        "Platforms 16 128 32 16 slope=right static",
        "Enemies 64 84 12 12 floating=true friction=1 name=slime sensor static type=enemy",
        "Enemies 192 128 16 16 name=crate sensor static type=crate",
        "point 24 120 name=player type=spawn",
        "line 128 96, 128 96, 128 48, 176 48 name=lift",
        "picture 32 16 32 32",
        '! Enemies: drag must be a number >= 0, got "true"',
      }, "; "),
      show(level, world)
    )
    small.run(world, 60)
    assert.equal(84, level.named.slime.y)
  end)

  it("lead to the map, and are found by name and id", function()
    local given = things({
      box(7, { target = { id = 8 } }, { name = "door" }),
      tiled.object(8, 0, 0, 0, 0, { shape = "point", name = "door" }),
    })
    local level = load(given)
    local door = level.objects[1]
    assert.equal(given.layers[1].objects[1], door.tiled.object)
    assert.equal(given.layers[1], door.tiled.layer)
    assert.equal(given, level.map)
    assert.same(
      { door, door, level.points[1] },
      { level.named.door, level.byId[7], level.byId[door.target.id] }
    )
  end)
end)

describe("world:loadTiled, objects", function()
  local crate = { mass = 3, friction = 0.5, label = "fragile" }
  local quarter = tiled.object(1, 4, 6, 8, 10, { properties = { friction = 0.25 } })
  local known = {
    crate = { { id = 2, type = "crate", properties = crate } },
    half = { tiled.shapes(2, { quarter }) },
    twice = { tiled.shapes(2, { tiled.object(1, 0, 0, 8, 8), tiled.object(2, 8, 8, 8, 8) }) },
    no = { { id = 2, properties = { solid = false } } },
  }
  tiled.text(
    [[
have a class | things | 0 0 8 8 type=exit type:own; 9 0 8 8 type=false class=new; 18 0 8 8 type:own
  things 0 0 8 8 sensor static type=exit; things 9 0 8 8 sensor static type=new
  things 18 0 8 8 sensor static type=own
are not there if they say so | things | 0 0 8 8 solid:false; 9 0 8 8; point 5 0 0 0 solid:false
  things 9 0 8 8 sensor static; point 5 0
with the fields of their tile | things | 0 16 16 16 gid=3 friction:0.7 | tiles = "crate"
  things 0 0 16 16 friction=0.7 label=fragile mass=3 type=crate
with the shape of their tile, scaled | things | 100 200 32 16 gid=3 | tiles = "half"
  things 108 190 16 10 friction=0.25 sensor static
flipped | things | 100 200 64 16 gid=2147483651; 100 200 16 32 gid=1073741827 | tiles = "half"
  things 116 190 32 10 friction=0.25 sensor static
  things 104 168 8 20 friction=0.25 sensor static
turned | things | 100 200 16 16 gid=3 rotation=90 | tiles = "half"
  things 100 204 10 8 friction=0.25 sensor static
with several shapes of their tile | things | 100 200 16 16 gid=3 | tiles = "twice"
  things 100 184 16 16 sensor static; ! things: its tile has 2 rectangles: the whole tile counts
with a tile that says no | things | 0 16 16 16 gid=3 solid:true | tiles = "no"
are points | things offsetx=100 | point 30 40 0 0 name=player type=spawn; 50 60 0 0 vx:5 | y = 99
  point 130 139 name=player type=spawn; point 150 159 vx=5
without a size on one side | things | 0 0 8 0; 0 0 0 8 gid=1
  ! things: it has no size x2
are lines | things offsetx=100 | polyline 100 200 0 0 0,0 30,0 30,40 name=path period:4
  line 200 200, 200 200, 230 200, 230 240 name=path period=4
are lines, turned | things | polyline 100 200 0 0 0,0 30,0 30,40 rotation=90
  line 100 200, 100 200, 100 230, 60 230
are lines, but no walls, in a solid layer | things solid:true | polyline 100 200 0 0 0,0 32,0 32,48
  line 100 200, 100 200, 132 200, 132 248
  ! things: polyline: a line has no width, draw rectangles or polygons
are only lines if they say so | things solid:true | polyline 0 0 0 0 0,0 32,0 solid:false
  line 0 0, 0 0, 32 0
are turned | things | 9 9 30 10 rotation=89.99999; 9 9 30 10 rotation=180; 9 9 30 10 rotation=-90
  things -1 9 10 30 sensor static; things -21 -1 30 10 sensor static
  things 9 -21 10 30 sensor static
are turned by hand | things | 9 9 30 10 rotation=89.6; 9 9 30 10 rotation=-179.83
  things -1 9 10 30 sensor static; things -21 -1 30 10 sensor static
turned by another angle | things | 0 0 8 8 rotation=30
  ! things: rotated by 30 degrees: boxes do not turn
with a tile, turned | things | 9 9 30 9 gid=1 name=a rotation=90; 9 9 30 9 gid=1 name=b rotation=180
  things 9 9 9 30 name=a sensor static; things -21 9 30 9 name=b sensor static
of other shapes | things | capsule 0 0 8 8; text 0 0 8 8
  ! things: capsule: only rectangles are boxes; ! things: text: only rectangles are boxes
are circles, no ellipses | things | ellipse 0 0 8 8; ellipse 0 0 16 8
  things 0 0 8 8 radius=4 sensor static; ! things: ellipse: only circles are round
  the option ellipses = "box" makes it a box
are circles by their radius, if it fits | things | 0 0 8 8 static:true radius:4; 0 0 8 8 radius:5
  things 0 0 8 8 radius=4 static; things 0 0 8 8 sensor static
  ! things: radius must be half of width and height, which are 8 and 8: it is left out
do not fall for what walls may have | things | 0 0 8 8 radius:96; 9 0 8 8 carry:false strength:2
  things 0 0 8 8 sensor static; things 9 0 8 8 carry=false sensor static strength=2
  ! things: radius must be half of width and height, which are 8 and 8: it is left out
are the boxes of ellipses | things | ellipse 0 0 16 8 | ellipses = "box"
  things 0 0 16 8 sensor static
are the circles in ellipses | things | ellipse 10 0 16 8 | ellipses = "circle"
  things 14 0 8 8 radius=4 sensor static
of several boxes stand | things | polygon 9 9 0 0 0,0 10,0 10,20 30,20 30,30 0,30 solid:true
  things 9 9 10 20 static; things 9 29 30 10 static
of several boxes do not move | things | polygon 9 9 0 0 0,0 10,0 10,20 30,20 30,30 0,30 static:false
  ! things: polygon of 2 boxes: only static ones hold together
of one box do | things | polygon 100 200 0 0 0,0 40,0 40,10 0,10 static:false
  things 100 200 40 10 static=false
that are slopes do not | things | polygon 100 200 0 0 0,16 32,0 32,16 static:false
  ! things: slope: only static and kinematic objects have it
are polygons, turned | things offsetx=7 | polygon 9 9 0 0 0,0 40,0 40,10 0,10 rotation=90 solid:true
  things 6 9 10 40 static
are mere pictures | things offsetx=5 | 100 200 32 16 gid=3 | y = 7
  picture 105 191 32 16
are no pictures with a name | things | 0 16 16 16 gid=3 name=cloud
  things 0 0 16 16 name=cloud sensor static
nor with a property | things | 0 16 16 16 gid=1 far:3; 9 16 16 16 gid=3 | tiles = "crate"
  things 0 0 16 16 far=3 sensor static
  things 9 0 16 16 friction=0.5 label=fragile mass=3 type=crate
nor in a layer with a word of ours | things gravity:0 | 0 16 16 16 gid=3
  things 0 0 16 16 gravity=0
nor of onlyLayers | things | 0 16 16 16 gid=3 | onlyLayers = { 1 }
  things 0 0 16 16 sensor static
in a group | things group:enemies | 0 0 8 8; 9 0 8 8 group:coins
  enemies 0 0 8 8 sensor static; coins 9 0 8 8 sensor static
have the size of the editor | things | 0 0 8 8 width:8 x:0; 0 0 8 8 width:9 x:1; 0 0 8 8 width:7
  things 0 0 8 8 sensor static; things 0 0 8 8 sensor static; things 0 0 8 8 sensor static
are walls by their layer before their mass | walls | 0 0 8 8 mass:2; 9 0 8 8 kinematic:true
  walls 0 0 8 8 mass=2 static; walls 9 0 8 8 kinematic
polygon, a rectangle | walls | polygon 0 0 0 0 0,0 40,0 40,10 0,10
  walls 0 0 40 10 static
polygon, the other way round | walls | polygon 0 0 0 0 0,0 0,10 40,10 40,0
  walls 0 0 40 10 static
polygon, closed by its first corner | walls | polygon 0 0 0 0 0,0 40,0 40,10 0,10 0,0
  walls 0 0 40 10 static
polygon, by a hand that trembles | walls | polygon 0 0 0 0 0,0 40,0.004 39.998,10 0,10.001
  walls 0 0 40 10 static
polygon, a box with corners off by a pixel | walls | polygon 0 0 0 0 0,0 40,0.7 39.2,30 -0.9,29.5
  walls 0 0 40 30 static
polygon, a hill with its foot off | walls | polygon 0 0 0 0 0,64.1 128,0 128,64
  walls 0 0 128 64.1 slope=right static
polygon, a slope with its wall off | walls | polygon 0 32 0 0 0,0 31.91,-31.64 32.18,0.09
  walls 0 0.36 31.91 31.64 slope=right static
polygon, of a tile in pixels, as drawn | walls | polygon 0 0 0 0 0,1 8,0 8,8 1,8 1,7 0,7
  walls 0 0 8 1 slope=right static; walls 0 1 8 6 static; walls 1 7 7 1 static
polygon, a curve in pixels, as drawn | walls | polygon 0 0 0 0 0,1.6 4,0.7 8,0 8,8 0,8
  walls 4 0 4 0.7 slope=right static; walls 0 0.7 4 0.9 slope=right static
  walls 4 0.7 4 0.9 static; walls 0 1.6 8 6.4 static
polygon, a U | walls | polygon 0 0 0 0 0,0 10,0 10,20 20,20 20,0 30,0 30,30 0,30
  walls 0 0 10 20 static; walls 20 0 10 20 static; walls 0 20 30 10 static
polygon, a stair | walls | polygon 0 0 0 0 0,0 10,0 10,10 20,10 20,20 0,20
  walls 0 0 10 10 static; walls 0 10 20 10 static
polygon, a triangle, high on the right | walls | polygon 0 0 0 0 0,16 32,0 32,16
  walls 0 0 32 16 slope=right static
polygon, a triangle that hangs on the left | walls | polygon 0 0 0 0 0,0 0,16 32,0
  walls 0 0 32 16 slope=topleft static
polygon, an overhang | walls | polygon 0 0 0 0 0,0 20,0 12,16 0,16
  walls 12 0 8 16 slope=topleft static; walls 0 0 12 16 static
polygon, a roof | walls | polygon 0 0 0 0 0,16 8,0 24,16
  walls 0 0 8 16 slope=right static; walls 8 0 16 16 slope=left static
polygon, a slope beside a step | walls | polygon 0 0 0 0 0,0 32,32 -16,32 -16,16 0,16
  walls 0 0 16 16 slope=left static; walls 16 16 16 16 slope=left static
  walls -16 16 32 16 static
polygon, a corner on an edge | walls | polygon 0 0 0 0 0,0 40,0 40,10 0,10 0,5
  walls 0 0 40 10 static
polygon, two towers | walls | polygon 0 0 0 0 0,0 10,0 10,30 30,30 30,10 40,10 40,40 0,40
  walls 0 0 10 30 static; walls 30 10 10 20 static; walls 0 30 40 10 static
polygon, a leaf | walls | polygon 0 0 0 0 0,0 16,4 16,16 0,12
  walls 0 0 16 4 slope=left static; walls 0 4 16 8 static; walls 0 12 16 4 slope=topright static
polygon, one that crosses itself | walls | polygon 0 0 0 0 0,0 16,16 0,16 16,0
  ! walls: polygon: it has thin parts that are no boxes, nor slopes
polygon, one without area | walls | polygon 0 0 0 0 0,0 16,0 0,0
  ! walls: polygon: it has no area
]],
    known
  )

  small.each("with a tile stand as the tileset says, {1}", {
    unspecified = { 100, 180 },
    topleft = { 100, 200 },
    topright = { 70, 200 },
    center = { 85, 190 },
    bottomright = { 70, 180 },
  }, function(name, row)
    local given = things({ tiled.object(1, 100, 200, 30, 20, { gid = 1, name = "tree" }) })
    given.tilesets[1].objectalignment = name
    local tree = load(given).objects[1]
    assert.same(row, { tree.x, tree.y })
  end)
end)

describe("world:loadTiled, words", function()
  for _, row in ipairs({
    { "friction", "1.00", 1 },
    { "mass", " 20.50 ", 20.5 },
    { "vx", "-3.5", -3.5 },
    { "static", "true", true },
    { "sensor", "False", false },
    { "oneWay", "true", "top" },
    { "oneWay", "left", "left" },
    { "oneWay", "false", nil },
    { "oneWay", false, nil },
    { "code", "007", "007" }, -- the game's own
    { "mask", { players = false, tiles = true }, { players = false, tiles = true } },
    { "loot", { "gold", { "key", 2 } }, { "gold", { "key", 2 } } },
  }) do
    it(("are values: %s = %q"):format(row[1], tostring(row[2])), function()
      local isWall = row[1] == "oneWay" or nil
      local level = load(things({ box(0, { [row[1]] = row[2], solid = isWall }) }))
      assert.same(row[3], level.objects[1][row[1]])
      assert.same({}, level.unsupported)
    end)
  end

  it("say yes and no in several ways", function()
    for _, value in ipairs({ "true", "yes", "1", 1 }) do
      assert.is_true(load(things({ box(0, { solid = value }) })).objects[1].static)
    end
    assert.same({}, load(things({ box(0, { solid = "false" }) })).objects)
  end)

  small.rows("that cannot be are named, unless they are the game's own: {3}", {
    { "drag", "true", 'drag must be a number >= 0, got "true"' },
    { "friction", "-1", "friction must be a number >= 0, got -1" },
    { "friction", 0 / 0, "friction must be a number >= 0, got nan" },
    { "oneWay", "up", 'oneWay must be true, false, "top", "bottom", "left" or "right", got "up"' },
    { "onBegin", "open", 'onBegin must be a function, got "open"' },
    { "solid", 2, "solid must be true or false, got 2" },
    { "group", true, "group must be a string or a number, got true" },
    { "mask", { players = "no" }, 'mask.players must be true or false, got "no"' },
  }, function(name, value, words)
    local given = things({ box(7, { [name] = value, lives = 3 }) })
    local level = load(given)
    assert.same({ 3, nil }, { level.objects[1].lives, rawget(level.objects[1], name) })
    local entry = level.unsupported[1]
    assert.same(
      { "object", "things", 7, words },
      { entry.kind, entry.layer, entry.id, entry.reason }
    )
    assert.equal(given.layers[1].objects[1], entry.object)
    small.refuses('layer "things", object 7: ' .. words, load, given, { strict = true })
    level = load(given, { ignore = { name }, strict = true })
    assert.equal(name .. ": left out, by the option ignore", level.unsupported[1].reason)
  end)

  it("of layers, tiles and shapes, too, with their ids", function()
    local tiles = {
      { id = 2, type = "crate", properties = { solid = true, friction = "wood" } },
      tiled.shapes(3, { tiled.object(5, 0, 0, 16, 8, { properties = { mass = -1 } }) }),
    }
    local inner = tiled.objects(3, "things", { box(0) })
    local level = load(map({
      tiled.tiles(1, "ground", { "34." }, { properties = { drag = "no" } }),
      tiled.group(2, "all", { inner }, { properties = { vx = "fast" } }),
    }, tiles))
    local list = {}
    for i, entry in ipairs(level.unsupported) do
      list[i] = ("%s %s %d: %s"):format(entry.kind, entry.layer, entry.id, entry.reason)
    end
    assert.same({
      'layer ground 1: drag must be a number >= 0, got "no"',
      'tile ground 2: friction must be a number >= 0, got "wood"',
      "tile ground 3: mass must be a number > 0, got -1",
      'layer all 2: vx must be a number, got "fast"',
    }, list)
    assert.equal(3, #level.objects)
  end)

  it("may be the same table twice", function()
    local loot = {}
    assert.same({ {}, {} }, load(things({ box(0, { loot = { loot, loot } }) })).objects[1].loot)
  end)
end)
