--- Maps that are damaged at random: whatever is wrong with them, they are loaded or refused with a
--- message that blames the game's line, and the world goes on.

local effort = require("spec.support.effort")
local ldtk = require("spec.support.ldtk")
local physics = require("physics")
local random = require("spec.support.random")
local small = require("spec.support.small")
local tiled = require("spec.support.tiled")

local NAN, INF = 0 / 0, 1 / 0

-- What may stand in place of something.
local NONE = {}
local DAMAGE =
  { NONE, {}, { {} }, { 5 }, { x = 1 }, 5, -1, 1.5, 1e300, NAN, INF, true, "x", "", print }

local MAPS = { tiled.infinite() }
for i, name in ipairs({ "course", "meadow" }) do
  MAPS[i + 1] = dofile("spec/maps/" .. name .. ".lua")
end

-- All places in a map, { table, key }, in one order.
local function placesOf(value, list, seen)
  if seen[value] then
    return list
  end
  seen[value] = true
  local keys = {}
  for key in pairs(value) do
    keys[#keys + 1] = key
  end
  table.sort(keys, function(a, b)
    return type(a) == type(b) and a < b or type(a) < type(b)
  end)
  for _, key in ipairs(keys) do
    list[#list + 1] = { value, key }
    if type(value[key]) == "table" then
      placesOf(value[key], list, seen)
    end
  end
  return list
end

local function damage(map, generator)
  for _ = 1, generator:integer(1, 3) do
    local places = placesOf(map, {}, {})
    local place = generator:pick(places)
    local value = generator:pick(DAMAGE)
    place[1][place[2]] = value ~= NONE and small.copy(value) or nil
  end
end

-- Digs, goes and comes back, as far as the map allows.
local function tryTiles(level)
  for _, tiles in pairs(level.tileLayers) do
    tiles:setTile(tiles.firstColumn, tiles.firstRow, 0)
    tiles:unload()
    tiles:load()
  end
end

small.rows(
  "loadTiled and loadLDtk: a damaged one of {1} is refused or whole",
  { "Tiled", "LDtk" },
  function(kind)
    local loaded, refused = 0, 0
    for seed = 1, effort.share(300, 100) do
      local generator = random.new(seed * 31)
      local n = generator:integer(1, 4)
      local map = n == 4 and tiled.sti(MAPS[2]) or small.copy(MAPS[n])
      map = kind == "LDtk" and ldtk.cave() or map
      local options = { strict = generator:chance(0.2) }
      damage(map, generator)
      local world = physics.newWorld()
      world.objects.player = { x = 0, y = 0, width = 5, height = 5 }
      local isDone, level = pcall(function()
        if kind == "LDtk" then
          return (world:loadLDtk(map, nil, options))
        end
        return (world:loadTiled(map, options))
      end)
      if isDone then
        loaded = loaded + 1
        world:update(1 / 60)
        tryTiles(level)
        world:update(1 / 60)
      else
        refused = refused + 1
        assert.truthy(level:find("maps_damaged_spec.lua:%d+: physics: "), seed .. ": " .. level)
        assert.equal("player", next(world.objects))
        assert.is_nil(next(world.objects, "player"))
      end
    end
    assert.is_true(loaded > 10 and refused > 10)
  end
)
