--- Keeps loops over `pairs` interpreted. LuaJIT 2.1 of 2022 may lose an entry, or crash, where it
--- compiles one (CONTRIBUTING, "The trace compiler", 8). The library has no such loop where it is
--- compiled; in specs and games at random they may stand anywhere.

local jit = rawget(_G, "jit")
if jit then
  local next, pairs = next, pairs

  local function step(list, key)
    return next(list, key)
  end
  jit.off(step)

  -- A table that has a way of its own keeps that.
  rawset(_G, "pairs", function(list)
    local iterator, state, key = pairs(list)
    return iterator == next and step or iterator, state, key
  end)
end
