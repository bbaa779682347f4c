--- What a game may ask of `loadTiled`.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local values = require(root .. ".maps.values")

local options = {}

local OPTIONS = {
  "decompress",
  "folder",
  "ignore",
  "merge",
  "onlyLayers",
  "skipLayers",
  "solidLayers",
  "solidProperty",
  "solidTiles",
  "strict",
  "x",
  "y",
}

--- How an error names the call.
options.WHERE = "world:loadTiled(map, options)"

local WHERE = options.WHERE

---@class physics.TiledOptions
---@field x? number px, default 0: where the map's left edge goes
---@field y? number px, default 0: where its upper edge goes
---@field solidLayers? (string|integer)[] names or ids of layers: a yes, not their own `solid`, nor
---  what their names say
---@field solidTiles? integer[] gids: a yes instead of the own `solid` of these tiles
---@field solidProperty? string the property that makes solid, default "solid" and "collidable"
---@field onlyLayers? (string|integer)[] names or ids of layers: nothing else is read
---@field skipLayers? (string|integer)[] names or ids of layers that are left out
---@field ignore? string[] names of properties that mean something else in this game
---@field strict? boolean default false; true: a property that cannot be used is an error
---@field merge? boolean default true: equal solid tiles become few; false: each one is an object
---@field folder? string where the map lies, for its external tilesets: a map by path knows it
---@field decompress? fun(data: string, compression: string): string? unpacks "zlib", "gzip" or
---  "zstd" where neither LÖVE nor LibDeflate can

-- The option of this name, a list of what `kind` says; nil if it is not given.
local function listOf(given, name, kind)
  local list = given[name]
  if list ~= nil and not check.isList(list) then
    check.fail(("%s: %s must be a list of %s, got %s"):format(WHERE, name, kind, check.show(list)))
  end
  return list
end

local function layersOf(given, name)
  local list = listOf(given, name, "layer names")
  for i = 1, #(list or {}) do
    check.group(list[i], WHERE, ("%s[%d]"):format(name, i))
  end
  return list
end

local function gidsOf(given)
  local list, isSolid = listOf(given, "solidTiles", "gids") or {}, {}
  for i = 1, #list do
    check.integer(list[i], ("solidTiles[%d]"):format(i), WHERE, 1, 268435455)
    isSolid[list[i]] = true
  end
  return isSolid
end

local function ignoredOf(given)
  local list, isIgnored = listOf(given, "ignore", "property names") or {}, {}
  for i = 1, #list do
    if type(list[i]) ~= "string" then
      check.fail(("%s: ignore[%d] must be a name, got %s"):format(WHERE, i, check.show(list[i])))
    end
    isIgnored[list[i]] = true
  end
  return isIgnored
end

local function checkKind(given, name, kind, expected)
  if given[name] ~= nil and type(given[name]) ~= kind then
    local text = ("%s: %s must be %s, got %s"):format(
      WHERE,
      name,
      expected,
      check.show(given[name])
    )
    check.fail(text)
  end
  return given[name]
end

--- Returns what a map is read by.
--- Errors: an unknown option, or a wrong value for one.
---@param given physics.TiledOptions?
---@return table reading
function options.check(given)
  given = values.readOptions(given, OPTIONS, { "merge", "strict" }, WHERE)
  local solidName = checkKind(given, "solidProperty", "string", "a name")
  return {
    x = given.x or 0,
    y = given.y or 0,
    merge = given.merge ~= false,
    folder = checkKind(given, "folder", "string", "a path"),
    decompress = checkKind(given, "decompress", "function", "a function"),
    solidTiles = given.solidTiles,
    isSolidGid = gidsOf(given),
    solidLayers = layersOf(given, "solidLayers"),
    skipLayers = layersOf(given, "skipLayers"),
    onlyLayers = layersOf(given, "onlyLayers"),
    rules = {
      solidNames = solidName and { solidName } or { "solid", "collidable" },
      isIgnored = ignoredOf(given),
      isStrict = given.strict or false,
    },
  }
end

return options
