--- Decides which functions LuaJIT's trace compiler may compile. On other Luas this does nothing.
--
-- A compiled trace is one path through the code, branch by branch. Code that takes another path for
-- every object becomes hundreds of traces. LuaJIT has room for 1000 of them, in 512 KB, for the
-- whole program. (LÖVE 11.4 gives it 2000, in 16 MB.) When the room is full, all traces are thrown
-- away and compiled again, for ever.
--
-- So the loops over all objects or pairs are short, with few branches, and compiled. What happens
-- to single ones, in the order of events, is interpreted. The code that leads from one loop to the
-- next is interpreted, too. In a small world its loops are short and are not compiled by
-- themselves. They would be unrolled into whatever comes before them, once for each path that leads
-- there.
--
-- A program that gives LuaJIT more room may have everything compiled (`lift`).

local interpreted = {}

local jit = rawget(_G, "jit")
local off = type(jit) == "table" and jit.off
local getinfo = type(debug) == "table" and debug.getinfo
local kept = {} -- main chunks and functions that are kept interpreted
local isLifted = false -- nothing is kept any more; files are loaded later, too

-- What `lift` gives the compiler: traces, KB of machine code.
local ROOM = { "maxtrace=8000", "maxmcode=16384" }

local function keep(f)
  if isLifted then
    return
  end
  off(f, true) -- `true`: also the functions inside
  kept[#kept + 1] = f
end

--- Keeps the file that calls this interpreted: all functions in it.
function interpreted.file()
  if off and getinfo then
    keep(getinfo(2, "f").func)
  elseif off then
    -- A tail call: `true` means the function that is still running then, the caller's main chunk.
    return off(true, true)
  end
end

--- Keeps single functions interpreted, in a file that is compiled.
function interpreted.functions(...)
  for n = 1, off and select("#", ...) or 0 do
    keep((select(n, ...)))
  end
end

--- Keeps functions interpreted for good: all that go through a table by `next` or `pairs`. What
--- LuaJIT 2.1 of 2022 makes of that may crash on x64: it reads what `next` has found through the
--- lower half of a pointer to the stack. (spec/interpreted_spec.lua finds those that are missing.)
function interpreted.always(...)
  for n = 1, off and select("#", ...) or 0 do
    off((select(n, ...)), true)
  end
end

--- Gives the compiler more room, and everything to compile. Returns whether there is one.
function interpreted.lift()
  if not (off and getinfo and jit.opt and jit.status()) then
    return false
  end
  jit.opt.start(ROOM[1], ROOM[2])
  for n = 1, #kept do
    jit.on(kept[n], true)
  end
  isLifted = true
  return true
end

return interpreted
