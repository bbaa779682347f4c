--- Checks values and raises errors: which values are wrong, and which line the error names. What
--- the message says is in wording.lua. It names the place, the field, what was expected and what
--- was found:
---   physics: objects.boxes[3].width must be a number > 0, got nil
--- It points at the caller's line: the first one that is not in a file of the library.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local fields = require(root .. ".world.fields")
local interpreted = require(root .. ".memory.jit")
local keyOrder = require(root .. ".memory.keyOrder")
local wording = require(root .. ".memory.lazy")(root .. ".world.wording")

local floor = math.floor
local format = string.format

-- Numbers beyond these are refused, like infinity and 0: their squares or inverses would be
-- infinite.
local LARGEST, SMALLEST = 1e100, 1e-100

local check = { LARGEST = LARGEST, SMALLEST = SMALLEST }

-- The line that is named -------------------------------------------------------------------------

local getinfo = type(debug) == "table" and debug.getinfo or nil
local ownSources = {} -- chunk names of the library's files
local ownFolder -- prefix of the library's chunk names; nil: the library is one file

local function learnOwnSources()
  local source = getinfo(1, "S").source
  ownSources[source] = true
  ownFolder = source:match("^([^\n]*[/\\])world[/\\]check%.lua$")
  if ownFolder then
    ownSources[ownFolder:sub(1, -2) .. ".lua"] = true
  end
end

if getinfo then
  learnOwnSources()
end

local function isOwn(source)
  return ownSources[source] or (ownFolder and source:sub(1, #ownFolder) == ownFolder)
end

-- Returns the level of the next entry of the stack, if this one has no line of a game. That is a C
-- function (on gopher-lua: Go), the gap that Lua 5.1 leaves for a tail call, or the library. On
-- gopher-lua "tail" is the function that was called; the entry after it stands for no function.
local function nextLevel(level, info)
  local what = info.what
  local isTailCalled = what == "tail" and info.currentline > 0
  if what == "C" or what == "G" or (what == "tail" and not isTailCalled) then
    return level + 1
  elseif isOwn(info.source) then
    return level + (isTailCalled and 2 or 1)
  end
end

--- Raises `physics: message` at the line that called into the library. C functions (pcall) and the
--- gaps that Lua 5.1 leaves for tail calls are no callers; without any caller no line is named.
---@param message string
function check.fail(message)
  if not getinfo then
    error("physics: " .. message, 3)
  end
  local level, info = 2, nil
  while level do
    info = getinfo(level, "Sl")
    level = info and nextLevel(level, info)
  end
  -- The place is put in here, since `error` of gopher-lua counts levels in another way.
  local place = ""
  if info and info.currentline > 0 then
    place = (info.short_src or info.source:gsub("^@", "")) .. ":" .. info.currentline .. ": "
  end
  error(place .. "physics: " .. message, 0)
end

local fail = check.fail

-- Words ------------------------------------------------------------------------------------------

--- Returns a short text for a value, the same on every Lua.
---@param value any
---@return string
function check.show(value)
  return (wording.show(value))
end

--- Returns how the game would write the place of an object: `objects.boxes[3]`, `objects.player`.
---@param group string|number
---@param key string|number? nil: the object stands directly in `objects`
---@return string
function check.place(group, key)
  return (wording.place(group, key))
end

--- Returns what is wrong with a value that does not fit an entry of `fields.lua`.
---@param path string
---@param field physics.Field
---@param value any
---@return string
function check.describe(path, field, value)
  return (wording.describe(path, field, value))
end

local show = check.show

local function failValue(path, expected, value)
  fail(wording.mustBe(path, expected, value))
end

-- What is accepted -------------------------------------------------------------------------------

--- Returns whether a value is a number that the library can work with: finite, not huge.
---@param value any
---@return boolean
function check.isFinite(value)
  return type(value) == "number" and value >= -LARGEST and value <= LARGEST
end

local isFinite = check.isFinite

--- Returns whether a value can be the name of a group.
---@param value any
---@return boolean
function check.isName(value)
  return type(value) == "string" or isFinite(value)
end

local isName = check.isName

local function inRange(value, min, above, max)
  return isFinite(value)
    and (not min or value >= min)
    and (not above or value > above and (above ~= 0 or value >= SMALLEST))
    and (not max or value <= max)
end

--- Returns whether a predicate refuses an entry, and the first one in order: no message may depend
--- on the order of pairs().
function check.firstBad(map, isGood)
  local found, bad = false, nil
  for key, value in pairs(map) do
    if not isGood(key, value) and (not found or keyOrder.comesBefore(key, bad)) then
      found, bad = true, key
    end
  end
  return found, bad
end

local firstBad = check.firstBad

--- Returns the index of the first name that cannot be used, and the index of an equal name before
--- it.
function check.badName(list)
  local seen = {}
  for i = 1, #list do
    local name = list[i]
    if not isName(name) or seen[name] then
      return i, seen[name]
    end
    seen[name] = i
  end
end

local function isEmpty(list)
  return next(list) == nil
end

--- Returns whether a value is a list or an empty table. A set, `{ players = true }`, is neither.
function check.isList(value)
  return type(value) == "table" and (value[1] ~= nil or isEmpty(value))
end

local function isNames(value)
  return check.isList(value) and not check.badName(value)
end

--- The largest speed of `soft`, px/s.
check.FASTEST = 1e6

--- By type of a field that is a table: whether an entry of it can be used. ("speeds" is a row of
--- "soft".)
check.ENTRIES = {}
local ENTRIES = check.ENTRIES

-- By type of the other fields. A field of type "sides" is written by the library and never checked.
local ACCEPTS = {}

--- Returns whether a value fits an entry of `fields.lua`; nil does not.
---@param field physics.Field
---@param value any
---@return boolean
function check.accepts(field, value)
  local isEntry = ENTRIES[field.type]
  if isEntry then
    return type(value) == "table" and not firstBad(value, isEntry)
  end
  return ACCEPTS[field.type](value, field)
end

local isAccepted = check.accepts

function ENTRIES.mask(key, value)
  return isName(key) and type(value) == "boolean"
end

function ENTRIES.masks(key, value)
  return isName(key) and type(value) == "table" and not firstBad(value, ENTRIES.mask)
end

function ENTRIES.area(key, value)
  local field = fields.areaByName[key]
  return field ~= nil and isAccepted(field, value)
end

function ENTRIES.speeds(key, value)
  return isName(key) and inRange(value, 0, nil, check.FASTEST)
end

function ENTRIES.soft(key, value)
  return isName(key) and type(value) == "table" and not firstBad(value, ENTRIES.speeds)
end

function ACCEPTS.number(value, field)
  return inRange(value, field.min, field.above, field.max)
end

function ACCEPTS.boolean(value)
  return type(value) == "boolean"
end

ACCEPTS["function"] = function(value)
  return type(value) == "function"
end

function ACCEPTS.string(value, field)
  if type(value) == "boolean" then
    return field.yes ~= nil
  end
  for i = 1, #field.values do
    if value == field.values[i] then
      return true
    end
  end
  return false
end

ACCEPTS.names = isNames

local function isOwnName(name)
  return type(name) == "string" and not fields.objectByName[name]
end

function ACCEPTS.ownFields(value)
  local isGood = isNames(value)
  for i = 1, isGood and #value or 0 do
    isGood = isGood and isOwnName(value[i])
  end
  return isGood
end

--- Checks the name of a field of the game.
--- Errors: it is no string, or a field of the library.
---@param name any
---@param path string how the place of the name is written
function check.ownField(name, path)
  if not isOwnName(name) then
    fail(wording.ownField(path, name))
  end
end

--- Checks one value against an entry of `fields.lua`.
--- Errors: it does not fit, nil included.
---@param field physics.Field
---@param value any
---@param path string how the place of the value is written
function check.value(field, value, path)
  if not isAccepted(field, value) then
    fail(wording.describe(path, field, value))
  end
end

-- Objects ----------------------------------------------------------------------------------------

local RADIUS, ONE_WAY = fields.objectByName.radius, fields.objectByName.oneWay
local AREA, SLOPE = fields.objectByName.area, fields.objectByName.slope

-- Returns the field that cannot be together with the others of a circle, and what it must be.
local function badCircle(object, radius, size)
  local width, height = size or object.width, size or object.height
  if width ~= 2 * radius or height ~= 2 * radius then
    local sizes = show(width) .. " and " .. show(height)
    return RADIUS, "half of width and height, which are " .. sizes
  elseif object.oneWay then
    return ONE_WAY, "nil where there is a radius"
  elseif object.slope then
    return SLOPE, "nil where there is a radius"
  end
end

local function isBad(field, value)
  if value == nil then
    return field.required == true
  end
  return not field.written and not isAccepted(field, value)
end

--- Returns the first field, in the order of `fields.objects`, with a value that cannot be used.
--- Makes no garbage if all are fine.
---@param object table
---@param size number? px, what width and height are going to be (see `sizeToFill`)
---@return physics.Field? field nil: all are fine
---@return string? expected what it must be, if the value is wrong only beside those of others
---@return string? hint how that can be mended
function check.badField(object, size)
  local list = fields.objects
  for i = 1, #list do
    local field = list[i]
    local value = object[field.name]
    if (value ~= nil or field.required) and isBad(field, value) then
      if not (size and (field.name == "width" or field.name == "height")) then
        return field
      end
    end
  end
  if object.slope ~= nil and not (object.static or object.kinematic) then
    return SLOPE, "nil for a dynamic object", " (set static = true or kinematic = true)"
  end
  local radius = object.radius
  if object.area ~= nil and not object.sensor then
    return AREA, "nil unless the object is a sensor"
  elseif radius ~= nil then
    return badCircle(object, radius, size)
  end
end

--- Returns the width and height that `add` writes: those of a circle that has none yet.
---@param object table
---@return number? size px
function check.sizeToFill(object)
  local radius = object.radius
  if object.width == nil and object.height == nil and isFinite(radius) and radius > 0 then
    return 2 * radius
  end
end

local function mustBeTable(value, path)
  if type(value) ~= "table" then
    failValue(path, "a table", value)
  end
end

--- Checks some fields of an object, in the order given.
--- Errors: the object is not a table; a field is missing or cannot be used.
---@param object any
---@param place string how the game would write it: `objects.boxes[3]`
---@param names string[] names from `fields.objects`
function check.fields(object, place, names)
  mustBeTable(object, place)
  for i = 1, #names do
    local field = fields.objectByName[names[i]]
    local value = object[field.name]
    if isBad(field, value) then
      fail(wording.field(object, place, field))
    end
  end
end

--- Checks an object and all its fields.
--- Errors: the object is not a table; a field is missing or cannot be used (the first in the list).
---@param object any
---@param place string how the game would write it: `objects.boxes[3]`
---@param size number? px, what width and height are going to be
function check.object(object, place, size)
  mustBeTable(object, place)
  local field, expected, hint = check.badField(object, size)
  if field then
    fail(wording.field(object, place, field, expected, hint))
  end
end

-- Settings ---------------------------------------------------------------------------------------

local function isAmong(names, name)
  for i = 1, #names do
    if names[i] == name then
      return true
    end
  end
  return false
end

--- Checks that a table has only entries with these names.
--- Errors: another name (the first in order, so that the message does not vary from run to run).
---@param given table
---@param kind string what an entry is: `setting`
---@param names string[]
---@param where string the call it was given to: `newWorld(settings)`
function check.names(given, kind, names, where)
  local isUnknown, name = firstBad(given, function(key)
    return isAmong(names, key)
  end)
  if isUnknown then
    fail(wording.unknown(kind, name, names, where))
  end
end

--- Checks one setting.
--- Errors: an unknown name; a value that cannot be used; nil where the setting has a default.
---@param name string
---@param value any
---@param where string? the call it was given to, nil: it is read from a field of the world
function check.setting(name, value, where)
  local field = fields.settingByName[name]
  if not field then
    fail(wording.unknown("setting", name, fields.settingNames, where or "world"))
  elseif value == nil and field.default == nil then
    return
  elseif not isAccepted(field, value) then
    fail(wording.describe(where and where .. ": " .. name or "world." .. name, field, value))
  end
end

--- Checks a table of settings; nil is allowed, for the table and for each setting.
--- Errors: another type than table; an unknown setting; a value that cannot be used.
---@param settings table?
---@param where string the call it was given to: `newWorld(settings)`
function check.settings(settings, where)
  if settings == nil then
    return
  end
  check.table(settings, "settings", where)
  check.names(settings, "setting", fields.settingNames, where)
  for _, field in ipairs(fields.settings) do
    local value = settings[field.name]
    if value ~= nil and not isAccepted(field, value) then
      fail(wording.describe(where .. ": " .. field.name, field, value))
    end
  end
end

-- Arguments --------------------------------------------------------------------------------------

--- Checks a number: finite, and in its range.
---@param value any
---@param what string name of the argument
---@param where string the call: `world:update(dt)`
---@param min number? smallest value allowed
---@param max number? largest value allowed
function check.number(value, what, where, min, max)
  if not inRange(value, min, nil, max) then
    failValue(where .. ": " .. what, wording.number(value, min, nil, max), value)
  end
end

--- Checks a number that must be > 0 and finite.
---@param value any
---@param what string name of the argument
---@param where string the call
function check.positive(value, what, where)
  if not inRange(value, nil, 0, nil) then
    failValue(where .. ": " .. what, wording.number(value, nil, 0, nil), value)
  end
end

--- Checks a whole number in a range.
---@param value any
---@param what string name of the argument
---@param where string the call
---@param min integer
---@param max integer
function check.integer(value, what, where, min, max)
  if not inRange(value, min, nil, max) or floor(value) ~= value then
    failValue(where .. ": " .. what, format("an integer in %d..%d", min, max), value)
  end
end

---@param value any
---@param what string name of the argument
---@param where string the call
function check.boolean(value, what, where)
  if type(value) ~= "boolean" then
    failValue(where .. ": " .. what, "true or false", value)
  end
end

---@param value any
---@param what string name of the argument
---@param where string the call
function check.table(value, what, where)
  if type(value) ~= "table" then
    failValue(where .. ": " .. what, "a table", value)
  end
end

--- Checks an optional argument: a string, a table, a function.
---@param value any
---@param kind "string"|"table"|"function"
---@param what string name of the argument
---@param where string the call
function check.optional(value, kind, what, where)
  if value ~= nil and type(value) ~= kind then
    failValue(where .. ": " .. what, "a " .. kind, value)
  end
end

--- Checks a string that must be one of a few.
---@param value any
---@param what string name of the argument
---@param where string the call
---@param values string[]
function check.choice(value, what, where, values)
  for i = 1, #values do
    if value == values[i] then
      return
    end
  end
  failValue(where .. ": " .. what, wording.choice(values), value)
end

--- Checks the name of a group: a string or a finite number.
---@param value any
---@param where string the call: `world:add(group, object)`
---@param what string? name of the argument, default "group"
function check.group(value, where, what)
  if not isName(value) then
    local isSwapped = not what and type(value) == "table"
    local order = isSwapped and " (the group comes first, then the object)" or ""
    fail(wording.mustBe(where .. ": " .. (what or "group"), "a string or a number", value) .. order)
  end
end

--- Checks a filter of a query: a group name, a list of group names or a function; nil is none.
---@param value any
---@param where string the call
function check.filter(value, where)
  if value == nil or type(value) == "function" or isName(value) then
    return
  end
  if not check.isList(value) then -- an object or a set of names would match nothing
    failValue(where .. ": filter", "a group name, a list of them or a function", value)
  end
  for i = 1, #value do
    if not isName(value[i]) then
      local hint = type(value[i]) == "table" and " (the name of a group, not its table)" or ""
      fail(wording.mustBe(format("%s: filter[%d]", where, i), "a group name", value[i]) .. hint)
    end
  end
end

interpreted.always(check.firstBad, isEmpty)

return check
