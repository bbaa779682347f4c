--- Modules that are loaded when they are first used: what a world does not need for its first step.
--
-- The first use copies what the module holds into the table that stood for it, and takes the
-- metatable away. From then on it is a table of functions like any other: a call costs no more, and
-- the trace compiler of LuaJIT sees nothing special.

local root = (...):match("^(.*)%.[^.]+%.[^.]+$")
local interpreted = require(root .. ".memory.jit")

-- Loads the module that a table stands for, and returns one of its fields.
local function fill(self, key)
  local name = getmetatable(self).name
  for field, value in pairs(require(name)) do
    rawset(self, field, value)
  end
  setmetatable(self, nil)
  return rawget(self, key)
end

interpreted.always(fill)

--- Returns a table that stands for a module. Its fields must be read at use, not when the file that
--- holds it is loaded, and nothing may be written to it.
---@param name string as `require` takes it
---@return any
return function(name)
  return setmetatable({}, { __index = fill, name = name })
end
