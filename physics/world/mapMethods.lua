--- The methods of a world that load maps.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local class = require(root .. ".world.class")
local lazy = require(root .. ".memory.lazy")

-- What is loaded when it is first used.
local array = lazy(root .. ".maps.array")
local ldtk = lazy(root .. ".maps.ldtk")
local tiled = lazy(root .. ".maps.tiled")
local tileLayers = lazy(root .. ".maps.tiles")

---@class (partial) physics.World
local World = class.World

local isFinite = check.isFinite
local checkSelf, checkIdle, checkObjects = class.checkSelf, class.checkIdle, class.checkObjects
local checkIsGroup, groupFor, put = class.checkIsGroup, class.groupFor, class.put

-- An object must be larger than this, px; physics/world/check.lua has the exact limit.
local SMALLEST = 1e-90

-- Functions of a world that layers of tiles use (physics/maps/tiles.lua).
local MAPS = { put = put, remove = World.remove }

function MAPS.check(self, where, groups)
  if self._bodies.asking then
    check.fail(where .. " cannot be called from inside canCollide")
  end
  checkObjects(self)
  for i = 1, #groups do
    checkIsGroup(self, groups[i], where)
  end
end

-- Checks a place and size. They are sums and products of a map's numbers, so they may be out of
-- range although those are not.
local function checkPlace(object, group, where)
  local isGood = isFinite(object.x) and isFinite(object.y)
  isGood = isGood and isFinite(object.width) and isFinite(object.height)
  isGood = isGood and object.radius == nil and object.area == nil -- these must fit to others
  if not (isGood and object.width > SMALLEST and object.height > SMALLEST) then
    check.object(object, where .. ": " .. check.place(group) .. "[n]")
  end
end

-- Checks whether objects can be put into these groups; their fields were checked before.
local function checkAll(self, objects, groupOf, groups, where)
  for i = 1, #groups do
    checkIsGroup(self, groups[i], where)
  end
  for i = 1, #objects do
    checkPlace(objects[i], groupOf[i], where)
  end
end

local function putAll(self, objects, groupOf)
  for i = 1, #objects do
    put(self, groupOf[i], objects[i])
  end
end

--- Adds the objects of a map of the editor Tiled, and its solid tiles, merged into few large
--- rectangles. The map is its Lua export (the table, or the path of the file), or the table that
--- STI makes of it. The map is not changed, and nothing is drawn. See docs/maps.md for all of it.
---
--- - The name of a layer is the group of its objects. Properties of an object are its fields.
---   Fields that the library knows are also taken from its tile, its layer and the layers around
---   it; the nearest one counts.
--- - `solid = true` (or `collidable`) on an object, a tile, a layer or a group of layers makes it
---   static, and `solid = false` leaves it out. The name of a layer (walls, collision, colliders,
---   solid, ground, platforms) does the same as `solid = true`, unless an option or a property says
---   otherwise. A tile is also solid if it has collision rectangles.
--- - Points are in `level.points`, lines in `level.lines`. Tile objects about which the map says
---   nothing are decoration, and not in the world.
---
--- Not supported, and listed in `unsupported` of the result: maps that are not orthogonal, objects
--- that are turned by other than quarters, polygons with other than level and upright edges,
--- ellipses that are no circles, capsules, texts, parallax, layers and tilesets that cannot be
--- read, and properties with values that cannot be used.
---
--- Errors: the map or the file does not exist; an unknown option; an option names a layer or a gid
--- that is not in the map; a layer in `solidLayers` cannot be read; a gid belongs to no tileset; a
--- part is malformed; with `strict` a property cannot be used; a group is an object; it is called
--- from inside `canCollide`. Nothing has been added then.
---@param map table|string the table that the export or STI returns, or the path of the export
---@param options physics.TiledOptions? where the map goes, and what of it is solid
---@return physics.Level level the objects that were added, counts, and what is not supported
function World:loadTiled(map, options)
  local call = "loadTiled(map, options)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  checkObjects(self)
  local level, groupOf, groups, tiles = tiled.read(map, options)
  checkAll(self, level.objects, groupOf, groups, "world:loadTiled(map)")
  for i = 1, #groups do
    groupFor(self, groups[i])
  end
  putAll(self, level.objects, groupOf)
  for i = 1, #tiles do
    tileLayers.attach(tiles[i], self, MAPS)
  end
  return level
end

--- Adds the tiles of a plain array. Each solid cell is static. Equal cells are merged into few
--- large objects, which changes no motion. One-way cells merge only along their solid side; sensors
--- and cells that move do not merge, unless their field `merge` says so. The result can change the
--- tiles: `tiles:setTile(column, row, value)`, `tiles:load()`, `tiles:unload()`.
---
--- The cells are one list, row by row, or a list of rows (`cells[row][column]`). A row may be a
--- string (`"##..#"`): each character is a cell. For a list of rows `columns` is nil, and a short
--- row ends with empty cells. Columns and rows are counted from 1. The cells are copied, so change
--- them with `setTile`, too. Each object has the field `tile` with its `tiles`, `column`, `row`,
--- `columns`, `rows` and `value`.
---
--- Errors: the group is not a name, or is an object; the cells are not a list; a list of values
--- ends within a row; a row is longer than `columns`; a cell is not a number, string or boolean;
--- the size is missing; an unknown option, or a wrong value for one; it is called from
--- inside `canCollide`. Nothing has been added then.
---@param group string|number name of their group; the field `group` of a value has precedence
---@param cells table list of values, or list of rows
---@param columns integer? of a list of values: how many are a row; nil for a list of rows
---@param size number|number[] px, of a cell: one number, or width and height
---@param options physics.TileOptions? which values are solid, and where the tiles go
---@return physics.Tiles tiles
---@diagnostic disable-next-line: redefined-local
function World:addTiles(group, cells, columns, size, options) -- luacheck: ignore 431
  local call = "addTiles(group, cells, columns, size, options)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  checkObjects(self)
  local tiles, objects, groupOf, later = array.read(group, cells, columns, size, options)
  checkIsGroup(self, group, "world:" .. call)
  checkAll(self, objects, groupOf, groupOf, "world:" .. call)
  groupFor(self, group)
  if not later then
    putAll(self, objects, groupOf)
  end
  tileLayers.attach(tiles, self, MAPS, later and objects)
  return tiles
end

--- Adds a level of the editor LDtk: the solid cells of its IntGrid layers, merged into few large
--- static objects, and its entities with their fields. Any JSON library decodes the project. The
--- project is not changed, and nothing is drawn. See docs/maps.md.
---
--- Cells are in the group of the identifier of their layer, entities in the group of their own
--- identifier. The fields `solid`, `group` and all fields of objects mean what they mean in a map
--- from Tiled.
---
--- Errors: the project or the level does not exist; the layers of the level are in another file; an
--- unknown option; an option names a layer or value that the level does not have; a part is
--- malformed; with `strict` a field cannot be used; a group is an object; it is called from inside
--- `canCollide`. Nothing has been added then.
---@param project table the .ldtk file, decoded by a JSON library
---@param level string|integer|table|nil its identifier, iid or number, or its decoded .ldtkl file;
---  default: the first level
---@param options physics.LDtkOptions? where the level goes, and what of it is solid
---@return physics.LDtkLevel level the objects that were added, counts, and what is not supported
function World:loadLDtk(project, level, options)
  local call = "loadLDtk(project, level, options)"
  checkSelf(self, call)
  checkIdle(self._bodies, call)
  checkObjects(self)
  local found, groupOf, tiles = ldtk.read(project, level, options)
  checkAll(self, found.objects, groupOf, groupOf, "world:" .. call)
  putAll(self, found.objects, groupOf)
  for i = 1, #tiles do
    tileLayers.attach(tiles[i], self, MAPS)
  end
  return found
end

return World
