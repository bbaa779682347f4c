-- Loaded before the specs, by busted or scripts/plain_busted.lua: fails unless they run on the
-- interpreter that was asked for. Without it `busted` could quietly fall back to whatever `lua` is,
-- or run "-joff" with the JIT on.
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
