-- Loaded before the specs of the single file (scripts/single.sh). The file shows nothing
-- of its inside, but many specs are about a module of the library: here they get the modules of
-- the file, taken out with the debug library, and so test the same code that a game would run.

local function upvalue(f, wanted)
  for i = 1, math.huge do
    local name, value = debug.getupvalue(f, i)
    if name == wanted then
      return value
    end
    assert(name, "the single file has changed: no upvalue '" .. wanted .. "' found")
  end
end

-- `physics.draw` calls the method of that name, and that one loads its module by
-- `compiler.load` when it is called.
local method = upvalue(require("physics").draw, "method")
local loader = upvalue(getmetatable(upvalue(method, "draw")).__index, "compiler").load
local inner = upvalue(loader, "require") -- without LuaJIT it would be `loader` itself

for name in io.lines("modules.txt") do
  package.preload[name] = inner
end

-- Were the folder found, the specs would be about that.
local source = debug.getinfo(require("physics").newWorld, "S").source
assert(source == "@./physics.lua" and not io.open("physics/world/world.lua"), source)
