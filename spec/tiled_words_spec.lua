--- Properties in maps of Tiled: strings of old maps, words of the game that are ours, too, and
--- values that cannot be.

local tiled = require("spec.support.tiled")

local load = tiled.load

--- One rectangle with properties.
local function loadOne(properties, options)
  local object = tiled.object(7, 0, 0, 8, 8, { properties = properties })
  local map = tiled.map({ tiled.tileset() }, { tiled.objects(3, "things", { object }) })
  local level, world = load(map, options)
  return level.objects[1], level, world
end

local function reasonsOf(level)
  local list = {}
  for i, part in ipairs(level.unsupported) do
    list[i] = ("%s %s %s: %s"):format(part.kind, part.layer, tostring(part.id), part.reason)
  end
  return list
end

describe("world:loadTiled, words", function()
  describe("makes values of strings", function()
    for _, row in ipairs({
      { "friction", "1.00", 1 },
      { "mass", " 20.50 ", 20.5 },
      { "vx", "-3.5", -3.5 },
      { "static", "true", true },
      { "sensor", "False", false },
      { "oneWay", "true", "top" },
      { "oneWay", "left", "left" },
      { "oneWay", true, "top" },
    }) do
      it(("%s = %q"):format(row[1], tostring(row[2])), function()
        local isWall = row[1] == "oneWay" or nil
        local object, level = loadOne({ [row[1]] = row[2], solid = isWall })
        assert.equal(row[3], object[row[1]])
        assert.same({}, level.unsupported)
      end)
    end

    it("oneWay = false, which is none", function()
      for _, value in ipairs({ "false", false }) do
        local object, level = loadOne({ oneWay = value })
        assert.is_nil(object.oneWay)
        assert.same({}, level.unsupported)
      end
    end)

    it("solid and merge", function()
      for _, value in ipairs({ "true", "yes", "1", 1 }) do
        assert.is_true(loadOne({ solid = value }).static)
      end
      assert.is_nil((loadOne({ solid = "false" })))
    end)

    it("but not of the game's own", function()
      local object = loadOne({ code = "007", open = "true" })
      assert.same({ "007", "true" }, { object.code, object.open })
    end)
  end)

  describe("names what cannot be, and loads the rest:", function()
    for _, row in ipairs({
      { "drag", "true", 'drag must be a number >= 0, got "true"' },
      { "friction", "0x10", 'friction must be a number >= 0, got "0x10"' },
      { "friction", "-1", "friction must be a number >= 0, got -1" },
      { "friction", 0 / 0, "friction must be a number >= 0, got nan" },
      { "mass", 0, "mass must be a number > 0, got 0" },
      {
        "oneWay",
        "up",
        'oneWay must be true, false, "top", "bottom", "left" or "right", got "up"',
      },
      { "onBegin", "open", 'onBegin must be a function, got "open"' },
      { "solid", 2, "solid must be true or false, got 2" },
      { "group", true, "group must be a string or a number, got true" },
    }) do
      it(row[3], function()
        local properties = { [row[1]] = row[2], lives = 3 }
        local object, level = loadOne(properties)
        assert.equal(3, object.lives)
        assert.not_equal(row[2], rawget(object, row[1]))
        assert.same({ "object things 7: " .. row[3] }, reasonsOf(level))
        assert.equal(properties, level.unsupported[1].object.properties)
        local isDone, message = pcall(loadOne, properties, { strict = true })
        assert.is_false(isDone)
        assert.truthy(message:find('layer "things", object 7: ' .. row[3], 1, true), message)
        local ignored, quiet = loadOne(properties, { ignore = { row[1] }, strict = true })
        assert.not_equal(row[2], rawget(ignored, row[1]))
        assert.same({}, quiet.unsupported)
        assert.equal(properties, ignored.tiled.object.properties) -- there it still is
      end)
    end

    it("of layers and tiles, too, with their ids", function()
      local set = tiled.tileset({
        { id = 2, type = "crate", properties = { solid = true, friction = "wood" } },
        tiled.shapes(3, { tiled.object(5, 0, 0, 16, 8, { properties = { mass = -1 } }) }),
      })
      local map = tiled.map({ set }, {
        tiled.tiles(1, "ground", { "34." }, { properties = { restitution = 2, drag = "no" } }),
        tiled.group(2, "all", {
          tiled.objects(3, "things", { tiled.object(1, 0, 0, 8, 8) }),
        }, { properties = { vx = "fast" } }),
      })
      local level = load(map)
      assert.same({
        'layer ground 1: drag must be a number >= 0, got "no"',
        "layer ground 1: restitution must be a number in 0..1, got 2",
        'tile ground 2: friction must be a number >= 0, got "wood"',
        "tile ground 3: mass must be a number > 0, got -1",
        'layer all 2: vx must be a number, got "fast"',
      }, reasonsOf(level))
      assert.equal(3, #level.objects)
    end)
  end)

  describe("takes what Tiled 1.12 has", function()
    it("lists and classes, as the game's own", function()
      local object = loadOne({
        loot = { "gold", { "key", 2 } },
        stats = { hp = 3, armor = { head = 1 } },
      })
      assert.same({ "gold", { "key", 2 } }, object.loot)
      assert.equal(1, object.stats.armor.head)
    end)

    it("a class as a mask", function()
      local object = loadOne({ mask = { players = false, tiles = true } })
      assert.same({ players = false, tiles = true }, object.mask)
      local _, level = loadOne({ mask = { players = "no" } })
      assert.same(
        { 'object things 7: mask.players must be true or false, got "no"' },
        reasonsOf(level)
      )
    end)

    it("but no table that holds itself", function()
      local loot = {}
      loot[1] = { loot }
      local isDone, message = pcall(loadOne, { loot = loot })
      assert.is_false(isDone)
      assert.truthy(
        message:find('object 7: property "loot" must not hold itself', 1, true),
        message
      )
      loot = {}
      assert.same({ {}, {} }, loadOne({ loot = { loot, loot } }).loot) -- twice is no circle
    end)
  end)
end)
