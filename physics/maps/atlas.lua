---@diagnostic disable
--- A level of several maps, each in its place in the world of the editor. Adds maps and takes them
--- out again, and lists the objects of those that are there.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local check = require(root .. ".fields.check")
local level = require(root .. ".maps.level")
local properties = require(root .. ".maps.properties")
local recall = require(root .. ".maps.recall")

local atlas = {}

--- A map of a level of several maps.
---@class physics.AtlasMap
---@field name string its path in the world of the editor, without the ending: "caves/lake"
---@field x number px
---@field y number px
---@field width number? px
---@field height number? px
---@field level physics.Level? the objects that it has added, nil: it is not there

--- The part of a world that a world of Tiled or a project of LDtk has added. The lists are those
--- of all maps that are there. So are `named`, `byId`, `byIid` and `tileLayers`: the first map that
--- has a name counts. `x`, `y`, `width` and `height` are those of all maps.
---@class physics.Atlas: physics.Level
---@field maps physics.AtlasMap[] all maps, also those that are not there
---@field map table the decoded world or project
---@field package _world physics.World
---@field package _readMap function see `atlas.new`
---@field package _options table those of each map
---@field package _made table<table, table> map -> its level and layers, of those that are there
---@field package _there table<string, true> names of these
local Atlas = {}
Atlas.__index = Atlas

local LISTS, TABLES = level.LISTS, " byId byIid named tileLayers"

local function join(self, made)
  for name in LISTS:gmatch("%a+") do
    local list = self[name]
    for _, entry in ipairs(made[name]) do
      list[#list + 1] = entry
    end
  end
  for name in TABLES:gmatch("%a+") do
    self[name] = properties.join(made[name] or {}, self[name])
  end
  self.tiles, self.rectangles = self.tiles + made.tiles, self.rectangles + made.rectangles
end

local function find(self, call, name)
  local where = "level:" .. call
  check.self(self, Atlas, where, "a level of several maps")
  return level.pick(self.maps, name, where .. ": name", "a map of the world")
end

-- Reads those of these maps that are not there. Returns the argument for `_set`.
function Atlas._read(self, isWanted)
  local made = {}
  for _, map in ipairs(self.maps) do
    if isWanted[map.name] then
      local options = properties.join(self._options, { x = map.x, y = map.y })
      made[map] = self._made[map] or self._readMap(self._world, map.path, options)
    end
  end
  return made
end

-- Sets the maps that are there: by map its `level`, the `layers` of its tiles, and once a function
-- `add`.
function Atlas._set(self, made)
  self._made, self._there, self.tiles, self.rectangles = made, {}, 0, 0
  for name in (LISTS .. TABLES):gmatch("%a+") do
    self[name] = {}
  end
  for _, map in ipairs(self.maps) do
    local its = made[map] or {}
    map.level = its.level
    if its.add then
      its.add()
      its.add = nil
    end
    if map.level then
      self._there[map.name] = true
      join(self, map.level)
      map.width, map.height = map.level.width, map.level.height
    end
  end
  local boxes = self.maps[1] and self.maps or { { x = 0, y = 0 } }
  self.x, self.y, self.width, self.height = cells.around(boxes)
end

-- Lets a map be there, or not.
local function setThere(self, map, isThere)
  local names = properties.put({}, self._there)
  names[map.name] = isThere or nil
  self:_set(self:_read(names))
end

--- Makes a level of the maps of a world of the editor. Errors: one of them cannot be read.
---@param world table
---@param maps table[] physics.AtlasMap
---@param readMap function reads a map; returns its `level`, the `layers` of its tiles, and a
---  function `add` that adds them
---@param options table? as the game has given them; `later`: no map is there at first
---@param given table? the decoded world
---@param name string by which a state finds it
---@return physics.Atlas
function atlas.new(world, maps, readMap, options, given, name)
  local self = setmetatable({ maps = maps, map = given, _world = world, _made = {} }, Atlas)
  self._readMap, self._options = readMap, properties.put({}, options or {})
  self._options.folder = nil -- each map knows its own
  local names = {}
  for _, map in ipairs(maps) do
    map._baseX, map._baseY = map.x - world._shiftedX, map.y - world._shiftedY
    names[map.name] = not self._options.later or nil
  end
  self:_set(self:_read(names))
  recall.mapsOf(world).atlases[name] = self
  return self
end

--- Adds one map of the world, as its file is. Nothing happens if it is there.
---
--- Errors: the world has no map of that name; as in `loadTiled`; it is called from inside
--- `canCollide`. Nothing has changed then.
---@param name string as in `level.maps`
---@return physics.Level level the part of the world that it has added
function Atlas:addMap(name)
  local map = find(self, "addMap(name)", name)
  if not map.level then
    setThere(self, map, true)
  end
  return map.level
end

--- Takes one map of the world out again: its objects, wherever they are now, and its tiles.
---
--- Errors: the world has no map of that name; it is called from inside `canCollide`.
---@param name string as in `level.maps`
---@return boolean removed false: it was not there
function Atlas:removeMap(name)
  local map = find(self, "removeMap(name)", name)
  if not map.level then
    return false
  end
  for _, tiles in ipairs(self._made[map].layers) do
    tiles:unload()
  end
  for _, object in ipairs(map.level.objects) do
    self._world:remove(object)
  end
  setThere(self, map, false)
  return true
end

return atlas
