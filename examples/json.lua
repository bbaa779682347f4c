-- Decodes JSON, as much of it as the editors Tiled and LDtk write. A game takes a library.

local json = {}

local ESCAPES = { b = "\b", f = "\f", n = "\n", r = "\r", t = "\t" }
local WORDS = { ["true"] = true, ["false"] = false }

local readValue

local function skip(text, at)
  return text:find("%S", at) or #text + 1
end

local function readText(text, at)
  local last = at
  repeat
    last = text:find('"', last + 1, true) or error("JSON: a text does not end")
    local backslashes = text:sub(at, last - 1):match("\\*$")
  until #backslashes % 2 == 0
  return (text:sub(at + 1, last - 1):gsub("\\(.)", function(c)
    return ESCAPES[c] or c
  end)),
    last + 1
end

local function readList(text, at, last, readEntry)
  local list = {}
  at = skip(text, at + 1)
  while text:sub(at, at) ~= last do
    at = skip(text, readEntry(list, at))
    if text:sub(at, at) == "," then
      at = skip(text, at + 1)
    end
  end
  return list, at + 1
end

function readValue(text, at)
  at = skip(text, at)
  local first = text:sub(at, at)
  if first == '"' then
    return readText(text, at)
  elseif first == "[" then
    return readList(text, at, "]", function(list, here)
      local value, after = readValue(text, here)
      list[#list + 1] = value
      return after
    end)
  elseif first == "{" then
    return readList(text, at, "}", function(list, here)
      local key, after = readText(text, here)
      list[key], after = readValue(text, text:find(":", after, true) + 1)
      return after
    end)
  end
  local word = text:match("^[%w.+-]+", at) or error("JSON: no value at " .. at)
  if WORDS[word] ~= nil then
    return WORDS[word], at + #word
  end
  return tonumber(word), at + #word -- null is nil
end

--- Returns what a text in JSON says; `null` is nil.
function json.decode(text)
  return (readValue(text, 1))
end

return json
