--- Maps of Tiled as JSON, by their paths: their tilesets and worlds. (That a decoded map is read as
--- its Lua export is in the rows of the other specs of Tiled.)

local physics = require("physics")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

-- What stands for JSON here, and for a decoder of it, is Lua.
local function decode(text)
  local compile = rawget(_G, "loadstring") or rawget(_G, "load")
  return assert(compile("return " .. text))(), #text
end

local MAP = [[{ type = "map", width = 8, height = 2, tilewidth = 16, tileheight = 16,
  tilesets = { { firstgid = 1, source = "sets/other.tsj" },
    { firstgid = 5, source = "sets/earth.tsj" } },
  layers = { { type = "tilelayer", id = 1, name = "land", width = 2, height = 1, data = { 5, 6 } },
    { type = "objectgroup", id = 2, name = "things", objects = { %s } } } }]]
local EARTH = [[{ name = "earth", tilewidth = 16, tileheight = 16, tilecount = 4, type = "tileset",
  tiles = { { id = 1, type = "rock",
    properties = { { name = "solid", type = "bool", value = true } } } } }]]
local CRATES = [[
  { id = 7, name = "crate", type = "Crate", gid = 2147483654, x = 40, y = 32, width = 32,
    height = 16, rotation = 0, properties = { { name = "mass", type = "int", value = 2 } } },
  { id = 8, template = "parts/crate.tj", x = 80, y = 32, name = "box" }]]

local FILES = {
  ["maps/cave.tmj"] = MAP:format(CRATES),
  ["maps/sets/earth.tsj"] = EARTH,
  ["maps/sets/other.tsj"] = EARTH,
  ["maps/all.world"] = [[{ maps = { { fileName = "cave.tmj", x = 100, y = 0 } } }]],
}

local REAL = rawget(_G, "love")

-- Pretends that LÖVE has these files, until the spec ends.
local function pretend(files)
  local asked, filesystem = {}, {}
  finally(function()
    rawset(_G, "love", REAL)
  end)
  function filesystem.getInfo(path)
    return files[path] and {}
  end
  function filesystem.read(path)
    asked[#asked + 1] = path
    return files[path], #files[path]
  end
  function filesystem.load(path)
    return function()
      return decode(files[path])
    end
  end
  function filesystem.getDirectoryItems()
    local names = {}
    for path in pairs(files) do
      names[#names + 1] = path:match("^maps/([^/]+)$")
    end
    return names
  end
  rawset(_G, "love", { filesystem = filesystem })
  return asked
end

local function load(path, options)
  local world = physics.newWorld()
  local level = world:loadTiled(path, small.set({ decode = decode }, options))
  return level, world
end

local ROCK = "land 16 0 16 16 static type=rock"

describe("world:loadTiled, JSON", function()
  it("is read by its path, with its tilesets, each file once", function()
    local asked = pretend(FILES)
    local crate = "; things 40 16 32 16 mass=2 name=crate static type=Crate"
    local cure = "export the map as Lua (File > Export As), tilesets embedded, templates detached"
    assert.equal(
      ROCK .. crate .. "; ! things: template: it is not read: " .. cure,
      tiled.show(load("maps/cave.tmj"))
    )
    table.sort(asked)
    local paths = "maps/cave.tmj maps/sets/earth.tsj maps/sets/other.tsj"
    assert.equal(paths, table.concat(asked, " "))
  end)

  it("is read without LÖVE, too", function()
    local path = os.tmpname()
    local file = assert(io.open(path .. ".tmj", "wb"))
    file:write(
      (MAP:gsub("%%s", ""):gsub("source = [^}]*", "name = 'a', tilecount = 2, tilewidth = 16"))
    )
    file:close()
    assert.equal(1, #load(path .. ".tmj", { kinds = { "static" } }).walls)
    os.remove(path)
    os.remove(path .. ".tmj")
  end)

  it("says which tileset cannot be read", function()
    local files = small.set({}, FILES)
    files["maps/sets/earth.tsj"] = nil
    pretend(files)
    local words = 'external ("sets/earth.tsj"): cannot read "maps/sets/earth.tsj": there is no such'
    assert.equal(words .. " file", load("maps/cave.tmj").unsupported[1].reason)
  end)

  it("has properties of all types, as the Lua export has them", function()
    local object = tiled.object(1, 0, 0, 8, 8)
    local inner = { { type = "int", value = 3 }, { type = "list", value = { { value = true } } } }
    object.properties = {
      { name = "target", type = "object", value = 7 },
      { name = "mask", type = "class", propertytype = "Mask", value = { players = false } },
      { name = "loot", type = "list", value = inner },
      { name = "drag", type = "float", value = 0.5 },
    }
    local made = load(tiled.map({}, { tiled.objects(1, "a", { object }) })).objects[1]
    assert.same({ { id = 7 }, { players = false }, { 3, { true } }, 0.5 }, {
      made.target,
      made.mask,
      made.loot,
      made.drag,
    })
  end)

  it("is refused if it cannot be decoded", function()
    pretend({ ["a.tmj"] = "{" })
    small.refuses('world:loadTiled(map): cannot read "a.tmj": ', load, "a.tmj")
    pretend({ ["a.tmj"] = "nil" })
    small.refuses('what "a.tmj" returns must be a table, got nil', load, "a.tmj")
  end)
end)

describe("world:loadTiled, a world of the editor", function()
  it("is read by its path, and has all that a level has", function()
    pretend(FILES)
    local level = load("maps/all.world", { x = 1000 })
    local cave = level.maps[1].level
    assert.same({ 1100, 0, 128, 32 }, { level.x, level.y, level.width, level.height })
    assert.same({ cave.objects[2], cave.tileLayers.land }, { level.byId[7], level.tileLayers.land })
    assert.equal("cave.tmj", level.map.maps[1].fileName)
    assert.same({ 1, 1, 1 }, { #level.dynamic + #level.walls - 1, level.tiles, level.rectangles })
    level:removeMap("cave")
    assert.same({ {}, {}, {} }, { level.byId, level.tileLayers, level.named })
    assert.same({ 1100, 128 }, { level.x, level.width })
  end)

  it("refuses patterns and a world without maps", function()
    local given = { patterns = { { regexp = "room-(\\d+)_(\\d+)\\.tmx$" } }, maps = {} }
    small.refuses("a world with patterns: list its maps", load, given, { folder = "maps" })
    small.refuses("map.maps must be a table, got nil", load, { type = "world" }, { folder = "a" })
  end)
end)
