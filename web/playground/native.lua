-- Plays a program of the playground in plain Lua, with the library's own files:
--
--   luajit web/playground/native.lua web/playground/snippets/lift.lua 300 right:20-90,space:40
--
-- Prints the hash of its world after so many steps, "hash 1234".

package.path = "./?.lua;./web/playground/?.lua;" .. package.path

local file, steps, keys = arg[1], tonumber(arg[2]), arg[3] or ""
local input = assert(io.open(file, "rb"))
local code = input:read("*a")
input:close()

-- Nothing is painted here, so any width of a text will do.
local host = {
  measure = function(text, size)
    return #text * size * 0.5
  end,
}
local run = require("stage").start(host, require("physics"), code)
run:follow(keys)
for _ = 1, steps do
  run:step()
  run:draw()
end
print("hash " .. run:hash())
