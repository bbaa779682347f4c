--- What messages say: values as text, what is expected, what is probably meant. It is loaded with
--- the first message.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local check = require(root .. ".world.check")
local fields = require(root .. ".world.fields")

local wording = {}

local huge = 1 / 0 -- math.huge is a finite number on gopher-lua
local format = string.format
local isFinite, isName = check.isFinite, check.isName
local firstBad, ENTRIES = check.firstBad, check.ENTRIES
local LARGEST, SMALLEST, FASTEST = check.LARGEST, check.SMALLEST, check.FASTEST

local MAX_SHOWN = 40 -- characters of a string in a message

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
function wording.show(value)
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

local show = wording.show

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
function wording.place(group, key)
  local path = indexed("objects", group)
  return key == nil and path or indexed(path, key)
end

-- What is expected -------------------------------------------------------------------------------

--- Returns what a message says of a value that is another one than expected.
function wording.mustBe(path, expected, value)
  return format("%s must be %s, got %s", path, expected, show(value))
end

local mustBe = wording.mustBe

--- Returns which numbers are expected, in place of this value.
function wording.number(value, min, above, max)
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

--- Returns which strings are expected.
function wording.choice(values)
  local shown = {}
  for i = 1, #values do
    shown[i] = show(values[i])
  end
  local last = table.remove(shown)
  return #shown == 0 and last or table.concat(shown, ", ") .. " or " .. last
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
function wording.isSlip(name, known)
  return isOneOff(name:lower(), known:lower())
end

--- Returns the name in a list that an unknown name is probably a misspelling of.
---@param name any
---@param names string[]
---@return string? nil: there is none
function wording.guess(name, names)
  local guess
  for _, known in ipairs(names) do
    if tostring(name):lower() == known:lower() then
      return known
    elseif not guess and wording.isSlip(tostring(name), known) then
      guess = known
    end
  end
  return guess
end

--- Returns what a message says of a name that is none of those known.
function wording.unknown(kind, name, names, where)
  local guess = wording.guess(name, names)
  local hint = guess and format(" (did you mean %s?)", show(guess)) or ""
  local known, plural = table.concat(names, ", "), kind == "entry" and "entries" or kind .. "s"
  return format("%s: unknown %s %s%s; the %s are %s", where, kind, show(name), hint, plural, known)
end

-- Fields -----------------------------------------------------------------------------------------

-- By type of a field: `describe(path, field, value)` says what is wrong with a value.
local DESCRIBE = {}

local function describeBoolean(path, value)
  return mustBe(path, "true or false", value)
end

function DESCRIBE.number(path, field, value)
  return mustBe(path, wording.number(value, field.min, field.above, field.max), value)
end

function DESCRIBE.boolean(path, _, value)
  return describeBoolean(path, value)
end

DESCRIBE["function"] = function(path, _, value)
  return mustBe(path, "a function", value)
end

function DESCRIBE.string(path, field, value)
  local choice = wording.choice(field.values)
  return mustBe(path, field.yes and "true, false, " .. choice or choice, value)
end

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
  return describeByGroup(path, mask, expected, ENTRIES.mask, describeBoolean)
end

function DESCRIBE.mask(path, _, value)
  return describeMask(path, value)
end

function DESCRIBE.masks(path, _, value)
  local expected = "a table { [group] = { [group] = false } }"
  return describeByGroup(path, value, expected, ENTRIES.masks, describeMask)
end

function DESCRIBE.area(path, _, value)
  if type(value) ~= "table" then
    return mustBe(path, "a table { gravity = 100, … }", value)
  end
  local _, key = firstBad(value, ENTRIES.area)
  local field = fields.areaByName[key]
  if field then
    return wording.describe(indexed(path, key), field, value[key])
  end
  return wording.unknown("entry", key, fields.areaNames, path)
end

local function describeSpeed(path, value)
  return mustBe(path, wording.number(value, 0, nil, FASTEST), value)
end

local function describeSpeeds(path, row)
  return describeByGroup(path, row, "a table { [group] = px/s }", ENTRIES.speeds, describeSpeed)
end

function DESCRIBE.soft(path, _, value)
  local expected = "a table { [group] = { [group] = px/s } }"
  return describeByGroup(path, value, expected, ENTRIES.soft, describeSpeeds)
end

function DESCRIBE.names(path, _, value)
  if not check.isList(value) then
    return mustBe(path, "a list of group names", value)
  end
  local i, earlier = check.badName(value)
  if earlier then
    local name = show(value[i])
    return format("%s must name each group once, got %s at [%d] and [%d]", path, name, earlier, i)
  end
  return mustBe(indexed(path, i), "a group name", value[i])
end

--- Returns what is wrong with the name of a field of the game; nil: it can be used.
function wording.ownField(path, name)
  if type(name) ~= "string" then
    return mustBe(path, "the name of a field", name)
  elseif fields.objectByName[name] then
    return format("%s must be a field of your own; %s is saved anyway", path, name)
  end
end

function DESCRIBE.ownFields(path, _, value)
  if not check.isList(value) then
    return mustBe(path, "a list of names of fields", value)
  end
  for i = 1, #value do
    local problem = wording.ownField(indexed(path, i), value[i])
    if problem then
      return problem
    end
  end
  local i, earlier = check.badName(value)
  local text = "%s must name each field once, got %s at [%d] and [%d]"
  return format(text, path, show(value[i]), earlier, i)
end

--- Returns what is wrong with a value that does not fit an entry of `fields.lua`.
---@param path string
---@param field physics.Field
---@param value any
---@return string
function wording.describe(path, field, value)
  return DESCRIBE[field.type](path, field, value)
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

--- Returns what is wrong with a field of an object. `expected` and `hint`: see `check.badField`.
function wording.field(object, place, field, expected, hint)
  local path, value = place .. "." .. field.name, object[field.name]
  if expected then
    return mustBe(path, expected, value) .. (hint or "")
  end
  return wording.describe(path, field, value) .. advice(object, field, value)
end

return wording
