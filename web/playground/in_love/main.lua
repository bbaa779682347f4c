-- Plays the snippets in LÖVE itself, for web/site/test.mjs: what runs in the playground must run
-- here, too.
--
--   xvfb-run -a love web/playground/in_love 300 right:20-90,space:40 lift crowd
--
-- Prints the hash of each after so many steps, "lift 1234".

local root = love.filesystem.getSource() .. "/../../.."
package.path = root .. "/?.lua;" .. root .. "/web/playground/?.lua;" .. package.path

local physics = require("physics")
local stage = require("stage")

local STEP = 1 / 60 -- s
local CALLBACKS =
  { "load", "update", "draw", "keypressed", "keyreleased", "mousepressed", "mousemoved" }

local held = {}

function love.keyboard.isDown(...)
  for _, key in ipairs({ ... }) do
    if held[key] then
      return true
    end
  end
  return false
end

local function call(name, ...)
  if love[name] then
    love[name](...)
  end
end

local function press(keys, step)
  for _, key in ipairs(keys) do
    if step == key.from or step == key.to + 1 then
      local isDown = step == key.from
      held[key.name] = isDown or nil
      call(isDown and "keypressed" or "keyreleased", key.name, key.name, false)
    end
  end
end

local function play(name, steps, keys)
  for _, callback in ipairs(CALLBACKS) do
    love[callback] = nil
  end
  held = {}
  dofile(root .. "/web/playground/snippets/" .. name .. ".lua")
  call("load", {}, {})
  for step = 1, steps do
    press(keys, step)
    call("update", STEP)
    love.graphics.clear()
    love.graphics.push("all")
    call("draw")
    love.graphics.pop()
  end
  print(("%s %.0f"):format(name, physics.hash()))
end

function love.errorhandler(message)
  io.stderr:write(debug.traceback(tostring(message), 2), "\n")
  os.exit(1)
end

function love.load(arguments)
  local steps, keys = tonumber(arguments[1]), stage.readKeys(arguments[2])
  for i = 3, #arguments do
    play(arguments[i], steps, keys)
  end
  os.exit(0)
end
