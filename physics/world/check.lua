--- Checks values and raises errors: which values are wrong, what the message says, which line it
--- names. A message names the place, the field, what was expected and what was found:
---   physics: objects.boxes[3].width must be a number > 0, got nil
--- It points at the caller's line: the first one that is not in a file of the library.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local fields = require(root .. ".world.fields")
local interpreted = require(root .. ".memory.jit")
local keyOrder = require(root .. ".memory.keyOrder")

local floor = math.floor
local huge = 1 / 0 -- math.huge is a finite number on gopher-lua
local format = string.format

local MAX_SHOWN = 40 -- characters of a string in a message
-- Numbers beyond these are refused, like infinity and 0: their squares or inverses would be
-- infinite.
local LARGEST, SMALLEST = 1e100, 1e-100

local check = {}

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

-- Show a value -----------------------------------------------------------------------------------

local ESCAPES = { ["\n"] = "\\n", ["\t"] = "\\t", ["\r"] = "\\r", ['"'] = '\\"', ["\\"] = "\\\\" }

local function escape(character)
  return ESCAPES[character] or format("\\%03d", character:byte())
end

-- Returns whether a byte is the second to fourth of a UTF-8 character: text is not cut before it.
local function isContinuation(byte)
  return byte >= 128 and byte < 192
end

local function quote(text)
  if #text > MAX_SHOWN then
    local last = MAX_SHOWN
    while last > MAX_SHOWN - 3 and isContinuation(text:byte(last + 1)) do
      last = last - 1
    end
    text = text:sub(1, last) .. "..."
  end
  return '"' .. text:gsub('[%c"\\]', escape) .. '"'
end

local function showNumber(value)
  if value ~= value then
    return "nan"
  elseif value == huge then
    return "inf"
  elseif value == -huge then
    return "-inf"
  end
  return format("%.14g", value)
end

--- Returns a short text for a value, the same on every Lua.
---@param value any
---@return string
function check.show(value)
  local kind = type(value)
  if kind == "string" then
    return quote(value)
  elseif kind == "number" then
    return showNumber(value)
  elseif kind == "nil" or kind == "boolean" then
    return tostring(value)
  end
  return kind
end

local show = check.show

local KEYWORDS = {}
for word in
  ([[and break do else elseif end false for function goto if in local nil not or repeat return then
  true until while]]):gmatch("%a+")
do
  KEYWORDS[word] = true
end

local function indexed(path, key)
  if type(key) == "string" and key:find("^[%a_][%w_]*$") and not KEYWORDS[key] then
    return path .. "." .. key
  end
  return path .. "[" .. show(key) .. "]"
end

--- Returns how the game would write the place of an object: `objects.boxes[3]`, `objects.player`.
---@param group string|number
---@param key string|number? nil: the object stands directly in `objects`
---@return string
function check.place(group, key)
  local path = indexed("objects", group)
  return key == nil and path or indexed(path, key)
end

-- What is expected -------------------------------------------------------------------------------

local function isFinite(value)
  return type(value) == "number" and value >= -LARGEST and value <= LARGEST
end

local function isName(value)
  return type(value) == "string" or isFinite(value)
end

local function inRange(value, min, above, max)
  return isFinite(value)
    and (not min or value >= min)
    and (not above or value > above and (above ~= 0 or value >= SMALLEST))
    and (not max or value <= max)
end

local function describeNumber(value, min, above, max)
  local text = "a number"
  if value == huge or value == -huge then
    text = "a finite number"
  elseif not max and type(value) == "number" and (value > LARGEST or value < -LARGEST) then
    if not min and not above then
      min = -LARGEST
    end
    max = LARGEST
  elseif above == 0 and type(value) == "number" and value > 0 and value < SMALLEST then
    return text .. " >= " .. show(SMALLEST)
  end
  if min and max then
    return format("%s in %s..%s", text, show(min), show(max))
  end
  text = text .. (min and " >= " .. show(min) or above and " > " .. show(above) or "")
  return text .. (max and (above and " and <= " or " <= ") .. show(max) or "")
end

local function describeChoice(values)
  local shown = {}
  for i = 1, #values do
    shown[i] = show(values[i])
  end
  local last = table.remove(shown)
  return #shown == 0 and last or table.concat(shown, ", ") .. " or " .. last
end

-- Returns the first entry, in order, that a predicate refuses: no message may depend on the order
-- of pairs().
local function firstBad(map, isGood)
  local found, bad = false, nil
  for key, value in pairs(map) do
    if not isGood(key, value) and (not found or keyOrder.comesBefore(key, bad)) then
      found, bad = true, key
    end
  end
  return found, bad
end

-- Returns whether two names differ by one slip: a letter wrong, missing, too many, or swapped with
-- its neighbour.
local function isOneOff(a, b)
  while a ~= "" and a:sub(1, 1) == b:sub(1, 1) do
    a, b = a:sub(2), b:sub(2)
  end
  while a ~= "" and a:sub(-1) == b:sub(-1) do
    a, b = a:sub(1, -2), b:sub(1, -2)
  end
  return #a <= 1 and #b <= 1 or #a == 2 and a == b:reverse()
end

--- Returns whether one name is probably a misspelling of another: it differs by one slip at most,
--- or only by capitals.
---@param name string
---@param known string
---@return boolean
function check.isSlip(name, known)
  return isOneOff(name:lower(), known:lower())
end

--- Returns the name in a list that an unknown name is probably a misspelling of.
---@param name any
---@param names string[]
---@return string? nil: there is none
function check.guess(name, names)
  local guess
  for _, known in ipairs(names) do
    if tostring(name):lower() == known:lower() then
      return known
    elseif not guess and check.isSlip(tostring(name), known) then
      guess = known
    end
  end
  return guess
end

local function describeUnknown(kind, name, names, where)
  local guess = check.guess(name, names)
  local hint = guess and format(" (did you mean %s?)", show(guess)) or ""
  local known, plural = table.concat(names, ", "), kind == "entry" and "entries" or kind .. "s"
  return format("%s: unknown %s %s%s; the %s are %s", where, kind, show(name), hint, plural, known)
end

-- Each type of field: `accepts(field, value)`, and `describe(path, field, value)`, which says what
-- is wrong with a value that was not accepted.
local TYPES = {}

local function isAccepted(field, value)
  return TYPES[field.type].accepts(field, value)
end

---@return string
local function describe(path, field, value)
  return TYPES[field.type].describe(path, field, value)
end

local function isMaskEntry(key, value)
  return isName(key) and type(value) == "boolean"
end

local function isAreaEntry(key, value)
  local field = fields.areaByName[key]
  return field ~= nil and isAccepted(field, value)
end

local function isMasksEntry(key, value)
  return isName(key) and type(value) == "table" and not firstBad(value, isMaskEntry)
end

local function mustBe(path, expected, value)
  return format("%s must be %s, got %s", path, expected, show(value))
end

local function describeBoolean(path, value)
  return mustBe(path, "true or false", value)
end

TYPES.number = {
  accepts = function(field, value)
    return inRange(value, field.min, field.above, field.max)
  end,
  describe = function(path, field, value)
    return mustBe(path, describeNumber(value, field.min, field.above, field.max), value)
  end,
}

TYPES.boolean = {
  accepts = function(_, value)
    return type(value) == "boolean"
  end,
  describe = function(path, _, value)
    return describeBoolean(path, value)
  end,
}

TYPES["function"] = {
  accepts = function(_, value)
    return type(value) == "function"
  end,
  describe = function(path, _, value)
    return mustBe(path, "a function", value)
  end,
}

TYPES.string = {
  accepts = function(field, value)
    if type(value) == "boolean" then
      return field.yes ~= nil
    end
    for i = 1, #field.values do
      if value == field.values[i] then
        return true
      end
    end
    return false
  end,
  describe = function(path, field, value)
    local choice = describeChoice(field.values)
    return mustBe(path, field.yes and "true, false, " .. choice or choice, value)
  end,
}

-- Says what is wrong with a table that has group names as keys, and entries that fit `isEntry(key,
-- value)`. `describeEntry(path, value)` says what is wrong with one of them.
local function describeByGroup(path, value, expected, isEntry, describeEntry)
  if type(value) ~= "table" then
    return mustBe(path, expected, value)
  end
  local _, key = firstBad(value, isEntry)
  if not isName(key) then
    return format("%s must have group names as keys, got %s", path, show(key))
  end
  return describeEntry(indexed(path, key), value[key])
end

local function describeMask(path, mask)
  local expected = "a table { [group] = false }"
  return describeByGroup(path, mask, expected, isMaskEntry, describeBoolean)
end

TYPES.mask = {
  accepts = function(_, value)
    return type(value) == "table" and not firstBad(value, isMaskEntry)
  end,
  describe = function(path, _, value)
    return describeMask(path, value)
  end,
}

TYPES.masks = {
  accepts = function(_, value)
    return type(value) == "table" and not firstBad(value, isMasksEntry)
  end,
  describe = function(path, _, value)
    local expected = "a table { [group] = { [group] = false } }"
    return describeByGroup(path, value, expected, isMasksEntry, describeMask)
  end,
}

TYPES.area = {
  accepts = function(_, value)
    return type(value) == "table" and not firstBad(value, isAreaEntry)
  end,
  describe = function(path, _, value)
    if type(value) ~= "table" then
      return mustBe(path, "a table { gravity = 100, … }", value)
    end
    local _, key = firstBad(value, isAreaEntry)
    local field = fields.areaByName[key]
    if field then
      return describe(indexed(path, key), field, value[key])
    end
    return describeUnknown("entry", key, fields.areaNames, path)
  end,
}

--- The largest speed of `soft`, px/s.
check.FASTEST = 1e6
local FASTEST = check.FASTEST

local function isSoftEntry(key, value)
  return isName(key) and inRange(value, 0, nil, FASTEST)
end

local function isSoftRow(key, value)
  return isName(key) and type(value) == "table" and not firstBad(value, isSoftEntry)
end

local function describeSoftEntry(path, value)
  return mustBe(path, describeNumber(value, 0, nil, FASTEST), value)
end

local function describeSoftRow(path, row)
  return describeByGroup(path, row, "a table { [group] = px/s }", isSoftEntry, describeSoftEntry)
end

TYPES.soft = {
  accepts = function(_, value)
    return type(value) == "table" and not firstBad(value, isSoftRow)
  end,
  describe = function(path, _, value)
    local expected = "a table { [group] = { [group] = px/s } }"
    return describeByGroup(path, value, expected, isSoftRow, describeSoftRow)
  end,
}

-- Returns the index of the first name that cannot be used, and the index of an equal name before
-- it.
local function badName(list)
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

TYPES.names = {
  accepts = function(_, value)
    return check.isList(value) and not badName(value)
  end,
  describe = function(path, _, value)
    if not check.isList(value) then
      return mustBe(path, "a list of group names", value)
    end
    local i, earlier = badName(value)
    if earlier then
      local name = show(value[i])
      return format("%s must name each group once, got %s at [%d] and [%d]", path, name, earlier, i)
    end
    return mustBe(indexed(path, i), "a group name", value[i])
  end,
}

-- Returns what is wrong with the name of a field of the game; nil: it can be used.
local function describeOwn(path, name)
  if type(name) ~= "string" then
    return mustBe(path, "the name of a field", name)
  elseif fields.objectByName[name] then
    return format("%s must be a field of your own; %s is saved anyway", path, name)
  end
end

--- Checks the name of a field of the game.
--- Errors: it is no string, or a field of the library.
---@param name any
---@param path string how the place of the name is written
function check.ownField(name, path)
  local problem = describeOwn(path, name)
  if problem then
    fail(problem)
  end
end

TYPES.ownFields = {
  accepts = function(_, value)
    if not check.isList(value) or badName(value) then
      return false
    end
    for i = 1, #value do
      if describeOwn("", value[i]) then
        return false
      end
    end
    return true
  end,
  describe = function(path, _, value)
    if not check.isList(value) then
      return mustBe(path, "a list of names of fields", value)
    end
    for i = 1, #value do
      local problem = describeOwn(indexed(path, i), value[i])
      if problem then
        return problem
      end
    end
    local i, earlier = badName(value)
    local text = "%s must name each field once, got %s at [%d] and [%d]"
    return format(text, path, show(value[i]), earlier, i)
  end,
}

-- A field of type "sides" is written by the library and never checked.

--- Returns what is wrong with a value that does not fit an entry of `fields.lua`.
---@type fun(path: string, field: physics.Field, value: any): string
check.describe = describe

--- Returns whether a value fits an entry of `fields.lua`; nil does not.
---@type fun(field: physics.Field, value: any): boolean
check.accepts = isAccepted

--- Checks one value against an entry of `fields.lua`.
--- Errors: it does not fit, nil included.
---@param field physics.Field
---@param value any
---@param path string how the place of the value is written
function check.value(field, value, path)
  if not isAccepted(field, value) then
    fail(describe(path, field, value))
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
    fail(mustBe(path, "a table", value))
  end
end

-- Returns advice on how to fix a field, in parentheses, or "".
local function advice(object, field, value)
  local other = field.misnamed and object[field.misnamed]
  if value == nil and isFinite(other) then
    return format(" (but %s is %s: call it %s)", field.misnamed, show(other), field.name)
  elseif value == nil and field.misnamed and isFinite(object.radius) then
    return format(" (2 * radius is %s)", show(2 * object.radius))
  elseif field.infinite and value == huge then
    return format(" (%s)", field.infinite)
  end
  return ""
end

local function failField(object, place, field, expected, hint)
  local value = object[field.name]
  if expected then
    fail(mustBe(place .. "." .. field.name, expected, value) .. (hint or ""))
  end
  fail(describe(place .. "." .. field.name, field, value) .. advice(object, field, value))
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
      failField(object, place, field)
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
    failField(object, place, field, expected, hint)
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
    fail(describeUnknown(kind, name, names, where))
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
    fail(describeUnknown("setting", name, fields.settingNames, where or "world"))
  elseif value == nil and field.default == nil then
    return
  elseif not isAccepted(field, value) then
    fail(describe(where and where .. ": " .. name or "world." .. name, field, value))
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
      fail(describe(where .. ": " .. field.name, field, value))
    end
  end
end

-- Arguments --------------------------------------------------------------------------------------

--- Returns whether a value is a number that the library can work with: finite, not huge.
---@type fun(value: any): boolean
check.isFinite = isFinite

--- Returns whether a value can be the name of a group.
---@type fun(value: any): boolean
check.isName = isName

--- Checks a number: finite, and in its range.
---@param value any
---@param what string name of the argument
---@param where string the call: `world:update(dt)`
---@param min number? smallest value allowed
---@param max number? largest value allowed
function check.number(value, what, where, min, max)
  if not inRange(value, min, nil, max) then
    fail(mustBe(where .. ": " .. what, describeNumber(value, min, nil, max), value))
  end
end

--- Checks a number that must be > 0 and finite.
---@param value any
---@param what string name of the argument
---@param where string the call
function check.positive(value, what, where)
  if not inRange(value, nil, 0, nil) then
    fail(mustBe(where .. ": " .. what, describeNumber(value, nil, 0, nil), value))
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
    fail(mustBe(where .. ": " .. what, format("an integer in %d..%d", min, max), value))
  end
end

---@param value any
---@param what string name of the argument
---@param where string the call
function check.boolean(value, what, where)
  if type(value) ~= "boolean" then
    fail(mustBe(where .. ": " .. what, "true or false", value))
  end
end

---@param value any
---@param what string name of the argument
---@param where string the call
function check.table(value, what, where)
  if type(value) ~= "table" then
    fail(mustBe(where .. ": " .. what, "a table", value))
  end
end

--- Checks an optional argument: a string, a table, a function.
---@param value any
---@param kind "string"|"table"|"function"
---@param what string name of the argument
---@param where string the call
function check.optional(value, kind, what, where)
  if value ~= nil and type(value) ~= kind then
    fail(mustBe(where .. ": " .. what, "a " .. kind, value))
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
  fail(mustBe(where .. ": " .. what, describeChoice(values), value))
end

--- Checks the name of a group: a string or a finite number.
---@param value any
---@param where string the call: `world:add(group, object)`
---@param what string? name of the argument, default "group"
function check.group(value, where, what)
  if not isName(value) then
    local isSwapped = not what and type(value) == "table"
    local order = isSwapped and " (the group comes first, then the object)" or ""
    fail(mustBe(where .. ": " .. (what or "group"), "a string or a number", value) .. order)
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
    fail(mustBe(where .. ": filter", "a group name, a list of them or a function", value))
  end
  for i = 1, #value do
    if not isName(value[i]) then
      local hint = type(value[i]) == "table" and " (the name of a group, not its table)" or ""
      fail(mustBe(format("%s: filter[%d]", where, i), "a group name", value[i]) .. hint)
    end
  end
end

interpreted.always(firstBad, isEmpty)

return check
