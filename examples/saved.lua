-- Saved games: tables of numbers, texts, booleans and tables, as Lua code in the save folder.

local saved = {}

local function write(value)
  if type(value) == "number" then
    return ("%.17g"):format(value) -- fewer digits would not be the same number
  elseif type(value) ~= "table" then
    return type(value) == "string" and ("%q"):format(value) or tostring(value)
  end
  local parts = {}
  for key, inner in pairs(value) do
    parts[#parts + 1] = "[" .. write(key) .. "]=" .. write(inner)
  end
  return "{" .. table.concat(parts, ",") .. "}"
end

--- Writes a table into a file of the save folder.
function saved.write(name, value)
  return love.filesystem.write(name, "return " .. write(value))
end

--- Returns the table of a file; nil: there is none, or it is damaged.
function saved.read(name)
  local chunk = love.filesystem.getInfo(name) and love.filesystem.load(name)
  local isRead, value = pcall(chunk or error)
  return isRead and value or nil
end

return saved
