-- Measures the engines in LÖVE, without a window: `love bench --scene pile --n 1000`.
-- What it can do stands in bench/options.lua and bench/long.lua; without LÖVE use bench/run.lua.

local root = love.filesystem.getSource() .. "/.."
package.path = root .. "/?.lua;" .. package.path

local program = arg[-2] or "love"

function love.load(arguments)
  if arguments[1] == "--long" then
    require("bench.long").main(arguments[2], tonumber(arguments[3]) or 5)
    os.exit(0)
  end
  os.exit(require("bench.app").main(arguments, {
    root = root,
    command = { program, root .. "/bench" },
    isLove = true,
  }))
end
