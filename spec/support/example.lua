--- Loads a file of the examples, which require each other by their bare names.

local example = {}

--- Returns the module of an example, "football".
function example.require(name)
  local before = package.path
  package.path = before .. ";./examples/?.lua"
  local module = require(name)
  package.path = before
  return module
end

return example
