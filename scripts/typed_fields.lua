--- Writes an entry of physics/fields/fields.lua in words and as a type.

local typedFields = {}

local TYPES = {
  number = "number",
  boolean = "boolean",
  mask = "table<string|number, boolean>",
  masks = "table<string|number, table<string|number, boolean>>",
  soft = "table<string|number, table<string|number, number>>",
  names = "(string|number)[]",
  ownFields = "string[]",
  sides = "physics.Touching",
  area = "physics.Area",
}

-- Types of the parameters of callbacks, by their names.
local PARAMETERS = {
  self = "physics.Object",
  other = "physics.Object",
  object = "physics.Object",
  a = "physics.Object",
  b = "physics.Object",
  side = "physics.Side",
  speed = "number",
  x1 = "number",
  y1 = "number",
  x2 = "number",
  y2 = "number",
  dt = "number",
  axis = '"x"|"y"',
}

-- What a callback returns, if it does.
local RETURNS = { canCollide = "boolean?", profile = "number" }

local function callback(field)
  local parameters = {}
  for name in field.signature:gmatch("[%w_]+") do
    parameters[#parameters + 1] = name .. ": " .. assert(PARAMETERS[name], name)
  end
  local text = "fun(" .. table.concat(parameters, ", ") .. ")"
  local returns = RETURNS[field.name]
  return returns and text .. ": " .. returns or text
end

--- Returns the type of a field, without the mark of what may be left out.
---@param field physics.Field
---@return string
function typedFields.type(field)
  if field.type == "function" then
    return callback(field)
  elseif field.type == "string" then
    local choice = '"' .. table.concat(field.values, '"|"') .. '"'
    return field.yes and "boolean|" .. choice or choice
  end
  return assert(TYPES[field.type], field.type)
end

-- Numbers as the file of fields writes them, where the digits would say less.
local NAMES = { [9.81 * 64] = "9.81 * 64", [1 / 30] = "1 / 30" }

--- Returns the default of a field, as Lua where it is a constant, else in words.
---@param field physics.Field
---@return string
function typedFields.default(field)
  if field.required or field.written then
    return field.required and "required" or "written"
  elseif field.absent or field.default == nil then
    return field.absent or "none"
  end
  local value = field.default
  if type(value) == "string" then
    return ('`"%s"`'):format(value)
  end
  return "`"
    .. (NAMES[value] or (type(value) == "number" and ("%.14g"):format(value) or tostring(value)))
    .. "`"
end

--- Returns the range of a number: ">= 0", "> 0, <= 0.25", "0..1", or "".
---@param field physics.Field
---@return string
function typedFields.range(field)
  if field.min and field.max then
    return ("%g..%g"):format(field.min, field.max)
  end
  local parts = {}
  for _, bound in ipairs({ { ">=", field.min }, { ">", field.above }, { "<=", field.max } }) do
    if bound[2] then
      parts[#parts + 1] = ("%s %g"):format(bound[1], bound[2])
    end
  end
  return table.concat(parts, ", ")
end

return typedFields
