--- Returns a box of 16 px at x, y, a table for `world:add`, with more fields, or other ones.
---@param x number px
---@param y number px
---@param fields? table
---@return table
return function(x, y, fields)
  local box = { x = x, y = y, width = 16, height = 16 }
  for name, value in pairs(fields or {}) do
    box[name] = value
  end
  return box
end
