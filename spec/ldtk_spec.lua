--- Levels of the editor LDtk: cells, entities, what is solid, and what is refused.

local ldtk = require("spec.support.ldtk")
local physics = require("physics")
local tiled = require("spec.support.tiled")

local WHERE = "world:loadLDtk(project, level, options): "
local VALUES = { "dirt", "ladder", "stone" }

local boxes = tiled.boxes

local function load(project, level, options)
  local world = physics.newWorld({ gravity = 800 })
  local found = world:loadLDtk(project, level, options)
  return found, world
end

--- A level with cells, a player, a chest and a door.
local function newProject(values)
  local rows = {
    "2....",
    "2....",
    "11133",
  }
  local things = ldtk.entities("Entities", {
    ldtk.entity("Player", 24, 32, 16, 24, { lives = 3, items = { "Knife", "Boots" } }),
    ldtk.entity("Chest", 56, 32, 16, 16, { solid = true, name = "treasure" }),
    ldtk.entity("Chest", 72, 32, 16, 16, { friction = 0.5 }, { iid = "second" }),
    ldtk.entity("Door", 0, 0, 8, 32, {}, { __pivot = { 0, 0 } }),
  })
  local layers = { things, ldtk.intGrid("Collisions", rows) }
  return ldtk.project({ ldtk.level("Cave", layers) }, values or VALUES)
end

describe("world:loadLDtk", function()
  it("merges the cells of IntGrid layers, by the values that are solid", function()
    local project = newProject()
    local level, world = load(project, nil, { solid = { dirt = true, [3] = true } })
    assert.same({ "0 32 80 16" }, boxes(world, "Collisions"))
    assert.same({ 5, 1 }, { level.tiles, level.rectangles })
    local floor = world.objects.Collisions[1]
    assert.is_true(floor.static)
    local cell = floor.ldtk
    assert.same({ 0, 2, 5, 1 }, { cell.column, cell.row, cell.columns, cell.rows })
    assert.is_nil(floor.ldtk.value) -- two of them
    assert.equal(project.levels[1].layerInstances[2], floor.ldtk.layer)
    assert.equal(1, #level.solidLayers)
    assert.equal('option solid: "dirt", "stone"', level.solidLayers[1].reason)
  end)

  it("gives values fields", function()
    local _, world = load(newProject(), nil, {
      solid = {
        dirt = true,
        ladder = { sensor = true, group = "ladders", merge = true },
        stone = { friction = 0.9, material = "stone" },
      },
    })
    assert.same({ "0 32 48 16", "48 32 32 16" }, boxes(world, "Collisions"))
    assert.same({ "0 0 16 32" }, boxes(world, "ladders"))
    assert.is_true(world.objects.ladders[1].sensor)
    assert.equal("stone", world.objects.Collisions[2].material)
  end)

  describe("without the option solid", function()
    it("takes values with a name that says so", function()
      local level, world = load(newProject({ "Walls", "water", "ground" }))
      assert.same({ "0 32 80 16" }, boxes(world, "Collisions"))
      assert.equal('its values "Walls", "ground"', level.solidLayers[1].reason)
    end)

    it("takes all values if no name says so", function()
      local level, world = load(newProject())
      assert.same({ "0 0 16 32", "0 32 80 16" }, boxes(world, "Collisions"))
      assert.equal('its values "dirt", "ladder", "stone"', level.solidLayers[1].reason)
      level, world = load(newProject({ false, false, false }))
      assert.equal(2, #boxes(world, "Collisions"))
      assert.equal("its values 1, 2, 3", level.solidLayers[1].reason)
    end)
  end)

  it("adds entities by their pivot, to the group of their identifier", function()
    local level, world = load(newProject(), nil, { kinds = { Player = "dynamic" } })
    assert.same({ "16 8 16 24" }, boxes(world, "Player"))
    assert.same({ "48 16 16 16", "64 16 16 16" }, boxes(world, "Chest"))
    assert.same({ "0 0 8 32" }, boxes(world, "Door"))
    local player, chest = level.named.Player, level.named.treasure
    assert.same({ 3, { "Knife", "Boots" }, "Player" }, { player.lives, player.items, player.type })
    assert.is_nil(player.static)
    assert.is_true(chest.static)
    assert.equal(chest, level.named.Chest)
    assert.equal(chest, world.objects.Chest[1])
    assert.equal(world.objects.Chest[2], level.byIid.second)
    assert.equal("entity-Player", player.ldtk.entity.iid)
    assert.equal(0.5, world.objects.Chest[2].friction)
    assert.same({}, level.unsupported)
  end)

  it("to other groups, by the option groups or the field group", function()
    local project = newProject()
    local entities = project.levels[1].layerInstances[1].entityInstances
    entities[4] = ldtk.entity("Door", 0, 0, 8, 32, { group = "exits" })
    local _, world = load(project, nil, { groups = { Player = "players", Door = "doors" } })
    assert.equal(1, #world.objects.players)
    assert.equal(1, #world.objects.exits)
    assert.is_nil(world.objects.doors)
    assert.is_nil(world.objects.Player)
    assert.equal(2, #world.objects.Chest)
  end)

  it("keeps a field named type, and leaves out what says solid = false", function()
    local project = newProject()
    project.levels[1].layerInstances[1].entityInstances = {
      ldtk.entity("Mob", 8, 8, 8, 8, { type = "slime" }),
      ldtk.entity("Mark", 8, 8, 8, 8, { solid = false }),
    }
    local level, world = load(project)
    assert.equal("slime", world.objects.Mob[1].type)
    assert.is_nil(world.objects.Mark)
    assert.is_nil(level.named.Mark)
  end)

  it("goes on with the world, and shares no table with the project", function()
    local options = { solid = { dirt = true, stone = true }, kinds = { Player = "dynamic" } }
    local project = newProject()
    local before = tiled.copy(project)
    local level, world = load(project, nil, options)
    for _ = 1, 60 do
      world:update(1 / 60)
    end
    assert.equal(8, level.named.Player.y)
    assert.equal(level.named.Player.touching.bottom, world.objects.Collisions[1])
    level.named.Player.items[1] = "Sword"
    assert.same(before, project)
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
    assert.same({ music = "cave" }, level.fields)
    assert.equal(project.levels[1], level.level)
  end)

  it("digs, counted from 0 as in the editor", function()
    local level, world = load(newProject(), nil, { solid = { dirt = true, stone = true } })
    local tiles = level.tileLayers.Collisions
    assert.is_true(tiles:setTile(1, 2, 0))
    assert.same({ "0 32 16 16", "32 32 48 16" }, boxes(world, "Collisions"))
    assert.same({ 0, 1, 2 }, { tiles:getTile(1, 2), tiles:getTile(0, 2), tiles:getTile(0, 0) })
    tiles:setTile(1, 2, 3)
    assert.same({ "0 32 80 16" }, boxes(world, "Collisions"))
    for _, row in ipairs({ { 7, "7" }, { "dirt", '"dirt"' } }) do
      local isDone, message = pcall(tiles.setTile, tiles, 1, 1, row[1])
      assert.is_false(isDone)
      local expected = "tiles:setTile(column, row, value): value must be 0 or a value of layer"
        .. ' "Collisions", got '
        .. row[2]
      assert.truthy(message:find(expected, 1, true), message)
    end
  end)

  describe("finds the level", function()
    local function newProjectOfTwo()
      local project = newProject()
      project.levels[2] = ldtk.level("Top", { ldtk.intGrid("Collisions", { "1" }) })
      return project
    end

    it("by identifier, iid and number, or takes the first", function()
      local project = newProjectOfTwo()
      for _, row in ipairs({ { nil, 1 }, { 1, 1 }, { "Top", 2 }, { "level-Top", 2 }, { 2, 2 } }) do
        assert.equal(project.levels[row[2]], load(project, row[1]).level)
      end
    end)

    it("in the worlds of a project of several", function()
      local project = newProjectOfTwo()
      project.worlds, project.levels = { { levels = project.levels } }, {}
      assert.equal("Top", load(project, "Top").level.identifier)
      assert.equal("Cave", load(project).level.identifier)
    end)

    it("itself, as from a .ldtkl file", function()
      local project = newProjectOfTwo()
      local level = project.levels[2]
      project.levels[2] = {
        identifier = "Top",
        externalRelPath = "cave/Top.ldtkl",
      }
      assert.equal(1, load(project, level).tiles)
      local isDone, message = pcall(load, project, "Top")
      assert.is_false(isDone)
      assert.truthy(
        message:find(WHERE .. 'level "Top" is in cave/Top.ldtkl: decode it and give that', 1, true)
      )
    end)
  end)

  it("reads only the layers that are wanted", function()
    local project = newProject()
    local _, world = load(project, nil, { onlyLayers = { "Entities" } })
    assert.is_nil(world.objects.Collisions)
    assert.equal(1, #world.objects.Player)
    _, world = load(project, nil, { skipLayers = { "Entities" } })
    assert.is_nil(world.objects.Player)
    local tiles = ldtk.intGrid("Background", { "." }, { __type = "Tiles" })
    project.levels[1].layerInstances[3] = tiles
    assert.same({}, load(project).unsupported)
    local level = load(project, nil, { onlyLayers = { "Background" } })
    assert.same({ 0, tiles }, { #level.objects, level.pictures[1] })
  end)

  it("names fields that cannot be, refuses them if strict, and leaves those of the game", function()
    local project = newProject()
    project.levels[1].layerInstances[1].entityInstances = {
      ldtk.entity("Mob", 8, 8, 8, 8, { drag = "yes", mass = "2", life = 5, x = 3 }),
    }
    local level, world = load(project)
    local mob = world.objects.Mob[1]
    assert.same({ 2, 5, 4 }, { mob.mass, mob.life, mob.x })
    assert.is_nil(mob.drag)
    local first, second = level.unsupported[1], level.unsupported[2]
    assert.equal('drag must be a number >= 0, got "yes"', first.reason)
    assert.equal('property "x": the editor\'s own value counts', second.reason)
    local place = { first.kind, first.layer, first.id, first.name }
    assert.same({ "object", "Entities", "entity-Mob", "Mob" }, place)
    assert.equal(1, #load(project, nil, { ignore = { "drag" } }).unsupported)
    local isDone, message = pcall(load, project, nil, { strict = true })
    assert.is_false(isDone)
    local expected = 'layer "Entities", entity "Mob": drag must be a number >= 0, got "yes"'
    assert.truthy(message:find(WHERE .. expected, 1, true), message)
  end)

  it("takes no notice of null, however a decoder says it", function()
    local project = newProject()
    local null = print -- json.null is a function in some, userdata in others
    project.levels[1].layerInstances[1].entityInstances = {
      ldtk.entity("Door", 8, 8, 8, 8, { lockedWith = null, mask = null }),
    }
    project.levels[1].externalRelPath = null
    local door = load(project).named.Door
    assert.is_nil(door.lockedWith)
    assert.is_nil(door.mask)
  end)

  -- dkjson comes with busted; elsewhere the spec has nothing to say.
  local hasJson, json = pcall(require, "dkjson")
  if hasJson then
    it("reads what a JSON library makes of a project", function()
      local project = json.decode((json.encode(newProject())))
      local level, world = load(project, "Cave", { solid = { dirt = true, stone = true } })
      assert.same({ "0 32 80 16" }, boxes(world, "Collisions"))
      assert.equal(3, level.named.Player.lives)
      assert.equal(5, level.tiles)
    end)
  end
end)
