--- How much of the specs to play: all of it on one interpreter, a selection on the others. They
--- run the same code on the same numbers, and that the bits are the same is a spec of its own. The
--- one is LuaJIT, as LÖVE has it.
--- `PHYSICS_SPEC=full` plays all of it everywhere, `PHYSICS_SPEC=quick` the selection everywhere.
---
--- Each interpreter selects other rows and variants (`plays`). So the two of `make test` together
--- play more than each of them, and those of `make test-all` all of it several times.

local effort = {}

local jit = rawget(_G, "jit")
local wanted = os.getenv("PHYSICS_SPEC")
local asked = os.getenv("PHYSICS_LUA")

-- By which the interpreters select; those of `make test` come first.
local NUMBERS = { ["LuaJIT"] = 0, ["Lua 5.4"] = 1, ["LuaJIT -joff"] = 2, ["Lua 5.1"] = 3 }
NUMBERS["Lua 5.2"], NUMBERS["Lua 5.3"] = 4, 5
NUMBERS["Lua 5.5"] = 6
local own = NUMBERS[asked or jit and "LuaJIT" or _VERSION] or 0

--- Whether everything is played.
effort.isWhole = wanted == "full" or (wanted ~= "quick" and jit and jit.status()) or false

--- A number of seeds, rounds or objects: all of them, or the share of a slow interpreter.
function effort.share(count, least)
  if effort.isWhole then
    return count
  end
  return math.max(least or 1, math.floor(count / 5))
end

--- Whether to play a row: where not everything is played, each interpreter plays one of `share`
--- rows, and the next interpreter the next ones.
function effort.plays(row, share)
  return effort.isWhole or (row - own) % share == 0
end

--- Those of a list of rows.
function effort.rows(list, share)
  local part = {}
  for i, row in ipairs(list) do
    part[#part + 1] = effort.plays(i, share) and row or nil
  end
  return part
end

--- Whether this process plays what takes half a second or more and shows the same on every Lua, and
--- what compares Luas: only LuaJIT does, as LÖVE has it, or whatever was not asked for by name.
effort.isFirst = asked == nil or asked == "LuaJIT"

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

--- The same in `make test` only, for files that play some hundred worlds in all of their rows.
function effort.interpretQuickly(setup, teardown)
  if wanted == "quick" then
    effort.interpret(setup, teardown)
  end
end

return effort
