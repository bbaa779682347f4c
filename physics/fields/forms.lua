---@diagnostic disable
--- Forms: how columns hold a value of the game, where they do not hold the value itself. A form
--- belongs to a type of rows (see fields/fields), so a field needs no code of its own here.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local constants = require(root .. ".memory.constants")
local fields = require(root .. ".fields.fields")
local layout = require(root .. ".memory.layout")

---@class physics.Form
---@field keep function? (value, before) -> the value of a column: a copy, so that a change is
---  found; `before` is that of the slot before
---@field isKept function? (value, kept) -> whether a value equals the kept one; false: nothing is

local forms = {}

--- Returns whether two values are equal, or tables with equal entries, whatever their metatables.
function forms.isSame(one, other)
  if type(one) ~= "table" or type(other) ~= "table" then
    return one == other
  end
  for key, value in next, one, nil do
    if not forms.isSame(value, rawget(other, key)) then
      return false
    end
  end
  for key in next, other, nil do
    if rawget(one, key) == nil then
      return false
    end
  end
  return true
end

--- Returns a value, or of a table a copy; in `into`, which is empty, if that is given.
function forms.copy(value, into)
  if type(value) ~= "table" then
    return value
  end
  local copy = into or {}
  for key, inner in next, value, nil do
    copy[key] = type(inner) == "table" and forms.copy(inner) or inner
  end
  return copy
end

-- Returns a copy of a mask or an area. Many tiles have the same one: those in a row share it.
local function keepTable(given, before)
  return forms.isSame(given, before) and before or forms.copy(given)
end

-- (`false` is refused.)
local function isSameTable(given, kept)
  return given ~= false and forms.isSame(given or false, kept)
end

local function isSameSide(value, kept)
  return constants.sideOf(value) == kept
end

local TABLE, PLAIN = { keep = keepTable, isKept = isSameTable }, {}
local SIDE = { keep = constants.sideOf, isKept = isSameSide }
local BY_TYPE = { mask = TABLE, area = TABLE }

--- Returns the form of the values of a row.
---@param row physics.Field
---@return physics.Form
function forms.of(row)
  return BY_TYPE[row.type] or row.yes and SIDE or PLAIN
end

--- Returns the value of a column for nil, by the kind of the object (of an empty slot: nil).
function forms.absent(row, kind)
  if row.none ~= nil and (kind ~= constants.DYNAMIC or row.default == nil) then
    return row.none
  end
  return row.default
end

-- Each field has a column.
for _, row in ipairs(fields.columned) do
  local absent = forms.absent(row)
  local isPlain = type(absent) == (row.type or "number")
  layout.add(row.column, absent, row.axis ~= nil, row.moves, isPlain)
end

require(root .. ".memory.compiler").leave(forms.isSame, forms.copy)

return forms
