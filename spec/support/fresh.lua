--- The library loaded anew, as a program has it that has just started.

local fresh = {}

local function isOurs(name)
  return name == "physics" or name:find("^physics%.") ~= nil
end

-- Forgets what is loaded of the library; returns it by name.
local function unload()
  local loaded = {}
  for name, module in pairs(package.loaded) do
    if isOurs(name) then
      loaded[name] = module
    end
  end
  for name in pairs(loaded) do
    package.loaded[name] = nil
  end
  return loaded
end

--- Calls `f` with a library of its own, which `require` gives meanwhile, too.
function fresh.during(f)
  local loaded = unload()
  local isDone, problem = pcall(function()
    f(require("physics"))
  end)
  unload()
  for name, module in pairs(loaded) do
    package.loaded[name] = module
  end
  assert(isDone, problem)
end

return fresh
