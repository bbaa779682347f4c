--- Makes the boxes of cell values in plain arrays and in LDtk, where the game says which are solid.

local root = (...):match("^(.*)%.maps%.")
local cells = require(root .. ".maps.cells")
local check = require(root .. ".world.check")
local interpreted = require(root .. ".memory.jit")
local properties = require(root .. ".maps.properties")

local values = {}

local RULES = { solidNames = { "solid" }, isIgnored = {}, isStrict = true, isCode = true }

local function showKey(value)
  return ("solid[%s]"):format(check.show(value))
end

-- Returns the keys in an order that does not depend on `pairs`: of several wrong ones always the
-- same is reported.
local function sortedKeys(given)
  local keys = {}
  for key in pairs(given) do
    keys[#keys + 1] = key
  end
  table.sort(keys, function(a, b)
    local kindA, kindB = type(a), type(b)
    if kindA ~= kindB then
      return kindA < kindB
    elseif kindA == "boolean" then
      return not a and b
    end
    return a < b
  end)
  return keys
end

--- Returns whether something can be the value of a cell.
function values.isValue(value)
  local kind = type(value)
  return (kind == "number" and value == value) or kind == "string" or kind == "boolean"
end

--- Reads a table of fields. Errors: it is not a table; a field cannot be used.
---@param given table
---@param place string how the game writes it
---@param where string the call
---@return physics.Traits
function values.readFields(given, place, where)
  check.table(given, place, where)
  local traits = properties.read(given, where .. ": " .. place, RULES)
  return traits
end

--- Reads the option `solid`. Errors: it is not a table; a key is not a value of cells; a field
--- cannot be used.
---@param given table<any, boolean|table>?
---@param common physics.Traits what holds for all
---@param where string the call
---@return table<any, physics.Traits|false>? solid nil: nothing is said of any value
function values.readSolid(given, common, where)
  if given == nil then
    return nil
  end
  check.table(given, "solid", where)
  for key in pairs(given) do
    if not values.isValue(key) then
      local text = "%s: solid must have values of cells as keys, got %s"
      check.fail(text:format(where, check.show(key)))
    end
  end
  local solid = {}
  for _, key in ipairs(sortedKeys(given)) do
    local value, what = given[key], showKey(key)
    if type(value) ~= "boolean" and type(value) ~= "table" then
      local text = "%s: %s must be true, false or a table of fields, got %s"
      check.fail(text:format(where, what, check.show(value)))
    end
    local traits = value and values.readFields(type(value) == "table" and value or {}, what, where)
    solid[key] = traits and traits.solid ~= false and properties.combine(common, traits)
  end
  return solid
end

-- Boxes of a value --------------------------------------------------------------------------------

--- Returns the options of a loader after the checks that all loaders share: unknown names, `x` and
--- `y`, options that are true or false.
---@param given table?
---@param names table the options that there are (see check.names)
---@param flags string[] those that are true or false
---@param where string the call, for messages
---@return table options
function values.readOptions(given, names, flags, where)
  if given == nil then
    given = {}
  end
  check.table(given, "options", where)
  check.names(given, "option", names, where)
  for _, name in ipairs({ "x", "y" }) do
    if given[name] ~= nil then
      check.number(given[name], name, where)
    end
  end
  for _, name in ipairs(flags) do
    if given[name] ~= nil then
      check.boolean(given[name], name, where)
    end
  end
  return given
end

--- Returns a copy. Tables in it are shared, since they are the game's.
---@param given table
---@return table
function values.copy(given)
  local copied = {}
  for name, value in pairs(given) do
    copied[name] = value
  end
  return copied
end

local function newBoxes(state, traits, value)
  local fields, merge = traits.fields, traits.merge
  if merge == nil then
    merge = fields.static == true and not fields.sensor
  end
  merge = merge and state.merge
  local oneWay = fields.oneWay
  return cells.addBoxes(state.tiles, {
    x = 0,
    y = 0,
    width = state.tiles.tileWidth,
    height = state.tiles.tileHeight,
    fields = fields,
    group = traits.group == nil and state.group or traits.group,
    value = value,
    first = value,
    isWide = merge and oneWay ~= "left" and oneWay ~= "right",
    isTall = merge and oneWay ~= "top" and oneWay ~= "bottom",
  })
end

--- Returns the boxes of a value as a list, empty if it is not solid.
---@param state table `tiles`; `group`: of what says none; `merge`; `traitsOf(value)`: what holds
---  for it, false: it is not solid; `pieces` and `boxesByKey`: tables for what is known already
---@param value any
---@return physics.TileBoxes[]
function values.piecesOf(state, value)
  local known = state.pieces[value]
  if known then
    return known
  end
  local pieces = {} ---@type physics.TileBoxes[]
  local traits = state.traitsOf(value)
  if traits then
    properties.makeStatic(traits)
    local group = check.show(traits.group)
    local key = properties.signature({ group, tostring(traits.merge), traits.fields }, 1)
    local boxes = state.boxesByKey[key]
    if not boxes then
      boxes = newBoxes(state, traits, value)
      state.boxesByKey[key] = boxes
    elseif boxes.value ~= value then
      boxes.value = nil
    end
    pieces[1] = boxes
  end
  state.pieces[value] = pieces
  return pieces
end

interpreted.always(sortedKeys, values.readSolid, values.copy)

return values
