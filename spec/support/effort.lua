--- How much of the slow specs to play. All of it with the trace compiler; interpreters, which are
--- slower, play a selection: they run the same code on the same numbers, and that the bits are the
--- same is a spec of its own. So does `physics.compile`, which is slow to start in so many worlds.
--- `PHYSICS_SPEC=full` plays all of it everywhere, `PHYSICS_SPEC=quick` the selection everywhere.

local effort = {}

local jit = rawget(_G, "jit")
local wanted = os.getenv("PHYSICS_SPEC")
local isCompiled = os.getenv("PHYSICS_LUA") == "LuaJIT compiled"

--- Whether everything is played.
effort.isWhole = wanted == "full"
  or (wanted ~= "quick" and jit and jit.status() and not isCompiled)
  or false

--- A number of seeds, rounds or objects: all of them, or the share of a slow interpreter.
function effort.share(count, least)
  if effort.isWhole then
    return count
  end
  return math.max(least or 1, math.floor(count / 5))
end

--- Switches the trace compiler off for the specs of a file: what plays thousands of small worlds
--- would keep it busy with each of them for nothing. Takes busted's `setup` and `teardown`.
function effort.interpret(setup, teardown)
  if jit and jit.status() then
    setup(function()
      jit.off()
    end)
    teardown(function()
      jit.on()
    end)
  end
end

return effort
