--- Writes a case as Lua source, for spec/fuzz/found.txt.

local write = {}

local KEYWORDS = { ["end"] = true, ["repeat"] = true, ["and"] = true, ["or"] = true }

-- A number that reads back as the same one.
local function number(value)
  if value % 1 == 0 and value > -1e15 and value < 1e15 then
    return ("%d"):format(value)
  end
  for digits = 1, 17 do
    local text = ("%." .. digits .. "g"):format(value)
    if tonumber(text) == value then
      return text
    end
  end
  return ("%.17g"):format(value)
end

local function comesBefore(a, b)
  if type(a) == type(b) then
    return a < b
  end
  return type(a) == "number"
end

local function keyText(key)
  if type(key) == "number" then
    return "[" .. number(key) .. "]"
  elseif key:find("^[%a_][%w_]*$") and not KEYWORDS[key] then
    return key
  end
  return ("[%q]"):format(key)
end

local value

local function entries(list)
  local texts, keys = {}, {}
  for n = 1, #list do
    texts[n] = value(list[n])
  end
  for key in pairs(list) do
    if not (type(key) == "number" and key >= 1 and key <= #list and key % 1 == 0) then
      keys[#keys + 1] = key
    end
  end
  table.sort(keys, comesBefore)
  for _, key in ipairs(keys) do
    texts[#texts + 1] = keyText(key) .. " = " .. value(list[key])
  end
  return texts
end

--- Returns a value as source: numbers, strings, booleans and tables of them.
function value(given)
  if type(given) == "number" then
    return number(given)
  elseif type(given) == "string" then
    return ("%q"):format(given)
  elseif type(given) ~= "table" then
    return tostring(given)
  end
  local texts = entries(given)
  return #texts == 0 and "{}" or "{ " .. table.concat(texts, ", ") .. " }"
end

write.value = value

return write
