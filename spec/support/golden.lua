--- Compares a number with the one in spec/golden.lua. With PHYSICS_GOLDEN=FILE it is noted in that
--- file instead (see scripts/golden.sh).

local numbers = require("spec.golden")

local golden = {}

--- Checks a number.
---@param name string its name in spec/golden.lua
---@param number string
function golden.check(name, number)
  local path = os.getenv("PHYSICS_GOLDEN")
  if path then
    local file = assert(io.open(path, "a"))
    file:write(name, " ", number, "\n")
    file:close()
    return
  end
  -- (The `assert` with assertions is that of the spec files only.)
  local text = "%s: %s is written in spec/golden.lua, got %s"
  assert(numbers[name] == number, text:format(name, numbers[name], number))
end

return golden
