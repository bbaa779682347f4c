--- Keeps the trace compiler of LuaJIT out of what it is bad at.
--
-- A compiled trace is one way through the code, branch by branch; code that goes another way at
-- every object becomes hundreds of traces, which are thrown away and compiled again for ever. So
-- the loops over all objects or pairs are short, with few branches, and compiled; what happens to
-- single ones, in the order of events, is interpreted. On other Luas this does nothing.

local interpreted = {}

local jit = rawget(_G, "jit")
local off = type(jit) == "table" and jit.off

--- Keeps the file that calls this interpreted: all functions in it.
function interpreted.file()
  if off then
    -- A tail call: `true` means the function that is still running then, the caller's main chunk.
    return off(true, true)
  end
end

--- Keeps single functions interpreted, in a file that is compiled.
function interpreted.functions(...)
  for n = 1, off and select("#", ...) or 0 do
    off((select(n, ...)))
  end
end

return interpreted
