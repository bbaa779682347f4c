--- JSON, as much as the results need: strings, numbers, booleans, lists, objects.
--- Source: RFC 8259. What it does not know: null, which a Lua table cannot hold.

local json = {}

local ESCAPES = { ['"'] = '\\"', ["\\"] = "\\\\", ["\n"] = "\\n", ["\r"] = "\\r", ["\t"] = "\\t" }
local CONTROL = '[%z\1-\31\\"]'

local function quote(text)
  local quoted = text:gsub(CONTROL, function(char)
    return ESCAPES[char] or string.format("\\u%04x", char:byte())
  end)
  return '"' .. quoted .. '"'
end

local encode

local function encodeList(list)
  local parts = {}
  for i = 1, #list do
    parts[i] = encode(list[i])
  end
  return "[" .. table.concat(parts, ",") .. "]"
end

local function encodeObject(object)
  local names = {}
  for name in pairs(object) do
    if type(name) ~= "string" then
      error("json: an object's names are strings, got " .. tostring(name))
    end
    names[#names + 1] = name
  end
  table.sort(names)
  for i, name in ipairs(names) do
    names[i] = quote(name) .. ":" .. encode(object[name])
  end
  return "{" .. table.concat(names, ",") .. "}"
end

-- 17 digits bring every double back; integers are written as such.
local function encodeNumber(number)
  if number ~= number or number == math.huge or number == -math.huge then
    error("json: there is no way to write " .. tostring(number))
  end
  if number == math.floor(number) and math.abs(number) < 1e15 then
    return string.format("%.0f", number)
  end
  return string.format("%.17g", number)
end

function encode(value)
  local kind = type(value)
  if kind == "table" then
    return (#value > 0 or next(value) == nil) and encodeList(value) or encodeObject(value)
  elseif kind == "string" then
    return quote(value)
  elseif kind == "number" then
    return encodeNumber(value)
  elseif kind == "boolean" then
    return tostring(value)
  end
  error("json: cannot write a " .. kind)
end

--- Writes a value. A table with `[1]` is a list, so is an empty one; names come in order.
---
--- Errors: a value that JSON cannot hold.
---@param value table|string|number|boolean
---@return string
json.encode = encode

local UNESCAPED = { b = "\b", f = "\f", n = "\n", r = "\r", t = "\t" }

local function fail(text, at, expected)
  local found = at > #text and "the end" or "'" .. text:sub(at, at) .. "'"
  error(string.format("json: expected %s at %d, got %s", expected, at, found), 0)
end

local function skip(text, at)
  return text:find("[^ \t\r\n]", at) or #text + 1
end

-- The text that a backslash at `at` starts, and where it goes on. Beyond ASCII: UTF-8 of the
-- basic plane.
local function unescape(text, at)
  local hex = text:match("^u(%x%x%x%x)", at + 1)
  if not hex then
    local char = text:sub(at + 1, at + 1)
    if not char:find('[bfnrt"\\/]') then
      fail(text, at + 1, "an escape")
    end
    return UNESCAPED[char] or char, at + 2
  end
  local code = tonumber(hex, 16)
  if code < 0x80 then
    return string.char(code), at + 6
  elseif code < 0x800 then
    return string.char(0xC0 + math.floor(code / 64), 0x80 + code % 64), at + 6
  end
  local middle = math.floor(code / 64) % 64
  return string.char(0xE0 + math.floor(code / 4096), 0x80 + middle, 0x80 + code % 64), at + 6
end

local function decodeString(text, at)
  local parts = {}
  at = at + 1
  while true do
    local stop = text:find('[%z\1-\31\\"]', at)
    if not stop or text:find("^[%z\1-\31]", stop) then
      fail(text, stop or #text + 1, "the end of a string")
    end
    parts[#parts + 1] = text:sub(at, stop - 1)
    if text:sub(stop, stop) == '"' then
      return table.concat(parts), stop + 1
    end
    parts[#parts + 1], at = unescape(text, stop)
  end
end

local decode

local function decodeList(text, at)
  local list = {}
  at = skip(text, at + 1)
  if text:sub(at, at) == "]" then
    return list, at + 1
  end
  while true do
    list[#list + 1], at = decode(text, at)
    at = skip(text, at)
    local char = text:sub(at, at)
    if char == "]" then
      return list, at + 1
    elseif char ~= "," then
      fail(text, at, "',' or ']'")
    end
    at = at + 1
  end
end

local function decodeObject(text, at)
  local object = {}
  at = skip(text, at + 1)
  if text:sub(at, at) == "}" then
    return object, at + 1
  end
  while true do
    at = skip(text, at)
    if text:sub(at, at) ~= '"' then
      fail(text, at, "a name")
    end
    local name
    name, at = decodeString(text, at)
    at = skip(text, at)
    if text:sub(at, at) ~= ":" then
      fail(text, at, "':'")
    end
    object[name], at = decode(text, at + 1)
    at = skip(text, at)
    local char = text:sub(at, at)
    if char == "}" then
      return object, at + 1
    elseif char ~= "," then
      fail(text, at, "',' or '}'")
    end
    at = at + 1
  end
end

local function decodeNumber(text, at)
  local digits = text:match("^-?%d+%.?%d*[eE]?[+-]?%d*", at)
  local number = digits and tonumber(digits)
  if not number then
    fail(text, at, "a value")
  end
  return number, at + #digits
end

function decode(text, at)
  at = skip(text, at)
  local char = text:sub(at, at)
  if char == "{" then
    return decodeObject(text, at)
  elseif char == "[" then
    return decodeList(text, at)
  elseif char == '"' then
    return decodeString(text, at)
  elseif text:find("^true", at) then
    return true, at + 4
  elseif text:find("^false", at) then
    return false, at + 5
  end
  return decodeNumber(text, at)
end

--- Reads a value.
---
--- Errors: what is expected, where, and what stands there.
---@param text string
---@return table|string|number|boolean
function json.decode(text)
  local value, at = decode(text, 1)
  at = skip(text, at)
  if at <= #text then
    fail(text, at, "the end")
  end
  return value
end

return json
