--- A source of columns (see physics/memory/columnStore.lua) that looks at what is done with them:
--- each index, the kind of each value, and that no code keeps a column that has been replaced. It
--- makes room for no more than is asked for.

local columnStore = require("physics.memory.columnStore")

local checked = {}

local EMPTY = { number = 0, integer = 0, boolean = false }
local MOST = 2 ^ 31 -- integers are below

-- By column, since a column itself must stay empty for `__index` to be asked.
local valuesOf = setmetatable({}, { __mode = "k" })
local lengthOf = setmetatable({}, { __mode = "k" })
local kindOf = setmetatable({}, { __mode = "k" })

local Column = {}

local function checkIndex(column, k)
  local length = lengthOf[column]
  if not length then
    error("a column that has been replaced is used", 3)
  elseif type(k) ~= "number" or k % 1 ~= 0 or k < 0 or k >= length then
    error(("index %s in a column of %d"):format(tostring(k), length), 3)
  end
end

function Column.__index(column, k)
  checkIndex(column, k)
  local value = valuesOf[column][k]
  if value == nil then
    return EMPTY[kindOf[column]]
  end
  return value
end

local function isOf(kind, value)
  if kind == "integer" then
    return type(value) == "number" and value % 1 == 0 and value > -MOST and value < MOST
  end
  return type(value) == kind
end

function Column.__newindex(column, k, value)
  checkIndex(column, k)
  if not isOf(kindOf[column], value) then
    error(("%s in a column of %ss"):format(tostring(value), kindOf[column]), 2)
  end
  valuesOf[column][k] = value
end

local source = {}

function source.give(kind, lengths)
  local columns = {}
  for n = 1, #lengths do
    local column = setmetatable({}, Column)
    valuesOf[column], lengthOf[column], kindOf[column] = {}, lengths[n], kind
    columns[n] = column
  end
  return columns, columns
end

function source.room(_, last)
  return math.max(last, 0)
end

function source.drop(columns)
  for n = 1, #columns do
    lengthOf[columns[n]] = nil
  end
end

--- Calls `f` with worlds of checked columns; returns what it returns.
function checked.during(f)
  local before = columnStore.use(source)
  local isDone, result = pcall(f)
  columnStore.use(before)
  if not isDone then
    error(result, 0)
  end
  return result
end

return checked
