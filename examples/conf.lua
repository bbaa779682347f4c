-- LÖVE reads this before it opens the window.

local script = require("script")
local view = require("view")

local isReadable, problem = pcall(script.read, arg or {})

if script.isOn then
  -- LÖVE shows errors on a blue screen and waits for a key that is never pressed here.
  function love.errorhandler(message)
    io.stderr:write(debug.traceback(tostring(message), 2), "\n")
    os.exit(1)
  end
end
if not isReadable then
  io.stderr:write(problem, "\n")
  os.exit(1)
end

function love.conf(t)
  t.identity = "physics-lua-examples"
  t.version = "11.4"
  t.window.title = "physics.lua"
  t.window.width = view.width
  t.window.height = view.height
  t.window.resizable = true
  t.window.highdpi = true -- all pixels of a fine screen
  t.window.vsync = script.isOn and 0 or 1
  -- The library is pure Lua: it needs neither love.physics nor anything else of LÖVE.
  t.modules.physics = false
  -- love.js crashes without audio when the page gets the focus.
  t.modules.audio = love._os == "Web"
  t.modules.sound = false
  t.modules.joystick = false
  t.modules.touch = false
  t.modules.video = false
end
