-- Measures the engines that need no LÖVE: `luajit bench/run.lua --scene pile --n 1000`, or any
-- other Lua. What it can do stands in bench/options.lua.

local root = arg[0]:match("^(.*)bench/run%.lua$") or error("start it as .../bench/run.lua", 0)
root = root == "" and "." or root
package.path = root .. "/?.lua;" .. package.path

-- The interpreter and its own options (luajit -joff) stand before the script.
local command = { arg[0] }
for i = -1, -math.huge, -1 do
  if not arg[i] then
    break
  end
  table.insert(command, 1, arg[i])
end

os.exit(require("bench.app").main(arg, { root = root, command = command, isLove = false }))
