--- The order of keys and names, the same on every Lua, so that nothing depends on that of `pairs`.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local interpreted = require(root .. ".memory.jit")

local keyOrder = {}

--- Whether one key comes before another one: numbers before strings, each in their own order. What
--- is neither is no key of the library, and comes in no order but that of its type.
---@param a any
---@param b any
---@return boolean
function keyOrder.comesBefore(a, b)
  local kind = type(a)
  if kind == type(b) then
    return (kind == "number" or kind == "string") and a < b
  end
  return kind < type(b)
end

--- Returns the keys of a table in that order.
---@param map table
---@return any[]
function keyOrder.sorted(map)
  local list = {}
  for key in next, map, nil do
    list[#list + 1] = key
  end
  table.sort(list, keyOrder.comesBefore)
  return list
end

interpreted.always(keyOrder.sorted)

return keyOrder
