--- Keeps the trace compiler of LuaJIT out of a function, and so keeps apart what it calls.
--
-- A compiled trace runs on through everything it calls and after every loop it leaves. In a step
-- that goes from one small job to the next, that makes a trace for each way through all jobs in a
-- row: megabytes of machine code, thrown away and compiled again for ever. So the functions that
-- only conduct are interpreted, and each job beneath them is compiled by itself, once.
-- On other Luas this does nothing.

local jit = rawget(_G, "jit")
local off = type(jit) == "table" and jit.off

--- Returns the function given.
return function(conductor)
  if off then
    off(conductor)
  end
  return conductor
end
