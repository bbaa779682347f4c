-- Loaded before the specs, by busted or scripts/plain_busted.lua: fails unless they run on the
-- interpreter that was asked for. Without it `busted` could quietly fall back to whatever `lua` is,
-- or run "-joff" with the JIT on. Where SPEC_TIMES names a file, the seconds of the processor that
-- each spec file took go there.
local asked = assert(os.getenv("PHYSICS_LUA"), "PHYSICS_LUA is not set")

local running = _VERSION
local jit = rawget(_G, "jit")
if jit then
  -- status() returns more than one value; only the first says whether the compiler is on.
  local on = jit.status()
  running = on and "LuaJIT" or "LuaJIT -joff"
end

if running ~= asked then
  error("the specs were to run on " .. asked .. ", but this is " .. running, 0)
end

local path = os.getenv("SPEC_TIMES")
if path and path ~= "" then
  local busted = require("busted")
  local times, started = assert(io.open(path, "w")), 0
  busted.subscribe({ "file", "start" }, function()
    started = os.clock()
    return nil, true
  end)
  busted.subscribe({ "file", "end" }, function(file)
    times:write(("%.2f %s\n"):format(os.clock() - started, file.name))
    times:flush()
    return nil, true
  end)
end
