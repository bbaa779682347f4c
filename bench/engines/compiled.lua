--- physics.lua after `physics.compile()`: what LuaJIT takes when it has room for everything. Each
--- measurement is a process of its own, so that the others keep the usual limits.

local ours = require("bench.engines.ours")
local physics = require("physics")

local compiled = { needsCompiler = true }

function compiled.new(scene)
  physics.compile()
  return ours.new(scene)
end

return compiled
