---@diagnostic disable
--- Gives LuaJIT's trace compiler room for the library, and takes functions from it. Where there is
--- no compiler, nothing happens.
--
-- A trace is one path through the code, branch by branch. The library has up to 2500 in a scene.
-- LuaJIT has room for 1000 in the whole program, in 512 kB, LÖVE 11.4 for 2000, in 16 MB. When the
-- room is full, all traces are thrown away and compiled again. So the room is made larger.

local compiler = {}

local jit = rawget(_G, "jit")

-- Traces, kB of machine code. A game that wants other limits sets them after it has loaded the
-- library. (LuaJIT's `hotexit` stays: with 150 for 10, a crowd has a third fewer traces after four
-- minutes, but ordinary calls take up to twice the time until their ways are compiled.)
local ROOM = { "maxtrace=8000", "maxmcode=16384" }

--- Leaves functions alone. So does each file with those that go through a table by `next` or
--- `pairs`. LuaJIT of 2022 makes code of them that may crash on x64: it reads the result of `next`
--- through the lower half of a pointer to the stack.
function compiler.leave(...)
  for n = 1, jit and select("#", ...) or 0 do
    jit.off(assert((select(n, ...))), true) -- (nil would be the whole compiler)
  end
end

--- Loads a module and returns it. Meanwhile nothing is compiled: this runs once. (Else `require` of
--- the library takes 1 ms more, and 30 kB.)
function compiler.load(name)
  local isOn = jit.status()
  jit.off()
  local module = require(name)
  jit[isOn and "on" or "off"]()
  return module
end

if type(jit) == "table" and jit.opt then
  jit.opt.start(ROOM[1], ROOM[2])
else
  jit, compiler.load = nil, require
end

return compiler
