--- Levels of the editor LDtk: cells, entities, what is solid, and where it stands.

local ldtk = require("spec.support.ldtk")
local physics = require("physics")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

local VALUES = { "dirt", "ladder", "stone" }
local SOLID = { solid = { dirt = true, stone = true } }

local boxes = tiled.boxes

local function load(project, level, options)
  local world = physics.newWorld({ gravity = 800 })
  local found = world:loadLDtk(project, level, options)
  return found, world
end

--- A level with cells, a player, two chests and a door, or other entities.
local function newProject(values, entities)
  local things = ldtk.entities("Entities", entities or {
    ldtk.entity("Player", 24, 32, 16, 24, { lives = 3, items = { "Knife", "Boots" } }),
    ldtk.entity("Chest", 56, 32, 16, 16, { solid = true, name = "treasure" }),
    ldtk.entity("Chest", 72, 32, 16, 16, { friction = 0.5 }, { iid = "second" }),
    ldtk.entity("Door", 0, 0, 8, 32, {}, { __pivot = { 0, 0 } }),
  })
  local cells = ldtk.intGrid("Collisions", { "2....", "2....", "11133" })
  return ldtk.project({ ldtk.level("Cave", { things, cells }) }, values or VALUES)
end

describe("world:loadLDtk", function()
  -- The names of the values, the option solid, what is solid of the layer Collisions, and why.
  local FIELDS = { friction = 0.9, material = "stone" }
  local LADDER = { sensor = true, group = "ladders", merge = true }
  local WHOLE, FLOOR = "Collisions 0 32 80 16 static", "Collisions 0 32 48 16 static"
  local LADDERS, ONE_WAY = "Collisions 0 0 16 32 static", "Collisions 48 32 32 16 oneWay=top static"
  for i, row in ipairs({
    { VALUES, { dirt = true, [3] = true }, WHOLE, "option solid" },
    { VALUES, { dirt = true, [3] = false }, FLOOR, "option solid" },
    {
      VALUES,
      { dirt = true, ladder = LADDER, stone = FIELDS },
      "ladders 0 0 16 32 sensor static; "
        .. FLOOR
        .. "; Collisions 48 32 32 16 friction=0.9 material=stone static",
      "option solid",
    },
    { { "Walls", "water", "ground" }, nil, WHOLE, "its values" },
    { { "a", "decor", "b" }, nil, WHOLE, "its values" },
    { VALUES, nil, WHOLE, "its values" },
    { { "dirt", "lava_1", "semiSolid" }, nil, ONE_WAY, "its values" },
    { { "dirt", "Water Block", "stone" }, nil, LADDERS, "its values" },
    { { false, false, false }, nil, LADDERS .. "; " .. WHOLE, "its values" },
    { {}, nil, LADDERS .. "; " .. WHOLE, "its values" },
  }) do
    it(("makes cells solid, %d: %s"):format(i, row[4]), function()
      local level, world = load(newProject(row[1], {}), nil, { solid = row[2] })
      assert.equal(row[3], tiled.show(level, world))
      assert.same({ 1, row[4] }, { #level.solidLayers, level.solidLayers[1].reason })
    end)
  end

  it("takes the one-way side of a layer by its name", function()
    local cells = ldtk.intGrid("OneWay", { "12" })
    local level = load(ldtk.project({ ldtk.level("Cave", { cells }) }, { "dirt", "wall" }))
    assert.same({ 1, "top" }, { #level.walls, level.walls[1].oneWay })
  end)

  it("adds entities by their pivot, to the group of their identifier, named and kept", function()
    local project = newProject()
    local before = small.copy(project)
    local level, world =
      load(project, nil, { kinds = { Player = "dynamic" }, solid = { dirt = true, stone = true } })
    assert.equal(
      WHOLE
        .. "; Player 16 8 16 24 items={1=Knife 2=Boots} lives=3 type=Player"
        .. "; Chest 48 16 16 16 name=treasure static type=Chest"
        .. "; Chest 64 16 16 16 friction=0.5 sensor static type=Chest"
        .. "; Door 0 0 8 32 sensor static type=Door",
      tiled.show(level, world)
    )
    local named, player = level.named, level.named.Player
    assert.same({ named.Chest, world.objects.Chest[2] }, { named.treasure, level.byIid.second })
    local cell = world.objects.Collisions[1].ldtk
    assert.same({ 0, 2, 5, 1, nil }, { cell.column, cell.row, cell.columns, cell.rows, cell.value })
    assert.equal(project.levels[1].layerInstances[2], cell.layer)
    assert.equal("entity-Player", player.ldtk.entity.iid)
    player.items[1] = "Sword"
    small.run(world, 60)
    assert.same({ 8, before }, { player.y, project })
    assert.equal(player.touching.bottom, world.objects.Collisions[1])
  end)

  -- Fields and more of an entity, options: what stands there, or what is said of it.
  local DRAG = '! Entities: drag must be a number >= 0, got "yes"'
  local null = print -- json.null is a function in some decoders, userdata in others
  for i, row in ipairs({
    { { group = "exits" }, { groups = { Mob = "mobs" } }, "exits 4 0 8 8 sensor static type=Mob" },
    { {}, { groups = { Mob = "mobs" } }, "mobs 4 0 8 8 sensor static type=Mob" },
    { { type = "slime" }, nil, "Mob 4 0 8 8 sensor static type=slime" },
    { { solid = false }, nil, "" },
    { { key = null, mask = null }, nil, "Mob 4 0 8 8 sensor static type=Mob" },
    { { drag = "yes", mass = "2" }, nil, "Mob 4 0 8 8 mass=2 type=Mob; " .. DRAG },
    {
      { drag = "yes", radius = 4, restitution = 1 },
      { ignore = { "drag" } },
      "Mob 4 0 8 8 radius=4 restitution=1 sensor static type=Mob"
        .. "; ! Entities: drag: left out, by the option ignore",
    },
    { { x = 3, y = 8 }, nil, "Mob 4 0 8 8 sensor static type=Mob" },
  }) do
    it("reads the fields of an entity, " .. i, function()
      local level, world = load(
        newProject(nil, { ldtk.entity("Mob", 8, 8, 8, 8, row[1]) }),
        nil,
        small.set({ solid = {} }, row[2])
      )
      table.remove(level.unsupported) -- that there is no wall
      assert.equal(row[3], tiled.show(level, world))
    end)
  end

  it("refuses a field that cannot be if strict, at its place", function()
    local project = newProject(nil, { ldtk.entity("Mob", 8, 8, 8, 8, { drag = "yes" }) })
    local words = 'options): layer "Entities", entity "Mob": drag must be a number >= 0, got "yes"'
    small.refuses(words, load, project, nil, { strict = true })
    local entry = load(project).unsupported[1]
    assert.same({ "object", "entity-Mob", "Mob" }, { entry.kind, entry.id, entry.name })
  end)

  it("puts everything where the options and the layers say", function()
    local project = newProject()
    for _, layer in ipairs(project.levels[1].layerInstances) do
      layer.__pxTotalOffsetX, layer.__pxTotalOffsetY = 3, -5
    end
    local level, world = load(project, nil, { x = 512, y = -64, solid = { dirt = true } })
    assert.same({ "515 -37 48 16" }, boxes(world, "Collisions"))
    assert.same({ "531 -61 16 24" }, boxes(world, "Player"))
    assert.same({ 512, -64, 320, 160 }, { level.x, level.y, level.width, level.height })
    assert.same({ 512, -64 }, { level.worldX, level.worldY })
    assert.same({ { music = "cave" }, project.levels[1] }, { level.fields, level.level })
  end)

  it("digs, counted from 0 as in the editor", function()
    local level, world = load(newProject(), nil, SOLID)
    local tiles = level.tileLayers.Collisions
    assert.is_true(tiles:setTile(1, 2, 0))
    assert.same({ "0 32 16 16", "32 32 48 16" }, boxes(world, "Collisions"))
    assert.same({ 0, 1, 2 }, { tiles:getTile(1, 2), tiles:getTile(0, 2), tiles:getTile(0, 0) })
    tiles:setTile(1, 2, 3)
    assert.same({ "0 32 80 16" }, boxes(world, "Collisions"))
    for shown, value in pairs({ ["7"] = 7, ['"dirt"'] = "dirt" }) do
      local words = 'row, value): value must be 0 or a value of layer "Collisions", got '
      small.refuses(words .. shown, tiles.setTile, tiles, 1, 1, value)
    end
  end)

  it("finds the level by identifier, iid and number, in all worlds, or takes it", function()
    local project = newProject()
    project.levels[2] = ldtk.level("Top", { ldtk.intGrid("Collisions", { "1" }) })
    for _, row in ipairs({ { nil, 1 }, { 1, 1 }, { "Top", 2 }, { "level-Top", 2 }, { 2, 2 } }) do
      assert.equal(project.levels[row[2]], load(project, row[1]).level)
    end
    project.worlds, project.levels = { { levels = project.levels } }, {}
    assert.equal("Top", load(project, "Top").level.identifier)
    assert.equal("Cave", load(project).level.identifier)
    -- As from a .ldtkl file.
    assert.equal(1, load(project, project.worlds[1].levels[2]).tiles)
  end)

  it("reads only the layers that are wanted", function()
    local project = newProject()
    local background = ldtk.intGrid("Background", { "." }, { __type = "Tiles" })
    project.levels[1].layerInstances[3] = background
    for name, row in pairs({
      Entities = { 4, 0, { onlyLayers = { "Entities" } } },
      Collisions = { 1, 1, { skipLayers = { "Entities" } } },
      Background = { 0, 1, { onlyLayers = { "Background" } } },
      none = { 0, 0, { onlyLayers = {} } },
    }) do
      local level = load(project, nil, row[3])
      assert.same({ row[1], row[2] }, { #level.objects, #level.pictures }, name)
      assert.equal(row[2] == 1 and background or nil, level.pictures[1])
    end
  end)

  -- dkjson comes with busted; elsewhere the spec has nothing to say.
  local hasJson, json = pcall(require, "dkjson")
  if hasJson then
    it("reads what a JSON library makes of a project", function()
      local level, world = load(json.decode((json.encode(newProject()))), "Cave", SOLID)
      assert.same({ "0 32 80 16" }, boxes(world, "Collisions"))
      assert.same({ 3, 5 }, { level.named.Player.lives, level.tiles })
    end)
  end
end)
