--- Where a map comes from: the file of an export, and the files of tilesets beside it.

local root = (...):match("^(.*)%.maps%.")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local report = require(root .. ".maps.tiled.report")

local source = {}

local WHERE = report.WHERE

local SLASHES = "; love.filesystem divides folders by / on every system"

local function compile(path)
  if type(love) == "table" and love.filesystem then
    if not love.filesystem.getInfo(path, "file") then
      local hint = path:find("\\", 1, true) and SLASHES or ""
      return nil, "there is no such file" .. hint
    end
    return love.filesystem.load(path)
  end
  return loadfile(path)
end

-- What a file returns; nil and a sentence about it if it cannot be had.
local function run(path)
  local isRead, chunk, problem = pcall(compile, path)
  if not isRead or not chunk then
    problem = isRead and problem or chunk -- of the loader, or of pcall
    return nil, ("cannot read %s: %s"):format(check.show(path), tostring(problem))
  end
  local isRun, result = pcall(chunk) ---@diagnostic disable-line: param-type-mismatch
  if not isRun then
    return nil, ("cannot run %s: %s"):format(check.show(path), tostring(result))
  end
  return result
end

local function loadMap(path)
  if path:match("%.tm[xj]$") or path:match("%.json$") then
    check.fail(
      ("%s: %s must be exported as Lua: File > Export As, *.lua"):format(WHERE, check.show(path))
    )
  end
  local map, problem = run(path)
  if problem then
    check.fail(WHERE .. ": " .. problem)
  elseif type(map) ~= "table" then
    check.fail(
      ("%s: %s must return a map, got %s"):format(WHERE, check.show(path), check.show(map))
    )
  end
  return map
end

local function checkSizes(map)
  check.table(map.layers, "map.layers", WHERE)
  check.positive(map.tilewidth, "map.tilewidth", WHERE)
  check.positive(map.tileheight, "map.tileheight", WHERE)
  check.number(map.width, "map.width", WHERE, 0)
  check.number(map.height, "map.height", WHERE, 0)
  check.optional(map.orientation, "string", "map.orientation", WHERE)
  for _, name in ipairs({ "offsetx", "offsety" }) do -- of STI
    if map[name] ~= nil then
      check.number(map[name], "map." .. name, WHERE)
    end
  end
end

--- Returns a map, and the folder in which it lies, nil: that is not known.
--- Errors: no map, no such file; a tileset instead of a map; no layers, no sizes.
---@param given table|string
---@return table map
---@return string? folder
function source.load(given)
  local map, folder = given, nil
  if type(given) == "string" then
    map, folder = loadMap(given), given:match("^(.*)[/\\][^/\\]*$") or ""
  elseif type(given) ~= "table" then
    check.fail(
      ("%s: map must be a Tiled map or the path of one, got %s"):format(WHERE, check.show(given))
    )
  end
  if map.layers == nil and (map.tilecount ~= nil or map.wangsets ~= nil) then
    check.fail(WHERE .. ": this is a tileset, not a map: load the map that uses it")
  end
  checkSizes(map)
  return map, folder
end

-- Tilesets ----------------------------------------------------------------------------------------

-- "maps/../sets/land.lua" is "sets/land.lua": love.filesystem knows no "..".
local function join(folder, name)
  local isAbsolute = folder:match("^[/\\]") and "/" or ""
  local parts = {}
  for part in (folder .. "/" .. name):gmatch("[^/\\]+") do
    if part == ".." and #parts > 0 and parts[#parts] ~= ".." then
      parts[#parts] = nil
    elseif part ~= "." then
      parts[#parts + 1] = part
    end
  end
  return isAbsolute .. table.concat(parts, "/")
end

local function complete(set, given)
  local full = {}
  for name, value in pairs(given) do
    full[name] = value
  end
  for name, value in pairs(set) do
    full[name] = value
  end
  return full
end

interpreted.always(complete)

--- Returns a tileset with what the file says that was exported beside it.
---@param set table as it stands in the map
---@param folder string? where the map lies
---@return table set the same one if nothing more is known
---@return string? problem why not
function source.tileset(set, folder)
  if set.tilewidth ~= nil or set.exportfilename == nil then
    return set
  elseif type(set.exportfilename) ~= "string" then
    return set, "exportfilename must be a path, got " .. check.show(set.exportfilename)
  elseif not folder then
    return set, "where the map lies is not known: give the option folder"
  end
  local path = join(folder, set.exportfilename)
  local given, problem = run(path)
  if problem then
    return set, problem
  elseif type(given) ~= "table" or type(given.tilewidth) ~= "number" then
    return set, check.show(path) .. " is no tileset"
  end
  return complete(set, given)
end

return source
